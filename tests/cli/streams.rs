//! Standard output and signals: full disks, readers that go, interrupts.
#![cfg(unix)]

use std::fs::{self, File};
use std::io::{BufRead, BufReader, Read, Write};
use std::path::Path;
use std::process::{Child, Command, Output, Stdio};
use std::time::{Duration, Instant};

use crate::builder::{PROGRAM, bifdiag};

fn spawn(arguments: &[&str]) -> Child {
    Command::new(PROGRAM)
        .args(arguments)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap()
}

fn signal(child: &Child, name: &str) {
    let status = Command::new("kill").args([name, &child.id().to_string()]).status().unwrap();
    assert!(status.success());
}

fn stderr(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

#[test]
#[cfg(target_os = "linux")]
fn a_full_disk_behind_stdout_is_reported() {
    for arguments in [&["--help"][..], &["bodies"], &["--body", "paper", "--json"], &["schema", "atlas"]] {
        let full = File::options().write(true).open("/dev/full").unwrap();
        let output = Command::new(PROGRAM).args(arguments).stdout(full).output().unwrap();
        assert_eq!(output.status.code(), Some(1), "{arguments:?}");
        assert!(stderr(&output).contains("cannot write to standard output: No space left on device"), "{output:?}");
    }
}

#[test]
#[cfg(target_os = "linux")]
fn a_closed_stdout_is_reported_and_nothing_else_is_written_there() {
    for arguments in ["--help", "bodies", "--body paper --json", "man", "classify --body paper --h 3.8 --l 3.25"] {
        let closed = format!("exec '{PROGRAM}' {arguments} >&-");
        let output = Command::new("sh").args(["-c", &closed]).output().unwrap();
        assert_eq!(output.status.code(), Some(1), "{arguments}");
        assert_eq!(stderr(&output), "error: cannot write to standard output: it is closed\n", "{arguments}");
    }
    // A batch without lines has nothing to write.
    let empty = format!("exec '{PROGRAM}' classify --batch /dev/null >&-");
    assert!(Command::new("sh").args(["-c", &empty]).status().unwrap().success());
}

#[test]
fn a_stdout_that_is_thrown_away_is_no_failure() {
    let discarded = File::options().read(true).write(true).open("/dev/null").unwrap();
    let output = Command::new(PROGRAM).arg("bodies").stdout(discarded).output().unwrap();
    assert_eq!((output.status.code(), stderr(&output)), (Some(0), String::new()));
}

#[test]
fn a_reader_that_has_gone_ends_the_run_quietly() {
    for arguments in [&["--help"][..], &["bodies"], &["--body", "paper", "--json"], &["man"]] {
        let mut child = spawn(arguments);
        drop(child.stdout.take());
        let output = child.wait_with_output().unwrap();
        assert_eq!((output.status.code(), stderr(&output)), (Some(0), String::new()), "{arguments:?}");
    }
}

#[test]
fn a_reader_that_takes_one_line_of_a_batch_ends_it_quietly() {
    let mut child = spawn(&["classify", "--body", "paper", "--batch", "-"]);
    let mut stdin = child.stdin.take().unwrap();
    // Ends with a broken pipe of its own when the program has gone.
    let writer = std::thread::spawn(move || while stdin.write_all(b"{\"h\":1,\"l\":1}\n").is_ok() {});
    let mut line = String::new();
    BufReader::new(child.stdout.take().unwrap()).read_line(&mut line).unwrap();
    assert!(line.ends_with("}\n"));
    let output = child.wait_with_output().unwrap();
    writer.join().unwrap();
    assert_eq!((output.status.code(), stderr(&output)), (Some(0), String::new()));
}

#[test]
fn a_closed_stderr_is_no_reason_to_fail() {
    let mut child = spawn(&["critical", "--A", "9,1,1", "--r", "1,0,0", "--l", "1", "--timings", "-vv"]);
    drop(child.stderr.take());
    assert_eq!(child.wait_with_output().unwrap().status.code(), Some(0));
}

#[test]
fn interrupts_end_a_batch_between_lines() {
    for name in ["-INT", "-TERM", "-HUP"] {
        let mut child = spawn(&["classify", "--body", "paper", "--batch", "-"]);
        let mut stdin = child.stdin.take().unwrap();
        let mut stdout = BufReader::new(child.stdout.take().unwrap());
        stdin.write_all(b"{\"h\":1,\"l\":1}\n{\"h\":2,\"l\":1}\n{\"h\"").unwrap();
        let mut answers = String::new();
        stdout.read_line(&mut answers).unwrap();
        stdout.read_line(&mut answers).unwrap();
        signal(&child, name);
        stdout.read_to_string(&mut answers).unwrap();
        let output = child.wait_with_output().unwrap();
        drop(stdin);
        assert_eq!(output.status.code(), Some(1), "{name}");
        assert!(stderr(&output).contains("interrupted"), "{name}: {}", stderr(&output));
        assert_eq!(answers.lines().count(), 2);
        assert!(answers.ends_with("}\n"));
    }
}

/// Each of them would go on for minutes, the last ones without ever looking whether they are to stop, or for ever at a
/// reader that takes nothing.
#[test]
fn interrupts_end_every_command_within_a_second() {
    let place = tempfile::tempdir().unwrap();
    let scan = format!("scan --family general --samples 1000000 --out {}", place.path().join("s.csv").display());
    let commands = [
        scan.as_str(),
        "find --type M4 --all --samples 1000000000",
        "orbit --body paper --gamma 0.6,0,0.8 --omega 1,0.3,1 --times 0:1e9:2 --json",
        "section --body paper --h 4.45 --l 3.25 --crossings 100000000 --no-plot --json",
        "scan --family general --samples 1000000 --out -",
    ];
    for command in commands {
        for name in ["-INT", "-TERM"] {
            let child = spawn(&command.split_whitespace().collect::<Vec<_>>());
            std::thread::sleep(Duration::from_millis(300));
            let reply = Instant::now();
            signal(&child, name);
            let output = child.wait_with_output().unwrap();
            let waited = reply.elapsed();
            assert!(waited < Duration::from_secs(1), "{command}: {name} took {waited:?}");
            assert_eq!(output.status.code(), Some(1), "{command}: {}", stderr(&output));
            assert!(stderr(&output).contains("interrupted"), "{command}: {}", stderr(&output));
        }
    }
    assert_eq!(names(place.path()), Some(vec!["s.csv.partial".to_owned()]), "what can be taken up again, and no more");
}

/// The section has to be covered for seconds here, and searched for a minute; no motion is followed in the first of these.
#[test]
fn a_terminal_shows_how_far_the_search_for_orbits_has_come_until_it_is_interrupted() {
    use rustix::pty::{OpenptFlags, grantpt, openpt, ptsname, unlockpt};

    let controller = openpt(OpenptFlags::RDWR | OpenptFlags::NOCTTY).unwrap();
    grantpt(&controller).unwrap();
    unlockpt(&controller).unwrap();
    let name = ptsname(&controller, Vec::new()).unwrap();
    let terminal = File::options().read(true).write(true).open(name.to_str().unwrap()).unwrap();
    let command = "periodic --body paper --h 4.645785 --l 3.25";
    let mut child =
        Command::new(PROGRAM).args(command.split_whitespace()).stdout(Stdio::null()).stderr(terminal).spawn().unwrap();
    let (mut controller, mut shown) = (File::from(controller), Vec::new());
    let is_shown = |shown: &[u8]| {
        let text = String::from_utf8_lossy(shown);
        text.contains(" with the rim checked") || text.contains("% of the area decided")
    };
    // When the program ends, and with it the last writer, reading fails.
    let mut room = [0; 4096];
    while !is_shown(&shown) {
        let count = controller.read(&mut room).unwrap();
        shown.extend_from_slice(&room[..count]);
    }
    let reply = Instant::now();
    signal(&child, "-INT");
    let status = child.wait().unwrap();
    assert_eq!(status.code(), Some(1));
    assert!(reply.elapsed() < Duration::from_secs(1), "{:?}", reply.elapsed());
}

/// It used to halve intervals without end.
#[test]
fn a_section_of_a_very_heavy_body_comes_to_its_end() {
    bifdiag("section --A 0.3,0.21,0.17 --r 0,1e60,1e60 --h 0 --l 0 --orbits 2 --crossings 10 --no-plot --json")
        .succeeds();
}

#[test]
fn a_second_interrupt_ends_what_the_first_has_reported_to_stop() {
    let child = spawn(&["section", "--body", "paper", "--h", "4.45", "--l", "3.25", "--crossings", "100000000"]);
    std::thread::sleep(Duration::from_millis(300));
    signal(&child, "-INT");
    let _may_be_over = Command::new("kill").args(["-INT", &child.id().to_string()]).stderr(Stdio::null()).status();
    assert_eq!(child.wait_with_output().unwrap().status.code(), Some(1));
}

#[test]
fn several_command_lines_run_in_one_process() {
    let run = |line: &str| bifdiag::cli::run(line.split_whitespace().map(Into::into));
    for threads in ["", "--threads 1", "--threads 3", "-vv --timings"] {
        assert_eq!(run(&format!("bifdiag classify --batch /dev/null {threads}")), 0);
        assert_eq!(run(&format!("bifdiag classify --h 1 --l 1 {threads} -q")), 2);
    }
}

/// An interrupted run leaves the files of an earlier one as they are, keeps what it has found beside them, and the same
/// command ends with the bytes of a run that was not stopped.
#[test]
fn an_interrupted_section_replaces_no_file_and_the_same_command_goes_on() {
    let place = tempfile::tempdir().unwrap();
    let path = |name: &str| place.path().join(name).to_string_lossy().into_owned();
    let long = "section --body paper --h 4.45 --l 3.25 --orbits 12 --crossings 6000 --threads 1 --json";
    for (verdict, ending) in [("whole", "csv"), ("none", "npz")] {
        let (data, out) = (format!("data/{verdict}.{ending}"), verdict);
        let line = |data: &str, out: &str| {
            format!("{long} --verdict {verdict} --data {} --out {} --format svg", path(data), path(out))
        };
        let run = |line: &str| spawn(&line.split_whitespace().collect::<Vec<_>>());
        let whole = run(&line(&format!("data/whole-{verdict}.{ending}"), "uncut")).wait_with_output().unwrap();
        assert!(whole.status.success(), "{}", stderr(&whole));
        fs::create_dir_all(path(out)).unwrap();
        fs::write(path(&data), "earlier").unwrap();
        fs::write(path(&format!("{out}/section.json")), "earlier").unwrap();
        let mut stops = 0;
        let output = loop {
            let child = run(&line(&data, out));
            std::thread::sleep(Duration::from_millis(120 + 60 * stops));
            let _over = Command::new("kill").args(["-INT", &child.id().to_string()]).stderr(Stdio::null()).status();
            let output = child.wait_with_output().unwrap();
            if output.status.success() {
                break output;
            }
            stops += 1;
            assert!(stops < 100, "it never ends");
            assert_eq!(output.status.code(), Some(1), "{}", stderr(&output));
            assert!(stderr(&output).contains("interrupted"), "{}", stderr(&output));
            if !output.stdout.is_empty() {
                let document: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
                let message = stderr(&output);
                let after_the_work = message.contains("the files already written are complete");
                assert!(after_the_work || document["complete"] == false || message.contains("12 of 12"), "{message}");
                assert!(after_the_work || message.contains("run the same command again"), "{message}");
            }
            // The files have their names at the very end.
            let replaced = fs::read(path(&format!("{out}/section.json"))).unwrap() != b"earlier";
            assert!(replaced || fs::read(path(&data)).unwrap() == b"earlier");
            assert!(!replaced || fs::read(path(&data)).unwrap().len() > 1000);
        };
        println!("stopped {stops} times");
        assert!(output.stdout == whole.stdout);
        for name in ["section.json", "section.svg"] {
            let of = |out: &str| fs::read(path(&format!("{out}/{name}"))).unwrap();
            assert!(of(out) == of("uncut"), "{name}");
        }
        assert!(fs::read(path(&data)).unwrap() == fs::read(path(&format!("data/whole-{verdict}.{ending}"))).unwrap());
    }
    assert_eq!(
        names(&place.path().join("data")).unwrap(),
        ["none.npz", "whole-none.npz", "whole-whole.csv", "whole.csv"]
    );
}

/// What an interrupted run has found was formatted outside of the cut-off: 22 s after 5 s of work, and was written over
/// the file of an earlier run.
#[test]
fn an_interrupted_section_with_much_data_ends_within_a_second() {
    let place = tempfile::tempdir().unwrap();
    let path = |name: &str| place.path().join(name).to_string_lossy().into_owned();
    fs::write(path("s.csv"), "earlier").unwrap();
    let long = "section --body paper --h 4.45 --l 3.25 --crossings 1000000 --orbits 50 --verdict none";
    let lines = [
        format!("{long} --data {} --out {}", path("s.csv"), path("out")),
        format!("{long} --no-plot --out {}", path("out")),
        format!("{long} --data - --no-plot"),
    ];
    for line in lines {
        let child = spawn(&line.split_whitespace().collect::<Vec<_>>());
        std::thread::sleep(Duration::from_secs(3));
        let reply = Instant::now();
        signal(&child, "-INT");
        let output = child.wait_with_output().unwrap();
        let waited = reply.elapsed();
        assert!(waited < Duration::from_millis(1500), "{line} took {waited:?}");
        assert_eq!(output.status.code(), Some(1), "{line}: {}", stderr(&output));
        assert!(stderr(&output).contains("interrupted"), "{line}: {}", stderr(&output));
    }
    assert_eq!(fs::read(path("s.csv")).unwrap(), b"earlier");
    assert_eq!(names(place.path()).unwrap(), ["out", "s.csv", "s.csv.partial"]);
    assert_eq!(names(&place.path().join("out")).unwrap(), ["section.npz.partial"]);
}

/// In a directory, the journal of another section is discarded, as its files are replaced.
#[test]
fn the_journal_of_another_section_in_a_directory_is_discarded() {
    let place = tempfile::tempdir().unwrap();
    fs::write(place.path().join("section.npz.partial"), "bifdiag of old section A=1\nmore").unwrap();
    let run =
        bifdiag("section --body paper --h 4.45 --l 3.25 --orbits 2 --crossings 10 --no-plot --out").and(place.path());
    run.succeeds().telling("belonged to another unfinished section");
    assert_eq!(names(place.path()).unwrap(), ["section.json", "section.npz"]);
}

#[test]
fn an_interrupted_orbit_replaces_no_file() {
    let place = tempfile::tempdir().unwrap();
    let data = place.path().join("motion.csv");
    fs::write(&data, "earlier").unwrap();
    let line = "orbit --body paper --gamma 0.6,0,0.8 --omega 1,0.3,1 --times 0:1e9:1000000 --data";
    let words: Vec<String> = line.split(' ').map(str::to_owned).chain([data.to_string_lossy().into_owned()]).collect();
    let child = spawn(&words.iter().map(String::as_str).collect::<Vec<_>>());
    std::thread::sleep(Duration::from_millis(500));
    signal(&child, "-INT");
    let output = child.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(1));
    assert!(stderr(&output).contains("no file was written"), "{}", stderr(&output));
    assert_eq!(fs::read(&data).unwrap(), b"earlier");
    assert_eq!(names(place.path()).unwrap(), ["motion.csv"]);
}

