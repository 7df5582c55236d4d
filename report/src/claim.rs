//! One row of the comparison: a statement of the thesis, our result and the verdict.

use super::digits::{brief, short};
use super::page::{escape, inline};
use super::verdict::{Agreement, Allowance, Stated, Verdict};
use serde::{Deserialize, Serialize};

/// One statement and its verdict.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Claim {
    /// Section, equation or figure of the thesis; empty for our own statements.
    pub place: String,
    /// The statement.
    pub statement: String,
    /// Numbers that the thesis prints, and nothing else; empty if it states none.
    pub thesis: String,
    /// Our result.
    pub ours: String,
    /// Uncertainty of our result: scatter over seeds; empty if all digits shown are certain.
    pub uncertainty: String,
    /// Difference between the two numbers, or between ours and its reference.
    pub difference: String,
    /// Our judgement.
    pub verdict: Verdict,
}

/// Meaning of a number that is not reproduced.
#[derive(Debug, Clone, PartialEq)]
pub enum Otherwise<'a> {
    /// Something is wrong.
    Failure,
    /// The number was in this range before; the text says what is known and what is not.
    Known(std::ops::RangeInclusive<f64>, &'a str),
}

impl Claim {
    fn new(place: &str, statement: &str, ours: String, verdict: Verdict) -> Self {
        Self {
            place: place.into(),
            statement: statement.into(),
            thesis: String::new(),
            ours,
            uncertainty: String::new(),
            difference: String::new(),
            verdict,
        }
    }

    /// A number of the thesis beside ours: reproduced if ours lies within the allowance.
    pub fn stated(
        place: &str,
        statement: &str,
        thesis: (&str, f64),
        ours: f64,
        allowance: Allowance,
    ) -> Self {
        let shown = short(ours);
        Self::compared(
            (place, statement),
            thesis,
            (shown, ours),
            allowance,
            Otherwise::Failure,
        )
    }

    /// The same, shown as the text, and with the meaning of a number that is not reproduced.
    pub fn compared(
        (place, statement): (&str, &str),
        thesis: (&str, f64),
        (shown, ours): (String, f64),
        allowance: Allowance,
        otherwise: Otherwise,
    ) -> Self {
        let thesis = Stated::new(thesis);
        let verdict = match (Agreement::test(&thesis, ours, allowance), otherwise) {
            (Some(agreement), _) => Verdict::Reproduced(agreement),
            (None, Otherwise::Known(range, text)) if range.contains(&ours) => {
                Verdict::Differs(text.into())
            }
            _ => Verdict::Failed,
        };
        Self {
            thesis: thesis.text().into(),
            difference: brief((ours - thesis.value()).abs()),
            ..Self::new(place, statement, shown, verdict)
        }
    }

    /// A statement on sign, order, monotonicity or scaling, `what`, that holds in our result or does
    /// not.
    pub fn trend(place: &str, statement: &str, ours: String, holds: bool, what: &str) -> Self {
        Self::judged(place, statement, ours, holds, Verdict::Trend(what.into()))
    }

    /// A number of ours beside one of another source, `against`; agrees within `tolerance`, absolute.
    pub fn own(statement: &str, ours: f64, against: (&str, f64), tolerance: f64) -> Self {
        let difference = (ours - against.1).abs();
        let verdict = Verdict::OursChecked(against.0.into());
        Self {
            difference: brief(difference),
            ..Self::judged("", statement, short(ours), difference <= tolerance, verdict)
        }
    }

    /// A result of ours that agrees with its reference or does not.
    pub fn own_statement(statement: &str, ours: String, holds: bool, against: &str) -> Self {
        Self::judged(
            "",
            statement,
            ours,
            holds,
            Verdict::OursChecked(against.into()),
        )
    }

    /// A formula of the thesis: its largest deviation from our numbers, `over` what.
    pub fn formula(
        place: &str,
        statement: &str,
        deviation: f64,
        tolerance: f64,
        over: &str,
    ) -> Self {
        let verdict = Verdict::OursChecked(format!("the thesis' {place}, {over}"));
        let ours = format!("deviation {} at most", brief(deviation));
        Self::judged(place, statement, ours, deviation <= tolerance, verdict)
    }

    /// An input or a convention, which the text describes.
    pub fn definition(place: &str, statement: &str, ours: String, holds: bool, of: &str) -> Self {
        Self::judged(
            place,
            statement,
            ours,
            holds,
            Verdict::Definition(of.into()),
        )
    }

