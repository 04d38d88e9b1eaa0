//! The words and numbers that a document tells of each curve: its branch, its Morse index, its ranges of μ and l, and how it
//! goes on to infinity.

use bifdiag_schema::{AtlasDocument, CertificateDocument, CurveDocument};
use dashu_ratio::RBig;

use crate::Refused;
use crate::equilibria::pieces::{Branch, End, Piece};
use crate::equilibria::spaces::Spaces;
use crate::numbers::bounds;
use crate::numbers::fixed::Fixed;
use crate::numbers::number;
use crate::order::orders::Orders;
use crate::order::slabs::Slab;
use crate::topology::morse;

/// A double is what a set is within 2⁻ᵇ of the set's size: μ and l of cusps, which the document rounds from roots in doubles.
const ROOT: usize = 20;
/// Likewise, of numbers that are only converted.
pub(crate) const CONVERTED: usize = 40;

/// What a document ought to say of a curve, in the certificate's units.
struct Measures {
    branch: String,
    words: String,
    index: Option<u8>,
    mu: Option<[Option<Fixed>; 2]>,
    x: [Option<Fixed>; 2],
    /// J and h₀ of the axis for x → ∞.
    tail: Option<[Fixed; 2]>,
}

/// Checks what is told of each curve.
pub(crate) fn curves(
    document: &AtlasDocument,
    certificate: &CertificateDocument,
    orders: &Orders,
    slabs: &[Slab],
) -> Result<(), Refused> {
    let units = [number::unit(&certificate.units.moment)?, number::unit(&certificate.units.energy)?];
    for curve in &document.curves {
        let found = match orders.pieces.find(&curve.id) {
            Ok(number) => Measures::of(orders, slabs, number)?,
            // A pole line that runs on critical lines.
            Err(_) => Measures::of_line(orders.spaces, curve.id == "P+"),
        };
        found.compare(curve, &units, &orders.spaces.norm)?;
    }
    Ok(())
}

impl Measures {
    fn of(orders: &Orders, slabs: &[Slab], number: usize) -> Result<Self, Refused> {
        let (spaces, piece) = (orders.spaces, &orders.pieces.list[number]);
        let x = [orders.pieces.end_x(spaces, number, 0)?, orders.pieces.end_x(spaces, number, 1)?];
        let index = if piece.critical {
            let levels = slabs.iter().flat_map(|slab| &slab.levels).filter(|level| level.curve == number);
            let axes = match piece.branch {
                Branch::Over(base) | Branch::Rotation(base) => spaces.list[base].axes.len(),
                _ => 1,
            };
            let found = levels.map(|level| &level.point).find_map(|point| morse::index(spaces, point, axes));
            Some(found.ok_or(Refused::Field { field: "curves.index" })?)
        } else {
            None
        };
        let branch = piece.id.split('.').next().unwrap_or_default().to_owned();
        let mu = mu_range(spaces, piece, &x);
        Ok(Self { branch, words: words(spaces, piece), index, mu, x, tail: tail(spaces, piece) })
    }

    fn of_line(spaces: &Spaces, plus: bool) -> Self {
        Self {
            branch: if plus { "P+" } else { "P-" }.to_owned(),
            words: pole_line(plus),
            index: None,
            mu: None,
            x: [Some(Fixed::whole(0)), None],
            tail: Some(line_tail(spaces, plus)),
        }
    }

    fn compare(&self, curve: &CurveDocument, [moment, energy]: &[RBig; 2], norm: &Fixed) -> Result<(), Refused> {
        let refuse = |field| Err(Refused::Field { field });
        if curve.branch != self.branch {
            return refuse("curves.branch");
        }
        if curve.branch_name != self.words {
            return refuse("curves.branch_name");
        }
        if curve.index != self.index {
            return refuse("curves.index");
        }
        let same = |claim: Option<f64>, found: Option<&Fixed>, power: i32, unit: &RBig| match (claim, found) {
            (None, None) => true,
            (Some(claim), Some(found)) => is_near(claim, power, unit, found, &size(found), ROOT),
            _ => false,
        };
        let mu = match (&curve.mu_range, &self.mu) {
            (None, None) => true,
            (Some(claim), Some(found)) => (0..2).all(|end| same(claim[end], found[end].as_ref(), 1, moment)),
            _ => false,
        };
        if !mu {
            return refuse("curves.mu_range");
        }
        let l2 = moment * energy * RBig::from(2);
        if !(0..2).all(|end| same(curve.l_range[end], self.x[end].as_ref(), 2, &l2)) {
            return refuse("curves.l_range");
        }
        let tail = match (&curve.tail, &self.tail) {
            (None, None) => true,
            (Some(claim), Some([j, h])) => {
                is_near(claim.moment, 1, moment, j, &size(j), CONVERTED)
                    && is_near(claim.h_offset, 1, energy, h, &size(norm), CONVERTED)
            }
            _ => false,
        };
        if tail { Ok(()) } else { refuse("curves.tail") }
    }
}

