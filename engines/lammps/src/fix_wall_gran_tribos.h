/* -*- c++ -*- ----------------------------------------------------------
   Includes headers of LAMMPS and is therefore distributed under the GNU General Public License, version 2.
------------------------------------------------------------------------- */

#ifndef LMP_FIX_WALL_GRAN_TRIBOS_H
#define LMP_FIX_WALL_GRAN_TRIBOS_H

#include "contact_block.h"
#include "contact_law.h"
#include "contact_store.h"

#include "fix.h"

#include <vector>

namespace LAMMPS_NS {

// Plane walls, fixed, moving or driven by a force, with the law of pair gran/tribos.
class FixWallGranTribos : public Fix {
 public:
  FixWallGranTribos(class LAMMPS *, int, char **);
  ~FixWallGranTribos() override;
  int setmask() override;
  void init() override;
  void setup(int) override;
  void initial_integrate(int) override;
  void post_force(int) override;
  void final_integrate() override;

  void write_restart(FILE *) override;
  void restart(char *) override;
  void grow_arrays(int) override;
  void copy_arrays(int, int, int) override;
  void set_arrays(int) override;
  int pack_exchange(int, double *) override;
  int unpack_exchange(int, double *) override;
  int pack_restart(int, double *) override;
  void unpack_restart(int, int) override;
  int size_restart(int) override;
  int maxsize_restart() override;
  double compute_array(int, int) override;
  double memory_usage() override;

 private:
  struct Wall {
    int axis = 0;
    double side = 1;             // 1: grains lie above the plane along the axis; -1: below
    bool at_edge = false;        // follows the side of the box
    double position = 0;
    tribos::Vec3 velocity;
    bool driven = false;         // moves along its axis under `push` and the grains
    double push = 0, mass = 0;   // push towards the grains
    tribos::Vec3 force;          // of the grains on the wall
  };

  int parse_wall(int narg, char **arg, int iarg);
  double number(int narg, char **arg, int iarg, const char *of) const;
  void touch(int atom, int wall, double overlap, tribos::Contact &) const;
  void collect(tribos::ContactBlock &, bool advances);
  void accelerate(double dt);

  tribos::ContactLaw law;
  std::vector<Wall> walls;
  tribos::ContactStore store;
  bool changed = false;    // the law is another one than in the restart file
};

}    // namespace LAMMPS_NS

#endif
