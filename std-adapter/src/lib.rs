//! Simulations on top of `tribos-core`: bodies that slide and spin to rest, contact dynamics, cohesive
//! powders, atoms; everything that allocates or accesses files.
//!
//! A scene, which is plain data ([`scene`]), becomes a simulation ([`slide`], [`powder`], [`tip`]); a
//! session runs it with checkpoints ([`run`]). The physics is in [`tribos_core`], re-exported here as
//! [`kernel`].
//!
//! # Examples
//!
//! A puck that slides and spins: both motions end in the same moment.
//!
//! ```
//! use tribos::scene::DiskScene;
//! let puck = DiskScene { speed: 1.0, spin: 5.0, gamma: 0.3, ..DiskScene::default() };
//! let end = puck.run()?.outcome; // m/s, rad/s
//! assert!((end.end_time - 0.369017132104558).abs() < 1e-9); // s
//! # Ok::<(), tribos::slide::MotionError>(())
//! ```
//!
//! A patch and a law chosen by name:
//!
//! ```
//! use tribos::friction::{AnyFriction, Law, Patch};
//! use tribos::kernel::prelude::*;
//! let (patch, law): (Patch, Law) = ("hertz".parse()?, "coulomb:mu=0.3".parse()?);
//! let ball = AnyFriction::new(&patch, &law, None)?.with_radius(0.002)?; // m
//! let wrench = ball.wrench(10.0, &Twist::new(0.1, 0.0, 50.0)); // N; m/s, m/s, rad/s
//! assert!(wrench.force.x < 0.0 && wrench.torque < 0.0); // N, N m
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! A curling stone that turns counterclockwise, and curls to the left:
//!
//! ```
//! use tribos::scene::{CurlingScene, IceModel};
//! let model = IceModel::ScratchGuide;
//! let stone = CurlingScene { model, speed: 1.9866, spin: 1.5, ..CurlingScene::default() }; // m/s, rad/s
//! let end = stone.run()?.outcome;
//! assert!(end.x > 28.3 && end.curl > 0.9); // m on, and to the left
//! # Ok::<(), tribos::slide::MotionError>(())
//! ```
//!
//! A billiard ball, struck through its centre, ends rolling with 5/7 of its speed:
//!
//! ```
//! use tribos::cd::{WorldMaterials, WorldSetup, Wall, World, solid};
//! use tribos::kernel::contact::{Cohesion, NormalLaw, SphereBody, IndependentFriction};
//! use tribos::kernel::nalgebra::Vector3;
//! let ball = SphereBody { velocity: Vector3::x(), ..solid(0.028, 1700.0) }; // m/s; m, kg/m³
//! let laws = WorldMaterials::uniform(NormalLaw::new(Cohesion::NONE, 0.0)?, IndependentFriction::sliding(0.2)?);
//! let table = WorldSetup::new(laws).wall(Wall::fixed(Vector3::z(), 0.0)).gravity(Vector3::z() * -9.81);
//! let mut world = World::new(table.sphere(Vector3::z() * 0.028, 0.028, ball))?;
//! (0..200).try_for_each(|_| world.step().map(|_| ()))?;
//! assert!((world.state().spheres[0].velocity.x - 5.0 / 7.0).abs() < 1e-12);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! A cohesive powder under a piston:
//!
//! ```
//! use tribos::{powder::PowderSimulation, run::run_to_end, scene::PowderScene};
//! let scene = PowderScene { width: 6.0, height: 8.0, pressure: 0.02, ..PowderScene::default() };
//! let mut compaction = PowderSimulation::new(&scene)?;
//! run_to_end(&mut compaction, |_line, _done| ())?;
//! let outcome = compaction.outcome();
//! assert!(outcome.porosity_final < outcome.porosity_initial);
//! # Ok::<(), tribos::run::PackingRunError>(())
//! ```
//!
//! # Modules
//!
//! | module | contents |
//! |---|---|
//! | [`friction`] | patch, law and accuracy tier chosen by name; the catalogue of laws |
//! | [`onset`] | what a contact holds under force and torque before it slides |
//! | [`scene`] | scenes: plain data with defaults, their files, units and checks |
//! | [`push`] | quasi-static pushing: motion cones, sticking and sliding, paths |
//! | [`slide`] | sliding bodies: disk, cylinder, pipe, box or other plate, curling rock; launches that end at a wanted pose |
//! | [`stick`] | bodies that hold, let go and hold again: on a spring, on an incline, on a turntable |
//! | [`cd`], [`powder`] | rigid spheres in contact; cohesive powders under a piston |
//! | [`grains`] | grains in boxes under gravity, pistons, moving plates and shaking |
//! | [`soft`] | soft spheres: the same contacts with springs and dashpots |
//! | [`gas`] | granular gases: hard spheres from collision to collision |
//! | [`measure`] | stress, fabric, pair correlation, force chains of packings; packings of other programs |
//! | [`tip`] | a tip of atoms turned on a substrate |
//! | [`fit`] | parameters of friction laws from measurements |
//! | [`run`] | the driver: sessions with checkpoints, progress, cancellation |
//! | [`record`], [`space`] | errors of output files; periodic boxes |
//!
//! [`prelude`] has the names of everyday use. Items that this documentation does not show serve the
//! command of this repository: they are no part of the promise and change without notice.

#[doc(hidden)]
pub mod golden;
pub mod prelude;
pub mod scene;

/// Friction chosen at run time: a patch, a law and a tier by name.
pub mod friction {
    #[doc(inline)]
    pub use tribos_friction::*;
}

/// The driver of simulations: step, observe, record, checkpoint, resume, cancel.
pub mod run {
    #[doc(inline)]
    pub use tribos_base::run::*;
    #[doc(hidden)]
    pub use tribos_grains::packing::PackingRun;
    #[doc(inline)]
    pub use tribos_grains::packing::{PackingRunError, PackingStopReason, PlacementError};
    #[doc(inline)]
    pub use tribos_motion::SceneRun;
}

#[doc(hidden)]
pub use tribos_atoms::md;
#[doc(inline)]
pub use tribos_atoms::tip;
#[doc(hidden)]
pub use tribos_base::random;
#[doc(hidden)]
pub use tribos_base::{bracket, results, statistics};
#[doc(inline)]
pub use tribos_base::{record, space};
#[doc(hidden)]
pub use tribos_contacts::event;
#[doc(inline)]
pub use tribos_contacts::{cd, problem, soft};
#[doc(inline)]
pub use tribos_grains::{gas, grains, measure, powder};
#[doc(hidden)]
pub use tribos_motion as motion;
#[doc(inline)]
pub use tribos_motion::{fit, onset, push, slide, stick};

pub use tribos_core as kernel;
pub use tribos_core::nalgebra;
