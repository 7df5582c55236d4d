//! Tables of round patches: made by the compiler, and at run time.

use crate::couplings::{EXPONENTS, PRESSURES, batches, profile, smooth};
use crate::{Input, Verdict};
use tribos_core::coupling::round::{
    LateralPolynomialTable, PolynomialTable, RoundTable32, RoundTable64,
};
use tribos_core::coupling::table::{DiskTable32, DiskTable64};
use tribos_core::internals::{SmoothProfile, Speeds};
use tribos_core::patch::{PolynomialPressure, PowerPressure};

const fn made<T: Copy, E: Copy>(table: Result<T, E>) -> T {
    match table {
        Ok(table) => table,
        Err(_) => panic!("the exponent is in range"),
    }
}

static HALF_64: DiskTable64 = made(DiskTable64::new(0.5));
static HALF_32: DiskTable32 = made(DiskTable32::new(0.5));
static HERTZ_64: RoundTable64 = made(RoundTable64::new(-0.25, PowerPressure::HERTZ));
static RIM_32: RoundTable32 = made(RoundTable32::new(2.0, PowerPressure::RING));

/// Questions about a table that is made at run time.
const QUESTIONS: usize = 4;

/// Tables in flash, f64.
pub fn flash_f64(input: &mut Input<'_>) -> Verdict {
    if input.one_in(2) {
        smooth(input, &HALF_64)
    } else {
        smooth(input, &HERTZ_64)
    }
}

/// Tables in flash, f32.
pub fn flash_f32(input: &mut Input<'_>) -> Verdict {
    if input.one_in(2) {
        smooth(input, &HALF_32)
    } else {
        smooth(input, &RIM_32)
    }
}

/// A table of any exponent that is made at run time, f64.
pub fn made_f64(input: &mut Input<'_>) -> Verdict {
    let (alpha, pressure) = (exponent(input), input.one_of(&PRESSURES));
    match input.below(4) {
        0 => {
            let table = input.taken(DiskTable64::new(alpha))?;
            (0..QUESTIONS).try_for_each(|_| smooth(input, &table))
        }
        1 => {
            let table = input.taken(RoundTable64::new(alpha, pressure))?;
            (0..QUESTIONS).try_for_each(|_| smooth(input, &table))
        }
        2 => {
            let mixed = input.taken(PolynomialPressure::new([0.25, 1.0, -0.5]))?;
            let table = input.taken(LateralPolynomialTable::new(alpha, &mixed))?;
            (0..QUESTIONS).try_for_each(|_| smooth(input, &table))
        }
        _ => {
            let mixed = PolynomialPressure::new([1.0, input.unit(), input.unit()]);
            let mixed = input.taken(mixed)?;
            let table = input.taken(PolynomialTable::new(alpha, &mixed))?;
            (0..QUESTIONS).try_for_each(|_| {
                let at = [input.number(), input.number()];
                let speeds = Speeds::new(at[0], at[1]);
                input.give(table.factors_and_slope(&speeds));
                input.give(table.factors_and_rough_slope(&speeds));
                profile(input, &table, at)?;
                batches(input, &table)
            })
        }
    }
}

/// A table of any exponent that is made at run time, f32.
pub fn made_f32(input: &mut Input<'_>) -> Verdict {
    let (alpha, pressure) = (exponent(input) as f32, input.one_of(&PRESSURES));
    if input.one_in(2) {
        let table = input.taken(DiskTable32::new(alpha))?;
        (0..QUESTIONS).try_for_each(|_| smooth(input, &table))
    } else {
        let table = input.taken(RoundTable32::new(alpha, pressure))?;
        (0..QUESTIONS).try_for_each(|_| smooth(input, &table))
    }
}

/// One of the list, or any: refused or in range.
fn exponent(input: &mut Input<'_>) -> f64 {
    if input.one_in(2) {
        input.one_of(&EXPONENTS)
    } else {
        crate::laws::exponent(input)
    }
}
