/* The digest in one precision; included twice by digest.c, which sets REAL, NAME and LOCAL. */
#include "digest_draw.h"

static void LOCAL(simple_laws)(struct stream *s)
{
    REAL p[6], x;
    uint32_t sticks = 0;
    NAME(coulomb) coulomb;
    NAME(dry) dry;
    NAME(power) power;
    NAME(stribeck) stribeck;

    LOCAL(draws)(s, FIT, p, 6);
    x = LOCAL(draw)(s, WIDE);
    coulomb.mu = p[0];
    dry.mu_static = p[0] + p[1];
    dry.mu_dynamic = p[1];
    power.alpha = p[2] - 1;
    power.coefficient = p[3];
    stribeck.dry = dry;
    stribeck.stribeck_speed = p[2];
    stribeck.exponent = p[3];
    stribeck.viscous = p[4];
    NUMBER(NAME(coulomb_friction)(&coulomb, x, &out));
    NUMBER(NAME(dry_friction)(&dry, x, &out));
    if (ok(s, NAME(dry_sticks)(&dry, x, &sticks))) {
        feed_bits(s, sticks);
    }
    NUMBER(NAME(dry_net_drive)(&dry, x, &out));
    NUMBER(NAME(power_friction)(&power, x, &out));
    NUMBER(NAME(power_slope)(&power, x, &out));
    NUMBER(NAME(stribeck_friction)(&stribeck, x, &out));
    NUMBER(NAME(stribeck_slope)(&stribeck, x, &out));
    NUMBER(NAME(stribeck_minimum)(&stribeck, &out));
}

static void LOCAL(laws_with_state)(struct stream *s)
{
    REAL p[6], x[3], z;
    NAME(lugre) lugre;
    NAME(rate_state) rock;

    LOCAL(draws)(s, FIT, p, 6);
    LOCAL(draws)(s, WIDE, x, 3);
    lugre.coulomb_force = p[0];
    lugre.static_force = p[0] + p[1];
    lugre.stribeck_speed = p[2];
    lugre.stiffness = p[3];
    lugre.bristle_damping = p[4];
    lugre.viscous_damping = p[5];
    rock.mu = p[0];
    rock.a = p[1];
    rock.b = p[2];
    rock.reference_speed = p[3];
    rock.slip_distance = p[4];
    rock.viscous = p[5];
    z = x[0];
    NUMBER(NAME(lugre_step)(&lugre, &z, x[1], x[2], &out));
    feed_number(s, z);
    NUMBER(NAME(lugre_force)(&lugre, x[0], x[1], &out));
    NUMBER(NAME(lugre_steady_force)(&lugre, x[1], &out));
    NUMBER(NAME(lugre_passive_up_to)(&lugre, &out));
    NUMBER(NAME(rate_state_friction)(&rock, x[0], x[1], &out));
    NUMBER(NAME(rate_state_slope)(&rock, x[0], x[1], &out));
    z = x[1];
    LOCAL(feed)(s, NAME(rate_state_advance_dieterich)(&rock, &z, x[0], x[2]), 0);
    feed_number(s, z);
    z = x[1];
    LOCAL(feed)(s, NAME(rate_state_advance_ruina)(&rock, &z, x[0], x[2]), 0);
    feed_number(s, z);
    NUMBER(NAME(rate_state_steady_friction)(&rock, x[0], &out));
    NUMBER(NAME(rate_state_steady_slope)(&rock, x[0], &out));
}

enum { LOCAL(TWISTS) = 21 }; /* more than the library converts at once */

static void LOCAL(draw_twists)(struct stream *s, NAME(twist) *twists)
{
    int i;

    for (i = 0; i < LOCAL(TWISTS); ++i) {
        twists[i] = LOCAL(draw_twist)(s, WIDE);
    }
}

