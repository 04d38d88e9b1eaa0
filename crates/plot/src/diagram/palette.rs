//! Colours: apart in print and for colour-blind readers, with the paper's associations. Grounds say what a section consists
//! of: one tint for each component, in stripes where there are several.

use std::collections::BTreeMap;

use plotters::style::RGBColor;

use crate::page::{FAINT_INK, rgb, rgbs};
use bifdiag_schema::{AtlasDocument, ComponentDocument, CurveDocument, CurveKind, RegionDocument};

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

/// The tints of components: S² or D², T², then with rising genus or number of circles; the last is that of the whole sphere,
/// over which P is a torus too.
const TINTS: [RGBColor; 7] = rgbs([0xd4_de_f8, 0xdd_f3_e0, 0xf9_f0_b8, 0xf6_cf_ba, 0xd9_c2_f2, 0xf4_b7_c9, 0xae_e4_96]);
/// The place of the whole sphere.
const SPHERE: usize = TINTS.len() - 1;
/// Ground of a region of which nothing is known.
const UNKNOWN: RGBColor = rgb(0xe3_e3_e3);

/// What a region consists of, as far as its ground tells it.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Parts {
    /// The places of the components in [`TINTS`].
    tints: Vec<usize>,
    /// Boundary circles of U.
    circles: u32,
}

impl Parts {
    fn of(region: &RegionDocument) -> Self {
        let circles = region.components.iter().map(|part| part.boundary_circles).sum();
        Self { tints: tints(region.signature.as_deref(), &region.components), circles }
    }
}

/// The tints of components: by their sections or, where there are none, by their boundary circles. The whole sphere is always
/// one component.
fn tints(signature: Option<&str>, components: &[ComponentDocument]) -> Vec<usize> {
    let by_circles = |part: &ComponentDocument| match part.boundary_circles {
        0 | 1 => 0,
        many => usize::try_from(many).unwrap_or(SPHERE).min(SPHERE - 1),
    };
    match (components, signature) {
        ([whole], _) if whole.boundary_circles == 0 => vec![SPHERE],
        (_, Some(signature)) => signature.split('+').filter_map(section_tint).collect(),
        (parts, None) => parts.iter().map(by_circles).collect(),
    }
}

/// The tint of a section over a part of the sphere.
fn section_tint(name: &str) -> Option<usize> {
    match name {
        "S2" => Some(0),
        "T2" => Some(1),
        name => name.strip_prefix('M')?.parse().ok().map(|genus: usize| genus.min(SPHERE - 1)),
    }
}

/// The ground of a region of the diagram.
pub(super) fn ground_of(region: &RegionDocument) -> Vec<RGBColor> {
    ground(&Parts::of(region))
}

/// The ground of a region: one colour, or those of its stripes. Regions with sections of one type and different U differ a
/// little, and so do components of one type.
fn ground(parts: &Parts) -> Vec<RGBColor> {
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
    let tints = signature.split('+').filter_map(section_tint).collect();
    let colors = ground(&Parts { tints, circles: 0 });
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
    use crate::page::{INK, PAPER, POLE, POLE_MINUS, Theme, contrast};

    #[test]
    fn curves_are_told_apart_by_every_reader() {
        // Ten is a clear difference of patches; lines are thin.
        let colors: Vec<RGBColor> = [RED, BLUE, GREEN, YELLOW, POLE, POLE_MINUS].into_iter().chain(FURTHER).collect();
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
    fn tori_over_the_whole_sphere_and_over_a_disc_are_far_apart() {
        // Half again as far as grounds are at least.
        for (theme, least) in [(Theme::Light, 10.0), (Theme::Dark, 11.0), (Theme::Print, 6.0)] {
            assert_apart(&[TINTS[SPHERE], TINTS[1]].map(|color| theme.ground(color)), least);
        }
        let over = |boundary_circles| ComponentDocument {
            boundary_circles,
            poles: None,
            accessible_region: String::new(),
            energy_surface: String::new(),
            section: Some("T2".to_owned()),
            genus: Some(1),
        };
        let tint = |boundary_circles| tints(Some("T2"), &[over(boundary_circles)]);
        assert_eq!([tint(0), tint(1), tint(2)], [[SPHERE], [1], [1]]);
    }

    #[test]
    fn pole_lines_differ_in_colour_and_dash() {
        assert_apart(&[POLE, POLE_MINUS], 40.0);
        let [plus, minus] = [CurveKind::PolePlus, CurveKind::PoleMinus].map(crate::diagram::stroke::pole_pattern);
        let lengths = |pattern: &[crate::page::Dash]| pattern.iter().map(|dash| dash.1).collect::<Vec<f64>>();
        assert_ne!(lengths(&plus), lengths(&minus));
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
                for color in [RED, BLUE, GREEN, POLE, POLE_MINUS] {
                    assert!(against(color) > line, "{color:?} in {theme:?} on {ground:?}: {}", against(color));
                }
            }
        }
    }

    #[test]
    fn components_show_in_the_ground() {
        let of = |signature: &str| {
            let tints = signature.split('+').filter_map(section_tint).collect();
            ground(&Parts { tints, circles: 1 })
        };
        assert_eq!(of("S2+T2").len(), 2);
        assert_eq!(of("S2+S2+T2").len(), 3);
        let twins = of("T2+T2");
        assert!(twins.len() == 2 && twins[0] != twins[1], "{twins:?}");
        assert_ne!(of("S2+S2"), of("M3"));
    }
}
