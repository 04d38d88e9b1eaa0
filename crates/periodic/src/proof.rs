//! Proofs that there is a periodic orbit near a computed one, by the operator of Krawczyk on the enclosed return map.
//!
//! **Theorem.** Let X ⊂ ℝ⁶ be a box of (γ, ω) around x̂, F the map that follows a motion from X to its m-th crossing of
//! P⁻ after the start, c₁ and c₂ linear forms, and
//! Φ(x) = (|γ|² − 1, ⟨γ, Aω⟩ − l, H − h, S, c₁(F(x) − x), c₂(F(x) − x)).
//! 1. If K = x̂ − YΦ(x̂) + (1 − Y DΦ(X))(X − x̂) is in the interior of X for some matrix Y, then Φ has exactly one zero
//!    x* in X, and it is in K.
//! 2. Let Z be a box that contains X and F(X), and Ψ = (|γ|², ⟨γ, Aω⟩, H, S, c₁, c₂). If ‖1 − Y′M‖ < 1 for some matrix Y′
//!    and all M in DΨ(Z), then F(x*) = x*: the motion from x* has energy h and vertical momentum l exactly and is
//!    periodic, and no other point of X is on such a motion that returns to itself at its m-th crossing.
//! 3. The sum of its two multipliers is the trace of DF(x*) less 3.
//!
//! *Proof.* 1 is Krawczyk's theorem. F preserves |γ|, ⟨γ, l⟩ and H, and S∘F = 0, so that Ψ(x*) = Ψ(F(x*)).
//! By the mean value theorem Ψ(a) − Ψ(b) = M(a − b) with M in DΨ(Z), and M is invertible. Conversely a fixed point of F on
//! P_hl is a zero of Φ. DF(x*) is 0 on the direction of the motion, has the gradients of the three integrals as left
//! eigenvectors with value 1, and has the multipliers on the tangent plane of P. ∎

use bifdiag_body::{Body, Number};
use bifdiag_enclosure::return_map::{Return, ReturnError, Starts, returns};
use bifdiag_numbers::Sign;
use bifdiag_numbers::enclosure::Arithmetic;
use bifdiag_numbers::interval::Interval;
use nalgebra::{SMatrix, SVector};
use thiserror::Error;

type Box6 = [Interval; 6];
type Rows = [Box6; 6];
type Matrix = SMatrix<f64, 6, 6>;

/// What was proved of an orbit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OrbitProof {
    /// γ and ω at its start lie here; there is one such orbit with this number of crossings.
    pub state: [[f64; 2]; 6],
    /// Its period.
    pub period: [f64; 2],
    /// The sum of its multipliers.
    pub trace: [f64; 2],
    /// Its crossings of P in a period.
    pub crossings: u32,
}

/// Why a proof failed.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub enum ProofError {
    /// A number left the range of doubles.
    #[error("a number is out of range")]
    Range,
    /// A return could not be enclosed.
    #[error(transparent)]
    Return(#[from] ReturnError),
    /// Krawczyk's operator maps no box into its interior.
    #[error("no box around the orbit is mapped into itself")]
    NotContracting,
    /// It may close at an earlier return.
    #[error("the orbit may close earlier")]
    Repeated,
}

/// The start in doubles lies on P up to this.
const ROUNDING: f64 = 4e-15;
/// Half sides of the boxes tried, in units in which γ and ω are of moderate size.
const RADII: [f64; 4] = [1e-10, 1e-8, 1e-11, 1e-12];

/// Proves that near a start (γ, ω) on P⁻ there is a periodic orbit at exactly (h, l) with `turns` returns to P⁻ and a
/// period of at most `longest`.
///
/// # Errors
/// [`ProofError`].
pub fn prove(
    body: &Body,
    [h, l]: [&Number; 2],
    start: [f64; 6],
    turns: usize,
    longest: f64,
) -> Result<OrbitProof, ProofError> {
    let problem = Problem::new(body, [h, l], start, turns, longest).ok_or(ProofError::Range)?;
    // A little more than the rounding of S: the crossing at the start itself must not count, on whichever side of P it
    // lies.
    let point = problem.returns(problem.unit.map(|unit| ROUNDING * unit))?;
    let mut why = ProofError::NotContracting;
    for radius in RADII {
        match problem.attempt(&point, problem.unit.map(|unit| radius * unit)) {
            Ok(proof) => return Ok(proof),
            Err(error) => why = error,
        }
    }
    Err(why)
}

struct Problem<'a> {
    body: &'a Body,
    moments: [Interval; 3],
    center: [Interval; 3],
    h: Interval,
    l: Interval,
    start: [f64; 6],
    /// c₁ and c₂.
    forms: [[f64; 6]; 2],
    /// Units of γ and ω.
    unit: [f64; 6],
    turns: usize,
    longest: f64,
}

