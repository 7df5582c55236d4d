//! What a run leaves in its folder, and what `tribos view` and `tribos export` add to it: names, `#`
//! for a number, and folders of frames.

/// Of a disk, and of a body that holds and slips.
pub const MOTION: &[&str] = &["summary.json", "series.csv", "motion.svg", "motion.png"];

/// Of a body in the plane.
pub const PATH: &[&str] = &["summary.json", "series.csv", "path.svg", "path.png"];

/// Of a powder or a tip under way.
pub const UNDER_WAY: &[&str] = &["checkpoint.json", "frames/"];

/// Results of a powder or of grains.
pub const POWDER: &[&str] = &[
    "summary.json",
    "series.csv",
    "series.svg",
    "series.png",
    "packing.svg",
    "packing.png",
    "initial.xyz",
    "initial.vtp",
    "initial-contacts.vtp",
    "final.xyz",
    "final.vtp",
    "final-contacts.vtp",
    "final-state.json",
];

/// Results of a gas.
pub const GAS: &[&str] = &[
    "summary.json",
    "series.csv",
    "series.svg",
    "series.png",
    "spheres.svg",
    "spheres.png",
    "final.xyz",
    "final.vtp",
];

/// Results of a tip.
pub const TIP: &[&str] = &[
    "summary.json",
    "series.csv",
    "angles.svg",
    "angles.png",
    "tip.svg",
    "tip.png",
    "initial.data",
    "final.data",
];

/// The page of `tribos view`.
pub const PAGE: &str = "view.html";

/// Whether `tribos view` or `tribos export` made a file of this name from the frames.
pub fn is_made_from_frames(name: &str) -> bool {
    name == PAGE || name.starts_with("still-") || name.starts_with("trajectory")
}
