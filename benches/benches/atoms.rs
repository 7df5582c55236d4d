//! Atoms of a melt: forces by potential and by the sums computed, the pair list, and a step by
//! thermostat. The front `atoms` compares speeds with LAMMPS and shows drift against the time step.

mod settings;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use nalgebra::Vector3;
use std::hint::black_box;
use tribos::md::eam::{SuttonChen, SuttonChenParameters};
use tribos::md::group::Group;
use tribos::md::interaction::{Evaluation, Interaction};
use tribos::md::neighbours::VerletList;
use tribos::md::pair::Shift;
use tribos::md::thermostat::{Langevin, NoseHoover, RotationBias, Thermostat};
use tribos::space::PeriodicBox;
use tribos_benches::fronts::atoms::melt::{CUTOFF, Melt, SKIN, TIME_STEP, lennard_jones};

/// 4 · 10³ atoms, and the steps in which they melt.
const CUBES: usize = 10;
const MELTING: usize = 300;
/// Of both thermostats.
const TEMPERATURE: f64 = 0.7;

fn melt() -> Melt {
    Melt::after(CUBES, MELTING, Shift::None).expect("the melt is valid")
}

/// The pairs of the melt within the cut-off that all potentials here have.
fn listed(melt: &Melt) -> VerletList {
    let space = PeriodicBox::new([Some(melt.edge); 3]).expect("the edge is positive");
    let mut list = VerletList::new(space, CUTOFF, SKIN).expect("they fit the box");
    let told = list.update(&melt.atoms.positions, &melt.atoms.species);
    told.expect("all places are finite");
    list
}

/// Sutton and Chen's, as dense as the melt: two passes over the pairs.
fn sutton_chen(melt: &Melt) -> SuttonChen {
    let given = SuttonChenParameters {
        epsilon: 0.01,
        a: melt.edge / CUBES as f64,
        c: 39.432,
        n: 9,
        m: 6,
        cutoff: CUTOFF,
        taper: 0.9 * CUTOFF,
    };
    SuttonChen::new(given).expect("the parameters are in the domain")
}

fn forces(criterion: &mut Criterion) {
    let melt = melt();
    let mut list = listed(&melt);
    let pairs: usize = list.chunks_mut().iter().map(|chunk| chunk.pairs()).sum();
    let lennard_jones = lennard_jones(Shift::None).expect("the cut-off is positive");
    let sutton_chen = sutton_chen(&melt);
    let cases: [(&str, &dyn Interaction, Evaluation); 4] = [
        ("Lennard-Jones", &lennard_jones, Evaluation::Forces),
        ("Lennard-Jones, sums", &lennard_jones, Evaluation::Sums),
        ("Sutton-Chen", &sutton_chen, Evaluation::Forces),
        ("Sutton-Chen, sums", &sutton_chen, Evaluation::Sums),
    ];
    let mut group = criterion.benchmark_group("forces");
    group.throughput(Throughput::Elements(pairs as u64));
    for (name, interaction, wanted) in cases {
        let mut forces = vec![Vector3::zeros(); melt.atoms.len()];
        interaction.forces(&mut list, &mut forces, wanted);
        // Action and reaction.
        let sum: Vector3<f64> = forces.iter().sum();
        let most = forces.iter().map(Vector3::norm).fold(0.0, f64::max);
        assert!(most > 1.0 && sum.norm() < 1e-9 * most, "{name}: {sum}");
        group.bench_function(name, |bencher| {
            bencher.iter(|| interaction.forces(&mut list, black_box(&mut forces), wanted));
        });
    }
    group.finish();
}

fn lists(criterion: &mut Criterion) {
    let melt = melt();
    let mut list = listed(&melt);
    let mut group = criterion.benchmark_group("list");
    group.throughput(Throughput::Elements(melt.atoms.len() as u64));
    group.bench_function("build", |bencher| {
        bencher.iter(|| list.build(black_box(&melt.atoms.positions), &melt.atoms.species));
    });
    group.finish();
}

fn steps(criterion: &mut Criterion) {
    let melt = melt();
    let valid = "the thermostat is in the domain";
    let nose_hoover = NoseHoover::new(TEMPERATURE, 1.0, RotationBias::Counts).expect(valid);
    let langevin = Langevin::new(TEMPERATURE, 1.0).expect(valid);
    let cases = [
        ("constant energy", Thermostat::None),
        ("Nose-Hoover", Thermostat::NoseHoover(nose_hoover)),
        ("Langevin", Thermostat::Langevin(langevin)),
    ];
    let mut group = criterion.benchmark_group("step");
    group.throughput(Throughput::Elements(melt.atoms.len() as u64));
    for (name, thermostat) in cases {
        let atoms = Group {
            thermostat,
            ..Group::default()
        };
        let system = melt.moved_as(atoms, Shift::None, TIME_STEP);
        let mut system = system.expect("the melt is valid");
        group.bench_function(name, |bencher| {
            bencher.iter(|| system.step(Evaluation::Forces).expect("nothing overlaps"));
        });
    }
    group.finish();
}

criterion_group! {
    name = benches;
    config = settings::criterion();
    targets = forces, lists, steps
}
criterion_main!(benches);
