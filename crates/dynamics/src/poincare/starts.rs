//! Starting points in every component of the section.

use super::{PoincareError, SectionSetting};
use crate::section::{
    Monitor, SectionError, StartOptions, TorusPoint, spread_starts, spread_starts_over, spread_starts_round,
};
use bifdiag_diagram::accessible::component_of;

/// Places of the whole sphere that are tried for each start before a component counts as small.
const TRIES: u64 = 2000;

impl SectionSetting {
    /// `count` points, an equal share in each component of U_hl, alternating between the sheets: low-discrepancy,
    /// reproducible.
    ///
    /// A component too small to be met by points spread over the sphere is filled from around its minimum.
    ///
    /// # Errors
    /// [`PoincareError::Merge`] when components could not be separated, [`PoincareError::NoStart`] when one is too
    /// small for `f64`.
    pub fn spread(&self, count: usize, seed: u64) -> Result<Vec<TorusPoint>, PoincareError> {
        self.spread_watched(count, seed, &Monitor::default())
    }

    /// The same; `monitor` can stop the search.
    ///
    /// # Errors
    /// Those of [`spread`](Self::spread); [`SectionError::Interrupted`] when it was stopped.
    pub fn spread_watched(&self, count: usize, seed: u64, monitor: &Monitor) -> Result<Vec<TorusPoint>, PoincareError> {
        let parts = self.component_count();
        let partition = if parts > 1 { self.region.partition()? } else { None };
        let mut found: Vec<std::vec::IntoIter<TorusPoint>> = Vec::with_capacity(parts);
        for part in 0..parts {
            let share = count / parts + usize::from(part < count % parts);
            let options = StartOptions { count: share, seed, tries_per_start: TRIES, stop: Some(&monitor.stop) };
            let here = |gamma: [f64; 3]| partition.as_ref().map_or(Some(0), |p| component_of(p, gamma)) == Some(part);
            let spread = if parts == 1 {
                spread_starts(&self.torus, self.h(), self.l(), &options)
            } else {
                spread_starts_over(&self.torus, self.h(), self.l(), &options, 1, &|gamma| here(gamma).then_some(0))
            };
            let points = match spread {
                Err(SectionError::Inaccessible { .. }) => {
                    let center = self.minimum(part).ok_or(PoincareError::NoStart { component: part })?;
                    spread_starts_round(&self.torus, self.h(), self.l(), &options, center, &here).map_err(|error| {
                        match error {
                            SectionError::Inaccessible { .. } => PoincareError::NoStart { component: part },
                            error => error.into(),
                        }
                    })?
                }
                spread => spread?,
            };
            found.push(points.into_iter());
        }
        // In turn, so that the first orbits show every component.
        let mut starts = Vec::with_capacity(count);
        while starts.len() < count {
            starts.extend(found.iter_mut().filter_map(Iterator::next));
        }
        Ok(starts)
    }

    /// A minimum of U in a component, in the body's axes.
    fn minimum(&self, part: usize) -> Option<[f64; 3]> {
        match self.region.partition() {
            Ok(Some(partition)) => partition.minimum_of(part).map(|gamma| partition.frame().vector_to_body(gamma)),
            _ => self.torus.top().r_hat(),
        }
    }
}
