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
    mirror: Mirror,
    /// A minimum of the component on each side, where they are known.
    arms: Option<[usize; 2]>,
}

/// A reflection that takes a saddle to the other one at its position; or, with `exchanges`, to itself and each of its sides to the
/// other.
pub(crate) struct Mirror {
    /// What it makes of each minimum.
    pub image: Vec<usize>,
    pub exchanges: bool,
}

/// Arms that are tried, each with the number of its saddle.
type Choice = Vec<(usize, [usize; 2])>;

/// Positions of unknown saddles for which all choices are tried.
const MOST_OPEN: usize = 3;

impl<'a> Joining<'a> {
    /// Finds the arms of all saddles, which are listed by rising position; `path` finds those of one saddle by its number.
    /// `None` when not all of them follow.
    pub fn new(
        minima: &'a [usize],
        saddles: Vec<(usize, Mirror)>,
        path: impl Fn(usize) -> Option<[usize; 2]>,
    ) -> Option<Self> {
        let saddles = saddles.into_iter().map(|(position, mirror)| Saddle { position, mirror, arms: None }).collect();
        let mut found = Self { minima, saddles };
        let mut lost = vec![false; found.saddles.len()];
        loop {
            found.settle();
            let open: Vec<usize> = (0..lost.len()).filter(|&n| found.saddles[n].arms.is_none()).collect();
            if open.is_empty() {
                return Some(found);
            }
            if let Some(choice) = found.only_choice(&open) {
                for (n, arms) in choice {
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
        match self.components(position, &Choice::new())[..] {
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

    /// The arms of all unknown saddles: of all that the symmetry allows those that leave the sphere connected, if they join the same
    /// components at every height, and each of these holds as many saddles.
    fn only_choice(&self, open: &[usize]) -> Option<Choice> {
        let position = |n: usize| self.saddles[n].position;
        let groups: Vec<&[usize]> = open.chunk_by(|&m, &n| position(m) == position(n)).collect();
        if groups.len() > MOST_OPEN {
            return None;
        }
        let mut choices: Vec<Choice> = vec![Vec::new()];
        for group in &groups {
            let longer = choices.iter().map(|chosen| self.longer(chosen, group)).collect::<Option<Vec<_>>>()?;
            choices = longer.concat();
        }
        choices.retain(|chosen| {
            let mut classes = self.classes(usize::MAX, chosen);
            (0..self.minima.len()).all(|n| classes.root(n) == classes.root(0))
        });
        let parts = |chosen: &Choice| {
            let above = |group: &&[usize]| {
                let mut classes = self.classes(position(group[0]) + 1, chosen);
                // Each class is named by its least member.
                let parts: Vec<usize> = (0..self.minima.len()).map(|n| classes.root(n)).collect();
                let here = chosen.iter().filter(|(n, _)| group.contains(n));
                let mut saddles: Vec<usize> = here.map(|(_, [p, _])| classes.root(*p)).collect();
                saddles.sort_unstable();
                (parts, saddles)
            };
            groups.iter().map(above).collect::<Vec<_>>()
        };
        let first = choices.first()?;
        let expected = parts(first);
        choices.iter().all(|other| parts(other) == expected).then(|| first.clone())
    }

    /// A choice for lower saddles, with each possible choice for those at one position: any two components below whose
    /// images are joined by the mirror image and that an exchange of sides maps to each other.
    fn longer(&self, chosen: &Choice, group: &[usize]) -> Option<Vec<Choice>> {
        let Saddle { position, mirror, .. } = &self.saddles[group[0]];
        let mut classes = self.classes(*position, chosen);
        let below = self.components(*position, chosen);
        let mut found = Vec::new();
        for (place, &p) in below.iter().enumerate() {
            for &q in &below[place..] {
                let image = [p, q].map(|minimum| classes.root(mirror.image[minimum]));
                let arms = match group {
                    [one] if !mirror.exchanges || image == [q, p] => vec![(*one, [p, q])],
                    [_] => continue,
                    [one, other] => vec![(*one, [p, q]), (*other, image)],
                    _ => return None,
                };
                found.push(chosen.iter().copied().chain(arms).collect());
            }
        }
        Some(found)
    }

    /// One minimum of each component below a position, given the saddles known or chosen.
    fn components(&self, position: usize, chosen: &Choice) -> Vec<usize> {
        let mut classes = self.classes(position, chosen);
        let below = (0..self.minima.len()).filter(|&n| self.minima[n] < position);
        let mut roots: Vec<usize> = below.map(|n| classes.root(n)).collect();
        roots.sort_unstable();
        roots.dedup();
        roots
    }

    fn classes(&self, position: usize, chosen: &Choice) -> Classes {
        let mut classes = Classes::new(self.minima.len());
        let known = self.saddles.iter().filter_map(|saddle| Some((saddle.position, saddle.arms?)));
        let chosen = chosen.iter().map(|(n, arms)| (self.saddles[*n].position, *arms));
        for (_, [p, q]) in known.chain(chosen).filter(|(at, _)| *at < position) {
            classes.join(p, q);
        }
        classes
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// Minima and saddles of a sphere: their positions, the arms of the saddles, and which of them a reflection takes to itself, with
    /// its sides exchanged. With `mirrored` each other saddle has a mirror image, and minima 2n and 2n + 1 are mirror images of each
    /// other.
    #[derive(Debug)]
    struct Tree {
        minima: Vec<usize>,
        saddles: Vec<(usize, [usize; 2], bool)>,
        mirrored: bool,
    }

    /// Minimum n ^ 1, where there is one.
    fn image(n: usize, count: usize) -> usize {
        if (n ^ 1) < count { n ^ 1 } else { n }
    }

    fn trees() -> impl Strategy<Value = Tree> {
        let saddle = (any::<prop::sample::Index>(), any::<prop::sample::Index>(), 1..20usize, any::<bool>());
        let saddles = prop::collection::vec(saddle, 1..6);
        (prop::collection::vec(0..8usize, 1..6), saddles, any::<bool>()).prop_map(|(mut minima, saddles, mirrored)| {
            minima.sort_unstable();
            let count = minima.len();
            if mirrored {
                (1..count).step_by(2).for_each(|n| minima[n] = minima[n - 1]);
            }
            let minima: Vec<usize> = minima.into_iter().map(|p| 40 * p).collect();
            let mut list = Vec::new();
            for (number, (p, q, up, alone)) in saddles.into_iter().enumerate() {
                let exchanges = mirrored && alone;
                let p = p.index(count);
                let q = if exchanges { image(p, count) } else { q.index(count) };
                let position = minima[p].max(minima[q]) + 40 * up - 30 + 4 * number;
                list.push((position, [p, q], exchanges));
                if mirrored && !exchanges {
                    list.push((position, [image(p, count), image(q, count)], false));
                }
            }
            list.sort_unstable();
            Tree { minima, saddles: list, mirrored }
        })
    }

    /// The minima below each position and the saddles up to it, by the components in which they lie.
    fn partition(
        minima: &[usize],
        saddles: &[(usize, [usize; 2])],
        position: usize,
    ) -> (Vec<Option<usize>>, Vec<Option<usize>>) {
        let mut classes = Classes::new(minima.len());
        let below = || saddles.iter().filter(|(p, _)| *p <= position);
        below().for_each(|(_, [p, q])| {
            classes.join(*p, *q);
        });
        let first = |classes: &mut Classes, n: usize| (0..minima.len()).find(|&m| classes.root(m) == classes.root(n));
        let mut held: Vec<Option<usize>> = below().map(|(_, [p, _])| first(&mut classes, *p)).collect();
        held.sort_unstable();
        let parts = (0..minima.len()).map(|n| if minima[n] <= position { first(&mut classes, n) } else { None });
        (parts.collect(), held)
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(10000))]

        /// Whatever paths are missing, what follows is true at each height.
        #[test]
        fn components_are_those_of_all_paths(tree in trees(), known in any::<u16>()) {
            let Tree { minima, saddles, mirrored } = &tree;
            let arms: Vec<(usize, [usize; 2])> = saddles.iter().map(|(position, arms, _)| (*position, *arms)).collect();
            let whole = partition(minima, &arms, usize::MAX);
            if whole.0.iter().any(|class| *class != whole.0[0]) {
                return Ok(());
            }
            let mirror = |exchanges| {
                let all = 0..minima.len();
                let image = all.map(|n| if *mirrored { image(n, minima.len()) } else { n }).collect();
                Mirror { image, exchanges }
            };
            let list = saddles.iter().map(|(position, _, exchanges)| (*position, mirror(*exchanges))).collect();
            let path = |n: usize| (known >> n & 1 == 1).then(|| saddles[n].1);
            let Some(found) = Joining::new(minima, list, path) else { return Ok(()) };
            for (position, _) in &arms {
                prop_assert_eq!(partition(minima, &found.arms(), *position), partition(minima, &arms, *position));
            }
        }
    }

    fn joined(
        minima: &[usize],
        saddles: &[usize],
        image: &[usize],
        exchanged: Option<usize>,
    ) -> Option<Vec<(usize, [usize; 2])>> {
        let mirror = |(n, &position): (usize, &usize)| {
            (position, Mirror { image: image.to_vec(), exchanges: exchanged == Some(n) })
        };
        let found = Joining::new(minima, saddles.iter().enumerate().map(mirror).collect(), |_| None)?;
        Some(found.arms())
    }

    /// Two minima, and two saddles that are mirror images: both join them, and no path is asked for.
    #[test]
    fn mirror_images_join_the_two_sides() {
        assert_eq!(joined(&[0, 1], &[2, 2], &[0, 1], None).unwrap(), [(2, [0, 1]), (2, [0, 1])]);
        // A saddle that may be on either side of another one is not decided.
        assert!(joined(&[0, 1], &[2, 3], &[0, 1], None).is_none());
        let mirror = || Mirror { image: vec![0, 1], exchanges: false };
        let found =
            Joining::new(&[0, 1], vec![(2, mirror()), (2, mirror())], |_| unreachable!("no path is needed")).unwrap();
        assert_eq!((found.only(1), found.only(2), found.only(3)), (Some(0), None, Some(0)));
    }

    /// Above a pair of saddles a third one lies between two minima that are mirror images, and its sides are, too: it does not lead to
    /// the third minimum, so that the pair does. Without the symmetry nothing follows.
    #[test]
    fn mirror_images_join_both_minima_of_a_pair() {
        let [swapped, same] = [[0, 2, 1], [0, 1, 2]];
        let found = joined(&[0, 1, 1], &[2, 2, 3], &swapped, Some(2)).unwrap();
        assert_eq!(found[..2], [(2, [0, 1]), (2, [0, 2])]);
        assert!(joined(&[0, 1, 1], &[2, 2, 3], &swapped, None).is_none());
        assert!(joined(&[0, 1, 1], &[2, 2, 3], &same, None).is_none());
    }
}
