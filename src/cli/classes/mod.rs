//! `bifdiag classes`: the classes of bodies, and the position of a body among them.

mod class;

use bifdiag_diagram::class::Class;
use bifdiag_exact::Accuracy;
use bifdiag_schema::{ClassDocument, ClassesDocument, StandingDocument};
use bifdiag_survey::border::class_of;
use bifdiag_survey::nearest::{HERE, NearestOptions, nearest};
use bifdiag_survey::space::{BodySet, ReducedBody};
use bifdiag_survey::strata::{BESIDE, SpecialStratum};
use clap::Args;

use super::export::answer;
use super::failure::Failure;
use super::input::{PlainBodyArguments, head};
use super::terminal::{Report, Table, bound, counted, significant};
use class::{share, special};

pub use class::{CLASS_EXAMPLES, ClassArguments, run as class};

pub const CLASSES_EXAMPLES: &str = "\
Examples:
  bifdiag classes
  bifdiag classes --physical --json | jq -r '.classes[].name'
  bifdiag classes --at --A 1,1.1,1.4 --r 0.5,0.3,0.8
  bifdiag classes --at --body paper --json

Two bodies belong to the same class when their diagrams agree up to deformation: lengths, stability and the order of \
unrelated events may differ. With --at: the class of a body and its distances to the borders of that class. A distance is \
√(|ΔA|² + ∠²), with A scaled to the sum 2 and ∠ the angle between the two r, turned first \
among axes of equal moments.";

/// `bifdiag classes`.
#[derive(Debug, Args)]
pub struct ClassesArguments {
    /// Find the class of a body and its distances to the borders of that class
    #[arg(long)]
    pub at: bool,
    #[command(flatten)]
    pub body: PlainBodyArguments,
    /// Only physical bodies: A_i + A_j > A_k, or equality and r_k = 0
    #[arg(long, help_heading = "Work")]
    pub physical: bool,
    /// With --at: also search along N random lines through the body (default: 48 where its own diagram suggests no
    /// border)
    #[arg(long, value_name = "N", help_heading = "Work", requires = "at")]
    #[arg(value_parser = clap::value_parser!(u32).range(1..=1_000_000), hide_short_help = true)]
    pub lines: Option<u32>,
    /// With --at: seed for the lines (default: 0)
    #[arg(long, value_name = "N", help_heading = "Work", requires = "at", hide_short_help = true)]
    pub seed: Option<u64>,
    /// Print the answer as JSON
    #[arg(long, help_heading = "Output")]
    pub json: bool,
}

pub fn run(arguments: &ClassesArguments) -> Result<(), Failure> {
    if arguments.at {
        return standing(arguments);
    }
    if let Some(option) = arguments.body.given().next() {
        return Err(Failure::input(format!(
            "{option} describes a body, but nothing is asked about it; add --at to find its class"
        )));
    }
    let mut document = bifdiag_documents::shipped_classes();
    if arguments.physical {
        document.classes.retain(|class| class.physical);
        document.others.retain(|class| class.physical);
    }
    if arguments.json {
        document.classes.iter_mut().for_each(bifdiag_documents::add_text);
    }
    answer(arguments.json, &document, || table(&document))
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
    report.line(
        "distance: from the class's example to the nearest body of another class that the survey found, special bodies included; there \
        may be nearer ones",
    );
    let existing = classes.iter().filter(|class| class.physical).count();
    report.line(format!("{}, {existing} of them of physical bodies", counted(classes.len(), "class", "classes")));
    let special = others.iter().filter(|class| class.stratum.is_some()).count();
    let unphysical = match others.len() - special {
        0 => String::new(),
        unphysical => format!(", {unphysical} known only for unphysical bodies"),
    };
    report.line(format!("and besides these {special} of special bodies{unphysical} (--json lists them)"));
    report.text()
}

/// `--at`: the position of a body among the classes.
fn standing(arguments: &ClassesArguments) -> Result<(), Failure> {
    let subject = arguments.body.subject()?;
    if arguments.physical && subject.body.flags().unphysical {
        return Err(Failure::input(
            "--physical: no mass distribution has these moments and this centre of mass (it needs Ai + Aj > Ak, or \
            Ai + Aj = Ak with rk = 0); leave out --physical",
        ));
    }
    let usual = NearestOptions::default();
    let options = NearestOptions {
        lines: arguments.lines,
        seed: arguments.seed.unwrap_or(usual.seed),
        set: if arguments.physical { BodySet::Physical } else { BodySet::All },
    };
    let class = class_of(&subject.body, Accuracy::Exact).map(|(_, class)| class);
    let around = |class: &Class| nearest(ReducedBody::of_body(&subject.body), class.clone(), &options);
    let is_resolved = SpecialStratum::is_resolved(&subject.body);
    let borders = class.as_ref().ok().filter(|_| is_resolved).map_or_else(Vec::new, around);
    let command = subject
        .command("classes")
        .flag("at", true)
        .flag("physical", arguments.physical)
        .option_if("lines", arguments.lines)
        .option_if("seed", arguments.seed.filter(|seed| *seed != usual.seed));
    let name = class.as_ref().ok().map(Class::name);
    let document = bifdiag_documents::standing(&subject.body, name, &borders, command);
    answer(arguments.json, &document, || {
        let mut text = Report::default();
        head(&subject, &mut text);
        match &class {
            Ok(_) => standing_report(&mut text, &document, is_resolved),
            Err(error) => text.line(format!("its class is not known: {error}")),
        }
        text.text()
    })
}

fn standing_report(report: &mut Report, document: &StandingDocument, is_resolved: bool) {
    let name = document.name.as_deref().unwrap_or_default();
    report.line(format!("class {name}"));
    if document.known {
        report.line(format!("  bifdiag class {name} shows details"));
    } else {
        report.line("  it is not a built-in class, so `bifdiag class` does not know it");
    }
    if let Some(stratum) = &document.stratum {
        report.line(format!("a special body: {}", special(stratum)));
        let beside: Vec<String> = document
            .generic
            .iter()
            .map(|beside| {
                let share = if document.generic.len() > 1 {
                    format!(" ({:.0} %)", 100.0 * beside.share)
                } else {
                    String::new()
                };
                format!("{}{share}", beside.class)
            })
            .collect();
        report.line(format!(
            "classes found among {BESIDE} random generic bodies within 1e-6 of it: {}; rare ones may be missing",
            beside.join(", ")
        ));
    }
    if document.borders.is_empty() {
        report.line(if is_resolved {
            "no border of its class was found".to_owned()
        } else {
            format!(
                "its borders are not sought: a more special body is within {:e} of it, too near to tell borders apart in doubles",
                SpecialStratum::RESOLVED
            )
        });
        return;
    }
    report.line("");
    let mut table = Table::new(&["distance at most", "class beyond", "what happens on the border"]);
    for border in &document.borders {
        table.row([distance(border.distance), border.class.clone(), border.event.clone()]);
    }
    report.line(table.text());
    report
        .line("there may be more borders, and nearer ones; --lines N looks along N random lines through the body too");
    if document.borders[0].distance == 0.0 {
        report.line(format!("the body is on a border of its class, or within {} of one", distance(0.0)));
    }
    report.line(
        "axes by rising moments, numbered as in this body beyond a border too; what makes the body special (equal moments, zeros of r) is kept on the way, and classes \
        of more special bodies, such as those on a border, are not counted",
    );
}

/// A distance; 0 stands for all that are not told from the body itself.
fn distance(distance: f64) -> String {
    bound(if distance == 0.0 { HERE } else { distance }, 4)
}
