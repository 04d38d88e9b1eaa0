//! The chaotic share of energy surfaces as documents.

use bifdiag_chaos::{Share, ShareOptions};
use bifdiag_diagram::arrangement::RegionId;
use bifdiag_diagram::topology::Component;
use bifdiag_numbers::Number;
use bifdiag_schema::{ChaosPointDocument, ChaosShareDocument, CommandLine};

use crate::body::{given, head};
use crate::subject::Subject;

/// The shares of the components at one point, in their order.
#[must_use]
pub fn chaos_point(
    subject: &Subject,
    [h, l]: [&Number; 2],
    region: Option<RegionId>,
    components: &[Component],
    shares: &[Share],
    options: &ShareOptions,
) -> ChaosPointDocument {
    let command = subject.command("chaos").option("h", h.text()).option("l", l.text());
    let command = with_options(command, options);
    ChaosPointDocument {
        head: head(command.json()),
        body: given(&subject.body),
        h: h.text().to_owned(),
        l: l.text().to_owned(),
        region: region.map(|region| region.to_string()),
        steps: options.orbits.steps as u64,
        components: components.iter().zip(shares).map(|(component, share)| chaos_share(component, *share)).collect(),
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
