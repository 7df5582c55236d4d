//! Frames as one compressed text: numbers as differences, byte by byte in planes of their own.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use tribos::record::Partner;
use tribos::record::frames::Frame;

/// Compression level out of 10; a higher one takes longer than it saves.
const LEVEL: u8 = 6;
/// Largest encoded coordinate.
const STEPS: f64 = u16::MAX as f64;

/// The low and the high corner of the box that holds all frames.
pub(super) fn bounds(frames: &[Frame]) -> [[f64; 3]; 2] {
    let mut bounds = [[f64::INFINITY; 3], [f64::NEG_INFINITY; 3]];
    for frame in frames {
        for axis in 0..3 {
            let [low, high] = frame.corners.map(|corner| f64::from(corner[axis]));
            bounds[0][axis] = bounds[0][axis].min(low);
            bounds[1][axis] = bounds[1][axis].max(high);
        }
    }
    bounds
}

/// All frames as zlib in base64, places counted in a box: x, y and z of all frames less those of
/// the frame before, then speeds, and of the contacts a less the a before, b less a, force, hold.
pub(super) fn packed(frames: &[Frame], bounds: &[[f64; 3]; 2]) -> String {
    let mut bytes = Vec::new();
    for axis in 0..3 {
        let [low, high] = bounds.map(|corner| corner[axis]);
        let count = |place: f64| (STEPS * ((place - low) / (high - low))).round() as u16;
        let mut last: Vec<u16> = Vec::new();
        let mut differences = Vec::new();
        for frame in frames {
            let now: Vec<u16> = frame.places.iter().map(|x| count(x[axis])).collect();
            last.resize(now.len(), 0);
            let changes = now.iter().zip(&last);
            differences.extend(changes.map(|(now, last)| now.wrapping_sub(*last)));
            last = now;
        }
        planes(&mut bytes, &differences, |number| number.to_le_bytes());
    }
    let speeds: Vec<u16> = frames
        .iter()
        .flat_map(|f| &f.speeds)
        .map(|x| half(*x))
        .collect();
    planes(&mut bytes, &speeds, |number| number.to_le_bytes());

    let contacts = || frames.iter().flat_map(|frame| &frame.contacts);
    let mut last = 0;
    let mut ends = [Vec::new(), Vec::new()];
    for contact in contacts() {
        ends[0].push(contact.a.wrapping_sub(last));
        ends[1].push(number(contact.b).wrapping_sub(contact.a));
        last = contact.a;
    }
    for end in &ends {
        planes(&mut bytes, end, |number| number.to_le_bytes());
    }
    let forces: Vec<u16> = contacts()
        .map(|contact| half(contact.normal_force))
        .collect();
    planes(&mut bytes, &forces, |number| number.to_le_bytes());
    bytes.extend(contacts().map(|contact| contact.hold.0));
    STANDARD.encode(miniz_oxide::deflate::compress_to_vec_zlib(&bytes, LEVEL))
}

/// The lowest bytes of all numbers, then the next.
fn planes<T: Copy, const N: usize>(bytes: &mut Vec<u8>, numbers: &[T], of: fn(T) -> [u8; N]) {
    for plane in 0..N {
        bytes.extend(numbers.iter().map(|number| of(*number)[plane]));
    }
}

/// Upper half of a number, to which a frame's file rounds it.
fn half(value: f32) -> u16 {
    (value.to_bits() >> 16) as u16
}

/// Particles from 0 up, walls from the top down.
fn number(partner: Partner) -> u32 {
    match partner {
        Partner::Particle(index) => index,
        Partner::Wall(wall) => u32::MAX - wall,
    }
}
