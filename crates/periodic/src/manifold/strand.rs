//! The manifolds of an equilibrium with one real and one imaginary pair: two motions leave it and two approach it.

use bifdiag_dynamics::section::SectionError;
use bifdiag_schema::{ManifoldEnd, ManifoldKind};

use super::crossing::RESIDUAL;
use super::curve::{Curve, Vertex};
use super::model::{Manifold, Manifolds};
use super::series::Series;
use super::world::{Course, World};
use crate::flow::Phase;
use crate::section_map::Image;

/// The most returns of a motion.
const RETURNS: usize = 100;
/// A motion is followed from two starting points; it ends where the two results differ by more than this.
const ACCURACY: f64 = 1e-8;
/// How much earlier on the motion the second starting point lies, in growth times.
const BEFORE: f64 = 1.0;

/// The two motions that leave an equilibrium in a world.
pub fn manifold(world: &World<'_>, place: usize, series: &Series) -> Result<Manifold, SectionError> {
    let time = BEFORE / series.rates[0].re;
    let angles = [0.0, std::f64::consts::PI];
    let starts: Vec<Phase> =
        angles.iter().flat_map(|angle| [0.0, -time].map(|t| series.at(series.coordinates(*angle, t)))).collect();
    let courses = world.courses(&starts, RETURNS)?;
    let curves = courses.chunks(2).zip([1, -1]).map(|(pair, side)| curve(world, &pair[0], &pair[1], side)).collect();
    Ok(Manifold { orbit: place, kind: world.kind(), multiplier: None, curves, are_motions: true })
}

/// The crossings at which the results from both starting points agree.
fn curve(world: &World<'_>, course: &Course, other: &Course, side: i8) -> Curve {
    let agree = |pair: &(&Image, &Image)| (pair.0.point - pair.1.point).norm() <= ACCURACY;
    let pairs = course.images.iter().zip(&other.images).take_while(agree);
    let pieces: Vec<Vec<Vertex>> = pairs
        .enumerate()
        .map(|(level, (image, _))| vec![Vertex { point: world.mirrored(&image.point), level, s: f64::NEG_INFINITY }])
        .collect();
    let is_whole = pieces.len() == course.images.len() && pieces.len() == other.images.len();
    let end = if is_whole && course.came && other.came {
        ManifoldEnd::Orbit
    } else if pieces.len() == RETURNS {
        ManifoldEnd::Work
    } else {
        ManifoldEnd::Accuracy
    };
    Curve { end: Some(end), ..Curve::new((0, side), pieces, 0) }
}

/// How close leaving motions come to approaching ones, and which pairs agree from the first crossing to the last. Such
/// a pair does not prove a homoclinic orbit: manifolds split by about e^(−πω/λ), where ±λ and ±iω are the eigenvalues.
pub fn connect(found: &mut Manifolds) {
    let of = |kind: ManifoldKind| {
        let own = found.manifolds.iter().filter(move |manifold| manifold.kind == kind && manifold.are_motions);
        own.flat_map(|manifold| manifold.curves.iter().map(move |curve| (manifold.orbit, points(curve), curve.end)))
    };
    let mut contacts: Vec<[usize; 2]> = Vec::new();
    let mut alike: Vec<Phase> = Vec::new();
    for (from, leaving, end) in of(ManifoldKind::Unstable) {
        for (to, coming, other) in of(ManifoldKind::Stable) {
            if leaving.is_empty() || leaving.len() != coming.len() || [end, other] != [Some(ManifoldEnd::Orbit); 2] {
                continue;
            }
            let apart = leaving.iter().zip(coming.iter().rev()).map(|(a, b)| (a - b).norm());
            let residual = apart.fold(0.0, f64::max);
            if residual > RESIDUAL {
                continue;
            }
            contacts.push([from, to]);
            alike.extend([leaving[0], coming[0]]);
        }
    }
    let all = [ManifoldKind::Unstable, ManifoldKind::Stable]
        .map(|kind| of(kind).flat_map(|(_, points, _)| points).collect::<Vec<Phase>>());
    for [from, to] in contacts {
        found.touch(from, to);
    }
    for manifold in found.manifolds.iter_mut().filter(|manifold| manifold.are_motions) {
        let others = &all[usize::from(manifold.kind == ManifoldKind::Unstable)];
        for curve in &mut manifold.curves {
            let apart = points(curve).into_iter().flat_map(|a| others.iter().map(move |b| (a - b).norm()));
            curve.nearest = apart.min_by(f64::total_cmp);
            // Where a motion that comes this close goes is unknown, unless it is also one that approaches.
            let is_alike = points(curve).first().is_some_and(|first| alike.contains(first));
            if curve.end == Some(ManifoldEnd::Orbit) && !is_alike {
                curve.end = Some(ManifoldEnd::Accuracy);
            }
        }
    }
}

fn points(curve: &Curve) -> Vec<Phase> {
    curve.pieces.iter().flatten().map(|vertex| vertex.point).collect()
}
