//! Pictures of sections.
#![allow(
    clippy::disallowed_methods,
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    clippy::cast_precision_loss
)]

mod picture_letters;
mod picture_svg;
mod picture_texts;

use std::f64::consts::{PI, TAU};

use bifdiag_body::Body;
use bifdiag_dynamics::section::{
    Monitor, OrbitSection, Portrait, PortraitOptions, SectionChart, SectionCondition, SweepOptions, sweep,
};
use bifdiag_plot::{
    OrbitValues, Picture, PlotError, Projection, SectionOptions, SectionScene, Width, draw_section, draw_section_rows,
};
use picture_letters::unprintable;
use picture_svg::PIXELS_PER_INCH;
use picture_texts::{assert_texts_are_apart, texts};
use resvg::tiny_skia::Pixmap;

/// The plot areas of T⁻ and T⁺ in the first row: left, top, width, height.
const PANELS: [[f64; 4]; 2] = [[56.0, 64.0, 384.0, 240.0], [480.0, 64.0, 384.0, 240.0]];

fn portrait(h: f64, l: f64, condition: SectionCondition) -> Portrait {
    let body = Body::parse(&["2", "1.1", "1"], &["0.94868", "0", "0.61623"]).unwrap();
    Portrait::new(&body, h, l, &PortraitOptions { condition, ..PortraitOptions::default() }).unwrap()
}

/// Orbits from accessible places of a coarse grid, the sheets in turn.
fn orbits(portrait: &Portrait, count: usize, crossings: usize) -> Vec<OrbitSection> {
    let places = (0..).map(|k| [f64::from(k) * 2.4 % TAU, f64::from(k) * 0.618 % 1.0 * PI]);
    let states = places.enumerate().filter_map(|(k, place)| Some(portrait.states(SectionChart::Torus, place)?[k % 2]));
    let starts: Vec<_> = states.take(count).collect();
    let options = SweepOptions { crossings, condition: portrait.condition(), ..SweepOptions::default() };
    sweep(portrait.torus(), &starts, &options, &Monitor::default()).unwrap()
}

fn scene<'a>(portrait: &'a Portrait, orbits: &'a [OrbitSection]) -> SectionScene<'a> {
    SectionScene { portrait, orbits, values: None, families: None, curves: None, caption: "T²+T²" }
}

fn valued<'a>(portrait: &'a Portrait, orbits: &'a [OrbitSection], values: &'a [f64]) -> SectionScene<'a> {
    SectionScene { values: Some(OrbitValues { label: "Lyapunov exponent", values }), ..scene(portrait, orbits) }
}

/// The picture on a page; looked at for every width.
fn drawn(name: &str, scene: &SectionScene<'_>, options: &SectionOptions) -> Picture {
    let of_width = |width: Width| {
        let options = SectionOptions { width, ..options.clone() };
        let picture = draw_section(scene, &options).expect("the section can be drawn");
        look(&format!("{name}-{}mm", width.millimetres()), &picture);
        // Images are text that may hold anything.
        let drawn = without_images(&picture.svg);
        assert!(!drawn.contains("NaN") && !drawn.contains("inf\""), "a coordinate is not a number");
        assert_texts_are_apart(&texts(&picture));
        assert_eq!(unprintable(&picture, width), Vec::<String>::new());
        picture
    };
    let [page, _] = Width::ALL.map(of_width);
    page
}

/// An SVG without the contents of its images.
fn without_images(svg: &str) -> String {
    let mut parts = svg.split("base64,");
    let first = parts.next().unwrap_or_default().to_owned();
    parts.fold(first, |text, part| text + part.split_once('"').map_or("", |(_, rest)| rest))
}

