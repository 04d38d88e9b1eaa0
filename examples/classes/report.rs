//! The numbers of `docs/survey.md` and `docs/types.md`, written between their marks.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;
use std::path::Path;

use bifdiag_schema::{ClassDocument, ClassesDocument};
use bifdiag_survey::space::BodySet;

use crate::Failure;
use crate::graph::Unseen;
use crate::special::StratumState;
use crate::state::{Round, Stored, Summary, word};

/// The files from which the numbers are taken.
struct Known {
    walked: Stored,
    all: Stored,
    classes: Vec<ClassDocument>,
    general: Summary,
    special: Vec<StratumState>,
}

/// The files of `data/` and `docs/` below a folder, the root of the repository.
pub fn report(root: &Path) -> Result<(), Failure> {
    let text = |path: &str| std::fs::read_to_string(root.join("data").join(path));
    let known = Known {
        walked: serde_json::from_str(&text("survey/graph.json")?)?,
        all: serde_json::from_str(&text("survey/graph_all.json")?)?,
        classes: serde_json::from_str::<ClassesDocument>(&text("classes.json")?)?.classes,
        general: serde_json::from_str(&text("survey/general.summary.json")?)?,
        special: serde_json::from_str(&text("survey/special.json")?)?,
    };
    fill(
        &root.join("docs/survey.md"),
        &[
            ("rounds", rounds(&known.walked)),
            ("found", format!("In total, {}", totals(&known.walked, BodySet::Physical))),
            ("all", format!("In total, {}", totals(&known.all, BodySet::All))),
            ("depth", depth(&known)),
            ("largest", largest(&known)),
            ("events", events(&known)),
            ("special", special(&known)),
        ],
    )?;
    fill(&root.join("docs/types.md"), &[("four", four(&known)), ("births", births(&known))])
}

/// Puts each text between its marks.
fn fill(path: &Path, texts: &[(&str, String)]) -> Result<(), Failure> {
    let mut page = std::fs::read_to_string(path)?;
    for (name, text) in texts {
        let mark = format!("<!-- classes report: {name} -->\n");
        let (before, rest) = page.split_once(&mark).ok_or_else(|| format!("{}: no mark {name}", path.display()))?;
        let (_, after) = rest.split_once("<!-- end -->").ok_or_else(|| format!("{name} has no end"))?;
        page = format!("{before}{mark}\n{}\n\n<!-- end -->{after}", text.trim_end());
    }
    Ok(std::fs::write(path, page)?)
}

/// With commas between thousands.
fn many(number: u64) -> String {
    let digits = number.to_string();
    let groups: Vec<&str> =
        digits.as_bytes().rchunks(3).rev().filter_map(|group| std::str::from_utf8(group).ok()).collect();
    groups.join(",")
}

fn rounds(walked: &Stored) -> String {
    let mut table = "| round | lines | walls | new classes |\n| ---: | ---: | ---: | ---: |\n".to_owned();
    for (k, round) in walked.rounds.iter().enumerate() {
        let [lines, walls, new] = [round.lines, round.walls, round.new_at.len() as u64].map(many);
        let _always = writeln!(table, "| {} | {lines} | {walls} | {new} |", k + 1);
    }
    table
}