/// The largest absolute value of a set.
fn size(set: &Fixed) -> RBig {
    let [low, high] = set.ends();
    high.max(-low)
}

/// A double, or its square, is a unit times every number of a set, within 2⁻ᵇ of a size.
pub(crate) fn is_near(claim: f64, power: i32, unit: &RBig, set: &Fixed, size: &RBig, bits: usize) -> bool {
    let Some(exact) = bounds::exact(claim).filter(|exact| power == 1 || *exact >= RBig::ZERO) else { return false };
    let value = if power == 2 { &exact * &exact } else { exact } / unit;
    let room = size / RBig::from(dashu_int::IBig::ONE << bits);
    set.lies_in(&(&value - &room), &(value + room))
}

/// Numbers of the axes of a space.
fn axes(spaces: &Spaces, space: usize) -> String {
    let axes: Vec<String> = spaces.list[space].axes.iter().map(|axis| (axis + 1).to_string()).collect();
    format!("{} {}", if axes.len() > 1 { "axes" } else { "axis" }, axes.join(" and "))
}

fn pole_line(plus: bool) -> String {
    format!("pole line of {}r̂", if plus { "+" } else { "−" })
}

/// The branch in words.
fn words(spaces: &Spaces, piece: &Piece) -> String {
    let from = |plus: bool| if plus { "from +r̂" } else { "from −r̂" }.to_owned();
    match piece.branch {
        Branch::Line(plus) if piece.critical => from(plus),
        Branch::Line(plus) => pole_line(plus),
        Branch::Generic(0) => from(false),
        Branch::Generic(n) if n == spaces.active.len() => from(true),
        Branch::Generic(n) => {
            format!("between {} and {}", axes(spaces, spaces.active[n - 1]), axes(spaces, spaces.active[n]))
        }
        Branch::Over(base) | Branch::Rotation(base) => match spaces.list[base].axes.len() {
            1 => format!("pair over {}", axes(spaces, base)),
            2 => format!("circle over {}", axes(spaces, base)),
            _ => "all directions".to_owned(),
        },
    }
}

/// The range of μ of the closed form; absent where there is none.
fn mu_range(spaces: &Spaces, piece: &Piece, x: &[Option<Fixed>; 2]) -> Option<[Option<Fixed>; 2]> {
    match piece.branch {
        Branch::Generic(number) => {
            let limits = spaces.interval(number);
            Some([0, 1].map(|side| match &piece.range[side] {
                Some([low, high]) => Some(spaces.set(low).hull(&spaces.set(high))),
                None => limits[side].map(|a| spaces.set(a)),
            }))
        }
        Branch::Over(base) => Some([0, 1].map(|_| Some(spaces.list[base].a_set.clone()))),
        Branch::Line(plus) if piece.critical => {
            // μ = a ± r/s with s = 2x/a², which falls from ∞ on +r̂ and rises from −∞ on −r̂.
            let a = spaces.set(&spaces.j_r());
            let at = |side: usize| match (piece.ends[side], &x[side]) {
                (End::Infinity, _) => Some(a.clone()),
                (_, Some(x)) => {
                    let shift = (&spaces.norm * &a.square()).over(&(&Fixed::whole(2) * x))?;
                    Some(if plus { &a + &shift } else { &a - &shift })
                }
                _ => None,
            };
            Some(if plus { [at(1), at(0)] } else { [at(0), at(1)] })
        }
        Branch::Line(_) | Branch::Rotation(_) => None,
    }
}

/// J and h₀ of the axis to which a curve tends for x → ∞ (Proposition 6.2).
pub(crate) fn tail(spaces: &Spaces, piece: &Piece) -> Option<[Fixed; 2]> {
    if piece.ends[1] != End::Infinity {
        return None;
    }
    match (piece.branch, piece.limit) {
        (Branch::Line(plus), _) => Some(line_tail(spaces, plus)),
        (Branch::Rotation(base), _) => Some([spaces.list[base].a_set.clone(), Fixed::whole(0)]),
        (_, Some((space, side))) => {
            let space = &spaces.list[space];
            Some([space.a_set.clone(), &Fixed::whole(i32::from(-side)) * &space.root_q])
        }
        _ => None,
    }
}

fn line_tail(spaces: &Spaces, plus: bool) -> [Fixed; 2] {
    [spaces.set(&spaces.j_r()), if plus { -&spaces.norm } else { spaces.norm.clone() }]
}
