//! What a run writes: data, documents and pictures.

use std::path::{Path, PathBuf};

use schema::SectionDocument;

use super::arguments::SectionArguments;
use super::error::SectionInputError;
use super::sites::Sites;
use super::{Done, Sections, picture, report, table};
use crate::cli::atlas::add_picture;
use crate::cli::data::{DataFormat, DataTarget};
use crate::cli::failure::{Failure, InputError};
use crate::cli::files::FileSet;
use crate::cli::report::Report;
use crate::cli::timings::Timings;
use crate::cli::{DEFAULT_DIRECTORY, layout, output};

/// Where the results go.
pub struct Outputs<'a> {
    arguments: &'a SectionArguments,
    /// For everything but the data of `--data`.
    directory: Option<&'a Path>,
}

impl<'a> Outputs<'a> {
    /// Refuses what cannot be written before anything is computed.
    pub fn new(arguments: &'a SectionArguments, sites: usize) -> Result<Self, InputError> {
        if arguments.data == Some(DataTarget::Stdout) {
            if arguments.json {
                return Err(SectionInputError::TwoOnStdout.into());
            }
            if sites > 1 {
                return Err(SectionInputError::ManyOnStdout.into());
            }
        }
        let directory = match &arguments.out {
            Some(directory) if directory == Path::new("-") => return Err(InputError::OutIsStdout),
            Some(directory) => Some(directory.as_path()),
            None if arguments.json || arguments.data == Some(DataTarget::Stdout) => None,
            None if arguments.data.is_some() && arguments.no_plot => None,
            None => Some(Path::new(DEFAULT_DIRECTORY)),
        };
        Ok(Self { arguments, directory })
    }

    /// Writes the files, all or none, and then prints.
    pub fn write(&self, sites: &Sites, sections: &Sections, timings: &Timings) -> Result<(), Failure> {
        let mut files = FileSet::new(self.directory.unwrap_or(Path::new(".")));
        let mut csv = None;
        for section in &sections.done {
            let document = &section.document;
            match &self.arguments.data {
                Some(DataTarget::Stdout) => csv = Some(bytes(section, DataFormat::Csv)?),
                Some(DataTarget::File { path, format }) => {
                    let name = if sites.list.len() > 1 { of_region(path, document) } else { path.clone() };
                    files.add_at(&name, bytes(section, *format)?);
                }
                None => {}
            }
            if self.directory.is_some() {
                let stem = match &document.region {
                    Some(region) => format!("section-{region}"),
                    None => "section".to_owned(),
                };
                files.add(format!("{stem}.json"), layout::text(document)?);
                if self.arguments.data.is_none() {
                    files.add(format!("{stem}.npz"), bytes(section, DataFormat::Npz)?);
                }
                if !self.arguments.no_plot {
                    let picture =
                        timings.stage("picture", || picture::draw(self.arguments, &sites.subject, section))?;
                    add_picture(&mut files, &stem, &picture, &self.arguments.format, timings)?;
                }
            }
        }
        let written = timings.stage("files", || files.write())?;
        let text = match csv {
            Some(csv) => csv,
            None if self.arguments.json => self.json(sections)?.into_bytes(),
            None => text(sites, sections, &written).into_bytes(),
        };
        Ok(output::print(&text)?)
    }

    /// One document for one point, a list for an atlas.
    fn json(&self, sections: &Sections) -> Result<String, serde_json::Error> {
        let mut found = sections.done.iter().map(|section| section.document.clone());
        match (&self.arguments.atlas, found.next()) {
            (None, Some(document)) => layout::text(&document),
            (_, first) => {
                let all = first.into_iter().chain(found).collect();
                layout::text(&documents::sections(all, sections.skipped.clone(), sections.complete))
            }
        }
    }
}

fn bytes(section: &Done, format: DataFormat) -> Result<Vec<u8>, Failure> {
    Ok(table::of(&section.document, &section.orbits)?.bytes(format)?)
}

/// FILE-R4.npz for the region R4 of FILE.npz.
fn of_region(path: &Path, document: &SectionDocument) -> PathBuf {
    let stem = path.file_stem().unwrap_or_default().to_string_lossy();
    let region = document.region.as_deref().unwrap_or_default();
    let extension = path.extension().unwrap_or_default().to_string_lossy();
    path.with_file_name(format!("{stem}-{region}.{extension}"))
}

fn text(sites: &Sites, sections: &Sections, written: &[PathBuf]) -> String {
    let mut lines = Report::default();
    sites.subject.head(&mut lines);
    for section in &sections.done {
        report::add(&mut lines, &section.document);
    }
    for path in written {
        lines.line(format!("written: {}", path.display()));
    }
    lines.text()
}
