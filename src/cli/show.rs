//! `bifdiag show`: a region, a curve or an event of a body in words.

use bifdiag_diagram::arrangement::RegionId;
use bifdiag_diagram::atlas::Atlas;
use bifdiag_documents::{DocumentOptions, Drawn, Subject, words};
use bifdiag_exact::Accuracy;
use bifdiag_schema::{
    AtlasDocument, ComponentDocument, CurveDocument, CurveKind, EventDocument, EventKind, Reason, RegionDocument,
};
use clap::Args;

use super::atlas::{STRAY, inner_sample, strays, width_error};
use super::explain::explanation;
use super::failure::{Failure, failed};
use super::input::{BodyArguments, head, values};
use super::terminal::{Report, all_apart, bound, print, significant, told_apart};

pub const EXAMPLES: &str = "\
Examples:
  bifdiag show R5 --body paper
  bifdiag show G2.1 --A 2,1.1,1 --r 0.94868,0,0.61623
  bifdiag show E3 --body katok:6
  bifdiag show S3 --body katok:6
  bifdiag show M2 --body paper

The ids are those of `bifdiag atlas`: regions R1, R2, …, curves such as G0.1 or P+, events E1, E2, … by rising l. The \
name of a branch such as G0 shows each of its curves; a surface or a type such as M2, S2+T2 or k2n1 shows each region \
that has it. Surfaces and types are explained without a body, too.";

/// `bifdiag show`.
#[derive(Debug, Args)]
pub struct ShowArguments {
    /// A region, a curve, a branch, an event, or a surface
    #[arg(value_name = "ID")]
    pub id: String,
    #[command(flatten)]
    pub body: BodyArguments,
}

/// Significant digits.
const DIGITS: usize = 6;

pub fn run(arguments: &ShowArguments) -> Result<(), Failure> {
    let Some(subject) = arguments.body.optional_subject()? else {
        // What an id means without its body is known of a surface alone.
        let is_surface = is_surface(&arguments.id);
        return if is_surface { print(explanation(&arguments.id)?) } else { arguments.body.subject().map(drop) };
    };
    let atlas = bifdiag_exact::atlas(&subject.body, Accuracy::Exact).map_err(failed("the atlas could not be made"))?;
    let options = DocumentOptions { drawing: Drawn::Nothing, ..DocumentOptions::default() };
    let mut document = bifdiag_documents::atlas::document(&atlas, &options);
    bifdiag_documents::atlas::attach_verdict_changes(&mut document, &atlas);
    let mut report = Report::default();
    head(&subject, &mut report);
    report.line("");
    let id = values::id(&arguments.id);
    let branch = |curve: &&CurveDocument| curve.id.rsplit_once('.').is_some_and(|(branch, _)| branch == id);
    let event = id.strip_prefix('E').and_then(|number| number.parse::<usize>().ok()?.checked_sub(1));
    if let Some(region) = document.regions.iter().find(|region| region.id == id) {
        let is_stray = strays(&subject, &document).contains(&region.id);
        show_region(&mut report, &subject, &atlas, &document, (region, is_stray));
        if is_stray {
            report.line("");
            report.line(STRAY);
        }
    } else if let Some(curve) = document.curves.iter().find(|curve| curve.id == id) {
        show_curve(&mut report, &atlas, &document, curve);
    } else if let Some(event) = event.and_then(|place| document.events.get(place)) {
        show_event(&mut report, &document, event);
    } else if document.curves.iter().any(|curve| branch(&curve)) {
        for (place, curve) in document.curves.iter().filter(branch).enumerate() {
            if place > 0 {
                report.line("");
            }
            show_curve(&mut report, &atlas, &document, curve);
        }
        // S2 is the name of a branch and of a surface.
        let found = if is_surface(&id) { regions_with(&document, &id) } else { Vec::new() };
        if !found.is_empty() {
            report.line("");
            show_surface(&mut report, &subject, &document, (&id, &found));
        }
    } else if id == "L=0" && subject.body.is_euler() {
        // Without weight every curve begins at h = l = 0.
        let regions: Vec<&str> = document.regions.iter().map(|region| region.id.as_str()).collect();
        report.line("l=0: at rest every orientation is an equilibrium, and h = 0");
        report.line(format!("at h = l = 0 the forbidden region and {} meet", regions.join(", ")));
    } else if is_surface(&id) {
        show_surface(&mut report, &subject, &document, (&id, &regions_with(&document, &id)));
    } else {
        return Err(unknown(&arguments.id, &document));
    }
    print(report.text())
}

