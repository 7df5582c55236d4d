//! A gas of rough spheres in a box, for conservation laws in collisions.

use crate::packings::{Rough, accelerated, spheres};
use nalgebra::Vector3;
use tribos::cd::{StepLimits, WorldMaterials, WorldSetup, solid};
use tribos::random::Random;
use tribos::space::PeriodicBox;
use tribos_core::contact::NormalLaw;

/// Side of the box: a power of two, so that images are exact.
pub const SIDE: f64 = 16.0;

/// 64 spheres on a cubic lattice with random radii, velocities and spins, which soon collide.
pub fn gas(space: PeriodicBox, normal: NormalLaw<f64>, friction: Rough) -> WorldSetup<Rough> {
    let mut random = Random::new(7, 1);
    let lattice = |index: usize| {
        let cell = [index % 4, index / 4 % 4, index / 16].map(|cell| 2.0 + 4.0 * cell as f64);
        Vector3::from(cell)
    };
    let mut setup = spheres(
        (0..64).map(lattice).collect(),
        WorldMaterials::uniform(normal, friction),
    );
    setup.space = space;
    setup.solver = accelerated(1e-10);
    setup.step_limits = StepLimits {
        longest: 0.05,
        motion: 0.1,
    };
    let mut vector = |size: f64| {
        let mut component = || size * (2.0 * random.unit() - 1.0);
        Vector3::new(component(), component(), component())
    };
    for (body, sphere) in setup.spheres.iter_mut().enumerate() {
        let radius = 1.4 + 0.4 * vector(1.0).x;
        setup.radii[body] = radius;
        *sphere = solid(radius, 1.0);
        // Velocities point to the middle, because an open gas must collide.
        let inwards = (setup.positions[body] - Vector3::repeat(0.5 * SIDE)) * -0.15;
        sphere.velocity = vector(1.0) + inwards;
        sphere.spin = vector(1.0);
    }
    setup
}

/// A box of this side, periodic along the given axes.
pub fn periodic(axes: [bool; 3]) -> PeriodicBox {
    PeriodicBox::new(axes.map(|periodic| periodic.then_some(SIDE))).expect("the box is valid")
}
