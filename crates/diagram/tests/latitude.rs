//! The sweep over latitudes against the oracle file, the paper, exact values and a flood fill.

use std::collections::BTreeMap;

use bifdiag_body::{Body, Number};
use bifdiag_diagram::topology::latitude::{self, Arcs, Latitudes, Obstacle, SweepError};
use bifdiag_diagram::topology::{Component, Poles, signature};
use serde::Deserialize;
use support::bodies::{STRATA, Stratum, random_body, random_point};
use support::flood_fill;
use support::random::SplitMix64;

/// Components at (h, l) in the body's own units.
fn sweep(body: &Body, h: f64, l: f64) -> Result<Vec<Component>, SweepError> {
    let frame = body.frame();
    latitude::components(&frame, h / frame.energy_unit, l / frame.momentum_unit)
}

/// (boundary circles, number of poles) of each component.
fn types(components: &[Component]) -> Vec<(u32, u32)> {
    components.iter().map(|c| (c.boundary_circles, c.poles.map_or(0, Poles::count))).collect()
}

#[derive(Deserialize)]
struct Case {
    #[serde(rename = "A")]
    moments: [Number; 3],
    r: [Number; 3],
    h: f64,
    l: f64,
    components: Vec<CaseComponent>,
}

#[derive(Deserialize)]
struct CaseComponent {
    boundary_circles: u32,
    poles: u32,
    genus: u32,
}

#[test]
fn every_case_of_the_oracle_file() {
    let text = support::data("cases/classify.jsonl");
    let mut count = 0;
    for line in text.lines() {
        let case: Case = serde_json::from_str(line).unwrap();
        let body = Body::new(case.moments, case.r).unwrap();
        let found = sweep(&body, case.h, case.l).unwrap_or_else(|error| panic!("{error}: {line}"));
        let expected: Vec<_> = case.components.iter().map(|c| (c.boundary_circles, c.poles)).collect();
        assert_eq!(types(&found), expected, "{line}");
        let genera: Vec<_> = case.components.iter().map(|c| Some(c.genus)).collect();
        assert_eq!(found.iter().map(Component::genus).collect::<Vec<_>>(), genera, "{line}");
        count += 1;
    }
    assert_eq!(count, 80);
}

#[test]
fn the_nine_regions_of_the_papers_body() {
    let body = Body::parse(&["2", "1.1", "1"], &["0.94868", "0", "0.61623"]).unwrap();
    let disc = (1, 0);
    for (h, l, expected, section) in [
        (1.8, 3.25, vec![disc], "S2"),
        (2.6, 3.25, vec![(1, 1)], "T2"),
        (3.8, 3.25, vec![disc, (1, 1)], "S2+T2"),
        (4.45, 3.25, vec![(1, 1), (1, 1)], "T2+T2"),
        (4.675, 3.25, vec![(2, 2)], "M3"),
        (5.3, 3.25, vec![(1, 2)], "M2"),
        (6.5, 3.25, vec![(0, 2)], "T2"),
        (3.1486, 2.72, vec![(2, 1)], "M2"),
        (14.0, 7.2, vec![disc, disc], "S2+S2"),
    ] {
        let found = sweep(&body, h, l).unwrap();
        assert_eq!(types(&found), expected, "({h}, {l})");
        assert_eq!(signature(&found).as_deref(), Some(section));
    }
}

#[test]
fn kovalevskayas_body() {
    let body = Body::parse(&["2", "2", "1"], &["1", "0", "0"]).unwrap();
    for (h, expected) in [
        (-0.16, vec![]),
        (-0.15, vec![(1, 1)]),
        (1.83, vec![(1, 1)]),
        (1.84, vec![(3, 1)]),
        (1.85, vec![(2, 2)]),
        (1.86, vec![(0, 2)]),
    ] {
        let found = sweep(&body, h, 1.84).unwrap();
        let found: Vec<_> = found.iter().map(|c| (c.boundary_circles, c.poles.unwrap().count())).collect();
        assert_eq!(found, expected, "h = {h}");
    }
}

