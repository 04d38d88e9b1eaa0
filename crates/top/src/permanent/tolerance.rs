//! What uncertain moments and weight do to the spins at which a rotation changes.

use dashu_ratio::RBig;

use super::rotation::{AxisRotation, SpinType};

/// The inputs that are varied, as they are told.
const INPUTS: [&str; 4] =
    ["moment about the axis", "first other moment", "second other moment", "weight times distance"];

/// The spins at which one change happens over a box of parts.
#[derive(Clone, Debug, PartialEq)]
pub struct SpinRange {
    /// The change.
    pub types: [SpinType; 2],
    /// Least and largest spin, over the parts that were tried.
    pub omega: [f64; 2],
    /// The input that moves it most by itself, and by how much of the spin.
    pub most: (&'static str, f64),
}

/// All changes over a box of parts.
#[derive(Clone, Debug, PartialEq)]
pub struct SpinRanges {
    /// Each change of the nominal part; empty when not all parts have the same changes.
    pub changes: Vec<SpinRange>,
    /// All parts that were tried have the same changes in the same order.
    pub same: bool,
    /// How many were tried.
    pub parts: usize,
}

/// Varies the three moments and the weight by a relative tolerance each: all 81 combinations of less, nominal and more.
/// That is a sample of the box, not a bound over it.
#[must_use]
pub fn spin_ranges(rotation: &AxisRotation, tolerance: &RBig) -> SpinRanges {
    let nominal = rotation.changes();
    let types = |found: &[super::SpinChange]| found.iter().map(|c| [c.from, c.to]).collect::<Vec<_>>();
    let mut changes: Vec<SpinRange> = nominal
        .iter()
        .map(|c| SpinRange { types: [c.from, c.to], omega: [c.omega, c.omega], most: (INPUTS[0], 0.0) })
        .collect();
    let mut same = true;
    for number in 0..81_i8 {
        let steps = [number % 3 - 1, number / 3 % 3 - 1, number / 9 % 3 - 1, number / 27 - 1];
        let found = varied(rotation, steps, tolerance).changes();
        if types(&found) != types(&nominal) {
            same = false;
            continue;
        }
        let alone = (steps.iter().filter(|step| **step != 0).count() == 1).then(|| steps.iter().position(|s| *s != 0));
        for (range, change) in changes.iter_mut().zip(&found) {
            range.omega = [range.omega[0].min(change.omega), range.omega[1].max(change.omega)];
        }
        if let Some(input) = alone.flatten() {
            for ((range, change), nominal) in changes.iter_mut().zip(&found).zip(&nominal) {
                let moved = (change.omega / nominal.omega - 1.0).abs();
                if moved > range.most.1 {
                    range.most = (INPUTS[input], moved);
                }
            }
        }
    }
    SpinRanges { changes: if same { changes } else { Vec::new() }, same, parts: 81 }
}

/// Each input times 1 + step · tolerance.
fn varied(rotation: &AxisRotation, steps: [i8; 4], tolerance: &RBig) -> AxisRotation {
    let factor = |step: i8| RBig::ONE + tolerance * RBig::from(step);
    let mut varied = rotation.clone();
    for (moment, step) in varied.moments.iter_mut().zip(steps) {
        *moment = &*moment * factor(step);
    }
    varied.weight = &rotation.weight * factor(steps[3]);
    varied
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::body::Body;

    /// Ω = 2 √(Ar)/C of a top that is symmetric: C counts once, A and r half.
    #[test]
    fn the_axial_moment_matters_most_to_a_sleeping_top() {
        let body = Body::parse(&["2", "2.000001", "0.5"], &["0", "0", "3"]).unwrap();
        let rotation = AxisRotation::new(&body, 2, -1).unwrap();
        let percent = RBig::from_parts(1.into(), 100u32.into());
        let found = spin_ranges(&rotation, &percent);
        let last = found.changes.last().unwrap();
        assert_eq!(last.most.0, INPUTS[0]);
        assert!((last.most.1 - 1.0 / 99.0).abs() < 1e-5, "{found:?}");
        let nominal = 4.0 * 6.0_f64.sqrt();
        assert!(last.omega[0] < 0.985 * nominal && last.omega[1] > 1.015 * nominal);
    }
}
