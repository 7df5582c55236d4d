//! The driver of packings: steps, measurements, series, checkpoints, limits.
//!
//! A [`Body`] says its loads, its measures and when it ends; all else of a run is here.

use super::body::{Body, Ending, MeasuredState, MeasurementSchedule};
use super::checkpoint::{ORIGIN, PackingCheckpoint};
use super::last::put_report;
use super::{Kinds, Limits, Packing, PackingRunError, Shape, Stored, Totals};
use serde_json::{Map, Value};
use std::borrow::Cow;
use std::error::Error;
use std::time::Instant;
use tribos_base::golden::{Digest, Measurement, contacts, digest};
use tribos_base::record::checkpoint::hex;
use tribos_base::record::frames::{Bodies, ContactStateFlags, Frame, FrameContact, Kind};
use tribos_base::record::{ContactRow, Snapshot, json_number, with_digest};
use tribos_contacts::cd::{EnergyBalance, StepReport};
use tribos_contacts::problem::GlobalProblem;

/// Overlap of rigid spheres over the smaller radius beyond which their packing is none: twice what a start may have.
const TOO_DEEP: f64 = 0.1;

/// A packing in motion.
#[derive(Debug)]
pub(crate) struct PackingDriver<B: Body<N>, const N: usize> {
    pub body: B,
    pub watch: B::Monitor,
    pub seen: MeasuredState,
    pub series: Vec<[f64; N]>,
    /// Why the run ended, if it has.
    pub ending: Option<B::Ending>,
    pub kinds: Kinds,
    /// Digest of what the run began with.
    origin: String,
    totals: Totals,
    started: Instant,
}

/// What a frame tells of a body beside its spheres.
#[derive(Clone, Copy, Debug)]
pub(crate) struct FrameInfo<'a> {
    pub limits: &'a Limits,
    pub height: f64,
    pub measure: f64,
    /// Low and high coordinates of the box.
    pub extents: [[f64; 2]; 3],
}

impl<B: Body<N>, const N: usize> PackingDriver<B, N> {
    /// A run at its start, or where it was kept.
    pub fn begin<P: Error>(
        (body, watch): (B, B::Monitor),
        (packing, contacts): (Box<dyn Packing>, Vec<ContactRow>),
        (kinds, origin): (Kinds, String),
        kept: Option<PackingCheckpoint<B, N>>,
    ) -> Result<Self, PackingRunError<P>> {
        let mut run = Self {
            body,
            watch,
            seen: MeasuredState {
                packing,
                contacts,
                report: StepReport::default(),
            },
            series: Vec::new(),
            ending: None,
            kinds,
            origin,
            totals: Totals::default(),
            started: Instant::now(),
        };
        match kept {
            Some(kept) => run.restore(kept)?,
            None => run.series.push(run.line()),
        }
        Ok(run)
    }

    /// Takes over what a checkpoint has beside the packing.
    fn restore<P: Error>(
        &mut self,
        kept: PackingCheckpoint<B, N>,
    ) -> Result<(), PackingRunError<P>> {
        self.watch = kept.watch;
        self.totals = kept.totals;
        self.series = kept.series;
        self.ending = kept.ending;
        self.seen.report = kept.report;
        if self.steps() > 0 {
            self.find_contacts()?;
        }
        Ok(())
    }

    /// Takes one step; `false` once the run has ended, which takes no more steps.
    pub fn step<P: Error>(&mut self) -> Result<bool, PackingRunError<P>> {
        if self.ending.is_some() {
            return Ok(false);
        }
        let (watch, seen) = (&mut self.watch, &mut self.seen);
        self.body.prepare(watch, &mut *seen.packing);
        seen.report = seen.packing.step()?;
        self.totals.add(&seen.report);
        self.check_overlap()?;
        if B::CADENCE == MeasurementSchedule::Steps {
            self.measure_step()?;
        }

        // Lines of the series; the last state is one of them.
        let bounds = self.body.bounds();
        let ending = if self.body.is_over(&mut self.watch, &self.seen) {
            Some(B::Ending::OVER)
        } else {
            bounds.reached(self.seen.packing.clock())
        };
        let is_line = ending.is_some() || self.steps().is_multiple_of(bounds.samples);
        if is_line && B::CADENCE == MeasurementSchedule::Lines {
            self.measure_step()?;
        }
        if is_line {
            self.judge_overlap()?;
        }
        if is_line || B::CADENCE == MeasurementSchedule::Steps {
            let line = self.finite_line()?;
            if is_line {
                self.series.push(line);
            }
        }
        self.ending = ending;
        Ok(ending.is_none())
    }

