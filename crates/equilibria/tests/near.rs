//! Steady rotations near an axis over a box of bodies, against those of single bodies of the box in their own principal axes.

// Numbers of the tests are far below 2^53.
#![allow(clippy::cast_possible_truncation)]

use bifdiag_body::{Body, BodyAxis, Tensor};
use bifdiag_equilibria::critical::{Equilibrium, ExactSpin};
use bifdiag_equilibria::permanent::{
    AxisRotation, BoxedBody, SettledTypes, angle_between, equally_near, nearest_permanent, nearest_steady,
    settled_types,
};
use bifdiag_equilibria::stability::LinearType;
use bifdiag_numbers::Sign;
use bifdiag_numbers::enclosure::{Arithmetic, Enclosure};
use bifdiag_numbers::interval::Interval;
use bifdiag_numbers::symmetric::Symmetric;
use bifdiag_schema::SpinType;
use dashu_ratio::RBig;
use support::random::SplitMix64;

/// Nominal entries and deviations, in millionths: Ixx, Iyy, Izz, Ixy, Ixz, Iyz, r.
struct Case {
    nominal: [i64; 9],
    within: [i64; 9],
}

fn millionth(x: i64) -> RBig {
    RBig::from_parts(x.into(), 1_000_000u32.into())
}

impl Case {
    /// About the third axis, which is up or down by the sign of r.
    fn random(random: &mut SplitMix64) -> Self {
        let mut draw = |lo: f64, hi: f64| (1e6 * random.between(lo, hi)).round() as i64;
        let moments = [draw(0.6, 1.4), draw(0.6, 1.4), draw(0.6, 1.4)];
        let r = draw(-1.5, 1.5);
        let [x, y, z] = moments;
        // Every third is symmetric.
        let y = if draw(0.0, 3.0) < 1_000_000 { x } else { y };
        let size = draw(0.0, 0.01);
        let mut most = |share: f64| (share * size as f64 * draw(0.0, 1.0) as f64 / 1e6) as i64;
        let within =
            [most(1.0), most(1.0), most(1.0), most(0.5), most(0.5), most(0.5), most(0.5), most(0.5), most(1.0)];
        Self { nominal: [x, y, z, 0, 0, 0, 0, 0, r], within }
    }

    fn boxed(&self) -> BoxedBody {
        let [xx, yy, zz, xy, xz, yz, x, y, z] = std::array::from_fn(|k| {
            let end = |sign: i64| Interval::rational(&millionth(self.nominal[k] + sign * self.within[k]), ());
            end(-1).hull(&end(1))
        });
        BoxedBody { tensor: [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]], center: [x, y, z] }
    }

    /// One of the bodies, its principal axes, and what is up.
    fn member(&self, random: &mut SplitMix64) -> (Body, [f64; 3]) {
        let values: [RBig; 9] = std::array::from_fn(|k| {
            let step = (self.within[k] as f64 * random.between(-1.0, 1.0)) as i64;
            millionth(self.nominal[k] + step)
        });
        let [xx, yy, zz, xy, xz, yz, x, y, z] = values;
        let form = Tensor::new(Symmetric::new([xx, yy, zz, xy, xz, yz]), [x, y, z]).unwrap().principal().unwrap();
        (form.body, form.axes.map(|axis| axis[2]))
    }
}

fn kind(found: &Equilibrium) -> SpinType {
    match (found.index, found.stability) {
        (0, _) => SpinType::Minimum,
        (1, _) => SpinType::SaddleCentre,
        (_, LinearType::Elliptic | LinearType::DoubleElliptic) => SpinType::Elliptic,
        (_, LinearType::Complex) => SpinType::Complex,
        (_, LinearType::DoubleReal) => SpinType::DoubleReal,
        _ => SpinType::Saddle,
    }
}

/// Spins outside the ranges, with the type that is said there.
fn spins(found: &SettledTypes) -> Vec<(f64, SpinType)> {
    let mut spins = Vec::new();
    for (number, range) in found.ranges.iter().enumerate() {
        if let (0, Some(from)) = (number, range.from) {
            spins.extend([0.1, 0.9, 0.999_999].map(|part| (part * range.omega[0], from)));
        }
        let next = found.ranges.get(number + 1).map_or(4.0 * range.omega[1], |next| next.omega[0]);
        if let (Some(to), true) = (range.to, range.omega[1].is_finite()) {
            let along = |part: f64| range.omega[1] + part * (next - range.omega[1]);
            spins.extend([1e-6, 0.5, 0.999_999].map(|part| (along(part), to)));
        }
    }
    spins
}

