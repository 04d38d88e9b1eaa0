//! Times single answers in one process, for `benches/peers.py`.
//!
//! Reads JSON Lines `{"A": [..], "r": [..], "h": .., "l": ..}` and writes one line each with the times in
//! microseconds, each the least of several runs: `atlas` (events, regions, topology), `polylines` (the same body's
//! curves, traced), `classify` and `critical` (cold: nothing prepared but the numbers), `locate` (a further point of the
//! prepared body), with the number of `regions` and the `document` of the point.

use std::hint::black_box;
use std::io::{BufRead, Write};
use std::time::Instant;

use bifdiag_body::{Body, Number};
use bifdiag_diagram::fast::classify;
use bifdiag_documents::DocumentOptions;
use bifdiag_equilibria::critical::critical;
use bifdiag_schema::Accuracy;
use serde::Deserialize;

/// Runs of which the fastest counts.
const RUNS: u32 = 7;

#[derive(Deserialize)]
struct Query {
    #[serde(rename = "A")]
    moments: [f64; 3],
    #[serde(rename = "r")]
    center: [f64; 3],
    h: f64,
    l: f64,
}

/// Microseconds of the fastest of several runs of `calls` calls, per call.
fn microseconds<R>(calls: u32, mut job: impl FnMut() -> R) -> f64 {
    let time = |_| {
        let start = Instant::now();
        for _ in 0..calls {
            black_box(job());
        }
        start.elapsed().as_secs_f64() * 1e6 / f64::from(calls)
    };
    (0..RUNS).map(time).fold(f64::INFINITY, f64::min)
}

fn answer(line: &str) -> Result<serde_json::Value, Box<dyn std::error::Error>> {
    let query: Query = serde_json::from_str(line)?;
    let body = Body::from_f64(query.moments, query.center)?;
    let (h, l) = (Number::from_f64(query.h)?, Number::from_f64(query.l)?);
    let atlas = bifdiag_diagram::fast::atlas(&body)?;
    Ok(serde_json::json!({
        "atlas": microseconds(5, || bifdiag_diagram::fast::atlas(&body)),
        "polylines": microseconds(1, || bifdiag_documents::atlas::document(&atlas, &DocumentOptions::default())),
        "classify": microseconds(10, || classify(&body, &h, &l)),
        "critical": microseconds(10, || critical(&body, &l)),
        "locate": microseconds(1000, || atlas.locate(query.h, query.l)),
        "regions": atlas.regions().len(),
        "document": bifdiag_documents::classification(
            &body.clone().into(), &h, &l, &classify(&body, &h, &l)?, Accuracy::Exact, None,
        ),
    }))
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut output = std::io::stdout().lock();
    for line in std::io::stdin().lock().lines() {
        writeln!(output, "{}", answer(&line?)?)?;
    }
    Ok(())
}
