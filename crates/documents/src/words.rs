//! Topology and motions in words.

use bifdiag_diagram::arrangement::RegionId;
use bifdiag_diagram::atlas::{Atlas, Passage};
use bifdiag_equilibria::curves::CurveName;
pub use bifdiag_numbers::decimal::counted;
use bifdiag_numbers::table::Id;
use bifdiag_schema::{
    AtlasDocument, CellDocument, ComponentDocument, CurveDocument, CurveKind, Damped, EventDocument, Failing,
    FrictionDocument, NonlinearDocument, NonlinearVerdict, Reason, RegionDocument,
};

/// How many relative equilibria there are at most at one l.
#[must_use]
pub fn most_equilibria(document: &AtlasDocument) -> String {
    let is_set = |curve: &CurveDocument| matches!(curve.kind, CurveKind::Circle | CurveKind::Sphere);
    // At rest without weight all of S² is critical.
    let at = if document.body.flags.euler { "one l > 0" } else { "one l" };
    let once = if document.curves.iter().any(is_set) { " (a circle or sphere of them counted once)" } else { "" };
    let most = counted(document.summary.critical_points_max, "relative equilibrium", "relative equilibria");
    format!("at most {most} at {at}{once}")
}

/// What lies over one component of U.
#[must_use]
pub fn component(component: &ComponentDocument) -> [String; 3] {
    let poles = match component.poles.as_deref() {
        None => String::new(),
        Some([]) => ", without poles".to_owned(),
        Some([pole]) => format!(", with the pole {pole}r̂"),
        Some(_) => ", with both poles".to_owned(),
    };
    let shape = match component.boundary_circles {
        0 => "the whole sphere".to_owned(),
        1 => "a disc".to_owned(),
        2 => "an annulus".to_owned(),
        circles => format!("a sphere without {circles} discs"),
    };
    let surface = match component.boundary_circles {
        0 => "the rotations of space".to_owned(),
        1 => "a three-sphere".to_owned(),
        2 => "a sphere times a circle".to_owned(),
        circles => format!("the connected sum of {} copies of a sphere times a circle", circles - 1),
    };
    let section = match (&component.section, component.genus) {
        (Some(name), Some(0)) => format!("P: {name}, a sphere"),
        (Some(name), Some(1)) => format!("P: {name}, a torus"),
        (Some(name), Some(genus)) => format!("P: {name}, a surface of genus {genus}"),
        _ => "P: none, since r = 0".to_owned(),
    };
    [
        format!("U: {}, {shape}{poles}", component.accessible_region),
        format!("  E: {}, {surface}", component.energy_surface),
        format!("  {section}"),
    ]
}

/// The motions on a curve.
#[must_use]
pub fn motion(curve: &CurveDocument) -> String {
    let what = match curve.kind {
        CurveKind::PolePlus => return "the centre of mass can hang straight down".to_owned(),
        CurveKind::PoleMinus => return "the centre of mass can stand straight up".to_owned(),
        CurveKind::Generic => "a permanent rotation",
        CurveKind::Pair => "a symmetric pair of permanent rotations",
        CurveKind::Circle => "a circle of permanent rotations",
        CurveKind::Axis => "rotation about a principal axis",
        CurveKind::Sphere => "any rotation",
    };
    // A circle of index 1 falls off on both of its sides.
    let kind = match (curve.kind, curve.index) {
        (_, Some(0)) => ", minima of U_l",
        (CurveKind::Circle, Some(_)) => ", maxima of U_l",
        (_, Some(1)) => ", saddles of U_l",
        (_, Some(_)) => ", maxima of U_l",
        (_, None) => "",
    };
    format!("{what} of branch {}, {}{kind}", curve.branch, curve.branch_name)
}

/// The verdict on a steady rotation, with its reason where the linear type does not say it.
#[must_use]
pub fn verdict(found: &NonlinearDocument) -> String {
    let why = match found.why {
        Reason::Spectrum => return found.verdict.word().to_owned(),
        Reason::Energy => "minimum of energy",
        Reason::Integral => "a further integral",
        Reason::Arnold => "Arnold's theorem",
        Reason::Resonance12 => "1:2 resonance",
        Reason::Resonance13 => "1:3 resonance",
        Reason::Resonance11 => "1:1 resonance",
        Reason::Degenerate => "degenerate",
    };
    format!("{} ({why})", found.verdict.word())
}

