//! What tolerances do to the spins at which rotation about an axis changes: bounds for all bodies within them, and the classes
//! of sampled ones.

use bifdiag_body::part::{MeasuredPart, Part};
use bifdiag_body::{Body, Number};
use bifdiag_diagram::class::ClassName;
use bifdiag_equilibria::critical::SteadyFamily;
use bifdiag_equilibria::permanent::{
    AxisKind, Near, NominalRotation, SettledTypes, sampled_bodies, sampled_parts, sampled_shares,
    settled_types_of_part, settled_types_of_shares, spin_ranges,
};
use bifdiag_exact::AxisSpins;

use crate::border::classes_of;

/// How well the numbers of a body are known.
#[derive(Clone, Copy, Debug)]
pub enum Tolerances<'a> {
    /// Exactly.
    Exact,
    /// To shares of the moment about the axis, of the two others, and of the weight times its distance.
    Shares(&'a [Number; 4]),
    /// Each number of a part to within so much.
    Measured(&'a Part, &'a MeasuredPart),
}

/// What holds for all bodies within tolerances, and which classes some of them have.
#[derive(Clone, Debug, PartialEq)]
pub struct Tolerated {
    /// Bounds on the spins at which the type changes, with the direction of the axis up and with its other end.
    pub ends: [SettledTypes; 2],
    /// They are those of the nominal steady rotation that moves with the spin, not of the axis itself.
    pub is_moving: bool,
    /// How many sampled bodies have each class, the most frequent first.
    pub classes: Vec<(Option<ClassName>, usize)>,
}

impl Tolerances<'_> {
    /// The share of all, where it is the same.
    #[must_use]
    pub fn share_of_all(shares: &[Number; 4]) -> Option<&Number> {
        let [axis, others @ ..] = shares;
        others.iter().all(|other| other == axis).then_some(axis)
    }
}

impl Tolerated {
    /// Of rotation about an axis, which is `up` in the frame of the part. `None` for exact numbers, where several steady
    /// rotations are equally near to the axis or the nearest one is one of a circle, and for shares that differ where the
    /// axis is not permanent.
    #[must_use]
    pub fn new(body: &Body, spins: &AxisSpins, tolerances: Tolerances<'_>, up: [f64; 3]) -> Option<Self> {
        match tolerances {
            Tolerances::Exact => None,
            Tolerances::Shares(shares) => Self::of_shares(body, spins, shares),
            Tolerances::Measured(part, measured) => Self::of_part(spins, part, measured, up),
        }
    }

    fn of_shares(body: &Body, spins: &AxisSpins, shares: &[Number; 4]) -> Option<Self> {
        if let Some(ends) = &spins.ends {
            let shares = shares.each_ref().map(|share| share.value().clone());
            return Some(Self {
                ends: ends
                    .each_ref()
                    .map(|end| SettledTypes { ranges: spin_ranges(&end.rotation, &shares), tilt: None }),
                is_moving: false,
                classes: classes_of(sampled_bodies(&ends[0].rotation, &shares)),
            });
        }
        let [plus, minus] = spins.nearest_isolated()?;
        let share = Tolerances::share_of_all(shares)?.value();
        let settled = |up, family: &SteadyFamily| {
            let rotation = NominalRotation { fast: family.fast, slowest: family.slowest() };
            settled_types_of_shares(body, share, up, &rotation)
        };
        Some(Self {
            ends: [settled(spins.up, plus), settled(spins.up.map(|x| -x), minus)],
            is_moving: true,
            classes: classes_of(sampled_shares(body, share)),
        })
    }

    fn of_part(spins: &AxisSpins, part: &Part, measured: &MeasuredPart, up: [f64; 3]) -> Option<Self> {
        let near = if let (Some(ends), AxisKind::Permanent { .. }) = (&spins.ends, spins.kind) {
            ends.each_ref().map(|end| Near::Axis(&end.rotation))
        } else {
            let axes = part.principal().ok()?.axes;
            let in_part = |v: [f64; 3]| std::array::from_fn(|i| (0..3).map(|k| axes[k][i] * v[k]).sum());
            spins
                .nearest_isolated()?
                .map(|family| Near::Rotation(NominalRotation { fast: in_part(family.fast), slowest: family.slowest() }))
        };
        let settled = |up, near| settled_types_of_part(part, measured, up, near);
        Some(Self {
            ends: [settled(up, near[0]), settled(up.map(|x| -x), near[1])],
            is_moving: matches!(near[0], Near::Rotation(_)),
            classes: classes_of(sampled_parts(part, measured)),
        })
    }

    /// How many bodies were sampled.
    #[must_use]
    pub fn sampled(&self) -> usize {
        self.classes.iter().map(|(_, bodies)| bodies).sum()
    }

    /// The largest angle, in radians, of a rotation outside the ranges; `None` where the axis itself is permanent for all.
    #[must_use]
    pub fn tilt(&self) -> Option<f64> {
        self.ends.iter().filter_map(|found| found.tilt).reduce(f64::max)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Among parts that are nearly symmetric are symmetric ones, which have other diagrams; all parts are counted.
    #[test]
    fn a_symmetric_part_has_neighbours_of_another_class() {
        let body = Body::parse(&["1", "1", "0.6"], &["0", "0", "1"]).unwrap();
        let [x, y, z] = [0, 0, 1].map(dashu_ratio::RBig::from);
        let spins = AxisSpins::new(&body, [0.0, 0.0, 1.0], &[x, y, z]);
        let found = |share: &str| {
            let shares: [Number; 4] = std::array::from_fn(|_| share.parse().unwrap());
            Tolerated::new(&body, &spins, Tolerances::Shares(&shares), [0.0, 0.0, 1.0]).unwrap()
        };
        let one = found("0");
        assert_eq!((one.classes.len(), one.classes[0].1), (1, 1));
        let several = found("0.01");
        let same = |(class, _): &(Option<ClassName>, usize)| *class == one.classes[0].0;
        assert!(several.classes.len() > 1 && several.classes.iter().any(same), "{several:?}");
        assert!(several.classes.iter().all(|(class, _)| class.is_some()), "{several:?}");
        assert_eq!(several.sampled(), bifdiag_equilibria::permanent::SAMPLES);
    }
}
