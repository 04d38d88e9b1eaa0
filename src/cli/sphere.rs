//! `bifdiag sphere`: U on the Poisson sphere at one point, as a picture.

use std::path::PathBuf;

use bifdiag_body::{Body, Number};
use bifdiag_diagram::accessible::{AccessibleRegion, component_of};
use bifdiag_diagram::fast::FastError;
use bifdiag_diagram::topology::{Answer, Components};
use bifdiag_documents::{Subject, component};
use bifdiag_dynamics::field::dot;
use bifdiag_dynamics::poincare::components_at;
use bifdiag_equilibria::critical::critical;
use bifdiag_exact::{Accuracy, AnswerError, Solver, classify};
use bifdiag_plot::{Picture, SphereScene, body_line, draw_sphere, value_text};
use bifdiag_schema::ComponentDocument;
use clap::Args;

use super::atlas::stray_sample;
use super::export::{FileSet, PictureArguments, WidthArgument, directory};
use super::failure::{Failure, failed};
use super::input::{BodyArguments, PointArguments, head, values};
use super::section::poincare_failure;
use super::terminal::{Report, Timings, print};

pub const EXAMPLES: &str = "\
Examples:
  bifdiag sphere --body paper --h 4.45 --l 3.25
  bifdiag sphere --body paper --region R4 --format svg,png
  bifdiag sphere --A 2,2,1 --r 1,0,0 --h 3.4 --l 2.87 --view 0,0,1 --out annulus

The picture shows the Poisson sphere from two opposite sides; its points γ are the directions of gravity in \
principal axes. \
U is tinted: a component with k boundary circles and n of the poles ±r̂ has a section of genus k + n − 1 above it.";

/// `bifdiag sphere`.
#[derive(Debug, Args)]
pub struct SphereArguments {
    #[command(flatten)]
    pub body: BodyArguments,
    #[command(flatten)]
    pub point: PointArguments,
    /// Use the sample point of this region instead of --h and --l
    #[arg(long, value_name = "ID", conflicts_with_all = ["energy", "momentum"], help_heading = "Point")]
    pub region: Option<String>,
    /// Direction from which the first view is taken, in principal axes (default: one whose rim cuts U least)
    #[arg(long, value_name = "x,y,z", allow_hyphen_values = true, value_parser = values::direction)]
    #[arg(help_heading = "Output", hide_short_help = true)]
    pub view: Option<[f64; 3]>,
    /// Write the picture to DIR (default: bifdiag-out)
    #[arg(long, value_name = "DIR", help_heading = "Output")]
    pub out: Option<PathBuf>,
    #[command(flatten)]
    pub picture: PictureArguments,
    #[command(flatten)]
    pub width: WidthArgument,
}

/// A point at which U is drawn.
struct Site {
    /// The region whose sample it is.
    region: Option<String>,
    h: Number,
    l: Number,
}

impl Site {
    /// The point of the options.
    fn new(arguments: &SphereArguments, subject: &Subject) -> Result<Self, Failure> {
        if let Some(id) = &arguments.region {
            let atlas = bifdiag_exact::atlas(&subject.body, Accuracy::Exact)
                .map_err(failed("the regions of this body could not be found"))?;
            let ids = || atlas.regions().ids();
            let Some(region) = ids().find(|region| region.to_string() == *id) else {
                let known: Vec<String> = ids().map(|id| id.to_string()).collect();
                let regions = if known.len() == 1 { "only the region" } else { "the regions" };
                let known = known.join(", ");
                return Err(Failure::input(format!("--region {id}: the atlas of this body has {regions} {known}")));
            };
            let sample = atlas.sample(region);
            if Solver::of(atlas, Accuracy::Exact).is_outside(region, [sample.h, sample.l]) {
                return Err(stray_sample(id));
            }
            let number = |x| Number::from_f64(x).map_err(failed("the sample of the region is beyond f64"));
            return Ok(Self { region: Some(id.clone()), h: number(sample.h)?, l: number(sample.l)? });
        }
        let given = |number: &Option<Number>, missing| {
            let needed = "a point such as --h 4.45 --l 3.25, or a region such as --region R4, is needed";
            number.clone().ok_or_else(|| Failure::input(format!("{missing} is missing: {needed}")))
        };
        Ok(Self {
            region: None,
            h: given(&arguments.point.energy, "--h")?,
            l: given(&arguments.point.momentum, "--l")?,
        })
    }
}

pub fn run(arguments: &SphereArguments, timings: &Timings) -> Result<(), Failure> {
    let subject = arguments.body.subject()?;
    let directory = directory(arguments.out.as_deref(), true)?.unwrap_or_default();
    let (picture, caption) = timings.stage("picture", || draw(&subject, arguments))?;
    let mut files = FileSet::new(&directory);
    files.pictures("sphere", &picture, &arguments.picture, timings)?;
    let written = timings.stage("files", || files.write())?;
    let mut report = Report::default();
    head(&subject, &mut report);
    report.line(caption);
    report.written(&written);
    print(report.text())
}

