//! Contact problems that are known, and random ones, by every method.

use super::{
    ContactComponents, ContactThresholds, Friction, GlobalProblem, ProblemMethod, ReducedProblem,
    SolverOptions, SolverStatus, SparseMatrix,
};
use super::{ProblemError, Solution, residual, solve};
use nalgebra::{DMatrix, DVector};
use tribos_base::random::Random;

/// Problems that are squeezed; 10,000 take a minute and a half.
const SQUEEZED: u64 = 100;

const METHODS: [ProblemMethod; 5] = [
    ProblemMethod::Automatic,
    ProblemMethod::Sweeps,
    ProblemMethod::Gradient,
    ProblemMethod::Interior,
    ProblemMethod::Proximal,
];

fn by(problem: &ReducedProblem, method: ProblemMethod) -> Solution {
    let settings = SolverOptions {
        method,
        most_sweeps: 20_000,
        ..SolverOptions::default()
    };
    solve(problem, &settings, |_| ())
}

/// Bodies of six degrees of freedom each, and contacts between two of them or with the ground.
fn assembly(layout: ContactComponents, bodies: usize, contacts: usize, seed: u64) -> GlobalProblem {
    let mut random = Random::new(seed, 0);
    let mut signed = || 2.0 * random.unit() - 1.0;
    let size = layout.size();
    let (mut m, mut h) = (Vec::new(), Vec::new());
    for at in 0..6 * bodies {
        m.push((at, at, libm::exp(2.0 * signed())));
    }
    for contact in 0..contacts {
        let first = contact % bodies;
        let second = (first + 1 + contact / bodies) % (bodies + 1);
        for component in 0..size {
            for (body, sign) in [(first, 1.0), (second, -1.0)] {
                // The body after the last is the ground.
                for axis in (0..6).filter(|_| body < bodies) {
                    let entry = sign * (signed() + if axis == component { 2.0 } else { 0.0 });
                    h.push((6 * body + axis, contact * size + component, entry));
                }
            }
        }
    }
    let f = (0..6 * bodies).map(|_| signed()).collect();
    let w = vec![0.0; size * contacts];
    // A third of the thresholds is zero.
    let mut threshold = || (1.5 * signed()).max(0.0);
    let laws = (0..contacts)
        .map(|contact| ContactThresholds {
            sliding: threshold(),
            rolling: threshold(),
            torsion: threshold(),
            cohesion: if contact % 4 == 0 { 0.1 } else { 0.0 },
            friction: if contact % 2 == 0 {
                Friction::Ellipsoid
            } else {
                Friction::Separate
            },
        })
        .collect();
    let shape = [6 * bodies, size * contacts];
    let m = SparseMatrix::from_triplets([shape[0]; 2], &m).expect("entries are inside");
    let h = SparseMatrix::from_triplets(shape, &h).expect("entries are inside");
    GlobalProblem::new(layout, m, h, f, w, laws).expect("the problem is valid")
}

#[test]
fn every_method_solves_random_assemblies_of_every_layout() {
    for size in 2..=6 {
        let layout = ContactComponents::of_size(size).expect("a layout");
        for seed in 0..6 {
            let problem = assembly(layout, 4, 7, seed)
                .reduced()
                .expect("masses are positive");
            let mut solved = 0;
            for method in METHODS {
                let end = by(&problem, method);
                let meets = end.residual.meets(1e-8);
                assert_eq!(
                    meets,
                    end.ending == SolverStatus::Converged,
                    "{layout:?} {seed} {method:?}"
                );
                assert_eq!(end.residual, residual(&problem, &end.impulses));
                solved += usize::from(meets);
                assert!(
                    meets || method != ProblemMethod::Automatic,
                    "{layout:?} {seed}: {end:?}"
                );
            }
            assert!(solved >= 4, "{layout:?} {seed}: {solved} methods");
        }
    }
}

#[test]
fn bodies_and_contacts_are_two_ways_to_the_same_answer() {
    let global = assembly(ContactComponents::All, 3, 9, 11);
    let with_bodies = global.reduced().expect("masses are positive");
    let mut without = with_bodies.clone();
    without.made = None;
    let [a, b] = [&with_bodies, &without].map(|problem| by(problem, ProblemMethod::Interior));
    assert_eq!([a.ending, b.ending], [SolverStatus::Converged; 2]);
    for (a, b) in a.velocities.iter().zip(&b.velocities) {
        assert!((a - b).abs() < 1e-7, "{a} {b}");
    }
}

