//! What is known when two curves are compared, and the point of a curve at one x.

use bifdiag_schema::PlaceDocument;
use dashu_ratio::RBig;

use crate::Refused;
use crate::equilibria::pieces::{Branch, Piece, Pieces, coordinates, distance};
use crate::equilibria::places::{Place, Point, Side};
use crate::equilibria::spaces::Spaces;
use crate::numbers::fixed::Fixed;

/// Newton steps that sharpen a place at most: each doubles its digits. They end where half of the bits are known, or one
/// gains nothing.
const STEPS: usize = 12;
/// Halvings at most.
const HALVINGS: usize = 256;

/// A curve over one x.
#[derive(Clone, Debug)]
pub(crate) struct Stand {
    /// y in the coordinate of the curve's interval; absent on a straight line.
    pub y: Option<Fixed>,
    pub point: Point,
}

/// The coordinate of the branch in which a curve is computed.
struct Coordinate {
    base: usize,
    side: Side,
    /// x rises with y.
    rising: bool,
    /// Between these, one of which may be absent, y is surely on the curve.
    inner: [Option<Fixed>; 2],
}

/// What is known when curves are compared.
pub(crate) struct Orders<'a> {
    pub spaces: &'a Spaces,
    pub pieces: &'a Pieces,
    /// The branch of the generic family on which dJ/dμ = 0 once, and the equilibrium there.
    pub inflection: Option<(usize, Point)>,
    /// (curve, side, other): the other passes exactly through this end.
    pub meetings: Vec<(usize, usize, usize)>,
}

impl Orders<'_> {
    /// The equilibrium of a curve over x, from the place that the certificate names: x of both its ends must enclose x.
    pub fn stand(&self, curve: usize, place: Option<&PlaceDocument>, x: &Fixed) -> Result<Stand, Refused> {
        let (spaces, piece) = (self.spaces, &self.pieces.list[curve]);
        let found = match piece.branch {
            Branch::Line(_) | Branch::Rotation(_) if place.is_some() => None,
            Branch::Line(plus) => spaces.line(plus, x).map(|point| Stand { y: None, point }),
            Branch::Rotation(base) => Some(Stand { y: None, point: spaces.rotation(base, x) }),
            Branch::Generic(_) | Branch::Over(_) => place
                .and_then(|place| Place::read(place, spaces))
                .and_then(|place| enclosed(spaces, piece, &place, x))
                .and_then(|(coordinate, y)| coordinate.sharpened(spaces, y, x)),
        };
        found.ok_or_else(|| Refused::Place { curve: piece.id.clone(), x: x.to_f64() })
    }

    /// The inflection, if it lies on the branch of a curve.
    pub fn turn(&self, curve: usize) -> Option<&Point> {
        let (branch, bend) = self.inflection.as_ref()?;
        (self.pieces.list[curve].branch == Branch::Generic(*branch)).then_some(bend)
    }

    /// The refusal of a pair near x.
    pub fn refused(&self, curves: [usize; 2], x: f64, why: &'static str) -> Refused {
        Refused::Pair { curves: curves.map(|c| self.pieces.list[c].id.clone()), x, why }
    }
}

