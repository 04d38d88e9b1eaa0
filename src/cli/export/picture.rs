//! Pictures as SVG, PNG, PDF and TikZ.

use bifdiag_plot::{Picture, PlotError, Theme, Width};
use clap::builder::{EnumValueParser, TypedValueParser};
use clap::{Args, ValueEnum};

use super::error::ExportError;
use super::exporter::Exporter;
use crate::cli::input::values::{Named, named};

/// Formats of pictures.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum PictureFormat {
    Svg,
    Png,
    Pdf,
    /// A LaTeX document of one TikZ picture
    Tikz,
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

/// For what pictures are coloured.
const THEMES: [Named<Theme>; 3] = [
    ("light", "Dark on white", Theme::Light),
    ("dark", "Light on a dark ground", Theme::Dark),
    ("print", "For paper and photocopies: pale grounds, darker lines", Theme::Print),
];

/// How pictures are written; every command that draws has these options.
#[derive(Clone, Debug, Args)]
pub struct PictureArguments {
    /// Formats of the picture
    #[arg(long, value_parser = PictureFormat::parser(), value_delimiter = ',', default_value = "svg", help_heading = "Output")]
    pub format: Vec<PictureFormat>,
    /// Colours of the picture
    #[arg(long, value_parser = named(&THEMES), default_value = "light", help_heading = "Output", hide_possible_values = true)]
    #[arg(value_name = "light|dark|print")]
    pub theme: Theme,
}

/// Widths of pictures in print
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum WidthName {
    #[value(name = "178mm")]
    Page,
    #[value(name = "86mm")]
    Column,
}

/// For what width a picture is laid out.
#[derive(Clone, Debug, Args)]
pub struct WidthArgument {
    /// Width of the picture in print: both columns of a journal or one; letters have at least 6 pt there
    #[arg(long, value_enum, default_value = "178mm", help_heading = "Output", hide_possible_values = true)]
    #[arg(value_name = "178mm|86mm")]
    width: WidthName,
}

impl WidthArgument {
    /// The width.
    pub fn width(&self) -> Width {
        match self.width {
            WidthName::Page => Width::Page,
            WidthName::Column => Width::Column,
        }
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
            PictureFormat::Tikz => "tikz",
        }
    }

    fn bytes(&self, picture: &Picture) -> Result<Vec<u8>, ExportError> {
        Ok(match self.format {
            PictureFormat::Svg => picture.svg.clone().into_bytes(),
            PictureFormat::Png => picture.to_png(self.resolution)?,
            PictureFormat::Pdf => picture.to_pdf()?,
            PictureFormat::Tikz => picture.to_tikz()?.into_bytes(),
        })
    }
}
