//! Bodies that friction holds: published complaints about simulators in which they creep.
//!
//! Loads are those of the reports where they give them; patches and bonds are ours.

use tribos_core::contact::TimeStep;
use tribos_core::coupling::coulomb::CoulombDisk;
use tribos_core::limit_surface::{FrictionSet, RoundLimitSurface, ShapeLimitSurface};
use tribos_core::patch::bar::Bar;
use tribos_core::patch::nodes::{Node, Nodes};
use tribos_core::patch::outline::Polygon;
use tribos_core::patch::points::PointPatch;
use tribos_core::planar::{ElasticState, PlanarBody};
use tribos_core::presliding::{Pose, Presliding};
use tribos_core::real::Real;
use tribos_core::twist::Wrench;

const GRAVITY: f64 = 9.81;
/// Displacement at which bonds break under a straight pull, in m.
pub const BREAK: f64 = 1e-5;
/// Time constant with which a load approaches its end, and time until it is there, in s. No inertia
/// carries the body beyond the place where it will rest.
const RAMP: f64 = 0.1;
const SETTLE: f64 = 6.0;
/// Period of a cyclic load in s.
const PERIOD: f64 = 1.0;

/// A set that is chosen at run time.
pub type Set<R> = Box<dyn FrictionSet<R> + Send + Sync>;

/// A body, what it stands on, and what pulls.
#[expect(
    missing_debug_implementations,
    reason = "a set chosen at run time has none"
)]
pub struct Case<R: Real> {
    /// What it is, and where it was published.
    pub name: &'static str,
    body: PlanarBody<R>,
    bonds: Presliding<R>,
    /// All that friction carries.
    pub set: Set<R>,
    /// The load; the amplitude of a cyclic one.
    pub push: Wrench<R>,
    /// Whether the torque of the load is cyclic.
    pub is_cyclic: bool,
}

/// How a load was held.
#[derive(Clone, Copy, Debug)]
pub struct HeldLoad<R> {
    /// Displacement when it had settled, in m.
    pub elastic: R,
    /// Change of position and angle since, at the same phase of a cyclic load, in m and rad.
    pub drift: [R; 2],
    /// Whether the anchor of the bonds kept its bits from the first step on.
    pub anchored: bool,
}

/// Masses, sets and loads of a case in f64.
struct Plan {
    name: &'static str,
    mass: f64,
    /// Radius of gyration in m.
    gyration: f64,
    push: [f64; 3],
    is_cyclic: bool,
}

impl<R: Real> Case<R> {
    fn new(plan: &Plan, set: Set<R>) -> Self {
        let number = R::from_f64;
        let (mass, lever) = (plan.mass, plan.gyration);
        // Critically damped.
        let stiffness = set.force_limit().to_f64() / BREAK;
        let damping = 2.0 * (stiffness * mass).sqrt();
        let [k, c] = [stiffness, damping].map(|k| [number(k), number(k * lever * lever)]);
        let [x, y, torque] = plan.push.map(number);
        Self {
            name: plan.name,
            body: PlanarBody::new(number(mass), number(mass * lever * lever)).expect("a mass"),
            bonds: Presliding::new(k[0], k[1])
                .and_then(|bonds| bonds.with_damping(c[0], c[1]))
                .expect("bonds"),
            set,
            push: Wrench::new(x, y, torque),
            is_cyclic: plan.is_cyclic,
        }
    }

    /// The factor by which the load may grow.
    pub fn margin(&self) -> R {
        R::ONE / self.set.gauge(&self.push)
    }

    /// Loads the body slowly, lets it settle and follows it for `steps`.
    pub fn held(&self, dt: R, steps: u64) -> HeldLoad<R> {
        let time_step = TimeStep::new(dt).expect("a step");
        let count = |time: f64| (R::from_f64(time) / dt).to_f64().round() as u64;
        let (ramp, settle, period) = (count(RAMP), count(SETTLE), count(PERIOD));
        let start = ElasticState::at_rest(Pose::new(R::ZERO, R::ZERO, R::ZERO));
        let mut state = start;
        let mut settled = start;
        // Whole periods.
        let settle = settle.div_ceil(period) * period;
        let steps = if self.is_cyclic {
            steps.div_ceil(period) * period
        } else {
            steps
        };
        for step in 0..settle + steps {
            let mut push = self.push * share(step, ramp);
            if self.is_cyclic {
                let turns = R::from_f64((step % period) as f64 / period as f64);
                push.torque *= (R::from_f64(core::f64::consts::TAU) * turns).sin();
            }
            let moved = self
                .body
                .step_elastic(&self.bonds, &*self.set, &state, &push, time_step);
            state = moved.state;
            if step + 1 == settle {
                settled = state;
            }
        }
        let crept = state.pose.since(&settled.pose);
        HeldLoad {
            elastic: settled.pose.position.x.hypot(settled.pose.position.y),
            drift: [crept.shift.x.hypot(crept.shift.y), crept.turn.abs()],
            anchored: state.anchor == start.anchor,
        }
    }

    /// Whether bonds break under `scale` times the load, which grows slowly and then stays.
    pub fn is_released(&self, scale: R, dt: R) -> bool {
        let time_step = TimeStep::new(dt).expect("a step");
        let count = |time: f64| (R::from_f64(time) / dt).to_f64().round() as u64;
        let start = ElasticState::at_rest(Pose::new(R::ZERO, R::ZERO, R::ZERO));
        let mut state = start;
        let ramp = count(RAMP);
        for step in 0..count(SETTLE) {
            let push = self.push * (scale * share(step, ramp));
            state = self
                .body
                .step_elastic(&self.bonds, &*self.set, &state, &push, time_step)
                .state;
        }
        state.anchor != start.anchor
    }
}

