//! ∂U_hl on single latitudes, in the coordinates of the PP-torus, for drawing.

use super::angle::Trig;
use super::circle::{Circle, root_between};
use super::error::{Effort, Obstacle, SweepError, check_finite};
use super::level::Level;
use bifdiag_body::Frame;
use bifdiag_numbers::vector::{cross, dot};

/// An accessible arc of a circle of latitude, from `start` in the direction of growing ψ' to `end`;
/// both are (cos ψ', sin ψ').
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Arc {
    /// Where the arc begins.
    pub start: [f64; 2],
    /// Where it ends.
    pub end: [f64; 2],
}

/// The accessible part of a circle of latitude.
#[derive(Clone, Debug, PartialEq)]
pub enum Arcs {
    /// The circle lies outside U_hl.
    Nothing,
    /// The circle lies in U_hl.
    Everything,
    /// One or two arcs.
    Part(Vec<Arc>),
}

/// The circles of latitude ⟨γ,r̂⟩ = c of one body at one (h, l).
///
/// ψ' is measured as in the paper's Fig. Projections12: γ = sin ϑ'(sin ψ' e_x' + cos ψ' e_y') + cos ϑ' r̂ with
/// (e_x', e_y', r̂) right-handed and e_y' the normalised projection of the body's third axis onto the plane ⊥ r̂
/// (of the second if r̂ lies on the third). For r = 0 the frame's third axis takes the place of r̂.
#[derive(Clone, Debug)]
pub struct Latitudes {
    level: Level,
    zero_momentum: bool,
    /// (cos ψ', sin ψ') of the internal tangent vectors e1 and e2.
    tangent: [[f64; 2]; 2],
}

impl Latitudes {
    /// For h and l in the frame's units.
    ///
    /// # Errors
    /// [`SweepError::NotFinite`].
    pub fn new(frame: &Frame, h: f64, l: f64) -> Result<Self, SweepError> {
        check_finite(h, l)?;
        let level = Level::new(frame, h, l);
        let pole = frame.vector_to_body(level.pole);
        let [x, y, z] = pole;
        let n = (x * x + y * y).sqrt();
        let e_y = if n > 0.0 { [-z * x / n, -z * y / n, n] } else { [0.0, 1.0, 0.0] };
        let e_x = cross(e_y, pole);
        let tangent = level.tangent.map(|e| {
            let e = frame.vector_to_body(e);
            [dot(e, e_y), dot(e, e_x)]
        });
        Ok(Self { level, zero_momentum: l == 0.0, tangent })
    }

    /// The accessible arcs on the latitude c, their number certified, their ends to the last few bits.
    ///
    /// # Errors
    /// [`SweepError::NoLatitude`]; [`SweepError::Undecided`] when the circle is tangent to ∂U_hl within rounding.
    pub fn arcs_at(&self, c: f64) -> Result<Arcs, SweepError> {
        if !(-1.0..=1.0).contains(&c) {
            return Err(SweepError::NoLatitude { cosine: c });
        }
        let theta = Trig::of_cosine(c);
        let mut effort = Effort::new();
        let circle = if self.zero_momentum {
            let accessible = self.level.height(&theta).is_positive();
            return accessible
                .map(|yes| if yes { Arcs::Everything } else { Arcs::Nothing })
                .ok_or_else(|| undecided(c, effort));
        } else if c.abs() == 1.0 {
            Circle::pole(&self.level, theta, 0)
        } else {
            Circle::new(&self.level, theta, 0, &mut effort)
        }
        .ok_or_else(|| undecided(c, effort))?;
        let mut starts = Vec::new();
        let mut ends = Vec::new();
        for (here, next) in circle.roots() {
            let end = self.longitude(&root_between(&self.level, &theta, here, next).trig());
            if next.accessible { starts.push(end) } else { ends.push(end) }
        }
        if starts.is_empty() {
            return Ok(if circle.marks[0].accessible { Arcs::Everything } else { Arcs::Nothing });
        }
        // Roots alternate; bring each arc's start before its end.
        if circle.marks[0].accessible {
            ends.rotate_left(1);
        }
        let [[a, b], [d, e]] = self.tangent;
        let reflected = a * e - b * d < 0.0;
        let arcs = starts
            .into_iter()
            .zip(ends)
            .map(|(start, end)| if reflected { Arc { start: end, end: start } } else { Arc { start, end } });
        Ok(Arcs::Part(arcs.collect()))
    }

    /// (cos ψ', sin ψ') of an internal longitude.
    fn longitude(&self, psi: &Trig) -> [f64; 2] {
        let (cos, sin) = (0.5 * (psi.cos.lo + psi.cos.hi), 0.5 * (psi.sin.lo + psi.sin.hi));
        let [e1, e2] = self.tangent;
        [cos * e1[0] + sin * e2[0], cos * e1[1] + sin * e2[1]]
    }
}

fn undecided(cosine: f64, effort: Effort) -> SweepError {
    SweepError::Undecided { cosine, obstacle: Obstacle::Singularity, effort: effort.spent() }
}
