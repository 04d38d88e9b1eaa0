//! Colours: apart in print and for colour-blind readers, with the paper's associations. Grounds say what a section consists
//! of: one tint for each component, in stripes where there are several.

use std::collections::BTreeMap;

use plotters::style::RGBColor;

use crate::page::{FAINT_INK, rgb, rgbs};
use bifdiag_schema::{AtlasDocument, CurveDocument, CurveKind, RegionDocument};

/// The branch of the global minimum.
const RED: RGBColor = rgb(0xa3_0d_18);
/// The branch that starts at −r̂.
const BLUE: RGBColor = rgb(0x0f_3a_8a);
/// A symmetric pair.
const GREEN: RGBColor = rgb(0x00_80_5c);
/// The branch with a cusp in the paper's body.
const YELLOW: RGBColor = rgb(0xd2_b4_00);
/// Branches beyond the paper's four.
const FURTHER: [RGBColor; 4] = rgbs([0xa0_40_f0, 0x00_b4_f0, 0x3a_1c_10, 0xe8_3c_b4]);

/// The tints of components: S² or D², T² or the whole sphere, then with rising genus or number of circles.
const TINTS: [RGBColor; 6] = rgbs([0xd4_de_f8, 0xdd_f3_e0, 0xf9_f0_b8, 0xf6_cf_ba, 0xd9_c2_f2, 0xf4_b7_c9]);
/// Ground of a region of which nothing is known.
const UNKNOWN: RGBColor = rgb(0xe3_e3_e3);

/// What a region consists of, as far as its ground tells it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Parts {
    /// The places of the components in [`TINTS`].
    tints: Vec<usize>,
    /// Boundary circles of U.
    circles: u32,
}

impl Parts {
    pub(super) fn of(region: &RegionDocument) -> Self {
        let circles = region.components.iter().map(|part| part.boundary_circles).sum();
        if let Some(signature) = &region.signature {
            return Self { tints: section_tints(signature), circles };
        }
        let tint = |circles: u32| match circles {
            0 => 1,
            1 => 0,
            many => usize::try_from(many).unwrap_or(0).min(TINTS.len() - 1),
        };
        Self { tints: region.components.iter().map(|part| tint(part.boundary_circles)).collect(), circles }
    }
}

/// The tints of the sections joined by `+`.
fn section_tints(signature: &str) -> Vec<usize> {
    let tint = |name: &str| match name {
        "S2" => Some(0),
        "T2" => Some(1),
        name => name.strip_prefix('M')?.parse().ok().map(|genus: usize| genus.min(TINTS.len() - 1)),
    };
    signature.split('+').filter_map(tint).collect()
}

/// The ground of a region: one colour, or those of its stripes. Regions with sections of one type and different U differ a
/// little, and so do components of one type.
pub(super) fn ground(parts: &Parts) -> Vec<RGBColor> {
    // In parts of 32, so that bytes suffice.
    let shade = |color: RGBColor, shade: u16| {
        let darker = |byte: u8| u8::try_from(u16::from(byte) * shade / 32).unwrap_or(byte);
        RGBColor(darker(color.0), darker(color.1), darker(color.2))
    };
    let by_circles = [32, 30, 31][(parts.circles % 3) as usize];
    let mut colors: Vec<RGBColor> = Vec::new();
    for tint in &parts.tints {
        let mut color = shade(TINTS[*tint], by_circles);
        while colors.contains(&color) {
            color = shade(color, 30);
        }
        colors.push(color);
    }
    if colors.is_empty() { vec![UNKNOWN] } else { colors }
}

/// One colour for the sections of a signature, such as `S2+T2`: the mean of its ground.
pub(crate) fn tint(signature: &str) -> RGBColor {
    let colors = ground(&Parts { tints: section_tints(signature), circles: 0 });
    let mean = |channel: fn(&RGBColor) -> u8| {
        let sum: usize = colors.iter().map(|color| usize::from(channel(color))).sum();
        u8::try_from(sum / colors.len()).unwrap_or(u8::MAX)
    };
    RGBColor(mean(|color| color.0), mean(|color| color.1), mean(|color| color.2))
}

/// True for a line where a pole enters U_hl.
pub(super) fn is_pole(curve: &CurveDocument) -> bool {
    matches!(curve.kind, CurveKind::PolePlus | CurveKind::PoleMinus)
}

/// Colour and name of each branch of critical curves.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct BranchStyle {
    pub color: RGBColor,
    pub name: String,
    /// Place in the legend.
    pub rank: usize,
}

