//! What the terminal shows of a part.

use std::path::PathBuf;

use bifdiag_body::part::Existence;
use bifdiag_numbers::vector::{dot, norm};
use bifdiag_schema::{PartDocument, PrincipalDocument};

use crate::cli::input::{GivenPart, shown};
use crate::cli::terminal::{Report, Table, significant};

/// Digits of moments, to be compared with those that a CAD program prints.
const DIGITS: usize = 9;

pub fn text(given: &GivenPart, document: &PartDocument, written: &[PathBuf]) -> String {
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
    let about_com = table(&document.principal_com, document, "radius of gyration");
    report
        .line(format!("about the centre of mass (what CAD prints), moments in {}, radii in {length}", units.moment()));
    report.line(about_com);
    report.line(format!("about the fixed point: the axes of A and r, r in {}", units.energy()));
    report.line(table(&document.principal, document, "r"));
    existence(&mut report, given);
    if !document.exact {
        report.line("the principal form is irrational: A and r are given to 130 digits, symmetries exactly");
    }
    report.written(written);
    report.text()
}

/// Moments and axes about a point, with the angle of each axis to the line from the fixed point to the centre of mass.
fn table(principal: &PrincipalDocument, document: &PartDocument, last: &'static str) -> String {
    let value = |text: &String| text.parse::<bifdiag_numbers::Number>().map_or(f64::NAN, |number| number.to_f64());
    let com = document.com.each_ref().map(value);
    let mass = value(&document.mass);
    let distance = norm(com);
    let mut table = Table::new(&["axis", "moment", "direction", "angle to com", last]);
    for k in 0..3 {
        let axis = principal.axes[k];
        let [x, y, z] = axis.map(|x| format!("{x:>9.6}"));
        let cosine = dot(axis, com).abs() / distance;
        table.row([
            (k + 1).to_string(),
            significant(principal.moments[k], DIGITS),
            format!("({x}, {y}, {z})"),
            if distance == 0.0 { "-".to_owned() } else { format!("{:.4}°", libm::acos(cosine.min(1.0)).to_degrees()) },
            if last == "r" {
                significant(value(&document.center[k]), DIGITS)
            } else {
                significant((principal.moments[k].max(0.0) / mass).sqrt(), DIGITS)
            },
        ]);
    }
    table.text()
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
