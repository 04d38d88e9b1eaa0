//! The curves that a document lists, against those that follow from the certificate.

use bifdiag_schema::{AtlasDocument, CertificateDocument, CurveDocument, CurveKind};

use crate::Refused;
use crate::equilibria::pieces::{Branch, Piece, Pieces};
use crate::equilibria::spaces::Spaces;

/// Checks that every curve is listed once and at its place, its kind, its multiplicity and the curves on which it runs, and
/// the names of the curves at each cusp.
pub(crate) fn curves(
    document: &AtlasDocument,
    certificate: &CertificateDocument,
    spaces: &Spaces,
    pieces: &Pieces,
) -> Result<(), Refused> {
    let mut expected: Vec<Course> = pieces.list.iter().map(|piece| Course::of(spaces, piece)).collect();
    for (plus, id) in [(true, "P+"), (false, "P-")] {
        // A pole line that runs on critical lines is listed beside them.
        let on = |piece: &&Piece| piece.critical && piece.branch == Branch::Line(plus);
        let pieces: Vec<String> = pieces.list.iter().filter(on).map(|piece| piece.id.clone()).collect();
        if !pieces.is_empty() {
            let kind = if plus { CurveKind::PolePlus } else { CurveKind::PoleMinus };
            expected.push(Course { id: id.to_owned(), kind, multiplicity: 1, coincides_with: pieces });
        }
    }
    let listed: Vec<Course> = document.curves.iter().map(Course::listed).collect();
    if expected.len() != listed.len() {
        return Err(Refused::Field { field: "the number of curves" });
    }
    if let Some(course) = listed.iter().zip(&expected).find_map(|(listed, course)| (listed != course).then_some(course))
    {
        return Err(Refused::UnknownCurve { id: course.id.clone() });
    }
    for (number, cusp) in certificate.cusps.iter().enumerate() {
        let named = cusp.curves.iter().map(|id| pieces.find(id)).collect::<Result<Vec<usize>, _>>()?;
        if named != pieces.at_cusp(number) {
            return Err(Refused::BadPlace { what: "cusp", number });
        }
    }
    Ok(())
}

/// What a document says of a curve.
#[derive(PartialEq)]
struct Course {
    id: String,
    kind: CurveKind,
    multiplicity: u32,
    coincides_with: Vec<String>,
}

impl Course {
    fn listed(document: &CurveDocument) -> Self {
        let coincides_with = document.coincides_with.clone();
        Self { id: document.id.clone(), kind: document.kind, multiplicity: document.multiplicity, coincides_with }
    }

    fn of(spaces: &Spaces, piece: &Piece) -> Self {
        let kind = match piece.branch {
            Branch::Generic(_) => CurveKind::Generic,
            Branch::Line(_) if piece.critical => CurveKind::Axis,
            Branch::Line(true) => CurveKind::PolePlus,
            Branch::Line(false) => CurveKind::PoleMinus,
            Branch::Over(base) | Branch::Rotation(base) => match spaces.list[base].axes.len() {
                1 => CurveKind::Pair,
                2 => CurveKind::Circle,
                _ => CurveKind::Sphere,
            },
        };
        let line = |plus| if plus { "P+" } else { "P-" }.to_owned();
        let coincides_with = match piece.branch {
            Branch::Line(plus) if piece.critical => vec![line(plus)],
            _ => Vec::new(),
        };
        let multiplicity = if kind == CurveKind::Pair { 2 } else { 1 };
        Self { id: piece.id.clone(), kind, multiplicity, coincides_with }
    }
}
