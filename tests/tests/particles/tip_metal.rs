//! Tips of metals: forces as LAMMPS computes them, faces of the crystal, units.

use nalgebra::Vector3;
use std::path::Path;
use tribos::md::interaction::{Evaluation, evaluate};
use tribos::md::neighbours::VerletList;
use tribos::scene::TipScene;
use tribos::space::PeriodicBox;
use tribos::tip::{TipPotential, TipSimulation, build};
use tribos_tests::atoms::{data, path, text};
use tribos_tests::tables::Table;
use tribos_tests::tips::{scene, to_the_end};

type Error = Box<dyn std::error::Error>;

/// A small tip at rest on a small substrate.
const SMALL: &str = "body = \"tip\"\nlambda = 0\nsubstrate_columns = 8\nsubstrate_rows = 8\nsubstrate_layers = 4\n\
                     tip_layers = 4\ntip_side_atoms = 2\ntemperature = 300\ntime_step = 0.004\nskin = 0.5\n\
                     equilibration = 0.2\ndrive_time = 0\nrest_time = 0\n";

fn small(text: &str) -> Result<TipScene, Error> {
    scene(&format!("{SMALL}{text}"))
}

/// A tip of one element on a substrate of another, (111) on (100), turned.
fn alloy() -> Result<TipScene, Error> {
    small(&format!(
        "potential = \"eam:{},substrate=Aa,tip=Bb\"\nface = \"fcc100\"\ntip_orientation = 15",
        path("synthetic.eam.alloy").display()
    ))
}

/// Copper, (110) on (110), in a potential of one element.
fn copper(potential: &str) -> Result<TipScene, Error> {
    small(&format!(
        "potential = \"{potential}\"\nface = \"fcc110\"\ntip_face = \"fcc110\""
    ))
}

/// Forces of a scene's potential on the atoms of `NAME.data`, and the energy.
fn computed(scene: &TipScene, name: &str) -> Result<(Vec<Vector3<f64>>, f64), Error> {
    let all = data(name, [true, true, false]);
    let setup = build(scene)?.setup;
    let mut list = VerletList::new(all.space()?, scene.reach(), 0.5)?;
    let mut atoms = setup.atoms.clone();
    assert_eq!(atoms.len(), all.atoms.len());
    // The file has a species for each part: the first three are the substrate's.
    for (number, &id) in all.ids.iter().enumerate() {
        let atom = id as usize - 1;
        atoms.positions[atom] = all.atoms.positions[number];
        let is_of_tip = all.atoms.species[number] >= 3;
        let sites = [0, atoms.masses.len() as u8 - 1];
        assert_eq!(atoms.species[atom], sites[usize::from(is_of_tip)]);
    }
    let mut forces = Vec::new();
    let tally = evaluate(
        &setup.interaction,
        &mut list,
        &atoms,
        &mut forces,
        Evaluation::Sums,
    )?;
    Ok((forces, tally.energy))
}

/// Largest deviation from the table, in parts of its largest force.
fn deviation(name: &str, forces: &[Vector3<f64>]) -> f64 {
    let table = Table::read(&format!("md/{name}.csv"));
    let expected: Vec<Vector3<f64>> = table
        .rows()
        .map(|row| ["fx", "fy", "fz"].map(|axis| row.number(axis)).into())
        .collect();
    assert_eq!(expected.len(), forces.len());
    let largest = expected.iter().map(Vector3::norm).fold(0.0, f64::max);
    assert!(largest > 0.1, "{largest}");
    let off = expected.iter().zip(forces).map(|(a, b)| (a - b).norm());
    off.fold(0.0, f64::max) / largest
}

/// The energy in the head of a table.
fn energy(name: &str) -> Option<f64> {
    let text = text(&format!("{name}.csv"));
    let (_, rest) = text.split_once("energy ")?;
    rest.split_whitespace().next()?.parse().ok()
}

#[test]
fn forces_of_a_tip_of_another_element_are_those_of_lammps() -> Result<(), Error> {
    let (forces, sum) = computed(&alloy()?, "tip_alloy")?;
    let off = deviation("tip_alloy", &forces);
    assert!(off < 1e-12, "{off:.1e}");
    let expected = energy("tip_alloy").ok_or("no energy")?;
    assert!((sum / expected - 1.0).abs() < 1e-12, "{sum} {expected}");
    Ok(())
}

