//! The linear type along every curve and where it changes, as a document gives them, against the signs of the linearised
//! flow: between the ends of curves it changes where b² − 4c changes its sign (on a circle of equilibria, b), and all
//! zeros of that are isolated. Where Arnold's theorem decides, its hypotheses are checked along the whole stretch by another
//! normal form than the program's.

mod amplitudes;
mod determinant;
mod expansion;
mod flow;
mod hypotheses;
mod modes;
mod range;
mod verdicts;

use std::rc::Rc;

use bifdiag_schema::{
    AtlasDocument, CurveDocument, Failing, NonlinearVerdict, Reason, Stability, StabilityChangeDocument,
    StabilityChangeKind, VerdictChangeDocument,
};
use dashu_ratio::RBig;

use crate::Refused;
use crate::equilibria::pieces::{Branch, End, coordinates, distance};
use crate::equilibria::places::{Point, Side};
use crate::equilibria::spaces::Spaces;
use crate::numbers::bounds::{is_at_most, is_root_within, is_within, roundings};
use crate::numbers::fixed::Fixed;
use crate::numbers::isolation::{Root, roots};
use crate::order::orders::Orders;
use flow::{Flow, without_weight};
use hypotheses::{Exception, Stretch};
use range::{CHANGES, apart, narrow, uncertain};

/// The part of the bits to which a root's range is narrowed, relative to its distance from the ends of the branch; the others are
/// for what cancels where the root is evaluated.
const NARROW: [usize; 2] = [1, 2];
/// Numbers that a document rounds from doubles.
const ROUNDED: f64 = 1e-9;

/// Largest stated error, in roundings of l, h and |r|.
const ROUNDINGS: u32 = 256;

/// A list that is wrong is so at every precision.
pub(crate) const VERDICTS: Refused = Refused::Field { field: "verdict_changes" };

/// The types along a curve, by rising x, and the roots between them.
pub(crate) struct Along {
    curve: usize,
    types: Vec<Stability>,
    turns: Vec<[Fixed; 2]>,
    /// Stretches with two imaginary pairs, by rising parameter.
    elliptic: Vec<Stretch>,
}

/// What a document ought to say of one change, in the certificate's units.
struct Change {
    curve: usize,
    onto: Option<usize>,
    kind: StabilityChangeKind,
    from: Stability,
    to: Stability,
    /// x and h.
    at: [Fixed; 2],
}

/// Checks the types and verdicts along all curves and every change; the types, and the curves with a verdict that is not
/// checked.
pub(crate) fn check(document: &AtlasDocument, orders: &Orders) -> Result<(Vec<Along>, Vec<String>), Refused> {
    let along = along_all(orders)?;
    let l2 = orders.spaces.square_of_momentum();
    let mut unchecked = Vec::new();
    for curve in &document.curves {
        let own = along.iter().find(|along| orders.pieces.list[along.curve].id == curve.id);
        if !spans(curve, own, &l2) {
            return Err(Refused::Field { field: "curves.stability" });
        }
        if let Some(own) = own
            && !verdicts::check(orders, curve, own.curve, &own.elliptic)?
        {
            unchecked.push(curve.id.clone());
        }
    }
    let expected = changes(orders, &along)?;
    let listed = &document.stability_changes;
    let ordered = listed.is_sorted_by(|p, q| p.l < q.l || (p.l == q.l && p.h <= q.h));
    if listed.len() != expected.len() || !ordered {
        return Err(CHANGES);
    }
    let mut open: Vec<&StabilityChangeDocument> = listed.iter().collect();
    for change in &expected {
        let at = open.iter().position(|claim| change.is_listed(claim, orders, &l2)).ok_or(CHANGES)?;
        open.remove(at);
    }
    Ok((along, unchecked))
}

