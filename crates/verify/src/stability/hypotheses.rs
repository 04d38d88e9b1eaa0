//! The points of a stretch with two imaginary pairs at index 2 at which a hypothesis of Arnold's theorem fails, and the verdict
//! there: the resonances are zeros of polynomials, and so are those of the determinant.

use std::rc::Rc;

use bifdiag_schema::{Failing, NonlinearVerdict, Reason};
use dashu_ratio::RBig;

use super::amplitudes::NormalForm;
use super::determinant::{Determinant, Rotations, is_axis};
use super::flow::Flow;
use super::modes::Rotation;
use super::range::{apart, narrow, uncertain};
use crate::Refused;
use crate::equilibria::pieces::Branch;
use crate::equilibria::spaces::Spaces;
use crate::numbers::ball::Ball;
use crate::numbers::isolation::roots;

/// Words of the numbers of normal forms: interpolation takes several bits for each degree, and beside special bodies more are
/// needed.
const WORDS: [usize; 3] = [3, 6, 24];

/// Bits to which a zero is narrowed at least, relative to its distance from the ends: l and h are compared with doubles.
const NARROW: usize = 64;

/// A stretch of a branch, by rising parameter.
#[derive(Clone)]
pub(super) struct Stretch {
    pub branch: Branch,
    pub flow: Rc<Flow>,
    /// Ranges that hold its ends.
    pub ends: [[RBig; 2]; 2],
    /// Where both frequencies are equal at an end that is counted with this stretch: the type beyond differs.
    pub collisions: [Option<bool>; 2],
}

/// A point at which a hypothesis fails.
#[derive(Clone)]
pub(super) struct Exception {
    pub kind: Failing,
    /// A range of the parameter.
    pub range: [RBig; 2],
    pub verdict: NonlinearVerdict,
    pub why: Reason,
    /// The verdicts on both sides differ.
    pub changes: bool,
}

/// The points of every stretch, with their verdicts; `None` where one of them is not decided.
pub(super) fn points(spaces: &Spaces, stretches: &[&Stretch]) -> Result<Vec<Option<Vec<Exception>>>, Refused> {
    let mut found = vec![None; stretches.len()];
    decide::<{ WORDS[0] }>(spaces, stretches, &mut found)?;
    decide::<{ WORDS[1] }>(spaces, stretches, &mut found)?;
    decide::<{ WORDS[2] }>(spaces, stretches, &mut found)?;
    Ok(found)
}

/// Decides what is open. The determinant in μ is one polynomial: stretches that touch, as those on both sides of a moment
/// do, share its values.
fn decide<const N: usize>(
    spaces: &Spaces,
    stretches: &[&Stretch],
    found: &mut [Option<Vec<Exception>>],
) -> Result<(), Refused> {
    let of = |stretch: &Stretch, range: [&RBig; 2]| Determinant::<N>::new(spaces, stretch.branch, &stretch.flow, range);
    let mut shared: Vec<(Rc<Flow>, [RBig; 2], Option<Determinant<N>>)> = Vec::new();
    for (stretch, found) in stretches.iter().zip(found).filter(|(_, found)| found.is_none()) {
        let run = stretch.run(stretches);
        let is_its = |known: &(Rc<Flow>, [RBig; 2], _)| Rc::ptr_eq(&known.0, &stretch.flow) && known.1 == run;
        let number = shared.iter().position(is_its).unwrap_or(shared.len());
        if number == shared.len() {
            shared.push((Rc::clone(&stretch.flow), run.clone(), of(stretch, run.each_ref())));
        }
        // A place in the whole run may be a moment.
        let alone = if shared[number].2.is_none() { of(stretch, stretch.whole()) } else { None };
        if let Some(determinant) = shared[number].2.as_ref().or(alone.as_ref()) {
            *found = stretch.points_with(spaces, determinant)?;
        }
    }
    Ok(())
}

impl Stretch {
    fn whole(&self) -> [&RBig; 2] {
        [&self.ends[0][0], &self.ends[1][1]]
    }

    /// D₄ is other than 0 somewhere, so that it vanishes at isolated points only.
    pub fn has_determinant(&self, spaces: &Spaces) -> bool {
        self.is_nonzero_somewhere::<{ WORDS[0] }>(spaces)
            || self.is_nonzero_somewhere::<{ WORDS[1] }>(spaces)
            || self.is_nonzero_somewhere::<{ WORDS[2] }>(spaces)
    }

    /// In the middle, or where that is a zero or a resonance, as it may be of a body with small numbers, beside it.
    fn is_nonzero_somewhere<const N: usize>(&self, spaces: &Spaces) -> bool {
        const PLACES: [[u8; 2]; 3] = [[1, 2], [3, 7], [5, 9]];
        let [from, to] = [&self.ends[0][1], &self.ends[1][0]];
        let sign = |[part, whole]: [u8; 2]| {
            let at = from + (to - from) * RBig::from_parts(part.into(), whole.into());
            NormalForm::new(&self.rotation::<N>(spaces, [&at, &at])?)?.arnold.strict_sign()
        };
        PLACES.into_iter().any(|place| sign(place).is_some())
    }

    fn rotation<const N: usize>(&self, spaces: &Spaces, [lo, hi]: [&RBig; 2]) -> Option<Rotation<N>> {
        Rotations::new(spaces, self.branch).at(&Ball::between(lo, hi))
    }

