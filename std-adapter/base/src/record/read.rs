//! Reading text files of limited size.

use super::RecordError;
use flate2::bufread::MultiGzDecoder;
use std::fs::File;
use std::io::{BufReader, Read};
use std::path::Path;

/// First bytes of compressed files (RFC 1952; bzip2; .xz 1.2.1; RFC 8878; APPNOTE 6.3), and what unpacks them.
const COMPRESSED: [(&[u8], &str); 5] = [
    (&[0x1f, 0x8b], "gunzip"),
    (b"BZh", "bunzip2"),
    (&[0xfd, b'7', b'z', b'X', b'Z', 0], "unxz"),
    (&[0x28, 0xb5, 0x2f, 0xfd], "unzstd"),
    (b"PK\x03\x04", "unzip"),
];

/// Mark of the byte order that some programs put before UTF-8 text.
const BYTE_ORDER_MARK: &[u8] = "\u{feff}".as_bytes();
/// Bytes that are read at a time.
const CHUNK: u64 = 1 << 16;

/// The text of a file or a pipe, of at most `most` bytes; a byte order mark before it is dropped. Stops at the first
/// byte that is not text or exceeds the limit, so that an endless device is refused at once.
///
/// ```
/// use tribos::record::{RecordError, read_text};
/// # let home = tempfile::tempdir()?;
/// # let file = home.path().join("scene.toml");
/// std::fs::write(&file, "speed = 1")?;
/// assert_eq!(read_text(&file, 9)?, "speed = 1");
/// assert!(matches!(read_text(&file, 8), Err(RecordError::TooLarge { most: 8 })));
/// std::fs::write(&file, "\u{feff}speed = 1")?;
/// assert_eq!(read_text(&file, 99)?, "speed = 1");
/// std::fs::write(&file, "speed\0= 1")?;
/// assert!(matches!(read_text(&file, 100), Err(RecordError::NotText { at: 5 })));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn read_text(path: &Path, most: u64) -> Result<String, RecordError> {
    read_text_from(&mut File::open(path)?, most)
}

/// First bytes of files of VTK, which may hold blocks of any bytes.
const WITH_BLOCKS: [&[u8]; 2] = [b"<", b"# vtk"];

/// The bytes of a file of at most `most` bytes, unpacked if it is gzip; a byte order mark before it is dropped. Only what
/// begins as a file of VTK may hold a zero byte: all else is refused at the first.
///
/// ```
/// use tribos::record::{RecordError, read_bytes};
/// # let home = tempfile::tempdir()?;
/// # let file = home.path().join("spheres.txt.gz");
/// // "0 0 0 1" and a line feed, packed by gzip.
/// let packed = [
///     31, 139, 8, 0, 0, 0, 0, 0, 2, 255, 51, 80, 48, 0, 66, 67, 46, 0, 204, 205, 7, 4, 8, 0, 0, 0,
/// ];
/// std::fs::write(&file, packed)?;
/// assert_eq!(read_bytes(&file, 8)?, b"0 0 0 1\n");
/// assert!(matches!(read_bytes(&file, 7), Err(RecordError::TooLarge { most: 7 })));
/// std::fs::write(&file, "0 0\0 1")?;
/// assert!(matches!(read_bytes(&file, 99), Err(RecordError::NotText { at: 3 })));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn read_bytes(path: &Path, most: u64) -> Result<Vec<u8>, RecordError> {
    let mut head = Vec::new();
    File::open(path)?
        .take(COMPRESSED[0].0.len() as u64)
        .read_to_end(&mut head)?;
    let source = File::open(path)?;
    if head == COMPRESSED[0].0 {
        return bytes_from(&mut MultiGzDecoder::new(BufReader::new(source)), most);
    }
    bytes_from(&mut BufReader::new(source), most)
}

/// The bytes of an open source.
fn bytes_from(source: &mut impl Read, most: u64) -> Result<Vec<u8>, RecordError> {
    let mut bytes = Vec::new();
    loop {
        let before = bytes.len();
        source.by_ref().take(CHUNK).read_to_end(&mut bytes)?;
        if bytes.len() == before {
            break;
        }
        if before == 0
            && let Some(cure) = packer(&bytes)
        {
            return Err(RecordError::Compressed(cure));
        }
        let has_blocks = WITH_BLOCKS.iter().any(|head| bytes.starts_with(head));
        let zero = bytes[before..].iter().position(|byte| *byte == 0);
        if let Some(at) = zero.filter(|_| !has_blocks) {
            let at = (before + at) as u64;
            return Err(RecordError::NotText { at });
        }
        if bytes.len() as u64 > most {
            return Err(RecordError::TooLarge { most });
        }
    }
    if bytes.starts_with(BYTE_ORDER_MARK) {
        bytes.drain(..BYTE_ORDER_MARK.len());
    }
    Ok(bytes)
}

/// What unpacks a compressed file that begins with these bytes.
pub(super) fn packer(bytes: &[u8]) -> Option<&'static str> {
    let known = COMPRESSED.iter().find(|(head, _)| bytes.starts_with(head));
    known.map(|(_, cure)| *cure)
}

/// As [`read_text`], from an open source.
fn read_text_from(source: &mut impl Read, most: u64) -> Result<String, RecordError> {
    let bytes = bytes_from(source, most)?;
    if let Some(at) = bytes.iter().position(|byte| *byte == 0) {
        return Err(RecordError::NotText { at: at as u64 });
    }
    String::from_utf8(bytes).map_err(|error| RecordError::NotText {
        at: error.utf8_error().valid_up_to() as u64,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sources_without_end_and_bytes_of_no_text_are_refused() {
        let endless = &mut std::io::repeat(b'y');
        assert!(matches!(
            read_text_from(endless, 1 << 20),
            Err(RecordError::TooLarge { .. })
        ));
        assert!(matches!(
            read_text_from(&mut &b"\xff"[..], 9),
            Err(RecordError::NotText { at: 0 })
        ));
        let packed = read_text_from(&mut &b"\x1f\x8b\x08\0rest"[..], 99);
        let told = packed.map_err(|error| error.to_string());
        assert_eq!(
            told,
            Err("the file is compressed (gunzip); unpack it first".into())
        );
    }
}
