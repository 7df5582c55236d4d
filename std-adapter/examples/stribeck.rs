//! A disk under Stribeck friction, brought to rest.

use tribos::friction::{Friction, Law, Patch};
use tribos::slide::planar::{Gradient, Journey, Launch, TallBody};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let law: Law = "stribeck:mu_s=0.4,mu_d=0.2,vs=0.05,k=0.02".parse()?; // m/s, s/m
    let friction = Friction::new(&Patch::Disk, &law, None)?.with_radius(0.08)?; // m
    let disk = TallBody::new(friction, 0.0, Gradient::AllRound, [9.81, 0.5])?; // flat; m/s^2, I/(M R^2)
    let launch = Launch {
        velocity: [1.0, 0.0],
        spin: 5.0,
    }; // m/s, rad/s
    let end = Journey::new(&disk, &launch, 1e-4)?.to_end()?.point;
    println!(
        "at rest after {:.6} s and {:.6} m, turned by {:.6} rad",
        end.time, end.distance, end.angle
    );
    Ok(())
}
