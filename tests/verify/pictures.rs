//! What serves pictures is right: polylines, outlines, windows and widths.

use schema::{AtlasDocument, RegionDocument};
use verify::{Refused, verify};

use crate::made::{body, forged, preset, whole};

/// Two points of every polyline, a corner of every outline, every end of a window and every width, a little aside; a region
/// without its outline or of no end.
#[test]
fn pictures_that_are_a_little_wrong_are_refused() {
    for name in ["paper", "kovalevskaya"] {
        let true_one = whole(&preset(name));
        let refused = |field, change: &dyn Fn(&mut AtlasDocument)| {
            assert_eq!(forged(&true_one, change), Err(Refused::Field { field }), "{name}");
        };
        for (curve, number) in true_one.curves.iter().zip(0..) {
            let last = curve.polyline.len() - 1;
            refused("curves.polyline", &|d| d.curves[number].polyline[last / 2][0] += 1e-6);
            refused("curves.polyline", &|d| d.curves[number].polyline[last][1] += 1e-6);
        }
        for (region, number) in true_one.regions.iter().zip(0..) {
            let outlines = region.polygon.as_ref().unwrap();
            let inside = |h: f64| true_one.view.everything.h.iter().all(|border| (h - border).abs() > 1e-3);
            let corner = outlines.iter().flatten().position(|corner| inside(corner[0])).unwrap();
            let refused = |what: &str, change: &dyn Fn(&mut RegionDocument)| {
                let refused = forged(&true_one, |d| change(&mut d.regions[number]));
                assert!(matches!(refused, Err(Refused::Region { .. })), "{name} {}: {what}: {refused:?}", region.id);
            };
            refused("a corner aside", &|region| {
                region.polygon.iter_mut().flatten().flatten().nth(corner).unwrap()[0] += 1e-6;
            });
            refused("no outline", &|region| region.polygon = Some(Vec::new()));
            let outlines = |region: &mut RegionDocument, change: &dyn Fn(&mut Vec<[f64; 2]>)| {
                region.polygon.iter_mut().flatten().for_each(change);
            };
            refused("turned round", &|region| outlines(region, &|outline| outline.reverse()));
            refused("begun elsewhere", &|region| {
                outlines(region, &|outline| {
                    outline.pop();
                    outline.rotate_left(1);
                    outline.push(outline[0]);
                });
            });
            refused("three times", &|region| {
                let all = region.polygon.clone().unwrap();
                region.polygon = Some(all.iter().flat_map(|outline| [outline, outline, outline]).cloned().collect());
            });
            refused("twice around", &|region| {
                outlines(region, &|outline| {
                    let again = outline[1..].to_vec();
                    outline.extend(again);
                });
            });
            let others = match region.h_width {
                Some(width) => vec![Some(width * 1.000_01), Some(width * 0.999_99), None],
                None => vec![Some(1e6)],
            };
            for other in others {
                refused("another width", &|region| region.h_width = other);
            }
        }
        for end in 0..2 {
            refused("view", &|d| d.view.everything.h[end] += 1e-3);
            refused("view", &|d| d.view.main.h[end] += 1e-3);
            refused("view", &|d| d.view.everything.l[end] += 1e-3);
            refused("view", &|d| d.view.main.l[end] += 1e-3);
        }
    }
}

/// The outlines of a region end at an event within it, or run up to the top of the view where its lower curve does not.
#[test]
fn outlines_without_a_part_of_their_region_are_refused() {
    let mut forged_ones = [0; 2];
    for name in ["paper", "kovalevskaya", "katok:3"] {
        let true_one = whole(&preset(name));
        let view = &true_one.view.everything;
        let seen = 0.01 * (view.h[1] - view.h[0]) * view.l[1];
        for (region, number) in true_one.regions.iter().zip(0..) {
            let outlines = region.polygon.as_ref().unwrap();
            let mut refused = |kind: usize, outline: usize, other: Vec<[f64; 2]>| {
                if other.len() > 3 && (area(&outlines[outline]) - area(&other)).abs() > seen {
                    let result =
                        forged(&true_one, |d| d.regions[number].polygon.as_mut().unwrap()[outline].clone_from(&other));
                    assert!(matches!(result, Err(Refused::Region { .. })), "{name} {}: {kind}: {result:?}", region.id);
                    forged_ones[kind] += 1;
                }
            };
            for (outline, k) in outlines.iter().zip(0..) {
                for event in &true_one.events {
                    refused(0, k, outline.iter().copied().filter(|corner| corner[1] <= event.l).collect());
                }
                let Some(top) = outline.iter().position(|corner| corner[0] == view.h[1]) else { continue };
                let [h, l] = outline[top / 2];
                let left = outline[top..].iter().position(|corner| corner[0] < view.h[1] || corner[1] < l);
                if let Some(left) = left.filter(|_| h < view.h[1]) {
                    let wall = [view.h[1], l * (1.0 + 1e-12)];
                    refused(1, k, [&outline[..=top / 2], &[wall], &outline[top + left..]].concat());
                }
            }
        }
    }
    assert!(forged_ones.iter().all(|number| *number > 3), "{forged_ones:?}");
}