#[test]
fn random_points_agree_with_a_flood_fill() {
    let mut rng = SplitMix64::new(2008);
    let mut tally: BTreeMap<Stratum, [u32; 3]> = BTreeMap::new();
    let mut seen: BTreeMap<Vec<(u32, u32)>, u32> = BTreeMap::new();
    let (mut refined, mut wrong) = (0, 0);
    for n in 0..8_800 {
        let stratum = STRATA[n % STRATA.len()];
        let body = random_body(&mut rng, stratum);
        let (h, l) = random_point(&mut rng, &body);
        let counts = tally.entry(stratum).or_default();
        counts[0] += 1;
        let Ok(found) = sweep(&body, h, l) else {
            counts[1] += 1;
            continue;
        };
        let coarse = flood_fill::components(&body, h, l, 48);
        if coarse != flood_fill::components(&body, h, l, 67) {
            continue;
        }
        counts[2] += 1;
        *seen.entry(types(&found)).or_default() += 1;
        if coarse != found {
            // Discs and holes below the size of the grid's cells: ask finer grids, which must agree with each other.
            let rows = [(230, 310), (900, 1270)].into_iter().find(|&(rows, more)| {
                flood_fill::components(&body, h, l, rows) == found && flood_fill::components(&body, h, l, more) == found
            });
            println!("{stratum:?} A = {:?}, r = {:?}, h = {h}, l = {l}", body.moments_f64(), body.center_f64());
            println!("  sweep {:?}, coarse {:?}, settled by {rows:?} rows", types(&found), types(&coarse));
            refined += 1;
            wrong += u32::from(rows.is_none());
        }
    }
    println!("points, undecided, compared: {tally:?}\ntypes: {seen:?}");
    println!("{refined} settled by finer grids, {wrong} wrong");
    assert_eq!(wrong, 0);
    assert!(refined <= 20);
    assert!(
        tally.values().all(|[points, undecided, compared]| undecided * 100 < *points && compared * 20 > points * 19)
    );
}

#[derive(Deserialize)]
struct CriticalCase {
    #[serde(rename = "A")]
    moments: [Number; 3],
    r: [Number; 3],
    l: Number,
    critical: Vec<CriticalPoint>,
}

#[derive(Deserialize)]
struct CriticalPoint {
    h: Number,
}

/// χ(U_hl) as the sweep finds it.
fn euler_characteristic(components: &[Component]) -> i64 {
    components.iter().map(|c| 2 - i64::from(c.boundary_circles)).sum()
}

#[test]
fn certified_critical_values_of_extreme_bodies_are_the_only_changes() {
    let mut counts = [0; 3];
    for line in support::data("cases/extremes.jsonl").lines() {
        let case: CriticalCase = serde_json::from_str(line).unwrap();
        let body = Body::new(case.moments, case.r).unwrap();
        let l = case.l.to_f64();
        let levels: Vec<f64> = case.critical.iter().map(|point| point.h.to_f64()).collect();
        let size: f64 = levels.iter().fold(0.0, |m: f64, h| m.max(h.abs()));
        let outside = 1e-3 * (levels[levels.len() - 1] - levels[0]);
        let mut bounds = vec![levels[0] - outside];
        bounds.extend(&levels);
        bounds.push(levels[levels.len() - 1] + outside);
        let mut before = None;
        for (n, pair) in bounds.windows(2).enumerate() {
            let gap = pair[1] - pair[0];
            let found: Vec<_> = [1e-3, 0.1, 0.5, 0.9, 0.999]
                .map(|t| {
                    let found = sweep(&body, pair[0] + t * gap, l);
                    counts[0] += 1;
                    match found {
                        Ok(components) => Some(euler_characteristic(&components)),
                        Err(SweepError::Undecided { .. }) => {
                            counts[1] += 1;
                            assert!(gap / size < 1e-6, "{line} gap {n} at {t}");
                            None
                        }
                        Err(error) => panic!("{error}"),
                    }
                })
                .into_iter()
                .flatten()
                .collect();
            assert!(found.windows(2).all(|pair| pair[0] == pair[1]), "{line} gap {n}: {found:?}");
            if let (Some(before), Some(&here)) = (before, found.first()) {
                let before: i64 = before;
                assert_eq!((here - before).abs(), 1, "{line} at critical value {n}: {before} {here}");
                counts[2] += 1;
            }
            before = found.first().copied();
            if n == 0 {
                assert_eq!(before, Some(0));
            } else if n == levels.len() {
                assert_eq!(before, Some(2));
            }
        }
    }
    let [points, undecided, bracketed] = counts;
    println!("{points} points, {undecided} undecided, {bracketed} critical values bracketed");
    // Undecided are the levels of two bodies at l > 10⁶ whose gaps are a few units in the last place of h.
    assert!(undecided <= 40 && bracketed >= 90);
}

