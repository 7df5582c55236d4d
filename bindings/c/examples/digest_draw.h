/* Random draws and the hash in one precision; included by digest_real.h. */

/* One number from a distribution. */
static REAL LOCAL(draw)(struct stream *s, enum range range)
{
    const REAL infinity = (REAL)REAL_MAX + (REAL)REAL_MAX;
    const REAL edges[11] = {
        0,
        -(REAL)0,
        REAL_MIN * REAL_EPSILON,
        -REAL_MIN * REAL_EPSILON,
        REAL_MIN,
        REAL_MAX,
        -REAL_MAX,
        infinity,
        -infinity,
        infinity - infinity,
        1,
    };
    const uint64_t bits = draw_bits(s);
    const unsigned odd = bits & 63;
    /* 24 bits: exact in either precision. */
    REAL x = (REAL)(bits >> 40) / 16777216;

    if (range == WIDE && odd < 11) {
        return edges[odd];
    }
    if ((range == MILD || range == FIT) && odd == 0) {
        return edges[(bits >> 6) % 11];
    }
    if (range == WIDE) {
        x = x * (REAL)((uint64_t)1 << ((bits >> 6) & 31)) / 65536;
    } else {
        x = 2 * x;
    }
    if (range == FIT || range == SURE) {
        return x < (REAL)1 / 1024 ? (REAL)1 / 1024 : x;
    }
    return (bits >> 11) & 1 ? -x : x;
}

static void LOCAL(draws)(struct stream *s, enum range range, REAL *x, int count)
{
    int i;

    for (i = 0; i < count; ++i) {
        x[i] = LOCAL(draw)(s, range);
    }
}

static NAME(vector) LOCAL(draw_vector)(struct stream *s, enum range range)
{
    REAL x[3];
    NAME(vector) vector;

    LOCAL(draws)(s, range, x, 3);
    vector.x = x[0];
    vector.y = x[1];
    vector.z = x[2];
    return vector;
}

static NAME(twist) LOCAL(draw_twist)(struct stream *s, enum range range)
{
    NAME(vector) x = LOCAL(draw_vector)(s, range);
    NAME(twist) twist = {x.x, x.y, x.z};

    return twist;
}

static NAME(wrench) LOCAL(draw_wrench)(struct stream *s, enum range range)
{
    NAME(vector) x = LOCAL(draw_vector)(s, range);
    NAME(wrench) wrench = {x.x, x.y, x.z};

    return wrench;
}

static void LOCAL(feed)(struct stream *s, tribos_status status, REAL x)
{
    if (ok(s, status)) {
        feed_number(s, x);
    }
}

static void LOCAL(feed_three)(struct stream *s, REAL x, REAL y, REAL z)
{
    feed_number(s, x);
    feed_number(s, y);
    feed_number(s, z);
}

static void LOCAL(feed_vector)(struct stream *s, NAME(vector) v)
{
    LOCAL(feed_three)(s, v.x, v.y, v.z);
}

static void LOCAL(feed_wrench)(struct stream *s, tribos_status status, NAME(wrench) w)
{
    if (ok(s, status)) {
        LOCAL(feed_three)(s, w.x, w.y, w.torque);
    }
}

static void LOCAL(feed_twist)(struct stream *s, tribos_status status, NAME(twist) t)
{
    if (ok(s, status)) {
        LOCAL(feed_three)(s, t.x, t.y, t.spin);
    }
}

static void LOCAL(feed_jacobian)(struct stream *s, tribos_status status, const NAME(jacobian) *j)
{
    int row;

    if (ok(s, status)) {
        for (row = 0; row < 3; ++row) {
            LOCAL(feed_three)(s, j->rows[row][0], j->rows[row][1], j->rows[row][2]);
        }
    }
}

static void LOCAL(feed_motion)(struct stream *s, NAME(motion) m)
{
    LOCAL(feed_three)(s, m.time, m.speed, m.spin);
    feed_number(s, m.distance);
    feed_number(s, m.angle);
}

/* Declares the result of a call, calls, and hashes the result. */
#define NUMBER(call)                  \
    do {                              \
        REAL out = 0;                 \
        tribos_status status = call;  \
        LOCAL(feed)(s, status, out);  \
    } while (0)
#define WRENCH(call)                        \
    do {                                    \
        NAME(wrench) out = {0, 0, 0};       \
        tribos_status status = call;        \
        LOCAL(feed_wrench)(s, status, out); \
    } while (0)
#define TWIST(call)                        \
    do {                                   \
        NAME(twist) out = {0, 0, 0};       \
        tribos_status status = call;       \
        LOCAL(feed_twist)(s, status, out); \
    } while (0)
#define JACOBIAN(call)                         \
    do {                                       \
        NAME(jacobian) out = {{{0}}};          \
        tribos_status status = call;           \
        LOCAL(feed_jacobian)(s, status, &out); \
    } while (0)
