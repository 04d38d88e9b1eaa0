//! Every example of the documentation does what is printed below it.
//!
//! # Convention
//! The fenced blocks of a page are worked through in order, in one empty directory for each page.
//!
//! - ```` ```sh ```` : one command on each line (`\` continues a line). Commands that start with `bifdiag` or with
//!   `cargo run --release --` are run; they may end in `> FILE`. Those that start with a prefix of [`NOT_RUN`] are for
//!   people. Nothing else is allowed.
//! - ```` ```text ```` after it: what the commands of the last `sh` block print to stdout, exactly. With the word `stderr`
//!   behind `text`: what they print to stderr, which otherwise must stay empty. With `status:2`: the exit status of
//!   the last command, otherwise 0. A line `…` stands for any number of lines.
//! - ```` ```json file:NAME ```` (or any language): the block is written to the file NAME.
//! - ```` ```rust ```` : a doctest, run with those of the library (`src/lib.rs` includes the pages).
//!
//! With `UPDATE_DOCS=1` in the environment, blocks without `…` are rewritten with what the program prints now.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// The program.
const PROGRAM: &str = env!("CARGO_BIN_EXE_bifdiag");

/// Commands of the documentation that are not run here.
const NOT_RUN: [&str; 7] = [
    "cargo test",
    "cargo bench",
    "git clone",
    ".ci/run",
    "PROPTEST_CASES=",
    "UPDATE_DOCS=",
    "cargo install cargo-mutants",
];

/// Stands for any number of lines.
const ANYTHING: &str = "…";

/// A fenced block.
struct Block {
    info: String,
    body: String,
    /// Lines of the body in the page, from 0.
    lines: std::ops::Range<usize>,
}

impl Block {
    fn language(&self) -> &str {
        self.info.split_whitespace().next().unwrap_or_default()
    }

    fn has(&self, word: &str) -> bool {
        self.info.split_whitespace().any(|found| found == word)
    }

    fn value(&self, key: &str) -> Option<&str> {
        self.info.split_whitespace().find_map(|word| word.strip_prefix(key)?.strip_prefix(':'))
    }
}

/// What the commands of a block have printed.
#[derive(Default)]
struct Printed {
    stdout: String,
    stderr: String,
    status: i32,
}

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// All pages of the repository that are written for people.
fn pages() -> Vec<PathBuf> {
    let mut found = Vec::new();
    for folder in ["", "docs", "figures"] {
        let entries = fs::read_dir(root().join(folder)).unwrap_or_else(|error| panic!("{folder}: {error}"));
        let files = entries.map(|entry| entry.expect("the folder can be listed").path());
        found.extend(files.filter(|path| path.extension().is_some_and(|extension| extension == "md")));
    }
    found.sort();
    found
}

fn blocks(text: &str) -> Vec<Block> {
    let mut found = Vec::new();
    let mut open: Option<Block> = None;
    for (number, line) in text.lines().enumerate() {
        match (&mut open, line.strip_prefix("```")) {
            (None, Some(info)) => {
                let lines = number + 1..number + 1;
                open = Some(Block { info: info.to_owned(), body: String::new(), lines });
            }
            (Some(_), Some("")) => {
                let mut block = open.take().expect("a block is open");
                block.lines.end = number;
                found.push(block);
            }
            (Some(block), _) => {
                block.body.push_str(line);
                block.body.push('\n');
            }
            (None, None) => {}
        }
    }
    assert!(open.is_none(), "the last block is not closed");
    found
}

/// The words of a command; quotes keep blanks together.
fn words(line: &str) -> Vec<String> {
    let mut words = Vec::new();
    let (mut word, mut quote, mut started) = (String::new(), None, false);
    for c in line.chars() {
        match quote {
            Some(mark) if c == mark => quote = None,
            Some(_) => word.push(c),
            None if c == '\'' || c == '"' => (quote, started) = (Some(c), true),
            None if c.is_whitespace() => {
                if started {
                    words.push(std::mem::take(&mut word));
                }
                started = false;
            }
            None => {
                word.push(c);
                started = true;
            }
        }
    }
    assert!(quote.is_none(), "a quote is not closed: {line}");
    if started {
        words.push(word);
    }
    words
}

/// Runs one command; false if it is one that is not run.
fn run(command: &str, place: &Path, printed: &mut Printed) -> bool {
    let arguments = ["bifdiag", "cargo run --release --"]
        .iter()
        .find_map(|start| command.strip_prefix(start).filter(|rest| rest.is_empty() || rest.starts_with(' ')));
    let Some(arguments) = arguments else {
        assert!(NOT_RUN.iter().any(|start| command.starts_with(start)), "an unknown kind of command: {command}");
        return false;
    };
    let mut arguments = words(arguments);
    let file = (arguments.len() >= 2 && arguments[arguments.len() - 2] == ">").then(|| arguments.pop());
    if file.is_some() {
        arguments.pop();
    }
    let mut program = Command::new(PROGRAM);
    program.args(&arguments).current_dir(place);
    let output = assert_cmd::Command::from_std(program).output().expect("the program starts");
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).expect("the program prints UTF-8");
    let stdout = text(output.stdout);
    match file.flatten() {
        Some(name) => fs::write(place.join(name), stdout).expect("the file can be written"),
        None => printed.stdout.push_str(&stdout),
    }
    printed.stderr.push_str(&text(output.stderr));
    printed.status = output.status.code().expect("the program ends by itself");
    true
}

