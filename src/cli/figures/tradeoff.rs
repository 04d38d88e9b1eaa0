//! The charts of what accuracy costs, from the tables of `data/tradeoff/`.

use csv::StringRecord;
use plot::{Chart, ChartAxis, ChartPanel, Scale, Series, draw_chart};

use super::figure::Figure;
use crate::cli::export::ExportError;

const CLASSIFY: &str = include_str!("../../../data/tradeoff/classify.csv");
const ATLAS: &str = include_str!("../../../data/tradeoff/atlas.csv");
const ORBITS: &str = include_str!("../../../data/tradeoff/orbits.csv");
const POLYLINES: &str = include_str!("../../../data/tradeoff/polylines.csv");

type Draw = fn() -> Result<Chart, ExportError>;

const CHARTS: [(&str, Draw); 4] = [
    ("tradeoff-classify", classify),
    ("tradeoff-atlas", atlas),
    ("tradeoff-orbits", orbits),
    ("tradeoff-polylines", polylines),
];

pub fn figures() -> impl Iterator<Item = Figure> {
    CHARTS.into_iter().map(|(stem, draw)| Figure {
        stem,
        draw: Box::new(move |_, theme| Ok(draw_chart(&draw()?, theme).map_err(ExportError::from)?)),
    })
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

    /// Per cent of the rows' points for which the columns count.
    fn share(&self, row: &StringRecord, counted: &[&str], of: &str) -> f64 {
        100.0 * counted.iter().map(|column| self.number(row, column)).sum::<f64>() / self.number(row, of)
    }

    /// A series for each name in a column, from the rows that are chosen.
    fn series(
        &self,
        column: &str,
        names: &[&str],
        joined: bool,
        choose: impl Fn(&StringRecord) -> bool,
        point: impl Fn(&StringRecord) -> [f64; 2],
    ) -> Vec<Series> {
        let of = |name: usize| {
            let rows = self.rows.iter().filter(|row| self.text(row, column) == names[name] && choose(row));
            Series { name, points: rows.map(&point).collect(), joined }
        };
        (0..names.len()).map(of).collect()
    }
}

fn axis(label: &str, scale: Scale) -> ChartAxis {
    ChartAxis { label: label.to_owned(), scale }
}

fn names(names: &[&str]) -> Vec<String> {
    names.iter().map(|name| (*name).to_owned()).collect()
}

/// What is not answered: undecided, or without any answer.
const OPEN: [&str; 2] = ["undecided", "failed"];

fn classify() -> Result<Chart, ExportError> {
    const METHODS: [&str; 6] = [
        "fast",
        "proof of the whole plane",
        "companion matrix",
        "flood fill 32x64",
        "flood fill 96x192",
        "flood fill 256x512",
    ];
    let table = Table::new(CLASSIFY)?;
    let beside =
        |row: &StringRecord| table.text(row, "stratum") == "generic" && !table.text(row, "distance").is_empty();
    let random = |row: &StringRecord| table.text(row, "distance").is_empty();
    let panel = |title: &str, counted: &'static [&'static str]| ChartPanel {
        title: title.to_owned(),
        x: axis("relative distance from a curve", Scale::Descending),
        y: axis("per cent of the points", Scale::Percent),
        series: table.series("method", &METHODS, true, beside, |row| {
            [table.number(row, "distance"), table.share(row, counted, "points")]
        }),
    };
    Ok(Chart {
        title: "Classification of a point: wrong and open answers, and time".to_owned(),
        names: names(&METHODS),
        panels: vec![
            panel("wrong answers", &["wrong"]),
            panel("undecided", &OPEN),
            ChartPanel {
                title: "random points of six strata".to_owned(),
                x: axis("CPU time of a point in µs (median)", Scale::Logarithmic),
                y: axis("per cent without the right answer", Scale::Percent),
                series: table.series("method", &METHODS, false, random, |row| {
                    let share = table.share(row, &["wrong", "undecided", "failed"], "points");
                    [table.number(row, "cpu_us_median"), share]
                }),
            },
        ],
    })
}

fn atlas() -> Result<Chart, ExportError> {
    const METHODS: [&str; 7] = [
        "regions alone",
        "fast",
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
        y: axis("per cent of the bodies of four strata", Scale::Percent),
        series: table.series(
            "method",
            &METHODS,
            false,
            |_| true,
            |row| [table.number(row, "cpu_us_median"), table.share(row, counted, "bodies")],
        ),
    };
    Ok(Chart {
        title: "Atlas of a body: wrong and open answers, and time".to_owned(),
        names: names(&METHODS),
        panels: vec![panel("wrong", &["wrong"]), panel("undecided", &OPEN)],
    })
}

fn orbits() -> Result<Chart, ExportError> {
    const METHODS: [&str; 4] = ["taylor", "dop853", "rk4", "splitting"];
    let table = Table::new(ORBITS)?;
    let panel = |title: &str, h: &'static str, column: &'static str, label: &str| ChartPanel {
        title: title.to_owned(),
        x: axis("CPU time of a crossing in µs", Scale::Logarithmic),
        y: axis(label, Scale::Logarithmic),
        series: table.series(
            "method",
            &METHODS,
            true,
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

fn polylines() -> Result<Chart, ExportError> {
    let table = Table::new(POLYLINES)?;
    let panel = |title: &str, column: &'static str, label: &str| ChartPanel {
        title: title.to_owned(),
        x: axis("tolerance, relative to the picture", Scale::Descending),
        y: axis(label, Scale::Logarithmic),
        series: vec![Series {
            name: 0,
            points: table.rows.iter().map(|row| [table.number(row, "tolerance"), table.number(row, column)]).collect(),
            joined: true,
        }],
    };
    Ok(Chart {
        title: "Polylines: tolerance against deviation, size and time".to_owned(),
        names: names(&["polylines of an atlas"]),
        panels: vec![
            panel("deviation that is left", "deviation_largest", "largest of 24 bodies, relative to the picture"),
            panel("size", "json_bytes", "bytes of atlas.json (median)"),
            panel("time", "document_us", "CPU time of curves and stability in µs (median)"),
        ],
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_chart_finds_its_measurements() {
        for (stem, draw) in CHARTS {
            let picture = draw_chart(&draw().unwrap(), plot::Theme::Light).unwrap();
            assert!(picture.svg.contains("<polyline") || picture.svg.contains("<circle"), "{stem} is empty");
        }
        let table = Table::new(ORBITS).unwrap();
        assert!(table.rows.iter().all(|row| table.number(row, "error_100") > 0.0));
    }
}