/// Copper of Sutton & Chen as a table, by the formulas of tables/md/make_tips.py.
fn copper_table() -> String {
    const EPSILON: f64 = 1.2382e-2;
    const A: f64 = 3.61;
    const C: f64 = 39.432;
    const KNOTS: u32 = 1000;
    let (cutoff, start) = (1.8 * A, 1.6 * A);
    let taper = |r: f64| match (r - start) / (cutoff - start) {
        x if x <= 0.0 => 1.0,
        x if x >= 1.0 => 0.0,
        x => (1.0 - x) * (1.0 - x) * (1.0 - x) * (1.0 + 3.0 * x + 6.0 * x * x),
    };
    let power = |x: f64, k: usize| std::iter::repeat_n(x, k).fold(1.0, |product, x| product * x);
    let steps = f64::from(KNOTS - 1);
    let (dr, drho) = (cutoff / steps, 400.0 / steps);
    let distances = || (0..KNOTS).map(|k| (f64::from(k) * dr).max(1.0));
    let densities = (0..KNOTS).map(|k| -EPSILON * C * (f64::from(k) * drho).sqrt());
    let mut text = format!(
        "Sutton and Chen\n1990\n\n1 Cu\n{KNOTS} {drho:?} {KNOTS} {dr:?} {cutoff:?}\n29 63.546 3.61 fcc\n"
    );
    let own = distances().map(|r| power(A / r, 6) * taper(r));
    let pairs = distances().map(|r| r * (EPSILON * power(A / r, 9)) * taper(r));
    for value in densities.chain(own).chain(pairs) {
        text += &format!("{value:?}\n");
    }
    text
}

#[test]
fn forces_of_a_copper_tip_are_those_of_lammps_and_near_the_closed_form() -> Result<(), Error> {
    let file = Path::new(env!("CARGO_TARGET_TMPDIR")).join("copper.eam.alloy");
    std::fs::write(&file, copper_table())?;
    let tabulated = copper(&format!("eam:{}", file.display()))?;
    let (forces, sum) = computed(&tabulated, "tip_copper")?;
    let off = deviation("tip_copper", &forces);
    assert!(off < 1e-12, "{off:.1e}");
    let expected = energy("tip_copper").ok_or("no energy")?;
    assert!((sum / expected - 1.0).abs() < 1e-12, "{sum} {expected}");
    // The closed form differs by the error of the splines.
    let (closed, _) = computed(&copper("sutton-chen:Cu")?, "tip_copper")?;
    let off = deviation("tip_copper", &closed);
    assert!(off < 1e-5, "{off:.1e}");
    let spacings = [
        tabulated.spacings()[0],
        copper("sutton-chen:Cu")?.spacings()[0],
    ];
    assert!((spacings[0] - spacings[1]).abs() < 1e-6, "{spacings:?}");
    Ok(())
}

/// Number of neighbours of an atom at the distance of nearest ones, and the least distance of all.
fn neighbours(scene: &TipScene, atom: usize) -> Result<(usize, f64), Error> {
    let shape = scene.shape();
    let sites = shape.sites();
    let [x, y] = shape.periods();
    let space = PeriodicBox::new([Some(x), Some(y), None])?;
    let others = (0..sites.len()).filter(|&other| other != atom);
    let distances: Vec<f64> = others
        .map(|other| {
            space
                .displacement(&sites[other].place, &sites[atom].place)
                .norm()
        })
        .collect();
    let near = distances
        .iter()
        .filter(|&&r| r < 1.2 * shape.spacing)
        .count();
    Ok((near, distances.into_iter().fold(f64::INFINITY, f64::min)))
}

#[test]
fn each_face_is_one_of_the_face_centred_cubic_crystal() -> Result<(), Error> {
    for face in ["fcc111", "fcc100", "fcc110"] {
        for columns in [9, 10] {
            let scene = scene(&format!(
                "body = \"tip\"\nlambda = 0\nface = \"{face}\"\ntip_face = \"{face}\"\nspacing = 1.1\n\
                 substrate_columns = {columns}\nsubstrate_rows = 10\nsubstrate_layers = 7\ntip_layers = 7\ntip_side_atoms = 3"
            ))?;
            let shape = scene.shape();
            let sites = shape.sites();
            assert!(shape.is_one_crystal());
            let [x, y] = shape.axis();
            for (atom, site) in sites.iter().enumerate() {
                let (near, least) = neighbours(&scene, atom)?;
                assert!((least / 1.1 - 1.0).abs() < 1e-12, "{face} {least}");
                // Inner atoms of the substrate, and those on the axis of the tip, have all twelve.
                let from_axis = (site.place.x - x).hypot(site.place.y - y);
                let is_inner = (2..5).contains(&site.layer)
                    || ((7..11).contains(&site.layer) && from_axis < 0.2);
                assert!(
                    !is_inner || near == 12,
                    "{face}: {near} in layer {}",
                    site.layer
                );
                assert!(near <= 12);
            }
            // A volume of d³/√2 for each atom.
            let [x, y] = shape.periods();
            let volume = x * y * shape.layer_distance() / (columns * 10) as f64;
            assert!(
                (volume * 2.0_f64.sqrt() / 1.1_f64.powi(3) - 1.0).abs() < 1e-12,
                "{face}"
            );
        }
    }
    Ok(())
}

