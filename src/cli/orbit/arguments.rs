//! The options of `bifdiag orbit`, and the state at which they let the motion start.

use std::f64::consts::PI;
use std::path::{Path, PathBuf};
use std::sync::atomic::AtomicBool;

use bifdiag_body::Number;
use bifdiag_documents::Subject;
use bifdiag_dynamics::field::{HeavyTop, State, dot};
use bifdiag_dynamics::motion::{Motion, MotionOptions, Quaternion, follow};
use bifdiag_dynamics::section::{PpTorus, SectionError, TorusPoint};
use bifdiag_numbers::symmetric;
use clap::Args;
use dashu_ratio::RBig;

use super::times::Times;
use crate::cli::export::DataTarget;
use crate::cli::failure::{Failure, failed, incomplete};
use crate::cli::input::values::{Triple, Vertical};
use crate::cli::input::{BodyArguments, values};

pub const EXAMPLES: &str = "\
Examples:
  bifdiag orbit --body paper --gamma 0.6,0,0.8 --omega 1,0.3,1
  bifdiag orbit --body paper --h 4.45 --l 3.25 --theta 1 --psi pi/2 --data m.csv
  bifdiag orbit --body lagrange --gamma 0,0.1,1 --l-vector 0,0,3 --times -5:5:11
  bifdiag orbit --body paper --euler pi/3,pi/2,0 --omega 1,0.3,1
  bifdiag orbit --body paper --gamma 0.6,0,0.8 --omega 1,0.3,1 --proved
  bifdiag orbit --body paper --gamma 0,0,1 --omega 1,0,2 --animate m.svg

The start, at time 0, is gamma (or Euler's angles theta from 0 to pi, psi and phi: gamma = (sin theta sin psi, sin theta cos psi, \
cos theta)) with the angular momentum l or the angular velocity omega = l/A, in principal axes; or a \
point of the section: (h, l), theta, psi and sheet of its PP-torus, as `bifdiag section` writes them. The attitude is a \
unit quaternion w,x,y,z that takes vectors from the body to space, whose third axis is gamma: both point down, along \
gravity. theta, \
psi, phi are Euler's angles of the third axis.";

/// `bifdiag orbit`.
#[derive(Debug, Args)]
pub struct OrbitArguments {
    #[command(flatten)]
    pub body: BodyArguments,
    /// The vertical, pointing down, in principal axes, of any length
    #[arg(long, value_name = "g1,g2,g3", allow_hyphen_values = true, value_parser = values::vertical)]
    #[arg(help_heading = "Start: a state")]
    pub gamma: Option<Vertical>,
    /// Euler's angles instead of --gamma, such as pi/3,pi/2,0
    #[arg(long, value_name = "THETA,PSI,PHI", allow_hyphen_values = true, value_parser = values::angles)]
    #[arg(help_heading = "Start: a state")]
    pub euler: Option<[f64; 3]>,
    /// Angular momentum, in principal axes, such as 1,0.3,2
    #[arg(long, value_name = "l1,l2,l3", allow_hyphen_values = true, value_parser = values::triple)]
    #[arg(help_heading = "Start: a state")]
    pub l_vector: Option<Triple>,
    /// Angular velocity in rad per unit of time, instead of --l-vector
    #[arg(long, value_name = "w1,w2,w3", allow_hyphen_values = true, value_parser = values::triple)]
    #[arg(help_heading = "Start: a state")]
    pub omega: Option<Triple>,
    /// Energy
    #[arg(long = "h", value_name = "h", allow_hyphen_values = true, value_parser = values::number)]
    #[arg(help_heading = "Start: a point of the section")]
    pub energy: Option<Number>,
    /// Vertical angular momentum
    #[arg(long = "l", value_name = "l", allow_hyphen_values = true, value_parser = values::number)]
    #[arg(help_heading = "Start: a point of the section")]
    pub momentum: Option<Number>,
    /// Angle of the PP-torus between gamma and r, in radians or as pi/2
    #[arg(long, value_name = "ANGLE", allow_hyphen_values = true, value_parser = values::angle)]
    #[arg(help_heading = "Start: a point of the section")]
    pub theta: Option<f64>,
    /// Angle of the PP-torus about r
    #[arg(long, value_name = "ANGLE", allow_hyphen_values = true, value_parser = values::angle)]
    #[arg(help_heading = "Start: a point of the section")]
    pub psi: Option<f64>,
    /// Sheet of the PP-torus: + (the default) or -
    #[arg(long, value_name = "+|-", allow_hyphen_values = true, value_parser = values::sheet)]
    #[arg(help_heading = "Start: a point of the section", hide_short_help = true)]
    pub sheet: Option<i8>,
    /// Euler's angle phi at the start (default: 0)
    #[arg(long, value_name = "ANGLE", allow_hyphen_values = true, value_parser = values::angle)]
    #[arg(help_heading = "Motion", hide_short_help = true, conflicts_with = "euler")]
    pub phi: Option<f64>,
    /// Times: n values from t0 to t1, or a FILE (-: stdin) with one per line; negative times are in the past
    #[arg(long, value_name = "t0:t1:n|FILE", default_value = "0:10:21", allow_hyphen_values = true)]
    #[arg(value_parser = Times::parse, help_heading = "Motion")]
    pub times: Times,
    /// Truncation error per step of the Taylor series, relative to the size of the motion
    #[arg(long, value_name = "TOL", allow_hyphen_values = true, value_parser = values::step_tolerance)]
    #[arg(default_value = "1e-15", hide_short_help = true, help_heading = "Motion")]
    pub tol: f64,
    /// Enclose the motion in intervals that are proved to contain it
    #[arg(long, help_heading = "Motion", conflicts_with_all = ["tol", "animate"])]
    pub proved: bool,
    /// Digits of the proof's arithmetic, from 5 to 250 (default: as many as --bound needs)
    #[arg(long, value_name = "D", requires = "proved", hide_short_help = true, help_heading = "Motion")]
    #[arg(value_parser = values::proof_digits)]
    pub digits: Option<u32>,
    /// Widest interval wanted; the proof ends where the intervals would be wider
    #[arg(long, value_name = "WIDTH", requires = "proved", hide_short_help = true, help_heading = "Motion")]
    #[arg(default_value = "1e-10", value_parser = values::proof_bound)]
    pub bound: f64,
    /// Write the samples to FILE.csv, .npz, .parquet or .jsonl (-: CSV to stdout)
    #[arg(long, value_name = "FILE", value_parser = DataTarget::parse, help_heading = "Output")]
    pub data: Option<DataTarget>,
    /// Write an animation of the body, the trace of its axis, and the section as it fills, to FILE.svg, FILE.html or,
    /// with ffmpeg, FILE.mp4
    #[arg(long, value_name = "FILE", value_parser = animation, help_heading = "Output", hide_short_help = true)]
    pub animate: Option<PathBuf>,
    /// Print the answer as JSON
    #[arg(long, help_heading = "Output")]
    pub json: bool,
}

impl OrbitArguments {
    /// φ at the start.
    pub fn start_phi(&self) -> f64 {
        self.euler.map_or(self.phi.unwrap_or_default(), |[_, _, phi]| phi)
    }
}

/// The motion that the options ask for: a body, its state at time 0, and the times at which it is wanted.
pub struct Problem<'a> {
    pub arguments: &'a OrbitArguments,
    pub subject: Subject,
    pub top: HeavyTop,
    pub start: State,
    pub times: Vec<f64>,
}

