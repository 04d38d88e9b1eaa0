//! Bodies deep in their cells.

use rand_xoshiro::SplitMix64;
use rand_xoshiro::rand_core::SeedableRng;

use super::chart::Chart;
use super::chord::chord;
use super::nearest::{NearestOptions, nearest, unit};
use super::place::{Domain, Place};
use crate::border::class_of;
use crate::digits::{DIGITS, rounded};
use bifdiag_body::Body;
use bifdiag_diagram::class::ClassName;
use bifdiag_exact::Accuracy;

/// Goes to the middle of its class on so many random lines, one after the other.
#[must_use]
pub fn centre(start: Place, class: &ClassName, lines: u32, domain: Domain, seed: u64) -> Place {
    let mut rng = SplitMix64::seed_from_u64(seed);
    let mut place = start;
    for _ in 0..lines {
        let chart = Chart::new(place);
        let Some(line) = chart.line(&chart.random(&mut rng), domain) else { break };
        let end = |forth| chord(&line, &line.nodes(forth, 0.5), true).stretches.first().map_or(0.0, |own| own.s[1]);
        let next = Place::of(line.at(0.5 * (end(false) + end(true))));
        if is_of(next.values(), class, Accuracy::Fast) {
            place = next;
        }
    }
    place
}

/// Goes away from the borders around a body, and from special bodies, as far as so many steps lead; gives the body that was
/// farthest from them, and how far it was.
///
/// Each step leads against the sum of the directions to all borders, in which near ones weigh most.
#[must_use]
pub fn deepen(start: Place, class: &ClassName, steps: u32, options: &NearestOptions) -> (Place, f64) {
    /// How much nearer borders weigh more.
    const SHARPNESS: f64 = 6.0;
    let (mut place, mut best) = (start, (start, 0.0));
    for step in 0..steps {
        let chart = Chart::new(place);
        let options = NearestOptions { seed: options.seed.wrapping_add(u64::from(step)), ..*options };
        let mut around: Vec<(f64, Vec<f64>)> =
            nearest(place, &options).into_iter().map(|border| (border.distance, border.direction)).collect();
        around.extend(chart.to_special());
        let distance = around.iter().map(|(distance, _)| *distance).fold(f64::INFINITY, f64::min);
        if distance > best.1 {
            best = (place, distance);
        }
        let mut away = vec![0.0; chart.dimensions()];
        for (far, direction) in &around {
            let weight = libm::exp(-SHARPNESS * (far / distance - 1.0));
            away.iter_mut().zip(direction).for_each(|(x, y)| *x -= weight * y);
        }
        let Some(away) = unit(away) else { break };
        let stride = distance * (0.6 - 0.5 * f64::from(step) / f64::from(steps));
        let coordinates: Vec<f64> = away.iter().map(|x| stride * x).collect();
        let next = chart.body(&coordinates, options.domain).filter(|next| is_of(next.values(), class, Accuracy::Fast));
        // Where the way is barred, the next step begins at the best place, with other lines.
        place = next.unwrap_or(best.0);
    }
    best
}

/// A body near to a place, with as few digits as leave it in its class and most of its distance to all borders; that
/// distance with it.
#[must_use]
pub fn plain(place: Place, class: &ClassName, distance: f64, options: &NearestOptions) -> ([[f64; 3]; 2], f64) {
    const KEPT: f64 = 0.9;
    let room = |values: [[f64; 3]; 2]| {
        let place = Place::of(values);
        let borders = nearest(place, options).into_iter().map(|border| border.distance);
        let special = Chart::new(place).to_special().into_iter().map(|(distance, _)| distance);
        borders.chain(special).fold(f64::INFINITY, f64::min)
    };
    // With fewer digits the body is likely to leave its class.
    let first = (1..DIGITS)
        .zip([0.1, 1e-2, 1e-3, 1e-4, 1e-5])
        .find(|(_, unit)| *unit <= distance)
        .map_or(DIGITS, |(digits, _)| digits);
    for digits in first..=DIGITS {
        let values = place.values().map(|part| part.map(|x| rounded(x, digits)));
        let same_kind = Chart::new(Place::of(values)).dimensions() == Chart::new(place).dimensions();
        if same_kind && Place::of(values).is_in(options.domain) && is_of(values, class, Accuracy::Exact) {
            let left = room(values);
            if left >= KEPT * distance {
                return (values, left.min(distance));
            }
        }
    }
    (place.values(), room(place.values()).min(distance))
}

fn is_of([a, r]: [[f64; 3]; 2], class: &ClassName, accuracy: Accuracy) -> bool {
    Body::from_f64(a, r).is_ok_and(|body| class_of(&body, accuracy).is_ok_and(|(_, found)| found.name() == class))
}
