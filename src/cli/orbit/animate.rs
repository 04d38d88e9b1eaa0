//! The motion as a moving picture.

use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::atomic::AtomicBool;

use bifdiag_body::part::file::edges;
use bifdiag_dynamics::field::{HeavyTop, State, dot};
use bifdiag_dynamics::section::{
    Monitor, OrbitEnd, Portrait, PortraitOptions, PpTorus, SectionChart, SweepOptions, sweep,
};
use bifdiag_plot::{AnimatedCrossing, AnimationScene, draw_animation, draw_frame};

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
/// Edges of a mesh that are shown, and in a film, which does not grow by them.
const EDGES: usize = 240;
const EDGES_OF_FILM: usize = 4000;
/// Dots of a film to an inch of print.
const FILM_DPI: f64 = 200.0;
/// Most crossings that are shown.
const CROSSINGS: usize = 2000;

/// The file that is written and what goes into it: where a film is asked for and ffmpeg is not there, a page beside it.
///
/// # Errors
/// When the motion cannot be followed, or ffmpeg fails.
pub fn file(problem: &Problem<'_>, path: &Path) -> Result<(PathBuf, Vec<u8>), Failure> {
    let ending = path.extension().and_then(|ending| ending.to_str()).unwrap_or_default();
    let is_film = ending == "mp4";
    if is_film && has_ffmpeg() {
        return Ok((path.to_owned(), animation(problem, EDGES_OF_FILM, film)??));
    }
    let svg = animation(problem, EDGES, |scene| draw_animation(scene).map(|picture| picture.svg))??;
    if !is_film {
        return Ok((path.to_owned(), if ending == "html" { page(&svg) } else { svg }.into_bytes()));
    }
    let page_at = path.with_extension("html");
    tracing::warn!(
        "ffmpeg is not installed, so {} cannot be made: {} is written instead",
        path.display(),
        page_at.display()
    );
    Ok((page_at, page(&svg).into_bytes()))
}

/// It can be run.
fn has_ffmpeg() -> bool {
    let mut asked = Command::new("ffmpeg");
    let run = asked.arg("-version").stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null()).status();
    !matches!(run, Err(error) if error.kind() == std::io::ErrorKind::NotFound)
}

/// The frames as a film.
fn film(scene: &AnimationScene<'_>) -> Result<Vec<u8>, Failure> {
    let failure = |error: std::io::Error| Failure::work("ffmpeg did not take the film").because(error);
    let first = draw_frame(scene, 0)?.to_pixels(FILM_DPI)?;
    let place = tempfile::tempdir().map_err(failure)?;
    let out = place.path().join("film.mp4");
    let rate = f64::from(FRAMES - 1) / SECONDS;
    let size = format!("{}x{}", first.size[0], first.size[1]);
    let mut ffmpeg = Command::new("ffmpeg");
    ffmpeg.args(["-loglevel", "error", "-y", "-f", "rawvideo", "-pixel_format", "rgb24", "-video_size", &size]);
    // Players want an even number of pixels.
    let even = "pad=ceil(iw/2)*2:ceil(ih/2)*2:color=white";
    ffmpeg.args(["-framerate", &rate.to_string(), "-i", "-", "-vf", even, "-pix_fmt", "yuv420p"]).arg(&out);
    let running = ffmpeg.stdin(Stdio::piped()).stdout(Stdio::null()).stderr(Stdio::piped()).spawn();
    let mut running = running.map_err(failure)?;
    // If it ends early, its message is reported below.
    let mut taken = Ok(());
    if let Some(mut input) = running.stdin.take() {
        for frame in 0..scene.frames.len() {
            taken = input.write_all(&draw_frame(scene, frame)?.to_pixels(FILM_DPI)?.rgb);
            if taken.is_err() {
                break;
            }
        }
    }
    let done = running.wait_with_output().map_err(failure)?;
    if !done.status.success() {
        let said = String::from_utf8_lossy(&done.stderr);
        return Err(Failure::work(format!("ffmpeg made no film: {}", said.trim())));
    }
    taken.and_then(|()| std::fs::read(&out)).map_err(failure)
}

/// Frames at equal times from the first one to the last.
fn animation<T>(problem: &Problem<'_>, most: usize, draw: impl FnOnce(&AnimationScene<'_>) -> T) -> Result<T, Failure> {
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
    Ok(draw(&AnimationScene {
        frames: &frames,
        times: [first, last],
        unit: subject.part.as_ref().map_or("", |part| part.time_unit()),
        moments: top.moments(),
        edges: &edges_of(problem, most)?,
        axis,
        trace: &trace,
        crossings: crossings.as_deref(),
        accessible: &accessible,
        title: &title,
        seconds: SECONDS,
    }))
}

/// The edges of a mesh in principal axes, thinned out if there are too many for a picture.
fn edges_of(problem: &Problem<'_>, most: usize) -> Result<Vec<[[f64; 3]; 2]>, Failure> {
    let part = &problem.arguments.body.part;
    let Some(file) = &part.file else { return Ok(Vec::new()) };
    let all = edges(file, part.fixed_point()?);
    let step = all.len().div_ceil(most).max(1);
    Ok(all.into_iter().step_by(step).map(|ends| ends.map(|end| problem.subject.to_principal(end))).collect())
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
