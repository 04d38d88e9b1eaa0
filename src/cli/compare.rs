//! `bifdiag compare`: which regions, events and changes of stability one body has and another lacks.

use std::path::Path;

use bifdiag_body::{Body, Preset};
use bifdiag_diagram::class::Class;
use bifdiag_documents::words::{counted, most_equilibria};
use bifdiag_documents::{Compared, DocumentOptions, Drawn};
use bifdiag_exact::Accuracy;
use bifdiag_schema::{AtlasDocument, ComparedRegionsDocument, ComparisonDocument, EventKind, SCHEMA_VERSION};
use bifdiag_survey::border::BorderOptions;
use bifdiag_survey::path::{Oriented, borders_between, in_near_axes};
use clap::Args;

use super::export::answer;
use super::failure::{Failure, failed};
use super::input::read;
use super::terminal::{Report, Table, Timings, all_apart};

pub const COMPARE_EXAMPLES: &str = "\
Examples:
  bifdiag compare paper katok:1
  bifdiag compare paper \"A=2,1.1,1;r=0.94868,0.01,0.61623\"
  bifdiag compare kovalevskaya lagrange --json

A body is a name (`bifdiag bodies` lists them), A=A1,A2,A3;r=r1,r2,r3 (& may replace ;), or an atlas.json (-: stdin). \
Branches are named in axes by rising moments, so that those of the two bodies can be compared. The path is straight \
in A and r, with A1 ≤ A2 ≤ A3, the sum of A = 2, r_i ≥ 0 and the largest r_i = 1 unless r = 0; where moments are equal, r is \
turned among their axes to be as close to that of the other body as exchanging the axes allows, and for a ball into \
the direction of the other r.";

/// `bifdiag compare`.
#[derive(Debug, Args)]
pub struct CompareArguments {
    /// The first body: a name, A=…;r=…, or an atlas.json, of which only the body is read
    #[arg(value_name = "BODY")]
    pub first: String,
    /// The second body
    #[arg(value_name = "BODY")]
    pub second: String,
    /// Print the comparison as JSON
    #[arg(long, help_heading = "Output")]
    pub json: bool,
}

/// A body with what is compared.
struct Diagram<'a> {
    name: &'a str,
    atlas: AtlasDocument,
    class: Option<Class>,
    standard: Oriented,
    standard_atlas: AtlasDocument,
}

pub fn run(arguments: &CompareArguments, timings: &Timings) -> Result<(), Failure> {
    let names = [&arguments.first, &arguments.second];
    let [first, second] = [body(names[0])?, body(names[1])?];
    let [standard, other] = in_near_axes(&first, &second);
    let [first, second] = timings.stage("atlases", || {
        Ok::<_, Failure>([Diagram::of(names[0], &first, standard)?, Diagram::of(names[1], &second, other)?])
    })?;
    let borders = timings
        .stage("path", || borders_between(&first.standard.body, &second.standard.body, &BorderOptions::default()));
    let document = bifdiag_documents::comparison([first.compared(), second.compared()], &borders);
    answer(arguments.json, &document, || report(&document, [&first, &second]))
}

impl<'a> Diagram<'a> {
    fn of(name: &'a str, body: &Body, standard: Oriented) -> Result<Self, Failure> {
        let atlas = |body: &Body| {
            let failed = failed(format!("{name}: the atlas could not be made"));
            bifdiag_exact::atlas(body, Accuracy::Exact).map_err(failed)
        };
        let options = DocumentOptions { drawing: Drawn::Nothing, ..DocumentOptions::default() };
        let given = atlas(body)?;
        Ok(Self {
            name,
            class: Class::of(&given).ok(),
            atlas: bifdiag_documents::atlas::document(&given, &options),
            standard_atlas: bifdiag_documents::atlas::document(&atlas(&standard.body)?, &options),
            standard,
        })
    }

    fn compared(&self) -> Compared<'_> {
        Compared {
            atlas: &self.atlas,
            class: self.class.as_ref(),
            standard: &self.standard,
            standard_atlas: &self.standard_atlas,
        }
    }
}

/// The body that a text names.
fn body(text: &str) -> Result<Body, Failure> {
    if let Some(preset) = Preset::find(text) {
        return Ok(preset.body());
    }
    let wrong = |why: &dyn std::fmt::Display| Failure::input(format!("BODY {text}: {why}"));
    if let Some((moments, center)) = text.strip_prefix("A=").and_then(|rest| rest.split_once([';', '&'])) {
        let center = center.trim().strip_prefix("r=").ok_or_else(|| {
            wrong(&"the centre of mass must follow A; write A=2,1.1,1;r=0.94868,0,0.61623, in quotation marks")
        })?;
        let list = |text: &str| text.split(',').map(|part| part.trim().to_owned()).collect::<Vec<_>>();
        return Body::parse(&list(moments), &list(center)).map_err(|error| wrong(&error));
    }
    let is_file = text == "-" || Path::new(text).extension().is_some_and(|ending| ending.eq_ignore_ascii_case("json"));
    if !is_file {
        return Err(wrong(
            &"it is not a named body (`bifdiag bodies` lists them); give a name, \"A=2,1.1,1;r=0.94868,0,0.61623\" or \
            an atlas.json",
        ));
    }
    let file = read(Path::new(text))
        .map_err(|error| wrong(&format!("{error}; give an atlas.json that can be read, or - for stdin")))?;
    let atlas = bifdiag_documents::reading::atlas(&file, text)
        .map_err(|error| wrong(&format!("it is not an atlas of version {SCHEMA_VERSION}: {error}")))?;
    Body::parse(&atlas.body.given.moments, &atlas.body.given.center).map_err(|error| wrong(&error))
}

