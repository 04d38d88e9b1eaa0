//! Whether the parts of cells show what the plane shows there.

use std::collections::BTreeSet;

use super::division::{Division, LabelledPlane};
use super::lattice::{LatticeCell, LatticeNode, PlanePoint, area, mean};
use super::pieces::{changes_of, joinings, parts};

/// Where on a chord the way to its bend begins: not in the middle, where special points lie.
const ALONG: f64 = 0.45;
/// Parts of less than this share of a cell show nothing.
const SEEN: f64 = 1e-6;

/// Parts of a cell that were tried.
struct CellTrial<L> {
    /// How its changes are joined.
    partners: Vec<usize>,
    /// What its parts show, and their corners.
    parts: Vec<(Option<L>, Vec<PlanePoint>)>,
    /// Which of them differ from the plane between their corners.
    wrong: Vec<usize>,
}

impl<P: LabelledPlane> Division<'_, P> {
    /// Looks at the parts of cells. Where changes can be joined in several ways, that which shows fewest wrong parts is kept;
    /// where a border has one chord that is wrong, its cell is quartered (these cells are returned), and in one of the finest lattice it
    /// is bent.
    pub(super) fn try_parts(
        &mut self,
        cells: &[LatticeCell],
        tried: &mut BTreeSet<(LatticeNode, u32, usize)>,
    ) -> Vec<LatticeCell> {
        let count = |cell: &LatticeCell| cell.sides().iter().map(|side| self.changes(*side).len()).sum::<usize>();
        let is_new = |cell: &LatticeCell| tried.insert((cell.from, cell.size, count(cell)));
        let new: Vec<LatticeCell> = cells.iter().copied().filter(is_new).collect();
        let mut open = Vec::new();
        let mut bent = Vec::new();
        for (cell, mut trials) in self.trials(&new) {
            let Some(best) = (0..trials.len()).min_by_key(|&k| trials[k].wrong.len()) else { continue };
            let CellTrial { partners, parts, wrong } = trials.swap_remove(best);
            if partners.len() > 2 {
                self.joined.insert((cell.from, cell.size), partners);
            } else if let (Some(&part), true) = (wrong.first(), cell.size == 1) {
                bent.push((cell, parts.into_iter().map(|(_, corners)| corners).nth(part).unwrap_or_default()));
            } else if !wrong.is_empty() {
                open.push(cell);
            }
        }
        self.bend(bent);
        open
    }

    /// The parts of cells for each way to join their changes.
    fn trials(&mut self, cells: &[LatticeCell]) -> Vec<(LatticeCell, Vec<CellTrial<P::Label>>)> {
        let mut places = Vec::new();
        let mut all = Vec::new();
        for &cell in cells {
            let round = self.round(cell);
            let changes = changes_of(&round);
            if changes.is_empty() {
                continue;
            }
            let ways = joinings(&round, &changes);
            // One way to join several needs no look, nor does the tip of a strip.
            let is_tip = || round[changes[0]].side == round[changes[1]].side;
            if ways.is_empty() || ways.len() == 1 && (changes.len() > 2 || is_tip()) {
                continue;
            }
            let trial = |partners: Vec<usize>| {
                let parts = parts(&round, &changes, &partners, None);
                CellTrial { partners, parts, wrong: Vec::new() }
            };
            let trials: Vec<CellTrial<P::Label>> = ways.into_iter().map(trial).collect();
            places.extend(
                trials
                    .iter()
                    .flat_map(|trial| &trial.parts)
                    .map(|(_, corners)| self.place(mean(corners.iter().copied()))),
            );
            all.push((cell, trials));
        }
        let shown = self.plane.labels(&places);
        self.seen.extend(shown.iter().cloned().zip(places));
        let mut shown = shown.into_iter();
        for (cell, trials) in &mut all {
            let least = SEEN * f64::from(cell.size * cell.size);
            for trial in trials {
                let is_wrong = |(label, corners): &(Option<P::Label>, Vec<PlanePoint>)| {
                    shown.next() != *label && area(corners).abs() > least
                };
                let is_wrong: Vec<bool> = trial.parts.iter().map(is_wrong).collect();
                trial.wrong = (0..is_wrong.len()).filter(|&part| is_wrong[part]).collect();
            }
        }
        all
    }

    /// Bends the chords of cells: towards the corners of the part that shows something else.
    fn bend(&mut self, cells: Vec<(LatticeCell, Vec<PlanePoint>)>) {
        let way = |(cell, part): (LatticeCell, Vec<PlanePoint>)| {
            let round = self.round(cell);
            let ends: Vec<PlanePoint> = changes_of(&round).into_iter().map(|k| round[k].at).collect();
            let [from, to] = ends[..] else { return None };
            let is_corner = |at: &PlanePoint| round.iter().any(|stop| stop.after.is_none() && stop.at == *at);
            let corners = || part.iter().copied().filter(|at| is_corner(at) && *at != from && *at != to);
            let start = [0, 1].map(|axis| from[axis] + ALONG * (to[axis] - from[axis]));
            corners().next().map(|_| (cell, [start, mean(corners())]))
        };
        let ways: Vec<(LatticeCell, [PlanePoint; 2])> = cells.into_iter().filter_map(way).collect();
        let drawn: Vec<[PlanePoint; 2]> = ways.iter().map(|(_, way)| way.map(|at| self.place(at))).collect();
        for ((cell, [from, to]), found) in ways.into_iter().zip(self.plane.changes(&drawn)) {
            if let Some((share, _)) = found.first() {
                self.bends.insert(cell.from, [0, 1].map(|axis| from[axis] + share * (to[axis] - from[axis])));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::holds;
    use super::super::{Changes, LabelledPlane, divide};
    use super::*;

    /// Lands whose borders cross a way where some functions vanish.
    struct Lands {
        land: fn(PlanePoint) -> u8,
        /// Each is linear on a way along an axis.
        zeros: fn(PlanePoint) -> Vec<f64>,
    }

    impl LabelledPlane for Lands {
        type Label = u8;

        fn labels(&self, places: &[PlanePoint]) -> Vec<u8> {
            places.iter().map(|place| (self.land)(*place)).collect()
        }

        fn changes(&self, ways: &[[PlanePoint; 2]]) -> Vec<Changes<u8>> {
            let of = |[p, q]: &[PlanePoint; 2]| {
                let on = |t: f64| if t == 1.0 { *q } else { [p[0] + (q[0] - p[0]) * t, p[1] + (q[1] - p[1]) * t] };
                let ends = (self.zeros)(*p).into_iter().zip((self.zeros)(*q));
                let mut cuts: Vec<f64> = ends.map(|(f, g)| f / (f - g)).filter(|t| (0.0..=1.0).contains(t)).collect();
                cuts.extend([0.0, 1.0]);
                cuts.sort_by(f64::total_cmp);
                cuts.dedup();
                // The land at both ends may be a line's own.
                let inner = cuts.windows(2).map(|pair| (pair[0], (self.land)(on(f64::midpoint(pair[0], pair[1])))));
                let shown: Vec<(f64, u8)> = inner.chain([(1.0, (self.land)(on(1.0)))]).collect();
                let before = [(self.land)(on(0.0))].into_iter().chain(shown.iter().map(|(_, land)| *land));
                let changes = before.zip(&shown).map(|(before, (at, after))| (*at, [before, *after]));
                changes.filter(|(_, [before, after])| before != after).collect()
            };
            ways.iter().map(of).collect()
        }
    }

    /// Which places the subdivision of a grid of 8 × 8 cells shows otherwise than the plane.
    fn wrong(plane: &Lands, places: impl Iterator<Item = PlanePoint>) -> Vec<PlanePoint> {
        let axis: Vec<f64> = (0..=8).map(|k| f64::from(k) / 8.0).collect();
        let shown: Vec<u8> = axis.iter().flat_map(|&y| axis.iter().map(move |&x| (plane.land)([x, y]))).collect();
        let subdivision = divide(plane, [&axis, &axis], &shown);
        let total: f64 = subdivision.pieces.iter().map(|(_, corners)| area(corners).abs()).sum();
        assert!((total - 1.0).abs() < 1e-9, "{total}");
        let at =
            |place: PlanePoint| subdivision.pieces.iter().find(|(_, piece)| holds(piece, place)).map(|(land, _)| *land);
        places.filter(|place| at(*place) != Some((plane.land)(*place))).collect()
    }

    /// A wedge about the diagonal, which shows something of its own, with its tip in the upper corner.
    const WEDGE: Lands = Lands {
        land: |[x, y]| {
            if x == y { 2 } else { u8::from((x - y).abs() < 0.08 * (2.0 - x - y)) }
        },
        zeros: |[x, y]| vec![x - y, x - y - 0.08 * (2.0 - x - y), y - x - 0.08 * (2.0 - x - y)],
    };

    #[test]
    fn a_wedge_with_a_line_of_its_own_is_one_piece_to_its_tip() {
        // To the last cell of the finest lattice.
        let beside = [-1.2, -0.8, -0.4, 0.4, 0.8, 1.2];
        let places = (1..1000).flat_map(|k| beside.map(|part| (1e-3 * f64::from(k), part)));
        let places = places.map(|(t, part)| [t + 0.08 * part * (1.0 - t), t - 0.08 * part * (1.0 - t)]);
        let inside = places.filter(|place| place.iter().all(|x| (0.0..1.0).contains(x)) && place[0] < 1.0 - 1.0 / 64.0);
        assert_eq!(wrong(&WEDGE, inside), Vec::<PlanePoint>::new());
    }

    #[test]
    fn four_lands_meet_in_a_point() {
        // Straight borders through a point of no lattice.
        const SIDES: fn(PlanePoint) -> [f64; 2] = |[x, y]| [x - 0.41 - 0.2 * (y - 0.57), y - 0.57 + 0.3 * (x - 0.41)];
        let plane = Lands {
            land: |place| SIDES(place).into_iter().enumerate().map(|(k, side)| u8::from(side > 0.0) << k).sum(),
            zeros: |place| SIDES(place).to_vec(),
        };
        let places = (0..2000).map(|k| {
            let (angle, away) = (0.01 * f64::from(k), 0.002 + 0.01 * f64::from(k % 37) / 37.0);
            [0.41 + away * libm::cos(angle), 0.57 + away * libm::sin(angle)]
        });
        let off = |place: &PlanePoint| SIDES(*place).iter().all(|side| side.abs() > 1e-6);
        assert_eq!(wrong(&plane, places.filter(off)), Vec::<PlanePoint>::new());
    }

    #[test]
    fn sides_with_lands_of_their_own_have_no_area() {
        let plane = Lands {
            land: |[x, y]| match (x == 0.0, y == 0.0) {
                (true, true) => 3,
                (true, false) => 2,
                (false, true) => 1,
                (false, false) => 0,
            },
            zeros: |[x, y]| vec![x, y],
        };
        let places = (0..400).map(|k| [1e-4 + 1e-3 * f64::from(k % 20), 1e-4 + 1e-3 * f64::from(k / 20)]);
        assert_eq!(wrong(&plane, places), Vec::<PlanePoint>::new());
    }

    #[test]
    fn a_corner_on_a_node_is_sharp() {
        // The lines x = 3/4 and y = 3/4 belong to what is beyond.
        let plane = Lands { land: |[x, y]| u8::from(x >= 0.75 || y >= 0.75), zeros: |[x, y]| vec![x - 0.75, y - 0.75] };
        let places = (0..400).map(|k| [0.75 - 1e-3 * f64::from(k % 20) - 5e-4, 0.75 - 1e-3 * f64::from(k / 20) - 5e-4]);
        // Within a tenth of a cell of the finest lattice, 1/64.
        let found = wrong(&plane, places);
        assert!(found.iter().all(|[x, y]| 1.5 - x - y < 0.004), "{found:?}");
    }
}
