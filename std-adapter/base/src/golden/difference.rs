//! Differences between a run and its pinned results, as readable messages.

use super::quantity::Quantity;
use std::fmt;

/// Result of comparing a run with its pinned results.
#[derive(Clone, Debug, PartialEq)]
pub enum Verdict {
    /// The results have the same bits.
    Same,
    /// The parameters differ, so results cannot be compared; the text names the first difference.
    SceneChanged(String),
    /// The scene is the same and the results differ.
    Differs(Difference),
}

/// The first differences.
///
/// ```
/// use tribos::golden::{Difference, Pinned, SeriesDifference, SummaryDifference, Verdict, measure};
/// # use tribos::scene::Scene;
/// # let text = "body = \"curling\"\nmodel = \"dry\"\nspeed = 2\nspin = 1.5";
/// let mut run = measure(&Scene::parse("rock.toml", text, &[])?, || ())?;
/// let pinned = Pinned::new("rock.toml".into(), vec![], &run);
/// run.rows[9][1] = run.rows[9][1].next_up(); // the last bit of a place
/// let lost = run.summary.pop();
/// let Verdict::Differs(found) = pinned.compare(&run) else { unreachable!() };
/// let Difference { series, summary, count, .. } = found;
/// assert!(matches!(series, Some(SeriesDifference::Block { column, .. }) if column == "x"));
/// let (name, was) = lost.ok_or("no summary")?;
/// assert_eq!(summary, Some(SummaryDifference { name, is: None, was: Some(was) }));
/// assert_eq!(count, 2);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Difference {
    /// Earliest difference in the series.
    pub series: Option<SeriesDifference>,
    /// First difference in the summary.
    pub summary: Option<SummaryDifference>,
    /// First part of the final state that differs.
    pub state: Option<String>,
    /// Number of columns, quantities and parts of the state that differ.
    pub count: usize,
}

/// A difference of the series.
#[derive(Clone, Debug, PartialEq)]
pub enum SeriesDifference {
    /// A pinned column that the run does not have.
    Missing(String),
    /// A column of the run that is not pinned.
    New(String),
    /// A block of rows.
    Block {
        /// Name of the column.
        column: String,
        /// First and last row, from 0.
        rows: [usize; 2],
        /// Times of these rows in the run.
        times: [f64; 2],
        /// Number of rows in the run, and pinned.
        lengths: [usize; 2],
    },
}

/// A difference of the summary.
#[derive(Clone, Debug, PartialEq)]
pub struct SummaryDifference {
    /// Name of the quantity.
    pub name: String,
    /// Its value in the run, if it has one.
    pub is: Option<Quantity>,
    /// Its pinned value, if it has one.
    pub was: Option<Quantity>,
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let series = self.series.iter().map(ToString::to_string);
        let summary = self.summary.iter().map(ToString::to_string);
        let state = self
            .state
            .iter()
            .map(|name| format!("final state: {name} differ"));
        let told: Vec<String> = series.chain(summary).chain(state).collect();
        f.write_str(&told.join("; "))?;
        match self.count.saturating_sub(told.len()) {
            0 => Ok(()),
            others => write!(f, "; and {others} more"),
        }
    }
}

impl fmt::Display for SeriesDifference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Missing(name) => write!(f, "series column \"{name}\" is missing"),
            Self::New(name) => write!(f, "series column \"{name}\" is not pinned"),
            Self::Block {
                column,
                rows: [from, to],
                times: [start, end],
                lengths: [is, was],
            } => {
                write!(
                    f,
                    "series column \"{column}\" differs first in rows {from}..{to} \
                     (time {start:.4} to {end:.4})"
                )?;
                if is != was {
                    write!(f, "; series has {is} rows, pinned {was}")?;
                }
                Ok(())
            }
        }
    }
}

impl fmt::Display for SummaryDifference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let name = &self.name;
        match (&self.is, &self.was) {
            (Some(is), Some(was)) => write!(f, "summary \"{name}\" is {is}, pinned {was}"),
            (Some(is), None) => write!(f, "summary \"{name}\" is {is} and is not pinned"),
            (None, Some(was)) => write!(f, "summary \"{name}\" is missing, pinned {was}"),
            (None, None) => write!(f, "summary \"{name}\""),
        }
    }
}