fn number(text: &str) -> bool {
    !text.is_empty() && text.bytes().all(|digit| digit.is_ascii_digit())
}

/// True for a type such as k2n1.
fn is_type(id: &str) -> bool {
    let upper = id.to_ascii_uppercase();
    let parts = upper.strip_prefix('K').and_then(|rest| rest.split_once('N'));
    parts.is_some_and(|(circles, poles)| number(circles) && number(poles))
}

/// True for what may name a component of U, E or P, or all sections of a region.
fn is_surface(id: &str) -> bool {
    let upper = id.to_ascii_uppercase();
    let holed = |text: &str| text.strip_prefix("S2-").and_then(|rest| rest.strip_suffix("D2")).is_some_and(number);
    let summed = |text: &str| text.strip_prefix('#').and_then(|rest| rest.strip_suffix("(S1XS2)")).is_some_and(number);
    let of_genus = |text: &str| text.strip_prefix('M').is_some_and(number);
    let named = |text: &str| ["S2", "D2", "T2", "S3", "RP3", "S1XS2", "(S1XS2)#(S1XS2)"].contains(&text);
    let one = |text: &str| named(text) || holed(text) || summed(text) || of_genus(text) || is_type(text);
    // A sum is of types alone, or of surfaces alone.
    let parts = || upper.split('+');
    one(&upper) || (parts().all(one) && (parts().all(is_type) || !parts().any(is_type)))
}

/// The name that the program prints for a surface or for sections, whatever was typed.
fn printed_name(typed: &str) -> String {
    let one = |name: &str| match &*name.to_ascii_uppercase() {
        _ if is_type(name) => name.to_ascii_lowercase(),
        "M0" | "S2-0D2" => "S2".to_owned(),
        "M1" => "T2".to_owned(),
        "S2-1D2" => "D2".to_owned(),
        "#0(S1XS2)" => "S3".to_owned(),
        "#1(S1XS2)" => "S1xS2".to_owned(),
        "#2(S1XS2)" => "(S1xS2)#(S1xS2)".to_owned(),
        other => other.replace('X', "x"),
    };
    typed.split('+').map(one).collect::<Vec<_>>().join("+")
}

/// Such as `k2n1`: the boundary circles and the poles of a component.
fn kind(component: &ComponentDocument) -> String {
    // Without weight there are no poles, and a scan counts them so.
    let poles = component.poles.as_ref().map_or(0, Vec::len);
    format!("k{}n{poles}", component.boundary_circles)
}

/// The regions that have a component or a signature of this name.
fn regions_with<'a>(document: &'a AtlasDocument, name: &str) -> Vec<&'a RegionDocument> {
    let name = &printed_name(name);
    let is = |text: &str| text.eq_ignore_ascii_case(name);
    let sorted = |text: &str| {
        let mut parts: Vec<String> = text.split('+').map(str::to_ascii_uppercase).collect();
        parts.sort_unstable();
        parts
    };
    let has = |region: &&RegionDocument| {
        let component = |component: &ComponentDocument| {
            let section = component.section.as_deref().is_some_and(is);
            is(&component.accessible_region) || is(&component.energy_surface) || is(&kind(component)) || section
        };
        let sum =
            |part: fn(&ComponentDocument) -> String| region.components.iter().map(part).collect::<Vec<_>>().join("+");
        let sums =
            [sum(|of| of.accessible_region.clone()), sum(|of| of.energy_surface.clone()), sum(kind), region.shown()];
        sums.iter().any(|sum| sorted(sum) == sorted(name)) || region.components.iter().any(component)
    };
    document.regions.iter().filter(has).collect()
}

/// The regions that were found under a name in words.
fn show_surface(
    report: &mut Report,
    subject: &Subject,
    document: &AtlasDocument,
    (name, found): (&str, &[&RegionDocument]),
) {
    let name = printed_name(name);
    report.line(match found.len() {
        0 => format!("no region of this body has {name}"),
        1 => format!("{name} occurs in the region {}", found[0].id),
        _ => {
            let ids: Vec<&str> = found.iter().map(|region| region.id.as_str()).collect();
            format!("{name} occurs in the regions {}", ids.join(", "))
        }
    });
    let strays = strays(subject, document);
    for region in found {
        report.line("");
        let what = if region.signature.is_some() { "sections" } else { "U =" };
        report.line(format!("region {}, {what} {}", region.id, region.shown()));
        let [h, l] = inner_sample(subject, &region.sample, DIGITS);
        let mark = if strays.contains(&region.id) { "~" } else { "" };
        report.line(format!("  sample: {mark}h = {h}, l = {l}"));
        for line in region.components.iter().flat_map(words::component) {
            report.line(line);
        }
    }
    if found.iter().any(|region| strays.contains(&region.id)) {
        report.line("");
        report.line(STRAY);
    }
}

