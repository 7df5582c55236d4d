#include "foot.h"

#include "vectors.h"

bool body_is_free(const mjModel *m, int body)
{
    if (m->body_dofnum[body] != 6 || m->body_jntnum[body] != 1 || !(m->body_mass[body] > 0))
        return false;
    for (int other = 1; other < m->nbody; other++)
        if (other != body && m->body_rootid[other] == m->body_rootid[body]) return false;
    for (int i = 0; i < 6; i++)
        if (m->dof_armature[m->body_dofadr[body] + i] != 0) return false;
    return true;
}

// Position and orientation, column by column, of the frame that the patch turns with.
static void frame_of(const foot *foot, const mjData *d, const mjtNum **position,
                     const mjtNum **matrix)
{
    const int i = foot->frame_index;
    if (foot->frame == FRAME_GEOM) {
        *position = d->geom_xpos + 3 * i;
        *matrix = d->geom_xmat + 9 * i;
    } else if (foot->frame == FRAME_BODY) {
        *position = d->xpos + 3 * i;
        *matrix = d->xmat + 9 * i;
    } else {
        *position = d->site_xpos + 3 * i;
        *matrix = d->site_xmat + 9 * i;
    }
}

void foot_place(foot *foot, const mjData *d)
{
    const mjtNum *origin, *frame;
    frame_of(foot, d, &origin, &frame);
    double *x = foot->axes, *y = foot->axes + 3, *normal = foot->axes + 6;
    memcpy(normal, foot->normal_sum, 3 * sizeof(double));
    mju_normalize3(normal);

    // The origin of the frame, brought along the normal to the mean height of the contacts.
    double lever[3] = {0, 0, 0};
    add_scaled3(lever, foot->position_sum, 1.0 / foot->contact_count);
    subtract3(lever, lever, origin);
    memcpy(foot->centre, origin, sizeof foot->centre);
    add_scaled3(foot->centre, normal, dot3(normal, lever));

    // The frame's axis after the one along the normal is the patch's x.
    double along[3];
    mju_mulMatTVec3(along, frame, normal);
    int upright = 0;
    for (int i = 1; i < 3; i++)
        if (fabs(along[i]) > fabs(along[upright])) upright = i;
    const int next = (upright + 1) % 3;
    for (int i = 0; i < 3; i++) x[i] = frame[3 * i + next] - normal[i] * along[next];
    mju_normalize3(x);
    cross3(y, normal, x);
}

// A velocity and an angular velocity as a motion of the foot.
static void in_axes(const foot *foot, const double shift[3], const double turn[3],
                    double motion[MOTIONS])
{
    const double *x = foot->axes, *y = foot->axes + 3, *normal = foot->axes + 6;
    motion[ALONG_X] = dot3(x, shift);
    motion[ALONG_Y] = dot3(y, shift);
    motion[SPIN] = dot3(normal, turn);
    motion[LIFT] = dot3(normal, shift);
    motion[TILT_X] = dot3(x, turn);
    motion[TILT_Y] = dot3(y, turn);
}

void foot_turn(foot *foot, const mjData *d)
{
    for (int i = 0; i < foot->freedom_count; i++) {
        const freedom *freedom = foot->freedoms + i;
        // MuJoCo's axes are angular and linear, the latter at the centre of mass of the tree.
        const mjtNum *axis = d->cdof + 6 * freedom->index;
        double lever[3], shift[3], *motion = foot->jacobian + MOTIONS * i;
        subtract3(lever, foot->centre, d->subtree_com + 3 * freedom->root);
        cross3(shift, axis, lever);
        add_scaled3(shift, axis + 3, 1);
        in_axes(foot, shift, axis, motion);
        for (int k = 0; k < MOTIONS; k++) motion[k] *= freedom->sign;
    }
}

void foot_motion(const foot *foot, const mjtNum *velocities, double motion[MOTIONS])
{
    memset(motion, 0, MOTIONS * sizeof(double));
    for (int i = 0; i < foot->freedom_count; i++)
        for (int k = 0; k < MOTIONS; k++)
            motion[k] += foot->jacobian[MOTIONS * i + k] * velocities[foot->freedoms[i].index];
}

// sin(x)/x
static double sinc(double x) { return fabs(x) > 0 ? sin(x) / x : 1; }

// change += what a turn by a vector of angles makes of another vector (Rodrigues, in half angles without
// cancellation).
static void add_turn(double change[3], const double turn[3], const double vector[3])
{
    const double angle = sqrt(dot3(turn, turn)), half = sinc(0.5 * angle);
    double once[3], twice[3];
    cross3(once, turn, vector);
    cross3(twice, turn, once);
    add_scaled3(change, once, sinc(angle));
    add_scaled3(change, twice, 0.5 * half * half);
}

// How a point moves, and how it would along the tangent.
typedef struct carried {
    double shift[3], straight[3];
} carried;

