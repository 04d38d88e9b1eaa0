//! The part below the views: the legend, and the table of the relative equilibria with the position and stability of
//! each and the rate of the motions near it.

use bifdiag_schema::{ComponentDocument, Multiplicity, Reason, RelativeEquilibriumDocument, small_motions};
use plotters::style::RGBColor;

use super::marks::{self, SphereMark};
use super::scene::SphereScene;
use bifdiag_page::{
    Canvas, INK, Ink, Legend, Symbol, Table, letter, rgb, rgbs, section_type, short_number, short_time,
};

/// Ground where U > h.
pub(super) const FORBIDDEN: RGBColor = rgb(0xd9_d9_d9);
/// Tints of components, apart from each other and from that for every reader.
const TINTS: [RGBColor; 5] = rgbs([0xc7_e5_ff, 0xff_e8_85, 0x9e_ba_9e, 0xee_b7_87, 0xd8_b2_f7]);
/// ∂U.
pub(super) const BOUNDARY: Ink = Ink { color: INK, width: 1.8 };
/// Other levels.
pub(super) const LEVEL: Ink = Ink { color: rgb(0x8c_8c_8c), width: 0.6 };
/// The tint of the component at a place of the canonical order.
pub(super) fn tint(place: usize) -> RGBColor {
    TINTS[place % TINTS.len()]
}

/// What the scene needs explained, in rows of `width` pixels.
pub(super) fn legend(scene: &SphereScene<'_>, has_levels: bool, width: f64) -> Legend {
    let components = scene.components.iter().enumerate();
    let mut entries: Vec<(Symbol, String)> = components
        .map(|(place, component)| (Symbol::Swatch(vec![tint(place)]), sentence(place + 1, component)))
        .collect();
    if entries.is_empty() {
        entries.push((Symbol::Swatch(vec![tint(0)]), "accessible: U(γ) ≤ h".to_owned()));
    }
    let is_whole = matches!(scene.components, [component] if component.boundary_circles == 0);
    if !is_whole {
        entries.push((Symbol::Swatch(vec![FORBIDDEN]), "not accessible: U(γ) > h".to_owned()));
        entries.push((Symbol::solid(BOUNDARY), "∂U: U(γ) = h".to_owned()));
    }
    if has_levels {
        entries.push((Symbol::solid(LEVEL), "other levels of U".to_owned()));
    }
    if scene.r_hat.is_some() {
        entries.push((symbol(SphereMark::Pole(true)), "+r̂, hanging".to_owned()));
        entries.push((symbol(SphereMark::Pole(false)), "−r̂, upright".to_owned()));
    }
    Legend::new(entries, width)
}

/// A component in words: its boundary circles and poles, and what lies above it.
fn sentence(number: usize, component: &ComponentDocument) -> String {
    let circles = match component.boundary_circles {
        0 => "the whole sphere".to_owned(),
        1 => "1 boundary circle".to_owned(),
        many => format!("{many} boundary circles"),
    };
    let poles = match component.poles.as_deref() {
        None => String::new(),
        Some([]) => ", no pole".to_owned(),
        Some([pole]) => format!(", pole {}r̂", pole.replace('-', "−")),
        Some(_) => ", both poles".to_owned(),
    };
    let section = component
        .section
        .as_ref()
        .zip(component.genus)
        .map_or_else(String::new, |(section, genus)| format!(", P = {} (genus {genus})", section_type(section)));
    let energy = component.energy_surface.replace("S1xS2", "S¹×S²").replace("RP3", "RP³").replace("S3", "S³");
    format!("{number}: {circles}{poles};  E = {energy}{section}")
}

/// A mark as a symbol.
fn symbol(mark: SphereMark) -> Symbol {
    Symbol::Mark("marker", Box::new(move |canvas: &Canvas, at| marks::draw(canvas, mark, at)))
}

/// Significant digits of an energy, at least and at most.
const DIGITS: [usize; 2] = [5, 15];
/// Energies are equal when they differ by less, relative to the largest: those of pairs do by rounding.
const EQUAL: f64 = 1e-14;