impl<'a> Problem<'a> {
    fn new(body: &'a Body, [h, l]: [&Number; 2], start: [f64; 6], turns: usize, longest: f64) -> Option<Self> {
        let exact = |x: &Number| Interval::rational(x.value(), ());
        let speed = start[3..].iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        let least = body.moments_f64().into_iter().fold(f64::INFINITY, f64::min);
        let weight = body.center_f64().into_iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        let speed = speed.max((weight / least).sqrt());
        let mut problem = Self {
            body,
            moments: body.moments().each_ref().map(exact),
            center: body.center().each_ref().map(exact),
            h: exact(h),
            l: exact(l),
            start,
            forms: [[0.0; 6]; 2],
            unit: [1.0, 1.0, 1.0, speed, speed, speed],
            turns,
            longest,
        };
        problem.forms = problem.tangents()?;
        start.iter().all(|x| x.is_finite()).then_some(problem)
    }

    /// Two linear forms independent of the four gradients: unit vectors orthogonal to them.
    fn tangents(&self) -> Option<[[f64; 6]; 2]> {
        let rows = self.gradients(&self.start.map(Interval::point));
        // In units of γ and ω the columns are of similar size.
        let scaled = SMatrix::<f64, 4, 6>::from_fn(|i, j| middle(rows[i][j]) * self.unit[j]);
        let mut basis: Vec<SVector<f64, 6>> = Vec::new();
        let candidates = (0..4).map(|i| scaled.row(i).transpose()).chain((0..6).map(|j| SVector::ith(j, 1.0)));
        let mut forms = Vec::new();
        for (k, mut v) in candidates.enumerate() {
            v = v.try_normalize(0.0)?;
            for _ in 0..2 {
                for e in &basis {
                    v -= e * e.dot(&v);
                }
            }
            let length = v.norm();
            if k < 4 && length < 1e-9 {
                return None;
            }
            // A plane of dimension two has two unit vectors of ℝ⁶ that are not nearly orthogonal to it.
            if k < 4 || length > 0.4 {
                basis.push(v / length);
                if k >= 4 {
                    forms.push(std::array::from_fn(|j| v[j] / length / self.unit[j]));
                }
            }
        }
        forms.truncate(2);
        forms.try_into().ok()
    }

    fn returns(&self, radii: [f64; 6]) -> Result<Vec<Return>, ProofError> {
        let starts = Starts::boxed(self.body, self.start, radii).ok_or(ProofError::Range)?;
        Ok(returns(self.body, &starts, Some(Sign::Negative), self.turns, self.longest)?)
    }

    /// |γ|² − 1, ⟨γ, Aω⟩ − l, H − h and S.
    fn integrals(&self, x: &Box6) -> [Interval; 4] {
        let ([a1, a2, a3], [r1, r2, r3]) = (self.moments, self.center);
        let [g1, g2, g3, w1, w2, w3] = *x;
        let half = Interval::point(0.5);
        [
            g1.square() + g2.square() + g3.square() - Interval::ONE,
            a1 * g1 * w1 + a2 * g2 * w2 + a3 * g3 * w3 - self.l,
            half * (a1 * w1.square() + a2 * w2.square() + a3 * w3.square()) - g1 * r1 - g2 * r2 - g3 * r3 - self.h,
            w1 * (r2 * g3 - r3 * g2) + w2 * (r3 * g1 - r1 * g3) + w3 * (r1 * g2 - r2 * g1),
        ]
    }

    /// Their gradients by γ and ω.
    fn gradients(&self, x: &Box6) -> [Box6; 4] {
        let (a, r) = (self.moments, self.center);
        let [g, w] = [[x[0], x[1], x[2]], [x[3], x[4], x[5]]];
        let both = |u: [Interval; 3], v: [Interval; 3]| [u[0], u[1], u[2], v[0], v[1], v[2]];
        let each = |u: [Interval; 3], v: [Interval; 3]| std::array::from_fn(|i| u[i] * v[i]);
        let cross = |u: [Interval; 3], v: [Interval; 3]| {
            std::array::from_fn(|i| u[(i + 1) % 3] * v[(i + 2) % 3] - u[(i + 2) % 3] * v[(i + 1) % 3])
        };
        [
            both(g.map(Interval::twice), [Interval::ZERO; 3]),
            both(each(a, w), each(a, g)),
            both(r.map(|x| -x), each(a, w)),
            both(cross(w, r), cross(r, g)),
        ]
    }

    fn form(&self, k: usize, x: &Box6) -> Interval {
        (0..6).fold(Interval::ZERO, |sum, j| sum + Interval::point(self.forms[k][j]) * x[j])
    }

