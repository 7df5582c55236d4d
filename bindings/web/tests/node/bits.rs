//! Digests of results of every function, computed natively from the numbers of `test/bits.mjs`.
//!
//! That file has the same chapters, calls the package in Node, and compares its digests with those that this
//! program leaves in `dist/bits.txt`. Neither side is a snapshot of the other.

use tribos_core::contact::{Attraction, TimeStep};
use tribos_core::floor::SteadyState;
use tribos_core::law::LocalLaw;
use tribos_core::limit_surface::UnknownPressureSet;
use tribos_core::patch::mesh::Vertex;
use tribos_core::patch::nodes::Node;
use tribos_core::planar::PlanarBody;
use tribos_core::slider::SliderParameters;
use tribos_core::twist::Twist;
use tribos_friction::{Area, Coefficients, Floor, FootOnFloor};
use tribos_web::all::contact::{ContactLaw, ContactParameters, GIVEN};
use tribos_web::all::launches::LaunchTarget;
use tribos_web::all::prepared::Prepared;
use tribos_web::all::store::{self, Item};
use tribos_web::friction::{self, nine, row_of, row_of_twist, twist_of, wrench_of};
use tribos_web::patch::Patch;
use tribos_web::planar::{Stepper, Trajectory, to_rest};
use tribos_web::slide::LaunchedBody;
use tribos_web::surface::{ELLIPSOID, EXACT, Surface, meridian, projected, shape};

const CALLS: usize = 1000;
/// Calls of what takes long.
const FEW: usize = 50;
const SEPARATE: u32 = 2;
const OIL: &str = "stribeck:mu_s=0.4,mu_d=0.2,vs=0.05";
const NOTCH: [[f64; 2]; 5] = [[0.0, 0.0], [0.4, 0.0], [0.4, 0.3], [0.2, 0.1], [0.0, 0.3]];
const HOLE: [[f64; 2]; 4] = [[0.05, 0.02], [0.1, 0.02], [0.1, 0.05], [0.05, 0.05]];

/// Numbers of one chapter, and the digest of its results.
struct Chapter {
    state: u32,
    hash: [u32; 2],
}

impl Chapter {
    fn new(seed: u32) -> Self {
        let hash = [0x811c_9dc5, 0x9747_b28c];
        Self { state: seed, hash }
    }

    /// From 0 to 1: Mulberry32 (Tommy Ettinger).
    fn next(&mut self) -> f64 {
        self.state = self.state.wrapping_add(0x6d2b_79f5);
        let mut t = (self.state ^ (self.state >> 15)).wrapping_mul(1 | self.state);
        t = t.wrapping_add((t ^ (t >> 7)).wrapping_mul(61 | t)) ^ t;
        f64::from(t ^ (t >> 14)) / 4_294_967_296.0
    }

    fn positive(&mut self, most: f64) -> f64 {
        (1.0 - self.next()) * most
    }

    /// Of either sign; zero at times.
    fn signed(&mut self, most: f64) -> f64 {
        let value = (2.0 * self.next() - 1.0) * most;
        if self.next() < 0.1 { 0.0 } else { value }
    }

    fn three(&mut self, most: f64) -> [f64; 3] {
        [(); 3].map(|()| self.signed(most))
    }

    fn twist(&mut self) -> [f64; 3] {
        [2.0, 2.0, 50.0].map(|most| self.signed(most))
    }

    fn push(&mut self, force: f64, torque: f64) -> [f64; 3] {
        [force, force, torque].map(|most| self.signed(most))
    }

    /// Takes results in.
    fn add(&mut self, values: &[f64]) {
        for value in values {
            // One NaN for all.
            let bits = if value.is_nan() {
                0x7ff8_0000_0000_0000
            } else {
                value.to_bits()
            };
            for word in [bits as u32, (bits >> 32) as u32] {
                let factors = [0x0100_0193, 0x5bd1_e995];
                for (hash, factor) in self.hash.iter_mut().zip(factors) {
                    *hash = (*hash ^ word).rotate_left(13).wrapping_mul(factor);
                }
            }
        }
    }

    fn add_flag(&mut self, flag: bool) {
        self.add(&[f64::from(u8::from(flag))]);
    }
}

/// Friction of the package: its patch as the boundary names it, coefficient and radius.
#[derive(Clone, Copy)]
struct Friction {
    patch: Patch,
    mu: f64,
    radius: f64,
}

fn plain(radius: f64, mu: f64) -> Friction {
    let handle = 0;
    let patch = Patch { handle, radius, mu };
    Friction { patch, mu, radius }
}

