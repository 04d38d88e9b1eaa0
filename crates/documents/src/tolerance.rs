//! What tolerances do to the spins at which rotation about an axis changes, as a document.

use bifdiag_body::part::{Measured, MeasuredPart, Part, Spin};
use bifdiag_equilibria::permanent::SpinRange;
use bifdiag_numbers::{Number, decimal};
use bifdiag_schema::{
    AxisEnd, CommandLine, MeasuredDocument, SampledClassDocument, SpinRangeDocument, ToleranceDocument,
};
use bifdiag_survey::tolerance::{Tolerances, Tolerated};

/// What was found within some tolerances; `second` is one second in the body's unit of time.
pub(crate) fn tolerance(tolerances: Tolerances<'_>, found: &Tolerated, second: f64) -> ToleranceDocument {
    let ranges = AxisEnd::ALL
        .iter()
        .zip(&found.ends)
        .flat_map(|(end, settled)| settled.ranges.iter().map(|range| spin_range(*end, range, second)));
    let class = |(name, parts): &(Option<_>, usize)| SampledClassDocument {
        class: name.as_ref().map(ToString::to_string),
        parts: *parts,
    };
    let measured = |part: &MeasuredPart, k: usize| {
        let (name, value) = part.named(k);
        let within = decimal::short(&part.inputs[k].within);
        MeasuredDocument { name: name.to_owned(), value: decimal::short(value), within }
    };
    let (relative, inputs) = match tolerances {
        Tolerances::Exact => (None, Vec::new()),
        Tolerances::Shares(shares) => (Some(crate::body::texts(shares)), Vec::new()),
        Tolerances::Measured(_, part) => (None, part.uncertain().map(|k| measured(part, k)).collect()),
    };
    ToleranceDocument {
        relative,
        inputs,
        moving: found.is_moving,
        tilt_deg: found.tilt().map(f64::to_degrees),
        sampled_parts: found.sampled(),
        classes: found.classes.iter().map(class).collect(),
        ranges: ranges.collect(),
    }
}

/// A range of spins in the body's unit of time, with the end that is up.
fn spin_range(up: AxisEnd, range: &SpinRange, second: f64) -> SpinRangeDocument {
    let rpm = |omega: f64| omega.is_finite().then(|| Spin::rpm(omega * second));
    // Three times rounded on the way.
    let outward = |share: f64| move |rpm: f64| rpm * (1.0 + share * f64::EPSILON);
    let [low, high] = range.omega.map(rpm);
    SpinRangeDocument {
        up,
        from: range.from,
        to: range.to,
        rpm: [low.map(outward(-2.0)), high.map(outward(2.0))],
        between: range.between.clone(),
        most: range.most.map(|(input, _)| input.to_owned()),
        most_rpm: range.most.and_then(|(_, omega)| rpm(omega)),
    }
}

/// Shares as they are given to the command.
pub(crate) fn shares_text(shares: &[Number; 4]) -> String {
    if let Some(share) = Tolerances::share_of_all(shares) {
        return share.text().to_owned();
    }
    let [axis, first, _, weight] = shares;
    format!("axis={},across={},weight={}", axis.text(), first.text(), weight.text())
}

/// `bifdiag COMMAND` with the options that describe a measured part.
pub(crate) fn measured_command(command: &str, part: &Part, measured: &MeasuredPart) -> CommandLine {
    let text = |number: &Measured| {
        let value = decimal::short(&number.value);
        if number.within.is_zero() { value } else { format!("{value}+-{}", decimal::short(&number.within)) }
    };
    let list = |numbers: &[Measured]| numbers.iter().map(text).collect::<Vec<_>>().join(",");
    let products = measured.inputs[3..6].iter().any(|product| !product.value.is_zero());
    let is_zero = |number: &Measured| number.value.is_zero() && number.within.is_zero();
    let pivot = (!measured.pivot.iter().all(is_zero)).then(|| list(&measured.pivot));
    CommandLine::new(command)
        .option(if measured.about_com { "inertia-com" } else { "inertia" }, list(&measured.inputs[..6]))
        .option_if("products", products.then_some("tensor"))
        .option("com", list(&measured.com()))
        .option_if("pivot", pivot)
        .option("mass", list(&measured.inputs[9..10]))
        .option("units", &part.units)
        .option("g", list(&measured.inputs[10..]))
        .flag("unphysical", !part.properties.existence().is_possible())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shares_are_written_once_where_they_agree() {
        let text = |shares: [&str; 4]| shares_text(&shares.map(|share| share.parse().unwrap()));
        assert_eq!(text(["0.01"; 4]), "0.01");
        assert_eq!(text(["0.01", "0.01", "0.01", "0"]), "axis=0.01,across=0.01,weight=0");
    }
}
