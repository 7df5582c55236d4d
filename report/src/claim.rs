//! One row of the comparison: a statement of the thesis, our result and the verdict.

use super::digits::{brief, short};
use super::html::{escape, inline};
use super::verdict::{Agreement, Allowance, CLASSES, PrintedNumber, Verdict};
use serde::{Deserialize, Serialize};
use std::fmt::Display;

/// One statement and its verdict.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Claim {
    /// Name of the statement in its list. Rows of one name and place are one statement for several
    /// models or parameters.
    pub id: String,
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
    /// What is shown, as numbers.
    pub numbers: Numbers,
    /// Our judgement.
    pub verdict: Verdict,
}

/// The numbers of a row, in the unit of the statement; those that it has not are missing.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Numbers {
    /// What the thesis prints.
    pub thesis: Option<f64>,
    /// Our result.
    pub ours: Option<f64>,
    /// Distance of the two, or of ours and its reference.
    pub difference: Option<f64>,
    /// Largest distance at which they agree.
    pub allowance: Option<f64>,
    /// Standard error of ours, and standard deviation of the thesis' number.
    pub sigma: Option<[f64; 2]>,
    /// Random samples of ours.
    pub samples: Option<u64>,
}

impl Numbers {
    /// The difference in combined standard deviations, √(σ² + σ_thesis²).
    pub fn z(&self) -> Option<f64> {
        let ([ours, thesis], difference) = self.sigma.zip(self.difference)?;
        Some(difference / ours.hypot(thesis))
    }
}

/// Samples below which a mean decides little.
pub const ENOUGH_SAMPLES: u64 = 5;

/// Combined deviations below which two random numbers do not differ.
const DECISIVE: f64 = 2.0;

/// Meaning of a number that is not reproduced.
#[derive(Debug, Clone, PartialEq)]
pub enum MismatchMeaning {
    /// Something is wrong.
    Failure,
    /// It was found in this range before.
    Known(std::ops::RangeInclusive<f64>),
}

/// The words of a row.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Statement {
    /// Its name in the list that it is from, if there is one.
    pub id: String,
    /// Where the thesis makes it: section, equation, figure; empty for our own.
    pub place: String,
    /// The statement itself.
    pub text: String,
    /// What the verdict rests on: the property or the source compared with, the cause of a
    /// difference, what is right instead, or what is missing.
    pub basis: String,
}

impl Statement {
    /// Reads `(place): text — basis`; place and basis may be missing.
    pub fn parse(words: &str) -> Self {
        let placed = words
            .strip_prefix('(')
            .and_then(|rest| rest.split_once("): "));
        let (place, rest) = placed.unwrap_or(("", words));
        let (text, basis) = rest.split_once(" — ").unwrap_or((rest, ""));
        let [place, text, basis] = [place, text, basis].map(|part| part.trim().to_owned());
        Self {
            id: String::new(),
            place,
            text,
            basis,
        }
    }

    /// With a value in place of `{name}`.
    pub fn with(self, name: &str, value: impl Display) -> Self {
        let (name, value) = (format!("{{{name}}}"), value.to_string());
        let fill = |text: String| text.replace(&name, &value);
        Self {
            id: self.id,
            place: fill(self.place),
            text: fill(self.text),
            basis: fill(self.basis),
        }
    }
}

impl Claim {
    fn new(statement: Statement, ours: String, verdict: Verdict) -> Self {
        Self {
            id: statement.id,
            place: statement.place,
            statement: statement.text,
            thesis: String::new(),
            ours,
            uncertainty: String::new(),
            numbers: Numbers::default(),
            verdict,
        }
    }

    /// A number of the thesis beside ours: reproduced if ours lies within the allowance.
    pub fn stated(
        statement: Statement,
        thesis: (&str, f64),
        ours: f64,
        allowance: Allowance,
    ) -> Self {
        let shown = (short(ours), ours);
        Self::compared(
            statement,
            thesis,
            shown,
            allowance,
            MismatchMeaning::Failure,
        )
    }

