#include "model.h"

#include <ctype.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "patch.h"

_Static_assert(sizeof(mjtNum) == sizeof(double), "MuJoCo in single precision is not supported");
_Static_assert((int)JOINT_FREE == mjJNT_FREE && (int)JOINT_BALL == mjJNT_BALL && (int)JOINT_SLIDE == mjJNT_SLIDE &&
                   (int)JOINT_HINGE == mjJNT_HINGE,
               "the numbers of MuJoCo's joints");

// Where a refusal is written.
typedef struct refusal {
    char *why;
    size_t room;
} refusal;

static bool refuse(const refusal *to, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(to->why, to->room, format, arguments);
    va_end(arguments);
    return false;
}

static const char *name_of(const mjModel *m, int geom)
{
    const char *name = mj_id2name(m, mjOBJ_GEOM, geom);
    return name ? name : "(without name)";
}

// Appends the names of the model's named elements of a kind.
static void list_names(const mjModel *m, mjtObj kind, char *out, size_t room)
{
    const int count = kind == mjOBJ_GEOM ? m->ngeom : m->nsite;
    size_t used = 0;
    out[0] = 0;
    for (int i = 0; i < count && used < room; i++) {
        const char *name = mj_id2name(m, kind, i);
        if (!name) continue;
        const int more = snprintf(out + used, room - used, "%s\"%s\"", used ? ", " : "", name);
        if (more < 0) return;
        used += (size_t)more;
    }
    if (!used) snprintf(out, room, "none");
}

// Finds an element by its name. Names in attributes stay as they are where MuJoCo attaches a model to another and puts
// a prefix such as "left/" before all others, that of the instance among them.
static int find(const mjModel *m, int instance, mjtObj kind, const char *name, const refusal *to)
{
    const char *own = mj_id2name(m, mjOBJ_PLUGIN, instance);
    const char *slash = own ? strrchr(own, '/') : NULL;
    char prefixed[500];
    if (slash) {
        snprintf(prefixed, sizeof prefixed, "%.*s%s", (int)(slash + 1 - own), own, name);
        const int found = mj_name2id(m, kind, prefixed);
        if (found >= 0) return found;
    }
    const int found = mj_name2id(m, kind, name);
    if (found >= 0) return found;
    char names[300];
    list_names(m, kind, names, sizeof names);
    const char *what = kind == mjOBJ_GEOM ? "geom" : "site";
    refuse(to, "the model has no %s \"%s\"; its named %ss are: %s", what, name, what, names);
    return -1;
}

// Reads names of geoms, separated by white space.
static bool read_geoms(const mjModel *m, int instance, const char *key, const char *text, int **out,
                       int *count, const refusal *to)
{
    *out = malloc((strlen(text) / 2 + 1) * sizeof(int));
    char *copy = malloc(strlen(text) + 1);
    if (!*out || !copy) {
        free(copy);
        return refuse(to, "no memory for the names of geoms");
    }
    strcpy(copy, text);
    *count = 0;
    bool is_read = true;
    for (char *word = copy; is_read;) {
        while (isspace((unsigned char)*word)) word++;
        if (!*word) break;
        char *end = word;
        while (*end && !isspace((unsigned char)*end)) end++;
        const bool is_last = !*end;
        *end = 0;
        const int geom = find(m, instance, mjOBJ_GEOM, word, to);
        is_read = geom >= 0;
        for (int i = 0; is_read && i < *count; i++)
            if ((*out)[i] == geom) is_read = refuse(to, "%s names geom \"%s\" twice", key, word);
        if (is_read) (*out)[(*count)++] = geom;
        word = is_last ? end : end + 1;
    }
    free(copy);
    if (is_read && !*count)
        return refuse(to, "%s is missing: give the name of a geom, or of several separated by spaces", key);
    return is_read;
}

// The dimension of contacts of two geoms, by MuJoCo's rule; 0 where they have none.
static int contact_dimension(const mjModel *m, int a, int b)
{
    for (int i = 0; i < m->npair; i++) {
        const int first = m->pair_geom1[i], second = m->pair_geom2[i];
        if ((first == a && second == b) || (first == b && second == a)) return m->pair_dim[i];
    }
    if (!(m->geom_contype[a] & m->geom_conaffinity[b]) &&
        !(m->geom_contype[b] & m->geom_conaffinity[a]))
        return 0;
    const int difference = m->geom_priority[a] - m->geom_priority[b];
    if (difference) return m->geom_condim[difference > 0 ? a : b];
    return m->geom_condim[a] > m->geom_condim[b] ? m->geom_condim[a] : m->geom_condim[b];
}

