//! The graph of classes as a document.

use std::collections::BTreeMap;

use bifdiag_body::{Body, BodyError};
use bifdiag_diagram::class::ClassName;
use bifdiag_schema::{ClassDocument, ClassNeighbourDocument, ClassWitnessDocument, ClassesDocument, SCHEMA_VERSION};
use bifdiag_survey::space::BodySet;

use crate::graph::{ClassGraph, Node};

/// How often classes were met among bodies drawn at random: by bodies that exist, and among all A > 0.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ClassCounts {
    /// Physical bodies of each class, and the number of all that were drawn.
    pub existing: (BTreeMap<ClassName, u64>, u64),
    /// Bodies of each class among all A > 0, and the number of all that were drawn.
    pub all: (BTreeMap<ClassName, u64>, u64),
}

/// The graph, with measures from counts.
///
/// # Errors
/// [`BodyError`] for a witness that is no body.
pub fn classes(graph: &ClassGraph, counts: &ClassCounts) -> Result<ClassesDocument, BodyError> {
    let classes = graph.nodes.iter().map(|(name, node)| class(name, node, graph, counts)).collect::<Result<_, _>>()?;
    Ok(ClassesDocument { schema_version: SCHEMA_VERSION.to_owned(), classes, others: Vec::new() })
}

/// A class that is not in the graph, with a body of it; `bodies` of `all` random ones (of its stratum) have it.
#[must_use]
pub fn other_class(node: &Node, body: &Body, stratum: Option<&str>, [bodies, all]: [u64; 2]) -> ClassDocument {
    let (bodies, all) = (bodies as f64, all.max(1) as f64);
    let measure = bodies / all;
    let sure = bodies == 0.0 || bodies == all;
    ClassDocument {
        name: node.class.name().to_string(),
        text: String::new(),
        stratum: stratum.map(str::to_owned),
        regions: node.regions,
        types: node.types.iter().map(ToString::to_string).collect(),
        physical: node.physical,
        witness: ClassWitnessDocument { body: bifdiag_documents::given(body) },
        distance: 0.0,
        measure,
        measure_error: if sure { 1.0 / all } else { (measure * (1.0 - measure) / all).sqrt() },
        neighbours: Vec::new(),
    }
}

fn class(name: &ClassName, node: &Node, graph: &ClassGraph, counts: &ClassCounts) -> Result<ClassDocument, BodyError> {
    let (bodies, all) = if node.physical { &counts.existing } else { &counts.all };
    let bodies = bodies.get(name).copied().unwrap_or_default();
    let beside = graph.edges.iter().filter_map(|((between, event), edge)| {
        let class = match between {
            [one, other] if one == name => other,
            [other, one] if one == name => other,
            _ => return None,
        };
        let physical = edge.place.is_in(BodySet::Physical);
        Some(ClassNeighbourDocument { class: class.to_string(), event: event.clone(), physical })
    });
    let mut neighbours: Vec<ClassNeighbourDocument> = beside.collect();
    neighbours.sort_by(|p, q| (&p.class, &p.event).cmp(&(&q.class, &q.event)));
    let body = Body::from_f64(node.witness[0], node.witness[1])?;
    Ok(ClassDocument {
        text: node.class.text().to_owned(),
        distance: node.distance,
        neighbours,
        ..other_class(node, &body, None, [bodies, *all])
    })
}
