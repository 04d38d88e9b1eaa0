//! How well the moments and the weight are known.

use bifdiag_body::Number;
use bifdiag_numbers::decimal;
use bifdiag_schema::{
    AxisEnd, CriticalSpinDocument, MeasuredDocument, SampledClassDocument, SpinRangeDocument, SpinType,
    ToleranceDocument,
};
use dashu_ratio::RBig;

use crate::cli::failure::Failure;
use crate::cli::input::values;
use crate::cli::terminal::{Report, Table, bound, bound_below, counted, significant};

/// Relative tolerances of the moment about the axis, of the two others, and of the weight times its distance.
#[derive(Clone, Debug, PartialEq)]
pub struct ToleranceArgument(pub [Number; 4]);

/// Digits of a bound, and of one of a narrow range or beside another one at most.
const DIGITS: [usize; 2] = [6, 17];

/// Position of the column of types found inside a range.
const INSIDE: usize = 4;

/// The names that can have their own tolerance, and which of the four each sets.
const NAMES: [(&str, [bool; 4]); 4] = [
    ("axis", [true, false, false, false]),
    ("across", [false, true, true, false]),
    ("moments", [true, true, true, false]),
    ("weight", [false, false, false, true]),
];

/// One for all, 1% or 0.01, or each by name: axis=0.5%,across=1%,weight=2%; what is not named is exact.
pub fn tolerance(text: &str) -> Result<ToleranceArgument, Failure> {
    if !text.contains('=') {
        let one = relative(text)?;
        return Ok(ToleranceArgument(std::array::from_fn(|_| one.clone())));
    }
    let zero = values::number("0")?;
    let mut all: [Number; 4] = std::array::from_fn(|_| zero.clone());
    let mut given = [false; 4];
    for item in text.split(',') {
        let (name, value) = item.split_once('=').ok_or_else(wrong)?;
        let known = NAMES.iter().find(|(known, _)| *known == name.trim());
        let (name, which) = known.ok_or_else(|| unknown(name.trim()))?;
        let value = relative(value)?;
        for (place, _) in which.iter().enumerate().filter(|(_, named)| **named) {
            if std::mem::replace(&mut given[place], true) {
                return Err(Failure::input(format!(
                    "{name}: another item sets the same moment or the weight already; leave out one of them"
                )));
            }
            all[place] = value.clone();
        }
    }
    Ok(ToleranceArgument(all))
}

/// 1% or 0.01.
fn relative(text: &str) -> Result<Number, Failure> {
    let text = text.trim();
    let (number, percent) = text.strip_suffix('%').map_or((text, false), |number| (number, true));
    let number = values::number(number)?;
    let value = if percent { number.value() / RBig::from(100) } else { number.value().clone() };
    // Beyond, moments would vanish.
    if value >= RBig::ZERO && value <= RBig::from_parts(1.into(), 2u8.into()) {
        Ok(values::number(&decimal::short(&value))?)
    } else {
        Err(wrong())
    }
}

fn unknown(name: &str) -> Failure {
    let names: Vec<&str> = NAMES.iter().map(|(name, _)| *name).collect();
    Failure::input(format!("{name:?} is none of the names {}", names.join(", ")))
}

fn wrong() -> Failure {
    Failure::input(
        "a tolerance is a share from 0 to 50%, such as 1% or 0.01, or shares by name: axis=0.5%,across=1%,weight=2%",
    )
}

