//! Parts whose numbers are known to within so much, as documents.

use bifdiag_body::part::{INPUT_NAMES, INPUTS, Measured, MeasuredPart, Part};
use bifdiag_equilibria::permanent::{BoxedBody, SettledTypes, SpinRange, settled_types};
use bifdiag_numbers::{decimal, sequence};
use bifdiag_schema::{MeasuredDocument, SampledClassDocument, ToleranceDocument};
use dashu_ratio::RBig;

use crate::body::principal;
use crate::command::CommandLine;
use crate::spin::{classes_of, spin_range};

/// Parts that are tried for their classes, the nominal one first.
const SAMPLES: u64 = 81;

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
        .option("mass", list(&measured.inputs[9..]))
        .option("units", &part.units)
        .option("g", decimal::short(&part.gravity))
        .flag("unphysical", !part.properties.existence().is_possible())
}

/// What the deviations of a part's numbers do to the steady rotations near an axis. `ends` are the ends of the axis that are
/// up, in the part's frame, each with its name; `second` is one second in the part's unit of time.
#[must_use]
pub fn measured_tolerance(
    part: &Part,
    measured: &MeasuredPart,
    ends: [(&str, [f64; 3]); 2],
    second: f64,
) -> ToleranceDocument {
    let mut tilt = 0.0_f64;
    let mut ranges = Vec::new();
    for (name, up) in ends {
        let found = settled(part, measured, up);
        tilt = tilt.max(found.tilt);
        let alone: Vec<(usize, SettledTypes)> =
            measured.uncertain().map(|k| (k, settled(part, &measured.only(k), up))).collect();
        ranges.extend(found.ranges.iter().map(|range| {
            let most = most(range, &alone).map(|(input, moved)| (INPUT_NAMES[input], moved));
            spin_range(name, &SpinRange { most, ..range.clone() }, second)
        }));
    }
    let (classes, sampled_parts) = sampled_classes(part, measured);
    let told = |k: usize| MeasuredDocument {
        name: INPUT_NAMES[k].to_owned(),
        value: decimal::short(&measured.inputs[k].value),
        within: decimal::short(&measured.inputs[k].within),
    };
    ToleranceDocument {
        relative: None,
        inputs: measured.uncertain().map(told).collect(),
        tilt_deg: Some(tilt.to_degrees()),
        sampled_parts,
        classes,
        ranges,
    }
}

fn settled(part: &Part, measured: &MeasuredPart, up: [f64; 3]) -> SettledTypes {
    let (tensor, center) = measured.bounds(&part.units.acceleration(&part.gravity));
    settled_types(&BoxedBody { tensor, center }, up)
}

/// The number that alone leaves the largest part of a range unsettled, and half of that.
fn most(range: &SpinRange, alone: &[(usize, SettledTypes)]) -> Option<(usize, f64)> {
    let [from, to] = range.omega;
    let unsettled = |found: &SettledTypes| {
        let common = found.ranges.iter().map(|other| (other.omega[1].min(to) - other.omega[0].max(from)).max(0.0));
        0.5 * common.sum::<f64>()
    };
    alone.iter().map(|(input, found)| (*input, unsettled(found))).filter(|(_, moved)| *moved > 0.0).max_by(|p, q| {
        // Of equals the first.
        p.1.total_cmp(&q.1).then(q.0.cmp(&p.0))
    })
}

/// The classes of sampled parts that can exist (of all, where the nominal one cannot), the most frequent first, and how many
/// parts that were.
fn sampled_classes(part: &Part, measured: &MeasuredPart) -> (Vec<SampledClassDocument>, usize) {
    let physical = part.properties.existence().is_possible();
    let sampled = (0..SAMPLES).filter_map(|number| measured.at(&steps(number)).ok());
    let possible = sampled.filter(|properties| !physical || properties.existence().is_possible());
    let bodies = possible.map(|properties| Some(principal(&Part { properties, ..part.clone() }).ok()?.body));
    let classes = classes_of(bodies);
    let parts = classes.iter().map(|found| found.parts).sum();
    (classes, parts)
}

/// A random point of the cube from −1 to 1; number 0 is its middle.
fn steps(number: u64) -> [RBig; INPUTS] {
    const BITS: u32 = 20;
    std::array::from_fn(|k| {
        if number == 0 {
            return RBig::ZERO;
        }
        let bits = sequence::random(number * INPUTS as u64 + k as u64) >> (64 - BITS - 1);
        RBig::from_parts(i64::try_from(bits).unwrap_or_default().into(), (1_u64 << BITS).into()) - RBig::ONE
    })
}