#[test]
fn a_wedge_that_sticks_with_other_forces_keeps_them() {
    // A mass between two walls, squeezed: any common squeeze is a solution with friction.
    let m = SparseMatrix::from_triplets([2, 2], &[(0, 0, 1.0), (1, 1, 1.0)]).expect("valid");
    let arms = [(0, 0, 1.0), (1, 1, 1.0), (0, 2, -1.0), (1, 3, 1.0)];
    let h = SparseMatrix::from_triplets([2, 4], &arms).expect("valid");
    let laws = vec![ContactThresholds::coulomb(0.5); 2];
    let jam = GlobalProblem::new(
        ContactComponents::Plane,
        m,
        h,
        vec![0.0, -1.0],
        vec![0.0; 4],
        laws,
    );
    let jam = jam.and_then(|jam| jam.reduced()).expect("valid");
    for squeeze in [2.0, 5.0] {
        let start = Some(vec![squeeze, 0.5, squeeze, 0.5]);
        let held = solve(
            &jam,
            &SolverOptions {
                start,
                ..SolverOptions::default()
            },
            |_| (),
        );
        assert_eq!(held.ending, SolverStatus::Converged);
        assert!((held.impulses[0] - squeeze).abs() < 1e-8, "{held:?}");
    }
    // Without a squeeze it falls: the other solution.
    let falls = solve(&jam, &SolverOptions::default(), |_| ());
    assert_eq!(falls.ending, SolverStatus::Converged);
    assert!((falls.velocities[1] + 1.0).abs() < 1e-7 || falls.velocities[1].abs() < 1e-7);
}

#[test]
fn what_cannot_be_solved_is_not_called_solved() {
    // A contact between bodies that do not move, which closes.
    let w = SparseMatrix::from_triplets([3, 3], &[]).expect("valid");
    let laws = vec![ContactThresholds::coulomb(0.3)];
    let hopeless = ReducedProblem::new(ContactComponents::Space, w, vec![-1.0, 0.0, 0.0], laws)
        .expect("valid");
    for method in METHODS {
        let end = by(&hopeless, method);
        assert_ne!(end.ending, SolverStatus::Converged, "{method:?}");
        assert!(end.impulses.iter().all(|r| r.is_finite()), "{end:?}");
    }
}

#[test]
fn units_of_mass_change_nothing_but_the_units() {
    let problem = assembly(ContactComponents::Space, 4, 8, 3)
        .reduced()
        .expect("masses are positive");
    // A residual leaves some digits of impulses that hardly move anything.
    let closely = SolverOptions {
        tolerance: 1e-12,
        ..SolverOptions::default()
    };
    let reference = solve(&problem, &closely, |_| ());
    for unit in [1e-12, 1e12] {
        let entries: Vec<_> = problem
            .w()
            .triplets()
            .map(|(i, j, v)| (i, j, v * unit))
            .collect();
        let w = SparseMatrix::from_triplets([24, 24], &entries).expect("valid");
        let mut laws = problem.laws().to_vec();
        laws.iter_mut().for_each(|law| law.cohesion /= unit);
        let other = ReducedProblem::new(ContactComponents::Space, w, problem.q().to_vec(), laws)
            .expect("valid");
        let end = solve(&other, &closely, |_| ());
        for (a, b) in end.impulses.iter().zip(&reference.impulses) {
            assert!((a * unit - b).abs() < 1e-7, "{a} {b}");
        }
    }
}

#[test]
fn data_that_is_no_problem_is_refused() {
    let w = || SparseMatrix::from_triplets([3, 3], &[]).expect("valid");
    let law = ContactThresholds::coulomb(0.3);
    let new = |q: Vec<f64>, law| ReducedProblem::new(ContactComponents::Space, w(), q, vec![law]);
    assert!(matches!(
        new(vec![0.0; 2], law),
        Err(ProblemError::Size { what: "q", .. })
    ));
    assert!(matches!(
        new(vec![f64::NAN; 3], law),
        Err(ProblemError::NotFinite { .. })
    ));
    let bad = ContactThresholds::coulomb(-0.3);
    assert!(matches!(
        new(vec![0.0; 3], bad),
        Err(ProblemError::Law { contact: 0, .. })
    ));
    let outside = SparseMatrix::from_triplets([2, 2], &[(0, 2, 1.0)]);
    assert!(matches!(
        outside,
        Err(ProblemError::OutOfRange { column: 2, .. })
    ));
}

