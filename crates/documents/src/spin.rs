//! Spins and states as documents.

use std::cmp::Ordering;
use std::collections::BTreeMap;

use bifdiag_body::Body;
use bifdiag_body::part::Spin;
use bifdiag_diagram::atlas::Atlas;
use bifdiag_diagram::class::ClassName;
use bifdiag_diagram::region_changes::{RegionChange, region_changes};
use bifdiag_equilibria::permanent::{
    AxisRotation, SAMPLES, SpinChange, SpinRange, SpinType, sampled_bodies, spin_ranges,
};
use bifdiag_exact::Accuracy;
use bifdiag_numbers::Number;
use bifdiag_schema::{SampledClassDocument, SpinChangeDocument, SpinDocument, SpinRangeDocument, ToleranceDocument};
use bifdiag_survey::border::class_of;
use dashu_ratio::RBig;

/// A rate of turning, from rad/s.
#[must_use]
pub fn spin(rad_per_s: f64) -> SpinDocument {
    SpinDocument { rpm: Spin::rpm(rad_per_s), rad_per_s }
}

/// A spin at which something changes.
struct Change {
    stability: Option<SpinChange>,
    region: Option<RegionChange>,
}

impl Change {
    /// All of a rotation, by rising spin; without an atlas only those of the stability are known.
    fn all(rotation: &AxisRotation, atlas: Option<&Atlas>) -> Vec<Self> {
        let stability = |change| Self { stability: Some(change), region: None };
        let mut changes: Vec<Self> = rotation.changes().into_iter().map(stability).collect();
        for region in atlas.map(|atlas| region_changes(atlas, rotation)).unwrap_or_default() {
            let is_same = |change: &&mut Self| {
                let of_type = change.stability.as_ref();
                of_type.is_some_and(|at| (at.omega - region.omega).abs() <= at.error_bound + region.error_bound)
            };
            match changes.iter_mut().find(is_same) {
                Some(same) => same.region = Some(region),
                None => changes.push(Self { stability: None, region: Some(region) }),
            }
        }
        changes.sort_by(|p, q| p.spin().0.total_cmp(&q.spin().0));
        changes
    }

    /// Ω and a bound on its error.
    fn spin(&self) -> (f64, f64) {
        match (&self.stability, &self.region) {
            (Some(change), _) => (change.omega, change.error_bound),
            (None, Some(change)) => (change.omega, change.error_bound),
            (None, None) => (f64::NAN, f64::NAN),
        }
    }

    /// Where a spin stands to it: exactly if the type changes, else equal within rounding.
    fn place_of(&self, omega: &RBig) -> Ordering {
        if let Some(change) = &self.stability {
            return change.place_of(omega);
        }
        let (at, error_bound) = self.spin();
        let apart = omega.to_f64().value() - at;
        if apart.abs() <= error_bound { Ordering::Equal } else { apart.total_cmp(&0.0) }
    }

    fn document(&self, rotation: &AxisRotation, up: &str, second: f64) -> SpinChangeDocument {
        let (at, error_bound) = self.spin();
        let here = || {
            let found = RBig::try_from(at).ok().and_then(|at| rotation.type_at_spin(&at));
            found.map_or_else(String::new, |found| found.name().to_owned())
        };
        let (stability, region) = (self.stability.as_ref(), self.region);
        SpinChangeDocument {
            up: up.to_owned(),
            spin: spin(at * second),
            l: rotation.l(at),
            h: rotation.h(at),
            kind: match (stability, region) {
                (Some(_), Some(_)) => "stability-and-region",
                (Some(_), None) => "stability",
                _ => "region",
            }
            .to_owned(),
            from: stability.map_or_else(here, |change| change.from.name().to_owned()),
            to: stability.map_or_else(here, |change| change.to.name().to_owned()),
            event: region.map(|change| change.event.name().to_owned()),
            error_bound: error_bound * second,
        }
    }
}