/// True when `found` is `wanted`, in which a line `…` stands for any number of lines.
fn agrees(wanted: &str, found: &str) -> bool {
    fn lines_agree(wanted: &[&str], found: &[&str]) -> bool {
        match wanted.split_first() {
            None => found.is_empty(),
            Some((first, rest)) if first.trim() == ANYTHING => {
                (0..=found.len()).any(|skipped| lines_agree(rest, &found[skipped..]))
            }
            Some((first, rest)) => found.first() == Some(first) && lines_agree(rest, &found[1..]),
        }
    }
    let wanted: Vec<&str> = wanted.lines().collect();
    let found: Vec<&str> = found.lines().collect();
    lines_agree(&wanted, &found)
}

/// Works through a page; the number of commands that were run.
fn work_through(path: &Path) -> usize {
    let name = path.strip_prefix(root()).unwrap_or(path).display().to_string();
    let text = fs::read_to_string(path).unwrap_or_else(|error| panic!("{name}: {error}"));
    let place = tempfile::tempdir().expect("a temporary directory can be made");
    let update = std::env::var_os("UPDATE_DOCS").is_some();
    let mut updated: Vec<String> = text.lines().map(str::to_owned).collect();
    let blocks = blocks(&text);
    let mut count = 0;
    // From the last line to the first, so that a longer block moves no line that is still to be rewritten.
    let mut rewrites = Vec::new();
    for (number, block) in blocks.iter().enumerate() {
        if let Some(file) = block.value("file") {
            fs::write(place.path().join(file), &block.body).expect("the file can be written");
        }
        if block.language() != "sh" {
            continue;
        }
        let mut printed = Printed::default();
        let commands = block.body.replace("\\\n", " ");
        let ran = commands.lines().filter(|line| run(line, place.path(), &mut printed)).count();
        count += ran;
        if ran == 0 {
            continue;
        }
        let said: Vec<&Block> = blocks[number + 1..].iter().take_while(|next| next.language() != "sh").collect();
        let answers: Vec<&&Block> = said.iter().filter(|block| block.language() == "text").collect();
        let status = answers.iter().find_map(|answer| answer.value("status")).unwrap_or("0");
        let at = format!("{name}, line {}", block.lines.start + 1);
        assert_eq!(printed.status.to_string(), status, "{at}: status\n{}", printed.stderr);
        for answer in &answers {
            let found = if answer.has("stderr") { &printed.stderr } else { &printed.stdout };
            if update && !answer.body.contains(ANYTHING) {
                rewrites.push((answer.lines.clone(), found.clone()));
            } else {
                assert!(agrees(&answer.body, found), "{at}: printed\n{found}\nbut the page says\n{}", answer.body);
            }
        }
        if !answers.iter().any(|answer| answer.has("stderr")) {
            assert_eq!(printed.stderr, "", "{at}: stderr");
        }
    }
    if !rewrites.is_empty() {
        for (lines, found) in rewrites.into_iter().rev() {
            updated.splice(lines, found.lines().map(str::to_owned));
        }
        fs::write(path, updated.join("\n") + "\n").expect("the page can be written");
    }
    count
}

#[test]
fn every_example_prints_what_the_page_says() {
    let commands: usize = pages().iter().map(|page| work_through(page)).sum();
    assert!(commands >= 30, "only {commands} commands were found");
}

/// Targets of `[text](target)` and `src="target"` that are files of the repository.
fn links(text: &str) -> Vec<String> {
    let outside_blocks: String = text.split("\n```").step_by(2).collect();
    let markdown = outside_blocks.split("](").skip(1).filter_map(|rest| rest.split([')', '#']).next());
    let html = outside_blocks.split("src=\"").skip(1).filter_map(|rest| rest.split('"').next());
    let local = |target: &&str| !target.is_empty() && !target.contains("://");
    markdown.chain(html).filter(local).map(str::to_owned).collect()
}

#[test]
fn links_lead_to_files() {
    let mut count = 0;
    for page in pages() {
        let text = fs::read_to_string(&page).expect("the page can be read");
        let folder = page.parent().expect("a page lies in a folder");
        for link in links(&text) {
            assert!(folder.join(&link).exists(), "{}: {link} does not exist", page.display());
            count += 1;
        }
    }
    assert!(count >= 10, "only {count} links were found");
}

#[test]
fn gaps_stand_for_any_lines_and_nothing_else_does() {
    assert!(agrees("a\nb\n", "a\nb\n"));
    assert!(agrees("a\n…\nd\n", "a\nb\nc\nd\n"));
    assert!(agrees("…\nd\n", "d\n"));
    assert!(!agrees("a\n…\nc\n", "a\nb\n"));
    assert!(!agrees("a\n", "a\nb\n"));
    assert_eq!(words("classify --A 2,1.1,1 '--r= 1' \"x y\""), ["classify", "--A", "2,1.1,1", "--r= 1", "x y"]);
}

/// The Python of docs/draw-it-yourself.md, where there is a Python with numpy and matplotlib.
#[test]
fn pictures_can_be_drawn_by_hand() {
    let has_both = Command::new("python3").args(["-c", "import numpy, matplotlib"]).output();
    if !has_both.is_ok_and(|output| output.status.success()) {
        return;
    }
    let text = fs::read_to_string(root().join("docs/draw-it-yourself.md")).expect("the page can be read");
    let place = tempfile::tempdir().expect("a temporary directory can be made");
    let blocks = blocks(&text);
    let of = |language: &str| {
        blocks.iter().filter(|block| block.language() == language).map(|block| block.body.as_str()).collect::<String>()
    };
    let mut printed = Printed::default();
    assert!(of("sh").lines().all(|line| run(line, place.path(), &mut printed)), "{}", printed.stderr);
    let output = Command::new("python3").args(["-c", &of("python")]).current_dir(place.path()).output();
    let output = output.expect("Python starts");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    for picture in ["diagram.png", "grid.png", "section.png"] {
        assert!(place.path().join(picture).exists(), "{picture} was not drawn");
    }
}
