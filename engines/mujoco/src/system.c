#include "system.h"

#include <stdlib.h>
#include "compliance.h"
#include "step.h"
#include "vectors.h"

// Share of its slip that friction takes back in a step from a body that it holds: what it knows a step late, of third
// order in the step, carries the body no further than fifty times what one step of it does. A larger share would
// move a body back visibly that a sudden push has moved in the step in which friction did not know of it.
#define RETURN 0.02

static bool remember_touch(tribos_system *system, foot *foot, const contact *contact, double sign)
{
    if (system->touch_count == system->touch_room) {
        const int room = 2 * system->touch_room + 16;
        touch *touches = realloc(system->touches, (size_t)room * sizeof *touches);
        if (!touches) return false;
        system->touches = touches;
        system->touch_room = room;
    }
    touch *made = system->touches + system->touch_count;
    made->sign = sign;
    made->row = contact->row;
    made->stiffness = contact->stiffness;
    made->gap = contact->gap;
    made->next = foot->first;
    memcpy(made->position, contact->position, sizeof made->position);
    memcpy(made->frame, contact->frame, sizeof made->frame);
    memcpy(made->spring, contact->spring, sizeof made->spring);
    memset(made->surface, 0, sizeof made->surface);
    if (contact->surface) memcpy(made->surface, contact->surface, sizeof made->surface);
    foot->is_conveyed = foot->is_conveyed || !(dot3(made->surface, made->surface) == 0);
    foot->first = system->touch_count;
    system->touch_count++;
    foot->contact_count++;
    add_scaled3(foot->normal_sum, contact->frame, sign);
    add_scaled3(foot->position_sum, contact->position, 1);
    return true;
}

void system_begin(tribos_system *system, const view *v)
{
    system->touch_count = 0;
    for (int i = 0; i < system->count; i++) {
        foot *foot = system->feet + i;
        foot->is_asleep = v->body_awake && !v->body_awake[foot->bodies[0]];
        foot->first = -1;
        foot->contact_count = 0;
        foot->is_conveyed = false;
        memset(foot->normal_sum, 0, sizeof foot->normal_sum);
        memset(foot->position_sum, 0, sizeof foot->position_sum);
    }
}

const char *system_touch(tribos_system *system, const contact *contact)
{
    if (contact->row < 0 || contact->geoms[0] < 0 || contact->geoms[1] < 0) return NULL;
    for (int side = 0; side < 2; side++) {
        const int geom = contact->geoms[side], ground = contact->geoms[1 - side];
        int at = system->geom_first[geom];
        for (; at >= 0; at = system->memberships[at].next) {
            foot *foot = system->feet + system->memberships[at].foot;
            if (!foot_stands_on(foot, ground)) continue;
            if (contact->dimension != 1)
                return "a contact of a foot with its ground has friction of MuJoCo's own: "
                       "condim was changed after the feet were made; set it to 1 again";
            if (!remember_touch(system, foot, contact, side == 1 ? 1 : -1)) return "no memory for contacts";
        }
    }
    return NULL;
}

// The motion of the surfaces of conveyors, as the mean of those that each contact shows.
static void find_surface_velocity(const tribos_system *system, foot *foot)
{
    double shift[3] = {0, 0, 0}, spin = 0;
    memset(foot->surface, 0, sizeof foot->surface);
    if (!foot->is_conveyed) return;
    for (int at = foot->first; at >= 0; at = system->touches[at].next) {
        const touch *touch = system->touches + at;
        const double *v = touch->surface, sign = touch->sign;
        double lever[3], turned[3];
        subtract3(lever, foot->centre, touch->position);
        cross3(turned, touch->frame, lever);
        add_scaled3(shift, touch->frame + 3, sign * v[0]);
        add_scaled3(shift, touch->frame + 6, sign * v[1]);
        add_scaled3(shift, turned, sign * v[2]);
        // The spin about the contact's normal is `sign` times that about the foot's, as is its sense.
        spin += v[2];
    }
    // MuJoCo's are those of the foot against the surface.
    double plane[2];
    foot_in_plane(foot, shift, plane);
    foot->surface[ALONG_X] = -plane[0] / foot->contact_count;
    foot->surface[ALONG_Y] = -plane[1] / foot->contact_count;
    foot->surface[SPIN] = -spin / foot->contact_count;
}

// How far a foot moves on its ground in a step that begins where MuJoCo's arrays are, or, `sense` -1, in one that has ended
// there: added to its slip.
static void add_slip(const foot *foot, const view *v, const double motion[MOTIONS], int sense, double *slip)
{
    double way[3], bend[2];
    subtract3(way, motion, foot->surface);
    for (int k = 0; k < 3; k++) way[k] *= v->timestep;
    foot_bend(foot, v, sense * v->timestep, bend);
    for (int k = 0; k < 2; k++) way[k] += sense * bend[k];
    add_scaled3(slip, way, 1);
}

