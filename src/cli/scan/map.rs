//! `bifdiag scan map`: the class of each body over two parameters.

use bifdiag_documents::scan::ReadScanError;
use bifdiag_plot::{Figure, Picture, draw_map};
use bifdiag_schema::BodyParameter;

use super::arguments::MapArguments;
use super::output;
use crate::cli::export::FileSet;
use crate::cli::failure::Failure;
use crate::cli::terminal::{Report, Timings, print};
use crate::pictures::{Seen, map};

pub fn run(arguments: &MapArguments, timings: &Timings) -> Result<(), Failure> {
    if arguments.x == arguments.y {
        let (axis, all) = (arguments.y, BodyParameter::ALL.map(BodyParameter::name).join(", "));
        return Err(Failure::input(format!("--y {axis}: both axes show the same parameter; choose two of {all}")));
    }
    let file = &arguments.file;
    let format = output::format_of_input(file)?;
    if output::summary_path(file).exists() {
        output::checked_summary(file)?;
    } else {
        tracing::warn!("{} has no summary beside it: its rows may be incomplete", file.display());
    }
    let table = |error: Failure| Failure::input(format!("{}: {error}", file.display()));
    let mut bodies = Vec::new();
    for row in format.rows(file).map_err(table)? {
        let row = row.map_err(table)?;
        let not_a_row = |error: ReadScanError| {
            let (path, body) = (file.display(), row.index);
            Failure::input(format!("{path}: body {body}: {error}; name a file with the rows of a scan")).because(error)
        };
        let axes = [arguments.x, arguments.y];
        bodies.push(Seen::new(&bifdiag_documents::scan::read_row(&row).map_err(not_a_row)?, axes, arguments.show));
    }
    let axes = [("--x", arguments.x), ("--y", arguments.y)];
    if bodies.is_empty() {
        let path = file.display();
        return Err(Failure::input(format!("{path}: it contains no bodies; name a file with the rows of a scan")));
    }
    for (place, (option, parameter)) in axes.into_iter().enumerate() {
        if bodies.iter().all(|body| body.at[place] == bodies[0].at[place]) {
            let path = file.display();
            return Err(Failure::input(format!("{option} {parameter}: it is the same for all bodies of {path}")));
        }
    }
    let map = map(&bodies, [arguments.x, arguments.y], arguments.show);
    let picture = timings.stage("map", || draw_map(&map, arguments.picture.theme, arguments.width.width))?;
    if picture.millimetres_high() > Picture::HIGHEST {
        tracing::warn!(
            "the picture is {:.0} mm high, more than the {} mm of a page: its legend has {} entries; a map over \
            smaller ranges, or --show regions, has fewer{}",
            picture.millimetres_high(),
            Picture::HIGHEST,
            map.entries.len(),
            if arguments.width.width.is_column() { ", and --width 178mm makes it lower" } else { "" },
        );
    }
    let mut files = FileSet::new(&arguments.out);
    files.remove_pictures("map");
    files.figure("map", Figure { picture, legend: None, caption: map.caption() }, &arguments.picture, timings)?;
    print(Report::of_written(&files.write()?).text())
}
