#include "patch.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

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

static bool read_disk(patch *out, const char *size, char *why, size_t room)
{
    if (read_numbers(size, &out->radius, 1) != 1 || !is_positive(out->radius))
        return refuse(why, room, "size of a disk is its radius in m, > 0 and finite, not \"%s\"", size);
    out->kind = PATCH_DISK;
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

static bool read_polygon(patch *out, const char *text, char *why, size_t room)
{
    const int count = read_numbers(text, NULL, 0);
    if (count < 6 || count % 2)
        return refuse(why, room,
                      "corners of a polygon are three or more pairs x y in m, not \"%s\"", text);
    tribos_point_f64 *corners = malloc((size_t)count * sizeof(double));
    if (!corners) return refuse(why, room, "no memory for corners%s", "");
    read_numbers(text, &corners->x, count);
    const bool is_made = make_polygon(out, corners, (size_t)count / 2, why, room);
    free(corners);
    return is_made;
}

// Largest torque per force about the origin.
static double arm(const patch *patch)
{
    const tribos_twist_f64 turn = {0, 0, 1};
    tribos_wrench_f64 wrench = {NAN, NAN, NAN};
    if (patch->kind == PATCH_DISK) {
        const tribos_disk_surface_f64 surface = {1, patch->radius};
        tribos_disk_surface_wrench_f64(&surface, &turn, &wrench);
    } else {
        tribos_polygon_wrench_f64(&patch->polygon, 1, 1, &turn, &wrench);
    }
    return fabs(wrench.torque);
}

bool patch_read(patch *out, const char *kind, const char *size, const char *corners, char *why,
                size_t room)
{
    memset(out, 0, sizeof *out);
    const bool is_polygon = strcmp(kind, "polygon") == 0;
    if (!is_polygon && *corners)
        return refuse(why, room, "corners are for patch \"polygon\", not for \"%s\"", kind);
    if (is_polygon && *size)
        return refuse(why, room, "a polygon has corners and no size: leave out size \"%s\"", size);
    bool is_read;
    if (strcmp(kind, "disk") == 0)
        is_read = read_disk(out, size, why, room);
    else if (strcmp(kind, "box") == 0)
        is_read = read_box(out, size, why, room);
    else if (is_polygon)
        is_read = read_polygon(out, corners, why, room);
    else
        return refuse(why, room, "patch must be \"disk\", \"box\" or \"polygon\", not \"%s\"", kind);
    if (is_read) out->arm = arm(out);
    return is_read;
}

void patch_free(patch *patch)
{
    free(patch->edges);
    patch->edges = NULL;
}

void patch_project(const patch *patch, double force_limit, const double wrench[3], double length,
                   double nearest[3])
{
    const tribos_wrench_f64 given = {wrench[0], wrench[1], wrench[2]};
    tribos_projection_f64 found = {.wrench = {NAN, NAN, NAN}};
    if (patch->kind == PATCH_DISK) {
        const tribos_disk_surface_f64 surface = {force_limit, patch->radius};
        tribos_disk_surface_project_f64(&surface, &given, length, &found);
    } else {
        tribos_polygon_project_f64(&patch->polygon, force_limit, &given, length, &found);
    }
    nearest[0] = found.wrench.x;
    nearest[1] = found.wrench.y;
    nearest[2] = found.wrench.torque;
}
