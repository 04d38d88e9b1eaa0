//! Meshes against exact integrals of polyhedra that are known otherwise.

use std::fmt::Write;

use bifdiag_body::part::mesh::{Mesh, MeshError, MeshFormat, VolumeIntegrals};
use bifdiag_numbers::symmetric::Symmetric;
use dashu_ratio::RBig;
use proptest::prelude::*;

type Point = [f64; 3];

/// The faces of a convex hull, found by brute force: planes through three points with all others on one side. Faces with
/// more corners are fans around their least corner.
fn hull(points: &[Point]) -> Option<Vec<[Point; 3]>> {
    let exact: Vec<[RBig; 3]> = points.iter().map(|p| p.map(|x| RBig::try_from(x).unwrap())).collect();
    let side = |a: usize, b: usize, c: usize, d: usize| {
        let v = |k: usize| -> [RBig; 3] { std::array::from_fn(|i| &exact[k][i] - &exact[a][i]) };
        let (u, v, w) = (v(b), v(c), v(d));
        let minor = |i: usize, j: usize| &v[i] * &w[j] - &v[j] * &w[i];
        &u[0] * minor(1, 2) + &u[1] * minor(2, 0) + &u[2] * minor(0, 1)
    };
    let count = points.len();
    let mut faces = Vec::new();
    for a in 0..count {
        for b in 0..count {
            for c in 0..count {
                if a >= b || a >= c || b == c {
                    continue;
                }
                let others: Vec<RBig> =
                    (0..count).filter(|d| ![a, b, c].contains(d)).map(|d| side(a, b, c, d)).collect();
                if others.iter().any(RBig::is_zero) {
                    return None;
                }
                // Outward: all others below the plane.
                if others.iter().all(|s| *s < RBig::ZERO) {
                    faces.push([points[a], points[b], points[c]]);
                }
            }
        }
    }
    (faces.len() >= 4).then_some(faces)
}

/// Integrals over a convex body as a sum over tetrahedra from one of its corners: by their corners' moments, another
/// formula than the program's: ∫ x xᵀ = V/20 (Σ vᵢ vᵢᵀ + (Σ vᵢ)(Σ vᵢ)ᵀ).
fn by_tetrahedra(faces: &[[Point; 3]], apex: Point) -> (RBig, [RBig; 3], Symmetric) {
    let exact = |p: Point| p.map(|x| RBig::try_from(x).unwrap());
    let mut volume = RBig::ZERO;
    let mut first = [RBig::ZERO, RBig::ZERO, RBig::ZERO];
    let mut second = Symmetric::diagonal([RBig::ZERO, RBig::ZERO, RBig::ZERO]);
    let apex = exact(apex);
    for face in faces {
        let corners: Vec<[RBig; 3]> = face.iter().map(|p| exact(*p)).chain([apex.clone()]).collect();
        let edge = |k: usize| -> [RBig; 3] { std::array::from_fn(|i| &corners[k][i] - &apex[i]) };
        let (u, v, w) = (edge(0), edge(1), edge(2));
        let minor = |i: usize, j: usize| &v[i] * &w[j] - &v[j] * &w[i];
        let own = (&u[0] * minor(1, 2) + &u[1] * minor(2, 0) + &u[2] * minor(0, 1)) / RBig::from(6);
        let sum: [RBig; 3] = std::array::from_fn(|i| corners.iter().fold(RBig::ZERO, |s, c| s + &c[i]));
        let twentieth = &own / RBig::from(20);
        second = second.plus(&twentieth, &Symmetric::outer(&sum));
        for corner in &corners {
            second = second.plus(&twentieth, &Symmetric::outer(corner));
        }
        for i in 0..3 {
            first[i] += &own * &sum[i] / RBig::from(4);
        }
        volume += own;
    }
    (volume, first, second)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, ..ProptestConfig::default() })]

    /// 200 random convex polyhedra: the integrals equal those over tetrahedra from a corner, exactly, in every format.
    #[test]
    fn polyhedra_have_their_exact_integrals(
        points in prop::collection::vec(prop::array::uniform3(-4.0f32..4.0), 4..9),
    ) {
        let points: Vec<Point> = points.into_iter().map(|p| p.map(f64::from)).collect();
        let Some(faces) = hull(&points) else { return Ok(()) };
        let found = Mesh::from_triangles(faces.clone()).integrals().unwrap();
        let (volume, first, second) = by_tetrahedra(&faces, points[0]);
        prop_assert_eq!(&found, &VolumeIntegrals { volume, first, second });
        for (format, bytes) in files(&faces) {
            prop_assert_eq!(&Mesh::read(&bytes, format).unwrap().integrals().unwrap(), &found, "{:?}", format);
        }
    }
}

