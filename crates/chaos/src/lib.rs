//! The chaotic share of the components of an energy surface, in Liouville measure, at a point of the (h, l) plane and over it.
