//! The next crossings of the section S = ⟨ω, r×γ⟩ = 0, enclosed with its derivative.
//!
//! In a step S is known as a polynomial with a bound of what it leaves. The step is cut into pieces until on each either S or
//! Ṡ has one sign for all motions of the set: there is no crossing, or at most one for each motion. A piece for which
//! neither is proved is a [tangency](ReturnError::Tangency), or too close to one; it is never skipped.
//!
//! Let p̂ be the middle of the set close to the section, X a box that holds all motions while they cross, n = ∇S. The map G
//! from a state near p̂ to the point where its motion crosses has the derivative Π(1 + η), Π = 1 − f nᵀ/⟨n, f⟩ at a point of
//! X, η the change of the flow's derivative during the crossing. The mean value theorem encloses the crossings of the set by
//! that of p̂ and Π(X) (1 + η) applied to the set, and the derivative of the return by Π(X) (1 + η) times that of the flow.

use bifdiag_body::Body;
use bifdiag_numbers::Sign;
use bifdiag_numbers::enclosure::{Arithmetic, Enclosure};
use bifdiag_numbers::interval::Interval;
use dashu_ratio::RBig;
use thiserror::Error;

use crate::bound::{exp, frobenius, norm, up};
use crate::field::{Equations, FREE, QuadraticField};
use crate::scalar::{DoubleDouble, Scalar};
use crate::set::{self, FlowSet, ROUNDINGS, Shape};
use crate::start::ExactStart;
use crate::step::Step;

/// A crossing of all motions of a set.
#[derive(Clone, Debug, PartialEq)]
pub struct Return {
    /// When they cross.
    pub time: [f64; 2],
    /// γ and ω there.
    pub state: [Interval; FREE],
    /// The derivative of γ and ω there by γ and ω at the start, along the section.
    pub derivative: [[Interval; FREE]; FREE],
    /// The sign of Ṡ there.
    pub direction: Sign,
    /// Crossings in either direction after the start until then, this one counted.
    pub crossings: u32,
}

/// Where motions start: a set of γ and ω, with ω in units of a power of two near the motion's frequency.
#[derive(Clone, Debug)]
pub struct Starts {
    speed: RBig,
    set: FlowSet<DoubleDouble, FREE>,
}

impl Starts {
    /// All γ and ω within `radius` of the given ones in each coordinate, ω in units of [`ExactStart::speed`].
    #[must_use]
    pub fn near(body: &Body, start: &ExactStart, radius: f64) -> Self {
        let speed = start.speed(body);
        let mut set = start.free::<DoubleDouble>(&speed, (), 106);
        for r in &mut set.shape.radii {
            *r = up(*r + radius);
        }
        Self { speed, set }
    }

    /// The box of all γ and ω within `radii` of doubles, exactly these; γ need not have length 1.
    #[must_use]
    pub fn boxed(body: &Body, middle: [f64; FREE], radii: [f64; FREE]) -> Option<Self> {
        let exact: Vec<RBig> = middle.iter().filter_map(|x| RBig::try_from(*x).ok()).collect();
        let [x, y, z, a, b, c] = <[RBig; FREE]>::try_from(exact).ok()?;
        let speed = ExactStart { gamma: [x, y, z], omega: [a, b, c], phi: RBig::ZERO }.speed(body);
        // A power of two.
        let unit = speed.to_f64().value();
        let scaled = |i: usize| if i < 3 { 1.0 } else { 1.0 / unit };
        let middle = std::array::from_fn(|i| DoubleDouble::double(middle[i] * scaled(i), ()));
        let set = FlowSet::new(middle, std::array::from_fn(|i| up(radii[i] * scaled(i))));
        Some(Self { speed, set })
    }
}

/// Why there is no enclosure of the return.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub enum ReturnError {
    /// r = 0.
    #[error("without weight there is no section")]
    NoSection,
    /// A motion touches the section, or comes too close to touching it.
    #[error("between t = {from} and t = {to} a motion may touch the section")]
    Tangency {
        /// From here
        from: f64,
        /// to there.
        to: f64,
    },
    /// No crossing in the time that was given.
    #[error("no crossing up to t = {time}")]
    NotBack {
        /// The time.
        time: f64,
    },
    /// Nothing can be proved of the next step.
    #[error("the set is too wide after t = {time}")]
    Wide {
        /// The time up to which it could be followed.
        time: f64,
    },
}

/// The longest step, in the time of the motion's fastest frequency.
const LONGEST: f64 = 1.0;
/// Lengths of a step that are tried before a tangency is reported.
const TRIES: u32 = 3;
/// The shortest pieces, as parts of a step.
const SHORTEST: f64 = 1e-7;

type Field = QuadraticField<DoubleDouble, FREE>;
type Matrix = [[Interval; FREE]; FREE];

