//! Rate and state in the logarithms of speed and age, with mass or quasi-static.
//!
//! With w = ln(v/V₀), φ = ln(V₀θ/D_c) and the spring force F:
//!
//! ```text
//! m v w' = F − N μ(w, φ),    F' = k (V − v),
//! φ' = 1/θ − v/D_c  (Dieterich)   or   −(v/D_c) ln(vθ/D_c)  (Ruina)
//! ```
//!
//! Without mass the first equation is the balance F = N μ, whose derivative in time gives w':
//! μ_w w' = k (V − v)/N − μ_φ φ', with μ_w = a T + ηv, μ_φ = b T and T = v/√(v² + q²), the regularised
//! law's tanh; F is then what the law says and cannot drift.

use super::motion::{SpringIntegrator, SpringSample, spring_impulse};
use super::rosenbrock::{OdeSystem, StepSizeControl};
use crate::stick::MotionError;
use tribos_core::Real;
use tribos_core::law::{AgeingLaw, RateState, RateStateParameters, StateVariable};

/// How the age evolves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StateEvolutionKind {
    /// θ' = 1 − vθ/D_c: contacts age at rest.
    Ageing,
    /// θ' = −(vθ/D_c) ln(vθ/D_c): they change by sliding only.
    Slip,
}

/// A body under rate and state.
#[derive(Clone, Debug)]
pub(super) struct RateStateMotion {
    law: RateState<f64, AgeingLaw>,
    /// The law without its viscous term: for a small `a` a difference of slopes would lose T.
    dry: RateState<f64, AgeingLaw>,
    ages: StateEvolutionKind,
    mass: f64,
    stiffness: f64,
    load: f64,
    time: f64,
    pull: f64,
    /// w, φ, and the spring force, which counts with mass only.
    y: [f64; 3],
    pace: StepSizeControl,
    /// Speeds: of slipping, and beyond all bounds.
    slow: f64,
    runaway: f64,
}

/// Speed, in speeds of the pull, from which a motion without inertia counts as running away.
const RUNAWAY: f64 = 1e9;
/// Speed, in m/s, below which rest cannot be told from numbers that underflow: v falls as e^(−Δμ/a), to nothing where
/// `a` is a few ten-thousandths.
const SLOWEST: f64 = 1e-300;
/// Share of the shortest time scale that the first step takes.
const FIRST: f64 = 1e-3;

impl RateStateMotion {
    /// Sliding steadily with `start`, under a pull with `speed`; under a law, and the same without its viscous term.
    pub fn new(
        [law, dry]: [RateState<f64, AgeingLaw>; 2],
        ages: StateEvolutionKind,
        [mass, stiffness, load]: [f64; 3],
        [speed, start]: [f64; 2],
        tolerance: f64,
    ) -> Self {
        let p = *law.parameters();
        let log_speed = Real::ln(start / p.reference_speed);
        let friction = law.coefficient(start, law.steady_age(start));
        let force = load * friction;
        let first = FIRST * p.slip_distance / start.max(speed);
        Self {
            law,
            dry,
            ages,
            mass,
            stiffness,
            load,
            time: 0.0,
            pull: force / stiffness,
            y: [log_speed, -log_speed, force],
            pace: StepSizeControl::new(first, tolerance),
            slow: super::SLOW * speed,
            runaway: RUNAWAY * speed,
        }
    }

    fn speed_of(&self, log_speed: f64) -> f64 {
        self.law.parameters().reference_speed * Real::exp(log_speed)
    }

    fn age_of(&self, log_age: f64) -> StateVariable<f64> {
        let p = self.law.parameters();
        StateVariable {
            theta: p.slip_distance / p.reference_speed * Real::exp(log_age),
        }
    }

    fn force(&self) -> f64 {
        if self.mass > 0.0 {
            return self.y[2];
        }
        let (speed, age) = (self.speed_of(self.y[0]), self.age_of(self.y[1]));
        self.load * self.law.coefficient(speed, age)
    }

