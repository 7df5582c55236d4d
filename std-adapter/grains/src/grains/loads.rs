//! What drives the grains: gravity, pistons, moving plates, shaking, each at its time.

use super::bound::{self, BoundGrain, Holder};
use super::layout::Layout;
use super::ramp::Ramp;
use super::wall::{AxisEnd, InitialWall, PLATE, WallId};
use crate::grains::scene::{Axis, GrainsScene};
use crate::packing::{InitialSpheres, Packing};
use nalgebra::Vector3;
use std::f64::consts::TAU;
use tribos_contacts::cd::AxisControl;
use tribos_contacts::cd::Rectangle;

/// How a wall is driven along its normal.
#[derive(Clone, Debug)]
enum WallControl {
    /// With the box, which may be shaken.
    Box,
    /// By a stress.
    Stress(Ramp),
    /// With a speed along the axis.
    Speed(Ramp),
    /// Not at all.
    Fixed,
    /// Opened at the time of the scene.
    Lid,
    /// Along itself with the drum.
    Facet(Vector3<f64>),
}

/// The loads of a scene.
#[derive(Clone, Debug)]
pub(super) struct Loads {
    gravity: Ramp,
    angle: Ramp,
    plate_speed: Ramp,
    wall_speed: Ramp,
    /// Controls of the walls, in their order, with their places at the start.
    walls: Vec<(WallId, WallControl, f64)>,
    /// Rate of rotation of a drum, its radius, and the opening of a hopper.
    drum: (Ramp, f64),
    opening: f64,
    shake: Shake,
    repeat: Option<f64>,
    /// Velocity of driven grains, and all grains that no force moves.
    drive: [Ramp; 3],
    turn: Turn,
    bound: Vec<BoundGrain>,
    /// Velocity of the plate above along z, if it has one.
    lid: Option<Ramp>,
    /// What the lengths of periodic axes follow.
    axes: [AxisLoad; 3],
}

/// What the length of a periodic axis follows.
#[derive(Clone, Debug)]
enum AxisLoad {
    Fixed,
    Stress(Ramp),
    Speed(Ramp),
}

/// The rotation of driven grains about an axis through their centre at the start, which moves with them.
#[derive(Clone, Debug)]
struct Turn {
    rate: Ramp,
    axis: Vector3<f64>,
    centre: Vector3<f64>,
}

/// A harmonic motion of the box.
#[derive(Clone, Copy, Debug)]
struct Shake {
    amplitude: f64,
    /// Angular frequency.
    rate: f64,
    axis: Axis,
}

impl Loads {
    /// The loads of a scene on the walls of its box.
    pub fn of(scene: &GrainsScene, layout: &Layout, start: &InitialSpheres) -> Self {
        let control = |face: WallId| match face {
            WallId::Side(_, AxisEnd::Low) => WallControl::Box,
            WallId::Side(axis, AxisEnd::High) => match (scene.pressure(axis), scene.velocity(axis))
            {
                (Some(stress), _) => WallControl::Stress(stress.clone()),
                (None, Some(speed)) => WallControl::Speed(speed.clone()),
                (None, None) => WallControl::Box,
            },
            WallId::Slope => WallControl::Fixed,
            WallId::Lid => WallControl::Lid,
            WallId::Facet(along) => WallControl::Facet(along),
        };
        let wall = |part: &InitialWall| (part.face, control(part.face), part.place);
        let bound = scene.bound(start);
        Self {
            gravity: scene.gravity.clone(),
            angle: scene.gravity_angle.clone(),
            plate_speed: scene.lid_speed_x.clone(),
            wall_speed: scene.side_wall_speed_z.clone(),
            walls: layout.parts.iter().map(wall).collect(),
            drum: (scene.drum_angular_velocity.clone(), 0.5 * scene.width),
            opening: scene.open_time,
            shake: Shake {
                amplitude: scene.shake_amplitude,
                rate: TAU * scene.shake_frequency,
                axis: scene.shake_axis,
            },
            repeat: scene.ramp_period,
            axes: [Axis::X, Axis::Y, Axis::Z].map(|axis| {
                if layout.space.lengths()[axis.index()].is_none() {
                    return AxisLoad::Fixed;
                }
                match (scene.pressure(axis), scene.velocity(axis)) {
                    (Some(stress), _) => AxisLoad::Stress(stress.clone()),
                    (None, Some(speed)) => AxisLoad::Speed(speed.clone()),
                    (None, None) => match (axis, scene.compression(), layout.space.lengths()[2]) {
                        (Axis::Z, Some(rate), Some(length)) => {
                            AxisLoad::Speed((-rate * length).into())
                        }
                        _ => AxisLoad::Fixed,
                    },
                }
            }),
            drive: [
                scene.driven_velocity_x.clone(),
                scene.driven_velocity_y.clone(),
                scene.driven_velocity_z.clone(),
            ],
            turn: Turn {
                rate: scene.driven_angular_velocity.clone(),
                axis: scene.driven_axis.direction(),
                centre: bound::centre(&bound),
            },
            bound,
            lid: scene.wall_velocity_z.clone(),
        }
    }

