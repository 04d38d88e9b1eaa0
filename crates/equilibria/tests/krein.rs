//! Krein signs from the whole Euler–Poisson linearisation (Proposition 13.5 of docs/mathematics.md): eigenvectors of the 6×6
//! matrix and the second variation of the energy with multipliers for both Casimirs. Nothing here knows the closed form, the
//! Morse index or the reduced flow.

use bifdiag_body::Body;
use bifdiag_equilibria::critical::{Equilibrium, Multiplicity, critical};
use bifdiag_equilibria::curves::{CriticalSet, CurveId, CurveName};
use bifdiag_equilibria::stability::{LinearType, LinearTypes, StabilityChangeKind};
use nalgebra::{Complex, SMatrix, SVector, SymmetricEigen, Vector3};
use support::bodies::{Stratum, random_body};
use support::random::SplitMix64;

type Matrix6 = SMatrix<f64, 6, 6>;

/// The flow linearised on (γ, l) space, and the quadratic part of the energy there.
struct Whole {
    flow: Matrix6,
    energy: Matrix6,
    gamma: Vector3<f64>,
    l: Vector3<f64>,
}

fn hat(v: Vector3<f64>) -> SMatrix<f64, 3, 3> {
    v.cross_matrix()
}

impl Whole {
    fn new(body: &Body, point: &Equilibrium) -> Self {
        let a = SMatrix::<f64, 3, 3>::from_diagonal(&Vector3::from(body.moments_f64()));
        let inverse = SMatrix::<f64, 3, 3>::from_diagonal(&Vector3::from(body.moments_f64().map(|a| 1.0 / a)));
        let (gamma, r) = (Vector3::from(point.gamma), Vector3::from(body.center_f64()));
        let omega = point.omega * gamma;
        let l = a * omega;
        // γ' = γ × A⁻¹l, l' = l × A⁻¹l − γ × r, by rows.
        let mut flow = Matrix6::zeros();
        flow.fixed_view_mut::<3, 3>(0, 0).copy_from(&-hat(omega));
        flow.fixed_view_mut::<3, 3>(0, 3).copy_from(&(hat(gamma) * inverse));
        flow.fixed_view_mut::<3, 3>(3, 0).copy_from(&hat(r));
        flow.fixed_view_mut::<3, 3>(3, 3).copy_from(&(hat(l) * inverse - hat(omega)));
        // H − Ω⟨γ,l⟩ − β⟨γ,γ⟩/2 is stationary for β = −⟨γ, r + Ωl⟩.
        let beta = -gamma.dot(&(r + point.omega * l));
        let unit = SMatrix::<f64, 3, 3>::identity();
        let mut energy = Matrix6::zeros();
        energy.fixed_view_mut::<3, 3>(0, 0).copy_from(&(-beta * unit));
        energy.fixed_view_mut::<3, 3>(0, 3).copy_from(&(-point.omega * unit));
        energy.fixed_view_mut::<3, 3>(3, 0).copy_from(&(-point.omega * unit));
        energy.fixed_view_mut::<3, 3>(3, 3).copy_from(&inverse);
        Self { flow, energy, gamma, l }
    }

    /// Frequencies, each with the sign of the energy of its motion; `None` where two are too close to tell vectors apart.
    fn signs(&self) -> Option<Vec<(f64, i8)>> {
        let eigenvalues = self.flow.complex_eigenvalues();
        let scale = eigenvalues.iter().map(|x| x.norm()).fold(0.0, f64::max);
        let imaginary = eigenvalues.iter().filter(|x| x.im > 1e-4 * scale && x.re.abs() < 1e-7 * scale);
        let mut frequencies: Vec<f64> = imaginary.map(|x| x.im).collect();
        frequencies.sort_by(f64::total_cmp);
        if frequencies.windows(2).any(|pair| pair[1] - pair[0] < 1e-4 * scale) {
            return None;
        }
        frequencies.into_iter().map(|frequency| Some((frequency, self.sign(frequency, scale)?))).collect()
    }

    /// Inverse iteration beside iω gives the eigenvector v, and v*Qv is real.
    fn sign(&self, frequency: f64, scale: f64) -> Option<i8> {
        let shift = Complex::new(1e-10 * scale, frequency * (1.0 + 1e-11));
        let shifted = self.flow.map(|x| Complex::new(x, 0.0)) - SMatrix::<Complex<f64>, 6, 6>::identity() * shift;
        let solver = shifted.lu();
        let start = [0.3, -0.7, 0.5, 0.9, 0.2, -0.4];
        let mut v = SVector::<Complex<f64>, 6>::from_fn(|k, _| Complex::new(start[k], start[5 - k]));
        for _ in 0..4 {
            v = solver.solve(&v)?;
            v /= Complex::new(v.norm(), 0.0);
        }
        let square = (v.adjoint() * self.energy.map(|x| Complex::new(x, 0.0)) * v)[0];
        assert!(square.im.abs() < 1e-9, "{square}");
        let sizes = self.energy.norm();
        (square.re.abs() > 1e-7 * sizes).then_some(if square.re > 0.0 { 1 } else { -1 })
    }

