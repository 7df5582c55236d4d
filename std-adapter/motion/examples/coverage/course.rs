//! Velocities as exact functions of time.

use tribos_base::random::Random;

/// From `low` to `high`, evenly in the logarithm.
pub fn log_uniform(random: &mut Random, [low, high]: [f64; 2]) -> f64 {
    low * libm::pow(high / low, random.unit())
}

/// From `low` to `high`.
pub fn uniform(random: &mut Random, [low, high]: [f64; 2]) -> f64 {
    low + (high - low) * random.unit()
}

/// A normal deviate by the polar method of Marsaglia and Bray (1964).
pub fn normal(random: &mut Random) -> f64 {
    loop {
        let [x, y] = [(); 2].map(|()| 2.0 * random.unit() - 1.0);
        let square: f64 = x * x + y * y;
        if square > 0.0 && square < 1.0 {
            return x * (-2.0 * libm::log(square) / square).sqrt();
        }
    }
}

/// The velocity of a record; times are in cycles, velocities in shares of the largest.
#[derive(Debug)]
pub enum VelocityCourse {
    /// One sine, with a phase in radians.
    Sine(f64),
    /// Three sines: their shares, frequencies and phases.
    Sines([[f64; 3]; 3]),
    /// Straight lines to and fro.
    Triangle,
    /// A sine whose frequency grows from `1` by this factor in `over` cycles.
    Chirp { growth: f64, over: f64 },
    /// Levels that begin at these times; a ramp between two takes `ramp`.
    Levels {
        begins: Vec<f64>,
        levels: Vec<f64>,
        ramp: f64,
    },
    /// The exponential of a sine, from `low` to 1.
    Waves { low: f64 },
}

const TURN: f64 = std::f64::consts::TAU;

impl VelocityCourse {
    /// To and fro.
    pub fn both_ways(random: &mut Random, cycles: f64) -> Self {
        match (5.0 * random.unit()) as u32 {
            0 => Self::Sine(TURN * random.unit()),
            1 => Self::Sines(std::array::from_fn(|k| {
                let frequency = [0.4, 1.0, 2.3][k] * uniform(random, [0.8, 1.2]);
                [
                    uniform(random, [0.2, 0.33]),
                    frequency,
                    TURN * random.unit(),
                ]
            })),
            2 => Self::Triangle,
            3 => Self::Chirp {
                growth: uniform(random, [2.0, 5.0]),
                over: cycles,
            },
            _ => {
                let mut sign = 1.0;
                let mut level = || {
                    sign = -sign;
                    sign * log_uniform(random, [0.02, 1.0])
                };
                let count = (2.0 * cycles).ceil() as usize + 1;
                let levels = (0..count).map(|_| level()).collect();
                let begins = (0..count).map(|k| 0.5 * k as f64).collect();
                Self::Levels {
                    begins,
                    levels,
                    ramp: uniform(random, [0.02, 0.2]),
                }
            }
        }
    }

    /// Forward only, over a range of speeds, each of which is held for a while at least.
    pub fn forward(random: &mut Random, cycles: f64, hold: f64) -> Self {
        let low = log_uniform(random, [0.005, 0.2]);
        if random.unit() < 0.4 {
            return Self::Waves { low };
        }
        // Each level goes on for the same distance.
        let (mut begins, mut levels, mut time, mut high) = (Vec::new(), Vec::new(), 0.0, false);
        let step = 1.0 / low;
        while time < cycles && levels.len() < 10_000 {
            begins.push(time);
            let level = if high {
                low * step
            } else {
                low * uniform(random, [1.0, 3.0]).min(step)
            };
            levels.push(level);
            let share = if levels.len() == 1 { 0.2 } else { 1.0 };
            time += 0.5 * low / level * share + hold;
            high = !high;
        }
        let ramp = if random.unit() < 0.5 { 0.0 } else { 0.01 };
        Self::Levels {
            begins,
            levels,
            ramp,
        }
    }

    /// Velocity at a time.
    pub fn velocity(&self, time: f64) -> f64 {
        match self {
            Self::Sine(phase) => libm::sin(TURN * time + phase),
            Self::Sines(all) => {
                let wave = |[share, frequency, phase]: &[f64; 3]| {
                    share * libm::sin(TURN * frequency * time + phase)
                };
                all.iter().map(wave).sum()
            }
            Self::Triangle => {
                let place = (time + 0.25).fract();
                if place < 0.5 {
                    4.0 * place - 1.0
                } else {
                    3.0 - 4.0 * place
                }
            }
            Self::Chirp { growth, over } => {
                let rate = (growth - 1.0) / over;
                libm::sin(TURN * time * (1.0 + 0.5 * rate * time))
            }
            Self::Levels {
                begins,
                levels,
                ramp,
            } => {
                let here = begins.partition_point(|begin| *begin <= time).max(1) - 1;
                let before = levels[here.max(1) - 1];
                let since = time - begins[here];
                if since >= *ramp {
                    return levels[here];
                }
                before + (levels[here] - before) * since / ramp
            }
            Self::Waves { low } => {
                let wave = 0.5 * (1.0 + libm::sin(TURN * time - 0.25 * TURN));
                libm::pow(*low, 1.0 - wave)
            }
        }
    }
}
