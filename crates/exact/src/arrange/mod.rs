//! The arrangement: events in proved order, vertical orders, faces.

mod apart;
mod arrangement;
mod event;
mod glue;
mod pairs;
mod single;
mod slab;
mod stages;
mod undecided;

pub(crate) use arrangement::{Arrangement, arrange};
pub(crate) use event::{Event, Source};
pub(crate) use slab::Slab;
pub(crate) use stages::STAGES;
pub(crate) use undecided::Undecided;
