#include "model.h"

#include <ctype.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

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

// The degrees of freedom of foot and ground; those that move both alike do not move the foot on its ground.
static bool read_freedoms(const mjModel *m, foot *foot, const refusal *to)
{
    foot->freedoms = malloc((size_t)(m->nv + 1) * sizeof *foot->freedoms);
    foot->jacobian = malloc((size_t)(m->nv + 1) * MOTIONS * sizeof(double));
    if (!foot->freedoms || !foot->jacobian) return refuse(to, "no memory for degrees of freedom");
    for (int side = 0; side < 2; side++)
        for (int body = foot->bodies[side]; body > 0; body = m->body_parentid[body])
            for (int k = 0; k < m->body_dofnum[body]; k++) {
                const int index = m->body_dofadr[body] + k;
                int at = 0;
                while (at < foot->freedom_count && foot->freedoms[at].index != index) at++;
                if (at < foot->freedom_count) {
                    foot->freedoms[at] = foot->freedoms[--foot->freedom_count];
                    continue;
                }
                const freedom made = {index, m->body_rootid[m->dof_bodyid[index]],
                                      side == 0 ? 1 : -1};
                foot->freedoms[foot->freedom_count++] = made;
            }
    if (!foot->freedom_count)
        return refuse(to, "the foot never moves on its ground: neither body has a joint");
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
    for (int side = 0; side < 2; side++) foot->moves[side] = foot->bodies[side] != 0;
    int jointed = foot->bodies[0];
    while (jointed && !m->body_jntnum[jointed]) jointed = m->body_parentid[jointed];
    foot->is_afloat = jointed && m->jnt_type[m->body_jntadr[jointed]] == mjJNT_FREE;
    if (foot->bodies[0] == foot->bodies[1])
        return refuse(to, "geom \"%s\" and ground \"%s\" are of one body", geom, ground);
    if (!*texts[3]) return refuse(to, "patch is missing: give one of " PATCH_NAMES);
    if (!patch_read(&foot->patch, texts[3], texts[4], texts[5], to->why, to->room)) return false;
    if (read_numbers(mu, &foot->mu, 1) != 1 || !(foot->mu >= 0) || isinf(foot->mu))
        return refuse(to, "mu must be one number >= 0 and finite, not \"%s\"", mu);
    return read_frame(m, foot, site, to) && read_freedoms(m, foot, to) && check_contacts(m, foot, to);
}

// Links each geom to its feet; a pair of geoms belongs to one foot alone.
static bool link_geoms(tribos_system *system, const mjModel *m, int *blamed, const refusal *to)
{
    int total = 0;
    for (int i = 0; i < system->count; i++) total += system->feet[i].geom_count;
    system->geom_first = malloc((size_t)(m->ngeom + 1) * sizeof(int));
    system->memberships = malloc((size_t)total * sizeof *system->memberships);
    if (!system->geom_first || !system->memberships) return refuse(to, "no memory for geoms");
    for (int i = 0; i < m->ngeom; i++) system->geom_first[i] = -1;
    int made = 0;
    for (int i = 0; i < system->count; i++) {
        const foot *foot = system->feet + i;
        *blamed = foot->instance;
        for (int j = 0; j < foot->geom_count; j++) {
            const int geom = foot->geoms[j];
            system->memberships[made] = (membership){i, system->geom_first[geom]};
            system->geom_first[geom] = made++;
        }
    }
    for (int i = 0; i < system->count; i++)
        for (int j = 0; j < system->feet[i].geom_count; j++)
            for (int k = 0; k < system->feet[i].ground_count; k++) {
                const int geom = system->feet[i].geoms[j], ground = system->feet[i].grounds[k];
                const int ends[2][2] = {{geom, ground}, {ground, geom}};
                for (int way = 0; way < 2; way++)
                    for (int at = system->geom_first[ends[way][0]]; at >= 0;
                         at = system->memberships[at].next) {
                        const int other = system->memberships[at].foot;
                        if (other >= i) continue;
                        for (int l = 0; l < system->feet[other].ground_count; l++) {
                            if (system->feet[other].grounds[l] != ends[way][1]) continue;
                            *blamed = system->feet[i].instance;
                            const char *name = mj_id2name(m, mjOBJ_PLUGIN, system->feet[other].instance);
                            return refuse(to, "geom \"%s\" and ground \"%s\" have the friction of instance \"%s\" "
                                              "already", name_of(m, geom), name_of(m, ground), name ? name : "");
                        }
                    }
            }
    return true;
}

static bool shares_tree(const foot *a, const foot *b)
{
    for (int i = 0; i < a->freedom_count; i++)
        for (int j = 0; j < b->freedom_count; j++)
            if (a->freedoms[i].root == b->freedoms[j].root) return true;
    return false;
}

static bool is_free(const mjModel *m, const foot *foot)
{
    for (int side = 0; side < 2; side++) {
        if (foot->moves[side] && !body_is_free(m, foot->bodies[side])) return false;
    }
    return true;
}

// Puts feet that move each other into groups.
static bool link_groups(tribos_system *system, const mjModel *m, const refusal *to)
{
    const int count = system->count;
    int *label = malloc((size_t)count * sizeof(int));
    system->groups = calloc((size_t)m->nplugin, sizeof *system->groups);
    if (!label || !system->groups) {
        free(label);
        return refuse(to, "no memory for feet");
    }
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
            return refuse(to, "no memory for feet");
        }
        group->is_free = true;
        for (int j = 0, at = 0; j < count; j++) {
            if (label[j] != i) continue;
            group->feet[at++] = j;
            group->is_free = group->is_free && is_free(m, system->feet + j);
        }
        if (group->count > largest) largest = group->count;
        system->group_count++;
    }
    free(label);
    system->scratch = malloc(system_scratch(largest));
    return system->scratch ? true : refuse(to, "no memory for a step of %d feet", largest);
}

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

tribos_system *system_new(const mjModel *m, int lead, int *blamed, char *why, size_t room)
{
    const refusal to = {why, room};
    *blamed = lead;
    tribos_system *system = calloc(1, sizeof *system);
    if (system) system->feet = calloc((size_t)m->nplugin, sizeof *system->feet);
    bool is_made = system && system->feet;
    if (!is_made) refuse(&to, "no memory for feet");
    is_made = is_made && check_options(m, &to);
    for (int i = lead; is_made && i < m->nplugin; i++) {
        if (m->plugin[i] != m->plugin[lead]) continue;
        foot *foot = system->feet + system->count++;
        *blamed = foot->instance = i;
        foot->state = m->plugin_stateadr[i];
        is_made = read_foot(m, foot, &to);
    }
    is_made = is_made && link_geoms(system, m, blamed, &to) && link_groups(system, m, &to);
    if (is_made) return system;
    system_free(system);
    return NULL;
}

void system_free(tribos_system *system)
{
    if (!system) return;
    for (int i = 0; system->feet && i < system->count; i++) {
        foot *foot = system->feet + i;
        free(foot->geoms);
        free(foot->grounds);
        free(foot->freedoms);
        free(foot->jacobian);
        patch_free(&foot->patch);
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
    to->patch = own.patch;
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
