//! The vocabulary of a powder's scene.

use super::key::{Domain, Key};
use super::slider::key;

pub(super) const WIDTH: Key = key(
    "width",
    "R",
    "side of the square base, periodic in x and y",
    Domain::Positive,
);
pub(super) const HEIGHT: Key = key(
    "height",
    "R",
    "cut of the deposit, where the piston starts; or give `count`",
    Domain::Positive,
);
pub(super) const COUNT: Key = key(
    "count",
    "-",
    "number of spheres, in place of `height`",
    Domain::Count { up_to: 1e6 },
);
pub(super) const CAPTURE: Key = key(
    "capture_radius",
    "R",
    "distance of centres at which a falling sphere is captured (default 3)",
    Domain::Positive,
);
pub(super) const SPREAD: Key = key(
    "radius_spread",
    "R",
    "radii uniform from 1 - spread to 1 + spread (default 0)",
    Domain::NotNegative,
);
pub(super) const SEED: Key = key(
    "seed",
    "-",
    "of the deposit's random numbers (default 1)",
    // What f64 counts.
    Domain::Count {
        up_to: 9_007_199_254_740_992.0,
    },
);
pub(super) const SLIDING: Key = key(
    "sliding",
    "-",
    "mu: sliding force over P = F_n + F_coh (default 0.3)",
    Domain::NotNegative,
);
pub(super) const ROLLING: Key = key(
    "rolling",
    "-",
    "mu_t: rolling torque over P r_eff (default 0)",
    Domain::NotNegative,
);
pub(super) const TORSION: Key = key(
    "torsion",
    "-",
    "mu_n: torsion torque over P r_eff (default 0)",
    Domain::NotNegative,
);
pub(super) const COUPLING: Key = key(
    "coupling",
    "-",
    "of the thresholds of sliding and torsion (default independent)",
    Domain::OneOf(&["independent", "ellipsoid", "exact"]),
);
pub(super) const PRESSURE: Key = key(
    "pressure",
    "F_coh/R^2",
    "on the piston (default 0.0025)",
    Domain::Positive,
);
pub(super) const RANGE: Key = key(
    "cohesion_range",
    "R",
    "d_c: cohesion acts up to this gap (default 0.01)",
    Domain::NotNegative,
);
pub(super) const ATTRACTION: Key = key(
    "attraction",
    "-",
    "cohesion at a gap: a constant pull, or a resistance to opening (default pull)",
    Domain::OneOf(&["pull", "resistance"]),
);
pub(super) const RESTITUTION: Key = key(
    "restitution",
    "-",
    "speed after an impact over speed before, at walls too (default 0)",
    Domain::Fraction,
);
pub(super) const WALL: Key = key(
    "wall",
    "-",
    "substrate and piston: law of spheres, cohesion only, neither (default full)",
    Domain::OneOf(&["full", "smooth", "none"]),
);
pub(super) const MASS: Key = key(
    "piston_mass",
    "rho R^3",
    "mass of the piston (default 1000)",
    Domain::Positive,
);
pub(super) const SOLVER: Key = key(
    "solver",
    "-",
    "method for the contacts of a step (default accelerated)",
    Domain::OneOf(&["accelerated", "gauss-seidel"]),
);
pub(super) const ORDER: Key = key(
    "order",
    "-",
    "gauss-seidel: order of the contacts in a sweep (default alternating)",
    Domain::OneOf(&["alternating", "fixed", "random"]),
);
pub(super) const STOP: Key = key(
    "stop",
    "-",
    "gauss-seidel: after `sweeps`, or by change of any or of all contacts (default global)",
    Domain::OneOf(&["global", "local", "fixed"]),
);
pub(super) const TOLERANCE: Key = key(
    "tolerance",
    "-",
    "change of a sweep, relative to P, at which sweeps stop (default 1e-4)",
    Domain::Between {
        above: 0.0,
        up_to: 1.0,
    },
);
pub(super) const SWEEPS: Key = key(
    "sweeps",
    "-",
    "N_I: most sweeps a step; all of them with stop = \"fixed\" (default 1000)",
    Domain::Count { up_to: 1e6 },
);
pub(super) const WARM_START: Key = key(
    "warm_start",
    "-",
    "whether a step starts from the forces of the last one (default on)",
    Domain::OneOf(&["on", "off"]),
);
pub(super) const MOTION: Key = key(
    "motion",
    "R",
    "farthest that a sphere may move in a step (default 0.05)",
    Domain::Between {
        above: 0.0,
        up_to: 0.5,
    },
);
pub(super) const TIME_STEP: Key = key(
    "time_step",
    "sqrt(rho R^4/F_coh)",
    "longest step (default 0.2)",
    Domain::Positive,
);
pub(super) const STILL: Key = key(
    "still_speed",
    "sqrt(F_coh/rho)/R",
    "slower groups that nothing touches are left alone (default 1e-7; 0 never)",
    Domain::NotNegative,
);
pub(super) const BLOCKED: Key = key(
    "blocked",
    "-",
    "the end: forces balance and the piston stands, or it stands (default balance)",
    Domain::OneOf(&["balance", "piston"]),
);
pub(super) const STEPS: Key = key(
    "steps",
    "-",
    "end of the run if it is not blocked before (default 200000)",
    Domain::Count { up_to: 1e9 },
);
pub(super) const DURATION: Key = key(
    "duration",
    "sqrt(rho R^4/F_coh)",
    "the same as a time (default: none)",
    Domain::Positive,
);
pub(super) const SAMPLES: Key = key(
    "samples",
    "-",
    "steps from one line of the series to the next (default 20)",
    Domain::Count { up_to: 1e9 },
);
