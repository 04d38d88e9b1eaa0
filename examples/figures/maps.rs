//! The maps of classes.

use std::collections::BTreeMap;
use std::error::Error;

use bifdiag::pictures::{EventScene, Seen, Shown, events, map};
use bifdiag_body::{Body, Preset};
use bifdiag_exact::Accuracy;
use bifdiag_plot::{Map, MapAxis, MapBodies, MapLine, MapNote, Width, draw_map};
use bifdiag_schema::BodyParameter;
use bifdiag_survey::border::{BodySegment, BorderOptions};
use bifdiag_survey::events::follow;
use bifdiag_survey::scan::{ScanRow, known_classes};
use bifdiag_survey::{BodyFamily, Design};
use rayon::prelude::*;
use support::katok;

use crate::figure::{Figure, THEME};

/// Computes a map.
type Make = fn() -> Result<Map, Box<dyn Error>>;

const MAPS: [(&str, Make); 5] = [
    ("map-katok", katok_plane),
    ("map-lagrange-kovalevskaya", lagrange_to_kovalevskaya),
    ("map-paper-r2-r3", paper_off_the_axis),
    ("map-paper-a2-r3", paper_in_the_plane),
    ("map-paper-a2-r3-near", paper_near_the_axis),
];

pub fn figures() -> impl Iterator<Item = Figure> {
    MAPS.into_iter()
        .map(|(stem, make)| Figure { stem, draw: Box::new(move || Ok(draw_map(&make()?, THEME, Width::PAGE)?)) })
}

/// The rows of a grid.
fn rows(family: BodyFamily, vary: &[&str]) -> Result<Vec<ScanRow>, Box<dyn Error>> {
    let mut ranges = Vec::with_capacity(vary.len());
    for text in vary {
        ranges.push(text.parse()?);
    }
    let design = Design::new(family, ranges, None, 0)?;
    Ok((0..design.count()).into_par_iter().map(|n| ScanRow::of(n, design.values(n), Accuracy::Exact)).collect())
}

fn classes_of(family: BodyFamily, vary: &[&str], axes: [BodyParameter; 2]) -> Result<Map, Box<dyn Error>> {
    let seen: Vec<Seen> = rows(family, vary)?.iter().map(|row| Seen::new(row, axes, Shown::Class)).collect();
    Ok(map(&seen, axes, Shown::Class))
}

fn body_family(moments: [&str; 3], center: [&str; 3]) -> Result<BodyFamily, Box<dyn Error>> {
    let body = Body::parse(&moments, &center)?;
    Ok(BodyFamily::Body { moments: body.moments().clone(), center: body.center().clone() })
}

/// The Katok plane. The grid and its halves, quarters and eighths avoid the lines on which bodies are special: A_j = 1,
/// A_j = 3/4, A2 = A3.
fn katok_plane() -> Result<Map, Box<dyn Error>> {
    let vary = ["A2=0.3:1.69:72", "A3=0.305:1.7:72"];
    let mut map = classes_of(BodyFamily::Katok, &vary, [BodyParameter::A2, BodyParameter::A3])?;
    number_as_katok(&mut map);
    map.title = String::from("Tops with the centre of mass on a principal axis: Katok's seven classes");
    map.subtitle = String::from("A = (A1, A2, A3), r = (1, 0, 0); colours: class computed for each of 5184 bodies");
    map.x = MapAxis { name: "A2/A1".to_owned(), range: [0.3, 1.69] };
    map.y = MapAxis { name: "A3/A1".to_owned(), range: [0.305, 1.7] };
    add_exact_borders(&mut map);
    Ok(map)
}

/// Katok's borders in the place of those that were found, and the lines between which bodies exist.
fn add_exact_borders(map: &mut Map) {
    if let MapBodies::Areas { borders, .. } = &mut map.bodies {
        borders.clear();
    }
    let exact = "exact borders: Aⱼ = A1, Aⱼ = ¾A1, 4(1/√(1 − Aⱼ/A1) − 1) = 1/(1 − Aₖ/A1) for Aₖ < Aⱼ";
    for value in katok::LINES {
        for points in [vec![[value, 0.3], [value, 1.7]], vec![[0.3, value], [1.7, value]]] {
            map.lines.push(MapLine { points, text: exact.to_owned(), ..MapLine::default() });
        }
    }
    let curve: Vec<[f64; 2]> = (0..=400)
        .map(|n| 0.25 + 0.5 * f64::from(n) / 400.0)
        .filter_map(|a2| Some([a2, katok::lesser_moment(a2)?]))
        .collect();
    let mirrored = curve.iter().map(|[p, q]| [*q, *p]).collect();
    for points in [curve, mirrored] {
        map.lines.push(MapLine { points, text: exact.to_owned(), ..MapLine::default() });
    }
    let physical = "bodies exist between these lines: |A2 − A3| ≤ A1 ≤ A2 + A3";
    for points in [vec![[0.3, 0.7], [0.7, 0.3]], vec![[0.3, 1.3], [0.7, 1.7]], vec![[1.3, 0.3], [1.7, 0.7]]] {
        let text = physical.to_owned();
        map.lines.push(MapLine { points, dashed: true, text, ..MapLine::default() });
    }
}