/// It looked like an empty input, and the exit status was 0.
#[test]
#[cfg(target_os = "linux")]
fn a_closed_stdin_is_reported() {
    let point = "--body paper --h 4.45 --l 3.25";
    let starts = format!("section {point} --starts - --json");
    let times = "orbit --body paper --gamma 0.6,0,0.8 --omega 1,0.3,1 --times - --json";
    let lines = ["critical --batch -", "classify --batch -", "verify -", "section --atlas - --json", &starts, times];
    for line in lines {
        let closed = format!("exec '{PROGRAM}' {line} <&-");
        let output = Command::new("sh").args(["-c", &closed]).output().unwrap();
        assert_eq!(output.status.code(), Some(2), "{line}: {}", stderr(&output));
        assert!(stderr(&output).contains("standard input is closed"), "{line}: {}", stderr(&output));
    }
    for line in ["critical --batch -", "bodies"] {
        let empty = format!("exec '{PROGRAM}' {line} </dev/null");
        assert!(Command::new("sh").args(["-c", &empty]).status().unwrap().success(), "{line}");
    }
}

/// The files of a set get their names while the directory is locked, so that those of two runs cannot mix.
#[test]
#[cfg(target_os = "linux")]
fn files_of_two_runs_in_one_directory_do_not_mix() {
    let place = tempfile::tempdir().unwrap();
    let other = File::open(place.path()).unwrap();
    other.lock().unwrap();
    let mut child = spawn(&["--body", "paper", "--out", &place.path().to_string_lossy()]);
    std::thread::sleep(Duration::from_secs(2));
    let early = names(place.path()).unwrap();
    assert!(child.try_wait().unwrap().is_none() && early.iter().all(|name| name.starts_with('.')), "{early:?}");
    other.unlock().unwrap();
    assert!(child.wait_with_output().unwrap().status.success());
    let files = ["atlas.json", "diagram.caption.tex", "diagram.caption.txt", "diagram.svg"];
    assert_eq!(names(place.path()).unwrap(), files);
}

