//! `bifdiag classes` and `bifdiag class`: the classes of bodies, one of them, and where a body stands among them.

mod arguments;
mod class;
mod standing;

use bifdiag_schema::{ClassDocument, ClassesDocument};

use super::export::answer;
use super::failure::Failure;
use super::terminal::{Report, Table, significant};

pub use arguments::{CLASS_EXAMPLES, CLASSES_EXAMPLES, ClassArguments, ClassesArguments};
pub use class::run as class;

pub fn run(arguments: &ClassesArguments) -> Result<(), Failure> {
    if arguments.at {
        return standing::run(arguments);
    }
    if let Some(option) = arguments.body.given().next() {
        return Err(arguments::ClassesInput::NotAt { option }.into());
    }
    let mut document = bifdiag_documents::shipped_classes();
    if arguments.physical {
        document.classes.retain(|class| class.physical);
        document.others.retain(|class| class.physical);
    }
    if arguments.json {
        document.classes.iter_mut().for_each(bifdiag_documents::add_text);
    }
    Ok(answer(arguments.json, &document, || table(&document))?)
}

/// Its share of bodies in percent, or that it is less than can be told.
fn share(class: &ClassDocument) -> String {
    if class.measure == 0.0 {
        return format!("< {}%", significant(100.0 * class.measure_error, 1));
    }
    format!("{}%", significant(100.0 * class.measure, 3))
}

fn table(ClassesDocument { classes, others, .. }: &ClassesDocument) -> String {
    let mut order: Vec<&ClassDocument> = classes.iter().collect();
    order.sort_by(|p, q| {
        (q.physical, q.measure, q.distance)
            .partial_cmp(&(p.physical, p.measure, p.distance))
            .unwrap_or(std::cmp::Ordering::Equal)
    });
    let mut table = Table::new(&["class", "exists", "share", "regions", "neighbours", "distance", "types"]);
    for class in order {
        let mut neighbours: Vec<&str> = class.neighbours.iter().map(|neighbour| neighbour.class.as_str()).collect();
        neighbours.dedup();
        table.row([
            class.name.clone(),
            if class.physical { "yes" } else { "-" }.to_owned(),
            share(class),
            class.regions.to_string(),
            neighbours.len().to_string(),
            significant(class.distance, 2),
            class.types.join(" "),
        ]);
    }
    let mut report = Report::default();
    report.line(table.text());
    let existing = classes.iter().filter(|class| class.physical).count();
    report.line(format!("{} classes, {existing} of them of bodies that exist", classes.len()));
    let special = others.iter().filter(|class| class.stratum.is_some()).count();
    report.line(format!(
        "and apart from these {special} of special bodies, {} known only of bodies that do not exist (--json lists them)",
        others.len() - special
    ));
    report.text()
}
