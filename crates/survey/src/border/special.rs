//! Bodies of a segment that are more special than those beside them.

use dashu_ratio::RBig;

use super::event::BorderEventKind;
use super::segment::BodySegment;
use super::vanishing::ParameterRoot;
use bifdiag_body::BodyAxis;

/// What is special about one body of a segment, and not about those beside it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum SpecialBody {
    /// r = 0.
    NoWeight,
    /// The moments of these axes are equal.
    EqualMoments {
        /// The axes.
        axes: Vec<BodyAxis>,
        /// True if one pitchfork leaves to infinity: that of the pair over axis i, with r_i = 0 on the whole segment, where
        /// s² = Σ r_k²/(A_k − A_i)² and r_k ≠ 0 for another of the axes, and no component of r vanishes there alone.
        pitchfork_leaves: bool,
    },
    /// These components of r are 0.
    Components(Vec<BodyAxis>),
}

impl SpecialBody {
    /// What happens there if nothing else does.
    pub(crate) fn kind(self) -> BorderEventKind {
        match self {
            Self::NoWeight => BorderEventKind::WeightVanishes,
            Self::EqualMoments { axes, .. } => BorderEventKind::MomentsEqual { axes },
            Self::Components(axes) => BorderEventKind::SymmetryBroken { axes },
        }
    }
}

/// A special body between two values of t, and where it is, from exact fractions.
pub(crate) fn special(segment: &BodySegment, t: [f64; 2]) -> Option<(SpecialBody, ParameterRoot)> {
    // Every finite double is a fraction.
    let [from, to] = t.map(|t| RBig::try_from(t).unwrap_or(RBig::ZERO));
    let inside = |t: &RBig| from <= *t && *t <= to;
    let moment = |axis: BodyAxis, t: &RBig| segment.exactly(axis.index(), t);
    let component = |axis: BodyAxis, t: &RBig| segment.exactly(3 + axis.index(), t);

    let leaves = BodyAxis::ALL.map(|axis| zero(|t| component(axis, t)).filter(inside));
    let is_weightless = |t: &&RBig| BodyAxis::ALL.iter().all(|axis| component(*axis, t).is_zero());
    if let Some(t) = leaves.iter().flatten().find(is_weightless) {
        return Some((SpecialBody::NoWeight, root(t)));
    }
    for (i, axis) in BodyAxis::ALL.into_iter().enumerate() {
        for other in BodyAxis::ALL.into_iter().skip(i + 1) {
            let Some(t) = zero(|t| moment(axis, t) - moment(other, t)).filter(inside) else { continue };
            let value = moment(axis, &t);
            let axes: Vec<BodyAxis> = BodyAxis::ALL.into_iter().filter(|axis| moment(*axis, &t) == value).collect();
            let is_passive =
                |axis: &BodyAxis| [RBig::ZERO, RBig::ONE].iter().all(|end| component(*axis, end).is_zero());
            let is_active = |axis: &BodyAxis| !component(*axis, &t).is_zero();
            // Where a symmetry is broken too, other pitchforks may open into cusps.
            let alone = !leaves.contains(&Some(t.clone()));
            let are_two = axes.len() == 2;
            let pitchfork_leaves = alone && are_two && axes.iter().any(is_passive) && axes.iter().any(is_active);
            return Some((SpecialBody::EqualMoments { axes, pitchfork_leaves }, root(&t)));
        }
    }
    // Of two axes with equal moments r has one component, whose direction is a matter of the axes.
    let is_own = |axis: &BodyAxis, t: &RBig| {
        let is_twin = |other: &BodyAxis| {
            other != axis && [RBig::ZERO, RBig::ONE].iter().all(|end| moment(*axis, end) == moment(*other, end))
        };
        BodyAxis::ALL.iter().filter(|other| is_twin(other)).all(|other| component(*other, t).is_zero())
    };
    let vanishing = BodyAxis::ALL.into_iter().zip(leaves);
    let vanishing: Vec<(BodyAxis, RBig)> =
        vanishing.filter_map(|(axis, t)| Some((axis, t?))).filter(|(axis, t)| is_own(axis, t)).collect();
    let (_, t) = vanishing.first()?;
    let axes = vanishing.iter().filter(|(_, other)| other == t).map(|(axis, _)| *axis).collect();
    Some((SpecialBody::Components(axes), root(t)))
}

/// Where a linear function vanishes that is not the same everywhere.
fn zero(of: impl Fn(&RBig) -> RBig) -> Option<RBig> {
    let (from, to) = (of(&RBig::ZERO), of(&RBig::ONE));
    (from != to).then(|| &from / (&from - to))
}

fn root(exact: &RBig) -> ParameterRoot {
    let t = exact.to_f64().value();
    let is_exact = RBig::try_from(t).is_ok_and(|t| t == *exact);
    ParameterRoot { t, error: if is_exact { 0.0 } else { f64::EPSILON * t.abs() } }
}

