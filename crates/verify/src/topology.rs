//! The topology that is claimed of each region, against boxes and Morse theory.

use dashu_ratio::RBig;

use super::faces::Slab;
use super::family::{Point, Spaces};
use super::fixed::Fixed;
use super::order::Orders;
use super::pieces::Family;
use super::{Refused, number, sphere, words};
use schema::{AtlasDocument, CertificateDocument, ComponentDocument};
use top::topology::{Component, Poles};

/// An extremum of U: γ in the body's axes.
struct Extremum {
    minimum: bool,
    gamma: Vec<[f64; 3]>,
}

/// Checks every region; those that the atlas leaves open, or that these boxes do not decide, are listed.
pub(super) fn check(
    document: &AtlasDocument,
    certificate: &CertificateDocument,
    orders: &Orders,
    slabs: &[Slab],
    cells: &[Vec<(usize, usize)>],
) -> Result<Vec<String>, Refused> {
    let spaces = orders.spaces;
    let mut open = Vec::new();
    for (face, region) in document.regions.iter().enumerate() {
        let refuse = |why| Refused::Region { region: region.id.clone(), why };
        if region.components.is_empty() {
            open.push(region.id.clone());
            continue;
        }
        let sample = certificate.samples.iter().find(|sample| sample.region == region.id);
        let sample = sample.ok_or_else(|| refuse("it has no sample"))?;
        let slab = slabs.get(sample.slab).ok_or_else(|| refuse("its sample lies in no slab"))?;
        let h = number(&sample.h).ok_or_else(|| Refused::Number { text: sample.h.clone() })?;
        let h_set = Fixed::of(&h);
        let position = slab.stands.iter().take_while(|(_, _, height)| height.below(&h_set)).count();
        let above = slab.stands.get(position).is_none_or(|(_, _, height)| h_set.below(height));
        let position = position.checked_sub(1).filter(|_| above).ok_or_else(|| refuse("its sample is not inside"))?;
        if !cells[face].contains(&(sample.slab, position)) {
            return Err(refuse("its sample lies in another region"));
        }
        let found = components(spaces, orders, slab, position, &h);
        let Some(found) = found? else {
            open.push(region.id.clone());
            continue;
        };
        let expected: Vec<ComponentDocument> = found.iter().map(crate::component).collect();
        if expected != region.components || region.signature != top::topology::signature(&found) {
            let claimed = region.components.iter().map(|c| c.accessible_region.clone()).collect::<Vec<_>>().join(" + ");
            return Err(Refused::Topology { region: region.id.clone(), claimed, found: words(&found) });
        }
    }
    Ok(open)
}

fn components(
    spaces: &Spaces,
    orders: &Orders,
    slab: &Slab,
    position: usize,
    h: &RBig,
) -> Result<Option<Vec<Component>>, Refused> {
    let has_poles = !spaces.active.is_empty();
    if position + 1 == slab.stands.len() {
        let poles = has_poles.then_some(Poles { plus: true, minus: true });
        return Ok(Some(vec![Component { boundary_circles: 0, poles }]));
    }
    let (mut minima, mut maxima) = (Vec::new(), Vec::new());
    for (place, (curve, point, _)) in slab.stands.iter().enumerate() {
        if !orders.pieces.list[*curve].critical {
            continue;
        }
        let refused = || Refused::Place { curve: orders.pieces.list[*curve].id.clone(), x: slab.x.to_f64() };
        let Some(extremum) = extremum(spaces, orders.pieces.list[*curve].family, point).ok_or_else(refused)? else {
            continue;
        };
        match (extremum.minimum, place <= position) {
            (true, true) => minima.extend(extremum.gamma),
            (false, false) => maxima.extend(extremum.gamma),
            _ => {}
        }
    }
    let double = |x: &RBig| x.to_f64().value();
    let mut a = [0.0; 3];
    for space in &spaces.list {
        for &axis in &space.axes {
            a[axis] = double(&space.a);
        }
    }
    let r = spaces.r.each_ref().map(double);
    let region = sphere::Region { a, r, h: double(h), x: slab.x.to_f64() };
    Ok(sphere::components(&region, &minima, &maxima, has_poles.then_some(r)))
}

/// Whether an equilibrium is a minimum or a maximum of U: `Some(None)` for a saddle, `None` when that is not certain.
///
/// The second variation on γ⊥ is that of (μ−A) + (4/J)Aγ(Aγ)ᵀ; its trace and determinant tell. A circle of equilibria has
/// determinant 0, and its trace tells alone.
#[allow(clippy::option_option)]
fn extremum(spaces: &Spaces, family: Family, point: &Point) -> Option<Option<Extremum>> {
    let tau_of = point.tau.as_ref()?;
    let (mut a, mut tau, mut gamma) = (Vec::new(), Vec::new(), Vec::new());
    for (k, space) in spaces.list.iter().enumerate() {
        for n in 0..space.axes.len() {
            a.push(space.a_set.clone());
            tau.push(tau_of[k].clone());
            // Along the first direction of each space, which is that of r where there is r.
            gamma.push(if n == 0 { point.gamma[k].clone() } else { Fixed::whole(0) });
        }
    }
    let w: Vec<Fixed> = gamma.iter().map(Fixed::square).collect();
    let one = Fixed::whole(1);
    let stiffness = Fixed::whole(4).over(&point.j)?;
    let (mut trace, mut determinant) = (Fixed::whole(0), Fixed::whole(0));
    for k in 0..3 {
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        let twist = (&(&gamma[i] * &gamma[j]) * &(&a[j] - &a[i])).square();
        trace = &(&trace + &(&(&one - &w[k]) * &tau[k])) + &(&stiffness * &twist);
        determinant = &(&determinant + &(&w[k] * &(&tau[i] * &tau[j]))) + &(&stiffness * &(&tau[k] * &twist));
    }
    let circle = match family {
        Family::Over(base) | Family::Rotation(base) => spaces.list[base].axes.len() > 1,
        _ => false,
    };
    let minimum = match (circle, determinant.sign()) {
        (false, Some(-1)) => return Some(None),
        (false, Some(1)) | (true, _) => trace.sign().filter(|sign| *sign != 0)? > 0,
        _ => return None,
    };
    let direction = |flip: bool| {
        let mut v = [0.0; 3];
        for (k, space) in spaces.list.iter().enumerate() {
            let along = point.gamma[k].to_f64();
            let along = match family {
                Family::Over(base) | Family::Rotation(base) if base == k && flip => -along,
                _ => along,
            };
            let norm = if space.q.is_zero() { 0.0 } else { space.root_q.to_f64() };
            for (n, &axis) in space.axes.iter().enumerate() {
                let unit =
                    if norm > 0.0 { spaces.r[axis].to_f64().value() / norm } else { f64::from(u8::from(n == 0)) };
                v[axis] = along * unit;
            }
        }
        v
    };
    let paired = matches!(family, Family::Over(_) | Family::Rotation(_)) && !circle;
    let gamma = if paired { vec![direction(false), direction(true)] } else { vec![direction(false)] };
    Some(Some(Extremum { minimum, gamma }))
}