/// A range of y on the curve that holds the place over x. x is monotone along a curve; so it is enough that x of the
/// ends of the range lies on both sides.
fn enclosed(spaces: &Spaces, piece: &Piece, place: &Place, x: &Fixed) -> Option<(Coordinate, Fixed)> {
    // Digits are rounded outward, so that a place may reach beyond an end of its curve.
    let [low, high] = place.range(spaces);
    let clipped = |end: RBig, side: usize| match &piece.range[side] {
        Some([outer, _]) if side == 0 => end.max(outer.clone()),
        Some([_, outer]) => end.min(outer.clone()),
        None => end,
    };
    let range = [clipped(low, 0), clipped(high, 1)];
    let [low, high] = &range;
    let (base, side, inside) = match piece.branch {
        Branch::Generic(number) if place.side != Side::Over => {
            let [left, right] = spaces.interval(number);
            let (base, side) = coordinates(spaces, number);
            (base, side, left.is_none_or(|a| low > a) && right.is_none_or(|a| high < a))
        }
        Branch::Over(base) if place.side == Side::Over && place.base == base => (base, Side::Over, *low >= RBig::ZERO),
        _ => return None,
    };
    let coordinate = Coordinate::new(spaces, base, side, piece);
    if low > high || !inside {
        return None;
    }
    let ends = range.each_ref().map(|parameter| coordinate.y(spaces, parameter));
    // An end inside the enclosure of a cusp or pitchfork needs no comparison.
    let at_station = [
        piece.range[0].as_ref().is_some_and(|end| *low <= end[1]),
        piece.range[1].as_ref().is_some_and(|end| *high >= end[0]),
    ];
    for which in (0..2).filter(|&which| !at_station[which]) {
        let reached = spaces.x(coordinate.base, coordinate.side, &ends[which])?;
        let smaller_x = (which == 0) == piece.rising;
        let holds = if smaller_x { reached.at_most(x) } else { x.at_most(&reached) };
        if !holds {
            return None;
        }
    }
    let y = ends[0].hull(&ends[1]);
    Some((coordinate, y))
}

impl Coordinate {
    fn new(spaces: &Spaces, base: usize, side: Side, piece: &Piece) -> Self {
        let mut coordinate = Self { base, side, rising: piece.rising, inner: [None, None] };
        let [low, high] = &piece.range;
        let inner = [low.as_ref().map(|end| &end[1]), high.as_ref().map(|end| &end[0])];
        coordinate.inner = inner.map(|end| Some(coordinate.y(spaces, end?)));
        if side == Side::Minus {
            coordinate.rising = !coordinate.rising;
            coordinate.inner.reverse();
        }
        coordinate
    }

    /// Interval Newton steps on x(y) = x, and halvings beside a cusp, where they do not exist: none loses the solution,
    /// and an empty one is a contradiction.
    fn sharpened(&self, spaces: &Spaces, mut y: Fixed, x: &Fixed) -> Option<Stand> {
        let state = |y: &Fixed| spaces.point(self.base, self.side, y);
        let (mut steps, mut halvings) = (0, 0);
        while steps < STEPS && halvings < HALVINGS && !y.is_sharp(spaces.bits() / 2) {
            let middle = y.middle();
            let (at, over) = (spaces.x(self.base, self.side, &middle)?, state(&y)?);
            let slope = over.slopes.as_ref().map(|[log_slope, _]| &over.x * log_slope);
            let newton = slope.and_then(|slope| (&at - x).over(&slope));
            let next = if let Some(step) = newton {
                steps += 1;
                y.meet(&(&middle - &step))?
            } else {
                halvings += 1;
                let Some(next) = self.halved(&y, &middle, &at, x) else {
                    break;
                };
                next
            };
            if next == y {
                break;
            }
            y = next;
        }
        Some(Stand { point: state(&y)?, y: Some(y) })
    }

    /// The half of a range that holds the solution, since x is monotone along a curve; `None` when x in the middle, which
    /// must lie on the curve, does not decide it.
    fn halved(&self, y: &Fixed, middle: &Fixed, at: &Fixed, x: &Fixed) -> Option<Fixed> {
        let [low, high] = &self.inner;
        let on_curve =
            low.as_ref().is_none_or(|low| low.below(middle)) && high.as_ref().is_none_or(|h| middle.below(h));
        let upper = match (at.below(x), x.below(at)) {
            (true, _) => self.rising,
            (_, true) => !self.rising,
            _ => return None,
        };
        on_curve.then(|| middle.hull(&if upper { y.upper() } else { y.lower() }))
    }

    /// y of a μ; over a space without r the parameter is y itself.
    fn y(&self, spaces: &Spaces, parameter: &RBig) -> Fixed {
        match self.side {
            Side::Over => spaces.set(parameter),
            side => spaces.set(&distance(spaces, self.base, side, parameter)),
        }
    }
}
