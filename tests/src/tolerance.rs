//! Every bound of the tests, once, with its reason.
//!
//! Bounds are measured worst cases rounded up; [`crate::worst::Worst`] prints the measured value
//! and its place beside each (`cargo test -p tribos-tests -- --nocapture`). *ulp* is the gap above
//! the reference value; *relative* is the distance over the reference; *of F/v* is the distance
//! over the drag F/v, the natural unit of all derivatives, which themselves pass through zero.

/// A bound with its reason.
#[derive(Clone, Copy, Debug)]
pub struct Bound {
    /// The largest error allowed.
    pub limit: f64,
    /// Why it is not smaller.
    pub reason: &'static str,
}

macro_rules! bounds {
    ($($(#[$doc:meta])* $name:ident = $limit:expr, $reason:expr;)*) => {
        $($(#[$doc])* pub const $name: Bound = Bound { limit: $limit, reason: $reason };)*
    };
}

bounds! {
    /// Coulomb table and table of α = 0, ulp.
    COULOMB_TABLE_ULPS = 5.0, "promised in coupling::table; Horner scheme and two products";
    /// Tables of −0.75 ≤ α ≤ 10, relative.
    TABLE = 1.5e-15, "7 ulp: speed power, Horner scheme, weights";
    /// Tables of α < −0.75, relative.
    TABLE_DEEP = 1.2e-14, "torque near equal speeds: its singular part is conditioned like 1/(1+alpha)";
    /// Elliptic integrals by the arithmetic-geometric mean, relative.
    AGM = 1e-14, "promised in coupling::compact; rounds of the mean add up near equal speeds";
    /// Compact powers of −0.99 ≤ α ≤ 30, relative.
    COMPACT = 2.5e-15, "speed power, series with compensated sums";
    /// Compact powers of α > 30, relative.
    COMPACT_ENDS = 1e-14, "powers of the ratio with steep exponents";
    /// Quadrature for 0 ≤ α ≤ 5, relative.
    QUADRATURE = 4e-9, "1e-8 is promised; 8 radii, worst just below v = 2w";
    /// Quadrature for −0.5 ≤ α < 0, relative.
    QUADRATURE_FALLING = 7e-8, "2e-6 is promised; integrable singularity on the rim";
    /// Quadrature's Jacobian for α ≥ 0, of F/v.
    QUADRATURE_JACOBIAN = 2e-6, "1e-5 is promised; logarithmic derivative near equal speeds";

    /// Jacobian of tables and compact forms at the tables' arguments, relative.
    JACOBIAN = 1e-12, "derivative of a degree-12 polynomial; relative to entries that pass through zero";
    /// The same for α < −0.95.
    JACOBIAN_DEEP = 5e-12, "slope at equal speeds is z^(1+alpha): z^0.01 carries rounding of z from all octaves";
    /// Jacobian of tables and compact forms on a dense sweep, of F/v.
    JACOBIAN_DENSE = 2e-13, "economized polynomials differentiated at the cell borders";
    /// A tier against the other one on a dense sweep, relative.
    TIERS_AGREE = 2.2e-15, "sum of the two tiers' own errors";
    /// AGM tier against the Coulomb table, ulp.
    AGM_AGAINST_TABLE_ULPS = 48.0, "cross-check only; 5.2e-15, the AGM tier's own error";
    /// Tiers against the rim mean, relative; α ≥ −0.5.
    RIM_MEAN = 4e-15, "double-exponential rule in f64";
    /// Tiers against the rim mean, relative; α < −0.5.
    RIM_MEAN_DEEP = 1e-12, "the rule's end cut off where the integrand still grows like theta^(alpha-1+2)";

    /// f32 table of −0.75 ≤ α ≤ 5 and compact form of −0.75 ≤ α ≤ 10, ulp of f32.
    SINGLE_ULPS = 5.0, "speed power, Horner scheme, weights, in f32";
    /// f32 table of 5 < α ≤ 10, ulp of f32.
    SINGLE_STEEP_ULPS = 8.0, "the profile rises by a factor 40 on one cell of degree 5; 7.05 in a sweep of 800,000 ratios";
    /// f32 tables of −0.99 ≤ α < −0.75, ulp of f32.
    SINGLE_DEEP_ULPS = 66.0, "1 - h^2 is rounded before the torque subtracts from it: 1/(1+alpha)";
    /// f32 AGM tier, relative.
    SINGLE_AGM = 2e-6, "5e-6 is promised; rounds of the mean add up near equal speeds";
    /// f32 Jacobian of −0.75 ≤ α ≤ 5, of F/v.
    SINGLE_JACOBIAN = 6e-6, "derivative of a polynomial of degree 4 (alpha 0) or 5; 5.3e-6 in a sweep of 800,000 ratios";

    /// Every row of hard_twists.csv, force and torque, relative.
    HARD_WRENCH = 2e-15, "as TABLE, at the ends of the range of f64";
    /// Every row of hard_twists.csv, derivatives, relative.
    HARD_JACOBIAN = 1e-12, "as JACOBIAN";

    /// Identities between outputs (Euler, reciprocity, scaling), relative to the largest term.
    IDENTITY = 4e-15, "both sides round; 18 ulp";
    /// Jacobian against central differences with step 2⁻¹⁷ of the speed, of F/v.
    DIFFERENCES = 2e-8, "truncation: third derivative x 2^-34/6; rounding 1e-16 x 2^17";
    /// The same for contacts in the plane, step 2⁻²⁰ of the speed, of the matrix norm.
    DIFFERENCES_IN_PLANE = 1e-6, "Coulomb's third derivative near equal speeds and near zero of either";
    /// What differs by a handful of roundings, relative.
    ROUNDING = 1e-15, "4 to 5 ulp";
    /// Largest eigenvalue of a negative semidefinite Jacobian, of its norm.
    EIGENVALUE = 1e-14, "an exact zero eigenvalue rounds to either side";

    /// K, D, C of the elliptic integrals, ulp.
    ELLIPTIC_ULPS = 4.5, "8 is promised in special::elliptic; five rounds of the mean and the series";
    /// B and E of the elliptic integrals, ulp of K.
    ELLIPTIC_B_ULPS = 1.5, "4 is promised in special::elliptic; a difference of terms of size K";
    /// Gauss function with the disk's parameters, relative.
    GAUSS = 4e-16, "4e-15 is promised; compensated sums leave the last rounding";
    /// Its slope, relative.
    GAUSS_SLOPE = 2.5e-15, "not compensated within an expansion; 52 expansions at z = 2^-52";
    /// Gauss function at x = 1 with parameters of exponents up to 48, relative.
    GAUSS_RISING = 1.5e-15, "compensated sums; the expected value is a product of 50 factors";
    /// The same up to 128.
    GAUSS_STEEP = 4e-15, "promised in special::hypergeometric; the series itself keeps 1e-15";
    /// Legendre's relation, of K(m)K(1-m).
    LEGENDRE = 1e-15, "four products of integrals of a few ulp";

    /// Odd exponents against their polynomials, relative.
    POLYNOMIAL = 1e-15, "as TABLE, and the rounding of the polynomial";
    /// The thesis' formulas in f64 against the kernel, relative.
    FORMULA = 4e-13, "K and E cancel in the printed forms, most at the ends of the range tried";
    /// Observed order of the approach to table 3.1 between ε = 1e-2 and 1e-3, absolute.
    ORDER_OF_LIMITS = 2e-3, "the next order, eps^4, and rounding at eps = 1e-3";
    /// Slopes next to ε = 1 against those at 1, relative.
    SLOPE_AT_ONE = 2e-14, "they approach their limit like z ln z, 1e-14 one ulp away";
    /// C_α(1e±6) against its limits, absolute.
    LIMIT_OF_INERTIA = 1e-11, "corrections of order 1e-12";
    /// The cubic torque at v = 4e5 w against w v², relative.
    FAST_SLIDING = 1e-10, "correction of order (w/v)^2/3";
    /// A value quoted in kernel-math.md with five decimals, absolute.
    QUOTED_VALUE = 5e-6, "rounding of the quotation";
    /// A factor quoted in errata.md with four digits, absolute.
    QUOTED = 6e-4, "rounding of the quotation";

    /// Finite fixed points, relative.
    FIXED_POINT = 5e-15, "1e-13 is promised; last digits of slope over value";
    /// Growth at a fixed point, of its ratio.
    GROWTH_AT_FIXED_POINT = 1e-12, "rounding of C_alpha over its distance 1e-6 from the interval's end";
    /// The ratio recovered from its own inertia, relative.
    INERTIA_INVERTED = 1e-11, "slope of C_alpha vanishes like eps at zero";
    /// Mean fixed point of α = 1 ± 1e-4 against the golden ratio, absolute.
    GOLDEN_MEAN = 1e-8, "order (alpha - 1)^2";
    /// Fixed points of α within 1e-6 of 1 against the golden ratio, absolute.
    GOLDEN_RATIO = 1e-6, "order |alpha - 1|";

    /// Stop time, distance and angle, relative.
    STOP = 2e-13, "1e-14 is promised for one call; steps and the older constants add";
    /// Final ratio of a body whose ratio goes to zero, absolute; its inverse where it grows.
    STOP_PURE = 1e-6, "the slower motion dies with a power of the other, not at once";
    /// Final ratio, relative.
    STOP_RATIO = 1e-13, "direction at the last substep, where it turns by less than 8 roundings";
    /// Rest pose of a solution of the inverse problem against its target, of the distance and of
    /// the angle turned.
    INVERSE_POSE = 1e-13, "1e-12 is promised; two motions to rest of 1e-14 each, and the ratio met to 1e-15";
    /// Launch recovered from its own rest pose, of the speed scale.
    INVERSE_LAUNCH = 3e-13, "as INVERSE_POSE over the slope of the rest's direction";
    /// Jacobian of the rest pose against differences of order 6, of unit speed.
    INVERSE_JACOBIAN = 3e-9, "1e-8 is promised; rounding of the differences over their step";
    /// The same within 5 % of equal speeds.
    INVERSE_JACOBIAN_EQUAL = 1e-3, "the differences' error: the law's own slopes are not smooth there";
    /// A run cut into steps against one call, relative.
    STEPS_AGREE = 2e-13, "thousands of roundings of the state";
    /// Free decay for α ≥ 1 against eq. 3.34, relative.
    DECAY = 2e-13, "local error 4 ulp a substep; the logarithm of the speed lost multiplies it";
    /// f32 slider against the f64 one, relative.
    SINGLE_STOP = 5e-6, "f32 wrench of 3 ulp, about 20 substeps";
    /// Stop time of the fixed-step method, in steps.
    VERLET_STEPS = 1.5, "first order at the stop: the last step ends on the clock";
    /// Observed order of convergence against the expected one, absolute.
    ORDER = 0.1, "next order and rounding";
    /// Pure sliding of α < 1 against its closed form, relative.
    PURE_SLIDING = 4e-15, "closes in one step; a power and three products";
    /// Work of friction by Simpson's rule against energy lost, relative to the energy.
    WORK = 1e-11, "Simpson's rule over 1 ms of 0.4 s, worst next to the stop";
}
