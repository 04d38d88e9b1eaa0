//! What the options ask for.

use std::path::PathBuf;

use bifdiag_plot::{Theme, Width};
use bifdiag_schema::{Accuracy, WindowDocument};

use super::arguments::AtlasArguments;
use super::error::AtlasInput;
use crate::cli::export::{PictureFormat, directory};
use crate::cli::failure::Failure;
use bifdiag_documents::Subject;

pub struct Settings {
    pub subject: Subject,
    pub accuracy: Accuracy,
    /// The atlas carries its certificate.
    pub certificate: bool,
    pub window: Option<WindowDocument>,
    /// Where the files go, if any are wanted.
    pub directory: Option<PathBuf>,
    /// Of the diagram.
    pub formats: Vec<PictureFormat>,
    pub theme: Theme,
    pub width: Width,
    /// Whether the document carries its drawing.
    pub drawing: bool,
    pub json: bool,
}

impl Settings {
    pub fn new(arguments: &AtlasArguments) -> Result<Self, Failure> {
        if arguments.no_polygons {
            return Err(AtlasInput::NoPolygons.into());
        }
        if arguments.certificate && arguments.window.is_some() {
            return Err(AtlasInput::CertificateOfWindow.into());
        }
        if arguments.certificate && arguments.accuracy == Accuracy::Fast {
            return Err(AtlasInput::FastCertificate.into());
        }
        Ok(Self {
            subject: arguments.body.subject()?,
            accuracy: arguments.accuracy,
            certificate: arguments.certificate,
            window: arguments.window,
            directory: directory(arguments.out.as_deref(), !arguments.json)?,
            formats: if arguments.no_plot { Vec::new() } else { arguments.picture.format.clone() },
            theme: arguments.picture.theme,
            width: arguments.width.width(),
            drawing: !arguments.no_drawing,
            json: arguments.json,
        })
    }
}
