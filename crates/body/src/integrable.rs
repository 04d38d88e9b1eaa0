//! Integrable cases: bodies with a first integral besides H, ⟨γ,L⟩ and ⟨γ,γ⟩.

use dashu_ratio::RBig;

use super::axis::BodyAxis;
use super::rigid_body::Body;
use bifdiag_numbers::symmetric::{Symmetric, dot};

/// A case in which the equations of motion have a further first integral, or an invariant relation. L = Aω.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum IntegrableCase {
    /// r = 0: ⟨L,L⟩.
    Euler,
    /// Two equal moments and r on the third axis: ω about it. `None`: three equal moments, ⟨L,r⟩.
    Lagrange(Option<BodyAxis>),
    /// A_i = A_j = 2A_k with r_k = 0, for this axis k: |(ω_i + iω_j)² + (r_i + ir_j)(γ_i + iγ_j)/A_k|².
    Kovalevskaya(BodyAxis),
    /// A_i = A_j = 4A_k with r_k = 0, for this axis k: ω_k(ω_i² + ω_j²) + (r_iω_i + r_jω_j)γ_k/A_k, where ⟨γ,L⟩ = 0.
    GoryachevChaplygin(BodyAxis),
    /// The plane ⟨L,r⟩ = 0 cuts ⟨L,A⁻¹L⟩ = const in a circle: motions stay in this plane.
    HessAppelrot,
}

/// Which motions keep the value of a further integral.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Holds {
    /// All.
    Always,
    /// Those with ⟨γ,L⟩ = 0.
    ZeroMomentum,
    /// Those on which it is 0.
    WhereZero,
}

impl IntegrableCase {
    /// The cases to which a body belongs, decided exactly; none for most.
    #[must_use]
    pub fn of(body: &Body) -> Vec<Self> {
        if body.is_euler() {
            return vec![Self::Euler];
        }
        let (a, r) = (body.moments(), body.center());
        if a[0] == a[1] && a[1] == a[2] {
            return vec![Self::Lagrange(None)];
        }
        // Equal moments and components that are 0 are so in a rounded body, too; ratios of moments are not.
        let symmetric = BodyAxis::ALL.into_iter().find(|k| {
            let [i, j] = k.others();
            a[i] == a[j]
        });
        let exact = ExactBody::of(body);
        match symmetric {
            Some(k) if k.others().into_iter().all(|i| r[i].value().is_zero()) => vec![Self::Lagrange(Some(k))],
            Some(k) if exact.has_ratio(2) => vec![Self::Kovalevskaya(k)],
            Some(k) if exact.has_ratio(4) => vec![Self::GoryachevChaplygin(k)],
            _ if is_hess(&exact.matrix, &exact.center) => vec![Self::HessAppelrot],
            _ => Vec::new(),
        }
    }

    /// For which motions the integral is one.
    #[must_use]
    pub fn holds(self) -> Holds {
        match self {
            Self::Euler | Self::Lagrange(_) | Self::Kovalevskaya(_) => Holds::Always,
            Self::GoryachevChaplygin(_) => Holds::ZeroMomentum,
            Self::HessAppelrot => Holds::WhereZero,
        }
    }

    /// The case by the name of those who found it.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Euler => "Euler",
            Self::Lagrange(_) => "Lagrange",
            Self::Kovalevskaya(_) => "Kovalevskaya",
            Self::GoryachevChaplygin(_) => "Goryachev–Chaplygin",
            Self::HessAppelrot => "Hess–Appelrot",
        }
    }

    /// The integral as a formula in ω, γ, A and r, with L = Aω.
    #[must_use]
    pub fn integral(self) -> String {
        let names = |k: BodyAxis| {
            let [i, j] = k.others();
            // In the order in which they are read.
            if i.index() < j.index() { [i, j] } else { [j, i] }
        };
        match self {
            Self::Euler => "⟨L,L⟩".to_owned(),
            Self::Lagrange(Some(k)) => format!("ω{k}"),
            Self::Lagrange(None) | Self::HessAppelrot => "⟨L,r⟩".to_owned(),
            Self::Kovalevskaya(k) => {
                let [i, j] = names(k);
                format!("(ω{i}² − ω{j}² + (r{i}γ{i} − r{j}γ{j})/A{k})² + (2ω{i}ω{j} + (r{i}γ{j} + r{j}γ{i})/A{k})²")
            }
            Self::GoryachevChaplygin(k) => {
                let [i, j] = names(k);
                format!("ω{k}(ω{i}² + ω{j}²) + (r{i}ω{i} + r{j}ω{j})γ{k}/A{k}")
            }
        }
    }
}

