//! `critical`: all relative equilibria at one l.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::term::term;
use super::{FrictionDocument, GivenBody, Head, NonlinearDocument, NonlinearVerdict, Number, PartDocument, Reason};

term! {
    /// Linear type of a relative equilibrium, decided exactly: the eigenvalues ±λ₁, ±λ₂ of the Euler–Poisson flow reduced by l.
    pub enum Stability {
        /// Two imaginary pairs; across a circle of equilibria one pair.
        Elliptic = "elliptic",
        /// One real and one imaginary pair.
        SaddleCentre = "saddle-centre",
        /// Two real pairs; across a circle of equilibria one pair.
        Saddle = "saddle",
        /// A complex quadruple.
        Complex = "complex",
        /// A double imaginary pair.
        DoubleElliptic = "double-elliptic",
        /// A double real pair.
        DoubleReal = "double-real",
        /// An eigenvalue zero.
        Zero = "zero",
    }
}

impl Stability {
    /// Some eigenvalue has a positive real part.
    #[must_use]
    pub fn is_unstable(self) -> bool {
        matches!(self, Self::SaddleCentre | Self::Saddle | Self::Complex | Self::DoubleReal)
    }
}

/// What is known of the stability of a relative equilibrium; of a circle or sphere of them as a whole.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Verdict {
    /// Stable: a minimum of U_l.
    Energy,
    /// Stable by a further integral, as the sleeping top.
    Integral,
    /// Stable by Arnold's theorem.
    Arnold,
    /// All eigenvalues are imaginary; nothing more is known.
    Spectrum,
    /// Unstable.
    Unstable,
    /// An eigenvalue is zero, and nothing more is known.
    Open,
}

impl Verdict {
    /// Every value, in the order of their codes.
    pub const ALL: &[Self] = &[Self::Energy, Self::Integral, Self::Arnold, Self::Spectrum, Self::Unstable, Self::Open];

    /// The reason for stability, in the words of tables.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::Energy => "by energy",
            Self::Integral => "by an integral",
            Self::Arnold => "by Arnold's theorem",
            Self::Spectrum => "spectrally only",
            Self::Unstable => "no",
            Self::Open => "open",
        }
    }

    /// What is known without a verdict where the verdict is open.
    #[must_use]
    pub fn of(nonlinear: &NonlinearDocument, kind: Stability) -> Self {
        match (nonlinear.verdict, nonlinear.why) {
            (NonlinearVerdict::Unstable, _) => Self::Unstable,
            (NonlinearVerdict::Stable, Reason::Energy) => Self::Energy,
            (NonlinearVerdict::Stable, Reason::Integral) => Self::Integral,
            (NonlinearVerdict::Stable, _) => Self::Arnold,
            (NonlinearVerdict::Open, _) if kind == Stability::Zero => Self::Open,
            (NonlinearVerdict::Open, _) => Self::Spectrum,
        }
    }
}

impl Serialize for Verdict {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Energy => serializer.serialize_str("energy"),
            Self::Integral => serializer.serialize_str("integral"),
            Self::Arnold => serializer.serialize_str("arnold"),
            Self::Spectrum => serializer.serialize_str("spectrum"),
            Self::Unstable => serializer.serialize_bool(false),
            Self::Open => serializer.serialize_unit(),
        }
    }
}

impl<'de> Deserialize<'de> for Verdict {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        #[derive(Deserialize)]
        #[serde(untagged)]
        enum Raw {
            Word(String),
            Stable(bool),
            Open(()),
        }
        let wrong = |what: String| {
            serde::de::Error::custom(format!(
                "stable is {what}, not one of \"energy\", \"integral\", \"arnold\", \"spectrum\", false, null"
            ))
        };
        match Raw::deserialize(deserializer)? {
            Raw::Word(word) => match word.as_str() {
                "energy" => Ok(Self::Energy),
                "integral" => Ok(Self::Integral),
                "arnold" => Ok(Self::Arnold),
                "spectrum" => Ok(Self::Spectrum),
                _ => Err(wrong(format!("`{word}`"))),
            },
            Raw::Stable(false) => Ok(Self::Unstable),
            Raw::Stable(true) => Err(wrong("true".to_owned())),
            Raw::Open(()) => Ok(Self::Open),
        }
    }
}

