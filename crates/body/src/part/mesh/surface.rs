//! Triangles over shared corners.

/// Triangles over shared corners, counter-clockwise as seen from outside.
#[derive(Clone, Debug, PartialEq)]
pub struct Mesh {
    corners: Vec<[f64; 3]>,
    triangles: Vec<[usize; 3]>,
}

impl Mesh {
    /// A mesh from triangles given by their corners; equal corners become one, triangles without area between different
    /// corners stay, those with a corner twice go.
    #[must_use]
    pub fn from_triangles(triangles: impl IntoIterator<Item = [[f64; 3]; 3]>) -> Self {
        let mut numbers = std::collections::HashMap::new();
        let mut mesh = Self { corners: Vec::new(), triangles: Vec::new() };
        for triangle in triangles {
            let [a, b, c] = triangle.map(|corner| {
                // −0 is 0.
                let corner = corner.map(|x| x + 0.0);
                *numbers.entry(corner.map(f64::to_bits)).or_insert_with(|| {
                    mesh.corners.push(corner);
                    mesh.corners.len() - 1
                })
            });
            if a != b && b != c && c != a {
                mesh.triangles.push([a, b, c]);
            }
        }
        mesh
    }

    /// The corners.
    #[must_use]
    pub fn corners(&self) -> &[[f64; 3]] {
        &self.corners
    }

    /// The triangles, by their corners' numbers.
    #[must_use]
    pub fn triangles(&self) -> &[[usize; 3]] {
        &self.triangles
    }
}
