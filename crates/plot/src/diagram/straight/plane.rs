//! The straightened plane on the page: where energies and momenta, curves, events and regions lie.

use super::super::scene::{Cell, Scene, coincidences};
use super::shares::Shares;
use super::strata::{Slab, SlabSlice};
use bifdiag_page::{Areas, Point, Rect, pixel};
use bifdiag_schema::{AtlasDocument, EventDocument};

/// Pixels below the lowest curve, where no motion is.
pub(super) const BELOW_ALL: f64 = 8.0;

/// A panel of the straightened plane.
pub(crate) struct Straight {
    pub(crate) rect: Rect,
    /// Pixels on the right of it.
    pub(super) right: f64,
    pub(super) slabs: Vec<Slab>,
    /// The shares by which it is placed.
    pub(super) shares: Shares,
    /// On the page, for each station of each slab: x, and y of the curves.
    pub(super) placed: Vec<Vec<(f64, Vec<f64>)>>,
    /// The set of coincident curves of each curve.
    set_of: Vec<usize>,
}

/// A place in a slab: its index, that of the station before, and how far from that to the next.
type SlabPosition = (usize, usize, f64);

impl Straight {
    /// The plane between these momenta, not placed yet.
    pub(super) fn new(atlas: &AtlasDocument, rect: Rect, right: f64, slabs: Vec<Slab>) -> Self {
        let mut set_of = vec![0; atlas.curves.len()];
        for (number, set) in coincidences(atlas).iter().enumerate() {
            for &curve in set {
                set_of[curve] = number;
            }
        }
        Self { rect, right, slabs, shares: Shares::default(), placed: Vec::new(), set_of }
    }

    /// A position of the page in the unit square, with y upwards.
    pub(crate) fn in_unit_square(&self, [x, y]: Point) -> Point {
        [(x - self.rect.x) / self.rect.width, (self.rect.bottom() - y) / self.rect.height]
    }

    /// Places everything again.
    pub(super) fn place(&mut self, shares: &Shares) {
        let Rect { x, width, height, .. } = self.rect;
        let ends = shares.ends(x, width);
        let bottom = self.rect.bottom() - BELOW_ALL;
        let of_slab = |(number, slab): (usize, &Slab)| {
            let of_station = |station: &SlabSlice| {
                let sizes = shares.heights(slab, station);
                let scale = (height - BELOW_ALL) / sizes.iter().sum::<f64>();
                let mut sum = 0.0;
                let y = sizes.iter().map(|size| {
                    let y = bottom - scale * sum;
                    sum += size;
                    y
                });
                (ends[number] + (ends[number + 1] - ends[number]) * station.share, y.collect())
            };
            slab.stations.iter().map(of_station).collect()
        };
        self.placed = self.slabs.iter().enumerate().map(of_slab).collect();
    }

    pub(crate) fn l_end(&self) -> Option<f64> {
        self.slabs.last().map(|slab| slab.l[1])
    }

    /// Where l lies; an event momentum at the end of the slab before it.
    pub(super) fn at(&self, l: f64) -> Option<SlabPosition> {
        let slab = self.slabs.iter().position(|slab| (slab.l[0]..=slab.l[1]).contains(&l))?;
        Some(self.within(slab, l))
    }

    /// Where a momentum of a slab lies.
    pub(super) fn within(&self, slab: usize, l: f64) -> SlabPosition {
        let stations = &self.slabs[slab].stations;
        let next = stations.partition_point(|station| station.l <= l).clamp(1, stations.len() - 1);
        let (from, to) = (stations[next - 1].l, stations[next].l);
        (slab, next - 1, if to > from { (l - from) / (to - from) } else { 0.0 })
    }

    pub(super) fn x(&self, (slab, station, share): SlabPosition) -> f64 {
        let (from, to) = (self.placed[slab][station].0, self.placed[slab][station + 1].0);
        from + (to - from) * share
    }

    /// The curves at a place, upwards.
    pub(super) fn heights(&self, (slab, station, share): SlabPosition) -> Vec<f64> {
        let (from, to) = (&self.placed[slab][station].1, &self.placed[slab][station + 1].1);
        from.iter().zip(to).map(|(from, to)| from + (to - from) * share).collect()
    }

    /// The places in the middle of columns of this many pixels.
    pub(super) fn columns(&self, step: f64) -> Vec<SlabPosition> {
        let mut columns = Vec::new();
        let mut x = self.rect.x + 0.5 * step;
        for (slab, placed) in self.placed.iter().enumerate() {
            for station in 0..placed.len() - 1 {
                let (from, to) = (placed[station].0, placed[station + 1].0);
                while x < to && x < self.rect.right() {
                    columns.push((slab, station, ((x - from) / (to - from)).clamp(0.0, 1.0)));
                    x += step;
                }
            }
        }
        columns
    }

    /// Where a curve lies among those of a slab.
    pub(super) fn layer(&self, slab: usize, curve: usize) -> Option<usize> {
        self.slabs[slab].layers.iter().position(|layer| self.set_of[layer.lower] == self.set_of[curve])
    }

