//! The shares of the parts: more, in steps, where a name does not fit.

use super::super::labels::Boxes;
use super::super::scene::Scene;
use super::plane::Straight;
use super::shares::Shares;
use super::strata::slabs;
use bifdiag_page::{PlotError, Rect, pixel};

/// Steps at most, and the most by which one step enlarges a share.
const STEPS: usize = 60;
/// For a name in full, for type and id, and for the id.
const STEP: [f64; 3] = [1.03, 1.08, 1.3];
/// Width of a column in pixels.
const COLUMN: f64 = 2.0;
/// Free pixels round a name.
const CLEARANCE: f64 = 3.5;
/// Regions narrower than this many times their names are made wider.
const NARROW: f64 = 2.5;

/// The plane up to `l_end`, with the shares that are `held` or in which as many labels of this size as may be fit into their
/// regions; `None` for a document that does not say which curves lie above each other.
pub(crate) fn straighten(
    scene: &Scene<'_>,
    rect: Rect,
    right: f64,
    l_end: f64,
    boxes: &[Boxes],
    held: Option<&Shares>,
) -> Result<Option<Straight>, PlotError> {
    let Some(slabs) = slabs(scene, l_end)? else { return Ok(None) };
    let mut straight = Straight::new(scene.atlas, rect, right, slabs);
    // Shares of another arrangement are no use.
    let fits = |held: &&Shares| held.wide.len() == straight.slabs.len() && held.high.len() == boxes.len();
    let shares = held.filter(fits).cloned().unwrap_or_else(|| shares(&mut straight, boxes));
    straight.place(&shares);
    straight.shares = shares;
    Ok(Some(straight))
}

/// How well the names fit: how many in full, type and id alone, or the id; then how well the worst.
type Fit = (usize, usize, usize, f64);

/// The best shares that are found.
fn shares(straight: &mut Straight, boxes: &[Boxes]) -> Shares {
    let mut shares = Shares { wide: lengths(straight), high: vec![1.0; boxes.len()] };
    let mut best: Option<(Fit, Shares)> = None;
    for _ in 0..STEPS {
        straight.place(&shares);
        let rooms: Vec<[Room; 3]> = measured(straight, boxes);
        let fits = |form: usize| rooms.iter().filter(|room| room[form].share >= 1.0).count();
        let worst = rooms.iter().map(|room| room[1].share.min(1.0)).sum::<f64>();
        let fit = (fits(2), fits(1), fits(0), worst);
        if best.as_ref().is_none_or(|(known, _)| fit > *known) {
            best = Some((fit, shares.clone()));
        }
        if fits(0) == boxes.len() {
            break;
        }
        for (region, room) in rooms.iter().enumerate() {
            // What has no room for its id first.
            let Some((short, most)) = room.iter().zip(STEP).rev().find(|(room, _)| room.share < 1.0) else { continue };
            let by = (1.0 / short.share.max(1e-3)).sqrt().min(most);
            shares.high[region] *= by;
            if short.extent < NARROW {
                short.slabs.iter().for_each(|&slab| shares.wide[slab] *= by);
            }
        }
    }
    best.map_or(shares, |(_, shares)| shares)
}

/// Longer stretches of l are wider, though much less than they are longer.
fn lengths(straight: &Straight) -> Vec<f64> {
    let all = straight.l_end().unwrap_or(1.0);
    straight.slabs.iter().map(|slab| 0.4 + ((slab.l[1] - slab.l[0]) / all).sqrt()).collect()
}

/// The room of a region for a name.
struct Room {
    /// Its height relative to that of the name, at this width.
    share: f64,
    /// Its width compared to that of the name.
    extent: f64,
    /// Where it is.
    slabs: Vec<usize>,
}

/// The rooms for names in full, for type and id, and for the id.
fn measured(straight: &Straight, boxes: &[Boxes]) -> Vec<[Room; 3]> {
    let columns = straight.columns(COLUMN);
    // The layers of each region in each column, from above to below.
    let mut layers: Vec<Vec<Vec<[f64; 2]>>> = vec![vec![Vec::new(); columns.len()]; boxes.len()];
    for (column, place) in columns.iter().enumerate() {
        let heights = straight.heights(*place);
        for (number, layer) in straight.slabs[place.0].layers.iter().enumerate() {
            let top = heights.get(number + 1).copied().unwrap_or(straight.rect.y);
            layers[layer.region][column].push([top, heights[number]]);
        }
    }
    let room = |region: usize, extents: [[f64; 2]; 2]| {
        let mut best = Room { share: 0.0, extent: 0.0, slabs: Vec::new() };
        let mut own: Vec<usize> = (0..columns.len()).filter(|column| !layers[region][*column].is_empty()).collect();
        let pixels = own.len() as f64 * COLUMN;
        own.dedup_by_key(|column| columns[*column].0);
        best.slabs = own.iter().map(|column| columns[*column].0).collect();
        for [width, height] in extents {
            let [width, height] = [width + 2.0 * CLEARANCE, height + 2.0 * CLEARANCE];
            best.extent = best.extent.max(pixels / width);
            let needed = pixel((width / COLUMN).ceil() + 1.0, columns.len());
            for first in 0..columns.len().saturating_sub(needed) {
                for mut common in layers[region][first].iter().copied() {
                    for column in first + 1..first + needed {
                        let overlaps = layers[region][column]
                            .iter()
                            .map(|[top, bottom]| [top.max(common[0]), bottom.min(common[1])]);
                        let widest = overlaps.max_by(|a, b| (a[1] - a[0]).total_cmp(&(b[1] - b[0])));
                        common = widest.unwrap_or([0.0; 2]);
                        if common[1] - common[0] <= best.share * height {
                            break;
                        }
                    }
                    best.share = best.share.max((common[1] - common[0]) / height);
                }
            }
        }
        best
    };
    boxes.iter().enumerate().map(|(region, forms)| forms.map(|extents| room(region, extents))).collect()
}