/// In words, with the bodies named as they were asked for.
fn report(document: &ComparisonDocument, diagrams: [&Diagram<'_>; 2]) -> String {
    let mut report = Report::default();
    for ((number, diagram), body) in ["1", "2"].into_iter().zip(diagrams).zip(&document.bodies) {
        let Diagram { name, atlas, .. } = diagram;
        let class = body.class.as_ref().map_or("class undecided".to_owned(), |class| format!("class {class}"));
        report.line(format!(
            "{number}: {name}, {class}, {}, {}, {}",
            counted(body.regions, "region", "regions"),
            counted(body.events, "event", "events"),
            most_equilibria(atlas),
        ));
    }
    if document.same_class == Some(true) {
        report.line(
            "both belong to the same class: their regions, curves and events correspond; lengths, stability and the order \
             of unrelated events may differ",
        );
    }
    report.line("");
    add_regions(&mut report, document);
    add_events(&mut report, document);
    add_stability(&mut report, document);
    add_path(&mut report, document);
    report.text()
}

/// All kinds of regions: also those that both have are few.
fn add_regions(report: &mut Report, document: &ComparisonDocument) {
    let mut table = Table::new(&["U", "P", "regions of 1", "regions of 2"]);
    for kind in &document.regions {
        let [first, second] =
            kind.regions.each_ref().map(|ids| if ids.is_empty() { "-".to_owned() } else { ids.join(" ") });
        table.row([components(kind), kind.signature.clone().unwrap_or_else(|| "-".to_owned()), first, second]);
    }
    report.line(table.text());
    report.line("");
}

fn components(kind: &ComparedRegionsDocument) -> String {
    let one = |component: &bifdiag_schema::ComponentDocument| {
        let poles = component.poles.as_ref().map_or_else(String::new, |poles| poles.concat());
        let poles = if poles.is_empty() { String::new() } else { format!("({poles})") };
        format!("{}{poles}", component.accessible_region)
    };
    kind.components.iter().map(one).collect::<Vec<_>>().join(" + ")
}

fn add_events(report: &mut Report, document: &ComparisonDocument) {
    let mut table = Table::new(&["event", "in 1", "in 2"]);
    let differing = document.events.iter().filter(|event| event.counts[0] != event.counts[1]);
    for event in differing.clone() {
        let kind = match event.kind {
            EventKind::Cusp => "cusp",
            EventKind::Pitchfork => "pitchfork",
            EventKind::Crossing => "crossing",
        };
        let [first, second] = event.counts.map(|count| count.to_string());
        table.row([format!("{kind}: {}", event.branches.join(", ")), first, second]);
    }
    add_differing(report, &table, differing.count(), document.events.len(), "kinds of events");
}

fn add_stability(report: &mut Report, document: &ComparisonDocument) {
    let mut table = Table::new(&["change of stability", "branch", "from", "to", "in 1", "in 2"]);
    let differing = document.stability_changes.iter().filter(|change| change.counts[0] != change.counts[1]);
    for change in differing.clone() {
        let [first, second] = change.counts.map(|count| count.to_string());
        let [from, to] = [change.from, change.to].map(|of| of.word().to_owned());
        table.row([change.kind.word().to_owned(), change.branch.clone(), from, to, first, second]);
    }
    add_differing(report, &table, differing.count(), document.stability_changes.len(), "kinds of changes of stability");
}

/// What differs, and how many kinds both bodies have equally often.
fn add_differing(report: &mut Report, table: &Table, differing: usize, all: usize, what: &str) {
    if differing > 0 {
        report.line(table.text());
        report.line(format!("{what} that both have in equal number: {}", all - differing));
    } else if all == 0 {
        report.line(format!("{what}: neither has any"));
    } else {
        let same = if all == 1 { "the same one".to_owned() } else { format!("the same {all}") };
        report.line(format!("{what}: both have {same}"));
    }
    report.line("");
}

fn add_path(report: &mut Report, document: &ComparisonDocument) {
    let path = &document.path;
    match (path.borders.len(), document.same_class) {
        (0, Some(true)) => {
            report.line("the path between them was not searched for borders, because its ends have the same class");
            return;
        }
        (0, _) => {
            report.line("the borders on the path between them could not be found");
            return;
        }
        _ => {}
    }
    report.line("borders on the straight path from 1 (at 0) to 2 (at 1):");
    let mut table = Table::new(&["at", "class beyond", "what happens on the border"]);
    let places: Vec<f64> = path.borders.iter().map(|border| border.at).collect();
    for (border, at) in path.borders.iter().zip(all_apart(&places, 6)) {
        table.row([at, border.classes[1].clone(), border.event.text.clone()]);
    }
    report.line(table.text());
    report.line(if path.complete {
        "a class that the path enters and leaves again may be missing"
    } else {
        "the path continues beyond the last of them: further borders were not found"
    });
    report.line("branches and components of r in axes by rising moments");
    for (number, _) in ["1", "2"].into_iter().zip(path.turned).filter(|(_, turned)| *turned) {
        report.line(format!(
            "{number} has equal moments: its r is turned among their axes, which leaves its diagram \
        unchanged"
        ));
    }
}
