/* Digest of the friction of manifolds as the header computes it: one at a time, and with SSE or NEON four side by side. */
#include "tribos_manifold_friction.h"
#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#if defined(__SSE2__)
#include <emmintrin.h>
#define FOUR_LANES
#define TMF_NAME four_manifolds
#define TMF_T __m128
#define TMF_SPLAT(f) _mm_set1_ps(f)
#define TMF_ADD(a, b) _mm_add_ps(a, b)
#define TMF_SUB(a, b) _mm_sub_ps(a, b)
#define TMF_MUL(a, b) _mm_mul_ps(a, b)
#define TMF_DIV(a, b) _mm_div_ps(a, b)
#define TMF_SQRT(a) _mm_sqrt_ps(a)
#define TMF_ABS(a) _mm_andnot_ps(_mm_set1_ps(-0.0f), a)
#define TMF_MIN(a, b) _mm_min_ps(b, a)
#define TMF_MAX(a, b) _mm_max_ps(b, a)
#define TMF_MASK __m128
#define TMF_LESS(a, b) _mm_cmplt_ps(a, b)
#define TMF_AT_MOST(a, b) _mm_cmple_ps(a, b)
#define TMF_SELECT(m, a, b) _mm_or_ps(_mm_and_ps(m, a), _mm_andnot_ps(m, b))
#define TMF_ALL(m) (_mm_movemask_ps(m) == 15)
typedef __m128 four;
static four loaded(const float *x) { return _mm_loadu_ps(x); }
static void store(float *x, four lanes) { _mm_storeu_ps(x, lanes); }
#elif defined(__ARM_NEON) && defined(__aarch64__)
#include <arm_neon.h>
#define FOUR_LANES
#define TMF_NAME four_manifolds
#define TMF_T float32x4_t
#define TMF_SPLAT(f) vdupq_n_f32(f)
#define TMF_ADD(a, b) vaddq_f32(a, b)
#define TMF_SUB(a, b) vsubq_f32(a, b)
#define TMF_MUL(a, b) vmulq_f32(a, b)
#define TMF_DIV(a, b) vdivq_f32(a, b)
#define TMF_SQRT(a) vsqrtq_f32(a)
#define TMF_ABS(a) vabsq_f32(a)
/* vminq_f32 and vmaxq_f32 give NaN wherever there is one. */
#define TMF_MIN(a, b) smaller(a, b)
#define TMF_MAX(a, b) larger(a, b)
#define TMF_MASK uint32x4_t
#define TMF_LESS(a, b) vcltq_f32(a, b)
#define TMF_AT_MOST(a, b) vcleq_f32(a, b)
#define TMF_SELECT(m, a, b) vbslq_f32(m, a, b)
#define TMF_ALL(m) (vminvq_u32(m) != 0)
typedef float32x4_t four;
static four smaller(four a, four b) { return vbslq_f32(vcltq_f32(b, a), b, a); }
static four larger(four a, four b) { return vbslq_f32(vcltq_f32(a, b), b, a); }
static four loaded(const float *x) { return vld1q_f32(x); }
static void store(float *x, four lanes) { vst1q_f32(x, lanes); }
#endif
#ifdef FOUR_LANES
#include "tribos_manifold_friction.h"
#endif

static uint64_t state = 5;
static uint64_t hash = UINT64_C(0xcbf29ce484222325);

/* Knuth's linear congruential generator. */
static uint32_t bits(void)
{
	state = state * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
	return (uint32_t)(state >> 32);
}

/* A magnitude m 2^k with 0 <= m < 1, k from -12 to 3. */
static float size(void)
{
	uint32_t b = bits();
	return (float)(b >> 8) / 16777216.0f * (float)(1u << (b & 15)) / 4096.0f;
}

static float either(void)
{
	float x = size();
	return bits() & 1 ? x : -x;
}

static void feed(float x)
{
	uint32_t b;
	int i;
	if (x != x)
		b = UINT32_C(0x7fc00000);
	else
		memcpy(&b, &x, sizeof b);
	for (i = 0; i < 4; ++i)
		hash = (hash ^ (b >> (8 * i) & 255)) * UINT64_C(0x100000001b3);
}

int main(void)
{
	static const float curves[3][3] = { TRIBOS_CURVE_AREA, TRIBOS_CURVE_POINTS, TRIBOS_CURVE_ELLIPSOID };
	int n, i;
	for (n = 0; n < 4000; ++n) {
		float corners[10], in[8];
		int count = (int)(bits() % 6);
		tribos_contact_area_f32 area;
		for (i = 0; i < 2 * count; ++i)
			corners[i] = size();
		area = tribos_contact_area(corners, count);
		feed(area.centre[0]);
		feed(area.centre[1]);
		feed(area.lever);
		for (i = 0; i < 3; ++i)
			feed(area.spinning[i]);
		for (i = 0; i < 3; ++i)
			feed(area.slipping[i]);
		in[0] = size();           /* k */
		in[1] = size() * 1024.0f; /* kt */
		in[2] = size();           /* F */
		in[3] = size();           /* lever */
		in[4] = bits() & 1 ? 1.0f : 0.75f;
		in[5] = either();
		in[6] = either();
		in[7] = either();
		for (i = 0; i < 4; ++i) {
			float p1 = in[5], p2 = in[6], t = in[7];
			if (i < 3)
				tribos_manifold_friction(in[0], in[1], in[2], in[3], in[4], curves[i], &p1, &p2, &t);
			else
				tribos_manifold_friction_directed(in[0], in[1], in[2], in[3], in[4], area.spinning, area.slipping, &p1,
												  &p2, &t);
			feed(p1);
			feed(p2);
			feed(t);
#ifdef FOUR_LANES
			{
				four w[8], m[3], s[3];
				float lanes[3][4], want[3];
				int k, l;
				want[0] = p1;
				want[1] = p2;
				want[2] = t;
				for (k = 0; k < 8; ++k) { /* the third lane is another manifold */
					float one[4];
					for (l = 0; l < 4; ++l)
						one[l] = k == 5 && l == 2 ? 0.0f : in[k];
					w[k] = loaded(one);
				}
				for (k = 0; k < 3; ++k) {
					float one[2][4];
					for (l = 0; l < 4; ++l) {
						one[0][l] = i < 3 ? curves[i][k] : area.spinning[k];
						one[1][l] = area.slipping[k];
					}
					m[k] = loaded(one[0]);
					s[k] = loaded(one[1]);
				}
				if (i < 3)
					four_manifolds(w[0], w[1], w[2], w[3], w[4], m, w + 5, w + 6, w + 7);
				else
					four_manifolds_directed(w[0], w[1], w[2], w[3], w[4], m, s, w + 5, w + 6, w + 7);
				for (k = 0; k < 3; ++k)
					store(lanes[k], w[5 + k]);
				for (k = 0; k < 3; ++k)
					for (l = 0; l < 4; ++l)
						if (l != 2 && memcmp(&lanes[k][l], &want[k], sizeof(float)) != 0 && want[k] == want[k]) {
							printf("lane %d has other bits in manifold %d\n", l, n);
							return 1;
						}
			}
#endif
		}
	}
	printf("%016" PRIx64 "\n", hash);
	return 0;
}
