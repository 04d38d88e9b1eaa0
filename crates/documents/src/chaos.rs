//! The chaotic share of energy surfaces as documents.

use bifdiag_chaos::{CellShare, Cells, PointShares, Share, ShareOptions};
use bifdiag_diagram::topology::Component;
use bifdiag_numbers::Number;
use bifdiag_schema::{
    ChaosCellDocument, ChaosMapDocument, ChaosPointDocument, ChaosShareDocument, CommandLine, WindowDocument,
};

use crate::body::{given, head};
use crate::subject::Subject;

/// The shares of the components at one point, in their order.
#[must_use]
pub fn chaos_point(
    subject: &Subject,
    [h, l]: [&Number; 2],
    found: &PointShares,
    options: &ShareOptions,
) -> ChaosPointDocument {
    let command = subject.command("chaos").option("h", h.text()).option("l", l.text());
    let command = with_options(command, options);
    ChaosPointDocument {
        head: head(command.json()),
        body: given(&subject.body),
        h: h.text().to_owned(),
        l: l.text().to_owned(),
        region: found.region.map(|region| region.to_string()),
        steps: options.orbits.steps as u64,
        components: found.components.iter().zip(&found.shares).map(|(one, share)| chaos_share(one, *share)).collect(),
        part: subject.part.clone(),
    }
}

fn chaos_share(component: &Component, share: Share) -> ChaosShareDocument {
    ChaosShareDocument {
        accessible_region: component.accessible_region(),
        energy_surface: component.energy_surface(),
        fraction: share.fraction(),
        error: share.error(),
        open: share.open_share(),
        orbits: share.orbits,
        crossings: share.crossings,
    }
}

/// The map of a window without its rows; `tiles` are those of it.
#[must_use]
pub fn chaos_map(subject: &Subject, cells: &Cells, tiles: [u64; 2], options: &ShareOptions) -> ChaosMapDocument {
    let range = |[from, to]: [f64; 2]| format!("{from:?}:{to:?}");
    let [n, m] = cells.counts;
    let command = subject.command("chaos").option("window", format!("{},{}", range(cells.h), range(cells.l)));
    let command = with_options(command.option("cells", format!("{n}x{m}")), options);
    ChaosMapDocument {
        head: head(command.text()),
        body: given(&subject.body),
        window: WindowDocument { h: cells.h, l: cells.l },
        cells: cells.counts,
        error: options.error,
        steps: options.orbits.steps as u64,
        seed: options.seed,
        tiles,
        rows: Vec::new(),
        part: subject.part.clone(),
    }
}

/// A row of a map.
#[must_use]
pub fn chaos_cell(row: &CellShare) -> ChaosCellDocument {
    let known = row.share.orbits > 0;
    ChaosCellDocument {
        cell: row.cell,
        h: row.h,
        l: row.l,
        region: row.region.to_string(),
        component: u32::try_from(row.component).unwrap_or(u32::MAX),
        part: row.part,
        block: u32::try_from(row.block).unwrap_or(u32::MAX),
        fraction: known.then(|| row.share.fraction()),
        error: known.then_some(row.error),
        open: if known { row.share.open_share() } else { 1.0 },
        orbits: row.share.orbits,
        crossings: row.share.crossings,
    }
}

/// A command with the options that are not as usual.
fn with_options(mut command: CommandLine, options: &ShareOptions) -> CommandLine {
    let usual = ShareOptions::default();
    if options.error.to_bits() != usual.error.to_bits() {
        command = command.option("error", format!("{:?}", options.error));
    }
    if options.orbits.steps != usual.orbits.steps {
        command = command.option("steps", options.orbits.steps.to_string());
    }
    if options.seed != usual.seed {
        command = command.option("seed", options.seed.to_string());
    }
    command
}
