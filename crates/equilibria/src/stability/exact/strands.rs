//! The families of relative equilibria by rising spin: each cut where its spin turns, with the types along the strands.
//!
//! On the generic family Ω⁴ = P = Σ r_k²/(μ − a_k)² (Theorem 3.2 of docs/mathematics.md), which is convex between two
//! moments that carry r and monotone beyond them: between two there is one fold, where P′ = 0, and beyond them none. Over a
//! passive moment Ω⁴ = 1/z falls with z.

use std::cmp::Ordering;

use dashu_ratio::RBig;

use super::body::Forms;
use super::family_chart::{Family, FamilyChart};
use super::profile::{Profile, compare};
use super::{BITS, StabilityProfile, kind};
use crate::curves::{Branch, IntervalId, Pole};
use crate::stability::{Constants, LinearType, Reduced, StabilityChangeKind, State};
use bifdiag_body::Axis;
use bifdiag_numbers::Sign;
use bifdiag_numbers::enclosure::Enclosure;
use bifdiag_numbers::polynomial::{Polynomial, Root};
use bifdiag_numbers::table::Id;
use bifdiag_numbers::wide::Wide;
use bifdiag_schema::SteadyStart;

/// A part of a strand with one type.
#[derive(Clone, Debug)]
pub struct StrandStretch {
    /// Where it begins; `None` at rest.
    pub from: Option<State<Wide>>,
    /// Which eigenvalues meet there; `None` where the strand itself begins.
    pub change: Option<StabilityChangeKind>,
    /// The linear type.
    pub kind: LinearType,
    /// Morse index of U_l; on a circle of its one normal direction.
    pub index: u8,
}

/// A part of a family along which the spin rises without end.
#[derive(Clone, Debug)]
pub struct Strand {
    /// Its branch.
    pub branch: Branch,
    /// How it begins.
    pub start: SteadyStart,
    /// By rising spin.
    pub stretches: Vec<StrandStretch>,
    /// The axis of the frame to which γ tends at fast spins, and on which side of it.
    pub fast: (Axis, Sign),
}

impl StabilityProfile {
    /// Every family, cut into strands; none without weight. `None` where roots are closer than 2^-4000.
    #[must_use]
    pub fn strands(&self) -> Option<Vec<Strand>> {
        let Some(forms) = &self.forms else { return Some(Vec::new()) };
        let mut strands = Vec::new();
        for (chart, profile) in &self.families {
            strands.extend(self.strands_of(chart, profile, forms)?);
        }
        Some(strands)
    }

    fn strands_of(&self, chart: &FamilyChart, profile: &Profile, forms: &Forms) -> Option<Vec<Strand>> {
        let c: Constants<Wide> = self.body.constants(BITS + 64);
        let state = |root: &mut Root| chart.state(&self.body, &c, root, BITS);
        let last = profile.types.len() - 1;
        let active = &self.body.active;
        let (branch, fast) = match chart.family {
            Family::Over(axis) => (Branch::Symmetric(axis), [Some((axis, Sign::Positive)), None]),
            Family::Generic(n) => {
                let branch = match (active.len(), n) {
                    (1, 0) => Branch::Axis(Pole::Minus),
                    (1, _) => Branch::Axis(Pole::Plus),
                    _ => Branch::Generic(IntervalId::at(n)),
                };
                let left = n.checked_sub(1).map(|k| (active[k], Sign::Positive));
                let right = active.get(n).map(|&k| (k, Sign::Negative));
                // γ_k = r_k/(s (μ − a_k)); towards t = 0 lies the left moment, if there is one.
                (branch, if left.is_some() { [left, right] } else { [right, None] })
            }
        };
        let strand = |start, from: Option<State<Wide>>, order: Vec<usize>, fast| {
            Some(Strand { branch, start, stretches: self.stretches(chart, profile, from, &order)?, fast })
        };
        let falling = |from: usize| (0..=from).rev().collect::<Vec<_>>();
        match (chart.family, fast) {
            (Family::Over(_), [Some(fast), _]) => {
                let one = &Polynomial::from_rationals(&[-RBig::ONE, RBig::ONE]);
                let fork = state(&mut Root::exact(one, RBig::ONE));
                Some(vec![strand(SteadyStart::Fork, Some(fork), falling(last), fast)?])
            }
            (_, [Some(fast), None]) => Some(vec![strand(SteadyStart::Rest, None, falling(last), fast)?]),
            (_, [Some(left), Some(right)]) => {
                let mut found = chart.roots(&chart.fold(&self.body, forms))?;
                let mut fold = found.pop().filter(|_| found.is_empty())?;
                fold.refine(BITS);
                let (mut below, mut at) = (0, 0);
                for station in &profile.stations {
                    match compare(&mut station.root.clone(), &mut fold) {
                        Ordering::Less => below += 1,
                        Ordering::Equal => at = 1,
                        Ordering::Greater => break,
                    }
                }
                let from = state(&mut fold);
                let down = strand(SteadyStart::Fold, Some(from.clone()), falling(below), left)?;
                let up = strand(SteadyStart::Fold, Some(from), (below + at..=last).collect(), right)?;
                Some(vec![down, up])
            }
            _ => None,
        }
    }

    /// Stretches in the order in which a strand meets them, one for those in a row that agree.
    fn stretches(
        &self,
        chart: &FamilyChart,
        profile: &Profile,
        mut from: Option<State<Wide>>,
        order: &[usize],
    ) -> Option<Vec<StrandStretch>> {
        let c: Constants<Wide> = self.body.constants(BITS + 64);
        let mut list: Vec<StrandStretch> = Vec::new();
        for (number, &k) in order.iter().enumerate() {
            let (kind_here, index) = (profile.types[k], self.index_at(chart, &profile.samples[k])?);
            let mut change = None;
            if let Some(before) = number.checked_sub(1).map(|before| order[before]) {
                if list.last().is_some_and(|last| (last.kind, last.index) == (kind_here, index)) {
                    continue;
                }
                let station = &profile.stations[before.min(k)];
                from = Some(chart.state(&self.body, &c, &mut station.root.clone(), BITS));
                change = Some(kind(station.kind, profile.types[before], kind_here));
            }
            list.push(StrandStretch { from: from.clone(), change, kind: kind_here, index });
        }
        Some(list)
    }

    /// The Morse index at a rational t that is no station.
    fn index_at(&self, chart: &FamilyChart, t: &RBig) -> Option<u8> {
        /// Times that the precision is doubled: c is not 0 there.
        const ATTEMPTS: u32 = 8;
        let at = Polynomial::from_rationals(&[-t, RBig::ONE]);
        (0..ATTEMPTS).find_map(|attempt| {
            let bits = BITS << attempt;
            let c: Constants<Wide> = self.body.constants(bits + 64);
            let state = chart.state(&self.body, &c, &mut Root::exact(&at, t.clone()), bits);
            let trace = state.hessian_trace(&c).sign();
            if chart.is_circle() {
                return match trace? {
                    Sign::Positive => Some(0),
                    Sign::Negative => Some(1),
                    Sign::Zero => None,
                };
            }
            Reduced::new(&c, &state).index(trace)
        })
    }
}
