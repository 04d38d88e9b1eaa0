//! `bifdiag classes --at`: where a body stands among the classes.

use bifdiag_exact::Accuracy;
use bifdiag_schema::StandingDocument;
use bifdiag_survey::border::class_of;
use bifdiag_survey::nearest::{NearestOptions, nearest};
use bifdiag_survey::space::{BodySet, ReducedBody};

use super::arguments::ClassesArguments;
use crate::cli::export::answer;
use crate::cli::failure::Failure;
use crate::cli::input::head;
use crate::cli::terminal::{Report, Table, significant};

pub fn run(arguments: &ClassesArguments) -> Result<(), Failure> {
    let subject = arguments.body.subject()?;
    let usual = NearestOptions::default();
    let options = NearestOptions {
        lines: arguments.lines.unwrap_or(usual.lines),
        seed: arguments.seed.unwrap_or(usual.seed),
        set: if arguments.physical { BodySet::Physical } else { BodySet::All },
        ..usual
    };
    let class = class_of(&subject.body, Accuracy::Exact).map(|(_, class)| class);
    let borders = match &class {
        Ok(_) => nearest(ReducedBody::of_body(&subject.body), &options),
        Err(_) => Vec::new(),
    };
    let command = subject
        .command("classes")
        .flag("at", true)
        .flag("physical", arguments.physical)
        .option_if("lines", arguments.lines.filter(|lines| *lines != usual.lines))
        .option_if("seed", arguments.seed.filter(|seed| *seed != usual.seed));
    let document =
        bifdiag_documents::standing(class.as_ref().ok().map(bifdiag_diagram::class::Class::name), &borders, command);
    Ok(answer(arguments.json, &document, || {
        let mut text = Report::default();
        head(&subject, &mut text);
        match &class {
            Ok(_) => report(&mut text, &document),
            Err(error) => text.line(format!("the body has no class: {error}")),
        }
        text.text()
    })?)
}

fn report(report: &mut Report, document: &StandingDocument) {
    let name = document.name.as_deref().unwrap_or_default();
    report.line(format!("class {name}"));
    if document.known {
        report.line(format!("  bifdiag class {name} tells more"));
    } else {
        report.line("  it is none of the classes that come with bifdiag, so `bifdiag class` does not know it");
    }
    if document.borders.is_empty() {
        report.line("no border was met on the lines through it");
        return;
    }
    report.line("");
    let mut table = Table::new(&["at most so far", "class beyond", "what happens on the border"]);
    for border in &document.borders {
        table.row([distance(border.distance), border.class.clone(), border.event.clone()]);
    }
    report.line(table.text());
    report
        .line("axes by rising moments; special bodies (two equal moments, a component of r that is 0) are not counted");
}

/// A distance, as far as the body's own rounding leaves it.
fn distance(distance: f64) -> String {
    /// A few roundings of A with the sum 2 and of r with the length 1.
    const ROUNDING: f64 = 1e-15;
    if distance < ROUNDING { "0".to_owned() } else { significant(distance, 4) }
}