static bool check_contacts(const mjModel *m, const foot *foot, const refusal *to)
{
    for (int i = 0; i < foot->geom_count; i++)
        for (int j = 0; j < foot->ground_count; j++) {
            const int geom = foot->geoms[i], ground = foot->grounds[j];
            const char *name = name_of(m, geom), *other = name_of(m, ground);
            const int dimension = contact_dimension(m, geom, ground);
            if (dimension == 0)
                return refuse(to, "geoms \"%s\" and \"%s\" never touch: their contype and conaffinity exclude "
                                  "each other, and there is no contact pair", name, other);
            if (dimension != 1)
                return refuse(to, "contacts of geoms \"%s\" and \"%s\" have friction of MuJoCo's own (condim %d): "
                                  "give \"%s\" condim=\"1\" and a higher priority than \"%s\", or both condim=\"1\", "
                                  "or a contact pair with condim=\"1\"",
                              name, other, dimension, name, other);
        }
    return true;
}

// Checks that all geoms of a side are of one body, or are fixed to each other.
static bool check_side(const mjModel *m, const char *key, const int *geoms, int count, int *body,
                       const refusal *to)
{
    const int first = m->geom_bodyid[geoms[0]];
    *body = m->body_weldid[first];
    for (int i = 1; i < count; i++)
        if (m->body_weldid[m->geom_bodyid[geoms[i]]] != *body)
            return refuse(to, "the geoms of %s must be of one body: \"%s\" and \"%s\" move apart", key,
                          name_of(m, geoms[0]), name_of(m, geoms[i]));
    return true;
}

static bool read_frame(const mjModel *m, foot *foot, const char *site, const refusal *to)
{
    if (*site) {
        foot->frame = FRAME_SITE;
        foot->frame_index = find(m, foot->instance, mjOBJ_SITE, site, to);
        if (foot->frame_index < 0) return false;
        if (m->body_weldid[m->site_bodyid[foot->frame_index]] != foot->bodies[0])
            return refuse(to, "site \"%s\" is not on the body of the foot", site);
    } else if (foot->geom_count == 1) {
        foot->frame = FRAME_GEOM;
        foot->frame_index = foot->geoms[0];
    } else {
        foot->frame = FRAME_BODY;
        foot->frame_index = foot->bodies[0];
    }
    return true;
}

// The coefficients, of which those at rest may be left out.
static bool read_coefficients(foot *foot, const char *mu, const char *mu_s, const char *growth, const char *cut_off,
                              const refusal *to)
{
    if (read_numbers(mu, &foot->mu, 1) != 1 || !(foot->mu >= 0) || isinf(foot->mu))
        return refuse(to, "mu must be one number >= 0 and finite, not \"%s\"", mu);
    foot->mu_s = foot->mu;
    if (*mu_s && (read_numbers(mu_s, &foot->mu_s, 1) != 1 || !(foot->mu_s >= foot->mu) || isinf(foot->mu_s)))
        return refuse(to, "mu_s, the coefficient at rest, must be one number >= mu and finite, not \"%s\"", mu_s);
    if (!*growth != !*cut_off)
        return refuse(to, "friction that ages has both ageing_b and ageing_t0: mu_s + b ln(t/t0)%s", "");
    if (!*growth) return true;
    if (read_numbers(growth, &foot->ageing_b, 1) != 1 || !(foot->ageing_b >= 0) || isinf(foot->ageing_b))
        return refuse(to, "ageing_b must be one number >= 0 and finite, not \"%s\"", growth);
    if (read_numbers(cut_off, &foot->ageing_t0, 1) != 1 || !(foot->ageing_t0 > 0) || isinf(foot->ageing_t0))
        return refuse(to, "ageing_t0 must be one time in s, > 0 and finite, not \"%s\"", cut_off);
    return true;
}

