/*
 * Tribos: dry friction of bodies that slide and spin at once, for kernels on processors and on graphics cards.
 *
 * This header stands alone: nothing to link, no memory, no tables, no state; + - * /, roots and selections only, with a
 * logarithm of its own. C99, C++11 and later, CUDA, HIP, NVRTC. MIT OR Apache-2.0.
 *
 *   round patches    disk, ring, flat punch, Hertz, paraboloid: wrench, Jacobian, gauge, normal, projection, time step
 *   polygons         under uniform pressure, convex or not: the same
 *
 * All names end in _f32 (float) or _f64 (double) and begin with tribos_kernel_, so that tribos.h, the interface of the
 * compiled library, may be included beside it.
 *
 *   const tribos_kernel_twist_f32 motion = { 1.0f, 0.0f, 20.0f };                   m/s, m/s, rad/s
 *   tribos_kernel_wrench_f32 friction =
 *       tribos_kernel_round_wrench_f32(TRIBOS_KERNEL_DISK, motion, 0.51f, 0.04f);   mu N in N, radius in m: N, N, N m
 *
 * Strength (mu N), radius, mass and corners are arguments, so that each of many environments may have its own. A
 * pressure that the compiler knows costs nothing; one that it does not is a switch.
 *
 * Units: any consistent set. Wrench and twist refer to the centre of a round patch, to the origin of a polygon's corners.
 * Signs: friction opposes the motion; a push is what moves the patch, and the normal is the motion that it causes.
 * Domain: 0 <= strength < infinity, 0 < radius < infinity and so on as stated; these are not checked, and others give
 * some number or NaN, never an endless loop. Motions and pushes may be anything: NaN gives NaN, rest no friction.
 *
 * Accuracy in units of the last place (eps is 1.2e-7 in f32, 2.2e-16 in f64):
 *   round wrench     force 7, torque 8 (ring 12, 10) from twists as given
 *   Jacobian         3e-15 (f32: 6e-6) of the larger of the entry and F/v
 *   gauge, project   1e-15 of the limits (f32: 3e-7, 4e-7 for lengths below 0.3 radii)
 *   polygon          wrench 6e-15 of mu N and mu N R up to 10 times as long as wide (f32: 2.5e-6), Jacobian 4e-14 (1e-5);
 *                    gauge 1e-14, normal and projection 1e-13 of the limits (f32: 1e-5)
 *
 * Bits. The text follows the Rust kernel tribos-core operation by operation. On a host with IEEE arithmetic and without
 * contraction, results have the bits of RoundFriction::wrench, ::wrench_jacobian, RoundLimitSurface::gauge,
 * ::twist_normal_to, ::project_with_length, of ShapeFriction and ShapeLimitSurface, and of PlanarBody::step, which tests
 * compare (NaN is NaN, of any payload). A device whose + - * / and roots round to nearest, subnormals included, gives
 * them too, as CUDA promises with the flags below; no test of ours has run on one, and HIP is written for and not tried.
 * Elsewhere results differ by rounding.
 *
 *   gcc, clang    -ffp-contract=off, no -ffast-math; SSE2 or another unit that rounds to the type (not x87)
 *   nvcc, NVRTC   --fmad=false, and the defaults -ftz=false -prec-div=true -prec-sqrt=true, no -use_fast_math
 *   hipcc         -ffp-contract=off -fno-fast-math -fno-gpu-flush-denormals-to-zero
 *   MSVC          /fp:precise without /fp:contract
 *
 * Where the numbers come from: this file is generated. The fitted terms are those of the Rust kernel, which
 * tests/tables/fit_coulomb.py and generate_polygons.py fit there, to errors below those of rounding. To write it again:
 *
 *   TRIBOS_WRITE_HEADER=1 cargo test -p tribos-c --test interface kernel
 */

#ifndef TRIBOS_KERNEL_H
#define TRIBOS_KERNEL_H

/* Under NVRTC and HIPRTC the mathematics is built in. */
#if !defined(__CUDACC_RTC__) && !defined(__HIPCC_RTC__)
#include <math.h>
#include <string.h>
#endif

/* What stands before each function; both headers share it. */
#ifndef TRIBOS_FN
#if defined(__CUDACC__) || defined(__HIPCC__)
#define TRIBOS_FN static __host__ __device__ __forceinline__
#else
#define TRIBOS_FN static inline
#endif
#endif

/* Parts, in which a pressure that the compiler knows is no question any more. */
#if !defined(__CUDACC__) && !defined(__HIPCC__) && defined(__GNUC__)
#define TRIBOS_PART_ static inline __attribute__((always_inline))
#define TRIBOS_RARE_ static __attribute__((noinline, unused))
#else
#define TRIBOS_PART_ TRIBOS_FN
#define TRIBOS_RARE_ TRIBOS_FN
#endif

/* Pressures over the distance r from the centre, in units of the radius. */
enum tribos_kernel_pressure {
	TRIBOS_KERNEL_DISK,       /* uniform */
	TRIBOS_KERNEL_RING,       /* all on the rim */
	TRIBOS_KERNEL_PUNCH,      /* 1/sqrt(1 - r2) */
	TRIBOS_KERNEL_HERTZ,      /* sqrt(1 - r2) */
	TRIBOS_KERNEL_PARABOLOID  /* 1 - r2 */
};

/* True where powers of sqrt(z) stand in for the logarithm. */
TRIBOS_PART_ int tribos_has_roots_(int pressure)
{
	return pressure == TRIBOS_KERNEL_PUNCH || pressure == TRIBOS_KERNEL_HERTZ;
}

/* True where a Newton step along the limit curve leaves at most its square. */
TRIBOS_PART_ int tribos_is_smooth_(int pressure)
{
	return pressure != TRIBOS_KERNEL_RING && pressure != TRIBOS_KERNEL_PUNCH;
}

/* ================================ float ================================ */

/* A motion: length/time, length/time, 1/time. */
typedef struct tribos_kernel_twist_f32 {
	float x, y, spin;
} tribos_kernel_twist_f32;

/* Force, force, force x length. */
typedef struct tribos_kernel_wrench_f32 {
	float x, y, torque;
} tribos_kernel_wrench_f32;

/* Derivatives of (force x, force y, torque) by (velocity x, velocity y, spin): a symmetric matrix. */
typedef struct tribos_kernel_jacobian_f32 {
	float xx, xy, xn, yy, yn, nn;
} tribos_kernel_jacobian_f32;

/* The wrench of a limit surface nearest to a given one. */
typedef struct tribos_kernel_projection_f32 {
	tribos_kernel_wrench_f32 wrench; /* the given one, to the bit, where friction carries it */
	tribos_kernel_twist_f32 normal;  /* the outward normal with |velocity|2 + (spin radius)2 = 1; 0 inside */
	int slides;                     /* 0 inside the surface, 1 on it */
} tribos_kernel_projection_f32;

/* The end of a time step. */
typedef struct tribos_kernel_step_f32 {
	tribos_kernel_twist_f32 twist;     /* the motion after it */
	tribos_kernel_wrench_f32 friction; /* mean over the step */
	int is_at_rest;                   /* friction holds the body: the twist is 0 */
} tribos_kernel_step_f32;

/* A body in the plane. */
typedef struct tribos_kernel_body_f32 {
	float mass;    /* > 0 */
	float inertia; /* about the normal, mass x length2, > 0 */
} tribos_kernel_body_f32;

/* ---- Numbers of the type ---- */

TRIBOS_PART_ float tribos_of_bits_f32_(unsigned int given)
{
#if defined(__CUDA_ARCH__) || defined(__HIP_DEVICE_COMPILE__) || defined(__CUDACC_RTC__)
	return __uint_as_float(given);
#else
	float x;
	memcpy(&x, &given, sizeof x);
	return x;
#endif
}

TRIBOS_PART_ unsigned int tribos_to_bits_f32_(float x)
{
#if defined(__CUDA_ARCH__) || defined(__HIP_DEVICE_COMPILE__) || defined(__CUDACC_RTC__)
	return __float_as_uint(x);
#else
	unsigned int found;
	memcpy(&found, &x, sizeof x);
	return found;
#endif
}

TRIBOS_PART_ float tribos_infinity_f32_(void)
{
	return tribos_of_bits_f32_(0x7f800000u);
}

TRIBOS_PART_ float tribos_nan_f32_(void)
{
	return tribos_of_bits_f32_(0x7fc00000u);
}

/* The larger, the smaller number; the first if either is NaN. */
TRIBOS_PART_ float tribos_larger_f32_(float a, float b)
{
	return a < b ? b : a;
}

TRIBOS_PART_ float tribos_smaller_f32_(float a, float b)
{
	return b < a ? b : a;
}

TRIBOS_PART_ int tribos_is_finite_f32_(float x)
{
	return fabsf(x) < tribos_infinity_f32_();
}

TRIBOS_PART_ int tribos_is_ratio_f32_(float x)
{
	return 0.0f <= x && x <= 1.0f;
}

/* True from the smallest normal number up to the largest one. */
TRIBOS_PART_ int tribos_is_normal_f32_(float x)
{
	return 1.1754944e-38f <= x && x < tribos_infinity_f32_();
}

/* sqrt(a2 + b2) without overflow on the way. */
TRIBOS_PART_ float tribos_hypot_f32_(float a, float b)
{
	const float x = fabsf(a), y = fabsf(b);
	const float large = x > y ? x : y, small = x > y ? y : x;
	float ratio;
	if (large == 0.0f || large == tribos_infinity_f32_())
		return large + small;
	ratio = small / large;
	return large * sqrtf(1.0f + ratio * ratio);
}

/* ln z of a positive normal number: next to 2^k it is k ln 2 + 2 artanh f. */
TRIBOS_PART_ float tribos_log_f32_(float z)
{
	const unsigned int raised = (tribos_to_bits_f32_(z) + ((unsigned int)1 << (23 - 1))) >> 23;
	const float count = tribos_of_bits_f32_(0x4b000000u | raised) - 8388735.0f;
	const float nearest = tribos_of_bits_f32_(raised << 23);
	const float f = (z - nearest) / (z + nearest), f2 = f * f, f4 = f2 * f2;
	const float sum = (0.6666671f + 0.39978802f * f2) + 0.2996279f * f4;
	return count * 0.6931472f + f * (2.0f + f2 * sum);
}

/* ---- Products in the range of numbers whose factors are not: mantissa 2^exponent ---- */

typedef struct tribos_wide_f32_ {
	float mantissa;
	int exponent;
} tribos_wide_f32_;

TRIBOS_PART_ float tribos_power_of_two_f32_(int exponent)
{
	return tribos_of_bits_f32_((unsigned int)(127 + exponent) << 23);
}

TRIBOS_PART_ int tribos_is_number_f32_(tribos_wide_f32_ x)
{
	return x.mantissa != 0.0f && tribos_is_finite_f32_(x.mantissa);
}

TRIBOS_PART_ tribos_wide_f32_ tribos_wide_of_f32_(float mantissa, int exponent)
{
	tribos_wide_f32_ wide;
	int own, part;
	wide.mantissa = mantissa;
	wide.exponent = exponent;
	if (!tribos_is_number_f32_(wide))
		return wide;
	if (fabsf(mantissa) < 1.1754944e-38f) {
		mantissa = mantissa * tribos_power_of_two_f32_(64);
		exponent -= 64;
	}
	own = (int)(tribos_to_bits_f32_(fabsf(mantissa)) >> 23) - 127;
	part = own / 2;
	wide.mantissa = mantissa * tribos_power_of_two_f32_(-part) * tribos_power_of_two_f32_(part - own);
	wide.exponent = exponent + own;
	return wide;
}

TRIBOS_PART_ tribos_wide_f32_ tribos_wide_times_f32_(tribos_wide_f32_ a, tribos_wide_f32_ b)
{
	return tribos_wide_of_f32_(a.mantissa * b.mantissa, a.exponent + b.exponent);
}

TRIBOS_PART_ tribos_wide_f32_ tribos_wide_over_f32_(tribos_wide_f32_ a, tribos_wide_f32_ b)
{
	return tribos_wide_of_f32_(a.mantissa / b.mantissa, a.exponent - b.exponent);
}

TRIBOS_PART_ tribos_wide_f32_ tribos_wide_plus_f32_(tribos_wide_f32_ a, tribos_wide_f32_ b)
{
	const tribos_wide_f32_ large = a.exponent >= b.exponent ? a : b, small = a.exponent >= b.exponent ? b : a;
	const int apart = large.exponent - small.exponent;
	if (!(tribos_is_number_f32_(a) && tribos_is_number_f32_(b))) {
		if (a.mantissa == 0.0f)
			return b;
		return b.mantissa == 0.0f ? a : tribos_wide_of_f32_(a.mantissa + b.mantissa, 0);
	}
	if (apart > 64)
		return large;
	return tribos_wide_of_f32_(large.mantissa + small.mantissa * tribos_power_of_two_f32_(-apart), large.exponent);
}

TRIBOS_PART_ float tribos_wide_value_f32_(tribos_wide_f32_ x)
{
	const int lowest = 1 - 127;
	if (!tribos_is_number_f32_(x))
		return x.mantissa;
	if (x.exponent > 127)
		return copysignf(tribos_infinity_f32_(), x.mantissa);
	if (x.exponent >= lowest)
		return x.mantissa * tribos_power_of_two_f32_(x.exponent);
	if (x.exponent >= lowest - 64)
		return x.mantissa * 1.1754944e-38f * tribos_power_of_two_f32_(x.exponent - lowest);
	return copysignf(0.0f, x.mantissa);
}

/* ---- Round patches in units of radius and strength ---- */

/* Sums of fitted terms: regular parts of two functions, singular parts of the same. */
typedef struct tribos_sums_f32_ {
	float p, r, q, s;
} tribos_sums_f32_;

/* Of force and torque; the disk has theta in the place of torque. */
TRIBOS_PART_ tribos_sums_f32_ tribos_torque_sums_f32_(int pressure, int slides, float u)
{
	const float u2 = u * u;
	tribos_sums_f32_ sums;
	(void)slides;
	switch (pressure) {
	case TRIBOS_KERNEL_DISK:
		sums.p = 0.9586682f + (((-0.048473008f * u2 - 0.21180934f) * u2 + 0.20715554f) * u
			+ (-0.16814268f * u2 - 0.094984345f) * u2);
		sums.r = 0.22706915f + (((0.10881853f * u2 + 0.35778007f) * u2 - 0.1291883f) * u
			+ (0.34511948f * u2 + 0.071327776f) * u2);
		sums.q = 0.1492827f + (((0.00014321838f * u2 + 0.017195553f) * u2
			+ 0.18706717f) * u + (-0.0009048045f * u2 + 0.103965394f) * u2);
		sums.s = -0.20329744f + (((-0.00034773475f * u2 - 0.03922769f) * u2
			- 0.34860364f) * u + (0.0021628898f * u2 - 0.22198008f) * u2);
		break;
	case TRIBOS_KERNEL_RING:
		sums.p = 0.64573175f + (((-0.055347916f * u2 - 0.36554402f) * u2 - 0.041774523f) * u
			+ (-0.23889832f * u2 - 0.24996294f) * u2);
		sums.r = 0.79040265f + (((0.008499482f * u2 + 0.07655576f) * u2 + 0.34371006f) * u
			+ (0.04014654f * u2 + 0.10159234f) * u2);
		sums.q = 0.30694538f + (((-0.0005243445f * u2 + 0.1461268f) * u2 + 0.4444884f) * u
			+ (0.01780278f * u2 + 0.3663564f) * u2);
		sums.s = -0.2003729f + (((7.76198e-5f * u2 - 0.023511516f) * u2 - 0.11042077f) * u
			+ (-0.0027016818f * u2 - 0.06703969f) * u2);
		break;
	case TRIBOS_KERNEL_PUNCH:
		sums.p = (slides ? 0.8545998f : 0.7853982f) + ((((slides ? 0.0037360918f : 0.0f) * u2
			+ (slides ? 0.017472677f : 0.0f)) * u2 + (slides ? 0.13946643f : 0.0f)) * u
			+ ((slides ? 0.006491699f : 0.0f) * u2 + (slides ? 0.046890683f : 0.0f)) * u2);
		sums.r = (slides ? 0.36819994f : 0.49087384f) + ((((slides ? -0.011123231f : 0.0f) * u2
			+ (slides ? -0.02476835f : 0.0f)) * u2 + (slides ? -0.010221945f : 0.3926991f)) * u
			+ ((slides ? -0.013021307f : 0.0f) * u2 + (slides ? -0.034872048f : 0.0f)) * u2);
		sums.q = (slides ? 0.23639986f : 0.0f) + ((((slides ? -0.0025590628f : 0.0f) * u2
			+ (slides ? -0.010890886f : 0.0f)) * u2 + (slides ? -0.07934876f : 0.0f)) * u
			+ ((slides ? -0.0039757043f : 0.0f) * u2 + (slides ? -0.02836215f : 0.0f)) * u2);
		sums.s = (slides ? -0.069733195f : 0.3926991f) + ((((slides ? 0.008258077f : 0.0f) * u2
			+ (slides ? 0.019085959f : 0.0f)) * u2 + (slides ? 0.03245599f : 0.0f)) * u
			+ ((slides ? 0.009328607f : 0.0f) * u2 + (slides ? 0.030571643f : 0.0f)) * u2);
		break;
	case TRIBOS_KERNEL_HERTZ:
		sums.p = (slides ? 0.9170998f : 0.957204f) + ((((slides ? -0.005520238f : 0.0f) * u2
			+ (slides ? -0.0054690707f : 0.0f)) * u2 + (slides ? 0.09693337f : 0.2945243f)) * u
			+ ((slides ? -0.004909646f : 0.0f) * u2 + (slides ? 0.009013742f : 0.0f)) * u2);
		sums.r = (slides ? 0.21364994f : 0.2715146f) + ((((slides ? 0.0075679524f : 0.0f) * u2
			+ (slides ? 0.0015691053f : 0.0f)) * u2 + (slides ? -0.011044524f : 0.478602f)) * u
			+ ((slides ? 0.0035020406f : 0.0f) * u2 + (slides ? -0.007804595f : 0.22089323f)) * u2);
		sums.q = (slides ? 0.125f : 0.2945243f) + ((((slides ? 0.004455868f : 0.0f) * u2
			+ (slides ? 0.006177323f : 0.0f)) * u2 + (slides ? -0.03516943f : 0.0f)) * u
			+ ((slides ? 0.0038901833f : 0.0f) * u2 + (slides ? 0.0016537415f : 0.0f)) * u2);
		sums.s = (slides ? -0.024233364f : 0.25770876f) + ((((slides ? -0.0068287854f : 0.0f) * u2
			+ (slides ? -0.0037820078f : 0.0f)) * u2 + (slides ? 0.013079836f : 0.44178647f)) * u
			+ ((slides ? -0.0035104777f : 0.0f) * u2 + (slides ? 0.0023943426f : 0.0f)) * u2);
		break;
	default:
		sums.p = (slides ? 0.94717216f : 1.1073183f) + ((((slides ? 0.07436729f : -0.043637183f) * u2
			+ (slides ? 0.13910094f : -0.12173295f)) * u2 + (slides ? 0.055162024f : 0.46107912f)) * u
			+ ((slides ? 0.18963914f : -0.12644304f) * u2 + (slides ? -0.025268827f : 0.079833716f)) * u2);
		sums.r = (slides ? 0.18268351f : 0.28122208f) + ((((slides ? -0.10165483f : 0.012689512f) * u2
			+ (slides ? -0.15660478f : 0.14773487f)) * u2 + (slides ? 0.031088332f : 0.31452358f)) * u
			+ ((slides ? -0.24104945f : 0.04867644f) * u2 + (slides ? 0.02502755f : 0.29177514f)) * u2);
		sums.q = (slides ? -0.102786236f : 0.085558265f) + ((((slides ? 0.00019667648f : -0.00010015814f) * u2
			+ (slides ? 0.0026215522f : -0.0013883971f)) * u2 + (slides ? -0.11788301f : 0.07511525f)) * u
			+ ((slides ? -0.00076272077f : 0.00039185418f) * u2 + (slides ? -0.0300133f : 0.017125294f)) * u2);
		sums.s = (slides ? 0.11646222f : -0.064647555f) + ((((slides ? -0.00029838405f : 2.380142e-5f) * u2
			+ (slides ? -0.0038467476f : 0.00034282915f)) * u2 + (slides ? 0.1534386f : -0.025878614f)) * u
			+ ((slides ? 0.0011465073f : -9.31799e-5f) * u2 + (slides ? 0.041799456f : -0.0047510793f)) * u2);
		break;
	}
	return sums;
}

/* Of force and its slope. */
TRIBOS_PART_ tribos_sums_f32_ tribos_slope_sums_f32_(int pressure, int slides, float u)
{
	const float u2 = u * u;
	tribos_sums_f32_ sums;
	(void)slides;
	switch (pressure) {
	case TRIBOS_KERNEL_DISK:
		sums.p = 0.9586682f + (((-0.048473008f * u2 - 0.21180934f) * u2 + 0.20715554f) * u
			+ (-0.16814268f * u2 - 0.094984345f) * u2);
		sums.r = -0.30033988f + (((0.15331368f * u2 + 0.8286953f) * u2 - 0.12954934f) * u
			+ (0.62079036f * u2 + 0.37174872f) * u2);
		sums.q = 0.1492827f + (((0.00014321838f * u2 + 0.017195553f) * u2
			+ 0.18706717f) * u + (-0.0009048045f * u2 + 0.103965394f) * u2);
		sums.s = -0.44560272f + (((0.0015100571f * u2 - 0.39147067f) * u2
			- 0.93385327f) * u + (-0.04980218f * u2 - 0.90499127f) * u2);
		break;
	case TRIBOS_KERNEL_RING:
		sums.p = 0.63661975f + ((((slides ? 0.008499482f : -0.055347916f) * u2
			+ (slides ? 0.01751138f : -0.026117176f)) * u2 + (slides ? 0.28211737f : 0.036183342f)) * u
			+ ((slides ? 0.018897839f : -0.10052853f) * u2 + (slides ? 0.036354158f : 0.009190507f)) * u2);
		sums.r = (slides ? -0.12296134f : -0.1953482f) + ((((slides ? -0.014740234f : 0.10771512f) * u2
			+ (slides ? -0.03401097f : 0.11637892f)) * u2 + (slides ? -0.012687474f : -0.20027843f)) * u
			+ ((slides ? -0.058005113f : 0.40204486f) * u2 + (slides ? -0.007594868f : -0.16801228f)) * u2);
		sums.q = (slides ? -0.15915479f : 0.1591535f) + ((((slides ? 7.76198e-5f : -0.0005243445f) * u2
			+ (slides ? -0.017914101f : 0.10921039f)) * u2 + (slides ? -0.059639614f : 0.17866185f)) * u
			+ ((slides ? -0.0028957312f : 0.019113641f) * u2 + (slides ? -0.03592197f : 0.17452578f)) * u2);
		sums.s = (slides ? 0.15915494f : -0.1591549f) + ((((slides ? 0.0040509407f : -0.02959358f) * u2
			+ (slides ? 0.09363943f : -0.6072992f)) * u2 + (slides ? 0.11935891f : -0.3580095f)) * u
			+ ((slides ? 0.042135913f : -0.30223608f) * u2 + (slides ? 0.11104165f : -0.55017084f)) * u2);
		break;
	case TRIBOS_KERNEL_PUNCH:
		sums.p = (slides ? 0.8545998f : 0.7853982f) + ((((slides ? 0.0037360918f : 0.0f) * u2
			+ (slides ? 0.017472677f : 0.0f)) * u2 + (slides ? 0.13946643f : 0.0f)) * u
			+ ((slides ? 0.006491699f : 0.0f) * u2 + (slides ? 0.046890683f : 0.0f)) * u2);
		sums.r = (slides ? -0.23639986f : 0.0f) + ((((slides ? -0.014849819f : 0.0f) * u2
			+ (slides ? -0.04223968f : 0.0f)) * u2 + (slides ? -0.14968838f : 0.0f)) * u
			+ ((slides ? -0.01951904f : 0.0f) * u2 + (slides ? -0.08176286f : 0.0f)) * u2);
		sums.q = (slides ? 0.23639986f : 0.0f) + ((((slides ? -0.0025590628f : 0.0f) * u2
			+ (slides ? -0.010890886f : 0.0f)) * u2 + (slides ? -0.07934876f : 0.0f)) * u
			+ ((slides ? -0.0039757043f : 0.0f) * u2 + (slides ? -0.02836215f : 0.0f)) * u2);
		sums.s = (slides ? 0.19386695f : 0.0f) + ((((slides ? 0.010195566f : 0.0f) * u2
			+ (slides ? 0.029870404f : 0.0f)) * u2 + (slides ? 0.11180423f : 0.0f)) * u
			+ ((slides ? 0.0137309525f : 0.0f) * u2 + (slides ? 0.058945406f : 0.0f)) * u2);
		break;
	case TRIBOS_KERNEL_HERTZ:
		sums.p = (slides ? 0.9170998f : 0.957204f) + ((((slides ? -0.005520238f : 0.0f) * u2
			+ (slides ? -0.0054690707f : 0.0f)) * u2 + (slides ? 0.09693337f : 0.2945243f)) * u
			+ ((slides ? -0.004909646f : 0.0f) * u2 + (slides ? 0.009013742f : 0.0f)) * u2);
		sums.r = (slides ? -0.125f : -0.2945243f) + ((((slides ? 0.03186402f : 0.0f) * u2
			+ (slides ? 0.040296502f : 0.0f)) * u2 + (slides ? -0.006756114f : 0.0f)) * u
			+ ((slides ? 0.0265093f : 0.0f) * u2 + (slides ? 0.036698375f : 0.0f)) * u2);
		sums.q = (slides ? 0.125f : 0.2945243f) + ((((slides ? 0.004455868f : 0.0f) * u2
			+ (slides ? 0.006177323f : 0.0f)) * u2 + (slides ? -0.03516943f : 0.0f)) * u
			+ ((slides ? 0.0038901833f : 0.0f) * u2 + (slides ? 0.0016537415f : 0.0f)) * u2);
		sums.s = (slides ? 0.05613306f : 0.0f) + ((((slides ? -0.025402654f : 0.0f) * u2
			+ (slides ? -0.03608094f : 0.0f)) * u2 + (slides ? -0.022523753f : 0.0f)) * u
			+ ((slides ? -0.021458244f : 0.0f) * u2 + (slides ? -0.04108116f : 0.0f)) * u2);
		break;
	default:
		sums.p = (slides ? 0.94717216f : 1.1073183f) + ((((slides ? 0.07436729f : -0.043637183f) * u2
			+ (slides ? 0.13910094f : -0.12173295f)) * u2 + (slides ? 0.055162024f : 0.46107912f)) * u
			+ ((slides ? 0.18963914f : -0.12644304f) * u2 + (slides ? -0.025268827f : 0.079833716f)) * u2);
		sums.r = (slides ? -0.0030130963f : -0.49466652f) + ((((slides ? -0.369617f : 0.17280605f) * u2
			+ (slides ? -1.0191792f : 0.60214543f)) * u2 + (slides ? 0.30773938f : -0.3218062f)) * u
			+ ((slides ? -1.1042509f : 0.55538803f) * u2 + (slides ? -0.10490525f : 0.16075791f)) * u2);
		sums.q = (slides ? -0.102786236f : 0.085558265f) + ((((slides ? 0.00019667648f : -0.00010015814f) * u2
			+ (slides ? 0.0026215522f : -0.0013883971f)) * u2 + (slides ? -0.11788301f : 0.07511525f)) * u
			+ ((slides ? -0.00076272077f : 0.00039185418f) * u2 + (slides ? -0.0300133f : 0.017125294f)) * u2);
		sums.s = (slides ? 0.51995105f : -0.36462343f) + ((((slides ? 0.0012580008f : -0.0005691049f) * u2
			+ (slides ? 0.13481738f : -0.062255196f)) * u2 + (slides ? 1.0524276f : -0.5726884f)) * u
			+ ((slides ? -0.007706925f : 0.0034575036f) * u2 + (slides ? 0.7289261f : -0.35482225f)) * u2);
		break;
	}
	return sums;
}

/* T/F' of spinning alone. */
TRIBOS_PART_ float tribos_inv_moment_f32_(int pressure)
{
	switch (pressure) {
	case TRIBOS_KERNEL_DISK:
		return 1.0f / 1.5f;
	case TRIBOS_KERNEL_RING:
		return 1.0f / 0.5f;
	case TRIBOS_KERNEL_PUNCH:
		return 1.0f / 1.0f;
	case TRIBOS_KERNEL_HERTZ:
		return 1.0f / 2.0f;
	default:
		return 1.0f / 2.5f;
	}
}

/* Argument of the sums, and what multiplies the singular parts of force and torque, and of the slope. */
typedef struct tribos_hooks_f32_ {
	float argument, hook, slope;
} tribos_hooks_f32_;

TRIBOS_PART_ tribos_hooks_f32_ tribos_hooks_of_f32_(int pressure, float z)
{
	tribos_hooks_f32_ hooks;
	if (tribos_has_roots_(pressure)) {
		const float u = sqrtf(z) - 0.5f;
		hooks.argument = u * u;
		hooks.hook = u;
		hooks.slope = u;
	} else {
		const float log = tribos_log_f32_(tribos_larger_f32_(1.1754944e-38f, z));
		hooks.slope = pressure == TRIBOS_KERNEL_RING ? log
			: pressure == TRIBOS_KERNEL_DISK     ? z * log
							     : z * (z * log);
		hooks.argument = z - 0.5f;
		hooks.hook = z * hooks.slope;
	}
	return hooks;
}

/* F/v and T/w in units of the larger speed, where 1 - z is the squared ratio of the smaller to the larger speed. */
typedef struct tribos_factors_f32_ {
	float phi, chi, slope;
} tribos_factors_f32_;

TRIBOS_PART_ tribos_factors_f32_ tribos_force_and_torque_f32_(int pressure, int slides, float z)
{
	const tribos_hooks_f32_ hooks = tribos_hooks_of_f32_(pressure, z);
	const tribos_sums_f32_ sums = tribos_torque_sums_f32_(pressure, slides, hooks.argument);
	const float phi = sums.p + hooks.hook * sums.q, chi = sums.r + hooks.hook * sums.s;
	tribos_factors_f32_ factors;
	factors.phi = phi;
	factors.chi = chi;
	factors.slope = 0.0f;
	if (pressure == TRIBOS_KERNEL_DISK) {
		const float turns = slides ? 0.0f : z;
		factors.chi = chi + turns * (tribos_inv_moment_f32_(pressure) * phi - chi);
	} else if (pressure == TRIBOS_KERNEL_RING) {
		factors.phi = slides ? chi : phi;
		factors.chi = slides ? phi : chi;
	}
	return factors;
}

