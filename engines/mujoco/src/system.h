// All feet of a simulation, and what they do in a step: `system_begin`, `system_touch` for each contact, `system_step`,
// `system_push`; and `system_remember` at the end of the step, or `system_recall` at the start of the next.
#ifndef TRIBOS_MUJOCO_SYSTEM_H
#define TRIBOS_MUJOCO_SYSTEM_H

#include <stddef.h>
#include "foot.h"

// A contact as MuJoCo found it. Frames have the normal, from the first geom to the second, and two tangents.
typedef struct contact {
    int geoms[2];
    int dimension;
    int row;                // of its normal force among the constraints, negative if it has none
    const double *position, *frame;
    const double *surface;  // motion of a conveyor's surface along the tangents and about the normal, or NULL
    double stiffness;       // inverse of its row's regularisation
    double spring[3];       // stiffness, damping and impedance of its row's reference, for `system_recall`
    double gap;             // distance less margin, for the same
} contact;

// A contact of a foot with its ground.
typedef struct touch {
    double sign;  // 1 if MuJoCo's normal points from the ground to the foot, else -1
    int row;
    double position[3], frame[9], surface[3];
    double stiffness, spring[3], gap;
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
    int body;      // the only one that moves, if it moves freely, else 0
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
    bool owes_slip;   // of the step before: it is found in the next
} tribos_system;

// Why feet cannot be those of one model, and which.
typedef enum link_result { LINKED, NO_MEMORY, NEVER_MOVES, CLAIMED_TWICE } link_result;
typedef struct link_fault {
    int foot;
    int other, geom, ground;  // that has the friction of this geom on this ground already
} link_fault;

// Room for feet, whose geoms, bodies, frames, friction and states the caller fills in before they are linked. Memory of
// the geoms becomes the system's; sets stay the caller's.
tribos_system *system_new(int count);
link_result system_link(tribos_system *system, const view *v, link_fault *fault);
void system_free(tribos_system *system);

// Bytes of `scratch` that a group of so many feet uses.
size_t system_scratch(int count, int nv);

// Takes what an equal system found in the step that it is in.
void system_copy(tribos_system *to, const tribos_system *from);

// Forgets the contacts of the step before.
void system_begin(tribos_system *system, const view *v);

// Gives the feet a contact, if it is theirs. NULL, or the reason why it has no friction.
const char *system_touch(tribos_system *system, const contact *contact);

// Finds the friction of this step.
void system_step(tribos_system *system, const view *v);

// Adds the friction that was found to the passive forces.
void system_push(const tribos_system *system, const view *v);

// Remembers loads and friction for the next step, at the end of this one, where the velocities are new and all else is not.
// `forces` are those of the constraints' rows.
void system_remember(tribos_system *system, const view *v, const double *forces);

// The same at the start of the next step, if a step `has_passed`: from the acceleration that the solver found, as the
// forces are gone. What feet have slipped is found within the step, with the places of its start.
void system_recall(tribos_system *system, const view *v, bool has_passed);

#endif