    /// Refuses a packing that rigid spheres cannot have, where the step began with such an overlap for the smallest.
    fn check_overlap<P: Error>(&mut self) -> Result<(), PackingRunError<P>> {
        let radii = self.seen.packing.radii().iter();
        let smallest = radii.copied().fold(f64::INFINITY, f64::min);
        if self.seen.packing.is_rigid() && self.seen.report.overlap > TOO_DEEP * smallest {
            self.find_contacts()?;
            self.judge_overlap()?;
        }
        Ok(())
    }

    /// Refuses such a packing by its contacts.
    fn judge_overlap<P: Error>(&self) -> Result<(), PackingRunError<P>> {
        let radii = self.seen.packing.radii();
        let radius = |body: Option<u32>| body.map_or(f64::INFINITY, |body| radii[body as usize]);
        let depth = |row: &ContactRow| -row.gap / radius(Some(row.a)).min(radius(row.b.particle()));
        let overlap = self.seen.contacts.iter().map(depth).fold(0.0, f64::max);
        if self.seen.packing.is_rigid() && overlap > TOO_DEEP {
            return Err(PackingRunError::Overlap {
                step: self.steps(),
                overlap,
                solid_fraction: self.body.solid_fraction(&self.seen),
            });
        }
        Ok(())
    }

    /// Finds the contacts after a step and measures them.
    fn measure_step<P: Error>(&mut self) -> Result<(), PackingRunError<P>> {
        self.find_contacts()?;
        self.body.measure(&mut self.watch, &self.seen);
        Ok(())
    }

    fn find_contacts<P: Error>(&mut self) -> Result<(), PackingRunError<P>> {
        let step = self.steps();
        let contacts = self.seen.packing.contacts();
        self.seen.contacts = contacts.map_err(|cause| PackingRunError::Touch { step, cause })?;
        Ok(())
    }

    /// The current line of the series.
    pub fn line(&self) -> [f64; N] {
        self.body.line(&self.watch, &self.seen)
    }

    /// The current line, if all its values and the energy balance are finite.
    fn finite_line<P: Error>(&self) -> Result<[f64; N], PackingRunError<P>> {
        let line = self.line();
        let named = B::COLUMNS.into_iter().zip(line);
        let balance = [("work", self.seen.packing.energy().imbalance())];
        match named.chain(balance).find(|(_, value)| !value.is_finite()) {
            Some((column, value)) => Err(PackingRunError::NotFinite {
                step: self.steps(),
                column,
                value,
            }),
            None => Ok(line),
        }
    }

    /// Share of the run that is done.
    pub fn progress(&self) -> f64 {
        self.body.bounds().progress(self.seen.packing.clock())
    }

    /// Elapsed time.
    pub fn time(&self) -> f64 {
        self.seen.packing.clock().0
    }

    /// Number of steps so far.
    pub fn steps(&self) -> u64 {
        self.seen.packing.clock().1
    }

    /// Sums over the steps, with the time up to now.
    pub fn totals(&self) -> Totals {
        Totals {
            wall_seconds: self.totals.wall_seconds + self.started.elapsed().as_secs_f64(),
            ..self.totals
        }
    }

    /// The contact problem of the last step; before the first there is none, nor after a restart.
    pub fn problem(&self) -> Option<GlobalProblem> {
        let problem = self.seen.packing.problem();
        problem.filter(|problem| !problem.laws().is_empty())
    }

