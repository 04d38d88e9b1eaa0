//! As much of HTTP/1.1 as a browser on this machine needs to load a page: GET and HEAD, one request a connection. Only what
//! lies in the page's folder when the program starts is served, under the name that it has there: regular files inside
//! the folder only. A `NAME.br`, beside NAME or in place of it, is sent to browsers that accept Brotli; where it is in place of
//! NAME, others are sent what it holds.

use std::collections::BTreeMap;
use std::fs;
use std::io::{self, BufRead, BufReader, Read, Write};
use std::net::{TcpListener, TcpStream};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::thread;
use std::time::{Duration, Instant};

/// The longest head of a request.
const LONGEST_HEAD: u64 = 16 << 10;
/// How long a request may take.
const REQUEST: Duration = Duration::from_secs(10);
/// How long an answer may take: a page of some megabytes through a slow tunnel.
const ANSWER: Duration = Duration::from_mins(1);
/// How long a request that is refused is waited for.
const REFUSAL: Duration = Duration::from_millis(100);
/// The most connections at one time; a browser opens about six.
const CONNECTIONS: usize = 64;
/// Pause after a connection could not be taken, for instance because no descriptor was free.
const PAUSE: Duration = Duration::from_millis(50);
/// Below this path the page's build gives each file a name that changes with its content: a browser need not ask again.
const NAMED_BY_CONTENT: &str = "/assets/";
const FOREVER: &str = "max-age=31536000, immutable";
/// Names of this machine. A page of another site whose name was made to lead here (DNS rebinding) says that name.
const HOSTS: [&str; 3] = ["localhost", "127.0.0.1", "[::1]"];

/// A folder and its files by their paths in an address.
#[derive(Debug)]
pub struct Folder {
    root: PathBuf,
    files: BTreeMap<String, PathBuf>,
}

impl Folder {
    /// All files below a folder.
    ///
    /// # Errors
    /// The folder cannot be read, or holds no `index.html`.
    pub fn read(root: &Path) -> io::Result<Self> {
        let root = root.canonicalize()?;
        let mut files = BTreeMap::new();
        let mut folders = vec![(root.clone(), "/".to_owned())];
        while let Some((folder, prefix)) = folders.pop() {
            for entry in fs::read_dir(folder)? {
                let entry = entry?;
                let path = format!("{prefix}{}", entry.file_name().to_string_lossy());
                if entry.file_type()?.is_dir() {
                    folders.push((entry.path(), format!("{path}/")));
                } else {
                    files.insert(path, entry.path());
                }
            }
        }
        match files.get("/index.html").filter(|index| inside(&root, index).is_some()).cloned() {
            Some(index) => files.insert("/".to_owned(), index),
            None => return Err(io::Error::new(io::ErrorKind::NotFound, "it holds no index.html")),
        };
        Ok(Self { root, files })
    }

    fn file(&self, path: &str) -> Option<PathBuf> {
        inside(&self.root, self.files.get(path)?)
    }

    /// What is sent of a path, and whether it is packed, which it is only if the browser `accepts` that.
    fn content(&self, path: &str, accepts: bool) -> Option<io::Result<(Vec<u8>, bool)>> {
        let plain = self.file(path);
        let packed = self.file(&format!("{path}.br")).filter(|_| accepts || plain.is_none());
        Some(match (packed, plain) {
            (Some(packed), _) if accepts => fs::read(packed).map(|bytes| (bytes, true)),
            (Some(packed), _) => fs::File::open(packed).and_then(|mut packed| {
                let mut bytes = Vec::new();
                brotli_decompressor::BrotliDecompress(&mut packed, &mut bytes)?;
                Ok((bytes, false))
            }),
            (None, plain) => fs::read(plain?).map(|bytes| (bytes, false)),
        })
    }
}

/// The content type of a path.
fn kind(path: &str) -> &'static str {
    match path.rsplit(['/', '.']).next() {
        // A folder's path ends in nothing.
        Some("" | "html") => "text/html; charset=utf-8",
        Some("js") => "text/javascript",
        Some("css") => "text/css",
        Some("wasm") => "application/wasm",
        Some("svg") => "image/svg+xml",
        _ => "application/octet-stream",
    }
}

/// Where a regular file of a folder lies once links are followed, if that is in the folder.
fn inside(root: &Path, file: &Path) -> Option<PathBuf> {
    file.canonicalize().ok().filter(|file| file.starts_with(root) && file.is_file())
}

/// Answers until the process ends.
pub fn serve(listener: &TcpListener, folder: &Folder) {
    let connections = Arc::new(());
    thread::scope(|scope| {
        for stream in listener.incoming() {
            let Ok(stream) = stream.map(Arc::new) else {
                thread::sleep(PAUSE);
                continue;
            };
            // It is counted until it ends; so it is where no thread could be started, and the closure is dropped.
            let (own, counted) = (Arc::clone(&stream), Arc::clone(&connections));
            let is_one_too_many = Arc::strong_count(&counted) > CONNECTIONS + 1;
            let work = move || {
                let _left = answer(&own, folder);
                drop(counted);
            };
            if is_one_too_many || thread::Builder::new().spawn_scoped(scope, work).is_err() {
                let _left = refuse(&stream);
            }
        }
    });
}

