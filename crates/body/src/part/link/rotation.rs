//! Rotations of tensors by rational matrices that are exactly orthogonal, so that moments stay what they are.

use bifdiag_numbers::symmetric::Symmetric;
use dashu_ratio::RBig;

/// R T Rᵀ with the rotation of a quaternion (w, x, y, z) of any length but 0: R = (w² − |v|²) E + 2 v vᵀ + 2 w [v×] over
/// w² + |v|².
pub(super) fn rotated(tensor: &Symmetric, [w, x, y, z]: &[RBig; 4]) -> Symmetric {
    let v = [x, y, z];
    let squared = x * x + y * y + z * z;
    let length = w * w + &squared;
    let two = RBig::from(2);
    let skew = |i: usize, j: usize| match (3 + j - i) % 3 {
        0 => RBig::ZERO,
        1 => -v[3 - i - j].clone(),
        _ => v[3 - i - j].clone(),
    };
    let r: [[RBig; 3]; 3] = std::array::from_fn(|i| {
        std::array::from_fn(|j| {
            let diagonal = if i == j { w * w - &squared } else { RBig::ZERO };
            (diagonal + &two * v[i] * v[j] + &two * w * skew(i, j)) / &length
        })
    });
    tensor.map(|i, j, _| {
        let row = tensor.times(&r[j]);
        (0..3).fold(RBig::ZERO, |sum, k| sum + &r[i][k] * &row[k])
    })
}

/// The quaternion of roll, pitch and yaw about the fixed axes x, y, z, from tan(angle/2) in f64: exactly a rotation, and
/// the wanted one within 1e-16 of each angle.
pub(super) fn of_angles([roll, pitch, yaw]: &[RBig; 3]) -> [RBig; 4] {
    let about = |angle: &RBig, axis: usize| {
        let tangent = RBig::try_from(libm::tan(0.5 * angle.to_f64().value())).unwrap_or(RBig::ZERO);
        let mut q = [RBig::ONE, RBig::ZERO, RBig::ZERO, RBig::ZERO];
        q[axis] = tangent;
        q
    };
    times(&about(yaw, 3), &times(&about(pitch, 2), &about(roll, 1)))
}

fn times(p: &[RBig; 4], q: &[RBig; 4]) -> [RBig; 4] {
    [
        &p[0] * &q[0] - &p[1] * &q[1] - &p[2] * &q[2] - &p[3] * &q[3],
        &p[0] * &q[1] + &p[1] * &q[0] + &p[2] * &q[3] - &p[3] * &q[2],
        &p[0] * &q[2] - &p[1] * &q[3] + &p[2] * &q[0] + &p[3] * &q[1],
        &p[0] * &q[3] + &p[1] * &q[2] - &p[2] * &q[1] + &p[3] * &q[0],
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_turn_about_z_by_a_quarter_exchanges_x_and_y() {
        let tensor = Symmetric::diagonal([1, 2, 3].map(RBig::from));
        let quarter = [1, 0, 0, 1].map(RBig::from);
        assert_eq!(rotated(&tensor, &quarter), Symmetric::diagonal([2, 1, 3].map(RBig::from)));
    }

    #[test]
    fn angles_turn_about_fixed_axes_in_the_order_of_urdf() {
        // R = Rz(yaw) Ry(pitch) Rx(roll): roll and yaw by 90° take x to y and y to z.
        let quarter = RBig::try_from(std::f64::consts::FRAC_PI_2).unwrap();
        let q = of_angles(&[quarter.clone(), RBig::ZERO, quarter]);
        let turned = rotated(&Symmetric::diagonal([1, 2, 3].map(RBig::from)), &q);
        let rows = turned.rows().each_ref().map(|row| row.each_ref().map(|x| x.to_f64().value()));
        for (i, wanted) in [3.0, 1.0, 2.0].into_iter().enumerate() {
            assert!((rows[i][i] - wanted).abs() < 1e-15, "{rows:?}");
        }
        // Exactly a rotation.
        assert_eq!(turned.determinant(), RBig::from(6));
        assert_eq!(turned.trace(), RBig::from(6));
    }
}
