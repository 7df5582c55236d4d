use super::{Assembly, ForceDistribution, KnownForces, LayerProfile, MeasureOptions, Measures};
use nalgebra::{Matrix3, Vector3};
use serde_json::json;
use std::f64::consts::PI;
use tribos_base::random::Random;
use tribos_base::record::{ContactRow, Partner};
use tribos_base::space::PeriodicBox;

fn cube(side: f64) -> PeriodicBox {
    PeriodicBox::new([Some(side); 3]).unwrap()
}

fn push(a: u32, b: Partner, normal: Vector3<f64>, force: f64) -> ContactRow {
    ContactRow {
        a,
        b,
        normal,
        gap: 0.0,
        force: normal * force,
        torque: Vector3::zeros(),
    }
}

/// A row of touching spheres of radius 1 along a direction from the origin, pressed by walls at both ends.
fn row(count: u32, direction: Vector3<f64>, force: f64) -> (Vec<Vector3<f64>>, Vec<ContactRow>) {
    let places = (0..count)
        .map(|n| direction * (2.0 * f64::from(n)))
        .collect();
    let touch = |n: u32| push(n, Partner::Particle(n + 1), direction, force);
    let mut contacts: Vec<_> = (0..count - 1).map(touch).collect();
    contacts.push(push(0, Partner::Wall(0), -direction, force));
    contacts.push(push(count - 1, Partner::Wall(1), direction, force));
    (places, contacts)
}

fn with_forces(places: Vec<Vector3<f64>>, contacts: Vec<ContactRow>) -> Assembly {
    let count = places.len();
    Assembly {
        contacts,
        forces: KnownForces::Complete,
        ..Assembly::new(PeriodicBox::OPEN, places, vec![1.0; count])
    }
}

#[test]
fn a_face_centred_crystal_has_its_shells_twelve_contacts_and_no_direction() {
    let (cells, a) = (5_u32, 8.0_f64.sqrt());
    let base = [
        [0.0, 0.0, 0.0],
        [0.5, 0.5, 0.0],
        [0.5, 0.0, 0.5],
        [0.0, 0.5, 0.5],
    ];
    let mut places = Vec::new();
    for n in 0..cells.pow(3) {
        let cell = [n % cells, n / cells % cells, n / cells / cells].map(f64::from);
        let at = |[x, y, z]: [f64; 3]| Vector3::new(cell[0] + x, cell[1] + y, cell[2] + z) * a;
        places.extend(base.map(at));
    }
    let count = places.len();
    let crystal = Assembly::new(cube(a * f64::from(cells)), places, vec![1.0; count]);
    let options = MeasureOptions {
        reach: Some(4.5),
        bins: 450,
        ..MeasureOptions::default()
    };
    let found = Measures::of(crystal, &options).unwrap();
    assert_eq!(
        found.coordination.histogram.iter().position(|k| *k > 0),
        Some(12)
    );
    assert_eq!(
        (found.coordination.mean, found.coordination.rattlers),
        (12.0, 0)
    );
    for value in found.fabric.values {
        assert!((value - 1.0 / 3.0).abs() < 1e-12);
    }
    assert!(found.fabric.anisotropy < 1e-11);
    assert!((found.porosity - (1.0 - PI / 18.0_f64.sqrt())).abs() < 1e-12);
    // Shells at 2, 2.83, 3.46, 4 and 4.47 radii (Kittel, Introduction to Solid State Physics).
    for (r, within) in [
        (1.9, 0.0),
        (2.1, 12.0),
        (3.0, 18.0),
        (3.6, 42.0),
        (4.2, 54.0),
    ] {
        let bin = (r / found.pairs.width) as usize;
        assert!((found.pairs.within[bin] - within).abs() < 1e-9, "{r}");
    }
    assert!(found.stress.is_none() && found.forces.is_none());
}

