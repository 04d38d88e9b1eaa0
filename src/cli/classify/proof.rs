//! `bifdiag classify --certificate`: one point with its proof.

use bifdiag_diagram::topology::Answer;
use bifdiag_documents::{DocumentOptions, Drawn, Subject, certified_atlas_of, leave_out_drawing, proved_point};
use bifdiag_exact::{CertifiedAtlas, Solver};
use bifdiag_numbers::Number;
use bifdiag_schema::Accuracy;
use bifdiag_verify::verify_point;

use super::many::unanswered;
use crate::cli::export::answer;
use crate::cli::failure::{Failure, failed};
use crate::cli::terminal::Timings;

pub fn run(subject: &Subject, h: &Number, l: &Number, timings: &Timings) -> Result<(), Failure> {
    let solver = Solver::new(subject.body.clone(), Accuracy::Exact);
    let found = solver.classify(h, l).map_err(unanswered)?;
    if let Answer::Critical(_) = found.answer {
        return Err(Failure::work(
            "the point lies on a curve; only for a point beside it can it be proved in which \
        region it lies",
        ));
    }
    let places = solver.places(h, l, &found.answer).map_err(failed("the region of the point is not known"))?;
    let [region] = places[..] else { return Err(Failure::work("the region of the point is not known")) };
    let proved = timings.stage("proof", || CertifiedAtlas::new(&subject.body));
    let proved = proved.map_err(failed("the atlas could not be proved"))?;
    let drawn = proved.to_atlas().map_err(failed("the atlas could not be made"))?;
    let options = DocumentOptions { drawing: Drawn::Nothing, ..DocumentOptions::default() };
    let mut atlas = timings.stage("certificate", || certified_atlas_of(subject, &proved, &drawn, &options))?;
    leave_out_drawing(&mut atlas, subject)?;
    let document = proved_point(subject, [h, l], region, &proved, atlas).ok_or_else(|| {
        Failure::work(if l.value().is_zero() {
            "--certificate: an atlas proves l > 0 only, and this point has l = 0; without --certificate it is \
            classified, exactly too"
        } else {
            "--certificate: l is nearer to an event of the diagram than the certificate's bounds for that event; \
            without --certificate the point is classified, exactly too"
        })
    })?;
    // A refused document is not written.
    timings.stage("verify", || verify_point(&document)).map_err(failed("the proof is not confirmed"))?;
    answer(true, &document, String::new)
}
