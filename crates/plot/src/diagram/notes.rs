//! The title, units, and what the picture cannot show, in words.

use super::insets::Magnifications;
use super::labels::{H, L, region_type};
use crate::page::{Heading, body_line, short_number, text_width};
use bifdiag_schema::AtlasDocument;

/// Font size of the notes.
pub(super) const NOTE_SIZE: f64 = 11.0;

/// The body in a line of at most `width` pixels at this font size, its numbers rounded where that is needed, and all that
/// is known of it for programs.
pub(super) fn heading(atlas: &AtlasDocument, width: f64, size: f64) -> Heading {
    let AtlasDocument { body: own, head, .. } = atlas;
    let title = body_line(&own.given.moments, &own.given.center, width, size);
    let mut metadata = format!("A = ({}), r = ({})", own.given.moments.join(", "), own.given.center.join(", "));
    for (name, value) in [("version", &head.version), ("command", &head.command)] {
        if !value.is_empty() {
            metadata.extend(["; ", name, ": ", value]);
        }
    }
    Heading { title, metadata }
}

/// What is said below the title: what is special about the body.
pub(super) fn remark(atlas: &AtlasDocument) -> &'static str {
    if atlas.body.flags.unphysical { "no mass has these moments and this centre" } else { "" }
}

/// Units of h and l of a real part; empty for a body of numbers.
pub(super) fn units(atlas: &AtlasDocument) -> [String; 2] {
    let Some(part) = &atlas.body.part else { return [String::new(), String::new()] };
    match part.units.split(',').map(str::trim).collect::<Vec<_>>()[..] {
        ["kg", "m", "s"] => ["J".to_owned(), "J s".to_owned()],
        [mass, length, time] => {
            let momentum = format!("{mass} {length}²/{time}");
            [format!("{momentum}²"), momentum]
        }
        _ => [String::new(), String::new()],
    }
}

/// What the picture cannot show, in lines of at most `width` pixels.
pub(super) fn notes(atlas: &AtlasDocument, magnified: &Magnifications, width: f64) -> Vec<String> {
    let mut lines = Vec::new();
    for (heading, regions) in
        [("Too narrow to be drawn:", &magnified.invisible), ("Outside the window:", &magnified.outside)]
    {
        if regions.is_empty() {
            continue;
        }
        let items = regions.iter().map(|&index| {
            let region = &atlas.regions[index];
            let kind = region_type(region);
            let wide =
                atlas.h_width(&region.id).map_or_else(String::new, |wide| format!(", {} wide", short_number(wide, 2)));
            let [h, l] = [region.sample.h, region.sample.l].map(|value| short_number(value, 8));
            format!("{} ({kind}) at {H} = {h}, {L} = {l}{wide}", region.id)
        });
        wrap(heading, items, width, &mut lines);
    }
    let undecided = atlas.summary.undecided.len();
    if undecided > 0 {
        let items = atlas.summary.undecided.iter().map(|what| {
            let [h, l] = [what.h, what.l].map(|value| short_number(value, 8));
            format!("{} near {H} = {h}, {L} = {l}", what.what)
        });
        wrap(&format!("Undecided in f64 ({undecided}):"), items, width, &mut lines);
    }
    lines
}

/// Adds a heading and items to lines of at most `width` pixels.
fn wrap(heading: &str, items: impl Iterator<Item = String>, width: f64, lines: &mut Vec<String>) {
    let mut line = heading.to_owned();
    for (place, item) in items.enumerate() {
        let separator = if place == 0 { " " } else { "; " };
        if text_width(&line, NOTE_SIZE) + text_width(&item, NOTE_SIZE) > width - 2.0 * NOTE_SIZE {
            line.push_str(separator.trim_end());
            lines.push(std::mem::replace(&mut line, item));
        } else {
            line.push_str(separator);
            line.push_str(&item);
        }
    }
    line.push('.');
    lines.push(line);
}