/// What the walks in a domain have met, and what they have not.
fn totals(Stored { rounds, classes, borders }: &Stored, domain: BodySet) -> String {
    let index = usize::from(domain == BodySet::All);
    let rounds = || rounds.iter().filter(|round| round.domain == word(domain));
    let sum = |of: fn(&Round) -> u64| rounds().map(of).sum::<u64>();
    let (lines, walls, lost) = (sum(|round| round.lines), sum(|round| round.walls), sum(|round| round.lost));
    let quiet = rounds().fold(0, |quiet, round| round.after(quiet));
    let pairs: BTreeSet<&[String; 2]> = borders.iter().map(|border| &border.classes).collect();
    let unseen = Unseen::of(classes.iter().map(|class| class.met[index]).filter(|met| *met > 0));
    format!(
        "{} lines with {} walls found **{} classes** and {} kinds of borders between {} pairs of them. The last {} walls\n\
         led to nothing new. At {lost} places ({:.1}%) two classes meet within a stretch that bisection did not resolve, and\n\
         no wall was recorded. By the Good–Turing estimate, the next wall leads to an unknown class with probability {:.1e};\n\
         Chao's estimate of the number of unseen classes is {:.0} ({} {} met once, {} twice).",
        many(lines),
        many(walls),
        classes.len(),
        borders.len(),
        pairs.len(),
        many(quiet),
        100.0 * lost as f64 / (walls + lost).max(1) as f64,
        unseen.chance,
        unseen.classes,
        unseen.once,
        if unseen.once == 1 { "class was" } else { "classes were" },
        unseen.twice
    )
}

fn depth(known: &Known) -> String {
    let mut distances: Vec<f64> =
        known.classes.iter().filter(|class| class.physical).map(|class| class.distance).collect();
    distances.sort_by(f64::total_cmp);
    let (Some(least), Some(largest)) = (distances.first(), distances.last()) else { return String::new() };
    let middle = distances[distances.len() / 2];
    let thin = distances.iter().filter(|distance| **distance < 1e-8).count();
    format!(
        "Distances to the nearest body of another class that the survey found range from {largest:.2} to {least:.0e}; their \
         median is {middle:.0e}; {thin} are below 1e-8. `classes --at` finds a nearer one from some of the witnesses."
    )
}

fn largest(known: &Known) -> String {
    let mut table =
        "| class | share | regions | cusps | crossings | neighbours |\n| --- | ---: | ---: | ---: | ---: | ---: |\n"
            .to_owned();
    let mut order: Vec<&ClassDocument> = known.classes.iter().filter(|class| class.physical).collect();
    order.sort_by(|p, q| q.measure.total_cmp(&p.measure));
    for class in order.into_iter().take(14) {
        let events = known.general.classes.iter().find(|met| met.class == class.name).map(|met| met.events);
        let [cusps, _, crossings] = events.unwrap_or_default();
        let beside: BTreeSet<&str> = class.neighbours.iter().map(|beside| beside.class.as_str()).collect();
        let _always = writeln!(
            table,
            "| `{0}` | {1:.2}% | {2} | {cusps} | {crossings} | {3} |",
            class.name,
            100.0 * class.measure,
            class.regions,
            beside.len()
        );
    }
    table
}

/// The kind of an event, and the branches that take part.
fn kind(event: &str) -> Option<(usize, String)> {
    let through = |event: &str| {
        let words: Vec<&str> = event.split_whitespace().collect();
        Some(format!("{} through {}", words.get(3)?, event.split("through ").nth(1)?))
    };
    if let Some((_, branch)) = event.split_once(" on branch ").filter(|_| event.starts_with("a swallowtail is born")) {
        return Some((0, branch.to_owned()));
    }
    if event.starts_with("the cusp of ") && event.contains("passes through") {
        return Some((if event.contains(" P") { 2 } else { 1 }, through(event)?));
    }
    if let Some(curves) = event.strip_prefix("curves of ").and_then(|rest| rest.strip_suffix(" meet in one point")) {
        let few = curves.split(", ").count() <= 3;
        return few.then(|| (if curves.contains('P') { 4 } else { 3 }, curves.to_owned()));
    }
    event.starts_with("J_r").then(|| (5, "P+ and P-".to_owned()))
}

const KINDS: [&str; 6] = [
    "swallowtail",
    "cusp through a critical curve",
    "cusp through a pole line",
    "triple point of critical curves",
    "triple point with a pole line",
    "pole lines at infinity, J_r = A2",
];

