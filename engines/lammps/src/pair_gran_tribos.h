/* -*- c++ -*- ----------------------------------------------------------
   Includes headers of LAMMPS and is therefore distributed under the GNU General Public License, version 2.
------------------------------------------------------------------------- */

#ifndef LMP_PAIR_GRAN_TRIBOS_H
#define LMP_PAIR_GRAN_TRIBOS_H

#include "contact_block.h"
#include "contact_law.h"

#include "pair.h"

#include <vector>

namespace LAMMPS_NS {

// Spheres that slide and spin against each other under the exact coupled friction of a disk.
class PairGranTribos : public Pair {
 public:
  PairGranTribos(class LAMMPS *);
  ~PairGranTribos() override;
  void compute(int, int) override;
  void settings(int, char **) override;
  void coeff(int, char **) override;
  void init_style() override;
  double init_one(int, int) override;
  void write_restart(FILE *) override;
  void read_restart(FILE *) override;
  double single(int, int, int, int, double, double, double, double &) override;

 private:
  void allocate();
  void find_largest_radii();
  double touch(int i, int j, tribos::Contact &) const;
  void collect(tribos::ContactBlock &, bool advances);

  std::vector<std::vector<tribos::ContactLaw>> laws;
  class FixContactHistory *history = nullptr;
  bool rolls = false, attracts = false;
  bool changed = true;    // laws may have changed since the last run
  double widest = 0;      // largest gap across which cohesion acts
  std::vector<int> touching;    // neighbours of an atom that it touches, while a step looks for them
  int frozen = 0;         // group bit of frozen atoms
  std::vector<double> radius_moving, radius_frozen;    // largest ones, by type
};

}    // namespace LAMMPS_NS

#endif
