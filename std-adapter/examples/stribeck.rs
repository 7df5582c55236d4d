//! A disk under Stribeck friction, brought to rest.

use tribos::scene::DiskScene;

#[rustfmt::skip] // As short as documentation shows it.
fn main() -> Result<(), Box<dyn std::error::Error>> {
    let law = Some("stribeck:mu_s=0.4,mu_d=0.2,vs=0.05,k=0.02".parse()?); // m/s, s/m
    let disk = DiskScene { speed: 1.0, spin: 5.0, radius: 0.08, law, ..DiskScene::default() }; // m/s, rad/s, m
    let end = disk.run()?.outcome;
    println!("at rest after {:.6} s and {:.6} m, turned by {:.6} rad", end.end_time, end.distance, end.angle);
    Ok(())
}
