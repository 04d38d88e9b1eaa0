//! Steady rotations in words.

use bifdiag_documents::words;
use bifdiag_schema::{Multiplicity, SpinChangeDocument, SpinDocument, SteadyDocument, Verdict};

use crate::cli::terminal::{Report, significant, told_apart};

/// Its stability in words.
pub fn report_steady(report: &mut Report, steady: &SteadyDocument) {
    report.line(format!("steady rotation, {}: {}", words::verdict(&steady.nonlinear), steady.stability.word()));
    report.line(format!("with friction that conserves l: {}", words::with_friction(&steady.friction)));
    match steady.one_of {
        Some(Multiplicity::Circle) => {
            report.line("it is one of a circle of steady rotations, which are judged as a whole");
        }
        Some(Multiplicity::Sphere) if steady.l == 0.0 => {
            report.line("at rest every orientation is an equilibrium; they are judged as a whole");
        }
        Some(Multiplicity::Sphere) => report.line("rotation about every axis is steady"),
        Some(Multiplicity::Points(_)) | None => {}
    }
    if let Some(frequencies) = frequencies(steady) {
        report.line(format!("{frequencies}, seen from the rotating body"));
    }
    if let Some(time) = steady.growth_time_s {
        report.line(format!("a deviation grows by a factor of e in {} s", significant(time, 4)));
    }
    if let Some(note) = &steady.note {
        report.line(note);
        return;
    }
    let [below, above] = steady.regions.each_ref().map(|region| region.as_deref().unwrap_or("none"));
    report.line(format!("regions beside it: {below} below, {above} above in h"));
}

/// The frequencies in words; none where no pair of eigenvalues has an imaginary part.
fn frequencies(steady: &SteadyDocument) -> Option<String> {
    let [slow, fast] = steady.frequencies_hz;
    let hertz = |frequency: f64| format!("{} Hz", significant(frequency, 6));
    match (slow > 0.0, fast > 0.0) {
        (_, false) => None,
        (false, true) => Some(format!("frequency of small oscillations: {}", hertz(fast))),
        (true, true) if slow < fast => {
            let [slow, fast] = told_apart([slow, fast], 6);
            Some(format!("frequencies of small oscillations: {slow} Hz, {fast} Hz"))
        }
        (true, true) if steady.stable != Verdict::Unstable => {
            Some(format!("frequency of small oscillations: {}, twice", hertz(fast)))
        }
        (true, true) => Some(format!("frequency of oscillations that grow: {}", hertz(fast))),
    }
}

/// The change at this `spin` and those at the next smaller and larger ones, which are known for a permanent axis; without an
/// atlas those of stability.
pub fn changes(report: &mut Report, steady: &SteadyDocument, spin: SpinDocument, atlas: bool) {
    if steady.one_of == Some(Multiplicity::Sphere) && steady.l == 0.0 {
        report.line("this verdict is that of rest; rotation about this axis, however slow, has its own");
        return;
    }
    let of_regions = |change: &SpinChangeDocument| change.kind == "region";
    let change = |[next, any]: [&str; 2], change: &Option<SpinChangeDocument>| match change {
        Some(change) => {
            let what = if of_regions(change) {
                "regions change".to_owned()
            } else {
                format!("{} to {}", change.from.word(), change.to.word())
            };
            let [_, rpm] = told_apart([spin.rpm, change.spin.rpm], 8);
            let [_, rad_per_s] = told_apart([spin.rad_per_s, change.spin.rad_per_s], 8);
            format!("next change {next}: {rpm} rpm = {rad_per_s} rad/s, {what}")
        }
        None if atlas => format!("no change {any}"),
        None => format!("no change of stability {any}; the regions are not known"),
    };
    match &steady.at {
        Some(at) if of_regions(at) => report.line("the regions change at this spin, or within rounding of it"),
        Some(at) => report.line(format!("this spin is a threshold: {} below, {} above", at.from.word(), at.to.word())),
        None => {}
    }
    // The slowest spins may have another type than rest.
    if spin.rad_per_s == 0.0 {
        report.line(change(["above the slowest spins"; 2], &steady.above));
    } else {
        report.line(change(["at smaller spin", "at any smaller spin above 0"], &steady.below));
        report.line(change(["at larger spin", "at any larger spin"], &steady.above));
    }
}
