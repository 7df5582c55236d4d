//! How much of the report is computed.

/// How much is computed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Effort {
    /// What takes a minute or two.
    Quick,
    /// Everything that the thesis shows.
    Full,
}

impl Effort {
    /// In folders and on the page.
    pub fn name(self) -> &'static str {
        match self {
            Self::Quick => "quick",
            Self::Full => "full",
        }
    }
}
