//! Pictures of finished results: the bifurcation diagram of an atlas, Poincaré sections and maps, as SVG,
//! PNG and, with the feature `pdf`, PDF.
//!
//! What is drawn of an atlas comes from [`bifdiag_schema`] alone, what is drawn of a section from its portrait and its
//! crossings; nothing is computed here that these do not say already. Every picture is drawn on a [`page`], which knows nothing of what
//! it shows, and becomes a [`Picture`]; other pictures can be drawn on it too.

mod animation;
mod campbell;
mod chaos;
mod diagram;
mod map;
mod part;
mod periods;
mod section;
mod sphere;
mod steady;

pub use animation::{AnimatedCrossing, AnimationScene, draw_animation, draw_frame};
pub use bifdiag_page as page;
pub use bifdiag_page::{
    Caption, Figure, Picture, Pixels, PlotError, Theme, Width, body_line, section_type, value_text,
};
pub use campbell::{Campbell, CampbellRow, draw_campbell};
pub use chaos::{ChaosCell, ChaosPanel, ChaosScene, draw_chaos};
pub use diagram::{
    CurveSource, DashPattern, DiagramDescription, DiagramLabel, DiagramOptions, DiagramStroke, DiagramSymbol,
    DiagramTitle, DiagramView, LabelBoxes, LegendPlace, MarkedPoints, PanelTicks, StraightColumn, StraightDiagram,
    StraightPanel, StraightShares, chosen_view, describe, describe_panel, draw, draw_codes, draw_figure,
    straight_diagram,
};
pub use map::{Map, MapAxis, MapBodies, MapEntry, MapLine, MapNote, draw_map};
pub use part::{PartScene, draw_part};
pub use periods::draw_periods;
pub use section::{
    OrbitColors, OrbitFamilies, OrbitValues, Projection, SectionCurves, SectionOptions, SectionScene, draw_section,
    draw_section_rows,
};
pub use sphere::{SphereScene, draw_sphere};
pub use steady::{Steadiness, SteadyCurve, SteadyScene, draw_steady};
