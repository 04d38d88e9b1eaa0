//! Ridges and valleys of J over the latitudes, and their pieces inside U_hl.

use std::cmp::Ordering::Less;

use dashu_ratio::RBig;

use super::latitude::{Latitude, RealRoot};

/// A piece of a strand in U_hl by rising w; `None`: it reaches that end of its strand.
#[derive(Clone, Debug)]
pub(super) struct Piece<L> {
    pub ends: [Option<L>; 2],
}

impl<L: Latitude> Piece<L> {
    /// A latitude within the strand lies on this piece; `None` when it cannot be told from an end.
    pub fn holds(&self, latitude: &L) -> Option<bool> {
        let [low, high] = &self.ends;
        let above = low.as_ref().map_or(Some(true), |low| Some(low.compare(latitude)? == Less))?;
        let below = high.as_ref().map_or(Some(true), |high| Some(latitude.compare(high)? == Less))?;
        Some(above && below)
    }

    pub fn reaches(&self, end: usize) -> bool {
        self.ends[end].is_none()
    }

    /// Euler's characteristic with compact support, where `open` tells which ends do not belong to the strand.
    pub fn characteristic(&self, open: [bool; 2]) -> i32 {
        1 - (0..2).map(|end| i32::from(open[end] && self.reaches(end))).sum::<i32>()
    }
}

/// The maximal runs of gaps that are inside, as pairs of the roots at their ends.
pub(super) fn runs(inside: &[bool]) -> Vec<[Option<usize>; 2]> {
    let mut found: Vec<[Option<usize>; 2]> = Vec::new();
    for (gap, _) in inside.iter().enumerate().filter(|(_, inside)| **inside) {
        let (before, after) = (gap.checked_sub(1), (gap + 1 < inside.len()).then_some(gap));
        match found.last_mut() {
            Some(last) if gap > 0 && last[1] == before => last[1] = after,
            _ => found.push([before, after]),
        }
    }
    found
}

/// A rational in each gap between ascending isolated roots.
pub(super) fn samples(roots: &[RealRoot]) -> Vec<RBig> {
    let ranges: Vec<[RBig; 2]> = roots.iter().map(RealRoot::range).collect();
    let (Some(first), Some(last)) = (ranges.first(), ranges.last()) else { return vec![RBig::ZERO] };
    let mut found = vec![&first[0] - RBig::ONE];
    found.extend(ranges.windows(2).map(|pair| (&pair[0][1] + &pair[1][0]) / RBig::from(2)));
    found.push(&last[1] + RBig::ONE);
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn runs_are_maximal() {
        assert_eq!(runs(&[true, true, false, true]), [[None, Some(1)], [Some(2), None]]);
        assert_eq!(runs(&[false, true, false]), [[Some(0), Some(1)]]);
        assert_eq!(runs(&[true]), [[None, None]]);
        assert_eq!(runs(&[false]), [[None::<usize>; 2]; 0]);
    }
}
