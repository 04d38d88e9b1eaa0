//! Which steady rotations are nearest to an axis at fast spins.

use bifdiag_body::{Body, Number};
use bifdiag_numbers::vector::{dot, norm, normalised};

use crate::critical::{FamilyPoint, Multiplicity, SteadyFamily, SteadyStretch};

/// The families whose axes are nearest to a direction that points up, at fast spins: several if they are equally near,
/// none if all of them are perpendicular to it. Of a symmetric pair the one on that side, of a circle the nearest.
#[must_use]
pub fn fastest_along(body: &Body, families: &[SteadyFamily], up: [f64; 3]) -> Vec<SteadyFamily> {
    /// Cosines that differ by less are the same.
    const TIE: f64 = 1e-9;
    // γ points down; a pair has both ends, a circle all directions of its plane.
    let along = |family: &SteadyFamily| match family.axes {
        Multiplicity::Circle | Multiplicity::Sphere => norm(in_plane_of(body, family, up)),
        Multiplicity::Points(1) => -dot(family.fast, up),
        Multiplicity::Points(_) => dot(family.fast, up).abs(),
    };
    let most = families.iter().map(along).fold(0.0, f64::max);
    let nearest = families.iter().filter(|family| most > TIE && along(family) > most - TIE).cloned();
    let on_that_side = |family: SteadyFamily| match family.axes {
        Multiplicity::Circle => {
            let down = normalised(in_plane_of(body, &family, up)).map(|x| 0.0 - x);
            let from = family.fast;
            moved(family, |gamma| {
                let share = dot(gamma, from);
                std::array::from_fn(|k| gamma[k] + share * (down[k] - from[k]))
            })
        }
        Multiplicity::Points(2) if dot(family.fast, up) > 0.0 => mirrored(family),
        _ => family,
    };
    nearest.map(on_that_side).collect()
}

/// The share of a direction in the plane of the moments that are equal to that of a family at fast spins.
fn in_plane_of(body: &Body, family: &SteadyFamily, up: [f64; 3]) -> [f64; 3] {
    let moments = body.moments().each_ref().map(Number::value);
    let own = largest(family.fast);
    std::array::from_fn(|k| if moments[k] == moments[own] { up[k] } else { 0.0 })
}

fn largest(v: [f64; 3]) -> usize {
    v.iter().enumerate().max_by(|p, q| p.1.abs().total_cmp(&q.1.abs())).map_or(0, |(k, _)| k)
}

/// The other one of a symmetric pair, reflected in the principal plane from which both come: across it both are farthest apart
/// at fast spins, where they tend to the two ends of a principal axis.
fn mirrored(family: SteadyFamily) -> SteadyFamily {
    let across = largest(family.fast);
    moved(family, |mut gamma| {
        gamma[across] = 0.0 - gamma[across];
        gamma
    })
}

/// The family with every γ moved.
fn moved(family: SteadyFamily, by: impl Fn([f64; 3]) -> [f64; 3]) -> SteadyFamily {
    let place = |place: FamilyPoint| FamilyPoint { gamma: by(place.gamma), ..place };
    let stretch = |stretch: SteadyStretch| SteadyStretch { from: stretch.from.map(place), ..stretch };
    SteadyFamily {
        slow: family.slow.map(&by),
        fast: by(family.fast),
        stretches: family.stretches.into_iter().map(stretch).collect(),
        ..family
    }
}
