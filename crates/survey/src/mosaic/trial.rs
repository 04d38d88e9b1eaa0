//! Whether the parts of cells show what the plane shows there.

use std::collections::BTreeSet;

use super::chords::{Bend, joinings};
use super::division::{Division, Plane};
use super::lattice::{Cell, Node, Place, distance, mean};
use super::pieces::{changes_of, parts};

/// Where on a chord the way to its bend begins: not in the middle, where special points lie.
const ALONG: f64 = 0.45;
/// Parts of less than this share of a cell show nothing.
const SEEN: f64 = 1e-6;

/// What a part of a cell shows, and its corners.
type Part<L> = (Option<L>, Vec<Place>);

/// A chord that does not bound what lies beyond it, and the way on which that ends.
struct Turn<L> {
    cell: Cell,
    ends: [Place; 2],
    way: [Place; 2],
    beyond: L,
}

/// Parts of a cell that were tried.
struct Trial<L> {
    /// How its changes are joined.
    partners: Vec<usize>,
    /// Its parts.
    parts: Vec<Part<L>>,
    /// Which of them show something else than the plane does amid their corners.
    wrong: Vec<usize>,
}

impl<P: Plane> Division<'_, P> {
    /// Looks at the parts of cells. Where changes can be joined in several ways, that which shows fewest wrong parts is kept;
    /// a cell with a wrong part is quartered (these are told), and in one of the finest lattice the border of that is bent.
    pub(super) fn try_parts(&mut self, cells: &[Cell], tried: &mut BTreeSet<(Node, u32, usize)>) -> Vec<Cell> {
        let count = |cell: &Cell| cell.sides().iter().map(|side| self.changes(*side).len()).sum::<usize>();
        let is_new = |cell: &Cell| tried.insert((cell.from, cell.size, count(cell)));
        let new: Vec<Cell> = cells.iter().copied().filter(is_new).collect();
        let mut open = Vec::new();
        let mut bent = Vec::new();
        for (cell, mut trials) in self.trials(&new) {
            let Some(best) = (0..trials.len()).min_by_key(|&k| trials[k].wrong.len()) else { continue };
            let Trial { partners, parts, wrong } = trials.swap_remove(best);
            if cell.size > 1 {
                open.extend((!wrong.is_empty()).then_some(cell));
                continue;
            }
            bent.extend(wrong.first().and_then(|&part| self.turn(cell, &partners, &parts[part])));
            if partners.len() > 2 {
                self.joined.insert(cell.from, partners);
            }
        }
        self.bend(bent);
        open
    }

    /// The parts of cells for each way to join their changes.
    fn trials(&self, cells: &[Cell]) -> Vec<(Cell, Vec<Trial<P::Label>>)> {
        let mut places = Vec::new();
        let mut all = Vec::new();
        for &cell in cells {
            let round = self.round(cell);
            let changes = changes_of(&round);
            if changes.is_empty() {
                continue;
            }
            let ways = joinings(&round, &changes);
            // The tip of a strip needs no look.
            if ways.is_empty() || changes.len() == 2 && round[changes[0]].side == round[changes[1]].side {
                continue;
            }
            let trial = |partners: Vec<usize>| {
                let parts = parts(&round, &changes, &partners, None);
                Trial { partners, parts, wrong: Vec::new() }
            };
            let trials: Vec<Trial<P::Label>> = ways.into_iter().map(trial).collect();
            places.extend(
                trials
                    .iter()
                    .flat_map(|trial| &trial.parts)
                    .map(|(_, corners)| self.place(mean(corners.iter().copied()))),
            );
            all.push((cell, trials));
        }
        let mut shown = self.plane.labels(&places).into_iter();
        for (cell, trials) in &mut all {
            let least = SEEN * f64::from(cell.size * cell.size);
            for trial in trials {
                let is_wrong = |(label, corners): &Part<P::Label>| shown.next() != *label && area(corners) > least;
                let is_wrong: Vec<bool> = trial.parts.iter().map(is_wrong).collect();
                trial.wrong = (0..is_wrong.len()).filter(|&part| is_wrong[part]).collect();
            }
        }
        all
    }

    /// The way on which the longest chord of a part that shows something else may have its bend: towards the corners of the
    /// part.
    fn turn(&self, cell: Cell, partners: &[usize], (shown, part): &Part<P::Label>) -> Option<Turn<P::Label>> {
        let round = self.round(cell);
        let changes = changes_of(&round);
        let length = |[from, to]: [usize; 2]| distance(round[changes[from]].at, round[changes[to]].at);
        let chords = partners.iter().enumerate().map(|(from, to)| [from, *to]);
        let own = chords.filter(|ends| ends.iter().all(|end| part.contains(&round[changes[*end]].at)));
        let [from, to] = own.max_by(|a, b| length(*a).total_cmp(&length(*b)))?;
        let ends = [from, to].map(|end| round[changes[end]].at);
        let around = [from, (from + changes.len() - 1) % changes.len()].map(|change| &round[changes[change]].after);
        let beyond = around.into_iter().find(|label| *label != shown)?.clone()?;
        let is_corner = |at: &Place| round.iter().any(|stop| stop.after.is_none() && stop.at == *at);
        let corners = || part.iter().copied().filter(|at| is_corner(at) && !ends.contains(at));
        corners().next()?;
        let start = [0, 1].map(|axis| ends[0][axis] + ALONG * (ends[1][axis] - ends[0][axis]));
        Some(Turn { cell, ends, way: [start, mean(corners())], beyond })
    }

    /// Bends chords to where on these ways ends what lies beyond them.
    fn bend(&mut self, turns: Vec<Turn<P::Label>>) {
        let drawn: Vec<[Place; 2]> = turns.iter().map(|turn| turn.way.map(|at| self.place(at))).collect();
        for (turn, found) in turns.into_iter().zip(self.plane.changes(&drawn)) {
            let Turn { cell, ends, way: [from, to], beyond } = turn;
            if let Some((share, _)) = found.first().filter(|(_, labels)| labels[0] == beyond) {
                let at = [0, 1].map(|axis| from[axis] + share * (to[axis] - from[axis]));
                self.bends.insert(cell.from, Bend { ends, at });
            }
        }
    }
}