/// An interrupt while the rows are written into their file left `FILE.partial.new` behind.
#[test]
fn an_interrupted_merge_leaves_nothing_half_written() {
    let place = tempfile::tempdir().unwrap();
    bifdiag("scan --family general --samples 20000 --out a.csv").inside(place.path()).succeeds();
    let mut caught = false;
    for wait in 0..40 {
        let merge = |out: &str| format!("scan merge a.csv --out {out}");
        let mut command = Command::new(PROGRAM);
        command.args(merge("b.jsonl").split(' ')).current_dir(place.path()).stdout(Stdio::null()).stderr(Stdio::null());
        let mut child = command.spawn().unwrap();
        while !place.path().join("b.jsonl.partial.new").exists() && child.try_wait().unwrap().is_none() {
            std::thread::sleep(Duration::from_millis(1));
        }
        std::thread::sleep(Duration::from_millis(wait));
        let _over = Command::new("kill").args(["-INT", &child.id().to_string()]).stderr(Stdio::null()).status();
        caught |= !child.wait().unwrap().success();
        let left = names(place.path()).unwrap();
        assert!(left.iter().all(|name| !name.contains(".new")), "{left:?}");
        if caught {
            return;
        }
    }
    panic!("it is too fast to be caught");
}

/// Names in a directory, sorted; `None` if it is not there.
fn names(directory: &Path) -> Option<Vec<String>> {
    let entries = fs::read_dir(directory).ok()?;
    let mut names: Vec<String> =
        entries.map(|entry| entry.unwrap().file_name().to_string_lossy().into_owned()).collect();
    names.sort();
    Some(names)
}

