//! Spins and parts with tolerances as documents.

use std::cmp::Ordering;

use bifdiag_body::Body;
use bifdiag_body::part::{INPUT_NAMES, Measured, MeasuredPart, Part, Spin};
use bifdiag_diagram::atlas::Atlas;
use bifdiag_diagram::region_changes::{RotationChange, rotation_changes};
use bifdiag_equilibria::critical::Equilibrium;
use bifdiag_equilibria::curves::{BranchName, CurveName, Pole};
use bifdiag_equilibria::nonlinear::VerdictChange;
use bifdiag_equilibria::permanent::{
    AxisRotation, Near, SettledTypes, SpinRange, SpinType, sampled_bodies, sampled_parts, sampled_shares,
    settled_types_of_part, settled_types_of_shares, spin_ranges,
};
use bifdiag_numbers::{Number, decimal};
use bifdiag_schema::{
    CommandLine, FrictionDocument, MeasuredDocument, NonlinearDocument, NonlinearVerdict, Reason, SampledClassDocument,
    SpinChangeDocument, SpinDocument, SpinRangeDocument, SpinStretchDocument, ToleranceDocument,
};
use bifdiag_survey::border::classes_of;
use dashu_ratio::RBig;

use crate::stability::{friction, isolated_spins};

/// A rate of turning, from rad/s.
#[must_use]
pub fn spin(rad_per_s: f64) -> SpinDocument {
    SpinDocument { rpm: Spin::rpm(rad_per_s), rad_per_s }
}

/// A rate of turning as it was asked for.
#[must_use]
pub fn asked_spin(spin: &Spin) -> SpinDocument {
    SpinDocument { rpm: spin.in_rpm(), rad_per_s: spin.rad_per_s() }
}

/// The name of a type that a rotation has between its changes: with C = 2A = 2B, and of a free plate about its normal,
/// both pairs agree at every spin.
#[must_use]
pub fn type_name(rotation: &AxisRotation, kind: SpinType) -> &'static str {
    let [c, a, b] = &rotation.moments;
    if kind == SpinType::Minimum && *c == a + b && (a == b || rotation.weight.is_zero()) {
        return "double-elliptic (local minimum)";
    }
    kind.name()
}

fn change(change: &RotationChange, rotation: &AxisRotation, up: &str, second: f64) -> SpinChangeDocument {
    let RotationChange { omega, error_bound, .. } = *change;
    let name = |of: fn(&bifdiag_equilibria::permanent::SpinChange) -> SpinType| {
        let found = match &change.stability {
            Some(change) => Some(of(change)),
            None => RBig::try_from(omega).ok().and_then(|omega| rotation.type_at_spin(&omega)),
        };
        found.map_or_else(String::new, |found| type_name(rotation, found).to_owned())
    };
    SpinChangeDocument {
        up: up.to_owned(),
        spin: spin(omega * second),
        l: rotation.l(omega),
        h: rotation.h(omega),
        kind: match (&change.stability, change.region) {
            (Some(_), Some(_)) => "stability-and-region",
            (Some(_), None) => "stability",
            _ => "region",
        }
        .to_owned(),
        from: name(|change| change.from),
        to: name(|change| change.to),
        event: change.region.map(|event| event.name().to_owned()),
        error_bound: error_bound * second,
    }
}

/// Everything that changes with the spin of a rotation, by rising spin; `second` is one second in the body's unit of time,
/// and without an atlas only the stability is known.
#[must_use]
pub fn spin_changes(rotation: &AxisRotation, up: &str, atlas: Option<&Atlas>, second: f64) -> Vec<SpinChangeDocument> {
    rotation_changes(rotation, atlas).iter().map(|found| change(found, rotation, up, second)).collect()
}

