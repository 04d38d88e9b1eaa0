//! As much of HTTP/1.1 as a browser on this machine needs to load a page: GET and HEAD, one request a connection.

use std::fs;
use std::io::{self, BufRead, BufReader, Read, Write};
use std::net::{TcpListener, TcpStream};
use std::thread;
use std::time::Duration;

use super::folder::Folder;

/// The longest head of a request.
const LONGEST_HEAD: u64 = 16 << 10;
/// How long a client may take.
const PATIENCE: Duration = Duration::from_secs(10);

/// Answers until the process ends.
///
/// # Errors
/// No thread could be started.
pub fn serve(listener: &TcpListener, folder: &Folder) -> io::Result<()> {
    thread::scope(|scope| {
        for stream in listener.incoming() {
            // A connection that broke before it was taken, or a client that left, is no concern of the others.
            let Ok(stream) = stream else { continue };
            thread::Builder::new().spawn_scoped(scope, move || {
                let _left = answer(&stream, folder);
            })?;
        }
        Ok(())
    })
}

fn answer(stream: &TcpStream, folder: &Folder) -> io::Result<()> {
    stream.set_read_timeout(Some(PATIENCE))?;
    stream.set_write_timeout(Some(PATIENCE))?;
    let mut lines = BufReader::new(stream.take(LONGEST_HEAD)).lines();
    let request = lines.next().transpose()?.unwrap_or_default();
    // The whole head is taken before the answer: what is left unread would cut the answer off.
    for line in lines {
        if line?.is_empty() {
            break;
        }
    }
    let mut words = request.split(' ');
    let (method, target) = (words.next().unwrap_or_default(), words.next().unwrap_or_default());
    let path = target.split(['?', '#']).next().unwrap_or_default();
    let (status, kind, body) = match (method, folder.file(path)) {
        ("GET" | "HEAD", Some((file, kind))) => ("200 OK", kind, fs::read(file)?),
        ("GET" | "HEAD", None) => ("404 Not Found", "text/plain", b"There is no such file.\n".to_vec()),
        _ => ("405 Method Not Allowed", "text/plain", b"Only GET and HEAD are answered.\n".to_vec()),
    };
    let head = format!(
        "HTTP/1.1 {status}\r\nContent-Type: {kind}\r\nContent-Length: {}\r\nCache-Control: no-cache\r\nConnection: close\r\n\r\n",
        body.len()
    );
    let mut stream = stream;
    stream.write_all(head.as_bytes())?;
    if method != "HEAD" {
        stream.write_all(&body)?;
    }
    stream.flush()
}
