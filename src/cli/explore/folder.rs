//! The files of a built page. Only what lies there when the program starts is served, under the name that it has there.

use std::collections::BTreeMap;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// Paths in an address to files.
#[derive(Debug)]
pub struct Folder(BTreeMap<String, PathBuf>);

impl Folder {
    /// All files below a folder.
    ///
    /// # Errors
    /// The folder cannot be read, or holds no `index.html`.
    pub fn read(root: &Path) -> io::Result<Self> {
        let mut files = BTreeMap::new();
        let mut folders = vec![(root.to_owned(), "/".to_owned())];
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
        match files.get("/index.html").cloned() {
            Some(index) => files.insert("/".to_owned(), index),
            None => return Err(io::Error::new(io::ErrorKind::NotFound, "it holds no index.html")),
        };
        Ok(Self(files))
    }

    /// The file of a path, and the type that a browser needs to be told.
    pub fn file(&self, path: &str) -> Option<(&Path, &'static str)> {
        let file = self.0.get(path)?;
        let kind = match file.extension().and_then(|suffix| suffix.to_str()) {
            Some("html") => "text/html; charset=utf-8",
            Some("js") => "text/javascript",
            Some("css") => "text/css",
            Some("wasm") => "application/wasm",
            Some("svg") => "image/svg+xml",
            _ => "application/octet-stream",
        };
        Some((file, kind))
    }
}
