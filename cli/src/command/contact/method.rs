//! Methods on the command line.

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use tribos::problem::Method;

/// Reads the name of a method.
pub fn parser() -> impl TypedValueParser<Value = Method> {
    let named = |method: Method| PossibleValue::new(method.name()).help(help(method));
    PossibleValuesParser::new(Method::ALL.map(named)).try_map(|name| {
        let mut all = Method::ALL.into_iter();
        all.find(|method| method.name() == name)
            .ok_or("no such method")
    })
}

fn help(method: Method) -> &'static str {
    match method {
        Method::Automatic => "Sweeps, and others where they are foreseen to be faster",
        Method::Sweeps => "Gauss-Seidel sweeps with momentum",
        Method::Gradient => "Projected gradients with momentum",
        Method::Interior => "Interior point method, Newton's method at its end",
        Method::Proximal => "Proximal points with Newton's method",
    }
}
