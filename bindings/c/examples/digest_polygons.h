/* The digest of patches with straight edges in one precision; included by digest_real.h. */

static void LOCAL(feed_polygon)(struct stream *s, const NAME(polygon) *patch, const REAL *p,
                                const NAME(twist) *twist, const NAME(wrench) *push)
{
    NAME(wrench) met = {0, 0, 0};
    NAME(jacobian) rates = {{{0}}};
    NAME(projection) nearest = {{0, 0, 0}, {0, 0, 0}, 0};
    tribos_status status;

    LOCAL(feed_three)(s, patch->centre.x, patch->centre.y, patch->radius);
    WRENCH(NAME(polygon_wrench)(patch, p[0], p[1], twist, &out));
    status = NAME(polygon_wrench_jacobian)(patch, p[0], p[1], twist, &met, &rates);
    LOCAL(feed_wrench)(s, status, met);
    LOCAL(feed_jacobian)(s, status, &rates);
    NUMBER(NAME(polygon_gauge)(patch, p[2], push, &out));
    TWIST(NAME(polygon_motion)(patch, p[2], push, &out));
    status = NAME(polygon_project)(patch, p[2], push, p[3], &nearest);
    LOCAL(feed_projection)(s, status, nearest);
    status = NAME(polygon_project)(patch, p[2], push, 0, &nearest);
    LOCAL(feed_projection)(s, status, nearest);
}

/* A corner in each quadrant, at times a hole of the same shape; first uniform, then leaning. */
static void LOCAL(polygons)(struct stream *s, enum range range)
{
    const size_t counts[2] = {4, 4};
    REAL x[8], p[4], shift[2];
    NAME(point) corners[8], centre;
    NAME(edge) edges[8];
    NAME(polygon) patch;
    NAME(twist) twist;
    NAME(wrench) push;
    size_t loops;
    int i;

    LOCAL(draws)(s, FIT, x, 8);
    LOCAL(draws)(s, FIT, p, 4);
    LOCAL(draws)(s, MILD, shift, 2);
    twist = LOCAL(draw_twist)(s, range);
    push = LOCAL(draw_wrench)(s, range);
    loops = 1 + (size_t)(draw_bits(s) >> 63);
    for (i = 0; i < 4; ++i) {
        corners[i].x = i == 0 || i == 3 ? x[2 * i] : -x[2 * i];
        corners[i].y = i < 2 ? x[2 * i + 1] : -x[2 * i + 1];
        corners[4 + i].x = corners[i].x / 4;
        corners[4 + i].y = corners[i].y / 4;
    }
    if (!ok(s, NAME(polygon_new)(corners, counts, loops, edges, 8, &patch))) {
        return;
    }
    LOCAL(feed_polygon)(s, &patch, p, &twist, &push);
    centre.x = patch.centre.x + shift[0] / 8;
    centre.y = patch.centre.y + shift[1] / 8;
    if (ok(s, NAME(polygon_lean)(&patch, &centre))) {
        LOCAL(feed_polygon)(s, &patch, p, &twist, &push);
    }
}
