//! Poles, relative equilibria and principal axes, and their names: beside the marks, off ∂U and the rim, and off each other.

use super::scene::SphereScene;
use super::view::{SphereView, Vector, turned};
use bifdiag_page::{
    Anchor, Canvas, FAINT_INK, INK, Ink, Labelled, PAPER, POLE, POLE_MINUS, Point, Rect, Taken, distance, letter,
    meets, rgb, round_point, text_width,
};
use bifdiag_schema::{Multiplicity, RelativeEquilibriumDocument};
use plotters::style::RGBColor;

/// Font sizes of names, and of the numbers of components.
const LABEL: f64 = 12.0;
const NUMBER: f64 = 15.0;
pub(super) const MARK: f64 = 4.2;
/// Round the mark of an equilibrium.
const POLE_RING: f64 = 7.4;
/// Principal axes so near to a pole have no mark of their own.
const NEAR: f64 = 0.1;
/// Relative equilibria stand out from every tint and from the level lines.
pub(super) const EQUILIBRIUM: RGBColor = rgb(0x9a_10_2a);

/// From a mark to its name, for the nearest places and the others.
const AWAY: [f64; 2] = [9.0, 15.3];
/// The cost of placing a number beside the sphere.
const OUTSIDE: f64 = 1000.0;
/// What it costs to cross ∂U or the rim, and a level line; to be one place further down the list costs 1.
const CROSSED: [f64; 2] = [60.0, 4.0];

/// The meaning of a mark.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum SphereMark {
    /// A relative equilibrium of this Morse index.
    Equilibrium(u8),
    /// +r̂ (true) or −r̂.
    Pole(bool),
    /// The end of a principal axis.
    Axis,
}

impl SphereMark {
    /// Of a relative equilibrium: across a circle of maxima U rises nowhere, as at a maximum.
    pub(super) fn of(point: &RelativeEquilibriumDocument) -> Self {
        match (point.multiplicity, point.index) {
            (Multiplicity::Circle, 1..) => Self::Equilibrium(2),
            (_, index) => Self::Equilibrium(index),
        }
    }
}

pub(super) fn draw(canvas: &Canvas, mark: SphereMark, at: Point) {
    let thin = Ink { color: EQUILIBRIUM, width: 1.8 };
    match mark {
        SphereMark::Equilibrium(0) => {
            canvas.disc(at, MARK + 1.0, PAPER);
            canvas.disc(at, MARK, EQUILIBRIUM);
        }
        SphereMark::Equilibrium(1) => {
            for [dx, dy] in [[1.0, 1.0], [1.0, -1.0]] {
                let [x, y] = [MARK * dx, MARK * dy];
                let ends = [[at[0] - x, at[1] - y], [at[0] + x, at[1] + y]];
                canvas.path(&ends, Ink { color: PAPER, width: 3.8 });
                canvas.path(&ends, thin);
            }
        }
        SphereMark::Equilibrium(_) => canvas.ring(at, MARK, thin),
        SphereMark::Pole(plus) => {
            canvas.ring(at, POLE_RING, Ink { color: if plus { POLE } else { POLE_MINUS }, width: 2.2 });
            if plus {
                canvas.disc(at, 1.7, POLE);
            }
        }
        SphereMark::Axis => canvas.disc(at, 1.6, FAINT_INK),
    }
}

/// Draws the ends of the principal axes, the poles, the equilibria and the numbers of components that a view shows, with
/// their names.
pub(super) fn draw_all(canvas: &Canvas, scene: &SphereScene<'_>, names: &mut Names<'_>, numbers: &[(usize, Point)]) {
    let view = names.view;
    let r_hat = scene.r_hat;
    let poles: Vec<Vector> = r_hat.into_iter().flat_map(|r| [r, r.map(|c| -c)]).collect();
    let ends = (0..6).map(|k| {
        let mut gamma = [0.0; 3];
        gamma[k % 3] = if k < 3 { 1.0 } else { -1.0 };
        gamma
    });
    let equilibria = scene.equilibria.iter().map(|point| point.gamma);
    let fixed = poles.iter().copied().chain(ends).chain(equilibria).filter_map(|gamma| view.position(gamma));
    let fixed: Vec<Point> = fixed.collect();
    let asides: Vec<_> =
        scene.equilibria.iter().map(|point| names.aside(view.position(point.gamma)?, point.index, &fixed)).collect();
    // Poles and axes first, then the equilibria, so that one at a pole lies inside its ring.
    let mut named: Vec<(Point, String, f64, RGBColor)> = Vec::new();
    for (plus, name) in [(true, "+r̂"), (false, "−r̂")] {
        let sign = if plus { 1.0 } else { -1.0 };
        if let Some(at) = r_hat.and_then(|r| view.position(r.map(|c| sign * c))) {
            draw(canvas, SphereMark::Pole(plus), at);
            names.take(Rect::around(at, POLE_RING + 1.0));
            named.push((at, name.to_owned(), LABEL, INK));
        }
    }
    for (axis, ends) in [["e₁", "−e₁"], ["e₂", "−e₂"], ["e₃", "−e₃"]].into_iter().enumerate() {
        for (sign, name) in [1.0, -1.0].into_iter().zip(ends) {
            let mut gamma = [0.0; 3];
            gamma[axis] = sign;
            // At a pole the mark of the pole says more.
            let near = |pole: &Vector| (0..3).all(|k| (pole[k] - gamma[k]).abs() < NEAR);
            if let Some(at) = view.position(gamma).filter(|_| !poles.iter().any(near)) {
                draw(canvas, SphereMark::Axis, at);
                names.take(Rect::around(at, 2.0));
                named.push((at, name.to_owned(), LABEL, FAINT_INK));
            }
        }
    }
    let numbers = numbers.iter().map(|(number, at)| (*at, number.to_string(), NUMBER, INK));
    named.splice(0..0, numbers);
    let mut letters = Vec::new();
    for ((place, equilibrium), aside) in scene.equilibria.iter().enumerate().zip(asides) {
        if equilibrium.multiplicity == Multiplicity::Circle {
            circle(canvas, view, equilibrium.gamma, scene.axis);
        }
        if let Some(mut at) = view.position(equilibrium.gamma) {
            if let Some((rect, leader)) = aside {
                canvas.path(&leader, Ink { color: EQUILIBRIUM, width: 0.9 });
                at = rect.center();
            } else {
                names.take(Rect::around(at, MARK + 1.0));
            }
            draw(canvas, SphereMark::of(equilibrium), at);
            letters.push((at, letter(place), LABEL, EQUILIBRIUM));
        }
    }
    for (at, name, size, color) in letters.into_iter().chain(named) {
        names.write(canvas, at, &name, (size, color), size > LABEL);
    }
}