/* Phi and its slope; a ring's slope is infinite at z = 0. */
TRIBOS_PART_ tribos_factors_f32_ tribos_force_and_slope_f32_(int pressure, int slides, float z, int is_rough)
{
	const tribos_hooks_f32_ hooks = tribos_hooks_of_f32_(pressure, z);
	const float argument = pressure == TRIBOS_KERNEL_RING ? z : hooks.argument;
	const tribos_sums_f32_ sums = tribos_slope_sums_f32_(pressure, slides, argument);
	tribos_factors_f32_ factors;
	(void)is_rough;
	factors.phi = sums.p + hooks.hook * sums.q;
	factors.slope = sums.r + hooks.slope * sums.s;
	factors.chi = 0.0f;
	if (pressure == TRIBOS_KERNEL_RING && fabsf(z) <= 0.0f)
		factors.slope = 0.0f - sums.s * tribos_infinity_f32_();
	return factors;
}

/* Chi from phi and its slope. */
TRIBOS_PART_ float tribos_torque_of_slope_f32_(int pressure, int slides, float x, float z, tribos_factors_f32_ at)
{
	const float inv_n = tribos_inv_moment_f32_(pressure);
	const float z_slope = fabsf(z) <= 0.0f ? 0.0f : z * at.slope;
	const float theta = inv_n * (0.5f * at.phi + z_slope);
	return slides ? theta : inv_n * z * at.phi + x * theta;
}

/* F/v and T of v2 and w. */
typedef struct tribos_drag_f32_ {
	float drag, torque;
} tribos_drag_f32_;

TRIBOS_PART_ tribos_drag_f32_ tribos_drag_of_f32_(int pressure, float slide_sq, float rim)
{
	const float rim_sq = rim * rim;
	const int slides = rim_sq < slide_sq;
	const float major = tribos_larger_f32_(slide_sq, rim_sq), minor = tribos_smaller_f32_(slide_sq, rim_sq);
	const float per_major = 1.0f / major;
	const float z = (major - minor) * per_major;
	const tribos_factors_f32_ factors = tribos_force_and_torque_f32_(pressure, slides, z);
	const float per_speed = sqrtf(per_major);
	tribos_drag_f32_ found;
	found.drag = per_speed * factors.phi;
	found.torque = (slides ? rim * per_speed : 1.0f) * factors.chi;
	return found;
}

/* Sliding speed and rim speed in units of the larger one. */
typedef struct tribos_speeds_f32_ {
	float major, slide, rim, ratio, gap;
} tribos_speeds_f32_;

TRIBOS_PART_ float tribos_limit_speed_f32_(float speed, float other)
{
	const float infinity = tribos_infinity_f32_();
	if (speed == infinity && other < infinity)
		return 1.0f;
	if (other == infinity && speed < infinity)
		return 0.0f;
	return speed == infinity ? speed - other : speed + 0.0f * other;
}

TRIBOS_PART_ tribos_speeds_f32_ tribos_speeds_of_f32_(float slide, float rim)
{
	const float v = fabsf(slide), w = fabsf(rim), major = v > w ? v : w;
	tribos_speeds_f32_ speeds;
	speeds.major = major;
	speeds.slide = v / major;
	speeds.rim = w / major;
	speeds.ratio = speeds.slide * speeds.rim;
	speeds.gap = fabsf(v - w) / major;
	if (!(speeds.ratio >= 0.0f)) {
		/* Rest, infinities and NaN: limits. */
		speeds.major = v + w;
		speeds.slide = tribos_limit_speed_f32_(v, w);
		speeds.rim = tribos_limit_speed_f32_(w, v);
		speeds.ratio = speeds.slide * speeds.rim;
		speeds.gap = fabsf(speeds.slide - speeds.rim);
	}
	return speeds;
}

/* Reduced force and torque of sliding speed and rim speed, drag and torque in that order. */
TRIBOS_PART_ tribos_drag_f32_ tribos_reduced_wrench_f32_(int pressure, float slide, float rim)
{
	const tribos_speeds_f32_ at = tribos_speeds_of_f32_(slide, rim);
	const int slides = at.slide > at.rim;
	const tribos_factors_f32_ factors =
		tribos_force_and_torque_f32_(pressure, slides, at.gap * (1.0f + at.ratio));
	tribos_drag_f32_ found;
	found.drag = at.major == 0.0f ? 0.0f : at.slide * factors.phi;
	found.torque = at.major == 0.0f ? 0.0f : at.rim * factors.chi;
	return found;
}

/* F/v, dF/dv, dF/dw = dT/dv and dT/dw. */
typedef struct tribos_rates_f32_ {
	float drag, slide, mixed, rim;
} tribos_rates_f32_;

/* h^p (a + b h2) times a scale, p = 0 or 1. */
TRIBOS_PART_ float tribos_wide_entry_f32_(tribos_wide_f32_ scale, tribos_wide_f32_ h, int is_odd, float a, float b)
{
	const tribos_wide_f32_ square = tribos_wide_times_f32_(h, h);
	const tribos_wide_f32_ sum = tribos_wide_plus_f32_(
		tribos_wide_of_f32_(a, 0), tribos_wide_times_f32_(square, tribos_wide_of_f32_(b, 0)));
	const tribos_wide_f32_ product = is_odd ? tribos_wide_times_f32_(h, sum) : sum;
	return tribos_wide_value_f32_(
		tribos_is_number_f32_(product) ? tribos_wide_times_f32_(product, scale) : product);
}

/* Rates where the ratio of the speeds or 1 over the larger one leaves the normal numbers. */
TRIBOS_RARE_ tribos_rates_f32_ tribos_wide_rates_f32_(tribos_speeds_f32_ at, float v, float w, tribos_factors_f32_ by)
{
	const float major = v > w ? v : w, minor = v > w ? w : v, bend = 2.0f * by.slope, none = 0.0f;
	const tribos_wide_f32_ m = tribos_wide_of_f32_(major, 0);
	const tribos_wide_f32_ scale = tribos_wide_over_f32_(tribos_wide_of_f32_(1.0f, 0), m);
	const tribos_wide_f32_ h = tribos_wide_over_f32_(tribos_wide_of_f32_(minor, 0), m);
	tribos_rates_f32_ rates;
	rates.drag = tribos_wide_entry_f32_(scale, h, 0, by.phi, none);
	if (at.slide > at.rim) {
		rates.slide = tribos_wide_entry_f32_(scale, h, 0, none, -bend);
		rates.mixed = tribos_wide_entry_f32_(scale, h, 1, bend, none);
		rates.rim = tribos_wide_entry_f32_(scale, h, 0, none - bend, none);
	} else {
		rates.slide = tribos_wide_entry_f32_(scale, h, 0, by.phi, bend);
		rates.mixed = tribos_wide_entry_f32_(scale, h, 1, -by.phi, -bend);
		rates.rim = tribos_wide_entry_f32_(scale, h, 0, none, by.phi + at.ratio * at.ratio * bend);
	}
	return rates;
}

TRIBOS_PART_ tribos_rates_f32_ tribos_rates_of_f32_(int pressure, float slide, float rim)
{
	const tribos_speeds_f32_ at = tribos_speeds_of_f32_(slide, rim);
	const int slides = at.slide > at.rim;
	const float h = at.ratio, x = h * h, z = at.gap * (1.0f + h), scale = 1.0f / at.major;
	tribos_factors_f32_ factors = tribos_force_and_slope_f32_(pressure, slides, z, 0);
	tribos_rates_f32_ rates;
	if (at.major == 0.0f || !tribos_is_finite_f32_(at.major)) {
		/* At rest the limit of damping; there is none of infinite speeds. */
		rates.drag = at.major == 0.0f ? tribos_infinity_f32_() : tribos_nan_f32_();
		rates.slide = rates.rim = rates.drag;
		rates.mixed = at.major == 0.0f ? 0.0f : rates.drag;
		return rates;
	}
	factors.chi = tribos_torque_of_slope_f32_(pressure, slides, x, z, factors);
	if (tribos_is_normal_f32_(scale) && (x >= 1.1754944e-38f || slide == 0.0f || rim == 0.0f)) {
		const float bend = 2.0f * factors.slope, x_bend = x * bend;
		const float turned = -h * (factors.phi + x_bend);
		rates.drag = scale * factors.phi;
		rates.slide = scale * (slides ? 0.0f - x_bend : factors.phi + x_bend);
		rates.mixed = scale * (slides ? h * bend : turned);
		rates.rim = scale * (slides ? 0.0f - bend : 0.0f - h * turned);
		return rates;
	}
	return tribos_wide_rates_f32_(at, fabsf(slide), fabsf(rim), factors);
}

/* ---- Wrench and Jacobian of round patches ---- */

/* The wrench without sliding, at rest and where a product may leave the range of numbers. */
TRIBOS_RARE_ tribos_kernel_wrench_f32 tribos_wide_wrench_f32_(
	int pressure, tribos_kernel_twist_f32 twist, float strength, float radius)
{
	const float speed = tribos_hypot_f32_(twist.x, twist.y);
	const tribos_drag_f32_ reduced = tribos_reduced_wrench_f32_(pressure, speed, twist.spin * radius);
	const float force = strength * reduced.drag, torque = strength * radius * reduced.torque;
	const float drag = force / speed;
	const int is_plain = tribos_is_normal_f32_(drag);
	tribos_kernel_wrench_f32 wrench;
	wrench.torque = -copysignf(torque, twist.spin);
	if (speed == 0.0f) {
		wrench.x = wrench.y = force != force ? force : 0.0f;
		return wrench;
	}
	wrench.x = -(is_plain ? drag * twist.x : force * (twist.x / speed));
	wrench.y = -(is_plain ? drag * twist.y : force * (twist.y / speed));
	return wrench;
}

/* Friction of a round patch that moves with a twist, against it. Zero at rest. */
TRIBOS_FN tribos_kernel_wrench_f32 tribos_kernel_round_wrench_f32(
	int pressure, tribos_kernel_twist_f32 twist, float strength, float radius)
{
	const float least = 1e-15f, most = 1.0f / 1e-15f;
	const float rim = fabsf(twist.spin * radius), square = twist.x * twist.x + twist.y * twist.y;
	const int moves = square > least * least && square < most * most;
	if (moves && (rim == 0.0f || (rim > least && rim < most))) {
		const tribos_drag_f32_ reduced = tribos_drag_of_f32_(pressure, square, rim);
		const float drag = strength * reduced.drag;
		if (tribos_is_normal_f32_(drag)) {
			tribos_kernel_wrench_f32 wrench;
			wrench.x = -(drag * twist.x);
			wrench.y = -(drag * twist.y);
			wrench.torque = -copysignf(strength * radius * reduced.torque, twist.spin);
			return wrench;
		}
	}
	return tribos_wide_wrench_f32_(pressure, twist, strength, radius);
}

/* Its derivatives by the twist, negative semidefinite. At rest the diagonal is minus infinity, what is beside it 0. */
TRIBOS_FN tribos_kernel_jacobian_f32 tribos_kernel_round_jacobian_f32(
	int pressure, tribos_kernel_twist_f32 twist, float strength, float radius)
{
	const float speed = tribos_hypot_f32_(twist.x, twist.y);
	const tribos_rates_f32_ rates = tribos_rates_of_f32_(pressure, speed, twist.spin * radius);
	const float cosine = speed == 0.0f ? 1.0f : twist.x / speed, sine = speed == 0.0f ? 0.0f : twist.y / speed;
	const float along = strength * rates.slide, across = strength * rates.drag;
	const float mixed = strength * radius * rates.mixed * copysignf(1.0f, twist.spin);
	const float cc = cosine * cosine, ss = sine * sine;
	tribos_kernel_jacobian_f32 jacobian;
	jacobian.xx = along == across ? -along : -(along * cc + across * ss);
	jacobian.xy = along == across ? -0.0f : -((along - across) * cosine * sine);
	jacobian.yy = along == across ? -along : -(along * ss + across * cc);
	jacobian.xn = -(mixed * cosine);
	jacobian.yn = -(mixed * sine);
	jacobian.nn = -(strength * radius * radius * rates.rim);
	return jacobian;
}

/* ---- The limit surface of a round patch: a curve over the ratio h of the smaller to the larger speed ---- */

/* T of spinning alone. */
TRIBOS_PART_ float tribos_spin_torque_f32_(int pressure)
{
	switch (pressure) {
	case TRIBOS_KERNEL_DISK:
		return 0.6666667f;
	case TRIBOS_KERNEL_RING:
		return 1.0f;
	case TRIBOS_KERNEL_PUNCH:
		return 0.7853982f;
	case TRIBOS_KERNEL_HERTZ:
		return 0.5890486f;
	default:
		return 0.5333333f;
	}
}

/* Force and torque at equal speeds, and lines a f + b t = 1 through that point and a pole: the force's, the torque's. */
typedef struct tribos_chords_f32_ {
	float force, torque, a, b, c, d;
} tribos_chords_f32_;

TRIBOS_PART_ tribos_chords_f32_ tribos_chords_of_f32_(int pressure)
{
	tribos_chords_f32_ chords;
	switch (pressure) {
	case TRIBOS_KERNEL_DISK:
		chords.force = 0.84882635f;
		chords.torque = 0.28294212f;
		chords.a = 1.0f;
		chords.b = 0.5342918f;
		chords.c = 0.67809725f;
		chords.d = 1.5f;
		break;
	case TRIBOS_KERNEL_RING:
		chords.force = 0.63661975f;
		chords.torque = 0.6366198f;
		chords.a = 1.0f;
		chords.b = 0.5707963f;
		chords.c = 0.5707963f;
		chords.d = 1.0f;
		break;
	case TRIBOS_KERNEL_PUNCH:
		chords.force = 0.7853982f;
		chords.torque = 0.39269906f;
		chords.a = 1.0f;
		chords.b = 0.54647905f;
		chords.c = 0.63661975f;
		chords.d = 1.2732395f;
		break;
	case TRIBOS_KERNEL_HERTZ:
		chords.force = 0.8835729f;
		chords.torque = 0.22089323f;
		chords.a = 1.0f;
		chords.b = 0.5270742f;
		chords.c = 0.7073553f;
		chords.d = 1.6976527f;
		break;
	default:
		chords.force = 0.90541476f;
		chords.torque = 0.18108293f;
		chords.a = 1.0f;
		chords.b = 0.52233106f;
		chords.c = 0.7294662f;
		chords.d = 1.8750001f;
		break;
	}
	return chords;
}

/* The polynomials from which searches start: M at the pole, m/h by powers of h2, and M and m at equal speeds. */
typedef struct tribos_start_f32_ {
	float top, a, b, c, d, e, f, major, minor;
} tribos_start_f32_;

TRIBOS_PART_ tribos_start_f32_ tribos_start_of_f32_(int pressure, int slides)
{
	tribos_start_f32_ start;
	switch (pressure) {
	case TRIBOS_KERNEL_DISK:
		start.top = (slides ? 1.0f : 0.6666667f);
		start.a = (slides ? 0.24999154f : 1.0000103f);
		start.b = (slides ? 0.021435415f : -0.12572598f);
		start.c = (slides ? -0.00075380737f : -0.007640611f);
		start.d = (slides ? 0.027361512f : -0.035051838f);
		start.e = (slides ? -0.03694461f : 0.04433234f);
		start.f = (slides ? 0.02177248f : -0.02700954f);
		start.major = (slides ? 0.84882635f : 0.28294212f);
		start.minor = (slides ? 0.28294212f : 0.84882635f);
		break;
	case TRIBOS_KERNEL_RING:
		start.top = 1.0f;
		start.a = (slides ? 0.49984163f : 0.49984157f);
		start.b = (slides ? 0.07376331f : 0.07376343f);
		start.c = (slides ? -0.09954262f : -0.09953976f);
		start.d = (slides ? 0.4699936f : 0.47000504f);
		start.e = (slides ? -0.6788902f : -0.6788864f);
		start.f = (slides ? 0.3674717f : 0.36748886f);
		start.major = (slides ? 0.63661975f : 0.6366198f);
		start.minor = (slides ? 0.6366198f : 0.63661975f);
		break;
	case TRIBOS_KERNEL_PUNCH:
		start.top = (slides ? 1.0f : 0.7853982f);
		start.a = (slides ? 0.3333017f : 0.78539824f);
		start.b = (slides ? 0.03558421f : 2.026558e-6f);
		start.c = (slides ? -0.01392889f : 0.0f);
		start.d = (slides ? 0.09724808f : -7.6293945e-6f);
		start.e = (slides ? -0.13713837f : 1.5258789e-5f);
		start.f = (slides ? 0.07717323f : -3.8146973e-6f);
		start.major = (slides ? 0.7853982f : 0.39269906f);
		start.minor = (slides ? 0.39269906f : 0.7853982f);
		break;
	case TRIBOS_KERNEL_HERTZ:
		start.top = (slides ? 1.0f : 0.5890486f);
		start.a = (slides ? 0.19999722f : 1.1780974f);
		start.b = (slides ? 0.014482349f : -0.29452193f);
		start.c = (slides ? 0.001408577f : -8.583069e-6f);
		start.d = (slides ? 0.009554863f : 4.9591064e-5f);
		start.e = (slides ? -0.012069702f : -2.2888184e-5f);
		start.f = (slides ? 0.007498741f : 1.9073486e-5f);
		start.major = (slides ? 0.8835729f : 0.22089323f);
		start.minor = (slides ? 0.22089323f : 0.8835729f);
		break;
	default:
		start.top = (slides ? 1.0f : 0.5333333f);
		start.a = (slides ? 0.16666563f : 1.3333312f);
		start.b = (slides ? 0.010490656f : -0.49985957f);
		start.c = (slides ? 0.0015230179f : 0.060934067f);
		start.d = (slides ? 0.003938675f : 0.012462616f);
		start.e = (slides ? -0.004524231f : -0.007713318f);
		start.f = (slides ? 0.0029902458f : 0.006275177f);
		start.major = (slides ? 0.90541476f : 0.18108293f);
		start.minor = (slides ? 0.18108293f : 0.90541476f);
		break;
	}
	return start;
}

/* A point with its normal (1, h), the leading component first, and dm/dh. */
typedef struct tribos_point_f32_ {
	float major, minor, rate;
} tribos_point_f32_;

TRIBOS_PART_ tribos_point_f32_ tribos_point_of_f32_(int pressure, int slides, float ratio, int is_rough)
{
	const float x = ratio * ratio;
	const float z = tribos_is_smooth_(pressure) ? 1.0f - x : (1.0f - ratio) * (1.0f + ratio);
	const tribos_factors_f32_ at = tribos_force_and_slope_f32_(pressure, slides, z, is_rough);
	const float chi = tribos_torque_of_slope_f32_(pressure, slides, x, z, at);
	tribos_point_f32_ point;
	point.major = slides ? at.phi : chi;
	point.minor = ratio * (slides ? chi : at.phi);
	point.rate = slides ? -(2.0f * at.slope) : at.phi + 2.0f * x * at.slope;
	return point;
}

/* The equation of a search for a given point (A, a): A m - a M = 0 on its ray, (A - M) h - k (a - m) = 0 nearest to it. */
typedef struct tribos_equation_f32_ {
	int is_ray;
	float major, minor, weight;
} tribos_equation_f32_;

TRIBOS_PART_ float tribos_value_f32_(tribos_equation_f32_ given, float ratio, tribos_point_f32_ at)
{
	return given.is_ray ? given.major * at.minor - given.minor * at.major
			    : (given.major - at.major) * ratio - given.weight * (given.minor - at.minor);
}

TRIBOS_PART_ float tribos_rate_f32_(tribos_equation_f32_ given, float ratio, tribos_point_f32_ at)
{
	return given.is_ray ? (given.major + given.minor * ratio) * at.rate
			    : (given.major - at.major) + (ratio * ratio + given.weight) * at.rate;
}

/* A step of Chebyshev's on the polynomials. */
TRIBOS_PART_ float tribos_stepped_f32_(tribos_start_f32_ of, float ratio, tribos_equation_f32_ given)
{
	const float x = ratio * ratio;
	float sum = of.f * x + of.e, bend = of.f, slope = of.f * x + sum, loss = of.f * 0.9166667f;
	float turn, value, per_rate, newton, bent, next;
	tribos_point_f32_ at;
	sum = sum * x + of.d;
	bend = bend * x + slope;
	slope = slope * x + sum;
	sum = sum * x + of.c;
	bend = bend * x + slope;
	slope = slope * x + sum;
	sum = sum * x + of.b;
	bend = bend * x + slope;
	slope = slope * x + sum;
	sum = sum * x + of.a;
	loss = loss * x + of.e * 0.9f;
	loss = loss * x + of.d * 0.875f;
	loss = loss * x + of.c * 0.8333333f;
	loss = loss * x + of.b * 0.75f;
	loss = loss * x + of.a * 0.5f;
	turn = ratio * (6.0f * slope + 8.0f * x * bend);
	at.major = of.top - x * loss;
	at.minor = ratio * sum;
	at.rate = sum + 2.0f * x * slope;
	value = tribos_value_f32_(given, ratio, at);
	per_rate = 1.0f / tribos_rate_f32_(given, ratio, at);
	newton = value * per_rate;
	bent = given.is_ray ? given.minor * at.rate + (given.major + given.minor * ratio) * turn
			    : 3.0f * ratio * at.rate + (ratio * ratio + given.weight) * turn;
	bent = 0.5f * bent * per_rate;
	next = ratio - newton * (1.0f + newton * bent);
	return tribos_is_ratio_f32_(next) ? next : ratio;
}

/* Where a search on the ray of a point starts. */
TRIBOS_PART_ float tribos_start_on_ray_f32_(tribos_start_f32_ of, tribos_equation_f32_ given)
{
	const float slope = given.minor / given.major, at_pole = of.a / of.top;
	const float ratio = slope / (at_pole + (1.0f - at_pole * of.major / of.minor) * slope);
	return tribos_stepped_f32_(of, ratio, given);
}

/* Where a search for the nearest point starts. */
TRIBOS_PART_ float tribos_start_nearest_f32_(tribos_start_f32_ of, tribos_equation_f32_ given)
{
	const float value = -(given.weight * given.minor);
	const float linear = given.major - of.top + given.weight * of.a;
	const float both = given.major - of.major + given.weight * of.minor;
	const float cubic = both - linear;
	const float chord = -(value / both);
	const float bend = cubic * chord * chord;
	const float curved = (2.0f * bend * chord - value) / (linear + 3.0f * bend);
	const float first = tribos_is_ratio_f32_(curved) ? curved : chord;
	const float second = tribos_stepped_f32_(of, first, given);
	return 0.03f < fabsf(second - first) ? tribos_stepped_f32_(of, second, given) : second;
}

/* Where a search ended, with the last ratio whose point was computed and M + h m there. */
typedef struct tribos_end_f32_ {
	float ratio, major, minor, before, power;
} tribos_end_f32_;

/* The last step moves the point along the curve: dM/dh = -h dm/dh. */
TRIBOS_PART_ tribos_end_f32_ tribos_end_of_f32_(float step, float ratio, tribos_point_f32_ at)
{
	const float change = at.rate * step;
	tribos_end_f32_ end;
	end.before = ratio;
	end.power = at.major + ratio * at.minor;
	end.ratio = ratio + step;
	end.major = at.major - (ratio + 0.5f * step) * change;
	end.minor = at.minor + change;
	return end;
}

TRIBOS_PART_ float tribos_settled_f32_(float ratio)
{
	return 256.0f * 1.1920929e-7f * ratio + 1.1754944e-38f;
}

/* True where a Newton step is the last one. */
TRIBOS_PART_ int tribos_is_last_f32_(int pressure, float step, float newton, float before)
{
	const float square = step * step;
	const int is_short = square <= 0.5f * 1.1920929e-7f;
	if (tribos_is_smooth_(pressure))
		return is_short;
	return fabsf(step) <= tribos_settled_f32_(newton)
		|| (fabsf(step) * square <= 0.125f * 1.1920929e-7f * (before * before * newton) && is_short);
}

/* Newton steps kept in a bracket, at most 65 points. */
TRIBOS_RARE_ tribos_end_f32_ tribos_bracketed_f32_(
	int pressure, int slides, tribos_equation_f32_ given, float ratio, float before, tribos_point_f32_ at)
{
	float low = 0.0f, high = 1.0f, from = ratio, by = 0.0f;
	int left, is_done = 0;
	tribos_end_f32_ end;
	for (left = 64;; --left) {
		const float value = tribos_value_f32_(given, ratio, at), rate = tribos_rate_f32_(given, ratio, at);
		const float step = -(value / rate), newton = ratio + step;
		int is_newton, is_narrow, is_end;
		from = ratio;
		if (value < 0.0f)
			low = ratio;
		else
			high = ratio;
		is_newton = fabsf(rate) < tribos_infinity_f32_() && low <= newton && newton <= high;
		is_narrow = high - low <= tribos_settled_f32_(high);
		is_end = !(0.0f < fabsf(value));
		is_done = is_end || (is_newton ? tribos_is_last_f32_(pressure, step, newton, before) : is_narrow);
		by = is_newton && !is_end ? step : 0.0f;
		ratio = is_newton ? newton : 0.5f * (low + high);
		before = is_newton ? step : 0.0f;
		if (is_done || left == 0)
			break;
		at = tribos_point_of_f32_(pressure, slides, ratio, 0);
	}
	if (!(0.0f < fabsf(by)))
		at.rate = by = 0.0f;
	end = tribos_end_of_f32_(by, from, at);
	if (!is_done)
		end.ratio = end.major = end.minor = end.before = end.power = tribos_nan_f32_();
	return end;
}

/* The zero in [0, 1] of an equation along the curve. */
TRIBOS_PART_ tribos_end_f32_ tribos_solved_f32_(int pressure, int slides, float start, tribos_equation_f32_ given)
{
	const int is_smooth = tribos_is_smooth_(pressure), is_rough = pressure == TRIBOS_KERNEL_DISK;
	float ratio = tribos_is_ratio_f32_(start) ? start : 1.0f, before = 0.0f, value, rate, step, newton;
	tribos_point_f32_ at;
	if (!(1 && is_smooth)) {
		/* From here a step leads next to the end. */
		at = tribos_point_of_f32_(pressure, slides, ratio, is_rough);
		step = -(tribos_value_f32_(given, ratio, at) / tribos_rate_f32_(given, ratio, at));
		newton = ratio + step;
		before = tribos_is_ratio_f32_(newton) ? step : 0.0f;
		ratio = tribos_is_ratio_f32_(newton) ? newton : ratio;
	}
	at = tribos_point_of_f32_(pressure, slides, ratio, 0);
	value = tribos_value_f32_(given, ratio, at);
	rate = tribos_rate_f32_(given, ratio, at);
	step = -(value / rate);
	newton = ratio + step;
	if (0.0f < rate && rate < tribos_infinity_f32_() && tribos_is_ratio_f32_(newton)
		&& tribos_is_last_f32_(pressure, step, newton, before))
		return tribos_end_of_f32_(step, ratio, at);
	return tribos_bracketed_f32_(pressure, slides, given, ratio, before, at);
}

/* A planar vector and its normal companion as magnitudes, with what these leave out. */
typedef struct tribos_pair_f32_ {
	float planar, normal, x, y, sign;
} tribos_pair_f32_;

TRIBOS_PART_ tribos_pair_f32_ tribos_pair_of_f32_(float x, float y, float normal)
{
	const float least = 1e-15f * 1e-15f, square = x * x + y * y;
	const int is_ordinary = (least < square && square < 1.0f / least) || fabsf(x) + fabsf(y) <= 0.0f;
	tribos_pair_f32_ pair;
	pair.planar = is_ordinary ? sqrtf(square) : tribos_hypot_f32_(x, y);
	pair.normal = fabsf(normal);
	pair.x = pair.planar <= 0.0f ? 0.0f : x / pair.planar;
	pair.y = pair.planar <= 0.0f ? 0.0f : y / pair.planar;
	pair.sign = normal;
	return pair;
}

/* A normal (slide, rim), of which the larger part is 1, as a twist of length 1. */
TRIBOS_PART_ tribos_kernel_twist_f32 tribos_unit_twist_f32_(tribos_pair_f32_ pair, float slide, float rim, float radius)
{
	const float ratio = slide * rim, share = 1.0f / sqrtf(1.0f + ratio * ratio);
	tribos_kernel_twist_f32 twist;
	twist.x = slide * share * pair.x;
	twist.y = slide * share * pair.y;
	twist.spin = copysignf(rim * share / radius, pair.sign);
	return twist;
}

/* The normal where the ray of a point meets the curve, and the gauge of the point in its unit. */
typedef struct tribos_ray_f32_ {
	float slide, rim, gauge;
} tribos_ray_f32_;

TRIBOS_PART_ tribos_ray_f32_ tribos_ray_of_f32_(int pressure, float force, float torque)
{
	const tribos_chords_f32_ equal = tribos_chords_of_f32_(pressure);
	const int slides = torque * equal.force <= force * equal.torque;
	tribos_equation_f32_ given;
	tribos_end_f32_ end;
	tribos_ray_f32_ ray;
	float known;
	given.is_ray = 1;
	given.major = slides ? force : torque;
	given.minor = slides ? torque : force;
	given.weight = 0.0f;
	end = tribos_solved_f32_(
		pressure, slides, tribos_start_on_ray_f32_(tribos_start_of_f32_(pressure, slides), given), given);
	ray.gauge = (given.major + given.minor * end.before) / end.power;
	known = 1.0f + 0.0f * ray.gauge;
	ray.slide = slides ? known : end.ratio * known;
	ray.rim = slides ? end.ratio * known : known;
	return ray;
}

/* The same of a point of any size: `unit` is the larger component where their products may not be normal numbers. */
TRIBOS_PART_ int tribos_is_ordinary_f32_(float size)
{
	return (1e-15f < size && size < 1.0f / 1e-15f) || fabsf(size) <= 0.0f;
}