/// The ranges as a table, and at which spins every part is stable.
pub fn report(report: &mut Report, document: &CriticalSpinDocument) {
    let Some(tolerance) = &document.tolerance else { return };
    report.line("");
    report.line("what stands above is of the nominal part alone");
    let Some(relative) = &tolerance.relative else {
        return measured(report, tolerance, document.slow.as_ref());
    };
    if tolerance.moving {
        let [share, ..] = relative;
        report.line(format!(
            "every body whose principal moments and components of r differ by at most a factor of 1 ± {share} \
            (bounds, not samples):"
        ));
        return beside(report, tolerance, document.slow.as_ref());
    }
    let [axis, first, second, weight] = relative;
    report.line(if [first, second, weight].iter().all(|other| *other == axis) {
        format!("every part whose moments and weight differ by at most a factor of 1 ± {axis} (bounds, not samples):")
    } else {
        let known =
            [(axis, "the moment about the axis"), (first, "the two moments across the axis"), (weight, "the weight")];
        let loose = known.iter().filter(|(share, _)| *share != "0");
        let loose: Vec<String> = loose.map(|(share, what)| format!("{what} times 1 ± {share}")).collect();
        let exact = if loose.len() < known.len() { "; what is not named is exact" } else { "" };
        format!("every part with {} (bounds, not samples{exact}):", loose.join(", "))
    });
    ranges(report, &tolerance.ranges, document.slow.as_ref(), true);
    report.line(classes(tolerance));
    if !tolerance.ranges.is_empty() {
        report.line(format!(
            "what is found inside a range comes from {}; \"matters most\" and \"moves it by\" are of the \
            nominal part's last change in that range",
            counted(tolerance.sampled_parts, "sampled part", "sampled parts")
        ));
    }
}

/// The same where each number has its own ±.
fn measured(report: &mut Report, tolerance: &ToleranceDocument, slow: Option<&[SpinType; 2]>) {
    let inputs: Vec<String> =
        tolerance.inputs.iter().map(|input| format!("{} {} ± {}", input.name, input.value, input.within)).collect();
    let is_product = |input: &MeasuredDocument| ["Ixy", "Ixz", "Iyz"].contains(&&*input.name) && input.value != "0";
    let products = if tolerance.inputs.iter().any(is_product) { "products as entries of the tensor; " } else { "" };
    report.line(format!("every part with {} ({products}bounds, not samples):", inputs.join(", ")));
    beside(report, tolerance, slow);
}

/// The ranges of steady rotations near the axis or the nominal rotation.
fn beside(report: &mut Report, tolerance: &ToleranceDocument, slow: Option<&[SpinType; 2]>) {
    let of = if tolerance.moving { "that of the nominal part at this spin" } else { "the permanent axis" };
    report.line(match tolerance.tilt_deg {
        None => "all of them have this permanent axis".to_owned(),
        Some(0.0) => "no spin was found at which all of them were shown to have a steady rotation near the nominal one"
            .to_owned(),
        // Below this it is the rounding of the bounds.
        Some(tilt) => {
            let tilt = bound(tilt.max(1e-9), 2);
            format!("at each spin outside these ranges it has a steady rotation within {tilt}° of {of}")
        }
    });
    ranges(report, &tolerance.ranges, slow, false);
    report.line(classes(tolerance));
}

/// The ranges as a table, with what was found `inside` them too, and at which spins every part is stable; `slow` are the types
/// of the nominal part at slow spins.
fn ranges(report: &mut Report, ranges: &[SpinRangeDocument], slow: Option<&[SpinType; 2]>, inside: bool) {
    if !ranges.is_empty() {
        report.line(table(ranges, inside));
        if !inside && ranges.iter().any(|range| range.from.is_some() && range.from == range.to) {
            report.line("where `below` and `above` agree, the types inside the range were not found");
        }
        report.line("the ranges are those of the type; regions and frequencies may change at other spins");
    }
    for (up, slow) in AxisEnd::ALL.iter().zip(slow.into_iter().flatten()) {
        report.line(certainly(*up, *slow, ranges));
    }
    // Whichever type the nominal one has, of some of them both pairs may agree.
    let of_ranges = ranges.iter().flat_map(|range| range.from.iter().chain(&range.to).chain(&range.between));
    let has_none = |up: AxisEnd| ranges.iter().all(|range| range.up != up);
    let everywhere = AxisEnd::ALL.iter().zip(slow.into_iter().flatten()).filter(|(up, _)| has_none(**up));
    if everywhere.map(|(_, kind)| kind).chain(of_ranges).any(|kind| kind.is_elliptic()) {
        report.line("of these parts elliptic means elliptic or double-elliptic");
    }
}

