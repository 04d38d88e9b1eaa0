//! `data/tradeoff/points.jsonl`.

use serde::Deserialize;
use top::body::{Body, Number};
use top::topology::{Component, latitude};

use super::Failure;

#[derive(Deserialize)]
struct Line {
    stratum: String,
    distance: Option<f64>,
    #[serde(rename = "A")]
    moments: [String; 3],
    #[serde(rename = "r")]
    center: [String; 3],
    h: String,
    l: String,
    critical: [usize; 2],
    middle: Option<f64>,
}

/// A point of a body and the truth about it.
pub struct Point {
    pub stratum: String,
    /// Relative distance from a curve; `None`: random.
    pub distance: Option<f64>,
    pub body: Body,
    pub h: Number,
    pub l: Number,
    /// How many relative equilibria lie below h.
    pub equilibria_below: usize,
    /// The components of U_hl; `None` where no double lies in the region at this l, or the sweep refuses.
    pub truth: Option<Vec<Component>>,
}

/// Every nth point.
pub fn read(nth: usize) -> Result<Vec<Point>, Failure> {
    let text = std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/data/tradeoff/points.jsonl"))?;
    text.lines().step_by(nth).map(|line| point(serde_json::from_str(line)?)).collect()
}

fn point(line: Line) -> Result<Point, Failure> {
    let body = Body::parse(&line.moments, &line.center)?;
    let (h, l): (Number, Number) = (line.h.parse()?, line.l.parse()?);
    let frame = body.frame();
    let below = line.critical[0];
    let truth = match line.middle {
        Some(middle) => latitude::components(&frame, middle / frame.energy_unit, l.to_f64() / frame.momentum_unit).ok(),
        // The lowest curve is that of the minimum.
        None => (below == 0).then(Vec::new),
    };
    Ok(Point { stratum: line.stratum, distance: line.distance, body, h, l, equilibria_below: below, truth })
}
