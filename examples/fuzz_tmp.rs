use bifdiag::arrangement::Arrangement;
use bifdiag::body::Body;
use bifdiag::equilibria::CriticalSet;
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
            let s = match CriticalSet::new(b.frame()) {
                Ok(s) => s,
                Err(e) => {
                    println!("{e}");
                    continue;
                }
            };
            let ar = Arrangement::new(s);
            evs += ar.evaluations as u64;
            maxev = maxev.max(ar.evaluations);
            faces = faces.max(ar.faces);
            if !ar.undecided.is_empty() {
                und += 1;
                if show {
                    println!("{kind} {a:?} {r:?} {:?}", &ar.undecided[..ar.undecided.len().min(4)]);
                }
            }
            if ar.slabs.is_empty() {
                inc += 1;
            }
            if let Err(e) = ar.check_invariants() {
                bad += 1;
                if show || bad < 3 {
                    println!("{kind} {a:?} {r:?} {e} und {:?}", ar.undecided);
                }
            }
        }
        println!(
            "{kind:12} n={n} und={und} inc={inc} bad={bad} mean_ev={} max_ev={maxev} maxfaces={faces} {:.1} us",
            evs / n as u64,
            t.elapsed().as_secs_f64() * 1e6 / n as f64
        );
    }
}
