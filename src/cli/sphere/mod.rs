//! `bifdiag sphere`: U on the Poisson sphere at one point, as a picture.

mod arguments;
mod error;
mod scene;
mod site;

use bifdiag_diagram::topology::{Answer, Components};
use bifdiag_documents::{Subject, component};
use bifdiag_exact::{Accuracy, classify};
use bifdiag_plot::{Picture, Theme, Width, draw_sphere};

use super::export::{ExportError, FileSet, RESOLUTION, directory};
use super::failure::Failure;
use super::input::head;
use super::input::values::Vector;
use super::terminal::{Report, Timings, print};
use error::SphereError;

pub use arguments::{EXAMPLES, SphereArguments};
pub use site::Site;

pub fn run(arguments: &SphereArguments, timings: &Timings) -> Result<(), Failure> {
    let subject = arguments.body.subject()?;
    let directory = directory(arguments.out.as_deref(), true)?.unwrap_or_default();
    let site = Site::new(arguments, &subject)?;
    let (theme, width) = (arguments.picture.theme, arguments.width.width());
    let (picture, caption) =
        timings.stage("picture", || draw(&subject, &site, arguments.view.as_ref(), theme, width))?;
    let mut files = FileSet::new(&directory);
    files.pictures("sphere", &picture, &arguments.picture.format, RESOLUTION, timings)?;
    let written = timings.stage("files", || files.write())?;
    let mut report = Report::default();
    head(&subject, &mut report);
    report.line(caption);
    report.written(&written);
    Ok(print(report.text())?)
}

/// The picture, and what it says of the point.
pub fn draw(
    subject: &Subject,
    site: &Site,
    view: Option<&Vector>,
    theme: Theme,
    width: Width,
) -> Result<(Picture, String), Failure> {
    let found = classify(&subject.body, &site.h, &site.l, Accuracy::Exact).map_err(SphereError::from)?;
    let components = match &found.answer {
        Answer::Regular(components) => components.iter().map(component).collect(),
        Answer::Forbidden => return Err(SphereError::Empty { h: site.h.text().to_owned() }.into()),
        // On a curve the parts touch: they are shown as one.
        Answer::Critical(_) | Answer::Undecided(_) => Vec::new(),
    };
    let caption = caption(site, &found.answer);
    let picture = scene::scene(subject, site, &components, &caption, view, |scene| draw_sphere(scene, theme, width))?;
    Ok((picture.map_err(ExportError::from)?, caption))
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
    let region = site.region.as_ref().map_or_else(String::new, |region| format!(",  region {region}"));
    let special = match answer {
        Answer::Critical(classes) if is_pole_line(classes) => ",  on a pole line: a pole lies on ∂U, P changes here",
        Answer::Critical(_) => ",  on a curve: U changes here",
        Answer::Undecided(_) => ",  not decided",
        Answer::Regular(_) | Answer::Forbidden => "",
    };
    format!("U(γ) ≤ h on the Poisson sphere:  h = {},  l = {}{region}{special}", site.h.text(), site.l.text())
}