/// The first crossing after time 0, in a direction if one is given, of all motions whose γ and ω at the start are within
/// `radius` of the given one in each coordinate (ω in units of the motion's frequency, [`ExactStart::speed`]). A start on the
/// section, with Ṡ ≠ 0, does not count.
///
/// # Errors
/// [`ReturnError`].
pub fn first_return(
    body: &Body,
    start: &ExactStart,
    radius: f64,
    direction: Option<Sign>,
    longest: f64,
) -> Result<Return, ReturnError> {
    let mut found = returns(body, &Starts::near(body, start, radius), direction, 1, longest)?;
    found.pop().ok_or(ReturnError::NotBack { time: 0.0 })
}

/// The first `count` crossings after time 0, in a direction if one is given. Starts need not lie on the section: where S = 0
/// within the set, its motions pass the section in one direction at the start, and that does not count.
///
/// # Errors
/// [`ReturnError`].
pub fn returns(
    body: &Body,
    starts: &Starts,
    direction: Option<Sign>,
    count: usize,
    longest: f64,
) -> Result<Vec<Return>, ReturnError> {
    if body.is_euler() {
        return Err(ReturnError::NoSection);
    }
    let Starts { speed, set } = starts;
    let seconds = 1.0 / speed.to_f64().value();
    let field = Field::new(&Equations::free(body, speed), (), DoubleDouble::full());
    let section = Section::new(body);
    let mut set = set.clone();
    let (mut now, mut flow, mut is_first) = (Interval::ZERO, FlowDerivative::start(), true);
    let (mut found, mut crossings) = (Vec::with_capacity(count), 0);
    // A crossing at the very end of a step is found with another length.
    let (mut length, mut tries) = (LONGEST, 0);
    while now.lo * seconds < longest {
        let wide = ReturnError::Wide { time: now.lo * seconds };
        let step = Step::new(&field, set.clone(), length).ok_or(wide)?;
        let reach = up(2.0 * (step.deviation() + step.rest()));
        let piece = Crossing { field: &field, section: &section, step: &step, s: section.series(&step), reach };
        let (all, trouble) = piece.find(is_first);
        let is_wanted = |sign: Sign| direction.is_none_or(|wanted| wanted == sign);
        let wanted = all.iter().filter(|(_, sign)| is_wanted(*sign)).count();
        // What comes after the last crossing that is wanted is of no interest.
        if let Some([a, b]) = trouble.filter(|_| found.len() + wanted < count) {
            if tries == TRIES {
                return Err(ReturnError::Tangency { from: (now.lo + a) * seconds, to: (now.hi + b) * seconds });
            }
            tries += 1;
            length = 0.77 * step.length();
            continue;
        }
        for (ends, sign) in all {
            crossings += 1;
            if !is_wanted(sign) {
                continue;
            }
            let ends = piece.narrowed(ends, sign);
            let (state, derivative) = piece.cross(ends, &flow).ok_or(wide)?;
            let scaled = |i: usize| if i < 3 { Interval::ONE } else { Interval::point(1.0 / seconds) };
            let clock = Interval::point(seconds) * (now + Interval { lo: ends[0], hi: ends[1] });
            found.push(Return {
                time: [clock.lo, clock.hi],
                state: std::array::from_fn(|i| state[i] * scaled(i)),
                derivative: std::array::from_fn(|i| std::array::from_fn(|j| derivative[i][j] * scaled(i) / scaled(j))),
                direction: sign,
                crossings,
            });
            if found.len() == count {
                return Ok(found);
            }
        }
        flow = flow.followed(&piece.flow(step.length()));
        is_first = false;
        now = now + Interval::point(step.length());
        (length, tries) = (LONGEST, 0);
        set = step.end().ok_or(wide)?;
    }
    Err(ReturnError::NotBack { time: now.lo * seconds })
}

/// S = Σ c γ_i ω_j.
struct Section {
    terms: Vec<(usize, usize, Interval)>,
    /// A bound of ‖M‖, S = ⟨x, Mx⟩.
    norm: f64,
}

impl Section {
    fn new(body: &Body) -> Self {
        let mut terms = Vec::new();
        for i in 0..3 {
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            let r = body.center().each_ref().map(|x| Interval::rational(x.value(), ()));
            // (r×γ)_i ω_i.
            terms.push((k, 3 + i, r[j]));
            terms.push((j, 3 + i, -r[k]));
        }
        let norm = up(terms.iter().map(|(.., c)| 0.5 * c.magnitude() * c.magnitude()).sum::<f64>().sqrt());
        Self { terms, norm }
    }

