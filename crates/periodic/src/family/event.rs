//! Special orbits between two members.

use bifdiag_schema::OrbitEventKind;

use super::member::{Member, Setting};

/// Closer than this to the trace of a special orbit, a change of sign is rounding: in integrable tops whole families
/// have the trace 2.
const FLAT: f64 = 1e-7;
/// Steps of the search. It stops when the place no longer moves, or when moves below `ROUNDING` no longer halve: these
/// are rounding.
const STEPS: u32 = 60;
const ROUNDING: f64 = 1e-8;

/// A special orbit that has been located.
pub(super) struct Located {
    pub kind: OrbitEventKind,
    pub member: Member,
    /// The last move of the free parameter.
    pub error: f64,
    /// Its place between the two members, from 0 to 1.
    pub place: f64,
}

/// If the trace is closer than this to 2 at both members, it is taken to touch 2 between them.
const TOUCHES: f64 = 0.1;

/// Where two families cross, the place is known only to the square root of the defect, since orbits of both families
/// close there.
const CROSSING: f64 = 4e-7;

/// A function that vanishes at a special orbit.
type Test = fn(&Setting<'_>, &Member) -> f64;

/// Vanishes where the free parameter turns back.
fn turning(setting: &Setting<'_>, member: &Member) -> f64 {
    member.rate(setting.space, setting.level)
}

/// Vanishes where two families meet.
fn unity(_: &Setting<'_>, member: &Member) -> f64 {
    member.trace - 2.0
}

/// Whether the test changes its sign from one member to the other.
fn changes(setting: &Setting<'_>, [from, to]: [&Member; 2], test: Test) -> bool {
    (test(setting, from) < 0.0) != (test(setting, to) < 0.0)
}

/// Whether the trace − 2 touches 0 between two members, if it does not change its sign.
fn touches(members: [&Member; 2]) -> bool {
    members.iter().all(|member| (member.trace - 2.0).abs() < TOUCHES)
}

/// Whether the free parameter does not turn back between two members, or the trace passes or touches 2 there.
pub(super) fn is_turn_explained(setting: &Setting<'_>, from: &Member, to: &Member) -> bool {
    let members = [from, to];
    !changes(setting, members, turning) || changes(setting, members, unity) || touches(members)
}

/// The special orbits between a member and the one at `distance` from it, in order.
pub(super) fn events(setting: &Setting<'_>, from: &Member, to: &Member, distance: f64) -> Vec<Located> {
    let minus_one: Test = |_, member| member.trace + 2.0;
    let third: Test = |_, member| member.trace + 1.0;
    let changes = |test: Test| changes(setting, [from, to], test);
    let is_clear = |test: Test| test(setting, from).abs() > FLAT && test(setting, to).abs() > FLAT;
    let crosses = |test: Test| is_clear(test) && changes(test);
    let mut found = Vec::new();
    let mut look = |test: Test, kind| found.push(locate(setting, (from, to), distance, test, kind));
    match (changes(turning), crosses(unity)) {
        (true, true) => look(turning, OrbitEventKind::Fold),
        // It turns where a family of more symmetric orbits crosses.
        (true, false) if is_clear(unity) && touches([from, to]) => look(turning, OrbitEventKind::Branch),
        (false, true) => look(unity, OrbitEventKind::Branch),
        _ => {}
    }
    for (test, kind) in [(minus_one, OrbitEventKind::Doubling), (third, OrbitEventKind::Tripling)] {
        if crosses(test) {
            look(test, kind);
        }
    }
    found.sort_by(|p, q| p.place.total_cmp(&q.place));
    found
}

/// By regula falsi with halved weights (Illinois).
fn locate(
    setting: &Setting<'_>,
    (from, to): (&Member, &Member),
    distance: f64,
    test: Test,
    kind: OrbitEventKind,
) -> Located {
    let parameter = |member: &Member| member.parameter(setting.space, setting.level);
    let mut ends = [0.0, 1.0];
    let mut values = [test(setting, from), test(setting, to)];
    let mut best: Option<Located> = None;
    let mut moved_before = f64::INFINITY;
    for _ in 0..STEPS {
        let place = (ends[0] - values[0] * (ends[1] - ends[0]) / (values[1] - values[0])).clamp(ends[0], ends[1]);
        // From the nearest known orbit: next to a crossing of families only a good guess leads to the right one.
        let known = best.as_ref().map_or((from, 0.0), |last| (&last.member, last.place));
        let Ok(member) = setting.ahead(known.0, (place - known.1) * distance) else { break };
        let value = test(setting, &member);
        let moved = best.as_ref().map_or(f64::INFINITY, |last| (last.place - place).abs());
        let moved_by = |last: &Located| (parameter(&last.member) - parameter(&member)).abs();
        let mut error = best.as_ref().map_or((parameter(to) - parameter(from)).abs(), moved_by);
        if kind == OrbitEventKind::Branch {
            error = error.max(CROSSING);
        }
        best = Some(Located { kind, member, error, place });
        if moved <= 1e-12 || value == 0.0 || (moved <= ROUNDING && moved >= 0.5 * moved_before) {
            break;
        }
        moved_before = moved;
        let side = usize::from((value < 0.0) != (values[0] < 0.0));
        (ends[side], values[side]) = (place, value);
        values[1 - side] *= 0.5;
        if ends[1] - ends[0] <= 1e-13 {
            break;
        }
    }
    // Where the search finds no orbit, the event is placed at the member before it, with the whole step as its error.
    best.unwrap_or_else(|| Located {
        kind,
        error: (parameter(to) - parameter(from)).abs(),
        member: from.clone(),
        place: 0.0,
    })
}