/// A style for each branch of critical curves: red for the global minimum from l = 0, blue from −r̂, green for the
/// first symmetric pair, yellow and further colours in the order in which the atlas names them.
pub(super) fn branch_styles(atlas: &AtlasDocument) -> BTreeMap<&str, BranchStyle> {
    let critical: Vec<&CurveDocument> = atlas.curves.iter().filter(|curve| !is_pole(curve)).collect();
    let first = |curve: &CurveDocument| atlas.polyline(&curve.id).first().map(|point| point[0]);
    let at_start = |curve: &&&CurveDocument| curve.l_range[0].is_none_or(|l| l == 0.0) && first(curve).is_some();
    let start = |curve: &CurveDocument| first(curve).unwrap_or(0.0);
    let lowest = critical.iter().filter(at_start).min_by(|a, b| start(a).total_cmp(&start(b)));
    let highest = critical.iter().filter(at_start).max_by(|a, b| start(a).total_cmp(&start(b)));
    let mut styles = BTreeMap::new();
    if let (Some(lowest), false) = (lowest, atlas.body.flags.euler) {
        styles.insert(lowest.branch.as_str(), BranchStyle { color: RED, name: lowest.branch_name.clone(), rank: 0 });
        if let Some(highest) = highest.filter(|curve| curve.branch != lowest.branch) {
            let name = highest.branch_name.clone();
            styles.insert(highest.branch.as_str(), BranchStyle { color: BLUE, name, rank: 1 });
        }
    }
    let is_pair = |curve: &CurveDocument| matches!(curve.kind, CurveKind::Pair | CurveKind::Circle);
    let mut pair_colors = vec![GREEN];
    let mut other_colors = vec![YELLOW];
    let mut further = FURTHER.into_iter().cycle();
    for pairs in [true, false] {
        for curve in critical.iter().filter(|curve| is_pair(curve) == pairs) {
            if styles.contains_key(curve.branch.as_str()) {
                continue;
            }
            let preferred = if pairs { &mut pair_colors } else { &mut other_colors };
            let color = preferred.pop().or_else(|| if pairs { None } else { pair_colors.pop() });
            let color = color.unwrap_or_else(|| further.next().unwrap_or(FAINT_INK));
            let name = curve.branch_name.clone();
            let rank = styles.len() + 2;
            styles.insert(curve.branch.as_str(), BranchStyle { color, name, rank });
        }
    }
    styles
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::page::sight::assert_apart;
    use crate::page::{INK, PAPER, POLE, Theme, contrast};

    #[test]
    fn curves_are_told_apart_by_every_reader() {
        // Ten is a clear difference of patches; lines are thin.
        let colors: Vec<RGBColor> = [RED, BLUE, GREEN, YELLOW, POLE].into_iter().chain(FURTHER).collect();
        assert_apart(&colors, 18.0);
    }

    #[test]
    fn grounds_are_told_apart_by_every_reader() {
        for (theme, least) in [(Theme::Light, 6.0), (Theme::Dark, 7.0), (Theme::Print, 4.0)] {
            // Two to three times what is just seen on large areas; the ground of the page is one of them.
            let shown: Vec<RGBColor> = TINTS.into_iter().chain([PAPER]).map(|color| theme.ground(color)).collect();
            assert_apart(&shown, least);
        }
    }

    #[test]
    fn lines_stand_out_from_grounds_in_every_theme() {
        let shades = |tint: usize| (0..3).flat_map(move |circles| ground(&Parts { tints: vec![tint, tint], circles }));
        for theme in [Theme::Light, Theme::Dark, Theme::Print] {
            for ground in (0..TINTS.len()).flat_map(shades).chain([PAPER]) {
                let against = |color: RGBColor| contrast(theme.color(color), theme.ground(ground));
                let [text, line] =
                    if [&TINTS[..], &[PAPER]].concat().contains(&ground) { [7.0, 1.8] } else { [5.5, 1.4] };
                assert!(against(INK) > text, "text in {theme:?} on {ground:?}: {}", against(INK));
                for color in [RED, BLUE, GREEN, POLE] {
                    assert!(against(color) > line, "{color:?} in {theme:?} on {ground:?}: {}", against(color));
                }
            }
        }
    }

    #[test]
    fn components_show_in_the_ground() {
        let of = |signature: &str| ground(&Parts { tints: section_tints(signature), circles: 1 });
        assert_eq!(of("S2+T2").len(), 2);
        assert_eq!(of("S2+S2+T2").len(), 3);
        let twins = of("T2+T2");
        assert!(twins.len() == 2 && twins[0] != twins[1], "{twins:?}");
        assert_ne!(of("S2+S2"), of("M3"));
    }
}
