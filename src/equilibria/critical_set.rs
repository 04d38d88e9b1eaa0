//! All curves of critical values and both pole lines of a body.

use thiserror::Error;

use super::arc::{Arc, Segment, Shape};
use super::curve::{Branch, Curve, End, Orbit, Pole};
use super::cusps::{MuInterval, cusps, inflection};
use super::generic::{GenericState, Mu};
use super::index;
use super::point::Point;
use super::symmetric::SymmetricFamily;
use crate::body::Frame;
use crate::numerics::UNIT_ROUNDOFF;

/// A cusp: two curves of critical points meet and vanish.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cusp {
    /// The point in the (x, h) plane.
    pub point: Point,
    /// The two curves, in the order of the branch's parameter.
    pub curves: [usize; 2],
    /// The curves lie at larger x (they are born there as x rises).
    pub opens_upward: bool,
}

/// A pitchfork: a symmetric pair (or a circle) leaves a curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pitchfork {
    /// The point in the (x, h) plane.
    pub point: Point,
    /// The curve that is left, before and after, by rising x.
    pub through: [usize; 2],
    /// The curve of the pair.
    pub pair: usize,
}

/// A place where f64 does not tell how many cusps there are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CuspCluster {
    /// The point in the (x, h) plane.
    pub point: Point,
    /// On this interval of the generic family.
    pub interval: usize,
}

/// Why a body's critical points cannot be computed in `f64`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum EquilibriaError {
    /// Products of the body's data leave the range of `f64`.
    #[error(
        "the body's data differ by more than 10^25 in size (a moment, a difference of moments or a component of r); \
         f64 cannot resolve them"
    )]
    Range,
}

/// The curves of critical values, complete, with the points where they end.
#[derive(Clone, Debug, PartialEq)]
pub struct CriticalSet {
    /// The body.
    pub frame: Frame,
    /// Curves; pole lines last.
    pub curves: Vec<Curve>,
    /// Cusps.
    pub cusps: Vec<Cusp>,
    /// Pitchforks.
    pub pitchforks: Vec<Pitchfork>,
    /// What is not decided.
    pub clusters: Vec<CuspCluster>,
}

/// A place where the generic family is cut.
#[derive(Clone, Copy)]
enum Station {
    End(Option<usize>),
    Cusp(Mu),
    Pitchfork(Mu, usize),
    Inflection(Mu),
}

impl Station {
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
    /// Finds every curve of the body.
    ///
    /// # Errors
    /// [`EquilibriaError::Range`] when the data differ so much that products leave the range of `f64`.
    pub fn new(frame: Frame) -> Result<Self, EquilibriaError> {
        check_range(&frame)?;
        let mut set =
            Self { frame, curves: Vec::new(), cusps: Vec::new(), pitchforks: Vec::new(), clusters: Vec::new() };
        let active: Vec<usize> = (0..3).filter(|&k| set.frame.r[k] > 0.0).collect();
        let passive: Vec<usize> = (0..3)
            .filter(|&k| k == 0 || set.frame.group[k - 1] != set.frame.group[k])
            .filter(|&k| active.iter().all(|&m| set.frame.group[m] != set.frame.group[k]))
            .collect();
        match active.len() {
            0 => set.add_euler(&passive),
            1 => {
                set.add_axis(active[0], &passive);
                set.add_symmetric(&passive);
            }
            _ => {
                set.add_generic(&active, &passive);
                set.add_symmetric(&passive);
                set.add_pole_lines();
            }
        }
        Ok(set)
    }

    /// r = 0: rotations about the principal axes, straight lines through the origin.
    fn add_euler(&mut self, passive: &[usize]) {
        for &axis in passive {
            let dimension = eigenspace_dimension(&self.frame, axis);
            let orbit = match dimension {
                1 => Orbit::Pair(axis),
                2 => Orbit::Circle(axis),
                _ => Orbit::Sphere,
            };
            let index = (0..3).filter(|&k| self.frame.group[k] > self.frame.group[axis]).count();
            // For a circle the index counts the one normal direction only; for a sphere there is none.
            let index = if dimension == 1 { index } else { index.min(3 - dimension) };
            self.curves.push(Curve {
                branch: Branch::Symmetric(axis),
                piece: 1,
                orbit,
                index: Some(u8::try_from(index).unwrap_or(2)),
                pole: None,
                arcs: vec![Arc::straight(unit(axis, 1.0), self.frame.a[axis], [0.0, f64::INFINITY])],
                ends: [End::Origin, End::Infinity],
            });
        }
    }

