//! Labels of diagrams: of every class of the survey, the presets, random bodies, rods and real parts, none meets another
//! thing, and every region is labelled.
#![allow(clippy::disallowed_methods, clippy::cast_precision_loss)]

mod picture_layout;
mod picture_letters;
mod picture_svg;

use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

use bifdiag_body::{Body, Preset, Tensor};
use bifdiag_diagram::atlas::Atlas;
use bifdiag_documents::DocumentOptions;
use bifdiag_equilibria::critical::critical;
use bifdiag_numbers::Number;
use bifdiag_numbers::symmetric::Symmetric;
use bifdiag_plot::{CurveSource, DiagramOptions, DiagramView, Figure, Width, draw_figure};
use bifdiag_schema::{AtlasDocument, RelativeEquilibriumDocument};
use picture_layout::Layout;
use picture_letters::unprintable;
use serde_json::Value;
use support::bodies::{STRATA, Stratum, random_body};
use support::random::SplitMix64;

/// Polylines as fine as a magnification needs.
struct Curves(Atlas);

impl CurveSource for Curves {
    fn polyline(&self, curve: &str, l: [f64; 2], tolerance: f64) -> Option<Vec<[f64; 2]>> {
        self.0.polyline(curve.parse().ok()?, l, tolerance)
    }

    fn equilibria(&self, l: f64) -> Vec<RelativeEquilibriumDocument> {
        let found = Number::from_f64(l).ok().and_then(|l| critical(self.0.body(), &l).ok());
        found.map_or_else(Vec::new, |found| bifdiag_documents::equilibria(&found))
    }
}

fn drawn(body: &Body, width: Width, view: DiagramView) -> (AtlasDocument, Figure) {
    let atlas = Curves(bifdiag_diagram::fast::atlas(body).expect("the body has an atlas"));
    let options = DocumentOptions::default();
    let document = bifdiag_documents::atlas::document(&atlas.0, &options);
    let figure = draw_figure(&document, Some(&atlas), &DiagramOptions { width, view, ..DiagramOptions::default() })
        .expect("the diagram can be drawn");
    (document, figure)
}

/// How regions are labelled in a main panel.
#[derive(Default)]
struct Seen {
    regions: usize,
    /// Labelled inside.
    inside: usize,
    /// With the type of the section, too.
    named: usize,
    /// The least height of a region, in millimetres.
    lowest: f32,
}

impl Seen {
    fn in_picture(atlas: &AtlasDocument, layout: &Layout) -> Self {
        let mut seen = Self { regions: atlas.regions.len(), lowest: f32::INFINITY, ..Self::default() };
        for region in &atlas.regions {
            let id = format!("main-label-{}", region.id);
            let texts = layout.texts.iter().filter(|(_, _, label)| *label == id).count();
            let is_inside = texts > 0 && !layout.boxes.iter().any(|(label, _)| *label == id);
            seen.inside += usize::from(is_inside);
            seen.named += usize::from(is_inside && texts > 1);
            let own = layout.regions.iter().filter(|(name, _)| *name == format!("main-{}", region.id));
            let millimetres = 25.4 / picture_svg::PIXELS_PER_INCH;
            seen.lowest = seen.lowest.min(own.map(|(_, area)| area.height() * millimetres).fold(0.0, f32::max));
        }
        seen
    }
}

/// What is wrong with the picture of a body.
fn faults(name: &str, body: &Body, width: Width, view: DiagramView) -> (Vec<String>, Seen) {
    let name = &format!("{name}-{}mm-{view:?}", width.millimetres());
    let (atlas, Figure { picture, caption, .. }) = drawn(body, width, view);
    // For the eye: set PLOT_OUT to a directory.
    if let Some(out) = std::env::var_os("PLOT_OUT").map(std::path::PathBuf::from) {
        std::fs::write(out.join(format!("{name}.svg")), &picture.svg).unwrap();
    }
    let layout = Layout::of(&picture);
    let mut faults = layout.collisions();
    faults.extend(unprintable(&picture, width));
    for region in &atlas.regions {
        // In a label, in the key, where regions of one ground share an entry, or in a note on what cannot be drawn.
        let labelled = |text: &str| {
            let is_named = |entry: &str| {
                let rest = entry.strip_prefix(&region.id);
                rest.is_some_and(|rest| rest.is_empty() || rest.starts_with(", U = ") || rest.starts_with(':'))
            };
            text.split(';').map(str::trim_start).any(is_named) || text.contains(&format!("{} (", region.id))
        };
        // … or where the key has left the picture.
        let in_caption = |line: &str| line.split(": ").any(labelled);
        if !layout.texts.iter().any(|(text, _, _)| labelled(text)) && !caption.text.lines().any(in_caption) {
            faults.push(format!("{} is not labelled", region.id));
        }
    }
    for (text, _, _) in &layout.texts {
        for (sign, rest) in ["h ×", "l ×"].into_iter().filter_map(|sign| Some((sign, text.split_once(sign)?.1))) {
            // Powers of ten begin at thousands.
            let number: String = rest.chars().take_while(|c| c.is_ascii_digit() || *c == '.').collect();
            if !rest[number.len()..].starts_with("·10") && number.parse::<f64>().unwrap() < 2.95 {
                faults.push(format!("an inset magnifies {sign}{number} only"));
            }
        }
    }
    let high = picture.millimetres_high();
    if width.is_column() && view != DiagramView::Plane && high > 120.5 * width.millimetres() / 86.0 {
        faults.push(format!("{high} mm high"));
    }
    let wide = f64::from(layout.size[0] / picture_svg::PIXELS_PER_INCH) * 25.4;
    if (wide - width.millimetres()).abs() > 0.1 {
        faults.push(format!("{wide} mm wide"));
    }
    let seen = Seen::in_picture(&atlas, &layout);
    (faults.into_iter().map(|fault| format!("{name}: {fault}")).collect(), seen)
}