/// For the eye: set PLOT_OUT to a directory.
fn look(name: &str, picture: &Picture) {
    if let Some(out) = std::env::var_os("PLOT_OUT").map(std::path::PathBuf::from) {
        std::fs::write(out.join(format!("{name}.svg")), &picture.svg).unwrap();
        std::fs::write(out.join(format!("{name}.png")), picture.to_png(144.0).unwrap()).unwrap();
        #[cfg(feature = "pdf")]
        std::fs::write(out.join(format!("{name}.pdf")), picture.to_pdf().unwrap()).unwrap();
    }
}

fn pixels(picture: &Picture) -> Pixmap {
    Pixmap::decode_png(&picture.to_png(f64::from(PIXELS_PER_INCH)).unwrap()).unwrap()
}

fn color(pixels: &Pixmap, x: f64, y: f64) -> [u8; 3] {
    let pixel = pixels.pixel(x as u32, y as u32).unwrap();
    [pixel.red(), pixel.green(), pixel.blue()]
}

fn has(texts: &[(String, [f32; 4])], wanted: &str) -> bool {
    texts.iter().any(|(text, _)| text == wanted)
}

#[test]
fn both_sheets_have_axes_names_and_a_legend() {
    let portrait = portrait(4.45, 3.25, SectionCondition::Height);
    let orbits = orbits(&portrait, 12, 200);
    let texts = texts(&drawn("torus", &scene(&portrait, &orbits), &SectionOptions::default()));
    for wanted in ["T⁻", "T⁺", "ψ′", "ϑ′", "2π", "h = 4.45, l = 3.25", "T²+T²", "∂U", "Ṡ < 0, incoming"]
    {
        assert!(has(&texts, wanted), "{wanted} is not printed: {texts:?}");
    }
    assert!(texts[0].0.starts_with("A = (2, 1.1, 1), r"));
    assert!(!has(&texts, "S⁻"));
}

/// What a panel shows of the torus: all of it, or what is accessible with a twentieth more on each side if that is small.
fn window(portrait: &Portrait) -> [[f64; 2]; 2] {
    let points: Vec<[f64; 2]> = portrait.accessible(SectionChart::Torus).loops.iter().flatten().copied().collect();
    let cropped = [0, 1].map(|k| {
        let from = points.iter().map(|point| point[k]).fold(f64::INFINITY, f64::min);
        let to = points.iter().map(|point| point[k]).fold(f64::NEG_INFINITY, f64::max);
        [(from - 0.05 * (to - from)).max(0.0), (to + 0.05 * (to - from)).min([TAU, PI][k])]
    });
    let share: f64 = cropped.iter().map(|[from, to]| to - from).product::<f64>() / (TAU * PI);
    if share < 0.6 { cropped } else { [[0.0, TAU], [0.0, PI]] }
}

#[test]
fn the_ground_is_shaded_as_the_equations_say() {
    for (h, l) in [(2.6, 3.25), (4.675, 3.25), (5.3, 3.25), (3.1486, 2.72)] {
        let portrait = portrait(h, l, SectionCondition::Height);
        let picture = drawn("ground", &scene(&portrait, &[]), &SectionOptions::default());
        let pixels = pixels(&picture);
        let window = window(&portrait);
        let mut seen = [0_usize; 3];
        for (sheet, [left, top, width, height]) in PANELS.into_iter().enumerate() {
            for k in 0..60 * 40 {
                let at = [(f64::from(k % 60) + 0.5) / 60.0 * width, (f64::from(k / 60) + 0.5) / 40.0 * height];
                let kind = |dx: f64, dy: f64| {
                    let share = [(at[0] + dx) / width, (at[1] + dy) / height];
                    let place = [0, 1].map(|k| window[k][0] + share[k] * (window[k][1] - window[k][0]));
                    portrait.rates(SectionChart::Torus, place).map(|rates| rates[sheet] < 0.0)
                };
                // Lines are up to three pixels wide.
                let mut near = (0..32).map(|k| {
                    let angle = f64::from(k % 16) / 16.0 * TAU;
                    let far = if k < 16 { 1.5 } else { 3.0 };
                    [far * angle.cos(), far * angle.sin()]
                });
                if near.any(|[dx, dy]| kind(dx, dy) != kind(0.0, 0.0)) {
                    continue;
                }
                let (number, expected) = match kind(0.0, 0.0) {
                    None => (0, [0xff, 0xff, 0xff]),
                    Some(true) => (1, [0xcd, 0xd5, 0xdf]),
                    Some(false) => (2, [0xf1, 0xee, 0xe6]),
                };
                seen[number] += 1;
                assert_eq!(color(&pixels, left + at[0], top + at[1]), expected, "({h}, {l}) sheet {sheet} at {at:?}");
            }
        }
        assert!(seen.iter().all(|&count| count > 100), "({h}, {l}): {seen:?}");
    }
}

