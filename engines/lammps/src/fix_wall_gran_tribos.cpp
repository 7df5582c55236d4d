/* ----------------------------------------------------------------------
   Includes headers of LAMMPS and is therefore distributed under the GNU General Public License, version 2.
------------------------------------------------------------------------- */

#include "fix_wall_gran_tribos.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "input.h"
#include "modify.h"
#include "output.h"
#include "region.h"
#include "update.h"
#include "utils.h"
#include "variable.h"

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
  for (const char *name : {"xlo", "xhi", "ylo", "yhi", "zlo", "zhi", "region"})
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
    error->all(FLERR, "Fix wall/gran/tribos: no wall; give one of xlo, xhi, ylo, yhi, zlo, zhi and its position, or a region");

  restart_global = restart_peratom = 1;
  create_attribute = 1;
  for (const Wall &wall : walls) most += wall.region ? wall.region->cmax : 1;
  maxexchange = store.packed_size_of(most);
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

// A finite number, or v_NAME: an equal-style variable.
FixWallGranTribos::Value FixWallGranTribos::value(int narg, char **arg, int iarg, const char *of) const
{
  Value given;
  if (iarg >= narg || std::strncmp(arg[iarg], "v_", 2) != 0) {
    given.number = number(narg, arg, iarg, of);
    return given;
  }
  given.variable = arg[iarg] + 2;
  const int index = input->variable->find(given.variable.c_str());
  if (index < 0 || !input->variable->equalstyle(index))
    error->all(FLERR, "Fix wall/gran/tribos: '{} {}': there is no equal-style variable {}", of, arg[iarg], given.variable);
  return given;
}

double FixWallGranTribos::now(const Value &value) const
{
  if (value.variable.empty()) return value.number;
  return input->variable->compute_equal(input->variable->find(value.variable.c_str()));
}

// One wall, its position and its options; returns the index of what follows.
int FixWallGranTribos::parse_wall(int narg, char **arg, int iarg)
{
  const std::string name = arg[iarg];
  if (!names_wall(name))
    error->all(FLERR,
               "Fix wall/gran/tribos: unknown keyword '{}': expected a wall (xlo, xhi, ylo, yhi, zlo, zhi, region), or "
               "'velocity' or 'piston' after a wall's position",
               name);
  Wall wall;
  if (name == "region") {
    if (iarg + 1 >= narg) error->all(FLERR, "Fix wall/gran/tribos: the ID after 'region' is missing");
    wall.region_id = arg[iarg + 1];
    wall.region = domain->get_region_by_id(wall.region_id);
    if (!wall.region) error->all(FLERR, "Fix wall/gran/tribos: there is no region {}", wall.region_id);
    // Only one displacement and one angle are kept in restart files.
    if (wall.region->varshape || (wall.region->nregion > 1 && wall.region->dynamic_check()))
      error->all(FLERR,
                 "Fix wall/gran/tribos: region {} changes its shape, or its parts move: give each part as a region of its "
                 "own, with 'move' or 'rotate'",
                 wall.region_id);
    walls.push_back(wall);
    return iarg + 2;
  }
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
      const char *before[] = {"velocity", "velocity VX", "velocity VX VY"};
      for (int axis = 0; axis < 3; axis++) {
        wall.follows[axis] = value(narg, arg, iarg + 1 + axis, before[axis]);
        component(wall.velocity, axis) = wall.follows[axis].number;
        varies = varies || !wall.follows[axis].variable.empty();
      }
      iarg += 4;
    } else if (option == "piston") {
      wall.driven = true;
      wall.push = value(narg, arg, iarg + 1, "piston");
      varies = varies || !wall.push.variable.empty();
      wall.mass = number(narg, arg, iarg + 2, "piston F");
      if (wall.mass <= 0)
        error->all(FLERR, "Fix wall/gran/tribos: 'piston {} {}': the mass must be positive", arg[iarg + 1], arg[iarg + 2]);
      iarg += 3;
    } else
      error->all(FLERR, "Fix wall/gran/tribos: unknown option '{}' of wall {}: expected velocity or piston", option, name);
  }
  const Value &across = wall.follows[wall.axis];
  const bool moves = wall.driven || across.number != 0 || !across.variable.empty();
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
  for (Wall &wall : walls) {
    if (!wall.region_id.empty() && !(wall.region = domain->get_region_by_id(wall.region_id)))
      error->all(FLERR, "Fix wall/gran/tribos: there is no region {} any more", wall.region_id);
    if (wall.region_id.empty() && domain->periodicity[wall.axis])
      error->all(FLERR, "Fix wall/gran/tribos: a wall across {}, but the box is periodic there", "xyz"[wall.axis]);
  }
}

void FixWallGranTribos::setup(int vflag)
{
  if (varies) follow();
  post_force(vflag);
}

// Velocities and pushes that follow variables, at the current step.
void FixWallGranTribos::follow()
{
  modify->clearstep_compute();
  for (Wall &wall : walls) {
    for (int axis = 0; axis < 3; axis++)
      if (!(wall.driven && axis == wall.axis) && !wall.follows[axis].variable.empty())
        component(wall.velocity, axis) = now(wall.follows[axis]);
    if (wall.driven) wall.push.number = now(wall.push);
  }
  modify->addstep_compute(update->ntimestep + 1);
}

