//! A part whose numbers are known to within a tolerance each.

use bifdiag_numbers::enclosure::{Arithmetic, Enclosure};
use bifdiag_numbers::interval::Interval;
use bifdiag_numbers::symmetric::Symmetric;
use dashu_ratio::RBig;

use crate::part::mass::{MassError, MassProperties};
use crate::part::units::Units;

/// A number, and how far the true one may be from it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Measured {
    /// The nominal value.
    pub value: RBig,
    /// The largest deviation, not negative; zero for a number that is exact.
    pub within: RBig,
}

impl Measured {
    /// The number at `step` of its deviation, from −1 to 1.
    fn at(&self, step: &RBig) -> RBig {
        &self.value + &self.within * step
    }

    /// All that it may be.
    #[must_use]
    pub fn enclosed(&self) -> Interval {
        let end = |value: RBig| Interval::rational(&value, ());
        end(&self.value - &self.within).hull(&end(&self.value + &self.within))
    }
}

/// How many numbers a part has: six of the tensor, three of the centre of mass, the mass and gravity.
pub const INPUTS: usize = 11;

/// Position of the centre of mass among them.
const COM: usize = 6;

/// Their names.
const INPUT_NAMES: [&str; INPUTS] = ["Ixx", "Iyy", "Izz", "Ixy", "Ixz", "Iyz", "com x", "com y", "com z", "mass", "g"];

/// The numbers of a part as they were measured.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MeasuredPart {
    /// The tensor is about the centre of mass, else about the fixed point.
    pub about_com: bool,
    /// Ixx, Iyy, Izz, Ixy, Ixz, Iyz as entries of the tensor, the centre of mass from the fixed point, the mass, and the
    /// acceleration of gravity in m/s².
    pub inputs: [Measured; INPUTS],
    /// The fixed point in the axes in which the part was described; the centre of mass above is seen from it.
    pub pivot: [Measured; 3],
}

impl MeasuredPart {
    /// From the numbers of the part itself, and gravity.
    #[must_use]
    pub fn new(about_com: bool, part: [Measured; INPUTS - 1], gravity: Measured) -> Self {
        let mut inputs = part.into_iter().chain([gravity]);
        let next = |_| inputs.next().unwrap_or_else(|| unreachable!("as many as there are"));
        let zero = Measured { value: RBig::ZERO, within: RBig::ZERO };
        Self { about_com, inputs: std::array::from_fn(next), pivot: std::array::from_fn(|_| zero.clone()) }
    }

    /// With the centre of mass and a pivot in the same axes, both as they were measured: the vector between them counts.
    #[must_use]
    pub fn seen_from(mut self, pivot: [Measured; 3]) -> Self {
        for (coordinate, pivot) in self.inputs[COM..].iter_mut().zip(&pivot) {
            coordinate.value -= &pivot.value;
            coordinate.within += &pivot.within;
        }
        Self { pivot, ..self }
    }

    /// The centre of mass in the axes of the pivot.
    #[must_use]
    pub fn com(&self) -> [Measured; 3] {
        std::array::from_fn(|k| {
            let (between, pivot) = (&self.inputs[COM + k], &self.pivot[k]);
            Measured { value: &between.value + &pivot.value, within: &between.within - &pivot.within }
        })
    }

    /// What one of the numbers is called, and its nominal value.
    #[must_use]
    pub fn named(&self, input: usize) -> (&'static str, &RBig) {
        /// Where the pivot alone, or both, are not exact.
        const NAMES: [[&str; 2]; 3] =
            [["pivot x", "com x - pivot x"], ["pivot y", "com y - pivot y"], ["pivot z", "com z - pivot z"]];
        let own = &self.inputs[input];
        let pivot = input.checked_sub(COM).and_then(|k| Some((self.pivot.get(k)?, NAMES[k])));
        match pivot {
            Some((pivot, [name, _])) if !pivot.within.is_zero() && pivot.within == own.within => (name, &pivot.value),
            Some((pivot, [_, both])) if !pivot.within.is_zero() || !pivot.value.is_zero() => (both, &own.value),
            _ => (INPUT_NAMES[input], &own.value),
        }
    }

    /// Indices of the numbers that are not exact.
    pub fn uncertain(&self) -> impl Iterator<Item = usize> {
        (0..INPUTS).filter(|&k| !self.inputs[k].within.is_zero())
    }

    /// The nominal part, all of its numbers exact.
    #[must_use]
    pub fn nominal(&self) -> Self {
        let exact = |number: &Measured| Measured { value: number.value.clone(), within: RBig::ZERO };
        Self { inputs: self.inputs.each_ref().map(exact), ..self.clone() }
    }

