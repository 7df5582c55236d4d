// The law of a contact, in passes over a block: normal force, springs that slip, dashpots beside them.
//
// A spring whose force exceeds its threshold is shortened to the admissible force that is nearest in elastic energy.
// The energy of a sliding force F and a torque T is |F|^2/(2 k_t) + T^2/(2 k_n): the distance is that of the wrench
// (F, T/l) with l^2 = k_n/k_t, l = a/sqrt(2) for k_n = k_t a^2/2. With this length, and with no other, steady motion
// ends at the wrench whose outward normal on the limit surface is the twist: the friction of the moving disk.
//
// Dashpots beside the springs of a contact that sticks obey the same threshold. A contact that slips under a common
// threshold of sliding and torsion carries the force of its springs alone, which is all that friction allows.

#include "contact_block.h"

#include "ellipse.h"
#include "transport.h"
#include "tribos.h"

#include <cmath>

namespace tribos {

namespace {

// Share of the tangent stiffness in the critical damping of a Hertz contact, sqrt(5/6): restitution does not depend
// on the speed (Tsuji, Tanaka and Ishida, Powder Technol. 71 (1992) 239).
const double HERTZ_DAMPING = 0.9128709291752769;

// Torque of a spinning disk under uniform pressure over mu P a.
const double SPIN_TORQUE = 2.0 / 3.0;

// l/a for k_n = k_t a^2/2.
const double AREA_LENGTH = 0.7071067811865476;

double positive_part(double x)
{
  return x < 0 ? 0 : x;    // NaN stays
}

// The vector of length up to `limit` that is nearest to `trial`.
Vec3 nearest_on_disc(const Vec3 &trial, double limit)
{
  const double size_sq = dot(trial, trial);
  if (size_sq <= limit * limit) return trial;
  return trial * (limit / std::sqrt(size_sq));
}

double clamped(double x, double limit)
{
  return std::fabs(x) <= limit ? x : std::copysign(limit, x) + 0 * x;    // NaN stays
}

}    // namespace

void ContactBlock::prepare(const Contact &c, Grip &g) const
{
  const ContactLaw &law = *c.law;
  const double overlap = positive_part(c.overlap);
  double push, damping = law.damping;
  if (law.normal == Normal::HOOKE) {
    g.slope = law.stiffness;
    push = law.stiffness * overlap;
  } else {
    g.slope = 2 * law.stiffness * std::sqrt(c.r_eff * overlap);
    push = 2.0 / 3.0 * g.slope * overlap;
    damping *= HERTZ_DAMPING;
  }
  g.dashpot = 2 * damping * std::sqrt(g.slope * c.mass);
  // Spring and dashpot push, or do nothing.
  g.bound = overlap == 0 ? 0 : positive_part(push - g.dashpot * dot(c.velocity, c.normal));

  g.k_sliding = law.tangential * g.slope;
  g.k_rolling = law.turns_with_inertia() ? g.slope * c.inertia / c.mass : 0;
  g.force_limit = law.mu * g.bound;
  g.rolling_limit = law.mu_rolling * g.bound * c.r_eff;
  if (law.disk_of_overlap) {
    g.disk = std::sqrt(c.r_eff * overlap);
    g.torque_limit = SPIN_TORQUE * g.force_limit * g.disk;
  } else {
    g.torque_limit = law.mu_torsion * g.bound * c.r_eff;
    g.disk = law.mu > 0 ? law.mu_torsion * c.r_eff / (SPIN_TORQUE * law.mu) : 0;
  }
  if (law.torsion_spring == TorsionSpring::AREA) {
    // A disk of no known radius has that of the contact.
    const double radius_sq = g.disk > 0 ? g.disk * g.disk : c.r_eff * overlap;
    g.k_torsion = 0.5 * g.k_sliding * radius_sq;
    g.length = AREA_LENGTH;
  } else {
    g.k_torsion = g.k_rolling;
    g.length = std::sqrt(g.k_torsion / g.k_sliding) / g.disk;
  }
}

// Strains the springs by the motion of the step.
void ContactBlock::stretch(const Contact &c, Grip &g, ContactStore &store, double dt) const
{
  Springs &s = store.springs(c.slot.now);
  // A spring that stiffens keeps its force, one that softens its elongation: neither makes energy.
  const auto kept = [](double before, double after) { return after > before ? before / after : 1.0; };
  const double stiffened = kept(s.slope, g.slope);
  const Transport transport(c.normal_before, c.normal, c.turning * dt);
  const double opening = dot(c.velocity, c.normal), twist = dot(c.spin, c.normal);
  const Vec3 slip = c.velocity - c.normal * opening;
  s.sliding = transport.carry(s.sliding) * stiffened + slip * dt;
  g.trial = s.sliding * g.k_sliding;
  g.trial_torque = 0;
  if (c.law->twists()) {
    s.torsion = s.torsion * kept(s.torsion_stiffness, g.k_torsion) + twist * dt;
    g.trial_torque = s.torsion * g.k_torsion;
  }
  if (c.law->rolls()) {
    Vec3 &rolling = store.rolling(c.slot.now);
    const Vec3 roll = c.spin - c.normal * twist;
    const Vec3 turned = transport.carry(rolling) * stiffened + roll * dt;
    const Vec3 trial = turned * g.k_rolling;
    g.elastic_rolling = nearest_on_disc(trial, g.rolling_limit);
    rolling = g.elastic_rolling == trial ? turned : g.elastic_rolling * (1 / g.k_rolling);
  }
}

// Shortens the springs that slip.
void ContactBlock::relax(const Contact &c, const Grip &g, ContactStore &store) const
{
  Springs &s = store.springs(c.slot.now);
  if (!(g.held == g.trial)) s.sliding = g.k_sliding > 0 ? g.held * (1 / g.k_sliding) : Vec3();
  if (g.held_torque != g.trial_torque) s.torsion = g.k_torsion > 0 ? g.held_torque / g.k_torsion : 0;
  s.slope = g.slope;
  s.torsion_stiffness = g.k_torsion;
  s.slips = g.slips;
}

// Adds the dashpots to springs that stick.
void ContactBlock::load_with_dashpots(const Contact &c, Grip &g, ContactStore &store) const
{
  const Springs &s = store.springs(c.slot.now);
  const double share = s.slips ? 0 : g.dashpot / g.slope;
  const double c_sliding = g.slope > 0 ? g.k_sliding * share : 0;
  const double c_torsion = g.slope > 0 ? g.k_torsion * share : 0;
  const Vec3 slip = c.velocity - c.normal * dot(c.velocity, c.normal);
  g.trial = s.sliding * g.k_sliding + slip * c_sliding;
  g.trial_torque = c.law->twists() ? s.torsion * g.k_torsion + dot(c.spin, c.normal) * c_torsion : 0;
}

// The nearest admissible pair of force and torque of every trial.
const char *ContactBlock::hold(bool except_slipping)
{
  double loads[CAPACITY], lengths[CAPACITY];
  tribos_wrench_f64 wrenches[CAPACITY];
  tribos_projection_f64 projections[CAPACITY];
  int who[CAPACITY], slipping = 0;
  const auto take = [this](int k, const tribos_wrench_f64 &nearest, const tribos_wrench_f64 &trial) {
    Grip &g = grips[k];
    if (nearest.x == trial.x && nearest.torque == trial.torque) return;
    g.slips = true;
    g.held = trial.x > 0 ? g.trial * (nearest.x / trial.x) : g.trial;
    g.held_torque = nearest.torque * g.disk;
  };

  for (int k = 0; k < count; k++) {
    Grip &g = grips[k];
    if (except_slipping && g.slips) continue;
    g.slips = false;
    const ContactLaw &law = *contacts[k].law;
    if (law.coupling == Coupling::SEPARATE || !law.twists()) {
      g.held = nearest_on_disc(g.trial, g.force_limit);
      g.held_torque = clamped(g.trial_torque, g.torque_limit);
      continue;
    }
    g.held = g.trial;
    g.held_torque = g.trial_torque;
    if (g.force_limit == 0 || g.disk == 0) {
      g.held = g.trial * 0;
      g.held_torque = g.trial_torque * 0;
      continue;
    }
    // A convex set holds everything between its poles: most contacts stick and end here.
    const double size_sq = dot(g.trial, g.trial);
    const double left = g.force_limit * (g.torque_limit - std::fabs(g.trial_torque));
    if (left > 0 && size_sq * g.torque_limit * g.torque_limit < left * left) continue;
    const double size = std::sqrt(size_sq);
    if (law.coupling == Coupling::ELLIPSOID) {
      // In units of the largest force, and of that force times the length.
      const double force_unit = 1 / g.force_limit, torque_unit = 1 / (g.force_limit * g.length * g.disk);
      double force = size * force_unit, torque = std::fabs(g.trial_torque) * torque_unit;
      const double trial_force = force, trial_torque = torque;
      if (!move_into_ellipse(force, torque, SPIN_TORQUE / g.length)) continue;
      g.slips = true;
      if (trial_force > 0) g.held = g.trial * (force / trial_force);
      if (trial_torque > 0) g.held_torque = g.trial_torque * (torque / trial_torque);
      continue;
    }
    const tribos_wrench_f64 trial = {size, 0, g.trial_torque / g.disk};
    loads[slipping] = g.force_limit;
    lengths[slipping] = g.length;
    wrenches[slipping] = trial;
    who[slipping++] = k;
  }

  // The exact surface for unit limit and radius, prepared once for each run of the same length.
  const tribos_disk_surface_f64 unit = {1, 1};
  for (int first = 0, next; first < slipping; first = next) {
    next = first + 1;
    while (next < slipping && lengths[next] == lengths[first]) next++;
    const auto status = tribos_disk_surface_project_batch_f64(
        &unit, loads + first, wrenches + first, next - first, lengths[first], projections + first);
    if (status != TRIBOS_STATUS_OK) return tribos_status_text(status);
  }
  for (int n = 0; n < slipping; n++) take(who[n], projections[n].wrench, wrenches[n]);
  return nullptr;
}

void ContactBlock::finish(Contact &c, const Grip &g, ContactStore &store, bool with_energy) const
{
  const ContactLaw &law = *c.law;
  const double pull = c.overlap >= -law.range ? law.cohesion : 0;
  c.force = c.normal * (g.bound - pull) - g.held;
  c.moment = c.normal * -g.held_torque;
  if (law.rolls()) {
    const double c_rolling = g.slope > 0 ? g.k_rolling * (g.dashpot / g.slope) : 0;
    const Vec3 roll = c.spin - c.normal * dot(c.spin, c.normal);
    const Vec3 elastic = store.rolling(c.slot.now) * g.k_rolling;
    c.moment = c.moment - nearest_on_disc(elastic + roll * c_rolling, g.rolling_limit);
  }
  if (!with_energy) return;
  const Springs &s = store.springs(c.slot.now);
  const double overlap = positive_part(c.overlap);
  const double share = law.normal == Normal::HOOKE ? 0.5 : 0.4 * 2.0 / 3.0;
  c.energy = share * g.slope * overlap * overlap - pull * (c.overlap + law.range) +
      0.5 * g.k_sliding * dot(s.sliding, s.sliding);
  if (law.twists()) c.energy += 0.5 * g.k_torsion * s.torsion * s.torsion;
  if (law.rolls()) {
    const Vec3 &turn = store.rolling(c.slot.now);
    c.energy += 0.5 * g.k_rolling * dot(turn, turn);
  }
}

const char *ContactBlock::evaluate(ContactStore &store, double dt, bool advances, bool with_energy)
{
  for (int k = 0; k < count; k++) prepare(contacts[k], grips[k]);
  if (advances) {
    for (int k = 0; k < count; k++) stretch(contacts[k], grips[k], store, dt);
    if (const char *refusal = hold(false)) return refusal;
    for (int k = 0; k < count; k++) relax(contacts[k], grips[k], store);
  }
  for (int k = 0; k < count; k++)
    if (!advances || !grips[k].slips) load_with_dashpots(contacts[k], grips[k], store);
  if (const char *refusal = hold(advances)) return refusal;
  for (int k = 0; k < count; k++) finish(contacts[k], grips[k], store, with_energy);
  return nullptr;
}

}    // namespace tribos
