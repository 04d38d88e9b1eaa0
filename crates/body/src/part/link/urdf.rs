//! URDF: the tensor is about the centre of mass, its products are entries of the tensor, its axes those of the block's
//! `origin`.

use bifdiag_numbers::symmetric::Symmetric;
use dashu_ratio::RBig;
use roxmltree::Node;

use super::error::LinkError;
use super::rotation::{of_angles, rotated};
use super::xml::{child, list};
use crate::part::mass::MassProperties;

pub(super) fn properties(block: Node<'_, '_>, link: &str) -> Result<MassProperties, LinkError> {
    let attribute = |element: &'static str, attribute: &'static str| {
        let missing = || LinkError::Missing { link: link.to_owned(), element, attribute };
        child(block, element).and_then(|node| node.attribute(attribute)).ok_or_else(missing)
    };
    let one = |element, name| list::<1>(link, name, attribute(element, name)?).map(|[x]| x);
    let origin = |name: &'static str| match child(block, "origin").and_then(|node| node.attribute(name)) {
        Some(value) => list::<3>(link, name, value),
        None => Ok([RBig::ZERO, RBig::ZERO, RBig::ZERO]),
    };
    let mass = one("mass", "value")?;
    let mut entries = Vec::with_capacity(6);
    for name in ["ixx", "iyy", "izz", "ixy", "ixz", "iyz"] {
        entries.push(one("inertia", name)?);
    }
    let entries = <[RBig; 6]>::try_from(entries).unwrap_or_else(|_| unreachable!("six entries"));
    let (com, angles) = (origin("xyz")?, origin("rpy")?);
    let tensor = Symmetric::new(entries);
    let tensor = if angles.iter().all(RBig::is_zero) { tensor } else { rotated(&tensor, &of_angles(&angles)) };
    MassProperties::about_com(mass, com, tensor).map_err(|source| LinkError::Mass { link: link.to_owned(), source })
}
