//! Numbers in blocks of bytes, as VTK packs and writes them.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use flate2::read::ZlibDecoder;
use std::io::Read as _;

/// Letters of base64 that stand for three bytes.
const QUARTET: usize = 4;
/// Largest size of an array in bytes.
const MOST: u64 = 4 << 30;

/// How blocks of a file are written.
#[derive(Clone, Copy, Debug)]
pub(super) struct Packing {
    /// Bytes of a number in the head of a block.
    pub header: usize,
    /// Whether blocks are packed by zlib.
    pub is_packed: bool,
    pub is_big_endian: bool,
}

impl Packing {
    fn number(&self, bytes: &[u8]) -> u64 {
        let add = |sum: u64, byte: &u8| sum << 8 | u64::from(*byte);
        if self.is_big_endian {
            bytes.iter().fold(0, add)
        } else {
            bytes.iter().rev().fold(0, add)
        }
    }

    /// The bytes of an array that begins at the start of these; what follows it does not count.
    pub fn array(&self, bytes: &[u8]) -> Option<Vec<u8>> {
        let word = |at: usize| {
            bytes
                .get(at * self.header..(at + 1) * self.header)
                .map(|word| self.number(word))
        };
        if !self.is_packed {
            let length = usize::try_from(word(0)?).ok()?;
            let begin = self.header;
            return bytes
                .get(begin..begin.checked_add(length)?)
                .map(<[u8]>::to_vec);
        }
        // Number of blocks, their size, that of the last if it is shorter, then the packed size of each.
        let (count, size) = (usize::try_from(word(0)?).ok()?, word(1)?);
        let mut at = count.checked_add(3)?.checked_mul(self.header)?;
        let (mut all, most) = (Vec::new(), size.checked_mul(count as u64)?.min(MOST));
        for block in 0..count {
            let length = usize::try_from(word(3 + block)?).ok()?;
            let packed = bytes.get(at..at.checked_add(length)?)?;
            let room = most.checked_sub(all.len() as u64)?;
            ZlibDecoder::new(packed)
                .take(room)
                .read_to_end(&mut all)
                .ok()?;
            at += length;
        }
        Some(all)
    }

    /// The array in base64; head and data may be coded one by one.
    pub fn array_of_text(&self, text: &[u8]) -> Option<Vec<u8>> {
        let letters: Vec<u8> = text
            .iter()
            .copied()
            .filter(|letter| !letter.is_ascii_whitespace())
            .collect();
        let (mut bytes, mut from) = (Vec::new(), 0);
        for (at, quartet) in letters.chunks(QUARTET).enumerate() {
            let end = (at * QUARTET + QUARTET).min(letters.len());
            if quartet.contains(&b'=') || end == letters.len() {
                bytes.extend(STANDARD.decode(&letters[from..end]).ok()?);
                from = end;
            }
        }
        self.array(&bytes)
    }

    /// Numbers of a type of VTK; none for a type that is not known.
    pub fn numbers(&self, kind: &str, bytes: &[u8]) -> Option<Vec<f64>> {
        macro_rules! read {
            ($number:ty) => {{
                let words = bytes.as_chunks::<{ size_of::<$number>() }>().0.iter();
                let is_big = self.is_big_endian;
                let number = |word| {
                    if is_big {
                        <$number>::from_be_bytes(word)
                    } else {
                        <$number>::from_le_bytes(word)
                    }
                };
                #[allow(clippy::cast_lossless)]
                let all = words.map(|word| number(*word) as f64).collect();
                Some(all)
            }};
        }
        match kind {
            "Float64" | "double" => read!(f64),
            "Float32" | "float" => read!(f32),
            "Int64" | "vtktypeint64" | "long" | "vtkIdType" => read!(i64),
            "UInt64" | "unsigned_long" | "vtktypeuint64" => read!(u64),
            "Int32" | "int" => read!(i32),
            "UInt32" | "unsigned_int" => read!(u32),
            "Int16" | "short" => read!(i16),
            "UInt16" | "unsigned_short" => read!(u16),
            "Int8" | "char" => read!(i8),
            "UInt8" | "unsigned_char" => read!(u8),
            _ => None,
        }
    }
}
