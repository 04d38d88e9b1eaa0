//! Pictures of atlases.
#![allow(clippy::disallowed_methods, clippy::cast_precision_loss)]

mod picture_svg;
mod picture_texts;
mod plot_fixture;

use bifdiag_plot::{DiagramOptions, DiagramView, Picture, PlotError, Width, draw};
use bifdiag_schema::WindowDocument;
use picture_svg::PIXELS_PER_INCH;
use picture_texts::{assert_texts_are_apart, texts};
use plot_fixture::{Fixture, kovalevskaya, paper, parabolas};
use resvg::tiny_skia::Pixmap;

fn picture(name: &str, fixture: &Fixture) -> Picture {
    // In the plane: straightened diagrams have tests of their own.
    let options = DiagramOptions { view: DiagramView::Plane, ..DiagramOptions::default() };
    let picture = draw(&fixture.atlas, Some(fixture), &options).expect("the fixture can be drawn");
    // For the eye: set PLOT_OUT to a directory.
    if let Some(out) = std::env::var_os("PLOT_OUT").map(std::path::PathBuf::from) {
        std::fs::write(out.join(format!("{name}.svg")), &picture.svg).unwrap();
        std::fs::write(out.join(format!("{name}.png")), picture.to_png(144.0).unwrap()).unwrap();
        #[cfg(feature = "pdf")]
        std::fs::write(out.join(format!("{name}.pdf")), picture.to_pdf().unwrap()).unwrap();
    }
    picture
}

fn assert_sound(fixture: &Fixture, picture: &Picture) {
    assert!(!picture.svg.contains("NaN") && !picture.svg.contains("inf"), "a coordinate is not a number");
    let texts = texts(picture);
    for region in &fixture.atlas.regions {
        let with_region = format!("{}, U = ", region.id);
        let label = |text: &str| text == region.id || text.starts_with(&with_region);
        assert!(texts.iter().any(|(text, _)| label(text)), "region {} has no label", region.id);
    }
    assert_texts_are_apart(&texts);
}

#[test]
fn the_papers_body_has_nine_labelled_regions() {
    let fixture = paper();
    assert_eq!(fixture.atlas.regions.len(), 9);
    let picture = picture("paper", &fixture);
    assert_sound(&fixture, &picture);
    let texts = texts(&picture);
    for kind in ["S²", "T²", "S²+T²", "T²+T²", "M²₃", "M²₂", "S²+S²"] {
        assert!(texts.iter().any(|(text, _)| text == kind), "{kind} is not printed");
    }
}

#[test]
fn kovalevskayas_body_with_coincident_curves() {
    let fixture = kovalevskaya();
    let picture = picture("kovalevskaya", &fixture);
    assert_sound(&fixture, &picture);
    assert!(texts(&picture).iter().any(|(text, _)| text == "in turn: coincident"));
}

#[test]
fn one_region_above_one_curve() {
    let fixture = parabolas(&[(1.0, 0.0)]);
    assert_eq!(fixture.atlas.regions.len(), 1);
    assert_sound(&fixture, &picture("one-region", &fixture));
}

#[test]
fn without_a_section_the_accessible_region_is_printed() {
    let fixture = parabolas(&[(3.0, 0.0), (2.0, 0.0), (1.0, 0.0)]);
    let picture = picture("euler", &fixture);
    assert_sound(&fixture, &picture);
    assert_eq!(texts(&picture).iter().filter(|(text, _)| text == "U: D²").count(), 3);
}

#[test]
fn a_region_a_million_times_smaller_than_the_picture_has_its_panel() {
    let fixture = parabolas(&[(2.0, 0.0), (1.5, -0.3), (1.0, -0.9 + 1e-6)]);
    assert_eq!(fixture.atlas.events.len(), 3);
    let picture = picture("tiny", &fixture);
    assert_sound(&fixture, &picture);
}

