//! One step of contact dynamics for packings under load, with zero initial impulses.

use super::jammed::{Jammed, NotJammed};
use nalgebra::Vector3;
use tribos::cd::internals::{Link, Operator, Spheres};
use tribos::cd::solid;
use tribos::space::PeriodicBox;
use tribos::space::pairs::neighbours;
use tribos_core::contact::{
    Cohesion, Contact, ContactFriction, ContactGeometry, ContactVector, NormalLaw, WallBody,
};

/// Length of the step. Without cohesion and open gaps the problem scales with it.
const STEP: f64 = 0.01;
/// Load of the upper plate on an area R².
const PRESSURE: f64 = 1.0;
/// Gap up to which surfaces count as touching: above rounding, far below any motion.
const TOUCHING: f64 = 1e-9;

/// The step of a packing whose upper plate is pushed down; a plate as heavy as all spheres.
pub fn pressed<F: ContactFriction<f64>>(
    packing: &Jammed,
    friction: F,
) -> Result<Spheres<F>, NotJammed> {
    let Jammed {
        space,
        positions,
        radii,
        height,
    } = packing;
    let law = NormalLaw::new(Cohesion::NONE, 0.0).map_err(|error| NotJammed(error.to_string()))?;
    let mut problem = Spheres::new([friction; 2]);
    let spheres: Vec<_> = radii.iter().map(|&radius| solid(radius, 1.0)).collect();
    let mass: f64 = spheres.iter().map(|sphere| 1.0 / sphere.inv_mass).sum();
    let area = space.lengths()[0].unwrap_or(1.0) * space.lengths()[1].unwrap_or(1.0);

    let refused = |error: tribos_core::contact::ContactError| NotJammed(error.to_string());
    for [a, b] in neighbours(space, positions, radii, TOUCHING)? {
        let [i, j] = [a as usize, b as usize];
        let apart = space.displacement(&positions[i], &positions[j]);
        let touch = ContactGeometry::spheres(&apart, [radii[i], radii[j]]).map_err(refused)?;
        let contact = Contact::new(&touch, &law, &spheres[i], &spheres[j], STEP);
        let bodies = [a, b];
        problem.pairs.push(&Link { bodies, contact });
    }
    // A floor, and a plate under load.
    let up = Vector3::z();
    let still = WallBody {
        velocity: Vector3::zeros(),
        inv_mass: 0.0,
    };
    let piston = WallBody {
        inv_mass: 1.0 / mass,
        ..still
    };
    let planes = [(up, 0.0, still), (-up, -height, piston)];
    for (i, (x, &radius)) in positions.iter().zip(radii).enumerate() {
        for (w, (outward, place, plate)) in planes.iter().enumerate() {
            let above = outward.dot(x) - place;
            if above - radius > TOUCHING {
                continue;
            }
            let touch = ContactGeometry::plate(above, outward, radius).map_err(refused)?;
            let contact = Contact::new(&touch, &law, &spheres[i], plate, STEP);
            problem.walls.push(Link {
                bodies: [i as u32, w as u32],
                contact,
            });
        }
    }
    let falling = WallBody {
        velocity: -up * (PRESSURE * area / mass * STEP),
        ..piston
    };
    problem.free = (spheres, vec![still, falling]);
    problem.start();
    Ok(problem)
}

/// An upright chain of touching spheres between the plates.
pub fn chain(count: usize) -> Jammed {
    let place = |index| Vector3::z() * (2.0 * index as f64 + 1.0);
    Jammed {
        space: PeriodicBox::OPEN,
        positions: (0..count).map(place).collect(),
        radii: vec![1.0; count],
        height: 2.0 * count as f64,
    }
}

/// Sets all impulses to zero.
pub fn cool<F: ContactFriction<f64>>(problem: &mut Spheres<F>) {
    for contact in 0..problem.contacts() {
        problem.guess(contact, &ContactVector::default());
    }
    problem.refresh();
}