#[test]
fn an_ideal_gas_has_no_correlation_between_periods_or_faces() {
    let mut random = Random::new(3, 0);
    let count = 6000;
    let mut point = || Vector3::from_fn(|_, _| 10.0 * random.unit());
    let places: Vec<_> = (0..count).map(|_| point()).collect();
    for space in [
        cube(10.0),
        PeriodicBox::new([Some(10.0), None, None]).unwrap(),
    ] {
        let mut gas = Assembly::new(space, places.clone(), vec![1e-6; count]);
        gas.bounds = [[0.0, 10.0]; 3];
        let options = MeasureOptions {
            reach: Some(3.0),
            bins: 6,
            gap: 0.0,
            ..MeasureOptions::default()
        };
        let pairs = Measures::of(gas, &options).unwrap().pairs;
        for (bin, g) in pairs.values.iter().enumerate().skip(1) {
            assert!((g - 1.0).abs() < 0.03, "{bin} {g}");
        }
    }
}

#[test]
fn a_column_bears_the_force_over_the_area_in_one_chain() {
    for (count, force) in [(3, 2.0), (8, 0.5)] {
        let (mut places, contacts) = row(count, Vector3::z(), force);
        places.iter_mut().for_each(|place| place.z += 1.0);
        let space = PeriodicBox::new([Some(10.0), Some(5.0), None]).unwrap();
        let mut column = with_forces(places, contacts);
        column.space = space;
        column.enclose();
        let found = Measures::of(column, &MeasureOptions::default()).unwrap();
        let stress = found.stress.unwrap();
        let pressure = force / 50.0;
        assert!(
            (stress.total() - Matrix3::from_diagonal(&(Vector3::z() * pressure))).norm() < 1e-15
        );
        assert!((stress.deviator() / pressure - 1.0).abs() < 1e-12);
        assert!((found.fabric.values[0] - 1.0).abs() < 1e-12);
        assert!((found.fabric.anisotropy - 7.5).abs() < 1e-12);
        let chains = found.chains.unwrap();
        let lengths: Vec<usize> = chains.chains.iter().map(Vec::len).collect();
        assert_eq!((lengths, chains.share), (vec![count as usize], 1.0));
    }
}

#[test]
fn chains_follow_the_strong_forces_and_end_where_these_turn() {
    for direction in [Vector3::x(), -Vector3::y(), Vector3::new(0.6, 0.0, -0.8)] {
        // A weak row beside a strong one.
        let (mut places, mut contacts) = row(5, direction, 1.0);
        let (weak, weaker) = row(4, direction, 0.1);
        places.extend(
            weak.iter()
                .map(|place| place + Vector3::new(50.0, 50.0, 50.0)),
        );
        let later = |row: ContactRow| ContactRow {
            a: row.a + 5,
            b: row.b.particle().map_or(row.b, |b| Partner::Particle(b + 5)),
            ..row
        };
        contacts.extend(weaker.into_iter().map(later));
        let found =
            Measures::of(with_forces(places, contacts), &MeasureOptions::default()).unwrap();
        let chains = found.chains.unwrap();
        // From either end.
        let mut chain = chains.chains.concat();
        chain.sort_unstable();
        assert_eq!((chains.chains.len(), chain), (1, vec![0, 1, 2, 3, 4]));
    }
    // Two rows that meet at a right angle, at sphere 3, whose own direction is between them.
    let (mut places, mut contacts) = row(4, Vector3::x(), 1.0);
    contacts.pop();
    contacts.push(push(6, Partner::Wall(1), Vector3::y(), 1.0));
    for n in 0..3_u32 {
        places.push(Vector3::new(6.0, 2.0 * f64::from(n + 1), 0.0));
        contacts.push(push(3 + n, Partner::Particle(4 + n), Vector3::y(), 1.0));
    }
    let narrow = MeasureOptions {
        angle: 0.5,
        ..MeasureOptions::default()
    };
    let corner = with_forces(places, contacts);
    let found = Measures::of(corner, &narrow).unwrap().chains.unwrap();
    assert_eq!(found.longest(), 3);
    assert!(found.chains.iter().all(|chain| !chain.contains(&3)));
}

