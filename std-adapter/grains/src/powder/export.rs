//! Files with which LAMMPS runs the same powder, by the pair style `gran/tribos` of `engines/lammps`.

use super::blocked::{LOAD_DEVIATION, PISTON_MOTION, window_time};
use super::deposit::Deposit;
use super::start;
pub use crate::packing::export::ExportError;
use crate::packing::export::{
    LARGEST_FORCE, UNLIKE_WALLS, commands, head, mass, stable_step, volume,
};
use crate::packing::{Kinds, Method, PackingRunError, Springs};
use crate::powder::scene::PowderScene;
use nalgebra::Vector3;
use std::ops::ControlFlow;
pub use tribos_base::exchange::lammps::Export;
use tribos_base::exchange::lammps::{SphereRows, sphere_data_file};
use tribos_base::record::number;
use tribos_contacts::cd::Wall;

/// Room above the piston and below the substrate in the box of the files, in R.
const ROOM: f64 = 2.0;
/// Distance by which neighbour lists reach beyond a contact, in R.
const SKIN: f64 = 0.2;
/// Lines of thermodynamic output in a window.
const LINES: u64 = 4;

/// The start of a scene's run: `powder.data`, the spheres at rest, and `in.powder`, laws, walls and the run until the piston
/// stands.
///
/// ```
/// use tribos::powder::export::{Export, start};
/// use tribos::scene::{ContactMethod, PowderScene};
/// let soft = PowderScene {
///     width: 6.0,
///     height: 8.0,
///     method: ContactMethod::Soft,
///     ..PowderScene::default()
/// };
/// let files: Export = start(&soft)?;
/// assert!(files.data.contains("Atoms # sphere"));
/// assert!(files.script.contains("pair_coeff * * hooke 1000.0 damping 1.0 sliding 0.3"));
/// // Rigid spheres have no springs.
/// assert!(start(&PowderScene { method: ContactMethod::ContactDynamics, ..soft }).is_err());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn start(scene: &PowderScene) -> Result<Export, ExportError> {
    let Method::Soft(springs) = scene.contact_method() else {
        return Err(ExportError::Rigid);
    };
    scene
        .check()
        .map_err(PackingRunError::from)
        .map_err(ExportError::Start)?;
    let (deposit, spheres) =
        start::start(scene, |_| ControlFlow::Continue(())).map_err(ExportError::Start)?;
    let kinds = &spheres.kinds;
    let stable = longest_step(scene, &springs, (&deposit, kinds));
    let (pairs, at_walls) = commands(&scene.mixture(), &springs, kinds, |_| true);
    let at_walls = at_walls.ok_or(ExportError::Beyond {
        key: "mu_second",
        reason: UNLIKE_WALLS,
    })?;
    Ok(Export {
        name: "powder",
        data: data(scene, (&deposit, kinds)),
        script: script(
            scene,
            &deposit,
            [&pairs, &at_walls],
            stable.min(scene.max_time_step),
        ),
        notes: Vec::new(),
    })
}

/// A step that is stable during the whole run.
fn longest_step(
    scene: &PowderScene,
    springs: &Springs,
    (deposit, kinds): (&Deposit, &Kinds),
) -> f64 {
    let area = scene.width * scene.width;
    let pressure = scene.pressure + scene.gravity * mass(&deposit.radii, kinds) / area;
    let piston = Wall::piston(
        -Vector3::z(),
        -deposit.height,
        scene.piston_mass,
        scene.load(),
    );
    stable_step(
        (springs, &scene.mixture()),
        (&deposit.radii, kinds),
        LARGEST_FORCE * pressure,
        &[(piston, area)],
    )
}

/// Volume of the spheres.
fn solid(deposit: &Deposit) -> f64 {
    deposit.radii.iter().map(|radius| volume(*radius)).sum()
}

