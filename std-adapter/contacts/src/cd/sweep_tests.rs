//! Sweeps by several threads against the sweep of one contact after the other.

use super::internals::{
    Accelerated, GlobalChange, Link, Monitor, Operator, Spheres, Tolerance, Visit,
};
use super::schedule::BLOCK;
use super::solid;
use super::sweep::WORTHWHILE;
use nalgebra::Vector3;
use tribos_base::random::Random;
use tribos_core::contact::{
    Attraction, Cohesion, Contact, ContactFriction, ContactGeometry, IndependentFriction,
    NormalLaw, SphereBody,
};

/// Spheres, several blocks of them, and pairs whose numbers differ by so much at most: enough of them lie inside
/// of blocks to be shared among threads, and many join two blocks.
const SPHERES: usize = 5_000;
const PAIRS: usize = 16_000;
const REACH: usize = 300;

/// Half widths of the radii around 1: alike spheres, and spheres of all sizes.
const SPREADS: [f64; 2] = [0.0, 0.8];

/// Spheres with random velocities, and contacts in random directions.
fn tangle<F: ContactFriction<f64>>(friction: F, spread: f64) -> Spheres<F> {
    let mut random = Random::new(7, 1);
    let mut number = |below: usize| (random.unit() * below as f64) as usize;
    let mut vector =
        |size: f64| Vector3::from([(); 3].map(|()| size * (number(2_001) as f64 / 1_000.0 - 1.0)));
    let mut problem = Spheres::new([friction; 2]);
    let mut radii = Vec::new();
    for at in 0..SPHERES {
        let (velocity, spin) = (vector(1.0), vector(1.0));
        radii.push(1.0 + spread * libm::sin(at as f64));
        problem.free.0.push(SphereBody {
            velocity,
            spin,
            ..solid(radii[at], 1.0)
        });
    }
    let cohesion = Cohesion::new(2.0, 0.01, Attraction::Pull).expect("cohesion is valid");
    let law = NormalLaw::new(cohesion, 0.0).expect("the law is valid");
    let mut random = Random::new(8, 1);
    let mut number = |below: usize| (random.unit() * below as f64) as usize;
    let mut taken = Vec::new();
    while taken.len() < PAIRS {
        let a = number(SPHERES);
        let b = a + 1 + number(REACH);
        if b < SPHERES {
            taken.push([a, b]);
        }
    }
    taken.sort_unstable();
    taken.dedup();
    let inside = taken.iter().filter(|[a, b]| a / BLOCK == b / BLOCK).count();
    assert!(inside >= WORTHWHILE && taken.len() - inside > 1_000);
    for [a, b] in taken {
        let [first, second] = [radii[a], radii[b]];
        let gap = -0.01 + 0.03 * number(1_000) as f64 / 1_000.0;
        let apart = vector(1.0).normalize() * (first + second + gap);
        let touch = ContactGeometry::spheres(&apart, [first, second]).expect("they are apart");
        let [first, second] = [a, b].map(|body| &problem.free.0[body]);
        let contact = Contact::new(&touch, &law, first, second, 0.01);
        let bodies = [a as u32, b as u32];
        problem.join(&Link { bodies, contact });
    }
    problem.start();
    problem
}

/// Whether pairs are solved four at a time.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Lanes {
    Four,
    One,
}

/// Impulses, motions and what a monitor saw after some sweeps to and fro.
fn swept<F: ContactFriction<f64>>(
    threads: usize,
    lanes: Lanes,
    friction: F,
    spread: f64,
) -> String {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
    pool.expect("threads can be made").install(|| {
        let mut problem = tangle(friction, spread);
        if lanes == Lanes::One {
            problem.without_lanes();
            assert_eq!(problem.lane_pairs(), 0);
        } else {
            assert!(10 * problem.lane_pairs() > 9 * problem.pairs.len());
        }
        let mut seen = Vec::new();
        for visit in [Visit::Forward, Visit::Backward, Visit::Forward] {
            let mut watch = GlobalChange::default();
            problem.sweep(visit, &mut watch);
            seen.push(watch);
        }
        Accelerated::default().solve(&mut problem, NEVER, SWEEPS);
        format!("{seen:?} {}", solution(&problem))
    })
}