    /// Numbers of positive and negative squares of the energy on the leaf ⟨γ,γ⟩ = 1, ⟨γ,l⟩ = const.
    fn signature(&self) -> [usize; 2] {
        let mut normals = SMatrix::<f64, 6, 2>::zeros();
        normals.fixed_view_mut::<3, 1>(0, 0).copy_from(&self.gamma);
        normals.fixed_view_mut::<3, 1>(0, 1).copy_from(&self.l);
        normals.fixed_view_mut::<3, 1>(3, 1).copy_from(&self.gamma);
        let q = normals.qr().q();
        let onto = Matrix6::identity() - q * q.transpose();
        let squares = SymmetricEigen::new(onto.transpose() * self.energy * onto).eigenvalues;
        let least = 1e-9 * self.energy.norm();
        [squares.iter().filter(|x| **x > least).count(), squares.iter().filter(|x| **x < -least).count()]
    }
}

/// How many of the imaginary pairs have the sign + and how many −, by type and Morse index.
fn expected(point: &Equilibrium) -> [usize; 2] {
    match (point.stability, point.index) {
        (LinearType::Elliptic, 0) => [2, 0],
        (LinearType::Elliptic, _) => [1, 1],
        (LinearType::SaddleCentre, _) => [1, 0],
        _ => [0, 0],
    }
}

fn counted(signs: &[(f64, i8)]) -> [usize; 2] {
    [1, -1].map(|sign| signs.iter().filter(|(_, found)| *found == sign).count())
}

/// Kovalevskaya's body, Lagrange's tops and bodies with nothing special.
fn bodies() -> Vec<Body> {
    let mut bodies = vec![
        Body::parse(&["2", "2", "1"], &["1", "0", "0"]).unwrap(),
        Body::parse(&["2", "1.1", "1"], &["0.94868", "0", "0.61623"]).unwrap(),
        Body::parse(&["1", "1", "0.5"], &["0", "0", "1"]).unwrap(),
        Body::parse(&["0.57847392", "0.53739099", "1"], &["0.00595273", "0.00176367", "-0.99998073"]).unwrap(),
    ];
    let mut random = SplitMix64::new(137);
    for stratum in [Stratum::Generic, Stratum::NearAxis, Stratum::Axis, Stratum::Lagrange] {
        bodies.extend((0..12).map(|_| random_body(&mut random, stratum)));
    }
    bodies
}

#[test]
fn the_energy_has_the_signs_that_the_morse_index_says() {
    let mut random = SplitMix64::new(138);
    let (mut pairs, mut skipped) = (std::collections::BTreeMap::new(), 0);
    for body in bodies() {
        let [r, a] = [body.center_f64(), body.moments_f64()].map(|v| v.iter().fold(0.0_f64, |m, x| m.max(x.abs())));
        for _ in 0..3 {
            let l = (random.between(0.1, 6.0) * (r * a).sqrt()).to_string().parse().unwrap();
            for point in critical(&body, &l).unwrap().list {
                if point.multiplicity != Multiplicity::Points(1) || point.stability == LinearType::DoubleElliptic {
                    continue;
                }
                let whole = Whole::new(&body, &point);
                let Some(signs) = whole.signs() else {
                    skipped += 1;
                    continue;
                };
                assert_eq!(counted(&signs), expected(&point), "{body:?} l = {l} {point:?} {signs:?}");
                let index = usize::from(point.index);
                assert_eq!(whole.signature(), [4 - index, index], "{body:?} l = {l} {point:?}");
                *pairs.entry((point.stability.word(), point.index)).or_insert(0) += 1;
            }
        }
    }
    println!("{pairs:?}, {skipped} with pairs too close to be told apart");
    for kind in [("elliptic", 0), ("elliptic", 2), ("saddle-centre", 1), ("complex", 2), ("saddle", 2)] {
        assert!(pairs.get(&kind).is_some_and(|&count| count > 4), "{kind:?}: {pairs:?}");
    }
    assert!(20 * skipped < pairs.values().sum::<i32>(), "{skipped}");
}

