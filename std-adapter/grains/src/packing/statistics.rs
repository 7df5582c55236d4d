//! Statistics of the contacts of a packing: coordination, forces, thresholds.

use super::Limits;
use tribos_base::record::ContactRow;
use tribos_base::results::{Reporting::*, summary};

summary! {
    /// Contacts between spheres whose normal forces have one sign.
    #[derive(Copy, Default)]
    pub struct NormalForces = part;

    /// Number of these contacts.
    contacts: usize, "-";
    /// Mean magnitude of their normal forces.
    mean: f64, "force";
    /// Largest magnitude of their normal forces.
    largest: f64, "force";
}

summary! {
    /// Shares of the contacts between spheres that are at their thresholds; none for modes without friction, and in a
    /// packing of several materials, which has more thresholds than one. See [`Limits`].
    #[derive(Copy, Default)]
    pub struct ThresholdShares = part;

    /// Share at the threshold of sliding.
    sliding: Option<f64>, "-";
    /// Share at the threshold of rolling.
    rolling: Option<f64>, "-";
    /// Share at the threshold of torsion.
    torsion: Option<f64>, "-";
}

summary! {
    /// Statistics of the contacts of a packing, in its units. The parts of `compression`, `tension` and `at_threshold`
    /// are listed with their meanings in docs/results.md.
    ///
    /// ```
    /// use nalgebra::Vector3;
    /// use tribos::powder::{Limits, ContactStatistics};
    /// use tribos::record::{ContactRow, Partner};
    /// # use tribos::scene::PowderScene;
    /// // Three spheres in a row from a wall on.
    /// let (normal, torque) = (Vector3::x(), Vector3::zeros());
    /// let touch = |a, b, force| ContactRow { a, b, normal, gap: 0.0, force, torque };
    /// let contacts = [
    ///     touch(0, Partner::Wall(0), Vector3::new(3.0, 0.0, 0.0)),
    ///     // A push of 3 and the cohesion of 1: the threshold of sliding lies at 0.3 of their sum.
    ///     touch(0, Partner::Particle(1), Vector3::new(3.0, 0.0, 1.2)),
    ///     touch(1, Partner::Particle(2), Vector3::new(-0.5, 0.0, 0.0)),
    /// ];
    /// let scene = PowderScene { width: 6.0, height: 8.0, mu: 0.3, ..PowderScene::default() };
    /// let found = ContactStatistics::of(&contacts, &[1.0; 3], &Limits::of(&scene.material()));
    /// assert_eq!(found.wall_contacts, 1);
    /// assert_eq!(found.coordination, [0, 1, 2]); // one sphere has one contact, two have two
    /// assert_eq!(found.mean_coordination, 5.0 / 3.0);
    /// assert_eq!((found.compression.contacts, found.tension.contacts), (1, 1)); // one pushes, one pulls
    /// assert_eq!((found.at_threshold.sliding, found.at_threshold.rolling), (Some(0.5), None));
    /// assert_eq!(found.tension.largest, 0.5);
    /// ```
    #[derive(Default)]
    pub struct ContactStatistics = part;

    /// Number of contacts with walls.
    wall_contacts: usize, "-";
    /// Mean number of contacts of a sphere, walls included.
    mean_coordination: f64, "-", ShownAs("coordination", "contacts a sphere");
    /// Number of spheres with 0, 1, 2, … contacts, walls included.
    coordination: Vec<usize>, "-";
    /// Contacts that push.
    compression: NormalForces, "-";
    /// Contacts that pull.
    tension: NormalForces, "-";
    /// Shares of the contacts that are at their thresholds.
    at_threshold: ThresholdShares, "-";
}

impl NormalForces {
    fn of(forces: &[f64]) -> Self {
        Self {
            contacts: forces.len(),
            mean: mean(forces.iter().sum(), forces.len()),
            largest: forces.iter().copied().fold(0.0, f64::max),
        }
    }
}

/// Mean of a sum over so many; 0 of none.
fn mean(sum: f64, count: usize) -> f64 {
    if count > 0 { sum / count as f64 } else { 0.0 }
}

impl ContactStatistics {
    /// Evaluates the contacts; `radii` are those of all spheres.
    pub fn of(contacts: &[ContactRow], radii: &[f64], limits: &Limits) -> Self {
        let mut counts = vec![0; radii.len()];
        let mut found = Self::default();
        let [mut pushes, mut pulls] = [const { Vec::new() }; 2];
        let (mut carrying, mut at) = (0_usize, [0_usize; 3]);
        for contact in contacts {
            counts[contact.a as usize] += 1;
            let Some(b) = contact.b.particle() else {
                found.wall_contacts += 1;
                continue;
            };
            counts[b as usize] += 1;

            // Contacts that push, and contacts that pull.
            let force = contact.normal_force();
            if force > 0.0 {
                pushes.push(force);
            } else if force < 0.0 {
                pulls.push(-force);
            }

            // Modes at their thresholds.
            if let Some(reached) = limits.reached(contact, radii) {
                carrying += 1;
                for (is, count) in reached.into_iter().zip(&mut at) {
                    *count += usize::from(is);
                }
            }
        }
        found.mean_coordination = counts.iter().sum::<usize>() as f64 / counts.len() as f64;
        found.coordination = histogram(&counts);
        [found.compression, found.tension] =
            [pushes, pulls].map(|forces| NormalForces::of(&forces));
        let resists = limits.resists();
        let [sliding, rolling, torsion] =
            [0, 1, 2].map(|mode: usize| resists[mode].then(|| mean(at[mode] as f64, carrying)));
        found.at_threshold = ThresholdShares {
            sliding,
            rolling,
            torsion,
        };
        found
    }

    /// Without a share of contacts at their thresholds if other materials have thresholds of its own.
    pub(crate) fn of_materials(mut self, is_mixed: bool) -> Self {
        if is_mixed {
            self.at_threshold = ThresholdShares::default();
        }
        self
    }
}

/// Number of spheres with 0, 1, 2, … contacts.
fn histogram(counts: &[usize]) -> Vec<usize> {
    let most = counts.iter().copied().max().unwrap_or(0);
    let mut histogram = vec![0; most + 1];
    for &count in counts {
        histogram[count] += 1;
    }
    histogram
}
