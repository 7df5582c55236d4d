//! Columns as a Parquet file: one row group, plain encoding, no compression.

use super::frame::{Cells, Column};
use parquet::basic::{LogicalType, Repetition, Type as Physical};
use parquet::data_type::{BoolType, ByteArray, ByteArrayType, DataType, DoubleType, Int64Type};
use parquet::errors::Result;
use parquet::file::properties::WriterProperties;
use parquet::file::writer::{SerializedColumnWriter, SerializedFileWriter};
use parquet::schema::types::Type;
use std::sync::Arc;

/// The file's bytes; the same columns give the same bytes.
pub fn bytes(columns: &[Column]) -> Result<Vec<u8>> {
    let columns: Vec<Column> = columns.iter().map(typed).collect();
    let fields = columns.iter().map(field).collect::<Result<_>>()?;
    let schema = Type::group_type_builder("schema").with_fields(fields);
    let properties = WriterProperties::builder()
        .set_created_by(format!("tribos {}", env!("CARGO_PKG_VERSION")))
        .set_dictionary_enabled(false)
        .build();
    let (schema, properties) = (Arc::new(schema.build()?), Arc::new(properties));
    let mut file = SerializedFileWriter::new(Vec::new(), schema, properties)?;
    let mut rows = file.next_row_group()?;
    for column in &columns {
        if let Some(mut writer) = rows.next_column()? {
            write(&column.cells, &mut writer)?;
            writer.close()?;
        }
    }
    rows.close()?;
    file.into_inner()
}

/// Given values are numbers if all of them are, else texts.
fn typed(column: &Column) -> Column {
    let cells = match &column.cells {
        Cells::Given(texts) => {
            let numbers: Option<Vec<_>> = texts
                .iter()
                .map(|text| text.parse().ok().map(Some))
                .collect();
            let words = || texts.iter().cloned().map(Some).collect();
            numbers.map_or_else(|| Cells::Words(words()), Cells::Numbers)
        }
        other => other.clone(),
    };
    let name = column.name.clone();
    Column { name, cells }
}

/// Every column may have gaps.
fn field(column: &Column) -> Result<Arc<Type>> {
    let (physical, logical) = match column.cells {
        Cells::Integers(_) => (Physical::INT64, None),
        Cells::Numbers(_) => (Physical::DOUBLE, None),
        Cells::Flags(_) => (Physical::BOOLEAN, None),
        Cells::Words(_) | Cells::Given(_) => (Physical::BYTE_ARRAY, Some(LogicalType::String)),
    };
    let field = Type::primitive_type_builder(&column.name, physical)
        .with_logical_type(logical)
        .with_repetition(Repetition::OPTIONAL);
    Ok(Arc::new(field.build()?))
}

fn write(cells: &Cells, writer: &mut SerializedColumnWriter<'_>) -> Result<()> {
    match cells {
        Cells::Integers(cells) => present::<Int64Type>(cells.clone(), writer),
        Cells::Numbers(cells) => present::<DoubleType>(cells.clone(), writer),
        Cells::Flags(cells) => present::<BoolType>(cells.clone(), writer),
        Cells::Words(cells) => {
            let word = |cell: &Option<String>| cell.as_deref().map(ByteArray::from);
            present::<ByteArrayType>(cells.iter().map(word).collect(), writer)
        }
        Cells::Given(cells) => {
            let word = |cell: &String| Some(ByteArray::from(cell.as_str()));
            present::<ByteArrayType>(cells.iter().map(word).collect(), writer)
        }
    }
}

/// Values that are there, and a level for each row that tells whether it has one.
fn present<T: DataType>(
    cells: Vec<Option<T::T>>,
    writer: &mut SerializedColumnWriter<'_>,
) -> Result<()> {
    let levels: Vec<i16> = cells.iter().map(|cell| i16::from(cell.is_some())).collect();
    let values: Vec<T::T> = cells.into_iter().flatten().collect();
    writer
        .typed::<T>()
        .write_batch(&values, Some(&levels), None)?;
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use parquet::file::reader::{FileReader, SerializedFileReader};
    use parquet::record::Field;

    #[test]
    fn numbers_read_back_to_the_same_bits() -> Result<()> {
        let numbers = [
            0.1,
            -0.0,
            f64::NAN,
            f64::INFINITY,
            5e-324,
            f64::MAX,
            -1.0 / 3.0,
        ];
        let mut cells: Vec<Option<f64>> = numbers.map(Some).to_vec();
        cells.push(None);
        let columns = [
            Column {
                name: "x".into(),
                cells: Cells::Numbers(cells.clone()),
            },
            Column::integers("n", (0..8).map(|n| i64::MAX - n)),
            Column::given("w", (0..8).map(|n| format!("ü{n}")).collect()),
            Column::given("k", (0..8).map(|n| format!("{n}e-1")).collect()),
        ];
        let bytes = bytes(&columns)?;
        assert_eq!(bytes, super::bytes(&columns)?);
        let reader = SerializedFileReader::new(bytes::Bytes::from(bytes))?;
        for (index, row) in reader.get_row_iter(None)?.enumerate() {
            let row: Vec<Field> = row?
                .into_columns()
                .into_iter()
                .map(|(_, field)| field)
                .collect();
            let bits = match row[0] {
                Field::Double(x) => Some(x.to_bits()),
                _ => None,
            };
            assert_eq!(bits, cells[index].map(f64::to_bits));
            assert_eq!(row[1], Field::Long(i64::MAX - index as i64));
            assert_eq!(row[2], Field::Str(format!("ü{index}")));
            assert_eq!(row[3], Field::Double(index as f64 / 10.0));
        }
        Ok(())
    }
}
