//! The pinned results of one scene, and their comparison with a new run.

use super::difference::{Difference, SeriesDifference, SummaryDifference, Verdict};
use super::measure::Measurement;
use super::quantity::{Quantity, digest};
use crate::scene::key::present_name;
use std::collections::BTreeMap;

/// Values by the keys of a scene.
type Parameters = BTreeMap<String, Quantity>;

/// Number of blocks of rows per column, each with a digest.
const BLOCKS: usize = 16;

/// One scene with its results.
///
/// ```
/// use tribos::golden::{Pinned, Verdict, measure};
/// # use tribos::scene::Scene;
/// # let text = "body = \"curling\"\nmodel = \"dry\"\nspeed = 2\nspin = 1.5";
/// let run = measure(&Scene::parse("rock.toml", text, &[])?, || ())?;
/// let pinned = Pinned::new("rock.toml".into(), vec![], &run);
/// assert_eq!(pinned.rows(), run.rows.len());
/// let counts = [run.columns.len(), run.summary.len(), 0]; // a slide has no state but its path
/// assert_eq!(pinned.results(), counts);
/// // On a lighter rock the same results would mean nothing.
/// let set = vec!["mass=19".into()];
/// let lighter = measure(&Scene::parse("rock.toml", text, &set)?, || ())?;
/// assert!(matches!(pinned.compare(&lighter), Verdict::SceneChanged(_)));
/// let other = Pinned::new("rock.toml".into(), set, &lighter);
/// assert_ne!(other.scene_digest(), pinned.scene_digest());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Pinned {
    /// The scene file, relative to the folder of the golden file, or absolute.
    pub path: String,
    /// Overrides of the form `key=value`.
    pub overrides: Vec<String>,
    /// Resolved parameters.
    pub(super) parameters: Parameters,
    /// Quantities of the summary.
    pub(super) summary: BTreeMap<String, Quantity>,
    /// Lines of the series.
    pub(super) rows: usize,
    /// Lines in a block, except the last one.
    pub(super) block_rows: usize,
    /// Digests of the blocks of each column.
    pub(super) columns: BTreeMap<String, Vec<u64>>,
    /// Digests of the final state.
    pub(super) state: BTreeMap<String, u64>,
}

impl Pinned {
    /// Pins a measurement.
    pub fn new(path: String, overrides: Vec<String>, measured: &Measurement) -> Self {
        let block_rows = measured.rows.len().div_ceil(BLOCKS).max(1);
        let columns = measured.columns.iter().enumerate();
        let state = measured.state.iter();
        Self {
            path,
            overrides,
            parameters: measured.parameters.clone(),
            summary: measured.summary.iter().cloned().collect(),
            rows: measured.rows.len(),
            block_rows,
            columns: columns
                .map(|(index, name)| (name.clone(), measured.blocks(index, block_rows)))
                .collect(),
            state: state.map(|(name, bits)| ((*name).into(), *bits)).collect(),
        }
    }

    /// Digest of the resolved parameters, which distinguishes a changed scene from changed results.
    pub fn scene_digest(&self) -> u64 {
        digest(&self.parameters)
    }

    /// Number of results: columns, quantities of the summary, digests of the state.
    pub fn results(&self) -> [usize; 3] {
        [self.columns.len(), self.summary.len(), self.state.len()]
    }

    /// Lines of the series.
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// Compares a new run with the pinned results.
    pub fn compare(&self, measured: &Measurement) -> Verdict {
        let named = |(name, value): (&String, &Quantity)| {
            (present_name(measured.keys, name).into(), value.clone())
        };
        let mut parameters: Parameters = self.parameters.iter().map(named).collect();
        // A key that came later and has its default says nothing new.
        for (name, default) in &measured.defaults {
            if measured.parameters.get(name) == Some(default) {
                parameters
                    .entry(name.clone())
                    .or_insert_with(|| default.clone());
            }
        }
        if digest(&parameters) != digest(&measured.parameters) {
            return Verdict::SceneChanged(changed_parameter(&parameters, &measured.parameters));
        }
        let (series, columns) = self.series_difference(measured);
        let (summary, quantities) = self.summary_difference(measured);
        let state: Vec<String> = self.state_differences(measured);
        let count = columns + quantities + state.len();
        if count == 0 && series.is_none() {
            return Verdict::Same;
        }
        Verdict::Differs(Difference {
            series,
            summary,
            state: state.into_iter().next(),
            count,
        })
    }

