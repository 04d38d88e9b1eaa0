//! Which minima the saddles join, with as few paths as possible: what follows from the connected sphere and its symmetry
//! needs none (Corollary 9.8).

use crate::order::gluing::Classes;

/// Minima and saddles by their positions in a slab, which rise with their heights; two that are mirror images of each other
/// share one.
pub(crate) struct Joining<'a> {
    minima: &'a [usize],
    saddles: Vec<Saddle>,
}

struct Saddle {
    position: usize,
    /// A minimum of the component on each side, where they are known.
    arms: Option<[usize; 2]>,
}

impl<'a> Joining<'a> {
    /// Finds the arms of all saddles, which are listed by rising position; `path` finds those of one saddle by its number.
    /// `None` when not all of them follow.
    pub fn new(minima: &'a [usize], saddles: &[usize], path: impl Fn(usize) -> Option<[usize; 2]>) -> Option<Self> {
        let saddles = saddles.iter().map(|&position| Saddle { position, arms: None }).collect();
        let mut found = Self { minima, saddles };
        let mut lost = vec![false; found.saddles.len()];
        loop {
            found.settle();
            let open: Vec<usize> = (0..lost.len()).filter(|&n| found.saddles[n].arms.is_none()).collect();
            let Some(&first) = open.first() else {
                return Some(found);
            };
            let position = found.saddles[first].position;
            let last = open.iter().all(|&n| found.saddles[n].position == position);
            if let Some(arms) = if last { found.joined(position) } else { None } {
                for n in open {
                    found.saddles[n].arms = Some(arms);
                }
                continue;
            }
            let next = open.into_iter().find(|&n| !lost[n])?;
            found.saddles[next].arms = path(next);
            lost[next] = found.saddles[next].arms.is_none();
        }
    }

    /// Positions and arms of the saddles.
    pub fn arms(&self) -> Vec<(usize, [usize; 2])> {
        self.saddles.iter().filter_map(|saddle| Some((saddle.position, saddle.arms?))).collect()
    }

    /// A minimum of the only component below a position.
    pub fn only(&self, position: usize) -> Option<usize> {
        match self.components(position)[..] {
            [component] => Some(component),
            _ => None,
        }
    }

    /// Both sides of a saddle lie in the only component below it.
    fn settle(&mut self) {
        for n in 0..self.saddles.len() {
            if self.saddles[n].arms.is_none() {
                self.saddles[n].arms = self.only(self.saddles[n].position).map(|only| [only, only]);
            }
        }
    }

    /// The arms of all saddles at a position, where all others are known and leave two components of the sphere: one of them
    /// joins these, and another one is its mirror image.
    fn joined(&self, position: usize) -> Option<[usize; 2]> {
        let [p, q] = self.components(position)[..] else {
            return None;
        };
        let mut all = self.classes(usize::MAX);
        let parts = self.components(usize::MAX).len();
        (parts == 2 && all.root(p) != all.root(q)).then_some([p, q])
    }

    /// One minimum of each component below a position, as far as the saddles are known.
    fn components(&self, position: usize) -> Vec<usize> {
        let mut classes = self.classes(position);
        let below = (0..self.minima.len()).filter(|&n| self.minima[n] < position);
        let mut roots: Vec<usize> = below.map(|n| classes.root(n)).collect();
        roots.sort_unstable();
        roots.dedup();
        roots
    }

    fn classes(&self, position: usize) -> Classes {
        let mut classes = Classes::new(self.minima.len());
        for [p, q] in self.saddles.iter().filter(|saddle| saddle.position < position).filter_map(|saddle| saddle.arms) {
            classes.join(p, q);
        }
        classes
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// Minima and saddles of a sphere: their positions, and the arms of the saddles. With `mirrored` each saddle has a mirror
    /// image, and minima 2n and 2n + 1 are mirror images of each other.
    #[derive(Debug)]
    struct Tree {
        minima: Vec<usize>,
        saddles: Vec<(usize, [usize; 2])>,
    }

    fn trees() -> impl Strategy<Value = Tree> {
        let saddle = (any::<prop::sample::Index>(), any::<prop::sample::Index>(), 1..20usize);
        let saddles = prop::collection::vec(saddle, 1..6);
        (prop::collection::vec(0..8usize, 1..6), saddles, any::<bool>()).prop_map(|(mut minima, saddles, mirrored)| {
            minima.sort_unstable();
            let image = |n: usize, count: usize| {
                if mirrored && (n ^ 1) < count { n ^ 1 } else { n }
            };
            let count = minima.len();
            if mirrored {
                (1..count).step_by(2).for_each(|n| minima[n] = minima[n - 1]);
            }
            let minima: Vec<usize> = minima.into_iter().map(|p| 40 * p).collect();
            let mut list = Vec::new();
            for (number, (p, q, up)) in saddles.into_iter().enumerate() {
                let (p, q) = (p.index(count), q.index(count));
                let position = minima[p].max(minima[q]) + 40 * up - 30 + 4 * number;
                list.push((position, [p, q]));
                if mirrored {
                    list.push((position, [image(p, count), image(q, count)]));
                }
            }
            list.sort_unstable();
            Tree { minima, saddles: list }
        })
    }

    /// The minima below each position, by the components in which they lie.
    fn partition(minima: &[usize], saddles: &[(usize, [usize; 2])], position: usize) -> Vec<Option<usize>> {
        let mut classes = Classes::new(minima.len());
        saddles.iter().filter(|(p, _)| *p <= position).for_each(|(_, [p, q])| {
            classes.join(*p, *q);
        });
        let first = |classes: &mut Classes, n: usize| (0..minima.len()).find(|&m| classes.root(m) == classes.root(n));
        (0..minima.len()).map(|n| if minima[n] <= position { first(&mut classes, n) } else { None }).collect()
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(3000))]

        /// Whatever paths are missing, what follows is true at each height.
        #[test]
        fn components_are_those_of_all_paths(tree in trees(), known in any::<u16>()) {
            let Tree { minima, saddles } = &tree;
            let whole = partition(minima, saddles, usize::MAX);
            if whole.iter().any(|class| *class != whole[0]) {
                return Ok(());
            }
            let positions: Vec<usize> = saddles.iter().map(|(position, _)| *position).collect();
            let path = |n: usize| (known >> n & 1 == 1).then(|| saddles[n].1);
            let Some(found) = Joining::new(minima, &positions, path) else { return Ok(()) };
            for &position in &positions {
                prop_assert_eq!(partition(minima, &found.arms(), position), partition(minima, saddles, position));
            }
        }
    }

    /// Two minima, and two saddles that are mirror images: both join them, and no path is asked for.
    #[test]
    fn mirror_images_join_the_two_sides() {
        let found = Joining::new(&[0, 1], &[2, 2], |_| unreachable!("no path is needed")).unwrap();
        assert_eq!(found.arms(), [(2, [0, 1]), (2, [0, 1])]);
        assert_eq!((found.only(1), found.only(2), found.only(3)), (Some(0), None, Some(0)));
        // A saddle that may be on either side of another one is not decided.
        assert!(Joining::new(&[0, 1], &[2, 3], |_| None).is_none());
    }
}
