//! Pictures of sections.
#![cfg(feature = "plot")]

use bifdiag::body::Body;
use bifdiag::plot::{Picture, Projection, SectionOptions, SectionScene, draw_section};
use bifdiag::section::{
    Monitor, OrbitSection, Portrait, PortraitOptions, StartOptions, SweepOptions, spread_starts, sweep,
};

fn portrait(h: f64, l: f64) -> Portrait {
    let body = Body::parse(&["2", "1.1", "1"], &["0.94868", "0", "0.61623"]).unwrap();
    Portrait::new(&body, h, l, &PortraitOptions::default()).unwrap()
}

fn orbits(portrait: &Portrait, count: usize, crossings: usize) -> Vec<OrbitSection> {
    let (h, l) = portrait.energy_momentum();
    let torus = portrait.torus();
    let starts = spread_starts(torus, h, l, &StartOptions { count, ..StartOptions::default() }).unwrap();
    let starts: Vec<_> = starts.into_iter().map(|point| torus.state(point, h, l).unwrap()).collect();
    sweep(torus, &starts, &SweepOptions { crossings, ..SweepOptions::default() }, &Monitor::default()).unwrap()
}

fn look(name: &str, picture: &Picture) {
    // For the eye: set PLOT_OUT to a directory.
    if let Some(out) = std::env::var_os("PLOT_OUT").map(std::path::PathBuf::from) {
        std::fs::write(out.join(format!("{name}.svg")), &picture.svg).unwrap();
        std::fs::write(out.join(format!("{name}.png")), picture.to_png(144.0).unwrap()).unwrap();
        std::fs::write(out.join(format!("{name}.pdf")), picture.to_pdf().unwrap()).unwrap();
    }
}

#[test]
fn a_section_is_drawn() {
    let portrait = portrait(4.45, 3.25);
    let orbits = orbits(&portrait, 24, 400);
    let scene = SectionScene { portrait: &portrait, orbits: &orbits, values: None, caption: "T² + T²" };
    for (name, projection) in [("torus", Projection::Torus), ("both", Projection::Both)] {
        let options = SectionOptions { projection, ..SectionOptions::default() };
        look(name, &draw_section(&scene, &options).unwrap());
        let options = SectionOptions { raster_above: 0, ..options };
        look(&format!("{name}-raster"), &draw_section(&scene, &options).unwrap());
    }
}
