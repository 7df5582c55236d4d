#include "patch.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// Shares of force and torque that are rounding.
#define NONE 1e-12

int read_numbers(const char *text, double *out, int room)
{
    int count = 0;
    for (;;) {
        while (isspace((unsigned char)*text)) text++;
        if (*text == 0) return count;
        char *end;
        const double number = strtod(text, &end);
        if (end == text || (*end && !isspace((unsigned char)*end))) return -1;
        if (count < room) out[count] = number;
        count++;
        text = end;
    }
}

static bool refuse(char *why, size_t room, const char *what, const char *text)
{
    snprintf(why, room, what, text);
    return false;
}

static bool is_positive(double number) { return number > 0 && isfinite(number); }

static bool read_round(patch *out, patch_kind kind, const char *size, char *why, size_t room)
{
    if (read_numbers(size, &out->radius, 1) != 1 || !is_positive(out->radius))
        return refuse(why, room, "size of a round patch is its radius in m, > 0 and finite, not \"%s\"", size);
    out->kind = kind;
    return true;
}

static bool read_annulus(patch *out, const char *size, char *why, size_t room)
{
    double radii[2];
    if (read_numbers(size, radii, 2) != 2 || !is_positive(radii[1]) ||
        !(radii[0] >= 0 && radii[0] <= 0.999999 * radii[1]))
        return refuse(why, room,
                      "size of an annulus is its inner and outer radius in m, 0 <= inner <= 0.999999 outer, not "
                      "\"%s\" (patch \"ring\" is the limit of a thin one)", size);
    out->kind = PATCH_ANNULUS;
    out->radius = radii[1];
    out->inner_ratio = radii[0] / radii[1];
    return true;
}

// A polygon with these corners, which may be given clockwise or counterclockwise.
static bool make_polygon(patch *out, const tribos_point_f64 *corners, size_t count, char *why,
                         size_t room)
{
    out->kind = PATCH_POLYGON;
    out->edges = malloc(count * sizeof *out->edges);
    if (!out->edges) return refuse(why, room, "no memory for corners%s", "");
    const tribos_status status =
        tribos_polygon_new_f64(corners, &count, 1, out->edges, count, &out->polygon);
    if (status == TRIBOS_STATUS_OK) return true;
    patch_free(out);
    return refuse(why, room, "the corners do not make a patch: %s", tribos_status_text(status));
}

static bool read_box(patch *out, const char *size, char *why, size_t room)
{
    double half[2];
    if (read_numbers(size, half, 2) != 2 || !is_positive(half[0]) || !is_positive(half[1]))
        return refuse(why, room,
                      "size of a box is its two half lengths in m, > 0 and finite, not \"%s\"", size);
    const double x = half[0], y = half[1];
    const tribos_point_f64 corners[4] = {{x, y}, {-x, y}, {-x, -y}, {x, -y}};
    return make_polygon(out, corners, 4, why, room);
}

// Reads pairs of numbers; NULL with the reason in `why`.
static tribos_point_f64 *read_corners(const char *text, int least, size_t *count, char *why,
                                      size_t room)
{
    const int numbers = read_numbers(text, NULL, 0);
    if (numbers < 2 * least || numbers % 2) {
        refuse(why, room,
               least == 3 ? "corners of a polygon are three or more pairs x y in m, not \"%s\""
                          : "corners of patch \"points\" are two or more pairs x y in m, not \"%s\"", text);
        return NULL;
    }
    tribos_point_f64 *corners = malloc((size_t)numbers * sizeof(double));
    if (!corners) refuse(why, room, "no memory for corners%s", "");
    else read_numbers(text, &corners->x, numbers);
    *count = (size_t)numbers / 2;
    return corners;
}

static bool read_polygon(patch *out, const char *text, char *why, size_t room)
{
    size_t count;
    tribos_point_f64 *corners = read_corners(text, 3, &count, why, room);
    if (!corners) return false;
    const bool is_made = make_polygon(out, corners, count, why, room);
    free(corners);
    return is_made;
}

static bool read_points(patch *out, const char *text, char *why, size_t room)
{
    size_t count;
    tribos_point_f64 *corners = read_corners(text, 2, &count, why, room);
    if (!corners) return false;
    out->kind = PATCH_POINTS;
    out->node_count = count;
    out->nodes = malloc(count * sizeof *out->nodes);
    for (size_t i = 0; out->nodes && i < count; i++)
        out->nodes[i] = (tribos_node_f64){corners[i].x, corners[i].y, 1};
    free(corners);
    if (!out->nodes) return refuse(why, room, "no memory for points%s", "");
    // The surface checks the points.
    const tribos_wrench_f64 none = {0, 0, 0};
    double gauge;
    const tribos_status status = tribos_nodes_gauge_f64(out->nodes, count, 1, &none, &gauge);
    if (status == TRIBOS_STATUS_OK) return true;
    patch_free(out);
    return refuse(why, room, "the points do not make a patch: %s",
                  status == TRIBOS_STATUS_FEET_IN_LINE ? "all are in one place" : tribos_status_text(status));
}