/// Spheres with their materials as types and their densities as a data file.
fn data(scene: &PowderScene, (deposit, kinds): (&Deposit, &Kinds)) -> String {
    sphere_data_file(&SphereRows {
        bounds: [
            [0.0, scene.width],
            [0.0, scene.width],
            [-ROOM, deposit.height + ROOM],
        ],
        tilt: 0.0,
        positions: &deposit.positions,
        radii: &deposit.radii,
        materials: kinds.mixed(),
        densities: &kinds.densities,
        velocities: None,
        spins: None,
    })
}

/// The input script.
fn script(
    scene: &PowderScene,
    deposit: &Deposit,
    [pairs, walls]: [&str; 2],
    time_step: f64,
) -> String {
    let [run, plugin] = head("powder");
    let window = (window_time(scene.piston_mass, scene.load()) / time_step).ceil() as u64;
    // As long as the run may take here: `max_steps` steps of `max_time_step`, or `duration`.
    let most = scene.max_steps as f64 * scene.max_time_step;
    let most = scene.duration.map_or(most, |duration| duration.min(most));
    let windows = (most / (window as f64 * time_step)).ceil().max(1.0) as u64;
    let weight = if scene.gravity > 0.0 {
        format!(
            "fix weight all gravity {} vector 0 0 -1\n",
            number(scene.gravity)
        )
    } else {
        String::new()
    };
    let [height, load, mass, area, solid, dt, skin, motion, deviation] = [
        deposit.height,
        scene.load(),
        scene.piston_mass,
        scene.width * scene.width,
        solid(deposit),
        time_step,
        SKIN,
        PISTON_MOTION,
        LOAD_DEVIATION,
    ]
    .map(number);
    format!(
        "# A powder under a piston, written by `tribos export lammps`. The run ends when the piston stands under its load, and\n\
         # writes porosity.txt, powder.restart and the spheres at the end as end.dump.\n\
         {run}\n\
         #\n\
         # Units: lengths in R, the mean radius; forces in F_coh, the cohesion; densities in rho, that of the spheres;\n\
         # times in sqrt(rho R^4/F_coh).\n\n\
         {plugin}\
         shell rm -f porosity.txt\n\n\
         units lj\natom_style sphere\ncomm_modify vel yes\nboundary p p f\n\
         # The spheres at rest.\n\
         read_data powder.data\n\n\
         # Springs, dashpots, thresholds of friction over P = F_n + F_coh, cohesion and the gap that it spans.\n\
         # LAMMPS does not know the style gran/tribos unless the plugin is loaded.\n\
         pair_style gran/tribos\n{pairs}\
         neighbor {skin} bin\nneigh_modify delay 0 every 1 check yes\ntimestep {dt}\n\n\
         fix move all nve/sphere\n{weight}\
         # Wall 1 is the substrate, wall 2 the piston with its load and its mass.\n\
         fix walls all wall/gran/tribos {walls} zlo 0 zhi {height} piston {load} {mass}\n\n\
         # Kinetic energy; height and velocity of the piston, the force of the spheres on it; porosity below it.\n\
         variable porosity equal 1-{solid}/({area}*f_walls[2][1])\n\
         variable push equal f_walls[2][5]\n\
         fix mean all ave/time 1 {window} {window} v_push\n\
         thermo {lines}\n\
         thermo_style custom step time ke f_walls[2][1] f_walls[2][2] f_walls[2][5] v_porosity\n\n\
         # Windows of a run until the piston moves less than {motion} in one and bears its load of {load} in the mean\n\
         # within {deviation} of it.\n\
         variable window loop {windows}\n\
         label next\n\
         variable before equal $(f_walls[2][1])\n\
         run {window}\n\
         variable moved equal abs(f_walls[2][1]-v_before)\n\
         variable error equal abs(f_mean/{load}-1)\n\
         if \"${{moved}} < {motion} && ${{error}} < {deviation}\" then \"jump SELF end\"\n\
         next window\n\
         jump SELF next\n\
         print \"not blocked within the time of the scene: the piston still moves\"\n\
         label end\n\
         print \"${{porosity}}\" file porosity.txt\n\
         write_restart powder.restart\n\
         write_dump all custom end.dump id type radius x y z vx vy vz modify sort id format float %.17g\n",
        lines = (window / LINES).max(1),
    )
}
