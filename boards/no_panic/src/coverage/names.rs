//! The compiler's names of functions, without their type arguments.

/// A function as named in the source.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Name {
    /// `module::function`, `module::Type::method` or `<module::Type as module::Trait>::method`,
    /// without the name of the kernel.
    pub path: String,
    /// Scalars among its type arguments.
    pub precisions: Vec<&'static str>,
}

impl Name {
    /// From `core::any::type_name`.
    pub fn of(name: &str) -> Self {
        let words: Vec<&str> = name
            .split(|c: char| !c.is_alphanumeric() && c != '_')
            .collect();
        let precisions = ["f32", "f64"];
        Self {
            // The arrow of a function type is not a bracket.
            path: path(&name.replace("->", "")),
            precisions: precisions
                .into_iter()
                .filter(|p| words.contains(p))
                .collect(),
        }
    }
}

fn path(name: &str) -> String {
    // <Type as Trait<…>>::method
    if let Some(rest) = name.strip_prefix('<') {
        let end = closing(rest);
        let (inside, method) = (&rest[..end], &rest[end + 1..]);
        let (implementor, implemented) = cut(inside);
        return format!(
            "<{} as {}>{}",
            plain(implementor),
            plain(implemented),
            plain(method)
        );
    }
    // module::<impl Type>::method
    if let Some(start) = name.find("<impl ") {
        let rest = &name[start + "<impl ".len()..];
        let end = closing(rest);
        return plain(&rest[..end]) + &plain(&rest[end + 1..]);
    }
    plain(name)
}

/// Splits at the " as " that is outside all brackets.
fn cut(inside: &str) -> (&str, &str) {
    let mut depth = 0;
    for (at, character) in inside.char_indices() {
        match character {
            '<' => depth += 1,
            '>' => depth -= 1,
            ' ' if depth == 0 && inside[at..].starts_with(" as ") => {
                return (&inside[..at], &inside[at + 4..]);
            }
            _ => {}
        }
    }
    (inside, "")
}

/// Position where the bracket open at the start closes.
fn closing(text: &str) -> usize {
    let mut depth = 1;
    for (at, character) in text.char_indices() {
        match character {
            '<' => depth += 1,
            '>' => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            return at;
        }
    }
    text.len() - 1
}

/// Without type arguments and the kernel's own name; a reference is `&` alone.
fn plain(text: &str) -> String {
    if text.starts_with('&') {
        return "&".into();
    }
    let mut depth = 0;
    let outside = |character: &char| {
        depth += i32::from(*character == '<');
        let outside = depth == 0;
        depth -= i32::from(*character == '>');
        outside
    };
    let text: String = text.chars().filter(outside).collect();
    text.replace("tribos_core::", "")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn type_arguments_are_dropped_and_scalars_kept() {
        let cases = [
            (
                "tribos_core::law::drag::reynolds<f32>",
                "law::drag::reynolds",
            ),
            (
                "tribos_core::slider::advance::<impl tribos_core::slider::Slider<f32, a::B<u8>>>::advance",
                "slider::Slider::advance",
            ),
            (
                "<tribos_core::coupling::dry::Dry<tribos_core::x::Y<f32>> as tribos_core::coupling::Coupling<f32>>::reduced_wrench",
                "<coupling::dry::Dry as coupling::Coupling>::reduced_wrench",
            ),
            (
                "<&tribos_core::x::Y<f32> as tribos_core::coupling::Coupling<f32>>::reduced_wrench",
                "<& as coupling::Coupling>::reduced_wrench",
            ),
            (
                "<f32 as tribos_core::real::Real>::sqrt",
                "<f32 as real::Real>::sqrt",
            ),
            (
                "tribos_core::patch::polar::PolarRule<f32>::nodes_shaped<12, fn(f32, f32) -> f32>",
                "patch::polar::PolarRule::nodes_shaped",
            ),
        ];
        for (name, path) in cases {
            let name = Name::of(name);
            assert_eq!((name.path.as_str(), name.precisions), (path, vec!["f32"]));
        }
    }
}
