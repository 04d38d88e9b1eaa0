//! The principal form of a tensor.

use dashu_ratio::RBig;

use super::coincidence::{Relation, keep_ratios, keep_trace, rounded};
use super::rigid_body::{Body, Tensor, TensorError};
use bifdiag_numbers::symmetric::{PrincipalAxes, Real};
use bifdiag_numbers::{Number, decimal};

/// A tensor in its principal axes.
#[derive(Clone, Debug, PartialEq)]
pub struct PrincipalForm {
    /// A and r; [`Body::tensor`] leads back unless the tensor is diagonal.
    pub body: Body,
    /// Row k is principal axis k in the axes of the tensor, rounded: v_principal = axes · v. A proper rotation.
    pub axes: [[f64; 3]; 3],
    /// Nothing was rounded.
    pub exact: bool,
}

impl Tensor {
    /// The body in its principal axes.
    ///
    /// A diagonal tensor keeps its axes and their order. Else the moments ascend, see [`PrincipalAxes`].
    ///
    /// # Errors
    /// [`TensorError::OutOfRange`].
    pub fn principal(&self) -> Result<PrincipalForm, TensorError> {
        // One digit more than is kept, and one for the rounding.
        let found = PrincipalAxes::new(self.matrix(), self.center(), Self::DIGITS + 2);
        let digits = Self::DIGITS + 1 + lost_in_differences(&found.values);
        let exact = found.values.iter().chain(&found.components).all(Real::is_exact);
        let kept = |x: &Real, digits| if x.is_exact() { x.lo.clone() } else { rounded(x, digits) };
        let mut moments = found.values.each_ref().map(|a| kept(a, digits));
        let mut center = found.components.each_ref().map(|r| kept(r, Self::DIGITS + 1));
        let mut relation = None;
        if !exact {
            keep_trace(self, &found, &mut moments);
            keep_ratios(&found, &mut center);
            relation = Relation::of(self, &found);
        }
        let related = relation.and_then(|relation| {
            let (mut moments, mut center) = (moments.clone(), center.clone());
            relation.impose(&found, &mut moments, &mut center);
            // Numbers of hundreds of digits get too long.
            body(&moments, &center).ok()
        });
        let body = related.map_or_else(|| body(&moments, &center), Ok)?;
        let body = if self.matrix().is_diagonal() { body } else { body.with_tensor(self.clone(), !exact) };
        Ok(PrincipalForm { body, axes: found.axes, exact })
    }
}

/// Decimal digits that the smallest difference of two moments loses against the largest moment.
fn lost_in_differences(values: &[Real; 3]) -> usize {
    let largest = values.iter().map(Real::to_f64).fold(0.0, f64::max);
    let differences = [(0, 1), (0, 2), (1, 2)].map(|(i, j)| ((&values[i].lo - &values[j].lo).to_f64().value()).abs());
    let smallest = differences.into_iter().filter(|gap| *gap > 0.0).fold(largest, f64::min);
    let mut lost = 0;
    let mut reached = smallest;
    while reached < largest && lost < 600 {
        reached *= 10.0;
        lost += 1;
    }
    lost
}

/// With short decimals where there are such, else exact rationals.
fn body(moments: &[RBig; 3], center: &[RBig; 3]) -> Result<Body, TensorError> {
    let number = |name: &'static str, x: &RBig, axis: usize| {
        decimal::short(x).parse::<Number>().map_err(|source| TensorError::OutOfRange { name, axis, source })
    };
    let numbers = |name: &'static str, [x, y, z]: &[RBig; 3]| {
        Ok::<_, TensorError>([number(name, x, 1)?, number(name, y, 2)?, number(name, z, 3)?])
    };
    Ok(Body::new(numbers("A", moments)?, numbers("r", center)?)?)
}

#[cfg(test)]
mod tests {
    use bifdiag_numbers::symmetric::Symmetric;

    use super::*;

    fn form(tensor: [&str; 6], center: [&str; 3]) -> PrincipalForm {
        let rational = |text: &str| text.parse::<Number>().unwrap().value().clone();
        Tensor::new(Symmetric::new(tensor.map(rational)), center.map(rational)).unwrap().principal().unwrap()
    }