    /// Krawczyk's operator on a box about the start.
    fn attempt(&self, point: &[Return], radii: [f64; 6]) -> Result<OrbitProof, ProofError> {
        let middle = self.start.map(Interval::point);
        let around: Box6 =
            std::array::from_fn(|i| Interval::between(self.start[i] - radii[i], self.start[i] + radii[i]));
        let offset: Box6 = std::array::from_fn(|i| around[i] - middle[i]);
        let found = self.returns(offset.map(Interval::magnitude))?;
        let (Some(last), Some(back)) = (found.last(), point.last()) else {
            return Err(ProofError::NotContracting);
        };
        // Each motion from the box crosses once in this time; for the start itself it is the crossing found for it
        // alone.
        if back.time[0] < last.time[0] || last.time[1] < back.time[1] {
            return Err(ProofError::NotContracting);
        }
        let derivative = self.derivative(&around, last);
        let inverse = inverted(&derivative).ok_or(ProofError::NotContracting)?;
        let moved: Box6 = std::array::from_fn(|i| back.state[i] - middle[i]);
        let [a, b, c, d] = self.integrals(&middle);
        let value = [a, b, c, d, self.form(0, &moved), self.form(1, &moved)];
        let defect = defect(&inverse, &derivative);
        let image: Box6 = std::array::from_fn(|i| {
            let newton = (0..6).fold(middle[i], |sum, j| sum - Interval::point(inverse[(i, j)]) * value[j]);
            (0..6).fold(newton, |sum, j| sum + defect[i][j] * offset[j])
        });
        if !(0..6).all(|i| around[i].lo < image[i].lo && image[i].hi < around[i].hi) {
            return Err(ProofError::NotContracting);
        }
        self.check_closed(&around, last)?;
        check_once(&image, &found)?;
        let trace = (0..6).fold(Interval::point(-3.0), |sum, i| sum + last.derivative[i][i]);
        Ok(OrbitProof {
            state: image.map(|x| [x.lo, x.hi]),
            period: last.time,
            trace: [trace.lo, trace.hi],
            crossings: last.crossings,
        })
    }

    /// DΦ over a box with its returns.
    fn derivative(&self, x: &Box6, back: &Return) -> Rows {
        let [a, b, c, d] = self.gradients(x);
        let moved = [0, 1].map(|k| {
            std::array::from_fn(|j| {
                (0..6).fold(Interval::ZERO, |sum, i| {
                    let entry = if i == j { back.derivative[i][j] - Interval::ONE } else { back.derivative[i][j] };
                    sum + Interval::point(self.forms[k][i]) * entry
                })
            })
        });
        [a, b, c, d, moved[0], moved[1]]
    }

    /// Part 2 of the theorem.
    fn check_closed(&self, x: &Box6, back: &Return) -> Result<(), ProofError> {
        let hull: Box6 =
            std::array::from_fn(|i| Interval { lo: x[i].lo.min(back.state[i].lo), hi: x[i].hi.max(back.state[i].hi) });
        let [a, b, c, d] = self.gradients(&hull);
        let rows = [a, b, c, d, self.forms[0].map(Interval::point), self.forms[1].map(Interval::point)];
        let inverse = inverted(&rows).ok_or(ProofError::NotContracting)?;
        let defect = defect(&inverse, &rows);
        // In the maximum norm of γ and ω in their units.
        let is_small = |i: usize| {
            let sum = (0..6).fold(Interval::ZERO, |sum, j| {
                let entry = Interval::point(defect[i][j].magnitude());
                sum + entry * Interval::point(self.unit[j]) / Interval::point(self.unit[i])
            });
            sum.hi < 1.0
        };
        if (0..6).all(is_small) { Ok(()) } else { Err(ProofError::NotContracting) }
    }
}

/// Checks that the orbit does not close at an earlier return.
fn check_once(x: &Box6, found: &[Return]) -> Result<(), ProofError> {
    let is_apart = |back: &Return| (0..6).any(|i| back.state[i].lo > x[i].hi || back.state[i].hi < x[i].lo);
    if found[..found.len() - 1].iter().all(is_apart) { Ok(()) } else { Err(ProofError::Repeated) }
}

fn middle(x: Interval) -> f64 {
    x.lo + 0.5 * (x.hi - x.lo)
}

/// The inverse of the midpoint matrix.
fn inverted(rows: &Rows) -> Option<Matrix> {
    Matrix::from_fn(|i, j| middle(rows[i][j])).try_inverse().filter(|inverse| inverse.iter().all(|x| x.is_finite()))
}

/// 1 − Y M.
fn defect(inverse: &Matrix, rows: &Rows) -> Rows {
    std::array::from_fn(|i| {
        std::array::from_fn(|j| {
            let one = Interval::point(f64::from(u8::from(i == j)));
            (0..6).fold(one, |sum, k| sum - Interval::point(inverse[(i, k)]) * rows[k][j])
        })
    })
}
