//! Colours: apart in print and for colour-blind readers, with the paper's associations. Grounds say what a section consists
//! of: one tint for each component, in stripes where there are several.

use std::collections::BTreeMap;

use plotters::style::RGBColor;

use bifdiag_page::{FAINT_INK, rgb, rgbs};
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

/// The types of components of U with what lies above them, as boundary circles of U and genus of P, and the tint of each.
const TINTS: [((u32, u32), RGBColor); 11] = [
    ((0, 1), rgb(0xd5_eb_b4)),
    ((1, 0), rgb(0xe5_f5_ff)),
    ((1, 1), rgb(0xc7_f6_d9)),
    ((2, 1), rgb(0xb8_d7_c6)),
    ((1, 2), rgb(0xff_fd_bd)),
    ((2, 2), rgb(0xe8_c1_dd)),
    ((2, 3), rgb(0xcf_d2_ad)),
    ((3, 3), rgb(0xf1_d9_f9)),
    ((3, 4), rgb(0xd1_bf_fd)),
    ((4, 4), rgb(0x9d_f0_07)),
    ((4, 5), rgb(0xcb_d2_fb)),
];
/// Fill of a region of which nothing is known.
const UNKNOWN: RGBColor = rgb(0xe3_e3_e3);

/// The tint of a type; of those beyond the known ones that of the last.
fn of_type(circles: u32, genus: u32) -> RGBColor {
    let known = TINTS.iter().find(|(own, _)| *own == (circles, genus));
    known.map_or(TINTS[TINTS.len() - 1].1, |(_, tint)| *tint)
}

/// The tint of a component; if its section is not known, that of a component with as many circles and no pole.
fn of_component(part: &ComponentDocument) -> RGBColor {
    let genus = part.genus.unwrap_or_else(|| part.boundary_circles.saturating_sub(1));
    of_type(part.boundary_circles, if part.boundary_circles == 0 { 1 } else { genus })
}

/// The tint of a section when the part of the sphere below it is not known: that over the fewest circles, but at least
/// one.
fn of_section(name: &str) -> Option<RGBColor> {
    let genus = match name {
        "S2" => 0,
        "T2" => 1,
        name => name.strip_prefix('M')?.parse().ok()?,
    };
    let with_boundary = TINTS.iter().filter(|((circles, own), _)| *own == genus && *circles > 0);
    Some(with_boundary.min_by_key(|((circles, _), _)| *circles).map_or(TINTS[TINTS.len() - 1].1, |(_, tint)| *tint))
}

/// The ground of a region of the diagram: one colour, or those of its stripes.
pub(super) fn ground_of(region: &RegionDocument) -> Vec<RGBColor> {
    ground(region.components.iter().map(of_component))
}

/// The ground of some components; those of one type differ a little.
fn ground(tints: impl IntoIterator<Item = RGBColor>) -> Vec<RGBColor> {
    // In parts of 32, so that bytes suffice.
    let darker = |byte: u8| u8::try_from(u16::from(byte) * 29 / 32).unwrap_or(byte);
    let mut colors: Vec<RGBColor> = Vec::new();
    for mut color in tints {
        while colors.contains(&color) {
            color = RGBColor(darker(color.0), darker(color.1), darker(color.2));
        }
        colors.push(color);
    }
    if colors.is_empty() { vec![UNKNOWN] } else { colors }
}