fn made(area: Area, law: &str) -> Friction {
    let prepared = Prepared::new(area, law).unwrap();
    let (radius, [mu, _]) = (prepared.area.radius(), prepared.power());
    let handle = store::keep(Item::Patch(Box::new(prepared)));
    let patch = Patch { handle, radius, mu };
    Friction { patch, mu, radius }
}

fn round(name: &str, law: &str) -> Friction {
    made(Area::round(name.parse().unwrap(), 0.04).unwrap(), law)
}

fn points(points: &[[f64; 3]]) -> Area {
    let node = |&[x, y, weight]: &[f64; 3]| Node { x, y, weight };
    Area::points(points.iter().map(node).collect()).unwrap()
}

fn mesh(vertices: &[[f64; 3]], triangles: &[[usize; 3]]) -> Area {
    let vertex = |&[x, y, pressure]: &[f64; 3]| Vertex { x, y, pressure };
    let vertices: Vec<_> = vertices.iter().map(vertex).collect();
    Area::mesh(&vertices, triangles).unwrap()
}

fn friction_of(chapter: &mut Chapter, friction: Friction, count: usize) {
    for _ in 0..count {
        let (twist, load) = (twist_of(chapter.twist()), chapter.positive(10.0));
        let (wrench, jacobian) = friction
            .patch
            .contact(|contact| {
                (
                    row_of(&contact.wrench(load, &twist)),
                    nine(&contact.jacobian(load, &twist)),
                )
            })
            .unwrap();
        chapter.add(&wrench);
        chapter.add(&jacobian);
    }
}

fn batches_of(chapter: &mut Chapter, friction: Friction) {
    let twists: Vec<[f64; 3]> = (0..CALLS).map(|_| chapter.twist()).collect();
    let loads: Vec<f64> = (0..CALLS).map(|_| chapter.positive(10.0)).collect();
    let work = |contact: &dyn friction::Contact| {
        let (mut rows, mut jacobians) = (twists.clone(), vec![[0.0; 9]; CALLS]);
        friction::wrenches(contact, 2.0, &mut rows);
        chapter.add(rows.as_flattened());
        for (twist, load) in twists.iter().zip(&loads) {
            chapter.add(&row_of(&contact.wrench(*load, &twist_of(*twist))));
        }
        friction::jacobians(contact, 2.0, &twists, &mut jacobians);
        chapter.add(jacobians.as_flattened());
        for (twist, load) in twists.iter().zip(&loads) {
            chapter.add(&nine(&contact.jacobian(*load, &twist_of(*twist))));
        }
    };
    friction.patch.contact(work).unwrap();
}

/// A surface of the package.
fn surface(friction: Friction, load: f64, model: u32) -> Surface {
    let [lever, spin_torque] = match model {
        EXACT => [1.0; 2],
        _ => shape(friction.patch).unwrap(),
    };
    Surface {
        patch: friction.patch,
        force_limit: friction.mu * load,
        model,
        lever,
        spin_torque,
    }
}

fn surface_of(chapter: &mut Chapter, friction: Friction, model: u32, count: usize) {
    for _ in 0..count {
        let surface = surface(friction, chapter.positive(10.0), model);
        let (push, twist) = (chapter.push(5.0, 0.2), twist_of(chapter.twist()));
        let (push, length) = (wrench_of(push), chapter.positive(0.1));
        let work = |set: &dyn tribos_core::limit_surface::FrictionSet<f64>| {
            chapter.add(&[set.gauge(&push)]);
            chapter.add(&row_of_twist(&set.twist_normal_to(&push)));
            chapter.add(&row_of(&set.scale_to_surface(&push)));
            chapter.add(&projected(&set.project_with_length(&push, length)));
            chapter.add(&[set.support(&twist)]);
            chapter.add(&row_of(&set.wrench(&twist)));
            chapter.add_flag(set.contains(&push));
        };
        surface.with(work).unwrap();
    }
    let mut rows = [[0.0; 3]; 33];
    let curve = surface(friction, 2.0, EXACT);
    curve.with(|set| meridian(set, 0.7, &mut rows)).unwrap();
    chapter.add(rows.as_flattened());
}

fn steps_of(chapter: &mut Chapter, friction: Friction, model: u32) {
    sticking_steps_of(chapter, friction, model, 1.0);
}

