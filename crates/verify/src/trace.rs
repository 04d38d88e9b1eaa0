//! Curves over any x in doubles: a place is looked for without rigour, and the equilibrium there is enclosed.

use std::ops::{Add, Mul, Sub};

use dashu_ratio::RBig;

use super::Refused;
use super::equilibria::Point;
use super::interval::Interval;
use super::pieces::{Branch, End, Piece, Pieces};
use super::place::Side;
use super::spaces::{Space, Spaces};

/// Steps of the search at most; every third halves the bracket, which holds at most 2⁶³ doubles.
const STEPS: usize = 200;
/// Room for the rounding of a place that lies beside an end of its curve.
const INSIDE: f64 = 8.0 * f64::EPSILON;

/// A relative equilibrium of a curve, exactly on it: x = l²/2, h and J.
#[derive(Clone, Copy, Debug)]
pub(super) struct Over<R> {
    pub x: R,
    pub h: R,
    pub j: R,
}

/// What the formulas are computed in: doubles to look for a place, intervals for what is claimed of it.
pub(super) trait Real: Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> {
    fn exact(x: &RBig) -> Self;
    fn double(x: f64) -> Self;
    fn inverse(self) -> Self;
    fn root(self) -> Self;
}

/// All curves.
pub(super) struct Traces(Vec<Trace>);

/// A curve.
enum Trace {
    /// h = x/J − ⟨γ, r⟩ with constants.
    Straight {
        j: Interval,
        rho: Interval,
    },
    Family(Box<Family>),
}

/// A curve of a family, by ρ > 0: μ is a + ρ, a − ρ, or divides a stretch between two moments as ρ to 1; over a space
/// without r it is y.
struct Family {
    doubles: [Form<f64>; 2],
    intervals: [Form<Interval>; 2],
    /// The length of the stretch between two moments, whose second half is measured from its far end.
    stretch: Option<f64>,
    /// Doubles on the curve between its ends, by rising ρ.
    range: [f64; 2],
    /// x rises with ρ.
    rises: bool,
    /// At the ends that are not at x → ∞.
    ends: [Option<Over<Interval>>; 2],
}

/// The equilibria of a half of a family by the distance y of their places.
enum Form<R> {
    /// Theorem 3.2, with a_k, |r_k|² and a − a_k of the spaces that carry r, and the side on which μ lies.
    Generic { spaces: Vec<[R; 3]>, side: f64 },
    /// Theorem 3.3, with a, Σ a_k q_k/d_k², R̂ and P̂.
    Over([R; 4]),
}

impl Traces {
    pub fn new(spaces: &Spaces, pieces: &Pieces) -> Result<Self, Refused> {
        let trace = |curve: usize| {
            let unbounded = || Refused::Unbounded { what: format!("the curve {}", pieces.list[curve].id) };
            Trace::new(spaces, pieces, curve).ok_or_else(unbounded)
        };
        Ok(Self((0..pieces.list.len()).map(trace).collect::<Result<_, _>>()?))
    }

    /// The point of a curve whose x is next to a number, as far as doubles tell; its end, where the curve does not go on.
    pub fn over(&self, curve: usize, x: f64) -> Option<Over<Interval>> {
        match &self.0[curve] {
            Trace::Straight { j, rho } => {
                let x = Interval::point(x);
                Some(Over { x, h: x * j.recip() - *rho, j: *j })
            }
            Trace::Family(family) => family.over(x),
        }
    }

    /// The same point, or one beside the end, in the precision of the spaces; `None` on a curve that is not generic.
    pub fn exactly(&self, spaces: &Spaces, pieces: &Pieces, curve: usize, x: f64) -> Option<Point> {
        let (base, side, y) = self.place(spaces, pieces, curve, x)?;
        let is_generic = matches!(pieces.list[curve].branch, Branch::Generic(_));
        is_generic.then(|| spaces.point(base, side, &spaces.set(&RBig::try_from(y).ok()?)))?
    }

    /// Where that point lies; `None` on a straight line.
    pub fn place(&self, spaces: &Spaces, pieces: &Pieces, curve: usize, x: f64) -> Option<(usize, Side, f64)> {
        let Trace::Family(family) = &self.0[curve] else { return None };
        let (half, y) = family.place(family.near(x));
        let space = |number: Option<usize>| spaces.active.get(number?).copied();
        match pieces.list[curve].branch {
            Branch::Over(base) => Some((base, Side::Over, y)),
            Branch::Generic(number) => match (space(number.checked_sub(1)), half) {
                (Some(left), 0) => Some((left, Side::Plus, y)),
                _ => Some((space(Some(number))?, Side::Minus, y)),
            },
            Branch::Line(_) | Branch::Rotation(_) => None,
        }
    }
}

