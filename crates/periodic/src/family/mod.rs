//! Families of periodic orbits, from the equilibria past their special orbits to their ends.

mod begin;
mod event;
mod follow;
mod guess;
mod member;
mod model;

use bifdiag_body::Body;
use bifdiag_dynamics::field::{Dimension, HeavyTop};
use bifdiag_equilibria::critical::{Equilibrium, RelativeEquilibria};

use follow::Course;
pub use model::{End, Family, FamilyError, FamilyOptions, Held, OrbitEvent, Stretch};

/// The families of the imaginary pairs of an equilibrium, the faster first (Lyapunov's centre theorem). Where the
/// theorem does not apply to a pair, since the other is a multiple of it or zero, the family has no members and its end
/// says so.
///
/// # Errors
/// [`FamilyError`].
pub fn families(
    body: &Body,
    equilibrium: &Equilibrium,
    options: &FamilyOptions<'_>,
) -> Result<Vec<Family>, FamilyError> {
    let known = RelativeEquilibria::new(body)?.without_normal_forms();
    families_of(&HeavyTop::new(body), &known, equilibrium, options)
}

/// The same for a body whose equilibria are known.
pub(crate) fn families_of(
    top: &HeavyTop,
    known: &RelativeEquilibria<'_>,
    equilibrium: &Equilibrium,
    options: &FamilyOptions<'_>,
) -> Result<Vec<Family>, FamilyError> {
    let mut frequencies: Vec<f64> = equilibrium
        .eigenvalues
        .pairs
        .into_iter()
        .filter(|[re, im]| *re == 0.0 && *im > 0.0)
        .map(|[_, im]| im)
        .collect();
    frequencies.sort_by(|p, q| q.total_cmp(p));
    let mut found = Vec::with_capacity(2);
    for frequency in frequencies {
        let course = Course::new(top, known, equilibrium, options)?;
        let mut stretch = course.beginning_at(equilibrium, top.units().reduce(frequency, Dimension::FREQUENCY))?;
        stretch.restore(top, options.held);
        found.push(Family { frequency, stretch });
    }
    Ok(found)
}
