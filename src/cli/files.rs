//! Files that appear whole and together, or not at all; and files that are read.

use std::fs;
use std::io::{self, Read, Write};
use std::path::{Path, PathBuf};

use tempfile::NamedTempFile;
use thiserror::Error;

use super::interrupt::uninterrupted;

/// Why files could not be written.
#[derive(Debug, Error)]
pub enum FilesError {
    #[error("cannot create the directory {path}: {source}; choose another with --out", path = path.display())]
    Directory { path: PathBuf, source: io::Error },
    #[error("cannot write {path}: {source}; nothing was changed", path = path.display())]
    Write { path: PathBuf, source: io::Error },
    #[error("cannot write {path}: a directory of this name is in the way; nothing was changed", path = path.display())]
    Occupied { path: PathBuf },
    #[error("cannot replace {path}: {source}", path = path.display())]
    Replace { path: PathBuf, source: io::Error },
}

/// The text of a whole file, or of stdin.
pub fn read(path: &Path) -> io::Result<String> {
    if path == Path::new("-") {
        let mut text = String::new();
        io::stdin().read_to_string(&mut text)?;
        return Ok(text);
    }
    fs::read_to_string(path)
}

/// Contents for files, most of them in one directory.
#[derive(Debug)]
pub struct FileSet {
    directory: PathBuf,
    files: Vec<(PathBuf, Vec<u8>)>,
}

impl FileSet {
    /// Nothing yet, for this directory.
    pub fn new(directory: &Path) -> Self {
        Self { directory: directory.to_owned(), files: Vec::new() }
    }

    /// Adds a file of the directory; nothing is written yet.
    pub fn add(&mut self, name: impl AsRef<Path>, contents: impl Into<Vec<u8>>) {
        self.files.push((self.directory.join(name), contents.into()));
    }

    /// Adds a file at a place of its own.
    pub fn add_at(&mut self, path: &Path, contents: impl Into<Vec<u8>>) {
        self.files.push((path.to_owned(), contents.into()));
    }

    /// Writes every file under a temporary name in its directory and, when all are whole and on the disk, renames
    /// them. If one cannot be written, none is, and directories made on the way are taken away again.
    pub fn write(self) -> Result<Vec<PathBuf>, FilesError> {
        let _guard = uninterrupted();
        let mut created = Vec::new();
        self.write_whole(&mut created).inspect_err(|_failure| {
            for directory in &created {
                // Fails where something else has been put there, which must stay.
                let _not_empty = fs::remove_dir(directory);
            }
        })
    }

    /// `created`: directories that were made, each before those that it lies in.
    fn write_whole(self, created: &mut Vec<PathBuf>) -> Result<Vec<PathBuf>, FilesError> {
        let mut whole = Vec::with_capacity(self.files.len());
        for (path, contents) in self.files {
            let directory = match path.parent() {
                Some(parent) if !parent.as_os_str().is_empty() => parent,
                _ => Path::new("."),
            };
            created.splice(0..0, create_directories(directory)?);
            if path.is_dir() {
                return Err(FilesError::Occupied { path });
            }
            match write_temporary(directory, &contents) {
                Ok(file) => whole.push((file, path)),
                Err(source) => return Err(FilesError::Write { path, source }),
            }
        }
        let mut written = Vec::with_capacity(whole.len());
        for (file, path) in whole {
            file.persist(&path).map_err(|error| FilesError::Replace { path: path.clone(), source: error.error })?;
            written.push(path);
        }
        Ok(written)
    }
}

/// A whole file under a temporary name, which vanishes unless it is persisted.
fn write_temporary(directory: &Path, contents: &[u8]) -> io::Result<NamedTempFile> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(".bifdiag-");
    #[cfg(unix)]
    {
        // As for any new file, the umask decides; the default of temporary files would hide it from others.
        use std::os::unix::fs::PermissionsExt;
        builder.permissions(fs::Permissions::from_mode(0o666));
    }
    let mut file = builder.tempfile_in(directory)?;
    file.write_all(contents)?;
    // A full disk may show only now.
    file.as_file().sync_all()?;
    Ok(file)
}

/// Makes the directory; returns those that were not there before, innermost first.
fn create_directories(directory: &Path) -> Result<Vec<PathBuf>, FilesError> {
    let missing: Vec<PathBuf> = directory
        .ancestors()
        .take_while(|path| !path.as_os_str().is_empty() && !path.exists())
        .map(Path::to_owned)
        .collect();
    fs::create_dir_all(directory).map_err(|source| FilesError::Directory { path: directory.to_owned(), source })?;
    Ok(missing)
}
