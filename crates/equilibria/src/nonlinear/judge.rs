//! The theorems that decide what eigenvalues, energy and integrals leave open (Theorem 13.9, Proposition 13.11 of
//! docs/algorithms.md).

use bifdiag_numbers::Sign;
use bifdiag_numbers::enclosure::Enclosure;

use super::determinant::arnold_numerator;
use super::normal_form::NormalForm;
use super::reduced_hamiltonian::{farthest, reduced_hamiltonian};
use super::series::Series;
use super::sixth::sixth;
use super::verdict::{Determinant, Nonlinear, Setting};
use crate::stability::{Constants, LinearType, RESONANCES, Reduced, State};
use bifdiag_schema::{NonlinearVerdict, Reason};

/// A relative equilibrium, enclosed, of a type that is known.
#[derive(Clone, Copy, Debug)]
pub struct Question<'a, E: Enclosure> {
    /// The body.
    pub c: &'a Constants<E>,
    /// Where it is.
    pub state: &'a State<E>,
    /// The linearised flow there.
    pub reduced: &'a Reduced<E>,
    /// Its type.
    pub kind: LinearType,
    /// What else is known.
    pub setting: Setting,
}

/// What the verdicts on a stretch with two imaginary pairs need: index 2 and no integral.
pub(super) const MAXIMUM: Setting = Setting { index: 2, minimum: None, integral: false };

impl<E: Enclosure> Question<'_, E> {
    /// The verdict; `None` where a better enclosure is needed. `exact` says, if known, which of the resonances 1:2 and
    /// 1:3 holds exactly.
    #[must_use]
    pub fn verdict(&self, exact: [Option<bool>; 2]) -> Option<Nonlinear> {
        if let Some(known) = self.setting.verdict(self.kind) {
            return Some(Nonlinear::of(known));
        }
        let near = Some(near(self.reduced));
        let found = |verdict, why, arnold| Some(Nonlinear { verdict, why, arnold, near, proved: true });
        if self.kind == LinearType::DoubleElliptic {
            // At index 2 the faster pair has positive energy, and the double one is not semisimple.
            let verdict = match self.numerator()?.strict_sign()? {
                Sign::Negative => NonlinearVerdict::Unstable,
                _ => NonlinearVerdict::Stable,
            };
            return found(verdict, Reason::Resonance11, None);
        }
        let [two, three] = [1, 2].map(|n| match exact[n - 1] {
            Some(holds) => Some(holds),
            None => defect(self.reduced, self.c, n).strict_sign().map(|_| false),
        });
        let (two, three) = (two?, three?);
        let form = if three { self.form(NormalForm::with_quartic)? } else { self.normal_form()? };
        if two {
            match form.cubic.sign()? {
                Sign::Zero => {}
                _ => return found(NonlinearVerdict::Unstable, Reason::Resonance12, None),
            }
        }
        let sign = form.arnold.strict_sign();
        let arnold = determinant(&form.arnold);
        if let Some(quartic) = form.quartic.filter(|quartic| quartic.sign() != Some(Sign::Zero)) {
            // On ω₁I₁ = ω₂I₂ the quartic part is (K₁₁ + 3K₁₂ + 9K₂₂ + 3√3 B cos ψ) I₁².
            let small = |value| E::small(value, self.c.precision);
            let [k11, k12, k22] = form.twist.clone();
            let along = k11 + small(3) * k12 + small(9) * k22;
            let verdict = match (along.square() - small(27) * quartic).strict_sign()? {
                Sign::Negative => NonlinearVerdict::Unstable,
                _ => NonlinearVerdict::Stable,
            };
            return found(verdict, Reason::Resonance13, arnold);
        }
        sign?;
        found(NonlinearVerdict::Stable, Reason::Arnold, arnold)
    }

    /// The verdict where enclosures came to their end.
    #[must_use]
    pub fn undecided(&self, exact: [Option<bool>; 2]) -> Nonlinear {
        let why = match exact {
            _ if self.kind == LinearType::DoubleElliptic => Reason::Resonance11,
            [Some(true), _] => Reason::Resonance12,
            [_, Some(true)] => Reason::Resonance13,
            _ => Reason::Degenerate,
        };
        let arnold = self.normal_form().and_then(|form| determinant(&form.arnold));
        Nonlinear { verdict: NonlinearVerdict::Open, why, arnold, near: Some(near(self.reduced)), proved: false }
    }

    /// c(b² − 4c)D₄ in units in which Ω = 1, finite at ω₁ = ω₂; `None` where the enclosures do not give it.
    #[must_use]
    pub fn numerator(&self) -> Option<E> {
        self.form(arnold_numerator)
    }

    /// The normal form of the flow reduced by l, in units in which Ω = 1: its determinant is D₄/s. `None` where the
    /// enclosures do not show that there are two distinct imaginary pairs.
    #[must_use]
    pub fn normal_form(&self) -> Option<NormalForm<E>> {
        self.form(NormalForm::new)
    }

    /// D₆/s, which decides where D₄ = 0; `None` where the enclosures do not exclude all resonances of order up to six.
    #[must_use]
    pub fn sixth(&self) -> Option<E> {
        self.form(sixth)
    }

    fn form<T, const D: usize>(&self, of: impl FnOnce(&Series<E, D>, &E, &E, E::Precision) -> T) -> T {
        let series = reduced_hamiltonian(self.c, self.state, farthest(self.state));
        let [b, c] = self.reduced.coefficients();
        of(&series, b, c, self.c.precision)
    }
}

/// mβ² − nχ of a resonance.
fn defect<E: Enclosure>(reduced: &Reduced<E>, c: &Constants<E>, n: usize) -> E {
    let [beta, chi] = reduced.coefficients();
    let [m, n] = RESONANCES[n].map(|value| E::small(value, c.precision));
    m * beta.square() - n * chi.clone()
}

/// (mb² − nc)/b² of all three.
fn near<E: Enclosure>(reduced: &Reduced<E>) -> [f64; 3] {
    let [beta, chi] = reduced.coefficients();
    let ratio = middle(&(chi.clone() / beta.square()));
    RESONANCES.map(|[m, n]| f64::from(m) - f64::from(n) * ratio)
}

fn middle<E: Enclosure>(value: &E) -> f64 {
    let [lo, hi] = value.bounds();
    lo + 0.5 * (hi - lo)
}

/// `None` where the enclosure is unbounded.
fn determinant<E: Enclosure>(value: &E) -> Option<Determinant> {
    let [lo, hi] = value.bounds();
    let middle = middle(value);
    let error = (hi - middle).max(middle - lo) + f64::EPSILON * middle.abs();
    (middle.is_finite() && error.is_finite()).then_some(Determinant { value: middle, error })
}
