//! One state of a trajectory.

use crate::record::frames::{Bodies, Frame};
use nalgebra::Vector3;

/// Bodies at one time. Any consistent units.
#[derive(Clone, Debug, PartialEq)]
pub struct State {
    /// Steps since the start.
    pub step: u64,
    /// Time.
    pub time: f64,
    /// The box along x, y and z.
    pub sides: [Side; 3],
    /// Displacement along x of the images one period higher along z, 0 unless the box is sheared.
    pub tilt: f64,
    /// Centres of the bodies.
    pub places: Vec<Vector3<f64>>,
    /// Further properties of each body.
    pub columns: Vec<Column>,
}

/// The box along one axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Side {
    /// Low end of the box.
    pub low: f64,
    /// High end of the box.
    pub high: f64,
    /// Whether the box repeats.
    pub is_periodic: bool,
}

/// A property of all bodies.
#[derive(Clone, Debug, PartialEq)]
pub struct Column {
    /// Name, one word. `radius`, `velocity` and `angular_velocity` are written under the names that
    /// each program uses; `material`, from 1, is the type of LAMMPS.
    pub name: &'static str,
    /// A value for each body.
    pub values: Values,
}

/// Values of a property.
#[derive(Clone, Debug, PartialEq)]
pub enum Values {
    /// Whole numbers.
    Integers(Vec<i64>),
    /// Numbers.
    Numbers(Vec<f64>),
    /// Vectors.
    Vectors(Vec<Vector3<f64>>),
}

impl Side {
    /// A periodic side from 0 to a length.
    pub fn periodic(length: f64) -> Self {
        Self {
            low: 0.0,
            high: length,
            is_periodic: true,
        }
    }

    /// An open side between two ends.
    pub fn open(low: f64, high: f64) -> Self {
        Self {
            low,
            high,
            is_periodic: false,
        }
    }
}

impl Column {
    /// A column of these values.
    pub fn new(name: &'static str, values: Values) -> Self {
        Self { name, values }
    }
}

impl State {
    /// The state of a stored frame, with the accuracy of [frames](crate::record::frames): the box with its periods,
    /// positions, radii, speeds, velocities, densities and materials where they are known, the number of contacts of each
    /// sphere, layer and part of each atom of a tip.
    ///
    /// ```
    /// use nalgebra::Vector3;
    /// use tribos::record::frames::{Bodies, Frame, Kind};
    /// use tribos::record::trajectory::{State, Values};
    /// let bodies = Bodies {
    ///     kind: Kind::Powder,
    ///     scene: serde_json::json!({"body": "powder"}),
    ///     limit: 2,
    ///     stride: 1,
    ///     sides: [10.0; 2],
    ///     periods: [Some(10.0), Some(10.0), None],
    ///     radii: vec![1.0],
    ///     materials: Vec::new(),
    ///     densities: Vec::new(),
    ///     layers: Vec::new(),
    ///     parts: Vec::new(),
    ///     marked: Vec::new(),
    /// };
    /// let frame = Frame {
    ///     corners: [[0.0; 3], [10.0, 10.0, 8.0]],
    ///     places: vec![Vector3::new(5.0, 5.0, 1.0)],
    ///     speeds: vec![0.5],
    ///     ..Frame::default()
    /// };
    /// let state = State::of_frame(&bodies, &frame);
    /// assert!(state.sides[0].is_periodic && state.sides[2].high == 8.0);
    /// let speed = state.columns.iter().find(|column| column.name == "speed");
    /// assert_eq!(speed.map(|speed| &speed.values), Some(&Values::Numbers(vec![0.5])));
    /// ```
    pub fn of_frame(bodies: &Bodies, frame: &Frame) -> Self {
        let count = frame.places.len();
        let side = |axis: usize| match frame.period(bodies, axis) {
            Some(length) => Side::periodic(length),
            None => {
                let [low, high] = frame.corners.map(|corner| f64::from(corner[axis]));
                Side::open(low, high)
            }
        };
        let mut columns = vec![
            Column::new("id", Values::Integers((0..count as i64).collect())),
            Column::new("radius", Values::Numbers(bodies.radii.clone())),
            Column::new(
                "speed",
                Values::Numbers(frame.speeds.iter().copied().map(f64::from).collect()),
            ),
        ];
        if !frame.velocities.is_empty() {
            let velocities = frame.velocities.iter().map(|v| v.cast()).collect();
            columns.push(Column::new("velocity", Values::Vectors(velocities)));
        }
        if !bodies.densities.is_empty() {
            let densities = Values::Numbers(bodies.densities.clone());
            columns.push(Column::new("density", densities));
        }
        if !bodies.materials.is_empty() {
            let materials = bodies.materials.iter().copied().map(i64::from).collect();
            columns.push(Column::new("material", Values::Integers(materials)));
        }
        if bodies.layers.is_empty() {
            let touching = touching(frame);
            columns.push(Column::new("coordination", Values::Integers(touching)));
        } else {
            let layers = bodies.layers.iter().copied().map(i64::from).collect();
            columns.push(Column::new("layer", Values::Integers(layers)));
            let parts = bodies.parts.iter().copied().map(i64::from).collect();
            columns.push(Column::new("part", Values::Integers(parts)));
        }
        Self {
            step: frame.step,
            time: frame.time,
            sides: [0, 1, 2].map(side),
            tilt: frame.tilt,
            places: frame.places.clone(),
            columns,
        }
    }

    /// Whole numbers of a column.
    pub(super) fn integers(&self, name: &str) -> Option<&[i64]> {
        let column = self.columns.iter().find(|column| column.name == name)?;
        match &column.values {
            Values::Integers(values) => Some(values),
            _ => None,
        }
    }
}

/// Number of contacts of each particle, walls included.
fn touching(frame: &Frame) -> Vec<i64> {
    let mut counts = vec![0; frame.places.len()];
    for contact in &frame.contacts {
        for particle in [Some(contact.a), contact.b.particle()]
            .into_iter()
            .flatten()
        {
            if let Some(count) = counts.get_mut(particle as usize) {
                *count += 1;
            }
        }
    }
    counts
}
