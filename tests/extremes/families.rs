//! Families of bodies and points that run into an extreme as ε → 0, and what the levels answer on the way.

use bifdiag_body::{Body, Number, Preset};
use bifdiag_diagram::fast::classify;
use bifdiag_diagram::topology::Component;
use bifdiag_diagram::topology::Components;
use bifdiag_exact::{CertifiedAtlas, classify_exactly};
use dashu_ratio::RBig;

/// What is asked.
pub enum Question {
    /// All regions of a body.
    Regions(Body),
    /// The components of U at a point.
    Point { body: Body, h: Number, l: Number },
}

/// What came back.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Answer {
    Right,
    Wrong,
    Undecided,
    /// The body or the momentum is refused, with the reason.
    Refused,
    /// An answer, but the truth is not proved.
    Unreported,
}

/// A family with a parameter ε = 10⁻ᵏ.
pub struct Extreme {
    pub name: &'static str,
    pub exponents: std::ops::RangeInclusive<isize>,
    question: fn(&RBig) -> Question,
}

impl Extreme {
    pub fn ask(&self, exponent: isize) -> Question {
        (self.question)(&(RBig::ONE / RBig::from(10).pow(exponent)))
    }
}

pub const EXTREMES: [Extreme; 10] = [
    Extreme {
        name: "l→0",
        // A = (2, 1.1, 1), r = (0.2, 0.3, 0.6), l = ε, half-way between the minimum and P+, which are O(l⁴) apart
        exponents: 0..=12,
        question: |e| {
            let (a, r) = (triple(["2", "1.1", "1"]), triple(["0.2", "0.3", "0.6"]));
            let body = Body::new(a.clone(), r.clone()).unwrap();
            let (norm, n2) = (exact("0.7"), exact("0.49"));
            let weighted = |power: isize| {
                (0..3).fold(RBig::ZERO, |sum, k| sum + a[k].value().pow(power) * r[k].value() * r[k].value() / &n2)
            };
            let j = weighted(1);
            let gap = (weighted(2) - &j * &j) / (RBig::from(2) * &norm * j.pow(4)) * e.pow(4);
            point(body, e * e / (RBig::from(2) * j) - norm - gap / RBig::from(2), e.clone())
        },
    },
    Extreme {
        name: "l→∞",
        // A = (2, 1.1, 1), r = (0.2, 0.3, 0.6), l = 1/ε, h = l²/4: half-way between the two lowest curves
        exponents: 0..=14,
        question: |e| {
            let body = Body::new(triple(["2", "1.1", "1"]), triple(["0.2", "0.3", "0.6"])).unwrap();
            let l = RBig::ONE / e;
            point(body, &l * &l / RBig::from(4), l)
        },
    },
    Extreme {
        name: "r→axis",
        // A = (2, 1.1, 1), r = (1, ε, 2ε): all regions
        exponents: 1..=18,
        question: |e| regions([exact("2"), exact("1.1"), exact("1")], [RBig::ONE, e.clone(), RBig::from(2) * e]),
    },
    Extreme {
        name: "A1→A2",
        // A = (1, 1 + ε, 1.3), r = (0.3, 0.5, 0.7): all regions
        exponents: 1..=18,
        question: |e| regions([RBig::ONE, RBig::ONE + e, exact("1.3")], [exact("0.3"), exact("0.5"), exact("0.7")]),
    },
    Extreme {
        name: "rod",
        // A = (ε, 1, 1 + ε/2), r = (1, 0.3, 0.2): all regions
        exponents: 1..=14,
        question: |e| {
            let a = [e.clone(), RBig::ONE, RBig::ONE + e / RBig::from(2)];
            regions(a, [RBig::ONE, exact("0.3"), exact("0.2")])
        },
    },
    Extreme {
        name: "plate",
        // A = (0.5, 0.7, 1.2 − ε), r = (0.3, 0.5, 0.7): all regions
        exponents: 1..=18,
        question: |e| {
            regions([exact("0.5"), exact("0.7"), exact("1.2") - e], [exact("0.3"), exact("0.5"), exact("0.7")])
        },
    },
    Extreme {
        name: "|r| scaling",
        // A = (2, 1.1, 1), r = ε¹⁰(0.3, 0.5, 0.7): all regions
        exponents: 0..=12,
        question: |e| {
            let scale = e.pow(10);
            let r = ["0.3", "0.5", "0.7"].map(|text| exact(text) * &scale);
            regions([exact("2"), exact("1.1"), RBig::ONE], r)
        },
    },
    Extreme {
        name: "near-cusp",
        // Kovalevskaya's cusp: l = l_c(1 + ε) and h on the tangent, between the two curves, which are O(ε^{3/2}) apart
        exponents: 2..=18,
        question: |e| {
            // l_c = (4/3) 3^{1/4}, h_c = √3, dh/dl = 3^{1/4}.
            let root = exact("1.31607401295249246081921890179699905516");
            let change = RBig::from(4) / RBig::from(3) * &root * e;
            let l = RBig::from(4) / RBig::from(3) * &root + &change;
            point(kovalevskaya(), &root * &root + &root * change, l)
        },
    },
    Extreme {
        name: "near-triple-crossing",
        // A = (1, 5/9, 1/2 + ε), r = (1, 0, 0): two pairs and the upper line meet at l² = 2 for ε = 0; all regions
        exponents: 1..=30,
        question: |e| {
            let a = [RBig::ONE, RBig::from(5) / RBig::from(9), exact("0.5") + e];
            regions(a, [RBig::ONE, RBig::ZERO, RBig::ZERO])
        },
    },
    Extreme {
        name: "near-pitchfork",
        // Kovalevskaya's pitchfork: l = (t⁴ + 1)/t³ with t = 1 + ε, half-way between the line l²/4 + 1 and the pair,
        // which are O(ε²) apart
        exponents: 1..=18,
        question: |e| {
            let t = RBig::ONE + e;
            let l = (t.pow(4) + RBig::ONE) / t.pow(3);
            let s = &t * &t;
            let pair = &s / RBig::from(2) + RBig::from(3) / (RBig::from(2) * &s);
            let line = &l * &l / RBig::from(4) + RBig::ONE;
            point(kovalevskaya(), (pair + line) / RBig::from(2), l)
        },
    },
];

