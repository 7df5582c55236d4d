//! One state of a run for a film.

use super::Bodies;
use super::bytes::{Source, from_upper_half, upper_half};
use crate::record::{Partner, digest};
use nalgebra::Vector3;

/// The first bytes of a frame, and the version that follows.
const MAGIC: [u8; 4] = *b"TrFr";
/// Version of a frame with speeds and normal forces alone, and of one with vectors.
const SPEEDS: u32 = 3;
const VECTORS: u32 = 4;
/// Largest encoded coordinate.
const STEPS: f64 = u16::MAX as f64;

/// A state. *Units*: those of the run.
///
/// ```
/// # use nalgebra::Vector3;
/// # use tribos::record::Partner;
/// # use tribos::record::frames::{Bodies, Frame, FrameContact, FrameFolder, ContactStateFlags, Kind};
/// # let bodies = Bodies {
/// #     kind: Kind::Powder,
/// #     scene: serde_json::json!({}),
/// #     limit: 2,
/// #     stride: 1,
/// #     sides: [10.0; 2],
/// #     periods: [Some(10.0), Some(10.0), None],
/// #     radii: vec![1.0],
/// #     materials: Vec::new(),
/// #     densities: Vec::new(),
/// #     layers: Vec::new(),
/// #     parts: Vec::new(),
/// #     marked: Vec::new(),
/// # };
/// # let home = tempfile::tempdir()?;
/// # let path = home.path().join("frames");
/// // A sphere that presses the floor, wall 0, with 0.3 and slides on it.
/// let (a, b, hold) = (0, Partner::Wall(0), ContactStateFlags::SLIDES);
/// let state = Frame {
///     corners: [[0.0; 3], [10.0; 3]],
///     places: vec![Vector3::new(5.0, 5.0, 1.0)],
///     speeds: vec![0.2],
///     contacts: vec![FrameContact { a, b, normal_force: 0.3, hold }],
///     ..Frame::default()
/// };
/// FrameFolder::begin(&path, &bodies)?.finish(&state)?;
/// let read = FrameFolder::read(&path, &bodies, 0)?;
/// assert_eq!((read.contacts[0].b, read.contacts[0].hold), (b, hold));
/// assert!((read.contacts[0].normal_force / 0.3 - 1.0).abs() <= 1.0 / 256.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Frame {
    /// Steps since the start.
    pub step: u64,
    /// Time.
    pub time: f64,
    /// Height of the piston's face, or mean height of the driven atoms.
    pub height: f64,
    /// Porosity of a powder, angle of a tip's driven layers in degrees.
    pub measure: f64,
    /// Displacement along x of the images one period higher along z, 0 unless the cell is sheared.
    pub tilt: f64,
    /// Low and high corner of the box in which positions are encoded.
    pub corners: [[f32; 3]; 2],
    /// Centres; in a file to half a 65535th of the box's sides.
    pub places: Vec<Vector3<f64>>,
    /// Speeds; in a file to 2⁻⁸ of each.
    pub speeds: Vec<f32>,
    /// Velocities; in a file to 2⁻⁸ of each component. None if only speeds are known.
    pub velocities: Vec<Vector3<f32>>,
    /// Contacts.
    pub contacts: Vec<FrameContact>,
    /// Forces across the contacts on their partners; in a file to 2⁻⁸ of each component. None if only normal forces are
    /// known.
    pub tangential: Vec<Vector3<f32>>,
}

/// A contact in a frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrameContact {
    /// A particle.
    pub a: u32,
    /// The other side of the contact.
    pub b: Partner,
    /// Normal force, positive for pressure, negative for a pull; in a file to 2⁻⁸ of it.
    pub normal_force: f32,
    /// State of the contact.
    pub hold: ContactStateFlags,
}

/// State of a contact: the modes that are at their thresholds, as bits.
///
/// ```
/// use tribos::record::frames::ContactStateFlags;
/// let turning = ContactStateFlags::of([false, true, true]); // does not slide
/// assert_eq!(turning.0, ContactStateFlags::ROLLS.0 | ContactStateFlags::SPINS.0);
/// assert_eq!(turning.0 & ContactStateFlags::SLIDES.0, 0);
/// assert_eq!(ContactStateFlags::of([false; 3]), ContactStateFlags::STICKS);
/// assert_ne!(ContactStateFlags::of([true; 3]), ContactStateFlags::OPEN);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ContactStateFlags(pub u8);

