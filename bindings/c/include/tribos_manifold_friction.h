/*
 * Tribos: friction of a contact manifold, one projection in place of two clamps.
 *
 * This header stands alone: nothing to link, no other header than <math.h>, and that only without
 * lanes of your own. C99, C++11 and later. MIT OR Apache-2.0.
 *
 * An engine that keeps one friction centre a manifold has a tangential impulse (p1, p2) limited by
 * F = mu sum(lambda), and an angular impulse t about the normal limited by F times a lever. Replace
 * both clamps of the accumulated impulses by
 *
 *   tribos_manifold_friction(k, kt, F, lever, slip, curve, &p1, &p2, &t);
 *
 *   k, kt   inverse effective masses: tangential in 1/kg, > 0, the one that made the candidate (the
 *           mean of both tangents if that was a 2x2 matrix); about the normal in 1/(kg m2), >= 0
 *   F       mu sum(lambda) in N s, >= 0, with the dynamic coefficient
 *   lever   mean distance of the contact from the friction centre in m, >= 0; 0 for one point:
 *           disk 2/3 of the radius, square 0.3826 of the side, ring the radius, or of the area
 *   slip    dynamic over static coefficient, 0 < slip <= 1
 *   curve   TRIBOS_CURVE_AREA (disk, square), TRIBOS_CURVE_POINTS (ring, feet) or
 *           TRIBOS_CURVE_ELLIPSOID: limit curve y = sqrt(1-X) (1 + h1 X + h2 X2 + h4 X4), X = x2
 *   p1,p2,t in: the impulses that would stop the contact; out: the nearest ones that friction
 *           can carry, in the metric k |dp|2 + kt dt2. N s and N m s.
 *
 * Planks and other elongated outlines: tribos_contact_area() once a manifold, from its corners in the
 * frame of the two tangents, then tribos_manifold_friction_directed() with what it gives.
 *
 * Accuracy, domain and derivation: the Rust module tribos_core::manifold_friction, whose bits these are if the
 * compiler does not contract or reorder (-ffp-contract=off, no -ffast-math).
 *
 * CUDA, HIP and NVRTC: as it is; the bits with --fmad=false (hipcc -ffp-contract=off). Another device's compiler may want
 * something else before each function: define TRIBOS_FN before the header.
 *
 * Lanes: define the macros below for a vector type, and include this header again for another name:
 *
 *   #define TMF_NAME     my_manifold_friction   gives also my_manifold_friction_directed
 *   #define TMF_T        __m128
 *   #define TMF_SPLAT(f) _mm_set1_ps(f)
 *   #define TMF_ADD(a, b) ... TMF_SUB, TMF_MUL, TMF_DIV
 *   #define TMF_SQRT(a), TMF_ABS(a)
 *   #define TMF_MIN(a, b)  b < a ? b : a    (_mm_min_ps(b, a))
 *   #define TMF_MAX(a, b)  a < b ? b : a    (_mm_max_ps(b, a))
 *   #define TMF_MASK     __m128
 *   #define TMF_LESS(a, b), TMF_AT_MOST(a, b)   masks, false for NaN
 *   #define TMF_SELECT(m, a, b)  a where m, else b
 *   #define TMF_ALL(m)   true if m is true in every lane
 *
 * The macros are undefined again at the end.
 */

#ifndef TRIBOS_MANIFOLD_FRICTION_H
#define TRIBOS_MANIFOLD_FRICTION_H

/* What stands before each function; tribos_kernel.h has the same. */
#ifndef TRIBOS_FN
#if defined(__CUDACC__) || defined(__HIPCC__)
#define TRIBOS_FN static __host__ __device__ __forceinline__
#else
#define TRIBOS_FN static inline
#endif
#endif

/* Limit curves that are the same in all directions: h1, h2, h4. */
#define TRIBOS_CURVE_AREA { -0.245f, -0.036812603f, 0.034142315f }
#define TRIBOS_CURVE_POINTS { -0.5203f, 0.2304f, 0.0135f }
#define TRIBOS_CURVE_ELLIPSOID { 0.0f, 0.0f, 0.0f }