// Where a foot's patch lies, how it moves, and how its contacts respond.
static void settle(const tribos_system *system, const view *v, foot *foot, bool is_free)
{
    foot_place(foot, v);
    foot_turn(foot, v);
    if (is_free) foot_rows(foot, v);
    memset(foot->stiffness, 0, sizeof foot->stiffness);
    for (int at = foot->first; at >= 0; at = system->touches[at].next) {
        const touch *touch = system->touches + at;
        double normal[3] = {0, 0, 0};
        add_scaled3(normal, touch->frame, touch->sign);
        foot_press(foot, touch->position, normal, touch->stiffness);
    }
    foot_motion(foot, v->qvel, foot->motion);
    find_surface_velocity(system, foot);
    double *state = v->states + foot->state;
    if (system->owes_slip && state[STATE_HELD] > 0) add_slip(foot, v, foot->motion, -1, state + STATE_SLIP);
    double bend[2];
    foot_bend(foot, v, v->timestep, bend);
    subtract3(foot->velocity, foot->motion, foot->surface);
    for (int k = 0; k < 2; k++) foot->velocity[k] += bend[k] / v->timestep;
}

size_t system_scratch(int count, int nv)
{
    const size_t numbers = (size_t)MOBILITY(count) + 2 * (size_t)COMPLIANCE(count) +
                           (size_t)SPRINGS(count) + (size_t)ROWS(count, nv);
    return sizeof(double) * numbers + (size_t)count * (sizeof(planar_foot) + sizeof(foot *));
}

// A foot in the step of its group: what it remembers, in the axes that its patch has now.
static void take_foot(planar_foot *planar, const foot *foot, const double *state)
{
    planar->set = foot->set;
    planar->limit = foot->mu * state[STATE_LOAD];
    planar->static_limit = foot_mu(foot, state) * state[STATE_LOAD];
    memcpy(planar->velocity, foot->velocity, sizeof planar->velocity);
    foot_in_plane(foot, state + STATE_ACCELERATION, planar->acceleration);
    planar->acceleration[2] = state[STATE_TURNING];
    foot_in_plane(foot, state + STATE_FORCE, planar->start);
    planar->start[2] = state[STATE_TORQUE];
}

// Adds the velocity with which slip is taken back, as one motion of the body: slips of feet that differ would turn
// into forces between them. A body that stands on two grounds, or lacks a motion, might not be able to follow.
static void take_back(foot **touching, planar_foot *planar, int loaded, const double *states, double dt)
{
    for (int i = 0; i < loaded; i++) {
        const foot *own = touching[planar[i].index], *first = NULL;
        bool is_on_one = own->is_afloat;
        for (int j = 0; j < loaded; j++) {
            const foot *other = touching[planar[j].index];
            if (other->bodies[0] != own->bodies[0]) continue;
            if (!first && states[other->state + STATE_HELD] > 0) first = other;
            is_on_one = is_on_one && other->bodies[1] == own->bodies[1];
        }
        if (!first || !is_on_one) continue;
        const double *slip = states + first->state + STATE_SLIP;
        double way[3], lever[3], turn[3] = {0, 0, 0}, moved[3], plane[2];
        foot_in_world(first, slip, way);
        add_scaled3(turn, first->axes + 6, slip[SPIN]);
        subtract3(lever, own->centre, first->centre);
        cross3(moved, turn, lever);
        add_scaled3(way, moved, 1);
        foot_in_plane(own, way, plane);
        planar[i].velocity[ALONG_X] += RETURN / dt * plane[0];
        planar[i].velocity[ALONG_Y] += RETURN / dt * plane[1];
        planar[i].velocity[SPIN] += RETURN / dt * slip[SPIN];
    }
}

// Friction of a group of feet.
static void step_group(tribos_system *system, const view *v, const group *group)
{
    const int room = group->count;
    double *compliance = system->scratch, *among = compliance + COMPLIANCE(room), *rest = among + COMPLIANCE(room);
    planar_foot *planar = (planar_foot *)(rest + MOBILITY(room) + SPRINGS(room) + ROWS(room, v->nv));
    foot **touching = (foot **)(planar + room);

    int count = 0;
    for (int i = 0; i < group->count; i++) {
        foot *foot = system->feet + group->feet[i];
        memset(foot->friction, 0, sizeof foot->friction);
        memset(foot->response, 0, sizeof foot->response);
        foot->is_held = foot->is_missed = false;
        if (foot->first < 0) continue;
        settle(system, v, foot, group->is_free);
        touching[count++] = foot;
    }
    if (!count) return;
    find_compliance(v, touching, count, group->is_free, group->body, rest, compliance);

    // Only feet that carried a load in the last step have friction.
    int loaded = 0;
    for (int i = 0; i < count; i++) {
        const double *state = v->states + touching[i]->state;
        if (!(state[STATE_LOAD] > 0)) continue;
        take_foot(planar + loaded, touching[i], state);
        planar[loaded++].index = i;
    }
    if (!loaded) return;
    take_back(touching, planar, loaded, v->states, v->timestep);
    for (int i = 0; i < loaded; i++)
        for (int j = 0; j < loaded; j++)
            memcpy(among + 9 * (loaded * i + j),
                   compliance + 9 * (count * planar[i].index + planar[j].index), 9 * sizeof(double));
    step_solve(planar, loaded, among, v->timestep);
    for (int j = 0; j < loaded; j++) {
        foot *foot = touching[planar[j].index];
        memcpy(foot->friction, planar[j].friction, sizeof foot->friction);
        foot->is_held = planar[j].is_held;
        foot->is_missed = planar[j].is_missed;
        for (int i = 0; i < count; i++)
            add_product3(touching[i]->response, compliance + 9 * (count * i + planar[j].index),
                         foot->friction);
    }
}

