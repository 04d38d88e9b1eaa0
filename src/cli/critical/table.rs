//! Relative equilibria at many l as columns.

use bifdiag_body::Body;
use bifdiag_equilibria::critical::{CriticalError, Multiplicity as Points, RelativeEquilibria};
use bifdiag_schema::{Multiplicity, Stability, Verdict};
use serde::Serialize;

use super::momenta::Momenta;
use crate::cli::export::{Columns, Values};
use bifdiag_body::Number;
use bifdiag_schema::SCHEMA_VERSION;

/// What the codes in the columns mean.
#[derive(Serialize)]
struct Meta<'a> {
    schema_version: &'a str,
    #[serde(rename = "A")]
    moments: [&'a str; 3],
    #[serde(rename = "r")]
    center: [&'a str; 3],
    /// The momenta: first, last, number.
    l: (&'a str, &'a str, u32),
    stability: [Stability; 7],
    stable: [Verdict; 5],
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
    eigenvalues: Vec<f64>,
    branch: Vec<i32>,
    branches: Vec<(String, String)>,
    eigenvalue_error: f64,
    error_bound: f64,
    incomplete: bool,
}

/// All equilibria at all momenta of a range.
pub fn of(body: &Body, [from, to]: [&Number; 2], count: u32) -> Result<Columns, NoTable> {
    let prepared = RelativeEquilibria::new(body)?;
    let mut rows = Rows::default();
    for k in 0..count {
        rows.extend(&prepared, k, &Momenta::at([from, to], count, k))?;
    }
    let meta = Meta {
        schema_version: SCHEMA_VERSION,
        moments: body.moments().each_ref().map(Number::text),
        center: body.center().each_ref().map(Number::text),
        l: (from.text(), to.text(), count),
        stability: bifdiag_documents::LINEAR_TYPES,
        stable: bifdiag_documents::VERDICTS,
        multiplicity: [Multiplicity::Points(1), Multiplicity::Points(2), Multiplicity::Circle, Multiplicity::Sphere],
        branches: rows.branches,
        eigenvalue_error: rows.eigenvalue_error,
        error_bound: rows.error_bound,
        complete: !rows.incomplete,
    };
    let ids: Vec<&str> = meta.branches.iter().map(|(id, _)| id.as_str()).collect();
    let eigenvalues = Values::Float { parts: &["1_re", "1_im", "2_re", "2_im"], values: rows.eigenvalues };
    let columns = [
        ("l_index", Values::Int32(rows.index_of_l)),
        ("l", Values::floats(rows.l.into_iter())),
        ("h", Values::floats(rows.h.into_iter())),
        ("gamma", Values::vectors(rows.gamma.into_iter())),
        ("omega", Values::floats(rows.omega.into_iter())),
        ("index", Values::Int8(rows.index)),
        ("multiplicity", Values::words(&meta.multiplicity, Values::Int8(rows.multiplicity))?),
        ("stability", Values::words(&meta.stability, Values::Int8(rows.stability))?),
        ("stable", Values::words(&meta.stable, Values::Int8(rows.stable))?),
        ("eigenvalues", eigenvalues),
        ("branch", Values::words(&ids, Values::Int32(rows.branch))?),
    ];
    Ok(Columns::new(columns, &meta)?)
}

/// Why there is no table.
#[derive(Debug, thiserror::Error)]
pub enum NoTable {
    #[error(transparent)]
    Critical(#[from] CriticalError),
    #[error(transparent)]
    Json(#[from] serde_json::Error),
}

impl Rows {
    fn extend(&mut self, prepared: &RelativeEquilibria<'_>, k: u32, l: &Number) -> Result<(), CriticalError> {
        let found = prepared.at(l)?;
        self.error_bound = self.error_bound.max(found.error_bound);
        self.incomplete |= !found.complete;
        for point in &found.list {
            self.index_of_l.push(k.cast_signed());
            self.l.push(l.to_f64());
            self.h.push(point.h);
            self.gamma.push(point.gamma);
            self.omega.push(point.omega);
            self.index.push(point.index.cast_signed());
            self.multiplicity.push(match point.multiplicity {
                Points::Points(1) => 0,
                Points::Points(_) => 1,
                Points::Circle => 2,
                Points::Sphere => 3,
            });
            self.stability.push(bifdiag_documents::type_code(point.stability));
            self.stable.push(bifdiag_documents::verdict_code(point.verdict));
            self.eigenvalues.extend(point.eigenvalues.pairs.as_flattened());
            self.eigenvalue_error = self.eigenvalue_error.max(point.eigenvalues.error);
            let id = point.curve.map_or_else(String::new, |curve| curve.to_string());
            let known = self.branches.iter().position(|(known, _)| *known == id);
            let branch = known.unwrap_or_else(|| {
                self.branches.push((id, point.branch_name.to_string()));
                self.branches.len() - 1
            });
            self.branch.push(i32::try_from(branch).unwrap_or(i32::MAX));
        }
        Ok(())
    }
}