#define TMF_BOTH_(a, b) a##b
#define TMF_JOINED_(a, b) TMF_BOTH_(a, b)

#endif

#ifndef TMF_NAME
#ifndef TRIBOS_MANIFOLD_FRICTION_SCALAR
#define TRIBOS_MANIFOLD_FRICTION_SCALAR
#define TMF_SCALAR_
/* Under NVRTC and HIPRTC the mathematics is built in. */
#if !defined(__CUDACC_RTC__) && !defined(__HIPCC_RTC__)
#include <math.h>
#endif

/* A contact area under uniform pressure. Symmetric matrices are xx, xy, yy. */
typedef struct tribos_contact_area_f32 {
	float centre[2];   /* m */
	float lever;       /* m */
	float spinning[3]; /* curvatures of the limit surface at pure spin, dimensionless */
	float slipping[3]; /* reciprocal curvatures at pure slip, dimensionless */
} tribos_contact_area_f32;

/* 2 artanh z, 0 <= z <= 1, without logarithm. */
TRIBOS_FN float tribos_twice_artanh_(float z)
{
	float factor = 2.0f, z2, sum;
	int i;
	z = z < 1.0f ? z : 1.0f;
	for (i = 0; i < 4; ++i) {
		z = z / (1.0f + sqrtf((1.0f - z) * (1.0f + z)));
		factor = factor * 2.0f;
	}
	z2 = z * z;
	sum = (0.0f + 1.0f / 9.0f) * z2;
	sum = (sum + 1.0f / 7.0f) * z2;
	sum = (sum + 1.0f / 5.0f) * z2;
	sum = (sum + 1.0f / 3.0f) * z2;
	return factor * z * (1.0f + sum);
}

/* The area bounded by `count` corners (x, y in turn) in m, clockwise or counterclockwise. Two corners, or a
 * polygon without area, are a line; fewer have no lever. Call it when the manifold is made, with the clip polygon
 * before it is reduced. Moments to 1e-5, 5e-5 where the width is 1 % of the length; below 3e-10 m they leave the range
 * of floats, and components may be 0 or NaN. */
