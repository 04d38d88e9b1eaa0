//! `bifdiag orbit`: starts, times and formats.

use std::fs;

use serde_json::{Value, json};

use crate::builder::bifdiag;
use crate::sections::{array, floats, meta};

#[test]
fn angular_velocity_and_momentum_give_the_same_start() {
    let line = "orbit --body paper --gamma 0.6,0,0.8 --json";
    let by_velocity = bifdiag(&format!("{line} --omega 1,0.5,1")).succeeds().json();
    let by_momentum = bifdiag(&format!("{line} --l-vector 2,0.55,1")).succeeds().json();
    assert_eq!(by_velocity["start"]["l"][0], by_momentum["start"]["l"][0]);
    assert_eq!(by_velocity["samples"].as_array().unwrap().len(), 21);
    assert!(by_velocity["summary"]["attitude_difference"].as_f64().unwrap() < 1e-13);
    // The length of gamma does not matter.
    let longer = bifdiag("orbit --body paper --gamma 3,0,4 --omega 1,0.5,1 --json").succeeds().json();
    assert_eq!(longer["h"], by_velocity["h"]);
}

#[test]
fn a_point_of_the_section_is_a_start() {
    let line = "orbit --body paper --h 4.45 --l 3.25 --theta 1.2 --psi pi/2 --json";
    let document = bifdiag(line).succeeds().json();
    let near = |key: &str, value: f64| (document[key].as_f64().unwrap() - value).abs() < 1e-14;
    assert!(near("h", 4.45) && near("l", 3.25), "{document}");
    let other = bifdiag(&format!("{line} --sheet -")).succeeds().json();
    assert_eq!(document["start"]["gamma"], other["start"]["gamma"]);
    assert_ne!(document["start"]["l"], other["start"]["l"]);
}

#[test]
fn data_are_written_in_every_format() {
    let place = tempfile::tempdir().unwrap();
    let line = "orbit --body paper --gamma 0.6,0,0.8 --omega 1,0.3,1 --times -1:1:5";
    let csv = bifdiag(&format!("{line} --data -")).succeeds().telling_nothing().stdout();
    let heading = "time,gamma1,gamma2,gamma3,l1,l2,l3,omega1,omega2,omega3,theta,psi,phi,\
                   attitude_w,attitude_x,attitude_y,attitude_z";
    assert_eq!((csv.lines().next(), csv.lines().count()), (Some(heading), 6));
    let times: Vec<&str> = csv.lines().skip(1).map(|line| line.split(',').next().unwrap()).collect();
    assert_eq!(times, ["-1.0", "-0.5", "0.0", "0.5", "1.0"]);
    for name in ["m.npz", "m.csv", "m.jsonl"] {
        bifdiag(&format!("{line} --data {name}")).inside(place.path()).succeeds().printing(&format!("written: {name}"));
    }
    assert_eq!(fs::read_to_string(place.path().join("m.csv")).unwrap(), csv);
    let archive = place.path().join("m.npz");
    assert!(array(&archive, "attitude").0.contains("(5, 4)"));
    assert_eq!(floats(&archive, "time"), [-1.0, -0.5, 0.0, 0.5, 1.0]);
    assert_eq!((&meta(&archive)["complete"], meta(&archive).get("samples")), (&json!(true), None));
    let lines = fs::read_to_string(place.path().join("m.jsonl")).unwrap();
    let last: Value = serde_json::from_str(lines.lines().last().unwrap()).unwrap();
    assert_eq!((last["attitude"].as_array().unwrap().len(), &last["time"]), (4, &json!(1.0)));
}

