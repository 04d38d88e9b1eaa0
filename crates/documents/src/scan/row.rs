//! Rows of scans.

use std::collections::BTreeMap;
use std::fmt::Display;
use std::str::FromStr;

use bifdiag_body::Flags;
use bifdiag_schema::RowDocument;
use bifdiag_survey::scan::{DiagramCounts, RegionMargin, ScanRow};

use super::error::ReadScanError;

/// What a scan notes about one body.
#[must_use]
pub fn row(row: &ScanRow) -> RowDocument {
    let [[a1, a2, a3], [r1, r2, r3]] = row.values;
    let Flags { unphysical, plate, symmetric, plane, axis, euler } = row.flags;
    let diagram = row.diagram.as_ref();
    let count = |of: fn(&DiagramCounts) -> u32| diagram.map(of);
    let margin = |room: Option<&RegionMargin>| room.map(|room| room.margin);
    let region = |room: Option<&RegionMargin>| room.map(|room| room.signature.to_string());
    let [largest, smallest] = [diagram.and_then(|d| d.largest.as_ref()), diagram.and_then(|d| d.smallest.as_ref())];
    RowDocument {
        index: row.index,
        a1,
        a2,
        a3,
        r1,
        r2,
        r3,
        status: row.status,
        class: row.class.as_ref().map(ToString::to_string),
        regions: count(|diagram| diagram.regions),
        cusps: count(|diagram| diagram.cusps),
        pitchforks: count(|diagram| diagram.pitchforks),
        crossings: count(|diagram| diagram.crossings),
        critical_points: count(|diagram| diagram.critical_points),
        signatures: diagram.map(|diagram| counts(&diagram.signatures)),
        types: diagram.map(|diagram| counts(&diagram.types)),
        largest_margin: margin(largest),
        largest_region: region(largest),
        smallest_margin: margin(smallest),
        smallest_region: region(smallest),
        unphysical,
        plate,
        symmetric,
        plane,
        axis,
        euler,
        work: count(|diagram| diagram.work),
        error: row.error.clone(),
    }
}

/// A row of a file.
///
/// # Errors
/// [`ReadScanError`] for names and counts that no scan has written.
pub fn read_row(document: &RowDocument) -> Result<ScanRow, ReadScanError> {
    let RowDocument { a1, a2, a3, r1, r2, r3, unphysical, plate, symmetric, plane, axis, euler, .. } = *document;
    Ok(ScanRow {
        index: document.index,
        values: [[a1, a2, a3], [r1, r2, r3]],
        status: document.status,
        class: document.class.as_deref().map(str::parse).transpose()?,
        diagram: document.regions.map(|regions| read_diagram(document, regions)).transpose()?,
        flags: Flags { unphysical, plate, symmetric, plane, axis, euler },
        error: document.error.clone(),
    })
}

fn read_diagram(row: &RowDocument, regions: u32) -> Result<DiagramCounts, ReadScanError> {
    let known = |count: Option<u32>, column| count.ok_or(ReadScanError::Missing { index: row.index, column });
    Ok(DiagramCounts {
        regions,
        cusps: known(row.cusps, "cusps")?,
        pitchforks: known(row.pitchforks, "pitchforks")?,
        crossings: known(row.crossings, "crossings")?,
        critical_points: known(row.critical_points, "critical_points")?,
        signatures: read_counts(row.signatures.as_deref())?,
        types: read_counts(row.types.as_deref())?,
        largest: read_room(row.largest_margin, row.largest_region.as_deref())?,
        smallest: read_room(row.smallest_margin, row.smallest_region.as_deref())?,
        work: known(row.work, "work")?,
    })
}

fn read_room(margin: Option<f64>, region: Option<&str>) -> Result<Option<RegionMargin>, ReadScanError> {
    // In CSV an empty name is no name.
    let signature = region.unwrap_or_default().parse()?;
    Ok(margin.map(|margin| RegionMargin { margin, signature }))
}

/// `S2:2 S2+T2:1`, in the order of the names.
fn counts<K: Display>(counts: &BTreeMap<K, u32>) -> String {
    let mut parts: Vec<(String, u32)> = counts.iter().map(|(name, count)| (name.to_string(), *count)).collect();
    parts.sort();
    parts.iter().map(|(name, count)| format!("{name}:{count}")).collect::<Vec<_>>().join(" ")
}

/// The counts of a text such as `S2:2 S2+T2:1`.
fn read_counts<K: FromStr + Ord>(text: Option<&str>) -> Result<BTreeMap<K, u32>, ReadScanError>
where
    ReadScanError: From<K::Err>,
{
    let read = |part: &str| {
        let wrong = || ReadScanError::Count(part.to_owned());
        let (name, count) = part.rsplit_once(':').ok_or_else(wrong)?;
        Ok((name.parse()?, count.parse().map_err(|_not_a_count| wrong())?))
    };
    text.filter(|text| !text.is_empty()).map_or_else(|| Ok(BTreeMap::new()), |text| text.split(' ').map(read).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use bifdiag_exact::Accuracy;

    #[test]
    fn rows_come_back_as_they_went() {
        for values in [
            [[2.0, 1.1, 1.0], [0.94868, 0.0, 0.61623]],
            [[2.0, -1.0, 1.0 / 3.0], [1e-300, 0.0, 6e150]],
            [[2.0, 1.5, 1.0], [0.0; 3]],
            [[0.9, 0.3, 0.6], [1.0, 0.0, 0.9]],
        ] {
            let known = ScanRow::of(3, values, Accuracy::Exact);
            assert_eq!(read_row(&row(&known)).unwrap(), known);
        }
    }

    #[test]
    fn counts_are_written_by_name() {
        let paper = row(&ScanRow::of(0, [[2.0, 1.1, 1.0], [0.94868, 0.0, 0.61623]], Accuracy::Exact));
        assert_eq!(paper.signatures.as_deref(), Some("M2:2 M3:1 S2:1 S2+S2:1 S2+T2:1 T2:2 T2+T2:1"));
        assert_eq!(paper.types.as_deref(), Some("k0n2:1 k1n0:3 k1n1:3 k1n2:1 k2n1:1 k2n2:1"));
    }

    #[test]
    fn damaged_rows_are_refused() {
        let paper = row(&ScanRow::of(0, [[2.0, 1.1, 1.0], [0.94868, 0.0, 0.61623]], Accuracy::Exact));
        let damaged = |change: fn(&mut RowDocument)| {
            let mut row = paper.clone();
            change(&mut row);
            read_row(&row).unwrap_err()
        };
        assert!(matches!(damaged(|row| row.signatures = Some("S2".to_owned())), ReadScanError::Count(_)));
        assert!(matches!(damaged(|row| row.signatures = Some("X2:1".to_owned())), ReadScanError::Surface(_)));
        assert!(matches!(damaged(|row| row.types = Some("k1n1:1 k1:2".to_owned())), ReadScanError::Component(_)));
        assert!(matches!(damaged(|row| row.class = Some("none".to_owned())), ReadScanError::Class(_)));
        let missing = ReadScanError::Missing { index: 0, column: "cusps" };
        assert_eq!(damaged(|row| row.cusps = None), missing);
    }
}
