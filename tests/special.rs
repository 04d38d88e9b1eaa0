//! The strata of special bodies in `data/survey/special.json`: what the file says of them, Katok's classes and the paper's
//! family in closed form.

use std::collections::{BTreeMap, BTreeSet};

use bifdiag_body::Body;
use bifdiag_diagram::class::ClassName;
use bifdiag_exact::Accuracy;
use bifdiag_survey::border::{self, BodySegment, BorderOptions, class_of};
use bifdiag_survey::scan;
use bifdiag_survey::space::ReducedBody;
use serde::Deserialize;
use support::katok;
use support::special::{SPECIAL_STRATA, SpecialStratum};

#[derive(Deserialize)]
struct Walked {
    stratum: String,
    parameters: usize,
    met: BTreeMap<String, Met>,
    classes: Vec<Class>,
    borders: Vec<Border>,
}

#[derive(Deserialize)]
struct Met {
    preset: Option<String>,
}

#[derive(Deserialize)]
struct Class {
    #[serde(rename = "class")]
    name: String,
    #[serde(rename = "A")]
    moments: [f64; 3],
    #[serde(rename = "r")]
    center: [f64; 3],
}

#[derive(Deserialize)]
struct Border {
    classes: [String; 2],
    #[serde(rename = "A")]
    moments: [f64; 3],
    error: f64,
}

fn strata() -> Vec<Walked> {
    serde_json::from_str(&support::data("survey/special.json")).unwrap()
}

/// The class of a preset.
fn named(preset: &str) -> String {
    let found = scan::known_classes().into_iter().find(|(_, known)| known.name() == preset);
    found.map(|(name, _): (ClassName, _)| name.to_string()).unwrap()
}

#[test]
fn every_stratum_has_its_classes_and_its_borders() {
    let strata = strata();
    assert!(strata.iter().map(|walked| &walked.stratum).eq(SPECIAL_STRATA.iter().map(|stratum| stratum.name)));
    for walked in &strata {
        let names: BTreeSet<&str> = walked.met.keys().map(String::as_str).collect();
        assert!(walked.classes.iter().map(|class| class.name.as_str()).eq(names.iter().copied()), "{}", walked.stratum);
        // A sample of the larger ones.
        for class in walked.classes.iter().step_by(1 + walked.classes.len() / 8) {
            let values = [class.moments, class.center];
            assert_eq!(SpecialStratum::of(&ReducedBody::of(values)).unwrap().name, walked.stratum);
            let body = Body::from_f64(class.moments, class.center).unwrap();
            assert_eq!(class_of(&body, Accuracy::Exact).unwrap().1.name().as_str(), class.name);
        }
        for border in &walked.borders {
            assert!(border.classes.iter().all(|class| names.contains(class.as_str())), "{}", walked.stratum);
        }
        // A stratum of one point has one class.
        assert!(walked.parameters > 0 || walked.met.len() == 1, "{}", walked.stratum);
    }
}

#[test]
fn katoks_seven_classes_are_those_of_r_on_an_axis_and_their_borders_are_his() {
    let mut presets = BTreeSet::new();
    for (axis, count) in [(0, 1), (1, 2), (2, 4)] {
        let walked = strata().into_iter().find(|walked| walked.stratum == format!("r on axis {}", axis + 1)).unwrap();
        assert_eq!(walked.met.len(), count, "{}", walked.stratum);
        presets.extend(walked.met.into_values().map(|met| met.preset.unwrap()));
        for border in &walked.borders {
            let a = border.moments;
            let mut others: Vec<f64> = (0..3).filter(|k| *k != axis).map(|k| a[k] / a[axis]).collect();
            others.sort_by(f64::total_cmp);
            let on_line = others.iter().any(|other| (other - katok::LINES[0]).abs() < 1e-8 + border.error);
            let on_curve = katok::lesser_moment(others[1]).is_some_and(|k| (k - others[0]).abs() < 1e-8 + border.error);
            assert!(on_line || on_curve, "{}: {others:?}", walked.stratum);
        }
    }
    assert!(presets.into_iter().eq((1..=7).map(|k| format!("katok:{k}"))));
}

/// A = (2, η, 1), r = (1, 0, 0): from Lagrange's top to Kovalevskaya's.
#[test]
fn the_papers_family_has_three_classes_between_lagrange_and_kovalevskaya() {
    let body = |eta: f64| Body::from_f64([2.0, eta, 1.0], [1.0, 0.0, 0.0]).unwrap();
    let (from, to) = (1.001, 1.999);
    let borders = border::all(&BodySegment::new(body(from), body(to)), &BorderOptions::default());
    let places: Vec<f64> = borders.iter().map(|border| from + (to - from) * border.t).collect();
    assert_eq!(places.len(), 2, "{places:?}");
    // 4 (1/√(1 − η/2) − 1) = 1/(1 − 1/2) and η/2 = 3/4.
    for (place, exact) in places.iter().zip([10.0 / 9.0, 1.5]) {
        assert!((place - exact).abs() < 1e-12, "{place} {exact}");
    }
    let classes = borders.iter().flat_map(|border| border.classes.each_ref().map(|class| class.name().to_string()));
    let expected = ["katok:7", "katok:6", "katok:6", "katok:5"].map(named);
    assert!(classes.eq(expected));
    // Its ends are special in more than one way.
    let kovalevskaya = ReducedBody::of_body(&body(2.0));
    assert_eq!(SpecialStratum::of(&kovalevskaya).unwrap().name, "A2 = A3, r across axis 1");
    assert_eq!(SpecialStratum::of(&ReducedBody::of_body(&body(1.0))).unwrap().name, "A1 = A2, Lagrange");
}

#[test]
fn classes_change_on_katoks_curve() {
    for greater in [0.5, 0.6, 0.7] {
        let lesser = katok::lesser_moment(greater).unwrap();
        let body = |a: f64| Body::from_f64([1.0, greater, a], [1.0, 0.0, 0.0]).unwrap();
        // On this side of the diagonal, on which two moments are equal.
        let half = 0.3 * (greater - lesser);
        let (from, to) = (lesser - half, lesser + half);
        let segment = BodySegment::new(body(from), body(to));
        let border = border::find(&segment, &BorderOptions::default()).unwrap();
        assert!((from + (to - from) * border.t - lesser).abs() < 1e-10, "{greater}: {border:?}");
    }
}
