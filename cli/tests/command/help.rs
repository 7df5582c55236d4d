//! Help, completions and manual: every command has them, with examples.

use crate::program::{Outcome, assert_has, told};
use clap::Command as Clap;
use serde_json::Value;
use std::path::Path;
use tribos_cli::command::program;

/// Every command with its path, subcommands of subcommands too.
fn all(command: &Clap, path: &[String], found: &mut Vec<(Vec<String>, Clap)>) {
    for sub in command.get_subcommands() {
        let mut path = path.to_vec();
        path.push(sub.get_name().to_owned());
        found.push((path.clone(), sub.clone()));
        all(sub, &path, found);
    }
}

pub fn commands() -> Vec<(Vec<String>, Clap)> {
    let mut found = Vec::new();
    all(&program(), &[], &mut found);
    found
}

#[test]
fn the_first_page_names_every_command_once() -> Outcome {
    let page = told("--help")?;
    for command in program().get_subcommands() {
        let name = command.get_name();
        let line = |line: &&str| line.starts_with(&format!("  {name} "));
        assert_eq!(page.lines().filter(line).count(), 1, "{name}: {page}");
    }
    Ok(())
}

#[test]
fn every_help_has_examples_and_more_than_its_line_on_the_first_page() {
    let commands = commands();
    assert!(commands.len() >= 16);
    for (path, command) in commands {
        let help = command.clone().render_long_help().to_string();
        assert!(help.contains("Examples:\n"), "{path:?}\n{help}");
        assert!(
            help.contains(&format!("tribos {}", path.join(" "))),
            "{path:?}\n{help}"
        );
        let about = command.get_about().map(ToString::to_string);
        assert!(about.is_some_and(|about| !about.is_empty()), "{path:?}");
    }
}

#[test]
fn help_is_short_and_points_to_the_rest() -> Outcome {
    /// Most lines of a summary, and of all options with their examples.
    const SHORT: usize = 50;
    const LONG: usize = 120;
    let (mut program, mut built) = (program(), Vec::new());
    program.build();
    all(&program, &[], &mut built);
    for (path, mut command) in built {
        let [short, long] = [command.render_help(), command.render_long_help()];
        for (page, most) in [(short, SHORT), (long, LONG)] {
            let lines = page.to_string().lines().count();
            assert!(lines <= most, "{path:?}: {lines} lines");
        }
    }
    let page = told("run --help")?;
    for body in tribos::scene::bodies() {
        assert!(
            page.contains(&format!("tribos scene keys {body}")),
            "{page}"
        );
    }
    Ok(())
}

#[test]
fn keys_are_told_body_by_body() -> Outcome {
    let all = told("scene keys")?;
    for body in tribos::scene::bodies() {
        assert!(all.contains(&format!("  {body} ")), "{all}");
        let keys = tribos::scene::vocabulary(body).ok_or("a body")?.keys;
        let text = told(["scene", "keys", body])?;
        assert_eq!(text.lines().count(), 1 + keys.len(), "{text}");
        for key in keys {
            let told = |line: &str| line.trim_start().starts_with(&format!("{} ", key.name));
            assert!(text.lines().any(told), "{body}: {}", key.name);
        }
    }
    // A scene stands for its body.
    let [scene, body] = ["compaction-small", "powder"].map(|word| told(["scene", "keys", word]));
    assert_eq!(scene?, body?);
    Ok(())
}

/// Least number of letters of a meaning.
const MEANING: usize = 8;