#[test]
fn every_scale_is_drawn() {
    for (name, lines) in [
        ("rod", vec![(1e-6, 1.2), (2.0, -1.0), (1.1, -0.2), (2.0, 1.0)]),
        ("large", vec![(2.0, -1e6), (1.5, -1.2e6), (1.0, 1e6), (1.1, 0.3e6)]),
        ("small", vec![(2.0, -1e-6), (1.5, -1.2e-6), (1.0, 1e-6), (1.1, 0.3e-6)]),
        ("many", vec![(2.0, 1.0), (1.7, 0.69), (1.4, 0.3), (1.2, -0.1), (1.0, -0.62), (0.8, -1.42)]),
    ] {
        let fixture = parabolas(&lines);
        assert_sound(&fixture, &picture(name, &fixture));
    }
}

#[test]
fn a_region_below_the_resolution_of_f64_is_named_in_a_note() {
    let fixture = parabolas(&[(2.0, -1.0), (2.0, 1.0), (2.0, 1.0 + 4e-15), (1.0, 1.5)]);
    let picture = picture("below-resolution", &fixture);
    assert!(picture.svg.contains("Too narrow to be drawn: "));
}

#[test]
fn equal_input_gives_equal_bytes_in_every_format() {
    let (first, second) = (picture("paper", &paper()), picture("paper", &paper()));
    assert_eq!(first, second);
    assert_eq!(first.to_png(96.0).unwrap(), second.to_png(96.0).unwrap());
}

#[test]
fn text_is_drawn_where_no_fonts_are_installed() {
    // Nothing is read from the machine: the title must still leave ink on the page.
    let picture = picture("kovalevskaya", &kovalevskaya());
    let png = Pixmap::decode_png(&picture.to_png(f64::from(PIXELS_PER_INCH)).unwrap()).unwrap();
    let dark = |x: u32, y: u32| png.pixel(x, y).is_some_and(|pixel| pixel.red() < 100);
    let ink = (10..34).flat_map(|y| (50..350).map(move |x| (x, y))).filter(|&(x, y)| dark(x, y)).count();
    assert!(ink > 200, "{ink} dark pixels in the title");
}

#[test]
fn a_column_is_86_mm_wide() {
    let options = DiagramOptions { width: Width::COLUMN, ..DiagramOptions::default() };
    let fixture = paper();
    let picture = draw(&fixture.atlas, Some(&fixture), &options).unwrap();
    assert!(picture.svg.contains(" width=\"86mm\""), "{}", picture.svg.lines().next().unwrap());
}

#[test]
fn png_follows_the_resolution() {
    let picture = picture("kovalevskaya", &kovalevskaya());
    let size = |dpi: f64| {
        let png = Pixmap::decode_png(&picture.to_png(dpi).unwrap()).unwrap();
        [png.width(), png.height()]
    };
    let (one, two) = (size(100.0), size(200.0));
    assert!((0..2).all(|side| two[side] - 2 * one[side] <= 1), "{one:?} and {two:?}");
    let millimetres = |side: &str| {
        let (_, rest) = picture.svg.split_once(&format!(" {side}=\"")).unwrap();
        rest.split_once("mm\"").unwrap().0.parse::<f64>().unwrap()
    };
    for (side, dots) in ["width", "height"].into_iter().zip(one) {
        let exact = millimetres(side) / 25.4 * 100.0;
        assert!((exact - f64::from(dots)).abs() <= 1.0, "{side}: {dots} for {exact} dots");
    }
    // pHYs: 3937 dots in a metre, twice, and the unit.
    let png = picture.to_png(100.0).unwrap();
    let at = png.windows(4).position(|bytes| bytes == b"pHYs").expect("the PNG says how large it is") + 4;
    assert_eq!(png[at..at + 9], [0, 0, 15, 97, 0, 0, 15, 97, 1]);
    for dpi in [0.0, -1.0, f64::NAN, 1e9] {
        assert!(matches!(picture.to_png(dpi), Err(PlotError::Resolution { .. })), "{dpi} dpi");
    }
}

#[cfg(feature = "pdf")]
#[test]
fn pdf_is_pdf_and_equal_input_gives_equal_bytes() {
    let [first, second] = [paper(), paper()].map(|fixture| picture("paper", &fixture).to_pdf().unwrap());
    assert!(first.starts_with(b"%PDF-"));
    assert_eq!(first, second);
}

#[cfg(not(feature = "pdf"))]
#[test]
fn pdf_names_the_feature_that_is_missing() {
    let error = picture("kovalevskaya", &kovalevskaya()).to_pdf().unwrap_err();
    assert!(matches!(error, PlotError::NoPdf), "{error:?}");
    assert!(error.to_string().contains("the feature `pdf`"), "{error}");
}

