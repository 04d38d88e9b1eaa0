//! Named bodies: the paper's, the integrable cases, the seven Katok classes and the special shapes.

use super::rigid_body::Body;

/// A body that can be called by its name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Preset {
    name: &'static str,
    moments: [&'static str; 3],
    center: [&'static str; 3],
    note: &'static str,
}

/// Every preset, in the order in which they are listed.
///
/// The Katok classes have r = (1, 0, 0) and, with A1 = 1 and k_j = 1 − A_j, A2 > A3. The class changes where
/// some A_j passes 1 or 3/4 and where 4(1/√k2 − 1) = 1/k3; each representative lies well inside its class and
/// satisfies the triangle inequality.
const PRESETS: [Preset; 18] = [
    preset("paper", ["2", "1.1", "1"], ["0.94868", "0", "0.61623"], "the paper's body with nine regions"),
    preset("kovalevskaya", ["2", "2", "1"], ["1", "0", "0"], "Kovalevskaya's integrable top"),
    preset("goryachev-chaplygin", ["4", "4", "1"], ["1", "0", "0"], "integrable at l = 0 only"),
    preset(
        "lagrange",
        ["3/2", "1", "1"],
        ["1", "0", "0"],
        "Lagrange's top: r on the axis of symmetry, critical circles",
    ),
    preset("euler", ["2", "1.5", "1"], ["0", "0", "0"], "Euler's case r = 0: the section of the paper does not exist"),
    preset("katok:1", ["1", "1.6", "1.3"], ["1", "0", "0"], "Katok class 1: A2, A3 > A1"),
    preset("katok:2", ["1", "1.4", "0.875"], ["1", "0", "0"], "Katok class 2: A2 > A1 > A3 > 3/4 A1"),
    preset("katok:3", ["1", "1.3", "0.5"], ["1", "0", "0"], "Katok class 3: A2 > A1, A3 < 3/4 A1"),
    preset("katok:4", ["1", "0.925", "0.825"], ["1", "0", "0"], "Katok class 4: A1 > A2 > A3 > 3/4 A1"),
    preset("katok:5", ["1", "0.875", "0.5"], ["1", "0", "0"], "Katok class 5: A1 > A2 > 3/4 A1 > A3"),
    preset(
        "katok:6",
        ["1", "0.7", "0.5"],
        ["1", "0", "0"],
        "Katok class 6: 3/4 A1 > A2, 4(1/sqrt(k2) - 1) > 1/k3, k_j = 1 - A_j/A1",
    ),
    preset(
        "katok:7",
        ["1", "0.55", "0.52"],
        ["1", "0", "0"],
        "Katok class 7: 3/4 A1 > A2, 4(1/sqrt(k2) - 1) < 1/k3, k_j = 1 - A_j/A1",
    ),
    preset("projpm", ["2", "2", "1"], ["1", "0", "0"], "Fig. projpm: genus 3 at h = 3.4, l = 2.87"),
    preset("projections12", ["2", "1.5", "1"], ["1", "0", "0"], "Fig. Projections12: genus 3 at h = 80.5, l = 12.80"),
    preset("isotropic", ["1", "1", "1"], ["1", "0", "0"], "three equal moments: two relative equilibria"),
    preset("plate", ["3", "2", "1"], ["0", "0.8", "0.6"], "a plate held in its plane: A1 = A2 + A3"),
    preset("rod", ["1/1000", "1", "1"], ["1", "0", "0"], "a thin rod held on its axis"),
    preset("ten", ["0.57847392", "0.53739099", "1"], ["0.00595273", "0.00176367", "-0.99998073"], TEN_NOTE),
];

const TEN_NOTE: &str = "ten relative equilibria at l = 1.45";

/// Other spellings of names, and the names.
const OTHER_SPELLINGS: [(&str, &str); 10] = [
    ("kovalevskaja", "kovalevskaya"),
    ("kovalevsky", "kovalevskaya"),
    ("kowalevskaja", "kovalevskaya"),
    ("kowalevskaya", "kovalevskaya"),
    ("kowalevski", "kovalevskaya"),
    ("kowalewski", "kovalevskaya"),
    ("goryachev–chaplygin", "goryachev-chaplygin"),
    ("goryatchev-tchaplygin", "goryachev-chaplygin"),
    ("gorjatschew-tschaplygin", "goryachev-chaplygin"),
    ("chaplygin", "goryachev-chaplygin"),
];

const fn preset(
    name: &'static str,
    moments: [&'static str; 3],
    center: [&'static str; 3],
    note: &'static str,
) -> Preset {
    Preset { name, moments, center, note }
}

impl Preset {
    /// Every preset, in the order in which they are listed.
    #[must_use]
    pub fn all() -> &'static [Self] {
        &PRESETS
    }

    /// The preset of this name, in whatever case, or by another spelling of it.
    #[must_use]
    pub fn find(name: &str) -> Option<&'static Self> {
        let lower = name.to_lowercase();
        let other = OTHER_SPELLINGS.iter().find(|(spelling, _)| *spelling == lower);
        let name = other.map_or(&*lower, |(_, name)| name);
        PRESETS.iter().find(|preset| preset.name == name)
    }

    /// Other spellings of its name.
    pub fn other_spellings(&self) -> impl Iterator<Item = &'static str> + use<> {
        let name = self.name;
        OTHER_SPELLINGS.iter().filter(move |(_, of)| *of == name).map(|(spelling, _)| *spelling)
    }

    /// Its name.
    #[must_use]
    pub fn name(&self) -> &'static str {
        self.name
    }

    /// What it is.
    #[must_use]
    pub fn note(&self) -> &'static str {
        self.note
    }

    /// The body.
    ///
    /// # Panics
    /// Never: the table's numbers are constants, and a test builds every one of them.
    #[must_use]
    pub fn body(&self) -> Body {
        Body::parse(&self.moments, &self.center).expect("the table of presets holds valid bodies")
    }
}