impl Trace {
    fn new(spaces: &Spaces, pieces: &Pieces, curve: usize) -> Option<Self> {
        let piece = &pieces.list[curve];
        let norm = Interval::exact(&spaces.r2).sqrt();
        let zero = Interval::point(0.0);
        match piece.branch {
            Branch::Line(plus) => {
                let rho = if plus { norm } else { -norm };
                Some(Self::Straight { j: Interval::exact(&spaces.j_r()), rho })
            }
            Branch::Rotation(base) => Some(Self::Straight { j: Interval::exact(&spaces.list[base].a), rho: zero }),
            Branch::Generic(_) | Branch::Over(_) => {
                let end = |side: usize| match piece.ends[side] {
                    End::Infinity => Some(None),
                    // The families from +r̂ and −r̂.
                    End::Origin => {
                        let h = if piece.branch == Branch::Generic(0) { norm } else { -norm };
                        Some(Some(Over { x: zero, h, j: Interval::exact(&spaces.j_r()) }))
                    }
                    End::Cusp(_) | End::Pitchfork(_) => {
                        let point = pieces.end_point(spaces, curve, side)?;
                        let h = Spaces::height(&point.x, &point)?;
                        let [x, h, j] = [&point.x, &h, &point.j].map(Interval::of);
                        Some(Some(Over { x, h, j }))
                    }
                };
                Some(Self::Family(Box::new(Family::new(spaces, piece, [end(0)?, end(1)?])?)))
            }
        }
    }
}

impl Family {
    fn new(spaces: &Spaces, piece: &Piece, ends: [Option<Over<Interval>>; 2]) -> Option<Self> {
        let moments = match piece.branch {
            Branch::Generic(number) => spaces.interval(number),
            _ => [None, None],
        };
        let falls = matches!(moments, [None, Some(_)]);
        let rho = |t: &RBig| match moments {
            [Some(a), Some(b)] => (t - a) / (b - t),
            [Some(a), None] => t - a,
            [None, Some(b)] => b - t,
            [None, None] => t.clone(),
        };
        let [low, high] = &piece.range;
        let mut inner = [low.as_ref().map(|end| rho(&end[1])), high.as_ref().map(|end| rho(&end[0]))];
        if falls {
            inner.reverse();
        }
        let [low, high] = inner.map(|end| end.map(|end| end.to_f64().value()));
        let range =
            [low.unwrap_or(0.0).max(1e-290) * (1.0 + INSIDE), high.unwrap_or(1e290).min(1e290) * (1.0 - INSIDE)];
        let stretch = match moments {
            [Some(a), Some(b)] => Some((b - a).to_f64().value()),
            _ => None,
        };
        let (doubles, intervals) = (forms(spaces, piece.branch, moments)?, forms(spaces, piece.branch, moments)?);
        Some(Self { doubles, intervals, stretch, range, rises: piece.rising != falls, ends })
    }

    fn over(&self, x: f64) -> Option<Over<Interval>> {
        for (side, end) in self.ends.iter().enumerate() {
            let Some(end) = end else { continue };
            if if side == 0 { x <= end.x.middle() } else { x >= end.x.middle() } {
                return Some(*end);
            }
        }
        if self.range[0] >= self.range[1] {
            return self.ends.iter().flatten().next().copied();
        }
        let (half, y) = self.place(self.near(x));
        Some(self.intervals[half].at(y))
    }

    /// The half and the distance from its moment.
    fn place(&self, rho: f64) -> (usize, f64) {
        match self.stretch {
            None => (0, rho),
            Some(stretch) if rho <= 1.0 => (0, stretch * rho / (1.0 + rho)),
            Some(stretch) => (1, stretch / (1.0 + rho)),
        }
    }

