/* Times one solver of Siconos on one contact problem u = W r + q.
 *
 *   race --list
 *       prints name and components of a contact of each solver; "+" marks options that are not the defaults.
 *   race PROBLEM SECONDS SOLVER STORAGE TOLERANCE REPETITIONS
 *       prints a line a repetition: ms, Siconos' status, impulses.
 *
 * PROBLEM is text: components, contacts, entries of W; row, column and value of each entry; q; for each contact the
 * friction coefficient and the rolling threshold. STORAGE is blocks, sparse or dense. A repetition that takes longer
 * than SECONDS of the processor ends the program with status 24; with 0 seconds there is no limit. Time is that of the
 * processor without a limit and that of the wall with one: the timer of a limit makes the processor's clock coarse.
 */
#define _GNU_SOURCE
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <time.h>
#include <unistd.h>

#include "FrictionContactProblem.h"
#include "Friction_cst.h"
#include "NonSmoothDrivers.h"
#include "NumericsMatrix.h"
#include "NumericsSparseMatrix.h"
#include "NumericsVerbose.h"
#include "RollingFrictionContactProblem.h"
#include "SolverOptions.h"
#include "SparseBlockMatrix.h"

enum { USAGE = 2, UNKNOWN = 3, OUT_OF_TIME = 24 };
enum { MOST_MEMORY_GB = 6 };

/* ------------------------------------------------------------------ solvers */

/* A solver: its number, components of a contact, most iterations, and what differs from its default options. */
typedef struct {
  const char *name;
  int id, size, most;
  int inner;           /* another inner solver, or 0 */
  int option, value;   /* an integer option, or 0 */
} Solver;

/* Bounds of iterations beyond what the time allows; solvers with an inner loop or a factorisation have less. */
enum { MANY = 10000000, OUTER = 100000, NEWTON = 2000 };

/* Left out: HP and NSGS with the quartic local solver do not return, NSGSV crashes, and SOCLCP solves the convex
 * problem without the term of De Saxce. */
static const Solver SOLVERS[] = {
  {"NSGS", SICONOS_FRICTION_3D_NSGS, 3, MANY},
  {"PROX", SICONOS_FRICTION_3D_PROX, 3, OUTER},
  {"TFP", SICONOS_FRICTION_3D_TFP, 3, OUTER},
  {"PFP", SICONOS_FRICTION_3D_PFP, 3, OUTER},
  {"ACLMFP", SICONOS_FRICTION_3D_ACLMFP, 3, OUTER},
  {"NSN_AC", SICONOS_FRICTION_3D_NSN_AC, 3, NEWTON},
  {"NSN_AC_TEST", SICONOS_FRICTION_3D_NSN_AC_TEST, 3, NEWTON},
  {"NSN_FB", SICONOS_FRICTION_3D_NSN_FB, 3, NEWTON},
  {"NSN_NM", SICONOS_FRICTION_3D_NSN_NM, 3, NEWTON},
  {"DSFP", SICONOS_FRICTION_3D_DSFP, 3, MANY},
  {"VI_FPP", SICONOS_FRICTION_3D_VI_FPP, 3, MANY},
  {"VI_EG", SICONOS_FRICTION_3D_VI_EG, 3, MANY},
  {"FPP", SICONOS_FRICTION_3D_FPP, 3, MANY},
  {"EG", SICONOS_FRICTION_3D_EG, 3, MANY},
  {"ADMM", SICONOS_FRICTION_3D_ADMM, 3, MANY},
  {"NSGS+pli", SICONOS_FRICTION_3D_NSGS, 3, MANY, SICONOS_FRICTION_3D_ONECONTACT_ProjectionOnConeWithLocalIteration},
  {"NSGS+nsn", SICONOS_FRICTION_3D_NSGS, 3, MANY, SICONOS_FRICTION_3D_ONECONTACT_NSN},
  {"NSGS+nsn_gp", SICONOS_FRICTION_3D_NSGS, 3, MANY, SICONOS_FRICTION_3D_ONECONTACT_NSN_GP},
  {"PROX+nsgs", SICONOS_FRICTION_3D_PROX, 3, OUTER, SICONOS_FRICTION_3D_NSGS},
  {"PROX+nsn_fb", SICONOS_FRICTION_3D_PROX, 3, OUTER, SICONOS_FRICTION_3D_NSN_FB},
  {"NSN_AC+hybrid", SICONOS_FRICTION_3D_NSN_AC, 3, NEWTON, 0,
   SICONOS_FRICTION_3D_NSN_HYBRID_STRATEGY, SICONOS_FRICTION_3D_NSN_HYBRID_STRATEGY_VI_EG_NSN},
  {"ADMM+symmetrize", SICONOS_FRICTION_3D_ADMM, 3, MANY, 0,
   SICONOS_FRICTION_3D_ADMM_IPARAM_SYMMETRY, SICONOS_FRICTION_3D_ADMM_SYMMETRIZE},
  {"NSGS", SICONOS_FRICTION_2D_NSGS, 2, MANY},
  {"CPG", SICONOS_FRICTION_2D_CPG, 2, MANY},
  {"LEMKE", SICONOS_FRICTION_2D_LEMKE, 2, OUTER},
  {"ENUM", SICONOS_FRICTION_2D_ENUM, 2, OUTER},
  {"NSGS", SICONOS_ROLLING_FRICTION_3D_NSGS, 5, MANY},
  {"NSGS+poc", SICONOS_ROLLING_FRICTION_3D_NSGS, 5, MANY, SICONOS_ROLLING_FRICTION_3D_ONECONTACT_ProjectionOnCone},
  {"ADMM", SICONOS_ROLLING_FRICTION_3D_ADMM, 5, MANY},
};
enum { COUNT = sizeof SOLVERS / sizeof *SOLVERS };

