//! What the terminal shows of an atlas.

use std::path::PathBuf;

use bifdiag_diagram::atlas::Atlas;
use bifdiag_documents::Subject;
use bifdiag_documents::words::{counted, most_equilibria};
use bifdiag_exact::{Accuracy, Solver};
use bifdiag_numbers::vector::norm;
use bifdiag_schema::{
    AtlasDocument, ComponentDocument, EventDocument, EventKind, RegionDocument, SampleDocument, StabilityChangeDocument,
};

use crate::cli::failure::Failure;
use crate::cli::input::{head, integrable};
use crate::cli::terminal::{Report, Table, all_apart, bound, significant, told_apart};

/// Significant digits of a place in the plane.
const DIGITS: usize = 8;

/// What is said where the sample of a region, in doubles, lies outside it.
pub const STRAY: &str = "~ rounded to doubles, the sample lies outside its region, which is too narrow for them there";

/// What is said where that is not decided.
const DOUBTFUL: &str = "~ the region is so narrow there that its sample, in doubles, may lie outside it";

/// Nothing is drawn at such a sample under the name of the region.
pub fn stray_sample(id: &str) -> Failure {
    Failure::input(format!(
        "--region {id}: rounded to doubles, its sample lies outside it, because the region is too narrow for them \
        there; give --h and --l, or another region"
    ))
}

/// Regions whose samples, in doubles, lie elsewhere. With `--accuracy fast`, whose regions are numbered differently, all
/// whose samples may lie elsewhere.
pub fn strays(subject: &Subject, document: &AtlasDocument) -> Vec<String> {
    let is_narrow = |region: &&RegionDocument| region.sample.margin.h <= region.sample.margin.error_bound;
    let solver = Solver::new(subject.body.clone(), Accuracy::Exact);
    let is_outside = |region: &RegionDocument| {
        region.id.parse().is_ok_and(|id| solver.is_outside(id, [region.sample.h, region.sample.l]))
    };
    let narrow = document.regions.iter().filter(is_narrow);
    let strays = narrow.filter(|region| document.accuracy == Accuracy::Fast || is_outside(region));
    strays.map(|region| region.id.clone()).collect()
}

/// The table of regions fits a terminal of this width.
const TABLE_WIDTH: usize = 100;

/// Everything that the terminal shows.
pub fn text(subject: &Subject, atlas: &Atlas, document: &AtlasDocument, written: &[PathBuf]) -> String {
    let mut report = Report::default();
    head(subject, &mut report);
    integrable(&subject.body, &mut report);
    report.line("");
    if document.regions.is_empty() && document.summary.undecided.is_empty() {
        report.line("no region reaches into the window: all points inside it are forbidden; there is no picture");
    } else {
        let strays = strays(subject, document);
        report.line(region_table(subject, document, &strays));
        if !strays.is_empty() {
            report.line(if document.accuracy == Accuracy::Fast { DOUBTFUL } else { STRAY });
        }
        if document.regions.iter().any(|region| region.clipped) {
            report.line("* cut by the window: width and l-range are those of the whole region");
        }
    }
    report.line("");
    if let Some(table) = event_table(&document.events, &bifdiag_documents::atlas::events(atlas)) {
        report.line(table);
        report.line("");
    }
    if let Some(table) = stability_table(&document.stability_changes) {
        report.line(table);
        report.line("");
    }
    let summary = &document.summary;
    // In a window there may be fewer of them.
    let most = if document.window.is_none() { format!(", {}", most_equilibria(document)) } else { String::new() };
    let (regions, events) = (counted(summary.regions, "region", "regions"), counted(summary.events, "event", "events"));
    report.line(format!("{regions}, {events}{most}"));
    match (summary.complete, document.window) {
        (true, _) => {}
        (false, Some(_)) => report.line("only what lies in the window is listed, not the whole half-plane l > 0"),
        (false, None) => report.line("the half-plane l > 0 is not completely known"),
    }
    if let Some(certificate) = &document.certificate {
        let topology = if summary.undecided.is_empty() { " and the topology of each" } else { "" };
        report.line(format!(
            "proved: the number of regions{topology} ({} bits sufficed); check with bifdiag verify",
            certificate.bits
        ));
    }
    if summary.undecided.is_empty() {
        report.line("nothing was left undecided");
    }
    for undecided in &summary.undecided {
        let curves = &undecided.curves;
        report.line(format!(
            "undecided: {} near l = {}, h = {}{}",
            undecided.what,
            significant(undecided.l, DIGITS),
            significant(undecided.h, DIGITS),
            if curves.is_empty() { String::new() } else { format!(" ({})", curves.join(", ")) },
        ));
    }
    report.written(written);
    report.text()
}