#[test]
fn other_faces_and_turned_tips_touch_nothing_too_closely() -> Result<(), Error> {
    for face in ["fcc111", "fcc100", "fcc110"] {
        for tip_face in ["fcc111", "fcc100", "fcc110"] {
            for orientation in [0, 17, 45, 90] {
                for outline in ["hexagon", "disk", "cone"] {
                    let scene = scene(&format!(
                        "body = \"tip\"\nlambda = 0\nface = \"{face}\"\ntip_face = \"{tip_face}\"\n\
                         tip_orientation = {orientation}\noutline = \"{outline}\"\nsubstrate_columns = 10\nsubstrate_rows = 10\n\
                         substrate_layers = 4\ntip_layers = 4\ntip_side_atoms = 3"
                    ))?;
                    let sites = scene.shape().sites();
                    let tip = sites
                        .iter()
                        .position(|site| site.layer == 4)
                        .ok_or("no tip")?;
                    for (atom, site) in sites.iter().enumerate().skip(tip) {
                        let (_, least) = neighbours(&scene, atom)?;
                        let is_low = site.layer == 4;
                        // (111) layers keep their distance however they are turned.
                        let closest = if is_low { 0.81 } else { 0.999 };
                        assert!(least > closest * scene.spacing, "{face} {tip_face} {least}");
                    }
                }
            }
        }
    }
    Ok(())
}

#[test]
fn a_metal_is_held_at_its_temperature_in_kelvin() -> Result<(), Error> {
    let scene = TipScene {
        equilibration: 4.0,
        ..copper("sutton-chen:Cu")?
    };
    let mut run = TipSimulation::new(&scene)?;
    to_the_end(&mut run)?;
    let start = run.outcome().start;
    for heat in start.temperature {
        // Some hundred freedoms: a tenth of scatter at a moment, less in the mean.
        assert!((heat / 300.0 - 1.0).abs() < 0.25, "{start:?}");
    }
    // 63.546 u in eV ps²/Å².
    let mass = run.system().atoms().masses[0];
    assert!(
        (mass / (63.546 * 1.036_426_9e-4) - 1.0).abs() < 1e-7,
        "{mass}"
    );
    Ok(())
}

#[test]
fn what_a_metal_has_itself_is_refused_as_a_key() {
    for (text, words) in [
        (
            "potential = \"sutton-chen:Fe\"",
            "`potential`: no parameters for \"Fe\"",
        ),
        (
            "potential = \"eam:nowhere.eam\"",
            "`potential`: nowhere.eam: ",
        ),
        (
            "potential = \"eam\"",
            "`potential`: must be \"lennard-jones\"",
        ),
        (
            "potential = \"morse\"",
            "`potential`: must be \"lennard-jones\"",
        ),
        (
            "potential = \"sutton-chen:Cu\"\nspacing = 2.7",
            "`spacing` is for \"lennard-jones\" only",
        ),
        (
            "potential = \"sutton-chen:Cu\"\ncutoff = 5",
            "`cutoff` is for \"lennard-jones\" only",
        ),
        (
            "potential = \"sutton-chen:Cu\"\nadhesion_energy = 0.5",
            "`adhesion_energy` is for",
        ),
        (
            "potential = \"sutton-chen:Cu\"\nshift = \"force\"",
            "`shift` is for",
        ),
        (
            "lattice_expansion = 0.01",
            "`lattice_expansion` is for metals only",
        ),
        (
            "face = \"fcc211\"",
            "one of \"fcc111\", \"fcc100\", \"fcc110\"",
        ),
    ] {
        match small(text) {
            Err(error) => assert!(error.to_string().contains(words), "{text}: {error}"),
            Ok(_) => assert_eq!(text, "", "it was not refused"),
        }
    }
    let file = path("synthetic.eam.alloy");
    assert!(Path::new(&file).exists());
    let missing = format!("eam:{},tip=Cc", file.display()).parse::<TipPotential>();
    assert!(missing.is_err_and(|error| error.to_string().contains("no element `Cc`")));
}

#[test]
fn a_scene_of_a_metal_comes_back_from_what_it_says() -> Result<(), Error> {
    let scene = copper("sutton-chen:Cu")?;
    let json = scene.json();
    assert_eq!(json["potential"], "sutton-chen:Cu");
    let spacing = json["spacing"].as_f64().ok_or("no spacing")?;
    assert_eq!(spacing, scene.spacings()[0]);
    let again = TipScene {
        spacing,
        cutoff: json["cutoff"].as_f64().ok_or("no cut-off")?,
        ..scene.clone()
    };
    again.check()?;
    assert_eq!(again.json(), json);
    Ok(())
}
