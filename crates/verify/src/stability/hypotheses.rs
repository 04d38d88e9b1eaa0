//! The points of a stretch with two imaginary pairs at index 2 at which a hypothesis of Arnold's theorem fails, and the verdict
//! there: the resonances are zeros of polynomials, and so are those of the determinant.

use std::rc::Rc;

use bifdiag_schema::{Failing, NonlinearVerdict, Reason};
use dashu_ratio::RBig;

use super::amplitudes::NormalForm;
use super::determinant::{Determinant, is_axis, rotation};
use super::flow::Flow;
use super::range::{apart, narrow, uncertain};
use crate::Refused;
use crate::equilibria::pieces::Branch;
use crate::equilibria::spaces::Spaces;
use crate::numbers::ball::Ball;
use crate::numbers::isolation::roots;

/// Words of the numbers of normal forms: interpolation takes several bits for each degree, and beside special bodies more are
/// needed.
const WORDS: [usize; 3] = [4, 8, 24];

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

impl Stretch {
    fn whole(&self) -> [&RBig; 2] {
        [&self.ends[0][0], &self.ends[1][1]]
    }

    /// D₄ is other than 0 somewhere, so that it vanishes at isolated points only.
    pub fn has_determinant(&self, spaces: &Spaces) -> bool {
        self.is_nonzero_in_the_middle::<{ WORDS[0] }>(spaces).is_some()
            || self.is_nonzero_in_the_middle::<{ WORDS[1] }>(spaces).is_some()
            || self.is_nonzero_in_the_middle::<{ WORDS[2] }>(spaces).is_some()
    }

    fn is_nonzero_in_the_middle<const N: usize>(&self, spaces: &Spaces) -> Option<i8> {
        let middle = (&self.ends[0][1] + &self.ends[1][0]) / RBig::from(2);
        let at = rotation::<N>(spaces, self.branch, &Ball::of(&middle))?;
        NormalForm::new(&at)?.arnold.strict_sign()
    }

    /// Every point, with its verdict; `None` where one of them is not decided.
    pub fn points(&self, spaces: &Spaces) -> Result<Option<Vec<Exception>>, Refused> {
        let few = self.points_with::<{ WORDS[0] }>(spaces)?;
        let more = few.map_or_else(|| self.points_with::<{ WORDS[1] }>(spaces), |few| Ok(Some(few)))?;
        more.map_or_else(|| self.points_with::<{ WORDS[2] }>(spaces), |more| Ok(Some(more)))
    }

    fn points_with<const N: usize>(&self, spaces: &Spaces) -> Result<Option<Vec<Exception>>, Refused> {
        let Some(determinant) = Determinant::<N>::new(spaces, self.branch, &self.flow, self.whole()) else {
            return Ok(None);
        };
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
        let Some(zeros) = determinant.zeros(spaces.bits() / 2) else { return Ok(None) };
        let meets = |zero: &[RBig; 2], range: &[RBig; 2]| zero[0] <= range[1] && range[0] <= zero[1];
        let others: Vec<&[RBig; 2]> = points.iter().map(|point| &point.range).chain(&self.ends).collect();
        if zeros.iter().any(|zero| others.iter().any(|range| meets(zero, range))) {
            return Ok(None);
        }
        let sharper = || determinant.zeros(N * 32);
        for (n, range) in zeros.into_iter().enumerate() {
            let is_decided = |range: &[RBig; 2]| self.has_sixth_degree::<N>(spaces, range);
            let decided = is_decided(&range) || sharper().is_some_and(|zeros| zeros.get(n).is_some_and(is_decided));
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
        let sixth = rotation::<N>(spaces, self.branch, &Ball::between(lo, hi)).and_then(|at| NormalForm::sixth(&at));
        sixth.is_some_and(|value| value.strict_sign().is_some())
    }

    /// At ω₁ = 3ω₂: |K₁₁ + 3K₁₂ + 9K₂₂| against 3√3|B|.
    fn markeev<const N: usize>(&self, spaces: &Spaces, [lo, hi]: &[RBig; 2]) -> Option<(NonlinearVerdict, Reason)> {
        let at = rotation::<N>(spaces, self.branch, &Ball::between(lo, hi))?;
        let [k11, k12, k22] = &NormalForm::new(&at)?.twist;
        let along = &(k11 + &(&Ball::whole(3) * k12)) + &(&Ball::whole(9) * k22);
        let rest = &along.square() - &(&Ball::whole(27) * &NormalForm::quartic(&at)?);
        let verdict = if rest.strict_sign()? > 0 { NonlinearVerdict::Stable } else { NonlinearVerdict::Unstable };
        Some((verdict, Reason::Resonance13))
    }
}
