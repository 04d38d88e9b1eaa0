//! The curves of the generic family: each interval of μ cut at cusps, pitchforks and the inflection.

use super::arc::{Arc, Segment, Shape};
use super::critical_set::{CriticalSet, Cusp, CuspCluster, Pitchfork};
use super::curve::{Branch, Curve, CurveId, End, IntervalId, Orbit};
use super::curve_point::Point;
use super::cusps::{MuInterval, cusps, inflection};
use super::families::{GenericState, Mu};
use super::index;
use bifdiag_body::Axis;
use bifdiag_numbers::table::Id;

/// A place where the generic family is cut.
#[derive(Clone, Copy)]
enum Cut {
    End(Option<Axis>),
    Cusp(Mu),
    Pitchfork(Mu, Axis),
    Inflection(Mu),
}

impl Cut {
    fn mu(&self) -> Option<Mu> {
        match *self {
            Self::End(_) => None,
            Self::Cusp(mu) | Self::Pitchfork(mu, _) | Self::Inflection(mu) => Some(mu),
        }
    }
}

/// A limit of the generic family, or a point on it: |δ| and x.
#[derive(Clone, Copy)]
struct Node {
    mu: Option<Mu>,
    x: f64,
    slope: f64,
}

impl CriticalSet {
    /// The generic family over every interval between active moments.
    pub(super) fn add_generic(&mut self, active: &[Axis], passive: &[Axis]) {
        let bend = if active.len() == 3 { inflection(&self.frame) } else { None };
        for n in 0..=active.len() {
            let interval = MuInterval::numbered(active, n);
            let found = cusps(&self.frame, &interval, active);
            for &mu in &found.clusters {
                let state = GenericState::at(&self.frame, mu);
                let point = Point::over(&self.frame, state.x, state.gamma, state.j);
                self.clusters.push(CuspCluster { point, interval: IntervalId::at(n) });
            }
            let mut cuts: Vec<Cut> = found.at.into_iter().map(Cut::Cusp).collect();
            cuts.extend(bend.iter().filter(|(at, _)| *at == n).map(|&(_, mu)| Cut::Inflection(mu)));
            for &k in passive {
                if let Some(mu) = self.passive_mu(&interval, k) {
                    cuts.push(Cut::Pitchfork(mu, k));
                }
            }
            cuts.sort_by(|p, q| {
                let key = |cut: &Cut| cut.mu().map_or((Axis::ALL[0], 0.0), |mu| (mu.base, mu.delta));
                let (p, q) = (key(p), key(q));
                p.0.cmp(&q.0).then(p.1.total_cmp(&q.1))
            });
            cuts.insert(0, Cut::End(interval.left));
            cuts.push(Cut::End(interval.right));
            self.cut_interval(IntervalId::at(n), &interval, &cuts);
        }
    }

    /// μ = a_k of a moment without r, if it lies in the interval, measured from the nearer end.
    fn passive_mu(&self, interval: &MuInterval, k: Axis) -> Option<Mu> {
        let diff = &self.frame.diff;
        let inside = interval.left.is_none_or(|left| diff[k][left] > 0.0)
            && interval.right.is_none_or(|right| diff[k][right] < 0.0);
        let base = match (interval.left, interval.right) {
            (Some(left), Some(right)) if diff[k][left] <= diff[right][k] => left,
            (_, Some(right)) => right,
            (Some(left), None) => left,
            (None, None) => return None,
        };
        inside.then(|| Mu { base, delta: diff[k][base] })
    }

    /// Turns the cuts of an interval into curves, cusps and pitchforks.
    fn cut_interval(&mut self, number: IntervalId, interval: &MuInterval, cuts: &[Cut]) {
        let nodes: Vec<Node> = cuts.iter().map(|cut| self.node(cut)).collect();
        let middle = match (interval.left, interval.right) {
            (Some(left), Some(right)) => {
                Some(self.node_at(Mu { base: left, delta: 0.5 * self.frame.diff[right][left] }))
            }
            _ => None,
        };
        let mut arcs: Vec<Arc> = Vec::new();
        let mut piece = 0;
        let mut start = self.end_of(&cuts[0], None);
        for (k, window) in nodes.windows(2).enumerate() {
            arcs.push(self.arc(interval, &window[0], &window[1], middle.as_ref()));
            if matches!(cuts[k + 1], Cut::Inflection(_)) {
                continue;
            }
            piece += 1;
            let this = self.curves.next_id();
            let end = self.end_of(&cuts[k + 1], Some((this, &nodes[k + 1])));
            let rising = nodes_rise(&nodes, k, arcs.len());
            let mut done = std::mem::take(&mut arcs);
            let ends = if rising { [start, end] } else { [end, start] };
            if !rising {
                done.reverse();
            }
            self.close_cut(start, this, rising);
            let index = index::generic(&self.frame, &done, rising);
            self.curves.push(Curve {
                branch: Branch::Generic(number),
                piece,
                orbit: Orbit::Point,
                index: Some(index),
                pole: None,
                arcs: done,
                ends,
            });
            if let End::Pitchfork(p) = end {
                self.pitchforks[p].through[usize::from(!rising)] = this;
            }
            if let End::Cusp(c) = end {
                // A curve that rises towards the cusp lies below it in x.
                self.cusps[c].opens_upward = !rising;
            }
            start = end;
        }
    }

