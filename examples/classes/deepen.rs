//! Bodies deep in their cells.

use rand_xoshiro::SplitMix64;
use rand_xoshiro::rand_core::SeedableRng;

use bifdiag_body::Body;
use bifdiag_diagram::class::ClassName;
use bifdiag_exact::Accuracy;
use bifdiag_survey::border::class_of;
use bifdiag_survey::nearest::{NearestBorder, NearestOptions, nearest};
use bifdiag_survey::space::{BodySet, ReducedBody, TangentBasis};

use crate::chord::chord;

/// Significant digits of the numbers of a witness, at most.
const DIGITS: usize = 6;

/// Goes to the middle of its class on `lines` random lines, one after the other.
#[must_use]
pub fn centre(start: ReducedBody, class: &ClassName, lines: u32, domain: BodySet, seed: u64) -> ReducedBody {
    let mut rng = SplitMix64::seed_from_u64(seed);
    let mut place = start;
    for _ in 0..lines {
        let chart = TangentBasis::new(place);
        let Some(line) = chart.line(&chart.random(&mut rng), domain) else { break };
        let end = |forth| chord(&line, &line.nodes(forth, 0.5), true).stretches.first().map_or(0.0, |own| own.s[1]);
        let next = ReducedBody::of(line.at(0.5 * (end(false) + end(true))));
        if is_of(next.values(), class, Accuracy::Fast) {
            place = next;
        }
    }
    place
}

/// Goes away from the borders around a body, and from special bodies, over `steps` steps; gives the body that was
/// farthest from them, and how far it was.
///
/// Each step leads against the sum of the directions to all borders, in which near ones weigh most.
#[must_use]
pub fn deepen(start: ReducedBody, class: &ClassName, steps: u32, options: &NearestOptions) -> (ReducedBody, f64) {
    /// How much nearer borders weigh more.
    const SHARPNESS: f64 = 6.0;
    let (mut place, mut best) = (start, (start, 0.0));
    for step in 0..steps {
        let chart = TangentBasis::new(place);
        let options = NearestOptions { seed: options.seed.wrapping_add(u64::from(step)), ..*options };
        let mut around: Vec<(f64, Vec<f64>)> =
            around(place, &options).into_iter().map(|border| (border.distance, border.direction)).collect();
        around.extend(to_special(place, &chart));
        let distance = around.iter().map(|(distance, _)| *distance).fold(f64::INFINITY, f64::min);
        if distance > best.1 {
            best = (place, distance);
        }
        let mut away = vec![0.0; chart.dimensions()];
        for (far, direction) in &around {
            let weight = libm::exp(-SHARPNESS * (far / distance - 1.0));
            away.iter_mut().zip(direction).for_each(|(x, y)| *x -= weight * y);
        }
        let length = away.iter().map(|x| x * x).sum::<f64>().sqrt();
        if !(length > 0.0 && length.is_finite()) {
            break;
        }
        let stride = distance * (0.6 - 0.5 * f64::from(step) / f64::from(steps));
        let coordinates: Vec<f64> = away.iter().map(|x| stride * (x / length)).collect();
        let next =
            body_at(&chart, &coordinates, options.set).filter(|next| is_of(next.values(), class, Accuracy::Fast));
        // Where the way is barred, the next step begins at the best place, with other lines.
        place = next.unwrap_or(best.0);
    }
    best
}

