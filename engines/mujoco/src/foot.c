#include "foot.h"

#include <stdlib.h>
#include "vectors.h"

bool body_is_free(const view *v, int body)
{
    if (v->body_dofnum[body] != 6 || v->body_jntnum[body] != 1 || !(v->body_mass[body] > 0))
        return false;
    for (int other = 1; other < v->nbody; other++)
        if (other != body && v->body_rootid[other] == v->body_rootid[body]) return false;
    for (int i = 0; i < 6; i++)
        if (v->dof_armature[v->body_dofadr[body] + i] != 0) return false;
    return true;
}

bool foot_stands_on(const foot *foot, int ground)
{
    for (int i = 0; i < foot->ground_count; i++)
        if (foot->grounds[i] == ground) return true;
    return false;
}

// The degrees of freedom of foot and ground; those that move both alike do not move the foot on its ground.
static void link_freedoms(foot *foot, const view *v)
{
    foot->freedom_count = 0;
    for (int side = 0; side < 2; side++)
        for (int body = foot->bodies[side]; body > 0; body = v->body_parentid[body])
            for (int k = 0; k < v->body_dofnum[body]; k++) {
                const int index = v->body_dofadr[body] + k;
                int at = 0;
                while (at < foot->freedom_count && foot->freedoms[at].index != index) at++;
                if (at < foot->freedom_count) {
                    foot->freedoms[at] = foot->freedoms[--foot->freedom_count];
                    continue;
                }
                const freedom made = {index, v->body_rootid[body], side == 0 ? 1 : -1};
                foot->freedoms[foot->freedom_count++] = made;
            }
}

bool foot_link(foot *foot, const view *v)
{
    for (int side = 0; side < 2; side++) foot->moves[side] = foot->bodies[side] != 0;
    // A welded body is told as the one with joints that it is welded to.
    const int jointed = foot->bodies[0];
    foot->is_afloat = jointed && v->jnt_type[v->body_jntadr[jointed]] == JOINT_FREE;
    foot->is_straight = foot->is_afloat && v->body_jntnum[jointed] == 1 && !foot->moves[1];
    foot->freedoms = malloc((size_t)(v->nv + 1) * sizeof *foot->freedoms);
    foot->jacobian = malloc((size_t)(v->nv + 1) * MOTIONS * sizeof(double));
    if (!foot->freedoms || !foot->jacobian) return false;
    link_freedoms(foot, v);
    return true;
}

// Position and orientation, column by column, of the frame that the patch turns with.
static void frame_of(const foot *foot, const view *v, const double **position,
                     const double **matrix)
{
    const int i = foot->frame_index;
    if (foot->frame == FRAME_GEOM) {
        *position = v->geom_xpos + 3 * i;
        *matrix = v->geom_xmat + 9 * i;
    } else if (foot->frame == FRAME_BODY) {
        *position = v->xpos + 3 * i;
        *matrix = v->xmat + 9 * i;
    } else {
        *position = v->site_xpos + 3 * i;
        *matrix = v->site_xmat + 9 * i;
    }
}