    /// The whole of the stretches that touch one another and this one, in μ.
    fn run(&self, stretches: &[&Self]) -> [RBig; 2] {
        let mut run = self.whole().map(RBig::clone);
        let is_neighbour = |other: &&&Self, run: &[RBig; 2]| {
            let [from, to] = other.whole();
            Rc::ptr_eq(&other.flow, &self.flow) && (*to == run[0] || *from == run[1])
        };
        while let Some(other) = stretches.iter().find(|other| is_neighbour(other, &run)) {
            let [from, to] = other.whole();
            run = [from.min(&run[0]).clone(), to.max(&run[1]).clone()];
        }
        run
    }

    fn points_with<const N: usize>(
        &self,
        spaces: &Spaces,
        determinant: &Determinant<N>,
    ) -> Result<Option<Vec<Exception>>, Refused> {
        let is_axis = is_axis(spaces, self.branch);
        let mut points = Vec::new();
        for (range, changes) in self.ends.iter().zip(self.collisions) {
            let Some(changes) = changes else { continue };
            // The right side of Theorem 13.10 has the sign of the polynomial over that of 4b² − 25c = −9c.
            let Some(sign) = determinant.sign(range) else { return Ok(None) };
            let verdict = if (sign > 0) == is_axis { NonlinearVerdict::Stable } else { NonlinearVerdict::Unstable };
            let (kind, why) = (Failing::Resonance11, Reason::Resonance11);
            points.push(Exception { kind, range: range.clone(), verdict, why, changes });
        }
        for (polynomial, kind) in self.flow.resonances().iter().zip([Failing::Resonance12, Failing::Resonance13]) {
            let found = roots(polynomial, self.whole()).ok_or_else(uncertain)?;
            for mut root in found {
                let is_inside = apart(&mut root, &self.ends[0])? && apart(&mut root, &self.ends[1])?;
                if !is_inside || root.hi < self.ends[0][1] || self.ends[1][0] < root.lo {
                    continue;
                }
                narrow(&mut root, self.whole(), spaces.bits());
                let range = [root.lo, root.hi];
                let judged = match kind {
                    Failing::Resonance12 if is_axis => {
                        determinant.sign(&range).map(|_| (NonlinearVerdict::Stable, Reason::Arnold))
                    }
                    Failing::Resonance12 => {
                        determinant.sign(&range).map(|_| (NonlinearVerdict::Unstable, Reason::Resonance12))
                    }
                    _ => self.markeev::<N>(spaces, &range),
                };
                let Some((verdict, why)) = judged else { return Ok(None) };
                points.push(Exception { kind, range, verdict, why, changes: false });
            }
        }
        let least = if N < WORDS[2] { NARROW } else { 0 };
        let zeros = |bits: usize| determinant.zeros(self.whole(), [bits, least]);
        let Some(found) = zeros(spaces.bits() / 2) else { return Ok(None) };
        let meets = |zero: &[RBig; 2], range: &[RBig; 2]| zero[0] <= range[1] && range[0] <= zero[1];
        let others: Vec<&[RBig; 2]> = points.iter().map(|point| &point.range).chain(&self.ends).collect();
        if found.iter().any(|zero| others.iter().any(|range| meets(zero, range))) {
            return Ok(None);
        }
        for (n, range) in found.into_iter().enumerate() {
            let is_decided = |range: &[RBig; 2]| self.has_sixth_degree::<N>(spaces, range);
            let decided = is_decided(&range) || zeros(N * 32).is_some_and(|found| found.get(n).is_some_and(is_decided));
            let (verdict, why) = match decided {
                true => (NonlinearVerdict::Stable, Reason::Arnold),
                false if N < WORDS[2] => return Ok(None),
                false => (NonlinearVerdict::Open, Reason::Degenerate),
            };
            points.push(Exception { kind: Failing::Determinant, range, verdict, why, changes: false });
        }
        Ok(Some(points))
    }

    /// D₆ is other than 0 where D₄ = 0.
    fn has_sixth_degree<const N: usize>(&self, spaces: &Spaces, [lo, hi]: &[RBig; 2]) -> bool {
        let sixth = self.rotation::<N>(spaces, [lo, hi]).and_then(|at| NormalForm::sixth(&at));
        sixth.is_some_and(|value| value.strict_sign().is_some())
    }

    /// At ω₁ = 3ω₂: |K₁₁ + 3K₁₂ + 9K₂₂| against 3√3|B|.
    fn markeev<const N: usize>(&self, spaces: &Spaces, [lo, hi]: &[RBig; 2]) -> Option<(NonlinearVerdict, Reason)> {
        let at = self.rotation::<N>(spaces, [lo, hi])?;
        let [k11, k12, k22] = &NormalForm::new(&at)?.twist;
        let along = &(k11 + &(&Ball::whole(3) * k12)) + &(&Ball::whole(9) * k22);
        let rest = &along.square() - &(&Ball::whole(27) * &NormalForm::quartic(&at)?);
        let verdict = if rest.strict_sign()? > 0 { NonlinearVerdict::Stable } else { NonlinearVerdict::Unstable };
        Some((verdict, Reason::Resonance13))
    }
}
