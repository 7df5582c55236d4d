//! Forces are slopes of the energy, sum up to nothing and have the same bits on any number of threads.

use nalgebra::Vector3;
use tribos::md::configuration::Configuration;
use tribos::md::eam::file::PotentialFile;
use tribos::md::eam::{SuttonChen, SuttonChenError, SuttonChenParameters, Tabulated};
use tribos::md::interaction::{Evaluation, Interaction, evaluate};
use tribos::md::neighbours::VerletList;
use tribos::md::pair::{Mixing, Shift};
use tribos_tests::atoms::{binary, computed, data, single, text};

/// Copper (Sutton & Chen 1990, table 1), eV and Å.
const COPPER: SuttonChenParameters = SuttonChenParameters {
    epsilon: 1.2382e-2,
    a: 3.61,
    c: 39.432,
    n: 9,
    m: 6,
    cutoff: 7.0,
    taper: 6.0,
};

fn copper() -> SuttonChen {
    SuttonChen::new(COPPER).unwrap()
}

fn tabulated() -> Tabulated {
    let file = PotentialFile::read(&text("synthetic.eam.alloy")).unwrap();
    Tabulated::new(&file, &[0, 1]).unwrap()
}

/// Atoms of a metal, with a law; the closed form has one species.
fn metals() -> [(Configuration, Box<dyn Interaction>); 2] {
    let alloy = data("alloy500", [true, true, false]);
    let mut pure = alloy.clone();
    pure.atoms.species.fill(0);
    [(alloy, Box::new(tabulated())), (pure, Box::new(copper()))]
}

#[test]
fn a_force_is_the_slope_of_the_energy() {
    const STEP: f64 = 1e-4;
    for (all, law) in metals() {
        let (forces, _) = computed(&all, law.as_ref());
        let largest = forces.iter().map(Vector3::norm).fold(0.0, f64::max);
        for atom in [0, 7, 123, 320, 499] {
            let force = forces[all.ids[atom] as usize - 1];
            for axis in 0..3 {
                let energy = |way: f64| {
                    let mut moved = all.clone();
                    moved.atoms.positions[atom][axis] += way;
                    computed(&moved, law.as_ref()).1.energy
                };
                // Differences of fourth order.
                let wide = (energy(2.0 * STEP) - energy(-2.0 * STEP)) / (4.0 * STEP);
                let narrow = (energy(STEP) - energy(-STEP)) / (2.0 * STEP);
                let slope = (4.0 * narrow - wide) / 3.0;
                let off = (slope + force[axis]).abs() / largest;
                assert!(off < 1e-8, "atom {atom}, axis {axis}: {off:.1e}");
            }
        }
    }
}

/// The closed form by its definition, every pair looked at.
fn by_definition(all: &Configuration, given: &SuttonChenParameters) -> f64 {
    let lengths = all.space().unwrap().lengths();
    let taper = |r: f64| {
        let x = ((r - given.taper) / (given.cutoff - given.taper)).max(0.0);
        if x < 1.0 {
            1.0 - x.powi(3) * (10.0 - 15.0 * x + 6.0 * x * x)
        } else {
            0.0
        }
    };
    let places = &all.atoms.positions;
    let mut energy = 0.0;
    for (i, a) in places.iter().enumerate() {
        let mut density = 0.0;
        for (_, b) in places.iter().enumerate().filter(|&(j, _)| j != i) {
            let mut way = b - a;
            for axis in 0..3 {
                if let Some(length) = lengths[axis] {
                    way[axis] -= length * (way[axis] / length).round();
                }
            }
            let (r, s) = (way.norm(), taper(way.norm()));
            energy += 0.5 * given.epsilon * (given.a / r).powi(given.n as i32) * s;
            density += (given.a / r).powi(given.m as i32) * s;
        }
        energy -= given.epsilon * given.c * density.sqrt();
    }
    energy
}

#[test]
fn the_closed_form_is_its_definition() {
    let [_, (all, law)] = metals();
    let (_, tally) = computed(&all, law.as_ref());
    let expected = by_definition(&all, &COPPER);
    assert!(
        (tally.energy / expected - 1.0).abs() < 1e-13,
        "{} {expected}",
        tally.energy
    );
}

/// Published: cohesive energy 3.49 eV at the lattice constant 3.61 Å, where the pressure vanishes.
#[test]
fn copper_coheres_as_published() {
    let law = SuttonChen::new(SuttonChenParameters {
        cutoff: 18.0,
        taper: 17.0,
        ..COPPER
    })
    .unwrap();
    const CELLS: u32 = 10;
    let mut places = Vec::new();
    for cell in 0..CELLS.pow(3) {
        let corner = [cell % CELLS, cell / CELLS % CELLS, cell / CELLS / CELLS];
        for base in [
            [0.0, 0.0, 0.0],
            [0.5, 0.5, 0.0],
            [0.5, 0.0, 0.5],
            [0.0, 0.5, 0.5],
        ] {
            let along = |axis: usize| COPPER.a * (f64::from(corner[axis]) + base[axis]);
            places.push(Vector3::new(along(0), along(1), along(2)));
        }
    }
    let mut all = data("alloy500", [true; 3]);
    all.bounds = [[0.0, COPPER.a * f64::from(CELLS)]; 3];
    all.ids = (1..=places.len() as u64).collect();
    all.atoms = tribos::md::atoms::Atoms::at(places);
    let (forces, tally) = computed(&all, &law);
    let cohesion = -tally.energy / forces.len() as f64;
    assert!((cohesion - 3.49).abs() < 0.01, "{cohesion}");
    // eV/Å³; the bulk modulus is about 0.8.
    let pressure = tally.virial.trace() / (3.0 * all.volume());
    assert!(pressure.abs() < 2e-3, "{pressure}");
    assert!(forces.iter().all(|force| force.norm() < 1e-12));
}