impl Body {
    /// True when A⁻¹ across r is a multiple of 1: Hess and Appelrot's case, in which both pairs of eigenvalues at rest agree.
    #[must_use]
    pub fn is_round_across_r(&self) -> bool {
        let exact = ExactBody::of(self);
        is_hess(&exact.matrix, &exact.center)
    }
}

/// A as a matrix and r, neither rounded: what follows is invariant under rotations.
struct ExactBody {
    matrix: Symmetric,
    center: [RBig; 3],
}

impl ExactBody {
    fn of(body: &Body) -> Self {
        if let Some(tensor) = body.tensor() {
            return Self { matrix: tensor.matrix().clone(), center: tensor.center().clone() };
        }
        let values = |numbers: &[crate::Number; 3]| numbers.each_ref().map(|x| x.value().clone());
        Self { matrix: Symmetric::diagonal(values(body.moments())), center: values(body.center()) }
    }

    /// The moments are n c, n c and c for a c, and A r = n c r: then c = tr A/(2n + 1).
    fn has_ratio(&self, n: i32) -> bool {
        let n = RBig::from(n);
        let c = self.matrix.trace() / (RBig::from(2) * &n + RBig::ONE);
        let double = &n * &c;
        let [determinant, second, ..] = self.matrix.characteristic();
        let along = self.matrix.times(&self.center);
        second == &double * (&double + RBig::from(2) * &c)
            && -determinant == &double * &double * c
            && along.iter().zip(&self.center).all(|(image, r)| *image == &double * r)
    }
}

