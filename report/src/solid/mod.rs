//! Shared parts of three-dimensional pictures: the view, the paper and colours.

pub(super) mod paper;
pub(super) mod ramp;
pub(super) mod view;