TRIBOS_FN tribos_contact_area_f32 tribos_contact_area(const float *corners, int count)
{
	tribos_contact_area_f32 area;
	float most2 = 0.0f, end[4] = { 0.0f, 0.0f, 0.0f, 0.0f };
	float twice = 0.0f, cx = 0.0f, cy = 0.0f, half, third, surface;
	float distance = 0.0f, j[3] = { 0.0f, 0.0f, 0.0f }, m[3] = { 0.0f, 0.0f, 0.0f };
	int i, n;
	if (count > 0) {
		end[0] = end[2] = corners[0];
		end[1] = end[3] = corners[1];
	}
	for (i = 0; i < count; ++i) {
		for (n = i + 1; n < count; ++n) {
			float x = corners[2 * n] - corners[2 * i], y = corners[2 * n + 1] - corners[2 * i + 1];
			float d2 = x * x + y * y;
			if (d2 > most2) {
				most2 = d2;
				end[0] = corners[2 * i];
				end[1] = corners[2 * i + 1];
				end[2] = corners[2 * n];
				end[3] = corners[2 * n + 1];
			}
		}
	}
	for (i = 0; i < count; ++i) {
		const float *p = corners + 2 * i, *q = corners + 2 * (i + 1 < count ? i + 1 : 0);
		float ax = p[0] - corners[0], ay = p[1] - corners[1];
		float bx = q[0] - corners[0], by = q[1] - corners[1];
		float cross = ax * by - ay * bx;
		twice = twice + cross;
		cx = cx + cross * (ax + bx);
		cy = cy + cross * (ay + by);
	}
	half = 0.5f * twice;
	{
		float far = sqrtf(most2);
		if ((half < 0.0f ? -half : half) <= 1e-4f * far * far) {
			float x = end[2] - end[0], y = end[3] - end[1], length = sqrtf(x * x + y * y);
			const float along = 0.6f, slip = 4.0f / 3.0f;
			if (length > 0.0f) {
				x = x / length;
				y = y / length;
			} else {
				x = 1.0f;
				y = 0.0f;
			}
			area.centre[0] = 0.5f * (end[0] + end[2]);
			area.centre[1] = 0.5f * (end[1] + end[3]);
			area.lever = 0.5f * 0.5f * length;
			area.spinning[0] = along * x * x + 2.0f * y * y;
			area.spinning[1] = (along - 2.0f) * x * y;
			area.spinning[2] = along * y * y + 2.0f * x * x;
			area.slipping[0] = slip * x * x + 0.0f * y * y;
			area.slipping[1] = (slip - 0.0f) * x * y;
			area.slipping[2] = slip * y * y + 0.0f * x * x;
			return area;
		}
	}
	third = 3.0f * twice;
	area.centre[0] = corners[0] + cx / third;
	area.centre[1] = corners[1] + cy / third;
	/* Triangles between the centre and the edges. */
	for (i = 0; i < count; ++i) {
		const float *p = corners + 2 * i, *q = corners + 2 * (i + 1 < count ? i + 1 : 0);
		const float tiny = 1.17549435e-38f;
		float ax = p[0] - area.centre[0], ay = p[1] - area.centre[1];
		float bx = q[0] - area.centre[0], by = q[1] - area.centre[1];
		float x = bx - ax, y = by - ay, length = sqrtf(x * x + y * y);
		float h, t0, t1, r0, r1, ends, mean, log, line, sines, normal, mixed, along, twelfth;
		if (length == 0.0f)
			continue;
		x = x / length;
		y = y / length;
		h = ax * y - ay * x;
		t0 = ax * x + ay * y;
		t1 = bx * x + by * y;
		r0 = sqrtf(h * h + t0 * t0);
		r1 = sqrtf(h * h + t1 * t1);
		r0 = r0 > tiny ? r0 : tiny;
		r1 = r1 > tiny ? r1 : tiny;
		ends = r0 + r1;
		mean = t0 + t1;
		log = tribos_twice_artanh_(length / ends);
		line = 0.5f * 0.5f * length * (ends + mean * mean / ends) + 0.5f * h * h * log;
		distance = distance + h * line / 3.0f;
		sines = t1 / r1 - t0 / r0;
		normal = h * sines;
		mixed = h * (h / r0 - h / r1);
		along = h * (log - sines);
		m[0] = m[0] + (normal * y * y + 2.0f * mixed * x * y + along * x * x);
		m[1] = m[1] + ((along - normal) * x * y + mixed * (y * y - x * x));
		m[2] = m[2] + (normal * x * x - 2.0f * mixed * x * y + along * y * y);
		twelfth = (ax * by - ay * bx) / 12.0f;
		j[0] = j[0] + twelfth * (ax * ax + bx * bx + 0.5f * (ax * bx + bx * ax));
		j[1] = j[1] + twelfth * (ax * ay + bx * by + 0.5f * (ax * by + bx * ay));
		j[2] = j[2] + twelfth * (ay * ay + by * by + 0.5f * (ay * by + by * ay));
	}
	surface = half;
	{
		float lever = distance / surface, lever2 = lever * lever;
		float xx = m[0] / surface, xy = m[1] / surface, yy = m[2] / surface;
		float scale = 1.0f / ((xx * yy - xy * xy) * lever);
		area.lever = lever;
		area.spinning[0] = yy * scale;
		area.spinning[1] = -xy * scale;
		area.spinning[2] = xx * scale;
		for (i = 0; i < 3; ++i)
			area.slipping[i] = j[i] / surface / lever2;
	}
	return area;
}