/// The same triangles in all formats.
fn files(faces: &[[Point; 3]]) -> Vec<(MeshFormat, Vec<u8>)> {
    let mut ascii = "solid part\n".to_owned();
    let mut binary = vec![0; 80];
    binary.extend(u32::try_from(faces.len()).unwrap().to_le_bytes());
    let mut obj = String::new();
    let mut corners = String::new();
    let mut indices = String::new();
    for (number, face) in faces.iter().enumerate() {
        ascii.push_str("facet normal 0 0 0\nouter loop\n");
        binary.extend([0; 12]);
        for [x, y, z] in face {
            writeln!(ascii, "vertex {x:e} {y:e} {z:e}").unwrap();
            writeln!(obj, "v {x} {y} {z}").unwrap();
            writeln!(corners, "{x} {y} {z}").unwrap();
            for c in [x, y, z] {
                #[expect(clippy::cast_possible_truncation, reason = "the points are of single precision")]
                binary.extend((*c as f32).to_le_bytes());
            }
        }
        ascii.push_str("endloop\nendfacet\n");
        binary.extend([0; 2]);
        let k = 3 * number;
        writeln!(obj, "f {} {} {}", k + 1, k + 2, k + 3).unwrap();
        writeln!(indices, "3 {} {} {}", k, k + 1, k + 2).unwrap();
    }
    ascii.push_str("endsolid part\n");
    let ply = format!(
        "ply\nformat ascii 1.0\nelement vertex {}\nproperty float x\nproperty float y\nproperty float z\nelement face {}\n\
         property list uchar int vertex_indices\nend_header\n{corners}{indices}",
        3 * faces.len(),
        faces.len(),
    );
    vec![
        (MeshFormat::Stl, ascii.into_bytes()),
        (MeshFormat::Stl, binary),
        (MeshFormat::Obj, obj.into_bytes()),
        (MeshFormat::Ply, ply.into_bytes()),
    ]
}

/// The box [0, a] × [0, b] × [0, c] from its corner `at`.
fn cuboid(at: Point, size: Point) -> Vec<[Point; 3]> {
    let corner = |k: usize| std::array::from_fn(|i| at[i] + if k >> i & 1 == 1 { size[i] } else { 0.0 });
    let quads = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    quads.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).map(|face| face.map(corner)).collect()
}

fn turned(faces: &[[Point; 3]]) -> Vec<[Point; 3]> {
    faces.iter().map(|[a, b, c]| [*a, *c, *b]).collect()
}

#[test]
fn a_box_and_a_hollow_box() {
    let outer = cuboid([0.0; 3], [2.0, 4.0, 6.0]);
    let solid = Mesh::from_triangles(outer.clone()).integrals().unwrap();
    let properties = solid.with_mass(&RBig::from(12)).unwrap();
    assert_eq!(properties.com, [1, 2, 3].map(RBig::from));
    // m (b² + c²) / 12 and so on.
    assert_eq!(properties.about_com, Symmetric::diagonal([52, 40, 20].map(RBig::from)));
    assert_eq!(solid.with_density(&RBig::from(2)).unwrap().mass, RBig::from(96));
    let cavity = turned(&cuboid([0.5; 3], [1.0, 1.0, 1.0]));
    let hollow = Mesh::from_triangles([outer, cavity].concat()).integrals().unwrap();
    assert_eq!(hollow.volume, RBig::from(47));
}