/// What happens at a border on which bodies are special, or none is; `found` is what the diagrams on its two sides suggest,
/// `is_sure` is true when that vanishes between them.
pub(super) fn explained(special: Option<SpecialBody>, found: BorderEventKind, is_sure: bool) -> BorderEventKind {
    use BorderEventKind as Kind;
    match (special, found) {
        (None, Kind::PitchforkAtInfinity { .. }) => Kind::Several,
        (None, found) => found,
        (Some(SpecialBody::EqualMoments { pitchfork_leaves: true, .. }), found @ Kind::PitchforkAtInfinity { .. }) => {
            found
        }
        (Some(_), found) if is_sure && !found.is_guess() && !matches!(found, Kind::PitchforkAtInfinity { .. }) => found,
        (Some(special), _) => special.kind(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use bifdiag_body::Body;

    fn between([a, r]: [[f64; 3]; 2], [b, s]: [[f64; 3]; 2]) -> Option<(SpecialBody, f64, f64)> {
        let segment = BodySegment::new(Body::from_f64(a, r).unwrap(), Body::from_f64(b, s).unwrap());
        special(&segment, [0.0, 1.0]).map(|(special, root)| (special, root.t, root.error))
    }

    #[test]
    fn special_bodies_are_distinguished() {
        let generic = [[1.0, 1.5, 2.0], [0.5, 0.25, 1.0]];
        let with = |k: usize, value: f64| {
            let mut body = generic;
            body[k / 3][k % 3] = value;
            body
        };
        assert_eq!(between(generic, with(0, 1.25)), None);
        let [first, second, third] = BodyAxis::ALL;
        let equal = |axes: Vec<BodyAxis>, pitchfork_leaves| SpecialBody::EqualMoments { axes, pitchfork_leaves };
        assert_eq!(between(generic, with(0, 2.0)), Some((equal(vec![first, second], false), 0.5, 0.0)));
        assert_eq!(between(generic, with(4, -0.75)), Some((SpecialBody::Components(vec![second]), 0.25, 0.0)));
        let [a, r] = generic;
        let onto_an_axis = Some((SpecialBody::Components(vec![first, third]), 1.0, 0.0));
        assert_eq!(between(generic, [a, [0.0, 1.0, 0.0]]), onto_an_axis);
        assert_eq!(between([a, [0.0; 3]], generic), Some((SpecialBody::NoWeight, 0.0, 0.0)));
        assert_eq!(between([a, r.map(|x| -x)], generic), Some((SpecialBody::NoWeight, 0.5, 0.0)));
        // Axes 1 and 2 of a body with A1 = A2 may be turned: r1 = 0 alone is nothing special.
        let turned = |r: [f64; 3], s: [f64; 3]| between([[1.0, 1.0, 0.5], r], [[1.0, 1.0, 0.5], s]);
        assert_eq!(turned([0.0, 1.0, 1.0], [1.0, 1.0, 2.0]), None);
        let on_axis_3 = Some((SpecialBody::Components(vec![first, second]), 0.0, 0.0));
        assert_eq!(turned([0.0, 0.0, 1.0], [3.0, 1.0, 2.0]), on_axis_3);
        let in_plane = Some((SpecialBody::Components(vec![third]), 0.0, 0.0));
        assert_eq!(turned([0.0, 1.0, 0.0], [3.0, 1.0, 2.0]), in_plane);
        // The third of two equal moments passes them; a third of the way is no double.
        let ball = between([[1.0, 1.0, 0.5], r], [[1.0, 1.0, 2.0], r]);
        assert_eq!(ball, Some((equal(vec![first, second, third], false), 1.0 / 3.0, f64::EPSILON / 3.0)));
        // A pitchfork goes to infinity if one of the two axes has r_i = 0 throughout and the other has not.
        let passing = |r: [f64; 3], s: [f64; 3]| between([[1.0, 0.5, 2.0], r], [[1.0, 1.5, 2.0], s]);
        assert_eq!(passing([1.0, 0.0, 0.0], [1.0, 0.0, 0.0]), Some((equal(vec![first, second], true), 0.5, 0.0)));
        assert_eq!(passing([0.0, 0.0, 1.0], [0.0, 0.0, 1.0]), Some((equal(vec![first, second], false), 0.5, 0.0)));
        assert_eq!(passing([1.0, 0.0, 0.0], [1.0, 0.5, 0.0]), Some((equal(vec![first, second], false), 0.5, 0.0)));
        assert_eq!(passing([1.0, 0.0, -0.5], [1.0, 0.0, 0.5]), Some((equal(vec![first, second], false), 0.5, 0.0)));
    }
}
