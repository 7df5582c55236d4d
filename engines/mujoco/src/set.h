// The set of all friction that a foot can carry, as a step asks for it.
#ifndef TRIBOS_MUJOCO_SET_H
#define TRIBOS_MUJOCO_SET_H

typedef struct friction_set friction_set;

// First member of whatever knows the area.
struct friction_set {
    // The friction of the set nearest to `wrench` (N, N, N m) where torques are divided by `length` (m):
    // the same bits if it lies inside. NaN for what is not finite.
    void (*project)(const friction_set *set, double force_limit, const double wrench[3], double length,
                    double nearest[3]);
    // The friction of the set that opposes a motion (m/s, m/s, rad/s); none opposes rest. NaN for what is not finite.
    void (*oppose)(const friction_set *set, double force_limit, const double motion[3], double friction[3]);
    double arm;  // largest torque per force about the origin, in m
};

#endif
