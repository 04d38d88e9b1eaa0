//! What a map shows, and where on the page.

use bifdiag_page::{Caption, Point, Rect, clip_polyline};

/// One of the two parameters.
#[derive(Clone, Debug, PartialEq)]
pub struct MapAxis {
    /// The text at the axis.
    pub name: String,
    /// From, to.
    pub range: [f64; 2],
}

/// Something that bodies show.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MapEntry {
    /// Its name in the legend.
    pub name: String,
    /// Its description there, in smaller letters.
    pub note: String,
    /// The text in the map where there is room; empty for a group of things.
    pub mark: String,
    /// Its full name, for tooltips; may be empty.
    pub key: String,
    /// Which of the colours it has where entries have no order; `None`: that of all the rest.
    pub color: Option<usize>,
}

/// Where bodies lie; each shows the entry with its number, or nothing that is known.
#[derive(Clone, Debug, PartialEq)]
pub enum MapBodies {
    /// A full grid with this many columns, row by row from below; each body is in the middle of its cell.
    Grid {
        /// Number of columns.
        columns: usize,
        /// Entries, row by row.
        entries: Vec<Option<usize>>,
    },
    /// Areas with their borders.
    Areas {
        /// What each area shows, and its corners.
        pieces: Vec<(Option<usize>, Vec<[f64; 2]>)>,
        /// Bodies, and the entries that they show.
        seen: Vec<(usize, [f64; 2])>,
        /// The borders between areas, as straight parts.
        borders: Vec<[[f64; 2]; 2]>,
        /// What the legend says of the borders.
        legend: String,
    },
    /// Points anywhere.
    Points(Vec<([f64; 2], Option<usize>)>),
}

/// A line that is drawn over the map.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MapLine {
    /// Its points.
    pub points: Vec<[f64; 2]>,
    /// Dashed lines are borders of another kind.
    pub dashed: bool,
    /// Which colour it has: 0 is that of text.
    pub hue: usize,
    /// What the legend says; lines with the same text share an entry.
    pub text: String,
    /// The text beside it in the map; may be empty.
    pub name: String,
}

/// A text at a place of the map.
#[derive(Clone, Debug, PartialEq)]
pub struct MapNote {
    /// Where.
    pub at: [f64; 2],
    /// What.
    pub text: String,
    /// Which colour it has, as that of a line.
    pub hue: usize,
    /// Whether the place itself is marked by a ring; then the text is beside it, else on it.
    pub ring: bool,
}

impl MapBodies {
    /// Which of this many entries are visible, and whether unknown bodies are: not what covers too few pixels.
    pub(super) fn seen(&self, entries: usize, view: &MapView) -> (Vec<bool>, bool) {
        let pieces = match self {
            Self::Grid { entries: shown, .. } => return (vec![true; entries], shown.iter().any(Option::is_none)),
            Self::Points(points) => return (vec![true; entries], points.iter().any(|(_, entry)| entry.is_none())),
            Self::Areas { pieces, .. } => pieces,
        };
        let (mut areas, mut unknown) = (vec![0.0; entries], 0.0);
        for (entry, corners) in pieces {
            *entry.and_then(|entry| areas.get_mut(entry)).unwrap_or(&mut unknown) += area(corners, view);
        }
        (areas.into_iter().map(|area| area >= SEEN).collect(), unknown >= SEEN)
    }

    /// Gives every entry another number.
    pub fn renumber(&mut self, number: impl Fn(usize) -> usize) {
        let entries: Box<dyn Iterator<Item = &mut Option<usize>> + '_> = match self {
            Self::Grid { entries, .. } => Box::new(entries.iter_mut()),
            Self::Areas { pieces, seen, .. } => {
                for (entry, _) in &mut *seen {
                    *entry = number(*entry);
                }
                Box::new(pieces.iter_mut().map(|(entry, _)| entry))
            }
            Self::Points(points) => Box::new(points.iter_mut().map(|(_, entry)| entry)),
        };
        for entry in entries.flatten() {
            *entry = number(*entry);
        }
    }
}

