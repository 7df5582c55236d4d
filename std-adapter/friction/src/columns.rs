//! Files of numbers with named columns: triangles and points of patches.

use super::FrictionError;
use super::refusal::finite_number;
use std::path::Path;

/// The rows of a CSV file that has just these columns, in any order: at least one.
pub(super) fn read<const N: usize>(
    path: &Path,
    columns: [&str; N],
    most: usize,
) -> Result<Vec<[f64; N]>, FrictionError> {
    let text = super::text::read_text(path, MOST_BYTES)
        .map_err(|error| FrictionError::Syntax(format!("{}: {error}", path.display())))?;
    parsed(path, &text, columns, most)
}

/// Most bytes of a file.
const MOST_BYTES: u64 = 1 << 27;

fn parsed<const N: usize>(
    path: &Path,
    text: &str,
    columns: [&str; N],
    most: usize,
) -> Result<Vec<[f64; N]>, FrictionError> {
    let refused = |line: usize, reason: &str| {
        FrictionError::Syntax(format!("{}:{}: {reason}", path.display(), line + 1))
    };
    let wanted = columns.join(",");
    let rows = text.lines().enumerate();
    let mut rows = rows.filter(|(_, line)| !line.trim().is_empty() && !line.starts_with('#'));
    let (first, header) = rows
        .next()
        .ok_or_else(|| refused(0, &format!("the file is empty; give columns {wanted}")))?;
    let names: Vec<&str> = header.split(',').map(str::trim).collect();
    let mut places = [0; N];
    for (place, name) in places.iter_mut().zip(columns) {
        match names.iter().position(|known| *known == name) {
            Some(at) if names.len() == N => *place = at,
            _ => return Err(refused(first, &format!("the columns must be {wanted}"))),
        }
    }
    let mut all = Vec::new();
    for (number, row) in rows {
        let fields: Vec<&str> = row.split(',').map(str::trim).collect();
        if fields.len() != N {
            let reason = format!("{} values where there are {N} columns", fields.len());
            return Err(refused(number, &reason));
        }
        let mut values = [0.0; N];
        for ((value, place), name) in values.iter_mut().zip(places).zip(columns) {
            *value = finite_number(fields[place])
                .map_err(|error| refused(number, &format!("{name}: {error}")))?;
        }
        all.push(values);
        if all.len() > most {
            return Err(refused(number, &format!("more than {most} rows")));
        }
    }
    if all.is_empty() {
        return Err(refused(first, "there are no rows; give at least one"));
    }
    Ok(all)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_come_in_any_order_and_faults_are_named_by_line() {
        let read = |text: &str| {
            let rows = parsed(Path::new("feet.csv"), text, ["x", "y"], 2);
            rows.map_err(|refusal| refusal.to_string())
        };
        assert_eq!(read("# m\ny,x\n1, 2\n"), Ok(vec![[2.0, 1.0]]));
        for (text, reason) in [
            ("", "feet.csv:1: the file is empty; give columns x,y"),
            ("x,z\n1,2", "feet.csv:1: the columns must be x,y"),
            ("x,y,y\n1,2,3", "feet.csv:1: the columns must be x,y"),
            (
                "x,y\n1,2\n3",
                "feet.csv:3: 1 values where there are 2 columns",
            ),
            ("x,y\n1,inf", "feet.csv:2: y: give a finite number, not inf"),
            ("x,y\n", "feet.csv:1: there are no rows; give at least one"),
            ("x,y\n1,2\n1,2\n1,2\n", "feet.csv:4: more than 2 rows"),
        ] {
            assert_eq!(read(text), Err(reason.to_owned()), "{text:?}");
        }
    }
}
