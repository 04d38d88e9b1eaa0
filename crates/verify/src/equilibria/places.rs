//! Places on families of relative equilibria, as certificates write them, and the equilibria over ranges of them (Theorems
//! 3.2 and 3.3), enclosed in [`Fixed`].

use bifdiag_schema::PlaceDocument;
use dashu_ratio::RBig;

use super::spaces::Spaces;
use crate::numbers::fixed::Fixed;
use crate::numbers::number;

/// A half of a family.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Side {
    /// μ = a + y.
    Plus,
    /// μ = a − y.
    Minus,
    /// v = P̂ + y over a space without r.
    Over,
}

/// A range of places, as exact numbers.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Place {
    pub base: usize,
    pub side: Side,
    pub lo: RBig,
    pub hi: RBig,
}

impl Place {
    /// A place whose base is a space and whose ends are numbers in order.
    pub fn read(document: &PlaceDocument, spaces: &Spaces) -> Option<Self> {
        let side = match document.side.as_str() {
            "+" => Side::Plus,
            "-" => Side::Minus,
            "over" => Side::Over,
            _ => return None,
        };
        let [lo, hi] = document.y.each_ref().map(|text| number::exact(text));
        let (lo, hi) = (lo?, hi?);
        (lo <= hi && document.base < spaces.list.len()).then_some(Self { base: document.base, side, lo, hi })
    }

    pub fn y(&self, spaces: &Spaces) -> Fixed {
        spaces.set(&self.lo).hull(&spaces.set(&self.hi))
    }

    /// The range of μ (of y over a space without r).
    pub fn range(&self, spaces: &Spaces) -> [RBig; 2] {
        let a = &spaces.list[self.base].a;
        match self.side {
            Side::Plus => [a + &self.lo, a + &self.hi],
            Side::Minus => [a - &self.hi, a - &self.lo],
            Side::Over => [self.lo.clone(), self.hi.clone()],
        }
    }
}

/// Equilibria over a range of y.
#[derive(Clone, Debug)]
pub(crate) struct Point {
    /// The component of γ along r in each space that carries r, and along its first direction in one that does not.
    pub gamma: Vec<Fixed>,
    pub j: Fixed,
    /// ⟨γ, r⟩.
    pub rho: Fixed,
    /// l²/2.
    pub x: Fixed,
    /// μ − a of each space; absent on a line that is no equilibrium.
    pub tau: Option<Vec<Fixed>>,
    /// d ln x/dy and dJ/dy; absent on lines.
    pub slopes: Option<[Fixed; 2]>,
}

/// What the formulas of the generic family share (Theorem 3.2, Lemma 3.5), with μ = a_base + δ.
struct Generic<'a> {
    spaces: &'a Spaces,
    base: usize,
    delta: Fixed,
    /// 1/δ.
    inverse: Fixed,
    /// t_k = δ/(μ − a_k); 0 for a space without r.
    t: Vec<Fixed>,
    /// Σ q_k t_k², and w_k = q_k t_k² divided by it.
    total: Fixed,
    w: Vec<Fixed>,
}

/// √Σ q t², J and x, the last from s = √Σ q t²/|δ|.
struct Momentum {
    root: Fixed,
    j: Fixed,
    x: Fixed,
}

impl Spaces {
    /// All equilibria over a range of y; `None` when it reaches a moment.
    pub fn point(&self, base: usize, side: Side, y: &Fixed) -> Option<Point> {
        match side {
            Side::Over => self.pair(base, y),
            Side::Plus => Generic::new(self, base, y.clone())?.point(side, y),
            Side::Minus => Generic::new(self, base, -y)?.point(side, y),
        }
    }

    /// x of the equilibria over a range of y, without the rest.
    pub fn x(&self, base: usize, side: Side, y: &Fixed) -> Option<Fixed> {
        let delta = if side == Side::Minus { -y } else { y.clone() };
        match side {
            Side::Over => Some(self.pair(base, y)?.x),
            _ => Some(Generic::new(self, base, delta)?.x(y)?.x),
        }
    }

    /// h = x/J − ⟨γ, r⟩ over x.
    pub fn height(x: &Fixed, point: &Point) -> Option<Fixed> {
        Some(&x.over(&point.j)? - &point.rho)
    }

    /// Over a space without r: γ_k = √q_k/(s d_k) with s² = v = P̂ + y, and the rest of |γ|² = 1 in the space itself.
    fn pair(&self, base: usize, y: &Fixed) -> Option<Point> {
        let (r_sum, p_sum) = self.sums(base);
        let v = &self.set(&p_sum) + y;
        let s = v.root()?;
        let mut gamma = Vec::with_capacity(self.list.len());
        for (k, space) in self.list.iter().enumerate() {
            gamma.push(if k == base {
                y.over(&v)?.root()?
            } else if self.active.contains(&k) {
                space.root_q.over(&(&s * self.difference(base, k)))?
            } else {
                Fixed::whole(0)
            });
        }
        let r = self.set(&r_sum);
        let shift = r.over(&v)?;
        let j = &self.list[base].a_set - &shift;
        let x = (&s * &j.square()).half();
        let log_slope = (&Fixed::whole(1).half() + &(&Fixed::whole(2) * &shift).over(&j)?).over(&v)?;
        let slopes = Some([log_slope, shift.over(&v)?]);
        Some(Point { gamma, rho: r.over(&s)?, j, x, tau: Some(self.over_moments(base)), slopes })
    }

