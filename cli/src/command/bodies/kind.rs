//! What a sweep makes of the summaries of a kind of run.

/// A number of a summary that is averaged: its column and its place in the summary.
type Quantity = (&'static str, &'static str);

/// A column of the table for the terminal.
#[derive(Debug)]
pub struct Told {
    /// Its head.
    pub head: &'static str,
    /// Index among the quantities.
    pub quantity: usize,
    /// Factor to the unit in the head.
    pub factor: f64,
}

/// The quantities of a kind of run.
#[derive(Debug)]
pub struct Kind {
    /// All that go into the table; the first is the one drawn.
    pub quantities: &'static [Quantity],
    /// What the drawing is called, and its axis.
    pub drawn: [&'static str; 2],
    /// A word of the summary whose share is told: column, place, word.
    pub share: [&'static str; 3],
    /// For the terminal.
    pub told: &'static [Told],
}

/// Flat disks, in the units of their scene.
pub static DISK: Kind = Kind {
    quantities: &[
        ("distance", "/distance"),
        ("angle", "/angle"),
        ("end_time", "/end_time"),
        ("final_ratio", "/final_ratio"),
        ("limit_ratio", "/limit_ratio"),
        ("steps", "/steps"),
        ("initial_energy", "/initial_energy"),
        ("energy_dissipated", "/energy_dissipated"),
        ("energy_error", "/energy_error"),
    ],
    drawn: ["Distance to rest", "distance"],
    share: ["rest", "/ending", "rest"],
    told: &[
        told("distance", 0, 1.0),
        told("angle [rad]", 1, 1.0),
        told("time", 2, 1.0),
        told("final ratio", 3, 1.0),
    ],
};

/// Bodies along a path in the plane.
pub static PLANAR: Kind = Kind {
    quantities: &[
        ("curl", "/curl"),
        ("x", "/x"),
        ("path_length", "/path_length"),
        ("angle", "/angle"),
        ("end_time", "/end_time"),
        ("final_ratio", "/final_ratio"),
        ("max_lean", "/max_lean"),
        ("steps", "/steps"),
        ("initial_energy", "/initial_energy"),
        ("energy_dissipated", "/energy_dissipated"),
        ("energy_error", "/energy_error"),
    ],
    drawn: ["Curl, to the left if positive", "curl [m]"],
    share: ["rest", "/ending", "rest"],
    told: &[
        told("forward [m]", 1, 1.0),
        told("curl [m]", 0, 1.0),
        told("angle [rad]", 3, 1.0),
        told("time [s]", 4, 1.0),
    ],
};

/// Powders.
pub static POWDER: Kind = Kind {
    quantities: &[
        ("porosity_final", "/porosity_final"),
        ("porosity_bulk", "/porosity_bulk"),
        ("porosity_initial", "/porosity_initial"),
        ("particles", "/particles"),
        ("contacts", "/contacts"),
        ("coordination", "/statistics/mean_coordination"),
        ("stress_zz", "/stress_zz"),
        ("stress_zz_plus", "/stress_zz_plus"),
        ("stress_zz_minus", "/stress_zz_minus"),
        ("steps", "/steps"),
        ("iterations_total", "/iterations_total"),
        ("dissipation_normal", "/dissipation/normal"),
        ("dissipation_sliding", "/dissipation/sliding"),
        ("dissipation_rolling", "/dissipation/rolling"),
        ("dissipation_torsion", "/dissipation/torsion"),
        ("dissipation_cohesion", "/dissipation/cohesion"),
    ],
    drawn: ["Final porosity", "porosity"],
    share: ["blocked", "/ending", "blocked"],
    told: &[
        told("porosity [%]", 0, 100.0),
        told("contacts a sphere", 5, 1.0),
        told("stress_zz", 6, 1.0),
        told("plus", 7, 1.0),
        told("minus", 8, 1.0),
    ],
};

/// Tips.
pub static TIP: Kind = Kind {
    quantities: &[
        ("final_angle", "/final_angle_degrees"),
        ("driven_angle", "/driven_angle_degrees"),
        ("largest_angle", "/largest_angle_degrees"),
        ("tip_temperature", "/tip_temperature"),
    ],
    drawn: ["Angle after the drive", "final angle [degree]"],
    share: ["reversible", "/verdict", "reversible"],
    told: &[
        told("final angle [deg]", 0, 1.0),
        told("driven [deg]", 1, 1.0),
        told("largest [deg]", 2, 1.0),
        told("tip T [eps/k_B]", 3, 1.0),
    ],
};

const fn told(head: &'static str, quantity: usize, factor: f64) -> Told {
    Told {
        head,
        quantity,
        factor,
    }
}
