//! A billiard ball, struck through its centre, slides at first and ends rolling with 5/7 of its speed.

use tribos::cd::{Wall, World, WorldMaterials, WorldSetup, solid};
use tribos::kernel::{
    contact::{Cohesion, IndependentFriction, NormalLaw, SphereBody},
    nalgebra::Vector3,
};

#[rustfmt::skip] // As short as documentation shows it.
fn main() -> Result<(), Box<dyn std::error::Error>> {
    let (up, radius) = (Vector3::z(), 0.028); // m
    let ball = SphereBody { velocity: Vector3::x(), ..solid(radius, 1700.0) }; // m/s, kg/m³
    let laws = WorldMaterials::uniform(NormalLaw::new(Cohesion::NONE, 0.0)?, IndependentFriction::sliding(0.2)?);
    let table = WorldSetup::new(laws).wall(Wall::fixed(up, 0.0)).gravity(up * -9.81);
    let mut world = World::new(table.sphere(up * radius, radius, ball))?;
    (0..300).try_for_each(|_| world.step().map(|_| ()))?;
    println!("{:.6} m/s after {:.1} s", world.state().spheres[0].velocity.x, world.state().time);
    Ok(())
}
