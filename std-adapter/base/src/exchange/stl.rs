//! Triangles of an STL file, as text or binary.

use super::text::{Line, TextError};

/// Bytes before the triangles of a binary file: a heading and their number.
const HEADING: usize = 84;
/// Bytes of a triangle: a normal, three corners, two of no meaning.
const TRIANGLE: usize = 50;

/// Corners of the triangles of a file. Normals are not read: the corners have them.
///
/// *Units*: those of the file.
///
/// ```
/// use tribos_base::exchange::stl::triangles;
/// let text = "solid wedge\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 2e0 0\n\
///             endloop\nendfacet\nendsolid wedge\n";
/// assert_eq!(triangles(text.as_bytes())?, [[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 2.0, 0.0]]]);
/// let refused = triangles(b"solid\nvertex 0 0 zero\n");
/// assert!(refused.is_err_and(|error| error.to_string().starts_with("line 2: a coordinate")));
/// # Ok::<(), tribos_base::exchange::text::TextError>(())
/// ```
pub fn triangles(bytes: &[u8]) -> Result<Vec<[[f64; 3]; 3]>, TextError> {
    // The length tells a binary file, whose heading may begin as a text does.
    let count = bytes
        .get(HEADING - 4..HEADING)
        .and_then(|count| count.try_into().ok());
    let count = count.map(|count| u32::from_le_bytes(count) as usize);
    match count.and_then(|count| count.checked_mul(TRIANGLE)) {
        Some(length) if bytes.len() == HEADING + length => Ok(binary(&bytes[HEADING..])),
        _ => text(&String::from_utf8_lossy(bytes)),
    }
}

fn binary(bytes: &[u8]) -> Vec<[[f64; 3]; 3]> {
    let number = |bytes: &[u8]| f32::from_le_bytes([bytes[0], bytes[1], bytes[2], bytes[3]]);
    let triangle = |record: &[u8]| {
        [0, 1, 2].map(|corner: usize| {
            [0, 1, 2].map(|axis: usize| f64::from(number(&record[12 * (corner + 1) + 4 * axis..])))
        })
    };
    bytes.chunks_exact(TRIANGLE).map(triangle).collect()
}

fn text(text: &str) -> Result<Vec<[[f64; 3]; 3]>, TextError> {
    let mut corners = Vec::new();
    let mut last = Line {
        number: 1,
        text: "",
    };
    for (number, text) in (1..).zip(text.lines()) {
        let line = Line { number, text };
        let words = line.words();
        let Some((&"vertex", rest)) = words.split_first() else {
            continue;
        };
        let &[x, y, z] = rest else {
            return Err(line.missing("a coordinate", "a line `vertex` has three"));
        };
        let mut corner = [0.0; 3];
        for (into, word) in corner.iter_mut().zip([x, y, z]) {
            *into = line.number("a coordinate", word)?;
        }
        corners.push(corner);
        last = line;
    }
    match corners.as_chunks() {
        ([], []) => Err(last.missing(
            "a triangle",
            "give an STL file, as text with `facet` and `vertex` or binary of its full length",
        )),
        (triangles, []) => Ok(triangles.to_vec()),
        _ => Err(last.missing("a corner of the last triangle", "a triangle has three")),
    }
}

#[cfg(test)]
mod tests {
    use super::triangles;

    #[test]
    fn a_binary_file_has_the_triangles_of_its_text() {
        let corners = [[0.0_f32, 0.25, -1.5], [1.0, 0.0, 3.0], [0.0, 2.0, 1e-3]];
        let mut bytes = vec![0_u8; 80];
        bytes[..5].copy_from_slice(b"solid");
        bytes.extend(2_u32.to_le_bytes());
        for _ in 0..2 {
            bytes.extend([0_u8; 12]);
            bytes.extend(corners.iter().flatten().flat_map(|x| x.to_le_bytes()));
            bytes.extend([0_u8; 2]);
        }
        let expected = corners.map(|corner| corner.map(f64::from));
        assert_eq!(triangles(&bytes), Ok(vec![expected; 2]));
        // Cut short it is neither binary nor text.
        bytes.pop();
        assert!(triangles(&bytes).is_err());
    }
}
