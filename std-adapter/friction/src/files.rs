//! Files of patches: triangles, points, corners of polygons.

use super::FrictionError;
use std::path::Path;
use tribos_base::record::{Rows, TableError};

/// Most corners of a file: the check that no edges cross takes the square of their number.
const MOST_CORNERS: usize = 10_000;

/// The rows of a file that has just these columns.
pub(super) fn numbers<const N: usize>(
    path: &Path,
    columns: &'static [&'static str; N],
    most: usize,
) -> Result<Vec<[f64; N]>, FrictionError> {
    let rows = Rows::open(path, |_| columns);
    rows.and_then(|rows| rows.all(most)).map_err(refused)
}

/// The corners of a polygon and its holes.
pub(super) fn loops(path: &Path) -> Result<Vec<Vec<[f64; 2]>>, FrictionError> {
    let rows = Rows::open(path, corner_columns);
    rows.and_then(read_loops).map_err(refused)
}

fn refused(refusal: TableError) -> FrictionError {
    FrictionError::Syntax(refusal.to_string())
}

/// Columns of a file of corners, with or without loops.
fn corner_columns(header: &[&str]) -> &'static [&'static str] {
    match header.contains(&"loop") {
        true => &["x", "y", "loop"],
        false => &["x", "y"],
    }
}

/// The corners of a file with columns x, y and perhaps loop: the first loop is the outer one.
fn read_loops(mut rows: Rows<'_>) -> Result<Vec<Vec<[f64; 2]>>, TableError> {
    let mut order: Vec<String> = Vec::new();
    let mut loops: Vec<Vec<[f64; 2]>> = Vec::new();
    let (mut count, mut corner) = (0, [0.0; 2]);
    while rows.next(&mut corner)?.is_some() {
        let name = rows.words().concat();
        match order.iter().position(|known| *known == name) {
            Some(last) if last + 1 == order.len() => loops[last].push(corner),
            Some(_) => {
                let reason = format!("the corners of loop {name} must follow each other");
                return Err(rows.refusal(&reason));
            }
            None => {
                order.push(name);
                loops.push(vec![corner]);
            }
        }
        count += 1;
        if count > MOST_CORNERS {
            return Err(rows.refusal(&format!("more than {MOST_CORNERS} corners")));
        }
    }
    Ok(loops)
}

#[cfg(test)]
mod tests {
    use super::*;
    use tribos_base::record::OtherColumns;

    #[test]
    fn corners_and_holes_are_read_and_faults_named_by_line() {
        let read = |text: &str| {
            let (name, others) = (Path::new("sole.csv"), OtherColumns::Refused);
            let rows = Rows::of(name, text.as_bytes(), others, corner_columns);
            let loops = rows.and_then(read_loops);
            loops.map_err(|refusal| refusal.to_string())
        };
        let plain = read("# a triangle\nx,y\n0,0\n1,0\n0,1\n");
        assert_eq!(plain, Ok(vec![vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]]));
        let holed = read("loop,y,x\no,0,0\no,0,4\no,4,0\nh,1,1\nh,1,2\nh,2,1\n");
        assert_eq!(
            holed.map(|loops| loops[1].clone()),
            Ok(vec![[1.0, 1.0], [2.0, 1.0], [1.0, 2.0]])
        );
        for (text, reason) in [
            (
                "x,z\n0,0",
                "sole.csv:1: column `y` is missing; the header must be x,y",
            ),
            (
                "x,x,y\n0,0,0",
                "sole.csv:1: column `x` occurs twice; the header must be x,y",
            ),
            (
                "x,y\n0,0\n1,abc",
                "sole.csv:3: y is `abc`; give a number such as 0.5 or 1e-3",
            ),
            (
                "x,y,loop\n0,0,a\n0,0,b\n0,0,a",
                "sole.csv:4: the corners of loop a must follow each other",
            ),
        ] {
            assert_eq!(read(text), Err(reason.to_owned()), "{text:?}");
        }
    }
}
