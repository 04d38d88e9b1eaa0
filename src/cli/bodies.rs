//! `bifdiag bodies`: the named bodies.

use clap::Args;

use super::export::answer;
use super::failure::Failure;
use super::terminal::Table;

pub const EXAMPLES: &str = "\
Examples:
  bifdiag bodies
  bifdiag bodies --json | jq -r '.bodies[].name'";

/// `bifdiag bodies`.
#[derive(Debug, Args)]
pub struct BodiesArguments {
    /// Print the list as JSON
    #[arg(long)]
    pub json: bool,
}

pub fn run(arguments: &BodiesArguments) -> Result<(), Failure> {
    let document = bifdiag_documents::all_bodies();
    Ok(answer(arguments.json, &document, || {
        let mut table = Table::new(&["name", "A", "r", "note"]);
        for preset in &document.bodies {
            table.row([
                preset.name.clone(),
                preset.body.moments.join(","),
                preset.body.center.join(","),
                preset.note.clone(),
            ]);
        }
        table.text()
    })?)
}
