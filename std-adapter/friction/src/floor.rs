//! Floors of several surfaces, each with a motion of its own, under an area or under several feet.

use super::flat::Flat;
use super::owned_feet::OwnedFeet;
use super::{Area, Coefficients, FrictionError};
use tribos_core::contact::TimeStep;
use tribos_core::floor::{Feet, FloorStep, Foot, SteadyState};
use tribos_core::limit_surface::FrictionSet;
use tribos_core::patch::affine_image::{AffineImage, AffineMap};
use tribos_core::patch::feet::PatchPart;
use tribos_core::patch::piece::{HalfPlane, PatchPiece};
use tribos_core::planar::PlanarBody;
use tribos_core::twist::{Twist, Wrench, WrenchJacobian};

/// A part of the floor and how it moves: what lies within all of some half-planes, in the coordinates of the body.
///
/// ```
/// use tribos::friction::Surface;
/// use tribos::prelude::*;
/// // A belt of 0.5 m/s to the left of the x axis, and a square plate that stands.
/// let belt = Surface::half_plane([0.0, 0.0], [1.0, 0.0], Twist::new(0.5, 0.0, 0.0))?; // m; m/s
/// let plate = Surface::polygon(&[[0.0, -0.1], [0.1, -0.1], [0.1, 0.0], [0.0, 0.0]], Twist::ZERO)?;
/// assert!(belt != plate);
/// // Hollow ones are given in parts.
/// let hollow = [[0.0, 0.0], [1.0, 0.0], [0.1, 0.1], [0.0, 1.0]];
/// assert!(Surface::polygon(&hollow, Twist::ZERO).is_err());
/// # Ok::<(), tribos::friction::FrictionError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Surface {
    sides: Vec<HalfPlane<f64>>,
    twist: Twist<f64>,
}

impl Surface {
    /// All that lies to the left of the line through `point` along `direction`.
    pub fn half_plane(
        point: [f64; 2],
        direction: [f64; 2],
        twist: Twist<f64>,
    ) -> Result<Self, FrictionError> {
        let side = HalfPlane::new(point, direction).map_err(tribos_core::Error::from)?;
        Ok(Self {
            sides: vec![side],
            twist,
        })
    }

    /// A convex polygon, its corners in either sense.
    pub fn polygon(corners: &[[f64; 2]], twist: Twist<f64>) -> Result<Self, FrictionError> {
        let count = corners.len();
        let turn = |i: usize| {
            let [a, b, c] = [i, i + 1, i + 2].map(|at| corners[at % count]);
            (b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0])
        };
        let turns: Vec<f64> = match count {
            0..3 => Vec::new(),
            _ => (0..count).map(turn).collect(),
        };
        let is_left = turns.iter().all(|turn| *turn > 0.0);
        if turns.is_empty() || !(is_left || turns.iter().all(|turn| *turn < 0.0)) {
            return Err(FrictionError::Syntax(
                "a surface is a half-plane or a convex polygon: give a hollow one in parts that move alike".into(),
            ));
        }
        let sides = (0..count).map(|i| {
            let (from, to) = (corners[i], corners[(i + 1) % count]);
            let (from, to) = if is_left { (from, to) } else { (to, from) };
            HalfPlane::new(from, [to[0] - from[0], to[1] - from[1]])
        });
        let sides: Result<Vec<_>, _> = sides.collect();
        Ok(Self {
            sides: sides.map_err(tribos_core::Error::from)?,
            twist,
        })
    }
}

/// One foot of a body: an area, its coefficients and load, where it stands on the body, and how its surface moves.
#[derive(Clone, Debug)]
pub struct FootOnFloor<'a> {
    /// The area, in coordinates of its own.
    pub area: &'a Area,
    /// Its coefficients of friction.
    pub mu: Coefficients,
    /// Its load, in N.
    pub load: f64,
    /// Where the origin of its coordinates lies on the body, in m.
    pub place: [f64; 2],
    /// The angle by which it is turned on the body, in degrees.
    pub degrees: f64,
    /// Motion of the surface under it.
    pub surface: Twist<f64>,
}