#[test]
fn every_body_of_the_box_has_the_type_outside_the_ranges() {
    let mut random = SplitMix64::new(19);
    let (mut agreed, mut tilted) = (0, 0);
    for _ in 0..60 {
        let case = Case::random(&mut random);
        let found = settled_types(&case.boxed(), [0.0, 0.0, 1.0]);
        for (omega, expected) in spins(&found) {
            for _ in 0..6 {
                let (body, up) = case.member(&mut random);
                let rational = |x: f64| RBig::try_from(x).unwrap();
                let steady =
                    nearest_steady(&body, &ExactSpin::rational(rational(omega)), up, Some(&up.map(rational))).unwrap();
                assert!(steady.angle <= found.tilt.unwrap() + 1e-9, "{:?} {omega} {steady:?}", case.nominal);
                assert_eq!(
                    kind(&steady.equilibrium),
                    expected,
                    "{:?} {:?} {omega} {steady:?}",
                    case.nominal,
                    case.within
                );
                agreed += 1;
                tilted += i32::from(steady.angle > 1e-4);
            }
        }
    }
    println!("{agreed} agree, {tilted} of them about a tilted axis");
    assert!(agreed > 1500 && tilted > 500, "{agreed} {tilted}");
}

/// Where all numbers are exact the ranges shrink to the changes of the permanent axis.
#[test]
fn exact_numbers_leave_the_changes_alone() {
    let mut changes = 0;
    let mut random = SplitMix64::new(20);
    for _ in 0..20 {
        let case = Case { within: [0; 9], ..Case::random(&mut random) };
        let found = settled_types(&case.boxed(), [0.0, 0.0, 1.0]);
        let body = case.member(&mut random).0;
        let rotation = AxisRotation::new(&body, BodyAxis::ALL[2], Sign::Negative).unwrap();
        // A diagonal tensor keeps its axes.
        for change in rotation.changes() {
            let range =
                found.ranges.iter().find(|range| range.omega[0] <= change.omega && change.omega <= range.omega[1]);
            let range = range.unwrap_or_else(|| panic!("{change:?} {found:?}"));
            assert!(range.omega[1] - range.omega[0] < 2e-3 * change.omega, "{change:?} {range:?}");
            if range.from == Some(change.from) && range.to == Some(change.to) {
                changes += 1;
            }
        }
        assert!(found.tilt.is_some_and(|tilt| tilt < 1e-12), "{:?}", found.tilt);
    }
    assert!(changes > 15, "{changes}");
}

/// A sleeping top with an error in every number: the closed form's threshold lies in its range for each corner, and the range
/// is not much wider than what the corners need.
#[test]
fn the_range_of_a_sleeping_top_is_narrow() {
    let mut nominal = [1_000_000, 1_000_000, 600_000, 0, 0, 0, 0, 0, 1_000_000];
    for percent in [1_i64, 3] {
        let within = [percent * 10_000, percent * 10_000, percent * 6_000, 0, 0, 0, 0, 0, percent * 10_000];
        let found = settled_types(&Case { nominal, within }.boxed(), [0.0, 0.0, 1.0]);
        let range = found.ranges.iter().find(|range| range.to == Some(SpinType::Elliptic)).unwrap();
        assert_eq!(range.from, Some(SpinType::Complex));
        // Ω² = 4 A r / C².
        let part = 0.01 * percent as f64;
        let threshold = |side: f64| 2.0 * (1.0 + side * part) / (0.6 * (1.0 - side * part));
        assert!(range.omega[0] <= threshold(-1.0) && threshold(1.0) <= range.omega[1], "{range:?}");
        let needed = threshold(1.0) - threshold(-1.0);
        assert!(range.omega[1] - range.omega[0] < 4.0 * needed, "{range:?} {needed}");
    }
    nominal[8] = -1_000_000;
    let hanging = settled_types(&Case { nominal, within: [0; 9] }.boxed(), [0.0, 0.0, 1.0]);
    assert!(hanging.ranges.iter().all(|range| range.from.is_none_or(SpinType::is_elliptic)), "{hanging:?}");
}

/// Directions that r and the differences of moments put into a plane of symmetry of Staude's cone have two nearest axes, both of
/// the cone and at one angle; others have one.
#[test]
fn axes_at_one_angle_are_all_found() {
    for (a, r, up, count) in [
        (["1", "2", "3"], ["0", "0", "1"], [1.0, 1.0, 1.0], 1),
        (["1", "2", "3"], ["0", "0", "1"], [1.0, -1.0, 0.5], 1),
        (["1", "2", "3"], ["0", "1", "0"], [1.0, 0.3, -1.0], 1),
        (["1", "2", "3"], ["0", "0", "1"], [1.0, 0.9, 1.0], 0),
        (["1", "2", "3"], ["0.1", "0.2", "0.3"], [1.0, 1.0, 0.0], 0),
    ] {
        let body = Body::parse(&a, &r).unwrap();
        let nearest = nearest_permanent(&body, up).unwrap();
        let others = equally_near(&body, up, nearest.axis);
        assert_eq!(others.len(), count, "{a:?} {r:?} {up:?} {others:?}");
        for other in others {
            assert!((angle_between(other, up) - nearest.angle).abs() < 1e-9, "{a:?} {r:?} {up:?}");
            // What lies on the cone is its own nearest axis.
            let found = nearest_permanent(&body, other).unwrap();
            assert!(found.angle < 1e-9 && angle_between(other, nearest.axis) > 0.1, "{found:?}");
        }
    }
}
