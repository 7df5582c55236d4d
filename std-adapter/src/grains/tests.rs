//! Grains do what their loads say.
