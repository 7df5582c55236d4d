// All feet of a simulation, and what they do in a step.
#ifndef TRIBOS_MUJOCO_SYSTEM_H
#define TRIBOS_MUJOCO_SYSTEM_H

#include "foot.h"
#include "step.h"

// A contact of a foot with its ground.
typedef struct touch {
    int contact;
    double sign;  // 1 if MuJoCo's normal points from the ground to the foot, else -1
    int next;     // of the same foot, -1 after the last
} touch;

// A foot that a geom belongs to.
typedef struct membership {
    int foot;
    int next;  // of the same geom, -1 after the last
} membership;

// Feet with degrees of freedom of the same trees, directly or by way of others.
typedef struct group {
    int *feet, count;
    bool is_free;  // all bodies move freely or not at all
} group;

typedef struct tribos_system {
    foot *feet;
    int count;
    group *groups;
    int group_count;
    int *geom_first;  // of each geom, its first membership or -1
    membership *memberships;

    touch *touches;
    int touch_count, touch_room;
    double *scratch;
    bool is_current;  // friction of this step is in the feet
} tribos_system;

// Bytes of `scratch` that a group of so many feet uses.
size_t system_scratch(int count);

// Finds the friction of this step. NULL, or the reason why there is none.
const char *system_step(tribos_system *system, const mjModel *m, mjData *d);

// Adds the friction that was found to the passive forces.
void system_push(const tribos_system *system, mjData *d);

// Remembers loads and friction for the next step, at the end of this one.
void system_remember(tribos_system *system, const mjModel *m, mjData *d);

#endif