/// A body on an area that is cut by the borders of several surfaces, or on several feet.
///
/// *Units*: N, m, m/s, rad/s; twists and wrenches refer to the origin of the body's coordinates. *Accuracy*: that of
/// [`tribos_core::floor`].
///
/// ```
/// use tribos::friction::{Area, Coefficients, Floor, Surface};
/// use tribos::kernel::floor::SteadyState;
/// use tribos::prelude::*;
/// let parcel = Area::named(&"box:0.3x0.2".parse()?, 1.0, None)?;
/// // Its upper half lies on a belt, the other one on the ground.
/// let belt = Surface::half_plane([0.0, 0.0], [1.0, 0.0], Twist::new(0.5, 0.0, 0.0))?; // m; m/s
/// let floor = Floor::under(&parcel, &Coefficients::isotropic(0.4)?, 20.0, &[belt])?; // N
/// let held = floor.wrench(&Twist::ZERO);
/// assert!((held.force.x - 4.0).abs() < 1e-14 && (held.torque + 4.0 * 0.05).abs() < 1e-15);
/// let SteadyState::Balanced(motion) = floor.steady_motion(&Wrench::ZERO) else { panic!() };
/// assert!((motion.twist.velocity.x - 0.25).abs() < 1e-12 && motion.twist.spin < 0.0);
/// # Ok::<(), tribos::friction::FrictionError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Floor {
    feet: Vec<Foot<f64, Flat<f64>>>,
}

impl Floor {
    /// An area on surfaces of which the first counts where two lie over each other, and on a floor at rest where none
    /// lies.
    pub fn under(
        area: &Area,
        mu: &Coefficients,
        load: f64,
        surfaces: &[Surface],
    ) -> Result<Self, FrictionError> {
        let patch = mu.on(area.clone())?.into_flat()?;
        let limit = mu.largest() * load;
        let mut feet = Vec::new();
        let mut left = vec![PatchPiece { patch, share: 1.0 }];
        for surface in surfaces {
            let mut outside = Vec::new();
            for mut piece in left {
                // What lies beyond one side is outside; what is within all of them stands on the surface.
                let mut inside = true;
                for side in &surface.sides {
                    let beyond = within(&piece, &side.other_side())?;
                    outside.extend(beyond);
                    match within(&piece, side)? {
                        Some(rest) => piece = rest,
                        None => {
                            inside = false;
                            break;
                        }
                    }
                }
                if inside {
                    feet.push(foot(piece, limit, surface.twist));
                }
            }
            left = outside;
        }
        feet.extend(
            left.into_iter()
                .map(|piece| foot(piece, limit, Twist::ZERO)),
        );
        Self::new(feet)
    }

