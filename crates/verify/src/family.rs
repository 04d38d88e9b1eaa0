//! The body of a certificate and its families of relative equilibria, in [`Fixed`].

use dashu_ratio::RBig;

use super::fixed::Fixed;
use super::sturm::{Coefficients, plus, times};
use schema::PlaceDocument;
use top::body::{Body, Number};

/// An eigenspace of A.
#[derive(Clone, Debug)]
pub(super) struct Space {
    pub a: RBig,
    pub q: RBig,
    /// Its axes, numbered as the body's.
    pub axes: Vec<usize>,
    pub a_set: Fixed,
    pub q_set: Fixed,
    pub root_q: Fixed,
}

/// The body in the certificate's units.
#[derive(Clone, Debug)]
pub(super) struct Spaces {
    pub list: Vec<Space>,
    pub active: Vec<usize>,
    pub r: [RBig; 3],
    pub r2: RBig,
    pub norm: Fixed,
}

/// A half of a family.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Side {
    Plus,
    Minus,
    Over,
}

/// A range of places, as exact numbers.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Place {
    pub base: usize,
    pub side: Side,
    pub lo: RBig,
    pub hi: RBig,
}

/// Equilibria over a range of y.
#[derive(Clone, Debug)]
pub(super) struct Point {
    pub gamma: Vec<Fixed>,
    pub j: Fixed,
    pub rho: Fixed,
    pub x: Fixed,
    /// μ − a of each space; absent on a line that is no equilibrium.
    pub tau: Option<Vec<Fixed>>,
    /// d ln x/dy and dJ/dy.
    pub slopes: Option<[Fixed; 2]>,
}

impl Spaces {
    pub fn new(body: &Body, moment: &RBig, energy: &RBig) -> Self {
        let r = body.center().each_ref().map(|r| r.value() / energy);
        let mut order = [0, 1, 2];
        order.sort_by(|&i, &j| body.moments()[i].cmp(&body.moments()[j]));
        let mut groups: Vec<(RBig, RBig, Vec<usize>)> = Vec::new();
        for i in order {
            let a = Number::value(&body.moments()[i]) / moment;
            let q = &r[i] * &r[i];
            match groups.last_mut() {
                Some((last, sum, axes)) if *last == a => {
                    *sum += q;
                    axes.push(i);
                }
                _ => groups.push((a, q, vec![i])),
            }
        }
        let list: Vec<Space> = groups
            .into_iter()
            .map(|(a, q, mut axes)| {
                axes.sort_unstable();
                let q_set = Fixed::of(&q);
                Space { a_set: Fixed::of(&a), root_q: q_set.root(), q_set, a, q, axes }
            })
            .collect();
        let r2 = r.iter().fold(RBig::ZERO, |sum, c| sum + c * c);
        let active = (0..list.len()).filter(|&k| !list[k].q.is_zero()).collect();
        Self { list, active, norm: Fixed::of(&r2).root(), r2, r }
    }

    pub fn passive(&self) -> Vec<usize> {
        (0..self.list.len()).filter(|k| !self.active.contains(k)).collect()
    }

    pub fn j_r(&self) -> RBig {
        self.list.iter().fold(RBig::ZERO, |sum, s| sum + &s.a * &s.q) / &self.r2
    }

    /// R̂ and P̂ over a space without r.
    pub fn sums(&self, base: usize) -> (RBig, RBig) {
        self.active.iter().fold((RBig::ZERO, RBig::ZERO), |(r, p), &k| {
            let d = &self.list[base].a - &self.list[k].a;
            let term = &self.list[k].q / &d;
            (r + &term, p + term / d)
        })
    }

    fn factor(&self, k: usize) -> Coefficients {
        vec![-self.list[k].a.clone(), RBig::ONE]
    }

    /// Π_{j≠skipped} (μ−a_j)^power over the active spaces.
    fn product(&self, skipped: &[usize], power: usize) -> Coefficients {
        self.active.iter().filter(|k| !skipped.contains(k)).fold(vec![RBig::ONE], |product, &k| {
            (0..power).fold(product, |product, _| times(&product, &self.factor(k)))
        })
    }

