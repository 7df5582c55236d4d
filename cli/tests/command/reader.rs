//! A reader's folder, and a shell in it: for what the docs, the helps and the transcripts print.

use crate::program::{Error, Outcome, Said, texts};
use std::fs;
use std::io::Write;
use std::path::Path;
use std::process::{Command, Stdio};

/// What a shell line says in the folder that stands for the reader's home, and the exit code of its last command.
pub fn said(folder: &Path, line: &str, input: &str) -> Result<Said, Error> {
    let program = Path::new(env!("CARGO_BIN_EXE_tribos"));
    let own = program.parent().ok_or("no folder")?.display();
    let path = format!("{own}:{}", std::env::var("PATH")?);
    let mut shell = Command::new("sh")
        .args(["-c", line])
        .current_dir(folder)
        .env("PATH", path)
        .env("HOME", folder)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()?;
    // A command that reads nothing may be gone already.
    if let Some(mut pipe) = shell.stdin.take() {
        let _ = pipe.write_all(input.as_bytes());
    }
    let output = shell.wait_with_output()?;
    let [out, err] = texts(&output)?;
    Ok((output.status.code(), out, err))
}

/// The scenes, and the files that a reader is taken to have.
pub fn prepare(folder: &Path) -> Outcome {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    copy(&root.join("scenes"), &folder.join("scenes"))?;
    fs::copy(root.join("scenes/disk.toml"), folder.join("my.toml"))?;
    let contacts = root.join("std-adapter/contacts/src/problem/file/samples");
    for (theirs, ours) in [
        ("Rover1041.dat", "rover.dat"),
        ("NESpheres_10_1.dat", "spheres.dat"),
    ] {
        fs::copy(contacts.join(theirs), folder.join(ours))?;
    }
    // Where shells look for completions.
    for place in [
        ".local/share/bash-completion/completions",
        ".zfunc",
        ".config/fish/completions",
    ] {
        fs::create_dir_all(folder.join(place))?;
    }
    let atoms = root.join("tests/tables/md");
    for (theirs, ours) in [
        ("fcc500.data", "melt.data"),
        ("slab576.data", "slab.data"),
        ("binary500.data", "glass.data"),
        ("synthetic.eam", "metal.eam"),
    ] {
        fs::copy(atoms.join(theirs), folder.join(ours))?;
    }
    // A metal under the name of another.
    let metal = fs::read_to_string(atoms.join("synthetic.eam.alloy"))?;
    let metal = metal.replacen("2 Aa Bb", "2 Cu Bb", 1);
    fs::write(folder.join("Cu_mishin1.eam.alloy"), metal)?;
    fs::write(folder.join("copper.xyz"), copper())?;
    fs::write(folder.join("twists.csv"), "speed,spin\n1,0\n0.5,20\n")?;
    let feet = "x,y,weight\n0.1,0,0.4\n-0.1,0.1,0.3\n-0.1,-0.1,0.3\n";
    fs::write(folder.join("feet.csv"), feet)?;
    let sole = "x,y\n0,0\n0.24,0\n0.24,0.1\n0,0.08\n";
    fs::write(folder.join("sole.csv"), sole)?;
    let belts = "surface,x,y,velocity_x,velocity_y,spin\n\
        left,0,0,0.5,0,0\nleft,1,0,0.5,0,0\nright,0,0,-0.5,0,0\nright,-1,0,-0.5,0,0\n";
    fs::write(folder.join("belts.csv"), belts)?;
    let robot = "patch,x,y,radius,velocity_x,velocity_y,spin\n\
        disk,0.2,0.25,0.02,-0.2,0,0\ndisk,-0.2,0.25,0.02,-0.2,0,0\n\
        disk,0.2,-0.25,0.02,0.2,0,0\ndisk,-0.2,-0.25,0.02,0.2,0,0\n";
    fs::write(folder.join("robot.csv"), robot)?;
    fs::write(folder.join("plain.xyz"), "2\n\nSi 0 0 0\nSi 0 0 1\n")?;
    fs::write(
        folder.join("grains.csv"),
        "x,y,z,R_eq\n0,0,0,0.002\n0,0,0.004,0.002\n",
    )?;
    let face = "x1,y1,p1,x2,y2,p2,x3,y3,p3\n0,0,1,0.1,0,2,0,0.1,0\n";
    fs::write(folder.join("face.csv"), face)?;
    let pushes = "force_x,force_y,torque\n100,20,5\n300,0,-10\n";
    fs::write(folder.join("pushes.csv"), pushes)?;
    measurements(folder)
}

