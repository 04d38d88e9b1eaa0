//! The curves that a document lists, against those that follow from the certificate: which there are, on which others they
//! run, their branches, Morse indices, ranges of μ and l, and their asymptotes.

use bifdiag_schema::{AtlasDocument, CertificateDocument, CurveDocument, CurveKind};
use dashu_ratio::RBig;

use crate::Refused;
use crate::equilibria::pieces::{Branch, End, Piece};
use crate::equilibria::spaces::Spaces;
use crate::numbers::bounds;
use crate::numbers::fixed::Fixed;
use crate::order::orders::Orders;
use crate::order::slabs::Slab;
use crate::topology::morse;

/// A double is what a set is within 2⁻ᵇ of the set's size: μ and l of cusps, which the document rounds from roots in doubles.
const ROOT: usize = 20;
/// Likewise, of numbers that are only converted.
pub(crate) const CONVERTED: usize = 40;

/// What a document ought to say of a curve, in the certificate's units.
struct Expected<'a> {
    id: &'a str,
    kind: CurveKind,
    coincides_with: Vec<&'a str>,
    branch: &'a str,
    words: String,
    index: Option<u8>,
    mu: Option<[Option<Fixed>; 2]>,
    x: [Option<Fixed>; 2],
    /// J and h₀ of the axis for x → ∞.
    tail: Option<[Fixed; 2]>,
}

/// Checks every curve, and the names of the curves at each cusp.
pub(crate) fn check(
    document: &AtlasDocument,
    certificate: &CertificateDocument,
    orders: &Orders,
    slabs: &[Slab],
) -> Result<(), Refused> {
    let pieces = &orders.pieces.list;
    let mut expected = (0..pieces.len()).map(|n| Expected::of(orders, slabs, n)).collect::<Result<Vec<_>, _>>()?;
    for plus in [true, false] {
        // A pole line that runs on critical lines is listed beside them.
        let on = |piece: &&Piece| piece.critical && piece.branch == Branch::Line(plus);
        let runs_on: Vec<&str> = pieces.iter().filter(on).map(|piece| piece.id.as_str()).collect();
        if !runs_on.is_empty() {
            expected.push(Expected::line(orders.spaces, plus, runs_on));
        }
    }
    if expected.len() != document.curves.len() {
        return Err(Refused::Field { field: "the number of curves" });
    }
    for (curve, expected) in document.curves.iter().zip(&expected) {
        expected.compare(curve, orders.spaces)?;
    }
    for (number, cusp) in certificate.cusps.iter().enumerate() {
        let named = cusp.curves.iter().map(|id| orders.pieces.find(id)).collect::<Result<Vec<usize>, _>>()?;
        if named != orders.pieces.at_cusp(number) {
            return Err(Refused::misplaced("cusp", number));
        }
    }
    Ok(())
}

impl<'a> Expected<'a> {
    fn of(orders: &Orders<'a>, slabs: &[Slab], number: usize) -> Result<Self, Refused> {
        let (spaces, piece) = (orders.spaces, &orders.pieces.list[number]);
        let axes = match piece.branch {
            Branch::Over(base) | Branch::Rotation(base) => spaces.list[base].axes.len(),
            _ => 1,
        };
        let index = if piece.critical {
            let mut levels = slabs.iter().flat_map(|slab| &slab.levels).filter(|level| level.curve == number);
            let found = levels.find_map(|level| morse::index(spaces, &level.point, axes));
            Some(found.ok_or(Refused::Field { field: "curves.index" })?)
        } else {
            None
        };
        let (kind, coincides_with) = match (piece.branch, axes) {
            (Branch::Generic(_), _) => (CurveKind::Generic, Vec::new()),
            (Branch::Line(plus), _) if piece.critical => (CurveKind::Axis, vec![pole_id(plus)]),
            (Branch::Line(plus), _) => (pole_kind(plus), Vec::new()),
            (_, 1) => (CurveKind::Pair, Vec::new()),
            (_, 2) => (CurveKind::Circle, Vec::new()),
            _ => (CurveKind::Sphere, Vec::new()),
        };
        let x = [0, 1].map(|side| orders.pieces.end_x(number, side));
        Ok(Self {
            id: &piece.id,
            kind,
            coincides_with,
            branch: piece.id.split('.').next().unwrap_or_default(),
            words: words(spaces, piece),
            index,
            mu: mu_range(spaces, piece, x),
            x: x.map(Option::<&Fixed>::cloned),
            tail: tail(spaces, piece),
        })
    }

