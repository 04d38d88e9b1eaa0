//! Which accessible regions the theorems of `docs/mathematics.md` leave.

use super::component::{Component, Poles, sort_components};

/// The most boundary circles of U_hl (Proposition 11.8).
pub const CIRCLES_MAX: u32 = 5;

/// Every U_hl that is not excluded for r ≠ 0, by its components: the sphere, a sphere without one to five discs, two to
/// five discs, or a disc and an annulus (Proposition 11.9), with the poles in them. A component with three or more circles
/// contains r̂ (Theorem 11.1), and where −r̂ is in U_hl, so is r̂, whose energy is less. For k = 5, for some discs with
/// poles, and others, it is not known whether they occur.
#[must_use]
pub fn accessible_regions() -> Vec<Vec<Component>> {
    let mut found = vec![vec![component(0, true, true)]];
    let spheres_without_discs = (1..=CIRCLES_MAX).map(|k| vec![k]);
    let several_discs = (2..=CIRCLES_MAX as usize).map(|m| vec![1; m]);
    for circles in spheres_without_discs.chain(several_discs).chain([vec![1, 2]]) {
        let places = 0..circles.len();
        if circles[0] < 3 {
            found.push(region(&circles, [None, None]));
        }
        for plus in places.clone() {
            found.push(region(&circles, [Some(plus), None]));
            found.extend(places.clone().map(|minus| region(&circles, [Some(plus), Some(minus)])));
        }
    }
    for region in &mut found {
        sort_components(region);
    }
    found.sort_by_key(|region| region.iter().map(Component::key).collect::<Vec<_>>());
    found.dedup();
    found
}

/// A component that no body shows: three or more boundary circles without r̂ (Theorem 11.1).
pub(crate) fn is_excluded(component: &Component) -> bool {
    component.boundary_circles >= 3 && component.poles.is_some_and(|poles| !poles.plus)
}

fn component(boundary_circles: u32, plus: bool, minus: bool) -> Component {
    Component { boundary_circles, poles: Some(Poles { plus, minus }) }
}

/// Components with these numbers of circles, and the places of the two poles among them.
fn region(circles: &[u32], poles: [Option<usize>; 2]) -> Vec<Component> {
    let has = |pole: usize, place: usize| poles[pole] == Some(place);
    circles.iter().enumerate().map(|(place, k)| component(*k, has(0, place), has(1, place))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use bifdiag_body::Preset;

    #[test]
    fn the_list_is_that_of_the_propositions() {
        let regions = accessible_regions();
        // S²; k = 1, 2 with none, one or both poles; k = 3, 4, 5 with one or both; m discs with 4 ways of the poles;
        // disc and annulus with 7.
        assert_eq!(regions.len(), 1 + 2 * 3 + 3 * 2 + 4 * 4 + 7);
        for region in &regions {
            let poles = |minus: bool| {
                let holds =
                    |component: &&Component| component.poles.is_some_and(|p| if minus { p.minus } else { p.plus });
                region.iter().filter(holds).count()
            };
            assert!(poles(false) <= 1 && poles(true) <= poles(false), "{region:?}");
            assert!(region.len() == 1 || region.iter().all(|component| component.boundary_circles <= 2), "{region:?}");
            assert!(region.iter().all(|c| c.boundary_circles < 3 || c.poles.unwrap().plus), "{region:?}");
        }
    }

    #[test]
    fn known_bodies_show_no_others() {
        let regions = accessible_regions();
        for preset in Preset::all() {
            let body = preset.body();
            if body.flags().euler {
                continue;
            }
            for region in crate::fast::atlas(&body).unwrap().regions() {
                let components = region.components.as_ref().unwrap();
                assert!(regions.contains(components), "{}: {components:?}", preset.name());
            }
        }
    }
}
