//! Files, numbers and words of scenes, where they are.

#[cfg(feature = "scenes")]
pub(super) use super::feet_files::feet;
#[cfg(feature = "scenes")]
pub(super) use super::files;
#[cfg(feature = "scenes")]
pub(super) use tribos_base::scene::{finite_number, nearest};

#[cfg(not(feature = "scenes"))]
pub(super) use without::{feet, files, finite_number, nearest};

/// Names are known by heart, and areas made of numbers.
#[cfg(not(feature = "scenes"))]
mod without {
    pub fn nearest<'a>(_: &str, _: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
        None
    }

    pub fn finite_number(text: &str) -> Result<f64, String> {
        let number = text.trim().parse().ok();
        let finite = number.filter(|x: &f64| x.is_finite());
        finite.ok_or_else(|| "give a finite number such as 0.5 or 1e-3".into())
    }

    pub fn feet<R: crate::Precision>(
        path: &std::path::Path,
    ) -> Result<crate::Flat<R>, crate::FrictionError> {
        Err(files::refusal(path))
    }

    pub mod files {
        use crate::FrictionError;
        use std::path::Path;

        pub fn numbers<const N: usize>(
            path: &Path,
            _: &[&str; N],
            _: usize,
        ) -> Result<Vec<[f64; N]>, FrictionError> {
            Err(refusal(path))
        }

        pub fn refusal(_: &Path) -> FrictionError {
            FrictionError::Syntax("files are read with the feature `scenes`".into())
        }

        pub fn loops(path: &Path) -> Result<Vec<Vec<[f64; 2]>>, FrictionError> {
            numbers(path, &["x", "y"], 0).map(|corners| vec![corners])
        }
    }
}
