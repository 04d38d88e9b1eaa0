//! The campaign that makes `data/classes.json`: walks, deep witnesses, measures.
//!
//! ```sh
//! cargo run --release --example classes -- grow STATE existing|all SEED STEPS WALLS [i/n] [SUMMARY.json …]
//! cargo run --release --example classes -- round STATE existing|all SEED STEPS [i/n] [SUMMARY.json …]
//! cargo run --release --example classes -- join STATE SHARD …
//! cargo run --release --example classes -- deepen STATE STEPS [i/n]
//! cargo run --release --example classes -- write STATE ALL SPECIAL GENERAL.summary.json POSITIVE.summary.json PUBLISHED SHIPPED
//! cargo run --release --example classes -- special data/survey/special.json SEED LINES
//! cargo run --release --example classes -- pages data/classes.json target/classes
//! cargo run --release --example classes -- report .
//! cargo run --release --example classes -- extremes data/classes.json
//! cargo run --release --example classes -- five SEED RUNS STEPS
//! ```
//!
//! `grow` begins with the classes of STATE, and those of the first bodies of scans, and lets each of them walk STEPS steps
//! again and again, until no new class was met on WALLS walls; STATE is written after each round, and the same command
//! goes on from there; `round` is one round alone. A shard walks from a part of the classes; `join` adds shards to STATE. `deepen` looks for witnesses far from all borders, `special` walks in
//! each stratum of special bodies until LINES lines in a row met no new class, `pages` writes the catalogue, `report` the
//! numbers of `docs/survey.md` and `docs/types.md` between their marks. `five` searches for a fifth maximum. `data/classes.sh` has the
//! commands that made what is published.

mod chord;
mod deepen;
mod document;
mod extremes;
mod five;
mod graph;
mod map;
mod others;
mod pages;
mod report;
mod sketch;
mod special;
mod state;
mod walk;

use std::path::Path;

use bifdiag_diagram::class::ClassName;
use bifdiag_schema::{ClassDocument, ClassesDocument};
use bifdiag_survey::nearest::NearestOptions;
use bifdiag_survey::scan::Shard;
use bifdiag_survey::space::{BodySet, ReducedBody};
use rayon::prelude::*;

use deepen::{centre, deepen, plain};
use document::ClassCounts;
use state::{State, Summary, part};

type Failure = Box<dyn std::error::Error>;

fn main() -> Result<(), Failure> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = arguments.iter().map(String::as_str).collect();
    match words[..] {
        ["grow", state, domain, seed, steps, walls, ref rest @ ..] => {
            let (path, domain, walls) = (Path::new(state), set_of_word(domain), walls.parse()?);
            let (seed, steps, (shard, summaries)) = (seed.parse()?, steps.parse()?, shard(rest)?);
            let mut state = begun(path, summaries)?;
            while state.quiet(domain, seed) < walls {
                walk(path, &mut state, domain, [seed, steps], shard)?;
            }
            Ok(())
        }
        ["round", state, domain, seed, steps, ref rest @ ..] => {
            let (path, (shard, summaries)) = (Path::new(state), shard(rest)?);
            walk(path, &mut begun(path, summaries)?, set_of_word(domain), [seed.parse()?, steps.parse()?], shard)
        }
        ["join", state, ref shards @ ..] => {
            let mut whole = State::read_or_new(Path::new(state))?;
            for shard in shards {
                whole.join(State::read(Path::new(shard))?);
            }
            whole.write(Path::new(state))
        }
        ["deepen", state, steps, ref rest @ ..] => deepen_all(Path::new(state), steps.parse()?, shard(rest)?.0),
        ["write", state, all, special, general, positive, published, shipped] => {
            let state = State::read(Path::new(state))?;
            let counts = ClassCounts { existing: counts(general)?, all: counts(positive)? };
            let mut document = document::classes(&state.graph, &counts)?;
            document.others = others::others(all, special, &document.classes, &counts)?;
            std::fs::write(published, lines(&document)?)?;
            document.classes.iter_mut().for_each(|class| class.text.clear());
            Ok(std::fs::write(shipped, lines(&document)?)?)
        }
        ["special", path, seed, lines] => special::special(Path::new(path), [seed.parse()?, lines.parse()?]),
        ["extremes", classes] => extremes::extremes(classes),
        ["report", root] => report::report(Path::new(root)),
        ["five", seed, runs, steps] => {
            five::five([seed.parse()?, runs.parse()?, steps.parse()?]);
            Ok(())
        }
        ["pages", classes, folder] => pages::pages(classes, Path::new(folder)),
        _ => Err("see the head of examples/classes/main.rs".into()),
    }
}