/// Everything that a map shows.
#[derive(Clone, Debug, PartialEq)]
pub struct Map {
    /// Above it.
    pub title: String,
    /// Below the title, smaller.
    pub subtitle: String,
    /// To the right.
    pub x: MapAxis,
    /// Upwards.
    pub y: MapAxis,
    /// What bodies show, in the order of the legend.
    pub entries: Vec<MapEntry>,
    /// Whether the entries are values of a quantity, by rising value: their colours grow darker then.
    pub ordered: bool,
    /// The legend's text for unknown bodies.
    pub unknown: String,
    /// The bodies.
    pub bodies: MapBodies,
    /// Where no body exists.
    pub impossible: Vec<Vec<[f64; 2]>>,
    /// Lines.
    pub lines: Vec<MapLine>,
    /// Texts.
    pub notes: Vec<MapNote>,
    /// A table of everything that the entries represent, its heading first; may be empty.
    pub key: Vec<Vec<String>>,
}

impl Map {
    /// The caption of the map: its titles, and the table of everything that its entries represent.
    #[must_use]
    pub fn caption(&self) -> Caption {
        let mut caption = Caption::default();
        caption.paragraph(&format!("{}: {}.", self.title, self.subtitle));
        if let [heading, rows @ ..] = &self.key[..] {
            caption.table(heading, rows);
        }
        caption
    }
}

/// Pixels that an area needs so that a mark points at it.
pub(super) const SEEN: f64 = 12.0;

/// Font sizes of texts and of notes.
pub(super) const SIZE: f64 = 11.5;
pub(super) const SMALL: f64 = 11.0;

/// The ranges of a map and its place on the page.
pub(super) struct MapView {
    pub x: [f64; 2],
    pub y: [f64; 2],
    pub rect: Rect,
}

impl MapView {
    /// A point of the map on the page.
    pub(super) fn at(&self, [x, y]: [f64; 2]) -> Point {
        let share = |value: f64, [from, to]: [f64; 2]| (value - from) / (to - from);
        let rect = &self.rect;
        [rect.x + share(x, self.x) * rect.width, rect.y + rect.height * (1.0 - share(y, self.y))]
    }

    /// The parts of a line inside the map, on the page.
    pub(super) fn parts(&self, line: &MapLine) -> Vec<Vec<Point>> {
        let points: Vec<Point> = line.points.iter().map(|point| self.at(*point)).collect();
        clip_polyline(&points, &self.rect)
    }
}

/// The area of a polygon on the page.
pub(super) fn area(corners: &[[f64; 2]], view: &MapView) -> f64 {
    let corners: Vec<Point> = corners.iter().map(|corner| view.at(*corner)).collect();
    let next = corners.iter().cycle().skip(1);
    0.5 * corners.iter().zip(next).map(|(p, q)| p[0] * q[1] - p[1] * q[0]).sum::<f64>().abs()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_reach_the_frame_and_end_there() {
        let rect = Rect { x: 0.0, y: 0.0, width: 4.0, height: 2.0 };
        let view = MapView { x: [0.0, 4.0], y: [0.0, 2.0], rect };
        let parts = |points: &[[f64; 2]]| view.parts(&MapLine { points: points.to_vec(), ..MapLine::default() });
        assert_eq!(parts(&[[0.0, 1.0], [1.0, 3.0]]), [[[0.0, 1.0], [0.5, 0.0]]]);
        assert_eq!(parts(&[[0.0, 4.0], [4.0, -4.0]]), [[[1.0, 0.0], [2.0, 2.0]]]);
        let over = parts(&[[0.0, 1.0], [1.0, 3.0], [2.0, 1.0]]);
        assert_eq!(over, [[[0.0, 1.0], [0.5, 0.0]], [[1.5, 0.0], [2.0, 1.0]]]);
        assert_eq!(parts(&[[0.0, 1e9], [1.0, 1e8]]), Vec::<Vec<Point>>::new());
    }
}
