//! Verdicts on statements of the thesis, each with its evidence.

use super::digits::brief;
use serde::{Deserialize, Serialize};

/// A number as the thesis prints it, and its value.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PrintedNumber {
    text: String,
    value: f64,
}

impl PrintedNumber {
    /// Text as printed, with its unit, and the value in the unit of our number.
    pub fn new((text, value): (&str, f64)) -> Self {
        let text = text.into();
        Self { text, value }
    }

    /// As printed.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Its value.
    pub fn value(&self) -> f64 {
        self.value
    }
}

/// Allowed distance of a number from the thesis' own, with its reason.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub enum Allowance {
    /// The thesis gives an exact value or a closed form: our numerical error, absolute.
    Exact(f64),
    /// Half a unit of the last digit that the thesis prints.
    Digits(f64),
    /// An error that the thesis states, with the place of the statement.
    StatedError(f64, String),
    /// The thesis has one random sample: two standard deviations of single samples of ours.
    Scatter(f64),
}

impl Allowance {
    /// Largest difference allowed.
    pub fn size(&self) -> f64 {
        match self {
            Self::Exact(size)
            | Self::Digits(size)
            | Self::StatedError(size, _)
            | Self::Scatter(size) => *size,
        }
    }

    /// True for exact values and closed forms.
    pub fn is_exact(&self) -> bool {
        matches!(self, Self::Exact(_))
    }

    /// Description of the allowance's origin.
    pub fn words(&self) -> String {
        match self {
            Self::Exact(_) => "exact value, up to our numerical error".into(),
            Self::Digits(_) => "half a unit of the last printed digit".into(),
            Self::StatedError(_, place) => format!("error stated in {place}"),
            Self::Scatter(_) => {
                "scatter: two standard deviations of single samples, of which the thesis has one"
                    .into()
            }
        }
    }
}

/// A number of ours that lies within the allowance of the thesis'. Only [`Agreement::test`] makes one.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Agreement {
    thesis: f64,
    ours: f64,
    allowance: Allowance,
}

impl Agreement {
    /// Compares two numbers; NaN agrees with nothing.
    pub fn test(thesis: &PrintedNumber, ours: f64, allowance: Allowance) -> Option<Self> {
        let thesis = thesis.value;
        ((ours - thesis).abs() <= allowance.size()).then_some(Self {
            thesis,
            ours,
            allowance,
        })
    }

    /// The allowance.
    pub fn allowance(&self) -> &Allowance {
        &self.allowance
    }

    /// The thesis' number and ours.
    pub fn numbers(&self) -> [f64; 2] {
        [self.thesis, self.ours]
    }

    /// The same comparison with another number of ours.
    pub fn with(&self, ours: f64) -> Option<Self> {
        let thesis = PrintedNumber::new(("", self.thesis));
        Self::test(&thesis, ours, self.allowance.clone())
    }
}

/// Outcome of checking a claim.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub enum Verdict {
    /// A number that the thesis states, within the thesis' own error.
    Reproduced(Agreement),
    /// Sign, order, monotonicity or scaling as the thesis says; the text says which.
    Trend(String),
    /// Our own result, or a formula of the thesis, that agrees with what the text names.
    OursChecked(String),
    /// An input or a convention, which cannot fail; the text says of what.
    Definition(String),
    /// The results differ for a demonstrated reason, which the text gives.
    CauseKnown(String),
    /// Random numbers that are off by less than two of their deviations, yet by more than the allowance; the
    /// text says what is known.
    Undecided(String),
    /// The results differ as before; the text says what is known and what is not.
    Differs(String),
    /// The thesis is wrong; the text gives the correct result.
    ThesisInError(String),
    /// The thesis gives too little for a comparison; the text says what is missing.
    NotCheckable(String),
    /// The comparison failed, and nothing known explains it.
    Failed,
}

/// Classes of the kinds of verdict in pages.
pub const CLASSES: [&str; 10] = [
    "reproduced",
    "trend",
    "checked",
    "definition",
    "known",
    "undecided",
    "differs",
    "error",
    "unchecked",
    "failed",
];

/// Words of the kinds of verdict, in the order of the tables.
pub const KINDS: [&str; 10] = [
    "reproduced",
    "trend reproduced",
    "no number, checked",
    "definition",
    "differs, cause known",
    "undecided",
    "differs",
    "thesis in error",
    "not checkable",
    "failed",
];

impl Verdict {
    /// Index into [`KINDS`].
    pub fn kind(&self) -> usize {
        match self {
            Self::Reproduced(_) => 0,
            Self::Trend(_) => 1,
            Self::OursChecked(_) => 2,
            Self::Definition(_) => 3,
            Self::CauseKnown(_) => 4,
            Self::Undecided(_) => 5,
            Self::Differs(_) => 6,
            Self::ThesisInError(_) => 7,
            Self::NotCheckable(_) => 8,
            Self::Failed => 9,
        }
    }

    /// Name of the kind of verdict.
    pub fn name(&self) -> &'static str {
        KINDS[self.kind()]
    }

    /// Short description of the evidence.
    pub fn evidence(&self) -> String {
        match self {
            Self::Reproduced(agreement) => {
                let allowance = agreement.allowance();
                format!("± {}: {}", brief(allowance.size()), allowance.words())
            }
            Self::OursChecked(text) => format!("against {text}"),
            Self::Definition(text) => format!("follows from {text}"),
            Self::Trend(text)
            | Self::CauseKnown(text)
            | Self::Undecided(text)
            | Self::Differs(text)
            | Self::ThesisInError(text)
            | Self::NotCheckable(text) => text.clone(),
            Self::Failed => "no known reason".into(),
        }
    }
}

/// Number of claims for each verdict.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Counts(pub [usize; 10]);

impl Counts {
    /// Counts verdicts.
    pub fn of<'a>(verdicts: impl IntoIterator<Item = &'a Verdict>) -> Self {
        let mut counts = Self::default();
        for verdict in verdicts {
            counts.0[verdict.kind()] += 1;
        }
        counts
    }

    /// Those of two lists.
    pub fn plus(self, other: Self) -> Self {
        Self(std::array::from_fn(|kind| self.0[kind] + other.0[kind]))
    }

    /// All of them.
    pub fn total(&self) -> usize {
        self.0.iter().sum()
    }

    /// "5 reproduced; 1 thesis in error": the kinds that occur.
    pub fn words(&self) -> String {
        let occurring = self.0.iter().zip(KINDS).filter(|(count, _)| **count > 0);
        let words: Vec<String> = occurring
            .map(|(count, kind)| format!("{count} {kind}"))
            .collect();
        words.join("; ")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_a_number_within_its_allowance_agrees() {
        let thesis = PrintedNumber::new(("≈ 0.653", 0.653));
        let agrees = |ours| Agreement::test(&thesis, ours, Allowance::Digits(5e-4)).is_some();
        assert!(agrees(0.653) && agrees(0.653_499) && agrees(0.652_501));
        for other in [0.6536, 0.6524, f64::NAN, f64::INFINITY] {
            assert!(!agrees(other), "{other}");
        }
    }

    #[test]
    fn each_verdict_is_counted_under_its_words() {
        let verdicts = [
            Verdict::Failed,
            Verdict::Trend("order".into()),
            Verdict::Failed,
        ];
        let counts = Counts::of(&verdicts);
        assert_eq!(counts.words(), "1 trend reproduced; 2 failed");
        assert_eq!(counts.total(), 3);
    }
}
