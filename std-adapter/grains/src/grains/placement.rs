//! The start: grains that touch neither each other nor a wall, at random places of a lattice.

use super::container::has_room;
use crate::grains::scene::{Container, EndBoundary, GrainsScene, SideBoundary};
use crate::packing::{InitialSpheres, Kinds, PlacementError, Radii};
use nalgebra::Vector3;
use std::ops::ControlFlow;
use tribos_base::random::Random;
use tribos_base::space::PeriodicBox;
use tribos_contacts::cd::MovingMesh;

/// Streams of the seed: one for the radii, one for the places.
const RADII: u64 = 0;
const PLACES: u64 = 1;
/// Share of the height that the rounding of the highest place may exceed.
const FULL: f64 = 1e-9;
/// Grains between two reports of the placement.
const BATCH: usize = 1000;

/// Radii and places of a scene's grains; `watch` receives the number placed so far and can stop.
///
/// The box is divided into equal places of at least `initial_spacing` diameters of the largest grain, which are
/// filled from below. In its place a grain sits at random where it does not leave it.
pub(super) fn start(
    (scene, mesh): (&GrainsScene, Option<&MovingMesh>),
    mut watch: impl FnMut(usize) -> ControlFlow<()>,
) -> Result<InitialSpheres, PlacementError> {
    let distribution = scene.radii()?;
    let distribution = distribution.as_ref();
    let largest = distribution.map_or(1.0 + scene.radius_spread, |radii| radii.bounds()[1]);
    let mixture = scene.mixture();
    let sizes = mixture.drawn().map(|component| component.radius);
    let lattice = Lattice::of(scene, sizes.fold(0.0, f64::max) * largest)?;
    let kinds = Kinds::of(mixture.draw(scene.seed, scene.count), &mixture);
    let mut radii = radii(scene, distribution);
    for (radius, kind) in radii.iter_mut().zip(&kinds.materials) {
        *radius *= mixture.components()[mixture.index(*kind)].radius;
    }
    let mut random = Random::new(scene.seed, PLACES);
    let mut positions = Vec::with_capacity(scene.count);
    let [floor, lid] = scene.carpets();
    let rise = Vector3::z() * (floor + scene.initial_height);
    let highest = scene
        .height
        .filter(|_| scene.boundary_z != EndBoundary::Floor);
    // Places outside a container, in a mesh or an intruder stay empty.
    let mut index = 0;
    while let Some(&radius) = radii.get(positions.len()) {
        if index % BATCH == 0 && watch(positions.len()).is_break() {
            return Err(PlacementError::Stopped);
        }
        let place = lattice.place(index, radius, &mut random) + rise;
        if has_room(scene, &place, radius) && is_clear((scene, mesh), &place, radius) {
            positions.push(place);
        }
        index += 1;
        let is_drum = scene.container == Container::Drum;
        let top = if is_drum {
            Some(scene.width + 2.0 * radius)
        } else {
            highest.map(|high| high - lid)
        };
        if top.is_some_and(|top| place.z + radius > top * (1.0 + FULL))
            && positions.len() < scene.count
        {
            let (given, room) = (scene.count, positions.len());
            return Err(PlacementError::Full {
                given,
                room,
                is_drum,
            });
        }
    }
    Ok(InitialSpheres {
        positions,
        radii,
        periods: [None; 3],
        kinds,
        contacts: Vec::new(),
        frozen: None,
    })
}

