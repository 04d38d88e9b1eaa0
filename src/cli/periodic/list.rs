//! `bifdiag periodic list`: the families of all equilibria of a body, with filters for their orbits.

use std::sync::Arc;
use std::sync::atomic::Ordering;

use bifdiag_body::Number;
use bifdiag_documents::{Asked, Subject, families_listed, periodic_list};
use bifdiag_dynamics::section::Monitor;
use bifdiag_equilibria::curves::CurveName;
use bifdiag_periodic::catalogue::{Catalogue, Wanted};
use bifdiag_periodic::family::{FamilyError, FamilyOptions, Held};
use bifdiag_schema::{ListedFamilyDocument, PeriodicListDocument};
use clap::Args;
use rayon::prelude::*;

use super::family::NOT_FOUND;
use super::list_output::{columns, read_back, text, written};
use crate::cli::export::{DataFormat, DataTarget, Journal, answer, unusable};
use crate::cli::failure::{Failure, failed, no_such_curve};
use crate::cli::input::{BodyArguments, Numbers, values};
use crate::cli::terminal::interrupt::{Stoppable, stoppable};
use crate::cli::terminal::{Progress, print, say};

pub const LIST_EXAMPLES: &str = "\
Examples:
  bifdiag periodic list --body paper --l 1.5 --members 60
  bifdiag periodic list --body paper --l 1.5 --stable --period 2:5
  bifdiag periodic list --body paper --l 0.5:1.5:3 --family G2.1/1 --data orbits.csv

