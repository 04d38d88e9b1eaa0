//! `bifdiag explore`: a page is served to this machine, and nothing else.

use std::fs;
use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::path::Path;
use std::process::{Child, Command, Stdio};

use crate::builder::{PROGRAM, bifdiag};

/// The command under way, ended with the test.
struct Served {
    child: Child,
    url: String,
}

impl Served {
    fn of(page: &Path, arguments: &[&str]) -> Self {
        let mut child = Command::new(PROGRAM)
            .args(["explore", "--no-open", "--page"])
            .arg(page)
            .args(arguments)
            .stdout(Stdio::piped())
            .spawn()
            .unwrap();
        let mut url = String::new();
        BufReader::new(child.stdout.take().unwrap()).read_line(&mut url).unwrap();
        Self { child, url: url.trim_end().to_owned() }
    }

    /// The answer to a request, its head and its body.
    fn ask(&self, request: &str) -> (String, Vec<u8>) {
        let host = self.url.strip_prefix("http://").and_then(|rest| rest.split('/').next()).unwrap();
        let mut stream = TcpStream::connect(host).unwrap();
        write!(stream, "{request} HTTP/1.1\r\nHost: {host}\r\n\r\n").unwrap();
        let mut answer = Vec::new();
        stream.read_to_end(&mut answer).unwrap();
        let end = answer.windows(4).position(|four| four == b"\r\n\r\n").unwrap();
        (String::from_utf8(answer[..end].to_vec()).unwrap(), answer[end + 4..].to_vec())
    }
}

impl Drop for Served {
    fn drop(&mut self) {
        self.child.kill().unwrap();
        self.child.wait().unwrap();
    }
}

#[test]
fn a_page_is_served_with_the_body_in_its_address() {
    let place = tempfile::tempdir().unwrap();
    let page = place.path().join("page");
    fs::create_dir_all(page.join("assets")).unwrap();
    fs::write(page.join("index.html"), "<title>here</title>").unwrap();
    let module = b"\0asm\x01\0\0\0";
    fs::write(page.join("assets/module.wasm"), module).unwrap();
    fs::write(place.path().join("secret"), "not for the page").unwrap();

    let served = Served::of(&page, &["--A=2,11/10,1", "--r=1,0,-1e-3", "--h=3.80", "--l=13/4"]);
    assert!(served.url.starts_with("http://127.0.0.1:"), "{}", served.url);
    assert!(served.url.ends_with("/#A=2,11/10,1&r=1,0,-1e-3&h=3.80&l=13/4"), "{}", served.url);
    let (head, body) = served.ask("GET /");
    assert!(head.starts_with("HTTP/1.1 200 OK\r\nContent-Type: text/html"), "{head}");
    assert_eq!(body, b"<title>here</title>");
    let (head, body) = served.ask("GET /assets/module.wasm?anew");
    assert!(head.contains("Content-Type: application/wasm\r\nContent-Length: 8\r\n"), "{head}");
    assert_eq!(body, module);
    assert_eq!(served.ask("HEAD /index.html").1, b"");
    for path in ["/../secret", "/assets/../../secret", "//etc/passwd", "/%2e%2e/secret", "/assets", "secret"] {
        let (head, body) = served.ask(&format!("GET {path}"));
        assert!(head.starts_with("HTTP/1.1 404"), "{path}: {head}");
        assert!(!body.ends_with(b"page"), "{path}");
    }
    assert!(served.ask("POST /").0.starts_with("HTTP/1.1 405"));
}

#[test]
fn without_a_page_the_way_to_one_is_told() {
    let place = tempfile::tempdir().unwrap();
    bifdiag("explore --no-open").inside(place.path()).refused().telling("npm run build");
    bifdiag("explore --no-open --page").and(place.path()).refused().telling("it holds no index.html");
    bifdiag("explore --no-open --page nowhere").inside(place.path()).refused().telling("--page nowhere");
    bifdiag("explore --no-open --h 1").inside(place.path()).refused().telling("--l");
}
