//! Proved atlases against those of f64 of random bodies: agreement, what is not proved, and the time of each.
//!
//! `cargo run --release --example certified_survey [bodies] [stratum]`; prints one line a stratum.

use std::time::Instant;

use proof::CertifiedAtlas;
use top::atlas::Atlas;
use top::topology::signature;

use support::bodies::{STRATA, random_body};
use support::random::SplitMix64;

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
        let (mut unproved, mut regions_open, mut different, mut regions, mut wide) = (0, 0, 0, 0, 0);
        let mut times = Vec::with_capacity(count);
        let mut slowest = (0.0, String::new());
        for _ in 0..count {
            let body = random_body(&mut rng, stratum);
            let text = format!("{:?} {:?}", body.moments_f64(), body.center_f64());
            let start = Instant::now();
            let certified = CertifiedAtlas::new(&body);
            let time = start.elapsed().as_secs_f64() * 1e3;
            if time > slowest.0 {
                slowest = (time, text.clone());
            }
            times.push(time);
            let quick = Atlas::new(&body).ok().filter(|atlas| atlas.arrangement().undecided.is_empty());
            let certified = match certified {
                Ok(certified) => certified,
                Err(error) => {
                    unproved += 1;
                    eprintln!("{name}: {text}: {error}");
                    continue;
                }
            };
            wide += usize::from(certified.bits() > 53);
            let class = |c: &[top::topology::Component]| format!("{c:?} {:?}", signature(c));
            let mut proved: Vec<String> = Vec::new();
            for region in certified.region_ids() {
                regions += 1;
                match certified.components(region) {
                    Some(components) => proved.push(class(components)),
                    None => regions_open += 1,
                }
            }
            if let Some(quick) = quick {
                let mut all: Vec<String> = Vec::new();
                for region in quick.regions().ids() {
                    if let Ok(components) = quick.components(region) {
                        all.push(class(components));
                    }
                }
                let same_count = quick.regions().len() == certified.region_count();
                proved.sort();
                all.sort();
                let whole = proved.len() == certified.region_count() && all.len() == quick.regions().len();
                if !same_count || (whole && proved != all) {
                    different += 1;
                    eprintln!("{name}: {text}: different: {} and {}", certified.region_count(), quick.regions().len());
                }
            }
        }
        times.sort_by(f64::total_cmp);
        println!(
            "{name}: {count} bodies, {unproved} not proved, {different} different, {regions_open} of {regions} regions open, \
             {wide} beyond f64, median {:.2} ms, 99 % {:.2} ms, slowest {:.2} ms {}",
            times[times.len() / 2],
            times[times.len() * 99 / 100],
            slowest.0,
            slowest.1
        );
    }
}
