/*
 * A digest of all functions of the header, in both precisions, over a seeded stream of inputs.
 *
 * The numbers are drawn from integers and powers of two without rounding, so that all rounding except
 * that of a few sums happens in the library.
 */
#include "demo.h"
#include "tribos.h"

#include <float.h>
#include <string.h>

/* Distribution of the numbers of a draw. */
enum range {
    WIDE, /* either sign, 2^-16 to 2^15; one in six at an edge of the number range */
    MILD, /* -2 to 2, one in 64 at an edge */
    FIT, /* 2^-10 to 2, one in 64 at an edge: mostly accepted as a parameter */
    SURE /* 2^-10 to 2 */
};

struct stream {
    uint64_t state;
    uint64_t hash;
};

static uint64_t draw_bits(struct stream *s)
{
    s->state = s->state * 6364136223846793005u + 1442695040888963407u;
    return s->state ^ (s->state >> 33);
}

static void feed_bits(struct stream *s, uint64_t bits)
{
    int byte;

    for (byte = 0; byte < 8; ++byte) {
        s->hash = (s->hash ^ (bits & 255)) * 0x100000001b3u;
        bits >>= 8;
    }
}

/* The payload of a NaN is not part of any promise. */
static void feed_number(struct stream *s, double x)
{
    uint64_t bits = 0x7ff8000000000000u;

    if (x == x) {
        memcpy(&bits, &x, sizeof bits);
    }
    feed_bits(s, bits);
}

/* Hashes whether a call succeeded, and returns it. */
static int ok(struct stream *s, tribos_status status)
{
    feed_bits(s, status == TRIBOS_STATUS_OK);
    return status == TRIBOS_STATUS_OK;
}

#define REAL double
#define REAL_MAX DBL_MAX
#define REAL_MIN DBL_MIN
#define REAL_EPSILON DBL_EPSILON
#define NAME(name) tribos_##name##_f64
#define LOCAL(name) name##_f64
#include "digest_real.h"
#undef REAL
#undef REAL_MAX
#undef REAL_MIN
#undef REAL_EPSILON
#undef NAME
#undef LOCAL

#define REAL float
#define REAL_MAX FLT_MAX
#define REAL_MIN FLT_MIN
#define REAL_EPSILON FLT_EPSILON
#define NAME(name) tribos_##name##_f32
#define LOCAL(name) name##_f32
#include "digest_real.h"

uint64_t digest(void)
{
    struct stream s = {1, 0xcbf29ce484222325u};

    all_f64(&s);
    all_f32(&s);
    return s.hash;
}