/// Friction over speed, and over time, as somebody may have measured it.
fn measurements(folder: &Path) -> Outcome {
    let speeds: Vec<f64> = (0..40).map(|i| 1e-4 * 1.25_f64.powi(i)).collect();
    let noise = |i: usize| 1e-3 * ((7 * i % 11) as f64 - 5.0);
    let steady = |f: &dyn Fn(f64) -> f64, columns: &str, rest: &str| {
        let lines = speeds.iter().enumerate();
        let lines = lines.map(|(i, v)| format!("{v},{}{rest}\n", f(*v) + noise(i)));
        format!("{columns}\n{}", lines.collect::<String>())
    };
    let stribeck = |v: f64| 0.1 + 0.05 * (-(v / 0.01).powi(2)).exp() + 0.02 * v;
    fs::write(
        folder.join("bearing.csv"),
        steady(&stribeck, "v,f,sigma", ",0.002"),
    )?;
    fs::write(
        folder.join("forces.csv"),
        steady(&|v| 12.5 * stribeck(v), "v,f", ""),
    )?;
    fs::write(
        folder.join("ice.csv"),
        steady(&|v| 0.05 * v.powf(0.5), "v,f", ""),
    )?;
    fs::write(
        folder.join("steps.csv"),
        steady(&|v| 0.6 - 0.01 * v.ln(), "v,f", ""),
    )?;
    let pull = (0..300).map(|i| {
        let (t, v) = (1e-3 * f64::from(i), 0.05 * (0.04 * f64::from(i)).sin());
        format!(
            "{t},{v},{}\n",
            (1.0 - (-30.0 * t).exp()) * v.signum() + 0.4 * v
        )
    });
    fs::write(
        folder.join("pull.csv"),
        format!("t,v,f\n{}", pull.collect::<String>()),
    )?;
    Ok(())
}

/// A folder with all below it.
pub fn copy(from: &Path, to: &Path) -> Outcome {
    fs::create_dir_all(to)?;
    for entry in fs::read_dir(from)? {
        let (path, name) = (
            entry.as_ref().map(fs::DirEntry::path),
            entry.as_ref().map(fs::DirEntry::file_name),
        );
        let (Ok(path), Ok(name)) = (path, name) else {
            continue;
        };
        if path.is_dir() {
            copy(&path, &to.join(name))?;
        } else {
            fs::copy(&path, to.join(name))?;
        }
    }
    Ok(())
}

/// A crystal of 3 × 3 × 3 cubes of four atoms.
fn copper() -> String {
    const EDGE: f64 = 3.6;
    let side = 3.0 * EDGE;
    let mut text = format!(
        "108\nLattice=\"{side} 0 0 0 {side} 0 0 0 {side}\" pbc=\"T T T\" Properties=species:S:1:pos:R:3\n"
    );
    for cell in 0..27 {
        let corner = [cell % 3, cell / 3 % 3, cell / 9].map(f64::from);
        for shift in [
            [0.0, 0.0, 0.0],
            [0.5, 0.5, 0.0],
            [0.5, 0.0, 0.5],
            [0.0, 0.5, 0.5],
        ] {
            let [x, y, z] = [0, 1, 2].map(|axis| EDGE * (corner[axis] + shift[axis]));
            text += &format!("Cu {x} {y} {z}\n");
        }
    }
    text
}
