//! Inertial blocks of robots' links: URDF and MJCF, in the frame of the link. Both are in kg, m, s.

mod rotation;

use bifdiag_numbers::decimal::counted;
use bifdiag_numbers::symmetric::Symmetric;
use bifdiag_numbers::{Number, ParseNumberError};
use dashu_ratio::RBig;
use roxmltree::Node;
use thiserror::Error;

use super::mass::{MassError, MassProperties};
use rotation::{of_angles, rotated};

/// Why a file gives no inertial block.
#[derive(Debug, Error)]
pub enum LinkError {
    /// The file is not XML.
    #[error("not readable as XML: {0}")]
    Xml(#[from] roxmltree::Error),
    /// The root is neither that of URDF nor that of MJCF.
    #[error("the root element is <{found}>; <robot> (URDF) or <mujoco> (MJCF) is known")]
    Root {
        /// Its name.
        found: String,
    },
    /// No block.
    #[error(
        "no {kind} of the file has an inertial block; shapes alone are not read as masses: write <inertial>, or give a mesh"
    )]
    Nothing {
        /// What has such blocks: `link` in URDF, `body` in MJCF.
        kind: &'static str,
    },
    /// Several blocks.
    #[error(
        "there is more than one {kind} with an inertial block in the file: {}; choose one by --link NAME",
        known.join(", ")
    )]
    Several {
        /// `link` or `body`.
        kind: &'static str,
        /// Their names.
        known: Vec<String>,
    },
    /// No such link.
    #[error("--link {name}: no {kind} of that name has an inertial block; those that have one: {}", known.join(", "))]
    Unknown {
        /// `link` or `body`.
        kind: &'static str,
        /// What was asked for.
        name: String,
        /// Those that are there.
        known: Vec<String>,
    },
    /// Several blocks, none with a name of its own.
    #[error(
        "there is more than one {kind} with an inertial block in the file, and none has a name of its own; give each of \
         them its own name in the file, and choose one by --link NAME"
    )]
    NoName {
        /// `link` or `body`.
        kind: &'static str,
    },
    /// Several blocks of one name.
    #[error(
        "--link {name}: more than one {kind} with an inertial block is called so; give each of them its own name in the \
         file"
    )]
    SameName {
        /// `link` or `body`.
        kind: &'static str,
        /// What was asked for.
        name: String,
    },
    /// An attribute is missing.
    #[error("<{element}> of {link} has no {attribute}")]
    Missing {
        /// The link or the body, such as `link arm`.
        link: String,
        /// The element.
        element: &'static str,
        /// The attribute.
        attribute: &'static str,
    },
    /// An attribute is not a number.
    #[error("{attribute}=\"{value}\" of {link}: {source}")]
    Number {
        /// The link or the body.
        link: String,
        /// The attribute.
        attribute: &'static str,
        /// What is written.
        value: String,
        /// What is wrong.
        source: ParseNumberError,
    },
    /// A list of numbers has the wrong length.
    #[error("{attribute}=\"{value}\" of {link} has {}, not {wanted}", counted(*found, "number", "numbers"))]
    Count {
        /// The link or the body.
        link: String,
        /// The attribute.
        attribute: &'static str,
        /// What is written.
        value: String,
        /// How many numbers it has.
        found: usize,
        /// How many are needed.
        wanted: usize,
    },
    /// The orientation is given in a form that is not supported.
    #[error("{link}: the orientation {attribute} is not read; write it as quat")]
    Orientation {
        /// The body.
        link: String,
        /// The attribute.
        attribute: &'static str,
    },
    /// Two attributes that exclude each other.
    #[error("{link}: {attribute} and {other} exclude each other; leave out one of them")]
    Both {
        /// The body.
        link: String,
        /// The attribute.
        attribute: &'static str,
        /// The other one.
        other: &'static str,
    },
    /// A quaternion of no rotation.
    #[error("{link}: the quat 0 0 0 0 is no rotation; write 1 0 0 0 for none")]
    ZeroQuaternion {
        /// The body.
        link: String,
    },
    /// The mass is not positive.
    #[error("{link}: {source}")]
    Mass {
        /// The link or the body.
        link: String,
        /// What is wrong.
        source: MassError,
    },
}

