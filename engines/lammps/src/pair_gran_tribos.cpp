/* ----------------------------------------------------------------------
   Includes headers of LAMMPS and is therefore distributed under the GNU General Public License, version 2.
------------------------------------------------------------------------- */

#include "pair_gran_tribos.h"

#include "fix_contact_history.h"

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "fix.h"
#include "force.h"
#include "memory.h"
#include "modify.h"
#include "neigh_list.h"
#include "neighbor.h"
#include "output.h"
#include "update.h"
#include "utils.h"

#include <algorithm>
#include <cmath>
#include <cstring>

using namespace LAMMPS_NS;
using tribos::Contact;
using tribos::ContactBlock;
using tribos::ContactLaw;
using tribos::ContactStore;
using tribos::LastForce;
using tribos::Vec3;

namespace {

const char HISTORY_ID[] = "TRIBOS_HISTORY";
const char PLACEHOLDER_ID[] = "TRIBOS_HISTORY_DUMMY";

// 2/5 m R^2 over m R^2 of a solid sphere.
const double SOLID_SPHERE = 0.4;

bool never(const std::string &)
{
  return false;
}

}    // namespace

PairGranTribos::PairGranTribos(LAMMPS *lmp) : Pair(lmp)
{
  single_enable = 1;
  single_extra = 7;
  svector = new double[single_extra];
  no_virial_fdotr_compute = 1;
  centroidstressflag = CENTROID_NOTAVAIL;
  finitecutflag = 1;
  restartinfo = 1;
  writedata = 0;
  // Holds the place of the history before all fixes that add or migrate atoms.
  if (modify->get_fix_by_id(PLACEHOLDER_ID) || modify->get_fix_by_id(HISTORY_ID))
    error->all(FLERR, "There can be one pair style gran/tribos only: give the materials different atom types instead");
  modify->add_fix(std::string(PLACEHOLDER_ID) + " all DUMMY");
}

PairGranTribos::~PairGranTribos()
{
  delete[] svector;
  for (const char *id : {HISTORY_ID, PLACEHOLDER_ID})
    if (modify->get_fix_by_id(id)) modify->delete_fix(id);
  if (allocated) {
    memory->destroy(setflag);
    memory->destroy(cutsq);
  }
}

void PairGranTribos::allocate()
{
  const int n = atom->ntypes + 1;
  memory->create(setflag, n, n, "pair:setflag");
  memory->create(cutsq, n, n, "pair:cutsq");
  for (int i = 0; i < n; i++)
    for (int j = 0; j < n; j++) setflag[i][j] = 0;
  laws.assign(n, std::vector<ContactLaw>(n));
  allocated = 1;
}

void PairGranTribos::settings(int narg, char **arg)
{
  if (narg > 0)
    error->all(FLERR, "Pair style gran/tribos takes no arguments, but got '{}': laws belong to pair_coeff", arg[0]);
}

void PairGranTribos::coeff(int narg, char **arg)
{
  if (narg < 2) error->all(FLERR, "Pair_coeff of gran/tribos needs two atom types and a law: hooke K or hertz E");
  if (!allocated) allocate();
  int ilo, ihi, jlo, jhi;
  utils::bounds(FLERR, arg[0], 1, atom->ntypes, ilo, ihi, error);
  utils::bounds(FLERR, arg[1], 1, atom->ntypes, jlo, jhi, error);
  ContactLaw law;
  std::string problem;
  law.parse(narg, arg, 2, never, problem);
  if (!problem.empty()) error->all(FLERR, "Pair_coeff of gran/tribos: {}", problem);
  int set = 0;
  for (int i = ilo; i <= ihi; i++)
    for (int j = std::max(jlo, i); j <= jhi; j++, set++) {
      changed = changed || !setflag[i][j] || !(laws[i][j] == law);
      laws[i][j] = laws[j][i] = law;
      setflag[i][j] = 1;
    }
  if (set == 0) error->all(FLERR, "Pair_coeff of gran/tribos: no pair of types with I <= J in {} {}", arg[0], arg[1]);
}

