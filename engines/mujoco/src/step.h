// Friction of feet that move each other, in one implicit time step.
#ifndef TRIBOS_MUJOCO_STEP_H
#define TRIBOS_MUJOCO_STEP_H

#include <stdbool.h>
#include "patch.h"

// A foot's friction, or any other motion or wrench of it: along x, along y, about the normal.
typedef struct planar_foot {
    const patch *patch;
    double limit;            // mu x load, in N
    double velocity[3];      // relative to its ground, m/s and rad/s
    double acceleration[3];  // without friction of the feet
    double start[3];         // friction of the step before
    double friction[3];      // found: N, N, N m
    bool is_held;            // found: friction brings the foot to rest on its ground
    int index;               // among all feet that touch their grounds, for the caller

    // Its own compliance as a metric.
    double compliance[9];
    double inverse[9];
    bool has_inverse;
    double bound;        // of an isotropic metric above it: acceleration per force
    double length;       // which makes a force of a torque there
    double condition;    // root of the condition number of the compliance in that metric
    double midway[3];    // friction of the motion at half time
    double ended[3];     // friction of the motion at the end
} planar_foot;

// Finds friction such that each foot is at rest at the end of the step where the patches can carry that;
// otherwise friction opposes the motion at half time, or at the end where a foot turns about.
// `compliance` has a row-major 3 x 3 block for each pair of feet: the acceleration of the first by unit friction on
// the second.
void step_solve(planar_foot *feet, int count, const double *compliance, double dt);

#endif
