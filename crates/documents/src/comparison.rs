//! Two bodies compared, as a document.

use bifdiag_diagram::class::Class;
use bifdiag_schema::{
    AtlasDocument, CommandLine, ComparedBodyDocument, ComparedEventDocument, ComparedRegionsDocument,
    ComparedStabilityDocument, ComparisonDocument, CrossedBorderDocument, CurveKind, EventKind, PathDocument,
};
use bifdiag_survey::border::Border;
use bifdiag_survey::path::Oriented;

use crate::body::{given, head};
use crate::border::event;

/// One of two bodies: its atlas as given and in standard axes, whose branches both bodies share.
pub struct Compared<'a> {
    /// The atlas of the body as given.
    pub atlas: &'a AtlasDocument,
    /// Its class, if that is decided.
    pub class: Option<&'a Class>,
    /// The body in standard axes.
    pub standard: &'a Oriented,
    /// The atlas of that.
    pub standard_atlas: &'a AtlasDocument,
}

impl Compared<'_> {
    /// As an argument of the command.
    fn name(&self) -> String {
        let given = &self.atlas.body.given;
        format!("A={};r={}", given.moments.join(","), given.center.join(","))
    }
}

/// What one of two bodies has and the other lacks, and the borders between them.
#[must_use]
pub fn comparison(bodies: [Compared<'_>; 2], borders: &[Border]) -> ComparisonDocument {
    let command = bodies.iter().fold(CommandLine::new("compare"), |line, body| line.argument(body.name()));
    let classes = bodies.each_ref().map(|body| body.class);
    let same_class = match classes {
        [Some(first), Some(second)] => Some(first == second),
        _ => None,
    };
    let last = borders.last().map(|border| &border.classes[1]);
    ComparisonDocument {
        head: head(command.json()),
        same_class,
        regions: regions(&bodies),
        events: events(&bodies),
        stability_changes: stability_changes(&bodies),
        path: PathDocument {
            ends: bodies.each_ref().map(|body| given(&body.standard.body)),
            turned: bodies.each_ref().map(|body| body.standard.is_turned),
            borders: borders.iter().map(crossed).collect(),
            complete: same_class == Some(true) || last.is_some_and(|last| Some(last) == classes[1]),
        },
        bodies: bodies.map(|body| ComparedBodyDocument {
            name: body.name(),
            body: body.atlas.body.given.clone(),
            class: body.class.map(|class| class.name().to_string()),
            regions: body.atlas.summary.regions,
            events: body.atlas.summary.events,
            critical_points_max: body.atlas.summary.critical_points_max,
        }),
    }
}

fn crossed(border: &Border) -> CrossedBorderDocument {
    CrossedBorderDocument {
        at: border.t,
        error: border.error,
        event: event(&border.event),
        classes: border.classes.each_ref().map(|class| class.name().to_string()),
    }
}

fn regions(bodies: &[Compared<'_>; 2]) -> Vec<ComparedRegionsDocument> {
    let mut kinds: Vec<ComparedRegionsDocument> = Vec::new();
    for (which, body) in bodies.iter().enumerate() {
        for region in &body.atlas.regions {
            let known = kinds.iter().position(|kind| kind.components == region.components);
            let kind = known.unwrap_or_else(|| {
                kinds.push(ComparedRegionsDocument {
                    components: region.components.clone(),
                    signature: region.signature.clone(),
                    regions: Default::default(),
                });
                kinds.len() - 1
            });
            kinds[kind].regions[which].push(region.id.clone());
        }
    }
    kinds
}

/// The branch of a curve in words that are comparable between strata: branches are numbered by the moments between
/// which they lie, and there are fewer of these where moments are equal or components of r are 0.
fn branch(atlas: &AtlasDocument, id: &str) -> String {
    let Some(curve) = atlas.curves.iter().find(|curve| curve.id == id) else { return id.to_owned() };
    match &curve.branch_name {
        // Next to equal moments the branch extends to the nearest of the others.
        name if curve.kind == CurveKind::Generic && name.starts_with("between ") => {
            let axes = |words: &str| -> Vec<String> {
                words.split(' ').filter(|word| word.parse::<u8>().is_ok()).map(str::to_owned).collect()
            };
            let (below, above) = name.rsplit_once(" and ax").unwrap_or((name, ""));
            match (axes(below).last(), axes(above).first()) {
                (Some(below), Some(above)) => format!("between axes {below} and {above}"),
                _ => name.clone(),
            }
        }
        name => name.clone(),
    }
}

fn events(bodies: &[Compared<'_>; 2]) -> Vec<ComparedEventDocument> {
    let mut kinds: Vec<ComparedEventDocument> = Vec::new();
    for (which, body) in bodies.iter().enumerate() {
        for event in &body.standard_atlas.events {
            let mut branches: Vec<String> = event.curves.iter().map(|id| branch(body.standard_atlas, id)).collect();
            branches.sort_unstable();
            if event.kind != EventKind::Crossing {
                branches.dedup();
            }
            match kinds.iter_mut().find(|kind| kind.kind == event.kind && kind.branches == branches) {
                Some(kind) => kind.counts[which] += 1,
                None => kinds.push(ComparedEventDocument {
                    kind: event.kind,
                    branches,
                    counts: std::array::from_fn(|of| usize::from(of == which)),
                }),
            }
        }
    }
    kinds
}

fn stability_changes(bodies: &[Compared<'_>; 2]) -> Vec<ComparedStabilityDocument> {
    let mut kinds: Vec<ComparedStabilityDocument> = Vec::new();
    for (which, body) in bodies.iter().enumerate() {
        for change in &body.standard_atlas.stability_changes {
            let found = ComparedStabilityDocument {
                kind: change.kind,
                branch: branch(body.standard_atlas, &change.curve),
                from: change.from,
                to: change.to,
                counts: std::array::from_fn(|of| usize::from(of == which)),
            };
            let same = |kind: &&mut ComparedStabilityDocument| {
                (kind.kind, &kind.branch, kind.from, kind.to) == (found.kind, &found.branch, found.from, found.to)
            };
            match kinds.iter_mut().find(same) {
                Some(kind) => kind.counts[which] += 1,
                None => kinds.push(found),
            }
        }
    }
    kinds
}