static void LOCAL(feed_wrenches)(struct stream *s, tribos_status status, const NAME(wrench) *w)
{
    int i;

    for (i = 0; i < LOCAL(TWISTS); ++i) {
        LOCAL(feed_wrench)(s, status, w[i]);
    }
}

static void LOCAL(feed_jacobians)(struct stream *s, tribos_status status, const NAME(jacobian) *j)
{
    int i;

    for (i = 0; i < LOCAL(TWISTS); ++i) {
        LOCAL(feed_jacobian)(s, status, &j[i]);
    }
}

static void LOCAL(patches)(struct stream *s)
{
    static NAME(twist) twists[LOCAL(TWISTS)];
    static NAME(wrench) wrenches[LOCAL(TWISTS)];
    static NAME(jacobian) jacobians[LOCAL(TWISTS)];
    tribos_status status;
    REAL p[4];
    NAME(round) patch;
    NAME(twist) twist;
    REAL load, inner;

    LOCAL(draws)(s, FIT, p, 4);
    twist = LOCAL(draw_twist)(s, WIDE);
    patch.coefficient = p[0];
    patch.radius = p[1];
    load = p[2];
    inner = p[3] / 2;
    WRENCH(NAME(disk_wrench)(&patch, load, &twist, &out));
    JACOBIAN(NAME(disk_jacobian)(&patch, load, &twist, &out));
    WRENCH(NAME(annulus_wrench)(&patch, inner, load, &twist, &out));
    JACOBIAN(NAME(annulus_jacobian)(&patch, inner, load, &twist, &out));
    WRENCH(NAME(hertz_wrench)(&patch, load, &twist, &out));
    JACOBIAN(NAME(hertz_jacobian)(&patch, load, &twist, &out));
    WRENCH(NAME(ring_wrench)(&patch, load, &twist, &out));
    JACOBIAN(NAME(ring_jacobian)(&patch, load, &twist, &out));
    WRENCH(NAME(punch_wrench)(&patch, load, &twist, &out));
    JACOBIAN(NAME(punch_jacobian)(&patch, load, &twist, &out));
    LOCAL(draw_twists)(s, twists);
    status = NAME(disk_wrench_batch)(&patch, load, twists, LOCAL(TWISTS), wrenches);
    LOCAL(feed_wrenches)(s, status, wrenches);
    status = NAME(disk_jacobian_batch)(&patch, load, twists, LOCAL(TWISTS), jacobians);
    LOCAL(feed_jacobians)(s, status, jacobians);
}

static void LOCAL(powers)(struct stream *s)
{
    REAL p[5];
    NAME(round) patch;
    NAME(power_compact) power;
    NAME(twist) twist;

    LOCAL(draws)(s, FIT, p, 5);
    twist = LOCAL(draw_twist)(s, MILD);
    power.built = 0;
    (void)ok(s, NAME(power_compact_build)(2 * p[0] - 1, p[1] - 1, &power));
    patch.coefficient = p[2];
    patch.radius = p[3];
    WRENCH(NAME(power_compact_wrench)(&power, &patch, p[4], &twist, &out));
    JACOBIAN(NAME(power_compact_jacobian)(&power, &patch, p[4], &twist, &out));
}

