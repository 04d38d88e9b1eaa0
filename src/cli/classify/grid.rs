//! Many points at once: a grid of energies and momenta.

use std::path::{Path, PathBuf};

use bifdiag_diagram::atlas::Spot;
use bifdiag_documents::{GridAxis, Subject, grid};
use bifdiag_exact::{AnswerError, Solver};
use bifdiag_numbers::table::Id;
use bifdiag_schema::Accuracy;
use rayon::prelude::*;
use thiserror::Error;

use crate::cli::export::{Archive, ExportError, FileSet};
use crate::cli::failure::{CommandError, Exit, Failure};
use crate::cli::input::values::Grid;
use crate::cli::terminal::{Report, Timings, print};

/// Why there is no grid, or not all of it.
#[derive(Debug, Error)]
pub enum GridError {
    #[error("--grid needs --out FILE.npz or --out FILE.png")]
    NoOut,
    #[error("--out {path}: the extension tells the format; give FILE.npz or FILE.png", path = .0.display())]
    Format(PathBuf),
    #[error("--out is for --grid; leave it out")]
    OutAlone,
    #[error("--grid and {0} both say where; leave out one of them")]
    Both(&'static str),
    #[error("--grid: {0}")]
    Row(#[from] AnswerError),
    #[error("--grid: the atlas of this body was not finished within its budget")]
    NoAtlas,
    #[error("{0} points of the grid could not be answered; they are -3")]
    Undecided(usize),
}

impl CommandError for GridError {
    fn exit(&self) -> Exit {
        match self {
            Self::NoAtlas | Self::Undecided(_) => Exit::Failed,
            _ => Exit::WrongInput,
        }
    }
}

/// Formats of a grid.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum GridFormat {
    Npz,
    Png,
}

impl GridFormat {
    /// By the extension.
    pub fn of(out: Option<&Path>) -> Result<(Self, PathBuf), GridError> {
        let path = out.ok_or(GridError::NoOut)?;
        match path.extension().and_then(|extension| extension.to_str()) {
            Some("npz") => Ok((Self::Npz, path.to_owned())),
            Some("png") => Ok((Self::Png, path.to_owned())),
            _ => Err(GridError::Format(path.to_owned())),
        }
    }
}

/// What stands in the array `region`: the index of the region, or one of the codes of [`grid`].
fn code(spot: Spot) -> i32 {
    match spot {
        Spot::Region(region) => i32::try_from(region.index()).unwrap_or(i32::MAX),
        Spot::Forbidden => -1,
        Spot::Critical => -2,
        Spot::Undecided => -3,
    }
}

/// Computes the grid and writes it.
pub fn run(
    subject: &Subject,
    asked: &Grid,
    accuracy: Accuracy,
    (format, path): &(GridFormat, PathBuf),
    timings: &Timings,
) -> Result<(), Failure> {
    let prepared = Solver::new(subject.body.clone(), accuracy);
    let [h, l] = [&asked.h, &asked.l].map(GridAxis::values);
    let atlas = prepared.atlas().ok_or(GridError::NoAtlas)?;
    let rows: Result<Vec<Vec<Spot>>, AnswerError> =
        timings.stage("rows", || l.par_iter().map(|&l| prepared.row(l, &h).unwrap_or(Ok(Vec::new()))).collect());
    let codes: Vec<i32> = rows.map_err(GridError::from)?.into_iter().flatten().map(code).collect();
    let bytes = match format {
        GridFormat::Npz => {
            let ids: Vec<String> = atlas.regions().ids().map(|region| region.to_string()).collect();
            let meta =
                serde_json::to_string(&grid(subject, &asked.h, &asked.l, accuracy)).map_err(ExportError::from)?;
            archive(&h, &l, &codes, &ids, &meta).map_err(ExportError::from)?
        }
        GridFormat::Png => {
            let kinds: Vec<String> = atlas
                .regions()
                .iter()
                .map(|region| {
                    region.components.as_deref().ok().and_then(bifdiag_diagram::topology::signature).unwrap_or_default()
                })
                .collect();
            bifdiag_plot::draw_codes(h.len(), &codes, &kinds).map_err(ExportError::from)?
        }
    };
    let mut files = FileSet::new(Path::new("."));
    files.add_at(path, bytes);
    print(Report::of_written(&timings.stage("files", || files.write())?).text())?;
    let undecided = codes.iter().filter(|code| **code == -3).count();
    if undecided > 0 && accuracy == Accuracy::Exact {
        return Err(GridError::Undecided(undecided).into());
    }
    Ok(())
}

fn archive(h: &[f64], l: &[f64], codes: &[i32], ids: &[String], meta: &str) -> Result<Vec<u8>, zip::result::ZipError> {
    let mut archive = Archive::new();
    archive.floats("h", h)?;
    archive.floats("l", l)?;
    archive.matrix("region", l.len(), codes)?;
    archive.texts("regions", ids)?;
    archive.text("meta", meta)?;
    archive.bytes()
}
