//! A bound on the work of one answer.

/// Boxes that may still be examined.
#[derive(Clone, Copy, Debug)]
pub(super) struct Effort {
    left: u32,
}

impl Effort {
    const LIMIT: u32 = 200_000;

    pub fn new() -> Self {
        Self { left: Self::LIMIT }
    }

    pub fn spend(&mut self) -> Option<()> {
        self.left = self.left.checked_sub(1)?;
        Some(())
    }

    pub fn spent(self) -> u32 {
        Self::LIMIT - self.left
    }
}