impl JsonSchema for Verdict {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "Verdict".into()
    }

    fn json_schema(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
        let words = [
            (
                serde_json::json!("energy"),
                "Stable: a strict minimum of U_l; of a circle or sphere of minima, as a whole.",
            ),
            (serde_json::json!("integral"), "Stable by a further integral (Lagrange's top, Euler's)."),
            (serde_json::json!("arnold"), "Stable by Arnold's theorem, or at a resonance by what replaces it there."),
            (
                serde_json::json!("spectrum"),
                "All eigenvalues are imaginary; whether it is stable is open, or differs from spin to spin.",
            ),
            (serde_json::json!(false), "Unstable."),
            (serde_json::json!(null), "An eigenvalue is zero; whether it is stable is open."),
        ];
        let one = |(word, about): &(serde_json::Value, &str)| serde_json::json!({"const": word, "description": about});
        schemars::json_schema!({
            "description": "What is known of the stability; of a circle or sphere as a whole (Proposition 13.6 of docs/mathematics.md).",
            "oneOf": words.iter().map(one).collect::<Vec<_>>()
        })
    }
}

/// What an entry represents: one critical point, or a circle or sphere of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Multiplicity {
    /// 1: a nondegenerate critical point. 2: a degenerate one, in which curves end: at a cusp two critical points meet in it, at
    /// a pitchfork three, or a point and a circle.
    Points(u32),
    /// A circle of critical points (Lagrange's top); `gamma` is one of them.
    Circle,
    /// All of S² is critical (r = 0 and three equal moments).
    Sphere,
}

impl Serialize for Multiplicity {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Points(count) => serializer.serialize_u32(*count),
            Self::Circle => serializer.serialize_str("circle"),
            Self::Sphere => serializer.serialize_str("sphere"),
        }
    }
}

impl<'de> Deserialize<'de> for Multiplicity {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        #[derive(Deserialize)]
        #[serde(untagged)]
        enum Raw {
            Count(u32),
            Name(String),
        }
        match Raw::deserialize(deserializer)? {
            Raw::Count(count) => Ok(Self::Points(count)),
            Raw::Name(name) if name == "circle" => Ok(Self::Circle),
            Raw::Name(name) if name == "sphere" => Ok(Self::Sphere),
            Raw::Name(name) => {
                Err(serde::de::Error::custom(format!("multiplicity `{name}` is neither a count, circle nor sphere")))
            }
        }
    }
}

impl JsonSchema for Multiplicity {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "Multiplicity".into()
    }

    fn json_schema(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
        schemars::json_schema!({
            "description": "What an entry stands for: 1, a critical point; 2, a degenerate one, exactly at a cusp, where two critical points meet in it, or at a pitchfork, where three do, or a point and a circle; or a circle or sphere, of which `gamma` is one point.",
            "oneOf": [{"type": "integer", "minimum": 1}, {"enum": ["circle", "sphere"]}]
        })
    }
}

/// A relative equilibrium: the body turns about the vertical γ with constant angular velocity ω γ.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct RelativeEquilibriumDocument {
    /// Energy h = U_l(γ).
    pub h: f64,
    /// The vertical in body coordinates.
    pub gamma: [f64; 3],
    /// Angular velocity l / J(γ), with the sign of l.
    pub omega: f64,
    /// Negative eigenvalues of the Hessian of U_l, the Morse index: 0 minimum, 1 saddle, 2 maximum (unless it is degenerate,
    /// which `multiplicity` 2 says); for a circle, of its one normal direction (0 also where that is degenerate, at a cusp).
    pub index: u8,
    /// 1: a critical point; 2: a degenerate one, exactly at a cusp, where two meet in it, at a pitchfork, where three do, or
    /// one and a circle, or where a cusp lies at a pitchfork, where more do; `circle` or `sphere`: all points of one, of which `gamma` is one.
    pub multiplicity: Multiplicity,
    /// Linear type of the flow reduced by l.
    pub stability: Stability,
    /// The reason for its stability, if known: `nonlinear` in one word.
    pub stable: Verdict,
    /// The verdict on its stability, with its reason.
    pub nonlinear: NonlinearDocument,
    /// What friction leaves of it.
    pub friction: FrictionDocument,
    /// The two of ±λ₁, ±λ₂ with re ≥ 0 and im ≥ 0, as [re, im], real ones first, then by size. A complex quadruple gives the same
    /// pair twice; a circle its transverse pair, then [0, 0].
    pub eigenvalues: [[f64; 2]; 2],
    /// Bound on the error of each of the four numbers.
    pub eigenvalue_error: f64,
    /// Id of the curve on which it lies.
    pub branch: String,
    /// Its branch in words.
    pub branch_name: String,
}

