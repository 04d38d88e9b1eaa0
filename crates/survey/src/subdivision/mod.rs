//! A rectangle divided by what its points show, along borders that are found on the sides of a grid.
//!
//! A cell whose sides the borders cross twice is cut along the chord of the two crossings; where more come together it is
//! quartered, until what is left is cut along chords between crossings of one kind, or is a star about their middle. A strip
//! narrower than a cell is followed straight on from side to side. Borders are exact on the sides of cells, and straight
//! between.

mod division;
mod lattice;
mod pieces;
mod strip;
mod trial;

use std::collections::{BTreeMap, BTreeSet};

use division::Division;
pub use division::{Changes, LabelledPlane};
pub use lattice::PlanePoint;
use lattice::{LatticeCell, UNIT};
pub use pieces::Subdivision;

/// Divides the rectangle of a grid with these values of the two coordinates and what is shown at its points, row by row
/// from below.
pub fn divide<P: LabelledPlane>(plane: &P, axes: [&[f64]; 2], shown: &[P::Label]) -> Subdivision<P::Label> {
    let [columns, rows] = axes.map(|values| u32::try_from(values.len().saturating_sub(1)).unwrap_or(0));
    let mut division = Division {
        plane,
        axes,
        labels: BTreeMap::new(),
        sides: BTreeMap::new(),
        joined: BTreeMap::new(),
        seen: Vec::new(),
        bends: BTreeMap::new(),
    };
    let nodes = (0..=rows).flat_map(|row| (0..=columns).map(move |column| [column * UNIT, row * UNIT]));
    division.labels = nodes.zip(shown.iter().cloned()).collect();
    let cell = |row, column| LatticeCell { from: [column * UNIT, row * UNIT], size: UNIT };
    let mut cells: Vec<LatticeCell> =
        (0..rows).flat_map(|row| (0..columns).map(move |column| cell(row, column))).collect();
    division.learn_sides(cells.iter().flat_map(|cell| cell.sides()).collect());
    let mut followed = BTreeSet::new();
    let mut tried = BTreeSet::new();
    let mut wrong: Vec<LatticeCell> = Vec::new();
    loop {
        let is_open = |cell: &&LatticeCell| division.is_open(**cell) || wrong.contains(cell);
        let (open, mut done): (Vec<LatticeCell>, Vec<LatticeCell>) = cells.iter().partition(is_open);
        if open.is_empty() {
            if division.follow(&cells, &mut followed) {
                continue;
            }
            wrong = division.try_parts(&cells, &mut tried);
            if wrong.is_empty() {
                break;
            }
            continue;
        }
        division.split(&open);
        done.extend(open.into_iter().flat_map(LatticeCell::quarters));
        cells = done;
    }
    cells.sort_by_key(|cell| [cell.from[1], cell.from[0]]);
    division.look_between();
    division.cut(&cells)
}

#[cfg(test)]
mod tests {
    use super::lattice::area;
    use super::*;

    /// Three lands: a disc, and beside it left and right of a slanted line.
    struct Lands;

    fn land([x, y]: PlanePoint) -> u8 {
        if (x - 0.4) * (x - 0.4) + (y - 0.55) * (y - 0.55) < 0.07 {
            0
        } else if x + 0.3 * y < 0.57 {
            1
        } else {
            2
        }
    }

    impl LabelledPlane for Lands {
        type Label = u8;

        fn labels(&self, places: &[PlanePoint]) -> Vec<u8> {
            places.iter().copied().map(land).collect()
        }

        fn changes(&self, ways: &[[PlanePoint; 2]]) -> Vec<Vec<(f64, [u8; 2])>> {
            let on = |[p, q]: &[PlanePoint; 2], t: f64| [p[0] + (q[0] - p[0]) * t, p[1] + (q[1] - p[1]) * t];
            let of = |way: &[PlanePoint; 2]| {
                let at = |k: u32| f64::from(k) / 4096.0;
                let pair = |k: u32| [land(on(way, at(k))), land(on(way, at(k + 1)))];
                (0..4096).map(|k| (at(k) + 0.5 / 4096.0, pair(k))).filter(|(_, [p, q])| p != q).collect()
            };
            ways.iter().map(of).collect()
        }
    }

    pub(super) fn holds(corners: &[PlanePoint], [x, y]: PlanePoint) -> bool {
        let next = corners.iter().cycle().skip(1);
        let crossed = |(p, q): &(&PlanePoint, &PlanePoint)| {
            (p[1] > y) != (q[1] > y) && x < p[0] + (y - p[1]) / (q[1] - p[1]) * (q[0] - p[0])
        };
        corners.iter().zip(next).filter(crossed).count() % 2 == 1
    }