    #[test]
    fn a_diagonal_tensor_loses_nothing() {
        let principal = form(["0.3", "0.1", "0.2", "0", "0", "0"], ["0.981", "-1/3", "0"]);
        assert!(principal.exact && principal.body.tensor().is_none());
        assert_eq!(principal.body.moments().each_ref().map(Number::text), ["0.3", "0.1", "0.2"]);
        assert_eq!(principal.body.center().each_ref().map(Number::text), ["0.981", "-1/3", "0"]);
        assert_eq!(principal.axes, [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]);
    }

    #[test]
    fn a_tilted_tensor_whose_principal_form_is_rational_loses_nothing() {
        // diag(0.1, 0.2, 0.3) and r = (1, 2, 3) turned about z by 3-4-5.
        let principal = form(["0.164", "0.136", "0.3", "-0.048", "0", "0"], ["-1", "2", "3"]);
        assert!(principal.exact);
        assert_eq!(principal.body.moments().each_ref().map(Number::text), ["0.1", "0.2", "0.3"]);
        assert!(principal.body.flags().unphysical && !principal.body.flags().plate);
        // The third axis points down where the three would be left-handed otherwise.
        assert_eq!(principal.body.center()[2].text().trim_start_matches('-'), "3");
    }

    #[test]
    fn symmetries_of_tilted_tensors_are_exact() {
        // 1 + v vᵀ with v = (1, 2, 3): a double moment 1 and the moment 15 along v.
        let tensor = ["2", "5", "10", "2", "3", "6"];
        let on_axis = form(tensor, ["1", "2", "3"]);
        assert!(!on_axis.exact);
        let flags = on_axis.body.flags();
        assert!(flags.symmetric && flags.axis && flags.plane);
        assert_eq!(on_axis.body.moments().each_ref().map(Number::text), ["1", "1", "15"]);
        assert_eq!(&on_axis.body.center()[2].text()[..18], "3.7416573867739413");
        assert_eq!(on_axis.body.center_squared(), RBig::from(14));
        // Orthogonal to the axis, and neither.
        assert_eq!(form(tensor, ["3", "0", "-1"]).body.center()[2].text(), "0");
        assert!(!form(tensor, ["1", "0", "0"]).body.flags().axis);
        // Irrational moments and r orthogonal to the axis whose moment is rational.
        let plane = form(["2", "3", "4", "1", "0", "0"], ["1", "1", "0"]);
        assert_eq!(plane.body.moments()[2].text(), "4");
        assert_eq!(plane.body.center()[2].text(), "0");
        assert!(plane.body.flags().plane && !plane.body.flags().axis);
        // r along an axis whose moment is rational while the other two are not.
        let upright = form(["2", "3", "4", "1", "0", "0"], ["0", "0", "5"]);
        assert!(upright.body.flags().axis && !upright.exact);
        assert_eq!(upright.body.center()[2].text(), "5");
    }

    #[test]
    fn what_is_rounded_is_known_to_130_digits() {
        let principal = form(["2", "3", "4", "1", "1e-30", "0"], ["1", "1", "1"]);
        // The trace and |r|² are kept to the available digits.
        let sum = principal.body.moments().iter().fold(RBig::from(-9), |sum, a| sum + a.value());
        let squared = principal.body.center().iter().fold(RBig::from(-3), |sum, r| sum + r.value() * r.value());
        let bound = RBig::from_parts(1.into(), dashu_int::UBig::from(10u8).pow(127));
        for off in [sum, squared] {
            assert!(off.clone().max(-off) < bound);
        }
    }

    #[test]
    fn what_is_not_positive_definite_is_refused() {
        for (tensor, wrong) in [
            (["0", "1", "1", "0", "0", "0"], 1),
            (["1", "1", "1", "1", "0", "0"], 2),
            (["1", "1", "1", "0.8", "0.8", "-0.8"], 3),
        ] {
            let rational = |text: &str| text.parse::<Number>().unwrap().value().clone();
            let error = Tensor::new(Symmetric::new(tensor.map(rational)), [RBig::ZERO; 3]).unwrap_err();
            let TensorError::NotPositiveDefinite { order, .. } = error else { panic!("{error}") };
            assert_eq!(order, wrong);
        }
    }
}
