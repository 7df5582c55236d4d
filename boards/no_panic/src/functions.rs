//! The image's source: every public function of the kernel for every instance of its parameters.
//!
//! The compiler's list gives the functions, `tribos-api` the instances. Each function is
//! written once, generic, and called once for each choice of its parameters.

use std::fmt::Write;
use tribos_api::{
    CONSTANTS, EVERY, Function, INSTANCES, Instance, Library, Parameter, THOROUGH, UNBOUNDED,
};

/// Precisions with their place in [`CONSTANTS`].
const PRECISIONS: [(usize, &str); 2] = [(0, "f32"), (1, "f64")];

/// Source of the image, and the names of its functions.
#[derive(Debug)]
pub struct Image {
    /// Rust source text.
    pub source: String,
    /// One name per function, precision and choice of parameters; each is a constant of the image.
    pub names: Vec<String>,
    /// Number of functions.
    pub functions: usize,
}

/// The image of all public functions.
///
/// # Errors
/// The functions for which the list of instances has no choice.
pub fn image() -> Result<Image, String> {
    of(&Library::read("tribos-core", &[])?.functions()?)
}

fn of(functions: &[Function]) -> Result<Image, String> {
    let mut image = Image {
        source: "use tribos_core::*;\n".into(),
        names: Vec::new(),
        functions: 0,
    };
    let (mut calls, mut without) = ([String::new(), String::new()], String::new());
    let plain = plain(functions);
    // The board has no vectors: their arithmetic is one instruction each, and calls nothing that is here.
    let is_here = |function: &&Function| !function.derived && !function.path.contains("<wide::");
    for function in functions.iter().filter(is_here) {
        image.functions += 1;
        let number = image.functions;
        let _ = image.source.write_str(&definition(function, number));
        let given: Vec<&Parameter> = function
            .parameters
            .iter()
            .filter(|p| !is_closure(p))
            .collect();
        let thorough = THOROUGH
            .iter()
            .any(|start| function.path.starts_with(start));
        // A function without parameters is a single function for all precisions.
        let precisions = if given.is_empty() {
            &PRECISIONS[1..]
        } else {
            &PRECISIONS
        };
        for &(place, precision) in precisions {
            let choices = choices(&given, place, thorough, &plain);
            if choices.is_empty() {
                let _ = writeln!(without, "{} in {precision}", function.path);
            }
            for choice in choices {
                let arguments = choice.join(", ");
                let name = format!("{} [{precision}: {arguments}]", function.path);
                let _ = writeln!(
                    calls[place],
                    "        f{number}::<{arguments}>(keeper, {name:?});"
                );
                image.names.push(name);
            }
        }
    }
    if !without.is_empty() {
        return Err(format!(
            "no instance in tests/api/src/instances.rs suits these:\n{without}"
        ));
    }
    image.source += "pub fn everything(keeper: &mut crate::image::Opaque) {\n";
    for (place, precision) in PRECISIONS {
        let _ = write!(
            image.source,
            "    {{\n        type R = {precision};\n{}    }}\n",
            calls[place]
        );
    }
    image.source += "}\n";
    Ok(image)
}

/// A generic function that returns the address of `function`.
fn definition(function: &Function, number: usize) -> String {
    let declared = function
        .parameters
        .iter()
        .filter(|p| !is_closure(p))
        .map(|parameter| {
            let Parameter {
                name,
                constant,
                bounds,
                ..
            } = parameter;
            match constant {
                Some(of) => format!("const {name}: {of}"),
                // Instances borrow nothing that is not static.
                None => {
                    let bounds: Vec<&str> = bounds.iter().map(String::as_str).collect();
                    format!(
                        "{name}: {}",
                        [&bounds[..], &["'static"]].concat().join(" + ")
                    )
                }
            }
        });
    let declared: Vec<String> = declared.collect();
    let conditions = match function.conditions[..] {
        [] => String::new(),
        _ => format!(" where {}", function.conditions.join(", ")),
    };
    let own = match function.own[..] {
        [] => String::new(),
        _ => format!("::<{}>", function.own.join(", ")),
    };
    // Parameters written as `impl Trait` follow from the type of the function.
    let pointer = match function
        .parameters
        .iter()
        .any(|parameter| parameter.is_synthetic)
    {
        true => {
            let mut inputs = function.inputs.join(", ");
            for closure in function.parameters.iter().filter(|p| is_closure(p)) {
                inputs = inputs.replace(
                    &closure.name,
                    &closure.bounds[0]
                        .replace("core::ops::FnOnce", "fn")
                        .replace("core::ops::Fn", "fn"),
                );
            }
            format!(" as fn({inputs}) -> _")
        }
        false => String::new(),
    };
    // References are static, like the functions of the image.
    let path = function.path.replace("'a", "'static");
    format!(
        "fn f{number}<{}>(keeper: &mut crate::image::Opaque, name: &'static str){conditions} {{\n    \
         keeper.keep(name, {}{own}{pointer} as *const ());\n}}\n",
        declared.join(", "),
        path
    )
}

