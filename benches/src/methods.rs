//! One interface for every method and tier, with common timing, error and name.

use crate::errors::Errors;
use crate::mix;
use crate::reference::{self, Wide};
use core::fmt;
use std::hint::black_box;
use tribos_core::coupling::unscaled_wrench;
use tribos_core::coupling::{ReducedFriction, ReducedWrench, compact};
use tribos_core::real::Real;

/// Kind of a method.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A tier of the kernel.
    Tier,
    /// Elliptic integrals by another route.
    Elliptic,
    /// A double sum over the disk.
    Integration,
    /// An approximation in use.
    Approximation,
}

impl Kind {
    /// Name of the kind in reports.
    pub fn name(self) -> &'static str {
        match self {
            Self::Tier => "tier",
            Self::Elliptic => "elliptic",
            Self::Integration => "integration",
            Self::Approximation => "approximation",
        }
    }
}

/// Pairs `[slide, rim]` in both precisions.
#[derive(Clone, Debug)]
pub struct Inputs {
    /// Pairs in f64.
    pub wide: Vec<[f64; 2]>,
    /// The same pairs, rounded to f32.
    pub narrow: Vec<[f32; 2]>,
}

impl Inputs {
    /// Pairs and their roundings.
    pub fn new(wide: Vec<[f64; 2]>) -> Self {
        let narrow = mix::narrowed(&wide);
        Self { wide, narrow }
    }

    /// Every `stride`-th pair.
    pub fn thinned(&self, stride: usize) -> Self {
        Self::new(self.wide.iter().step_by(stride).copied().collect())
    }
}

pub(crate) type Sweep<R> = Box<dyn Fn(&[[R; 2]], &mut [[R; 2]])>;

enum Evaluation {
    Wide(Sweep<f64>),
    Narrow(Sweep<f32>),
}

/// One way to compute force and torque.
pub struct Method {
    /// Name of the method in reports.
    pub name: String,
    /// Kind of the method.
    pub kind: Kind,
    /// Exponent α of the method's law.
    pub alpha: f64,
    /// Whether the power of the velocity scale is omitted.
    pub unscaled: bool,
    /// Largest allowed absolute error of F and T/T(0); α = 0 only.
    pub bound: f64,
    /// Only every `stride`-th pair is timed.
    pub stride: usize,
    evaluation: Evaluation,
}

impl fmt::Debug for Method {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Method")
            .field("name", &self.name)
            .finish_non_exhaustive()
    }
}

/// The loop over a slice, compiled once per method, so that the method itself is inlined.
pub(crate) fn sweep<R: Copy + 'static>(evaluate: impl Fn(R, R) -> [R; 2] + 'static) -> Sweep<R> {
    Box::new(move |pairs, results| {
        for (&[slide, rim], result) in pairs.iter().zip(results) {
            *result = evaluate(slide, rim);
        }
    })
}

/// `[F, T]` of a wrench.
pub(crate) fn as_pair<R>(ReducedWrench { force, torque }: ReducedWrench<R>) -> [R; 2] {
    [force, torque]
}

impl Method {
    /// A method for α = 0 in f64.
    pub fn wide(
        name: impl Into<String>,
        kind: Kind,
        bound: f64,
        evaluate: impl Fn(f64, f64) -> [f64; 2] + 'static,
    ) -> Self {
        Self::new(name, kind, bound, Evaluation::Wide(sweep(evaluate)))
    }

    /// A method for α = 0 in f32.
    pub fn narrow(
        name: impl Into<String>,
        kind: Kind,
        bound: f64,
        evaluate: impl Fn(f32, f32) -> [f32; 2] + 'static,
    ) -> Self {
        Self::new(name, kind, bound, Evaluation::Narrow(sweep(evaluate)))
    }

    fn new(name: impl Into<String>, kind: Kind, bound: f64, evaluation: Evaluation) -> Self {
        let name = name.into();
        Self {
            name,
            kind,
            alpha: 0.0,
            unscaled: false,
            bound,
            stride: 1,
            evaluation,
        }
    }