#[test]
fn a_window_clips_the_picture_and_lists_what_lies_outside() {
    let fixture = paper();
    let window = WindowDocument { h: [3.0, 6.0], l: [3.0, 3.5] };
    let picture =
        draw(&fixture.atlas, Some(&fixture), &DiagramOptions { window: Some(window), ..DiagramOptions::default() })
            .unwrap();
    let texts = texts(&picture);
    assert!(texts.iter().any(|(text, _)| text.starts_with("Outside the window:")));
    assert!(texts.iter().any(|(text, _)| text == "M²₃"));
    assert!(!texts.iter().any(|(text, _)| text == "S²+S²"), "that region lies above l = 6.88");
}

#[test]
fn without_a_source_the_documents_polylines_are_drawn() {
    let fixture = paper();
    let picture = draw(&fixture.atlas, None, &DiagramOptions::default()).unwrap();
    assert_sound(&fixture, &picture);
}

#[test]
fn documents_whose_parts_do_not_fit_are_refused() {
    let mut broken = paper().atlas;
    broken.regions[0].cells[0].lower = "c99".to_owned();
    let error = draw(&broken, None, &DiagramOptions::default()).unwrap_err();
    assert!(error.to_string().contains("c99"), "{error}");
    let mut bare = paper().atlas;
    bare.drawing.as_mut().unwrap().curves.clear();
    assert!(matches!(draw(&bare, None, &DiagramOptions::default()), Err(PlotError::NoPolyline { .. })));
    bare.drawing = None;
    assert!(matches!(draw(&bare, None, &DiagramOptions::default()), Err(PlotError::NoDrawing)));
    let window = WindowDocument { h: [1.0, 1.0], l: [0.0, 1.0] };
    let empty = draw(&paper().atlas, None, &DiagramOptions { window: Some(window), ..DiagramOptions::default() });
    assert!(matches!(empty, Err(PlotError::EmptyWindow { .. })));
}

#[test]
fn an_event_far_out_gets_an_overview_and_does_not_hide_the_others() {
    // Five crossings at l < 0.4; the first and the last curve, nearly parallel, cross at l = 9.5.
    let fixture = parabolas(&[(1.0, 0.0), (0.8, -0.01), (0.6, -0.04), (0.999_8, -0.009)]);
    let [near, far] = [true, false].map(|least| {
        let places = fixture.atlas.events.iter().map(|event| event.l);
        if least { places.fold(f64::INFINITY, f64::min) } else { places.fold(0.0, f64::max) }
    });
    assert!(far > 20.0 * near, "the fixture has no event far out: {near}, {far}");
    let picture = picture("far-out", &fixture);
    assert_sound(&fixture, &picture);
    assert!(texts(&picture).iter().any(|(text, _)| text.contains("overview, main panel framed")));
}

#[test]
fn sections_of_one_type_over_different_regions_are_told_apart() {
    let mut fixture = paper();
    let tori = fixture.atlas.regions.iter_mut().filter(|region| region.signature.as_deref() == Some("T2"));
    let largest = tori.last().expect("the paper's body has sections T²");
    largest.components[0].accessible_region = "S2".to_owned();
    let picture = picture("over-different-regions", &fixture);
    assert_sound(&fixture, &picture);
    let texts = texts(&picture);
    for wanted in [", U = D²", ", U = S²"] {
        assert!(texts.iter().any(|(text, _)| text.ends_with(wanted)), "{wanted} is not printed");
    }
}

