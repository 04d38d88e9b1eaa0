//! The curves of a body from its certificate's cusps: names, ends, directions.

use dashu_ratio::RBig;

use super::places::{Place, Point, Side};
use super::spaces::Spaces;
use crate::Refused;
use crate::numbers::fixed::Fixed;

/// The branch of relative equilibria, or the line, that contains a curve.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Branch {
    /// Between two spaces that carry r, by number from below.
    Generic(usize),
    /// Over a space without r.
    Over(usize),
    /// γ = ± r̂, critical when r lies on an axis; `true` is +.
    Line(bool),
    /// r = 0.
    Rotation(usize),
}

/// Where a curve ends, by rising x.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum End {
    Origin,
    Infinity,
    Cusp(usize),
    Pitchfork(usize),
}

impl End {
    /// A cusp or a pitchfork: curves meet there.
    pub fn is_station(self) -> bool {
        matches!(self, Self::Cusp(_) | Self::Pitchfork(_))
    }
}

/// A curve.
#[derive(Clone, Debug)]
pub(crate) struct Piece {
    pub id: String,
    pub branch: Branch,
    /// Enclosures of μ (of y over a space) at both ends of the parameter; `None` at a limit.
    pub range: [Option<[RBig; 2]>; 2],
    /// x rises with the parameter.
    pub rising: bool,
    pub ends: [End; 2],
    /// μ ≥ the largest moment: the global minimum (Proposition 4.3).
    pub lowest: bool,
    /// The space at whose axis it ends for x → ∞, and 1 at +e, −1 at −e, 0 without r.
    pub limit: Option<(usize, i8)>,
    /// A critical curve, not only a pole line.
    pub critical: bool,
}

/// All curves, cusps and pitchforks.
#[derive(Clone, Debug)]
pub(crate) struct Pieces {
    pub list: Vec<Piece>,
    pub cusps: Vec<Place>,
    /// The space without r over which each pitchfork's pair runs.
    pub forks: Vec<usize>,
    /// x at both ends of each curve; `None` for infinity.
    ends: Vec<[Option<Fixed>; 2]>,
}

/// A cusp or a pitchfork, and the range of μ that holds it.
type Station = ([RBig; 2], End);

impl Pieces {
    /// `cusps` are known to be all of the generic family and over the spaces without r, in the certificate's order.
    pub fn new(spaces: &Spaces, cusps: Vec<Place>) -> Result<Self, Refused> {
        let mut pieces = Self { list: Vec::new(), cusps, forks: Vec::new(), ends: Vec::new() };
        match spaces.active.len() {
            0 => pieces.rotations(spaces),
            1 => pieces.lines(spaces),
            _ => {
                for number in 0..=spaces.active.len() {
                    pieces.generic(spaces, number)?;
                }
            }
        }
        pieces.pairs(spaces)?;
        if spaces.active.len() > 1 {
            for plus in [true, false] {
                let id = if plus { "P+" } else { "P-" }.to_owned();
                pieces.list.push(line(id, plus, [End::Origin, End::Infinity], false, false));
            }
        }
        let ends = |curve| Ok([pieces.x_of_end(spaces, curve, 0)?, pieces.x_of_end(spaces, curve, 1)?]);
        pieces.ends = (0..pieces.list.len()).map(ends).collect::<Result<_, Refused>>()?;
        Ok(pieces)
    }

    pub fn find(&self, id: &str) -> Result<usize, Refused> {
        self.list.iter().position(|piece| piece.id == id).ok_or_else(|| Refused::UnknownCurve { id: id.to_owned() })
    }

    fn rotations(&mut self, spaces: &Spaces) {
        for base in 0..spaces.list.len() {
            self.list.push(Piece {
                id: format!("{}.1", pair_name(spaces, base)),
                branch: Branch::Rotation(base),
                range: [None, None],
                rising: true,
                ends: [End::Origin, End::Infinity],
                lowest: base + 1 == spaces.list.len(),
                limit: None,
                critical: true,
            });
        }
    }

    fn lines(&mut self, spaces: &Spaces) {
        let axis = spaces.active[0];
        for plus in [false, true] {
            let mut forks: Vec<usize> = spaces.passive().into_iter().filter(|&k| (k > axis) == plus).collect();
            forks.sort_by_key(|&k| std::cmp::Reverse(k.abs_diff(axis)));
            let mut from = End::Origin;
            for number in 0..=forks.len() {
                let to = if number < forks.len() { End::Pitchfork(self.forks.len()) } else { End::Infinity };
                let id = format!("L{}.{}", if plus { "+" } else { "-" }, number + 1);
                self.list.push(line(id, plus, [from, to], plus && number == 0, true));
                if number < forks.len() {
                    self.forks.push(forks[number]);
                }
                from = to;
            }
        }
    }

