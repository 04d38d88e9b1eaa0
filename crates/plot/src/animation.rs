//! An animated motion: the turning body with the trace of its axis and a clock, next to the section as it fills, as one
//! SVG without scripts; or a single frame of it.

use std::f64::consts::{PI, TAU};

use bifdiag_page::{
    Anchor, CHART_TEXT, Canvas, FAINT_INK, INK, Ink, Path, Picture, PlotError, Point, Rect, Theme, lines, render, rgb,
    rgbs, ticks, to_units,
};
use plotters::style::RGBColor;

/// A crossing of the section.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AnimatedCrossing {
    /// Its part of the time, in [0, 1].
    pub at: f64,
    /// ±1.
    pub sheet: i8,
    /// ϑ′.
    pub theta: f64,
    /// ψ′.
    pub psi: f64,
}

/// What is shown.
#[derive(Clone, Copy, Debug)]
pub struct AnimationScene<'a> {
    /// For each frame the principal axes in space, where the third axis points along γ: downwards.
    pub frames: &'a [[[f64; 3]; 3]],
    /// The times of the first frame and the last.
    pub times: [f64; 2],
    /// What a time is in, or nothing.
    pub unit: &'a str,
    /// Principal moments of inertia.
    pub moments: [f64; 3],
    /// The edges of the body in its principal axes, from the fixed point; without them its ellipsoid of inertia is drawn.
    pub edges: &'a [[[f64; 3]; 2]],
    /// The axis whose trace is drawn, in the body: r̂.
    pub axis: [f64; 3],
    /// Its tip in space at equal times, the first and the last those of the frames.
    pub trace: &'a [[f64; 3]],
    /// Crossings in the order of time; `None` where the body has no section.
    pub crossings: Option<&'a [AnimatedCrossing]>,
    /// Outlines of the accessible area on T⁻ and T⁺, as loops of (ψ′, ϑ′).
    pub accessible: &'a [Vec<[f64; 2]>],
    /// What it is, in words.
    pub title: &'a str,
    /// Duration in seconds; then it repeats.
    pub seconds: f64,
}

/// Half the width of the view of the body, and its middle.
const RADIUS: f64 = 150.0;
const MIDDLE: Point = [190.0, 236.0];
/// Points of each circle on the body.
const CIRCLE: usize = 36;
/// Distance of the farthest point of the body from the fixed point.
const REACH: f64 = 0.86;
/// One of this many points of the trace is a key frame for its visible length.
const PER_KEY_FRAME: usize = 8;
/// A sheet of the section: its width, ψ′ ∈ [0, 2π], and its height, ϑ′ ∈ [0, π].
const SHEET: [f64; 2] = [300.0, 150.0];
const LEFT: f64 = 400.0;
const TOPS: [f64; 2] = [84.0, 276.0];
/// Widths of the page with a section and without, and its height.
const WIDTHS: [f64; 2] = [730.0, 380.0];
const HEIGHT: f64 = 512.0;
/// The line of the clock and its margin.
const CLOCK: f64 = 470.0;
const MARGIN: f64 = 24.0;
const TITLE: f64 = 13.0;
/// The principal axes, and that whose trace is drawn.
const AXES: [RGBColor; 3] = rgbs([0x00_72_b2, 0x00_9e_73, 0x8a_5a_00]);
const TRACED: RGBColor = rgb(0xd5_5e_00);
const MESH: Ink = Ink { color: rgb(0x70_78_80), width: 0.7 };

/// From space to the picture: seen from a little above the horizon, the third axis downwards.
fn seen([x, y, z]: [f64; 3]) -> Point {
    // An azimuth of 30° and an elevation of atan(3/4)/2 or so, as rational directions.
    const AZIMUTH: [f64; 2] = [0.866_025_403_784_438_6, 0.5];
    const ELEVATION: [f64; 2] = [0.96, 0.28];
    let across = AZIMUTH[0] * x + AZIMUTH[1] * y;
    let away = AZIMUTH[0] * y - AZIMUTH[1] * x;
    [MIDDLE[0] + RADIUS * across, MIDDLE[1] + RADIUS * (ELEVATION[0] * z - ELEVATION[1] * away)]
}