    /// The same, shown as the text. If it is not reproduced, the basis of the statement says why.
    pub fn compared(
        statement: Statement,
        thesis: (&str, f64),
        (shown, ours): (String, f64),
        allowance: Allowance,
        otherwise: MismatchMeaning,
    ) -> Self {
        let thesis = PrintedNumber::new(thesis);
        let numbers = Numbers {
            thesis: Some(thesis.value()),
            ours: Some(ours),
            difference: Some((ours - thesis.value()).abs()),
            allowance: Some(allowance.size()),
            ..Numbers::default()
        };
        let verdict = match (Agreement::test(&thesis, ours, allowance), otherwise) {
            (Some(agreement), _) => Verdict::Reproduced(agreement),
            (None, MismatchMeaning::Known(range)) if range.contains(&ours) => {
                Verdict::Differs(statement.basis.clone())
            }
            _ => Verdict::Failed,
        };
        Self {
            thesis: thesis.text().into(),
            numbers,
            ..Self::new(statement, shown, verdict)
        }
    }

    /// A statement on sign, order, monotonicity or scaling that holds in our result or does not.
    pub fn trend(statement: Statement, ours: impl Into<String>, holds: bool) -> Self {
        Self::judged(statement, ours, holds, Verdict::Trend)
    }

    /// A number of ours beside one of another source; agrees within `tolerance`, absolute.
    pub fn own(statement: Statement, ours: f64, other: f64, tolerance: f64) -> Self {
        let difference = (ours - other).abs();
        Self {
            numbers: Numbers {
                ours: Some(ours),
                difference: Some(difference),
                allowance: Some(tolerance),
                ..Numbers::default()
            },
            ..Self::own_statement(statement, short(ours), difference <= tolerance)
        }
    }

    /// A result of ours that agrees with what it is checked against, or does not.
    pub fn own_statement(statement: Statement, ours: impl Into<String>, holds: bool) -> Self {
        Self::judged(statement, ours, holds, Verdict::OursChecked)
    }

    /// A formula of the thesis: its largest deviation from our numbers.
    pub fn formula(statement: Statement, deviation: f64, tolerance: f64) -> Self {
        let ours = format!("deviation {} at most", brief(deviation));
        let place = statement.place.clone();
        let verdict = |basis| Verdict::OursChecked(format!("the thesis' {place}, {basis}"));
        Self::judged(statement, ours, deviation <= tolerance, verdict)
    }

    /// An input or a convention; the basis says of what.
    pub fn definition(statement: Statement, ours: impl Into<String>, holds: bool) -> Self {
        Self::judged(statement, ours, holds, Verdict::Definition)
    }

    /// A statement of the thesis that our result contradicts for a reason that is shown.
    pub fn contradiction(statement: Statement, ours: impl Into<String>, holds: bool) -> Self {
        Self::judged(statement, ours, holds, Verdict::CauseKnown)
    }

    /// A statement known to be wrong; `refuted` says whether our evidence against it holds.
    pub fn refutation(statement: Statement, ours: impl Into<String>, refuted: bool) -> Self {
        Self::judged(statement, ours, refuted, Verdict::ThesisInError)
    }

    /// A printed number known to be wrong. If ours agreed with it, it would not be an error.
    pub fn erratum(statement: Statement, printed: (&str, f64), (ours, right): (f64, f64)) -> Self {
        /// Rounding apart, ours must be the right value.
        const ROUNDING: f64 = 1e-9;
        let printed_is_wrong = (ours - printed.1).abs() > ROUNDING * right.abs();
        let ours_is_right = (ours - right).abs() <= ROUNDING * right.abs();
        Self {
            numbers: Numbers {
                thesis: Some(printed.1),
                ours: Some(ours),
                difference: Some((ours - printed.1).abs()),
                ..Numbers::default()
            },
            ..Self::refutation(statement, short(ours), printed_is_wrong && ours_is_right)
        }
        .printed(printed.0)
    }

    /// Something that the thesis gives too little for; the basis says what is missing.
    pub fn not_checkable(statement: Statement) -> Self {
        let verdict = Verdict::NotCheckable(statement.basis.clone());
        Self::new(statement, String::new(), verdict)
    }