void PairGranTribos::init_style()
{
  if (!atom->radius_flag || !atom->rmass_flag || !atom->omega_flag || !atom->torque_flag)
    error->all(FLERR, "Pair style gran/tribos needs atom style sphere: radius, mass, omega and torque of each atom");
  if (!atom->tag_enable) error->all(FLERR, "Pair style gran/tribos needs atom IDs");
  if (!comm->ghost_velocity)
    error->all(FLERR, "Pair style gran/tribos needs velocities of ghost atoms: use 'comm_modify vel yes'");

  rolls = attracts = false;
  widest = 0;
  for (int i = 1; i <= atom->ntypes; i++)
    for (int j = i; j <= atom->ntypes; j++) {
      if (!setflag[i][j]) continue;
      rolls = rolls || laws[i][j].rolls();
      widest = std::max(widest, laws[i][j].range);
    }
  // Lists by size end at the sum of the radii; across gaps they have to reach farther.
  attracts = widest > 0;
  neighbor->add_request(this, attracts ? NeighConst::REQ_DEFAULT : NeighConst::REQ_SIZE);

  if (!history) {
    const std::string command = std::string(HISTORY_ID) + " all TRIBOS/HISTORY";
    history = dynamic_cast<FixContactHistory *>(modify->replace_fix(PLACEHOLDER_ID, command, 1));
    if (!history) error->all(FLERR, "Pair style gran/tribos: fix style TRIBOS/HISTORY of the plugin is not loaded");
  }

  frozen = 0;
  for (Fix *fix : modify->get_fix_by_style("^freeze")) frozen |= fix->groupbit;
  find_largest_radii();
}

// Largest radii by type, of the atoms that are and of those that fixes will pour.
void PairGranTribos::find_largest_radii()
{
  const int types = atom->ntypes;
  radius_moving.assign(types + 1, 0);
  radius_frozen.assign(types + 1, 0);
  for (Fix *fix : modify->get_fix_list()) {
    if (!utils::strmatch(fix->style, "^pour") && !utils::strmatch(fix->style, "^deposit")) continue;
    for (int type = 1; type <= types; type++) {
      int index = type;
      if (const void *radius = fix->extract("radius", index)) radius_moving[type] = *(const double *) radius;
    }
  }
  for (int i = 0; i < atom->nlocal; i++) {
    double &largest = (atom->mask[i] & frozen ? radius_frozen : radius_moving)[atom->type[i]];
    largest = std::max(largest, atom->radius[i]);
  }
  for (auto *radii : {&radius_moving, &radius_frozen})
    MPI_Allreduce(MPI_IN_PLACE, radii->data(), types + 1, MPI_DOUBLE, MPI_MAX, world);
}

double PairGranTribos::init_one(int i, int j)
{
  if (!setflag[i][j]) {
    if (!setflag[i][i] || !(laws[i][i] == laws[j][j]))
      error->all(FLERR,
                 "Pair style gran/tribos: no pair_coeff for types {} {}; friction of two different materials does not "
                 "follow from that of each",
                 i, j);
    laws[i][j] = laws[j][i] = laws[i][i];
  }
  const double sum = std::max({radius_moving[i] + radius_moving[j], radius_frozen[i] + radius_moving[j],
                               radius_moving[i] + radius_frozen[j]});
  return sum + widest;
}

