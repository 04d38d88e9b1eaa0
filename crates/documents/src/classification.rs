//! The type of a point as a document.

use bifdiag_diagram::arrangement::RegionId;
use bifdiag_diagram::atlas::Atlas;
use bifdiag_diagram::topology::{Answer, Classification, Margin};
use bifdiag_diagram::topology::{Component, signature};
use bifdiag_exact::Solver;
use bifdiag_numbers::Number;
use bifdiag_schema::{Accuracy, CandidateDocument, ClassificationDocument, ComponentDocument, MarginDocument, Status};

use crate::body::{given, head};
use crate::subject::Subject;

/// One component of U_hl.
#[must_use]
pub fn component(component: &Component) -> ComponentDocument {
    let poles = component.poles.map(|poles| {
        let signs = [(poles.plus, "+"), (poles.minus, "-")];
        signs.iter().filter(|(inside, _)| *inside).map(|(_, sign)| (*sign).to_owned()).collect()
    });
    ComponentDocument {
        boundary_circles: component.boundary_circles,
        poles,
        accessible_region: component.accessible_region(),
        energy_surface: component.energy_surface(),
        section: component.section(),
        genus: component.genus(),
    }
}

/// The components of U_hl.
#[must_use]
pub fn components(components: &[Component]) -> Vec<ComponentDocument> {
    components.iter().map(component).collect()
}

/// The distance to the nearest curve.
#[must_use]
pub fn margin(margin: &Margin) -> MarginDocument {
    let nearest = margin.nearest.map_or_else(String::new, |curve| curve.to_string());
    MarginDocument { h: margin.h, nearest, error_bound: margin.error_bound }
}

/// What is said where ids of regions are not those of the exact atlas.
const NUMBERED_OTHERWISE: &str = "regions are numbered as by bifdiag atlas --accuracy fast: f64 does not decide all events of this body, and \
     other answers may number them otherwise";

/// The answer for a point (h, l) of a body, with its regions if an atlas is prepared.
#[must_use]
pub fn classification(
    subject: &Subject,
    h: &Number,
    l: &Number,
    found: &Classification,
    accuracy: Accuracy,
    prepared: Option<&Solver>,
) -> ClassificationDocument {
    let body = &subject.body;
    let status = match found.answer {
        Answer::Regular(_) => Status::Regular,
        Answer::Forbidden => Status::Forbidden,
        Answer::Critical(_) => Status::Critical,
        Answer::Undecided(_) => Status::Undecided,
    };
    let (places, why_not) = match prepared.map(|prepared| prepared.places(h, l, &found.answer)) {
        Some(Ok(places)) => (Some(places), None),
        Some(Err(why)) if found.answer != Answer::Forbidden => (None, Some(why)),
        Some(Err(_)) | None => (None, None),
    };
    let region = match (&found.answer, places.as_deref()) {
        (Answer::Regular(_), Some([Some(region)])) => Some(region.to_string()),
        _ => None,
    };
    let euler = "r = 0: the poles ±r̂ do not exist and S vanishes identically, so P_hl is not defined";
    let unnamed = why_not.map(|why| format!("the ids of the regions are not known: {why}"));
    // Numbers depend on events that f64 does not decide.
    let is_numbered_otherwise = accuracy == Accuracy::Fast
        && found.answer != Answer::Forbidden
        && places.is_some()
        && prepared.and_then(Solver::atlas).is_some_and(|atlas| !atlas.arrangement().undecided.is_empty());
    let numbered = is_numbered_otherwise.then(|| NUMBERED_OTHERWISE.to_owned());
    let notes: Vec<String> =
        body.is_euler().then(|| euler.to_owned()).into_iter().chain(unnamed).chain(numbered).collect();
    let of_u = found.components();
    let command = subject.command("classify").option("h", h.text()).option("l", l.text());
    ClassificationDocument {
        head: head(
            command.option_if("accuracy", accuracy_option(accuracy)).flag("no-region", prepared.is_none()).json(),
        ),
        body: given(body),
        h: h.text().to_owned(),
        l: l.text().to_owned(),
        status,
        accuracy,
        region,
        margin: margin(&found.margin),
        signature: of_u.filter(|components| !components.is_empty()).and_then(signature),
        components: of_u.map(components),
        candidates: candidates(found, prepared.and_then(Solver::atlas).zip(places)),
        note: (!notes.is_empty()).then(|| notes.join("; ")),
        part: subject.part.clone(),
    }
}

/// The value of `--accuracy`, unless it is the default.
#[must_use]
pub fn accuracy_option(accuracy: Accuracy) -> Option<&'static str> {
    (accuracy == Accuracy::Fast).then_some("fast")
}

/// The regions that meet at a point; the classes where their regions are not known.
fn candidates(found: &Classification, located: Option<(&Atlas, Vec<Option<RegionId>>)>) -> Vec<CandidateDocument> {
    let classes = found.candidates();
    if classes.is_empty() {
        return Vec::new();
    }
    let candidate = |region: Option<RegionId>, class: &[Component]| CandidateDocument {
        region: region.map(|region| region.to_string()),
        status: if class.is_empty() { Status::Forbidden } else { Status::Regular },
        components: components(class),
    };
    let Some((atlas, places)) = located else {
        return classes.iter().map(|class| candidate(None, class)).collect();
    };
    let class = |region: Option<RegionId>| region.and_then(|region| atlas.components(region).ok()).unwrap_or_default();
    places.into_iter().map(|region| candidate(region, class(region))).collect()
}
