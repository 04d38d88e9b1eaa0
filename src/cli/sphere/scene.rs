//! What the picture needs of a body at one point.

use bifdiag_body::Body;
use bifdiag_diagram::accessible::{AccessibleRegion, component_of};
use bifdiag_documents::Subject;
use bifdiag_dynamics::field::dot;
use bifdiag_equilibria::critical::critical;
use bifdiag_plot::SphereScene;
use bifdiag_schema::ComponentDocument;

use super::error::SphereError;
use super::site::Site;
use crate::cli::input::values::Vector;
use crate::cli::terminal::significant;

/// Hands over what is to be drawn of U; without components (on a curve) all of it has one tint.
pub fn scene<P>(
    subject: &Subject,
    site: &Site,
    components: &[ComponentDocument],
    caption: &str,
    view: Option<&Vector>,
    draw: impl FnOnce(&SphereScene<'_>) -> P,
) -> Result<P, SphereError> {
    let body = &subject.body;
    let (h, l) = (site.h.to_f64(), site.l.to_f64());
    let (moments, center) = (body.moments_f64(), body.center_f64());
    let potential_above = |gamma: [f64; 3]| {
        let j = dot(gamma, [0, 1, 2].map(|k| moments[k] * gamma[k]));
        l * l / (2.0 * j) - dot(gamma, center) - h
    };
    let r = dot(center, center).sqrt();
    let r_hat = (r > 0.0).then(|| center.map(|c| c / r));
    let found = critical(body, &site.l)?;
    let region = AccessibleRegion::new(body, h, l)?;
    let partition = if components.len() > 1 { region.partition()? } else { None };
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
        view: view.map(|Vector(direction)| *direction),
    }))
}

/// A and r with as many digits as a title holds.
fn title(body: &Body) -> String {
    let join = |numbers: [f64; 3]| numbers.map(|x| significant(x, 6)).join(", ");
    format!("A = ({}),  r = ({})", join(body.moments_f64()), join(body.center_f64())).replace('-', "−")
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