impl ContactStateFlags {
    /// No mode is at its threshold.
    pub const STICKS: Self = Self(0);
    /// The force across is at the threshold of sliding.
    pub const SLIDES: Self = Self(1);
    /// The torque across is at the threshold of rolling.
    pub const ROLLS: Self = Self(2);
    /// The torque along the normal is at the threshold of torsion.
    pub const SPINS: Self = Self(4);
    /// The contact carries nothing, or has no thresholds of its own.
    pub const OPEN: Self = Self(128);

    /// The state in which these thresholds are reached: sliding, rolling, torsion.
    pub fn of(reached: [bool; 3]) -> Self {
        let [slides, rolls, spins] = reached.map(u8::from);
        Self(slides * Self::SLIDES.0 + rolls * Self::ROLLS.0 + spins * Self::SPINS.0)
    }
}

impl Frame {
    /// Period along an axis; that of a box that has deformed is that of its corners, in single precision.
    pub fn period(&self, bodies: &Bodies, axis: usize) -> Option<f64> {
        let start = bodies.periods[axis]?;
        let [low, high] = self.corners.map(|corner| corner[axis]);
        let has_deformed = low == 0.0 && high != start as f32 && high > 0.0;
        Some(if has_deformed { high.into() } else { start })
    }

    /// The frame as the bytes of a file of this [run](Bodies::run).
    pub(super) fn bytes(&self, run: u128) -> Vec<u8> {
        let mut bytes = self.content();
        let end = seal(&bytes, run);
        bytes.extend(end);
        bytes
    }

    /// A frame from the bytes of a file of this run; `None` if they are not one, to the last bit.
    pub(super) fn parse(bytes: &[u8], run: u128) -> Option<Self> {
        let (content, end) = bytes.split_last_chunk()?;
        if seal(content, run) != *end {
            return None;
        }
        Self::of_content(content)
    }

    /// Contents of the file before its digest.
    fn content(&self) -> Vec<u8> {
        let (n, m) = (self.places.len(), self.contacts.len());
        let has_vectors = [self.velocities.len(), self.tangential.len()] == [n, m];
        let mut bytes = Vec::with_capacity(80 + 12 * n + 17 * m);
        bytes.extend(MAGIC);
        bytes.extend(if has_vectors { VECTORS } else { SPEEDS }.to_le_bytes());
        bytes.extend(self.step.to_le_bytes());
        for number in [self.time, self.height, self.measure, self.tilt] {
            bytes.extend(number.to_le_bytes());
        }
        for count in [n, m] {
            bytes.extend((count as u32).to_le_bytes());
        }
        for side in self.corners.as_flattened() {
            bytes.extend(side.to_le_bytes());
        }
        for place in &self.places {
            for axis in 0..3 {
                bytes.extend(self.count(axis, place[axis]).to_le_bytes());
            }
        }
        let numbers =
            |vectors: &[Vector3<f32>]| -> Vec<f32> { vectors.iter().flatten().copied().collect() };
        let mut put = |values: &[f32]| {
            bytes.extend(
                values
                    .iter()
                    .flat_map(|value| upper_half(*value).to_le_bytes()),
            )
        };
        if has_vectors {
            put(&numbers(&self.velocities));
        } else {
            put(&self.speeds);
        }
        let contacts = || self.contacts.iter();
        bytes.extend(contacts().flat_map(|contact| contact.a.to_le_bytes()));
        bytes.extend(contacts().flat_map(|contact| number(contact.b).to_le_bytes()));
        bytes.extend(contacts().flat_map(|contact| upper_half(contact.normal_force).to_le_bytes()));
        bytes.extend(contacts().map(|contact| contact.hold.0));
        if has_vectors {
            let tangential = numbers(&self.tangential);
            bytes.extend(
                tangential
                    .iter()
                    .flat_map(|value| upper_half(*value).to_le_bytes()),
            );
        }
        bytes
    }

