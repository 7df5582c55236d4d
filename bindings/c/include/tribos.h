/*
 * Tribos: coupled sliding and spinning friction. Generated from the Rust source; do not edit.
 *
 * No heap, no global state, no panic. Everything exists in double (_f64) and in single precision
 * (_f32), with the same meaning. Units are any consistent set.
 *
 * Every function returns a tribos_status. If it is not TRIBOS_STATUS_OK, the results are left as
 * they were. Every call validates its parameters, with one or two comparisons each; motions, loads
 * and states are never refused: NaN in gives NaN out.
 *
 * A null pointer is refused. Every other pointer must point to memory of its type, aligned and, for
 * arguments, initialised; an array must hold as many elements as its count says and must not
 * overlap the results. No pointer is kept after the call, except that a polygon names the memory of its
 * edges. Functions may be called from any thread and from interrupts.
 *
 * The floating-point unit must round to nearest and keep subnormal numbers, as it does by default:
 * do not link with -ffast-math.
 */

#ifndef TRIBOS_H
#define TRIBOS_H

#include <stddef.h>
#include <stdint.h>

#define TRIBOS_VERSION "0.1.0"

// 0 after success; any other value gives the reason why the results were not written.
enum tribos_status
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : int32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
  // The result has been written.
  TRIBOS_STATUS_OK = 0,
  // A pointer is null.
  TRIBOS_STATUS_NULL_POINTER = 1,
  // A number of elements exceeds the address space.
  TRIBOS_STATUS_COUNT = 2,
  // An enumerator has no valid value.
  TRIBOS_STATUS_CHOICE = 3,
  // The memory of a table was not filled by its build function.
  TRIBOS_STATUS_NOT_BUILT = 4,
  // A friction coefficient is negative, infinite or NaN.
  TRIBOS_STATUS_COEFFICIENT = 10,
  // An exponent alpha is NaN or not between -1 (excluded) and the largest one of the tier.
  TRIBOS_STATUS_EXPONENT = 11,
  // A parameter that must be positive and finite is not.
  TRIBOS_STATUS_NOT_POSITIVE = 12,
  // A parameter that must be finite and not negative is not.
  TRIBOS_STATUS_NEGATIVE = 13,
  // A fraction is NaN or not between 0 and 1.
  TRIBOS_STATUS_NOT_A_FRACTION = 14,
  // Two parameters are in the wrong order, such as a dynamic coefficient above the static one.
  TRIBOS_STATUS_ORDER = 15,
  // The law has no minimum at a positive speed.
  TRIBOS_STATUS_NO_MINIMUM = 16,
  // The radius of the contact is not positive and finite.
  TRIBOS_STATUS_RADIUS = 20,
  // The order q of the pressure is not between -1 and 8.
  TRIBOS_STATUS_PRESSURE_ORDER = 21,
  // The inner over the outer radius of an annulus is not between 0 and 0.999999.
  TRIBOS_STATUS_INNER_RATIO = 22,
  // A semi-axis is not positive and finite, or one is more than 1e6 times as long as the other.
  TRIBOS_STATUS_SEMI_AXES = 23,
  // A node has a position that is not finite.
  TRIBOS_STATUS_NODE_POSITION = 30,
  // A node's weight is negative or NaN, or makes the sum infinite.
  TRIBOS_STATUS_NODE_WEIGHT = 31,
  // No node, or no foot, carries load.
  TRIBOS_STATUS_UNLOADED = 32,
  // The nodes do not fit into the given memory.
  TRIBOS_STATUS_FULL = 33,
  // Three feet lie on a line.
  TRIBOS_STATUS_FEET_IN_LINE = 34,
  // A body on three feet tips over.
  TRIBOS_STATUS_TIPS = 35,
  // A loop of a polygon has fewer than 3 corners.
  TRIBOS_STATUS_CORNERS = 36,
  // No corner of the polygon sees all of it, or its area is zero.
  TRIBOS_STATUS_HIDDEN = 37,
  // The number of divisions is not between 1 and 1024.
  TRIBOS_STATUS_DIVISIONS = 38,
  // The number of rings or angles is not between 1 and 1024.
  TRIBOS_STATUS_RINGS = 39,
  // The rim exponent of a pressure is not between -1 (excluded) and 64.
  TRIBOS_STATUS_RIM_EXPONENT = 40,
  // The pressure on a polygon is linear already.
  TRIBOS_STATUS_LEANS = 41,
  // Edges of a polygon touch or cross, a hole lies outside, or a loop has no area.
  TRIBOS_STATUS_OUTLINE = 42,
  // The patch has two coefficients already.
  TRIBOS_STATUS_AXES = 43,
  // The force limit is negative, infinite or NaN.
  TRIBOS_STATUS_FORCE_LIMIT = 50,
  // The reduced torque of pure spinning is not positive and finite.
  TRIBOS_STATUS_SPIN_TORQUE = 51,
  // The deceleration of a slider is not positive and finite.
  TRIBOS_STATUS_DECELERATION = 60,
  // The inertia ratio of a slider is not positive and finite.
  TRIBOS_STATUS_INERTIA = 61,
  // The motion does not come to rest, or is not finite.
  TRIBOS_STATUS_NO_REST = 62,
  // The push is more than friction of all feet carries: no motion is steady.
  TRIBOS_STATUS_ACCELERATES = 63,
  // The search for a steady motion ended before friction balanced the push, or the push is NaN.
  TRIBOS_STATUS_MISSED = 64,
  // There is no normal: centres coincide, or one lies in the plate.
  TRIBOS_STATUS_NO_NORMAL = 70,
  // A position, a radius or the motion of a surface is not finite, or a radius is not positive.
  TRIBOS_STATUS_NOT_FINITE = 71,
  // A time step is not positive and finite.
  TRIBOS_STATUS_TIME_STEP = 72,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum tribos_status tribos_status;
#else
typedef int32_t tribos_status;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

// Effect of cohesion within its range.
enum tribos_attraction
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : uint32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
  // A constant pull, which closes the gap of a released pair.
  TRIBOS_ATTRACTION_PULL = 0,
  // A resistance against opening, which does not close the gap of a released pair.
  TRIBOS_ATTRACTION_RESISTANCE = 1,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum tribos_attraction tribos_attraction;
#else
typedef uint32_t tribos_attraction;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

// How pressure is spread over a disk or an ellipse, with rho from 0 at its centre to 1 on its edge.
enum tribos_pressure
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : uint32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
  // 1/sqrt(1 - rho^2): a rigid flat punch on an elastic body.
  TRIBOS_PRESSURE_FLAT_PUNCH = 0,
  // The same everywhere.
  TRIBOS_PRESSURE_UNIFORM = 1,
  // sqrt(1 - rho^2): curved elastic bodies.
  TRIBOS_PRESSURE_HERTZ = 2,
  // 1 - rho^2
  TRIBOS_PRESSURE_PARABOLOID = 3,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum tribos_pressure tribos_pressure;
#else
typedef uint32_t tribos_pressure;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

// Coulomb's law: friction = mu x load.
typedef struct tribos_coulomb_f64 {
  // Friction coefficient, 0 <= mu < inf.
  double mu;
} tribos_coulomb_f64;

// Dry friction with different coefficients at rest and in motion,
// 0 <= mu_dynamic <= mu_static < inf.
typedef struct tribos_dry_f64 {
  // Coefficient at rest.
  double mu_static;
  // Coefficient in motion.
  double mu_dynamic;
} tribos_dry_f64;

// The power law: friction per load = coefficient x |speed|^alpha.
typedef struct tribos_power_f64 {
  // Exponent, -1 < alpha <= 128. Below 0 friction falls with speed, and motions need not be unique.
  double alpha;
  // Coefficient, 0 <= coefficient < inf, in (time/length)^alpha.
  double coefficient;
} tribos_power_f64;

// The Stribeck curve: mu(v) = mu_d + (mu_s - mu_d) exp(-(v/v_s)^exponent) + viscous v.
typedef struct tribos_stribeck_f64 {
  // Coefficients mu_s and mu_d.
  struct tribos_dry_f64 dry;
  // Stribeck speed v_s, positive and finite.
  double stribeck_speed;
  // Exponent of the decay, positive and finite; 1 and 2 are usual.
  double exponent;
  // Viscous coefficient in 1/speed, finite and not negative.
  double viscous;
} tribos_stribeck_f64;

// The LuGre model in units of force:
// z' = v - stiffness |v| z/g(v), g(v) = F_c + (F_s - F_c) exp(-(v/v_s)^2),
// force = stiffness z + bristle_damping z' + viscous_damping v.
// The force has the sign of v: the friction on a body that moves with v is minus this force.
typedef struct tribos_lugre_f64 {
  // Coulomb force F_c, 0 < F_c <= F_s.
  double coulomb_force;
  // Static force F_s, the largest force of the bristles.
  double static_force;
  // Stribeck speed v_s, positive.
  double stribeck_speed;
  // Stiffness of the bristles, positive, force/length.
  double stiffness;
  // Damping of the bristles, not negative, force x time/length.
  double bristle_damping;
  // Viscous damping, not negative, force x time/length.
  double viscous_damping;
} tribos_lugre_f64;

// Rate-and-state friction, regularised at rest:
// mu(V, theta) = a asinh(V/q) + viscous V, q = 2 V_0 exp(-(mu + b ln(V_0 theta/D_c))/a).
typedef struct tribos_rate_state_f64 {
  // Coefficient of steady sliding at V_0, not negative.
  double mu;
  // Direct effect of the speed, positive.
  double a;
  // Effect of the age, not negative.
  double b;
  // Reference speed V_0, positive.
  double reference_speed;
  // Memory length D_c, positive.
  double slip_distance;
  // Viscous coefficient in 1/speed, not negative.
  double viscous;
} tribos_rate_state_f64;

// A round contact patch.
typedef struct tribos_round_f64 {
  // Friction coefficient mu, or coefficient of the power law, 0 <= coefficient < inf.
  double coefficient;
  // Radius of the patch, positive and finite.
  double radius;
} tribos_round_f64;

// Motion of a rigid patch in its plane. Units: length/time and 1/time, in any consistent set.
typedef struct tribos_twist_f64 {
  // Sliding velocity of the patch centre, first component.
  double x;
  // Sliding velocity of the patch centre, second component.
  double y;
  // Angular velocity about the normal; positive turns the first axis towards the second.
  double spin;
} tribos_twist_f64;

// Force and torque on a patch in its plane. Units: force, and force x length.
typedef struct tribos_wrench_f64 {
  // Force at the patch centre, first component.
  double x;
  // Force at the patch centre, second component.
  double y;
  // Torque about the normal.
  double torque;
} tribos_wrench_f64;

// Derivatives d(force x, force y, torque)/d(velocity x, velocity y, spin).
typedef struct tribos_jacobian_f64 {
  // `rows[i][j]`: component i of the wrench per component j of the twist.
  double rows[3][3];
} tribos_jacobian_f64;

// One exponent under one pressure, built by `tribos_power_compact_build_f64`. Its content is opaque.
typedef struct tribos_power_compact_f64 {
  // Internal data.
  uint64_t opaque[24];
  // Marker of a completed build.
  uint32_t built;
} tribos_power_compact_f64;

// A table of one exponent, built by `tribos_power_table_build_f64`. Its content is opaque. It may be
// copied and moved, but not to a program with another version of the library.
typedef struct tribos_power_table_f64 {
  // Internal data.
  double opaque[1694];
  // Marker of a completed build.
  uint32_t built;
} tribos_power_table_f64;

// One point of a contact.
typedef struct tribos_node_f64 {
  // First coordinate relative to the reference point of twist and wrench; finite.
  double x;
  // Second coordinate.
  double y;
  // Share of the load in any unit, not negative: only ratios of weights matter.
  double weight;
} tribos_node_f64;

// A point of the contact plane.
typedef struct tribos_point_f64 {
  // First coordinate.
  double x;
  // Second coordinate.
  double y;
} tribos_point_f64;

// A pressure on a disk, p = (1 - r^2/R^2)^q (1 + tilt x/R), represented by rings of nodes.
typedef struct tribos_disk_rule_f64 {
  // Radius R, positive and finite.
  double radius;
  // Number of rings, 1 to 1024.
  uint32_t rings;
  // Nodes on each ring, 1 to 1024.
  uint32_t angles;
  // Exponent q, -1 < q <= 64: -1/2 flat punch, 0 uniform, 1/2 Hertz.
  double rim_exponent;
  // First component of the tilt, for the contact of a braking body; 0 for no tilt.
  double tilt_x;
  // Second component of the tilt. A pressure that is negative at a node is refused.
  double tilt_y;
} tribos_disk_rule_f64;

// The exact limit surface of a uniform disk.
typedef struct tribos_disk_surface_f64 {
  // mu x load, finite and not negative. With 0 the set is the zero wrench.
  double force_limit;
  // Radius of the disk, positive and finite.
  double radius;
} tribos_disk_surface_f64;

// The wrench of a set that is nearest to a given wrench.
typedef struct tribos_projection_f64 {
  // The nearest wrench; bit-identical to the given one if that is inside or on the surface.
  struct tribos_wrench_f64 wrench;
  // Outward normal at the wrench, |velocity|^2 + (spin radius)^2 = 1; zero if the contact sticks.
  struct tribos_twist_f64 normal;
  // 1 if the wrench is on the surface and the contact slides; 0 if it is inside and the contact sticks.
  uint32_t slides;
} tribos_projection_f64;

// The ellipsoid (|force|/f)^2 + (torque/(f radius spin_torque))^2 <= 1, which planners use instead.
// For the disk the exact surface lies inside it, down to gauge 0.934.
typedef struct tribos_ellipsoid_f64 {
  // Force limit f = mu x load, finite and not negative.
  double force_limit;
  // Radius of the patch, positive and finite.
  double radius;
  // Reduced torque of pure spinning, positive and finite: 2/3 for the uniform disk.
  double spin_torque;
} tribos_ellipsoid_f64;

// Memory for one edge of a polygon. Its content is opaque.
typedef struct tribos_edge_f64 {
  // Internal data.
  double opaque[7];
} tribos_edge_f64;

// A polygon under uniform or linear pressure, written by tribos_polygon_new_f64. It does not contain
// its edges: their memory must stay valid and unchanged for as long as the polygon or a copy is used.
typedef struct tribos_polygon_f64 {
  // The edges, in the memory given to tribos_polygon_new_f64.
  struct tribos_edge_f64 *edges;
  // Number of edges.
  size_t count;
  // Centre of pressure: the centroid of the area under uniform pressure.
  struct tribos_point_f64 centre;
  // Distance of the farthest corner from the centre of pressure.
  double radius;
  // Area over radius^2.
  double reduced_area;
  // Half the length of the longest edge over the radius.
  double longest_half;
  // Pressure at the centre of pressure over the mean pressure: 1 if uniform.
  double pressure;
  // Slope of the pressure times radius over the mean pressure, first component: 0 if uniform.
  double slope_x;
  // Second component of the slope.
  double slope_y;
} tribos_polygon_f64;

// A patch of any shape, built by one of the functions tribos_shape_. Its content is opaque. It may be copied
// and moved, but not to a program with another version of the library.
typedef struct tribos_shape_f64 {
  // Internal data.
  uint64_t opaque[24];
  // Marker of a completed build.
  uint32_t built;
} tribos_shape_f64;

// One of several shapes under a body, and what it carries.
typedef struct tribos_part_f64 {
  // Its patch, in the coordinates of the body.
  const struct tribos_shape_f64 *shape;
  // Its coefficient, the larger one of two, times its load; not negative. Only ratios count.
  double limit;
} tribos_part_f64;

// A sliding body; all parameters are positive and finite.
typedef struct tribos_slider_f64 {
  // Deceleration of pure sliding, mu x gravity.
  double deceleration;
  // Radius of the contact.
  double radius;
  // Inertia ratio I/(M radius^2): 1/2 for a disk on its own face.
  double inertia_ratio;
} tribos_slider_f64;

// The state of a slider, in units consistent with its deceleration and radius.
typedef struct tribos_motion_f64 {
  // Time since the start.
  double time;
  // Sliding speed, not negative.
  double speed;
  // Spin, of either sign.
  double spin;
  // Distance covered.
  double distance;
  // Angle turned, in radians.
  double angle;
} tribos_motion_f64;

// State of a slider at the end of a step.
typedef struct tribos_advance_f64 {
  // The motion at the end of the step.
  struct tribos_motion_f64 motion;
  // Ratio of sliding to rim speed in the limit of rest; NaN if the body is still moving.
  double ratio;
  // 1 if the body comes to rest in this step, else 0.
  uint32_t came_to_rest;
  // Evaluations of the wrench.
  uint32_t evaluations;
} tribos_advance_f64;

// State of a slider at rest.
typedef struct tribos_rest_f64 {
  // Time, distance and angle at rest; speeds zero.
  struct tribos_motion_f64 motion;
  // Ratio of sliding to rim speed in the limit of rest.
  double ratio;
  // Evaluations of the wrench.
  uint32_t evaluations;
} tribos_rest_f64;

