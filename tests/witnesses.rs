//! Every witness in `data/witnesses.json` shows what it says, by both topological methods, and with room.

use documents::{candidate, margin};
use schema::WitnessDocument;
use survey::search::Target;
use top::body::{Body, Number};
use top::classify::classify;
use top::topology::{Component, Poles, latitude};

fn witnesses() -> Vec<WitnessDocument> {
    serde_json::from_str(&support::data("witnesses.json")).unwrap()
}

fn component(document: &schema::ComponentDocument) -> Component {
    let signs = document.poles.as_ref().unwrap();
    let has = |sign: &str| signs.iter().any(|pole| pole == sign);
    Component { boundary_circles: document.boundary_circles, poles: Some(Poles { plus: has("+"), minus: has("-") }) }
}

#[test]
fn both_methods_confirm_every_witness() {
    for witness in witnesses() {
        let target = Target::of_type(&witness.kind).or_else(|_| Target::of_signature(&witness.kind)).unwrap();
        let components: Vec<Component> = witness.components.iter().map(component).collect();
        assert!(target.accepts_region(&components), "{}", witness.kind);
        let body = Body::parse(&witness.moments, &witness.center).unwrap();
        let [h, l] = [&witness.h, &witness.l].map(|text| text.parse::<Number>().unwrap());
        let answer = classify(&body, &h, &l).unwrap();
        // As documents, so that every name in the file is compared too.
        assert_eq!(answer.components().map(candidate).as_ref(), Some(&witness.components), "{}", witness.kind);
        assert_eq!(margin(&answer.margin), witness.margin, "{}", witness.kind);
        let frame = body.frame();
        let (h, l) = (h.to_f64() / frame.energy_unit, l.to_f64() / frame.momentum_unit);
        assert_eq!(latitude::components(&frame, h, l).unwrap(), components, "{}", witness.kind);
        // Well visible: by far not a matter of rounding.
        let r = body.center_f64().iter().map(|c| c * c).sum::<f64>().sqrt();
        assert!(witness.margin.h > 3e-4 * r, "{}: {:?}", witness.kind, witness.margin);
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
