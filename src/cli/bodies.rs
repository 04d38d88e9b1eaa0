//! `bifdiag bodies`: the named bodies.

use bifdiag::body::Number;
use bifdiag::document::BodiesDocument;

use super::arguments::BodiesArguments;
use super::failure::Failure;
use super::table::Table;
use super::{layout, output};

pub fn run(arguments: &BodiesArguments) -> Result<(), Failure> {
    let document = BodiesDocument::all();
    if arguments.json {
        return Ok(output::print(layout::text(&document)?.as_bytes())?);
    }
    let join = |numbers: &[Number; 3]| numbers.each_ref().map(Number::text).join(",");
    let mut table = Table::new(&["name", "A", "r", "note"]);
    for preset in &document.bodies {
        table.row([preset.name.clone(), join(&preset.moments), join(&preset.center), preset.note.clone()]);
    }
    Ok(output::print(table.text().as_bytes())?)
}
