//! Files with which LAMMPS runs the same system.

use super::build::{TipSystem, build, is_of_tip};
use super::run::TipError;
use super::shape::AtomRole;
use crate::md::atoms::Atoms;
use crate::md::configuration::Configuration;
use crate::md::lammps::data_file;
use crate::md::pair::Shift;
use crate::md::system::Integrator;
use crate::tip::scene::{DriveKind, DrivenHold, StageSteps, ThermostatKind, TipScene};
use nalgebra::Vector3;
pub use tribos_base::exchange::lammps::Export;
use tribos_base::record::number;

/// Room above and below the atoms in the box of the files, in σ.
const ROOM: f64 = 10.0;

/// The start of a scene's run: `tip.data`, with a type for each [`AtomRole`], and `in.tip`.
///
/// ```
/// use tribos::md::lammps::read_data;
/// use tribos::scene::TipScene;
/// use tribos::tip::{build, export::{Export, data, start}};
/// let scene = TipScene {
///     lambda: 0.01,
///     substrate_columns: 8,
///     substrate_rows: 8,
///     substrate_layers: 4,
///     tip_layers: 4,
///     tip_side_atoms: 2,
///     ..TipScene::default()
/// };
/// let files: Export = start(&scene)?;
/// assert!(files.script.contains("read_data tip.data"));
/// // What is read is what Tribos starts from, to the bit.
/// let setup = build(&scene)?.setup;
/// let atoms = read_data(&files.data)?.atoms;
/// assert_eq!(atoms.positions, setup.atoms.positions);
/// assert_eq!(atoms.velocities, setup.atoms.velocities);
/// // The same file from any places, such as those of a later step.
/// assert_eq!(data(&scene, &atoms.positions, &atoms.velocities, &setup.group_of), files.data);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn start(scene: &TipScene) -> Result<Export, TipError> {
    let TipSystem { setup, .. } = build(scene)?;
    let atoms = &setup.atoms;
    Ok(Export {
        name: "tip",
        data: data(scene, &atoms.positions, &atoms.velocities, &setup.group_of),
        script: script(scene),
        notes: Vec::new(),
    })
}

/// Atoms of a scene at given positions as a data file.
pub fn data(
    scene: &TipScene,
    positions: &[Vector3<f64>],
    velocities: &[Vector3<f64>],
    parts: &[u8],
) -> String {
    let heights = || positions.iter().map(|place| place.z);
    let masses = scene.potential.plain_masses();
    let [x, y] = scene.shape().periods();
    data_file(&Configuration {
        atoms: Atoms {
            positions: positions.to_vec(),
            velocities: velocities.to_vec(),
            species: parts.to_vec(),
            masses: AtomRole::ALL
                .map(|part| masses[usize::from(is_of_tip(part))])
                .to_vec(),
        },
        ids: (1..=positions.len() as u64).collect(),
        names: None,
        bounds: [
            [0.0, x],
            [0.0, y],
            [
                heights().fold(f64::INFINITY, f64::min) - ROOM,
                heights().fold(f64::NEG_INFINITY, f64::max) + ROOM,
            ],
        ],
        has_box: true,
        is_periodic: [true, true, false],
        step: 0,
        forces: None,
    })
}

/// The input script.
fn script(scene: &TipScene) -> String {
    let StageSteps {
        before,
        driven,
        after,
    } = scene.stage_steps();
    let units = if scene.potential.is_metal() {
        "metal"
    } else {
        "lj"
    };
    let mut text = format!(
        "# A tip on a substrate: written by tribos export.\n\
         # Types: 1 base, 2 substrate bath, 3 surface, 4 apex, 5 tip bath, 6 driven.\n\
         units {units}\natom_style atomic\nboundary p p f\nread_data tip.data\n\n\
         {}\nneighbor {} bin\nneigh_modify delay 0 every 1 check yes\n\n\
         group base type 1\ngroup driven type 6\ngroup mobile subtract all base\n\n\
         dump start all custom 1 start.dump id type x y z fx fy fz\n\
         dump_modify start sort id format float %.17g\nthermo_style custom step temp pe ke etotal press\n\
         thermo_modify norm no format float %.17g\nthermo {}\nrun 0\nundump start\n\n",
        pair(scene),
        number(scene.skin),
        scene.sample_every
    );
    text += &motion(scene);
    text += &format!("timestep {}\nrun {before}\n\n", number(scene.time_step));
    text += &match scene.drive {
        DriveKind::Torque => {
            format!("{}run {driven}\nunfix torque\nrun {after}\n", drive(scene))
        }
        DriveKind::Slide => {
            "# Here a support begins to pull the driven atoms, for which LAMMPS has no fix.\n"
                .into()
        }
    };
    text
}

