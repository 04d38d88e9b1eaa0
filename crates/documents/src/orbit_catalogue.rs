//! All families of a body, with the orbits that were asked for, as a document.

use bifdiag_body::{Body, Number};
use bifdiag_equilibria::critical::Equilibrium;
use bifdiag_numbers::decimal::counted;
use bifdiag_periodic::catalogue::Wanted;
use bifdiag_periodic::family::{Family, Held, Stretch};
use bifdiag_schema::{CommandLine, FamilyEnd, ListedFamilyDocument, ListedOrbitDocument, PeriodicListDocument};

use crate::body::{given, head};
use crate::periodic::{end, periodic_orbit};
use crate::subject::Subject;

/// What was asked for.
#[derive(Clone, Debug)]
pub struct Asked<'a> {
    /// What is held along a family.
    pub held: Held,
    /// Its values.
    pub values: &'a [Number],
    /// Only one curve or family.
    pub only: Option<&'a str>,
    /// The most members of a family.
    pub members: usize,
    /// Branches too.
    pub branches: bool,
    /// Which orbits.
    pub wanted: Wanted,
}

/// The families of some equilibria with the orbits that are wanted; `number` is that of the only family wanted of each.
#[must_use]
pub fn families_listed(
    body: &Body,
    found: &[(Equilibrium, Vec<Family>)],
    number: Option<usize>,
    wanted: &Wanted,
) -> Vec<ListedFamilyDocument> {
    let mut listed = Vec::new();
    for (equilibrium, families) in found {
        let curve = equilibrium.curve.map_or_else(|| "?".to_owned(), |curve| curve.to_string());
        for (place, family) in families.iter().enumerate().filter(|(place, _)| number.is_none_or(|n| n == place + 1)) {
            let branches = family.stretch.events.iter().flat_map(|event| &event.branches);
            for (branch, stretch) in std::iter::once(&family.stretch).chain(branches).enumerate() {
                listed.push(ListedFamilyDocument {
                    family: format!("{curve}/{}", place + 1),
                    branch,
                    gamma: equilibrium.gamma,
                    h: equilibrium.h,
                    l: equilibrium.l,
                    frequency: family.frequency,
                    followed: stretch.members.len(),
                    orbits: orbits(body, stretch, wanted),
                    end: end(stretch),
                });
            }
        }
    }
    listed
}

fn orbits(body: &Body, stretch: &Stretch, wanted: &Wanted) -> Vec<ListedOrbitDocument> {
    let members = stretch.members.iter().enumerate().filter(|(_, orbit)| wanted.holds(orbit));
    members.map(|(member, orbit)| ListedOrbitDocument { member, orbit: periodic_orbit(body, orbit) }).collect()
}

/// The list of these families; of one that is not made yet, what is known before.
#[must_use]
pub fn periodic_list(
    subject: &Subject,
    command: CommandLine,
    asked: &Asked<'_>,
    families: Vec<ListedFamilyDocument>,
) -> PeriodicListDocument {
    let texts = |held| (asked.held == held).then(|| asked.values.iter().map(|value| value.text().to_owned()).collect());
    let (complete, why) = completeness(&families);
    PeriodicListDocument {
        head: head(command.json()),
        body: given(&subject.body),
        fixed_l: texts(Held::Momentum),
        fixed_h: texts(Held::Energy),
        only: asked.only.map(ToOwned::to_owned),
        members: asked.members,
        branches: asked.branches,
        stable: asked.wanted.stable,
        period: asked.wanted.period,
        crossings: asked.wanted.crossings,
        families,
        complete,
        why,
        part: subject.part.clone(),
    }
}

fn completeness(families: &[ListedFamilyDocument]) -> (bool, String) {
    let ending = |kind| families.iter().filter(|family| family.end.kind == kind).count();
    let says = |kind, one: &str, several: &str| {
        let count = ending(kind);
        (count > 0).then(|| counted(count, one, several))
    };
    let left = [
        says(FamilyEnd::Members, "family goes on", "families go on"),
        says(FamilyEnd::Lost, "family was followed no further", "families were followed no further"),
        says(FamilyEnd::Resonant, "pair is resonant: no family was begun", "pairs are resonant: no family was begun"),
        says(
            FamilyEnd::NotIsolated,
            "pair is of an equilibrium that is not isolated: no family was begun",
            "pairs are of equilibria that are not isolated: no family was begun",
        ),
    ];
    let left: Vec<String> = left.into_iter().flatten().collect();
    let first = if left.is_empty() { "every family was followed to its end".to_owned() } else { left.join("; ") };
    let note = "families that meet no equilibrium are not in the list; its orbits are computed in doubles, not proved, and \
                `bifdiag verify` does not check them";
    (left.is_empty(), format!("{first}; {note}"))
}
