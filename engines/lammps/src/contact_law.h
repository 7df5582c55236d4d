// Laws of a contact: springs, dashpots, cohesion and thresholds of friction.

#ifndef TRIBOS_CONTACT_LAW_H
#define TRIBOS_CONTACT_LAW_H

#include <string>

namespace tribos {

// How the spring of the normal force grows with the overlap d.
enum class Normal : int {
  HOOKE,    // k d
  HERTZ     // 4/3 E sqrt(r_eff) d^(3/2)
};

// Which sliding forces and torques about the normal a contact holds together.
enum class Coupling : int {
  NONE,         // sliding alone; no torque about the normal
  SEPARATE,     // each up to its own limit
  ELLIPSOID,    // the ellipsoid with these limits as half axes
  EXACT         // the limit surface of a disk under uniform pressure
};

// Stiffness of the spring of torsion.
enum class TorsionSpring : int {
  AREA,      // k_t a^2/2: a disk of radius a on which springs of total stiffness k_t are spread
  INERTIA    // normal stiffness times effective inertia over effective mass: the normal frequency
};

// The parameters of one pair of types, or of a wall. Plain data: a restart file holds its bytes.
struct ContactLaw {
  Normal normal = Normal::HOOKE;
  Coupling coupling = Coupling::EXACT;
  TorsionSpring torsion_spring = TorsionSpring::AREA;
  int disk_of_overlap = 1;      // 1: contact radius a = sqrt(r_eff overlap); 0: from mu_torsion
  double stiffness = 0;         // k (force/length) or contact modulus E (force/area)
  double damping = 0;           // damping ratio of all springs; 1 is critical
  double tangential = 2.0 / 7;  // stiffness of the sliding spring over that of the normal one
  double mu = 0;                // threshold of sliding, over P
  double mu_torsion = 0;        // threshold of torsion, over P r_eff; unused with disk_of_overlap
  double mu_rolling = 0;        // threshold of rolling, over P r_eff; 0: no rolling resistance
  double cohesion = 0;          // constant pull, force
  double range = 0;             // largest gap across which it pulls, length

  bool twists() const { return coupling != Coupling::NONE && (disk_of_overlap ? mu > 0 : mu_torsion > 0); }
  bool rolls() const { return mu_rolling > 0; }
  bool turns_with_inertia() const { return rolls() || torsion_spring == TorsionSpring::INERTIA; }
  // Reads "hooke K" or "hertz E" and the keywords after it, from arg[first] on, and stops before the first word
  // of `ends`. Returns the index of what follows; on bad input `problem` says what and what would be valid.
  int parse(int narg, char **arg, int first, bool (*ends)(const std::string &), std::string &problem);
};

bool operator==(const ContactLaw &, const ContactLaw &);

}    // namespace tribos

#endif