    /// The cusps and pitchforks of a branch of the generic family, by rising μ.
    fn stations(&mut self, spaces: &Spaces, number: usize) -> Result<Vec<Station>, Refused> {
        let [left, right] = spaces.interval(number);
        let above = |mu: &RBig| left.is_none_or(|a| mu > a);
        let below = |mu: &RBig| right.is_none_or(|a| mu < a);
        let mut stations: Vec<Station> = Vec::new();
        for (cusp, place) in self.cusps.iter().enumerate().filter(|(_, place)| place.side != Side::Over) {
            let range = place.range(spaces);
            if above(&range[0]) && below(&range[1]) {
                stations.push((range, End::Cusp(cusp)));
            }
        }
        for base in spaces.passive() {
            let mu = &spaces.list[base].a;
            if above(mu) && below(mu) {
                stations.push(([mu.clone(), mu.clone()], End::Pitchfork(self.forks.len())));
                self.forks.push(base);
            }
        }
        stations.sort_by(|(p, _), (q, _)| p[0].cmp(&q[0]));
        if stations.windows(2).any(|pair| pair[0].0[1] >= pair[1].0[0]) {
            return Err(Refused::Uncertain {
                what: format!("the ranges of cusps or pitchforks of the branch G{number} overlap"),
            });
        }
        Ok(stations)
    }

    /// A branch of the generic family, cut at its cusps and pitchforks. x turns at each cusp.
    fn generic(&mut self, spaces: &Spaces, number: usize) -> Result<(), Refused> {
        let stations = self.stations(spaces, number)?;
        let [left, right] = [number.checked_sub(1), Some(number)].map(|n| spaces.active.get(n?).copied());
        let (first, last) = (number == 0, number == spaces.active.len());
        let largest = spaces.list.len() - 1;
        let mut rising = first;
        let mut start: (Option<[RBig; 2]>, End) = (None, if first { End::Origin } else { End::Infinity });
        for piece in 0..=stations.len() {
            let station = stations.get(piece);
            let end = station.map_or(if last { End::Origin } else { End::Infinity }, |(_, end)| *end);
            let range = [start.0, station.map(|(range, _)| range.clone())];
            let limit = if start.1 == End::Infinity && piece == 0 {
                left.map(|k| (k, 1))
            } else if station.is_none() && !last {
                right.map(|k| (k, -1))
            } else {
                None
            };
            let lowest = match &range[0] {
                Some([mu, _]) => *mu >= spaces.list[largest].a,
                None => last && left == Some(largest),
            };
            self.list.push(Piece {
                id: format!("G{number}.{}", piece + 1),
                branch: Branch::Generic(number),
                range,
                rising,
                ends: if rising { [start.1, end] } else { [end, start.1] },
                lowest,
                limit,
                critical: true,
            });
            rising ^= matches!(end, End::Cusp(_));
            start = (station.map(|(range, _)| range.clone()), end);
        }
        Ok(())
    }

    /// The symmetric pairs over the spaces without r, each cut at the cusp of its closed form if there is one.
    fn pairs(&mut self, spaces: &Spaces) -> Result<(), Refused> {
        if spaces.active.is_empty() {
            return Ok(());
        }
        for base in spaces.passive() {
            let Some(fork) = self.forks.iter().position(|&fork| fork == base) else {
                return Err(Refused::uncertain("the ranges of pitchforks overlap"));
            };
            let piece = |number: usize, range, rising, ends, limit| Piece {
                id: format!("{}.{number}", pair_name(spaces, base)),
                branch: Branch::Over(base),
                range,
                rising,
                ends,
                lowest: base + 1 == spaces.list.len(),
                limit,
                critical: true,
            };
            let zero = Some([RBig::ZERO, RBig::ZERO]);
            if let Some((cusp, turn)) = self.turn(spaces, base)? {
                let at = Some([turn.clone(), turn]);
                let ends = [End::Cusp(cusp), End::Pitchfork(fork)];
                self.list.push(piece(1, [zero, at.clone()], false, ends, None));
                let ends = [End::Cusp(cusp), End::Infinity];
                self.list.push(piece(2, [at, None], true, ends, Some((base, 0))));
            } else {
                let ends = [End::Pitchfork(fork), End::Infinity];
                self.list.push(piece(1, [zero, None], true, ends, Some((base, 0))));
            }
        }
        Ok(())
    }

