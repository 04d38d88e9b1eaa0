//! What a section's document says beside its orbits.

use bifdiag_body::Preset;
use bifdiag_documents::{SectionPlace, section};
use bifdiag_dynamics::poincare::SectionSetting;
use bifdiag_dynamics::section::{Monitor, SweepOptions};

#[test]
fn a_stopped_run_says_so() {
    let body = Preset::find("paper").unwrap().body();
    let setting = SectionSetting::new(&body, &"4.45".parse().unwrap(), &"3.25".parse().unwrap()).unwrap();
    let starts = setting.spread(4, 0).unwrap();
    let monitor = Monitor::default();
    monitor.stop.store(true, std::sync::atomic::Ordering::Relaxed);
    let document = section(
        &body.clone().into(),
        &setting.run(&starts, Some(0), &SweepOptions::default(), &monitor).unwrap(),
        SectionPlace::Point,
    );
    assert!(!document.complete && document.orbits.is_empty());
    assert!(document.notes[0].contains("interrupted"));
}
