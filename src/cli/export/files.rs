//! Files that appear whole and together, or not at all.

use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use bifdiag_plot::{Figure, Picture};
use clap::ValueEnum;
use serde::Serialize;
use tempfile::{NamedTempFile, PersistError};

use super::picture::{PictureArguments, PictureFormat};
use crate::cli::failure::Failure;
use crate::cli::terminal::Timings;
use crate::cli::terminal::interrupt::{unfinished, uninterrupted};

/// What a file is to hold.
enum Contents {
    Whole(Vec<u8>),
    /// This writes it.
    Written(Box<Writing>),
}

/// Writes a file.
type Writing = dyn FnOnce(&mut BufWriter<&mut File>) -> io::Result<()>;

/// Contents for files, most of them in one directory.
pub struct FileSet {
    directory: PathBuf,
    files: Vec<(PathBuf, Contents)>,
    /// Files of earlier runs.
    stale: Vec<PathBuf>,
}

impl FileSet {
    /// Nothing yet, for this directory.
    pub fn new(directory: &Path) -> Self {
        Self { directory: directory.to_owned(), files: Vec::new(), stale: Vec::new() }
    }

    /// Adds a file of the directory; nothing is written yet.
    pub fn add(&mut self, name: impl AsRef<Path>, contents: impl Into<Vec<u8>>) {
        self.files.push((self.directory.join(name), Contents::Whole(contents.into())));
    }

    /// Adds a file at a place of its own.
    pub fn add_at(&mut self, path: &Path, contents: impl Into<Vec<u8>>) {
        self.files.push((path.to_owned(), Contents::Whole(contents.into())));
    }

    /// Adds a file that may be too long for the memory, at a place of its own, which no other process writes meanwhile:
    /// what earlier runs left under temporary names when they were killed goes.
    pub fn add_written(
        &mut self,
        path: &Path,
        write: impl FnOnce(&mut BufWriter<&mut File>) -> io::Result<()> + 'static,
    ) {
        self.files.push((path.to_owned(), Contents::Written(Box::new(write))));
    }

    /// Adds a document as JSON.
    pub fn json(&mut self, stem: &str, document: &impl Serialize) -> Result<(), Failure> {
        self.add(format!("{stem}.json"), bifdiag_documents::layout::text(document)?);
        Ok(())
    }

    /// Names the pictures of earlier runs, which are removed unless they are rewritten.
    pub fn remove_pictures(&mut self, stem: &str) {
        for format in PictureFormat::value_variants() {
            self.remove(format!("{stem}.{}", format.ending()));
            self.remove(format!("{stem}.legend.{}", format.ending()));
        }
        for ending in ["txt", "tex"] {
            self.remove(format!("{stem}.caption.{ending}"));
        }
    }

    /// Adds a picture in its formats with its legend, if that is a picture of its own, and its caption.
    pub fn figure(
        &mut self,
        stem: &str,
        figure: Figure,
        arguments: &PictureArguments,
        timings: &Timings,
    ) -> Result<(), Failure> {
        self.pictures(stem, &figure.picture, arguments, timings)?;
        if let Some(legend) = &figure.legend {
            self.pictures(&format!("{stem}.legend"), legend, arguments, timings)?;
        }
        self.add(format!("{stem}.caption.txt"), figure.caption.text);
        self.add(format!("{stem}.caption.tex"), figure.caption.tex);
        Ok(())
    }

    /// Adds a picture in several formats.
    pub fn pictures(
        &mut self,
        stem: &str,
        picture: &Picture,
        arguments: &PictureArguments,
        timings: &Timings,
    ) -> Result<(), Failure> {
        arguments.format.iter().try_for_each(|&format| {
            let bytes = timings.stage(format.ending(), || arguments.bytes(format, picture))?;
            self.add(format!("{stem}.{}", format.ending()), bytes);
            Ok(())
        })
    }

    /// Marks a file of an earlier run for removal when the others are written.
    pub fn remove(&mut self, name: impl AsRef<Path>) {
        self.stale.push(self.directory.join(name));
    }

