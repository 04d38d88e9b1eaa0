//! The options of `bifdiag classes` and `bifdiag class`.

use std::path::PathBuf;

use clap::Args;
use thiserror::Error;

use crate::cli::export::PictureArguments;
use crate::cli::failure::{CommandError, Exit};
use crate::cli::input::BodyArguments;

pub const CLASSES_EXAMPLES: &str = "\
Examples:
  bifdiag classes
  bifdiag classes --physical --json | jq -r '.classes[].name'
  bifdiag classes --at --A 1,1.1,1.4 --r 0.5,0.3,0.8
  bifdiag classes --at --body paper --json

Two bodies have one class when their diagrams are the same but for the lengths in them. With --at: which class a body has, and \
how far it is to its borders. Distances are √(|ΔA|² + ∠²), for A with the sum 2 and the angle between the two r.";

pub const CLASS_EXAMPLES: &str = "\
Examples:
  bifdiag class 01036ac4a504
  bifdiag class 01036ac4a504 --no-plot
  bifdiag class 0103 --json

The beginning of a name is enough where no other class begins so.";

/// `bifdiag classes`.
#[derive(Debug, Args)]
pub struct ClassesArguments {
    /// Tell the class of a body, and how far it is to the borders of that class
    #[arg(long)]
    pub at: bool,
    #[command(flatten)]
    pub body: BodyArguments,
    /// Only bodies that exist: A_i + A_j > A_k, or equality and r_k = 0
    #[arg(long, help_heading = "Work")]
    pub physical: bool,
    /// With --at: random lines through the body, each in both directions (default: 48)
    #[arg(long, value_name = "N", help_heading = "Work", requires = "at")]
    #[arg(value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
    pub lines: Option<u32>,
    /// With --at: chooses the lines (default: 0)
    #[arg(long, value_name = "N", help_heading = "Work", requires = "at")]
    pub seed: Option<u64>,
    /// Print the answer as JSON
    #[arg(long, help_heading = "Output")]
    pub json: bool,
}

/// `bifdiag class`.
#[derive(Debug, Args)]
pub struct ClassArguments {
    /// The name of a class, 12 hexadecimal digits, or its beginning
    #[arg(value_name = "NAME")]
    pub name: String,
    /// Write no picture
    #[arg(long, help_heading = "Output")]
    pub no_plot: bool,
    /// Print the class as JSON; pictures only with --out
    #[arg(long, help_heading = "Output")]
    pub json: bool,
    /// Write the diagram of the class's witness to DIR (default: bifdiag-out)
    #[arg(long, value_name = "DIR", help_heading = "Output")]
    pub out: Option<PathBuf>,
    #[command(flatten)]
    pub picture: PictureArguments,
}

/// What is asked cannot be answered.
#[derive(Debug, Error)]
pub enum ClassesInput {
    #[error("{option} describes a body, and nothing is asked of it; add --at to tell its class")]
    NotAt { option: &'static str },
    #[error(
        "NAME {name}: none of the classes that come with bifdiag begins so{nearest}; a name is computed from the structure of \
         a diagram, so it does not lead back to a body: `bifdiag classes --at --body …` (or --A … --r …) gives the class of a \
         body and the classes beside it, and `bifdiag classes` lists those that are known"
    )]
    Unknown { name: String, nearest: String },
    #[error("NAME {name}: {count} classes begin so, {first} and others; give more digits")]
    Several { name: String, count: usize, first: String },
}

impl CommandError for ClassesInput {
    fn exit(&self) -> Exit {
        Exit::WrongInput
    }
}
