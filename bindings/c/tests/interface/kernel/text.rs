//! Writes the header from its template, the files of `template`, and Python's terms.
//!
//! The template is C with words in capitals for what differs between the types, `_fx` for the end of their names, numbers
//! like `0.5r` in their precision, and marks:
//!
//! | mark | stands for |
//! |---|---|
//! | `@@each`, `@@once` | what follows is written for each type, once |
//! | `@@if f64`, `@@end` | lines of one type |
//! | `@@(1.01)`, `@@(1/3)`, `@@(1-0.1)` | a number of f64, rounded to the type |
//! | `@@sums PRESSURE FUNCTION` | sums of fitted terms in the order of the kernel |
//! | `@@by_pressure WHAT` | cases with numbers of a prepared curve |
//! | `@@atanh`, `@@ln2`, `@@bend_…` | terms of the logarithm, ln 2, terms of an edge |
//! | `@@to_bits`, `@@of_bits` | a number as its bits and back |

use super::numbers::{PRESSURES, Type, curve, fitted, rough};
use std::fmt::Write as _;

/// Its parts in the order of the header.
const TEMPLATE: &str = concat!(
    include_str!("template/preface.h.in"),
    include_str!("template/numbers.h.in"),
    include_str!("template/round.h.in"),
    include_str!("template/wrench.h.in"),
    include_str!("template/surface.h.in"),
    include_str!("template/project.h.in"),
    include_str!("template/polygon.h.in"),
    include_str!("template/edges.h.in"),
    include_str!("template/polygon_surface.h.in"),
    include_str!("template/step.h.in"),
    include_str!("template/end.h.in"),
);
/// Longest line of what is written here.
const WIDTH: usize = 120;

/// The header.
pub fn header() -> String {
    let (first, rest) = TEMPLATE
        .split_once("@@each\n")
        .expect("a part for each type");
    let (each, last) = rest.split_once("@@once\n").expect("an end");
    let first = first.strip_prefix("@@once\n").expect("a beginning");
    format!("{first}{}{}{last}", typed::<f32>(each), typed::<f64>(each))
}

/// The part of a type.
fn typed<R: Type>(template: &str) -> String {
    let mut text = String::new();
    let mut is_kept = true;
    for line in template.lines() {
        if let Some(suffix) = line.strip_prefix("@@if ") {
            is_kept = suffix == R::SUFFIX;
        } else if line == "@@end" {
            is_kept = true;
        } else if is_kept {
            match line.strip_prefix("@@") {
                Some(mark) => text += &block::<R>(mark),
                None => text += &in_line::<R>(line),
            }
            text.push('\n');
        }
    }
    words::<R>(&text)
}

/// What a line that is a mark stands for.
fn block<R: Type>(mark: &str) -> String {
    let parts: Vec<_> = mark.split(' ').collect();
    match parts[..] {
        ["sums", pressure, function] => sums::<R>(pressure, function),
        ["by_pressure", what] => PRESSURES.map(|name| case::<R>(name, what)).join("\n"),
        ["of_bits"] => bits("REAL x", "AS_REAL(given)", "&x, &given, sizeof x"),
        ["to_bits"] => bits("BITS found", "AS_BITS(x)", "&found, &x, sizeof x")
            .replace("return x", "return found"),
        _ => panic!("no mark {mark}"),
    }
}

fn bits(found: &str, on_device: &str, copied: &str) -> String {
    format!(
        "#if defined(__CUDA_ARCH__) || defined(__HIP_DEVICE_COMPILE__) || defined(__CUDACC_RTC__)\n\
         \treturn {on_device};\n#else\n\t{found};\n\tmemcpy({copied});\n\treturn x;\n#endif"
    )
}

/// A line with the marks within it replaced.
fn in_line<R: Type>(line: &str) -> String {
    let mut text = line.to_owned();
    while let Some(start) = text.find("@@") {
        let mark = &text[start + 2..];
        let (length, number) = if let Some(inner) = mark.strip_prefix('(') {
            let (inner, _) = inner.split_once(')').expect("a closed mark");
            (inner.len() + 2, R::from_f64(quotient(inner)).literal())
        } else {
            let length = mark.find(|c: char| c != '_' && !c.is_ascii_alphanumeric());
            let length = length.expect("a mark's end");
            (length, named::<R>(&mark[..length]))
        };
        text.replace_range(start..start + 2 + length, &number);
    }
    text
}

