//! What a diagram shows, as plain values.

use bifdiag::plot::{DiagramDescription, DiagramLabel, DiagramSymbol};
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// Puts `title`, `windows`, `grounds`, `strokes`, `labels`, `legend`, `ink` and `paper` into a dict.
pub fn describe(out: &Bound<'_, PyDict>, drawn: &DiagramDescription) -> PyResult<()> {
    let label = |label: &DiagramLabel| (label.region, label.lines.clone(), label.size, label.at, label.tip);
    let labels = drawn.labels.iter().map(|labels| labels.iter().map(label).collect::<Vec<_>>());
    let strokes = drawn.strokes.iter().map(|stroke| (stroke.curve, stroke.l, stroke.width, stroke.lines.clone()));
    // The shape of a mark, the colours of a ground, or the pattern and the width of a line.
    let entry = |(symbol, text): &(DiagramSymbol, String)| {
        let (mark, ground, line) = match symbol {
            DiagramSymbol::Mark(shape) => (Some(*shape), None, None),
            DiagramSymbol::Ground(colors) => (None, Some(colors.clone()), None),
            DiagramSymbol::Line(pattern, width) => (None, None, Some((pattern.clone(), *width))),
        };
        (mark, ground, line, text.clone())
    };
    out.set_item("title", &drawn.title)?;
    out.set_item("windows", drawn.windows.iter().map(|window| [window.h, window.l]).collect::<Vec<_>>())?;
    out.set_item("grounds", drawn.grounds.clone())?;
    out.set_item("strokes", strokes.collect::<Vec<_>>())?;
    out.set_item("labels", labels.collect::<Vec<_>>())?;
    out.set_item("legend", drawn.legend.iter().map(entry).collect::<Vec<_>>())?;
    out.set_item("ink", &drawn.ink)?;
    out.set_item("paper", &drawn.paper)
}
