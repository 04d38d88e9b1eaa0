//! Classes that have a name of their own.

use std::collections::BTreeMap;

use bifdiag_body::Preset;
use bifdiag_diagram::class::{Class, ClassName};
use bifdiag_exact::Accuracy;

/// The classes of the named bodies; of several bodies of one class the first.
#[must_use]
pub fn known_classes() -> BTreeMap<ClassName, &'static Preset> {
    let mut known = BTreeMap::new();
    for preset in Preset::all() {
        let class = bifdiag_exact::atlas(&preset.body(), Accuracy::Fast).ok().and_then(|atlas| Class::of(&atlas).ok());
        if let Some(class) = class {
            known.entry(class.name().clone()).or_insert(preset);
        }
    }
    known
}