#define TMF_NAME tribos_manifold_friction
#define TMF_T float
#define TMF_SPLAT(f) (f)
#define TMF_ADD(a, b) ((a) + (b))
#define TMF_SUB(a, b) ((a) - (b))
#define TMF_MUL(a, b) ((a) * (b))
#define TMF_DIV(a, b) ((a) / (b))
#define TMF_SQRT(a) sqrtf(a)
#define TMF_ABS(a) fabsf(a)
#define TMF_MIN(a, b) tribos_min_(a, b)
#define TMF_MAX(a, b) tribos_max_(a, b)
#define TMF_MASK int
#define TMF_LESS(a, b) ((a) < (b))
#define TMF_AT_MOST(a, b) ((a) <= (b))
#define TMF_SELECT(m, a, b) ((m) ? (a) : (b))
#define TMF_ALL(m) (m)
TRIBOS_FN float tribos_min_(float a, float b) { return b < a ? b : a; }
TRIBOS_FN float tribos_max_(float a, float b) { return a < b ? b : a; }
#endif
#endif

#ifdef TMF_NAME

#ifndef TMF_ONCE_
#define TMF_ONCE_
#define TMF_F_(f) TMF_SPLAT(f)
/* Names of this inclusion's own functions. */
#define TMF_OWN_(suffix) TMF_JOINED_(TMF_NAME, suffix)
#endif

/* h and its first two derivatives at X. */
TRIBOS_FN void TMF_OWN_(_height_)(const TMF_T h[3], TMF_T x2, TMF_T out[3])
{
	TMF_T x4 = TMF_MUL(x2, x2), twice = TMF_ADD(h[1], h[1]), four = TMF_MUL(TMF_F_(4.0f), h[2]);
	out[0] = TMF_ADD(TMF_ADD(TMF_F_(1.0f), TMF_MUL(h[0], x2)), TMF_MUL(x4, TMF_ADD(h[1], TMF_MUL(h[2], x4))));
	out[1] = TMF_ADD(TMF_ADD(h[0], TMF_MUL(twice, x2)), TMF_MUL(TMF_MUL(four, x2), x4));
	out[2] = TMF_ADD(twice, TMF_MUL(TMF_MUL(TMF_F_(3.0f), four), x4));
}

/* Quadratic form of a symmetric matrix. */
TRIBOS_FN TMF_T TMF_OWN_(_form_)(const TMF_T m[3], TMF_T x, TMF_T y)
{
	return TMF_ADD(TMF_ADD(TMF_MUL(TMF_MUL(m[0], x), x), TMF_MUL(TMF_MUL(TMF_ADD(m[1], m[1]), x), y)),
				   TMF_MUL(TMF_MUL(m[2], y), y));
}

/* Limit curve for a force along (x, y). */
TRIBOS_FN void TMF_OWN_(_curve_)(const TMF_T spinning[3], const TMF_T slipping[3], TMF_T x, TMF_T y, TMF_T h[3])
{
	TMF_T g = TMF_MIN(TMF_MAX(TMF_OWN_(_form_)(spinning, x, y), TMF_F_(0.3f)), TMF_F_(2.0f));
	TMF_T w = TMF_MIN(TMF_MAX(TMF_OWN_(_form_)(slipping, x, y), TMF_F_(0.05f)), TMF_F_(1.5f));
	h[0] = TMF_SUB(TMF_F_(0.5f), TMF_MUL(TMF_F_(0.5f), g));
	h[1] = TMF_ADD(TMF_F_(-0.1126f), TMF_MUL(TMF_F_(0.1339f), w));
	h[2] = TMF_SUB(TMF_SUB(TMF_SUB(TMF_SQRT(w), TMF_F_(1.0f)), h[0]), h[1]);
}

