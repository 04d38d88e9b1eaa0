//! U_hl on the Poisson sphere, seen from two opposite sides: its components, their boundary, level sets of U_l, the poles
//! and the relative equilibria. The picture explains the numbers of boundary circles and poles at a glance.

mod grid;
mod marks;
mod parts;
mod scene;
mod tables;
mod view;

pub use scene::SphereScene;

use bifdiag_page::{
    Anchor, Canvas, FAINT_INK, HEIGHT, Ink, Path, Picture, PlotError, Point, Rect, Taken, Theme, Width, number, render,
    text_width, to_units,
};
use grid::Grid;
use marks::Names;
use parts::Parts;
use scene::{CAPTION_SIZE, Titles};
use tables::{BOUNDARY, FORBIDDEN, LEVEL, tint};
use view::{SphereView, best_direction};

/// Width of the page, and of the sphere: for two views beside each other, and for two below each other.
const WIDTH: [f64; 2] = [860.0, 446.43];
const RADIUS: [f64; 2] = [186.0, 140.0];
const MARGIN: f64 = 34.0;
/// Above the first view, and below each for its caption.
const ABOVE: f64 = 66.0;
const BELOW: f64 = 34.0;
/// Below everything.
const FOOT: f64 = 12.0;
/// Level lines of U, at quantiles of its values on the sphere.
const LEVELS: usize = 14;

const RIM: Ink = Ink { color: FAINT_INK, width: 0.9 };

/// Draws U_hl, the two views beside each other on a page, below each other in a column. Equal scenes give equal bytes.
///
/// # Errors
/// A failure of the drawing library.
pub fn draw_sphere(scene: &SphereScene<'_>, theme: Theme, paper: Width) -> Result<Picture, PlotError> {
    let in_column = paper.is_column();
    let [width, radius] = [WIDTH, RADIUS].map(|sizes| paper.scale() * sizes[usize::from(in_column)]);
    let titles = Titles::new(scene, MARGIN, width - 2.0 * MARGIN);
    let middle = ABOVE + titles.more + radius;
    let centers = if in_column {
        [[width / 2.0, middle], [width / 2.0, middle + 2.0 * radius + BELOW + 26.0]]
    } else {
        [[MARGIN + radius, middle], [width - MARGIN - radius, middle]]
    };
    let direction = scene.view.unwrap_or_else(|| best_direction(scene.r_hat, scene.potential_above, &marked(scene)));
    let views = SphereView::pair(direction, scene.r_hat, centers, radius);
    let grids = views.each_ref().map(|view| Grid::new(view, scene.potential_above));
    let parts = Parts::new(&grids, scene.component_of);
    let largest = scene.equilibria.iter().map(|equilibrium| equilibrium.h.abs()).fold(0.0, f64::max);
    let levels = levels(&grids, largest);
    let legend = tables::legend(scene, !levels.is_empty(), width - 2.0 * MARGIN);
    let below = centers[1][1] + radius + BELOW;
    let equilibria_at = [MARGIN, below + legend.height() + 8.0];
    let equilibria = tables::equilibria(scene, [paper.pixels() - 2.0 * MARGIN, HEIGHT - equilibria_at[1] - FOOT]);
    let height = equilibria_at[1] + equilibria.height() + FOOT;
    let size = [width.max(equilibria.width() + 2.0 * MARGIN), height.ceil()];
    let title = format!("{}; {}", scene.title, scene.caption);
    render(size, title.as_str(), theme, |canvas| {
        for (view, grid) in grids.iter().enumerate() {
            ground(canvas, &views[view], grid, |node| parts.component(view, node), scene.components.len());
            shade(canvas, &views[view], view);
            lines(canvas, &views[view], grid, &levels);
        }
        let mut taken = Taken::default();
        titles.boxes().for_each(|area| taken.take_box(area));
        for (place, view) in views.iter().enumerate() {
            let grid = &grids[place];
            let drawn = |levels: &[f64]| levels.iter().flat_map(|level| grid.level_lines(*level)).collect::<Vec<_>>();
            let mut heavy = drawn(&[0.0]);
            heavy.push(outline(view));
            let mut names = Names::new(view, [heavy, drawn(&levels)], taken);
            let caption = seen_from(view);
            let at = [view.center[0], view.center[1] + radius + 20.0];
            canvas.text(&caption, at, CAPTION_SIZE, FAINT_INK, Anchor::Middle);
            let half = text_width(&caption, CAPTION_SIZE) / 2.0;
            names.take(Rect {
                x: at[0] - half,
                y: at[1] - CAPTION_SIZE,
                width: 2.0 * half,
                height: 1.3 * CAPTION_SIZE,
            });
            // On a curve the components are not known.
            let are_told = !scene.components.is_empty();
            let own = parts.deepest.iter().filter(|(_, (view, _))| are_told && *view == place);
            let numbers = own.map(|&(component, (_, node))| (component + 1, grid.place(node)));
            marks::draw_all(canvas, scene, &mut names, &numbers.collect::<Vec<_>>());
            taken = names.into_taken();
        }
        titles.draw(canvas);
        legend.draw(canvas, [MARGIN, below]);
        equilibria.draw(canvas, equilibria_at);
    })
}

