//! The straightened plane in a panel of any size, for a page that redraws it interactively: its map as numbers.

use super::plan::Plan;
use super::scene::{CurveSource, DiagramOptions, Scene, windows};
use super::straight::{LabelBoxes, Straight, StraightColumn, StraightShares, Tick, straighten};
use bifdiag_page::{PlotError, Point, Rect, TICK_SIZE};
use bifdiag_schema::AtlasDocument;

/// Width of a digit over the size of letters, and a little more, in any font of numbers.
const DIGIT: f64 = 0.64;
/// Steps from the highest curve to the upper edge.
const STEPS: u32 = 64;

/// The plane that [`straight_diagram`](super::straight_diagram) shows, in a panel whose upper left corner is the origin.
pub struct StraightPanel<'a> {
    scene: Scene<'a>,
    straight: Straight,
}

/// Round numbers on an axis: where in pixels, and their labels.
pub type PanelTicks = Vec<(f64, String)>;

impl<'a> StraightPanel<'a> {
    /// In this many pixels, with the shares that are `held`, if they are of such an arrangement, or in which as many
    /// labels of these sizes as may be fit into their regions.
    ///
    /// # Errors
    /// As those of [`straight_diagram`](super::straight_diagram).
    pub fn new(
        atlas: &'a AtlasDocument,
        source: Option<&'a dyn CurveSource>,
        size: [f64; 2],
        boxes: &[LabelBoxes],
        held: Option<&StraightShares>,
    ) -> Result<Self, PlotError> {
        let scene =
            Scene::new(atlas, source, &DiagramOptions::default(), Plan { straight: true, ..Plan::panel(size) })?;
        let [_, everything] = windows(&scene, None)?;
        let rect = Rect { x: 0.0, y: 0.0, width: size[0], height: size[1] };
        let straight = straighten(&scene, rect, 0.0, everything.l[1], boxes, held)?;
        Ok(Self { scene, straight: straight.ok_or(PlotError::NotStraight)? })
    }

    /// The shares that place everything.
    #[must_use]
    pub fn shares(&self) -> &StraightShares {
        self.straight.shares()
    }

    /// A column for each pixel, at the roundest momentum in it, and for each of `more` momenta that are in view.
    ///
    /// # Errors
    /// A curve without points.
    pub fn columns(&self, more: &[f64]) -> Result<Vec<StraightColumn>, PlotError> {
        self.straight.columns_at(&self.scene, more, STEPS)
    }

    /// Momenta along a curve of the document, and where it lies there.
    #[must_use]
    pub fn curve(&self, curve: usize) -> Vec<(f64, Point)> {
        self.straight.course(curve, [0.0, f64::INFINITY])
    }

    /// The events, in the order of the document, where they are in view.
    #[must_use]
    pub fn events(&self) -> Vec<Option<Point>> {
        self.scene.atlas.events.iter().map(|event| self.straight.event(&self.scene, event)).collect()
    }

    /// Lines of constant h.
    #[must_use]
    pub fn levels(&self) -> Vec<Vec<Point>> {
        self.straight.level_lines()
    }

    /// Round momenta, energies at l = 0, and energies at the last l.
    #[must_use]
    pub fn ticks(&self) -> [PanelTicks; 3] {
        let half = |label: &str| 0.5 * DIGIT * TICK_SIZE * label.chars().count() as f64;
        let [left, right] = self.straight.levels();
        [self.straight.momenta(half), left, right]
            .map(|ticks| ticks.into_iter().map(|Tick { at, label, .. }| (at, label)).collect())
    }

    /// The last l.
    #[must_use]
    pub fn l_end(&self) -> f64 {
        self.straight.l_end().unwrap_or(0.0)
    }
}

#[cfg(test)]
mod tests {
    use super::super::labels::{boxes, names};
    use super::super::scene::{Curves, DiagramTitle};
    use super::super::straight_diagram;
    use super::*;
    use bifdiag_documents::DocumentOptions;
    use bifdiag_page::{Width, distance};
    use support::bodies::{STRATA, random_body};
    use support::random::SplitMix64;

    fn panels(check: impl Fn(&Curves, &AtlasDocument, &StraightPanel<'_>)) {
        let mut rng = SplitMix64::new(40);
        for stratum in STRATA {
            let body = random_body(&mut rng, stratum);
            let atlas = Curves(bifdiag_diagram::fast::atlas(&body).expect("the body has an atlas"));
            let document = bifdiag_documents::atlas::document(&atlas.0, &DocumentOptions::default());
            let size = Plan::straight(Width::PAGE, true).main;
            let labels = boxes(&names(&document));
            let panel = StraightPanel::new(&document, Some(&atlas), size, &labels, None).unwrap();
            check(&atlas, &document, &panel);
        }
    }

    #[test]
    fn a_panel_as_large_as_the_picture_has_its_places() {
        panels(|atlas, document, panel| {
            let options = DiagramOptions { title: DiagramTitle::Body, ..DiagramOptions::default() };
            let drawn = straight_diagram(document, Some(atlas), &options).unwrap();
            let [width, height] = Plan::straight(Width::PAGE, true).main;
            let unit = |[x, y]: Point| [x / width, 1.0 - y / height];
            let near = |one: Point, other: Point| distance(one, other) < 1e-9;
            for (stroke, points) in drawn.described.strokes.iter().zip(&drawn.strokes) {
                let own = panel.curve(stroke.curve);
                let inner = points.get(1..points.len().saturating_sub(1)).unwrap_or_default();
                for point in inner {
                    assert!(own.iter().any(|(_, at)| near(unit(*at), *point)), "{point:?}");
                }
            }
            for (event, at) in drawn.events.iter().zip(panel.events()) {
                assert!(event.zip(at).is_some_and(|(event, at)| near(unit(at), event)));
            }
            assert_eq!(drawn.l_end, panel.l_end());
        });
    }

    #[test]
    fn shares_that_are_held_give_the_same_panel() {
        panels(|atlas, document, panel| {
            let size = Plan::straight(Width::PAGE, true).main;
            let labels = boxes(&names(document));
            let again = StraightPanel::new(document, Some(atlas), size, &labels, Some(panel.shares())).unwrap();
            assert_eq!(again.columns(&[]).unwrap(), panel.columns(&[]).unwrap());
        });
    }

    #[test]
    fn columns_have_the_regions_of_their_points_at_round_momenta() {
        panels(|atlas, _, panel| {
            let wanted = 0.377 * panel.l_end();
            let columns = panel.columns(&[wanted]).unwrap();
            assert!(columns.iter().any(|column| column.l == wanted));
            assert!(columns.windows(2).all(|pair| pair[0].l < pair[1].l && pair[0].x <= pair[1].x));
            for column in columns.iter().step_by(7) {
                let ends = column.curves.iter().skip(1).map(|([h, _], _)| *h).chain(column.above.get(8).copied());
                for (([h, _], region), end) in column.curves.iter().zip(ends) {
                    if end - h < 1e-9 * h.abs().max(1.0) {
                        continue;
                    }
                    let found = atlas.0.locate(0.5 * (h + end), column.l).unwrap();
                    let bifdiag_diagram::atlas::Place::Region(own) = found.place else { panic!("{found:?}") };
                    assert_eq!(own.to_string(), format!("R{}", region + 1));
                }
            }
        });
    }
}
