//! `bifdiag class NAME`: one class in words, with the diagram of its witness.

use std::path::PathBuf;

use bifdiag_body::Body;
use bifdiag_diagram::atlas::Atlas;
use bifdiag_documents::DocumentOptions;
use bifdiag_exact::Accuracy;
use bifdiag_plot::draw_figure;
use bifdiag_schema::{AtlasDocument, ClassDocument, ClassesDocument};
use clap::Args;

use crate::Curves;
use crate::cli::export::{DiagramArguments, FileSet, PictureArguments, answer, directory};
use crate::cli::failure::{Failure, failed};
use crate::cli::terminal::{Report, Table, Timings, counted, significant};

pub const CLASS_EXAMPLES: &str = "\
Examples:
  bifdiag class 01036ac4a504
  bifdiag class 01036ac4a504 --no-plot
  bifdiag class 0103 --json

The first digits of a name are enough if no other class begins with them.";

/// `bifdiag class`.
#[derive(Debug, Args)]
pub struct ClassArguments {
    /// Name of a class, 12 hexadecimal digits, or its first digits
    #[arg(value_name = "NAME")]
    pub name: String,
    /// Write no picture
    #[arg(long, help_heading = "Output")]
    pub no_plot: bool,
    /// Print the class as JSON; pictures only with --out
    #[arg(long, help_heading = "Output")]
    pub json: bool,
    /// Write the diagram of the class's witness to DIR (default: bifdiag-out)
    #[arg(long, value_name = "DIR", help_heading = "Output")]
    pub out: Option<PathBuf>,
    #[command(flatten)]
    pub picture: PictureArguments,
    #[command(flatten)]
    pub diagram: DiagramArguments,
}

pub fn run(arguments: &ClassArguments, timings: &Timings) -> Result<(), Failure> {
    let mut class = find(&arguments.name)?;
    if arguments.json {
        bifdiag_documents::add_text(&mut class);
    }
    let directory = directory(arguments.out.as_deref(), !arguments.json && !arguments.no_plot)?;
    if arguments.json && directory.is_none() {
        return answer(true, &class, String::new);
    }
    let (atlas, document) = timings.stage("regions", || witness(&class))?;
    let mut written = Vec::new();
    if let Some(directory) = directory.filter(|_| !arguments.no_plot) {
        let mut files = FileSet::new(&directory);
        let name = format!("class-{}", class.name);
        let options = arguments.diagram.options(None, arguments.picture.theme);
        let figure = timings.stage("diagram", || draw_figure(&document, Some(&Curves(&atlas)), &options))?;
        files.figure(&name, figure, &arguments.picture, timings)?;
        written = timings.stage("files", || files.write())?;
    }
    answer(arguments.json, &class, || report(&class, &document, &written))
}

/// The class whose name begins so.
fn find(name: &str) -> Result<ClassDocument, Failure> {
    let ClassesDocument { classes, others, .. } = bifdiag_documents::shipped_classes();
    let all: Vec<ClassDocument> = classes.into_iter().chain(others).collect();
    let digits = name.to_ascii_lowercase();
    let mut found = all.iter().filter(|class| !name.is_empty() && class.name.starts_with(&digits));
    match (found.next(), found.count()) {
        (Some(only), 0) => Ok(only.clone()),
        (Some(first), more) => {
            let (count, first) = (more + 1, &first.name);
            let others = counted(more, "other", "others");
            Err(Failure::input(format!(
                "NAME {name}: {count} classes begin with it, {first} and {others}; give more digits"
            )))
        }
        (None, _) if name.is_empty() => Err(Failure::input("NAME is empty; `bifdiag classes --json` lists the names")),
        (None, _) => Err(Failure::input(format!(
            "NAME {name}: no built-in class begins with it{}; a name is computed from the structure of a diagram and \
            cannot be turned back into a body: `bifdiag classes --at --body …` (or --A … --r …) gives the class of a \
            body and the neighbouring classes, and `bifdiag classes --json` lists those that are known",
            nearest(&digits, &all)
        ))),
    }
}

