//! `bifdiag completions` and `bifdiag man`: what shells and manual readers need.

use std::io;

use super::arguments::{CompletionsArguments, ManArguments, Options};
use super::failure::Failure;
use super::files::FileSet;
use super::output;
use super::report::Report;

pub fn completions(arguments: &CompletionsArguments) -> Result<(), Failure> {
    let mut text = Vec::new();
    clap_complete::generate(arguments.shell, &mut Options::command(), "bifdiag", &mut text);
    Ok(output::print(&text)?)
}

pub fn man(arguments: &ManArguments) -> Result<(), Failure> {
    let mut root = Options::command();
    root.build();
    let Some(directory) = &arguments.out else {
        return Ok(output::print(&page(root)?)?);
    };
    let mut files = FileSet::new(directory);
    for command in root.get_subcommands().chain([&root]) {
        let file = clap_mangen::Man::new(command.clone()).get_filename();
        files.add(file, page(command.clone())?);
    }
    Ok(output::print(Report::of_paths(&files.write()?).text().as_bytes())?)
}

fn page(command: clap::Command) -> Result<Vec<u8>, Failure> {
    let name = command.get_name().to_owned();
    let mut text = Vec::new();
    let rendered: io::Result<()> = clap_mangen::Man::new(command).render(&mut text);
    rendered.map_err(|source| Failure::Page { name: format!("the manual page of {name}"), source })?;
    Ok(text)
}
