//! Eigenvalues and principal axes of symmetric matrices against planted ones.

use bifdiag_numbers::symmetric::{PrincipalAxes, Real, Symmetric, dot};
use dashu_ratio::RBig;
use proptest::prelude::*;

fn whole(n: i64) -> RBig {
    RBig::from(n)
}

/// The columns of (1 + |q|²) times Cayley's rational rotation of the vector q.
fn rotation(q: [i64; 3]) -> ([[RBig; 3]; 3], RBig) {
    let squared = q.iter().map(|x| x * x).sum::<i64>();
    let skew = |i: usize, j: usize| match (3 + j - i) % 3 {
        0 => 0,
        1 => -q[3 - i - j],
        _ => q[3 - i - j],
    };
    let entry = |i: usize, j: usize| i64::from(i == j) * (1 - squared) + 2 * q[i] * q[j] + 2 * skew(i, j);
    let column = |j: usize| std::array::from_fn(|i| whole(entry(i, j)));
    ([column(0), column(1), column(2)], whole(1 + squared))
}

/// Q diag(values) Qᵀ and Q v, exactly.
fn tilted(values: [i64; 3], v: [i64; 3], q: [i64; 3]) -> (Symmetric, [RBig; 3]) {
    let (columns, scale) = rotation(q);
    let zero = Symmetric::diagonal([RBig::ZERO, RBig::ZERO, RBig::ZERO]);
    let weight = |k: usize| whole(values[k]) / (&scale * &scale);
    let matrix = (0..3).fold(zero, |sum, k| sum.plus(&weight(k), &Symmetric::outer(&columns[k])));
    let vector = std::array::from_fn(|i| (0..3).fold(RBig::ZERO, |sum, k| sum + whole(v[k]) * &columns[k][i]) / &scale);
    (matrix, vector)
}

fn magnitude(x: &RBig) -> RBig {
    x.clone().max(-x.clone())
}

proptest! {
    /// Rational moments in axes turned by a rational rotation: all found, exactly; the components are those planted.
    #[test]
    fn planted_moments_and_components_are_found(
        mut values in prop::array::uniform3(1i64..9),
        v in prop::array::uniform3(-3i64..4),
        q in prop::array::uniform3(-4i64..5),
    ) {
        let (matrix, vector) = tilted(values, v, q);
        let found = PrincipalAxes::new(&matrix, &vector, 30);
        if !matrix.is_diagonal() {
            let mut planted: Vec<(i64, i64)> = values.into_iter().zip(v.map(|x| x * x)).collect();
            planted.sort_unstable();
            values.sort_unstable();
            for k in 0..3 {
                prop_assert_eq!(&found.values[k], &Real::exact(whole(values[k])));
            }
            // The squared length in each eigenspace.
            for value in values {
                let wanted: i64 = planted.iter().filter(|(other, _)| *other == value).map(|(_, x)| x).sum();
                let own = (0..3).filter(|&k| found.values[k].lo == whole(value));
                let [lo, hi] = own.fold([RBig::ZERO, RBig::ZERO], |[lo, hi], k| {
                    let c = &found.components[k];
                    let (a, b) = (magnitude(&c.lo), magnitude(&c.hi));
                    let (a, b) = (a.clone().min(b.clone()), a.max(b));
                    [lo + &a * &a, hi + &b * &b]
                });
                prop_assert!(lo <= whole(wanted) && whole(wanted) <= hi, "{wanted} for {value}");
            }
        }
        check_axes(&matrix, &vector, &found)?;
    }

    /// Any matrix: the enclosures hold D(lo) D(hi) ≤ 0, the axes are those of the eigenvalues.
    #[test]
    fn irrational_moments_are_enclosed(
        entries in prop::array::uniform6(-50i64..50),
        v in prop::array::uniform3(-9i64..10),
    ) {
        let matrix = Symmetric::new(entries.map(whole));
        let vector = v.map(whole);
        let found = PrincipalAxes::new(&matrix, &vector, 40);
        let d = matrix.characteristic();
        let at = |x: &RBig| ((&d[3] * x + &d[2]) * x + &d[1]) * x + &d[0];
        for value in &found.values {
            prop_assert!(at(&value.lo) * at(&value.hi) <= RBig::ZERO);
            prop_assert!(value.is_known_to(40));
        }
        check_axes(&matrix, &vector, &found)?;
    }
}

/// A v = μ v, right-handed orthonormal axes, and components that are the vector's.
fn check_axes(matrix: &Symmetric, vector: &[RBig; 3], found: &PrincipalAxes) -> Result<(), TestCaseError> {
    let a = matrix.rows().each_ref().map(|row| row.each_ref().map(|x| x.to_f64().value()));
    let v = vector.each_ref().map(|x| x.to_f64().value());
    let size = 1.0 + a.iter().flatten().fold(0.0_f64, |m, x| m.max(x.abs()));
    let product = |x: &[f64; 3], y: &[f64; 3]| x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
    for k in 0..3 {
        let axis = &found.axes[k];
        for i in 0..3 {
            prop_assert!((product(&a[i], axis) - found.values[k].to_f64() * axis[i]).abs() < 1e-14 * size);
            prop_assert!((product(axis, &found.axes[i]) - f64::from(u8::from(i == k))).abs() < 1e-14);
        }
        prop_assert!(
            (product(axis, &v) - found.components[k].to_f64()).abs()
                < 1e-13 * (1.0 + dot(vector, vector).to_f64().value())
        );
    }
    for (square, component) in found.squares.iter().zip(&found.components) {
        if let Some(square) = square {
            // The component is enclosed, and its square with it.
            let [lo, hi] = [&component.lo, &component.hi].map(|x| x * x);
            let (least, most) = if lo <= hi { (lo, hi) } else { (hi, lo) };
            prop_assert!(least <= *square && *square <= most);
        }
    }
    let [x, y, z] = &found.axes;
    let cross = [x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]];
    prop_assert!(product(&cross, z) > 0.99);
    Ok(())
}

/// Two moments 10⁻⁴⁰ apart stay two, with their difference known.
#[test]
fn a_small_gap_is_kept() {
    let small = RBig::from_parts(1.into(), dashu_int::UBig::from(10u8).pow(40));
    let one = || RBig::ONE;
    let matrix = Symmetric::new([one(), one(), whole(3), small.clone(), RBig::ZERO, RBig::ZERO]);
    let found = PrincipalAxes::new(&matrix, &[one(), one(), one()], 30);
    let gap = &found.values[1].lo - &found.values[0].hi;
    assert!(magnitude(&(gap / small / whole(2) - one())) < RBig::from_parts(1.into(), 1_000_000u32.into()));
    // (1, 1, 1) is orthogonal to (1, −1, 0).
    assert_eq!(found.components[0], Real::exact(RBig::ZERO));
}
