//! `bifdiag scan border`: where the class changes between two bodies.

use bifdiag_body::Number;
use bifdiag_schema::{BorderDocument, BorderEventName, FoundBorderDocument};
use bifdiag_survey::border::{self, BodySegment, BorderOptions};
use bifdiag_survey::{ParameterRange, with_values};

use super::arguments::BorderArguments;
use crate::cli::export::answer;
use crate::cli::failure::Failure;
use crate::cli::terminal::{Report, significant};

/// Significant digits of a place.
const DIGITS: usize = 12;

pub fn run(arguments: &BorderArguments) -> Result<(), Failure> {
    let subject = arguments.body.subject()?;
    if arguments.vary.is_empty() {
        return Err(Failure::input("--vary is missing; give a parameter and two values, such as --vary A3=0.7:0.8"));
    }
    for (place, range) in arguments.vary.iter().enumerate() {
        let parameter = range.parameter;
        if range.steps.is_some() {
            let right = format!("write {parameter}=from:to");
            return Err(Failure::input(format!("--vary: a border is sought between two values; {right}")));
        }
        if arguments.vary[..place].iter().any(|other| other.parameter == parameter) {
            return Err(Failure::input(format!("--vary: {parameter} is given twice")));
        }
    }
    let end = |value: fn(&ParameterRange) -> &Number| {
        let values = arguments.vary.iter().map(|range| (range.parameter, value(range)));
        with_values(&subject.body, values).map_err(|error| Failure::input(format!("--vary: {error}")))
    };
    let options = BorderOptions { accuracy: arguments.accuracy, ..BorderOptions::default() };
    let segment = BodySegment::new(end(|range| &range.from)?, end(|range| &range.to)?);
    let border = border::find(&segment, &options).map_err(|error| Failure::input(format!("--vary: {error}")))?;
    let text = |range: &ParameterRange| format!("{}={}:{}", range.parameter, range.from.text(), range.to.text());
    let vary: Vec<String> = arguments.vary.iter().map(text).collect();
    let command = subject.command("scan border").option("vary", vary.join(","));
    let command = command.option_if("accuracy", bifdiag_documents::accuracy_option(arguments.accuracy));
    let document = bifdiag_documents::border(&border, &segment, &arguments.vary, command);
    answer(arguments.json, &document, || report(&document, &arguments.vary))
}

fn report(document: &BorderDocument, vary: &[ParameterRange]) -> String {
    let mut report = Report::default();
    for border in &document.borders {
        add_border(&mut report, border, vary);
    }
    report.text()
}

fn add_border(report: &mut Report, border: &FoundBorderDocument, vary: &[ParameterRange]) {
    for (value, range) in border.at.iter().zip(vary) {
        if value.error == 0.0 {
            report.line(format!("{} = {}, exactly", range.parameter, value.value));
        } else {
            report.line(format!("{} = {} ± {}", range.parameter, value.value, one_digit(value.error)));
        }
    }
    if !border.reached {
        report.line("the border is not known to 1e-10: f64 alone does not decide the bodies between these two");
    }
    for (end, class) in border.classes.iter().enumerate() {
        let body = border
            .at
            .iter()
            .zip(vary)
            .map(|(value, range)| format!("{} = {}", range.parameter, shortest(value.enclosure[end])));
        report.line(format!("class {class} at {}", body.collect::<Vec<_>>().join(", ")));
    }
    let event = &border.event;
    report.line(format!("event: {}", event.text));
    if let (Some(h), Some(l), true) = (event.h, event.l, border.reached) {
        let [h, l] = [h, l].map(|x| significant(x, DIGITS));
        report.line(format!("  at h = {h}, l = {l}, of the curves {}", event.curves.join(", ")));
    }
    let named = if is_of_the_body(event.kind) { "by the names of their branches " } else { "" };
    for (class, labels) in border.classes.iter().zip([&event.vanish, &event.appear]) {
        if !labels.is_empty() {
            report.line(format!("  {named}only in {class}: {}", each_once(labels).join("; ")));
        }
    }
    report.line("one border between the two ends; others were not searched for");
}

/// All digits, with a power of ten where many zeros would lead.
fn shortest(x: f64) -> String {
    if x != 0.0 && x.abs() < 1e-4 { format!("{x:e}") } else { x.to_string() }
}

/// True where branches are named anew beyond the border, so that one event may have two names.
fn is_of_the_body(kind: BorderEventName) -> bool {
    use BorderEventName::{MomentsEqual, PitchforkAtInfinity, SymmetryBroken, WeightVanishes};
    matches!(kind, MomentsEqual | PitchforkAtInfinity | SymmetryBroken | WeightVanishes)
}

/// Equal labels, which follow one another, as one.
fn each_once(labels: &[String]) -> Vec<String> {
    let once = |same: &[String]| match same.len() {
        1 => same[0].clone(),
        count => format!("{} ({count} times)", same[0]),
    };
    labels.chunk_by(|p, q| p == q).map(once).collect()
}

/// An error with one digit, rounded up.
fn one_digit(error: f64) -> String {
    let nearest = format!("{error:.0e}");
    if nearest.parse::<f64>().is_ok_and(|rounded| rounded >= error) {
        return nearest;
    }
    let next = || {
        let (digit, power) = nearest.split_once('e')?;
        Some(format!("{:.0e}", format!("{}e{power}", digit.parse::<u32>().ok()? + 1).parse::<f64>().ok()?))
    };
    next().unwrap_or(nearest.clone())
}

#[cfg(test)]
mod tests {
    use super::one_digit;

    #[test]
    fn errors_are_rounded_up() {
        let cases = [(1.23e-5, "2e-5"), (1e-5, "1e-5"), (9.2e-7, "1e-6"), (1.6e-11, "2e-11"), (2.49e-300, "3e-300")];
        for (error, text) in cases {
            assert_eq!(one_digit(error), text);
        }
    }
}
