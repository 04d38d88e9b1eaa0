//! Pictures of U on the Poisson sphere.

use plot::{SphereEquilibrium, SphereScene, Theme, draw_sphere};
use schema::ComponentDocument;

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

fn scene<'a>(components: &'a [ComponentDocument], equilibria: &'a [SphereEquilibrium]) -> SphereScene<'a> {
    SphereScene {
        title: "a body",
        caption: "a point",
        potential_above: &cap,
        r_hat: Some([0.0, 0.0, 1.0]),
        components,
        component_of: &|_| Some(0),
        equilibria,
        view: Some([0.0, 0.0, 1.0]),
    }
}

/// Numbers of drawn paths of the colour and width of ∂U, and of moves in them.
fn boundary_lines(svg: &str) -> usize {
    let paths = svg.lines().filter(|line| line.contains("stroke=\"#222222\" stroke-width=\"18\""));
    paths.map(|path| path.split('"').nth(1).unwrap_or_default().matches('M').count()).sum()
}

#[test]
fn a_cap_seen_from_above_has_one_circle_in_the_first_view() {
    let components = [component(1)];
    let picture = draw_sphere(&scene(&components, &[]), Theme::Light).unwrap();
    assert_eq!(boundary_lines(&picture.svg), 1);
    assert!(picture.svg.contains("1: 1 boundary circle, pole +r̂;  E = S³, P = T² (genus 1)"), "{}", picture.svg);
    assert_eq!(picture, draw_sphere(&scene(&components, &[]), Theme::Light).unwrap());
}

#[test]
fn on_a_curve_no_component_is_named() {
    let picture = draw_sphere(&scene(&[], &[]), Theme::Light).unwrap();
    assert!(picture.svg.contains("accessible: U(γ) ≤ h"));
    assert!(!picture.svg.contains("boundary circle"));
}

#[test]
fn a_circle_of_equilibria_is_drawn_as_one() {
    let gamma = [0.6, 0.0, 0.8];
    let circle = SphereEquilibrium { gamma, index: 0, circle_about: Some([0.0, 0.0, 1.0]) };
    let point = SphereEquilibrium { circle_about: None, ..circle };
    let [with, without] = [circle, point].map(|equilibrium| {
        let components = [component(1)];
        draw_sphere(&scene(&components, &[equilibrium]), Theme::Light).unwrap().svg.matches("<polyline").count()
    });
    assert_eq!(with, without + 1);
}