static const Solver *solver_of(const char *name, int size) {
  for (const Solver *s = SOLVERS; s < SOLVERS + COUNT; s++)
    if (s->size == size && !strcmp(s->name, name)) return s;
  return NULL;
}

/* Options of a solver with a tolerance. */
static SolverOptions *options(const Solver *s, double tolerance) {
  SolverOptions *o = solver_options_create(s->id);
  if (!o) exit(UNKNOWN);
  if (s->inner) solver_options_update_internal(o, 0, s->inner);
  if (s->option) o->iparam[s->option] = s->value;
  o->iparam[SICONOS_IPARAM_MAX_ITER] = s->most;
  o->dparam[SICONOS_DPARAM_TOL] = tolerance;
  return o;
}

/* ------------------------------------------------------------------ problem */

/* Entries of W are in the order of their rows. */
typedef struct {
  int size, contacts, n;
  long entries;
  int *row, *column;
  double *value, *q, *mu, *rolling;
  long *start;   /* first entry of each row, and the number of entries */
} Problem;

static void *room(size_t count, size_t size) {
  void *p = calloc(count ? count : 1, size);
  if (!p) exit(USAGE);
  return p;
}

static int read_problem(const char *path, Problem *p) {
  FILE *f = fopen(path, "r");
  if (!f || fscanf(f, "%d %d %ld", &p->size, &p->contacts, &p->entries) != 3) return 0;
  p->n = p->size * p->contacts;
  p->row = room(p->entries, sizeof(int));
  p->column = room(p->entries, sizeof(int));
  p->value = room(p->entries, sizeof(double));
  p->start = room(p->n + 1, sizeof(long));
  p->q = room(p->n, sizeof(double));
  p->mu = room(p->contacts, sizeof(double));
  p->rolling = room(p->contacts, sizeof(double));
  for (long k = 0; k < p->entries; k++) {
    if (fscanf(f, "%d %d %lf", p->row + k, p->column + k, p->value + k) != 3) return 0;
    p->start[p->row[k] + 1]++;
  }
  for (int i = 0; i < p->n; i++) p->start[i + 1] += p->start[i];
  for (int i = 0; i < p->n; i++)
    if (fscanf(f, "%lf", p->q + i) != 1) return 0;
  for (int c = 0; c < p->contacts; c++)
    if (fscanf(f, "%lf %lf", p->mu + c, p->rolling + c) != 2) return 0;
  fclose(f);
  return 1;
}

/* ----------------------------------------------------------------- matrices */

static NumericsMatrix *sparse(const Problem *p) {
  NumericsMatrix *m = NM_create(NM_SPARSE, p->n, p->n);
  NM_triplet_alloc(m, p->entries ? p->entries : 1);
  numericsSparseMatrix(m)->origin = NSM_TRIPLET;
  for (long k = 0; k < p->entries; k++) NM_entry(m, p->row[k], p->column[k], p->value[k]);
  return m;
}

static NumericsMatrix *dense(const Problem *p) {
  NumericsMatrix *m = NM_create(NM_DENSE, p->n, p->n);
  memset(m->matrix0, 0, sizeof(double) * p->n * p->n);
  for (long k = 0; k < p->entries; k++) m->matrix0[p->row[k] + (size_t)p->column[k] * p->n] += p->value[k];
  return m;
}

/* Marks the contacts that contact c depends on, itself included. */
static void neighbours(const Problem *p, int c, char *marked) {
  memset(marked, 0, p->contacts);
  marked[c] = 1;
  for (long k = p->start[c * p->size]; k < p->start[(c + 1) * p->size]; k++) marked[p->column[k] / p->size] = 1;
}