/// `1.01`, `1/3` or `1-0.1`.
fn quotient(text: &str) -> f64 {
    let number = |text: &str| text.parse::<f64>().expect("a number");
    match (text.split_once('/'), text.split_once('-')) {
        (Some((over, under)), _) => number(over) / number(under),
        (_, Some((from, less))) => number(from) - number(less),
        _ => number(text),
    }
}

fn named<R: Type>(mark: &str) -> String {
    let of = |column: usize| {
        let terms: Vec<_> = R::bend().iter().map(|row| row[column].literal()).collect();
        even_and_odd(&terms, ["gap", "gap_sq"], 2)
    };
    match mark {
        "ln2" => R::from_f64(std::f64::consts::LN_2).literal(),
        "bend_smooth" => of(0),
        "bend_of_log" => of(1),
        "atanh" => {
            let terms: Vec<_> = R::atanh().iter().map(|term| term.literal()).collect();
            match &terms[..] {
                [a, b, c] => format!("({a} + {b} * f2) + {c} * f4"),
                [a, b, c, d, e, g, h] => format!(
                    "(({a} + {b} * f2) + f4 * ({c} + {d} * f2))\n\t\t+ f4 * f4 * (({e} + {g} * f2) + f4 * {h})"
                ),
                _ => panic!("{} terms", terms.len()),
            }
        }
        _ => panic!("no mark {mark}"),
    }
}

/// Assigns the four sums of a pressure's terms.
fn sums<R: Type>(pressure: &str, function: &str) -> String {
    let rows = match function {
        "torque" => fitted(pressure)[0],
        "slope" => fitted(pressure)[1],
        _ => rough(),
    };
    let [spinning, sliding] = R::rows(&rows);
    let mut text = String::new();
    for (column, name) in ["p", "r", "q", "s"].into_iter().enumerate() {
        let terms: Vec<_> = spinning
            .iter()
            .zip(sliding)
            .map(|(spinning, sliding)| chosen([spinning[column], sliding[column]]))
            .collect();
        let sum = even_and_odd(&terms, ["u", "u2"], 2);
        writeln!(text, "\t\tsums.{name} = {sum};").expect("text");
    }
    text.trim_end().to_owned()
}

/// A number, or one of two.
fn chosen<R: Type>([spinning, sliding]: [R; 2]) -> String {
    if spinning == sliding {
        return spinning.literal();
    }
    format!("(slides ? {} : {})", sliding.literal(), spinning.literal())
}

/// Σ termₙ uⁿ as `tribos_core`'s `even_and_odd` has it: t₀ + (odd u + even u²), both by powers of u².
fn even_and_odd(terms: &[String], [u, square]: [&str; 2], indent: usize) -> String {
    let nested = |first: usize| {
        let mut powers = terms.iter().skip(first).step_by(2).rev();
        let mut sum = powers.next().expect("two terms and more").clone();
        for term in powers {
            sum = format!("({sum} * {square} + {term})");
        }
        sum
    };
    let sum = format!(
        "{} + ({} * {u} + {} * {square})",
        terms[0],
        nested(1),
        nested(2)
    );
    wrapped(&sum.replace("+ -", "- "), indent)
}

/// Breaks a long expression before its signs.
fn wrapped(text: &str, indent: usize) -> String {
    let (mut lines, mut line) = (String::new(), String::new());
    for word in text.split(' ') {
        let is_sign = word == "+" || word == "-";
        if is_sign && line.len() + 8 * (indent + 1) + 40 > WIDTH {
            lines += line.trim_end();
            lines += &format!("\n{}", "\t".repeat(indent + 1));
            line.clear();
        }
        line += word;
        line.push(' ');
    }
    lines + line.trim_end()
}

