//! Formulas of single exhibits against closed forms and other programs.

use std::f64::consts::PI;
use tribos_report::figure::FigureError;
use tribos_thesis::asperities::{HertzSphere, RoughSurface};
use tribos_thesis::exhibits::contact_laws::ContactLaws;
use tribos_thesis::exhibits::heat::surface;
use tribos_thesis::exhibits::settling::{attraction, weight};
use tribos_thesis::reference_integration::{Points, to_rest};

const LAWS: ContactLaws = ContactLaws {
    mu: 0.3,
    mu_rolling: 0.1,
    mu_torsion: 0.4,
    cohesion_force: 1.0,
    cohesion_range: 0.01,
    effective_radius: 0.5,
};

#[test]
fn both_figures_name_their_axes_and_marks() -> Result<(), FigureError> {
    let normal = LAWS.figure_4_2().svg()?;
    for text in [
        "gap",
        "normal force F_n",
        "−F_coh",
        "d_c",
        "any",
        "v_t",
        "F_n = F_coh",
    ] {
        assert!(normal.contains(text), "{text}");
    }
    let torques = LAWS.figure_4_3().svg()?;
    for text in ["ω_t", "ω_n", "T_t", "T_n", "F_n = 0"] {
        assert!(torques.contains(text), "{text}");
    }
    Ok(())
}

#[test]
fn each_coefficient_moves_its_own_graph_only() -> Result<(), FigureError> {
    let torques = LAWS.figure_4_3().svg()?;
    let sliding = ContactLaws { mu: 0.6, ..LAWS };
    assert_eq!(sliding.figure_4_3().svg()?, torques);
    assert_ne!(sliding.figure_4_2().svg()?, LAWS.figure_4_2().svg()?);

    // Ticks at the largest thresholds, 2 μ_t r_eff = 0.1 and 2 μ_n r_eff = 0.4.
    let halves: Vec<&str> = torques.split("Torsion").collect();
    let shown = |half: &str| ["\n0.1\n", "\n0.4\n"].map(|tick| half.contains(tick));
    assert_eq!(shown(halves[0]), [true, false]);
    assert_eq!(shown(halves[1]), [false, true]);

    // Coefficients count as lengths, together with r_eff.
    let halved = ContactLaws {
        mu_rolling: LAWS.mu_rolling * 2.0,
        mu_torsion: LAWS.mu_torsion * 2.0,
        effective_radius: LAWS.effective_radius / 2.0,
        ..LAWS
    };
    assert_eq!(halved.figure_4_3().svg()?, torques);
    Ok(())
}

#[test]
fn no_resistance_is_drawn_as_a_flat_graph() -> Result<(), FigureError> {
    let free = ContactLaws {
        mu: 0.0,
        mu_rolling: 0.0,
        mu_torsion: 0.0,
        ..LAWS
    };
    free.figure_4_2().svg()?;
    free.figure_4_3().svg()?;
    Ok(())
}

#[test]
fn the_surface_follows_the_closed_form() {
    let times = [0.25, 1.0];
    for (time, ours) in times.into_iter().zip(surface(&times)) {
        let exact = 2.0 * f64::sqrt(time / PI);
        assert!((ours / exact - 1.0).abs() < 3e-3, "{time}: {ours} {exact}");
    }
}

#[test]
fn attractions_are_those_of_hamaker() {
    // python3: 1e-19*1e-7/(6*0.165e-9**2), and 1e-19*5e-8/(12*0.165e-9**2) of two smooth spheres of 100 nm.
    assert!((attraction(1e-4) / 6.121824e-8 - 1.0).abs() < 1e-6);
    assert!((attraction(1e-7) / 1.530456e-8 - 1.0).abs() < 1e-6);
    // (π/6) 2650·9.81·10⁻¹² at 100 µm.
    assert!((weight(1e-4) / 1.361174e-8 - 1.0).abs() < 1e-5);
}

#[test]
fn points_have_the_known_limits_and_stops() {
    let (ring, disk) = (Points::ring(720), Points::disk(32, 32));
    // Pure spin: T = 1 and 2/3; a little slide on it: F = ε/2 and ε.
    let [force, torque] = ring.reduced(0.0, 1e-4);
    assert!((force / 1e-4 - 0.5).abs() < 1e-6 && (torque - 1.0).abs() < 1e-6);
    let [force, torque] = disk.reduced(0.0, 1e-4);
    assert!((force / 1e-4 - 1.0).abs() < 1e-3 && (torque - 2.0 / 3.0).abs() < 1e-3);
    // The linear law decouples: F = ε and T = ⟨r²⟩.
    let [force, torque] = disk.reduced(1.0, 0.7);
    assert!((force - 0.7).abs() < 1e-14 && (torque - 0.5).abs() < 1e-3);
    // A pure slide ends after v/κ and v²/(2κ).
    let slide = to_rest(
        |v| ring.friction(v, 0.0, [0.0; 2]),
        0.0,
        1.0,
        [2.0, 0.0, 0.0],
    );
    assert!((slide.time - 2.0).abs() < 1e-4 && (slide.place[0] - 2.0).abs() < 1e-8);
}

#[test]
fn a_sphere_indents_by_hertz() {
    let (radius, contact_modulus) = (0.02_f64, 7e10);
    let sphere = HertzSphere {
        radius,
        contact_modulus,
    };
    for load in [1e-9, 1e-3, 1.0, 1e4] {
        // Back from the contact radius: L = 4E*a³/(3R).
        let a = (sphere.area(load) / PI).sqrt();
        let back = 4.0 * contact_modulus * a.powi(3) / (3.0 * radius);
        assert!((back / load - 1.0).abs() < 1e-13, "{back} for {load}");
    }
}

/// ∫ f over [0, ∞) by the trapezoid of x = exp(t − e^(−t)), which dies twice exponentially at
/// zero.
fn half_line(scale: f64, f: impl Fn(f64) -> f64) -> f64 {
    let step = 1.0 / 64.0;
    (-400..500)
        .map(|i| {
            let t = f64::from(i) * step;
            let x = (t - (-t).exp()).exp();
            f(scale * x) * scale * x * (1.0 + (-t).exp()) * step
        })
        .sum()
}

#[test]
fn exponential_asperities_make_area_proportional_to_load() {
    let tip = HertzSphere {
        radius: 2e-4,
        contact_modulus: 1e11,
    };
    let decay_length = 1e-6;
    let rough = RoughSurface { decay_length, tip };
    for separation in [0.0_f64, 2e-6, 1e-5] {
        // Sum of Hertz contacts of tips that reach `indent` beyond the separation.
        let density = |indent: f64| 1e9 * (-(separation + indent) / decay_length).exp();
        let load_of =
            |indent: f64| 4.0 / 3.0 * tip.contact_modulus * (tip.radius * indent.powi(3)).sqrt();
        let sum = |of: &dyn Fn(f64) -> f64| half_line(decay_length, |z| density(z) * of(z));
        let (load, area) = (sum(&load_of), sum(&|z| tip.area(load_of(z))));
        assert!((rough.mean_pressure() * area / load - 1.0).abs() < 1e-12);
    }
}
