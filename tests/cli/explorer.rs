//! `bifdiag explore`: a page is served to this machine, and nothing else.

use std::fs;
use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use crate::builder::{PROGRAM, bifdiag};

/// The command under way, ended with the test.
struct Served {
    child: Child,
    url: String,
}

impl Served {
    fn of(page: &Path, arguments: &[&str]) -> Self {
        let mut command = Command::new(PROGRAM);
        command.args(["explore", "--no-open", "--page"]).arg(page).args(arguments);
        Self::by(command)
    }

    /// A page of one file, served under limits that the shell sets.
    #[cfg(target_os = "linux")]
    fn limited(page: &Path, limits: &str) -> Self {
        fs::write(page.join("index.html"), "here").unwrap();
        let mut command = Command::new("sh");
        command.args(["-c", &format!("{limits}; exec '{PROGRAM}' explore --no-open --page \"$0\"")]).arg(page);
        Self::by(command)
    }

    fn by(mut command: Command) -> Self {
        let mut child = command.stdout(Stdio::piped()).spawn().unwrap();
        let mut url = String::new();
        BufReader::new(child.stdout.take().unwrap()).read_line(&mut url).unwrap();
        Self { child, url: url.trim_end().to_owned() }
    }

    /// Where it is served.
    fn host(&self) -> &str {
        self.url.strip_prefix("http://").and_then(|rest| rest.split('/').next()).unwrap()
    }

    fn connect(&self) -> TcpStream {
        let stream = TcpStream::connect(self.host()).unwrap();
        stream.set_read_timeout(Some(Duration::from_secs(40))).unwrap();
        stream
    }

    /// True if a request is refused. One that comes later than the server waits for is closed without an answer.
    fn refuses(&self) -> bool {
        let mut stream = self.connect();
        let request = format!("GET / HTTP/1.1\r\nHost: {}\r\n\r\n", self.host());
        let mut answer = String::new();
        let read = stream.write_all(request.as_bytes()).and_then(|()| stream.read_to_string(&mut answer));
        read.map_or(true, |_| answer.is_empty() || answer.starts_with("HTTP/1.1 503"))
    }

    /// The answer to a request, its head and its body.
    fn ask(&self, request: &str) -> (String, Vec<u8>) {
        self.ask_with(request, &format!("Host: {}\r\n", self.host()))
    }