    /// y of an energy where the curves have the energies `h` and lie at `y`: unbounded above the highest.
    pub(super) fn height(&self, energy: f64, h: &[f64], y: &[f64]) -> Option<f64> {
        let above = h.partition_point(|h| *h <= energy);
        let below = above.checked_sub(1)?;
        if above == h.len() {
            let share = (energy - h[below]) / (energy - h[below] + self.span(h));
            return Some(y[below] + (self.rect.y - y[below]) * share);
        }
        Some(y[below] + (y[above] - y[below]) * ((energy - h[below]) / (h[above] - h[below])))
    }

    /// The energy that lies at a share of the way from the highest curve to the upper edge.
    pub(super) fn energy_above(&self, share: f64, h: &[f64]) -> f64 {
        h[h.len() - 1] + self.span(h) * share / (1.0 - share)
    }

    /// So far above the highest curve is half of what is left: as much as the curves span.
    fn span(&self, h: &[f64]) -> f64 {
        (h[h.len() - 1] - h[0]) + self.energy_unit()
    }

    /// The shares that place everything.
    pub(crate) fn shares(&self) -> &Shares {
        &self.shares
    }

    /// An energy that is not large compared to those in view.
    pub(super) fn energy_unit(&self) -> f64 {
        let ends = self.slabs.first().zip(self.slabs.last());
        let span =
            ends.and_then(|(first, last)| Some(last.stations.last()?.h.last()? - first.stations.first()?.h.first()?));
        0.02 * span.unwrap_or(1.0)
    }

    /// Where [h, l] lies on the page; nowhere where there is no motion.
    pub(crate) fn position(&self, [h, l]: [f64; 2]) -> Option<Point> {
        let (slab, station, share) = self.at(l)?;
        let place = (slab, station, share);
        let stations = &self.slabs[slab].stations;
        let (from, to) = (&stations[station].h, &stations[station + 1].h);
        let energies: Vec<f64> = from.iter().zip(to).map(|(from, to)| from + (to - from) * share).collect();
        Some([self.x(place), self.height(h, &energies, &self.heights(place))?])
    }

    /// Where an event lies: on one of its curves.
    pub(crate) fn event(&self, scene: &Scene<'_>, event: &EventDocument) -> Option<Point> {
        let curves =
            || (0..scene.atlas.curves.len()).filter(|&curve| event.curves.contains(&scene.atlas.curves[curve].id));
        // At a cusp they are on one side only.
        let slabs =
            (0..self.slabs.len()).filter(|&slab| (self.slabs[slab].l[0]..=self.slabs[slab].l[1]).contains(&event.l));
        let found = slabs.flat_map(|slab| curves().filter_map(move |curve| Some((slab, self.layer(slab, curve)?))));
        let (slab, layer) = found.into_iter().next()?;
        let place = self.within(slab, event.l);
        Some([self.x(place), self.heights(place)[layer]])
    }

    /// A curve between two momenta.
    pub(crate) fn curve(&self, curve: usize, range: [f64; 2]) -> Vec<Point> {
        let mut points: Vec<Point> = self.course(curve, range).into_iter().map(|(_, point)| point).collect();
        points.dedup();
        points
    }

    /// Momenta between two of them, and where the curve lies there.
    pub(crate) fn course(&self, curve: usize, [from, to]: [f64; 2]) -> Vec<(f64, Point)> {
        let mut points = Vec::new();
        for (number, slab) in self.slabs.iter().enumerate() {
            let l = [from.max(slab.l[0]), to.min(slab.l[1])];
            let Some(layer) = self.layer(number, curve).filter(|_| l[0] < l[1]) else { continue };
            let inside = slab.stations.iter().zip(&self.placed[number]);
            let inside = inside.filter(|(station, _)| l[0] < station.l && station.l < l[1]);
            let end = |l: f64| {
                let place = self.within(number, l);
                (l, [self.x(place), self.heights(place)[layer]])
            };
            points.push(end(l[0]));
            points.extend(inside.map(|(station, (x, y))| (station.l, [*x, y[layer]])));
            points.push(end(l[1]));
        }
        points
    }

    /// The polygon of a region's cell.
    pub(crate) fn cell(&self, cell: &Cell) -> Vec<Point> {
        let Some(slab) = self.slabs.iter().position(|slab| slab.l[0] == cell.l[0]) else { return Vec::new() };
        let Some(layer) = self.slabs[slab].layers.iter().position(|layer| layer.lower == cell.lower) else {
            return Vec::new();
        };
        let placed = &self.placed[slab];
        let lower = placed.iter().map(|(x, y)| [*x, y[layer]]);
        let upper = placed.iter().rev().map(|(x, y)| [*x, y.get(layer + 1).copied().unwrap_or(self.rect.y)]);
        lower.chain(upper).collect()
    }

    /// The pixels of all regions.
    pub(crate) fn areas(&self) -> Areas {
        Areas::new(&self.rect, |[width, height], of| {
            for (x, place) in self.columns(1.0).into_iter().enumerate().take(width) {
                let y = self.heights(place);
                let row = |y: f64| pixel((y - self.rect.y - 0.5).ceil(), height);
                for (layer, own) in self.slabs[place.0].layers.iter().enumerate() {
                    let Ok(region) = i32::try_from(own.region) else { continue };
                    let top = y.get(layer + 1).map_or(0, |y| row(*y));
                    (top..row(y[layer])).for_each(|row| of[row * width + x] = region);
                }
            }
        })
    }
}
