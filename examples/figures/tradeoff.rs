//! The charts of what accuracy costs, from the tables of `data/tradeoff/`.

use std::collections::BTreeMap;

use csv::StringRecord;

use crate::chart::{Chart, ChartAxis, ChartPanel, Scale, Series, draw_chart};
use crate::figure::{Figure, THEME};

const CLASSIFY: &str = include_str!("../../data/tradeoff/classify.csv");
const ATLAS: &str = include_str!("../../data/tradeoff/atlas.csv");
const ORBITS: &str = include_str!("../../data/tradeoff/orbits.csv");
const POLYLINES: &str = include_str!("../../data/tradeoff/polylines.csv");

type Draw = fn() -> Result<Chart, csv::Error>;

const CHARTS: [(&str, Draw); 4] = [
    ("tradeoff-classify", classify),
    ("tradeoff-atlas", atlas),
    ("tradeoff-orbits", orbits),
    ("tradeoff-polylines", polylines),
];

pub fn figures() -> impl Iterator<Item = Figure> {
    CHARTS.into_iter().map(|(stem, draw)| Figure { stem, draw: Box::new(move || Ok(draw_chart(&draw()?, THEME)?)) })
}

/// A table with a head.
struct Table {
    columns: StringRecord,
    rows: Vec<StringRecord>,
}

impl Table {
    fn new(text: &str) -> Result<Self, csv::Error> {
        let mut reader = csv::Reader::from_reader(text.as_bytes());
        Ok(Self { columns: reader.headers()?.clone(), rows: reader.into_records().collect::<Result<_, _>>()? })
    }

    fn text<'a>(&self, row: &'a StringRecord, column: &str) -> &'a str {
        let at = self.columns.iter().position(|name| name == column);
        at.and_then(|at| row.get(at)).unwrap_or_default()
    }

    /// NaN, which is not drawn, for an empty cell.
    fn number(&self, row: &StringRecord, column: &str) -> f64 {
        self.text(row, column).parse().unwrap_or(f64::NAN)
    }

    /// A series for each name in a column, from the rows that are chosen. A line joins the points of a series where x goes
    /// one way; where it does not, it is measured no better than the points lie apart.
    fn series(
        &self,
        column: &str,
        names: &[&str],
        choose: impl Fn(&StringRecord) -> bool,
        point: impl Fn(&StringRecord) -> [f64; 2],
    ) -> Vec<Series> {
        let of = |name: usize| {
            let rows = self.rows.iter().filter(|row| self.text(row, column) == names[name] && choose(row));
            let points: Vec<[f64; 2]> = rows.map(&point).collect();
            let joined = points.is_sorted_by(|p, q| p[0] <= q[0]) || points.is_sorted_by(|p, q| p[0] >= q[0]);
            Series { name, points, joined, intervals: Vec::new() }
        };
        (0..names.len()).map(of).collect()
    }

    /// For each method the share of what is counted in all rows of each group, with its confidence interval; x is the
    /// geometric mean over the group, a little aside for each method where `aside` is not 0.
    fn shares(
        &self,
        names: &[&str],
        [counted, of]: [&[&str]; 2],
        x: &str,
        aside: f64,
        group: impl Fn(&StringRecord) -> Option<i32>,
    ) -> Vec<Series> {
        let series = |name: usize| {
            let mut groups: BTreeMap<i32, Vec<&StringRecord>> = BTreeMap::new();
            for row in self.rows.iter().filter(|row| self.text(row, "method") == names[name]) {
                if let Some(group) = group(row) {
                    groups.entry(group).or_default().push(row);
                }
            }
            let sum = |rows: &[&StringRecord], columns: &[&str]| {
                rows.iter().flat_map(|row| columns.iter().map(|column| self.number(row, column))).sum::<f64>()
            };
            let shift = libm::exp10(aside * (name as f64 - 0.5 * (names.len() - 1) as f64));
            let mut points = Vec::new();
            let mut intervals = Vec::new();
            for rows in groups.values() {
                let logs: f64 = rows.iter().map(|row| libm::log(self.number(row, x))).sum();
                let (count, all) = (sum(rows, counted), sum(rows, of));
                points.push([libm::exp(logs / rows.len() as f64) * shift, 100.0 * count / all]);
                intervals.push(wilson(count, all).map(|share| 100.0 * share));
            }
            Series { name, points, joined: false, intervals }
        };
        (0..names.len()).map(series).collect()
    }

    /// The names with the number of what each method was tried on.
    fn counted(&self, names: &[&str], of: &str) -> Vec<String> {
        let total = |name: &str| {
            let rows = self.rows.iter().filter(|row| self.text(row, "method") == name);
            rows.map(|row| self.number(row, of)).sum::<f64>()
        };
        names.iter().map(|name| format!("{} ({} {of})", times(name), total(name))).collect()
    }
}

