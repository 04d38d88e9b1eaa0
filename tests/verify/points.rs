//! The proof of one point, true and forged; integrable cases, true and forged.

use bifdiag_body::{Body, Number};
use bifdiag_documents::{DocumentOptions, Drawn, Subject, certified_atlas_of, leave_out_drawing, proved_point};
use bifdiag_exact::{Accuracy, CertifiedAtlas, Solver};
use bifdiag_schema::{IntegrableCaseName, PointProofDocument, Status};
use bifdiag_verify::{Refused, verify, verify_point};

use crate::made::{body, document, forged, preset};

fn point(body: &Body, h: &str, l: &str) -> PointProofDocument {
    let [h, l]: [Number; 2] = [h, l].map(|text| text.parse().unwrap());
    let solver = Solver::new(body.clone(), Accuracy::Exact);
    let found = solver.classify(&h, &l).unwrap();
    let places = solver.places(&h, &l, &found.answer).unwrap();
    let proved = CertifiedAtlas::new(body).unwrap();
    let (subject, drawn) = (Subject::from(body.clone()), proved.to_atlas().unwrap());
    let options = DocumentOptions { drawing: Drawn::Nothing, ..DocumentOptions::default() };
    let mut atlas = certified_atlas_of(&subject, &proved, &drawn, &options).unwrap();
    leave_out_drawing(&mut atlas, &subject).unwrap();
    proved_point(&subject, [&h, &l], places[0], &proved, atlas).unwrap()
}

#[test]
fn points_of_all_kinds_are_confirmed() {
    let paper = preset("paper");
    for (h, l) in [("3.8", "3.25"), ("-7", "0.001"), ("3.53", "2.86"), ("4.645784643886436", "3.25"), ("1e6", "100")] {
        verify_point(&point(&paper, h, l)).unwrap();
    }
    for name in ["lagrange", "kovalevskaya", "euler", "katok:6", "isotropic"] {
        verify_point(&point(&preset(name), "2", "3/7")).unwrap();
    }
}

/// Each field of a point is refused when it is forged, also where two of them agree.
#[test]
fn a_forged_point_is_refused() {
    let true_one = point(&preset("paper"), "3.8", "3.25");
    assert_eq!(true_one.region.as_deref(), Some("R5"));
    let other = point(&preset("paper"), "4.7", "3.25");
    assert_ne!(other.region, true_one.region);
    let refused = |change: &dyn Fn(&mut PointProofDocument)| {
        let mut forged = true_one.clone();
        change(&mut forged);
        assert_ne!(forged, true_one, "the forgery changes nothing");
        verify_point(&forged).expect_err("a forgery is confirmed")
    };
    let field = |field| Refused::Field { field };
    let with_command = |forged: &mut PointProofDocument| {
        let line = forged.head.command.clone();
        let (before, _) = line.split_once(" --h ").unwrap();
        forged.head.command = format!("{before} --h {} --l {} --certificate --json", forged.h, forged.l);
    };
    // The components, or the whole of another region.
    assert_eq!(refused(&|p| p.components[0].genus = Some(1)), field("components"));
    assert_eq!(refused(&|p| p.components.truncate(1)), field("components"));
    assert_eq!(refused(&|p| p.region.clone_from(&other.region)), field("region"));
    let swapped = refused(&|p| {
        p.region.clone_from(&other.region);
        p.components.clone_from(&other.components);
    });
    assert_eq!(swapped, field("region"));
    assert_eq!(refused(&|p| p.region = None), field("region"));
    assert_eq!(refused(&|p| p.status = Status::Forbidden), field("status"));
    // h and l, alone and with the command that belongs to them.
    assert_eq!(refused(&|p| p.h = "4.7".to_owned()), field("command"));
    let moved = refused(&|p| {
        p.h = "4.7".to_owned();
        with_command(p);
    });
    assert_eq!(moved, field("region"));
    let moved = refused(&|p| {
        p.l = "3.2".to_owned();
        with_command(p);
    });
    assert_eq!(moved, field("level.x"));
    // The curves over l.
    refused(&|p| p.level.x.push('1'));
    assert_eq!(refused(&|p| p.slab += 1), field("level"));
    assert_eq!(refused(&|p| p.slab = 99), field("slab"));
    assert_eq!(refused(&|p| p.level.curves.swap(0, 1)), field("level"));
    assert_eq!(refused(&|p| p.level.curves[2].region = "R2".to_owned()), field("level"));
    refused(&|p| {
        p.level.curves.pop();
    });
    for number in 0..true_one.level.curves.len() {
        if true_one.level.curves[number].place.is_some() {
            refused(&|p| p.level.curves[number].place = None);
            refused(&|p| {
                let place = p.level.curves[number].place.as_mut().unwrap();
                place.y = ["0.1".to_owned(), "0.11".to_owned()];
            });
        }
    }
    // The atlas is checked as ever.
    refused(&|p| p.atlas.regions[4].components.clone_from(&true_one.atlas.regions[0].components));
    refused(&|p| p.atlas.certificate = None);
    refused(&|p| p.head.schema_version = "2".to_owned());
}

/// A point on a curve lies in no region, however the document puts it.
#[test]
fn a_point_on_a_curve_is_not_confirmed() {
    // The ball has the energies l²/2 − 1 at rest below and l²/2 + 1.
    let ball = preset("isotropic");
    let mut document = point(&ball, "0.5", "1");
    document.h = "3/2".to_owned();
    document.head.command = document.head.command.replace("--h 0.5", "--h 3/2");
    assert!(matches!(verify_point(&document), Err(Refused::Uncertain { .. })), "{:?}", verify_point(&document));
}

#[test]
fn an_integrable_case_is_checked() {
    for name in ["kovalevskaya", "lagrange", "euler", "goryachev-chaplygin", "isotropic"] {
        let document = document(&preset(name));
        assert_eq!(document.body.integrable.len(), 1, "{name}");
        verify(&document).unwrap();
    }
    let hess = document(&body([["1/2", "1/3", "1/7"], ["1", "0", "2"]]));
    assert_eq!(hess.body.integrable[0].case, IntegrableCaseName::HessAppelrot);
    verify(&hess).unwrap();
    let wrong = Err(Refused::Field { field: "body.integrable" });
    let kovalevskaya = document(&preset("kovalevskaya"));
    assert_eq!(forged(&kovalevskaya, |d| d.body.integrable.clear()), wrong);
    assert_eq!(forged(&kovalevskaya, |d| d.body.integrable[0].case = IntegrableCaseName::Lagrange), wrong);
    assert_eq!(forged(&kovalevskaya, |d| d.body.integrable[0].integral = "ω3".to_owned()), wrong);
    assert_eq!(forged(&kovalevskaya, |d| d.body.integrable[0].holds = "where l = 0".to_owned()), wrong);
    let generic = document(&preset("paper"));
    assert_eq!(forged(&generic, |d| d.body.integrable.clone_from(&kovalevskaya.body.integrable)), wrong);
}
