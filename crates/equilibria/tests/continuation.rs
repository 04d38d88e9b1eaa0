//! Newton continuation against the closed form, over all strata.

use std::cell::Cell;

use bifdiag_body::Number;
use bifdiag_equilibria::critical::{CriticalError, Equilibrium, RelativeEquilibria};
use bifdiag_equilibria::curves::{CriticalSet, Curve};
use proptest::prelude::*;
use support::property::holds_for_bodies;
use support::strata::STRATA;

/// Both ways to the relative equilibria, between each two ends of curves, before the first and behind the last.
#[test]
fn continuation_and_closed_form_find_the_same_relative_equilibria() {
    let (followed, lost, largest) = (Cell::new(0), Cell::new(0), Cell::new(0.0_f64));
    for stratum in STRATA {
        holds_for_bodies(stratum, 40, |body| {
            let Ok(equilibria) = RelativeEquilibria::new(body) else { return Ok(()) };
            let Ok(set) = CriticalSet::new(body.frame()) else { return Ok(()) };
            let unit = set.frame.momentum_unit;
            let mut ends: Vec<f64> = set.curves.iter().flat_map(Curve::x).filter(|x| x.is_finite()).collect();
            ends.sort_by(f64::total_cmp);
            ends.dedup_by(|x, y| (*x - *y).abs() <= 1e-6 * *x);
            let last = ends[ends.len() - 1];
            ends.push(if last > 0.0 { 9.0 * last } else { set.frame.r_norm.max(1.0) * set.frame.a[2] });
            for pair in ends.windows(2) {
                let l = Number::from_f64((pair[0] + pair[1]).sqrt() * unit).unwrap();
                let Ok(closed) = equilibria.at(&l) else { continue };
                followed.set(followed.get() + closed.list.len());
                match equilibria.continued(&l) {
                    Ok(found) => {
                        prop_assert!(found.by_continuation && found.list.len() == closed.list.len());
                        // Ties in h may stand in another order.
                        let places = |list: &[Equilibrium]| {
                            let mut places: Vec<_> =
                                list.iter().map(|one| (one.curve.unwrap().to_string(), one.index)).collect();
                            places.sort();
                            places
                        };
                        prop_assert_eq!(places(&found.list), places(&closed.list));
                        let scale = closed
                            .list
                            .iter()
                            .map(|one| one.h.abs() + one.omega.abs() * l.to_f64())
                            .fold(0.0, f64::max);
                        let off = (found.error_bound - closed.error_bound) / scale;
                        largest.set(off.max(largest.get()));
                        prop_assert!(off <= 1e-11, "{off} at {l}");
                    }
                    Err(CriticalError::Lost { curve }) => {
                        println!(
                            "{stratum:?} lost {curve:?} at {l} of {ends:?}: {}",
                            support::property::body_text(body)
                        );
                        lost.set(lost.get() + 1);
                    }
                    Err(error) => prop_assert!(false, "{error}"),
                }
            }
            Ok(())
        });
    }
    println!(
        "{} relative equilibria, {} momenta not reached, h off by {:e}",
        followed.get(),
        lost.get(),
        largest.get()
    );
    assert_eq!(lost.get(), 0);
}
