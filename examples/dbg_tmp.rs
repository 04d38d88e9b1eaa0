use bifdiag::atlas::Atlas;
use bifdiag::body::Body;
fn main() {
    let b = Body::parse(
        &["0.6230937192046181", "0.6224505253504269", "0.8555636810400489"],
        &["2.3325004322552683e-5", "5.574219551572418e-5", "0.521275423321006"],
    )
    .unwrap();
    let t = std::time::Instant::now();
    let a = Atlas::new(&b).unwrap();
    println!("{:?}", t.elapsed());
    for (k, r) in a.regions().iter().enumerate() {
        println!("{k} {:?} {:?}", r.sample, r.components.as_ref().map(|c| c.len()));
        if r.components.is_err() {
            let s = &a.arrangement().set;
            for e in s.equilibria_at(r.sample.x).list {
                println!(
                    "   {} {:?} h={:.12} idx {}",
                    bifdiag::atlas::curve_name(s, e.curve),
                    e.point.gamma,
                    e.point.h(),
                    e.index
                );
            }
            println!("  r_hat {:?} a {:?}", s.frame.r_hat(), s.frame.a);
        }
    }
}
