//! The Poincaré section at one point, orbit by orbit, and the motion behind each orbit.

use std::sync::atomic::AtomicBool;

use bifdiag::documents::SectionPlace;
use bifdiag::dynamics::integrator::DEFAULT_TOLERANCE;
use bifdiag::dynamics::motion::{MotionOptions, follow};
use bifdiag::dynamics::section::chaos::ChaosOptions;
use bifdiag::dynamics::section::{
    Monitor, OrbitSection, Portrait, PortraitOptions, SectionChart, SectionLine, SweepOptions, TorusPoint, sweep,
};
use bifdiag::{SectionSetting, documents};
use serde::Serialize;
use wasm_bindgen::prelude::*;

use crate::body::{Refused, body, number, rows};

/// Numbers of a crossing.
const ROW: usize = 13;

/// A body and a point (h, l) that have a section.
#[wasm_bindgen]
pub struct Section {
    setting: SectionSetting,
}

/// The picture behind the orbits: everything as (ψ', ϑ') on T⁻ and T⁺.
#[derive(Serialize)]
struct PortraitPicture {
    /// Loops whose odd inside is accessible.
    accessible: Vec<Vec<[f64; 2]>>,
    /// Likewise where Ṡ < 0, on T⁻ and T⁺.
    incoming: [Vec<Vec<[f64; 2]>>; 2],
    /// ∂U.
    boundary: Vec<Vec<[f64; 2]>>,
    /// Ṡ = 0, on T⁻ and T⁺.
    tangency: [Vec<Vec<[f64; 2]>>; 2],
    /// ∂U again, as vectors γ.
    sphere: Vec<Vec<[f64; 3]>>,
}

#[wasm_bindgen]
impl Section {
    /// At a point.
    ///
    /// # Errors
    /// A body or numbers that are none, and points without a section; the message says why.
    #[wasm_bindgen(constructor)]
    pub fn new(text: &str, h: &str, l: &str) -> Result<Self, JsError> {
        Ok(Self { setting: setting(text, h, l)? })
    }

    /// e_x', e_y', r̂: the axes of the PP-torus.
    #[must_use]
    pub fn axes(&self) -> Vec<f64> {
        self.setting.torus().axes().concat()
    }

    /// Starts as the command line spreads them: ϑ', ψ', sheet of each.
    ///
    /// # Errors
    /// A component that is too small for `f64`.
    pub fn starts(&self, count: u32, seed: u32) -> Result<Vec<f64>, JsError> {
        let starts = self.setting.spread(count as usize, u64::from(seed)).map_err(Refused::from)?;
        Ok(starts.iter().flat_map(|start| [start.theta, start.psi, f64::from(start.sheet)]).collect())
    }

    /// Follows orbits; a row for each crossing: orbit (counted from `first`), index, time, γ, l, sheet, Ṡ, ϑ', ψ'.
    ///
    /// # Errors
    /// Starts that are not accessible.
    pub fn follow(&self, starts: &[f64], first: u32, crossings: u32) -> Result<Vec<f64>, JsError> {
        let orbits = self.orbits(starts, crossings)?;
        let mut rows = Vec::with_capacity(ROW * orbits.iter().map(|orbit| orbit.points.len()).sum::<usize>());
        for point in orbits.iter().flat_map(|orbit| &orbit.points) {
            let [g1, g2, g3] = point.gamma;
            let [l1, l2, l3] = point.l;
            let (orbit, index, sheet) =
                (f64::from(first + point.orbit), f64::from(point.index), f64::from(point.sheet));
            let row: [f64; ROW] =
                [orbit, index, point.time, g1, g2, g3, l1, l2, l3, sheet, point.s_dot, point.theta, point.psi];
            rows.extend_from_slice(&row);
        }
        Ok(rows)
    }

    /// Verdicts on orbits, and what they rest on: JSON, the `orbits` of the section's document.
    ///
    /// # Errors
    /// Starts that are not accessible.
    pub fn judge(&self, starts: &[f64], crossings: u32) -> Result<String, JsError> {
        Ok(self.judged(starts, crossings)?)
    }

    /// What the two halves look like before any orbit: JSON with accessible, incoming, boundary, tangency, sphere.
    ///
    /// # Errors
    /// None at a point that has a section.
    pub fn portrait(&self, rows: u32) -> Result<String, JsError> {
        Ok(self.picture(rows)?)
    }

