#include "step.h"

#include <float.h>
#include "vectors.h"

// Rounds in which friction follows a motion that it hardly changes, at most; the share of a round's change that the next may
// have; and the change at which they end, in units of the largest friction.
#define ROUNDS 8
#define SLOW 0.25
#define FOLLOWED 1e-9
// By how much friction must be exceeded to be exceeded beyond all rounding.
#define BEYOND 1.01
// Accuracy to which a foot is solved among others, as a share of what the last sweep has changed.
#define CLOSER 0.1
// Change of friction at which iterations end, in units of the largest friction: far below a time step's error.
#define TOLERANCE 1e-7
// Velocity that counts as none after sweeps, in units of what the largest friction changes in a step.
#define STILL 1e-6
// The same for friction that is found for all feet at once, which is accurate to rounding.
#define REST 1e-12
// The same for velocities of feet against each other, which friction does not change: a body that tilts on its contacts'
// springs moves feet of different heights.
#define GIVE 1e-3
// Forces that move the feet together by less than this share of what each would do to a foot alone are forces between
// feet: their heights differ by less than a hundredth of their distances.
#define BETWEEN 1e-4
// Sweeps over the feet, and steps on one foot within a sweep, at most.
#ifndef SWEEPS
#define SWEEPS 200
#endif
#define STEPS 500
// Share of the largest compliance that is added to all, such that a mechanism that lacks motions has an inverse.
#define FLOOR 1e-12
// Reversals of motions slower than this share of the foot's speed are rounding.
#define REVERSAL 1e-9
// Off-diagonal elements up to which the circles of Gershgorin bound the eigenvalues closely enough.
#define NEARLY_DIAGONAL 1e-2
// Bound of the rounding of eigenvalues from an angle, whose cosine is flat at both ends.
#define ROUNDING 1e-7
#define PI 3.14159265358979323846

static double norm2(double x, double y) { return sqrt(x * x + y * y); }

// Bounds of the eigenvalues of a symmetric matrix.
static void eigenvalues(const double m[9], double *least, double *most)
{
    const double xy = fabs(m[1]), xz = fabs(m[2]), yz = fabs(m[5]);
    if (xy + xz + yz > NEARLY_DIAGONAL) {
        // The roots of the characteristic polynomial by the angle of its trigonometric form.
        const double mean = (m[0] + m[4] + m[8]) / 3;
        const double x = m[0] - mean, y = m[4] - mean, z = m[8] - mean;
        const double size =
            sqrt((x * x + y * y + z * z + 2 * (xy * xy + xz * xz + yz * yz)) / 6);
        const double determinant =
            x * y * z + 2 * m[1] * m[2] * m[5] - x * yz * yz - y * xz * xz - z * xy * xy;
        const double cosine = determinant / (2 * size * size * size);
        const double angle = acos(fmin(fmax(cosine, -1), 1)) / 3;
        *most = mean + 2 * size * cos(angle) + ROUNDING * size;
        *least = mean + 2 * size * cos(angle + 2 * PI / 3) - ROUNDING * size;
        return;
    }
    *least = fmin(m[0] - xy - xz, fmin(m[4] - xy - yz, m[8] - xz - yz));
    *most = fmax(m[0] + xy + xz, fmax(m[4] + xy + yz, m[8] + xz + yz));
}

// The foot's own block of the compliance, and its inverse.
static void invert(planar_foot *foot, const double block[9])
{
    double *c = foot->compliance;
    memcpy(c, block, 9 * sizeof(double));
    const double arm_sq = foot->set->arm * foot->set->arm;
    const double floor = FLOOR * (c[0] + c[4] + c[8] * arm_sq);
    c[0] += floor;
    c[4] += floor;
    c[8] += floor / arm_sq;
    foot->has_inverse = inverse3(foot->inverse, c);
}

