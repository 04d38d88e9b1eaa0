//! A motion that moves: the turning body with the trace of its axis, beside the section that fills, as one SVG without
//! scripts.

use std::f64::consts::{PI, TAU};
use std::fmt::Write;

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
    /// Principal moments of inertia.
    pub moments: [f64; 3],
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
    /// How long it plays, in seconds; then it begins anew.
    pub seconds: f64,
}

/// Half the width of the view of the body.
const RADIUS: f64 = 150.0;
/// Points of each circle on the body.
const CIRCLE: usize = 36;
/// Of so many points of the trace one tells how much of it is seen.
const TOLD: usize = 8;
/// A sheet of the section: its width, ψ′ ∈ [0, 2π], and its height, ϑ′ ∈ [0, π].
const SHEET: [f64; 2] = [300.0, 150.0];
const LEFT: f64 = 380.0;
const TOPS: [f64; 2] = [50.0, 250.0];

/// From space to the picture: seen from a little above the horizon, the third axis downwards.
fn seen([x, y, z]: [f64; 3]) -> [f64; 2] {
    // An azimuth of 30° and an elevation of atan(3/4)/2 or so, as rational directions.
    const AZIMUTH: [f64; 2] = [0.866_025_403_784_438_6, 0.5];
    const ELEVATION: [f64; 2] = [0.96, 0.28];
    let across = AZIMUTH[0] * x + AZIMUTH[1] * y;
    let away = AZIMUTH[0] * y - AZIMUTH[1] * x;
    [190.0 + RADIUS * across, 220.0 + RADIUS * (ELEVATION[0] * z - ELEVATION[1] * away)]
}

/// A vector of the body in space.
fn turned(frame: &[[f64; 3]; 3], v: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|i| (0..3).map(|k| frame[k][i] * v[k]).sum())
}

fn path(points: impl Iterator<Item = [f64; 2]>, closed: bool) -> String {
    let mut d = String::new();
    for (k, [x, y]) in points.enumerate() {
        let _infallible = write!(d, "{}{x:.1} {y:.1}", if k == 0 { "M" } else { " L" });
    }
    if closed { d + "Z" } else { d }
}

/// The animation as SVG (SMIL), the same bytes for the same scene.
#[must_use]
pub fn draw_animation(scene: &AnimationScene) -> String {
    let mut out = String::new();
    let width = if scene.crossings.is_some() { 720 } else { 380 };
    let title = escaped(scene.title);
    let _infallible = write!(
        out,
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} 440\" font-family=\"sans-serif\" font-size=\"13\">\n\
         <title>{title}</title>\n<rect width=\"{width}\" height=\"440\" fill=\"#ffffff\"/>\n\
         <text x=\"20\" y=\"24\">{title}</text>\n"
    );
    body(scene, &mut out);
    if let Some(crossings) = scene.crossings {
        section(scene, crossings, &mut out);
    }
    out.push_str("</svg>\n");
    out
}

fn repeat(scene: &AnimationScene) -> String {
    format!("dur=\"{}s\" repeatCount=\"indefinite\"", scene.seconds)
}

/// A path that moves from frame to frame.
fn moving(scene: &AnimationScene, style: &str, closed: bool, points: &[[f64; 3]], out: &mut String) {
    let values: Vec<String> =
        scene.frames.iter().map(|frame| path(points.iter().map(|point| seen(turned(frame, *point))), closed)).collect();
    let first = values.first().map_or("", String::as_str);
    let _infallible = writeln!(
        out,
        "<path d=\"{first}\" fill=\"none\" {style}><animate attributeName=\"d\" values=\"{}\" {}/></path>",
        values.join(";"),
        repeat(scene)
    );
}

fn body(scene: &AnimationScene, out: &mut String) {
    let [x, y] = seen([0.0; 3]);
    let _infallible = writeln!(
        out,
        "<g id=\"body\"><title>the body in space, gravity downwards</title>\n\
         <circle cx=\"{x}\" cy=\"{y}\" r=\"{RADIUS}\" fill=\"#f6f6f2\" stroke=\"#b0b0a8\"/>"
    );
    // The ellipsoid ⟨x, Ax⟩ = const, its longest half-axis 0.7.
    let least = scene.moments.iter().fold(f64::INFINITY, |least, a| least.min(*a));
    let half: [f64; 3] = std::array::from_fn(|k| 0.7 * (least / scene.moments[k]).sqrt());
    for (k, color) in ["#0072b2", "#009e73", "#8a5a00"].into_iter().enumerate() {
        let (p, q) = ((k + 1) % 3, (k + 2) % 3);
        let circle: Vec<[f64; 3]> = (0..CIRCLE)
            .map(|n| {
                let (sin, cos) = libm::sincos(TAU * n as f64 / CIRCLE as f64);
                let mut point = [0.0; 3];
                (point[p], point[q]) = (half[p] * cos, half[q] * sin);
                point
            })
            .collect();
        moving(scene, &format!("stroke=\"{color}\" stroke-width=\"1.2\""), true, &circle, out);
    }
    trace(scene, out);
    moving(
        scene,
        "stroke=\"#d55e00\" stroke-width=\"3\" stroke-linecap=\"round\"",
        false,
        &[[0.0; 3], scene.axis],
        out,
    );
    let _infallible = writeln!(
        out,
        "<path d=\"M350 330v60m-4 -8l4 8l4 -8\" fill=\"none\" stroke=\"#606060\"/><text x=\"330\" y=\"408\">gravity</text>\n\
         <text x=\"20\" y=\"425\" fill=\"#a04600\">axis to the centre of mass, and its trace</text></g>"
    );
}

