//! Pictures as SVG, PNG and PDF.

use clap::ValueEnum;
use clap::builder::{EnumValueParser, TypedValueParser};
use plot::{Picture, PlotError};

use super::error::ExportError;
use super::exporter::Exporter;

/// Formats of pictures.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum PictureFormat {
    Svg,
    Png,
    Pdf,
}

impl PictureFormat {
    /// Refuses the formats that this build does not make.
    pub fn parser() -> impl TypedValueParser<Value = Self> {
        EnumValueParser::<Self>::new().try_map(|format| match format {
            Self::Pdf if !Picture::MAKES_PDF => Err(PlotError::NoPdf),
            format => Ok(format),
        })
    }
}

/// Dots per inch of a PNG if nothing else is wanted.
pub const RESOLUTION: f64 = 192.0;

/// A format with the dots per inch, where it has any.
pub struct PictureExporter {
    pub format: PictureFormat,
    pub resolution: f64,
}

impl Exporter<Picture> for PictureExporter {
    fn ending(&self) -> &'static str {
        match self.format {
            PictureFormat::Svg => "svg",
            PictureFormat::Png => "png",
            PictureFormat::Pdf => "pdf",
        }
    }

    fn bytes(&self, picture: &Picture) -> Result<Vec<u8>, ExportError> {
        Ok(match self.format {
            PictureFormat::Svg => picture.svg.clone().into_bytes(),
            PictureFormat::Png => picture.to_png(self.resolution)?,
            PictureFormat::Pdf => picture.to_pdf()?,
        })
    }
}
