#include "attached.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

struct attached {
    tribos_system *system;
    view view;
    contact_layout layout;
    double *states;
    double time;  // of the last step, s
};

#define NAMED(type, name) #type " " #name ";"

const char *attached_arrays(void) { return MODEL_ARRAYS(NAMED) DATA_ARRAYS(NAMED); }

#define TAKEN(type, name) v.name = *next++;

static view view_of(const simulation *of, double *states)
{
    view v = {.states = states, .solve = of->solve, .model = of->model, .data = of->data, .body_awake = of->body_awake,
              .nv = of->nv, .nbody = of->nbody, .ngeom = of->ngeom};
    void *const *next = of->arrays;
    MODEL_ARRAYS(TAKEN)
    DATA_ARRAYS(TAKEN)
    return v;
}

static bool take_foot(foot *foot, const given_foot *given)
{
    foot->geoms = malloc((size_t)given->geom_count * sizeof(int));
    foot->grounds = malloc(sizeof(int));
    if (!foot->geoms || !foot->grounds) return false;
    memcpy(foot->geoms, given->geoms, (size_t)given->geom_count * sizeof(int));
    foot->grounds[0] = given->ground;
    foot->geom_count = given->geom_count;
    foot->ground_count = 1;
    memcpy(foot->bodies, given->bodies, sizeof foot->bodies);
    foot->frame = (frame_kind)given->frame;
    foot->frame_index = given->frame_index;
    foot->mu = given->mu;
    foot->set = given->set;
    return true;
}

attached *attached_new(const simulation *of, const given_foot *feet, int count, link_result *result, link_fault *fault)
{
    *result = NO_MEMORY;
    attached *made = calloc(1, sizeof *made);
    if (!made) return NULL;
    made->system = system_new(count);
    made->states = calloc((size_t)count * STATE_SIZE, sizeof *made->states);
    made->view = view_of(of, made->states);
    made->layout = of->layout;
    made->time = -INFINITY;
    bool is_made = made->system && made->states;
    for (int i = 0; is_made && i < count; i++) {
        made->system->feet[i].state = i * STATE_SIZE;
        is_made = take_foot(made->system->feet + i, feet + i);
    }
    if (is_made) *result = system_link(made->system, &made->view, fault);
    if (*result == LINKED) return made;
    attached_free(made);
    return NULL;
}

void attached_free(attached *attached)
{
    if (!attached) return;
    system_free(attached->system);
    free(attached->states);
    free(attached);
}

static int integer_at(const char *contact, int place)
{
    int number;
    memcpy(&number, contact + place, sizeof number);
    return number;
}

static double number_at(const char *contact, int place)
{
    double number;
    memcpy(&number, contact + place, sizeof number);
    return number;
}

static const char *collect(attached *attached, const contacts *contacts)
{
    const contact_layout *at = &attached->layout;
    for (size_t i = 0; i < contacts->count; i++) {
        const char *found = contacts->first + i * (size_t)at->width;
        double position[3], frame[9], surface[3];
        contact contact = {.row = integer_at(found, at->row)};
        if (contact.row < 0 || (size_t)contact.row >= contacts->rows) continue;
        memcpy(contact.geoms, found + at->geoms, sizeof contact.geoms);
        memcpy(position, found + at->position, sizeof position);
        memcpy(frame, found + at->frame, sizeof frame);
        contact.dimension = integer_at(found, at->dimension);
        contact.position = position;
        contact.frame = frame;
        if (at->surface >= 0) contact.surface = memcpy(surface, found + at->surface, sizeof surface);
        contact.stiffness = contacts->stiffness[contact.row];
        memcpy(contact.spring, contacts->springs + 4 * contact.row, sizeof contact.spring);
        contact.gap = number_at(found, at->distance) - number_at(found, at->margin);
        const char *why = system_touch(attached->system, &contact);
        if (why) return why;
    }
    return NULL;
}

const char *attached_step(attached *attached, double time, double timestep, const contacts *contacts)
{
    tribos_system *system = attached->system;
    attached->view.timestep = timestep;
    // A simulation that was reset.
    if (time < attached->time) {
        memset(attached->states, 0, (size_t)system->count * STATE_SIZE * sizeof(double));
        system->is_current = false;
    }
    system_recall(system, &attached->view, time > attached->time);
    attached->time = time;
    system_begin(system, &attached->view);
    const char *why = collect(attached, contacts);
    if (why) return why;
    system_step(system, &attached->view);
    system_push(system, &attached->view);
    return NULL;
}

void attached_report(const attached *attached, int index, foot_report *out)
{
    const foot *foot = attached->system->feet + index;
    const double *state = attached->states + foot->state;
    memset(out, 0, sizeof *out);
    memcpy(out->axes, foot->axes, sizeof out->axes);
    memcpy(out->centre, foot->centre, sizeof out->centre);
    out->missed = state[STATE_MISSED] + foot->is_missed;
    if (foot->first < 0) return;
    out->load = state[STATE_LOAD];
    memcpy(out->friction, foot->friction, sizeof out->friction);
    memcpy(out->twist, foot->motion, sizeof out->twist);
    out->is_held = foot->is_held;
}