#[test]
fn a_chain_that_bends_has_buckled_by_its_angle() {
    let (places, contacts) = row(3, Vector3::x(), 1.0);
    let before = with_forces(places.clone(), contacts.clone());
    let chains = Measures::of(before.clone(), &MeasureOptions::default())
        .unwrap()
        .chains
        .unwrap();
    for (aside, buckled) in [(0.2, 1), (-0.2, 1), (0.001, 0)] {
        let mut bent = places.clone();
        bent[1].y += aside;
        let after = with_forces(bent, contacts.clone());
        let change = chains.buckling(&before, &after);
        let angle = 2.0 * libm::atan2(f64::abs(aside), 2.0);
        assert_eq!((change.triples, change.buckled), (1, buckled));
        assert!((change.mean - angle).abs() < 1e-14 && change.largest == change.mean);
    }
}

#[test]
fn exponential_forces_have_the_tail_of_their_mean() {
    const COUNT: u32 = 20_000;
    for scale in [1.0, 37.0] {
        // Quantiles of an exponential distribution, whose excess over any force has the same mean.
        let force = |n: u32| -scale * libm::log(1.0 - (f64::from(n) + 0.5) / f64::from(COUNT));
        let touch = |n: u32| push(n, Partner::Particle(n + 1), Vector3::x(), force(n));
        let mut contacts: Vec<_> = (0..COUNT).map(touch).collect();
        contacts.push(push(0, Partner::Particle(9), Vector3::x(), -3.0 * scale));
        contacts.push(push(0, Partner::Wall(0), Vector3::x(), 100.0 * scale));
        let found = ForceDistribution::of(&contacts).unwrap();
        assert!((found.mean / scale - 1.0).abs() < 1e-3);
        assert!((found.tail[0] - 1.0).abs() < 5e-3, "{}", found.tail[0]);
        let above = f64::from(COUNT) / libm::exp(1.0);
        assert!((found.tail[1] * above.sqrt() - 1.0).abs() < 0.01);
        assert_eq!(found.signs, [COUNT as usize, 1]);
        assert_eq!(found.mean_pull, 3.0 * scale);
        assert_eq!(found.counts.iter().sum::<usize>(), COUNT as usize);
        // The density integrates to 1.
        let density: f64 = found.table().rows.iter().map(|row| row[1] * 0.25).sum();
        assert!((density - 1.0).abs() < 1e-12);
    }
    assert_eq!(ForceDistribution::of(&[]), None);
}

#[test]
fn tails_that_hang_from_a_ring_are_rattlers() {
    // A ring of four with a tail of three, and a contact without force.
    let pairs = [[0, 1], [1, 2], [2, 3], [3, 0], [3, 4], [4, 5], [5, 6]];
    let mut contacts: Vec<_> = pairs
        .map(|[a, b]| push(a, Partner::Particle(b), Vector3::x(), 1.0))
        .to_vec();
    contacts.push(push(6, Partner::Particle(0), Vector3::x(), 0.0));
    let (places, _) = row(7, Vector3::x(), 1.0);
    let mut options = MeasureOptions::default();
    let found = Measures::of(with_forces(places.clone(), contacts.clone()), &options).unwrap();
    assert_eq!(found.coordination.rattlers, 3);
    assert_eq!(found.coordination.mean, 2.0);
    assert_eq!(found.coordination.mean_without, 2.0);
    options.least_contacts = 3;
    let found = Measures::of(with_forces(places, contacts), &options).unwrap();
    assert_eq!(found.coordination.rattlers, 7);
    assert!(found.coordination.mean_without.is_nan());
}

#[test]
fn slices_along_every_axis_hold_all_of_the_solid() {
    let mut random = Random::new(8, 0);
    let places: Vec<_> = (0..40)
        .map(|_| Vector3::from_fn(|_, _| 20.0 * random.unit()))
        .collect();
    let radii: Vec<f64> = (0..40).map(|_| 0.5 + random.unit()).collect();
    for axis in 0..3 {
        for slices in [1, 7] {
            let gas = Assembly::new(cube(20.0), places.clone(), radii.clone());
            let options = MeasureOptions {
                axis,
                slices,
                ..MeasureOptions::default()
            };
            let found = Measures::of(gas, &options).unwrap();
            let mean: f64 = found
                .profile
                .slices
                .iter()
                .map(|slice| slice[2])
                .sum::<f64>()
                / slices as f64;
            assert!((mean - found.porosity).abs() < 1e-12, "{axis}");
            let centres: f64 = found.profile.slices.iter().map(|slice| slice[3]).sum();
            assert_eq!(centres, 40.0);
        }
    }
}

