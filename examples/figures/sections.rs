//! The Poincaré sections of the paper.

use std::error::Error;

use bifdiag_body::{Body, Preset};
use bifdiag_dynamics::field::State;
use bifdiag_dynamics::section::chaos::{ChaosOptions, OrbitVerdict, chaos_measures};
use bifdiag_dynamics::section::{
    Monitor, OrbitSection, Portrait, PortraitOptions, SectionCondition, SectionError, SweepOptions, TorusPoint, sweep,
};
use bifdiag_plot::{OrbitColors, OrbitFamilies, Picture, Projection, SectionOptions, SectionScene, draw_section_rows};

use crate::figure::{Figure, THEME};
use crate::typical::{orbit, typical_orbits};

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
    /// The same, and the caption counts their verdicts.
    Judged,
    /// The one through this ϑ', ψ', sheet.
    Through(f64, f64, i8),
}

/// Every region of Kovalevskaya's top with a section of it.
const KOVALEVSKAYA: &str = "section-kovalevskaya";

/// Sections of the paper's body on the torus, to which the figures add what is theirs.
const PAPER: Sections =
    Sections { stem: "", body: "paper", condition: SectionCondition::Height, projection: Projection::Torus, rows: &[] };

const FIGURES: [Sections; 7] = [
    Sections {
        stem: "section-projections",
        body: "kovalevskaya",
        projection: Projection::Sphere,
        rows: &[Row { h: 3.4, l: 2.87, caption: "M²₃", orbits: Orbits::None }],
        ..PAPER
    },
    Sections {
        stem: "section-sphere-and-torus",
        body: "projections",
        projection: Projection::Both,
        rows: &[Row { h: 80.5, l: 12.80, caption: "M²₃", orbits: Orbits::Through(0.5, 0.78, 1) }],
        ..PAPER
    },
    Sections {
        stem: "section-structure-1",
        rows: &[
            Row { h: 1.8, l: 3.25, caption: "R1,  S²", orbits: Orbits::Typical },
            Row { h: 2.6, l: 3.25, caption: "R2,  T²", orbits: Orbits::Typical },
            Row { h: 3.8, l: 3.25, caption: "R5,  S²+T²", orbits: Orbits::Typical },
            Row { h: 4.45, l: 3.25, caption: "R8,  T²+T²", orbits: Orbits::Typical },
        ],
        ..PAPER
    },
    Sections {
        stem: "section-structure-2",
        rows: &[
            Row { h: 4.675, l: 3.25, caption: "R7,  M²₃", orbits: Orbits::Typical },
            Row { h: 5.3, l: 3.25, caption: "R3,  M²₂", orbits: Orbits::Typical },
            Row { h: 6.5, l: 3.25, caption: "R4,  T²", orbits: Orbits::Typical },
        ],
        ..PAPER
    },
    Sections {
        stem: "section-structure-3",
        rows: &[
            Row { h: 3.1486, l: 2.72, caption: "R6,  M²₂", orbits: Orbits::Typical },
            Row { h: 14.0, l: 7.2, caption: "R9,  S²+S²", orbits: Orbits::Typical },
        ],
        ..PAPER
    },
    Sections {
        stem: KOVALEVSKAYA,
        body: "kovalevskaya",
        rows: &[
            Row { h: 0.5, l: 1.0, caption: "R1,  T²", orbits: Orbits::Judged },
            Row { h: 4.4, l: 1.9, caption: "R2,  T²", orbits: Orbits::Judged },
            Row { h: 1.7976, l: 1.8042, caption: "R3,  M²₃", orbits: Orbits::Judged },
            Row { h: 2.8, l: 2.45, caption: "R4,  M²₃", orbits: Orbits::Judged },
        ],
        ..PAPER
    },
    Sections {
        stem: "section-earlier-condition",
        condition: SectionCondition::AngularMomentum,
        projection: Projection::Sphere,
        rows: &[Row { h: 4.45, l: 3.25, caption: "", orbits: Orbits::Typical }],
        ..PAPER
    },
];

pub fn figures() -> impl Iterator<Item = Figure> {
    FIGURES.iter().map(|sections| Figure { stem: sections.stem, draw: Box::new(|| draw(sections)) })
}

fn body(name: &str) -> Option<Body> {
    match name {
        // Fig. Projections12.
        "projections" => Body::parse(&["2", "1.5", "1"], &["1", "0", "0"]).ok(),
        name => Preset::find(name).map(Preset::body),
    }
}

fn draw(sections: &Sections) -> Result<Picture, Box<dyn Error>> {
    let body = body(sections.body).expect("a test looks up every body");
    let options = PortraitOptions { condition: sections.condition, ..PortraitOptions::default() };
    let mut parts = Vec::new();
    for row in sections.rows {
        let portrait = Portrait::new(&body, row.h, row.l, &options)?;
        let orbits = orbits(&portrait, row)?;
        let verdicts = if orbits.is_empty() { Vec::new() } else { verdicts(&portrait, &orbits)? };
        let caption = match row.orbits {
            Orbits::Judged => format!("{};  {}", row.caption, counted(&verdicts)),
            Orbits::None | Orbits::Typical | Orbits::Through(..) => row.caption.to_owned(),
        };
        let place = |verdict: &OrbitVerdict| match verdict {
            OrbitVerdict::Regular => 0,
            OrbitVerdict::Chaotic => 1,
            OrbitVerdict::Open(_) => 2,
        };
        parts.push((portrait, orbits, verdicts.iter().map(place).collect::<Vec<usize>>(), caption));
    }
    let scenes: Vec<SectionScene<'_>> = parts
        .iter()
        .map(|(portrait, orbits, of, caption)| SectionScene {
            portrait,
            orbits,
            values: None,
            families: Some(OrbitFamilies { of, names: &VERDICTS, colors: OrbitColors::Verdicts }),
            curves: None,
            caption,
        })
        .collect();
    let options = SectionOptions {
        projection: sections.projection,
        raster_above: 4000,
        theme: THEME,
        ..SectionOptions::default()
    };
    Ok(draw_section_rows(&scenes, &options)?)
}

