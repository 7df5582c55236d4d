//! Files, numbers and words of scenes, where they are.

#[cfg(feature = "scenes")]
pub(super) use tribos_base::{
    record::Rows,
    scene::{finite_number, nearest},
};

#[cfg(not(feature = "scenes"))]
pub(super) use without::{Rows, finite_number, nearest};

/// Names are known by heart, and areas made of numbers.
#[cfg(not(feature = "scenes"))]
mod without {
    use std::convert::Infallible;
    use std::path::Path;

    pub fn nearest<'a>(_: &str, _: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
        None
    }

    pub fn finite_number(text: &str) -> Result<f64, String> {
        let number = text.trim().parse().ok();
        let finite = number.filter(|x: &f64| x.is_finite());
        finite.ok_or_else(|| "give a finite number such as 0.5 or 1e-3".into())
    }

    /// There are none.
    pub struct Rows(Infallible);

    impl Rows {
        pub fn open(
            _: &Path,
            _: impl FnOnce(&[&str]) -> &'static [&'static str],
        ) -> Result<Self, &'static str> {
            Err("files are read with the feature `scenes`")
        }

        pub fn all<const N: usize>(self, _: usize) -> Result<Vec<[f64; N]>, &'static str> {
            match self.0 {}
        }

        pub fn next(&mut self, _: &mut [f64]) -> Result<Option<u64>, &'static str> {
            match self.0 {}
        }

        pub fn words(&self) -> &[String] {
            match self.0 {}
        }

        pub fn refusal(&self, _: &str) -> &'static str {
            match self.0 {}
        }
    }
}