// The foot's own compliance as a metric.
static void measure(planar_foot *foot)
{
    const double *c = foot->compliance;
    // The largest compliance of forces in the plane, and the length with which that of torques is equal to it.
    const double largest = 0.5 * (c[0] + c[4]) + norm2(0.5 * (c[0] - c[4]), c[1]);
    foot->length = sqrt(largest / c[8]);
    const double scale[3] = {1, 1, foot->length};
    double scaled[9], least, most;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) scaled[3 * i + j] = c[3 * i + j] * scale[i] * scale[j] / largest;
    eigenvalues(scaled, &least, &most);
    foot->bound = largest * most;
    foot->condition = sqrt(most / fmax(least, DBL_EPSILON * most));
}

static void project(const planar_foot *foot, const double wrench[3], double nearest[3])
{
    foot->set->project(foot->set, foot->limit, wrench, foot->length, nearest);
}

static bool is_inside(const planar_foot *foot, const double wrench[3])
{
    double nearest[3];
    project(foot, wrench, nearest);
    return nearest[0] == wrench[0] && nearest[1] == wrench[1] && nearest[2] == wrench[2];
}

// The friction that would bring the foot to rest, from `start` where its motion is `slope`. False if it is
// surely too large.
static bool needed(const planar_foot *foot, const double start[3], const double slope[3],
                   double wrench[3])
{
    memcpy(wrench, start, 3 * sizeof(double));
    if (!foot->has_inverse) return false;
    double step[3];
    product3(step, foot->inverse, slope);
    add_scaled3(wrench, step, -1);
    const double most = BEYOND * foot->limit;
    return norm2(wrench[0], wrench[1]) <= most && fabs(wrench[2]) <= most * foot->set->arm;
}

// The friction that leaves the least energy, to an `accuracy` in N, from `at` where the motion is `slope`; true if it
// brings the foot to rest.
static bool minimise(planar_foot *foot, double at[3], const double slope[3], double accuracy)
{
    double rest[3];
    foot->is_cut = false;
    foot->error = 0;
    if (needed(foot, at, slope, rest) && is_inside(foot, rest)) {
        memcpy(at, rest, sizeof rest);
        return true;
    }
    // Gradient steps in the isotropic metric, each brought back to the set, with the momentum of Nesterov (2004,
    // section 2.2) for the known condition, which is dropped where it leads uphill.
    const double rates[3] = {1 / foot->bound, 1 / foot->bound,
                             foot->length * foot->length / foot->bound};
    const double momentum = (foot->condition - 1) / (foot->condition + 1);
    // Distance from the solution in units of the last step.
    const double left = fmin(foot->condition, foot->condition * foot->condition - 1);
    const double start[3] = {at[0], at[1], at[2]};
    double ahead[3] = {at[0], at[1], at[2]};
    for (int step = 0; step < STEPS; step++) {
        double change[3], motion[3] = {slope[0], slope[1], slope[2]}, next[3];
        subtract3(change, ahead, start);
        add_product3(motion, foot->compliance, change);
        for (int i = 0; i < 3; i++) next[i] = ahead[i] - motion[i] * rates[i];
        project(foot, next, next);
        subtract3(change, next, at);
        double uphill = 0;
        for (int i = 0; i < 3; i++) uphill += (ahead[i] - next[i]) * change[i] / rates[i];
        memcpy(at, next, sizeof next);
        memcpy(ahead, next, sizeof next);
        if (!(uphill > 0)) add_scaled3(ahead, change, momentum);
        const double moved = fmax(norm2(change[0], change[1]), fabs(change[2]) / foot->length);
        foot->error = left * moved;
        if (!(foot->error > accuracy)) return false;
    }
    foot->is_cut = true;
    return false;
}

// sum += the acceleration of a foot by the friction of all.
static void add_response(const planar_foot *feet, int count, const double *compliance, int foot,
                         double sum[3])
{
    const double *row = compliance + 9 * count * foot;
    for (int j = 0; j < count; j++) add_product3(sum, row + 9 * j, feet[j].friction);
}