static NumericsMatrix *blocks(const Problem *p) {
  int d = p->size, count = p->contacts;
  char *marked = room(count, 1);
  size_t *place = room(count, sizeof(size_t)), filled = 0;
  for (int c = 0; c < count; c++) {
    neighbours(p, c, marked);
    for (int j = 0; j < count; j++) filled += marked[j];
  }
  SparseBlockStructuredMatrix *b = SBM_new();
  b->blocknumber0 = b->blocknumber1 = count;
  b->nbblocks = b->filled2 = filled;
  b->filled1 = count + 1;
  b->blocksize0 = room(count, sizeof(unsigned));
  b->blocksize1 = room(count, sizeof(unsigned));
  b->index1_data = room(count + 1, sizeof(size_t));
  b->index2_data = room(filled, sizeof(size_t));
  b->block = room(filled, sizeof(double *));
  filled = 0;
  for (int c = 0; c < count; c++) {
    b->blocksize0[c] = b->blocksize1[c] = (c + 1) * d;
    neighbours(p, c, marked);
    for (int j = 0; j < count; j++) {
      if (!marked[j]) continue;
      place[j] = filled;
      b->index2_data[filled] = j;
      b->block[filled++] = room(d * d, sizeof(double));
    }
    b->index1_data[c + 1] = filled;
    /* Blocks are stored by columns. */
    for (long k = p->start[c * d]; k < p->start[(c + 1) * d]; k++)
      b->block[place[p->column[k] / d]][p->row[k] % d + d * (p->column[k] % d)] += p->value[k];
  }
  free(marked);
  free(place);
  return NM_new_SBM(p->n, p->n, b);
}

static NumericsMatrix *matrix(const Problem *p, const char *storage) {
  if (!strcmp(storage, "blocks")) return blocks(p);
  if (!strcmp(storage, "sparse")) return sparse(p);
  if (!strcmp(storage, "dense")) return dense(p);
  exit(USAGE);
}

/* ------------------------------------------------------------------- timing */

static void out_of_time(int signal) {
  (void)signal;
  _exit(OUT_OF_TIME);
}

/* Ends the program after so many seconds of the processor; 0 for never. */
static void arm(double seconds) {
  struct itimerval timer = {{0, 0}, {(long)seconds, (long)((seconds - (long)seconds) * 1e6)}};
  setitimer(ITIMER_PROF, &timer, NULL);
}

static double milliseconds(double limit) {
  struct timespec t;
  clock_gettime(limit > 0 ? CLOCK_MONOTONIC : CLOCK_PROCESS_CPUTIME_ID, &t);
  return t.tv_sec * 1e3 + t.tv_nsec * 1e-6;
}

static double *copy(const double *from, int count) {
  double *to = room(count, sizeof(double));
  memcpy(to, from, sizeof(double) * count);
  return to;
}

/* Solves once from zero, with everything fresh: solvers change what they are given. Returns ms. */
static double solve(const Problem *p, NumericsMatrix *w, SolverOptions *o, double seconds, double *r, int *status) {
  double *u = room(p->n, sizeof(double)), from;
  if (p->size == 5) {
    RollingFrictionContactProblem *problem = rollingFrictionContactProblem_new();
    problem->dimension = p->size;
    problem->numberOfContacts = p->contacts;
    problem->M = w;
    problem->q = copy(p->q, p->n);
    problem->mu = copy(p->mu, p->contacts);
    problem->mu_r = copy(p->rolling, p->contacts);
    arm(seconds);
    from = milliseconds(seconds);
    *status = rolling_fc3d_driver(problem, r, u, o);
  } else {
    FrictionContactProblem *problem = frictionContactProblem_new();
    problem->dimension = p->size;
    problem->numberOfContacts = p->contacts;
    problem->M = w;
    problem->q = copy(p->q, p->n);
    problem->mu = copy(p->mu, p->contacts);
    arm(seconds);
    from = milliseconds(seconds);
    *status = p->size == 3 ? fc3d_driver(problem, r, u, o) : fc2d_driver(problem, r, u, o);
  }
  double taken = milliseconds(seconds) - from;
  arm(0);
  /* Problem and options stay until the program ends: some solvers free parts of them. */
  free(u);
  return taken;
}

static int list(void) {
  for (int k = 0; k < COUNT; k++) printf("%s %d\n", SOLVERS[k].name, SOLVERS[k].size);
  return 0;
}

int main(int count, char **words) {
  if (count == 2 && !strcmp(words[1], "--list")) return list();
  Problem p;
  if (count != 7 || !read_problem(words[1], &p)) return USAGE;
  double seconds = atof(words[2]), tolerance = atof(words[5]);
  const Solver *s = solver_of(words[3], p.size);
  if (!s) return UNKNOWN;
  /* Solvers print on their own: only we keep the output. */
  FILE *out = fdopen(dup(1), "w");
  int nowhere = open("/dev/null", O_WRONLY);
  dup2(nowhere, 1);
  dup2(nowhere, 2);
  numerics_set_verbose(0);
  struct rlimit memory = {(rlim_t)MOST_MEMORY_GB << 30, (rlim_t)MOST_MEMORY_GB << 30};
  setrlimit(RLIMIT_AS, &memory);
  signal(SIGPROF, out_of_time);
  for (int k = 0; k < atoi(words[6]); k++) {
    double *r = room(p.n, sizeof(double));
    int status;
    double taken = solve(&p, matrix(&p, words[4]), options(s, tolerance), seconds, r, &status);
    fprintf(out, "%.6f %d", taken, status);
    for (int i = 0; i < p.n; i++) fprintf(out, " %.17g", r[i]);
    fprintf(out, "\n");
    fflush(out);
    free(r);
  }
  /* No clean-up of the library: some of its solvers crash in it. */
  _exit(0);
}