    /// A body on several feet.
    pub fn feet(feet: &[FootOnFloor<'_>]) -> Result<Self, FrictionError> {
        let feet = feet.iter().map(|foot| {
            let map = AffineMap::placed(super::coefficients::quarters(foot.degrees), foot.place);
            let patch = foot.mu.on(foot.area.clone())?.into_flat()?;
            let patch = patch
                .image(&map)
                .ok_or(tribos_core::patch::PatchError::NoImage)?;
            Ok(Foot {
                patch,
                limit: foot.mu.largest() * foot.load,
                surface: foot.surface,
            })
        });
        Self::new(feet.collect::<Result<_, FrictionError>>()?)
    }

    fn new(feet: Vec<Foot<f64, Flat<f64>>>) -> Result<Self, FrictionError> {
        Feet::new(&feet)?;
        Ok(Self { feet })
    }

    /// What `work` makes of the kernel's feet, which were valid when they were made.
    fn with<T>(&self, work: impl FnOnce(&Feet<'_, f64, Flat<f64>>) -> T) -> Option<T> {
        Feet::new(&self.feet).ok().map(|feet| work(&feet))
    }

    /// The feet: pieces of the area, or those that were given.
    #[doc(hidden)]
    pub fn parts(&self) -> &[Foot<f64, Flat<f64>>] {
        &self.feet
    }

    /// What all feet carry together, in N.
    pub fn limit(&self) -> f64 {
        self.feet.iter().map(|foot| foot.limit).sum()
    }

    /// The wrench on the body, in N and N m.
    pub fn wrench(&self, twist: &Twist<f64>) -> Wrench<f64> {
        self.with(|feet| feet.wrench(twist)).unwrap_or(Wrench::ZERO)
    }

    /// ∂wrench/∂twist, symmetric.
    pub fn wrench_jacobian(&self, twist: &Twist<f64>) -> WrenchJacobian<f64> {
        self.with(|feet| feet.wrench_and_jacobian(twist).1)
            .unwrap_or_else(WrenchJacobian::zeros)
    }

    /// The motion in which friction balances a push on the body.
    pub fn steady_motion(&self, push: &Wrench<f64>) -> SteadyState<f64> {
        self.with(|feet| feet.steady_motion(push))
            .unwrap_or(SteadyState::Accelerates)
    }

    /// The motion of a body after `dt`; `None` only without feet.
    pub fn step(
        &self,
        body: &PlanarBody<f64>,
        twist: &Twist<f64>,
        push: &Wrench<f64>,
        dt: TimeStep<f64>,
    ) -> Option<FloorStep<f64>> {
        self.with(|feet| feet.step(body, twist, push, dt))
    }

    /// All feet as one patch.
    #[doc(hidden)]
    pub fn area(&self) -> Result<Flat<f64>, FrictionError> {
        let part = |foot: &Foot<f64, Flat<f64>>| PatchPart {
            patch: foot.patch.clone(),
            load: foot.limit,
        };
        let parts: Vec<_> = self.feet.iter().map(part).collect();
        Ok(Flat::Feet(OwnedFeet::new(parts)?))
    }

    /// All wrenches that the feet carry together while body and surfaces move as one.
    pub fn limit_surface(&self) -> Result<Box<dyn FrictionSet<f64> + Send + Sync>, FrictionError> {
        Area::Flat(self.area()?).limit_surface(self.limit())
    }
}

/// A piece of a piece.
fn within(
    piece: &PatchPiece<f64, Flat<f64>>,
    side: &HalfPlane<f64>,
) -> Result<Option<PatchPiece<f64, Flat<f64>>>, FrictionError> {
    let part = piece.patch.within(side)?;
    Ok(part.map(|part| PatchPiece {
        share: piece.share * part.share,
        ..part
    }))
}

fn foot(
    piece: PatchPiece<f64, Flat<f64>>,
    limit: f64,
    surface: Twist<f64>,
) -> Foot<f64, Flat<f64>> {
    Foot {
        patch: piece.patch,
        limit: limit * piece.share,
        surface,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A disk on two belts, whose border runs off its middle, against a polygon of many corners of the same area.
    #[test]
    fn a_disk_on_two_belts_is_a_polygon_of_many_corners() {
        let count = 2000_usize;
        // The polygon of this radius has the area of the disk of radius 1.
        let angle = std::f64::consts::TAU / count as f64;
        let radius = (angle / libm_sin(angle)).sqrt();
        let corners: Vec<[f64; 2]> = (0..count)
            .map(|i| {
                let [cos, sin] =
                    super::super::coefficients::quarters(360.0 * i as f64 / count as f64);
                [radius * cos, radius * sin]
            })
            .collect();
        let polygon = Area::polygon(&[&corners], None).unwrap();
        let disk = Area::round(super::super::Patch::Disk, 1.0).unwrap();
        let belts = [
            ([0.2, 0.1], [0.8, 0.6], Twist::new(0.5, 0.2, 0.0)),
            ([-0.3, 0.0], [-1.0, 0.2], Twist::new(-0.4, 0.0, 0.7)),
        ];
        let belts = belts.map(|(at, along, twist)| Surface::half_plane(at, along, twist).unwrap());
        for mu in ["0.5", "0.5,0.2,30deg"] {
            let mu: Coefficients = mu.parse().unwrap();
            let [whole, many] =
                [&disk, &polygon].map(|area| Floor::under(area, &mu, 10.0, &belts).unwrap());
            assert_eq!(whole.parts().len(), 3);
            assert!((whole.limit() - 5.0).abs() < 1e-14);
            for twist in [[0.1, 0.2, 0.0], [0.5, 0.1, 1.0], [-0.1, 0.3, -2.0]] {
                let twist = Twist::new(twist[0], twist[1], twist[2]);
                let off = whole.wrench(&twist) - many.wrench(&twist);
                // The border of the polygon lies within 1e-6 of the circle.
                assert!(
                    off.force.norm() < 2e-6 && off.torque.abs() < 2e-6,
                    "{off:?}"
                );
            }
        }
    }

    fn libm_sin(x: f64) -> f64 {
        tribos_core::real::Real::sin(x)
    }

    #[test]
    fn feet_that_are_pieces_have_the_friction_of_the_whole() {
        let parcel = Area::named(&"box:0.3x0.2".parse().unwrap(), 1.0, None).unwrap();
        let mu = Coefficients::isotropic(0.4).unwrap();
        let still =
            Surface::polygon(&[[0.02, -0.05], [0.1, -0.03], [0.05, 0.07]], Twist::ZERO).unwrap();
        let [plain, cut] =
            [&[][..], &[still]].map(|all| Floor::under(&parcel, &mu, 20.0, all).unwrap());
        assert!(plain.parts().len() == 1 && cut.parts().len() == 4);
        for twist in [[0.1, 0.2, 0.0], [0.0, 0.0, 1.0], [-0.1, 0.3, -2.0]] {
            let twist = Twist::new(twist[0], twist[1], twist[2]);
            let off = plain.wrench(&twist) - cut.wrench(&twist);
            assert!(
                off.force.norm() < 1e-12 && off.torque.abs() < 1e-13,
                "{off:?}"
            );
        }
    }
}