/// The known name with the longest beginning in common, if that is at least half a name.
fn nearest(digits: &str, all: &[ClassDocument]) -> String {
    let common = |class: &ClassDocument| class.name.bytes().zip(digits.bytes()).take_while(|(p, q)| p == q).count();
    let best = all.iter().max_by_key(|class| common(class)).filter(|class| 2 * common(class) >= class.name.len());
    best.map_or_else(String::new, |class| format!(" (the nearest is {})", class.name))
}

/// The diagram of the witness; without it, the program has a defect.
fn witness(class: &ClassDocument) -> Result<(Atlas, AtlasDocument), Failure> {
    let body = Body::parse(&class.witness.body.moments, &class.witness.body.center);
    let body = body.map_err(failed("the witness of the class is no body"))?;
    let atlas =
        bifdiag_exact::atlas(&body, Accuracy::Exact).map_err(failed("the witness of the class has no atlas"))?;
    let document = bifdiag_documents::atlas::document(&atlas, &DocumentOptions::default());
    Ok((atlas, document))
}

/// What is special about a body, and how its axes are numbered where that names some.
pub fn special(stratum: &str) -> String {
    let names_axes = stratum.contains("ax") || stratum.contains('A');
    format!("{stratum}{}", if names_axes { " (axes by rising moments)" } else { "" })
}

/// Its share of bodies in percent, or that no body of a sample has it.
pub fn share(class: &ClassDocument) -> String {
    if class.measure == 0.0 {
        return format!("0/{}", sampled(class));
    }
    format!("{}%", significant(100.0 * class.measure, 3))
}

/// How many bodies the sample has: the error of a share that it shows to be all or nothing is that of one body.
fn sampled(class: &ClassDocument) -> String {
    significant(1.0 / class.measure_error, 6)
}

/// The same, and how it is known.
fn share_in_words(class: &ClassDocument) -> String {
    let (share, error) = (share(class), class.measure_error);
    if class.stratum.as_ref().is_some_and(|stratum| stratum.starts_with("the ball")) {
        return format!("{share}, because they differ only in scale");
    }
    match class.measure {
        0.0 => format!("none of a sample of {} bodies", sampled(class)),
        1.0 => format!("{share} of a sample of {} bodies", sampled(class)),
        _ => format!("{share} (± {}%)", significant(100.0 * error, 1)),
    }
}

fn report(class: &ClassDocument, document: &AtlasDocument, written: &[PathBuf]) -> String {
    let mut report = Report::default();
    let (whose, of) = if class.physical {
        ("a class of physical bodies", "physical bodies")
    } else {
        ("a class that no physical body is known to have", "bodies with A > 0")
    };
    report.line(format!("class {}: {}; {whose}", class.name, counted(class.regions, "region", "regions")));
    let among = match &class.stratum {
        Some(stratum) => {
            report.line(format!("special bodies: {}", special(stratum)));
            "such special "
        }
        None => "",
    };
    let sections: Vec<&str> = document.regions.iter().filter_map(|region| region.signature.as_deref()).collect();
    report.line(if sections.is_empty() {
        "sections of its regions: none, since r = 0".to_owned()
    } else {
        format!("sections of its regions: {}", sections.join(", "))
    });
    report.line(format!("types of components: {}", class.types.join(", ")));
    report.line(format!("share of {among}{of}: {}", share_in_words(class)));
    report.line("an example:");
    let (moments, center) = (class.witness.body.moments.join(","), class.witness.body.center.join(","));
    report.line(format!("  bifdiag --A {moments} --r {center}"));
    if class.distance > 0.0 {
        let distance = significant(class.distance, 3);
        report.line(format!(
            "  the nearest body of another class that the survey found, special bodies included, is {distance} away; \
             there may be nearer ones"
        ));
    }
    report.line("");
    if class.distance == 0.0 {
        report.line("what is known of the borders around this body:");
        report.line(format!("  bifdiag classes --at --A {moments} --r {center}"));
    } else if class.neighbours.is_empty() {
        report.line("no neighbouring class is known");
    } else {
        let mut table = Table::new(&["class beside it", "what happens on the border"]);
        for neighbour in &class.neighbours {
            let only = if class.physical && !neighbour.physical { " (among unphysical bodies)" } else { "" };
            table.row([neighbour.class.clone(), format!("{}{only}", neighbour.event)]);
        }
        report.line(table.text());
    }
    report.written(written);
    report.text()
}
