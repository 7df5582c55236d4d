//! Text of other encodings than UTF-8, and packed text, made UTF-8 while it is read.

use flate2::bufread::MultiGzDecoder;
use std::io::{self, BufRead, BufReader, Cursor, Read};

/// First bytes of gzip (RFC 1952).
const GZIP: &[u8] = &[0x1f, 0x8b];
/// Marks of the byte order before UTF-16 text, the low byte first and the high byte first.
const LOW_FIRST: &[u8] = &[0xff, 0xfe];
const HIGH_FIRST: &[u8] = &[0xfe, 0xff];
/// Bytes that tell what a file is.
const HEAD: u64 = 2;
/// Bytes of a buffer.
const BUFFER: usize = 1 << 16;
/// Letters of Windows' code page 1252 where it differs from Latin-1, from byte 0x80 to byte 0x9f.
const WINDOWS: [char; 32] = [
    '€', '\u{81}', '‚', 'ƒ', '„', '…', '†', '‡', 'ˆ', '‰', 'Š', '‹', 'Œ', '\u{8d}', 'Ž', '\u{8f}',
    '\u{90}', '‘', '’', '“', '”', '•', '–', '—', '˜', '™', 'š', '›', 'œ', '\u{9d}', 'ž', 'Ÿ',
];
/// Byte from which the code pages differ from ASCII.
const FIRST: u8 = 0x80;

/// The source as UTF-8 or one byte a letter: gzip is unpacked, UTF-16 with its mark converted. Words for what was done.
pub(super) fn as_text<'a>(
    source: Box<dyn BufRead + 'a>,
) -> io::Result<(Box<dyn BufRead + 'a>, Option<&'static str>)> {
    let (head, source) = peeked(source)?;
    if head == GZIP {
        let unpacked = BufReader::with_capacity(BUFFER, MultiGzDecoder::new(source));
        let (head, inner) = peeked(Box::new(unpacked))?;
        let (inner, is_wide) = narrow(&head, inner);
        return Ok((inner, Some(if is_wide { "gzip, UTF-16" } else { "gzip" })));
    }
    let (source, is_wide) = narrow(&head, source);
    Ok((source, is_wide.then_some("UTF-16")))
}

/// UTF-8 in the place of UTF-16, and whether it was.
fn narrow<'a>(head: &[u8], source: Box<dyn BufRead + 'a>) -> (Box<dyn BufRead + 'a>, bool) {
    let is_low_first = head == LOW_FIRST;
    if !is_low_first && head != HIGH_FIRST {
        return (source, false);
    }
    let wide = Wide {
        source,
        is_low_first,
        high: None,
        made: Cursor::new(Vec::new()),
    };
    (Box::new(BufReader::with_capacity(BUFFER, wide)), true)
}

/// The first bytes of a source, and the source with them.
fn peeked<'a>(mut source: Box<dyn BufRead + 'a>) -> io::Result<(Vec<u8>, Box<dyn BufRead + 'a>)> {
    let mut head = Vec::new();
    source.by_ref().take(HEAD).read_to_end(&mut head)?;
    let whole = Cursor::new(head.clone()).chain(source);
    Ok((head, Box::new(whole)))
}

/// A source of UTF-16 that reads as UTF-8.
struct Wide<'a> {
    source: Box<dyn BufRead + 'a>,
    is_low_first: bool,
    /// The first half of a pair of units that make one letter.
    high: Option<u16>,
    /// Letters that are not yet taken.
    made: Cursor<Vec<u8>>,
}

impl Wide<'_> {
    /// Converts the next units; false at the end.
    fn fill(&mut self) -> io::Result<bool> {
        let mut units = Vec::new();
        self.source
            .by_ref()
            .take(BUFFER as u64)
            .read_to_end(&mut units)?;
        if units.is_empty() && self.high.is_none() {
            return Ok(false);
        }
        let is_end = units.len() < BUFFER;
        let (pairs, _) = units.as_chunks::<2>();
        let unit = |pair: &[u8; 2]| match self.is_low_first {
            true => u16::from_le_bytes(*pair),
            false => u16::from_be_bytes(*pair),
        };
        let mut all: Vec<u16> = self.high.take().into_iter().collect();
        all.extend(pairs.iter().map(unit));
        // A pair that the buffer parts is completed by the next one.
        if !is_end
            && all
                .last()
                .is_some_and(|unit| (0xd800..0xdc00).contains(unit))
        {
            self.high = all.pop();
        }
        let letters = char::decode_utf16(all);
        let text: String = letters
            .map(|letter| letter.unwrap_or(char::REPLACEMENT_CHARACTER))
            .collect();
        self.made = Cursor::new(text.into_bytes());
        Ok(true)
    }
}

impl Read for Wide<'_> {
    fn read(&mut self, into: &mut [u8]) -> io::Result<usize> {
        loop {
            let count = self.made.read(into)?;
            if count > 0 || into.is_empty() || !self.fill()? {
                return Ok(count);
            }
        }
    }
}

/// Text of one byte a letter, in Windows' code page 1252, of which Latin-1 is a part.
pub(super) fn letters_of(bytes: &[u8], into: &mut String) {
    into.clear();
    into.extend(bytes.iter().map(|&byte| {
        let special = byte.checked_sub(FIRST).map(usize::from);
        special
            .and_then(|at| WINDOWS.get(at).copied())
            .unwrap_or(char::from(byte))
    }));
}

#[cfg(test)]
mod tests {
    use super::*;

    fn text(bytes: &[u8]) -> io::Result<(String, Option<&'static str>)> {
        let (mut source, told) = as_text(Box::new(bytes))?;
        let mut text = String::new();
        source.read_to_string(&mut text)?;
        Ok((text, told))
    }

    #[test]
    fn wide_text_is_converted_in_both_orders_and_across_buffers() -> io::Result<()> {
        // Letters of two units at odd places, so that a buffer parts one of them.
        let long: String = "x".to_owned() + &"\u{1d6cd}µ;1\n".repeat(BUFFER);
        for order in [u16::to_le_bytes as fn(u16) -> [u8; 2], u16::to_be_bytes] {
            let units = [0xfeff].into_iter().chain(long.encode_utf16());
            let bytes: Vec<u8> = units.flat_map(order).collect();
            let (made, told) = text(&bytes)?;
            assert!(made.trim_start_matches('\u{feff}') == long);
            assert_eq!(told, Some("UTF-16"));
        }
        Ok(())
    }

    #[test]
    fn packed_text_is_unpacked_and_plain_text_stays() -> io::Result<()> {
        use std::io::Write;
        let mut packer = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::fast());
        packer.write_all(b"v,f\n1,2\n")?;
        let packed = packer.finish()?;
        assert_eq!(text(&packed)?, ("v,f\n1,2\n".to_owned(), Some("gzip")));
        // Two members, one after the other, as `cat a.gz b.gz` makes them.
        let twice = [&packed[..], &packed[..]].concat();
        assert_eq!(text(&twice)?.0, "v,f\n1,2\nv,f\n1,2\n");
        assert!(text(&packed[..packed.len() - 9]).is_err());
        for plain in ["", "v", "v,f\n"] {
            assert_eq!(text(plain.as_bytes())?, (plain.to_owned(), None));
        }
        Ok(())
    }

    #[test]
    fn bytes_become_the_letters_of_windows() {
        let mut made = String::new();
        letters_of(b"\xb5m \xb0 \x96 \x80 \xfc", &mut made);
        assert_eq!(made, "µm ° – € ü");
    }
}
