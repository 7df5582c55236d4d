//! Measures as a few lines for the person at the terminal.

use super::Frames;
use super::over_time::MeansOverTime;
use crate::command::digits::{shown, with_error};
use std::path::Path;
use tribos::measure::{KnownForces, LayerProfile, Measures};
use tribos::statistics::TimeAverage;

/// The lines.
pub fn text(
    measures: &Measures,
    (frames, averages): (&Frames, Option<&MeansOverTime>),
    out: Option<&Path>,
) -> String {
    let assembly = &measures.assembly;
    let from = match assembly.forces {
        KnownForces::Complete => "with their forces",
        KnownForces::Rounded => "with forces to 0.4 %",
        KnownForces::Normal => "with normal forces only",
        KnownForces::Unknown => "of the geometry, without forces",
    };
    let coordination = &measures.coordination;
    let without = match coordination.mean_without {
        // All of them are rattlers.
        mean if mean.is_nan() => String::new(),
        mean => format!(", {} without them", shown(mean)),
    };
    let mut text = format!(
        "spheres       {}, mean radius {}\n\
         porosity      {} %\n\
         contacts      {} {from}\n\
         coordination  {} a sphere; {} rattlers{}\n\
         fabric        anisotropy {}, largest {} along ({})\n",
        assembly.radii.len(),
        shown(assembly.mean_radius()),
        shown(100.0 * measures.porosity),
        assembly.contacts.len(),
        shown(coordination.mean),
        coordination.rattlers,
        without,
        shown(measures.fabric.anisotropy),
        shown(measures.fabric.values[0]),
        measures
            .fabric
            .direction
            .map(|x| format!("{x:.3}"))
            .as_slice()
            .join(", "),
    );
    text += &loads(measures);
    text += &necks(measures);
    text += &averages.map_or(String::new(), MeansOverTime::text);
    if let Some(table) = &frames.series {
        text += &format!("frames        {}\n", table.rows.len());
    }
    text += &frames.layers.as_ref().map_or(String::new(), layers);
    if let Some(out) = out {
        text += &format!("written to    {}\n", out.display());
    }
    text
}

/// The profile of a flow: middle of each layer, solid fraction, velocity along x and stress across the layers.
fn layers(profile: &LayerProfile) -> String {
    let axis = ["x", "y", "z"][profile.axis];
    let across = profile.axis;
    let mut text = format!(
        "layers from   {:>12}  {:>20}  {:>22}  stress_{axis}{axis}\n",
        format!("middle {axis}"),
        "solid fraction",
        "velocity x"
    );
    for layer in &profile.layers {
        let value = |mean: &TimeAverage| with_error(mean.mean, mean.error);
        let middle = shown(0.5 * (layer.ends[0] + layer.ends[1]));
        let [solid, velocity] = [&layer.solid_fraction, &layer.velocity[0]].map(value);
        let stress = value(&layer.stress[across]);
        text += &format!(
            "{:<13} {middle:>12}  {solid:>20}  {velocity:>22}  {stress}\n",
            ""
        );
    }
    text.replacen("from  ", &format!("from {}", shown(profile.from)), 1)
}

/// Stress, forces and force chains, as far as they are known.
fn loads(measures: &Measures) -> String {
    let mut text = String::new();
    if let Some(stress) = &measures.stress {
        text += &format!(
            "stress        pressure {}, deviator {}; of it motion {}\n",
            shown(stress.pressure()),
            shown(stress.deviator()),
            shown(stress.kinetic.trace() / 3.0),
        );
    }
    if let Some(forces) = &measures.forces {
        let [decay, error] = forces.tail;
        text += &format!(
            "forces        {} push by {} on the mean, {} pull by {}; tail exp(-({decay:.2} +- {error:.2}) f/<f>)\n",
            forces.signs[0],
            shown(forces.mean),
            forces.signs[1],
            shown(forces.mean_pull),
        );
    }
    if let Some(chains) = &measures.chains {
        text += &format!(
            "force chains  {} with {:.2} spheres on the mean, {} at most; {:.1} % of the spheres\n",
            chains.chains.len(),
            chains.mean_length(),
            chains.longest(),
            100.0 * chains.share,
        );
    }
    text
}

/// Levers, where the coefficients are known.
fn necks(measures: &Measures) -> String {
    let necks = &measures.necks;
    if necks.coefficients.is_none() || necks.necks.is_empty() {
        return String::new();
    }
    format!(
        "necks         levers {} of torsion and {} of rolling, radius R_c {}; {} beyond their sphere\n",
        shown(necks.mean(|neck| neck.torsion_lever)),
        shown(necks.mean(|neck| neck.rolling_lever)),
        shown(necks.mean(|neck| neck.radius)),
        necks.beyond,
    )
}