A family begins at every imaginary pair of every isolated relative equilibrium (Lyapunov's centre theorem), but for resonant \
ones. Without --l and --h families are followed at l = 0 and at one momentum of each kind: between any two at which equilibria \
appear, vanish or change their linear type. \
With --data, an interrupted list resumes when the same command is run again.";

/// `bifdiag periodic list`.
#[derive(Debug, Args)]
pub struct ListArguments {
    #[command(flatten)]
    pub body: BodyArguments,
    /// Vertical angular momentum, held fixed along a family, or a range a:b:n of n values
    #[arg(long = "l", value_name = "l|a:b:n", allow_hyphen_values = true, value_parser = Numbers::parse, help_heading = "Families")]
    pub momentum: Option<Numbers>,
    /// Instead of l: the energy, held fixed, or a range of energies
    #[arg(long = "h", value_name = "h|a:b:n", allow_hyphen_values = true, value_parser = Numbers::parse, help_heading = "Families")]
    #[arg(conflicts_with = "momentum")]
    pub energy: Option<Numbers>,
    /// Only the families of one curve, such as G2.1, or a single one, such as G2.1/2 for its second fastest oscillation
    #[arg(long, value_name = "FAMILY", value_parser = Only::parse, help_heading = "Families")]
    pub family: Option<Only>,
    /// Follow each family for at most N orbits
    #[arg(long, value_name = "N", default_value_t = 200, help_heading = "Families")]
    pub members: usize,
    /// Also follow the families that begin at doublings, triplings and crossings
    #[arg(long, help_heading = "Families")]
    pub branches: bool,
    /// Only linearly stable orbits
    #[arg(long, help_heading = "Orbits")]
    pub stable: bool,
    /// Only orbits with a period from A to B
    #[arg(long, value_name = "A:B", value_parser = periods, help_heading = "Orbits")]
    pub period: Option<[f64; 2]>,
    /// Only orbits that cross P at most N times in a period
    #[arg(long, value_name = "N", help_heading = "Orbits")]
    pub crossings: Option<u32>,
    /// Write the orbits to FILE (.parquet, .csv, .jsonl, .npz; -: CSV to stdout)
    #[arg(long, value_name = "FILE", help_heading = "Output")]
    pub data: Option<String>,
    /// Discard what an earlier run of --data left unfinished
    #[arg(long, requires = "data", help_heading = "Output")]
    pub restart: bool,
    /// Print the families and orbits as JSON
    #[arg(long, help_heading = "Output")]
    pub json: bool,
}

/// A curve, and the number of a family on it.
#[derive(Clone, Debug, PartialEq)]
pub struct Only {
    text: String,
    curve: CurveName,
    number: Option<usize>,
}

impl Only {
    fn parse(text: &str) -> Result<Self, Failure> {
        let text = values::id(text);
        let (curve, number) = text.split_once('/').map_or((&text[..], None), |(curve, number)| (curve, Some(number)));
        let number = match number.map(str::parse) {
            None => None,
            Some(Ok(number @ 1..=2)) => Some(number),
            Some(_) => {
                return Err(Failure::input(format!(
                    "`{text}` is not a family: an equilibrium has at most two, such as G2.1/1 and G2.1/2"
                )));
            }
        };
        let curve = curve.parse().map_err(Failure::input)?;
        Ok(Self { text, curve, number })
    }
}

fn periods(text: &str) -> Result<[f64; 2], Failure> {
    let (from, to) = text.split_once(':').ok_or_else(|| Failure::input("periods are written A:B, such as 2:5"))?;
    let [from, to] = [values::float(from)?, values::float(to)?];
    if from <= to {
        Ok([from, to])
    } else {
        Err(Failure::input(format!("A = {from} is above B = {to}; write the shorter period first")))
    }
}

pub fn run(arguments: &ListArguments, quiet: bool) -> Result<(), Failure> {
    if arguments.members == 0 {
        return Err(Failure::input("--members 0: a family has at least one orbit"));
    }
    let target = arguments.data.as_deref().map(DataTarget::parse).transpose()?;
    if arguments.json && target == Some(DataTarget::Stdout) {
        return Err(Failure::input("--json and --data - both write to stdout; give --data a file"));
    }
    let subject = arguments.body.subject()?;
    let catalogue = Catalogue::new(&subject.body).map_err(failed(NOT_FOUND))?;
    if let Some(Only { text, curve, .. }) = &arguments.family
        && !catalogue.curves().contains(curve)
    {
        return Err(no_such_curve("--family", text, catalogue.curves()));
    }
    let (held, values) = match (&arguments.momentum, &arguments.energy) {
        (Some(momenta), _) => (Held::Momentum, momenta.list()),
        (None, Some(energies)) => (Held::Energy, energies.list()),
        (None, None) => (Held::Momentum, catalogue.momenta()),
    };
    let wanted = Wanted { stable: arguments.stable, period: arguments.period, crossings: arguments.crossings };
    let asked = Asked {
        held,
        values: &values,
        only: arguments.family.as_ref().map(|only| &only.text[..]),
        members: arguments.members,
        branches: arguments.branches,
        wanted,
    };
    let work = Work { subject: &subject, catalogue: &catalogue, asked: &asked, arguments };
    let monitor = Arc::new(Monitor::default());
    let shared = Arc::clone(&monitor);
    let interruptible = stoppable(move || shared.stop.store(true, Ordering::Relaxed));
    match target {
        Some(DataTarget::File { path, format }) => {
            let journal = work.journal(&path)?;
            let mut kept = Kept { journal: Some(journal), families: Vec::new() };
            work.follow(&mut kept, &monitor, interruptible, quiet)?;
            let document = work.document(kept.families);
            let table = columns(&document)?;
            let files = written(&table, (&path, format))?;
            if let Some(journal) = kept.journal {
                std::fs::remove_file(journal.path()).map_err(|error| unusable(journal.path(), error))?;
            }
            answer(arguments.json, &document, || text(&subject, &document, &files))
        }
        stdout => {
            let mut kept = Kept { journal: None, families: Vec::new() };
            work.follow(&mut kept, &monitor, interruptible, quiet)?;
            let document = work.document(kept.families);
            if stdout.is_some() {
                return print(DataFormat::Csv.bytes(&columns(&document)?)?);
            }
            answer(arguments.json, &document, || text(&subject, &document, &[]))
        }
    }
}

/// The families found so far.
struct Kept {
    /// Keeps them on disk as well.
    journal: Option<Journal>,
    families: Vec<ListedFamilyDocument>,
}

/// A list to be made.
struct Work<'a> {
    subject: &'a Subject,
    catalogue: &'a Catalogue<'a>,
    asked: &'a Asked<'a>,
    arguments: &'a ListArguments,
}