    /// A pole line on which critical lines run.
    fn line(spaces: &Spaces, plus: bool, coincides_with: Vec<&'a str>) -> Self {
        Self {
            id: pole_id(plus),
            kind: pole_kind(plus),
            coincides_with,
            branch: pole_id(plus),
            words: pole_line(plus),
            index: None,
            mu: None,
            x: [Some(Fixed::whole(0)), None],
            tail: Some(line_tail(spaces, plus)),
        }
    }

    fn compare(&self, curve: &CurveDocument, spaces: &Spaces) -> Result<(), Refused> {
        let Spaces { moment, energy, norm, .. } = spaces;
        let multiplicity = if self.kind == CurveKind::Pair { 2 } else { 1 };
        if curve.id != self.id
            || (curve.kind, curve.multiplicity) != (self.kind, multiplicity)
            || curve.coincides_with != self.coincides_with
        {
            return Err(Refused::UnknownCurve { id: self.id.to_owned() });
        }
        let same =
            |claim: Option<f64>, found: Option<&Fixed>, power: i32, unit: &RBig, least: &RBig| match (claim, found) {
                (None, None) => true,
                (Some(claim), Some(found)) => is_near(claim, power, unit, found, &size(found).max(least.clone()), ROOT),
                _ => false,
            };
        // μ is a moment up to what the weight adds, and may be 0.
        let smallest = size(&spaces.list[0].a_set);
        let mu = match (&curve.mu_range, &self.mu) {
            (None, None) => true,
            (Some(claim), Some(found)) => (0..2).all(|end| same(claim[end], found[end].as_ref(), 1, moment, &smallest)),
            _ => false,
        };
        let l2 = spaces.square_of_momentum();
        let tail = match (&curve.tail, &self.tail) {
            (None, None) => true,
            (Some(claim), Some([j, h])) => {
                is_near(claim.moment, 1, moment, j, &size(j), CONVERTED)
                    && is_near(claim.h_offset, 1, energy, h, &size(norm), CONVERTED)
            }
            _ => false,
        };
        let fields = [
            ("curves.branch", curve.branch == self.branch),
            ("curves.branch_name", curve.branch_name == self.words),
            ("curves.index", curve.index == self.index),
            ("curves.mu_range", mu),
            ("curves.l_range", (0..2).all(|end| same(curve.l_range[end], self.x[end].as_ref(), 2, &l2, &RBig::ZERO))),
            ("curves.tail", tail),
        ];
        match fields.into_iter().find(|(_, is_right)| !is_right) {
            Some((field, _)) => Err(Refused::Field { field }),
            None => Ok(()),
        }
    }
}

fn pole_id(plus: bool) -> &'static str {
    if plus { "P+" } else { "P-" }
}

fn pole_kind(plus: bool) -> CurveKind {
    if plus { CurveKind::PolePlus } else { CurveKind::PoleMinus }
}

/// The largest absolute value of a set.
fn size(set: &Fixed) -> RBig {
    let [low, high] = set.ends();
    high.max(-low)
}

/// A double, or its square, is a unit times every number of a set, within 2⁻ᵇ of a size.
pub(crate) fn is_near(claim: f64, power: i32, unit: &RBig, set: &Fixed, size: &RBig, bits: usize) -> bool {
    let Some(exact) = bounds::exact(claim).filter(|exact| power == 1 || *exact >= RBig::ZERO) else {
        return false;
    };
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

/// The range of μ of the closed form; absent without one.
fn mu_range(spaces: &Spaces, piece: &Piece, x: [Option<&Fixed>; 2]) -> Option<[Option<Fixed>; 2]> {
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
            let at = |side: usize| match (piece.ends[side], x[side]) {
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
