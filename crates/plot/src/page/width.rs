//! How wide a picture is in print.

/// Points in print of a pixel: the smallest letters have 11 pixels.
pub(crate) const POINTS: f32 = 6.0 / 11.0;

/// The greatest height of a picture, 230 mm in print: what a page or a column leaves beside a caption.
pub(crate) const HEIGHT: f64 = 1195.0;

/// The width for which a picture is laid out: its smallest letters have 6 pt there.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Width {
    /// Both columns of a journal, 178 mm.
    #[default]
    Page,
    /// One column of a journal, 86 mm.
    Column,
}

impl Width {
    /// Each of them.
    pub const ALL: [Self; 2] = [Self::Page, Self::Column];

    /// In print.
    #[must_use]
    pub fn millimetres(self) -> f64 {
        match self {
            Self::Page => 178.0,
            Self::Column => 86.0,
        }
    }

    /// On the page: so wide 11 pixels, the smallest letters, are 6 pt in print.
    pub(crate) fn pixels(self) -> f64 {
        match self {
            Self::Page => 924.0,
            Self::Column => 446.0,
        }
    }
}
