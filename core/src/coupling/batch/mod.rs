//! Many speeds under one coupling, in groups of eight: side by side where the processor has vectors.
//!
//! The scalar functions are the definition. Where the target has vectors whose roots and quotients
//! round as the scalar ones do, a table computes a group of ordinary speeds in lanes, to the same
//! bits; a group with a lane out of the ordinary goes to the scalar function as a whole, and so does
//! every group elsewhere.

#[cfg(any(
    target_feature = "sse2",
    all(target_arch = "aarch64", target_feature = "neon"),
    target_feature = "simd128"
))]
#[path = "lanes/mod.rs"]
mod ways;
#[cfg(not(any(
    target_feature = "sse2",
    all(target_arch = "aarch64", target_feature = "neon"),
    target_feature = "simd128"
)))]
#[path = "alone.rs"]
mod ways;

pub(crate) use ways::LaneProfile;
pub use ways::Laned;
pub(super) use ways::{drags, jacobians, patch_jacobians, patch_wrenches, wrenches};

/// Speeds in a group.
pub const GROUP: usize = 8;

/// One value for each speed of a group.
pub type Group<T> = [T; GROUP];

/// Calls `all` with each group of inputs and of outputs; where it answers no outputs, and for what
/// remains of the slices, each output is `one` of its input. Elements beyond the shorter slice are
/// not changed.
#[inline(always)]
pub(super) fn each<I, O>(
    inputs: &[I],
    outputs: &mut [O],
    all: impl Fn(&Group<I>) -> Option<Group<O>>,
    one: impl Fn(&I) -> O,
) {
    let count = inputs.len().min(outputs.len());
    let inputs = inputs.get(..count).unwrap_or(inputs);
    let outputs = outputs.get_mut(..count).unwrap_or_default();
    let (inputs, last_inputs) = inputs.as_chunks::<GROUP>();
    let (outputs, last_outputs) = outputs.as_chunks_mut::<GROUP>();
    for (inputs, outputs) in inputs.iter().zip(outputs) {
        match all(inputs) {
            Some(group) => *outputs = group,
            None => singly(inputs, outputs, &one),
        }
    }
    singly(last_inputs, last_outputs, &one);
}

#[inline]
fn singly<I, O>(inputs: &[I], outputs: &mut [O], one: &impl Fn(&I) -> O) {
    for (input, output) in inputs.iter().zip(outputs) {
        *output = one(input);
    }
}
