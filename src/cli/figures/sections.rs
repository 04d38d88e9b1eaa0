//! The Poincaré sections of the paper.

use dynamics::section::{OrbitSection, Portrait, PortraitOptions, SectionCondition, TorusPoint};
use plot::{OrbitFamilies, Picture, Projection, SectionOptions, SectionScene, Theme, draw_section_rows};
use top::body::{Body, Preset};

use super::error::FigureSection;
use super::figure::Figure;
use super::typical::{orbit, typical_orbits};
use crate::cli::export::ExportError;
use crate::cli::failure::Failure;
use crate::cli::section::families::{NAMES, families};
use crate::cli::terminal::Timings;

/// A figure of sections.
struct Sections {
    stem: &'static str,
    /// Name of the body.
    body: &'static str,
    condition: SectionCondition,
    projection: Projection,
    rows: &'static [Row],
}

/// One section.
struct Row {
    h: f64,
    l: f64,
    caption: &'static str,
    orbits: Orbits,
}

/// Which orbits are shown.
enum Orbits {
    None,
    /// Typical ones, that keep off each other.
    Typical,
    /// The one through this ϑ', ψ', sheet.
    Through(f64, f64, i8),
}

const FIGURES: [Sections; 6] = [
    Sections {
        stem: "section-projections",
        body: "kovalevskaya",
        condition: SectionCondition::Height,
        projection: Projection::Sphere,
        rows: &[Row { h: 3.4, l: 2.87, caption: "M²₃", orbits: Orbits::None }],
    },
    Sections {
        stem: "section-sphere-and-torus",
        body: "projections",
        condition: SectionCondition::Height,
        projection: Projection::Both,
        rows: &[Row { h: 80.5, l: 12.80, caption: "M²₃", orbits: Orbits::Through(0.5, 0.78, 1) }],
    },
    Sections {
        stem: "section-structure-1",
        body: "paper",
        condition: SectionCondition::Height,
        projection: Projection::Torus,
        rows: &[
            Row { h: 1.8, l: 3.25, caption: "S²", orbits: Orbits::Typical },
            Row { h: 2.6, l: 3.25, caption: "T²", orbits: Orbits::Typical },
            Row { h: 3.8, l: 3.25, caption: "S²+T²", orbits: Orbits::Typical },
            Row { h: 4.45, l: 3.25, caption: "T²+T²", orbits: Orbits::Typical },
        ],
    },
    Sections {
        stem: "section-structure-2",
        body: "paper",
        condition: SectionCondition::Height,
        projection: Projection::Torus,
        rows: &[
            Row { h: 4.675, l: 3.25, caption: "M²₃", orbits: Orbits::Typical },
            Row { h: 5.3, l: 3.25, caption: "M²₂", orbits: Orbits::Typical },
            Row { h: 6.5, l: 3.25, caption: "T²", orbits: Orbits::Typical },
        ],
    },
    Sections {
        stem: "section-structure-3",
        body: "paper",
        condition: SectionCondition::Height,
        projection: Projection::Torus,
        rows: &[
            Row { h: 3.1486, l: 2.72, caption: "M²₂", orbits: Orbits::Typical },
            Row { h: 14.0, l: 7.2, caption: "S²+S²", orbits: Orbits::Typical },
        ],
    },
    Sections {
        stem: "section-earlier-condition",
        body: "paper",
        condition: SectionCondition::AngularMomentum,
        projection: Projection::Sphere,
        rows: &[Row { h: 4.45, l: 3.25, caption: "", orbits: Orbits::Typical }],
    },
];

pub fn figures() -> impl Iterator<Item = Figure> {
    FIGURES
        .iter()
        .map(|sections| Figure { stem: sections.stem, draw: Box::new(|timings, theme| draw(sections, timings, theme)) })
}

fn body(name: &str) -> Option<Body> {
    match name {
        // Fig. Projections12.
        "projections" => Body::parse(&["2", "1.5", "1"], &["1", "0", "0"]).ok(),
        name => Preset::find(name).map(Preset::body),
    }
}

fn draw(sections: &Sections, timings: &Timings, theme: Theme) -> Result<Picture, Failure> {
    let body = body(sections.body).expect("a test looks up every body");
    let options = PortraitOptions { condition: sections.condition, ..PortraitOptions::default() };
    let mut parts = Vec::new();
    for row in sections.rows {
        let portrait = Portrait::new(&body, row.h, row.l, &options).map_err(FigureSection::from)?;
        let orbits = timings.stage(sections.stem, || orbits(&portrait, row))?;
        let families = families(&body, row.h, row.l, &orbits);
        parts.push((portrait, orbits, families));
    }
    let scenes: Vec<SectionScene<'_>> = parts
        .iter()
        .zip(sections.rows)
        .map(|((portrait, orbits, of), row)| SectionScene {
            portrait,
            orbits,
            values: None,
            families: Some(OrbitFamilies { of, names: &NAMES }),
            caption: row.caption,
        })
        .collect();
    let options =
        SectionOptions { projection: sections.projection, raster_above: 4000, theme, ..SectionOptions::default() };
    Ok(draw_section_rows(&scenes, &options).map_err(ExportError::from)?)
}

fn orbits(portrait: &Portrait, row: &Row) -> Result<Vec<OrbitSection>, FigureSection> {
    match row.orbits {
        Orbits::None => Ok(Vec::new()),
        Orbits::Typical => typical_orbits(portrait),
        Orbits::Through(theta, psi, sheet) => {
            let state = portrait.torus().state(TorusPoint { theta, psi, sheet }, row.h, row.l)?;
            orbit(portrait, state, 0).map(|orbit| vec![orbit])
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_body_exists() {
        for figure in &FIGURES {
            assert!(body(figure.body).is_some(), "{} is to show {}", figure.stem, figure.body);
        }
    }
}