#[test]
fn a_neck_slides_and_turns_at_its_thresholds() {
    let (places, contacts) = row(2, Vector3::x(), 1.0);
    for (radii, effective) in [([1.0, 1.0], 0.5), ([1.0, 3.0], 0.75)] {
        for (mu, mu_t, mu_n) in [(0.3, 0.1, 0.2), (0.5, 0.0, 0.9)] {
            let mut pair = with_forces(places.clone(), contacts.clone());
            pair.radii = radii.to_vec();
            pair.scene = json!({"mu": mu, "mu_rolling": mu_t, "mu_torsion": mu_n});
            let found = Measures::of(pair, &MeasureOptions::default())
                .unwrap()
                .necks;
            let neck = found.necks[0];
            assert!((neck.effective_radius - effective).abs() < 1e-15);
            assert!((neck.rolling_lever - mu_t * effective).abs() < 1e-15);
            // The largest torque of a uniform round contact: 2/3 mu P R_c.
            assert!((2.0 / 3.0 * mu * neck.radius - mu_n * effective).abs() < 1e-15);
            assert_eq!(found.beyond, usize::from(neck.radius > 1.0));
        }
    }
    let stranger = Measures::of(with_forces(places, contacts), &MeasureOptions::default()).unwrap();
    assert_eq!(stranger.necks.coefficients, None);
    assert!(stranger.necks.necks[0].radius.is_nan());
}

#[test]
fn fluctuations_of_the_motion_press_and_a_common_motion_does_not() {
    for drift in [Vector3::zeros(), Vector3::new(3.0, -2.0, 1.0)] {
        let (places, _) = row(2, Vector3::x(), 1.0);
        let mut pair = with_forces(places, Vec::new());
        pair.space = cube(10.0);
        pair.enclose();
        pair.velocities = Some(vec![drift + Vector3::y() * 0.5, drift - Vector3::y() * 0.5]);
        let options = MeasureOptions {
            density: Some(2.0),
            ..MeasureOptions::default()
        };
        let stress = Measures::of(pair, &options).unwrap().stress.unwrap();
        let mass = 2.0 * 4.0 / 3.0 * PI;
        let expected = 2.0 * mass * 0.25 / 1000.0;
        assert!((stress.kinetic.m22 / expected - 1.0).abs() < 1e-12);
        assert!((stress.pressure() / expected - 1.0 / 3.0).abs() < 1e-12);
    }
}

/// Random spheres in a box that repeats along all axes but one, with forces between neighbours and velocities.
fn stirred(open: Option<usize>) -> Assembly {
    let mut random = Random::new(11, 3);
    let mut periods = [Some(9.0), Some(8.0), Some(7.0)];
    if let Some(axis) = open {
        periods[axis] = None;
    }
    let vector = |random: &mut Random, scale: f64| Vector3::from_fn(|_, _| scale * random.unit());
    let places: Vec<_> = (0..60).map(|_| vector(&mut random, 7.0)).collect();
    let velocities = (0..60)
        .map(|_| vector(&mut random, 2.0) - Vector3::repeat(1.0))
        .collect();
    let radii = (0..60).map(|n| 0.4 + 0.01 * f64::from(n)).collect();
    let mut state = Assembly::new(PeriodicBox::new(periods).unwrap(), places, radii);
    state.touch(0.1).unwrap();
    for contact in &mut state.contacts {
        contact.force = contact.normal * random.unit() + Vector3::new(0.1, -0.2, 0.05);
    }
    state.forces = KnownForces::Complete;
    state.velocities = Some(velocities);
    state
}