/// What fails at an isolated point of a range to which Arnold's theorem applies, and the verdict there.
#[must_use]
pub fn exception(kind: Failing, verdict: NonlinearVerdict, why: Reason) -> String {
    let (what, of_kind) = match kind {
        Failing::Resonance11 => ("1:1 resonance", Reason::Resonance11),
        Failing::Resonance12 => ("1:2 resonance", Reason::Resonance12),
        Failing::Resonance13 => ("1:3 resonance", Reason::Resonance13),
        Failing::Determinant => ("D4 = 0", Reason::Degenerate),
    };
    let verdict = if why == of_kind {
        verdict.word().to_owned()
    } else {
        self::verdict(&NonlinearDocument::along(verdict, why, false))
    };
    format!("({what}): {verdict}")
}

/// What it is with friction that conserves l.
#[must_use]
pub fn with_friction(found: &FrictionDocument) -> String {
    match found.conserving_l {
        Some(Damped::Survives) => "stable".to_owned(),
        // A degenerate point that is no minimum.
        Some(Damped::Lost) if found.growing == 0 => "unstable".to_owned(),
        Some(Damped::Lost) => format!("unstable in {}", counted(found.growing, "direction", "directions")),
        None => "open".to_owned(),
    }
}

/// True if the regions meet along the curve of this id with `below` on the side of lower h.
#[must_use]
pub fn lies_below(atlas: &Atlas, below: &RegionDocument, above: &RegionDocument, curve: &str) -> bool {
    let number = |region: &RegionDocument| region.id.parse::<RegionId>().ok();
    let (Some(below), Some(above)) = (number(below), number(above)) else { return false };
    let set = &atlas.arrangement().set;
    let is_it = |(floor, beyond)| beyond == Some(below) && CurveName::of(set, floor).to_string() == curve;
    atlas.floors(above).any(is_it)
}

/// True if a region reaches the place of an event: a cell of it ends at its l, between curves of which one takes part.
#[must_use]
pub fn touches(region: &RegionDocument, event: &EventDocument) -> bool {
    let takes_part = |curve: &String| event.curves.contains(curve);
    let reaches = |cell: &&CellDocument| takes_part(&cell.lower) || cell.upper.as_ref().is_some_and(takes_part);
    cells_at(region, event).any(|cell| reaches(&cell))
}

/// The same for the forbidden region, which lies below cells without a cell below them.
#[must_use]
pub fn touches_forbidden(regions: &[RegionDocument], event: &EventDocument) -> bool {
    let cells: Vec<&CellDocument> = regions.iter().flat_map(|region| cells_at(region, event)).collect();
    let overlap = |p: &CellDocument, q: &CellDocument| p.l_range == q.l_range;
    let is_lowest = |cell: &CellDocument| {
        !cells.iter().any(|other| overlap(other, cell) && other.upper.as_ref() == Some(&cell.lower))
    };
    cells.iter().any(|cell| event.curves.contains(&cell.lower) && is_lowest(cell))
}

/// The cells of a region that end at the l of an event.
fn cells_at<'a>(region: &'a RegionDocument, event: &'a EventDocument) -> impl Iterator<Item = &'a CellDocument> {
    let near = event.l_error + 4.0 * f64::EPSILON * event.l;
    region.cells.iter().filter(move |cell| cell.l_range.iter().flatten().any(|l| (l - event.l).abs() <= near))
}

/// What happens to U, E and P on the way from one side of a curve to the other.
#[must_use]
pub fn crossing(curve: &CurveDocument, from: &[ComponentDocument], to: &[ComponentDocument], upwards: bool) -> String {
    let (below, above) = if upwards { (from, to) } else { (to, from) };
    let twice = curve.multiplicity == 2;
    let either = |up: &'static str, down: &'static str| if upwards { up } else { down };
    let surgery = match (curve.kind, curve.index) {
        (CurveKind::PolePlus | CurveKind::PoleMinus, _) => {
            let pole = pole_name(curve.kind);
            let (way, genus) = (either("enters", "leaves"), either("rises", "falls"));
            format!("the pole {pole} {way} U; E stays as it is, the genus of P {genus} by one")
        }
        (CurveKind::Sphere, _) => format!("all of U {}", either("appears", "vanishes")),
        (CurveKind::Circle, Some(0)) => format!("an annulus of U {}", either("appears", "vanishes")),
        (CurveKind::Circle, _) => format!("along a whole circle of maxima U {}", either("closes", "opens")),
        (_, Some(0)) if twice => {
            format!("two discs of U {}, and with them two three-spheres of E", either("appear", "vanish"))
        }
        (_, Some(0)) => {
            format!("a disc of U {}, and with it a three-sphere of E", either("appears", "vanishes"))
        }
        (_, Some(1)) => at_saddles(twice, below.len().saturating_sub(above.len()), upwards),
        _ if twice => format!("two holes of U {}", either("close", "open")),
        _ => format!("a hole of U {}", either("closes", "opens")),
    };
    format!("{surgery} ({} to {})", names(from), names(to))
}