    /// Times on every `stride`-th pair only.
    pub(crate) fn every(self, stride: usize) -> Self {
        Self { stride, ..self }
    }

    /// Marks another exponent, with or without the power of the scale.
    pub(crate) fn with_exponent(self, alpha: f64, unscaled: bool) -> Self {
        Self {
            alpha,
            unscaled,
            ..self
        }
    }

    /// "f64" or "f32".
    pub fn precision(&self) -> &'static str {
        match self.evaluation {
            Evaluation::Wide(_) => "f64",
            Evaluation::Narrow(_) => "f32",
        }
    }

    /// One pass over `inputs`, hidden from the optimiser on both sides.
    pub fn runner<'a>(&'a self, inputs: &'a Inputs) -> Box<dyn FnMut() + 'a> {
        match &self.evaluation {
            Evaluation::Wide(sweep) => Box::new(pass(sweep, &inputs.wide)),
            Evaluation::Narrow(sweep) => Box::new(pass(sweep, &inputs.narrow)),
        }
    }

    /// Results over `inputs` and exact values for the same, possibly rounded, arguments.
    fn judged(&self, inputs: &Inputs) -> (Vec<[f64; 2]>, Vec<[Wide; 2]>) {
        let (results, arguments) = match &self.evaluation {
            Evaluation::Wide(sweep) => (collected(sweep, &inputs.wide), inputs.wide.clone()),
            Evaluation::Narrow(sweep) => {
                let widen = |&[a, b]: &[f32; 2]| [f64::from(a), f64::from(b)];
                let results = collected(sweep, &inputs.narrow);
                let arguments = inputs.narrow.iter().map(widen).collect();
                (results.iter().map(widen).collect(), arguments)
            }
        };
        let exact = arguments.iter().map(|&[v, w]| self.exact(v, w)).collect();
        (results, exact)
    }

    /// Double-double for α = 0; otherwise the compact tier, accurate to 4 ulp.
    fn exact(&self, slide: f64, rim: f64) -> [Wide; 2] {
        if self.alpha == 0.0 {
            return reference::wrench(slide, rim);
        }
        // The catalogue names valid exponents only.
        let Ok(power) = compact::CompactPower::new(self.alpha) else {
            return [Wide::new(f64::NAN); 2];
        };
        let wrench = if self.unscaled {
            unscaled_wrench(&power, slide, rim)
        } else {
            power.reduced_wrench(slide, rim)
        };
        as_pair(wrench).map(Wide::new)
    }

    /// Largest errors over `inputs`.
    pub fn errors(&self, inputs: &Inputs) -> Errors {
        let (found, exact) = self.judged(inputs);
        Errors::between(&found, &exact)
    }

    /// Panics unless the method meets its accuracy, so that no wrong method is timed.
    ///
    /// For α ≠ 0 the relative error decides, else the absolute one.
    pub fn assert_right(&self, inputs: &Inputs) {
        let errors = self.errors(inputs);
        let error = if self.alpha == 0.0 {
            errors.absolute()
        } else {
            errors.relative()
        };
        assert!(
            error <= self.bound,
            "{} errs by {error:e}, more than {:e}",
            self.name,
            self.bound
        );
    }
}

/// A closure that sweeps once into its own buffer.
fn pass<'a, R: Real>(sweep: &'a Sweep<R>, pairs: &'a [[R; 2]]) -> impl FnMut() + 'a {
    let mut results = vec![[R::ZERO; 2]; pairs.len()];
    move || {
        sweep(black_box(pairs), black_box(&mut results));
        black_box(&mut results);
    }
}

fn collected<R: Real>(sweep: &Sweep<R>, pairs: &[[R; 2]]) -> Vec<[R; 2]> {
    let mut results = vec![[R::ZERO; 2]; pairs.len()];
    sweep(pairs, &mut results);
    results
}
