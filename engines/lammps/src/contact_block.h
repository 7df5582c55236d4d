// Forces of many contacts at once.

#ifndef TRIBOS_CONTACT_BLOCK_H
#define TRIBOS_CONTACT_BLOCK_H

#include "contact_law.h"
#include "contact_store.h"
#include "vec3.h"

namespace tribos {

// Contact of two bodies. Quantities of motion are those of the second body against the first.
struct Contact {
  // Which bodies, for whoever collects the forces.
  int first, second;
  double first_lever, second_lever;    // centres to contact point, length
  Vec3 branch;                         // from the centre of the second body to that of the first

  const ContactLaw *law;
  ContactStore::Slot slot;
  Vec3 normal;           // unit vector from the first body to the second
  Vec3 normal_before;    // at the step before
  double overlap;        // length; negative across a gap
  double r_eff;          // reduced radius, length
  double mass;           // reduced mass
  double inertia;        // reduced moment of inertia
  Vec3 velocity;         // of the surfaces, length/time
  Vec3 spin;             // difference of the spins, radians/time
  double turning;        // mean spin of both bodies about the normal, radians/time

  // Results.
  Vec3 force;       // on the second body
  Vec3 moment;      // torque on the second body beyond that of the force; its opposite acts on the first
  double energy;    // of springs and cohesion
};

// Contacts are collected and evaluated together: then the limit surface is prepared once for all that slip.
class ContactBlock {
 public:
  static constexpr int CAPACITY = 64;

  bool is_full() const { return count == CAPACITY; }
  // A contact to fill in. Its results are undefined until `evaluate`.
  Contact &add() { return contacts[count++]; }
  void clear() { count = 0; }
  Contact *begin() { return contacts; }
  Contact *end() { return contacts + count; }

  // Springs and forces after a step of length `dt`; with `advances` false the forces of springs that stay as they are.
  // Returns the sentence of a refusal of the kernel, or nothing.
  const char *evaluate(ContactStore &store, double dt, bool advances, bool with_energy);

 private:
  // What springs and dashpots across the normal hold at most, and what they would like.
  struct Grip {
    double bound;            // P: what the normal spring and dashpot push with
    double slope;            // tangent stiffness of the normal spring
    double dashpot;          // constant of the normal dashpot
    double k_sliding, k_torsion, k_rolling;
    double disk;             // radius of the contact disk
    double length;           // root of k_torsion/k_sliding over the disk's radius
    double force_limit, torque_limit, rolling_limit;
    Vec3 trial, held;        // sliding force on the first body
    double trial_torque, held_torque;
    bool slips;              // the springs have reached the common threshold of sliding and torsion
    Vec3 elastic_rolling;    // rolling torque of the spring
  };

  void prepare(const Contact &contact, Grip &grip) const;
  void stretch(const Contact &contact, Grip &grip, ContactStore &store, double dt) const;
  void relax(const Contact &contact, const Grip &grip, ContactStore &store) const;
  void load_with_dashpots(const Contact &contact, Grip &grip, ContactStore &store) const;
  void finish(Contact &contact, const Grip &grip, ContactStore &store, bool with_energy) const;
  const char *hold(bool except_slipping);

  int count = 0;
  Contact contacts[CAPACITY];
  Grip grips[CAPACITY];
};

}    // namespace tribos

#endif