fn triple(value: &Value) -> [f64; 3] {
    std::array::from_fn(|k| value[k].as_f64().unwrap())
}

/// The first body of each class that the survey met, and those with most regions among bodies that cannot exist.
fn survey() -> Vec<(String, Body)> {
    let mut bodies = Vec::new();
    for (survey, least) in [("general", 0), ("positive", 24)] {
        let summary: Value = serde_json::from_str(&support::data(&format!("survey/{survey}.summary.json"))).unwrap();
        let classes = summary["classes"].as_array().unwrap();
        for class in classes.iter().filter(|class| class["regions"].as_u64().unwrap() >= least) {
            let first = &class["first"];
            let body = Body::from_f64(triple(&first["A"]), triple(&first["r"])).unwrap();
            bodies.push((format!("class-{survey}-{}", class["class"].as_str().unwrap()), body));
        }
    }
    bodies
}

fn random(count: usize) -> Vec<(String, Body)> {
    let mut rng = SplitMix64::new(20);
    // Every second body is special.
    let stratum = |n: usize| if n.is_multiple_of(2) { Stratum::Generic } else { STRATA[n / 2 % STRATA.len()] };
    (0..count).map(|n| (format!("random-{n}"), random_body(&mut rng, stratum(n)))).collect()
}

/// Thin rods whose centre of mass lies near their axis.
fn rods(count: u32) -> Vec<(String, Body)> {
    let mut rng = SplitMix64::new(7);
    let body = |n: u32| {
        let thickness = rng.power_of_ten(-6.0, -1.0);
        let moments = [thickness, 1.0, 1.0 + 0.9 * thickness * rng.unit()];
        let center = [1.0, rng.power_of_ten(-4.0, -1.0), rng.power_of_ten(-4.0, -1.0)];
        (format!("rod-{n}"), Body::from_f64(moments, center).unwrap())
    };
    (0..count).map(body).collect()
}

/// Point masses of a few kilograms on turned frames, in SI units: numbers with many digits on every scale.
fn parts(count: u32) -> Vec<(String, Body)> {
    let mut rng = SplitMix64::new(11);
    let body = |n: u32| {
        let size = rng.power_of_ten(-3.0, 0.0);
        let masses: Vec<(f64, [f64; 3])> =
            (0..6).map(|_| (rng.between(0.1, 2.0), [0.0; 3].map(|_| size * rng.between(-1.0, 1.0)))).collect();
        let mut rows = [[0.0; 3]; 3];
        let mut center = [0.0; 3];
        for (mass, at) in &masses {
            let square: f64 = at.iter().map(|x| x * x).sum();
            for i in 0..3 {
                center[i] += 9.80665 * mass * at[i];
                for j in 0..3 {
                    rows[i][j] += mass * (if i == j { square } else { 0.0 } - at[i] * at[j]);
                }
            }
        }
        let exact = |x: f64| Number::from_f64(x).unwrap().value().clone();
        let upper = [rows[0][0], rows[1][1], rows[2][2], rows[0][1], rows[0][2], rows[1][2]].map(exact);
        let tensor = Tensor::new(Symmetric::new(upper), center.map(exact)).unwrap();
        (format!("part-{n}"), tensor.principal().unwrap().body)
    };
    (0..count).map(body).collect()
}

