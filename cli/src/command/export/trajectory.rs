//! `tribos export vtk|xyz|lammps-dump`: all kept states of a run.

use crate::command::run::frames_folder;
use crate::command::view::path;
use crate::command::view::run_files::RunFiles;
use crate::failure::Failure;
use nalgebra::Vector3;
use std::path::{Path, PathBuf};
use tribos::record::frames::{Bodies, FrameFolder, Kind};
use tribos::record::trajectory::{self, Column, Format, Side, State, Values};
use tribos::run::folder::{self, Contents, OutputFolder};

/// All frames of a powder or a tip, or the path of a body in the plane, from a finished or interrupted
/// run.
///
/// Writes the box with its periods and tilt, positions in the cell, radii, speeds, densities and materials; the
/// number of contacts of each sphere, the layer and part of each atom of a tip, or the velocity, spin and angle of a body in the
/// plane. It has the frames that `tribos run --frames` kept, with positions exact to a 130,000th of
/// the box.
#[derive(Debug, clap::Args)]
#[command(after_long_help = super::EXAMPLES)]
pub struct Trajectory {
    /// The folder of the run.
    run: PathBuf,
    /// Folder for the files, created if missing; an export of another run in it is removed first.
    /// [default: that of the run]
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
}

/// What an export leaves.
fn files(format: Format) -> &'static [&'static str] {
    match format {
        Format::Vtk => &["trajectory.pvd", "trajectory/#.vtp"],
        Format::Xyz => &["trajectory.xyz"],
        Format::LammpsDump => &["trajectory.dump"],
    }
}

impl Trajectory {
    /// Writes, one state after another.
    pub fn write(self, format: Format) -> Result<(), Failure> {
        let kept = RunFiles::read(&self.run)?;
        let (states, file) = match &kept.bodies {
            Some(bodies) => self.solid(&kept, bodies, format)?,
            None => self.path(&kept, format)?,
        };
        crate::command::print(&format!(
            "written to    {}, {states} states\n",
            file.display()
        ))
    }

    /// The folder for the files: the run's, or one of their own.
    fn folder(
        &self,
        kept: &RunFiles,
        format: Format,
    ) -> Result<(&Path, Option<OutputFolder>), Failure> {
        match &self.out {
            Some(out) if !super::is_same(out, &self.run) => {
                let contents = Contents {
                    about: kept.manifest.about.clone(),
                    ..Contents::of("export", files(format))
                };
                Ok((out, Some(OutputFolder::reopen(out, &contents)?)))
            }
            _ => {
                folder::add(&self.run, files(format))?;
                Ok((&self.run, None))
            }
        }
    }

    fn solid(
        &self,
        kept: &RunFiles,
        bodies: &Bodies,
        format: Format,
    ) -> Result<(usize, PathBuf), Failure> {
        let frames = &frames_folder(&self.run);
        let steps = FrameFolder::steps(frames)?;
        if steps.is_empty() {
            return Err(Failure::input(format!(
                "{}: there is no frame yet; let the run continue to its first checkpoint",
                frames.display()
            )));
        }
        let (out, _lock) = self.folder(kept, format)?;
        let mut film = trajectory::Trajectory::begin(out, format)?;
        for step in steps {
            let frame = FrameFolder::read(frames, bodies, step)?;
            film.add(&State::of_frame(bodies, &frame))?;
        }
        // What frames cannot hold.
        let exact = match bodies.kind {
            Kind::Tip => "final.data",
            Kind::Powder | Kind::Grains | Kind::Gas => "final.xyz",
        };
        crate::command::note(format_args!(
            "frames have positions to half a 65535th of the box, speeds without directions and no spins; {exact} of a \
             finished run has all of its last state"
        ));
        Ok((film.states(), film.finish()?))
    }

    fn path(&self, kept: &RunFiles, format: Format) -> Result<(usize, PathBuf), Failure> {
        let folder = self.run.display();
        let Some(summary) = &kept.summary else {
            return Err(Failure::input(format!(
                "{folder}: no run is there, neither {} nor summary.json; \
                 make one with `tribos run SCENE --out {folder}`",
                frames_folder(&self.run).display()
            )));
        };
        if ["powder", "grains", "gas", "tip"]
            .contains(&summary["scene"]["body"].as_str().unwrap_or_default())
        {
            return Err(Failure::input(format!(
                "{folder}: the run kept no frames; run it again without `--frames 0`"
            )));
        }
        let states = states(&self.run, kept)?;
        let (out, _lock) = self.folder(kept, format)?;
        let mut film = trajectory::Trajectory::begin(out, format)?;
        for state in states {
            film.add(&state)?;
        }
        Ok((film.states(), film.finish()?))
    }
}

/// A body in the plane z = 0, line by line of its series.
fn states(run: &Path, kept: &RunFiles) -> Result<Vec<State>, Failure> {
    let rows = path::rows(&run.join("series.csv"), &kept.manifest)?;
    let radius = path::radius(&kept.manifest.about)?;
    let side = |axis: usize| {
        let places = rows.iter().map(|row| row[1 + axis]);
        let low = places.clone().fold(f64::INFINITY, f64::min);
        let high = places.fold(f64::NEG_INFINITY, f64::max);
        Side::open(low - radius, high + radius)
    };
    let sides = [side(0), side(1), Side::open(-radius, radius)];
    let state = |(step, row): (usize, &path::Row)| {
        let [time, x, y, angle, _, spin, vx, vy] = *row;
        State {
            step: step as u64,
            time,
            sides,
            tilt: 0.0,
            places: vec![Vector3::new(x, y, 0.0)],
            columns: vec![
                Column::new("radius", Values::Numbers(vec![radius])),
                Column::new("angle", Values::Numbers(vec![angle])),
                Column::new("velocity", Values::Vectors(vec![Vector3::new(vx, vy, 0.0)])),
                Column::new(
                    "angular_velocity",
                    Values::Vectors(vec![Vector3::z() * spin]),
                ),
            ],
        }
    };
    Ok(rows.iter().enumerate().map(state).collect())
}