#[test]
fn times_may_stand_in_a_file() {
    let place = tempfile::tempdir().unwrap();
    fs::write(place.path().join("times.csv"), "time,weight\n-0.5,1\n\n0,1\n# later\n2.25,3\n").unwrap();
    let line = "orbit --body paper --gamma 1,0,0 --omega 1,0.3,1 --json --times";
    let document = bifdiag(line).and("times.csv").inside(place.path()).succeeds().json();
    let times: Vec<f64> =
        document["samples"].as_array().unwrap().iter().map(|sample| sample["time"].as_f64().unwrap()).collect();
    assert_eq!(times, [-0.5, 0.0, 2.25]);
    for (text, message) in [
        ("0\nx\n", "line 2: `x` is not a number"),
        ("1\n0.5\n", "line 2: 0.5 is below 1 on the line before"),
        ("# nothing\n", "holds no time"),
    ] {
        fs::write(place.path().join("times.csv"), text).unwrap();
        bifdiag(line).and("times.csv").inside(place.path()).refused().telling(message);
    }
}

/// Released at rest 1e-9 from hanging the body swings about axis 1, as a pendulum with A = 2 and r = 1: γ₂ = 1e-9 cos(t/√2).
#[test]
fn a_start_next_to_hanging_at_rest_swings() {
    let found = bifdiag("orbit --A 2,1.1,1 --r 0,0,1 --gamma 0,1e-9,1 --omega 0,0,0 --times 0:0.5:2 --json").succeeds();
    let samples = &found.json()["samples"];
    let end = samples[1]["gamma"][1].as_f64().unwrap();
    assert!((end / 1e-9 - libm::cos(0.5 / std::f64::consts::SQRT_2)).abs() < 1e-9, "{samples}");
}

#[test]
fn a_weightless_body_moves_too() {
    let line = "orbit --body euler --gamma 0,0,1 --omega 0.1,2,0.3 --json";
    let document = bifdiag(line).succeeds().json();
    assert!(document["summary"]["drift"]["h"].as_f64().unwrap() < 1e-13);
}

#[test]
fn passing_the_pole_is_reported() {
    // A pendulum about the first axis that goes over the top.
    let line = "orbit --A 2,1.5,1 --r 0,0,1 --gamma 0,0.6,0.8 --l-vector 7,0,0 --times 0:20:41";
    bifdiag(line).succeeds().printing("note: gamma passes e3 or -e3 within rounding");
    let document = bifdiag(&format!("{line} --json")).succeeds().json();
    assert!(document["summary"]["at_pole"].as_u64().unwrap() > 0);
    assert!(document["summary"]["attitude_difference"].as_f64().unwrap() < 1e-11);
}

#[test]
fn a_motion_becomes_a_moving_picture() {
    let place = tempfile::tempdir().unwrap();
    let line = "orbit --body paper --h 4.45 --l 3.25 --theta 1.2 --psi pi/2 --times 0:20:3 --animate";
    bifdiag(&format!("{line} m.svg")).inside(place.path()).succeeds().printing("written: m.svg");
    let svg = std::fs::read_to_string(place.path().join("m.svg")).unwrap();
    assert!(svg.starts_with("<svg") && svg.contains("T⁺") && svg.matches("calcMode=\"discrete\"").count() > 10);
    assert!(svg.len() < 600_000, "{} bytes", svg.len());
    bifdiag(&format!("{line} m.html")).inside(place.path()).succeeds();
    let page = std::fs::read_to_string(place.path().join("m.html")).unwrap();
    assert!(page.contains(svg.trim_end()) && !page.contains("http://localhost"));
    // Without weight there is no section, but a body that turns.
    let free = "orbit --body euler --gamma 0,0,1 --omega 1,0.1,0.2 --times 0:20:3 --animate f.svg";
    bifdiag(free).inside(place.path()).succeeds();
    assert!(!std::fs::read_to_string(place.path().join("f.svg")).unwrap().contains("T⁺"));
    bifdiag(&format!("{line} m.gif")).refused().telling("FILE.svg, FILE.html or FILE.mp4");
}

