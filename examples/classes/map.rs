//! The graph of classes as a picture.

use std::collections::BTreeMap;
use std::fmt::{self, Write};

use bifdiag_schema::ClassDocument;

const COLUMN: f64 = 90.0;
const ROW: f64 = 15.0;

/// The picture as SVG.
pub fn map(classes: &[ClassDocument]) -> Result<String, fmt::Error> {
    let plan = Plan::new(classes);
    let [width, height] = [80.0 + COLUMN * (plan.last - plan.first) as f64, plan.tallest + 70.0];
    let mut out = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" font-family=\"sans-serif\" font-size=\"11\">\
         <rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>"
    );
    plan.borders(&mut out)?;
    plan.classes(&mut out)?;
    plan.words(&mut out)?;
    out.push_str("</svg>\n");
    Ok(out)
}

/// Columns by the number of regions; inside a column in the order that keeps borders short.
struct Plan<'a> {
    classes: &'a [ClassDocument],
    number: BTreeMap<&'a str, usize>,
    columns: BTreeMap<usize, Vec<usize>>,
    /// The fewest and the most regions.
    first: usize,
    last: usize,
    /// Height of the tallest column, and of each class.
    tallest: f64,
    height: Vec<f64>,
}

impl<'a> Plan<'a> {
    fn new(classes: &'a [ClassDocument]) -> Self {
        let mut columns: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
        for (k, class) in classes.iter().enumerate() {
            columns.entry(class.regions).or_default().push(k);
        }
        let tallest = columns.values().map(Vec::len).max().unwrap_or(1) as f64 * ROW;
        let [first, last] = [columns.keys().next(), columns.keys().last()].map(|end| end.copied().unwrap_or(0));
        let number = classes.iter().enumerate().map(|(k, class)| (class.name.as_str(), k)).collect();
        let height = vec![0.0; classes.len()];
        let mut plan = Self { classes, number, columns, first, last, tallest, height };
        plan.settle();
        plan
    }

    /// Each class goes to the mean of those beside it, again and again.
    fn settle(&mut self) {
        let number = |name: &str| self.number.get(name).copied();
        let beside: Vec<Vec<usize>> = self
            .classes
            .iter()
            .map(|class| class.neighbours.iter().filter_map(|n| number(&n.class)).collect())
            .collect();
        for round in 0..=24 {
            for column in self.columns.values_mut() {
                if round > 0 {
                    let mean = |k: usize| match beside[k].len() {
                        0 => self.height[k],
                        count => beside[k].iter().map(|&n| self.height[n]).sum::<f64>() / count as f64,
                    };
                    column.sort_by(|&p, &q| mean(p).total_cmp(&mean(q)).then(p.cmp(&q)));
                }
                for (row, &k) in column.iter().enumerate() {
                    self.height[k] = 0.5 * self.tallest + ROW * (row as f64 + 0.5 - 0.5 * column.len() as f64);
                }
            }
        }
    }

    fn across(&self, regions: usize) -> f64 {
        40.0 + COLUMN * (regions - self.first) as f64
    }

    fn place(&self, k: usize) -> [f64; 2] {
        [self.across(self.classes[k].regions), 20.0 + self.height[k]]
    }

    fn borders(&self, out: &mut String) -> fmt::Result {
        for (k, class) in self.classes.iter().enumerate() {
            for neighbour in class.neighbours.iter().filter(|neighbour| neighbour.class > class.name) {
                let Some(&n) = self.number.get(neighbour.class.as_str()) else { continue };
                let ([x0, y0], [x1, y1]) = (self.place(k), self.place(n));
                // Inside a column a bow.
                let bow = if x0 == x1 { 18.0 } else { 0.0 };
                let [x, y] = [0.5 * (x0 + x1) + bow, 0.5 * (y0 + y1)];
                write!(
                    out,
                    "<path d=\"M{x0:.0} {y0:.0}Q{x:.0} {y:.0} {x1:.0} {y1:.0}\" fill=\"none\" stroke=\"{}\" stroke-opacity=\".55\"/>",
                    colour(&neighbour.event)
                )?;
            }
        }
        Ok(())
    }

    fn classes(&self, out: &mut String) -> fmt::Result {
        for (k, class) in self.classes.iter().enumerate() {
            let size = 2.2 + 0.7 * (7.0 + libm::log10(class.measure.max(1e-7)));
            let [x, y] = self.place(k);
            write!(
                out,
                "<a href=\"{0}.md\"><circle cx=\"{x:.0}\" cy=\"{y:.0}\" r=\"{size:.1}\" fill=\"#222\"><title>{0}</title></circle></a>",
                class.name
            )?;
        }
        Ok(())
    }

    /// Numbers of regions, and the legend.
    fn words(&self, out: &mut String) -> fmt::Result {
        for &regions in self.columns.keys() {
            let (x, y) = (self.across(regions), self.tallest + 40.0);
            let what = if regions == self.first { " regions" } else { "" };
            write!(out, "<text x=\"{x:.0}\" y=\"{y:.0}\" text-anchor=\"middle\">{regions}{what}</text>")?;
        }
        for (place, (name, colour)) in COLOURS.into_iter().enumerate() {
            let (x, y) = (40.0 + 150.0 * place as f64, self.tallest + 62.0);
            write!(out, "<text x=\"{x:.0}\" y=\"{y:.0}\" fill=\"{colour}\">{name}</text>")?;
        }
        Ok(())
    }
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