/// The tip of the axis so far.
fn trace(scene: &AnimationScene, out: &mut String) {
    let tips: Vec<[f64; 2]> = scene.trace.iter().map(|tip| seen(*tip)).collect();
    let mut lengths = vec![0.0];
    for pair in tips.windows(2) {
        let [dx, dy] = [pair[1][0] - pair[0][0], pair[1][1] - pair[0][1]];
        lengths.push(lengths[lengths.len() - 1] + (dx * dx + dy * dy).sqrt());
    }
    let whole = lengths[lengths.len() - 1].max(f64::MIN_POSITIVE);
    let offsets: Vec<String> =
        lengths.iter().step_by(TOLD).map(|length| format!("{:.4}", 1.0 - length / whole)).collect();
    let _infallible = writeln!(
        out,
        "<path d=\"{}\" fill=\"none\" stroke=\"#d55e00\" stroke-width=\"0.8\" pathLength=\"1\" stroke-dasharray=\"1\">\
         <animate attributeName=\"stroke-dashoffset\" values=\"{}\" {}/></path>",
        path(tips.into_iter(), false),
        offsets.join(";"),
        repeat(scene)
    );
}

fn section(scene: &AnimationScene, crossings: &[AnimatedCrossing], out: &mut String) {
    let place = |sheet: usize, psi: f64, theta: f64| [LEFT + SHEET[0] * psi / TAU, TOPS[sheet] + SHEET[1] * theta / PI];
    for (sheet, name) in ["T⁻", "T⁺"].into_iter().enumerate() {
        let top = TOPS[sheet];
        let [width, height] = SHEET;
        let area: String = scene
            .accessible
            .iter()
            .map(|points| path(points.iter().map(|[psi, theta]| place(sheet, *psi, *theta)), true))
            .collect();
        let _infallible = writeln!(
            out,
            "<g id=\"sheet{sheet}\"><title>{name}</title><path d=\"{area}\" fill=\"#eceae2\" fill-rule=\"evenodd\"/>\
             <rect x=\"{LEFT}\" y=\"{top}\" width=\"{width}\" height=\"{height}\" fill=\"none\" stroke=\"#707070\"/>\
             <text x=\"{}\" y=\"{}\">{name}</text>",
            LEFT + width + 8.0,
            top + 14.0,
        );
        for crossing in crossings.iter().filter(|crossing| usize::from(crossing.sheet > 0) == sheet) {
            let [x, y] = place(sheet, crossing.psi, crossing.theta);
            let _infallible = writeln!(
                out,
                "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"2\" fill=\"#0072b2\"><animate attributeName=\"opacity\" \
                 values=\"0;1\" keyTimes=\"0;{:.5}\" calcMode=\"discrete\" {}/></circle>",
                crossing.at.clamp(1e-5, 1.0),
                repeat(scene)
            );
        }
        out.push_str("</g>\n");
    }
    let _infallible =
        writeln!(out, "<text x=\"{LEFT}\" y=\"425\">section d⟨γ,r⟩/dt = 0: ψ′ to the right, ϑ′ down</text>");
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scene<'a>(frames: &'a [[[f64; 3]; 3]], crossings: Option<&'a [AnimatedCrossing]>) -> AnimationScene<'a> {
        AnimationScene {
            frames,
            moments: [2.0, 1.5, 1.0],
            axis: [0.0, 0.0, 1.0],
            trace: &[[0.0, 0.0, 1.0], [0.0, 0.6, 0.8]],
            crossings,
            accessible: &[],
            title: "A < B & C",
            seconds: 10.0,
        }
    }

    #[test]
    fn frames_and_crossings_are_all_there_and_the_text_is_xml() {
        let one = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let other = [[0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, 1.0]];
        let crossings = [AnimatedCrossing { at: 0.5, sheet: 1, theta: 1.0, psi: 2.0 }; 3];
        let svg = draw_animation(&scene(&[one, other, one], Some(&crossings)));
        assert_eq!(svg.matches("<circle cx").count(), 1 + 3);
        assert_eq!(svg.matches("attributeName=\"d\"").count(), 4);
        assert!(svg.contains("A &lt; B &amp; C") && svg.contains("keyTimes=\"0;0.50000\""));
        assert_eq!(svg, draw_animation(&scene(&[one, other, one], Some(&crossings))));
        assert!(!draw_animation(&scene(&[one], None)).contains("sheet0"));
    }

    #[test]
    fn the_third_axis_of_space_points_down() {
        let ([x, y], [down_x, down_y]) = (seen([0.0; 3]), seen([0.0, 0.0, 1.0]));
        assert!((x - down_x).abs() < 1e-12 && down_y > y + 100.0);
    }
}
