//! The search itself: sampling, improvement of the best bodies, confirmation.

use std::ops::ControlFlow;

use super::exclusion::Exclusion;
use super::improve::improve;
use super::score::{Score, ScoredPoint, look, sample};
use super::target::Target;
use super::witness::{KnownPoint, Witness, WitnessError, known_witness};
use super::{NearestBody, SearchAnswer, SearchOptions, SearchResult};
use crate::parallel::each;

/// Bodies between two checks of the results.
const BLOCK: u64 = 2048;

/// Candidates that are improved.
const CANDIDATES: usize = 6;

/// Steps of each improvement.
const STEPS: u64 = 150;

/// A body and what was seen of it.
type ScoredBody = ([[f64; 3]; 2], ScoredPoint);

/// Finds a body and a point that show what is sought: a theorem that excludes it is the answer, a known point that shows it is
/// taken (after confirmation), else bodies are [searched](search).
pub fn find(
    target: &Target,
    known: &[KnownPoint],
    options: &SearchOptions,
    watch: &mut dyn FnMut(u64) -> ControlFlow<()>,
) -> SearchResult {
    if let Some(theorem) = Exclusion::of(target) {
        return SearchResult::at_once(SearchAnswer::Excluded(theorem));
    }
    match known_witness(known, target, &options.domain, options.accuracy) {
        Some(witness) => SearchResult::at_once(SearchAnswer::Found(Box::new(witness))),
        None => search(target, options, watch),
    }
}

/// Samples bodies, improves the best of them and confirms the winner, as soon as one shows it; the same for any number of
/// threads. `watch` gets the number of bodies drawn since, and may stop the search.
pub fn search(target: &Target, options: &SearchOptions, watch: &mut dyn FnMut(u64) -> ControlFlow<()>) -> SearchResult {
    let mut best: Vec<ScoredBody> = Vec::new();
    let (mut drawn, mut tried, mut showing) = (0, 0, 0);
    let mut refused = Vec::new();
    let mut nearest = None;
    while drawn < options.samples {
        let to = options.samples.min(drawn + BLOCK);
        let numbers: Vec<u64> = (drawn..to).collect();
        let found = each(&numbers, |n| seen(sample(*n, options.seed, options.domain.physical), target, options));
        let found: Vec<ScoredBody> = found.into_iter().flatten().collect();
        tried += found.len() as u64;
        let shown = found.iter().filter(|(_, seen)| matches!(seen.score, Score::Shown(_))).count() as u64;
        showing += shown;
        best.extend(found.into_iter().filter(|(_, seen)| seen.score != Score::Nothing));
        sort(&mut best);
        best.truncate(CANDIDATES);
        let more = to - drawn;
        drawn = to;
        if watch(more).is_break() {
            return SearchResult { answer: SearchAnswer::Stopped, drawn, tried, showing, refused };
        }
        if drawn < options.samples && (shown == 0 || options.all) {
            continue;
        }
        match confirmed(&best, target, options, &mut refused) {
            Ok(witness) => {
                let answer = SearchAnswer::Found(Box::new(witness));
                return SearchResult { answer, drawn, tried, showing, refused };
            }
            Err(best) => nearest = best,
        }
    }
    SearchResult { answer: SearchAnswer::NotFound { nearest }, drawn, tried, showing, refused }
}

/// The best of some bodies, improved and confirmed; else the one that came nearest.
fn confirmed(
    best: &[ScoredBody],
    target: &Target,
    options: &SearchOptions,
    refused: &mut Vec<([[f64; 3]; 2], WitnessError)>,
) -> Result<Witness, Option<NearestBody>> {
    let better = each(best, |(values, _)| seen(improve(*values, target, &options.domain, STEPS), target, options));
    let mut improved: Vec<ScoredBody> = better.into_iter().flatten().chain(best.iter().copied()).collect();
    sort(&mut improved);
    let witness = improved.iter().find_map(|(values, _)| {
        Witness::of_body(*values, target, options.accuracy).map_err(|error| refused.push((*values, error))).ok()
    });
    witness.ok_or_else(|| improved.first().map(nearest))
}

