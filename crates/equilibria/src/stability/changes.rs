//! The linear type along every curve of a body, and where it changes: complete, from exact roots.

use std::fmt;

use dashu_ratio::RBig;

use super::exact::{ExactBody, ExactPoint, Family, Forms, Profile, StationKind, Strand};
use super::{Constants, LinearType, Signs, StabilitySpan, State};
use crate::curves::{Branch, CriticalSet, Curve, CurveId, Orbit, Pole};
use bifdiag_body::Body;
use bifdiag_numbers::Number;
use bifdiag_numbers::Sign;
use bifdiag_numbers::polynomial::{Polynomial, Root};
use bifdiag_numbers::table::Id;
use bifdiag_numbers::wide::Wide;

/// How the linear type changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum ChangeKind {
    /// Two imaginary pairs of opposite Krein sign meet and leave the axis.
    HamiltonianHopf,
    /// Two real pairs meet and become a complex quadruple.
    RealCollision,
    /// A pair of eigenvalues goes through zero: at a cusp, or where a pair of equilibria leaves the curve.
    Zero,
}

impl ChangeKind {
    /// The word for it.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::HamiltonianHopf => "hamiltonian-hopf",
            Self::RealCollision => "real-collision",
            Self::Zero => "zero",
        }
    }
}

impl fmt::Display for ChangeKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.word())
    }
}

/// A point of a branch at which the linear type changes. In the body's units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StabilityChange {
    /// Vertical angular momentum.
    pub l: f64,
    /// Energy.
    pub h: f64,
    /// Bound on the error of both.
    pub error_bound: f64,
    /// The curve on which it lies; at a cusp or pitchfork the first of the two.
    pub curve: CurveId,
    /// The curve that goes on after a cusp or pitchfork.
    pub onto: Option<CurveId>,
    /// What happens.
    pub kind: ChangeKind,
    /// The type before: at smaller l, or on `curve`.
    pub from: LinearType,
    /// The type after: at larger l, or on `onto`.
    pub to: LinearType,
}

/// The families of a body with everything that decides the linear type along them.
#[derive(Clone, Debug)]
pub struct StabilityProfile {
    body: ExactBody,
    forms: Option<Forms>,
    strands: Vec<(Strand, Profile)>,
}

/// Bits with which places of changes are evaluated.
const BITS: usize = 160;

impl StabilityProfile {
    /// Isolates every change. `None` when roots are closer than 2^-4000, which no body of the supported range has.
    #[must_use]
    pub fn new(body: &Body, set: &CriticalSet) -> Option<Self> {
        let body = ExactBody::new(body, &set.frame);
        if body.active.is_empty() {
            return Some(Self { body, forms: None, strands: Vec::new() });
        }
        let forms = Forms::new(&body);
        let generic = (0..=body.active.len()).map(|n| Strand::generic(&body, &forms, n));
        let over = body.passive.iter().map(|&axis| Strand::over(&body, axis));
        let strands: Option<Vec<_>> =
            generic.chain(over).map(|strand| Some((strand.clone(), Profile::new(&strand)?))).collect();
        Some(Self { strands: strands?, forms: Some(forms), body })
    }

    fn strand(&self, branch: Branch) -> Option<&(Strand, Profile)> {
        let family = family(branch)?;
        self.strands.iter().find(|(strand, _)| strand.family == family)
    }

    /// All relative equilibria of a branch at l ≠ 0, counted exactly; `None` without weight (Euler's rotations are not
    /// on families with a parameter).
    #[must_use]
    pub fn points(&self, branch: Branch, l: &Number) -> Option<Vec<ExactPoint>> {
        let (strand, profile) = self.strand(branch)?;
        let condition = strand.at_momentum(&self.body, self.forms.as_ref()?, &self.body.abscissa(l));
        ExactPoint::all(&self.body, strand, profile, &condition)
    }

    /// The same at one spin Ω ≠ 0.
    #[must_use]
    pub fn points_at_spin(&self, branch: Branch, omega: &RBig) -> Option<Vec<ExactPoint>> {
        let (strand, profile) = self.strand(branch)?;
        let condition = strand.at_spin(&self.body, self.forms.as_ref()?, &self.body.squared_spin(omega));
        ExactPoint::all(&self.body, strand, profile, &condition)
    }

    /// The exact body.
    #[must_use]
    pub fn body(&self) -> &ExactBody {
        &self.body
    }