fn sticking_steps_of(chapter: &mut Chapter, friction: Friction, model: u32, strength: f64) {
    let (mass, inertia) = (0.5, 0.003);
    let surface = surface(friction, 4.0, model);
    for _ in 0..CALLS {
        let (twist, push) = (chapter.twist(), chapter.push(3.0, 0.1));
        let (dt, angle) = (chapter.positive(0.05), chapter.signed(3.0));
        // It does not matter to a round patch.
        let angle = if surface.patch.turns() { angle } else { 0.0 };
        let stepper = Stepper::new(mass, inertia, dt).unwrap().sticking(strength);
        for twist in [twist, [0.0; 3]] {
            let step = surface.with(|set| stepper.step(set, angle, twist, push));
            chapter.add(&step.unwrap().row());
        }
    }
    for _ in 0..FEW {
        let (twist, push) = (chapter.twist(), chapter.push(3.0, 0.1));
        let pose = [1.0, 1.0, 3.0].map(|most| chapter.signed(most));
        let stepper = Stepper::new(mass, inertia, 0.01)
            .unwrap()
            .sticking(strength);
        for (push, pose, steps) in [(push, pose, 20), ([0.0; 3], [0.0; 3], 100)] {
            let course = Trajectory {
                twist,
                pose,
                push,
                turns: surface.patch.turns(),
            };
            let mut rows = vec![[0.0; 7]; steps + 1];
            let count = surface.with(|set| course.follow(set, &stepper, &mut rows));
            chapter.add(rows[..count.unwrap()].as_flattened());
        }
    }
}

fn slides_of(chapter: &mut Chapter, friction: Friction) {
    for _ in 0..FEW {
        let (mass, inertia) = (chapter.positive(2.0), chapter.positive(0.01));
        let thrown = LaunchedBody {
            parameters: parameters(friction, mass, inertia),
            twist: chapter.twist(),
        };
        let patch = friction.patch;
        let rest = patch.glides(|patch| thrown.rest(patch));
        chapter.add(&rest.unwrap());
        let time = chapter.positive(0.5);
        let after = patch.glides(|patch| thrown.after(patch, time));
        chapter.add(&after.unwrap());
        let mut rows = [[0.0; 7]; 5];
        patch.glides(|patch| thrown.path(patch, &mut rows)).unwrap();
        chapter.add(rows.as_flattened());
    }
}

fn parameters(friction: Friction, mass: f64, inertia: f64) -> SliderParameters<f64> {
    let load = mass * 9.81;
    SliderParameters {
        deceleration: friction.mu * load / mass,
        radius: friction.radius,
        inertia_ratio: inertia / (mass * friction.radius * friction.radius),
    }
}

fn modes_of(chapter: &mut Chapter, friction: Friction) {
    for _ in 0..CALLS {
        let (inertia, initial) = (chapter.positive(1.0), chapter.positive(3.0));
        let made = friction.patch.glides(|patch| patch.modes(inertia, initial));
        let [least, most, spinning, ratio, between, sliding, last] = made.unwrap().row();
        chapter.add(&[least, most, last, 0.0, spinning]);
        if !ratio.is_nan() {
            chapter.add(&[ratio, between]);
        }
        chapter.add(&[f64::INFINITY, sliding]);
    }
}

fn disk() -> Friction {
    plain(0.04, 0.3)
}

fn disk_of_a_power(chapter: &mut Chapter) {
    let friction = round("disk", "power:gamma=0.3,alpha=0.5");
    friction_of(chapter, friction, CALLS);
    batches_of(chapter, friction);
    slides_of(chapter, friction);
    modes_of(chapter, friction);
}

fn disk_approximations(chapter: &mut Chapter) {
    for model in [ELLIPSOID, SEPARATE] {
        surface_of(chapter, disk(), model, CALLS);
    }
    for model in [ELLIPSOID, SEPARATE] {
        steps_of(chapter, disk(), model);
    }
}

fn round_patches(chapter: &mut Chapter) {
    let annulus = format!("annulus:{}", 0.03 / 0.04);
    let names = [
        "ring",
        &annulus,
        "hertz",
        "punch",
        "paraboloid",
        "power:0.25",
        "polynomial:1,-0.5",
    ];
    for name in names {
        let friction = round(name, "coulomb:mu=0.3");
        friction_of(chapter, friction, CALLS);
        surface_of(chapter, friction, EXACT, FEW);
        slides_of(chapter, friction);
        modes_of(chapter, friction);
    }
}

