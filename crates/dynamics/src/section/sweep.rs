//! Many orbits, each followed to its next crossings.

use std::sync::atomic::Ordering;

use pulp::{Arch, Simd, WithSimd};

use super::error::{SectionError, check_count};
use super::follow::{News, OrbitFollower};
use super::orbit::{OrbitEnd, OrbitSection, SweepOptions};
use super::readings::Gauge;
use super::scan::Scan;
use super::torus::PpTorus;
use super::workers::{Monitor, Turns, run_workers};
use super::workers::{OrbitCheckpoint, OrbitTask};
use crate::field::State;
use crate::integrator::check_tolerance;
use crate::integrator::taylor::Lanes;

/// Steps between two updates of the monitor.
const STEPS_BETWEEN_NEWS: u32 = 256;

/// Follows every start to its crossings; orbit k is `starts[k]`. A start on the section, within rounding, is the
/// orbit's point of index 0.
///
/// The result does not depend on the number of threads, nor on the instructions. With the feature `parallel`
/// the orbits are shared among the threads of the current rayon pool.
///
/// # Errors
/// [`SectionError::Parameter`] and [`SectionError::Tolerance`] for options out of range, [`SectionError::InstructionSet`] if this processor
/// lacks it.
pub fn sweep(
    torus: &PpTorus,
    starts: &[State],
    options: &SweepOptions,
    monitor: &Monitor,
) -> Result<Vec<OrbitSection>, SectionError> {
    check_count(starts.len())?;
    let tasks: Vec<OrbitTask> =
        starts.iter().zip(0_u32..).map(|(&start, orbit)| OrbitTask { orbit, start, halt: None }).collect();
    Ok(sweep_on(torus, &tasks, options, usize::MAX, monitor)?.into_iter().map(|(orbit, _)| orbit).collect())
}

/// Follows orbits from their starts or from where they were halted, and halts them when they have `most` points, or a
/// few more, or when the run is stopped. The points of a continued orbit follow its earlier ones.
///
/// Orbits come back in the order of their numbers, each with the state from which it continues; None if it has ended.
///
/// # Errors
/// Those of [`sweep`].
pub fn sweep_on(
    torus: &PpTorus,
    tasks: &[OrbitTask],
    options: &SweepOptions,
    most: usize,
    monitor: &Monitor,
) -> Result<Vec<(OrbitSection, Option<OrbitCheckpoint>)>, SectionError> {
    check_tolerance(options.tolerance)?;
    if options.max_time.is_nan() || options.max_time <= 0.0 {
        return Err(SectionError::Parameter {
            name: "max_time",
            value: options.max_time,
            expected: "a positive time is needed",
        });
    }
    let arch = options.instructions.arch().ok_or(SectionError::InstructionSet(options.instructions))?;
    let units = torus.top().units();
    if units.are_one() {
        return Ok(followed(arch, torus, tasks, options, most, monitor));
    }
    let tasks: Vec<OrbitTask> =
        tasks.iter().map(|task| OrbitTask { start: task.start.reduced(units), ..*task }).collect();
    let orbits = followed(arch, &torus.reduced(), &tasks, &options.reduced(units), most, monitor);
    Ok(orbits.into_iter().map(|(orbit, halt)| (orbit.restored(units, options.condition), halt)).collect())
}

/// An orbit's points, and the state from which it continues.
type Leg = (OrbitSection, Option<OrbitCheckpoint>);

/// The orbits of a top in its own units.
fn followed(
    arch: Arch,
    torus: &PpTorus,
    tasks: &[OrbitTask],
    options: &SweepOptions,
    most: usize,
    monitor: &Monitor,
) -> Vec<Leg> {
    let queue = Queue { torus, tasks, options, most, turns: Turns::new(monitor) };
    let mut orbits = run_workers(|| arch.dispatch(SweepWorker { queue: &queue }));
    orbits.sort_by_key(|(orbit, _)| orbit.orbit);
    orbits
}

/// The orbits still to be done, shared by the workers.
struct Queue<'a> {
    torus: &'a PpTorus,
    tasks: &'a [OrbitTask],
    options: &'a SweepOptions,
    /// Points after which an orbit is halted.
    most: usize,
    turns: Turns<'a>,
}