#[test]
fn odd_starts_and_sizes_end_honestly() {
    let fall = |unit: f64| {
        let w = SparseMatrix::from_triplets([3, 3], &[(0, 0, 0.5), (1, 1, 0.5), (2, 2, 0.5)]);
        let q = [-3.0, 4.0, 0.0].map(|x| x * unit).to_vec();
        ReducedProblem::new(
            ContactComponents::Space,
            w.expect("valid"),
            q,
            vec![ContactThresholds::coulomb(0.5)],
        )
    };
    let problem = fall(1.0).expect("valid");
    for start in [
        vec![],
        vec![1.0; 4],
        vec![f64::NAN; 3],
        vec![f64::INFINITY, 0.0, 0.0],
        vec![1e9; 3],
    ] {
        for method in METHODS {
            let start = Some(start.clone());
            let settings = SolverOptions {
                method,
                start,
                ..SolverOptions::default()
            };
            let end = solve(&problem, &settings, |_| ());
            assert_eq!(end.ending, SolverStatus::Converged, "{method:?}: {end:?}");
            assert!((end.impulses[0] - 6.0).abs() < 1e-6, "{end:?}");
        }
    }
    // Where squares would leave the range of numbers.
    for unit in [1e-100, 1e-200, 1e100, 1e200] {
        let end = by(&fall(unit).expect("valid"), ProblemMethod::Automatic);
        let right = (end.impulses[0] / (6.0 * unit) - 1.0).abs() < 1e-6
            && (end.impulses[1] / (-3.0 * unit) - 1.0).abs() < 1e-6;
        assert!(
            right && end.ending == SolverStatus::Converged,
            "{unit}: {end:?}"
        );
    }
    // Cohesion alone, without a velocity: the contact rests, and holds no force.
    let still = ReducedProblem {
        q: vec![0.0; 3],
        laws: vec![ContactThresholds {
            cohesion: 2.0,
            ..ContactThresholds::coulomb(0.5)
        }],
        ..problem
    };
    for method in METHODS {
        let end = by(&still, method);
        assert_eq!(end.ending, SolverStatus::Converged, "{method:?}: {end:?}");
        assert!(end.impulses[0].abs() < 1e-7, "{end:?}");
    }
    let none = SparseMatrix::from_triplets([0, 0], &[]).expect("valid");
    let none =
        ReducedProblem::new(ContactComponents::All, none, Vec::new(), Vec::new()).expect("valid");
    assert_eq!(
        by(&none, ProblemMethod::Automatic).ending,
        SolverStatus::Converged
    );
}

/// Contacts of one body with walls that move, and weights of the first few that move nothing: u · y = w · y whatever
/// the impulses, up to a share `slip` of the arms.
fn squeezed(seed: u64, slip: f64) -> (ReducedProblem, Vec<f64>) {
    let mut random = Random::new(seed, 7);
    let mut signed = || 2.0 * random.unit() - 1.0;
    let layout = if signed() < 0.0 {
        ContactComponents::Plane
    } else {
        ContactComponents::Space
    };
    let (size, freedoms) = (layout.size(), 6);
    let squeezed = 2 + (2.0 * (signed() + 1.0)) as usize;
    let contacts = squeezed + (1.5 * (signed() + 1.0)) as usize;
    let mut arms = DMatrix::from_fn(freedoms, size * contacts, |_, _| signed());
    let mut weights = DVector::zeros(contacts);
    for contact in 0..squeezed {
        weights[contact] = libm::exp(2.0 * signed());
    }
    // The last of them closes the chain.
    let last = squeezed - 1;
    let mut balance = DVector::zeros(freedoms);
    for contact in 0..last {
        balance += arms.column(size * contact) * weights[contact];
    }
    let off = DVector::from_fn(freedoms, |_, _| slip * signed());
    let closing = -balance / weights[last] + off;
    arms.set_column(size * last, &closing);
    let masses = DMatrix::from_diagonal(&DVector::from_fn(freedoms, |_, _| {
        libm::exp(2.0 * signed())
    }));
    let product = arms.transpose() * &masses * &arms;
    let free = DVector::from_fn(freedoms, |_, _| signed());
    let mut q = arms.transpose() * free;
    for contact in 0..squeezed {
        // Walls that close, at 1e-8 to 1.
        let speed = libm::exp(-18.0 * (0.5 + 0.5 * signed()));
        q[size * contact] -= speed;
    }
    let laws = (0..contacts).map(|_| ContactThresholds::coulomb((1.5 * signed()).max(0.0)));
    let laws = laws.collect();
    let entries: Vec<_> = (0..q.len())
        .flat_map(|row| (0..q.len()).map(move |column| (row, column)))
        .map(|(row, column)| (row, column, product[(row, column)]))
        .collect();
    let w = SparseMatrix::from_triplets([q.len(); 2], &entries).expect("entries are inside");
    let problem = ReducedProblem::new(layout, w, q.as_slice().to_vec(), laws).expect("valid");
    (problem, weights.as_slice().to_vec())
}