// Fills in a contact of atoms i and j whose law is known, but for the slot. Returns the distance of the centres.
double PairGranTribos::touch(int i, int j, Contact &c) const
{
  const double *radius = atom->radius;
  const Vec3 branch = Vec3(atom->x[i]) - Vec3(atom->x[j]);
  const double distance = norm(branch);
  c.branch = branch;
  c.normal = branch * (-1 / distance);
  c.overlap = radius[i] + radius[j] - distance;
  c.r_eff = radius[i] * radius[j] / (radius[i] + radius[j]);
  // The contact point lies in the middle of the overlap: levers add up to the distance.
  c.first_lever = radius[i] - 0.5 * c.overlap;
  c.second_lever = radius[j] - 0.5 * c.overlap;

  const double mi = atom->rmass[i], mj = atom->rmass[j];
  c.mass = mi * mj / (mi + mj);
  if (frozen && atom->mask[i] & frozen) c.mass = mj;
  if (frozen && atom->mask[j] & frozen) c.mass = mi;
  if (c.law->turns_with_inertia()) {
    const double inertia_i = SOLID_SPHERE * mi * radius[i] * radius[i];
    const double inertia_j = SOLID_SPHERE * mj * radius[j] * radius[j];
    c.inertia = inertia_i * inertia_j / (inertia_i + inertia_j);
    if (frozen && atom->mask[i] & frozen) c.inertia = inertia_j;
    if (frozen && atom->mask[j] & frozen) c.inertia = inertia_i;
  }

  const Vec3 wi(atom->omega[i]), wj(atom->omega[j]);
  const Vec3 approach = Vec3(atom->v[j]) - Vec3(atom->v[i]);
  c.velocity = approach - cross(wi * c.first_lever + wj * c.second_lever, c.normal);
  c.spin = wj - wi;
  c.turning = 0.5 * dot(wi + wj, c.normal);
  // Where the normal was: positions follow from velocities in the middle of the step.
  const Vec3 branch_before = branch + approach * update->dt;
  c.normal_before = branch_before * (-1 / norm(branch_before));
  c.first = i;
  c.second = j;
  return distance;
}

// Evaluates the contacts of the block and adds their forces to the atoms.
void PairGranTribos::collect(ContactBlock &block, bool advances)
{
  ContactStore &store = history->store;
  if (const char *refusal = block.evaluate(store, update->dt, advances, eflag_either))
    error->one(FLERR, "Pair style gran/tribos: {}", refusal);
  double **f = atom->f, **torque = atom->torque;
  const int nlocal = atom->nlocal, newton_pair = force->newton_pair;
  for (Contact &c : block) {
    const int i = c.first, j = c.second;
    if (!advances && !changed) {
      const LastForce *last = store.last_before(c.slot.before);
      if (last && last->overlap == c.overlap) c.force = last->force, c.moment = last->moment;
    }
    if (store.keeps_last()) store.last(c.slot.now) = {c.force, c.moment, c.overlap};
    const Vec3 about = cross(c.normal, c.force);
    c.force.subtract_from(f[i]);
    (about * -c.first_lever - c.moment).add_to(torque[i]);
    if (newton_pair || j < nlocal) {
      c.force.add_to(f[j]);
      (c.moment - about * c.second_lever).add_to(torque[j]);
    }
    if (evflag)
      ev_tally_xyz(i, j, nlocal, newton_pair, eflag_either ? c.energy : 0, 0, -c.force.x, -c.force.y, -c.force.z,
                   c.branch.x, c.branch.y, c.branch.z);
  }
  block.clear();
}