    /// D (Σ t_k)(Σ u_k a_k) + 4 Σ_{i<k} u_i u_k (a_i−a_k)² D/((μ−a_i)(μ−a_k)) with u_k = q_k Π_{j≠k}(μ−a_j)² and
    /// D t_k = q_k Π_{j≠k}(μ−a_j)³: the numerator of T J + 4V, whose zeros are the cusps.
    pub fn cusp_polynomial(&self) -> Coefficients {
        let one = RBig::ONE;
        let u = |k: usize| times(&self.product(&[k], 2), &[self.list[k].q.clone()]);
        let (mut t, mut j, mut v) = (Vec::new(), Vec::new(), Vec::new());
        for (n, &k) in self.active.iter().enumerate() {
            t = plus(&t, &self.product(&[k], 3), &self.list[k].q);
            j = plus(&j, &u(k), &self.list[k].a);
            for &i in &self.active[..n] {
                let d = &self.list[i].a - &self.list[k].a;
                let term = times(&times(&u(i), &u(k)), &self.product(&[i, k], 1));
                v = plus(&v, &term, &(&d * &d));
            }
        }
        plus(&times(&t, &j), &plus(&[], &v, &RBig::from(4)), &one)
    }

    /// N and F of the meetings with pole lines (Proposition 5.3 of docs/mathematics.md).
    pub fn pole_polynomials(&self) -> [Coefficients; 2] {
        let (mut p, mut q, mut r) = (Vec::new(), Vec::new(), Vec::new());
        for &k in &self.active {
            let squared = self.product(&[k], 2);
            p = plus(&p, &squared, &self.list[k].q);
            q = plus(&q, &squared, &(&self.list[k].q * &self.list[k].a));
            r = plus(&r, &self.product(&[k], 1), &self.list[k].q);
        }
        let d = self.product(&[], 1);
        let half = RBig::ONE / RBig::from(2);
        let height = plus(&plus(&[], &q, &half), &times(&r, &d), &RBig::from(-1));
        let line = -(&half / self.j_r());
        let n = plus(&times(&height, &p), &times(&q, &q), &line);
        let cube = times(&times(&p, &times(&p, &p)), &times(&d, &d));
        let f = plus(&times(&n, &n), &cube, &-self.r2.clone());
        [n, f]
    }

    /// E and E² − 4r²v³ in v over a space without r.
    pub fn pole_polynomials_over(&self, base: usize) -> [Coefficients; 2] {
        let (r_sum, _) = self.sums(base);
        let a = &self.list[base].a;
        let j = [-r_sum.clone(), a.clone()];
        let e = plus(&[RBig::ZERO, r_sum * RBig::from(3), -a.clone()], &times(&j, &j), &(RBig::ONE / self.j_r()));
        let f = plus(&times(&e, &e), &[RBig::ZERO, RBig::ZERO, RBig::ZERO, RBig::ONE], &(&self.r2 * RBig::from(-4)));
        [e, f]
    }

    /// The cubic whose one root is the place where dJ/dμ = 0.
    pub fn inflection_polynomial(&self) -> Coefficients {
        let [i, j, k] = self.active[..] else { return Vec::new() };
        [(i, j, k), (j, k, i), (k, i, j)].into_iter().fold(Vec::new(), |sum, (i, j, k)| {
            let d = &self.list[i].a - &self.list[j].a;
            let cube = (0..3).fold(vec![RBig::ONE], |cube, _| times(&cube, &self.factor(k)));
            plus(&sum, &cube, &(&self.list[i].q * &self.list[j].q * &d * &d))
        })
    }

    /// All equilibria over a range of y; `None` when it reaches a moment.
    pub fn point(&self, base: usize, side: Side, y: &Fixed) -> Option<Point> {
        if side == Side::Over { self.pair(base, y) } else { self.generic(base, side, y) }
    }