TRIBOS_PART_ tribos_ray_f32_ tribos_ray_in_range_f32_(int pressure, float force, float torque, float *unit)
{
	const int is_ordinary = tribos_is_ordinary_f32_(force) && tribos_is_ordinary_f32_(torque);
	const float size = is_ordinary ? 1.0f : tribos_larger_f32_(torque, force);
	*unit = size;
	return tribos_ray_of_f32_(
		pressure, is_ordinary ? force : force / size, is_ordinary ? torque : torque / size);
}

/* No force limit that is negative or NaN. */
TRIBOS_PART_ float tribos_limit_of_f32_(float strength)
{
	const float limit = strength + 0.0f;
	return 0.0f <= limit ? limit : tribos_nan_f32_();
}

/* The smallest factor f >= 0 with wrench/f in the set: below 1 inside, 1 on the surface; 0 for no wrench, infinite for an
 * infinite one and for any under no strength. */
TRIBOS_FN float tribos_kernel_round_gauge_f32(
	int pressure, tribos_kernel_wrench_f32 wrench, float strength, float radius)
{
	const float limit = tribos_limit_of_f32_(strength), infinity = tribos_infinity_f32_();
	const tribos_pair_f32_ pair = tribos_pair_of_f32_(wrench.x, wrench.y, wrench.torque);
	const float force = pair.planar, torque = pair.normal / radius;
	tribos_ray_f32_ ray;
	float unit;
	if (force == 0.0f && torque == 0.0f)
		return 0.0f;
	if (force + torque == infinity && (force == infinity || torque == infinity))
		return infinity + limit;
	ray = tribos_ray_in_range_f32_(pressure, force, torque, &unit);
	return unit == 1.0f ? ray.gauge / limit : unit / limit * ray.gauge;
}

/* The motion that a push causes: the outward normal where its ray meets the surface, with |velocity|2 + (spin radius)2 = 1.
 * Zero for no push, NaN for an infinite one. */
TRIBOS_FN tribos_kernel_twist_f32 tribos_kernel_round_normal_f32(
	int pressure, tribos_kernel_wrench_f32 push, float radius)
{
	tribos_kernel_twist_f32 none;
	tribos_pair_f32_ pair;
	tribos_ray_f32_ ray;
	float unit;
	if (push.x == 0.0f && push.y == 0.0f && push.torque == 0.0f) {
		none.x = none.y = none.spin = 0.0f;
		return none;
	}
	pair = tribos_pair_of_f32_(push.x, push.y, push.torque);
	ray = tribos_ray_in_range_f32_(pressure, pair.planar, pair.normal / radius, &unit);
	return tribos_unit_twist_f32_(pair, ray.slide, ray.rim, radius);
}

/* The projection of a wrench that the set holds. */
TRIBOS_PART_ tribos_kernel_projection_f32 tribos_held_f32_(tribos_kernel_wrench_f32 wrench)
{
	tribos_kernel_projection_f32 held;
	held.wrench = wrench;
	held.normal.x = held.normal.y = held.normal.spin = 0.0f;
	held.slides = 0;
	return held;
}

/* That of one that has no nearest point. */
TRIBOS_PART_ tribos_kernel_projection_f32 tribos_unknown_f32_(void)
{
	tribos_kernel_projection_f32 unknown;
	unknown.wrench.x = unknown.wrench.y = unknown.wrench.torque = tribos_nan_f32_();
	unknown.normal.x = unknown.normal.y = unknown.normal.spin = tribos_nan_f32_();
	unknown.slides = 1;
	return unknown;
}

/* That of a wrench next to the surface, of which `nearest` is that of one outside. */
TRIBOS_RARE_ tribos_kernel_projection_f32 tribos_beside_f32_(
	int pressure, tribos_kernel_wrench_f32 wrench, float strength, float radius, tribos_kernel_projection_f32 nearest)
{
	const float gauge = tribos_kernel_round_gauge_f32(pressure, wrench, strength, radius);
	if (gauge < 1.0f - 64.0f * 1.1920929e-7f)
		return tribos_held_f32_(wrench);
	if (gauge <= 1.0f + 64.0f * 1.1920929e-7f) {
		nearest.wrench = wrench;
		nearest.normal = tribos_kernel_round_normal_f32(pressure, wrench, radius);
		nearest.slides = 1;
	}
	return nearest;
}

/* That onto {0}, the set without strength. */
TRIBOS_RARE_ tribos_kernel_projection_f32 tribos_to_origin_f32_(tribos_pair_f32_ pair, float radius, float length)
{
	const float lever = length / radius, rim = pair.normal / length / lever;
	const float norm = tribos_hypot_f32_(pair.planar, rim);
	tribos_kernel_projection_f32 found;
	if (!(tribos_is_finite_f32_(norm) && length > 0.0f))
		return tribos_unknown_f32_();
	found.wrench.x = found.wrench.y = found.wrench.torque = 0.0f;
	found.normal.x = pair.planar / norm * pair.x;
	found.normal.y = pair.planar / norm * pair.y;
	found.normal.spin = copysignf(rim / norm / radius, pair.sign);
	found.slides = 1;
	return found;
}

/* The wrench of the set nearest to a given one by the distance sqrt(|force|2 + (torque/length)2), 0 < length < infinity:
 * with the radius of gyration as length that of kinetic energy. NaN for an infinite wrench. */
TRIBOS_FN tribos_kernel_projection_f32 tribos_kernel_round_project_f32(
	int pressure, tribos_kernel_wrench_f32 wrench, float strength, float radius, float length)
{
	const tribos_chords_f32_ chords = tribos_chords_of_f32_(pressure);
	const float limit = tribos_limit_of_f32_(strength), collar = 2.0f * (64.0f * 1.1920929e-7f);
	const tribos_pair_f32_ pair = tribos_pair_of_f32_(wrench.x, wrench.y, wrench.torque);
	const float arm = pair.normal / radius;
	const float bound = tribos_larger_f32_(
		chords.c * pair.planar + chords.d * arm, chords.a * pair.planar + chords.b * arm);
	const int has_length = length > 0.0f && tribos_is_finite_f32_(length);
	const float lever = (has_length ? length : radius) / radius, lever_sq = lever * lever;
	const float force = pair.planar / limit, torque = arm / limit;
	tribos_kernel_projection_f32 nearest;
	tribos_equation_f32_ given;
	tribos_end_f32_ end;
	float beyond, width;
	int slides;
	/* So far inside that no search is needed, by an inscribed quadrangle. */
	if (bound < limit * (1.0f - collar) || (wrench.x == 0.0f && wrench.y == 0.0f && wrench.torque == 0.0f))
		return tribos_held_f32_(wrench);
	if (limit == 0.0f)
		return tribos_to_origin_f32_(pair, radius, length);
	if (!(tribos_is_finite_f32_(force) && tribos_is_finite_f32_(torque)))
		return tribos_unknown_f32_();
	slides = torque - chords.torque <= lever_sq * (force - chords.force);
	given.is_ray = 0;
	given.major = slides ? force : torque;
	given.minor = slides ? torque : force;
	given.weight = slides ? 1.0f / lever_sq : lever_sq;
	end = tribos_solved_f32_(
		pressure, slides, tribos_start_nearest_f32_(tribos_start_of_f32_(pressure, slides), given), given);
	beyond = (given.major - end.major) + end.ratio * (given.minor - end.minor);
	width = collar * end.power;
	if (beyond < -width)
		return tribos_held_f32_(wrench);
	nearest.wrench.x = limit * (slides ? end.major : end.minor) * pair.x;
	nearest.wrench.y = limit * (slides ? end.major : end.minor) * pair.y;
	nearest.wrench.torque = copysignf(limit * radius * (slides ? end.minor : end.major), pair.sign);
	nearest.normal = tribos_unit_twist_f32_(pair, slides ? 1.0f : end.ratio, slides ? end.ratio : 1.0f, radius);
	nearest.slides = 1;
	if (!has_length)
		nearest = tribos_unknown_f32_();
	return width < beyond ? nearest : tribos_beside_f32_(pressure, wrench, strength, radius, nearest);
}

/* ---- Polygons under uniform pressure ---- */

/* An edge, prepared: where it begins and how it lies, in radii about the centroid. */
typedef struct tribos_kernel_edge_f32 {
	float x, y;                 /* the corner of the same number */
	float tangent_x, tangent_y; /* of length 1; the patch lies to the left */
	float length;
	float offset;               /* distance of the centroid to the left of its line */
} tribos_kernel_edge_f32;

/* A polygon, prepared. */
typedef struct tribos_kernel_polygon_f32 {
	float x, y;   /* the centroid, in the corners' coordinates */
	float radius; /* distance of the farthest corner from it */
	float area;   /* in units of radius2 */
	float arm;    /* largest torque about the origin over the strength */
	float reach;  /* bound of the corners' distances from the origin */
	float rounding; /* of its dissipated power: grows with the aspect ratio of slender patches */
	int count;   /* corners */
} tribos_kernel_polygon_f32;

/* A motion (v, w) of the centroid in radii, |v|2 + w2 = 1, with 1 over what it was divided by. */
typedef struct tribos_unit_motion_f32_ {
	float x, y, spin, rate;
} tribos_unit_motion_f32_;

/* True of speeds whose squares are normal numbers with digits to spare. */
TRIBOS_PART_ int tribos_has_square_f32_(float sq)
{
	return sq > 1.1754944e-38f / 1.1920929e-7f && sq < tribos_infinity_f32_();
}

/* The power of two that brings speeds of this size to such. */
TRIBOS_PART_ float tribos_to_ordinary_f32_(float size)
{
	const float down = sqrtf(1.1754944e-38f), up = 1.0f / down;
	if (tribos_has_square_f32_(size * size))
		return 1.0f;
	if (size < 1.0f)
		return tribos_has_square_f32_(size * up * (size * up)) ? up : up * up;
	return down * 0.125f;
}

/* True where a patch moves, with what its twist is multiplied by besides; else `unit` is what every component of its
 * friction is: 0 at rest, NaN for NaN. */
TRIBOS_PART_ int tribos_unit_motion_of_f32_(
	tribos_kernel_polygon_f32 polygon, tribos_kernel_twist_f32 twist, tribos_unit_motion_f32_ *motion, float *unit)
{
	float vx = twist.x - twist.spin * polygon.y, vy = twist.y + twist.spin * polygon.x;
	float rim = twist.spin * polygon.radius, size = fabsf(vx) + fabsf(vy) + fabsf(rim), by = 1.0f, sq;
	*unit = 0.0f;
	if (!tribos_has_square_f32_(size * size)) {
		float of_twist, of_speeds;
		if (!(tribos_is_finite_f32_(twist.x) && tribos_is_finite_f32_(twist.y)
			&& tribos_is_finite_f32_(twist.spin))) {
			*unit = tribos_nan_f32_();
			return 0;
		}
		of_twist = tribos_to_ordinary_f32_(fabsf(twist.x) + fabsf(twist.y) + fabsf(twist.spin));
		twist.x = twist.x * of_twist;
		twist.y = twist.y * of_twist;
		twist.spin = twist.spin * of_twist;
		vx = twist.x - twist.spin * polygon.y;
		vy = twist.y + twist.spin * polygon.x;
		rim = twist.spin * polygon.radius;
		of_speeds = tribos_to_ordinary_f32_(fabsf(vx) + fabsf(vy) + fabsf(rim));
		vx = vx * of_speeds;
		vy = vy * of_speeds;
		rim = rim * of_speeds;
		if (vx == 0.0f && vy == 0.0f && rim == 0.0f)
			return 0;
		by = of_twist * of_speeds;
	}
	sq = vx * vx + vy * vy + rim * rim;
	if (tribos_has_square_f32_(sq)) {
		const float rate = 1.0f / sqrtf(sq);
		motion->x = vx * rate;
		motion->y = vy * rate;
		motion->spin = rim * rate;
		motion->rate = rate;
	} else {
		size = tribos_hypot_f32_(tribos_hypot_f32_(vx, vy), rim);
		motion->x = vx / size;
		motion->y = vy / size;
		motion->spin = rim / size;
		motion->rate = 1.0f / size;
	}
	*unit = by;
	return 1;
}

/* A corner under a motion: velocity, speed q, arm v.(z x x) and what q differs from 1 by. */
typedef struct tribos_corner_f32_ {
	float ux, uy, q, arm, p, rest, x, y;
} tribos_corner_f32_;

TRIBOS_PART_ tribos_corner_f32_ tribos_corner_of_f32_(tribos_unit_motion_f32_ motion, float x, float y)
{
	const float w = motion.spin, least = 0.25f * 1.1920929e-7f, sq = x * x + y * y, from_rim = sq - 1.0f, half = 0.5f * w;
	float inv;
	tribos_corner_f32_ corner;
	corner.x = x;
	corner.y = y;
	corner.ux = motion.x - w * y;
	corner.uy = motion.y + w * x;
	corner.q = sqrtf(corner.ux * corner.ux + corner.uy * corner.uy + least * least);
	corner.arm = motion.y * x - motion.x * y;
	inv = 1.0f / (corner.q + 1.0f);
	corner.p = (from_rim - corner.arm * ((corner.arm + corner.arm + w * from_rim) * inv)) * inv;
	corner.rest = half * sq - corner.p * (corner.arm + half * corner.p);
	return corner;
}

/* What an edge contributes to force, torque and second derivatives of the power, of the area. */
typedef struct tribos_edge_sums_f32_ {
	float x, y, turn, xx, xy, yy, xn, yn, nn;
} tribos_edge_sums_f32_;

TRIBOS_PART_ tribos_edge_sums_f32_ tribos_edge_sums_of_f32_(tribos_unit_motion_f32_ motion,
	tribos_kernel_edge_f32 edge, tribos_corner_f32_ from, tribos_corner_f32_ to, int has_hessian)
{
	const float w = motion.spin, tx = edge.tangent_x, ty = edge.tangent_y, length = edge.length;
	const float along = motion.x * tx + motion.y * ty, across = motion.x * ty - motion.y * tx;
	const float eta = along + w * edge.offset;
	const float inv_sum = 1.0f / (from.q + to.q);
	const float reach = length * inv_sum, zeta = eta * inv_sum;
	const float reach_sq = reach * reach, zeta_sq = zeta * zeta, y_sq = w * w * reach_sq;
	/* z2/(1 - y2) and 1 - y2, by the sum that does not cancel. */
	const float dot = from.ux * to.ux + from.uy * to.uy;
	const int is_ahead = 0.0f <= dot;
	const float both = (from.q * to.q + fabsf(dot)) * (inv_sum * inv_sum), twice = both + both;
	const float inv = 1.0f / (is_ahead ? twice : twice * y_sq), turned = y_sq + y_sq;
	const float open = (is_ahead ? zeta_sq : both * both) * inv;
	const float gap = (is_ahead ? twice : zeta_sq * (turned * turned) * inv) + 1.1754944e-38f;
	/* G = ((artanh y/y - 1)/y2 - 1/3)/y2 and g = 1/3 + y2 G. */
	const float gap_sq = gap * gap;
	const float smooth = -0.6401715f + (((0.062278572f * gap_sq + 0.9708506f) * gap_sq
			- 0.8417069f) * gap + (1.3189739f * gap_sq - 0.6702241f) * gap_sq);
	const float of_log = -0.4999984f + (((0.0f * gap_sq - 2.0414815f) * gap_sq - 1.248345f) * gap
			+ (-0.59180963f * gap_sq - 2.0788827f) * gap_sq);
	const float bend = smooth + tribos_log_f32_(gap) * of_log, log = 0.33333334f + y_sq * bend;
	const float p = 0.5f * (from.p + to.p), arm = 0.5f * (from.arm + to.arm);
	const float rest = 0.5f * (from.rest + to.rest), sigma = arm + w * p;
	/* Integrals of p and of its further part along the edge. */
	const float beta = length * (p - length * reach * (open - zeta_sq * log));
	const float zeta_0 = 0.5f * along, zeta_1 = 0.5f * edge.offset - zeta * sigma;
	const float once = zeta_1 * (zeta + zeta_0) - zeta_0 * zeta_0 * sigma;
	const float closed = open - zeta_sq * bend;
	const float bent = 0.6666667f * once + w * reach_sq * closed;
	const float beta_rest = along * (length * (rest - length * reach * bent));
	tribos_edge_sums_f32_ sums;
	sums.x = tx * beta;
	sums.y = ty * beta;
	sums.turn = edge.offset * beta - (beta_rest + beta_rest);
	sums.xx = sums.xy = sums.yy = sums.xn = sums.yn = sums.nn = 0.0f;
	if (has_hessian) {
		const float double_inv = inv_sum + inv_sum, kappa = arm * arm - p + w * arm * p;
		const float lambda = double_inv * (kappa + reach_sq * log);
		const float lengthwise = length * (edge.offset - eta * arm + w * eta * lambda);
		const float middle = 0.5f * ((from.x + to.x) * tx + (from.y + to.y) * ty);
		const float rise = length * double_inv * (across * sigma + middle);
		const float mixed = length * double_inv * (reach_sq * log * eta * along - (p + w * w * kappa));
		const float sum = 2.0f + 2.0f * w * sigma;
		const float spread = 0.16666667f * sigma * (4.0f + sum * (2.0f + sum));
		const float left = 0.6666667f * edge.offset - along * spread;
		const float whole = left + 2.0f * w * reach_sq * bend * eta;
		const float chi = arm * p - rest - w * double_inv * kappa * (1.0f + p) + reach_sq * inv_sum * along * whole;
		sums.xx = lengthwise * tx * tx - rise * tx * ty;
		sums.xy = lengthwise * tx * ty - 0.5f * rise * (ty * ty - tx * tx);
		sums.yy = lengthwise * ty * ty + rise * tx * ty;
		sums.xn = -(mixed * tx);
		sums.yn = -(mixed * ty);
		sums.nn = along * (length * chi);
	}
	return sums;
}

/* Four sums, of which the next one stands first. */
typedef struct tribos_four_f32_ {
	float a, b, c, d;
} tribos_four_f32_;

TRIBOS_PART_ tribos_four_f32_ tribos_four_and_f32_(tribos_four_f32_ four, float part)
{
	const float first = four.a + part;
	four.a = four.b;
	four.b = four.c;
	four.c = four.d;
	four.d = first;
	return four;
}

/* Their sum after `count` parts: (1 + 2) + (3 + 4) of the sums in the order in which they were begun. */
TRIBOS_PART_ float tribos_four_total_f32_(tribos_four_f32_ four, int count)
{
	return count % 2 == 0 ? (four.a + four.b) + (four.c + four.d) : (four.d + four.a) + (four.b + four.c);
}

TRIBOS_PART_ tribos_edge_sums_f32_ tribos_edges_summed_f32_(
	const tribos_kernel_edge_f32 *edges, int count, tribos_unit_motion_f32_ motion, int has_hessian)
{
	const tribos_four_f32_ none = { 0.0f, 0.0f, 0.0f, 0.0f };
	tribos_four_f32_ x = none, y = none, turn = none, xx = none, xy = none, yy = none, xn = none, yn = none;
	tribos_four_f32_ nn = none;
	tribos_corner_f32_ corner = tribos_corner_of_f32_(motion, edges[0].x, edges[0].y);
	tribos_edge_sums_f32_ sums;
	int i;
	for (i = 0; i < count; ++i) {
		const tribos_kernel_edge_f32 *next = edges + (i + 1 < count ? i + 1 : 0);
		const tribos_corner_f32_ to = tribos_corner_of_f32_(motion, next->x, next->y);
		const tribos_edge_sums_f32_ part = tribos_edge_sums_of_f32_(motion, edges[i], corner, to, has_hessian);
		x = tribos_four_and_f32_(x, part.x);
		y = tribos_four_and_f32_(y, part.y);
		turn = tribos_four_and_f32_(turn, part.turn);
		if (has_hessian) {
			xx = tribos_four_and_f32_(xx, part.xx);
			xy = tribos_four_and_f32_(xy, part.xy);
			yy = tribos_four_and_f32_(yy, part.yy);
			xn = tribos_four_and_f32_(xn, part.xn);
			yn = tribos_four_and_f32_(yn, part.yn);
			nn = tribos_four_and_f32_(nn, part.nn);
		}
		corner = to;
	}
	sums.x = tribos_four_total_f32_(x, count);
	sums.y = tribos_four_total_f32_(y, count);
	sums.turn = tribos_four_total_f32_(turn, count);
	sums.xx = tribos_four_total_f32_(xx, count);
	sums.xy = tribos_four_total_f32_(xy, count);
	sums.yy = tribos_four_total_f32_(yy, count);
	sums.xn = tribos_four_total_f32_(xn, count);
	sums.yn = tribos_four_total_f32_(yn, count);
	sums.nn = tribos_four_total_f32_(nn, count);
	return sums;
}

/* The wrench about the origin of the corners' coordinates. */
TRIBOS_PART_ tribos_kernel_wrench_f32 tribos_polygon_wrench_of_f32_(tribos_kernel_polygon_f32 polygon,
	tribos_unit_motion_f32_ motion, tribos_edge_sums_f32_ sums, float share, float strength)
{
	const float by = motion.spin * share;
	const float torque = -(0.33333334f * motion.spin * (2.0f + share * sums.turn));
	tribos_kernel_wrench_f32 wrench;
	wrench.x = -(motion.x + by * sums.x) * strength;
	wrench.y = -(motion.y + by * sums.y) * strength;
	wrench.torque = strength * polygon.radius * torque + (polygon.x * wrench.y - polygon.y * wrench.x);
	return wrench;
}

/* Friction of a polygon under uniform pressure, against its twist. Zero at rest, NaN for infinite twists. */
TRIBOS_FN tribos_kernel_wrench_f32 tribos_kernel_polygon_wrench_f32(const tribos_kernel_polygon_f32 *polygon,
	const tribos_kernel_edge_f32 *edges, tribos_kernel_twist_f32 twist, float strength)
{
	tribos_unit_motion_f32_ motion;
	tribos_kernel_wrench_f32 wrench;
	float rest;
	if (!tribos_unit_motion_of_f32_(*polygon, twist, &motion, &rest)) {
		wrench.x = wrench.y = wrench.torque = rest;
		return wrench;
	}
	return tribos_polygon_wrench_of_f32_(
		*polygon, motion, tribos_edges_summed_f32_(edges, polygon->count, motion, 0), 1.0f / polygon->area, strength);
}

/* Prepares a polygon of `count` >= 3 corners (x, y in turn), clockwise or counterclockwise; `edges` has room for as many.
 * Returns 1, or 0 where a corner is not finite or repeated, or the area is lost in rounding. Edges must not cross: that
 * alone is not checked. */
TRIBOS_FN int tribos_kernel_polygon_prepare_f32(
	const float *corners, int count, tribos_kernel_edge_f32 *edges, tribos_kernel_polygon_f32 *polygon)
{
	float unit = 0.0f, twice = 0.0f, size = 0.0f, sense, area = 0.0f, mx = 0.0f, my = 0.0f, third, cx, cy;
	float radius = 0.0f, boundary = 0.0f, slender;
	tribos_kernel_twist_f32 turn;
	int i;
	if (count < 3)
		return 0;
	for (i = 0; i < count; ++i) {
		const float *at = corners + 2 * i, *next = corners + 2 * (i + 1 < count ? i + 1 : 0);
		const float dx = fabsf(at[0] - corners[0]), dy = fabsf(at[1] - corners[1]);
		if (!(tribos_is_finite_f32_(at[0]) && tribos_is_finite_f32_(at[1])))
			return 0;
		if (at[0] == next[0] && at[1] == next[1])
			return 0;
		unit = dx > unit ? dx : unit;
		unit = dy > unit ? dy : unit;
	}
	if (!tribos_is_finite_f32_(unit))
		return 0;
	/* Corners in units of the extent, for now where the edges will be. */
	for (i = 0; i < count; ++i) {
		edges[i].x = (corners[2 * i] - corners[0]) / unit;
		edges[i].y = (corners[2 * i + 1] - corners[1]) / unit;
	}
	for (i = 0; i < count; ++i) {
		const tribos_kernel_edge_f32 a = edges[i], b = edges[i + 1 < count ? i + 1 : 0];
		twice = twice + (a.x * b.y - a.y * b.x);
		size = size + (fabsf(a.x * b.y) + fabsf(a.y * b.x));
	}
	if (!(fabsf(twice) > 2.0f * 2.0f * 1.1920929e-7f * size + 1.1754944e-38f / 1.1920929e-7f) || twice == 0.0f)
		return 0;
	sense = copysignf(1.0f, twice);
	for (i = 0; i < count; ++i) {
		const tribos_kernel_edge_f32 a = edges[i], b = edges[i + 1 < count ? i + 1 : 0];
		const float part = sense * (a.x * b.y - a.y * b.x);
		area = area + part;
		mx = mx + (a.x + b.x) * part;
		my = my + (a.y + b.y) * part;
	}
	if (area <= 2.0f * 2.0f * 1.1920929e-7f * fabsf(twice) + 1.1754944e-38f / 1.1920929e-7f)
		return 0;
	third = 1.0f / (3.0f * area);
	cx = mx * third;
	cy = my * third;
	for (i = 0; i < count; ++i) {
		const float distance = tribos_hypot_f32_(edges[i].x - cx, edges[i].y - cy);
		radius = distance > radius ? distance : radius;
	}
	polygon->x = corners[0] + cx * unit;
	polygon->y = corners[1] + cy * unit;
	polygon->radius = radius * unit;
	polygon->area = 0.5f * area / (radius * radius);
	if (!tribos_is_finite_f32_(polygon->x + polygon->y + polygon->radius))
		return 0;
	for (i = 0; i < count; ++i) {
		edges[i].x = (edges[i].x - cx) / radius;
		edges[i].y = (edges[i].y - cy) / radius;
	}
	for (i = 0; i < count; ++i) {
		const tribos_kernel_edge_f32 a = edges[i], b = edges[i + 1 < count ? i + 1 : 0];
		const int is_forward = twice > 0.0f;
		const float from_x = is_forward ? a.x : b.x, from_y = is_forward ? a.y : b.y;
		const float side_x = (is_forward ? b.x : a.x) - from_x, side_y = (is_forward ? b.y : a.y) - from_y;
		const float length = tribos_hypot_f32_(side_x, side_y);
		if (length == 0.0f)
			return 0;
		edges[i].length = length;
		edges[i].tangent_x = side_x / length;
		edges[i].tangent_y = side_y / length;
		edges[i].offset = from_x * edges[i].tangent_y - from_y * edges[i].tangent_x;
	}
	/* What its limit surface is measured by. */
	polygon->count = count;
	polygon->reach = polygon->radius + tribos_hypot_f32_(polygon->x, polygon->y);
	for (i = 0; i < count; ++i)
		boundary = boundary + edges[i].length;
	slender = 0.25f * boundary / polygon->area;
	polygon->rounding = 1.1920929e-7f * (slender > 1.0f ? slender : 1.0f);
	turn.x = turn.y = 0.0f;
	turn.spin = 1.0f;
	polygon->arm = fabsf(tribos_kernel_polygon_wrench_f32(polygon, edges, turn, 1.0f).torque);
	return 1;
}

/* Friction of a polygon with its derivatives by the twist, negative semidefinite and zero at rest. */
TRIBOS_FN tribos_kernel_wrench_f32 tribos_kernel_polygon_wrench_jacobian_f32(const tribos_kernel_polygon_f32 *polygon,
	const tribos_kernel_edge_f32 *edges, tribos_kernel_twist_f32 twist, float strength,
	tribos_kernel_jacobian_f32 *jacobian)
{
	const float share = 1.0f / polygon->area, limit = -strength, radius = polygon->radius;
	tribos_unit_motion_f32_ motion;
	tribos_edge_sums_f32_ d;
	tribos_kernel_wrench_f32 wrench;
	float unit, x, y, n, to_x, to_y, to_n, half, from_x, from_y;
	if (!tribos_unit_motion_of_f32_(*polygon, twist, &motion, &unit)) {
		wrench.x = wrench.y = wrench.torque = unit;
		jacobian->xx = jacobian->xy = jacobian->xn = jacobian->yy = jacobian->yn = jacobian->nn = unit;
		return wrench;
	}
	d = tribos_edges_summed_f32_(edges, polygon->count, motion, 1);
	wrench = tribos_polygon_wrench_of_f32_(*polygon, motion, d, share, strength);
	/* Second derivatives of the power, and their part across the twist. */
	x = motion.x;
	y = motion.y;
	n = motion.spin;
	d.xx = share * d.xx;
	d.xy = share * d.xy;
	d.yy = share * d.yy;
	d.xn = share * d.xn - n * x;
	d.yn = share * d.yn - n * y;
	d.nn = share * d.nn + (x * x + y * y);
	to_x = d.xx * x + d.xy * y + d.xn * n;
	to_y = d.xy * x + d.yy * y + d.yn * n;
	to_n = d.xn * x + d.yn * y + d.nn * n;
	half = 0.5f * (to_x * x + to_y * y + to_n * n);
	to_x = to_x - half * x;
	to_y = to_y - half * y;
	to_n = to_n - half * n;
	d.xx = (d.xx - (to_x * x + to_x * x)) * motion.rate * unit;
	d.xy = (d.xy - (to_x * y + to_y * x)) * motion.rate * unit;
	d.yy = (d.yy - (to_y * y + to_y * y)) * motion.rate * unit;
	d.xn = (d.xn - (to_x * n + to_n * x)) * motion.rate * unit;
	d.yn = (d.yn - (to_y * n + to_n * y)) * motion.rate * unit;
	d.nn = (d.nn - (to_n * n + to_n * n)) * motion.rate * unit;
	/* About the origin: the centroid moves with (-y, x) for each unit of spin. */
	x = polygon->x;
	y = polygon->y;
	d.xx = limit * d.xx;
	d.xy = limit * d.xy;
	d.yy = limit * d.yy;
	d.xn = limit * radius * d.xn;
	d.yn = limit * radius * d.yn;
	d.nn = limit * radius * radius * d.nn;
	from_x = d.xy * x - d.xx * y;
	from_y = d.yy * x - d.xy * y;
	jacobian->xx = d.xx;
	jacobian->xy = d.xy;
	jacobian->yy = d.yy;
	jacobian->xn = d.xn + from_x;
	jacobian->yn = d.yn + from_y;
	jacobian->nn = d.nn + 2.0f * (d.yn * x - d.xn * y) + (from_y * x - from_x * y);
	return wrench;
}
/* ---- The limit surface of a polygon: convex functions of the twist, least by Newton's method ---- */

