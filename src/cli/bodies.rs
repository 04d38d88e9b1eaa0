//! `bifdiag bodies`: the named bodies.

use super::arguments::BodiesArguments;
use super::failure::Failure;
use super::table::Table;
use super::{layout, output};

pub fn run(arguments: &BodiesArguments) -> Result<(), Failure> {
    let document = documents::all_bodies();
    if arguments.json {
        return Ok(output::print(layout::text(&document)?.as_bytes())?);
    }
    let mut table = Table::new(&["name", "A", "r", "note"]);
    for preset in &document.bodies {
        table.row([preset.name.clone(), preset.moments.join(","), preset.center.join(","), preset.note.clone()]);
    }
    Ok(output::print(table.text().as_bytes())?)
}
