//! `bifdiag atlas`, the main job: the table of regions, `atlas.json` and the diagram.

use std::path::{Path, PathBuf};

use documents::{DocumentOptions, certified_atlas};
use plot::{CurveSource, DiagramOptions, Picture, draw};
use proof::CertifiedAtlas;
use schema::{Accuracy, AtlasDocument, ComponentDocument, RegionDocument};
use top::atlas::Atlas;

use super::arguments::{AtlasArguments, Format};
use super::failure::{Failure, InputError};
use super::files::FileSet;
use super::report::Report;
use super::subject::Subject;
use super::table::{Table, significant};
use super::timings::Timings;
use super::{DEFAULT_DIRECTORY, layout, output};

/// How much farther than usual a draft's polylines may lie from their curves.
const DRAFT_COARSENING: f64 = 8.0;

/// The table of regions fits a terminal of this width.
const TABLE_WIDTH: usize = 100;

/// Dots per inch of a PNG.
const PNG_RESOLUTION: f64 = 192.0;

pub fn run(arguments: &AtlasArguments, timings: &Timings) -> Result<(), Failure> {
    let accuracy = arguments.accuracy.level();
    let subject = arguments.body.subject()?;
    let directory = directory(arguments)?;
    let (atlas, document) = if accuracy == Accuracy::Certified {
        let proof = timings.stage("proof", || CertifiedAtlas::new(&subject.body))?;
        let drawn = proof.drawn()?;
        let mut document =
            timings.stage("certificate", || certified_atlas(&proof, &drawn, &DocumentOptions::default()))?;
        if subject.inertia.is_some() {
            attach_part(&mut document, &subject);
            documents::seal(&mut document)?;
        }
        (drawn, document)
    } else {
        let atlas = timings.stage("regions", || Atlas::new(&subject.body))?;
        let mut options = DocumentOptions { window: arguments.window, accuracy, ..DocumentOptions::default() };
        if accuracy == Accuracy::Draft {
            options.chord_tolerance *= DRAFT_COARSENING;
        }
        let mut document = timings.stage("curves", || documents::atlas::document(&atlas, &options));
        attach_part(&mut document, &subject);
        (atlas, document)
    };
    tracing::info!(
        regions = document.summary.regions,
        events = document.summary.events,
        undecided = document.summary.undecided.len(),
        "atlas made"
    );
    let json = layout::text(&document)?;

    let mut written = Vec::new();
    if let Some(directory) = directory {
        let mut files = FileSet::new(directory);
        files.add("atlas.json", json.as_str());
        if !arguments.no_plot {
            let options = DiagramOptions { window: arguments.window };
            let picture = timings.stage("diagram", || draw(&document, Some(&Curves(&atlas)), &options))?;
            add_picture(&mut files, "diagram", &picture, &arguments.format, timings)?;
        }
        written = timings.stage("files", || files.write())?;
    }
    let text = if arguments.json { json } else { report(&subject, &document, &written) };
    Ok(output::print(text.as_bytes())?)
}

/// Polylines as fine as a magnification needs.
pub struct Curves<'a>(pub &'a Atlas);

impl CurveSource for Curves<'_> {
    fn polyline(&self, curve: &str, l: [f64; 2], tolerance: f64) -> Option<Vec<[f64; 2]>> {
        self.0.polyline(curve.parse().ok()?, l, tolerance)
    }
}

/// The directory to write to, if any.
fn directory(arguments: &AtlasArguments) -> Result<Option<&Path>, InputError> {
    match &arguments.out {
        Some(directory) if directory == Path::new("-") => Err(InputError::OutIsStdout),
        Some(directory) => Ok(Some(directory)),
        None if arguments.json => Ok(None),
        None => Ok(Some(Path::new(DEFAULT_DIRECTORY))),
    }
}

/// The part that was given; what it can be is decided on its own tensor, not on rounded moments.
fn attach_part(document: &mut AtlasDocument, subject: &Subject) {
    if let Some(inertia) = &subject.inertia {
        document.body.flags.unphysical = inertia.unphysical;
        document.body.flags.plate = inertia.plate;
        document.body.inertia = Some(inertia.clone());
    }
}

/// Adds a picture in every format that is wanted.
pub fn add_picture(
    files: &mut FileSet,
    stem: &str,
    picture: &Picture,
    formats: &[Format],
    timings: &Timings,
) -> Result<(), Failure> {
    for format in formats {
        match format {
            Format::Svg => files.add(format!("{stem}.svg"), picture.svg.as_str()),
            Format::Png => files.add(format!("{stem}.png"), timings.stage("png", || picture.to_png(PNG_RESOLUTION))?),
            Format::Pdf => files.add(format!("{stem}.pdf"), timings.stage("pdf", || picture.to_pdf())?),
        }
    }
    Ok(())
}

