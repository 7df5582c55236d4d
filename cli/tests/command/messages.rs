//! Messages quote what they got, say what was meant, and say what was written.

use crate::program::{Outcome, refused, tribos};
use assert_cmd::Command;

const DISK: &str = "speed = 1.0\nspin = 5.0\ngamma = 0.3\nalpha = 0.0\ngravity = 9.81\n\
                    radius = 0.08\nmass = 0.1\ninertia_ratio = 0.5\n";

#[test]
fn a_syntax_error_is_the_only_problem_of_a_file() -> Outcome {
    let folder = tempfile::tempdir()?;
    let file = folder.path().join("scene.toml");
    for (text, line, words) in [
        ("body = \"powder\"\nwidth = \nheight = 8\n", 2, "not TOML"),
        (
            "body = \"tip\"\nlambda = 0,02\n",
            2,
            "write a decimal point: 0.02",
        ),
        (
            "body = \"powder\"\nwidth = 10\npressure = 1kPa # much\n",
            3,
            "got 1kPa; numbers carry no units",
        ),
        ("width 8\n", 1, "key = value"),
    ] {
        std::fs::write(&file, text)?;
        // What else is said on the command line cannot be judged either.
        for arguments in [
            "scene check scene.toml",
            "run scene.toml --out out --set nonsense=1",
        ] {
            let told = refused(folder.path(), arguments)?;
            assert!(told.contains(&format!("scene.toml:{line}: ")), "{told}");
            assert!(told.contains(words), "{told}");
            assert!(
                !told.contains("missing") && !told.contains("unknown key"),
                "{told}"
            );
            assert_eq!(told.trim().lines().count(), 1, "{told}");
        }
    }
    Ok(())
}

#[test]
fn values_are_quoted_with_what_is_wrong_about_them() -> Outcome {
    let folder = tempfile::tempdir()?;
    std::fs::write(folder.path().join("disk.toml"), DISK)?;
    std::fs::write(folder.path().join("twists.csv"), "speed,spin\n1 m/s,2\n")?;
    for (arguments, words) in [
        (
            "run disk.toml --out x --set mass=1kg",
            "got \"1kg\"; numbers carry no units",
        ),
        (
            "run disk.toml --out x --set mass=0,5",
            "got \"0,5\"; write a decimal point: 0.5",
        ),
        ("run disk.toml --out x --set mass=heavy", "got \"heavy\""),
        (
            "wrench --speed 1m/s --spin 1",
            "got 1m/s; numbers carry no units",
        ),
        ("wrench --speed 0,5 --spin 1", "write a decimal point: 0.5"),
        ("wrench --twists twists.csv", "numbers carry no units"),
        (
            "wrench --speed 1 --spin 1 --law coulomb:mu=30%",
            "numbers carry no units",
        ),
    ] {
        let told = refused(folder.path(), arguments)?;
        assert!(told.contains(words), "{arguments}: {told}");
    }
    Ok(())
}

#[test]
fn words_that_are_nearly_right_are_told_apart_from_others() -> Outcome {
    let folder = tempfile::tempdir()?;
    for (arguments, words) in [
        ("run dsik --out x", "did you mean `disk`?"),
        (
            "run compactoin-small --out x",
            "did you mean `compaction-small`?",
        ),
        ("run xyzzy --out x", "there are disk,"),
        ("scene show curling-darw", "did you mean `curling-draw`?"),
        ("scene new pwoder", "did you mean `powder`?"),
        ("scene keys cylindre", "did you mean `cylinder`?"),
        ("scene schema cylindre", "did you mean `cylinder`?"),
        ("laws strybeck", "did you mean `stribeck`?"),
        (
            "wrench --speed 1 --spin 1 --law strybeck:mu_s=1",
            "did you mean `stribeck`?",
        ),
        (
            "wrench --speed 1 --spin 1 --law dry:mus=1",
            "did you mean `mu_s`?",
        ),
        (
            "wrench --speed 1 --spin 1 --patch hetrz",
            "did you mean `hertz`?",
        ),
        (
            "run disk --out x --set integrator=verlett",
            "did you mean \"verlet\"?",
        ),
        (
            "run disk --out x --set body=cilinder",
            "did you mean \"cylinder\"?",
        ),
        ("run disk --out x --set sped=1", "did you mean `speed`?"),
        ("wrench --speed 1 --spin 1 --tier compct", "'compact'"),
    ] {
        let told = refused(folder.path(), arguments)?;
        assert!(told.contains(words), "{arguments}: {told}");
    }
    Ok(())
}