/// At a saddle two components of U join, or one gets a boundary circle more; `joined` is by how many components there are
/// fewer above. The two saddles of a pair are mirror images: both do the same, or both join the same two components.
fn at_saddles(twice: bool, joined: usize, upwards: bool) -> String {
    let (join, gets) = if upwards { ("join", "gets") } else { ("part", "loses") };
    let with_them = "and those of E with them";
    match (twice, joined) {
        (false, 0) if upwards => "at a saddle a component of U gets one more boundary circle".to_owned(),
        (false, 0) => "at a saddle a component of U loses a boundary circle".to_owned(),
        (false, _) => format!("at a saddle components of U {join}, {with_them}"),
        (true, 0) => {
            let circles = if upwards { "two more boundary circles" } else { "two boundary circles" };
            format!("at two saddles U {gets} {circles}")
        }
        (true, 1) => format!("two components of U {join} at two saddles, {with_them}"),
        (true, _) => format!("at two saddles components of U {join}, {with_them}"),
    }
}

/// What happens where a way through the plane goes over a curve, as a sentence with the names of both sides.
#[must_use]
pub fn passage(atlas: &Atlas, document: &AtlasDocument, passage: &Passage) -> String {
    let name = |region: Option<RegionId>| region.map_or_else(|| "the forbidden region".to_owned(), |id| id.to_string());
    let of = |region: Option<RegionId>| region.and_then(|id| document.regions.get(id.index()));
    let components = |region: Option<&RegionDocument>| region.map_or_else(Vec::new, |region| region.components.clone());
    let (from, to) = (of(passage.from), of(passage.to));
    let (before, after) = (components(from), components(to));
    let way = format!("{} → {}", name(passage.from), name(passage.to));
    let nearest = CurveName::of(&atlas.arrangement().set, passage.curve).to_string();
    let alone = document.curves.iter().find(|curve| curve.id == nearest).and_then(|curve| at_once(document, curve));
    let between = |one: &RegionDocument, other: Option<&RegionDocument>, id: &str| {
        let other = other.map(|region| &region.id);
        one.neighbours.iter().any(|neighbour| neighbour.curve == id && neighbour.region.as_ref() == other)
    };
    let adjacent = |id: &str| {
        [(from, to), (to, from)].into_iter().any(|(one, other)| one.is_some_and(|one| between(one, other, id)))
    };
    match alone.filter(|(curve, _)| adjacent(&curve.id)) {
        Some((curve, pole)) => {
            let upwards = match (from, to) {
                (Some(from), Some(to)) => lies_below(atlas, from, to, &curve.id),
                (from, _) => from.is_none(),
            };
            let pole = pole.map_or_else(String::new, |pole| format!(", at the pole {}", pole_name(pole)));
            format!("{way} across {}{pole}: {}.", curve.id, crossing(curve, &before, &after, upwards))
        }
        None => format!("{way}: several things happen at once ({} to {}).", names(&before), names(&after)),
    }
}

/// The one critical curve at the place of a curve, and the pole line there; `None` where several critical curves lie there.
fn at_once<'a>(
    document: &'a AtlasDocument,
    curve: &'a CurveDocument,
) -> Option<(&'a CurveDocument, Option<CurveKind>)> {
    let is_line = |curve: &CurveDocument| matches!(curve.kind, CurveKind::PolePlus | CurveKind::PoleMinus);
    let others = document.curves.iter().filter(|other| curve.coincides_with.contains(&other.id));
    let there: Vec<&CurveDocument> = std::iter::once(curve).chain(others).collect();
    let line = there.iter().find(|curve| is_line(curve)).map(|curve| curve.kind);
    let critical: Vec<&CurveDocument> = there.into_iter().filter(|curve| !is_line(curve)).collect();
    match (&critical[..], line) {
        ([], Some(_)) => Some((curve, None)),
        ([critical], line) => Some((critical, line)),
        _ => None,
    }
}

fn pole_name(kind: CurveKind) -> &'static str {
    if kind == CurveKind::PolePlus { "+r̂" } else { "-r̂" }
}

/// The components of U, or a line saying that U is empty.
fn names(components: &[ComponentDocument]) -> String {
    if components.is_empty() {
        return "empty".to_owned();
    }
    components.iter().map(|component| component.accessible_region.as_str()).collect::<Vec<_>>().join(" + ")
}
