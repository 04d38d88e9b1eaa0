//! The type of a point as a document.

use numbers::Number;
use schema::{Accuracy, ClassificationDocument, ComponentDocument, MarginDocument, SCHEMA_VERSION, Status};
use top::body::Body;
use top::classify::{Answer, Classification, Margin};
use top::topology::{Component, signature};

use crate::body::texts;

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

/// The components of one class.
#[must_use]
pub fn candidate(components: &[Component]) -> Vec<ComponentDocument> {
    components.iter().map(component).collect()
}

/// The distance to the nearest curve.
#[must_use]
pub fn margin(margin: &Margin) -> MarginDocument {
    let nearest = margin.nearest.map_or_else(String::new, |curve| curve.to_string());
    MarginDocument { h: margin.h, nearest, error_bound: margin.error_bound }
}

/// The answer for a point (h, l) of a body.
#[must_use]
pub fn classification(
    body: &Body,
    h: &Number,
    l: &Number,
    found: &Classification,
    accuracy: Accuracy,
) -> ClassificationDocument {
    let status = match found.answer {
        Answer::Regular(_) => Status::Regular,
        Answer::Forbidden => Status::Forbidden,
        Answer::Critical(_) => Status::Critical,
        Answer::Undecided(_) => Status::Undecided,
    };
    let note = if found.unproved_topology {
        Some("the region is known, but its topology is not proved")
    } else if body.flags().euler {
        Some("r = 0: the poles ±r̂ do not exist and S vanishes identically, so P_hl is not defined")
    } else {
        None
    };
    let components = found.components();
    ClassificationDocument {
        schema_version: SCHEMA_VERSION.to_owned(),
        moments: texts(body.moments()),
        center: texts(body.center()),
        h: h.text().to_owned(),
        l: l.text().to_owned(),
        status,
        accuracy,
        margin: margin(&found.margin),
        signature: components.filter(|components| !components.is_empty()).and_then(signature),
        components: components.map(candidate),
        candidates: found.candidates().iter().map(|class| candidate(class)).collect(),
        note: note.map(str::to_owned),
        inertia: None,
    }
}