    /// The types along a curve by rising l, in the body's units; `None` where f64 cut its branch otherwise.
    #[must_use]
    pub fn spans(&self, set: &CriticalSet, id: CurveId) -> Option<Vec<StabilitySpan>> {
        let curve = &set.curves[id];
        let [from, to] = curve.x().map(|x| (2.0 * x).sqrt() * set.frame.momentum_unit);
        let whole = |stability| StabilitySpan { l_from: from, l_to: to.is_finite().then_some(to), stability };
        if !curve.is_critical() {
            return Some(Vec::new());
        }
        let Some((strand, profile)) = self.strand(curve.branch) else {
            return Some(vec![whole(self.without_weight(curve))]);
        };
        let pieces = profile.pieces(strand.is_reversed);
        if pieces.len() != branch(set, curve.branch).count() {
            return None;
        }
        let stretches = pieces.get(curve.piece - 1)?.clone();
        let mut changes: Vec<(f64, LinearType)> = stretches
            .clone()
            .skip(1)
            .map(|k| (self.place(set, strand, &profile.stations[k - 1].root)[0].0, profile.types[k]))
            .collect();
        let mut first = profile.types[*stretches.start()];
        if !changes.is_empty() && !self.rises(set, strand, profile, *stretches.start()) {
            let mut types: Vec<LinearType> = std::iter::once(first).chain(changes.iter().map(|c| c.1)).collect();
            let mut places: Vec<f64> = changes.iter().map(|c| c.0).collect();
            types.reverse();
            places.reverse();
            first = types[0];
            changes = places.into_iter().zip(types.into_iter().skip(1)).collect();
        }
        let mut spans = vec![whole(first)];
        for (l, kind) in changes {
            let last = spans.len() - 1;
            if spans[last].stability != kind {
                spans[last].l_to = Some(l);
                spans.push(StabilitySpan { l_from: l, ..whole(kind) });
            }
        }
        Some(spans)
    }

    /// Every change of the linear type along a branch, by rising l, then h.
    #[must_use]
    pub fn changes(&self, set: &CriticalSet) -> Vec<StabilityChange> {
        let mut changes = Vec::new();
        for (strand, profile) in &self.strands {
            let here = |id: &CurveId| family(set.curves[*id].branch) == Some(strand.family);
            let mut curves: Vec<CurveId> = set.curves.ids().filter(here).collect();
            curves.sort_by_key(|&id| set.curves[id].piece);
            let pieces = profile.pieces(strand.is_reversed);
            if pieces.len() != curves.len() {
                continue;
            }
            for (k, station) in profile.stations.iter().enumerate() {
                let (mut from, mut to) = (profile.types[k], profile.types[k + 1]);
                if from == to {
                    continue;
                }
                let piece_of = |stretch: usize| pieces.iter().position(|piece| piece.contains(&stretch));
                let (Some(before), Some(after)) = (piece_of(k), piece_of(k + 1)) else { continue };
                let reversed = if station.is_cut() { strand.is_reversed } else { !self.rises(set, strand, profile, k) };
                if reversed {
                    std::mem::swap(&mut from, &mut to);
                }
                let [(l, l_error), (h, h_error)] = self.place(set, strand, &station.root);
                changes.push(StabilityChange {
                    l,
                    h,
                    error_bound: l_error.max(h_error),
                    curve: curves[before.min(after)],
                    onto: station.is_cut().then(|| curves[before.max(after)]),
                    kind: kind(station.kind, from, to),
                    from,
                    to,
                });
            }
        }
        changes.sort_by(|p, q| p.l.total_cmp(&q.l).then(p.h.total_cmp(&q.h)));
        changes
    }

    /// l rises with t from the sample of a stretch to the station after it.
    fn rises(&self, set: &CriticalSet, strand: &Strand, profile: &Profile, stretch: usize) -> bool {
        let t = &profile.samples[stretch];
        let sample = Root::exact(&Polynomial::from_rationals(&[-t, RBig::ONE]), t.clone());
        self.place(set, strand, &sample)[0].0 < self.place(set, strand, &profile.stations[stretch].root)[0].0
    }

    /// l and h at a point of a family, each with a bound on its error.
    fn place(&self, set: &CriticalSet, strand: &Strand, root: &Root) -> [(f64, f64); 2] {
        let c: Constants<Wide> = self.body.constants(BITS);
        let state: State<Wide> = strand.state(&self.body, &c, &mut root.clone(), BITS);
        state.place(&c, &set.frame)
    }

    /// The type of a rotation without weight: λ² = −Ω² and −Ω²(a_k − a_i)(a_k − a_j)/(a_i a_j).
    fn without_weight(&self, curve: &Curve) -> LinearType {
        let (Orbit::Pair(axis), a) = (curve.orbit, &self.body.a) else { return Signs::transverse_type(Sign::Positive) };
        let [i, j] = axis.others().map(|k| &a[k]);
        let product = (&a[axis] - i) * (&a[axis] - j);
        let apart = Sign::from(&(&product - i * j));
        Signs { b: Sign::Positive, c: Sign::from(&product), discriminant: apart * apart }.linear_type()
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

/// The curves of a branch.
fn branch(set: &CriticalSet, branch: Branch) -> impl Iterator<Item = &Curve> {
    set.curves.iter().filter(move |curve| curve.branch == branch)
}

fn kind(station: StationKind, from: LinearType, to: LinearType) -> ChangeKind {
    match station {
        StationKind::Collision(_) if [from, to].contains(&LinearType::Elliptic) => ChangeKind::HamiltonianHopf,
        StationKind::Collision(_) => ChangeKind::RealCollision,
        _ => ChangeKind::Zero,
    }
}
