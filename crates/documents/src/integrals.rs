//! Integrable cases as documents, and their further integrals along motions.

use bifdiag_body::{Body, Holds, IntegrableCase};
use bifdiag_dynamics::field::{HeavyTop, State, further_integral, keeps_further_integral};
use bifdiag_schema::{FurtherIntegralDocument, IntegrableCaseName, IntegrableDocument};

/// The integrable cases of a body.
#[must_use]
pub fn integrable(body: &Body) -> Vec<IntegrableDocument> {
    IntegrableCase::of(body).into_iter().map(document).collect()
}

fn document(case: IntegrableCase) -> IntegrableDocument {
    IntegrableDocument {
        case: match case {
            IntegrableCase::Euler => IntegrableCaseName::Euler,
            IntegrableCase::Lagrange(_) => IntegrableCaseName::Lagrange,
            IntegrableCase::Kovalevskaya(_) => IntegrableCaseName::Kovalevskaya,
            IntegrableCase::GoryachevChaplygin(_) => IntegrableCaseName::GoryachevChaplygin,
            IntegrableCase::HessAppelrot => IntegrableCaseName::HessAppelrot,
        },
        integral: case.integral(),
        holds: match case.holds() {
            Holds::Always => "always",
            Holds::ZeroMomentum => "where l = 0",
            Holds::WhereZero => "where it is 0",
        }
        .to_owned(),
    }
}

/// The name of a case, and its further integral, in a line of text.
#[must_use]
pub fn integrable_words(document: &IntegrableDocument) -> String {
    let IntegrableDocument { case, integral, holds } = document;
    let (name, what) = match case {
        IntegrableCaseName::Euler => ("Euler", "further integral"),
        IntegrableCaseName::Lagrange => ("Lagrange", "further integral"),
        IntegrableCaseName::Kovalevskaya => ("Kovalevskaya", "further integral"),
        IntegrableCaseName::GoryachevChaplygin => ("Goryachev–Chaplygin", "further integral"),
        IntegrableCaseName::HessAppelrot => ("Hess–Appelrot", "invariant relation"),
    };
    let holds = if holds == "always" { String::new() } else { format!(", constant {holds}") };
    format!("{name}'s case: {what} {integral}{holds}")
}

/// The further integrals of a body along motions, each its number, a start and the states that follow it.
pub fn further_integrals<'a, S>(
    body: &Body,
    motions: &(impl Iterator<Item = (u32, State, S)> + Clone + 'a),
) -> Vec<FurtherIntegralDocument>
where
    S: Iterator<Item = State>,
{
    let top = HeavyTop::new(body);
    let along = |case: IntegrableCase| {
        let mut found =
            FurtherIntegralDocument { of: document(case), kept: true, at_start: 0.0, orbit: None, drift: 0.0 };
        let are_several = motions.clone().nth(1).is_some();
        for (number, start, states) in motions.clone() {
            let at_start = further_integral(case, &top, &start);
            found.kept &= keeps_further_integral(case, &top, &start);
            if found.orbit.is_none() || at_start.abs() > found.at_start.abs() {
                (found.at_start, found.orbit) = (at_start, Some(number));
            }
            let off = states.map(|state| (further_integral(case, &top, &state) - at_start).abs());
            found.drift = off.fold(found.drift, f64::max);
        }
        found.orbit = found.orbit.filter(|_| are_several);
        found
    };
    IntegrableCase::of(body).into_iter().map(along).collect()
}