    /// A statement of the thesis that our result contradicts for a demonstrated reason.
    pub fn contradiction(
        place: &str,
        statement: &str,
        ours: String,
        holds: bool,
        cause: &str,
    ) -> Self {
        Self::judged(
            place,
            statement,
            ours,
            holds,
            Verdict::CauseKnown(cause.into()),
        )
    }

    /// A statement known to be wrong, with the evidence; `refuted` is whether the evidence holds.
    pub fn refutation(
        place: &str,
        statement: &str,
        ours: String,
        refuted: bool,
        right: &str,
    ) -> Self {
        Self::judged(
            place,
            statement,
            ours,
            refuted,
            Verdict::ThesisInError(right.into()),
        )
    }

    /// A printed number known to be wrong. If ours agreed with it, it would not be an error.
    pub fn erratum(
        place: &str,
        statement: &str,
        printed: (&str, f64),
        (ours, right): (f64, f64),
        reason: &str,
    ) -> Self {
        /// Rounding apart, ours must be the right value.
        const ROUNDING: f64 = 1e-9;
        let printed_is_wrong = (ours - printed.1).abs() > ROUNDING * right.abs();
        let ours_is_right = (ours - right).abs() <= ROUNDING * right.abs();
        let refuted = printed_is_wrong && ours_is_right;
        Self {
            difference: brief((ours - printed.1).abs()),
            ..Self::refutation(place, statement, short(ours), refuted, reason)
        }
        .printed(printed.0)
    }

    /// A statement for which the thesis gives too little; the text says what is missing.
    pub fn not_checkable(place: &str, statement: &str, why: &str) -> Self {
        Self::new(
            place,
            statement,
            String::new(),
            Verdict::NotCheckable(why.into()),
        )
    }

    fn judged(place: &str, statement: &str, ours: String, holds: bool, verdict: Verdict) -> Self {
        let verdict = if holds { verdict } else { Verdict::Failed };
        Self::new(place, statement, ours, verdict)
    }

    /// With the numbers that the thesis prints.
    pub fn printed(self, thesis: &str) -> Self {
        Self {
            thesis: thesis.into(),
            ..self
        }
    }

    /// With the uncertainty of our result.
    pub fn uncertain(self, uncertainty: impl Into<String>) -> Self {
        Self {
            uncertainty: uncertainty.into(),
            ..self
        }
    }

    /// One row of the comparison table.
    pub(super) fn row(&self) -> String {
        let or_dash = |text: &str| {
            if text.is_empty() {
                "–".to_owned()
            } else {
                inline(text)
            }
        };
        let place = match self.place.as_str() {
            "" => String::new(),
            place => format!("<span class=\"place\">{}</span> ", inline(place)),
        };
        let ours = match self.uncertainty.as_str() {
            "" => or_dash(&self.ours),
            uncertainty => {
                let (ours, uncertainty) = (inline(&self.ours), inline(uncertainty));
                format!("{ours} <span class=\"place\">{uncertainty}</span>")
            }
        };
        format!(
            "<tr><td>{place}{}</td><td>{}</td><td>{ours}</td><td>{}</td><td>{}</td></tr>\n",
            inline(&self.statement),
            or_dash(&self.thesis),
            or_dash(&self.difference),
            self.verdict_cell()
        )
    }

    fn verdict_cell(&self) -> String {
        let (class, name) = (self.verdict.class(), escape(self.verdict.name()));
        let word = format!("<span class=\"verdict {class}\">{name}</span>");
        format!("{word}<br>{}", inline(&self.verdict.evidence()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_changed_number_changes_the_verdict() {
        let known = "the level is open";
        let verdict = |ours: f64| {
            Claim::compared(
                ("4.6.1", "E₀"),
                ("54 %", 0.54),
                (short(ours), ours),
                Allowance::StatedError(0.02, "section 4.6.1".into()),
                Otherwise::Known(0.65..=0.69, known),
            )
            .verdict
        };
        assert!(matches!(verdict(0.55), Verdict::Reproduced(_)));
        assert_eq!(verdict(0.67), Verdict::Differs(known.into()));
        for strange in [0.60, 0.75, f64::NAN] {
            assert_eq!(verdict(strange), Verdict::Failed);
        }
    }

    #[test]
    fn an_erratum_is_one_only_while_ours_is_right_and_the_printed_number_is_not() {
        let verdict = |printed: f64, ours: f64| {
            Claim::erratum("A.6", "integral", ("π", printed), (ours, 2.0), "it is 2").verdict
        };
        assert_eq!(verdict(3.0, 2.0), Verdict::ThesisInError("it is 2".into()));
        assert_eq!(verdict(2.0, 2.0), Verdict::Failed);
        assert_eq!(verdict(3.0, 2.1), Verdict::Failed);
    }
}
