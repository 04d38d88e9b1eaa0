//! The topology of U from its minima, saddles and maxima (Propositions 9.1 and 9.2, Corollary 9.8).

use super::component::Component;
use super::descent::Descent;
use super::joining::{Joining, Mirror};
use super::landscape::{Coordinates, Landscape, Origin};
use super::morse::{Nature, nature};
use crate::equilibria::pieces::Branch;
use crate::order::gluing::Classes;
use crate::order::orders::Orders;
use crate::order::slabs::{Level, Slab};

/// A critical point, by the position of its curve in a slab.
struct Critical {
    position: usize,
    nature: Nature,
    origin: Origin,
    /// For one of a pair, the space in which it is mirrored.
    base: Option<usize>,
    /// For a single one, a space of one axis along which U falls: reflected there, its sides change places.
    falls_along: Option<usize>,
}

impl Critical {
    /// The reflection of a saddle that leads to the other one of a pair, or exchanges its sides. Minima that are no pair over its
    /// space lie in its plane.
    fn mirror(&self, minima: &[&Self]) -> Mirror {
        let space = self.base.or(self.falls_along);
        let image = |(number, minimum): (usize, &&Self)| {
            let is_other = |n: &usize| *n != number && minima[*n].position == minimum.position;
            let moved = space.is_some() && minimum.base == space;
            if moved { (0..minima.len()).find(is_other).unwrap_or(number) } else { number }
        };
        Mirror {
            image: minima.iter().enumerate().map(image).collect(),
            exchanges: self.base.is_none() && space.is_some(),
        }
    }
}

/// A point of the sphere: its position, and the number of a minimum to which a path descends from it.
type Foot = (usize, usize);

/// How the critical points of U over the abscissa of a slab are joined.
pub(crate) struct Merging {
    /// Positions.
    minima: Vec<usize>,
    saddles: Vec<(usize, [usize; 2])>,
    maxima: Vec<Foot>,
    /// r̂ and −r̂, unless r = 0.
    poles: Option<[Foot; 2]>,
}

impl Merging {
    /// `None` when an equilibrium is not certain to be nondegenerate, or no path from it is proved.
    pub fn new(orders: &Orders, slab: &Slab) -> Option<Self> {
        let land = Landscape::new(orders.spaces, &orders.spaces.set(&slab.x))?;
        let criticals = criticals(orders, slab, &land)?;
        let of = |nature: Nature| criticals.iter().filter(move |critical| critical.nature == nature);
        let positions = |nature: Nature| of(nature).map(|critical| critical.position).collect::<Vec<usize>>();
        let minima: Vec<&Coordinates> = of(Nature::Minimum).map(|critical| &critical.origin.gamma).collect();
        let descent = Descent { land: &land, minima: &minima };
        let list = positions(Nature::Minimum);
        let saddles: Vec<&Origin> = of(Nature::Saddle).map(|saddle| &saddle.origin).collect();
        let mirrors =
            of(Nature::Saddle).map(|saddle| (saddle.position, saddle.mirror(&of(Nature::Minimum).collect::<Vec<_>>())));
        let joining = Joining::new(&list, mirrors.collect(), |n| descent.arms(saddles[n]))?;
        let foot = |position: usize, from: &Origin| joining.only(position).or_else(|| descent.any(from));
        let maxima =
            of(Nature::Maximum).map(|maximum| Some((maximum.position, foot(maximum.position, &maximum.origin)?)));
        let maxima: Vec<Foot> = maxima.collect::<Option<_>>()?;
        // Proposition 4.10.
        if minima.len() + maxima.len() != saddles.len() + 2 {
            return None;
        }
        let saddles = joining.arms();
        let mut found = Self { minima: list.clone(), saddles, maxima, poles: None };
        if !orders.spaces.active.is_empty() {
            let pole = |plus: bool| {
                let lies = |level: &Level| orders.pieces.list[level.curve].branch == Branch::Line(plus);
                let position = slab.levels.iter().position(lies)?;
                let level = &slab.levels[position];
                let at_pole = || foot(position, &land.pole(&level.point)?);
                let critical = orders.pieces.list[level.curve].critical;
                Some((position, if critical { found.foot(position) } else { at_pole() }?))
            };
            found.poles = Some([pole(true)?, pole(false)?]);
        }
        Some(found)
    }

    /// The minimum below the one critical point at a position.
    fn foot(&self, position: usize) -> Option<usize> {
        let minimum = || self.minima.iter().position(|&p| p == position);
        let saddle = || self.saddles.iter().find(|(p, _)| *p == position).map(|(_, arms)| arms[0]);
        let maximum = || self.maxima.iter().find(|(p, _)| *p == position).map(|(_, foot)| *foot);
        minimum().or_else(saddle).or_else(maximum)
    }

    /// The components of U above the curve at a position; `None` if these paths contradict themselves.
    pub fn components(&self, position: usize) -> Option<Vec<Component>> {
        let mut classes = Classes::new(self.minima.len());
        let saddles = || self.saddles.iter().filter(|(p, _)| *p <= position);
        for (_, [p, q]) in saddles() {
            classes.join(*p, *q);
        }
        let mut characteristic = vec![0i32; self.minima.len()];
        for minimum in (0..self.minima.len()).filter(|&n| self.minima[n] <= position) {
            characteristic[classes.root(minimum)] += 1;
        }
        for (_, arms) in saddles() {
            characteristic[classes.root(arms[0])] -= 1;
        }
        for (_, foot) in self.maxima.iter().filter(|(p, _)| *p <= position) {
            characteristic[classes.root(*foot)] += 1;
        }
        let roots = (0..self.minima.len()).filter(|&n| self.minima[n] <= position);
        let roots: Vec<usize> = roots.filter(|&n| classes.root(n) == n).collect();
        let component = |&root: &usize| {
            let mut holds = |(p, foot): Foot| p <= position && classes.root(foot) == root;
            let poles = self.poles.map(|poles| poles.map(&mut holds));
            Some(Component { boundary_circles: u32::try_from(2 - characteristic[root]).ok()?, poles })
        };
        roots.iter().map(component).collect()
    }
}

/// The equilibria over the abscissa of a slab: two for a symmetric pair.
fn criticals(orders: &Orders, slab: &Slab, land: &Landscape) -> Option<Vec<Critical>> {
    let mut found = Vec::new();
    for (position, level) in slab.levels.iter().enumerate() {
        let piece = &orders.pieces.list[level.curve];
        if !piece.critical {
            continue;
        }
        let nature = nature(orders.spaces, &level.point)?;
        let base = if let Branch::Over(base) | Branch::Rotation(base) = piece.branch { Some(base) } else { None };
        let falls = |&space: &usize| {
            let tau = level.point.tau.as_ref().and_then(|tau| tau[space].strict_sign());
            orders.spaces.list[space].axes.len() == 1 && tau == Some(-1)
        };
        // At γ_i = 0 the second variation along e_i is μ − a_i (Proposition 4.1).
        let falls_along = if base.is_none() { orders.spaces.passive().into_iter().find(falls) } else { None };
        let mut add = |mirrored| {
            let origin = land.equilibrium(&level.point, mirrored)?;
            found.push(Critical { position, nature, origin, base, falls_along });
            Some(())
        };
        add(None)?;
        if base.is_some() {
            add(base)?;
        }
    }
    Some(found)
}
