//! What the tests, examples and benchmarks of several packages share: bodies of every stratum that shrink, points planted
//! beside their curves, random bodies for campaigns and benchmarks, a flood fill as an independent method, other methods of
//! integration, and the files of `data/`.

// A panic is a failed test.
#![allow(clippy::missing_panics_doc)]

pub mod aim;
pub mod bodies;
pub mod flood_fill;
pub mod katok;
#[cfg(feature = "peers")]
pub mod peers;
pub mod property;
pub mod random;
pub mod sanity;
#[cfg(feature = "survey")]
pub mod special;
pub mod strata;

/// The text of a file of the repository's folder `data/`.
#[must_use]
pub fn data(path: &str) -> String {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../../data/").to_owned() + path;
    std::fs::read_to_string(&file).unwrap_or_else(|error| panic!("{file}: {error}"))
}
