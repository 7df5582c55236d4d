//! Cases from the reference tables of the tests, 25 to 32 digits.

use super::{Case, SEED};
use crate::mix::Lcg;
use crate::reference::Wide;
use tribos_tests::tables::Table;

/// Which rows of which table.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Source {
    /// A table of one pressure, with columns alpha, eps, F and T.
    File(&'static str),
    /// A uniform annulus of this inner radius.
    Annulus(f64),
    /// A polynomial pressure with these coefficients.
    Polynomial([f64; 3]),
}

/// The polynomial pressure of the front: more load in the middle and at the rim than between.
pub const POLYNOMIAL: [f64; 3] = [1.0, -2.0, 1.5];
/// Rim speeds are powers of four, by which every exponent of the front scales without rounding.
const LARGEST_POWER: f64 = 3.0;

impl Source {
    /// The one of [`POLYNOMIAL`].
    pub const POLYNOMIAL: Self = Self::Polynomial(POLYNOMIAL);

    fn file(self) -> String {
        let name = match self {
            Self::File(name) => name,
            Self::Annulus(_) => "annulus",
            Self::Polynomial(_) => "polynomial",
        };
        format!("{name}.csv")
    }
}

/// All rows of one exponent with F and T not zero, at rim speeds from a seeded sequence.
///
/// *Domain*: 2α is an integer.
pub fn cases(source: Source, alpha: f64) -> Vec<Case> {
    let table = Table::read(&source.file());
    let mut random = Lcg::new(SEED);
    let mut cases = Vec::new();
    for row in table.rows() {
        let is_asked = match source {
            Source::File(_) => true,
            Source::Annulus(k) => row.number("k") == k,
            Source::Polynomial(a) => ["a0", "a1", "a2"].map(|c| row.number(c)) == a,
        };
        let ratio = row.number("eps");
        if !is_asked || row.number("alpha") != alpha || ratio == 0.0 {
            continue;
        }
        let rim = 4.0_f64.powi(random.uniform(-LARGEST_POWER, LARGEST_POWER).round() as i32);
        let scale = rim.powf(alpha);
        cases.push(Case {
            speeds: [ratio * rim, rim],
            exact: ["F", "T"].map(|column| {
                let value = row.reference(column);
                Wide {
                    high: scale * value.high,
                    low: scale * value.low,
                }
            }),
        });
    }
    cases
}
