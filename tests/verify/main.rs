//! `verify` confirms atlases with certificates and refuses false ones.

mod claims;
mod confirmed;
mod fields;
mod made;
mod points;
