//! From a rest pose to every launch within the limits.

use super::{Launch, LaunchLimits, MotionError, OutOfReach, Pose, RestMap};
use crate::slide::inverse::solve::LaunchMagnitudes;
use std::collections::BTreeMap;
use std::f64::consts::TAU;
use std::num::NonZeroU32;
use tribos_core::Real;
use tribos_core::coupling::{PowerLawFriction, ReducedFriction};

/// Meaning of the requested angle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Turns {
    /// The total angle turned during the motion, of either sign.
    Exact,
    /// The orientation at rest, which repeats every 2π/`symmetry`: any number of turns, in both
    /// directions.
    Modulo {
        /// Order of the body's rotational symmetry, 1 for none.
        symmetry: NonZeroU32,
    },
}

/// One launch that ends at the requested pose.
///
/// ```
/// use tribos::slide::inverse::{LaunchLimits, Pose, RestMap, LaunchSolution, Turns};
/// use tribos::kernel::coupling::coulomb::CoulombDisk;
/// let disk = RestMap::new(CoulombDisk, 0.3 * 9.81, 0.08, 0.5)?; // mu g, R, C = I/(M R^2)
/// let target = Pose { x: 1.0, y: 0.0, angle: 0.0 };
/// let turns = Turns::Modulo { symmetry: std::num::NonZeroU32::MIN };
/// let all: Vec<LaunchSolution> = disk.launches(&target, turns, &LaunchLimits::new(3.0, 30.0)?)?;
/// assert!(all.len() > 2);
/// assert!(all.iter().all(|one| (one.turns() - one.turns().round()).abs() < 1e-12));
/// // Spin only adds to the work of friction: the least is mu g d, without a turn.
/// assert_eq!(all[0].turns(), 0.0);
/// assert!((all[0].energy_per_mass - 0.3 * 9.81).abs() < 1e-12);
/// # Ok::<(), tribos::slide::inverse::MotionError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LaunchSolution {
    /// The launch.
    pub launch: Launch,
    /// |velocity|, in m/s.
    pub speed: f64,
    /// Direction of the velocity from the first axis, in rad; 0 for a pure spin, where it is
    /// arbitrary.
    pub direction: f64,
    /// Total angle turned, in rad.
    pub angle: f64,
    /// Time from launch to rest, in s.
    pub time: f64,
    /// Kinetic energy per mass, in J/kg.
    pub energy_per_mass: f64,
}

impl LaunchSolution {
    /// Number of turns during the motion, of either sign.
    pub fn turns(&self) -> f64 {
        self.angle / TAU
    }
}

/// Largest number of solutions that [`RestMap::launches`] lists; for [`RestMap::fewest_turns`] the
/// caller chooses the number.
///
/// ```
/// use tribos::slide::inverse::{MotionError, LaunchLimits, MAX_SOLUTIONS, Pose, RestMap, Turns};
/// use tribos::kernel::coupling::coulomb::CoulombDisk;
/// let disk = RestMap::new(CoulombDisk, 0.3 * 9.81, 0.08, 0.5)?; // mu g, R, C = I/(M R^2)
/// let turns = Turns::Modulo { symmetry: std::num::NonZeroU32::MIN };
/// let spins = LaunchLimits::new(3.0, 1e4)?; // ω² 3 R/(8 mu g) = 10⁶ rad
/// let all = disk.launches(&Pose::default(), turns, &spins);
/// assert!(matches!(all, Err(MotionError::TooMany { count }) if count > MAX_SOLUTIONS));
/// assert_eq!(disk.fewest_turns(&Pose::default(), turns, &spins, 7)?.solutions.len(), 7);
/// # Ok::<(), tribos::slide::inverse::MotionError>(())
/// ```
pub const MAX_SOLUTIONS: u64 = 10_000;

