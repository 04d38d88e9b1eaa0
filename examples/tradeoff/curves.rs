//! Points exactly on curves (`data/oracles/curve_points.py`): each is critical, and its candidates are the classes that the
//! latitude sweep proves around it.

use std::collections::BTreeMap;

use bifdiag_body::Body;
use bifdiag_diagram::topology::Answer;
use bifdiag_diagram::topology::Component;
use bifdiag_exact::Accuracy;
use rayon::prelude::*;
use serde::Deserialize;

use super::Failure;
use super::clock::{spread, timed};
use super::points::swept;
use super::verdict::{Verdict, counts};

#[derive(Deserialize)]
struct Line {
    kind: String,
    #[serde(rename = "A")]
    moments: [String; 3],
    #[serde(rename = "r")]
    center: [String; 3],
    h: String,
    l: String,
    around: Vec<(f64, f64)>,
}

struct Answered {
    kind: String,
    verdict: Verdict,
    /// How many classes meet.
    classes: usize,
    time: f64,
}

pub fn run(path: &str) -> Result<(), Failure> {
    let text = std::fs::read_to_string(path)?;
    let lines: Vec<&str> = text.lines().collect();
    let answers: Result<Vec<Answered>, String> =
        lines.par_iter().map(|line| answered(line).map_err(|error| error.to_string())).collect();
    let mut kinds: BTreeMap<String, Vec<Answered>> = BTreeMap::new();
    for answer in answers? {
        kinds.entry(answer.kind.clone()).or_default().push(answer);
    }
    println!(
        "kind,points,right,wrong,failed,untold,classes_1,classes_2,classes_3,classes_4,cpu_us_median,cpu_us_99,cpu_us_largest"
    );
    for (kind, answers) in kinds {
        let verdicts: Vec<Verdict> = answers.iter().map(|answer| answer.verdict).collect();
        let counts = counts(&verdicts, &[Verdict::Right, Verdict::Wrong, Verdict::Failed, Verdict::Unknown]);
        let meeting = |classes| answers.iter().filter(|answer| answer.classes == classes).count().to_string();
        let meeting = (1..=4).map(meeting).collect::<Vec<_>>().join(",");
        let mut times: Vec<f64> = answers.iter().map(|answer| answer.time).collect();
        println!("{kind},{},{counts},{meeting},{}", answers.len(), spread(&mut times, 1));
    }
    Ok(())
}

fn answered(line: &str) -> Result<Answered, Failure> {
    let Line { kind, moments, center, h, l, around } = serde_json::from_str(line)?;
    let body = Body::parse(&moments, &center)?;
    let (h, l) = (h.parse()?, l.parse()?);
    let mut classes: Option<Vec<Vec<Component>>> = around.iter().map(|&(h, l)| swept(&body, h, l)).collect();
    if let Some(classes) = &mut classes {
        let mut seen = Vec::new();
        classes.retain(|class| {
            !seen.contains(class) && {
                seen.push(class.clone());
                true
            }
        });
    }
    let (found, time) = timed(|| bifdiag_exact::classify(&body, &h, &l, Accuracy::Exact));
    let verdict = match (found.as_ref().map(|found| &found.answer), &classes) {
        (Err(_), _) => Verdict::Failed,
        // The sweep refuses a point around.
        (Ok(Answer::Critical(_)), None) => Verdict::Unknown,
        (Ok(Answer::Critical(candidates)), Some(classes)) => {
            let all = candidates.len() == classes.len() && candidates.iter().all(|class| classes.contains(class));
            if all { Verdict::Right } else { Verdict::Wrong }
        }
        (Ok(_), _) => Verdict::Wrong,
    };
    if matches!(verdict, Verdict::Wrong | Verdict::Failed) {
        eprintln!("{kind}: {line}\n  {found:?}\n  {classes:?}");
    }
    Ok(Answered { kind, verdict, classes: classes.map_or(0, |classes| classes.len()), time })
}
