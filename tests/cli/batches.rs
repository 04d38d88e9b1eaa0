//! Batches that are right: order, echo, and the same bytes however they arrive.

use std::fmt::Write as _;
use std::io::{BufRead, BufReader, Write as _};
use std::process::{Command, Stdio};

use serde_json::json;

use crate::builder::{PROGRAM, bifdiag};

/// Runs of equal bodies of several lengths.
fn points() -> String {
    let mut lines = String::new();
    for i in 0..300 {
        let a = 1.25 + f64::from(i / 7 % 5) / 8.0;
        writeln!(lines, r#"{{"A":[{a},1.1,"1"],"r":[0.9,0,"3/5"],"h":{},"l":{i}}}"#, f64::from(i) / 10.0).unwrap();
    }
    lines
}

#[test]
fn answers_stand_in_the_order_of_the_lines_and_echo_them() {
    let answers = bifdiag("classify --batch -").reading(points()).succeeds().telling_nothing().json_lines();
    assert_eq!(answers.len(), 300);
    for (i, answer) in answers.iter().enumerate() {
        assert_eq!(answer["l"], i.to_string());
        assert_eq!(answer["A"][2], "1");
        assert_eq!(answer["r"], json!(["0.9", "0", "3/5"]));
        assert_eq!(answer["schema_version"], "3");
    }
}

#[test]
fn equal_bodies_written_otherwise_are_echoed_as_they_were_written() {
    let texts = ["1.1", "11/10", "11e-1", "1.10", "2.2/2", "1.1", "11/10"];
    let line = |a: &&str| format!(r#"{{"A":[2,"{a}",1],"r":[1,0,0],"h":1,"l":1}}"#);
    let batch = texts.iter().map(line).collect::<Vec<_>>().join("\n");
    let answers = bifdiag("classify --batch -").reading(batch).succeeds().json_lines();
    let echoed: Vec<_> = answers.iter().map(|answer| answer["A"][1].as_str().unwrap()).collect();
    assert_eq!(echoed, texts);
}

#[test]
fn threads_do_not_change_a_byte() {
    let one = bifdiag("classify --batch - --threads 1").reading(points()).succeeds().stdout();
    let four = bifdiag("classify --batch - --threads 4").reading(points()).succeeds().stdout();
    assert_eq!(one, four);
    let one = bifdiag("critical --batch - --threads 1").reading(points()).succeeds().stdout();
    let four = bifdiag("critical --batch - --threads 4").reading(points()).succeeds().stdout();
    assert_eq!(one, four);
}

#[test]
fn a_line_is_answered_before_the_next_is_written_with_the_same_bytes() {
    let at_once = bifdiag("classify --batch -").reading(points()).succeeds().stdout();
    let mut child = Command::new(PROGRAM)
        .args(["classify", "--batch", "-"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    let mut stdin = child.stdin.take().unwrap();
    let mut stdout = BufReader::new(child.stdout.take().unwrap());
    let mut answers = String::new();
    for line in points().lines() {
        writeln!(stdin, "{line}").unwrap();
        stdout.read_line(&mut answers).unwrap();
    }
    drop(stdin);
    assert!(child.wait().unwrap().success());
    assert_eq!(answers, at_once);
}

#[test]
fn lines_without_a_body_mean_that_of_the_command_line() {
    let batch = "{\"h\":1,\"l\":2}\n{\"A\":[3,2,1],\"r\":[0,0,1],\"h\":1,\"l\":2}\n{\"h\":3,\"l\":\"1/3\"}";
    let answers = bifdiag("classify --body paper --batch -").reading(batch).succeeds().json_lines();
    assert_eq!(answers[0]["A"], json!(["2", "1.1", "1"]));
    assert_eq!(answers[1]["A"], json!(["3", "2", "1"]));
    assert_eq!((&answers[2]["A"], &answers[2]["l"]), (&answers[0]["A"], &json!("1/3")));
}

#[test]
fn the_case_files_are_batches() {
    let answers = bifdiag("classify --batch data/cases/classify.jsonl").succeeds().json_lines();
    assert_eq!(answers.len(), 80);
    assert!(answers.iter().all(|answer| answer.get("error").is_none()));
    let answers = bifdiag("critical --batch data/cases/extremes.jsonl").succeeds().json_lines();
    assert_eq!(answers.len(), 28);
    assert!(answers.iter().all(|answer| answer.get("error").is_none()));
}

#[test]
fn an_empty_batch_has_no_answers() {
    bifdiag("classify --batch - --strict").reading("").succeeds().printing_nothing().telling_nothing();
}

#[test]
fn unphysical_bodies_are_counted_unless_quiet() {
    let batch = "{\"A\":[9,1,1],\"r\":[1,0,0],\"l\":1}\n{\"A\":[2,1.5,1],\"r\":[1,0,0],\"l\":1}\n";
    bifdiag("critical --batch -").reading(batch).succeeds().telling("warning: the body of 1 of 2 lines cannot exist");
    bifdiag("critical -q --batch -").reading(batch).succeeds().telling_nothing();
}

/// The first points of a body are answered cold, the others by the prepared body: the classes are the same.
#[test]
fn the_first_and_the_later_points_of_a_body_have_the_same_answers() {
    let point = r#"{"A":[2,1.1,1],"r":[0.94868,0,0.61623],"h":4.675,"l":3.25}"#;
    let answers = bifdiag("classify --batch -").reading(format!("{point}\n").repeat(12)).succeeds().json_lines();
    for answer in &answers {
        assert_eq!(answer["status"], "regular");
        assert_eq!((&answer["components"], &answer["signature"]), (&answers[0]["components"], &json!("M3")));
        assert_eq!(answer["margin"]["nearest"], answers[0]["margin"]["nearest"]);
    }
}

/// A right question without an answer is no wrong line: it counts apart, and the exit status is 1.
#[test]
fn right_questions_without_an_answer_count_apart() {
    let lines = "{\"A\":[1e-30,1,1],\"r\":[1,1,1],\"h\":1,\"l\":1}\n{\"A\":[2,1,0]}\n";
    let message = "1 of 2 lines of the batch is without an answer";
    let done = bifdiag("classify --batch -")
        .reading(lines)
        .fails()
        .telling(message)
        .telling("1 of 2 lines of the batch is invalid");
    assert_eq!(done.json_lines().len(), 2);
    bifdiag("classify --batch - --strict").reading(lines).refused().telling("1 of 2 lines of the batch is invalid");
}

/// A key that means nothing here is no secret; a spin would be another question.
#[test]
fn ignored_keys_are_listed_and_a_spin_is_refused() {
    let line = r#"{"A":[2,1.1,1],"r":[1,0,0],"h":1,"l":1,"name":"x"}"#;
    let reply = "were ignored (number of lines): h (2), name (2)";
    bifdiag("critical --batch -").reading(format!("{line}\n{line}\n")).succeeds().telling(reply);
    bifdiag("classify --batch -").reading(line).succeeds().telling("(number of lines): name (1)");
    bifdiag("classify -q --batch -").reading(line).succeeds().telling_nothing();
    let spin = r#"{"A":[2,1.1,1],"r":[1,0,0],"l":1,"spin":"3 rpm"}"#;
    let answers = bifdiag("critical --batch -").reading(spin).succeeds().json_lines();
    assert!(answers[0]["error"].as_str().unwrap().starts_with("spin: a line asks about one l"), "{answers:?}");
    let refused = bifdiag("critical --batch - --spin").and("3 rpm").refused();
    refused.telling("--spin cannot be used with --batch: a line asks about one l, not a spin");
}