    /// Proposition 4.7: the cusp of the pair over a space without r, at y = −3R̂/a − P̂ if that is positive: listed
    /// exactly then, and once.
    fn turn(&self, spaces: &Spaces, base: usize) -> Result<Option<(usize, RBig)>, Refused> {
        let (r_sum, p_sum) = spaces.sums(base);
        let turn = r_sum * RBig::from(-3) / &spaces.list[base].a - p_sum;
        let over = |cusp: &usize| self.cusps[*cusp].side == Side::Over && self.cusps[*cusp].base == base;
        let listed: Vec<usize> = (0..self.cusps.len()).filter(over).collect();
        let counted = usize::from(turn > RBig::ZERO);
        let held = listed.iter().all(|&c| self.cusps[c].lo <= turn && turn <= self.cusps[c].hi);
        if listed.len() != counted || !held {
            let (branch, listed) = (pair_name(spaces, base), listed.len());
            return Err(Refused::Count { what: "cusps", branch, listed, counted });
        }
        Ok(listed.first().map(|&cusp| (cusp, turn)))
    }

    /// The curves that end at a cusp.
    pub fn at_cusp(&self, cusp: usize) -> Vec<usize> {
        self.at_end(End::Cusp(cusp))
    }

    fn at_end(&self, end: End) -> Vec<usize> {
        (0..self.list.len()).filter(|&c| self.list[c].ends.contains(&end)).collect()
    }

    /// The curves at a pitchfork: the one before, the one after, the pair.
    pub fn at_fork(&self, fork: usize) -> Vec<usize> {
        let mut curves = self.at_end(End::Pitchfork(fork));
        curves.sort_by_key(|&c| {
            let piece = &self.list[c];
            (matches!(piece.branch, Branch::Over(_)), piece.ends[0] == End::Pitchfork(fork))
        });
        curves
    }

    /// The equilibrium at which a curve ends, in coordinates that suit its other places.
    pub fn end_point(&self, spaces: &Spaces, curve: usize, side: usize) -> Option<Point> {
        let piece = &self.list[curve];
        match (piece.ends[side], piece.branch) {
            (End::Cusp(cusp), _) => {
                let place = &self.cusps[cusp];
                spaces.point(place.base, place.side, &place.y(spaces))
            }
            (End::Pitchfork(fork), Branch::Over(_) | Branch::Line(_)) => {
                spaces.point(self.forks[fork], Side::Over, &Fixed::whole(0))
            }
            (End::Pitchfork(fork), Branch::Generic(number)) => {
                let (base, side) = coordinates(spaces, number);
                let mu = &spaces.list[self.forks[fork]].a;
                spaces.point(base, side, &spaces.set(&distance(spaces, base, side, mu)))
            }
            _ => None,
        }
    }

    /// x where a curve ends; `None` for infinity.
    pub fn end_x(&self, curve: usize, side: usize) -> Option<&Fixed> {
        self.ends[curve][side].as_ref()
    }

    fn x_of_end(&self, spaces: &Spaces, curve: usize, side: usize) -> Result<Option<Fixed>, Refused> {
        match self.list[curve].ends[side] {
            End::Origin => Ok(Some(Fixed::whole(0))),
            End::Infinity => Ok(None),
            _ => match self.end_point(spaces, curve, side) {
                Some(point) => Ok(Some(point.x)),
                None => {
                    Err(Refused::Uncertain { what: format!("an end of {} cannot be enclosed", self.list[curve].id) })
                }
            },
        }
    }
}

/// One coordinate y for a whole interval of the generic family.
pub(crate) fn coordinates(spaces: &Spaces, number: usize) -> (usize, Side) {
    match number.checked_sub(1) {
        Some(left) => (spaces.active[left], Side::Plus),
        None => (spaces.active[0], Side::Minus),
    }
}

/// y of a μ.
pub(crate) fn distance(spaces: &Spaces, base: usize, side: Side, mu: &RBig) -> RBig {
    let d = mu - &spaces.list[base].a;
    if side == Side::Minus { -d } else { d }
}

fn line(id: String, plus: bool, ends: [End; 2], lowest: bool, critical: bool) -> Piece {
    let branch = Branch::Line(plus);
    Piece { id, branch, range: [None, None], rising: true, ends, lowest, limit: None, critical }
}

fn pair_name(spaces: &Spaces, base: usize) -> String {
    let axes: String = spaces.list[base].axes.iter().map(|axis| (axis + 1).to_string()).collect();
    format!("S{axes}")
}
