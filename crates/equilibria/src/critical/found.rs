//! The equilibria of one branch at one l or spin, quickly, with bounds, or exactly; and those at rest.

use super::beyond;
use super::{Equilibrium, Fixed, Found, Multiplicity, Question, RelativeEquilibria};
use crate::curves::{BranchName, CurveId, CurveName, Orbit, Point, Shape};
use crate::nonlinear::{self, Friction, Nonlinear, Setting};
use crate::stability::exact::{ExactBody, ExactPoint, Touch};
use crate::stability::{Constants, Eigenvalues, LinearType, Place, Reduced, State};
use bifdiag_body::Axis;
use bifdiag_numbers::Sign;
use bifdiag_numbers::UNIT_ROUNDOFF;
use bifdiag_numbers::enclosure::{Arithmetic, Enclosure};
use bifdiag_numbers::interval::Interval;
use bifdiag_numbers::wide::Wide;
use bifdiag_schema::{NonlinearVerdict, Reason};

/// A relative equilibrium in the frame, before it is expressed in the body's axes and units.
struct Site {
    point: Point,
    orbit: Orbit,
    /// Where curves end the point is degenerate.
    is_degenerate: bool,
    is_fold: bool,
    curve: CurveName,
    setting: Setting,
}

impl RelativeEquilibria<'_> {
    /// The equilibria of one curve, if intervals decide everything that is reported of them.
    pub(super) fn quickly(&self, id: CurveId, x: f64, question: &Question<'_>, found: &mut Found) -> bool {
        let curve = &self.set.curves[id];
        let [from, to] = curve.x();
        if curve.index.is_none() || !(from < x && x < to) {
            return true;
        }
        let Some((site, state)) = self.enclosed(id, x) else { return false };
        let (c, reduced) = (&self.constants, Reduced::new(&self.constants, &state));
        let kind = if is_set(site.orbit) { reduced.transverse_type() } else { reduced.linear_type() };
        let Some(kind) = kind else { return false };
        let eigenvalues = self.eigenvalues(&reduced, kind, &site);
        if eigenvalues.are_coarse() {
            return false;
        }
        let judged = nonlinear::Question { c, state: &state, reduced: &reduced, kind, setting: site.setting };
        let Some(nonlinear) = self.deferred(kind, site.setting).or_else(|| judged.verdict([None; 2])) else {
            return false;
        };
        self.push(found, question, &site, &reduced, (kind, nonlinear, eigenvalues));
        true
    }

    /// No verdict, where one would need a normal form and none is wanted.
    fn deferred(&self, kind: LinearType, setting: Setting) -> Option<Nonlinear> {
        (self.defers && setting.verdict(kind).is_none()).then(Nonlinear::deferred)
    }

    /// The point of a curve over x, enclosed.
    fn enclosed(&self, id: CurveId, x: f64) -> Option<(Site, State<Interval>)> {
        let frame = &self.set.frame;
        let curve = &self.set.curves[id];
        let arc = curve.arc(x);
        let (point, mu) = arc.point_and_mu(frame, x);
        let place = match (&arc.shape, mu) {
            (Shape::Generic(_), Some(mu)) => Place::Generic(mu),
            (Shape::Symmetric { family, .. }, _) => {
                Place::Over { axis: family.axis, s: 2.0 * x / (point.j * point.j), r_sum: family.r_sum }
            }
            _ => {
                let axis = Axis::ALL.into_iter().find(|&k| point.gamma[k] != 0.0)?;
                Place::About { axis, weight: point.gamma[axis] * frame.r[axis] }
            }
        };
        // l and its square are rounded.
        let state = place.enclosed(&self.constants, Interval::point(x).widened(4.0))?;
        let is_global = mu.is_some_and(|mu| mu.minus_moment(frame, Axis::ALL[2]) >= 0.0);
        let minimum = is_global.then_some(true);
        let setting = Setting { index: curve.index?, minimum, integral: self.set.has_integral(curve) };
        let site = Site {
            point,
            orbit: curve.orbit,
            is_degenerate: false,
            is_fold: false,
            curve: CurveName::of(&self.set, id),
            setting,
        };
        Some((site, state))
    }

    /// All equilibria of a branch, from exact roots.
    pub(super) fn exactly(&self, question: &Question<'_>, found: &mut Found) -> Option<()> {
        if self.set.frame.is_euler() {
            return self.without_weight(question, found);
        }
        let profile = self.profile()?;
        let points = match question.fixed {
            Fixed::Momentum { l, .. } => profile.points(question.branch, l)?,
            Fixed::Spin(spin) => profile.points_at_spin(question.branch, &spin.fourth)?,
        };
        for exact in &points {
            let x = match question.fixed {
                Fixed::Momentum { x, .. } => x,
                Fixed::Spin(_) => abscissa_of(&exact.state),
            };
            let site = self.site(exact, question, x)?;
            let judged = || beyond::verdict(self.profile()?, question.branch, exact, site.setting);
            let nonlinear = self.deferred(exact.kind, site.setting).or_else(judged)?;
            let eigenvalues = self.eigenvalues(&exact.reduced, exact.kind, &site);
            self.push(found, question, &site, &exact.reduced, (exact.kind, nonlinear, eigenvalues));
        }
        Some(())
    }

    fn site(&self, exact: &ExactPoint, question: &Question<'_>, x: f64) -> Option<Site> {
        let frame = &self.set.frame;
        let last = exact.piece + usize::from(exact.touch.is_some());
        let is_alike = self.profile()?.is_cut_alike(question.branch, question.ids().count());
        let here = |id: &CurveId| {
            let curve = &self.set.curves[*id];
            let [from, to] = curve.x();
            let near = 64.0 * UNIT_ROUNDOFF * x;
            if is_alike {
                (exact.piece..=last).contains(&curve.piece)
            } else {
                // Where f64 cut the branch otherwise, as at a pitchfork in a cusp, pieces have other numbers.
                from - near <= x && x <= to + near && (exact.index.is_none() || curve.index == exact.index)
            }
        };
        // Where two curves meet, the one of smaller index.
        let carrier = question.ids().filter(here).min_by_key(|&id| self.set.curves[id].index);
        let curve = carrier.map(|id| &self.set.curves[id]);
        let is_flat = matches!(exact.touch, Some(Touch::Both { .. }));
        let index = if is_flat { 0 } else { curve.and_then(|curve| curve.index).or(exact.index)? };
        let minimum = match exact.touch {
            _ if exact.state.tau[2].sign() == Some(Sign::Positive) => Some(true),
            // Two points vanish into one another: the degree of the gradient is 0, and 1 at a minimum. Where a pair leaves at a
            // cusp, the curve has both branches of it or none on the side without the pair: the degree is even.
            Some(Touch::Cusp | Touch::Both { is_cusp: true }) => Some(false),
            // The degree is that on the side without the pair, and of the pair.
            Some(Touch::Pitchfork(axis)) => carrier.and_then(|id| self.pair_at(axis, id)).map(|index| index == 0),
            None | Some(Touch::Both { is_cusp: false }) => None,
        };
        let integral = curve.is_some_and(|curve| self.set.has_integral(curve));
        Some(Site {
            point: match curve.map(|curve| &curve.arcs[0].shape) {
                Some(Shape::Straight { gamma, j }) => Point::over(frame, x, *gamma, *j),
                _ => self.point(&exact.state, x),
            },
            orbit: curve.map_or(Orbit::Point, |curve| curve.orbit),
            is_degenerate: exact.touch.is_some(),
            is_fold: exact.is_double && matches!(question.fixed, Fixed::Spin(_)),
            curve: carrier.map_or_else(
                || CurveName::on(BranchName::of(frame, question.branch), exact.piece),
                |id| CurveName::of(&self.set, id),
            ),
            setting: Setting { index, minimum, integral },
        })
    }

    /// The index of the pair, or the circle, that leaves the branch of a curve over an axis.
    fn pair_at(&self, axis: Axis, curve: CurveId) -> Option<u8> {
        let group = &self.set.frame.group;
        let mut forks = self.set.pitchforks.iter();
        let fork = forks.find(|fork| fork.through.contains(&curve) && group[fork.axis] == group[axis])?;
        self.set.curves[fork.pair?].index
    }

    /// γ and J of an exact point, rounded.
    pub(super) fn point(&self, state: &State<Wide>, x: f64) -> Point {
        let frame = &self.set.frame;
        let gamma = std::array::from_fn(|k| {
            let (w, r, tau) = (middle(&state.w[k]), frame.r[k], middle(&state.tau[k]));
            // γ_k = r_k/(sτ_k) keeps the digits of a small γ_k.
            if r == 0.0 { w.max(0.0).sqrt() } else { r / (middle(&state.s) * tau) }
        });
        Point::over(frame, x, gamma, middle(&state.j))
    }

    /// Euler's rotations where intervals leave the type open: a double pair, which the exact body decides.
    fn without_weight(&self, question: &Question<'_>, found: &mut Found) -> Option<()> {
        for id in question.ids() {
            let x = match question.fixed {
                Fixed::Momentum { x, .. } => x,
                // l = JΩ, and J is the same along the whole curve.
                Fixed::Spin(spin) => {
                    let j = self.set.curves[id].point(&self.set.frame, 1.0).j;
                    let momentum = j * spin.omega.to_f64().value() / self.set.frame.frequency_unit;
                    0.5 * momentum * momentum
                }
            };
            let (site, state) = self.enclosed(id, x)?;
            let kind = self.profile()?.without_weight(&self.set.curves[id]);
            let nonlinear = Nonlinear::of(site.setting.verdict(kind)?);
            let reduced = Reduced::new(&self.constants, &state);
            let eigenvalues = self.eigenvalues(&reduced, kind, &site);
            self.push(found, question, &site, &reduced, (kind, nonlinear, eigenvalues));
        }
        Some(())
    }

    /// In the body's unit of time.
    fn eigenvalues<E: Enclosure>(&self, reduced: &Reduced<E>, kind: LinearType, site: &Site) -> Eigenvalues {
        reduced.eigenvalues(kind, is_set(site.orbit), self.set.frame.frequency_unit)
    }

    /// Enters a point, or both of a symmetric pair.
    fn push<E: Enclosure>(
        &self,
        found: &mut Found,
        question: &Question<'_>,
        site: &Site,
        reduced: &Reduced<E>,
        (kind, nonlinear, eigenvalues): (LinearType, Nonlinear, Eigenvalues),
    ) {
        let frame = &self.set.frame;
        let Site { point, orbit, .. } = site;
        let rounding = 8.0 * UNIT_ROUNDOFF * point.x * point.slope();
        found.error_bound = found.error_bound.max((point.h_error() + rounding) * frame.energy_unit);
        let momentum = question.fixed.sign() * (2.0 * point.x).sqrt();
        let equilibrium = Equilibrium {
            l: momentum * frame.momentum_unit,
            h: point.h() * frame.energy_unit,
            gamma: frame.vector_to_body(point.gamma),
            omega: momentum / point.j * frame.frequency_unit,
            index: site.setting.index,
            multiplicity: match orbit {
                Orbit::Circle(_) => Multiplicity::Circle,
                Orbit::Sphere => Multiplicity::Sphere,
                _ => Multiplicity::Points(if site.is_degenerate { 2 } else { 1 }),
            },
            is_fold: site.is_fold,
            stability: kind,
            nonlinear: nonlinear.in_unit(frame.momentum_unit / frame.frequency_unit),
            friction: Friction::new(reduced, kind, site.setting, is_set(*orbit)),
            eigenvalues,
            curve: Some(site.curve),
            branch_name: self.words(question.branch),
        };
        if let Orbit::Pair(axis) = orbit {
            let mut mirrored = point.gamma;
            mirrored[*axis] = -mirrored[*axis];
            found.list.push(Equilibrium { gamma: frame.vector_to_body(mirrored), ..equilibrium.clone() });
        }
        found.list.push(equilibrium);
    }
}

