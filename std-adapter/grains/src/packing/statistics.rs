//! Statistics of the contacts of a packing: coordination, forces, thresholds.

use super::Limits;
use serde_json::{Map, Value};
use tribos_base::record::ContactRow;
use tribos_base::record::json_number;

/// Statistics of the contacts of a packing. *Units*: R, F_coh.
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
/// assert_eq!((found.contacts, found.wall_contacts), (2, 1));
/// assert_eq!(found.coordination, [0, 1, 2]); // one sphere has one contact, two have two
/// assert_eq!(found.mean_coordination(), 5.0 / 3.0);
/// assert_eq!(found.signs, [1, 1]); // one pushes, one pulls
/// assert_eq!(found.at_threshold, [Some(0.5), None, None]);
/// assert_eq!(found.json()["tension"]["largest"].as_f64(), Some(0.5));
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ContactStatistics {
    /// Number of contacts between spheres.
    pub contacts: usize,
    /// Number of contacts with substrate and piston.
    pub wall_contacts: usize,
    /// Number of spheres with 0, 1, 2, … contacts, walls included.
    pub coordination: Vec<usize>,
    /// Number of contacts between spheres that push, and of those that pull.
    pub signs: [usize; 2],
    /// Mean and largest normal force of the contacts that push.
    pub compression: [f64; 2],
    /// Mean and largest pull of the contacts that pull.
    pub tension: [f64; 2],
    /// Fractions of the contacts between spheres that are at the threshold of sliding, rolling and
    /// torsion; `None` for modes without friction, and in a packing of two materials, which has more
    /// thresholds than one. See [`Limits`].
    pub at_threshold: [Option<f64>; 3],
    /// Deepest overlap, a length; 0 if there is none. Results of a run have that of all its steps.
    pub max_overlap: f64,
}

impl ContactStatistics {
    /// Evaluates the contacts; `radii` are those of all spheres.
    pub fn of(contacts: &[ContactRow], radii: &[f64], limits: &Limits) -> Self {
        let mut counts = vec![0; radii.len()];
        let mut found = Self::default();
        let mut sums = [0.0; 2];
        let (mut carrying, mut at) = (0_usize, [0_usize; 3]);
        for contact in contacts {
            counts[contact.a as usize] += 1;
            found.max_overlap = found.max_overlap.max(-contact.gap);
            let Some(b) = contact.b.particle() else {
                found.wall_contacts += 1;
                continue;
            };
            counts[b as usize] += 1;
            found.contacts += 1;

            // Contacts that push, and contacts that pull.
            let force = contact.normal_force();
            if force > 0.0 {
                found.signs[0] += 1;
                sums[0] += force;
                found.compression[1] = found.compression[1].max(force);
            } else if force < 0.0 {
                found.signs[1] += 1;
                sums[1] -= force;
                found.tension[1] = found.tension[1].max(-force);
            }

            // Modes at their thresholds.
            if let Some(reached) = limits.reached(contact, radii) {
                carrying += 1;
                for (is, count) in reached.into_iter().zip(&mut at) {
                    *count += usize::from(is);
                }
            }
        }
        found.coordination = histogram(&counts);
        let mean = |sum: f64, count: usize| if count > 0 { sum / count as f64 } else { 0.0 };
        found.compression[0] = mean(sums[0], found.signs[0]);
        found.tension[0] = mean(sums[1], found.signs[1]);
        let resists = limits.resists();
        found.at_threshold =
            [0, 1, 2].map(|mode: usize| resists[mode].then(|| mean(at[mode] as f64, carrying)));
        found
    }

    /// Without a share of contacts at their thresholds if a second material has thresholds of its own.
    pub(crate) fn of_materials(mut self, is_mixed: bool) -> Self {
        if is_mixed {
            self.at_threshold = [None; 3];
        }
        self
    }

    /// With an overlap that was deeper before.
    pub(crate) fn since(mut self, overlap: f64) -> Self {
        self.max_overlap = self.max_overlap.max(overlap);
        self
    }

    /// Mean number of contacts of a sphere, including walls.
    pub fn mean_coordination(&self) -> f64 {
        let spheres: usize = self.coordination.iter().sum();
        let ends: usize = self
            .coordination
            .iter()
            .enumerate()
            .map(|(n, k)| n * k)
            .sum();
        ends as f64 / spheres as f64
    }

    /// The statistics as JSON.
    pub fn json(&self) -> Value {
        let pair = |[mean, most]: [f64; 2], count: usize| {
            let mut map = Map::new();
            map.insert("contacts".into(), count.into());
            map.insert("mean".into(), json_number(mean));
            map.insert("largest".into(), json_number(most));
            Value::Object(map)
        };
        let mut map = Map::new();
        map.insert("wall_contacts".into(), self.wall_contacts.into());
        map.insert(
            "mean_coordination".into(),
            json_number(self.mean_coordination()),
        );
        map.insert("coordination".into(), self.coordination.clone().into());
        map.insert("compression".into(), pair(self.compression, self.signs[0]));
        map.insert("tension".into(), pair(self.tension, self.signs[1]));
        let mut shares = Map::new();
        for (name, share) in ["sliding", "rolling", "torsion"]
            .iter()
            .zip(self.at_threshold)
        {
            shares.insert((*name).into(), share.map_or(Value::Null, json_number));
        }
        map.insert("at_threshold".into(), Value::Object(shares));
        Value::Object(map)
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
