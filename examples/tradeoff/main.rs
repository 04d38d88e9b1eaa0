//! What accuracy costs: `tradeoff classify FILE`, `curves FILE`, `atlas`, `polylines` and `extremes` write the tables of
//! `data/tradeoff/` as CSV to stdout. (`orbit_accuracy tradeoff` writes that of orbits.)
//!
//! ```text
//! cargo run --release --example tradeoff -- classify points.jsonl > data/tradeoff/classify.csv
//! ```
//! `classify`: every point of a file of `data/oracles/campaign_points.py`, whose truth comes from certified root isolation
//! and the proved latitude sweep, answered by each level and by what one would do otherwise; a stratum after the file takes
//! that one alone, so that a run that broke off can go on. `curves`: points exactly on curves, from
//! `data/oracles/curve_points.py`. `atlas`: whole bodies, against the proved atlas. `polylines`: chord tolerance against size
//! and time. `extremes`: families that run into an extreme, and what fast and exact answer on the way.
//! Times are CPU times of the thread in microseconds, the least of three where a call is short.

#[path = "../../tests/extremes/families.rs"]
mod families;

mod atlas;
mod classify;
mod clock;
mod companion;
mod curves;
mod extremes;
mod points;
mod polylines;
mod verdict;

type Failure = Box<dyn std::error::Error>;

fn main() -> Result<(), Failure> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    match arguments[..] {
        ["classify", file] => classify::run(&points::read(file)?, None)?,
        ["classify", file, stratum] => classify::run(&points::read(file)?, Some(stratum))?,
        ["curves", file] => curves::run(file)?,
        ["atlas"] => atlas::run(&points::read(points::BODIES)?),
        ["polylines"] => polylines::run(&points::read(points::BODIES)?),
        ["extremes"] => extremes::run(),
        _ => return Err("tradeoff classify FILE, curves FILE, atlas, polylines or extremes".into()),
    }
    Ok(())
}