    /// The number of the component of U in which each γ lies; −1 where that could not be proved.
    ///
    /// # Errors
    /// Numbers that are no triples.
    pub fn components(&self, gammas: &[f64]) -> Result<Vec<i32>, JsError> {
        let gammas: Vec<[f64; 3]> = rows("a list of γ", gammas)?.collect();
        let found = self.setting.components_at(&gammas);
        Ok(found.into_iter().map(|part| part.and_then(|part| i32::try_from(part).ok()).unwrap_or(-1)).collect())
    }

    /// The motion from a point of the section at rising times; a row for each: time, γ, l, ω, ϑ, ψ, φ, q (w, x, y, z).
    ///
    /// # Errors
    /// A start that is not accessible; times that fall.
    pub fn motion(&self, theta: f64, psi: f64, sheet: i8, times: &[f64]) -> Result<Vec<f64>, JsError> {
        let torus = self.setting.torus();
        let start = self.setting.state(TorusPoint { theta, psi, sheet }).map_err(Refused::from)?;
        let never = AtomicBool::new(false);
        let options = MotionOptions { tolerance: DEFAULT_TOLERANCE, phi: 0.0, stop: &never };
        let motion = follow(torus.top(), &start, times, &options).map_err(Refused::from)?;
        let mut numbers = Vec::with_capacity(17 * motion.samples.len());
        for sample in motion.samples {
            numbers.push(sample.time);
            numbers.extend(sample.gamma.into_iter().chain(sample.l).chain(sample.omega));
            numbers.extend([sample.theta, sample.psi, sample.phi]);
            numbers.extend(sample.attitude.components());
        }
        Ok(numbers)
    }
}

impl Section {
    fn orbits(&self, starts: &[f64], crossings: u32) -> Result<Vec<OrbitSection>, Refused> {
        let mut states = Vec::new();
        for start in points(starts)? {
            states.push(self.setting.state(start)?);
        }
        Ok(sweep(self.setting.torus(), &states, &options(crossings), &Monitor::default())?)
    }

    fn judged(&self, starts: &[f64], crossings: u32) -> Result<String, Refused> {
        let starts: Vec<TorusPoint> = points(starts)?.collect();
        let monitor = Monitor::default();
        let mut section = self.setting.run(&starts, None, &options(crossings), &monitor)?;
        self.setting.measure(&mut section, &ChaosOptions::default(), &monitor)?;
        json(&documents::section(&self.setting.body().clone().into(), &section, SectionPlace::Point).orbits)
    }

    fn picture(&self, rows: u32) -> Result<String, Refused> {
        let setting = &self.setting;
        let options = PortraitOptions { rows: rows as usize, ..PortraitOptions::default() };
        let portrait = Portrait::new(setting.body(), setting.h(), setting.l(), &options)?;
        let lines = |lines: &[SectionLine]| {
            lines.iter().flat_map(|line| portrait.in_chart(SectionChart::Torus, line)).collect()
        };
        json(&PortraitPicture {
            accessible: portrait.accessible(SectionChart::Torus).loops,
            incoming: [-1, 1].map(|sheet| portrait.incoming(SectionChart::Torus, sheet).loops),
            boundary: lines(portrait.boundary()),
            tangency: [-1, 1].map(|sheet| lines(portrait.tangency(sheet))),
            sphere: portrait.boundary().iter().map(|line| line.points.clone()).collect(),
        })
    }
}

fn setting(text: &str, h: &str, l: &str) -> Result<SectionSetting, Refused> {
    Ok(SectionSetting::new(&body(text)?, &number("h", h)?, &number("l", l)?)?)
}

/// Points of the torus from ϑ', ψ', sheet of each.
fn points(numbers: &[f64]) -> Result<impl Iterator<Item = TorusPoint> + '_, Refused> {
    let point = |[theta, psi, sheet]: [f64; 3]| TorusPoint { theta, psi, sheet: if sheet < 0.0 { -1 } else { 1 } };
    Ok(rows("a list of starts", numbers)?.map(point))
}

fn options(crossings: u32) -> SweepOptions {
    SweepOptions { crossings: crossings as usize, ..SweepOptions::default() }
}

fn json(value: &impl Serialize) -> Result<String, Refused> {
    bifdiag::schema::json(value).map_err(|error| Refused::Json(error.to_string()))
}