fn unknown(id: &str, document: &AtlasDocument) -> Failure {
    let curves: Vec<&str> = document.curves.iter().map(|curve| curve.id.as_str()).collect();
    let up_to = |what: &str, letter: &str, count: usize| match count {
        0 => format!("no {what}s"),
        1 => format!("the {what} {letter}1"),
        2 => format!("the {what}s {letter}1 and {letter}2"),
        _ => format!("the {what}s {letter}1 to {letter}{count}"),
    };
    let regions = up_to("region", "R", document.regions.len());
    let curves = format!("the curve{} {}", if curves.len() == 1 { "" } else { "s" }, curves.join(", "));
    let events = up_to("event", "E", document.events.len());
    let one = if id.contains([',', ' ']) { "give one ID" } else { "this body has nothing of that name" };
    Failure::input(format!("ID {id}: {one}; it has {regions}, {curves} and {events}"))
}

fn range([from, to]: [Option<f64>; 2]) -> String {
    let from = from.unwrap_or(0.0);
    let Some(to) = to else { return format!("l > {}", significant(from, DIGITS)) };
    if from >= to {
        return format!("l = {from} alone, as far as doubles tell");
    }
    let [from, to] = told_apart([from, to], DIGITS);
    format!("{from} < l < {to}")
}

fn show_region(
    report: &mut Report,
    subject: &Subject,
    atlas: &Atlas,
    document: &AtlasDocument,
    (region, is_stray): (&RegionDocument, bool),
) {
    let signature = region.signature.as_ref().map_or_else(String::new, |signature| format!(", sections {signature}"));
    report.line(format!("region {}{signature}", region.id));
    let width = region.id.parse().ok().and_then(|id: RegionId| atlas.h_widths()[id]);
    let width = width.map_or_else(
        || "unbounded in h".to_owned(),
        |width| format!("at most {} wide in h", bound(width + width_error(subject, width), DIGITS - 1)),
    );
    report.line(format!("  {}, {width}", range(region.l_range)));
    let margin = &region.sample.margin;
    let [h, l] = inner_sample(subject, &region.sample, DIGITS);
    let mark = if is_stray { "~" } else { "" };
    let distance = if margin.h > margin.error_bound {
        significant(margin.h, 3)
    } else {
        format!("at most {}", bound(margin.h + margin.error_bound, 1))
    };
    report.line(format!("  sample: {mark}h = {h}, l = {l} ({distance} in h to {})", margin.nearest));
    report.line("");
    for component in &region.components {
        for line in words::component(component) {
            report.line(line);
        }
    }
    report.line("");
    report.line("its boundaries:");
    for neighbour in &region.neighbours {
        let curve = document.curves.iter().find(|curve| curve.id == neighbour.curve);
        let other = document.regions.iter().find(|other| Some(&other.id) == neighbour.region.as_ref());
        let Some(curve) = curve else { continue };
        let upwards = other.is_some_and(|other| words::lies_below(atlas, region, other, &curve.id));
        let (name, h) = match (other, upwards) {
            (Some(other), true) => (other.id.as_str(), "rising"),
            (Some(other), false) => (other.id.as_str(), "falling"),
            (None, _) => ("the forbidden region", "falling"),
        };
        report.line(format!("  {h} h, across {} ({}), to {name}:", curve.id, words::motion(curve)));
        let to = other.map_or(&[][..], |other| &other.components);
        report.line(format!("    {}", words::crossing(curve, &region.components, to, upwards)));
    }
}

