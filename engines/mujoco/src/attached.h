// Feet that are attached to a simulation from outside, by the addresses of its arrays: for any version of MuJoCo.
#ifndef TRIBOS_MUJOCO_ATTACHED_H
#define TRIBOS_MUJOCO_ATTACHED_H

#include "system.h"

// Where the fields of a contact lie, in bytes from its start; `surface` is negative where contacts have none.
typedef struct contact_layout {
    int width, distance, position, frame, margin, geoms, dimension, row, surface;
} contact_layout;

// A simulation: the arrays that `attached_arrays` names, in their order.
typedef struct simulation {
    void *const *arrays;
    void (*solve)(const void *model, void *data, double *x, const double *y, int count);
    const void *model;
    void *data;
    const int *body_awake;  // NULL where bodies do not sleep
    int nv, nbody, ngeom;
    contact_layout layout;
} simulation;

// A foot, whose geoms and set stay the caller's.
typedef struct given_foot {
    const int *geoms;
    int geom_count, ground;
    int bodies[2];
    int frame, frame_index;  // a frame_kind, and of which geom, body or site
    double mu;
    const friction_set *set;
} given_foot;

// The contacts of a step and its constraints' rows, whose springs are four numbers a row.
typedef struct contacts {
    const char *first;
    size_t count;
    const double *stiffness, *springs;
    size_t rows;
} contacts;

// A foot in the last step, as Python has it.
typedef struct foot_report {
    double load, friction[3], twist[3], axes[9], centre[3];
    double is_held, missed;
} foot_report;

typedef struct attached attached;

// Types and names of the arrays, "type name;" of each.
const char *attached_arrays(void);

// NULL with the reason in `result` and `fault`.
attached *attached_new(const simulation *of, const given_foot *feet, int count, link_result *result, link_fault *fault);
void attached_free(attached *attached);

// Adds this step's friction to the passive forces. NULL, or the reason why there is none.
const char *attached_step(attached *attached, double time, double timestep, const contacts *contacts);
void attached_report(const attached *attached, int foot, foot_report *out);

#endif