/// Embedded atoms of the scene's file. LAMMPS has no closed form of Sutton & Chen: a table of it must
/// be there.
fn embedded(scene: &TipScene, [substrate, tip]: [&str; 2]) -> String {
    let potential = scene.potential.to_string();
    let file = match potential.strip_prefix("eam:") {
        Some(rest) => rest.split(',').next().unwrap_or(rest).to_owned(),
        None => "sutton-chen.eam.alloy".into(),
    };
    let elements = AtomRole::ALL.map(|part| if is_of_tip(part) { tip } else { substrate });
    format!(
        "# The table of the potential; a funcfl table needs pair_style eam and no elements.\n\
         pair_style eam/alloy\npair_coeff * * {file} {}\n",
        elements.join(" ")
    )
}

fn pair(scene: &TipScene) -> String {
    if let Some(elements) = scene.potential.elements() {
        return embedded(scene, elements);
    }
    let cutoff = number(scene.cutoff);
    let (style, shift) = match scene.shift {
        Shift::None => ("lj/cut", "no"),
        Shift::Energy => ("lj/cut", "yes"),
        Shift::Force => ("lj/smooth/linear", ""),
    };
    let mut text = format!("pair_style {style} {cutoff}\n");
    if !shift.is_empty() {
        text += &format!("pair_modify shift {shift}\n");
    }
    text += "pair_coeff * * 1 1\n";
    if scene.adhesion_energy != 1.0 {
        text += &format!("pair_coeff 1*3 4*6 {} 1\n", number(scene.adhesion_energy));
    }
    text
}

/// Integration, thermostats and constraints.
fn motion(scene: &TipScene) -> String {
    let temperature = number(scene.temperature);
    let seed = scene.seed % 900_000_000 + 1;
    let mut text = String::from("group baths type 2 5\ngroup plain subtract mobile baths\n");
    let plain = "fix move mobile nve\n";
    text += &match scene.thermostat {
        // At T = 0 it does nothing here, and LAMMPS refuses it.
        ThermostatKind::NoseHoover if scene.temperature == 0.0 => plain.into(),
        ThermostatKind::NoseHoover => {
            let relaxation = number(scene.thermostat_time);
            let fix = format!("nvt temp {temperature} {temperature} {relaxation} tchain 1");
            format!(
                "# The rotation of the tip's bath counts as heat here: LAMMPS needs the package\n\
                 # EXTRA-COMPUTE for `compute temp/rotate`, which spares it.\n\
                 group tipbath type 5\ngroup subbath type 2\n\
                 fix move1 plain nve\nfix move2 subbath {fix}\nfix move3 tipbath {fix}\n"
            )
        }
        ThermostatKind::Langevin => format!(
            "fix move mobile nve\n\
             fix noise baths langevin {temperature} {temperature} {} {seed}\n",
            number(1.0 / scene.langevin_rate)
        ),
        ThermostatKind::None => plain.into(),
    };
    text += &match scene.driven_constraint {
        DrivenHold::Plane => "fix height driven setforce NULL NULL 0\n".to_owned(),
        DrivenHold::Level => format!(
            "# LAMMPS shares the load and the substrate's push among the driven atoms.\n\
             fix load driven addforce 0 0 {}\nfix level driven aveforce NULL NULL 0\n",
            number(scene.lift())
        ),
    };
    if scene.drive_damping_rate != 0.0 {
        text += &format!(
            "fix damping driven viscous {}\n",
            number(scene.drive_damping_rate)
        );
    }
    if scene.integrator == Integrator::LeapFrog {
        text += "# LAMMPS has velocity Verlet: the same places, velocities half a step on.\n";
    }
    text
}

/// The same angular acceleration for all driven atoms.
fn drive(scene: &TipScene) -> String {
    let sites = scene.shape().sites();
    let drive = super::build::drive(scene, &sites);
    let [x, y] = drive.axis.map(number);
    let a = number(drive.acceleration);
    format!(
        "variable fx atom -{a}*(y-{y})\nvariable fy atom {a}*(x-{x})\n\
         fix torque driven addforce v_fx v_fy 0\n"
    )
}