#[test]
fn every_key_has_its_meaning_wherever_keys_are_told() -> Outcome {
    let folder = tempfile::tempdir()?;
    let schema: Value = serde_json::from_str(&told("scene schema")?)?;
    for body in tribos::scene::bodies() {
        let listed = told(["scene", "keys", body])?;
        let file = folder.path().join(format!("{body}.toml"));
        let place = file.to_str().ok_or("a name")?;
        told(["scene", "new", body, "--out", place])?;
        for key in tribos::scene::vocabulary(body).ok_or("a body")?.keys {
            let name = key.name;
            assert!(key.meaning.len() >= MEANING, "{body}: {name}");
            assert!(!key.unit.is_empty(), "{body}: {name}");
            let line = |text: &str| {
                let is_its = |line: &&str| {
                    let line = line.trim_start_matches(['#', ' ']);
                    line.split([' ', '=']).next() == Some(name)
                };
                text.lines().find(is_its).map(str::to_owned)
            };
            let told = line(&listed).ok_or_else(|| format!("{body}: no {name}"))?;
            assert!(told.contains(key.meaning), "{body}: {told}");
            // A schema has defaults apart.
            let meaning = key.meaning.split(" (default").next().unwrap_or_default();
            let described = described(&schema, name);
            assert!(
                described.iter().any(|text| text.contains(meaning)),
                "{body}: {name}: {described:?}"
            );
        }
        // What a scene says of itself is told too.
        let checked = told(["scene", "check", place])?;
        let values = checked.lines().filter(|line| line.starts_with("  "));
        let names = values.filter_map(|line| Some(line.split_once(" = ")?.0.trim()));
        for name in names {
            let key = format!("  {name} ");
            assert!(listed.contains(&key), "{body}: {name}");
        }
    }
    Ok(())
}

/// Descriptions of a property, wherever the schema has it.
fn described(schema: &Value, name: &str) -> Vec<String> {
    match schema {
        Value::Object(members) => {
            let here = members
                .get("properties")
                .map(|all| &all[name]["description"]);
            let here = here.and_then(Value::as_str).map(str::to_owned);
            let inside = members.values().flat_map(|value| described(value, name));
            here.into_iter().chain(inside).collect()
        }
        Value::Array(values) => values
            .iter()
            .flat_map(|value| described(value, name))
            .collect(),
        _ => Vec::new(),
    }
}

#[test]
fn every_command_has_a_manual_page() -> Outcome {
    let folder = tempfile::tempdir()?;
    let out = folder.path().join("man1");
    let place = out.to_str().ok_or("a name")?;
    told(["man", "--out", place])?;
    let mut names: Vec<String> = commands()
        .iter()
        .map(|(path, _)| format!("tribos-{}.1", path.join("-")))
        .collect();
    names.push("tribos.1".into());
    assert_eq!(std::fs::read_dir(&out)?.count(), names.len());
    for name in &names {
        let page = std::fs::read_to_string(out.join(name))?;
        assert_has(
            &page,
            &[".SH NAME", ".SH SYNOPSIS", ".SH OPTIONS", ".SH EXAMPLES"],
        );
    }
    // A reader of manuals, where there is one.
    let mut mandoc = std::process::Command::new("mandoc");
    mandoc
        .args(["-Tlint", "-W", "error"])
        .current_dir(&out)
        .args(&names);
    match mandoc.output() {
        Ok(output) => assert!(output.status.success(), "{output:?}"),
        Err(_) => println!("skipped: no mandoc"),
    }
    Ok(())
}

#[test]
fn fish_completes_values_where_it_is_installed() -> Outcome {
    let folder = tempfile::tempdir()?;
    let program = Path::new(env!("CARGO_BIN_EXE_tribos"));
    let own = program.parent().ok_or("no folder")?.display();
    let asked =
        "tribos completions fish | source; complete -C 'tribos run disk --set integrator=v'";
    let fish = std::process::Command::new("fish")
        .args(["-c", asked])
        .env("PATH", format!("{own}:{}", std::env::var("PATH")?))
        .env("HOME", folder.path())
        .output();
    match fish {
        Ok(output) => assert!(
            output.stdout.starts_with(b"integrator=verlet"),
            "{output:?}"
        ),
        Err(_) => println!("skipped: no fish"),
    }
    Ok(())
}