/// Whether A and r are of Hess and Appelrot's case: the form ⟨L, adj(A) L⟩ on the plane across r is a multiple of ⟨L,L⟩, so
/// that trace² = 4 det there. On this plane the trace is tr M − rᵀMr/|r|² and the determinant rᵀ adj(M) r/|r|², with
/// M = adj A and adj M = (det A) A.
pub(super) fn is_hess(matrix: &Symmetric, center: &[RBig; 3]) -> bool {
    let (adjugate, squared) = (matrix.adjugate(), dot(center, center));
    let trace = adjugate.trace() * &squared - dot(center, &adjugate.times(center));
    let determinant = matrix.determinant() * dot(center, &matrix.times(center));
    &trace * &trace == RBig::from(4) * determinant * squared
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Tensor;

    fn cases(moments: [&str; 3], center: [&str; 3]) -> Vec<IntegrableCase> {
        IntegrableCase::of(&Body::parse(&moments, &center).unwrap())
    }

    #[test]
    fn the_classical_cases_are_recognised_in_every_order_of_the_axes_and_unit() {
        use IntegrableCase::{Euler, GoryachevChaplygin, HessAppelrot, Kovalevskaya, Lagrange};
        let [first, second, third] = BodyAxis::ALL;
        assert_eq!(cases(["2", "1.5", "1"], ["0"; 3]), [Euler]);
        assert_eq!(cases(["1", "1", "1"], ["0"; 3]), [Euler]);
        assert_eq!(cases(["3/2", "1", "1"], ["1", "0", "0"]), [Lagrange(Some(first))]);
        assert_eq!(cases(["1", "1", "2/3"], ["0", "0", "-7"]), [Lagrange(Some(third))]);
        assert_eq!(cases(["1", "1", "1"], ["1", "-2", "3"]), [Lagrange(None)]);
        assert_eq!(cases(["2", "2", "1"], ["1", "0", "0"]), [Kovalevskaya(third)]);
        assert_eq!(cases(["2/7", "1/7", "2/7"], ["0.3", "0", "-0.4"]), [Kovalevskaya(second)]);
        assert_eq!(cases(["1", "4", "4"], ["0", "1", "2"]), [GoryachevChaplygin(first)]);
        // r_1²(1/A3 − 1/A2) = r_3²(1/A2 − 1/A1).
        assert_eq!(cases(["1/2", "1/3", "1/7"], ["1", "0", "2"]), [HessAppelrot]);
        assert_eq!(cases(["1/7", "1/2", "1/3"], ["-20", "10", "0"]), [HessAppelrot]);
    }

    #[test]
    fn what_is_only_near_a_case_is_none() {
        for (moments, center) in [
            (["2", "2", "1.0000000000000000000001"], ["1", "0", "0"]),
            (["2", "1.9999999999999999999999", "1"], ["1", "0", "0"]),
            (["2", "2", "1"], ["1", "0", "1e-30"]),
            (["4", "4", "1"], ["1", "1e-30", "1e-30"]),
            (["1", "1", "2"], ["1e-30", "0", "1"]),
            (["1/2", "1/3", "1/7"], ["1", "1e-30", "2"]),
            (["1/2", "1/3", "1/7"], ["1", "0", "1.9999"]),
            (["3", "3", "1"], ["1", "0", "0"]),
            (["2", "1.1", "1"], ["0.94868", "0", "0.61623"]),
        ] {
            assert_eq!(cases(moments, center), [], "{moments:?} {center:?}");
        }
    }

    /// A tensor whose principal form is irrational is examined directly, not through the rounded numbers.
    #[test]
    fn a_rounded_body_is_recognised_by_its_tensor() {
        let ratio = |p: i32, q: u32| RBig::from_parts(p.into(), q.into());
        // (2E − q qᵀ)/3 for q = (2, −2, 1)/3, the moments 2/3, 2/3, 1/3; r ⟂ q with |r| = √2 and with |r| = √(2 + 1e-40).
        let q = [ratio(2, 3), ratio(-2, 3), ratio(1, 3)];
        let unit = Symmetric::diagonal([ratio(2, 3), ratio(2, 3), ratio(2, 3)]);
        let matrix = unit.plus(&ratio(-1, 3), &Symmetric::outer(&q));
        let form = Tensor::new(matrix.clone(), [ratio(1, 1), ratio(1, 1), ratio(0, 1)]).unwrap().principal().unwrap();
        assert!(!form.exact && form.body.tensor().is_some());
        assert!(matches!(IntegrableCase::of(&form.body)[..], [IntegrableCase::Kovalevskaya(_)]));
        let near = [ratio(1, 1), ratio(1, 1), ratio(1, 1) / RBig::from(10).pow(40)];
        let form = Tensor::new(matrix, near).unwrap().principal().unwrap();
        assert_eq!(IntegrableCase::of(&form.body), []);
        // adj A is a multiple of the unit across r = (1, 0, 0); its moments are irrational.
        let across = Symmetric::new([3, 2, 2, 1, 1, 0].map(RBig::from));
        let form = Tensor::new(across.adjugate(), [1, 0, 0].map(RBig::from)).unwrap().principal().unwrap();
        assert!(!form.exact);
        assert_eq!(IntegrableCase::of(&form.body), [IntegrableCase::HessAppelrot]);
        let other = Symmetric::new([3, 2, 2, 1, 1, 1].map(RBig::from));
        let form = Tensor::new(other.adjugate(), [1, 0, 0].map(RBig::from)).unwrap().principal().unwrap();
        assert_eq!(IntegrableCase::of(&form.body), []);
    }
}