/// Without ffmpeg a page is written, and it is said; with it, the film that it makes of 361 frames.
#[test]
fn a_motion_becomes_a_film_where_ffmpeg_is() {
    let place = tempfile::tempdir().unwrap();
    let line = "orbit --body euler --gamma 0,0,1 --omega 1,0.1,0.2 --times 0:2:3 --animate m.mp4";
    let run = || bifdiag(line).inside(place.path());
    let without = run().finding_programs_in(place.path()).succeeds();
    without.printing("written: m.html").telling("ffmpeg is not installed, so m.mp4 cannot be made");
    assert!(std::fs::read_to_string(place.path().join("m.html")).unwrap().contains("id=\"clock\""));
    assert!(!place.path().join("m.mp4").exists());
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        // It counts what it is given into the last of its arguments.
        let counting = "#!/bin/sh\nfor last; do :; done\n/bin/cat | /usr/bin/wc -c > \"$last\"\n";
        let ffmpeg = place.path().join("ffmpeg");
        std::fs::write(&ffmpeg, counting).unwrap();
        std::fs::set_permissions(&ffmpeg, std::fs::Permissions::from_mode(0o755)).unwrap();
        run().finding_programs_in(place.path()).succeeds().printing("written: m.mp4");
        let bytes: usize = std::fs::read_to_string(place.path().join("m.mp4")).unwrap().trim().parse().unwrap();
        assert!(bytes > 361 * 3 * 500 * 500 && bytes.is_multiple_of(361 * 3), "{bytes}");
    }
}

/// The body of a mesh turns as it is, not as its ellipsoid.
#[test]
fn the_body_of_a_mesh_is_what_turns() {
    let place = tempfile::tempdir().unwrap();
    std::fs::write(place.path().join("box.obj"), super::parts::BOX).unwrap();
    let line = "orbit --part box.obj --density 1 --pivot 1,1,0 --g 9.81 --gamma 0,0.6,0.8 --omega 0,0,1 --times 0:2:3 --animate m.svg";
    bifdiag(line).inside(place.path()).succeeds();
    let svg = std::fs::read_to_string(place.path().join("m.svg")).unwrap();
    // The edges, r̂ and three axes; the ellipsoid would have three circles.
    assert_eq!(svg.matches("attributeName=\"d\"").count(), 5);
    assert!(svg.contains("time in s"));
}

/// γ of Euler's angles is that of the attitude, and the sample at time 0 has the angles themselves.
#[test]
fn a_motion_starts_at_eulers_angles() {
    let line = "orbit --body paper --omega 1,0.3,1 --times 0:2:3 --json";
    let found = bifdiag(&format!("{line} --euler 1.1,-0.4,0.7")).succeeds().telling_nothing().json();
    let number = |value: &Value| value.as_f64().unwrap();
    for (key, angle) in [("theta", 1.1), ("psi", -0.4), ("phi", 0.7)] {
        assert!((number(&found["start"][key]) - angle).abs() < 1e-15, "{key}: {}", found["start"][key]);
    }
    let ((sin, cos), (sin_psi, cos_psi)) = (libm::sincos(1.1), libm::sincos(-0.4));
    let gamma = [sin * sin_psi, sin * cos_psi, cos];
    for (k, x) in gamma.into_iter().enumerate() {
        assert!((number(&found["start"]["gamma"][k]) - x).abs() < 1e-15);
    }
    // Its own command, and the same motion from gamma.
    let command = found["command"].as_str().unwrap().strip_prefix("bifdiag ").unwrap();
    assert_eq!(bifdiag(command).succeeds().json(), found);
    bifdiag("orbit --body paper --euler 4,0,0 --omega 1,0,0").refused().telling("theta = 4").telling("from 0 to pi");
    bifdiag("orbit --body paper --euler 1,0 --omega 1,0,0").refused().telling("write three angles");
    bifdiag("orbit --body paper --euler 1,0,0 --gamma 1,0,0 --omega 1,0,0")
        .refused()
        .telling("both describe the start");
    bifdiag("orbit --body paper --euler 1,0,0 --phi 1 --omega 1,0,0").refused().telling("--phi");
    bifdiag("orbit --body paper --euler 1,0,0").refused().telling("--omega or --l-vector is missing");
}

