//! Rows of the front of patches: patch × law × tier, each with error and time.
//!
//! | judge | of what | digits |
//! |---|---|---|
//! | `tables` | power laws in f64: the reference tables of the tests, 25 to 32 digits | 25 |
//! | `f64` | power laws in f32: the compact tier in f64 at the rounded speeds | 13 |
//! | `area` | any law, any pressure: [`area`], double-exponential integrals | 11 |
//! | `sum` | contacts at points: the same sum in double-double arithmetic | 30 |
//! | `disk` | the limit surface: the double-double wrench of the disk | 30 |

pub mod area;
pub mod laws;
pub mod points;
pub mod round;
pub mod surface;
pub mod tables;
pub mod tall;

use crate::methods::sweep;
use crate::reference::Wide;
use std::hint::black_box;
use tribos_core::real::Real;

/// Seed of every set of speeds.
pub const SEED: u64 = 1;

/// Why a row could not be made; it does not happen.
pub type Refused = Box<dyn core::error::Error>;

/// Subject of a row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Label {
    /// Shape and pressure.
    pub patch: &'static str,
    /// Local law.
    pub law: &'static str,
    /// Tier that computes it.
    pub tier: &'static str,
    /// Reference for the errors.
    pub judge: &'static str,
}

/// Sliding and rim speed, with force and torque as they should be.
#[derive(Clone, Copy, Debug)]
pub struct Case {
    /// v and w.
    pub speeds: [f64; 2],
    /// F and T.
    pub exact: [Wide; 2],
}

/// Largest errors; infinite if a result was NaN.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Worst {
    /// |δF|/F
    pub force: f64,
    /// |δT|/T
    pub torque: f64,
    /// The larger of |δF| and |δT| over the larger of F and T: errors in units of what the contact
    /// carries, for μ = N = R = 1.
    pub of_larger: f64,
}

impl Worst {
    /// Takes in one result.
    pub fn include(&mut self, found: [f64; 2], exact: [Wide; 2]) {
        let [force, torque] = [0, 1].map(|i| deviation(found[i], exact[i]));
        let scale = exact[0].high.abs().max(exact[1].high.abs());
        self.force = self.force.max(over(force, exact[0].high));
        self.torque = self.torque.max(over(torque, exact[1].high));
        self.of_larger = self.of_larger.max(over(force.max(torque), scale));
    }
}

/// |found − exact|; NaN counts as infinite, so that `max` cannot lose it.
fn deviation(found: f64, exact: Wide) -> f64 {
    let error = ((found - exact.high) - exact.low).abs();
    if error.is_nan() { f64::INFINITY } else { error }
}

/// 0/0 is no error.
fn over(error: f64, size: f64) -> f64 {
    if error == 0.0 {
        0.0
    } else {
        error / size.abs()
    }
}

/// One row of the front, ready to be timed.
pub struct Entry {
    /// Patch, law, tier and reference of the row.
    pub label: Label,
    /// "f64" or "f32".
    pub precision: &'static str,
    /// Memory that it occupies: a table, nodes, parameters.
    pub bytes: usize,
    /// How far off it is.
    pub worst: Worst,
    /// Evaluations in one run.
    pub elements: usize,
    /// One run over its speeds.
    pub run: Box<dyn FnMut()>,
}

impl core::fmt::Debug for Entry {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_struct("Entry")
            .field("label", &self.label)
            .field("precision", &self.precision)
            .finish_non_exhaustive()
    }
}

impl Entry {
    /// Judges `evaluate` on `cases` and makes it ready to be timed on `timed`.
    pub fn new<R: Real>(
        label: Label,
        bytes: usize,
        cases: &[Case],
        timed: &[[f64; 2]],
        evaluate: impl Fn(R, R) -> [R; 2] + 'static,
    ) -> Self {
        let mut worst = Worst::default();
        for case in cases {
            let [slide, rim] = case.speeds.map(R::from_f64);
            worst.include(evaluate(slide, rim).map(R::to_f64), case.exact);
        }
        let pairs: Vec<[R; 2]> = timed.iter().map(|pair| pair.map(R::from_f64)).collect();
        let mut results = vec![[R::ZERO; 2]; pairs.len()];
        let sweep = sweep(evaluate);
        Self {
            label,
            precision: precision::<R>(),
            bytes,
            worst,
            elements: pairs.len(),
            run: Box::new(move || {
                sweep(black_box(&pairs), black_box(&mut results));
                black_box(&mut results);
            }),
        }
    }
}

/// "f64" or "f32".
pub fn precision<R: Real>() -> &'static str {
    if size_of::<R>() == size_of::<f64>() {
        "f64"
    } else {
        "f32"
    }
}