    /// r on an eigenspace: two straight lines γ = ±r̂, cut at the pitchforks of the other axes.
    fn add_axis(&mut self, axis: usize, passive: &[usize]) {
        let a = self.frame.a[axis];
        for (interval, pole, sign) in [(0, Pole::Minus, -1.0), (1, Pole::Plus, 1.0)] {
            let gamma = unit(axis, sign);
            // μ = a ± r/s passes a_k at s = r/|a_k − a|, on the line on whose side a_k lies.
            let mut cuts: Vec<(f64, usize)> = passive
                .iter()
                .filter(|&&k| self.frame.diff[k][axis] * sign > 0.0)
                .map(|&k| (0.5 * a * a * self.frame.r[axis] / self.frame.diff[k][axis].abs(), k))
                .collect();
            cuts.sort_by(|p, q| p.0.total_cmp(&q.0));
            let first = self.curves.len();
            let mut from = (0.0, End::Origin);
            for piece in 0..=cuts.len() {
                let to = cuts.get(piece).map_or((f64::INFINITY, End::Infinity), |&(x, _)| {
                    (x, End::Pitchfork(self.pitchforks.len() + piece))
                });
                let index = index::on_axis(&self.frame, axis, sign, from.0, to.0);
                self.curves.push(Curve {
                    branch: Branch::Axis(interval),
                    piece: piece + 1,
                    orbit: Orbit::Point,
                    index: Some(index),
                    pole: Some(pole),
                    arcs: vec![Arc::straight(gamma, a, [from.0, to.0])],
                    ends: [from.1, to.1],
                });
                from = to;
            }
            for (n, &(x, k)) in cuts.iter().enumerate() {
                // `pair` holds the axis until the pair's curve is made.
                let point = Point::over(&self.frame, x, gamma, a);
                self.pitchforks.push(Pitchfork { point, through: [first + n, first + n + 1], pair: k });
            }
        }
    }

    /// The generic family over every interval between active moments.
    fn add_generic(&mut self, active: &[usize], passive: &[usize]) {
        let bend = if active.len() == 3 { inflection(&self.frame) } else { None };
        for n in 0..=active.len() {
            let interval =
                MuInterval { left: n.checked_sub(1).map(|left| active[left]), right: active.get(n).copied() };
            let found = cusps(&self.frame, &interval, active);
            for &mu in &found.clusters {
                let state = GenericState::at(&self.frame, mu);
                let point = Point::over(&self.frame, state.x, state.gamma, state.j);
                self.clusters.push(CuspCluster { point, interval: n });
            }
            let mut stations: Vec<Station> = found.at.into_iter().map(Station::Cusp).collect();
            stations.extend(bend.iter().filter(|(at, _)| *at == n).map(|&(_, mu)| Station::Inflection(mu)));
            for &k in passive {
                if let Some(mu) = self.passive_mu(&interval, k) {
                    stations.push(Station::Pitchfork(mu, k));
                }
            }
            stations.sort_by(|p, q| {
                let key = |station: &Station| station.mu().map_or((0, 0.0), |mu| (mu.base, mu.delta));
                let (p, q) = (key(p), key(q));
                p.0.cmp(&q.0).then(p.1.total_cmp(&q.1))
            });
            stations.insert(0, Station::End(interval.left));
            stations.push(Station::End(interval.right));
            self.cut_interval(n, &interval, &stations);
        }
    }

    /// μ = a_k of a moment without r, if it lies in the interval, measured from the nearer end.
    fn passive_mu(&self, interval: &MuInterval, k: usize) -> Option<Mu> {
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

    /// Turns the stations of an interval into curves, cusps and pitchforks.
    fn cut_interval(&mut self, number: usize, interval: &MuInterval, stations: &[Station]) {
        let nodes: Vec<Node> = stations.iter().map(|station| self.node(station)).collect();
        let middle = match (interval.left, interval.right) {
            (Some(left), Some(right)) => {
                Some(self.node_at(Mu { base: left, delta: 0.5 * self.frame.diff[right][left] }))
            }
            _ => None,
        };
        let mut arcs: Vec<Arc> = Vec::new();
        let mut piece = 0;
        let mut start = self.end_of(&stations[0], None);
        // The curve on the other side of the last cut, if that cut was a cusp or pitchfork.
        for (k, window) in nodes.windows(2).enumerate() {
            arcs.push(self.arc(interval, &window[0], &window[1], middle.as_ref()));
            if matches!(stations[k + 1], Station::Inflection(_)) {
                continue;
            }
            piece += 1;
            let this = self.curves.len();
            let end = self.end_of(&stations[k + 1], Some((this, &nodes[k + 1])));
            let rising = arcs[0].x[0] < arcs[arcs.len() - 1].x[1] && nodes_rise(&nodes, k, arcs.len());
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
                let before_after = if rising { 0 } else { 1 };
                self.pitchforks[p].through[before_after] = this;
            }
            if let End::Cusp(c) = end {
                // A curve that rises towards the cusp lies below it in x.
                self.cusps[c].opens_upward = !rising;
            }
            start = end;
        }
    }