    /// Coefficients of S(p(t)).
    fn series(&self, step: &Step<'_, DoubleDouble, FREE>) -> Vec<Interval> {
        let rows = step.coefficients();
        let count = rows[0].len();
        let mut s = vec![Interval::ZERO; 2 * count - 1];
        for (i, j, c) in &self.terms {
            for (a, x) in rows[*i].iter().enumerate() {
                let x = *c * Interval::point(*x).widened(4.0);
                for (b, y) in rows[*j].iter().enumerate() {
                    s[a + b] = s[a + b] + x * Interval::point(*y).widened(4.0);
                }
            }
        }
        s
    }

    /// ∇S.
    fn gradient(&self, x: &[Interval; FREE]) -> [Interval; FREE] {
        let mut gradient = [Interval::ZERO; FREE];
        for (i, j, c) in &self.terms {
            gradient[*i] = gradient[*i] + *c * x[*j];
            gradient[*j] = gradient[*j] + *c * x[*i];
        }
        gradient
    }
}

/// A step beside the section.
struct Crossing<'a> {
    field: &'a Field,
    section: &'a Section,
    step: &'a Step<'a, DoubleDouble, FREE>,
    /// Of S(p(t)).
    s: Vec<Interval>,
    /// How far from p(t) the motions of the set are, and those through rounded points of it and between both.
    reach: f64,
}

impl Crossing<'_> {
    /// S for all motions over a piece of the step.
    fn value(&self, t: Interval) -> Interval {
        let s = self.s.iter().rev().fold(Interval::ZERO, |sum, c| sum * t + *c);
        let (size, e) = (self.step.size(), self.reach);
        s + ball(2.0 * self.section.norm * (size + e) * e)
    }

    /// Ṡ likewise.
    fn rate(&self, t: Interval) -> Interval {
        let terms = self.s.iter().enumerate().skip(1).rev();
        let rate = terms.fold(Interval::ZERO, |sum, (k, c)| sum * t + *c * Interval::point(k as f64));
        // 2⟨x, M f(x)⟩ − 2⟨p, Mṗ⟩ with ṗ = f(p) + d.
        let (e, f) = (self.reach, self.field);
        let size = self.step.size() + e;
        let steep = (f.lambda + 2.0 * f.kappa * size) * e;
        let speed = f.lambda * size + f.kappa * size * size;
        rate + ball(2.0 * self.section.norm * (size * steep + e * speed + size * self.step.defect()))
    }

    /// The crossings of a step in order, each as a piece with the sign of Ṡ on it, up to a piece on which the sign is
    /// not proved. At the start of the first step S may be 0.
    #[expect(clippy::type_complexity, reason = "crossings, and what ends them")]
    fn find(&self, is_first: bool) -> (Vec<([f64; 2], Sign)>, Option<[f64; 2]>) {
        let mut found = Vec::new();
        let mut pieces = vec![[0.0, self.step.length()]];
        while let Some([a, b]) = pieces.pop() {
            let t = Interval { lo: a, hi: b };
            if self.value(t).strict_sign().is_some() {
                continue;
            }
            if let Some(sign) = self.rate(t).strict_sign() {
                let [before, after] = [a, b].map(|t| self.value(Interval::point(t)).strict_sign());
                let starts_here = is_first && a == 0.0 && before.is_none() && after == Some(sign);
                if starts_here || before == Some(sign) || (before == Some(-sign) && after == Some(-sign)) {
                    continue;
                }
                if before == Some(-sign) && after == Some(sign) {
                    found.push(([a, b], sign));
                    continue;
                }
            }
            if b - a < SHORTEST * self.step.length() {
                return (found, Some([a, b]));
            }
            // Off the middle, so that cuts do not fall on a crossing that lies there by symmetry.
            let middle = a + 0.46 * (b - a);
            pieces.extend([[middle, b], [a, middle]]);
        }
        (found, None)
    }

    /// The part of a piece with a crossing outside of which S has the signs of its ends.
    fn narrowed(&self, [mut a, mut b]: [f64; 2], sign: Sign) -> [f64; 2] {
        for share in [0.5, 0.3, 0.7].into_iter().cycle().take(150) {
            let t = a + share * (b - a);
            match self.value(Interval::point(t)).strict_sign() {
                Some(found) if found == sign => b = t,
                Some(_) => a = t,
                None => {}
            }
        }
        [a, b]
    }

    /// The derivative of the flow from the start of the step, for all its motions: a matrix, and a bound of how far it may be.
    fn flow(&self, time: f64) -> (set::Matrix<FREE>, f64) {
        self.step.derivative(&RBig::try_from(time).unwrap_or(RBig::ZERO))
    }

    /// Where the motions cross between two times of the step, and the derivative of that by the start.
    fn cross(&self, [a, b]: [f64; 2], flow: &FlowDerivative) -> Option<([Interval; FREE], Matrix)> {
        let t = a + 0.5 * (b - a);
        let time = RBig::try_from(t).ok()?;
        let set = self.step.at(&time);
        let p = set.middle.each_ref().map(|x| Interval::point(x.to_double()).widened(4.0));
        let around = |p: &[Interval; FREE]| std::array::from_fn::<_, FREE, _>(|i| p[i] + ball(set.radii[i]));
        // All motions between a and b: |x(t) − x(t')| ≤ ‖f‖ |t − t'|, with ‖f‖ from the bound of ‖x‖.
        let size = self.step.size() + self.reach;
        let speed = up(self.field.lambda * size + self.field.kappa * size * size);
        let span = up(b - a);
        let box_of = |x: [Interval; FREE]| x.map(|x| x + ball(speed * span));
        let x = box_of(around(&p));
        let f = self.field.enclosed(&x);
        let n = self.section.gradient(&x);
        let rate = (0..FREE).fold(Interval::ZERO, |sum, i| sum + n[i] * f[i]);
        rate.strict_sign()?;
        let projection: Matrix = std::array::from_fn(|i| {
            std::array::from_fn(|j| Interval::point(f64::from(u8::from(i == j))) - f[i] * n[j] / rate)
        });
        // ‖U − 1‖ for the flow's derivative U over at most b − a.
        let steep = up(self.field.lambda + 2.0 * self.field.kappa * size);
        let eta = up(exp(up(steep * span)) - 1.0);
        if eta > 1.0 {
            return None;
        }
        let turned: Matrix = std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                let length = up((0..FREE).map(|m| projection[i][m].magnitude()).sum::<f64>());
                projection[i][j] + ball(eta * length)
            })
        });
        // The crossing of the middle itself.
        let at_middle = (0..self.section.terms.len()).fold(Interval::ZERO, |sum, k| {
            let (i, j, c) = self.section.terms[k];
            sum + c * p[i] * p[j]
        });
        let delay = at_middle / rate;
        let (images, rest) = self.step.image(&time);
        let state = std::array::from_fn(|i| {
            let along = images.reach(|v| applied(&turned[i], &v).magnitude());
            let beside = (0..FREE).map(|m| turned[i][m].magnitude()).sum::<f64>() * rest;
            p[i] - delay * f[i] + ball(up(along) + up(beside))
        });
        let (last, rest) = self.flow(t);
        let last = last.map(|row| row.map(|x| Interval::point(x) + ball(rest)));
        Some((state, flow.then(&product(&turned, &last))))
    }
}

