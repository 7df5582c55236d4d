// The area on which a foot stands, as a model names it.
#ifndef TRIBOS_MUJOCO_PATCH_H
#define TRIBOS_MUJOCO_PATCH_H

#include <stdbool.h>
#include <stddef.h>
#include "set.h"
#include "tribos.h"

typedef enum patch_kind {
    PATCH_DISK,
    PATCH_ANNULUS,
    PATCH_RING,
    PATCH_HERTZ,
    PATCH_PUNCH,
    PATCH_POLYGON,
    PATCH_POINTS
} patch_kind;

typedef struct patch {
    friction_set set;
    patch_kind kind;
    double radius;       // of a round patch, in m
    double inner_ratio;  // of an annulus
    bool is_even;        // sliding has no torque and spin no force, about the origin
    tribos_polygon_f64 polygon;
    tribos_edge_f64 *edges;  // memory of the polygon
    tribos_node_f64 *nodes;  // points with equal loads
    size_t node_count;
} patch;

// The kinds, by the names in a model.
#define PATCH_NAMES                                                                                  \
    "\"disk\", \"annulus\", \"ring\", \"hertz\", \"punch\", \"box\", \"polygon\", \"points\""

// Reads a patch from the text of its attributes. False with the reason in `why`.
bool patch_read(patch *out, const char *kind, const char *size, const char *corners, char *why,
                size_t room);
void patch_free(patch *patch);

// Reads numbers separated by white space; -1 where something else stands. Returns how many there are; those
// beyond `room` are not written.
int read_numbers(const char *text, double *out, int room);

#endif