/// A vector of the body in space.
fn turned(frame: &[[f64; 3]; 3], v: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|i| (0..3).map(|k| frame[k][i] * v[k]).sum())
}

/// The animation as SVG (SMIL). Equal scenes give equal bytes.
///
/// # Errors
/// [`PlotError`].
pub fn draw_animation(scene: &AnimationScene) -> Result<Picture, PlotError> {
    draw(scene, None)
}

/// One frame of the animation.
///
/// # Errors
/// [`PlotError`].
pub fn draw_frame(scene: &AnimationScene, frame: usize) -> Result<Picture, PlotError> {
    draw(scene, Some(frame))
}

fn draw(scene: &AnimationScene, frame: Option<usize>) -> Result<Picture, PlotError> {
    let width = WIDTHS[usize::from(scene.crossings.is_none())];
    render([width, HEIGHT], scene.title, Theme::Light, |canvas| {
        let stage = Stage { scene, frame, canvas };
        for (number, line) in lines(scene.title, TITLE, width - 2.0 * MARGIN).iter().enumerate() {
            canvas.text(line, [MARGIN, 24.0 + 17.0 * number as f64], TITLE, INK, Anchor::Start);
        }
        stage.body();
        if let Some(crossings) = scene.crossings {
            stage.section(crossings);
        }
        stage.clock(width);
    })
}

/// What is drawn on, and which frame; all of them where none is given.
struct Stage<'a> {
    scene: &'a AnimationScene<'a>,
    frame: Option<usize>,
    canvas: &'a Canvas,
}

