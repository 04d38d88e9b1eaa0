//! The Poincaré section of one body at one (h, l): whether it exists, where its orbits start, and their results.

mod error;
mod starts;

use std::sync::atomic::Ordering;

pub use error::{Near, PoincareError};

use crate::field::{HeavyTop, State};
use crate::section::chaos::{ChaosMeasure, ChaosOptions, Judgement, chaos_measures, verdicts};
use crate::section::{Monitor, OrbitEnd, OrbitSection, PpTorus, SectionError, SweepOptions, TorusPoint, sweep};
use bifdiag_body::{Body, Number};
use bifdiag_diagram::accessible::{AccessibleRegion, component_of};
use bifdiag_diagram::fast::classify;
use bifdiag_diagram::topology::Component;
use bifdiag_diagram::topology::{Answer, Classification, Margin};
use bifdiag_equilibria::critical::critical;

/// A body and a point (h, l) that have a section: r ≠ 0, and (h, l) is accessible and on no curve.
#[derive(Clone, Debug)]
pub struct SectionSetting {
    body: Body,
    torus: PpTorus,
    components: Vec<Component>,
    margin: Margin,
    region: AccessibleRegion,
    energy: Number,
    momentum: Number,
}

/// A section that was computed.
#[derive(Clone, Debug, PartialEq)]
pub struct PoincareSection {
    /// The body.
    pub body: Body,
    /// Energy.
    pub h: Number,
    /// Vertical angular momentum.
    pub l: Number,
    /// The components of U_hl.
    pub components: Vec<Component>,
    /// Where the orbits were to start.
    pub starts: Vec<TorusPoint>,
    /// The seed of spread starts.
    pub seed: Option<u64>,
    /// How they were followed.
    pub options: SweepOptions,
    /// The orbits that were begun; each names its start by its number.
    pub orbits: Vec<OrbitSection>,
    /// For each start the component in which it lies; `None` where that could not be proved.
    pub component_of_start: Vec<Option<usize>>,
    /// How regular each of `orbits` is; empty if that was not asked for.
    pub chaos: Vec<ChaosMeasure>,
    /// The verdict on each of `orbits`, where these alone were asked for.
    pub verdicts: Vec<Judgement>,
    /// Orbits that were open, and how far they were followed for their verdicts alone.
    pub further: Option<Further>,
    /// Orbits were ended where their verdict was found.
    pub early: bool,
    /// The measurement of chaos was stopped.
    pub chaos_interrupted: bool,
}

/// Orbits without a verdict that were followed beyond the crossings that were asked for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Further {
    /// Their numbers.
    pub orbits: Vec<u32>,
    /// Crossings of those that were followed longest.
    pub crossings: usize,
}

impl PoincareSection {
    /// Every orbit was followed to its end.
    #[must_use]
    pub fn complete(&self) -> bool {
        let whole = self.orbits.len() == self.starts.len() && self.whole_orbits() == self.orbits.len();
        whole && !self.chaos_interrupted
    }

    /// Orbits that were not cut short by an interrupt.
    #[must_use]
    pub fn whole_orbits(&self) -> usize {
        self.orbits.iter().filter(|orbit| orbit.report.end != OrbitEnd::Interrupted).count()
    }
}

/// The components of E at a point that was classified.
///
/// # Errors
/// [`PoincareError::Forbidden`] names the lowest energy, [`PoincareError::OnCurve`] the curve, and
/// [`PoincareError::Undecided`] the curve, or l where the order of the curves is not certain;
/// others where l leaves the range of `f64`.
pub fn components_at(
    body: &Body,
    [h, l]: [&Number; 2],
    found: &Classification,
) -> Result<Vec<Component>, PoincareError> {
    let (h_text, l_text) = (h.text().to_owned(), l.text().to_owned());
    let margin = &found.margin;
    let curve = || margin.nearest.map_or_else(String::new, |curve| curve.to_string());
    match &found.answer {
        Answer::Regular(components) => Ok(components.clone()),
        Answer::Forbidden => {
            let lowest = critical(body, l)?.list.into_iter().next();
            Err(PoincareError::Forbidden {
                h: h_text,
                l: l_text,
                lowest: lowest.as_ref().map_or(f64::NAN, |point| point.h),
                branch: lowest.and_then(|point| point.curve).map_or_else(String::new, |curve| curve.to_string()),
            })
        }
        Answer::Critical(_) => Err(PoincareError::OnCurve { h: h_text, l: l_text, curve: curve() }),
        Answer::Undecided(_) if margin.h > margin.error_bound => {
            Err(PoincareError::Undecided { near: Near::Order { l: l_text } })
        }
        Answer::Undecided(_) => {
            let (curve, distance, error_bound) = (curve(), margin.h, margin.error_bound);
            Err(PoincareError::Undecided { near: Near::Curve { h: h_text, l: l_text, curve, distance, error_bound } })
        }
    }
}

