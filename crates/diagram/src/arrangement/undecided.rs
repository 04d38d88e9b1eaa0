//! Where f64 left something undecided, and which curves are involved.

use super::{Arrangement, Undecided};
use bifdiag_equilibria::curves::CurveId;

impl Arrangement {
    /// x = l²/2 and h, in the frame's units, of a place where something is undecided.
    #[must_use]
    pub fn place_of(&self, undecided: &Undecided) -> [f64; 2] {
        match *undecided {
            Undecided::Contact { curves, x } => {
                // For an unbounded or nearly unbounded range, the end where h is finite.
                let at = match x {
                    [from, to] if to <= 4.0 * from => from.midpoint(to),
                    [from, _] if from > 0.0 => from,
                    [_, to] => to.min(1.0),
                };
                let point = self.set.curves[curves[0]].point(&self.set.frame, at);
                // Where x² is beyond f64, h = x/J to every digit.
                [at, if point.h().is_finite() { point.h() } else { at * point.slope() }]
            }
            Undecided::Cusps { cluster } => {
                let point = &self.set.clusters[cluster].point;
                [point.x, point.h()]
            }
            Undecided::Simultaneous { events: [event, _] } | Undecided::Order { event } => {
                let event = &self.events[event];
                [event.x, event.h]
            }
        }
    }

    /// The curves about which something is undecided.
    #[must_use]
    pub fn curves_of(&self, undecided: &Undecided) -> Vec<CurveId> {
        match undecided {
            Undecided::Contact { curves, .. } => curves.to_vec(),
            Undecided::Cusps { .. } => Vec::new(),
            Undecided::Simultaneous { events } => {
                let mut curves: Vec<CurveId> = events.iter().flat_map(|&e| self.events[e].change.curves()).collect();
                curves.sort_unstable();
                curves.dedup();
                curves
            }
            Undecided::Order { event } => self.events[*event].change.curves(),
        }
    }
}
