//! The functions that a program contains, by the keys of [`public_items`](crate::public_items).

use crate::public_items::Precision;
use std::collections::{BTreeMap, BTreeSet};

/// The functions of `crate_name` that a program holds, each with the precisions in its generics.
///
/// The program is to be built with `-Csymbol-mangling-version=v0`, without optimisation, so that
/// nothing is inlined, and without debug information, which names what the linker dropped.
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

/// The listed functions that a program does not hold, or not in every precision.
pub fn not_linked(
    listed: &BTreeMap<String, Precision>,
    linked: &BTreeMap<String, BTreeSet<&'static str>>,
) -> Vec<String> {
    // Methods by default and from macros count for their trait.
    let mut held: BTreeMap<&str, BTreeSet<&str>> = BTreeMap::new();
    for (key, precisions) in linked {
        let of_trait = key.split_once(" as ").map(|(_, method)| method);
        let key = of_trait
            .filter(|_| !listed.contains_key(key))
            .unwrap_or(key);
        held.entry(key).or_default().extend(precisions);
    }
    let mut out = Vec::new();
    for (key, precision) in listed {
        match (held.get(key.as_str()), precision) {
            (_, Precision::Inlined) | (Some(_), Precision::Fixed) => {}
            (None, _) => out.push(key.clone()),
            (Some(held), Precision::Both) => {
                let lacks = ["f32", "f64"]
                    .into_iter()
                    .filter(|real| !held.contains(real));
                out.extend(lacks.map(|real| format!("{key} in {real}")));
            }
        }
    }
    out
}

/// The key in a demangled name: `<a::T<f64> as b::Trait<f64>>::f`, `<a::T<f64>>::f` or `a::f::<f64>`.
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

/// Where the bracket closes that was open before the text.
fn closing(text: &str) -> Option<usize> {
    let mut depth = 1;
    let mut last = ' ';
    for (at, c) in text.char_indices() {
        match c {
            '<' => depth += 1,
            // Not the arrow of a function's type.
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
