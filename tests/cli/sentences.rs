//! Every sentence and number says what was decided: no difference that is only a name, no rounding for 0, no plural of one.

use std::process::Command;

use serde_json::{Value, json};

use crate::builder::{PROGRAM, bifdiag};

/// Bodies in which something is 0 or equal, beside the presets.
const SPECIAL: [&str; 16] = [
    "--body paper",
    "--body euler",
    "--body lagrange",
    "--body kovalevskaya",
    "--body goryachev-chaplygin",
    "--body hess-appelrot",
    "--body katok:1",
    "--body katok:4",
    "--body ten",
    "--A 1,1,2 --r 0.3,0.4,0.5",
    "--A 2,1,1 --r 0.1,0,0.7",
    "--A 1,1,1 --r 0.3,1,2",
    "--A 3,2,1 --r 0,0.7,0.1",
    "--A 2,1,1 --r 0,0,0",
    "--A 1,1,1 --r 0,0,0",
    "--A 1.1,0.7,0.4 --r 0,0,0.3",
];

#[test]
fn isolated_exceptions_of_a_curve_are_reported_to_be_such() {
    let shown = bifdiag("show G0.1 --body paper").succeeds();
    shown
        .printing("at l = 2.23671 alone (1:2 resonance): unstable\n")
        .printing("at l = 3.03086 alone (1:3 resonance): stable\n")
        .printing("at l = 2.3278 alone (D4 = 0): stable (Arnold's theorem)\n");
}

#[test]
fn an_axis_without_frequencies_is_reported_what_it_is() {
    let refused = |body: &str| bifdiag(&format!("campbell {body} --no-plot --to")).and("5 rad/s").refused();
    refused("--A 2,1.1,1 --r 0,0,0 --axis 0,1,1")
        .telling("is steady at no spin")
        .telling("the nearest permanent axes are (0, 1, 0) and (0, 0, 1), 45° away");
    refused("--A 2,2,1 --r 0,0,0 --axis 1,1,1").telling(
        "the nearest permanent axis is (0.707107, 0.707107, 0), one of a circle of such axes, 35.3° \
        away",
    );
    refused("--A 2,2,1 --r 0,0,1 --axis 0,1,3").telling("the nearest permanent axis is (0, 0, 1), 18.4° away");
    let spins = bifdiag("critical-spin --A 2,2,1 --r 0,0,0 --axis 1,1,1").succeeds();
    spins.printing("(0.707107, 0.707107, 0) is one of a circle of permanent axes");
    let tie = bifdiag("critical-spin --A 2,2,1 --r 0,0,0 --axis 1,0,1").succeeds();
    tie.printing("also at this angle: (1, 0, 0)\n").printing("(1, 0, 0) is one of a circle of permanent axes");
}

#[test]
fn every_command_is_explained() {
    let help = bifdiag("--help").succeeds().stdout();
    let commands = help.lines().skip_while(|line| *line != "Commands:").skip(1).take_while(|line| !line.is_empty());
    let names: Vec<&str> = commands.filter_map(|line| line.split_whitespace().next()).collect();
    assert!(names.len() > 20, "{help}");
    for name in names {
        let reply = bifdiag("explain").and(name).succeeds().printing("(Commands)").stdout();
        let words = reply.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(words.contains(&format!("`bifdiag {name} --help`")), "{reply}");
    }
    // A word that is a term, too, has both entries.
    let both = bifdiag("explain section --json").succeeds().json();
    let entries = both["entries"].as_array().unwrap();
    assert!(entries.len() > 1 && entries.last().unwrap()["section"] == "Commands", "{both}");
    bifdiag("explain Spin-Down").succeeds().printing("Follow a steady rotation, slowed by friction");
}