    /// φ' and its derivatives by w and φ.
    fn ageing(&self, w: f64, phi: f64) -> [f64; 3] {
        let p = self.law.parameters();
        let rate = p.reference_speed / p.slip_distance;
        let renewed = rate * Real::exp(w);
        match self.ages {
            StateEvolutionKind::Ageing => {
                let aged = rate * Real::exp(-phi);
                [aged - renewed, -renewed, -aged]
            }
            StateEvolutionKind::Slip => {
                let excess = w + phi;
                [-renewed * excess, -renewed * (excess + 1.0), -renewed]
            }
        }
    }

    /// v, T and ηv.
    fn regularised(&self, w: f64, phi: f64) -> [f64; 3] {
        let p = self.law.parameters();
        let speed = self.speed_of(w);
        let slope = self.dry.slope(speed, self.age_of(phi));
        [speed, slope * speed / p.a, p.viscous * speed]
    }
}

/// (w, φ, F) with mass.
struct Inertial<'a> {
    body: &'a RateStateMotion,
    speed: f64,
}

impl OdeSystem<3> for Inertial<'_> {
    fn rate(&self, &[w, phi, force]: &[f64; 3]) -> [f64; 3] {
        let body = self.body;
        let (speed, age) = (body.speed_of(w), body.age_of(phi));
        let friction = body.load * body.law.coefficient(speed, age);
        [
            (force - friction) / (body.mass * speed),
            body.ageing(w, phi)[0],
            body.stiffness * (self.speed - speed),
        ]
    }

    fn jacobian(&self, y: &[f64; 3]) -> [[f64; 3]; 3] {
        let (body, [w, phi, _]) = (self.body, *y);
        let p = body.law.parameters();
        let [speed, tanh, viscous] = body.regularised(w, phi);
        let momentum = body.mass * speed;
        let [_, by_speed, by_age] = body.ageing(w, phi);
        [
            [
                -body.load * (p.a * tanh + viscous) / momentum - self.rate(y)[0],
                -body.load * p.b * tanh / momentum,
                1.0 / momentum,
            ],
            [by_speed, by_age, 0.0],
            [-body.stiffness * speed, 0.0, 0.0],
        ]
    }
}

/// (w, φ) without mass.
struct QuasiStatic<'a> {
    body: &'a RateStateMotion,
    speed: f64,
}

impl QuasiStatic<'_> {
    /// w' as numerator and denominator.
    fn parts(&self, w: f64, phi: f64) -> [f64; 2] {
        let (body, p) = (self.body, self.body.law.parameters());
        let [speed, tanh, viscous] = body.regularised(w, phi);
        let drive = body.stiffness * (self.speed - speed) / body.load;
        [
            drive - p.b * tanh * body.ageing(w, phi)[0],
            p.a * tanh + viscous,
        ]
    }
}

impl OdeSystem<2> for QuasiStatic<'_> {
    fn rate(&self, &[w, phi]: &[f64; 2]) -> [f64; 2] {
        let [over, under] = self.parts(w, phi);
        [over / under, self.body.ageing(w, phi)[0]]
    }

    fn jacobian(&self, &[w, phi]: &[f64; 2]) -> [[f64; 2]; 2] {
        let (body, p) = (self.body, self.body.law.parameters());
        let [over, under] = self.parts(w, phi);
        let [speed, tanh, viscous] = body.regularised(w, phi);
        let [rate, by_speed, by_age] = body.ageing(w, phi);
        // dT/dw, and dT/dφ = (b/a) dT/dw.
        let bend = tanh * (1.0 - tanh * tanh);
        let ratio = p.b / p.a;
        let over_by_speed =
            -body.stiffness * speed / body.load - p.b * (bend * rate + tanh * by_speed);
        let over_by_age = -p.b * (bend * ratio * rate + tanh * by_age);
        let under_by_speed = p.a * bend + viscous;
        let under_by_age = p.b * bend;
        let w_rate = over / under;
        [
            [
                (over_by_speed - w_rate * under_by_speed) / under,
                (over_by_age - w_rate * under_by_age) / under,
            ],
            [by_speed, by_age],
        ]
    }
}

