//! Stability decided in exact arithmetic: the conditions for a change of the linear type as integer polynomials in the
//! parameter of each family (Proposition 13.4 of docs/algorithms.md), their roots isolated without exception.

mod body;
mod family_chart;
mod invariants;
mod profile;
mod strands;

use dashu_ratio::RBig;

use bifdiag_schema::StabilityChangeKind;

use super::changes::{Along, StabilityChange, Turn};
use super::{Constants, LinearType, Signs, State};
use crate::curves::{Branch, CriticalSet, Curve, CurveId, Orbit, Pole};
use bifdiag_body::Body;
use bifdiag_numbers::enclosure::Enclosure;
use bifdiag_numbers::polynomial::{Polynomial, Root};
use bifdiag_numbers::table::{Id, Table};
use bifdiag_numbers::wide::Wide;
use bifdiag_numbers::{Number, Sign};
use profile::Profile;

pub use body::{ExactBody, Forms};
pub(crate) use family_chart::{Family, FamilyChart};
pub use profile::{ExactPoint, Touch};
pub(crate) use profile::{StationKind, compare};
pub use strands::{Strand, StrandStretch};

/// The families of a body with everything that decides the linear type along them.
#[derive(Clone, Debug)]
pub struct StabilityProfile {
    body: ExactBody,
    forms: Option<Forms>,
    families: Vec<(FamilyChart, Profile)>,
}

/// Bits with which places of changes are evaluated.
const BITS: usize = 160;

impl StabilityProfile {
    /// Isolates every change. `None` when roots are closer than 2^-4000, which no body of the supported range has.
    #[must_use]
    pub fn new(body: &Body, set: &CriticalSet) -> Option<Self> {
        let body = ExactBody::new(body, &set.frame);
        if body.active.is_empty() {
            return Some(Self { body, forms: None, families: Vec::new() });
        }
        let forms = Forms::new(&body);
        let generic = (0..=body.active.len()).map(|n| FamilyChart::generic(&body, &forms, n));
        let over = body.passive.iter().map(|&axis| FamilyChart::over(&body, axis));
        let families: Option<Vec<_>> =
            generic.chain(over).map(|chart| Some((chart.clone(), Profile::new(&chart)?))).collect();
        Some(Self { families: families?, forms: Some(forms), body })
    }

    /// The numbers of the linearisation.
    #[must_use]
    pub fn constants(&self, bits: usize) -> Constants<Wide> {
        self.body.constants(bits)
    }

    /// All relative equilibria of a branch at l ≠ 0, counted exactly; `None` without weight (Euler's rotations are not
    /// on families with a parameter).
    #[must_use]
    pub fn points(&self, branch: Branch, l: &Number) -> Option<Vec<ExactPoint>> {
        let (chart, profile) = self.on(branch)?;
        let condition = chart.at_momentum(&self.body, self.forms.as_ref()?, &self.body.abscissa(l));
        ExactPoint::all(&self.body, chart, profile, &condition)
    }

    /// The same at one spin Ω ≠ 0, from Ω⁴.
    #[must_use]
    pub fn points_at_spin(&self, branch: Branch, fourth: &RBig) -> Option<Vec<ExactPoint>> {
        let (chart, profile) = self.on(branch)?;
        let condition = chart.at_spin(&self.body, self.forms.as_ref()?, &self.body.fourth_power_of_spin(fourth));
        ExactPoint::all(&self.body, chart, profile, &condition)
    }

    /// An equilibrium of a branch, enclosed in intervals of some precision, from a root with this many bits.
    #[must_use]
    pub fn refined<E: Enclosure>(
        &self,
        branch: Branch,
        point: &ExactPoint,
        precision: (E::Precision, usize),
    ) -> Option<(Constants<E>, State<E>)> {
        Some(point.refined(&self.body, &self.on(branch)?.0, precision))
    }

    /// Which of the resonances 1:2 and 1:3, between imaginary pairs, hold there.
    #[must_use]
    pub fn resonances(&self, branch: Branch, point: &ExactPoint) -> Option<[bool; 2]> {
        let [_, two, three] = &self.on(branch)?.0.resonances;
        Some([two, three].map(|polynomial| point.is_root_of(polynomial)))
    }

    /// The exact body.
    pub(crate) fn body(&self) -> &ExactBody {
        &self.body
    }

    /// How many families there are.
    pub(crate) fn family_count(&self) -> usize {
        self.families.len()
    }

    /// The families with what is known along them, and the curves of each by rising number of their piece; none where f64 cut
    /// the branch otherwise.
    pub(crate) fn families(&self, set: &CriticalSet) -> Vec<(&FamilyChart, &Profile, Vec<CurveId>)> {
        let mut list = Vec::new();
        for (chart, profile) in &self.families {
            let here = |id: &CurveId| family(set.curves[*id].branch) == Some(chart.family);
            let mut curves: Vec<CurveId> = set.curves.ids().filter(here).collect();
            curves.sort_by_key(|&id| set.curves[id].piece);
            if profile.pieces(chart.is_reversed).len() == curves.len() {
                list.push((chart, profile, curves));
            }
        }
        list
    }

