//! Lines of a batch that are wrong: each with its message in place.

use crate::builder::bifdiag;

/// A line, and parts of its message.
const WRONG: &[(&[u8], &[&str])] = &[
    (b"", &["the line is empty", "\"A\": [A1, A2, A3]"]),
    (b"   \t", &["the line is empty"]),
    (b"not json", &["not a JSON object"]),
    (b"[[2,1,1],[1,0,0],1,1]", &["not a JSON object"]),
    (b"42", &["not a JSON object"]),
    (b"{", &["not valid JSON", "column"]),
    (b"{\"A\":[2,1,1],\"r\":[1,0,0],\"h\":1,\"l\":1", &["not valid JSON: EOF"]),
    (b"{\"A\":[2,1,1],\"r\":[1,0,0],\"h\":1,\"l\":1} x", &["not valid JSON: trailing characters"]),
    (b"{\"A\":[2,1,1],\"r\":[1,0,0],\"h\":1,\"l\":1,}", &["not valid JSON"]),
    (b"   {\"\xc3\xa9\":1, x}", &["not valid JSON", "(column 12)"]),
    (b"{\"A\":[2,1,1],\"A\":[2,1,1],\"r\":[1,0,0],\"h\":1,\"l\":1}", &["duplicate field `A`"]),
    (b"{\"A\":[2,1,1],\"r\":[1,0,0],\"h\":1,\"l\":1\xff}", &["not UTF-8 from byte 37"]),
    (b"{\"r\":[1,0,0],\"h\":1,\"l\":1}", &["A is missing", "\"A\": [2, 1.1, 1]"]),
    (b"{\"A\":[2,1,1],\"h\":1,\"l\":1}", &["r is missing", "\"r\": [0.94868, 0, 0.61623]"]),
    (b"{\"A\":[2,1,1],\"r\":[1,0,0],\"l\":1}", &["h is missing", "\"h\": 3.8"]),
    (b"{\"A\":[2,1,1],\"r\":[1,0,0],\"h\":1}", &["l is missing", "\"l\": 3.25"]),
    (b"{\"a\":[2,1,1],\"r\":[1,0,0],\"h\":1,\"l\":1}", &["A is missing"]),
    (b"{\"A\":null,\"r\":[1,0,0],\"h\":1,\"l\":1}", &["A is missing"]),
    (b"{\"A\":\"2,1,1\",\"r\":[1,0,0],\"h\":1,\"l\":1}", &["A: \"2,1,1\" is not a list of three numbers"]),
    (b"{\"A\":{\"x\":2},\"r\":[1,0,0],\"h\":1,\"l\":1}", &["A: {\"x\":2} is not a list"]),
    (b"{\"A\":[2,1],\"r\":[1,0,0],\"h\":1,\"l\":1}", &["three moments of inertia, 2 given"]),
    (b"{\"A\":[2,1,1,1],\"r\":[1,0,0],\"h\":1,\"l\":1}", &["4 given"]),
    (b"{\"A\":[2,1,0],\"r\":[1,0,0],\"h\":1,\"l\":1}", &["A3 = 0 is not positive"]),
    (b"{\"A\":[2,\"-1\",1],\"r\":[1,0,0],\"h\":1,\"l\":1}", &["A2 = -1 is not positive"]),
    (b"{\"A\":[2,null,1],\"r\":[1,0,0],\"h\":1,\"l\":1}", &["A2: null is not a number"]),
    (b"{\"A\":[2,[1],1],\"r\":[1,0,0],\"h\":1,\"l\":1}", &["A2: [1] is not a number"]),
    (b"{\"A\":[2,1,1],\"r\":[1,0],\"h\":1,\"l\":1}", &["r needs three coordinates, 2 given"]),
    (b"{\"A\":[2,1,1],\"r\":[1,0,true],\"h\":1,\"l\":1}", &["r3: true is not a number"]),
    (b"{\"A\":[2,1,1],\"r\":[1,0,\"x\"],\"h\":1,\"l\":1}", &["r3: `x` is not a number"]),
    (b"{\"A\":[2,1,1],\"r\":[1,0,0],\"h\":NaN,\"l\":1}", &["not valid JSON"]),
    (b"{\"A\":[2,1,1],\"r\":[1,0,0],\"h\":\"nan\",\"l\":1}", &["h: `nan` is not finite"]),
    (b"{\"A\":[2,1,1],\"r\":[1,0,0],\"h\":1,\"l\":\"1/0\"}", &["l: `1/0` has denominator zero"]),
    (b"{\"A\":[2,1,1],\"r\":[1,0,0],\"h\":1,\"l\":1e999}", &["l: `1e999` is out of range", "1e150"]),
    (b"{\"A\":[2,1,1],\"r\":[1,0,0],\"h\":[1],\"l\":1}", &["h: [1] is not a number", "\"11/10\""]),
    (b"{\"A\":[2,1,1],\"r\":[1,0,0],\"h\":\"\",\"l\":1}", &["h: the number is missing"]),
];

const GOOD: &[u8] = b"{\"A\":[2,1.1,1],\"r\":[1,0,0],\"h\":1,\"l\":1}";

#[test]
fn each_gives_its_error_in_its_place() {
    let mut batch = Vec::new();
    for (line, _) in WRONG {
        batch.extend_from_slice(line);
        batch.push(b'\n');
        batch.extend_from_slice(GOOD);
        batch.push(b'\n');
    }
    let done = bifdiag("classify --batch -").reading(batch.clone()).succeeds();
    let answers = done.json_lines();
    assert_eq!(answers.len(), 2 * WRONG.len());
    for (i, (line, messages)) in WRONG.iter().enumerate() {
        let (answer, good) = (&answers[2 * i], &answers[2 * i + 1]);
        assert_eq!(answer["line"], 2 * i + 1);
        assert_eq!(answer.as_object().unwrap().len(), 2);
        for message in *messages {
            let error = answer["error"].as_str().unwrap();
            assert!(error.contains(message), "{}\nwanted: {message}\ngot: {error}", String::from_utf8_lossy(line));
        }
        assert_eq!((&good["l"], good.get("error")), (&"1".into(), None));
    }
    let message = format!("{} of {} lines of the batch are invalid", WRONG.len(), 2 * WRONG.len());
    done.telling(&message);
    let done = bifdiag("classify --batch - --strict").reading(batch).refused().telling(&message);
    assert_eq!(done.json_lines(), answers, "--strict changes the exit status, not the answers");
}

#[test]
fn endless_lines_are_refused_without_being_kept() {
    let done = bifdiag("classify --batch -").reading([vec![b' '; 5 << 20], b"\n".to_vec(), GOOD.to_vec()].concat());
    let answers = done.succeeds().json_lines();
    assert!(answers[0]["error"].as_str().unwrap().contains("longer than 1048576 bytes"));
    assert_eq!(answers[1]["h"], "1");
}

#[test]
fn critical_asks_for_no_energy() {
    let done = bifdiag("critical --batch -").reading(*b"{\"A\":[2,1,1],\"r\":[1,0,0],\"l\":1}\n{\"l\":1}\n").succeeds();
    let answers = done.json_lines();
    assert!(answers[0]["critical"].is_array());
    assert!(answers[1]["error"].as_str().unwrap().starts_with("A is missing"));
}