impl SectionSetting {
    /// Looks whether there is a section.
    ///
    /// # Errors
    /// [`PoincareError::WeightlessBody`] for r = 0; [`PoincareError::Forbidden`] names the lowest energy;
    /// [`PoincareError::OnCurve`] names the curve, and [`PoincareError::Undecided`] the curve, or l where the order of the
    /// curves is not certain; others when the body or l leave the
    /// range of `f64`.
    pub fn new(body: &Body, h: &Number, l: &Number) -> Result<Self, PoincareError> {
        if body.flags().euler {
            return Err(PoincareError::WeightlessBody);
        }
        let found = classify(body, h, l)?;
        let components = components_at(body, [h, l], &found)?;
        let torus = PpTorus::new(&HeavyTop::new(body))?;
        let region = AccessibleRegion::new(body, h.to_f64(), l.to_f64())?;
        let (margin, energy, momentum) = (found.margin, h.clone(), l.clone());
        Ok(Self { body: body.clone(), torus, components, margin, region, energy, momentum })
    }

    /// The body.
    #[must_use]
    pub fn body(&self) -> &Body {
        &self.body
    }

    /// The distance in h to the nearest curve.
    #[must_use]
    pub fn margin(&self) -> &Margin {
        &self.margin
    }

    /// The PP-torus.
    #[must_use]
    pub fn torus(&self) -> &PpTorus {
        &self.torus
    }

    /// Energy.
    #[must_use]
    pub fn h(&self) -> f64 {
        self.energy.to_f64()
    }

    /// Vertical angular momentum.
    #[must_use]
    pub fn l(&self) -> f64 {
        self.momentum.to_f64()
    }

    /// h and l, exactly.
    #[must_use]
    pub fn point(&self) -> [&Number; 2] {
        [&self.energy, &self.momentum]
    }

    /// The state over a point of the torus.
    ///
    /// # Errors
    /// As [`PpTorus::state`].
    pub fn state(&self, point: TorusPoint) -> Result<State, SectionError> {
        self.torus.state(point, self.h(), self.l())
    }

    /// Follows an orbit from each point. `monitor` counts and can stop; the section is then not complete.
    ///
    /// # Errors
    /// [`PoincareError::Section`] for inaccessible points and options out of range.
    pub fn run(
        &self,
        starts: &[TorusPoint],
        seed: Option<u64>,
        options: &SweepOptions,
        monitor: &Monitor,
    ) -> Result<PoincareSection, PoincareError> {
        let mut section = self.begin(starts, seed, options)?;
        let mut states = Vec::with_capacity(starts.len());
        for start in starts {
            states.push(self.state(*start)?);
        }
        section.orbits = sweep(&self.torus, &states, options, monitor)?;
        Ok(section)
    }

    /// A section before any orbit was started.
    ///
    /// # Errors
    /// [`PoincareError::Section`] for inaccessible points.
    pub fn begin(
        &self,
        starts: &[TorusPoint],
        seed: Option<u64>,
        options: &SweepOptions,
    ) -> Result<PoincareSection, PoincareError> {
        let mut gammas = Vec::with_capacity(starts.len());
        for start in starts {
            gammas.push(self.state(*start)?.gamma);
        }
        Ok(PoincareSection {
            body: self.body.clone(),
            h: self.energy.clone(),
            l: self.momentum.clone(),
            components: self.components.clone(),
            starts: starts.to_vec(),
            seed,
            options: *options,
            orbits: Vec::new(),
            component_of_start: self.components_at(&gammas),
            chaos: Vec::new(),
            verdicts: Vec::new(),
            further: None,
            early: false,
            chaos_interrupted: false,
        })
    }