void PairGranTribos::compute(int eflag, int vflag)
{
  ev_init(eflag, vflag);
  // Springs stay as they are while a run is set up.
  const bool advances = !update->setupflag;
  const bool keeps_last = !advances || update->ntimestep == update->laststep ||
      (output->restart_flag && update->ntimestep == output->next_restart);
  ContactStore &store = history->store;
  ContactBlock block;
  history->partners.clear();
  store.begin_step(atom->nlocal, rolls, keeps_last);

  const double *radius = atom->radius;
  const int *type = atom->type;
  double **x = atom->x;
  for (int ii = 0; ii < list->inum; ii++) {
    const int i = list->ilist[ii];
    const Vec3 xi(x[i]);
    const ContactLaw *laws_of_i = laws[type[i]].data();
    store.begin_atom(i);
    // First who touches, without a branch: a processor guesses it wrong at every third neighbour.
    const int *neighbours = list->firstneigh[i];
    const int count = list->numneigh[i];
    if ((size_t) count > touching.size()) touching.resize(count);
    int found = 0;
    for (int jj = 0; jj < count; jj++) {
      const int j = neighbours[jj] & NEIGHMASK;
      const Vec3 branch = xi - Vec3(x[j]);
      const double reach = radius[i] + radius[j] + (attracts ? laws_of_i[type[j]].range : 0);
      touching[found] = j;
      found += !(dot(branch, branch) >= reach * reach);
    }
    for (int k = 0; k < found; k++) {
      const int j = touching[k];
      if (block.is_full()) collect(block, advances);
      Contact &contact = block.add();
      contact.law = &laws_of_i[type[j]];
      touch(i, j, contact);
      contact.slot = store.carry(atom->tag[j]);
      history->partners.push_back(j);
    }
    store.end_atom();
  }
  collect(block, advances);
  store.end_step();
  history->step_ended();
  if (advances) changed = false;
}

// Normal force over distance; svector: sliding force (3 components) and torque (3) on atom i, radius of the contact.
double PairGranTribos::single(int i, int j, int itype, int jtype, double, double, double, double &fforce)
{
  Contact c;
  c.law = &laws[itype][jtype];
  const double distance = touch(i, j, c);
  fforce = 0;
  std::fill(svector, svector + single_extra, 0.0);
  if (c.overlap <= -c.law->range) return 0;

  tribos::StoredContact known, other;
  if (!history->store.find(i, atom->tag[j], known) && j < atom->nlocal &&
      history->store.find(j, atom->tag[i], other))
    known = other.seen_from_partner(atom->tag[j]);
  ContactStore alone;
  alone.grow(1);
  alone.rolls = rolls;
  alone.append(0, {known});
  alone.begin_step(1, rolls, false);
  alone.begin_atom(0);
  ContactBlock block;
  c.slot = alone.carry(known.springs.partner);
  block.add() = c;
  if (const char *refusal = block.evaluate(alone, update->dt, false, true))
    error->one(FLERR, "Pair style gran/tribos: {}", refusal);
  const Contact &found = *block.begin();
  const double push = dot(found.force, found.normal);
  const Vec3 sliding = found.normal * push - found.force;
  const Vec3 torque = cross(found.normal, found.force) * -found.first_lever - found.moment;
  fforce = push / distance;
  const double numbers[] = {sliding.x, sliding.y, sliding.z, torque.x, torque.y, torque.z,
                            std::sqrt(found.r_eff * std::max(found.overlap, 0.0))};
  std::copy(std::begin(numbers), std::end(numbers), svector);
  return found.energy;
}

void PairGranTribos::write_restart(FILE *fp)
{
  for (int i = 1; i <= atom->ntypes; i++)
    for (int j = i; j <= atom->ntypes; j++) {
      fwrite(&setflag[i][j], sizeof(int), 1, fp);
      if (setflag[i][j]) fwrite(&laws[i][j], sizeof(ContactLaw), 1, fp);
    }
}

void PairGranTribos::read_restart(FILE *fp)
{
  allocate();
  for (int i = 1; i <= atom->ntypes; i++)
    for (int j = i; j <= atom->ntypes; j++) {
      if (comm->me == 0) utils::sfread(FLERR, &setflag[i][j], sizeof(int), 1, fp, nullptr, error);
      MPI_Bcast(&setflag[i][j], 1, MPI_INT, 0, world);
      if (!setflag[i][j]) continue;
      ContactLaw law;
      if (comm->me == 0) utils::sfread(FLERR, &law, sizeof(law), 1, fp, nullptr, error);
      MPI_Bcast(&law, sizeof(law), MPI_BYTE, 0, world);
      laws[i][j] = laws[j][i] = law;
    }
  // Forces of the last step of the run that wrote the file belong to these laws.
  changed = false;
}