#[cfg(test)]
mod tests {
    use super::straighten;
    use crate::diagram::labels::{boxes, names};
    use crate::diagram::plan::Plan;
    use crate::diagram::scene::{Curves, DiagramOptions, Scene, windows};
    use crate::diagram::straight::plane::{BELOW_ALL, Straight};
    use bifdiag_documents::DocumentOptions;
    use bifdiag_page::{Point, Rect, Width};
    use support::bodies::{STRATA, random_body};
    use support::random::SplitMix64;

    /// Bodies of all strata.
    fn straightened(check: impl Fn(&Straight, &Scene<'_>)) {
        let mut rng = SplitMix64::new(38);
        for stratum in STRATA.iter().cycle().take(3 * STRATA.len()) {
            let body = random_body(&mut rng, *stratum);
            let atlas = Curves(bifdiag_diagram::fast::atlas(&body).expect("the body has an atlas"));
            let document = bifdiag_documents::atlas::document(&atlas.0, &DocumentOptions::default());
            let scene =
                Scene::new(&document, Some(&atlas), &DiagramOptions::default(), Plan::straight(Width::PAGE, true))
                    .unwrap();
            let rect = Rect { x: 50.0, y: 50.0, width: 800.0, height: 440.0 };
            let l_end = windows(&scene, None).unwrap()[1].l[1];
            let straight = straighten(&scene, rect, 40.0, l_end, &boxes(&names(&document)), None).unwrap();
            check(&straight.expect("the document tells how the curves lie"), &scene);
        }
    }

    #[test]
    fn regions_keep_their_order_and_go_on_through_event_momenta() {
        straightened(|straight, scene| {
            for (slab, placed) in straight.slabs.iter().zip(&straight.placed) {
                assert!(placed.windows(2).all(|pair| pair[0].0 < pair[1].0));
                for (x, y) in placed {
                    let within = straight.rect.grown(1e-6);
                    assert!(y.iter().all(|y| within.contains([*x, *y])), "{x}, {y:?}");
                    assert!(y.windows(2).all(|pair| pair[1] <= pair[0]), "{y:?}");
                    assert!((y[0] - straight.rect.bottom() + BELOW_ALL).abs() < 1e-9, "the lowest curve is level");
                }
                assert_eq!(slab.layers.len(), placed[0].1.len());
            }
            for (place, pair) in straight.slabs.windows(2).enumerate() {
                let before = &straight.placed[place][straight.placed[place].len() - 1];
                let after = &straight.placed[place + 1][0];
                assert!((before.0 - after.0).abs() < 1e-9);
                for (number, layer) in pair[0].layers.iter().enumerate() {
                    let Some(other) = straight.layer(place + 1, layer.lower) else { continue };
                    let (one, other) = (before.1[number], after.1[other]);
                    let (id, l) = (&scene.atlas.curves[layer.lower].id, pair[0].l[1]);
                    let given = &scene.atlas.body.given;
                    assert!((one - other).abs() < 0.5, "{id} at {l} of {given:?}: {one} and {other}");
                }
            }
        });
    }

    #[test]
    fn height_rises_with_energy() {
        straightened(|straight, scene| {
            let mut last = f64::INFINITY;
            let l = 0.37 * straight.l_end().unwrap();
            let lowest = scene.atlas.drawing.as_ref().unwrap().view.everything.h;
            for step in 0..=400_u32 {
                let h = lowest[0] + (lowest[1] - lowest[0]) * f64::from(step) / 400.0;
                if let Some([_, y]) = straight.position([h, l]) {
                    assert!(y <= last && y >= straight.rect.y, "{y} at {h}");
                    last = y;
                }
            }
            assert!(last < straight.rect.bottom(), "some motion is in view");
        });
    }

    #[test]
    fn every_event_lies_on_its_curves() {
        straightened(|straight, scene| {
            for event in &scene.atlas.events {
                let [x, y] = straight.event(scene, event).expect("events are in view");
                for (curve, _) in scene.atlas.curves.iter().enumerate().filter(|(_, c)| event.curves.contains(&c.id)) {
                    let near = |[px, py]: &Point| (px - x).abs() < 0.5 && (py - y).abs() < 0.5;
                    assert!(straight.curve(curve, [0.0, f64::INFINITY]).iter().any(near), "{event:?}");
                }
            }
        });
    }
}