/// Checks the points at which a hypothesis of Arnold's theorem fails; enters curves on which they are not decided.
pub(crate) fn exceptions(
    document: &AtlasDocument,
    orders: &Orders,
    along: &[Along],
    unchecked: &mut Vec<String>,
) -> Result<(), Refused> {
    let Some(claims) = &document.verdict_changes else { return Ok(()) };
    let l2 = orders.spaces.square_of_momentum();
    let id = |own: &Along| orders.pieces.list[own.curve].id.clone();
    let mut needed: Vec<&Along> = Vec::new();
    for own in along {
        let curve = document.curves.iter().find(|curve| curve.id == id(own)).ok_or_else(uncertain)?;
        if verdicts::needs_normal_form(orders, curve, own.curve) {
            needed.push(own);
        }
    }
    let stretches: Vec<&Stretch> = needed.iter().flat_map(|own| &own.elliptic).collect();
    let mut found = hypotheses::points(orders.spaces, &stretches)?.into_iter();
    let (mut expected, mut undecided) = (Vec::new(), Vec::new());
    for own in needed {
        let points: Vec<Option<Vec<_>>> = found.by_ref().take(own.elliptic.len()).collect();
        match points.into_iter().collect::<Option<Vec<_>>>() {
            Some(points) => expected.extend(points.into_iter().flatten().map(|point| (own, point))),
            None => undecided.push(id(own)),
        }
    }
    let (open, mut checked): (Vec<_>, Vec<_>) = claims.iter().partition(|claim| undecided.contains(&claim.curve));
    let ordered = claims.is_sorted_by(|p, q| p.l < q.l || (p.l == q.l && p.h <= q.h));
    if open.iter().any(|claim| claim.proved) {
        return Err(uncertain());
    }
    if checked.len() != expected.len() || !ordered {
        return Err(VERDICTS);
    }
    for (own, exception) in &expected {
        let branch = orders.pieces.list[own.curve].branch;
        let at = place(orders.spaces, branch, exception.range.each_ref()).ok_or_else(uncertain)?;
        let is_it = |claim: &&VerdictChangeDocument| {
            claim.curve == id(own)
                && exception.is_listed(claim)
                && is_there(claim.l, claim.h, claim.error_bound, &at, orders, &l2)
        };
        let found = checked.iter().position(is_it).ok_or(VERDICTS)?;
        checked.remove(found);
    }
    undecided.retain(|curve| !unchecked.contains(curve));
    unchecked.extend(undecided);
    Ok(())
}

/// The types along every critical curve.
fn along_all(orders: &Orders) -> Result<Vec<Along>, Refused> {
    let (spaces, pieces) = (orders.spaces, orders.pieces);
    let mut branches: Vec<Branch> = Vec::new();
    for piece in pieces.list.iter().filter(|piece| piece.critical) {
        if !branches.contains(&piece.branch) {
            branches.push(piece.branch);
        }
    }
    let (mut found, mut shared) = (Vec::new(), None);
    for branch in branches {
        let curves = (0..pieces.list.len()).filter(|&c| pieces.list[c].branch == branch && pieces.list[c].critical);
        if let Branch::Rotation(base) = branch {
            let types = vec![without_weight(spaces, base)];
            let still = |curve| Along { curve, types: types.clone(), turns: Vec::new(), elliptic: Vec::new() };
            found.extend(curves.map(still));
            continue;
        }
        let flow = &flow_of(orders, branch, &mut shared)?;
        let whole = range::of(spaces, pieces, branch, flow.condition()).ok_or(CHANGES)?;
        let mut zeros = roots(flow.condition(), whole.each_ref()).ok_or(CHANGES)?;
        for curve in curves {
            found.push(along(orders, flow, &whole, &mut zeros, curve)?);
        }
    }
    Ok(found)
}

/// The linearised flow along a branch with a parameter; that in μ is one for all branches.
fn flow_of(orders: &Orders, branch: Branch, shared: &mut Option<Rc<Flow>>) -> Result<Rc<Flow>, Refused> {
    match branch {
        Branch::Over(base) => Ok(Rc::new(Flow::over(orders.spaces, base))),
        Branch::Rotation(_) => Err(CHANGES),
        _ if orders.spaces.active.is_empty() => Err(CHANGES),
        _ => Ok(Rc::clone(shared.get_or_insert_with(|| Rc::new(Flow::generic(orders.spaces))))),
    }
}

