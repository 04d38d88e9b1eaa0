//! Pictures as SVG, PNG, PDF and TikZ.

use bifdiag_plot::{DiagramView, Picture, PlotError, Theme, Width};
use clap::builder::{EnumValueParser, TypedValueParser};
use clap::{Args, ValueEnum};

use crate::cli::failure::Failure;
use crate::cli::input::values::{Named, named};

/// Dots per inch of a PNG in print.
const RESOLUTION: f64 = 300.0;

/// Formats of pictures.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum PictureFormat {
    Svg,
    Png,
    #[value(hide = !Picture::MAKES_PDF)]
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

    /// What the names of its files end with.
    pub fn ending(self) -> &'static str {
        match self {
            Self::Svg => "svg",
            Self::Png => "png",
            Self::Pdf => "pdf",
            Self::Tikz => "tikz",
        }
    }

    /// A picture in this format.
    pub fn bytes(self, picture: &Picture) -> Result<Vec<u8>, Failure> {
        Ok(match self {
            Self::Svg => picture.svg.clone().into_bytes(),
            Self::Png => picture.to_png(RESOLUTION)?,
            Self::Pdf => picture.to_pdf()?,
            Self::Tikz => picture.to_tikz()?.into_bytes(),
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
    /// Formats of the picture; pdf needs the feature `pdf`
    #[arg(long, value_parser = PictureFormat::parser(), value_delimiter = ',', default_value = "svg", help_heading = "Output")]
    pub format: Vec<PictureFormat>,
    /// Colours of the picture
    #[arg(long, value_parser = named(&THEMES), default_value = "light", help_heading = "Output", hide_possible_values = true)]
    #[arg(value_name = "light|dark|print", hide_short_help = true)]
    pub theme: Theme,
}

/// Coordinates of a bifurcation diagram.
const VIEWS: [Named<DiagramView>; 3] = [
    ("auto", "straight where plane would need more than two insets", DiagramView::Auto),
    ("plane", "h to the right, l upwards, with insets", DiagramView::Plane),
    ("straight", "l to the right, h upwards, each region as high as its label needs", DiagramView::Straight),
];

/// How a bifurcation diagram is drawn.
#[derive(Clone, Debug, Args)]
pub struct DiagramArguments {
    /// Draw h over l, straightened so that every region can be seen, or the plane with insets
    #[arg(long, value_parser = named(&VIEWS), default_value = "auto", help_heading = "Output", hide_possible_values = true)]
    #[arg(value_name = "plane|straight|auto", hide_short_help = true)]
    pub view: DiagramView,
    /// Leave the dots at the samples of the regions out
    #[arg(long, help_heading = "Output", hide_short_help = true)]
    pub no_samples: bool,
}

/// The widths of a journal's page.
const WIDTHS: [Named<Width>; 2] =
    [("178mm", "Both columns of a journal", Width::Page), ("86mm", "One column", Width::Column)];

/// For what width a picture is laid out.
#[derive(Clone, Debug, Args)]
pub struct WidthArgument {
    /// Width of the picture in print: both columns of a journal or one; letters have at least 6 pt there
    #[arg(long, value_parser = named(&WIDTHS), default_value = "178mm", help_heading = "Output", hide_possible_values = true)]
    #[arg(value_name = "178mm|86mm", hide_short_help = true)]
    pub width: Width,
}
