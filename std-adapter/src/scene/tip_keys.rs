//! The vocabulary of a tip's scene.

use super::key::{Domain, Key};
use super::slider::key;

const HALF_TURN: Domain = Domain::Between {
    above: -180.0,
    up_to: 180.0,
};

pub(super) const LAMBDA: Key = key(
    "lambda",
    "eps/sigma^2",
    "drive: force on each driven atom, see `reading`",
    Domain::Finite,
);
pub(super) const READING: Key = key(
    "reading",
    "-",
    "lambda is the force at a distance of sigma from the axis, or the mean or the largest force \
     (default angular)",
    Domain::OneOf(&["angular", "mean", "largest"]),
);
pub(super) const SPACING: Key = key(
    "spacing",
    "sigma",
    "distance of neighbours in the crystal (default 2^(1/6) = 1.1225)",
    Domain::Between {
        above: 0.5,
        up_to: 2.0,
    },
);
pub(super) const COLUMNS: Key = key(
    "columns",
    "-",
    "atoms along x in a layer of the substrate, periodic (default 28)",
    Domain::Count { up_to: 1000.0 },
);
pub(super) const ROWS: Key = key(
    "rows",
    "-",
    "rows of atoms along y, an even number, periodic (default 28)",
    Domain::Count { up_to: 1000.0 },
);
pub(super) const SUBSTRATE_LAYERS: Key = key(
    "substrate_layers",
    "-",
    "two frozen, two with a thermostat, the rest free; at least 4 (default 6)",
    Domain::Count { up_to: 100.0 },
);
pub(super) const TIP_LAYERS: Key = key(
    "tip_layers",
    "-",
    "two driven, two with a thermostat, the rest free; at least 4 (default 6)",
    Domain::Count { up_to: 100.0 },
);
pub(super) const SIDE: Key = key(
    "side",
    "-",
    "atoms on a side of the tip's top layer (default 10)",
    Domain::Count { up_to: 300.0 },
);
pub(super) const OUTLINE: Key = key(
    "outline",
    "-",
    "of the tip's layers (default hexagon)",
    Domain::OneOf(&["hexagon", "disk", "cone"]),
);
pub(super) const ORIENTATION: Key = key(
    "orientation",
    "degree",
    "angle by which the tip is turned out of registry (default 0)",
    HALF_TURN,
);
pub(super) const RAISE: Key = key(
    "raise",
    "sigma",
    "how much higher than in the crystal the driven layers stand (default 0)",
    Domain::Finite,
);
pub(super) const HOLD: Key = key(
    "hold",
    "-",
    "driven layers: z of each atom fixed, or z common and free under `load` (default plane)",
    Domain::OneOf(&["plane", "level"]),
);
pub(super) const LOAD: Key = key(
    "load",
    "eps/sigma",
    "force on each driven atom towards the substrate, with hold = \"level\" (default 0)",
    Domain::Finite,
);
pub(super) const CUTOFF: Key = key(
    "cutoff",
    "sigma",
    "of the Lennard-Jones potential (default 2.5)",
    Domain::Between {
        above: 1.0,
        up_to: 10.0,
    },
);
pub(super) const SHIFT: Key = key(
    "shift",
    "-",
    "what is done at the cut-off (default none)",
    Domain::OneOf(&["none", "energy", "force"]),
);
pub(super) const ADHESION: Key = key(
    "adhesion",
    "eps",
    "depth of the potential between tip and substrate (default 1)",
    Domain::Positive,
);
pub(super) const TEMPERATURE: Key = key(
    "temperature",
    "eps/k_B",
    "of the thermostats (default 0.1)",
    Domain::NotNegative,
);
pub(super) const THERMOSTAT: Key = key(
    "thermostat",
    "-",
    "of the bath layers (default nose-hoover)",
    Domain::OneOf(&["nose-hoover", "langevin", "none"]),
);
pub(super) const RELAXATION: Key = key(
    "relaxation",
    "tau",
    "time of the Nose-Hoover thermostat (default 0.5)",
    Domain::Positive,
);
pub(super) const FRICTION: Key = key(
    "friction",
    "1/tau",
    "rate of the Langevin thermostat (default 1)",
    Domain::Positive,
);
pub(super) const SPIN: Key = key(
    "spin",
    "-",
    "whether the tip's common rotation is heat for its Nose-Hoover thermostat (default spared)",
    Domain::OneOf(&["spared", "counts"]),
);
pub(super) const DAMPING: Key = key(
    "damping",
    "1/tau",
    "force -gamma m v on driven atoms: gamma (default 0.1)",
    Domain::NotNegative,
);
pub(super) const EQUILIBRATION: Key = key(
    "equilibration",
    "tau",
    "time before the drive is switched on (default 50)",
    Domain::NotNegative,
);
pub(super) const DRIVE: Key = key(
    "drive_time",
    "tau",
    "time that the drive lasts (default 200)",
    Domain::NotNegative,
);
pub(super) const REST: Key = key(
    "rest_time",
    "tau",
    "time after it (default 100)",
    Domain::NotNegative,
);
pub(super) const TIME_STEP: Key = key(
    "time_step",
    "tau",
    "of the integrator (default 0.005)",
    Domain::Between {
        above: 0.0,
        up_to: 0.05,
    },
);
pub(super) const INTEGRATOR: Key = key(
    "integrator",
    "-",
    "which velocities are kept (default leap-frog)",
    Domain::OneOf(&["leap-frog", "velocity-verlet"]),
);
pub(super) const SKIN: Key = key(
    "skin",
    "sigma",
    "how much farther lists of neighbours reach than the cut-off (default 0.3)",
    Domain::Positive,
);
pub(super) const SEED: Key = key(
    "seed",
    "-",
    "of the first velocities and of noise (default 1)",
    Domain::Count {
        up_to: 9_007_199_254_740_992.0,
    },
);
pub(super) const SAMPLES: Key = key(
    "samples",
    "-",
    "steps from one line of the series to the next (default 100)",
    Domain::Count { up_to: 1e9 },
);
