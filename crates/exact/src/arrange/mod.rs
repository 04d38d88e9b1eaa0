//! The arrangement: events in proved order, vertical orders, faces.

mod apart;
mod arrangement;
mod event;
mod glue;
mod slab;
mod stages;

pub(crate) use arrangement::{Arrangement, arrange};
pub(crate) use event::{Event, EventSource, Undecided};
pub(crate) use slab::Slab;
pub(crate) use stages::STAGES;
