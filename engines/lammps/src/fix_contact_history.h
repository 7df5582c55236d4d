/* -*- c++ -*- ----------------------------------------------------------
   Includes headers of LAMMPS and is therefore distributed under the GNU General Public License, version 2.
------------------------------------------------------------------------- */

#ifndef LMP_FIX_CONTACT_HISTORY_H
#define LMP_FIX_CONTACT_HISTORY_H

#include "contact_store.h"

#include "fix.h"

namespace LAMMPS_NS {

// Keeps the springs of the contacts of pair gran/tribos with the atoms: they migrate with them between processors and
// are part of restart files. The pair style makes this fix; it is not meant for input scripts.
class FixContactHistory : public Fix {
 public:
  FixContactHistory(class LAMMPS *, int, char **);
  ~FixContactHistory() override;
  int setmask() override;
  void pre_exchange() override;
  void min_pre_exchange() override;
  void post_run() override;
  void write_restart(FILE *) override;

  void grow_arrays(int) override;
  void copy_arrays(int, int, int) override;
  void set_arrays(int) override;
  int pack_exchange(int, double *) override;
  int unpack_exchange(int, double *) override;
  int pack_restart(int, double *) override;
  void unpack_restart(int, int) override;
  int size_restart(int) override;
  int maxsize_restart() override;
  int pack_reverse_comm_size(int, int) override;
  int pack_reverse_comm(int, int, double *) override;
  void unpack_reverse_comm(int, int *, double *) override;
  double memory_usage() override;

  tribos::ContactStore store;
  // Local index of the second body of each contact of the last step, in the order of the atoms.
  std::vector<int> partners;

  // A step of the pair style has ended: `partners` belongs to the store and to the atoms as they are now.
  void step_ended();

 private:
  void share_with_partners();

  bool fresh = false;                // contacts are stored by one of their atoms only
  int local_atoms = 0, all_atoms = 0;    // at the last step of the pair style
  // While contacts are shared: what owned atoms and ghosts have.
  std::vector<std::vector<tribos::StoredContact>> lists;
};

}    // namespace LAMMPS_NS

#endif
