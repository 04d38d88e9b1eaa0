//! Runs one hot path a number of times: `hot_paths NAME COUNT`, for profilers and for counting instructions
//! (`benches/instructions.sh`). `hot_paths list` names the paths. A count of 0 prepares the work and does none of it.

use std::hint::black_box;
use std::process::ExitCode;

use bifdiag_body::{Body, Number};
use bifdiag_diagram::atlas::Atlas;
use bifdiag_diagram::fast::classify;
use bifdiag_diagram::topology::latitude;
use bifdiag_documents::DocumentOptions;
use bifdiag_equilibria::critical::critical;
use bifdiag_equilibria::curves::CriticalSet;
use bifdiag_exact::CertifiedAtlas;

#[path = "../benches/workload/mod.rs"]
mod workload;

use workload::Case;

type Job = Box<dyn FnMut(usize)>;

fn in_turn<T: 'static, R>(items: Vec<T>, mut job: impl FnMut(&T) -> R + 'static) -> Job {
    Box::new(move |call| drop(black_box(job(black_box(&items[call % items.len()])))))
}

fn atlas(cases: Vec<Case>) -> Job {
    in_turn(cases, |case| bifdiag_diagram::fast::atlas(&case.body))
}

fn prepared(cases: &[Case]) -> Vec<Atlas> {
    cases.iter().map(|case| bifdiag_diagram::fast::atlas(&case.body).expect("an atlas of the workload")).collect()
}

fn exact() -> Vec<(Body, Number, Number)> {
    let exact = |case: &Case| {
        let (h, l) = case.exact();
        (case.body.clone(), h, l)
    };
    workload::generic().iter().map(exact).collect()
}

/// Prepares the work of a path.
type Prepare = fn() -> Job;

const PATHS: [(&str, Prepare); 15] = [
    ("parse", || {
        let text = |x: &Number| x.text().to_owned();
        let texts = workload::generic()
            .iter()
            .map(|case| (case.body.moments().each_ref().map(text), case.body.center().each_ref().map(text)))
            .collect();
        in_turn(texts, |(a, r): &([String; 3], [String; 3])| Body::parse(a, r))
    }),
    ("frame", || in_turn(workload::generic(), |case| case.body.frame())),
    ("curves", || in_turn(workload::generic(), |case| CriticalSet::new(case.body.frame()))),
    ("atlas", || atlas(workload::generic())),
    ("atlas-paper", || atlas(workload::preset("paper"))),
    ("atlas-kovalevskaya", || atlas(workload::preset("kovalevskaya"))),
    ("atlas-plane", || atlas(workload::plane())),
    ("atlas-near-axis", || atlas(workload::near_axis())),
    ("atlas-rods", || atlas(workload::rods())),
    ("proof", || in_turn(workload::generic(), |case| CertifiedAtlas::new(&case.body))),
    ("polylines", || {
        in_turn(prepared(&workload::generic()), |atlas| {
            bifdiag_documents::atlas::document(atlas, &DocumentOptions::default())
        })
    }),
    ("classify", || in_turn(exact(), |(body, h, l)| classify(body, h, l))),
    ("critical", || in_turn(exact(), |(body, _, l)| critical(body, l))),
    ("locate", || {
        let cases = workload::generic();
        let atlases = prepared(&cases);
        let points: Vec<_> =
            cases.iter().zip(atlases).map(|(case, atlas)| (atlas, workload::points(&case.body, 1)[0])).collect();
        in_turn(points, |(atlas, (h, l))| atlas.locate(*h, *l))
    }),
    ("latitude-sweep", || {
        let cases = workload::generic().into_iter().map(|case| (case.body.frame(), case.h, case.l)).collect();
        in_turn(cases, |(frame, h, l): &(bifdiag_body::Frame, f64, f64)| {
            latitude::components(frame, h / frame.energy_unit, l / frame.momentum_unit)
        })
    }),
];

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let known = |name: &str| PATHS.iter().find(|(path, _)| *path == name);
    match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        ["list"] => {
            for (name, _) in PATHS {
                println!("{name}");
            }
            ExitCode::SUCCESS
        }
        [name, count] if known(name).is_some() && count.parse::<usize>().is_ok() => {
            let (_, prepare) = known(name).expect("checked by the guard");
            let mut job = prepare();
            for call in 0..count.parse().expect("checked by the guard") {
                job(call);
            }
            ExitCode::SUCCESS
        }
        _ => {
            eprintln!("hot_paths NAME COUNT, or hot_paths list");
            ExitCode::from(2)
        }
    }
}
