//! Elements and exact numbers of attributes.

use bifdiag_numbers::Number;
use dashu_ratio::RBig;

use super::error::LinkError;

/// The first child of that name.
pub(super) fn child<'a, 'input>(node: roxmltree::Node<'a, 'input>, tag: &str) -> Option<roxmltree::Node<'a, 'input>> {
    node.children().find(|child| child.has_tag_name(tag))
}

/// The numbers of an attribute, exactly.
pub(super) fn list<const N: usize>(link: &str, attribute: &'static str, value: &str) -> Result<[RBig; N], LinkError> {
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