/// A bound on the error of the width of a region in h.
pub fn width_error(subject: &Subject, width: f64) -> f64 {
    1e-6 * width + 4e-9 * norm(subject.body.center_f64())
}

/// The table of regions, with as many digits as fit.
fn region_table(subject: &Subject, document: &AtlasDocument, strays: &[String]) -> String {
    let width = |region: &RegionDocument, digits| {
        let Some(width) = document.h_width(&region.id) else { return "inf".to_owned() };
        let error = width_error(subject, width);
        if width > error { significant(width, digits) } else { format!("<{}", bound(width + error, 1)) }
    };
    let sample = |region: &RegionDocument, digits| {
        let [h, l] = inner_sample(subject, &region.sample, digits);
        let sample = format!("({h}, {l})");
        if strays.contains(&region.id) { format!("~{sample}") } else { sample }
    };
    table_of(&document.regions, &sample, &width)
}

fn table_of(
    regions: &[RegionDocument],
    sample: &dyn Fn(&RegionDocument, usize) -> String,
    width: &dyn Fn(&RegionDocument, usize) -> String,
) -> String {
    let with = |digits, sample: &dyn Fn(&RegionDocument, usize) -> String| region_rows(regions, width, sample, digits);
    let short = |region: &RegionDocument, digits| short_sample(&region.sample, digits);
    let fits = |digits: &usize| with(*digits, &short).width() <= TABLE_WIDTH;
    let digits = [6, 5, 4, 3].into_iter().find(fits).unwrap_or(2);
    with(digits, sample).text()
}

/// A sample with this many digits.
fn short_sample(SampleDocument { h, l, .. }: &SampleDocument, digits: usize) -> String {
    format!("({}, {})", significant(*h, digits), significant(*l, digits))
}

/// h and l of a sample with this many digits, or with as many as leave it in its region: the slope of curves is
/// l/J ≤ l/min A. Where none is seen to do so, the decimals that the doubles denote, as those of [`strays`].
pub fn inner_sample(subject: &Subject, SampleDocument { h, l, margin }: &SampleDocument, digits: usize) -> [String; 2] {
    let least_moment = subject.body.moments_f64().into_iter().fold(f64::INFINITY, f64::min);
    let written = |digits: usize| [h, l].map(|x| significant(*x, digits));
    let is_inside = |digits: &usize| {
        let [h_error, l_error] = [(h, 0), (l, 1)]
            .map(|(x, k)| written(*digits)[k].parse::<f64>().map_or(f64::INFINITY, |rounded| (rounded - x).abs()));
        h_error + l_error * (l.abs() + l_error) / least_moment < margin.h
    };
    (digits..17).find(is_inside).map_or_else(|| [*h, *l].map(shortest), written)
}

/// The shortest decimal of a double.
fn shortest(x: f64) -> String {
    let written = |digits| significant(x, digits);
    (1..17).map(written).find(|text| text.parse() == Ok(x)).unwrap_or_else(|| written(17))
}

fn region_rows(
    regions: &[RegionDocument],
    width: &dyn Fn(&RegionDocument, usize) -> String,
    sample: &dyn Fn(&RegionDocument, usize) -> String,
    digits: usize,
) -> Table {
    let mut table = Table::new(&["id", "signature", "U", "E", "P", "genus", "sample (h, l)", "width", "l-range"]);
    for region in regions {
        let column = |cell: &dyn Fn(&ComponentDocument) -> String| {
            region.components.iter().map(cell).collect::<Vec<_>>().join("\n")
        };
        let number = |x: Option<f64>, missing: &str| x.map_or(missing.to_owned(), |x| significant(x, digits));
        let [from, to] = region.l_range;
        table.row([
            if region.clipped { format!("{}*", region.id) } else { region.id.clone() },
            wrapped_signature(region.signature.as_deref().unwrap_or("-")),
            column(&|component| component.accessible_region.clone()),
            column(&|component| component.energy_surface.clone()),
            column(&|component| component.section.clone().unwrap_or_else(|| "-".to_owned())),
            column(&|component| component.genus.map_or_else(|| "-".to_owned(), |genus| genus.to_string())),
            sample(region, digits),
            width(region, digits),
            match [from, to] {
                [Some(from), Some(to)] => told_apart([from, to], digits).join(".."),
                _ => format!("{}..{}", number(from, "?"), number(to, "inf")),
            },
        ]);
    }
    table
}

/// A signature on lines of at most twelve characters, broken at its plus signs.
fn wrapped_signature(signature: &str) -> String {
    const WIDTH: usize = 12;
    let mut lines: Vec<String> = Vec::new();
    for piece in signature.split_inclusive('+') {
        match lines.last_mut() {
            Some(line) if line.len() + piece.len() <= WIDTH => line.push_str(piece),
            _ => lines.push(piece.to_owned()),
        }
    }
    lines.join("\n")
}