/// A body near to a place, with as few digits as leave it in its class and most of its distance to all borders; that
/// distance with it.
#[must_use]
pub fn plain(place: ReducedBody, class: &ClassName, distance: f64, options: &NearestOptions) -> ([[f64; 3]; 2], f64) {
    const KEPT: f64 = 0.9;
    let room = |values: [[f64; 3]; 2]| {
        let place = ReducedBody::of(values);
        let borders = around(place, options).into_iter().map(|border| border.distance);
        let special = to_special(place, &TangentBasis::new(place)).into_iter().map(|(distance, _)| distance);
        borders.chain(special).fold(f64::INFINITY, f64::min)
    };
    // With fewer digits the body is likely to leave its class.
    let first = (1..DIGITS)
        .zip([0.1, 1e-2, 1e-3, 1e-4, 1e-5])
        .find(|(_, unit)| *unit <= distance)
        .map_or(DIGITS, |(digits, _)| digits);
    for digits in first..=DIGITS {
        let values = place.values().map(|part| part.map(|x| format!("{x:.*e}", digits - 1).parse().unwrap_or(x)));
        let same_kind =
            TangentBasis::new(ReducedBody::of(values)).dimensions() == TangentBasis::new(place).dimensions();
        if same_kind && ReducedBody::of(values).is_in(options.set) && is_of(values, class, Accuracy::Exact) {
            let left = room(values);
            if left >= KEPT * distance {
                return (values, left.min(distance));
            }
        }
    }
    (place.values(), room(place.values()).min(distance))
}

/// The borders around a body; none where it has no class.
fn around(place: ReducedBody, options: &NearestOptions) -> Vec<NearestBorder> {
    let [a, r] = place.values();
    let own = Body::from_f64(a, r)
        .ok()
        .and_then(|body| class_of(&body, Accuracy::Fast).or_else(|_open| class_of(&body, Accuracy::Exact)).ok());
    own.map_or_else(Vec::new, |(_, class)| nearest(place, class, options))
}

fn is_of([a, r]: [[f64; 3]; 2], class: &ClassName, accuracy: Accuracy) -> bool {
    Body::from_f64(a, r).is_ok_and(|body| class_of(&body, accuracy).is_ok_and(|(_, found)| found.name() == class))
}

/// How far it is to each kind of bodies that are special, by equal moments or a component of r that is 0, where this one is
/// not; and the coordinates of the direction there, of length 1.
fn to_special(ReducedBody { a, r }: ReducedBody, basis: &TangentBasis) -> Vec<(f64, Vec<f64>)> {
    let unit = |k: usize| -> [f64; 3] { std::array::from_fn(|i| f64::from(u8::from(i == k))) };
    let mut found = Vec::with_capacity(5);
    let mut note = |distance: f64, change: [[f64; 3]; 2]| {
        let slope = basis.coordinates(&change);
        let length = slope.iter().map(|x| x * x).sum::<f64>().sqrt();
        if distance > 0.0 && length > 0.0 {
            found.push((distance, slope.into_iter().map(|x| x / length).collect()));
        }
    };
    for (i, j) in [(0, 1), (1, 2)] {
        // The nearest A with A_i = A_j has the mean of both in their place.
        let change = std::array::from_fn(|k| unit(i)[k] - unit(j)[k]);
        note((a[j] - a[i]) / std::f64::consts::SQRT_2, [change, [0.0; 3]]);
    }
    for k in 0..3 {
        // r_k is the sine of the angle between r and the plane.
        note(libm::asin(r[k].min(1.0)), [[0.0; 3], unit(k).map(|x| -x)]);
    }
    found
}

/// The body at these coordinates, on the line through them.
fn body_at(basis: &TangentBasis, coordinates: &[f64], set: BodySet) -> Option<ReducedBody> {
    let length = coordinates.iter().map(|x| x * x).sum::<f64>().sqrt();
    let line = basis.line(coordinates, set)?;
    (length < line.reach()[1]).then(|| ReducedBody::of(line.at(length)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nearest_special_body_is_as_far_as_it_is() {
        let place = ReducedBody::of([[0.5, 0.6, 0.9], [0.6, 0.0, 0.8]]);
        let chart = TangentBasis::new(place);
        let special = to_special(place, &chart);
        assert_eq!(special.len(), 4);
        for (distance, direction) in special {
            let line = chart.line(&direction, BodySet::All).unwrap();
            assert!((line.distance(line.reach()[1]) - distance).abs() < 0.3 * distance, "{distance}");
        }
    }
}
