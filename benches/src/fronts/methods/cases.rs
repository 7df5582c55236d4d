//! The trials, their methods and parameters.

use tribos_trials::{Ball, Column, Compacted, Cooling, Method, Slope, Trial};

/// A trial with what is compared on it.
pub struct Case {
    pub stem: &'static str,
    pub title: String,
    pub about: String,
    pub trial: Box<dyn Trial + Send>,
    pub methods: Vec<Method>,
    /// The row whose time is 1.
    pub unit: Method,
    /// The quantity that is drawn.
    pub drawn: usize,
}

/// Usual tolerances and stiffnesses.
const TOLERANCES: [f64; 4] = [1e-2, 1e-4, 1e-6, 1e-9];
const STIFFNESSES: [f64; 3] = [1e3, 1e4, 1e5];
/// The row with which others are compared.
const UNIT: f64 = 1e-6;
/// Steps in √(R/g).
const STEP: f64 = 0.1;
/// Sweeps of a row that may not have more.
const FEW: usize = 10;

/// All trials.
pub fn cases(quick: bool) -> Result<Vec<Case>, String> {
    let mut all = vec![column(quick), heavy(quick), ball(), slope(quick)];
    for fraction in [0.05, 0.3] {
        all.push(gas(fraction, quick)?);
    }
    all.push(deposit(quick));
    Ok(all)
}

/// Rows of contact dynamics by tolerance, one with few sweeps, and soft particles.
fn usual(step: f64, stiffnesses: &[f64]) -> Vec<Method> {
    let few = Method::ContactDynamics {
        tolerance: UNIT,
        sweeps: FEW,
        step,
    };
    let rigid = TOLERANCES.map(|tolerance| Method::rigid(tolerance, step));
    let soft = stiffnesses.iter().map(|&k| Method::soft(k));
    rigid.into_iter().chain([few]).chain(soft).collect()
}

fn column(quick: bool) -> Case {
    let trial = Column {
        spheres: 20,
        top: 1.0,
        time: if quick { 20.0 } else { 40.0 },
    };
    Case {
        stem: "column",
        title: "Force on the floor under a column".into(),
        about: format!(
            "{} spheres that touch and are let go, for {} √(R/g): largest errors in the second half; k in the weight of \
             all over R",
            trial.spheres, trial.time
        ),
        trial: Box::new(trial),
        methods: usual(STEP, &STIFFNESSES),
        unit: Method::rigid(UNIT, STEP),
        drawn: 0,
    }
}

fn heavy(quick: bool) -> Case {
    let trial = Column {
        spheres: 6,
        top: 1e6,
        time: if quick { 4.0 } else { 20.0 },
    };
    // Ten sweeps leave the heavy sphere to fall through the light ones.
    let is_enough =
        |method: &Method| !matches!(method, Method::ContactDynamics { sweeps: FEW, .. });
    let stiffnesses: &[f64] = if quick { &[1e3] } else { &[1e3, 1e4] };
    let methods = usual(STEP, stiffnesses);
    let methods = methods.into_iter().filter(is_enough).collect();
    Case {
        stem: "heavy",
        title: "A mass of 10⁶ on five of 1".into(),
        about: format!(
            "As before, for {} √(R/g); with ten sweeps a step the heavy sphere falls through the light ones",
            trial.time
        ),
        trial: Box::new(trial),
        methods,
        unit: Method::rigid(UNIT, STEP),
        drawn: 0,
    }
}

fn ball() -> Case {
    let trial = Ball {
        mu: 0.2,
        speed: 2.0,
    };
    let mut methods: Vec<Method> = [0.1, 0.01, 0.001, 1e-4]
        .map(|step| Method::rigid(UNIT, step))
        .to_vec();
    methods.extend(STIFFNESSES.map(Method::soft));
    methods.push(Method::Soft {
        stiffness: STIFFNESSES[1],
        steps: 200.0,
    });
    Case {
        stem: "ball",
        title: "A ball slides into rolling".into(),
        about: format!(
            "μ = {}, v = {} √(g R): speed 5/7 v, and the way to 1.5 times the instant of rolling over 12 v²/(49 μ g); k \
             in m g/R",
            trial.mu, trial.speed
        ),
        trial: Box::new(trial),
        methods,
        unit: Method::rigid(UNIT, 0.01),
        drawn: 1,
    }
}

