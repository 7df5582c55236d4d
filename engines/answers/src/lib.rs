//! A physics engine in Rust before the problems of [friction-answers](../../tests/answers/README.md): implement [`Engine`], name it in
//! [`export`](crate::export!), build a `cdylib`, and `friction-answers run target/release/examples/libmy_answers.so`.
//!
//! Units are SI; the axes are the world's, with y upwards: x of the problems is x here, their y is −z, their z is y.

/// A rigid body as the problems have it.
#[derive(Clone, Copy, Debug)]
pub struct Body {
    /// About the body's origin.
    pub shape: Shape,
    /// Moves with the velocity and spin that [`Engine::set`] gives it before every step.
    pub is_driven: bool,
    /// Of the origin, in m.
    pub place: [f64; 3],
    /// Quaternion x, y, z, w.
    pub pose: [f64; 4],
    /// In kg.
    pub mass: f64,
    /// Principal moments about the centre of mass along the axes of the body, in kg m².
    pub inertia: [f64; 3],
    /// Centre of mass from the origin, in m.
    pub com: [f64; 3],
}

/// A shape, in m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shape {
    /// Half sides along x, y, z.
    Box([f64; 3]),
    /// Upright: radius, half its height, and whether it stands on the thin rim of its face.
    Cylinder(f64, f64, bool),
    /// Radius.
    Ball(f64),
    /// Along x: radius, half the length of its straight part.
    Capsule(f64, f64),
    /// x and z of three balls of [`FOOT`] radius in the plane y = 0 of the body.
    Feet([[f64; 2]; 3]),
}

/// Radius of a foot, in m.
pub const FOOT: f64 = 0.01;

/// What is built.
#[derive(Clone, Debug)]
pub struct Scene {
    /// Friction between any two bodies, and at the floor.
    pub mu: f64,
    /// In m/s².
    pub gravity: [f64; 3],
    /// Length of a step, in s.
    pub dt: f64,
    /// At y = 0.
    pub has_floor: bool,
    /// Number of the setting, in the order of [`Engine::ABOUT`].
    pub setting: usize,
    /// Bodies by their numbers.
    pub bodies: Vec<Body>,
}

/// Place of the centre of mass, pose, velocity of the centre of mass and spin of a body.
#[derive(Clone, Copy, Debug)]
pub struct State {
    /// In m.
    pub place: [f64; 3],
    /// Quaternion x, y, z, w.
    pub pose: [f64; 4],
    /// In m/s.
    pub velocity: [f64; 3],
    /// In rad/s.
    pub spin: [f64; 3],
}

/// A world of an engine; numbers of bodies are those of [`Scene::bodies`].
pub trait Engine: Sized {
    /// `{"name": …, "version": …, "licence": …, "kind": "games", "mechanics" or "gpu", "settings": {name: {"dt": …}}}`: the engine's own defaults first.
    const ABOUT: &core::ffi::CStr;
    /// The world, or a sentence about what the engine has not. Scenes with torsion or anisotropic friction do not come here.
    fn new(scene: &Scene) -> Result<Self, &'static core::ffi::CStr>;
    /// Velocity of a centre of mass, and spin.
    fn set(&mut self, body: usize, velocity: [f64; 3], spin: [f64; 3]);
    /// A step.
    fn step(&mut self);
    /// After it.
    fn state(&self, body: usize) -> State;
    /// From now on, in m/s².
    fn gravity(&mut self, gravity: [f64; 3]);
    /// On a centre of mass in the next step, in N.
    fn force(&mut self, body: usize, force: [f64; 3]);
}

/// `engine.h`.
#[doc(hidden)]
pub mod c {
    use super::{Body, Engine, Scene, Shape, State};
    use core::ffi::{CStr, c_char, c_int, c_void};

    #[repr(C)]
    #[derive(Debug)]
    pub struct CBody {
        kind: c_int,
        is_driven: c_int,
        is_rim: c_int,
        sizes: [f64; 6],
        place: [f64; 3],
        pose: [f64; 4],
        mass: f64,
        inertia: [f64; 3],
        com: [f64; 3],
    }

    #[repr(C)]
    #[derive(Debug)]
    pub struct CScene {
        mu: f64,
        mu_across: f64,
        torsion: f64,
        gravity: [f64; 3],
        dt: f64,
        has_floor: c_int,
        setting: c_int,
        count: c_int,
        bodies: *const CBody,
    }

    pub fn raised([x, y, z]: [f64; 3]) -> [f64; 3] {
        [x, z, -y]
    }

    fn laid([x, y, z]: [f64; 3]) -> [f64; 3] {
        [x, -z, y]
    }