/// As many digits as distinguish different energies, which are given in rising order.
fn energies(h: &[f64]) -> Vec<String> {
    let largest = h.iter().fold(0.0_f64, |largest, h| largest.max(h.abs()));
    let printed = |digits: usize| h.iter().map(|h| short_number(*h, digits)).collect::<Vec<_>>();
    let are_apart = |texts: &Vec<String>| {
        let mut pairs = h.windows(2).zip(texts.windows(2));
        pairs.all(|(h, texts)| h[1] - h[0] <= EQUAL * largest || texts[0] != texts[1])
    };
    (DIGITS[0]..DIGITS[1]).map(printed).find(are_apart).unwrap_or_else(|| printed(DIGITS[1]))
}

/// Columns that are left out where all would be too high, the least first: from which on, and a note on them.
const LEFT_OUT: [(usize, &str); 2] = [
    (6, "periods and growth: bifdiag critical prints them"),
    (4, "types, stability, periods and growth: bifdiag critical prints them"),
];

/// One row for each relative equilibrium, as each has its letter in the views, and as many columns as find room.
pub(super) fn equilibria(scene: &SphereScene<'_>, [width, height]: [f64; 2]) -> Table {
    let full = columns(scene, width, usize::MAX);
    let shorter = LEFT_OUT.into_iter().map(|(count, note)| columns(scene, width, count).with_note(note));
    let mut last = full;
    for table in shorter {
        if last.height() <= height {
            break;
        }
        last = table;
    }
    last
}

/// The first columns of the table.
fn columns(scene: &SphereScene<'_>, room: f64, count: usize) -> Table {
    let times = if scene.time_unit.is_empty() { String::new() } else { format!(" in {}", scene.time_unit) };
    let heading = ["", "relative equilibrium", "h", "of U", "linear type", "stability"].map(str::to_owned);
    let motions = format!("small motions: period, or time of growth by a factor of e{times}");
    let heading = heading.into_iter().chain([motions]).take(count).collect();
    let h: Vec<f64> = scene.equilibria.iter().map(|point| point.h).collect();
    let rows = scene.equilibria.iter().zip(energies(&h)).enumerate().map(|(place, (point, h))| {
        let cells = [
            letter(place),
            format!("{}, {}", point.branch, point.branch_name),
            h,
            kind(point).to_owned(),
            point.stability.word().to_owned(),
            point.nonlinear.to_string(),
            small_motions(&[point.eigenvalues], short_time),
        ];
        (symbol(SphereMark::of(point)), cells.into_iter().take(count).collect())
    });
    Table::new(heading, rows.collect(), room)
}

fn kind(point: &RelativeEquilibriumDocument) -> &'static str {
    match (point.multiplicity, point.index) {
        (Multiplicity::Sphere, _) => "constant",
        (Multiplicity::Circle, 0) if point.nonlinear.why == Reason::Energy => "circle of minima",
        // A circle at its cusp.
        (Multiplicity::Circle, 0) | (Multiplicity::Points(2..), _) => "degenerate",
        (Multiplicity::Circle, _) => "circle of maxima",
        (Multiplicity::Points(_), 0) => "minimum",
        (Multiplicity::Points(_), 1) => "saddle",
        (Multiplicity::Points(_), _) => "maximum",
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use bifdiag_page::Theme;
    use bifdiag_page::sight::assert_apart;

    #[test]
    fn energies_have_the_digits_that_tell_them_apart() {
        assert_eq!(energies(&[1.0 / 3.0, 2.0 / 3.0]), ["0.33333", "0.66667"]);
        assert_eq!(energies(&[-1.0, 1.793_331_2, 1.793_331_9]), ["−1", "1.793331", "1.793332"]);
        // A pair, equal up to rounding.
        assert_eq!(energies(&[0.1 + 0.2, 0.3 + 1e-15]), ["0.3", "0.3"]);
    }

    #[test]
    fn components_are_told_apart_by_every_reader() {
        for theme in [Theme::Light, Theme::Dark] {
            let shown: Vec<RGBColor> = TINTS.into_iter().chain([FORBIDDEN]).map(|color| theme.ground(color)).collect();
            // A clear difference of patches.
            assert_apart(&shown, 10.0);
        }
    }
}