#[cfg(test)]
mod tests {
    use dashu_ratio::RBig;

    use super::*;
    use crate::Number;

    fn body(name: &str) -> Body {
        Preset::find(name).unwrap_or_else(|| panic!("no preset {name}")).body()
    }

    fn ratio(numerator: i32, denominator: u32) -> RBig {
        RBig::from_parts(numerator.into(), denominator.into())
    }

    #[test]
    fn names_are_unique_and_every_body_exists() {
        for (i, preset) in Preset::all().iter().enumerate() {
            assert!(!preset.body().flags().unphysical, "{}", preset.name());
            assert!(Preset::all()[i + 1..].iter().all(|other| other.name() != preset.name()), "{}", preset.name());
            assert!(!preset.note().is_empty());
        }
        assert!(Preset::find("nobody").is_none());
    }

    /// The class by Example 15.2 of docs/algorithms.md, from exact comparisons:
    /// 4(1/√k2 − 1) < 1/k3 ⇔ 16/k2 < (1/k3 + 4)².
    fn katok_class(body: &Body) -> Option<u32> {
        let [a1, a2, a3] = body.moments().each_ref().map(|a| a.value().clone());
        assert_eq!((a1, body.center_f64()), (RBig::ONE, [1.0, 0.0, 0.0]));
        assert!(a2 > a3);
        let three_quarters = ratio(3, 4);
        let band = |a: &RBig| {
            if *a > RBig::ONE {
                Some('a')
            } else if *a == RBig::ONE || *a == three_quarters {
                None
            } else if *a > three_quarters {
                Some('b')
            } else {
                Some('c')
            }
        };
        match (band(&a2)?, band(&a3)?) {
            ('a', 'a') => Some(1),
            ('a', 'b') => Some(2),
            ('a', 'c') => Some(3),
            ('b', 'b') => Some(4),
            ('b', 'c') => Some(5),
            _ => {
                let (k2, k3) = (RBig::ONE - a2, RBig::ONE - a3);
                let left = RBig::from(16) / k2;
                let root = RBig::ONE / k3 + RBig::from(4);
                match left.cmp(&(&root * &root)) {
                    std::cmp::Ordering::Greater => Some(6),
                    std::cmp::Ordering::Less => Some(7),
                    std::cmp::Ordering::Equal => None,
                }
            }
        }
    }

    #[test]
    fn each_katok_preset_lies_in_its_class() {
        for class in 1..=7 {
            assert_eq!(katok_class(&body(&format!("katok:{class}"))), Some(class));
        }
    }

    #[test]
    fn other_spellings_are_found() {
        for (spelling, name) in OTHER_SPELLINGS {
            assert_eq!(body(spelling), body(name));
        }
        assert_eq!(Preset::find("Kowalevski").map(Preset::name), Some("kovalevskaya"));
        assert_eq!(Preset::find("Katok:6").map(Preset::name), Some("katok:6"));
    }

    #[test]
    fn special_presets_are_special() {
        assert!(body("euler").flags().euler);
        assert!(body("lagrange").flags().axis && body("lagrange").flags().symmetric);
        assert!(body("plate").flags().plate && body("plate").flags().plane);
        assert_eq!(body("isotropic").frame().group, [0, 0, 0]);
        assert!(!body("ten").flags().degenerate());
        let goryachev_chaplygin = body("goryachev-chaplygin");
        let [a1, a2, a3] = goryachev_chaplygin.moments().each_ref().map(Number::value);
        assert!(a1 == a2 && *a1 == RBig::from(4) * a3);
    }
}
