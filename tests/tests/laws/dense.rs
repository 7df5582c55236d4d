//! Between the rows of the tables: dense sweeps against the other tier, the arithmetic–geometric
//! mean and a mean over the rim, with arguments crowded where formulas and cells meet.

use tribos_core::coupling::table::DiskTable64;
use tribos_core::coupling::{ReducedFriction, compact, coulomb};
use tribos_tests::patches;
use tribos_tests::reference::Reference;
use tribos_tests::rim_mean;
use tribos_tests::sweep::{self, Lcg};
use tribos_tests::tolerance;
use tribos_tests::worst::Worst;

const EXPONENTS: [f64; 15] = [
    -0.75, -0.5, -0.25, -0.1, 0.0, 0.02, 0.3, 0.75, 1.0, 1.5, 2.5, 4.0, 5.5, 8.0, 10.0,
];

#[test]
fn the_fitted_form_agrees_with_the_series() {
    let [mut force, mut torque] = ["form - series, F", "form - series, T"].map(Worst::of);
    let series = compact::CompactPower::new(0.0).unwrap();
    let mut ratios = sweep::ratios(20_000);
    ratios.extend(sweep::cell_borders());
    for ratio in ratios {
        let got = coulomb::CoulombDisk.reduced_wrench(ratio, 1.0);
        let wanted = series.reduced_wrench(ratio, 1.0);
        let place = || format!("eps {ratio:e}");
        force.see(Reference::exact(wanted.force).relative(got.force), place);
        torque.see(Reference::exact(wanted.torque).relative(got.torque), place);
    }
    force.assert_within(&tolerance::TIERS_AGREE);
    torque.assert_within(&tolerance::TIERS_AGREE);
}

#[test]
fn tables_agree_with_the_compact_form_on_every_cell() {
    let mut wrench = Worst::of("table - compact, F and T");
    let mut jacobian = Worst::of("table - compact, Jacobian (of F/v)");
    let mut ratios = sweep::ratios(2_000);
    ratios.extend(sweep::cell_borders());
    for alpha in EXPONENTS {
        let table = DiskTable64::new(alpha).unwrap();
        let compact = compact::CompactPower::new(alpha).unwrap();
        for &ratio in &ratios {
            let place = || format!("alpha {alpha}, eps {ratio:e}");
            let wanted = compact.reduced_wrench(ratio, 1.0);
            let got = table.reduced_wrench(ratio, 1.0);
            wrench.see(Reference::exact(wanted.force).relative(got.force), place);
            wrench.see(Reference::exact(wanted.torque).relative(got.torque), place);
            let wanted = compact.reduced_jacobian(ratio, 1.0);
            let got = table.reduced_jacobian(ratio, 1.0);
            for (wanted, got) in [
                (wanted.force_per_slide, got.force_per_slide),
                (wanted.force_slide, got.force_slide),
                (wanted.mixed, got.mixed),
                (wanted.torque_rim, got.torque_rim),
            ] {
                let scale = compact.reduced_jacobian(ratio, 1.0).force_per_slide;
                jacobian.see(Reference::exact(wanted).over(got, scale), place);
            }
        }
    }
    wrench.assert_within(&tolerance::TIERS_AGREE);
    jacobian.assert_within(&tolerance::JACOBIAN_DENSE);
}

/// Worst distance of the exact tiers from the rim mean; torques in units of v F + w T, and up to
/// ε = 1.5, where the oracle's own difference loses digits.
fn against_rim_mean(quantity: &'static str, low: f64, high: f64) -> Worst {
    let mut worst = Worst::of(quantity);
    let mut rng = Lcg::new(5);
    for _ in 0..60 {
        let alpha = rng.between(low, high);
        let tiers = patches::exact::<f64>(alpha);
        for n in 0..40 {
            let ratio = match n % 4 {
                0 => rng.log_between(1e-4, 1e4),
                1 => 1.0 + rng.log_between(1e-14, 0.5),
                2 => 1.0 - rng.log_between(1e-14, 0.5),
                _ => rng.between(0.0, 2.0),
            };
            let [force, torque] = rim_mean::force_and_torque(alpha, ratio);
            for (name, tier) in &tiers {
                let place = || format!("{name}, alpha {alpha}, eps {ratio:e}");
                let got = tier.reduced_wrench(ratio, 1.0);
                worst.see(Reference::exact(force).relative(got.force), place);
                if ratio < 1.5 {
                    let power = torque + ratio * force;
                    worst.see((torque - got.torque).abs() / power, place);
                }
            }
        }
    }
    worst
}

#[test]
fn random_exponents_agree_with_a_mean_over_the_rim() {
    against_rim_mean("F, T - rim mean, alpha [-0.5, 10]", -0.5, 10.0)
        .assert_within(&tolerance::RIM_MEAN);
    against_rim_mean("F, T - rim mean, alpha [-0.95, -0.5]", -0.95, -0.5)
        .assert_excused(&tolerance::RIM_MEAN_DEEP, &tolerance::RIM_MEAN);
}

#[test]
fn quadrature_keeps_its_promise_between_the_rows() {
    let [mut rising, mut falling, mut jacobian] = [
        "quadrature - compact, F and T, alpha [0, 5]",
        "quadrature - compact, F and T, alpha [-0.5, 0)",
        "quadrature - compact, Jacobian, alpha [0, 5] (of F/v)",
    ]
    .map(Worst::of);
    let mut ratios = sweep::ratios(1_000);
    ratios.extend([2.0, 2.0_f64.next_up(), 2.0_f64.next_down()]);
    for alpha in [
        -0.5, -0.4, -0.25, -0.1, 0.0, 0.02, 0.1, 0.3, 0.5, 0.75, 1.0, 2.0, 3.5, 4.5, 5.0,
    ] {
        let compact = compact::CompactPower::new(alpha).unwrap();
        let (_, quadrature) = patches::all::<f64>(alpha).pop().unwrap();
        for &ratio in &ratios {
            let place = || format!("alpha {alpha}, eps {ratio:e}");
            let wanted = compact.reduced_wrench(ratio, 1.0);
            let got = quadrature.reduced_wrench(ratio, 1.0);
            let wrench = if alpha < 0.0 {
                &mut falling
            } else {
                &mut rising
            };
            wrench.see(Reference::exact(wanted.force).relative(got.force), place);
            wrench.see(Reference::exact(wanted.torque).relative(got.torque), place);
            if alpha < 0.0 {
                continue;
            }
            let wanted = compact.reduced_jacobian(ratio, 1.0);
            let got = quadrature.reduced_jacobian(ratio, 1.0);
            for (wanted, got) in [
                (wanted.force_slide, got.force_slide),
                (wanted.mixed, got.mixed),
                (wanted.torque_rim, got.torque_rim),
            ] {
                let scale = compact.reduced_jacobian(ratio, 1.0).force_per_slide;
                jacobian.see(Reference::exact(wanted).over(got, scale), place);
            }
        }
    }
    rising.assert_within(&tolerance::QUADRATURE);
    falling.assert_within(&tolerance::QUADRATURE_FALLING);
    jacobian.assert_within(&tolerance::QUADRATURE_JACOBIAN);
}
