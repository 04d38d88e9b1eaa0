//! Walks inside the strata of special bodies.

use std::collections::BTreeMap;
use std::path::Path;

use bifdiag_body::Body;
use bifdiag_exact::Accuracy;
use bifdiag_survey::border::class_of;
use bifdiag_survey::scan;
use bifdiag_survey::space::{BodySet, TangentBasis};
use serde::{Deserialize, Serialize};
use support::special::{RandomBodies, SPECIAL_STRATA, SpecialStratum};

use crate::Failure;
use crate::state::{State, Stored, replace};

/// Random bodies of a stratum, of each domain.
const BODIES: usize = 2000;

/// What is known of a stratum.
#[derive(Serialize, Deserialize)]
pub struct StratumState {
    pub stratum: String,
    pub parameters: usize,
    /// Random bodies that were drawn, of those that exist and of all A > 0.
    pub bodies: usize,
    /// Number of classes that bodies that exist have.
    pub existing: usize,
    /// Its classes.
    pub met: BTreeMap<String, Met>,
    #[serde(flatten)]
    pub walked: Stored,
}

/// A class of a stratum.
#[derive(Default, Serialize, Deserialize)]
pub struct Met {
    /// How many of the random bodies have it, of those that exist and of all A > 0.
    pub bodies: [u32; 2],
    /// The first of the program's named bodies that has it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub preset: Option<String>,
}

/// Walks in each stratum that FILE does not have; it is written after each of them.
pub fn special(path: &Path, [seed, lines]: [u64; 2]) -> Result<(), Failure> {
    let mut known: Vec<StratumState> = match std::fs::read_to_string(path) {
        Ok(text) => serde_json::from_str(&text)?,
        Err(_) => Vec::new(),
    };
    // Those with few parameters are done soonest.
    for (number, stratum) in SPECIAL_STRATA.iter().enumerate().rev() {
        if known.iter().any(|done| done.stratum == stratum.name) {
            continue;
        }
        let found = walk(stratum, [seed.wrapping_add(number as u64), lines])?;
        eprintln!("{}: {} classes", found.stratum, found.met.len());
        known.insert(0, found);
        // A stratum a line.
        let texts = known.iter().map(serde_json::to_string).collect::<Result<Vec<_>, _>>()?;
        replace(path, &format!("[\n{}\n]\n", texts.join(",\n")))?;
    }
    Ok(())
}

fn walk(stratum: &SpecialStratum, [seed, lines]: [u64; 2]) -> Result<StratumState, Failure> {
    let mut state = State::default();
    let mut met: BTreeMap<String, Met> = BTreeMap::new();
    let parameters = stratum.bodies(BodySet::All, seed).next().map_or(0, |place| TangentBasis::new(place).dimensions());
    for (index, domain) in [BodySet::Physical, BodySet::All].into_iter().enumerate() {
        for place in stratum.bodies(domain, seed).take(BODIES) {
            let Ok((_, class)) = class_of(&Body::from_f64(place.a, place.r)?, Accuracy::Fast) else { continue };
            let Met { bodies, .. } = met.entry(class.name().to_string()).or_default();
            bodies[index] += 1;
            if bodies[index] == 1 {
                state.graph.add_body(place.values());
            }
        }
        let (mut quiet, mut number) = (0, 0);
        while parameters > 0 && quiet < lines {
            let round = state.round(domain, [seed, number, 2], "1/1".parse()?);
            quiet = if round.new_at.is_empty() { quiet + round.lines } else { 0 };
            eprintln!("{}: {round} {quiet} quiet, {} classes", stratum.name, state.graph.nodes.len());
            number += 1;
            let idle = round.lines == 0;
            state.rounds.push(round);
            if idle {
                break;
            }
        }
    }
    let presets = scan::known_classes();
    for name in state.graph.nodes.keys() {
        let preset = presets.get(name).map(|preset| preset.name().to_owned());
        met.entry(name.to_string()).or_default().preset = preset;
    }
    let existing = state.graph.nodes.values().filter(|node| node.physical).count();
    let stratum = stratum.name.to_owned();
    Ok(StratumState { stratum, parameters, bodies: BODIES, existing, met, walked: state.stored() })
}
