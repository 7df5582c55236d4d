// Entry point: registers the styles with LAMMPS.

#include "fix_contact_history.h"
#include "fix_wall_gran_tribos.h"
#include "pair_gran_tribos.h"
#include "plugin_interface.h"

using namespace LAMMPS_NS;

namespace {

Pair *create_pair(LAMMPS *lmp)
{
  return new PairGranTribos(lmp);
}

Fix *create_history(LAMMPS *lmp, int narg, char **arg)
{
  return new FixContactHistory(lmp, narg, arg);
}

Fix *create_wall(LAMMPS *lmp, int narg, char **arg)
{
  return new FixWallGranTribos(lmp, narg, arg);
}

}    // namespace

extern "C" void lammpsplugin_init(void *lmp, void *library, void *register_style)
{
  const auto add = [=](const char *kind, const char *name, const char *description, void *create) {
    PluginStyle style = {TRIBOS_LAMMPS_VERSION, kind, name, description, "Tribos", create, library};
    ((RegisterStyle) register_style)(&style, lmp);
  };
  add("pair", "gran/tribos", "coupled sliding and torsion friction of spheres", (void *) &create_pair);
  add("fix", "wall/gran/tribos", "plane walls with the law of pair gran/tribos", (void *) &create_wall);
  add("fix", "TRIBOS/HISTORY", "springs of the contacts of pair gran/tribos", (void *) &create_history);
}