/// The visible part of the circle on which γ turns about an axis.
fn circle(canvas: &Canvas, view: &SphereView, gamma: Vector, axis: Vector) {
    const STEPS: u32 = 180;
    let step = std::f64::consts::TAU / f64::from(STEPS);
    let places = (0..=STEPS).map(|k| view.position(turned(gamma, axis, step * f64::from(k))));
    let places: Vec<Option<Point>> = places.collect();
    for run in places.split(Option::is_none) {
        let points: Vec<Point> = run.iter().copied().flatten().collect();
        canvas.path(&points, Ink { color: EQUILIBRIUM, width: 1.6 });
    }
}

/// The room of a view.
pub(super) struct Names<'a> {
    pub view: &'a SphereView,
    /// ∂U with the rim, and other levels.
    lines: [Vec<Vec<Point>>; 2],
    taken: Taken,
}

impl<'a> Names<'a> {
    /// A view on a page on which something is taken.
    pub(super) fn new(view: &'a SphereView, lines: [Vec<Vec<Point>>; 2], taken: Taken) -> Self {
        Self { view, lines, taken }
    }

    /// What is taken on the page.
    pub(super) fn into_taken(self) -> Taken {
        self.taken
    }

    /// Keeps names away from a box.
    pub(super) fn take(&mut self, rect: Rect) {
        self.taken.take_box(rect);
    }

    /// Writes a name beside a mark, with a rim of paper; text that is not the name of a mark is inside the view.
    pub(super) fn write(
        &mut self,
        canvas: &Canvas,
        at: Point,
        name: &str,
        (size, color): (f64, RGBColor),
        inside: bool,
    ) {
        let extent = [text_width(name, size), 0.8 * size];
        let outward = if at[0] < self.view.center[0] { -1.0 } else { 1.0 };
        let places = round_point(at, extent, &AWAY, outward).enumerate();
        let costs = places.map(|(order, rect)| (order as f64 + self.cost(&rect.grown(1.5), inside), rect));
        let costs: Vec<(f64, Rect)> = costs.collect();
        let Some(rect) = self.taken.place_anyhow(costs.into_iter(), 1.5) else { return };
        let base = [rect.x, rect.bottom() - 0.03 * size];
        for [dx, dy] in [[-1.0, 0.0], [1.0, 0.0], [0.0, -1.0], [0.0, 1.0]] {
            canvas.text(name, [base[0] + dx, base[1] + dy], size, PAPER, Anchor::Start);
        }
        canvas.text(name, base, size, color, Anchor::Start);
    }

    /// A place beside its point for the mark of an extremum if the mark would hide ∂U round it, and a line to the point; both
    /// are taken. The place keeps off the points of other marks.
    fn aside(&mut self, at: Point, index: u8, fixed: &[Point]) -> Option<(Rect, [Point; 2])> {
        let Self { lines: [boundary, _], taken, .. } = self;
        if index == 1 || !crosses(boundary, &Rect::around(at, MARK)) {
            return None;
        }
        let labelled = Labelled { tips: &[at], lengths: [6.0, 40.0], clearance: 1.5 };
        let places = round_point(at, [2.0 * MARK + 2.0; 2], &[8.0, 13.0, 20.0, 30.0], 1.0);
        let keeps_off = |rect: &Rect| !fixed.iter().any(|other| *other != at && rect.grown(POLE_RING).contains(*other));
        let free = places.filter(|rect| !crosses(boundary, rect) && keeps_off(rect)).map(|rect| (0.0, rect));
        taken.place_with_leader(&labelled, free, |_| 0.0)
    }

    fn cost(&self, rect: &Rect, inside: bool) -> f64 {
        let SphereView { center, radius, .. } = *self.view;
        let leaves = inside && rect.corners().iter().any(|corner| distance(*corner, center) > radius);
        let crossed: f64 =
            self.lines.iter().zip(CROSSED).map(|(lines, cost)| if crosses(lines, rect) { cost } else { 0.0 }).sum();
        if leaves { crossed + OUTSIDE } else { crossed }
    }
}

/// True where one of some lines passes through a box.
fn crosses(lines: &[Vec<Point>], rect: &Rect) -> bool {
    lines.iter().any(|line| line.windows(2).any(|ends| meets(ends[0], ends[1], rect)))
}