/// What is wrong with the diagrams of four hundred bodies at both widths, and how their regions are labelled.
fn all_faults(view: DiagramView) -> (usize, Vec<String>, [Vec<Seen>; 2]) {
    let presets = Preset::all().iter().map(|preset| (preset.name().replace(':', "-"), preset.body()));
    let mut bodies: Vec<(String, Body)> = presets.collect();
    bodies.extend(survey());
    bodies.extend(random(200));
    bodies.extend(rods(60));
    bodies.extend(parts(60));
    assert!(bodies.len() > 400, "{} bodies", bodies.len());
    let next = AtomicUsize::new(0);
    let found: Mutex<(Vec<String>, [Vec<Seen>; 2])> = Mutex::default();
    std::thread::scope(|scope| {
        for _ in 0..std::thread::available_parallelism().map_or(1, usize::from) {
            scope.spawn(|| {
                while let Some((name, body)) = bodies.get(next.fetch_add(1, Ordering::Relaxed)) {
                    for (number, width) in Width::ALL.into_iter().enumerate() {
                        let (faults, own) = faults(name, body, width, view);
                        let mut found = found.lock().unwrap();
                        found.0.extend(faults);
                        found.1[number].push(own);
                    }
                }
            });
        }
    });
    let (faults, seen) = found.into_inner().unwrap();
    (bodies.len(), faults, seen)
}

#[test]
fn no_label_of_four_hundred_diagrams_meets_anything() {
    let (bodies, found, _) = all_faults(DiagramView::Plane);
    assert!(found.is_empty(), "{} faults in {bodies} diagrams:\n{}", found.len(), found.join("\n"));
}

#[test]
fn nearly_all_regions_of_four_hundred_straightened_diagrams_are_labelled_inside() {
    let (bodies, found, seen) = all_faults(DiagramView::Straight);
    for (width, seen) in Width::ALL.into_iter().zip(seen) {
        let count = |count: fn(&Seen) -> usize| seen.iter().map(count).sum::<usize>();
        let [regions, inside, named] =
            [count(|seen| seen.regions), count(|seen| seen.inside), count(|seen| seen.named)];
        let whole = seen.iter().filter(|seen| seen.inside == seen.regions).count();
        let lowest = seen.iter().map(|seen| seen.lowest).fold(f32::INFINITY, f32::min);
        println!(
            "{} mm: {inside} of {regions} regions are labelled inside, {named} with their type; all regions of {whole} \
             of {bodies} bodies; the lowest region is {lowest} mm high",
            width.millimetres()
        );
        assert!(inside as f64 >= 0.95 * regions as f64, "{inside} of {regions} at {} mm", width.millimetres());
    }
    assert!(found.is_empty(), "{} faults in {bodies} diagrams:\n{}", found.len(), found.join("\n"));
}

/// An 86 mm figure of a body with up to twelve regions, as it is drawn by default.
#[test]
fn columns_are_at_most_120_mm_high() {
    let presets = Preset::all().iter().map(|preset| (preset.name().replace(':', "-"), preset.body()));
    let bodies = presets.chain(survey().into_iter().step_by(4));
    let faults: Vec<String> =
        bodies.flat_map(|(name, body)| faults(&name, &body, Width::COLUMN, DiagramView::Auto).0).collect();
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn diagrams_are_as_wide_as_asked_and_no_label_meets_anything() {
    let mut found = Vec::new();
    for name in ["paper", "ten", "kovalevskaya", "katok:6", "lagrange", "euler"] {
        let body = Preset::find(name).unwrap().body();
        for millimetres in [80.0, 100.0, 131.0, 132.0, 150.0, 250.0] {
            for view in [DiagramView::Plane, DiagramView::Straight] {
                found.extend(faults(&name.replace(':', "-"), &body, Width::new(millimetres).unwrap(), view).0);
            }
        }
    }
    assert!(found.is_empty(), "{}", found.join("\n"));
}

#[test]
fn a_collision_is_found() {
    let (_, Figure { picture, .. }) = drawn(&Preset::find("paper").unwrap().body(), Width::PAGE, DiagramView::Plane);
    assert_eq!(Layout::of(&picture).collisions(), Vec::<String>::new());
    // The first label with a box moves to the middle of another region's text.
    let layout = Layout::of(&picture);
    let [one, other] = [&layout.texts[layout.texts.len() - 1].0, &layout.texts[0].0];
    assert_ne!(one, other);
    let mut moved = Layout::of(&picture);
    let place = moved.boxes[0].1;
    moved.texts[0].1 = place;
    moved.leaders[0].1 = [[place.left() - 5.0, place.top() + 1.0], [place.right() + 5.0, place.bottom() - 1.0]];
    assert!(moved.collisions().len() >= 2);
}
