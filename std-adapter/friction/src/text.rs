//! Files and words of scenes, where they are.

#[cfg(feature = "scenes")]
pub(super) use tribos_base::{
    record::read_text,
    scene::{nearest, number_hint},
};

#[cfg(not(feature = "scenes"))]
pub(super) use without::{nearest, number_hint, read_text};

/// Names are known by heart, and areas made of numbers.
#[cfg(not(feature = "scenes"))]
mod without {
    use std::path::Path;

    pub fn read_text(_: &Path, _: u64) -> Result<String, &'static str> {
        Err("files are read with the feature `scenes`")
    }

    pub fn nearest<'a>(_: &str, _: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
        None
    }

    pub fn number_hint(_: &str) -> Option<String> {
        None
    }
}