    /// Enters `this` as the curve after the cut `start`.
    fn close_cut(&mut self, start: End, this: usize, rising: bool) {
        match start {
            End::Cusp(c) => self.cusps[c].curves[1] = this,
            End::Pitchfork(p) => self.pitchforks[p].through[usize::from(rising)] = this,
            End::Origin | End::Infinity => {}
        }
    }

    /// The end of a curve at a station; makes the cusp or pitchfork when its first curve is known.
    fn end_of(&mut self, station: &Station, first: Option<(usize, &Node)>) -> End {
        match (*station, first) {
            (Station::End(None), _) => End::Origin,
            (Station::Cusp(mu), Some((curve, node))) => {
                let point = self.point(mu, node);
                self.cusps.push(Cusp { point, curves: [curve; 2], opens_upward: false });
                End::Cusp(self.cusps.len() - 1)
            }
            (Station::Pitchfork(mu, axis), Some((curve, node))) => {
                let point = self.point(mu, node);
                self.pitchforks.push(Pitchfork { point, through: [curve; 2], pair: axis });
                End::Pitchfork(self.pitchforks.len() - 1)
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

    fn node(&self, station: &Station) -> Node {
        match *station {
            Station::End(None) => Node { mu: None, x: 0.0, slope: 1.0 / self.frame.j_r },
            Station::End(Some(k)) => {
                Node { mu: Some(Mu { base: k, delta: 0.0 }), x: f64::INFINITY, slope: 1.0 / self.frame.a[k] }
            }
            Station::Cusp(mu) | Station::Pitchfork(mu, _) | Station::Inflection(mu) => self.node_at(mu),
        }
    }

    /// The arc between neighbouring stations, by rising x.
    fn arc(&self, interval: &MuInterval, from: &Node, to: &Node, middle: Option<&Node>) -> Arc {
        let side = |node: &Node| node.mu.map(|mu| mu.base);
        let straddles = matches!((side(from), side(to)), (Some(p), Some(q)) if p != q);
        let mut segments = match middle.filter(|_| straddles) {
            Some(middle) => {
                let on_right = self.from_right(interval, middle);
                vec![self.segment(interval, from, middle), self.segment(interval, &on_right, to)]
            }
            None => vec![self.segment(interval, from, to)],
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
    fn from_right(&self, interval: &MuInterval, middle: &Node) -> Node {
        let mu = match (interval.left, interval.right) {
            (Some(left), Some(right)) => Some(Mu { base: right, delta: -0.5 * self.frame.diff[right][left] }),
            _ => middle.mu,
        };
        Node { mu, ..*middle }
    }

    fn segment(&self, interval: &MuInterval, from: &Node, to: &Node) -> Segment {
        let base = [to, from].iter().find_map(|node| node.mu.map(|mu| mu.base));
        let base = base.or(interval.right).or(interval.left).unwrap_or(0);
        let distance = |node: &Node| node.mu.map_or(f64::INFINITY, |mu| mu.delta.abs());
        let sign = if interval.left == Some(base) { 1.0 } else { -1.0 };
        let (mut x, mut ends) = ([from.x, to.x], [distance(from), distance(to)]);
        if x[0] > x[1] {
            x.reverse();
            ends.reverse();
        }
        Segment { base, sign, distance: ends, x }
    }

    /// The pairs and circles over eigenspaces without r; their pitchforks are known by now.
    fn add_symmetric(&mut self, passive: &[usize]) {
        for &axis in passive {
            let Some(number) = self.pitchforks.iter().position(|p| p.pair == axis && self.is_open(p)) else {
                continue;
            };
            let family = SymmetricFamily::over(&self.frame, axis);
            let root = self.pitchforks[number].point;
            let orbit =
                if eigenspace_dimension(&self.frame, axis) == 2 { Orbit::Circle(axis) } else { Orbit::Pair(axis) };
            let start = (0.0, root.x, root.slope());
            let end = (f64::INFINITY, f64::INFINITY, 1.0 / self.frame.a[axis]);
            let cusp = family.cusp(&self.frame).map(|t| {
                let state = family.at(&self.frame, t);
                (t, Point::over(&self.frame, state.x, state.gamma, state.j))
            });
            let first = self.curves.len();
            let push = |set: &mut Self, piece, from: (f64, f64, f64), to: (f64, f64, f64), mut ends: [End; 2]| {
                let (mut t, mut x, mut slope) = ([from.0, to.0], [from.1, to.1], [from.2, to.2]);
                let rising = x[0] < x[1];
                if !rising {
                    t.reverse();
                    x.reverse();
                    slope.reverse();
                    ends.reverse();
                }
                let index = index::symmetric(&set.frame, &family, t, rising, orbit);
                let arcs = vec![Arc { shape: Shape::Symmetric { family, t }, x, slope }];
                let index = Some(index);
                set.curves.push(Curve { branch: Branch::Symmetric(axis), piece, orbit, index, pole: None, arcs, ends });
            };
            match cusp {
                None => push(self, 1, start, end, [End::Pitchfork(number), End::Infinity]),
                Some((t, point)) => {
                    let turn = (t, point.x, point.slope());
                    let number_of_cusp = self.cusps.len();
                    self.cusps.push(Cusp { point, curves: [first, first + 1], opens_upward: true });
                    push(self, 1, start, turn, [End::Pitchfork(number), End::Cusp(number_of_cusp)]);
                    push(self, 2, turn, end, [End::Cusp(number_of_cusp), End::Infinity]);
                }
            }
            self.pitchforks[number].pair = first;
        }
    }

    /// A pitchfork whose `pair` still names the axis: the curve with that number, if any, is no pair.
    fn is_open(&self, pitchfork: &Pitchfork) -> bool {
        !matches!(self.curves.get(pitchfork.pair), Some(curve) if matches!(curve.branch, Branch::Symmetric(_)))
    }

    fn add_pole_lines(&mut self) {
        let r_hat = self.frame.r_hat();
        for (pole, sign) in [(Pole::Plus, 1.0), (Pole::Minus, -1.0)] {
            self.curves.push(Curve {
                branch: Branch::Pole(pole),
                piece: 1,
                orbit: Orbit::Pole(pole),
                index: None,
                pole: Some(pole),
                arcs: vec![Arc::straight(r_hat.map(|c| sign * c), self.frame.j_r, [0.0, f64::INFINITY])],
                ends: [End::Origin, End::Infinity],
            });
        }
    }

    /// Numbers of the curves over x, and whether an end lies within rounding of x.
    #[must_use]
    pub fn curves_over(&self, x: f64) -> (Vec<usize>, bool) {
        let tolerance = 64.0 * UNIT_ROUNDOFF * x;
        let over = (0..self.curves.len()).filter(|&c| {
            let [from, to] = self.curves[c].x();
            from < x && x < to
        });
        let near = self.curves.iter().any(|curve| curve.x().iter().any(|end| (end - x).abs() <= tolerance))
            || self.clusters.iter().any(|cluster| (cluster.point.x - x).abs() <= 1e-6 * x);
        (over.collect(), near)
    }
}

/// x of the nodes rises along the last `count` arcs that end at node k + 1.
fn nodes_rise(nodes: &[Node], k: usize, count: usize) -> bool {
    nodes[k + 1 - count].x < nodes[k + 1].x
}

fn unit(axis: usize, sign: f64) -> [f64; 3] {
    let mut v = [0.0; 3];
    v[axis] = sign;
    v
}

/// Dimension of the eigenspace whose first axis is given.
fn eigenspace_dimension(frame: &Frame, axis: usize) -> usize {
    (0..3).filter(|&k| frame.group[k] == frame.group[axis]).count()
}

fn check_range(frame: &Frame) -> Result<(), EquilibriaError> {
    // Fifth powers of differences and fourth powers of components are multiplied.
    const SMALLEST: f64 = 1e-25;
    let too_small = |x: f64, scale: f64| x != 0.0 && x.abs() < SMALLEST * scale;
    let bad = (0..3).any(|k| {
        too_small(frame.r[k], frame.r_norm)
            || too_small(frame.a[k], frame.a[2])
            || (0..k).any(|m| too_small(frame.diff[k][m], frame.a[2]))
    });
    if bad { Err(EquilibriaError::Range) } else { Ok(()) }
}
