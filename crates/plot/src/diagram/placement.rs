//! The places of all text in all panels of a diagram.

use super::grid::LEGIBLE;
use super::labels::{Form, Label, Name, names};
use super::layout::{CROWDED, Frame, LETTER_SIZE, is_marked};
use super::markers::MARKER;
use super::panel::Panel;
use super::room::Room;
use super::scene::Scene;
use crate::page::{Point, Rect, Taken, text_width};

/// The text of a diagram.
pub(super) struct Texts {
    /// The name of each region.
    pub names: Vec<Name>,
    /// The labels of each panel.
    pub labels: Vec<Vec<Label>>,
    /// The place of the letters at the frame of which an inset is the first.
    pub letters: Vec<Option<Rect>>,
    /// Regions that no label tells in full, and whether they have a label at all: the key tells them.
    pub key: Vec<(usize, bool)>,
}

/// How a region is labelled: where, and in which form; the best first.
const TRIES: [(bool, Form); 6] = [
    (true, Form::Full),
    (true, Form::Short),
    (false, Form::Full),
    (true, Form::Id),
    (false, Form::Short),
    (false, Form::Id),
];

/// Finds the places: inside the regions first, in every panel, then beside those that are left.
pub(super) fn place(scene: &Scene<'_>, panels: &[Panel], frames: &[Vec<Frame>]) -> Texts {
    let names = names(scene.atlas);
    let mut letters = vec![None; panels.len()];
    let room = |(panel, frames): (_, &Vec<Frame>)| free_room(scene, panel, frames, &mut letters);
    let mut rooms: Vec<Room<'_>> = panels.iter().zip(frames).map(room).collect();
    for room in &mut rooms {
        for (region, name) in names.iter().enumerate() {
            if room.depth(region) >= LEGIBLE {
                room.label_inside(region, name, &[Form::Full]);
            }
        }
    }
    for (region, name) in names.iter().enumerate() {
        if !rooms.iter().any(|room| room.has_label(region)) {
            label(&mut rooms, region, name);
        }
    }
    // What can be seen in a panel is named there too.
    for room in &mut rooms {
        for (region, name) in names.iter().enumerate() {
            if room.depth(region) >= LEGIBLE && !room.has_label(region) {
                let _no_room = room.label_inside(region, name, &[Form::Short, Form::Id])
                    || room.label_beside(region, name, Form::Id);
            }
        }
    }
    let labels: Vec<Vec<Label>> = rooms.into_iter().map(Room::into_labels).collect();
    let key = names.iter().enumerate().filter_map(|(region, name)| {
        let own = || labels.iter().flatten().filter(|label| label.region == region);
        let is_told = |label: &Label| match label.setting.form {
            Form::Full => true,
            Form::Short => name.accessible.is_none(),
            Form::Id => false,
        };
        (!own().any(is_told)).then(|| (region, own().next().is_some()))
    });
    let key = key.collect();
    Texts { names, labels, letters, key }
}

/// Labels a region once, in the best way for which there is room: in the first panel that shows it well, else in the one
/// that shows it best.
fn label(rooms: &mut [Room<'_>], region: usize, name: &Name) {
    let mut order: Vec<usize> = (0..rooms.len()).filter(|&room| rooms[room].depth(region) > 0.0).collect();
    order.sort_by(|&a, &b| {
        let depth = |room: usize| rooms[room].depth(region).min(LEGIBLE);
        depth(b).total_cmp(&depth(a)).then(a.cmp(&b))
    });
    for (inside, form) in TRIES {
        for &room in &order {
            let room = &mut rooms[room];
            let placed = if inside {
                room.depth(region) >= LEGIBLE && room.label_inside(region, name, &[form])
            } else {
                room.label_beside(region, name, form)
            };
            if placed {
                return;
            }
        }
    }
}

/// The room of a panel that markers, frames and their letters leave to labels; tells `letters` where the letters are.
fn free_room<'a>(scene: &Scene<'_>, panel: &'a Panel, frames: &[Frame], letters: &mut [Option<Rect>]) -> Room<'a> {
    let mut taken = Taken::default();
    let events = scene.atlas.events.iter().map(|event| [event.h, event.l]);
    let points = events.chain(scene.dots.iter().map(|dot| dot.at)).map(|point| panel.view.position(point));
    for point in points.filter(|point: &Point| is_marked(*point, panel, frames)) {
        taken.take_box(Rect::around(point, MARKER + 0.5));
    }
    for frame in frames {
        if frame.rect.width < CROWDED || frame.rect.height < CROWDED {
            taken.take_box(frame.rect);
        } else {
            taken.take_outline(&frame.rect);
        }
    }
    let mut room = Room::new(panel, scene.cells.len(), taken);
    for frame in frames {
        let text = frame.letters().join(", ");
        letters[frame.insets[0]] = room.beside(&frame.rect, [text_width(&text, LETTER_SIZE), LETTER_SIZE]);
    }
    room
}