/// A tolerance that no sweep meets, and a number of sweeps in which momentum is gained and lost.
const NEVER: Tolerance = Tolerance {
    relative: 0.0,
    speed: 0.0,
};
const SWEEPS: usize = 60;

/// Impulses and motions.
fn solution<F: ContactFriction<f64>>(problem: &Spheres<F>) -> String {
    let links = problem.links();
    let impulses: Vec<_> = links.map(|link| *link.contact.impulse()).collect();
    format!("{impulses:?} {:?}", problem.spheres)
}

/// A problem whose momentum is that of any problem, contact by contact.
struct Plain<F: ContactFriction<f64>>(Spheres<F>);

impl<F: ContactFriction<f64>> Operator for Plain<F> {
    type Impulse = <Spheres<F> as Operator>::Impulse;

    fn contacts(&self) -> usize {
        self.0.contacts()
    }
    fn impulse(&self, contact: usize) -> Self::Impulse {
        self.0.impulse(contact)
    }
    fn dot(&self, contact: usize, a: &Self::Impulse, b: &Self::Impulse) -> f64 {
        self.0.dot(contact, a, b)
    }
    fn guess(&mut self, contact: usize, impulse: &Self::Impulse) {
        self.0.guess(contact, impulse);
    }
    fn refresh(&mut self) {
        self.0.refresh();
    }
    fn sweep<W: Monitor>(&mut self, visit: Visit<'_>, watch: &mut W) {
        self.0.sweep(visit, watch);
    }
}

#[test]
fn momentum_of_all_pairs_at_once_has_the_bits_of_one_contact_after_the_other() {
    let all = IndependentFriction::all(0.3, 0.1, 0.1).expect("in range");
    for spread in SPREADS {
        let (mut four, mut plain) = (tangle(all, spread), Plain(tangle(all, spread)));
        plain.0.without_lanes();
        let iterations = Accelerated::default().solve(&mut four, NEVER, SWEEPS);
        let one_by_one = Accelerated::default().solve(&mut plain, NEVER, SWEEPS);
        assert_eq!(iterations, one_by_one);
        assert!(solution(&four) == solution(&plain.0));
    }
}

#[test]
fn blocks_and_pairs_across_them_have_the_same_bits_on_any_number_of_threads() {
    let all = IndependentFriction::all(0.3, 0.1, 0.1).expect("in range");
    for spread in SPREADS {
        let alone = swept(1, Lanes::One, all, spread);
        for threads in [2, 3] {
            for lanes in [Lanes::One, Lanes::Four] {
                let shared = swept(threads, lanes, all, spread);
                assert!(shared == alone, "{threads} threads, {spread}");
            }
        }
    }
}

#[test]
fn four_contacts_side_by_side_have_the_bits_of_one_after_the_other() {
    fn compare<F: ContactFriction<f64>>(friction: F) {
        for spread in SPREADS {
            let four = swept(1, Lanes::Four, friction, spread);
            assert!(four == swept(1, Lanes::One, friction, spread), "{spread}");
        }
    }
    compare(IndependentFriction::none());
    for [mu, mu_rolling, mu_torsion] in [[0.3, 0.1, 0.1], [0.0, 0.0, 0.0], [1e-310, 0.1, 1.0]] {
        compare(IndependentFriction::sliding(mu).expect("in range"));
        compare(IndependentFriction::sliding_rolling(mu, mu_rolling).expect("in range"));
        compare(IndependentFriction::sliding_torsion(mu, mu_torsion).expect("in range"));
        compare(IndependentFriction::all(mu, mu_rolling, mu_torsion).expect("in range"));
    }
}
