//! Pictures as SVG, PNG, PDF and TikZ.

use bifdiag_plot::{DiagramOptions, DiagramTitle, DiagramView, LegendPlace, Picture, PlotError, Theme, Width};
use bifdiag_schema::WindowDocument;
use clap::builder::{EnumValueParser, TypedValueParser};
use clap::{Args, ValueEnum};

use crate::cli::failure::Failure;
use crate::cli::input::values::{Named, float, named};

/// Dots per inch of a PNG in print.
const RESOLUTION: f64 = 300.0;

/// Formats of pictures.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum PictureFormat {
    Svg,
    Png,
    #[value(hide = !Picture::MAKES_PDF)]
    Pdf,
    /// A TikZ picture for \input
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
    /// Formats: svg, png, tikz; pdf with the feature `pdf`
    #[arg(long, value_parser = PictureFormat::parser(), value_delimiter = ',', default_value = "svg", help_heading = "Output")]
    #[arg(hide_possible_values = true)]
    pub format: Vec<PictureFormat>,
    /// Colours of the picture
    #[arg(long, value_parser = named(&THEMES), default_value = "light", help_heading = "Output", hide_possible_values = true)]
    #[arg(value_name = "light|dark|print", hide_short_help = true)]
    pub theme: Theme,
    /// Resolution of png, in dots per inch of print
    #[arg(long, value_name = "N", value_parser = resolution, allow_hyphen_values = true, default_value_t = RESOLUTION)]
    #[arg(help_heading = "Output", hide_short_help = true)]
    pub dpi: f64,
    /// Make tikz a standalone LaTeX document
    #[arg(long, help_heading = "Output", hide_short_help = true)]
    pub standalone: bool,
}

impl PictureArguments {
    /// One format, with the defaults for everything else.
    pub fn plain(format: PictureFormat) -> Self {
        Self { format: vec![format], theme: Theme::Light, dpi: RESOLUTION, standalone: false }
    }

    /// A picture in one of the formats.
    pub fn bytes(&self, format: PictureFormat, picture: &Picture) -> Result<Vec<u8>, Failure> {
        Ok(match format {
            PictureFormat::Svg => picture.svg.clone().into_bytes(),
            PictureFormat::Png => picture.to_png(self.dpi)?,
            PictureFormat::Pdf => picture.to_pdf()?,
            PictureFormat::Tikz if self.standalone => picture.to_latex()?.into_bytes(),
            PictureFormat::Tikz => picture.to_tikz()?.into_bytes(),
        })
    }
}

/// A resolution that a journal may ask for.
fn resolution(text: &str) -> Result<f64, Failure> {
    const RANGE: std::ops::RangeInclusive<f64> = 30.0..=2400.0;
    let dpi = float(text)?;
    let wrong = || Failure::input(format!("{text}: a resolution has between 30 and 2400 dots per inch, such as 600"));
    RANGE.contains(&dpi).then_some(dpi).ok_or_else(wrong)
}

/// Coordinates of a bifurcation diagram.
const VIEWS: [Named<DiagramView>; 3] = [
    ("auto", "straight where plane would need more than two insets or be too high", DiagramView::Auto),
    ("plane", "h to the right, l upwards, with insets", DiagramView::Plane),
    ("straight", "l to the right, h upwards, each region as high as its label needs", DiagramView::Straight),
];

/// Places of a legend.
const LEGENDS: [Named<LegendPlace>; 4] = [
    ("auto", "below, as long as the picture is not higher than a page (120 mm at 86 mm), else file", LegendPlace::Auto),
    ("none", "in words only, in the caption", LegendPlace::None),
    ("below", "in the picture", LegendPlace::Below),
    ("file", "in a picture of its own, and in the caption", LegendPlace::Apart),
];

/// How a bifurcation diagram is drawn.
#[derive(Clone, Debug, Args)]
pub struct DiagramArguments {
    #[command(flatten)]
    pub width: WidthArgument,
    /// Draw the plane with insets, or h over l straightened so that every region can be seen
    #[arg(long, value_parser = named(&VIEWS), default_value = "auto", help_heading = "Output", hide_possible_values = true)]
    #[arg(value_name = "plane|straight|auto", hide_short_help = true)]
    pub view: DiagramView,
    /// Omit the dots at the samples of the regions, as the straightened plane does
    #[arg(long, help_heading = "Output", hide_short_help = true)]
    pub no_samples: bool,
    /// Put the legend below the diagram, into a separate picture, or nowhere; FILE.caption.txt and .tex hold what is
    /// left out
    #[arg(long, value_parser = named(&LEGENDS), default_value = "auto", help_heading = "Output", hide_possible_values = true)]
    #[arg(value_name = "auto|none|below|file", hide_short_help = true)]
    pub legend: LegendPlace,
    /// Title above the diagram in place of the body, or none
    #[arg(long, value_name = "TEXT|none", help_heading = "Output", hide_short_help = true)]
    pub title: Option<String>,
    /// Put the table of small motions below the diagram, if it fits, instead of into the caption
    #[arg(long, help_heading = "Output", hide_short_help = true)]
    pub table: bool,
}

impl DiagramArguments {
    /// Refuses what the straightened plane cannot show.
    pub fn check(&self, window: Option<WindowDocument>) -> Result<(), Failure> {
        if self.view == DiagramView::Straight && window.is_some() {
            let why = "shows the whole plane and --window only a part of it; leave out one of them";
            return Err(Failure::input(format!("--view straight {why}")));
        }
        Ok(())
    }

    /// How the diagram is drawn.
    pub fn options(&self, window: Option<WindowDocument>, theme: Theme) -> DiagramOptions {
        let title = match self.title.as_deref() {
            None => DiagramTitle::Body,
            Some("none" | "") => DiagramTitle::None,
            Some(text) => DiagramTitle::Text(text.to_owned()),
        };
        let Self { view, no_samples, legend, table, .. } = *self;
        DiagramOptions { window, points: None, theme, width: self.width.width, view, no_samples, legend, title, table }
    }
}

/// For what width a picture is laid out.
#[derive(Clone, Debug, Args)]
pub struct WidthArgument {
    /// Printed width of the picture, in mm, cm, in or TeX's pt; sections and spheres may be some per cent narrower; its letters have at least 6 pt
    #[arg(long, value_parser = width, default_value = "178mm", help_heading = "Output")]
    #[arg(value_name = "LENGTH", allow_hyphen_values = true, hide_short_help = true)]
    pub width: Width,
}

/// Units of a width, in millimetres; pt is that of TeX, as `\the\columnwidth` has it.
const UNITS: [(&str, f64); 5] = [("mm", 1.0), ("cm", 10.0), ("in", 25.4), ("pt", 25.4 / 72.27), ("bp", 25.4 / 72.0)];

/// A width with its unit.
fn width(text: &str) -> Result<Width, Failure> {
    let [least, most] = Width::RANGE;
    let wrong = |why: &str| {
        Failure::input(format!(
            "{why}; a width is a length from {least}mm to {most}mm with its unit (mm, cm, in, pt), such as 86mm or 246pt"
        ))
    };
    let unit = UNITS.into_iter().find_map(|(unit, size)| Some((text.trim().strip_suffix(unit)?, size)));
    let (number, size) = unit.ok_or_else(|| wrong("it has none of the units of a width"))?;
    let length = float(number.trim()).map_err(|error| wrong(&error.to_string()))?;
    let millimetres = (length * size * 1e3).round() / 1e3;
    Width::new(millimetres).ok_or_else(|| wrong(&format!("{} is out of range", text.trim())))
}