/// Reads and writes of a connection, together no longer than until a time.
struct Until<'a>(&'a TcpStream, Instant);

impl Until<'_> {
    /// The time that is left.
    fn left(&self) -> io::Result<Option<Duration>> {
        let left = self.1.checked_duration_since(Instant::now()).filter(|left| !left.is_zero());
        left.map(Some).ok_or_else(|| io::ErrorKind::TimedOut.into())
    }
}

impl Read for Until<'_> {
    fn read(&mut self, bytes: &mut [u8]) -> io::Result<usize> {
        self.0.set_read_timeout(self.left()?)?;
        self.0.read(bytes)
    }
}

impl Write for Until<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.set_write_timeout(self.left()?)?;
        self.0.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.0.flush()
    }
}

/// The lines of a request's head. All of it is taken before an answer: it may come in several pieces, and what is left unread
/// would cut the answer off.
fn head(stream: &TcpStream, until: Instant) -> io::Result<Vec<String>> {
    let mut lines = Vec::new();
    for line in BufReader::new(Until(stream, until).take(LONGEST_HEAD)).lines() {
        let line = line?;
        if !lines.is_empty() && line.is_empty() {
            break;
        }
        lines.push(line);
    }
    Ok(lines)
}

fn answer(stream: &TcpStream, folder: &Folder) -> io::Result<()> {
    let head = head(stream, Instant::now() + REQUEST)?;
    let (request, fields) = head.split_first().map_or(("", &[][..]), |(request, fields)| (request.as_str(), fields));
    let values = |name: &'static str| {
        fields.iter().filter_map(move |field| field.split_once(':').filter(|(key, _)| key.eq_ignore_ascii_case(name)))
    };
    let hosts: Vec<bool> = values("host").map(|(_, host)| is_own(host)).collect();
    let accepts = values("accept-encoding").any(|(_, codings)| accepts_brotli(codings));
    let mut words = request.split(' ');
    let (method, target) = (words.next().unwrap_or_default(), words.next().unwrap_or_default());
    let path = target.split(['?', '#']).next().unwrap_or_default();
    let mut encoding = "";
    let (status, kind, body) = match (method, folder.content(path, accepts)) {
        _ if hosts != [true] => ("421 Misdirected Request", "text/plain", b"Only localhost is served.\n".to_vec()),
        ("GET" | "HEAD", Some(Ok((body, is_packed)))) => {
            encoding = if is_packed { "Content-Encoding: br\r\n" } else { "" };
            ("200 OK", kind(path), body)
        }
        ("GET" | "HEAD", Some(Err(_))) => {
            ("503 Service Unavailable", "text/plain", b"The file cannot be read now.\n".to_vec())
        }
        ("GET" | "HEAD", None) => ("404 Not Found", "text/plain", b"There is no such file.\n".to_vec()),
        _ => ("405 Method Not Allowed", "text/plain", b"Only GET and HEAD are answered.\n".to_vec()),
    };
    let keep = if status.starts_with("200") && path.starts_with(NAMED_BY_CONTENT) { FOREVER } else { "no-cache" };
    let head = format!(
        "HTTP/1.1 {status}\r\nContent-Type: {kind}\r\nContent-Length: {}\r\n{encoding}Vary: Accept-Encoding\r\nCache-Control: {keep}\r\nConnection: close\r\n\r\n",
        body.len()
    );
    let mut stream = Until(stream, Instant::now() + ANSWER);
    stream.write_all(head.as_bytes())?;
    if method != "HEAD" {
        stream.write_all(&body)?;
    }
    stream.flush()
}

/// True for a list of content codings that has Brotli, and not with the weight 0.
fn accepts_brotli(codings: &str) -> bool {
    codings.split(',').any(|coding| {
        let (name, weight) = coding.split_once(';').unwrap_or((coding, ""));
        let weight = weight.trim().strip_prefix("q=").map_or(Ok(1.0), str::parse::<f64>);
        name.trim().eq_ignore_ascii_case("br") && weight.is_ok_and(|weight| weight > 0.0)
    })
}

/// True for a name of this machine, with a port or without: a tunnel may lead here from another port.
fn is_own(host: &str) -> bool {
    let host = host.trim().to_ascii_lowercase();
    HOSTS.iter().any(|name| match host.strip_prefix(name).map(|rest| rest.strip_prefix(':').ok_or(rest)) {
        Some(Ok(port)) => port.parse::<u16>().is_ok(),
        Some(Err(rest)) => rest.is_empty(),
        None => false,
    })
}

/// Answers without a thread that there are too many connections.
fn refuse(stream: &TcpStream) -> io::Result<()> {
    let until = Instant::now() + REFUSAL;
    let _request = head(stream, until)?;
    Until(stream, until)
        .write_all(b"HTTP/1.1 503 Service Unavailable\r\nContent-Length: 0\r\nConnection: close\r\n\r\n")
}
