//! How the nodes of a ring move together: the derivatives of the flow from node to node, in components along the nodes'
//! frames.

use nalgebra::{SMatrix, SVector};

use crate::flow::Parts;

/// A move of the first node: its two components across the orbit and the one beyond, and the relative change of the
/// period.
pub type Move = SVector<f64, 4>;

/// How the components of a move are carried from one node to another.
#[derive(Clone, Copy, Debug)]
pub struct Link {
    /// What becomes of the components at the first node.
    pub tangent: SMatrix<f64, 4, 4>,
    /// What a relative change of the period adds.
    pub of_period: Parts,
}

/// The links of a ring.
#[derive(Clone, Debug)]
pub struct Chain {
    /// From each node to the next.
    links: Vec<Link>,
    /// From the first node to each, and once around.
    carried: Vec<Link>,
}

impl Link {
    fn none() -> Self {
        Self { tangent: SMatrix::identity(), of_period: Parts::zeros() }
    }

    /// This link after another.
    fn after(&self, first: &Self) -> Self {
        Self { tangent: self.tangent * first.tangent, of_period: self.tangent * first.of_period + self.of_period }
    }

    /// What becomes of a move of the first node, which has no component along the orbit.
    fn parts(&self, first: &Move) -> Parts {
        self.tangent * Parts::new(first[0], first[1], first[2], 0.0) + self.of_period * first[3]
    }
}

impl Chain {
    /// From the links between each node and the next.
    #[must_use]
    pub fn new(links: Vec<Link>) -> Self {
        let mut carried = Vec::with_capacity(links.len() + 1);
        let mut last = Link::none();
        carried.push(last);
        for link in &links {
            last = link.after(&last);
            carried.push(last);
        }
        Self { links, carried }
    }

    /// Extrapolates from another chain through this one and beyond it by `share` of their distance.
    #[must_use]
    pub fn beyond(&self, before: &Self, share: f64) -> Self {
        let pairs = self.links.iter().zip(&before.links);
        let links = pairs.map(|(here, there)| Link {
            tangent: here.tangent + (here.tangent - there.tangent) * share,
            of_period: here.of_period + (here.of_period - there.of_period) * share,
        });
        Self::new(links.collect())
    }

    /// The same chain, starting at another node.
    #[must_use]
    pub fn turned(mut self, by: usize) -> Self {
        self.links.rotate_left(by);
        Self::new(self.links)
    }

    /// The moves of all nodes that follow from a move of the first.
    pub fn moved(&self, first: Move) -> impl Iterator<Item = Parts> {
        self.carried[..self.links.len()].iter().map(move |link| link.parts(&first))
    }

    /// The accumulated defects of the links: their components at each node, and after one turn.
    #[must_use]
    pub fn carry(&self, defects: &[Parts]) -> Vec<Parts> {
        let mut last = Parts::zeros();
        let mut carried = vec![last];
        for (link, defect) in self.links.iter().zip(defects) {
            last = link.tangent * last + defect;
            carried.push(last);
        }
        carried
    }

    /// The move that closes the ring across and along, given the defect after one turn, and satisfies one more
    /// condition. Beyond, the ring is closed already, since h and l do not change. `None` if there is no such move, or
    /// more than one.
    #[must_use]
    pub fn closing(&self, defect: &Parts, (condition, value): (&Move, f64)) -> Option<Move> {
        let around = &self.carried[self.links.len()];
        let mut matrix = SMatrix::<f64, 4, 4>::zeros();
        let mut right = Move::zeros();
        for (row, part) in [0, 1, 3].into_iter().enumerate() {
            for column in 0..3 {
                let stays = if part == column { 1.0 } else { 0.0 };
                matrix[(row, column)] = around.tangent[(part, column)] - stays;
            }
            matrix[(row, 3)] = around.of_period[part];
            right[row] = -defect[part];
        }
        matrix.set_row(3, &condition.transpose());
        right[3] = value;
        // For a very unstable orbit the determinant is lost to rounding, and any nonzero number of its size will do.
        matrix.lu().solve(&right).or_else(|| {
            matrix[(0, 0)] *= 1.0 + f64::EPSILON;
            matrix.lu().solve(&right)
        })
    }

    /// The largest factor by which the flow stretches from one node to the next.
    #[must_use]
    pub fn stretch(&self) -> f64 {
        self.links.iter().map(|link| link.tangent.norm()).fold(0.0, f64::max)
    }

    /// The reduced derivative of the return to the first node, and the product of the determinants from node to node,
    /// which is 1 up to rounding.
    #[must_use]
    pub fn reduced(&self) -> Reduced {
        let mut product = SMatrix::<f64, 2, 2>::identity();
        let mut determinant = 1.0;
        for link in &self.links {
            let part = link.tangent.fixed_view::<2, 2>(0, 0);
            product = part * product;
            determinant *= part[(0, 0)] * part[(1, 1)] - part[(0, 1)] * part[(1, 0)];
        }
        Reduced { matrix: product, determinant }
    }
}

/// The derivative of the return of an orbit, across it.
#[derive(Clone, Copy, Debug)]
pub struct Reduced {
    /// In the two directions across at the first node.
    pub matrix: SMatrix<f64, 2, 2>,
    /// Its determinant, computed without cancellation of large entries.
    pub determinant: f64,
}

impl Reduced {
    /// Its trace: 2 at folds, −2 at doublings.
    #[must_use]
    pub fn trace(&self) -> f64 {
        self.matrix.trace()
    }

    /// The multipliers, [re, im]: a conjugate pair on the unit circle, or two real ones, the larger first.
    #[must_use]
    pub fn multipliers(&self) -> [[f64; 2]; 2] {
        let (half, product) = (0.5 * self.trace(), self.determinant);
        let discriminant = half * half - product;
        if discriminant < 0.0 {
            let im = (-discriminant).sqrt();
            return [[half, im], [half, -im]];
        }
        let larger = half + discriminant.sqrt().copysign(half);
        if larger == 0.0 { [[0.0; 2]; 2] } else { [[larger, 0.0], [product / larger, 0.0]] }
    }
}
