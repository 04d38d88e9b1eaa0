//! l = 0: the body hangs or stands at rest.

use super::{Equilibrium, Multiplicity, RelativeEquilibria};
use crate::curves::{CurveId, CurveName};
use crate::stability::exact::ExactBody;
use crate::stability::{Constants, Eigenvalues, LinearType, Reduced, Setting, Verdict};
use bifdiag_numbers::enclosure::Arithmetic;
use bifdiag_numbers::wide::Wide;

/// Enough for every eigenvalue to be right to rounding.
const BITS: usize = 160;

impl RelativeEquilibria<'_> {
    /// The body hangs (γ = r̂) or stands (γ = −r̂) at rest; for r = 0 every γ is an equilibrium.
    pub(super) fn at_rest(&self) -> Vec<Equilibrium> {
        let frame = &self.set.frame;
        if frame.is_euler() {
            return vec![Equilibrium {
                l: 0.0,
                h: 0.0,
                gamma: [0.0, 0.0, 1.0],
                omega: 0.0,
                index: 0,
                multiplicity: Multiplicity::Sphere,
                is_fold: false,
                stability: LinearType::Zero,
                verdict: Verdict::Energy,
                eigenvalues: Eigenvalues { pairs: [[0.0; 2]; 2], error: 0.0 },
                curve: Some(CurveName::Rest),
                branch_name: "at rest".into(),
            }];
        }
        let body = ExactBody::new(self.body, frame);
        [(1.0, 0), (-1.0, 2)].map(|(side, index)| self.resting(&body, side, index)).to_vec()
    }

    fn resting(&self, body: &ExactBody, side: f64, index: u8) -> Equilibrium {
        let frame = &self.set.frame;
        let (reduced, is_double) = at_rest(body, side);
        let stability = match (index, is_double) {
            (0, true) => LinearType::DoubleElliptic,
            (0, false) => LinearType::Elliptic,
            (_, true) => LinearType::DoubleReal,
            (_, false) => LinearType::Saddle,
        };
        let gamma = frame.r_hat().map(|c| side * c);
        let starts = |c: &CurveId| {
            let curve = &self.set.curves[*c];
            curve.is_critical() && curve.x()[0] == 0.0 && (curve.index == Some(0)) == (index == 0)
        };
        let curve = self.set.curves.ids().find(starts);
        let setting = Setting { index, global_minimum: index == 0, integral: self.set.is_lagrange() };
        Equilibrium {
            l: 0.0,
            h: -side * frame.r_norm * frame.energy_unit,
            gamma: frame.vector_to_body(gamma),
            omega: 0.0,
            index,
            multiplicity: Multiplicity::Points(1),
            is_fold: false,
            stability,
            verdict: setting.verdict(stability),
            eigenvalues: reduced.eigenvalues(stability, false, frame.frequency_unit),
            curve: curve.map(|c| CurveName::of(&self.set, c)),
            branch_name: curve.map_or_else(|| "at rest".into(), |c| self.words(self.set.curves[c].branch)),
        }
    }
}

/// The linearised flow at γ = ±r̂, and whether its two pairs agree: where A⁻¹ across r̂ is a multiple of 1.
fn at_rest(body: &ExactBody, side: f64) -> (Reduced<Wide>, bool) {
    let c: Constants<Wide> = body.constants(BITS);
    let total = c.rho[0].clone() + c.rho[1].clone() + c.rho[2].clone();
    let w = c.rho.clone().map(|rho| rho / total.clone());
    let r = total.sqrt() * Wide::double(side, BITS);
    (Reduced::at_rest(&c, &w, &r), body.is_round_across_r())
}
