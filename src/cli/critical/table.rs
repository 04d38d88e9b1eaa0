//! Relative equilibria at many l, or at one spin, as columns.

use bifdiag_body::part::Spin;
use bifdiag_body::{Body, Number};
use bifdiag_documents::Subject;
use bifdiag_documents::codes::{self, Branches, MULTIPLICITIES, place};
use bifdiag_equilibria::critical::{CriticalError, Equilibria, RelativeEquilibria};
use bifdiag_equilibria::permanent::angle_between;
use bifdiag_schema::{
    Multiplicity, NonlinearVerdict, Reason, SCHEMA_VERSION, SpinDocument, Stability, SteadyAxesDocument, Verdict,
};
use serde::Serialize;

use super::spins::spin_at;
use crate::cli::export::{Columns, Values};
use crate::cli::failure::{Failure, failed};
use crate::cli::input::Numbers;
use crate::cli::spin::that_can_be_given;

/// What is said where there is no answer.
pub const NOT_FOUND: &str = "the relative equilibria could not be found";

/// An l beyond f64 is wrong input.
pub fn not_found(error: CriticalError) -> Failure {
    match error {
        CriticalError::Momentum(error) => Failure::input(format!("--l: {error}")),
        error => failed(NOT_FOUND)(error),
    }
}

/// A spin beyond f64 is wrong input.
pub fn no_axes_at(subject: &Subject, spin: &Spin, error: CriticalError) -> Failure {
    match error {
        CriticalError::Spin { smallest, largest, spin: asked } => {
            let size = if asked < smallest { "slow" } else { "fast" };
            let [smallest, largest] = [smallest, largest].map(|omega| that_can_be_given(subject, omega));
            Failure::input(format!(
                "--spin {spin} is too {size} for this body in f64; use a spin from {smallest} to {largest} rad/s, or 0"
            ))
        }
        error => failed(NOT_FOUND)(error),
    }
}