    /// A frame from the contents of its file before the digest; `None` if they are invalid.
    fn of_content(bytes: &[u8]) -> Option<Self> {
        let mut source = Source(bytes);
        let (magic, version) = (source.take()?, u32::from_le_bytes(source.take()?));
        let has_vectors = version == VECTORS;
        if magic != MAGIC || !(has_vectors || version == SPEEDS) {
            return None;
        }
        let mut frame = Self {
            step: u64::from_le_bytes(source.take()?),
            time: f64::from_le_bytes(source.take()?),
            height: f64::from_le_bytes(source.take()?),
            measure: f64::from_le_bytes(source.take()?),
            tilt: f64::from_le_bytes(source.take()?),
            ..Self::default()
        };
        let n = u32::from_le_bytes(source.take()?) as usize;
        let m = u32::from_le_bytes(source.take()?) as usize;
        for side in frame.corners.as_flattened_mut() {
            *side = f32::from_le_bytes(source.take()?);
        }
        let places: Vec<[u16; 3]> = source.list(n, |[a, b, c, d, e, f]| {
            [[a, b], [c, d], [e, f]].map(u16::from_le_bytes)
        })?;
        let place = |counts: &[u16; 3]| Vector3::from_fn(|axis, _| frame.place(axis, counts[axis]));
        frame.places = places.iter().map(place).collect();
        let half = |bytes| from_upper_half(u16::from_le_bytes(bytes));
        let vector =
            |[a, b, c, d, e, f]: [u8; 6]| Vector3::new(half([a, b]), half([c, d]), half([e, f]));
        if has_vectors {
            frame.velocities = source.list(n, vector)?;
            frame.speeds = frame
                .velocities
                .iter()
                .map(|v| v.cast::<f64>().norm() as f32)
                .collect();
        } else {
            frame.speeds = source.list(n, half)?;
        }
        let a = source.list(m, u32::from_le_bytes)?;
        let b = source.list(m, u32::from_le_bytes)?;
        let forces = source.list(m, half)?;
        let holds = source.list(m, |[hold]| ContactStateFlags(hold))?;
        if has_vectors {
            frame.tangential = source.list(m, vector)?;
        }
        frame.contacts = (0..m)
            .map(|at| FrameContact {
                a: a[at],
                b: partner(b[at]),
                normal_force: forces[at],
                hold: holds[at],
            })
            .collect();
        let known = |index: u32| (index as usize) < n;
        let sound = frame
            .contacts
            .iter()
            .all(|contact| known(contact.a) && contact.b.particle().is_none_or(known));
        (source.0.is_empty() && sound).then_some(frame)
    }

    /// Encodes a coordinate.
    fn count(&self, axis: usize, place: f64) -> u16 {
        let [low, high] = self.corners.map(|corner| f64::from(corner[axis]));
        let share = (place - low) / (high - low);
        // The cast saturates: coordinates outside the box go to its side, NaN to the low side.
        (STEPS * share).round() as u16
    }

    /// Decodes a coordinate.
    fn place(&self, axis: usize, count: u16) -> f64 {
        let [low, high] = self.corners.map(|corner| f64::from(corner[axis]));
        low + (high - low) * (f64::from(count) / STEPS)
    }
}

/// The end of a file: a digest of the run and of all bytes before.
fn seal(content: &[u8], run: u128) -> [u8; 16] {
    (digest(content) ^ run).to_le_bytes()
}

/// Number of a partner: particles count from 0 up, walls from the top down.
fn number(partner: Partner) -> u32 {
    match partner {
        Partner::Particle(index) => index,
        Partner::Wall(wall) => u32::MAX - wall,
    }
}

