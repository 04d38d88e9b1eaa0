//! Every class in `data/classes.json` is what it says: a sample in each run, all of them in a campaign
//! (`cargo test --release --test classes -- --ignored`).

use std::collections::BTreeSet;

use bifdiag_body::Body;
use bifdiag_diagram::atlas::Atlas;
use bifdiag_exact::{Accuracy, CertifiedAtlas};
use bifdiag_schema::{ClassDocument, ClassesDocument};
use bifdiag_survey::border::class_of;
use bifdiag_survey::space::{BodySet, ReducedBody};
use bifdiag_survey::{ComponentType, scan};
use support::special::SpecialStratum;

fn classes() -> Vec<ClassDocument> {
    serde_json::from_str::<ClassesDocument>(&support::data("classes.json")).unwrap().classes
}

fn body(class: &ClassDocument) -> Body {
    Body::parse(&class.witness.body.moments, &class.witness.body.center).unwrap()
}

fn types(atlas: &Atlas) -> Vec<String> {
    let known = atlas.regions().iter().filter_map(|region| region.components.as_ref().ok());
    known.flatten().map(ComponentType::of).collect::<BTreeSet<_>>().iter().map(ToString::to_string).collect()
}

/// The class of the witness, exactly, and all that is said of it.
fn check(class: &ClassDocument) {
    let body = body(class);
    let (atlas, found) = class_of(&body, Accuracy::Exact).unwrap();
    assert_eq!(found.name().as_str(), class.name);
    assert_eq!(atlas.regions().len(), class.regions, "{}", class.name);
    assert_eq!(types(&atlas), class.types, "{}", class.name);
    assert_eq!(ReducedBody::of_body(&body).is_in(BodySet::Physical), class.physical, "{}", class.name);
}

/// A class of generic bodies: with its text, and a witness at a distance from all borders.
fn check_generic(class: &ClassDocument) {
    check(class);
    let body = body(class);
    assert_eq!(class_of(&body, Accuracy::Exact).unwrap().1.text(), class.text, "{}", class.name);
    assert!(!body.flags().degenerate() && class.distance > 0.0, "{}", class.name);
}

/// The arrangement and the topology of the witness are proved, and the verifier confirms its document.
fn prove(class: &ClassDocument) {
    let proof = CertifiedAtlas::new(&body(class)).unwrap_or_else(|error| panic!("{}: {error}", class.name));
    assert_eq!(proof.region_count(), class.regions, "{}", class.name);
    let mut types: Vec<ComponentType> = Vec::new();
    for region in proof.region_ids() {
        let components = proof.components(region).unwrap_or_else(|| panic!("{}: {region}", class.name));
        types.extend(components.iter().map(ComponentType::of));
    }
    types.sort();
    types.dedup();
    assert_eq!(types.iter().map(ComponentType::to_string).collect::<Vec<_>>(), class.types, "{}", class.name);
    let drawn = proof.to_atlas().unwrap();
    let document =
        bifdiag_documents::certified_atlas(&proof, &drawn, &bifdiag_documents::DocumentOptions::default()).unwrap();
    bifdiag_verify::verify(&document)
        .unwrap_or_else(|refused| panic!("{} at {:.1e}: {refused}", class.name, class.distance));
}

#[test]
fn every_witness_has_its_class() {
    for class in classes().iter().step_by(5) {
        check_generic(class);
    }
}

/// The classes that are listed apart: those of special bodies, and those that are known only of bodies that do not exist.
#[test]
fn every_other_class_is_that_of_its_witness_in_its_stratum() {
    let others = serde_json::from_str::<ClassesDocument>(&support::data("classes.json")).unwrap().others;
    assert!(others.len() > 600, "{}", others.len());
    for class in &others {
        check(class);
        let body = body(class);
        assert_ne!(body.flags().unphysical, class.physical, "{}", class.name);
        let stratum = SpecialStratum::of(&ReducedBody::of_body(&body)).map(|stratum| stratum.name);
        assert_eq!(stratum, class.stratum.as_deref(), "{}", class.name);
        assert!(stratum.is_some() || !class.physical, "{}", class.name);
    }
}

#[test]
fn some_witnesses_are_proved_and_verified() {
    classes().iter().step_by(29).for_each(prove);
}

#[test]
#[ignore = "a campaign of minutes"]
fn all_witnesses_are_what_they_say_and_are_proved_and_verified() {
    let classes = classes();
    classes.iter().for_each(check_generic);
    classes.iter().for_each(prove);
}

/// The classes that a million random bodies have shown are among them, with their shares.
/// No two curves of a body touch (Theorem 4.12), so that no border can be explained by it.
#[test]
fn no_border_is_said_to_be_a_tangency() {
    for class in classes() {
        for beside in &class.neighbours {
            assert!(!beside.event.contains("touch"), "{} and {}: {}", class.name, beside.class, beside.event);
        }
    }
    for file in ["survey/graph.json", "survey/special.json"] {
        assert!(!support::data(file).contains(" touch\""), "{file}");
    }
}

#[test]
fn the_classes_of_the_survey_are_there() {
    let survey: serde_json::Value = serde_json::from_str(&support::data("survey/general.summary.json")).unwrap();
    let known = classes();
    let met = survey["classes"].as_array().unwrap();
    assert_eq!(met.len(), 43);
    for seen in met {
        let class = known.iter().find(|class| class.name == seen["class"].as_str().unwrap()).unwrap();
        assert!(class.physical, "{}", class.name);
        assert_eq!(class.measure, seen["bodies"].as_f64().unwrap() / survey["classified"].as_f64().unwrap());
    }
}

/// The bodies that have names of their own are special, but for those that are not.
#[test]
fn generic_presets_have_a_known_class() {
    let names: Vec<String> = classes().into_iter().map(|class| class.name).collect();
    for (name, preset) in scan::known_classes() {
        let generic = !preset.body().flags().degenerate();
        assert!(!generic || names.contains(&name.to_string()), "{}", preset.name());
        assert!(bifdiag_exact::atlas(&preset.body(), Accuracy::Exact).is_ok());
    }
}
