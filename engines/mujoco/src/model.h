// The feet of a model, read from the attributes of the plugin's instances.
#ifndef TRIBOS_MUJOCO_MODEL_H
#define TRIBOS_MUJOCO_MODEL_H

#include <mujoco/mujoco.h>
#include "system.h"

// Names of the attributes, in the order in which the plugin registers them.
#define ATTRIBUTES \
    {"geom", "ground", "site", "patch", "size", "corners", "mu", "mu_s", "ageing_b", "ageing_t0"}

// Prepares the feet of all instances in the plugin slot of instance `lead`. NULL with the reason in `why`,
// and in `blamed` the instance.
tribos_system *feet_new(const mjModel *m, int lead, int *blamed, char *why, size_t room);
void feet_free(tribos_system *system);

// MuJoCo's arrays; those of the model alone without data.
view view_of(const mjModel *m, mjData *d);

#endif