/// The plain motion lies in the enclosures, in every format, and the document's own command gives the same bytes.
#[test]
fn a_proved_motion_holds_the_plain_one() {
    let place = tempfile::tempdir().unwrap();
    let line = "orbit --body paper --gamma 3,0,4 --omega 1,3/10,1 --phi 0.5 --times -2:10:7";
    let plain = bifdiag(&format!("{line} --json")).succeeds().json();
    let proved = bifdiag(&format!("{line} --proved --json")).succeeds().json();
    let end = |ends: &Value, side: usize| ends[side].as_str().unwrap().parse::<f64>().unwrap();
    for (n, sample) in plain["samples"].as_array().unwrap().iter().enumerate() {
        assert_eq!(sample["time"], proved["times"][n]);
        for (name, plain, count) in [("gamma", "gamma", 3), ("omega", "omega", 3), ("quaternion", "attitude", 4)] {
            for k in 0..count {
                let (ends, value) = (&proved["enclosures"][name][n][k], sample[plain][k].as_f64().unwrap());
                let (lo, hi) = (end(ends, 0), end(ends, 1));
                assert!(lo <= hi && hi - lo <= 1e-10, "{name} {ends}");
                assert!(lo - 1e-12 <= value && value <= hi + 1e-12, "{name} {ends} {value}");
            }
        }
        let entries = |name: &str| proved["enclosures"][name][n].as_array().unwrap().clone();
        assert_eq!(entries("rotation")[6..], entries("gamma"));
    }
    assert_eq!((&proved["complete"], &proved["proved_to"]), (&json!(true), &json!(10.0)));
    let command = proved["command"].as_str().unwrap().strip_prefix("bifdiag ").unwrap();
    assert_eq!(bifdiag(command).succeeds().json(), proved);
    bifdiag(&format!("{line} --proved --data m.csv")).inside(place.path()).succeeds().printing("widest enclosure: ");
    let csv = std::fs::read_to_string(place.path().join("m.csv")).unwrap();
    assert!(csv.starts_with("time,gamma_lo1,gamma_lo2,gamma_lo3,gamma_hi1,") && csv.lines().count() == 8, "{csv}");
    bifdiag(&format!("{line} --proved --data m.npz")).inside(place.path()).succeeds();
}

/// The screen says in which direction gamma points, as that of the plain motion does.
#[test]
fn a_proved_motion_tells_its_frame() {
    let line = "orbit --body paper --gamma 0.6,0,0.8 --omega 1,0.3,1 --times 0:1:2";
    for option in ["", " --proved"] {
        bifdiag(&format!("{line}{option}")).succeeds().printing(
            "gamma and omega are in principal axes; gamma and the third axis of space point down, along gravity",
        );
    }
}

/// The digits that are advised are more than those that were used, and enough for the bound.
#[test]
fn advised_digits_go_further() {
    let line = "orbit --A 2.3,1.7,1.2 --r 0.5,0.3,0.6 --gamma 1,2,2 --omega 0.5,-0.3,2 --times 0:200:3 --proved";
    let reached = |options: &str| {
        let ended = bifdiag(&format!("{line} {options}")).fails();
        let text = ended.stdout();
        let to = text.split("proved to t = ").nth(1).unwrap().split(';').next().unwrap().parse::<f64>().unwrap();
        let digits = text.split("--digits ").nth(1).unwrap().split_whitespace().next().unwrap().parse::<u32>().unwrap();
        (to, digits)
    };
    let (to, digits) = reached("--digits 5");
    assert!(digits >= 17, "53 bits are 15 digits: {digits}");
    bifdiag(&format!("{line} --digits {digits}")).succeeds();
    assert!(to > 10.0);
    assert!(reached("--digits 30 --bound 1e-140").1 >= 150);
    bifdiag(&format!("{line} --digits 5")).fails().telling("1 of 3 times is enclosed");
}

