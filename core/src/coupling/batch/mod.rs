//! Many speeds under one coupling, in groups of eight: side by side where the processor has vectors.
//!
//! The scalar functions are the definition. Where the target has vectors whose roots and quotients
//! round as the scalar ones do, a fitted form or a table computes a group of ordinary speeds in lanes, to the
//! same bits; a group with a lane out of the ordinary goes to the scalar function as a whole, and so does
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

pub(super) use ways::{drags, jacobians, patch_jacobians, patch_wrenches, wrenches};

use super::{ReducedFriction, ReducedJacobian, ReducedWrench};
use crate::lanes::{GROUP, Group};
use crate::real::Real;
use crate::twist::{Twist, Wrench};

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
    let (inputs, last_inputs) = groups(inputs, count);
    let (outputs, last_outputs) = groups_mut(outputs, count);
    for (inputs, outputs) in inputs.iter().zip(outputs) {
        match all(inputs) {
            Some(group) => *outputs = group,
            None => singly(inputs, outputs, &one),
        }
    }
    singly(last_inputs, last_outputs, &one);
}

/// The first `count` of a slice, in groups, and what remains.
#[inline(always)]
fn groups<T>(of: &[T], count: usize) -> (&[Group<T>], &[T]) {
    of.get(..count).unwrap_or(of).as_chunks()
}

/// [`groups`] to write to.
#[inline(always)]
fn groups_mut<T>(of: &mut [T], count: usize) -> (&mut [Group<T>], &mut [T]) {
    of.get_mut(..count).unwrap_or_default().as_chunks_mut()
}

/// Force and torque of slide and rim.
#[inline(always)]
pub(super) fn reduced_wrenches<R: Real, C: ReducedFriction<R> + ?Sized>(
    coupling: &C,
    [slides, rims]: [&[R]; 2],
    [forces, torques]: [&mut [R]; 2],
) {
    let inputs = slides.len().min(rims.len());
    let count = inputs.min(forces.len()).min(torques.len());
    let ([slides, rims], [forces, torques]) = (
        [slides, rims].map(|speeds| groups(speeds, count)),
        [forces, torques].map(|results| groups_mut(results, count)),
    );
    let singly = |[slides, rims]: [&[R]; 2], [forces, torques]: [&mut [R]; 2]| {
        let results = forces.iter_mut().zip(torques);
        for ((&slide, &rim), (f, t)) in slides.iter().zip(rims).zip(results) {
            let ReducedWrench { force, torque } = coupling.reduced_wrench(slide, rim);
            (*f, *t) = (force, torque);
        }
    };
    let results = forces.0.iter_mut().zip(torques.0);
    for ((slides, rims), (forces, torques)) in slides.0.iter().zip(rims.0).zip(results) {
        match coupling.reduced_wrenches(slides, rims) {
            Some(group) => [*forces, *torques] = group,
            None => singly([slides, rims], [forces, torques]),
        }
    }
    singly([slides.1, rims.1], [forces.1, torques.1]);
}

/// Wrenches of twists, eight of them at once by `all`, else one by one.
#[inline(always)]
pub(super) fn twist_wrenches<R: Real>(
    twists: &[Twist<R>],
    wrenches: &mut [Wrench<R>],
    all: impl Fn([&Group<R>; 3]) -> Option<[Group<R>; 3]>,
    one: impl Fn(&Twist<R>) -> Wrench<R>,
) {
    let side_by_side = |twists: &Group<Twist<R>>| {
        let x = twists.each_ref().map(|twist| twist.velocity.x);
        let y = twists.each_ref().map(|twist| twist.velocity.y);
        let spin = twists.each_ref().map(|twist| twist.spin);
        let [x, y, torque] = all([&x, &y, &spin])?;
        let mut wrenches = [Wrench::ZERO; GROUP];
        for (((wrench, x), y), torque) in wrenches.iter_mut().zip(x).zip(y).zip(torque) {
            *wrench = Wrench::new(x, y, torque);
        }
        Some(wrenches)
    };
    each(twists, wrenches, side_by_side, one);
}

/// [`twist_wrenches`] where each component of twists and wrenches has a slice of its own.
#[inline(always)]
pub(super) fn component_wrenches<R: Real>(
    twists: [&[R]; 3],
    wrenches: [&mut [R]; 3],
    all: impl Fn([&Group<R>; 3]) -> Option<[Group<R>; 3]>,
    one: impl Fn(&Twist<R>) -> Wrench<R>,
) {
    let shortest = |count: usize, length: usize| count.min(length);
    let count = twists
        .iter()
        .map(|slice| slice.len())
        .fold(usize::MAX, shortest);
    let count = wrenches
        .iter()
        .map(|slice| slice.len())
        .fold(count, shortest);
    let singly = |[vx, vy, spin]: [&[R]; 3], [fx, fy, torque]: [&mut [R]; 3]| {
        let results = fx.iter_mut().zip(fy).zip(torque);
        for (((&vx, &vy), &spin), ((fx, fy), torque)) in vx.iter().zip(vy).zip(spin).zip(results) {
            let wrench = one(&Twist::new(vx, vy, spin));
            (*fx, *fy, *torque) = (wrench.force.x, wrench.force.y, wrench.torque);
        }
    };
    let [vx, vy, spin] = twists.map(|slice| groups(slice, count));
    let [fx, fy, torque] = wrenches.map(|slice| groups_mut(slice, count));
    let results = fx.0.iter_mut().zip(fy.0).zip(torque.0);
    for (((vx, vy), spin), ((fx, fy), torque)) in vx.0.iter().zip(vy.0).zip(spin.0).zip(results) {
        match all([vx, vy, spin]) {
            Some(group) => [*fx, *fy, *torque] = group,
            None => singly([vx, vy, spin], [fx, fy, torque]),
        }
    }
    singly([vx.1, vy.1, spin.1], [fx.1, fy.1, torque.1]);
}

/// Jacobians of slide and rim.
#[inline(always)]
pub(super) fn reduced_jacobians<R: Real, C: ReducedFriction<R> + ?Sized>(
    coupling: &C,
    [slides, rims]: [&[R]; 2],
    jacobians: &mut [ReducedJacobian<R>],
) {
    let count = slides.len().min(rims.len()).min(jacobians.len());
    let [slides, rims] = [slides, rims].map(|speeds| groups(speeds, count));
    let jacobians = groups_mut(jacobians, count);
    let singly = |[slides, rims]: [&[R]; 2], jacobians: &mut [ReducedJacobian<R>]| {
        for ((&slide, &rim), jacobian) in slides.iter().zip(rims).zip(jacobians) {
            *jacobian = coupling.reduced_jacobian(slide, rim);
        }
    };
    for ((slides, rims), jacobians) in slides.0.iter().zip(rims.0).zip(jacobians.0) {
        let Some([a, b, c, d]) = coupling.reduced_jacobians(slides, rims) else {
            singly([slides, rims], jacobians);
            continue;
        };
        let entries = a.iter().zip(b).zip(c).zip(d);
        for (jacobian, (((&force_per_slide, force_slide), mixed), torque_rim)) in
            jacobians.iter_mut().zip(entries)
        {
            *jacobian = ReducedJacobian {
                force_per_slide,
                force_slide,
                mixed,
                torque_rim,
            };
        }
    }
    singly([slides.1, rims.1], jacobians.1);
}

#[inline]
fn singly<I, O>(inputs: &[I], outputs: &mut [O], one: &impl Fn(&I) -> O) {
    for (input, output) in inputs.iter().zip(outputs) {
        *output = one(input);
    }
}
