//! Many wrenches at once, each under its own load.
//!
//! The wrenches of a group go through the search of their own calls side by side, to the same bits. A group with a
//! wrench or load out of the ordinary, and what remains of the slices, goes one by one.

use super::meridian::SideBySide;
use super::polar::{AxisymmetricPair, is_ordinary, is_ordinary_planar};
use super::searches::{Projected, ScaledCurve, inside};
use super::{Projection, Region, RoundLimitSurface};
use crate::coupling::DryReducedFriction;
use crate::lanes::{Lanes, Numbers};
use crate::real::Real;
use crate::twist::{Twist, Wrench};

/// Wrenches of a group with their loads, part by part.
struct Group<'a, R: Real, C> {
    set: ScaledCurve<'a, R, C, R::SideBySide>,
    pair: AxisymmetricPair<R::SideBySide>,
    /// Force and torque/radius.
    lengths: [R::SideBySide; 2],
}

impl<R: Real, C: DryReducedFriction<R>> RoundLimitSurface<R, C> {
    /// Gauges of many wrenches: the force limit of each is that of this surface times its load.
    ///
    /// A contact's load changes from step to step, and its surface with it in size alone: prepare it with the
    /// friction coefficient as force limit. Elements beyond the shortest slice are not changed.
    ///
    /// *Domain*: 0 ≤ load < ∞. *Special values*: NaN for a load that is negative or NaN and every wrench but zero.
    /// *Accuracy*: bit for bit [`super::FrictionSet::gauge`] of the surface with that force limit.
    ///
    /// ```
    /// use tribos_core::coupling::coulomb::CoulombDisk;
    /// use tribos_core::limit_surface::{FrictionSet, RoundLimitSurface};
    /// use tribos_core::twist::Wrench;
    /// let puck = RoundLimitSurface::new(CoulombDisk, 0.3_f64, 0.04)?; // coefficient, radius in m
    /// let pushes = [Wrench::new(0.2, 0.0, 0.004); 2]; // N, N m
    /// let mut gauges = [0.0; 2];
    /// puck.gauge_batch(&[1.7, 0.6], &pushes, &mut gauges); // loads in N
    /// assert!(gauges[0] < 1.0 && gauges[1] > 1.0); // one holds, one slips
    /// # Ok::<(), tribos_core::Error>(())
    /// ```
    pub fn gauge_batch(&self, loads: &[R], wrenches: &[Wrench<R>], gauges: &mut [R]) {
        each_group(
            self,
            loaded(loads, wrenches),
            gauges,
            true,
            |group, _, gauges| {
                let found = group.gauges().to_array();
                for (gauge, found) in gauges.iter_mut().zip(found.as_ref()) {
                    *gauge = *found;
                }
            },
            |load, wrench| self.loaded(R::Alone::repeat(load)).gauge_of(wrench),
        );
    }

    /// Motions that many pushes cause, whatever the load. Elements beyond the shorter slice are not changed.
    ///
    /// *Accuracy*: bit for bit [`super::FrictionSet::twist_normal_to`].
    ///
    /// ```
    /// use tribos_core::coupling::coulomb::CoulombDisk;
    /// use tribos_core::limit_surface::{FrictionSet, RoundLimitSurface};
    /// use tribos_core::twist::{Twist, Wrench};
    /// let puck = RoundLimitSurface::new(CoulombDisk, 0.3_f64, 0.04)?;
    /// let pushes = [1.0, -1.0].map(|sign| Wrench::new(sign * 0.2, 0.0, sign * 0.004));
    /// let mut motions = [Twist::ZERO; 2];
    /// puck.twist_normal_to_batch(&pushes, &mut motions);
    /// assert_eq!(motions[0], -motions[1]);
    /// # Ok::<(), tribos_core::Error>(())
    /// ```
    pub fn twist_normal_to_batch(&self, pushes: &[Wrench<R>], twists: &mut [Twist<R>]) {
        each_group(
            self,
            under_one_load(pushes),
            twists,
            true,
            |group, _, twists| group.store_motions(twists),
            |load, push| self.loaded(R::Alone::repeat(load)).motion_of(push),
        );
    }