    /// The same part with all numbers but this one exact.
    #[must_use]
    pub fn only(&self, input: usize) -> Self {
        let mut only = self.clone();
        for (k, measured) in only.inputs.iter_mut().enumerate() {
            if k != input {
                measured.within = RBig::ZERO;
            }
        }
        only
    }

    /// The part each of whose numbers deviates by `steps` times its tolerance, with steps from −1 to 1, and gravity there.
    ///
    /// # Errors
    /// [`MassError`] for a mass that is not positive.
    pub fn at(&self, steps: &[RBig; INPUTS]) -> Result<(MassProperties, RBig), MassError> {
        let values: [RBig; INPUTS] = std::array::from_fn(|k| self.inputs[k].at(&steps[k]));
        let [xx, yy, zz, xy, xz, yz, x, y, z, mass, gravity] = values;
        let (tensor, com) = (Symmetric::new([xx, yy, zz, xy, xz, yz]), [x, y, z]);
        let properties = if self.about_com {
            MassProperties::about_com(mass, com, tensor)
        } else {
            MassProperties::about_origin(mass, com, &tensor)
        };
        Ok((properties?, gravity))
    }

    /// Bounds on the tensor about the fixed point and on r = m g c, in the units of the part.
    #[must_use]
    pub fn bounds(&self, units: &Units) -> ([[Interval; 3]; 3], [Interval; 3]) {
        let [xx, yy, zz, xy, xz, yz, x, y, z, mass, gravity] = self.inputs.each_ref().map(Measured::enclosed);
        let (com, shift) = ([x, y, z], if self.about_com { mass } else { Interval::ZERO });
        let given = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]];
        let tensor = std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                // m (|c|² E − c cᵀ)
                let moved =
                    if i == j { com[(i + 1) % 3].square() + com[(i + 2) % 3].square() } else { -(com[i] * com[j]) };
                given[i][j] + shift * moved
            })
        });
        let weight = mass * gravity * Interval::rational(&units.acceleration(&RBig::ONE), ());
        (tensor, com.map(|c| weight * c))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn exact(value: i64) -> RBig {
        RBig::from(value)
    }

    #[test]
    fn every_part_of_the_box_lies_within_the_bounds() {
        let numbers = [30, 40, 50, 1, -2, 3, 1, 2, -4, 5, 10];
        for about_com in [true, false] {
            let measured =
                |k: usize| Measured { value: exact(numbers[k]), within: RBig::from_parts(1.into(), (k + 2).into()) };
            let part = MeasuredPart::new(about_com, std::array::from_fn(measured), measured(10));
            let units: Units = "kg,cm,s".parse().unwrap();
            let (tensor, center) = part.bounds(&units);
            for number in 0..200_usize {
                // −1, −1/2, 0, 1/2, 1 for each.
                let steps: [RBig; INPUTS] = std::array::from_fn(|k| {
                    let digit = (number * 7919 + (k + 1) * 104_729 + number / (k + 1)) % 5;
                    RBig::from_parts(digit.into(), 2u32.into()) - RBig::ONE
                });
                let (found, gravity) = part.at(&steps).unwrap();
                let about = found.tensor_about_origin();
                let within = |bounds: Interval, value: &RBig| {
                    let [lo, hi] = bounds.exact_bounds().unwrap();
                    assert!(lo <= *value && *value <= hi, "{bounds:?} {value}");
                };
                for i in 0..3 {
                    for j in 0..3 {
                        within(tensor[i][j], &about.rows()[i][j]);
                    }
                    within(center[i], &(&found.com[i] * &found.mass * &gravity * RBig::from(100)));
                }
            }
        }
    }

    #[test]
    fn exact_numbers_stay_exact() {
        let inputs: Vec<Measured> = (1..INPUTS)
            .map(|k| Measured { value: RBig::from(k), within: if k == 8 { RBig::ONE } else { RBig::ZERO } })
            .collect();
        let one = Measured { value: RBig::ONE, within: RBig::ZERO };
        let part = MeasuredPart::new(false, inputs.try_into().unwrap(), one);
        assert_eq!(part.uncertain().collect::<Vec<_>>(), [7]);
        assert_eq!(part.only(3).uncertain().count(), 0);
        let (tensor, center) = part.bounds(&Units::default());
        assert_eq!(tensor[0][1], Interval::point(4.0));
        // Products round outward.
        for (bounds, [from, to]) in [(center[0], [70.0, 70.0]), (center[1], [70.0, 90.0])] {
            assert!(bounds.lo <= from && to <= bounds.hi, "{bounds:?}");
            assert!(from - bounds.lo < 1e-12 && bounds.hi - to < 1e-12, "{bounds:?}");
        }
    }
}
