// Judges the step of feet: by the kernel's step of one body, and by the conditions that friction has to meet.
// Prints the largest deviations.

#include "patch.h"
#include "step.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "vectors.h"

#define CASES 20000
#define FEET 4
#define DT 1e-2  // s

static uint64_t state = 1;

// Uniform between -1 and 1.
static double drawn(void)
{
    state = state * 6364136223846793005u + 1442695040888963407u;
    return (double)(int64_t)(state ^ (state >> 31)) / 9223372036854775808.0;
}

static double most(double a, double b) { return a > b || isnan(a) ? a : b; }

static patch read(const char *kind, const char *size)
{
    patch made;
    char why[200];
    if (!patch_read(&made, kind, size, "", why, sizeof why)) {
        fprintf(stderr, "%s\n", why);
        exit(1);
    }
    return made;
}

// Velocities and pushes from those that hold to those that slide far, in units of what friction does in a step.
static void draw_motion(planar_foot *foot, const double per_force[3])
{
    const double units[3] = {per_force[0], per_force[1], per_force[2] * foot->set->arm};
    const double speed = pow(10, 1.5 * drawn()), push = pow(10, 1.5 * drawn() - 0.5);
    for (int k = 0; k < 3; k++) {
        foot->velocity[k] = drawn() * speed * foot->limit * units[k] * DT;
        foot->acceleration[k] = drawn() * push * foot->limit * units[k];
        foot->start[k] = 0;
    }
}

// One body on a disk: friction and rest are those of the kernel's step.
static void beside_the_kernel(double *worst, int *held, int *others)
{
    patch disk = read("disk", "0.05");
    for (int i = 0; i < CASES; i++) {
        const tribos_planar_body_f64 body = {pow(10, drawn()), 1e-3 * pow(10, drawn())};
        const double per_force[3] = {1 / body.mass, 1 / body.mass, 1 / body.inertia};
        const double compliance[9] = {per_force[0], 0, 0, 0, per_force[1], 0, 0, 0, per_force[2]};
        planar_foot foot = {.set = &disk.set, .limit = pow(10, drawn())};
        draw_motion(&foot, per_force);
        step_solve(&foot, 1, compliance, DT);

        const tribos_disk_surface_f64 surface = {foot.limit, disk.radius};
        const tribos_twist_f64 twist = {foot.velocity[0], foot.velocity[1], foot.velocity[2]};
        const tribos_wrench_f64 push = {foot.acceleration[0] * body.mass, foot.acceleration[1] * body.mass,
                                        foot.acceleration[2] * body.inertia};
        tribos_planar_step_f64 step;
        if (tribos_planar_disk_step_f64(&body, &surface, &twist, &push, DT, &step) != TRIBOS_STATUS_OK)
            exit(1);
        *held += foot.is_held;
        *others += foot.is_held != (bool)step.is_at_rest;
        const double error[3] = {foot.friction[0] - step.friction.x, foot.friction[1] - step.friction.y,
                                 (foot.friction[2] - step.friction.torque) / disk.set.arm};
        *worst = most(sqrt(dot3(error, error)) / foot.limit, *worst);
    }
    patch_free(&disk);
}

// A symmetric positive matrix whose axes are far from those of the patch.
static void draw_compliance(double compliance[9], double arm)
{
    double root[9];
    const double units[3] = {1, 1, 1 / arm};
    for (int k = 0; k < 9; k++) root[k] = drawn() * units[k / 3];
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            compliance[3 * i + j] = dot3(root + 3 * i, root + 3 * j) + (i == j ? 0.02 * units[i] * units[i] : 0);
}

// By how much friction is not the one that opposes the motion after the time 1/inv_time: the nearest wrench to it plus
// some of that motion would be itself.
static double residual(const planar_foot *foot, const double compliance[9], double inv_time)
{
    double motion[3], moved[3], nearest[3];
    memcpy(motion, foot->acceleration, sizeof motion);
    add_scaled3(motion, foot->velocity, inv_time);
    add_product3(motion, compliance, foot->friction);
    const double arm = foot->set->arm, rate = 1 / (compliance[0] + compliance[4] + compliance[8] * arm * arm);
    for (int k = 0; k < 3; k++)
        moved[k] = foot->friction[k] - rate * motion[k] * (k == 2 ? arm * arm : 1);
    foot->set->project(foot->set, foot->limit, moved, arm, nearest);
    subtract3(moved, nearest, foot->friction);
    moved[2] /= arm;
    return sqrt(dot3(moved, moved)) / foot->limit;
}

