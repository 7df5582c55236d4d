//! scratch
use tribos::run::Simulation;
use tribos::scene::{Scene, parse_scene};
use tribos::tip::TipRun;
fn main() {
    let overrides: Vec<String> = std::env::args().skip(1).collect();
    let Scene::Tip(scene) = parse_scene("t", "body = \"tip\"\nlambda = 0.02\n", &overrides)
        .unwrap_or_else(|e| panic!("{e}"))
    else {
        panic!()
    };
    let start = std::time::Instant::now();
    let mut run = match TipRun::new(&scene) {
        Ok(r) => r,
        Err(e) => panic!("{e}"),
    };
    let n = run.system().atoms().len();
    let verbose = std::env::var("V").is_ok();
    let mut k = 0;
    loop {
        let go = match run.step() {
            Ok(g) => g,
            Err(e) => panic!("{e}"),
        };
        k += 1;
        if verbose && k % 20 == 0 {
            let line = run.series().last().unwrap();
            println!(
                "{}",
                line.iter()
                    .map(|x| format!("{x:.3}"))
                    .collect::<Vec<_>>()
                    .join(" ")
            );
        }
        if !go {
            break;
        }
    }
    let s = start.elapsed().as_secs_f64();
    let o = run.outcome();
    println!(
        "{} {:?} driven {:.2} final {:.2} layers {:.1?} slip {:?}/{:?} T {:.3} h {:.3} plateaus {:?} | {n} atoms {:.2} M/s {:.0}s builds {}",
        overrides.join(" "),
        o.verdict,
        o.driven_angle,
        o.final_angle,
        o.layer_angles,
        o.slipped_driven,
        o.slipped,
        o.tip_temperature,
        run.series().last().unwrap()[3],
        o.plateaus
            .iter()
            .map(|p| format!("{:.0}-{:.0}:{:.1}", p.from, p.to, p.angle))
            .collect::<Vec<_>>(),
        n as f64 * run.system().steps() as f64 / s / 1e6,
        s,
        run.system().list_builds()
    );
}