fn table(ranges: &[SpinRangeDocument], inside: bool) -> String {
    let mut names = vec!["up", "rpm", "below", "above", "matters most", "moves it by"];
    if inside {
        names.insert(INSIDE, "inside too");
    } else {
        // These are bounds with one input's tolerance alone, which may be far wider than what happens.
        names.splice(4.., ["widest bound by", "half its width"]);
    }
    let mut table = Table::new(&names);
    let of_end = |up: AxisEnd| written(&ranges.iter().filter(|range| range.up == up).collect::<Vec<_>>());
    // They are listed by the end that is up.
    let bounds = AxisEnd::ALL.iter().flat_map(|up| of_end(*up));
    for (range, [low, high]) in ranges.iter().zip(bounds) {
        let word = |found: Option<SpinType>| found.map_or("-", SpinType::word).to_owned();
        let mut cells = vec![
            range.up.word().to_owned(),
            format!("{low} .. {high}"),
            word(range.from),
            word(range.to),
            range.most.clone().unwrap_or_else(|| "-".to_owned()),
            match (&range.most, range.most_rpm) {
                (_, Some(rpm)) => format!("{} rpm", significant(rpm, 3)),
                (Some(_), None) if inside => "the change vanishes".to_owned(),
                (Some(_), None) => "inf".to_owned(),
                (None, None) => "-".to_owned(),
            },
        ];
        if inside {
            let between: Vec<&str> = range.between.iter().map(|kind| kind.word()).collect();
            let between = if between.is_empty() { "-".to_owned() } else { between.join(", ") };
            cells.insert(INSIDE, between);
        }
        table.row(cells);
    }
    table.text()
}

/// The classes of the diagrams of the sampled parts, in words.
fn classes(tolerance: &ToleranceDocument) -> String {
    let count =
        |found: &SampledClassDocument| format!("{} ({})", found.class.as_deref().unwrap_or("open"), found.parts);
    let list: Vec<String> = tolerance.classes.iter().map(count).collect();
    let sampled = counted(tolerance.sampled_parts, "sampled part", "sampled parts");
    format!("classes of diagrams of the {sampled}: {}", list.join(", "))
}

/// The bounds of ranges of one end that is up, by rising spin, rounded outward: with more than the fewest digits where a narrow
/// range would look wider, or one would seem to touch the next.
fn written(ranges: &[&SpinRangeDocument]) -> Vec<[String; 2]> {
    let end = |k: usize, end: usize| ranges.get(k).and_then(|range| range.rpm[end]);
    let one = |k: usize| {
        let ([low, high], before) = (ranges[k].rpm, k.checked_sub(1).and_then(|before| end(before, 1)));
        let apart = |from: Option<f64>, to: Option<f64>| from.zip(to).map_or(f64::INFINITY, |(from, to)| to - from);
        let gaps = [0.1 * apart(low, high), 0.25 * apart(before, low), 0.25 * apart(high, end(k + 1, 0))];
        let least = gaps.into_iter().filter(|gap| *gap > 0.0).fold(f64::INFINITY, f64::min);
        // A unit of the last digit is at most this part of a number.
        let (mut digits, mut unit) = (DIGITS[0], 1e-5);
        while digits < DIGITS[1] && least < unit * high.or(low).unwrap_or(0.0) {
            digits += 1;
            unit *= 0.1;
        }
        [
            low.map_or_else(|| "-inf".to_owned(), |rpm| bound_below(rpm, digits)),
            high.map_or_else(|| "inf".to_owned(), |rpm| bound(rpm, digits)),
        ]
    };
    (0..ranges.len()).map(one).collect()
}