    /// γ = ± r̂ over x; an equilibrium when r lies on an axis, with μ = a ± r/s and s = 2x/J².
    pub fn line(&self, plus: bool, x: &Fixed) -> Option<Point> {
        let sign = |e: Fixed| if plus { e } else { -&e };
        let j = self.set(&self.j_r());
        let mut gamma = Vec::with_capacity(self.list.len());
        for space in &self.list {
            gamma.push(sign(space.root_q.over(&self.norm)?));
        }
        let tau = match self.active[..] {
            [axis] => {
                let shift = sign((&self.norm * &j.square()).over(&(&Fixed::whole(2) * x))?);
                Some((0..self.list.len()).map(|k| self.difference(axis, k) + &shift).collect())
            }
            _ => None,
        };
        Some(Point { gamma, j, rho: sign(self.norm.clone()), x: x.clone(), tau, slopes: None })
    }

    /// r = 0: rotation about the axes of a space.
    pub fn rotation(&self, base: usize, x: &Fixed) -> Point {
        Point {
            gamma: (0..self.list.len()).map(|k| Fixed::whole(i32::from(k == base))).collect(),
            j: self.list[base].a_set.clone(),
            rho: Fixed::whole(0),
            x: x.clone(),
            tau: Some(self.over_moments(base)),
            slopes: None,
        }
    }

    /// μ − a of each space where μ is the moment of one.
    fn over_moments(&self, base: usize) -> Vec<Fixed> {
        (0..self.list.len()).map(|k| self.difference(base, k).clone()).collect()
    }
}

impl<'a> Generic<'a> {
    fn new(spaces: &'a Spaces, base: usize, delta: Fixed) -> Option<Self> {
        let one = Fixed::whole(1);
        let inverse = one.over(&delta)?;
        let mut t = Vec::with_capacity(spaces.list.len());
        for k in 0..spaces.list.len() {
            t.push(if k == base {
                one.clone()
            } else if spaces.active.contains(&k) {
                // Depends on δ once, so that its range is sharp.
                one.over(&(&one + &(spaces.difference(base, k) * &inverse)))?
            } else {
                // Without r the space does not enter; μ may pass its moment.
                Fixed::whole(0)
            });
        }
        let weights: Vec<Fixed> = spaces.list.iter().zip(&t).map(|(space, t)| &space.q_set * &t.square()).collect();
        let total = weights.iter().fold(Fixed::whole(0), |sum, g| &sum + g);
        let w = weights.iter().map(|g| g.over(&total)).collect::<Option<_>>()?;
        Some(Self { spaces, base, delta, inverse, t, total, w })
    }

    fn x(&self, y: &Fixed) -> Option<Momentum> {
        let root = self.total.root()?;
        let j = self.moment_of_inertia()?;
        let x = (&root.over(y)? * &j.square()).half();
        Some(Momentum { root, j, x })
    }

    fn point(&self, side: Side, y: &Fixed) -> Option<Point> {
        let spaces = self.spaces;
        let sign = |e: Fixed| if side == Side::Plus { e } else { -&e };
        let Momentum { root, j, x } = self.x(y)?;
        let mut gamma = Vec::with_capacity(spaces.list.len());
        for (space, t) in spaces.list.iter().zip(&self.t) {
            gamma.push(sign((&space.root_q * t).over(&root)?));
        }
        let rho = gamma.iter().zip(&spaces.list).fold(Fixed::whole(0), |sum, (g, space)| &sum + &(g * &space.root_q));
        let mean = self.w.iter().zip(&self.t).fold(Fixed::whole(0), |sum, (w, t)| &sum + &(w * t));
        let spread = self.spread();
        let bracket = &mean + &(&Fixed::whole(4) * &spread).over(&j)?;
        let log_slope = -&bracket.over(y)?;
        let j_slope = -&(&Fixed::whole(2) * &spread).over(y)?;
        let tau = (0..spaces.list.len()).map(|k| &self.delta + spaces.difference(self.base, k)).collect();
        Some(Point { gamma, j, rho, x, tau: Some(tau), slopes: Some([log_slope, j_slope]) })
    }

    /// J = Σ w a with Σ w = 1: measured from each moment in turn, since none gives the narrowest result everywhere.
    fn moment_of_inertia(&self) -> Option<Fixed> {
        let n = self.w.len();
        let measured = (0..n).map(|from| {
            (0..n).filter(|&k| k != from).fold(self.spaces.list[from].a_set.clone(), |sum, k| {
                &sum + &(&self.w[k] * self.spaces.difference(k, from))
            })
        });
        measured.map(Some).reduce(|best, sum| best?.meet(&sum?))?
    }

    /// V δ = Σ w_i w_k d² t_i t_k/δ; for k = base the factor d t_i/δ is 1 − t_i up to sign.
    fn spread(&self) -> Fixed {
        let one = Fixed::whole(1);
        let mut spread = Fixed::whole(0);
        for i in 0..self.w.len() {
            for k in 0..i {
                let kernel = if k == self.base || i == self.base {
                    let other = if k == self.base { i } else { k };
                    self.spaces.difference(self.base, other) * &(&one - &self.t[other])
                } else {
                    &(&(&self.spaces.difference(i, k).square() * &self.t[i]) * &self.t[k]) * &self.inverse
                };
                spread = &spread + &(&(&self.w[i] * &self.w[k]) * &kernel);
            }
        }
        spread
    }
}
