//! Colours of orbits: apart for colour-blind readers too, or from a scale whose lightness grows with the value.

use plotters::style::RGBColor;

use super::scene::{OrbitColors, SectionScene};
use bifdiag_page::{Anchor, Canvas, INK, Ink, Rect, rgb, rgbs, ticks};

/// Shades of each hue, which distinguish the orbits of a family.
const SHADES: usize = 4;
/// Hues of families: apart for colour-blind readers too, and dark enough for the shaded ground.
const FAMILIES: [[RGBColor; SHADES]; 5] = [
    rgbs([0x1f_6f_c2, 0x0b_3c_7d, 0x3f_96_e0, 0x08_20_4d]),
    rgbs([0xc8_50_00, 0x8a_35_00, 0xf0_8a_24, 0x5e_1f_00]),
    rgbs([0x00_7a_58, 0x2a_b5_86, 0x00_52_3c, 0x00_30_1f]),
    rgbs([0xc0_78_f0, 0x8f_3f_c7, 0x5a_16_87, 0x35_0a_52]),
    rgbs([0xb8_a0_18, 0x94_80_00, 0x5f_52_00, 0x3a_32_00]),
];
/// Colours of orbits by family and shade.
const ORBITS: usize = FAMILIES.len() * SHADES;
/// An orbit without a value.
const UNKNOWN: RGBColor = rgb(0x8a_8a_8a);
/// The scale of values, from the lowest to the highest.
const SCALE: [RGBColor; 6] = rgbs([0x16_1b_5c, 0x5b_23_8c, 0xa5_2c_83, 0xd9_4a_5e, 0xee_7d_2d, 0xf2_b1_13]);
/// Colours of the scale: with the rest they fit the palette of an image.
const LEVELS: usize = 200;
const TICK_SIZE: f64 = 11.0;

/// How the orbits of a picture are coloured.
pub(super) struct Coloring {
    pub bar: Option<Bar>,
}

/// The scale of values and what they are.
pub(super) struct Bar {
    label: String,
    range: [f64; 2],
}

impl Coloring {
    pub fn new(scenes: &[SectionScene<'_>]) -> Self {
        let labelled = scenes.iter().find_map(|scene| scene.values);
        let bar = labelled.map(|first| {
            let values = scenes.iter().filter_map(|scene| scene.values).flat_map(|values| values.values);
            let finite = values.copied().filter(|value| value.is_finite());
            let [from, to] =
                finite.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], value| [a.min(value), b.max(value)]);
            // One value, or none, still has a scale around it.
            let range = if from < to {
                [from, to]
            } else if from == to {
                let half = if from == 0.0 { 1.0 } else { 0.5 * from.abs() };
                [from - half, from + half]
            } else {
                [0.0, 1.0]
            };
            Bar { label: first.label.to_owned(), range }
        });
        Self { bar }
    }

    /// The colours that an image of this picture can need.
    pub fn palette(&self) -> Vec<RGBColor> {
        let scale = (0..LEVELS).map(level_color);
        FAMILIES.into_iter().flatten().chain([UNKNOWN]).chain(scale.filter(|_| self.bar.is_some())).collect()
    }

    /// Place in the palette of orbit number `index` of a scene.
    pub fn of(&self, scene: &SectionScene<'_>, index: usize) -> usize {
        if let (Some(bar), Some(values)) = (&self.bar, scene.values) {
            return bar.level(values.values[index]).map_or(ORBITS, |level| ORBITS + 1 + level);
        }
        let own = family(scene, index);
        let before = (0..index).filter(|&other| family(scene, other) == own).count();
        let places = places(scene, own);
        places[before % places.len()]
    }
}

/// The family of an orbit.
pub(super) fn family(scene: &SectionScene<'_>, index: usize) -> usize {
    scene.families.and_then(|families| families.of.get(index).copied()).unwrap_or(0)
}

/// The places in the palette of the colours of a family.
fn places(scene: &SectionScene<'_>, family: usize) -> Vec<usize> {
    let first = family % FAMILIES.len() * SHADES;
    match (scene.families.map(|families| families.colors).unwrap_or_default(), family) {
        (OrbitColors::Orbits, _) | (OrbitColors::Verdicts, 0) => (first..first + SHADES).collect(),
        (OrbitColors::Verdicts, 2..) => vec![ORBITS],
        (OrbitColors::Families | OrbitColors::Verdicts, _) => vec![first],
    }
}