fn potential(a: [f64; 3], r: [f64; 3], l: f64, g: [f64; 3]) -> f64 {
    let j = a[0] * g[0] * g[0] + a[1] * g[1] * g[1] + a[2] * g[2] * g[2];
    l * l / (2.0 * j) - (g[0] * r[0] + g[1] * r[1] + g[2] * r[2])
}

/// Radius within which a hole counts as small.
const SMALL: f64 = 0.03;

/// Small holes about ±e_i, as their centres: U > h at the centre, U ≤ h at the distance [`SMALL`].
fn small_holes(a: [f64; 3], r: [f64; 3], h: f64, l: f64) -> Vec<[f64; 3]> {
    let axes = (0..3).flat_map(|axis| [(axis, 1.0), (axis, -1.0)]);
    let holes = axes.filter(|&(axis, sign)| {
        let accessible = |x: f64, y: f64| {
            let mut g = [0.0; 3];
            g[axis] = sign * (1.0 - x * x - y * y).sqrt();
            g[(axis + 1) % 3] = x;
            g[(axis + 2) % 3] = y;
            potential(a, r, l, g) <= h
        };
        let around = (0..64).all(|n| {
            let t = f64::from(n) / 32.0 - 1.0;
            let (c, s) = (SMALL * (1.0 - t * t) / (1.0 + t * t), SMALL * 2.0 * t / (1.0 + t * t));
            accessible(c, s) && accessible(-c, -s)
        });
        around && !accessible(0.0, 0.0)
    });
    holes.map(|(axis, sign)| std::array::from_fn(|i| if i == axis { sign } else { 0.0 })).collect()
}

#[test]
fn extreme_bodies_and_momenta_agree_with_a_flood_fill_that_counts_small_holes_apart() {
    let mut rng = SplitMix64::new(99);
    let mut counts = [0; 4];
    for n in 0..1500 {
        let d = rng.direction();
        let (a, r) = [
            ([1e-6, 1.0, 1.0 + 1e-9], d),
            ([1e-6, 0.7, 1.0], [d[0], d[1], 1e-12]),
            ([0.7, 1.0, 1.0 + 1e-9], d),
            ([1.0, 1.0 + 1e-9, 1.0 + 2.3e-9], d),
            ([0.5, 0.7, 1.0], [1e-12 * d[0], 1e-12 * d[1], d[2]]),
        ][n % 5];
        let body = Body::from_f64(a, r).unwrap();
        let l = rng.power_of_ten(-6.0, 8.0);
        let h = potential(a, r, l, rng.direction());
        counts[0] += 1;
        let found = match sweep(&body, h, l) {
            Ok(found) => found,
            Err(SweepError::Undecided { .. }) => {
                counts[1] += 1;
                continue;
            }
            Err(error) => panic!("{error}"),
        };
        let holes = small_holes(a, r, h, l);
        let filled = |g: [f64; 3]| {
            let distance = |e: &[f64; 3]| (0..3).map(|i| (g[i] - e[i]) * (g[i] - e[i])).sum::<f64>();
            potential(a, r, l, g) <= h || holes.iter().any(|e| distance(e) < SMALL * SMALL)
        };
        let mut coarse = flood_fill::fill(r, 48, filled);
        if coarse != flood_fill::fill(r, 67, filled) || (!holes.is_empty() && coarse.len() != 1) {
            continue;
        }
        counts[2] += 1;
        if let [only] = coarse.as_mut_slice() {
            only.boundary_circles += u32::try_from(holes.len()).unwrap();
            counts[3] += u32::from(!holes.is_empty());
        }
        assert_eq!(found, coarse, "A = {a:?}, r = {r:?}, h = {h}, l = {l}");
    }
    let [points, undecided, compared, holes] = counts;
    println!("{points} points, {undecided} undecided, {compared} compared, {holes} with small holes");
    assert!(undecided * 20 < points && compared * 2 > points && holes > 0);
}