impl<'a> Problem<'a> {
    pub fn new(arguments: &'a OrbitArguments) -> Result<Self, Failure> {
        if arguments.json && arguments.data == Some(DataTarget::Stdout) {
            return Err(Failure::input("--data - and --json both want stdout; give --data FILE.csv"));
        }
        let subject = arguments.body.subject()?;
        let top = HeavyTop::new(&subject.body);
        let start = start(arguments, &top)?;
        Ok(Self { arguments, subject, top, start, times: arguments.times.list()? })
    }

    /// l = ⟨γ,Aω⟩ at the start; 0 where the numbers that were given make it 0 exactly.
    pub fn vertical_momentum(&self) -> f64 {
        let Self { arguments, subject, start, .. } = self;
        let given = match (&arguments.gamma, &arguments.l_vector, &arguments.omega) {
            (Some(gamma), Some(l), _) => Some(symmetric::dot(&gamma.given.values(), &l.values())),
            (Some(gamma), None, Some(omega)) => {
                Some(symmetric::dot(&gamma.given.values(), &subject.body.angular_momentum(&omega.values())))
            }
            _ => arguments.momentum.as_ref().map(|l| l.value().clone()),
        };
        if given.is_some_and(|l: RBig| l.is_zero()) { 0.0 } else { dot(start.gamma, start.l) }
    }

    /// The motion at some times.
    pub fn follow(&self, times: &[f64], stop: &AtomicBool) -> Result<Motion, Failure> {
        let options = MotionOptions { tolerance: self.arguments.tol, phi: self.arguments.start_phi(), stop };
        follow(&self.top, &self.start, times, &options).map_err(failed("the motion could not be computed"))
    }
}

