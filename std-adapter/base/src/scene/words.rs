//! Words that a key of a scene may have, and the values that they stand for.

use super::hint::nearest;
use tribos_core::contact::Attraction;

/// A value that a scene names by a word.
pub trait Word: Copy + 'static {
    /// All words, the order of the documentation.
    const WORDS: &'static [&'static str];

    /// The word of this value.
    fn word(self) -> &'static str;

    /// The value of a word.
    fn of_word(word: &str) -> Option<Self>;
}

/// A text that is none of the words of its type.
///
/// ```
/// use tribos::scene::{SliderIntegrator, UnknownWord};
/// assert_eq!("verlet".parse(), Ok(SliderIntegrator::Verlet));
/// assert_eq!(SliderIntegrator::Verlet.to_string(), "verlet");
/// let refused: Result<SliderIntegrator, UnknownWord> = "verlett".parse();
/// assert!(refused.is_err_and(|error| error.to_string().ends_with("did you mean \"verlet\"?")));
/// ```
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("must be one of \"{}\", got \"{given}\"{}", .known.join("\", \""), meant(.given, .known))]
pub struct UnknownWord {
    /// The text.
    pub given: String,
    /// The words that would be valid.
    pub known: &'static [&'static str],
}

/// The hint at the word that was probably meant.
pub fn meant(given: &str, known: &[&'static str]) -> String {
    let near = nearest(given, known.iter().copied());
    near.map_or(String::new(), |near| format!("; did you mean \"{near}\"?"))
}

/// Gives the values of an enum their words, both ways.
#[macro_export]
#[doc(hidden)]
macro_rules! words {
    (only $name:ty { $($variant:ident = $word:literal),+ $(,)? }) => {
        impl $crate::scene::words::Word for $name {
            const WORDS: &'static [&'static str] = &[$($word),+];

            fn word(self) -> &'static str {
                match self {
                    $(Self::$variant => $word),+
                }
            }

            fn of_word(word: &str) -> Option<Self> {
                match word {
                    $($word => Some(Self::$variant),)+
                    _ => None,
                }
            }
        }

        impl $crate::results::Recorded for $name {
            fn recorded(&self) -> Option<$crate::serde_json::Value> {
                Some($crate::scene::words::Word::word(*self).into())
            }
        }
    };
    ($name:ty { $($variant:ident = $word:literal),+ $(,)? }) => {
        $crate::words!(only $name { $($variant = $word),+ });

        impl std::fmt::Display for $name {
            fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.write_str($crate::scene::words::Word::word(*self))
            }
        }

        impl std::str::FromStr for $name {
            type Err = $crate::scene::UnknownWord;

            fn from_str(text: &str) -> Result<Self, Self::Err> {
                use $crate::scene::words::Word;
                <Self as Word>::of_word(text).ok_or_else(|| $crate::scene::UnknownWord {
                    given: text.to_owned(),
                    known: <Self as Word>::WORDS,
                })
            }
        }
    };
}
pub use words;

// Of the kernel, which knows no files.
words!(only Attraction { Pull = "pull", Resistance = "resistance" });

impl Word for bool {
    const WORDS: &'static [&'static str] = &["on", "off"];

    fn word(self) -> &'static str {
        if self { "on" } else { "off" }
    }

    fn of_word(word: &str) -> Option<Self> {
        match word {
            "on" => Some(true),
            "off" => Some(false),
            _ => None,
        }
    }
}
