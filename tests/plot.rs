//! Pictures of atlases.
#![cfg(feature = "plot")]
#![allow(clippy::disallowed_methods, clippy::cast_precision_loss)]

mod plot_fixture;

use bifdiag::plot::{DiagramOptions, draw};
use plot_fixture::{kovalevskaya, paper};

#[test]
fn dump() {
    let Some(out) = std::env::var_os("PLOT_OUT") else { return };
    let out = std::path::PathBuf::from(out);
    for (name, fixture) in [("paper", paper()), ("kovalevskaya", kovalevskaya())] {
        for event in &fixture.atlas.events {
            println!("{name} {:?} {} {} {:?}", event.kind, event.l, event.h, event.curves);
        }
        for region in &fixture.atlas.regions {
            println!("{name} {} {:?} {:?} {:?} {:?}", region.id, region.signature, region.l_range, region.h_width, region.boundary);
        }
        let start = std::time::Instant::now();
        let picture = draw(&fixture.atlas, Some(&fixture), &DiagramOptions::default()).unwrap();
        println!("{name} {:?}", start.elapsed());
        std::fs::write(out.join(format!("{name}.svg")), &picture.svg).unwrap();
        std::fs::write(out.join(format!("{name}.png")), picture.to_png(144.0).unwrap()).unwrap();
        std::fs::write(out.join(format!("{name}.pdf")), picture.to_pdf().unwrap()).unwrap();
    }
}