fn polygon(chapter: &mut Chapter) {
    let area = Area::polygon(&[&NOTCH, &HOLE], None).unwrap();
    chapter.add(&[area.radius()]);
    chapter.add(&area.centre());
    let friction = made(area, "coulomb:mu=0.5");
    friction_of(chapter, friction, CALLS);
    surface_of(chapter, friction, EXACT, FEW);
    steps_of(chapter, friction, EXACT);
    sticking_steps_of(chapter, friction, EXACT, 0.8 / 0.5);
    let (mass, inertia) = (2.0, 0.05);
    let surface = surface(friction, mass * 9.81, EXACT);
    for _ in 0..5 {
        let mut rows = [[0.0; 7]; 400];
        let count = to_rest(&surface, [mass, inertia], chapter.twist(), 50, &mut rows).unwrap();
        chapter.add(rows[..count].as_flattened());
    }
}

fn other_straight_edges(chapter: &mut Chapter) {
    let notch = Area::polygon(&[&NOTCH], None).unwrap();
    friction_of(chapter, made(notch, "power:gamma=0.5,alpha=0.5"), CALLS);
    let (x, y) = (0.15, 0.1);
    let corners = [[-x, -y], [x, -y], [x, y], [-x, y]];
    let feet = [[0.0, 0.0, 1.0], [0.1, 0.0, 1.0], [0.0, 0.1, 2.0]];
    let tile = [
        [0.0, 0.0, 1.0],
        [0.1, 0.0, 2.0],
        [0.1, 0.1, 0.5],
        [0.0, 0.1, 0.0],
    ];
    let areas = [
        Area::polygon(&[&corners], Some([0.02, 0.0])).unwrap(),
        Area::bar([-0.1, 0.0], [0.1, 0.0]).unwrap(),
        points(&feet),
        mesh(&tile, &[[0, 1, 2], [0, 2, 3]]),
    ];
    for area in areas {
        let friction = made(area, "coulomb:mu=0.5");
        friction_of(chapter, friction, CALLS);
        surface_of(chapter, friction, EXACT, FEW);
    }
    friction_of(chapter, made(points(&feet), OIL), CALLS);
}

/// Friction under the larger of two coefficients.
fn tread(area: Area) -> Friction {
    let mu = tread_coefficients();
    made(mu.on(area).unwrap(), "coulomb:mu=0.9")
}

fn tread_coefficients() -> Coefficients {
    Coefficients::along_and_across([0.5, 0.9], 0.3).unwrap()
}

fn named(name: &str) -> Area {
    Area::named(&name.parse().unwrap(), 1.0, None).unwrap()
}

fn floor_of(chapter: &mut Chapter, floor: &Floor) {
    chapter.add(&[floor.limit(), floor.parts().len() as f64]);
    for _ in 0..FEW {
        let twist = twist_of(chapter.twist());
        chapter.add(&row_of(&floor.wrench(&twist)));
        chapter.add(&nine(&floor.wrench_jacobian(&twist)));
        let push = wrench_of(chapter.push(0.5, 0.05));
        let SteadyState::Balanced(found) = floor.steady_motion(&push) else {
            panic!("no push is too large here")
        };
        chapter.add(&row_of_twist(&found.twist));
        chapter.add(&row_of(&found.friction));
        let carried_by = found.carried_by.map_or(-1.0, |foot| foot as f64);
        chapter.add(&[carried_by, found.evaluations as f64]);
        let body = PlanarBody::new(chapter.positive(2.0), chapter.positive(0.01)).unwrap();
        let (from, push) = (twist_of(chapter.twist()), wrench_of(chapter.push(9.0, 0.5)));
        let dt = TimeStep::new(chapter.positive(0.05)).unwrap();
        let end = floor.step(&body, &from, &push, dt).unwrap();
        chapter.add(&row_of_twist(&end.twist));
        chapter.add(&row_of(&end.friction));
        let carried_by = end.carried_by.map_or(-1.0, |foot| foot as f64);
        chapter.add(&[carried_by, end.imbalance]);
        let set = floor.limit_surface().unwrap();
        let nearest = set.project_with_length(&push, chapter.positive(0.1));
        chapter.add(&[set.gauge(&push)]);
        chapter.add(&row_of_twist(&set.twist_normal_to(&push)));
        chapter.add(&row_of(&nearest.wrench));
    }
}

