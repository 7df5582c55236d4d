// Friction of feet that move each other, in one implicit time step.
#ifndef TRIBOS_MUJOCO_STEP_H
#define TRIBOS_MUJOCO_STEP_H

#include <stdbool.h>
#include "set.h"

// A foot's friction, or any other motion or wrench of it: along x, along y, about the normal.
typedef struct planar_foot {
    const friction_set *set;
    double limit;            // mu x load, in N
    double static_limit;     // the same of a foot that was at rest in the step before, with the coefficient of rest
    double velocity[3];      // relative to its ground, m/s and rad/s
    double acceleration[3];  // without friction of the feet
    double start[3];         // friction of the step before
    double friction[3];      // found: N, N, N m
    bool is_held;            // found: friction brings the foot to rest on its ground
    bool is_missed;          // found: a search stopped at its count; friction is in its set and gives no power all the same
    int index;               // among all feet that touch their grounds, for the caller

    // Its own compliance as a metric.
    double compliance[9];
    double inverse[9];
    bool has_inverse;
    double bound;        // of an isotropic metric above it: acceleration per force
    double length;       // which makes a force of a torque there
    double error;        // bound of what the last search left of its own friction, in N
    bool is_cut;         // the last search for its own friction stopped at its count
    double condition;    // root of the condition number of the compliance in that metric
    double midway[3];    // friction of the motion at half time
    double ended[3];     // friction of the motion at the end

    // Of the search for friction that holds all feet. Accelerations are in units of each foot's limit.
    double unit[3];
    double left[3];    // acceleration that is left
    double force[3];   // friction along it: N, N, N m
    double moved[3];   // acceleration by that
    double along[3];   // direction of the search: N, N, N m
    double change[3];  // acceleration by it
    double enough[3];  // friction without forces between feet
} planar_foot;

// Finds friction such that each foot is at rest at the end of the step where the patches can carry that;
// otherwise friction opposes the motion at half time, or at the end where a foot turns about. Each foot's friction is in
// its set; while feet slide, friction gives no power to their mean motion, whatever the searches left. Feet that are at rest
// all together within their static limits stay so; beyond, the limits of sliding hold for all of them.
// `compliance` has a row-major 3 x 3 block for each pair of feet: the acceleration of the first by unit friction on
// the second.
void step_solve(planar_foot *feet, int count, const double *compliance, double dt);

#endif