// Driven walls, by the velocity Verlet scheme of the grains.
void FixWallGranTribos::accelerate(double dt)
{
  for (Wall &wall : walls)
    if (wall.driven)
      component(wall.velocity, wall.axis) +=
          dt * (component(wall.force, wall.axis) + wall.side * wall.push.number) / wall.mass;
}

void FixWallGranTribos::initial_integrate(int)
{
  accelerate(0.5 * update->dt);
  for (Wall &wall : walls) wall.before = component(wall.velocity, wall.axis);
  if (varies) follow();
  for (Wall &wall : walls)
    wall.position += 0.5 * (wall.before + component(wall.velocity, wall.axis)) * update->dt;
}

void FixWallGranTribos::final_integrate()
{
  accelerate(0.5 * update->dt);
}

// Where a grain meets a plane.
void FixWallGranTribos::meet_plane(int i, int which)
{
  const Wall &wall = walls[which];
  const double overlap = atom->radius[i] - wall.side * (atom->x[i][wall.axis] - wall.position);
  if (overlap <= -law.range) return;
  const Vec3 normal = along(wall.axis, -wall.side);
  met.push_back({which, which, overlap, normal, normal, wall.velocity, Vec3()});
}

// Where a grain meets the surface of a region: at its points that are nearest to the centre.
void FixWallGranTribos::meet_region(int i, int which, bool advances)
{
  Region *region = walls[which].region;
  const Vec3 x(atom->x[i]), v(atom->v[i]);
  if (!region->match(x.x, x.y, x.z)) return;
  const double reach = atom->radius[i] + law.range;
  const int found = region->surface(x.x, x.y, x.z, reach);
  const size_t first = met.size();
  for (int k = 0; k < found; k++) {
    const Region::Contact &contact = region->contact[k];
    Meeting meeting = {which, which + (int64_t) walls.size() * (1 + contact.iwall), atom->radius[i] - contact.r, Vec3(),
                       Vec3(), Vec3(), Vec3()};
    meeting.normal = meeting.before = Vec3(contact.delx, contact.dely, contact.delz) * (-1 / contact.r);
    if (region->dynamic_check()) {
      double velocity[3];
      region->velocity_contact(velocity, atom->x[i], k);
      meeting.velocity = Vec3(velocity);
      if (region->rotateflag) meeting.spin = Vec3(region->omega);
    }
    met.push_back(meeting);
  }
  // The normal a step ago, from the place that the grain had then against the wall: it turns on curved walls and edges.
  for (size_t k = first; advances && k < met.size(); k++) {
    Meeting &meeting = met[k];
    const Vec3 step = (v - meeting.velocity) * update->dt, old = x - step;
    const int then = region->surface(old.x, old.y, old.z, reach + norm(step));
    for (int n = 0; n < then; n++) {
      const Region::Contact &contact = region->contact[n];
      if (which + (int64_t) walls.size() * (1 + contact.iwall) != meeting.partner) continue;
      const Vec3 normal = Vec3(contact.delx, contact.dely, contact.delz) * (-1 / contact.r);
      const Vec3 turned = normal - cross(meeting.spin, normal) * update->dt;
      meeting.before = turned * (1 / norm(turned));
    }
  }
}

// Fills in a contact of an atom, the first body, with a wall.
void FixWallGranTribos::touch(int i, const Meeting &at, Contact &c) const
{
  c.first = i;
  c.second = at.wall;
  c.law = &law;
  c.overlap = at.overlap;
  c.normal = at.normal;
  c.normal_before = at.before;
  c.r_eff = atom->radius[i];
  c.first_lever = atom->radius[i] - at.overlap;
  c.second_lever = 0;
  c.mass = atom->rmass[i];
  c.inertia = SOLID_SPHERE * c.mass * c.r_eff * c.r_eff;
  const Vec3 omega(atom->omega[i]);
  c.velocity = at.velocity - Vec3(atom->v[i]) - cross(omega * c.first_lever, c.normal);
  c.spin = at.spin - omega;
  c.turning = 0.5 * dot(omega + at.spin, c.normal);
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
    if (wall.region) {
      wall.region->prematch();
      if (wall.region->dynamic_check()) wall.region->set_velocity();
    }
  }
  ContactBlock block;
  store.begin_step(atom->nlocal, law.rolls(), keeps_last);
  for (int i = 0; i < atom->nlocal; i++) {
    store.begin_atom(i);
    met.clear();
    for (size_t which = 0; which < walls.size() && (atom->mask[i] & groupbit); which++)
      if (walls[which].region)
        meet_region(i, which, advances);
      else
        meet_plane(i, which);
    for (const Meeting &meeting : met) {
      if (block.is_full()) collect(block, advances);
      Contact &contact = block.add();
      touch(i, meeting, contact);
      contact.slot = store.carry(meeting.partner);
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

// The law, and position and velocity of each wall: of a region its displacement and its angle.
void FixWallGranTribos::write_restart(FILE *fp)
{
  if (comm->me != 0) return;
  std::vector<double> numbers;
  for (Wall &wall : walls)
    if (wall.region)
      numbers.insert(numbers.end(), wall.region->prev, wall.region->prev + 4);
    else
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
    if (wall.region) std::memcpy(wall.region->prev, numbers, sizeof(numbers));
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
  return 1 + store.packed_size_of(most);
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