fn floors(chapter: &mut Chapter) {
    let disk = |radius| Area::round(tribos_friction::Patch::Disk, radius).unwrap();
    let notch = || Area::polygon(&[&NOTCH], None).unwrap();
    let worn = || {
        let name = format!("worn-annulus:{}", 0.03 / 0.04);
        Area::round(name.parse().unwrap(), 0.04).unwrap()
    };
    let all = [
        made(named("ellipse:0.3x0.2"), "coulomb:mu=0.5"),
        made(named("hertz-ellipse:0.2x0.3"), "coulomb:mu=0.5"),
        made(named("bolts:5x0.1"), "coulomb:mu=0.5"),
        tread(disk(0.1)),
        tread(named("hertz-ellipse:0.3x0.2")),
        tread(notch()),
        made(worn(), "coulomb:mu=0.3"),
    ];
    for friction in all {
        let centre = store::with(friction.patch.handle, |patch| Ok(patch.area.centre()));
        chapter.add(&[friction.mu, friction.radius]);
        chapter.add(&centre.unwrap());
        friction_of(chapter, friction, FEW);
        surface_of(chapter, friction, EXACT, FEW);
    }
    let one = |mu| Coefficients::isotropic(mu).unwrap();
    let pierced = Area::polygon(&[&NOTCH, &HOLE], None).unwrap();
    let areas = [
        (pierced, one(0.5)),
        (notch(), tread_coefficients()),
        (disk(0.04), one(0.3)),
    ];
    for (area, mu) in &areas {
        for _ in 0..5 {
            let [first, second] = [(); 2].map(|()| twist_of(chapter.twist()));
            let plate = [[0.1, 0.05], [0.3, 0.05], [0.3, 0.2], [0.1, 0.2]];
            let surfaces = [
                tribos_friction::Surface::half_plane([0.0, 0.15], [0.4, 0.12 - 0.15], first),
                tribos_friction::Surface::polygon(&plate, second),
                tribos_friction::Surface::half_plane([0.2, 0.0], [0.0, 0.1], Twist::ZERO),
            ];
            let surfaces = surfaces.map(Result::unwrap);
            floor_of(chapter, &Floor::under(area, mu, 20.0, &surfaces).unwrap());
        }
    }
    let areas = [
        (disk(0.04), one(0.3)),
        (named("ellipse:0.3x0.2"), one(0.5)),
        (notch(), tread_coefficients()),
        (worn(), one(0.3)),
        (named("box:0.3x0.2"), one(0.4)),
    ];
    for _ in 0..10 {
        let feet: Vec<_> = areas
            .iter()
            .map(|(area, mu)| FootOnFloor {
                area,
                mu: *mu,
                load: chapter.positive(9.0),
                place: [chapter.signed(1.0), chapter.signed(1.0)],
                degrees: chapter.signed(180.0),
                surface: twist_of(chapter.twist()),
            })
            .collect();
        floor_of(chapter, &Floor::feet(&feet).unwrap());
    }
}

fn law(chapter: &mut Chapter) {
    let law: tribos_friction::Law = OIL.parse().unwrap();
    let law = law.build::<f64>().unwrap();
    let speeds: Vec<f64> = (0..CALLS).map(|_| chapter.signed(1.0)).collect();
    for speed in &speeds {
        chapter.add(&[law.friction(speed.abs()), law.slope(speed.abs())]);
    }
    for speed in &speeds {
        chapter.add(&[law.friction(speed.abs())]);
    }
}

fn launches(chapter: &mut Chapter) {
    let ring = made(
        Area::round("ring".parse().unwrap(), 0.08).unwrap(),
        "coulomb:mu=0.3",
    );
    for friction in [plain(0.08, 0.3), ring] {
        for call in 0..10 {
            let [x, y, angle] = [
                chapter.positive(1.0),
                chapter.signed(1.0),
                chapter.signed(3.0),
            ];
            let wanted = LaunchTarget {
                parameters: parameters(friction, 0.5, 0.0016),
                pose: [x, y, angle],
                max_speed: 10.0,
                max_spin: 200.0,
                symmetry: std::num::NonZeroU32::new(1 - call % 2),
            };
            let mut rows = [[0.0; 8]; 20];
            let count = wanted.launches(friction.patch.handle, &mut rows).unwrap();
            chapter.add(rows[..count].as_flattened());
        }
    }
}

