// How feet of a group accelerate by wrenches on each of them.
#ifndef TRIBOS_MUJOCO_COMPLIANCE_H
#define TRIBOS_MUJOCO_COMPLIANCE_H

#include "foot.h"

// Numbers of a mobility, of a compliance, and of the scratch memory of `find_compliance` and of `find_mobility`.
#define MOBILITY(count) (36 * (count) * (count))
#define COMPLIANCE(count) (9 * (count) * (count))
#define SPRINGS(count) (18 * (count) * (count))
#define ROWS(count, nv) (12 * (count) * (nv))

// Acceleration of each foot in its six motions by unit wrenches on each: a row-major 6 x 6 block for each pair.
// `scratch` is for bodies that do not move freely.
void find_mobility(const view *v, foot **feet, int count, bool is_free, double *scratch, double *mobility);

// Acceleration in the contact planes that unit friction gives while the normal forces respond: the mobility less
// what the springs of the contacts take, P - M K (1 + N K)^-1 M^T, in its blocks P in the plane, N along the
// normals, M between them, and the springs' stiffness K.
void find_compliance(foot **feet, int count, const double *mobility, double *scratch, double *compliance);

#endif
