//! U on the Poisson sphere.

use documents::Subject;
use plot::Width;
use top::body::{Body, Number};

use super::figure::Figure;
use crate::cli::input::values::Vector;
use crate::cli::sphere::{Site, draw};

/// A picture of U at one point of a body.
struct Sphere {
    stem: &'static str,
    moments: [&'static str; 3],
    center: [&'static str; 3],
    h: &'static str,
    l: &'static str,
    view: Option<Vector>,
}

const SPHERES: [Sphere; 3] = [
    Sphere {
        stem: "sphere-two-discs",
        moments: ["2", "1.1", "1"],
        center: ["0.94868", "0", "0.61623"],
        h: "4.45",
        l: "3.25",
        view: None,
    },
    Sphere {
        stem: "sphere-annulus",
        moments: ["2", "2", "1"],
        center: ["1", "0", "0"],
        h: "3.4",
        l: "2.87",
        view: None,
    },
    Sphere {
        stem: "sphere-four-circles",
        moments: ["1", "1.05", "2.02"],
        center: ["0.0001", "0.0665", "1"],
        h: "1.79332",
        l: "1.7862",
        view: Some(Vector([0.0, 0.0, -1.0])),
    },
];

pub fn figures() -> impl Iterator<Item = Figure> {
    SPHERES.iter().filter_map(|sphere| {
        let body = Body::parse(&sphere.moments, &sphere.center).ok()?;
        let subject = Subject::from(body);
        let [h, l] = [sphere.h, sphere.l].map(|text| text.parse::<Number>().ok());
        let site = Site { region: None, h: h?, l: l? };
        Some(Figure {
            stem: sphere.stem,
            draw: Box::new(move |_, theme| Ok(draw(&subject, &site, sphere.view.as_ref(), theme, Width::Page)?.0)),
        })
    })
}
