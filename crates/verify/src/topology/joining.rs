//! Which minima the saddles join, with as few paths as possible: what follows from the connected sphere and its symmetry
//! needs none (Corollary 9.8).

use crate::order::gluing::Classes;

/// Minima and saddles by their positions in a slab, which rise with their heights; two that are mirror images of each other
/// share one.
pub(crate) struct Joining<'a> {
    minima: &'a [usize],
    saddles: Vec<Saddle>,
    /// The minimum that the reflection which leads from a saddle to its mirror image makes of one.
    image: &'a dyn Fn(usize, usize) -> usize,
}

struct Saddle {
    position: usize,
    /// A minimum of the component on each side, where they are known.
    arms: Option<[usize; 2]>,
}

impl<'a> Joining<'a> {
    /// Finds the arms of all saddles, which are listed by rising position; `path` finds those of one saddle by its number,
    /// `image` the mirror image of a minimum under the reflection of a saddle, both by number. `None` when not all of them
    /// follow.
    pub fn new(
        minima: &'a [usize],
        saddles: &[usize],
        image: &'a dyn Fn(usize, usize) -> usize,
        path: impl Fn(usize) -> Option<[usize; 2]>,
    ) -> Option<Self> {
        let saddles = saddles.iter().map(|&position| Saddle { position, arms: None }).collect();
        let mut found = Self { minima, saddles, image };
        let mut lost = vec![false; found.saddles.len()];
        loop {
            found.settle();
            let open: Vec<usize> = (0..lost.len()).filter(|&n| found.saddles[n].arms.is_none()).collect();
            let Some(&first) = open.first() else {
                return Some(found);
            };
            let position = found.saddles[first].position;
            let last = open.iter().all(|&n| found.saddles[n].position == position);
            if let Some(arms) = if last { found.joined(position, &open) } else { None } {
                for (n, arms) in open.into_iter().zip(arms) {
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

    /// The arms of a saddle, or of one and its mirror image, where all others are known: of all pairs of components below it those
    /// that leave the sphere connected, if they join the same components.
    fn joined(&self, position: usize, open: &[usize]) -> Option<Vec<[usize; 2]>> {
        let below = self.components(position);
        let mut classes = self.classes(position);
        let mut found: Option<(Vec<usize>, Vec<[usize; 2]>)> = None;
        for (place, &p) in below.iter().enumerate() {
            for &q in &below[place..] {
                let arms = match open {
                    [_] => vec![[p, q]],
                    [one, _] => vec![[p, q], [p, q].map(|minimum| classes.root((self.image)(*one, minimum)))],
                    _ => return None,
                };
                let parts_with = |mut classes: Classes| {
                    for [p, q] in &arms {
                        classes.join(*p, *q);
                    }
                    (0..self.minima.len()).map(|n| classes.root(n)).collect::<Vec<usize>>()
                };
                let whole = parts_with(self.classes(usize::MAX));
                if whole.iter().any(|root| *root != whole[0]) {
                    continue;
                }
                let joined = parts_with(self.classes(position));
                let agrees = |first: &[usize]| {
                    (0..joined.len()).all(|n| (0..n).all(|m| (first[n] == first[m]) == (joined[n] == joined[m])))
                };
                if found.as_ref().is_some_and(|(first, _)| !agrees(first)) {
                    return None;
                }
                found.get_or_insert((joined, arms));
            }
        }
        found.map(|(_, arms)| arms)
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
        mirrored: bool,
    }

    /// Minimum n ^ 1, where there is one.
    fn image(n: usize, count: usize) -> usize {
        if (n ^ 1) < count { n ^ 1 } else { n }
    }

    fn trees() -> impl Strategy<Value = Tree> {
        let saddle = (any::<prop::sample::Index>(), any::<prop::sample::Index>(), 1..20usize);
        let saddles = prop::collection::vec(saddle, 1..6);
        (prop::collection::vec(0..8usize, 1..6), saddles, any::<bool>()).prop_map(|(mut minima, saddles, mirrored)| {
            minima.sort_unstable();
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
            Tree { minima, saddles: list, mirrored }
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
            let Tree { minima, saddles, mirrored } = &tree;
            let whole = partition(minima, saddles, usize::MAX);
            if whole.iter().any(|class| *class != whole[0]) {
                return Ok(());
            }
            let positions: Vec<usize> = saddles.iter().map(|(position, _)| *position).collect();
            let path = |n: usize| (known >> n & 1 == 1).then(|| saddles[n].1);
            let image = |_, n: usize| if *mirrored { image(n, minima.len()) } else { n };
            let Some(found) = Joining::new(minima, &positions, &image, path) else { return Ok(()) };
            for &position in &positions {
                prop_assert_eq!(partition(minima, &found.arms(), position), partition(minima, saddles, position));
            }
        }
    }

    /// Two minima, and two saddles that are mirror images: both join them, and no path is asked for.
    #[test]
    fn mirror_images_join_the_two_sides() {
        let found = Joining::new(&[0, 1], &[2, 2], &|_, n| n, |_| unreachable!("no path is needed")).unwrap();
        assert_eq!(found.arms(), [(2, [0, 1]), (2, [0, 1])]);
        assert_eq!((found.only(1), found.only(2), found.only(3)), (Some(0), None, Some(0)));
        // A saddle that may be on either side of another one is not decided.
        assert!(Joining::new(&[0, 1], &[2, 3], &|_, n| n, |_| None).is_none());
    }

    /// Two minima that are mirror images are joined above; whatever a pair of saddles below joins to the third one, its mirror image
    /// joins the other. Without the symmetry nothing follows.
    #[test]
    fn mirror_images_join_both_minima_of_a_pair() {
        let upper = |n: usize| (n == 2).then_some([1, 2]);
        let swapped = |_, n: usize| [0, 2, 1][n];
        let found = Joining::new(&[0, 1, 1], &[2, 2, 3], &swapped, upper).unwrap();
        assert_eq!(found.arms(), [(2, [0, 1]), (2, [0, 2]), (3, [1, 2])]);
        assert!(Joining::new(&[0, 1, 1], &[2, 2, 3], &|_, n| n, upper).is_none());
    }
}
