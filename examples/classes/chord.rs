//! What lies on a line: stretches of one class, and the walls between them.

use bifdiag_body::Body;
use bifdiag_diagram::class::Class;

use bifdiag_exact::Accuracy;
use bifdiag_survey::border::{self, BodySegment, BorderEventKind, BorderOptions, class_of};
use bifdiag_survey::space::{BodyLine, ReducedBody};

/// A place where the class changes.
#[derive(Clone, Debug, PartialEq)]
pub struct Wall {
    /// Where on the line.
    pub s: f64,
    /// Estimate of the error of `s`.
    pub error: f64,
    /// The classes before and behind it, in the direction away from the start of the line.
    pub classes: [Class; 2],
    /// What happens there.
    pub event: BorderEventKind,
    /// The body there.
    pub place: ReducedBody,
}

/// A part of a line on which the class seems to be the same.
#[derive(Clone, Debug, PartialEq)]
pub struct Stretch {
    /// From, to; by size.
    pub s: [f64; 2],
    /// The class.
    pub class: Class,
}

/// One side of a line.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Chord {
    /// The stretches, the first one that of the start of the line.
    pub stretches: Vec<Stretch>,
    /// The walls between them.
    pub walls: Vec<Wall>,
    /// Places where the class changes and no wall could be pinned down.
    pub lost: u32,
}

/// Walls between two nodes, at most.
const WALLS: usize = 8;

/// Looks at the bodies at these values of s, from the start of the line outwards, and finds the walls between those of
/// different classes. Bodies that f64 does not decide are passed over, but for the start. With `first` it ends at the first
/// wall.
#[must_use]
pub fn chord(line: &BodyLine, nodes: &[f64], first: bool) -> Chord {
    let mut found = Chord::default();
    let by_f64 = class_at(line, 0.0);
    let accuracy = if by_f64.is_some() { Accuracy::Fast } else { Accuracy::Exact };
    let Some(class) = by_f64.or_else(|| class_by(line, 0.0, accuracy)) else { return found };
    found.stretches.push(Stretch { s: [0.0, 0.0], class: class.clone() });
    let (mut last, mut class) = (0.0, class);
    for &s in nodes {
        let Some(here) = class_at(line, s) else { continue };
        if here != class {
            found.cross(line, [last, s], &here, if last == 0.0 { accuracy } else { Accuracy::Fast });
            if first {
                return found;
            }
        }
        (last, class) = (s, here);
    }
    if let Some(stretch) = found.stretches.last_mut() {
        stretch.s[1] = last;
    }
    found
}

impl Chord {
    /// The walls between two bodies of different classes, which are decided at this accuracy.
    fn cross(&mut self, line: &BodyLine, [mut from, to]: [f64; 2], class: &Class, accuracy: Accuracy) {
        let options = BorderOptions { tolerance: 1e-9, accuracy, ..BorderOptions::default() };
        for _ in 0..WALLS {
            let (Some(start), Some(end)) = (body_at(line, from), body_at(line, to)) else { break };
            let Ok(border) = border::find(&BodySegment::new(start, end), &options) else { break };
            let at = |t: f64| from + t * (to - from);
            let (s, behind) = (at(border.t), at(border.enclosure[1]));
            let error = border.error * (to - from).abs();
            let beyond = border.classes[1].clone();
            if let Some(stretch) = self.stretches.last_mut() {
                stretch.s[1] = at(border.enclosure[0]);
            }
            self.stretches.push(Stretch { s: [behind, to], class: beyond.clone() });
            let place = ReducedBody::of(line.at(s));
            self.walls.push(Wall { s, error, classes: border.classes, event: border.event.kind, place });
            if beyond == *class {
                return;
            }
            from = behind;
        }
        self.lost += 1;
        self.stretches.push(Stretch { s: [to, to], class: class.clone() });
    }
}

/// The body at s.
fn body_at(line: &BodyLine, s: f64) -> Option<Body> {
    let [a, r] = line.at(s);
    Body::from_f64(a, r).ok()
}

/// The class at s, as far as f64 decides it.
pub fn class_at(line: &BodyLine, s: f64) -> Option<Class> {
    class_by(line, s, Accuracy::Fast)
}

fn class_by(line: &BodyLine, s: f64, accuracy: Accuracy) -> Option<Class> {
    class_of(&body_at(line, s)?, accuracy).ok().map(|(_, class)| class)
}
