//! Pictures of U on the Poisson sphere.

mod picture_letters;
mod picture_svg;
mod picture_texts;

use bifdiag_plot::{Picture, SphereScene, Theme, Width, draw_sphere};
use bifdiag_schema::{
    ComponentDocument, Damped, FrictionDocument, Multiplicity, NonlinearDocument, NonlinearVerdict, Reason,
    RelativeEquilibriumDocument, Stability, Verdict,
};
use picture_letters::unprintable;
use picture_texts::{assert_texts_are_apart, texts};

fn component(boundary_circles: u32) -> ComponentDocument {
    ComponentDocument {
        boundary_circles,
        poles: Some(vec!["+".to_owned()]),
        accessible_region: "D2".to_owned(),
        energy_surface: "S3".to_owned(),
        section: Some("T2".to_owned()),
        genus: Some(1),
    }
}

/// A cap of 60° round e3.
fn cap(gamma: [f64; 3]) -> f64 {
    0.5 - gamma[2]
}

fn scene<'a>(components: &'a [ComponentDocument], equilibria: &'a [RelativeEquilibriumDocument]) -> SphereScene<'a> {
    SphereScene {
        title: "a body",
        caption: "a point",
        potential_above: &cap,
        r_hat: Some([0.0, 0.0, 1.0]),
        components,
        component_of: &|_| Some(0),
        equilibria,
        axis: [0.0, 0.0, 1.0],
        time_unit: "s",
        view: Some([0.0, 0.0, 1.0]),
    }
}

/// Lines of the colour and width of ∂U, the sample in the legend apart.
fn boundary_lines(svg: &str) -> usize {
    let paths = svg.lines().filter(|line| line.contains("stroke=\"#222222\" stroke-width=\"18\""));
    paths.map(|path| path.split('"').nth(1).unwrap_or_default().matches('M').count()).sum::<usize>() - 1
}

/// True where a text of a picture holds another.
fn says(picture: &Picture, wanted: &str) -> bool {
    texts(picture).iter().any(|(text, _)| text.contains(wanted))
}

#[test]
fn a_cap_seen_from_above_has_one_circle_in_the_first_view() {
    let components = [component(1)];
    let picture = draw_sphere(&scene(&components, &[]), Theme::Light, Width::PAGE).unwrap();
    assert_eq!(boundary_lines(&picture.svg), 1);
    assert!(says(&picture, "1: 1 boundary circle, pole +r̂; E = S³, P = T² (genus 1)"), "{:?}", texts(&picture));
    assert_eq!(picture, draw_sphere(&scene(&components, &[]), Theme::Light, Width::PAGE).unwrap());
}

#[test]
fn on_a_curve_no_component_is_named() {
    let picture = draw_sphere(&scene(&[], &[]), Theme::Light, Width::PAGE).unwrap();
    assert!(says(&picture, "accessible: U(γ) ≤ h"));
    assert!(!picture.svg.contains("boundary circle"));
}

/// An equilibrium with a period of two and a growth time of a quarter.
fn equilibrium(multiplicity: Multiplicity) -> RelativeEquilibriumDocument {
    RelativeEquilibriumDocument {
        h: 0.25,
        gamma: [0.6, 0.0, 0.8],
        omega: 1.0,
        index: 1,
        multiplicity,
        stability: Stability::SaddleCentre,
        stable: Verdict::Unstable,
        nonlinear: NonlinearDocument::along(NonlinearVerdict::Unstable, Reason::Spectrum, true),
        friction: FrictionDocument { conserving_l: Some(Damped::Lost), growing: 1, rates: Vec::new() },
        eigenvalues: [[4.0, 0.0], [0.0, std::f64::consts::PI]],
        eigenvalue_error: 1e-15,
        branch: "G1.1".to_owned(),
        branch_name: "from −r̂".to_owned(),
    }
}

#[test]
fn a_circle_of_equilibria_is_drawn_as_one() {
    let lines = |multiplicity, index| {
        let components = [component(1)];
        let equilibria = [RelativeEquilibriumDocument { index, ..equilibrium(multiplicity) }];
        let picture = draw_sphere(&scene(&components, &equilibria), Theme::Light, Width::PAGE).unwrap();
        picture.svg.matches("<path").count()
    };
    assert_eq!(lines(Multiplicity::Circle, 0), lines(Multiplicity::Points(1), 0) + 1);
    // A saddle has a cross of two lines with rims of paper, in its view and its row; a circle of maxima has a ring as a maximum.
    assert_eq!(lines(Multiplicity::Circle, 1), lines(Multiplicity::Points(1), 1) + 1 - 8);
}

