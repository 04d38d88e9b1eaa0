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
    ("--A 2,1,1 --r 1,0,0 --mass 3", &["--mass is for a part (--inertia, --inertia-com or --part)", "with --A"]),
    ("critical-spin --A 5,1,1 --r 1,0,0 --unphysical", &["--unphysical is for a part", "leave it out with --A"]),
    ("--A 2,1,1 --r 1,0,0 --mass 3 --inertia 1,1,1,0,0,0", &["--A and --inertia both describe the body"]),
    ("--body paper --body euler", &["'--body <NAME>' cannot be used multiple times"]),
    // The moments.
    ("--A", &["a value is required for '--A <A1,A2,A3>'"]),
    ("--A --r 1,0,0", &["--A has no value (--r follows it)", "--A A1,A2,A3"]),
    ("--A= --r 1,0,0", &["'--A <A1,A2,A3>'", "0 given", "such as 2,1.1,1"]),
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
    // Periodic orbits.
    ("periodic family --body paper", &["--l is missing", "--l 1.5", "--h"]),
    ("periodic family --body paper --l 1 --from Q", &["--from Q", "no such curve", "G1.1"]),
    ("periodic family --body paper --h 1 --l 1", &["'--h <h>' cannot be used with '--l <l>'"]),
    ("periodic family --body paper --h -5", &["--h -5", "no equilibrium"]),
    ("periodic family --body paper --l 1 --members 0", &["--members 0", "at least one"]),
    // Words and comparisons.
    ("explain pichfork", &["WORD pichfork", "the nearest is pitchfork"]),
    ("compare paper nobody", &["BODY nobody", "`bifdiag bodies` lists them"]),
    ("classify --body paper --h 1 --l 1 --certificate --no-region", &["--certificate", "leave --no-region out"]),
    ("classify --body paper --grid -1:6:20,0:4:20 --no-region", &["--grid writes", "leave --no-region out"]),
    ("classify --body paper --grid -1:6:20,0:4:20 --json", &["leave --json out"]),
    ("classify --body paper --grid -1:6:20,0:4:20 --strict", &["leave --strict out"]),
    ("orbit --body paper --gamma 0,0.6,0.8 --omega 1,0,2 --phi pi/2/2", &["`pi/2/2` is not an angle", "pi/2"]),
    ("orbit --body paper --gamma 0,0.6,0.8 --omega 1,0,2 --phi pi/0", &["`pi/0` is not an angle"]),
    ("orbit --body paper --gamma 0,0.6,0.8 --omega 1,0,2 --phi pi*2", &["`pi*2` is not an angle"]),
    ("orbit --body paper --gamma 0,0.6,0.8 --omega 1,0,2 --phi *pi", &["`*pi` is not an angle"]),
    ("orbit --body paper --euler 1,pi/0,0 --omega 1,0,0", &["`pi/0` is not an angle"]),
    ("critical --body paper --l 0:1e100:3", &["--l: l = 5e99 is too large"]),
    ("critical --body paper --l 0:1e100:3 --json", &["--l: l = 5e99 is too large"]),
    ("orbit --body paper --gamma 0,0.6,0.8 --omega 1,0,2 --phi pi/1e200", &["`1e200` is out of range"]),
    ("find --type M4 --moment-ratio 1e200", &["`1e200` is out of range"]),
    ("find --type M4 --moment-ratio 9/10", &["a ratio is a number of 1 or more"]),
    ("show D2+k1n1 --body paper", &["nothing of that name"]),
    ("orbit --body paper --times 1e100:1:3", &["t0 = 1e100 is above t1 = 1"]),
    ("orbit --body paper --euler 9,0,0 --omega 1,0,0", &["--euler: theta = 9", "from 0 to pi"]),
    // Pictures.
    ("--body paper --width 86", &["'86' for '--width <LENGTH>'", "none of the units", "such as 86mm or 246pt"]),
    ("--body paper --width 2in", &["2in is out of range", "from 80mm to 500mm"]),
    ("sphere --body paper --region R1 --width widemm", &["'widemm' for", "`wide` is not a number"]),
    ("--body paper --width 1e100mm", &["1e100mm is out of range", "from 80mm to 500mm"]),
    ("--body paper --width 1e200mm", &["`1e200` is out of range"]),
    ("--body paper --dpi 10", &["'10' for '--dpi <N>'", "between 30 and 2400"]),
    ("--body paper --legend above", &["'above' for '--legend", "auto, none, below, file"]),
    // Named bodies.
    ("--body nobody", &["'nobody' for '--body <NAME>'", "kovalevskaya"]),
    ("--body katok:8", &["'katok:8' for '--body <NAME>'", "katok:7"]),
    // Real parts.
    ("--inertia 1,1,1,0,0,0 --mass 2 --g 9.81", &["--com is missing", "--inertia also needs it", "--com 0,0.02,0.15"]),
    ("--inertia 1,1,1,0,0,0 --com 0,0,1 --g 9.81", &["--mass is missing", "--mass 2.5"]),
    ("--mass 2", &["--inertia or --inertia-com is missing", "--mass also needs it"]),
    (
        "--inertia 1,1,1 --com 0,0,1 --mass 2 --g 9.81",
        &["'1,1,1' for '--inertia", "3 numbers given", "Ixx,Iyy,Izz,Ixy,Ixz,Iyz"],
    ),
    ("--inertia 1,1,1,0,q,0 --com 0,0,1 --mass 2 --g 9.81", &["Ixz: `q` is not a number"]),
    (
        "--inertia 1,1,1,2,0,0 --com 0,0,1 --mass 2 --g 9.81",
        &["--products is missing", "-1, 1, 3 with either sign, but the principal axes differ", "∫ x y dm"],
    ),
    (
        "--inertia 1,1,1,0,0,0 --com 0,1 --mass 2 --g 9.81",
        &["'0,1' for '--com <x,y,z>'", "2 numbers given", "0,0.02,0.15"],
    ),
    (
        "--inertia 1,1,1,0,0,0 --com 0,0,1 --mass 0 --g 9.81",
        &["'0' for '--mass <m>'", "greater than zero", "such as kg"],
    ),
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
    ("critical --body paper --l 1e", &["'1e' for '--l <l|a:b:n>'"]),
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
    (
        "verify no-such-atlas.json",
        &["no-such-atlas.json", "give an atlas.json or the proof of a point that can be read"],
    ),
    ("verify", &["<ATLAS.json>"]),
    ("--body paper --accuracy high", &["'high' for '--accuracy <ACCURACY>'", "exact, fast"]),
    ("--body paper --accuracy certified", &["'certified' for '--accuracy <ACCURACY>'", "exact, fast", "--certificate"]),
    ("classify --body paper --h 1 --l 1 --accuracy standard", &["'standard'", "exact, fast", "leave it out"]),
    ("scan --family katok --samples 3 --out - --accuracy draft", &["'draft'", "exact, fast", "`fast`"]),
    ("--body paper --certificate --window 0:4,0:3", &["--certificate covers the whole plane", "--window"]),
    ("--body paper --certificate --accuracy fast", &["--certificate needs exact answers", "--accuracy fast"]),
    ("--body paper --format gif", &["'gif' for '--format <FORMAT>'", "svg, png, "]),
    ("--body paper --out -", &["--out -", "a directory is needed, such as --out pictures"]),
    ("--body paper --out", &["a value is required for '--out <DIR>'"]),
    ("--body paper --threads 0", &["'0' for '--threads <N>'", "from 1 to 1024"]),
    ("--body paper --threads -3", &["'-3' for '--threads <N>'", "whole number"]),
    ("--body paper --threads 1.5", &["'1.5' for '--threads <N>'"]),
    ("--body paper -q -v", &["'--quiet' cannot be used with '--verbose...'"]),
    // Scans.
    ("scan", &["no bodies are given", "--family general --samples 100000", "--vary A2=0.5:2:200"]),
    ("scan --family general", &["--samples is missing", "such as --vary A2=0.5:2:200"]),
    ("scan --family general --samples 5", &["--out is missing", "--out scan.parquet", "stdout"]),
    ("scan --family moon --samples 5 --out a.csv", &["'moon' for '--family <FAMILY>'", "general, positive, katok"]),
    ("scan --family general --samples 0 --out a.csv", &["0 is not in 1.."]),
    (
        "scan --family general --samples 5 --out a.txt",
        &["--out a.txt", "the extension does not give the format", ".parquet, .csv or .jsonl"],
    ),
    ("scan --family general --samples 5 --format parquet --out -", &["--out -", "Parquet", "--format csv"]),
    ("scan --family general --samples 5 --json --out -", &["--json and --out - both want stdout"]),
    ("scan --family general --samples 5 --out a.csv --shard 4/3", &["'4/3' for '--shard <i/n>'", "1 ≤ i ≤ n", "3/16"]),
    ("scan --family general --samples 5 --out a.csv --shard 1", &["'1' for '--shard <i/n>'", "written i/n"]),
    (
        "scan --family general --samples 5 --out no/such/folder/a.csv",
        &["--out no/such/folder/a.csv", "No such file", "an existing folder"],
    ),
    ("scan --family general --samples 5 --body paper --out a.csv", &["--family and --body both describe the bodies"]),
    ("scan --family general --vary A2=1:2:3 --out a.csv", &["--vary", "the family chooses every parameter itself"]),
    ("scan --family katok --vary A1=1:2:3 --out a.csv", &["--vary", "keeps A1 fixed", "A2 and A3"]),
    ("scan --family katok --vary A2=1:2:3 --samples 5 --out a.csv", &["--samples", "a grid has its own number"]),
    (
        "scan --family katok --vary A2=1:2:3,A3=1:2 --out a.csv",
        &["--vary", "A3 has no number of values", "A3=from:to:N"],
    ),
    ("scan --body paper --out a.csv", &["--vary", "nothing varies", "A2=0.5:2:200"]),
    (
        "scan --body paper --vary A4=1:2:3 --out a.csv",
        &["'A4=1:2:3' for '--vary", "`A4` is no parameter", "A1, A2, A3, r1, r2, r3"],
    ),
    ("scan --body paper --vary A2=2:1:3 --out a.csv", &["A2=2:1 is empty", "lower end first"]),
    ("scan --body paper --vary A2=1:2:1 --out a.csv", &["`1` is no number of grid values"]),
    ("scan --body paper --vary A2=0:2:3 --out a.csv", &["A2 = 0 is no moment of inertia"]),
    ("scan --body paper --vary A2 --out a.csv", &["'A2' for '--vary", "a range is written A2=0.5:2"]),
    ("scan --body paper --vary A2=1:2:3,A2=1:2:3 --out a.csv", &["--vary: A2 is given twice"]),
    ("scan merge --out a.csv", &["merge needs shards", "shard-*.parquet"]),
    ("scan merge nothing.csv --out a.csv", &["nothing.csv", "No such file", "name the shards"]),
    ("scan merge nothing.csv", &["--out is missing"]),
    ("scan map nothing.csv --x A2 --y A3", &["nothing.csv", "No such file"]),
    ("scan map nothing.txt --x A2 --y A3", &["nothing.txt", ".parquet, .csv or .jsonl"]),
    ("scan map nothing.csv --x A7 --y A3", &["'A7' for '--x <PARAMETER>'", "A1, A2, A3, r1, r2, r3"]),
    ("scan map nothing.csv --x A2 --y A2", &["--y A2: both axes show the same parameter"]),
    ("scan border --vary A3=0.7:0.8", &["no body is given"]),
    ("scan border --body katok:2", &["--vary is missing", "such as --vary A3=0.7:0.8"]),
    ("scan border --body katok:2 --vary A3=0.7:0.8:3", &["--vary", "A3=from:to"]),
    ("scan border --body katok:2 --vary A3=0.8:0.85", &["--vary", "both ends have the class"]),
    ("scan border --body katok:2 --vary A3=-1:0.85", &["--vary", "A3 = -1 is not positive"]),
    // Searches.
    ("classes --body paper", &["--body", "add --at"]),
    ("classes --at", &["no body is given", "--A 2,1.1,1"]),
    ("classes --lines 5", &["--at"]),
    ("classes --at --body paper --lines 0", &["0 is not in 1..=1000000"]),
    ("class", &["<NAME>"]),
    ("class xyz", &["NAME xyz", "no built-in class begins with it", "bifdiag classes --at"]),
    ("class 0", &["NAME 0", "classes begin with it", "give more digits"]),
    ("find", &["no target is given", "--type M4", "--circles 3 --poles 1"]),
    ("find --type X4", &["--type", "`X4` is no type", "M4", "k3n1"]),
    ("find --signature S2+X", &["--signature", "`X` is no section", "S2+T2"]),
    ("find --type M4 --circles 3", &["'--type <TYPE>' cannot be used with '--circles <K>'"]),
    ("find --poles 3", &["3 is not in 0..=2"]),
    ("find --type M4 --moment-ratio 0.5", &["'0.5' for '--moment-ratio <R>'", "a number of 1 or more"]),
    // Sections.
    ("section --h 1 --l 1", &["no body is given"]),
    ("section --body paper --l 3.25", &["--h is missing", "--h 4.45", "--region R4"]),
    ("section --body paper --h 4.45", &["--l is missing", "--l 3.25"]),
    (
        "section --body paper --h 1.5 --l 3.25",
        &["(h, l) = (1.5, 3.25) is forbidden", "the lowest energy at l = 3.25 is 1.63969940", "G2.1", "choose h above"],
    ),
    ("section --body paper --h -2 --l 0", &["forbidden", "the lowest energy at l = 0 is -1.13125"]),
    ("section --body kovalevskaya --h 2 --l 2", &["(2, 2) lies on the curve", "topology changes", "choose h"]),
    ("section --body paper --h 1.6396994084479426 --l 3.25", &["too near to the curve", "error bound"]),
    ("section --body euler --h 2 --l 1", &["r = 0", "this section does not exist", "r ≠ 0"]),
    ("section --body paper --h 4 --l 1e60", &["--l"]),
    ("section --body paper --h 4 --l 3 --orbits 0", &["'0' for '--orbits <N>'", "whole number from 1"]),
    ("section --body paper --h 4 --l 3 --crossings -5", &["'-5' for '--crossings <M>'", "whole number"]),
    ("section --body paper --h 4 --l 3 --seed x", &["'x' for '--seed <K>'", "whole number"]),
    (
        "scan border --body paper --vary A2=1.1:1.1",
        &["A2=1.1:1.1 is one value, at which nothing varies; write two different"],
    ),
    ("scan border --body paper --vary A2=1.2:1.1", &["A2=1.2:1.1 is empty; write the lower end first"]),
    ("section --body paper --h 4 --l 3 --max-time 0", &["'0' for '--max-time <T>'", "greater than zero"]),
    ("section --body paper --h 4.45 --l 3.25 --tol 1e-30", &["'1e-30' for '--tol <TOL>'", "1e-18 to 1e-2"]),
    ("section --body paper --h 4.45 --l 3.25 --integrator rk4", &["--integrator was removed", "--tol 1e-12", "Taylor"]),
    ("section --body paper --h 4.45 --l 3.25 --integrator=dop853", &["--integrator was removed", "--tol 1e-12"]),
    ("section --body paper --h 4.45 --l 3.25 --step 0.1", &["--step was removed", "--tol 1e-12", "Taylor"]),
    ("section --body paper --h 4 --l 3 --condition height2", &["'height2' for '--condition", "angular-momentum"]),
    ("section --body paper --h 4 --l 3 --projection plane", &["'plane' for '--projection", "torus, sphere, both"]),
    ("section --body paper --h 4 --l 3 --color red", &["'red' for '--color", "orbit, lyapunov, rotation"]),
    ("section --body paper --h 4 --l 3 --data points.txt", &["'points.txt' for '--data <FILE>'", "FILE.npz, FILE.csv"]),
    ("section --body paper --h 4 --l 3 --data points", &["'points' for '--data", "extension"]),
    ("section --body paper --h 4.45 --l 3.25 --data - --json", &["--data - and --json both want stdout"]),
    ("section --body paper --h 4.45 --l 3.25 --out -", &["--out -", "a directory is needed"]),
    ("section --body paper --h 4 --l 3 --region R1", &["--region and --h both give the point"]),
    ("section --atlas no/such --region R1", &["--atlas no/such", "No such file", "atlas.json"]),
    ("section --atlas - --body paper", &["--atlas and --body both say", "leave out --body"]),
    ("section --atlas - --h 3", &["--atlas and --h both say"]),
    ("section --atlas -", &["--atlas - is not an atlas of version 3", "bifdiag atlas --json"]),
    ("section --body paper --h 4.45 --l 3.25 --starts no/such.csv", &["--starts no/such.csv", "No such file"]),
    ("section --body paper --h 4.45 --l 3.25 --starts -", &["--starts - holds no start", "theta,psi,sheet"]),
    ("section --body paper --h 4.45 --l 3.25 --starts - --orbits 3", &["--orbits cannot be used with --starts"]),
    ("section --body paper --h 4.45 --l 3.25 --seeds x.csv", &["--seeds was removed; use --starts FILE.csv"]),
    ("section --body paper --h 4.45 --l 3.25 --rng-seed=7", &["--rng-seed was removed; use --seed K"]),
    // Orbits.
    ("orbit --gamma 1,0,0 --omega 1,1,1", &["no body is given"]),
    ("orbit --body paper", &["no start is given", "--gamma 0.6,0,0.8", "--theta 1.2"]),
    ("orbit --body paper --gamma 1,0,0", &["--omega or --l-vector is missing", "--omega 1,0.3,1"]),
    ("orbit --body paper --omega 1,0,0", &["--gamma is missing", "--omega also needs it"]),
    ("orbit --body paper --gamma 1,0,0 --omega 1,0,0 --l-vector 1,0,0", &["--l-vector and --omega both describe"]),
    ("orbit --body paper --gamma 1,0,0 --h 3", &["--gamma and --h both describe the start"]),
    ("orbit --body paper --gamma 0,0,0 --omega 1,0,0", &["'0,0,0' for '--gamma", "zero vector has no direction"]),
    ("orbit --body paper --gamma 1,0 --omega 1,0,0", &["'1,0' for '--gamma", "2 numbers given"]),
    ("orbit --body paper --h 4.45 --l 3.25 --theta 1", &["--psi is missing", "such as --psi pi/2"]),
    ("orbit --body paper --h 4.45 --l 3.25 --theta 4 --psi 0", &["--theta 4", "from 0 to pi"]),
    ("orbit --body paper --h 4.45 --l 3.25 --theta x --psi 0", &["'x' for '--theta <ANGLE>'"]),
    ("orbit --body paper --h 4.45 --l 3.25 --theta 1 --psi 0 --sheet 2", &["'2' for '--sheet", "+ (or 1)"]),
    ("orbit --body paper --h 1 --l 3.25 --theta 1 --psi 0", &["not accessible", "U = 4.66", "--h 1"]),
    ("orbit --body euler --h 1 --l 1 --theta 1 --psi 0", &["need r ≠ 0", "--gamma"]),
    ("orbit --body paper --gamma 1,0,0 --omega 1,1,1 --times 0:1", &["'0:1' for '--times", "t0:t1:n"]),
    ("orbit --body paper --gamma 1,0,0 --omega 1,1,1 --times 1:0:5", &["t0 = 1 is above t1 = 0"]),
    ("orbit --body paper --gamma 1,0,0 --omega 1,1,1 --times 0:1:x", &["n = `x` is not a whole number"]),
    (
        "orbit --body paper --gamma 1,0,0 --omega 1,1,1 --times no/such",
        &["--times no/such", "No such file", "0:10:101"],
    ),
    ("orbit --body paper --gamma 1,0,0 --omega 1,1,1 --data x.dat", &["'x.dat' for '--data", "extension"]),
    ("orbit --body paper --gamma 1,0,0 --omega 1,1,1 --json --data -", &["--data - and --json both want stdout"]),
    ("orbit --body paper --gamma 1,0,0 --omega 1,1,1 --integrator splitting", &["--integrator was removed", "--tol"]),
    ("orbit --body paper --gamma 1,0,0 --omega 1,1,1 --tol 1", &["'1' for '--tol <TOL>'", "1e-18 to 1e-2"]),
    // Commands.
    ("frobnicate", &["unrecognized subcommand 'frobnicate'"]),
    ("clasify --body paper", &["unrecognized subcommand 'clasify'", "classify"]),
    ("--body paper classify --h 1 --l 1", &["--body is before the command classify", "bifdiag classify --body"]),
    ("--json bodies", &["--json is before the command bodies"]),
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

