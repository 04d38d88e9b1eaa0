//! What an atlas, a further point and a cold answer cost, on one core: CPU time of the thread (wall time where there is
//! no Unix clock).
//!
//! `cargo bench`; `benches/criterion_table.py` then collects the estimates. A benchmark over several bodies takes them
//! in turn, so that its time is that of one body on average.

use std::hint::black_box;
use std::time::Duration;

use bifdiag_body::{Body, Number};
use bifdiag_diagram::atlas::Atlas;
use bifdiag_diagram::fast::{classify, classify_in};
use bifdiag_diagram::topology::latitude;
use bifdiag_documents::DocumentOptions;
use bifdiag_equilibria::critical::critical;
use bifdiag_equilibria::curves::CriticalSet;
use criterion::{Criterion, criterion_group, criterion_main};

#[cfg(unix)]
#[path = "workload/cpu_time.rs"]
mod cpu_time;
mod workload;

use workload::Case;

#[cfg(unix)]
use cpu_time::CpuTime as Clock;
#[cfg(not(unix))]
use criterion::measurement::WallTime as Clock;

/// Measures a job on the items in turn.
fn in_turn<T, R>(criterion: &mut Criterion<Clock>, name: &str, items: &[T], mut job: impl FnMut(&T) -> R) {
    let mut items = items.iter().cycle();
    criterion.bench_function(name, |bencher| {
        bencher.iter(|| {
            let item = items.next().expect("a workload is not empty");
            black_box(job(black_box(item)))
        });
    });
}

fn bodies(criterion: &mut Criterion<Clock>) {
    let texts: Vec<([String; 3], [String; 3])> = workload::generic()
        .iter()
        .map(|case| {
            (case.body.moments().clone().map(|x| x.to_string()), case.body.center().clone().map(|x| x.to_string()))
        })
        .collect();
    in_turn(criterion, "body/parse", &texts, |(moments, center)| Body::parse(moments, center));
    in_turn(criterion, "body/frame", &workload::generic(), |case| case.body.frame());
}

fn atlases(criterion: &mut Criterion<Clock>) {
    let sets = [
        ("generic", workload::generic()),
        ("paper", workload::preset("paper")),
        ("kovalevskaya", workload::preset("kovalevskaya")),
        ("plane", workload::plane()),
        ("near_axis", workload::near_axis()),
        ("rods", workload::rods()),
    ];
    for (name, cases) in &sets {
        in_turn(criterion, &format!("atlas/{name}"), cases, |case| bifdiag_diagram::fast::atlas(&case.body));
    }
    let curves = |case: &Case| CriticalSet::new(case.body.frame());
    in_turn(criterion, "curves/generic", &sets[0].1, curves);
    for (name, cases) in &sets[..3] {
        let atlases = prepared(cases);
        in_turn(criterion, &format!("polylines/{name}"), &atlases, |atlas| {
            bifdiag_documents::atlas::document(atlas, &DocumentOptions::default())
        });
        let bare = DocumentOptions { drawing: bifdiag_documents::Drawn::Nothing, ..DocumentOptions::default() };
        in_turn(criterion, &format!("document/{name}"), &atlases, |atlas| {
            bifdiag_documents::atlas::document(atlas, &bare)
        });
    }
}

fn prepared(cases: &[Case]) -> Vec<Atlas> {
    cases.iter().map(|case| bifdiag_diagram::fast::atlas(&case.body).expect("an atlas of the workload")).collect()
}

fn points(criterion: &mut Criterion<Clock>) {
    let cases = workload::generic();
    let exact: Vec<(&Body, Number, Number)> = cases
        .iter()
        .map(|case| {
            let (h, l) = case.exact();
            (&case.body, h, l)
        })
        .collect();
    in_turn(criterion, "classify/cold", &exact, |(body, h, l)| classify(body, h, l));
    in_turn(criterion, "critical/cold", &exact, |(body, _, l)| critical(body, l));

    let atlases = prepared(&cases);
    let further: Vec<(usize, f64, f64, Number, Number)> = (0..16)
        .flat_map(|k| {
            cases.iter().enumerate().map(move |(number, case)| {
                let (h, l) = workload::points(&case.body, 16)[k];
                let (exact_h, exact_l) = Case { body: case.body.clone(), h, l }.exact();
                (number, h, l, exact_h, exact_l)
            })
        })
        .collect();
    in_turn(criterion, "prepared/locate", &further, |&(number, h, l, ..)| atlases[number].locate(h, l));
    in_turn(criterion, "prepared/classify", &further, |(number, _, _, h, l)| classify_in(&atlases[*number], h, l));
    // One body, many points: what a scan of one diagram costs.
    let one = &atlases[0];
    let own = workload::points(&cases[0].body, 1024);
    in_turn(criterion, "prepared/locate_one_body", &own, |&(h, l)| one.locate(h, l));
}

fn second_method(criterion: &mut Criterion<Clock>) {
    let frames: Vec<_> = workload::generic().iter().map(|case| (case.body.frame(), case.h, case.l)).collect();
    in_turn(criterion, "latitude_sweep/generic", &frames, |(frame, h, l)| {
        latitude::components(frame, h / frame.energy_unit, l / frame.momentum_unit)
    });
}

criterion_group! {
    name = benches;
    config = Criterion::default().with_measurement(Clock).warm_up_time(Duration::from_secs(1)).measurement_time(Duration::from_secs(3));
    targets = bodies, atlases, points, second_method
}
criterion_main!(benches);
