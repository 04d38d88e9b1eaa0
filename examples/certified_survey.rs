//! Proved atlases against those of f64 of random bodies: agreement, what is not proved, and the time of each.
//!
//! `cargo run --release --example certified_survey [bodies] [stratum]`; prints one line a stratum.

use std::time::Instant;

use bifdiag_body::Body;
use bifdiag_diagram::topology::{Component, signature};
use bifdiag_exact::CertifiedAtlas;

use support::bodies::{STRATA, random_body};
use support::random::SplitMix64;

#[derive(Default)]
struct Tally {
    unproved: usize,
    different: usize,
    regions: usize,
    regions_open: usize,
    /// Atlases that needed more than f64.
    wide: usize,
    /// Milliseconds, each with the body.
    times: Vec<(f64, String)>,
}

fn main() {
    let mut arguments = std::env::args().skip(1);
    let count: usize = arguments.next().and_then(|n| n.parse().ok()).unwrap_or(100);
    let wanted = arguments.next();
    for stratum in STRATA {
        let name = format!("{stratum:?}");
        if wanted.as_ref().is_some_and(|wanted| *wanted != name) {
            continue;
        }
        let mut rng = SplitMix64::new(20_261_121);
        let mut tally = Tally::default();
        for _ in 0..count {
            let body = random_body(&mut rng, stratum);
            let text = format!("{:?} {:?}", body.moments_f64(), body.center_f64());
            if let Err(what) = tally.examine(&body, &text) {
                eprintln!("{name}: {text}: {what}");
            }
        }
        tally.print(&name, count);
    }
}

impl Tally {
    fn examine(&mut self, body: &Body, text: &str) -> Result<(), String> {
        let start = Instant::now();
        let certified = CertifiedAtlas::new(body);
        self.times.push((start.elapsed().as_secs_f64() * 1e3, text.to_owned()));
        let certified = certified.map_err(|error| {
            self.unproved += 1;
            error.to_string()
        })?;
        self.wide += usize::from(certified.bits() > 53);
        let mut proved: Vec<String> =
            certified.region_ids().filter_map(|region| certified.components(region)).map(class).collect();
        let regions = certified.region_count();
        self.regions += regions;
        self.regions_open += regions - proved.len();
        let quick = bifdiag_diagram::fast::atlas(body).ok().filter(|atlas| atlas.arrangement().undecided.is_empty());
        let Some(quick) = quick else { return Ok(()) };
        let mut all: Vec<String> =
            quick.regions().ids().filter_map(|region| quick.components(region).ok()).map(class).collect();
        proved.sort();
        all.sort();
        let whole = proved.len() == regions && all.len() == quick.regions().len();
        if quick.regions().len() != regions || (whole && proved != all) {
            self.different += 1;
            return Err(format!("different: {regions} and {}", quick.regions().len()));
        }
        Ok(())
    }

    fn print(mut self, stratum: &str, bodies: usize) {
        self.times.sort_by(|p, q| p.0.total_cmp(&q.0));
        let Self { unproved, different, regions, regions_open, wide, times } = self;
        let Some((slowest, body)) = times.last() else { return };
        println!(
            "{stratum}: {bodies} bodies, {unproved} not proved, {different} different, {regions_open} of {regions} regions \
             open, {wide} beyond f64, median {:.2} ms, 99 % {:.2} ms, slowest {slowest:.2} ms {body}",
            times[times.len() / 2].0,
            times[times.len() * 99 / 100].0
        );
    }
}

fn class(components: &[Component]) -> String {
    format!("{components:?} {:?}", signature(components))
}
