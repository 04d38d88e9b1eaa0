//! Orbits that are followed until it is known whether they are regular or chaotic.

use super::{PoincareError, PoincareSection, Setting};
use crate::section::chaos::{ChaosMeasure, ChaosOptions, chaos_measures};
use crate::section::{End, Monitor, OrbitSection, SweepOptions, TorusPoint, sweep};

/// Crossings after which a verdict is looked for; then after twice as many, and so on.
const FIRST_LOOK: usize = 128;

impl Setting {
    /// As [`run`](Self::run) and [`measure`](Self::measure), but an orbit ends where its verdict is found: after 128
    /// crossings, or 256, 512, …, or as many as the options allow. Those that go on begin anew, so that this takes at most
    /// twice the time of the orbits that it returns.
    ///
    /// # Errors
    /// As both of them.
    pub fn run_until_decided(
        &self,
        starts: &[TorusPoint],
        seed: Option<u64>,
        options: &SweepOptions,
        chaos: &ChaosOptions,
        monitor: &Monitor,
    ) -> Result<PoincareSection, PoincareError> {
        let mut section = self.begin(starts, seed, options)?;
        section.early = true;
        let mut pending: Vec<u32> = (0_u32..).zip(starts).map(|(orbit, _)| orbit).collect();
        let mut done: Vec<(OrbitSection, ChaosMeasure)> = Vec::with_capacity(starts.len());
        let mut crossings = FIRST_LOOK.min(options.crossings);
        while !pending.is_empty() {
            let mut states = Vec::with_capacity(pending.len());
            for &orbit in &pending {
                states.push(self.state(starts[orbit as usize])?);
            }
            let orbits = sweep(self.torus(), &states, &SweepOptions { crossings, ..*options }, monitor)?;
            let measures = chaos_measures(self.torus(), &orbits, chaos, monitor)?;
            let last = crossings >= options.crossings || monitor.is_stopped();
            let mut undecided = Vec::new();
            for (mut orbit, mut measure) in orbits.into_iter().zip(measures) {
                let number = pending[orbit.orbit as usize];
                let open = measure.judgement.verdict.is_open();
                if orbit.report.end == End::Crossings && !last {
                    if open {
                        undecided.push(number);
                        continue;
                    }
                    orbit.report.end = End::Decided;
                }
                orbit.orbit = number;
                orbit.points.iter_mut().for_each(|point| point.orbit = number);
                measure.orbit = number;
                done.push((orbit, measure));
            }
            pending = undecided;
            crossings = (2 * crossings).min(options.crossings);
        }
        done.sort_by_key(|(orbit, _)| orbit.orbit);
        (section.orbits, section.chaos) = done.into_iter().unzip();
        section.chaos_interrupted = monitor.is_stopped();
        Ok(section)
    }
}