/// The answer of `critical`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct CriticalDocument {
    /// Where it comes from.
    #[serde(flatten)]
    pub head: Head,
    /// The body.
    #[serde(flatten)]
    pub body: GivenBody,
    /// Vertical angular momentum as given.
    #[schemars(with = "Number")]
    pub l: String,
    /// All relative equilibria, by rising h, then γ lexicographically; a symmetric pair is two entries.
    pub critical: Vec<RelativeEquilibriumDocument>,
    /// Bound on the error of every `h`.
    pub error_bound: f64,
    /// True: beside a cusp or pitchfork, points are counted in exact arithmetic. False only where two cusps are closer than
    /// 2⁻⁴⁰⁰⁰.
    pub complete: bool,
    /// What could not be decided, in words.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub note: Option<String>,
    /// The part from which A and r were computed, when one was given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub part: Option<PartDocument>,
}

/// Eigenvalues in words: periods of small oscillations, and the times in which small deviations grow by the factor e. `at`
/// holds the pairs of one equilibrium, or of one and a later one of the same type on its curve; `number` writes a time.
#[must_use]
pub fn small_motions(at: &[[[f64; 2]; 2]], number: impl Fn(f64) -> String) -> String {
    let Some(&[first, second]) = at.first() else { return String::new() };
    let times = |of: &dyn Fn(&[[f64; 2]; 2]) -> f64| {
        let mut texts: Vec<String> = at.iter().map(|pairs| number(of(pairs))).collect();
        texts.dedup();
        texts.join(" … ")
    };
    let part = |k: usize, [re, im]: [f64; 2]| {
        let growth = || format!("growth {}", times(&|pairs| 1.0 / pairs[k][0]));
        let period = || format!("period {}", times(&|pairs| std::f64::consts::TAU / pairs[k][1]));
        match (re > 0.0, im > 0.0) {
            (true, true) => format!("{} with {}", growth(), period()),
            (true, false) => growth(),
            (false, true) => period(),
            (false, false) => "zero".to_owned(),
        }
    };
    if first == second {
        format!("{}, twice", part(0, first))
    } else {
        format!("{}, {}", part(0, first), part(1, second))
    }
}

/// The eigenvalues ±λ₁, ±λ₂ of one equilibrium: `±0.5, ±1.2i`, of a quadruple `±0.5 ± 1.2i`.
#[must_use]
pub fn eigenvalues_in_words([first, second]: &[[f64; 2]; 2], number: impl Fn(f64) -> String) -> String {
    let pair = |[re, im]: [f64; 2]| match (re > 0.0, im > 0.0) {
        (true, true) => format!("±{} ± {}i", number(re), number(im)),
        (true, false) => format!("±{}", number(re)),
        (false, true) => format!("±{}i", number(im)),
        (false, false) => "0".to_owned(),
    };
    match (first == second, first[0] > 0.0 && first[1] > 0.0) {
        (true, true) => pair(*first),
        (true, false) => format!("{}, twice", pair(*first)),
        (false, _) => format!("{}, {}", pair(*first), pair(*second)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_quadruple_is_one_pair_with_two_signs() {
        let words = |pairs| eigenvalues_in_words(&pairs, |x| format!("{x}"));
        assert_eq!(words([[0.5, 0.0], [0.0, 1.5]]), "±0.5, ±1.5i");
        assert_eq!(words([[0.5, 1.5], [0.5, 1.5]]), "±0.5 ± 1.5i");
        assert_eq!(words([[0.0, 1.5], [0.0, 1.5]]), "±1.5i, twice");
        assert_eq!(words([[0.5, 0.0], [0.0, 0.0]]), "±0.5, 0");
    }

    #[test]
    fn times_that_stay_the_same_are_told_once() {
        let number = |time: f64| format!("{time:.3}");
        let at = |growth: f64| [[1.0 / growth, 0.0], [0.0, std::f64::consts::TAU / 5.0]];
        assert_eq!(small_motions(&[at(2.0), at(3.0)], number), "growth 2.000 … 3.000, period 5.000");
        assert_eq!(small_motions(&[at(2.0)], number), "growth 2.000, period 5.000");
    }
}