#[test]
fn every_crossing_is_drawn_once_and_where_it_is() {
    let portrait = portrait(4.45, 3.25, SectionCondition::Height);
    let orbits = orbits(&portrait, 1, 60);
    let scene = scene(&portrait, &orbits);
    for raster_above in [0, 1000] {
        let options = SectionOptions { raster_above, point_size: Some(3.0), ..SectionOptions::default() };
        let picture = drawn("one-orbit", &scene, &options);
        assert_eq!(picture.svg.matches("<image").count(), if raster_above == 0 { 2 } else { 0 });
        if raster_above > 0 {
            assert_eq!(picture.svg.matches("h0").count(), orbits[0].points.len());
        }
        let pixels = pixels(&picture);
        let mut looked_at = 0;
        for point in &orbits[0].points {
            let [left, top, width, height] = PANELS[usize::from(point.sheet > 0)];
            let (x, y) = (left + point.psi / TAU * width, top + point.theta / PI * height);
            let [red, _, blue] = color(&pixels, x, y);
            // The frame, ∂U and the line of tangency are drawn over the points.
            let rates = portrait.rates(SectionChart::Torus, [point.psi, point.theta]);
            let at_rim = x - left < 3.0 || left + width - x < 3.0 || y - top < 3.0 || top + height - y < 3.0;
            let on_a_line = at_rim || rates.is_none_or(|rates| rates[usize::from(point.sheet > 0)].abs() < 0.2);
            looked_at += u32::from(!on_a_line);
            assert!(on_a_line || (red < 0x60 && blue > 0x80), "({x}, {y}): red {red}, blue {blue}");
        }
        assert!(looked_at > 30, "only {looked_at} points lie clear of the lines");
    }
}

#[test]
fn a_hundred_thousand_points_make_a_small_file() {
    let portrait = portrait(6.5, 3.25, SectionCondition::Height);
    let orbits = orbits(&portrait, 100, 1000);
    let count: usize = orbits.iter().map(|orbit| orbit.points.len()).sum();
    assert!(count >= 100_000);
    let picture = drawn("dense", &scene(&portrait, &orbits), &SectionOptions::default());
    assert!(picture.svg.len() < 500_000, "{} bytes", picture.svg.len());
    assert_eq!(picture.svg.matches("<image").count(), 2);
    // The image is in the picture and in the PDF.
    let dark = pixels(&picture).pixels().iter().filter(|pixel| pixel.green() < 0x90).count();
    assert!(dark > 20_000, "{dark} dark pixels");
    #[cfg(feature = "pdf")]
    assert!(picture.to_pdf().unwrap().windows(12).any(|bytes| bytes == b"/Subtype/Ima"));
}