/* The whole search. `h` is the limit curve, that of `spinning` and `slipping` unless these are null. */
TRIBOS_FN void TMF_OWN_(_search_)(TMF_T k, TMF_T kt, TMF_T force, TMF_T lever, TMF_T slip, TMF_T h[3],
									  const TMF_T *spinning, const TMF_T *slipping, int steps, TMF_T *p1, TMF_T *p2,
									  TMF_T *t)
{
	const TMF_T zero = TMF_F_(0.0f), one = TMF_F_(1.0f), half = TMF_F_(0.5f), tiny = TMF_F_(1e-30f);
	const TMF_T diagonal = TMF_F_(0.70710678f), three = TMF_F_(3.0f), most = TMF_F_(0.6f);
	TMF_T twist = TMF_SELECT(TMF_LESS(zero, lever), *t, TMF_SELECT(TMF_AT_MOST(*t, *t), zero, *t));
	TMF_T limit = TMF_MUL(force, lever); /* of the twist */
	TMF_T p = TMF_SQRT(TMF_ADD(TMF_MUL(*p1, *p1), TMF_MUL(*p2, *p2))), q = TMF_ABS(twist);
	/* A candidate that static friction holds is left as it is. */
	TMF_T inv = TMF_DIV(one, TMF_ADD(p, tiny)), d1 = TMF_MUL(*p1, inv), d2 = TMF_MUL(*p2, inv);
	TMF_T x, y, x2, at[3], a, b, fw, tw, sum, least, start, bq, unit, ap, l, spin2, radius, widening;
	TMF_T s, c, along, last = zero, before = zero;
	TMF_MASK holds;
	int i;
	if (spinning)
		TMF_OWN_(_curve_)(spinning, slipping, d1, d2, h);
	x = TMF_DIV(TMF_MUL(slip, p), TMF_ADD(force, tiny));
	y = TMF_DIV(TMF_MUL(slip, q), TMF_ADD(limit, tiny));
	x2 = TMF_MUL(x, x);
	TMF_OWN_(_height_)(h, TMF_MIN(x2, one), at);
	holds = TMF_AT_MOST(TMF_MUL(y, y), TMF_MUL(TMF_MUL(TMF_SUB(one, x2), at[0]), at[0]));
	if (TMF_ALL(holds)) {
		*t = twist;
		return;
	}
	/* Metric k |dp|2 + kt dt2 in units of the limits: only ratios of a, b, ap and bq count, none may exceed 1. */
	fw = TMF_MUL(k, force);
	tw = TMF_MUL(kt, limit);
	a = TMF_MUL(fw, force);
	b = TMF_MUL(tw, limit);
	sum = TMF_ADD(a, b);
	least = TMF_MUL(TMF_F_(1e-6f), sum);
	a = TMF_MAX(a, least);
	b = TMF_MAX(b, least);
	x = TMF_ABS(*p1);
	y = TMF_ABS(*p2);
	start = TMF_MUL(fw, TMF_MAX(TMF_MAX(x, y), TMF_MUL(diagonal, TMF_ADD(x, y))));
	bq = TMF_MUL(tw, q);
	unit = TMF_DIV(one, TMF_MAX(TMF_ADD(TMF_ADD(start, bq), sum), tiny));
	fw = TMF_MUL(fw, unit);
	a = TMF_MUL(a, unit);
	b = TMF_MUL(b, unit);
	ap = TMF_MUL(fw, p);
	bq = TMF_MUL(bq, unit);
	start = TMF_MUL(start, unit);
	/* Multiplier of the nearest point of a circle like the curve: Newton's method from below. */
	l = TMF_ADD(TMF_MUL(diagonal, start), TMF_SUB(TMF_MUL(diagonal, bq), TMF_MAX(a, b)));
	l = TMF_MAX(TMF_MAX(TMF_SUB(start, a), TMF_SUB(bq, b)), TMF_MAX(l, zero));
	spin2 = zero;
	radius = one;
	widening = TMF_MUL(TMF_F_(0.55f), TMF_ADD(h[0], TMF_MUL(half, h[1])));
	for (i = 0; i < 2; ++i) {
		TMF_T oa = TMF_ADD(a, l), ob = TMF_ADD(b, l), u = TMF_MUL(ap, ob), v = TMF_MUL(bq, oa);
		TMF_T u2 = TMF_MUL(u, u), v2 = TMF_MUL(v, v), n2 = TMF_ADD(u2, v2);
		TMF_T r = TMF_MUL(TMF_MUL(oa, ob), radius), r2 = TMF_MUL(r, r);
		TMF_T rise = TMF_MUL(TMF_MUL(n2, TMF_ADD(r, r)), TMF_SUB(n2, r2));
		TMF_T slope = TMF_MUL(TMF_ADD(n2, TMF_MUL(three, r2)), TMF_ADD(TMF_MUL(u2, ob), TMF_MUL(v2, oa)));
		l = TMF_MAX(TMF_ADD(l, TMF_DIV(rise, TMF_MAX(slope, tiny))), zero);
		spin2 = TMF_DIV(v2, TMF_MAX(n2, tiny));
		radius = TMF_ADD(one, TMF_MUL(widening, TMF_MUL(spin2, TMF_SUB(one, spin2))));
	}
	along = p;
	if (spinning) {
		/* The force turns towards the directions in which spin leaves more of it. */
		TMF_T coupled = TMF_MUL(l, spin2), isotropic = TMF_ADD(a, TMF_SUB(l, coupled));
		TMF_T xx = TMF_ADD(isotropic, TMF_MUL(coupled, spinning[0])), xy = TMF_MUL(coupled, spinning[1]);
		TMF_T yy = TMF_ADD(isotropic, TMF_MUL(coupled, spinning[2]));
		x = TMF_SUB(TMF_MUL(yy, d1), TMF_MUL(xy, d2));
		y = TMF_SUB(TMF_MUL(xx, d2), TMF_MUL(xy, d1));
		inv = TMF_DIV(one, TMF_ADD(TMF_SQRT(TMF_ADD(TMF_MUL(x, x), TMF_MUL(y, y))), tiny));
		d1 = TMF_MUL(x, inv);
		d2 = TMF_MUL(y, inv);
		along = TMF_MAX(TMF_ADD(TMF_MUL(*p1, d1), TMF_MUL(*p2, d2)), zero);
		ap = TMF_MUL(fw, along);
		TMF_OWN_(_curve_)(spinning, slipping, d1, d2, h);
	}
	/* The point (s, c h) of the curve with this multiplier. */
	TMF_OWN_(_height_)(h, TMF_SUB(one, spin2), at);
	x = TMF_SUB(at[0], TMF_MUL(TMF_ADD(spin2, spin2), at[1]));
	s = TMF_MUL(ap, TMF_ADD(l, TMF_MUL(TMF_MUL(x, at[0]), b)));
	c = TMF_MUL(TMF_MUL(x, bq), TMF_ADD(a, l));
	inv = TMF_DIV(one, TMF_SQRT(TMF_MAX(TMF_ADD(TMF_MUL(s, s), TMF_MUL(c, c)), tiny)));
	s = TMF_MUL(s, inv);
	c = TMF_MUL(c, inv);
	/* Newton steps along the curve, corrected by the change of the slope. */
	for (i = 0; i < steps; ++i) {
		TMF_T s2 = TMF_MUL(s, s), c2 = TMF_MUL(c, c), sc = TMF_MUL(s, c), twice = TMF_ADD(c2, c2);
		TMF_T steep, hq, bend, fx, fy, residual, descent, angle, onto, scale;
		TMF_OWN_(_height_)(h, s2, at);
		steep = TMF_SUB(at[0], TMF_MUL(twice, at[1]));
		hq = TMF_MUL(sc, TMF_SUB(TMF_MUL(three, at[1]), TMF_MUL(twice, at[2])));
		bend = TMF_ADD(TMF_MUL(c, steep), TMF_MUL(s, TMF_ADD(hq, hq)));
		fx = TMF_SUB(ap, TMF_MUL(a, s));
		fy = TMF_SUB(bq, TMF_MUL(b, TMF_MUL(c, at[0])));
		residual = TMF_SUB(TMF_MUL(fx, c), TMF_MUL(fy, TMF_MUL(s, steep)));
		descent = TMF_ADD(TMF_ADD(TMF_MUL(a, c2), TMF_MUL(fx, s)),
						  TMF_ADD(TMF_MUL(TMF_MUL(b, s2), TMF_MUL(steep, steep)), TMF_MUL(fy, bend)));
		descent = TMF_MAX(descent, tiny);
		angle = TMF_MAX(TMF_MIN(TMF_DIV(residual, descent), most), TMF_F_(-0.6f));
		if (i > 0) {
			TMF_MASK is_short = TMF_LESS(TMF_ABS(last), TMF_F_(1e-4f));
			TMF_T change = TMF_SELECT(is_short, zero, TMF_SUB(descent, before));
			TMF_T over = TMF_MUL(TMF_SELECT(is_short, one, last), descent);
			TMF_T factor = TMF_SUB(one, TMF_MUL(TMF_MUL(half, angle), TMF_DIV(change, over)));
			angle = TMF_MUL(angle, TMF_MAX(TMF_MIN(factor, TMF_F_(1.5f)), half));
		}
		last = angle;
		before = descent;
		/* Back onto the unit circle. */
		onto = TMF_SUB(TMF_F_(1.5f), TMF_MUL(half, TMF_ADD(s2, c2)));
		s = TMF_MUL(s, onto);
		c = TMF_MUL(c, onto);
		scale = TMF_SUB(one, TMF_MUL(half, TMF_MUL(angle, angle)));
		x = TMF_ABS(TMF_MUL(TMF_ADD(s, TMF_MUL(angle, c)), scale));
		c = TMF_ABS(TMF_MUL(TMF_SUB(c, TMF_MUL(angle, s)), scale));
		s = x;
	}
	TMF_OWN_(_height_)(h, TMF_MUL(s, s), at);
	x = TMF_MIN(TMF_MUL(s, force), along);
	y = TMF_MIN(TMF_MUL(TMF_MUL(c, at[0]), limit), q);
	y = TMF_SELECT(TMF_LESS(twist, zero), TMF_MUL(TMF_F_(-1.0f), y), y);
	*p1 = TMF_SELECT(holds, *p1, TMF_MUL(x, d1));
	*p2 = TMF_SELECT(holds, *p2, TMF_MUL(x, d2));
	*t = TMF_SELECT(holds, twist, y);
}

