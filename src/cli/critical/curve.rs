//! The steady axes over the spin as a picture.

use std::path::Path;

use bifdiag_body::part::Spin;
use bifdiag_documents::Subject;
use bifdiag_equilibria::critical::{FamilyPoint, RelativeEquilibria, SteadyFamily};
use bifdiag_equilibria::nonlinear::NonlinearVerdict;
use bifdiag_plot::{Steadiness, SteadyCurve, SteadyScene, Theme, draw_steady};
use bifdiag_schema::Reason;
use dashu_ratio::RBig;

use super::spins::spin_at;
use super::table::{NOT_FOUND, from_center, no_axes_at};
use crate::cli::export::{FileSet, PictureArguments, PictureFormat};
use crate::cli::failure::{Failure, failed};
use crate::cli::terminal::{Report, Timings, counted, print};

/// Draws every steady axis at the spins of a range: its angle from the centre of mass.
pub fn draw(
    subject: &Subject,
    ends: [&Spin; 2],
    count: u32,
    (path, format): (&Path, PictureFormat),
    timings: &Timings,
) -> Result<(), Failure> {
    if subject.body.is_euler() {
        return Err(Failure::input("--out: without weight there is no angle from the centre of mass to draw"));
    }
    if ends[0].exact_rad_per_s() == ends[1].exact_rad_per_s() {
        return Err(Failure::input(
            "--spin: a picture needs two spins that differ; give \"a:b:n UNIT\" with a below b, or --out FILE.csv",
        ));
    }
    let scene = timings.stage("critical", || scene(subject, ends, count))?;
    let picture = draw_steady(&scene, Theme::Light)?;
    let mut files = FileSet::new(path.parent().unwrap_or(path));
    files.add_at(path, PictureArguments::plain(format).bytes(format, &picture)?);
    let written = timings.stage("files", || files.write())?;
    let mut report = Report::default();
    let drawn = scene.curves.iter().filter(|curve| curve.is_within(scene.range)).count();
    report.line(format!(
        "{} of steady axes over this range of spins or a part of it",
        counted(drawn, "family", "families")
    ));
    report.written(&written);
    print(report.text())
}

/// Each family as a curve, cut where its stability changes.
fn scene(subject: &Subject, ends: [&Spin; 2], count: u32) -> Result<SteadyScene, Failure> {
    let body = &subject.body;
    let prepared = RelativeEquilibria::new(body).map_err(failed(NOT_FOUND))?;
    for end in ends {
        let omega = end.exact_rad_per_s() * subject.unit_of_time();
        prepared.at_spin(&omega).map_err(|error| no_axes_at(subject, end, error))?;
    }
    let families = prepared.families().ok_or_else(|| Failure::work(NOT_FOUND))?;
    let angle = |gamma: [f64; 3]| from_center(body, gamma.map(|x| 0.0 - x));
    let rpm = |omega: f64| Spin::rpm(omega * subject.second());
    let [from, to] = ends.map(Spin::in_rpm);
    let start = |family: &SteadyFamily| -> Vec<[f64; 2]> {
        let place = family.stretches.first().and_then(|first| first.from);
        let at_start = |place: FamilyPoint| [rpm(place.omega), angle(place.gamma)];
        place.map(at_start).or(family.slow.map(|gamma| [0.0, angle(gamma)])).into_iter().collect()
    };
    let mut points: Vec<Vec<[f64; 2]>> = families.iter().map(start).collect();
    let even = (0..count).map(|k| spin_at(ends, count, k));
    let mut spins: Vec<(f64, RBig)> =
        even.map(|spin| (spin.in_rpm(), spin.exact_rad_per_s() * subject.unit_of_time())).collect();
    // Where axes appear, they move like the root of what the spin exceeds that place by.
    let step = (to - from) / f64::from(count.max(2) - 1) / rpm(1.0);
    let starts = families.iter().flat_map(|family| &family.stretches).filter_map(|stretch| stretch.from);
    spins.extend(
        starts
            .flat_map(|place| close_to(place.omega, step))
            .filter(|omega| (from..=to).contains(&rpm(*omega)))
            .filter_map(|omega| Some((rpm(omega), RBig::try_from(omega).ok()?))),
    );
    for (spin, omega) in spins.into_iter().filter(|(_, omega)| !omega.is_zero()) {
        let found = prepared.at_spin(&omega).map_err(failed(NOT_FOUND))?;
        for (family, points) in families.iter().zip(&mut points) {
            if let Some(axis) = found.list.iter().find(|axis| family.holds(body, axis)) {
                points.push([spin, angle(axis.gamma)]);
            }
        }
    }
    let are_known = prepared.exceptions().is_some();
    let curves = families.iter().zip(points).map(|(family, mut points)| {
        // The places where the type changes are exact.
        let places = family.stretches.iter().skip(1).filter_map(|stretch| stretch.from);
        points.extend(places.map(|place| [rpm(place.omega), angle(place.gamma)]));
        points.sort_by(|p, q| p[0].total_cmp(&q[0]));
        SteadyCurve { name: family.branch.to_string(), runs: runs(family, &points, rpm, are_known) }
    });
    Ok(SteadyScene { range: [from, to], curves: curves.collect() })
}

/// Values on both sides of a place, to the distance of a step, so that their roots are even.
fn close_to(place: f64, step: f64) -> impl Iterator<Item = f64> {
    const PARTS: i32 = 10;
    let away = move |k: i32| {
        let share = f64::from(k) / f64::from(PARTS);
        place + step * share * share.abs()
    };
    (-PARTS..=PARTS).filter(|k| *k != 0).map(away)
}

/// The points of each range of one verdict, the ends of it in both neighbours.
fn runs(
    family: &SteadyFamily,
    points: &[[f64; 2]],
    rpm: impl Fn(f64) -> f64,
    are_known: bool,
) -> Vec<(Steadiness, Vec<[f64; 2]>)> {
    let starts: Vec<f64> =
        family.stretches.iter().map(|stretch| stretch.from.map_or(0.0, |place| rpm(place.omega))).collect();
    let run = |(number, stretch): (usize, &bifdiag_equilibria::critical::SteadyStretch)| {
        let until = starts.get(number + 1).copied().unwrap_or(f64::INFINITY);
        let kind = match stretch.verdict_with(are_known) {
            Some((NonlinearVerdict::Stable, Reason::Energy)) => Steadiness::Lasting,
            Some((NonlinearVerdict::Stable, _)) => Steadiness::Frictionless,
            Some((NonlinearVerdict::Unstable, _)) => Steadiness::Unstable,
            Some((NonlinearVerdict::Open, _)) | None => Steadiness::Open,
        };
        let here = points.iter().copied().filter(|[at, _]| (starts[number]..=until).contains(at));
        (kind, here.collect())
    };
    family.stretches.iter().enumerate().map(run).collect()
}
