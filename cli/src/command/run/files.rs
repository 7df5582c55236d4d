//! What a run leaves in its folder, and what `tribos view` and `tribos export` add to it: names, `#`
//! for a number, and folders of frames.

/// Of a disk.
pub const DISK: &[&str] = &[
    "summary.json",
    "series.csv",
    "motion.svg",
    "motion.png",
    "view.html",
    "trajectory.pvd",
    "trajectory/#.vtp",
    "trajectory.xyz",
    "trajectory.dump",
];

/// Of a body in the plane.
pub const PATH: &[&str] = &[
    "summary.json",
    "series.csv",
    "path.svg",
    "path.png",
    "view.html",
    "trajectory.pvd",
    "trajectory/#.vtp",
    "trajectory.xyz",
    "trajectory.dump",
];

/// Of a powder.
pub const POWDER: &[&str] = &[
    "summary.json",
    "checkpoint.json",
    "frames/",
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
    "still-#.png",
    "view.html",
    "trajectory.pvd",
    "trajectory/#.vtp",
    "trajectory.xyz",
    "trajectory.dump",
];

/// Of a tip.
pub const TIP: &[&str] = &[
    "summary.json",
    "checkpoint.json",
    "frames/",
    "series.csv",
    "angles.svg",
    "angles.png",
    "tip.svg",
    "tip.png",
    "initial.data",
    "final.data",
    "still-#.png",
    "view.html",
    "trajectory.pvd",
    "trajectory/#.vtp",
    "trajectory.xyz",
    "trajectory.dump",
];