// The acceleration that friction must take from a foot for rest after the time 1/inv_time, with what
// friction of all takes now.
static void slope_of(const planar_foot *feet, int count, const double *compliance, double inv_time,
                     int foot, double slope[3])
{
    memcpy(slope, feet[foot].acceleration, 3 * sizeof(double));
    add_scaled3(slope, feet[foot].velocity, inv_time);
    add_response(feet, count, compliance, foot, slope);
}

// The velocity of a foot at the end of the step.
static void velocity_after(const planar_foot *feet, int count, const double *compliance, double dt,
                           int foot, double after[3])
{
    double change[3];
    memcpy(change, feet[foot].acceleration, sizeof change);
    add_response(feet, count, compliance, foot, change);
    memcpy(after, feet[foot].velocity, 3 * sizeof(double));
    add_scaled3(after, change, dt);
}

// Marks the feet that are at rest at the end, to a share of what the largest friction changes in a step. True if all are.
static bool mark_held(planar_foot *feet, int count, const double *compliance, double dt, double share)
{
    bool all = true;
    for (int i = 0; i < count; i++) {
        double after[3];
        velocity_after(feet, count, compliance, dt, i, after);
        const double none = share * feet[i].bound * feet[i].limit * dt;
        feet[i].is_held = norm2(after[0], after[1]) <= none && fabs(after[2]) * feet[i].set->arm <= none;
        all = all && feet[i].is_held;
    }
    return all;
}

// Friction of all feet with the least energy, in sweeps from that of the step before. True if the last sweep left
// all of them held. No foot is solved much closer than the sweep before has changed the others.
static bool minimise_all(planar_foot *feet, int count, const double *compliance, double inv_time)
{
    double limit = 0;
    for (int i = 0; i < count; i++) {
        memcpy(feet[i].friction, feet[i].start, sizeof feet[i].friction);
        limit = fmax(limit, feet[i].limit);
    }
    const double tolerance = TOLERANCE * limit;
    double accuracy = count == 1 ? tolerance : limit;
    bool is_held = true, is_met = false;
    for (int sweep = 0; sweep < SWEEPS && !is_met; sweep++) {
        double change = 0, error = 0;
        is_held = true;
        for (int i = 0; i < count; i++) {
            planar_foot *foot = feet + i;
            double slope[3], before[3], moved[3];
            memcpy(before, foot->friction, sizeof before);
            slope_of(feet, count, compliance, inv_time, i, slope);
            foot->is_held = minimise(foot, foot->friction, slope, accuracy);
            error = fmax(error, foot->error);
            is_held = is_held && foot->is_held;
            subtract3(moved, foot->friction, before);
            change = fmax(change, norm2(moved[0], moved[1]));
            change = fmax(change, fabs(moved[2]) / foot->set->arm);
        }
        is_met = count == 1 || !(fmax(change, error) > tolerance);
        accuracy = fmax(CLOSER * change, tolerance);
    }
    for (int i = 0; i < count; i++) feet[i].is_missed = feet[i].is_missed || feet[i].is_cut || !is_met;
    return is_held;
}

// What friction along the acceleration that is left would change of it, all in units of each foot's limit. Returns the
// power of that; `alone`, the power if no foot moved another.
static double respond(planar_foot *feet, int count, const double *compliance, double *alone)
{
    double power = 0;
    *alone = 0;
    for (int i = 0; i < count; i++)
        for (int k = 0; k < 3; k++) feet[i].force[k] = feet[i].unit[k] * feet[i].left[k];
    for (int i = 0; i < count; i++) {
        double sum[3] = {0, 0, 0}, own[3];
        for (int j = 0; j < count; j++) add_product3(sum, compliance + 9 * (count * i + j), feet[j].force);
        product3(own, feet[i].compliance, feet[i].force);
        power += dot3(sum, feet[i].force);
        *alone += dot3(own, feet[i].force);
        for (int k = 0; k < 3; k++) feet[i].moved[k] = feet[i].unit[k] * sum[k];
    }
    return power;
}

