#include "system.h"

#include <stdlib.h>
#include "compliance.h"
#include "vectors.h"

// Share of its slip that friction takes back in a step from a body that it holds: what it knows a step late, of third
// order in the step, carries the body no further than fifty times what one step of it does. A larger share would
// move a body back visibly that a sudden push has moved in the step in which friction did not know of it.
#define RETURN 0.02

// A foot whose body sleeps keeps what it remembers: MuJoCo leaves its contacts out.
static bool is_asleep(const mjModel *m, const mjData *d, const foot *foot)
{
#if mjVERSION_HEADER >= 340
    return (m->opt.enableflags & mjENBL_SLEEP) && d->body_awake[foot->bodies[0]] == 0;
#else
    (void)m, (void)d, (void)foot;
    return false;
#endif
}

static bool stands_on(const foot *foot, int ground)
{
    for (int i = 0; i < foot->ground_count; i++)
        if (foot->grounds[i] == ground) return true;
    return false;
}

static bool remember_touch(tribos_system *system, foot *foot, const mjContact *contact, int index,
                           double sign)
{
    if (system->touch_count == system->touch_room) {
        const int room = 2 * system->touch_room + 16;
        touch *touches = realloc(system->touches, (size_t)room * sizeof *touches);
        if (!touches) return false;
        system->touches = touches;
        system->touch_room = room;
    }
    const touch made = {index, sign, foot->first};
    foot->first = system->touch_count;
    system->touches[system->touch_count++] = made;
    foot->contact_count++;
    add_scaled3(foot->normal_sum, contact->frame, sign);
    add_scaled3(foot->position_sum, contact->pos, 1);
    return true;
}

// Gives the feet their contacts with their grounds.
static const char *collect(tribos_system *system, const mjData *d)
{
    system->touch_count = 0;
    for (int i = 0; i < system->count; i++) {
        foot *foot = system->feet + i;
        foot->first = -1;
        foot->contact_count = 0;
        memset(foot->normal_sum, 0, sizeof foot->normal_sum);
        memset(foot->position_sum, 0, sizeof foot->position_sum);
    }
    for (int i = 0; i < d->ncon; i++) {
        const mjContact *contact = d->contact + i;
        if (contact->efc_address < 0 || contact->geom[0] < 0 || contact->geom[1] < 0) continue;
        for (int side = 0; side < 2; side++) {
            const int geom = contact->geom[side], ground = contact->geom[1 - side];
            int at = system->geom_first[geom];
            for (; at >= 0; at = system->memberships[at].next) {
                foot *foot = system->feet + system->memberships[at].foot;
                if (!stands_on(foot, ground)) continue;
                if (contact->dim != 1)
                    return "a contact of a foot with its ground has friction of MuJoCo's own: "
                           "condim was changed after the simulation was made; set it to 1 again";
                if (!remember_touch(system, foot, contact, i, side == 1 ? 1 : -1))
                    return "no memory for contacts";
            }
        }
    }
    return NULL;
}