/// Wilson's 95 % confidence interval of a share of which `count` of `all` were seen.
fn wilson(count: f64, all: f64) -> [f64; 2] {
    const Z: f64 = 1.959_963_984_540_054;
    let share = count / all;
    let middle = share + Z * Z / (2.0 * all);
    let half = Z * (share * (1.0 - share) / all + Z * Z / (4.0 * all * all)).sqrt();
    [-half, half].map(|half| ((middle + half) / (1.0 + Z * Z / all)).clamp(0.0, 1.0))
}

fn axis(label: &str, scale: Scale) -> ChartAxis {
    ChartAxis { label: label.to_owned(), scale }
}

/// A name with a true sign between the two sides of a grid.
fn times(name: &str) -> String {
    let sides = |word: &str| match word.split_once('x') {
        Some((wide, high)) if wide.parse::<u32>().is_ok() && high.parse::<u32>().is_ok() => format!("{wide}×{high}"),
        _ => word.to_owned(),
    };
    name.split(' ').map(sides).collect::<Vec<_>>().join(" ")
}

fn names(names: &[&str]) -> Vec<String> {
    names.iter().map(|name| (*name).to_owned()).collect()
}

/// What is not answered: undecided, or without any answer.
const OPEN: [&str; 2] = ["undecided", "failed"];

fn classify() -> Result<Chart, csv::Error> {
    const METHODS: [&str; 6] =
        ["fast", "exact", "companion matrix", "flood fill 32x64", "flood fill 96x192", "flood fill 256x512"];
    let table = Table::new(CLASSIFY)?;
    let beside = |row: &StringRecord| {
        let distance = libm::log10(table.number(row, "distance")).round();
        #[expect(clippy::cast_possible_truncation, reason = "a few decades; a NaN is not finite")]
        let decade = distance as i32;
        (table.text(row, "stratum") == "generic" && distance.is_finite()).then_some(decade)
    };
    let random = |row: &StringRecord| table.text(row, "distance").is_empty().then_some(0);
    let panel = |title: &str, counted: &'static [&'static str]| ChartPanel {
        title: title.to_owned(),
        x: axis("relative distance from a curve", Scale::Descending),
        y: axis("% of generic points; bars: 95 % confidence", Scale::Percent),
        series: table.shares(&METHODS, [counted, &["points"]], "distance", 0.08, beside),
    };
    Ok(Chart {
        title: "Classification of a point: wrong and open answers, and time".to_owned(),
        names: table.counted(&METHODS, "points"),
        panels: vec![
            panel("wrong, 100 or 1000 points a mark", &["wrong"]),
            panel("undecided, 100 or 1000 points a mark", &OPEN),
            ChartPanel {
                title: "random points of all strata".to_owned(),
                x: axis("CPU time of a point in µs (median)", Scale::Logarithmic),
                y: axis("% not right; bars: 95 % confidence", Scale::Percent),
                series: table.shares(
                    &METHODS,
                    [&["wrong", "undecided", "failed"], &["points"]],
                    "cpu_us_median",
                    0.0,
                    random,
                ),
            },
        ],
    })
}