#[test]
fn units_do_not_matter() {
    let mut rng = SplitMix64::new(15);
    for n in 0..550 {
        let body = random_body(&mut rng, STRATA[n % STRATA.len()]);
        let (h, l) = random_point(&mut rng, &body);
        let scaled = Body::from_f64(body.moments_f64().map(|a| 3e-5 * a), body.center_f64().map(|r| 7e4 * r)).unwrap();
        let (Ok(one), Ok(other)) = (sweep(&body, h, l), sweep(&scaled, 7e4 * h, -(3e-5f64 * 7e4).sqrt() * l)) else {
            continue;
        };
        assert_eq!(one, other, "{body:?} {h} {l}");
    }
}

#[test]
fn points_on_curves_are_undecided() {
    let body = Body::parse(&["2", "2", "1"], &["1", "0", "0"]).unwrap();
    let obstacle = |h: f64, l: f64| match sweep(&body, h, l) {
        Err(SweepError::Undecided { obstacle, .. }) => obstacle,
        other => panic!("({h}, {l}): {other:?}"),
    };
    assert_eq!(obstacle(1.25, 3.0), Obstacle::Pole);
    assert_eq!(obstacle(3.25, 3.0), Obstacle::Pole);
    assert_eq!(obstacle(1.0, 0.0), Obstacle::Pole);
    // The tilted pair at s = 3: l² = s(1 + 1/s²)², h = s/2 + 3/(2s) = 2, a saddle.
    assert_eq!(obstacle(2.0, 3.0f64.sqrt() * 10.0 / 9.0), Obstacle::Singularity);
    assert_eq!(sweep(&body, 2.0 + 1e-12, 3.0f64.sqrt() * 10.0 / 9.0).map(|c| types(&c)), Ok(vec![(0, 2)]));
}

#[test]
fn input_that_is_not_finite_is_refused() {
    let frame = Body::parse(&["2", "2", "1"], &["1", "0", "0"]).unwrap().frame();
    assert!(matches!(latitude::components(&frame, f64::NAN, 1.0), Err(SweepError::NotFinite { .. })));
    assert!(matches!(latitude::components(&frame, 1.0, f64::INFINITY), Err(SweepError::NotFinite { .. })));
    assert!(matches!(Latitudes::new(&frame, 1.0, f64::NAN), Err(SweepError::NotFinite { .. })));
    let latitudes = Latitudes::new(&frame, 1.0, 1.0).unwrap();
    assert_eq!(latitudes.arcs_at(1.5), Err(SweepError::NoLatitude { cosine: 1.5 }));
    // Far beyond the range of squares: no answer, but no wrong one.
    assert!(matches!(latitude::components(&frame, 1e300, 1e200), Err(SweepError::Undecided { .. })));
}

#[test]
fn a_latitude_tangent_to_the_boundary_is_no_obstacle() {
    // G = 0 and ∂G/∂ψ = 0 at e3 on the equator, which is regular.
    let body = Body::parse(&["2", "1.5", "1"], &["1", "0", "0"]).unwrap();
    assert!(sweep(&body, 8.0, 4.0).is_ok());
    assert_eq!(sweep(&body, 8.0, 4.0).map(|c| types(&c)), sweep(&body, 8.0 + 1e-9, 4.0).map(|c| types(&c)));
}

#[test]
fn without_momentum_u_is_a_cap() {
    let body = Body::parse(&["2", "1.1", "1"], &["0", "3", "4"]).unwrap();
    let at = |h: f64| sweep(&body, h, 0.0).map(|c| types(&c)).unwrap();
    assert_eq!((at(-5.1), at(-4.9), at(4.9), at(5.1)), (vec![], vec![(1, 1)], vec![(1, 1)], vec![(0, 2)]));
}

