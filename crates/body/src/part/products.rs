//! The two conventions of the products of inertia.

use bifdiag_numbers::symmetric::Symmetric;
use dashu_ratio::RBig;

/// What the three products of a list Ixx, Iyy, Izz, Ixy, Ixz, Iyz are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Products {
    /// Entries of the tensor: Ixy = −∫ x y dm.
    Tensor,
    /// The integrals: Ixy = +∫ x y dm.
    Integral,
}

/// The tensor of a list Ixx, Iyy, Izz, Ixy, Ixz, Iyz.
#[must_use]
pub fn tensor_of(list: [RBig; 6], products: Products) -> Symmetric {
    match products {
        Products::Tensor => Symmetric::new(list),
        Products::Integral => {
            let [xx, yy, zz, xy, xz, yz] = list;
            Symmetric::new([xx, yy, zz, -xy, -xz, -yz])
        }
    }
}