#if mjVERSION_HEADER >= 4000000
// The motion of the surfaces of conveyors, as the mean of those that each contact shows.
static void find_surface_velocity(const tribos_system *system, const mjData *d, foot *foot)
{
    double shift[3] = {0, 0, 0}, spin = 0;
    for (int at = foot->first; at >= 0; at = system->touches[at].next) {
        const mjContact *contact = d->contact + system->touches[at].contact;
        const double *v = contact->surfacevel, sign = system->touches[at].sign;
        double lever[3], turned[3];
        subtract3(lever, foot->centre, contact->pos);
        cross3(turned, contact->frame, lever);
        add_scaled3(shift, contact->frame + 3, sign * v[0]);
        add_scaled3(shift, contact->frame + 6, sign * v[1]);
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
#endif

// Where a foot's patch lies, how it moves, and how its contacts respond.
static void settle(const tribos_system *system, const mjModel *m, const mjData *d, foot *foot,
                   bool is_free)
{
    foot_place(foot, d);
    foot_turn(foot, d);
    if (is_free) foot_mobility_roots(foot, m, d);
    memset(foot->stiffness, 0, sizeof foot->stiffness);
    for (int at = foot->first; at >= 0; at = system->touches[at].next) {
        const mjContact *contact = d->contact + system->touches[at].contact;
        double normal[3] = {0, 0, 0};
        add_scaled3(normal, contact->frame, system->touches[at].sign);
        foot_press(foot, contact->pos, normal, d->efc_D[contact->efc_address]);
    }
    double motion[MOTIONS];
    foot_motion(foot, d->qvel, motion);
    memcpy(foot->motion, motion, sizeof foot->motion);
    memset(foot->surface, 0, sizeof foot->surface);
#if mjVERSION_HEADER >= 4000000
    if (m->flg_surfacevel) find_surface_velocity(system, d, foot);
#endif
    double bend[2];
    foot_bend(foot, m, d, d->qvel, m->opt.timestep, bend);
    subtract3(foot->velocity, motion, foot->surface);
    for (int k = 0; k < 2; k++) foot->velocity[k] += bend[k] / m->opt.timestep;
}

size_t system_scratch(int count)
{
    const size_t numbers = (size_t)MOBILITY(count) + 2 * (size_t)COMPLIANCE(count) +
                           (size_t)SPRINGS(count);
    return sizeof(double) * numbers + (size_t)count * (sizeof(planar_foot) + sizeof(foot *));
}

// A foot in the step of its group: what it remembers, in the axes that its patch has now.
static planar_foot planar_of(const foot *foot, const mjtNum *state)
{
    planar_foot planar = {.patch = &foot->patch, .limit = foot->mu * state[STATE_LOAD]};
    memcpy(planar.velocity, foot->velocity, sizeof planar.velocity);
    foot_in_plane(foot, state + STATE_ACCELERATION, planar.acceleration);
    planar.acceleration[2] = state[STATE_TURNING];
    foot_in_plane(foot, state + STATE_FORCE, planar.start);
    planar.start[2] = state[STATE_TORQUE];
    return planar;
}

// Adds the velocity with which slip is taken back, as one motion of the body: slips of feet that differ would turn
// into forces between them. A body that stands on two grounds, or lacks a motion, might not be able to follow.
static void take_back(foot **touching, planar_foot *planar, int loaded, const mjData *d, double dt)
{
    for (int i = 0; i < loaded; i++) {
        const foot *own = touching[planar[i].index], *first = NULL;
        bool is_on_one = own->is_afloat;
        for (int j = 0; j < loaded; j++) {
            const foot *other = touching[planar[j].index];
            if (other->bodies[0] != own->bodies[0]) continue;
            if (!first && d->plugin_state[other->state + STATE_HELD] > 0) first = other;
            is_on_one = is_on_one && other->bodies[1] == own->bodies[1];
        }
        if (!first || !is_on_one) continue;
        const mjtNum *slip = d->plugin_state + first->state + STATE_SLIP;
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
static void step_group(tribos_system *system, const mjModel *m, mjData *d, const group *group)
{
    const int room = group->count;
    double *mobility = system->scratch, *compliance = mobility + MOBILITY(room),
           *among = compliance + COMPLIANCE(room), *rest = among + COMPLIANCE(room);
    planar_foot *planar = (planar_foot *)(rest + SPRINGS(room));
    foot **touching = (foot **)(planar + room);

    int count = 0;
    for (int i = 0; i < group->count; i++) {
        foot *foot = system->feet + group->feet[i];
        memset(foot->friction, 0, sizeof foot->friction);
        memset(foot->response, 0, sizeof foot->response);
        foot->is_held = foot->is_missed = false;
        if (foot->first < 0) continue;
        settle(system, m, d, foot, group->is_free);
        touching[count++] = foot;
    }
    if (!count) return;
    find_mobility(m, d, touching, count, group->is_free, mobility);
    find_compliance(touching, count, mobility, rest, compliance);

    // Only feet that carried a load in the last step have friction.
    int loaded = 0;
    for (int i = 0; i < count; i++) {
        const mjtNum *state = d->plugin_state + touching[i]->state;
        if (!(state[STATE_LOAD] > 0)) continue;
        planar[loaded] = planar_of(touching[i], state);
        planar[loaded++].index = i;
    }
    if (!loaded) return;
    take_back(touching, planar, loaded, d, m->opt.timestep);
    for (int i = 0; i < loaded; i++)
        for (int j = 0; j < loaded; j++)
            memcpy(among + 9 * (loaded * i + j),
                   compliance + 9 * (count * planar[i].index + planar[j].index), 9 * sizeof(double));
    step_solve(planar, loaded, among, m->opt.timestep);
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

const char *system_step(tribos_system *system, const mjModel *m, mjData *d)
{
    if (m->opt.integrator == mjINT_RK4)
        return "the integrator RK4 evaluates forces within a step, where friction has no implicit step: "
               "choose Euler, implicit or implicitfast";
    const char *why = collect(system, d);
    if (why) return why;
    for (int i = 0; i < system->group_count; i++) step_group(system, m, d, system->groups + i);
    system->is_current = true;
    return NULL;
}

void system_push(const tribos_system *system, mjData *d)
{
    for (int i = 0; i < system->count; i++) {
        const foot *foot = system->feet + i;
        if (foot->first < 0) continue;
        for (int k = 0; k < foot->freedom_count; k++)
            d->qfrc_passive[foot->freedoms[k].index] +=
                dot3(foot->jacobian + MOTIONS * k, foot->friction);
    }
}

// What a touching foot remembers.
static void remember(const tribos_system *system, const mjModel *m, const mjData *d,
                     const foot *foot, mjtNum *state)
{
    state[STATE_LOAD] = 0;
    for (int at = foot->first; at >= 0; at = system->touches[at].next)
        state[STATE_LOAD] +=
            d->efc_force[d->contact[system->touches[at].contact].efc_address];
    foot_in_world(foot, foot->friction, state + STATE_FORCE);
    state[STATE_TORQUE] = foot->friction[2];
    state[STATE_HELD] = foot->is_held;
    state[STATE_MISSED] += foot->is_missed;

    // Its acceleration in this step, as the integrator made it, less that by friction.
    double motion[MOTIONS], acceleration[3];
    foot_motion(foot, d->qvel, motion);
    for (int k = 0; k < 3; k++)
        acceleration[k] =
            (motion[k] - foot->motion[k]) / m->opt.timestep - foot->response[k];
    foot_in_world(foot, acceleration, state + STATE_ACCELERATION);
    state[STATE_TURNING] = acceleration[2];

    // How far it has moved on its ground in spite of being held.
    double slip[3], bend[2];
    subtract3(slip, motion, foot->surface);
    for (int k = 0; k < 3; k++) slip[k] *= m->opt.timestep;
    foot_bend(foot, m, d, d->qvel, m->opt.timestep, bend);
    for (int k = 0; k < 2; k++) slip[k] += bend[k];
    if (foot->is_held)
        add_scaled3(state + STATE_SLIP, slip, 1);
    else
        memset(state + STATE_SLIP, 0, sizeof slip);
}

void system_remember(tribos_system *system, const mjModel *m, mjData *d)
{
    for (int i = 0; i < system->count; i++) {
        const foot *foot = system->feet + i;
        mjtNum *state = d->plugin_state + foot->state;
        if (foot->first >= 0)
            remember(system, m, d, foot, state);
        else if (!is_asleep(m, d, foot))
            memset(state, 0, STATE_MISSED * sizeof(mjtNum));
    }
    system->is_current = false;
}
