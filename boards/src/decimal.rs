//! Numbers with a fixed number of decimals, formatted with integers only.
//!
//! Float formatting in `core` takes some 10 KiB and contains panics that survive optimisation.

use core::fmt::{Display, Formatter, Result, Write};

/// A number that is formatted with `PLACES` decimals, at most 6.
///
/// *Domain*: magnitudes below 2³²/10^`PLACES`; larger ones are written as the largest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Decimal<const PLACES: u32>(pub f32);

impl<const PLACES: u32> Decimal<PLACES> {
    const UNIT: u32 = {
        assert!(PLACES <= 6);
        10_u32.pow(PLACES)
    };
}

impl<const PLACES: u32> Display for Decimal<PLACES> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        if self.0.is_nan() {
            return f.write_str("NaN");
        }
        // Conversions of floats to integers saturate.
        let scaled = (self.0.abs() * Self::UNIT as f32 + 0.5) as u32;
        if self.0 < 0.0 && scaled > 0 {
            f.write_char('-')?;
        }
        write!(f, "{}", scaled / Self::UNIT)?;
        let mut rest = scaled % Self::UNIT;
        if PLACES > 0 {
            f.write_char('.')?;
        }
        for _ in 0..PLACES {
            rest *= 10;
            f.write_char(char::from(b'0' + (rest / Self::UNIT) as u8))?;
            rest %= Self::UNIT;
        }
        Ok(())
    }
}

#[cfg(all(test, not(target_os = "none")))]
mod tests {
    use super::*;

    #[test]
    fn decimals_are_rounded_and_padded() {
        assert_eq!(Decimal::<2>(5.6789).to_string(), "5.68");
        assert_eq!(Decimal::<3>(-0.0625).to_string(), "-0.063");
        assert_eq!(Decimal::<3>(1.004).to_string(), "1.004");
        assert_eq!(Decimal::<0>(41.5).to_string(), "42");
        assert_eq!(Decimal::<1>(-0.04).to_string(), "0.0");
    }

    #[test]
    fn no_number_is_left_out() {
        assert_eq!(Decimal::<2>(f32::NAN).to_string(), "NaN");
        assert_eq!(Decimal::<0>(f32::INFINITY).to_string(), "4294967295");
        assert_eq!(Decimal::<0>(f32::NEG_INFINITY).to_string(), "-4294967295");
    }
}