fn events(known: &Known) -> String {
    let mut met: [(u64, u64, BTreeMap<String, u64>); 6] = Default::default();
    let mut others = 0;
    for border in &known.walked.borders {
        let walls = border.walls[0];
        match kind(&border.event) {
            Some((kind, branches)) if walls > 0 => {
                met[kind].0 += 1;
                met[kind].1 += walls;
                *met[kind].2.entry(branches).or_default() += walls;
            }
            _ => others += walls,
        }
    }
    let mut table = "| event | kinds of borders | walls | of the branches |\n| --- | ---: | ---: | --- |\n".to_owned();
    for (name, (borders, walls, branches)) in KINDS.iter().zip(met) {
        let mut branches: Vec<(String, u64)> = branches.into_iter().collect();
        branches.sort_by(|p, q| q.1.cmp(&p.1).then_with(|| p.0.cmp(&q.0)));
        let names: Vec<String> = branches.into_iter().map(|(name, _)| name).collect();
        let _always = writeln!(table, "| {name} | {borders} | {} | {} |", many(walls), names.join("; "));
    }
    format!(
        "{table}\nNot listed are {others} walls of other kinds, where two events are closer than f64 resolves, or where the \
         nearest event was mistaken for the one that happens."
    )
}

fn special(known: &Known) -> String {
    let mut table =
        "| bodies | parameters | classes | of physical bodies | borders | walls | last with a new class | named |\n\
                     | --- | ---: | ---: | ---: | ---: | ---: | ---: | --- |\n"
            .to_owned();
    for StratumState { stratum, parameters, met, walked, existing, .. } in &known.special {
        let walls: u64 = walked.rounds.iter().map(|round| round.walls).sum();
        let (mut before, mut last) = (0, 0);
        for round in &walked.rounds {
            last = round.new_at.last().map_or(last, |at| before + at);
            before += round.walls;
        }
        let presets: Vec<&str> = met.values().filter_map(|met| met.preset.as_deref()).collect();
        let _always = writeln!(
            table,
            "| {stratum} | {parameters} | {} | {existing} | {} | {} | {} | {} |",
            met.len(),
            walked.borders.len(),
            many(walls),
            many(last),
            presets.join(", ")
        );
    }
    table
}

fn has(class: &ClassDocument, kind: &str) -> bool {
    class.types.iter().any(|found| found == kind)
}

fn four(known: &Known) -> String {
    let classes: Vec<&ClassDocument> = known.classes.iter().filter(|class| class.physical).collect();
    let count = |test: &dyn Fn(&ClassDocument) -> bool| classes.iter().filter(|class| test(class)).count();
    format!(
        "Of the {} known classes of physical bodies, {} show k4n2 and {} show k4n1 ({} show at least one).",
        classes.len(),
        count(&|class| has(class, "k4n2")),
        count(&|class| has(class, "k4n1")),
        count(&|class| has(class, "k4n1") || has(class, "k4n2"))
    )
}

fn births(known: &Known) -> String {
    let classes: BTreeMap<&str, &ClassDocument> =
        known.classes.iter().filter(|class| class.physical).map(|class| (class.name.as_str(), class)).collect();
    let mut table = "| type | event | borders |\n| --- | --- | ---: |\n".to_owned();
    for kind in ["k4n1", "k4n2"] {
        let mut events: BTreeMap<&str, usize> = BTreeMap::new();
        for beside in classes.values().filter(|class| has(class, kind)).flat_map(|class| &class.neighbours) {
            if beside.physical && classes.get(beside.class.as_str()).is_some_and(|class| !has(class, kind)) {
                *events.entry(&beside.event).or_default() += 1;
            }
        }
        let mut events: Vec<_> = events.into_iter().collect();
        events.sort_by(|p, q| q.1.cmp(&p.1).then_with(|| p.0.cmp(q.0)));
        for (event, count) in events {
            let _always = writeln!(table, "| {kind} | {event} | {count} |");
        }
    }
    table
}