typedef struct tribos_vector_f32_ {
	float x, y, z;
} tribos_vector_f32_;

TRIBOS_PART_ float tribos_dot_f32_(tribos_vector_f32_ a, tribos_vector_f32_ b)
{
	return a.x * b.x + a.y * b.y + a.z * b.z;
}

TRIBOS_PART_ float tribos_norm_f32_(tribos_vector_f32_ a)
{
	return tribos_hypot_f32_(tribos_hypot_f32_(a.x, a.y), a.z);
}

/* What is to be least at a twist t, of a wrench x in units of strength and arm: D(t)2/2 - x.t, whose minimum is the normal
 * above x, or t.M t/2 + reach D(t) - x.t, with M = (1, 1, length2), whose minimum is the displacement to the nearest. */
typedef struct tribos_goal_f32_ {
	int is_gauge;
	tribos_vector_f32_ wrench;
	float reach, length_sq;
} tribos_goal_f32_;

/* Power, its gradient and its second derivatives there. */
typedef struct tribos_power_f32_ {
	float value;
	tribos_vector_f32_ gradient;
	tribos_kernel_jacobian_f32 hessian;
} tribos_power_f32_;

TRIBOS_PART_ tribos_power_f32_ tribos_power_at_f32_(
	const tribos_kernel_polygon_f32 *polygon, const tribos_kernel_edge_f32 *edges, tribos_vector_f32_ at)
{
	const float inv_arm = 1.0f / polygon->arm;
	tribos_kernel_twist_f32 twist;
	tribos_kernel_jacobian_f32 j;
	tribos_kernel_wrench_f32 wrench;
	tribos_power_f32_ power;
	twist.x = at.x;
	twist.y = at.y;
	twist.spin = at.z * inv_arm;
	wrench = tribos_kernel_polygon_wrench_jacobian_f32(polygon, edges, twist, 1.0f, &j);
	power.gradient.x = -wrench.x;
	power.gradient.y = -wrench.y;
	power.gradient.z = -(wrench.torque * inv_arm);
	power.hessian.xx = -j.xx;
	power.hessian.xy = -j.xy;
	power.hessian.yy = -j.yy;
	power.hessian.xn = -inv_arm * j.xn;
	power.hessian.yn = -inv_arm * j.yn;
	power.hessian.nn = -inv_arm * inv_arm * j.nn;
	power.value = tribos_dot_f32_(power.gradient, at);
	return power;
}

TRIBOS_PART_ tribos_vector_f32_ tribos_displacement_f32_(tribos_goal_f32_ goal, tribos_vector_f32_ at)
{
	at.z = goal.length_sq * at.z;
	return at;
}

TRIBOS_PART_ float tribos_goal_value_f32_(tribos_goal_f32_ goal, tribos_vector_f32_ at, float power)
{
	if (goal.is_gauge)
		return 0.5f * power * power - tribos_dot_f32_(goal.wrench, at);
	return 0.5f * tribos_dot_f32_(at, tribos_displacement_f32_(goal, at)) + power * goal.reach
		- tribos_dot_f32_(goal.wrench, at);
}

TRIBOS_PART_ tribos_vector_f32_ tribos_goal_gradient_f32_(
	tribos_goal_f32_ goal, tribos_vector_f32_ at, tribos_power_f32_ power)
{
	const float factor = goal.is_gauge ? power.value : goal.reach;
	tribos_vector_f32_ g;
	g.x = power.gradient.x * factor;
	g.y = power.gradient.y * factor;
	g.z = power.gradient.z * factor;
	if (!goal.is_gauge) {
		g.x = at.x + g.x;
		g.y = at.y + g.y;
		g.z = goal.length_sq * at.z + g.z;
	}
	g.x = g.x - goal.wrench.x;
	g.y = g.y - goal.wrench.y;
	g.z = g.z - goal.wrench.z;
	return g;
}

/* A step of Newton's method against a gradient; pivots that rounding has made too small are raised. */
TRIBOS_PART_ tribos_vector_f32_ tribos_newton_f32_(
	tribos_goal_f32_ goal, tribos_power_f32_ power, tribos_vector_f32_ right)
{
	const float factor = goal.is_gauge ? power.value : goal.reach, least = 4.0f * 1.1920929e-7f;
	const tribos_vector_f32_ g = power.gradient;
	const tribos_kernel_jacobian_f32 h = power.hessian;
	const float xx = goal.is_gauge ? g.x * g.x + h.xx * factor : h.xx * factor + 1.0f;
	const float yy = goal.is_gauge ? g.y * g.y + h.yy * factor : h.yy * factor + 1.0f;
	const float zz = goal.is_gauge ? g.z * g.z + h.nn * factor : h.nn * factor + goal.length_sq;
	const float xy = goal.is_gauge ? g.x * g.y + h.xy * factor : h.xy * factor;
	const float xz = goal.is_gauge ? g.x * g.z + h.xn * factor : h.xn * factor;
	const float yz = goal.is_gauge ? g.y * g.z + h.yn * factor : h.yn * factor;
	const float a = xy / xx, b = xz / xx, of_y = yy - a * xy, y = of_y < least * yy ? least * yy : of_y;
	const float c = (yz - a * xz) / y, of_z = zz - b * xz - c * c * y, z = of_z < least * zz ? least * zz : of_z;
	const float second = right.y - a * right.x, third = right.z - b * right.x - c * second;
	tribos_vector_f32_ step;
	step.z = third / z;
	step.y = second / y - c * step.z;
	step.x = right.x / xx - a * step.y - b * step.z;
	return step;
}

/* Where a goal is least, and the power there. */
typedef struct tribos_least_f32_ {
	tribos_vector_f32_ at;
	tribos_power_f32_ power;
	int is_found;
} tribos_least_f32_;

TRIBOS_RARE_ tribos_least_f32_ tribos_least_of_f32_(const tribos_kernel_polygon_f32 *polygon,
	const tribos_kernel_edge_f32 *edges, tribos_goal_f32_ goal, tribos_vector_f32_ start)
{
	const float rounding = polygon->rounding, noise = 8.0f * rounding;
	float size = 0.0f, descent = 0.0f, before = 0.0f, slack = 0.0f, factor = 1.0f;
	int steps = 0, halvings = 0;
	tribos_vector_f32_ next = start, step = start;
	tribos_least_f32_ least;
	least.at = start;
	least.is_found = 1;
	for (;;) {
		const tribos_power_f32_ power = tribos_power_at_f32_(polygon, edges, next);
		const float value = tribos_goal_value_f32_(goal, next, power.value);
		const tribos_vector_f32_ gradient = tribos_goal_gradient_f32_(goal, next, power);
		const float length = tribos_norm_f32_(gradient);
		if (steps > 0) {
			const float enough = before - 0.0001f * factor * descent, slope = tribos_dot_f32_(gradient, step);
			const int is_level = value <= before + slack && slope >= -(0.9998f * descent);
			const int gains = length < size || value < before - slack;
			const int bends = size > 32.0f * rounding && fabsf(slope) < 0.5f * descent;
			if (halvings < 30 && !(value <= enough || is_level)) {
				factor = 0.5f * factor;
				++halvings;
				next.x = least.at.x - step.x * factor;
				next.y = least.at.y - step.y * factor;
				next.z = least.at.z - step.z * factor;
				continue;
			}
			/* A full step that no longer shortens the gradient shows its rounding. */
			if (factor == 1.0f && size < sqrtf(rounding) && !(gains || bends))
				return least;
		}
		least.at = next;
		least.power = power;
		size = length;
		if (size <= noise)
			return least;
		if (steps == 40 || size != size) {
			least.is_found = size <= 64.0f * sqrtf(1.1920929e-7f);
			return least;
		}
		++steps;
		halvings = 0;
		step = tribos_newton_f32_(goal, power, gradient);
		descent = tribos_dot_f32_(gradient, step);
		before = value;
		slack = noise * (1.0f + fabsf(before));
		factor = 1.0f;
		next.x = least.at.x - step.x;
		next.y = least.at.y - step.y;
		next.z = least.at.z - step.z;
	}
}

/* The wrench in units of strength and arm, and its length; 0 where it has no direction. */
TRIBOS_PART_ float tribos_scaled_f32_(const tribos_kernel_polygon_f32 *polygon, tribos_kernel_wrench_f32 wrench,
	float limit, tribos_vector_f32_ *scaled)
{
	float size;
	scaled->x = wrench.x / limit;
	scaled->y = wrench.y / limit;
	scaled->z = wrench.torque / limit / polygon->arm;
	size = tribos_norm_f32_(*scaled);
	return size > 0.0f && tribos_is_finite_f32_(size) ? size : 0.0f;
}

/* The normal above a wrench of that length. */
TRIBOS_PART_ tribos_goal_f32_ tribos_gauge_goal_f32_(tribos_vector_f32_ scaled, float size)
{
	tribos_goal_f32_ goal;
	goal.is_gauge = 1;
	goal.wrench.x = scaled.x / size;
	goal.wrench.y = scaled.y / size;
	goal.wrench.z = scaled.z / size;
	goal.reach = goal.length_sq = 0.0f;
	return goal;
}

/* The gauge of that wrench: no number where the search has missed. */
TRIBOS_PART_ float tribos_gauge_of_f32_(tribos_goal_f32_ goal, float size, tribos_least_f32_ found)
{
	return size * (found.is_found ? tribos_dot_f32_(goal.wrench, found.at) / found.power.value : tribos_nan_f32_());
}

/* A twist of the search with |velocity|2 + (spin reach)2 = 1. */
TRIBOS_PART_ tribos_kernel_twist_f32 tribos_normal_of_f32_(
	const tribos_kernel_polygon_f32 *polygon, float x, float y, float z)
{
	const float spin = z / polygon->arm;
	const float length = tribos_hypot_f32_(tribos_hypot_f32_(x, y), spin * polygon->reach);
	tribos_kernel_twist_f32 normal;
	normal.x = x / length;
	normal.y = y / length;
	normal.spin = spin / length;
	return normal;
}

/* The smallest factor f >= 0 with wrench/f in the set, about the origin of the corners; NaN where the search has missed. */
TRIBOS_FN float tribos_kernel_polygon_gauge_f32(const tribos_kernel_polygon_f32 *polygon,
	const tribos_kernel_edge_f32 *edges, tribos_kernel_wrench_f32 wrench, float strength)
{
	tribos_vector_f32_ scaled;
	const float size = tribos_scaled_f32_(polygon, wrench, tribos_limit_of_f32_(strength), &scaled);
	tribos_goal_f32_ goal;
	if (size == 0.0f) {
		const float any = fabsf(wrench.x) + fabsf(wrench.y) + fabsf(wrench.torque);
		return any == 0.0f || any != any ? any : tribos_infinity_f32_();
	}
	goal = tribos_gauge_goal_f32_(scaled, size);
	return tribos_gauge_of_f32_(goal, size, tribos_least_of_f32_(polygon, edges, goal, goal.wrench));
}

/* The motion that a push causes, with |velocity|2 + (spin reach)2 = 1. Zero for no push, NaN for an infinite one. */
TRIBOS_FN tribos_kernel_twist_f32 tribos_kernel_polygon_normal_f32(const tribos_kernel_polygon_f32 *polygon,
	const tribos_kernel_edge_f32 *edges, tribos_kernel_wrench_f32 push, float strength)
{
	tribos_vector_f32_ scaled;
	const float size = tribos_scaled_f32_(polygon, push, tribos_limit_of_f32_(strength), &scaled);
	tribos_kernel_twist_f32 normal;
	tribos_goal_f32_ goal;
	tribos_least_f32_ found;
	normal.x = push.x == 0.0f && push.y == 0.0f && push.torque == 0.0f ? 0.0f : tribos_nan_f32_();
	normal.y = normal.spin = normal.x;
	if (size == 0.0f)
		return normal;
	goal = tribos_gauge_goal_f32_(scaled, size);
	found = tribos_least_of_f32_(polygon, edges, goal, goal.wrench);
	return found.is_found ? tribos_normal_of_f32_(polygon, found.at.x, found.at.y, found.at.z) : normal;
}

/* The wrench of the set nearest to a given one, as tribos_kernel_round_project has it, about the origin of the corners. */
TRIBOS_FN tribos_kernel_projection_f32 tribos_kernel_polygon_project_f32(const tribos_kernel_polygon_f32 *polygon,
	const tribos_kernel_edge_f32 *edges, tribos_kernel_wrench_f32 wrench, float strength, float length)
{
	const float limit = tribos_limit_of_f32_(strength), arm = length / polygon->arm;
	const float own = 24.0f * polygon->rounding, least = 64.0f * 1.1920929e-7f;
	const float collar = own > 0.015625f ? 0.015625f : own > least ? own : least;
	tribos_kernel_projection_f32 projection = tribos_held_f32_(wrench);
	tribos_vector_f32_ scaled, start;
	float size, gauge, along;
	tribos_goal_f32_ goal;
	tribos_least_f32_ found;
	if (wrench.x == 0.0f && wrench.y == 0.0f && wrench.torque == 0.0f)
		return projection;
	size = tribos_scaled_f32_(polygon, wrench, limit, &scaled);
	if (size == 0.0f || !(arm > 0.0f && tribos_is_finite_f32_(arm))) {
		/* None is carried, or there is no nearest one. */
		const tribos_kernel_twist_f32 normal = tribos_normal_of_f32_(
			polygon, wrench.x, wrench.y, wrench.torque / (length * length) * polygon->arm);
		const int is_number = tribos_is_finite_f32_(normal.spin) && tribos_is_finite_f32_(normal.x);
		projection = tribos_unknown_f32_();
		if (limit == 0.0f && length > 0.0f && is_number) {
			projection.wrench.x = projection.wrench.y = projection.wrench.torque = 0.0f;
			projection.normal = normal;
		}
		return projection;
	}
	goal = tribos_gauge_goal_f32_(scaled, size);
	found = tribos_least_of_f32_(polygon, edges, goal, goal.wrench);
	gauge = tribos_gauge_of_f32_(goal, size, found);
	if (gauge < 1.0f - collar)
		return projection;
	projection.slides = 1;
	if (gauge <= 1.0f + collar) {
		projection.normal = tribos_normal_of_f32_(polygon, found.at.x, found.at.y, found.at.z);
		return projection;
	}
	/* A wrench of any size is one of order 1 to the search, which starts along the normal above the wrench. */
	goal.is_gauge = 0;
	goal.reach = size > 1048576.0f ? 1.0f / size : 1.0f;
	goal.wrench = size > 1048576.0f ? goal.wrench : scaled;
	goal.length_sq = arm * arm;
	along = (tribos_dot_f32_(goal.wrench, found.at) - found.power.value * goal.reach)
		/ tribos_dot_f32_(found.at, tribos_displacement_f32_(goal, found.at));
	start.x = found.at.x * along;
	start.y = found.at.y * along;
	start.z = found.at.z * along;
	found = tribos_least_of_f32_(polygon, edges, goal, start);
	projection.wrench.x = limit * found.power.gradient.x;
	projection.wrench.y = limit * found.power.gradient.y;
	projection.wrench.torque = limit * polygon->arm * found.power.gradient.z;
	projection.normal = tribos_normal_of_f32_(polygon, found.at.x, found.at.y, found.at.z);
	return projection;
}

/* ---- The implicit time step of a body on its patch ---- */

/* A patch under a strength, round or a polygon. */
typedef struct tribos_set_f32_ {
	int is_round, pressure;
	const tribos_kernel_polygon_f32 *polygon;
	const tribos_kernel_edge_f32 *edges;
	float strength, radius;
} tribos_set_f32_;

TRIBOS_PART_ tribos_kernel_projection_f32 tribos_set_project_f32_(
	tribos_set_f32_ set, tribos_kernel_wrench_f32 wrench, float length)
{
	if (!set.is_round)
		return tribos_kernel_polygon_project_f32(set.polygon, set.edges, wrench, set.strength, length);
	return tribos_kernel_round_project_f32(set.pressure, wrench, set.strength, set.radius, length);
}

/* The largest torque, which is the power at unit spin. */
TRIBOS_PART_ float tribos_torque_limit_f32_(tribos_set_f32_ set)
{
	tribos_kernel_twist_f32 turn;
	turn.x = turn.y = 0.0f;
	turn.spin = 1.0f;
	if (!set.is_round)
		return -tribos_kernel_polygon_wrench_f32(
			set.polygon, set.edges, turn, tribos_limit_of_f32_(set.strength)).torque;
	return tribos_limit_of_f32_(set.strength) * (set.radius * tribos_spin_torque_f32_(set.pressure));
}

TRIBOS_PART_ int tribos_same_f32_(tribos_kernel_wrench_f32 a, tribos_kernel_wrench_f32 b)
{
	return a.x == b.x && a.y == b.y && a.torque == b.torque;
}

/* A wrench that is carried made so short that it does not oppose what is wanted beyond it: friction gives no energy. */
TRIBOS_RARE_ tribos_kernel_wrench_f32 tribos_shortened_f32_(
	tribos_kernel_wrench_f32 carried, tribos_kernel_wrench_f32 wanted, float length)
{
	const float x = carried.x, y = carried.y, n = carried.torque / length, m = wanted.torque / length;
	float size = fabsf(x) > 0.0f ? fabsf(x) : 0.0f, reached, factor;
	size = fabsf(y) > size ? fabsf(y) : size;
	size = fabsf(n) > size ? fabsf(n) : size;
	reached = 0.0f + x / size * (wanted.x / size) + y / size * (wanted.y / size) + n / size * (m / size);
	reached = reached / (0.0f + x / size * (x / size) + y / size * (y / size) + n / size * (n / size));
	if (reached >= 1.0f || reached != reached)
		return carried;
	factor = reached > 0.0f ? reached : 0.0f;
	carried.x = carried.x * factor;
	carried.y = carried.y * factor;
	carried.torque = carried.torque * factor;
	return carried;
}

TRIBOS_PART_ tribos_kernel_wrench_f32 tribos_without_gain_f32_(
	tribos_kernel_wrench_f32 carried, tribos_kernel_wrench_f32 wanted, float length)
{
	const float planar = carried.x * (wanted.x - carried.x) + carried.y * (wanted.y - carried.y);
	const float gain = planar * (length * length) + carried.torque * (wanted.torque - carried.torque);
	if (gain > 0.0f || tribos_same_f32_(carried, wanted))
		return carried;
	return tribos_shortened_f32_(carried, wanted, length);
}

/* The friction that brings the body to rest within a time. */
TRIBOS_PART_ tribos_kernel_wrench_f32 tribos_stopping_f32_(
	tribos_kernel_body_f32 body, tribos_kernel_twist_f32 twist, tribos_kernel_wrench_f32 push, float dt)
{
	const float mass = body.mass / dt, inertia = body.inertia / dt;
	tribos_kernel_wrench_f32 wrench;
	wrench.x = -(mass * twist.x + push.x);
	wrench.y = -(mass * twist.y + push.y);
	wrench.torque = -(inertia * twist.spin + push.torque);
	return wrench;
}

TRIBOS_PART_ tribos_kernel_twist_f32 tribos_moved_f32_(tribos_kernel_body_f32 body, tribos_kernel_twist_f32 twist,
	tribos_kernel_wrench_f32 push, tribos_kernel_wrench_f32 friction, float dt)
{
	const float rate = dt / body.mass, turn = dt / body.inertia;
	twist.x = twist.x + rate * (push.x + friction.x);
	twist.y = twist.y + rate * (push.y + friction.y);
	twist.spin = twist.spin + turn * (push.torque + friction.torque);
	return twist;
}

TRIBOS_PART_ tribos_kernel_step_f32 tribos_step_f32_(tribos_kernel_body_f32 body, tribos_kernel_twist_f32 twist,
	tribos_kernel_wrench_f32 push, tribos_set_f32_ set, float dt)
{
	const float length = sqrtf(body.inertia / body.mass), limit = tribos_limit_of_f32_(set.strength);
	const float torque_limit = tribos_torque_limit_f32_(set);
	const tribos_kernel_wrench_f32 at_end = tribos_stopping_f32_(body, twist, push, dt);
	const tribos_kernel_wrench_f32 half_way = tribos_stopping_f32_(body, twist, push, 0.5f * dt);
	const int is_beyond = tribos_hypot_f32_(at_end.x, at_end.y) > 1.01f * limit
		|| fabsf(at_end.torque) > 1.01f * torque_limit;
	tribos_kernel_wrench_f32 wanted = is_beyond ? half_way : at_end, carried, ended;
	tribos_kernel_step_f32 after, at_last;
	/* One search in the text: at the end where the body may come to rest, at half time, and at the end of a motion that
	 * has turned about. */
	int stage = is_beyond ? 1 : 0, has_ended = 0;
	after.is_at_rest = at_last.is_at_rest = 0;
	ended = at_end;
	for (;;) {
		carried = tribos_without_gain_f32_(
			tribos_set_project_f32_(set, wanted, length).wrench, wanted, length);
		if (stage == 0) {
			if (tribos_same_f32_(carried, at_end)) {
				after.twist.x = after.twist.y = after.twist.spin = 0.0f;
				after.friction = at_end;
				after.is_at_rest = 1;
				return after;
			}
			ended = carried;
			has_ended = 1;
			wanted = half_way;
			stage = 1;
			continue;
		}
		if (stage == 1) {
			after.twist = tribos_moved_f32_(body, twist, push, carried, dt);
			after.friction = carried;
			if (!(twist.x * after.twist.x + twist.y * after.twist.y < 0.0f
				|| twist.spin * after.twist.spin < 0.0f))
				return after;
			if (!has_ended) {
				wanted = at_end;
				stage = 2;
				continue;
			}
			carried = ended;
		}
		break;
	}
	at_last.twist = tribos_moved_f32_(body, twist, push, carried, dt);
	at_last.friction = carried;
	return carried.x * (0.5f * twist.x + 0.5f * at_last.twist.x)
				+ carried.y * (0.5f * twist.y + 0.5f * at_last.twist.y)
				+ carried.torque * (0.5f * twist.spin + 0.5f * at_last.twist.spin)
			> 0.0f
		? after
		: at_last;
}

/* The motion of a body on a round patch after the time dt > 0 under friction and a constant push. Of second order in dt
 * while it slides; rest is exact; friction never gives energy. NaN for NaN. */
TRIBOS_FN tribos_kernel_step_f32 tribos_kernel_round_step_f32(int pressure, tribos_kernel_body_f32 body,
	tribos_kernel_twist_f32 twist, tribos_kernel_wrench_f32 push, float strength, float radius, float dt)
{
	tribos_set_f32_ set;
	set.is_round = 1;
	set.pressure = pressure;
	set.polygon = 0;
	set.edges = 0;
	set.strength = strength;
	set.radius = radius;
	return tribos_step_f32_(body, twist, push, set, dt);
}

/* The same on a polygon; twist, push and the body's centre of mass are at the origin of the corners' coordinates. */
TRIBOS_FN tribos_kernel_step_f32 tribos_kernel_polygon_step_f32(const tribos_kernel_polygon_f32 *polygon,
	const tribos_kernel_edge_f32 *edges, tribos_kernel_body_f32 body, tribos_kernel_twist_f32 twist,
	tribos_kernel_wrench_f32 push, float strength, float dt)
{
	tribos_set_f32_ set;
	set.is_round = 0;
	set.pressure = TRIBOS_KERNEL_DISK;
	set.polygon = polygon;
	set.edges = edges;
	set.strength = strength;
	set.radius = 0.0f;
	return tribos_step_f32_(body, twist, push, set, dt);
}

/* ================================ double ================================ */

/* A motion: length/time, length/time, 1/time. */
typedef struct tribos_kernel_twist_f64 {
	double x, y, spin;
} tribos_kernel_twist_f64;

/* Force, force, force x length. */
typedef struct tribos_kernel_wrench_f64 {
	double x, y, torque;
} tribos_kernel_wrench_f64;

/* Derivatives of (force x, force y, torque) by (velocity x, velocity y, spin): a symmetric matrix. */
typedef struct tribos_kernel_jacobian_f64 {
	double xx, xy, xn, yy, yn, nn;
} tribos_kernel_jacobian_f64;

/* The wrench of a limit surface nearest to a given one. */
typedef struct tribos_kernel_projection_f64 {
	tribos_kernel_wrench_f64 wrench; /* the given one, to the bit, where friction carries it */
	tribos_kernel_twist_f64 normal;  /* the outward normal with |velocity|2 + (spin radius)2 = 1; 0 inside */
	int slides;                     /* 0 inside the surface, 1 on it */
} tribos_kernel_projection_f64;

/* The end of a time step. */
typedef struct tribos_kernel_step_f64 {
	tribos_kernel_twist_f64 twist;     /* the motion after it */
	tribos_kernel_wrench_f64 friction; /* mean over the step */
	int is_at_rest;                   /* friction holds the body: the twist is 0 */
} tribos_kernel_step_f64;

/* A body in the plane. */
typedef struct tribos_kernel_body_f64 {
	double mass;    /* > 0 */
	double inertia; /* about the normal, mass x length2, > 0 */
} tribos_kernel_body_f64;

/* ---- Numbers of the type ---- */

TRIBOS_PART_ double tribos_of_bits_f64_(unsigned long long given)
{
#if defined(__CUDA_ARCH__) || defined(__HIP_DEVICE_COMPILE__) || defined(__CUDACC_RTC__)
	return __longlong_as_double(given);
#else
	double x;
	memcpy(&x, &given, sizeof x);
	return x;
#endif
}

TRIBOS_PART_ unsigned long long tribos_to_bits_f64_(double x)
{
#if defined(__CUDA_ARCH__) || defined(__HIP_DEVICE_COMPILE__) || defined(__CUDACC_RTC__)
	return (unsigned long long)__double_as_longlong(x);
#else
	unsigned long long found;
	memcpy(&found, &x, sizeof x);
	return found;
#endif
}

TRIBOS_PART_ double tribos_infinity_f64_(void)
{
	return tribos_of_bits_f64_(0x7ff0000000000000u);
}

TRIBOS_PART_ double tribos_nan_f64_(void)
{
	return tribos_of_bits_f64_(0x7ff8000000000000u);
}

/* The larger, the smaller number; the first if either is NaN. */
TRIBOS_PART_ double tribos_larger_f64_(double a, double b)
{
	return a < b ? b : a;
}

TRIBOS_PART_ double tribos_smaller_f64_(double a, double b)
{
	return b < a ? b : a;
}

TRIBOS_PART_ int tribos_is_finite_f64_(double x)
{
	return fabs(x) < tribos_infinity_f64_();
}

TRIBOS_PART_ int tribos_is_ratio_f64_(double x)
{
	return 0.0 <= x && x <= 1.0;
}

/* True from the smallest normal number up to the largest one. */
TRIBOS_PART_ int tribos_is_normal_f64_(double x)
{
	return 2.2250738585072014e-308 <= x && x < tribos_infinity_f64_();
}

/* sqrt(a2 + b2) without overflow on the way. */
TRIBOS_PART_ double tribos_hypot_f64_(double a, double b)
{
	const double x = fabs(a), y = fabs(b);
	const double large = x > y ? x : y, small = x > y ? y : x;
	double ratio;
	if (large == 0.0 || large == tribos_infinity_f64_())
		return large + small;
	ratio = small / large;
	return large * sqrt(1.0 + ratio * ratio);
}

/* ln z of a positive normal number: next to 2^k it is k ln 2 + 2 artanh f. */
TRIBOS_PART_ double tribos_log_f64_(double z)
{
	const unsigned long long raised = (tribos_to_bits_f64_(z) + ((unsigned long long)1 << (52 - 1))) >> 52;
	const double count = tribos_of_bits_f64_(0x4330000000000000u | raised) - 4503599627371519.0;
	const double nearest = tribos_of_bits_f64_(raised << 52);
	const double f = (z - nearest) / (z + nearest), f2 = f * f, f4 = f2 * f2;
	const double sum = ((0.6666666666666694 + 0.39999999999325336 * f2) + f4 * (0.2857142883944641 + 0.2222218236947741 * f2))
		+ f4 * f4 * ((0.18184632005423831 + 0.15283173320297724 * f2) + f4 * 0.15123295208614101);
	return count * 0.6931471805599453 + f * (2.0 + f2 * sum);
}

/* ---- Products in the range of numbers whose factors are not: mantissa 2^exponent ---- */

typedef struct tribos_wide_f64_ {
	double mantissa;
	int exponent;
} tribos_wide_f64_;

TRIBOS_PART_ double tribos_power_of_two_f64_(int exponent)
{
	return tribos_of_bits_f64_((unsigned long long)(1023 + exponent) << 52);
}

TRIBOS_PART_ int tribos_is_number_f64_(tribos_wide_f64_ x)
{
	return x.mantissa != 0.0 && tribos_is_finite_f64_(x.mantissa);
}

TRIBOS_PART_ tribos_wide_f64_ tribos_wide_of_f64_(double mantissa, int exponent)
{
	tribos_wide_f64_ wide;
	int own, part;
	wide.mantissa = mantissa;
	wide.exponent = exponent;
	if (!tribos_is_number_f64_(wide))
		return wide;
	if (fabs(mantissa) < 2.2250738585072014e-308) {
		mantissa = mantissa * tribos_power_of_two_f64_(64);
		exponent -= 64;
	}
	own = (int)(tribos_to_bits_f64_(fabs(mantissa)) >> 52) - 1023;
	part = own / 2;
	wide.mantissa = mantissa * tribos_power_of_two_f64_(-part) * tribos_power_of_two_f64_(part - own);
	wide.exponent = exponent + own;
	return wide;
}

TRIBOS_PART_ tribos_wide_f64_ tribos_wide_times_f64_(tribos_wide_f64_ a, tribos_wide_f64_ b)
{
	return tribos_wide_of_f64_(a.mantissa * b.mantissa, a.exponent + b.exponent);
}

TRIBOS_PART_ tribos_wide_f64_ tribos_wide_over_f64_(tribos_wide_f64_ a, tribos_wide_f64_ b)
{
	return tribos_wide_of_f64_(a.mantissa / b.mantissa, a.exponent - b.exponent);
}