    /// Enters `this` as the curve after the cut `start`.
    fn close_cut(&mut self, start: End, this: CurveId, rising: bool) {
        match start {
            End::Cusp(c) => self.cusps[c].curves[1] = this,
            End::Pitchfork(p) => self.pitchforks[p].through[usize::from(rising)] = this,
            End::Origin | End::Infinity => {}
        }
    }

    /// The end of a curve at a cut; makes the cusp or pitchfork when its first curve is known.
    fn end_of(&mut self, cut: &Cut, first: Option<(CurveId, &Node)>) -> End {
        match (*cut, first) {
            (Cut::End(None), _) => End::Origin,
            (Cut::Cusp(mu), Some((curve, node))) => {
                let point = self.point(mu, node);
                End::Cusp(self.cusps.push(Cusp { point, curves: [curve; 2], opens_upward: false }))
            }
            (Cut::Pitchfork(mu, axis), Some((curve, node))) => {
                let point = self.point(mu, node);
                End::Pitchfork(self.pitchforks.push(Pitchfork { point, axis, through: [curve; 2], pair: None }))
            }
            _ => End::Infinity,
        }
    }

    fn point(&self, mu: Mu, node: &Node) -> Point {
        let state = GenericState::at(&self.frame, mu);
        Point::over(&self.frame, node.x, state.gamma, state.j)
    }

    fn node_at(&self, mu: Mu) -> Node {
        let state = GenericState::at(&self.frame, mu);
        Node { mu: Some(mu), x: state.x, slope: 1.0 / state.j }
    }

    fn node(&self, cut: &Cut) -> Node {
        match *cut {
            Cut::End(None) => Node { mu: None, x: 0.0, slope: 1.0 / self.frame.j_r },
            Cut::End(Some(k)) => {
                Node { mu: Some(Mu { base: k, delta: 0.0 }), x: f64::INFINITY, slope: 1.0 / self.frame.a[k] }
            }
            Cut::Cusp(mu) | Cut::Pitchfork(mu, _) | Cut::Inflection(mu) => self.node_at(mu),
        }
    }

    /// The arc between neighbouring cuts, by rising x.
    fn arc(&self, interval: &MuInterval, from: &Node, to: &Node, middle: Option<&Node>) -> Arc {
        let side = |node: &Node| node.mu.map(|mu| mu.base);
        let straddles = matches!((side(from), side(to)), (Some(p), Some(q)) if p != q);
        let mut segments = match middle.filter(|_| straddles) {
            Some(middle) => {
                let on_right = segment(interval, &self.seen_from_right(interval, middle), to);
                // A cut in the very middle (a passive moment half-way) begins the right half.
                if from.mu == middle.mu { vec![on_right] } else { vec![segment(interval, from, middle), on_right] }
            }
            None => vec![segment(interval, from, to)],
        };
        let (mut x, mut slope) = ([from.x, to.x], [from.slope, to.slope]);
        if x[0] > x[1] {
            x.reverse();
            slope.reverse();
            segments.reverse();
        }
        Arc { shape: Shape::Generic(segments), x, slope }
    }

    /// The middle of an interval, measured from its right end.
    fn seen_from_right(&self, interval: &MuInterval, middle: &Node) -> Node {
        let mu = match (interval.left, interval.right) {
            (Some(left), Some(right)) => Some(Mu { base: right, delta: -0.5 * self.frame.diff[right][left] }),
            _ => middle.mu,
        };
        Node { mu, ..*middle }
    }
}

/// The segment between two neighbouring cuts on one side of an interval.
fn segment(interval: &MuInterval, from: &Node, to: &Node) -> Segment {
    let base = [to, from].iter().find_map(|node| node.mu.map(|mu| mu.base));
    let base = base.or(interval.right).or(interval.left).unwrap_or(Axis::ALL[0]);
    let distance = |node: &Node| node.mu.map_or(f64::INFINITY, |mu| mu.delta.abs());
    let sign = if interval.left == Some(base) { 1.0 } else { -1.0 };
    let (mut x, mut ends) = ([from.x, to.x], [distance(from), distance(to)]);
    if x[0] > x[1] {
        x.reverse();
        ends.reverse();
    }
    Segment { base, sign, distance: ends, x }
}

/// x of the nodes rises along the last `count` arcs that end at node k + 1.
fn nodes_rise(nodes: &[Node], k: usize, count: usize) -> bool {
    nodes[k + 1 - count].x < nodes[k + 1].x
}