fn show_curve(report: &mut Report, atlas: &Atlas, document: &AtlasDocument, curve: &CurveDocument) {
    report.line(format!("curve {}: {}", curve.id, words::motion(curve)));
    report.line(format!("  {}", range(curve.l_range)));
    if !curve.coincides_with.is_empty() {
        report.line(format!("  at the same (h, l): {}", curve.coincides_with.join(", ")));
    }
    for span in &curve.stability {
        report.line(format!(
            "  {}: {}, {}; with friction {}",
            range([Some(span.l_from), span.l_to]),
            span.stability.word(),
            words::verdict(&span.nonlinear),
            words::with_friction(&span.friction)
        ));
    }
    isolated(report, document, curve);
    report.line("");
    let parts = |region: &RegionDocument| region.neighbours.iter().any(|neighbour| neighbour.curve == curve.id);
    if !document.regions.iter().any(parts) {
        let same = match &curve.coincides_with[..] {
            [] => String::new(),
            ids => format!("; show {} says what it separates", ids.join(" or ")),
        };
        report.line(format!("no region is listed as a neighbour across it{same}"));
        return;
    }
    let mut changes: Vec<String> = Vec::new();
    for below in &document.regions {
        for neighbour in below.neighbours.iter().filter(|neighbour| neighbour.curve == curve.id) {
            let above = document.regions.iter().find(|other| Some(&other.id) == neighbour.region.as_ref());
            let (from, from_components, above) = match above {
                Some(above) if words::lies_below(atlas, below, above, &curve.id) => {
                    (below.id.as_str(), &below.components[..], above)
                }
                // Below lies the forbidden region.
                None => ("the forbidden region", &[][..], below),
                Some(_) => continue,
            };
            let change = words::crossing(curve, from_components, &above.components, true);
            changes.push(format!("  from {from} to {}: {change}", above.id));
        }
    }
    report.line("with rising h:");
    for change in changes {
        report.line(change);
    }
}

/// The points of a curve at which a hypothesis of Arnold's theorem fails: the verdict beside them is not theirs.
fn isolated(report: &mut Report, document: &AtlasDocument, curve: &CurveDocument) {
    let changes: Vec<_> = document.verdict_changes.iter().flatten().filter(|change| change.curve == curve.id).collect();
    let momenta = all_apart(&changes.iter().map(|change| change.l).collect::<Vec<_>>(), DIGITS);
    for (change, l) in changes.into_iter().zip(momenta) {
        let exception = words::exception(change.kind, change.verdict, change.why);
        report.line(format!("  at l = {l} alone {exception}"));
    }
    let by_arnold = curve.stability.iter().any(|span| span.nonlinear.why == Reason::Arnold);
    if by_arnold && document.verdict_changes.is_none() {
        report.line(
            "  Arnold's theorem: its usual conditions fail at isolated l, of which not all were found: none is listed",
        );
    }
}

fn show_event(report: &mut Report, document: &AtlasDocument, event: &EventDocument) {
    let curves = || event.curves.iter().filter_map(|id| document.curves.iter().find(|curve| curve.id == *id));
    let of_circles = curves().any(|curve| curve.kind == CurveKind::Circle);
    let of_pairs = curves().all(|curve| curve.kind == CurveKind::Pair);
    let what = match (event.kind, of_circles) {
        (EventKind::Cusp, false) if of_pairs => "cusp: two symmetric pairs of relative equilibria meet and vanish",
        (EventKind::Cusp, false) => "cusp: two relative equilibria meet and vanish",
        (EventKind::Cusp, true) => "cusp: two circles of relative equilibria meet and vanish",
        (EventKind::Pitchfork, false) => "pitchfork: a symmetric pair leaves a curve",
        (EventKind::Pitchfork, true) => "pitchfork: a circle of relative equilibria leaves a curve",
        (EventKind::Crossing, _) => "crossing: two curves have the same energy at different points of the sphere",
    };
    report.line(what);
    // The rounding of the text is part of its error.
    let value = |x: f64, error: f64| {
        let text = significant(x, 16);
        let rounding = text.parse::<f64>().map_or(0.0, |written| (written - x).abs());
        format!("{text} (± {})", bound(error + rounding, 1))
    };
    report.line(format!("  h = {}, l = {}", value(event.h, event.h_error), value(event.l, event.l_error)));
    for curve in curves() {
        report.line(format!("  {}: {}", curve.id, words::motion(curve)));
    }
    let here = whole_point(document, event);
    let mut near: Vec<&str> = document
        .regions
        .iter()
        .filter(|region| words::touches(region, &here))
        .map(|region| region.id.as_str())
        .collect();
    if words::touches_forbidden(&document.regions, &here) {
        near.insert(0, "the forbidden region");
    }
    report.line(format!("  regions that meet there: {}", near.join(", ")));
}

/// Where several events fall on one point, as far as their errors tell, the curves of all of them do: the event with all
/// curves, and with an error of l that covers them.
fn whole_point(document: &AtlasDocument, event: &EventDocument) -> EventDocument {
    let mut whole = EventDocument { curves: Vec::new(), ..event.clone() };
    for other in &document.events {
        let l_error = event.l_error + other.l_error;
        if (event.h - other.h).abs() <= event.h_error + other.h_error && (event.l - other.l).abs() <= l_error {
            whole.curves.extend(other.curves.iter().cloned());
            whole.l_error = whole.l_error.max(l_error);
        }
    }
    whole
}