TRIBOS_PART_ tribos_wide_f64_ tribos_wide_plus_f64_(tribos_wide_f64_ a, tribos_wide_f64_ b)
{
	const tribos_wide_f64_ large = a.exponent >= b.exponent ? a : b, small = a.exponent >= b.exponent ? b : a;
	const int apart = large.exponent - small.exponent;
	if (!(tribos_is_number_f64_(a) && tribos_is_number_f64_(b))) {
		if (a.mantissa == 0.0)
			return b;
		return b.mantissa == 0.0 ? a : tribos_wide_of_f64_(a.mantissa + b.mantissa, 0);
	}
	if (apart > 64)
		return large;
	return tribos_wide_of_f64_(large.mantissa + small.mantissa * tribos_power_of_two_f64_(-apart), large.exponent);
}

TRIBOS_PART_ double tribos_wide_value_f64_(tribos_wide_f64_ x)
{
	const int lowest = 1 - 1023;
	if (!tribos_is_number_f64_(x))
		return x.mantissa;
	if (x.exponent > 1023)
		return copysign(tribos_infinity_f64_(), x.mantissa);
	if (x.exponent >= lowest)
		return x.mantissa * tribos_power_of_two_f64_(x.exponent);
	if (x.exponent >= lowest - 64)
		return x.mantissa * 2.2250738585072014e-308 * tribos_power_of_two_f64_(x.exponent - lowest);
	return copysign(0.0, x.mantissa);
}

/* ---- Round patches in units of radius and strength ---- */

/* Sums of fitted terms: regular parts of two functions, singular parts of the same. */
typedef struct tribos_sums_f64_ {
	double p, r, q, s;
} tribos_sums_f64_;

/* Of force and torque; the disk has theta in the place of torque. */
TRIBOS_PART_ tribos_sums_f64_ tribos_torque_sums_f64_(int pressure, int slides, double u)
{
	const double u2 = u * u;
	tribos_sums_f64_ sums;
	(void)slides;
	switch (pressure) {
	case TRIBOS_KERNEL_DISK:
		sums.p = 0.9643763020858971 + (((((-0.058532840198676155 * u2 - 0.5842633783652773) * u2
			- 0.7765781850895676) * u2 - 0.16298138088850694) * u2 + 0.2498128778274331) * u
			+ ((((-0.005456774268069727 * u2 - 0.2506404618853142) * u2
			- 0.837053523258099) * u2 - 0.4678153098177159) * u2 + 0.013354763369464787) * u2);
		sums.r = 0.20811628887258538 + (((((0.26919224595027375 * u2 + 2.5347750635619057) * u2
			+ 2.8434409409187418) * u2 + 0.0998116826708981) * u2 - 0.2762674931063023) * u
			+ ((((0.02547307290347257 * u2 + 1.1267254636233701) * u2
			+ 3.423025904829259) * u2 + 1.320385232325516) * u2 - 0.32832093007917684) * u2);
		sums.q = 0.1822229704999175 + (((((-1.9883724695722864e-5 * u2 + 0.024345006175283283) * u2
			+ 0.39243858649660407) * u2 + 0.7933381239885168) * u2 + 0.3965177493006795) * u
			+ ((((8.978915723472938e-7 * u2 + 0.001456983184223812) * u2
			+ 0.13621755140386962) * u2 + 0.6852604672679915) * u2 + 0.6490865313095427) * u2);
		sums.s = -0.3126702295816072 + (((((9.388900269829137e-5 * u2 - 0.11255513905215568) * u2
			- 1.7290318664394384) * u2 - 3.097815895721817) * u2 - 1.0754573703099486) * u
			+ ((((-4.251136504465063e-6 * u2 - 0.006818138432731789) * u2
			- 0.6179260978215214) * u2 - 2.8840211661647177) * u2 - 2.2273650302732952) * u2);
		break;
	case TRIBOS_KERNEL_RING:
		sums.p = 0.6571382791362133 + (((((-0.05355429113407963 * u2 - 0.7315412407660902) * u2
			- 1.1997710841562583) * u2 - 0.3456665719913761) * u2 + 0.036422091726741504) * u
			+ ((((-0.0038592356893775836 * u2 - 0.2740360879067468) * u2
			- 1.1710365320619724) * u2 - 0.8049845631747584) * u2 - 0.07658075874917278) * u2);
		sums.r = 0.7892039286740243 + (((((0.004031767814928033 * u2 + 0.058023157900431756) * u2
			+ 0.11400658033097436) * u2 + 0.0782606487360252) * u2 + 0.33576729324250515) * u
			+ ((((0.0002881964623734344 * u2 + 0.02101276311740363) * u2
			+ 0.0987781203913993) * u2 + 0.09880412895255235) * u2 + 0.08521971508532425) * u2);
		sums.q = 0.33985762692616894 + (((((0.0009491951558521174 * u2 + 0.15089180451114104) * u2
			+ 1.1475289956639263) * u2 + 1.6020129452327858) * u2 + 0.699256279743669) * u
			+ ((((-6.839019492077493e-6 * u2 + 0.02121123280239949) * u2
			+ 0.537835446840425) * u2 + 1.61504337901799) * u2 + 1.1871652467218092) * u2);
		sums.s = -0.20383166348926407 + (((((-7.085020875222037e-5 * u2 - 0.011472715119110166) * u2
			- 0.09313314964071127) * u2 - 0.15793216174805455) * u2 - 0.13640112123373807) * u
			+ ((((5.122020399459618e-7 * u2 - 0.0015916021676906891) * u2
			- 0.04189171623492093) * u2 - 0.1406213721701195) * u2 - 0.14726371923148127) * u2);
		break;
	case TRIBOS_KERNEL_PUNCH:
		sums.p = (slides ? 0.8545997880780726 : 0.7853981633974483) + (((((((slides ? 2.7952406622020447e-5 : 0.0) * u2
			+ (slides ? 8.417626719088087e-5 : 0.0)) * u2 + (slides ? 0.00045835983186166455 : 0.0)) * u2
			+ (slides ? 0.002720933387990497 : 0.0)) * u2 + (slides ? 0.01743276765088376 : 0.0)) * u2
			+ (slides ? 0.13946638410409692 : 0.0)) * u + (((((slides ? 2.3903443658351008e-5 : 0.0) * u2
			+ (slides ? 0.00019003728620863342 : 0.0)) * u2 + (slides ? 0.001109512096058035 : 0.0)) * u2
			+ (slides ? 0.006793433030570862 : 0.0)) * u2 + (slides ? 0.04689303179916843 : 0.0)) * u2);
		sums.r = (slides ? 0.3681999293593575 : 0.4908738521234052) + (((((((slides ? -0.00020216704774086362 : 0.0) * u2
			+ (slides ? -0.00046579945016013544 : 0.0)) * u2 + (slides ? -0.0018713066463364359 : 0.0)) * u2
			+ (slides ? -0.007474868699729408 : 0.0)) * u2 + (slides ? -0.02461920495519268 : 0.0)) * u2
			+ (slides ? -0.0102217512846066 : 0.39269908169872414)) * u
			+ (((((slides ? -0.00012767141649585274 : 0.0) * u2 + (slides ? -0.0008991563206621266 : 0.0)) * u2
			+ (slides ? -0.003788093708582413 : 0.0)) * u2 + (slides ? -0.014129511297596676 : 0.0)) * u2
			+ (slides ? -0.0348809784775115 : 0.0)) * u2);
		sums.q = (slides ? 0.23639985871871508 : 0.0) + (((((((slides ? -1.9628306526429174e-5 : 0.0) * u2
			+ (slides ? -5.591517970799004e-5 : 0.0)) * u2 + (slides ? -0.00029574038315324704 : 0.0)) * u2
			+ (slides ? -0.0017343060493255412 : 0.0)) * u2 + (slides ? -0.01083583667809389 : 0.0)) * u2
			+ (slides ? -0.07934858768992413 : 0.0)) * u + (((((slides ? -1.3566139948362952e-5 : 0.0) * u2
			+ (slides ? -0.00012260477498286868 : 0.0)) * u2 + (slides ? -0.000712030030984596 : 0.0)) * u2
			+ (slides ? -0.0042877794688089155 : 0.0)) * u2 + (slides ? -0.028366855376819457 : 0.0)) * u2);
		sums.s = (slides ? -0.06973319205204842 : 0.39269908169872414) + (((((((slides ? 0.0001438114006471987 : 0.0) * u2
			+ (slides ? 0.00032599956054544024 : 0.0)) * u2 + (slides ? 0.0013059953646364388 : 0.0)) * u2
			+ (slides ? 0.005342945473733294 : 0.0)) * u2 + (slides ? 0.01892064387944831 : 0.0)) * u2
			+ (slides ? 0.03245555589074051 : 0.0)) * u + (((((slides ? 7.991864176339419e-5 : 0.0) * u2
			+ (slides ? 0.0006213522062136124 : 0.0)) * u2 + (slides ? 0.002668468809457976 : 0.0)) * u2
			+ (slides ? 0.010348787142356037 : 0.0)) * u2 + (slides ? 0.030584559279079136 : 0.0)) * u2);
		break;
	case TRIBOS_KERNEL_HERTZ:
		sums.p = (slides ? 0.9170997880780726 : 0.9572040116406402) + (((((((slides ? -0.000130342835639579 : 0.0) * u2
			+ (slides ? -0.000285960056164215 : 0.0)) * u2 + (slides ? -0.0010596923264189816 : 0.0)) * u2
			+ (slides ? -0.0035654512821593986 : 0.0)) * u2 + (slides ? -0.005389827977900214 : 0.0)) * u2
			+ (slides ? 0.09693347461461777 : 0.2945243112740431)) * u
			+ (((((slides ? -7.826149615583726e-5 : 0.0) * u2 + (slides ? -0.0005319251534427738 : 0.0)) * u2
			+ (slides ? -0.0020089385735109475 : 0.0)) * u2 + (slides ? -0.005502058710980195 : 0.0)) * u2
			+ (slides ? 0.009009039991237441 : 0.0)) * u2);
		sums.r = (slides ? 0.21364994701951814 : 0.2715145994557585) + (((((((slides ? 0.0004605327546959628 : 0.0) * u2
			+ (slides ? 0.0007667547161747643 : 0.0)) * u2 + (slides ? 0.002025363463935614 : 0.0)) * u2
			+ (slides ? 0.0043008766413739795 : 0.0)) * u2 + (slides ? 0.0014316302765118461 : 0.0)) * u2
			+ (slides ? -0.011044703460131497 : 0.4786020058203201)) * u
			+ (((((slides ? 0.00018348082182602122 : 0.0) * u2 + (slides ? 0.0011895037257864444 : 0.0)) * u2
			+ (slides ? 0.003139914973233646 : 0.0)) * u2 + (slides ? 0.004514626485834613 : 0.0)) * u2
			+ (slides ? -0.007796328698056981 : 0.22089323345553233)) * u2);
		sums.q = (slides ? 0.12499999999999999 : 0.2945243112740431) + (((((((slides ? 9.599696523181972e-5 : 0.0) * u2
			+ (slides ? 0.00020512566198607936 : 0.0)) * u2 + (slides ? 0.0007578948028324588 : 0.0)) * u2
			+ (slides ? 0.0027064823960389526 : 0.0)) * u2 + (slides ? 0.0060636054074984565 : 0.0)) * u2
			+ (slides ? -0.035169773849386424 : 0.0)) * u + (((((slides ? 4.565892708876165e-5 : 0.0) * u2
			+ (slides ? 0.0003731490711301514 : 0.0)) * u2 + (slides ? 0.0014672994473802915 : 0.0)) * u2
			+ (slides ? 0.004545755581923647 : 0.0)) * u2 + (slides ? 0.0016632779265600111 : 0.0)) * u2);
		sums.s = (slides ? -0.02423336865365454 : 0.25770877236478773) + (((((((slides ? -0.00034978269348519725 : 0.0) * u2
			+ (slides ? -0.0005843548581019053 : 0.0)) * u2 + (slides ? -0.0015787388147639855 : 0.0)) * u2
			+ (slides ? -0.00375267703268301 : 0.0)) * u2 + (slides ? -0.0035933491649460703 : 0.0)) * u2
			+ (slides ? 0.013080366929112951 : 0.44178646691106466)) * u
			+ (((((slides ? -0.0001123765638337374 : 0.0) * u2 + (slides ? -0.000897115799807108 : 0.0)) * u2
			+ (slides ? -0.0025488024491422023 : 0.0)) * u2 + (slides ? -0.004634703915206934 : 0.0)) * u2
			+ (slides ? 0.002379093052414313 : 0.0)) * u2);
		break;
	default:
		sums.p = (slides ? 0.9376120089650134 : 1.1107180011030144) + ((((((slides ? 0.2782253041466174 : -0.06765013633737067) * u2
			+ (slides ? 2.024315188773776 : -0.5293339812362257)) * u2
			+ (slides ? 1.7953614843833552 : -0.581517663097388)) * u2
			+ (slides ? -0.09851692393065394 : -0.06335319751015449)) * u2
			+ (slides ? -0.02571239157743599 : 0.4886368010891158)) * u
			+ (((((slides ? 0.03152858222471295 : -0.007518869616115804) * u2
			+ (slides ? 1.0125198202250105 : -0.25333994790610287)) * u2
			+ (slides ? 2.448375721095 : -0.6890646313889419)) * u2 + (slides ? 0.660325433451735 : -0.3076220279882552)) * u2
			+ (slides ? -0.2736670827723023 : 0.15858409071840618)) * u2);
		sums.r = (slides ? 0.2028524100771901 : 0.28068606592281975) + ((((((slides ? -0.7847000636720697 : 0.006430047821739128) * u2
			+ (slides ? -5.40128727755377 : 0.05540512410009661)) * u2
			+ (slides ? -4.131521294383454 : 0.08524283281592797)) * u2
			+ (slides ? 0.49223512866689684 : 0.14262280032032326)) * u2
			+ (slides ? 0.20820535626095962 : 0.310376176290444)) * u
			+ (((((slides ? -0.09036603431815761 : 0.0006994748691533393) * u2
			+ (slides ? -2.7920755930822976 : 0.024956775335281407)) * u2
			+ (slides ? -6.201400733738075 : 0.08053613699955388)) * u2
			+ (slides ? -1.1442409727508864 : 0.07901876798418912)) * u2
			+ (slides ? 0.6017165704812811 : 0.28090743542543767)) * u2);
		sums.q = (slides ? -0.21312522694766722 : 0.12479586851084912) + ((((((slides ? -1.5056879101806027e-5 : 3.506723652424681e-6) * u2
			+ (slides ? -0.008987583437782472 : 0.002135560450546808)) * u2
			+ (slides ? -0.5234236833493968 : 0.12980457336753443)) * u2
			+ (slides ? -1.5809164348645075 : 0.4364868980821038)) * u2
			+ (slides ? -0.7076370299920515 : 0.27096420063964366)) * u
			+ (((((slides ? 1.142702547183603e-6 : -2.6572376179971976e-7) * u2
			+ (slides ? 0.0001816515672047886 : -4.257792048186972e-5)) * u2
			+ (slides ? -0.11829158653717756 : 0.028580063850349044)) * u2
			+ (slides ? -1.1836255138382454 : 0.3057588117518546)) * u2
			+ (slides ? -1.3278500796176511 : 0.4112619992632476)) * u2);
		sums.s = (slides ? 0.34924274146179557 : -0.07083407472465415) + ((((((slides ? 4.413822967597589e-5 : -3.2164754542172586e-7) * u2
			+ (slides ? 0.025841644916550954 : -0.00019797854940094324)) * u2
			+ (slides ? 1.4532815318112442 : -0.012639818510656596)) * u2
			+ (slides ? 4.056722557779195 : -0.04947878250844718)) * u2
			+ (slides ? 1.472624900588158 : -0.05447736569423005)) * u
			+ (((((slides ? -3.3611547023870054e-6 : 2.457908641576574e-8) * u2
			+ (slides ? -0.0005288390862486616 : 3.905643355832479e-6)) * u2
			+ (slides ? 0.3353687593130492 : -0.002696680143434325)) * u2
			+ (slides ? 3.1859042521705945 : -0.03144216622764698)) * u2
			+ (slides ? 3.1538862613511114 : -0.05612155733062098)) * u2);
		break;
	}
	return sums;
}

/* Of force and its slope. */
TRIBOS_PART_ tribos_sums_f64_ tribos_slope_sums_f64_(int pressure, int slides, double u)
{
	const double u2 = u * u;
	tribos_sums_f64_ sums;
	(void)slides;
	switch (pressure) {
	case TRIBOS_KERNEL_DISK:
		sums.p = 0.9646058363391036 + ((((((-0.0032370260304756095 * u2 - 0.20593480720875434) * u2
			- 0.9785217343052035) * u2 - 0.8578832586115368) * u2 - 0.12715745110115034) * u2
			+ 0.2526776993791444) * u + ((((-0.040834140151918545 * u2
			- 0.5690833190228652) * u2 - 1.1130942063067404) * u2 - 0.44025908879146214) * u2
			+ 0.027913976268873545) * u2);
		sums.r = -0.34643749332921375 + ((((((0.011935192276547454 * u2 + 1.1596904792625375) * u2
			+ 6.693713810590741) * u2 + 5.994913531106006) * u2 + 0.2886133776430402) * u2
			- 0.4687598240019988) * u + ((((0.1942972565852938 * u2 + 3.6015693292065682) * u2
			+ 7.915780936156555) * u2 + 2.655049091537991) * u2 - 0.5041952840832039) * u2);
		sums.q = 0.18354756221517807 + ((((((3.5416546242302043e-7 * u2 + 0.0008332543255329518) * u2
			+ 0.1055778294771661) * u2 + 0.7391753125869125) * u2 + 0.9934517291055692) * u2
			+ 0.4115736016199983) * u + ((((-9.375977759839015e-6 * u2
			+ 0.01614265409186584) * u2 + 0.3576827002658945) * u2 + 1.018389620845855) * u2
			+ 0.7224906705158484) * u2);
		sums.s = -0.5786123469983316 + ((((((1.6810147449583237e-5 * u2 - 0.07316412921002588) * u2
			- 2.4563468016758647) * u2 - 9.557935445480753) * u2 - 8.295000375434888) * u2
			- 2.030373150769537) * u + ((((-0.002837336555733737 * u2
			- 0.5998231115381207) * u2 - 5.993623348559888) * u2 - 10.525770017081767) * u2
			- 4.787063920775876) * u2);
		break;
	case TRIBOS_KERNEL_RING:
		sums.p = 0.6366197723675814 + (((((((slides ? 0.00014499137393659913 : -0.0021331628482270425) * u2
			+ (slides ? 0.004683155896586399 : -0.06612606977735669)) * u2
			+ (slides ? 0.00392237816224037 : -0.02890833090023781)) * u2
			+ (slides ? 0.004570626947008868 : 0.0014843041260894046)) * u2
			+ (slides ? 0.013898289277098012 : 0.00511233135974089)) * u2
			+ (slides ? 0.28211625721341416 : 0.03619362897025218)) * u
			+ (((((slides ? 0.0015936599293011522 : -0.02329058186008903) * u2
			+ (slides ? 0.005536189176889485 : -0.0685651674431026)) * u2
			+ (slides ? 0.003401185126850114 : -0.004202070385206922)) * u2
			+ (slides ? 0.007350185658425653 : 0.0029390659923896364)) * u2
			+ (slides ? 0.03616330887066783 : 0.01087628039816664)) * u2);
		sums.r = (slides ? -0.12296131412151255 : -0.195348572062277) + (((((((slides ? -0.0002890324759423786 : 0.004337834490261715) * u2
			+ (slides ? -0.026921235763389798 : 0.40689065472915953)) * u2
			+ (slides ? -0.02448585057517366 : 0.255201596455279)) * u2
			+ (slides ? -0.001514120248271164 : -0.1896334144850882)) * u2
			+ (slides ? -0.002198951134641024 : -0.20219596114196375)) * u2
			+ (slides ? -0.01264351404635913 : -0.20080187247215414)) * u
			+ (((((slides ? -0.006031266434884823 : 0.09146525274409367) * u2
			+ (slides ? -0.04054696398067557 : 0.5816497391202686)) * u2
			+ (slides ? -0.006673603282477032 : -0.08541596756530295)) * u2
			+ (slides ? -0.0013412398316174589 : -0.2018022222588182)) * u2
			+ (slides ? -0.004392908105055411 : -0.20184706755345833)) * u2);
		sums.q = (slides ? -0.15915494309189468 : 0.15915494309188197) + (((((((slides ? 2.0424786374682376e-7 : -2.9899975528181095e-6) * u2
			+ (slides ? -0.0007210197922917751 : 0.010574874971649332)) * u2
			+ (slides ? -0.009279894643255215 : 0.12834675139561083)) * u2
			+ (slides ? -0.017544175063845396 : 0.19210211297540283)) * u2
			+ (slides ? -0.027199163680050608 : 0.19039218410308886)) * u2
			+ (slides ? -0.05968310365687482 : 0.17904931092682927)) * u
			+ (((((slides ? -3.5553860650997854e-5 : 0.0005229792041239957) * u2
			+ (slides ? -0.0038490531195598575 : 0.055555209504797934)) * u2
			+ (slides ? -0.014043937453510938 : 0.1777886402631023)) * u2
			+ (slides ? -0.02141222035635074 : 0.19264265760269017)) * u2
			+ (slides ? -0.03730193847186039 : 0.18650967359788653)) * u2);
		sums.s = (slides ? 0.15915494309189535 : -0.15915494309189523) + (((((((slides ? 5.916687217405819e-5 : -0.0008857341648231994) * u2
			+ (slides ? 0.017657085277946023 : -0.2676445241845648)) * u2
			+ (slides ? 0.087981054779033 : -1.2491355535757434)) * u2
			+ (slides ? 0.10581140060215968 : -1.1619369977841467)) * u2
			+ (slides ? 0.10879724522665302 : -0.7615795017852159)) * u2
			+ (slides ? 0.11936620731878733 : -0.35809862195328057)) * u
			+ (((((slides ? 0.0022395960496727745 : -0.03387178086256182) * u2
			+ (slides ? 0.05375694935384221 : -0.8023665681538134)) * u2
			+ (slides ? 0.10249322861675804 : -1.3139791831517131)) * u2
			+ (slides ? 0.10709047695114639 : -0.9637305301987333)) * u2
			+ (slides ? 0.11190581910935583 : -0.5595290907813695)) * u2);
		break;
	case TRIBOS_KERNEL_PUNCH:
		sums.p = (slides ? 0.8545997880780726 : 0.7853981633974483) + (((((((slides ? 2.7952406622020447e-5 : 0.0) * u2
			+ (slides ? 8.417626719088087e-5 : 0.0)) * u2 + (slides ? 0.00045835983186166455 : 0.0)) * u2
			+ (slides ? 0.002720933387990497 : 0.0)) * u2 + (slides ? 0.01743276765088376 : 0.0)) * u2
			+ (slides ? 0.13946638410409692 : 0.0)) * u + (((((slides ? 2.3903443658351008e-5 : 0.0) * u2
			+ (slides ? 0.00019003728620863342 : 0.0)) * u2 + (slides ? 0.001109512096058035 : 0.0)) * u2
			+ (slides ? 0.006793433030570862 : 0.0)) * u2 + (slides ? 0.04689303179916843 : 0.0)) * u2);
		sums.r = (slides ? -0.23639985871871508 : 0.0) + (((((((slides ? -0.0002298981794280513 : 0.0) * u2
			+ (slides ? -0.0005497940332021153 : 0.0)) * u2 + (slides ? -0.0023296536930144268 : 0.0)) * u2
			+ (slides ? -0.010195801939515883 : 0.0)) * u2 + (slides ? -0.04205197260582597 : 0.0)) * u2
			+ (slides ? -0.14968813538870349 : 0.0)) * u + (((((slides ? -0.00015187994919442852 : 0.0) * u2
			+ (slides ? -0.0010892547625198574 : 0.0)) * u2 + (slides ? -0.004897607522089851 : 0.0)) * u2
			+ (slides ? -0.02092294433614295 : 0.0)) * u2 + (slides ? -0.08177401027668396 : 0.0)) * u2);
		sums.q = (slides ? 0.23639985871871508 : 0.0) + (((((((slides ? -1.9628306526429174e-5 : 0.0) * u2
			+ (slides ? -5.591517970799004e-5 : 0.0)) * u2 + (slides ? -0.00029574038315324704 : 0.0)) * u2
			+ (slides ? -0.0017343060493255412 : 0.0)) * u2 + (slides ? -0.01083583667809389 : 0.0)) * u2
			+ (slides ? -0.07934858768992413 : 0.0)) * u + (((((slides ? -1.3566139948362952e-5 : 0.0) * u2
			+ (slides ? -0.00012260477498286868 : 0.0)) * u2 + (slides ? -0.000712030030984596 : 0.0)) * u2
			+ (slides ? -0.0042877794688089155 : 0.0)) * u2 + (slides ? -0.028366855376819457 : 0.0)) * u2);
		sums.s = (slides ? 0.1938669492292365 : 0.0) + (((((((slides ? 0.000154799605116533 : 0.0) * u2
			+ (slides ? 0.00037416612923799384 : 0.0)) * u2 + (slides ? 0.0016011196589245582 : 0.0)) * u2
			+ (slides ? 0.0070772429591975765 : 0.0)) * u2 + (slides ? 0.029756480537902617 : 0.0)) * u2
			+ (slides ? 0.11180414358066074 : 0.0)) * u + (((((slides ? 0.00010589430758059236 : 0.0) * u2
			+ (slides ? 0.0007467145149254316 : 0.0)) * u2 + (slides ? 0.0033805885672042427 : 0.0)) * u2
			+ (slides ? 0.014636567135938257 : 0.0)) * u2 + (slides ? 0.058951414656306794 : 0.0)) * u2);
		break;
	case TRIBOS_KERNEL_HERTZ:
		sums.p = (slides ? 0.9170997880780726 : 0.9572040116406402) + (((((((slides ? -0.000130342835639579 : 0.0) * u2
			+ (slides ? -0.000285960056164215 : 0.0)) * u2 + (slides ? -0.0010596923264189816 : 0.0)) * u2
			+ (slides ? -0.0035654512821593986 : 0.0)) * u2 + (slides ? -0.005389827977900214 : 0.0)) * u2
			+ (slides ? 0.09693347461461777 : 0.2945243112740431)) * u
			+ (((((slides ? -7.826149615583726e-5 : 0.0) * u2 + (slides ? -0.0005319251534427738 : 0.0)) * u2
			+ (slides ? -0.0020089385735109475 : 0.0)) * u2 + (slides ? -0.005502058710980195 : 0.0)) * u2
			+ (slides ? 0.009009039991237441 : 0.0)) * u2);
		sums.r = (slides ? -0.125 : -0.2945243112740431) + (((((((slides ? 0.0012257229999891818 : 0.0) * u2
			+ (slides ? 0.0022333458887302923 : 0.0)) * u2 + (slides ? 0.006857765417917003 : 0.0)) * u2
			+ (slides ? 0.01981405722118841 : 0.0)) * u2 + (slides ? 0.039792067987269926 : 0.0)) * u2
			+ (slides ? -0.006756779993352952 : 0.0)) * u + (((((slides ? 0.0005565433270609573 : 0.0) * u2
			+ (slides ? 0.003727362560728338 : 0.0)) * u2 + (slides ? 0.01196196007887296 : 0.0)) * u2
			+ (slides ? 0.03022351987090642 : 0.0)) * u2 + (slides ? 0.03672881032013024 : 0.0)) * u2);
		sums.q = (slides ? 0.12499999999999999 : 0.2945243112740431) + (((((((slides ? 9.599696523181972e-5 : 0.0) * u2
			+ (slides ? 0.00020512566198607936 : 0.0)) * u2 + (slides ? 0.0007578948028324588 : 0.0)) * u2
			+ (slides ? 0.0027064823960389526 : 0.0)) * u2 + (slides ? 0.0060636054074984565 : 0.0)) * u2
			+ (slides ? -0.035169773849386424 : 0.0)) * u + (((((slides ? 4.565892708876165e-5 : 0.0) * u2
			+ (slides ? 0.0003731490711301514 : 0.0)) * u2 + (slides ? 0.0014672994473802915 : 0.0)) * u2
			+ (slides ? 0.004545755581923647 : 0.0)) * u2 + (slides ? 0.0016632779265600111 : 0.0)) * u2);
		sums.s = (slides ? 0.05613305077076352 : 0.0) + (((((((slides ? -0.000893695294716854 : 0.0) * u2
			+ (slides ? -0.0016381745867533905 : 0.0)) * u2 + (slides ? -0.0051149005692787 : 0.0)) * u2
			+ (slides ? -0.015519750157831438 : 0.0)) * u2 + (slides ? -0.03556766409748155 : 0.0)) * u2
			+ (slides ? -0.022522599977874362 : 0.0)) * u + (((((slides ? -0.0003757694162855507 : 0.0) * u2
			+ (slides ? -0.0027332476520911704 : 0.0)) * u2 + (slides ? -0.009100538228491223 : 0.0)) * u2
			+ (slides ? -0.024792589910029878 : 0.0)) * u2 + (slides ? -0.04111865281487313 : 0.0)) * u2);
		break;
	default:
		sums.p = (slides ? 0.9369540995406178 : 1.1108579983516844) + (((((((slides ? 0.02215567434318418 : -0.00474710971174276) * u2
			+ (slides ? 0.9900481973241916 : -0.21990690825734865)) * u2
			+ (slides ? 3.53591133620276 : -0.8520434981040126)) * u2
			+ (slides ? 2.0112409182022892 : -0.6274065203625633)) * u2
			+ (slides ? -0.22368106074906952 : -0.03665755572957844)) * u2
			+ (slides ? -0.034334706367294014 : 0.49047266928874467)) * u
			+ (((((slides ? 0.22993404331847042 : -0.04999540787268355) * u2
			+ (slides ? 2.373792971269501 : -0.5442416113453596)) * u2
			+ (slides ? 3.390582853576591 : -0.8899752004305447)) * u2
			+ (slides ? 0.5332992924255608 : -0.2804591149453824)) * u2
			+ (slides ? -0.32021176991574357 : 0.16850154649691093)) * u2);
		sums.r = (slides ? 0.09625381854353118 : -0.5234035742726721) + (((((((slides ? -0.11487422736973855 : 0.02322108315100869) * u2
			+ (slides ? -6.918486962807373 : 1.4237334954956573)) * u2
			+ (slides ? -29.147856949510125 : 6.326373127703122)) * u2
			+ (slides ? -17.86386722660297 : 4.614753786296934)) * u2
			+ (slides ? 1.9498351948302601 : -0.005862160251703828)) * u2
			+ (slides ? 1.1414492044399185 : -0.5518597422440782)) * u
			+ (((((slides ? -1.4169584566046807 : 0.2881355708062571) * u2
			+ (slides ? -18.233013594806042 : 3.8283243944068075)) * u2
			+ (slides ? -29.358129883686495 : 6.750000042367658)) * u2
			+ (slides ? -4.685640377640983 : 1.7619748214471136)) * u2
			+ (slides ? 2.51868340584801 : -0.5087585996805569)) * u2);
		sums.q = (slides ? -0.2207185282591039 : 0.12641165520200448) + (((((((slides ? 4.4911513192513273e-7 : -9.44665446841278e-8) * u2
			+ (slides ? 0.00010094000347248869 : -2.1349926961468476e-5)) * u2
			+ (slides ? -0.09322261944621565 : 0.020173957549304223)) * u2
			+ (slides ? -1.3303930614960233 : 0.30228594170999507)) * u2
			+ (slides ? -2.3149380458299196 : 0.5930769259527126)) * u2
			+ (slides ? -0.7835018247218957 : 0.28712043896428285)) * u
			+ (((((slides ? -7.033095315964081e-6 : 1.4806469564512665e-6) * u2
			+ (slides ? -0.006071016581100276 : 0.0012973181895466008)) * u2
			+ (slides ? -0.4889649983714627 : 0.10788508382208874)) * u2
			+ (slides ? -2.180695112868467 : 0.5186650413972865)) * u2
			+ (slides ? -1.6471877178033705 : 0.47932596746601847)) * u2);
		sums.s = (slides ? 1.092798555278159 : -0.5304587302668485) + (((((((slides ? 1.2889511279168806e-5 : -2.6255465379810287e-6) * u2
			+ (slides ? 0.029681819656309585 : -0.005996964592647652)) * u2
			+ (slides ? 3.5913263566874045 : -0.7355065626691095)) * u2
			+ (slides ? 22.7717117592863 : -4.866578078543814)) * u2
			+ (slides ? 24.236366830437625 : -5.7823541567552965)) * u2
			+ (slides ? 5.225082208042263 : -1.7154352436460691)) * u
			+ (((((slides ? -0.00033905361747153584 : 6.857431742646475e-5) * u2
			+ (slides ? 0.5644411871292135 : -0.11451692417111732)) * u2
			+ (slides ? 11.689646812960113 : -2.4334049028460423)) * u2
			+ (slides ? 28.671213909462647 : -6.389654537937197)) * u2
			+ (slides ? 13.885473742634066 : -3.716895613212874)) * u2);
		break;
	}
	return sums;
}

