//! Where a moving picture goes.

use std::path::{Path, PathBuf};

use thiserror::Error;

/// Where an animation goes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct AnimationTarget {
    path: PathBuf,
    page: bool,
}

/// The name of the file is of no use.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[error("the extension tells the format: give FILE.svg or FILE.html")]
pub struct UnknownAnimation;

impl AnimationTarget {
    /// Of the text of an option.
    pub fn parse(text: &str) -> Result<Self, UnknownAnimation> {
        let path = Path::new(text);
        match path.extension().and_then(|extension| extension.to_str()) {
            Some("svg") => Ok(Self { path: path.to_owned(), page: false }),
            Some("html") => Ok(Self { path: path.to_owned(), page: true }),
            _ => Err(UnknownAnimation),
        }
    }

    /// The file.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Is it a page around the picture?
    pub fn is_page(&self) -> bool {
        self.page
    }
}
