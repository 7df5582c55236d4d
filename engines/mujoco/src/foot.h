// A foot: geoms of one body that stand on a ground, where their patch lies and what moves it.
#ifndef TRIBOS_MUJOCO_FOOT_H
#define TRIBOS_MUJOCO_FOOT_H

#include <stdbool.h>
#include "set.h"
#include "view.h"

// What a foot remembers from step to step. The plugin has it in MuJoCo's `plugin_state`: it is saved, copied and reset
// with the simulation. Vectors are in the frame of the world.
enum {
    STATE_LOAD = 0,          // sum of its normal forces in the last step, N
    STATE_FORCE = 1,         // friction on it in the last step, N, 3 numbers
    STATE_TORQUE = 4,        // friction's torque about its normal, N m
    STATE_HELD = 5,          // 1 if friction held it, else 0
    STATE_ACCELERATION = 6,  // of its centre without friction of the feet, m/s^2, 3 numbers
    STATE_TURNING = 9,       // angular acceleration about its normal without that friction, rad/s^2
    STATE_SLIP = 10,         // of its centre on its ground since friction holds it: m along the patch's x and y, rad
    STATE_MISSED = 13,       // steps so far in which a search for its friction stopped at its count
    STATE_RESTED = 14,       // time for which friction has held it, s
    STATE_SIZE = 15
};

typedef enum frame_kind { FRAME_GEOM, FRAME_BODY, FRAME_SITE } frame_kind;

// A degree of freedom that moves a foot or its ground.
typedef struct freedom {
    int index;
    int root;     // root body of its tree
    double sign;  // 1 for the foot, -1 for the ground
} freedom;

// Motions of a foot, relative to its ground, are those of its patch's centre in the patch's axes.
enum { ALONG_X, ALONG_Y, SPIN, LIFT, TILT_X, TILT_Y, MOTIONS };

typedef struct foot {
    // From the model.
    int instance;  // of the plugin
    int state;     // address among the states
    int *geoms, geom_count;
    int *grounds, ground_count;
    int bodies[2];  // of the foot, of the ground
    bool moves[2];  // false if the body is fixed to the world
    bool is_afloat; // its body has all six motions by a joint of its own
    bool is_straight; // that joint alone, on a ground that is fixed: where no velocity changes its origin goes straight
    frame_kind frame;
    int frame_index;
    double mu;
    double mu_s;            // of a foot at rest, up to the time `ageing_t0`; less than mu counts as mu
    double ageing_b, ageing_t0;  // it grows by b for each e-fold of its time at rest in units of t0, s
    const friction_set *set;
    freedom *freedoms;
    int freedom_count;

    // Of this step.
    bool is_asleep;         // MuJoCo leaves its contacts out
    int first;              // of its contacts, -1 without
    int contact_count;
    bool is_conveyed;       // the surface of its ground moves on its body
    double normal_sum[3];   // of the contacts' normals, from the ground to the foot
    double position_sum[3];
    double axes[9];         // the patch's x, y and normal in the rows
    double centre[3];
    double *jacobian;       // a row of MOTIONS numbers for each of its freedoms
    // By unit velocities of foot and ground along the axes of the world and about those of the inertia, if they move
    // freely: [motion][velocity].
    double rows[2][36];
    double stiffness[9];    // of its contacts in lift and tilts
    double motion[MOTIONS]; // by the degrees of freedom
    double surface[3];      // motion of a conveyor's surface, along x, along y, about the normal
    double velocity[3];     // mean over the step, relative to the surface, if no velocity changes
    double friction[3];     // on the foot
    double response[3];     // its acceleration by the friction of all feet
    bool is_held, is_missed;
} foot;

// MuJoCo's joints, by its numbers.
enum { JOINT_FREE, JOINT_BALL, JOINT_SLIDE, JOINT_HINGE };

// Whether a body moves freely: alone in its tree, on a free joint without armature.
bool body_is_free(const view *v, int body);

// The coefficient of a foot with these states: that of rest if friction held it in the last step.
double foot_mu(const foot *foot, const double *state);

// Whether a geom is one of its grounds.
bool foot_stands_on(const foot *foot, int ground);

// What moves foot and ground. False if there is no memory for it.
bool foot_link(foot *foot, const view *v);

// The patch's plane, centre and axes, from the sums over its contacts and its frame.
void foot_place(foot *foot, const view *v);

// Its motions by each of its degrees of freedom.
void foot_turn(foot *foot, const view *v);

// Its motions for velocities of all degrees of freedom, or accelerations.
void foot_motion(const foot *foot, const double *velocities, double motion[MOTIONS]);

// By how much the way of its body along its ground's surface, in a time `dt` in which no velocity changes, is not straight:
// MuJoCo gives the joints whole turns, which carry what they hold in a circle and not along its tangent.
// It is that of the body's origin, which a free joint moves straight, such that feet of one body have one bend.
void foot_bend(const foot *foot, const view *v, double dt, double bend[2]);

// Its motions by those of foot and ground, of those that move.
void foot_rows(foot *foot, const view *v);

// The part of a normal force in lift and tilts.
void foot_row(const foot *foot, const double position[3], const double normal[3], double row[3]);

// Adds a contact to the stiffness of its normal forces: `stiffness` in acceleration's inverse units.
void foot_press(foot *foot, const double position[3], const double normal[3], double stiffness);

// A force in the frame of the world as one in the patch's plane, and back.
void foot_in_plane(const foot *foot, const double world[3], double plane[2]);
void foot_in_world(const foot *foot, const double plane[2], double world[3]);

#endif
