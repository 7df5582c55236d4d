//! Reading text files of limited size.

use std::fs::File;
use std::io::{ErrorKind, Read};
use std::path::Path;

/// A text that cannot be read.
///
/// ```
/// use tribos::record::ReadError;
/// let error = ReadError::TooLarge { most: 3 << 20 };
/// assert_eq!(error.to_string(), "the file is larger than 3 MB, which is the most that is read");
/// let nowhere = tribos::record::read_text("nowhere.toml".as_ref(), 100);
/// assert!(nowhere.is_err_and(|error| error.is_missing()) && !error.is_missing());
/// ```
#[derive(Debug, thiserror::Error)]
pub enum ReadError {
    /// The file cannot be opened or read.
    #[error(transparent)]
    Io(#[from] std::io::Error),
    /// The file is larger than the limit.
    #[error("the file is larger than {} MB, which is the most that is read", most >> 20)]
    TooLarge {
        /// Largest number of bytes.
        most: u64,
    },
    /// The file is compressed.
    #[error("the file is compressed ({0}); unpack it first")]
    Compressed(&'static str),
    /// The file contains a zero byte or is not UTF-8.
    #[error("the file is not text: its byte {at} is zero or not UTF-8")]
    NotText {
        /// Offset of the first byte that is not text.
        at: u64,
    },
}

impl ReadError {
    /// Whether the file does not exist.
    pub fn is_missing(&self) -> bool {
        matches!(self, Self::Io(error) if error.kind() == ErrorKind::NotFound)
    }
}

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
/// use tribos::record::{ReadError, read_text};
/// # let home = tempfile::tempdir()?;
/// # let file = home.path().join("scene.toml");
/// std::fs::write(&file, "speed = 1")?;
/// assert_eq!(read_text(&file, 9)?, "speed = 1");
/// assert!(matches!(read_text(&file, 8), Err(ReadError::TooLarge { most: 8 })));
/// std::fs::write(&file, "\u{feff}speed = 1")?;
/// assert_eq!(read_text(&file, 99)?, "speed = 1");
/// std::fs::write(&file, "speed\0= 1")?;
/// assert!(matches!(read_text(&file, 100), Err(ReadError::NotText { at: 5 })));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn read_text(path: &Path, most: u64) -> Result<String, ReadError> {
    read_text_from(&mut File::open(path)?, most)
}

/// What unpacks a compressed file that begins with these bytes.
pub(super) fn packer(bytes: &[u8]) -> Option<&'static str> {
    let known = COMPRESSED.iter().find(|(head, _)| bytes.starts_with(head));
    known.map(|(_, cure)| *cure)
}

/// As [`read_text`], from an open source.
fn read_text_from(source: &mut impl Read, most: u64) -> Result<String, ReadError> {
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
            return Err(ReadError::Compressed(cure));
        }
        if let Some(at) = bytes[before..].iter().position(|byte| *byte == 0) {
            let at = (before + at) as u64;
            return Err(ReadError::NotText { at });
        }
        if bytes.len() as u64 > most {
            return Err(ReadError::TooLarge { most });
        }
    }
    if bytes.starts_with(BYTE_ORDER_MARK) {
        bytes.drain(..BYTE_ORDER_MARK.len());
    }
    String::from_utf8(bytes).map_err(|error| ReadError::NotText {
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
            Err(ReadError::TooLarge { .. })
        ));
        assert!(matches!(
            read_text_from(&mut &b"\xff"[..], 9),
            Err(ReadError::NotText { at: 0 })
        ));
        let packed = read_text_from(&mut &b"\x1f\x8b\x08\0rest"[..], 99);
        let told = packed.map_err(|error| error.to_string());
        assert_eq!(
            told,
            Err("the file is compressed (gunzip); unpack it first".into())
        );
    }
}
