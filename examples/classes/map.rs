//! The graph of classes as a picture.

use std::collections::BTreeMap;
use std::fmt::Write;

use schema::ClassDocument;

const COLUMN: f64 = 90.0;
const ROW: f64 = 15.0;

/// Columns by the number of regions; inside a column in the order that keeps borders short.
pub fn map(classes: &[ClassDocument]) -> String {
    let mut columns: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
    for (k, class) in classes.iter().enumerate() {
        columns.entry(class.regions).or_default().push(k);
    }
    let number: BTreeMap<&str, usize> = classes.iter().enumerate().map(|(k, class)| (class.name.as_str(), k)).collect();
    let beside: Vec<Vec<usize>> = classes
        .iter()
        .map(|class| class.neighbours.iter().filter_map(|n| number.get(n.class.as_str()).copied()).collect())
        .collect();
    let tallest = columns.values().map(Vec::len).max().unwrap_or(1) as f64 * ROW;
    let mut height = vec![0.0; classes.len()];
    let place = |column: &[usize], height: &mut [f64]| {
        for (row, &k) in column.iter().enumerate() {
            height[k] = 0.5 * tallest + ROW * (row as f64 + 0.5 - 0.5 * column.len() as f64);
        }
    };
    for column in columns.values() {
        place(column, &mut height);
    }
    // Each class goes to the mean of those beside it, again and again.
    for _ in 0..24 {
        for column in columns.values_mut() {
            let mean = |k: usize| {
                let near = &beside[k];
                if near.is_empty() {
                    height[k]
                } else {
                    near.iter().map(|&n| height[n]).sum::<f64>() / near.len() as f64
                }
            };
            column.sort_by(|&p, &q| mean(p).total_cmp(&mean(q)).then(p.cmp(&q)));
            place(column, &mut height);
        }
    }
    let first = columns.keys().next().copied().unwrap_or(0);
    let last = columns.keys().last().copied().unwrap_or(0);
    let x = |k: usize| 40.0 + COLUMN * (classes[k].regions - first) as f64;
    let y = |k: usize| 20.0 + height[k];
    let size = [80.0 + COLUMN * (last - first) as f64, tallest + 70.0];
    let mut out = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {} {}\" font-family=\"sans-serif\" font-size=\"11\">\
         <rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>",
        size[0], size[1]
    );
    for (k, class) in classes.iter().enumerate() {
        for neighbour in class.neighbours.iter().filter(|neighbour| neighbour.class > class.name) {
            let Some(&n) = number.get(neighbour.class.as_str()) else { continue };
            let [from, to] = [[x(k), y(k)], [x(n), y(n)]];
            // Inside a column a bow.
            let bow = if from[0] == to[0] { 18.0 } else { 0.0 };
            let half = [0.5 * (from[0] + to[0]) + bow, 0.5 * (from[1] + to[1])];
            let _always = write!(
                out,
                "<path d=\"M{:.0} {:.0}Q{:.0} {:.0} {:.0} {:.0}\" fill=\"none\" stroke=\"{}\" stroke-opacity=\".55\"/>",
                from[0],
                from[1],
                half[0],
                half[1],
                to[0],
                to[1],
                colour(&neighbour.event)
            );
        }
    }
    for (k, class) in classes.iter().enumerate() {
        let size = 2.2 + 0.7 * (7.0 + libm::log10(class.measure.max(1e-7)));
        let _always = write!(
            out,
            "<a href=\"{0}.md\"><circle cx=\"{1:.0}\" cy=\"{2:.0}\" r=\"{size:.1}\" fill=\"#222\"><title>{0}</title></circle></a>",
            class.name,
            x(k),
            y(k)
        );
    }
    for &regions in columns.keys() {
        let (x, y) = (40.0 + COLUMN * (regions - first) as f64, tallest + 40.0);
        let what = if regions == first { " regions" } else { "" };
        let _always = write!(out, "<text x=\"{x:.0}\" y=\"{y:.0}\" text-anchor=\"middle\">{regions}{what}</text>");
    }
    for (place, (name, colour)) in COLOURS.into_iter().enumerate() {
        let (x, y) = (40.0 + 150.0 * place as f64, tallest + 62.0);
        let _always = write!(out, "<text x=\"{x:.0}\" y=\"{y:.0}\" fill=\"{colour}\">{name}</text>");
    }
    out.push_str("</svg>\n");
    out
}

/// What is written in the legend, and its colour.
const COLOURS: [(&str, &str); 6] = [
    ("swallowtail", "#b3322b"),
    ("cusp on a curve", "#2e8b57"),
    ("cusp on a pole line", "#1f5fa8"),
    ("triple point", "#8a5fb0"),
    ("pole lines at infinity", "#c77d1e"),
    ("other", "#555555"),
];

fn colour(event: &str) -> &'static str {
    let kind = if event.contains("swallowtail") {
        0
    } else if event.contains("cusp of") && event.contains(" P") {
        2
    } else if event.contains("cusp of") {
        1
    } else if event.contains("meet in one point") {
        3
    } else if event.contains("J_r") {
        4
    } else {
        5
    };
    COLOURS[kind].1
}
