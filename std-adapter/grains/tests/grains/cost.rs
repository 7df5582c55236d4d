//! Forecasts of what runs cost.

use tribos_grains::powder::PackingCost;
use tribos_grains::scene::{GrainsScene, PowderScene};
use tribos_grains::{grains, powder};

/// Far more than an update takes on any machine, in s.
const SLOW: f64 = 1e-4;

#[test]
fn updates_are_timed_under_any_laws() {
    let powder = |keys: &str| {
        let text = format!("body = \"powder\"\nwidth = 6\nheight = 8\n{keys}");
        powder::cost(&PowderScene::parse("tiny.toml", &text, &[]).unwrap()).unwrap()
    };
    let costs: [PackingCost; 5] = [
        powder("mu = 0"),
        powder(""),
        powder("mu_rolling = 1\nmu_torsion = 1\ncoupling = \"exact\""),
        powder("cohesion_range = 0"),
        grains::cost(&GrainsScene::default()).unwrap(),
    ];
    for cost in costs {
        for seconds in [cost.update_seconds, cost.sliding_seconds] {
            assert!(seconds > 0.0 && seconds < SLOW, "{cost:?}");
        }
        assert!(cost.memory() > cost.spheres * 100);
    }
}
