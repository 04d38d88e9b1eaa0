//! The places of all text in all panels of a diagram.

use super::grid::LEGIBLE;
use super::labels::{Label, Name, names};
use super::layout::{CROWDED, Frame, LETTER_SIZE, is_marked, letter};
use super::panel::Panel;
use super::scene::Scene;
use super::space::Space;
use crate::page::{Point, Rect, text_width};

/// The text of a diagram.
pub(super) struct Texts {
    /// The name of each region.
    pub names: Vec<Name>,
    /// The labels of each panel.
    pub labels: Vec<Vec<Label>>,
    /// The place of each inset's letter at its frame.
    pub letters: Vec<Option<Rect>>,
    /// Regions that found no place.
    pub unlabelled: Vec<usize>,
}

/// Finds the places: inside the regions first, in every panel, then beside those that are left.
pub(super) fn place(scene: &Scene<'_>, panels: &[Panel], frames: &[Vec<Frame>]) -> Texts {
    let names = names(scene.atlas);
    let mut letters = vec![None; panels.len()];
    let keep_free = |(panel, frames): (_, &Vec<Frame>)| free_space(scene, panel, frames, &mut letters);
    let mut spaces: Vec<Space<'_>> = panels.iter().zip(frames).map(keep_free).collect();
    let mut labelled = vec![false; names.len()];
    for space in &mut spaces {
        space.label_inside(&names, &mut labelled);
    }
    let sample = |region: usize, panel: &Panel| {
        let sample = &scene.atlas.regions[region].sample;
        panel.view.position([sample.h, sample.l])
    };
    let mut unlabelled = Vec::new();
    for region in (0..names.len()).filter(|&region| !labelled[region]) {
        // The first panel that shows it well, else the one that shows it best.
        let depths: Vec<f64> = spaces.iter().map(|space| space.depth(region)).collect();
        let deepest = (0..depths.len()).max_by(|&a, &b| depths[a].total_cmp(&depths[b]).then(b.cmp(&a)));
        let best = depths.iter().position(|depth| *depth >= LEGIBLE).or(deepest);
        if !best.is_some_and(|best| spaces[best].label_beside(region, &names[region], sample(region, &panels[best]))) {
            unlabelled.push(region);
        }
    }
    // What can be seen in a panel is named there too.
    for (space, panel) in spaces.iter_mut().zip(panels) {
        for region in (0..names.len()).filter(|&region| labelled[region]) {
            if space.depth(region) >= LEGIBLE && !space.has_label(region) {
                space.label_beside(region, &names[region], sample(region, panel));
            }
        }
    }
    Texts { names, labels: spaces.into_iter().map(Space::into_labels).collect(), letters, unlabelled }
}

/// The space of a panel that markers, frames and their letters leave to labels; tells `letters` where the letters are.
fn free_space<'a>(scene: &Scene<'_>, panel: &'a Panel, frames: &[Frame], letters: &mut [Option<Rect>]) -> Space<'a> {
    let mut space = Space::new(panel, scene.cells.len());
    let events = scene.atlas.events.iter().map(|event| [event.h, event.l]);
    let samples = scene.atlas.regions.iter().map(|region| [region.sample.h, region.sample.l]);
    let points = events.chain(samples).map(|point| panel.view.position(point));
    for point in points.filter(|point: &Point| is_marked(*point, panel, frames)) {
        space.take(&Rect::around(point, 4.5));
    }
    for frame in frames {
        space.take_outline(&frame.rect);
        if frame.rect.width < CROWDED || frame.rect.height < CROWDED {
            space.take(&frame.rect);
        }
    }
    for frame in frames {
        let text = letter(frame.inset);
        letters[frame.inset] = space.beside(&frame.rect, [text_width(&text, LETTER_SIZE), LETTER_SIZE]);
    }
    space
}
