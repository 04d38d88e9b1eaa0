//! The examples for clusters give the bytes of the scan in one piece. Without the tools they are skipped, and say so.
#![cfg(feature = "cli")]

use std::path::Path;
use std::process::{Command, Stdio};

const PROGRAM: &str = env!("CARGO_BIN_EXE_bifdiag");
const SCAN: [&str; 4] = ["--family", "general", "--samples", "300"];

fn example(name: &str) -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/cluster").join(name)
}

/// True when the command runs; otherwise tells that the test is skipped.
fn is_there(program: &str, arguments: &[&str], wanted: &str) -> bool {
    let output = Command::new(program).args(arguments).stderr(Stdio::null()).output();
    let there =
        output.is_ok_and(|output| output.status.success() && String::from_utf8_lossy(&output.stdout).contains(wanted));
    if !there {
        eprintln!("skipped: `{program} {}` does not answer with `{wanted}`", arguments.join(" "));
    }
    there
}

/// Python with Dask: of the environment variable `PYTHON`, or python3.
fn python() -> String {
    std::env::var("PYTHON").unwrap_or_else(|_not_set| "python3".to_owned())
}

fn assert_as_in_one_piece(place: &Path, merged: &str) {
    let done =
        Command::new(PROGRAM).arg("scan").args(SCAN).args(["--out", "whole.csv"]).current_dir(place).output().unwrap();
    assert!(done.status.success());
    for ending in ["", ".summary.json"] {
        let read = |name: &str| std::fs::read(place.join(format!("{name}{ending}"))).unwrap();
        assert!(read("whole.csv") == read(merged), "{merged}{ending}");
    }
    let left = std::fs::read_dir(place).unwrap().count();
    assert_eq!(left, 4, "shards are left behind");
}

#[test]
fn dask_runs_the_shards_of_a_scan() {
    if !is_there(&python(), &["-c", "import distributed; print('distributed')"], "distributed") {
        return;
    }
    let place = tempfile::tempdir().unwrap();
    let output = Command::new(python())
        .arg(example("scan_dask.py"))
        .args(["--bifdiag", PROGRAM, "--workers", "2", "--shards", "5", "--out", "merged.csv", "--"])
        .args(SCAN)
        .current_dir(place.path())
        .output()
        .unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    assert_as_in_one_piece(place.path(), "merged.csv");
}

#[test]
#[cfg(unix)]
fn gnu_parallel_runs_the_shards_of_a_scan() {
    if !is_there("parallel", &["--version"], "GNU parallel") {
        return;
    }
    let place = tempfile::tempdir().unwrap();
    let output = Command::new(example("scan_parallel.sh"))
        .args(["5", "merged.csv"])
        .args(SCAN)
        .env("BIFDIAG", PROGRAM)
        .current_dir(place.path())
        .output()
        .unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    assert_as_in_one_piece(place.path(), "merged.csv");
}
