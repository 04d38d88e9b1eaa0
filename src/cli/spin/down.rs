//! `bifdiag spin-down`: how a steady rotation ends when friction slowly takes its angular momentum.

use std::path::{Path, PathBuf};

use bifdiag_body::Number;
use bifdiag_diagram::atlas::Atlas;
use bifdiag_documents::{DocumentOptions, Subject};
use bifdiag_equilibria::curves::{CurveName, MomentumError, abscissa};
use bifdiag_exact::Accuracy;
use bifdiag_plot::{DiagramOptions, DiagramView, MarkedPoints, draw};
use bifdiag_schema::{SlowdownDocument, SlowdownEvent, SpinDownDocument, WindowDocument};
use clap::Args;

use crate::Curves;
use crate::cli::export::{FileSet, PictureArguments, WidthArgument, answer};
use crate::cli::failure::{Failure, failed, no_such_curve};
use crate::cli::input::{BodyArguments, head, motion_units, values};
use crate::cli::terminal::{Report, Table, Timings, significant, told_apart};

pub const SPIN_DOWN_EXAMPLES: &str = "\
Examples:
  bifdiag spin-down --A 2,2,3 --r 0,0,1 --from L-.2 --l 6
  bifdiag spin-down --body paper --from G1.3 --json
  bifdiag spin-down --body paper --from G1.3 --out way

Friction in the body damps all that is not steady; friction at the pivot or in the air removes l, in the limit much \
more slowly. The rotation then follows its curve as long as that is a minimum of U_l.";

/// `bifdiag spin-down`.
#[derive(Debug, Args)]
pub struct SpinDownArguments {
    #[command(flatten)]
    pub body: BodyArguments,
    /// Curve of the rotation, by its id in `bifdiag atlas`
    #[arg(long, value_name = "CURVE", help_heading = "Rotation")]
    pub from: String,
    /// Initial vertical angular momentum; its sign does not matter (default: the largest l of the curve, or twice the l
    /// of the last event if the curve is unbounded, without events twice the unit of the diagram)
    #[arg(long = "l", value_name = "l", allow_hyphen_values = true, value_parser = values::number, help_heading = "Rotation")]
    pub momentum: Option<Number>,
    /// Draw the path over the diagram, to DIR/spin-down.svg
    #[arg(long, value_name = "DIR", help_heading = "Output")]
    pub out: Option<PathBuf>,
    #[command(flatten)]
    pub width: WidthArgument,
    #[command(flatten)]
    pub picture: PictureArguments,
    /// Print the path as JSON
    #[arg(long, help_heading = "Output")]
    pub json: bool,
}

/// Significant digits.
const DIGITS: usize = 6;

pub fn run(arguments: &SpinDownArguments, timings: &Timings) -> Result<(), Failure> {
    let subject = arguments.body.subject()?;
    let atlas = timings.stage("atlas", || bifdiag_exact::atlas(&subject.body, Accuracy::Exact));
    let atlas = atlas.map_err(failed("the atlas could not be made"))?;
    let set = &atlas.arrangement().set;
    let id = values::id(&arguments.from);
    let critical = || set.curves.pairs().filter(|(_, curve)| curve.is_critical());
    let name = |curve| CurveName::of(set, curve).to_string();
    let Some((from, curve)) = critical().find(|(curve, _)| name(*curve) == id) else {
        return Err(no_such_curve("--from", &arguments.from, critical().map(|(curve, _)| name(curve))));
    };
    let [lower, upper] = curve.x().map(|x| atlas.momentum(x));
    let last = atlas.arrangement().events.iter().map(|event| event.x).fold(curve.x()[0], f64::max);
    let l = match &arguments.momentum {
        Some(l) => l.to_f64().abs(),
        None if upper.is_finite() => upper,
        None => 2.0 * if last > 0.0 { atlas.momentum(last) } else { set.frame.momentum_unit },
    };
    if let Some(given) = arguments.momentum.as_ref().filter(|given| given.to_f64() < 0.0) {
        tracing::warn!(
            "--l {given}: the path is that of l = {l}, with the signs of l and omega reversed",
            given = given.text()
        );
    }
    let is_double =
        |given: &Number| Number::from_f64(given.to_f64()).is_ok_and(|double| double.value() == given.value());
    if let Some(given) = arguments.momentum.as_ref().filter(|given| !is_double(given)) {
        tracing::warn!("--l {given}: the path begins at the nearest double, l = {l}", given = given.text());
    }
    if !(lower < l && l <= upper) {
        if lower == upper && arguments.momentum.is_none() {
            let right = "it begins and ends at the same l in doubles: give --from another curve";
            return Err(Failure::input(format!("--from {id}: {right}")));
        }
        let is_below = l <= lower;
        let [refused, end] = told_apart([l, if is_below { lower } else { upper }], DIGITS);
        let (lower, upper) =
            if is_below { (end, significant(upper, DIGITS)) } else { (significant(lower, DIGITS), end) };
        let range = if upper == "inf" { format!("above {lower}") } else { format!("above {lower}, up to {upper}") };
        return Err(Failure::input(format!("--l {refused}: the curve {id} has l {range}")));
    }
    abscissa(&set.frame, l).map_err(|MomentumError { smallest, largest, .. }| {
        Failure::input(format!(
            "--l {l:e} leaves f64 for this body; |l| from {smallest:.1e} to {largest:.1e} is possible"
        ))
    })?;
    let command = subject.command("spin-down").option("from", &id).option("l", format!("{l:?}"));
    let document = bifdiag_documents::spin_down(&subject, command, &atlas, from, l);
    let written = match &arguments.out {
        Some(directory) => drawn(arguments, &subject, &atlas, &document, directory, timings)?,
        None => Vec::new(),
    };
    answer(arguments.json, &document, || text(&subject, &id, &document, &written))
}