/// Everything that changes with the spin of a rotation, by rising spin; `second` is one second in the body's unit of time,
/// and without an atlas only the stability is known.
#[must_use]
pub fn spin_changes(rotation: &AxisRotation, up: &str, atlas: Option<&Atlas>, second: f64) -> Vec<SpinChangeDocument> {
    Change::all(rotation, atlas).iter().map(|change| change.document(rotation, up, second)).collect()
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
    let changes = Change::all(rotation, atlas);
    let at = |place: Ordering| changes.iter().filter(move |change| change.place_of(omega) == place);
    let beside = [at(Ordering::Greater).next_back(), at(Ordering::Equal).next(), at(Ordering::Less).next()];
    beside.map(|change| change.map(|change| change.document(rotation, up, second)))
}

/// What relative tolerances of C, A, B and the weight do to the changes of stability of some rotations, each with the name of
/// the end that is up.
#[must_use]
pub fn tolerance(rotations: &[(&str, AxisRotation)], relative: &[Number; 4], second: f64) -> ToleranceDocument {
    let values = relative.each_ref().map(|relative| relative.value().clone());
    let ranges = rotations.iter().flat_map(|(up, rotation)| {
        spin_ranges(rotation, &values).into_iter().map(|range| spin_range(up, &range, second))
    });
    ToleranceDocument {
        relative: Some(relative.each_ref().map(|relative| relative.text().to_owned())),
        inputs: Vec::new(),
        tilt_deg: None,
        sampled_parts: SAMPLES,
        classes: rotations.first().map_or_else(Vec::new, |(_, rotation)| classes_of(sampled_bodies(rotation, &values))),
        ranges: ranges.collect(),
    }
}

/// A range of spins in the body's unit of time, with the name of the end that is up.
pub(crate) fn spin_range(up: &str, range: &SpinRange, second: f64) -> SpinRangeDocument {
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

/// How many sampled parts have each class, the most frequent first; no class stands for parts whose class is not decided,
/// and for those that are no bodies.
pub(crate) fn classes_of(bodies: impl Iterator<Item = Option<Body>>) -> Vec<SampledClassDocument> {
    let mut counts: BTreeMap<Option<ClassName>, usize> = BTreeMap::new();
    for body in bodies {
        let class = body.and_then(|body| class_of(&body, Accuracy::Exact).ok());
        *counts.entry(class.map(|(_, class)| class.name().clone())).or_default() += 1;
    }
    let mut counts: Vec<_> = counts.into_iter().collect();
    counts.sort_by(|(p, p_count), (q, q_count)| q_count.cmp(p_count).then_with(|| p.cmp(q)));
    let document = |(name, parts): (Option<ClassName>, usize)| SampledClassDocument {
        class: name.map(|name| name.to_string()),
        parts,
    };
    counts.into_iter().map(document).collect()
}

#[cfg(test)]
mod tests {
    use bifdiag_body::BodyAxis;
    use bifdiag_numbers::Sign;
    use dashu_ratio::RBig;

    use super::*;

    /// Among parts that are nearly symmetric are symmetric ones, which have other diagrams; all parts are counted.
    #[test]
    fn a_symmetric_part_has_neighbours_of_another_class() {
        let body = Body::parse(&["1", "1", "0.6"], &["0", "0", "1"]).unwrap();
        let rotation = AxisRotation::new(&body, BodyAxis::ALL[2], Sign::Negative).unwrap();
        let classes = |percent: i32| {
            let tolerance = RBig::from_parts(percent.into(), 100_u8.into());
            classes_of(sampled_bodies(&rotation, &std::array::from_fn(|_| tolerance.clone())))
        };
        let one = classes(0);
        assert_eq!((one.len(), one[0].parts), (1, SAMPLES));
        let several = classes(1);
        assert!(several.len() > 1 && several.iter().any(|found| found.class == one[0].class), "{several:?}");
        assert!(several.iter().all(|found| found.class.is_some()), "{several:?}");
        assert_eq!(several.iter().map(|found| found.parts).sum::<usize>(), SAMPLES);
    }
}
