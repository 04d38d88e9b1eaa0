//! The options of `bifdiag state`, `bifdiag critical-spin` and `bifdiag campbell`.

use std::path::PathBuf;

use bifdiag_body::part::Spin;
use clap::Args;

use super::direction::{AxisArgument, axis};
use super::tolerance::{ToleranceArgument, tolerance};
use crate::cli::input::BodyArguments;
use crate::cli::input::values::{self, Triple};

pub const STATE_EXAMPLES: &str = "\
Examples:
  bifdiag state --inertia-com 8e-5,8e-5,1.2e-4,0,0,0 --com 0,0,0.04 --mass 0.2 \\
      --spin \"3000 rpm\" --axis z
  bifdiag state --body paper --spin \"2 rad/s\" --axis 0,1,1 --vertical 0,0,1
  bifdiag state --body paper --omega 1,0,2 --vertical 0,0,1 --json

A body turns about a fixed point; --vertical points up, in the part's frame (without a part: in principal axes). With --spin \
and --axis the default is: the axis points up.";

pub const CRITICAL_SPIN_EXAMPLES: &str = "\
Examples:
  bifdiag critical-spin --inertia-com 8e-5,8e-5,1.2e-4,0,0,0 --com 0,0,0.04 \\
      --mass 0.2 --axis z --tolerance 1%
  bifdiag critical-spin --A 2,1.1,1 --r 0,0,1 --axis 0,0,1 --json";

pub const CAMPBELL_EXAMPLES: &str = "\
Examples:
  bifdiag campbell --inertia-com 8e-5,9e-5,1.2e-4,0,0,0 --com 0,0,0.04 \\
      --mass 0.2 --axis z --to \"4000 rpm\"
  bifdiag campbell --A 2,1.1,1 --r 0,0,1 --axis=-z --to \"5 rad/s\" --out campbell";

/// `bifdiag state`.
#[derive(Debug, Args)]
pub struct StateArguments {
    #[command(flatten)]
    pub body: BodyArguments,
    /// Rate of turning about --axis, with its unit: rpm, Hz, rad/s, deg/s
    #[arg(long, value_name = "\"3000 rpm\"", allow_hyphen_values = true, help_heading = "State")]
    pub spin: Option<Spin>,
    /// The axis of the spin: x, y, z or a direction
    #[arg(long, value_name = "x,y,z", allow_hyphen_values = true, value_parser = axis, help_heading = "State")]
    pub axis: Option<AxisArgument>,
    /// The angular velocity in rad/s, instead of --spin and --axis
    #[arg(long, value_name = "x,y,z", allow_hyphen_values = true, value_parser = values::triple, help_heading = "State")]
    pub omega: Option<Triple>,
    /// The direction upward (default: along --axis)
    #[arg(long, value_name = "x,y,z", allow_hyphen_values = true, value_parser = axis, help_heading = "State")]
    pub vertical: Option<AxisArgument>,
    /// Print the state as JSON
    #[arg(long, help_heading = "Output")]
    pub json: bool,
}

/// `bifdiag critical-spin`.
#[derive(Debug, Args)]
pub struct CriticalSpinArguments {
    #[command(flatten)]
    pub body: BodyArguments,
    /// The axis of rotation: x, y, z or a direction
    #[arg(long, value_name = "x,y,z", allow_hyphen_values = true, value_parser = axis, help_heading = "Rotation")]
    pub axis: AxisArgument,
    /// How well moments and weight are known: 1%, or axis=0.5%,across=1%,weight=2% (moments for the first two); bounds on the
    /// spins at which such parts change
    #[arg(long, value_name = "1%", value_parser = tolerance, help_heading = "Rotation")]
    pub tolerance: Option<ToleranceArgument>,
    /// Print the spins as JSON
    #[arg(long, help_heading = "Output")]
    pub json: bool,
}

/// `bifdiag campbell`.
#[derive(Debug, Args)]
pub struct CampbellArguments {
    #[command(flatten)]
    pub body: BodyArguments,
    /// The axis of rotation, pointing up: x, y, z or a direction
    #[arg(long, value_name = "x,y,z", allow_hyphen_values = true, value_parser = axis, help_heading = "Rotation")]
    pub axis: AxisArgument,
    /// The largest spin, with its unit: rpm, Hz, rad/s, deg/s
    #[arg(long, value_name = "\"6000 rpm\"", allow_hyphen_values = true, help_heading = "Rotation")]
    pub to: Spin,
    /// Write campbell.svg and campbell.csv to DIR
    #[arg(long, value_name = "DIR", default_value = "bifdiag-out", help_heading = "Output")]
    pub out: PathBuf,
    /// Draw nothing
    #[arg(long, help_heading = "Output")]
    pub no_plot: bool,
}
