//! Sections from the question to the answer: whether there is one, where the orbits start, and in which component.

use bifdiag_body::{Body, Number, Preset};
use bifdiag_diagram::topology::signature;
use bifdiag_dynamics::poincare::{PoincareError, SectionSetting};
use bifdiag_dynamics::section::{Monitor, OrbitSection, SweepOptions};

fn number(x: f64) -> Number {
    Number::from_f64(x).unwrap()
}

fn setting(body: &Body, h: f64, l: f64) -> Result<SectionSetting, PoincareError> {
    SectionSetting::new(body, &number(h), &number(l))
}

/// Without the start itself, which has index 0.
fn crossings(orbit: &OrbitSection) -> usize {
    orbit.points.iter().filter(|point| point.index > 0).count()
}

fn preset(name: &str) -> Body {
    Preset::find(name).unwrap().body()
}

#[test]
fn orbits_stay_in_their_component_and_return_to_it() {
    // h = 3.8, 4.45 and (14, 7.2) have two components; every crossing must lie in that of its start.
    for (h, l) in [(3.8, 3.25), (4.45, 3.25), (14.0, 7.2)] {
        let setting = setting(&preset("paper"), h, l).unwrap();
        let starts = setting.spread(10, 3).unwrap();
        let options = SweepOptions { crossings: 60, ..SweepOptions::default() };
        let section = setting.run(&starts, Some(3), &options, &Monitor::default()).unwrap();
        for orbit in &section.orbits {
            let start = section.component_of_start[orbit.orbit as usize];
            let points: Vec<[f64; 3]> = orbit.points.iter().map(|point| point.gamma).collect();
            let found = setting.components_at(&points);
            assert!(found.iter().all(|part| *part == start && part.is_some()), "{h}: {:?}", orbit.report);
        }
        let first: Vec<_> =
            section.orbits.iter().map(|orbit| section.component_of_start[orbit.orbit as usize]).collect();
        assert_eq!(first[..4], [Some(0), Some(1), Some(0), Some(1)]);
    }
}

#[test]
fn components_too_small_for_a_spread_are_filled_from_their_minimum() {
    // Just above the second minimum 3.484722441 of l = 3.25, its disc has a radius of about 1e-4, …
    for above in [1e-8, 1e-11] {
        let setting = setting(&preset("paper"), 3.484_722_441 + above, 3.25).unwrap();
        let starts = setting.spread(6, 0).unwrap();
        let gammas: Vec<[f64; 3]> = starts.iter().map(|p| setting.torus().gamma(p.theta, p.psi)).collect();
        let parts = setting.components_at(&gammas);
        assert_eq!(parts, [0, 1, 0, 1, 0, 1].map(Some), "{above:e}");
        assert_eq!(starts.iter().filter(|p| p.sheet > 0).count(), 4, "each part begins on T⁺");
        let options = SweepOptions { crossings: 20, ..SweepOptions::default() };
        let section = setting.run(&starts, Some(0), &options, &Monitor::default()).unwrap();
        assert_eq!(signature(&section.components).as_deref(), Some("S2+T2"));
        assert!(section.orbits.iter().all(|orbit| crossings(orbit) == 20), "{:?}", section.orbits);
    }
}

#[test]
fn every_region_of_every_named_body_has_starts() {
    let mut regions = 0;
    for preset in Preset::all() {
        let body = preset.body();
        if body.flags().euler {
            continue;
        }
        let atlas = bifdiag_diagram::fast::atlas(&body).unwrap();
        for region in atlas.regions().ids() {
            let components = atlas.components(region).unwrap().len();
            let sample = atlas.sample(region);
            let setting = match setting(&body, sample.h, sample.l) {
                Err(PoincareError::Undecided { .. }) => continue,
                setting => setting.unwrap(),
            };
            let starts = setting.spread(2 * components + 1, 1).unwrap();
            let gammas: Vec<[f64; 3]> = starts.iter().map(|p| setting.torus().gamma(p.theta, p.psi)).collect();
            let parts = setting.components_at(&gammas);
            for part in 0..components {
                let count = parts.iter().filter(|found| **found == Some(part)).count();
                assert!(count >= 2, "{} {region}: {parts:?}", preset.name());
            }
            regions += 1;
        }
    }
    assert!(regions > 60, "{regions}");
}

#[test]
fn there_is_no_section_where_there_is_none() {
    let paper = preset("paper");
    let Err(PoincareError::Forbidden { lowest, branch, .. }) = setting(&paper, 1.6, 3.25) else { panic!("h = 1.6") };
    assert!((lowest - 1.639_699_408).abs() < 1e-9 && branch == "G2.1");
    let top = preset("kovalevskaya");
    let on_curve = setting(&top, 2.0, 2.0);
    assert!(matches!(on_curve, Err(PoincareError::OnCurve { .. })), "{on_curve:?}");
    assert_eq!(setting(&preset("euler"), 2.0, 1.0).unwrap_err(), PoincareError::WeightlessBody);
}

#[test]
fn a_stopped_run_is_not_complete() {
    let setting = setting(&preset("paper"), 4.45, 3.25).unwrap();
    let starts = setting.spread(4, 0).unwrap();
    let monitor = Monitor::default();
    monitor.stop.store(true, std::sync::atomic::Ordering::Relaxed);
    let section = setting.run(&starts, Some(0), &SweepOptions::default(), &monitor).unwrap();
    assert!(!section.complete() && section.orbits.is_empty());
}
