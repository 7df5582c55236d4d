//! Two bodies as one: the mass and inertia with which a common impulse meets their relative motion.

use crate::standing::push;
use crate::symmetric::solved;
use tribos_core::planar::PlanarBody;
use tribos_core::twist::{Twist, Wrench};

/// Radius of gyration in metres of a pair that cannot turn; its inverse, of one that cannot shift: far beyond any body's, and
/// its square is exact.
const LOCKED: f32 = 1e3;

/// A foot's body and its ground's in the plane of contact, reduced to one body at the foot's centre of mass.
///
/// ```
/// use tribos_core::twist::Twist;
/// use tribos_feet::Reduced;
/// let on_plank = Reduced::new([[1.0, 200.0], [0.5, 0.0]], [0.0; 2]).ok_or("both are fixed")?; // 1/kg, 1/(kg m²)
/// let [puck, plank] = on_plank.shared(&Twist::new(-3.0, 0.0, -1.0));
/// assert_eq!([puck, plank], [Twist::new(-2.0, 0.0, -1.0), Twist::new(1.0, 0.0, 0.0)]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Reduced {
    body: PlanarBody<f32>,
    inverse: [[f32; 2]; 2],
    lever: [f32; 2],
    /// The mass matrix if friction moves the ground.
    coupled: Option<[f64; 6]>,
}

impl Reduced {
    /// From 1/mass in 1/kg and 1/inertia about the normal in 1/(kg m²) of the foot's body and of the ground, zero for
    /// what friction does not move, and the vector from the ground's centre of mass to the foot's in metres, in the plane.
    /// `None` if neither can be moved.
    pub fn new(inverse: [[f32; 2]; 2], lever: [f32; 2]) -> Option<Self> {
        let sums = [0, 1].map(|i| inverse[0][i] + inverse[1][i]);
        // Locked motions get a large mass, so that friction acts only on the others.
        let [mass, inertia] = match sums.map(|sum| sum > 0.0) {
            [true, true] => sums.map(f32::recip),
            [true, false] => [sums[0].recip(), sums[0].recip() * (LOCKED * LOCKED)],
            [false, true] => [sums[1].recip() * (LOCKED * LOCKED), sums[1].recip()],
            [false, false] => return None,
        };
        let body = PlanarBody::new(mass, inertia).ok()?;
        let coupled = is_moved(inverse[1]).then(|| mass_matrix(&body, inverse[1][1], lever));
        Some(Self {
            body,
            inverse,
            lever,
            coupled,
        })
    }

    /// The pair, if friction acted at the ground's centre of mass.
    pub fn body(&self) -> &PlanarBody<f32> {
        &self.body
    }

    /// Whether friction moves the foot and the ground.
    pub fn moved(&self) -> [bool; 2] {
        self.inverse.map(is_moved)
    }

    /// The mass matrix of the relative motion if friction moves the ground, as [`Standing::new`](crate::Standing::new)
    /// has it.
    pub fn coupled(&self) -> Option<&[f64; 6]> {
        self.coupled.as_ref()
    }

    /// Changes of the foot's and the ground's motions that together give a change of the relative one.
    pub fn shared(&self, change: &Twist<f32>) -> [Twist<f32>; 2] {
        let [foot, ground] = self.inverse;
        if self.coupled.is_none() {
            let free = foot.map(|inverse| f32::from(u8::from(inverse > 0.0)));
            let alone = Twist {
                velocity: change.velocity * free[0],
                spin: change.spin * free[1],
            };
            return [alone, Twist::ZERO];
        }
        let Wrench { force, torque } = self.push(change, 1.0);
        let [x, y] = self.lever;
        let below = torque + (x * force.y - y * force.x);
        let moved = |velocity, spin| Twist { velocity, spin };
        [
            moved(force * foot[0], torque * foot[1]),
            moved(force * -ground[0], below * -ground[1]),
        ]
    }

    /// The mean push that makes `change` of the relative motion in a time `dt`, in s.
    pub fn push(&self, change: &Twist<f32>, dt: f32) -> Wrench<f32> {
        push(&self.body, self.coupled(), change, dt)
    }
}

/// Whether friction moves a body of this 1/mass and 1/inertia.
fn is_moved([mass, inertia]: [f32; 2]) -> bool {
    mass > 0.0 || inertia > 0.0
}

/// The mass matrix of the relative motion at the foot's centre of mass: xx, xy, yy, xn, yn, nn.
fn mass_matrix(body: &PlanarBody<f32>, turn: f32, lever: [f32; 2]) -> [f64; 6] {
    let [mass, inertia] = [body.mass(), body.inertia()].map(f64::from);
    let [x, y] = lever.map(f64::from);
    let turn = f64::from(turn);
    if turn == 0.0 {
        return [mass, 0.0, mass, 0.0, 0.0, inertia];
    }
    // A force on the ground rotates it, which moves points off its centre.
    let inverse = [
        1.0 / mass + turn * y * y,
        -(turn * x * y),
        1.0 / mass + turn * x * x,
        -(turn * y),
        turn * x,
        1.0 / inertia,
    ];
    let column = |right: [f64; 3]| solved(&inverse, &right);
    let [xx, xy, xn] = column([1.0, 0.0, 0.0]);
    let [_, yy, yn] = column([0.0, 1.0, 0.0]);
    let [_, _, nn] = column([0.0, 0.0, 1.0]);
    [xx, xy, yy, xn, yn, nn]
}
