//! One figure or table of the thesis with its claims, and what exhibits share.

use crate::failure::Failure;
use crate::report::image::Drawing;
use crate::report::page::{Claim, Verdict};
use crate::report::player::Film;
use tribos_core::coupling::ReducedWrench;
use tribos_core::coupling::{Coupling, table::Table64};
use tribos_core::modes::Modes;

/// What one maker returns.
pub struct Exhibit {
    pub heading: String,
    pub text: Vec<String>,
    pub caption: String,
    /// Shown below the figure.
    pub film: Option<Film>,
    pub drawing: Box<dyn Drawing>,
    pub columns: Vec<&'static str>,
    pub rows: Vec<Vec<f64>>,
    pub claims: Vec<Claim>,
}

/// The table of one exponent.
pub fn table(alpha: f64) -> Result<Table64, Failure> {
    Table64::new(alpha).map_err(Failure::run)
}

/// Final motion for one exponent and inertia ratio.
pub fn modes(alpha: f64, inertia_ratio: f64) -> Result<Modes<f64, Table64>, Failure> {
    Modes::new(table(alpha)?, inertia_ratio).map_err(Failure::run)
}

/// F and T at ε with ωR = 1.
pub fn at(table: &Table64, ratio: f64) -> [f64; 2] {
    let ReducedWrench { force, torque } = table.reduced_wrench(ratio, 1.0);
    [force, torque]
}

/// `n` + 1 numbers from `from` to `to`, equally spaced.
pub fn linear(from: f64, to: f64, n: usize) -> Vec<f64> {
    (0..=n)
        .map(|i| from + (to - from) * i as f64 / n as f64)
        .collect()
}

/// `n` + 1 numbers from `from` to `to`, equally spaced in the logarithm.
pub fn geometric(from: f64, to: f64, n: usize) -> Vec<f64> {
    linear(from.ln(), to.ln(), n)
        .into_iter()
        .map(f64::exp)
        .collect()
}

/// Column `y` of the rows against column `x`.
pub fn points(rows: &[Vec<f64>], x: usize, y: usize) -> Vec<(f64, f64)> {
    rows.iter().map(|row| (row[x], row[y])).collect()
}

/// A number of the thesis beside ours; agrees within `tolerance`, absolute.
pub fn claim(statement: &str, thesis: (&str, f64), ours: f64, tolerance: f64) -> Claim {
    let difference = (ours - thesis.1).abs();
    Claim {
        statement: statement.into(),
        thesis: thesis.0.into(),
        ours: short(ours),
        uncertainty: String::new(),
        difference: format!("{difference:.1e}"),
        verdict: if difference <= tolerance {
            Verdict::Agrees
        } else {
            Verdict::Differs
        },
    }
}

/// A statement that either holds in our computation or does not; `shown` is the evidence.
pub fn statement(statement: &str, thesis: &str, shown: String, holds: bool) -> Claim {
    Claim {
        statement: statement.into(),
        thesis: thesis.into(),
        ours: shown,
        uncertainty: String::new(),
        difference: String::new(),
        verdict: if holds {
            Verdict::Agrees
        } else {
            Verdict::Differs
        },
    }
}

/// A printed number known to be wrong. If ours agreed with it, it would not be an erratum.
pub fn erratum(what: &str, printed: (&str, f64), ours: f64, right: f64, reason: &str) -> Claim {
    /// Rounding apart, ours must be the right value.
    const ROUNDING: f64 = 1e-9;
    let printed_is_wrong = (ours - printed.1).abs() > ROUNDING * right.abs();
    let ours_is_right = (ours - right).abs() <= ROUNDING * right.abs();
    Claim {
        statement: what.into(),
        thesis: printed.0.into(),
        ours: short(ours),
        uncertainty: String::new(),
        difference: format!("{:.1e}", (ours - printed.1).abs()),
        verdict: if printed_is_wrong && ours_is_right {
            Verdict::Erratum(reason.into())
        } else {
            Verdict::Differs
        },
    }
}

/// A statement known to be wrong, with the evidence; `refuted` tells that the evidence holds.
pub fn refutation(what: &str, printed: &str, shown: String, refuted: bool, reason: &str) -> Claim {
    Claim {
        statement: what.into(),
        thesis: printed.into(),
        ours: shown,
        uncertainty: String::new(),
        difference: String::new(),
        verdict: if refuted {
            Verdict::Erratum(reason.into())
        } else {
            Verdict::Differs
        },
    }
}

/// Something that cannot be reproduced here.
pub fn not_checked(what: &str, thesis: &str, why: &str) -> Claim {
    Claim {
        statement: what.into(),
        thesis: thesis.into(),
        ours: why.into(),
        uncertainty: String::new(),
        difference: String::new(),
        verdict: Verdict::NotChecked,
    }
}

/// Twelve decimals, or seven significant digits for very small and large numbers.
pub fn short(x: f64) -> String {
    if x != 0.0 && x.is_finite() && !(1e-3..1e6).contains(&x.abs()) {
        format!("{x:.6e}")
    } else {
        format!("{x:.12}")
    }
}

/// A number that hangs on conditions which the thesis does not state.
pub struct Conditional<'a> {
    /// What it is.
    pub statement: &'a str,
    /// As printed, and its value.
    pub thesis: (&'a str, f64),
    /// As shown, and its value.
    pub ours: (String, f64),
    /// Agrees within this, absolute.
    pub tolerance: f64,
    /// Where ours was found before: outside of it something is wrong with ours.
    pub known: std::ops::RangeInclusive<f64>,
    /// What decides.
    pub reason: &'a str,
}

impl Conditional<'_> {
    /// Agrees, differs for the reason given, or just differs.
    pub fn claim(self) -> Claim {
        let ours = self.ours.1;
        let difference = (ours - self.thesis.1).abs();
        Claim {
            statement: self.statement.into(),
            thesis: self.thesis.0.into(),
            ours: self.ours.0,
            uncertainty: String::new(),
            difference: format!("{difference:.1e}"),
            verdict: if difference <= self.tolerance {
                Verdict::Agrees
            } else if self.known.contains(&ours) {
                Verdict::Unstated(self.reason.into())
            } else {
                Verdict::Differs
            },
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_condition_excuses_only_what_was_found_before() {
        let verdict = |ours: f64| {
            let conditional = Conditional {
                statement: "porosity",
                thesis: ("54 %", 0.54),
                ours: (short(ours), ours),
                tolerance: 0.02,
                known: 0.65..=0.69,
                reason: "d_c",
            };
            conditional.claim().verdict
        };
        assert_eq!(verdict(0.55), Verdict::Agrees);
        assert_eq!(verdict(0.67), Verdict::Unstated("d_c".into()));
        for strange in [0.60, 0.75, f64::NAN] {
            assert_eq!(verdict(strange), Verdict::Differs);
        }
    }
}
