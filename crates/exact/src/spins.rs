//! What changes with the spin of rotation about an axis: types, and with an atlas the regions beside it.

use bifdiag_body::Body;
use bifdiag_diagram::atlas::Atlas;
use bifdiag_diagram::region_changes::{RotationChange, rotation_changes};
use bifdiag_equilibria::critical::{Multiplicity, RelativeEquilibria, SteadyFamily};
use bifdiag_equilibria::curves::BranchName;
use bifdiag_equilibria::nonlinear::VerdictChange;
use bifdiag_equilibria::permanent::{
    AxisEnd, AxisKind, AxisRotation, OneSpin, PermanentAxis, SpinType, fastest_along, permanent_axes,
};
use bifdiag_numbers::Sign;
use dashu_ratio::RBig;

use crate::answers::Accuracy;
use crate::solver::Solver;

/// Rotation about a permanent axis with one end up.
#[derive(Clone, Debug)]
pub struct EndUp {
    /// That end.
    pub end: AxisEnd,
    /// The rotation.
    pub rotation: AxisRotation,
    /// Everything that changes with its spin, by rising spin.
    pub changes: Vec<RotationChange>,
}

impl EndUp {
    /// For an axis with its direction up, and with the other end up; without an atlas only types are known.
    #[must_use]
    pub fn both(body: &Body, axis: PermanentAxis, atlas: Option<&Atlas>) -> Option<[Self; 2]> {
        // γ points down.
        let up = |end, gamma| {
            let rotation = AxisRotation::about(body, axis, gamma)?;
            let changes = rotation_changes(&rotation, atlas);
            Some(Self { end, rotation, changes })
        };
        Some([up(AxisEnd::Plus, Sign::Negative)?, up(AxisEnd::Minus, Sign::Positive)?])
    }

    /// The type at the slowest spins.
    #[must_use]
    pub fn slowest(&self) -> SpinType {
        self.rotation.own(self.rotation.slowest_type())
    }
}

/// Rotation about one axis over the spin.
#[derive(Clone, Debug)]
pub struct AxisSpins {
    /// The direction of the question, in principal axes.
    pub up: [f64; 3],
    /// What it is; a permanent axis within half a degree is followed in its place.
    pub kind: AxisKind,
    /// What it is itself.
    pub itself: AxisKind,
    /// The spin at which rotation about the axis itself is steady.
    pub one_spin: Option<OneSpin>,
    /// For a permanent axis: both ends.
    pub ends: Option<[EndUp; 2]>,
    /// For another axis: the families of steady rotations nearest to each of its ends at fast spins, several if they are
    /// equally near, none if all become perpendicular to it; `None` where the families of the body are not all known.
    pub beside: Option<[Vec<SteadyFamily>; 2]>,
    /// The isolated relative equilibria of the body to which Arnold's theorem does not apply; `None` where not all were found.
    pub exceptions: Option<Vec<(BranchName, VerdictChange)>>,
    /// The regions of the body are known; a permanent axis needs its neighbours.
    pub has_regions: bool,
}

impl AxisSpins {
    /// For the axis along `up` in principal axes; `exact` is the same in the axes in which the body was given, of any length.
    #[must_use]
    pub fn new(body: &Body, up: [f64; 3], exact: &[RBig; 3]) -> Self {
        let (kind, itself) = (AxisKind::followed(body, up, exact), AxisKind::of(body, up, exact));
        let prepared = RelativeEquilibria::new(body).ok();
        let exceptions = prepared.as_ref().and_then(RelativeEquilibria::exceptions);
        let one_spin = if let AxisKind::AtOneSpin(axis) = &itself { OneSpin::of(body, axis, exact) } else { None };
        let mut spins = Self { up, kind, itself, one_spin, ends: None, beside: None, exceptions, has_regions: false };
        if let AxisKind::Permanent { axis, .. } = kind {
            let solver = Solver::new(body.clone(), Accuracy::Exact);
            spins.has_regions = solver.atlas().is_some();
            spins.ends = EndUp::both(body, axis, solver.atlas());
        } else {
            let families = prepared.as_ref().and_then(RelativeEquilibria::families);
            let nearest =
                |families: Vec<SteadyFamily>| [up, up.map(|x| -x)].map(|up| fastest_along(body, &families, up));
            spins.beside = families.map(nearest);
        }
        spins
    }

    /// The one family that is nearest to each end at fast spins.
    #[must_use]
    pub fn nearest(&self) -> Option<[&SteadyFamily; 2]> {
        let [[plus], [minus]] = self.beside.as_ref()?.each_ref().map(Vec::as_slice) else { return None };
        Some([plus, minus])
    }

    /// These where bodies with other moments have them too: no circle or sphere of axes remains when its moments become different.
    #[must_use]
    pub fn nearest_isolated(&self) -> Option<[&SteadyFamily; 2]> {
        self.nearest().filter(|both| both.iter().all(|family| matches!(family.axes, Multiplicity::Points(_))))
    }

    /// The families beside the axis, each once: of a circle of axes the other end is shown by the same.
    pub fn families(&self) -> impl Iterator<Item = &SteadyFamily> {
        let [plus, minus] = self.beside.as_ref().map_or([&[][..]; 2], |both| both.each_ref().map(Vec::as_slice));
        plus.iter().chain(minus.iter().filter(|family| family.axes != Multiplicity::Circle))
    }
}

/// All steady axes of a body over the spin.
#[derive(Clone, Debug)]
pub struct AllSpins {
    /// Families of steady axes.
    pub families: Vec<SteadyFamily>,
    /// The axes that are permanent at every spin, of a circle of them one, with both ends.
    pub permanent: Vec<(PermanentAxis, [EndUp; 2])>,
    /// The isolated relative equilibria of the body to which Arnold's theorem does not apply; `None` where not all were found.
    pub exceptions: Option<Vec<(BranchName, VerdictChange)>>,
    /// The regions of the body are known; a permanent axis needs its neighbours.
    pub has_regions: bool,
}

impl AllSpins {
    /// For a body whose relative equilibria are prepared; `None` where roots are too close to tell its families apart.
    #[must_use]
    pub fn new(body: &Body, prepared: &RelativeEquilibria<'_>) -> Option<Self> {
        let families = prepared.families()?;
        let axes = permanent_axes(body, &families);
        let solver = Solver::new(body.clone(), Accuracy::Exact);
        let atlas = if axes.is_empty() { None } else { solver.atlas() };
        let ends = |axis: PermanentAxis| Some((axis, EndUp::both(body, axis, atlas)?));
        Some(Self {
            permanent: axes.into_iter().filter_map(ends).collect(),
            exceptions: prepared.exceptions(),
            has_regions: atlas.is_some(),
            families,
        })
    }
}