/// How far the picture shows more than the way, in parts of it.
const MARGIN: f64 = 0.15;

/// The way over the diagram, with a dot where it begins and wherever it turns, falls or ends.
fn drawn(
    arguments: &SpinDownArguments,
    subject: &Subject,
    atlas: &Atlas,
    document: &SpinDownDocument,
    directory: &Path,
    timings: &Timings,
) -> Result<Vec<PathBuf>, Failure> {
    let way = &document.path;
    let begin = way.iter().take(1).map(|stretch| [stretch.h[0], stretch.l[0]]);
    let is_event = |stretch: &&SlowdownDocument| stretch.event != SlowdownEvent::Crossing;
    let ends = way.iter().filter(is_event).map(|stretch| [stretch.h[1], stretch.l[1]]);
    let points: Vec<[f64; 2]> = begin.chain(ends).collect();
    let over = |side: usize| {
        let values = || way.iter().flat_map(move |stretch| if side == 0 { stretch.h } else { stretch.l });
        let (least, most) = (values().fold(f64::INFINITY, f64::min), values().fold(f64::NEG_INFINITY, f64::max));
        let margin = if most > least { MARGIN * (most - least) } else { MARGIN * most.abs().max(1.0) };
        [least - margin, most + margin]
    };
    let window = WindowDocument { h: over(0), l: [over(1)[0].max(0.0), over(1)[1]] };
    let marked = MarkedPoints { points, text: "where it begins, turns, falls or ends".to_owned(), way: way.clone() };
    let (window, points, view) = (Some(window), Some(marked), DiagramView::Plane);
    let (theme, width) = (arguments.picture.theme, arguments.width.width);
    let options = DiagramOptions { window, points, theme, view, width, ..DiagramOptions::default() };
    let mut diagram = bifdiag_documents::atlas::document(atlas, &DocumentOptions::default());
    bifdiag_documents::atlas::attach_part(&mut diagram, subject);
    let picture = timings.stage("diagram", || draw(&diagram, Some(&Curves(atlas)), &options))?;
    let mut files = FileSet::new(directory);
    files.remove_pictures("spin-down");
    files.pictures("spin-down", &picture, &arguments.picture, timings)?;
    files.write()
}

fn text(subject: &Subject, from: &str, document: &SpinDownDocument, written: &[PathBuf]) -> String {
    let mut report = Report::default();
    head(subject, &mut report);
    report.line("");
    let mut table = Table::new(&["curve", "l", "h", "omega", "regions", "then"]);
    for stretch in &document.path {
        let range = |[from, to]: [f64; 2]| {
            let [from, to] = told_apart([from, to], DIGITS);
            if from == to { from } else { format!("{from} → {to}") }
        };
        let [below, above] = stretch.regions.each_ref().map(|region| region.as_deref().unwrap_or("none"));
        table.row([
            stretch.curve.clone(),
            range(stretch.l),
            range(stretch.h),
            range(stretch.omega),
            format!("{below}, {above}"),
            then(stretch, subject.body.is_euler()),
        ]);
    }
    report.line(table.text());
    report.line("");
    if let Some(first) = document.path.first().filter(|first| first.curve != from) {
        report.line(format!(
            "{from} ends at l = {} in a pitchfork, from which {} continues",
            significant(first.l[0], DIGITS),
            first.curve
        ));
    }
    report.line("regions: just below and just above in h");
    motion_units(subject, &mut report);
    report.line("in the limit where l is lost much more slowly than all that is not steady is damped");
    report.written(written);
    report.text()
}

/// What ends a stretch.
fn then(stretch: &SlowdownDocument, is_free: bool) -> String {
    let onto = stretch.onto.join(" or ");
    let falls = |why: &str| {
        if onto.is_empty() { format!("{why}: falls") } else { format!("{why}: falls, to {onto}") }
    };
    match stretch.event {
        SlowdownEvent::Crossing => "continues".to_owned(),
        SlowdownEvent::Turn => format!("pitchfork: continues along {onto}"),
        SlowdownEvent::Pitchfork => falls("pitchfork"),
        SlowdownEvent::Cusp => falls("cusp"),
        SlowdownEvent::Start => falls("no minimum"),
        SlowdownEvent::Rest => if is_free { "comes to rest" } else { "hangs at rest" }.to_owned(),
    }
}
