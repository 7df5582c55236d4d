#include "system.h"

#include <stdlib.h>
#include <string.h>

tribos_system *system_new(int count)
{
    tribos_system *system = calloc(1, sizeof *system);
    if (!system) return NULL;
    system->feet = calloc((size_t)count, sizeof *system->feet);
    system->groups = calloc((size_t)count, sizeof *system->groups);
    if (system->feet && system->groups) system->count = count;
    if (system->count) return system;
    system_free(system);
    return NULL;
}

// The foot before `index` that has this geom on this ground already, or -1.
static int claimant(const tribos_system *system, int index, int geom, int ground)
{
    const int ends[2][2] = {{geom, ground}, {ground, geom}};
    for (int way = 0; way < 2; way++)
        for (int at = system->geom_first[ends[way][0]]; at >= 0; at = system->memberships[at].next) {
            const int other = system->memberships[at].foot;
            if (other < index && foot_stands_on(system->feet + other, ends[way][1])) return other;
        }
    return -1;
}

// Links each geom to its feet; a pair of geoms belongs to one foot alone.
static link_result link_geoms(tribos_system *system, const view *v, link_fault *fault)
{
    int total = 0, made = 0;
    for (int i = 0; i < system->count; i++) total += system->feet[i].geom_count;
    system->geom_first = malloc((size_t)(v->ngeom + 1) * sizeof(int));
    system->memberships = malloc((size_t)total * sizeof *system->memberships);
    if (!system->geom_first || !system->memberships) return NO_MEMORY;
    for (int i = 0; i < v->ngeom; i++) system->geom_first[i] = -1;
    for (int i = 0; i < system->count; i++)
        for (int j = 0; j < system->feet[i].geom_count; j++) {
            const int geom = system->feet[i].geoms[j];
            system->memberships[made] = (membership){i, system->geom_first[geom]};
            system->geom_first[geom] = made++;
        }
    for (int i = 0; i < system->count; i++)
        for (int j = 0; j < system->feet[i].geom_count; j++)
            for (int k = 0; k < system->feet[i].ground_count; k++) {
                const int geom = system->feet[i].geoms[j], ground = system->feet[i].grounds[k];
                const int other = claimant(system, i, geom, ground);
                if (other < 0) continue;
                *fault = (link_fault){i, other, geom, ground};
                return CLAIMED_TWICE;
            }
    return LINKED;
}

static bool shares_tree(const foot *a, const foot *b)
{
    for (int i = 0; i < a->freedom_count; i++)
        for (int j = 0; j < b->freedom_count; j++)
            if (a->freedoms[i].root == b->freedoms[j].root) return true;
    return false;
}

static bool is_free(const view *v, const foot *foot)
{
    for (int side = 0; side < 2; side++) {
        if (foot->moves[side] && !body_is_free(v, foot->bodies[side])) return false;
    }
    return true;
}

// The only one of a foot's body and its ground's that moves; 0 if both do.
static int moving_body(const foot *foot)
{
    if (foot->moves[0] && foot->moves[1]) return 0;
    return foot->bodies[foot->moves[0] ? 0 : 1];
}

// Puts feet that move each other into groups.
static link_result link_groups(tribos_system *system, const view *v)
{
    const int count = system->count;
    int *label = malloc((size_t)count * sizeof(int));
    if (!label) return NO_MEMORY;
    for (int i = 0; i < count; i++) label[i] = i;
    for (int i = 0; i < count; i++)
        for (int j = 0; j < i; j++) {
            if (label[i] == label[j] || !shares_tree(system->feet + i, system->feet + j)) continue;
            const int from = label[i], into = label[j];
            for (int k = 0; k < count; k++)
                if (label[k] == from) label[k] = into;
        }
    int largest = 0;
    for (int i = 0; i < count; i++) {
        group *group = system->groups + system->group_count;
        for (int j = 0; j < count; j++) group->count += label[j] == i;
        if (!group->count) continue;
        group->feet = malloc((size_t)group->count * sizeof(int));
        if (!group->feet) {
            free(label);
            return NO_MEMORY;
        }
        group->is_free = true;
        group->body = moving_body(system->feet + i);
        for (int j = 0, at = 0; j < count; j++) {
            if (label[j] != i) continue;
            group->feet[at++] = j;
            group->is_free = group->is_free && is_free(v, system->feet + j);
            if (!group->is_free || moving_body(system->feet + j) != group->body) group->body = 0;
        }
        if (group->count > largest) largest = group->count;
        system->group_count++;
    }
    free(label);
    system->scratch = malloc(system_scratch(largest, v->nv));
    return system->scratch ? LINKED : NO_MEMORY;
}

link_result system_link(tribos_system *system, const view *v, link_fault *fault)
{
    for (int i = 0; i < system->count; i++) {
        fault->foot = i;
        if (!foot_link(system->feet + i, v)) return NO_MEMORY;
        if (!system->feet[i].freedom_count) return NEVER_MOVES;
    }
    const link_result result = link_geoms(system, v, fault);
    return result == LINKED ? link_groups(system, v) : result;
}

void system_free(tribos_system *system)
{
    if (!system) return;
    for (int i = 0; i < system->count; i++) {
        foot *foot = system->feet + i;
        free(foot->geoms);
        free(foot->grounds);
        free(foot->freedoms);
        free(foot->jacobian);
    }
    for (int i = 0; i < system->group_count; i++) free(system->groups[i].feet);
    free(system->feet);
    free(system->groups);
    free(system->geom_first);
    free(system->memberships);
    free(system->touches);
    free(system->scratch);
    free(system);
}

// Takes what a foot of an equal system found in this step; what it owns stays its own.
static void copy_foot(foot *to, const foot *from)
{
    const foot own = *to;
    *to = *from;
    to->geoms = own.geoms;
    to->grounds = own.grounds;
    to->set = own.set;
    to->freedoms = own.freedoms;
    to->jacobian = own.jacobian;
    memcpy(to->jacobian, from->jacobian, (size_t)to->freedom_count * MOTIONS * sizeof(double));
}

void system_copy(tribos_system *to, const tribos_system *from)
{
    to->is_current = false;
    if (!from->is_current || to->count != from->count) return;
    if (to->touch_room < from->touch_count) {
        touch *touches = realloc(to->touches, (size_t)from->touch_count * sizeof *touches);
        if (!touches) return;
        to->touches = touches;
        to->touch_room = from->touch_count;
    }
    to->touch_count = from->touch_count;
    if (from->touch_count)
        memcpy(to->touches, from->touches, (size_t)from->touch_count * sizeof *to->touches);
    for (int i = 0; i < to->count; i++) copy_foot(to->feet + i, from->feet + i);
    to->is_current = true;
}
