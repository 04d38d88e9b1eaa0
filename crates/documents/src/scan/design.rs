//! Which bodies a scan covers.

use bifdiag_numbers::Number;
use bifdiag_schema::{CommandLine, DesignDocument, FamilyDocument, RangeDocument};
use bifdiag_survey::scan::Shard;
use bifdiag_survey::{BodyFamily, BodyList, Design, ParameterRange};

use super::error::ReadScanError;
use crate::body::texts;

/// A range of a parameter.
#[must_use]
pub fn range(range: &ParameterRange) -> RangeDocument {
    RangeDocument {
        parameter: range.parameter,
        from: range.from.text().to_owned(),
        to: range.to.text().to_owned(),
        steps: range.steps,
    }
}

/// Which bodies a scan covers.
#[must_use]
pub fn design(design: &Design) -> DesignDocument {
    let family = match &design.family {
        BodyFamily::General => FamilyDocument::General,
        BodyFamily::Positive => FamilyDocument::Positive,
        BodyFamily::Katok => FamilyDocument::Katok,
        BodyFamily::Body { moments, center } => FamilyDocument::Body { moments: texts(moments), center: texts(center) },
        BodyFamily::Listed(list) => FamilyDocument::Listed { sha256: list.digest().to_owned() },
    };
    let vary = design.vary.iter().map(range).collect();
    DesignDocument { family, vary, samples: design.samples, seed: design.seed }
}

/// The bodies that a document describes.
///
/// # Errors
/// [`ReadScanError`] for invalid numbers, and for bodies that no scan covers.
pub fn read_design(document: &DesignDocument) -> Result<Design, ReadScanError> {
    let numbers =
        |[a, b, c]: &[String; 3]| -> Result<[Number; 3], ReadScanError> { Ok([a.parse()?, b.parse()?, c.parse()?]) };
    let family = match &document.family {
        FamilyDocument::General => BodyFamily::General,
        FamilyDocument::Positive => BodyFamily::Positive,
        FamilyDocument::Katok => BodyFamily::Katok,
        FamilyDocument::Body { moments, center } => {
            BodyFamily::Body { moments: numbers(moments)?, center: numbers(center)? }
        }
        FamilyDocument::Listed { sha256 } => BodyFamily::Listed(BodyList::new(sha256.clone(), Vec::new())),
    };
    let read_range = |range: &RangeDocument| -> Result<ParameterRange, ReadScanError> {
        let RangeDocument { parameter, from, to, steps } = range;
        Ok(ParameterRange { parameter: *parameter, from: from.parse()?, to: to.parse()?, steps: *steps })
    };
    let vary = document.vary.iter().map(read_range).collect::<Result<_, _>>()?;
    Ok(Design::new(family, vary, document.samples, document.seed)?)
}

/// The command line of a scan, or of the shard with these bodies, without its output options.
#[must_use]
pub fn command(design: &DesignDocument, range: [u64; 2]) -> CommandLine {
    let line = CommandLine::new("scan");
    let mut line = match &design.family {
        FamilyDocument::General => line.option("family", "general"),
        FamilyDocument::Positive => line.option("family", "positive"),
        FamilyDocument::Katok => line.option("family", "katok"),
        FamilyDocument::Body { moments, center } => line.option("A", moments.join(",")).option("r", center.join(",")),
        // The file that it came from is not remembered.
        FamilyDocument::Listed { .. } => line.option("bodies", "bodies.csv"),
    };
    for range in &design.vary {
        let steps = range.steps.map_or_else(String::new, |steps| format!(":{steps}"));
        line = line.option("vary", format!("{}={}:{}{steps}", range.parameter, range.from, range.to));
    }
    let is_list = matches!(design.family, FamilyDocument::Listed { .. });
    line.option_if("samples", if is_list { None } else { design.samples })
        .option_if("seed", (design.seed != 0).then_some(design.seed))
        .option_if("shard", shard(design, range))
}

/// The shard with these bodies; `None` for the whole scan.
fn shard(design: &DesignDocument, range: [u64; 2]) -> Option<String> {
    const MOST: u64 = 4096;
    let bodies = read_design(design).ok()?.count();
    let mut parts = (1..=MOST).flat_map(|count| (1..=count).map(move |number| (number, count)));
    let is_this =
        |&(number, count): &(u64, u64)| Shard::new(number, count).is_some_and(|shard| shard.range(bodies) == range);
    parts.find(is_this).filter(|(_, count)| *count > 1).map(|(number, count)| format!("{number}/{count}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn designs_come_back_as_they_went() {
        let ranges = |texts: &[&str]| texts.iter().map(|text| text.parse().unwrap()).collect::<Vec<ParameterRange>>();
        let body = |texts: [&str; 3]| texts.map(|text| text.parse().unwrap());
        let paper = BodyFamily::Body { moments: body(["2", "11/10", "1.0"]), center: body(["0.94868", "0", "-1e-3"]) };
        for known in [
            Design::new(BodyFamily::General, Vec::new(), Some(7), 3).unwrap(),
            Design::new(BodyFamily::Positive, Vec::new(), Some(1), 0).unwrap(),
            Design::new(BodyFamily::Katok, Vec::new(), Some(9), 0).unwrap(),
            Design::new(BodyFamily::Listed(BodyList::new("00ff".into(), Vec::new())), Vec::new(), Some(3), 0).unwrap(),
            Design::new(paper.clone(), ranges(&["A2=1/3:2:9", "r3=-0.50:0.5:2"]), None, 0).unwrap(),
            Design::new(paper, ranges(&["r1=0:1e-2"]), Some(5), 1).unwrap(),
        ] {
            let document = design(&known);
            assert_eq!(read_design(&document).unwrap(), known);
            // The texts too, not only their values.
            assert_eq!(design(&read_design(&document).unwrap()), document);
        }
    }

    #[test]
    fn damaged_designs_are_refused() {
        let mut document = design(&Design::new(BodyFamily::General, Vec::new(), Some(7), 3).unwrap());
        document.samples = None;
        assert!(matches!(read_design(&document), Err(ReadScanError::Design(_))));
        document.family =
            FamilyDocument::Body { moments: ["1", "x", "1"].map(str::to_owned), center: Default::default() };
        assert!(matches!(read_design(&document), Err(ReadScanError::Number(_))));
    }
}
