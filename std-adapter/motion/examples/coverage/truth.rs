//! Friction laws integrated on their own: classical Runge–Kutta steps, far finer than the samples.

/// A law with its true parameters.
#[derive(Clone, Copy, Debug)]
pub enum Truth {
    /// F_c, σ₀
    ElasticPlastic([f64; 2]),
    /// F_c, σ₀
    Dahl([f64; 2]),
    /// F_c, F_s, v_s, σ₂, σ₀, σ₁, and the break-away share; 1 is LuGre with `always`.
    Bristles([f64; 7], bool),
    /// k and f of three springs.
    Maxwell([f64; 6]),
    /// μ₀, a, b, v₀, η, d_c, and whether by the slip law.
    RateState([f64; 6], bool),
    /// The same on a spring.
    Sprung([f64; 6], bool, f64),
}

/// Largest part of a memory length in one step.
const FINE: f64 = 0.02;
/// Fewest steps between two samples.
const FEWEST: f64 = 50.0;

impl Truth {
    /// The state of steady sliding, or without a load.
    pub fn first(&self, velocity: f64, share: f64) -> [f64; 3] {
        match self {
            Self::ElasticPlastic([force, stiffness]) | Self::Dahl([force, stiffness]) => {
                [share * force / stiffness, 0.0, 0.0]
            }
            Self::Bristles([fc, _, _, _, s0, ..], _) => [share * fc / s0, 0.0, 0.0],
            Self::Maxwell([_, f1, _, f2, _, f3]) => [share * f1, share * f2, share * f3],
            Self::RateState([.., dc], _) => [libm::log(dc / velocity), 0.0, 0.0],
            Self::Sprung([mu, a, b, v0, _, dc], ..) => {
                let force = mu + (a - b) * libm::log(velocity / v0);
                [libm::log(dc / velocity), force, 0.0]
            }
        }
    }

    /// Rate of the state.
    fn rate(&self, [x, y, _]: [f64; 3], v: f64) -> [f64; 3] {
        let age = |log_age: f64, v: f64, dc: f64, slip: bool| {
            let turned = v * libm::exp(log_age) / dc;
            if slip {
                -(v / dc) * libm::log(turned)
            } else {
                libm::exp(-log_age) - v / dc
            }
        };
        match self {
            Self::Dahl([force, stiffness]) => {
                [v * (1.0 - stiffness * x * v.signum() / force), 0.0, 0.0]
            }
            Self::Bristles(p, _) => [self.bend(*p, x, v), 0.0, 0.0],
            Self::RateState([.., dc], slip) => [age(x, v, *dc, *slip), 0.0, 0.0],
            Self::Sprung([.., dc], slip, stiffness) => {
                let sliding = self.sliding(x, y);
                [age(x, sliding, *dc, *slip), stiffness * (v - sliding), 0.0]
            }
            _ => [0.0; 3],
        }
    }

    /// Speed of the contact on a spring.
    fn sliding(&self, log_age: f64, force: f64) -> f64 {
        let Self::Sprung([mu, a, b, v0, _, dc], ..) = self else {
            return f64::NAN;
        };
        v0 * libm::exp((force - mu - b * (log_age + libm::log(v0 / dc))) / a)
    }

    /// z'
    fn bend(&self, [fc, fs, vs, _, s0, _, share]: [f64; 7], z: f64, v: f64) -> f64 {
        let Self::Bristles(_, always) = self else {
            return f64::NAN;
        };
        let most = (fc + (fs - fc) * libm::exp(-(v / vs) * (v / vs))) / s0;
        let bent = z * v.signum() / most;
        let yields = if *always || bent >= 1.0 {
            1.0
        } else if bent <= share {
            0.0
        } else {
            let place = (bent - share) / (1.0 - share);
            0.5 * (1.0 - libm::cos(std::f64::consts::PI * place))
        };
        v * (1.0 - yields * bent)
    }

    /// Length over which the state changes, at a speed.
    fn length(&self, state: [f64; 3], v: f64) -> [f64; 2] {
        match self {
            Self::ElasticPlastic([force, stiffness]) | Self::Dahl([force, stiffness]) => {
                [force / stiffness, v.abs()]
            }
            Self::Bristles([fc, _, _, _, s0, ..], _) => [fc / s0, v.abs()],
            Self::Maxwell([k, f, ..]) => [f / k, v.abs()],
            Self::RateState([.., dc], _) => [*dc, v.abs()],
            Self::Sprung([_, a, _, _, _, dc], _, stiffness) => [
                dc.min(a / stiffness),
                v.abs().max(self.sliding(state[0], state[1])),
            ],
        }
    }

    /// The state after the time from `from` to `to`.
    pub fn advance(
        &self,
        state: [f64; 3],
        [from, to]: [f64; 2],
        v: impl Fn(f64) -> f64,
    ) -> [f64; 3] {
        let (mut time, mut state) = (from, state);
        while time < to {
            let coarse = (to - from) / FEWEST;
            let (now, then) = (v(time), v(time + coarse));
            let [length, speed] = self.length(state, now.abs().max(then.abs()));
            let step = coarse.min(FINE * length / speed).min(to - time);
            if time + step <= time {
                break;
            }
            state = self.step(state, step, [now, v(time + 0.5 * step), v(time + step)]);
            time += step;
        }
        state
    }

    fn step(&self, state: [f64; 3], dt: f64, [v0, v1, v2]: [f64; 3]) -> [f64; 3] {
        let clamped = |force: f64, limit: f64| force.max(-limit).min(limit);
        let slid = dt * (v0 + 4.0 * v1 + v2) / 6.0;
        match self {
            Self::ElasticPlastic([force, stiffness]) => {
                [clamped(state[0] + slid, force / stiffness), 0.0, 0.0]
            }
            Self::Maxwell(p) => {
                std::array::from_fn(|k| clamped(state[k] + p[2 * k] * slid, p[2 * k + 1]))
            }
            _ => {
                let moved =
                    |rate: [f64; 3], dt: f64| std::array::from_fn(|k| state[k] + dt * rate[k]);
                let a = self.rate(state, v0);
                let b = self.rate(moved(a, 0.5 * dt), v1);
                let c = self.rate(moved(b, 0.5 * dt), v1);
                let d = self.rate(moved(c, dt), v2);
                std::array::from_fn(|k| state[k] + dt * (a[k] + 2.0 * (b[k] + c[k]) + d[k]) / 6.0)
            }
        }
    }

    /// Friction.
    pub fn friction(&self, state: [f64; 3], v: f64) -> f64 {
        match self {
            Self::ElasticPlastic([_, stiffness]) | Self::Dahl([_, stiffness]) => {
                stiffness * state[0]
            }
            Self::Bristles(p, _) => p[4] * state[0] + p[5] * self.bend(*p, state[0], v) + p[3] * v,
            Self::Maxwell(_) => state.iter().sum(),
            Self::RateState([mu, a, b, v0, eta, dc], _) => {
                mu + a * libm::log(v / v0) + b * (state[0] + libm::log(v0 / dc)) + eta * v
            }
            Self::Sprung(..) => state[1],
        }
    }
}