/// The colours of a family.
pub(super) fn shades(scene: &SectionScene<'_>, family: usize) -> Vec<RGBColor> {
    let color = |place: usize| FAMILIES.as_flattened().get(place).copied().unwrap_or(UNKNOWN);
    places(scene, family).into_iter().map(color).collect()
}

/// Where no value is known.
pub(crate) const fn unknown() -> RGBColor {
    UNKNOWN
}

/// The colour of a part of the scale, from 0 to 1.
pub(crate) fn shade(share: f64) -> RGBColor {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to the levels")]
    let level = (share.clamp(0.0, 1.0) * (LEVELS - 1) as f64).round() as usize;
    level_color(level)
}

/// The colour of a level of the scale.
fn level_color(level: usize) -> RGBColor {
    let place = level as f64 / (LEVELS - 1) as f64 * (SCALE.len() - 1) as f64;
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between 0 and the length")]
    let below = (place as usize).min(SCALE.len() - 2);
    let share = place - below as f64;
    let mix = |a: u8, b: u8| {
        let value = f64::from(a) + share * (f64::from(b) - f64::from(a));
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between two bytes")]
        let byte = value.round() as u8;
        byte
    };
    let (a, b) = (SCALE[below], SCALE[below + 1]);
    RGBColor(mix(a.0, b.0), mix(a.1, b.1), mix(a.2, b.2))
}

impl Bar {
    fn level(&self, value: f64) -> Option<usize> {
        let share = (value - self.range[0]) / (self.range[1] - self.range[0]);
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to the levels")]
        let level = (share.clamp(0.0, 1.0) * (LEVELS - 1) as f64).round() as usize;
        value.is_finite().then_some(level)
    }

    /// Draws the bar with ticks and its label.
    pub fn draw(&self, canvas: &Canvas, rect: Rect) {
        let [from, to] = self.range;
        let ticks = ticks(&self.label, from, to, 6);
        paint_scale(canvas, &rect);
        canvas.outline(&rect.corners(), Ink { color: INK, width: 0.8 });
        for (value, label) in ticks.values.iter().zip(&ticks.labels) {
            let y = rect.y + rect.height * (1.0 - (value - from) / (to - from));
            let right = rect.x + rect.width;
            canvas.path(&[[right, y], [right + 4.0, y]], Ink { color: INK, width: 0.8 });
            canvas.text(label, [right + 7.0, y + 0.36 * TICK_SIZE], TICK_SIZE, INK, Anchor::Start);
        }
        // Flush with the page's right margin, above the bar.
        canvas.text(&ticks.quantity, [rect.x + 78.0, rect.y - 26.0], TICK_SIZE, INK, Anchor::End);
    }
}

/// Fills a rectangle with the scale, from below.
pub(crate) fn paint_scale(canvas: &Canvas, rect: &Rect) {
    for level in 0..LEVELS {
        // Each reaches to the upper end, and the next lies over it, so that no seam shows.
        let height = rect.height * (1.0 - level as f64 / LEVELS as f64);
        canvas.polygon(&Rect { height, ..*rect }.corners(), level_color(level));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use bifdiag_page::sight::{SIGHTS, apart};

    /// Relative luminance, the one that colour blindness leaves.
    fn luminance(color: RGBColor) -> f64 {
        0.2126 * f64::from(color.0) + 0.7152 * f64::from(color.1) + 0.0722 * f64::from(color.2)
    }

    #[test]
    fn the_scale_grows_lighter() {
        for level in 1..LEVELS {
            assert!(luminance(level_color(level)) >= luminance(level_color(level - 1)) - 0.5, "level {level}");
        }
    }

    #[test]
    fn families_are_told_apart_by_every_reader() {
        for sight in SIGHTS {
            for (place, one) in FAMILIES.iter().enumerate() {
                for other in &FAMILIES[..place] {
                    let distance = apart(sight, one[0], other[0]);
                    assert!(distance > 12.0, "{:?} and {:?} are {distance:.1} apart with {sight:?}", one[0], other[0]);
                }
            }
        }
    }

    #[test]
    fn every_colour_stands_out_from_the_ground() {
        for color in FAMILIES.into_iter().flatten().chain([UNKNOWN, level_color(0), level_color(LEVELS - 1)]) {
            assert!(luminance(color) < 190.0, "{color:?}");
        }
        const { assert!(ORBITS + 1 + LEVELS <= 255, "an image has room for one transparent and 255 other colours") };
    }
}
