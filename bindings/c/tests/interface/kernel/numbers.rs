//! The kernel's numbers: fitted terms, prepared curves, constants of both types.

use std::fmt::Debug;
use tribos_core::Real;
use tribos_core::coupling::coulomb::{
    CoulombDisk, CoulombHertz, CoulombParaboloid, CoulombPunch, CoulombRing,
};
use tribos_core::internals::{
    ATANH, ATANH_SINGLE, BEND, BEND_SINGLE, CurveNumbers, DISK_SLOPE_ROUGH, FittedRows,
};
use tribos_core::limit_surface::RoundLimitSurface;

/// Names of the pressures, in the order of the header.
pub const PRESSURES: [&str; 5] = ["disk", "ring", "punch", "hertz", "paraboloid"];

/// One of the two types.
pub trait Type: Real + Debug {
    /// How its names end.
    const SUFFIX: &'static str;
    /// Words of the template, and what stands for them.
    const WORDS: &'static [[&'static str; 2]];

    /// The largest power of ten.
    const MOST: f64;

    fn bits(self) -> u64;
    fn from_memory(memory: &[u8]) -> Self;
    fn to_memory(self) -> Vec<u8>;
    /// The shortest decimal that is this number.
    fn shortest(self) -> String {
        format!("{self:?}")
    }
    /// The same in C.
    fn literal(self) -> String;
    /// Fitted rows where spinning leads and where sliding does.
    fn rows(rows: &FittedRows) -> [&'static [[Self; 4]]; 2];
    fn atanh() -> &'static [Self];
    fn bend() -> &'static [[Self; 2]];
}

impl Type for f32 {
    const SUFFIX: &'static str = "f32";
    const MOST: f64 = 38.0;
    const WORDS: &'static [[&'static str; 2]] = &[
        ["REAL", "float"],
        ["BITS", "unsigned int"],
        ["ABS", "fabsf"],
        ["SQRT", "sqrtf"],
        ["COPYSIGN", "copysignf"],
        ["EPSILON", "1.1920929e-7f"],
        ["LEAST_NORMAL", "1.1754944e-38f"],
        ["LEAST_SPEED", "1e-15f"],
        ["INFINITY_BITS", "0x7f800000u"],
        ["NAN_BITS", "0x7fc00000u"],
        ["UNIT_BITS", "0x4b000000u"],
        ["UNIT_AND_BIAS", "8388735.0f"],
        ["DIGITS", "23"],
        ["BIAS", "127"],
        ["IS_SINGLE", "1"],
        ["AS_BITS", "__float_as_uint"],
        ["AS_REAL", "__uint_as_float"],
    ];

    fn literal(self) -> String {
        format!("{self:?}f")
    }
    fn bits(self) -> u64 {
        u64::from(self.to_bits())
    }
    fn from_memory(memory: &[u8]) -> Self {
        Self::from_ne_bytes(memory.try_into().expect("a number"))
    }
    fn to_memory(self) -> Vec<u8> {
        self.to_ne_bytes().to_vec()
    }
    fn rows(rows: &FittedRows) -> [&'static [[f32; 4]]; 2] {
        rows.single
    }
    fn atanh() -> &'static [f32] {
        &ATANH_SINGLE
    }
    fn bend() -> &'static [[f32; 2]] {
        &BEND_SINGLE
    }
}

impl Type for f64 {
    const SUFFIX: &'static str = "f64";
    const MOST: f64 = 308.0;
    const WORDS: &'static [[&'static str; 2]] = &[
        ["REAL", "double"],
        ["BITS", "unsigned long long"],
        ["ABS", "fabs"],
        ["SQRT", "sqrt"],
        ["COPYSIGN", "copysign"],
        ["EPSILON", "2.220446049250313e-16"],
        ["LEAST_NORMAL", "2.2250738585072014e-308"],
        ["LEAST_SPEED", "1e-140"],
        ["INFINITY_BITS", "0x7ff0000000000000u"],
        ["NAN_BITS", "0x7ff8000000000000u"],
        ["UNIT_BITS", "0x4330000000000000u"],
        ["UNIT_AND_BIAS", "4503599627371519.0"],
        ["DIGITS", "52"],
        ["BIAS", "1023"],
        ["IS_SINGLE", "0"],
        ["AS_BITS", "(unsigned long long)__double_as_longlong"],
        ["AS_REAL", "__longlong_as_double"],
    ];

    fn literal(self) -> String {
        self.shortest()
    }
    fn bits(self) -> u64 {
        self.to_bits()
    }
    fn from_memory(memory: &[u8]) -> Self {
        Self::from_ne_bytes(memory.try_into().expect("a number"))
    }
    fn to_memory(self) -> Vec<u8> {
        self.to_ne_bytes().to_vec()
    }
    fn rows(rows: &FittedRows) -> [&'static [[f64; 4]]; 2] {
        rows.double
    }
    fn atanh() -> &'static [f64] {
        &ATANH
    }
    fn bend() -> &'static [[f64; 2]] {
        &BEND
    }
}

/// Terms of force and torque and of force and slope of a pressure.
pub fn fitted(pressure: &str) -> [FittedRows; 2] {
    match pressure {
        "disk" => CoulombDisk::FITTED,
        "ring" => CoulombRing::FITTED,
        "punch" => CoulombPunch::FITTED,
        "hertz" => CoulombHertz::FITTED,
        "paraboloid" => CoulombParaboloid::FITTED,
        other => panic!("no pressure {other}"),
    }
}

/// The disk's terms for a first step.
pub fn rough() -> FittedRows {
    let [_, slope] = CoulombDisk::FITTED;
    FittedRows {
        double: [&DISK_SLOPE_ROUGH; 2],
        ..slope
    }
}

/// What is prepared of the curve of a pressure.
pub fn curve<R: Type>(pressure: &str) -> CurveNumbers<R> {
    macro_rules! of {
        ($coupling:expr) => {
            RoundLimitSurface::new($coupling, R::ONE, R::ONE).map(|surface| surface.curve_numbers())
        };
    }
    match pressure {
        "disk" => of!(CoulombDisk),
        "ring" => of!(CoulombRing),
        "punch" => of!(CoulombPunch),
        "hertz" => of!(CoulombHertz),
        _ => of!(CoulombParaboloid),
    }
    .expect("limits and a radius of 1")
}

#[test]
fn the_constants_of_the_template_are_those_of_the_types() {
    assert_eq!(f32::EPSILON, 1.1920929e-7);
    assert_eq!(f32::MIN_POSITIVE, 1.1754944e-38);
    assert_eq!(f64::EPSILON, 2.220446049250313e-16);
    assert_eq!(f64::MIN_POSITIVE, 2.2250738585072014e-308);
    assert_eq!((1_u32 << 23) as f32 + 127.0, 8388735.0);
    assert_eq!((1_u64 << 52) as f64 + 1023.0, 4503599627371519.0);
}
