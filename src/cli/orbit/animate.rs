//! The motion as a moving picture.

use std::path::Path;
use std::sync::atomic::AtomicBool;

use bifdiag_dynamics::field::{HeavyTop, State, dot};
use bifdiag_dynamics::section::{
    Monitor, OrbitEnd, Portrait, PortraitOptions, PpTorus, SectionChart, SweepOptions, sweep,
};
use bifdiag_plot::{AnimatedCrossing, AnimationScene, draw_animation};

use super::arguments::Problem;
use crate::cli::failure::Failure;
use crate::cli::input::shown;
use crate::cli::terminal::significant;

/// Frames of an animation.
const FRAMES: u32 = 361;
/// Points of the trace from one frame to the next.
const FINER: u32 = 8;
/// How long it plays.
const SECONDS: f64 = 20.0;
/// Most crossings that are shown.
const CROSSINGS: usize = 2000;

/// What goes into the file.
///
/// # Errors
/// When the motion cannot be followed.
pub fn text(problem: &Problem<'_>, file: &Path) -> Result<String, Failure> {
    let svg = animation(problem)?;
    Ok(if file.extension().is_some_and(|extension| extension == "html") { page(&svg) } else { svg })
}

/// Frames at equal times from the first one to the last.
fn animation(problem: &Problem<'_>) -> Result<String, Failure> {
    let Problem { subject, top, start, times, .. } = problem;
    let (first, last) = (times.first().copied().unwrap_or(0.0), times.last().copied().unwrap_or(0.0));
    let points = (FRAMES - 1) * FINER;
    let time = |k: u32| first + (last - first) * f64::from(k) / f64::from(points);
    let at: Vec<f64> = (0..=points).map(time).collect();
    let motion = problem.follow(&at, &AtomicBool::new(false))?;
    let unit = |k: usize| std::array::from_fn(|i| f64::from(u8::from(i == k)));
    let frames: Vec<[[f64; 3]; 3]> = motion
        .samples
        .iter()
        .step_by(FINER as usize)
        .map(|sample| [0, 1, 2].map(|k| sample.attitude.rotate(unit(k))))
        .collect();
    let axis = top.r_hat().unwrap_or([0.0, 0.0, 1.0]);
    let trace: Vec<[f64; 3]> = motion.samples.iter().map(|sample| sample.attitude.rotate(axis)).collect();
    let begin = motion.samples.first().map(|sample| State { gamma: sample.gamma, l: sample.l });
    let crossings = begin.and_then(|begin| crossings(top, &begin, last - first));
    let (h, l) = (top.energy(start), dot(start.gamma, start.l));
    let accessible = match &crossings {
        Some(_) => Portrait::new(&subject.body, h, l, &PortraitOptions::default())
            .map(|portrait| portrait.accessible(SectionChart::Torus).loops)
            .unwrap_or_default(),
        None => Vec::new(),
    };
    let text = |numbers: [String; 3]| numbers.map(|number| shown(&number)).join(", ");
    let title = format!(
        "A = ({}), r = ({}), h = {}, l = {}, t from {first} to {last}",
        text(bifdiag_documents::texts(subject.body.moments())),
        text(bifdiag_documents::texts(subject.body.center())),
        significant(h, 7),
        significant(l, 7),
    );
    Ok(draw_animation(&AnimationScene {
        frames: &frames,
        moments: top.moments(),
        axis,
        trace: &trace,
        crossings: crossings.as_deref(),
        accessible: &accessible,
        title: &title,
        seconds: SECONDS,
    }))
}

/// The crossings within a time; `None` where there is no section.
fn crossings(top: &HeavyTop, start: &State, time: f64) -> Option<Vec<AnimatedCrossing>> {
    let torus = PpTorus::new(top).ok()?;
    let options = SweepOptions { crossings: CROSSINGS, max_time: time, ..SweepOptions::default() };
    let orbits = sweep(&torus, &[*start], &options, &Monitor::default()).ok()?;
    let orbit = orbits.first().filter(|orbit| orbit.report.end != OrbitEnd::StaysOnSection)?;
    let shown = orbit.points.iter().map(|point| AnimatedCrossing {
        at: point.time / time,
        sheet: point.sheet,
        theta: point.theta,
        psi: point.psi,
    });
    Some(shown.collect())
}

/// A page that holds the picture, to stop it and to go to a time.
fn page(svg: &str) -> String {
    format!(
        "<!doctype html>\n<html lang=\"en\"><meta charset=\"utf-8\"><title>bifdiag orbit</title>\n\
         <style>body{{margin:1em auto;max-width:60em;font-family:sans-serif}}input{{width:70%}}</style>\n{svg}\
         <p><button id=\"stop\">stop</button> <input id=\"time\" type=\"range\" min=\"0\" max=\"{SECONDS}\" step=\"0.01\" \
         value=\"0\" aria-label=\"time\"></p>\n\
         <script>\n\
         const svg = document.querySelector(\"svg\"), stop = document.getElementById(\"stop\");\n\
         const time = document.getElementById(\"time\");\n\
         stop.onclick = () => {{\n  const paused = svg.animationsPaused();\n  paused ? svg.unpauseAnimations() : svg.pauseAnimations();\n\
         \x20 stop.textContent = paused ? \"stop\" : \"go on\";\n}};\n\
         time.oninput = () => svg.setCurrentTime(Number(time.value));\n\
         setInterval(() => {{ if (!svg.animationsPaused()) time.value = svg.getCurrentTime() % {SECONDS}; }}, 100);\n\
         </script></html>\n"
    )
}
