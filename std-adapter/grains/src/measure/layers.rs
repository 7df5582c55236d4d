//! Means over time in layers across an axis.

use super::stress::masses;
use super::{Assembly, KnownForces, Table};
use crate::grains::held_types;
use crate::packing::{branch, volume_between};
use nalgebra::{Matrix3, Vector3};
use std::f64::consts::PI;
use tribos_base::statistics::TimeAverage;

/// Means of a layer over time, with their standard errors. *Units*: those of the run.
#[derive(Clone, Debug, PartialEq)]
pub struct Layer {
    /// Low and high end; of a period that changes the mean over time.
    pub ends: [f64; 2],
    /// Share of the volume that is solid, with the exact volumes of spheres that the ends cut.
    pub solid_fraction: TimeAverage,
    /// Velocity of the mass in the layer along x, y and z.
    pub velocity: [TimeAverage; 3],
    /// Granular temperature: a third of the mean square of the velocities about that of the layer.
    pub temperature: TimeAverage,
    /// Stress xx, yy, zz and xz, positive for compression: contacts, each by the share of its branch in the layer, and the
    /// motion about the velocity of the layer. NaN where no forces are known.
    pub stress: [TimeAverage; 4],
    /// Shear stress over normal stress across z, -xz over zz: that of their means.
    pub stress_ratio: TimeAverage,
}

/// Profiles of a flow: means over time in layers of equal thickness across an axis. Spheres that no force moves (glued,
/// driven) are no part of them but as partners of contacts.
#[derive(Clone, Debug, PartialEq)]
pub struct LayerProfile {
    /// The axis: 0, 1 or 2 for x, y or z.
    pub axis: usize,
    /// Time from which on the means are taken.
    pub from: f64,
    /// Layers from low to high.
    pub layers: Vec<Layer>,
}

/// Ends, then each mean and its error in the order of [`Layer::means`].
const COLUMNS: &[&str] = &[
    "low",
    "high",
    "solid_fraction",
    "solid_fraction_error",
    "velocity_x",
    "velocity_x_error",
    "velocity_y",
    "velocity_y_error",
    "velocity_z",
    "velocity_z_error",
    "temperature",
    "temperature_error",
    "stress_xx",
    "stress_xx_error",
    "stress_yy",
    "stress_yy_error",
    "stress_zz",
    "stress_zz_error",
    "stress_xz",
    "stress_xz_error",
    "stress_ratio",
    "stress_ratio_error",
];

/// What a layer has at one time.
#[derive(Clone, Copy, Debug, Default)]
struct Content {
    ends: [f64; 2],
    volume: f64,
    solid: f64,
    mass: f64,
    momentum: Vector3<f64>,
    /// Σ m v v, and Σ F l over the contacts.
    motion: Matrix3<f64>,
    virial: Matrix3<f64>,
}

impl Content {
    fn velocity(&self) -> Vector3<f64> {
        self.momentum / self.mass
    }

    /// Σ m u u about the velocity of the layer.
    fn fluctuation(&self) -> Matrix3<f64> {
        if self.mass > 0.0 {
            self.motion - self.momentum * self.momentum.transpose() / self.mass
        } else {
            Matrix3::zeros()
        }
    }

    fn stress(&self) -> Matrix3<f64> {
        (self.virial + self.fluctuation()) / self.volume
    }
}

impl Layer {
    /// The means in the order of the columns.
    fn means(&self) -> impl Iterator<Item = &TimeAverage> {
        let first = std::iter::once(&self.solid_fraction).chain(&self.velocity);
        first
            .chain(std::iter::once(&self.temperature))
            .chain(&self.stress)
            .chain(std::iter::once(&self.stress_ratio))
    }

