//! Shared parts of three-dimensional pictures: the view, the paper and colours.

pub(super) mod ramp;
pub(super) mod svg_canvas;
pub(super) mod view;
