//! Inertial blocks of robots' links: URDF and MJCF, in the frame of the link. Both are in kg, m, s.

mod error;
mod mjcf;
mod rotation;
mod urdf;
mod xml;

use crate::part::mass::MassProperties;
use xml::child;

pub use error::LinkError;

/// Reads the inertial block of a link.
type Reader = fn(roxmltree::Node<'_, '_>, &str) -> Result<MassProperties, LinkError>;

/// The mass properties of a link in its own frame, in kg, m, s.
///
/// # Errors
/// [`LinkError`].
pub fn read_link(text: &str, name: Option<&str>) -> Result<MassProperties, LinkError> {
    let document = roxmltree::Document::parse(text)?;
    let root = document.root_element();
    let (tag, read): (&str, Reader) = match root.tag_name().name() {
        "robot" => ("link", urdf::properties),
        "mujoco" => ("body", mjcf::properties),
        found => return Err(LinkError::Root { found: found.to_owned() }),
    };
    let links: Vec<_> = root
        .descendants()
        .filter(|node| node.has_tag_name(tag))
        .filter_map(|node| Some((node.attribute("name").unwrap_or("(unnamed)"), child(node, "inertial")?)))
        .collect();
    let known = || links.iter().map(|(name, _)| (*name).to_owned()).collect();
    let (name, block) = match (name, &links[..]) {
        (_, []) => return Err(LinkError::Nothing),
        (None, [only]) => *only,
        (None, _) => return Err(LinkError::Several { known: known() }),
        (Some(wanted), _) => {
            let found = links.iter().find(|(name, _)| *name == wanted);
            *found.ok_or_else(|| LinkError::Unknown { name: wanted.to_owned(), known: known() })?
        }
    };
    read(block, name)
}