#[test]
fn layers_share_out_volume_momentum_and_stress_across_every_axis() {
    for (axis, open) in (0..3).flat_map(|axis| [(axis, None), (axis, Some(axis))]) {
        let state = stirred(open);
        let options = MeasureOptions {
            axis,
            slices: 5,
            ..MeasureOptions::default()
        };
        let flow = LayerProfile::of(&[state.clone(), state.clone()], (axis, 5), None).unwrap();
        let found = Measures::of(state.clone(), &options).unwrap();
        let volume = state.volume() / 5.0;
        let mut momentum = Vector3::zeros();
        let mut stress = [0.0; 4];
        for (layer, slice) in flow.layers.iter().zip(&found.profile.slices) {
            let ends = layer.ends.iter().zip(slice);
            assert!(ends.into_iter().all(|(a, b)| (a - b).abs() < 1e-12));
            // The profile of one state has its slices by other code.
            let solid = layer.solid_fraction.mean;
            assert!((solid - (1.0 - slice[2])).abs() < 1e-12, "{axis}");
            let velocity = layer.velocity.map(|mean| mean.mean);
            momentum += Vector3::from(velocity) * (solid * volume);
            // The motion of a layer beside that about it.
            let flow = |[i, j]: [usize; 2]| solid * velocity[i] * velocity[j];
            let parts = [[0, 0], [1, 1], [2, 2], [0, 2]].map(flow);
            for ((sum, mean), flow) in stress.iter_mut().zip(layer.stress).zip(parts) {
                *sum += (mean.mean + flow) / 5.0;
            }
            let [_, _, zz, xz] = layer.stress.map(|mean| mean.mean);
            let ratio = layer.stress_ratio.mean;
            assert!(zz <= 0.0 || (ratio + xz / zz).abs() < 1e-12, "{ratio}");
        }
        let masses: Vec<f64> = state
            .radii
            .iter()
            .map(|r| 4.0 / 3.0 * PI * (r * r * r))
            .collect();
        let moving = || state.velocities.iter().flatten().zip(&masses);
        let whole: Vector3<f64> = moving().map(|(v, m)| v * *m).sum();
        assert!(
            (momentum - whole).norm() < 1e-11 * masses.iter().sum::<f64>(),
            "{axis}"
        );
        let motion: Matrix3<f64> = moving().map(|(v, m)| v * v.transpose() * *m).sum();
        let contacts = found.stress.unwrap();
        let total = contacts.plus + contacts.minus + motion / state.volume();
        let total = [total.m11, total.m22, total.m33, total.m13];
        for (sum, total) in stress.into_iter().zip(total) {
            assert!(
                (sum - total).abs() < 1e-12 * (1.0 + total.abs()),
                "{axis}: {sum} {total}"
            );
        }
    }
}

#[test]
fn layers_are_means_over_time_and_leave_out_what_is_held() {
    let mut state = stirred(None);
    let spheres = state.radii.len();
    let speed = |states: &[Assembly], from| {
        let flow = LayerProfile::of(states, (2, 1), from).unwrap();
        flow.layers[0].velocity[0].mean
    };
    let at_rest = speed(&[state.clone(), state.clone()], None);
    let mut faster = state.clone();
    faster
        .velocities
        .iter_mut()
        .flatten()
        .for_each(|v| v.x += 1.0);
    (state.time, faster.time) = (Some(0.0), Some(1.0));
    let mut last = faster.clone();
    last.velocities
        .iter_mut()
        .flatten()
        .for_each(|v| v.x += 1.0);
    last.time = Some(4.0);
    // The state at 1 counts for one second, that at 4 for three; the first begins the time.
    let states = [state.clone(), faster, last];
    assert!((speed(&states, Some(0.0)) - at_rest - 1.75).abs() < 1e-12);
    assert!((speed(&states, Some(1.0)) - at_rest - 2.0).abs() < 1e-12);
    assert!(LayerProfile::of(&states, (2, 1), Some(4.0)).is_none());
    state.time = None;
    // Glued grains are no part of the flow; types of other programs' files are.
    state.materials = Some(
        (0..spheres)
            .map(|n| if n % 2 == 0 { 7 } else { 1 })
            .collect(),
    );
    let solid = |state: &Assembly| {
        LayerProfile::of(&[state.clone(), state.clone()], (2, 3), None)
            .unwrap()
            .layers[1]
            .solid_fraction
            .mean
    };
    let all = solid(&state);
    state.scene = json!({"body": "grains", "fixed_kinds": "7", "driven_kinds": "8"});
    assert!(solid(&state) < 0.7 * all);
    state.velocities = None;
    assert!(LayerProfile::of(&[state.clone(), state], (2, 3), None).is_none());
}
