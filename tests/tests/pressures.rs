//! Force, torque, lateral function and derivatives of other pressures against 25-digit tables.

use tribos_core::coupling::round::RoundTable64;
use tribos_core::coupling::{Coupling, Lateral, compact};
use tribos_core::patch::PowerPressure;
use tribos_tests::tables::Table;

#[test]
fn probe() {
    for name in [
        "ring.csv",
        "hertz.csv",
        "punch.csv",
        "paraboloid.csv",
        "pressures.csv",
    ] {
        let table = Table::read(name);
        for which in 0..2 {
            let mut worst: [(f64, String); 5] = std::array::from_fn(|_| (0.0, String::new()));
            for row in table.rows() {
                let (q, alpha, eps) = (row.number("q"), row.number("alpha"), row.number("eps"));
                let p = PowerPressure::new(q).unwrap();
                let t;
                let c;
                let tier: (&dyn Coupling<f64>, &dyn Lateral<f64>) = if which == 0 {
                    t = RoundTable64::new(alpha, p).unwrap();
                    (&t, &t)
                } else {
                    c = compact::Power::with_pressure(alpha, p).unwrap();
                    (&c, &c)
                };
                let w = tier.0.reduced_wrench(eps, 1.0);
                let j = tier.0.reduced_jacobian(eps, 1.0);
                let g = tier.1.lateral(eps, 1.0);
                let gname = "G";
                for (i, (n, x)) in [
                    ("F", w.force),
                    ("T", w.torque),
                    (gname, g),
                    ("dF", j.force_slide),
                    ("dT", j.mixed),
                ]
                .into_iter()
                .enumerate()
                {
                    let want = row.number(n);
                    if !want.is_finite() {
                        if x != want {
                            println!("{name} {q} {alpha} {eps} {n}: {x} {want}");
                        }
                        continue;
                    }
                    let e = if want == 0.0 {
                        x.abs()
                    } else {
                        ((x - want) / want).abs()
                    };
                    if e > worst[i].0 || e.is_nan() {
                        worst[i] = (e, format!("{n} q {q} alpha {alpha} eps {eps}: {x} {want}"));
                    }
                }
            }
            println!("{name} {which}");
            for w in &worst {
                println!("   {:.1e} {}", w.0, w.1);
            }
        }
    }
}
