//! Methods on the command line.

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use tribos::problem::ProblemMethod;

/// Reads the name of a method.
pub fn parser() -> impl TypedValueParser<Value = ProblemMethod> {
    let named = |method: ProblemMethod| PossibleValue::new(method.name()).help(help(method));
    PossibleValuesParser::new(ProblemMethod::ALL.map(named)).try_map(|name| {
        let mut all = ProblemMethod::ALL.into_iter();
        all.find(|method| method.name() == name)
            .ok_or("no such method")
    })
}

fn help(method: ProblemMethod) -> &'static str {
    match method {
        ProblemMethod::Automatic => "Sweeps, and others where they are foreseen to be faster",
        ProblemMethod::Sweeps => "Gauss-Seidel sweeps with momentum",
        ProblemMethod::Gradient => "Projected gradients with momentum",
        ProblemMethod::Interior => "Interior point method, Newton's method at its end",
        ProblemMethod::Proximal => "Proximal points with Newton's method",
    }
}