impl Work<'_> {
    fn document(&self, families: Vec<ListedFamilyDocument>) -> PeriodicListDocument {
        let Asked { held, values, members, .. } = *self.asked;
        let mut command = self.subject.command("periodic list");
        let name = if held == Held::Momentum { "l" } else { "h" };
        let given = if held == Held::Momentum { &self.arguments.momentum } else { &self.arguments.energy };
        let text = given.as_ref().map(|given| match given {
            Numbers::One(number) => number.text().to_owned(),
            Numbers::Range { from, to, .. } => format!("{}:{}:{}", from.text(), to.text(), values.len()),
        });
        command = command.option_if(name, text).option_if("family", self.asked.only);
        command = command.option("members", members).flag("branches", self.asked.branches);
        let Wanted { stable, period, crossings } = self.asked.wanted;
        command = command.flag("stable", stable).option_if("period", period.map(|[from, to]| format!("{from}:{to}")));
        periodic_list(self.subject, command.option_if("crossings", crossings), self.asked, families)
    }

    fn journal(&self, path: &std::path::Path) -> Result<Journal, Failure> {
        let identity = serde_json::to_vec(&self.document(Vec::new()))?;
        Journal::open(path, &identity, self.arguments.restart, |path, _| {
            Err(Failure::input(format!(
                "{} belongs to another unfinished list; finish that one with its own options, choose another --data, \
                or give --restart to discard it",
                path.display()
            )))
        })
    }

    /// Follows the families at every value that the journal lacks.
    fn follow(&self, kept: &mut Kept, monitor: &Monitor, interruptible: Stoppable, quiet: bool) -> Result<(), Failure> {
        let mut done = 0;
        if let Some(journal) = &mut kept.journal {
            done = journal.blocks().len();
            kept.families = read_back(journal)?;
            if done > 0 && !quiet {
                let name = if self.asked.held == Held::Momentum { "momenta" } else { "energies" };
                say(&format!("resuming after {done} of {} {name} done before", self.asked.values.len()));
            }
        }
        let total = self.asked.values.len() as u64;
        let progress = Progress::new(done as u64, total, "values", quiet);
        for value in &self.asked.values[done..] {
            let found = progress.beside(&monitor.orbits, "orbits found", || self.at(value, monitor))?;
            if monitor.is_stopped() {
                break;
            }
            if let Some(journal) = &mut kept.journal {
                let mut block = Vec::new();
                for family in &found {
                    bifdiag_schema::write_json(&mut block, family)?;
                    block.push(b'\n');
                }
                journal.append(&block)?;
            }
            kept.families.extend(found);
            progress.add(1);
        }
        progress.finish();
        let is_whole = interruptible.over();
        drop(interruptible);
        if is_whole {
            return Ok(());
        }
        Err(Failure::work(kept.journal.as_ref().map_or_else(
            || "interrupted".to_owned(),
            |journal| {
                let path = journal.path().display();
                format!("interrupted: {path} holds what was found; run the same command again to resume from there")
            },
        )))
    }

    /// The families at one value.
    fn at(&self, value: &Number, monitor: &Monitor) -> Result<Vec<ListedFamilyDocument>, Failure> {
        let Asked { held, members, branches, ref wanted, .. } = *self.asked;
        let only = self.arguments.family.as_ref();
        let starts = self.catalogue.starts(held, value, only.map(|only| only.curve)).map_err(failed(NOT_FOUND))?;
        let options = FamilyOptions { held, members, branches, monitor };
        let found: Result<Vec<_>, FamilyError> = starts
            .into_par_iter()
            .map(|start| {
                let families = self.catalogue.families(&start, &options)?;
                Ok((start, families))
            })
            .collect();
        let found = found.map_err(failed(NOT_FOUND))?;
        Ok(families_listed(&self.subject.body, &found, only.and_then(|only| only.number), wanted))
    }
}