/// The types along one curve.
fn along(
    orders: &Orders,
    flow: &Rc<Flow>,
    whole: &[RBig; 2],
    zeros: &mut [Root],
    curve: usize,
) -> Result<Along, Refused> {
    let piece = &orders.pieces.list[curve];
    let [first, last] = range::ends(orders.spaces, orders.pieces, piece, whole);
    let mut inside: Vec<&mut Root> = Vec::new();
    for root in zeros {
        if apart(root, &first)? && apart(root, &last)? && root.lo >= first[1] && root.hi <= last[0] {
            inside.push(root);
        }
    }
    let half = RBig::ONE / RBig::from(2);
    let mut from = first[1].clone();
    let mut types = Vec::new();
    for upto in inside.iter().map(|root| &root.lo).chain([&last[0]]) {
        types.push(flow.stability(&((&from + upto) * &half)));
        if let Some(root) = inside.get(types.len() - 1) {
            from.clone_from(&root.hi);
        }
    }
    let mut turns = Vec::new();
    for (n, root) in inside.iter_mut().enumerate() {
        narrow(root, whole.each_ref(), orders.spaces.bits() * NARROW[0] / NARROW[1]);
        // A zero without a change of the type does not count.
        if types[n] != types[n + 1] {
            turns.push(place(orders.spaces, piece.branch, [&root.lo, &root.hi]).ok_or(CHANGES)?);
        }
    }
    let at = |root: &&mut Root| [root.lo.clone(), root.hi.clone()];
    let stations: Vec<[RBig; 2]> = [first].into_iter().chain(inside.iter().map(at)).chain([last]).collect();
    let is_elliptic = |n: &usize| types[*n] == Stability::Elliptic;
    let stretch = |n: usize| {
        // A zero between two stretches is counted with the one before.
        let before = n.checked_sub(1).filter(|before| !is_elliptic(before)).map(|_| true);
        let after = types.get(n + 1).map(|_| !is_elliptic(&(n + 1)));
        let ends = [stations[n].clone(), stations[n + 1].clone()];
        Stretch { branch: piece.branch, flow: Rc::clone(flow), ends, collisions: [before, after] }
    };
    let elliptic = (0..types.len()).filter(is_elliptic).map(stretch).collect();
    types.dedup();
    if !range::rises(piece) {
        types.reverse();
        turns.reverse();
    }
    Ok(Along { curve, types, turns, elliptic })
}

/// x and h over a range of the parameter.
fn place(spaces: &Spaces, branch: Branch, [t, u]: [&RBig; 2]) -> Option<[Fixed; 2]> {
    let point: Point = match branch {
        Branch::Generic(number) => {
            let (base, side) = coordinates(spaces, number);
            let y = [t, u].map(|mu| spaces.set(&distance(spaces, base, side, mu)));
            spaces.point(base, side, &y[0].hull(&y[1]))?
        }
        Branch::Over(base) => {
            let p_sum = spaces.sums(base).1;
            let y = [t, u].map(|z| spaces.set(&(RBig::ONE / z - &p_sum)));
            spaces.point(base, Side::Over, &y[0].hull(&y[1]))?
        }
        Branch::Line(plus) => {
            // μ = a ± r/s and s = 2x/a².
            let a = &spaces.list[*spaces.active.first()?].a;
            let apart = spaces.set(&(t - a)).hull(&spaces.set(&(u - a)));
            let apart = if plus { apart } else { -&apart };
            let x = (&spaces.norm * &spaces.set(&(a * a))).over(&apart)?.half();
            spaces.line(plus, &x)?
        }
        Branch::Rotation(_) => return None,
    };
    let h = Spaces::height(&point.x, &point)?;
    Some([point.x, h])
}