/// The spins between the changes of type of a rotation, each with the verdict on rotation there: where the normal form decides,
/// Arnold's theorem but at the isolated spins among the [`exceptions`](bifdiag_equilibria::critical::RelativeEquilibria::exceptions) of the body, or where
/// these are not known the verdict at one spin inside. Left out where no double lies inside.
#[must_use]
pub fn spin_stretches(
    rotation: &AxisRotation,
    up: &str,
    second: f64,
    exceptions: Option<&[(Equilibrium, VerdictChange)]>,
) -> Vec<SpinStretchDocument> {
    /// Spins inside, relative to the ends, or to the one that there is.
    const INSIDE: [f64; 5] = [0.5, 0.41, 0.63, 0.29, 0.77];
    let changes = rotation.changes();
    let pole = if rotation.weight > RBig::ZERO { Pole::Plus } else { Pole::Minus };
    let on_axis = |point: &Equilibrium| matches!(point.curve, Some(CurveName::Piece { branch, .. }) if branch == BranchName::Axis(pole));
    let stretch = |k: usize| {
        let (from, to) = (k.checked_sub(1).map(|k| &changes[k]), changes.get(k));
        let place = |part: f64| match (from, to) {
            (Some(from), Some(to)) => from.omega + part * (to.omega - from.omega),
            (None, Some(to)) => part * to.omega,
            (Some(from), None) => from.omega / part,
            (None, None) => part,
        };
        let expected = from.map(|change| change.to).or(to.map(|change| change.from));
        let (kind, judged) = INSIDE.into_iter().find_map(|part| {
            let omega = RBig::try_from(place(part)).ok()?;
            let kind = rotation.type_at_spin(&omega).filter(|kind| expected.is_none_or(|known| known == *kind))?;
            Some((kind, rotation.stability_at_spin(&omega)?))
        })?;
        let by_normal_form = judged.nonlinear.near.is_some();
        let (verdict, why) = match exceptions {
            Some(_) if by_normal_form => (NonlinearVerdict::Stable, Reason::Arnold),
            _ => (judged.nonlinear.verdict, judged.nonlinear.why),
        };
        let inside = |point: &Equilibrium| {
            by_normal_form
                && on_axis(point)
                && from.is_none_or(|from| from.omega < point.omega.abs())
                && to.is_none_or(|to| point.omega.abs() < to.omega)
        };
        Some(SpinStretchDocument {
            up: up.to_owned(),
            from: from.map(|change| spin(change.omega * second)),
            to: to.map(|change| spin(change.omega * second)),
            stability: kind.name().to_owned(),
            // `verify` does not check what follows from the normal form.
            nonlinear: NonlinearDocument::along(verdict, why, judged.nonlinear.proved && !by_normal_form),
            isolated: exceptions.map(|list| isolated_spins(list, second, inside)),
            friction: FrictionDocument { rates: Vec::new(), ..friction(&judged.friction, &[[0.0; 2]; 2]) },
        })
    };
    (0..=changes.len()).filter_map(stretch).collect()
}

/// The changes at the next smaller spin than Ω, at Ω itself, and at the next larger one.
#[must_use]
pub fn changes_beside(
    rotation: &AxisRotation,
    up: &str,
    atlas: Option<&Atlas>,
    second: f64,
    omega: &RBig,
) -> [Option<SpinChangeDocument>; 3] {
    let changes = rotation_changes(rotation, atlas);
    let at = |place: Ordering| changes.iter().filter(move |change| change.place_of(omega) == place);
    let beside = [at(Ordering::Greater).next_back(), at(Ordering::Equal).next(), at(Ordering::Less).next()];
    beside.map(|found| found.map(|found| change(found, rotation, up, second)))
}

/// What relative tolerances of C, A, B and the weight do to the changes of stability of some rotations, each with the name of
/// the end that is up.
#[must_use]
pub fn tolerance(rotations: &[(&str, AxisRotation)], relative: &[Number; 4], second: f64) -> ToleranceDocument {
    let values = relative.each_ref().map(|relative| relative.value().clone());
    let ranges = rotations.iter().flat_map(|(up, rotation)| {
        spin_ranges(rotation, &values).into_iter().map(|range| spin_range(up, &range, second))
    });
    let (classes, sampled_parts) = match rotations.first() {
        Some((_, rotation)) => sampled_classes(sampled_bodies(rotation, &values)),
        None => (Vec::new(), 0),
    };
    ToleranceDocument {
        relative: Some(relative.each_ref().map(|relative| relative.text().to_owned())),
        inputs: Vec::new(),
        moving: false,
        tilt_deg: None,
        sampled_parts,
        classes,
        ranges: ranges.collect(),
    }
}

