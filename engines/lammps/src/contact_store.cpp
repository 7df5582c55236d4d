#include "contact_store.h"

#include <algorithm>
#include <cstring>

namespace tribos {

StoredContact StoredContact::seen_from_partner(int64_t tag) const
{
  // Normals and displacements change their sign; the turn about the normal does not.
  StoredContact other = *this;
  other.springs.partner = tag;
  other.springs.sliding = -springs.sliding;
  other.rolling = -rolling;
  other.last.force = -last.force;
  other.last.moment = -last.moment;
  return other;
}

void ContactStore::Pool::clear()
{
  springs.clear();
  rolling.clear();
  last.clear();
}

void ContactStore::grow(int atoms)
{
  if ((size_t) atoms <= counts.size()) return;
  firsts.resize(atoms, 0);
  counts.resize(atoms, 0);
  next_firsts.resize(atoms, 0);
  next_counts.resize(atoms, 0);
}

int ContactStore::largest_count(int atoms) const
{
  return atoms > 0 ? *std::max_element(counts.begin(), counts.begin() + atoms) : 0;
}

void ContactStore::copy(int from, int to)
{
  firsts[to] = firsts[from];
  counts[to] = counts[from];
}

void ContactStore::begin_step(int atoms, bool with_rolling, bool keep_last)
{
  next.clear();
  if (with_rolling && !rolls) now.rolling.assign(now.springs.size(), Vec3());
  rolls = with_rolling;
  with_last = keep_last;
  std::fill(next_counts.begin(), next_counts.begin() + atoms, 0);
}

void ContactStore::begin_atom(int i)
{
  atom = i;
  cursor = 0;
  next_firsts[i] = next.springs.size();
}

ContactStore::Slot ContactStore::carry(int64_t partner)
{
  const Slot slot = {next.springs.size(), -1};
  const size_t first = firsts[atom];
  const size_t known = counts[atom];
  // Neighbours come in the same order until their list is built anew: the next one known is usually the one.
  for (size_t tried = 0; tried < known; tried++, cursor++) {
    if (cursor >= known) cursor = 0;
    const size_t at = first + cursor;
    if (now.springs[at].partner != partner) continue;
    cursor++;
    next.springs.push_back(now.springs[at]);
    if (rolls) next.rolling.push_back(now.rolling[at]);
    if (with_last) next.last.emplace_back();
    return {slot.now, (long) at};
  }
  next.springs.emplace_back();
  next.springs.back().partner = partner;
  if (rolls) next.rolling.emplace_back();
  if (with_last) next.last.emplace_back();
  return slot;
}

void ContactStore::end_atom()
{
  next_counts[atom] = next.springs.size() - next_firsts[atom];
}

void ContactStore::end_step()
{
  std::swap(now, next);
  std::swap(firsts, next_firsts);
  std::swap(counts, next_counts);
  has_last = with_last;
}

StoredContact ContactStore::contact(int i, int index) const
{
  const size_t at = firsts[i] + index;
  StoredContact contact;
  contact.springs = now.springs[at];
  if (rolls) contact.rolling = now.rolling[at];
  if (has_last) contact.last = now.last[at];
  return contact;
}

const StoredContact *ContactStore::find(int i, int64_t partner, StoredContact &found) const
{
  for (int index = 0; index < counts[i]; index++)
    if (now.springs[firsts[i] + index].partner == partner) {
      found = contact(i, index);
      return &found;
    }
  return nullptr;
}

void ContactStore::push(Pool &pool, const StoredContact &contact)
{
  pool.springs.push_back(contact.springs);
  if (rolls) pool.rolling.push_back(contact.rolling);
  if (has_last) pool.last.push_back(contact.last);
}

void ContactStore::replace(const std::vector<std::vector<StoredContact>> &lists)
{
  next.clear();
  std::fill(counts.begin(), counts.end(), 0);
  for (size_t i = 0; i < lists.size(); i++) {
    firsts[i] = next.springs.size();
    counts[i] = lists[i].size();
    for (const auto &contact : lists[i]) push(next, contact);
  }
  std::swap(now, next);
}

void ContactStore::append(int i, const std::vector<StoredContact> &contacts)
{
  firsts[i] = now.springs.size();
  counts[i] = contacts.size();
  for (const auto &contact : contacts) push(now, contact);
}

int ContactStore::pack_one(const StoredContact &contact, double *to)
{
  const Springs &s = contact.springs;
  const LastForce &l = contact.last;
  // The bits of an integer, as LAMMPS' own fixes write tags.
  std::memcpy(to, &s.partner, sizeof(double));
  const double numbers[NUMBERS - 1] = {
      s.sliding.x,       s.sliding.y,       s.sliding.z,  s.torsion,    s.slope,      s.torsion_stiffness,
      contact.rolling.x, contact.rolling.y, contact.rolling.z, l.force.x,  l.force.y,    l.force.z,
      l.moment.x,        l.moment.y,        l.moment.z,   l.overlap,  (double) s.slips};
  std::memcpy(to + 1, numbers, sizeof(numbers));
  return NUMBERS;
}

int ContactStore::unpack_one(const double *from, StoredContact &contact)
{
  Springs &s = contact.springs;
  LastForce &l = contact.last;
  std::memcpy(&s.partner, from, sizeof(double));
  s.sliding = Vec3(from + 1);
  s.torsion = from[4];
  s.slope = from[5];
  s.torsion_stiffness = from[6];
  contact.rolling = Vec3(from + 7);
  l.force = Vec3(from + 10);
  l.moment = Vec3(from + 13);
  l.overlap = from[16];
  s.slips = (int64_t) from[17];
  return NUMBERS;
}

int ContactStore::pack(int i, double *to) const
{
  int m = 0;
  to[m++] = counts[i];
  for (int index = 0; index < counts[i]; index++) m += pack_one(contact(i, index), to + m);
  return m;
}

int ContactStore::unpack(int i, const double *from)
{
  int m = 0;
  std::vector<StoredContact> contacts((size_t) from[m++]);
  for (auto &contact : contacts) {
    m += unpack_one(from + m, contact);
    // What only some runs store is known by its content.
    const Vec3 &turn = contact.rolling;
    if (!rolls && !(turn == Vec3())) {
      now.rolling.resize(now.springs.size());
      rolls = true;
    }
    if (!has_last && contact.last.overlap == contact.last.overlap) {
      now.last.resize(now.springs.size());
      has_last = true;
    }
  }
  append(i, contacts);
  return m;
}

double ContactStore::memory_usage() const
{
  double bytes = 0;
  for (const Pool *pool : {&now, &next})
    bytes += pool->springs.capacity() * sizeof(Springs) + pool->rolling.capacity() * sizeof(Vec3) +
        pool->last.capacity() * sizeof(LastForce);
  return bytes + (firsts.capacity() + next_firsts.capacity()) * sizeof(size_t) +
      (counts.capacity() + next_counts.capacity()) * sizeof(int);
}

}    // namespace tribos
