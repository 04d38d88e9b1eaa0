use bifdiag::atlas::{Atlas, Place};
use bifdiag::body::{Body, Number};
struct R(u64);
impl R {
    fn u(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E3779B97F4A7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58476D1CE4E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D049BB133111EB);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }
    fn n(&mut self) -> f64 {
        let mut s = 0.0;
        for _ in 0..12 {
            s += self.u();
        }
        s - 6.0
    }
    fn lg(&mut self, a: f64, b: f64) -> f64 {
        (a.ln() + self.u() * (b / a).ln()).exp()
    }
}
fn main() {
    let n: usize = std::env::args().nth(1).unwrap().parse().unwrap();
    let show = std::env::args().nth(2).is_some();
    for kind in [
        "generic",
        "plane",
        "axis",
        "nearaxis",
        "symmetric",
        "flat",
        "tiny",
        "nearequal",
        "lagrange",
        "euler",
        "isotropic",
        "rod",
        "nearlagrange",
        "all",
    ] {
        let (mut el, mut cl, mut lo, mut ncl, mut merr, mut lbad, mut cbad, mut cund, mut cerr, mut built) =
            (0.0, 0.0, 0.0, 0, 0, 0, 0, 0, 0, 0);
        let mut g = R(7);
        let (mut inc, mut und, mut bad, mut maxev, mut evs, mut faces) = (0, 0, 0, 0, 0u64, 0);
        let t = std::time::Instant::now();
        for i in 0..n {
            let mut a = [0.3 + 1.7 * g.u(), 0.3 + 1.7 * g.u(), 0.3 + 1.7 * g.u()];
            let mut r = [g.n(), g.n(), g.n()];
            match kind {
                "plane" => r[i % 3] = 0.0,
                "axis" => {
                    r[i % 3] = 0.0;
                    r[(i + 1) % 3] = 0.0
                }
                "nearaxis" => {
                    let e = g.lg(1e-6, 0.1);
                    r[i % 3] *= e;
                    r[(i + 1) % 3] *= e
                }
                "symmetric" => a[i % 3] = a[(i + 1) % 3],
                "flat" => a[i % 3] = g.lg(1e-3, 0.1),
                "tiny" => r[i % 3] *= g.lg(1e-12, 1e-3),
                "nearequal" => a[i % 3] = a[(i + 1) % 3] * (1.0 + g.lg(1e-10, 1e-2)),
                "lagrange" => {
                    a[i % 3] = a[(i + 1) % 3];
                    r[i % 3] = 0.0;
                    r[(i + 1) % 3] = 0.0
                }
                "euler" => {
                    r = [0.0; 3];
                    if i % 3 == 0 {
                        a[1] = a[2]
                    }
                    if i % 7 == 0 {
                        a = [1.0; 3]
                    }
                }
                "isotropic" => a = [a[0]; 3],
                "rod" => a[i % 3] = g.lg(1e-6, 1e-3),
                "nearlagrange" => {
                    a[i % 3] = a[(i + 1) % 3] * (1.0 + g.lg(1e-6, 1e-1));
                    let e = g.lg(1e-6, 0.3);
                    r[i % 3] *= e;
                    r[(i + 1) % 3] *= e
                }
                "all" => {
                    a[i % 3] = a[(i + 1) % 3] * (1.0 + g.lg(1e-10, 1e-2));
                    r[i % 3] *= g.lg(1e-12, 1e-1);
                    r[(i + 1) % 3] *= g.lg(1e-12, 1.0)
                }
                _ => {}
            }
            let q = |x: f64| format!("{x:.12e}");
            let b = Body::parse(&a.map(q), &r.map(|x| if x == 0.0 { "0".into() } else { q(x) })).unwrap();
            let t0 = std::time::Instant::now();
            let at = match Atlas::new(&b) {
                Ok(a) => a,
                Err(e) => {
                    inc += 1;
                    if show {
                        println!("{kind} {a:?} {r:?} {e}");
                    }
                    continue;
                }
            };
            el += t0.elapsed().as_secs_f64();
            let ar = at.arrangement();
            evs += ar.evaluations as u64;
            maxev = maxev.max(ar.evaluations);
            faces = faces.max(ar.faces);
            if !ar.undecided.is_empty() {
                und += 1;
                if show {
                    println!("{kind} {a:?} {r:?} {:?}", &ar.undecided[..ar.undecided.len().min(4)]);
                }
            }
            if let Err(e) = ar.check_invariants() {
                bad += 1;
                if show || bad < 3 {
                    println!("{kind} {a:?} {r:?} {e} und {:?}", ar.undecided);
                }
            }
            for (k, reg) in at.regions().iter().enumerate() {
                match &reg.components {
                    Err(e) => {
                        merr += 1;
                        if show || merr < 4 {
                            println!("MRG {kind} {a:?} {r:?} region {k} {:?} {e}", reg.sample);
                        }
                    }
                    Ok(c) => {
                        let h = Number::from_f64(reg.sample.h * ar.set.frame.energy_unit);
                        let l = Number::from_f64((2.0 * reg.sample.x).sqrt() * ar.set.frame.momentum_unit);
                        let (Ok(h), Ok(l)) = (h, l) else { continue };
                        let t1 = std::time::Instant::now();
                        let d = bifdiag::classify::classify_with_effort(&b, &h, &l);
                        cl += t1.elapsed().as_secs_f64();
                        ncl += 1;
                        let t2 = std::time::Instant::now();
                        let loc = at.locate(h.to_f64(), l.to_f64()).unwrap();
                        lo += t2.elapsed().as_secs_f64();
                        if loc.place != Place::Region(k) {
                            lbad += 1;
                            if show || lbad < 4 {
                                println!("LOC {kind} {a:?} {r:?} region {k} {loc:?} {:?}", reg.sample);
                            }
                        }
                        match d {
                            Ok((d, e)) => {
                                if e.built_atlas {
                                    built += 1
                                }
                                match d.components {
                                    Some(x) => {
                                        let y: Vec<_> =
                                            c.iter().map(bifdiag::document::ComponentDocument::from).collect();
                                        if x != y {
                                            cbad += 1;
                                            if show || cbad < 4 {
                                                println!("CLS {kind} {a:?} {r:?} {k} {} {} {:?} {:?}", h, l, x, y);
                                            }
                                        }
                                    }
                                    None => {
                                        cund += 1;
                                    }
                                }
                            }
                            Err(e) => {
                                cerr += 1;
                                if show {
                                    println!("{e}")
                                }
                            }
                        }
                    }
                }
            }
        }
        println!(
            "  merge_err={merr} loc_bad={lbad} cls_bad={cbad} cls_und={cund} cls_err={cerr} built={built}/{ncl} cold {:.1}us locate {:.2}us atlas {:.1}us",
            cl * 1e6 / ncl as f64,
            lo * 1e6 / ncl as f64,
            el * 1e6 / n as f64
        );
        println!(
            "{kind:12} n={n} und={und} inc={inc} bad={bad} mean_ev={} max_ev={maxev} maxfaces={faces} {:.1} us",
            evs / n as u64,
            t.elapsed().as_secs_f64() * 1e6 / n as f64
        );
    }
}
