//! Where a curve stands over one x.

use dashu_ratio::RBig;
use schema::PlaceDocument;

use super::Refused;
use super::equilibria::Point;
use super::fixed::Fixed;
use super::pieces::{Branch, Pieces, coordinates, distance};
use super::place::{Place, Side};
use super::spaces::Spaces;

/// Newton steps that sharpen a place at most: each doubles its digits, and they end where it gains nothing.
const STEPS: usize = 12;

/// A curve over one x.
#[derive(Clone, Debug)]
pub(super) struct Stand {
    /// y in the coordinate of the curve's interval; absent on a straight line.
    pub y: Option<Fixed>,
    pub point: Point,
}

/// The coordinate of the branch in which a curve is computed.
struct Coordinate {
    base: usize,
    side: Side,
}

/// The equilibrium of a curve over x, from the place that the certificate names: x of both its ends must enclose x.
pub(super) fn stand(
    spaces: &Spaces,
    pieces: &Pieces,
    curve: usize,
    place: Option<&PlaceDocument>,
    x: &Fixed,
) -> Result<Stand, Refused> {
    let piece = &pieces.list[curve];
    let found = match piece.branch {
        Branch::Line(plus) => spaces.line(plus, x).map(|point| Stand { y: None, point }),
        Branch::Rotation(base) => Some(Stand { y: None, point: spaces.rotation(base, x) }),
        Branch::Generic(_) | Branch::Over(_) => place
            .and_then(|place| Place::read(place, spaces))
            .and_then(|place| enclosed(spaces, pieces, curve, &place, x))
            .and_then(|(coordinate, y)| sharpened(spaces, &coordinate, y, x)),
    };
    found.ok_or_else(|| Refused::Place { curve: piece.id.clone(), x: x.to_f64() })
}

/// A range of y on the curve that holds the place over x. x is monotone along a curve; so it is enough that x of the
/// ends of the range lies on both sides.
fn enclosed(spaces: &Spaces, pieces: &Pieces, curve: usize, place: &Place, x: &Fixed) -> Option<(Coordinate, Fixed)> {
    let piece = &pieces.list[curve];
    let range = place.range(spaces);
    let [low, high] = &range;
    let (coordinate, inside) = match piece.branch {
        Branch::Generic(number) if place.side != Side::Over => {
            let [left, right] = spaces.interval(number);
            let (base, side) = coordinates(spaces, number);
            (Coordinate { base, side }, left.is_none_or(|a| low > a) && right.is_none_or(|a| high < a))
        }
        Branch::Over(base) if place.side == Side::Over && place.base == base => {
            (Coordinate { base, side: Side::Over }, *low >= RBig::ZERO)
        }
        _ => return None,
    };
    // The place lies between the outer ends of the enclosures in which the curve ends.
    let before = piece.range[0].as_ref().is_some_and(|end| *low < end[0]);
    let after = piece.range[1].as_ref().is_some_and(|end| *high > end[1]);
    if before || after || !inside {
        return None;
    }
    let ends = range.each_ref().map(|parameter| coordinate.y(spaces, parameter));
    // An end inside the enclosure of a cusp or pitchfork needs no comparison.
    let at_station = [
        piece.range[0].as_ref().is_some_and(|end| *low <= end[1]),
        piece.range[1].as_ref().is_some_and(|end| *high >= end[0]),
    ];
    for which in (0..2).filter(|&which| !at_station[which]) {
        let reached = spaces.point(coordinate.base, coordinate.side, &ends[which])?.x;
        let smaller_x = (which == 0) == piece.rising;
        let holds = if smaller_x { reached.at_most(x) } else { x.at_most(&reached) };
        if !holds {
            return None;
        }
    }
    let y = ends[0].hull(&ends[1]);
    Some((coordinate, y))
}

/// Interval Newton steps on x(y) = x: none loses the solution, and an empty one is a contradiction.
fn sharpened(spaces: &Spaces, coordinate: &Coordinate, mut y: Fixed, x: &Fixed) -> Option<Stand> {
    let state = |y: &Fixed| spaces.point(coordinate.base, coordinate.side, y);
    for _ in 0..STEPS {
        let middle = y.middle();
        let (at, over) = (state(&middle)?, state(&y)?);
        let Some([log_slope, _]) = &over.slopes else { break };
        let Some(step) = (&at.x - x).over(&(&over.x * log_slope)) else { break };
        let next = y.meet(&(&middle - &step))?;
        if next == y {
            break;
        }
        y = next;
    }
    Some(Stand { point: state(&y)?, y: Some(y) })
}

impl Coordinate {
    /// y of a μ; over a space without r the parameter is y itself.
    fn y(&self, spaces: &Spaces, parameter: &RBig) -> Fixed {
        match self.side {
            Side::Over => Fixed::of(parameter),
            side => Fixed::of(&distance(spaces, self.base, side, parameter)),
        }
    }
}