fn area(corners: &[Place]) -> f64 {
    let next = corners.iter().cycle().skip(1);
    0.5 * corners.iter().zip(next).map(|(p, q)| p[0] * q[1] - p[1] * q[0]).sum::<f64>().abs()
}

#[cfg(test)]
mod tests {
    use super::super::{Changes, Plane, divide};
    use super::*;

    /// Lands whose borders cross a way where some functions vanish.
    struct Lands {
        land: fn(Place) -> u8,
        /// Each is linear on a way along an axis.
        zeros: fn(Place) -> Vec<f64>,
    }

    impl Plane for Lands {
        type Label = u8;

        fn labels(&self, places: &[Place]) -> Vec<u8> {
            places.iter().map(|place| (self.land)(*place)).collect()
        }

        fn changes(&self, ways: &[[Place; 2]]) -> Vec<Changes<u8>> {
            let of = |[p, q]: &[Place; 2]| {
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

    fn holds(corners: &[Place], [x, y]: Place) -> bool {
        let next = corners.iter().cycle().skip(1);
        let crossed = |(p, q): &(&Place, &Place)| {
            (p[1] > y) != (q[1] > y) && x < p[0] + (y - p[1]) / (q[1] - p[1]) * (q[0] - p[0])
        };
        corners.iter().zip(next).filter(crossed).count() % 2 == 1
    }

    /// Which places the mosaic of a grid of 8 × 8 cells shows otherwise than the plane.
    fn wrong(plane: &Lands, places: impl Iterator<Item = Place>) -> Vec<Place> {
        let axis: Vec<f64> = (0..=8).map(|k| f64::from(k) / 8.0).collect();
        let shown: Vec<u8> = axis.iter().flat_map(|&y| axis.iter().map(move |&x| (plane.land)([x, y]))).collect();
        let mosaic = divide(plane, [&axis, &axis], &shown);
        let total: f64 = mosaic.pieces.iter().map(|(_, corners)| area(corners)).sum();
        assert!((total - 1.0).abs() < 1e-9, "{total}");
        let at = |place: Place| mosaic.pieces.iter().find(|(_, piece)| holds(piece, place)).map(|(land, _)| *land);
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
        assert_eq!(wrong(&WEDGE, inside), Vec::<Place>::new());
    }

    #[test]
    fn four_lands_meet_in_a_point() {
        // Straight borders through a point of no lattice.
        const SIDES: fn(Place) -> [f64; 2] = |[x, y]| [x - 0.41 - 0.2 * (y - 0.57), y - 0.57 + 0.3 * (x - 0.41)];
        let plane = Lands {
            land: |place| SIDES(place).into_iter().enumerate().map(|(k, side)| u8::from(side > 0.0) << k).sum(),
            zeros: |place| SIDES(place).to_vec(),
        };
        let places = (0..2000).map(|k| {
            let (angle, away) = (0.01 * f64::from(k), 0.002 + 0.01 * f64::from(k % 37) / 37.0);
            [0.41 + away * libm::cos(angle), 0.57 + away * libm::sin(angle)]
        });
        let off = |place: &Place| SIDES(*place).iter().all(|side| side.abs() > 1e-6);
        assert_eq!(wrong(&plane, places.filter(off)), Vec::<Place>::new());
    }

    #[test]
    fn a_corner_on_a_node_is_sharp() {
        // The lines x = 3/4 and y = 3/4 belong to what is beyond; the diagonal shows something of its own, or not.
        const LANDS: [fn(Place) -> u8; 2] = [
            |[x, y]| u8::from(x >= 0.75 || y >= 0.75),
            |[x, y]| if x >= 0.75 || y >= 0.75 { 1 } else { 2 * u8::from(x == y) },
        ];
        for land in LANDS {
            let plane = Lands { land, zeros: |[x, y]| vec![x - 0.75, y - 0.75] };
            let below = |k: u32| 0.75 - 1e-3 * f64::from(k) - 5e-4;
            let places = (0..400).map(|k| [below(k % 20) + 1e-5, below(k / 20)]);
            // Within a tenth of a cell of the finest lattice, 1/64.
            let found = wrong(&plane, places);
            assert!(found.iter().all(|[x, y]| 1.5 - x - y < 0.004), "{found:?}");
        }
    }
}