fn orbits(portrait: &Portrait, row: &Row) -> Result<Vec<OrbitSection>, SectionError> {
    match row.orbits {
        Orbits::None => Ok(Vec::new()),
        Orbits::Typical | Orbits::Judged => typical_orbits(portrait),
        Orbits::Through(theta, psi, sheet) => {
            let state = portrait.torus().state(TorusPoint { theta, psi, sheet }, row.h, row.l)?;
            orbit(portrait, state, 0).map(|orbit| vec![orbit])
        }
    }
}

/// What verdicts are called.
const VERDICTS: [&str; 3] = ["regular", "chaotic", "undecided"];

/// Crossings after which orbits are judged: more than are drawn, since those near a separatrix turn slowly.
const JUDGED: usize = 6000;

/// Whether each orbit is regular.
fn verdicts(portrait: &Portrait, orbits: &[OrbitSection]) -> Result<Vec<OrbitVerdict>, SectionError> {
    let start = |orbit: &OrbitSection| orbit.points.first().map(|point| State { gamma: point.gamma, l: point.l });
    let starts: Vec<State> = orbits.iter().filter_map(start).collect();
    let options = SweepOptions { crossings: JUDGED, condition: portrait.condition(), ..SweepOptions::default() };
    let orbits = sweep(portrait.torus(), &starts, &options, &Monitor::default())?;
    let measures = chaos_measures(portrait.torus(), &orbits, &ChaosOptions::default(), &Monitor::default())?;
    Ok(measures.into_iter().map(|measure| measure.judgement.verdict).collect())
}

/// How many orbits are regular, chaotic and open.
fn counted(verdicts: &[OrbitVerdict]) -> String {
    let count = |is: fn(&OrbitVerdict) -> bool| verdicts.iter().filter(|verdict| is(verdict)).count();
    let counts = [
        (count(|verdict| *verdict == OrbitVerdict::Regular), "regular"),
        (count(|verdict| *verdict == OrbitVerdict::Chaotic), "chaotic"),
        (count(|verdict| matches!(verdict, OrbitVerdict::Open(_))), "open"),
    ];
    let counted = counts.into_iter().filter(|(count, _)| *count > 0);
    counted.map(|(count, word)| format!("{count} {word}")).collect::<Vec<_>>().join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;
    use bifdiag_diagram::atlas::Place;
    use bifdiag_diagram::topology::signature;
    use bifdiag_exact::Accuracy;
    use bifdiag_plot::section_type;

    /// Kovalevskaya's tori are known to be integrable.
    #[test]
    fn kovalevskayas_regions_have_a_section_each_and_its_orbits_are_regular() {
        let figure = FIGURES.iter().find(|figure| figure.stem == KOVALEVSKAYA).unwrap();
        let body = body(figure.body).unwrap();
        let atlas = bifdiag_exact::atlas(&body, Accuracy::Exact).unwrap();
        let mut shown = Vec::new();
        for row in figure.rows {
            let Place::Region(region) = atlas.locate(row.h, row.l).unwrap().place else { panic!("{}", row.caption) };
            shown.push(region);
            let portrait = Portrait::new(&body, row.h, row.l, &PortraitOptions::default()).unwrap();
            let verdicts = verdicts(&portrait, &typical_orbits(&portrait).unwrap()).unwrap();
            assert!(!verdicts.contains(&OrbitVerdict::Chaotic), "{}", row.caption);
            let regular = verdicts.iter().filter(|verdict| **verdict == OrbitVerdict::Regular).count();
            // Near a separatrix an orbit turns too slowly for a verdict.
            assert!(verdicts.len() >= 16 && 10 * regular >= 8 * verdicts.len(), "{}: {verdicts:?}", row.caption);
        }
        shown.sort();
        assert_eq!(shown, atlas.regions().ids().collect::<Vec<_>>());
    }

    #[test]
    fn captions_tell_the_regions() {
        for figure in FIGURES.iter().filter(|figure| figure.rows.iter().any(|row| row.caption.starts_with('R'))) {
            let atlas = bifdiag_exact::atlas(&body(figure.body).unwrap(), Accuracy::Exact).unwrap();
            for row in figure.rows {
                let Place::Region(region) = atlas.locate(row.h, row.l).unwrap().place else {
                    panic!("{}", row.caption)
                };
                let signature = signature(atlas.components(region).unwrap()).unwrap();
                assert_eq!(row.caption, format!("{region},  {}", section_type(&signature)), "{}", figure.stem);
            }
        }
    }

    #[test]
    fn every_body_exists() {
        for figure in &FIGURES {
            assert!(body(figure.body).is_some(), "{} is to show {}", figure.stem, figure.body);
        }
    }
}
