// The plugin `tribos.patch`: exact friction of contact patches as a passive force.
//
// Each instance is a foot. The first of them prepares all, as feet of one body are solved together.

#include <mujoco/mjplugin.h>
#include <mujoco/mujoco.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include "model.h"

#define NAME "tribos.patch"

static tribos_system *system_of(const mjData *d, int instance)
{
    return (tribos_system *)d->plugin_data[instance];
}

static void fail(const mjModel *m, int instance, const char *why)
{
    const char *name = mj_id2name(m, mjOBJ_PLUGIN, instance);
    if (name && *name)
        mju_error(NAME " \"%s\": %s", name, why);
    else
        mju_error(NAME ", instance %d: %s", instance, why);
}

static int state_size(const mjModel *m, int instance)
{
    (void)m, (void)instance;
    return STATE_SIZE;
}

// Whether an instance is the first of this plugin, which has the system.
static bool is_lead(const mjModel *m, int instance)
{
    for (int i = 0; i < instance; i++)
        if (m->plugin[i] == m->plugin[instance]) return false;
    return true;
}

static int make(const mjModel *m, mjData *d, int instance)
{
    d->plugin_data[instance] = 0;
    if (!is_lead(m, instance)) return 0;
    char why[600];
    int blamed;
    tribos_system *system = feet_new(m, instance, &blamed, why, sizeof why);
    if (!system) fail(m, blamed, why);
    d->plugin_data[instance] = (uintptr_t)system;
    return system ? 0 : -1;
}

static void destroy(mjData *d, int instance)
{
    feet_free(system_of(d, instance));
    d->plugin_data[instance] = 0;
}

// MuJoCo copies the state; a copy in the middle of a step needs what was found in it, too.
static void copy(mjData *to, const mjModel *m, const mjData *from, int instance)
{
    (void)m;
    tribos_system *system = system_of(to, instance);
    if (system) system_copy(system, system_of(from, instance));
}

static void reset(const mjModel *m, mjtNum *state, void *data, int instance)
{
    (void)m, (void)instance;
    tribos_system *system = data;
    memset(state, 0, STATE_SIZE * sizeof *state);
    if (system) system->is_current = false;
}

// The contacts of a step, as this version of MuJoCo has them. NULL, or the reason why one has no friction.
static const char *collect(tribos_system *system, const mjModel *m, const mjData *d)
{
    (void)m;
    for (int i = 0; i < d->ncon; i++) {
        const mjContact *found = d->contact + i;
        contact contact = {.geoms = {found->geom[0], found->geom[1]}, .dimension = found->dim,
                           .row = found->efc_address, .position = found->pos, .frame = found->frame};
        if (contact.row >= 0) contact.stiffness = d->efc_D[contact.row];
#if mjVERSION_HEADER >= 4000000
        if (m->flg_surfacevel) contact.surface = found->surfacevel;
#endif
        const char *why = system_touch(system, &contact);
        if (why) return why;
    }
    return NULL;
}

static void compute(const mjModel *m, mjData *d, int instance, int capability)
{
    (void)capability;
    tribos_system *system = system_of(d, instance);
    if (!system) return;
    if (m->opt.integrator == mjINT_RK4)
        fail(m, instance, "the integrator RK4 evaluates forces within a step, where friction has no implicit step: "
                          "choose Euler, implicit or implicitfast");
    const view v = view_of(m, d);
    system_begin(system, &v);
    const char *why = collect(system, m, d);
    if (why) fail(m, instance, why);
    system_step(system, &v);
    system_push(system, &v);
}

static void advance(const mjModel *m, mjData *d, int instance)
{
    tribos_system *system = system_of(d, instance);
    if (!system) return;
    if (!system->is_current) {
        fail(m, instance, "the step ended without its passive forces: they were disabled after the simulation "
                          "was made");
        return;
    }
    const view v = view_of(m, d);
    system_remember(system, &v, d->efc_force);
}

// MuJoCo's macro for this has other arguments in other versions.
__attribute__((constructor)) static void add_plugin(void)
{
    static const char *const attributes[] = ATTRIBUTES;
    mjpPlugin plugin;
    mjp_defaultPlugin(&plugin);
    plugin.name = NAME;
    plugin.nattribute = sizeof attributes / sizeof *attributes;
    plugin.attributes = attributes;
    plugin.capabilityflags = mjPLUGIN_PASSIVE;
    plugin.nstate = state_size;
    plugin.init = make;
    plugin.destroy = destroy;
    plugin.copy = copy;
    plugin.reset = reset;
    plugin.compute = compute;
    plugin.advance = advance;
    mjp_registerPlugin(&plugin);
}