// One foot of any mechanism: friction opposes the motion at half time or at the end, and rest is rest at the end.
static void by_its_conditions(double *worst, int *held)
{
    patch patches[2] = {read("disk", "0.05"), read("box", "0.05 0.02")};
    for (int i = 0; i < CASES; i++) {
        planar_foot foot = {.set = &patches[i % 2].set, .limit = pow(10, drawn())};
        double compliance[9];
        draw_compliance(compliance, foot.set->arm);
        const double per_force[3] = {1, 1, 1 / (foot.set->arm * foot.set->arm)};
        draw_motion(&foot, per_force);
        step_solve(&foot, 1, compliance, DT);
        const double at_end = residual(&foot, compliance, 1 / DT), midway = residual(&foot, compliance, 2 / DT);
        *worst = most(foot.is_held ? at_end : fmin(at_end, midway), *worst);
        *held += foot.is_held;
    }
    patch_free(patches + 1);
}

// Four feet of a rigid body that they can hold: it comes to rest, and a friction that holds it already is not
// changed.
static void together(double *left, double *changed, int *held)
{
    patch disk = read("disk", "0.02");
    for (int i = 0; i < CASES / 20; i++) {
        planar_foot feet[FEET];
        double compliance[9 * FEET * FEET], root[FEET][9];
        const double inv_mass = pow(10, drawn()), inv_inertia = 10 * inv_mass;
        for (int f = 0; f < FEET; f++) {
            const double x = drawn(), y = drawn(), a = sqrt(inv_mass), b = sqrt(inv_inertia);
            const double row[9] = {a, 0, -y * b, 0, a, x * b, 0, 0, b};
            memcpy(root[f], row, sizeof row);
        }
        for (int f = 0; f < FEET; f++)
            for (int g = 0; g < FEET; g++)
                for (int k = 0; k < 9; k++)
                    compliance[9 * (FEET * f + g) + k] = dot3(root[f] + 3 * (k / 3), root[g] + 3 * (k % 3));
        const double body[3] = {0.3 * drawn(), 0.3 * drawn(), 0.1 * drawn()};
        for (int f = 0; f < FEET; f++) {
            feet[f] = (planar_foot){.set = &disk.set, .limit = 2 + drawn()};
            for (int k = 0; k < 3; k++) {
                feet[f].acceleration[k] = dot3(root[f] + 3 * k, body);
                feet[f].velocity[k] = 0.3 * DT * feet[f].acceleration[k];
            }
        }
        step_solve(feet, FEET, compliance, DT);
        bool all_held = true;
        double here = 0;
        for (int f = 0; f < FEET; f++) {
            all_held = all_held && feet[f].is_held;
            double motion[3];
            memcpy(motion, feet[f].acceleration, sizeof motion);
            add_scaled3(motion, feet[f].velocity, 1 / DT);
            for (int g = 0; g < FEET; g++) add_product3(motion, compliance + 9 * (FEET * f + g), feet[g].friction);
            for (int k = 0; k < 2; k++) here = most(fabs(motion[k]) / inv_mass, here);
        }
        if (!all_held) continue;
        *held += 1;
        *left = most(here, *left);
        // Again from this friction, with the same motion.
        for (int f = 0; f < FEET; f++) memcpy(feet[f].start, feet[f].friction, sizeof feet[f].start);
        step_solve(feet, FEET, compliance, DT);
        for (int f = 0; f < FEET; f++)
            for (int k = 0; k < 2; k++)
                *changed = most(fabs(feet[f].friction[k] - feet[f].start[k]), *changed);
    }
}