static void oppose(const friction_set *set, double force_limit, const double motion[3], double friction[3])
{
    const patch *patch = (const struct patch *)set;
    const tribos_round_f64 round = {1, patch->radius};
    const tribos_coulomb_f64 law = {1};
    const tribos_twist_f64 twist = {motion[0], motion[1], motion[2]};
    tribos_wrench_f64 wrench = {NAN, NAN, NAN};
    switch (patch->kind) {
    case PATCH_DISK: tribos_disk_wrench_f64(&round, force_limit, &twist, &wrench); break;
    case PATCH_ANNULUS:
        tribos_annulus_wrench_f64(&round, patch->inner_ratio, force_limit, &twist, &wrench);
        break;
    case PATCH_RING: tribos_ring_wrench_f64(&round, force_limit, &twist, &wrench); break;
    case PATCH_HERTZ: tribos_hertz_wrench_f64(&round, force_limit, &twist, &wrench); break;
    case PATCH_PUNCH: tribos_punch_wrench_f64(&round, force_limit, &twist, &wrench); break;
    case PATCH_POLYGON: tribos_polygon_wrench_f64(&patch->polygon, 1, force_limit, &twist, &wrench); break;
    case PATCH_POINTS:
        tribos_nodes_coulomb_wrench_f64(&law, patch->nodes, patch->node_count, force_limit, &twist, &wrench);
        break;
    }
    friction[0] = wrench.x;
    friction[1] = wrench.y;
    friction[2] = wrench.torque;
}

// Largest torque per force about the origin, and whether the patch is even there.
static void set_arm(patch *patch)
{
    static const double motions[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    double friction[3][3];
    for (int k = 0; k < 3; k++) oppose(&patch->set, 1, motions[k], friction[k]);
    const double *x = friction[0], *y = friction[1], *spin = friction[2];
    patch->set.arm = fabs(spin[2]);
    patch->is_even = fmax(fabs(x[2]), fabs(y[2])) <= NONE * patch->set.arm && fmax(fabs(spin[0]), fabs(spin[1])) <= NONE;
}

// Whether a wrench lies between all forces without torque and the largest torques without force, surely inside of the set of
// an even patch.
static bool is_within(const patch *patch, double force_limit, const double wrench[3])
{
    const double left = (1 - NONE) * force_limit - fabs(wrench[2]) / patch->set.arm;
    return patch->is_even && left >= 0 && wrench[0] * wrench[0] + wrench[1] * wrench[1] <= left * left;
}

static void project(const friction_set *set, double force_limit, const double wrench[3], double length,
                    double nearest[3])
{
    const patch *patch = (const struct patch *)set;
    if (is_within(patch, force_limit, wrench)) {
        if (nearest != wrench) memcpy(nearest, wrench, 3 * sizeof(double));
        return;
    }
    const tribos_wrench_f64 given = {wrench[0], wrench[1], wrench[2]};
    const tribos_disk_surface_f64 disk = {force_limit, patch->radius};
    const tribos_round_f64 round = {1, patch->radius};
    tribos_projection_f64 found = {.wrench = {NAN, NAN, NAN}};
    switch (patch->kind) {
    case PATCH_DISK: tribos_disk_surface_project_f64(&disk, &given, length, &found); break;
    case PATCH_ANNULUS:
        tribos_annulus_project_f64(&round, patch->inner_ratio, force_limit, &given, length, &found);
        break;
    case PATCH_RING: tribos_ring_project_f64(&round, force_limit, &given, length, &found); break;
    case PATCH_HERTZ: tribos_hertz_project_f64(&round, force_limit, &given, length, &found); break;
    case PATCH_PUNCH: tribos_punch_project_f64(&round, force_limit, &given, length, &found); break;
    case PATCH_POLYGON:
        tribos_polygon_project_f64(&patch->polygon, force_limit, &given, length, &found);
        break;
    case PATCH_POINTS:
        tribos_nodes_project_f64(patch->nodes, patch->node_count, force_limit, &given, length, &found);
        break;
    }
    nearest[0] = found.wrench.x;
    nearest[1] = found.wrench.y;
    nearest[2] = found.wrench.torque;
}

bool patch_read(patch *out, const char *kind, const char *size, const char *corners, char *why,
                size_t room)
{
    static const struct {
        const char *name;
        patch_kind kind;
    } rounds[] = {{"disk", PATCH_DISK}, {"ring", PATCH_RING}, {"hertz", PATCH_HERTZ}, {"punch", PATCH_PUNCH}};
    memset(out, 0, sizeof *out);
    const bool is_polygon = strcmp(kind, "polygon") == 0, is_points = strcmp(kind, "points") == 0;
    if (!is_polygon && !is_points && *corners)
        return refuse(why, room, "corners are for patches \"polygon\" and \"points\", not for \"%s\"", kind);
    if ((is_polygon || is_points) && *size)
        return refuse(why, room, "this patch has corners and no size: leave out size \"%s\"", size);
    bool is_known = true, is_read = false;
    if (is_polygon)
        is_read = read_polygon(out, corners, why, room);
    else if (is_points)
        is_read = read_points(out, corners, why, room);
    else if (strcmp(kind, "box") == 0)
        is_read = read_box(out, size, why, room);
    else if (strcmp(kind, "annulus") == 0)
        is_read = read_annulus(out, size, why, room);
    else {
        is_known = false;
        for (size_t i = 0; i < sizeof rounds / sizeof *rounds && !is_known; i++) {
            if (strcmp(kind, rounds[i].name) != 0) continue;
            is_known = true;
            is_read = read_round(out, rounds[i].kind, size, why, room);
        }
    }
    if (!is_known) return refuse(why, room, "patch must be one of " PATCH_NAMES ", not \"%s\"", kind);
    if (is_read) {
        out->set = (friction_set){project, oppose, 0};
        set_arm(out);
    }
    return is_read;
}

void patch_free(patch *patch)
{
    free(patch->edges);
    free(patch->nodes);
    patch->edges = NULL;
    patch->nodes = NULL;
}