static void LOCAL(tables)(struct stream *s)
{
    static NAME(power_table) table;
    static NAME(twist) twists[LOCAL(TWISTS)];
    static NAME(wrench) wrenches[LOCAL(TWISTS)];
    static NAME(jacobian) jacobians[LOCAL(TWISTS)];
    tribos_status status;
    const REAL alphas[6] = {(REAL)-0.5, (REAL)0.5, 3, -1, 11, 1};
    REAL p[3];
    int a, n;

    for (a = 0; a < 6; ++a) {
        if (!ok(s, NAME(power_table_build)(alphas[a], &table))) {
            continue;
        }
        for (n = 0; n < 40; ++n) {
            NAME(round) patch;
            NAME(twist) twist;

            LOCAL(draws)(s, FIT, p, 3);
            twist = LOCAL(draw_twist)(s, WIDE);
            patch.coefficient = p[0];
            patch.radius = p[1];
            WRENCH(NAME(power_table_wrench)(&table, &patch, p[2], &twist, &out));
            JACOBIAN(NAME(power_table_jacobian)(&table, &patch, p[2], &twist, &out));
            LOCAL(draw_twists)(s, twists);
            status = NAME(power_table_wrench_batch)(
                &table, &patch, p[2], twists, LOCAL(TWISTS), wrenches);
            LOCAL(feed_wrenches)(s, status, wrenches);
            status = NAME(power_table_jacobian_batch)(
                &table, &patch, p[2], twists, LOCAL(TWISTS), jacobians);
            LOCAL(feed_jacobians)(s, status, jacobians);
        }
    }
}

static void LOCAL(feed_nodes)(struct stream *s, const NAME(node) *nodes, size_t count)
{
    size_t i;

    for (i = 0; i < count; ++i) {
        LOCAL(feed_three)(s, nodes[i].x, nodes[i].y, nodes[i].weight);
    }
}

static void LOCAL(points)(struct stream *s)
{
    REAL p[5], x[12];
    NAME(node) nodes[4];
    NAME(coulomb) coulomb;
    NAME(power) power;
    NAME(stribeck) stribeck;
    NAME(twist) twist;
    int i;

    LOCAL(draws)(s, FIT, p, 5);
    LOCAL(draws)(s, MILD, x, 12);
    twist = LOCAL(draw_twist)(s, MILD);
    for (i = 0; i < 4; ++i) {
        nodes[i].x = x[3 * i];
        nodes[i].y = x[3 * i + 1];
        nodes[i].weight = x[3 * i + 2] < 0 ? -x[3 * i + 2] : x[3 * i + 2];
    }
    coulomb.mu = p[0];
    power.alpha = p[1] - (REAL)0.5;
    power.coefficient = p[2];
    stribeck.dry.mu_static = p[0] + p[1];
    stribeck.dry.mu_dynamic = p[1];
    stribeck.stribeck_speed = p[2];
    stribeck.exponent = p[3];
    stribeck.viscous = p[4];
    WRENCH(NAME(nodes_coulomb_wrench)(&coulomb, nodes, 4, p[4], &twist, &out));
    JACOBIAN(NAME(nodes_coulomb_jacobian)(&coulomb, nodes, 4, p[4], &twist, &out));
    WRENCH(NAME(nodes_power_wrench)(&power, nodes, 4, p[4], &twist, &out));
    JACOBIAN(NAME(nodes_power_jacobian)(&power, nodes, 4, p[4], &twist, &out));
    WRENCH(NAME(nodes_stribeck_wrench)(&stribeck, nodes, 4, p[4], &twist, &out));
    JACOBIAN(NAME(nodes_stribeck_jacobian)(&stribeck, nodes, 4, p[4], &twist, &out));
}

static void LOCAL(rules)(struct stream *s)
{
    REAL x[8], p[4];
    NAME(point) corners[4];
    NAME(node) nodes[60];
    NAME(disk_rule) rule;
    size_t filled = 0;
    int i;

    LOCAL(draws)(s, MILD, x, 8);
    LOCAL(draws)(s, FIT, p, 4);
    for (i = 0; i < 4; ++i) {
        corners[i].x = x[2 * i];
        corners[i].y = x[2 * i + 1];
    }
    if (ok(s, NAME(polygon_nodes)(corners, 4, 2, nodes, 60, &filled))) {
        LOCAL(feed_nodes)(s, nodes, filled);
    }
    rule.radius = p[0];
    rule.rings = 4;
    rule.angles = 7;
    rule.rim_exponent = p[1] - 1;
    rule.tilt_x = p[2] / 2;
    rule.tilt_y = -p[3] / 2;
    if (ok(s, NAME(disk_nodes)(&rule, nodes, 60, &filled))) {
        LOCAL(feed_nodes)(s, nodes, filled);
    }
    if (ok(s, NAME(tripod_nodes)(corners, &corners[3], nodes))) {
        LOCAL(feed_nodes)(s, nodes, 3);
    }
}

