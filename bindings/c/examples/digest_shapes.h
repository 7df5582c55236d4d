/* The digest of shapes, feet and steps under static friction in one precision; included by digest_real.h. */

static void LOCAL(feed_shape)(struct stream *s, const NAME(shape) *shape, const REAL *p,
                              const NAME(twist) *twist, const NAME(wrench) *push)
{
    NAME(wrench) met = {0, 0, 0};
    NAME(jacobian) rates = {{{0}}};
    NAME(projection) nearest = {{0, 0, 0}, {0, 0, 0}, 0};
    tribos_status status;

    WRENCH(NAME(shape_wrench)(shape, p[0], p[1], twist, &out));
    status = NAME(shape_wrench_jacobian)(shape, p[0], p[1], twist, &met, &rates);
    LOCAL(feed_wrench)(s, status, met);
    LOCAL(feed_jacobian)(s, status, &rates);
    NUMBER(NAME(shape_gauge)(shape, p[2], push, &out));
    TWIST(NAME(shape_motion)(shape, p[2], push, &out));
    status = NAME(shape_project)(shape, p[2], push, p[3], &nearest);
    LOCAL(feed_projection)(s, status, nearest);
}

/* A built shape with one coefficient, then with two. */
static int LOCAL(feed_both)(struct stream *s, tribos_status status, NAME(shape) *shape, const REAL *p,
                            const NAME(point) *axis, const NAME(twist) *twist,
                            const NAME(wrench) *push)
{
    if (!ok(s, status)) {
        return 0;
    }
    LOCAL(feed_shape)(s, shape, p, twist, push);
    if (!ok(s, NAME(shape_two_coefficients)(shape, p[4], p[5], axis))) {
        return 0;
    }
    LOCAL(feed_shape)(s, shape, p, twist, push);
    return 1;
}

static void LOCAL(feed_sticking)(struct stream *s, tribos_status status, const NAME(planar_step) *step)
{
    if (ok(s, status)) {
        feed_bits(s, step->is_at_rest);
        LOCAL(feed_three)(s, step->twist.x, step->twist.y, step->twist.spin);
        LOCAL(feed_three)(s, step->friction.x, step->friction.y, step->friction.torque);
    }
}

static void LOCAL(feed_feet)(struct stream *s, const NAME(foot) *feet, const REAL *p,
                             const NAME(twist) *twist, const NAME(wrench) *push)
{
    NAME(planar_body) body;
    NAME(wrench) met = {0, 0, 0};
    NAME(jacobian) rates = {{{0}}};
    NAME(steady_motion) steady;
    NAME(floor_step) step;
    tribos_status status;

    body.mass = p[0];
    body.inertia = p[1];
    WRENCH(NAME(feet_wrench)(feet, 3, twist, &out));
    status = NAME(feet_wrench_jacobian)(feet, 3, twist, &met, &rates);
    LOCAL(feed_wrench)(s, status, met);
    LOCAL(feed_jacobian)(s, status, &rates);
    if (ok(s, NAME(feet_steady_motion)(feet, 3, push, &steady))) {
        feed_bits(s, steady.carried_by);
        feed_bits(s, steady.evaluations);
        LOCAL(feed_three)(s, steady.twist.x, steady.twist.y, steady.twist.spin);
        LOCAL(feed_three)(s, steady.friction.x, steady.friction.y, steady.friction.torque);
    }
    if (ok(s, NAME(feet_step)(&body, feet, 3, twist, push, p[6], &step))) {
        feed_bits(s, step.carried_by);
        feed_number(s, step.imbalance);
        LOCAL(feed_three)(s, step.twist.x, step.twist.y, step.twist.spin);
        LOCAL(feed_three)(s, step.friction.x, step.friction.y, step.friction.torque);
    }
}

/* Bars, a worn annulus and points, each with one and two coefficients. */
static void LOCAL(feed_others)(struct stream *s, const REAL *x, const REAL *p, const NAME(point) *centre,
                               const NAME(point) *axis, const NAME(twist) *twist,
                               const NAME(wrench) *push)
{
    NAME(point) from, to;
    NAME(node) nodes[3];
    NAME(shape) shape;
    tribos_status status;
    int i;

    from.x = x[0];
    from.y = -x[1];
    to.x = -x[2];
    to.y = x[3];
    for (i = 0; i < 2; ++i) {
        status = NAME(shape_bar)(&from, &to, i == 0 ? 0 : centre->x / 8, &shape);
        LOCAL(feed_both)(s, status, &shape, p, axis, twist, push);
    }
    status = NAME(shape_worn_annulus)(centre, p[6] / 2, p[7], &shape);
    LOCAL(feed_both)(s, status, &shape, p, axis, twist, push);
    for (i = 0; i < 3; ++i) {
        nodes[i].x = i == 1 ? -x[1] : x[2 * i];
        nodes[i].y = i == 2 ? -x[3] : x[2 * i + 1];
        nodes[i].weight = p[i];
    }
    status = NAME(shape_points)(nodes, 3, &shape);
    LOCAL(feed_both)(s, status, &shape, p, axis, twist, push);
}

