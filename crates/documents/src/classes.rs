//! The graph of classes as a document, and the one that comes with the program.

use std::collections::BTreeMap;

use bifdiag_body::{Body, BodyError};
use bifdiag_diagram::class::ClassName;
use bifdiag_exact::Accuracy;
use bifdiag_schema::{
    ClassBorderDocument, ClassDocument, ClassNeighbourDocument, ClassWitnessDocument, ClassesDocument, SCHEMA_VERSION,
    StandingDocument,
};
use bifdiag_survey::border::class_of;
use bifdiag_survey::graph::{ClassGraph, Domain, Nearest, Node};

use crate::body::given;
use crate::command::{CommandLine, head};

/// `data/classes.json` of the repository without the texts, which are most of it; a test keeps the two the same.
const SHIPPED: &str = include_str!("../data/classes.json");

/// The classes that come with the program, without their texts: those of generic bodies that exist, and others apart.
///
/// # Panics
/// Never: the file is a part of this package.
#[must_use]
pub fn shipped_classes() -> ClassesDocument {
    serde_json::from_str(SHIPPED).expect("the shipped classes are whole")
}

/// Gives a class its text: that of its witness.
///
/// # Panics
/// Never: the witness of a shipped class has a class.
pub fn add_text(class: &mut ClassDocument) {
    let body =
        Body::parse(&class.witness.body.moments, &class.witness.body.center).expect("the shipped classes are whole");
    let (_, found) = class_of(&body, Accuracy::Exact).expect("the witness of a shipped class has a class");
    found.text().clone_into(&mut class.text);
}

/// How often classes were met among bodies drawn at random: by bodies that exist, and among all A > 0.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ClassCounts {
    /// Bodies of each class that exist, of so many.
    pub existing: (BTreeMap<ClassName, u64>, u64),
    /// Bodies of each class, of so many.
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
        witness: ClassWitnessDocument { body: given(body) },
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
        let physical = edge.place.is_in(Domain::Existing);
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

/// Where a body stands among the classes.
#[must_use]
pub fn standing(name: Option<&ClassName>, borders: &[Nearest], command: CommandLine) -> StandingDocument {
    let known = |name: &ClassName| {
        let ClassesDocument { classes, others, .. } = shipped_classes();
        classes.iter().chain(&others).any(|class| class.name == name.as_str())
    };
    let border = |border: &Nearest| ClassBorderDocument {
        class: border.class.name().to_string(),
        event: border.event.to_string(),
        distance: border.distance,
        moments: border.place.a,
        center: border.place.r,
    };
    StandingDocument {
        head: head(command.json()),
        name: name.map(ToString::to_string),
        known: name.is_some_and(known),
        borders: borders.iter().map(border).collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    #[test]
    fn the_published_file_is_the_shipped_one() {
        let published = concat!(env!("CARGO_MANIFEST_DIR"), "/../../data/classes.json");
        // A packaged crate stands alone.
        if let Ok(text) = std::fs::read_to_string(published) {
            let mut published: ClassesDocument = serde_json::from_str(&text).unwrap();
            for class in &mut published.classes {
                assert!(class.text.starts_with("map 1\n"), "{}", class.name);
                class.text.clear();
            }
            assert!(published == shipped_classes(), "write both anew: data/classes.sh");
        }
    }

    #[test]
    fn neighbours_are_symmetric_classes_of_the_file() {
        let ClassesDocument { classes, others, .. } = shipped_classes();
        assert!([&classes, &others].iter().all(|list| list.windows(2).all(|pair| pair[0].name < pair[1].name)));
        assert!(others.iter().all(|other| classes.iter().all(|class| class.name != other.name)));
        assert!(others.iter().all(|other| other.stratum.is_some() || !other.physical));
        let arrows: BTreeSet<[&str; 3]> = classes
            .iter()
            .flat_map(|class| {
                class.neighbours.iter().map(|n| [class.name.as_str(), n.class.as_str(), n.event.as_str()])
            })
            .collect();
        assert!(!arrows.is_empty());
        for [from, to, event] in &arrows {
            assert!(arrows.contains(&[*to, *from, *event]), "{from} {to} {event}");
        }
    }
}