// Whether what is left is rest: each foot's velocity is none but for the give of contacts, and friction would change none
// of it, to this share of what the largest friction does.
static bool is_rest(const planar_foot *feet, int count, double share)
{
    for (int i = 0; i < count; i++) {
        const planar_foot *foot = feet + i;
        const double *u = foot->unit, full = foot->bound * foot->limit;
        const double left = fmax(norm2(foot->left[0], foot->left[1]), fabs(foot->left[2])) / u[0];
        const double moved = fmax(norm2(foot->moved[0], foot->moved[1]), fabs(foot->moved[2])) / (u[0] * u[0]);
        if (!(left <= GIVE * full && moved <= share * full * full)) return false;
    }
    return true;
}

static bool all_inside(const planar_foot *feet, int count)
{
    for (int i = 0; i < count; i++)
        if (!is_inside(feet + i, feet[i].friction)) return false;
    return true;
}

// Friction that brings several feet to rest at the end of the step, if they can carry it. Of the many that do where
// feet belong to one body, it is the one with the least sum of squares in units of each foot's limit: forces between
// feet, which nothing determines, are none and do not wander. Conjugate residuals from no friction (Stiefel, Comment.
// Math. Helv. 29 (1955) 157) meet such forces last; what they leave is judged at each step. Where feet cannot carry
// them, friction without them is enough. From the friction of the step before it is the least change instead.
static bool hold_together(planar_foot *feet, int count, const double *compliance, double dt, bool from_start)
{
    for (int i = 0; i < count; i++)
        for (int k = 0; k < 3; k++) feet[i].friction[k] = from_start ? feet[i].start[k] : 0;
    for (int i = 0; i < count; i++) {
        planar_foot *foot = feet + i;
        double slope[3];
        slope_of(feet, count, compliance, 1 / dt, i, slope);
        foot->is_held = true;
        for (int k = 0; k < 3; k++) {
            foot->unit[k] = k == 2 ? foot->limit * foot->set->arm : foot->limit;
            foot->left[k] = -foot->unit[k] * slope[k];
            foot->along[k] = foot->change[k] = 0;
        }
    }
    double before = INFINITY;
    bool has_enough = false;
    // As many steps as unknowns are exact but for rounding.
    for (int step = 0; step <= 6 * count; step++) {
        double alone, square = 0;
        const double power = respond(feet, count, compliance, &alone);
        if (is_rest(feet, count, REST)) {
            if (all_inside(feet, count)) return true;
            break;
        }
        if (!has_enough && power <= BETWEEN * alone && is_rest(feet, count, STILL)) {
            has_enough = true;
            for (int i = 0; i < count; i++) memcpy(feet[i].enough, feet[i].friction, sizeof feet[i].enough);
        }
        for (int i = 0; i < count; i++) {
            planar_foot *foot = feet + i;
            for (int k = 0; k < 3; k++) {
                foot->along[k] = foot->force[k] + power / before * foot->along[k];
                foot->change[k] = foot->moved[k] + power / before * foot->change[k];
            }
            square += dot3(foot->change, foot->change);
        }
        if (!(power > 0 && square > 0)) break;
        for (int i = 0; i < count; i++) {
            add_scaled3(feet[i].friction, feet[i].along, power / square);
            add_scaled3(feet[i].left, feet[i].change, -power / square);
        }
        before = power;
    }
    if (!has_enough) return false;
    for (int i = 0; i < count; i++) memcpy(feet[i].friction, feet[i].enough, sizeof feet[i].friction);
    return all_inside(feet, count);
}