/// Both parts of an outline where it is cut over the l of an event, or one of them; also of regions so thin that they are hardly seen.
#[test]
fn outlines_that_are_cut_at_an_event_are_refused() {
    let (mut forged_ones, mut thin_ones) = (0, 0);
    for name in ["paper", "kovalevskaya", "katok:3"] {
        let true_one = whole(&preset(name));
        verify(&true_one).unwrap();
        for (region, number) in true_one.regions.iter().zip(0..) {
            let [outline] = &region.polygon.as_ref().unwrap()[..] else { continue };
            for event in &true_one.events {
                let Some([mut left, mut right]) = cut(outline, event.l) else { continue };
                for part in [&mut left, &mut right] {
                    part.push(part[0]);
                }
                for other in [vec![left.clone(), right.clone()], vec![left], vec![right]] {
                    let refused = forged(&true_one, |d| d.regions[number].polygon = Some(other.clone()));
                    assert!(matches!(refused, Err(Refused::Region { .. })), "{name} {}: {refused:?}", region.id);
                    forged_ones += 1;
                    thin_ones += usize::from(is_thin(&true_one, outline));
                }
            }
        }
    }
    assert!(forged_ones > 20 && thin_ones > 5, "{forged_ones} {thin_ones}");
}

/// Where several events lie at one l outlines end at each event: one that is left out, however thin.
#[test]
fn outlines_without_one_of_their_pieces_are_refused() {
    let true_one = whole(&body([["1", "5/9", "1/2"], ["1", "0", "0"]]));
    verify(&true_one).unwrap();
    let mut thin_ones = 0;
    for (region, number) in true_one.regions.iter().zip(0..) {
        let outlines = region.polygon.as_ref().unwrap();
        for (outline, k) in outlines.iter().zip(0..).filter(|_| outlines.len() > 1) {
            let refused = forged(&true_one, |d| drop(d.regions[number].polygon.as_mut().unwrap().remove(k)));
            assert!(matches!(refused, Err(Refused::Region { .. })), "{} {k}: {refused:?}", region.id);
            thin_ones += usize::from(is_thin(&true_one, outline));
        }
    }
    assert!(thin_ones > 3, "{thin_ones}");
}

/// The corners on both sides of the wall over an l at which an outline has two.
fn cut(outline: &[[f64; 2]], l: f64) -> Option<[Vec<[f64; 2]>; 2]> {
    let there: Vec<usize> = (1..outline.len() - 1).filter(|&k| (outline[k][1] - l).abs() <= 1e-12 * l).collect();
    let [low, high] = there[..] else { return None };
    let is_through = outline[low][1] < outline[low + 1][1] && outline[high][1] > outline[high + 1][1];
    let parts = [[&outline[..=low], &outline[high..outline.len() - 1]].concat(), outline[low..=high].to_vec()];
    (is_through && parts.iter().all(|part| part.len() > 3)).then_some(parts)
}

/// In the mean an outline is less than 0.004 of the view high.
fn is_thin(document: &AtlasDocument, outline: &[[f64; 2]]) -> bool {
    let view = &document.view.everything;
    let [from, to] = [f64::min, f64::max].map(|choose| outline.iter().map(|corner| corner[1]).reduce(choose).unwrap());
    area(outline) < 0.004 * (view.h[1] - view.h[0]) * (to - from)
}

/// Where the slope of a curve turns, and of curves beside it: chords over ever more points of each.
#[test]
fn coarse_polylines_beside_a_turn_are_refused() {
    let true_one = whole(&body([["2", "1000", "0.854"], ["-0.7606", "0.9684", "-0.0368"]]));
    // The part that curves are drawn in (docs/formats.md).
    let norm = [0.7606_f64, 0.9684, 0.0368].map(|c| c * c).iter().sum::<f64>().sqrt();
    let width = (1.6 * true_one.events.last().unwrap().l).max(3.0 * (1000.0 * norm).sqrt());
    let height = width * width / 2000.0 + 2.0 * norm;
    let mut forged_ones = 0;
    for (curve, number) in true_one.curves.iter().zip(0..) {
        let line = &curve.polyline;
        let last = line.len() - 1;
        let coarser = |step: usize| -> Vec<[f64; 2]> {
            line.iter().enumerate().filter(|(k, _)| k % step == 0 || *k == last).map(|(_, point)| *point).collect()
        };
        let leaves = |points: &[[f64; 2]]| {
            let at = |l: f64| {
                points.windows(2).find(|pair| pair[1][1] >= l).map(|pair| {
                    let [[h, from], [h_to, to]] = [pair[0], pair[1]];
                    h + (h_to - h) * (l - from) / (to - from)
                })
            };
            // Twice the bound on chords, and as steep as the steepest here.
            let steepest = points.windows(2).map(|pair| (pair[1][0] - pair[0][0]) / (pair[1][1] - pair[0][1]));
            let most = 2.0 * height / 800.0 * (steepest.fold(0.0, f64::max) * width / height).max(1.0);
            line.iter().any(|[h, l]| at(*l).is_some_and(|chord| (h - chord).abs() > most))
        };
        for step in [8, 64] {
            let other = coarser(step);
            if leaves(&other) {
                let refused = forged(&true_one, |d| d.curves[number].polyline.clone_from(&other));
                assert_eq!(refused, Err(Refused::Field { field: "curves.polyline" }), "{} {step}", curve.id);
                forged_ones += 1;
            }
        }
    }
    assert!(forged_ones > 3, "{forged_ones}");
}

