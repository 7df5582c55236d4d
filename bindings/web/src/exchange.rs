//! Results and reasons that JavaScript reads.
//!
//! Results of fixed size stand at one address, the pieces of a reason at another. What has no fixed size
//! goes through memory that the caller provides. Nothing has to be freed, and without the feature `all`
//! there is no heap.

#[cfg(feature = "all")]
use alloc::string::String;
use core::sync::atomic::{AtomicU64, AtomicUsize, Ordering::Relaxed};
use tribos_core::Error;
use tribos_core::law::LawError;
use tribos_core::patch::PatchError;

/// Numbers of the longest result of fixed size.
const LONGEST: usize = 24;
/// Pieces of a reason.
const PIECES: usize = 3;

// The module has one thread; atomic numbers are plain ones there.
static RESULT: [AtomicU64; LONGEST] = [const { AtomicU64::new(0) }; LONGEST];
static REASON: [[AtomicUsize; 2]; PIECES] = [const { [const { AtomicUsize::new(0) }; 2] }; PIECES];
#[cfg(feature = "all")]
static SAID: std::sync::Mutex<String> = std::sync::Mutex::new(String::new());

/// Status after success.
pub const DONE: u32 = 0;
/// Status after a refusal.
pub const REFUSED: u32 = 1;
/// The same; the reason ends with the first number of the result.
pub const REFUSED_NUMBER: u32 = 2;

/// Why a call was refused.
#[derive(Clone, Debug, PartialEq)]
pub enum Refused {
    /// In words of this crate.
    Because(&'static str),
    /// By the kernel. Its words are taken without formatted numbers, which would be a third of the small
    /// module.
    Kernel(Error),
    /// In words of the library.
    #[cfg(feature = "all")]
    Said(String),
}

impl From<Error> for Refused {
    fn from(error: Error) -> Self {
        #[cfg(feature = "all")]
        if words_of(&error).1.is_none() {
            return Self::Said(alloc::string::ToString::to_string(&error));
        }
        Self::Kernel(error)
    }
}

impl From<LawError> for Refused {
    fn from(error: LawError) -> Self {
        Error::from(error).into()
    }
}

/// A refusal in the words of an error.
#[cfg(feature = "all")]
pub fn said(error: impl alloc::string::ToString) -> Refused {
    Refused::Said(error.to_string())
}

#[cfg(feature = "all")]
impl From<tribos_friction::FrictionError> for Refused {
    fn from(refusal: tribos_friction::FrictionError) -> Self {
        use tribos_friction::FrictionError;
        match refusal {
            // Numbers are JavaScript's to write.
            FrictionError::Friction(error) => error.into(),
            FrictionError::Patch(error) => Error::from(error).into(),
            FrictionError::Law(error) => error.into(),
            other => said(other),
        }
    }
}

/// The words of an error that disks can meet, to the letter those of its `Display`, and the number that
/// follows them.
pub fn words_of(error: &Error) -> ([&'static str; PIECES], Option<f64>) {
    match *error {
        Error::Law(LawError::Coefficient { given }) => (
            [
                "the coefficient must be finite and not negative, not ",
                "",
                "",
            ],
            Some(given),
        ),
        Error::Law(LawError::NotPositive { parameter, given }) => (
            ["the ", parameter, " must be positive and finite, not "],
            Some(given),
        ),
        Error::Law(LawError::Negative { parameter, given }) => (
            ["the ", parameter, " must be finite and not negative, not "],
            Some(given),
        ),
        Error::Law(LawError::NotFinite { parameter, given }) => {
            (["the ", parameter, " must be finite, not "], Some(given))
        }
        Error::Patch(PatchError::Radius { given }) => (
            [
                "the contact radius must be positive and finite, not ",
                "",
                "",
            ],
            Some(given),
        ),
        // Only prepared patches have others.
        _ => (["the kernel refuses these numbers", "", ""], None),
    }
}

/// Leaves a result of fixed size.
#[inline]
pub fn answer<const N: usize>(result: [f64; N]) {
    for (slot, value) in RESULT.iter().zip(result) {
        slot.store(value.to_bits(), Relaxed);
    }
}

/// Address of the results.
pub fn result_address() -> usize {
    RESULT.as_ptr().addr()
}

/// Address of addresses and lengths of the pieces of the reason.
pub fn reason_address() -> usize {
    REASON.as_ptr().addr()
}

/// Leaves a text where the reason stands.
fn leave(words: [&str; PIECES]) {
    for ([address, length], piece) in REASON.iter().zip(words) {
        address.store(piece.as_ptr().addr(), Relaxed);
        length.store(piece.len(), Relaxed);
    }
}

/// Leaves a text of any kind where the reason stands.
#[cfg(feature = "all")]
pub fn say(text: String) {
    let mut said = SAID.lock().unwrap_or_else(|held| held.into_inner());
    *said = text;
    leave([&said, "", ""]);
}

/// A status.
#[inline]
pub fn status(result: Result<(), Refused>) -> u32 {
    match result {
        Ok(()) => DONE,
        Err(refused) => leave_reason(refused),
    }
}

/// A status, and a number of rows as the result.
pub fn counted(result: Result<usize, Refused>) -> u32 {
    // Exact: memory has no more than 2^32 bytes.
    status(result.map(|count| answer([count as f64])))
}

#[inline(never)]
fn leave_reason(refused: Refused) -> u32 {
    match refused {
        Refused::Because(words) => leave([words, "", ""]),
        Refused::Kernel(error) => {
            let (words, given) = words_of(&error);
            leave(words);
            if let Some(given) = given {
                answer([given]);
                return REFUSED_NUMBER;
            }
        }
        #[cfg(feature = "all")]
        Refused::Said(words) => say(words),
    }
    REFUSED
}
