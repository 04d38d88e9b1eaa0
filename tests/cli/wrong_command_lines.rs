//! Command lines that are wrong: each with its exit status 2 and what the message says.

use crate::builder::bifdiag;

/// Words of the command line, and parts of the message: the argument, the value, what would be right.
const REFUSED: &[(&str, &[&str])] = &[
    // No body, or half of one, or two.
    ("", &["Usage: bifdiag", "Examples:"]),
    ("atlas", &["no body is given", "--A 2,1.1,1 --r 0.94868,0,0.61623", "--body paper"]),
    ("--json", &["no body is given", "--inertia"]),
    ("classify --h 1 --l 1", &["no body is given"]),
    ("critical --l 1", &["no body is given"]),
    ("--A 2,1.1,1", &["--r is missing", "such as --r 0.94868,0,0.61623"]),
    ("--r 1,0,0", &["--A is missing", "such as --A 2,1.1,1"]),
    ("--A 2,1,1 --r 1,0,0 --body paper", &["--A and --body both describe the body", "give one of"]),
    ("--body paper --inertia 1,1,1,0,0,0", &["--body and --inertia both describe the body"]),
    ("--A 2,1,1 --r 1,0,0 --mass 3", &["--A and --mass both describe the body"]),
    ("--body paper --body euler", &["'--body <NAME>' cannot be used multiple times"]),
    // The moments.
    ("--A", &["a value is required for '--A <A1,A2,A3>'"]),
    ("--A --r 1,0,0", &["--A has no value (--r follows it)", "--A A1,A2,A3"]),
    ("--A= --r 1,0,0", &["'--A <A1,A2,A3>'", "1 given", "such as 2,1.1,1"]),
    ("--A 2,1.1 --r 1,0,0", &["'2,1.1' for '--A <A1,A2,A3>'", "three moments of inertia, 2 given", "such as 2,1.1,1"]),
    ("--A 2,1,1,1 --r 1,0,0", &["'2,1,1,1' for '--A", "4 given"]),
    ("--A 2,0,1 --r 1,0,0", &["'2,0,1' for '--A", "A2 = 0 is not positive", "greater than zero"]),
    ("--A 2,1,-1 --r 1,0,0", &["A3 = -1 is not positive"]),
    ("--A -2,1,1 --r 1,0,0", &["'-2,1,1' for '--A", "A1 = -2 is not positive"]),
    ("--A nan,1,1 --r 1,0,0", &["A1: `nan` is not finite"]),
    ("--A 2,inf,1 --r 1,0,0", &["A2: `inf` is not finite"]),
    ("--A 2,,1 --r 1,0,0", &["A2: the number is missing"]),
    ("--A two,1,1 --r 1,0,0", &["A1: `two` is not a number", "1.1", "11/10"]),
    ("--A 2,1/0,1 --r 1,0,0", &["A2: `1/0` has denominator zero"]),
    ("--A 1e200,1,1 --r 1,0,0", &["A1: `1e200` is out of range", "1e150"]),
    ("--A 2;1;1 --r 1,0,0", &["'2;1;1'", "1 given", "commas"]),
    // The centre of mass.
    ("--A 2,1,1 --r 1,0", &["'1,0' for '--r <r1,r2,r3>'", "three coordinates, 2 given", "0.94868,0,0.61623"]),
    ("--A 2,1,1 --r 1,0,0x10", &["r3: `0x10` is not a number"]),
    ("--A 2,1,1 --r=1,-inf,0", &["r2: `-inf` is not finite"]),
    // Named bodies.
    ("--body nobody", &["'nobody' for '--body <NAME>'", "kovalevskaya"]),
    ("--body katok:8", &["'katok:8' for '--body <NAME>'", "katok:7"]),
    // Real parts.
    (
        "--inertia 1,1,1,0,0,0 --mass 2 --g 9.81",
        &["--com is missing", "--inertia also needs it", "--com 0,0.02,0.15 (m)"],
    ),
    ("--inertia 1,1,1,0,0,0 --com 0,0,1 --g 9.81", &["--mass is missing", "--mass 2.5 (kg)"]),
    ("--inertia 1,1,1,0,0,0 --com 0,0,1 --mass 2", &["--g is missing", "--g 9.80665"]),
    ("--mass 2", &["--inertia is missing", "--mass also needs it"]),
    (
        "--inertia 1,1,1 --com 0,0,1 --mass 2 --g 9.81",
        &["'1,1,1' for '--inertia", "3 numbers given", "Ixx,Iyy,Izz,Ixy,Ixz,Iyz"],
    ),
    ("--inertia 1,1,1,0,q,0 --com 0,0,1 --mass 2 --g 9.81", &["Ixz: `q` is not a number"]),
    (
        "--inertia 1,1,1,2,0,0 --com 0,0,1 --mass 2 --g 9.81",
        &["--inertia 1,1,1,2,0,0", "not positive definite", "2x2", "about the fixed point"],
    ),
    (
        "--inertia 1,1,1,0,0,0 --com 0,1 --mass 2 --g 9.81",
        &["'0,1' for '--com <x,y,z>'", "2 numbers given", "0,0.02,0.15"],
    ),
    ("--inertia 1,1,1,0,0,0 --com 0,0,1 --mass 0 --g 9.81", &["'0' for '--mass <m>'", "greater than zero", "in kg"]),
    (
        "--inertia 1,1,1,0,0,0 --com 0,0,1 --mass 1 --g -9.81",
        &["'-9.81' for '--g <g>'", "must not be negative", "9.80665"],
    ),
    // The point.
    ("classify --body paper --l 1", &["--h is missing", "such as --h 3.8", "--batch FILE"]),
    ("classify --body paper --h 1", &["--l is missing", "such as --l 3.25"]),
    ("classify --body paper --h x --l 1", &["'x' for '--h <h>'", "`x` is not a number"]),
    ("classify --body paper --h 1 --l nan", &["'nan' for '--l <l>'", "not finite"]),
    ("classify --body paper --h 1,5 --l 1", &["'1,5' for '--h <h>'", "write a decimal (1.1)"]),
    ("classify --body paper --h --l 1", &["--h has no value (--l follows it)"]),
    ("critical --body paper", &["--l is missing", "such as --l 3.25"]),
    ("critical --body paper --l 1e", &["'1e' for '--l <l>'"]),
    ("critical --body paper --l 1 --h 2", &["unexpected argument '--h'"]),
    // Batches.
    ("classify --batch no/such/file", &["--batch no/such/file", "No such file", "- for stdin"]),
    ("classify --batch .", &["--batch .", "directory"]),
    ("classify --batch - --h 1", &["--h cannot be used with --batch", "leave out"]),
    ("classify --batch - --l 1", &["--l cannot be used with --batch"]),
    ("critical --batch - --l 1", &["--l cannot be used with --batch"]),
    ("classify --body paper --h 1 --l 1 --strict", &["--strict needs --batch"]),
    ("critical --body paper --l 1 --strict", &["--strict needs --batch"]),
    ("classify --batch - --A 2,1,1", &["--r is missing"]),
    // What is computed and written.
    ("--body paper --window 0:6", &["'0:6' for '--window <hmin:hmax,lmin:lmax>'", "such as 0:6,0:4"]),
    ("--body paper --window 0-6,0-4", &["'0-6,0-4' for '--window", "such as 0:6,0:4"]),
    ("--body paper --window 6:0,0:4", &["hmin = 6 is not below hmax = 0", "lower end first"]),
    ("--body paper --window 0:6,1:1", &["lmin = 1 is not below lmax = 1"]),
    ("--body paper --window 0:6,-1:4", &["lmin = -1 is negative", "lmin ≥ 0"]),
    ("--body paper --window 0:inf,0:4", &["hmax: `inf` is not finite"]),
    ("verify no-such-atlas.json", &["no-such-atlas.json", "give an atlas.json that can be read"]),
    ("verify", &["<ATLAS.json>"]),
    ("--body paper --accuracy high", &["'high' for '--accuracy <ACCURACY>'", "draft, standard, certified"]),
    ("--body paper --format gif", &["'gif' for '--format <FORMAT>'", "svg, png, pdf"]),
    ("--body paper --out -", &["--out -", "a directory is needed", "--json"]),
    ("--body paper --out", &["a value is required for '--out <DIR>'"]),
    ("--body paper --threads 0", &["'0' for '--threads <N>'", "from 1 to 1024"]),
    ("--body paper --threads -3", &["'-3' for '--threads <N>'", "whole number"]),
    ("--body paper --threads 1.5", &["'1.5' for '--threads <N>'"]),
    ("--body paper -q -v", &["'--quiet' cannot be used with '--verbose...'"]),
    // Commands.
    ("frobnicate", &["unrecognized subcommand 'frobnicate'"]),
    ("clasify --body paper", &["unrecognized subcommand 'clasify'", "classify"]),
    ("--body paper classify --h 1 --l 1", &["--body stands before the command classify", "bifdiag classify --body"]),
    ("--json bodies", &["--json stands before the command bodies"]),
    ("--boddy paper", &["unexpected argument '--boddy'", "--body"]),
    ("schema nothing", &["'nothing' for '[NAME]'", "atlas"]),
    ("completions ksh", &["'ksh' for '<SHELL>'", "bash"]),
    ("completions", &["<SHELL>"]),
];

#[test]
fn each_is_refused_with_its_message_and_nothing_on_stdout() {
    assert!(REFUSED.len() >= 40);
    let directory = tempfile::tempdir().unwrap();
    for (line, messages) in REFUSED {
        let mut done = bifdiag(line).inside(directory.path()).refused().printing_nothing();
        for message in *messages {
            done = done.telling(message);
        }
    }
    assert_eq!(std::fs::read_dir(directory.path()).unwrap().count(), 0, "a refused run has left something behind");
}

#[test]
fn blanks_around_numbers_are_accepted_but_not_instead_of_commas() {
    bifdiag("critical --l 1 --A").and(" 2, 1.1 ,1 ").and("--r").and("1, 0, 0").succeeds();
    bifdiag("critical --l 1 --r 1,0,0 --A").and("2 1.1 1").refused().telling("1 given").telling("commas");
}
