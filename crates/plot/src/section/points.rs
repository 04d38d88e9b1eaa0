//! Crossings as points: vectors, or images where there are many.

use super::colors::Coloring;
use super::layout::SheetPanel;
use super::raster::Raster;
use super::scene::{SectionOptions, SectionScene};
use crate::page::{Canvas, Ink, Path, PlotError};

/// Diameters of points in pixels.
const SMALLEST: f64 = 0.8;
const LARGEST: f64 = 2.2;
/// The part of a panel that points may cover before they are made smaller.
const COVERAGE: f64 = 0.06;

/// How points are drawn.
pub(super) struct Style {
    diameter: f64,
    as_image: bool,
}

impl Style {
    pub fn new(scenes: &[SectionScene<'_>], options: &SectionOptions) -> Self {
        let count = |scene: &SectionScene<'_>| scene.orbits.iter().map(|orbit| orbit.points.len()).sum::<usize>();
        let total: usize = scenes.iter().map(count).sum();
        let densest = scenes.iter().map(count).max().unwrap_or(0);
        // Both sheets together are some 200,000 square pixels.
        let room = COVERAGE * 2e5 / densest.max(1) as f64;
        let diameter = options.point_size.unwrap_or_else(|| room.sqrt().clamp(SMALLEST, LARGEST));
        Self { diameter, as_image: total > options.raster_above }
    }
}

/// Draws the crossings of one sheet.
pub(super) fn draw(
    canvas: &Canvas,
    scene: &SectionScene<'_>,
    panel: &SheetPanel,
    coloring: &Coloring,
    style: &Style,
) -> Result<(), PlotError> {
    let orbits = scene.orbits.iter().enumerate().map(|(index, orbit)| {
        let crossings = orbit.points.iter().map(|point| scene.portrait.crossing(panel.chart, point));
        let own = crossings.filter(|(_, sheet)| *sheet == panel.sheet).map(|(place, _)| panel.position(place));
        (coloring.of(scene, index), own)
    });
    let palette = coloring.palette();
    let shown: Vec<_> = palette.iter().map(|color| canvas.color(*color)).collect();
    if style.as_image {
        let mut raster = Raster::new(panel.rect);
        for (color, points) in orbits {
            points.for_each(|at| raster.dot(at, style.diameter, color));
        }
        canvas.element(&raster.element(&shown)?);
        return Ok(());
    }
    for (color, points) in orbits {
        let mut path = Path::default();
        points.for_each(|at| path.dot(at));
        let ink = Ink { color: palette[color], width: style.diameter };
        path.draw(canvas, &format!("{} stroke-linecap=\"round\"", canvas.stroke(ink)));
    }
    Ok(())
}