/// Launches that end at the requested pose: their number, and those that were computed.
///
/// ```
/// use tribos::slide::inverse::{Launches, LaunchLimits, Pose, RestMap, Turns};
/// use tribos::kernel::coupling::coulomb::CoulombDisk;
/// let disk = RestMap::new(CoulombDisk, 0.3 * 9.81, 0.08, 0.5)?; // mu g, R, C = I/(M R^2)
/// let target = Pose { x: 1.0, y: 0.0, angle: 0.0 };
/// let turns = Turns::Modulo { symmetry: std::num::NonZeroU32::MIN };
/// let limits = LaunchLimits::new(3.0, 60.0)?;
/// let Launches { count, solutions } = disk.fewest_turns(&target, turns, &limits, 3)?;
/// assert_eq!(count, disk.launches(&target, turns, &limits)?.len() as u64);
/// assert!(count > 3);
/// // Without a turn, and with one in either sense.
/// let mut found: Vec<f64> = solutions.iter().map(|one| one.turns().round()).collect();
/// found.sort_by(f64::total_cmp);
/// assert_eq!(found, [-1.0, 0.0, 1.0]);
/// # Ok::<(), tribos::slide::inverse::MotionError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Launches {
    /// Number of launches within the limits; beyond 2^53 turns it is as exact as an f64, and it saturates at
    /// [`u64::MAX`].
    pub count: u64,
    /// The launches with the fewest turns, in order of increasing kinetic energy.
    pub solutions: Vec<LaunchSolution>,
}

/// Relative margin for rounding in the number of turns that are tried.
const SPARE: f64 = 1e-9;

/// Angles of one sign, `first` + j `step`, that have the same orientation.
struct EquivalentAngles {
    sense: f64,
    first: f64,
    step: f64,
}

/// Every whole number up to this one is an f64; above it, every f64 is a whole number.
const WHOLE: u64 = 1 << f64::MANTISSA_DIGITS;

/// The `rank`-th whole number that is an f64, counted from 0. There are fewer than 2^63 of them.
fn whole(rank: u64) -> f64 {
    match rank.checked_sub(WHOLE) {
        None => rank as f64,
        Some(beyond) => f64::from_bits((WHOLE as f64).to_bits() + beyond),
    }
}

/// Count of the whole numbers that are an f64 and do not exceed `x`.
fn integers_up_to(x: f64) -> u64 {
    if x < WHOLE as f64 {
        // Zero if negative or NaN.
        return if x >= 0.0 { x as u64 + 1 } else { 0 };
    }
    let largest = x.min(f64::MAX);
    largest.to_bits() - (WHOLE as f64).to_bits() + WHOLE + 1
}

impl EquivalentAngles {
    fn angle(&self, rank: u64) -> f64 {
        self.first + whole(rank) * self.step
    }

    /// Ranks of the angles up to `most`, all of which are tried. Beyond [`WHOLE`] they skip
    /// the turns whose number is not an f64.
    fn ranks(&self, most: f64) -> u64 {
        if self.step == 0.0 {
            return 1;
        }
        integers_up_to((most * (1.0 + SPARE) - self.first) / self.step)
    }
}

/// The angles of a ladder whose launches are within the limits, by rank, from `first` up to but not including
/// `end`.
struct AdmissibleAngles {
    ladder: EquivalentAngles,
    first: u64,
    end: u64,
}

impl AdmissibleAngles {
    fn count(&self) -> u64 {
        if self.first == self.end {
            return 0;
        }
        if self.end <= WHOLE {
            return self.end - self.first;
        }
        // Saturates at u64::MAX.
        (whole(self.end - 1) - whole(self.first)) as u64
    }

    /// The first `most` angles with their sign.
    fn angles(&self, most: u64) -> impl Iterator<Item = f64> + '_ {
        let end = self.end.min(self.first.saturating_add(most));
        (self.first..end).map(|rank| self.ladder.sense * self.ladder.angle(rank))
    }
}

/// Total number of launches of all flights, at most [`u64::MAX`].
fn count(flights: &[AdmissibleAngles]) -> u64 {
    let counts = flights.iter().map(AdmissibleAngles::count);
    counts.fold(0, u64::saturating_add)
}

impl Turns {
    /// The angles that match a requested `angle`, positive direction first.
    fn ladders(self, angle: f64) -> Vec<EquivalentAngles> {
        let Self::Modulo { symmetry } = self else {
            return vec![EquivalentAngles {
                sense: 1.0_f64.copysign(angle),
                first: angle.abs(),
                step: 0.0,
            }];
        };
        let step = TAU / f64::from(symmetry.get());
        let left = angle.rem_euclid(step);
        // Zero belongs to one direction only.
        let right = step - left;
        [(1.0, left), (-1.0, right)]
            .map(|(sense, first)| EquivalentAngles { sense, first, step })
            .into()
    }
}