    fn generic(&self, base: usize, side: Side, y: &Fixed) -> Option<Point> {
        let n = self.list.len();
        let delta = if side == Side::Plus { y.clone() } else { -y };
        let one = Fixed::whole(1);
        let zero = Fixed::whole(0);
        let u = one.over(&delta)?;
        let difference = |k: usize| Fixed::of(&(&self.list[base].a - &self.list[k].a));
        // t_k = δ/(δ + d_k): each depends on δ once, so that its range is sharp.
        let mut t = Vec::with_capacity(n);
        for k in 0..n {
            t.push(if k == base {
                one.clone()
            } else if self.active.contains(&k) {
                one.over(&(&one + &(&difference(k) * &u)))?
            } else {
                // Without r the space does not enter; μ may pass its moment.
                zero.clone()
            });
        }
        let weights: Vec<Fixed> = (0..n).map(|k| &self.list[k].q_set * &t[k].square()).collect();
        let total = weights.iter().fold(zero.clone(), |sum, g| &sum + g);
        let root = total.root();
        let s = root.over(y)?;
        let mut w = Vec::with_capacity(n);
        for g in &weights {
            w.push(g.over(&total)?);
        }
        let sign = |e: Fixed| if side == Side::Plus { e } else { -&e };
        let mut gamma = Vec::with_capacity(n);
        for k in 0..n {
            gamma.push(sign((&self.list[k].root_q * &t[k]).over(&root)?));
        }
        // Σ w a with Σ w = 1, measured from each moment: the narrowest.
        let mut j: Option<Fixed> = None;
        for from in 0..n {
            let sum = (0..n).filter(|&k| k != from).fold(self.list[from].a_set.clone(), |sum, k| {
                &sum + &(&w[k] * &Fixed::of(&(&self.list[k].a - &self.list[from].a)))
            });
            j = Some(match j {
                Some(best) => best.meet(&sum)?,
                None => sum,
            });
        }
        let j = j?;
        let rho = gamma.iter().zip(&self.list).fold(zero.clone(), |sum, (g, space)| &sum + &(g * &space.root_q));
        let x = half(&(&s * &j.square()));
        let mean = w.iter().zip(&t).fold(zero.clone(), |sum, (w, t)| &sum + &(w * t));
        // V δ = Σ w_i w_k d² t_i t_k u; for k = base the factor d u t_i is 1 − t_i up to sign.
        let mut spread = zero;
        for i in 0..n {
            for k in 0..i {
                let d = Fixed::of(&(&self.list[i].a - &self.list[k].a));
                let kernel = if k == base || i == base {
                    let other = if k == base { i } else { k };
                    &difference(other) * &(&one - &t[other])
                } else {
                    &(&(&d.square() * &t[i]) * &t[k]) * &u
                };
                spread = &spread + &(&(&w[i] * &w[k]) * &kernel);
            }
        }
        let bracket = &mean + &(&Fixed::whole(4) * &spread).over(&j)?;
        let log_slope = -&bracket.over(y)?;
        let j_slope = -&(&Fixed::whole(2) * &spread).over(y)?;
        let tau = (0..n).map(|k| &delta + &difference(k)).collect();
        Some(Point { gamma, j, rho, x, tau: Some(tau), slopes: Some([log_slope, j_slope]) })
    }

    fn pair(&self, base: usize, y: &Fixed) -> Option<Point> {
        let n = self.list.len();
        let (r_sum, p_sum) = self.sums(base);
        let v = &Fixed::of(&p_sum) + y;
        let s = v.root();
        let mut gamma = Vec::with_capacity(n);
        for k in 0..n {
            let d = Fixed::of(&(&self.list[base].a - &self.list[k].a));
            gamma.push(if k == base {
                y.over(&v)?.root()
            } else if self.active.contains(&k) {
                self.list[k].root_q.over(&(&s * &d))?
            } else {
                Fixed::whole(0)
            });
        }
        let r = Fixed::of(&r_sum);
        let shift = r.over(&v)?;
        let j = &self.list[base].a_set - &shift;
        let rho = r.over(&s)?;
        let x = half(&(&s * &j.square()));
        let log_slope = (&half(&Fixed::whole(1)) + &(&Fixed::whole(2) * &shift).over(&j)?).over(&v)?;
        let j_slope = shift.over(&v)?;
        let tau = (0..n).map(|k| Fixed::of(&(&self.list[base].a - &self.list[k].a))).collect();
        Some(Point { gamma, j, rho, x, tau: Some(tau), slopes: Some([log_slope, j_slope]) })
    }