/// Every change: on the curves, and from curve to curve at cusps and pitchforks.
fn changes(orders: &Orders, along: &[Along]) -> Result<Vec<Change>, Refused> {
    let pieces = orders.pieces;
    let mut found = Vec::new();
    for Along { curve, types, turns, .. } in along {
        for (pair, at) in types.windows(2).zip(turns) {
            let [from, to] = [pair[0], pair[1]];
            let kind = match (from, to) {
                (Stability::Elliptic, _) | (_, Stability::Elliptic) => StabilityChangeKind::HamiltonianHopf,
                _ => StabilityChangeKind::RealCollision,
            };
            let kind = if is_circle(orders, *curve) { StabilityChangeKind::Zero } else { kind };
            found.push(Change { curve: *curve, onto: None, kind, from, to, at: at.clone() });
        }
    }
    let cusps = (0..pieces.cusps.len()).map(|n| (End::Cusp(n), pieces.at_cusp(n)));
    let forks = (0..pieces.forks.len()).map(|n| (End::Pitchfork(n), pieces.at_fork(n)));
    for (end, mut curves) in cusps.chain(forks) {
        // The pair of a pitchfork begins there, the two others are one branch; they are listed by their numbers.
        if matches!(end, End::Pitchfork(_)) {
            curves.retain(|&c| !matches!(pieces.list[c].branch, Branch::Over(_)));
        }
        curves.sort_unstable();
        let [first, second] = curves[..] else {
            continue;
        };
        let side = |curve: usize| usize::from(pieces.list[curve].ends[0] != end);
        let type_at = |curve: usize| {
            let types = along.iter().find(|along| along.curve == curve).map(|along| &along.types)?;
            if side(curve) == 0 { types.first() } else { types.last() }.copied()
        };
        let (from, to) = type_at(first).zip(type_at(second)).ok_or(CHANGES)?;
        if from != to {
            let point = pieces.end_point(orders.spaces, first, side(first)).ok_or(CHANGES)?;
            let h = Spaces::height(&point.x, &point).ok_or(CHANGES)?;
            let kind = StabilityChangeKind::Zero;
            found.push(Change { curve: first, onto: Some(second), kind, from, to, at: [point.x, h] });
        }
    }
    Ok(found)
}

fn is_circle(orders: &Orders, curve: usize) -> bool {
    matches!(orders.pieces.list[curve].branch, Branch::Over(base) if orders.spaces.list[base].axes.len() > 1)
}

impl Change {
    /// The document lists this change; l and h are right within the error that it states.
    fn is_listed(&self, claim: &StabilityChangeDocument, orders: &Orders, l2: &RBig) -> bool {
        let id = |curve: usize| orders.pieces.list[curve].id.as_str();
        let named = claim.curve == id(self.curve)
            && claim.onto.as_deref() == self.onto.map(id)
            && (claim.kind, claim.from, claim.to) == (self.kind, self.from, self.to);
        named && is_there(claim.l, claim.h, claim.error_bound, &self.at, orders, l2)
    }
}

impl Exception {
    /// The document says the same of this point; where the determinant is 0 it may leave the verdict open, which claims nothing.
    fn is_listed(&self, claim: &VerdictChangeDocument) -> bool {
        let open = (NonlinearVerdict::Open, Reason::Degenerate);
        let claimed = (claim.verdict, claim.why);
        let is_expected = claimed == (self.verdict, self.why) || (self.kind == Failing::Determinant && claimed == open);
        is_expected && (claim.kind, claim.changes, claim.proved) == (self.kind, self.changes, true)
    }
}

/// l and h are those of a place, x and h, within the error that is stated, which is that of rounding.
fn is_there(l: f64, h: f64, error: f64, [x, height]: &[Fixed; 2], orders: &Orders, l2: &RBig) -> bool {
    let energy = &orders.spaces.energy;
    let sizes = [l, h.abs()].map(|x| RBig::try_from(x).unwrap_or(RBig::ZERO));
    let size = sizes.into_iter().fold(&orders.spaces.norm.ends()[1] * energy, |sum, size| sum + size);
    l >= 0.0
        && is_root_within(l, error, l2, x)
        && is_within(h, error, energy, height)
        && is_at_most(error, &roundings(ROUNDINGS, &size))
}

/// The types along a curve are those of a document.
fn spans(curve: &CurveDocument, along: Option<&Along>, l2: &RBig) -> bool {
    let spans = &curve.stability;
    let Some(along) = along else {
        return spans.is_empty();
    };
    let joined = spans.windows(2).all(|pair| pair[0].l_to == Some(pair[1].l_from));
    let ends = [spans.first().map(|span| span.l_from), spans.last().and_then(|span| span.l_to)];
    let same = |(p, q): (&Option<f64>, &Option<f64>)| match (p, q) {
        (Some(p), Some(q)) => (p - q).abs() <= ROUNDED * q.abs() && (*p != 0.0 || p.is_sign_positive()),
        _ => p == q,
    };
    let mut inner = spans.iter().skip(1).zip(&along.turns);
    joined
        && ends.iter().zip(&curve.l_range).all(same)
        && spans.iter().map(|span| span.stability).eq(along.types.iter().copied())
        && inner.all(|(span, [x, _])| is_root_within(span.l_from, span.l_from * ROUNDED, l2, x))
}
