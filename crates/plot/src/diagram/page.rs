//! A diagram with its legend, table and notes on a page.

use super::insets::{Magnifications, magnifications};
use super::labels::{boxes, names};
use super::layout::{BELOW, below_all, frames, inset_place, legend_place, page_width};
use super::legend::legend;
use super::notes::{NOTE_SIZE, about, columns, exceptions, heading, motions, notes, remark, units};
use super::paint::Diagram;
use super::palette::branch_styles;
use super::panel::Panel;
use super::placement;
use super::plan::{LEFT, Plan, RIGHT};
use super::scene::{CurveSource, DiagramOptions, DiagramTitle, LegendPlace, Scene, windows};
use super::straight::straighten;
use super::stroke::strokes;
use super::windows::View;
use bifdiag_page::{
    Anchor, Canvas, Caption, FAINT_INK, Figure, HEIGHT, Heading, INK, Legend, PlotError, Point, Rect, Table, Theme,
    render, title_size,
};
use bifdiag_schema::{AtlasDocument, WindowDocument};

const TITLE_SIZE: f64 = 14.0;
const NOTE: f64 = NOTE_SIZE * 1.4;
/// Round a legend that is a picture of its own.
const EDGE: f64 = 8.0;

/// Everything with its place.
pub(super) struct Page<'a> {
    diagram: Diagram<'a>,
    /// Whether there are more parts to magnify than insets.
    is_crowded: bool,
    size: [f64; 2],
    /// It should not be higher.
    limit: f64,
    heading: Heading,
    title: String,
    legend: Legend,
    legend_at: Point,
    /// Whether the legend is in the picture, and whether it has left that for one of its own.
    has_legend: bool,
    is_apart: bool,
    motions: Option<Table>,
    motions_at: Point,
    notes: Vec<String>,
    caption: Caption,
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
        plan: Plan,
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
        let width = page_width(&plan, insets);
        let room = width - LEFT - RIGHT;
        let dots = options.points.as_ref().map_or("sample point of a region", |marked| marked.text.as_str());
        let explained = |width| legend(&scene, &styles, &strokes, &panels, &texts, dots, width);
        let place = |(at, width)| (at, width, explained(width));
        let (mut legend_at, legend_room, mut legend) = place(legend_place(&plan, insets));
        if legend.widest() > legend_room {
            (legend_at, _, legend) = place(below_all(&plan, insets));
        }
        let axes = panels.iter().map(|panel| panel.view.rect.bottom() + BELOW).fold(0.0, f64::max);
        let mut notes = notes(atlas, &magnified, room);
        let notes_high = |notes: &[String]| notes.len() as f64 * NOTE + 8.0;
        let limit = match options.legend {
            LegendPlace::Below => HEIGHT * options.width.scale().max(1.0),
            _ => options.width.height(),
        };
        let mut below = axes.max(legend_at[1] + legend.height()) + 6.0;
        let has_legend = match options.legend {
            LegendPlace::Below => true,
            LegendPlace::Auto => below + notes_high(&notes) <= limit,
            LegendPlace::None | LegendPlace::Apart => false,
        };
        let mut caption = Caption::new(options.theme);
        caption.paragraph(&about(atlas, plan.straight));
        if !has_legend {
            caption.entries(legend.entries());
            for note in std::mem::take(&mut notes) {
                caption.paragraph(&note);
            }
            below = axes;
        }
        if let Some(exceptions) = exceptions(atlas) {
            caption.paragraph(exceptions);
        }
        let (heads, rows) = (columns(atlas), motions(&scene, &strokes, &panels));
        let cells: Vec<Vec<String>> = rows.iter().map(|(_, cells)| cells.clone()).collect();
        let fits = |table: &Table| below + table.height() + notes_high(&notes) <= limit;
        let table = options.table.then(|| Table::new(heads.clone(), rows, room)).filter(fits);
        if table.is_none() && !cells.is_empty() {
            caption.table(&heads, &cells);
        }
        let height = below + table.as_ref().map_or(0.0, Table::height) + notes_high(&notes);
        let heading = heading(atlas, room, TITLE_SIZE);
        let title = match &options.title {
            DiagramTitle::Body => heading.title.clone(),
            DiagramTitle::Text(text) => text.clone(),
            DiagramTitle::None => String::new(),
        };
        let is_apart = !has_legend && options.legend != LegendPlace::None;
        let diagram = Diagram { scene, strokes, panels, frames, texts, units: units(atlas) };
        Ok(Self {
            diagram,
            is_crowded: magnified.crowded,
            size: [width, height.ceil()],
            limit,
            heading,
            title,
            legend,
            legend_at,
            has_legend,
            is_apart,
            motions: table,
            motions_at: [LEFT, below],
            notes,
            caption,
        })
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
        self.size[1] <= self.limit && frames.iter().flatten().all(|frame| texts.letters[frame.insets[0]].is_some())
    }

    /// What is drawn in and at the panels.
    pub(super) fn diagram(&self) -> &Diagram<'a> {
        &self.diagram
    }

    /// The title.
    pub(super) fn title(&self) -> &str {
        &self.title
    }

    /// What the symbols mean.
    pub(super) fn legend(&self) -> &Legend {
        &self.legend
    }

    /// What is drawn in and at the panels, alone.
    pub(super) fn into_diagram(self) -> Diagram<'a> {
        self.diagram
    }

    /// Draws it.
    ///
    /// # Errors
    /// A failure of the drawing library.
    pub(super) fn draw(self, theme: Theme) -> Result<Figure, PlotError> {
        let picture = render(self.size, self.heading.clone(), theme, |canvas| {
            let size = title_size(&self.title, TITLE_SIZE, self.size[0] - LEFT);
            canvas.text(&self.title, [LEFT, 24.0], size, INK, Anchor::Start);
            self.draw_remark(canvas);
            self.diagram.paint(canvas);
            if self.has_legend {
                canvas.group("legend", "", || self.legend.draw(canvas, self.legend_at));
            }
            if let Some(motions) = &self.motions {
                canvas.group("motions", "", || motions.draw(canvas, self.motions_at));
            }
            let below = self.motions_at[1] + self.motions.as_ref().map_or(0.0, Table::height);
            for (row, note) in self.notes.iter().enumerate() {
                let base = below + (row as f64 + 1.0) * NOTE;
                canvas.text(note, [LEFT, base], NOTE_SIZE, FAINT_INK, Anchor::Start);
            }
        })?;
        let size = [self.size[0], self.legend.height() + 2.0 * EDGE];
        let apart = || render(size, self.heading.clone(), theme, |canvas| self.legend.draw(canvas, [EDGE; 2]));
        let legend = if self.is_apart { Some(apart()?) } else { None };
        Ok(Figure { picture, legend, caption: self.caption })
    }

    fn draw_remark(&self, canvas: &Canvas) {
        let Scene { atlas, plan, .. } = self.diagram.scene;
        let at = [LEFT + plan.main[0], plan.top - plan.remark];
        canvas.text(remark(atlas), at, NOTE_SIZE, FAINT_INK, Anchor::End);
    }
}