impl Stage<'_> {
    /// The values of an attribute in the frames that are shown.
    fn values(&self, value: impl Fn(usize) -> String) -> Vec<String> {
        let frames = match self.frame {
            Some(frame) => frame..frame + 1,
            None => 0..self.scene.frames.len(),
        };
        frames.map(value).collect()
    }

    /// What an attribute is first, and how it moves.
    fn animated(&self, attribute: &str, values: &[String]) -> (String, String) {
        let first = values.first().cloned().unwrap_or_default();
        let moves = match values {
            [] | [_] => String::new(),
            _ => format!("<animate attributeName=\"{attribute}\" values=\"{}\" {}/>", values.join(";"), self.repeat()),
        };
        (first, moves)
    }

    fn repeat(&self) -> String {
        format!("dur=\"{}s\" repeatCount=\"indefinite\"", self.scene.seconds)
    }

    /// Lines of the body.
    fn moving(&self, ink: Ink, closed: bool, lines: &[Vec<[f64; 3]>]) {
        let at = |k: usize| {
            let mut path = Path::default();
            for line in lines {
                let points: Vec<Point> = line.iter().map(|point| seen(turned(&self.scene.frames[k], *point))).collect();
                path.line(&points, closed);
            }
            path.data().to_owned()
        };
        let (first, moves) = self.animated("d", &self.values(at));
        self.canvas.element(&format!(
            "<path d=\"{first}\" {} stroke-linecap=\"round\">{moves}</path>",
            self.canvas.stroke(ink)
        ));
    }

    fn body(&self) {
        let Self { scene, canvas, .. } = self;
        canvas.group("body", "the body in space, gravity downwards", || {
            canvas.ring(MIDDLE, RADIUS, Ink { color: rgb(0xb0_b0_a8), width: 1.0 });
            let farthest = scene.edges.iter().flatten().map(|p| p.iter().map(|x| x * x).sum::<f64>().sqrt());
            let farthest = farthest.fold(0.0, f64::max);
            if farthest > 0.0 {
                let scaled = |ends: &[[f64; 3]; 2]| ends.map(|end| end.map(|x| REACH * x / farthest)).to_vec();
                self.moving(MESH, false, &scene.edges.iter().map(scaled).collect::<Vec<_>>());
            } else {
                self.ellipsoid();
            }
            self.trace();
            self.moving(Ink { color: TRACED, width: 3.0 }, false, &[vec![[0.0; 3], scene.axis]]);
            for (axis, name) in ["e₁", "e₂", "e₃"].into_iter().enumerate() {
                let end = |length: f64| std::array::from_fn(|k| if k == axis { length } else { 0.0 });
                self.moving(Ink { color: AXES[axis], width: 0.8 }, false, &[vec![[0.0; 3], end(0.9)]]);
                self.label(name, AXES[axis], end(1.0));
            }
            let arrow = [[352.0, 352.0], [352.0, 392.0]];
            canvas.path(&arrow, Ink { color: FAINT_INK, width: 1.0 });
            canvas.path(&[[348.0, 384.0], arrow[1], [356.0, 384.0]], Ink { color: FAINT_INK, width: 1.0 });
            canvas.text("gravity", [352.0, 408.0], CHART_TEXT, FAINT_INK, Anchor::Middle);
            let words = "thick: the axis to the centre of mass, and its trace";
            canvas.text(words, [MARGIN, 428.0], CHART_TEXT, TRACED, Anchor::Start);
        });
    }

    /// The ellipsoid ⟨x, Ax⟩ = const by its three principal sections.
    fn ellipsoid(&self) {
        let moments = self.scene.moments;
        let least = moments.iter().fold(f64::INFINITY, |least, a| least.min(*a));
        let half: [f64; 3] = std::array::from_fn(|k| 0.7 * (least / moments[k]).sqrt());
        for (k, color) in AXES.into_iter().enumerate() {
            let (p, q) = ((k + 1) % 3, (k + 2) % 3);
            let circle = (0..CIRCLE).map(|n| {
                let (sin, cos) = libm::sincos(TAU * n as f64 / CIRCLE as f64);
                let mut point = [0.0; 3];
                (point[p], point[q]) = (half[p] * cos, half[q] * sin);
                point
            });
            self.moving(Ink { color, width: 1.2 }, true, &[circle.collect()]);
        }
    }

    /// A name that moves with a point of the body.
    fn label(&self, name: &str, color: RGBColor, point: [f64; 3]) {
        let at = |k: usize| seen(turned(&self.scene.frames[k], point)).map(to_units);
        let places = self.values(|k| {
            let [x, y] = at(k);
            format!("{x} {}", y + to_units(0.36 * CHART_TEXT))
        });
        let (first, moves) = match &places[..] {
            [only] => (only.clone(), String::new()),
            all => (
                "0 0".to_owned(),
                format!(
                    "<animateTransform attributeName=\"transform\" type=\"translate\" values=\"{}\" {}/>",
                    all.join(";"),
                    self.repeat()
                ),
            ),
        };
        self.canvas.element(&format!("<g transform=\"translate({first})\">{moves}"));
        self.canvas.text(name, [0.0, 0.0], CHART_TEXT, color, Anchor::Middle);
        self.canvas.element("</g>");
    }

    /// The share of the time that has passed in a frame.
    fn share(&self, frame: usize) -> f64 {
        frame as f64 / (self.scene.frames.len() - 1).max(1) as f64
    }

    /// The tip of the axis so far.
    fn trace(&self) {
        let Self { scene, canvas, frame } = self;
        let tips: Vec<Point> = scene.trace.iter().map(|tip| seen(*tip)).collect();
        let ink = Ink { color: TRACED, width: 0.8 };
        if let Some(frame) = frame {
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a share of the points")]
            let until = (self.share(*frame) * (tips.len() - 1) as f64).round() as usize;
            canvas.path(&tips[..=until], ink);
            return;
        }
        let mut lengths = vec![0.0];
        for pair in tips.windows(2) {
            let [dx, dy] = [pair[1][0] - pair[0][0], pair[1][1] - pair[0][1]];
            lengths.push(lengths[lengths.len() - 1] + (dx * dx + dy * dy).sqrt());
        }
        let whole = lengths[lengths.len() - 1].max(f64::MIN_POSITIVE);
        let offsets: Vec<String> =
            lengths.iter().step_by(PER_KEY_FRAME).map(|length| format!("{:.4}", 1.0 - length / whole)).collect();
        let mut path = Path::default();
        path.line(&tips, false);
        canvas.element(&format!(
            "<path d=\"{}\" {} pathLength=\"1\" stroke-dasharray=\"1\">\
             <animate attributeName=\"stroke-dashoffset\" values=\"{}\" {}/></path>",
            path.data(),
            canvas.stroke(ink),
            offsets.join(";"),
            self.repeat()
        ));
    }

    fn section(&self, crossings: &[AnimatedCrossing]) {
        let canvas = self.canvas;
        for (sheet, name) in ["T⁻", "T⁺"].into_iter().enumerate() {
            let rect = Rect { x: LEFT, y: TOPS[sheet], width: SHEET[0], height: SHEET[1] };
            let place = |[psi, theta]: [f64; 2]| [rect.x + rect.width * psi / TAU, rect.y + rect.height * theta / PI];
            canvas.group(&format!("sheet{sheet}"), name, || {
                let mut area = Path::default();
                for points in self.scene.accessible {
                    area.line(&points.iter().copied().map(place).collect::<Vec<_>>(), true);
                }
                canvas.draw(&area, &format!("{} fill-rule=\"evenodd\"", canvas.fill(rgb(0xec_ea_e2))));
                canvas.outline(&rect.corners(), Ink { color: FAINT_INK, width: 0.9 });
                canvas.text(name, [rect.x, rect.y - 8.0], CHART_TEXT, INK, Anchor::Start);
                for (value, label) in [(0.0, "0"), (PI, "π"), (TAU, "2π")] {
                    canvas.text(
                        label,
                        [place([value, PI])[0], rect.bottom() + 15.0],
                        CHART_TEXT - 1.0,
                        INK,
                        Anchor::Middle,
                    );
                }
                canvas.text("ψ′", [rect.x + 0.75 * rect.width, rect.bottom() + 15.0], CHART_TEXT, INK, Anchor::Middle);
                canvas.text("ϑ′", [rect.x - 8.0, rect.center()[1] + 4.0], CHART_TEXT, INK, Anchor::End);
                for crossing in crossings.iter().filter(|crossing| usize::from(crossing.sheet > 0) == sheet) {
                    self.crossing(place([crossing.psi, crossing.theta]), crossing.at.clamp(1e-5, 1.0));
                }
            });
        }
        let words = "the section: height of the centre of mass extremal";
        canvas.text(words, [LEFT, TOPS[0] - 26.0], CHART_TEXT, FAINT_INK, Anchor::Start);
    }

    /// A crossing from its time on.
    fn crossing(&self, at: Point, from: f64) {
        let appears = match self.frame {
            Some(frame) if self.share(frame) < from => return,
            Some(_) => String::new(),
            None => format!(
                "<animate attributeName=\"opacity\" values=\"0;1\" keyTimes=\"0;{from:.5}\" calcMode=\"discrete\" {}/>",
                self.repeat()
            ),
        };
        let ([x, y], fill) = (at.map(to_units), self.canvas.fill(AXES[0]));
        self.canvas.element(&format!("<circle cx=\"{x}\" cy=\"{y}\" r=\"20\" {fill}>{appears}</circle>"));
    }

    /// The time: a mark that moves along its axis.
    fn clock(&self, width: f64) {
        let Self { scene, canvas, .. } = self;
        let [from, to] = scene.times;
        let name = if scene.unit.is_empty() { "time".to_owned() } else { format!("time in {}", scene.unit) };
        let [left, right] = [MARGIN + 8.0, width - MARGIN - 8.0];
        let across = |share: f64| left + share * (right - left);
        canvas.group("clock", "the time", || {
            canvas.path(&[[left, CLOCK], [right, CLOCK]], Ink { color: INK, width: 0.9 });
            let ticks = ticks(&name, from, to, 8);
            for (value, label) in ticks.values.iter().zip(&ticks.labels) {
                let x = across((value - from) / (to - from));
                canvas.path(&[[x, CLOCK], [x, CLOCK + 4.0]], Ink { color: INK, width: 0.9 });
                canvas.text(label, [x, CLOCK + 17.0], CHART_TEXT - 1.0, INK, Anchor::Middle);
            }
            canvas.text(&ticks.quantity, [width / 2.0, CLOCK + 34.0], CHART_TEXT, INK, Anchor::Middle);
            let places = self.values(|k| to_units(across(self.share(k))).to_string());
            // Uniform motion: the first and the last position suffice.
            let ends = match &places[..] {
                [first, .., last] => vec![first.clone(), last.clone()],
                _ => places,
            };
            let (first, moves) = self.animated("cx", &ends);
            let (y, fill) = (to_units(CLOCK), canvas.fill(TRACED));
            canvas.element(&format!("<circle cx=\"{first}\" cy=\"{y}\" r=\"50\" {fill}>{moves}</circle>"));
        });
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const FRAMES: [[[f64; 3]; 3]; 3] = [
        [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        [[0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, 1.0]],
        [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
    ];

    fn scene(crossings: Option<&[AnimatedCrossing]>) -> AnimationScene<'_> {
        AnimationScene {
            frames: &FRAMES,
            times: [0.0, 20.0],
            unit: "s",
            moments: [2.0, 1.5, 1.0],
            edges: &[],
            axis: [0.0, 0.0, 1.0],
            trace: &[[0.0, 0.0, 1.0], [0.0, 0.6, 0.8], [0.0, 0.0, 1.0]],
            crossings,
            accessible: &[],
            title: "A < B & C",
            seconds: 10.0,
        }
    }

    #[test]
    fn frames_and_crossings_are_all_there_and_the_text_is_xml() {
        let crossings = [AnimatedCrossing { at: 0.5, sheet: 1, theta: 1.0, psi: 2.0 }; 3];
        let svg = draw_animation(&scene(Some(&crossings))).unwrap().svg;
        assert_eq!(svg.matches("attributeName=\"opacity\"").count(), 3);
        // Three sections of the ellipsoid, r̂ and three axes.
        assert_eq!(svg.matches("attributeName=\"d\"").count(), 7);
        assert!(
            svg.contains("A &lt; B &amp; C") && svg.contains("keyTimes=\"0;0.50000\"") && svg.contains("time in s")
        );
        assert_eq!(svg, draw_animation(&scene(Some(&crossings))).unwrap().svg);
        assert!(!draw_animation(&scene(None)).unwrap().svg.contains("sheet0"));
    }

    #[test]
    fn a_frame_shows_what_was_until_then() {
        let crossings = [0.2, 0.5, 0.9].map(|at| AnimatedCrossing { at, sheet: 1, theta: 1.0, psi: 2.0 });
        let marks = |frame: usize| draw_frame(&scene(Some(&crossings)), frame).unwrap().svg.matches("r=\"20\"").count();
        assert_eq!([0, 1, 2].map(marks), [0, 2, 3]);
        assert!(!draw_frame(&scene(None), 1).unwrap().svg.contains("animate"));
    }

    #[test]
    fn a_body_of_edges_is_drawn_by_them() {
        let edges = [[[0.0, 0.0, 0.0], [0.0, 0.0, 40.0]], [[0.0, 0.0, 40.0], [10.0, 0.0, 20.0]]];
        let svg = draw_animation(&AnimationScene { edges: &edges, ..scene(None) }).unwrap().svg;
        assert_eq!(svg.matches("attributeName=\"d\"").count(), 5);
    }

    #[test]
    fn the_third_axis_of_space_points_down() {
        let ([x, y], [down_x, down_y]) = (seen([0.0; 3]), seen([0.0, 0.0, 1.0]));
        assert!((x - down_x).abs() < 1e-12 && down_y > y + 100.0);
    }
}
