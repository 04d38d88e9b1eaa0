//! Colours: apart in print and for colour-blind readers, with the paper's associations.

use std::collections::BTreeMap;

use plotters::style::RGBColor;

use crate::page::{FAINT_INK, rgb, rgbs};
use schema::{AtlasDocument, CurveDocument, CurveKind};

/// The branch of the global minimum.
const RED: RGBColor = rgb(0xc2_14_2d);
/// The branch that starts at −r̂.
const BLUE: RGBColor = rgb(0x12_50_a8);
/// A symmetric pair.
const GREEN: RGBColor = rgb(0x00_8a_5e);
/// The branch with a cusp in the paper's body.
const YELLOW: RGBColor = rgb(0xc9_a8_00);
/// Branches beyond the paper's four.
const FURTHER: [RGBColor; 5] = rgbs([0x8e_3b_9e, 0x1f_a3_c4, 0x7a_4a_21, 0xd4_6a_a0, 0x6b_6b_6b]);

/// Light grounds of the regions, one for each type of section.
const TINTS: [(&str, u32); 12] = [
    ("S2", 0xdf_eb_f7),
    ("T2", 0xe6_f3_d8),
    ("M2", 0xff_f1_c9),
    ("M3", 0xfb_dd_d3),
    ("M4", 0xe9_d6_d6),
    ("S2+S2", 0xd0_e8_ee),
    ("S2+T2", 0xdd_d9_f0),
    ("T2+T2", 0xf5_dd_ee),
    ("M2+S2", 0xea_e4_d0),
    ("M2+T2", 0xd5_ef_e2),
    ("M3+S2", 0xf7_e2_c0),
    ("S2+S2+T2", 0xe3_e3_e3),
];

/// The ground of a region whose printed type is `signature` (a signature, or components of U joined by `+`), with
/// `circles` boundary circles of U: regions with sections of one type and different U differ a little.
pub(crate) fn tint(signature: &str, circles: u32) -> RGBColor {
    let mut parts: Vec<&str> = signature.split('+').collect();
    parts.sort_unstable();
    let name = parts.join("+");
    let sum: usize = name.bytes().enumerate().map(|(place, byte)| (place + 1) * usize::from(byte)).sum();
    let known = TINTS.iter().find(|(known, _)| *known == name);
    let RGBColor(red, green, blue) = rgb(known.unwrap_or(&TINTS[sum % TINTS.len()]).1);
    // In parts of 32, so that bytes suffice.
    let shade = [32, 30, 31][(circles % 3) as usize];
    let darker = |byte: u8| u8::try_from(u16::from(byte) * shade / 32).unwrap_or(byte);
    RGBColor(darker(red), darker(green), darker(blue))
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
    let at_start = |curve: &&&CurveDocument| curve.l_range[0].is_none_or(|l| l == 0.0) && !curve.polyline.is_empty();
    let start = |curve: &CurveDocument| curve.polyline.first().map_or(0.0, |point| point[0]);
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
