//! What pictures of three dimensions share: the view, the paper they are drawn on and colours.

pub(super) mod paper;
pub(super) mod ramp;
pub(super) mod view;