#[test]
fn one_thing_has_no_plural() {
    let place = tempfile::tempdir().unwrap();
    let file = place.path().join("lagrange.json");
    let atlas = bifdiag("--body euler --certificate --no-drawing --json").succeeds().stdout();
    std::fs::write(&file, atlas).unwrap();
    let reply = bifdiag("verify").and(&file).succeeds().stdout();
    let words: Vec<&str> = reply.split([' ', '\n', ',']).collect();
    let is_wrong = |pair: &[&str]| pair[0] == "1" && ["regions", "events", "pairs"].contains(&pair[1]);
    assert!(!words.windows(2).any(is_wrong), "{reply}");
    bifdiag("section --body paper --region R5 --orbits 1 --crossings 20 --no-plot")
        .inside(place.path())
        .succeeds()
        .printing("20 crossings of 1 orbit\n");
    bifdiag("orbit --body paper --gamma 1 --omega 1,0,0").refused().telling("1 number given");
}

/// The spins of a range are those that were asked for, to the last digit.
#[test]
fn spins_are_echoed_as_they_were_asked_for() {
    let table = bifdiag("critical --body paper --spin").and("0:3000:301 rpm").succeeds().stdout();
    let mut spins: Vec<&str> = table.lines().skip(1).filter_map(|line| line.split(',').nth(1)).collect();
    spins.dedup();
    let asked: Vec<String> = (0..=300).map(|k| format!("{}.0", 10 * k)).collect();
    assert_eq!(spins, asked);
    let lines = bifdiag("critical --body paper --json --spin").and("0:300:4 rpm").succeeds().stdout();
    for (line, rpm) in lines.lines().zip([0.0, 100.0, 200.0, 300.0]) {
        let line: Value = serde_json::from_str(line).unwrap();
        assert_eq!(line["spin"]["rpm"], json!(rpm));
    }
    let state = bifdiag("state --body paper --axis z --json --spin").and("-350 rpm").succeeds().json();
    assert_eq!(state["spin"]["rpm"], json!(350.0));
    let place = tempfile::tempdir().unwrap();
    bifdiag("campbell --A 2,1.1,1 --r 0,0,1 --axis z --no-plot --to").and("4000 rpm").inside(place.path()).succeeds();
    let rows = std::fs::read_to_string(place.path().join("bifdiag-out/campbell.csv")).unwrap();
    let spins: Vec<&str> = rows.lines().skip(1).filter_map(|line| line.split(',').next()).collect();
    let asked: Vec<String> = (1..=400).map(|k| format!("{}.0", 10 * k)).collect();
    assert_eq!(spins, asked);
}

/// Numbers of a text that are smaller than 1e-12 and not 0, but for bounds of errors.
fn tiny(text: &str) -> Vec<&str> {
    let lines = text.lines().filter(|line| !line.contains("error bound"));
    let numbers = lines.flat_map(|line| line.split(|c: char| !c.is_ascii_alphanumeric() && !"+-.".contains(c)));
    let is_tiny = |word: &&str| word.parse::<f64>().is_ok_and(|x| x != 0.0 && x.abs() < 1e-12);
    numbers.filter(is_tiny).collect()
}

fn is_negative_zero(word: &str) -> bool {
    word.starts_with('-') && word.parse::<f64>().is_ok_and(|x| x == 0.0)
}

