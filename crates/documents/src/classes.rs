//! The built-in classes, and the position of a body among them.

use bifdiag_body::Body;
use bifdiag_diagram::class::ClassName;
use bifdiag_exact::Accuracy;
use bifdiag_schema::{
    ClassBesideDocument, ClassBorderDocument, ClassDocument, ClassesDocument, CommandLine, StandingDocument,
};
use bifdiag_survey::border::class_of;
use bifdiag_survey::nearest::NearestBorder;
use bifdiag_survey::strata::{SpecialStratum, classes_beside};

use crate::body::head;

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

/// The position of a body among the classes.
#[must_use]
pub fn standing(
    body: &Body,
    name: Option<&ClassName>,
    borders: &[NearestBorder],
    command: CommandLine,
) -> StandingDocument {
    let known = |name: &ClassName| {
        let ClassesDocument { classes, others, .. } = shipped_classes();
        classes.iter().chain(&others).any(|class| class.name == name.as_str())
    };
    let border = |border: &NearestBorder| ClassBorderDocument {
        class: border.class.name().to_string(),
        event: border.event.to_string(),
        distance: border.distance,
        moments: border.body.a,
        center: border.body.r,
    };
    let stratum = SpecialStratum::of_body(body);
    let beside = stratum.map_or_else(Vec::new, |_special| classes_beside(body));
    let all = beside.iter().map(|(_, count)| *count).sum::<usize>() as f64;
    let generic = beside
        .into_iter()
        .map(|(class, count)| ClassBesideDocument { class: class.to_string(), share: count as f64 / all });
    let generic = generic.collect();
    StandingDocument {
        head: head(command.json()),
        name: name.map(ToString::to_string),
        known: name.is_some_and(known),
        stratum: stratum.map(|stratum| stratum.name.to_owned()),
        generic,
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
        // A packaged crate has no repository around it.
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