fn seen(values: [[f64; 3]; 2], target: &Target, options: &SearchOptions) -> Option<ScoredBody> {
    look(values, target, &options.domain).map(|seen| (values, seen))
}

/// The best first. A stable sort: of equal ones the first stays first.
fn sort(candidates: &mut [ScoredBody]) {
    candidates.sort_by(|p, q| q.1.score.compare(p.1.score));
}

fn nearest((values, seen): &ScoredBody) -> NearestBody {
    let missing = match seen.score {
        Score::Near(missing) => missing,
        Score::Shown(_) | Score::Nothing => 0.0,
    };
    NearestBody { values: *values, at: seen.at, missing }
}

#[cfg(test)]
mod tests {
    use super::super::score::SearchDomain;
    use super::*;

    fn go_on(_: u64) -> ControlFlow<()> {
        ControlFlow::Continue(())
    }

    fn physical() -> SearchOptions {
        SearchOptions { domain: SearchDomain { physical: true, ..SearchDomain::default() }, ..SearchOptions::default() }
    }

    #[test]
    fn a_found_witness_shows_what_was_sought() {
        let target = Target::of_type("k2n1").unwrap();
        let found = search(&target, &SearchOptions { samples: 64, ..physical() }, &mut go_on);
        let SearchAnswer::Found(witness) = &found.answer else { panic!("{found:?}") };
        assert!(target.accepts_region(&witness.components) && !witness.body.flags().unphysical);
        assert!(witness.margin.h > 1e-3 && found.drawn == 64 && found.showing > 0);
        // The same point, known before, is the answer at once, unless the domain is narrower than its body.
        let Witness { body, h, l, components, .. } = (**witness).clone();
        let known = [KnownPoint { body, h, l, components }];
        let again = find(&target, &known, &physical(), &mut go_on);
        assert_eq!(again, SearchResult::at_once(found.answer.clone()));
        let narrow =
            SearchOptions { domain: SearchDomain { moment_ratio: 1.0, physical: true }, samples: 8, ..physical() };
        assert_eq!(find(&target, &known, &narrow, &mut go_on).drawn, 8);
    }

    #[test]
    fn bodies_outside_of_the_domain_are_not_counted_as_looked_at() {
        let target = Target::of_type("k0n2").unwrap();
        let counted = |moment_ratio| {
            let domain = SearchDomain { physical: false, moment_ratio };
            let found = search(&target, &SearchOptions { domain, samples: 64, all: true, ..physical() }, &mut go_on);
            (found.drawn, found.tried)
        };
        assert_eq!(counted(1.0), (64, 0));
        let (drawn, tried) = counted(2.0);
        assert!(drawn == 64 && 0 < tried && tried < 64, "{tried}");
    }

    #[test]
    fn a_search_without_success_reports_the_nearest_body() {
        let target = Target::CriticalPoints(12);
        let found = search(&target, &SearchOptions { samples: 16, ..SearchOptions::default() }, &mut go_on);
        let SearchAnswer::NotFound { nearest: Some(nearest) } = found.answer else { panic!("{found:?}") };
        assert!(nearest.missing >= 2.0 && found.drawn == 16 && found.showing == 0);
    }

    #[test]
    fn what_a_theorem_excludes_is_not_searched_and_a_search_can_be_stopped() {
        let never = &mut |_| panic!("nothing is to be searched");
        let excluded = find(&Target::of_type("k3n0").unwrap(), &[], &SearchOptions::default(), never);
        assert_eq!(excluded, SearchResult::at_once(SearchAnswer::Excluded(Exclusion::ThreeCircles)));
        let options = SearchOptions { samples: 8, ..SearchOptions::default() };
        let stopped = search(&Target::of_type("k2n1").unwrap(), &options, &mut |_| ControlFlow::Break(()));
        assert_eq!((stopped.answer, stopped.drawn), (SearchAnswer::Stopped, 8));
    }
}
