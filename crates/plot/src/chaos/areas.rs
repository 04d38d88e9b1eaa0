//! Rectangles of one colour that lie side by side, as few larger ones.

use std::collections::BTreeMap;

use plotters::style::RGBColor;

/// A rectangle of the plane in one colour.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Area {
    /// Its energies.
    pub h: [f64; 2],
    /// Its momenta.
    pub l: [f64; 2],
    pub color: RGBColor,
}

/// Joins rectangles of the same colour that have a whole edge in common: first along h, then along l. Edges are common where their
/// numbers are the same.
pub fn merged(areas: impl Iterator<Item = ([f64; 2], [f64; 2], RGBColor)>) -> Vec<Area> {
    let areas = areas.map(|(h, l, color)| Area { h, l, color }).collect();
    let turned = |area: Area| Area { h: area.l, l: area.h, ..area };
    let rows = joined(areas);
    joined(rows.into_iter().map(turned).collect()).into_iter().map(turned).collect()
}

/// Joins those that follow each other along h.
fn joined(mut areas: Vec<Area>) -> Vec<Area> {
    areas.sort_by(|a, b| a.h[0].total_cmp(&b.h[0]).then(a.l[0].total_cmp(&b.l[0])));
    let mut done: Vec<Area> = Vec::new();
    // The last one of each row.
    let mut last: BTreeMap<[u64; 2], usize> = BTreeMap::new();
    for area in areas {
        let row = area.l.map(f64::to_bits);
        match last.get(&row).map(|&number| &mut done[number]) {
            Some(before) if before.color == area.color && before.h[1].to_bits() == area.h[0].to_bits() => {
                before.h[1] = area.h[1];
            }
            _ => {
                last.insert(row, done.len());
                done.push(area);
            }
        }
    }
    done
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_neighbours_become_one_and_others_stay() {
        let (dark, light) = (RGBColor(0, 0, 0), RGBColor(9, 9, 9));
        let cell = |i: u8, j: u8, color| {
            let along = |k: u8| [f64::from(k), f64::from(k) + 1.0];
            (along(i), along(j), color)
        };
        let square = (0..3).flat_map(|i| (0..3).map(move |j| cell(i, j, if (i, j) == (1, 1) { light } else { dark })));
        let areas = merged(square);
        let size = |area: &Area| (area.h[1] - area.h[0]) * (area.l[1] - area.l[0]);
        let of = |color| areas.iter().filter(|area| area.color == color).map(size).sum::<f64>();
        assert_eq!((of(dark), of(light), areas.len()), (8.0, 1.0, 5));
        // Twice as tall: no whole edge in common.
        let tall = ([1.0, 2.0], [0.0, 2.0], dark);
        assert_eq!(merged([cell(0, 0, dark), tall].into_iter()).len(), 2);
        assert_eq!(merged((0..3).flat_map(|i| (0..2).map(move |j| cell(i, j, dark)))).len(), 1);
    }
}