#[test]
fn an_interrupted_run_leaves_all_files_or_none() {
    let place = tempfile::tempdir().unwrap();
    for i in 0..24 {
        let out = place.path().join(i.to_string());
        let path = out.to_string_lossy().into_owned();
        let child = spawn(&["--body", "paper", "--format", "svg,png", "--out", &path]);
        std::thread::sleep(Duration::from_micros(500 * i));
        // Fails if the run is over already, which is the last of the moments to be tried.
        let _over = Command::new("kill").args(["-TERM", &child.id().to_string()]).stderr(Stdio::null()).status();
        let finished = child.wait_with_output().unwrap().status.success();
        match names(&out) {
            None => assert!(!finished),
            Some(names) => {
                assert_eq!(names, ["atlas.json", "diagram.png", "diagram.svg"]);
                let atlas = fs::read(out.join("atlas.json")).unwrap();
                assert!(serde_json::from_slice::<serde_json::Value>(&atlas).is_ok());
                assert!(fs::read_to_string(out.join("diagram.svg")).unwrap().trim_end().ends_with("</svg>"));
            }
        }
    }
}

/// A streamed section that is interrupted, and killed, and interrupted, goes on to the bytes of one that was not.
#[cfg(unix)]
#[test]
fn a_streamed_section_goes_on_where_it_was_stopped() {
    let place = tempfile::tempdir().unwrap();
    let line = |name: &str| {
        let data = place.path().join(name).to_string_lossy().into_owned();
        let words = "section --body paper --h 4.45 --l 3.25 --orbits 3 --crossings 150000 --threads 1 --no-plot --data";
        words.split(' ').map(str::to_owned).chain([data]).collect::<Vec<String>>()
    };
    let words = |line: &[String]| -> Vec<String> { line.to_vec() };
    let run = |line: &[String]| spawn(&words(line).iter().map(String::as_str).collect::<Vec<_>>());
    assert!(run(&line("whole.npz")).wait_with_output().unwrap().status.success());
    let read = |name: &str| fs::read(place.path().join(name)).unwrap();
    let mut stops = 0;
    for attempt in 0.. {
        assert!(attempt < 200, "it never ends");
        let child = run(&line("cut.npz"));
        // Longer each time, so that it ends on a machine that is busy too.
        std::thread::sleep(Duration::from_millis(150 + 20 * attempt));
        signal(&child, if attempt % 2 == 0 { "-INT" } else { "-KILL" });
        let output = child.wait_with_output().unwrap();
        if output.status.success() {
            break;
        }
        stops += 1;
        if place.path().join("cut.npz").exists() {
            // The signal came when the file had its name; the next run finds the journal whole.
            assert!(read("whole.npz") == read("cut.npz"));
        } else if attempt % 2 == 0 && output.status.code() == Some(1) {
            assert!(stderr(&output).contains("run the same command again"), "{}", stderr(&output));
        }
    }
    println!("stopped {stops} times");
    assert!(read("whole.npz") == read("cut.npz"));
    assert_eq!(names(place.path()).unwrap(), ["cut.npz", "whole.npz"]);
}
