//! MJCF: `diaginertia` in the axes of `quat`, or `fullinertia` in the axes of the body, about the centre of mass.

use bifdiag_numbers::symmetric::Symmetric;
use dashu_ratio::RBig;
use roxmltree::Node;

use super::error::LinkError;
use super::rotation::rotated;
use super::xml::list;
use crate::part::mass::MassProperties;

pub(super) fn properties(block: Node<'_, '_>, link: &str) -> Result<MassProperties, LinkError> {
    let missing = |attribute| LinkError::Missing { link: link.to_owned(), element: "inertial", attribute };
    for attribute in ["axisangle", "xyaxes", "zaxis", "euler"] {
        if block.has_attribute(attribute) {
            return Err(LinkError::Orientation { link: link.to_owned(), attribute });
        }
    }
    let mass = block.attribute("mass").ok_or_else(|| missing("mass"))?;
    let [mass] = list::<1>(link, "mass", mass)?;
    let com = list::<3>(link, "pos", block.attribute("pos").ok_or_else(|| missing("pos"))?)?;
    let tensor = match (block.attribute("fullinertia"), block.attribute("diaginertia")) {
        (Some(full), _) => Symmetric::new(list::<6>(link, "fullinertia", full)?),
        (None, Some(diagonal)) => Symmetric::diagonal(list::<3>(link, "diaginertia", diagonal)?),
        (None, None) => return Err(missing("diaginertia or fullinertia")),
    };
    let tensor = match block.attribute("quat") {
        Some(quat) => {
            let quat = list::<4>(link, "quat", quat)?;
            if quat.iter().all(RBig::is_zero) {
                return Err(missing("quat that is not zero"));
            }
            rotated(&tensor, &quat)
        }
        None => tensor,
    };
    MassProperties::about_com(mass, com, tensor).map_err(|source| LinkError::Mass { link: link.to_owned(), source })
}
