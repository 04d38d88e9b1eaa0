//! The classes beside those of generic bodies that exist: of special bodies, and those met only where no body exists.

use std::collections::BTreeMap;
use std::path::Path;

use bifdiag_body::{Body, Preset};
use bifdiag_diagram::class::ClassName;
use bifdiag_schema::ClassDocument;
use bifdiag_survey::space::ReducedBody;
use support::special::SpecialStratum;

use crate::Failure;
use crate::document::{ClassCounts, other_class};
use crate::graph::Node;
use crate::special::StratumState;
use crate::state::State;

/// From the states of the walks among all A > 0 and among special bodies, without those that are `known`; by name.
pub fn others(
    all: &str,
    special: &str,
    known: &[ClassDocument],
    counts: &ClassCounts,
) -> Result<Vec<ClassDocument>, Failure> {
    let mut found = BTreeMap::new();
    for walked in serde_json::from_str::<Vec<StratumState>>(&std::fs::read_to_string(special)?)? {
        let StratumState { stratum, bodies, met, walked, .. } = walked;
        for (name, node) in State::of(walked)?.graph.nodes {
            let met = met.get(name.as_str()).ok_or_else(|| format!("{stratum}: {name} was not counted"))?;
            let count = met.bodies[usize::from(!node.physical)];
            let preset = met.preset.as_ref().and_then(|preset| Preset::find(preset)).map(Preset::body);
            let body = match preset.filter(|body| node.physical != body.flags().unphysical) {
                Some(body) => body,
                None => plain(&node)?,
            };
            found.insert(name, other_class(&node, &body, Some(&stratum), [u64::from(count), bodies as u64]));
        }
    }
    let mut all = State::read(Path::new(all))?.graph;
    for (([one, other], _), edge) in &all.edges {
        for name in [one, other] {
            if !all.nodes.contains_key(name) {
                let node = beside(&edge.place, name).ok_or_else(|| format!("{name} has no body beside its border"))?;
                all.nodes.insert(name.clone(), node);
            }
        }
    }
    for (name, node) in all.nodes {
        if !known.iter().any(|class| class.name == name.as_str()) {
            let (bodies, of) = (counts.all.0.get(&name).copied().unwrap_or_default(), counts.all.1);
            found.insert(name, other_class(&node, &plain(&node)?, None, [bodies, of]));
        }
    }
    Ok(found.into_values().collect())
}

/// A body of a class of which walks have met a border alone: the first of those around it.
fn beside(border: &ReducedBody, name: &ClassName) -> Option<Node> {
    let steps = [1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10];
    steps.into_iter().flat_map(|step| (0..64).map(move |signs| (step, signs))).find_map(|(step, signs): (f64, u32)| {
        let moved = |x: f64, k: usize| if signs >> k & 1 == 0 { x * (1.0 + step) } else { x * (1.0 - step) };
        let [a, r] = border.values();
        let values = [[0, 1, 2].map(|k| moved(a[k], k)), [0, 1, 2].map(|k| moved(r[k], 3 + k))];
        Node::of(values).filter(|node| node.class.name() == name)
    })
}

/// The witness with as few digits as leave it in its class and stratum; never a plate, which a rounded body could become.
fn plain(node: &Node) -> Result<Body, Failure> {
    let stratum = SpecialStratum::of(&ReducedBody::of(node.witness));
    for digits in 2..16 {
        let values = node.witness.map(|part| part.map(|x| format!("{x:.digits$e}").parse().unwrap_or(x)));
        let body = Body::from_f64(values[0], values[1])?;
        let flags = body.flags();
        if !flags.plate
            && node.physical != flags.unphysical
            && SpecialStratum::of(&ReducedBody::of(values)) == stratum
            && Node::of(values).is_some_and(|found| found.class == node.class && found.physical == node.physical)
        {
            return Ok(body);
        }
    }
    Ok(Body::from_f64(node.witness[0], node.witness[1])?)
}