// Adds how the joints of a body move a point of it in a time, from the innermost outwards.
static void carry(const mjModel *m, const mjData *d, int body, const mjtNum *velocities, double dt,
                  const double point[3], carried *out)
{
    for (; body; body = m->body_parentid[body])
        for (int k = m->body_jntnum[body] - 1; k >= 0; k--) {
            const int joint = m->body_jntadr[body] + k, type = m->jnt_type[joint], first = m->jnt_dofadr[joint];
            const int shifts = type == mjJNT_FREE ? 3 : type == mjJNT_SLIDE;
            const int turns = type == mjJNT_HINGE ? 1 : type == mjJNT_SLIDE ? 0 : 3;
            double turn[3] = {0, 0, 0}, lever[3], tangent[3];
            for (int i = first + shifts; i < first + shifts + turns; i++)
                add_scaled3(turn, d->cdof + 6 * i, velocities[i] * dt);
            subtract3(lever, point, d->xanchor + 3 * joint);
            cross3(tangent, turn, lever);
            add_scaled3(out->straight, tangent, 1);
            add_scaled3(lever, out->shift, 1);
            add_turn(out->shift, turn, lever);
            for (int i = first; i < first + shifts; i++) {
                add_scaled3(out->shift, d->cdof + 6 * i + 3, velocities[i] * dt);
                add_scaled3(out->straight, d->cdof + 6 * i + 3, velocities[i] * dt);
            }
        }
}

// A conveyor's surface goes on ahead of its body.
static void convey(const foot *foot, const double point[3], double dt, carried *out)
{
    double lever[3], spin[3] = {0, 0, 0}, half[3] = {0, 0, 0};
    foot_in_world(foot, foot->surface, out->straight);
    add_scaled3(spin, foot->axes + 6, foot->surface[SPIN]);
    subtract3(lever, point, foot->centre);
    cross3(out->shift, spin, lever);
    add_scaled3(out->straight, out->shift, 1);
    // The chord of a turn about the normal is the tangent turned by half of it.
    add_scaled3(half, spin, 0.5 * dt);
    memcpy(out->shift, out->straight, sizeof out->shift);
    add_turn(out->shift, half, out->straight);
    const double chord = sinc(0.5 * foot->surface[SPIN] * dt);
    for (int k = 0; k < 3; k++) {
        out->shift[k] *= chord * dt;
        out->straight[k] *= dt;
    }
}

void foot_bend(const foot *foot, const mjModel *m, const mjData *d, const mjtNum *velocities, double dt,
               double bend[2])
{
    const double *origin = d->xpos + 3 * foot->bodies[0];
    carried own = {{0}, {0}}, under = {{0}, {0}};
    convey(foot, origin, dt, &under);
    carry(m, d, foot->bodies[0], velocities, dt, origin, &own);
    carry(m, d, foot->bodies[1], velocities, dt, origin, &under);
    double way[3], straight[3];
    subtract3(way, own.shift, under.shift);
    subtract3(straight, own.straight, under.straight);
    add_scaled3(way, straight, -1);
    foot_in_plane(foot, way, bend);
}

void foot_mobility_roots(foot *foot, const mjModel *m, const mjData *d)
{
    for (int side = 0; side < 2; side++) {
        const int body = foot->bodies[side];
        double *root = foot->roots[side];
        if (!foot->moves[side]) continue;
        const double sign = side == 0 ? 1 : -1;
        const double inv_mass = sign / sqrt(m->body_mass[body]);
        double lever[3];
        subtract3(lever, foot->centre, d->xipos + 3 * body);
        for (int axis = 0; axis < 3; axis++) {
            const double none[3] = {0, 0, 0};
            double unit[3] = {0, 0, 0}, turn[3], shift[3], motion[MOTIONS];
            // Along the axes of the world.
            unit[axis] = inv_mass;
            in_axes(foot, unit, none, motion);
            for (int k = 0; k < MOTIONS; k++) root[6 * k + axis] = motion[k];
            // About the axes of the inertia.
            const double inv_inertia = sign / sqrt(m->body_inertia[3 * body + axis]);
            for (int k = 0; k < 3; k++) turn[k] = d->ximat[9 * body + 3 * k + axis] * inv_inertia;
            cross3(shift, turn, lever);
            in_axes(foot, shift, turn, motion);
            for (int k = 0; k < MOTIONS; k++) root[6 * k + 3 + axis] = motion[k];
        }
    }
}

void foot_press(foot *foot, const double position[3], const double normal[3], double stiffness)
{
    double lever[3], moment[3];
    subtract3(lever, position, foot->centre);
    cross3(moment, lever, normal);
    // The part of a normal force in lift and tilts.
    const double row[3] = {1, dot3(moment, foot->axes), dot3(moment, foot->axes + 3)};
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) foot->stiffness[3 * i + j] += stiffness * row[i] * row[j];
}

void foot_in_plane(const foot *foot, const double world[3], double plane[2])
{
    plane[0] = dot3(foot->axes, world);
    plane[1] = dot3(foot->axes + 3, world);
}

void foot_in_world(const foot *foot, const double plane[2], double world[3])
{
    memset(world, 0, 3 * sizeof(double));
    add_scaled3(world, foot->axes, plane[0]);
    add_scaled3(world, foot->axes + 3, plane[1]);
}
