//! Numbered lists of bodies.

use dashu_ratio::RBig;
use thiserror::Error;

use crate::parameter::ParameterRange;
use bifdiag_body::{Body, BodyError};
use bifdiag_numbers::Number;
use bifdiag_numbers::sequence::{self, point};
use bifdiag_schema::BodyParameter;

/// The bodies among which a scan chooses.
#[derive(Clone, Debug, PartialEq, Eq)]
#[expect(clippy::large_enum_variant, reason = "there is one design in a scan")]
pub enum BodyFamily {
    /// Every body that exists, up to its symmetries and units: A_i = 1 − m_i, where the second moments of mass m are
    /// uniform on the simplex m1 + m2 + m3 = 1, and r̂ uniform on the positive octant of the sphere, |r| = 1. Four
    /// parameters.
    General,
    /// As `general`, but with A itself uniform on the simplex A1 + A2 + A3 = 1, whether or not a body has these moments.
    Positive,
    /// A = (1, A2, A3), r = (1, 0, 0): the centre of mass on a principal axis. Two parameters.
    Katok,
    /// One body with some of its parameters varied.
    Body {
        /// A1, A2, A3 where not varied.
        moments: [Number; 3],
        /// r1, r2, r3 where not varied.
        center: [Number; 3],
    },
    /// Bodies that are given one by one.
    Listed(BodyList),
}

/// Bodies that are given one by one. Lists are equal if their digests are.
#[derive(Clone, Debug)]
pub struct BodyList {
    digest: String,
    bodies: Vec<[[f64; 3]; 2]>,
}

impl BodyList {
    /// A and r of each body, with a digest of all of them; only with the digest where the bodies themselves are not at hand.
    #[must_use]
    pub fn new(digest: String, bodies: Vec<[[f64; 3]; 2]>) -> Self {
        Self { digest, bodies }
    }

    /// The digest.
    #[must_use]
    pub fn digest(&self) -> &str {
        &self.digest
    }

    /// A and r of body n: no numbers where it is not at hand.
    fn values(&self, n: u64) -> [[f64; 3]; 2] {
        let body = usize::try_from(n).ok().and_then(|n| self.bodies.get(n));
        body.copied().unwrap_or([[f64::NAN; 3]; 2])
    }
}

impl PartialEq for BodyList {
    fn eq(&self, other: &Self) -> bool {
        self.digest == other.digest
    }
}

impl Eq for BodyList {}

/// A numbered list of bodies.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Design {
    /// The bodies.
    pub family: BodyFamily,
    /// What varies; on a grid the last one varies fastest.
    pub vary: Vec<ParameterRange>,
    /// Number of points of the low-discrepancy sequence, or of the bodies of a list; absent for a grid.
    pub samples: Option<u64>,
    /// Seed of the sequence.
    pub seed: u64,
}

/// Why there is no such scan.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum DesignError {
    /// A list and the families `general` and `positive` choose all parameters themselves.
    #[error("the family chooses every parameter itself; to vary some of them give a body or the family katok")]
    NothingToVary,
    /// A body, and nothing that varies.
    #[error("nothing varies; give ranges such as A2=0.5:2:200, or A2=0.5:2 with a number of samples")]
    NothingVaries,
    /// A parameter twice.
    #[error("{parameter} is given twice")]
    Twice {
        /// Which.
        parameter: BodyParameter,
    },
    /// The family fixes it.
    #[error("the family katok keeps {parameter} fixed; it varies A2 and A3")]
    Fixed {
        /// Which.
        parameter: BodyParameter,
    },
    /// Some ranges with, some without a number of values.
    #[error("{parameter} has no number of values while others have; write it as {parameter}=from:to:N")]
    HalfGrid {
        /// Which has none.
        parameter: BodyParameter,
    },
    /// A grid and a number of samples.
    #[error("a grid has its own number of bodies; leave out the number of samples, or the numbers of grid values")]
    GridAndSamples,
    /// Neither grid nor samples.
    #[error("the number of samples is missing")]
    NoSamples,
    /// More parameters than the sequence has dimensions.
    #[error("{count} parameters are sampled; at most {max} can be", max = sequence::DIMENSIONS_MAX)]
    TooManyDimensions {
        /// How many.
        count: usize,
    },
    /// A moment would become zero or negative.
    #[error("{parameter} = {value} is no moment of inertia; it must be greater than zero")]
    NotPositive {
        /// Which.
        parameter: BodyParameter,
        /// The lower end.
        value: String,
    },
    /// More bodies than can be numbered.
    #[error("the grid has more than 2^53 bodies")]
    TooMany,
}

