//! Properties of bodies of every stratum: as many cases as asked for, the smallest body that breaks one.

use std::fmt::Debug;

use bifdiag_body::{Body, Number};
use proptest::prelude::*;
use proptest::test_runner::{Config, RngSeed, TestCaseError, TestError, TestRunner};

use crate::aim::{Aim, aims};
use crate::strata::Stratum;

/// What a property says of one case.
pub type Verdict = Result<(), TestCaseError>;

/// Tests a property on `cases` bodies of a stratum, or as many as `PROPTEST_CASES` says. The same bodies each time, unless
/// `PROPTEST_RNG_SEED` says otherwise.
///
/// # Panics
/// With the smallest body for which the property fails.
pub fn holds_for_bodies(stratum: Stratum, cases: u32, property: impl Fn(&Body) -> Verdict) {
    run(stratum, cases, &stratum.bodies(), body_text, |body| property(&body));
}

/// [`holds_for_bodies`] with a point to aim at in the (h, l) half-plane of each body.
///
/// # Panics
/// Likewise.
pub fn holds_for_points(stratum: Stratum, cases: u32, property: impl Fn(&Body, &Aim) -> Verdict) {
    let tell = |(body, aim): &(Body, Aim)| format!("{}, {aim:?}", body_text(body));
    run(stratum, cases, &(stratum.bodies(), aims()), tell, |(body, aim)| property(&body, &aim));
}

fn run<S: Strategy>(
    stratum: Stratum,
    cases: u32,
    strategy: &S,
    tell: impl Fn(&S::Value) -> String,
    property: impl Fn(S::Value) -> Verdict,
) where
    S::Value: Debug,
{
    let mut config = Config { failure_persistence: None, max_shrink_iters: 500, ..Config::default() };
    if std::env::var_os("PROPTEST_CASES").is_none() {
        config.cases = cases;
    }
    if std::env::var_os("PROPTEST_RNG_SEED").is_none() {
        config.rng_seed = RngSeed::Fixed(stratum as u64);
    }
    match TestRunner::new(config).run(strategy, property) {
        Ok(()) => {}
        Err(TestError::Fail(why, smallest)) => panic!("{stratum:?}: {why}\n  for {}", tell(&smallest)),
        Err(TestError::Abort(why)) => panic!("{stratum:?}: {why}"),
    }
}

/// A body as the command line takes it.
#[must_use]
pub fn body_text(body: &Body) -> String {
    let triple = |numbers: &[Number; 3]| numbers.each_ref().map(Number::text).join(",");
    format!("--A {} --r={}", triple(body.moments()), triple(body.center()))
}