    fn of(times: &[f64], contents: &[Content], from: f64, has_forces: bool) -> Self {
        let all = |of: &dyn Fn(&Content) -> f64| contents.iter().map(of).collect::<Vec<f64>>();
        let mean = |of: &dyn Fn(&Content) -> f64| TimeAverage::of(times, &all(of), Some(from));
        // Means of the mass: the momentum of all times over their mass.
        let masses = all(&|content| content.mass);
        let is_empty = masses.iter().all(|mass| *mass == 0.0);
        let of_mass = |of: &dyn Fn(&Content) -> f64| {
            let value = |content: &Content| match content.mass > 0.0 {
                true => of(content),
                false if is_empty => f64::NAN,
                false => 0.0,
            };
            TimeAverage::weighted(times, &all(&value), &masses, Some(from))
        };
        let stress = |[i, j]: [usize; 2]| {
            let value = |content: &Content| match has_forces {
                true => content.stress()[(i, j)],
                false => f64::NAN,
            };
            mean(&value)
        };
        // As a mean with the normal stress as weight; a layer without it has no ratio.
        let weights = all(&|content| content.stress().m33.max(0.0));
        let bears = has_forces && weights.iter().any(|stress| *stress > 0.0);
        let ratios = all(&|content| match content.stress() {
            stress if bears && stress.m33 > 0.0 => -stress.m13 / stress.m33,
            _ if bears => 0.0,
            _ => f64::NAN,
        });
        let count = contents.len() as f64;
        let end = |at: usize| all(&|content| content.ends[at]).iter().sum::<f64>() / count;
        Self {
            ends: [end(0), end(1)],
            solid_fraction: mean(&|content| content.solid / content.volume),
            velocity: [0, 1, 2].map(|i| of_mass(&|content| content.velocity()[i])),
            temperature: of_mass(&|content| content.fluctuation().trace() / (3.0 * content.mass)),
            stress: [[0, 0], [1, 1], [2, 2], [0, 2]].map(stress),
            stress_ratio: TimeAverage::weighted(times, &ratios, &weights, Some(from)),
        }
    }
}

impl LayerProfile {
    /// Profiles of states in the order of time, from a time on; by default from the middle of the record. `None` if the
    /// velocities are not known, or no state is later. States without a time count by their order.
    ///
    /// ```
    /// use tribos::measure::{Assembly, LayerProfile};
    /// use tribos::{nalgebra::Vector3, space::PeriodicBox};
    /// // Two spheres in a cube of side 4, one above the other; that above flows along x.
    /// let space = PeriodicBox::new([Some(4.0); 3])?;
    /// let at = |z: f64| Vector3::new(2.0, 2.0, z);
    /// let mut state = Assembly::new(space, vec![at(1.0), at(3.0)], vec![1.0; 2]);
    /// state.velocities = Some(vec![Vector3::zeros(), Vector3::x()]);
    /// let flow = LayerProfile::of(&[state.clone(), state], (2, 2), None).ok_or("no velocities")?;
    /// assert_eq!((flow.layers[0].velocity[0].mean, flow.layers[1].velocity[0].mean), (0.0, 1.0));
    /// let solid = std::f64::consts::PI / 24.0;
    /// assert!((flow.layers[0].solid_fraction.mean - solid).abs() < 1e-12);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn of(
        states: &[Assembly],
        (axis, count): (usize, usize),
        from: Option<f64>,
    ) -> Option<Self> {
        let time = |(order, state): (usize, &Assembly)| state.time.unwrap_or(order as f64);
        let times: Vec<f64> = states.iter().enumerate().map(time).collect();
        let from = from.unwrap_or(0.5 * (times.first()? + times.last()?));
        // The state before the first that counts begins its time.
        let begin = times.iter().skip(1).position(|time| *time > from)?;
        let (states, times) = (states.get(begin..)?, times.get(begin..)?);
        // The box as far as there are spheres: below an open top it ends nowhere.
        let low_and_high = |[low, high]: [f64; 2], state: &Assembly| {
            let ([from, to], [first, last]) = (state.bounds[axis], state.extent(axis));
            [low.min(from.max(first)), high.max(to.min(last))]
        };
        let all = states
            .iter()
            .fold([f64::INFINITY, f64::NEG_INFINITY], low_and_high);
        let in_layers = |state| contents(state, (axis, count), all);
        let contents: Vec<Vec<Content>> = states.iter().map(in_layers).collect::<Option<_>>()?;
        let has_forces = states
            .iter()
            .all(|state| state.forces != KnownForces::Unknown);
        let layer = |at: usize| {
            let of_layer: Vec<Content> = contents.iter().map(|state| state[at]).collect();
            Layer::of(times, &of_layer, from, has_forces)
        };
        Some(Self {
            axis,
            from: times[0],
            layers: (0..count).map(layer).collect(),
        })
    }

    /// Columns: ends of the layer, then each mean with its standard error.
    pub fn table(&self) -> Table {
        let row = |layer: &Layer| {
            let means = layer.means().flat_map(|mean| [mean.mean, mean.error]);
            layer.ends.into_iter().chain(means).collect()
        };
        Table {
            name: "layers",
            columns: COLUMNS,
            rows: self.layers.iter().map(row).collect(),
        }
    }
}

