//! Grids of points.

use bifdiag_numbers::Number;
use bifdiag_schema::{Accuracy, GridAxisDocument, GridDocument};

use crate::body::{given, head};
use crate::classification::accuracy_option;
use crate::subject::Subject;

/// Equally spaced values, both ends included.
#[derive(Clone, Debug, PartialEq)]
pub struct GridAxis {
    /// The first.
    pub from: Number,
    /// The last.
    pub to: Number,
    /// Their number.
    pub count: usize,
}

impl GridAxis {
    /// The values as doubles, weighted so that both ends are what was given.
    #[must_use]
    pub fn values(&self) -> Vec<f64> {
        let (from, to) = (self.from.to_f64(), self.to.to_f64());
        let last = self.count.saturating_sub(1);
        (0..self.count)
            .map(|k| if last == 0 { from } else { ((last - k) as f64 * from + k as f64 * to) / last as f64 })
            .collect()
    }

    fn text(&self) -> String {
        format!("{}:{}:{}", self.from.text(), self.to.text(), self.count)
    }

    fn document(&self) -> GridAxisDocument {
        GridAxisDocument { from: self.from.text().to_owned(), to: self.to.text().to_owned(), count: self.count }
    }
}

/// What the arrays of a grid mean.
#[must_use]
pub fn grid(subject: &Subject, h: &GridAxis, l: &GridAxis, accuracy: Accuracy) -> GridDocument {
    let codes = [("-1", "forbidden"), ("-2", "critical"), ("-3", "undecided")];
    let line = subject.command("classify").option("grid", format!("{},{}", h.text(), l.text()));
    GridDocument {
        head: head(line.option_if("accuracy", accuracy_option(accuracy)).option("out", "grid.npz").text()),
        body: given(&subject.body),
        accuracy,
        h: h.document(),
        l: l.document(),
        codes: codes.map(|(code, word)| (code.to_owned(), word.to_owned())).into(),
    }
}
