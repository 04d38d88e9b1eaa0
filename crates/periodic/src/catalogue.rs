//! All families of a body: from every equilibrium with an imaginary pair, at one value of l or h after another.

use bifdiag_body::{Body, Number};
use bifdiag_dynamics::field::HeavyTop;
use bifdiag_equilibria::critical::{CriticalError, Equilibrium, RelativeEquilibria};
use bifdiag_equilibria::curves::{CriticalSet, Curve, CurveName, EquilibriaError};
use bifdiag_equilibria::stability::LinearTypes;
use bifdiag_schema::OrbitStability;
use thiserror::Error;

use crate::family::{Family, FamilyError, FamilyOptions, Held, families_of};
use crate::orbit::PeriodicOrbit;

/// Where the families of a body begin.
#[derive(Debug)]
pub struct Catalogue<'a> {
    body: &'a Body,
    top: HeavyTop,
    set: CriticalSet,
    known: RelativeEquilibria<'a>,
}

/// Why the equilibria of a body could not be found.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum CatalogueError {
    /// The curves of critical values could not be computed.
    #[error(transparent)]
    Curves(#[from] EquilibriaError),
    /// The equilibria at one l could not be computed.
    #[error(transparent)]
    Critical(#[from] CriticalError),
}

/// A filter for the orbits of a family.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Wanted {
    /// Only linearly stable orbits: multipliers on the unit circle other than 1 and −1.
    pub stable: bool,
    /// Only orbits with a period between these two, inclusive.
    pub period: Option<[f64; 2]>,
    /// Only orbits that cross P at most this many times in a period.
    pub crossings: Option<u32>,
}

impl Wanted {
    /// Whether an orbit passes the filter.
    #[must_use]
    pub fn holds(&self, orbit: &PeriodicOrbit) -> bool {
        let stable = !self.stable || orbit.stability == OrbitStability::Elliptic;
        let period = self.period.is_none_or(|[from, to]| (from..=to).contains(&orbit.period));
        stable && period && self.crossings.is_none_or(|most| orbit.crossings <= most)
    }
}

/// The momentum taken beyond the last change of the equilibria, in units of the l of that change.
const BEYOND: f64 = 1.25;
/// Changes closer together than this, relative to the l of the last one, count as one: too close for a momentum between
/// them.
const TOGETHER: f64 = 1e-6;

impl<'a> Catalogue<'a> {
    /// For a body.
    ///
    /// # Errors
    /// [`CatalogueError`].
    pub fn new(body: &'a Body) -> Result<Self, CatalogueError> {
        let known = RelativeEquilibria::new(body)?.without_normal_forms();
        Ok(Self { body, top: HeavyTop::new(body), set: CriticalSet::new(body.frame())?, known })
    }

    /// The curves on which families begin.
    #[must_use]
    pub fn curves(&self) -> Vec<CurveName> {
        let critical = self.set.curves.pairs().filter(|(_, curve)| curve.is_critical());
        critical.map(|(id, _)| CurveName::of(&self.set, id)).collect()
    }

    /// One momentum of each kind: 0, and a short decimal between any two at which equilibria appear, vanish or change
    /// their linear type, and beyond the last.
    #[must_use]
    pub fn momenta(&self) -> Vec<Number> {
        let unit = self.set.frame.momentum_unit;
        let ends = self.set.curves.iter().filter(|curve| curve.is_critical()).flat_map(Curve::x);
        let ends = ends.map(|x| (2.0 * x).sqrt() * unit);
        let changes = LinearTypes::new(self.body, &self.set).changes();
        let mut at: Vec<f64> = ends.chain(changes.iter().map(|change| change.l)).collect();
        at.retain(|l| l.is_finite() && *l > 0.0);
        at.sort_by(f64::total_cmp);
        let last = at.last().copied().unwrap_or(unit);
        at.dedup_by(|l, before| *l - *before <= TOGETHER * last);
        let mut momenta: Vec<Number> = "0".parse().into_iter().collect();
        let from = std::iter::once(0.0).chain(at.iter().copied());
        let to = at.iter().copied().chain([2.0 * (BEYOND - 0.5) * last]);
        momenta.extend(from.zip(to).filter_map(|(from, to)| short_decimal(from, to)));
        momenta
    }

    /// The equilibria at this l, or at this energy, one for each curve that reaches it; only those of `curve`, if it is
    /// given.
    ///
    /// # Errors
    /// [`CatalogueError`].
    pub fn starts(
        &self,
        held: Held,
        value: &Number,
        curve: Option<CurveName>,
    ) -> Result<Vec<Equilibrium>, CatalogueError> {
        let momenta = match held {
            Held::Momentum => vec![(value.clone(), None)],
            Held::Energy => self.momenta_of(value.to_f64()),
        };
        let mut found = Vec::new();
        for (l, of) in momenta {
            let list = self.known.at(&l)?.list;
            found.extend(list.into_iter().filter(|point| of.is_none() || point.curve == of));
        }
        found.retain(|point| curve.is_none() || point.curve == curve);
        Ok(found)
    }

    /// The momentum at which each curve has this energy.
    fn momenta_of(&self, energy: f64) -> Vec<(Number, Option<CurveName>)> {
        let frame = &self.set.frame;
        let h = energy / frame.energy_unit;
        let curves = self.set.curves.pairs().filter(|(_, curve)| curve.is_critical());
        let at = curves.filter_map(|(id, curve)| {
            // Along a curve h rises with l: dh/dx = 1/J.
            let height = |x: f64| curve.point(frame, x).h() - h;
            let [mut from, mut to] = curve.x();
            if !to.is_finite() {
                to = from.max(1.0);
                while height(to) < 0.0 && to < 1e300 {
                    to *= 2.0;
                }
            }
            if from == 0.0 {
                from = f64::MIN_POSITIVE.sqrt();
            }
            if height(from) > 0.0 || height(to) < 0.0 {
                return None;
            }
            for _ in 0..200 {
                let middle = 0.5 * (from + to);
                if height(middle) < 0.0 { from = middle } else { to = middle }
            }
            let l = (2.0 * to).sqrt() * frame.momentum_unit;
            Some((format!("{l:?}").parse().ok()?, Some(CurveName::of(&self.set, id))))
        });
        at.collect()
    }

    /// The families of the imaginary pairs of an equilibrium of the body, the faster first, as
    /// [`families`](crate::family::families) finds them.
    ///
    /// # Errors
    /// [`FamilyError`].
    pub fn families(&self, start: &Equilibrium, options: &FamilyOptions<'_>) -> Result<Vec<Family>, FamilyError> {
        families_of(&self.top, &self.known, start, options)
    }
}

/// The decimal with the fewest digits in the middle half of an interval.
fn short_decimal(from: f64, to: f64) -> Option<Number> {
    let (least, most) = (0.75 * from + 0.25 * to, 0.25 * from + 0.75 * to);
    let middle = 0.5 * (from + to);
    let mut decimals = (0..18).map(|digits| format!("{middle:.digits$e}"));
    let inside = |text: &String| text.parse().is_ok_and(|x: f64| (least..=most).contains(&x));
    let number: f64 = decimals.find(inside)?.parse().ok()?;
    format!("{number:?}").parse().ok()
}