impl<P: PowerLawFriction<f64> + ReducedFriction<f64>> RestMap<P> {
    /// Every launch within `limits` that comes to rest at `target`, in order of increasing kinetic energy;
    /// refused if there are more than [`MAX_SOLUTIONS`].
    ///
    /// For each total angle there is exactly one launch (proved in [the module](super)). With more turns
    /// the required speed falls and the required spin rises: the admissible launches are consecutive,
    /// and both ends of their range are found by bisection.
    ///
    /// *Accuracy*: the rest pose of every solution meets `target` to 1e-12 of the distance and
    /// of the angle turned, as long as the distance and the path of the rim differ by a factor of less
    /// than 1e99; beyond, the shorter one is taken as 0. *Cost*: about ten motions to rest per solution.
    pub fn launches(
        &self,
        target: &Pose,
        turns: Turns,
        limits: &LaunchLimits,
    ) -> Result<Vec<LaunchSolution>, MotionError> {
        let flights = self.flights(target, turns, limits)?;
        let count = count(&flights);
        if count > MAX_SOLUTIONS {
            return Err(MotionError::TooMany { count });
        }
        let all = self.compute_launches(target, turns, limits, &flights, count)?;
        Ok(all.solutions)
    }

    /// Number of launches within `limits` that come to rest at `target`, and the `most` with the
    /// fewest turns, in order of increasing kinetic energy. Counting takes a few bisections for any number of
    /// launches.
    ///
    /// *Memory*: 72 bytes per listed launch. *Domain*: any finite limits. Of orientations that are more than
    /// 2^53 steps away only those are found whose number of steps is an f64; launches whose rim travels more
    /// than 1e99 times as far as the centre are omitted.
    pub fn fewest_turns(
        &self,
        target: &Pose,
        turns: Turns,
        limits: &LaunchLimits,
        most: u64,
    ) -> Result<Launches, MotionError> {
        let flights = self.flights(target, turns, limits)?;
        self.compute_launches(target, turns, limits, &flights, most)
    }

    /// The angles of each direction whose launches are within the limits.
    fn flights(
        &self,
        target: &Pose,
        turns: Turns,
        limits: &LaunchLimits,
    ) -> Result<Vec<AdmissibleAngles>, MotionError> {
        let distance = Real::hypot(target.x, target.y);
        if !distance.is_finite() || !target.angle.is_finite() {
            return Err(MotionError::Target { given: *target });
        }
        let [_, most] = self.reach(limits.max_speed(), limits.max_spin());
        let ladders = turns.ladders(target.angle).into_iter();
        let flights = ladders.map(|ladder| {
            let ranks = ladder.ranks(most.min(self.farthest_turn(distance)));
            let mut known = BTreeMap::new();
            let mut throw = |rank: u64| {
                *known
                    .entry(rank)
                    .or_insert_with(|| self.throw(distance, ladder.angle(rank)))
            };
            let first = partition(0, ranks, |rank| throw(rank).speed > limits.max_speed());
            let end = partition(first, ranks, |rank| throw(rank).spin <= limits.max_spin());
            AdmissibleAngles { ladder, first, end }
        });
        Ok(flights.collect())
    }