/// A normal speed in twice the working precision (Ogita, Rump and Oishi, SIAM J. Sci. Comput. 26 (2005) 1955).
fn speed_of(problem: &ReducedProblem, r: &[f64], at: usize) -> f64 {
    let (mut sum, mut rest) = (problem.q()[at], 0.0);
    for &(column, w) in problem.w().row(at) {
        let product = w * r[column];
        let low = libm::fma(w, r[column], -product);
        let new = sum + product;
        let part = new - sum;
        rest += (sum - (new - part)) + (product - part) + low;
        sum = new;
    }
    sum + rest
}

/// The proof of a solution that there is none: its impulses move no contact that could help, and close.
fn assert_squeezes(problem: &ReducedProblem, end: &Solution) {
    let size = problem.layout().size();
    let weights = &end.squeeze.as_ref().expect("a proof").weights;
    assert!(weights.iter().all(|&y| y >= 0.0));
    let mut normals = vec![0.0; problem.q().len()];
    for (normal, y) in normals.iter_mut().step_by(size).zip(weights) {
        *normal = *y;
    }
    let moved = problem.w().transposed().times(&normals);
    let closing: f64 = normals.iter().zip(problem.q()).map(|(y, q)| -y * q).sum();
    let mut opened = 0.0;
    for (contact, law) in problem.laws().iter().enumerate() {
        let z = &moved[size * contact..size * (contact + 1)];
        let sliding: f64 = z[1..].iter().map(|z| z * z).sum();
        opened += (z[0] + law.sliding * sliding.sqrt()).max(0.0);
    }
    // Impulses of 1e6 times what stops the contacts do not open them.
    assert!(
        closing > 0.0 && 1e6 * opened < closing,
        "{opened:e} {closing:e}"
    );
}

#[test]
fn no_insoluble_or_nearly_insoluble_problem_is_called_solved() {
    let mut proven = [0; 2];
    for seed in 0..SQUEEZED {
        let slip = [0.0, 1e-14, 1e-9, 1e-4][seed as usize % 4];
        let (problem, weights) = squeezed(seed, slip);
        let size = problem.layout().size();
        let largest = problem
            .q()
            .iter()
            .fold(0.0_f64, |most, q| most.max(q.abs()));
        // What the judgement allows, and as much for its own rounding.
        let allowed = 2e-6 * largest;
        let normals = problem.q().iter().step_by(size);
        let closing: f64 = weights.iter().zip(normals).map(|(y, q)| -y * q).sum();
        let closing = closing / weights.iter().sum::<f64>();
        for method in METHODS {
            let settings = SolverOptions {
                method,
                most_sweeps: 2000,
                most_factorisations: 300,
                ..SolverOptions::default()
            };
            let end = solve(&problem, &settings, |_| ());
            let least = (0..problem.contacts())
                .map(|contact| speed_of(&problem, &end.impulses, size * contact))
                .fold(f64::INFINITY, f64::min);
            match end.ending {
                SolverStatus::Converged => {
                    assert!(-least <= allowed, "{seed} {method:?}: {least:e}");
                    assert!(slip > 1e-10 || closing <= allowed, "{seed} {method:?}");
                }
                SolverStatus::Insoluble => {
                    assert_squeezes(&problem, &end);
                    proven[0] += 1;
                }
                SolverStatus::Stalled | SolverStatus::OutOfWork => {}
            }
            proven[1] += usize::from(slip == 0.0 && closing > 1e-4 * largest);
        }
    }
    let [found, certain] = proven;
    assert!(found >= certain, "{found} proofs of {certain}");
}