/// What the codes in the columns mean.
#[derive(Serialize)]
struct Meta<'a> {
    schema_version: &'a str,
    #[serde(rename = "A")]
    moments: [&'a str; 3],
    #[serde(rename = "r")]
    center: [&'a str; 3],
    /// The momenta: first, last, number.
    #[serde(skip_serializing_if = "Option::is_none")]
    l: Option<(&'a str, &'a str, u32)>,
    #[serde(skip_serializing_if = "Option::is_none")]
    spin: Option<SpinDocument>,
    stability: &'static [Stability],
    stable: &'static [Verdict],
    verdict: &'static [NonlinearVerdict],
    why: &'static [Reason],
    multiplicity: [Multiplicity; 4],
    branches: Vec<(String, String)>,
    eigenvalue_error: f64,
    error_bound: f64,
    complete: bool,
}

#[derive(Default)]
struct Rows {
    index_of_l: Vec<i32>,
    l: Vec<f64>,
    h: Vec<f64>,
    gamma: Vec<[f64; 3]>,
    omega: Vec<f64>,
    index: Vec<i8>,
    multiplicity: Vec<i8>,
    stability: Vec<i8>,
    stable: Vec<i8>,
    verdict: Vec<i8>,
    why: Vec<i8>,
    survives_friction: Vec<i8>,
    eigenvalues: Vec<f64>,
    branch: Vec<i32>,
    branches: Branches,
    eigenvalue_error: f64,
    error_bound: f64,
    incomplete: bool,
}

/// All equilibria at all momenta of a range.
pub fn at_momenta(body: &Body, [from, to]: [&Number; 2], count: u32) -> Result<Columns, Failure> {
    let prepared = RelativeEquilibria::new(body).map_err(failed(NOT_FOUND))?;
    let mut rows = Rows::default();
    for k in 0..count {
        let l = Numbers::at([from, to], count, k);
        rows.extend(&prepared.at(&l).map_err(not_found)?, k, Some(l.to_f64()));
    }
    let numbers = ("l_index", Values::Int32(std::mem::take(&mut rows.index_of_l)));
    Ok(rows.columns(body, Some((from.text(), to.text(), count)), None, [numbers], [])?)
}

/// All steady axes at a spin.
pub fn at_spin(body: &Body, document: &SteadyAxesDocument, found: &Equilibria) -> Result<Columns, Failure> {
    let mut rows = Rows::default();
    rows.extend(found, 0, None);
    let axes = ("axis", Values::vectors(document.axes.iter().map(|axis| axis.axis)));
    let folds = ("fold", Values::Int8(document.axes.iter().map(|axis| i8::from(axis.fold)).collect()));
    Ok(rows.columns(body, None, Some(document.spin), [axes], [folds])?)
}

/// All steady axes at all spins of a range.
pub fn at_spins(subject: &Subject, ends: [&Spin; 2], count: u32) -> Result<Columns, Failure> {
    let body = &subject.body;
    let prepared = RelativeEquilibria::new(body).map_err(failed(NOT_FOUND))?;
    let (mut rows, mut rpm, mut axes, mut angles) = (Rows::default(), Vec::new(), Vec::new(), Vec::new());
    for k in 0..count {
        let spin = spin_at(ends, count, k);
        let omega = spin.exact_rad_per_s() * subject.unit_of_time();
        let found = prepared.at_spin(&omega).map_err(|error| no_axes_at(subject, &spin, error))?;
        for point in &found.list {
            rpm.push(spin.in_rpm());
            let up = point.gamma.map(|x| 0.0 - x);
            axes.push(subject.to_given(up));
            angles.push(from_center(body, up));
        }
        rows.extend(&found, k, None);
    }
    let before = [
        ("spin_index", Values::Int32(std::mem::take(&mut rows.index_of_l))),
        ("spin_rpm", Values::floats(rpm.into_iter())),
        ("axis", Values::vectors(axes.into_iter())),
        ("angle_deg", Values::floats(angles.into_iter())),
    ];
    Ok(rows.columns(body, None, None, before, [])?)
}

/// The angle in degrees from the centre of mass to the end of an axis that points up, in principal axes: 0 for a
/// standing body, 180 for a hanging one; NaN without weight.
pub fn from_center(body: &Body, up: [f64; 3]) -> f64 {
    /// Coordinates of γ are rounded: a smaller angle, in radians, counts as 0.
    const ROUNDING: f64 = 4.0 * f64::EPSILON;
    if body.is_euler() {
        return f64::NAN;
    }
    match angle_between(body.center_f64(), up) {
        angle if angle < ROUNDING => 0.0,
        angle if std::f64::consts::PI - angle < ROUNDING => 180.0,
        angle => angle.to_degrees(),
    }
}

impl Rows {
    /// Adds the equilibria of question `k`, at l as it was given.
    fn extend(&mut self, found: &Equilibria, k: u32, l: Option<f64>) {
        self.error_bound = self.error_bound.max(found.error_bound);
        self.incomplete |= !found.complete;
        for point in &found.list {
            self.index_of_l.push(k.cast_signed());
            self.l.push(l.unwrap_or(point.l));
            self.h.push(point.h);
            self.gamma.push(point.gamma);
            self.omega.push(point.omega);
            self.index.push(point.index.cast_signed());
            self.multiplicity.push(codes::multiplicity(point.multiplicity));
            let nonlinear = bifdiag_documents::nonlinear(&point.nonlinear);
            let stability = point.stability.term();
            self.stability.push(place(Stability::ALL, &stability));
            self.stable.push(place(Verdict::ALL, &Verdict::of(&nonlinear, stability)));
            self.verdict.push(place(NonlinearVerdict::ALL, &nonlinear.verdict));
            self.why.push(place(Reason::ALL, &nonlinear.why));
            self.survives_friction.push(i8::from(point.friction.survives == Some(true)));
            self.eigenvalues.extend(point.eigenvalues.pairs.as_flattened());
            self.eigenvalue_error = self.eigenvalue_error.max(point.eigenvalues.error);
            self.branch.push(self.branches.code(point));
        }
    }

    /// The table, between columns of the question's own.
    fn columns<const N: usize, const M: usize>(
        self,
        body: &Body,
        l: Option<(&str, &str, u32)>,
        spin: Option<SpinDocument>,
        before: [(&'static str, Values); N],
        after: [(&'static str, Values); M],
    ) -> Result<Columns, serde_json::Error> {
        let meta = Meta {
            schema_version: SCHEMA_VERSION,
            moments: body.moments().each_ref().map(Number::text),
            center: body.center().each_ref().map(Number::text),
            l,
            spin,
            stability: Stability::ALL,
            stable: Verdict::ALL,
            verdict: NonlinearVerdict::ALL,
            why: Reason::ALL,
            multiplicity: MULTIPLICITIES,
            branches: self.branches.0,
            eigenvalue_error: self.eigenvalue_error,
            error_bound: self.error_bound,
            complete: !self.incomplete,
        };
        let ids: Vec<&str> = meta.branches.iter().map(|(id, _)| id.as_str()).collect();
        let eigenvalues = Values::of_parts(&["1_re", "1_im", "2_re", "2_im"], self.eigenvalues.into_iter());
        let common = [
            ("l", Values::floats(self.l.into_iter())),
            ("h", Values::floats(self.h.into_iter())),
            ("gamma", Values::vectors(self.gamma.into_iter())),
            ("omega", Values::floats(self.omega.into_iter())),
            ("index", Values::Int8(self.index)),
            ("multiplicity", Values::words(&meta.multiplicity, Values::Int8(self.multiplicity))?),
            ("stability", Values::words(&meta.stability, Values::Int8(self.stability))?),
            ("stable", Values::words(&meta.stable, Values::Int8(self.stable))?),
            ("verdict", Values::words(&meta.verdict, Values::Int8(self.verdict))?),
            ("why", Values::words(&meta.why, Values::Int8(self.why))?),
            ("survives_friction", Values::Int8(self.survives_friction)),
            ("eigenvalues", eigenvalues),
            ("branch", Values::words(&ids, Values::Int32(self.branch))?),
        ];
        Columns::new(before.into_iter().chain(common).chain(after), &meta)
    }
}