/* Of the disk, to half of the digits. */
TRIBOS_PART_ tribos_sums_f64_ tribos_rough_sums_f64_(double u)
{
	const double u2 = u * u;
	tribos_sums_f64_ sums;
		sums.p = 0.9586681857686651 + (((-0.048473009140921244 * u2 - 0.21180934259419526) * u2
			+ 0.20715553558197583) * u + (-0.16814267309727726 * u2 - 0.09498434816454472) * u2);
		sums.r = -0.3003398721809165 + (((0.15331368432962458 * u2 + 0.8286953106111493) * u2
			- 0.12954934275513894) * u + (0.6207903425618827 * u2 + 0.3717487256822348) * u2);
		sums.q = 0.1492826864297439 + (((0.00014321837803702085 * u2 + 0.017195551945885203) * u2
			+ 0.18706716613546887) * u + (-0.0009048045303904908 * u2
			+ 0.1039653908729347) * u2);
		sums.s = -0.44560272793750194 + (((0.0015100571077966997 * u2 - 0.3914706677086592) * u2
			- 0.9338532405232598) * u + (-0.04980218212974206 * u2 - 0.9049912978019623) * u2);
	return sums;
}

/* T/F' of spinning alone. */
TRIBOS_PART_ double tribos_inv_moment_f64_(int pressure)
{
	switch (pressure) {
	case TRIBOS_KERNEL_DISK:
		return 1.0 / 1.5;
	case TRIBOS_KERNEL_RING:
		return 1.0 / 0.5;
	case TRIBOS_KERNEL_PUNCH:
		return 1.0 / 1.0;
	case TRIBOS_KERNEL_HERTZ:
		return 1.0 / 2.0;
	default:
		return 1.0 / 2.5;
	}
}

/* Argument of the sums, and what multiplies the singular parts of force and torque, and of the slope. */
typedef struct tribos_hooks_f64_ {
	double argument, hook, slope;
} tribos_hooks_f64_;

TRIBOS_PART_ tribos_hooks_f64_ tribos_hooks_of_f64_(int pressure, double z)
{
	tribos_hooks_f64_ hooks;
	if (tribos_has_roots_(pressure)) {
		const double u = sqrt(z) - 0.5;
		hooks.argument = u * u;
		hooks.hook = u;
		hooks.slope = u;
	} else {
		const double log = tribos_log_f64_(tribos_larger_f64_(2.2250738585072014e-308, z));
		hooks.slope = pressure == TRIBOS_KERNEL_RING ? log
			: pressure == TRIBOS_KERNEL_DISK     ? z * log
							     : z * (z * log);
		hooks.argument = z - 0.5;
		hooks.hook = z * hooks.slope;
	}
	return hooks;
}

/* F/v and T/w in units of the larger speed, where 1 - z is the squared ratio of the smaller to the larger speed. */
typedef struct tribos_factors_f64_ {
	double phi, chi, slope;
} tribos_factors_f64_;

TRIBOS_PART_ tribos_factors_f64_ tribos_force_and_torque_f64_(int pressure, int slides, double z)
{
	const tribos_hooks_f64_ hooks = tribos_hooks_of_f64_(pressure, z);
	const tribos_sums_f64_ sums = tribos_torque_sums_f64_(pressure, slides, hooks.argument);
	const double phi = sums.p + hooks.hook * sums.q, chi = sums.r + hooks.hook * sums.s;
	tribos_factors_f64_ factors;
	factors.phi = phi;
	factors.chi = chi;
	factors.slope = 0.0;
	if (pressure == TRIBOS_KERNEL_DISK) {
		const double turns = slides ? 0.0 : z;
		factors.chi = chi + turns * (tribos_inv_moment_f64_(pressure) * phi - chi);
	} else if (pressure == TRIBOS_KERNEL_RING) {
		factors.phi = slides ? chi : phi;
		factors.chi = slides ? phi : chi;
	}
	return factors;
}

/* Phi and its slope; a ring's slope is infinite at z = 0. */
TRIBOS_PART_ tribos_factors_f64_ tribos_force_and_slope_f64_(int pressure, int slides, double z, int is_rough)
{
	const tribos_hooks_f64_ hooks = tribos_hooks_of_f64_(pressure, z);
	const double argument = pressure == TRIBOS_KERNEL_RING ? z : hooks.argument;
	const tribos_sums_f64_ sums =
		is_rough ? tribos_rough_sums_f64_(argument) : tribos_slope_sums_f64_(pressure, slides, argument);
	tribos_factors_f64_ factors;
	(void)is_rough;
	factors.phi = sums.p + hooks.hook * sums.q;
	factors.slope = sums.r + hooks.slope * sums.s;
	factors.chi = 0.0;
	if (pressure == TRIBOS_KERNEL_RING && fabs(z) <= 0.0)
		factors.slope = 0.0 - sums.s * tribos_infinity_f64_();
	return factors;
}

/* Chi from phi and its slope. */
TRIBOS_PART_ double tribos_torque_of_slope_f64_(int pressure, int slides, double x, double z, tribos_factors_f64_ at)
{
	const double inv_n = tribos_inv_moment_f64_(pressure);
	const double z_slope = fabs(z) <= 0.0 ? 0.0 : z * at.slope;
	const double theta = inv_n * (0.5 * at.phi + z_slope);
	return slides ? theta : inv_n * z * at.phi + x * theta;
}

/* F/v and T of v2 and w. */
typedef struct tribos_drag_f64_ {
	double drag, torque;
} tribos_drag_f64_;

TRIBOS_PART_ tribos_drag_f64_ tribos_drag_of_f64_(int pressure, double slide_sq, double rim)
{
	const double rim_sq = rim * rim;
	const int slides = rim_sq < slide_sq;
	const double major = tribos_larger_f64_(slide_sq, rim_sq), minor = tribos_smaller_f64_(slide_sq, rim_sq);
	const double per_major = 1.0 / major;
	const double z = (major - minor) * per_major;
	const tribos_factors_f64_ factors = tribos_force_and_torque_f64_(pressure, slides, z);
	const double per_speed = sqrt(per_major);
	tribos_drag_f64_ found;
	found.drag = per_speed * factors.phi;
	found.torque = (slides ? rim * per_speed : 1.0) * factors.chi;
	return found;
}

/* Sliding speed and rim speed in units of the larger one. */
typedef struct tribos_speeds_f64_ {
	double major, slide, rim, ratio, gap;
} tribos_speeds_f64_;

TRIBOS_PART_ double tribos_limit_speed_f64_(double speed, double other)
{
	const double infinity = tribos_infinity_f64_();
	if (speed == infinity && other < infinity)
		return 1.0;
	if (other == infinity && speed < infinity)
		return 0.0;
	return speed == infinity ? speed - other : speed + 0.0 * other;
}

TRIBOS_PART_ tribos_speeds_f64_ tribos_speeds_of_f64_(double slide, double rim)
{
	const double v = fabs(slide), w = fabs(rim), major = v > w ? v : w;
	tribos_speeds_f64_ speeds;
	speeds.major = major;
	speeds.slide = v / major;
	speeds.rim = w / major;
	speeds.ratio = speeds.slide * speeds.rim;
	speeds.gap = fabs(v - w) / major;
	if (!(speeds.ratio >= 0.0)) {
		/* Rest, infinities and NaN: limits. */
		speeds.major = v + w;
		speeds.slide = tribos_limit_speed_f64_(v, w);
		speeds.rim = tribos_limit_speed_f64_(w, v);
		speeds.ratio = speeds.slide * speeds.rim;
		speeds.gap = fabs(speeds.slide - speeds.rim);
	}
	return speeds;
}

/* Reduced force and torque of sliding speed and rim speed, drag and torque in that order. */
TRIBOS_PART_ tribos_drag_f64_ tribos_reduced_wrench_f64_(int pressure, double slide, double rim)
{
	const tribos_speeds_f64_ at = tribos_speeds_of_f64_(slide, rim);
	const int slides = at.slide > at.rim;
	const tribos_factors_f64_ factors =
		tribos_force_and_torque_f64_(pressure, slides, at.gap * (1.0 + at.ratio));
	tribos_drag_f64_ found;
	found.drag = at.major == 0.0 ? 0.0 : at.slide * factors.phi;
	found.torque = at.major == 0.0 ? 0.0 : at.rim * factors.chi;
	return found;
}

/* F/v, dF/dv, dF/dw = dT/dv and dT/dw. */
typedef struct tribos_rates_f64_ {
	double drag, slide, mixed, rim;
} tribos_rates_f64_;

/* h^p (a + b h2) times a scale, p = 0 or 1. */
TRIBOS_PART_ double tribos_wide_entry_f64_(tribos_wide_f64_ scale, tribos_wide_f64_ h, int is_odd, double a, double b)
{
	const tribos_wide_f64_ square = tribos_wide_times_f64_(h, h);
	const tribos_wide_f64_ sum = tribos_wide_plus_f64_(
		tribos_wide_of_f64_(a, 0), tribos_wide_times_f64_(square, tribos_wide_of_f64_(b, 0)));
	const tribos_wide_f64_ product = is_odd ? tribos_wide_times_f64_(h, sum) : sum;
	return tribos_wide_value_f64_(
		tribos_is_number_f64_(product) ? tribos_wide_times_f64_(product, scale) : product);
}

/* Rates where the ratio of the speeds or 1 over the larger one leaves the normal numbers. */
TRIBOS_RARE_ tribos_rates_f64_ tribos_wide_rates_f64_(tribos_speeds_f64_ at, double v, double w, tribos_factors_f64_ by)
{
	const double major = v > w ? v : w, minor = v > w ? w : v, bend = 2.0 * by.slope, none = 0.0;
	const tribos_wide_f64_ m = tribos_wide_of_f64_(major, 0);
	const tribos_wide_f64_ scale = tribos_wide_over_f64_(tribos_wide_of_f64_(1.0, 0), m);
	const tribos_wide_f64_ h = tribos_wide_over_f64_(tribos_wide_of_f64_(minor, 0), m);
	tribos_rates_f64_ rates;
	rates.drag = tribos_wide_entry_f64_(scale, h, 0, by.phi, none);
	if (at.slide > at.rim) {
		rates.slide = tribos_wide_entry_f64_(scale, h, 0, none, -bend);
		rates.mixed = tribos_wide_entry_f64_(scale, h, 1, bend, none);
		rates.rim = tribos_wide_entry_f64_(scale, h, 0, none - bend, none);
	} else {
		rates.slide = tribos_wide_entry_f64_(scale, h, 0, by.phi, bend);
		rates.mixed = tribos_wide_entry_f64_(scale, h, 1, -by.phi, -bend);
		rates.rim = tribos_wide_entry_f64_(scale, h, 0, none, by.phi + at.ratio * at.ratio * bend);
	}
	return rates;
}

TRIBOS_PART_ tribos_rates_f64_ tribos_rates_of_f64_(int pressure, double slide, double rim)
{
	const tribos_speeds_f64_ at = tribos_speeds_of_f64_(slide, rim);
	const int slides = at.slide > at.rim;
	const double h = at.ratio, x = h * h, z = at.gap * (1.0 + h), scale = 1.0 / at.major;
	tribos_factors_f64_ factors = tribos_force_and_slope_f64_(pressure, slides, z, 0);
	tribos_rates_f64_ rates;
	if (at.major == 0.0 || !tribos_is_finite_f64_(at.major)) {
		/* At rest the limit of damping; there is none of infinite speeds. */
		rates.drag = at.major == 0.0 ? tribos_infinity_f64_() : tribos_nan_f64_();
		rates.slide = rates.rim = rates.drag;
		rates.mixed = at.major == 0.0 ? 0.0 : rates.drag;
		return rates;
	}
	factors.chi = tribos_torque_of_slope_f64_(pressure, slides, x, z, factors);
	if (tribos_is_normal_f64_(scale) && (x >= 2.2250738585072014e-308 || slide == 0.0 || rim == 0.0)) {
		const double bend = 2.0 * factors.slope, x_bend = x * bend;
		const double turned = -h * (factors.phi + x_bend);
		rates.drag = scale * factors.phi;
		rates.slide = scale * (slides ? 0.0 - x_bend : factors.phi + x_bend);
		rates.mixed = scale * (slides ? h * bend : turned);
		rates.rim = scale * (slides ? 0.0 - bend : 0.0 - h * turned);
		return rates;
	}
	return tribos_wide_rates_f64_(at, fabs(slide), fabs(rim), factors);
}

/* ---- Wrench and Jacobian of round patches ---- */

/* The wrench without sliding, at rest and where a product may leave the range of numbers. */
TRIBOS_RARE_ tribos_kernel_wrench_f64 tribos_wide_wrench_f64_(
	int pressure, tribos_kernel_twist_f64 twist, double strength, double radius)
{
	const double speed = tribos_hypot_f64_(twist.x, twist.y);
	const tribos_drag_f64_ reduced = tribos_reduced_wrench_f64_(pressure, speed, twist.spin * radius);
	const double force = strength * reduced.drag, torque = strength * radius * reduced.torque;
	const double drag = force / speed;
	const int is_plain = tribos_is_normal_f64_(drag);
	tribos_kernel_wrench_f64 wrench;
	wrench.torque = -copysign(torque, twist.spin);
	if (speed == 0.0) {
		wrench.x = wrench.y = force != force ? force : 0.0;
		return wrench;
	}
	wrench.x = -(is_plain ? drag * twist.x : force * (twist.x / speed));
	wrench.y = -(is_plain ? drag * twist.y : force * (twist.y / speed));
	return wrench;
}

/* Friction of a round patch that moves with a twist, against it. Zero at rest. */
TRIBOS_FN tribos_kernel_wrench_f64 tribos_kernel_round_wrench_f64(
	int pressure, tribos_kernel_twist_f64 twist, double strength, double radius)
{
	const double least = 1e-140, most = 1.0 / 1e-140;
	const double rim = fabs(twist.spin * radius), square = twist.x * twist.x + twist.y * twist.y;
	const int moves = square > least * least && square < most * most;
	if (moves && (rim == 0.0 || (rim > least && rim < most))) {
		const tribos_drag_f64_ reduced = tribos_drag_of_f64_(pressure, square, rim);
		const double drag = strength * reduced.drag;
		if (tribos_is_normal_f64_(drag)) {
			tribos_kernel_wrench_f64 wrench;
			wrench.x = -(drag * twist.x);
			wrench.y = -(drag * twist.y);
			wrench.torque = -copysign(strength * radius * reduced.torque, twist.spin);
			return wrench;
		}
	}
	return tribos_wide_wrench_f64_(pressure, twist, strength, radius);
}

/* Its derivatives by the twist, negative semidefinite. At rest the diagonal is minus infinity, what is beside it 0. */
TRIBOS_FN tribos_kernel_jacobian_f64 tribos_kernel_round_jacobian_f64(
	int pressure, tribos_kernel_twist_f64 twist, double strength, double radius)
{
	const double speed = tribos_hypot_f64_(twist.x, twist.y);
	const tribos_rates_f64_ rates = tribos_rates_of_f64_(pressure, speed, twist.spin * radius);
	const double cosine = speed == 0.0 ? 1.0 : twist.x / speed, sine = speed == 0.0 ? 0.0 : twist.y / speed;
	const double along = strength * rates.slide, across = strength * rates.drag;
	const double mixed = strength * radius * rates.mixed * copysign(1.0, twist.spin);
	const double cc = cosine * cosine, ss = sine * sine;
	tribos_kernel_jacobian_f64 jacobian;
	jacobian.xx = along == across ? -along : -(along * cc + across * ss);
	jacobian.xy = along == across ? -0.0 : -((along - across) * cosine * sine);
	jacobian.yy = along == across ? -along : -(along * ss + across * cc);
	jacobian.xn = -(mixed * cosine);
	jacobian.yn = -(mixed * sine);
	jacobian.nn = -(strength * radius * radius * rates.rim);
	return jacobian;
}

/* ---- The limit surface of a round patch: a curve over the ratio h of the smaller to the larger speed ---- */

/* T of spinning alone. */
TRIBOS_PART_ double tribos_spin_torque_f64_(int pressure)
{
	switch (pressure) {
	case TRIBOS_KERNEL_DISK:
		return 0.6666666666666666;
	case TRIBOS_KERNEL_RING:
		return 1.0;
	case TRIBOS_KERNEL_PUNCH:
		return 0.7853981633974483;
	case TRIBOS_KERNEL_HERTZ:
		return 0.5890486225480863;
	default:
		return 0.5333333333333334;
	}
}

/* Force and torque at equal speeds, and lines a f + b t = 1 through that point and a pole: the force's, the torque's. */
typedef struct tribos_chords_f64_ {
	double force, torque, a, b, c, d;
} tribos_chords_f64_;

TRIBOS_PART_ tribos_chords_f64_ tribos_chords_of_f64_(int pressure)
{
	tribos_chords_f64_ chords;
	switch (pressure) {
	case TRIBOS_KERNEL_DISK:
		chords.force = 0.8488263631567752;
		chords.torque = 0.28294212105225836;
		chords.a = 1.0;
		chords.b = 0.5342917352885173;
		chords.c = 0.6780972450961724;
		chords.d = 1.5;
		break;
	case TRIBOS_KERNEL_RING:
		chords.force = 0.6366197723675814;
		chords.torque = 0.6366197723675813;
		chords.a = 1.0;
		chords.b = 0.5707963267948967;
		chords.c = 0.5707963267948967;
		chords.d = 1.0;
		break;
	case TRIBOS_KERNEL_PUNCH:
		chords.force = 0.7853981633974483;
		chords.torque = 0.39269908169872414;
		chords.a = 1.0;
		chords.b = 0.5464790894703254;
		chords.c = 0.6366197723675814;
		chords.d = 1.2732395447351628;
		break;
	case TRIBOS_KERNEL_HERTZ:
		chords.force = 0.8835729338221294;
		chords.torque = 0.22089323345553238;
		chords.a = 1.0000000000000002;
		chords.b = 0.527073936836133;
		chords.c = 0.7073553026306458;
		chords.d = 1.69765272631355;
		break;
	default:
		chords.force = 0.9054147873672269;
		chords.torque = 0.18108295747344538;
		chords.a = 1.0;
		chords.b = 0.5223308363883077;
		chords.c = 0.7294661672776617;
		chords.d = 1.8749999999999996;
		break;
	}
	return chords;
}

/* The polynomials from which searches start: M at the pole, m/h by powers of h2, and M and m at equal speeds. */
typedef struct tribos_start_f64_ {
	double top, a, b, c, d, e, f, major, minor;
} tribos_start_f64_;

TRIBOS_PART_ tribos_start_f64_ tribos_start_of_f64_(int pressure, int slides)
{
	tribos_start_f64_ start;
	switch (pressure) {
	case TRIBOS_KERNEL_DISK:
		start.top = (slides ? 1.0 : 0.6666666666666666);
		start.a = (slides ? 0.24999154177350574 : 1.0000101962888028);
		start.b = (slides ? 0.021435416085238655 : -0.1257259774877332);
		start.c = (slides ? -0.0007538073760061708 : -0.007640610867945975);
		start.d = (slides ? 0.027361512451160724 : -0.0350518386214999);
		start.e = (slides ? -0.036944608557294666 : 0.044332341545866856);
		start.f = (slides ? 0.021772480209553493 : -0.027009538407044908);
		start.major = (slides ? 0.8488263631567752 : 0.28294212105225836);
		start.minor = (slides ? 0.28294212105225836 : 0.8488263631567752);
		break;
	case TRIBOS_KERNEL_RING:
		start.top = 1.0;
		start.a = 0.4998416137984154;
		start.b = 0.07376218530529333;
		start.c = -0.09953809488492915;
		start.d = (slides ? 0.4699945928828697 : 0.46999459288291234);
		start.e = (slides ? -0.6788869658204462 : -0.6788869658204604);
		start.f = 0.36747466089406444;
		start.major = (slides ? 0.6366197723675814 : 0.6366197723675813);
		start.minor = (slides ? 0.6366197723675813 : 0.6366197723675814);
		break;
	case TRIBOS_KERNEL_PUNCH:
		start.top = (slides ? 1.0 : 0.7853981633974483);
		start.a = (slides ? 0.33330169875749394 : 0.7853981633974483);
		start.b = (slides ? 0.03558394710043178 : 4.440892098500626e-16);
		start.c = (slides ? -0.01393283142466295 : -5.329070518200751e-15);
		start.d = (slides ? 0.09726805273428596 : 1.4210854715202004e-14);
		start.e = (slides ? -0.13714675296349554 : -2.3561944715311256e-6);
		start.f = (slides ? 0.07717600400261304 : 1.4210854715202004e-14);
		start.major = (slides ? 0.7853981633974483 : 0.39269908169872414);
		start.minor = (slides ? 0.39269908169872414 : 0.7853981633974483);
		break;
	case TRIBOS_KERNEL_HERTZ:
		start.top = (slides ? 0.9999999999999999 : 0.5890486225480863);
		start.a = (slides ? 0.1999972432874321 : 1.1780972450961724);
		start.b = (slides ? 0.014482051396409845 : -0.2945243112740443);
		start.c = (slides ? 0.001408601503459117 : -2.1316282072803006e-14);
		start.d = (slides ? 0.009552114132231893 : 7.815970093361102e-14);
		start.e = (slides ? -0.012066368293456975 : -2.9781625414671e-6);
		start.f = (slides ? 0.007499886561893376 : 2.842170943040401e-14);
		start.major = (slides ? 0.8835729338221294 : 0.22089323345553238);
		start.minor = (slides ? 0.22089323345553238 : 0.8835729338221294);
		break;
	default:
		start.top = (slides ? 1.0 : 0.5333333333333334);
		start.a = (slides ? 0.16666562705007876 : 1.3333313897760286);
		start.b = (slides ? 0.010490748071550371 : -0.4998613947345121);
		start.c = (slides ? 0.0015253934055707852 : 0.06096227477580207);
		start.d = (slides ? 0.003934166994026711 : 0.012426536539997812);
		start.e = (slides ? -0.004529664004067513 : -0.007712689191336608);
		start.f = (slides ? 0.0029904976221919455 : 0.006256893741117153);
		start.major = (slides ? 0.9054147873672269 : 0.18108295747344538);
		start.minor = (slides ? 0.18108295747344538 : 0.9054147873672269);
		break;
	}
	return start;
}

/* A point with its normal (1, h), the leading component first, and dm/dh. */
typedef struct tribos_point_f64_ {
	double major, minor, rate;
} tribos_point_f64_;

TRIBOS_PART_ tribos_point_f64_ tribos_point_of_f64_(int pressure, int slides, double ratio, int is_rough)
{
	const double x = ratio * ratio;
	const double z = tribos_is_smooth_(pressure) ? 1.0 - x : (1.0 - ratio) * (1.0 + ratio);
	const tribos_factors_f64_ at = tribos_force_and_slope_f64_(pressure, slides, z, is_rough);
	const double chi = tribos_torque_of_slope_f64_(pressure, slides, x, z, at);
	tribos_point_f64_ point;
	point.major = slides ? at.phi : chi;
	point.minor = ratio * (slides ? chi : at.phi);
	point.rate = slides ? -(2.0 * at.slope) : at.phi + 2.0 * x * at.slope;
	return point;
}

/* The equation of a search for a given point (A, a): A m - a M = 0 on its ray, (A - M) h - k (a - m) = 0 nearest to it. */
typedef struct tribos_equation_f64_ {
	int is_ray;
	double major, minor, weight;
} tribos_equation_f64_;

TRIBOS_PART_ double tribos_value_f64_(tribos_equation_f64_ given, double ratio, tribos_point_f64_ at)
{
	return given.is_ray ? given.major * at.minor - given.minor * at.major
			    : (given.major - at.major) * ratio - given.weight * (given.minor - at.minor);
}

TRIBOS_PART_ double tribos_rate_f64_(tribos_equation_f64_ given, double ratio, tribos_point_f64_ at)
{
	return given.is_ray ? (given.major + given.minor * ratio) * at.rate
			    : (given.major - at.major) + (ratio * ratio + given.weight) * at.rate;
}

/* A step of Chebyshev's on the polynomials. */
TRIBOS_PART_ double tribos_stepped_f64_(tribos_start_f64_ of, double ratio, tribos_equation_f64_ given)
{
	const double x = ratio * ratio;
	double sum = of.f * x + of.e, bend = of.f, slope = of.f * x + sum, loss = of.f * 0.9166666666666666;
	double turn, value, per_rate, newton, bent, next;
	tribos_point_f64_ at;
	sum = sum * x + of.d;
	bend = bend * x + slope;
	slope = slope * x + sum;
	sum = sum * x + of.c;
	bend = bend * x + slope;
	slope = slope * x + sum;
	sum = sum * x + of.b;
	bend = bend * x + slope;
	slope = slope * x + sum;
	sum = sum * x + of.a;
	loss = loss * x + of.e * 0.9;
	loss = loss * x + of.d * 0.875;
	loss = loss * x + of.c * 0.8333333333333334;
	loss = loss * x + of.b * 0.75;
	loss = loss * x + of.a * 0.5;
	turn = ratio * (6.0 * slope + 8.0 * x * bend);
	at.major = of.top - x * loss;
	at.minor = ratio * sum;
	at.rate = sum + 2.0 * x * slope;
	value = tribos_value_f64_(given, ratio, at);
	per_rate = 1.0 / tribos_rate_f64_(given, ratio, at);
	newton = value * per_rate;
	bent = given.is_ray ? given.minor * at.rate + (given.major + given.minor * ratio) * turn
			    : 3.0 * ratio * at.rate + (ratio * ratio + given.weight) * turn;
	bent = 0.5 * bent * per_rate;
	next = ratio - newton * (1.0 + newton * bent);
	return tribos_is_ratio_f64_(next) ? next : ratio;
}

/* Where a search on the ray of a point starts. */
TRIBOS_PART_ double tribos_start_on_ray_f64_(tribos_start_f64_ of, tribos_equation_f64_ given)
{
	const double slope = given.minor / given.major, at_pole = of.a / of.top;
	const double ratio = slope / (at_pole + (1.0 - at_pole * of.major / of.minor) * slope);
	return tribos_stepped_f64_(of, ratio, given);
}

/* Where a search for the nearest point starts. */
TRIBOS_PART_ double tribos_start_nearest_f64_(tribos_start_f64_ of, tribos_equation_f64_ given)
{
	const double value = -(given.weight * given.minor);
	const double linear = given.major - of.top + given.weight * of.a;
	const double both = given.major - of.major + given.weight * of.minor;
	const double cubic = both - linear;
	const double chord = -(value / both);
	const double bend = cubic * chord * chord;
	const double curved = (2.0 * bend * chord - value) / (linear + 3.0 * bend);
	const double first = tribos_is_ratio_f64_(curved) ? curved : chord;
	const double second = tribos_stepped_f64_(of, first, given);
	return 0.03 < fabs(second - first) ? tribos_stepped_f64_(of, second, given) : second;
}

/* Where a search ended, with the last ratio whose point was computed and M + h m there. */
typedef struct tribos_end_f64_ {
	double ratio, major, minor, before, power;
} tribos_end_f64_;

/* The last step moves the point along the curve: dM/dh = -h dm/dh. */
TRIBOS_PART_ tribos_end_f64_ tribos_end_of_f64_(double step, double ratio, tribos_point_f64_ at)
{
	const double change = at.rate * step;
	tribos_end_f64_ end;
	end.before = ratio;
	end.power = at.major + ratio * at.minor;
	end.ratio = ratio + step;
	end.major = at.major - (ratio + 0.5 * step) * change;
	end.minor = at.minor + change;
	return end;
}

TRIBOS_PART_ double tribos_settled_f64_(double ratio)
{
	return 256.0 * 2.220446049250313e-16 * ratio + 2.2250738585072014e-308;
}