// A body on a patch that is centred below its centre of mass.
typedef struct tribos_planar_body_f64 {
  // Mass, positive and finite.
  double mass;
  // Moment of inertia about the normal, positive and finite. Units: mass x length^2.
  double inertia;
} tribos_planar_body_f64;

// The end of a time step.
typedef struct tribos_planar_step_f64 {
  // The motion after the step.
  struct tribos_twist_f64 twist;
  // Friction on the body, as its mean over the step.
  struct tribos_wrench_f64 friction;
  // 1 if friction holds the body: the motion is zero, to the last bit. 0 else.
  uint32_t is_at_rest;
} tribos_planar_step_f64;

// A foot, the friction that it carries, and how its surface moves. Under a wheel or tread that a body drives
// backwards with the speed c the surface moves with (c, 0, 0).
typedef struct tribos_foot_f64 {
  // Its patch, in the coordinates of the body.
  const struct tribos_shape_f64 *shape;
  // Its coefficient, the larger one of two, times its load; finite and not negative.
  double limit;
  // Motion of the surface under it, about the origin of the body's coordinates; finite.
  struct tribos_twist_f64 surface;
} tribos_foot_f64;

// A motion under which friction balances a push.
typedef struct tribos_steady_motion_f64 {
  // Motion of the body.
  struct tribos_twist_f64 twist;
  // Friction of all feet.
  struct tribos_wrench_f64 friction;
  // The first foot of those that rest on their surface: the twist is that of the surface, to the last bit. The
  // number of feet where all slide.
  size_t carried_by;
  // How often friction of all feet was evaluated.
  size_t evaluations;
} tribos_steady_motion_f64;

// The end of a time step on feet.
typedef struct tribos_floor_step_f64 {
  // The motion after the step.
  struct tribos_twist_f64 twist;
  // Friction of all feet, as its mean over the step.
  struct tribos_wrench_f64 friction;
  // As in tribos_steady_motion_f64, at the end of the step.
  size_t carried_by;
  // What the search has left of the balance of momentum, over all limits: some rounding errors.
  double imbalance;
} tribos_floor_step_f64;

// A vector in three dimensions.
typedef struct tribos_vector_f64 {
  // First component.
  double x;
  // Second component.
  double y;
  // Third component.
  double z;
} tribos_vector_f64;

// Geometry of a contact.
typedef struct tribos_touch_f64 {
  // Unit normal, from the first body to the second.
  struct tribos_vector_f64 normal;
  // Distance of the surfaces; negative where they overlap.
  double gap;
  // Distances of the two centres from the contact point; 0 for a plate.
  double arms[2];
  // 1/(1/R1 + 1/R2), the lever of rolling and torsion friction; the radius at a plate.
  double lever;
} tribos_touch_f64;

// The contact law along the normal.
typedef struct tribos_normal_law_f64 {
  // Pull of cohesion, a force, finite and not negative.
  double cohesion;
  // Largest gap at which cohesion acts, finite and not negative.
  double cohesion_range;
  // A value of tribos_attraction.
  uint32_t attraction;
  // Coefficient of restitution: speed after an impact over speed before, 0 to 1.
  double restitution;
} tribos_normal_law_f64;

// A sphere that can move and rotate freely.
typedef struct tribos_sphere_f64 {
  // Velocity of the centre.
  struct tribos_vector_f64 velocity;
  // Angular velocity.
  struct tribos_vector_f64 spin;
  // 1/mass; 0 for an infinite mass.
  double inv_mass;
  // 1/(moment of inertia about any axis through the centre).
  double inv_inertia;
} tribos_sphere_f64;

// A contact prepared for one time step. The fields may be read; changed values are not validated.
typedef struct tribos_contact_f64 {
  // Unit normal, from the first body to the second.
  struct tribos_vector_f64 normal;
  // Distances of the centres from the contact point.
  double arms[2];
  // Lever of rolling and torsion friction.
  double lever;
  // Effective mass along the normal.
  double mass_normal;
  // Effective mass in the contact plane.
  double mass_sliding;
  // Effective moment of inertia of rolling and of torsion.
  double inertia;
  // Coupling of sliding and rolling, 0 for equal spheres.
  double coupling;
  // Impulse of cohesion in this step, 0 beyond its range.
  double cohesion;
  // Approach speed at which the contact counts as closed; the negative speed of a rebound.
  double allowance;
  // 1 if cohesion keeps the gap, which is open, as it is; else 0.
  uint32_t rests_open;
} tribos_contact_f64;

// A plate that impulses move only along its normal: a wall or a piston.
typedef struct tribos_plate_f64 {
  // Velocity; its component in the plane is prescribed and unaffected by impulses.
  struct tribos_vector_f64 velocity;
  // 1/mass; 0 for a wall.
  double inv_mass;
} tribos_plate_f64;

// An impulse on the second body; its opposite acts on the first. A new contact starts with zeros.
typedef struct tribos_impulse_f64 {
  // Impulse along the normal; positive separates the bodies.
  double normal;
  // Force impulse in the contact plane, in world axes.
  struct tribos_vector_f64 sliding;
  // Torque impulse in the contact plane.
  struct tribos_vector_f64 rolling;
  // Torque impulse about the normal.
  double torsion;
} tribos_impulse_f64;

// Friction coefficients, finite and not negative; a function reads those of its modes and ignores
// the others. P is the normal impulse plus cohesion.
typedef struct tribos_thresholds_f64 {
  // Sliding force over P.
  double sliding;
  // Rolling torque over P x lever.
  double rolling;
  // Torsion torque over P x lever.
  double torsion;
} tribos_thresholds_f64;

// Coulomb's law: friction = mu x load.
typedef struct tribos_coulomb_f32 {
  // Friction coefficient, 0 <= mu < inf.
  float mu;
} tribos_coulomb_f32;

// Dry friction with different coefficients at rest and in motion,
// 0 <= mu_dynamic <= mu_static < inf.
typedef struct tribos_dry_f32 {
  // Coefficient at rest.
  float mu_static;
  // Coefficient in motion.
  float mu_dynamic;
} tribos_dry_f32;

// The power law: friction per load = coefficient x |speed|^alpha.
typedef struct tribos_power_f32 {
  // Exponent, -1 < alpha <= 128. Below 0 friction falls with speed, and motions need not be unique.
  float alpha;
  // Coefficient, 0 <= coefficient < inf, in (time/length)^alpha.
  float coefficient;
} tribos_power_f32;

// The Stribeck curve: mu(v) = mu_d + (mu_s - mu_d) exp(-(v/v_s)^exponent) + viscous v.
typedef struct tribos_stribeck_f32 {
  // Coefficients mu_s and mu_d.
  struct tribos_dry_f32 dry;
  // Stribeck speed v_s, positive and finite.
  float stribeck_speed;
  // Exponent of the decay, positive and finite; 1 and 2 are usual.
  float exponent;
  // Viscous coefficient in 1/speed, finite and not negative.
  float viscous;
} tribos_stribeck_f32;

// The LuGre model in units of force:
// z' = v - stiffness |v| z/g(v), g(v) = F_c + (F_s - F_c) exp(-(v/v_s)^2),
// force = stiffness z + bristle_damping z' + viscous_damping v.
// The force has the sign of v: the friction on a body that moves with v is minus this force.
typedef struct tribos_lugre_f32 {
  // Coulomb force F_c, 0 < F_c <= F_s.
  float coulomb_force;
  // Static force F_s, the largest force of the bristles.
  float static_force;
  // Stribeck speed v_s, positive.
  float stribeck_speed;
  // Stiffness of the bristles, positive, force/length.
  float stiffness;
  // Damping of the bristles, not negative, force x time/length.
  float bristle_damping;
  // Viscous damping, not negative, force x time/length.
  float viscous_damping;
} tribos_lugre_f32;

// Rate-and-state friction, regularised at rest:
// mu(V, theta) = a asinh(V/q) + viscous V, q = 2 V_0 exp(-(mu + b ln(V_0 theta/D_c))/a).
typedef struct tribos_rate_state_f32 {
  // Coefficient of steady sliding at V_0, not negative.
  float mu;
  // Direct effect of the speed, positive.
  float a;
  // Effect of the age, not negative.
  float b;
  // Reference speed V_0, positive.
  float reference_speed;
  // Memory length D_c, positive.
  float slip_distance;
  // Viscous coefficient in 1/speed, not negative.
  float viscous;
} tribos_rate_state_f32;

// A round contact patch.
typedef struct tribos_round_f32 {
  // Friction coefficient mu, or coefficient of the power law, 0 <= coefficient < inf.
  float coefficient;
  // Radius of the patch, positive and finite.
  float radius;
} tribos_round_f32;

// Motion of a rigid patch in its plane. Units: length/time and 1/time, in any consistent set.
typedef struct tribos_twist_f32 {
  // Sliding velocity of the patch centre, first component.
  float x;
  // Sliding velocity of the patch centre, second component.
  float y;
  // Angular velocity about the normal; positive turns the first axis towards the second.
  float spin;
} tribos_twist_f32;

// Force and torque on a patch in its plane. Units: force, and force x length.
typedef struct tribos_wrench_f32 {
  // Force at the patch centre, first component.
  float x;
  // Force at the patch centre, second component.
  float y;
  // Torque about the normal.
  float torque;
} tribos_wrench_f32;

// Derivatives d(force x, force y, torque)/d(velocity x, velocity y, spin).
typedef struct tribos_jacobian_f32 {
  // `rows[i][j]`: component i of the wrench per component j of the twist.
  float rows[3][3];
} tribos_jacobian_f32;

// One exponent under one pressure, built by `tribos_power_compact_build_f32`. Its content is opaque.
typedef struct tribos_power_compact_f32 {
  // Internal data.
  uint64_t opaque[24];
  // Marker of a completed build.
  uint32_t built;
} tribos_power_compact_f32;

// A table of one exponent, built by `tribos_power_table_build_f32`. Its content is opaque. It may be
// copied and moved, but not to a program with another version of the library.
typedef struct tribos_power_table_f32 {
  // Internal data.
  float opaque[714];
  // Marker of a completed build.
  uint32_t built;
} tribos_power_table_f32;

// One point of a contact.
typedef struct tribos_node_f32 {
  // First coordinate relative to the reference point of twist and wrench; finite.
  float x;
  // Second coordinate.
  float y;
  // Share of the load in any unit, not negative: only ratios of weights matter.
  float weight;
} tribos_node_f32;

// A point of the contact plane.
typedef struct tribos_point_f32 {
  // First coordinate.
  float x;
  // Second coordinate.
  float y;
} tribos_point_f32;

// A pressure on a disk, p = (1 - r^2/R^2)^q (1 + tilt x/R), represented by rings of nodes.
typedef struct tribos_disk_rule_f32 {
  // Radius R, positive and finite.
  float radius;
  // Number of rings, 1 to 1024.
  uint32_t rings;
  // Nodes on each ring, 1 to 1024.
  uint32_t angles;
  // Exponent q, -1 < q <= 64: -1/2 flat punch, 0 uniform, 1/2 Hertz.
  float rim_exponent;
  // First component of the tilt, for the contact of a braking body; 0 for no tilt.
  float tilt_x;
  // Second component of the tilt. A pressure that is negative at a node is refused.
  float tilt_y;
} tribos_disk_rule_f32;

// The exact limit surface of a uniform disk.
typedef struct tribos_disk_surface_f32 {
  // mu x load, finite and not negative. With 0 the set is the zero wrench.
  float force_limit;
  // Radius of the disk, positive and finite.
  float radius;
} tribos_disk_surface_f32;

// The wrench of a set that is nearest to a given wrench.
typedef struct tribos_projection_f32 {
  // The nearest wrench; bit-identical to the given one if that is inside or on the surface.
  struct tribos_wrench_f32 wrench;
  // Outward normal at the wrench, |velocity|^2 + (spin radius)^2 = 1; zero if the contact sticks.
  struct tribos_twist_f32 normal;
  // 1 if the wrench is on the surface and the contact slides; 0 if it is inside and the contact sticks.
  uint32_t slides;
} tribos_projection_f32;

// The ellipsoid (|force|/f)^2 + (torque/(f radius spin_torque))^2 <= 1, which planners use instead.
// For the disk the exact surface lies inside it, down to gauge 0.934.
typedef struct tribos_ellipsoid_f32 {
  // Force limit f = mu x load, finite and not negative.
  float force_limit;
  // Radius of the patch, positive and finite.
  float radius;
  // Reduced torque of pure spinning, positive and finite: 2/3 for the uniform disk.
  float spin_torque;
} tribos_ellipsoid_f32;

// Memory for one edge of a polygon. Its content is opaque.
typedef struct tribos_edge_f32 {
  // Internal data.
  float opaque[7];
} tribos_edge_f32;

// A polygon under uniform or linear pressure, written by tribos_polygon_new_f32. It does not contain
// its edges: their memory must stay valid and unchanged for as long as the polygon or a copy is used.
typedef struct tribos_polygon_f32 {
  // The edges, in the memory given to tribos_polygon_new_f32.
  struct tribos_edge_f32 *edges;
  // Number of edges.
  size_t count;
  // Centre of pressure: the centroid of the area under uniform pressure.
  struct tribos_point_f32 centre;
  // Distance of the farthest corner from the centre of pressure.
  float radius;
  // Area over radius^2.
  float reduced_area;
  // Half the length of the longest edge over the radius.
  float longest_half;
  // Pressure at the centre of pressure over the mean pressure: 1 if uniform.
  float pressure;
  // Slope of the pressure times radius over the mean pressure, first component: 0 if uniform.
  float slope_x;
  // Second component of the slope.
  float slope_y;
} tribos_polygon_f32;

// A patch of any shape, built by one of the functions tribos_shape_. Its content is opaque. It may be copied
// and moved, but not to a program with another version of the library.
typedef struct tribos_shape_f32 {
  // Internal data.
  uint64_t opaque[24];
  // Marker of a completed build.
  uint32_t built;
} tribos_shape_f32;

// One of several shapes under a body, and what it carries.
typedef struct tribos_part_f32 {
  // Its patch, in the coordinates of the body.
  const struct tribos_shape_f32 *shape;
  // Its coefficient, the larger one of two, times its load; not negative. Only ratios count.
  float limit;
} tribos_part_f32;

// A sliding body; all parameters are positive and finite.
typedef struct tribos_slider_f32 {
  // Deceleration of pure sliding, mu x gravity.
  float deceleration;
  // Radius of the contact.
  float radius;
  // Inertia ratio I/(M radius^2): 1/2 for a disk on its own face.
  float inertia_ratio;
} tribos_slider_f32;

// The state of a slider, in units consistent with its deceleration and radius.
typedef struct tribos_motion_f32 {
  // Time since the start.
  float time;
  // Sliding speed, not negative.
  float speed;
  // Spin, of either sign.
  float spin;
  // Distance covered.
  float distance;
  // Angle turned, in radians.
  float angle;
} tribos_motion_f32;

// State of a slider at the end of a step.
typedef struct tribos_advance_f32 {
  // The motion at the end of the step.
  struct tribos_motion_f32 motion;
  // Ratio of sliding to rim speed in the limit of rest; NaN if the body is still moving.
  float ratio;
  // 1 if the body comes to rest in this step, else 0.
  uint32_t came_to_rest;
  // Evaluations of the wrench.
  uint32_t evaluations;
} tribos_advance_f32;

// State of a slider at rest.
typedef struct tribos_rest_f32 {
  // Time, distance and angle at rest; speeds zero.
  struct tribos_motion_f32 motion;
  // Ratio of sliding to rim speed in the limit of rest.
  float ratio;
  // Evaluations of the wrench.
  uint32_t evaluations;
} tribos_rest_f32;

// A body on a patch that is centred below its centre of mass.
typedef struct tribos_planar_body_f32 {
  // Mass, positive and finite.
  float mass;
  // Moment of inertia about the normal, positive and finite. Units: mass x length^2.
  float inertia;
} tribos_planar_body_f32;

// The end of a time step.
typedef struct tribos_planar_step_f32 {
  // The motion after the step.
  struct tribos_twist_f32 twist;
  // Friction on the body, as its mean over the step.
  struct tribos_wrench_f32 friction;
  // 1 if friction holds the body: the motion is zero, to the last bit. 0 else.
  uint32_t is_at_rest;
} tribos_planar_step_f32;

// A foot, the friction that it carries, and how its surface moves. Under a wheel or tread that a body drives
// backwards with the speed c the surface moves with (c, 0, 0).
typedef struct tribos_foot_f32 {
  // Its patch, in the coordinates of the body.
  const struct tribos_shape_f32 *shape;
  // Its coefficient, the larger one of two, times its load; finite and not negative.
  float limit;
  // Motion of the surface under it, about the origin of the body's coordinates; finite.
  struct tribos_twist_f32 surface;
} tribos_foot_f32;

