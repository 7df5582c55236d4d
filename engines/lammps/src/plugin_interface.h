// What a plugin tells LAMMPS about a style, as documented on the page "Writing plugins" of its developer guide. The
// header of the PLUGIN package is not part of binary distributions.

#ifndef TRIBOS_PLUGIN_INTERFACE_H
#define TRIBOS_PLUGIN_INTERFACE_H

extern "C" {

struct PluginStyle {
  const char *lammps_version;
  const char *kind;    // "pair", "fix", ...
  const char *name;
  const char *description;
  const char *author;
  // A function (LAMMPS *) -> Pair * for pair styles, (LAMMPS *, int, char **) -> Fix * for fixes.
  void *create;
  void *library;
};

typedef void (*RegisterStyle)(PluginStyle *, void *lammps);

}

#endif
