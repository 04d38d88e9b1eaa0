//! The next crossing of the section S = ⟨ω, r×γ⟩ = 0, enclosed with its derivative.
//!
//! In a step S is known as a polynomial with a bound of what it leaves. The step is cut into pieces until on each either S or
//! Ṡ has one sign for all motions of the set: there is no crossing, or at most one for each motion. A piece on which neither
//! can be told is a [tangency](ReturnError::Tangency), or too close to one; it is never passed over.
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

use crate::bound::{exp, up};
use crate::field::{Equations, FREE, QuadraticField};
use crate::scalar::DoubleDouble;
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
    if body.is_euler() {
        return Err(ReturnError::NoSection);
    }
    let speed = start.speed(body);
    let seconds = 1.0 / speed.to_f64().value();
    let field = Field::new(&Equations::free(body, &speed), (), DoubleDouble::full());
    let section = Section::new(body);
    let mut set = start.free::<DoubleDouble>(&speed, (), 106);
    for r in &mut set.radii {
        *r = up(*r + radius);
    }
    let (mut now, mut flow, mut is_first) = (Interval::ZERO, identity(), true);
    // A crossing at the very end of a step is found with another length.
    let (mut length, mut tries) = (LONGEST, 0);
    while now.lo * seconds < longest {
        let wide = ReturnError::Wide { time: now.lo * seconds };
        let step = Step::new(&field, set.clone(), length).ok_or(wide)?;
        let reach = up(2.0 * (step.deviation() + step.rest()));
        let piece = Crossing { field: &field, section: &section, step: &step, s: section.series(&step), reach };
        match piece.find(is_first, direction) {
            Found::Nothing => {}
            Found::Tangency(_) if tries < TRIES => {
                tries += 1;
                length = 0.77 * step.length();
                continue;
            }
            Found::Tangency([a, b]) => {
                return Err(ReturnError::Tangency { from: (now.lo + a) * seconds, to: (now.hi + b) * seconds });
            }
            Found::At(ends, sign) => {
                let (state, derivative) = piece.cross(ends, &flow).ok_or(wide)?;
                let scaled = |i: usize| if i < 3 { Interval::ONE } else { Interval::point(1.0 / seconds) };
                let clock = Interval::point(seconds) * (now + Interval { lo: ends[0], hi: ends[1] });
                return Ok(Return {
                    time: [clock.lo, clock.hi],
                    state: std::array::from_fn(|i| state[i] * scaled(i)),
                    derivative: std::array::from_fn(|i| {
                        std::array::from_fn(|j| derivative[i][j] * scaled(i) / scaled(j))
                    }),
                    direction: sign,
                });
            }
        }
        flow = product(&piece.flow(step.length()), &flow);
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

enum Found {
    Nothing,
    Tangency([f64; 2]),
    /// Between these times of the step, with this sign of Ṡ.
    At([f64; 2], Sign),
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

    /// The first crossing in a direction. At the start of the first step S may be 0.
    fn find(&self, is_first: bool, direction: Option<Sign>) -> Found {
        let mut pieces = vec![[0.0, self.step.length()]];
        while let Some([a, b]) = pieces.pop() {
            let t = Interval { lo: a, hi: b };
            if self.value(t).strict_sign().is_some() {
                continue;
            }
            match self.rate(t).strict_sign() {
                Some(sign) => {
                    let [before, after] = [a, b].map(|t| self.value(Interval::point(t)).strict_sign());
                    let starts_here = is_first && a == 0.0 && before.is_none() && after == Some(sign);
                    if starts_here || before == Some(sign) {
                        continue;
                    }
                    if before == Some(-sign) && after == Some(-sign) {
                        continue;
                    }
                    if before == Some(-sign) && after == Some(sign) {
                        if direction.is_none_or(|wanted| wanted == sign) {
                            return Found::At(self.narrowed([a, b], sign), sign);
                        }
                        continue;
                    }
                    if b - a < SHORTEST * self.step.length() {
                        return Found::Tangency([a, b]);
                    }
                }
                None if b - a < SHORTEST * self.step.length() => return Found::Tangency([a, b]),
                None => {}
            }
            // Off the middle, so that cuts do not fall on a crossing that is there by symmetry.
            let middle = a + 0.46 * (b - a);
            pieces.extend([[middle, b], [a, middle]]);
        }
        Found::Nothing
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

    /// The derivative of the flow from the start of the step, for all its motions.
    fn flow(&self, time: f64) -> Matrix {
        let (matrix, rest) = self.step.derivative(&RBig::try_from(time).unwrap_or(RBig::ZERO));
        matrix.map(|row| row.map(|x| Interval::point(x) + ball(rest)))
    }

    /// Where the motions cross between two times of the step, and the derivative of that by the start.
    fn cross(&self, [a, b]: [f64; 2], flow: &Matrix) -> Option<([Interval; FREE], Matrix)> {
        let t = a + 0.5 * (b - a);
        let time = RBig::try_from(t).ok()?;
        let set = self.step.at(&time);
        let p = set.middle.each_ref().map(|x| Interval::point(crate::scalar::Scalar::to_double(x)).widened(4.0));
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
            let along: f64 = (0..FREE)
                .map(|j| {
                    let entry =
                        (0..FREE).fold(Interval::ZERO, |sum, m| sum + turned[i][m] * Interval::point(images[m][j]));
                    entry.magnitude() * self.step.start().radii[j]
                })
                .sum();
            let beside = (0..FREE).map(|m| turned[i][m].magnitude()).sum::<f64>() * rest;
            p[i] - delay * f[i] + ball(up(along) + up(beside))
        });
        Some((state, product(&turned, &product(&self.flow(t), flow))))
    }
}

/// [−r, r] with r rounded up.
fn ball(r: f64) -> Interval {
    let r = up(r);
    if r.is_finite() { Interval { lo: -r, hi: r } } else { Interval::LINE }
}

fn identity() -> Matrix {
    std::array::from_fn(|i| std::array::from_fn(|j| Interval::point(f64::from(u8::from(i == j)))))
}

fn product(left: &Matrix, right: &Matrix) -> Matrix {
    std::array::from_fn(|i| {
        std::array::from_fn(|j| (0..FREE).fold(Interval::ZERO, |sum, m| sum + left[i][m] * right[m][j]))
    })
}
