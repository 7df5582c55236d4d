//! Laws with a state: bristles and contact ages.

use crate::arrays::{Batched, Column, Numbers, Output, View, broadcast, refused};
use crate::threads::fill;
use pyo3::prelude::*;
use tribos_core::law::{
    AgeingLaw, Bristle, LocalLaw, LuGreParameters, RateStateParameters, SlipLaw, StateVariable,
    SteadyRateState,
};

/// Nanoseconds that an evaluation takes, about.
const COST: usize = 60;

/// Named numbers of a call, and the caller's array for the result.
struct Call<'a, 'py, const N: usize> {
    names: [&'static str; N],
    given: [&'a Bound<'py, PyAny>; N],
    out: Option<&'a Bound<'py, PyAny>>,
}

impl<'py, const N: usize> Call<'_, 'py, N> {
    /// What `of` makes of each element, in rows of `shape`.
    fn each<const M: usize>(
        self,
        py: Python<'py>,
        shape: &[usize],
        of: impl Fn([f64; N]) -> [f64; M] + Sync,
    ) -> PyResult<Bound<'py, PyAny>> {
        let named = self.names.into_iter().zip(self.given);
        let numbers = named.map(|(name, given)| Numbers::new(name, given));
        let numbers = numbers.collect::<PyResult<Vec<_>>>()?;
        let batched: Vec<&dyn Batched> = numbers.iter().map(|one| one as &dyn Batched).collect();
        let batch = broadcast(&batched)?;
        let columns = numbers.into_iter().map(|one| one.over(&batch));
        let columns = columns.collect::<PyResult<Vec<_>>>()?;
        let mut views = [View::One([0.0]); N];
        for ((view, column), name) in views.iter_mut().zip(&columns).zip(self.names) {
            *view = Column::view(column)?;
            if name == "dt" {
                forward(view)?;
            }
        }
        let mut output = Output::new(py, &batch, shape, self.out)?;
        fill(py, output.rows::<M>()?, COST, |from, piece| {
            for (index, row) in (from..).zip(piece) {
                *row = of(views.map(|view| view.at(index)[0]));
            }
            Ok(())
        })?;
        output.finish()
    }
}

/// Refuses steps back in time.
fn forward(dt: &View<'_, 1>) -> PyResult<()> {
    let back = match dt {
        View::One([dt]) => *dt < 0.0,
        View::Each(all) => all.iter().any(|[dt]| *dt < 0.0),
    };
    if back {
        return Err(refused("dt must be >= 0"));
    }
    Ok(())
}

/// The LuGre model.
#[pyclass(frozen, module = "tribos._native")]
pub struct LuGre(tribos_core::law::LuGre<f64>);

#[pymethods]
impl LuGre {
    /// Coulomb and static force, Stribeck speed, stiffness, damping of the bristles and of the fluid.
    #[new]
    fn new(parameters: [f64; 6]) -> PyResult<Self> {
        let [coulomb, highest, speed, stiffness, bristles, fluid] = parameters;
        let law = tribos_core::law::LuGre::new(LuGreParameters {
            coulomb_force: coulomb,
            static_force: highest,
            stribeck_speed: speed,
            stiffness,
            bristle_damping: bristles,
            viscous_damping: fluid,
        });
        Ok(Self(law.map_err(refused)?))
    }

    /// Largest deflection of the bristles, in m.
    fn largest_deflection(&self) -> f64 {
        self.0.largest_deflection()
    }

    /// Speed up to which friction dissipates, in m/s.
    fn passive_up_to(&self) -> f64 {
        self.0.passive_up_to()
    }

    /// Deflections in m after steps, and mean forces in N, in the last axis.
    fn step<'py>(
        &self,
        py: Python<'py>,
        deflection: &Bound<'py, PyAny>,
        velocity: &Bound<'py, PyAny>,
        dt: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let call = Call {
            names: ["deflection", "velocity", "dt"],
            given: [deflection, velocity, dt],
            out: None,
        };
        call.each(py, &[2], |[deflection, velocity, dt]| {
            let (bristle, force) = self.0.step(Bristle { deflection }, velocity, dt);
            [bristle.deflection, force]
        })
    }

    /// Forces at this moment, in N.
    #[pyo3(signature = (deflection, velocity, out=None))]
    fn force<'py>(
        &self,
        py: Python<'py>,
        deflection: &Bound<'py, PyAny>,
        velocity: &Bound<'py, PyAny>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let call = Call {
            names: ["deflection", "velocity"],
            given: [deflection, velocity],
            out,
        };
        call.each(py, &[], |[deflection, velocity]| {
            [self.0.force(Bristle { deflection }, velocity)]
        })
    }

    /// Rates of the deflection, in m/s.
    #[pyo3(signature = (deflection, velocity, out=None))]
    fn rate<'py>(
        &self,
        py: Python<'py>,
        deflection: &Bound<'py, PyAny>,
        velocity: &Bound<'py, PyAny>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let call = Call {
            names: ["deflection", "velocity"],
            given: [deflection, velocity],
            out,
        };
        call.each(py, &[], |[deflection, velocity]| {
            [self.0.rate(Bristle { deflection }, velocity)]
        })
    }

    /// Forces of steady sliding, in N.
    #[pyo3(signature = (velocity, out=None))]
    fn steady_force<'py>(
        &self,
        py: Python<'py>,
        velocity: &Bound<'py, PyAny>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let call = Call {
            names: ["velocity"],
            given: [velocity],
            out,
        };
        call.each(py, &[], |[velocity]| [self.0.steady_force(velocity)])
    }
}

