//! Maps: every entry is numbered or listed with its place, and everything can be read.

mod picture_letters;
mod picture_svg;
mod picture_texts;

use bifdiag_plot::{Map, MapAxis, MapBodies, MapEntry, MapLine, Picture, Theme, Width, draw_map};
use picture_letters::unprintable;
use picture_texts::{assert_texts_are_apart, texts};

type Piece = (Option<usize>, Vec<[f64; 2]>);

fn area(entry: usize, from: [f64; 2], to: [f64; 2]) -> Piece {
    (Some(entry), vec![from, [to[0], from[1]], to, [from[0], to[1]]])
}

fn map(entries: usize, bodies: MapBodies) -> Map {
    let entry = |number: usize| MapEntry {
        name: format!("{:012x}", 0x1234_5678_9abc_u64 + 0x1_1111 * number as u64),
        note: format!("{} regions, below 0.1%", 9 + number % 16),
        mark: (number + 1).to_string(),
        key: String::new(),
        color: Some(number),
    };
    let axis = |name: &str| MapAxis { name: name.to_owned(), range: [0.5, 1.5] };
    Map {
        title: "A map".to_owned(),
        subtitle: "of areas".to_owned(),
        x: axis("A2"),
        y: axis("r3"),
        entries: (0..entries).map(entry).collect(),
        ordered: false,
        unknown: String::new(),
        bodies,
        impossible: Vec::new(),
        lines: Vec::new(),
        notes: Vec::new(),
        key: Vec::new(),
    }
}

/// One wide area, and in a corner squares that become smaller by a fifth each, far below a pixel.
fn corner(count: usize) -> Map {
    let mut pieces = vec![area(0, [0.6, 0.6], [1.5, 1.5])];
    let side = |k: usize| 0.1 * libm::pow(0.8, k as f64);
    pieces.extend((1..count).map(|k| area(k, [0.5 + side(k), 0.5], [0.5 + side(k - 1), 0.5 + side(k)])));
    let middle = |k: usize| [0.5 + 0.5 * (side(k) + side(k - 1)), 0.5 + 0.5 * side(k)];
    let seen = (1..count).map(|k| (k, middle(k))).chain([(0, [1.0, 1.0])]).collect();
    map(count, MapBodies::Areas { pieces, seen, borders: vec![[[0.6, 0.6], [1.5, 0.6]]], legend: "borders".to_owned() })
}

#[test]
fn every_class_of_a_crowded_map_has_a_number_or_a_place() {
    for (count, width) in [5, 40, 130].into_iter().flat_map(|count| Width::ALL.map(|width| (count, width))) {
        let map = corner(count);
        let picture = draw_map(&map, Theme::Light, width).unwrap();
        let texts = texts(&picture);
        let mut placed = 0;
        for entry in &map.entries {
            let legend = &entry.name;
            // A name may be listed by its first digits.
            let is_name = |text: &str| text.len() >= 6 && legend.starts_with(text);
            let at = texts.iter().position(|(text, _)| is_name(text));
            let at = at.unwrap_or_else(|| panic!("{legend} of {count} is not in the legend"));
            assert_eq!(texts[at - 1].0, entry.mark);
            let is_placed = texts[at + 1].0.trim_start_matches("at ").starts_with('(');
            placed += usize::from(is_placed);
            let is_marked = texts.iter().filter(|(text, _)| *text == entry.mark).count() > 1;
            assert!(is_marked || is_placed, "{legend} of {count} is nowhere");
            assert!(!is_placed || texts.iter().any(|(text, _)| text.starts_with("at (A₂, r₃):")));
        }
        assert_eq!(placed > 0, count > 20, "{placed} of {count}");
        // No page holds the places of so many; the picture tells its height.
        let faults = unprintable(&picture, width);
        assert_eq!(!faults.is_empty(), picture.millimetres_high() > Picture::HIGHEST, "{faults:?}");
        assert!(count > 100 || faults.is_empty(), "{faults:?}");
        assert_texts_are_apart(&texts);
    }
}

#[test]
fn a_hundred_classes_fit_both_widths() {
    let count = 110;
    let step = |k: usize| 0.5 + 0.009 * k as f64;
    let points = (0..count).map(|k| ([step(k), step(k * 37 % count)], Some(k))).collect();
    let map = map(count, MapBodies::Points(points));
    for width in Width::ALL {
        let picture = draw_map(&map, Theme::Light, width).unwrap();
        assert_texts_can_be_read(&picture, width);
        let texts = texts(&picture);
        let is_listed = |entry: &MapEntry, start: &str| start.len() >= 6 && entry.name.starts_with(start);
        for entry in &map.entries {
            let listed: Vec<_> = texts.iter().filter(|(text, _)| is_listed(entry, text)).collect();
            let others =
                map.entries.iter().filter(|other| listed.iter().any(|(text, _)| is_listed(other, text))).count();
            assert_eq!((listed.len(), others), (1, 1), "{}", entry.name);
        }
    }
}

/// The picture fits a page, and no text is too small in print, leaves the page or covers another.
fn assert_texts_can_be_read(picture: &Picture, width: Width) {
    assert_eq!(unprintable(picture, width), Vec::<String>::new());
    assert_texts_are_apart(&texts(picture));
}

#[test]
fn long_texts_stand_in_lines() {
    let mut map = corner(5);
    let long = |what: &str| format!("{what}: {}", "words that go on and on, ".repeat(9));
    (map.title, map.subtitle) = (long("a title"), long("a subtitle"));
    let points = vec![[0.5, 0.5], [1.5, 1.4]];
    map.lines = vec![MapLine { points, text: long("a line"), name: "its name".to_owned(), ..MapLine::default() }];
    for width in Width::ALL {
        let picture = draw_map(&map, Theme::Light, width).unwrap();
        assert_texts_can_be_read(&picture, width);
        let all: String = texts(&picture).into_iter().map(|(text, _)| text + " ").collect();
        for text in [&map.title, &map.subtitle, &map.lines[0].text, &map.lines[0].name] {
            assert!(all.contains(text.trim()), "{text} is not listed");
        }
    }
}

#[test]
fn a_cell_without_room_for_its_number_is_told_with_its_place() {
    let columns = 50;
    let entries = (0..columns * columns).map(|cell| Some(usize::from(cell == 51))).collect();
    let picture = draw_map(&map(2, MapBodies::Grid { columns, entries }), Theme::Light, Width::PAGE).unwrap();
    let texts = texts(&picture);
    let is_counted = texts.iter().filter(|(text, _)| text == "2").count() > 1
        || texts.iter().any(|(text, _)| text == "at (0.53, 0.53)");
    assert!(is_counted, "{texts:?}");
}