/// Whether the parameter is a closure; the image uses a function in its place.
fn is_closure(parameter: &Parameter) -> bool {
    parameter
        .bounds
        .iter()
        .any(|bound| bound.starts_with("core::ops::Fn"))
}

/// A type with the scalar as its only parameter, and a trait of [`EVERY`] that it implements.
type Plain<'a> = (&'a str, &'static str);

/// Those that the list of instances leaves out: they stand for their traits as they are.
fn plain(functions: &[Function]) -> Vec<Plain<'_>> {
    let mut found = Vec::new();
    for function in functions {
        let Some((this, rest)) = function
            .path
            .strip_prefix('<')
            .and_then(|path| path.split_once(" as "))
        else {
            continue;
        };
        let implemented = EVERY.into_iter().find(|name| last(rest) == *name);
        let has_others = function
            .parameters
            .iter()
            .any(|parameter| parameter.name != "R");
        let is_listed = INSTANCES.iter().any(|instance| instance.of == this);
        if let (Some(name), false, false) = (implemented, has_others, is_listed)
            && !found.contains(&(this, name))
        {
            found.push((this, name));
        }
    }
    found
}

/// Every choice of arguments.
fn choices<'a>(
    parameters: &[&Parameter],
    precision: usize,
    thorough: bool,
    plain: &[Plain<'a>],
) -> Vec<Vec<&'a str>> {
    let mut choices = vec![Vec::new()];
    for parameter in parameters {
        let is_given = |other: &&&Parameter| {
            let given = format!("= {}>", parameter.name);
            other.bounds.iter().any(|bound| bound.ends_with(&given))
        };
        let candidates = match parameters.iter().any(|other| is_given(&other)) {
            // The compiler infers it.
            true => vec!["_"],
            false => candidates(parameter, precision, thorough, plain),
        };
        let longer = |choice: &Vec<&'a str>| {
            let choice = choice.clone();
            let with = |&candidate| [&choice[..], &[candidate]].concat();
            candidates.iter().map(with).collect::<Vec<_>>()
        };
        choices = choices.iter().flat_map(longer).collect();
    }
    choices
}

/// Candidates for a parameter.
fn candidates<'a>(
    parameter: &Parameter,
    precision: usize,
    thorough: bool,
    plain: &[Plain<'a>],
) -> Vec<&'a str> {
    if parameter.constant.is_some() {
        let named = CONSTANTS.iter().find(|(name, _)| *name == parameter.name);
        return named.map_or(Vec::new(), |(_, values)| values[precision].to_vec());
    }
    let bounds = parameter
        .bounds
        .iter()
        .filter(|bound| !bound.contains("core::marker::"));
    let mut traits: Vec<&str> = bounds.map(|bound| last(bound)).collect();
    if traits.is_empty() {
        let unbounded = UNBOUNDED.iter().find(|(name, _)| *name == parameter.name);
        traits.extend(unbounded.map(|(_, wanted)| wanted));
    }
    let suits = |instance: &&Instance| {
        let here = instance
            .precision
            .is_none_or(|only| only == PRECISIONS[precision].1)
            && (thorough || instance.representative);
        here && !traits.is_empty() && traits.iter().all(|wanted| instance.traits.contains(wanted))
    };
    let listed = INSTANCES.iter().filter(suits).map(|instance| instance.of);
    let plain = plain
        .iter()
        .filter(|(_, name)| !traits.is_empty() && traits.iter().all(|wanted| wanted == name));
    listed.chain(plain.map(|(of, _)| *of)).collect()
}

/// The name of a trait without path; conversions, of which there are many, with their arguments.
fn last(bound: &str) -> &str {
    let path = bound.split(['<', '(']).next().unwrap_or_default();
    let name = path.rsplit("::").next().unwrap_or_default();
    match name {
        "AsRef" | "AsMut" => &bound[path.len() - name.len()..],
        _ => name,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn function(path: &str, name: &str, bound: &str) -> Function {
        Function {
            path: path.into(),
            symbol: None,
            parameters: vec![Parameter {
                name: name.into(),
                bounds: vec![bound.into()],
                ..Parameter::default()
            }],
            conditions: Vec::new(),
            own: vec![name.into()],
            inputs: Vec::new(),
            always_inlined: false,
            derived: false,
        }
    }

    #[test]
    fn a_law_stands_for_laws_without_a_line_in_the_list() {
        let law = function(
            "<law::Grease<R> as law::LocalLaw<R>>::slope",
            "R",
            "real::Real",
        );
        let on_disk = function("<Disk<L>>::wrench", "L", "law::LocalLaw<f64>");
        let source = of(&[law, on_disk]).unwrap().source;
        assert!(source.contains("f2::<law::Grease<R>>"), "{source}");
    }

    #[test]
    fn a_function_without_instance_is_named() {
        let bound = |bound: &str| function("law::lonely", "L", bound);
        assert!(of(&[bound("law::LocalLaw<f64>")]).is_ok());
        let error = of(&[bound("law::Unlisted")]).unwrap_err();
        assert!(error.contains("law::lonely in f32"), "{error}");
    }
}