// A motion under which friction balances a push.
typedef struct tribos_steady_motion_f32 {
  // Motion of the body.
  struct tribos_twist_f32 twist;
  // Friction of all feet.
  struct tribos_wrench_f32 friction;
  // The first foot of those that rest on their surface: the twist is that of the surface, to the last bit. The
  // number of feet where all slide.
  size_t carried_by;
  // How often friction of all feet was evaluated.
  size_t evaluations;
} tribos_steady_motion_f32;

// The end of a time step on feet.
typedef struct tribos_floor_step_f32 {
  // The motion after the step.
  struct tribos_twist_f32 twist;
  // Friction of all feet, as its mean over the step.
  struct tribos_wrench_f32 friction;
  // As in tribos_steady_motion_f32, at the end of the step.
  size_t carried_by;
  // What the search has left of the balance of momentum, over all limits: some rounding errors.
  float imbalance;
} tribos_floor_step_f32;

// A vector in three dimensions.
typedef struct tribos_vector_f32 {
  // First component.
  float x;
  // Second component.
  float y;
  // Third component.
  float z;
} tribos_vector_f32;

// Geometry of a contact.
typedef struct tribos_touch_f32 {
  // Unit normal, from the first body to the second.
  struct tribos_vector_f32 normal;
  // Distance of the surfaces; negative where they overlap.
  float gap;
  // Distances of the two centres from the contact point; 0 for a plate.
  float arms[2];
  // 1/(1/R1 + 1/R2), the lever of rolling and torsion friction; the radius at a plate.
  float lever;
} tribos_touch_f32;

// The contact law along the normal.
typedef struct tribos_normal_law_f32 {
  // Pull of cohesion, a force, finite and not negative.
  float cohesion;
  // Largest gap at which cohesion acts, finite and not negative.
  float cohesion_range;
  // A value of tribos_attraction.
  uint32_t attraction;
  // Coefficient of restitution: speed after an impact over speed before, 0 to 1.
  float restitution;
} tribos_normal_law_f32;

// A sphere that can move and rotate freely.
typedef struct tribos_sphere_f32 {
  // Velocity of the centre.
  struct tribos_vector_f32 velocity;
  // Angular velocity.
  struct tribos_vector_f32 spin;
  // 1/mass; 0 for an infinite mass.
  float inv_mass;
  // 1/(moment of inertia about any axis through the centre).
  float inv_inertia;
} tribos_sphere_f32;

// A contact prepared for one time step. The fields may be read; changed values are not validated.
typedef struct tribos_contact_f32 {
  // Unit normal, from the first body to the second.
  struct tribos_vector_f32 normal;
  // Distances of the centres from the contact point.
  float arms[2];
  // Lever of rolling and torsion friction.
  float lever;
  // Effective mass along the normal.
  float mass_normal;
  // Effective mass in the contact plane.
  float mass_sliding;
  // Effective moment of inertia of rolling and of torsion.
  float inertia;
  // Coupling of sliding and rolling, 0 for equal spheres.
  float coupling;
  // Impulse of cohesion in this step, 0 beyond its range.
  float cohesion;
  // Approach speed at which the contact counts as closed; the negative speed of a rebound.
  float allowance;
  // 1 if cohesion keeps the gap, which is open, as it is; else 0.
  uint32_t rests_open;
} tribos_contact_f32;

// A plate that impulses move only along its normal: a wall or a piston.
typedef struct tribos_plate_f32 {
  // Velocity; its component in the plane is prescribed and unaffected by impulses.
  struct tribos_vector_f32 velocity;
  // 1/mass; 0 for a wall.
  float inv_mass;
} tribos_plate_f32;

// An impulse on the second body; its opposite acts on the first. A new contact starts with zeros.
typedef struct tribos_impulse_f32 {
  // Impulse along the normal; positive separates the bodies.
  float normal;
  // Force impulse in the contact plane, in world axes.
  struct tribos_vector_f32 sliding;
  // Torque impulse in the contact plane.
  struct tribos_vector_f32 rolling;
  // Torque impulse about the normal.
  float torsion;
} tribos_impulse_f32;

// Friction coefficients, finite and not negative; a function reads those of its modes and ignores
// the others. P is the normal impulse plus cohesion.
typedef struct tribos_thresholds_f32 {
  // Sliding force over P.
  float sliding;
  // Rolling torque over P x lever.
  float rolling;
  // Torsion torque over P x lever.
  float torsion;
} tribos_thresholds_f32;

