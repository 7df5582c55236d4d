//! `tribos export vtk|xyz|lammps-dump`: whole trajectories, read back.

use crate::program::{Error, Outcome, succeed};
use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use nalgebra::Vector3;
use std::path::Path;
use tribos::md::{extended_xyz, lammps};
use tribos::record::frames::{Bodies, Frame, FrameFolder};

const TIP: &str = "body = \"tip\"\nlambda = 0.02\nsubstrate_columns = 12\nsubstrate_rows = 14\ntip_side_atoms = 3\n\
                   substrate_layers = 4\ntip_layers = 4\nequilibration = 0.1\ndrive_time = 0.2\n\
                   rest_time = 0.1\nsample_every = 10\n";
const POWDER: &str = "body = \"powder\"\nwidth = 6\nheight = 8\npressure = 0.02\nmax_steps = 60\n";

/// All frames of a run.
fn frames(run: &Path) -> Result<(Bodies, Vec<Frame>), Error> {
    let folder = run.join("frames");
    let bodies = FrameFolder::bodies(&folder)?.ok_or("no frames")?;
    let steps = FrameFolder::steps(&folder)?;
    let read = |step| FrameFolder::read(&folder, &bodies, step);
    let frames = steps.into_iter().map(read).collect::<Result<_, _>>()?;
    Ok((bodies, frames))
}

/// In the files places have single precision.
#[track_caller]
fn assert_places(read: &[Vector3<f64>], frame: &Frame) {
    assert_eq!(read.len(), frame.places.len());
    for (read, place) in read.iter().zip(&frame.places) {
        assert_eq!(read.map(|x| x as f32), place.map(|x| x as f32));
    }
}

/// An array of a VTP file as its bytes.
fn array(text: &str, name: &str) -> Result<Vec<u8>, Error> {
    let (_, rest) = text
        .split_once(&format!("Name=\"{name}\""))
        .ok_or("no such array")?;
    let (_, rest) = rest.split_once("format=\"binary\">").ok_or("no data")?;
    let (data, _) = rest.split_once('<').ok_or("no end")?;
    let bytes = STANDARD.decode(data)?;
    let (length, bytes) = bytes.split_first_chunk().ok_or("no length")?;
    assert_eq!(u64::from_le_bytes(*length), bytes.len() as u64);
    Ok(bytes.to_vec())
}

fn doubles(bytes: &[u8]) -> Vec<f64> {
    let numbers = bytes.as_chunks().0.iter();
    numbers.map(|bytes| f64::from_le_bytes(*bytes)).collect()
}

#[test]
fn a_tip_and_a_powder_are_read_back_frame_by_frame() -> Outcome {
    for (scene, column) in [(TIP, "layer"), (POWDER, "coordination")] {
        let home = tempfile::tempdir()?;
        let home = home.path();
        std::fs::write(home.join("scene.toml"), scene)?;
        succeed(home, "run scene.toml --out run --frames 100")?;
        let run = home.join("run");
        let (bodies, frames) = frames(&run)?;
        assert!(frames.len() > 3);
        for format in ["vtk", "xyz", "lammps-dump"] {
            succeed(home, format!("export {format} run --out files"))?;
        }
        let files = home.join("files");
        let text = |name: &str| std::fs::read_to_string(files.join(name));

        let dump = text("trajectory.dump")?;
        let read = lammps::frames(&dump).collect::<Result<Vec<_>, _>>()?;
        assert_eq!(read.len(), frames.len());
        for (read, frame) in read.iter().zip(&frames) {
            assert_eq!(read.step, frame.step);
            assert_eq!(read.is_periodic, [true, true, false]);
            assert_eq!(read.bounds[0], [0.0, bodies.sides[0]]);
            assert_places(&read.atoms.positions, frame);
            let types = bodies.parts.iter().zip(&read.atoms.species);
            assert!(types.into_iter().all(|(part, species)| part == species));
        }

        let xyz = text("trajectory.xyz")?;
        let lines: Vec<&str> = xyz.lines().collect();
        let stretch = bodies.radii.len() + 2;
        assert_eq!(lines.len(), stretch * frames.len());
        for (lines, frame) in lines.chunks(stretch).zip(&frames) {
            let read = extended_xyz::last_frame(&(lines.join("\n") + "\n"))?;
            assert_places(&read.atoms.positions, frame);
            assert!(lines[1].contains(&format!("Step={}", frame.step)));
            let speed = lines[2].split(' ').nth(6).map(str::parse);
            assert_eq!(speed, Some(Ok(frame.speeds[0])), "{}", lines[2]);
        }

        let collection = text("trajectory.pvd")?;
        let sets: Vec<&str> = collection
            .lines()
            .filter(|line| line.contains("<DataSet"))
            .collect();
        assert_eq!(sets.len(), frames.len());
        for (set, frame) in sets.iter().zip(&frames) {
            let value = |key: &str| {
                let (_, rest) = set.split_once(&format!("{key}=\""))?;
                Some(rest.split_once('"')?.0)
            };
            let time: f64 = value("timestep").ok_or("no time")?.parse()?;
            assert_eq!(time, frame.time);
            let state = text(value("file").ok_or("no file")?)?;
            let places = doubles(&array(&state, "Points")?);
            let wanted: Vec<f64> = frame.places.iter().flat_map(|x| [x.x, x.y, x.z]).collect();
            assert_eq!(places, wanted);
            assert_eq!(doubles(&array(&state, "radius")?), bodies.radii);
            assert_eq!(array(&state, column)?.len(), 8 * bodies.radii.len());
        }

        // A run that was broken off has frames and no summary; fewer states replace the others.
        std::fs::remove_file(run.join("summary.json"))?;
        let last = frames.last().ok_or("no frames")?.step;
        std::fs::remove_file(run.join(format!("frames/{last:012}.frame")))?;
        succeed(home, "export vtk run --out files")?;
        let states = std::fs::read_dir(files.join("trajectory"))?.count();
        assert_eq!(states, frames.len() - 1);
    }
    Ok(())
}

#[test]
fn a_body_in_the_plane_is_exported_along_its_path() -> Outcome {
    let home = tempfile::tempdir()?;
    let home = home.path();
    succeed(home, "run cylinder --out run")?;
    for format in ["vtk", "xyz", "lammps-dump"] {
        succeed(home, format!("export {format} run"))?;
    }
    let run = home.join("run");
    let series = std::fs::read_to_string(run.join("series.csv"))?;
    let head: Vec<&str> = series
        .lines()
        .next()
        .unwrap_or_default()
        .split(',')
        .collect();
    let at = |name: &str| {
        head.iter()
            .position(|&column| column == name)
            .ok_or("no column")
    };
    let [x, y, vx] = [at("x")?, at("y")?, at("vx")?];
    let dump = std::fs::read_to_string(run.join("trajectory.dump"))?;
    let read = lammps::frames(&dump).collect::<Result<Vec<_>, _>>()?;
    assert_eq!(read.len(), series.lines().count() - 1);
    for (read, line) in read.iter().zip(series.lines().skip(1)) {
        let cells: Vec<f64> = line
            .split(',')
            .map(|cell| cell.parse().unwrap_or(f64::NAN))
            .collect();
        let single = |at: usize| cells[at] as f32;
        let atoms = &read.atoms;
        let place = atoms.positions[0].map(|x| x as f32);
        assert_eq!([place.x, place.y], [single(x), single(y)]);
        assert_eq!(atoms.velocities[0].x as f32, single(vx));
    }
    assert_eq!(read[0].is_periodic, [false; 3]);
    Ok(())
}