    /// Projections of many wrenches: the force limit of each is that of this surface times its load, as in
    /// [`RoundLimitSurface::gauge_batch`]. Elements beyond the shortest slice are not changed.
    ///
    /// *Domain*: 0 ≤ load < ∞; `length` as in [`super::FrictionSet::project_with_length`], usually the radius.
    /// *Special values*: NaN for a negative load and every wrench but zero. *Accuracy*: bit for bit that of the surface with that force limit.
    ///
    /// ```
    /// use tribos_core::coupling::coulomb::CoulombDisk;
    /// use tribos_core::limit_surface::{FrictionSet, RoundLimitSurface, Projection, Region};
    /// use tribos_core::twist::Wrench;
    /// let puck = RoundLimitSurface::new(CoulombDisk, 0.3_f64, 0.04)?; // coefficient, radius in m
    /// let pushes = [Wrench::new(0.2, 0.0, 0.004); 2]; // N, N m
    /// let mut carried = pushes.map(|wrench| Projection { wrench, region: Region::Inside });
    /// puck.project_batch(puck.radius(), &[1.7, 0.6], &pushes, &mut carried); // loads in N
    /// assert!(carried[0].region == Region::Inside && carried[1].region != Region::Inside);
    /// assert!(carried[1].wrench.force.x < 0.3 * 0.6);
    /// # Ok::<(), tribos_core::Error>(())
    /// ```
    pub fn project_batch(
        &self,
        length: R,
        loads: &[R],
        wrenches: &[Wrench<R>],
        projections: &mut [Projection<R>],
    ) {
        self.project_groups(length, loaded(loads, wrenches), projections);
    }

    /// Projections of groups of loads and wrenches.
    pub(super) fn project_groups<'a>(
        &self,
        length: R,
        groups: impl Iterator<Item = Inputs<'a, R>>,
        projections: &mut [Projection<R>],
    ) {
        each_group(
            self,
            groups,
            projections,
            length > R::ZERO && length.is_finite(),
            |group, wrenches, projections| group.store_projections(length, wrenches, projections),
            |load, wrench| {
                self.loaded(R::Alone::repeat(load))
                    .project_one(wrench, length)
            },
        );
    }
}

impl<'a, R: Real, C: DryReducedFriction<R>> Group<'a, R, C> {
    /// Nothing for other counts than that of the lanes, and where a wrench or a load is out of the ordinary.
    #[inline(always)]
    fn new(surface: &'a RoundLimitSurface<R, C>, (loads, wrenches): Inputs<'_, R>) -> Option<Self> {
        let [mut x, mut y, mut torque] = [R::SideBySide::splat(0.0).to_array(); 3];
        let mut load = R::SideBySide::splat(1.0).to_array();
        let count = x.as_ref().len();
        if wrenches.len() != count || loads.is_some_and(|loads| loads.len() != count) {
            return None;
        }
        let forces = x.as_mut().iter_mut().zip(y.as_mut());
        for (((x, y), torque), wrench) in forces.zip(torque.as_mut()).zip(wrenches) {
            (*x, *y, *torque) = (wrench.force.x, wrench.force.y, wrench.torque);
        }
        for (to, from) in load.as_mut().iter_mut().zip(loads.unwrap_or_default()) {
            *to = *from;
        }
        let wrench = [x, y, torque].map(R::SideBySide::new);
        let set = surface.loaded(R::SideBySide::new(load));
        let [x, y, torque] = wrench;
        let pair = AxisymmetricPair::of_ordinary(wrench);
        let lengths = set.lengths(&pair);
        let ([force, turn], limit) = (lengths, set.force_limit);
        // Mostly nothing is zero or near the ends of the range.
        let (least, sum) = (R::TWO * R::LEAST_SPEED, force + turn + limit);
        let is_plain = R::SideBySide::both(
            R::SideBySide::repeat(least).below(force.smaller(turn).smaller(limit)),
            sum.below(R::SideBySide::repeat(R::ONE / least)),
        );
        let is_known =
            R::SideBySide::all(is_plain) || is_known::<R>([x, y, torque], lengths, limit);
        is_known.then_some(Self { set, pair, lengths })
    }

    #[inline(always)]
    fn gauges(&self) -> R::SideBySide {
        let gauge = self.set.gauge(&SideBySide(self.set.meridian), self.lengths);
        R::SideBySide::select(self.is_none(), R::SideBySide::splat(0.0), gauge)
    }

    /// True where neither force nor torque is given.
    #[inline(always)]
    fn is_none(&self) -> <R::SideBySide as Lanes>::Mask {
        let [force, torque] = self.lengths;
        (force + torque).at_most(R::SideBySide::splat(0.0))
    }

    #[inline(always)]
    fn store_motions(&self, twists: &mut [Twist<R>]) {
        let motion = self
            .set
            .motion(&SideBySide(self.set.meridian), &self.pair, self.lengths);
        let (is_none, zero) = (self.is_none(), R::SideBySide::splat(0.0));
        let parts = motion.map(|part| R::SideBySide::select(is_none, zero, part).to_array());
        for (twist, [x, y, spin]) in twists.iter_mut().zip(rows(&parts)) {
            *twist = Twist::new(x, y, spin);
        }
    }