/// The file of a moving picture.
fn animation(text: &str) -> Result<PathBuf, Failure> {
    match Path::new(text).extension().and_then(|extension| extension.to_str()) {
        Some("svg" | "html" | "mp4") => Ok(text.into()),
        _ => Err(Failure::input("the extension selects the format: give FILE.svg, FILE.html or FILE.mp4")),
    }
}

/// γ with l or ω, or a point of the section.
fn start(arguments: &OrbitArguments, top: &HeavyTop) -> Result<State, Failure> {
    let state = [
        ("--gamma", arguments.gamma.is_some()),
        ("--euler", arguments.euler.is_some()),
        ("--l-vector", arguments.l_vector.is_some()),
        ("--omega", arguments.omega.is_some()),
    ];
    let point = [
        ("--h", arguments.energy.is_some()),
        ("--l", arguments.momentum.is_some()),
        ("--theta", arguments.theta.is_some()),
        ("--psi", arguments.psi.is_some()),
        ("--sheet", arguments.sheet.is_some()),
    ];
    let first = |options: &[(&'static str, bool)]| options.iter().find(|(_, given)| *given).map(|(name, _)| *name);
    match (first(&state), first(&point)) {
        (None, None) => Err(Failure::input(
            "no start is given; use --gamma 0.6,0,0.8 with --omega 1,0.3,1 (or --l-vector), or a point of the section: \
             --h 4.45 --l 3.25 --theta 1.2 --psi pi/2",
        )),
        (Some(first), Some(second)) => Err(two_starts(first, second)),
        (Some(given), None) => of_state(arguments, top, given),
        (None, Some(given)) => of_point(arguments, top, given),
    }
}

fn of_state(arguments: &OrbitArguments, top: &HeavyTop, given: &'static str) -> Result<State, Failure> {
    let missing = |missing, example| move || incomplete(given, missing, example);
    let gamma = match (&arguments.gamma, arguments.euler) {
        (Some(_), Some(_)) => return Err(two_starts("--gamma", "--euler")),
        (Some(gamma), None) => gamma.unit,
        (None, Some([theta, psi, phi])) if (0.0..=PI).contains(&theta) => {
            Quaternion::of_angles(theta, psi, phi).vertical()
        }
        (None, Some([theta, ..])) => {
            let right = "it is the angle between gamma and the third axis, from 0 to pi";
            return Err(Failure::input(format!("--euler: theta = {theta}; {right}")));
        }
        (None, None) => return Err(missing("--gamma", "--gamma 0.6,0,0.8 or --euler pi/3,0,0")()),
    };
    let l = match (&arguments.l_vector, &arguments.omega) {
        (Some(_), Some(_)) => return Err(two_starts("--l-vector", "--omega")),
        (Some(l), None) => l.rounded(),
        (None, Some(omega)) => top.inertia(omega.rounded()),
        (None, None) => return Err(incomplete(given, "--omega or --l-vector", "--omega 1,0.3,1")),
    };
    Ok(State { gamma, l })
}

fn of_point(arguments: &OrbitArguments, top: &HeavyTop, given: &'static str) -> Result<State, Failure> {
    let missing = |missing, example| move || incomplete(given, missing, example);
    let h = arguments.energy.as_ref().ok_or_else(missing("--h", "--h 4.45"))?.to_f64();
    let l = arguments.momentum.as_ref().ok_or_else(missing("--l", "--l 3.25"))?.to_f64();
    let theta = arguments.theta.ok_or_else(missing("--theta", "--theta 1.2"))?;
    let psi = arguments.psi.ok_or_else(missing("--psi", "--psi pi/2"))?;
    if !(0.0..=PI).contains(&theta) {
        return Err(wrong_theta(theta));
    }
    let torus = PpTorus::new(top).map_err(|_no_axis| {
        Failure::input("--theta and --psi need r ≠ 0, and this body has r = 0; give --gamma with --omega or --l-vector")
    })?;
    let point = TorusPoint { theta, psi, sheet: arguments.sheet.unwrap_or(1) };
    torus.state(point, h, l).map_err(|error| match error {
        SectionError::SeedInaccessible { potential, .. } => Failure::input(format!(
            "(theta, psi) = ({theta}, {psi}) is not accessible: U = {potential} there, above --h {h}; raise h or choose \
             another point"
        )),
        // The angles are finite and r is not 0.
        _ => wrong_theta(theta),
    })
}

fn two_starts(first: &str, second: &str) -> Failure {
    Failure::input(format!(
        "{first} and {second} both describe the start; give gamma (or euler) with l-vector or omega, or h, l, theta, psi, sheet"
    ))
}

fn wrong_theta(theta: f64) -> Failure {
    Failure::input(format!("--theta {theta}: it is the angle between gamma and r, from 0 to pi"))
}
