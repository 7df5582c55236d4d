// What a step reads of MuJoCo's model and data, by MuJoCo's names. Each version of MuJoCo lays its structures out in
// another way: here are the arrays, which whoever knows the version points to.
#ifndef TRIBOS_MUJOCO_VIEW_H
#define TRIBOS_MUJOCO_VIEW_H

#define MODEL_ARRAYS(OF)                                                                             \
    OF(const int, body_parentid) OF(const int, body_rootid) OF(const int, body_dofnum)               \
    OF(const int, body_dofadr) OF(const int, body_jntnum) OF(const int, body_jntadr)                 \
    OF(const int, jnt_type) OF(const int, jnt_dofadr) OF(const double, body_mass)                    \
    OF(const double, body_inertia) OF(const double, dof_armature)
#define DATA_ARRAYS(OF)                                                                              \
    OF(const double, qvel) OF(const double, qacc) OF(double, qfrc_passive) OF(const double, cdof)    \
    OF(const double, subtree_com) OF(const double, xpos) OF(const double, xmat)                      \
    OF(const double, xipos) OF(const double, ximat) OF(const double, xanchor)                        \
    OF(const double, geom_xpos) OF(const double, geom_xmat) OF(const double, site_xpos)              \
    OF(const double, site_xmat)
#define MEMBER(type, name) type *name;

typedef struct view {
    MODEL_ARRAYS(MEMBER)
    DATA_ARRAYS(MEMBER)
    const int *body_awake;  // 0 of a body that sleeps; NULL where none can
    double *states;         // memory of the feet, STATE_SIZE numbers each

    // x = M^-1 y for `count` rows of nv numbers, as mj_solveM.
    void (*solve)(const void *model, void *data, double *x, const double *y, int count);
    const void *model;
    void *data;

    double timestep;
    int nv, nbody, ngeom;
} view;

#endif