    /// ρ over x. The bits of positive doubles are in order, and stand for their logarithms: over them x is nearly straight
    /// far from all moments.
    fn near(&self, x: f64) -> f64 {
        let beyond = |rho: f64| {
            let (half, y) = self.place(rho);
            let [at, x] = [self.doubles[half].at(y).x, x].map(f64::to_bits);
            let over = if at >= x { (at - x) as f64 } else { -((x - at) as f64) };
            if self.rises { over } else { -over }
        };
        let [mut low, mut high] = self.range.map(f64::to_bits);
        let [mut below, mut above] = self.range.map(beyond);
        if below >= 0.0 || above <= 0.0 {
            return self.range[usize::from(below < 0.0)];
        }
        let mut moved = None;
        for step in 0..STEPS {
            let width = high - low;
            if width <= 1 {
                break;
            }
            let share = if step % 3 == 2 { 0.5 } else { below / (below - above) };
            // A share of a width, which saturates.
            #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
            let step = ((share * width as f64) as u64).clamp(1, width - 1);
            let middle = low + step;
            let at = beyond(f64::from_bits(middle));
            // The rule of Illinois: an end that stays twice counts half.
            if at < 0.0 {
                (low, below) = (middle, at);
                above *= if moved == Some(false) { 0.5 } else { 1.0 };
                moved = Some(false);
            } else {
                (high, above) = (middle, at);
                below *= if moved == Some(true) { 0.5 } else { 1.0 };
                moved = Some(true);
            }
            if at == 0.0 {
                break;
            }
        }
        f64::from_bits(if moved == Some(false) { low } else { high })
    }
}

fn forms<R: Real>(spaces: &Spaces, branch: Branch, moments: [Option<&RBig>; 2]) -> Option<[Form<R>; 2]> {
    if let Branch::Over(base) = branch {
        let form = || {
            let (r_sum, p_sum) = spaces.sums(base);
            let a = &spaces.list[base].a;
            let weighed = spaces.active.iter().fold(RBig::ZERO, |sum, &k| {
                let space = &spaces.list[k];
                let d = a - &space.a;
                sum + &space.a * &space.q / (&d * &d)
            });
            Form::Over([a, &weighed, &r_sum, &p_sum].map(R::exact))
        };
        return Some([form(), form()]);
    }
    let generic = |from: &RBig, side: f64| {
        let row = |space: &Space| [&space.a, &space.q, &(from - &space.a)].map(R::exact);
        Form::Generic { spaces: spaces.active.iter().map(|&k| row(&spaces.list[k])).collect(), side }
    };
    match moments {
        [Some(a), Some(b)] => Some([generic(a, 1.0), generic(b, -1.0)]),
        [Some(a), None] => Some([generic(a, 1.0), generic(a, 1.0)]),
        [None, Some(b)] => Some([generic(b, -1.0), generic(b, -1.0)]),
        [None, None] => None,
    }
}

impl<R: Real> Form<R> {
    fn at(&self, y: f64) -> Over<R> {
        let half = R::double(0.5);
        match self {
            Self::Generic { spaces, side } => {
                // t_k = δ/(μ − a_k); s = √(Σ q t²)/|δ|, J = Σ a q t²/Σ q t², ⟨γ, r⟩ = ± Σ q t/√(Σ q t²).
                let delta = R::double(side * y);
                let zero = R::double(0.0);
                let (mut p, mut m, mut g) = (zero, zero, zero);
                for [a, q, d] in spaces {
                    let t = delta * (*d + delta).inverse();
                    let weight = *q * t;
                    g = g + weight;
                    p = p + weight * t;
                    m = m + *a * (weight * t);
                }
                let (j, root) = (m * p.inverse(), p.root());
                let kinetic = half * root * R::double(y).inverse() * j;
                Over { x: kinetic * j, h: kinetic - R::double(*side) * g * root.inverse(), j }
            }
            Self::Over([a, weighed, r_sum, p_sum]) => {
                let v = *p_sum + R::double(y);
                let (s, j) = (v.root(), (*weighed + *a * R::double(y)) * v.inverse());
                let kinetic = half * s * j;
                Over { x: kinetic * j, h: kinetic - *r_sum * s.inverse(), j }
            }
        }
    }
}

impl Real for f64 {
    fn exact(x: &RBig) -> Self {
        x.to_f64().value()
    }

    fn double(x: f64) -> Self {
        x
    }

    fn inverse(self) -> Self {
        1.0 / self
    }

    fn root(self) -> Self {
        self.sqrt()
    }
}

impl Real for Interval {
    fn exact(x: &RBig) -> Self {
        Self::exact(x)
    }

    fn double(x: f64) -> Self {
        Self::point(x)
    }

    fn inverse(self) -> Self {
        self.recip()
    }

    fn root(self) -> Self {
        self.sqrt()
    }
}