    /// Writes every file under a temporary name in its directory and, when all are whole and on the disk, renames
    /// them. If one cannot be written, none is, and directories created for it are removed again.
    pub fn write(self) -> Result<Vec<PathBuf>, Failure> {
        let _guard = uninterrupted();
        let written = self.write_whole();
        for path in unfinished().drain(..) {
            // Temporary files are gone; directories stay if something lies in them.
            let _not_empty = fs::remove_dir(path);
        }
        written
    }

    fn write_whole(self) -> Result<Vec<PathBuf>, Failure> {
        let mut whole = Vec::with_capacity(self.files.len());
        for (path, contents) in self.files {
            let directory = match path.parent() {
                Some(parent) if !parent.as_os_str().is_empty() => parent,
                _ => Path::new("."),
            };
            create_directories(directory)?;
            if path.is_dir() {
                let path = path.display();
                return Err(Failure::work(format!(
                    "cannot write {path}: a directory of this name is in the way; nothing was changed"
                )));
            }
            let name = path.file_name().unwrap_or_default().to_string_lossy();
            match write_temporary(directory, &format!(".bifdiag-{name}-"), contents) {
                Ok(file) => whole.push((file, path)),
                Err(error) => {
                    let path = path.display();
                    return Err(
                        Failure::work(format!("cannot write {path}: {error}; nothing was changed")).because(error)
                    );
                }
            }
        }
        let mut written = Vec::with_capacity(whole.len());
        let _lock = locked(&self.directory);
        let mut unfinished = unfinished();
        for (file, path) in whole {
            file.persist(&path).map_err(|PersistError { error, .. }| {
                Failure::work(format!("cannot replace {}: {error}", path.display())).because(error)
            })?;
            written.push(path);
        }
        unfinished.clear();
        for path in self.stale.into_iter().filter(|path| !written.contains(path) && path.is_file()) {
            fs::remove_file(&path).map_err(|error| {
                let path = path.display();
                Failure::work(format!("cannot remove {path}, which an earlier run left: {error}")).because(error)
            })?;
        }
        Ok(written)
    }
}

/// A whole file under a temporary name, which vanishes unless it is persisted.
fn write_temporary(directory: &Path, prefix: &str, contents: Contents) -> io::Result<NamedTempFile> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(prefix);
    #[cfg(unix)]
    {
        // As for any new file, the umask decides; the default of temporary files would hide it from others.
        use std::os::unix::fs::PermissionsExt;
        builder.permissions(fs::Permissions::from_mode(0o666));
    }
    let mut file = {
        let mut unfinished = unfinished();
        let file = builder.tempfile_in(directory)?;
        unfinished.insert(0, file.path().to_owned());
        file
    };
    match contents {
        Contents::Whole(bytes) => file.write_all(&bytes)?,
        Contents::Written(write) => {
            remove_others(directory, prefix, file.path())?;
            let mut writer = BufWriter::with_capacity(1 << 20, file.as_file_mut());
            write(&mut writer)?;
            writer.flush()?;
        }
    }
    // A full disk may show only now.
    file.as_file().sync_all()?;
    Ok(file)
}

/// A lock on a directory, held while the files of a set are renamed, so that those of two runs do not mix. Absent where
/// the system cannot lock directories.
fn locked(directory: &Path) -> Option<File> {
    let file = File::open(directory).ok()?;
    file.lock().ok()?;
    Some(file)
}

/// Takes away what killed runs left of a file: it may be as large as the disk.
fn remove_others(directory: &Path, prefix: &str, own: &Path) -> io::Result<()> {
    for entry in fs::read_dir(directory)? {
        let path = entry?.path();
        let is_left = path.file_name().is_some_and(|name| name.to_string_lossy().starts_with(prefix));
        if is_left && path.file_name() != own.file_name() {
            fs::remove_file(path)?;
        }
    }
    Ok(())
}

/// Makes the directory and those that it lies in; they are unfinished, innermost first.
fn create_directories(directory: &Path) -> Result<(), Failure> {
    let missing = directory.ancestors().take_while(|path| !path.as_os_str().is_empty() && !path.exists());
    unfinished().splice(0..0, missing.map(Path::to_owned));
    fs::create_dir_all(directory).map_err(|error| {
        let path = directory.display();
        Failure::work(format!("cannot create the directory {path}: {error}; choose another place")).because(error)
    })
}
