// The springs of all contacts, by atom.

#ifndef TRIBOS_CONTACT_STORE_H
#define TRIBOS_CONTACT_STORE_H

#include "vec3.h"

#include <cstdint>
#include <limits>
#include <vector>

namespace tribos {

// Springs of a contact as the atom that stores them sees it: it is the first body.
struct Springs {
  int64_t partner = 0;           // tag of the second body
  int64_t slips = 0;             // 1 if sliding and torsion together have reached their common threshold
  Vec3 sliding;                  // displacement of the second surface against the first, length
  double torsion = 0;            // turn of the second body against the first about the normal, radians
  double slope = 0;              // tangent stiffness of the normal spring at which these were measured
  double torsion_stiffness = 0;  // stiffness of the torsion spring then, force x length
};

// Force and torque on the second body at the end of a run, with the overlap that they belong to. A run that goes
// on takes them over: dashpots follow velocities in the middle of a step, which are gone by then.
struct LastForce {
  Vec3 force, moment;
  double overlap = std::numeric_limits<double>::quiet_NaN();
};

// One contact with everything that is known of it.
struct StoredContact {
  Springs springs;
  Vec3 rolling;    // turn of the second body against the first across the normal, radians
  LastForce last;

  // The same contact as the partner sees it.
  StoredContact seen_from_partner(int64_t tag) const;
};

// The contacts of atom i are a contiguous part of one array. A step writes them anew, in the order in which it visits
// them, and drops those that it does not visit.
class ContactStore {
 public:
  // Where a step has put a contact, and where it was before; -1 for a new one.
  struct Slot {
    size_t now;
    long before;
  };

  bool rolls = false;      // whether turns across the normal are stored
  bool has_last = false;   // whether last forces are stored

  void grow(int atoms);
  int count(int atom) const { return counts[atom]; }
  int largest_count(int atoms) const;
  void clear(int atom) { counts[atom] = 0; }
  void copy(int from, int to);

  // A step: begin, then for each atom its contacts, then end.
  void begin_step(int atoms, bool with_rolling, bool keep_last);
  void begin_atom(int atom);
  Slot carry(int64_t partner);
  void end_atom();
  void end_step();

  // Contacts of the current step, before it ends.
  bool keeps_last() const { return with_last; }
  Springs &springs(size_t slot) { return next.springs[slot]; }
  Vec3 &rolling(size_t slot) { return next.rolling[slot]; }
  LastForce &last(size_t slot) { return next.last[slot]; }
  // Of the step before.
  const LastForce *last_before(long slot) const { return has_last && slot >= 0 ? &now.last[slot] : nullptr; }

  // Contacts between steps.
  StoredContact contact(int atom, int index) const;
  const StoredContact *find(int atom, int64_t partner, StoredContact &found) const;
  // Replaces all contacts: `lists[i]` belongs to atom i.
  void replace(const std::vector<std::vector<StoredContact>> &lists);
  // Appends the contacts of an atom that has none.
  void append(int atom, const std::vector<StoredContact> &contacts);

  // As numbers, for messages and restart files.
  int packed_size(int atom) const { return HEADER + counts[atom] * NUMBERS; }
  int packed_size_of(int contacts) const { return HEADER + contacts * NUMBERS; }
  int pack(int atom, double *to) const;
  static int pack_one(const StoredContact &contact, double *to);
  static int unpack_one(const double *from, StoredContact &contact);
  int unpack(int atom, const double *from);
  static constexpr int HEADER = 1, NUMBERS = 18;

  double memory_usage() const;

 private:
  struct Pool {
    std::vector<Springs> springs;
    std::vector<Vec3> rolling;
    std::vector<LastForce> last;
    void clear();
  };

  void push(Pool &pool, const StoredContact &contact);

  Pool now, next;
  std::vector<size_t> firsts, next_firsts;
  std::vector<int> counts, next_counts;
  bool with_last = false;
  int atom = 0;
  size_t cursor = 0;
};

}    // namespace tribos

#endif