    /// Contacts at the current places: between two lines of the series they are found anew.
    fn contacts_now(&self) -> Cow<'_, [ContactRow]> {
        let found = match B::CADENCE {
            MeasurementSchedule::Lines => self.seen.packing.contacts().ok(),
            MeasurementSchedule::Steps => None,
        };
        found.map_or(Cow::Borrowed(self.seen.contacts.as_slice()), Cow::Owned)
    }

    fn shape(&self) -> Shape {
        let walls = self.seen.packing.walls().iter();
        Shape {
            // Without the displacement of sheared images.
            space: self.seen.packing.space().sheared(0.0),
            radii: self.seen.packing.radii().to_vec(),
            kinds: self.kinds.clone(),
            outward: walls.map(|wall| wall.outward).collect(),
            contacts: self.contacts_now().into_owned(),
        }
    }

    /// The run as a checkpoint file.
    pub fn checkpoint(&self) -> String {
        let mut map = Map::new();
        map.insert(B::FORMAT.0.into(), B::FORMAT.1.into());
        map.insert("scene".into(), self.body.scene());
        // Read by runs that start from this state.
        self.shape().put(&mut map);
        self.seen.packing.snapshot().put(&mut map);
        self.totals().put(&mut map);
        put_report(&self.seen.report, &mut map);
        map.insert(ORIGIN.into(), self.origin.clone().into());
        B::write_checkpoint(&self.watch, &mut map);
        let series: Vec<f64> = self.series.iter().flatten().copied().collect();
        map.insert("series".into(), hex(&series).into());
        map.insert("ending".into(), self.ending.map(Ending::name).into());
        with_digest(map)
    }

    /// The current state as a file, from which a run of another scene can start.
    pub fn state(&self) -> String {
        let stored = Stored {
            scene: self.body.scene(),
            shape: self.shape(),
            frozen: self.seen.packing.snapshot(),
        };
        stored.text()
    }

    /// Calls `export` with the current state in a box of these extents.
    pub fn with_snapshot<T>(
        &self,
        extents: [[f64; 2]; 3],
        export: impl FnOnce(&Snapshot<'_>) -> T,
    ) -> T {
        let packing = &self.seen.packing;
        let spheres = packing.spheres();
        let velocities: Vec<_> = spheres.iter().map(|sphere| sphere.velocity).collect();
        let spins: Vec<_> = spheres.iter().map(|sphere| sphere.spin).collect();
        export(&Snapshot {
            time: self.time(),
            space: packing.space(),
            extents,
            positions: packing.positions(),
            radii: packing.radii(),
            velocities: Some(&velocities),
            spins: Some(&spins),
            species: None,
            materials: self.kinds.mixed(),
            densities: Some(&self.kinds.densities),
            contacts: &self.seen.contacts,
        })
    }

    /// Data common to all frames of a film.
    pub fn bodies(&self, kind: Kind, sides: [f64; 2], limit: u64) -> Bodies {
        Bodies {
            kind,
            scene: self.body.scene(),
            limit,
            stride: 1,
            sides,
            periods: self.seen.packing.space().lengths(),
            radii: self.seen.packing.radii().to_vec(),
            materials: self.kinds.mixed().unwrap_or_default().to_vec(),
            densities: self.kinds.densities.clone(),
            layers: Vec::new(),
            parts: Vec::new(),
            marked: Vec::new(),
        }
    }

    /// The current state as a frame.
    pub fn frame(&self, told: &FrameInfo<'_>) -> Frame {
        let packing = &self.seen.packing;
        let (space, radii) = (packing.space(), packing.radii());
        let corner = |end: usize| told.extents.map(|ends| ends[end] as f32);
        let contact = |row: &ContactRow| FrameContact {
            a: row.a,
            b: row.b,
            normal_force: row.normal_force() as f32,
            hold: told
                .limits
                .reached(row, radii)
                .map_or(ContactStateFlags::OPEN, ContactStateFlags::of),
        };
        let spheres = packing.spheres().iter();
        Frame {
            step: self.steps(),
            time: self.time(),
            height: told.height,
            measure: told.measure,
            corners: [corner(0), corner(1)],
            tilt: space.offset(),
            places: packing.positions().iter().map(|x| space.wrap(x)).collect(),
            speeds: spheres
                .map(|sphere| sphere.velocity.norm() as f32)
                .collect(),
            contacts: self.contacts_now().iter().map(contact).collect(),
        }
    }

    /// The end of a run for golden files.
    pub fn measurement(&self, summary: &Value) -> Measurement {
        let rows = self.series.iter().map(|row| row.to_vec());
        let mut measurement = Measurement::new(summary, &B::COLUMNS, rows);
        measurement.state = self.with_snapshot([[0.0; 2]; 3], |end| {
            vec![
                ("positions", digest(end.positions)),
                ("radii", Digest::of(end.radii.iter().copied())),
                ("velocities", digest(end.velocities.unwrap_or_default())),
                ("spins", digest(end.spins.unwrap_or_default())),
                ("contacts", contacts(end.contacts)),
            ]
        });
        measurement
    }
}

/// Where the energy went: names and energies.
pub(crate) fn losses(energy: &EnergyBalance) -> [(&'static str, f64); 5] {
    [
        ("normal", energy.normal),
        ("sliding", energy.sliding),
        ("rolling", energy.rolling),
        ("torsion", energy.torsion),
        ("cohesion", energy.cohesion),
    ]
}

/// Named numbers as a JSON object.
pub(crate) fn object(numbers: &[(&str, f64)]) -> Value {
    let entry = |(name, value): &(&str, f64)| ((*name).to_owned(), json_number(*value));
    Value::Object(numbers.iter().map(entry).collect())
}