/// [−r, r] with r rounded up.
fn ball(r: f64) -> Interval {
    let r = up(r);
    if r.is_finite() { Interval { lo: -r, hi: r } } else { Interval::LINE }
}

/// The derivative of the flow over many steps: a matrix P whose columns are each off by a vector of a shape. In a step with
/// the derivative M + Δ, ‖Δ‖ ≤ δ, a column p + e becomes Mp + Me + Δ(p + e): what is not known is mapped with the motions, as
/// in a set of states, and a ball of radius δ‖p + e‖ is added. Nothing is multiplied by the sizes of all steps, as it would
/// be in a product of matrices of intervals.
struct FlowDerivative {
    matrix: set::Matrix<FREE>,
    beside: Shape<FREE>,
}

impl FlowDerivative {
    fn start() -> Self {
        Self { matrix: set::identity(), beside: Shape::new([0.0; FREE]) }
    }

    fn followed(&self, (map, rest): &(set::Matrix<FREE>, f64)) -> Self {
        let size = frobenius(&self.matrix);
        let (beside, rounding) = self.beside.image(map);
        let ball = ROUNDINGS * frobenius(map) * size + rest * (size + norm(&self.beside.component_radii()));
        Self { matrix: set::product(map, &self.matrix), beside: beside.widened(up(ball + rounding)) }
    }

    /// Its product with a matrix that follows it.
    fn then(&self, map: &Matrix) -> Matrix {
        std::array::from_fn(|i| {
            let beside = ball(self.beside.reach(|column| applied(&map[i], &column).magnitude()));
            std::array::from_fn(|j| applied(&map[i], &self.matrix.map(|row| row[j])) + beside)
        })
    }
}

/// ⟨row, v⟩.
fn applied(row: &[Interval; FREE], v: &[f64; FREE]) -> Interval {
    row.iter().zip(v).fold(Interval::ZERO, |sum, (c, x)| sum + *c * Interval::point(*x))
}

fn product(left: &Matrix, right: &Matrix) -> Matrix {
    std::array::from_fn(|i| {
        std::array::from_fn(|j| (0..FREE).fold(Interval::ZERO, |sum, m| sum + left[i][m] * right[m][j]))
    })
}
