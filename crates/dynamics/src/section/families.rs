//! Which orbits of a section belong together: those on one side of the plane through the fixed point across r̂, on each
//! component where there are several. The same family has the same colour in every region.

use bifdiag_body::Body;
use bifdiag_diagram::accessible::{AccessibleRegion, component_of};

use super::orbit::OrbitSection;
use crate::field::dot;

/// What the families are called.
pub const FAMILIES: [&str; 4] = ["on the side of +r̂", "on the side of −r̂", "on both sides", "on a further component"];

/// The family of each orbit, a place in [`FAMILIES`]. On a section of several components the majority of the crossings tells
/// the side of a component; two of them on one side are told apart.
#[must_use]
pub fn families(body: &Body, h: f64, l: f64, orbits: &[OrbitSection]) -> Vec<usize> {
    let center = body.center_f64();
    let region = AccessibleRegion::new(body, h, l).ok();
    let partition = region.as_ref().and_then(|region| region.partition().ok().flatten());
    let parts = partition.as_ref().filter(|partition| partition.components().len() > 1);
    // Crossings with ⟨γ, r⟩ > 0, and all.
    let count = |orbit: &OrbitSection| {
        let above = orbit.points.iter().filter(|point| dot(point.gamma, center) > 0.0).count();
        [above, orbit.points.len()]
    };
    let Some(parts) = parts else {
        let side = |[above, all]: [usize; 2]| if above == all { 0 } else { 2 - usize::from(above == 0) };
        return orbits.iter().map(|orbit| side(count(orbit))).collect();
    };
    let component =
        |orbit: &OrbitSection| orbit.points.first().and_then(|point| component_of(parts, point.gamma)).unwrap_or(0);
    let components: Vec<usize> = orbits.iter().map(component).collect();
    let mut family: Vec<Option<usize>> = vec![None; parts.components().len()];
    for place in 0..family.len() {
        let own = orbits.iter().zip(&components).filter(|(_, component)| **component == place);
        let [above, all] = own.fold([0, 0], |[a, n], (orbit, _)| {
            let [above, all] = count(orbit);
            [a + above, n + all]
        });
        let side = usize::from(2 * above < all);
        family[place] = Some(if family.contains(&Some(side)) { FAMILIES.len() - 1 } else { side });
    }
    components.into_iter().map(|component| family[component].unwrap_or(0)).collect()
}