fn exact(text: &str) -> RBig {
    text.parse::<Number>().unwrap().value().clone()
}

fn triple(texts: [&str; 3]) -> [Number; 3] {
    texts.map(|text| text.parse().unwrap())
}

fn kovalevskaya() -> Body {
    Preset::find("kovalevskaya").unwrap().body()
}

fn regions(a: [RBig; 3], r: [RBig; 3]) -> Question {
    Question::Regions(Body::new(a.map(Number::from_rational), r.map(Number::from_rational)).unwrap())
}

fn point(body: Body, h: RBig, l: RBig) -> Question {
    Question::Point { body, h: Number::from_rational(h), l: Number::from_rational(l) }
}

/// What `f64` alone and the proof answer; what is right is what is proved.
pub fn answers(question: &Question) -> [Answer; 2] {
    match question {
        Question::Regions(body) => {
            let proved = CertifiedAtlas::new(body).ok().and_then(|atlas| {
                let all = atlas.region_ids().map(|region| atlas.components(region).map(<[Component]>::to_vec));
                all.collect::<Option<Vec<_>>>().map(sorted)
            });
            let exact = if proved.is_some() { Answer::Right } else { Answer::Undecided };
            let fast = bifdiag_diagram::fast::atlas(body).map_or(Answer::Refused, |atlas| {
                let all = atlas.regions().ids().map(|region| atlas.components(region).ok().map(<[Component]>::to_vec));
                let whole = all.collect::<Option<Vec<_>>>().filter(|_| atlas.arrangement().undecided.is_empty());
                match (whole.map(sorted), &proved) {
                    (None, _) => Answer::Undecided,
                    (Some(_), None) => Answer::Unreported,
                    (Some(found), Some(proved)) => {
                        if found == *proved {
                            Answer::Right
                        } else {
                            Answer::Wrong
                        }
                    }
                }
            });
            [fast, exact]
        }
        Question::Point { body, h, l } => {
            let proved: Option<Components> =
                classify_exactly(body, h, l).ok().and_then(|found| found.components().map(<[Component]>::to_vec));
            let exact = if proved.is_some() { Answer::Right } else { Answer::Undecided };
            let fast = classify(body, h, l).map_or(Answer::Refused, |found| match (found.components(), &proved) {
                (None, Some(proved)) if !found.candidates().contains(proved) => Answer::Wrong,
                (None, _) => Answer::Undecided,
                (Some(_), None) => Answer::Unreported,
                (Some(components), Some(proved)) => {
                    if components == proved {
                        Answer::Right
                    } else {
                        Answer::Wrong
                    }
                }
            });
            [fast, exact]
        }
    }
}

fn sorted(mut classes: Vec<Vec<Component>>) -> Vec<Vec<Component>> {
    classes.sort_by_key(|components| format!("{components:?}"));
    classes
}
