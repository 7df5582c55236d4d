//! Why a choice of friction is refused.

use super::{LARGEST_EXPONENT, Tier};
use tribos_core::law::LawError;
use tribos_core::patch::PatchError;

/// Why a patch, a law or a tier was refused, with what to do about it.
///
/// ```
/// use tribos::friction::{AnyFriction, Law, Patch, FrictionError, Tier};
/// let unknown = "hetrz".parse::<Patch>().map_err(|refusal| refusal.to_string());
/// assert_eq!(unknown, Err("unknown patch `hetrz`; did you mean `hertz`?".into()));
/// let patch = Patch::Polynomial(vec![1.0, 1.0]);
/// let steep = AnyFriction::<f64>::new(&patch, &Law::power(0.3, 20.0)?, Some(Tier::Exact));
/// assert!(matches!(steep, Err(FrictionError::Tier { cure: Some(Tier::Quadrature), .. })));
/// assert!(matches!(Law::power(0.3, 200.0), Err(FrictionError::Exponent { .. })));
/// # Ok::<(), FrictionError>(())
/// ```
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum FrictionError {
    /// A name that is not known.
    #[error("unknown {what} `{given}`; {cure}")]
    Unknown {
        /// What kind of name.
        what: &'static str,
        /// What was given.
        given: String,
        /// What was meant, or all that is known.
        cure: String,
    },
    /// A patch or a law that is not written as it has to be.
    #[error("{0}")]
    Syntax(String),
    /// The law has a state, or depends on something else than the speed of a surface element.
    #[error("`{name}` is not a law of the local speed; {reason}")]
    NotLocal {
        /// The law.
        name: &'static str,
        /// Why it cannot couple with a patch, and what to do.
        reason: &'static str,
    },
    /// The law's parameters make no sense.
    #[error("{law}: {error}; {needs}")]
    Parameters {
        /// The law.
        law: &'static str,
        /// Why.
        error: LawError,
        /// What the law needs.
        needs: String,
    },
    /// No tier serves the exponent.
    #[error("the exponent alpha must be a number > -1 and <= {LARGEST_EXPONENT}, not {given}")]
    Exponent {
        /// What was given.
        given: f64,
    },
    /// The tier does not serve the law on the patch.
    #[error("the {tier} tier {reason}{}", match cure {
        Some(cure) => format!("; use the {cure} tier"),
        None => "; let the tier be chosen".into(),
    })]
    Tier {
        /// The tier that was asked for.
        tier: Tier,
        /// What it does not serve.
        reason: String,
        /// The tier that does; `None` if it is better left open.
        cure: Option<Tier>,
    },
    /// Polynomial pressures have no tables in single precision.
    #[error("polynomial pressures have tables in 64 bit only; use f64, or the quadrature tier")]
    SinglePrecision,
    /// The patch has no such friction, or no such question; the words say what does.
    #[error("{0}")]
    Unserved(String),
    /// Quadrature has no profile, which final motion and sliders are computed from.
    #[error("quadrature serves no final motion; use the exact tier")]
    NoProfile,
    /// Points and patches with straight edges have no axis of symmetry.
    #[error("points and patches with straight edges have no axis of symmetry: name a round patch")]
    NoAxis,
    /// The kernel refused the patch, or the nodes that stand for its pressure.
    #[error(transparent)]
    Patch(#[from] PatchError),
    /// The kernel refused the law.
    #[error(transparent)]
    Law(#[from] LawError),
    /// The kernel refused radius or coefficient.
    #[error(transparent)]
    Friction(#[from] tribos_core::Error),
}

impl FrictionError {
    /// An unknown word, with the nearest of all known ones or the list of them.
    #[doc(hidden)]
    pub fn unknown<'a>(
        what: &'static str,
        given: &str,
        known: impl IntoIterator<Item = &'a str>,
        list: impl Into<String>,
    ) -> Self {
        let cure = match super::text::nearest(given.split(':').next().unwrap_or(given), known) {
            Some(meant) => format!("did you mean `{meant}`?"),
            None => list.into(),
        };
        let given = given.to_owned();
        Self::Unknown { what, given, cure }
    }
}

/// A finite number, or why a text is none and what to write instead.
///
/// ```
/// use tribos::friction::finite_number;
/// assert_eq!(finite_number(" 1e-3"), Ok(1e-3));
/// assert_eq!(finite_number("0,5"), Err("got 0,5; write a decimal point: 0.5".into()));
/// ```
pub fn finite_number(text: &str) -> Result<f64, String> {
    super::text::finite_number(text)
}