void system_step(tribos_system *system, const view *v)
{
    for (int i = 0; i < system->group_count; i++) step_group(system, v, system->groups + i);
    system->is_current = true;
}

void system_push(const tribos_system *system, const view *v)
{
    for (int i = 0; i < system->count; i++) {
        const foot *foot = system->feet + i;
        if (foot->first < 0) continue;
        for (int k = 0; k < foot->freedom_count; k++)
            v->qfrc_passive[foot->freedoms[k].index] +=
                dot3(foot->jacobian + MOTIONS * k, foot->friction);
    }
}

// What a touching foot remembers of friction, and of its acceleration by all forces, less that by friction.
static void remember(const foot *foot, double load, const double by_all[3], double dt, double *state)
{
    // Whole steps at rest count.
    state[STATE_RESTED] = foot->is_held && state[STATE_HELD] > 0 ? state[STATE_RESTED] + dt : 0;
    state[STATE_LOAD] = load;
    foot_in_world(foot, foot->friction, state + STATE_FORCE);
    state[STATE_TORQUE] = foot->friction[2];
    state[STATE_HELD] = foot->is_held;
    state[STATE_MISSED] += foot->is_missed;
    double acceleration[3];
    subtract3(acceleration, by_all, foot->response);
    foot_in_world(foot, acceleration, state + STATE_ACCELERATION);
    state[STATE_TURNING] = acceleration[2];
    if (!foot->is_held) memset(state + STATE_SLIP, 0, 3 * sizeof(double));
}

// A foot that touches nothing; one that sleeps touches what it did.
static void forget(const foot *foot, double *state)
{
    if (foot->is_asleep) return;
    memset(state, 0, STATE_MISSED * sizeof(double));
    state[STATE_RESTED] = 0;
}

void system_remember(tribos_system *system, const view *v, const double *forces)
{
    for (int i = 0; i < system->count; i++) {
        const foot *foot = system->feet + i;
        double *state = v->states + foot->state;
        if (foot->first < 0) {
            forget(foot, state);
            continue;
        }
        double load = 0, motion[MOTIONS], by_all[3];
        for (int at = foot->first; at >= 0; at = system->touches[at].next) load += forces[system->touches[at].row];
        // As the integrator made it.
        foot_motion(foot, v->qvel, motion);
        for (int k = 0; k < 3; k++) by_all[k] = (motion[k] - foot->motion[k]) / v->timestep;
        remember(foot, load, by_all, v->timestep, state);
        if (foot->is_held) add_slip(foot, v, motion, 1, state + STATE_SLIP);
    }
    system->is_current = false;
}

// The normal force of a contact, as the solver has it: stiffness x max(0, reference - acceleration).
static double normal_force(const foot *foot, const touch *touch, const double acceleration[MOTIONS])
{
    double normal[3] = {0, 0, 0}, row[3];
    add_scaled3(normal, touch->frame, touch->sign);
    foot_row(foot, touch->position, normal, row);
    const double reference = -touch->spring[1] * dot3(row, foot->motion + LIFT) -
                             touch->spring[0] * touch->spring[2] * touch->gap;
    return touch->stiffness * fmax(reference - dot3(row, acceleration + LIFT), 0);
}

void system_recall(tribos_system *system, const view *v, bool has_passed)
{
    system->owes_slip = has_passed && system->is_current;
    if (!system->is_current) return;
    for (int i = 0; i < system->count; i++) {
        const foot *foot = system->feet + i;
        double *state = v->states + foot->state;
        if (foot->first < 0) {
            forget(foot, state);
            continue;
        }
        double load = 0, motion[MOTIONS];
        foot_motion(foot, v->qacc, motion);
        for (int at = foot->first; at >= 0; at = system->touches[at].next)
            load += normal_force(foot, system->touches + at, motion);
        remember(foot, load, motion, v->timestep, state);
    }
    system->is_current = false;
}