impl RateStateMotion {
    /// The next state and the step's length.
    fn next(&self, pace: &mut StepSizeControl, speed: f64, left: f64) -> Option<([f64; 3], f64)> {
        let body = self;
        if self.mass > 0.0 {
            let scale = [1.0, 1.0, self.load * self.law.parameters().a];
            return pace.step(&Inertial { body, speed }, &self.y, left, &scale);
        }
        let [w, phi, _] = self.y;
        let ([w, phi], step) =
            pace.step(&QuasiStatic { body, speed }, &[w, phi], left, &[1.0; 2])?;
        Some(([w, phi, 0.0], step))
    }
}

impl SpringIntegrator for RateStateMotion {
    fn moment(&self) -> SpringSample {
        let (velocity, age) = (self.speed_of(self.y[0]), self.age_of(self.y[1]));
        let force = self.force();
        SpringSample {
            time: self.time,
            pull: self.pull,
            position: self.pull - force / self.stiffness,
            velocity,
            spring_force: force,
            friction: self.load * self.law.coefficient(velocity, age),
            state: age.theta,
            slips: velocity > self.slow,
        }
    }

    fn step(&mut self, speed: f64, until: f64) -> Result<f64, MotionError> {
        let (before, left) = (self.moment(), until - self.time);
        let mut pace = self.pace.clone();
        let lost = MotionError::NotFiniteAt { time: self.time };
        let (end, step) = self.next(&mut pace, speed, left).ok_or(lost)?;
        if self.speed_of(end[0]) < SLOWEST {
            return Err(MotionError::TooSlow { time: self.time });
        }
        if self.mass > 0.0 && end[2] < 0.0 {
            return Err(MotionError::Backwards { time: self.time });
        }
        (self.y, self.pace) = (end, pace);
        self.pull += speed * step;
        self.time = if step >= left {
            until
        } else {
            self.time + step
        };
        Ok(spring_impulse(&before, &self.moment(), self.stiffness))
    }

    fn holds_exactly(&self) -> bool {
        false
    }

    fn runs_away(&self) -> bool {
        self.speed_of(self.y[0]) > self.runaway
    }
}

/// Tolerance of a measured record's steps, in ln v and ln θ.
const RECORD: f64 = 1e-7;
/// Most steps from one point of a record to the next: a slip takes some hundred.
const MOST_STEPS: u32 = 1000;

/// A contact without mass on a spring whose other end, the load point, moves as it was recorded. Forces and the
/// stiffness are per load.
#[derive(Clone, Debug)]
pub(crate) struct LoadedContact(RateStateMotion);

impl LoadedContact {
    /// Sliding steadily at a speed; `None` where the law refuses its parameters.
    pub fn new(
        parameters: RateStateParameters<f64>,
        ages: StateEvolutionKind,
        stiffness: f64,
        speed: f64,
    ) -> Option<Self> {
        let law = RateState::new(parameters).ok()?;
        let dry = RateState::new(RateStateParameters {
            viscous: 0.0,
            ..parameters
        });
        let springs = [0.0, stiffness, 1.0];
        let motion = RateStateMotion::new([law, dry.ok()?], ages, springs, [speed, speed], RECORD);
        Some(Self(motion))
    }

    /// Moves the load point for a while at a speed; `None` where the motion cannot be followed.
    pub fn advance(&mut self, speed: f64, duration: f64) -> Option<()> {
        let until = self.0.time + duration;
        for _ in 0..MOST_STEPS {
            if self.0.time >= until {
                return Some(());
            }
            self.0.step(speed, until).ok()?;
            if self.0.runs_away() {
                return None;
            }
        }
        None
    }

    /// Friction per load.
    pub fn friction(&self) -> f64 {
        self.0.force()
    }
}