/* A disk, an ellipse, a polygon and its piece, each with one and two coefficients; then three feet. */
static void LOCAL(shapes)(struct stream *s, enum range range)
{
    const size_t counts[1] = {4};
    REAL x[8], p[8], place[4], share;
    NAME(point) corners[4], centre, axis, axes, across[2];
    NAME(edge) edges[4], other[8];
    NAME(polygon) patch, piece;
    NAME(shape) shapes[3], other_shape;
    NAME(part) parts[3];
    NAME(foot) feet[3];
    NAME(twist) twist;
    NAME(wrench) push;
    NAME(disk_surface) disk;
    NAME(planar_body) body;
    NAME(planar_step) step;
    tribos_status status;
    uint32_t pressure;
    int i, built;

    LOCAL(draws)(s, FIT, x, 8);
    LOCAL(draws)(s, FIT, p, 8);
    LOCAL(draws)(s, MILD, place, 4);
    twist = LOCAL(draw_twist)(s, range);
    push = LOCAL(draw_wrench)(s, range);
    pressure = (uint32_t)(draw_bits(s) >> 62);
    centre.x = place[0];
    centre.y = place[1];
    axis.x = place[2];
    axis.y = place[3];
    axes.x = x[0];
    axes.y = x[1];
    across[0].x = x[2];
    across[0].y = x[3];
    across[1].x = -x[4];
    across[1].y = x[5];
    for (i = 0; i < 3; ++i) {
        feet[i].shape = &shapes[i];
        feet[i].limit = x[5 + i];
        parts[i].shape = &shapes[i];
        parts[i].limit = x[5 + i];
        feet[i].surface = LOCAL(draw_twist)(s, MILD);
    }
    status = NAME(shape_disk)(pressure, &centre, p[7], &shapes[0]);
    built = LOCAL(feed_both)(s, status, &shapes[0], p, &axis, &twist, &push);
    status = NAME(shape_ellipse)(pressure, &centre, &axes, &shapes[1]);
    built += LOCAL(feed_both)(s, status, &shapes[1], p, &axis, &twist, &push);
    status = NAME(shape_turned_ellipse)(pressure, &centre, across, &other_shape);
    LOCAL(feed_both)(s, status, &other_shape, p, &axis, &twist, &push);
    LOCAL(feed_others)(s, x, p, &centre, &axis, &twist, &push);
    for (i = 0; i < 4; ++i) {
        corners[i].x = i == 0 || i == 3 ? x[2 * i] : -x[2 * i];
        corners[i].y = i < 2 ? x[2 * i + 1] : -x[2 * i + 1];
    }
    if (!ok(s, NAME(polygon_new)(corners, counts, 1, edges, 4, &patch))) {
        return;
    }
    centre.x = patch.centre.x + place[0] / 8;
    centre.y = patch.centre.y + place[1] / 8;
    ok(s, NAME(polygon_lean)(&patch, &centre));
    if (ok(s, NAME(polygon_within)(&patch, &centre, &axis, other, 8, &piece, &share))) {
        feed_number(s, share);
        if (share > 0) {
            feed_bits(s, piece.count);
            WRENCH(NAME(polygon_wrench)(&piece, p[0], p[1], &twist, &out));
        }
    }
    status = NAME(shape_polygon)(&patch, &shapes[2]);
    built += LOCAL(feed_both)(s, status, &shapes[2], p, &axis, &twist, &push);
    if (built == 3) {
        status = NAME(shape_feet)(parts, 3, &other_shape);
        LOCAL(feed_both)(s, status, &other_shape, p, &axis, &twist, &push);
    }
    body.mass = p[0];
    body.inertia = p[1];
    disk.force_limit = p[2];
    disk.radius = p[7];
    for (i = 0; i < 2; ++i) {
        status = NAME(planar_disk_step_sticking)(&body, &disk, 1 + p[3], &twist, &push, p[6], &step);
        LOCAL(feed_sticking)(s, status, &step);
        status = NAME(planar_shape_step_sticking)(
            &body, &shapes[2], p[2], 1 + p[3], &twist, &push, p[6], &step);
        LOCAL(feed_sticking)(s, built == 3 ? status : TRIBOS_STATUS_NOT_BUILT, &step);
        if (built == 3) {
            LOCAL(feed_feet)(s, feet, p, &twist, &push);
        }
        /* From rest. */
        twist.x = 0;
        twist.y = 0;
        twist.spin = 0;
    }
}
