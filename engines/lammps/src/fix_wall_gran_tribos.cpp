/* ----------------------------------------------------------------------
   Includes headers of LAMMPS and is therefore distributed under the GNU General Public License, version 2.
------------------------------------------------------------------------- */

#include "fix_wall_gran_tribos.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "modify.h"
#include "output.h"
#include "update.h"
#include "utils.h"

#include <cmath>
#include <cstdlib>
#include <cstring>

using namespace LAMMPS_NS;
using namespace FixConst;
using tribos::Contact;
using tribos::ContactBlock;
using tribos::ContactLaw;
using tribos::ContactStore;
using tribos::LastForce;
using tribos::Vec3;

namespace {

// 2/5 m R^2 over m R^2 of a solid sphere.
const double SOLID_SPHERE = 0.4;

bool names_wall(const std::string &word)
{
  for (const char *name : {"xlo", "xhi", "ylo", "yhi", "zlo", "zhi"})
    if (word == name) return true;
  return false;
}

double &component(Vec3 &v, int axis)
{
  return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

Vec3 along(int axis, double length)
{
  Vec3 v;
  component(v, axis) = length;
  return v;
}

}    // namespace

FixWallGranTribos::FixWallGranTribos(LAMMPS *lmp, int narg, char **arg) : Fix(lmp, narg, arg)
{
  std::string problem;
  int iarg = law.parse(narg, arg, 3, names_wall, problem);
  if (!problem.empty()) error->all(FLERR, "Fix wall/gran/tribos: {}", problem);
  while (iarg < narg) iarg = parse_wall(narg, arg, iarg);
  if (walls.empty())
    error->all(FLERR, "Fix wall/gran/tribos: no wall; give one of xlo, xhi, ylo, yhi, zlo, zhi and its position");

  restart_global = restart_peratom = 1;
  create_attribute = 1;
  maxexchange = store.packed_size_of(walls.size());
  time_integrate = 0;
  array_flag = 1;
  size_array_rows = walls.size();
  size_array_cols = 5;
  global_freq = 1;
  extarray = 0;

  FixWallGranTribos::grow_arrays(atom->nmax);
  atom->add_callback(Atom::GROW);
  atom->add_callback(Atom::RESTART);
}

FixWallGranTribos::~FixWallGranTribos()
{
  atom->delete_callback(id, Atom::GROW);
  atom->delete_callback(id, Atom::RESTART);
}

double FixWallGranTribos::number(int narg, char **arg, int iarg, const char *of) const
{
  if (iarg >= narg) error->all(FLERR, "Fix wall/gran/tribos: a number is missing after '{}'", of);
  char *end = nullptr;
  const double value = std::strtod(arg[iarg], &end);
  if (end == arg[iarg] || *end != '\0' || !std::isfinite(value))
    error->all(FLERR, "Fix wall/gran/tribos: '{} {}': expected a finite number", of, arg[iarg]);
  return value;
}

// One wall, its position and its options; returns the index of what follows.
int FixWallGranTribos::parse_wall(int narg, char **arg, int iarg)
{
  const std::string name = arg[iarg];
  if (!names_wall(name))
    error->all(FLERR,
               "Fix wall/gran/tribos: unknown keyword '{}': expected a wall (xlo, xhi, ylo, yhi, zlo, zhi), or 'velocity' "
               "or 'piston' after a wall's position",
               name);
  Wall wall;
  wall.axis = name[0] - 'x';
  wall.side = name[1] == 'l' ? 1 : -1;
  for (const Wall &other : walls)
    if (other.axis == wall.axis && other.side == wall.side)
      error->all(FLERR, "Fix wall/gran/tribos: wall {} is given twice", name);
  if (iarg + 1 >= narg)
    error->all(FLERR, "Fix wall/gran/tribos: the position of wall {} is missing: a number or EDGE", name);
  wall.at_edge = std::strcmp(arg[iarg + 1], "EDGE") == 0;
  if (!wall.at_edge) wall.position = number(narg, arg, iarg + 1, name.c_str());
  iarg += 2;

  while (iarg < narg && !names_wall(arg[iarg])) {
    const std::string option = arg[iarg];
    if (option == "velocity") {
      wall.velocity = {number(narg, arg, iarg + 1, "velocity"), number(narg, arg, iarg + 2, "velocity VX"),
                       number(narg, arg, iarg + 3, "velocity VX VY")};
      iarg += 4;
    } else if (option == "piston") {
      wall.driven = true;
      wall.push = number(narg, arg, iarg + 1, "piston");
      wall.mass = number(narg, arg, iarg + 2, "piston F");
      if (wall.mass <= 0)
        error->all(FLERR, "Fix wall/gran/tribos: 'piston {} {}': the mass must be positive", arg[iarg + 1], arg[iarg + 2]);
      iarg += 3;
    } else
      error->all(FLERR, "Fix wall/gran/tribos: unknown option '{}' of wall {}: expected velocity or piston", option, name);
  }
  const bool moves = wall.driven || component(wall.velocity, wall.axis) != 0;
  if (wall.at_edge && moves)
    error->all(FLERR, "Fix wall/gran/tribos: wall {} cannot move and stay at the EDGE of the box", name);
  walls.push_back(wall);
  return iarg;
}

int FixWallGranTribos::setmask()
{
  return INITIAL_INTEGRATE | POST_FORCE | FINAL_INTEGRATE;
}

void FixWallGranTribos::init()
{
  if (!atom->radius_flag || !atom->rmass_flag || !atom->omega_flag || !atom->torque_flag)
    error->all(FLERR, "Fix wall/gran/tribos needs atom style sphere: radius, mass, omega and torque of each atom");
  if (domain->triclinic) error->all(FLERR, "Fix wall/gran/tribos needs an orthogonal box");
  for (const Wall &wall : walls)
    if (domain->periodicity[wall.axis])
      error->all(FLERR, "Fix wall/gran/tribos: a wall across {}, but the box is periodic there", "xyz"[wall.axis]);
}

void FixWallGranTribos::setup(int vflag)
{
  post_force(vflag);
}

// Driven walls, by the velocity Verlet scheme of the grains.
void FixWallGranTribos::accelerate(double dt)
{
  for (Wall &wall : walls)
    if (wall.driven)
      component(wall.velocity, wall.axis) +=
          dt * (component(wall.force, wall.axis) + wall.side * wall.push) / wall.mass;
}

void FixWallGranTribos::initial_integrate(int)
{
  accelerate(0.5 * update->dt);
  for (Wall &wall : walls) wall.position += component(wall.velocity, wall.axis) * update->dt;
}

void FixWallGranTribos::final_integrate()
{
  accelerate(0.5 * update->dt);
}

// Fills in a contact of an atom, the first body, with a wall.
void FixWallGranTribos::touch(int i, int which, double overlap, Contact &c) const
{
  const Wall &wall = walls[which];
  c.first = i;
  c.second = which;
  c.law = &law;
  c.overlap = overlap;
  c.normal = c.normal_before = along(wall.axis, -wall.side);
  c.r_eff = atom->radius[i];
  c.first_lever = atom->radius[i] - overlap;
  c.second_lever = 0;
  c.mass = atom->rmass[i];
  c.inertia = SOLID_SPHERE * c.mass * c.r_eff * c.r_eff;
  const Vec3 omega(atom->omega[i]);
  c.velocity = wall.velocity - Vec3(atom->v[i]) - cross(omega * c.first_lever, c.normal);
  c.spin = -omega;
  c.turning = 0.5 * dot(omega, c.normal);
}

// Evaluates the contacts of the block and adds their forces to atoms and walls.
void FixWallGranTribos::collect(ContactBlock &block, bool advances)
{
  if (const char *refusal = block.evaluate(store, update->dt, advances, false))
    error->one(FLERR, "Fix wall/gran/tribos: {}", refusal);
  for (Contact &c : block) {
    if (!advances && !changed) {
      const LastForce *last = store.last_before(c.slot.before);
      if (last && last->overlap == c.overlap) c.force = last->force, c.moment = last->moment;
    }
    if (store.keeps_last()) store.last(c.slot.now) = {c.force, c.moment, c.overlap};
    c.force.subtract_from(atom->f[c.first]);
    (cross(c.normal, c.force) * -c.first_lever - c.moment).add_to(atom->torque[c.first]);
    Vec3 &total = walls[c.second].force;
    total = total + c.force;
  }
  block.clear();
}

void FixWallGranTribos::post_force(int)
{
  const bool advances = !update->setupflag;
  const bool keeps_last = !advances || update->ntimestep == update->laststep ||
      (output->restart_flag && update->ntimestep == output->next_restart);
  for (Wall &wall : walls) {
    if (wall.at_edge) wall.position = wall.side > 0 ? domain->boxlo[wall.axis] : domain->boxhi[wall.axis];
    wall.force = Vec3();
  }
  ContactBlock block;
  store.begin_step(atom->nlocal, law.rolls(), keeps_last);
  for (int i = 0; i < atom->nlocal; i++) {
    store.begin_atom(i);
    for (size_t which = 0; which < walls.size() && (atom->mask[i] & groupbit); which++) {
      const Wall &wall = walls[which];
      const double overlap = atom->radius[i] - wall.side * (atom->x[i][wall.axis] - wall.position);
      if (overlap <= -law.range) continue;
      if (block.is_full()) collect(block, advances);
      Contact &contact = block.add();
      touch(i, which, overlap, contact);
      contact.slot = store.carry(which);
    }
    store.end_atom();
  }
  collect(block, advances);
  store.end_step();
  if (advances) changed = false;

  std::vector<double> sums;
  for (const Wall &wall : walls) sums.insert(sums.end(), {wall.force.x, wall.force.y, wall.force.z});
  MPI_Allreduce(MPI_IN_PLACE, sums.data(), (int) sums.size(), MPI_DOUBLE, MPI_SUM, world);
  for (size_t which = 0; which < walls.size(); which++) walls[which].force = Vec3(&sums[3 * which]);
}

// The law, and position and velocity of each wall.
void FixWallGranTribos::write_restart(FILE *fp)
{
  if (comm->me != 0) return;
  std::vector<double> numbers;
  for (Wall &wall : walls)
    numbers.insert(numbers.end(), {wall.position, wall.velocity.x, wall.velocity.y, wall.velocity.z});
  const int bytes = sizeof(ContactLaw) + (int) (numbers.size() * sizeof(double));
  fwrite(&bytes, sizeof(int), 1, fp);
  fwrite(&law, sizeof(ContactLaw), 1, fp);
  fwrite(numbers.data(), sizeof(double), numbers.size(), fp);
}

void FixWallGranTribos::restart(char *buf)
{
  ContactLaw written;
  std::memcpy((void *) &written, buf, sizeof(written));
  changed = !(written == law);
  buf += sizeof(written);
  for (Wall &wall : walls) {
    double numbers[4];
    std::memcpy(numbers, buf, sizeof(numbers));
    buf += sizeof(numbers);
    wall.position = numbers[0];
    // A wall with a given velocity keeps the one of the command.
    if (wall.driven) wall.velocity = Vec3(numbers + 1);
  }
}

void FixWallGranTribos::grow_arrays(int nmax)
{
  store.grow(nmax);
}

void FixWallGranTribos::copy_arrays(int i, int j, int)
{
  store.copy(i, j);
}

void FixWallGranTribos::set_arrays(int i)
{
  store.clear(i);
}

int FixWallGranTribos::pack_exchange(int i, double *buf)
{
  return store.pack(i, buf);
}

int FixWallGranTribos::unpack_exchange(int nlocal, double *buf)
{
  return store.unpack(nlocal, buf);
}

int FixWallGranTribos::pack_restart(int i, double *buf)
{
  buf[0] = 1 + store.pack(i, buf + 1);
  return (int) buf[0];
}

void FixWallGranTribos::unpack_restart(int nlocal, int nth)
{
  const double *extra = atom->extra[nlocal];
  int m = 0;
  for (int k = 0; k < nth; k++) m += (int) extra[m];
  store.unpack(nlocal, extra + m + 1);
}

int FixWallGranTribos::size_restart(int i)
{
  return 1 + store.packed_size(i);
}

int FixWallGranTribos::maxsize_restart()
{
  return 1 + store.packed_size_of(walls.size());
}

// Position, velocity along the axis and the force of the grains (3 components) of a wall.
double FixWallGranTribos::compute_array(int which, int column)
{
  Wall &wall = walls[which];
  if (column == 0) return wall.position;
  if (column == 1) return component(wall.velocity, wall.axis);
  return component(wall.force, column - 2);
}

double FixWallGranTribos::memory_usage()
{
  return store.memory_usage();
}
