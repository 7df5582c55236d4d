//! Help, completions and manual: every command has them, with examples.

use assert_cmd::Command;
use clap::Command as Clap;
use tribos_cli::command::program;

type Error = Box<dyn std::error::Error>;
type Outcome = Result<(), Error>;

/// Every command with its path, subcommands of subcommands too.
fn all(command: &Clap, path: &[String], found: &mut Vec<(Vec<String>, Clap)>) {
    for sub in command.get_subcommands() {
        let mut path = path.to_vec();
        path.push(sub.get_name().to_owned());
        found.push((path.clone(), sub.clone()));
        all(sub, &path, found);
    }
}

fn commands() -> Vec<(Vec<String>, Clap)> {
    let mut found = Vec::new();
    all(&program(), &[], &mut found);
    found
}

fn said(arguments: &[&str]) -> Result<String, Error> {
    let output = Command::cargo_bin("tribos")?.args(arguments).output()?;
    assert!(output.status.success(), "{arguments:?}");
    Ok(String::from_utf8(output.stdout)?)
}

#[test]
fn the_first_page_names_every_command_once_and_shows_examples() -> Outcome {
    let page = said(&["--help"])?;
    for command in program().get_subcommands() {
        let name = command.get_name();
        let line = |line: &&str| line.starts_with(&format!("  {name} "));
        assert_eq!(page.lines().filter(line).count(), 1, "{name}: {page}");
    }
    for words in ["Examples:\n", "\n    tribos run ", "docs/how-to.md"] {
        assert!(page.contains(words), "{words}");
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
fn every_command_has_a_manual_page() -> Outcome {
    let folder = tempfile::tempdir()?;
    let out = folder.path().join("man1");
    let place = out.to_str().ok_or("a name")?;
    said(&["man", "--out", place])?;
    let mut names: Vec<String> = commands()
        .iter()
        .map(|(path, _)| format!("tribos-{}.1", path.join("-")))
        .collect();
    names.push("tribos.1".into());
    assert_eq!(std::fs::read_dir(&out)?.count(), names.len());
    for name in &names {
        let page = std::fs::read_to_string(out.join(name))?;
        for section in [".SH NAME", ".SH SYNOPSIS", ".SH OPTIONS", ".SH EXAMPLES"] {
            assert!(page.contains(section), "{name}: {section}");
        }
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
fn bash_completes_commands_options_and_values() -> Outcome {
    let folder = tempfile::tempdir()?;
    let script = folder.path().join("tribos.bash");
    std::fs::write(&script, said(&["completions", "bash"])?)?;
    let completed = |words: &str| -> Result<String, Error> {
        let count = words.split(' ').count() - 1;
        // As the shell calls it after the key is pressed.
        let call = format!(
            "source '{}' && complete -p tribos >/dev/null && COMP_WORDS=({words}) COMP_CWORD={count} \
             && _tribos tribos \"${{COMP_WORDS[-1]}}\" \"${{COMP_WORDS[-2]}}\" && echo \"${{COMPREPLY[@]}}\"",
            script.display()
        );
        let output = std::process::Command::new("bash")
            .args(["-c", &call])
            .output();
        match output {
            Ok(output) if output.status.success() => Ok(String::from_utf8(output.stdout)?),
            Ok(output) => Err(format!("{output:?}").into()),
            Err(_) => Ok("skipped".into()),
        }
    };
    for (words, expected) in [
        ("tribos sw", "sweep"),
        ("tribos sweep --me", "--merge"),
        ("tribos golden ve", "verify"),
        ("tribos wrench --tier comp", "compact"),
    ] {
        let found = completed(words)?;
        assert!(
            found.trim() == expected || found == "skipped",
            "{words}: {found}"
        );
    }
    for shell in ["zsh", "fish", "powershell", "elvish"] {
        let text = said(&["completions", shell])?;
        assert!(
            text.contains("tribos") && text.contains("reproduce"),
            "{shell}"
        );
    }
    Ok(())
}
