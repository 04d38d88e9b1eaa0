//! The state at which the options let the motion start.

use std::f64::consts::PI;

use bifdiag_dynamics::field::{HeavyTop, State};
use bifdiag_dynamics::section::{PpTorus, SectionError, TorusPoint};

use super::arguments::OrbitArguments;
use super::error::OrbitInput;

/// γ with l or ω, or a point of the section.
pub fn of(arguments: &OrbitArguments, top: &HeavyTop) -> Result<State, OrbitInput> {
    let state = [
        ("--gamma", arguments.gamma.is_some()),
        ("--l-vector", arguments.l_vector.is_some()),
        ("--omega", arguments.omega.is_some()),
    ];
    let point = [
        ("--h", arguments.energy.is_some()),
        ("--l", arguments.momentum.is_some()),
        ("--theta", arguments.theta.is_some()),
        ("--psi", arguments.psi.is_some()),
        ("--sheet", arguments.sheet.is_some()),
    ];
    let first = |options: &[(&'static str, bool)]| options.iter().find(|(_, given)| *given).map(|(name, _)| *name);
    match (first(&state), first(&point)) {
        (None, None) => Err(OrbitInput::NoStart),
        (Some(first), Some(second)) => Err(OrbitInput::TwoStarts { first, second }),
        (Some(given), None) => of_state(arguments, top, given),
        (None, Some(given)) => of_point(arguments, top, given),
    }
}

fn of_state(arguments: &OrbitArguments, top: &HeavyTop, given: &'static str) -> Result<State, OrbitInput> {
    let missing = |missing, example| OrbitInput::Incomplete { given, missing, example };
    let gamma = arguments.gamma.ok_or(missing("--gamma", "--gamma 0.6,0,0.8"))?.0;
    let l = match (arguments.l_vector, arguments.omega) {
        (Some(_), Some(_)) => return Err(OrbitInput::TwoStarts { first: "--l-vector", second: "--omega" }),
        (Some(l), None) => l.0,
        (None, Some(omega)) => top.inertia(omega.0),
        (None, None) => return Err(missing("--omega or --l-vector", "--omega 1,0.3,1")),
    };
    Ok(State { gamma, l })
}

fn of_point(arguments: &OrbitArguments, top: &HeavyTop, given: &'static str) -> Result<State, OrbitInput> {
    let missing = |missing, example| OrbitInput::Incomplete { given, missing, example };
    let h = arguments.energy.as_ref().ok_or(missing("--h", "--h 4.45"))?.to_f64();
    let l = arguments.momentum.as_ref().ok_or(missing("--l", "--l 3.25"))?.to_f64();
    let theta = arguments.theta.ok_or(missing("--theta", "--theta 1.2"))?;
    let psi = arguments.psi.ok_or(missing("--psi", "--psi pi/2"))?;
    if !(0.0..=PI).contains(&theta) {
        return Err(OrbitInput::Theta { theta });
    }
    let torus = PpTorus::new(top).map_err(|_no_axis| OrbitInput::WeightlessTorus)?;
    let point = TorusPoint { theta, psi, sheet: arguments.sheet.unwrap_or(1) };
    torus.state(point, h, l).map_err(|error| match error {
        SectionError::SeedInaccessible { potential, .. } => OrbitInput::Inaccessible { theta, psi, potential, h },
        // The angles are finite and r is not 0.
        _ => OrbitInput::Theta { theta },
    })
}