/// γ from c and (cos ψ', sin ψ') by the definition of the PP-torus' axes, in the body's coordinates.
fn gamma(r: [f64; 3], c: f64, [cos, sin]: [f64; 2]) -> [f64; 3] {
    let norm = (r[0] * r[0] + r[1] * r[1] + r[2] * r[2]).sqrt();
    let z = r.map(|x| x / norm);
    let third = if r[0] == 0.0 && r[1] == 0.0 { [0.0, 1.0, 0.0] } else { [0.0, 0.0, 1.0] };
    let overlap = z[0] * third[0] + z[1] * third[1] + z[2] * third[2];
    let v: [f64; 3] = std::array::from_fn(|i| third[i] - overlap * z[i]);
    let n = (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]).sqrt();
    let y = v.map(|x| x / n);
    let x = [y[1] * z[2] - y[2] * z[1], y[2] * z[0] - y[0] * z[2], y[0] * z[1] - y[1] * z[0]];
    let s = (1.0 - c * c).sqrt();
    std::array::from_fn(|i| s * (sin * x[i] + cos * y[i]) + c * z[i])
}

#[test]
fn arcs_end_on_the_boundary_and_hold_accessible_points() {
    let mut rng = SplitMix64::new(12);
    let mut ends = 0;
    for n in 0..440 {
        let stratum = STRATA[n % STRATA.len()];
        let body = random_body(&mut rng, stratum);
        if stratum == Stratum::Euler {
            continue;
        }
        let (a, r) = (body.moments_f64(), body.center_f64());
        let (h, l) = random_point(&mut rng, &body);
        let frame = body.frame();
        let latitudes = Latitudes::new(&frame, h / frame.energy_unit, l / frame.momentum_unit).unwrap();
        for _ in 0..8 {
            let c = rng.between(-1.0, 1.0);
            let at = |direction: [f64; 2]| potential(a, r, l, gamma(r, c, direction)) - h;
            let size = h.abs() + l * l / a.iter().fold(f64::INFINITY, |m: f64, &x| m.min(x));
            let samples = (0..400).map(|k| {
                let t = (f64::from(k) + 0.5) / 200.0 - 1.0;
                let d = 1.0 + t * t;
                if k % 2 == 0 { [(1.0 - t * t) / d, 2.0 * t / d] } else { [(t * t - 1.0) / d, -2.0 * t / d] }
            });
            match latitudes.arcs_at(c).unwrap() {
                Arcs::Nothing => assert!(samples.into_iter().all(|direction| at(direction) > -1e-12 * size)),
                Arcs::Everything => assert!(samples.into_iter().all(|direction| at(direction) < 1e-12 * size)),
                Arcs::Part(arcs) => {
                    assert!(arcs.len() <= 2);
                    for arc in &arcs {
                        ends += 2;
                        assert!(at(arc.start).abs() < 1e-12 * size && at(arc.end).abs() < 1e-12 * size);
                    }
                    for direction in samples {
                        let inside = arcs.iter().any(|arc| between(arc.start, direction, arc.end));
                        let u = at(direction);
                        assert!(u.abs() < 1e-12 * size || inside == (u < 0.0), "{body:?} {h} {l} {c}");
                    }
                }
            }
        }
    }
    println!("{ends} ends of arcs");
    assert!(ends > 1000);
}

/// Whether x lies on the way from start to end in the positive direction; all are (cos, sin).
fn between(start: [f64; 2], x: [f64; 2], end: [f64; 2]) -> bool {
    let turn = |u: [f64; 2], v: [f64; 2]| {
        let (cos, sin) = (u[0] * v[0] + u[1] * v[1], u[0] * v[1] - u[1] * v[0]);
        // Grows with the angle from u to v in [0, 2π).
        if sin >= 0.0 { 1.0 - cos } else { 3.0 + cos }
    };
    turn(start, x) <= turn(start, end)
}