/// Layers of a state across an axis: of its period, or between ends common to all states.
fn contents(
    state: &Assembly,
    (axis, count): (usize, usize),
    common: [f64; 2],
) -> Option<Vec<Content>> {
    let velocities = state.velocities.as_ref()?;
    let period = state.space.lengths()[axis];
    let [low, high] = period.map_or(common, |length| [0.0, length]);
    let thickness = (high - low) / count as f64;
    let [own_low, own_high] = state.bounds[axis];
    let area = state.volume() / (own_high - own_low);
    let edge = |at: usize| low + thickness * at as f64;
    let empty = |at: usize| Content {
        ends: [edge(at), edge(at + 1)],
        volume: area * thickness,
        ..Content::default()
    };
    let mut layers: Vec<Content> = (0..count).map(empty).collect();
    // The layers that a stretch of the axis meets, with the shift of the image that meets each.
    let met = |from: f64, to: f64| {
        let (first, last) = ((from - low) / thickness, (to - low) / thickness);
        let whole = count as i64;
        (first.floor() as i64..=last.floor() as i64).filter_map(move |at| {
            let layer = at.rem_euclid(whole);
            let shift = (at - layer) as f64 / count as f64;
            (layer == at || period.is_some()).then_some((layer as usize, shift * (high - low)))
        })
    };
    let (masses, held) = (masses(state, None), held_types(&state.scene));
    for (sphere, (place, radius)) in state.positions.iter().zip(&state.radii).enumerate() {
        let kind = state.materials.as_ref().map_or(0, |kinds| kinds[sphere]);
        if held.has(kind) {
            continue;
        }
        let height = state.space.wrap(place)[axis];
        let volume = 4.0 / 3.0 * PI * radius * radius * radius;
        for (at, shift) in met(height - radius, height + radius) {
            let layer = &mut layers[at];
            let centre = Vector3::z() * (height - shift);
            let solid = volume_between(&[centre], &[*radius], layer.ends);
            let (mass, velocity) = (masses[sphere] * (solid / volume), velocities[sphere]);
            layer.solid += solid;
            layer.mass += mass;
            layer.momentum += velocity * mass;
            layer.motion += velocity * velocity.transpose() * mass;
        }
    }
    for row in &state.contacts {
        let way = branch(row, &state.radii);
        let start = state.space.wrap(&state.positions[row.a as usize])[axis];
        let [from, to] = [start.min(start + way[axis]), start.max(start + way[axis])];
        for (at, shift) in met(from, to) {
            let [begin, end] = layers[at].ends.map(|end| end + shift);
            // A branch along the layer lies in the one of its start.
            let share = match to > from {
                true => ((to.min(end) - from.max(begin)) / (to - from)).max(0.0),
                false => 1.0,
            };
            layers[at].virial += row.force * way.transpose() * share;
        }
    }
    Some(layers)
}
