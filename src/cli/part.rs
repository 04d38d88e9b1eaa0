//! `bifdiag body`: a real part as it was understood.

use std::path::PathBuf;

use bifdiag_body::part::Existence;
use bifdiag_body::part::file::edges;
use bifdiag_documents::Subject;
use bifdiag_equilibria::permanent::angle_between;
use bifdiag_numbers::vector::{dot, norm};
use bifdiag_plot::{PartScene, draw_part};
use bifdiag_schema::{PartDocument, PrincipalDocument};
use clap::Args;

use super::export::{FileSet, PictureArguments, answer};
use super::failure::Failure;
use super::input::{GivenPart, PartArguments, integrable, shown_of_part};
use super::terminal::{Report, Table, Timings, all_apart, fixed, significant};

pub const BODY_EXAMPLES: &str = "\
Examples:
  bifdiag body --inertia-com 0.24,0.15,0.17,0,0,0 --com 0,0.02,0.15 --mass 2.5
  bifdiag body --inertia-com 240,150,170,8,0,-12 --products tensor \\
      --com 0,20,150 --mass 2.5 --units kg,mm,s
  bifdiag body --inertia-com 0.24,0.15,0.17,0,0,0 --com 0,0.02,0.15 --mass 2.5 \\
      --pivot 0.01,0,0 --out part";

/// `bifdiag body`.
#[derive(Debug, Args)]
pub struct PartBodyArguments {
    #[command(flatten)]
    pub part: PartArguments,
    /// Draw the part into DIR (part.svg)
    #[arg(long, value_name = "DIR", help_heading = "Output")]
    pub out: Option<PathBuf>,
    #[command(flatten)]
    pub picture: PictureArguments,
    /// Print the part as JSON
    #[arg(long, help_heading = "Output")]
    pub json: bool,
}

pub fn run(arguments: &PartBodyArguments, timings: &Timings) -> Result<(), Failure> {
    let given = arguments.part.shown()?.ok_or_else(|| {
        Failure::input(
            "no part is given; use --inertia-com 0.24,0.15,0.17,0,0,0 --com 0,0.02,0.15 --mass 2.5, or --inertia",
        )
    })?;
    let document = bifdiag_documents::part(&given.part, &given.principal);
    let mut written = Vec::new();
    if let Some(directory) = &arguments.out {
        let mut files = FileSet::new(directory);
        let picture = draw_part(&document, &scene(arguments)?, arguments.picture.theme)?;
        files.pictures("part", &picture, &arguments.picture, timings)?;
        written = files.write()?;
    }
    let is_stl = arguments
        .part
        .file
        .as_ref()
        .is_some_and(|path| path.extension().is_some_and(|suffix| suffix.eq_ignore_ascii_case("stl")));
    let text = || report(&given, &document, if is_stl { SINGLE } else { DIGITS }, &written);
    let subject = Subject::new(&given.part, given.principal.clone());
    answer(arguments.json, &subject.part_answer(), text)
}

/// The mesh behind the ellipsoid.
fn scene(arguments: &PartBodyArguments) -> Result<PartScene, Failure> {
    let pivot = arguments.part.fixed_point()?;
    Ok(PartScene { edges: arguments.part.file.as_ref().map(|path| edges(path, pivot)).unwrap_or_default() })
}

/// Digits of moments, to be compared with those that a CAD program prints.
const DIGITS: usize = 9;
/// Those of coordinates in single precision.
const SINGLE: usize = 7;

fn report(given: &GivenPart, document: &PartDocument, digits: usize, written: &[PathBuf]) -> String {
    let shown = |text: &str| shown_of_part(text, digits);
    let units = &given.part.units;
    let [mass, length, _] = units.names();
    let mut report = Report::default();
    report.line(format!("mass            {} {mass}", shown(&document.mass)));
    report.line(format!(
        "centre of mass  ({}) {length} from the fixed point",
        document.com.each_ref().map(|c| shown(c)).join(", ")
    ));
    report.line(format!("gravity         {} m/s²", shown(&document.g)));
    report.line(format!("tensor about the fixed point, in {} (off the diagonal Ixy = -∫ x y dm)", units.moment()));
    for row in &document.inertia {
        report.line(format!("  {}", row.each_ref().map(|x| format!("{:>20}", shown(x))).join(" ")));
    }
    report.line("");
    let about_com = table(&document.principal_com, given, digits, "radius of gyration");
    report
        .line(format!("about the centre of mass (what CAD prints), moments in {}, radii in {length}", units.moment()));
    report.line(about_com);
    report.line(format!("about the fixed point: the axes of A and r, r in {}", units.energy()));
    report.line(table(&document.principal, given, digits, "r"));
    existence(&mut report, given);
    integrable(&given.principal.body, &mut report);
    if !document.exact {
        report.line("the principal form is irrational: A and r are computed to 130 digits, symmetries exactly");
    }
    report.written(written);
    report.text()
}

/// Moments and axes about a point, with the angle of each axis to the line from the fixed point to the centre of mass.
fn table(principal: &PrincipalDocument, given: &GivenPart, digits: usize, last: &'static str) -> String {
    let properties = &given.part.properties;
    let (com, mass) = (properties.com.each_ref().map(|x| x.to_f64().value()), properties.mass.to_f64().value());
    let (distance, center) = (norm(com), given.principal.body.center_f64());
    let moments = all_apart(&principal.moments, digits);
    let mut table = Table::new(&["axis", "moment", "direction", "angle to com", last]);
    for k in 0..3 {
        let axis = principal.axes[k];
        let [x, y, z] = axis.map(|x| format!("{:>9}", fixed(x, 6)));
        let angle = angle_between(com, if dot(axis, com) < 0.0 { axis.map(|x| -x) } else { axis }).to_degrees();
        table.row([
            (k + 1).to_string(),
            moments[k].clone(),
            format!("({x}, {y}, {z})"),
            if distance == 0.0 { "-".to_owned() } else { format!("{}°", small(angle)) },
            match (last, principal.moments[k]) {
                ("r", _) => significant(center[k], digits),
                (_, moment) if moment < 0.0 => "-".to_owned(),
                (_, moment) => significant((moment / mass).sqrt(), digits),
            },
        ]);
    }
    table.text()
}

/// Degrees with four places, or with a digit where they would be none; less than rounding leaves is nothing.
fn small(degrees: f64) -> String {
    const ROUNDING: f64 = 1e-12;
    if (ROUNDING..5e-5).contains(&degrees) { significant(degrees, 1) } else { format!("{degrees:.4}") }
}

fn existence(report: &mut Report, given: &GivenPart) {
    report.line(match given.part.properties.existence() {
        Existence::Solid => {
            "the part can exist: about its centre of mass each moment is less than the sum of the others".to_owned()
        }
        Existence::Flat => {
            "the part can exist and is flat: about its centre of mass the largest moment is the sum of the others"
                .to_owned()
        }
        Existence::Impossible(inequality) => {
            format!("the part cannot exist: about its centre of mass {inequality} ({})", given.part.units.moment())
        }
    });
}
