// How feet of a group accelerate by wrenches on each of them.
#ifndef TRIBOS_MUJOCO_COMPLIANCE_H
#define TRIBOS_MUJOCO_COMPLIANCE_H

#include "foot.h"

// Numbers of a compliance, and of the scratch memory of `find_compliance`: a mobility, springs, and rows of the mass.
#define COMPLIANCE(count) (9 * (count) * (count))
#define MOBILITY(count) (36 * (count) * (count))
#define SPRINGS(count) (18 * (count) * (count))
#define ROWS(count, nv) (12 * (count) * (nv))

// Acceleration in the contact planes that unit friction gives while the normal forces respond. `is_free` says that all
// bodies move freely or not at all; `body`, that no other moves, or 0.
void find_compliance(const view *v, foot **feet, int count, bool is_free, int body, double *scratch, double *compliance);

#endif