/// Times come from a file as they do from a range.
#[test]
fn a_proved_motion_takes_times_from_a_file() {
    let place = tempfile::tempdir().unwrap();
    fs::write(place.path().join("times.txt"), "0\n5\n10\n").unwrap();
    let line = "orbit --body paper --gamma 0.6,0,0.8 --omega 1,0.3,1 --proved --json --times";
    let ranged = bifdiag(&format!("{line} 0:10:3")).succeeds().json();
    let listed = bifdiag(&format!("{line} times.txt")).inside(place.path()).succeeds().json();
    assert_eq!((&ranged["times"], &ranged["enclosures"]), (&listed["times"], &listed["enclosures"]));
}

/// Sixty digits are sixty digits, and where digits end it is reported what goes further.
#[test]
fn the_proof_has_as_many_digits_as_are_asked() {
    let line = "orbit --body paper --gamma 0.6,0,0.8 --omega 0.1,0.3,0.1 --proved";
    let many = bifdiag(&format!("{line} --times 0:1:2 --bound 1e-60 --json")).succeeds().json();
    let [lo, hi] = [0, 1].map(|side| many["enclosures"]["gamma"][1][0][side].as_str().unwrap().to_owned());
    assert_eq!(lo[..55], hi[..55]);
    assert!(many["widest"].as_f64().unwrap() <= 1e-60);
    let ended = bifdiag(&format!("{line} --times 0:1000:3 --digits 15")).fails();
    ended.printing("proved to t = ").printing("from there enclosures outrun 53 bits: --digits 25");
    bifdiag(&format!("{line} --digits 3")).refused().telling("from 5 to 250");
    bifdiag(&format!("{line} --bound 0")).refused().telling("from 1e-140 to 1");
    bifdiag("orbit --body paper --gamma 0,0,1 --omega 1,0,0 --digits 30").refused().telling("--proved");
}

/// Angles become doubles, from which the motion is proved: the same start written out encloses another motion.
#[test]
fn a_proof_from_angles_prints_its_start() {
    let line = "orbit --body paper --omega 1,0.3,1 --times 0:1:2 --proved";
    let angles = bifdiag(&format!("{line} --euler pi/3,pi/2,0")).succeeds();
    angles.printing("proved from the start rounded to doubles: gamma = (0.866025403784438");
    let text = bifdiag(&format!("{line} --gamma 0.6,0,0.8")).succeeds().stdout();
    assert!(!text.contains("rounded to doubles"), "{text}");
}

/// A = (4, 4, 1) turns steadily about the axis of r with l = 4: the integral, which the case keeps at l = 0 alone, is constant.
#[test]
fn an_integral_that_a_case_does_not_keep_may_be_constant() {
    let line = "orbit --A 4,4,1 --r 1,0,0 --gamma 1,0,0 --omega 1,0,0 --times 0:2:2";
    bifdiag(line).succeeds().printing("constant where l = 0 only, and on steady rotations: largest deviation 0");
}

/// Twenty factors of the angular velocity leave the range of doubles; in another unit of time the motion is the same.
#[test]
fn spins_of_any_size_are_followed() {
    let turned = |size: &str, time: &str, weight: &str| {
        let line =
            format!("orbit --A 3,2,1.5 --r {weight} --gamma 1,1,1 --omega {size},0,{size} --times 0:{time}:2 --json");
        let samples = bifdiag(&line).succeeds().json()["samples"].clone();
        samples[1]["gamma"].as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect::<Vec<_>>()
    };
    let one = turned("1", "1", "0,0,0");
    for (size, time, weight) in [
        ("1e15", "1e-15", "0,0,0"),
        ("1e60", "1e-60", "0,0,0"),
        ("1e-40", "1e40", "0,0,0"),
        ("1e20", "1e-20", "0.2,-0.3,1"),
    ] {
        let other = turned(size, time, weight);
        assert!(one.iter().zip(&other).all(|(p, q)| (p - q).abs() < 1e-14), "{size}: {one:?} {other:?}");
    }
}