/// Everything that the terminal shows.
fn report(subject: &Subject, document: &AtlasDocument, written: &[PathBuf]) -> String {
    let mut report = Report::default();
    subject.head(&mut report);
    report.line("");
    report.line(region_table(&document.regions));
    report.line("");
    let summary = &document.summary;
    let count = |n: usize, one: &str, many: &str| format!("{n} {}", if n == 1 { one } else { many });
    report.line(format!(
        "{}, {}, at most {} at one l",
        count(summary.regions, "region", "regions"),
        count(summary.events, "event", "events"),
        count(summary.critical_points_max, "relative equilibrium", "relative equilibria"),
    ));
    match (summary.complete, document.window) {
        (true, _) => {}
        (false, Some(_)) => report.line("the window was searched, not the whole half-plane l > 0"),
        (false, None) => report.line("the half-plane l > 0 is not covered completely"),
    }
    if let Some(certificate) = &document.certificate {
        let topology = if summary.undecided.is_empty() { " and the topology of each" } else { "" };
        report.line(format!(
            "proved: the number of regions{topology} ({} bits sufficed); check with bifdiag verify",
            certificate.bits
        ));
    }
    if summary.undecided.is_empty() {
        report.line("nothing was left undecided");
    }
    for undecided in &summary.undecided {
        report.line(format!(
            "undecided: {} near l = {}, h = {} ({})",
            undecided.what,
            significant(undecided.l, 8),
            significant(undecided.h, 8),
            undecided.curves.join(", "),
        ));
    }
    for path in written {
        report.line(format!("written: {}", path.display()));
    }
    report.text()
}

/// The table of regions, with as many digits as fit.
fn region_table(regions: &[RegionDocument]) -> String {
    let tables = [6, 5, 4, 3, 2].map(|digits| region_rows(regions, digits));
    let [.., narrowest] = &tables;
    tables.iter().find(|table| table.width() <= TABLE_WIDTH).unwrap_or(narrowest).text()
}

fn region_rows(regions: &[RegionDocument], digits: usize) -> Table {
    let mut table = Table::new(&["id", "signature", "U", "E", "P", "genus", "sample (h, l)", "width", "l-range"]);
    for region in regions {
        let column = |cell: &dyn Fn(&ComponentDocument) -> String| {
            region.components.iter().map(cell).collect::<Vec<_>>().join("\n")
        };
        let number = |x: Option<f64>, missing: &str| x.map_or(missing.to_owned(), |x| significant(x, digits));
        let [from, to] = region.l_range;
        table.row([
            if region.clipped { format!("{}*", region.id) } else { region.id.clone() },
            wrapped_signature(region.signature.as_deref().unwrap_or("-")),
            column(&|component| component.accessible_region.clone()),
            column(&|component| component.energy_surface.clone()),
            column(&|component| component.section.clone().unwrap_or_else(|| "-".to_owned())),
            column(&|component| component.genus.map_or_else(|| "-".to_owned(), |genus| genus.to_string())),
            format!("({}, {})", significant(region.sample.h, digits), significant(region.sample.l, digits)),
            number(region.h_width, "inf"),
            format!("{}..{}", number(from, "?"), number(to, "inf")),
        ]);
    }
    table
}

/// A signature on lines of at most twelve characters, broken at its plus signs.
fn wrapped_signature(signature: &str) -> String {
    const WIDTH: usize = 12;
    let mut lines: Vec<String> = Vec::new();
    for piece in signature.split_inclusive('+') {
        match lines.last_mut() {
            Some(line) if line.len() + piece.len() <= WIDTH => line.push_str(piece),
            _ => lines.push(piece.to_owned()),
        }
    }
    lines.join("\n")
}

#[cfg(test)]
mod tests {
    use schema::{MarginDocument, SampleDocument};
    use top::topology::{Component, Poles, signature};

    use super::*;

    fn region(id: &str, components: &[Component], sample: [f64; 2]) -> RegionDocument {
        let margin = MarginDocument { h: 1e-3, nearest: "P+".to_owned(), error_bound: 1e-15 };
        RegionDocument {
            id: id.to_owned(),
            sample: SampleDocument { h: sample[0], l: sample[1], margin },
            components: documents::candidate(components),
            signature: signature(components),
            bounded: true,
            l_range: [Some(sample[1] / 3.0), Some(sample[1] / 0.7)],
            h_width: Some(sample[0] / 7.0),
            boundary: Vec::new(),
            neighbours: Vec::new(),
            cells: Vec::new(),
            clipped: false,
        }
    }

    #[test]
    fn the_table_fits_whatever_the_regions_are() {
        let poles = |plus, minus| Some(Poles { plus, minus });
        let component = |boundary_circles, poles| Component { boundary_circles, poles };
        let many = [component(1, poles(false, false)); 5];
        let regions = [
            region("R1", &[component(0, poles(true, true))], [-1.0 / 3.0, 1e-6 / 3.0]),
            region("R128", &many, [1.0 / 3.0 * 1e16, 1e8 / 3.0]),
            region("R3", &[component(3, poles(true, false)), component(1, poles(false, true))], [-1e-7 / 3.0, 0.1]),
            region("R4", &[component(2, None)], [1.0, 2.0]),
        ];
        let text = region_table(&regions);
        assert!(text.lines().all(|line| line.chars().count() <= TABLE_WIDTH), "{text}");
        for name in ["S2+S2+S2+S2+", "(S1xS2)#(S1xS2)", "M3", "RP3"] {
            assert!(text.contains(name), "{name} is missing in\n{text}");
        }
    }

    #[test]
    fn signatures_break_at_plus_signs() {
        assert_eq!(wrapped_signature("S2+T2"), "S2+T2");
        assert_eq!(wrapped_signature("S2+S2+T2+T2+M2"), "S2+S2+T2+T2+\nM2");
    }
}
