//! Every witness in `data/witnesses.json` shows what it says, by both topological methods, and with room.

use bifdiag_body::{Body, Number};
use bifdiag_diagram::fast::classify;
use bifdiag_diagram::topology::{Component, Poles, latitude};
use bifdiag_documents::margin;
use bifdiag_equilibria::critical::critical;
use bifdiag_exact::{Accuracy, classify_exactly};
use bifdiag_schema::WitnessDocument;
use bifdiag_survey::search::{Target, Witness, WitnessError};

fn witnesses() -> Vec<WitnessDocument> {
    serde_json::from_str(&support::data("witnesses.json")).unwrap()
}

fn body(witness: &WitnessDocument) -> Body {
    Body::parse(&witness.body.moments, &witness.body.center).unwrap()
}

fn component(document: &bifdiag_schema::ComponentDocument) -> Component {
    let signs = document.poles.as_ref().unwrap();
    let has = |sign: &str| signs.iter().any(|pole| pole == sign);
    Component { boundary_circles: document.boundary_circles, poles: Some(Poles { plus: has("+"), minus: has("-") }) }
}

/// Four boundary circles of a body that exists: the widest room in h that is known is 1.25e-4 |r|.
fn is_narrow(witness: &WitnessDocument, body: &Body) -> bool {
    witness.components.iter().any(|component| component.boundary_circles == 4) && !body.flags().unphysical
}

#[test]
fn both_methods_confirm_every_witness() {
    for witness in witnesses() {
        let target = Target::of_type(&witness.kind).or_else(|_| Target::of_signature(&witness.kind)).unwrap();
        let components: Vec<Component> = witness.components.iter().map(component).collect();
        assert!(target.accepts_region(&components), "{}", witness.kind);
        let body = body(&witness);
        let [energy, momentum] = [&witness.h, &witness.l].map(|text| text.parse::<Number>().unwrap());
        let answer = classify(&body, &energy, &momentum).unwrap();
        // As documents, so that every name in the file is compared too.
        assert_eq!(
            answer.components().map(bifdiag_documents::components).as_ref(),
            Some(&witness.components),
            "{}",
            witness.kind
        );
        assert_eq!(margin(&answer.margin), witness.margin, "{}", witness.kind);
        let frame = body.frame();
        let (h, l) = (energy.to_f64() / frame.energy_unit, momentum.to_f64() / frame.momentum_unit);
        assert_eq!(latitude::components(&frame, h, l).unwrap(), components, "{}", witness.kind);
        let r = body.center_f64().iter().map(|c| c * c).sum::<f64>().sqrt();
        if is_narrow(&witness, &body) {
            // Proved instead; its room is millions of times its error.
            assert!(witness.margin.h > 1e6 * witness.margin.error_bound, "{}: {:?}", witness.kind, witness.margin);
            let proved = classify_exactly(&body, &energy, &momentum).unwrap();
            assert_eq!(
                proved.components().map(bifdiag_documents::components).as_ref(),
                Some(&witness.components),
                "{}",
                witness.kind
            );
        } else {
            // Well visible: by far not a matter of rounding.
            assert!(witness.margin.h > 3e-4 * r, "{}: {:?}", witness.kind, witness.margin);
        }
    }
}

#[test]
fn bodies_that_exist_show_four_boundary_circles() {
    for kind in ["k4n1", "k4n2"] {
        let shows = |witness: &WitnessDocument| witness.kind == kind && !body(witness).flags().unphysical;
        assert!(witnesses().iter().any(shows), "{kind}");
    }
}

#[test]
fn all_of_table_1_but_the_tenth_entry_is_there() {
    let kinds: Vec<String> = witnesses().into_iter().map(|witness| witness.kind).collect();
    for kind in ["k1n0", "k2n0", "k1n1", "k2n1", "k3n1", "k0n2", "k1n2", "k2n2", "k3n2"] {
        assert!(kinds.iter().any(|known| known == kind), "{kind}");
    }
    assert!(kinds.iter().any(|kind| kind.contains('+')));
}

/// A circle of relative equilibria is not one of the isolated ones that are counted.
#[test]
fn circles_of_equilibria_are_not_counted() {
    let top = Body::from_f64([2.0, 2.0, 1.0], [0.0, 0.0, 1.0]).unwrap();
    let point = || ["2", "3"].map(|text| text.parse::<Number>().unwrap());
    let equilibria = critical(&top, &point()[1]).unwrap().list;
    assert_eq!(equilibria.len(), 3, "hanging, upright, and the circle");
    let confirm = |count| Witness::confirm(top.clone(), point(), &Target::CriticalPoints(count), Accuracy::Exact);
    assert_eq!(confirm(2).unwrap().critical_points, Some(2));
    assert_eq!(confirm(3).unwrap_err(), WitnessError::NotShown);
}