#[test]
fn every_part_of_the_svg_can_be_found_and_says_what_it_is() {
    let fixture = paper();
    let svg = picture("paper", &fixture).svg;
    let ids: Vec<&str> = svg.split(" id=\"").skip(1).filter_map(|rest| rest.split('"').next()).collect();
    let distinct: std::collections::BTreeSet<&&str> = ids.iter().collect();
    assert_eq!(ids.len(), distinct.len(), "an id occurs twice");
    for region in &fixture.atlas.regions {
        let id = format!("id=\"main-{}\"", region.id);
        let own = svg.lines().find(|line| line.contains(&id)).unwrap_or_else(|| panic!("{id} is missing"));
        assert!(own.contains(&format!("<title>{}: ", region.id)) && own.ends_with("</path>"), "{own}");
        assert!(own.matches('z').count() >= 1, "{} is not closed", region.id);
    }
    assert!(svg.contains("id=\"main-curve-"), "curves have ids");
    assert!(svg.contains("stroke-dasharray"), "dashes are attributes");
    // Dashes as lines of their own would be hundreds.
    assert!(svg.matches("<polyline").count() + svg.matches("<path").count() < 200, "many paths");
    assert!(svg.contains("<metadata>A = (2, 1.1, 1), r = (0.94868, 0, 0.61623)"));
}

#[test]
fn tikz_has_the_same_parts_alone_and_as_a_document() {
    let fixture = paper();
    let picture = picture("paper", &fixture);
    let alone = picture.to_tikz().unwrap();
    let tikz = picture.to_latex().unwrap();
    assert!(tikz.contains(&alone) && alone.matches("\\begingroup").count() == alone.matches("\\endgroup").count());
    assert!(tikz.starts_with("\\documentclass") && tikz.ends_with("\\end{document}\n"));
    assert_eq!(tikz.matches("\\begin{scope}").count(), tikz.matches("\\end{scope}").count());
    assert!(tikz.contains("$M^{2}_{3}$") && tikz.contains("+$\\hat{r}$ enters $U$"), "texts are formulas");
    assert!(tikz.contains("% main-R1\n") || tikz.contains("% main-regions\n"), "groups are named");
    for line in tikz.lines().map(str::trim).filter(|line| line.starts_with("\\path") || line.starts_with("\\node")) {
        assert!(line.ends_with(';'), "{line}");
        assert_eq!(line.matches('{').count(), line.matches('}').count(), "{line}");
        assert!(!line.contains("NaN") && line.is_ascii(), "{line}");
    }
    let number = |before: &str, behind: &str| -> f64 {
        let (_, rest) = tikz.split_once(before).unwrap();
        rest.split_once(behind).unwrap().0.parse().unwrap()
    };
    let width = number("tikzpicture}[x=", "bp") * number("rectangle (", ",") / 72.0 * 25.4;
    assert!((width - Width::PAGE.millimetres()).abs() < 1.0, "{width} mm in print");
    // Stripes of 5 pixels; nothing but the picture has a width.
    let distance = number("distance=", "bp") / number("tikzpicture}[x=", "bp");
    assert!((distance - 10.0).abs() < 0.1, "stripes repeat after {distance} pixels");
    let (head, _) = tikz.split_once("\\begin{tikzpicture}").unwrap();
    let (_, before) = head.split_once("\\begin{document}\n").unwrap();
    assert!(before.lines().all(|line| line.starts_with('%') || line.ends_with('%')), "{before}");
    let used: Vec<&str> = tikz.split("draw=").skip(1).filter_map(|rest| rest.split([',', ']']).next()).collect();
    assert!(used.iter().all(|name| tikz.contains(&format!("\\definecolor{{{name}}}"))), "a colour is not defined");
}

#[test]
fn themes_change_colours_and_nothing_else() {
    let fixture = paper();
    let with = |theme| {
        let options = DiagramOptions { theme, ..DiagramOptions::default() };
        draw(&fixture.atlas, Some(&fixture), &options).unwrap().svg
    };
    let [light, dark, print] =
        [bifdiag_plot::Theme::Light, bifdiag_plot::Theme::Dark, bifdiag_plot::Theme::Print].map(with);
    let colorless = |svg: &str| -> String {
        let mut parts = svg.split('#');
        let first = parts.next().unwrap_or_default().to_owned();
        let rest = |part: &str| if part.starts_with("stripes") { part.to_owned() } else { part[6..].to_owned() };
        parts.fold(first, |text, part| text + "#" + &rest(part))
    };
    assert!(light != dark && dark != print && light != print);
    assert_eq!(colorless(&light), colorless(&dark));
    assert_eq!(colorless(&light), colorless(&print));
    assert!(light.contains("height=\"100%\" fill=\"#FFFFFF\""));
    assert!(!dark.contains("height=\"100%\" fill=\"#FFFFFF\""));
}