/// One class a line.
fn lines(document: &ClassesDocument) -> Result<String, Failure> {
    let list = |classes: &[ClassDocument]| -> Result<String, serde_json::Error> {
        Ok(classes.iter().map(serde_json::to_string).collect::<Result<Vec<_>, _>>()?.join(",\n"))
    };
    let (version, classes, others) =
        (serde_json::to_string(&document.schema_version)?, list(&document.classes)?, list(&document.others)?);
    Ok(format!("{{\"schema_version\":{version},\"classes\":[\n{classes}\n],\"others\":[\n{others}\n]}}\n"))
}

/// A shard, if the first word is one, and the rest.
fn shard<'a>(words: &'a [&'a str]) -> Result<(Shard, &'a [&'a str]), Failure> {
    match words {
        [first, rest @ ..] if first.contains('/') && first.parse::<Shard>().is_ok() => Ok((first.parse()?, rest)),
        _ => Ok(("1/1".parse()?, words)),
    }
}

fn set_of_word(domain: &str) -> BodySet {
    if domain == state::word(BodySet::All) { BodySet::All } else { BodySet::Physical }
}

fn counts(path: &str) -> Result<(std::collections::BTreeMap<ClassName, u64>, u64), Failure> {
    let summary = Summary::read(path)?;
    let classes = summary.classes.iter().map(|class| Ok((class.class.parse()?, class.bodies)));
    Ok((classes.collect::<Result<_, Failure>>()?, summary.classified))
}

/// The state of a file, and the classes of the first bodies of scans.
fn begun(path: &Path, summaries: &[&str]) -> Result<State, Failure> {
    let mut state = State::read_or_new(path)?;
    for summary in summaries {
        for class in Summary::read(summary)?.classes {
            state.graph.add_body(ReducedBody::of([class.first.moments, class.first.center]).values());
        }
    }
    Ok(state)
}

/// One round more, which is written.
fn walk(path: &Path, state: &mut State, domain: BodySet, [seed, steps]: [u64; 2], shard: Shard) -> Result<(), Failure> {
    let number = state.rounds_of(domain, seed).count() as u64;
    let round = state.round(domain, [seed, number, steps], shard);
    let report = round.to_string();
    state.rounds.push(round);
    let (quiet, unseen) = (state.quiet(domain, seed), state.graph.unseen(domain));
    let (classes, borders) = (state.graph.nodes.len(), state.graph.edges.len());
    eprintln!("{report} {quiet} quiet, {classes} classes, {borders} borders, {unseen:?}");
    state.write(path)
}

/// Lines on which a witness goes to the middle of its class, before it is made deeper.
const LINES: u32 = 10;

/// Classes between two writings of the state.
const BLOCK: usize = 16;

/// Makes the witnesses of a part of the classes deeper, those whose distance is not known; STATE is written again and again.
fn deepen_all(path: &Path, steps: u32, shard: Shard) -> Result<(), Failure> {
    let mut state = State::read(path)?;
    let names: Vec<ClassName> = state.graph.nodes.keys().cloned().collect();
    let shallow: Vec<ClassName> =
        part(&names, shard).into_iter().filter(|name| state.graph.nodes[name].distance == 0.0).collect();
    for block in shallow.chunks(BLOCK) {
        let found: Vec<_> = block
            .par_iter()
            .map(|name| {
                let node = &state.graph.nodes[name];
                let domain = if node.physical { BodySet::Physical } else { BodySet::All };
                let options = NearestOptions { lines: Some(8), set: domain, seed: 1 };
                let place = centre(ReducedBody::of(node.witness), name, LINES, domain, 1);
                let (place, distance) = deepen(place, name, steps, &options);
                (name, plain(place, name, distance, &NearestOptions { seed: 2, ..options }))
            })
            .collect();
        for (name, (values, distance)) in found {
            eprintln!("{name} {distance:.3e} {values:?}");
            if let Some(node) = state.graph.nodes.get_mut(name) {
                (node.witness, node.distance) = (values, distance);
            }
        }
        state.write(path)?;
    }
    Ok(())
}