/// x = l²/2 = sJ²/2, rounded.
pub(super) fn abscissa_of(state: &State<Wide>) -> f64 {
    let j = middle(&state.j);
    0.5 * middle(&state.s) * j * j
}

/// The middle of an enclosure.
pub(super) fn middle(set: &Wide) -> f64 {
    let [lo, hi] = set.bounds();
    0.5 * (lo + hi)
}

/// A circle or a sphere of equilibria.
fn is_set(orbit: Orbit) -> bool {
    matches!(orbit, Orbit::Circle(_) | Orbit::Sphere)
}

/// Enough for every eigenvalue to be right to rounding.
const REST_BITS: usize = 160;

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
                nonlinear: Nonlinear::of((NonlinearVerdict::Stable, Reason::Energy)),
                friction: Friction { survives: Some(true), growing: 0, rates: [None; 2] },
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
        let (reduced, is_double) = (at_rest(body, side), self.body.is_round_across_r());
        let stability = match (index, is_double) {
            (0, true) => LinearType::DoubleElliptic,
            (0, false) => LinearType::Elliptic,
            (_, true) => LinearType::DoubleReal,
            (_, false) => LinearType::Saddle,
        };
        // The hanging body is in the minimum; the standing body falls.
        let verdict = if index == 0 {
            (NonlinearVerdict::Stable, Reason::Energy)
        } else {
            (NonlinearVerdict::Unstable, Reason::Spectrum)
        };
        // Zero has no sign.
        let gamma = frame.r_hat().map(|c| side * c + 0.0);
        let curve = self.set.at_rest(index == 0);
        let setting = Setting { index, minimum: Some(index == 0), integral: false };
        Equilibrium {
            l: 0.0,
            h: -side * self.body.center_norm().to_f64(),
            gamma: frame.vector_to_body(gamma),
            omega: 0.0,
            index,
            multiplicity: Multiplicity::Points(1),
            is_fold: false,
            stability,
            nonlinear: Nonlinear::of(verdict),
            friction: Friction::new(&reduced, stability, setting, false),
            eigenvalues: reduced.eigenvalues(stability, false, frame.frequency_unit),
            curve: curve.map(|c| CurveName::of(&self.set, c)),
            branch_name: curve.map_or_else(|| "at rest".into(), |c| self.words(self.set.curves[c].branch)),
        }
    }
}

/// The linearised flow at γ = ±r̂.
fn at_rest(body: &ExactBody, side: f64) -> Reduced<Wide> {
    let c: Constants<Wide> = body.constants(REST_BITS);
    let total = c.rho[0].clone() + c.rho[1].clone() + c.rho[2].clone();
    let w = c.rho.clone().map(|rho| rho / total.clone());
    let r = total.sqrt() * Wide::double(side, REST_BITS);
    Reduced::at_rest(&c, &w, &r)
}
