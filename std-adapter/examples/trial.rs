use nalgebra::Vector3;
use std::time::Instant;
use tribos::cd::*;
use tribos::powder::deposit::*;
use tribos::space::PeriodicBox;
use tribos_core::contact::*;
fn arg<T: std::str::FromStr>(n: usize, d: T) -> T {
    std::env::args()
        .nth(n)
        .and_then(|a| a.parse().ok())
        .unwrap_or(d)
}
fn main() {
    let mu_t: f64 = arg(1, 0.0);
    let mu_n: f64 = arg(2, 0.0);
    let seed: u64 = arg(3, 1);
    let motion: f64 = arg(4, 0.02);
    let tol: f64 = arg(5, 1e-5);
    let method: String = arg(6, "acc".into());
    let width: f64 = arg(7, 20.0);
    let height: f64 = arg(8, 61.5);
    let most: usize = arg(9, 1000);
    let dc: f64 = arg(10, 1e-2);
    let f = Thresholds::all(0.3, mu_t, mu_n).unwrap();
    let method = match method.as_str() {
        "acc" => Method::Accelerated { tolerance: tol },
        "gs" => Method::GaussSeidel {
            order: Order::Alternating,
            stop: Stop::Global(tol),
        },
        _ => Method::GaussSeidel {
            order: Order::Random { seed: 1 },
            stop: Stop::Global(tol),
        },
    };
    let d = Ballistic::new(width, 1.0, 3.0)
        .unwrap()
        .grow(Until::Height(height), seed)
        .unwrap();
    let n = d.positions.len();
    let coh = NormalLaw::new(Cohesion::new(1.0, dc, Attraction::Pull).unwrap(), 0.0).unwrap();
    let z = Vector3::z();
    let p = 1.0 / 400.0;
    let walls = vec![
        Wall::fixed(z, 0.0),
        Wall::piston(-z, -d.height, 1000.0, p * width * width),
    ];
    let volume: f64 = n as f64 * 4.0 / 3.0 * std::f64::consts::PI;
    let spheres = d.radii.iter().map(|&r| solid(r, 1.0)).collect();
    let mut w = World::new(Setup {
        space: PeriodicBox::new([Some(width), Some(width), None]).unwrap(),
        positions: d.positions,
        radii: d.radii,
        spheres,
        walls,
        laws: Laws::uniform(coh, f),
        gravity: Vector3::zeros(),
        pace: Pace {
            longest: 0.2,
            motion,
        },
        solver: Solver {
            method,
            most_sweeps: most,
            warm_start: true,
        },
        still_speed: 1e-7,
    })
    .unwrap();
    let t0 = Instant::now();
    let (mut sweeps, mut updates) = (0usize, 0usize);
    let mut h_old = -w.state().walls[1].place;
    let mut unmet = 0;
    let mut forces = 0.0;
    let mut worst_res = 0.0f64;
    let mut overlap = 0.0f64;
    for k in 1..200000u64 {
        let r = w.step().unwrap();
        sweeps += r.effort.sweeps;
        updates += r.effort.sweeps * r.contacts;
        unmet += usize::from(!r.effort.met);
        worst_res = worst_res.max(r.residual.relative);
        overlap = overlap.max(r.residual.penetration * r.dt);
        let contact: f64 = w
            .problem()
            .walls
            .iter()
            .filter(|l| l.bodies[1] == 1)
            .map(|l| l.contact.impulse().normal / r.dt)
            .sum();
        forces += contact / (p * width * width);
        if k == arg(11, 0) {
            let mut cold = w.problem().clone();
            let n = cold.contacts();
            for c in 0..n {
                cold.guess(c, &Modal::default());
            }
            cold.refresh();
            let z = 1e-8;
            let most = 100000;
            println!("contacts {n}");
            let run = |name: &str, f: &mut dyn FnMut(&mut Spheres<_>) -> Effort| {
                let mut p = cold.clone();
                let t = Instant::now();
                let e = f(&mut p);
                println!(
                    "{name:20} {:6} {} {:.3}s {:.1e}",
                    e.sweeps,
                    e.met,
                    t.elapsed().as_secs_f64(),
                    residual(&p).relative
                );
            };
            run("acc", &mut |p| Accelerated::default().solve(p, z, most));
            run("gs", &mut |p| {
                solve(p, &mut Sweeper::new(Order::Fixed, 0), Stop::Global(z), most)
            });
            return;
        }
        if k % 500 == 0 {
            let h = -w.state().walls[1].place;
            println!(
                "{k:6} t {:.1} dt {:.3} h {h:.4} E {:.4} contacts {} awake {} sweeps/step {:.0} unmet {unmet} F/F0 {:.4} kin {:.2e} worst {:.1e} over {:.1e} imb {:.1e} {:.1}s {:.1} Mups",
                w.state().time,
                r.dt,
                1.0 - volume / (width * width * h),
                r.contacts,
                r.awake,
                sweeps as f64 / k as f64,
                forces / 500.0,
                w.state().book.kinetic,
                worst_res,
                overlap,
                w.state().book.imbalance(),
                t0.elapsed().as_secs_f64(),
                updates as f64 / t0.elapsed().as_secs_f64() / 1e6
            );
            if (h_old - h).abs() < 1e-3 && (forces / 500.0 - 1.0).abs() < 1e-2 {
                println!("blocked {:?}", w.state().book);
                break;
            }
            h_old = h;
            forces = 0.0;
            worst_res = 0.0;
            unmet = 0;
        }
    }
}
