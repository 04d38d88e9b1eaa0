//! How enclosures of proved motions widen: widths against time, of a regular and of a chaotic motion.

use std::error::Error;
use std::sync::atomic::{AtomicBool, AtomicU64};

use bifdiag_body::{Body, Number};
use bifdiag_enclosure::orbit::{ProofOptions, prove};
use bifdiag_enclosure::start::ExactStart;
use dashu_ratio::RBig;

use crate::chart::{Chart, ChartAxis, ChartPanel, Scale, Series, draw_chart};
use crate::figure::{Figure, THEME};

/// A, r, γ and ω: the paper's body, and `ten`.
const MOTIONS: [(&str, [[&str; 3]; 4]); 2] = [
    ("paper, regular", [["2", "1.1", "1"], ["0.94868", "0", "0.61623"], ["0.6", "0", "0.8"], ["1", "0.3", "1"]]),
    (
        "ten, chaotic",
        [
            ["0.57847392", "0.53739099", "1"],
            ["0.00595273", "0.00176367", "-0.99998073"],
            ["0", "0.1", "1"],
            ["0.3", "0.2", "0.5"],
        ],
    ),
];

/// Digits that make 53, 64 and 102 bits.
const PRECISIONS: [(u32, &str); 3] = [(15, "53 bits"), (19, "64 bits"), (30, "102 bits")];

/// Enclosures are followed up to here.
const BOUND: f64 = 1e-2;

pub fn figures() -> impl Iterator<Item = Figure> {
    std::iter::once(Figure { stem: "proved-widths", draw: Box::new(|| Ok(draw_chart(&widths()?, THEME)?)) })
}

fn widths() -> Result<Chart, Box<dyn Error>> {
    let panel = |(name, [a, r, gamma, omega]): (&str, [[&str; 3]; 4])| -> Result<ChartPanel, Box<dyn Error>> {
        let body = Body::parse(&a.map(str::to_owned), &r.map(str::to_owned))?;
        let exact = |v: [&str; 3]| -> Result<[RBig; 3], Box<dyn Error>> {
            let [x, y, z] = v.map(str::parse::<Number>);
            Ok([x?.value().clone(), y?.value().clone(), z?.value().clone()])
        };
        let start = ExactStart { gamma: exact(gamma)?, omega: exact(omega)?, phi: RBig::ZERO };
        // From 1 to 2000, eight in a decade.
        let times = (0..=26).filter_map(|k| RBig::try_from(libm::exp10(f64::from(k) / 8.0).round()).ok());
        let mut times: Vec<RBig> = times.collect();
        times.dedup();
        let stop = AtomicBool::new(false);
        let series = PRECISIONS.iter().enumerate().map(|(name, (digits, _))| {
            let options = ProofOptions { digits: Some(*digits), bound: BOUND, stop: &stop, steps: &AtomicU64::new(0) };
            let samples = prove(&body, &start, &times, &options).samples;
            let points = samples.iter().map(|sample| [sample.time.to_f64().value(), sample.width()]).collect();
            Series { name, points, joined: true, intervals: Vec::new() }
        });
        Ok(ChartPanel {
            title: name.to_owned(),
            x: ChartAxis { label: "time".to_owned(), scale: Scale::Logarithmic },
            y: ChartAxis { label: "width of the widest interval".to_owned(), scale: Scale::Logarithmic },
            series: series.collect(),
        })
    };
    Ok(Chart {
        title: "Widths of proved enclosures against time".to_owned(),
        names: PRECISIONS.map(|(_, name)| name.to_owned()).to_vec(),
        panels: MOTIONS.into_iter().map(panel).collect::<Result<_, _>>()?,
    })
}