#[test]
fn what_is_no_closed_surface_is_refused() {
    let whole = cuboid([0.0; 3], [1.0, 1.0, 1.0]);
    let error = |faces: Vec<[Point; 3]>| Mesh::from_triangles(faces).integrals().unwrap_err();
    assert_eq!(error(Vec::new()), MeshError::Empty);
    assert!(matches!(error(whole[1..].to_vec()), MeshError::Open { edges: 3, .. }));
    let mut mixed = whole.clone();
    mixed[0].swap(0, 1);
    assert!(matches!(error(mixed), MeshError::Mixed { edges: 3, .. }));
    assert!(matches!(error(turned(&whole)), MeshError::Inverted { triangles: 12, volume } if volume == -1.0));
    let inner = cuboid([0.25; 3], [0.5, 0.5, 0.5]);
    assert_eq!(error([whole.clone(), inner].concat()), MeshError::Nested { triangles: 12 });
    let crossing = cuboid([0.5, 0.25, 0.75], [1.0, 2.0, 3.0]);
    assert!(matches!(error([whole.clone(), crossing].concat()), MeshError::Crossing { .. }));
    let far = turned(&cuboid([5.0; 3], [1.0, 1.0, 1.0]));
    assert!(matches!(error([whole.clone(), far].concat()), MeshError::Inverted { .. }));
    assert!(matches!(error([whole.clone(), whole.clone()].concat()), MeshError::Branched { .. }));
    assert!(matches!(
        error(vec![[[f64::NAN, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]]),
        MeshError::NotFinite { at } if at[0].is_nan()
    ));
}

/// Solids that touch in a face, an edge or a corner add up, with the same corners or with others.
#[test]
fn solids_in_contact_add_up() {
    let volume = |faces: Vec<[Point; 3]>| Mesh::from_triangles(faces).integrals().map(|found| found.volume);
    let one = cuboid([0.0; 3], [1.0, 1.0, 1.0]);
    for at in [[1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [1.0, 1.0, 1.0], [0.0, -1.0, 0.0], [1.0, 0.25, 0.25]] {
        let other = cuboid(at, [1.0, 1.0, 1.0]);
        assert_eq!(volume([one.clone(), other.clone()].concat()), Ok(RBig::from(2)), "{at:?}");
        assert_eq!(volume([other, one.clone()].concat()), Ok(RBig::from(2)), "{at:?}");
    }
    // Three in a row, and four round an edge.
    let row = [0.0, 1.0, 2.0].map(|x| cuboid([x, 0.0, 0.0], [1.0, 1.0, 1.0])).concat();
    assert_eq!(volume(row), Ok(RBig::from(3)));
    let round = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]].map(|[x, y]| cuboid([x, y, 0.0], [1.0, 1.0, 1.0]));
    assert_eq!(volume(round.concat()), Ok(RBig::from(4)));
    // A pin that fills a cavity.
    let block = [cuboid([-1.0; 3], [3.0, 3.0, 3.0]), turned(&one)].concat();
    assert_eq!(volume([block, one].concat()), Ok(RBig::from(27)));
}

/// Space that two solids share is not counted twice, also where they share corners or faces.
#[test]
fn solids_that_share_space_are_refused() {
    let error = |faces: Vec<[Point; 3]>| Mesh::from_triangles(faces).integrals().unwrap_err();
    let whole = cuboid([0.0; 3], [1.0, 1.0, 1.0]);
    // In a corner of the other one: with one corner in common, and with parts of three faces.
    let corner = cuboid([0.0; 3], [0.5, 0.5, 0.5]);
    assert!(matches!(error([whole.clone(), corner].concat()), MeshError::Nested { .. }));
    let [a, b, c, d] = [[0.0; 3], [0.5, 0.25, 0.25], [0.25, 0.5, 0.25], [0.25, 0.25, 0.5]];
    let spike = vec![[a, c, b], [a, b, d], [a, d, c], [b, c, d]];
    assert_eq!(error([whole.clone(), spike].concat()), MeshError::Nested { triangles: 4 });
    // The same face at one side.
    let longer = cuboid([0.0; 3], [2.0, 1.0, 1.0]);
    assert!(matches!(error([whole, longer].concat()), MeshError::Branched { .. } | MeshError::Nested { .. }));
}

/// Far from the origin nothing is lost: the tensor about the centre of mass is that at the origin, exactly.
#[test]
fn a_far_mesh_is_the_same_part() {
    let here = Mesh::from_triangles(cuboid([0.0; 3], [1.0, 2.0, 3.0])).integrals().unwrap();
    let there = Mesh::from_triangles(cuboid([1_048_576.0, -2_097_152.0, 0.5], [1.0, 2.0, 3.0])).integrals().unwrap();
    let [here, there] = [here, there].map(|integrals| integrals.with_density(&RBig::from(7)).unwrap());
    assert_eq!((&here.about_com, &here.mass), (&there.about_com, &there.mass));
}
