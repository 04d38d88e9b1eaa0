//! What a document says of itself and of its body: flags, totals, the whole half-plane.

use bifdiag_schema::{AtlasDocument, CommandLine, Flags, PointProofDocument};
use dashu_ratio::RBig;
use std::collections::BTreeMap;

use super::part;
use crate::Refused;
use crate::equilibria::pieces::Branch;
use crate::equilibria::spaces::Body;
use crate::order::orders::Orders;
use crate::order::slabs::Slab;
use crate::topology::component;

/// Checks the version by its form, the command, the flags of the body, and that nothing is left out.
pub(crate) fn frame(document: &AtlasDocument, body: &Body) -> Result<(), Refused> {
    let refuse = |field| Err(Refused::Field { field });
    if document.head.schema_version != bifdiag_schema::SCHEMA_VERSION {
        return refuse("schema_version");
    }
    let is_number = |part: &str| !part.is_empty() && part.bytes().all(|c| c.is_ascii_digit());
    let is_version = |text: &str| {
        let numbers = text.split(['-', '+']).next().unwrap_or_default();
        let after = &text[numbers.len()..];
        let is_tag = |c: u8| c.is_ascii_alphanumeric() || b"-+.".contains(&c);
        numbers.split('.').count() == 3 && numbers.split('.').all(is_number) && after.bytes().all(is_tag)
    };
    if !is_version(&document.head.version) {
        return refuse("version");
    }
    if document.head.command != command(document) {
        return refuse("command");
    }
    let flags = part::check(document, body, flags(body))?;
    if document.body.flags != flags {
        return refuse("body: unphysical, plate, symmetric, plane, axis or euler");
    }
    if document.body.degenerate != (flags.symmetric || flags.plane || flags.axis || flags.euler) {
        return refuse("body.degenerate");
    }
    let summary = &document.summary;
    if document.window.is_some() || document.regions.iter().any(|region| region.clipped) {
        return refuse("window or clipped: a certificate speaks of the whole half-plane");
    }
    if !summary.complete || !summary.undecided.is_empty() {
        return refuse("summary.complete or summary.undecided");
    }
    Ok(())
}

/// The flags of a body, by their definitions.
fn flags(body: &Body) -> Flags {
    let (a, r) = (&body.moments, &body.center);
    let mut flags = Flags { euler: r.iter().all(RBig::is_zero), ..Flags::default() };
    for k in 0..3 {
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        let others = &a[i] + &a[j];
        flags.unphysical |= others < a[k] || (others == a[k] && !r[k].is_zero());
        flags.plate |= others == a[k];
        flags.symmetric |= a[i] == a[j];
        flags.plane |= r[k].is_zero();
        // A r = a r for one a.
        flags.axis |= !r[k].is_zero() && (0..3).all(|n| r[n].is_zero() || a[n] == a[k]);
    }
    flags.plate &= !flags.unphysical;
    flags
}

/// Checks how many regions have each signature, and the number of critical points.
pub(crate) fn totals(document: &AtlasDocument, orders: &Orders, slabs: &[Slab]) -> Result<(), Refused> {
    let mut signatures = BTreeMap::new();
    for region in &document.regions {
        let name = component::signature(&region.components).unwrap_or_else(|| {
            region.components.iter().map(|c| c.accessible_region.as_str()).collect::<Vec<_>>().join("+")
        });
        *signatures.entry(name).or_insert(0) += 1;
    }
    if signatures != document.summary.signatures {
        return Err(Refused::Field { field: "summary.signatures" });
    }
    let spaces = orders.spaces;
    let count = |curve: usize| {
        let piece = &orders.pieces.list[curve];
        match piece.branch {
            _ if !piece.critical => 0,
            Branch::Over(base) | Branch::Rotation(base) if spaces.list[base].axes.len() == 1 => 2,
            _ => 1,
        }
    };
    let most = slabs.iter().map(|slab| slab.levels.iter().map(|level| count(level.curve)).sum::<usize>()).max();
    if most == Some(document.summary.critical_points_max) {
        Ok(())
    } else {
        Err(Refused::Field { field: "summary.critical_points_max" })
    }
}

/// The command line that makes a document with its certificate, from its body or part and from its contents.
fn command(document: &AtlasDocument) -> String {
    let line = CommandLine::new("atlas").body(&document.body.given, document.body.part.as_ref());
    line.flag("certificate", true).flag("no-drawing", document.drawing.is_none()).json()
}

/// The command line that makes the proof of a point.
pub(crate) fn point_command(point: &PointProofDocument) -> String {
    let line = CommandLine::new("classify").body(&point.atlas.body.given, point.atlas.body.part.as_ref());
    line.option("h", &point.h).option("l", &point.l).flag("certificate", true).json()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn flags_are_decided_exactly() {
        let number = |n: i32| RBig::from(n);
        let body = |a: [i32; 3], r: [i32; 3]| Body { moments: a.map(number), center: r.map(number) };
        let special = |a, r| flags(&body(a, r));
        let none = Flags::default();
        assert_eq!(special([3, 4, 5], [1, 2, 3]), none);
        assert_eq!(special([1, 4, 5], [1, 2, 0]), Flags { plate: true, plane: true, ..none });
        assert_eq!(special([1, 4, 5], [1, 2, 3]), Flags { unphysical: true, ..none });
        assert_eq!(special([1, 4, 6], [1, 2, 3]), Flags { unphysical: true, ..none });
        assert_eq!(special([2, 2, 1], [1, 2, 0]), Flags { symmetric: true, plane: true, axis: true, ..none });
        assert_eq!(special([3, 4, 5], [0, 2, 3]), Flags { plane: true, ..none });
        assert_eq!(special([3, 4, 5], [0, 0, 0]), Flags { plane: true, euler: true, ..none });
    }
}
