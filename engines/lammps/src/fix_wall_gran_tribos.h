/* -*- c++ -*- ----------------------------------------------------------
   Includes headers of LAMMPS and is therefore distributed under the GNU General Public License, version 2.
------------------------------------------------------------------------- */

#ifndef LMP_FIX_WALL_GRAN_TRIBOS_H
#define LMP_FIX_WALL_GRAN_TRIBOS_H

#include "contact_block.h"
#include "contact_law.h"
#include "contact_store.h"

#include "fix.h"

#include <string>
#include <vector>

namespace LAMMPS_NS {

// Walls with the law of pair gran/tribos: planes, fixed, moving or driven by a force, and surfaces of regions.
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
  // A number, or the equal-style variable that gives it at every step.
  struct Value {
    double number = 0;
    std::string variable;
  };

  struct Wall {
    std::string region_id;       // of a wall that is the surface of a region; empty: a plane
    class Region *region = nullptr;
    int axis = 0;
    double side = 1;             // 1: grains lie above the plane along the axis; -1: below
    bool at_edge = false;        // follows the side of the box
    double position = 0;
    tribos::Vec3 velocity;
    bool driven = false;         // moves along its axis under `push` and the grains
    double before = 0;           // velocity across at the step before
    Value follows[3];            // velocities
    Value push;                  // towards the grains
    double mass = 0;
    tribos::Vec3 force;          // of the grains on the wall
  };

  // Where a grain meets a wall.
  struct Meeting {
    int wall;
    int64_t partner;             // of its springs
    double overlap;
    tribos::Vec3 normal, before; // towards the wall, now and a step ago
    tribos::Vec3 velocity, spin; // of the wall there
  };

  int parse_wall(int narg, char **arg, int iarg);
  double number(int narg, char **arg, int iarg, const char *of) const;
  Value value(int narg, char **arg, int iarg, const char *of) const;
  double now(const Value &) const;
  void follow();
  void meet_plane(int atom, int wall);
  void meet_region(int atom, int wall, bool advances);
  void touch(int atom, const Meeting &, tribos::Contact &) const;
  void collect(tribos::ContactBlock &, bool advances);
  void accelerate(double dt);

  tribos::ContactLaw law;
  std::vector<Wall> walls;
  std::vector<Meeting> met;    // of one grain
  tribos::ContactStore store;
  int most = 0;            // contacts of a grain with the walls
  bool varies = false;     // a velocity or a push follows a variable
  bool changed = false;    // the law is another one than in the restart file
};

}    // namespace LAMMPS_NS

#endif