/// Cusps, pitchforks and crossings by rising l, each with its id among all of the body; `None` without events.
fn event_table(events: &[EventDocument], all: &[EventDocument]) -> Option<String> {
    let mut table = Table::new(&["event", "kind", "l", "h", "curves"]);
    let id = |event: &EventDocument| {
        let is_it = |other: &EventDocument| (other.l, other.h, &other.curves) == (event.l, event.h, &event.curves);
        all.iter().position(is_it).map_or_else(String::new, |place| format!("E{}", place + 1))
    };
    for (number, event) in events.iter().enumerate() {
        let digits = event_digits(events, number);
        let kind = match event.kind {
            EventKind::Cusp => "cusp",
            EventKind::Pitchfork => "pitchfork",
            EventKind::Crossing => "crossing",
        };
        table.row([
            id(event),
            kind.to_owned(),
            significant(event.l, digits),
            significant(event.h, digits),
            event.curves.join(", "),
        ]);
    }
    (!events.is_empty()).then(|| table.text())
}

/// As many digits as tell an event from those before and after it, by l or by h.
fn event_digits(events: &[EventDocument], number: usize) -> usize {
    let event = &events[number];
    let written = |event: &EventDocument, digits| [event.l, event.h].map(|x| significant(x, digits));
    let neighbours = [number.checked_sub(1), Some(number + 1)].into_iter().flatten();
    let others: Vec<&EventDocument> = neighbours
        .filter_map(|other| events.get(other))
        .filter(|other| (other.l, other.h) != (event.l, event.h))
        .collect();
    let is_apart = |digits: &usize| others.iter().all(|other| written(other, *digits) != written(event, *digits));
    (DIGITS..17).find(is_apart).unwrap_or(17)
}

/// Where the linear type changes along a branch; `None` without changes.
fn stability_table(changes: &[StabilityChangeDocument]) -> Option<String> {
    let mut table = Table::new(&["l", "h", "change of stability", "curve", "from", "to"]);
    let momenta: Vec<f64> = changes.iter().map(|change| change.l).collect();
    for (change, l) in changes.iter().zip(all_apart(&momenta, DIGITS)) {
        table.row([
            l,
            significant(change.h, DIGITS),
            change.kind.word().to_owned(),
            change.onto.as_ref().map_or(change.curve.clone(), |onto| format!("{}, {onto}", change.curve)),
            change.from.word().to_owned(),
            change.to.word().to_owned(),
        ]);
    }
    (!changes.is_empty()).then(|| table.text())
}

#[cfg(test)]
mod tests {
    use bifdiag_diagram::topology::{Component, Poles, signature};
    use bifdiag_schema::MarginDocument;

    use super::*;

    fn region(id: &str, components: &[Component], sample: [f64; 2]) -> RegionDocument {
        let margin = MarginDocument { h: 1e20, nearest: "P+".to_owned(), error_bound: 1e-15 };
        RegionDocument {
            id: id.to_owned(),
            sample: SampleDocument { h: sample[0], l: sample[1], margin },
            components: bifdiag_documents::components(components),
            signature: signature(components),
            bounded: true,
            l_range: [Some(sample[1] / 3.0), Some(sample[1] / 0.7)],
            boundary: Vec::new(),
            neighbours: Vec::new(),
            cells: Vec::new(),
            clipped: false,
        }
    }

    #[test]
    fn the_table_fits_whatever_the_regions_are() {
        let poles = |plus, minus| Some(Poles { plus, minus });
        let component = |boundary_circles, poles| Component { boundary_circles, poles };
        let many = [component(1, poles(false, false)); 5];
        let regions = [
            region("R1", &[component(0, poles(true, true))], [-1.0 / 3.0, 1e-6 / 3.0]),
            region("R128", &many, [1.0 / 3.0 * 1e16, 1e8 / 3.0]),
            region("R3", &[component(3, poles(true, false)), component(1, poles(false, true))], [-1e-7 / 3.0, 0.1]),
            region("R4", &[component(2, None)], [1.0, 2.0]),
        ];
        let sample = |region: &RegionDocument, digits| short_sample(&region.sample, digits);
        let text = table_of(&regions, &sample, &|region, digits| significant(region.sample.h / 7.0, digits));
        assert!(text.lines().all(|line| line.chars().count() <= TABLE_WIDTH), "{text}");
        for name in ["S2+S2+S2+S2+", "(S1xS2)#(S1xS2)", "M3", "RP3"] {
            assert!(text.contains(name), "{name} is missing in\n{text}");
        }
    }

    #[test]
    fn signatures_break_at_plus_signs() {
        assert_eq!(wrapped_signature("S2+T2"), "S2+T2");
        assert_eq!(wrapped_signature("S2+S2+T2+T2+M2"), "S2+S2+T2+T2+\nM2");
    }
}