    #[test]
    fn pieces_fill_the_rectangle_and_show_what_is_there() {
        // A cell is wider than what is between the lands at their meeting points.
        let axes: [Vec<f64>; 2] =
            [17, 13].map(|count| (0..count).map(|k| f64::from(k) / f64::from(count - 1)).collect());
        let shown: Vec<u8> = axes[1].iter().flat_map(|&y| axes[0].iter().map(move |&x| land([x, y]))).collect();
        let subdivision = divide(&Lands, [&axes[0], &axes[1]], &shown);
        let total: f64 = subdivision.pieces.iter().map(|(_, corners)| area(corners)).sum();
        assert!((total - 1.0).abs() < 1e-9, "{total}");
        let disc: f64 =
            subdivision.pieces.iter().filter(|(label, _)| *label == 0).map(|(_, corners)| area(corners)).sum();
        // Chords of a sixteenth in a circle of radius 0.26 leave out 1 % of it.
        assert!((disc / (0.07 * std::f64::consts::PI) - 1.0).abs() < 0.03, "{disc}");
        let mut wrong = 0;
        for k in 0..10_000_u32 {
            let at = [0.754_877_666_246_692_8, 0.569_840_290_998_053_3].map(|step| (f64::from(k) * step).fract());
            let found: Vec<u8> =
                subdivision.pieces.iter().filter(|(_, piece)| holds(piece, at)).map(|(label, _)| *label).collect();
            assert_eq!(found.len(), 1, "{at:?}");
            wrong += u32::from(found[0] != land(at));
        }
        assert!(subdivision.seen.iter().all(|(label, at)| land(*at) == *label));
        assert!(wrong < 100, "{wrong} of 10000 points lie in a piece that shows another land");
        assert!(!subdivision.borders.is_empty());
    }

    /// A strip with a middle and half a width at each x, here and there between the points of the lattice.
    struct Strip {
        at: fn(f64) -> (f64, f64),
    }

    impl Strip {
        fn shows(&self, [x, y]: PlanePoint) -> bool {
            let (middle, half) = (self.at)(x);
            (y - middle).abs() < half
        }
    }

    impl LabelledPlane for Strip {
        type Label = bool;

        fn labels(&self, places: &[PlanePoint]) -> Vec<bool> {
            places.iter().map(|place| self.shows(*place)).collect()
        }

        fn changes(&self, ways: &[[PlanePoint; 2]]) -> Vec<Vec<(f64, [bool; 2])>> {
            let on = |[p, q]: &[PlanePoint; 2], t: f64| [p[0] + (q[0] - p[0]) * t, p[1] + (q[1] - p[1]) * t];
            let of = |way: &[PlanePoint; 2]| {
                let (mut low, mut high) = (0.0, 1.0);
                let ends = [self.shows(way[0]), self.shows(way[1])];
                while high - low > 1e-9 {
                    let middle = f64::midpoint(low, high);
                    *(if self.shows(on(way, middle)) == ends[0] { &mut low } else { &mut high }) = middle;
                }
                if ends[0] == ends[1] { Vec::new() } else { vec![(low, ends)] }
            };
            ways.iter().map(of).collect()
        }
    }

    #[test]
    fn a_narrow_strip_is_one_piece_to_its_tip() {
        // One that is hit at one point of the lattice, one along a whole diagonal, and one that becomes wider.
        let strips = [
            Strip { at: |x| (0.21 + 0.43 * x + 0.1 * x * x, 0.02 * (0.9 - x)) },
            Strip { at: |x| (x, 0.003) },
            Strip { at: |x| (0.007 + 0.33 * x, 0.01 * (x - 0.1)) },
        ];
        let axes: [Vec<f64>; 2] = [9, 9].map(|count| (0..count).map(|k| f64::from(k) / 8.0).collect());
        for (number, strip) in strips.iter().enumerate() {
            let row = |y: f64| axes[0].iter().map(move |&x| strip.shows([x, y]));
            let shown: Vec<bool> = axes[1].iter().flat_map(|&y| row(y)).collect();
            let subdivision = divide(strip, [&axes[0], &axes[1]], &shown);
            for x in (0..1000).map(|k| 1e-3 * (f64::from(k) + 0.37)) {
                let (middle, half) = (strip.at)(x);
                // Not at the tip.
                let places = [(middle, true), (middle + 1.3 * half, false), (middle - 1.3 * half, false)];
                for (y, is_inside) in places.into_iter().filter(|(y, _)| half > 1e-3 && (0.0..1.0).contains(y)) {
                    let found =
                        subdivision.pieces.iter().find(|(_, piece)| holds(piece, [x, y])).map(|(label, _)| *label);
                    assert_eq!(found, Some(is_inside), "strip {number} at {x}, {y}");
                }
            }
            let total: f64 = subdivision.pieces.iter().map(|(_, corners)| area(corners)).sum();
            assert!((total - 1.0).abs() < 1e-9, "{total}");
        }
    }

    #[test]
    fn one_land_has_no_border() {
        struct Sea;
        impl LabelledPlane for Sea {
            type Label = ();
            fn labels(&self, places: &[PlanePoint]) -> Vec<()> {
                vec![(); places.len()]
            }
            fn changes(&self, ways: &[[PlanePoint; 2]]) -> Vec<Vec<(f64, [(); 2])>> {
                vec![Vec::new(); ways.len()]
            }
        }
        let values = [0.0, 1.0, 2.0];
        let subdivision = divide(&Sea, [&values, &values], &[(); 9]);
        assert_eq!((subdivision.pieces.len(), subdivision.borders.len()), (2, 0), "a strip for each row");
    }
}