fn slope(quick: bool) -> Case {
    let trial = Slope {
        mu: 0.5,
        mu_rolling: 0.2,
        slope: 0.1,
        time: if quick { 20.0 } else { 100.0 },
    };
    Case {
        stem: "slope",
        title: "Creep on a slope below all thresholds".into(),
        about: format!(
            "Five spheres on a slope of {}, where one would roll at {} and slide at {}: mean speed in the second half of \
             {} √(R/g), and displacement since the start; k in m g/R",
            trial.slope, trial.mu_rolling, trial.mu, trial.time
        ),
        trial: Box::new(trial),
        methods: usual(STEP, &STIFFNESSES),
        unit: Method::rigid(UNIT, STEP),
        drawn: 0,
    }
}

fn gas(fraction: f64, quick: bool) -> Result<Case, String> {
    let (starts, references) = if quick { (4, 16) } else { (6, 100) };
    let trial = Cooling {
        count: if quick { 500 } else { 1000 },
        fraction,
        restitution: 0.9,
        collisions: 10.0,
        seeds: [1, starts],
        reference: f64::NAN,
    };
    let trial = trial.referred([1001, references]);
    let trial = trial.map_err(|error| error.to_string())?;
    let mut methods = vec![Method::Events];
    methods.extend([0.2, 0.05, 0.0125].map(|motion| Method::rigid(1e-4, motion)));
    methods.extend(
        if quick {
            &STIFFNESSES[..2]
        } else {
            &STIFFNESSES[..]
        }
        .iter()
        .map(|&k| Method::soft(k)),
    );
    Ok(Case {
        stem: if fraction < 0.1 {
            "gas 0.05"
        } else {
            "gas 0.3"
        },
        title: format!("A gas cools at φ = {fraction}"),
        about: format!(
            "{} spheres, e = {}, T after {} collisions a sphere: mean of {starts} starts against events from {references} \
             others, T/T₀ = {:.5} (mean field {:.5}); step: largest motion in R; k in T₀/R²",
            trial.count,
            trial.restitution,
            trial.collisions,
            trial.reference,
            (-(1.0 - trial.restitution * trial.restitution) * trial.collisions / 3.0).exp()
        ),
        trial: Box::new(trial),
        methods,
        unit: Method::Events,
        drawn: 0,
    })
}

fn deposit(quick: bool) -> Case {
    let trial = Compacted {
        size: if quick { [8.0, 16.0] } else { [14.0, 40.0] },
        pressure: 0.0025,
    };
    let tolerances: &[f64] = if quick {
        &[1e-2, 1e-3, 1e-4]
    } else {
        &[1e-2, 1e-3, 1e-4, 1e-5]
    };
    let mut methods: Vec<Method> = tolerances.iter().map(|&t| Method::rigid(t, 0.1)).collect();
    methods.push(Method::ContactDynamics {
        tolerance: 1e-4,
        sweeps: FEW,
        step: 0.1,
    });
    let stiffnesses = if quick {
        &STIFFNESSES[..1]
    } else {
        &STIFFNESSES[..]
    };
    methods.extend(stiffnesses.iter().map(|&k| Method::soft(k)));
    Case {
        stem: "deposit",
        title: "Overlap in a compacted deposit".into(),
        about: format!(
            "A ballistic deposit of {} R by {} R, μ = 0.3, compacted under {} F_coh/R² until it is blocked; k in F_coh/R",
            trial.size[0], trial.size[1], trial.pressure
        ),
        trial: Box::new(trial),
        methods,
        unit: Method::rigid(1e-4, 0.1),
        drawn: 0,
    }
}
