//! Pictures of Poincaré sections: both sheets side by side, with the accessible part shaded by the sign of Ṡ, its
//! boundary, the line of tangency, the poles, and the crossings of orbits.
//!
//! A [`SectionScene`] is a [`Portrait`] with orbits; `layout` gives each sheet of each chart its panel, `ground` draws
//! and explains what the portrait says, and `points` draws the crossings, as vectors or as an image.

mod colors;
mod curves;
mod ground;
mod layout;
mod points;
mod scene;

pub use scene::{OrbitColors, OrbitFamilies, OrbitValues, Projection, SectionCurves, SectionOptions, SectionScene};

use bifdiag_dynamics::section::SectionCondition;
use bifdiag_page::{Anchor, Heading, INK, Legend, Picture, PlotError, body_line, render, text_width, title_size};
use colors::Coloring;
pub(crate) use colors::{paint_scale, shade, unknown};
use layout::Layout;

/// The most sections on one page.
const SCENES_MAX: usize = 64;
const TITLE_SIZE: f64 = 14.0;

/// Draws one section. Equal arguments give equal bytes.
///
/// # Errors
/// As [`draw_section_rows`].
pub fn draw_section(scene: &SectionScene<'_>, options: &SectionOptions) -> Result<Picture, PlotError> {
    draw_section_rows(std::slice::from_ref(scene), options)
}

/// Draws sections below each other, with one legend and one colour scale.
///
/// # Errors
/// [`PlotError::Scenes`] for no section or too many, [`PlotError::Values`] if there is not a value for each orbit, or
/// a failure of the drawing library.
pub fn draw_section_rows(scenes: &[SectionScene<'_>], options: &SectionOptions) -> Result<Picture, PlotError> {
    if scenes.is_empty() || scenes.len() > SCENES_MAX {
        return Err(PlotError::Scenes { given: scenes.len(), most: SCENES_MAX });
    }
    for scene in scenes {
        if let Some(values) = scene.values.filter(|values| values.values.len() != scene.orbits.len()) {
            let (label, orbits) = (values.label.to_owned(), scene.orbits.len());
            return Err(PlotError::Values { label, values: values.values.len(), orbits });
        }
    }
    let coloring = Coloring::new(scenes);
    let layout = Layout::new(scenes, options.projection, coloring.bar.is_some(), options.width);
    let mut entries = ground::legend(scenes, options.projection);
    entries.extend(curves::legend(scenes));
    let legend = Legend::new(entries, layout.room());
    let mut heading = heading(scenes, layout.width - 2.0 * layout::TITLE_AT[0]);
    if let Some(title) = &options.title {
        heading.title.clone_from(title);
    }
    let title = heading.title.clone();
    let size = [layout.width, (layout.bottom + legend.height() + 10.0).ceil()];
    let style = points::Style::new(scenes, options);
    render(size, heading, options.theme, |canvas| {
        for panel in &layout.panels {
            let scene = &scenes[panel.scene];
            ground::shade(canvas, scene.portrait, panel);
            canvas.keep(points::draw(canvas, scene, panel, &coloring, &style));
            ground::outline(canvas, scene.portrait, panel);
            if let Some(own) = scene.curves {
                curves::draw(canvas, scene.portrait, own, panel);
            }
        }
        let size = title_size(&title, TITLE_SIZE, layout.width - layout::TITLE_AT[0]);
        canvas.text(&title, layout::TITLE_AT, size, INK, Anchor::Start);
        layout.draw_captions(canvas, scenes);
        if let Some(bar) = &coloring.bar {
            bar.draw(canvas, layout.bar());
        }
        legend.draw(canvas, [layout::TITLE_AT[0], layout.bottom]);
    })
}

/// The body of some sections in a line of at most `width` pixels, and their condition if it is not the usual one; and all
/// numbers in full.
fn heading(scenes: &[SectionScene<'_>], width: f64) -> Heading {
    let portrait = scenes[0].portrait;
    let top = portrait.torus().top();
    let condition = match portrait.condition() {
        SectionCondition::Height => "",
        SectionCondition::AngularMomentum => ",  S = ⟨l, γ×r⟩",
    };
    let room = width - text_width(condition, TITLE_SIZE);
    let title = body_line(&top.moments(), &top.center(), room, TITLE_SIZE);
    let body = format!("A = {:?}, r = {:?}", top.moments(), top.center());
    let points = scenes.iter().map(|scene| scene.portrait.energy_momentum()).map(|(h, l)| format!("h = {h}, l = {l}"));
    let metadata = std::iter::once(body).chain(points).collect::<Vec<_>>().join("; ");
    Heading { title: format!("{title}{condition}"), metadata }
}