/// Whether a grain meets neither the intruder nor the mesh at a place.
fn is_clear(
    (scene, mesh): (&GrainsScene, Option<&MovingMesh>),
    place: &Vector3<f64>,
    radius: f64,
) -> bool {
    if scene.intruder_radius.is_none() && mesh.is_none() {
        return true;
    }
    let along = |is_periodic: bool, length: f64| is_periodic.then_some(length);
    let space = PeriodicBox::new([
        along(scene.boundary_x == SideBoundary::Periodic, scene.width),
        along(
            scene.boundary_y == SideBoundary::Periodic && !scene.is_flat(),
            scene.box_depth(),
        ),
        None,
    ]);
    // A box without room for its periods is refused later.
    let Ok(space) = space else { return true };
    let meets =
        |(at, size): (Vector3<f64>, f64)| space.displacement(&at, place).norm() < size + radius;
    let at_mesh = |mesh: &MovingMesh| !mesh.at(0.0).meetings(&space, place, radius).is_empty();
    !scene.intruder().is_some_and(meets) && !mesh.is_some_and(at_mesh)
}

/// Radii of a distribution, or uniform within their spread.
fn radii(scene: &GrainsScene, distribution: Option<&Radii>) -> Vec<f64> {
    let mut random = Random::new(scene.seed, RADII);
    let mut radius = || {
        if let Some(distribution) = distribution {
            return scene.radius * distribution.at(random.unit());
        }
        let share = 2.0 * random.unit() - 1.0;
        scene.radius * (1.0 + scene.radius_spread * share)
    };
    (0..scene.count).map(|_| radius()).collect()
}

/// Places for single grains.
struct Lattice {
    /// Number of places along x and y.
    across: [usize; 2],
    /// Lengths of a place.
    cell: Vector3<f64>,
    flat: bool,
}

impl Lattice {
    /// Places for grains up to `largest` mean radii.
    fn of(scene: &GrainsScene, largest: f64) -> Result<Self, PlacementError> {
        let needed = 2.0 * scene.radius * largest * scene.initial_spacing;
        let flat = scene.is_flat();
        let divide = |axis: &'static str, given: f64| {
            let places = (given / needed).floor();
            if places < 1.0 {
                return Err(PlacementError::NarrowBox {
                    axis,
                    given,
                    needed,
                });
            }
            Ok(places)
        };
        let nx = divide("x", scene.width)?;
        let depth = scene.box_depth();
        let ny = if flat { 1.0 } else { divide("y", depth)? };
        // A grain must not meet its own image.
        let lonely =
            |sides: SideBoundary, places: f64| sides == SideBoundary::Periodic && places < 2.0;
        for (axis, sides, places, given) in [
            ("x", scene.boundary_x, nx, scene.width),
            ("y", scene.boundary_y, if flat { 2.0 } else { ny }, depth),
        ] {
            if lonely(sides, places) {
                let needed = 2.0 * needed;
                return Err(PlacementError::NarrowBox {
                    axis,
                    given,
                    needed,
                });
            }
        }
        let (mut high, mut rise) = (f64::INFINITY, needed);
        if let (Some(height), EndBoundary::Walls | EndBoundary::Periodic) =
            (scene.height, scene.boundary_z)
        {
            let [floor, lid] = scene.carpets();
            let height = height - floor - lid - scene.initial_height;
            high = divide("z", height)?;
            rise = rise.max(if scene.boundary_z == EndBoundary::Periodic {
                height / high
            } else {
                needed
            });
        }
        let room = nx * ny * high;
        if (scene.count as f64) > room {
            return Err(PlacementError::Full {
                given: scene.count,
                room: room as usize,
                is_drum: false,
            });
        }
        Ok(Self {
            across: [nx, ny].map(|places| places as usize),
            cell: Vector3::new(scene.width / nx, depth / ny, rise),
            flat,
        })
    }

    /// The centre of a grain in one of the places, which count along x, then y, then z.
    fn place(&self, index: usize, radius: f64, random: &mut Random) -> Vector3<f64> {
        let [nx, ny] = self.across;
        let number = [index % nx, index / nx % ny, index / (nx * ny)];
        let mut along = |axis: usize| {
            let cell = self.cell[axis];
            let free = cell - 2.0 * radius;
            number[axis] as f64 * cell + radius + free * random.unit()
        };
        let [x, y, z] = [0, 1, 2].map(&mut along);
        Vector3::new(x, if self.flat { 0.0 } else { y }, z)
    }
}