/// At which spins all parts are linearly stable, in words; without ranges all have the type of the nominal part.
fn certainly(up: AxisEnd, slow: SpinType, ranges: &[SpinRangeDocument]) -> String {
    let ranges: Vec<&SpinRangeDocument> = ranges.iter().filter(|range| range.up == up).collect();
    let written = written(&ranges);
    // Of parts with other moments the two pairs of the nominal one do not agree.
    let slow = match slow {
        SpinType::DoubleMinimum => SpinType::Minimum,
        SpinType::DoubleElliptic => SpinType::Elliptic,
        slow => slow,
    };
    let stable = |found: Option<SpinType>| found.is_some_and(SpinType::is_elliptic);
    let mut stretches: Vec<String> = Vec::new();
    if ranges.first().is_some_and(|range| stable(range.from)) {
        stretches.push(format!("up to {} rpm", written[0][0]));
    }
    for (number, _) in ranges.iter().enumerate().filter(|(_, range)| stable(range.to)) {
        let [_, from] = &written[number];
        stretches.push(match written.get(number + 1) {
            Some([to, _]) => format!("from {from} to {to} rpm"),
            None => format!("from {from} rpm on"),
        });
    }
    let (up, word) = (up.word(), slow.word());
    let is_known = ranges.iter().any(|range| range.from.is_some() || range.to.is_some());
    match (ranges.is_empty(), stretches.is_empty()) {
        (true, _) if slow.is_elliptic() => {
            format!("{up} up, each of these parts is {word} at every spin: none is linearly unstable")
        }
        (true, _) => format!("{up} up, each of these parts is {word} at every spin: all are unstable"),
        (false, false) => format!("{up} up, none of these parts is linearly unstable {}", stretches.join(", ")),
        (false, true) if is_known => {
            format!("{up} up, each of these parts is unstable at every spin outside the ranges")
        }
        (false, true) => format!("{up} up, the types of all these parts are known at no spin"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tolerances_are_read_exactly_and_by_name() {
        let texts = |text: &str| tolerance(text).unwrap().0.map(|number| number.text().to_owned());
        assert_eq!(texts("1%"), ["0.01"; 4]);
        assert_eq!(texts("axis=0.5%, across=1%,weight=0.02"), ["0.005", "0.01", "0.01", "0.02"]);
        assert_eq!(texts("moments=1%"), ["0.01", "0.01", "0.01", "0"]);
        for wrong in ["80%", "-1%", "mass=1%", "axis=1%,2%"] {
            assert!(tolerance(wrong).is_err(), "{wrong}");
        }
    }

    fn range(from: Option<SpinType>, to: Option<SpinType>, rpm: [Option<f64>; 2]) -> SpinRangeDocument {
        SpinRangeDocument { up: AxisEnd::Plus, from, to, rpm, between: Vec::new(), most: None, most_rpm: None }
    }

    #[test]
    fn stability_is_told_where_it_is_decided() {
        let text_of = |slow, ranges: &[SpinRangeDocument]| certainly(AxisEnd::Plus, slow, ranges);
        let (first, second) = ([Some(1.0), Some(2.0)], [Some(4.0), Some(8.0)]);
        assert_eq!(
            text_of(SpinType::Elliptic, &[]),
            "+axis up, each of these parts is elliptic at every spin: none is linearly unstable"
        );
        assert_eq!(
            text_of(SpinType::Saddle, &[]),
            "+axis up, each of these parts is saddle at every spin: all are unstable"
        );
        let unstable = [
            range(Some(SpinType::Saddle), Some(SpinType::Complex), first),
            range(Some(SpinType::Complex), Some(SpinType::Saddle), second),
        ];
        let all = "+axis up, each of these parts is unstable at every spin outside the ranges";
        assert_eq!(text_of(SpinType::Saddle, &unstable), all);
        let between = [
            range(None, Some(SpinType::Elliptic), first),
            range(Some(SpinType::Elliptic), Some(SpinType::Saddle), second),
        ];
        assert_eq!(
            text_of(SpinType::Saddle, &between),
            "+axis up, none of these parts is linearly unstable from 2 to 4 rpm"
        );
        let nowhere = "+axis up, the types of all these parts are known at no spin";
        assert_eq!(text_of(SpinType::Elliptic, &[range(None, None, [Some(0.0), None])]), nowhere);
    }
}