static void LOCAL(feed_projection)(struct stream *s, tribos_status status, NAME(projection) p)
{
    if (ok(s, status)) {
        feed_bits(s, p.slides);
        LOCAL(feed_three)(s, p.wrench.x, p.wrench.y, p.wrench.torque);
        LOCAL(feed_three)(s, p.normal.x, p.normal.y, p.normal.spin);
    }
}

/* More than are converted at once. */
enum { LOCAL(BATCH) = 21 };

static void LOCAL(feed_projections)(
    struct stream *s, tribos_status status, const NAME(projection) *all)
{
    int i;

    if (ok(s, status)) {
        for (i = 0; i < LOCAL(BATCH); ++i) {
            LOCAL(feed_projection)(s, TRIBOS_STATUS_OK, all[i]);
        }
    }
}

static void LOCAL(batches)(struct stream *s, NAME(disk_surface) disk, REAL length, enum range range)
{
    REAL loads[LOCAL(BATCH)], gauges[LOCAL(BATCH)];
    NAME(wrench) pushes[LOCAL(BATCH)];
    NAME(twist) motions[LOCAL(BATCH)];
    NAME(projection) nearest[LOCAL(BATCH)];
    tribos_status status;
    int i;

    LOCAL(draws)(s, range, loads, LOCAL(BATCH));
    for (i = 0; i < LOCAL(BATCH); ++i) {
        pushes[i] = LOCAL(draw_wrench)(s, range);
    }
    if (ok(s, NAME(disk_surface_gauge_batch)(&disk, loads, pushes, LOCAL(BATCH), gauges))) {
        for (i = 0; i < LOCAL(BATCH); ++i) {
            feed_number(s, gauges[i]);
        }
    }
    if (ok(s, NAME(disk_surface_motion_batch)(&disk, pushes, LOCAL(BATCH), motions))) {
        for (i = 0; i < LOCAL(BATCH); ++i) {
            LOCAL(feed_three)(s, motions[i].x, motions[i].y, motions[i].spin);
        }
    }
    status = NAME(disk_surface_project_batch)(
        &disk, loads, pushes, LOCAL(BATCH), length, nearest);
    LOCAL(feed_projections)(s, status, nearest);
}

static void LOCAL(feed_step)(struct stream *s, tribos_status status, NAME(planar_step) step)
{
    if (ok(s, status)) {
        feed_bits(s, step.is_at_rest);
        LOCAL(feed_three)(s, step.twist.x, step.twist.y, step.twist.spin);
        LOCAL(feed_three)(s, step.friction.x, step.friction.y, step.friction.torque);
    }
}

static void LOCAL(planar_steps)(
    struct stream *s, NAME(disk_surface) disk, NAME(ellipsoid) usual, enum range range)
{
    REAL p[3];
    NAME(planar_body) body;
    NAME(planar_step) step = {{0, 0, 0}, {0, 0, 0}, 0};
    NAME(twist) twist, twists[LOCAL(BATCH)];
    NAME(wrench) push, pushes[LOCAL(BATCH)];
    NAME(planar_step) steps[LOCAL(BATCH)];
    REAL loads[LOCAL(BATCH)];
    tribos_status status;
    int i;

