//! Enclosures of a motion as a document.

use bifdiag_enclosure::orbit::{Ends, MOST_BITS, MOST_DIGITS, ProofEnd, ProvedMotion};
use bifdiag_enclosure::start::ExactStart;
use bifdiag_numbers::Number;
use bifdiag_numbers::decimal::{outward, significant};
use bifdiag_schema::{EnclosuresDocument, ExactStartDocument, ProvedMotionDocument};
use dashu_ratio::RBig;

use crate::body::{given, head, texts};
use crate::subject::Subject;

/// The bound of an enclosure that is wanted, where none is named.
pub const USUAL_BOUND: f64 = 1e-10;

/// What a proof starts from and how it is wanted: texts, from which the same command starts again.
#[derive(Clone, Debug, PartialEq)]
pub struct ProofAsked {
    /// γ, of any length.
    pub gamma: [Number; 3],
    /// ω, in the body's axes.
    pub omega: [Number; 3],
    /// φ.
    pub phi: Number,
    /// The times, as the option has them.
    pub times: String,
    /// Digits of the arithmetic, if they are fixed.
    pub digits: Option<u32>,
    /// The widest enclosure wanted.
    pub bound: f64,
}

impl ProofAsked {
    /// The start as the proof reads it.
    #[must_use]
    pub fn start(&self) -> ExactStart {
        let values = |numbers: &[Number; 3]| numbers.each_ref().map(|x| x.value().clone());
        ExactStart { gamma: values(&self.gamma), omega: values(&self.omega), phi: self.phi.value().clone() }
    }
}

/// The document without its enclosures, which [`enclosures`] gives.
#[must_use]
pub fn proved_motion(
    subject: &Subject,
    asked: &ProofAsked,
    times: &[f64],
    motion: &ProvedMotion,
) -> ProvedMotionDocument {
    let line = subject.command("orbit").option("gamma", texts(&asked.gamma).join(","));
    let line = line.option("omega", texts(&asked.omega).join(","));
    let line = line.option_if("phi", (asked.phi.to_f64() != 0.0).then(|| asked.phi.text()));
    let line = line.option("times", &asked.times).flag("proved", true).option_if("digits", asked.digits);
    let line = line.option_if("bound", (asked.bound.to_bits() != USUAL_BOUND.to_bits()).then_some(asked.bound));
    ProvedMotionDocument {
        head: head(line.json()),
        body: given(&subject.body),
        start: ExactStartDocument {
            gamma: texts(&asked.gamma),
            omega: texts(&asked.omega),
            phi: asked.phi.text().to_owned(),
        },
        times: times.iter().copied().take(motion.samples.len()).collect(),
        enclosures: None,
        proved_to: motion.proved[1],
        proved_from: motion.proved[0],
        bound: asked.bound,
        widest: motion.widest(),
        bits: motion.bits,
        steps: motion.steps,
        complete: motion.samples.len() == times.len(),
        notes: motion.end.map(|end| ending(asked, motion, end)).into_iter().chain(rounded(subject)).collect(),
        part: subject.part.clone(),
    }
}

/// What is enclosed where the body itself was rounded.
fn rounded(subject: &Subject) -> Option<String> {
    let is_rounded = subject.part.as_ref().is_some_and(|part| !part.exact);
    is_rounded
        .then(|| "A and r of this part are rounded to at least 130 digits; the motion is that of these".to_owned())
}

/// Where the proof ended and what goes further.
fn ending(asked: &ProofAsked, motion: &ProvedMotion, end: ProofEnd) -> String {
    let [from, to] = motion.proved;
    let proved = if from < 0.0 {
        format!("proved from t = {} to t = {}", significant(from, 6), significant(to, 6))
    } else {
        format!("proved to t = {}", significant(to, 6))
    };
    if end == ProofEnd::Interrupted {
        return match motion.samples.len() {
            // Steps with fewer bits, which were not enough, count for nothing.
            0 => format!("interrupted with {} bits, before the first time", motion.bits),
            _ => format!("{proved}; then it was interrupted"),
        };
    }
    let bits = motion.bits;
    match asked.digits {
        Some(digits) if bits < MOST_BITS => {
            let more = (digits + digits / 2).max(digits + 10).max(digits_beyond(bits, asked.bound)).min(MOST_DIGITS);
            format!("{proved}; from there enclosures outrun {bits} bits: --digits {more}")
        }
        _ => format!("{proved}; from there enclosures outrun {bits} bits, the most that there are: --bound 1e-2"),
    }
}

/// A number of digits that these bits do not reach, and ten more than the bound needs.
fn digits_beyond(bits: usize, bound: f64) -> u32 {
    // log₁₀ 2 < 0.302.
    let bits = u32::try_from(bits).unwrap_or(u32::MAX / 1000);
    let places = (0..300_u32).take_while(|n| libm::pow(10.0, -f64::from(*n)) > bound).count();
    (bits * 302 / 1000 + 2).max(u32::try_from(places).unwrap_or(0) + 10)
}

/// The enclosures as decimals, as short as their widths allow.
#[must_use]
pub fn enclosures(motion: &ProvedMotion) -> EnclosuresDocument {
    let mut document = EnclosuresDocument::default();
    for sample in &motion.samples {
        document.gamma.push(sample.gamma.each_ref().map(ends));
        document.omega.push(sample.omega.each_ref().map(ends));
        document.rotation.push(sample.rotation.each_ref().map(ends));
        document.quaternion.push(sample.quaternion.each_ref().map(ends));
    }
    document
}

fn ends(ends: &Ends) -> [String; 2] {
    let [lo, hi] = ends;
    let width = (hi - lo).to_f64().value().max(1e-300);
    let size = lo.to_f64().value().abs().max(hi.to_f64().value().abs());
    // Two digits of the width remain.
    let digits = (3_u16..1000).take_while(|digits| f64::from(*digits) < libm::log10(size / width) + 3.0).count() + 3;
    outward(ends, digits)
}

/// The enclosures as doubles that are rounded outward, a row for each time: the lower ends (0) or the upper ones (1) of γ, of
/// ω, of the rows of the rotation and of the quaternion.
#[derive(Clone, Debug, PartialEq)]
pub struct EnclosureRow {
    /// γ.
    pub gamma: [f64; 3],
    /// ω.
    pub omega: [f64; 3],
    /// The rotation, by rows.
    pub rotation: [[f64; 3]; 3],
    /// The quaternion w, x, y, z.
    pub quaternion: [f64; 4],
}

/// See [`EnclosureRow`].
#[must_use]
pub fn enclosure_rows(motion: &ProvedMotion, side: usize) -> Vec<EnclosureRow> {
    let end = |ends: &Ends| double(ends, side);
    let row = |sample: &bifdiag_enclosure::orbit::ProvedSample| {
        let rotation = sample.rotation.each_ref().map(end);
        EnclosureRow {
            gamma: sample.gamma.each_ref().map(end),
            omega: sample.omega.each_ref().map(end),
            rotation: std::array::from_fn(|i| std::array::from_fn(|k| rotation[3 * i + k])),
            quaternion: sample.quaternion.each_ref().map(end),
        }
    };
    motion.samples.iter().map(row).collect()
}

/// A double not above (0) or not below (1) an end.
fn double(ends: &Ends, side: usize) -> f64 {
    let nearest = ends[side].to_f64().value();
    let exact = RBig::try_from(nearest).unwrap_or(RBig::ZERO);
    match side {
        0 if exact > ends[0] => nearest.next_down(),
        1 if exact < ends[1] => nearest.next_up(),
        _ => nearest,
    }
}
