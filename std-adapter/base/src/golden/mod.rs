//! Golden files: results of scenes, pinned to the bit, to be checked later and on other machines.
//!
//! A golden file is TOML. For each scene it contains the path, the overrides, the resolved parameters
//! with their digest, every quantity of the summary by its bits, digests of each column of the series
//! over consecutive blocks of rows, and of powders digests of the final state. A digest is FNV-1a of
//! 64 bits over the bits of the numbers, lowest byte first, with one NaN for all. A parameter that came later than
//! the file is no difference while it has its default.
//!
//! ```
//! use tribos::golden::{Golden, Pinned, Verdict, measure};
//! use tribos::scene::Scene;
//! let text = "body = \"curling\"\nmodel = \"dry\"\nspeed = 2\nspin = 1.5";
//! let measured = measure(&Scene::parse("rock.toml", text, &[])?, || ())?;
//! let golden = Golden { scenes: vec![Pinned::new("rock.toml".into(), vec![], &measured)] };
//! let read = Golden::parse("golden.toml", &golden.text())?;
//! assert_eq!(read.scenes[0].compare(&measured), Verdict::Same);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod difference;
mod digest;
mod measure;
mod pinned;
mod quantity;
mod read;
mod text;

pub use difference::{Difference, SeriesDifference, SummaryDifference, Verdict};
pub use digest::{Digest, canonical_bits};
pub use measure::{Measure, Measurement, contacts, digest, values};
pub use pinned::Pinned;
pub use quantity::Quantity;
pub use read::GoldenError;

/// Version of the format.
///
/// ```
/// use tribos::golden::{FORMAT, Golden};
/// assert!(Golden::default().text().contains(&format!("format = {FORMAT}\n")));
/// ```
pub const FORMAT: i64 = 1;

/// A golden file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Golden {
    /// Its scenes, in the order of the file.
    pub scenes: Vec<Pinned>,
}
