//! The labels of regions.

use crate::page::{Anchor, Canvas, FAINT_INK, INK, Ink, PAPER, Point, Rect, subscript, superscript, text_width};
use schema::{AtlasDocument, RegionDocument};

/// The energy.
pub(super) const H: &str = "h";
/// The vertical angular momentum.
pub(super) const L: &str = "l";

/// Size of the id relative to the type.
const ID_SCALE: f64 = 0.78;
/// Height of a line relative to the font size.
const LINE: f64 = 1.2;

/// The type and the id of a region.
#[derive(Clone, Debug)]
pub(super) struct Name {
    pub kind: String,
    pub id: String,
}

/// A placed label of a region.
#[derive(Clone, Debug)]
pub(super) struct Label {
    pub region: usize,
    pub rect: Rect,
    /// Font size of the type.
    pub size: f64,
    /// True when type and id share a line.
    pub one_line: bool,
    /// From the region to the label.
    pub leader: Option<[Point; 2]>,
}

/// Size of a label.
pub(super) fn extent(name: &Name, size: f64, one_line: bool) -> [f64; 2] {
    let (kind, id) = (text_width(&name.kind, size), text_width(&name.id, size * ID_SCALE));
    if one_line { [kind + 0.4 * size + id, LINE * size] } else { [kind.max(id), LINE * size * (1.0 + ID_SCALE)] }
}

/// A section's name as the paper prints it: `S2` is S², `T2` is T², `M3` (genus 3) is M²₃.
fn section(name: &str) -> String {
    match name.strip_prefix('M') {
        Some(genus) => format!("M²{}", subscript(genus)),
        None => superscript(name),
    }
}

/// A component of the accessible region: `D2` is D², `S2-3D2` is S²∖3D².
fn accessible_region(name: &str) -> String {
    match name.split_once('-') {
        Some((sphere, discs)) => {
            let count = discs.trim_end_matches("D2");
            format!("{}∖{count}D²", superscript(sphere))
        }
        None => superscript(name),
    }
}

/// The accessible region of a region of the diagram.
pub(super) fn accessible_regions(region: &RegionDocument) -> String {
    let parts: Vec<String> =
        region.components.iter().map(|component| accessible_region(&component.accessible_region)).collect();
    parts.join("+")
}

/// The type printed in a region: that of its section, or of its accessible region where no section exists.
pub(super) fn region_type(region: &RegionDocument) -> String {
    if let Some(signature) = &region.signature {
        return signature.split('+').map(section).collect::<Vec<_>>().join("+");
    }
    if region.components.is_empty() {
        return "undecided".to_owned();
    }
    format!("U: {}", accessible_regions(region))
}

/// The names of all regions: the id with U where another region has a section of the same type over another U.
pub(super) fn names(atlas: &AtlasDocument) -> Vec<Name> {
    let types: Vec<[String; 2]> =
        atlas.regions.iter().map(|region| [region_type(region), accessible_regions(region)]).collect();
    let name = |(region, [kind, own]): (&RegionDocument, &[String; 2])| {
        let ambiguous = region.signature.is_some() && types.iter().any(|[other, u]| other == kind && u != own);
        let id = if ambiguous { format!("{}, U = {own}", region.id) } else { region.id.clone() };
        Name { kind: kind.clone(), id }
    };
    atlas.regions.iter().zip(&types).map(name).collect()
}

/// Draws a label.
pub(super) fn paint(canvas: &Canvas<'_>, label: &Label, name: &Name) {
    if let Some([anchor, end]) = label.leader {
        canvas.path(&[anchor, end], Ink { color: INK, width: 0.7 });
        canvas.disc(anchor, 1.3, INK);
        canvas.polygon(&label.rect.grown(1.5).corners(), PAPER);
        canvas.outline(&label.rect.grown(1.5).corners(), Ink { color: FAINT_INK, width: 0.5 });
    }
    let Rect { x, y, width, .. } = label.rect;
    let (size, id_size) = (label.size, label.size * ID_SCALE);
    let base = y + 0.95 * size;
    let (kind_x, id_at) = if label.one_line {
        (x + text_width(&name.kind, size) / 2.0, [x + width - text_width(&name.id, id_size) / 2.0, base])
    } else {
        let middle = x + width / 2.0;
        (middle, [middle, y + LINE * size + 0.9 * id_size])
    };
    canvas.text(&name.kind, [kind_x, base], size, INK, Anchor::Middle);
    canvas.text(&name.id, id_at, id_size, FAINT_INK, Anchor::Middle);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_printed_as_in_the_paper() {
        assert_eq!(section("T2"), "T²");
        assert_eq!(section("M3"), "M²₃");
        assert_eq!(accessible_region("S2-3D2"), "S²∖3D²");
    }
}