fn partner(number: u32) -> Partner {
    if number > u32::MAX / 2 {
        Partner::Wall(u32::MAX - number)
    } else {
        Partner::Particle(number)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const RUN: u128 = 7 << 100;

    fn frame() -> Frame {
        let contact = |a, b, normal_force, hold| FrameContact {
            a,
            b,
            normal_force,
            hold,
        };
        Frame {
            step: 1 << 40,
            time: -0.1,
            height: 61.5,
            measure: f64::NAN,
            tilt: 0.1,
            corners: [[0.0, 0.0, -1.0], [20.0, 20.0, 61.5]],
            places: (0..50)
                .map(|k| Vector3::new(0.4, 0.399, 1.2) * f64::from(k))
                .collect(),
            speeds: (0..50)
                .map(|k| 1e-7 * libm::exp2f(k as f32 / 1.3))
                .collect(),
            velocities: Vec::new(),
            tangential: Vec::new(),
            contacts: vec![
                contact(0, Partner::Particle(49), 0.3, ContactStateFlags::STICKS),
                contact(
                    7,
                    Partner::Wall(1),
                    -1.25,
                    ContactStateFlags::of([true, false, true]),
                ),
            ],
        }
    }

    #[test]
    fn a_frame_reads_back_as_near_as_promised() -> Result<(), &'static str> {
        let written = frame();
        let read = Frame::parse(&written.bytes(RUN), RUN).ok_or("unread")?;
        assert_eq!(
            (read.step, read.time, read.height, read.tilt),
            (written.step, written.time, written.height, written.tilt)
        );
        assert_eq!(read.corners, written.corners);
        assert!(read.measure.is_nan());
        for (a, b) in written.places.iter().zip(&read.places) {
            for (axis, side) in [20.0, 20.0, 62.5].into_iter().enumerate() {
                assert!((a[axis] - b[axis]).abs() <= 0.5001 * side / 65535.0);
            }
        }
        for (a, b) in written.speeds.iter().zip(&read.speeds) {
            assert!((a - b).abs() <= a / 256.0);
        }
        assert_eq!(read.contacts.len(), 2);
        assert_eq!(read.contacts[0].b, Partner::Particle(49));
        assert_eq!(read.contacts[1].b, Partner::Wall(1));
        assert_eq!(read.contacts[1].hold, ContactStateFlags(5));
        assert_eq!(read.contacts[1].normal_force, -1.25);
        // Reading and writing again gives the same bytes.
        assert_eq!(read.bytes(RUN), written.bytes(RUN));
        Ok(())
    }

    /// The frame with vectors.
    fn with_vectors() -> Frame {
        let (velocity, force) = (
            Vector3::new(0.7, -1.1e-3, 0.0),
            Vector3::new(-0.01, 0.2, 3e-9),
        );
        Frame {
            velocities: vec![velocity; 50],
            tangential: vec![force; 2],
            ..frame()
        }
    }

    #[test]
    fn vectors_read_back_and_give_the_speeds() -> Result<(), &'static str> {
        let written = with_vectors();
        let read = Frame::parse(&written.bytes(RUN), RUN).ok_or("unread")?;
        for (wrote, got) in [
            (written.velocities[0], read.velocities[49]),
            (written.tangential[0], read.tangential[1]),
        ] {
            assert!(
                wrote
                    .iter()
                    .zip(&got)
                    .all(|(a, b)| (a - b).abs() <= a.abs() / 256.0)
            );
        }
        assert!((read.speeds[7] - 0.7).abs() <= 0.7 / 256.0);
        assert_eq!(read.bytes(RUN), written.bytes(RUN));
        // One vector of a pair alone is no frame with vectors.
        let torn = Frame {
            tangential: Vec::new(),
            ..written
        };
        let torn = Frame::parse(&torn.bytes(RUN), RUN).ok_or("unread")?;
        assert!(torn.velocities.is_empty() && torn.contacts.len() == 2);
        Ok(())
    }

    #[test]
    fn what_is_not_a_frame_is_refused() {
        let bytes = with_vectors().content();
        for length in 0..bytes.len() {
            assert!(Frame::of_content(&bytes[..length]).is_none(), "{length}");
        }
        let bytes = frame().content();
        for length in 0..bytes.len() {
            assert!(Frame::of_content(&bytes[..length]).is_none(), "{length}");
        }
        let mut longer = bytes.clone();
        longer.push(0);
        assert!(Frame::of_content(&longer).is_none());
        // Another format, another version, and a particle that is not there.
        let first_contact = 80 + 8 * 50;
        for at in [0, 4, first_contact] {
            let mut other = bytes.clone();
            other[at] = 77;
            assert!(Frame::of_content(&other).is_none(), "{at}");
        }
        // A count larger than memory.
        let mut huge = bytes;
        huge[48..52].fill(0xff);
        assert!(Frame::of_content(&huge).is_none());
    }

    #[test]
    fn no_bit_of_a_file_may_change_nor_its_run() {
        let bytes = frame().bytes(RUN);
        assert!(Frame::parse(&bytes, RUN).is_some());
        assert!(Frame::parse(&bytes, RUN ^ 1).is_none());
        for at in 0..bytes.len() {
            for bit in 0..8 {
                let mut other = bytes.clone();
                other[at] ^= 1 << bit;
                assert!(
                    Frame::parse(&other, RUN).is_none(),
                    "bit {bit} of byte {at}"
                );
            }
        }
    }
}
