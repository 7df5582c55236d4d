//! Every tolerance of the tests, defined once, with its reason.
//!
//! Tolerances are measured worst cases rounded up; [`crate::worst::Worst`] prints the measured value
//! and its argument beside each (`cargo test -p tribos-tests -- --nocapture`). *ulp* is the gap above
//! the reference value; *relative* is the error over the reference; *of F/v* is the error
//! over the drag F/v, the natural unit of all derivatives, which themselves pass through zero.

/// A tolerance with its reason.
#[derive(Clone, Copy, Debug)]
pub struct Bound {
    /// The largest error allowed.
    pub limit: f64,
    /// Reason why it is not smaller.
    pub reason: &'static str,
}

macro_rules! bounds {
    ($($(#[$doc:meta])* $name:ident = $limit:expr, $reason:expr;)*) => {
        $($(#[$doc])* pub const $name: Bound = Bound { limit: $limit, reason: $reason };)*
    };
}

bounds! {
    /// Time, path length and angle of a body on a path, each relative to itself.
    MINOR_MOTION = 2e-12, "promised for journeys; errors of steps, each at most 1e-13, add up";
    /// Table of α = 0 on the disk, ulp.
    TABLE_DRY_ULPS = 5.0, "promised in coupling::table";
    /// Tables of −0.75 ≤ α ≤ 10, relative.
    TABLE = 1.5e-15, "7 ulp: speed power, Horner scheme, weights";
    /// Tables of α < −0.75, relative.
    TABLE_DEEP = 1.2e-14, "torque near equal speeds: its singular part is conditioned like 1/(1+alpha)";
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

    /// Polygons up to 10 times as long as wide, uniform pressure: of μN and μN (R + |centre|).
    POLYGON = 3e-15, "6e-15 is promised, for wedges; opposite edges cancel: 1.9e-15 at 10:1 among 17,500 twists, 7e-16 for other shapes";
    /// Their Jacobian, of its largest entry.
    POLYGON_JACOBIAN = 4e-14, "promised in coupling::flat; next to an edge its slope is the logarithm of the distance: 3.1e-14 at 10:1 among 17,500 twists";
    /// The same under linear pressure.
    POLYGON_LINEAR = 4e-15, "8e-15 is promised, for wedges; long edges cancel: 3.0e-15 at 10:1, 1.1e-15 for other shapes";
    /// Their Jacobian, of its largest entry.
    POLYGON_LINEAR_JACOBIAN = 5e-14, "promised in coupling::flat; next to an edge its slope is the logarithm of the distance: 3.0e-14 at 10:1";
    /// Bars and points: of μN and μN (R + |centre|).
    BAR = 2e-14, "promised in coupling::flat; moments about a centre up to 3 radii away cancel";
    /// Their Jacobian, of its largest entry.
    BAR_JACOBIAN = 5e-14, "promised in coupling::flat; moments about a centre up to 3 radii away cancel";
    /// Power laws of −1/2 ≤ α ≤ 3 on polygons, uniform pressure: of γN V^α, and that times R + |centre|.
    POLYGON_POWER = 5e-14, "promised in coupling::flat; opposite edges cancel: 1.4e-14 at 10:1 among 11,000 twists";
    /// Their Jacobian, of its largest entry.
    POLYGON_POWER_JACOBIAN = 1e-13, "promised in coupling::flat; moments about a centre up to 2 radii away cancel: 6.7e-14 at 10:1";
    /// The same under linear pressure.
    POLYGON_POWER_LINEAR = 1e-13, "promised in coupling::flat; moments about a centre up to 2 radii away cancel";
    /// Their Jacobian, of its largest entry.
    POLYGON_POWER_LINEAR_JACOBIAN = 2.5e-13, "promised in coupling::flat; 1.5e-13 among 11,000 twists";
    /// Power laws of −7/8 ≤ α ≤ 10 on polygons, either pressure.
    POLYGON_POWER_ENDS = 5e-13, "promised in coupling::flat; divided by 1 + alpha";
    /// Their Jacobian, of its largest entry.
    POLYGON_POWER_ENDS_JACOBIAN = 1e-12, "promised in coupling::flat; divided by 1 + alpha";
    /// Power laws of 0 < α ≤ 3 on polygons in f32.
    POLYGON_POWER_SINGLE = 4e-6, "promised in coupling::flat; opposite edges cancel, most where the shape is long";
    /// Their Jacobian, of its largest entry.
    POLYGON_POWER_SINGLE_JACOBIAN = 8e-6, "promised in coupling::flat; moments about a centre up to 2 radii away cancel";
    /// A strip 1000 times as long as wide, as above.
    SLIVER = 5e-13, "promised in coupling::flat: the aspect ratio times 5e-16, long edges cancel";
    /// Its Jacobian, of its largest entry.
    SLIVER_JACOBIAN = 4e-12, "promised in coupling::flat: the aspect ratio times 4e-15";
    /// The same under linear pressure.
    SLIVER_LINEAR = 5e-13, "promised in coupling::flat: the aspect ratio times 5e-16, long edges cancel";
    /// Its Jacobian, of its largest entry.
    SLIVER_LINEAR_JACOBIAN = 2e-12, "promised in coupling::flat: the aspect ratio times 2e-15";
    /// Push over gauge plus the friction of its motion, of μN with the torque over the largest arm.
    PATCH_SURFACE = 1e-13, "promised in limit_surface::ShapeLimitSurface; Newton's residual and the gauge's rounding";
    /// Gauge and normal of points, of the limits.
    POINT_SURFACE = 1e-9, "promised in limit_surface::ShapeLimitSurface between facets";
    /// Projections onto the surface of points, of the wrench.
    POINT_PROJECTION = 1e-8, "promised in limit_surface::ShapeLimitSurface between facets";
    /// Meshes of triangles up to 5 times as long as wide: of μN and μN (R + |centre|).
    MESH = 2e-14, "promised in patch::mesh; next to the centre of rotation a triangle loses the square of its distance over its size";
    /// Their Jacobian, of its largest entry.
    MESH_JACOBIAN = 2.5e-13, "promised in patch::mesh; logarithm of the distance from edges, sums about a centre up to 3 radii away";
    /// Needles 40 times as long as wide, and triangles of 1e-4 radii with a tenth of the load.
    MESH_UNEVEN = 2e-12, "a rounding error of the radius is 1e-12 of such a triangle next to the centre of rotation";
    /// Their Jacobian, of its largest entry.
    MESH_UNEVEN_JACOBIAN = 1e-10, "the same, over the distance from an edge";
    /// Meshes in f32.
    MESH_SINGLE = 1e-5, "promised in patch::mesh";
    /// Their Jacobian in f32, of its largest entry.
    MESH_SINGLE_JACOBIAN = 2e-5, "promised in patch::mesh";
    /// Yaw limits under any pressure, from both sides, of μN times the radius.
    ANY_PRESSURE_LIMIT = 2e-11, "1e-9 is promised; twice the corners over the last weight of the barrier";
    /// Supports under any pressure, relative.
    ANY_PRESSURE_SUPPORT = 2e-15, "1e-14 is promised; shares and speeds, each rounded a few times";
    /// Yaw limits under any pressure in f32, of μN times the radius.
    ANY_PRESSURE_SINGLE = 2e-3, "promised in limit_surface::AnyPressure; the barrier's last weight, of single precision, next to the largest force";
    /// Polygons in f32, of μN and μN (R + |centre|).
    POLYGON_SINGLE = 1.5e-6, "opposite edges cancel: 1.1e-6 at 10:1, 4e-7 for other shapes; 2.5e-6 is promised, for wedges";
    /// The same under linear pressure.
    POLYGON_LINEAR_SINGLE = 2e-6, "long edges cancel: 1.5e-6 at 10:1, 5e-7 for other shapes; 4e-6 is promised, for wedges";
    /// Their Jacobian, of its largest entry, under either pressure.
    POLYGON_SINGLE_JACOBIAN = 1e-5, "logarithm of the distance from an edge, which single precision rounds";

    /// Jacobian of tables and compact forms at the tables' arguments, relative.
    JACOBIAN = 1e-12, "derivative of a degree-12 polynomial; relative to entries that pass through zero";
    /// The same for α < −0.95.
    JACOBIAN_DEEP = 5e-12, "slope at equal speeds is z^(1+alpha): z^0.01 carries rounding of z from all octaves";
    /// Jacobian of tables and compact forms on a dense sweep, of F/v.
    JACOBIAN_DENSE = 2e-13, "economized polynomials differentiated at the cell borders";
    /// Two tiers compared on a dense sweep, relative.
    TIERS_AGREE = 2.2e-15, "sum of the two tiers' own errors";
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
    /// f32 Jacobian of −0.75 ≤ α ≤ 5, of F/v.
    SINGLE_JACOBIAN = 6e-6, "derivative of a polynomial of degree 4 (alpha 0) or 5; 5.3e-6 in a sweep of 800,000 ratios";

    /// Every row of hard_twists.csv, force and torque, relative.
    HARD_WRENCH = 2e-15, "as TABLE, at the ends of the range of f64";
    /// Every row of hard_twists.csv, derivatives, relative.
    HARD_JACOBIAN = 1e-12, "as JACOBIAN";

    /// Identities between outputs (Euler, reciprocity, scaling), relative to the largest term.
    IDENTITY = 4e-15, "both sides round; 18 ulp";
    /// Jacobians of patches in the plane against differences of sixth order, of the largest entry.
    DIFFERENCES = 1e-9, "steps of a 64th of the distance from the nearest kink, to the sixth power; rounding of a sliver's wrench over 1e-3";
    /// Torque of a slow spin of a patch in the plane, of the mean square of the distance.
    SLOW_SPIN = 3e-15, "a second moment of the patch and a few roundings";
    /// The same of polygons under dry friction.
    SLOW_SPIN_DRY = 1.5e-15, "as SLOW_SPIN, without powers";
    /// Friction of a patch in the plane in another unit of speed, of the scale of the wrench.
    UNITS = 1e-15, "powers of two change nothing but speeds below the normal range";
    /// Its Jacobian, of the largest entry.
    UNITS_JACOBIAN = 1e-14, "speeds below the normal range are rounded";
    /// Twelve points summed one by one, of the scale of the wrench.
    NODES = 2e-15, "a dozen roundings of terms up to the load";
    /// Their Jacobian, of its largest entry.
    NODES_JACOBIAN = 1e-14, "a dozen terms, each over the speed of its point, whose rounding is relative to the centre's distance";
    /// Jacobian of a round patch against itself in a frame that is turned, of its largest entry.
    ROUND_TURNED_JACOBIAN = 6.4e-14, "turning rounds the speed by an ulp or two, which the law raises to its power";
    /// Derivatives of pressures against twice extrapolated differences, of F/v times the speeds' ratio.
    RICHARDSON = 2e-12, "differences of steps down to 4e-4: 1e-16/4e-4, doubled by each extrapolation";
    /// Quantities that differ by a few rounding errors, relative.
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

    /// Gauge of surface points known to 32 digits, absolute.
    GAUGE = 1e-15, "dissipation of the form and three roundings";
    /// Velocity ratio recovered from its own friction, relative.
    NORMAL = 2e-15, "the form's error over the curvature of the surface";
    /// The same for a ring, whose slopes are infinite at equal speeds.
    NORMAL_RING = 4e-15, "the last Newton step only divides its error by a logarithm";
    /// Gauge of projections against 1, in units of EPSILON; the collar is 64.
    ON_SURFACE_ULPS = 8.0, "surface point and gauge round a few times each";
    /// The same for rings, annuli and patches in the plane.
    ON_SURFACE_PLANE_ULPS = 56.0, "their noise, in point and gauge";
    /// The same for points, whose gauge between facets is right to POINT_SURFACE.
    ON_SURFACE_POINT_ULPS = 4.5e6, "POINT_SURFACE in units of EPSILON";
    /// Displacement across the normal, of the set's size and the displacement.
    ACROSS_NORMAL = 1e-15, "normal and surface point round a few times";
    /// Friction of a projection's normal against the projection, of the set's size.
    FRICTION_OF_NORMAL = 2e-14, "noise of rings and annuli near equal speeds; 6.7e-16 on the disk";
    /// Growth of the distance of two wrenches by projection in f32, of the set's size.
    EXPANSION_SINGLE = 4e-7, "surface points round to a few ulp of the limits";
    /// f32 projections against f64, of the set's size.
    SINGLE_PROJECTION = 5e-7, "surface points round to a few ulp of the limits";
    /// The ellipsoid against its closed forms, relative.
    ELLIPSOID = 2e-15, "a dozen roundings";
    /// Published errors of the ellipsoid, relative.
    QUOTED_ELLIPSOID = 4e-3, "rounding of the quotation to three digits";
    /// Tables of pressures −1 ≤ q ≤ 6, −0.5 ≤ α ≤ 3, relative.
    ROUND_TABLE = 4e-15, "series continued to every cell; worst for the ring at alpha = -0.5";
    /// The same for −0.9 ≤ α ≤ 10.
    ROUND_TABLE_ENDS = 3e-14, "torque: terms of steep exponents and high orders alternate; 1/(1+alpha) towards -1";
    /// The same for α = −0.99.
    ROUND_TABLE_DEEP = 1.2e-13, "torque while sliding leads is conditioned like 1/(1+alpha)";
    /// Derivatives of tables of pressures at the tables' arguments, of the larger of themselves and F/v.
    ROUND_JACOBIAN = 1.5e-12, "ring at alpha = -0.9: slope of a polynomial of a function like z^(1+alpha+q)";
    /// The same on a dense sweep, α ≥ −0.5.
    ROUND_JACOBIAN_DENSE = 8e-12, "ring at the cell borders, where an economized polynomial's slope is worst";
    /// The same for −0.99 ≤ α < −0.5.
    ROUND_JACOBIAN_DEEP = 1.2e-10, "as ROUND_JACOBIAN_DENSE, of a function steeper still";
    /// Gradient of vG of tables of pressures, of the larger of itself and G.
    ROUND_LATERAL_JACOBIAN = 3e-12, "the slope enters with the factor z";
    /// Compact powers of pressures, −0.75 ≤ α ≤ 10, relative.
    ROUND_COMPACT = 2.5e-15, "as COMPACT";
    /// The same at α = −0.9.
    ROUND_COMPACT_DEEP = 1e-14, "promised in coupling::compact; ring: torque is (1+alpha)/2 of two terms that cancel, 7.2e-15 at v = 1.044 w";
    /// Derivatives of compact powers of pressures, of the larger of themselves and F/v.
    ROUND_COMPACT_JACOBIAN = 2e-13, "ring at alpha = 0.001 and equal speeds: 1/alpha against a logarithm that almost cancels";
    /// Force of fitted forms, ulp.
    FORM_FORCE_ULPS = 4.0, "promised in coupling::coulomb";
    /// The same of the ring.
    FORM_FORCE_RING_ULPS = 9.0, "promised in coupling::coulomb: the rounding of z next to equal speeds";
    /// Torque of fitted forms, ulp.
    FORM_TORQUE_ULPS = 5.0, "promised in coupling::coulomb";
    /// The same of ring and paraboloid.
    FORM_TORQUE_ENDS_ULPS = 7.0, "promised in coupling::coulomb";
    /// Lateral function of fitted forms, and with force and torque on a dense sweep, relative.
    FORM = 2e-15, "FORM_FORCE_RING_ULPS; the sweep's oracle, compact powers, adds its own error";
    /// Derivatives of fitted forms, of the larger of themselves and F/v.
    FORM_JACOBIAN = 3e-15, "promised in coupling::coulomb";
    /// f32 fitted forms, ulp of f32.
    SINGLE_FORM_ULPS = 5.0, "promised in coupling::coulomb";
    /// f32 tables of pressures −1 ≤ q ≤ 2, −0.75 ≤ α ≤ 3, ulp of f32.
    SINGLE_ROUND_ULPS = 10.0, "as SINGLE_ULPS; the profile of q = 2 falls to a quarter over the cells";
    /// The same at α = 5.
    SINGLE_ROUND_STEEP_ULPS = 25.0, "terms of alternating sign in cells of degree 5";
    /// The same for q ≤ 6 and −0.75 ≤ α ≤ 10.
    SINGLE_ROUND_ENDS_ULPS = 220.0, "as SINGLE_ROUND_STEEP_ULPS: the profile spans a factor 100";
    /// f32 compact powers of pressures, −0.75 ≤ α ≤ 10, ulp of f32.
    SINGLE_ROUND_COMPACT_ULPS = 10.0, "speed power; the ratio's rounding near equal speeds for the ring";
    /// F, T and G of tiers at speeds of the whole range, −0.9 ≤ α ≤ 10, relative.
    RANGES = 1e-14, "as ROUND_TABLE_ENDS";
    /// Their derivatives, relative.
    RANGES_JACOBIAN = 2e-12, "as ROUND_JACOBIAN";
    /// The same in f32.
    RANGES_SINGLE = 4e-6, "speed power over the whole range of f32";
    /// The same in f32.
    RANGES_SINGLE_JACOBIAN = 2.7e-5, "as RANGES_SINGLE";
    /// Quadrature at speeds of the whole range, −0.75 ≤ α ≤ 10, relative.
    QUADRATURE_RANGES = 4e-4, "integrable singularity on the rim at alpha = -0.75; 8 radii at alpha = 10";
    /// Its derivatives, of the larger of themselves and F/v.
    QUADRATURE_RANGES_JACOBIAN = 2e-3, "as QUADRATURE_RANGES";
    /// Leaning pressures against sums over the patch, of force plus torque.
    LEANING = 2.5e-14, "sums of 12,000 elements: the oracle's own rounding";
    /// Pressure gradient against the force that it balances, relative.
    BALANCE = 1.2e-15, "quotients and rotations of a handful of roundings";
    /// Lateral function of the uniform disk, relative.
    DISK_LATERAL = 4e-15, "as ROUND_TABLE, up to alpha = 9";
    /// Annuli, relative, of the factor 2/(1−k).
    ANNULUS = 6e-16, "two disks' roundings; 3e-16 is half an ulp of either";
    /// Annuli above 15/16, relative, without that factor, for α ≥ 0.
    THIN_ANNULUS = 6e-15, "means over rings of the disk's wrench and slopes: a table's are right to 5e-15 at an end of a cell";
    /// The same for α = −1/2.
    THIN_ANNULUS_WEAKENING = 1e-13, "rings go as the root of their distance from the centre of rotation, 1e-6 here";
    /// Derivatives of annuli, of the larger of themselves and F/v, of the factor 2/(1−k).
    ANNULUS_JACOBIAN = 2e-14, "slopes of the disk's table, whose two cells may end between the edges of a thin band";
    /// Tables of polynomial pressures of degree 4, relative.
    POLYNOMIAL_TABLE = 2e-15, "as ROUND_TABLE, times the sum of the shares' magnitudes";

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

    /// Slopes of local laws against extrapolated differences, relative to |slope| + friction/speed.
    LAW_SLOPE = 4e-13, "sixth-order differences with step 2^-7 of the speed: rounding 1e-16 x 2^9, truncation h^6";
    /// Local laws in f32 against f64, relative to friction; slopes to |slope| + friction/speed.
    LAW_SINGLE = 5e-7, "rounding of the parameters, the most by the power of the speed and by cancelling slopes";
    /// Local laws against their formula in extended precision, relative.
    LAW = 6e-15, "rate-and-state: 2^-53 x mu/a = 60 in the exponent";
    /// Ages after a step against extended precision, relative.
    AGE = 5e-16, "an exponential and four products";
    /// Steps of laws with memory in f32 against f64, relative to the largest term.
    STEP_SINGLE = 2e-6, "2^-24 x 16 decay times in the exponent while the start is remembered";
    /// Steps of an exact solution in one or in many parts, relative.
    PARTS_OF_A_STEP = 2e-14, "64 roundings of the state";
    /// Exact steps against Runge-Kutta of fourth order, relative to the steady value.
    LAW_ODE = 2e-13, "the oracle: 4000 roundings, and h^4/120 for h = 1/400 of the decay time";
    /// Linear law on the disk by quadrature against its closed form, relative.
    LINEAR_ON_DISK = 2e-13, "6e-14 next to equal speeds, where the mean that is 0 for a centre outside is so to the rule's error; else polynomials are exact at the nodes";

    /// Force, and the larger of force and torque, of laws with several regimes by quadrature, relative.
    REGIMES_ON_DISK = 4e-9, "1e-8 is promised; a Stribeck speed of a tenth of the speeds on the disk";

    /// Finite fixed points, relative.
    FIXED_POINT = 5e-15, "1e-13 is promised; last digits of slope over value";
    /// Ends of C_α under pressures, relative.
    INERTIA_ENDS = 2e-15, "2q + 3 + alpha cancels for the ring and alpha -> -1";
    /// Finite fixed points by tables of pressures, relative.
    TABLE_FIXED_POINT = 1e-12, "balance from the table's slope, as ROUND_JACOBIAN";
    /// Finite fixed points by compact powers of pressures, relative.
    PRESSURE_FIXED_POINT = 3e-15, "as FIXED_POINT";
    /// Balance C F = ε T at the fixed point of one tier by force and torque of the other, relative.
    FIXED_POINT_RESIDUAL = 6e-13, "as TABLE_FIXED_POINT";
    /// Growth at a fixed point, of its ratio.
    GROWTH_AT_FIXED_POINT = 1e-12, "rounding of C_alpha over its distance 1e-6 from the interval's end";
    /// The ratio recovered from its own inertia, relative.
    INERTIA_INVERTED = 1e-11, "slope of C_alpha vanishes like eps at zero";
    /// Mean fixed point of α = 1 ± 1e-4 against the golden ratio, absolute.
    GOLDEN_MEAN = 1e-8, "order (alpha - 1)^2";
    /// Fixed points of α within 1e-6 of 1 against the golden ratio, absolute.
    GOLDEN_RATIO = 1e-6, "order |alpha - 1|";

    /// Stop time, distance and angle, relative.
    STOP = 2e-13, "1e-13 is promised for one call; steps and the older constants add";
    /// Time, distance and angle of launches of any ratio, each relative.
    REST = 1e-13, "the promise; the table itself is good to some 1e-14";
    /// Time, distance and angle to rest of annuli, and states on the way, relative.
    ANNULUS_REST = 1e-11, "1e-8 is promised; the inner edge is a kink of the law that no panel ends at; thin bands cancel";
    /// Final ratio of a body whose ratio goes to zero, absolute; its inverse where it grows.
    STOP_PURE = 1e-6, "the slower motion dies with a power of the other, not at once";
    /// Final ratio, relative.
    STOP_RATIO = 1e-13, "rounding of C_alpha over its slope";
    /// Final ratio under pressures, relative.
    PRESSURE_STOP_RATIO = 1.7e-14, "as STOP_RATIO";
    /// Rest pose of a solution of the inverse problem against its target, of the distance and of
    /// the angle turned.
    INVERSE_POSE = 1e-13, "1e-12 is promised; two motions to rest of 1e-13 each, and the ratio met to 1e-15";
    /// The same where the two paths differ by up to 98 decades, each relative.
    INVERSE_FAR = 1e-12, "promised; rounding of the logarithm of their ratio, 3e-14, and of its root";
    /// Launch recovered from its own rest pose, of the speed scale.
    INVERSE_LAUNCH = 3e-13, "as INVERSE_POSE over the slope of the rest's direction";
    /// Jacobian of the rest pose against differences of order 6, of unit speed.
    INVERSE_JACOBIAN = 3e-9, "1e-8 is promised; rounding of the differences over their step";
    /// The same within 5 % of equal speeds.
    INVERSE_JACOBIAN_EQUAL = 1e-3, "the differences' error: the law's own slopes are not smooth there";
    /// A run cut into steps against one call, relative.
    STEPS_AGREE = 2e-13, "thousands of roundings of the state";
    /// Free decay for α ≥ 1 against eq. 3.34, relative.
    DECAY = 2e-13, "the logarithm of the speed lost multiplies its rounding";
    /// f32 slider against the f64 one, relative.
    SINGLE_STOP = 5e-6, "f32 wrench of 3 ulp, about ten panels";
    /// f32 slider after a time against the f64 one, relative, in f32 epsilons; speeds over their condition.
    SINGLE_ADVANCE_ULPS = 8.0, "1e-6 is promised where a few steps do; each adds half an ulp and a wrench of 3 ulp";
    /// Stop time of the fixed-step method, in steps.
    VERLET_STEPS = 1.5, "first order at the stop: the last step ends on the clock";
    /// Observed order of convergence against the expected one, absolute.
    ORDER = 0.1, "next order and rounding";
    /// Pure sliding of α < 1 against its closed form, relative.
    PURE_SLIDING = 4e-15, "closes in one step; a power and three products";
    /// Work of friction by Simpson's rule against energy lost, relative to the energy.
    WORK = 1e-11, "Simpson's rule over 1 ms of 0.4 s, worst next to the stop";

    /// Power that friction gives at the mean motion of a step, of force limit times speed.
    STEP_POWER = 2e-14, "a step that nearly ends at rest: rounding of the projection";
    /// Motion that a step without push turns about, of the motion.
    STEP_REVERSAL = 1e-14, "rounding of the projection";

    /// Impulses of a contact against the table, of P and the momentum that meets.
    CONTACT = 2e-15, "velocity, mass and projection round a dozen times";
    /// The same after turns of sliding and rolling.
    CONTACT_IN_TURNS = 5e-15, "velocities round anew in each turn";
    /// The same in f32.
    CONTACT_SINGLE = 5e-7, "as CONTACT";
    /// Friction beyond its threshold, relative.
    CONTACT_THRESHOLD = 1e-15, "the collar of 4 roundings inside which a projection moves nothing";
    /// What a second update of the same contact changes, of P and the momentum that meets.
    CONTACT_AGAIN = 3e-15, "the velocity left is rounded anew";
    /// The same in f32.
    CONTACT_AGAIN_SINGLE = 5e-7, "as CONTACT_AGAIN";
    /// Power of friction against its motion, of impulse times speed where the spheres meet.
    CONTACT_POWER = 3e-15, "a sticking contact keeps the rounding of its velocity";
    /// Motion that is not along the normal of friction's set, of all speeds that meet.
    CONTACT_LAWS = 2e-15, "velocities, block and projection round a dozen times";
    /// The same in f32.
    CONTACT_LAWS_SINGLE = 1e-6, "as CONTACT_LAWS";
    /// Momentum and angular momentum created by a contact, of what the spheres have and exchange.
    CONTACT_MOMENTUM = 3e-16, "each velocity rounds once; the arms add up to 2 ulp";
    /// Impulses of a contact turned in space, of P and the momentum that meets.
    CONTACT_TURNED = 5e-15, "the rotation's own rounding, conditioned by masses 1 to 1e9";
    /// One body followed in steps, relative to its closed form.
    CONTACT_MOTION = 3e-13, "20,000 roundings of the velocity";
    /// Work of a bond or time of a stop against its closed form, in steps.
    CONTACT_STEPS = 1.0, "the event falls between two steps";
    /// Several contacts against statics and their laws, relative.
    MANIFOLD = 1e-12, "1e-14 is asked of the last sweep; a column converges slowly";
}
