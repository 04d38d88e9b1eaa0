//! The JSON documents made from results: names, units and words; nothing is decided here.

pub mod atlas;
mod body;
mod border;
mod certified;
mod chaos;
mod classes;
mod classification;
pub mod codes;
mod comparison;
mod critical;
mod find;
mod grid;
mod integrals;
pub mod layout;
mod orbit_catalogue;
mod orbit_list;
mod periodic;
mod proved;
pub mod reading;
pub mod scan;
mod section;
mod spin;
mod spin_down;
mod stability;
mod steady;
mod subject;
mod witnesses;
pub mod words;

pub use atlas::{DocumentOptions, Drawn, attach_part};
pub use bifdiag_schema::CommandLine;
pub use body::{all_bodies, given, head, part, texts, version};
pub use border::border;
pub use certified::{certified_atlas, certified_atlas_of, leave_out_drawing, proved_point, seal};
pub use chaos::{chaos_cell, chaos_map, chaos_point};
pub use classes::{add_text, shipped_classes, standing};
pub use classification::{accuracy_option, classification, component, components, margin};
pub use comparison::{Compared, comparison};
pub use critical::{critical, equilibria, steady_axes};
pub use find::{find, witness};
pub use grid::{GridAxis, grid};
pub use integrals::{further_integrals, integrable, integrable_words};
pub use orbit_catalogue::{Asked, families_listed, periodic_list};
pub use orbit_list::periodic;
pub use periodic::{periodic_families, periodic_orbit};
pub use proved::{EnclosureRow, ProofAsked, USUAL_BOUND, enclosure_rows, enclosures, proved_motion};
pub use section::{chaos, drift, integrator, section, sections, tolerance_option};
pub use spin::{
    asked_spin, changes_beside, measured_command, measured_tolerance, spin, spin_changes, spin_stretches, tolerance,
    tolerance_beside, type_name,
};
pub use spin_down::spin_down;
pub use stability::{friction, nonlinear};
pub use steady::{steady_families, steady_spins};
pub use subject::Subject;
pub use witnesses::{ReadWitnessError, read_witness, shipped_witnesses};