/// The equilibrium of a curve at l.
fn at(body: &Body, curve: &str, l: f64) -> Option<Equilibrium> {
    let list = critical(body, &l.to_string().parse().unwrap()).unwrap().list;
    list.into_iter().find(|point| point.curve.is_some_and(|name| name.to_string() == curve))
}

/// Both pairs at l on a curve: frequencies with signs, and how many eigenvalues have positive real parts.
fn beside(body: &Body, set: &CriticalSet, curve: CurveId, l: f64) -> Option<(Vec<(f64, i8)>, usize)> {
    let whole = Whole::new(body, &at(body, &CurveName::of(set, curve).to_string(), l)?);
    let eigenvalues = whole.flow.complex_eigenvalues();
    let scale = eigenvalues.iter().map(|x| x.norm()).fold(0.0, f64::max);
    Some((whole.signs()?, eigenvalues.iter().filter(|x| x.re > 1e-4 * scale).count()))
}

#[test]
fn pairs_of_opposite_sign_destabilise_where_they_meet_and_only_there() {
    let (mut hopf, mut through_zero) = (0, 0);
    for body in bodies() {
        let set = CriticalSet::new(body.frame()).unwrap();
        for change in LinearTypes::new(&body, &set).changes() {
            let onto = change.onto.unwrap_or(change.curve);
            let ends = [(change.from, change.curve, -1.0), (change.to, onto, 1.0)];
            let Some((_, curve, side)) = ends.into_iter().find(|(kind, ..)| *kind == LinearType::Elliptic) else {
                continue;
            };
            // At a cusp both curves lie on one side of it.
            let lies = |side: f64| beside(&body, &set, curve, change.l * (1.0 + side * 1e-5)).is_some();
            let side = if change.onto.is_none() || lies(side) { side } else { -side };
            // Frequencies that are about to meet fall with the root of the distance, one that vanishes at least with its fourth root.
            let l = |reach: f64| change.l * (1.0 + reach);
            let [near, far] = [1e-5, 4e-5].map(|reach| beside(&body, &set, curve, l(side * reach)));
            let (Some((signs, unstable)), Some((wider, _))) = (near, far) else { continue };
            assert_eq!((signs.len(), unstable), (2, 0), "{body:?} {change:?} {signs:?}");
            match change.kind {
                StabilityChangeKind::HamiltonianHopf => {
                    hopf += 1;
                    // They are about to meet …
                    let gap = |signs: &[(f64, i8)]| signs[1].0 - signs[0].0;
                    assert!(gap(&signs) < 0.6 * gap(&wider), "{body:?} {change:?} {signs:?}");
                    // … with opposite signs, and beyond they are off the axis.
                    assert_eq!(counted(&signs), [1, 1], "{body:?} {change:?} {signs:?}");
                    let (after, unstable) = beside(&body, &set, curve, l(-side * 1e-5)).unwrap();
                    assert_eq!((after.len(), unstable), (0, 2), "{body:?} {change:?} {after:?}");
                }
                StabilityChangeKind::Zero => {
                    through_zero += 1;
                    assert!(signs[0].0 < 0.8 * wider[0].0, "{body:?} {change:?} {signs:?}");
                }
                StabilityChangeKind::RealCollision => panic!("real pairs meet beside {signs:?}: {body:?} {change:?}"),
            }
        }
    }
    println!("{hopf} meet with opposite signs, {through_zero} pass through zero");
    assert!(hopf > 20 && through_zero > 3, "{hopf} {through_zero}");
}

/// Where A1 = 2 A2 both pairs of Lagrange's top on its axis agree at every l: above the threshold, and hanging, the energy is
/// definite, so that meeting does not destabilise.
#[test]
fn pairs_of_one_sign_meet_and_stay() {
    let body = Body::parse(&["2", "1", "1"], &["1", "0", "0"]).unwrap();
    for (l, sign, kind) in [
        ("1", 1.0, LinearType::DoubleElliptic),
        ("3", 1.0, LinearType::DoubleElliptic),
        ("3", -1.0, LinearType::DoubleElliptic),
        ("1", -1.0, LinearType::DoubleReal),
    ] {
        let list = critical(&body, &l.parse().unwrap()).unwrap().list;
        let point = list.into_iter().find(|point| point.gamma[0] == sign).unwrap();
        assert_eq!(point.stability, kind, "{point:?}");
        let definite = kind == LinearType::DoubleElliptic;
        assert_eq!(Whole::new(&body, &point).signature(), if definite { [4, 0] } else { [2, 2] }, "{point:?}");
    }
}
