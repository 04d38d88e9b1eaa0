//! The title and what the picture cannot show, in words.

use super::insets::Magnifications;
use super::labels::{H, L, region_type};
use crate::page::{body, text_width};
use schema::AtlasDocument;

/// Font size of the notes.
pub(super) const NOTE_SIZE: f64 = 11.0;

/// The body in a line.
pub(super) fn title(atlas: &AtlasDocument) -> String {
    let mut title = body(&atlas.body.moments, &atlas.body.center);
    if atlas.body.flags.unphysical {
        title.push_str("   (unphysical: the triangle inequality is violated)");
    }
    title
}

/// What the picture cannot show, in lines of at most `width` pixels.
pub(super) fn notes(
    atlas: &AtlasDocument,
    magnified: &Magnifications,
    unlabelled: &[usize],
    width: f64,
) -> Vec<String> {
    let known: Vec<usize> = magnified.invisible.iter().chain(&magnified.outside).copied().collect();
    let crowded: Vec<usize> = unlabelled.iter().filter(|region| !known.contains(region)).copied().collect();
    let mut lines = Vec::new();
    for (heading, regions) in [
        ("Too narrow to be drawn:", &magnified.invisible),
        ("Outside the window:", &magnified.outside),
        ("Without room for a label:", &crowded),
    ] {
        if regions.is_empty() {
            continue;
        }
        let items = regions.iter().map(|&index| {
            let region = &atlas.regions[index];
            let kind = region_type(region);
            let wide = region.h_width.map_or_else(String::new, |wide| format!(", {wide:.1e} wide"));
            format!("{} ({kind}) at {H} = {}, {L} = {}{wide}", region.id, region.sample.h, region.sample.l)
        });
        wrap(heading, items, width, &mut lines);
    }
    let undecided = atlas.summary.undecided.len();
    if undecided > 0 {
        let items =
            atlas.summary.undecided.iter().map(|what| format!("{} near {H} = {}, {L} = {}", what.what, what.h, what.l));
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