    LOCAL(draws)(s, FIT, p, 3);
    twist = LOCAL(draw_twist)(s, range);
    push = LOCAL(draw_wrench)(s, range);
    body.mass = p[0];
    body.inertia = p[1];
    status = NAME(planar_disk_step)(&body, &disk, &twist, &push, p[2], &step);
    LOCAL(feed_step)(s, status, step);
    status = NAME(planar_ellipsoid_step)(&body, &usual, &twist, &push, p[2], &step);
    LOCAL(feed_step)(s, status, step);
    for (i = 0; i < LOCAL(BATCH); ++i) {
        loads[i] = LOCAL(draw)(s, range);
        twists[i] = LOCAL(draw_twist)(s, range);
        pushes[i] = LOCAL(draw_wrench)(s, range);
    }
    status = NAME(planar_disk_step_batch)(
        &body, &disk, loads, twists, pushes, LOCAL(BATCH), p[2], steps);
    if (ok(s, status)) {
        for (i = 0; i < LOCAL(BATCH); ++i) {
            LOCAL(feed_step)(s, TRIBOS_STATUS_OK, steps[i]);
        }
    }
}

static void LOCAL(surfaces)(struct stream *s, enum range range)
{
    REAL p[4];
    NAME(disk_surface) disk;
    NAME(ellipsoid) usual;
    NAME(twist) twist;
    NAME(wrench) wrench;
    NAME(projection) nearest = {{0, 0, 0}, {0, 0, 0}, 0};
    tribos_status status;

    LOCAL(draws)(s, FIT, p, 4);
    twist = LOCAL(draw_twist)(s, range);
    wrench = LOCAL(draw_wrench)(s, range);
    disk.force_limit = p[0];
    disk.radius = p[1];
    usual.force_limit = p[0];
    usual.radius = p[1];
    usual.spin_torque = p[2];
    NUMBER(NAME(disk_surface_support)(&disk, &twist, &out));
    WRENCH(NAME(disk_surface_wrench)(&disk, &twist, &out));
    NUMBER(NAME(disk_surface_gauge)(&disk, &wrench, &out));
    TWIST(NAME(disk_surface_motion)(&disk, &wrench, &out));
    WRENCH(NAME(disk_surface_scale)(&disk, &wrench, &out));
    status = NAME(disk_surface_project)(&disk, &wrench, p[3], &nearest);
    LOCAL(feed_projection)(s, status, nearest);
    status = NAME(disk_surface_project)(&disk, &wrench, 0, &nearest);
    LOCAL(feed_projection)(s, status, nearest);
    NUMBER(NAME(ellipsoid_support)(&usual, &twist, &out));
    WRENCH(NAME(ellipsoid_wrench)(&usual, &twist, &out));
    NUMBER(NAME(ellipsoid_gauge)(&usual, &wrench, &out));
    TWIST(NAME(ellipsoid_motion)(&usual, &wrench, &out));
    WRENCH(NAME(ellipsoid_scale)(&usual, &wrench, &out));
    status = NAME(ellipsoid_project)(&usual, &wrench, p[3], &nearest);
    LOCAL(feed_projection)(s, status, nearest);
    LOCAL(batches)(s, disk, p[3], range);
    LOCAL(planar_steps)(s, disk, usual, range);
}

#include "digest_polygons.h"
#include "digest_shapes.h"
#include "digest_surfaces.h"

static void LOCAL(steps)(struct stream *s, enum range range)
{
    REAL p[4], x[2];
    NAME(slider) slider;
    NAME(motion) motion = {0, 0, 0, 0, 0};
    int n;

    LOCAL(draws)(s, FIT, p, 4);
    LOCAL(draws)(s, range, x, 2);
    slider.deceleration = p[0];
    slider.radius = p[1];
    slider.inertia_ratio = p[2];
    motion.speed = x[0];
    motion.spin = x[1];
    for (n = 0; n < 4; ++n) {
        if (ok(s, NAME(slider_verlet_step)(&slider, &motion, p[3] / 4))) {
            LOCAL(feed_motion)(s, motion);
        }
        NUMBER(NAME(slider_energy)(&slider, &motion, &out));
        NUMBER(NAME(slider_dissipation)(&slider, &motion, &out));
    }
}