// True if surely no foot comes to rest within the step.
static bool is_beyond(planar_foot *feet, int count, const double *compliance, double dt)
{
    if (count == 1) {
        double rate[3], wrench[3];
        memcpy(rate, feet->acceleration, sizeof rate);
        add_scaled3(rate, feet->velocity, 1 / dt);
        const double zero[3] = {0, 0, 0};
        return feet->has_inverse && !needed(feet, zero, rate, wrench);
    }
    // More acceleration of each foot than all of them can give it.
    for (int i = 0; i < count; i++) {
        double most = 0, rate[2];
        for (int j = 0; j < count; j++) {
            const double *c = compliance + 9 * (count * i + j);
            const double arm = feet[j].set->arm, force_sq = c[0] * c[0] + c[1] * c[1] + c[3] * c[3] + c[4] * c[4];
            // The sum of two lengths is at most the root of twice the sum of their squares.
            most += sqrt(2 * (force_sq + arm * arm * (c[2] * c[2] + c[5] * c[5]))) * feet[j].limit;
        }
        for (int k = 0; k < 2; k++) rate[k] = feet[i].acceleration[k] + feet[i].velocity[k] / dt;
        if (!(norm2(rate[0], rate[1]) > BEYOND * most)) return false;
    }
    return true;
}

// True if a foot's velocity or spin has another sense at the end.
static bool turns_about(const planar_foot *feet, int count, const double *compliance, double dt)
{
    for (int i = 0; i < count; i++) {
        const double *u = feet[i].velocity, arm_sq = feet[i].set->arm * feet[i].set->arm;
        double v[3];
        velocity_after(feet, count, compliance, dt, i, v);
        const double speed_sq = u[0] * u[0] + u[1] * u[1] + arm_sq * u[2] * u[2];
        const double least = -REVERSAL * REVERSAL * speed_sq;
        if (u[0] * v[0] + u[1] * v[1] < least || arm_sq * u[2] * v[2] < least) return true;
    }
    return false;
}

// Power that friction would give to the feet's mean motion; `own`, the part of it that grows with its square.
static double power(const planar_foot *feet, int count, const double *compliance, double dt, double *own)
{
    double sum = 0;
    *own = 0;
    for (int i = 0; i < count; i++) {
        double motion[3], response[3] = {0, 0, 0};
        velocity_after(feet, count, compliance, dt, i, motion);
        add_scaled3(motion, feet[i].velocity, 1);
        sum += dot3(motion, feet[i].friction);
        add_response(feet, count, compliance, i, response);
        *own += dt * dot3(response, feet[i].friction);
    }
    return sum;
}

// Less friction, along itself, where a search that stopped at its count would have it give power.
static void give_no_power(planar_foot *feet, int count, const double *compliance, double dt)
{
    double own;
    const double all = power(feet, count, compliance, dt, &own);
    if (!(all > 0)) return;
    const double share = own > 0 ? fmax(1 - all / own, 0) : 0;
    for (int i = 0; i < count; i++)
        for (int k = 0; k < 3; k++) feet[i].friction[k] *= share;
}

// Friction that opposes the motion at half time, where feet slide so fast that it changes this motion little: each round
// takes the friction that opposes the motion of the round before. False where rounds do not close in quickly, or a foot
// turns about.
static bool follow(planar_foot *feet, int count, const double *compliance, double dt)
{
    double limit = 0, before = 0;
    for (int i = 0; i < count; i++) {
        memcpy(feet[i].friction, feet[i].start, sizeof feet[i].friction);
        limit = fmax(limit, feet[i].limit);
    }
    for (int round = 0; round < ROUNDS; round++) {
        double change = 0;
        for (int i = 0; i < count; i++) {
            planar_foot *foot = feet + i;
            double motion[3], moved[3], rate[3];
            memcpy(rate, foot->acceleration, sizeof rate);
            add_response(feet, count, compliance, i, rate);
            memcpy(motion, foot->velocity, sizeof motion);
            add_scaled3(motion, rate, 0.5 * dt);
            memcpy(moved, foot->friction, sizeof moved);
            foot->set->oppose(foot->set, foot->limit, motion, foot->friction);
            subtract3(moved, foot->friction, moved);
            const double share = norm2(moved[0], moved[1]) + fabs(moved[2]) / foot->set->arm;
            change = share > change || isnan(share) ? share : change;
        }
        // What the next round would change, if each changes the same share of what the one before did; the first may change
        // what motions do not feel.
        const double next = round > 1 ? change * change / before : change;
        if (fmin(change, next) <= FOLLOWED * limit) return !turns_about(feet, count, compliance, dt);
        if (!(round == 0 || change <= SLOW * before)) return false;
        before = change;
    }
    return false;
}