impl Queue<'_> {
    /// The next orbit.
    fn pop(&self) -> Option<(OrbitFollower, Option<OrbitCheckpoint>)> {
        let (_, task) = self.turns.next(self.tasks)?;
        let mut follower = OrbitFollower::new(self.torus, self.options, self.most, task.orbit, &task.start);
        if let Some(halt) = &task.halt {
            follower.resume(halt);
        }
        Some((follower, task.halt))
    }

    fn monitor(&self) -> &Monitor {
        self.turns.monitor
    }

    fn close(&self, mut follower: OrbitFollower, halt: Option<OrbitCheckpoint>, done: &mut Vec<Leg>) {
        self.report(&mut follower);
        if halt.is_none() {
            self.monitor().orbits.fetch_add(1, Ordering::Relaxed);
        }
        done.push((follower.finish(), halt));
    }

    fn report(&self, follower: &mut OrbitFollower) {
        self.monitor().crossings.fetch_add(follower.unreported(), Ordering::Relaxed);
    }
}

/// One worker: fills its lanes from the queue until it is empty.
struct SweepWorker<'a> {
    queue: &'a Queue<'a>,
}

impl WithSimd for SweepWorker<'_> {
    type Output = Vec<Leg>;

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> Self::Output {
        let queue = self.queue;
        let mut done = Vec::new();
        let mut lanes = Lanes::<S>::new(simd, queue.torus.top(), queue.options.tolerance);
        let mut scan = Scan::<S>::new(simd);
        let gauge = Gauge::<S>::new(simd, queue.torus, queue.options.condition);
        let mut followers: Vec<Option<OrbitFollower>> = Vec::new();
        for lane in 0..S::F64_LANES {
            followers.push(load(&mut lanes, &mut scan, lane, queue.pop(), 0));
        }
        let mut step = 0_u64;
        while followers.iter().any(Option::is_some) {
            step += 1;
            if step.is_multiple_of(STEPS_BETWEEN_NEWS.into()) {
                followers.iter_mut().flatten().for_each(|follower| queue.report(follower));
            }
            lanes.expand(simd);
            scan.read(simd, &lanes, queue.options.condition);
            let news = scan.lanes_with_news(simd);
            if news != 0 {
                let read = News::read(simd, &lanes, &scan);
                for lane in bits(news) {
                    if let Some(follower) = &mut followers[lane] {
                        follower.count(step);
                        follower.look(simd, queue.options, &read, lane);
                    }
                }
            }
            lanes.commit(simd);
            scan.commit();
            let stopped = queue.monitor().is_stopped();
            let all = stopped || lanes.any_is_at(queue.options.max_time);
            for lane in bits(if all { u32::MAX >> (32 - S::F64_LANES) } else { news }) {
                let ends = |follower: &mut OrbitFollower| {
                    follower.count(step);
                    follower.arrive(lanes.time(lane).seconds());
                    follower.is_over(queue.options) || follower.has(queue.most) || stopped
                };
                if let Some(mut follower) = followers[lane].take_if(ends) {
                    follower.settle(simd, &gauge, queue.torus, queue.options.condition);
                    let goes_on = follower.end.is_none();
                    let halt = goes_on.then(|| follower.halt(lanes.saved(lane), scan.start_of(lane)));
                    follower.end.get_or_insert(OrbitEnd::Interrupted);
                    queue.close(follower, halt, &mut done);
                    followers[lane] = load(&mut lanes, &mut scan, lane, queue.pop(), step);
                }
            }
        }
        done
    }
}

/// The places of the ones, the lowest first.
#[inline(always)]
fn bits(mut word: u32) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        let place = (word != 0).then_some(word.trailing_zeros() as usize);
        word &= word.wrapping_sub(1);
        place
    })
}

/// Puts an orbit into a lane, after `step` steps. An idle lane keeps its contents, which are never read.
#[inline(always)]
fn load<S: Simd>(
    lanes: &mut Lanes<S>,
    scan: &mut Scan<S>,
    lane: usize,
    task: Option<(OrbitFollower, Option<OrbitCheckpoint>)>,
    step: u64,
) -> Option<OrbitFollower> {
    let (mut follower, halt) = task?;
    follower.enter(step);
    lanes.load(lane, &follower.start, follower.momentum_scale);
    if let Some(halt) = halt {
        lanes.restore(lane, &halt.lane());
    }
    scan.load(lane, follower.start_value, follower.flat);
    Some(follower)
}
