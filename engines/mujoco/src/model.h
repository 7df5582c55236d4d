// The feet of a model, read from the attributes of the plugin's instances.
#ifndef TRIBOS_MUJOCO_MODEL_H
#define TRIBOS_MUJOCO_MODEL_H

#include "system.h"

// Names of the attributes, in the order in which the plugin registers them.
#define ATTRIBUTES {"geom", "ground", "site", "patch", "size", "corners", "mu"}

// Prepares the feet of all instances in the plugin slot of instance `lead`. NULL with the reason in `why`,
// and in `blamed` the instance.
tribos_system *system_new(const mjModel *m, int lead, int *blamed, char *why, size_t room);
void system_free(tribos_system *system);

// Takes what a system of the same model found in the step that it is in.
void system_copy(tribos_system *to, const tribos_system *from);

#endif