void foot_place(foot *foot, const view *v)
{
    const double *origin, *frame;
    frame_of(foot, v, &origin, &frame);
    double *x = foot->axes, *y = foot->axes + 3, *normal = foot->axes + 6;
    memcpy(normal, foot->normal_sum, 3 * sizeof(double));
    normalise3(normal);

    // The origin of the frame, brought along the normal to the mean height of the contacts.
    double lever[3] = {0, 0, 0};
    add_scaled3(lever, foot->position_sum, 1.0 / foot->contact_count);
    subtract3(lever, lever, origin);
    memcpy(foot->centre, origin, sizeof foot->centre);
    add_scaled3(foot->centre, normal, dot3(normal, lever));

    // The frame's axis after the one along the normal is the patch's x.
    double along[3];
    for (int i = 0; i < 3; i++)
        along[i] = frame[i] * normal[0] + frame[3 + i] * normal[1] + frame[6 + i] * normal[2];
    int upright = 0;
    for (int i = 1; i < 3; i++)
        if (fabs(along[i]) > fabs(along[upright])) upright = i;
    const int next = (upright + 1) % 3;
    for (int i = 0; i < 3; i++) x[i] = frame[3 * i + next] - normal[i] * along[next];
    normalise3(x);
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

void foot_turn(foot *foot, const view *v)
{
    for (int i = 0; i < foot->freedom_count; i++) {
        const freedom *freedom = foot->freedoms + i;
        // MuJoCo's axes are angular and linear, the latter at the centre of mass of the tree.
        const double *axis = v->cdof + 6 * freedom->index;
        double lever[3], shift[3], *motion = foot->jacobian + MOTIONS * i;
        subtract3(lever, foot->centre, v->subtree_com + 3 * freedom->root);
        cross3(shift, axis, lever);
        add_scaled3(shift, axis + 3, 1);
        in_axes(foot, shift, axis, motion);
        for (int k = 0; k < MOTIONS; k++) motion[k] *= freedom->sign;
    }
}

void foot_motion(const foot *foot, const double *velocities, double motion[MOTIONS])
{
    memset(motion, 0, MOTIONS * sizeof(double));
    for (int i = 0; i < foot->freedom_count; i++)
        for (int k = 0; k < MOTIONS; k++)
            motion[k] += foot->jacobian[MOTIONS * i + k] * velocities[foot->freedoms[i].index];
}

double foot_mu(const foot *foot, const double *state)
{
    if (!(state[STATE_HELD] > 0)) return foot->mu;
    const double aged = state[STATE_RESTED] > foot->ageing_t0 && foot->ageing_b > 0
                            ? foot->ageing_b * log(state[STATE_RESTED] / foot->ageing_t0)
                            : 0;
    return fmax(foot->mu_s + aged, foot->mu);
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
static void carry(const view *v, int body, double dt, const double point[3], carried *out)
{
    for (; body; body = v->body_parentid[body])
        for (int k = v->body_jntnum[body] - 1; k >= 0; k--) {
            const int joint = v->body_jntadr[body] + k, type = v->jnt_type[joint], first = v->jnt_dofadr[joint];
            const int shifts = type == JOINT_FREE ? 3 : type == JOINT_SLIDE;
            const int turns = type == JOINT_HINGE ? 1 : type == JOINT_SLIDE ? 0 : 3;
            double turn[3] = {0, 0, 0}, lever[3], tangent[3];
            for (int i = first + shifts; i < first + shifts + turns; i++)
                add_scaled3(turn, v->cdof + 6 * i, v->qvel[i] * dt);
            subtract3(lever, point, v->xanchor + 3 * joint);
            cross3(tangent, turn, lever);
            add_scaled3(out->straight, tangent, 1);
            add_scaled3(lever, out->shift, 1);
            add_turn(out->shift, turn, lever);
            for (int i = first; i < first + shifts; i++) {
                add_scaled3(out->shift, v->cdof + 6 * i + 3, v->qvel[i] * dt);
                add_scaled3(out->straight, v->cdof + 6 * i + 3, v->qvel[i] * dt);
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

void foot_bend(const foot *foot, const view *v, double dt, double bend[2])
{
    bend[0] = bend[1] = 0;
    if (foot->is_straight && !foot->is_conveyed) return;
    const double *origin = v->xpos + 3 * foot->bodies[0];
    carried own = {{0}, {0}}, under = {{0}, {0}};
    convey(foot, origin, dt, &under);
    carry(v, foot->bodies[0], dt, origin, &own);
    carry(v, foot->bodies[1], dt, origin, &under);
    double way[3], straight[3];
    subtract3(way, own.shift, under.shift);
    subtract3(straight, own.straight, under.straight);
    add_scaled3(way, straight, -1);
    foot_in_plane(foot, way, bend);
}

void foot_rows(foot *foot, const view *v)
{
    static const int along[3] = {ALONG_X, ALONG_Y, LIFT}, about[3] = {TILT_X, TILT_Y, SPIN};
    for (int side = 0; side < 2; side++) {
        const int body = foot->bodies[side];
        if (!foot->moves[side]) continue;
        const double sign = side == 0 ? 1 : -1, *inertia = v->ximat + 9 * body;
        double lever[3];
        subtract3(lever, foot->centre, v->xipos + 3 * body);
        for (int k = 0; k < 3; k++) {
            const double *axis = foot->axes + 3 * k;
            double moment[3], *shift = foot->rows[side] + 6 * along[k], *turn = foot->rows[side] + 6 * about[k];
            cross3(moment, lever, axis);
            for (int i = 0; i < 3; i++) {
                shift[i] = sign * axis[i];
                shift[3 + i] = sign * (inertia[i] * moment[0] + inertia[3 + i] * moment[1] + inertia[6 + i] * moment[2]);
                turn[i] = 0;
                turn[3 + i] = sign * (inertia[i] * axis[0] + inertia[3 + i] * axis[1] + inertia[6 + i] * axis[2]);
            }
        }
    }
}

void foot_row(const foot *foot, const double position[3], const double normal[3], double row[3])
{
    double lever[3], moment[3];
    subtract3(lever, position, foot->centre);
    cross3(moment, lever, normal);
    row[0] = 1;
    row[1] = dot3(moment, foot->axes);
    row[2] = dot3(moment, foot->axes + 3);
}

void foot_press(foot *foot, const double position[3], const double normal[3], double stiffness)
{
    double row[3];
    foot_row(foot, position, normal, row);
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