#[test]
fn values_colour_orbits_and_have_a_bar() {
    let portrait = portrait(4.45, 3.25, SectionCondition::Height);
    let orbits = orbits(&portrait, 12, 300);
    let values: Vec<f64> = (0..12).map(|k| if k == 3 { f64::NAN } else { 0.02 * f64::from(k) }).collect();
    let picture = drawn("values", &valued(&portrait, &orbits, &values), &SectionOptions::default());
    let texts = texts(&picture);
    assert!(has(&texts, "Lyapunov exponent") && has(&texts, "0.2"), "{texts:?}");
    assert!(picture.svg.contains("stroke=\"#8A8A8A\""), "the orbit without a value is grey");
    let error = draw_section(&valued(&portrait, &orbits, &values[..5]), &SectionOptions::default()).unwrap_err();
    assert!(matches!(error, PlotError::Values { values: 5, orbits: 12, .. }), "{error}");
    for values in [vec![0.25; 12], vec![0.0; 12], vec![f64::NAN; 12]] {
        drawn("one-value", &valued(&portrait, &orbits, &values), &SectionOptions::default());
    }
}

#[test]
fn long_numbers_leave_room_for_the_names_of_panels() {
    let portrait = portrait(3.988_228_955_219_956, 2.789_467_887_626_882, SectionCondition::Height);
    let orbits = orbits(&portrait, 2, 40);
    let texts = texts(&drawn("digits", &scene(&portrait, &orbits), &SectionOptions::default()));
    assert!(
        texts.iter().any(|(text, _)| text.starts_with("h ≈ 3.98823,") && text.ends_with("l ≈ 2.78947")),
        "{texts:?}"
    );
}

#[test]
fn the_sphere_stands_above_the_torus() {
    let portrait = portrait(5.3, 3.25, SectionCondition::Height);
    let orbits = orbits(&portrait, 8, 300);
    let options = SectionOptions { projection: Projection::Both, ..SectionOptions::default() };
    let texts = texts(&drawn("both", &scene(&portrait, &orbits), &options));
    let place = |wanted: &str| texts.iter().find(|(text, _)| text == wanted).map(|(_, area)| area[1]);
    assert!(place("S⁻") < place("T⁻") && place("S⁺") == place("S⁻"));
    assert!(has(&texts, "+r̂, accessible") && has(&texts, "−r̂, accessible"));
}

#[test]
fn the_earlier_section_is_drawn_on_the_sphere() {
    let portrait = portrait(4.45, 3.25, SectionCondition::AngularMomentum);
    let orbits = orbits(&portrait, 16, 300);
    let options = SectionOptions { projection: Projection::Sphere, ..SectionOptions::default() };
    let texts = texts(&drawn("angular-momentum", &scene(&portrait, &orbits), &options));
    assert!(has(&texts, "boundary of the projection"));
    assert!(texts[0].0.ends_with("S = ⟨l, γ×r⟩"), "{}", texts[0].0);
}

#[test]
fn rows_share_a_page_and_none_is_refused() {
    let portraits = [(1.8, 3.25), (6.5, 3.25), (14.0, 7.2)].map(|(h, l)| portrait(h, l, SectionCondition::Height));
    let scenes: Vec<_> = portraits.iter().map(|portrait| scene(portrait, &[])).collect();
    let picture = draw_section_rows(&scenes, &SectionOptions::default()).unwrap();
    let texts = texts(&picture);
    assert_eq!(texts.iter().filter(|(text, _)| text == "T⁺").count(), 3);
    assert_texts_are_apart(&texts);
    assert!(matches!(draw_section_rows(&[], &SectionOptions::default()), Err(PlotError::Scenes { given: 0, .. })));
}

#[test]
fn equal_input_gives_equal_bytes() {
    let picture = || {
        let portrait = portrait(4.675, 3.25, SectionCondition::Height);
        let orbits = orbits(&portrait, 10, 200);
        draw_section(&scene(&portrait, &orbits), &SectionOptions { raster_above: 0, ..SectionOptions::default() })
            .unwrap()
    };
    let (first, second) = (picture(), picture());
    assert_eq!(first, second);
    assert_eq!(first.to_png(96.0).unwrap(), second.to_png(96.0).unwrap());
    #[cfg(feature = "pdf")]
    assert_eq!(first.to_pdf().unwrap(), second.to_pdf().unwrap());
}