/// The area within a closed outline.
fn area(outline: &[[f64; 2]]) -> f64 {
    0.5 * outline.windows(2).map(|edge| edge[0][1] * edge[1][0] - edge[1][1] * edge[0][0]).sum::<f64>().abs()
}

/// Widths of a body that are reached but exceeded elsewhere: those of unbounded regions at finite places.
#[test]
fn widths_that_are_exceeded_far_out_are_refused() {
    let true_one = whole(&body([["1", "2", "3"], ["0.4", "0.5", "0.77"]]));
    verify(&true_one).unwrap();
    let mut forged_ones = 0;
    for (region, number) in true_one.regions.iter().zip(0..) {
        let (Some(width), [Some(from), None]) = (region.h_width, region.l_range) else { continue };
        let curve = |id: &String| true_one.curves.iter().find(|curve| curve.id == *id).unwrap();
        let height = |id: &String, l: f64| {
            let line = &curve(id).polyline;
            let after = line.iter().position(|point| point[1] >= l)?.max(1);
            let [p, q] = [line[after - 1], line[after]];
            Some(p[0] + (q[0] - p[0]) * (l - p[1]) / (q[1] - p[1]))
        };
        let cell = region.cells.last().unwrap();
        for l in [1.01, 1.5, 2.0, 3.0].map(|share| share * from.max(0.1)) {
            let gap = height(cell.upper.as_ref().unwrap(), l).zip(height(&cell.lower, l)).map(|(high, low)| high - low);
            if let Some(gap) = gap.filter(|gap| *gap < width * (1.0 - 1e-4)) {
                let refused = forged(&true_one, |d| d.regions[number].h_width = Some(gap));
                assert!(matches!(refused, Err(Refused::Region { .. })), "{}: {gap} of {width}", region.id);
                forged_ones += 1;
            }
        }
    }
    assert!(forged_ones > 3, "{forged_ones}");
}

/// Two close moments and r beside a plane: a cell of the region lies so far out that h in doubles tells nothing of its width,
/// and J of both its curves is the same double. The widths are those of 80 digits.
#[test]
fn widths_of_cells_far_out_are_true_and_no_others_are_confirmed() {
    let moments = ["1", "1.000000000000001", "1.7"];
    for (r_3, width) in [("1e-8", 0.058_912_204_261_928_5), ("1e-9", 6.105_062_067_323_444e-6)] {
        let true_one = whole(&body([moments, ["0.3", "0.2", r_3]]));
        verify(&true_one).unwrap();
        let is_it = |stated: f64| (stated - width).abs() < 1e-8 * width;
        let number = true_one.regions.iter().position(|region| region.h_width.is_some_and(is_it)).unwrap();
        for other in [0.9, 0.99, 1.01, 1.1, 100.0, 1e7].map(|factor| factor * width) {
            let refused = forged(&true_one, |d| d.regions[number].h_width = Some(other));
            assert!(matches!(refused, Err(Refused::Region { .. })), "{r_3}: {other} of {width}: {refused:?}");
        }
    }
}

/// Bodies whose curves run side by side over x up to 10¹⁵.
#[test]
fn widths_between_curves_of_close_moments_are_verified() {
    for [second, r] in [
        ["1.00000000000001", "0.3,0.2,1e-9"],
        ["1.0000000000000001", "0.3,0.2,1e-9"],
        ["1.000000000000001", "0.5,0.2,3e-9"],
        ["1.000000000000001", "0.3,0.6,1e-9"],
    ] {
        let r: Vec<&str> = r.split(',').collect();
        let document = whole(&body([["1", second, "1.7"], [r[0], r[1], r[2]]]));
        verify(&document).unwrap_or_else(|refused| panic!("{second} {r:?}: {refused}"));
    }
}
