//! Options of `bifdiag orbit`.

use bifdiag_body::Number;
use clap::Args;

use super::target::AnimationTarget;
use super::times::Times;
use crate::cli::export::DataTarget;
use crate::cli::input::BodyArguments;
use crate::cli::input::values::{self, Vector};

pub const EXAMPLES: &str = "\
Examples:
  bifdiag orbit --body paper --gamma 0.6,0,0.8 --omega 1,0.3,1
  bifdiag orbit --body paper --h 4.45 --l 3.25 --theta 1 --psi pi/2 --data m.csv
  bifdiag orbit --body lagrange --gamma 0,0.1,1 --l-vector 0,0,3 --times -5:5:11
  bifdiag orbit --body kovalevskaya --gamma 1,0,0 --omega 1.5,0,0.1 --json
  bifdiag orbit --body paper --gamma 0,0,1 --omega 1,0,2 --animate m.svg

The start, at time 0, is gamma with the angular momentum l or the angular velocity omega = l/A, in the body's axes; or a \
point of the section: (h, l), theta, psi and sheet of its PP-torus, as `bifdiag section` writes them. The attitude is a \
unit quaternion w,x,y,z that takes vectors of the body to space; theta, psi, phi are Euler's angles of the third axis.";

/// `bifdiag orbit`.
#[derive(Debug, Args)]
pub struct OrbitArguments {
    #[command(flatten)]
    pub body: BodyArguments,
    /// The vertical, in the body's axes; its length does not matter
    #[arg(long, value_name = "g1,g2,g3", allow_hyphen_values = true, value_parser = values::direction)]
    #[arg(help_heading = "Start: a state")]
    pub gamma: Option<Vector>,
    /// Angular momentum, in the body's axes, such as 1,0.3,2
    #[arg(long, value_name = "l1,l2,l3", allow_hyphen_values = true, value_parser = values::vector)]
    #[arg(help_heading = "Start: a state")]
    pub l_vector: Option<Vector>,
    /// Angular velocity, in the body's axes, instead of --l-vector
    #[arg(long, value_name = "w1,w2,w3", allow_hyphen_values = true, value_parser = values::vector)]
    #[arg(help_heading = "Start: a state")]
    pub omega: Option<Vector>,
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
    #[arg(help_heading = "Start: a point of the section")]
    pub sheet: Option<i8>,
    /// Euler's angle phi at the start
    #[arg(long, value_name = "ANGLE", default_value = "0", allow_hyphen_values = true, value_parser = values::angle)]
    #[arg(help_heading = "Motion")]
    pub phi: f64,
    /// Times: n of them from t0 to t1, or a FILE (-: stdin) with one on each line; negative ones are in the past
    #[arg(long, value_name = "t0:t1:n|FILE", default_value = "0:10:21", allow_hyphen_values = true)]
    #[arg(value_parser = Times::parse, help_heading = "Motion")]
    pub times: Times,
    /// Truncation error of a step of the Taylor series, relative to the size of the motion (default: 1e-15)
    #[arg(long, value_name = "TOL", allow_hyphen_values = true, value_parser = values::step_tolerance)]
    #[arg(hide_short_help = true, help_heading = "Motion")]
    pub tol: Option<f64>,
    /// Write the samples to FILE.csv, FILE.npz, FILE.parquet or FILE.jsonl (-: CSV to stdout)
    #[arg(long, value_name = "FILE", value_parser = DataTarget::parse, help_heading = "Output")]
    pub data: Option<DataTarget>,
    /// Write a moving picture of the body, the trace of its axis, and the section that fills, to FILE.svg or FILE.html
    #[arg(long, value_name = "FILE", value_parser = AnimationTarget::parse, help_heading = "Output")]
    pub animate: Option<AnimationTarget>,
    /// Print the answer as JSON
    #[arg(long, help_heading = "Output")]
    pub json: bool,
}
