//! A diagram with its legend, table and notes on a page.

use super::insets::{Magnifications, magnifications};
use super::labels::names;
use super::layout::{BELOW, LEFT, RIGHT, TOP, below_all, frames, inset_place, legend_place, page_width};
use super::legend::legend;
use super::notes::{NOTE_SIZE, heading, motions, motions_left_out, notes, remark, units};
use super::paint::Diagram;
use super::palette::branch_styles;
use super::panel::Panel;
use super::placement;
use super::plan::Plan;
use super::scene::{CurveSource, DiagramOptions, Scene, windows};
use super::straight::straighten;
use super::stroke::strokes;
use super::windows::View;
use crate::page::{
    Anchor, Canvas, FAINT_INK, HEIGHT, Heading, INK, Legend, Picture, PlotError, Point, Rect, Table, Theme, render,
    title_size,
};
use bifdiag_schema::{AtlasDocument, WindowDocument};

const TITLE_SIZE: f64 = 14.0;
const NOTE: f64 = NOTE_SIZE * 1.4;
/// The table of motions may take so many pixels, whatever is left.
const TABLE_LEAST: f64 = 90.0;

/// Everything with its place.
pub(super) struct Page<'a> {
    diagram: Diagram<'a>,
    /// Whether there are more parts to magnify than insets.
    is_crowded: bool,
    size: [f64; 2],
    heading: Heading,
    legend: Legend,
    legend_at: Point,
    motions: Table,
    motions_at: Point,
    notes: Vec<String>,
}

impl<'a> Page<'a> {
    /// Lays a diagram out.
    ///
    /// # Errors
    /// As those of [`super::draw`].
    pub(super) fn new(
        atlas: &'a AtlasDocument,
        source: Option<&'a dyn CurveSource>,
        options: &DiagramOptions,
        plan: &'static Plan,
    ) -> Result<Self, PlotError> {
        let scene = Scene::new(atlas, source, options, plan)?;
        let styles = branch_styles(atlas);
        let strokes = strokes(atlas, &styles);
        let (panels, mut magnified) = if plan.straight {
            (vec![straightened(&scene)?], Magnifications::default())
        } else {
            panels(&scene, options.window)?
        };
        let frames = frames(&panels);
        let mut texts = placement::place(&scene, &panels, &frames);
        // A region that a label points at is drawn, and one that a note names is not in the key.
        let is_unlabelled = |region: &usize| !texts.labels.iter().flatten().any(|label| label.region == *region);
        magnified.invisible.retain(is_unlabelled);
        magnified.outside.retain(is_unlabelled);
        texts.key.retain(|(region, _)| !magnified.invisible.contains(region) && !magnified.outside.contains(region));

        let insets = panels.len() - 1;
        let width = page_width(plan, insets);
        let dots = options.points.as_ref().map_or("sample point of a region", |marked| marked.text.as_str());
        let explained = |width| legend(&scene, &styles, &strokes, &panels, &texts, dots, width);
        let place = |(at, width)| (at, width, explained(width));
        let (mut legend_at, room, mut legend) = place(legend_place(plan, insets));
        if legend.widest() > room {
            (legend_at, _, legend) = place(below_all(plan, insets));
        }
        let axes = panels.iter().map(|panel| panel.view.rect.bottom() + BELOW + 6.0);
        let motions_at = [LEFT, axes.fold(legend_at[1] + legend.height(), f64::max) + 6.0];
        let notes = notes(atlas, &magnified, width - LEFT - RIGHT);
        let below = notes.len() as f64 * NOTE + 14.0;
        let motions = motions(&scene, &strokes, &panels, options.width.pixels() - LEFT - RIGHT)
            .shortened((HEIGHT - motions_at[1] - below).max(TABLE_LEAST), motions_left_out);
        let height = motions_at[1] + motions.height() + below;
        let size = [width.max(LEFT + motions.width() + RIGHT), height.ceil()];
        let heading = heading(atlas, width - LEFT - RIGHT, TITLE_SIZE);
        let diagram = Diagram { scene, strokes, panels, frames, texts, units: units(atlas) };
        let is_crowded = magnified.crowded;
        Ok(Self { diagram, is_crowded, size, heading, legend, legend_at, motions, motions_at, notes })
    }

    /// How many insets there are, and whether there would be more with room for them.
    pub(super) fn insets(&self) -> (usize, bool) {
        (self.diagram.panels.len() - 1, self.is_crowded)
    }

    /// Whether everything that is to be magnified has an inset.
    pub(super) fn is_complete(&self) -> bool {
        !self.is_crowded
    }

    /// Whether it is low enough, and every frame has the letter of its inset.
    pub(super) fn fits(&self) -> bool {
        let Diagram { frames, texts, .. } = &self.diagram;
        self.size[1] <= HEIGHT && frames.iter().flatten().all(|frame| texts.letters[frame.insets[0]].is_some())
    }

    /// Draws it.
    ///
    /// # Errors
    /// A failure of the drawing library.
    pub(super) fn draw(self, theme: Theme) -> Result<Picture, PlotError> {
        let title = self.heading.title.clone();
        render(self.size, self.heading.clone(), theme, |canvas| {
            let size = title_size(&title, TITLE_SIZE, self.size[0] - LEFT);
            canvas.text(&title, [LEFT, 24.0], size, INK, Anchor::Start);
            self.draw_remark(canvas);
            self.diagram.paint(canvas);
            canvas.group("legend", "", || self.legend.draw(canvas, self.legend_at));
            canvas.group("motions", "", || self.motions.draw(canvas, self.motions_at));
            let below = self.motions_at[1] + self.motions.height();
            for (row, note) in self.notes.iter().enumerate() {
                let base = below + (row as f64 + 1.0) * NOTE;
                canvas.text(note, [LEFT, base], NOTE_SIZE, FAINT_INK, Anchor::Start);
            }
        })
    }

    fn draw_remark(&self, canvas: &Canvas) {
        let Scene { atlas, plan, .. } = self.diagram.scene;
        let at = [LEFT + plan.main[0], TOP - plan.remark];
        canvas.text(remark(atlas), at, NOTE_SIZE, FAINT_INK, Anchor::End);
    }
}

/// The panel of the straightened plane.
fn straightened(scene: &Scene<'_>) -> Result<Panel, PlotError> {
    let [_, everything] = windows(scene, None)?;
    let [width, height] = scene.plan.main;
    let rect = Rect { x: LEFT, y: TOP, width, height };
    let straight = straighten(scene, rect, scene.plan.right, everything.l[1], &names(scene.atlas))?;
    Panel::straightened(scene, View { window: everything, rect }, straight.ok_or(PlotError::NotStraight)?)
}

/// The main panel and its insets, and what could not be magnified.
fn panels(scene: &Scene<'_>, asked: Option<WindowDocument>) -> Result<(Vec<Panel>, Magnifications), PlotError> {
    let view = |window, [x, y]: Point, [width, height]: [f64; 2]| View { window, rect: Rect { x, y, width, height } };
    let [main, everything] = windows(scene, asked)?;
    let main = Panel::new(scene, view(main, [LEFT, TOP], scene.plan.main))?;
    let mut magnified = magnifications(scene, &main, &everything)?;
    if everything != main.view.window {
        // It takes the first place, so that what lies far out is seen in its frame.
        magnified.windows.insert(0, everything);
    }
    let mut panels = vec![main];
    for (index, window) in magnified.windows.iter().enumerate() {
        panels.push(Panel::new(scene, view(*window, inset_place(scene.plan, index), scene.plan.inset))?);
    }
    Ok((panels, magnified))
}