static void LOCAL(ways)(struct stream *s, int to_rest)
{
    REAL p[4], x[2];
    NAME(slider) slider;
    NAME(motion) motion = {0, 0, 0, 0, 0};
    NAME(advance) next;
    NAME(rest) rest;

    LOCAL(draws)(s, SURE, p, 4);
    LOCAL(draws)(s, SURE, x, 2);
    slider.deceleration = p[0];
    slider.radius = p[1];
    slider.inertia_ratio = p[2];
    motion.speed = x[0];
    motion.spin = -x[1];
    if (ok(s, NAME(slider_advance)(&slider, &motion, p[3] / 64, &next))) {
        LOCAL(feed_motion)(s, next.motion);
        feed_number(s, next.ratio);
        feed_bits(s, next.came_to_rest);
        feed_bits(s, next.evaluations);
    }
    if (to_rest && ok(s, NAME(slider_to_rest)(&slider, &motion, &rest))) {
        LOCAL(feed_motion)(s, rest.motion);
        feed_number(s, rest.ratio);
        feed_bits(s, rest.evaluations);
    }
}

static void LOCAL(feed_sphere)(struct stream *s, NAME(sphere) body)
{
    LOCAL(feed_vector)(s, body.velocity);
    LOCAL(feed_vector)(s, body.spin);
}

static void LOCAL(feed_impulse)(struct stream *s, NAME(impulse) impulse)
{
    feed_number(s, impulse.normal);
    LOCAL(feed_vector)(s, impulse.sliding);
    LOCAL(feed_vector)(s, impulse.rolling);
    feed_number(s, impulse.torsion);
}

static void LOCAL(feed_contact)(struct stream *s, const NAME(contact) *c)
{
    LOCAL(feed_vector)(s, c->normal);
    LOCAL(feed_three)(s, c->arms[0], c->arms[1], c->lever);
    LOCAL(feed_three)(s, c->mass_normal, c->mass_sliding, c->inertia);
    LOCAL(feed_three)(s, c->coupling, c->cohesion, c->allowance);
    feed_bits(s, c->rests_open);
}

static void LOCAL(feed_touch)(struct stream *s, const NAME(touch) *t)
{
    LOCAL(feed_vector)(s, t->normal);
    feed_number(s, t->gap);
    LOCAL(feed_three)(s, t->arms[0], t->arms[1], t->lever);
}

/* One update of any kind, from the same initial state. */
#define SPHERES(call)                           \
    do {                                        \
        NAME(sphere) a = first, b = second;     \
        NAME(impulse) impulse = start;          \
        if (ok(s, call)) {                      \
            LOCAL(feed_impulse)(s, impulse);    \
            LOCAL(feed_sphere)(s, a);           \
            LOCAL(feed_sphere)(s, b);           \
        }                                       \
    } while (0)
#define PLATE(call)                             \
    do {                                        \
        NAME(sphere) a = first;                 \
        NAME(plate) b = floor;                  \
        NAME(impulse) impulse = start;          \
        if (ok(s, call)) {                      \
            LOCAL(feed_impulse)(s, impulse);    \
            LOCAL(feed_sphere)(s, a);           \
            LOCAL(feed_vector)(s, b.velocity);  \
        }                                       \
    } while (0)

static NAME(sphere) LOCAL(draw_sphere)(struct stream *s)
{
    NAME(sphere) body;

    body.velocity = LOCAL(draw_vector)(s, MILD);
    body.spin = LOCAL(draw_vector)(s, MILD);
    body.inv_mass = LOCAL(draw)(s, FIT);
    body.inv_inertia = LOCAL(draw)(s, FIT);
    return body;
}