fn any_pressure(chapter: &mut Chapter) {
    let corners = vec![[-0.1, -0.05], [0.2, -0.05], [0.2, 0.1], [-0.1, 0.05]];
    let support = UnknownPressureSet::new(corners, [0.03, 0.01], 5.0).unwrap();
    chapter.add(&[support.radius()]);
    for _ in 0..CALLS {
        let twist = twist_of(chapter.twist());
        chapter.add(&[support.support(&twist)]);
        chapter.add(&row_of(&support.wrench(&twist)));
    }
    for _ in 0..FEW {
        let force = [(); 2].map(|()| chapter.signed(6.0));
        let limits = support.torque_limits(force);
        let limits = limits.map_or([f64::NAN; 4], |limits| {
            let ([low, high], [lower, higher]) = (limits.certain, limits.possible);
            [low, high, lower, higher]
        });
        chapter.add(&limits);
        let push = wrench_of(chapter.push(6.0, 0.5));
        chapter.add(&support.gauge_bounds(&push));
    }
}

fn contacts(chapter: &mut Chapter) {
    let given = ContactParameters {
        coefficients: [0.3, 0.01, 0.02],
        patch: ("", 1.0),
        restitution: 0.5,
        cohesion: [0.0; 2],
        attraction: Attraction::Pull,
    };
    let coupled = ContactParameters {
        coefficients: [0.3, 0.0, 0.0],
        restitution: 0.0,
        ..given
    };
    let laws = [
        given,
        ContactParameters {
            patch: ("disk", 0.1),
            cohesion: [0.1, 0.0],
            ..coupled
        },
        ContactParameters {
            patch: ("annulus:0.5", 0.1),
            ..coupled
        },
        ContactParameters {
            patch: ("polynomial:1,-0.5", 0.1),
            ..coupled
        },
    ];
    for law in laws {
        let law = ContactLaw::new(&law).unwrap();
        for call in 0..CALLS {
            let mut row = [0.0; GIVEN];
            row[17] = 1.0;
            let is_spheres = call % 2 == 0;
            for at in [0, 9] {
                if at == 0 || is_spheres {
                    row[at..at + 3].copy_from_slice(&chapter.three(2.0));
                    row[at + 3..at + 6].copy_from_slice(&chapter.three(50.0));
                    let (mass, radius) = (chapter.positive(1.0), 0.01 + chapter.positive(0.1));
                    let inertia = 0.4 * mass * radius * radius;
                    row[at + 6..at + 9].copy_from_slice(&[1.0 / mass, 1.0 / inertia, radius]);
                } else {
                    row[at..at + 3].copy_from_slice(&chapter.three(1.0));
                }
            }
            let gap = chapter.signed(1e-3);
            row[18..22].copy_from_slice(&[0.6, 0.0, -0.8, gap]);
            let hit = if is_spheres {
                law.spheres(&row, 1e-3)
            } else {
                law.plate(&row, 1e-3)
            };
            chapter.add(&hit.unwrap());
        }
    }
}

/// Computes a chapter.
type Run = Box<dyn Fn(&mut Chapter)>;

/// All chapters, those of both modules first.
fn chapters() -> Vec<(&'static str, Run)> {
    vec![
        (
            "disk friction",
            Box::new(|chapter| friction_of(chapter, disk(), CALLS)),
        ),
        (
            "disk batches",
            Box::new(|chapter| batches_of(chapter, disk())),
        ),
        (
            "disk surface",
            Box::new(|chapter| surface_of(chapter, disk(), EXACT, CALLS)),
        ),
        (
            "disk steps",
            Box::new(|chapter| steps_of(chapter, disk(), EXACT)),
        ),
        (
            "disk slides",
            Box::new(|chapter| slides_of(chapter, disk())),
        ),
        ("disk modes", Box::new(|chapter| modes_of(chapter, disk()))),
        ("disk of a power", Box::new(disk_of_a_power)),
        (
            "disk of stribeck",
            Box::new(|chapter| friction_of(chapter, round("disk", OIL), FEW)),
        ),
        ("disk approximations", Box::new(disk_approximations)),
        ("round patches", Box::new(round_patches)),
        ("polygon", Box::new(polygon)),
        ("other straight edges", Box::new(other_straight_edges)),
        ("floors", Box::new(floors)),
        ("law", Box::new(law)),
        ("launches", Box::new(launches)),
        ("any pressure", Box::new(any_pressure)),
        ("contacts", Box::new(contacts)),
    ]
}

/// Lines of digest and name.
pub fn digests() -> String {
    let mut lines = String::new();
    for (seed, (name, run)) in (1..).zip(chapters()) {
        let mut chapter = Chapter::new(seed);
        run(&mut chapter);
        let [first, second] = chapter.hash;
        lines += &format!("{first:08x}{second:08x} {name}\n");
    }
    lines
}