/// Reads the inertial block of a link.
type Reader = fn(Node<'_, '_>, &str) -> Result<MassProperties, LinkError>;

/// The mass properties of a link in its own frame, in kg, m, s.
///
/// # Errors
/// [`LinkError`].
pub fn read_link(text: &str, name: Option<&str>) -> Result<MassProperties, LinkError> {
    let document = roxmltree::Document::parse(text)?;
    let root = document.root_element();
    let (kind, read): (&'static str, Reader) = match root.tag_name().name() {
        "robot" => ("link", urdf),
        "mujoco" => ("body", mjcf),
        found => return Err(LinkError::Root { found: found.to_owned() }),
    };
    let links: Vec<_> = root
        .descendants()
        .filter(|node| node.has_tag_name(kind))
        .filter_map(|node| Some((node.attribute("name").unwrap_or("(unnamed)"), child(node, "inertial")?)))
        .collect();
    let is_once = |wanted: &str| links.iter().filter(|(name, _)| *name == wanted).count() == 1;
    let known = || links.iter().map(|(name, _)| (*name).to_owned()).collect();
    let (name, block) = match (name, &links[..]) {
        (_, []) => return Err(LinkError::Nothing { kind }),
        (None, [only]) => *only,
        (None, _) if !links.iter().any(|(name, _)| is_once(name)) => return Err(LinkError::NoName { kind }),
        (None, _) => return Err(LinkError::Several { kind, known: known() }),
        (Some(wanted), _) => {
            let mut found = links.iter().filter(|(name, _)| *name == wanted);
            match (found.next(), found.next()) {
                (None, _) => return Err(LinkError::Unknown { kind, name: wanted.to_owned(), known: known() }),
                (Some(_), Some(_)) => return Err(LinkError::SameName { kind, name: wanted.to_owned() }),
                (Some(only), None) => *only,
            }
        }
    };
    read(block, &format!("{kind} {name}"))
}

/// URDF: the tensor is about the centre of mass, its products are entries of the tensor, its axes those of the block's
/// `origin`.
fn urdf(block: Node<'_, '_>, link: &str) -> Result<MassProperties, LinkError> {
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

/// MJCF: `diaginertia` in the axes of `quat`, or `fullinertia` in the axes of the body, about the centre of mass. With
/// `fullinertia` the format has neither of the others.
fn mjcf(block: Node<'_, '_>, link: &str) -> Result<MassProperties, LinkError> {
    let missing = |attribute| LinkError::Missing { link: link.to_owned(), element: "inertial", attribute };
    for attribute in ["axisangle", "xyaxes", "zaxis", "euler"] {
        if block.has_attribute(attribute) {
            return Err(LinkError::Orientation { link: link.to_owned(), attribute });
        }
    }
    let others = ["diaginertia", "quat"].into_iter().find(|other| block.has_attribute(*other));
    if let (Some(attribute), true) = (others, block.has_attribute("fullinertia")) {
        return Err(LinkError::Both { link: link.to_owned(), attribute, other: "fullinertia" });
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
                return Err(LinkError::ZeroQuaternion { link: link.to_owned() });
            }
            rotated(&tensor, &quat)
        }
        None => tensor,
    };
    MassProperties::about_com(mass, com, tensor).map_err(|source| LinkError::Mass { link: link.to_owned(), source })
}

/// The first child of that name.
fn child<'a, 'input>(node: Node<'a, 'input>, tag: &str) -> Option<Node<'a, 'input>> {
    node.children().find(|child| child.has_tag_name(tag))
}

/// The numbers of an attribute, exactly.
fn list<const N: usize>(link: &str, attribute: &'static str, value: &str) -> Result<[RBig; N], LinkError> {
    let mut numbers = Vec::with_capacity(N);
    for word in value.split_whitespace() {
        let number: Number = word.parse().map_err(|source| LinkError::Number {
            link: link.to_owned(),
            attribute,
            value: value.to_owned(),
            source,
        })?;
        numbers.push(number.value().clone());
    }
    numbers.try_into().map_err(|numbers: Vec<RBig>| LinkError::Count {
        link: link.to_owned(),
        attribute,
        value: value.to_owned(),
        found: numbers.len(),
        wanted: N,
    })
}