TRIBOS_FN void TMF_NAME(TMF_T k, TMF_T kt, TMF_T force, TMF_T lever, TMF_T slip, const TMF_T curve[3], TMF_T *p1,
							TMF_T *p2, TMF_T *t)
{
	TMF_T h[3];
	h[0] = curve[0];
	h[1] = curve[1];
	h[2] = curve[2];
	TMF_OWN_(_search_)(k, kt, force, lever, slip, h, 0, 0, 2, p1, p2, t);
}

TRIBOS_FN void TMF_OWN_(_directed)(TMF_T k, TMF_T kt, TMF_T force, TMF_T lever, TMF_T slip, const TMF_T spinning[3],
									   const TMF_T slipping[3], TMF_T *p1, TMF_T *p2, TMF_T *t)
{
	TMF_T h[3];
	h[0] = h[1] = h[2] = TMF_F_(0.0f);
	TMF_OWN_(_search_)(k, kt, force, lever, slip, h, spinning, slipping, 3, p1, p2, t);
}

#undef TMF_NAME
#undef TMF_T
#undef TMF_SPLAT
#undef TMF_ADD
#undef TMF_SUB
#undef TMF_MUL
#undef TMF_DIV
#undef TMF_SQRT
#undef TMF_ABS
#undef TMF_MIN
#undef TMF_MAX
#undef TMF_MASK
#undef TMF_LESS
#undef TMF_AT_MOST
#undef TMF_SELECT
#undef TMF_ALL
#undef TMF_ONCE_
#undef TMF_F_
#undef TMF_OWN_
#ifdef TMF_SCALAR_
#undef TMF_SCALAR_
#endif

#endif
