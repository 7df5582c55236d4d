//! Named columns of one length: what tables are written from.

use serde_json::Value;
use tribos::record::number;

/// Values of a column; `None` where a row has none.
#[derive(Clone, Debug, PartialEq)]
pub enum Cells {
    /// Whole numbers.
    Integers(Vec<Option<i64>>),
    /// Numbers.
    Numbers(Vec<Option<f64>>),
    /// Truth values.
    Flags(Vec<Option<bool>>),
    /// Texts.
    Words(Vec<Option<String>>),
    /// Values of a key as they were given.
    Given(Vec<String>),
}

/// A column.
#[derive(Clone, Debug, PartialEq)]
pub struct Column {
    /// Its head.
    pub name: String,
    /// Its values.
    pub cells: Cells,
}

/// A number of a summary; infinities and NaN stand there as texts.
pub fn scalar(value: &Value) -> Option<f64> {
    match value {
        Value::Number(number) => number.as_f64(),
        Value::String(text) => match text.as_str() {
            "inf" => Some(f64::INFINITY),
            "-inf" => Some(f64::NEG_INFINITY),
            "nan" => Some(f64::NAN),
            _ => None,
        },
        _ => None,
    }
}

impl Column {
    /// Values of summaries, in the narrowest type that holds all of them.
    pub fn of(name: &str, values: &[Option<&Value>]) -> Self {
        let values: Vec<Option<&Value>> = values
            .iter()
            .map(|value| value.filter(|value| !value.is_null()))
            .collect();
        let cells = Self::all(&values, Value::as_i64)
            .filter(|_| values.iter().any(Option::is_some))
            .map(Cells::Integers)
            .or_else(|| Self::all(&values, scalar).map(Cells::Numbers))
            .or_else(|| Self::all(&values, Value::as_bool).map(Cells::Flags))
            .unwrap_or_else(|| {
                let word = |value: &Value| value.as_str().map_or(value.to_string(), str::to_owned);
                Cells::Words(values.iter().map(|value| value.map(word)).collect())
            });
        let name = name.to_owned();
        Self { name, cells }
    }

    /// Values of a key.
    pub fn given(name: &str, texts: Vec<String>) -> Self {
        let name = name.to_owned();
        let cells = Cells::Given(texts);
        Self { name, cells }
    }

    /// Whole numbers without a gap.
    pub fn integers(name: &str, integers: impl Iterator<Item = i64>) -> Self {
        let name = name.to_owned();
        let cells = Cells::Integers(integers.map(Some).collect());
        Self { name, cells }
    }

    /// Numbers without a gap.
    pub fn numbers(name: &str, numbers: impl Iterator<Item = f64>) -> Self {
        let name = name.to_owned();
        let cells = Cells::Numbers(numbers.map(Some).collect());
        Self { name, cells }
    }

    /// `take` of every value that is there, unless one of them is of another type.
    fn all<T>(
        values: &[Option<&Value>],
        take: impl Fn(&Value) -> Option<T>,
    ) -> Option<Vec<Option<T>>> {
        let taken = values.iter().map(|value| match value {
            Some(value) => take(value).map(Some),
            None => Some(None),
        });
        taken.collect()
    }

    /// A value as text, numbers in the shortest form that keeps the bits; empty if there is none.
    fn text(&self, row: usize) -> String {
        let text = match &self.cells {
            Cells::Integers(cells) => cells[row].map(|cell| cell.to_string()),
            Cells::Numbers(cells) => cells[row].map(number),
            Cells::Flags(cells) => cells[row].map(|cell| cell.to_string()),
            Cells::Words(cells) => cells[row].clone(),
            Cells::Given(cells) => Some(cells[row].clone()),
        };
        text.unwrap_or_default()
    }

    /// Number of rows.
    pub fn len(&self) -> usize {
        match &self.cells {
            Cells::Integers(cells) => cells.len(),
            Cells::Numbers(cells) => cells.len(),
            Cells::Flags(cells) => cells.len(),
            Cells::Words(cells) => cells.len(),
            Cells::Given(cells) => cells.len(),
        }
    }
}

/// Adds a column of results. A key of the scene may be called as a result is, or as another with
/// `_result` behind: no two columns have one name.
pub fn add(columns: &mut Vec<Column>, mut column: Column) {
    while columns.iter().any(|other| other.name == column.name) {
        column.name += "_result";
    }
    columns.push(column);
}

/// The columns as CSV.
pub fn csv(columns: &[Column]) -> Result<Vec<u8>, csv::Error> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(columns.iter().map(|column| &column.name))?;
    for row in 0..columns.first().map_or(0, Column::len) {
        writer.write_record(columns.iter().map(|column| column.text(row)))?;
    }
    writer
        .into_inner()
        .map_err(|error| csv::Error::from(error.into_error()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn a_column_takes_the_narrowest_type() {
        let cases = [
            (
                json!([1, null, 3]),
                Cells::Integers(vec![Some(1), None, Some(3)]),
            ),
            (
                json!([1, 2.5, "inf"]),
                Cells::Numbers(vec![Some(1.0), Some(2.5), Some(f64::INFINITY)]),
            ),
            (json!([true, null]), Cells::Flags(vec![Some(true), None])),
            (
                json!(["a", 1]),
                Cells::Words(vec![Some("a".into()), Some("1".into())]),
            ),
            (json!([null]), Cells::Numbers(vec![None])),
        ];
        for (values, cells) in cases {
            let values: Vec<Option<&Value>> =
                values.as_array().into_iter().flatten().map(Some).collect();
            assert_eq!(Column::of("x", &values).cells, cells);
        }
        let words = vec!["1".to_owned(), "a,\"b\"".to_owned()];
        let text = csv(&[Column::given("k", words)]).ok();
        assert_eq!(text.as_deref(), Some(&b"k\n1\n\"a,\"\"b\"\"\"\n"[..]));
    }
}