/// The panel of the straightened plane.
fn straightened(scene: &Scene<'_>) -> Result<Panel, PlotError> {
    let [_, everything] = windows(scene, None)?;
    let [width, height] = scene.plan.main;
    let rect = Rect { x: LEFT, y: scene.plan.top, width, height };
    let straight = straighten(scene, rect, scene.plan.right, everything.l[1], &boxes(&names(scene.atlas)), None)?;
    Panel::straightened(scene, View { window: everything, rect }, straight.ok_or(PlotError::NotStraight)?)
}

/// The main panel and its insets, and what could not be magnified.
fn panels(scene: &Scene<'_>, asked: Option<WindowDocument>) -> Result<(Vec<Panel>, Magnifications), PlotError> {
    let view = |window, [x, y]: Point, [width, height]: [f64; 2]| View { window, rect: Rect { x, y, width, height } };
    let [main, everything] = windows(scene, asked)?;
    let main = Panel::new(scene, view(main, [LEFT, scene.plan.top], scene.plan.main))?;
    let mut magnified = magnifications(scene, &main, &everything)?;
    if everything != main.view.window {
        // It takes the first place, so that what lies far out is seen in its frame.
        magnified.windows.insert(0, everything);
    }
    let mut panels = vec![main];
    for (index, window) in magnified.windows.iter().enumerate() {
        panels.push(Panel::new(scene, view(*window, inset_place(&scene.plan, index), scene.plan.inset))?);
    }
    Ok((panels, magnified))
}