impl Design {
    /// Checks and completes a design: without ranges the family `katok` varies A2 and A3 from 3/10 to 17/10.
    ///
    /// # Errors
    /// [`DesignError`].
    pub fn new(
        family: BodyFamily,
        mut vary: Vec<ParameterRange>,
        samples: Option<u64>,
        seed: u64,
    ) -> Result<Self, DesignError> {
        let whole = matches!(family, BodyFamily::General | BodyFamily::Positive | BodyFamily::Listed(_));
        if whole && !vary.is_empty() {
            return Err(DesignError::NothingToVary);
        }
        if family == BodyFamily::Katok {
            if vary.is_empty() {
                let [from, to] = [(3, 10_u8), (17, 10)].map(|(p, q)| RBig::from_parts(p.into(), q.into()));
                vary.extend([BodyParameter::A2, BodyParameter::A3].map(|parameter| ParameterRange {
                    parameter,
                    from: Number::from_rational(from.clone()),
                    to: Number::from_rational(to.clone()),
                    steps: None,
                }));
            }
            let fixed = vary.iter().find(|range| !matches!(range.parameter, BodyParameter::A2 | BodyParameter::A3));
            if let Some(range) = fixed {
                return Err(DesignError::Fixed { parameter: range.parameter });
            }
        } else if !whole && vary.is_empty() {
            return Err(DesignError::NothingVaries);
        }
        for (place, range) in vary.iter().enumerate() {
            let parameter = range.parameter;
            if vary[..place].iter().any(|other| other.parameter == parameter) {
                return Err(DesignError::Twice { parameter });
            }
            if parameter.place() < 3 && range.from.value() <= &RBig::ZERO {
                return Err(DesignError::NotPositive { parameter, value: range.from.text().to_owned() });
            }
        }
        let design = Self { family, vary, samples, seed };
        design.check_count()?;
        Ok(design)
    }

    fn check_count(&self) -> Result<(), DesignError> {
        let steps: Vec<Option<u32>> = self.vary.iter().map(|range| range.steps).collect();
        if steps.iter().any(Option::is_some) {
            if let Some(place) = steps.iter().position(Option::is_none) {
                return Err(DesignError::HalfGrid { parameter: self.vary[place].parameter });
            }
            if self.samples.is_some() {
                return Err(DesignError::GridAndSamples);
            }
            let count = steps.iter().flatten().try_fold(1_u64, |count, &n| count.checked_mul(u64::from(n)));
            count.filter(|count| *count < 1 << 53).ok_or(DesignError::TooMany)?;
        } else {
            if self.samples.is_none() {
                return Err(DesignError::NoSamples);
            }
            if self.vary.len() > sequence::DIMENSIONS_MAX {
                return Err(DesignError::TooManyDimensions { count: self.vary.len() });
            }
        }
        Ok(())
    }

    /// Number of bodies.
    #[must_use]
    pub fn count(&self) -> u64 {
        self.samples.unwrap_or_else(|| self.vary.iter().filter_map(|range| range.steps).map(u64::from).product())
    }

    /// A and r of body n: exactly these doubles, read as their shortest decimals, are the body.
    #[must_use]
    pub fn values(&self, n: u64) -> [[f64; 3]; 2] {
        let (mut a, mut r) = match &self.family {
            BodyFamily::General | BodyFamily::Positive => {
                let u = point(n, 4, self.seed);
                let m = on_simplex(u[0], u[1]);
                let a = if self.family == BodyFamily::General { m.map(|m| 1.0 - m) } else { m };
                return [a, on_octant(u[2], u[3])];
            }
            BodyFamily::Listed(list) => return list.values(n),
            BodyFamily::Katok => ([1.0; 3], [1.0, 0.0, 0.0]),
            BodyFamily::Body { moments, center } => {
                (moments.each_ref().map(Number::to_f64), center.each_ref().map(Number::to_f64))
            }
        };
        let mut set = |parameter: BodyParameter, value: f64| match parameter.place() {
            place @ 0..3 => a[place] = value,
            place => r[place - 3] = value,
        };
        if self.samples.is_some() {
            let u = point(n, self.vary.len(), self.seed);
            for (range, u) in self.vary.iter().zip(u) {
                let (from, to) = (range.from.to_f64(), range.to.to_f64());
                set(range.parameter, from + (to - from) * u);
            }
        } else {
            let mut rest = n;
            for range in self.vary.iter().rev() {
                let steps = u64::from(range.steps.unwrap_or(1).max(1));
                set(range.parameter, range.grid_value(rest % steps, steps));
                rest /= steps;
            }
        }
        [a, r]
    }

