//! The files of a built page. Only what lies there when the program starts is served, under the name that it has there:
//! regular files, none of them outside of the folder.

use std::collections::BTreeMap;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

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

    /// The file of a path, and the type that a browser needs to be told.
    pub fn file(&self, path: &str) -> Option<(PathBuf, &'static str)> {
        let file = self.files.get(path)?;
        let kind = match file.extension().and_then(|suffix| suffix.to_str()) {
            Some("html") => "text/html; charset=utf-8",
            Some("js") => "text/javascript",
            Some("css") => "text/css",
            Some("wasm") => "application/wasm",
            Some("svg") => "image/svg+xml",
            _ => "application/octet-stream",
        };
        Some((inside(&self.root, file)?, kind))
    }
}

/// Where a regular file of a folder lies once links are followed, if that is in the folder.
fn inside(root: &Path, file: &Path) -> Option<PathBuf> {
    file.canonicalize().ok().filter(|file| file.starts_with(root) && file.is_file())
}