/// What the deviations of a part's numbers do to the steady rotations near an axis. `ends` are the ends of the axis that are
/// up, in the part's frame, each with its name; `second` is one second in the part's unit of time.
#[must_use]
pub fn measured_tolerance(
    part: &Part,
    measured: &MeasuredPart,
    ends: [(&str, [f64; 3], Near<'_>); 2],
    second: f64,
) -> ToleranceDocument {
    let moving = ends.iter().any(|(.., near)| !matches!(near, Near::Axis(_)));
    let settled = ends.map(|(name, up, near)| (name, settled_types_of_part(part, measured, up, near)));
    let (classes, sampled_parts) = sampled_classes(sampled_parts(part, measured));
    let input = |k: usize| MeasuredDocument {
        name: INPUT_NAMES[k].to_owned(),
        value: decimal::short(&measured.inputs[k].value),
        within: decimal::short(&measured.inputs[k].within),
    };
    let ranges =
        settled.iter().flat_map(|(name, found)| found.ranges.iter().map(|range| spin_range(name, range, second)));
    ToleranceDocument {
        relative: None,
        inputs: measured.uncertain().map(input).collect(),
        moving,
        tilt_deg: largest_tilt(&settled),
        sampled_parts,
        classes,
        ranges: ranges.collect(),
    }
}

/// What one relative tolerance of the principal moments and of r does to the steady rotations that tend to an axis at fast
/// spins. `ends` are the ends of the axis that are up, in principal axes, each with its name
/// and the spin at which its rotation begins.
#[must_use]
pub fn tolerance_beside(
    body: &Body,
    share: &Number,
    ends: [(&str, [f64; 3], f64); 2],
    second: f64,
) -> ToleranceDocument {
    let settled = ends.map(|(name, up, slowest)| (name, settled_types_of_shares(body, share.value(), up, slowest)));
    let (classes, sampled_parts) = sampled_classes(sampled_shares(body, share.value()));
    let ranges =
        settled.iter().flat_map(|(name, found)| found.ranges.iter().map(|range| spin_range(name, range, second)));
    ToleranceDocument {
        relative: Some(std::array::from_fn(|_| share.text().to_owned())),
        inputs: Vec::new(),
        moving: true,
        tilt_deg: largest_tilt(&settled),
        sampled_parts,
        classes,
        ranges: ranges.collect(),
    }
}

/// The largest tilt in degrees; `None` where the axis itself is permanent for all.
fn largest_tilt(settled: &[(&str, SettledTypes)]) -> Option<f64> {
    settled.iter().filter_map(|(_, found)| found.tilt).reduce(f64::max).map(f64::to_degrees)
}

/// A range of spins in the body's unit of time, with the name of the end that is up.
fn spin_range(up: &str, range: &SpinRange, second: f64) -> SpinRangeDocument {
    let rpm = |omega: f64| omega.is_finite().then(|| Spin::rpm(omega * second));
    let name = |found: SpinType| found.name().to_owned();
    SpinRangeDocument {
        up: up.to_owned(),
        from: range.from.map(name),
        to: range.to.map(name),
        rpm: range.omega.map(rpm),
        between: range.between.iter().copied().map(name).collect(),
        most: range.most.map(|(input, _)| input.to_owned()),
        most_rpm: range.most.and_then(|(_, omega)| rpm(omega)),
    }
}

/// How many sampled parts have each class, and how many parts that were.
fn sampled_classes(bodies: impl Iterator<Item = Option<Body>>) -> (Vec<SampledClassDocument>, usize) {
    let counts = classes_of(bodies);
    let parts = counts.iter().map(|(_, parts)| parts).sum();
    let document =
        |(name, parts)| SampledClassDocument { class: Option::map(name, |name| ToString::to_string(&name)), parts };
    (counts.into_iter().map(document).collect(), parts)
}

/// `bifdiag COMMAND` with the options that describe a measured part.
#[must_use]
pub fn measured_command(command: &str, part: &Part, measured: &MeasuredPart) -> CommandLine {
    let text = |number: &Measured| {
        let value = decimal::short(&number.value);
        if number.within.is_zero() { value } else { format!("{value}+-{}", decimal::short(&number.within)) }
    };
    let list = |numbers: &[Measured]| numbers.iter().map(text).collect::<Vec<_>>().join(",");
    let products = measured.inputs[3..6].iter().any(|product| !product.value.is_zero());
    CommandLine::new(command)
        .option(if measured.about_com { "inertia-com" } else { "inertia" }, list(&measured.inputs[..6]))
        .option_if("products", products.then_some("tensor"))
        .option("com", list(&measured.inputs[6..9]))
        .option("mass", list(&measured.inputs[9..10]))
        .option("units", &part.units)
        .option("g", list(&measured.inputs[10..]))
        .flag("unphysical", !part.properties.existence().is_possible())
}

#[cfg(test)]
mod tests {
    use bifdiag_body::BodyAxis;
    use bifdiag_equilibria::permanent::SAMPLES;
    use bifdiag_numbers::Sign;

    use super::*;

    /// Among parts that are nearly symmetric are symmetric ones, which have other diagrams; all parts are counted.
    #[test]
    fn a_symmetric_part_has_neighbours_of_another_class() {
        let body = Body::parse(&["1", "1", "0.6"], &["0", "0", "1"]).unwrap();
        let rotation = AxisRotation::new(&body, BodyAxis::ALL[2], Sign::Negative).unwrap();
        let classes = |percent: i32| {
            let tolerance = RBig::from_parts(percent.into(), 100_u8.into());
            sampled_classes(sampled_bodies(&rotation, &std::array::from_fn(|_| tolerance.clone()))).0
        };
        let one = classes(0);
        assert_eq!((one.len(), one[0].parts), (1, SAMPLES));
        let several = classes(1);
        assert!(several.len() > 1 && several.iter().any(|found| found.class == one[0].class), "{several:?}");
        assert!(several.iter().all(|found| found.class.is_some()), "{several:?}");
        assert_eq!(several.iter().map(|found| found.parts).sum::<usize>(), SAMPLES);
    }
}
