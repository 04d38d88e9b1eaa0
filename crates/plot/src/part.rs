//! The part as it was read: three views of its ellipsoid with pivot, centre of mass and principal axes.

use bifdiag_schema::PartDocument;

use bifdiag_page::{
    Anchor, Canvas, FAINT_INK, INK, Ink, Legend, POLE, Picture, PlotError, Point, Rect, Symbol, Taken, Theme, render,
    rgb, round_point, short_number, text_width,
};

const VIEW: f64 = 250.0;
const MARGIN: f64 = 34.0;
const TEXT: f64 = 12.0;
/// Of the largest moment, less is rounding.
const ROUNDING: f64 = 1e-12;
const OUTLINE: Ink = Ink { color: rgb(0x12_50_a8), width: 1.8 };
const FIXED: Ink = Ink { color: POLE, width: 2.2 };
const MESH: Ink = Ink { color: rgb(0xc8_c8_c8), width: 0.6 };
const AXES: [Ink; 3] = [
    Ink { color: rgb(0x00_7a_5e), width: 1.6 },
    Ink { color: rgb(0x8a_3f_9e), width: 1.6 },
    Ink { color: rgb(0xb0_3a_2e), width: 1.6 },
];
/// The two coordinates of each view, and their names.
const VIEWS: [([usize; 2], [&str; 2]); 3] = [([0, 1], ["x", "y"]), ([0, 2], ["x", "z"]), ([1, 2], ["y", "z"])];

/// What is drawn beside the numbers of the document.
#[derive(Clone, Debug, Default)]
pub struct PartScene {
    /// Edges of a mesh, from the fixed point.
    pub edges: Vec<[[f64; 3]; 2]>,
}

/// The solid ellipsoid with the mass and the tensor of the part: its semi-axes √(5 (I_j + I_k − I_i) / (2 m)) about the
/// centre of mass; 0 where the part cannot exist, and no ellipsoid `fits`.
struct Ellipsoid {
    fits: bool,
    center: [f64; 3],
    axes: [[f64; 3]; 3],
    semi: [f64; 3],
}

impl Ellipsoid {
    fn of(part: &PartDocument) -> Self {
        let mass = value(&part.mass);
        let moments = part.principal_com.moments;
        let second: [f64; 3] = std::array::from_fn(|i| moments[(i + 1) % 3] + moments[(i + 2) % 3] - moments[i]);
        let largest = moments.into_iter().fold(0.0, f64::max);
        let fits = second.into_iter().all(|second| second >= -ROUNDING * largest);
        let semi = second.map(|second| (2.5 * second.max(0.0) / mass).sqrt());
        Self { fits, center: part.com.each_ref().map(|c| value(c)), axes: part.principal_com.axes, semi }
    }

    /// The outline of its projection on two coordinates: c + Σ a_k cos(…) of an orthonormal pair in the plane, from the
    /// projected matrix Σ a_k² v_k v_kᵀ = L Lᵀ.
    fn outline(&self, [i, j]: [usize; 2]) -> Vec<Point> {
        let entry = |p: usize, q: usize| {
            (0..3).map(|k| self.semi[k] * self.semi[k] * self.axes[k][p] * self.axes[k][q]).sum::<f64>()
        };
        let (xx, xy, yy) = (entry(i, i), entry(i, j), entry(j, j));
        let a = xx.max(0.0).sqrt();
        let b = if a > 0.0 { xy / a } else { 0.0 };
        let c = (yy - b * b).max(0.0).sqrt();
        (0..=128)
            .map(|step| {
                let (sin, cos) = libm::sincos(std::f64::consts::TAU * f64::from(step) / 128.0);
                [self.center[i] + a * cos, self.center[j] + b * cos + c * sin]
            })
            .collect()
    }
}

fn value(text: &str) -> f64 {
    // Decimals or p/q.
    match text.split_once('/') {
        Some((p, q)) => value(p) / value(q),
        None => text.parse().unwrap_or(0.0),
    }
}

/// Draws a part: ellipsoid, pivot, centre of mass, principal axes, and the edges of its mesh.
///
/// # Errors
/// [`PlotError`].
pub fn draw_part(part: &PartDocument, scene: &PartScene, theme: Theme) -> Result<Picture, PlotError> {
    let ellipsoid = Ellipsoid::of(part);
    let reach = reach(&ellipsoid, scene);
    let length = part.units.split(',').nth(1).unwrap_or_default().trim();
    let size = [3.0 * VIEW + 4.0 * MARGIN, VIEW + 2.0 * MARGIN + 96.0];
    render(size, "The part as it was read", theme, |canvas| {
        for (k, view) in VIEWS.iter().enumerate() {
            let left = MARGIN + k as f64 * (VIEW + MARGIN);
            draw_view(canvas, [left, MARGIN], *view, &ellipsoid, scene, &reach, length);
        }
        legend(canvas, part, &ellipsoid);
    })
}

/// The middle and the half width of what is drawn.
fn reach(ellipsoid: &Ellipsoid, scene: &PartScene) -> ([f64; 3], f64) {
    let mut low = [0.0_f64; 3];
    let mut high = [0.0_f64; 3];
    let mut hold = |point: [f64; 3]| {
        for i in 0..3 {
            low[i] = low[i].min(point[i]);
            high[i] = high[i].max(point[i]);
        }
    };
    for k in 0..3 {
        for side in [-1.15, 1.15] {
            hold(std::array::from_fn(|i| ellipsoid.center[i] + side * ellipsoid.semi[k] * ellipsoid.axes[k][i]));
        }
    }
    for i in 0..3 {
        let along = |k: usize| ellipsoid.semi[k] * ellipsoid.axes[k][i];
        let half = (0..3).map(|k| along(k) * along(k)).sum::<f64>().sqrt();
        for side in [-1.0, 1.0] {
            let mut point = ellipsoid.center;
            point[i] += side * half;
            hold(point);
        }
    }
    scene.edges.iter().flatten().for_each(|point| hold(*point));
    let middle = std::array::from_fn(|i| 0.5 * (low[i] + high[i]));
    let half = (0..3).map(|i| 0.5 * (high[i] - low[i])).fold(0.0, f64::max);
    // Beyond the ends of axes is room for their numbers.
    (middle, if half > 0.0 { 1.2 * half } else { 1.0 })
}

