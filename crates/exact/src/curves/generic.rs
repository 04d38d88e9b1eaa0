//! The generic family, cut at cusps and pitchforks.

use super::curve::{Bound, Curve, Curves, Cusp, Pitchfork, Segment, Shape};
use super::place::{IsolationError, Place, charts, order, passive_place, roots_in_interval};
use crate::model::Model;
use bifdiag_equilibria::curves::{Branch, CurveId, End, IntervalId, Orbit};
use bifdiag_numbers::table::Id;

/// A place where a branch is cut or changes its half.
#[derive(Clone)]
enum Station {
    Cusp(Place),
    Pitchfork(Place, usize),
    Middle([Place; 2]),
}

/// What ends at a station and begins there.
struct Stop {
    bound: Bound,
    /// The end of the curve; `None` where only the half changes.
    end: Option<End>,
    /// Where the next segment begins.
    next: Option<Place>,
}

impl Stop {
    fn at(place: &Place, end: End) -> Self {
        Self { bound: Bound::At(place.clone()), end: Some(end), next: Some(place.clone()) }
    }
}

impl Station {
    fn place(&self) -> &Place {
        match self {
            Self::Cusp(place) | Self::Pitchfork(place, _) => place,
            Self::Middle(places) => &places[0],
        }
    }
}

/// The rank of [`Station::Middle`].
const MIDDLE: u8 = 2;

fn rank(station: &Station) -> u8 {
    match station {
        Station::Cusp(_) => 0,
        Station::Pitchfork(..) => 1,
        Station::Middle(_) => MIDDLE,
    }
}

impl Curves {
    pub(super) fn add_generic(&mut self, model: &Model, bits: usize) -> Result<(), IsolationError> {
        let polynomial = model.cusp_polynomial();
        let bend = model.inflection_polynomial();
        let last = model.active.len();
        for number in 0..=last {
            let roots = roots_in_interval(model, &polynomial, number, bits)?;
            if let Some(bend) = bend.as_ref().filter(|_| number > 0 && number < last)
                && let Some((place, _)) = roots_in_interval(model, bend, number, bits)?.into_iter().next()
            {
                self.inflection = Some((number, place));
            }
            let mut stations: Vec<Station> = Vec::new();
            for (place, odd) in roots {
                if odd {
                    stations.push(Station::Cusp(place));
                } else {
                    self.degenerate.push(place);
                }
            }
            for &group in &model.passive {
                if let Some(place) = passive_place(model, number, group) {
                    stations.push(Station::Pitchfork(place, group));
                }
            }
            if let [left, right] = &charts(model, number)[..]
                && let (Some(l), Some(r)) = (&left.limit, &right.limit)
            {
                let places = [Place::exact(left.half, l.clone()), Place::exact(right.half, r.clone())];
                stations.push(Station::Middle(places));
            }
            let mut overlap = None;
            stations.sort_by(|p, q| {
                order(model, p.place(), q.place()).unwrap_or_else(|| {
                    if rank(p).max(rank(q)) < MIDDLE {
                        overlap = Some(p.place().clone());
                    }
                    // A station in the very middle comes first and begins the right half.
                    rank(p).cmp(&rank(q))
                })
            });
            self.degenerate.extend(overlap);
            self.cut(model, number, &stations);
        }
        Ok(())
    }

    /// Turns the stations of an interval of the generic family into curves.
    fn cut(&mut self, model: &Model, number: usize, stations: &[Station]) {
        let charts = charts(model, number);
        let last = model.active.len();
        let mut half = charts[0].half;
        // Rising μ: towards larger x on the first interval, away from it elsewhere, and the other way after each cusp.
        let mut rising = number == 0;
        let mut start = if number == 0 { Bound::Infinity } else { Bound::Zero };
        let mut start_end = if number == 0 { End::Origin } else { End::Infinity };
        let mut segments: Vec<Segment> = Vec::new();
        let mut piece = 0;
        for index in 0..=stations.len() {
            let station = stations.get(index);
            let Stop { bound, end, next } = self.stop(station, number == last);
            let same_place = matches!((&start, &bound), (Bound::At(p), Bound::At(q)) if p.half == q.half && p.lo == q.lo && p.hi == q.hi);
            if !same_place {
                let ends = if rising { [start.clone(), bound.clone()] } else { [bound.clone(), start.clone()] };
                segments.push(Segment { half, ends });
            }
            if let Some(next) = &next {
                half = next.half;
                start = Bound::At(next.clone());
            }
            let Some(end) = end else { continue };
            piece += 1;
            let this = self.list.next_id();
            let mut done = std::mem::take(&mut segments);
            let mut ends = [start_end, end];
            if !rising {
                done.reverse();
                ends.reverse();
            }
            let limit = if ends[1] == End::Infinity { done.last().and_then(Segment::limit) } else { None };
            // Beyond the last pitchfork only, where a group without r has the largest moment.
            let ends_in_pair = model.passive.iter().max().is_some_and(|&top| top > model.active[last - 1]);
            let lowest = number == last && (!ends_in_pair || station.is_none());
            self.join(start_end, this, rising);
            self.list.push(Curve {
                branch: Branch::Generic(IntervalId::at(number)),
                piece,
                orbit: Orbit::Point,
                pole: None,
                shape: Shape::Family(done),
                ends,
                limit,
                lowest,
            });
            self.enter(station, this, rising);
            rising ^= matches!(station, Some(Station::Cusp(_)));
            start_end = end;
        }
    }

    /// What a station, or the end of the interval after the last one, ends and begins.
    fn stop(&self, station: Option<&Station>, at_origin: bool) -> Stop {
        match station {
            None if at_origin => Stop { bound: Bound::Infinity, end: Some(End::Origin), next: None },
            None => Stop { bound: Bound::Zero, end: Some(End::Infinity), next: None },
            Some(Station::Middle([left, right])) => {
                Stop { bound: Bound::At(left.clone()), end: None, next: Some(right.clone()) }
            }
            Some(Station::Cusp(place)) => Stop::at(place, End::Cusp(self.cusps.next_id())),
            Some(Station::Pitchfork(place, _)) => Stop::at(place, End::Pitchfork(self.pitchforks.next_id())),
        }
    }

    /// Enters the cusp or pitchfork at which the curve `this` ends; the next curve and the pair are not known yet.
    fn enter(&mut self, station: Option<&Station>, this: CurveId, rising: bool) {
        match station {
            Some(Station::Cusp(place)) => {
                self.cusps.push(Cusp { place: place.clone(), curves: [this; 2], opens: !rising });
            }
            Some(Station::Pitchfork(place, group)) => {
                let place = Some(place.clone());
                self.pitchforks.push(Pitchfork { group: *group, place, through: [this; 2], pair: this, opens: true });
            }
            Some(Station::Middle(_)) | None => {}
        }
    }

    /// Enters `this` as the curve after a cut.
    fn join(&mut self, cut: End, this: CurveId, rising: bool) {
        match cut {
            End::Cusp(cusp) => self.cusps[cusp].curves[1] = this,
            End::Pitchfork(pitchfork) => self.pitchforks[pitchfork].through[usize::from(rising)] = this,
            End::Origin | End::Infinity => {}
        }
    }
}
