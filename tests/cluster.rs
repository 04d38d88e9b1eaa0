//! The examples for clusters give the bytes of the scan in one piece. They need GNU parallel and Python with Dask, which
//! `.ci/run` installs: there `cargo test --release --test cluster -- --ignored` runs them, and fails without these tools.
#![cfg(feature = "cli")]

use std::path::Path;
use std::process::Command;

const PROGRAM: &str = env!("CARGO_BIN_EXE_bifdiag");
const SCAN: [&str; 4] = ["--family", "general", "--samples", "300"];

fn example(name: &str) -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/cluster").join(name)
}

/// The command succeeds in `place` and leaves `merged`, with the bytes of the scan in one piece and nothing besides.
fn gives_the_scan_in_one_piece(command: &mut Command, place: &Path, merged: &str) {
    let output = command.current_dir(place).output().unwrap_or_else(|error| panic!("{command:?}: {error}"));
    assert!(output.status.success(), "{command:?}: {}", String::from_utf8_lossy(&output.stderr));
    let done = Command::new(PROGRAM).arg("scan").args(SCAN).args(["--out", "whole.csv"]).current_dir(place).output();
    assert!(done.unwrap().status.success());
    for ending in ["", ".summary.json"] {
        let read = |name: &str| std::fs::read(place.join(format!("{name}{ending}"))).unwrap();
        assert!(read("whole.csv") == read(merged), "{merged}{ending}");
    }
    let left = std::fs::read_dir(place).unwrap().count();
    assert_eq!(left, 4, "shards are left behind");
}

/// Python with Dask is the environment variable `PYTHON`, or python3.
#[test]
#[ignore = "needs Dask; .ci/run installs it"]
fn dask_runs_the_shards_of_a_scan() {
    let python = std::env::var("PYTHON").unwrap_or_else(|_not_set| "python3".to_owned());
    let place = tempfile::tempdir().unwrap();
    let mut command = Command::new(python);
    command
        .arg(example("scan_dask.py"))
        .args(["--bifdiag", PROGRAM, "--workers", "2", "--shards", "5", "--out", "merged.csv", "--"])
        .args(SCAN);
    gives_the_scan_in_one_piece(&mut command, place.path(), "merged.csv");
}

#[test]
#[cfg(unix)]
#[ignore = "needs GNU parallel; .ci/run installs it"]
fn gnu_parallel_runs_the_shards_of_a_scan() {
    let place = tempfile::tempdir().unwrap();
    let mut command = Command::new(example("scan_parallel.sh"));
    command.args(["5", "merged.csv"]).args(SCAN).env("BIFDIAG", PROGRAM);
    gives_the_scan_in_one_piece(&mut command, place.path(), "merged.csv");
}