/// The law with either evolution of its age.
enum RateStateVariant {
    Ageing(tribos_core::law::RateState<f64, AgeingLaw>),
    Slip(tribos_core::law::RateState<f64, SlipLaw>),
}

/// Rate-and-state friction.
#[pyclass(frozen, module = "tribos._native")]
pub struct RateState(RateStateVariant);

impl RateStateVariant {
    fn coefficient(&self, speed: f64, age: StateVariable<f64>) -> f64 {
        match self {
            Self::Ageing(law) => law.coefficient(speed, age),
            Self::Slip(law) => law.coefficient(speed, age),
        }
    }
    fn slope(&self, speed: f64, age: StateVariable<f64>) -> f64 {
        match self {
            Self::Ageing(law) => law.slope(speed, age),
            Self::Slip(law) => law.slope(speed, age),
        }
    }
    fn advance(&self, age: StateVariable<f64>, speed: f64, dt: f64) -> f64 {
        match self {
            Self::Ageing(law) => law.advance(age, speed, dt).theta,
            Self::Slip(law) => law.advance(age, speed, dt).theta,
        }
    }
    fn steady_age(&self, speed: f64) -> f64 {
        match self {
            Self::Ageing(law) => law.steady_age(speed).theta,
            Self::Slip(law) => law.steady_age(speed).theta,
        }
    }
    fn steady(&self) -> SteadyRateState<f64> {
        match self {
            Self::Ageing(law) => law.steady(),
            Self::Slip(law) => law.steady(),
        }
    }
}

/// An age in s; no number below 0.
fn aged(theta: f64) -> StateVariable<f64> {
    let theta = if theta < 0.0 { f64::NAN } else { theta };
    StateVariable { theta }
}

#[pymethods]
impl RateState {
    /// μ₀, a, b, reference speed, slip distance and viscous coefficient; the slip law or that of ageing.
    #[new]
    fn new(parameters: [f64; 6], evolution: &str) -> PyResult<Self> {
        let [mu, a, b, reference_speed, slip_distance, viscous] = parameters;
        let parameters = RateStateParameters {
            mu,
            a,
            b,
            reference_speed,
            slip_distance,
            viscous,
        };
        Ok(Self(match evolution {
            "ageing" => RateStateVariant::Ageing(
                tribos_core::law::RateState::new(parameters).map_err(refused)?,
            ),
            "slip" => RateStateVariant::Slip(
                tribos_core::law::RateState::new(parameters).map_err(refused)?,
            ),
            other => {
                return Err(refused(format!(
                    "evolution must be 'ageing' or 'slip', not {other:?}"
                )));
            }
        }))
    }

    /// Friction per load.
    #[pyo3(signature = (speed, age, out=None))]
    fn friction<'py>(
        &self,
        py: Python<'py>,
        speed: &Bound<'py, PyAny>,
        age: &Bound<'py, PyAny>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let call = Call {
            names: ["speed", "age"],
            given: [speed, age],
            out,
        };
        call.each(py, &[], |[speed, age]| {
            [self.0.coefficient(speed.abs(), aged(age))]
        })
    }

    /// Its derivative with respect to the speed, in s/m.
    #[pyo3(signature = (speed, age, out=None))]
    fn slope<'py>(
        &self,
        py: Python<'py>,
        speed: &Bound<'py, PyAny>,
        age: &Bound<'py, PyAny>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let call = Call {
            names: ["speed", "age"],
            given: [speed, age],
            out,
        };
        call.each(py, &[], |[speed, age]| {
            [self.0.slope(speed.abs(), aged(age))]
        })
    }

    /// Ages in s after steps at constant speed.
    #[pyo3(signature = (age, speed, dt, out=None))]
    fn step<'py>(
        &self,
        py: Python<'py>,
        age: &Bound<'py, PyAny>,
        speed: &Bound<'py, PyAny>,
        dt: &Bound<'py, PyAny>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let call = Call {
            names: ["age", "speed", "dt"],
            given: [age, speed, dt],
            out,
        };
        call.each(py, &[], |[age, speed, dt]| {
            [self.0.advance(aged(age), speed.abs(), dt)]
        })
    }

    /// Ages of steady sliding, in s.
    #[pyo3(signature = (speed, out=None))]
    fn steady_age<'py>(
        &self,
        py: Python<'py>,
        speed: &Bound<'py, PyAny>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let call = Call {
            names: ["speed"],
            given: [speed],
            out,
        };
        call.each(py, &[], |[speed]| [self.0.steady_age(speed.abs())])
    }

    /// Friction per load of steady sliding.
    #[pyo3(signature = (speed, out=None))]
    fn steady_friction<'py>(
        &self,
        py: Python<'py>,
        speed: &Bound<'py, PyAny>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let call = Call {
            names: ["speed"],
            given: [speed],
            out,
        };
        let steady = self.0.steady();
        call.each(py, &[], |[speed]| [steady.friction(speed.abs())])
    }

    /// Stiffness in N/m of a spring that pulls steadily at this speed; without one, at slow speeds.
    #[pyo3(signature = (load, speed=None))]
    fn critical_stiffness(&self, load: f64, speed: Option<f64>) -> f64 {
        let steady = self.0.steady();
        match speed {
            Some(speed) => steady.critical_stiffness_at(load, speed),
            None => steady.critical_stiffness(load),
        }
    }

    /// Speed of least friction, in m/s.
    fn minimum(&self) -> Option<f64> {
        self.0.steady().minimum()
    }
}