static bool read_foot(const mjModel *m, foot *foot, const refusal *to)
{
    static const char *const keys[] = ATTRIBUTES;
    enum { COUNT = sizeof keys / sizeof *keys };
    const char *texts[COUNT];
    for (int i = 0; i < COUNT; i++) {
        texts[i] = mj_getPluginConfig(m, foot->instance, keys[i]);
        if (!texts[i]) texts[i] = "";
    }
    const char *geom = texts[0], *ground = texts[1], *site = texts[2], *mu = texts[6];
    if (!read_geoms(m, foot->instance, "geom", geom, &foot->geoms, &foot->geom_count, to) ||
        !read_geoms(m, foot->instance, "ground", ground, &foot->grounds, &foot->ground_count, to) ||
        !check_side(m, "geom", foot->geoms, foot->geom_count, &foot->bodies[0], to) ||
        !check_side(m, "ground", foot->grounds, foot->ground_count, &foot->bodies[1], to))
        return false;
    if (foot->bodies[0] == foot->bodies[1])
        return refuse(to, "geom \"%s\" and ground \"%s\" are of one body", geom, ground);
    if (!*texts[3]) return refuse(to, "patch is missing: give one of " PATCH_NAMES);
    patch *patch = calloc(1, sizeof *patch);
    if (!patch) return refuse(to, "no memory for a patch");
    foot->set = &patch->set;
    if (!patch_read(patch, texts[3], texts[4], texts[5], to->why, to->room)) return false;
    if (!read_coefficients(foot, mu, texts[7], texts[8], texts[9], to)) return false;
    return read_frame(m, foot, site, to) && check_contacts(m, foot, to);
}

// MuJoCo's factors of the mass.
static void solve(const void *m, void *d, double *x, const double *y, int count) { mj_solveM(m, d, x, y, count); }

static bool check_options(const mjModel *m, const refusal *to)
{
    if (m->opt.integrator == mjINT_RK4)
        return refuse(to, "the integrator RK4 evaluates forces within a step: choose Euler, implicit or "
                          "implicitfast");
#if mjVERSION_HEADER >= 336
    const int both = mjDSBL_SPRING | mjDSBL_DAMPER;
    if ((m->opt.disableflags & both) == both)
#else
    if (m->opt.disableflags & mjDSBL_PASSIVE)
#endif
        return refuse(to, "passive forces are disabled in the options of the model, and friction is one");
    return true;
}

// What is wrong with feet that each may be right.
static bool refuse_link(const mjModel *m, const tribos_system *system, link_result result, const link_fault *fault,
                        const refusal *to)
{
    switch (result) {
    case LINKED: return true;
    case NO_MEMORY: return refuse(to, "no memory for %d feet", system->count);
    case NEVER_MOVES: return refuse(to, "the foot never moves on its ground: neither body has a joint");
    case CLAIMED_TWICE: break;
    }
    const char *name = mj_id2name(m, mjOBJ_PLUGIN, system->feet[fault->other].instance);
    return refuse(to, "geom \"%s\" and ground \"%s\" have the friction of instance \"%s\" already",
                  name_of(m, fault->geom), name_of(m, fault->ground), name ? name : "");
}

tribos_system *feet_new(const mjModel *m, int lead, int *blamed, char *why, size_t room)
{
    const refusal to = {why, room};
    *blamed = lead;
    int count = 0;
    for (int i = lead; i < m->nplugin; i++) count += m->plugin[i] == m->plugin[lead];
    tribos_system *system = system_new(count);
    bool is_made = system || refuse(&to, "no memory for feet");
    is_made = is_made && check_options(m, &to);
    for (int i = lead, at = 0; is_made && i < m->nplugin; i++) {
        if (m->plugin[i] != m->plugin[lead]) continue;
        foot *foot = system->feet + at++;
        *blamed = foot->instance = i;
        foot->state = m->plugin_stateadr[i];
        is_made = read_foot(m, foot, &to);
    }
    if (is_made) {
        const view v = view_of(m, NULL);
        link_fault fault = {0};
        const link_result result = system_link(system, &v, &fault);
        if (result != LINKED) *blamed = system->feet[fault.foot].instance;
        is_made = refuse_link(m, system, result, &fault, &to);
    }
    if (is_made) return system;
    feet_free(system);
    return NULL;
}

void feet_free(tribos_system *system)
{
    for (int i = 0; system && i < system->count; i++) {
        patch *patch = (struct patch *)system->feet[i].set;
        if (patch) patch_free(patch);
        free(patch);
    }
    system_free(system);
}

#define OF_MODEL(type, name) v.name = m->name;
#define OF_DATA(type, name) v.name = d->name;

view view_of(const mjModel *m, mjData *d)
{
    view v = {.solve = solve, .model = m, .data = d, .timestep = m->opt.timestep,
              .nv = (int)m->nv, .nbody = (int)m->nbody, .ngeom = (int)m->ngeom};
    MODEL_ARRAYS(OF_MODEL)
    if (!d) return v;
    DATA_ARRAYS(OF_DATA)
#if mjVERSION_HEADER >= 340
    if (m->opt.enableflags & mjENBL_SLEEP) v.body_awake = d->body_awake;
#endif
    v.states = d->plugin_state;
    return v;
}