// Friction where not all feet come to rest at the end of the step.
static void slide(planar_foot *feet, int count, const double *compliance, double dt, bool is_ended)
{
    // Friction of the motion at half time.
    minimise_all(feet, count, compliance, 2 / dt);
    if (!turns_about(feet, count, compliance, dt)) return;
    // A motion that would turn about takes the friction of its end, unless that gives power.
    for (int i = 0; i < count; i++) memcpy(feet[i].midway, feet[i].friction, sizeof feet[i].midway);
    if (is_ended)
        for (int i = 0; i < count; i++) memcpy(feet[i].friction, feet[i].ended, sizeof feet[i].ended);
    else
        minimise_all(feet, count, compliance, 1 / dt);
    double own;
    if (power(feet, count, compliance, dt, &own) > 0)
        for (int i = 0; i < count; i++) memcpy(feet[i].friction, feet[i].midway, sizeof feet[i].friction);
}

// Brings all feet to rest at the end of the step, if their patches carry that.
static bool hold(planar_foot *feet, int count, const double *compliance, double dt)
{
    for (int from_start = 0; from_start < 2; from_start++)
        if (count > 1 && hold_together(feet, count, compliance, dt, from_start)) return true;
    // A foot alone was held exactly; of several the last sweep moves those before.
    return minimise_all(feet, count, compliance, 1 / dt) &&
           (count == 1 || mark_held(feet, count, compliance, dt, STILL));
}

static void prepare(planar_foot *feet, int count, const double *compliance)
{
    for (int i = 0; i < count; i++) {
        invert(feet + i, compliance + 9 * (count * i + i));
        measure(feet + i);
    }
}

static void exchange_limits(planar_foot *feet, int count)
{
    for (int i = 0; i < count; i++) {
        const double limit = feet[i].limit;
        feet[i].limit = feet[i].static_limit;
        feet[i].static_limit = limit;
    }
}

// Holds feet that were at rest within their static limits.
static bool stay(planar_foot *feet, int count, const double *compliance, double dt)
{
    bool has_more = false;
    for (int i = 0; i < count; i++) has_more = has_more || feet[i].static_limit > feet[i].limit;
    if (!has_more) return false;
    prepare(feet, count, compliance);
    exchange_limits(feet, count);
    const bool stays = !is_beyond(feet, count, compliance, dt) && hold(feet, count, compliance, dt);
    exchange_limits(feet, count);
    for (int i = 0; !stays && i < count; i++) feet[i].is_held = feet[i].is_missed = false;
    return stays;
}

void step_solve(planar_foot *feet, int count, const double *compliance, double dt)
{
    for (int i = 0; i < count; i++) feet[i].is_held = feet[i].is_missed = false;
    if (stay(feet, count, compliance, dt)) return;
    if (count == 1) invert(feet, compliance);
    const bool is_sliding = is_beyond(feet, count, compliance, dt);
    if (is_sliding && follow(feet, count, compliance, dt)) return;
    prepare(feet, count, compliance);

    // Rest at the end of the step.
    if (!is_sliding) {
        if (hold(feet, count, compliance, dt)) return;
        for (int i = 0; i < count; i++) memcpy(feet[i].ended, feet[i].friction, sizeof feet[i].ended);
    }
    slide(feet, count, compliance, dt, !is_sliding);
    give_no_power(feet, count, compliance, dt);
    // A foot may be at rest at half time alone, where it turns about.
    mark_held(feet, count, compliance, dt, STILL);
}
