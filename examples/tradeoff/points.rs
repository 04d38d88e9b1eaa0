//! Points with the truth about them, as `data/oracles/campaign_points.py` writes them: one line for each body.

use std::path::Path;

use bifdiag_body::{Body, Number};
use bifdiag_diagram::topology::{Component, latitude};
use serde::Deserialize;

use super::Failure;

/// The bodies of `atlas` and `polylines`.
pub const BODIES: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/data/tradeoff/points.jsonl");

#[derive(Deserialize)]
struct Line {
    stratum: String,
    #[serde(rename = "A")]
    moments: [String; 3],
    #[serde(rename = "r")]
    center: [String; 3],
    l: String,
    points: Vec<PointLine>,
}

#[derive(Deserialize)]
struct PointLine {
    distance: Option<String>,
    h: String,
    critical: usize,
    euler: i64,
    poles: Option<[bool; 2]>,
    middle: Option<f64>,
}

/// A body at one l, and points there.
pub struct Asked {
    pub stratum: String,
    pub body: Body,
    pub l: Number,
    points: Vec<PointLine>,
}

/// A point and the truth about it.
pub struct Point<'a> {
    pub body: &'a Body,
    /// Relative distance from a curve, as text; empty: random.
    pub distance: &'a str,
    pub h: Number,
    pub l: &'a Number,
    /// How many relative equilibria lie below h.
    pub equilibria_below: usize,
    pub euler: i64,
    pub poles: Option<[bool; 2]>,
    /// The components of U_hl; `None` where no double lies well inside of the region at this l, or the sweep refuses.
    pub truth: Option<Vec<Component>>,
}

/// All bodies of a file.
pub fn read(path: impl AsRef<Path>) -> Result<Vec<Asked>, Failure> {
    std::fs::read_to_string(path)?.lines().map(asked).collect()
}

fn asked(line: &str) -> Result<Asked, Failure> {
    let line: Line = serde_json::from_str(line)?;
    let body = Body::parse(&line.moments, &line.center)?;
    Ok(Asked { stratum: line.stratum, body, l: line.l.parse()?, points: line.points })
}

impl Asked {
    /// The distances of the points, in their order.
    pub fn distances(&self) -> impl Iterator<Item = &str> {
        self.points.iter().map(|point| point.distance.as_deref().unwrap_or_default())
    }

    /// The points.
    pub fn points(&self) -> Result<Vec<Point<'_>>, Failure> {
        self.points.iter().map(|line| self.point(line)).collect()
    }

    fn point<'a>(&'a self, line: &'a PointLine) -> Result<Point<'a>, Failure> {
        let truth = match line.middle {
            Some(middle) => swept(&self.body, middle, self.l.to_f64()),
            // Below the minimum nothing is accessible.
            None => (line.critical == 0).then(Vec::new),
        };
        Ok(Point {
            body: &self.body,
            distance: line.distance.as_deref().unwrap_or_default(),
            h: line.h.parse()?,
            l: &self.l,
            equilibria_below: line.critical,
            euler: line.euler,
            poles: line.poles,
            truth,
        })
    }
}

/// What the latitude sweep proves of a point of doubles.
pub fn swept(body: &Body, h: f64, l: f64) -> Option<Vec<Component>> {
    let frame = body.frame();
    latitude::components(&frame, h / frame.energy_unit, l / frame.momentum_unit).ok()
}

impl Point<'_> {
    /// The Euler characteristic and the poles are those that Morse theory counts.
    pub fn admits(&self, found: &[Component]) -> bool {
        let euler: i64 = found.iter().map(|component| 2 - i64::from(component.boundary_circles)).sum();
        let inside = |pole: fn(&Component) -> Option<bool>| found.iter().any(|component| pole(component) == Some(true));
        let poles = [inside(|c| c.poles.map(|p| p.plus)), inside(|c| c.poles.map(|p| p.minus))];
        euler == self.euler && self.poles.is_none_or(|expected| expected == poles)
    }
}
