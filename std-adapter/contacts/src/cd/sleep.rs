//! Sleep: groups of bodies at rest cost nothing until something touches them.

use super::assemble::PairGeometry;
use super::energy::EnergyBalance;
use super::setup::keeps_motion;
use super::wall::Wall;
use tribos_core::contact::SphereBody;

/// Number of slow steps after which a group of bodies is put to sleep.
const PATIENCE: u8 = 4;

/// Who is awake.
///
/// ```
/// use nalgebra::Vector3;
/// use tribos::cd::{EnergyBalance, solid};
/// use tribos::cd::internals::Sleep;
/// use tribos::kernel::contact::ContactGeometry;
/// // Two balls that touch and do not move: after a few steps they sleep.
/// let pairs = [([0, 1], ContactGeometry::spheres(&Vector3::new(0.02, 0.0, 0.0), [0.01; 2])?)];
/// let mut balls = [solid(0.01, 2500.0); 2];
/// let mut rest = Sleep::new(2);
/// for _ in 0..10 {
///     rest.wake(1e-3, &pairs, &[], &[]);
///     rest.settle(1e-3, &mut balls, &mut EnergyBalance::default());
/// }
/// assert_eq!(rest.awake(), [false, false]);
/// // Who is touched by somebody awake wakes up.
/// let mut rest = Sleep::restored(vec![false, true], rest.slow_steps().to_vec());
/// rest.wake(1e-3, &pairs, &[], &[]);
/// assert_eq!(rest.awake(), [true, true]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Sleep {
    awake: Vec<bool>,
    /// Number of steps for which each body has been slow.
    still: Vec<u8>,
    /// Group of each body, with one more for walls that move.
    group: Vec<u32>,
}

impl Sleep {
    /// Starts with all bodies awake.
    pub fn new(bodies: usize) -> Self {
        Self {
            awake: vec![true; bodies],
            still: vec![0; bodies],
            group: Vec::new(),
        }
    }

    /// Restores a state from the results of [`Sleep::awake`] and [`Sleep::still`].
    pub fn restored(awake: Vec<bool>, still: Vec<u8>) -> Self {
        Self {
            awake,
            still,
            group: Vec::new(),
        }
    }

    /// Number of steps for which each body has been slow.
    pub fn slow_steps(&self) -> &[u8] {
        &self.still
    }

    /// One flag per body, true if it is awake.
    pub fn awake(&self) -> &[bool] {
        &self.awake
    }

    /// Finds the groups of touching bodies; a group with an awake member is awake.
    pub fn wake(
        &mut self,
        sleep_speed: f64,
        pairs: &[PairGeometry],
        walls: &[PairGeometry],
        plates: &[Wall],
    ) {
        if sleep_speed <= 0.0 {
            return;
        }
        let count = self.awake.len() as u32;
        self.group.clear();
        self.group.extend(0..=count);
        for ([a, b], _) in pairs {
            join(&mut self.group, *a, *b);
        }
        // A wall that can move, or does, joins the group of the bodies that it touches.
        let moves = |wall: &Wall| wall.plate.inv_mass > 0.0 || wall.plate.velocity.norm() > 0.0;
        for ([a, wall], _) in walls {
            // A mesh is taken to move.
            if plates.get(*wall as usize).is_none_or(moves) {
                join(&mut self.group, *a, count);
            }
        }
        let mut awake = vec![false; self.group.len()];
        awake[find(&mut self.group, count) as usize] = true;
        for body in 0..count {
            if self.awake[body as usize] {
                awake[find(&mut self.group, body) as usize] = true;
            }
        }
        for body in 0..count {
            self.awake[body as usize] = awake[find(&mut self.group, body) as usize];
        }
    }

    /// Puts groups to sleep in which every body has been slow for long enough.
    pub fn settle(
        &mut self,
        sleep_speed: f64,
        spheres: &mut [SphereBody<f64>],
        energy: &mut EnergyBalance,
    ) {
        if sleep_speed <= 0.0 {
            return;
        }
        for (sphere, still) in spheres.iter().zip(&mut self.still) {
            // A solid sphere's surface speed from its inertia: R² = 2.5 I/m.
            let turn = if keeps_motion(sphere) {
                0.0
            } else {
                sphere.spin.norm() * (2.5 * sphere.inv_mass / sphere.inv_inertia).sqrt()
            };
            let moves = sphere.velocity.norm() + turn > sleep_speed;
            *still = if moves { 0 } else { still.saturating_add(1) };
        }
        let count = self.awake.len();
        let mut restless = vec![false; self.group.len()];
        restless[find(&mut self.group, count as u32) as usize] = true;
        for body in 0..count {
            if self.still[body] < PATIENCE {
                restless[find(&mut self.group, body as u32) as usize] = true;
            }
        }
        for body in 0..count {
            let awake = restless[find(&mut self.group, body as u32) as usize];
            if self.awake[body] && !awake {
                let sphere = &mut spheres[body];
                energy.add_sleep(sphere);
                sphere.velocity.fill(0.0);
                sphere.spin.fill(0.0);
            }
            self.awake[body] = awake;
        }
    }
}

/// Root of a body's group; paths are halved during the search.
fn find(group: &mut [u32], mut body: u32) -> u32 {
    while group[body as usize] != body {
        let above = group[group[body as usize] as usize];
        group[body as usize] = above;
        body = above;
    }
    body
}

/// Joins two groups under the smaller root.
fn join(group: &mut [u32], a: u32, b: u32) {
    let [a, b] = [a, b].map(|body| find(group, body));
    let (low, high) = if a < b { (a, b) } else { (b, a) };
    group[high as usize] = low;
}