    /// The grains that no force moves.
    pub fn bound(&self) -> &[BoundGrain] {
        &self.bound
    }

    /// Place of a grain that something holds at a time, and its velocity and spin.
    fn pose(&self, held: &BoundGrain, time: f64) -> (Vector3<f64>, [Vector3<f64>; 2]) {
        let [shift, velocity] = self.shift(held.holder, time);
        let [rate, angle] = self.follow(&self.turn.rate, time);
        if held.holder != Holder::Drive || (rate, angle) == (0.0, 0.0) {
            return (held.start + shift, [velocity, Vector3::zeros()]);
        }
        let spin = self.turn.axis * rate;
        let turned = rotated(held.start - self.turn.centre, self.turn.axis, angle);
        let place = self.turn.centre + shift + turned;
        (place, [velocity + spin.cross(&turned), spin])
    }

    /// Displacement and velocity at a time of the grains that something holds, without rotation.
    fn shift(&self, holder: Holder, time: f64) -> [Vector3<f64>; 2] {
        let along = |ramp: &Ramp, axis: Vector3<f64>| {
            let [speed, way] = self.follow(ramp, time);
            [axis * way, axis * speed]
        };
        let (shift, swing) = self.shake.at(time);
        let parts = match holder {
            Holder::Box => return [shift, swing],
            Holder::Drive => {
                let [x, y, z] = &self.drive;
                vec![
                    along(x, Vector3::x()),
                    along(y, Vector3::y()),
                    along(z, Vector3::z()),
                ]
            }
            Holder::Lid => {
                let rise = self.lid.as_ref().map(|speed| along(speed, Vector3::z()));
                vec![
                    rise.unwrap_or([shift, swing]),
                    along(&self.plate_speed, Vector3::x()),
                ]
            }
        };
        [0, 1].map(|of: usize| parts.iter().map(|part| part[of]).sum())
    }

    /// Whether a wall is a piston.
    pub fn is_piston(&self, wall: usize) -> bool {
        let control = self.walls.get(wall).map(|(_, control, _)| control);
        matches!(control, Some(WallControl::Stress(_)))
    }

    /// The value of a ramp at a time, and its integral from the start.
    fn follow(&self, ramp: &Ramp, time: f64) -> [f64; 2] {
        match self.repeat {
            None => [ramp.at(time), ramp.integral(time)],
            Some(period) => {
                let cycles = (time / period).floor();
                let phase = time - cycles * period;
                let whole = cycles * ramp.integral(period);
                [ramp.at(phase), whole + ramp.integral(phase)]
            }
        }
    }