    /// Adds Lyapunov exponents, rotation numbers and verdicts. The orbits are integrated once more; where `monitor` stops that,
    /// they have no exponent and the section is not complete.
    ///
    /// Orbits that stay open are followed again for their verdicts alone, over twice as many crossings, four times, …,
    /// as long as these are at most twice as many in total as those of the section.
    ///
    /// # Errors
    /// Those of [`chaos_measures`] and [`verdicts`].
    pub fn measure(
        &self,
        section: &mut PoincareSection,
        options: &ChaosOptions,
        monitor: &Monitor,
    ) -> Result<(), SectionError> {
        section.chaos = chaos_measures(&self.torus, &section.orbits, options, monitor)?;
        self.follow_open(section, options, monitor)?;
        section.chaos_interrupted = monitor.stop.load(Ordering::Relaxed);
        Ok(())
    }

    /// Looks for the verdicts of open orbits in more crossings.
    fn follow_open(
        &self,
        section: &mut PoincareSection,
        options: &ChaosOptions,
        monitor: &Monitor,
    ) -> Result<(), SectionError> {
        let mut left = 2 * section.options.crossings * section.orbits.len();
        let mut crossings = section.options.crossings;
        let goes_on = |orbit: &OrbitSection| orbit.report.end == OrbitEnd::Crossings;
        let mut open: Vec<usize> = (0..section.chaos.len()).filter(|&place| goes_on(&section.orbits[place])).collect();
        while !monitor.is_stopped() {
            open.retain(|&place| section.chaos[place].judgement.verdict.is_open());
            crossings *= 2;
            let Some(rest) = left.checked_sub(open.len() * crossings).filter(|_| !open.is_empty()) else { break };
            left = rest;
            let numbers: Vec<u32> = open.iter().map(|&place| section.orbits[place].orbit).collect();
            let mut states = Vec::with_capacity(open.len());
            for &number in &numbers {
                states.push(self.state(section.starts[number as usize])?);
            }
            let orbits = sweep(&self.torus, &states, &SweepOptions { crossings, ..section.options }, monitor)?;
            let found = verdicts(&self.torus, &orbits, options, monitor)?;
            if monitor.is_stopped() {
                break;
            }
            for (&place, judgement) in open.iter().zip(found) {
                section.chaos[place].judgement = judgement;
            }
            // The start is no crossing.
            let longest = orbits.iter().map(|orbit| orbit.points.len().saturating_sub(1)).max().unwrap_or(0);
            let further = section.further.get_or_insert(Further { orbits: numbers, crossings: longest });
            further.crossings = further.crossings.max(longest);
            let mut ends = orbits.iter();
            open.retain(|_| ends.next().is_some_and(goes_on));
        }
        Ok(())
    }

    /// Adds the verdicts alone.
    ///
    /// # Errors
    /// Those of [`verdicts`].
    pub fn judge(
        &self,
        section: &mut PoincareSection,
        options: &ChaosOptions,
        monitor: &Monitor,
    ) -> Result<(), SectionError> {
        section.verdicts = verdicts(&self.torus, &section.orbits, options, monitor)?;
        section.chaos_interrupted = monitor.stop.load(Ordering::Relaxed);
        Ok(())
    }

    /// The number of the component in which each accessible γ (in the body's axes) lies; None where that could not be
    /// proved.
    #[must_use]
    pub fn components_at(&self, gammas: &[[f64; 3]]) -> Vec<Option<usize>> {
        if self.component_count() == 1 {
            return vec![Some(0); gammas.len()];
        }
        match self.region.partition() {
            Ok(Some(partition)) => gammas.iter().map(|gamma| component_of(&partition, *gamma)).collect(),
            _ => vec![None; gammas.len()],
        }
    }

    /// How many components U_hl has.
    fn component_count(&self) -> usize {
        self.components.len()
    }
}

/// Crossings after which a verdict is looked for; then after twice as many, and so on.
const FIRST_LOOK: usize = 128;

impl SectionSetting {
    /// As [`run`](Self::run) and [`measure`](Self::measure), but an orbit ends where its verdict is found: after 128
    /// crossings, or 256, 512, …, or as many as the options allow. Orbits that continue are restarted, so this takes at
    /// most twice the time of the orbits that it returns.
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
                if orbit.report.end == OrbitEnd::Crossings && !last {
                    if open {
                        undecided.push(number);
                        continue;
                    }
                    orbit.report.end = OrbitEnd::Decided;
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
