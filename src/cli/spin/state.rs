//! `bifdiag state`: where a state lies, and what it is.

use documents::Subject;
use numbers::vector::{cross, dot, norm};
use proof::{Accuracy, Prepared};
use schema::StateDocument;
use top::atlas::Spot;
use top::body::Number;

use super::arguments::StateArguments;
use super::direction::{second, to_principal};
use super::error::{StateFailure, StateInput};
use super::rotation::Axis;
use super::steady::{at_spin, changes, told};
use crate::cli::export::answer;
use crate::cli::failure::Failure;
use crate::cli::input::head;
use crate::cli::terminal::{Report, Timings, significant};

/// h and l of a state are computed with a smaller error, relative to the size of their terms.
const ROUNDING: f64 = 1e-14;

/// A state in the frame of the question, in seconds.
struct State {
    omega: [f64; 3],
    vertical: [f64; 3],
}

pub fn run(arguments: &StateArguments, timings: &Timings) -> Result<(), Failure> {
    let state = State::of(arguments)?;
    let subject = arguments.body.subject()?;
    let document = timings.stage("state", || state.document(&subject)).map_err(StateFailure)?;
    Ok(answer(arguments.json, &document, || text(&subject, &document))?)
}

impl State {
    fn of(arguments: &StateArguments) -> Result<Self, StateInput> {
        match (&arguments.spin, arguments.axis, arguments.omega) {
            (Some(_), _, Some(_)) => Err(StateInput::Two { first: "--spin", second: "--omega" }),
            (_, Some(_), Some(_)) => Err(StateInput::Two { first: "--axis", second: "--omega" }),
            (Some(_), None, None) => Err(missing("--spin", "--axis", "--axis z")),
            (None, Some(_), None) => Err(missing("--axis", "--spin", "--spin \"3000 rpm\"")),
            (None, None, None) => Err(StateInput::Nothing),
            (None, None, Some(omega)) => {
                let vertical = arguments.vertical.ok_or(missing("--omega", "--vertical", "--vertical 0,0,1"))?;
                Ok(Self { omega: omega.0, vertical: vertical.0 })
            }
            (Some(spin), Some(axis), None) => {
                let vertical = arguments.vertical.unwrap_or(axis);
                Ok(Self { omega: axis.0.map(|x| x * spin.rad_per_s()), vertical: vertical.0 })
            }
        }
    }

    fn document(&self, subject: &Subject) -> Result<StateDocument, top::body::ParseNumberError> {
        let part = subject.part.as_ref();
        let second = second(part);
        let omega = to_principal(part, self.omega).map(|x| x / second);
        let up = to_principal(part, self.vertical);
        let (a, r) = (subject.body.moments_f64(), subject.body.center_f64());
        let momentum: [f64; 3] = std::array::from_fn(|k| a[k] * omega[k]);
        // γ = −up: U = −⟨γ, r⟩ = ⟨up, r⟩; l = ⟨Aω, γ⟩, of which the sign does not matter.
        let (h, l) = (0.5 * dot(omega, momentum) + dot(up, r), dot(momentum, up));
        let spin = norm(self.omega);
        let mut document = StateDocument {
            head: documents::head(
                subject
                    .command("state")
                    .option("omega", self.omega.map(|x| format!("{x:?}")).join(","))
                    .option("vertical", self.vertical.map(|x| format!("{x:?}")).join(","))
                    .json(),
            ),
            body: documents::given(&subject.body),
            omega: self.omega,
            vertical: self.vertical,
            spin: documents::spin(spin),
            h,
            l,
            steady: None,
            region: None,
            margin: None,
            nearest: None,
            note: None,
            part: subject.part.clone(),
        };
        let prepared = Prepared::new(subject.body.clone(), Accuracy::Exact);
        let steady = at_spin(subject, self.vertical, spin, &prepared);
        if prepared.atlas().is_none() {
            document.note = Some("the regions of this body were not found".to_owned());
        }
        match steady {
            Some(steady) if steady.angle_deg == 0.0 && self.is_upright() => document.steady = Some(steady),
            None if self.is_upright() => {
                document.note = Some("whether the motion is steady was not decided: the numbers leave f64".to_owned());
            }
            other => {
                document.nearest = other;
                let [h, l] = [Number::from_f64(h)?, Number::from_f64(l)?];
                if let Ok(found) = prepared.classify(&h, &l) {
                    document.margin = Some(documents::margin(&found.margin));
                    // A curve rises by l/J, which is at most l/min A, and h and l are rounded.
                    let least = a.into_iter().fold(f64::INFINITY, f64::min);
                    let size = 0.5 * dot(omega, momentum).abs() + norm(r) + document.l * document.l / least;
                    if found.margin.h > ROUNDING * size {
                        match prepared.spot(&h, &l, &found.answer) {
                            Spot::Region(region) => document.region = Some(region.to_string()),
                            _ => document.note = Some("the region of its (h, l) is not known".to_owned()),
                        }
                    }
                } else {
                    document.note = Some("the region of its (h, l) is not known".to_owned());
                }
            }
        }
        Ok(document)
    }

    /// The angular velocity is along the vertical.
    fn is_upright(&self) -> bool {
        norm(cross(self.omega, self.vertical)) <= 1e-9 * norm(self.omega) * norm(self.vertical)
    }
}

fn missing(given: &'static str, missing: &'static str, example: &'static str) -> StateInput {
    StateInput::Incomplete { given, missing, example }
}

fn text(subject: &Subject, document: &StateDocument) -> String {
    let mut report = Report::default();
    head(subject, &mut report);
    let spin = &document.spin;
    report.line(format!("spin {} rpm = {} rad/s", significant(spin.rpm, 8), significant(spin.rad_per_s, 8)));
    report.line(format!("h = {}, l = {}", significant(document.h, 10), significant(document.l, 10)));
    report.line("");
    match &document.steady {
        Some(steady) => {
            told(&mut report, steady);
            match Axis::of(subject, document.vertical) {
                Axis::Permanent { .. } => changes(&mut report, steady, document.note.is_none()),
                Axis::AtOneSpin { .. } => report.line("the axis is permanent at this spin only"),
                Axis::Principal => report.line(
                    "the axis is principal, but the centre of mass does not lie on it: at this spin a steady rotation is \
                     within 10⁻⁶ of it",
                ),
                Axis::Other { .. } | Axis::Unknown => {}
            }
        }
        None => other_text(&mut report, document),
    }
    report.text()
}

fn other_text(report: &mut Report, document: &StateDocument) {
    let place = match (&document.region, &document.margin, &document.note) {
        (Some(region), ..) => format!("its (h, l) lies in the region {region}"),
        (None, _, Some(note)) => note.clone(),
        (None, Some(margin), None) => {
            format!("its (h, l) lies on the curve {}, or within rounding of it", margin.nearest)
        }
        (None, None, None) => String::new(),
    };
    // Without an answer about steadiness only the note is left.
    report.line(if document.nearest.is_none() && document.margin.is_none() {
        place
    } else {
        format!("the motion is not steady; {place}")
    });
    if let (Some(_), Some(margin)) = (&document.region, &document.margin) {
        report.line(format!("the nearest curve is {} in h away ({})", significant(margin.h, 6), margin.nearest));
    }
    let Some(nearest) = &document.nearest else { return };
    let [x, y, z] = nearest.axis.map(|x| significant(x, 6));
    let angle = significant(nearest.angle_deg, 3);
    report.line("");
    report.line(format!(
        "at this spin the axis of the nearest steady rotation is ({x}, {y}, {z}), {angle}° from the vertical"
    ));
    told(report, nearest);
}