#ifdef __cplusplus
extern "C" {
#endif // __cplusplus

// The meaning of a status as a line of English text. The text is a constant of the program.
//
// *Special values*: a number that is no status gives "no such status".
const char *tribos_status_text(int32_t status);

// Friction per load of Coulomb's law: mu at every speed.
tribos_status tribos_coulomb_friction_f64(const struct tribos_coulomb_f64 *law,
                                          double speed,
                                          double *friction);

// Friction per load in motion: mu_dynamic. Special values: NaN gives NaN.
tribos_status tribos_dry_friction_f64(const struct tribos_dry_f64 *law,
                                      double speed,
                                      double *friction);

// Whether a body at rest remains at rest under a tangential load per normal load, of either sign: 1 if
// it sticks, 0 if it slips. Special values: |drive| = mu_static sticks, NaN slips.
tribos_status tribos_dry_sticks_f64(const struct tribos_dry_f64 *law,
                                    double drive_per_load,
                                    uint32_t *sticks);

// Net tangential load on a body at rest, per normal load: zero if the body sticks, else the drive minus
// dynamic friction, with the sign of the drive. Special values: NaN gives NaN.
tribos_status tribos_dry_net_drive_f64(const struct tribos_dry_f64 *law,
                                       double drive_per_load,
                                       double *net);

// Friction per load of the power law at speed > 0.
tribos_status tribos_power_friction_f64(const struct tribos_power_f64 *law,
                                        double speed,
                                        double *friction);

// Derivative of the power law's friction with respect to speed, at speed > 0.
tribos_status tribos_power_slope_f64(const struct tribos_power_f64 *law,
                                     double speed,
                                     double *slope);

// Friction per load of the Stribeck curve at speed >= 0.
tribos_status tribos_stribeck_friction_f64(const struct tribos_stribeck_f64 *law,
                                           double speed,
                                           double *friction);

// Derivative of the Stribeck curve with respect to speed. At rest: -inf for an exponent below 1.
tribos_status tribos_stribeck_slope_f64(const struct tribos_stribeck_f64 *law,
                                        double speed,
                                        double *slope);

// Speed of minimum friction between boundary and hydrodynamic lubrication;
// TRIBOS_STATUS_NO_MINIMUM if there is none. Cost: at most 512 slopes.
tribos_status tribos_stribeck_minimum_f64(const struct tribos_stribeck_f64 *law, double *speed);

// One step of dt >= 0 at constant velocity: advances the deflection (initially 0) and returns the
// mean force over the step, so that force x dt is the impulse. Both are exact for any dt. The
// force has the sign of the velocity. Special values: NaN gives NaN.
tribos_status tribos_lugre_step_f64(const struct tribos_lugre_f64 *law,
                                    double *deflection,
                                    double velocity,
                                    double dt,
                                    double *force);

// Instantaneous force, stiffness z + bristle_damping z' + viscous_damping v.
tribos_status tribos_lugre_force_f64(const struct tribos_lugre_f64 *law,
                                     double deflection,
                                     double velocity,
                                     double *force);

// Force of steady sliding, sgn(v) g(v) + viscous_damping v; at rest the limit for the sign of the zero.
tribos_status tribos_lugre_steady_force_f64(const struct tribos_lugre_f64 *law,
                                            double velocity,
                                            double *force);

// Speed up to which the model dissipates energy for any deflection; infinite if it always does.
tribos_status tribos_lugre_passive_up_to_f64(const struct tribos_lugre_f64 *law, double *speed);

// Friction per load at speed >= 0 for a contact of age theta (a time); 0 at rest.
tribos_status tribos_rate_state_friction_f64(const struct tribos_rate_state_f64 *law,
                                             double speed,
                                             double theta,
                                             double *friction);

// Derivative of this friction with respect to speed at constant age.
tribos_status tribos_rate_state_slope_f64(const struct tribos_rate_state_f64 *law,
                                          double speed,
                                          double theta,
                                          double *slope);

// Advances the age theta by dt >= 0 at constant speed, exactly, by the ageing law
// theta' = 1 - V theta/D_c.
tribos_status tribos_rate_state_advance_dieterich_f64(const struct tribos_rate_state_f64 *law,
                                                      double *theta,
                                                      double speed,
                                                      double dt);

// Advances the age theta like the function above, by the slip law theta' = -(V theta/D_c) ln(V theta/D_c).
tribos_status tribos_rate_state_advance_ruina_f64(const struct tribos_rate_state_f64 *law,
                                                  double *theta,
                                                  double speed,
                                                  double dt);

// Friction per load of steady sliding, where theta = D_c/V.
tribos_status tribos_rate_state_steady_friction_f64(const struct tribos_rate_state_f64 *law,
                                                    double speed,
                                                    double *friction);

// Derivative of the steady friction with respect to speed.
tribos_status tribos_rate_state_steady_slope_f64(const struct tribos_rate_state_f64 *law,
                                                 double speed,
                                                 double *slope);

// Uniform disk under Coulomb friction. Flash: 0.4 KiB of numbers (f32: 0.1).
// Accuracy at speeds right to 2 ulp: 7 ulp in force, 8 in torque (f32: 8).
tribos_status tribos_disk_wrench_f64(const struct tribos_round_f64 *patch,
                                     double load,
                                     const struct tribos_twist_f64 *twist,
                                     struct tribos_wrench_f64 *wrench);

// Jacobian of the uniform disk.
tribos_status tribos_disk_jacobian_f64(const struct tribos_round_f64 *patch,
                                       double load,
                                       const struct tribos_twist_f64 *twist,
                                       struct tribos_jacobian_f64 *jacobian);

// Annulus between inner_ratio and 1 radii under uniform pressure and Coulomb friction, from the disk.
// Domain: 0 <= inner_ratio <= 0.999999. Accuracy: that of the disk times 2/(1 - inner_ratio), at most 32.
tribos_status tribos_annulus_wrench_f64(const struct tribos_round_f64 *patch,
                                        double inner_ratio,
                                        double load,
                                        const struct tribos_twist_f64 *twist,
                                        struct tribos_wrench_f64 *wrench);

// Jacobian of the annulus.
tribos_status tribos_annulus_jacobian_f64(const struct tribos_round_f64 *patch,
                                          double inner_ratio,
                                          double load,
                                          const struct tribos_twist_f64 *twist,
                                          struct tribos_jacobian_f64 *jacobian);

// Hertz' pressure (a ball on a plane) under Coulomb friction.
// Accuracy at speeds right to 2 ulp: 7 ulp in force, 8 in torque (f32: 8).
tribos_status tribos_hertz_wrench_f64(const struct tribos_round_f64 *patch,
                                      double load,
                                      const struct tribos_twist_f64 *twist,
                                      struct tribos_wrench_f64 *wrench);

// Jacobian under Hertz' pressure.
tribos_status tribos_hertz_jacobian_f64(const struct tribos_round_f64 *patch,
                                        double load,
                                        const struct tribos_twist_f64 *twist,
                                        struct tribos_jacobian_f64 *jacobian);

// A thin ring under Coulomb friction.
// Accuracy at speeds right to 2 ulp: 12 ulp in force, 10 in torque (f32: 8).
tribos_status tribos_ring_wrench_f64(const struct tribos_round_f64 *patch,
                                     double load,
                                     const struct tribos_twist_f64 *twist,
                                     struct tribos_wrench_f64 *wrench);

// Jacobian of the ring. Special values: infinite where sliding and rim speed are equal.
tribos_status tribos_ring_jacobian_f64(const struct tribos_round_f64 *patch,
                                       double load,
                                       const struct tribos_twist_f64 *twist,
                                       struct tribos_jacobian_f64 *jacobian);

// A rigid flat punch on an elastic half space under Coulomb friction.
// Accuracy at speeds right to 2 ulp: 7 ulp in force, 8 in torque (f32: 8).
tribos_status tribos_punch_wrench_f64(const struct tribos_round_f64 *patch,
                                      double load,
                                      const struct tribos_twist_f64 *twist,
                                      struct tribos_wrench_f64 *wrench);

// Jacobian of the flat punch.
tribos_status tribos_punch_jacobian_f64(const struct tribos_round_f64 *patch,
                                        double load,
                                        const struct tribos_twist_f64 *twist,
                                        struct tribos_jacobian_f64 *jacobian);

// Prepares one exponent, -1 < alpha <= 128, under the pressure (1-r^2)^q of order q, -1 <= q <= 8:
// -1 ring, -1/2 flat punch, 0 uniform, 1/2 Hertz, 1 paraboloid. Cost: about 200 wrenches unless q = 0.
tribos_status tribos_power_compact_build_f64(double alpha,
                                             double pressure_order,
                                             struct tribos_power_compact_f64 *power);

// Any exponent under any pressure (1-r^2)^q, without a table. Computes in double precision, for _f32
// too, and is slow on a processor without it. Accuracy: 1e-14 relative for alpha >= -0.9 (f32: 10 ulp).
tribos_status tribos_power_compact_wrench_f64(const struct tribos_power_compact_f64 *power,
                                              const struct tribos_round_f64 *patch,
                                              double load,
                                              const struct tribos_twist_f64 *twist,
                                              struct tribos_wrench_f64 *wrench);

// Jacobian of any exponent under any pressure (1-r^2)^q, without a table.
tribos_status tribos_power_compact_jacobian_f64(const struct tribos_power_compact_f64 *power,
                                                const struct tribos_round_f64 *patch,
                                                double load,
                                                const struct tribos_twist_f64 *twist,
                                                struct tribos_jacobian_f64 *jacobian);

// Builds the table of one exponent for the uniform disk, -1 < alpha <= 10, in the caller's memory:
// 14 KiB (f32: 3). Cost: about 300,000 operations in double precision (f32: half as many, also in
// double precision), and 49 KiB of stack on a Cortex-M4 (f32: 13).
tribos_status tribos_power_table_build_f64(double alpha, struct tribos_power_table_f64 *table);

// Uniform disk under the power law, by a table built before; as fast as Coulomb friction except for
// one power. Accuracy: 1.5e-15 relative for alpha >= -0.75 (f32: 5 ulp).
tribos_status tribos_power_table_wrench_f64(const struct tribos_power_table_f64 *table,
                                            const struct tribos_round_f64 *patch,
                                            double load,
                                            const struct tribos_twist_f64 *twist,
                                            struct tribos_wrench_f64 *wrench);

// Jacobian of the uniform disk under the power law, by a table built before.
tribos_status tribos_power_table_jacobian_f64(const struct tribos_power_table_f64 *table,
                                              const struct tribos_round_f64 *patch,
                                              double load,
                                              const struct tribos_twist_f64 *twist,
                                              struct tribos_jacobian_f64 *jacobian);

// Wrenches of `count` twists under one load, to the bits of tribos_disk_wrench_f64.
tribos_status tribos_disk_wrench_batch_f64(const struct tribos_round_f64 *patch,
                                           double load,
                                           const struct tribos_twist_f64 *twists,
                                           size_t count,
                                           struct tribos_wrench_f64 *wrenches);

// Jacobians of `count` twists under one load, to the bits of tribos_disk_jacobian_f64.
tribos_status tribos_disk_jacobian_batch_f64(const struct tribos_round_f64 *patch,
                                             double load,
                                             const struct tribos_twist_f64 *twists,
                                             size_t count,
                                             struct tribos_jacobian_f64 *jacobians);

// Wrenches of `count` twists under one load, to the bits of tribos_power_table_wrench_f64.
tribos_status tribos_power_table_wrench_batch_f64(const struct tribos_power_table_f64 *table,
                                                  const struct tribos_round_f64 *patch,
                                                  double load,
                                                  const struct tribos_twist_f64 *twists,
                                                  size_t count,
                                                  struct tribos_wrench_f64 *wrenches);

// Jacobians of `count` twists under one load, to the bits of tribos_power_table_jacobian_f64.
tribos_status tribos_power_table_jacobian_batch_f64(const struct tribos_power_table_f64 *table,
                                                    const struct tribos_round_f64 *patch,
                                                    double load,
                                                    const struct tribos_twist_f64 *twists,
                                                    size_t count,
                                                    struct tribos_jacobian_f64 *jacobians);

// Wrench of Coulomb friction at `count` nodes.
tribos_status tribos_nodes_coulomb_wrench_f64(const struct tribos_coulomb_f64 *law,
                                              const struct tribos_node_f64 *nodes,
                                              size_t count,
                                              double load,
                                              const struct tribos_twist_f64 *twist,
                                              struct tribos_wrench_f64 *wrench);

// Jacobian of Coulomb friction at `count` nodes. Special values: a node at rest contributes the law's
// slope at rest if that is not negative, hence nothing under dry friction.
tribos_status tribos_nodes_coulomb_jacobian_f64(const struct tribos_coulomb_f64 *law,
                                                const struct tribos_node_f64 *nodes,
                                                size_t count,
                                                double load,
                                                const struct tribos_twist_f64 *twist,
                                                struct tribos_jacobian_f64 *jacobian);

// Wrench of the power law at `count` nodes.
tribos_status tribos_nodes_power_wrench_f64(const struct tribos_power_f64 *law,
                                            const struct tribos_node_f64 *nodes,
                                            size_t count,
                                            double load,
                                            const struct tribos_twist_f64 *twist,
                                            struct tribos_wrench_f64 *wrench);

// Jacobian of the power law at `count` nodes.
tribos_status tribos_nodes_power_jacobian_f64(const struct tribos_power_f64 *law,
                                              const struct tribos_node_f64 *nodes,
                                              size_t count,
                                              double load,
                                              const struct tribos_twist_f64 *twist,
                                              struct tribos_jacobian_f64 *jacobian);

// Wrench of the Stribeck curve at `count` nodes.
tribos_status tribos_nodes_stribeck_wrench_f64(const struct tribos_stribeck_f64 *law,
                                               const struct tribos_node_f64 *nodes,
                                               size_t count,
                                               double load,
                                               const struct tribos_twist_f64 *twist,
                                               struct tribos_wrench_f64 *wrench);

// Jacobian of the Stribeck curve at `count` nodes.
tribos_status tribos_nodes_stribeck_jacobian_f64(const struct tribos_stribeck_f64 *law,
                                                 const struct tribos_node_f64 *nodes,
                                                 size_t count,
                                                 double load,
                                                 const struct tribos_twist_f64 *twist,
                                                 struct tribos_jacobian_f64 *jacobian);

// Nodes of a uniform pressure on a simple polygon in which one corner sees the whole interior. The
// 7 (corners - 2) divisions^2 nodes are written to `nodes`, which has room for `capacity`; `filled` is
// their number. After TRIBOS_STATUS_FULL and other refusals the content of `nodes` is undefined.
// Accuracy: moments up to degree 5 to rounding; friction of a square 1.2e-2, 2.8e-3, 6.8e-4 of the
// load with 56, 224, 896 nodes while the centre of rotation lies inside.
tribos_status tribos_polygon_nodes_f64(const struct tribos_point_f64 *corners,
                                       size_t count,
                                       uint32_t divisions,
                                       struct tribos_node_f64 *nodes,
                                       size_t capacity,
                                       size_t *filled);

// Nodes of a pressure on a disk: rings x angles of them, written as by tribos_polygon_nodes_f64.
// Accuracy: Coulomb friction under uniform pressure 3.7e-3 with 8 x 16 nodes, 9.4e-4 with 16 x 32
// while the centre of rotation lies inside; outside, the error falls geometrically.
tribos_status tribos_disk_nodes_f64(const struct tribos_disk_rule_f64 *rule,
                                    struct tribos_node_f64 *nodes,
                                    size_t capacity,
                                    size_t *filled);

// Nodes of three feet that carry a body whose centre of mass lies above `centre`: `feet` points to
// three points, `nodes` to room for three nodes, whose positions are relative to `centre`.
tribos_status tribos_tripod_nodes_f64(const struct tribos_point_f64 *feet,
                                      const struct tribos_point_f64 *centre,
                                      struct tribos_node_f64 *nodes);

// Power that the patch dissipates with a twist: the largest wrench . twist of the set.
tribos_status tribos_disk_surface_support_f64(const struct tribos_disk_surface_f64 *surface,
                                              const struct tribos_twist_f64 *twist,
                                              double *power);

// Friction on a patch that moves with a twist. Special values: zero at rest.
tribos_status tribos_disk_surface_wrench_f64(const struct tribos_disk_surface_f64 *surface,
                                             const struct tribos_twist_f64 *twist,
                                             struct tribos_wrench_f64 *wrench);

// The smallest factor g >= 0 with wrench/g in the set: below 1 friction holds the patch, above 1 the patch
// slides. Special values: 0 for the zero wrench, infinite for an infinite one.
tribos_status tribos_disk_surface_gauge_f64(const struct tribos_disk_surface_f64 *surface,
                                            const struct tribos_wrench_f64 *wrench,
                                            double *gauge);

// The motion caused by a push, scaled to |velocity|^2 + (spin radius)^2 = 1.
// Special values: zero for the zero wrench.
tribos_status tribos_disk_surface_motion_f64(const struct tribos_disk_surface_f64 *surface,
                                             const struct tribos_wrench_f64 *push,
                                             struct tribos_twist_f64 *twist);

// The wrench scaled to the surface. Special values: the zero wrench is unchanged.
tribos_status tribos_disk_surface_scale_f64(const struct tribos_disk_surface_f64 *surface,
                                            const struct tribos_wrench_f64 *wrench,
                                            struct tribos_wrench_f64 *scaled);

// The nearest wrench of the set in the norm sqrt(|d force|^2 + (d torque/length)^2); a length of
// 0 represents the radius. Special values: NaN for a negative or infinite length.
tribos_status tribos_disk_surface_project_f64(const struct tribos_disk_surface_f64 *surface,
                                              const struct tribos_wrench_f64 *wrench,
                                              double length,
                                              struct tribos_projection_f64 *projection);

// As tribos_disk_surface_support_f64, for the ellipsoid.
tribos_status tribos_ellipsoid_support_f64(const struct tribos_ellipsoid_f64 *ellipsoid,
                                           const struct tribos_twist_f64 *twist,
                                           double *power);

// As tribos_disk_surface_wrench_f64, for the ellipsoid.
tribos_status tribos_ellipsoid_wrench_f64(const struct tribos_ellipsoid_f64 *ellipsoid,
                                          const struct tribos_twist_f64 *twist,
                                          struct tribos_wrench_f64 *wrench);

// As tribos_disk_surface_gauge_f64, for the ellipsoid.
tribos_status tribos_ellipsoid_gauge_f64(const struct tribos_ellipsoid_f64 *ellipsoid,
                                         const struct tribos_wrench_f64 *wrench,
                                         double *gauge);

// As tribos_disk_surface_motion_f64, for the ellipsoid.
tribos_status tribos_ellipsoid_motion_f64(const struct tribos_ellipsoid_f64 *ellipsoid,
                                          const struct tribos_wrench_f64 *push,
                                          struct tribos_twist_f64 *twist);

// As tribos_disk_surface_scale_f64, for the ellipsoid.
tribos_status tribos_ellipsoid_scale_f64(const struct tribos_ellipsoid_f64 *ellipsoid,
                                         const struct tribos_wrench_f64 *wrench,
                                         struct tribos_wrench_f64 *scaled);

// As tribos_disk_surface_project_f64, for the ellipsoid.
tribos_status tribos_ellipsoid_project_f64(const struct tribos_ellipsoid_f64 *ellipsoid,
                                           const struct tribos_wrench_f64 *wrench,
                                           double length,
                                           struct tribos_projection_f64 *projection);

// Prepares a polygon, convex or not, under uniform pressure. `corners` holds the corners of `loops` loops
// one after another, `counts` how many each has: first the outer loop, then holes inside of it and outside
// of each other, clockwise or counterclockwise. `memory` has room for `room` edges, one a corner is needed.
// Domain: 3 or more finite corners a loop; edges meet only at the corners that they share.
// Cost: the number of corners squared. After a refusal the content of `memory` is undefined.
tribos_status tribos_polygon_new_f64(const struct tribos_point_f64 *corners,
                                     const size_t *counts,
                                     size_t loops,
                                     struct tribos_edge_f64 *memory,
                                     size_t room,
                                     struct tribos_polygon_f64 *polygon);

// Moves the centre of pressure of a uniform polygon to `centre`, by a pressure that is linear over the
// area. Rewrites the polygon and the memory of its edges: copies of it are lost. TRIBOS_STATUS_NEGATIVE if
// the patch would lift off, in a rectangle a x b beyond |dx|/a + |dy|/b = 1/6 from its middle, and
// TRIBOS_STATUS_LEANS if the pressure is linear already; refusals leave polygon and edges as they were.
tribos_status tribos_polygon_lean_f64(struct tribos_polygon_f64 *polygon,
                                      const struct tribos_point_f64 *centre);

// Wrench of Coulomb friction on a polygon, against its twist. Special values: zero at rest.
// Accuracy: 6e-15 of coefficient x load, and x radius, about the centre of pressure, under linear pressure
// 8e-15 (f32: 4e-6), for patches up to 10 times as long as wide.
tribos_status tribos_polygon_wrench_f64(const struct tribos_polygon_f64 *polygon,
                                        double coefficient,
                                        double load,
                                        const struct tribos_twist_f64 *twist,
                                        struct tribos_wrench_f64 *wrench);

// Wrench and Jacobian, which is symmetric. Special values: both zero at rest. Accuracy of the Jacobian,
// of its largest entry with the radius as the unit of length: 5e-14
// (f32: 1e-5).
tribos_status tribos_polygon_wrench_jacobian_f64(const struct tribos_polygon_f64 *polygon,
                                                 double coefficient,
                                                 double load,
                                                 const struct tribos_twist_f64 *twist,
                                                 struct tribos_wrench_f64 *wrench,
                                                 struct tribos_jacobian_f64 *jacobian);

// The limit surface of a polygon with force_limit = coefficient x load: the smallest factor g >= 0 with
// wrench/g in the set. Below 1 friction holds the patch, above 1 it slides. Special values: 0 for the zero
// wrench, infinite for an infinite one. Accuracy: 1e-14 (f32: 1e-5) with the origin at most a few radii away.
// Cost: about 6 wrenches with Jacobian, at most 13.
tribos_status tribos_polygon_gauge_f64(const struct tribos_polygon_f64 *polygon,
                                       double force_limit,
                                       const struct tribos_wrench_f64 *wrench,
                                       double *gauge);

// The motion caused by a push, scaled to |velocity|^2 + (spin length)^2 = 1, where length is the radius
// plus the distance of the centre of pressure from the origin. Special values: zero for the zero wrench.
tribos_status tribos_polygon_motion_f64(const struct tribos_polygon_f64 *polygon,
                                        double force_limit,
                                        const struct tribos_wrench_f64 *push,
                                        struct tribos_twist_f64 *twist);

// The nearest wrench of the set in the norm sqrt(|d force|^2 + (d torque/length)^2); a length of 0
// represents that of tribos_polygon_motion_f64. Special values: NaN for a negative or infinite length.
tribos_status tribos_polygon_project_f64(const struct tribos_polygon_f64 *polygon,
                                         double force_limit,
                                         const struct tribos_wrench_f64 *wrench,
                                         double length,
                                         struct tribos_projection_f64 *projection);

// Gauge of a wrench on an annulus under uniform pressure, as tribos_disk_surface_gauge_f64 with
// force_limit = coefficient x load.
tribos_status tribos_annulus_gauge_f64(const struct tribos_round_f64 *patch,
                                       double inner_ratio,
                                       double load,
                                       const struct tribos_wrench_f64 *wrench,
                                       double *gauge);

// The nearest wrench that an annulus can carry, as tribos_disk_surface_project_f64.
tribos_status tribos_annulus_project_f64(const struct tribos_round_f64 *patch,
                                         double inner_ratio,
                                         double load,
                                         const struct tribos_wrench_f64 *wrench,
                                         double length,
                                         struct tribos_projection_f64 *projection);

// Gauge of a wrench under Hertz' pressure, as tribos_disk_surface_gauge_f64.
tribos_status tribos_hertz_gauge_f64(const struct tribos_round_f64 *patch,
                                     double load,
                                     const struct tribos_wrench_f64 *wrench,
                                     double *gauge);

// The nearest wrench that a Hertz contact can carry, as tribos_disk_surface_project_f64.
tribos_status tribos_hertz_project_f64(const struct tribos_round_f64 *patch,
                                       double load,
                                       const struct tribos_wrench_f64 *wrench,
                                       double length,
                                       struct tribos_projection_f64 *projection);

// Gauge of a wrench on a ring, as tribos_disk_surface_gauge_f64.
tribos_status tribos_ring_gauge_f64(const struct tribos_round_f64 *patch,
                                    double load,
                                    const struct tribos_wrench_f64 *wrench,
                                    double *gauge);

// The nearest wrench that a ring can carry, as tribos_disk_surface_project_f64.
tribos_status tribos_ring_project_f64(const struct tribos_round_f64 *patch,
                                      double load,
                                      const struct tribos_wrench_f64 *wrench,
                                      double length,
                                      struct tribos_projection_f64 *projection);

// Gauge of a wrench on a rigid flat punch, as tribos_disk_surface_gauge_f64.
tribos_status tribos_punch_gauge_f64(const struct tribos_round_f64 *patch,
                                     double load,
                                     const struct tribos_wrench_f64 *wrench,
                                     double *gauge);

// The nearest wrench that a rigid flat punch can carry, as tribos_disk_surface_project_f64.
tribos_status tribos_punch_project_f64(const struct tribos_round_f64 *patch,
                                       double load,
                                       const struct tribos_wrench_f64 *wrench,
                                       double length,
                                       struct tribos_projection_f64 *projection);

// Gauge of a wrench on `count` nodes, as tribos_polygon_gauge_f64. Two or more places carry load.
// Cost: the number of nodes times a few.
tribos_status tribos_nodes_gauge_f64(const struct tribos_node_f64 *nodes,
                                     size_t count,
                                     double force_limit,
                                     const struct tribos_wrench_f64 *wrench,
                                     double *gauge);

// The nearest wrench that `count` nodes can carry, as tribos_polygon_project_f64.
tribos_status tribos_nodes_project_f64(const struct tribos_node_f64 *nodes,
                                       size_t count,
                                       double force_limit,
                                       const struct tribos_wrench_f64 *wrench,
                                       double length,
                                       struct tribos_projection_f64 *projection);

// What of a polygon lies to the left of the line through `point` along `direction`, under the same pressure:
// the part of a patch on one of two surfaces. `share` is its part of the load; where it is 0 nothing lies
// there, and no piece is written. `memory` has room for `room` edges, other than those of the polygon: twice as
// many are always enough. Accuracy: both pieces of a patch have its friction together to rounding.
// TRIBOS_STATUS_NODE_POSITION for a point that is not finite, TRIBOS_STATUS_OUTLINE for no direction,
// TRIBOS_STATUS_FULL for too little room.
tribos_status tribos_polygon_within_f64(const struct tribos_polygon_f64 *polygon,
                                        const struct tribos_point_f64 *point,
                                        const struct tribos_point_f64 *direction,
                                        struct tribos_edge_f64 *memory,
                                        size_t room,
                                        struct tribos_polygon_f64 *piece,
                                        double *share);

// A disk about any centre under one of the pressures, a tribos_pressure. Domain: a finite centre;
// 0 < radius < inf. Alone and centred in the origin tribos_disk_wrench_f64 is quicker.
tribos_status tribos_shape_disk_f64(uint32_t pressure,
                                    const struct tribos_point_f64 *centre,
                                    double radius,
                                    struct tribos_shape_f64 *shape);

// An ellipse about any centre with semi-axes along x and y under one of the pressures, a tribos_pressure.
// Domain: a finite centre; positive, finite semi-axes whose quotient is at most 1e6.
// Accuracy, of coefficient x load, and x radius: 1e-14 (f32: 1e-6) for aspect ratios up to 1e3; Jacobian 1e-12
// (f32: 1e-5) of its largest entry.
tribos_status tribos_shape_ellipse_f64(uint32_t pressure,
                                       const struct tribos_point_f64 *centre,
                                       const struct tribos_point_f64 *semi_axes,
                                       struct tribos_shape_f64 *shape);

// The ellipse centre + p cos t + q sin t with two half-diameters p and q, in any direction: semi-axes where they
// are normal to each other. Otherwise as tribos_shape_ellipse_f64.
tribos_status tribos_shape_turned_ellipse_f64(uint32_t pressure,
                                              const struct tribos_point_f64 *centre,
                                              const struct tribos_point_f64 *half_diameters,
                                              struct tribos_shape_f64 *shape);

// A polygon under uniform or leaning pressure, whose edges stay where they are.
tribos_status tribos_shape_polygon_f64(const struct tribos_polygon_f64 *polygon,
                                       struct tribos_shape_f64 *shape);

// An annulus about any centre under the pressure 1/r, as a clutch, a pivot or a thrust bearing that has worn in.
// Domain: a finite centre; 0 <= inner_ratio <= 0.999999; 0 < radius < inf.
// Accuracy, of coefficient x load, and x radius: 2e-15 (f32: 1e-6). Cost: 16 rings, at most 96.
tribos_status tribos_shape_worn_annulus_f64(const struct tribos_point_f64 *centre,
                                            double inner_ratio,
                                            double radius,
                                            struct tribos_shape_f64 *shape);

// A straight line that carries load: a blade, a skate, the edge of a box. The centre of pressure lies `lean` from
// its middle towards `to`: 0 under uniform pressure, which is linear else. Domain: finite, different ends;
// TRIBOS_STATUS_NEGATIVE beyond a sixth of the length, where the bar would lift off.
// Accuracy, of coefficient x load, and x radius: 3e-14 (f32: 4e-6).
tribos_status tribos_shape_bar_f64(const struct tribos_point_f64 *from,
                                   const struct tribos_point_f64 *to,
                                   double lean,
                                   struct tribos_shape_f64 *shape);

// Points that stay where they are: feet, spikes, the nodes of a rule. Domain: that of tribos_nodes_gauge_f64.
tribos_status tribos_shape_points_f64(struct tribos_node_f64 *nodes,
                                      size_t count,
                                      struct tribos_shape_f64 *shape);

// Several shapes under one body as one, while all surfaces under them move alike: with coefficient x load or the
// force limit of a call the sum of all limits. Parts and their shapes stay where they are. Domain: limits with a
// finite, positive sum; TRIBOS_STATUS_CHOICE if a part is `shape` itself or several shapes.
tribos_status tribos_shape_feet_f64(const struct tribos_part_f64 *parts,
                                    size_t count,
                                    struct tribos_shape_f64 *shape);

// Gives a shape the coefficients `along` an axis of it and `across` that axis: tread, skates, grooved or brushed
// surfaces. The larger one is the coefficient, and the one in the force limit, of every call that follows.
// Rewrites the edges of a polygon and points: the polygon itself and copies are lost. Domain: positive, finite
// coefficients; an axis of any finite length but zero. TRIBOS_STATUS_AXES if the shape has two coefficients already;
// TRIBOS_STATUS_CHOICE for a worn annulus, and for several shapes, each of which takes its own;
// TRIBOS_STATUS_SEMI_AXES for an ellipse, stretched by the coefficients, of more than 1e6 to 1;
// TRIBOS_STATUS_RADIUS if the stretched patch vanishes in rounding, which loses the edges.
tribos_status tribos_shape_two_coefficients_f64(struct tribos_shape_f64 *shape,
                                                double along,
                                                double across,
                                                const struct tribos_point_f64 *axis);

// Wrench of Coulomb friction on a shape, against its twist. Special values: zero at rest.
tribos_status tribos_shape_wrench_f64(const struct tribos_shape_f64 *shape,
                                      double coefficient,
                                      double load,
                                      const struct tribos_twist_f64 *twist,
                                      struct tribos_wrench_f64 *wrench);

// Wrench and Jacobian, which is symmetric. Special values: both zero at rest.
tribos_status tribos_shape_wrench_jacobian_f64(const struct tribos_shape_f64 *shape,
                                               double coefficient,
                                               double load,
                                               const struct tribos_twist_f64 *twist,
                                               struct tribos_wrench_f64 *wrench,
                                               struct tribos_jacobian_f64 *jacobian);

// Gauge of a wrench on a shape, as tribos_polygon_gauge_f64.
tribos_status tribos_shape_gauge_f64(const struct tribos_shape_f64 *shape,
                                     double force_limit,
                                     const struct tribos_wrench_f64 *wrench,
                                     double *gauge);

// The motion caused by a push, as tribos_polygon_motion_f64.
tribos_status tribos_shape_motion_f64(const struct tribos_shape_f64 *shape,
                                      double force_limit,
                                      const struct tribos_wrench_f64 *push,
                                      struct tribos_twist_f64 *twist);

// The nearest wrench that a shape can carry, as tribos_polygon_project_f64.
tribos_status tribos_shape_project_f64(const struct tribos_shape_f64 *shape,
                                       double force_limit,
                                       const struct tribos_wrench_f64 *wrench,
                                       double length,
                                       struct tribos_projection_f64 *projection);

// One velocity-Verlet step of size duration > 0, in place. Friction stops a motion and never reverses
// it. Accuracy: second order in motion, first order at the stop. Cost: two wrenches.
tribos_status tribos_slider_verlet_step_f64(const struct tribos_slider_f64 *slider,
                                            struct tribos_motion_f64 *motion,
                                            double duration);

// Advances the motion by duration >= 0, also past rest. Accuracy: as tribos_slider_to_rest_f64.
// Cost: 8 evaluations of the wrench if the speeds change by less than a few thousandths, 12 up to
// a few hundredths; otherwise about 50 to 250.
tribos_status tribos_slider_advance_f64(const struct tribos_slider_f64 *slider,
                                        const struct tribos_motion_f64 *motion,
                                        double duration,
                                        struct tribos_advance_f64 *advance);

// Advances the motion to rest; TRIBOS_STATUS_NO_REST if it is not finite. Accuracy: 1e-13
// relative in each of time, distance and angle (f32: 5e-6), whichever motion ends first. Cost: about
// 150 evaluations of the wrench, rarely more than 500.
tribos_status tribos_slider_to_rest_f64(const struct tribos_slider_f64 *slider,
                                        const struct tribos_motion_f64 *motion,
                                        struct tribos_rest_f64 *rest);

// Kinetic energy per mass.
tribos_status tribos_slider_energy_f64(const struct tribos_slider_f64 *slider,
                                       const struct tribos_motion_f64 *motion,
                                       double *energy_per_mass);

// Power dissipated by friction, per mass.
tribos_status tribos_slider_dissipation_f64(const struct tribos_slider_f64 *slider,
                                            const struct tribos_motion_f64 *motion,
                                            double *power_per_mass);

// The motion of a body after the time dt under a constant push and the friction of a disk.
// Accuracy: second order in dt while the body slides; rest is exact.
// Special values: NaN for NaN, and where momentum/dt overflows.
tribos_status tribos_planar_disk_step_f64(const struct tribos_planar_body_f64 *body,
                                          const struct tribos_disk_surface_f64 *surface,
                                          const struct tribos_twist_f64 *twist,
                                          const struct tribos_wrench_f64 *push,
                                          double dt,
                                          struct tribos_planar_step_f64 *step);

// As tribos_planar_disk_step_f64, under the friction of an ellipsoid.
tribos_status tribos_planar_ellipsoid_step_f64(const struct tribos_planar_body_f64 *body,
                                               const struct tribos_ellipsoid_f64 *ellipsoid,
                                               const struct tribos_twist_f64 *twist,
                                               const struct tribos_wrench_f64 *push,
                                               double dt,
                                               struct tribos_planar_step_f64 *step);

// As tribos_planar_disk_step_f64 with friction that is `strength`, the static over the dynamic coefficient, times
// that of the surface while the body rests. A body at rest, whose twist is exactly zero, keeps every bit of it
// while the push lies in strength x surface; beyond, it slides under the surface in the same step. Domain:
// 1 <= strength; less counts as 1.
tribos_status tribos_planar_disk_step_sticking_f64(const struct tribos_planar_body_f64 *body,
                                                   const struct tribos_disk_surface_f64 *surface,
                                                   double strength,
                                                   const struct tribos_twist_f64 *twist,
                                                   const struct tribos_wrench_f64 *push,
                                                   double dt,
                                                   struct tribos_planar_step_f64 *step);

// As tribos_planar_disk_step_sticking_f64, on a patch of any shape with force_limit = dynamic coefficient x load,
// whose origin is the centre of mass.
tribos_status tribos_planar_shape_step_sticking_f64(const struct tribos_planar_body_f64 *body,
                                                    const struct tribos_shape_f64 *shape,
                                                    double force_limit,
                                                    double strength,
                                                    const struct tribos_twist_f64 *twist,
                                                    const struct tribos_wrench_f64 *push,
                                                    double dt,
                                                    struct tribos_planar_step_f64 *step);

// The wrench on a body that moves with `twist`. Special values: a foot that rests on its surface gives nothing.
// TRIBOS_STATUS_UNLOADED if no foot has a limit above 0.
tribos_status tribos_feet_wrench_f64(const struct tribos_foot_f64 *feet,
                                     size_t count,
                                     const struct tribos_twist_f64 *twist,
                                     struct tribos_wrench_f64 *wrench);

// Wrench and Jacobian, which is symmetric.
tribos_status tribos_feet_wrench_jacobian_f64(const struct tribos_foot_f64 *feet,
                                              size_t count,
                                              const struct tribos_twist_f64 *twist,
                                              struct tribos_wrench_f64 *wrench,
                                              struct tribos_jacobian_f64 *jacobian);

// The motion in which friction of the feet balances a push on the body: the one that a body comes to.
// Accuracy: balanced to 1e-12 of all limits (f32: 5e-5). TRIBOS_STATUS_ACCELERATES if the push is more than all
// feet carry together, TRIBOS_STATUS_MISSED if the search ended before the balance.
// Cost: 8 to 24 evaluations with Jacobian, about 12.
tribos_status tribos_feet_steady_motion_f64(const struct tribos_foot_f64 *feet,
                                            size_t count,
                                            const struct tribos_wrench_f64 *push,
                                            struct tribos_steady_motion_f64 *motion);

// The motion of a body after the time dt under a constant push and the friction of its feet, whose origin is the
// centre of mass. Accuracy: second order in dt while all feet slide; feet that come to rest on their surface do
// so in every bit. Special values: NaN for NaN.
tribos_status tribos_feet_step_f64(const struct tribos_planar_body_f64 *body,
                                   const struct tribos_foot_f64 *feet,
                                   size_t count,
                                   const struct tribos_twist_f64 *twist,
                                   const struct tribos_wrench_f64 *push,
                                   double dt,
                                   struct tribos_floor_step_f64 *step);

// Gauges of `count` wrenches, as tribos_disk_surface_gauge_f64. Domain: 0 <= load < inf.
// Special values: NaN for a negative or NaN load, unless the wrench is zero or infinite.
tribos_status tribos_disk_surface_gauge_batch_f64(const struct tribos_disk_surface_f64 *surface,
                                                  const double *loads,
                                                  const struct tribos_wrench_f64 *wrenches,
                                                  size_t count,
                                                  double *gauges);

// The motions caused by `count` pushes, as tribos_disk_surface_motion_f64; they do not depend on the load.
tribos_status tribos_disk_surface_motion_batch_f64(const struct tribos_disk_surface_f64 *surface,
                                                   const struct tribos_wrench_f64 *pushes,
                                                   size_t count,
                                                   struct tribos_twist_f64 *twists);

// Projections of `count` wrenches, as tribos_disk_surface_project_f64; a length of 0 represents the radius.
// Domain: 0 <= load < inf. Special values: NaN for a negative or NaN load, unless the wrench is zero.
tribos_status tribos_disk_surface_project_batch_f64(const struct tribos_disk_surface_f64 *surface,
                                                    const double *loads,
                                                    const struct tribos_wrench_f64 *wrenches,
                                                    size_t count,
                                                    double length,
                                                    struct tribos_projection_f64 *projections);

// Projections of `count` wrenches onto the surface of an annulus, as tribos_annulus_project_f64.
// Domain: 0 <= load < inf. Special values: NaN for a negative or NaN load, unless the wrench is zero.
tribos_status tribos_annulus_project_batch_f64(const struct tribos_round_f64 *patch,
                                               double inner_ratio,
                                               const double *loads,
                                               const struct tribos_wrench_f64 *wrenches,
                                               size_t count,
                                               double length,
                                               struct tribos_projection_f64 *projections);

// Projections of `count` wrenches onto the surface of a Hertz contact, as tribos_hertz_project_f64.
// Domain: 0 <= load < inf. Special values: NaN for a negative or NaN load, unless the wrench is zero.
tribos_status tribos_hertz_project_batch_f64(const struct tribos_round_f64 *patch,
                                             const double *loads,
                                             const struct tribos_wrench_f64 *wrenches,
                                             size_t count,
                                             double length,
                                             struct tribos_projection_f64 *projections);

// Projections of `count` wrenches onto the surface of a ring, as tribos_ring_project_f64.
// Domain: 0 <= load < inf. Special values: NaN for a negative or NaN load, unless the wrench is zero.
tribos_status tribos_ring_project_batch_f64(const struct tribos_round_f64 *patch,
                                            const double *loads,
                                            const struct tribos_wrench_f64 *wrenches,
                                            size_t count,
                                            double length,
                                            struct tribos_projection_f64 *projections);

// Projections of `count` wrenches onto the surface of a rigid flat punch, as tribos_punch_project_f64.
// Domain: 0 <= load < inf. Special values: NaN for a negative or NaN load, unless the wrench is zero.
tribos_status tribos_punch_project_batch_f64(const struct tribos_round_f64 *patch,
                                             const double *loads,
                                             const struct tribos_wrench_f64 *wrenches,
                                             size_t count,
                                             double length,
                                             struct tribos_projection_f64 *projections);

// Steps of `count` bodies alike, each with its load, motion and push, as tribos_planar_disk_step_f64.
// Domain: 0 <= load < inf. Special values: as there; NaN for a negative or NaN load, unless the body rests
// without push.
tribos_status tribos_planar_disk_step_batch_f64(const struct tribos_planar_body_f64 *body,
                                                const struct tribos_disk_surface_f64 *surface,
                                                const double *loads,
                                                const struct tribos_twist_f64 *twists,
                                                const struct tribos_wrench_f64 *pushes,
                                                size_t count,
                                                double dt,
                                                struct tribos_planar_step_f64 *steps);

// Contact geometry of two spheres; `displacement` is the vector from the first centre to the second.
// Accuracy: the normal to 4 ulp, the gap to 2 ulp of the distance.
tribos_status tribos_touch_spheres_f64(const struct tribos_vector_f64 *displacement,
                                       double first_radius,
                                       double second_radius,
                                       struct tribos_touch_f64 *touch);

// Contact geometry of a sphere, the first body, and a plate at distance `height` from its centre; `outward`
// is the plate's unit normal into the space of the sphere and is not normalised.
tribos_status tribos_touch_plate_f64(double height,
                                     const struct tribos_vector_f64 *outward,
                                     double radius,
                                     struct tribos_touch_f64 *touch);

// Prepares a contact of two spheres for a step of length dt.
tribos_status tribos_contact_spheres_f64(const struct tribos_touch_f64 *touch,
                                         const struct tribos_normal_law_f64 *law,
                                         const struct tribos_sphere_f64 *first,
                                         const struct tribos_sphere_f64 *second,
                                         double dt,
                                         struct tribos_contact_f64 *contact);

// Prepares a contact of a sphere with a plate, the second body.
tribos_status tribos_contact_plate_f64(const struct tribos_touch_f64 *touch,
                                       const struct tribos_normal_law_f64 *law,
                                       const struct tribos_sphere_f64 *first,
                                       const struct tribos_plate_f64 *second,
                                       double dt,
                                       struct tribos_contact_f64 *contact);

// Updates a contact of two spheres, with a normal impulse only.
tribos_status tribos_update_frictionless_spheres_f64(const struct tribos_contact_f64 *contact,
                                                     struct tribos_sphere_f64 *first,
                                                     struct tribos_sphere_f64 *second,
                                                     struct tribos_impulse_f64 *impulse);

// Updates a contact of two spheres, with normal impulse and sliding friction.
tribos_status tribos_update_sliding_spheres_f64(const struct tribos_contact_f64 *contact,
                                                const struct tribos_thresholds_f64 *friction,
                                                struct tribos_sphere_f64 *first,
                                                struct tribos_sphere_f64 *second,
                                                struct tribos_impulse_f64 *impulse);

// Updates a contact of two spheres, with normal impulse, sliding and torsion friction, each with its
// own threshold.
tribos_status tribos_update_sliding_torsion_spheres_f64(const struct tribos_contact_f64 *contact,
                                                        const struct tribos_thresholds_f64 *friction,
                                                        struct tribos_sphere_f64 *first,
                                                        struct tribos_sphere_f64 *second,
                                                        struct tribos_impulse_f64 *impulse);

// Updates a contact of two spheres, with normal impulse, sliding and rolling friction.
tribos_status tribos_update_sliding_rolling_spheres_f64(const struct tribos_contact_f64 *contact,
                                                        const struct tribos_thresholds_f64 *friction,
                                                        struct tribos_sphere_f64 *first,
                                                        struct tribos_sphere_f64 *second,
                                                        struct tribos_impulse_f64 *impulse);

// Updates a contact of two spheres, with normal impulse, sliding, rolling and torsion friction, each
// with its own threshold.
tribos_status tribos_update_all_spheres_f64(const struct tribos_contact_f64 *contact,
                                            const struct tribos_thresholds_f64 *friction,
                                            struct tribos_sphere_f64 *first,
                                            struct tribos_sphere_f64 *second,
                                            struct tribos_impulse_f64 *impulse);

// Updates a contact of two spheres, with normal impulse, and sliding and torsion under the common
// threshold of a uniform disk: `sliding` is mu, `torsion` is the radius of the disk over the lever, not
// a coefficient.
tribos_status tribos_update_patch_spheres_f64(const struct tribos_contact_f64 *contact,
                                              const struct tribos_thresholds_f64 *friction,
                                              struct tribos_sphere_f64 *first,
                                              struct tribos_sphere_f64 *second,
                                              struct tribos_impulse_f64 *impulse);

// Updates a contact of a sphere with a plate, with a normal impulse only.
tribos_status tribos_update_frictionless_plate_f64(const struct tribos_contact_f64 *contact,
                                                   struct tribos_sphere_f64 *first,
                                                   struct tribos_plate_f64 *second,
                                                   struct tribos_impulse_f64 *impulse);

// Updates a contact of a sphere with a plate, with normal impulse and sliding friction.
tribos_status tribos_update_sliding_plate_f64(const struct tribos_contact_f64 *contact,
                                              const struct tribos_thresholds_f64 *friction,
                                              struct tribos_sphere_f64 *first,
                                              struct tribos_plate_f64 *second,
                                              struct tribos_impulse_f64 *impulse);

// Updates a contact of a sphere with a plate, with normal impulse, sliding and torsion friction, each
// with its own threshold.
tribos_status tribos_update_sliding_torsion_plate_f64(const struct tribos_contact_f64 *contact,
                                                      const struct tribos_thresholds_f64 *friction,
                                                      struct tribos_sphere_f64 *first,
                                                      struct tribos_plate_f64 *second,
                                                      struct tribos_impulse_f64 *impulse);

// Updates a contact of a sphere with a plate, with normal impulse, sliding and rolling friction.
tribos_status tribos_update_sliding_rolling_plate_f64(const struct tribos_contact_f64 *contact,
                                                      const struct tribos_thresholds_f64 *friction,
                                                      struct tribos_sphere_f64 *first,
                                                      struct tribos_plate_f64 *second,
                                                      struct tribos_impulse_f64 *impulse);

// Updates a contact of a sphere with a plate, with normal impulse, sliding, rolling and torsion
// friction, each with its own threshold.
tribos_status tribos_update_all_plate_f64(const struct tribos_contact_f64 *contact,
                                          const struct tribos_thresholds_f64 *friction,
                                          struct tribos_sphere_f64 *first,
                                          struct tribos_plate_f64 *second,
                                          struct tribos_impulse_f64 *impulse);

// Updates a contact of a sphere with a plate, with normal impulse, and sliding and torsion under the
// common threshold of a uniform disk: `sliding` is mu, `torsion` is the radius of the disk over the
// lever, not a coefficient.
tribos_status tribos_update_patch_plate_f64(const struct tribos_contact_f64 *contact,
                                            const struct tribos_thresholds_f64 *friction,
                                            struct tribos_sphere_f64 *first,
                                            struct tribos_plate_f64 *second,
                                            struct tribos_impulse_f64 *impulse);

// Friction per load of Coulomb's law: mu at every speed.
tribos_status tribos_coulomb_friction_f32(const struct tribos_coulomb_f32 *law,
                                          float speed,
                                          float *friction);

// Friction per load in motion: mu_dynamic. Special values: NaN gives NaN.
tribos_status tribos_dry_friction_f32(const struct tribos_dry_f32 *law,
                                      float speed,
                                      float *friction);

// Whether a body at rest remains at rest under a tangential load per normal load, of either sign: 1 if
// it sticks, 0 if it slips. Special values: |drive| = mu_static sticks, NaN slips.
tribos_status tribos_dry_sticks_f32(const struct tribos_dry_f32 *law,
                                    float drive_per_load,
                                    uint32_t *sticks);

// Net tangential load on a body at rest, per normal load: zero if the body sticks, else the drive minus
// dynamic friction, with the sign of the drive. Special values: NaN gives NaN.
tribos_status tribos_dry_net_drive_f32(const struct tribos_dry_f32 *law,
                                       float drive_per_load,
                                       float *net);

// Friction per load of the power law at speed > 0.
tribos_status tribos_power_friction_f32(const struct tribos_power_f32 *law,
                                        float speed,
                                        float *friction);

// Derivative of the power law's friction with respect to speed, at speed > 0.
tribos_status tribos_power_slope_f32(const struct tribos_power_f32 *law, float speed, float *slope);

// Friction per load of the Stribeck curve at speed >= 0.
tribos_status tribos_stribeck_friction_f32(const struct tribos_stribeck_f32 *law,
                                           float speed,
                                           float *friction);

// Derivative of the Stribeck curve with respect to speed. At rest: -inf for an exponent below 1.
tribos_status tribos_stribeck_slope_f32(const struct tribos_stribeck_f32 *law,
                                        float speed,
                                        float *slope);

// Speed of minimum friction between boundary and hydrodynamic lubrication;
// TRIBOS_STATUS_NO_MINIMUM if there is none. Cost: at most 512 slopes.
tribos_status tribos_stribeck_minimum_f32(const struct tribos_stribeck_f32 *law, float *speed);

// One step of dt >= 0 at constant velocity: advances the deflection (initially 0) and returns the
// mean force over the step, so that force x dt is the impulse. Both are exact for any dt. The
// force has the sign of the velocity. Special values: NaN gives NaN.
tribos_status tribos_lugre_step_f32(const struct tribos_lugre_f32 *law,
                                    float *deflection,
                                    float velocity,
                                    float dt,
                                    float *force);

// Instantaneous force, stiffness z + bristle_damping z' + viscous_damping v.
tribos_status tribos_lugre_force_f32(const struct tribos_lugre_f32 *law,
                                     float deflection,
                                     float velocity,
                                     float *force);

// Force of steady sliding, sgn(v) g(v) + viscous_damping v; at rest the limit for the sign of the zero.
tribos_status tribos_lugre_steady_force_f32(const struct tribos_lugre_f32 *law,
                                            float velocity,
                                            float *force);

// Speed up to which the model dissipates energy for any deflection; infinite if it always does.
tribos_status tribos_lugre_passive_up_to_f32(const struct tribos_lugre_f32 *law, float *speed);

// Friction per load at speed >= 0 for a contact of age theta (a time); 0 at rest.
tribos_status tribos_rate_state_friction_f32(const struct tribos_rate_state_f32 *law,
                                             float speed,
                                             float theta,
                                             float *friction);

// Derivative of this friction with respect to speed at constant age.
tribos_status tribos_rate_state_slope_f32(const struct tribos_rate_state_f32 *law,
                                          float speed,
                                          float theta,
                                          float *slope);

// Advances the age theta by dt >= 0 at constant speed, exactly, by the ageing law
// theta' = 1 - V theta/D_c.
tribos_status tribos_rate_state_advance_dieterich_f32(const struct tribos_rate_state_f32 *law,
                                                      float *theta,
                                                      float speed,
                                                      float dt);

// Advances the age theta like the function above, by the slip law theta' = -(V theta/D_c) ln(V theta/D_c).
tribos_status tribos_rate_state_advance_ruina_f32(const struct tribos_rate_state_f32 *law,
                                                  float *theta,
                                                  float speed,
                                                  float dt);

// Friction per load of steady sliding, where theta = D_c/V.
tribos_status tribos_rate_state_steady_friction_f32(const struct tribos_rate_state_f32 *law,
                                                    float speed,
                                                    float *friction);

// Derivative of the steady friction with respect to speed.
tribos_status tribos_rate_state_steady_slope_f32(const struct tribos_rate_state_f32 *law,
                                                 float speed,
                                                 float *slope);

// Uniform disk under Coulomb friction. Flash: 0.4 KiB of numbers (f32: 0.1).
// Accuracy at speeds right to 2 ulp: 7 ulp in force, 8 in torque (f32: 8).
tribos_status tribos_disk_wrench_f32(const struct tribos_round_f32 *patch,
                                     float load,
                                     const struct tribos_twist_f32 *twist,
                                     struct tribos_wrench_f32 *wrench);

// Jacobian of the uniform disk.
tribos_status tribos_disk_jacobian_f32(const struct tribos_round_f32 *patch,
                                       float load,
                                       const struct tribos_twist_f32 *twist,
                                       struct tribos_jacobian_f32 *jacobian);

// Annulus between inner_ratio and 1 radii under uniform pressure and Coulomb friction, from the disk.
// Domain: 0 <= inner_ratio <= 0.999999. Accuracy: that of the disk times 2/(1 - inner_ratio), at most 32.
tribos_status tribos_annulus_wrench_f32(const struct tribos_round_f32 *patch,
                                        float inner_ratio,
                                        float load,
                                        const struct tribos_twist_f32 *twist,
                                        struct tribos_wrench_f32 *wrench);

// Jacobian of the annulus.
tribos_status tribos_annulus_jacobian_f32(const struct tribos_round_f32 *patch,
                                          float inner_ratio,
                                          float load,
                                          const struct tribos_twist_f32 *twist,
                                          struct tribos_jacobian_f32 *jacobian);

// Hertz' pressure (a ball on a plane) under Coulomb friction.
// Accuracy at speeds right to 2 ulp: 7 ulp in force, 8 in torque (f32: 8).
tribos_status tribos_hertz_wrench_f32(const struct tribos_round_f32 *patch,
                                      float load,
                                      const struct tribos_twist_f32 *twist,
                                      struct tribos_wrench_f32 *wrench);

// Jacobian under Hertz' pressure.
tribos_status tribos_hertz_jacobian_f32(const struct tribos_round_f32 *patch,
                                        float load,
                                        const struct tribos_twist_f32 *twist,
                                        struct tribos_jacobian_f32 *jacobian);

// A thin ring under Coulomb friction.
// Accuracy at speeds right to 2 ulp: 12 ulp in force, 10 in torque (f32: 8).
tribos_status tribos_ring_wrench_f32(const struct tribos_round_f32 *patch,
                                     float load,
                                     const struct tribos_twist_f32 *twist,
                                     struct tribos_wrench_f32 *wrench);

// Jacobian of the ring. Special values: infinite where sliding and rim speed are equal.
tribos_status tribos_ring_jacobian_f32(const struct tribos_round_f32 *patch,
                                       float load,
                                       const struct tribos_twist_f32 *twist,
                                       struct tribos_jacobian_f32 *jacobian);

// A rigid flat punch on an elastic half space under Coulomb friction.
// Accuracy at speeds right to 2 ulp: 7 ulp in force, 8 in torque (f32: 8).
tribos_status tribos_punch_wrench_f32(const struct tribos_round_f32 *patch,
                                      float load,
                                      const struct tribos_twist_f32 *twist,
                                      struct tribos_wrench_f32 *wrench);

// Jacobian of the flat punch.
tribos_status tribos_punch_jacobian_f32(const struct tribos_round_f32 *patch,
                                        float load,
                                        const struct tribos_twist_f32 *twist,
                                        struct tribos_jacobian_f32 *jacobian);

// Prepares one exponent, -1 < alpha <= 128, under the pressure (1-r^2)^q of order q, -1 <= q <= 8:
// -1 ring, -1/2 flat punch, 0 uniform, 1/2 Hertz, 1 paraboloid. Cost: about 200 wrenches unless q = 0.
tribos_status tribos_power_compact_build_f32(float alpha,
                                             float pressure_order,
                                             struct tribos_power_compact_f32 *power);

// Any exponent under any pressure (1-r^2)^q, without a table. Computes in double precision, for _f32
// too, and is slow on a processor without it. Accuracy: 1e-14 relative for alpha >= -0.9 (f32: 10 ulp).
tribos_status tribos_power_compact_wrench_f32(const struct tribos_power_compact_f32 *power,
                                              const struct tribos_round_f32 *patch,
                                              float load,
                                              const struct tribos_twist_f32 *twist,
                                              struct tribos_wrench_f32 *wrench);

// Jacobian of any exponent under any pressure (1-r^2)^q, without a table.
tribos_status tribos_power_compact_jacobian_f32(const struct tribos_power_compact_f32 *power,
                                                const struct tribos_round_f32 *patch,
                                                float load,
                                                const struct tribos_twist_f32 *twist,
                                                struct tribos_jacobian_f32 *jacobian);

// Builds the table of one exponent for the uniform disk, -1 < alpha <= 10, in the caller's memory:
// 14 KiB (f32: 3). Cost: about 300,000 operations in double precision (f32: half as many, also in
// double precision), and 49 KiB of stack on a Cortex-M4 (f32: 13).
tribos_status tribos_power_table_build_f32(float alpha, struct tribos_power_table_f32 *table);

// Uniform disk under the power law, by a table built before; as fast as Coulomb friction except for
// one power. Accuracy: 1.5e-15 relative for alpha >= -0.75 (f32: 5 ulp).
tribos_status tribos_power_table_wrench_f32(const struct tribos_power_table_f32 *table,
                                            const struct tribos_round_f32 *patch,
                                            float load,
                                            const struct tribos_twist_f32 *twist,
                                            struct tribos_wrench_f32 *wrench);

// Jacobian of the uniform disk under the power law, by a table built before.
tribos_status tribos_power_table_jacobian_f32(const struct tribos_power_table_f32 *table,
                                              const struct tribos_round_f32 *patch,
                                              float load,
                                              const struct tribos_twist_f32 *twist,
                                              struct tribos_jacobian_f32 *jacobian);

// Wrenches of `count` twists under one load, to the bits of tribos_disk_wrench_f32.
tribos_status tribos_disk_wrench_batch_f32(const struct tribos_round_f32 *patch,
                                           float load,
                                           const struct tribos_twist_f32 *twists,
                                           size_t count,
                                           struct tribos_wrench_f32 *wrenches);

// Jacobians of `count` twists under one load, to the bits of tribos_disk_jacobian_f32.
tribos_status tribos_disk_jacobian_batch_f32(const struct tribos_round_f32 *patch,
                                             float load,
                                             const struct tribos_twist_f32 *twists,
                                             size_t count,
                                             struct tribos_jacobian_f32 *jacobians);

// Wrenches of `count` twists under one load, to the bits of tribos_power_table_wrench_f32.
tribos_status tribos_power_table_wrench_batch_f32(const struct tribos_power_table_f32 *table,
                                                  const struct tribos_round_f32 *patch,
                                                  float load,
                                                  const struct tribos_twist_f32 *twists,
                                                  size_t count,
                                                  struct tribos_wrench_f32 *wrenches);

// Jacobians of `count` twists under one load, to the bits of tribos_power_table_jacobian_f32.
tribos_status tribos_power_table_jacobian_batch_f32(const struct tribos_power_table_f32 *table,
                                                    const struct tribos_round_f32 *patch,
                                                    float load,
                                                    const struct tribos_twist_f32 *twists,
                                                    size_t count,
                                                    struct tribos_jacobian_f32 *jacobians);

// Wrench of Coulomb friction at `count` nodes.
tribos_status tribos_nodes_coulomb_wrench_f32(const struct tribos_coulomb_f32 *law,
                                              const struct tribos_node_f32 *nodes,
                                              size_t count,
                                              float load,
                                              const struct tribos_twist_f32 *twist,
                                              struct tribos_wrench_f32 *wrench);

// Jacobian of Coulomb friction at `count` nodes. Special values: a node at rest contributes the law's
// slope at rest if that is not negative, hence nothing under dry friction.
tribos_status tribos_nodes_coulomb_jacobian_f32(const struct tribos_coulomb_f32 *law,
                                                const struct tribos_node_f32 *nodes,
                                                size_t count,
                                                float load,
                                                const struct tribos_twist_f32 *twist,
                                                struct tribos_jacobian_f32 *jacobian);

// Wrench of the power law at `count` nodes.
tribos_status tribos_nodes_power_wrench_f32(const struct tribos_power_f32 *law,
                                            const struct tribos_node_f32 *nodes,
                                            size_t count,
                                            float load,
                                            const struct tribos_twist_f32 *twist,
                                            struct tribos_wrench_f32 *wrench);

// Jacobian of the power law at `count` nodes.
tribos_status tribos_nodes_power_jacobian_f32(const struct tribos_power_f32 *law,
                                              const struct tribos_node_f32 *nodes,
                                              size_t count,
                                              float load,
                                              const struct tribos_twist_f32 *twist,
                                              struct tribos_jacobian_f32 *jacobian);

// Wrench of the Stribeck curve at `count` nodes.
tribos_status tribos_nodes_stribeck_wrench_f32(const struct tribos_stribeck_f32 *law,
                                               const struct tribos_node_f32 *nodes,
                                               size_t count,
                                               float load,
                                               const struct tribos_twist_f32 *twist,
                                               struct tribos_wrench_f32 *wrench);

// Jacobian of the Stribeck curve at `count` nodes.
tribos_status tribos_nodes_stribeck_jacobian_f32(const struct tribos_stribeck_f32 *law,
                                                 const struct tribos_node_f32 *nodes,
                                                 size_t count,
                                                 float load,
                                                 const struct tribos_twist_f32 *twist,
                                                 struct tribos_jacobian_f32 *jacobian);

// Nodes of a uniform pressure on a simple polygon in which one corner sees the whole interior. The
// 7 (corners - 2) divisions^2 nodes are written to `nodes`, which has room for `capacity`; `filled` is
// their number. After TRIBOS_STATUS_FULL and other refusals the content of `nodes` is undefined.
// Accuracy: moments up to degree 5 to rounding; friction of a square 1.2e-2, 2.8e-3, 6.8e-4 of the
// load with 56, 224, 896 nodes while the centre of rotation lies inside.
tribos_status tribos_polygon_nodes_f32(const struct tribos_point_f32 *corners,
                                       size_t count,
                                       uint32_t divisions,
                                       struct tribos_node_f32 *nodes,
                                       size_t capacity,
                                       size_t *filled);

// Nodes of a pressure on a disk: rings x angles of them, written as by tribos_polygon_nodes_f32.
// Accuracy: Coulomb friction under uniform pressure 3.7e-3 with 8 x 16 nodes, 9.4e-4 with 16 x 32
// while the centre of rotation lies inside; outside, the error falls geometrically.
tribos_status tribos_disk_nodes_f32(const struct tribos_disk_rule_f32 *rule,
                                    struct tribos_node_f32 *nodes,
                                    size_t capacity,
                                    size_t *filled);

// Nodes of three feet that carry a body whose centre of mass lies above `centre`: `feet` points to
// three points, `nodes` to room for three nodes, whose positions are relative to `centre`.
tribos_status tribos_tripod_nodes_f32(const struct tribos_point_f32 *feet,
                                      const struct tribos_point_f32 *centre,
                                      struct tribos_node_f32 *nodes);

// Power that the patch dissipates with a twist: the largest wrench . twist of the set.
tribos_status tribos_disk_surface_support_f32(const struct tribos_disk_surface_f32 *surface,
                                              const struct tribos_twist_f32 *twist,
                                              float *power);

// Friction on a patch that moves with a twist. Special values: zero at rest.
tribos_status tribos_disk_surface_wrench_f32(const struct tribos_disk_surface_f32 *surface,
                                             const struct tribos_twist_f32 *twist,
                                             struct tribos_wrench_f32 *wrench);

// The smallest factor g >= 0 with wrench/g in the set: below 1 friction holds the patch, above 1 the patch
// slides. Special values: 0 for the zero wrench, infinite for an infinite one.
tribos_status tribos_disk_surface_gauge_f32(const struct tribos_disk_surface_f32 *surface,
                                            const struct tribos_wrench_f32 *wrench,
                                            float *gauge);

// The motion caused by a push, scaled to |velocity|^2 + (spin radius)^2 = 1.
// Special values: zero for the zero wrench.
tribos_status tribos_disk_surface_motion_f32(const struct tribos_disk_surface_f32 *surface,
                                             const struct tribos_wrench_f32 *push,
                                             struct tribos_twist_f32 *twist);

// The wrench scaled to the surface. Special values: the zero wrench is unchanged.
tribos_status tribos_disk_surface_scale_f32(const struct tribos_disk_surface_f32 *surface,
                                            const struct tribos_wrench_f32 *wrench,
                                            struct tribos_wrench_f32 *scaled);

// The nearest wrench of the set in the norm sqrt(|d force|^2 + (d torque/length)^2); a length of
// 0 represents the radius. Special values: NaN for a negative or infinite length.
tribos_status tribos_disk_surface_project_f32(const struct tribos_disk_surface_f32 *surface,
                                              const struct tribos_wrench_f32 *wrench,
                                              float length,
                                              struct tribos_projection_f32 *projection);

// As tribos_disk_surface_support_f32, for the ellipsoid.
tribos_status tribos_ellipsoid_support_f32(const struct tribos_ellipsoid_f32 *ellipsoid,
                                           const struct tribos_twist_f32 *twist,
                                           float *power);

// As tribos_disk_surface_wrench_f32, for the ellipsoid.
tribos_status tribos_ellipsoid_wrench_f32(const struct tribos_ellipsoid_f32 *ellipsoid,
                                          const struct tribos_twist_f32 *twist,
                                          struct tribos_wrench_f32 *wrench);

// As tribos_disk_surface_gauge_f32, for the ellipsoid.
tribos_status tribos_ellipsoid_gauge_f32(const struct tribos_ellipsoid_f32 *ellipsoid,
                                         const struct tribos_wrench_f32 *wrench,
                                         float *gauge);

// As tribos_disk_surface_motion_f32, for the ellipsoid.
tribos_status tribos_ellipsoid_motion_f32(const struct tribos_ellipsoid_f32 *ellipsoid,
                                          const struct tribos_wrench_f32 *push,
                                          struct tribos_twist_f32 *twist);

// As tribos_disk_surface_scale_f32, for the ellipsoid.
tribos_status tribos_ellipsoid_scale_f32(const struct tribos_ellipsoid_f32 *ellipsoid,
                                         const struct tribos_wrench_f32 *wrench,
                                         struct tribos_wrench_f32 *scaled);

// As tribos_disk_surface_project_f32, for the ellipsoid.
tribos_status tribos_ellipsoid_project_f32(const struct tribos_ellipsoid_f32 *ellipsoid,
                                           const struct tribos_wrench_f32 *wrench,
                                           float length,
                                           struct tribos_projection_f32 *projection);

// Prepares a polygon, convex or not, under uniform pressure. `corners` holds the corners of `loops` loops
// one after another, `counts` how many each has: first the outer loop, then holes inside of it and outside
// of each other, clockwise or counterclockwise. `memory` has room for `room` edges, one a corner is needed.
// Domain: 3 or more finite corners a loop; edges meet only at the corners that they share.
// Cost: the number of corners squared. After a refusal the content of `memory` is undefined.
tribos_status tribos_polygon_new_f32(const struct tribos_point_f32 *corners,
                                     const size_t *counts,
                                     size_t loops,
                                     struct tribos_edge_f32 *memory,
                                     size_t room,
                                     struct tribos_polygon_f32 *polygon);

// Moves the centre of pressure of a uniform polygon to `centre`, by a pressure that is linear over the
// area. Rewrites the polygon and the memory of its edges: copies of it are lost. TRIBOS_STATUS_NEGATIVE if
// the patch would lift off, in a rectangle a x b beyond |dx|/a + |dy|/b = 1/6 from its middle, and
// TRIBOS_STATUS_LEANS if the pressure is linear already; refusals leave polygon and edges as they were.
tribos_status tribos_polygon_lean_f32(struct tribos_polygon_f32 *polygon,
                                      const struct tribos_point_f32 *centre);

// Wrench of Coulomb friction on a polygon, against its twist. Special values: zero at rest.
// Accuracy: 6e-15 of coefficient x load, and x radius, about the centre of pressure, under linear pressure
// 8e-15 (f32: 4e-6), for patches up to 10 times as long as wide.
tribos_status tribos_polygon_wrench_f32(const struct tribos_polygon_f32 *polygon,
                                        float coefficient,
                                        float load,
                                        const struct tribos_twist_f32 *twist,
                                        struct tribos_wrench_f32 *wrench);

// Wrench and Jacobian, which is symmetric. Special values: both zero at rest. Accuracy of the Jacobian,
// of its largest entry with the radius as the unit of length: 5e-14
// (f32: 1e-5).
tribos_status tribos_polygon_wrench_jacobian_f32(const struct tribos_polygon_f32 *polygon,
                                                 float coefficient,
                                                 float load,
                                                 const struct tribos_twist_f32 *twist,
                                                 struct tribos_wrench_f32 *wrench,
                                                 struct tribos_jacobian_f32 *jacobian);

// The limit surface of a polygon with force_limit = coefficient x load: the smallest factor g >= 0 with
// wrench/g in the set. Below 1 friction holds the patch, above 1 it slides. Special values: 0 for the zero
// wrench, infinite for an infinite one. Accuracy: 1e-14 (f32: 1e-5) with the origin at most a few radii away.
// Cost: about 6 wrenches with Jacobian, at most 13.
tribos_status tribos_polygon_gauge_f32(const struct tribos_polygon_f32 *polygon,
                                       float force_limit,
                                       const struct tribos_wrench_f32 *wrench,
                                       float *gauge);

// The motion caused by a push, scaled to |velocity|^2 + (spin length)^2 = 1, where length is the radius
// plus the distance of the centre of pressure from the origin. Special values: zero for the zero wrench.
tribos_status tribos_polygon_motion_f32(const struct tribos_polygon_f32 *polygon,
                                        float force_limit,
                                        const struct tribos_wrench_f32 *push,
                                        struct tribos_twist_f32 *twist);

// The nearest wrench of the set in the norm sqrt(|d force|^2 + (d torque/length)^2); a length of 0
// represents that of tribos_polygon_motion_f32. Special values: NaN for a negative or infinite length.
tribos_status tribos_polygon_project_f32(const struct tribos_polygon_f32 *polygon,
                                         float force_limit,
                                         const struct tribos_wrench_f32 *wrench,
                                         float length,
                                         struct tribos_projection_f32 *projection);

// Gauge of a wrench on an annulus under uniform pressure, as tribos_disk_surface_gauge_f32 with
// force_limit = coefficient x load.
tribos_status tribos_annulus_gauge_f32(const struct tribos_round_f32 *patch,
                                       float inner_ratio,
                                       float load,
                                       const struct tribos_wrench_f32 *wrench,
                                       float *gauge);

// The nearest wrench that an annulus can carry, as tribos_disk_surface_project_f32.
tribos_status tribos_annulus_project_f32(const struct tribos_round_f32 *patch,
                                         float inner_ratio,
                                         float load,
                                         const struct tribos_wrench_f32 *wrench,
                                         float length,
                                         struct tribos_projection_f32 *projection);

// Gauge of a wrench under Hertz' pressure, as tribos_disk_surface_gauge_f32.
tribos_status tribos_hertz_gauge_f32(const struct tribos_round_f32 *patch,
                                     float load,
                                     const struct tribos_wrench_f32 *wrench,
                                     float *gauge);

// The nearest wrench that a Hertz contact can carry, as tribos_disk_surface_project_f32.
tribos_status tribos_hertz_project_f32(const struct tribos_round_f32 *patch,
                                       float load,
                                       const struct tribos_wrench_f32 *wrench,
                                       float length,
                                       struct tribos_projection_f32 *projection);

// Gauge of a wrench on a ring, as tribos_disk_surface_gauge_f32.
tribos_status tribos_ring_gauge_f32(const struct tribos_round_f32 *patch,
                                    float load,
                                    const struct tribos_wrench_f32 *wrench,
                                    float *gauge);

// The nearest wrench that a ring can carry, as tribos_disk_surface_project_f32.
tribos_status tribos_ring_project_f32(const struct tribos_round_f32 *patch,
                                      float load,
                                      const struct tribos_wrench_f32 *wrench,
                                      float length,
                                      struct tribos_projection_f32 *projection);

// Gauge of a wrench on a rigid flat punch, as tribos_disk_surface_gauge_f32.
tribos_status tribos_punch_gauge_f32(const struct tribos_round_f32 *patch,
                                     float load,
                                     const struct tribos_wrench_f32 *wrench,
                                     float *gauge);

// The nearest wrench that a rigid flat punch can carry, as tribos_disk_surface_project_f32.
tribos_status tribos_punch_project_f32(const struct tribos_round_f32 *patch,
                                       float load,
                                       const struct tribos_wrench_f32 *wrench,
                                       float length,
                                       struct tribos_projection_f32 *projection);

// Gauge of a wrench on `count` nodes, as tribos_polygon_gauge_f32. Two or more places carry load.
// Cost: the number of nodes times a few.
tribos_status tribos_nodes_gauge_f32(const struct tribos_node_f32 *nodes,
                                     size_t count,
                                     float force_limit,
                                     const struct tribos_wrench_f32 *wrench,
                                     float *gauge);

// The nearest wrench that `count` nodes can carry, as tribos_polygon_project_f32.
tribos_status tribos_nodes_project_f32(const struct tribos_node_f32 *nodes,
                                       size_t count,
                                       float force_limit,
                                       const struct tribos_wrench_f32 *wrench,
                                       float length,
                                       struct tribos_projection_f32 *projection);

// What of a polygon lies to the left of the line through `point` along `direction`, under the same pressure:
// the part of a patch on one of two surfaces. `share` is its part of the load; where it is 0 nothing lies
// there, and no piece is written. `memory` has room for `room` edges, other than those of the polygon: twice as
// many are always enough. Accuracy: both pieces of a patch have its friction together to rounding.
// TRIBOS_STATUS_NODE_POSITION for a point that is not finite, TRIBOS_STATUS_OUTLINE for no direction,
// TRIBOS_STATUS_FULL for too little room.
tribos_status tribos_polygon_within_f32(const struct tribos_polygon_f32 *polygon,
                                        const struct tribos_point_f32 *point,
                                        const struct tribos_point_f32 *direction,
                                        struct tribos_edge_f32 *memory,
                                        size_t room,
                                        struct tribos_polygon_f32 *piece,
                                        float *share);

// A disk about any centre under one of the pressures, a tribos_pressure. Domain: a finite centre;
// 0 < radius < inf. Alone and centred in the origin tribos_disk_wrench_f32 is quicker.
tribos_status tribos_shape_disk_f32(uint32_t pressure,
                                    const struct tribos_point_f32 *centre,
                                    float radius,
                                    struct tribos_shape_f32 *shape);

// An ellipse about any centre with semi-axes along x and y under one of the pressures, a tribos_pressure.
// Domain: a finite centre; positive, finite semi-axes whose quotient is at most 1e6.
// Accuracy, of coefficient x load, and x radius: 1e-14 (f32: 1e-6) for aspect ratios up to 1e3; Jacobian 1e-12
// (f32: 1e-5) of its largest entry.
tribos_status tribos_shape_ellipse_f32(uint32_t pressure,
                                       const struct tribos_point_f32 *centre,
                                       const struct tribos_point_f32 *semi_axes,
                                       struct tribos_shape_f32 *shape);

// The ellipse centre + p cos t + q sin t with two half-diameters p and q, in any direction: semi-axes where they
// are normal to each other. Otherwise as tribos_shape_ellipse_f32.
tribos_status tribos_shape_turned_ellipse_f32(uint32_t pressure,
                                              const struct tribos_point_f32 *centre,
                                              const struct tribos_point_f32 *half_diameters,
                                              struct tribos_shape_f32 *shape);

// A polygon under uniform or leaning pressure, whose edges stay where they are.
tribos_status tribos_shape_polygon_f32(const struct tribos_polygon_f32 *polygon,
                                       struct tribos_shape_f32 *shape);

// An annulus about any centre under the pressure 1/r, as a clutch, a pivot or a thrust bearing that has worn in.
// Domain: a finite centre; 0 <= inner_ratio <= 0.999999; 0 < radius < inf.
// Accuracy, of coefficient x load, and x radius: 2e-15 (f32: 1e-6). Cost: 16 rings, at most 96.
tribos_status tribos_shape_worn_annulus_f32(const struct tribos_point_f32 *centre,
                                            float inner_ratio,
                                            float radius,
                                            struct tribos_shape_f32 *shape);

// A straight line that carries load: a blade, a skate, the edge of a box. The centre of pressure lies `lean` from
// its middle towards `to`: 0 under uniform pressure, which is linear else. Domain: finite, different ends;
// TRIBOS_STATUS_NEGATIVE beyond a sixth of the length, where the bar would lift off.
// Accuracy, of coefficient x load, and x radius: 3e-14 (f32: 4e-6).
tribos_status tribos_shape_bar_f32(const struct tribos_point_f32 *from,
                                   const struct tribos_point_f32 *to,
                                   float lean,
                                   struct tribos_shape_f32 *shape);

// Points that stay where they are: feet, spikes, the nodes of a rule. Domain: that of tribos_nodes_gauge_f32.
tribos_status tribos_shape_points_f32(struct tribos_node_f32 *nodes,
                                      size_t count,
                                      struct tribos_shape_f32 *shape);

// Several shapes under one body as one, while all surfaces under them move alike: with coefficient x load or the
// force limit of a call the sum of all limits. Parts and their shapes stay where they are. Domain: limits with a
// finite, positive sum; TRIBOS_STATUS_CHOICE if a part is `shape` itself or several shapes.
tribos_status tribos_shape_feet_f32(const struct tribos_part_f32 *parts,
                                    size_t count,
                                    struct tribos_shape_f32 *shape);

// Gives a shape the coefficients `along` an axis of it and `across` that axis: tread, skates, grooved or brushed
// surfaces. The larger one is the coefficient, and the one in the force limit, of every call that follows.
// Rewrites the edges of a polygon and points: the polygon itself and copies are lost. Domain: positive, finite
// coefficients; an axis of any finite length but zero. TRIBOS_STATUS_AXES if the shape has two coefficients already;
// TRIBOS_STATUS_CHOICE for a worn annulus, and for several shapes, each of which takes its own;
// TRIBOS_STATUS_SEMI_AXES for an ellipse, stretched by the coefficients, of more than 1e6 to 1;
// TRIBOS_STATUS_RADIUS if the stretched patch vanishes in rounding, which loses the edges.
tribos_status tribos_shape_two_coefficients_f32(struct tribos_shape_f32 *shape,
                                                float along,
                                                float across,
                                                const struct tribos_point_f32 *axis);

// Wrench of Coulomb friction on a shape, against its twist. Special values: zero at rest.
tribos_status tribos_shape_wrench_f32(const struct tribos_shape_f32 *shape,
                                      float coefficient,
                                      float load,
                                      const struct tribos_twist_f32 *twist,
                                      struct tribos_wrench_f32 *wrench);

// Wrench and Jacobian, which is symmetric. Special values: both zero at rest.
tribos_status tribos_shape_wrench_jacobian_f32(const struct tribos_shape_f32 *shape,
                                               float coefficient,
                                               float load,
                                               const struct tribos_twist_f32 *twist,
                                               struct tribos_wrench_f32 *wrench,
                                               struct tribos_jacobian_f32 *jacobian);

// Gauge of a wrench on a shape, as tribos_polygon_gauge_f32.
tribos_status tribos_shape_gauge_f32(const struct tribos_shape_f32 *shape,
                                     float force_limit,
                                     const struct tribos_wrench_f32 *wrench,
                                     float *gauge);

// The motion caused by a push, as tribos_polygon_motion_f32.
tribos_status tribos_shape_motion_f32(const struct tribos_shape_f32 *shape,
                                      float force_limit,
                                      const struct tribos_wrench_f32 *push,
                                      struct tribos_twist_f32 *twist);

// The nearest wrench that a shape can carry, as tribos_polygon_project_f32.
tribos_status tribos_shape_project_f32(const struct tribos_shape_f32 *shape,
                                       float force_limit,
                                       const struct tribos_wrench_f32 *wrench,
                                       float length,
                                       struct tribos_projection_f32 *projection);

// One velocity-Verlet step of size duration > 0, in place. Friction stops a motion and never reverses
// it. Accuracy: second order in motion, first order at the stop. Cost: two wrenches.
tribos_status tribos_slider_verlet_step_f32(const struct tribos_slider_f32 *slider,
                                            struct tribos_motion_f32 *motion,
                                            float duration);

// Advances the motion by duration >= 0, also past rest. Accuracy: as tribos_slider_to_rest_f32.
// Cost: 8 evaluations of the wrench if the speeds change by less than a few thousandths, 12 up to
// a few hundredths; otherwise about 50 to 250.
tribos_status tribos_slider_advance_f32(const struct tribos_slider_f32 *slider,
                                        const struct tribos_motion_f32 *motion,
                                        float duration,
                                        struct tribos_advance_f32 *advance);

// Advances the motion to rest; TRIBOS_STATUS_NO_REST if it is not finite. Accuracy: 1e-13
// relative in each of time, distance and angle (f32: 5e-6), whichever motion ends first. Cost: about
// 150 evaluations of the wrench, rarely more than 500.
tribos_status tribos_slider_to_rest_f32(const struct tribos_slider_f32 *slider,
                                        const struct tribos_motion_f32 *motion,
                                        struct tribos_rest_f32 *rest);

// Kinetic energy per mass.
tribos_status tribos_slider_energy_f32(const struct tribos_slider_f32 *slider,
                                       const struct tribos_motion_f32 *motion,
                                       float *energy_per_mass);

// Power dissipated by friction, per mass.
tribos_status tribos_slider_dissipation_f32(const struct tribos_slider_f32 *slider,
                                            const struct tribos_motion_f32 *motion,
                                            float *power_per_mass);

// The motion of a body after the time dt under a constant push and the friction of a disk.
// Accuracy: second order in dt while the body slides; rest is exact.
// Special values: NaN for NaN, and where momentum/dt overflows.
tribos_status tribos_planar_disk_step_f32(const struct tribos_planar_body_f32 *body,
                                          const struct tribos_disk_surface_f32 *surface,
                                          const struct tribos_twist_f32 *twist,
                                          const struct tribos_wrench_f32 *push,
                                          float dt,
                                          struct tribos_planar_step_f32 *step);

// As tribos_planar_disk_step_f32, under the friction of an ellipsoid.
tribos_status tribos_planar_ellipsoid_step_f32(const struct tribos_planar_body_f32 *body,
                                               const struct tribos_ellipsoid_f32 *ellipsoid,
                                               const struct tribos_twist_f32 *twist,
                                               const struct tribos_wrench_f32 *push,
                                               float dt,
                                               struct tribos_planar_step_f32 *step);

// As tribos_planar_disk_step_f32 with friction that is `strength`, the static over the dynamic coefficient, times
// that of the surface while the body rests. A body at rest, whose twist is exactly zero, keeps every bit of it
// while the push lies in strength x surface; beyond, it slides under the surface in the same step. Domain:
// 1 <= strength; less counts as 1.
tribos_status tribos_planar_disk_step_sticking_f32(const struct tribos_planar_body_f32 *body,
                                                   const struct tribos_disk_surface_f32 *surface,
                                                   float strength,
                                                   const struct tribos_twist_f32 *twist,
                                                   const struct tribos_wrench_f32 *push,
                                                   float dt,
                                                   struct tribos_planar_step_f32 *step);

// As tribos_planar_disk_step_sticking_f32, on a patch of any shape with force_limit = dynamic coefficient x load,
// whose origin is the centre of mass.
tribos_status tribos_planar_shape_step_sticking_f32(const struct tribos_planar_body_f32 *body,
                                                    const struct tribos_shape_f32 *shape,
                                                    float force_limit,
                                                    float strength,
                                                    const struct tribos_twist_f32 *twist,
                                                    const struct tribos_wrench_f32 *push,
                                                    float dt,
                                                    struct tribos_planar_step_f32 *step);

// The wrench on a body that moves with `twist`. Special values: a foot that rests on its surface gives nothing.
// TRIBOS_STATUS_UNLOADED if no foot has a limit above 0.
tribos_status tribos_feet_wrench_f32(const struct tribos_foot_f32 *feet,
                                     size_t count,
                                     const struct tribos_twist_f32 *twist,
                                     struct tribos_wrench_f32 *wrench);

// Wrench and Jacobian, which is symmetric.
tribos_status tribos_feet_wrench_jacobian_f32(const struct tribos_foot_f32 *feet,
                                              size_t count,
                                              const struct tribos_twist_f32 *twist,
                                              struct tribos_wrench_f32 *wrench,
                                              struct tribos_jacobian_f32 *jacobian);

// The motion in which friction of the feet balances a push on the body: the one that a body comes to.
// Accuracy: balanced to 1e-12 of all limits (f32: 5e-5). TRIBOS_STATUS_ACCELERATES if the push is more than all
// feet carry together, TRIBOS_STATUS_MISSED if the search ended before the balance.
// Cost: 8 to 24 evaluations with Jacobian, about 12.
tribos_status tribos_feet_steady_motion_f32(const struct tribos_foot_f32 *feet,
                                            size_t count,
                                            const struct tribos_wrench_f32 *push,
                                            struct tribos_steady_motion_f32 *motion);

// The motion of a body after the time dt under a constant push and the friction of its feet, whose origin is the
// centre of mass. Accuracy: second order in dt while all feet slide; feet that come to rest on their surface do
// so in every bit. Special values: NaN for NaN.
tribos_status tribos_feet_step_f32(const struct tribos_planar_body_f32 *body,
                                   const struct tribos_foot_f32 *feet,
                                   size_t count,
                                   const struct tribos_twist_f32 *twist,
                                   const struct tribos_wrench_f32 *push,
                                   float dt,
                                   struct tribos_floor_step_f32 *step);

// Gauges of `count` wrenches, as tribos_disk_surface_gauge_f32. Domain: 0 <= load < inf.
// Special values: NaN for a negative or NaN load, unless the wrench is zero or infinite.
tribos_status tribos_disk_surface_gauge_batch_f32(const struct tribos_disk_surface_f32 *surface,
                                                  const float *loads,
                                                  const struct tribos_wrench_f32 *wrenches,
                                                  size_t count,
                                                  float *gauges);

// The motions caused by `count` pushes, as tribos_disk_surface_motion_f32; they do not depend on the load.
tribos_status tribos_disk_surface_motion_batch_f32(const struct tribos_disk_surface_f32 *surface,
                                                   const struct tribos_wrench_f32 *pushes,
                                                   size_t count,
                                                   struct tribos_twist_f32 *twists);

// Projections of `count` wrenches, as tribos_disk_surface_project_f32; a length of 0 represents the radius.
// Domain: 0 <= load < inf. Special values: NaN for a negative or NaN load, unless the wrench is zero.
tribos_status tribos_disk_surface_project_batch_f32(const struct tribos_disk_surface_f32 *surface,
                                                    const float *loads,
                                                    const struct tribos_wrench_f32 *wrenches,
                                                    size_t count,
                                                    float length,
                                                    struct tribos_projection_f32 *projections);

// Projections of `count` wrenches onto the surface of an annulus, as tribos_annulus_project_f32.
// Domain: 0 <= load < inf. Special values: NaN for a negative or NaN load, unless the wrench is zero.
tribos_status tribos_annulus_project_batch_f32(const struct tribos_round_f32 *patch,
                                               float inner_ratio,
                                               const float *loads,
                                               const struct tribos_wrench_f32 *wrenches,
                                               size_t count,
                                               float length,
                                               struct tribos_projection_f32 *projections);

// Projections of `count` wrenches onto the surface of a Hertz contact, as tribos_hertz_project_f32.
// Domain: 0 <= load < inf. Special values: NaN for a negative or NaN load, unless the wrench is zero.
tribos_status tribos_hertz_project_batch_f32(const struct tribos_round_f32 *patch,
                                             const float *loads,
                                             const struct tribos_wrench_f32 *wrenches,
                                             size_t count,
                                             float length,
                                             struct tribos_projection_f32 *projections);

// Projections of `count` wrenches onto the surface of a ring, as tribos_ring_project_f32.
// Domain: 0 <= load < inf. Special values: NaN for a negative or NaN load, unless the wrench is zero.
tribos_status tribos_ring_project_batch_f32(const struct tribos_round_f32 *patch,
                                            const float *loads,
                                            const struct tribos_wrench_f32 *wrenches,
                                            size_t count,
                                            float length,
                                            struct tribos_projection_f32 *projections);

// Projections of `count` wrenches onto the surface of a rigid flat punch, as tribos_punch_project_f32.
// Domain: 0 <= load < inf. Special values: NaN for a negative or NaN load, unless the wrench is zero.
tribos_status tribos_punch_project_batch_f32(const struct tribos_round_f32 *patch,
                                             const float *loads,
                                             const struct tribos_wrench_f32 *wrenches,
                                             size_t count,
                                             float length,
                                             struct tribos_projection_f32 *projections);

// Steps of `count` bodies alike, each with its load, motion and push, as tribos_planar_disk_step_f32.
// Domain: 0 <= load < inf. Special values: as there; NaN for a negative or NaN load, unless the body rests
// without push.
tribos_status tribos_planar_disk_step_batch_f32(const struct tribos_planar_body_f32 *body,
                                                const struct tribos_disk_surface_f32 *surface,
                                                const float *loads,
                                                const struct tribos_twist_f32 *twists,
                                                const struct tribos_wrench_f32 *pushes,
                                                size_t count,
                                                float dt,
                                                struct tribos_planar_step_f32 *steps);

// Contact geometry of two spheres; `displacement` is the vector from the first centre to the second.
// Accuracy: the normal to 4 ulp, the gap to 2 ulp of the distance.
tribos_status tribos_touch_spheres_f32(const struct tribos_vector_f32 *displacement,
                                       float first_radius,
                                       float second_radius,
                                       struct tribos_touch_f32 *touch);

// Contact geometry of a sphere, the first body, and a plate at distance `height` from its centre; `outward`
// is the plate's unit normal into the space of the sphere and is not normalised.
tribos_status tribos_touch_plate_f32(float height,
                                     const struct tribos_vector_f32 *outward,
                                     float radius,
                                     struct tribos_touch_f32 *touch);

// Prepares a contact of two spheres for a step of length dt.
tribos_status tribos_contact_spheres_f32(const struct tribos_touch_f32 *touch,
                                         const struct tribos_normal_law_f32 *law,
                                         const struct tribos_sphere_f32 *first,
                                         const struct tribos_sphere_f32 *second,
                                         float dt,
                                         struct tribos_contact_f32 *contact);

// Prepares a contact of a sphere with a plate, the second body.
tribos_status tribos_contact_plate_f32(const struct tribos_touch_f32 *touch,
                                       const struct tribos_normal_law_f32 *law,
                                       const struct tribos_sphere_f32 *first,
                                       const struct tribos_plate_f32 *second,
                                       float dt,
                                       struct tribos_contact_f32 *contact);

// Updates a contact of two spheres, with a normal impulse only.
tribos_status tribos_update_frictionless_spheres_f32(const struct tribos_contact_f32 *contact,
                                                     struct tribos_sphere_f32 *first,
                                                     struct tribos_sphere_f32 *second,
                                                     struct tribos_impulse_f32 *impulse);

// Updates a contact of two spheres, with normal impulse and sliding friction.
tribos_status tribos_update_sliding_spheres_f32(const struct tribos_contact_f32 *contact,
                                                const struct tribos_thresholds_f32 *friction,
                                                struct tribos_sphere_f32 *first,
                                                struct tribos_sphere_f32 *second,
                                                struct tribos_impulse_f32 *impulse);

// Updates a contact of two spheres, with normal impulse, sliding and torsion friction, each with its
// own threshold.
tribos_status tribos_update_sliding_torsion_spheres_f32(const struct tribos_contact_f32 *contact,
                                                        const struct tribos_thresholds_f32 *friction,
                                                        struct tribos_sphere_f32 *first,
                                                        struct tribos_sphere_f32 *second,
                                                        struct tribos_impulse_f32 *impulse);

// Updates a contact of two spheres, with normal impulse, sliding and rolling friction.
tribos_status tribos_update_sliding_rolling_spheres_f32(const struct tribos_contact_f32 *contact,
                                                        const struct tribos_thresholds_f32 *friction,
                                                        struct tribos_sphere_f32 *first,
                                                        struct tribos_sphere_f32 *second,
                                                        struct tribos_impulse_f32 *impulse);

// Updates a contact of two spheres, with normal impulse, sliding, rolling and torsion friction, each
// with its own threshold.
tribos_status tribos_update_all_spheres_f32(const struct tribos_contact_f32 *contact,
                                            const struct tribos_thresholds_f32 *friction,
                                            struct tribos_sphere_f32 *first,
                                            struct tribos_sphere_f32 *second,
                                            struct tribos_impulse_f32 *impulse);

// Updates a contact of two spheres, with normal impulse, and sliding and torsion under the common
// threshold of a uniform disk: `sliding` is mu, `torsion` is the radius of the disk over the lever, not
// a coefficient.
tribos_status tribos_update_patch_spheres_f32(const struct tribos_contact_f32 *contact,
                                              const struct tribos_thresholds_f32 *friction,
                                              struct tribos_sphere_f32 *first,
                                              struct tribos_sphere_f32 *second,
                                              struct tribos_impulse_f32 *impulse);

// Updates a contact of a sphere with a plate, with a normal impulse only.
tribos_status tribos_update_frictionless_plate_f32(const struct tribos_contact_f32 *contact,
                                                   struct tribos_sphere_f32 *first,
                                                   struct tribos_plate_f32 *second,
                                                   struct tribos_impulse_f32 *impulse);

// Updates a contact of a sphere with a plate, with normal impulse and sliding friction.
tribos_status tribos_update_sliding_plate_f32(const struct tribos_contact_f32 *contact,
                                              const struct tribos_thresholds_f32 *friction,
                                              struct tribos_sphere_f32 *first,
                                              struct tribos_plate_f32 *second,
                                              struct tribos_impulse_f32 *impulse);

// Updates a contact of a sphere with a plate, with normal impulse, sliding and torsion friction, each
// with its own threshold.
tribos_status tribos_update_sliding_torsion_plate_f32(const struct tribos_contact_f32 *contact,
                                                      const struct tribos_thresholds_f32 *friction,
                                                      struct tribos_sphere_f32 *first,
                                                      struct tribos_plate_f32 *second,
                                                      struct tribos_impulse_f32 *impulse);

// Updates a contact of a sphere with a plate, with normal impulse, sliding and rolling friction.
tribos_status tribos_update_sliding_rolling_plate_f32(const struct tribos_contact_f32 *contact,
                                                      const struct tribos_thresholds_f32 *friction,
                                                      struct tribos_sphere_f32 *first,
                                                      struct tribos_plate_f32 *second,
                                                      struct tribos_impulse_f32 *impulse);

// Updates a contact of a sphere with a plate, with normal impulse, sliding, rolling and torsion
// friction, each with its own threshold.
tribos_status tribos_update_all_plate_f32(const struct tribos_contact_f32 *contact,
                                          const struct tribos_thresholds_f32 *friction,
                                          struct tribos_sphere_f32 *first,
                                          struct tribos_plate_f32 *second,
                                          struct tribos_impulse_f32 *impulse);

// Updates a contact of a sphere with a plate, with normal impulse, and sliding and torsion under the
// common threshold of a uniform disk: `sliding` is mu, `torsion` is the radius of the disk over the
// lever, not a coefficient.
tribos_status tribos_update_patch_plate_f32(const struct tribos_contact_f32 *contact,
                                            const struct tribos_thresholds_f32 *friction,
                                            struct tribos_sphere_f32 *first,
                                            struct tribos_plate_f32 *second,
                                            struct tribos_impulse_f32 *impulse);

#ifdef __cplusplus
}  // extern "C"
#endif  // __cplusplus

#endif  /* TRIBOS_H */
