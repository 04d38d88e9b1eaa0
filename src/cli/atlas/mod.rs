//! `bifdiag atlas`, the main job: the table of regions, `atlas.json` and the diagram.

mod report;

use std::borrow::Cow;
use std::path::PathBuf;

use bifdiag_diagram::atlas::Atlas;
use bifdiag_documents::{DocumentOptions, Subject, attach_part, certified_atlas_of};
use bifdiag_exact::CertifiedAtlas;
use bifdiag_plot::draw_figure;
use bifdiag_schema::{Accuracy, AtlasDocument, WindowDocument};
use clap::Args;

use super::export::{DiagramArguments, FileSet, PictureArguments, answer, directory};
use super::failure::{Failure, failed};
use super::input::{BodyArguments, accuracy, values};
use super::terminal::Timings;
use crate::Curves;

pub use report::{STRAY, inner_sample, stray_sample, strays, width_error};

pub const EXAMPLES: &str = "\
Examples:
  bifdiag atlas --A 2,1.1,1 --r 0.94868,0,0.61623
  bifdiag atlas --body katok:7 --window 0:4,0:3 --format png --out katok7
  bifdiag atlas --A 2,11/10,1 --r=-1,0,1/2 --json > atlas.json
  bifdiag atlas --inertia 0.30,0.21,0.17,0.01,0,-0.02 --products tensor \\
      --com 0,0.02,0.15 --mass 2.5 --g 9.80665 --no-plot";

/// `bifdiag atlas`.
#[derive(Debug, Args)]
pub struct AtlasArguments {
    #[command(flatten)]
    pub body: BodyArguments,
    /// Compute only this part of the plane
    #[arg(long, value_name = "hmin:hmax,lmin:lmax", allow_hyphen_values = true, value_parser = values::window)]
    #[arg(help_heading = "Work", hide_short_help = true)]
    pub window: Option<WindowDocument>,
    /// Required accuracy of the answer
    #[arg(long, value_parser = accuracy(), default_value = "exact", help_heading = "Work", hide_short_help = true)]
    pub accuracy: Accuracy,
    /// Prove every step and record what `bifdiag verify` needs to check it
    #[arg(long, help_heading = "Work", hide_short_help = true)]
    pub certificate: bool,
    /// Write atlas.json and the diagram to DIR (default: bifdiag-out)
    #[arg(long, value_name = "DIR", help_heading = "Output")]
    pub out: Option<PathBuf>,
    #[command(flatten)]
    pub picture: PictureArguments,
    #[command(flatten)]
    pub diagram: DiagramArguments,
    /// Draw nothing
    #[arg(long, help_heading = "Output", hide_short_help = true)]
    pub no_plot: bool,
    /// Leave polylines, polygons, widths and views out of atlas.json
    #[arg(long, help_heading = "Output", hide_short_help = true)]
    pub no_drawing: bool,
    /// Print the atlas as JSON
    #[arg(long, help_heading = "Output")]
    pub json: bool,
}

pub fn run(arguments: &AtlasArguments, timings: &Timings) -> Result<(), Failure> {
    if arguments.certificate && arguments.window.is_some() {
        let why = "covers the whole plane and --window only a part of it; leave out one of them";
        return Err(Failure::input(format!("--certificate {why}")));
    }
    if arguments.certificate && arguments.accuracy == Accuracy::Fast {
        let why = "needs exact answers, which --accuracy fast does not give; leave out one of them";
        return Err(Failure::input(format!("--certificate {why}")));
    }
    arguments.diagram.check(arguments.window)?;
    let subject = arguments.body.subject()?;
    let directory = directory(arguments.out.as_deref(), !arguments.json)?;
    let (atlas, document) = atlas(arguments, &subject, timings)?;
    tracing::info!(
        regions = document.summary.regions,
        events = document.summary.events,
        undecided = document.summary.undecided.len(),
        "atlas made"
    );
    // Pictures and the table of regions need the drawing.
    let mut stored = Cow::Borrowed(&document);
    if arguments.no_drawing {
        bifdiag_documents::leave_out_drawing(stored.to_mut(), &subject)?;
    }
    let mut written = Vec::new();
    if let Some(directory) = &directory {
        let mut files = FileSet::new(directory);
        files.json("atlas", &*stored)?;
        files.remove_pictures("diagram");
        // A window without a region would be an empty frame.
        if !arguments.no_plot && !document.regions.is_empty() {
            let options = arguments.diagram.options(arguments.window, arguments.picture.theme);
            let figure = timings.stage("diagram", || draw_figure(&document, Some(&Curves(&atlas)), &options))?;
            files.figure("diagram", figure, &arguments.picture, timings)?;
        }
        written = timings.stage("files", || files.write())?;
    }
    answer(arguments.json, &*stored, || report::text(&subject, &atlas, &document, &written))
}

/// The atlas of a body, to draw it, and its document.
fn atlas(arguments: &AtlasArguments, subject: &Subject, timings: &Timings) -> Result<(Atlas, AtlasDocument), Failure> {
    if arguments.certificate {
        let proof = timings.stage("proof", || CertifiedAtlas::new(&subject.body));
        let proof = proof.map_err(failed("the atlas could not be proved"))?;
        let drawn = proof.to_atlas().map_err(failed("the atlas could not be made"))?;
        let options = DocumentOptions::default();
        let document = timings.stage("certificate", || certified_atlas_of(subject, &proof, &drawn, &options));
        return Ok((drawn, document.map_err(failed("the proved atlas could not be written"))?));
    }
    let accuracy = arguments.accuracy;
    let atlas = timings.stage("regions", || bifdiag_exact::atlas(&subject.body, accuracy));
    let atlas = atlas.map_err(failed("the atlas could not be made"))?;
    let options = DocumentOptions { window: arguments.window, accuracy, ..DocumentOptions::default() };
    let mut document = timings.stage("curves", || bifdiag_documents::atlas::document(&atlas, &options));
    attach_part(&mut document, subject);
    timings.stage("verdicts", || bifdiag_documents::atlas::attach_verdict_changes(&mut document, &atlas));
    Ok((atlas, document))
}