    #[inline(always)]
    fn store_projections(
        &self,
        length: R,
        wrenches: &[Wrench<R>],
        projections: &mut [Projection<R>],
    ) {
        let is_deep = self.set.is_deep_inside(self.lengths);
        if R::SideBySide::all(is_deep) {
            for (projection, wrench) in projections.iter_mut().zip(wrenches) {
                *projection = inside(wrench);
            }
            return;
        }
        let curve = SideBySide(self.set.meridian);
        let Projected {
            wrench,
            normal,
            side,
        } = self.set.project(&curve, &self.pair, length);
        let (wrench, normal) = (wrench.map(Numbers::to_array), normal.map(Numbers::to_array));
        let lanes = rows(&wrench).zip(rows(&normal));
        for (projection, ([x, y, torque], [vx, vy, spin])) in projections.iter_mut().zip(lanes) {
            let normal = Twist::new(vx, vy, spin);
            *projection = Projection {
                wrench: Wrench::new(x, y, torque),
                region: Region::OnSurface { normal },
            };
        }
        let none = R::SideBySide::splat(0.0);
        let side = R::SideBySide::select(is_deep, R::SideBySide::splat(1.0), side);
        if R::SideBySide::all(side.below(none)) {
            return;
        }
        let (side, limits) = (side.to_array(), self.set.force_limit.to_array());
        let lanes = side.as_ref().iter().zip(limits.as_ref());
        for ((projection, given), (side, limit)) in projections.iter_mut().zip(wrenches).zip(lanes)
        {
            if *side > R::ZERO {
                *projection = inside(given);
            } else if *side == R::ZERO {
                let alone = ScaledCurve {
                    meridian: self.set.meridian,
                    force_limit: R::Alone::repeat(*limit),
                    radius: self.set.radius,
                };
                *projection = alone.beside_surface(given, *projection);
            }
        }
    }
}

/// True of wrenches, lengths and limits that the searches side by side take as those alone do.
#[cold]
fn is_known<R: Real>(
    [x, y, torque]: [R::SideBySide; 3],
    [force, turn]: [R::SideBySide; 2],
    limit: R::SideBySide,
) -> bool {
    let zero = R::SideBySide::splat(0.0);
    // Over a large radius a torque may vanish.
    let is_kept = R::SideBySide::either(zero.below(turn), torque.abs().at_most(zero));
    let sizes = R::SideBySide::both(
        R::SideBySide::both(is_ordinary_planar(x, y), is_ordinary(force)),
        R::SideBySide::both(is_ordinary(turn), is_kept),
    );
    let limits = R::SideBySide::both(is_ordinary(limit), zero.below(limit));
    R::SideBySide::all(R::SideBySide::both(sizes, limits))
}

/// A group's loads, all 1 where there are none, and its wrenches.
type Inputs<'a, R> = (Option<&'a [R]>, &'a [Wrench<R>]);

/// Groups of wrenches with their loads.
fn loaded<'a, R: Real>(
    loads: &'a [R],
    wrenches: &'a [Wrench<R>],
) -> impl Iterator<Item = Inputs<'a, R>> {
    let loads = loads.chunks(lanes::<R>()).map(Some);
    loads.zip(wrenches.chunks(lanes::<R>()))
}

/// Groups of wrenches under the force limit itself.
pub(super) fn under_one_load<R: Real>(
    wrenches: &[Wrench<R>],
) -> impl Iterator<Item = Inputs<'_, R>> {
    wrenches.chunks(lanes::<R>()).map(|group| (None, group))
}

/// Lanes of a precision.
#[inline(always)]
fn lanes<R: Real>() -> usize {
    R::SideBySide::splat(0.0).to_array().as_ref().len()
}

/// The three parts of each lane.
#[inline(always)]
fn rows<'a, R: Copy + 'a, A: AsRef<[R]>>(
    [x, y, z]: &'a [A; 3],
) -> impl Iterator<Item = [R; 3]> + 'a {
    let rows = x.as_ref().iter().zip(y.as_ref()).zip(z.as_ref());
    rows.map(|((x, y), z)| [*x, *y, *z])
}

/// Answers each group `together`, where it is ordinary and whole, else one by one.
#[inline(always)]
fn each_group<'a, R: Real, C: DryReducedFriction<R>, T>(
    surface: &RoundLimitSurface<R, C>,
    inputs: impl Iterator<Item = Inputs<'a, R>>,
    answers: &mut [T],
    may_be_together: bool,
    together: impl Fn(&Group<'_, R, C>, &[Wrench<R>], &mut [T]),
    alone: impl Fn(R, &Wrench<R>) -> T,
) {
    let groups = answers.chunks_mut(lanes::<R>());
    for ((loads, wrenches), answers) in inputs.zip(groups) {
        match Group::new(surface, (loads, wrenches)) {
            Some(group) if may_be_together && answers.len() == wrenches.len() => {
                together(&group, wrenches, answers);
            }
            _ => {
                for (n, (wrench, answer)) in wrenches.iter().zip(answers).enumerate() {
                    if let Some(load) = loads.map_or(Some(&R::ONE), |loads| loads.get(n)) {
                        *answer = alone(*load, wrench);
                    }
                }
            }
        }
    }
}