/// Gives Katok's classes their numbers, and each the same colour in every map, in this order.
fn number_as_katok(map: &mut Map) {
    let known: BTreeMap<String, &str> =
        known_classes().into_iter().map(|(class, preset)| (class.to_string(), preset.name())).collect();
    for entry in &mut map.entries {
        let Some(preset) = known.get(&entry.key) else { continue };
        let Some(number) = preset.strip_prefix("katok:").and_then(|number| number.parse::<usize>().ok()) else {
            continue;
        };
        entry.mark = number.to_string();
        entry.color = Some(number.saturating_sub(1));
        entry.note = entry.note.split(';').next().unwrap_or_default().to_owned();
        entry.name = format!("{preset}, {}", entry.name);
    }
    let mut order: Vec<usize> = (0..map.entries.len()).collect();
    order.sort_by(|&p, &q| map.entries[p].name.cmp(&map.entries[q].name));
    reorder(map, &order);
}

/// Puts the entries into another order.
fn reorder(map: &mut Map, order: &[usize]) {
    map.entries = order.iter().map(|&entry| map.entries[entry].clone()).collect();
    let place: BTreeMap<usize, usize> = order.iter().enumerate().map(|(new, old)| (*old, new)).collect();
    map.bodies.renumber(|entry| place.get(&entry).copied().unwrap_or(entry));
}

/// The range of η of the map from Lagrange to Kovalevskaya.
const ETA: [f64; 2] = [0.8, 2.2];

/// Its range of l.
const L: [f64; 2] = [1.3, 3.3];

/// A = (2, η, 1), r = (1, 0, 0): the classes over η, the momenta of all events, and what happens at the borders.
fn lagrange_to_kovalevskaya() -> Result<Map, Box<dyn Error>> {
    const BODIES: usize = 1120;
    let end = |eta: f64| Body::from_f64([2.0, eta, 1.0], [1.0, 0.0, 0.0]);
    let segment = BodySegment::new(end(ETA[0])?, end(ETA[1])?);
    let tracks = follow(&segment, BODIES, &BorderOptions::default());
    let mut map = events(&EventScene { tracks: &tracks, segment: &segment, parameter: BodyParameter::A2, l: L });
    number_as_katok(&mut map);
    map.title = String::from("From Lagrange (A2 = 1) to Kovalevskaya (A2 = 2)");
    map.subtitle.push_str("; L+, L−: from +r̂, −r̂; S2, S3: pair over axis 2, 3");
    Ok(map)
}

/// The paper's body, r2 and r3 varied.
fn paper_off_the_axis() -> Result<Map, Box<dyn Error>> {
    let family = body_family(["2", "1.1", "1"], ["0.94868", "0", "0"])?;
    let vary = ["r2=0.0002:0.15:70", "r3=0.001:0.7:70"];
    let mut map = classes_of(family, &vary, [BodyParameter::R2, BodyParameter::R3])?;
    map.title = String::from("Around the paper's body: the centre of mass leaves the axis");
    map.subtitle = String::from("A = (2, 1.1, 1), r = (0.94868, r2, r3); the paper's body has r2 = 0, r3 = 0.61623");
    map.notes.push(MapNote { at: [0.0, 0.61623], text: "the paper's body".to_owned(), hue: 0, ring: true });
    Ok(map)
}

/// The plane r2 = 0 of the paper's body, A2 and r3 varied.
fn plane(vary: [&str; 2]) -> Result<Map, Box<dyn Error>> {
    let paper = Preset::find("paper").map(Preset::body);
    let center = paper.map(|body| body.center()[0].text().to_owned()).unwrap_or_default();
    let family = body_family(["2", "1.1", "1"], [&center, "0", "0"])?;
    classes_of(family, &vary, [BodyParameter::A2, BodyParameter::R3])
}

/// Where the classes are few.
fn paper_in_the_plane() -> Result<Map, Box<dyn Error>> {
    let mut map = plane(["A2=0.5:2.5:60", "r3=0.13:1:60"])?;
    map.title = String::from("Around the paper's body: the plane r2 = 0");
    map.subtitle = String::from("A = (2, A2, 1), r = (0.94868, 0, r3); the paper's body has A2 = 1.1, r3 = 0.61623");
    map.notes.push(MapNote { at: [1.1, 0.61623], text: "the paper's body".to_owned(), hue: 0, ring: true });
    Ok(map)
}

/// Where they crowd.
fn paper_near_the_axis() -> Result<Map, Box<dyn Error>> {
    let mut map = plane(["A2=0.72:1.2:60", "r3=0.02:0.14:60"])?;
    map.title = String::from("Around the paper's body: the plane r2 = 0 near the axis");
    map.subtitle =
        String::from("A = (2, A2, 1), r = (0.94868, 0, r3): the lower left of the map for larger r3, magnified");
    Ok(map)
}

#[cfg(test)]
mod tests {
    use bifdiag_plot::Theme;

    use super::*;
    use crate::reading::picture_letters::unprintable;
    use crate::reading::picture_texts::{assert_texts_are_apart, texts};

    #[test]
    fn every_map_can_be_read_on_a_page_and_in_a_column() {
        for make in MAPS.map(|(_, make)| make) {
            let map = make().unwrap();
            for width in Width::ALL {
                let picture = draw_map(&map, Theme::Light, width).unwrap();
                assert_eq!(unprintable(&picture, width), Vec::<String>::new(), "{}", map.title);
                let texts = texts(&picture);
                assert_texts_are_apart(&texts);
                let inside = |value: f64, [from, to]: [f64; 2]| value > from && value < to;
                let is_seen = |[x, y]: &[f64; 2]| inside(*x, map.x.range) && inside(*y, map.y.range);
                for line in map.lines.iter().filter(|line| !line.name.is_empty()) {
                    let is_named = texts.iter().any(|(text, _)| *text == line.name);
                    assert_eq!(is_named, line.points.iter().any(is_seen), "{} of {}", line.name, map.title);
                }
            }
        }
    }
}
