//! Documents that are true, and what is said of them when they are changed.

use bifdiag_body::part::{MassProperties, Part};
use bifdiag_body::{Body, Number, Preset};
use bifdiag_documents::{DocumentOptions, Drawn, Subject, certified_atlas, certified_atlas_of, seal};
use bifdiag_exact::CertifiedAtlas;
use bifdiag_numbers::symmetric::Symmetric;
use bifdiag_schema::AtlasDocument;
use bifdiag_verify::{Refused, Report, verify};
use dashu_ratio::RBig;

pub fn preset(name: &str) -> Body {
    Preset::find(name).expect("a preset").body()
}

pub fn body([a, r]: [[&str; 3]; 2]) -> Body {
    Body::parse(&a, &r).unwrap()
}

pub fn document(body: &Body) -> AtlasDocument {
    certified(&CertifiedAtlas::new(body).unwrap())
}

pub fn certified(atlas: &CertifiedAtlas) -> AtlasDocument {
    let options = DocumentOptions { drawing: Drawn::Nothing, ..DocumentOptions::default() };
    certified_atlas(atlas, &atlas.to_atlas().unwrap(), &options).unwrap()
}

/// The document of a body with its drawing.
pub fn whole(body: &Body) -> AtlasDocument {
    let atlas = CertifiedAtlas::new(body).unwrap();
    certified_atlas(&atlas, &atlas.to_atlas().unwrap(), &DocumentOptions::default()).unwrap()
}

/// Documents of a generic body, of one with a pitchfork where a pole line meets it, and of a tilted part.
pub fn whole_documents() -> [AtlasDocument; 3] {
    [whole(&preset("paper")), whole(&preset("katok:6")), of_tilted_part()]
}

pub fn of_tilted_part() -> AtlasDocument {
    let tensor = Symmetric::new(["0.1", "0.2", "0.25", "0.01", "0", "-0.02"].map(exact));
    let properties = MassProperties::about_com(exact("2.5"), ["0.01", "0.02", "0.15"].map(exact), tensor).unwrap();
    let part = Part { properties, gravity: exact("9.80665"), units: "kg,cm,s".parse().unwrap() };
    let subject = Subject::of_part(&part).unwrap();
    let atlas = CertifiedAtlas::new(&subject.body).unwrap();
    certified_atlas_of(&subject, &atlas, &atlas.to_atlas().unwrap(), &DocumentOptions::default()).unwrap()
}

pub fn exact(text: &str) -> RBig {
    text.parse::<Number>().unwrap().value().clone()
}

/// What is said of a document that is changed and sealed anew.
pub fn forged(true_one: &AtlasDocument, change: impl Fn(&mut AtlasDocument)) -> Result<Report, Refused> {
    let mut forged = true_one.clone();
    change(&mut forged);
    assert_ne!(forged, *true_one, "the forgery changes nothing");
    seal(&mut forged).unwrap();
    verify(&forged)
}
