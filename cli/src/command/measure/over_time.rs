//! Means over time of the columns of a run's series.

use crate::command::digits::{shown, with_error};
use crate::failure::Failure;
use serde_json::{Map, Value};
use std::path::Path;
use tribos::grains::{COLUMNS, averages};
use tribos::record::{number, read_text};
use tribos::results::{Recorded, is_averaged};
use tribos::statistics::{Averages, TimeAverage};

/// Bytes of a series at most: a million lines have some 500 MB.
const MOST_BYTES: u64 = 1 << 30;

/// Means of the columns of a series, without the time and the number of steps.
pub struct MeansOverTime(Vec<(String, TimeAverage)>);

impl MeansOverTime {
    /// Reads the series of a run; none of a file, or of a folder without one. The time from which on means are taken is
    /// what was asked for, or that of the scene.
    pub fn read(
        source: &Path,
        asked: Option<f64>,
        of_scene: Option<f64>,
    ) -> Result<Option<Self>, Failure> {
        let file = source.join("series.csv");
        if !file.is_file() {
            return match asked {
                Some(_) => Err(Failure::input(format!(
                    "--average-from has no effect: {} has no series over time",
                    source.display()
                ))),
                None => Ok(None),
            };
        }
        let refused = |reason: String| Failure::input(format!("{}{reason}", file.display()));
        let text = read_text(&file, MOST_BYTES).map_err(|error| refused(format!(": {error}")))?;
        let mut lines = text.lines();
        let names: Vec<&str> = lines.next().unwrap_or_default().split(',').collect();
        if names[0] != "time" {
            let reason = format!(":1: the first column is `{}`, not `time`", names[0]);
            return Err(refused(reason));
        }
        let mut columns = vec![Vec::new(); names.len()];
        for (at, line) in lines.enumerate() {
            let cells: Result<Vec<f64>, _> = line.split(',').map(str::parse).collect();
            let cells = cells
                .ok()
                .filter(|cells| cells.len() == names.len())
                .ok_or_else(|| {
                    refused(format!(
                        ":{}: not {} numbers; run the scene again",
                        at + 2,
                        names.len()
                    ))
                })?;
            for (column, cell) in columns.iter_mut().zip(cells) {
                column.push(cell);
            }
        }
        let Some((times, values)) = columns.split_first() else {
            return Ok(None);
        };
        if let Some(from) = asked.filter(|from| times.last().is_none_or(|end| from >= end)) {
            let end = shown(times.last().copied().unwrap_or(0.0));
            let message = format!("--average-from {}: the run ends at {end}", shown(from));
            return Err(Failure::input(message));
        }
        let from = asked.or(of_scene);
        if names == COLUMNS {
            let row = |at: usize| std::array::from_fn(|column| columns[column][at]);
            let rows: Vec<[f64; COLUMNS.len()]> = (0..times.len()).map(row).collect();
            let Averages(all) = averages(&rows, from);
            return Ok(Some(Self(
                all.into_iter()
                    .map(|(name, mean)| (name.into(), mean))
                    .collect(),
            )));
        }
        let averaged = names
            .iter()
            .skip(1)
            .zip(values)
            .filter(|(name, _)| is_averaged(name));
        let mean = |(name, values): (&&str, &Vec<f64>)| {
            (String::from(*name), TimeAverage::of(times, values, from))
        };
        Ok(Some(Self(averaged.map(mean).collect())))
    }

    /// Every mean by the name of its column.
    pub fn json(&self) -> Value {
        let entry = |(name, mean): &(String, TimeAverage)| Some((name.clone(), mean.recorded()?));
        Value::Object(self.0.iter().filter_map(entry).collect::<Map<_, _>>())
    }

    /// The means as a table.
    pub fn csv(&self) -> String {
        let mut text = String::from("column,mean,error,from,effective,settled\n");
        for (name, found) in &self.0 {
            let numbers = [found.mean, found.error, found.from, found.effective].map(number);
            text += &format!("{name},{},{}\n", numbers.join(","), found.settled);
        }
        text
    }

    /// The means of columns that are not always 0, for people.
    pub fn text(&self) -> String {
        let shown_ones = self
            .0
            .iter()
            .filter(|(_, found)| found.mean != 0.0 || found.error != 0.0);
        let rows: Vec<[String; 4]> = shown_ones
            .map(|(name, found)| {
                let value = with_error(found.mean, found.error);
                let effective = format!("{:.0}", found.effective);
                let note = if found.settled { "" } else { "  not settled" };
                [name.clone(), value, shown(found.from), effective + note]
            })
            .collect();
        let mut text = format!(
            "over time     {:<20}  {:>24}  {:>10}  independent lines\n",
            "column", "mean and its error", "from"
        );
        for [name, value, from, effective] in rows {
            text += &format!("              {name:<20}  {value:>24}  {from:>10}  {effective}\n");
        }
        text
    }
}