/* True where a Newton step is the last one. */
TRIBOS_PART_ int tribos_is_last_f64_(int pressure, double step, double newton, double before)
{
	const double square = step * step;
	const int is_short = square <= 0.5 * 2.220446049250313e-16;
	if (tribos_is_smooth_(pressure))
		return is_short;
	return fabs(step) <= tribos_settled_f64_(newton)
		|| (fabs(step) * square <= 0.125 * 2.220446049250313e-16 * (before * before * newton) && is_short);
}

/* Newton steps kept in a bracket, at most 65 points. */
TRIBOS_RARE_ tribos_end_f64_ tribos_bracketed_f64_(
	int pressure, int slides, tribos_equation_f64_ given, double ratio, double before, tribos_point_f64_ at)
{
	double low = 0.0, high = 1.0, from = ratio, by = 0.0;
	int left, is_done = 0;
	tribos_end_f64_ end;
	for (left = 64;; --left) {
		const double value = tribos_value_f64_(given, ratio, at), rate = tribos_rate_f64_(given, ratio, at);
		const double step = -(value / rate), newton = ratio + step;
		int is_newton, is_narrow, is_end;
		from = ratio;
		if (value < 0.0)
			low = ratio;
		else
			high = ratio;
		is_newton = fabs(rate) < tribos_infinity_f64_() && low <= newton && newton <= high;
		is_narrow = high - low <= tribos_settled_f64_(high);
		is_end = !(0.0 < fabs(value));
		is_done = is_end || (is_newton ? tribos_is_last_f64_(pressure, step, newton, before) : is_narrow);
		by = is_newton && !is_end ? step : 0.0;
		ratio = is_newton ? newton : 0.5 * (low + high);
		before = is_newton ? step : 0.0;
		if (is_done || left == 0)
			break;
		at = tribos_point_of_f64_(pressure, slides, ratio, 0);
	}
	if (!(0.0 < fabs(by)))
		at.rate = by = 0.0;
	end = tribos_end_of_f64_(by, from, at);
	if (!is_done)
		end.ratio = end.major = end.minor = end.before = end.power = tribos_nan_f64_();
	return end;
}

/* The zero in [0, 1] of an equation along the curve. */
TRIBOS_PART_ tribos_end_f64_ tribos_solved_f64_(int pressure, int slides, double start, tribos_equation_f64_ given)
{
	const int is_smooth = tribos_is_smooth_(pressure), is_rough = pressure == TRIBOS_KERNEL_DISK;
	double ratio = tribos_is_ratio_f64_(start) ? start : 1.0, before = 0.0, value, rate, step, newton;
	tribos_point_f64_ at;
	if (!(0 && is_smooth)) {
		/* From here a step leads next to the end. */
		at = tribos_point_of_f64_(pressure, slides, ratio, is_rough);
		step = -(tribos_value_f64_(given, ratio, at) / tribos_rate_f64_(given, ratio, at));
		newton = ratio + step;
		before = tribos_is_ratio_f64_(newton) ? step : 0.0;
		ratio = tribos_is_ratio_f64_(newton) ? newton : ratio;
	}
	at = tribos_point_of_f64_(pressure, slides, ratio, 0);
	value = tribos_value_f64_(given, ratio, at);
	rate = tribos_rate_f64_(given, ratio, at);
	step = -(value / rate);
	newton = ratio + step;
	if (0.0 < rate && rate < tribos_infinity_f64_() && tribos_is_ratio_f64_(newton)
		&& tribos_is_last_f64_(pressure, step, newton, before))
		return tribos_end_of_f64_(step, ratio, at);
	return tribos_bracketed_f64_(pressure, slides, given, ratio, before, at);
}

/* A planar vector and its normal companion as magnitudes, with what these leave out. */
typedef struct tribos_pair_f64_ {
	double planar, normal, x, y, sign;
} tribos_pair_f64_;

TRIBOS_PART_ tribos_pair_f64_ tribos_pair_of_f64_(double x, double y, double normal)
{
	const double least = 1e-140 * 1e-140, square = x * x + y * y;
	const int is_ordinary = (least < square && square < 1.0 / least) || fabs(x) + fabs(y) <= 0.0;
	tribos_pair_f64_ pair;
	pair.planar = is_ordinary ? sqrt(square) : tribos_hypot_f64_(x, y);
	pair.normal = fabs(normal);
	pair.x = pair.planar <= 0.0 ? 0.0 : x / pair.planar;
	pair.y = pair.planar <= 0.0 ? 0.0 : y / pair.planar;
	pair.sign = normal;
	return pair;
}

/* A normal (slide, rim), of which the larger part is 1, as a twist of length 1. */
TRIBOS_PART_ tribos_kernel_twist_f64 tribos_unit_twist_f64_(tribos_pair_f64_ pair, double slide, double rim, double radius)
{
	const double ratio = slide * rim, share = 1.0 / sqrt(1.0 + ratio * ratio);
	tribos_kernel_twist_f64 twist;
	twist.x = slide * share * pair.x;
	twist.y = slide * share * pair.y;
	twist.spin = copysign(rim * share / radius, pair.sign);
	return twist;
}

/* The normal where the ray of a point meets the curve, and the gauge of the point in its unit. */
typedef struct tribos_ray_f64_ {
	double slide, rim, gauge;
} tribos_ray_f64_;

TRIBOS_PART_ tribos_ray_f64_ tribos_ray_of_f64_(int pressure, double force, double torque)
{
	const tribos_chords_f64_ equal = tribos_chords_of_f64_(pressure);
	const int slides = torque * equal.force <= force * equal.torque;
	tribos_equation_f64_ given;
	tribos_end_f64_ end;
	tribos_ray_f64_ ray;
	double known;
	given.is_ray = 1;
	given.major = slides ? force : torque;
	given.minor = slides ? torque : force;
	given.weight = 0.0;
	end = tribos_solved_f64_(
		pressure, slides, tribos_start_on_ray_f64_(tribos_start_of_f64_(pressure, slides), given), given);
	ray.gauge = (given.major + given.minor * end.before) / end.power;
	known = 1.0 + 0.0 * ray.gauge;
	ray.slide = slides ? known : end.ratio * known;
	ray.rim = slides ? end.ratio * known : known;
	return ray;
}

/* The same of a point of any size: `unit` is the larger component where their products may not be normal numbers. */
TRIBOS_PART_ int tribos_is_ordinary_f64_(double size)
{
	return (1e-140 < size && size < 1.0 / 1e-140) || fabs(size) <= 0.0;
}

TRIBOS_PART_ tribos_ray_f64_ tribos_ray_in_range_f64_(int pressure, double force, double torque, double *unit)
{
	const int is_ordinary = tribos_is_ordinary_f64_(force) && tribos_is_ordinary_f64_(torque);
	const double size = is_ordinary ? 1.0 : tribos_larger_f64_(torque, force);
	*unit = size;
	return tribos_ray_of_f64_(
		pressure, is_ordinary ? force : force / size, is_ordinary ? torque : torque / size);
}

/* No force limit that is negative or NaN. */
TRIBOS_PART_ double tribos_limit_of_f64_(double strength)
{
	const double limit = strength + 0.0;
	return 0.0 <= limit ? limit : tribos_nan_f64_();
}

/* The smallest factor f >= 0 with wrench/f in the set: below 1 inside, 1 on the surface; 0 for no wrench, infinite for an
 * infinite one and for any under no strength. */
TRIBOS_FN double tribos_kernel_round_gauge_f64(
	int pressure, tribos_kernel_wrench_f64 wrench, double strength, double radius)
{
	const double limit = tribos_limit_of_f64_(strength), infinity = tribos_infinity_f64_();
	const tribos_pair_f64_ pair = tribos_pair_of_f64_(wrench.x, wrench.y, wrench.torque);
	const double force = pair.planar, torque = pair.normal / radius;
	tribos_ray_f64_ ray;
	double unit;
	if (force == 0.0 && torque == 0.0)
		return 0.0;
	if (force + torque == infinity && (force == infinity || torque == infinity))
		return infinity + limit;
	ray = tribos_ray_in_range_f64_(pressure, force, torque, &unit);
	return unit == 1.0 ? ray.gauge / limit : unit / limit * ray.gauge;
}

/* The motion that a push causes: the outward normal where its ray meets the surface, with |velocity|2 + (spin radius)2 = 1.
 * Zero for no push, NaN for an infinite one. */
TRIBOS_FN tribos_kernel_twist_f64 tribos_kernel_round_normal_f64(
	int pressure, tribos_kernel_wrench_f64 push, double radius)
{
	tribos_kernel_twist_f64 none;
	tribos_pair_f64_ pair;
	tribos_ray_f64_ ray;
	double unit;
	if (push.x == 0.0 && push.y == 0.0 && push.torque == 0.0) {
		none.x = none.y = none.spin = 0.0;
		return none;
	}
	pair = tribos_pair_of_f64_(push.x, push.y, push.torque);
	ray = tribos_ray_in_range_f64_(pressure, pair.planar, pair.normal / radius, &unit);
	return tribos_unit_twist_f64_(pair, ray.slide, ray.rim, radius);
}

/* The projection of a wrench that the set holds. */
TRIBOS_PART_ tribos_kernel_projection_f64 tribos_held_f64_(tribos_kernel_wrench_f64 wrench)
{
	tribos_kernel_projection_f64 held;
	held.wrench = wrench;
	held.normal.x = held.normal.y = held.normal.spin = 0.0;
	held.slides = 0;
	return held;
}

/* That of one that has no nearest point. */
TRIBOS_PART_ tribos_kernel_projection_f64 tribos_unknown_f64_(void)
{
	tribos_kernel_projection_f64 unknown;
	unknown.wrench.x = unknown.wrench.y = unknown.wrench.torque = tribos_nan_f64_();
	unknown.normal.x = unknown.normal.y = unknown.normal.spin = tribos_nan_f64_();
	unknown.slides = 1;
	return unknown;
}

/* That of a wrench next to the surface, of which `nearest` is that of one outside. */
TRIBOS_RARE_ tribos_kernel_projection_f64 tribos_beside_f64_(
	int pressure, tribos_kernel_wrench_f64 wrench, double strength, double radius, tribos_kernel_projection_f64 nearest)
{
	const double gauge = tribos_kernel_round_gauge_f64(pressure, wrench, strength, radius);
	if (gauge < 1.0 - 64.0 * 2.220446049250313e-16)
		return tribos_held_f64_(wrench);
	if (gauge <= 1.0 + 64.0 * 2.220446049250313e-16) {
		nearest.wrench = wrench;
		nearest.normal = tribos_kernel_round_normal_f64(pressure, wrench, radius);
		nearest.slides = 1;
	}
	return nearest;
}

/* That onto {0}, the set without strength. */
TRIBOS_RARE_ tribos_kernel_projection_f64 tribos_to_origin_f64_(tribos_pair_f64_ pair, double radius, double length)
{
	const double lever = length / radius, rim = pair.normal / length / lever;
	const double norm = tribos_hypot_f64_(pair.planar, rim);
	tribos_kernel_projection_f64 found;
	if (!(tribos_is_finite_f64_(norm) && length > 0.0))
		return tribos_unknown_f64_();
	found.wrench.x = found.wrench.y = found.wrench.torque = 0.0;
	found.normal.x = pair.planar / norm * pair.x;
	found.normal.y = pair.planar / norm * pair.y;
	found.normal.spin = copysign(rim / norm / radius, pair.sign);
	found.slides = 1;
	return found;
}

/* The wrench of the set nearest to a given one by the distance sqrt(|force|2 + (torque/length)2), 0 < length < infinity:
 * with the radius of gyration as length that of kinetic energy. NaN for an infinite wrench. */
TRIBOS_FN tribos_kernel_projection_f64 tribos_kernel_round_project_f64(
	int pressure, tribos_kernel_wrench_f64 wrench, double strength, double radius, double length)
{
	const tribos_chords_f64_ chords = tribos_chords_of_f64_(pressure);
	const double limit = tribos_limit_of_f64_(strength), collar = 2.0 * (64.0 * 2.220446049250313e-16);
	const tribos_pair_f64_ pair = tribos_pair_of_f64_(wrench.x, wrench.y, wrench.torque);
	const double arm = pair.normal / radius;
	const double bound = tribos_larger_f64_(
		chords.c * pair.planar + chords.d * arm, chords.a * pair.planar + chords.b * arm);
	const int has_length = length > 0.0 && tribos_is_finite_f64_(length);
	const double lever = (has_length ? length : radius) / radius, lever_sq = lever * lever;
	const double force = pair.planar / limit, torque = arm / limit;
	tribos_kernel_projection_f64 nearest;
	tribos_equation_f64_ given;
	tribos_end_f64_ end;
	double beyond, width;
	int slides;
	/* So far inside that no search is needed, by an inscribed quadrangle. */
	if (bound < limit * (1.0 - collar) || (wrench.x == 0.0 && wrench.y == 0.0 && wrench.torque == 0.0))
		return tribos_held_f64_(wrench);
	if (limit == 0.0)
		return tribos_to_origin_f64_(pair, radius, length);
	if (!(tribos_is_finite_f64_(force) && tribos_is_finite_f64_(torque)))
		return tribos_unknown_f64_();
	slides = torque - chords.torque <= lever_sq * (force - chords.force);
	given.is_ray = 0;
	given.major = slides ? force : torque;
	given.minor = slides ? torque : force;
	given.weight = slides ? 1.0 / lever_sq : lever_sq;
	end = tribos_solved_f64_(
		pressure, slides, tribos_start_nearest_f64_(tribos_start_of_f64_(pressure, slides), given), given);
	beyond = (given.major - end.major) + end.ratio * (given.minor - end.minor);
	width = collar * end.power;
	if (beyond < -width)
		return tribos_held_f64_(wrench);
	nearest.wrench.x = limit * (slides ? end.major : end.minor) * pair.x;
	nearest.wrench.y = limit * (slides ? end.major : end.minor) * pair.y;
	nearest.wrench.torque = copysign(limit * radius * (slides ? end.minor : end.major), pair.sign);
	nearest.normal = tribos_unit_twist_f64_(pair, slides ? 1.0 : end.ratio, slides ? end.ratio : 1.0, radius);
	nearest.slides = 1;
	if (!has_length)
		nearest = tribos_unknown_f64_();
	return width < beyond ? nearest : tribos_beside_f64_(pressure, wrench, strength, radius, nearest);
}

/* ---- Polygons under uniform pressure ---- */

/* An edge, prepared: where it begins and how it lies, in radii about the centroid. */
typedef struct tribos_kernel_edge_f64 {
	double x, y;                 /* the corner of the same number */
	double tangent_x, tangent_y; /* of length 1; the patch lies to the left */
	double length;
	double offset;               /* distance of the centroid to the left of its line */
} tribos_kernel_edge_f64;

/* A polygon, prepared. */
typedef struct tribos_kernel_polygon_f64 {
	double x, y;   /* the centroid, in the corners' coordinates */
	double radius; /* distance of the farthest corner from it */
	double area;   /* in units of radius2 */
	double arm;    /* largest torque about the origin over the strength */
	double reach;  /* bound of the corners' distances from the origin */
	double rounding; /* of its dissipated power: grows with the aspect ratio of slender patches */
	int count;   /* corners */
} tribos_kernel_polygon_f64;

/* A motion (v, w) of the centroid in radii, |v|2 + w2 = 1, with 1 over what it was divided by. */
typedef struct tribos_unit_motion_f64_ {
	double x, y, spin, rate;
} tribos_unit_motion_f64_;

/* True of speeds whose squares are normal numbers with digits to spare. */
TRIBOS_PART_ int tribos_has_square_f64_(double sq)
{
	return sq > 2.2250738585072014e-308 / 2.220446049250313e-16 && sq < tribos_infinity_f64_();
}

/* The power of two that brings speeds of this size to such. */
TRIBOS_PART_ double tribos_to_ordinary_f64_(double size)
{
	const double down = sqrt(2.2250738585072014e-308), up = 1.0 / down;
	if (tribos_has_square_f64_(size * size))
		return 1.0;
	if (size < 1.0)
		return tribos_has_square_f64_(size * up * (size * up)) ? up : up * up;
	return down * 0.125;
}

/* True where a patch moves, with what its twist is multiplied by besides; else `unit` is what every component of its
 * friction is: 0 at rest, NaN for NaN. */
TRIBOS_PART_ int tribos_unit_motion_of_f64_(
	tribos_kernel_polygon_f64 polygon, tribos_kernel_twist_f64 twist, tribos_unit_motion_f64_ *motion, double *unit)
{
	double vx = twist.x - twist.spin * polygon.y, vy = twist.y + twist.spin * polygon.x;
	double rim = twist.spin * polygon.radius, size = fabs(vx) + fabs(vy) + fabs(rim), by = 1.0, sq;
	*unit = 0.0;
	if (!tribos_has_square_f64_(size * size)) {
		double of_twist, of_speeds;
		if (!(tribos_is_finite_f64_(twist.x) && tribos_is_finite_f64_(twist.y)
			&& tribos_is_finite_f64_(twist.spin))) {
			*unit = tribos_nan_f64_();
			return 0;
		}
		of_twist = tribos_to_ordinary_f64_(fabs(twist.x) + fabs(twist.y) + fabs(twist.spin));
		twist.x = twist.x * of_twist;
		twist.y = twist.y * of_twist;
		twist.spin = twist.spin * of_twist;
		vx = twist.x - twist.spin * polygon.y;
		vy = twist.y + twist.spin * polygon.x;
		rim = twist.spin * polygon.radius;
		of_speeds = tribos_to_ordinary_f64_(fabs(vx) + fabs(vy) + fabs(rim));
		vx = vx * of_speeds;
		vy = vy * of_speeds;
		rim = rim * of_speeds;
		if (vx == 0.0 && vy == 0.0 && rim == 0.0)
			return 0;
		by = of_twist * of_speeds;
	}
	sq = vx * vx + vy * vy + rim * rim;
	if (tribos_has_square_f64_(sq)) {
		const double rate = 1.0 / sqrt(sq);
		motion->x = vx * rate;
		motion->y = vy * rate;
		motion->spin = rim * rate;
		motion->rate = rate;
	} else {
		size = tribos_hypot_f64_(tribos_hypot_f64_(vx, vy), rim);
		motion->x = vx / size;
		motion->y = vy / size;
		motion->spin = rim / size;
		motion->rate = 1.0 / size;
	}
	*unit = by;
	return 1;
}

/* A corner under a motion: velocity, speed q, arm v.(z x x) and what q differs from 1 by. */
typedef struct tribos_corner_f64_ {
	double ux, uy, q, arm, p, rest, x, y;
} tribos_corner_f64_;

TRIBOS_PART_ tribos_corner_f64_ tribos_corner_of_f64_(tribos_unit_motion_f64_ motion, double x, double y)
{
	const double w = motion.spin, least = 0.25 * 2.220446049250313e-16, sq = x * x + y * y, from_rim = sq - 1.0, half = 0.5 * w;
	double inv;
	tribos_corner_f64_ corner;
	corner.x = x;
	corner.y = y;
	corner.ux = motion.x - w * y;
	corner.uy = motion.y + w * x;
	corner.q = sqrt(corner.ux * corner.ux + corner.uy * corner.uy + least * least);
	corner.arm = motion.y * x - motion.x * y;
	inv = 1.0 / (corner.q + 1.0);
	corner.p = (from_rim - corner.arm * ((corner.arm + corner.arm + w * from_rim) * inv)) * inv;
	corner.rest = half * sq - corner.p * (corner.arm + half * corner.p);
	return corner;
}

/* What an edge contributes to force, torque and second derivatives of the power, of the area. */
typedef struct tribos_edge_sums_f64_ {
	double x, y, turn, xx, xy, yy, xn, yn, nn;
} tribos_edge_sums_f64_;

TRIBOS_PART_ tribos_edge_sums_f64_ tribos_edge_sums_of_f64_(tribos_unit_motion_f64_ motion,
	tribos_kernel_edge_f64 edge, tribos_corner_f64_ from, tribos_corner_f64_ to, int has_hessian)
{
	const double w = motion.spin, tx = edge.tangent_x, ty = edge.tangent_y, length = edge.length;
	const double along = motion.x * tx + motion.y * ty, across = motion.x * ty - motion.y * tx;
	const double eta = along + w * edge.offset;
	const double inv_sum = 1.0 / (from.q + to.q);
	const double reach = length * inv_sum, zeta = eta * inv_sum;
	const double reach_sq = reach * reach, zeta_sq = zeta * zeta, y_sq = w * w * reach_sq;
	/* z2/(1 - y2) and 1 - y2, by the sum that does not cancel. */
	const double dot = from.ux * to.ux + from.uy * to.uy;
	const int is_ahead = 0.0 <= dot;
	const double both = (from.q * to.q + fabs(dot)) * (inv_sum * inv_sum), twice = both + both;
	const double inv = 1.0 / (is_ahead ? twice : twice * y_sq), turned = y_sq + y_sq;
	const double open = (is_ahead ? zeta_sq : both * both) * inv;
	const double gap = (is_ahead ? twice : zeta_sq * (turned * turned) * inv) + 2.2250738585072014e-308;
	/* G = ((artanh y/y - 1)/y2 - 1/3)/y2 and g = 1/3 + y2 G. */
	const double gap_sq = gap * gap;
	const double smooth = -0.6401861527732862 + ((((((0.001301559781050569 * gap_sq
			+ 1.486713005272929) * gap_sq + 1.9630649515817709) * gap_sq
			- 1.2543564159377816) * gap_sq - 1.16459091145224) * gap_sq
			- 0.8504653807248665) * gap + ((((0.1799373352753207 * gap_sq
			+ 3.1513953376926005) * gap_sq - 0.3679539886034428) * gap_sq
			- 1.2852959442330707) * gap_sq - 1.0195633958789827) * gap_sq);
	const double of_log = -0.4999999999999916 + ((((((0.0 * gap_sq - 0.7504774173850624) * gap_sq
			- 6.013823535200807) * gap_sq - 5.807985534896961) * gap_sq
			- 3.2812135473999957) * gap_sq - 1.2499999998507927) * gap
			+ ((((-0.04891932747810624 * gap_sq - 3.196885026539811) * gap_sq
			- 6.739369366662877) * gap_sq - 4.509353780325758) * gap_sq
			- 2.1874998324496304) * gap_sq);
	const double bend = smooth + tribos_log_f64_(gap) * of_log, log = 0.3333333333333333 + y_sq * bend;
	const double p = 0.5 * (from.p + to.p), arm = 0.5 * (from.arm + to.arm);
	const double rest = 0.5 * (from.rest + to.rest), sigma = arm + w * p;
	/* Integrals of p and of its further part along the edge. */
	const double beta = length * (p - length * reach * (open - zeta_sq * log));
	const double zeta_0 = 0.5 * along, zeta_1 = 0.5 * edge.offset - zeta * sigma;
	const double once = zeta_1 * (zeta + zeta_0) - zeta_0 * zeta_0 * sigma;
	const double closed = open - zeta_sq * bend;
	const double bent = 0.6666666666666666 * once + w * reach_sq * closed;
	const double beta_rest = along * (length * (rest - length * reach * bent));
	tribos_edge_sums_f64_ sums;
	sums.x = tx * beta;
	sums.y = ty * beta;
	sums.turn = edge.offset * beta - (beta_rest + beta_rest);
	sums.xx = sums.xy = sums.yy = sums.xn = sums.yn = sums.nn = 0.0;
	if (has_hessian) {
		const double double_inv = inv_sum + inv_sum, kappa = arm * arm - p + w * arm * p;
		const double lambda = double_inv * (kappa + reach_sq * log);
		const double lengthwise = length * (edge.offset - eta * arm + w * eta * lambda);
		const double middle = 0.5 * ((from.x + to.x) * tx + (from.y + to.y) * ty);
		const double rise = length * double_inv * (across * sigma + middle);
		const double mixed = length * double_inv * (reach_sq * log * eta * along - (p + w * w * kappa));
		const double sum = 2.0 + 2.0 * w * sigma;
		const double spread = 0.16666666666666666 * sigma * (4.0 + sum * (2.0 + sum));
		const double left = 0.6666666666666666 * edge.offset - along * spread;
		const double whole = left + 2.0 * w * reach_sq * bend * eta;
		const double chi = arm * p - rest - w * double_inv * kappa * (1.0 + p) + reach_sq * inv_sum * along * whole;
		sums.xx = lengthwise * tx * tx - rise * tx * ty;
		sums.xy = lengthwise * tx * ty - 0.5 * rise * (ty * ty - tx * tx);
		sums.yy = lengthwise * ty * ty + rise * tx * ty;
		sums.xn = -(mixed * tx);
		sums.yn = -(mixed * ty);
		sums.nn = along * (length * chi);
	}
	return sums;
}

/* Four sums, of which the next one stands first. */
typedef struct tribos_four_f64_ {
	double a, b, c, d;
} tribos_four_f64_;

TRIBOS_PART_ tribos_four_f64_ tribos_four_and_f64_(tribos_four_f64_ four, double part)
{
	const double first = four.a + part;
	four.a = four.b;
	four.b = four.c;
	four.c = four.d;
	four.d = first;
	return four;
}

/* Their sum after `count` parts: (1 + 2) + (3 + 4) of the sums in the order in which they were begun. */
TRIBOS_PART_ double tribos_four_total_f64_(tribos_four_f64_ four, int count)
{
	return count % 2 == 0 ? (four.a + four.b) + (four.c + four.d) : (four.d + four.a) + (four.b + four.c);
}

TRIBOS_PART_ tribos_edge_sums_f64_ tribos_edges_summed_f64_(
	const tribos_kernel_edge_f64 *edges, int count, tribos_unit_motion_f64_ motion, int has_hessian)
{
	const tribos_four_f64_ none = { 0.0, 0.0, 0.0, 0.0 };
	tribos_four_f64_ x = none, y = none, turn = none, xx = none, xy = none, yy = none, xn = none, yn = none;
	tribos_four_f64_ nn = none;
	tribos_corner_f64_ corner = tribos_corner_of_f64_(motion, edges[0].x, edges[0].y);
	tribos_edge_sums_f64_ sums;
	int i;
	for (i = 0; i < count; ++i) {
		const tribos_kernel_edge_f64 *next = edges + (i + 1 < count ? i + 1 : 0);
		const tribos_corner_f64_ to = tribos_corner_of_f64_(motion, next->x, next->y);
		const tribos_edge_sums_f64_ part = tribos_edge_sums_of_f64_(motion, edges[i], corner, to, has_hessian);
		x = tribos_four_and_f64_(x, part.x);
		y = tribos_four_and_f64_(y, part.y);
		turn = tribos_four_and_f64_(turn, part.turn);
		if (has_hessian) {
			xx = tribos_four_and_f64_(xx, part.xx);
			xy = tribos_four_and_f64_(xy, part.xy);
			yy = tribos_four_and_f64_(yy, part.yy);
			xn = tribos_four_and_f64_(xn, part.xn);
			yn = tribos_four_and_f64_(yn, part.yn);
			nn = tribos_four_and_f64_(nn, part.nn);
		}
		corner = to;
	}
	sums.x = tribos_four_total_f64_(x, count);
	sums.y = tribos_four_total_f64_(y, count);
	sums.turn = tribos_four_total_f64_(turn, count);
	sums.xx = tribos_four_total_f64_(xx, count);
	sums.xy = tribos_four_total_f64_(xy, count);
	sums.yy = tribos_four_total_f64_(yy, count);
	sums.xn = tribos_four_total_f64_(xn, count);
	sums.yn = tribos_four_total_f64_(yn, count);
	sums.nn = tribos_four_total_f64_(nn, count);
	return sums;
}

/* The wrench about the origin of the corners' coordinates. */
TRIBOS_PART_ tribos_kernel_wrench_f64 tribos_polygon_wrench_of_f64_(tribos_kernel_polygon_f64 polygon,
	tribos_unit_motion_f64_ motion, tribos_edge_sums_f64_ sums, double share, double strength)
{
	const double by = motion.spin * share;
	const double torque = -(0.3333333333333333 * motion.spin * (2.0 + share * sums.turn));
	tribos_kernel_wrench_f64 wrench;
	wrench.x = -(motion.x + by * sums.x) * strength;
	wrench.y = -(motion.y + by * sums.y) * strength;
	wrench.torque = strength * polygon.radius * torque + (polygon.x * wrench.y - polygon.y * wrench.x);
	return wrench;
}

/* Friction of a polygon under uniform pressure, against its twist. Zero at rest, NaN for infinite twists. */
TRIBOS_FN tribos_kernel_wrench_f64 tribos_kernel_polygon_wrench_f64(const tribos_kernel_polygon_f64 *polygon,
	const tribos_kernel_edge_f64 *edges, tribos_kernel_twist_f64 twist, double strength)
{
	tribos_unit_motion_f64_ motion;
	tribos_kernel_wrench_f64 wrench;
	double rest;
	if (!tribos_unit_motion_of_f64_(*polygon, twist, &motion, &rest)) {
		wrench.x = wrench.y = wrench.torque = rest;
		return wrench;
	}
	return tribos_polygon_wrench_of_f64_(
		*polygon, motion, tribos_edges_summed_f64_(edges, polygon->count, motion, 0), 1.0 / polygon->area, strength);
}

/* Prepares a polygon of `count` >= 3 corners (x, y in turn), clockwise or counterclockwise; `edges` has room for as many.
 * Returns 1, or 0 where a corner is not finite or repeated, or the area is lost in rounding. Edges must not cross: that
 * alone is not checked. */