    /// What the lengths of periodic axes follow at a time.
    pub fn axes(&self, time: f64) -> [AxisControl; 3] {
        self.axes.each_ref().map(|load| match load {
            AxisLoad::Fixed => AxisControl::Fixed,
            AxisLoad::Stress(stress) => AxisControl::Stress(self.follow(stress, time)[0]),
            AxisLoad::Speed(speed) => AxisControl::Speed(self.follow(speed, time)[0]),
        })
    }

    /// Acceleration of the grains at a time.
    pub fn gravity(&self, time: f64) -> Vector3<f64> {
        let [strength, _] = self.follow(&self.gravity, time);
        let [angle, _] = self.follow(&self.angle, time);
        let (sin, cos) = libm::sincos(angle.to_radians());
        Vector3::new(strength * sin, 0.0, -strength * cos)
    }

    /// Speed of the plate above along x at a time.
    pub fn plate_speed(&self, time: f64) -> f64 {
        self.follow(&self.plate_speed, time)[0]
    }

    /// Sets gravity and walls for a step from this time on. Walls that follow a speed or the shaking are
    /// put where their motion has taken them by then.
    pub fn apply(&self, layout: &Layout, packing: &mut dyn Packing) {
        let (time, _) = packing.clock();
        let extents = layout.extents(packing);
        packing.set_gravity(self.gravity(time));
        packing.set_axes(self.axes(time));
        for held in &self.bound {
            let (place, motion) = self.pose(held, time);
            packing.place(held.grain, place, motion);
        }
        let (shift, swing) = self.shake.at(time);
        let walls = packing.walls_mut().iter_mut();
        for (wall, (face, control, start)) in walls.zip(&self.walls) {
            let (area, axis) = match face {
                WallId::Side(axis, _) => (Layout::area(&extents, *axis), axis.unit()),
                _ => (0.0, Vector3::zeros()),
            };
            let across = match face {
                &PLATE => Vector3::x() * self.plate_speed(time),
                WallId::Side(Axis::X | Axis::Y, _) => {
                    Vector3::z() * self.follow(&self.wall_speed, time)[0]
                }
                _ => Vector3::zeros(),
            };
            match control {
                WallControl::Box => {
                    wall.place = start + wall.outward.dot(&shift);
                    wall.plate.velocity = swing + across;
                }
                WallControl::Stress(stress) => {
                    let [stress, _] = self.follow(stress, time);
                    wall.force = stress * area;
                    let along = axis * axis.dot(&wall.plate.velocity);
                    wall.plate.velocity = along + across;
                }
                WallControl::Speed(speed) => {
                    let [speed, way] = self.follow(speed, time);
                    wall.place = start + wall.outward.dot(&axis) * way;
                    wall.plate.velocity = axis * speed + across;
                }
                WallControl::Facet(along) => {
                    let (rate, radius) = &self.drum;
                    let [rate, _] = self.follow(rate, time);
                    // Roundings of its motion must not add up.
                    wall.place = *start;
                    wall.plate.velocity = along * (rate * radius);
                }
                WallControl::Lid if time >= self.opening => {
                    wall.edges = Some(Rectangle::NONE);
                }
                WallControl::Lid | WallControl::Fixed => {}
            }
        }
    }
}

/// A vector turned about a unit vector, right-handed (Rodrigues).
fn rotated(arm: Vector3<f64>, axis: Vector3<f64>, angle: f64) -> Vector3<f64> {
    let (sin, cos) = libm::sincos(angle);
    arm * cos + axis.cross(&arm) * sin + axis * (axis.dot(&arm) * (1.0 - cos))
}

impl Shake {
    /// Displacement and velocity of the box at a time.
    fn at(&self, time: f64) -> (Vector3<f64>, Vector3<f64>) {
        if self.amplitude == 0.0 {
            return (Vector3::zeros(), Vector3::zeros());
        }
        let (sin, cos) = libm::sincos(self.rate * time);
        let axis = self.axis.unit();
        (
            axis * (self.amplitude * sin),
            axis * (self.amplitude * self.rate * cos),
        )
    }
}
