//! The catalogue: a page for each class of bodies that exist, and an index with the graph drawn.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;
use std::path::Path;

use bifdiag_body::Body;
use bifdiag_exact::Accuracy;
use bifdiag_schema::{ClassDocument, ClassesDocument};
use bifdiag_survey::ComponentType;

use crate::Failure;
use crate::map::map;
use crate::sketch::sketch;

/// Writes the pages to a folder.
pub fn pages(classes: &str, folder: &Path) -> Result<(), Failure> {
    let mut document: ClassesDocument = serde_json::from_str(&std::fs::read_to_string(classes)?)?;
    document.classes.retain(|class| class.physical);
    let names: BTreeSet<String> = document.classes.iter().map(|class| class.name.clone()).collect();
    for class in &mut document.classes {
        class.neighbours.retain(|neighbour| neighbour.physical && names.contains(&neighbour.class));
    }
    std::fs::create_dir_all(folder)?;
    for class in &document.classes {
        let body = Body::parse(&class.witness.body.moments, &class.witness.body.center)?;
        let atlas = bifdiag_exact::atlas(&body, Accuracy::Exact)?;
        std::fs::write(folder.join(format!("{}.svg", class.name)), sketch(&atlas)?)?;
        let mut page = head(class);
        page.push_str("| region | sections | components |\n| --- | --- | --- |\n");
        for (region, known) in atlas.regions().pairs() {
            let components = known.components.as_ref().map_err(ToString::to_string)?;
            let signature = bifdiag_diagram::topology::signature(components).unwrap_or_default();
            let types: Vec<String> = components.iter().map(|c| ComponentType::of(c).to_string()).collect();
            writeln!(page, "| {region} | {signature} | {} |", types.join(", "))?;
        }
        page.push_str("\n## Beside it\n\n| class | what happens on the border |\n| --- | --- |\n");
        for neighbour in &class.neighbours {
            writeln!(page, "| [{0}]({0}.md) | {1} |", neighbour.class, neighbour.event)?;
        }
        std::fs::write(folder.join(format!("{}.md", class.name)), page)?;
    }
    std::fs::write(folder.join("graph.svg"), map(&document.classes)?)?;
    Ok(std::fs::write(folder.join("README.md"), index(&document.classes)?)?)
}

/// A share in percent, or what it is less than.
fn share(class: &ClassDocument) -> String {
    if class.measure == 0.0 {
        return format!("below {:.0e}", class.measure_error);
    }
    format!("{:.3e} ± {:.0e}", class.measure, class.measure_error)
}

fn head(class: &ClassDocument) -> String {
    let ClassDocument { name, regions, types, witness, distance, .. } = class;
    let (moments, center) = (witness.body.moments.join(","), witness.body.center.join(","));
    format!(
        "# Class {name}\n\n![the diagram, events and curves at even steps]({name}.svg)\n\n\
         {regions} regions; types of components {}; share of the bodies that exist {}. A body of it, {distance:.2e} from all \
         other classes that are known (the picture in true size by the same command):\n\n    \
         bifdiag --A {moments} --r {center}\n\n",
        types.join(", "),
        share(class)
    )
}

/// The page of all classes.
fn index(classes: &[ClassDocument]) -> Result<String, Failure> {
    let mut page = String::from(
        "# The classes of bodies that exist\n\nMade by `cargo run --release --example classes -- pages`; \
         what a class is, and how they were found, is described in `docs/survey.md`.\n\n\
         ![the graph of classes](graph.svg)\n\n\
         A dot is a class, to the right with its number of regions, its area with the logarithm of its share; a line is a border \
         between two, its colour what happens there.\n\n\
         | class | regions | share | distance | beside it | types |\n| --- | ---: | ---: | ---: | ---: | --- |\n",
    );
    let mut order: Vec<&ClassDocument> = classes.iter().collect();
    order.sort_by(|p, q| q.measure.total_cmp(&p.measure).then_with(|| q.distance.total_cmp(&p.distance)));
    for class in order {
        let beside: BTreeSet<&str> = class.neighbours.iter().map(|neighbour| neighbour.class.as_str()).collect();
        writeln!(
            page,
            "| [{0}]({0}.md) | {1} | {2} | {3:.1e} | {4} | {5} |",
            class.name,
            class.regions,
            share(class),
            class.distance,
            beside.len(),
            class.types.join(" ")
        )?;
    }
    let mut events: BTreeMap<&str, usize> = BTreeMap::new();
    for class in classes {
        for neighbour in class.neighbours.iter().filter(|neighbour| neighbour.class > class.name) {
            *events.entry(&neighbour.event).or_default() += 1;
        }
    }
    page.push_str("\n## What happens on the borders\n\n| event | borders |\n| --- | ---: |\n");
    let mut events: Vec<_> = events.into_iter().collect();
    events.sort_by(|p, q| q.1.cmp(&p.1).then_with(|| p.0.cmp(q.0)));
    for (event, count) in events {
        writeln!(page, "| {event} | {count} |")?;
    }
    Ok(page)
}