TRIBOS_FN int tribos_kernel_polygon_prepare_f64(
	const double *corners, int count, tribos_kernel_edge_f64 *edges, tribos_kernel_polygon_f64 *polygon)
{
	double unit = 0.0, twice = 0.0, size = 0.0, sense, area = 0.0, mx = 0.0, my = 0.0, third, cx, cy;
	double radius = 0.0, boundary = 0.0, slender;
	tribos_kernel_twist_f64 turn;
	int i;
	if (count < 3)
		return 0;
	for (i = 0; i < count; ++i) {
		const double *at = corners + 2 * i, *next = corners + 2 * (i + 1 < count ? i + 1 : 0);
		const double dx = fabs(at[0] - corners[0]), dy = fabs(at[1] - corners[1]);
		if (!(tribos_is_finite_f64_(at[0]) && tribos_is_finite_f64_(at[1])))
			return 0;
		if (at[0] == next[0] && at[1] == next[1])
			return 0;
		unit = dx > unit ? dx : unit;
		unit = dy > unit ? dy : unit;
	}
	if (!tribos_is_finite_f64_(unit))
		return 0;
	/* Corners in units of the extent, for now where the edges will be. */
	for (i = 0; i < count; ++i) {
		edges[i].x = (corners[2 * i] - corners[0]) / unit;
		edges[i].y = (corners[2 * i + 1] - corners[1]) / unit;
	}
	for (i = 0; i < count; ++i) {
		const tribos_kernel_edge_f64 a = edges[i], b = edges[i + 1 < count ? i + 1 : 0];
		twice = twice + (a.x * b.y - a.y * b.x);
		size = size + (fabs(a.x * b.y) + fabs(a.y * b.x));
	}
	if (!(fabs(twice) > 2.0 * 2.0 * 2.220446049250313e-16 * size + 2.2250738585072014e-308 / 2.220446049250313e-16) || twice == 0.0)
		return 0;
	sense = copysign(1.0, twice);
	for (i = 0; i < count; ++i) {
		const tribos_kernel_edge_f64 a = edges[i], b = edges[i + 1 < count ? i + 1 : 0];
		const double part = sense * (a.x * b.y - a.y * b.x);
		area = area + part;
		mx = mx + (a.x + b.x) * part;
		my = my + (a.y + b.y) * part;
	}
	if (area <= 2.0 * 2.0 * 2.220446049250313e-16 * fabs(twice) + 2.2250738585072014e-308 / 2.220446049250313e-16)
		return 0;
	third = 1.0 / (3.0 * area);
	cx = mx * third;
	cy = my * third;
	for (i = 0; i < count; ++i) {
		const double distance = tribos_hypot_f64_(edges[i].x - cx, edges[i].y - cy);
		radius = distance > radius ? distance : radius;
	}
	polygon->x = corners[0] + cx * unit;
	polygon->y = corners[1] + cy * unit;
	polygon->radius = radius * unit;
	polygon->area = 0.5 * area / (radius * radius);
	if (!tribos_is_finite_f64_(polygon->x + polygon->y + polygon->radius))
		return 0;
	for (i = 0; i < count; ++i) {
		edges[i].x = (edges[i].x - cx) / radius;
		edges[i].y = (edges[i].y - cy) / radius;
	}
	for (i = 0; i < count; ++i) {
		const tribos_kernel_edge_f64 a = edges[i], b = edges[i + 1 < count ? i + 1 : 0];
		const int is_forward = twice > 0.0;
		const double from_x = is_forward ? a.x : b.x, from_y = is_forward ? a.y : b.y;
		const double side_x = (is_forward ? b.x : a.x) - from_x, side_y = (is_forward ? b.y : a.y) - from_y;
		const double length = tribos_hypot_f64_(side_x, side_y);
		if (length == 0.0)
			return 0;
		edges[i].length = length;
		edges[i].tangent_x = side_x / length;
		edges[i].tangent_y = side_y / length;
		edges[i].offset = from_x * edges[i].tangent_y - from_y * edges[i].tangent_x;
	}
	/* What its limit surface is measured by. */
	polygon->count = count;
	polygon->reach = polygon->radius + tribos_hypot_f64_(polygon->x, polygon->y);
	for (i = 0; i < count; ++i)
		boundary = boundary + edges[i].length;
	slender = 0.25 * boundary / polygon->area;
	polygon->rounding = 2.220446049250313e-16 * (slender > 1.0 ? slender : 1.0);
	turn.x = turn.y = 0.0;
	turn.spin = 1.0;
	polygon->arm = fabs(tribos_kernel_polygon_wrench_f64(polygon, edges, turn, 1.0).torque);
	return 1;
}

/* Friction of a polygon with its derivatives by the twist, negative semidefinite and zero at rest. */
TRIBOS_FN tribos_kernel_wrench_f64 tribos_kernel_polygon_wrench_jacobian_f64(const tribos_kernel_polygon_f64 *polygon,
	const tribos_kernel_edge_f64 *edges, tribos_kernel_twist_f64 twist, double strength,
	tribos_kernel_jacobian_f64 *jacobian)
{
	const double share = 1.0 / polygon->area, limit = -strength, radius = polygon->radius;
	tribos_unit_motion_f64_ motion;
	tribos_edge_sums_f64_ d;
	tribos_kernel_wrench_f64 wrench;
	double unit, x, y, n, to_x, to_y, to_n, half, from_x, from_y;
	if (!tribos_unit_motion_of_f64_(*polygon, twist, &motion, &unit)) {
		wrench.x = wrench.y = wrench.torque = unit;
		jacobian->xx = jacobian->xy = jacobian->xn = jacobian->yy = jacobian->yn = jacobian->nn = unit;
		return wrench;
	}
	d = tribos_edges_summed_f64_(edges, polygon->count, motion, 1);
	wrench = tribos_polygon_wrench_of_f64_(*polygon, motion, d, share, strength);
	/* Second derivatives of the power, and their part across the twist. */
	x = motion.x;
	y = motion.y;
	n = motion.spin;
	d.xx = share * d.xx;
	d.xy = share * d.xy;
	d.yy = share * d.yy;
	d.xn = share * d.xn - n * x;
	d.yn = share * d.yn - n * y;
	d.nn = share * d.nn + (x * x + y * y);
	to_x = d.xx * x + d.xy * y + d.xn * n;
	to_y = d.xy * x + d.yy * y + d.yn * n;
	to_n = d.xn * x + d.yn * y + d.nn * n;
	half = 0.5 * (to_x * x + to_y * y + to_n * n);
	to_x = to_x - half * x;
	to_y = to_y - half * y;
	to_n = to_n - half * n;
	d.xx = (d.xx - (to_x * x + to_x * x)) * motion.rate * unit;
	d.xy = (d.xy - (to_x * y + to_y * x)) * motion.rate * unit;
	d.yy = (d.yy - (to_y * y + to_y * y)) * motion.rate * unit;
	d.xn = (d.xn - (to_x * n + to_n * x)) * motion.rate * unit;
	d.yn = (d.yn - (to_y * n + to_n * y)) * motion.rate * unit;
	d.nn = (d.nn - (to_n * n + to_n * n)) * motion.rate * unit;
	/* About the origin: the centroid moves with (-y, x) for each unit of spin. */
	x = polygon->x;
	y = polygon->y;
	d.xx = limit * d.xx;
	d.xy = limit * d.xy;
	d.yy = limit * d.yy;
	d.xn = limit * radius * d.xn;
	d.yn = limit * radius * d.yn;
	d.nn = limit * radius * radius * d.nn;
	from_x = d.xy * x - d.xx * y;
	from_y = d.yy * x - d.xy * y;
	jacobian->xx = d.xx;
	jacobian->xy = d.xy;
	jacobian->yy = d.yy;
	jacobian->xn = d.xn + from_x;
	jacobian->yn = d.yn + from_y;
	jacobian->nn = d.nn + 2.0 * (d.yn * x - d.xn * y) + (from_y * x - from_x * y);
	return wrench;
}
/* ---- The limit surface of a polygon: convex functions of the twist, least by Newton's method ---- */

typedef struct tribos_vector_f64_ {
	double x, y, z;
} tribos_vector_f64_;

TRIBOS_PART_ double tribos_dot_f64_(tribos_vector_f64_ a, tribos_vector_f64_ b)
{
	return a.x * b.x + a.y * b.y + a.z * b.z;
}

TRIBOS_PART_ double tribos_norm_f64_(tribos_vector_f64_ a)
{
	return tribos_hypot_f64_(tribos_hypot_f64_(a.x, a.y), a.z);
}

/* What is to be least at a twist t, of a wrench x in units of strength and arm: D(t)2/2 - x.t, whose minimum is the normal
 * above x, or t.M t/2 + reach D(t) - x.t, with M = (1, 1, length2), whose minimum is the displacement to the nearest. */
typedef struct tribos_goal_f64_ {
	int is_gauge;
	tribos_vector_f64_ wrench;
	double reach, length_sq;
} tribos_goal_f64_;

/* Power, its gradient and its second derivatives there. */
typedef struct tribos_power_f64_ {
	double value;
	tribos_vector_f64_ gradient;
	tribos_kernel_jacobian_f64 hessian;
} tribos_power_f64_;

TRIBOS_PART_ tribos_power_f64_ tribos_power_at_f64_(
	const tribos_kernel_polygon_f64 *polygon, const tribos_kernel_edge_f64 *edges, tribos_vector_f64_ at)
{
	const double inv_arm = 1.0 / polygon->arm;
	tribos_kernel_twist_f64 twist;
	tribos_kernel_jacobian_f64 j;
	tribos_kernel_wrench_f64 wrench;
	tribos_power_f64_ power;
	twist.x = at.x;
	twist.y = at.y;
	twist.spin = at.z * inv_arm;
	wrench = tribos_kernel_polygon_wrench_jacobian_f64(polygon, edges, twist, 1.0, &j);
	power.gradient.x = -wrench.x;
	power.gradient.y = -wrench.y;
	power.gradient.z = -(wrench.torque * inv_arm);
	power.hessian.xx = -j.xx;
	power.hessian.xy = -j.xy;
	power.hessian.yy = -j.yy;
	power.hessian.xn = -inv_arm * j.xn;
	power.hessian.yn = -inv_arm * j.yn;
	power.hessian.nn = -inv_arm * inv_arm * j.nn;
	power.value = tribos_dot_f64_(power.gradient, at);
	return power;
}

TRIBOS_PART_ tribos_vector_f64_ tribos_displacement_f64_(tribos_goal_f64_ goal, tribos_vector_f64_ at)
{
	at.z = goal.length_sq * at.z;
	return at;
}

TRIBOS_PART_ double tribos_goal_value_f64_(tribos_goal_f64_ goal, tribos_vector_f64_ at, double power)
{
	if (goal.is_gauge)
		return 0.5 * power * power - tribos_dot_f64_(goal.wrench, at);
	return 0.5 * tribos_dot_f64_(at, tribos_displacement_f64_(goal, at)) + power * goal.reach
		- tribos_dot_f64_(goal.wrench, at);
}

TRIBOS_PART_ tribos_vector_f64_ tribos_goal_gradient_f64_(
	tribos_goal_f64_ goal, tribos_vector_f64_ at, tribos_power_f64_ power)
{
	const double factor = goal.is_gauge ? power.value : goal.reach;
	tribos_vector_f64_ g;
	g.x = power.gradient.x * factor;
	g.y = power.gradient.y * factor;
	g.z = power.gradient.z * factor;
	if (!goal.is_gauge) {
		g.x = at.x + g.x;
		g.y = at.y + g.y;
		g.z = goal.length_sq * at.z + g.z;
	}
	g.x = g.x - goal.wrench.x;
	g.y = g.y - goal.wrench.y;
	g.z = g.z - goal.wrench.z;
	return g;
}

/* A step of Newton's method against a gradient; pivots that rounding has made too small are raised. */
TRIBOS_PART_ tribos_vector_f64_ tribos_newton_f64_(
	tribos_goal_f64_ goal, tribos_power_f64_ power, tribos_vector_f64_ right)
{
	const double factor = goal.is_gauge ? power.value : goal.reach, least = 4.0 * 2.220446049250313e-16;
	const tribos_vector_f64_ g = power.gradient;
	const tribos_kernel_jacobian_f64 h = power.hessian;
	const double xx = goal.is_gauge ? g.x * g.x + h.xx * factor : h.xx * factor + 1.0;
	const double yy = goal.is_gauge ? g.y * g.y + h.yy * factor : h.yy * factor + 1.0;
	const double zz = goal.is_gauge ? g.z * g.z + h.nn * factor : h.nn * factor + goal.length_sq;
	const double xy = goal.is_gauge ? g.x * g.y + h.xy * factor : h.xy * factor;
	const double xz = goal.is_gauge ? g.x * g.z + h.xn * factor : h.xn * factor;
	const double yz = goal.is_gauge ? g.y * g.z + h.yn * factor : h.yn * factor;
	const double a = xy / xx, b = xz / xx, of_y = yy - a * xy, y = of_y < least * yy ? least * yy : of_y;
	const double c = (yz - a * xz) / y, of_z = zz - b * xz - c * c * y, z = of_z < least * zz ? least * zz : of_z;
	const double second = right.y - a * right.x, third = right.z - b * right.x - c * second;
	tribos_vector_f64_ step;
	step.z = third / z;
	step.y = second / y - c * step.z;
	step.x = right.x / xx - a * step.y - b * step.z;
	return step;
}

/* Where a goal is least, and the power there. */
typedef struct tribos_least_f64_ {
	tribos_vector_f64_ at;
	tribos_power_f64_ power;
	int is_found;
} tribos_least_f64_;

TRIBOS_RARE_ tribos_least_f64_ tribos_least_of_f64_(const tribos_kernel_polygon_f64 *polygon,
	const tribos_kernel_edge_f64 *edges, tribos_goal_f64_ goal, tribos_vector_f64_ start)
{
	const double rounding = polygon->rounding, noise = 8.0 * rounding;
	double size = 0.0, descent = 0.0, before = 0.0, slack = 0.0, factor = 1.0;
	int steps = 0, halvings = 0;
	tribos_vector_f64_ next = start, step = start;
	tribos_least_f64_ least;
	least.at = start;
	least.is_found = 1;
	for (;;) {
		const tribos_power_f64_ power = tribos_power_at_f64_(polygon, edges, next);
		const double value = tribos_goal_value_f64_(goal, next, power.value);
		const tribos_vector_f64_ gradient = tribos_goal_gradient_f64_(goal, next, power);
		const double length = tribos_norm_f64_(gradient);
		if (steps > 0) {
			const double enough = before - 0.0001 * factor * descent, slope = tribos_dot_f64_(gradient, step);
			const int is_level = value <= before + slack && slope >= -(0.9998 * descent);
			const int gains = length < size || value < before - slack;
			const int bends = size > 32.0 * rounding && fabs(slope) < 0.5 * descent;
			if (halvings < 30 && !(value <= enough || is_level)) {
				factor = 0.5 * factor;
				++halvings;
				next.x = least.at.x - step.x * factor;
				next.y = least.at.y - step.y * factor;
				next.z = least.at.z - step.z * factor;
				continue;
			}
			/* A full step that no longer shortens the gradient shows its rounding. */
			if (factor == 1.0 && size < sqrt(rounding) && !(gains || bends))
				return least;
		}
		least.at = next;
		least.power = power;
		size = length;
		if (size <= noise)
			return least;
		if (steps == 40 || size != size) {
			least.is_found = size <= 64.0 * sqrt(2.220446049250313e-16);
			return least;
		}
		++steps;
		halvings = 0;
		step = tribos_newton_f64_(goal, power, gradient);
		descent = tribos_dot_f64_(gradient, step);
		before = value;
		slack = noise * (1.0 + fabs(before));
		factor = 1.0;
		next.x = least.at.x - step.x;
		next.y = least.at.y - step.y;
		next.z = least.at.z - step.z;
	}
}

/* The wrench in units of strength and arm, and its length; 0 where it has no direction. */
TRIBOS_PART_ double tribos_scaled_f64_(const tribos_kernel_polygon_f64 *polygon, tribos_kernel_wrench_f64 wrench,
	double limit, tribos_vector_f64_ *scaled)
{
	double size;
	scaled->x = wrench.x / limit;
	scaled->y = wrench.y / limit;
	scaled->z = wrench.torque / limit / polygon->arm;
	size = tribos_norm_f64_(*scaled);
	return size > 0.0 && tribos_is_finite_f64_(size) ? size : 0.0;
}

/* The normal above a wrench of that length. */
TRIBOS_PART_ tribos_goal_f64_ tribos_gauge_goal_f64_(tribos_vector_f64_ scaled, double size)
{
	tribos_goal_f64_ goal;
	goal.is_gauge = 1;
	goal.wrench.x = scaled.x / size;
	goal.wrench.y = scaled.y / size;
	goal.wrench.z = scaled.z / size;
	goal.reach = goal.length_sq = 0.0;
	return goal;
}

/* The gauge of that wrench: no number where the search has missed. */
TRIBOS_PART_ double tribos_gauge_of_f64_(tribos_goal_f64_ goal, double size, tribos_least_f64_ found)
{
	return size * (found.is_found ? tribos_dot_f64_(goal.wrench, found.at) / found.power.value : tribos_nan_f64_());
}

/* A twist of the search with |velocity|2 + (spin reach)2 = 1. */
TRIBOS_PART_ tribos_kernel_twist_f64 tribos_normal_of_f64_(
	const tribos_kernel_polygon_f64 *polygon, double x, double y, double z)
{
	const double spin = z / polygon->arm;
	const double length = tribos_hypot_f64_(tribos_hypot_f64_(x, y), spin * polygon->reach);
	tribos_kernel_twist_f64 normal;
	normal.x = x / length;
	normal.y = y / length;
	normal.spin = spin / length;
	return normal;
}

/* The smallest factor f >= 0 with wrench/f in the set, about the origin of the corners; NaN where the search has missed. */
TRIBOS_FN double tribos_kernel_polygon_gauge_f64(const tribos_kernel_polygon_f64 *polygon,
	const tribos_kernel_edge_f64 *edges, tribos_kernel_wrench_f64 wrench, double strength)
{
	tribos_vector_f64_ scaled;
	const double size = tribos_scaled_f64_(polygon, wrench, tribos_limit_of_f64_(strength), &scaled);
	tribos_goal_f64_ goal;
	if (size == 0.0) {
		const double any = fabs(wrench.x) + fabs(wrench.y) + fabs(wrench.torque);
		return any == 0.0 || any != any ? any : tribos_infinity_f64_();
	}
	goal = tribos_gauge_goal_f64_(scaled, size);
	return tribos_gauge_of_f64_(goal, size, tribos_least_of_f64_(polygon, edges, goal, goal.wrench));
}

/* The motion that a push causes, with |velocity|2 + (spin reach)2 = 1. Zero for no push, NaN for an infinite one. */
TRIBOS_FN tribos_kernel_twist_f64 tribos_kernel_polygon_normal_f64(const tribos_kernel_polygon_f64 *polygon,
	const tribos_kernel_edge_f64 *edges, tribos_kernel_wrench_f64 push, double strength)
{
	tribos_vector_f64_ scaled;
	const double size = tribos_scaled_f64_(polygon, push, tribos_limit_of_f64_(strength), &scaled);
	tribos_kernel_twist_f64 normal;
	tribos_goal_f64_ goal;
	tribos_least_f64_ found;
	normal.x = push.x == 0.0 && push.y == 0.0 && push.torque == 0.0 ? 0.0 : tribos_nan_f64_();
	normal.y = normal.spin = normal.x;
	if (size == 0.0)
		return normal;
	goal = tribos_gauge_goal_f64_(scaled, size);
	found = tribos_least_of_f64_(polygon, edges, goal, goal.wrench);
	return found.is_found ? tribos_normal_of_f64_(polygon, found.at.x, found.at.y, found.at.z) : normal;
}

/* The wrench of the set nearest to a given one, as tribos_kernel_round_project has it, about the origin of the corners. */
TRIBOS_FN tribos_kernel_projection_f64 tribos_kernel_polygon_project_f64(const tribos_kernel_polygon_f64 *polygon,
	const tribos_kernel_edge_f64 *edges, tribos_kernel_wrench_f64 wrench, double strength, double length)
{
	const double limit = tribos_limit_of_f64_(strength), arm = length / polygon->arm;
	const double own = 24.0 * polygon->rounding, least = 64.0 * 2.220446049250313e-16;
	const double collar = own > 0.015625 ? 0.015625 : own > least ? own : least;
	tribos_kernel_projection_f64 projection = tribos_held_f64_(wrench);
	tribos_vector_f64_ scaled, start;
	double size, gauge, along;
	tribos_goal_f64_ goal;
	tribos_least_f64_ found;
	if (wrench.x == 0.0 && wrench.y == 0.0 && wrench.torque == 0.0)
		return projection;
	size = tribos_scaled_f64_(polygon, wrench, limit, &scaled);
	if (size == 0.0 || !(arm > 0.0 && tribos_is_finite_f64_(arm))) {
		/* None is carried, or there is no nearest one. */
		const tribos_kernel_twist_f64 normal = tribos_normal_of_f64_(
			polygon, wrench.x, wrench.y, wrench.torque / (length * length) * polygon->arm);
		const int is_number = tribos_is_finite_f64_(normal.spin) && tribos_is_finite_f64_(normal.x);
		projection = tribos_unknown_f64_();
		if (limit == 0.0 && length > 0.0 && is_number) {
			projection.wrench.x = projection.wrench.y = projection.wrench.torque = 0.0;
			projection.normal = normal;
		}
		return projection;
	}
	goal = tribos_gauge_goal_f64_(scaled, size);
	found = tribos_least_of_f64_(polygon, edges, goal, goal.wrench);
	gauge = tribos_gauge_of_f64_(goal, size, found);
	if (gauge < 1.0 - collar)
		return projection;
	projection.slides = 1;
	if (gauge <= 1.0 + collar) {
		projection.normal = tribos_normal_of_f64_(polygon, found.at.x, found.at.y, found.at.z);
		return projection;
	}
	/* A wrench of any size is one of order 1 to the search, which starts along the normal above the wrench. */
	goal.is_gauge = 0;
	goal.reach = size > 1048576.0 ? 1.0 / size : 1.0;
	goal.wrench = size > 1048576.0 ? goal.wrench : scaled;
	goal.length_sq = arm * arm;
	along = (tribos_dot_f64_(goal.wrench, found.at) - found.power.value * goal.reach)
		/ tribos_dot_f64_(found.at, tribos_displacement_f64_(goal, found.at));
	start.x = found.at.x * along;
	start.y = found.at.y * along;
	start.z = found.at.z * along;
	found = tribos_least_of_f64_(polygon, edges, goal, start);
	projection.wrench.x = limit * found.power.gradient.x;
	projection.wrench.y = limit * found.power.gradient.y;
	projection.wrench.torque = limit * polygon->arm * found.power.gradient.z;
	projection.normal = tribos_normal_of_f64_(polygon, found.at.x, found.at.y, found.at.z);
	return projection;
}

/* ---- The implicit time step of a body on its patch ---- */

/* A patch under a strength, round or a polygon. */
typedef struct tribos_set_f64_ {
	int is_round, pressure;
	const tribos_kernel_polygon_f64 *polygon;
	const tribos_kernel_edge_f64 *edges;
	double strength, radius;
} tribos_set_f64_;

TRIBOS_PART_ tribos_kernel_projection_f64 tribos_set_project_f64_(
	tribos_set_f64_ set, tribos_kernel_wrench_f64 wrench, double length)
{
	if (!set.is_round)
		return tribos_kernel_polygon_project_f64(set.polygon, set.edges, wrench, set.strength, length);
	return tribos_kernel_round_project_f64(set.pressure, wrench, set.strength, set.radius, length);
}

/* The largest torque, which is the power at unit spin. */
TRIBOS_PART_ double tribos_torque_limit_f64_(tribos_set_f64_ set)
{
	tribos_kernel_twist_f64 turn;
	turn.x = turn.y = 0.0;
	turn.spin = 1.0;
	if (!set.is_round)
		return -tribos_kernel_polygon_wrench_f64(
			set.polygon, set.edges, turn, tribos_limit_of_f64_(set.strength)).torque;
	return tribos_limit_of_f64_(set.strength) * (set.radius * tribos_spin_torque_f64_(set.pressure));
}

TRIBOS_PART_ int tribos_same_f64_(tribos_kernel_wrench_f64 a, tribos_kernel_wrench_f64 b)
{
	return a.x == b.x && a.y == b.y && a.torque == b.torque;
}

/* A wrench that is carried made so short that it does not oppose what is wanted beyond it: friction gives no energy. */
TRIBOS_RARE_ tribos_kernel_wrench_f64 tribos_shortened_f64_(
	tribos_kernel_wrench_f64 carried, tribos_kernel_wrench_f64 wanted, double length)
{
	const double x = carried.x, y = carried.y, n = carried.torque / length, m = wanted.torque / length;
	double size = fabs(x) > 0.0 ? fabs(x) : 0.0, reached, factor;
	size = fabs(y) > size ? fabs(y) : size;
	size = fabs(n) > size ? fabs(n) : size;
	reached = 0.0 + x / size * (wanted.x / size) + y / size * (wanted.y / size) + n / size * (m / size);
	reached = reached / (0.0 + x / size * (x / size) + y / size * (y / size) + n / size * (n / size));
	if (reached >= 1.0 || reached != reached)
		return carried;
	factor = reached > 0.0 ? reached : 0.0;
	carried.x = carried.x * factor;
	carried.y = carried.y * factor;
	carried.torque = carried.torque * factor;
	return carried;
}

TRIBOS_PART_ tribos_kernel_wrench_f64 tribos_without_gain_f64_(
	tribos_kernel_wrench_f64 carried, tribos_kernel_wrench_f64 wanted, double length)
{
	const double planar = carried.x * (wanted.x - carried.x) + carried.y * (wanted.y - carried.y);
	const double gain = planar * (length * length) + carried.torque * (wanted.torque - carried.torque);
	if (gain > 0.0 || tribos_same_f64_(carried, wanted))
		return carried;
	return tribos_shortened_f64_(carried, wanted, length);
}

/* The friction that brings the body to rest within a time. */
TRIBOS_PART_ tribos_kernel_wrench_f64 tribos_stopping_f64_(
	tribos_kernel_body_f64 body, tribos_kernel_twist_f64 twist, tribos_kernel_wrench_f64 push, double dt)
{
	const double mass = body.mass / dt, inertia = body.inertia / dt;
	tribos_kernel_wrench_f64 wrench;
	wrench.x = -(mass * twist.x + push.x);
	wrench.y = -(mass * twist.y + push.y);
	wrench.torque = -(inertia * twist.spin + push.torque);
	return wrench;
}

TRIBOS_PART_ tribos_kernel_twist_f64 tribos_moved_f64_(tribos_kernel_body_f64 body, tribos_kernel_twist_f64 twist,
	tribos_kernel_wrench_f64 push, tribos_kernel_wrench_f64 friction, double dt)
{
	const double rate = dt / body.mass, turn = dt / body.inertia;
	twist.x = twist.x + rate * (push.x + friction.x);
	twist.y = twist.y + rate * (push.y + friction.y);
	twist.spin = twist.spin + turn * (push.torque + friction.torque);
	return twist;
}

TRIBOS_PART_ tribos_kernel_step_f64 tribos_step_f64_(tribos_kernel_body_f64 body, tribos_kernel_twist_f64 twist,
	tribos_kernel_wrench_f64 push, tribos_set_f64_ set, double dt)
{
	const double length = sqrt(body.inertia / body.mass), limit = tribos_limit_of_f64_(set.strength);
	const double torque_limit = tribos_torque_limit_f64_(set);
	const tribos_kernel_wrench_f64 at_end = tribos_stopping_f64_(body, twist, push, dt);
	const tribos_kernel_wrench_f64 half_way = tribos_stopping_f64_(body, twist, push, 0.5 * dt);
	const int is_beyond = tribos_hypot_f64_(at_end.x, at_end.y) > 1.01 * limit
		|| fabs(at_end.torque) > 1.01 * torque_limit;
	tribos_kernel_wrench_f64 wanted = is_beyond ? half_way : at_end, carried, ended;
	tribos_kernel_step_f64 after, at_last;
	/* One search in the text: at the end where the body may come to rest, at half time, and at the end of a motion that
	 * has turned about. */
	int stage = is_beyond ? 1 : 0, has_ended = 0;
	after.is_at_rest = at_last.is_at_rest = 0;
	ended = at_end;
	for (;;) {
		carried = tribos_without_gain_f64_(
			tribos_set_project_f64_(set, wanted, length).wrench, wanted, length);
		if (stage == 0) {
			if (tribos_same_f64_(carried, at_end)) {
				after.twist.x = after.twist.y = after.twist.spin = 0.0;
				after.friction = at_end;
				after.is_at_rest = 1;
				return after;
			}
			ended = carried;
			has_ended = 1;
			wanted = half_way;
			stage = 1;
			continue;
		}
		if (stage == 1) {
			after.twist = tribos_moved_f64_(body, twist, push, carried, dt);
			after.friction = carried;
			if (!(twist.x * after.twist.x + twist.y * after.twist.y < 0.0
				|| twist.spin * after.twist.spin < 0.0))
				return after;
			if (!has_ended) {
				wanted = at_end;
				stage = 2;
				continue;
			}
			carried = ended;
		}
		break;
	}
	at_last.twist = tribos_moved_f64_(body, twist, push, carried, dt);
	at_last.friction = carried;
	return carried.x * (0.5 * twist.x + 0.5 * at_last.twist.x)
				+ carried.y * (0.5 * twist.y + 0.5 * at_last.twist.y)
				+ carried.torque * (0.5 * twist.spin + 0.5 * at_last.twist.spin)
			> 0.0
		? after
		: at_last;
}

/* The motion of a body on a round patch after the time dt > 0 under friction and a constant push. Of second order in dt
 * while it slides; rest is exact; friction never gives energy. NaN for NaN. */
TRIBOS_FN tribos_kernel_step_f64 tribos_kernel_round_step_f64(int pressure, tribos_kernel_body_f64 body,
	tribos_kernel_twist_f64 twist, tribos_kernel_wrench_f64 push, double strength, double radius, double dt)
{
	tribos_set_f64_ set;
	set.is_round = 1;
	set.pressure = pressure;
	set.polygon = 0;
	set.edges = 0;
	set.strength = strength;
	set.radius = radius;
	return tribos_step_f64_(body, twist, push, set, dt);
}

/* The same on a polygon; twist, push and the body's centre of mass are at the origin of the corners' coordinates. */
TRIBOS_FN tribos_kernel_step_f64 tribos_kernel_polygon_step_f64(const tribos_kernel_polygon_f64 *polygon,
	const tribos_kernel_edge_f64 *edges, tribos_kernel_body_f64 body, tribos_kernel_twist_f64 twist,
	tribos_kernel_wrench_f64 push, double strength, double dt)
{
	tribos_set_f64_ set;
	set.is_round = 0;
	set.pressure = TRIBOS_KERNEL_DISK;
	set.polygon = polygon;
	set.edges = edges;
	set.strength = strength;
	set.radius = 0.0;
	return tribos_step_f64_(body, twist, push, set, dt);
}

#undef TRIBOS_PART_
#undef TRIBOS_RARE_

#endif