#[test]
fn wrong_lines_of_seeds_are_numbered() {
    let line = "section --body paper --h 4.45 --l 3.25 --starts -";
    for (seeds, message) in [
        ("theta,psi\n1,2\n", "line 1: the header `theta,psi` lacks sheet"),
        ("theta,psi,sheet\n1.2,1.5,1\n1,2\n", "line 3: 2 values, but the header has 3"),
        ("theta,psi,sheet\none,2,1\n", "line 2: theta = `one` is not a number"),
        ("theta,psi,sheet\n4,2,1\n", "line 2: theta = 4 is not between 0 and pi"),
        ("theta,psi,sheet\n1,2,0\n", "line 2: sheet = `0` is neither 1 (T+) nor -1 (T-)"),
        ("theta,psi,sheet\n0.9,1.5,1\n\n1.9,pi,1\n", "line 4: the point is not accessible: U = "),
    ] {
        bifdiag(line).reading(seeds).refused().printing_nothing().telling(message);
    }
}

#[test]
fn unknown_regions_are_reported_with_those_that_are_there() {
    let atlas = bifdiag("--body kovalevskaya --json").succeeds().stdout();
    let done = bifdiag("section --atlas - --region R99").reading(atlas.clone()).refused();
    done.telling("--region R99: the body has no such region; it has R1, R2").telling("or give all");
    bifdiag("section --atlas - --data -").reading(atlas).refused().telling("several sections do not fit one table");
    bifdiag("section --atlas -").reading("{\"schema_version\": \"3\"}").refused().telling("missing field `accuracy`");
}

/// They were taken for kg,m,s.
#[test]
fn units_of_a_part_in_an_atlas_that_do_not_exist_are_refused() {
    let line = "atlas --inertia 0.3,0.4,0.5,0,0,0 --com 0.02,0,0.15 --mass 2 --json";
    let forged = bifdiag(line).succeeds().stdout().replace("kg,m,s", "kg,fathom,s");
    let done = bifdiag("section --atlas - --region R1 --json").reading(forged).refused();
    done.telling("the units of its part: `fathom` is no unit of length");
}