#[test]
fn the_holes_of_fig_projections12_lie_at_zero_and_pi() {
    let frame = Body::parse(&["2", "1.5", "1"], &["1", "0", "0"]).unwrap().frame();
    let latitudes = Latitudes::new(&frame, 80.5 / frame.energy_unit, 12.8 / frame.momentum_unit).unwrap();
    let Arcs::Part(arcs) = latitudes.arcs_at(0.0).unwrap() else { panic!("the equator is cut by both holes") };
    assert_eq!(arcs.len(), 2);
    for arc in arcs {
        // Each arc is symmetric about ψ' = ±π/2, so the gaps are about 0 and π.
        assert!((arc.start[0] + arc.end[0]).abs() < 1e-12 && (arc.start[1] - arc.end[1]).abs() < 1e-12);
        assert!(arc.start[0].abs() > 0.5);
    }
}

#[test]
fn eulers_body_changes_at_the_principal_energies_only() {
    let body = Body::parse(&["1.5", "2", "1"], &["0", "0", "0"]).unwrap();
    let at = |h: f64| sweep(&body, h, 2.0).map(|c| (c.iter().all(|c| c.poles.is_none()), types(&c)));
    let (low, middle, high) = (1.0, 4.0 / 3.0, 2.0);
    for margin in [1e-12, 1e-6, 0.1] {
        assert_eq!(at(low - margin), Ok((true, vec![])));
        assert_eq!(at(low + margin), Ok((true, vec![(1, 0), (1, 0)])));
        assert_eq!(at(middle - margin), Ok((true, vec![(1, 0), (1, 0)])));
        assert_eq!(at(middle + margin), Ok((true, vec![(2, 0)])));
        assert_eq!(at(high - margin), Ok((true, vec![(2, 0)])));
        assert_eq!(at(high + margin), Ok((true, vec![(0, 0)])));
    }
    for critical in [low, middle, high] {
        assert!(matches!(at(critical), Err(SweepError::Undecided { .. })));
    }
}

#[test]
fn critical_circles_and_spheres_need_no_special_case() {
    // A = 1, r on the third axis: the circle ⟨γ,r̂⟩ = c is accessible for l²/2 − c ≤ h.
    let isotropic = Body::parse(&["1", "1", "1"], &["0", "0", "1"]).unwrap();
    // Lagrange, A3 > A1: at l = 4 U = 8/(1 + 3c²) − c is 1 and 3 at the poles, minima both, and has a circle of maxima.
    let lagrange = Body::parse(&["1", "1", "4"], &["0", "0", "1"]).unwrap();
    let at = |body: &Body, h: f64, l: f64| sweep(body, h, l).map(|c| types(&c));
    for margin in [1e-12, 1e-3] {
        assert_eq!(at(&isotropic, 1.0 - margin, 2.0), Ok(vec![]));
        assert_eq!(at(&isotropic, 1.0 + margin, 2.0), Ok(vec![(1, 1)]));
        assert_eq!(at(&isotropic, 3.0 - margin, 2.0), Ok(vec![(1, 1)]));
        assert_eq!(at(&isotropic, 3.0 + margin, 2.0), Ok(vec![(0, 2)]));
        assert_eq!(at(&lagrange, 1.0 + margin, 4.0), Ok(vec![(1, 1)]));
        assert_eq!(at(&lagrange, 3.0 - margin, 4.0), Ok(vec![(1, 1)]));
        assert_eq!(at(&lagrange, 3.0 + margin, 4.0), Ok(vec![(1, 1), (1, 1)]));
    }
    // The maximum of U over c lies where 48c/(1 + 3c²)² = −1.
    let mut c = 0.0f64;
    for _ in 0..60 {
        c = -(1.0 + 3.0 * c * c) * (1.0 + 3.0 * c * c) / 48.0;
    }
    let top = 8.0 / (1.0 + 3.0 * c * c) - c;
    assert_eq!(at(&lagrange, top - 1e-12, 4.0), Ok(vec![(1, 1), (1, 1)]));
    assert_eq!(at(&lagrange, top + 1e-12, 4.0), Ok(vec![(0, 2)]));
    assert!(matches!(at(&lagrange, top, 4.0), Err(SweepError::Undecided { .. })));
    assert_eq!(at(&Body::parse(&["1"; 3], &["0"; 3]).unwrap(), 2.0 + 1e-12, 2.0), Ok(vec![(0, 0)]));
}