    /// Whether `f64` cut a branch into as many curves.
    #[must_use]
    pub fn is_cut_alike(&self, branch: Branch, curves: usize) -> bool {
        self.on(branch).is_some_and(|(chart, profile)| profile.pieces(chart.is_reversed).len() == curves)
    }

    /// The family of a branch.
    fn on(&self, branch: Branch) -> Option<&(FamilyChart, Profile)> {
        let family = family(branch)?;
        self.families.iter().find(|(chart, _)| chart.family == family)
    }

    /// The types along the curves, `None` where f64 cut the branch otherwise, and the changes from one curve to another.
    pub(super) fn along(&self, set: &CriticalSet) -> (Table<CurveId, Option<Along>>, Vec<StabilityChange>) {
        let mut along: Table<CurveId, Option<Along>> = set.curves.map(|curve| match family(curve.branch) {
            None => Some(Along::default()),
            Some(_) if self.forms.is_none() => {
                Some(Along { first: Some(self.without_weight(curve)), turns: Vec::new() })
            }
            Some(_) => None,
        });
        let mut between = Vec::new();
        for (chart, profile, curves) in self.families(set) {
            let pieces = profile.pieces(chart.is_reversed);
            let changes = |k: &usize| profile.types[*k] != profile.types[*k + 1];
            // The change at station k, by rising t.
            let turn = |k: usize| {
                let (station, from, to) = (&profile.stations[k], profile.types[k], profile.types[k + 1]);
                Turn { place: self.place(set, chart, &station.root), from, to, kind: kind(station.kind, from, to) }
            };
            for (piece, &id) in pieces.iter().zip(&curves) {
                let inside: Vec<usize> = (*piece.start()..*piece.end()).filter(changes).collect();
                let mut turns: Vec<Turn> = inside.iter().map(|&k| turn(k)).collect();
                let mut first = profile.types[*piece.start()];
                if inside.first().is_some_and(|&k| !self.rises(set, chart, profile, k)) {
                    turns = turns.into_iter().rev().map(Turn::reversed).collect();
                    first = profile.types[*piece.end()];
                }
                along[id] = Some(Along { first: Some(first), turns });
            }
            let piece_of = |stretch: usize| pieces.iter().position(|piece| piece.contains(&stretch));
            for k in (0..profile.stations.len()).filter(|&k| profile.stations[k].is_cut()).filter(changes) {
                let (Some(before), Some(after)) = (piece_of(k), piece_of(k + 1)) else { continue };
                let turn = if chart.is_reversed { turn(k).reversed() } else { turn(k) };
                between.push(turn.on(curves[before.min(after)], Some(curves[before.max(after)])));
            }
        }
        (along, between)
    }

    /// l rises with t from the sample of a stretch to the station after it.
    fn rises(&self, set: &CriticalSet, chart: &FamilyChart, profile: &Profile, stretch: usize) -> bool {
        let t = &profile.samples[stretch];
        let sample = Root::exact(&Polynomial::from_rationals(&[-t, RBig::ONE]), t.clone());
        self.place(set, chart, &sample)[0].0 < self.place(set, chart, &profile.stations[stretch].root)[0].0
    }

    /// l and h at a point of a family, each with a bound on its error.
    fn place(&self, set: &CriticalSet, chart: &FamilyChart, root: &Root) -> [(f64, f64); 2] {
        let c: Constants<Wide> = self.body.constants(BITS);
        let state: State<Wide> = chart.state(&self.body, &c, &mut root.clone(), BITS);
        state.place(&c, &set.frame)
    }

    /// The type of a rotation without weight: λ² = −Ω² and −Ω²(a_k − a_i)(a_k − a_j)/(a_i a_j).
    pub(crate) fn without_weight(&self, curve: &Curve) -> LinearType {
        let (Orbit::Pair(axis), a) = (curve.orbit, &self.body.a) else { return Signs::transverse_type(Sign::Positive) };
        let [i, j] = axis.others().map(|k| &a[k]);
        let product = (&a[axis] - i) * (&a[axis] - j);
        let sign = |x: &RBig| Sign::from(x.numerator());
        let apart = sign(&(&product - i * j));
        Signs { b: Sign::Positive, c: sign(&product), discriminant: apart * apart }.linear_type()
    }
}

/// The family of a branch.
fn family(branch: Branch) -> Option<Family> {
    match branch {
        Branch::Generic(n) => Some(Family::Generic(n.index())),
        Branch::Axis(Pole::Minus) => Some(Family::Generic(0)),
        Branch::Axis(Pole::Plus) => Some(Family::Generic(1)),
        Branch::Symmetric(axis) => Some(Family::Over(axis)),
        Branch::Pole(_) => None,
    }
}

fn kind(station: StationKind, from: LinearType, to: LinearType) -> StabilityChangeKind {
    match station {
        StationKind::Collision(_) if [from, to].contains(&LinearType::Elliptic) => StabilityChangeKind::HamiltonianHopf,
        StationKind::Collision(_) => StabilityChangeKind::RealCollision,
        _ => StabilityChangeKind::Zero,
    }
}
