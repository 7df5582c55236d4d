/* ----------------------------------------------------------------------
   Includes headers of LAMMPS and is therefore distributed under the GNU General Public License, version 2.
------------------------------------------------------------------------- */

// A step stores each contact with one of its two atoms, the one in whose neighbour list it is. Before atoms migrate and
// lists are built anew, the other atom gets a copy as it sees it, through reverse communication if it lives on another
// processor. The next step finds the contact on either side and drops the copy.

#include "fix_contact_history.h"

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "force.h"
#include "modify.h"

using namespace LAMMPS_NS;
using namespace FixConst;
using tribos::ContactStore;
using tribos::StoredContact;

FixContactHistory::FixContactHistory(LAMMPS *lmp, int narg, char **arg) : Fix(lmp, narg, arg)
{
  if (narg != 3) error->all(FLERR, "Fix {} is made by pair style gran/tribos and takes no arguments", style);
  restart_peratom = 1;
  restart_global = 1;    // for `write_restart`, which comes before the atoms are packed
  create_attribute = 1;
  maxexchange_dynamic = 1;
  FixContactHistory::grow_arrays(atom->nmax);
  atom->add_callback(Atom::GROW);
  atom->add_callback(Atom::RESTART);
}

FixContactHistory::~FixContactHistory()
{
  atom->delete_callback(id, Atom::GROW);
  atom->delete_callback(id, Atom::RESTART);
}

int FixContactHistory::setmask()
{
  return PRE_EXCHANGE | MIN_PRE_EXCHANGE | POST_RUN;
}

void FixContactHistory::step_ended()
{
  fresh = true;
  local_atoms = atom->nlocal;
  all_atoms = atom->nlocal + atom->nghost;
}

void FixContactHistory::pre_exchange()
{
  share_with_partners();
}

void FixContactHistory::min_pre_exchange()
{
  share_with_partners();
}

void FixContactHistory::post_run()
{
  // Between runs atoms may be added or deleted and neighbour lists become invalid.
  share_with_partners();
}

void FixContactHistory::write_restart(FILE *fp)
{
  share_with_partners();
  // Nothing global belongs to the fix.
  const int bytes = 0;
  if (comm->me == 0) fwrite(&bytes, sizeof(int), 1, fp);
}

void FixContactHistory::share_with_partners()
{
  if (!fresh) return;
  fresh = false;
  lists.assign(all_atoms, {});
  size_t contact = 0;
  for (int i = 0; i < local_atoms; i++)
    for (int index = 0; index < store.count(i); index++, contact++) {
      const StoredContact here = store.contact(i, index);
      const int j = partners[contact];
      lists[i].push_back(here);
      // Without Newton's third law both processors compute the pairs of ghosts.
      if (j < local_atoms || force->newton_pair)
        lists[j].push_back(here.seen_from_partner(atom->tag[i]));
    }
  if (force->newton_pair) comm->reverse_comm_variable(this);
  lists.resize(local_atoms);
  store.replace(lists);
  std::vector<std::vector<StoredContact>>().swap(lists);
  maxexchange = store.packed_size_of(store.largest_count(local_atoms));
}

int FixContactHistory::pack_reverse_comm_size(int n, int first)
{
  int size = 0;
  for (int i = first; i < first + n; i++) size += store.packed_size_of(lists[i].size());
  return size;
}

int FixContactHistory::pack_reverse_comm(int n, int first, double *buf)
{
  int m = 0;
  for (int i = first; i < first + n; i++) {
    buf[m++] = lists[i].size();
    for (const auto &contact : lists[i]) m += ContactStore::pack_one(contact, buf + m);
  }
  return m;
}

void FixContactHistory::unpack_reverse_comm(int n, int *list, double *buf)
{
  int m = 0;
  for (int k = 0; k < n; k++) {
    const int contacts = (int) buf[m++];
    for (int index = 0; index < contacts; index++) {
      StoredContact contact;
      m += ContactStore::unpack_one(buf + m, contact);
      lists[list[k]].push_back(contact);
    }
  }
}

void FixContactHistory::grow_arrays(int nmax)
{
  store.grow(nmax);
}

void FixContactHistory::copy_arrays(int i, int j, int)
{
  store.copy(i, j);
}

void FixContactHistory::set_arrays(int i)
{
  store.clear(i);
}

int FixContactHistory::pack_exchange(int i, double *buf)
{
  return store.pack(i, buf);
}

int FixContactHistory::unpack_exchange(int nlocal, double *buf)
{
  return store.unpack(nlocal, buf);
}

int FixContactHistory::pack_restart(int i, double *buf)
{
  buf[0] = 1 + store.pack(i, buf + 1);
  return (int) buf[0];
}

void FixContactHistory::unpack_restart(int nlocal, int nth)
{
  const double *extra = atom->extra[nlocal];
  int m = 0;
  for (int k = 0; k < nth; k++) m += (int) extra[m];
  store.unpack(nlocal, extra + m + 1);
}

int FixContactHistory::size_restart(int i)
{
  return 1 + store.packed_size(i);
}

int FixContactHistory::maxsize_restart()
{
  return 1 + store.packed_size_of(store.largest_count(atom->nlocal));
}

double FixContactHistory::memory_usage()
{
  return store.memory_usage() + partners.capacity() * sizeof(int);
}