    /// The `most` launches with the fewest turns.
    fn compute_launches(
        &self,
        target: &Pose,
        turns: Turns,
        limits: &LaunchLimits,
        flights: &[AdmissibleAngles],
        most: u64,
    ) -> Result<Launches, MotionError> {
        let distance = Real::hypot(target.x, target.y);
        let mut angles: Vec<f64> = flights
            .iter()
            .flat_map(|flight| flight.angles(most))
            .collect();
        angles.sort_by(|a, b| a.abs().total_cmp(&b.abs()));
        // Beyond the exact whole numbers two ranks may round to one angle.
        angles.dedup();
        angles.truncate(usize::try_from(most).unwrap_or(usize::MAX));
        let all = angles.into_iter().map(|angle| {
            let throw = self.throw(distance, angle.abs());
            self.solution(target, angle, &throw)
        });
        let mut solutions: Vec<LaunchSolution> = all.filter(|one| is_within(one, limits)).collect();
        if solutions.iter().any(|solution| !solution.time.is_finite()) {
            return Err(MotionError::Target { given: *target });
        }
        let count = count(flights);
        if count == 0 || (most > 0 && solutions.is_empty()) {
            let ladders = turns.ladders(target.angle);
            let [farthest, most] = self.reach(limits.max_speed(), limits.max_spin());
            let needed = ladders
                .iter()
                .map(|ladder| self.nearest(target, ladder, limits));
            let Some(needed) =
                needed.min_by(|a, b| excess(a, limits).total_cmp(&excess(b, limits)))
            else {
                return Err(MotionError::Target { given: *target });
            };
            return Err(MotionError::OutOfReach(Box::new(OutOfReach {
                needed,
                limits: *limits,
                distance,
                distances: self.distances(needed.angle, limits),
                farthest,
                most,
            })));
        }
        solutions.sort_by(|a, b| a.energy_per_mass.total_cmp(&b.energy_per_mass));
        Ok(Launches { count, solutions })
    }

    /// A launch of given magnitudes, aimed at the target.
    fn solution(&self, target: &Pose, angle: f64, throw: &LaunchMagnitudes) -> LaunchSolution {
        let distance = Real::hypot(target.x, target.y);
        let along = |component: f64| match distance {
            0.0 => 0.0,
            _ => throw.speed * (component / distance),
        };
        let launch = Launch {
            velocity: [along(target.x), along(target.y)],
            spin: throw.spin.copysign(angle),
        };
        LaunchSolution {
            launch,
            speed: throw.speed,
            direction: match throw.speed {
                0.0 => 0.0,
                _ => libm::atan2(target.y, target.x),
            },
            angle,
            time: throw.time,
            energy_per_mass: self.energy_per_mass(&launch),
        }
    }

    /// The launch of one direction that exceeds the limits by the least. With more turns the required speed
    /// falls and the required spin rises: the optimum is where their excesses are equal.
    fn nearest(
        &self,
        target: &Pose,
        ladder: &EquivalentAngles,
        limits: &LaunchLimits,
    ) -> LaunchSolution {
        let distance = Real::hypot(target.x, target.y);
        let throw = |rank| self.throw(distance, ladder.angle(rank));
        let sliding_exceeds_more = |throw: &LaunchMagnitudes| {
            over(throw.speed, limits.max_speed()) > over(throw.spin, limits.max_spin())
        };
        let solution =
            |rank| self.solution(target, ladder.sense * ladder.angle(rank), &throw(rank));
        if ladder.step == 0.0 || limits.max_speed() == 0.0 {
            return solution(0);
        }
        let ranks = ladder.ranks(self.farthest_turn(distance));
        let mut end = 1;
        while end < ranks && sliding_exceeds_more(&throw(end)) {
            end *= 2;
        }
        let rank = partition(0, end.min(ranks), |rank| sliding_exceeds_more(&throw(rank)));
        let (before, after) = (solution(rank.saturating_sub(1)), solution(rank));
        if excess(&before, limits) < excess(&after, limits) {
            before
        } else {
            after
        }
    }
}

/// The first j of `from`..`to` for which `holds` is false; it is false for all that follow.
fn partition(from: u64, to: u64, mut holds: impl FnMut(u64) -> bool) -> u64 {
    let (mut low, mut high) = (from, to.max(from));
    while low < high {
        let middle = low + (high - low) / 2;
        if holds(middle) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    low
}

fn is_within(solution: &LaunchSolution, limits: &LaunchLimits) -> bool {
    solution.speed <= limits.max_speed() && solution.launch.spin.abs() <= limits.max_spin()
}

/// Ratio of a required value to its limit.
fn over(needed: f64, limit: f64) -> f64 {
    match needed {
        0.0 => 0.0,
        _ => needed / limit,
    }
}

/// Factor by which the limits are exceeded.
fn excess(solution: &LaunchSolution, limits: &LaunchLimits) -> f64 {
    let speed = over(solution.speed, limits.max_speed());
    let spin = over(solution.launch.spin.abs(), limits.max_spin());
    speed.max(spin)
}