    /// Body n.
    ///
    /// # Errors
    /// [`BodyError`] when some A_i is not positive or a value out of range.
    pub fn body(&self, n: u64) -> Result<Body, BodyError> {
        let [a, r] = self.values(n);
        Body::from_f64(a, r)
    }
}

/// A uniform point of the triangle m1 + m2 + m3 = 1, m ≥ 0.
fn on_simplex(u: f64, v: f64) -> [f64; 3] {
    let s = u.sqrt();
    [1.0 - s, s * (1.0 - v), s * v]
}

/// A uniform point of the positive octant of the unit sphere: height and longitude are uniform.
fn on_octant(u: f64, v: f64) -> [f64; 3] {
    let longitude = std::f64::consts::FRAC_PI_2 * v;
    let radius = ((1.0 - u) * (1.0 + u)).sqrt();
    [radius * libm::cos(longitude), radius * libm::sin(longitude), u]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parameter::ParseRangeError;

    #[test]
    fn grid_values_are_the_nearest_to_their_exact_fractions() {
        let vary = vec!["A2=0.3:1.7:141".parse().unwrap(), "A3=1/3:2/3:2".parse().unwrap()];
        let design = Design::new(BodyFamily::Katok, vary, None, 0).unwrap();
        assert_eq!(design.count(), 282);
        assert_eq!(design.values(2 * 45)[0], [1.0, 0.75, 1.0 / 3.0]);
        assert_eq!(design.values(2 * 45 + 1)[0], [1.0, 0.75, 2.0 / 3.0]);
        assert_eq!(design.body(2 * 45).unwrap().moments()[1].text(), "0.75");
        assert_eq!(design.values(281)[0], [1.0, 1.7, 2.0 / 3.0]);
    }

    #[test]
    fn bodies_of_the_general_family_exist_and_fill_their_domain() {
        let design = Design::new(BodyFamily::General, Vec::new(), Some(2000), 0).unwrap();
        let mut small = 0;
        for n in 0..design.count() {
            let [a, r] = design.values(n);
            assert!(!design.body(n).unwrap().flags().unphysical, "{a:?}");
            assert!((r.iter().map(|c| c * c).sum::<f64>() - 1.0).abs() < 1e-14 && r.iter().all(|c| *c > 0.0));
            // On the simplex the corner A1 < 1/2 has a quarter of the area.
            small += usize::from(a[0] < 0.5);
        }
        assert!((480..520).contains(&small), "{small}");
    }

    #[test]
    fn designs_that_say_too_little_or_too_much_are_refused() {
        let range = |text: &str| text.parse::<ParameterRange>().unwrap();
        let katok = |vary: &[&str], samples| {
            Design::new(BodyFamily::Katok, vary.iter().map(|text| range(text)).collect(), samples, 0).unwrap_err()
        };
        assert_eq!(katok(&["A1=1:2:3"], None), DesignError::Fixed { parameter: BodyParameter::A1 });
        assert_eq!(katok(&["A2=1:2:3", "A2=1:2:3"], None), DesignError::Twice { parameter: BodyParameter::A2 });
        assert_eq!(katok(&["A2=1:2:3", "A3=1:2"], None), DesignError::HalfGrid { parameter: BodyParameter::A3 });
        assert_eq!(katok(&["A2=1:2:3"], Some(5)), DesignError::GridAndSamples);
        assert_eq!(katok(&["A2=1:2"], None), DesignError::NoSamples);
        assert_eq!(
            katok(&["A2=0:2:9"], None),
            DesignError::NotPositive { parameter: BodyParameter::A2, value: "0".into() }
        );
        let general = Design::new(BodyFamily::General, vec![range("A2=1:2:3")], None, 0);
        assert_eq!(general.unwrap_err(), DesignError::NothingToVary);
        let refused = |text: &str| text.parse::<ParameterRange>().unwrap_err();
        assert!(matches!(refused("A2=2:1"), ParseRangeError::Empty { parameter: BodyParameter::A2, .. }));
        assert!(matches!(refused("A4=1:2"), ParseRangeError::Parameter { .. }));
        assert!(matches!(refused("A2=1"), ParseRangeError::Shape));
        assert!(matches!(refused("A2=1:x"), ParseRangeError::End { parameter: BodyParameter::A2, .. }));
        assert!(matches!(refused("A2=1:2:1"), ParseRangeError::Steps { parameter: BodyParameter::A2, .. }));
    }
}
