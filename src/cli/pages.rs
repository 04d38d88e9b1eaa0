//! `bifdiag completions` and `bifdiag man`: what shells and manual readers need.

use std::io;
use std::path::PathBuf;

use clap::{Args, Command};
use thiserror::Error;

use super::export::FileSet;
use super::failure::{CommandError, Failure};
use super::terminal::{Report, print};

pub const COMPLETIONS_EXAMPLES: &str = "\
Examples:
  bifdiag completions bash > ~/.local/share/bash-completion/completions/bifdiag
  bifdiag completions zsh > ~/.zfunc/_bifdiag
  bifdiag completions fish > ~/.config/fish/completions/bifdiag.fish";

pub const MAN_EXAMPLES: &str = "\
Examples:
  bifdiag man | man -l -
  bifdiag man --out ~/.local/share/man/man1      a page for each command";

/// `bifdiag completions`.
#[derive(Debug, Args)]
pub struct CompletionsArguments {
    /// The shell
    #[arg(value_enum)]
    pub shell: clap_complete::Shell,
}

/// `bifdiag man`.
#[derive(Debug, Args)]
pub struct ManArguments {
    /// Write a page for each command to DIR
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
}

/// A page could not be made.
#[derive(Debug, Error)]
#[error("the manual page of {command} cannot be made")]
pub struct PageError {
    command: String,
    source: io::Error,
}

impl CommandError for PageError {}

pub fn completions(arguments: &CompletionsArguments, mut root: Command) -> Result<(), Failure> {
    let mut text = Vec::new();
    clap_complete::generate(arguments.shell, &mut root, "bifdiag", &mut text);
    Ok(print(&text)?)
}

pub fn man(arguments: &ManArguments, mut root: Command) -> Result<(), Failure> {
    root.build();
    let Some(directory) = &arguments.out else {
        return Ok(print(page(root)?)?);
    };
    let mut files = FileSet::new(directory);
    for command in root.get_subcommands().chain([&root]) {
        let file = clap_mangen::Man::new(command.clone()).get_filename();
        files.add(file, page(command.clone())?);
    }
    Ok(print(Report::of_written(&files.write()?).text())?)
}

fn page(command: Command) -> Result<Vec<u8>, PageError> {
    let name = command.get_name().to_owned();
    let mut text = Vec::new();
    clap_mangen::Man::new(command).render(&mut text).map_err(|source| PageError { command: name, source })?;
    Ok(text)
}
