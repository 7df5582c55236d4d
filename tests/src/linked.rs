//! The functions contained in a program, identified by the symbols of [`tribos_api`].

use std::collections::{BTreeMap, BTreeSet};
use tribos_api::Function;

/// The functions of `crate_name` contained in a program, each with the precisions in its generics.
///
/// The program must be built with `-Csymbol-mangling-version=v0`, without optimisation, so that
/// nothing is inlined, and without debug information, which also names what the linker dropped.
pub fn linked_functions(
    program: &[u8],
    crate_name: &str,
) -> BTreeMap<String, BTreeSet<&'static str>> {
    let mut out: BTreeMap<_, BTreeSet<_>> = BTreeMap::new();
    for symbol in program.split(|&byte| byte == 0) {
        let name = std::str::from_utf8(symbol)
            .ok()
            .filter(|name| name.starts_with("_R"));
        let Some(name) = name.and_then(|name| rustc_demangle::try_demangle(name).ok()) else {
            continue;
        };
        let name = format!("{name:#}");
        if let Some(key) = key_of_symbol(&name, crate_name) {
            let precisions = ["f32", "f64"]
                .into_iter()
                .filter(|real| name.contains(real));
            out.entry(key).or_default().extend(precisions);
        }
    }
    out
}

/// Functions of the kernel that are missing from a program, or not present in every precision.
///
/// Derived functions, functions that are always inlined and leave no symbol, and functions of types of
/// other crates are ignored.
pub fn not_linked(
    functions: &[Function],
    linked: &BTreeMap<String, BTreeSet<&'static str>>,
) -> Vec<String> {
    let none = BTreeSet::new();
    let mut out = Vec::new();
    for function in functions.iter().filter(|f| !f.derived && !f.always_inlined) {
        let Some(symbol) = &function.symbol else {
            continue;
        };
        let held = linked.get(symbol).unwrap_or(&none);
        if function
            .parameters
            .iter()
            .any(|parameter| parameter.name == "R")
        {
            let lacks = ["f32", "f64"]
                .into_iter()
                .filter(|real| !held.contains(real));
            out.extend(lacks.map(|real| format!("{symbol} in {real}")));
        } else if !linked.contains_key(symbol) {
            out.push(symbol.clone());
        }
    }
    out
}

/// The symbol in a demangled name: `<a::T<f64> as b::Trait<f64>>::f`, `<a::T<f64>>::f` or `a::f::<f64>`.
fn key_of_symbol(name: &str, crate_name: &str) -> Option<String> {
    if name.contains('{') && !name.contains("{closure#0}>") {
        return None;
    }
    let inside = |path: &str| {
        Some(
            path.strip_prefix(crate_name)?
                .strip_prefix("::")?
                .to_owned(),
        )
    };
    let Some(rest) = name.strip_prefix('<') else {
        return inside(&bare(name));
    };
    let end = closing(rest)?;
    let (head, method) = (&rest[..end], bare(rest[end + 1..].strip_prefix("::")?));
    match split_at_as(head) {
        None => Some(format!("{}::{method}", inside(&bare(head))?)),
        Some((owner, of_trait)) => {
            let of_trait = inside(&bare(of_trait)).or_else(|| known_trait(of_trait))?;
            let of_trait = of_trait.rsplit("::").next()?.to_owned();
            let owner = inside(&bare(owner)).unwrap_or_else(|| bare(owner));
            Some(format!("{owner} as {of_trait}::{method}"))
        }
    }
}

/// Traits of the core library that the kernel implements.
fn known_trait(path: &str) -> Option<String> {
    ["From", "Default"]
        .into_iter()
        .find(|name| bare(path).ends_with(&format!("::{name}")))
        .map(String::from)
}

/// A path without its generic arguments.
fn bare(path: &str) -> String {
    path.split('<')
        .next()
        .unwrap_or_default()
        .trim_end_matches("::")
        .to_owned()
}

/// Position of the bracket that closes the one open before the text.
fn closing(text: &str) -> Option<usize> {
    let mut depth = 1;
    let mut last = ' ';
    for (at, c) in text.char_indices() {
        match c {
            '<' => depth += 1,
            // The `>` of a function type's arrow is not a bracket.
            '>' if last != '-' => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            return Some(at);
        }
        last = c;
    }
    None
}

/// The two sides of the outermost " as ".
fn split_at_as(text: &str) -> Option<(&str, &str)> {
    let mut depth = 0;
    for (at, c) in text.char_indices() {
        match c {
            '<' => depth += 1,
            '>' => depth -= 1,
            ' ' if depth == 0 && text[at..].starts_with(" as ") => {
                return Some((&text[..at], &text[at + 4..]));
            }
            _ => {}
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_come_out_of_symbols() {
        for (symbol, key) in [
            ("<k::a::T<f64>>::f", Some("a::T::f")),
            (
                "<k::a::T<f64, k::b::U<f32>> as k::c::Tr<f64>>::f::<3>",
                Some("a::T as Tr::f"),
            ),
            ("k::a::f::<f32>", Some("a::f")),
            ("<f64 as k::real::Real>::sqrt", Some("f64 as Real::sqrt")),
            (
                "<k::T<f64> as core::convert::From<k::U>>::from",
                Some("T as From::from"),
            ),
            ("<k::T as core::fmt::Debug>::fmt", None),
            ("other::k::f", None),
            ("k::a::f::<f32>::{closure#1}", None),
        ] {
            assert_eq!(key_of_symbol(symbol, "k").as_deref(), key, "{symbol}");
        }
    }
}