/// Levels other than h that cut the sphere into parts of about equal area, as differences from h; none where U is
/// constant up to the rounding of values as large as `largest`.
fn levels(grids: &[Grid<'_>; 2], largest: f64) -> Vec<f64> {
    const ROUNDING: f64 = 1e-14;
    let mut values: Vec<f64> = grids.iter().flat_map(|grid| grid.values().iter().copied()).collect();
    values.sort_by(f64::total_cmp);
    let [least, most] = [values[0], values[values.len() - 1]];
    if most - least <= ROUNDING * largest {
        return Vec::new();
    }
    (1..=LEVELS).map(|k| values[values.len() * k / (LEVELS + 1)]).filter(|level| *level != 0.0).collect()
}

/// The disc in the colour of what is not accessible, and the components over it.
fn ground(
    canvas: &Canvas,
    view: &SphereView,
    grid: &Grid<'_>,
    component: impl Fn(grid::Node) -> Option<usize>,
    components: usize,
) {
    canvas.draw(&rim(view), &canvas.fill(FORBIDDEN));
    // On a curve the components are not known: everything accessible has one tint.
    for place in 0..components.max(1) {
        let color = canvas.ground(tint(place));
        // A hair of the same colour closes the seams between cells.
        let attributes = format!("fill=\"{color}\" stroke=\"{color}\" stroke-width=\"4\"");
        canvas.draw(&grid.area(0.0, |node| component(node) == Some(place)), &attributes);
    }
}

/// The poles and the relative equilibria.
fn marked(scene: &SphereScene<'_>) -> Vec<[f64; 3]> {
    let poles = scene.r_hat.into_iter().flat_map(|r| [r, r.map(|c| -c)]);
    poles.chain(scene.equilibria.iter().map(|point| point.gamma)).collect()
}

/// Light from the upper left and a darker rim, so that the disc is seen as a sphere; too weak to make one tint another.
fn shade(canvas: &Canvas, view: &SphereView, number: usize) {
    const STOPS: [(f64, &str, f64); 4] =
        [(0.0, "fff", 0.45), (0.55, "fff", 0.0), (0.56, "000", 0.0), (1.0, "000", 0.22)];
    let [x, y] = view.center.map(to_units);
    let [radius, aside] = [1.0, 0.36].map(|share| to_units(share * view.radius));
    let stop =
        |(at, color, opacity)| format!("<stop offset=\"{at}\" stop-color=\"#{color}\" stop-opacity=\"{opacity}\"/>");
    canvas.element(&format!(
        "<defs><radialGradient id=\"shade-{number}\" gradientUnits=\"userSpaceOnUse\" cx=\"{x}\" cy=\"{y}\" r=\"{radius}\" \
         fx=\"{}\" fy=\"{}\">{}</radialGradient></defs>",
        x - aside,
        y - aside,
        STOPS.map(stop).concat()
    ));
    canvas.draw(&rim(view), &format!("fill=\"url(#shade-{number})\""));
}

/// Level lines, ∂U and the rim.
fn lines(canvas: &Canvas, view: &SphereView, grid: &Grid<'_>, levels: &[f64]) {
    let drawn = |levels: &[f64]| {
        let mut path = Path::default();
        for line in levels.iter().flat_map(|level| grid.level_lines(*level)) {
            path.line(&line, false);
        }
        path
    };
    canvas.draw(&drawn(levels), &canvas.stroke(LEVEL));
    canvas.draw(&drawn(&[0.0]), &canvas.stroke(BOUNDARY));
    canvas.draw(&rim(view), &canvas.stroke(RIM));
}

/// The outline of the sphere.
fn rim(view: &SphereView) -> Path {
    let mut path = Path::default();
    path.line(&outline(view), true);
    path
}

fn outline(view: &SphereView) -> Vec<Point> {
    let steps = (0..grid::SPOKES).map(|k| std::f64::consts::TAU * k as f64 / grid::SPOKES as f64);
    steps.map(|phi| view.place(std::f64::consts::FRAC_PI_2, phi)).collect()
}

/// The middle of a view, in words.
fn seen_from(view: &SphereView) -> String {
    let [x, y, z] = view.gamma(0.0, 0.0).map(|c| number((100.0 * c).round() / 100.0 + 0.0));
    format!("seen from γ = ({x}, {y}, {z})")
}