/// What the spins, momenta and points of these commands make of special bodies: nothing that is 0 is printed as 2.2e-16, and
/// nothing as −0.
#[test]
fn nothing_that_is_zero_is_printed_as_a_rounding() {
    let commands = [
        "critical --l 0",
        "critical --l 1",
        "critical --l=-5",
        "critical --spin 2rad/s",
        "critical --spin 0rpm",
        "critical --l 0:2:5",
        "state --axis z --spin 2rad/s",
        "state --axis=-z --spin 2rad/s",
        "state --axis x --spin=-2rad/s",
        "state --axis 1,0,1 --spin 0rpm",
        "critical-spin",
        "critical-spin --axis z",
        "critical-spin --axis=-x",
        "classify --h 2 --l 0",
        "classify --h 2 --l 1",
        "show R1",
        "orbit --gamma 0,0,1 --omega 0,0,0 --times 0:1:3 --no-plot",
    ];
    let mut wrong: Vec<String> = Vec::new();
    for body in SPECIAL {
        for command in commands {
            let (name, options) = command.split_once(' ').unwrap_or((command, ""));
            for json in ["", "--json"] {
                if json == "--json" && (name == "show" || name == "orbit") {
                    continue;
                }
                let line = format!("{name} {body} {options} {json}");
                let output = Command::new(PROGRAM).args(line.split_whitespace()).output().unwrap();
                let text = String::from_utf8(output.stdout).unwrap();
                let split = |c: char| !c.is_ascii_alphanumeric() && !"+-.".contains(c);
                let signed = text.split(split).filter(|word| is_negative_zero(word));
                wrong.extend(signed.map(|word| format!("{line}: {word}")));
                if json.is_empty() && name != "critical-spin" && !command.contains("0:2:5") {
                    wrong.extend(tiny(&text).iter().map(|word| format!("{line}: {word}")));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn a_proof_at_rest_is_refused_in_its_own_words() {
    let refused = bifdiag("classify --body paper --h 3.8 --l 0 --certificate").fails();
    refused.telling("an atlas proves l > 0 only");
}

/// What the normal form decides along a family of moving axes is said of the family, but at the spins at which it is not so, and
/// at each of those `critical --spin` beside it agrees.
#[test]
fn moving_axes_have_the_verdict_of_the_normal_form() {
    let mut exceptions = 0;
    for body in ["--body paper", "--body ten", "--A 2,1.1,1 --r 3,1,2"] {
        bifdiag(&format!("critical-spin {body}")).succeeds().printing("by Arnold's theorem");
        let found = bifdiag(&format!("critical-spin {body} --json")).succeeds().json();
        for family in found["families"].as_array().unwrap() {
            for stretch in family["stretches"].as_array().unwrap() {
                assert_ne!(stretch["stable"], "spectrum", "{body}");
                let isolated = stretch["isolated"].as_array().unwrap();
                assert!(isolated.is_empty() || stretch["stable"] == "arnold", "{body} {stretch}");
                for one in isolated {
                    exceptions += 1;
                    let place = match one["kind"].as_str().unwrap() {
                        "1:2" => "/near/1:2",
                        "1:3" => "/near/1:3",
                        _ => "/D4_over_s",
                    };
                    let spin = one["spin"]["rad_per_s"].as_f64().unwrap();
                    let beside = |factor: f64| -> Vec<f64> {
                        let spin = format!("{} rad/s", spin * factor);
                        let axes = bifdiag(&format!("critical {body} --json --spin")).and(spin).succeeds().json();
                        let axes = axes["axes"].as_array().unwrap().clone();
                        let branch = family["branch"].as_str().unwrap().to_owned();
                        let own = axes.iter().filter(|axis| axis["branch"].as_str().unwrap().starts_with(&branch));
                        own.filter_map(|axis| axis["nonlinear"].pointer(place)?.as_f64()).collect()
                    };
                    let (below, above) = (beside(1.0 - 1e-6), beside(1.0 + 1e-6));
                    let turns = below.iter().zip(&above).any(|(p, q)| (*p > 0.0) != (*q > 0.0));
                    assert!(turns && below.len() == above.len(), "{body} {one} {below:?} {above:?}");
                }
            }
        }
    }
    assert!(exceptions > 0);
}

/// The footer of `classes --at`: what stays so on the lines, and what is not counted.
#[test]
fn the_footer_of_a_standing_says_what_was_not_looked_at() {
    let reply = bifdiag("classes --at --body paper --lines 2").succeeds();
    reply
        .printing("what makes the body special (equal moments, zeros of r) is kept on the way")
        .printing("classes of more special bodies, such as those on a border, are not counted");
    let alone = bifdiag("classes --at --body euler --lines 1").succeeds().stdout();
    assert!(alone.contains("no border of its class was found"), "{alone}");
}

/// At the pitchfork of the hanging body (Ω = 1) its equilibrium is neither minimum nor saddle: the sphere says so.
#[test]
fn the_sphere_names_a_degenerate_equilibrium() {
    let place = tempfile::tempdir().unwrap();
    let line = |l: &str| format!("sphere --A 2,1.1,1 --r 0,0,1 --h 1 --l {l}");
    let drawn = |l: &str| {
        bifdiag(&line(l)).inside(place.path()).succeeds();
        std::fs::read_to_string(place.path().join("bifdiag-out/sphere.svg")).unwrap()
    };
    assert!(drawn("1").contains(">degenerate<") && !drawn("1.01").contains(">degenerate<"));
}

/// Only the pitchfork over an axis with r_i = 0 whose moment passes that of another goes to infinity; others stay.
#[test]
fn a_pitchfork_that_stays_is_not_said_to_go_to_infinity() {
    for (one, other) in [
        ("A=1,2,2;r=1,0,0", "A=1,2,2.1;r=1,0.1,0"),
        ("A=1,2,2;r=0,1,0", "A=1,1.99,2;r=0,1,1"),
        ("A=1,1,2;r=1,0,0", "A=1,1.5,2;r=0.5,1,0"),
        ("plate", "rod"),
    ] {
        let reply = bifdiag("compare").and(one).and(other).succeeds();
        assert!(!reply.stdout().contains("through infinity"), "{one} {other}\n{}", reply.stdout());
    }
}

#[test]
fn at_least_so_many_relative_equilibria_are_found() {
    bifdiag("find --critical-points 5").succeeds().printing("at least 5 isolated relative equilibria are shown by");
    // Each body shows as much.
    bifdiag("find --critical-points 1").refused().telling("a minimum and a maximum of U_l");
    for word in ["D6", "D₆", "−r̂", "member"] {
        bifdiag("explain").and(word).succeeds();
    }
    bifdiag("explain").and("−r̂").succeeds().printing("straight above");
    let few = bifdiag("find --critical-points 12 --samples 50").fails();
    few.telling("at least 12 isolated relative equilibria were not found among");
}

/// At l = 0 the two critical energies are ∓|r|: the margin bears the name that `critical` gives, and an exact one has no error.
#[test]
fn a_margin_at_rest_is_exact_and_named_as_critical_names_it() {
    for body in ["--A 2,1.1,1 --r 0,0,1", "--A 2,1.1,1 --r 3,0,4", "--body paper", "--body lagrange", "--body ten"] {
        let list = bifdiag(&format!("critical {body} --l 0 --json")).succeeds().json();
        for (h, which) in [("-20", 0), ("-1/7", 0), ("1/7", 1), ("20", 1)] {
            let found = bifdiag(&format!("classify {body} --h={h} --l 0 --json")).succeeds().json();
            let margin = &found["margin"];
            assert_eq!(margin["nearest"], list["critical"][which]["branch"], "{body} {h}");
            assert!(margin["error_bound"].as_f64().unwrap() <= 4e-15, "{body} {h} {margin}");
        }
    }
    bifdiag("classify --A 2,1.1,1 --r 3,0,4 --h 7 --l 0")
        .succeeds()
        .printing("margin: 2 in h to ")
        .printing("(error bound 0)");
    bifdiag("critical --A 2,1.1,1 --r 3,0,4 --l 0").succeeds().printing("error bound of h: 0\n");
}

#[test]
fn a_body_without_weight_at_rest_has_its_regions() {
    for body in ["--A 2,1.1,1", "--A 1,1,1", "--A 2,2,1"] {
        let found = bifdiag(&format!("state {body} --r 0,0,0 --axis z --json --spin")).and("0 rpm").succeeds().json();
        let above = &found["steady"]["regions"][1];
        let classified = bifdiag(&format!("classify {body} --r 0,0,0 --h 1 --l 0 --json")).succeeds().json();
        assert_eq!((&found["steady"]["regions"][0], above), (&Value::Null, &classified["region"]), "{found}");
        assert!(above.is_string() && found["steady"]["note"].is_null(), "{found}");
    }
    bifdiag("show l=0 --A 2,1.1,1 --r 0,0,0").succeeds().printing("the forbidden region and R1, R2, R3 meet");
    bifdiag("show l=0 --body paper").refused().telling("this body has nothing of that name");
}

#[test]
fn a_further_integral_names_the_orbit_of_its_value() {
    let run = |orbits: usize| {
        let line = format!("section --body kovalevskaya --region R1 --orbits {orbits} --crossings 5 --no-plot --json");
        bifdiag(&line).succeeds().json()["integrals"][0].clone()
    };
    let [one, several] = [1, 5].map(run);
    assert!(one["orbit"].is_null() && several["orbit"].is_u64(), "{one} {several}");
    let place = tempfile::tempdir().unwrap();
    let line = "section --body kovalevskaya --region R1 --orbits 5 --crossings 5 --no-plot";
    let named = format!("at the start of orbit {}, where it is largest", several["orbit"]);
    bifdiag(line).inside(place.path()).succeeds().printing(&named);
}

/// A rate of growth over a few returns is no mean.
#[test]
fn a_few_crossings_have_no_exponent() {
    for (crossings, has) in [(1, false), (47, false), (48, true)] {
        let line = format!("section --body paper --region R5 --orbits 1 --crossings {crossings} --no-plot --json");
        let found = bifdiag(&line).succeeds().json();
        assert_eq!(found["orbits"][0]["chaos"]["lyapunov"].is_object(), has, "{crossings}");
    }
}

#[test]
fn a_command_names_no_option_that_it_refuses() {
    for (line, with_parts) in
        [("classes --at", false), ("classify --h 1 --l 1", true), ("scan border --vary r1=0:1", false)]
    {
        let message = bifdiag(line).refused().stderr();
        assert_eq!(message.contains("--inertia-com"), with_parts, "{line}: {message}");
        let two = bifdiag(&format!("{line} --body paper --A 1,2,3 --r 1,0,0")).refused().stderr();
        assert!(!two.contains("--part"), "{line}: {two}");
    }
}

/// At a pitchfork the Hessian is singular, and its index is no question for rounded numbers; the branch is followed there all the
/// same.
#[test]
fn newton_continuation_reaches_a_pitchfork() {
    for body in ["--A 2,1.1,1 --r 0,0,1 --l 1", "--A 2,1,1 --r 1,0,0 --l=-2", "--A 2,1.5,1 --r 0,0,1 --l 1"] {
        let list = |method: &str| {
            let document = bifdiag(&format!("critical {body} --json{method}")).succeeds().json();
            document["critical"].as_array().unwrap().clone()
        };
        let (closed, followed) = (list(""), list(" --method newton"));
        assert!(closed.iter().any(|one| one["multiplicity"] == json!(2)), "{body}");
        assert_eq!(followed.len(), closed.len(), "{body}");
        for (one, other) in followed.iter().zip(&closed) {
            assert_eq!([&one["branch"], &one["index"]], [&other["branch"], &other["index"]], "{body}");
            assert!((one["h"].as_f64().unwrap() - other["h"].as_f64().unwrap()).abs() < 1e-12, "{body}");
        }
    }
}

#[test]
fn a_share_says_how_it_is_known() {
    bifdiag("class 69e5dfce4c33 --no-plot").succeeds().printing("bodies: 100%, because they differ only in scale\n");
    bifdiag("class 2614395a2a0f --no-plot").succeeds().printing("bodies: 100% of a sample of 2000 bodies\n");
}

#[test]
fn names_are_echoed_as_the_program_writes_them() {
    for (typed, written) in
        [("K1N1", "k1n1"), ("k1n1", "k1n1"), ("s1Xs2", "S1xS2"), ("s2-2d2", "S2-2D2"), ("t2+s2", "T2+S2")]
    {
        bifdiag(&format!("show {typed} --body paper"))
            .succeeds()
            .printing(&format!("\n{written} occurs in the region"));
    }
    bifdiag("show K7N9 --body paper").succeeds().printing("no region of this body has k7n9");
}

/// What a stranger stumbled over.
#[test]
fn refusals_and_tables_say_what_is_so() {
    let body = "--A 2.2,1.7,1.3 --r 0.3,-0.5,0.7";
    let limits = "|l| between 5.5e-46 and 4.5e44, or 0, is possible";
    bifdiag(&format!("critical {body} --l 1e-140")).refused().telling("--l: l = 1e-140").telling(limits);
    bifdiag("show R9 --A 2,2,1 --r 0,0,1")
        .refused()
        .telling("the regions R1 to R3, the curves")
        .telling("and the event E1");
    // l about the upward vertical has the other sign than about γ.
    let state = bifdiag(&format!("state {body} --omega 1,2,3 --vertical 0,0,1")).succeeds();
    assert!(state.stdout().contains("l = 3.9 about the upward vertical"), "{}", state.stdout());
    // A spin that does not depend on Ixx is not said to.
    let part = "--inertia-com 0.02±1%,0.03,0.04,0,0,0 --com 0,0,0.2 --mass 1.5 --axis z";
    let spins = bifdiag(&format!("critical-spin {part}")).succeeds();
    assert!(spins.stdout().lines().all(|row| !(row.contains("Ixx") && row.contains("e-1"))), "{}", spins.stdout());
    // One product of inertia moves the axes only.
    let one = "body --inertia-com 0.02,0.03,0.04,0.001,0,0 --com 0,0,0.2 --mass 1.5";
    bifdiag(one).refused().telling("0.01990098, 0.03009902, 0.04 with either sign, but the principal axes differ");
    let way = bifdiag("spin-down --A 1,1,2 --r 0,0,1 --from L-.1").succeeds();
    assert!(way.stdout().contains("L-.1 ends at l = 2 in a pitchfork, from which S12.1 continues"), "{}", way.stdout());
    let border = bifdiag("scan border --A 2.2,1.7,1.3 --r 0.3,0,0.7 --vary r2=0:0.5").succeeds();
    assert!(border.stdout().contains("crossing of G2 and P+ (2 times)"), "{}", border.stdout());
    assert!(!border.stdout().contains("0.00000000"), "{}", border.stdout());
}

/// The effective potential of a ball without weight is constant: no rounding is drawn as a level, and nothing is explained that
/// is not there.
#[test]
fn a_constant_potential_has_no_levels() {
    let place = tempfile::tempdir().unwrap();
    bifdiag("sphere --A 1,1,1 --r 0,0,0 --h 1 --l 1 --out ball").inside(place.path()).succeeds();
    let picture = std::fs::read_to_string(place.path().join("ball/sphere.svg")).unwrap();
    for absent in ["other levels", "not accessible"] {
        assert!(!picture.contains(absent), "{absent}");
    }
    assert!(picture.len() < 60_000, "{} bytes", picture.len());
    bifdiag("classes --at --A 2,1,4 --r 0,0.2,1 --physical")
        .refused()
        .telling("no mass distribution has these moments");
}

/// What an error is about stands in it.
#[test]
fn errors_name_what_is_wrong() {
    let part = "--inertia 0.03,0.03,0.02,0,0,0 --com 0,0,0.1 --mass 1 --axis z";
    bifdiag(&format!("critical-spin {part} --tolerance axis=1%,acros=2%"))
        .refused()
        .telling("\"acros\"")
        .telling("across");
    bifdiag("campbell --A 2,2,1 --r 0,0,1 --axis=w --to 60rpm").refused().telling("`w`").telling("x, y or z");
    bifdiag("body --inertia 0.0001,0.0001,0.00005,0,0,0 --com 0,0,0.01 --mass 20")
        .succeeds()
        .printing("the least principal moment is negative");
    let spins = bifdiag("critical-spin --A 2,2,2 --r 1,0,0 --axis z").succeeds();
    assert!(spins.stdout().contains("the axis that was given is steady at no spin"), "{}", spins.stdout());
}

/// Names that are told by other means, and sums of parts of U and E.
#[test]
fn surfaces_are_found_by_all_their_names() {
    bifdiag("show M1 --body paper").succeeds().printing("T2 occurs in the regions R2, R4, R5, R8");
    bifdiag("show D2+D2 --body paper").succeeds().printing("D2+D2 occurs in the regions R5, R8, R9");
    bifdiag("show k1n1+k1n1 --body paper").succeeds().printing("k1n1+k1n1 occurs in the region R8");
    bifdiag("show k1n1+k1n0 --body paper").succeeds().printing("occurs in the region R5");
    bifdiag("show S3+S3 --body paper").succeeds().printing("S3+S3 occurs in the regions R5, R8, R9");
    let stray = "--A 1.5,1,0.8 --r 0,1,4.52772148842394e-12";
    bifdiag(&format!("show S2 {stray}")).succeeds().printing("sample: ~h").printing("outside its region");
}