/// One colour for the sections of a signature, such as `S2+T2`: the mean of its ground.
pub(crate) fn tint(signature: &str) -> RGBColor {
    let colors = ground(signature.split('+').filter_map(of_section));
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
    use bifdiag_page::sight::assert_apart;
    use bifdiag_page::{INK, PAPER, POLE, POLE_MINUS, Theme, color_name, contrast};

    /// Two were pale yellow.
    #[test]
    fn tints_have_names_of_their_own() {
        let words: std::collections::BTreeSet<&str> = TINTS.iter().map(|(_, tint)| color_name(*tint)).collect();
        assert_eq!(words.len(), TINTS.len(), "{words:?}");
    }

    #[test]
    fn curves_are_told_apart_by_every_reader() {
        // Ten is a clear difference of patches; lines are thin.
        let colors: Vec<RGBColor> = [RED, BLUE, GREEN, YELLOW, POLE, POLE_MINUS].into_iter().chain(FURTHER).collect();
        assert_apart(&colors, 18.0);
    }

    /// The type by its circles and poles.
    fn component(boundary_circles: u32, poles: u32) -> ComponentDocument {
        ComponentDocument {
            boundary_circles,
            poles: None,
            accessible_region: String::new(),
            energy_surface: String::new(),
            section: None,
            genus: Some(if boundary_circles == 0 { 1 } else { boundary_circles + poles - 1 }),
        }
    }

    #[test]
    fn types_are_told_apart_by_every_reader() {
        for (theme, least) in [(Theme::Light, 6.1), (Theme::Dark, 7.1), (Theme::Print, 4.05)] {
            // Two to three times what is just seen on large areas; the ground of the page is one of them.
            let shown = TINTS.iter().map(|(_, tint)| *tint).chain([PAPER, UNKNOWN]).map(|color| theme.ground(color));
            assert_apart(&shown.collect::<Vec<_>>(), least);
        }
    }

    #[test]
    fn tori_over_the_whole_sphere_and_over_a_disc_are_far_apart() {
        // Half again as far as grounds are at least.
        for (theme, least) in [(Theme::Light, 10.0), (Theme::Dark, 11.0), (Theme::Print, 6.0)] {
            assert_apart(&[of_type(0, 1), of_type(1, 1)].map(|color| theme.ground(color)), least);
        }
    }

    #[test]
    fn each_type_that_occurs_has_a_tint_of_its_own() {
        let occur = [(0, 2), (1, 0), (1, 1), (1, 2), (2, 0), (2, 1), (2, 2), (3, 1), (3, 2), (4, 1), (4, 2)];
        let tints = occur.map(|(circles, poles)| of_component(&component(circles, poles)));
        let all: std::collections::BTreeSet<[u8; 3]> = tints.into_iter().map(|tint| [tint.0, tint.1, tint.2]).collect();
        assert_eq!(all.len(), occur.len());
        assert_eq!(tint("T2"), of_component(&component(1, 1)));
    }

    #[test]
    fn pole_lines_differ_in_colour_and_dash() {
        assert_apart(&[POLE, POLE_MINUS], 40.0);
        let [plus, minus] = [CurveKind::PolePlus, CurveKind::PoleMinus].map(crate::diagram::stroke::pole_pattern);
        let lengths = |pattern: &[bifdiag_page::Dash]| pattern.iter().map(|dash| dash.1).collect::<Vec<f64>>();
        assert_ne!(lengths(&plus), lengths(&minus));
    }

    #[test]
    fn lines_stand_out_from_grounds_in_every_theme() {
        let tints = || TINTS.iter().map(|(_, tint)| *tint);
        for theme in [Theme::Light, Theme::Dark, Theme::Print] {
            for shade in tints().flat_map(|tint| ground([tint, tint])).chain([PAPER]) {
                let against = |color: RGBColor| contrast(theme.color(color), theme.ground(shade));
                let is_pure = tints().chain([PAPER]).any(|tint| tint == shade);
                let [text, line] = if is_pure { [7.0, 1.8] } else { [5.5, 1.4] };
                assert!(against(INK) > text, "text in {theme:?} on {shade:?}: {}", against(INK));
                for color in [RED, BLUE, GREEN, POLE, POLE_MINUS] {
                    assert!(against(color) > line, "{color:?} in {theme:?} on {shade:?}: {}", against(color));
                }
            }
        }
    }

    #[test]
    fn components_show_in_the_ground() {
        let of = |signature: &str| ground(signature.split('+').filter_map(of_section));
        assert_eq!(of("S2+T2").len(), 2);
        assert_eq!(of("S2+S2+T2").len(), 3);
        let twins = of("T2+T2");
        assert!(twins.len() == 2 && twins[0] != twins[1], "{twins:?}");
        assert_ne!(of("S2+S2"), of("M3"));
    }
}