    /// γ = ± r̂ over x.
    pub fn line(&self, plus: bool, x: &Fixed) -> Option<Point> {
        let sign = |e: Fixed| if plus { e } else { -&e };
        let j = Fixed::of(&self.j_r());
        let mut gamma = Vec::with_capacity(self.list.len());
        for space in &self.list {
            gamma.push(sign(space.root_q.over(&self.norm)?));
        }
        let tau = match self.active[..] {
            [axis] => {
                // μ = a ± r/s with s = 2x/J².
                let shift = sign((&self.norm * &j.square()).over(&(&Fixed::whole(2) * x))?);
                Some(
                    (0..self.list.len())
                        .map(|k| &Fixed::of(&(&self.list[axis].a - &self.list[k].a)) + &shift)
                        .collect(),
                )
            }
            _ => None,
        };
        Some(Point { gamma, j, rho: sign(self.norm.clone()), x: x.clone(), tau, slopes: None })
    }

    /// r = 0: rotation about the axes of a space.
    pub fn rotation(&self, base: usize, x: &Fixed) -> Point {
        let n = self.list.len();
        Point {
            gamma: (0..n).map(|k| Fixed::whole(i32::from(k == base))).collect(),
            j: self.list[base].a_set.clone(),
            rho: Fixed::whole(0),
            x: x.clone(),
            tau: Some((0..n).map(|k| Fixed::of(&(&self.list[base].a - &self.list[k].a))).collect()),
            slopes: None,
        }
    }

    /// h_a − h_b of two curves over the same x: the difference of heights, and for two equilibria also
    /// x [(μ_b − μ_a)|γ_a − γ_b|² − (J_a − J_b)³/(J_a J_b)]/(J_a² + J_b²).
    pub fn gap(&self, x: &Fixed, a: &Point, b: &Point) -> Option<Fixed> {
        let product = &a.j * &b.j;
        let moment = self.moment_difference(a, b);
        let plain = &-&(x * &moment).over(&product)? - &(&a.rho - &b.rho);
        let Some(exact) = identity(a, b, &moment) else { return Some(plain) };
        plain.meet(&(x * &exact))
    }

    /// The gap over x, over ranges of equilibria.
    pub fn range_gap(&self, a: &Point, b: &Point) -> Option<Fixed> {
        identity(a, b, &self.moment_difference(a, b))
    }

    /// J_a − J_b = Σ (γ_a − γ_b)(γ_a + γ_b)(a − a_base).
    fn moment_difference(&self, a: &Point, b: &Point) -> Fixed {
        let plain = &a.j - &b.j;
        (0..self.list.len()).fold(plain, |best, base| {
            let sum = (0..self.list.len()).fold(Fixed::whole(0), |sum, k| {
                let (p, q) = (&a.gamma[k], &b.gamma[k]);
                let d = Fixed::of(&(&self.list[k].a - &self.list[base].a));
                &sum + &(&(&(p - q) * &(p + q)) * &d)
            });
            best.meet(&sum).unwrap_or(best)
        })
    }
}

/// The gap over x from the identity, for two equilibria.
fn identity(a: &Point, b: &Point, moment: &Fixed) -> Option<Fixed> {
    let (p, q) = (a.tau.as_ref()?, b.tau.as_ref()?);
    let mu = &q[0] - &p[0];
    let distance = a.gamma.iter().zip(&b.gamma).fold(Fixed::whole(0), |sum, (p, q)| &sum + &(p - q).square());
    let cube = (moment * &moment.square()).over(&(&a.j * &b.j))?;
    (&(&mu * &distance) - &cube).over(&(&a.j.square() + &b.j.square()))
}

fn half(x: &Fixed) -> Fixed {
    x * &Fixed::of(&(RBig::ONE / RBig::from(2)))
}

impl Place {
    pub fn read(document: &PlaceDocument) -> Option<Self> {
        let side = match document.side.as_str() {
            "+" => Side::Plus,
            "-" => Side::Minus,
            "over" => Side::Over,
            _ => return None,
        };
        let [lo, hi] = document.y.each_ref().map(|text| super::number(text));
        let (lo, hi) = (lo?, hi?);
        (lo <= hi).then_some(Self { base: document.base, side, lo, hi })
    }

    pub fn y(&self) -> Fixed {
        Fixed::between(&self.lo, &self.hi)
    }

    /// The range of μ (of y for a pair).
    pub fn range(&self, spaces: &Spaces) -> [RBig; 2] {
        let a = &spaces.list[self.base].a;
        match self.side {
            Side::Plus => [a + &self.lo, a + &self.hi],
            Side::Minus => [a - &self.hi, a - &self.lo],
            Side::Over => [self.lo.clone(), self.hi.clone()],
        }
    }
}
