//! `tribos measure`: stress, fabric, correlations, force chains of a packing.

mod over_time;
mod report;

use super::number;
use super::packing::SpheresSource;
use crate::failure::Failure;
use over_time::MeansOverTime;
use serde_json::Value;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};
use tribos::measure::{AssemblyError, KnownForces, LayerProfile, MeasureOptions, Measures, Table};
use tribos::record::{write_atomically, write_series};
use tribos::run::folder::{Contents, OutputFolder};
use tribos_report::image;
use tribos_report::runs::measure as figures;

/// Measure a packing of spheres: porosity and its profile, stress, fabric, pair correlation, distribution of
/// the normal forces, contacts and rattlers, force chains, levers of the contact torques.
///
/// Reads the last state of a run, or a file of any format that `tribos packing` reads. A file of another program
/// has no forces: its contacts are those of the geometry.
///
/// Of a run of grains it also tells the means over time of the columns of its series with their standard errors: from
/// where each has settled, or from --average-from on; the latter of any run. With --frames the profiles of a flow are
/// means over time in layers: solid fraction, velocity, granular temperature and stress, each with its standard error.
///
/// With --out it writes measures.json, a table (.csv) and a figure (.svg and .png) of each measure. Lengths,
/// forces and stresses are in the units of the packing; those of a powder are R, F_coh and F_coh/R^2.
#[derive(Debug, clap::Args)]
#[command(after_long_help = EXAMPLES)]
pub struct Arguments {
    #[command(flatten)]
    source: SpheresSource,
    /// Folder for the results, created if missing. Results of an earlier command in it are removed first;
    /// files that tribos did not write are never replaced. The folder of a run is refused.
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Measure also every frame of the run, or of a file with many: as a series over the steps, with the bending of the
    /// force chains from frame to frame, and, where velocities are known, as means over time in layers across --axis, from
    /// --average-from or the middle of the record on. Frames have forces to 0.4 %.
    #[arg(long)]
    frames: bool,
    /// Largest distance of the pair correlation [default: ten mean radii, or what the box allows].
    #[arg(long, value_name = "LENGTH", value_parser = number::positive, allow_negative_numbers = true)]
    reach: Option<f64>,
    /// Number of bins of the pair correlation.
    #[arg(long, value_name = "N", default_value = "200", value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
    bins: u32,
    /// Largest angle, in degrees, between a contact and the principal stresses of its spheres in a force
    /// chain, where forces are known [default: 45].
    #[arg(long, value_name = "DEGREES", value_parser = angle, allow_negative_numbers = true)]
    angle: Option<f64>,
    /// Fewest contacts of a sphere that is no rattler.
    #[arg(long, value_name = "N", default_value = "2")]
    least_contacts: usize,
    /// Number of slices of the profiles.
    #[arg(long, value_name = "N", default_value = "20", value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
    slices: u32,
    /// Axis of the profiles.
    #[arg(long, value_enum, default_value = "z")]
    axis: Axis,
    /// Largest gap of contacts, in mean radii, where no forces are known [default: 0.001].
    #[arg(long, value_name = "GAP", value_parser = number::not_negative, allow_negative_numbers = true)]
    gap: Option<f64>,
    /// Density of all spheres, for the stress of their motion, where forces are known [default: their own].
    #[arg(long, value_name = "DENSITY", value_parser = number::positive, allow_negative_numbers = true)]
    density: Option<f64>,
    /// Time from which on means over time are taken, in the unit of the run [default: for each column that after which it
    /// has settled].
    #[arg(long, value_name = "TIME", value_parser = number::not_negative, allow_negative_numbers = true)]
    average_from: Option<f64>,
    /// Output format of the summary.
    #[arg(long, value_enum, default_value = "text")]
    format: Format,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum Axis {
    X,
    Y,
    Z,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum Format {
    Text,
    Json,
}

const EXAMPLES: &str = "\
Examples:
  Means over time of a flow, with their errors:
    tribos run shear-cell --out out/shear
    tribos measure out/shear
  A powder, measured at its end and over all of its frames:
    tribos run compaction-small --set height=20 --out out/powder
    tribos measure out/powder --out out/powder-measures --frames
  A file, as one of another program, with contacts up to a gap of 1 % of a radius:
    tribos measure out/powder/final.xyz --gap 0.01 --format json";

/// Files that --out gets.
const FILES: [&str; 23] = [
    "measures.json",
    "pair-correlation.csv",
    "pair-correlation.svg",
    "pair-correlation.png",
    "coordination.csv",
    "coordination.svg",
    "coordination.png",
    "porosity-profile.csv",
    "porosity-profile.svg",
    "porosity-profile.png",
    "forces.csv",
    "forces.svg",
    "forces.png",
    "force-chains.csv",
    "force-chains.svg",
    "force-chains.png",
    "necks.csv",
    "series.csv",
    "series.svg",
    "averages.csv",
    "layers.csv",
    "layers.svg",
    "layers.png",
];

/// An angle from 0 to 90 degrees.
fn angle(text: &str) -> Result<f64, String> {
    let degrees = number::positive(text)?;
    if degrees <= 90.0 {
        Ok(degrees)
    } else {
        Err("give an angle > 0 and <= 90 degrees".into())
    }
}

impl Arguments {
    /// Measures, writes and prints.
    pub fn execute(self) -> Result<(), Failure> {
        let options = self.options();
        let state = self.source.read()?;
        if state.radii.is_empty() {
            return Err(Failure::input(format!(
                "{}: there is no sphere",
                self.source.path.display()
            )));
        }
        self.refuse_idle(state.forces)?;
        let measures = Measures::of(state, &options).map_err(Failure::input)?;
        let averages = self.averages(&measures.assembly.scene)?;
        let frames = self.frames(&options)?;
        let mut summary = measures.json();
        if let Some(averages) = &averages {
            summary["averages"] = averages.json();
        }
        let summary = format!("{summary:#}\n");
        if let Some(out) = &self.out {
            write(out, &measures, (&frames, averages.as_ref()), &summary)?;
        }
        match self.format {
            Format::Json => super::print(&summary),
            Format::Text => super::print(&report::text(
                &measures,
                (&frames, averages.as_ref()),
                self.out.as_deref(),
            )),
        }
    }

    /// Means over time of a run of grains, or of any run if they are asked for.
    fn averages(&self, scene: &Value) -> Result<Option<MeansOverTime>, Failure> {
        if self.average_from.is_none() && scene["body"] != "grains" {
            return Ok(None);
        }
        let of_scene = scene["average_from"].as_f64();
        MeansOverTime::read(&self.source.path, self.average_from, of_scene)
    }

    /// Refuses options that would change nothing.
    fn refuse_idle(&self, forces: KnownForces) -> Result<(), Failure> {
        let is_known = forces != KnownForces::Unknown;
        let idle = [
            (
                "--gap",
                self.gap.is_some() && is_known,
                "are those of the run",
            ),
            (
                "--angle",
                self.angle.is_some() && !is_known,
                "have no forces, so there are no force chains",
            ),
            (
                "--density",
                self.density.is_some() && !is_known,
                "have no forces, so there is no stress",
            ),
        ];
        match idle.into_iter().find(|(_, is_idle, _)| *is_idle) {
            Some((option, _, reason)) => Err(Failure::input(format!(
                "{option} has no effect: the contacts of {} {reason}",
                self.source.path.display()
            ))),
            None => Ok(()),
        }
    }

    fn options(&self) -> MeasureOptions {
        let usual = MeasureOptions::default();
        MeasureOptions {
            gap: self.gap.unwrap_or(usual.gap),
            reach: self.reach,
            bins: self.bins as usize,
            angle: self.angle.map_or(usual.angle, f64::to_radians),
            least_contacts: self.least_contacts,
            slices: self.slices as usize,
            axis: match self.axis {
                Axis::X => 0,
                Axis::Y => 1,
                Axis::Z => 2,
            },
            density: self.density,
        }
    }

    /// All frames, if they are wanted.
    fn frames(&self, options: &MeasureOptions) -> Result<Frames, Failure> {
        if !self.frames {
            return Ok(Frames::default());
        }
        let (steps, states) = self.source.read_all()?;
        let of_scene = states
            .last()
            .and_then(|state| state.scene["average_from"].as_f64());
        let layers = (options.axis, options.slices);
        let layers = LayerProfile::of(&states, layers, self.average_from.or(of_scene));
        let (count, mut done, mut last) = (steps.len(), 0, Instant::now());
        let states = steps.into_iter().zip(states);
        let series = Measures::series(states, options, |step| {
            done += 1;
            if last.elapsed() >= Duration::from_secs(1) {
                last = Instant::now();
                super::note(format_args!("frame {done} of {count}, step {step}"));
            }
        });
        Ok(Frames {
            series: Some(series.map_err(Failure::input)?),
            layers,
        })
    }
}

/// What the frames of a run show.
#[derive(Default)]
struct Frames {
    series: Option<Table>,
    layers: Option<LayerProfile>,
}

/// Writes the tables and figures, and at last the summary.
fn write(
    out: &Path,
    measures: &Measures,
    (frames, averages): (&Frames, Option<&MeansOverTime>),
    summary: &str,
) -> Result<(), Failure> {
    let folder = OutputFolder::begin(out, &Contents::of("measure", &FILES))?;
    let layers = frames.layers.as_ref().map(LayerProfile::table);
    for table in measures
        .tables()
        .iter()
        .chain(&frames.series)
        .chain(&layers)
    {
        let rows = table.rows.iter().map(Vec::as_slice);
        let name = format!("{}.csv", table.name);
        write_series(&out.join(name), table.columns, rows)?;
    }
    for (name, figure) in figures::figures(measures) {
        folder.check()?;
        image::write_both(out, name, &figure)?;
    }
    if let Some(layers) = &frames.layers {
        image::write_both(out, "layers", &figures::layers(layers))?;
    }
    if let Some(table) = &frames.series {
        let drawing = figures::series(table).svg()?;
        write_atomically(&out.join("series.svg"), drawing.as_bytes())?;
    }
    if let Some(averages) = averages {
        folder.write("averages.csv", averages.csv().as_bytes())?;
    }
    Ok(folder.write("measures.json", summary.as_bytes())?)
}

impl From<AssemblyError> for Failure {
    fn from(error: AssemblyError) -> Self {
        Self::input(error)
    }
}