    fn judged(
        statement: Statement,
        ours: impl Into<String>,
        holds: bool,
        verdict: impl Fn(String) -> Verdict,
    ) -> Self {
        let verdict = if holds {
            verdict(statement.basis.clone())
        } else {
            Verdict::Failed
        };
        Self::new(statement, ours.into(), verdict)
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

    /// With the distance of two random numbers and their deviations: the standard error of ours, the mean of
    /// `samples` runs, and the thesis'. Below two of both combined a difference is undecided; of less than
    /// [`ENOUGH_SAMPLES`] runs it is called underpowered.
    pub fn apart(self, difference: f64, sigma: [f64; 2], samples: u64) -> Self {
        let numbers = Numbers {
            difference: Some(difference.abs()),
            sigma: Some(sigma),
            samples: Some(samples),
            ..self.numbers
        };
        let verdict = match self.verdict {
            Verdict::Differs(text) if numbers.z().is_some_and(|z| z < DECISIVE) => {
                Verdict::Undecided(text)
            }
            verdict => verdict,
        };
        Self {
            numbers,
            verdict,
            ..self
        }
    }

    /// The distance in deviations for people; empty if neither number is random.
    fn z(&self) -> String {
        let few = self.numbers.samples.is_some_and(|n| n < ENOUGH_SAMPLES);
        let power = if few { ", underpowered" } else { "" };
        let z = self.numbers.z().map(|z| format!("{z:.1}{power}"));
        z.unwrap_or_default()
    }

    /// One row of the comparison table, with its name for links.
    pub(super) fn row(&self, id: &str) -> String {
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
        let difference = self.numbers.difference.map(brief).unwrap_or_default();
        let ours = match self.uncertainty.as_str() {
            "" => or_dash(&self.ours),
            uncertainty => {
                let (ours, uncertainty) = (inline(&self.ours), inline(uncertainty));
                format!("{ours} <span class=\"place\">{uncertainty}</span>")
            }
        };
        let z = match self.z().as_str() {
            "" => String::new(),
            z => format!(" <span class=\"place\">z = {}</span>", inline(z)),
        };
        format!(
            "<tr id=\"{id}\"><td>{place}{} <a class=\"id\" href=\"#{id}\">{}</a></td><td>{}</td><td>{ours}</td><td>{}{z}</td><td>{}</td></tr>\n",
            inline(&self.statement),
            escape(&self.id),
            or_dash(&self.thesis),
            or_dash(&difference),
            self.verdict_cell()
        )
    }

    fn verdict_cell(&self) -> String {
        let (class, name) = (CLASSES[self.verdict.kind()], escape(self.verdict.name()));
        let word = format!("<span class=\"verdict {class}\">{name}</span>");
        format!("{word}<br>{}", inline(&self.verdict.evidence()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_changed_number_changes_the_verdict() {
        let verdict = |ours: f64| {
            Claim::compared(
                Statement::parse("(4.6.1): E₀ — the level is open"),
                ("54 %", 0.54),
                (short(ours), ours),
                Allowance::StatedError(0.02, "section 4.6.1".into()),
                MismatchMeaning::Known(0.65..=0.69),
            )
            .verdict
        };
        assert!(matches!(verdict(0.55), Verdict::Reproduced(_)));
        assert_eq!(verdict(0.67), Verdict::Differs("the level is open".into()));
        for strange in [0.60, 0.75, f64::NAN] {
            assert_eq!(verdict(strange), Verdict::Failed);
        }
    }

    #[test]
    fn two_random_numbers_are_compared_in_their_combined_deviation() {
        let z = |samples| {
            let statement = Statement::parse("(1): a — order");
            Claim::trend(statement, "", true)
                .apart(-10.0, [3.0, 4.0], samples)
                .z()
        };
        assert_eq!([z(5), z(4)], ["2.0", "2.0, underpowered"]);
        let verdict = |sigma| {
            let known = MismatchMeaning::Known(5.0..=7.0);
            let (statement, allowance) =
                (Statement::parse("(1): a — open"), Allowance::Digits(0.5));
            Claim::compared(statement, ("3", 3.0), ("6".into(), 6.0), allowance, known)
                .apart(3.0, [sigma, 0.0], 5)
                .verdict
        };
        assert_eq!(verdict(1.6), Verdict::Undecided("open".into()));
        assert_eq!(verdict(1.4), Verdict::Differs("open".into()));
    }

    #[test]
    fn an_erratum_is_one_only_while_ours_is_right_and_the_printed_number_is_not() {
        let verdict = |printed: f64, ours: f64| {
            let statement = Statement::parse("(A.6): integral — it is 2");
            Claim::erratum(statement, ("π", printed), (ours, 2.0)).verdict
        };
        assert_eq!(verdict(3.0, 2.0), Verdict::ThesisInError("it is 2".into()));
        assert_eq!(verdict(2.0, 2.0), Verdict::Failed);
        assert_eq!(verdict(3.0, 2.1), Verdict::Failed);
    }
}