// Four feet at other heights of a body that slides and tilts: searches stop at their counts, friction is in its sets and
// gives no power to the mean motion all the same; where they do not, it opposes the motion of each foot at half time or at
// the end. Outside and power are in units of what the limits would do. With a `speed` in units of what the pushes do in a
// step the body moves as one along them.
static void sliding(double speed, double *outside, double *given, double *opposed, int *missed, int *found)
{
    patch disk = read("disk", "0.02");
    for (int i = 0; i < CASES / 20; i++) {
        planar_foot feet[FEET];
        double compliance[9 * FEET * FEET], root[FEET][15], body[5];
        for (int k = 0; k < 5; k++) body[k] = 10 * pow(10, drawn()) * drawn();
        for (int f = 0; f < FEET; f++) {
            const double x = drawn(), y = drawn(), height = pow(10, drawn() - 3) * drawn(), b = sqrt(10), c = 30 * height;
            const double row[15] = {1, 0, -y * b, 0, c, 0, 1, x * b, -c, 0, 0, 0, b, 0, 0};
            memcpy(root[f], row, sizeof row);
            feet[f] = (planar_foot){.set = &disk.set, .limit = 2 + drawn()};
            for (int k = 0; k < 3; k++) {
                for (int j = 0; j < 5; j++) feet[f].acceleration[k] += row[5 * k + j] * body[j];
                feet[f].velocity[k] = DT * (speed > 0 ? speed : drawn()) * feet[f].acceleration[k];
                feet[f].start[k] = 0.7 * drawn() * feet[f].limit * (k == 2 ? disk.set.arm : 1);
            }
            disk.set.project(&disk.set, feet[f].limit, feet[f].start, disk.set.arm, feet[f].start);
        }
        for (int f = 0; f < FEET; f++)
            for (int g = 0; g < FEET; g++)
                for (int k = 0; k < 9; k++) {
                    const double *a = root[f] + 5 * (k / 3), *b = root[g] + 5 * (k % 3);
                    compliance[9 * (FEET * f + g) + k] = dot3(a, b) + a[3] * b[3] + a[4] * b[4];
                }
        step_solve(feet, FEET, compliance, DT);
        double power = 0, full = 0, apart[2] = {0, 0};
        bool is_found = !feet[0].is_missed;
        for (int f = 0; f < FEET; f++) {
            double motion[3], nearest[3];
            planar_foot among = feet[f];
            for (int g = 0; g < FEET; g++)
                if (g != f) add_product3(among.acceleration, compliance + 9 * (FEET * f + g), feet[g].friction);
            for (int half = 0; half < 2; half++)
                apart[half] = most(residual(&among, compliance + 9 * (FEET * f + f), (1 + half) / DT), apart[half]);
            is_found = is_found && !feet[f].is_held;
            memcpy(motion, feet[f].acceleration, sizeof motion);
            for (int g = 0; g < FEET; g++) add_product3(motion, compliance + 9 * (FEET * f + g), feet[g].friction);
            for (int k = 0; k < 3; k++) motion[k] = 2 * feet[f].velocity[k] + DT * motion[k];
            power += dot3(motion, feet[f].friction);
            full += feet[f].limit * (fabs(motion[0]) + fabs(motion[1]) + disk.set.arm * fabs(motion[2]));
            disk.set.project(&disk.set, feet[f].limit, feet[f].friction, disk.set.arm, nearest);
            subtract3(nearest, nearest, feet[f].friction);
            nearest[2] /= disk.set.arm;
            *outside = most(sqrt(dot3(nearest, nearest)) / feet[f].limit, *outside);
        }
        *given = most(power / full, *given);
        *missed += feet[0].is_missed;
        if (is_found) *opposed = most(fmin(apart[0], apart[1]), *opposed);
        *found += is_found;
    }
    patch_free(&disk);
}

int main(void)
{
    double kernel = 0, conditions = 0, left = 0, changed = 0, outside = 0, given = -1, opposed = 0;
    double followed = 0;
    int held = 0, others = 0, held_alone = 0, held_together = 0, missed = 0, found = 0, fast_missed = 0, fast = 0;
    sliding(0, &outside, &given, &opposed, &missed, &found);
    sliding(100, &outside, &given, &followed, &fast_missed, &fast);
    beside_the_kernel(&kernel, &held, &others);
    by_its_conditions(&conditions, &held_alone);
    together(&left, &changed, &held_together);
    printf("kernel %g\nheld %d\nothers %d\nconditions %g\nheld_alone %d\nleft %g\nchanged %g\nheld_together %d\n", kernel,
           held, others, conditions, held_alone, left, changed, held_together);
    printf("followed %g\nfast %d\nfast_missed %d\n", followed, fast, fast_missed);
    printf("outside %g\ngiven %g\nopposed %g\nmissed %d\nfound %d\n", outside, given, opposed, missed, found);
    return 0;
}
