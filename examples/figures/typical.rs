//! Orbits that show a section: each begins where none has been yet.

use std::collections::HashSet;
use std::f64::consts::{PI, TAU};

use bifdiag_dynamics::field::State;
use bifdiag_dynamics::section::{Monitor, OrbitSection, Portrait, SectionChart, SectionError, SweepOptions, sweep};

/// Crossings of each orbit.
const CROSSINGS: usize = 1600;
/// Cells of the accessible area of one sheet on one side of γ₁ = 0. A start in a cell that an orbit has visited is
/// passed over: so curves keep apart, and a chaotic region is left to one orbit or two.
const CELLS: f64 = 110.0;
/// The most orbits on one side.
const MOST: usize = 24;
/// Starts that are tried for each cell.
const TRIES: f64 = 8.0;
/// Rows of the grid by which areas are measured.
const ROWS: u32 = 120;

/// A start, its place in the torus's chart, and its sheet (0 or 1).
type Start = ([f64; 2], usize, State);

/// Typical orbits on either side of γ₁ = 0, which for the paper's body parts the components of the section that are
/// apart.
pub fn typical_orbits(portrait: &Portrait) -> Result<Vec<OrbitSection>, SectionError> {
    let mut orbits: Vec<OrbitSection> = Vec::new();
    for side in [true, false] {
        let on_side = |place: [f64; 2]| {
            portrait.states(SectionChart::Torus, place).filter(|states| (states[0].gamma[0] > 0.0) == side)
        };
        let total = 2 * ROWS * ROWS;
        let found = (0..total).filter(|k| {
            let (row, column) = (k / (2 * ROWS), k % (2 * ROWS));
            let angle = |k: u32| (f64::from(k) + 0.5) * PI / f64::from(ROWS);
            on_side([angle(column), angle(row)]).is_some()
        });
        let share = found.count() as f64 / f64::from(total);
        if share == 0.0 {
            continue;
        }
        let cell = (share * TAU * PI / CELLS).sqrt();
        let mut visited: HashSet<(usize, [i64; 2])> =
            orbits.iter().flat_map(|orbit| cells(portrait, orbit, cell)).collect();
        let first = orbits.len();
        for (place, sheet, state) in starts(on_side, TRIES * CELLS / share) {
            if orbits.len() - first == MOST {
                break;
            }
            if visited.contains(&(sheet, cell_of(place, cell))) {
                continue;
            }
            let orbit = orbit(portrait, state, orbits.len())?;
            visited.extend(cells(portrait, &orbit, cell));
            orbits.push(orbit);
        }
    }
    Ok(orbits)
}

/// Accessible places of a Kronecker sequence in (ψ', ϑ'), the sheets in turn.
fn starts(states: impl Fn([f64; 2]) -> Option<[State; 2]>, tries: f64) -> impl Iterator<Item = Start> {
    // 1/p and 1/p² with p³ = p + 1.
    const STEP: [f64; 2] = [0.754_877_666_246_692_8, 0.569_840_290_998_053_3];
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "some thousands")]
    let tries = tries as u32;
    (1..=tries).filter_map(move |k| {
        let [x, y] = STEP.map(|step| f64::from(k) * step);
        let place = [(x - x.floor()) * TAU, (y - y.floor()) * PI];
        let sheet = (k % 2) as usize;
        states(place).map(|states| (place, sheet, states[sheet]))
    })
}

/// One orbit with its crossings.
pub fn orbit(portrait: &Portrait, state: State, number: usize) -> Result<OrbitSection, SectionError> {
    let options = SweepOptions { crossings: CROSSINGS, condition: portrait.condition(), ..SweepOptions::default() };
    let mut orbits = sweep(portrait.torus(), &[state], &options, &Monitor::default())?;
    let mut orbit = orbits.remove(0);
    orbit.orbit = u32::try_from(number).unwrap_or(u32::MAX);
    Ok(orbit)
}

fn cell_of([x, y]: [f64; 2], cell: f64) -> [i64; 2] {
    #[expect(clippy::cast_possible_truncation, reason = "some hundreds at most")]
    [x, y].map(|angle| (angle / cell).floor() as i64)
}

/// The cells that an orbit has visited.
fn cells(portrait: &Portrait, orbit: &OrbitSection, cell: f64) -> impl Iterator<Item = (usize, [i64; 2])> {
    orbit.points.iter().map(move |point| {
        let (place, sheet) = portrait.crossing(SectionChart::Torus, point);
        (usize::from(sheet > 0), cell_of(place, cell))
    })
}