static void LOCAL(contacts)(struct stream *s)
{
    REAL p[11];
    NAME(sphere) first, second;
    NAME(plate) floor;
    NAME(vector) displacement;
    NAME(vector) up = {0, 0, 1};
    NAME(normal_law) law;
    NAME(thresholds) mu;
    NAME(impulse) start;
    NAME(touch) touch;
    NAME(contact) contact;

    LOCAL(draws)(s, FIT, p, 11);
    first = LOCAL(draw_sphere)(s);
    second = LOCAL(draw_sphere)(s);
    displacement = LOCAL(draw_vector)(s, MILD);
    start.normal = LOCAL(draw)(s, MILD);
    start.sliding = LOCAL(draw_vector)(s, MILD);
    start.rolling = LOCAL(draw_vector)(s, MILD);
    start.torsion = LOCAL(draw)(s, MILD);
    floor.velocity = second.velocity;
    floor.inv_mass = p[10];
    law.cohesion = p[0];
    law.cohesion_range = p[1];
    law.attraction = draw_bits(s) >> 63;
    law.restitution = p[2] / 2;
    mu.sliding = p[3];
    mu.rolling = p[4];
    mu.torsion = p[5];
    if (ok(s, NAME(touch_spheres)(&displacement, p[6], p[7], &touch))) {
        LOCAL(feed_touch)(s, &touch);
        if (ok(s, NAME(contact_spheres)(&touch, &law, &first, &second, p[8], &contact))) {
            LOCAL(feed_contact)(s, &contact);
            SPHERES(NAME(update_frictionless_spheres)(&contact, &a, &b, &impulse));
            SPHERES(NAME(update_sliding_spheres)(&contact, &mu, &a, &b, &impulse));
            SPHERES(NAME(update_sliding_torsion_spheres)(&contact, &mu, &a, &b, &impulse));
            SPHERES(NAME(update_sliding_rolling_spheres)(&contact, &mu, &a, &b, &impulse));
            SPHERES(NAME(update_all_spheres)(&contact, &mu, &a, &b, &impulse));
            SPHERES(NAME(update_patch_spheres)(&contact, &mu, &a, &b, &impulse));
        }
    }
    if (ok(s, NAME(touch_plate)(p[9], &up, p[6], &touch))) {
        LOCAL(feed_touch)(s, &touch);
        if (ok(s, NAME(contact_plate)(&touch, &law, &first, &floor, p[8], &contact))) {
            LOCAL(feed_contact)(s, &contact);
            PLATE(NAME(update_frictionless_plate)(&contact, &a, &b, &impulse));
            PLATE(NAME(update_sliding_plate)(&contact, &mu, &a, &b, &impulse));
            PLATE(NAME(update_sliding_torsion_plate)(&contact, &mu, &a, &b, &impulse));
            PLATE(NAME(update_sliding_rolling_plate)(&contact, &mu, &a, &b, &impulse));
            PLATE(NAME(update_all_plate)(&contact, &mu, &a, &b, &impulse));
            PLATE(NAME(update_patch_plate)(&contact, &mu, &a, &b, &impulse));
        }
    }
}

static void LOCAL(all)(struct stream *s)
{
    int n;

    for (n = 0; n < 200; ++n) {
        LOCAL(simple_laws)(s);
        LOCAL(laws_with_state)(s);
        LOCAL(patches)(s);
        LOCAL(points)(s);
        LOCAL(surfaces)(s, n % 2 ? WIDE : MILD);
        LOCAL(other_surfaces)(s, n % 2 ? WIDE : MILD);
        LOCAL(steps)(s, n % 2 ? WIDE : MILD);
        LOCAL(contacts)(s);
    }
    LOCAL(tables)(s);
    for (n = 0; n < 40; ++n) {
        LOCAL(powers)(s);
        LOCAL(rules)(s);
        LOCAL(polygons)(s, n % 2 ? WIDE : MILD);
        LOCAL(shapes)(s, n % 2 ? WIDE : MILD);
        LOCAL(ways)(s, n % 8 == 0);
    }
}

#undef NUMBER
#undef WRENCH
#undef TWIST
#undef JACOBIAN
#undef SPHERES
#undef PLATE