#[test]
fn a_pair_that_parts_feels_no_jump() {
    let law = copper();
    let pull = |r: f64| {
        let mut all = data("alloy500", [false; 3]);
        all.atoms = tribos::md::atoms::Atoms::at(vec![Vector3::zeros(), Vector3::new(r, 0.0, 0.0)]);
        all.ids = vec![1, 2];
        let (forces, tally) = computed(&all, &law);
        [tally.energy, forces[0].x]
    };
    for r in [COPPER.taper, COPPER.cutoff] {
        let [inside, outside] = [r - 1e-9, r + 1e-9].map(pull);
        assert!(
            (inside[0] - outside[0]).abs() < 1e-8,
            "{inside:?} {outside:?}"
        );
        assert!(
            (inside[1] - outside[1]).abs() < 1e-4,
            "{inside:?} {outside:?}"
        );
    }
    assert_eq!(pull(COPPER.cutoff), [0.0; 2]);
    assert_eq!(pull(COPPER.cutoff + 0.1), [0.0; 2]);
    assert!(pull(COPPER.cutoff.next_down())[1].is_finite());
}

#[test]
fn parameters_that_make_no_metal_are_refused() {
    let new = |given: SuttonChenParameters| SuttonChen::new(given).unwrap_err();
    let error = new(SuttonChenParameters { a: -1.0, ..COPPER });
    assert!(matches!(
        error,
        SuttonChenError::Parameter { name: "a", .. }
    ));
    let error = new(SuttonChenParameters { n: 6, ..COPPER });
    assert!(matches!(error, SuttonChenError::Exponents { n: 6, m: 6 }));
    let error = new(SuttonChenParameters {
        taper: 7.0,
        ..COPPER
    });
    assert!(matches!(error, SuttonChenError::Taper { .. }));
}

#[test]
fn forces_of_closed_systems_sum_up_to_nothing() {
    let two = data("binary500", [true; 3]);
    let pair: [(Configuration, Box<dyn Interaction>); 2] = [
        (
            data("slab576", [true, true, false]),
            Box::new(single(Shift::Force)),
        ),
        (two, Box::new(binary(Mixing::Arithmetic, Shift::None))),
    ];
    for (all, law) in pair.into_iter().chain(metals()) {
        let (forces, _) = computed(&all, law.as_ref());
        let absolute: f64 = forces.iter().map(Vector3::norm).sum();
        let sum: Vector3<f64> = forces.iter().sum();
        assert!(sum.norm() < 1e-14 * absolute, "{sum} of {absolute}");
    }
}

/// Eight or more copies side by side, so that a list has several chunks.
fn copies(all: &Configuration) -> Configuration {
    const COPIES: usize = 3;
    let mut many = all.clone();
    let lengths = all.lengths();
    for copy in 1..COPIES.pow(3) {
        let steps = [
            copy % COPIES,
            copy / COPIES % COPIES,
            copy / COPIES / COPIES,
        ];
        let shift = Vector3::from_fn(|axis, _| steps[axis] as f64 * lengths[axis]);
        let moved = all.atoms.positions.iter().map(|place| place + shift);
        many.atoms.positions.extend(moved);
        many.atoms
            .velocities
            .extend_from_slice(&all.atoms.velocities);
        many.atoms.species.extend_from_slice(&all.atoms.species);
    }
    many.bounds = std::array::from_fn(|axis| {
        let low = all.bounds[axis][0];
        [low, low + COPIES as f64 * lengths[axis]]
    });
    many
}

#[test]
fn bits_do_not_depend_on_the_number_of_threads() {
    let liquid: (Configuration, Box<dyn Interaction>) = (
        data("binary500", [true; 3]),
        Box::new(binary(Mixing::Geometric, Shift::Energy)),
    );
    for (all, law) in metals().into_iter().chain([liquid]) {
        let all = copies(&all);
        let bits = |threads: usize| -> Vec<u64> {
            let pool = rayon::ThreadPoolBuilder::new()
                .num_threads(threads)
                .build()
                .unwrap();
            let (forces, tally) = pool.install(|| {
                let mut list = VerletList::new(all.space().unwrap(), law.cutoff(), 0.2).unwrap();
                let mut forces = Vec::new();
                let law = law.as_ref();
                let tally = evaluate(law, &mut list, &all.atoms, &mut forces, Evaluation::Sums);
                assert!(list.chunks_mut().len() > 2);
                (forces, tally.unwrap())
            });
            let forces = forces
                .iter()
                .flat_map(|force| force.iter().map(|x| x.to_bits()));
            let virial = tally.virial.iter().map(|x| x.to_bits());
            forces
                .chain(virial)
                .chain([tally.energy.to_bits()])
                .collect()
        };
        let one = bits(1);
        assert!(one == bits(2) && one == bits(3));
    }
}
