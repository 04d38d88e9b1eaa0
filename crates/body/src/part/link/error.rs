//! Why a file gives no inertial block.

use bifdiag_numbers::ParseNumberError;
use thiserror::Error;

use crate::part::mass::MassError;

/// Why a file gives no inertial block.
#[derive(Debug, Error)]
pub enum LinkError {
    /// Not XML.
    #[error("not readable as XML: {0}")]
    Xml(#[from] roxmltree::Error),
    /// Neither a robot nor a model.
    #[error("the root element is <{found}>; <robot> (URDF) or <mujoco> (MJCF) is known")]
    Root {
        /// Its name.
        found: String,
    },
    /// No block.
    #[error(
        "no link of the file has an inertial block; shapes alone are not read as masses: write <inertial>, or give a mesh"
    )]
    Nothing,
    /// Several blocks.
    #[error("the file has several links with an inertial block: {}; choose one by --link NAME", known.join(", "))]
    Several {
        /// Their names.
        known: Vec<String>,
    },
    /// No such link.
    #[error("--link {name}: no link of that name has an inertial block; there are {}", known.join(", "))]
    Unknown {
        /// What was asked for.
        name: String,
        /// Those that are there.
        known: Vec<String>,
    },
    /// An attribute is missing.
    #[error("<{element}> of link {link} has no {attribute}")]
    Missing {
        /// The link.
        link: String,
        /// The element.
        element: &'static str,
        /// The attribute.
        attribute: &'static str,
    },
    /// An attribute is no number or not so many.
    #[error("{attribute}=\"{value}\" of link {link}: {source}")]
    Number {
        /// The link.
        link: String,
        /// The attribute.
        attribute: &'static str,
        /// What is written.
        value: String,
        /// What is wrong.
        source: ParseNumberError,
    },
    /// A list of another length.
    #[error("{attribute}=\"{value}\" of link {link} has {found} numbers, {wanted} are needed")]
    Count {
        /// The link.
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
    /// An orientation that is not read.
    #[error(
        "link {link}: the orientation {attribute} is not read, since its meaning depends on other settings; write quat"
    )]
    Orientation {
        /// The link.
        link: String,
        /// The attribute.
        attribute: &'static str,
    },
    /// No mass.
    #[error("link {link}: {source}")]
    Mass {
        /// The link.
        link: String,
        /// What is wrong.
        source: MassError,
    },
}