#[test]
fn periods_and_growth_times_stand_below() {
    let picture =
        draw_sphere(&scene(&[component(1)], &[equilibrium(Multiplicity::Points(1))]), Theme::Light, Width::PAGE)
            .unwrap();
    for text in ["growth 0.25, period 2", "saddle-centre", "G1.1, from −r̂", "growth by a factor of e in s"] {
        assert!(says(&picture, text), "{text}\n{:?}", texts(&picture));
    }
}

#[test]
fn every_letter_of_a_view_stands_in_the_table() {
    let components = [component(1), component(2)];
    let at = |k: u32| {
        let angle = 0.6 * f64::from(k);
        let gamma = [libm::cos(angle) * 0.8, libm::sin(angle) * 0.8, if k.is_multiple_of(2) { 0.6 } else { -0.6 }];
        RelativeEquilibriumDocument { h: f64::from(k), gamma, ..equilibrium(Multiplicity::Points(1)) }
    };
    for count in 1..=12 {
        let equilibria: Vec<RelativeEquilibriumDocument> = (0..count).map(at).collect();
        for width in Width::ALL {
            let picture = draw_sphere(&scene(&components, &equilibria), Theme::Light, width).unwrap();
            let texts = texts(&picture);
            // h is an energy.
            for (k, letter) in (0..count).zip("abcdefgijmop".chars()) {
                // Five times in a view, and in its row.
                let count_of = texts.iter().filter(|(text, _)| *text == letter.to_string()).count();
                assert_eq!(count_of, 6, "{letter} of {count}");
                assert!(texts.iter().any(|(text, _)| *text == k.to_string()), "the energy of {letter}");
            }
            assert_eq!(unprintable(&picture, width), Vec::<String>::new(), "{count}");
        }
    }
}

/// Poles and axes on the rim, and equilibria so near to each other that their letters must give way.
#[test]
fn names_keep_off_each_other_and_off_the_boundary() {
    let components = [component(1)];
    let at = |gamma: [f64; 3]| RelativeEquilibriumDocument { gamma, ..equilibrium(Multiplicity::Points(1)) };
    let equilibria = [at([0.6, 0.0, 0.8]), at([0.58, 0.05, 0.8131]), at([0.0, 0.866, 0.5]), at([0.0, 0.0, 1.0])];
    let views = [None, Some([0.0, 0.0, 1.0]), Some([1.0, 0.0, 0.0]), Some([0.3, -0.8, 0.5])];
    for (view, width) in views.into_iter().flat_map(|view| Width::ALL.map(|width| (view, width))) {
        let scene = SphereScene { view, ..scene(&components, &equilibria) };
        let picture = draw_sphere(&scene, Theme::Light, width).unwrap();
        // A name is written five times, for its rim; where that is so is one name.
        let mut names: Vec<(String, [f32; 4])> = Vec::new();
        for (text, area) in texts(&picture) {
            let near = |other: &[f32; 4]| (0..4).all(|k| (other[k] - area[k]).abs() <= 2.1);
            if !names.iter().any(|(other, place)| *other == text && near(place)) {
                names.push((text, area));
            }
        }
        assert!(["a", "b", "c", "d", "+r̂", "−r̂", "e₁"].iter().all(|name| names.iter().any(|(text, _)| text == name)));
        assert_texts_are_apart(&names);
        assert_eq!(unprintable(&picture, width), Vec::<String>::new());
    }
}

#[test]
fn a_hole_is_not_hidden_by_the_mark_of_its_maximum() {
    let components = [component(1)];
    let maximum =
        RelativeEquilibriumDocument { gamma: [0.0, 0.0, 1.0], index: 2, ..equilibrium(Multiplicity::Points(1)) };
    // The first view shows e3 in its middle; a ring of 4.2 pixels marks it.
    let is_in_place = |level: f64| {
        let hole = move |gamma: [f64; 3]| gamma[2] - level;
        let equilibria = [maximum.clone()];
        let scene =
            SphereScene { potential_above: &hole, r_hat: Some([1.0, 0.0, 0.0]), ..scene(&components, &equilibria) };
        draw_sphere(&scene, Theme::Light, Width::PAGE).unwrap().svg.contains("<circle cx=\"2200\" cy=\"2520\" r=\"42\"")
    };
    assert!(is_in_place(0.9), "the hole is large");
    assert!(!is_in_place(0.9998), "the hole has a radius of 3.7 pixels");
}