    fn body(given: &CBody) -> Body {
        let [a, b, c, ..] = given.sizes;
        let foot = |i: usize| [given.sizes[2 * i], -given.sizes[2 * i + 1]];
        let shape = match given.kind {
            0 => Shape::Box([a, c, b]),
            1 => Shape::Cylinder(a, b, given.is_rim != 0),
            2 => Shape::Ball(a),
            3 => Shape::Capsule(a, b),
            _ => Shape::Feet([foot(0), foot(1), foot(2)]),
        };
        let [w, x, y, z] = given.pose;
        let [along, across, up] = given.inertia;
        let [x, y, z] = raised([x, y, z]);
        Body {
            shape,
            is_driven: given.is_driven != 0,
            place: raised(given.place),
            pose: [x, y, z, w],
            mass: given.mass,
            inertia: [along, up, across],
            com: raised(given.com),
        }
    }

    #[expect(unsafe_code, reason = "engine.h hands over pointers")]
    pub fn make<E: Engine>(given: &CScene, why: &mut *const c_char) -> *mut c_void {
        let count = usize::try_from(given.count).unwrap_or(0);
        // SAFETY: the caller holds this many bodies during the call.
        let bodies = unsafe { core::slice::from_raw_parts(given.bodies, count) };
        let made = if given.torsion > 0.0 {
            Err(c"Contacts have no torsional friction.")
        } else if given.mu_across >= 0.0 {
            Err(c"Friction is the same in all directions.")
        } else {
            E::new(&Scene {
                mu: given.mu,
                gravity: raised(given.gravity),
                dt: given.dt,
                has_floor: given.has_floor != 0,
                setting: usize::try_from(given.setting).unwrap_or(0),
                bodies: bodies.iter().map(body).collect(),
            })
        };
        match made {
            Ok(engine) => Box::into_raw(Box::new(engine)).cast(),
            Err(reason) => {
                *why = CStr::as_ptr(reason);
                core::ptr::null_mut()
            }
        }
    }

    #[expect(unsafe_code, reason = "engine.h hands over pointers")]
    pub fn drop<E: Engine>(world: *mut c_void) {
        // SAFETY: of `make`, which is called for the last time with it.
        core::mem::drop(unsafe { Box::from_raw(world.cast::<E>()) });
    }

    #[expect(unsafe_code, reason = "engine.h hands over pointers")]
    pub fn world<'a, E: Engine>(world: *mut c_void) -> &'a mut E {
        // SAFETY: of `make`, used by one caller at a time.
        unsafe { &mut *world.cast() }
    }

    pub fn write(state: &State, out: &mut [f64; 13]) {
        let [x, y, z, w] = state.pose;
        let [x, y, z] = laid([x, y, z]);
        out[..3].copy_from_slice(&laid(state.place));
        out[3..7].copy_from_slice(&[w, x, y, z]);
        out[7..10].copy_from_slice(&laid(state.velocity));
        out[10..].copy_from_slice(&laid(state.spin));
    }
}

/// The functions of `engine.h` for an [`Engine`](crate::Engine).
#[macro_export]
macro_rules! export {
    ($engine:ty) => {
        #[expect(unsafe_code, reason = "functions of engine.h")]
        mod exported {
            use super::*;
            use core::ffi::{c_char, c_int, c_void};
            use $crate::{Engine, c};
            #[unsafe(no_mangle)]
            extern "C" fn fa_about() -> *const c_char {
                <$engine>::ABOUT.as_ptr()
            }
            #[unsafe(no_mangle)]
            extern "C" fn fa_make(scene: &c::CScene, why: &mut *const c_char) -> *mut c_void {
                c::make::<$engine>(scene, why)
            }
            #[unsafe(no_mangle)]
            extern "C" fn fa_drop(world: *mut c_void) {
                c::drop::<$engine>(world);
            }
            #[unsafe(no_mangle)]
            extern "C" fn fa_set(
                world: *mut c_void,
                body: c_int,
                velocity: &[f64; 3],
                spin: &[f64; 3],
            ) {
                let (velocity, spin) = (c::raised(*velocity), c::raised(*spin));
                c::world::<$engine>(world).set(body as usize, velocity, spin);
            }
            #[unsafe(no_mangle)]
            extern "C" fn fa_step(world: *mut c_void) {
                c::world::<$engine>(world).step();
            }
            #[unsafe(no_mangle)]
            extern "C" fn fa_state(world: *mut c_void, body: c_int, state: &mut [f64; 13]) {
                c::write(&c::world::<$engine>(world).state(body as usize), state);
            }
            #[unsafe(no_mangle)]
            extern "C" fn fa_gravity(world: *mut c_void, gravity: &[f64; 3]) {
                c::world::<$engine>(world).gravity(c::raised(*gravity));
            }
            #[unsafe(no_mangle)]
            extern "C" fn fa_force(world: *mut c_void, body: c_int, force: &[f64; 3]) {
                c::world::<$engine>(world).force(body as usize, c::raised(*force));
            }
        }
    };
}
