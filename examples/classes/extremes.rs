//! The most of everything that the witnesses of classes show.

use bifdiag_body::Body;
use bifdiag_diagram::atlas::Atlas;
use bifdiag_equilibria::curves::Orbit;
use bifdiag_exact::Accuracy;
use bifdiag_schema::ClassesDocument;

use crate::Failure;

/// Relative equilibria at one l: all, minima, saddles, maxima.
fn counts(atlas: &Atlas) -> impl Iterator<Item = [usize; 4]> + '_ {
    let arrangement = atlas.arrangement();
    arrangement.slabs.iter().map(|slab| {
        let mut found = [0; 4];
        for &curve in &slab.order {
            let curve = &arrangement.set.curves[curve];
            let many = match curve.orbit {
                Orbit::Pole(_) => 0,
                Orbit::Pair(_) => 2,
                _ => 1,
            };
            found[0] += many;
            if let Some(index) = curve.index {
                found[1 + usize::from(index)] += many;
            }
        }
        found
    })
}

/// Prints each record with the class that holds it, for bodies that exist and for all.
pub fn extremes(classes: &str) -> Result<(), Failure> {
    let document: ClassesDocument = serde_json::from_str(&std::fs::read_to_string(classes)?)?;
    let what = ["relative equilibria", "minima", "saddles", "maxima", "regions", "components", "events", "neighbours"];
    for physical in [true, false] {
        let mut best = vec![(0, 0, String::new()); what.len()];
        for class in document.classes.iter().filter(|class| !physical || class.physical) {
            let body = Body::parse(&class.witness.body.moments, &class.witness.body.center)?;
            let atlas = bifdiag_exact::atlas(&body, Accuracy::Exact)?;
            let mut seen = vec![0; what.len()];
            for at_one_momentum in counts(&atlas) {
                for (most, count) in seen.iter_mut().zip(at_one_momentum) {
                    *most = (*most).max(count);
                }
            }
            let components = atlas.regions().iter().filter_map(|region| region.components.as_ref().ok()).map(Vec::len);
            seen[5] = components.max().unwrap_or(0);
            seen[4] = atlas.regions().len();
            seen[6] = atlas.arrangement().events.len();
            let mut beside: Vec<&str> = class.neighbours.iter().map(|neighbour| neighbour.class.as_str()).collect();
            beside.dedup();
            seen[7] = beside.len();
            for (record, count) in best.iter_mut().zip(seen) {
                match count.cmp(&record.0) {
                    std::cmp::Ordering::Greater => *record = (count, 1, class.name.clone()),
                    std::cmp::Ordering::Equal => record.1 += 1,
                    std::cmp::Ordering::Less => {}
                }
            }
        }
        println!("{}", if physical { "bodies that exist" } else { "all A > 0" });
        for (what, (count, classes, first)) in what.iter().zip(best) {
            println!("  most {what}: {count}, in {classes} classes, such as {first}");
        }
    }
    Ok(())
}