    fn ask_with(&self, request: &str, fields: &str) -> (String, Vec<u8>) {
        let mut stream = self.connect();
        write!(stream, "{request} HTTP/1.1\r\n{fields}\r\n").unwrap();
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
    // The page is asked for anew each time; the files that it names have other names once they change.
    assert!(head.contains("Cache-Control: no-cache\r\n"), "{head}");
    let (head, body) = served.ask("GET /assets/module.wasm?anew");
    assert!(head.contains("Cache-Control: max-age=31536000, immutable\r\n"), "{head}");
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

/// Three quarters of the module are spared on the way.
#[test]
fn a_browser_that_takes_brotli_gets_the_packed_file_beside_another() {
    let place = tempfile::tempdir().unwrap();
    for (name, content) in [("index.html", "here"), ("module.wasm", "module"), ("module.wasm.br", "packed")] {
        fs::write(place.path().join(name), content).unwrap();
    }
    let served = Served::of(place.path(), &[]);
    let ask = |path: &str, field: &str| {
        let (head, body) = served.ask_with(&format!("GET {path}"), &format!("Host: localhost\r\n{field}"));
        assert!(head.starts_with("HTTP/1.1 200"), "{head}");
        (head.contains("Content-Encoding: br\r\n"), String::from_utf8(body).unwrap())
    };
    for field in ["Accept-Encoding: gzip, br\r\n", "accept-encoding:br;q=0.5\r\n"] {
        let (is_packed, body) = ask("/module.wasm", field);
        assert!(is_packed && body == "packed", "{field}: {body}");
        assert_eq!(ask("/", field), (false, "here".to_owned()));
    }
    for field in ["", "Accept-Encoding: gzip\r\n", "Accept-Encoding: br;q=0, gzip\r\n", "Accept-Encoding: brx\r\n"] {
        assert_eq!(ask("/module.wasm", field), (false, "module".to_owned()), "{field}");
    }
}

/// Wheels carry packed files in place of plain ones.
#[test]
fn where_only_the_packed_file_is_there_other_browsers_get_what_it_holds() {
    let place = tempfile::tempdir().unwrap();
    let packed = [27, 40, 0, 248, 37, 64, 138, 144, 102, 42, 129, 21, 76];
    fs::write(place.path().join("index.html"), "here").unwrap();
    fs::write(place.path().join("module.wasm.br"), packed).unwrap();
    fs::write(place.path().join("broken.js.br"), &packed[..packed.len() / 2]).unwrap();
    let served = Served::of(place.path(), &[]);
    let ask = |path: &str, field: &str| served.ask_with(&format!("GET {path}"), &format!("Host: localhost\r\n{field}"));
    let (head, body) = ask("/module.wasm", "Accept-Encoding: gzip, br\r\n");
    assert!(head.contains("Content-Encoding: br\r\n") && head.contains("Content-Type: application/wasm\r\n"), "{head}");
    assert_eq!(body, packed);
    let (head, body) = ask("/module.wasm", "Accept-Encoding: gzip\r\n");
    assert!(!head.contains("Content-Encoding") && head.contains("Content-Type: application/wasm\r\n"), "{head}");
    assert_eq!(String::from_utf8(body).unwrap(), "module ".repeat(6).trim_end());
    assert!(ask("/broken.js", "").0.starts_with("HTTP/1.1 503"));
}

#[test]
fn without_a_page_the_way_to_one_is_reported() {
    let place = tempfile::tempdir().unwrap();
    bifdiag("explore --no-open").inside(place.path()).refused().telling("npm run build");
    bifdiag("explore --no-open --page").and(place.path()).refused().telling("it holds no index.html");
    bifdiag("explore --no-open --page nowhere").inside(place.path()).refused().telling("--page nowhere");
    bifdiag("explore --no-open --h 1").inside(place.path()).refused().telling("--l");
}

/// A page of another site, whose name was made to lead to this machine, says that name.
#[test]
fn names_of_other_machines_are_refused() {
    let place = tempfile::tempdir().unwrap();
    fs::write(place.path().join("index.html"), "here").unwrap();
    let served = Served::of(place.path(), &[]);
    let port = served.host().rsplit(':').next().unwrap().to_owned();
    let status = |fields: &str| served.ask_with("GET /", fields).0[9..12].to_owned();
    for host in ["localhost", "127.0.0.1", "[::1]", "LOCALHOST"] {
        assert_eq!(status(&format!("Host: {host}:{port}\r\n")), "200", "{host}");
        assert_eq!(status(&format!("host:{host}\r\n")), "200", "{host}");
    }
    for host in
        ["evil.example", "localhost.evil.example", "127.0.0.1.evil.example", "127.0.0.1:x", "", "[::1", "localhost:"]
    {
        assert_eq!(status(&format!("Host: {host}\r\n")), "421", "{host}");
    }
    assert_eq!(status(""), "421");
    assert_eq!(status("Host: localhost\r\nHost: evil.example\r\n"), "421");
}

#[test]
#[cfg(unix)]
fn only_regular_files_of_the_folder_are_served() {
    use std::os::unix::fs::symlink;
    let place = tempfile::tempdir().unwrap();
    let page = place.path().join("page");
    fs::create_dir(&page).unwrap();
    fs::write(page.join("index.html"), "here").unwrap();
    fs::write(place.path().join("secret"), "not for the page").unwrap();
    symlink(place.path().join("secret"), page.join("link")).unwrap();
    symlink(place.path(), page.join("folder")).unwrap();
    symlink("index.html", page.join("own")).unwrap();
    assert!(Command::new("mkfifo").arg(page.join("pipe")).status().unwrap().success());
    let served = Served::of(&page, &[]);
    assert_eq!(served.ask("GET /own").1, b"here");
    for path in ["/link", "/folder", "/folder/secret", "/pipe"] {
        assert!(served.ask(&format!("GET {path}")).0.starts_with("HTTP/1.1 404"), "{path}");
    }
    // What is put in the place of a file later is looked at, too.
    fs::remove_file(page.join("own")).unwrap();
    symlink(place.path().join("secret"), page.join("own")).unwrap();
    assert!(served.ask("GET /own").0.starts_with("HTTP/1.1 404"));
}

/// Patience was with each byte: a request that never ends held its connection for ever.
#[test]
fn a_request_that_never_ends_is_cut_off() {
    let place = tempfile::tempdir().unwrap();
    fs::write(place.path().join("index.html"), "here").unwrap();
    let served = Served::of(place.path(), &[]);
    let mut stream = served.connect();
    stream.write_all(b"GET / HTTP/1.1\r\nHost: localhost\r\nX: ").unwrap();
    let began = Instant::now();
    while stream.write_all(b"x").is_ok() {
        assert!(began.elapsed() < Duration::from_secs(30), "it is still open");
        std::thread::sleep(Duration::from_millis(250));
    }
}

#[test]
fn connections_beyond_the_most_are_refused_and_others_are_served_again() {
    let place = tempfile::tempdir().unwrap();
    fs::write(place.path().join("index.html"), "here").unwrap();
    let served = Served::of(place.path(), &[]);
    let idle: Vec<TcpStream> = (0..64).map(|_| served.connect()).collect();
    std::thread::sleep(Duration::from_millis(500));
    assert!(served.refuses());
    drop(idle);
    std::thread::sleep(Duration::from_millis(500));
    assert_eq!(served.ask("GET /").1, b"here");
}

/// Out of descriptors, it asked for the next connection without a pause, and took a whole core.
#[test]
#[cfg(target_os = "linux")]
fn without_descriptors_the_server_waits() {
    let place = tempfile::tempdir().unwrap();
    let served = Served::limited(place.path(), "ulimit -n 24");
    let idle: Vec<TcpStream> = (0..40).map(|_| served.connect()).collect();
    let ticks = || -> u64 {
        let stat = fs::read_to_string(format!("/proc/{}/stat", served.child.id())).unwrap();
        stat.rsplit(')').next().unwrap().split_whitespace().skip(11).take(2).map(|t| t.parse::<u64>().unwrap()).sum()
    };
    let before = ticks();
    std::thread::sleep(Duration::from_secs(2));
    // In hundredths of a second.
    assert!(ticks() - before < 10, "{} ticks", ticks() - before);
    drop(idle);
    std::thread::sleep(Duration::from_millis(500));
    assert_eq!(served.ask("GET /").1, b"here");
}

/// A thread that could not be started ended the server.
#[test]
#[cfg(target_os = "linux")]
fn without_threads_requests_are_refused_and_the_server_stays() {
    use rustix::process::{Pid, Resource, Rlimit, prlimit};

    let place = tempfile::tempdir().unwrap();
    fs::write(place.path().join("index.html"), "here").unwrap();
    let mut served = Served::of(place.path(), &[]);
    let status = fs::read_to_string(format!("/proc/{}/status", served.child.id())).unwrap();
    let size =
        status.lines().find_map(|line| line.strip_prefix("VmSize:")?.strip_suffix("kB")?.trim().parse::<u64>().ok());
    // Room for a request, but for no thread's stack.
    let limit = Rlimit { current: size.map(|kilobytes| (kilobytes + 1024) << 10), maximum: None };
    let whole = prlimit(Some(Pid::from_child(&served.child)), Resource::As, limit).unwrap();
    assert!((0..8).all(|_| served.refuses()));
    assert!(served.child.try_wait().unwrap().is_none());
    prlimit(Some(Pid::from_child(&served.child)), Resource::As, whole).unwrap();
    assert_eq!(served.ask("GET /").1, b"here");
}