/// Share of the load after some steps.
fn share<R: Real>(step: u64, ramp: u64) -> R {
    -R::from_f64(-(step as f64) / ramp as f64).exp_m1()
}

/// The largest tangent of an incline as a load on 1 kg: tangential force, and normal force.
fn incline(tangent: f64) -> [f64; 2] {
    let weight = GRAVITY / (1.0 + tangent * tangent).sqrt();
    [weight * tangent, weight]
}

/// All of them.
pub fn cases<R: Real + 'static>() -> Vec<Case<R>>
where
    CoulombDisk: tribos_core::coupling::DryReducedFriction<R>,
{
    let disk = |limit: f64, radius: f64| -> Set<R> {
        let [limit, radius] = [limit, radius].map(R::from_f64);
        Box::new(RoundLimitSurface::new(CoulombDisk, limit, radius).expect("a disk"))
    };
    let square = |limit: f64, side: f64| -> Set<R> {
        let half = R::from_f64(0.5 * side);
        let corners = [[-half, -half], [half, -half], [half, half], [-half, half]];
        let square = Polygon::new(corners).expect("a square");
        Box::new(ShapeLimitSurface::new(square, R::from_f64(limit)).expect("a limit"))
    };
    let bar = |limit: f64, half: f64| -> Set<R> {
        let half = R::from_f64(half);
        let bar = Bar::new([-half, R::ZERO], [half, R::ZERO]).expect("a bar");
        Box::new(ShapeLimitSurface::new(bar, R::from_f64(limit)).expect("a limit"))
    };
    let feet = |limit: f64, radius: f64| -> Set<R> {
        let feet = [0.0_f64, 1.0, 2.0].map(|third| {
            let angle = third * core::f64::consts::TAU / 3.0;
            let [x, y] = [radius * angle.cos(), radius * angle.sin()].map(R::from_f64);
            let weight = R::ONE;
            Node { x, y, weight }
        });
        let feet = PointPatch::new(Nodes::new(feet).expect("three feet")).expect("points");
        Box::new(ShapeLimitSurface::new(feet, R::from_f64(limit)).expect("a limit"))
    };
    let plan = |name, mass, gyration, push| Plan {
        name,
        mass,
        gyration,
        push,
        is_cyclic: false,
    };
    let [ramp, on_ramp] = incline(2.0_f64.to_radians().tan());
    let [steep, on_steep] = incline(0.99 * 0.5);
    let [steepest, on_steepest] = incline(0.999 * 0.5);
    let capsule = 0.045 * GRAVITY;
    let torque = 0.5 * GRAVITY * 0.05 * 2.0 / 3.0;
    let spinning = 0.999 * 0.4 * GRAVITY;
    vec![
        Case::new(
            &plan(
                "capsule pinched with 12 N (mujoco#3328)",
                0.045,
                0.01,
                [0.0, -capsule, 0.0],
            ),
            bar(0.7 * 12.0, 0.015),
        ),
        Case::new(
            &plan(
                "capsule pinched with 60 N (mujoco#3328)",
                0.045,
                0.01,
                [0.0, -capsule, 0.0],
            ),
            bar(0.7 * 60.0, 0.015),
        ),
        Case::new(
            &plan(
                "patch of cloth pinched, mu = 64 (newton#3943)",
                0.02,
                0.01,
                [0.0, -0.02 * GRAVITY, 0.0],
            ),
            square(64.0 * 5.0, 0.02),
        ),
        Case::new(
            &plan(
                "block on a ramp of 2 degrees, mu = 1 (newton#1138)",
                1.0,
                0.04,
                [ramp, 0.0, 0.0],
            ),
            square(on_ramp, 0.1),
        ),
        Case::new(
            &plan(
                "cube pressed on a wall with 20 N (genesis#2872)",
                1.0,
                0.04,
                [0.0, -GRAVITY, 0.0],
            ),
            square(20.0, 0.1),
        ),
        Case::new(
            &plan(
                "bar held off its middle by a claw (innate-os#730)",
                0.063,
                0.03,
                [0.0, -0.063 * GRAVITY, -0.063 * GRAVITY * 0.02],
            ),
            disk(0.7 * 8.0, 0.006),
        ),
        Case::new(
            &plan("block at 99 % of its angle", 1.0, 0.04, [steep, 0.0, 0.0]),
            square(0.5 * on_steep, 0.1),
        ),
        Case::new(
            &plan(
                "block at 99.9 % of its angle",
                1.0,
                0.04,
                [steepest, 0.0, 0.0],
            ),
            square(0.5 * on_steepest, 0.1),
        ),
        Case::new(
            &Plan {
                is_cyclic: true,
                ..plan(
                    "disk under a cyclic torque of 99 %",
                    1.0,
                    0.035,
                    [0.0, 0.0, 0.99 * torque],
                )
            },
            disk(0.5 * GRAVITY, 0.05),
        ),
        Case::new(
            &plan(
                "tripod on a turntable at 99.95 % of its speed",
                1.0,
                0.05,
                [spinning, 0.0, 0.0],
            ),
            feet(0.4 * GRAVITY, 0.05),
        ),
    ]
}
