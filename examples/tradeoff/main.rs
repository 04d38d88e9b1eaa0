//! What accuracy costs: `tradeoff classify`, `atlas`, `polylines` and `extremes` write the tables of `data/tradeoff/` as
//! CSV to stdout. (`orbit_accuracy tradeoff` writes that of orbits.)
//!
//! ```text
//! cargo run --release --example tradeoff -- classify > data/tradeoff/classify.csv
//! ```
//! `classify`: every point of `data/tradeoff/points.jsonl`, whose truth comes from certified root isolation
//! (`data/oracles/tradeoff_points.py`) and the proved latitude sweep, answered by each level and by what one would do
//! otherwise. `atlas`: whole bodies, against the proved atlas. `polylines`: chord tolerance against size and time.
//! `extremes`: families that run into an extreme, and what fast and exact answer on the way.
//! A second argument n takes every nth point only (`classify`). Times are CPU times of the thread in microseconds, the least of three where a call is short.

#[path = "../../tests/extremes/families.rs"]
mod families;

mod atlas;
mod classify;
mod clock;
mod companion;
mod extremes;
mod points;
mod polylines;

type Failure = Box<dyn std::error::Error>;

fn main() -> Result<(), Failure> {
    let points = points::read(std::env::args().nth(2).map_or(Ok(1), |text| text.parse())?)?;
    match std::env::args().nth(1).as_deref() {
        Some("classify") => classify::run(&points),
        Some("atlas") => atlas::run(&points),
        Some("polylines") => polylines::run(&points),
        Some("extremes") => extremes::run(),
        _ => return Err("tradeoff classify, tradeoff atlas, tradeoff polylines or tradeoff extremes".into()),
    }
    Ok(())
}