fn atlas() -> Result<Chart, csv::Error> {
    const METHODS: [&str; 7] = [
        "fast",
        "exact",
        "proof",
        "companion matrix: cusps alone",
        "flood fill 12x12 points of 32x64",
        "flood fill 24x24 points of 48x96",
        "flood fill 40x40 points of 64x128",
    ];
    let table = Table::new(ATLAS)?;
    let panel = |title: &str, counted: &'static [&'static str]| ChartPanel {
        title: title.to_owned(),
        x: axis("CPU time of a body in µs (median)", Scale::Logarithmic),
        y: axis("% of the bodies of four strata; bars: 95 % confidence", Scale::Percent),
        series: table.shares(&METHODS, [counted, &["bodies"]], "cpu_us_median", 0.0, |_| Some(0)),
    };
    Ok(Chart {
        title: "Atlas of a body: wrong and open answers, and time".to_owned(),
        names: table.counted(&METHODS, "bodies"),
        panels: vec![panel("wrong", &["wrong"]), panel("undecided", &OPEN)],
    })
}

fn orbits() -> Result<Chart, csv::Error> {
    const METHODS: [&str; 4] = ["taylor", "dop853", "rk4", "splitting"];
    let table = Table::new(ORBITS)?;
    let panel = |title: &str, h: &'static str, column: &'static str, label: &str| ChartPanel {
        title: title.to_owned(),
        x: axis("CPU time of a crossing in µs", Scale::Logarithmic),
        y: axis(label, Scale::Logarithmic),
        series: table.series(
            "method",
            &METHODS,
            |row| table.text(row, "h") == h,
            |row| [table.number(row, "cpu_us_per_crossing"), table.number(row, column)],
        ),
    };
    Ok(Chart {
        title: "Orbits: error against time".to_owned(),
        names: vec!["Taylor".to_owned(), "DOP853".to_owned(), "Runge–Kutta 4".to_owned(), "splitting".to_owned()],
        panels: vec![
            panel("regular orbits, h = 2.6", "2.6", "error_100", "error of γ and l at crossing 100"),
            panel("chaotic orbits, h = 4.45", "4.45", "error_100", "error of γ and l at crossing 100"),
            panel("chaotic orbits, h = 4.45", "4.45", "drift_energy", "drift of the energy over 100 crossings"),
        ],
    })
}

fn polylines() -> Result<Chart, csv::Error> {
    let table = Table::new(POLYLINES)?;
    let panel = |title: &str, column: &'static str, label: &str| ChartPanel {
        title: title.to_owned(),
        x: axis("tolerance, relative to the picture", Scale::Descending),
        y: axis(label, Scale::Logarithmic),
        series: vec![Series {
            name: 0,
            points: table.rows.iter().map(|row| [table.number(row, "tolerance"), table.number(row, column)]).collect(),
            joined: true,
            intervals: Vec::new(),
        }],
    };
    Ok(Chart {
        title: "Polylines: tolerance against deviation, size and time".to_owned(),
        names: names(&["polylines of an atlas"]),
        panels: vec![
            panel("deviation that is left", "deviation_largest", "largest of 24 bodies, relative to the picture"),
            panel("size", "json_bytes", "bytes of atlas.json (median)"),
            panel("time", "document_us", "CPU time of curves in µs (median)"),
        ],
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn confidence_intervals_are_wilsons() {
        assert!(wilson(0.0, 10.0)[0].abs() < 1e-15);
        assert!((wilson(0.0, 10.0)[1] - 0.277_533).abs() < 1e-6);
        let [low, high] = wilson(5.0, 10.0);
        assert!((low - 0.236_593).abs() < 1e-6 && (high - 0.763_407).abs() < 1e-6);
    }

    #[test]
    fn every_chart_finds_its_measurements() {
        for (stem, draw) in CHARTS {
            let picture = draw_chart(&draw().unwrap(), bifdiag_plot::Theme::Light).unwrap();
            assert!(picture.svg.contains("<path") && picture.svg.contains("<circle"), "{stem} is empty");
        }
        let table = Table::new(ORBITS).unwrap();
        assert!(table.rows.iter().all(|row| table.number(row, "error_100") > 0.0));
    }
}