/// The picture, and what it says of the point.
fn draw(subject: &Subject, arguments: &SphereArguments) -> Result<(Picture, String), Failure> {
    let site = Site::new(arguments, subject)?;
    let found = classify(&subject.body, &site.h, &site.l, Accuracy::Exact).map_err(|error| match error {
        AnswerError::Fast(FastError::Momentum(error)) => Failure::input(format!("--l: {error}")),
        error => Failure::work("the point could not be classified").because(error),
    })?;
    let components = match &found.answer {
        Answer::Regular(_) | Answer::Forbidden => {
            let components = components_at(&subject.body, [&site.h, &site.l], &found).map_err(poincare_failure)?;
            components.iter().map(component).collect()
        }
        // On a curve the parts touch: they are shown as one.
        Answer::Critical(_) | Answer::Undecided(_) => Vec::new(),
    };
    let caption = caption(&site, &found.answer);
    let (theme, width) = (arguments.picture.theme, arguments.width.width);
    let picture =
        scene(subject, &site, &components, &caption, arguments.view, |scene| draw_sphere(scene, theme, width))?;
    Ok((picture?, caption))
}

/// The classes that meet at a point on curves differ by the poles in U alone: no critical curve passes there.
fn is_pole_line(classes: &[Components]) -> bool {
    let circles = |components: &Components| {
        let mut circles: Vec<u32> = components.iter().map(|component| component.boundary_circles).collect();
        circles.sort_unstable();
        circles
    };
    classes.len() > 1 && classes.windows(2).all(|pair| circles(&pair[0]) == circles(&pair[1]))
}

/// The point, its region and what is special about it.
fn caption(site: &Site, answer: &Answer) -> String {
    let region = site.region.as_ref().map_or_else(String::new, |region| format!(", region {region}"));
    let special = match answer {
        Answer::Critical(classes) if is_pole_line(classes) => ", on a pole line: a pole lies on ∂U, P changes here",
        Answer::Critical(_) => ", on a curve of the bifurcation diagram",
        Answer::Undecided(_) => ", not decided",
        Answer::Regular(_) | Answer::Forbidden => "",
    };
    let [h, l] = [("h", site.h.text()), ("l", site.l.text())].map(|(name, text)| value_text(name, text, 6));
    format!("U(γ) ≤ h on the Poisson sphere: {h}, {l}{region}{special}")
}

/// Hands over what is to be drawn of U; without components (on a curve) all of it has one tint.
fn scene<P>(
    subject: &Subject,
    site: &Site,
    components: &[ComponentDocument],
    caption: &str,
    view: Option<[f64; 3]>,
    draw: impl FnOnce(&SphereScene<'_>) -> P,
) -> Result<P, Failure> {
    let body = &subject.body;
    let (h, l) = (site.h.to_f64(), site.l.to_f64());
    let (moments, center) = (body.moments_f64(), body.center_f64());
    let potential_above = |gamma: [f64; 3]| {
        let j = dot(gamma, [0, 1, 2].map(|k| moments[k] * gamma[k]));
        let terms = [l * l / (2.0 * j), -dot(gamma, center), -h];
        let [size, sum] = [terms.map(f64::abs), terms].map(|terms| terms.iter().sum::<f64>());
        // Where U is h everywhere, rounding would draw a pattern of its own.
        if sum.abs() <= 4.0 * f64::EPSILON * size { 0.0 } else { sum }
    };
    let r = dot(center, center).sqrt();
    let r_hat = (r > 0.0).then(|| center.map(|c| c / r));
    let found = critical(body, &site.l).map_err(failed("the relative equilibria could not be found"))?;
    let region =
        AccessibleRegion::new(body, h, l).map_err(failed("the components of U could not be told apart in f64"))?;
    let partition = if components.len() > 1 {
        region.partition().map_err(failed("the components of U could not be told apart"))?
    } else {
        None
    };
    let component_of = |gamma| match &partition {
        Some(partition) => component_of(partition, gamma),
        None => Some(0),
    };
    Ok(draw(&SphereScene {
        title: &title(body),
        caption,
        potential_above: &potential_above,
        r_hat,
        components,
        component_of: &component_of,
        equilibria: &bifdiag_documents::equilibria(&found),
        axis: r_hat.unwrap_or_else(|| symmetry_axis(moments)),
        time_unit: subject.part.as_ref().map_or("", |part| part.time_unit()),
        view,
    }))
}

/// A and r with as many digits as a title holds.
fn title(body: &Body) -> String {
    let [moments, center] = [body.moments(), body.center()].map(|numbers| numbers.each_ref().map(Number::text));
    body_line(&moments, &center, f64::INFINITY, 1.0)
}

/// The principal axis of a body with two equal moments.
fn symmetry_axis(moments: [f64; 3]) -> [f64; 3] {
    let [a, b, c] = moments;
    // Circles of equilibria need two equal moments.
    if a == b {
        [0.0, 0.0, 1.0]
    } else if a == c {
        [0.0, 1.0, 0.0]
    } else {
        [1.0, 0.0, 0.0]
    }
}