fn draw_view(
    canvas: &Canvas,
    corner: Point,
    (plane, names): ([usize; 2], [&str; 2]),
    ellipsoid: &Ellipsoid,
    scene: &PartScene,
    (middle, half): &([f64; 3], f64),
    unit: &str,
) {
    let [i, j] = plane;
    let scale = 0.5 * VIEW / half;
    let at = |u: f64, v: f64| {
        [corner[0] + 0.5 * VIEW + scale * (u - middle[i]), corner[1] + 0.5 * VIEW - scale * (v - middle[j])]
    };
    let frame = [[0.0, 0.0], [VIEW, 0.0], [VIEW, VIEW], [0.0, VIEW]].map(|[x, y]| [corner[0] + x, corner[1] + y]);
    for [from, to] in &scene.edges {
        canvas.path(&[at(from[i], from[j]), at(to[i], to[j])], MESH);
    }
    canvas.outline(&frame, Ink { color: FAINT_INK, width: 0.8 });
    let outline: Vec<Point> = ellipsoid.outline(plane).into_iter().map(|[u, v]| at(u, v)).collect();
    canvas.path(&outline, OUTLINE);
    let mut taken = Taken::default();
    outline.windows(2).for_each(|pair| taken.take_line([pair[0], pair[1]]));
    for point in [at(0.0, 0.0), at(ellipsoid.center[i], ellipsoid.center[j])] {
        taken.take_box(Rect::around(point, 6.0));
    }
    let mut axes = Vec::new();
    for k in 0..3 {
        let end = |side: f64| {
            let step = |c: usize| ellipsoid.center[c] + side * ellipsoid.semi[k] * ellipsoid.axes[k][c];
            at(step(i), step(j))
        };
        let ends = [end(1.15), end(-1.15)];
        canvas.path(&ends, AXES[k]);
        taken.take_line(ends);
        axes.push(ends);
    }
    for (k, ends) in axes.iter().enumerate() {
        let name = (k + 1).to_string();
        let rect = beside(ends, [text_width(&name, TEXT), TEXT], &mut taken);
        canvas.text(&name, [rect.x, rect.bottom() - 0.14 * TEXT], TEXT, AXES[k].color, Anchor::Start);
    }
    canvas.disc(at(ellipsoid.center[i], ellipsoid.center[j]), 3.6, INK);
    canvas.ring(at(0.0, 0.0), 4.6, FIXED);
    canvas.text(names[0], [corner[0] + VIEW, corner[1] + VIEW + 16.0], TEXT, INK, Anchor::End);
    canvas.text(names[1], [corner[0] - 6.0, corner[1] + 10.0], TEXT, INK, Anchor::End);
    let width = short_number(2.0 * half, 3);
    canvas.text(&format!("width {width} {unit}"), [corner[0], corner[1] + VIEW + 16.0], TEXT, FAINT_INK, Anchor::Start);
}

/// The nearest free place for a name at one of the ends of an axis; it is taken.
fn beside(ends: &[Point; 2], size: [f64; 2], taken: &mut Taken) -> Rect {
    let places = [3.0, 8.0, 14.0, 22.0]
        .into_iter()
        .flat_map(|away| ends.iter().flat_map(move |end| round_point(*end, size, &[away], 1.0).collect::<Vec<Rect>>()));
    let places = places.enumerate().map(|(order, rect)| (order as f64, rect));
    taken.place_anyhow(places, 0.0).unwrap_or(Rect::around(ends[0], 0.0))
}

/// What the marks are, and below it the moments and semi-axes.
fn legend(canvas: &Canvas, part: &PartDocument, ellipsoid: &Ellipsoid) {
    let top = VIEW + 2.0 * MARGIN + 6.0;
    let fixed = |canvas: &Canvas, at| canvas.ring(at, 4.6, FIXED);
    let center = |canvas: &Canvas, at| canvas.disc(at, 3.6, INK);
    let described = if ellipsoid.fits {
        "solid ellipsoid with this mass and this tensor"
    } else {
        "no ellipsoid has this tensor: drawn without its negative squares of semi-axes"
    };
    let entries = [
        (Symbol::Mark("ring", Box::new(fixed)), "fixed point"),
        (Symbol::Mark("disc", Box::new(center)), "centre of mass"),
        (Symbol::solid(OUTLINE), described),
    ];
    let entries = entries.into_iter().map(|(symbol, text)| (symbol, text.to_owned())).collect();
    Legend::new(entries, 3.0 * VIEW + 2.0 * MARGIN).draw(canvas, [MARGIN, top]);
    let mut units = part.units.split(',');
    let (mass, length) = (units.next().unwrap_or_default(), units.next().unwrap_or_default());
    for k in 0..3 {
        let moment = short_number(part.principal_com.moments[k], 6);
        let semi = short_number(ellipsoid.semi[k], 3);
        let text = format!(
            "axis {}: moment about the centre of mass {moment} {mass} {length}², semi-axis {semi} {length}",
            k + 1
        );
        canvas.text(&text, [MARGIN, top + 36.0 + 18.0 * k as f64], TEXT, AXES[k].color, Anchor::Start);
    }
}