#[test]
fn a_file_in_the_place_of_a_folder_is_said_to_be_one() -> Outcome {
    let folder = tempfile::tempdir()?;
    std::fs::write(folder.path().join("taken"), "text")?;
    for arguments in [
        "run disk --out taken",
        "sweep disk --set spin=1,2 --out taken",
        "deposit --count 10 --width 8 --out taken",
        "man --out taken",
    ] {
        let told = refused(folder.path(), arguments)?;
        assert!(
            told.contains("'taken'") && told.contains("that is a file"),
            "{arguments}: {told}"
        );
    }
    assert_eq!(
        std::fs::read_to_string(folder.path().join("taken"))?,
        "text"
    );
    Ok(())
}

#[test]
fn an_empty_name_is_refused_and_a_link_to_nowhere_is_said_to_be_one() -> Outcome {
    let folder = tempfile::tempdir()?;
    for arguments in [
        "run disk --out",
        "sweep disk --set spin=1,2 --out",
        "sweep --plan",
        "sweep --merge",
        "deposit --count 10 --width 8 --out",
        "export lammps tip-reversible --out",
        "export xyz",
        "man --out",
        "golden write disk --out",
        "scene new powder --out",
        "laws --curve coulomb:mu=0.3 --out",
        "wrench --speed 1 --spin 1 --output",
        "wrench --twists",
        "run --out out",
        "view",
    ] {
        let output = Command::cargo_bin("tribos")?
            .current_dir(folder.path())
            .args(arguments.split_whitespace())
            .arg("")
            .output()?;
        let told = String::from_utf8(output.stderr)?;
        assert_eq!(output.status.code(), Some(2), "{arguments}: {told}");
        assert!(told.contains("the name is empty"), "{arguments}: {told}");
    }
    assert_eq!(std::fs::read_dir(folder.path())?.count(), 0);
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink("nowhere", folder.path().join("link"))?;
        let told = refused(folder.path(), "run disk --out link")?;
        assert!(
            told.contains("symbolic link to what is not there"),
            "{told}"
        );
    }
    Ok(())
}

#[test]
fn commands_that_write_a_file_say_so() -> Outcome {
    let folder = tempfile::tempdir()?;
    let (code, said, _) = tribos(folder.path(), "laws --curve coulomb:mu=0.3 --out law.svg")?;
    assert_eq!((code, said.as_str()), (Some(0), "written to    law.svg\n"));
    let (code, _, told) = tribos(folder.path(), "wrench --speed 1 --spin 1 --output one.txt")?;
    assert_eq!(code, Some(0));
    assert!(told.contains("written to    one.txt"), "{told}");
    let arguments = "modes --alpha 0 --inertia-ratio 0.5 --diagram modes.csv";
    let (code, said, _) = tribos(folder.path(), arguments)?;
    assert_eq!(code, Some(0));
    assert!(said.contains("written to modes.csv"), "{said}");
    Ok(())
}

#[test]
fn golden_takes_scenes_by_name() -> Outcome {
    let folder = tempfile::tempdir()?;
    let (code, said, told) = tribos(folder.path(), "golden write disk pipe-a --out pinned.toml")?;
    assert_eq!(code, Some(0), "{told}");
    assert!(said.contains("disk: 201 rows"), "{said}");
    let (code, said, _) = tribos(folder.path(), "golden verify pinned.toml --only disk")?;
    assert_eq!(code, Some(0), "{said}");
    assert!(said.contains("disk: same"), "{said}");
    assert!(
        refused(folder.path(), "golden write dsik --out x.toml")?.contains("did you mean `disk`?")
    );
    Ok(())
}