/// The case of a pressure.
fn case<R: Type>(pressure: &str, what: &str) -> String {
    let numbers = curve::<R>(pressure);
    let [force, torque] = numbers.equal;
    let mut text = if pressure == PRESSURES[PRESSURES.len() - 1] {
        "\tdefault:".to_owned()
    } else {
        format!("\tcase TRIBOS_KERNEL_{}:", pressure.to_uppercase())
    };
    let mut assign = |name: &str, value: String| {
        write!(text, "\n\t\t{what}.{name} = {value};").expect("text");
    };
    match what {
        "spin_torque" => {
            return format!("{text}\n\t\treturn {};", numbers.spin_torque.literal());
        }
        "chords" => {
            let [[a, b], [c, d]] = numbers.chords;
            for (name, number) in [
                ("force", force),
                ("torque", torque),
                ("a", a),
                ("b", b),
                ("c", c),
                ("d", d),
            ] {
                assign(name, number.literal());
            }
        }
        _ => {
            let side = |[sliding, spinning]: [R; 2]| chosen([spinning, sliding]);
            let [sliding, spinning] = numbers.powers;
            assign("top", side(numbers.tops));
            for (name, powers) in ["a", "b", "c", "d", "e", "f"]
                .into_iter()
                .zip(sliding.into_iter().zip(spinning))
            {
                assign(name, side([powers.0, powers.1]));
            }
            assign("major", side([force, torque]));
            assign("minor", side([torque, force]));
        }
    }
    text + "\n\t\tbreak;"
}

/// Words, names and numbers of the type.
fn words<R: Type>(text: &str) -> String {
    let mut found = String::new();
    let mut word = String::new();
    for c in text.chars().chain(['\0']) {
        if c.is_ascii_alphanumeric() || c == '_' || c == '.' {
            word.push(c);
            continue;
        }
        found += &in_type::<R>(&word);
        word.clear();
        if c != '\0' {
            found.push(c);
        }
    }
    found
}

fn in_type<R: Type>(word: &str) -> String {
    if let Some([_, meaning]) = R::WORDS.iter().find(|[name, _]| *name == word) {
        return (*meaning).to_owned();
    }
    if let Some(number) = word
        .strip_suffix('r')
        .and_then(|number| number.parse().ok())
    {
        return R::from_f64(number).literal();
    }
    word.replace("_fx", &format!("_{}", R::SUFFIX))
}

/// The module of Python.
pub fn python() -> String {
    let mut text = include_str!("terms.py.in").to_owned();
    text += "\nROUND = {\n";
    for pressure in PRESSURES {
        text += &format!("    \"{pressure}\": {{\n");
        text += &python_rows::<f32>("float32", pressure);
        text += &python_rows::<f64>("float64", pressure);
        text += "    },\n";
    }
    text += "}\n\nBEND = {\n";
    text += &format!("    \"float32\": ({}),\n", python_tuples(f32::bend()));
    text += &format!("    \"float64\": ({}),\n", python_tuples(f64::bend()));
    text + "}\n"
}

fn python_rows<R: Type>(name: &str, pressure: &str) -> String {
    let mut text = format!("        \"{name}\": {{\n");
    for (function, rows) in ["torque", "slope"].into_iter().zip(fitted(pressure)) {
        text += &format!("            \"{function}\": (\n");
        for side in R::rows(&rows) {
            text += &format!("                ({}),\n", python_tuples(side));
        }
        text += "            ),\n";
    }
    text + "        },\n"
}

/// Rows of numbers as Python writes them.
fn python_tuples<R: Type, const N: usize>(rows: &[[R; N]]) -> String {
    let number = |number: &R| {
        let text = number.shortest();
        match text.split_once("e-") {
            Some((digits, power)) => format!("{digits}e-{power:0>2}"),
            None => text,
        }
    };
    let tuple = |row: &[R; N]| {
        format!(
            "({}),",
            row.iter().map(number).collect::<Vec<_>>().join(", ")
        )
    };
    rows.iter().map(tuple).collect::<Vec<_>>().join(" ")
}
