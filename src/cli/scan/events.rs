//! `bifdiag scan events`: the events of the diagram while one parameter of the body varies.

use bifdiag_documents::words::counted;
use bifdiag_numbers::Number;
use bifdiag_plot::{Figure, draw_map};
use bifdiag_schema::EventTracksDocument;
use bifdiag_survey::border::{BodySegment, BorderOptions};
use bifdiag_survey::events::follow;
use bifdiag_survey::{ParameterRange, with_values};

use super::arguments::EventsArguments;
use crate::cli::export::{Columns, DataFormat, DataTarget, FileSet, Values, answer, directory};
use crate::cli::failure::Failure;
use crate::cli::terminal::{Report, Table, Timings, all_apart, bound, print, significant};
use crate::pictures::{EventScene, events, momenta};

/// Bodies if no number is given.
const BODIES: u32 = 240;
/// The most bodies: each needs an atlas.
const BODIES_MAX: u32 = 20_000;
const DIGITS: usize = 6;

pub fn run(arguments: &EventsArguments, timings: &Timings) -> Result<(), Failure> {
    let subject = arguments.body.subject()?;
    let vary = &arguments.vary;
    let bodies = vary.steps.unwrap_or(BODIES);
    if bodies > BODIES_MAX {
        return Err(Failure::input(format!("--vary: {bodies} bodies are too many; give at most {BODIES_MAX}")));
    }
    let to_stdout = arguments.data == Some(DataTarget::Stdout);
    if to_stdout && arguments.json {
        return Err(Failure::input("--data - and --json both want stdout; give --data FILE.csv"));
    }
    let end = |value: &Number| {
        with_values(&subject.body, [(vary.parameter, value)])
            .map_err(|error| Failure::input(format!("--vary: {error}")))
    };
    let segment = BodySegment::new(end(&vary.from)?, end(&vary.to)?);
    let tracks = timings.stage("events", || follow(&segment, bodies as usize, &BorderOptions::default()));
    let text = format!("{}={}:{}:{bodies}", vary.parameter, vary.from.text(), vary.to.text());
    let command = subject.command("scan events").option("vary", text);
    let walked = ParameterRange { steps: Some(bodies), ..vary.clone() };
    let document = bifdiag_documents::event_tracks(&tracks, &segment, &walked, command);
    let directory = directory(arguments.out.as_deref(), !(arguments.json || to_stdout))?.filter(|_| !arguments.no_plot);
    let mut files = FileSet::new(directory.as_deref().unwrap_or_else(|| std::path::Path::new(".")));
    if let Some(DataTarget::File { path, format }) = &arguments.data {
        files.add_at(path, format.bytes(&columns(&document)?)?);
    }
    if directory.is_some() {
        let l = arguments.momenta.unwrap_or_else(|| momenta(&tracks));
        let map = events(&EventScene { tracks: &tracks, segment: &segment, parameter: vary.parameter, l });
        let picture = timings.stage("picture", || draw_map(&map, arguments.picture.theme, arguments.width.width))?;
        files.remove_pictures("events");
        let figure = Figure { picture, legend: None, caption: map.caption() };
        files.figure("events", figure, &arguments.picture, timings)?;
    }
    let written = files.write()?;
    if to_stdout {
        return print(DataFormat::Csv.bytes(&columns(&document)?)?);
    }
    answer(arguments.json, &document, || {
        let mut report = Report::default();
        let name = |place: usize, number: &Number| {
            if place == vary.parameter.place() { vary.parameter.to_string() } else { number.text().to_owned() }
        };
        let numbers = subject.body.moments().iter().chain(subject.body.center());
        let names: Vec<String> = numbers.enumerate().map(|(place, number)| name(place, number)).collect();
        report.line(format!("A = ({})", names[..3].join(", ")));
        report.line(format!("r = ({})", names[3..].join(", ")));
        add(&mut report, &document);
        report.written(&written);
        report.text()
    })
}

/// A row for each place of each event.
fn columns(document: &EventTracksDocument) -> Result<Columns, Failure> {
    let events = &document.events;
    let count = |number: usize| i32::try_from(number).unwrap_or(i32::MAX);
    let tracks = || events.iter().enumerate().flat_map(|(track, event)| event.at.iter().map(move |_| count(track)));
    let words = events.iter().map(|event| event.event.clone().into()).collect();
    let of = |values: fn(&bifdiag_schema::EventTrackDocument) -> &Vec<f64>| {
        Values::floats(events.iter().flat_map(|event| values(event).iter().copied()))
    };
    let columns = [
        ("track", Values::Int32(tracks().collect())),
        ("event", Values::Words { words, places: Box::new(Values::Int32(tracks().collect())) }),
        ("value", of(|event| &event.at)),
        ("h", of(|event| &event.h)),
        ("l", of(|event| &event.l)),
    ];
    let meta = EventTracksDocument { events: Vec::new(), ..document.clone() };
    Ok(Columns::new(columns, &meta)?)
}

fn add(report: &mut Report, document: &EventTracksDocument) {
    let parameter = document.vary.parameter;
    report.line(format!(
        "{parameter} from {} to {}: {}; {} between them",
        document.vary.from,
        document.vary.to,
        counted(document.bodies as usize, "body", "bodies"),
        counted(document.borders.len(), "border or special body", "borders or special bodies"),
    ));
    if document.passed > 0 {
        let left_out = counted(document.passed as usize, "of them is left out", "of them are left out");
        report.line(format!("{left_out} as special, on a border, undecided or alone in its class; neighbouring bodies are examined instead"));
    }
    report.line("");
    let values = border_values(document);
    if document.events.is_empty() {
        report.line("no events");
    } else {
        add_events(report, document, &values);
    }
    report
        .line("borders are sought between neighbouring bodies of different classes; two within one step may be missed");
    for (border, value) in document.borders.iter().zip(&values) {
        let Some(at) = border.at.first() else { continue };
        let error = if border.reached { String::new() } else { format!(" ± {}", bound(at.error, 1)) };
        report.line(format!("{parameter} = {value}{error}: {}", border.event.text));
    }
}

/// The values of the parameter at the borders, told apart from one another and from the ends of the range.
fn border_values(document: &EventTracksDocument) -> Vec<String> {
    let borders = document.borders.iter().map(|border| border.at.first().map_or(f64::NAN, |at| at.value));
    let ends = [&document.vary.from, &document.vary.to].into_iter().filter_map(|text| text.parse().ok());
    let mut values = all_apart(&borders.chain(ends).collect::<Vec<f64>>(), DIGITS);
    values.truncate(document.borders.len());
    values
}

/// The table of events, with the values of the parameter at the borders.
fn add_events(report: &mut Report, document: &EventTracksDocument, values: &[String]) {
    let parameter = document.vary.parameter;
    let border = |number: u32| values.get(number as usize);
    let mut table = Table::new(&["event", "from", "to", "l"]);
    for event in &document.events {
        let end = |side: usize| match event.between[side].and_then(border) {
            Some(value) => value.clone(),
            None => [&document.vary.from, &document.vary.to][side].clone(),
        };
        let least = event.l.iter().copied().fold(f64::INFINITY, f64::min);
        let most = event.l.iter().copied().fold(0.0, f64::max);
        let [least, most] = [least, most].map(|l| significant(l, DIGITS));
        let l = if least == most { least } else { format!("{least} … {most}") };
        table.row(vec![event.event.clone(), end(0), end(1), l]);
    }
    report.line(table.text());
    report.line(format!("from, to: values of {parameter}"));
    report.line(
        "l: the smallest and the largest among the bodies examined; at a border or special body, which is not, it may be \
         infinite",
    );
}