    /// The earliest difference of the series, and the number of columns that differ.
    fn series_difference(&self, measured: &Measurement) -> (Option<SeriesDifference>, usize) {
        let known = |name: &String| measured.columns.contains(name);
        if let Some(name) = self.columns.keys().find(|name| !known(name)) {
            return (Some(SeriesDifference::Missing(name.clone())), 1);
        }
        let mut first: Option<(usize, usize)> = None;
        let mut count = 0;
        for (index, name) in measured.columns.iter().enumerate() {
            let Some(pinned) = self.columns.get(name) else {
                return (Some(SeriesDifference::New(name.clone())), 1);
            };
            let blocks = measured.blocks(index, self.block_rows);
            let longest = blocks.len().max(pinned.len());
            let differs = |block: &usize| blocks.get(*block) != pinned.get(*block);
            if let Some(block) = (0..longest).find(differs) {
                count += 1;
                if first.is_none_or(|(earliest, _)| block < earliest) {
                    first = Some((block, index));
                }
            }
        }
        let series = first.map(|(block, index)| self.block(measured, block, index));
        (series, count)
    }

    /// A block of a column with its rows and times.
    fn block(&self, measured: &Measurement, block: usize, column: usize) -> SeriesDifference {
        let from = block.saturating_mul(self.block_rows);
        let rows = measured.rows.len();
        let to = from
            .saturating_add(self.block_rows)
            .min(rows.max(self.rows))
            - 1;
        let time = |row: usize| measured.rows.get(row.min(rows - 1)).and_then(|r| r.first());
        SeriesDifference::Block {
            column: measured.columns[column].clone(),
            rows: [from, to],
            times: [from, to].map(|row| match rows {
                0 => f64::NAN,
                _ => time(row).copied().unwrap_or(f64::NAN),
            }),
            lengths: [rows, self.rows],
        }
    }

    /// The first quantity of the summary that differs, and how many do.
    fn summary_difference(&self, measured: &Measurement) -> (Option<SummaryDifference>, usize) {
        let of_run = measured.summary.iter().map(|(name, is)| {
            let (is, was) = (Some(is.clone()), self.summary.get(name).cloned());
            (name, is, was)
        });
        let known = |name: &str| measured.summary.iter().any(|(known, _)| known == name);
        let gone = self.summary.iter().filter(|(name, _)| !known(name));
        let gone = gone.map(|(name, was)| (name, None, Some(was.clone())));
        let mut all = of_run.chain(gone).filter(|(_, is, was)| is != was);
        let first = all.next().map(|(name, is, was)| SummaryDifference {
            name: name.clone(),
            is,
            was,
        });
        let count = usize::from(first.is_some()) + all.count();
        (first, count)
    }

    /// Parts of the final state that differ.
    fn state_differences(&self, measured: &Measurement) -> Vec<String> {
        let now: BTreeMap<&str, u64> = measured.state.iter().copied().collect();
        let mut names: Vec<&str> = now.keys().copied().collect();
        names.extend(self.state.keys().map(String::as_str));
        names.sort_unstable();
        names.dedup();
        let differs = |name: &&str| now.get(name) != self.state.get(*name);
        names
            .into_iter()
            .filter(differs)
            .map(str::to_owned)
            .collect()
    }
}

/// The first parameter that differs, in words.
fn changed_parameter(was: &Parameters, is: &Parameters) -> String {
    let mut names: Vec<&String> = was.keys().chain(is.keys()).collect();
    names.sort();
    let changed = names
        .into_iter()
        .find(|name| was.get(*name) != is.get(*name));
    let Some(name) = changed else {
        return "its parameters".into();
    };
    match (is.get(name), was.get(name)) {
        (Some(is), Some(was)) => format!("`{name}` is {is}, pinned {was}"),
        (Some(is), None) => format!("`{name}` is {is}, and was unknown when it was pinned"),
        (None, Some(was)) => format!("`{name}` is unknown, pinned {was}"),
        (None, None) => format!("`{name}`"),
    }
}
