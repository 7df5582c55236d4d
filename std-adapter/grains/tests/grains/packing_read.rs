use nalgebra::Vector3;
use std::ops::ControlFlow;
use tribos_base::random::Random;
use tribos_base::record::frames::{Bodies, Frame, FrameFolder};
use tribos_base::record::trajectory::{Format, State, Trajectory};
use tribos_base::record::{Snapshot, extended_xyz, particles_vtp};
use tribos_base::run::{LongRun, Simulation};
use tribos_base::scene::SceneError;
use tribos_base::space::PeriodicBox;
use tribos_grains::gas::GasSimulation;
use tribos_grains::grains::GrainsSimulation;
use tribos_grains::packing::assembly::{Assembly, KnownForces};
use tribos_grains::powder::{self, PowderSimulation};
use tribos_grains::scene::ContactMethod;
use tribos_grains::scene::GasScene;
use tribos_grains::scene::GrainsScene;
use tribos_grains::scene::PowderScene;

/// Places, velocities, spins and radii with all their bits in use.
fn cloud(count: usize) -> ([Vec<Vector3<f64>>; 3], Vec<f64>) {
    let mut random = Random::new(5, 0);
    let mut some = |scale: f64, shift: f64| -> Vec<Vector3<f64>> {
        (0..count)
            .map(|_| Vector3::from_fn(|_, _| scale * (random.unit() - shift)))
            .collect()
    };
    let vectors = [some(9.0, 0.0), some(1e-3, 0.5), some(7.0, 0.5)];
    (
        vectors,
        (0..count).map(|_| 0.1 + 0.2 * random.unit()).collect(),
    )
}

fn refusal(name: &str, text: &str) -> String {
    Assembly::parse(name, text).map_or_else(|error| error.to_string(), |_| "read".into())
}

#[test]
fn exports_of_our_own_come_back_to_the_bit() {
    let ([places, velocities, spins], radii) = cloud(50);
    let space = PeriodicBox::new([Some(9.0), Some(9.5), None]).unwrap();
    let state = Snapshot {
        time: 0.3,
        space,
        extents: [[0.0, 9.0], [0.0, 9.5], [-1.0, 12.0]],
        positions: &places,
        radii: &radii,
        velocities: Some(&velocities),
        spins: Some(&spins),
        species: None,
        materials: None,
        densities: None,
        contacts: &[],
    };
    for (name, text) in [
        ("a.xyz", extended_xyz(&state).unwrap()),
        ("a.vtp", particles_vtp(&state).unwrap()),
    ] {
        let read = Assembly::parse(name, &text).unwrap();
        assert_eq!(read.positions, places, "{name}");
        assert_eq!(read.radii, radii, "{name}");
        assert_eq!(read.velocities.as_ref(), Some(&velocities), "{name}");
        assert_eq!(read.spins.as_ref(), Some(&spins), "{name}");
        assert_eq!(read.forces, KnownForces::Unknown);
        assert_eq!(read.space, space);
        assert_eq!(read.bounds, state.extents);
        let periodic = read
            .with_periods(name, [Some(9.0), Some(9.5), None])
            .unwrap();
        assert_eq!(periodic.space, space);
        for (x, reason) in [
            (Some(8.0), "its period along x is 9, not 8"),
            (
                None,
                "it says that it repeats along x after 9; give 9 in place of -",
            ),
        ] {
            let other = periodic.clone().with_periods(name, [x, Some(9.5), None]);
            let other = other.map(|_| ()).map_err(|error| error.to_string());
            assert_eq!(other, Err(format!("{name}: {reason}")));
        }
    }
}

#[test]
fn files_of_lammps_give_radii_from_diameters_in_a_box_from_zero() {
    let data = "grains\n\n2 atoms\n1 atom types\n-1 9 xlo xhi\n0 10 ylo yhi\n0 10 zlo zhi\n\n\
                Atoms # sphere\n\n1 1 0.5 2600 0 1 2\n2 1 1.5 2600 9 1 2 0 0 1\n\n\
                Velocities\n\n2 0 0 -1 7 8 9\n1 1 2 3 4 5 6\n";
    let read = Assembly::parse("g.data", data).unwrap();
    assert_eq!(read.radii, [0.25, 0.75]);
    assert_eq!(
        read.positions,
        [Vector3::new(1.0, 1.0, 2.0), Vector3::new(10.0, 1.0, 12.0)]
    );
    assert_eq!(read.velocities.unwrap()[0], Vector3::new(1.0, 2.0, 3.0));
    assert_eq!(read.spins.unwrap()[1], Vector3::new(7.0, 8.0, 9.0));
    assert_eq!(read.space.lengths(), [Some(10.0); 3]);
    assert_eq!(read.densities, Some(vec![2600.0; 2]));
    // Data do not say which axes repeat.
    let open = Assembly::parse("g.data", data).unwrap();
    let open = open.with_periods("g.data", [Some(10.0), Some(10.0), None]);
    assert_eq!(
        open.unwrap().space.lengths(),
        [Some(10.0), Some(10.0), None]
    );

    let frame = |x: f64| {
        format!(
            "ITEM: TIMESTEP\n7\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS pp ff ff\n0 4\n0 4\n-2 9\n\
             ITEM: ATOMS id type diameter x y z omegax omegay omegaz\n3 1 0.5 {x} 1 1 4 5 6\n"
        )
    };
    let read = Assembly::parse("g.dump", &(frame(1.0) + &frame(2.0))).unwrap();
    assert_eq!((read.radii[0], read.positions[0].x), (0.25, 2.0)); // the last frame
    assert_eq!(read.spins.unwrap()[0], Vector3::new(4.0, 5.0, 6.0));
    assert_eq!(read.space.lengths(), [Some(4.0), None, None]);
    assert_eq!(read.bounds, [[0.0, 4.0], [0.0, 4.0], [-2.0, 9.0]]);
}

#[test]
fn arrays_as_text_and_in_single_precision_are_read() {
    let file = |format: &str, points: &str, radii: &str| {
        format!(
            "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" byte_order=\"LittleEndian\">\n<PolyData>\n\
             <Piece NumberOfPoints=\"2\">\n<PointData Scalars=\"radius\">\n\
             <DataArray type=\"Float32\" Name=\"radius\" {format}>\n{radii}\n</DataArray>\n</PointData>\n\
             <Points>\n<DataArray type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\" format=\"ascii\">\n\
             {points}\n</DataArray>\n</Points>\n</Piece>\n</PolyData>\n</VTKFile>\n"
        )
    };
    let points = "0 0 0\n 2 0.5 0";
    let read = Assembly::parse("a.vtp", &file("format=\"ascii\"", points, "1 0.5")).unwrap();
    assert_eq!(read.positions[1], Vector3::new(2.0, 0.5, 0.0));
    assert_eq!(read.radii, [1.0, 0.5]);
    // 8, 0, 0, 0 as the length in 32 bits; then 1.0 and 0.5 as f32.
    let read = Assembly::parse(
        "a.vtp",
        &file("format=\"binary\"", points, "CAAAAAAAgD8AAAA/"),
    )
    .unwrap();
    assert_eq!(read.radii, [1.0, 0.5]);
    for (text, reason) in [
        (
            file("format=\"ascii\"", points, "1"),
            "a.vtp: 2 points need as many values of radius, not 1",
        ),
        (
            file("format=\"ascii\"", points, "1 -1"),
            "a.vtp: point 1: the radius must be a finite number > 0, not -1",
        ),
        (
            file("format=\"binary\"", points, "CAAAAAAAgD8="),
            "a.vtp: the array radius is damaged",
        ),
        (
            file("format=\"appended\" offset=\"0\"", points, ""),
            "a.vtp: the array radius is damaged",
        ),
        ("<html></html>".into(), "a.vtp: it is no VTK file"),
    ] {
        assert_eq!(refusal("a.vtp", &text), reason);
    }
}

#[test]
fn files_without_radii_tilted_or_cut_are_refused_by_line() {
    let head = "1\nLattice=\"4 0 0 0 4 0 0 0 4\" Properties=species:S:1:pos:R:3";
    for (text, reason) in [
        (format!("{head}\nX 1 1 1\n"), "f: line 2: there are no radii; give a column radius:R:1, or one radius of all by --columns radius=all:VALUE (key `columns`)"),
        (format!("{head}:radius:R:1\nX 1 1 1 0\n"), "f: line 3: the size of a sphere must be a number > 0, not `0`"),
        (format!("{head}:radius:R:1\nX 1 1 1 0,5\n"), "f: line 3: the size of a sphere must be a finite number (write a decimal point: 0.5), not `0,5`"),
        (
            "1\nLattice=\"4 0 0 1 4 0 0 0 4\" Properties=species:S:1:pos:R:3:radius:R:1\nX 1 1 1 1\n".into(),
            "f: line 2: Lattice must be of an orthogonal cell, or one that leans along x over z, `LX 0 0 0 LY 0 XZ 0 LZ` \
             with lengths > 0, not `4 0 0 1 4 0 0 0 4`",
        ),
        (
            "t\n\n1 atoms\n1 atom types\n0 4 xlo xhi\n0 4 ylo yhi\n0 4 zlo zhi\n\nAtoms # atomic\n\n1 1 1 1 1\n".into(),
            "f: line 9: the atom style `atomic` cannot be read; write the file with atom_style sphere",
        ),
        (
            "t\n\n1 atoms\n1 atom types\n0 4 xlo xhi\n0 4 ylo yhi\n0 4 zlo zhi\n\nAtoms\n\n1 1 1 1 1\n".into(),
            "f: line 11: a line of Atoms must be ID TYPE DIAMETER DENSITY X Y Z, and three image flags or none \
             (atom_style sphere), not `1 1 1 1 1`",
        ),
        (
            "ITEM: TIMESTEP\n7\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS pp ff ff\n0 4\n0 4\n0 9\n\
             ITEM: ATOMS id type x y z\n3 1 1 1 1\n".into(),
            "f: line 9: there are no radii; dump the column radius or diameter, or one radius of all by --columns \
             radius=all:VALUE (key `columns`)",
        ),
        ("{\"tribos_state\":1}".into(), "f: it is damaged (its digest is not that of its bytes); give a state or a checkpoint of a powder or of \
             grains"),
    ] {
        assert_eq!(refusal("f", &text), reason);
    }
}

/// A scene of spheres.
enum Scene {
    Grains(Box<GrainsScene>),
    Powder(Box<PowderScene>),
    Gas(GasScene),
}

impl Scene {
    fn parse(name: &str, text: &str) -> Result<Self, SceneError> {
        let powder = PowderScene::parse(name, text, &[])
            .map(Box::new)
            .map(Self::Powder);
        let gas = || GasScene::parse(name, text, &[]).map(Self::Gas);
        let grains = || {
            GrainsScene::parse(name, text, &[])
                .map(Box::new)
                .map(Self::Grains)
        };
        powder.or_else(|_| gas()).or_else(|_| grains())
    }
}

/// Some bodies of each kind, with several sizes, materials and densities, after some steps.
fn bodies() -> Vec<(&'static str, Scene)> {
    let grains = "body = \"grains\"\nwidth = 0.08\nradius = 0.005\ncount = 30\nduration = 1\ndensity = 2500\n\
                  second_fraction = 0.4\nsecond_radius = 0.7\nsecond_density = 7800\nmu_second = 0.2\n";
    let scene = |name: &'static str, text: &str| {
        let scene = Scene::parse(name, text);
        (
            name,
            scene.unwrap_or_else(|error| panic!("{name}: {error}")),
        )
    };
    let of = |name, more: &str| scene(name, &format!("{grains}{more}"));
    vec![
        of("bed", ""),
        of("column", "boundary_x = \"walls\"\nboundary_y = \"walls\"\n"),
        of("flat", "dimension = 2\n"),
        of(
            "plates",
            "boundary_z = \"walls\"\ngravity = 0\nwall_stress_z = 1000\nlid_speed_x = 0.1\n",
        ),
        of(
            "hopper",
            "boundary_x = \"walls\"\ncontainer = \"hopper\"\norifice_width = 0.03\norifice_height = 0.02\n",
        ),
        of("drum", "container = \"drum\"\ndepth = 0.03\n"),
        of(
            "cell",
            "boundary_z = \"periodic\"\nheight = 0.08\ngravity = 0\n",
        ),
        of(
            "sheared",
            "boundary_z = \"periodic\"\nheight = 0.08\ngravity = 0\nshear_rate = 2\n",
        ),
        scene(
            "powder",
            "body = \"powder\"\nwidth = 8\nheight = 10\npressure = 0.02\nradius_spread = 0.2\n\
             second_fraction = 0.3\nsecond_density = 2\nmu_second = 0.1\n",
        ),
        scene("gas", "body = \"gas\"\ncount = 60\n"),
    ]
}

/// What no file may lose.
#[derive(Clone, Debug, PartialEq)]
struct ReadPacking {
    positions: Vec<Vector3<f64>>,
    radii: Vec<f64>,
    densities: Option<Vec<f64>>,
    materials: Option<Vec<u8>>,
    periods: [Option<f64>; 3],
    tilt: f64,
}

impl ReadPacking {
    fn of(read: &Assembly) -> Self {
        Self {
            positions: read.positions.iter().map(|x| read.space.wrap(x)).collect(),
            radii: read.radii.clone(),
            densities: read.densities.clone(),
            materials: read.materials.clone(),
            periods: read.space.lengths(),
            tilt: read.space.offset(),
        }
    }

    /// The same, with places as near as `share` of the cell, and boxes to rounding.
    #[track_caller]
    fn assert_is(&self, other: &Self, share: f64, what: &str) {
        assert_eq!(self.radii, other.radii, "{what}");
        assert_eq!(self.densities, other.densities, "{what}");
        assert_eq!(self.materials, other.materials, "{what}");
        let ulps = |a: f64, b: f64| (a - b).abs() <= 4.0 * f64::EPSILON * a.abs();
        // The cell along periodic axes, the reach of the spheres along open ones.
        let reaches = self.positions.iter().map(Vector3::amax);
        let mut size = reaches.fold(0.0, f64::max);
        for (mine, theirs) in self.periods.iter().zip(other.periods) {
            assert_eq!(mine.is_some(), theirs.is_some(), "{what}");
            let pair = mine.zip(theirs);
            assert!(pair.is_none_or(|(a, b)| ulps(a, b)), "{what}");
            size = size.max(mine.unwrap_or(0.0));
        }
        // A tilt is the same after a whole period.
        if let Some(length) = self.periods[0] {
            let apart = (self.tilt - other.tilt) / length;
            assert!((apart - apart.round()).abs() < 1e-15 * 8.0, "{what}");
        }
        let space = PeriodicBox::new(self.periods).unwrap().sheared(self.tilt);
        for (mine, theirs) in self.positions.iter().zip(&other.positions) {
            let way = space.displacement(mine, theirs);
            assert!(way.amax() <= share * size, "{what}: {way:?}");
        }
        assert_eq!(self.positions.len(), other.positions.len(), "{what}");
    }
}

/// The spheres as a file again.
fn again(read: &Assembly) -> Assembly {
    let text = extended_xyz(&Snapshot {
        time: 0.0,
        space: read.space,
        extents: read.bounds,
        positions: &read.positions,
        radii: &read.radii,
        velocities: read.velocities.as_deref(),
        spins: read.spins.as_deref(),
        species: None,
        materials: read.materials.as_deref(),
        densities: read.densities.as_deref(),
        contacts: &[],
    });
    Assembly::parse("again.xyz", &text.unwrap()).unwrap()
}

/// A run after some steps: its exports, its frames, and the files that only spheres with contacts have.
fn exports(scene: &Scene) -> (ReadPacking, Vec<(&'static str, String)>, Bodies, Frame) {
    fn all<R: LongRun>(
        scene: &R::Scene,
        show: impl Fn(&R, &mut dyn FnMut(&Snapshot<'_>)),
        state: Option<fn(&R) -> String>,
    ) -> (ReadPacking, Vec<(&'static str, String)>, Bodies, Frame) {
        let mut run = R::begin(scene, None, &mut |_| ControlFlow::Continue(())).unwrap();
        for _ in 0..30 {
            run.step().unwrap();
        }
        let (mut kept, mut texts) = (None, Vec::new());
        show(&run, &mut |now| {
            kept = Some(ReadPacking {
                positions: now.positions.iter().map(|x| now.space.wrap(x)).collect(),
                radii: now.radii.to_vec(),
                densities: now.densities.map(<[f64]>::to_vec),
                materials: now.materials.map(<[u8]>::to_vec),
                periods: now.space.lengths(),
                tilt: now.space.offset(),
            });
            texts.push(("a.xyz", extended_xyz(now).unwrap()));
            texts.push(("a.vtp", particles_vtp(now).unwrap()));
        });
        if let Some(state) = state {
            texts.push(("state", state(&run)));
            texts.push(("checkpoint", run.checkpoint()));
        }
        (kept.unwrap(), texts, run.bodies(9), run.frame())
    }
    match scene {
        Scene::Grains(scene) => all::<GrainsSimulation>(
            scene,
            |run, show| run.with_snapshot(show),
            Some(GrainsSimulation::state),
        ),
        Scene::Powder(scene) => all::<PowderSimulation>(
            scene,
            |run, show| run.with_snapshot(show),
            Some(PowderSimulation::state),
        ),
        Scene::Gas(scene) => {
            all::<GasSimulation>(scene, |run, show| run.with_snapshot(show).unwrap(), None)
        }
    }
}

#[test]
fn a_checkpoint_of_another_body_is_named_as_what_it_is() {
    for method in ["events", "contact-dynamics", "soft"] {
        let text = format!("body = \"gas\"\ncount = 60\nmethod = \"{method}\"\n");
        let scene = GasScene::parse("gas", &text, &[]).unwrap();
        let kept = GasSimulation::new(&scene).unwrap().checkpoint();
        let said = "f: it is a checkpoint of body = \"gas\", without a state of forces; \
                    give a state or a checkpoint of a powder or of grains";
        assert_eq!(refusal("f", &kept), said, "{method}");
        let other = PowderScene::default();
        let refused = PowderSimulation::resume(&other, &kept).map_err(|error| error.to_string());
        let said = "the checkpoint belongs to another scene: `body` is \"gas\" there and \"powder\" here; \
                    change it back, or start anew with --anew";
        assert_eq!(refused.err().as_deref(), Some(said), "{method}");
    }
}

#[test]
fn no_format_loses_a_radius_a_density_a_material_a_period_or_the_tilt() {
    for (body, scene) in bodies() {
        let (run, texts, bodies, frame) = exports(&scene);
        // A film begins with its first step.
        let frame = Frame { step: 0, ..frame };
        assert_eq!(run.materials.is_some(), body != "gas", "{body}");
        assert_eq!(run.tilt != 0.0, body == "sheared", "{body}");
        let texts_of_state = texts.iter().find(|(format, _)| *format == "state");
        let texts_of_state = texts_of_state.map_or(String::new(), |(_, text)| text.clone());
        for (format, text) in texts {
            let what = format!("{body}, {format}");
            let read = Assembly::parse(format, &text).unwrap();
            ReadPacking::of(&read).assert_is(&run, 0.0, &what);
            ReadPacking::of(&again(&read)).assert_is(&run, 0.0, &what);
            // The folder of a gas has the spheres of its end in no other form.
            if (body, format) == ("gas", "a.xyz") {
                let home = tempfile::tempdir().unwrap();
                std::fs::write(home.path().join("final.xyz"), &text).unwrap();
                ReadPacking::of(&Assembly::read(home.path()).unwrap())
                    .assert_is(&run, 0.0, "a folder");
            }
        }
        // Data of LAMMPS: the start of the same spheres as springs, in a box of room above and below.
        if let Scene::Powder(scene) = &scene {
            let home = tempfile::tempdir().unwrap();
            let file = home.path().join("state.json");
            std::fs::write(&file, &texts_of_state).unwrap();
            let soft = PowderScene {
                method: ContactMethod::Soft,
                initial_state: Some(file),
                second_fraction: 0.0,
                mu_second: None,
                second_density: None,
                radius_spread: 0.0,
                ..(**scene).clone()
            };
            let data = powder::export::start(&soft).unwrap().data;
            let read = Assembly::parse("powder.data", &data).unwrap();
            let open = read.with_periods("powder.data", [Some(8.0), Some(8.0), None]);
            let mut read = ReadPacking::of(&open.unwrap());
            // The box begins below the substrate.
            let low = read.positions[0].z - run.positions[0].z;
            read.positions.iter_mut().for_each(|place| place.z -= low);
            read.assert_is(&run, 1e-14, "powder, data of LAMMPS");
        }
        // Frames have places to a 65535th of the box, trajectories in single precision.
        let home = tempfile::tempdir().unwrap();
        let frames = home.path().join("frames");
        let mut film = FrameFolder::begin(&frames, &bodies).unwrap();
        film.add(&frame);
        film.finish(&frame).unwrap();
        let [(_, read)] = &Assembly::read_all(home.path()).unwrap()[..] else {
            panic!("{body}: one frame");
        };
        let coarse = ReadPacking::of(read);
        coarse.assert_is(&run, 2e-5, body);
        let stored = FrameFolder::read(&frames, &bodies, frame.step).unwrap();
        let state = State::of_frame(&bodies, &stored);
        for format in [Format::Vtk, Format::Xyz, Format::LammpsDump] {
            let what = format!("{body}, {format:?}");
            let mut trajectory = Trajectory::begin(home.path(), format).unwrap();
            trajectory.add(&state).unwrap();
            let mut file = trajectory.finish().unwrap();
            if format == Format::Vtk {
                file = home
                    .path()
                    .join(format!("trajectory/{:012}.vtp", frame.step));
            }
            let read = Assembly::read(&file).unwrap();
            ReadPacking::of(&read).assert_is(&coarse, 1e-7, &what);
            ReadPacking::of(&again(&read)).assert_is(&coarse, 1e-7, &what);
        }
    }
}

#[test]
fn a_frame_has_the_velocities_and_forces_of_the_state_walls_included() {
    let text = "body = \"grains\"\nwidth = 0.05\nradius = 0.005\nradius_spread = 0.2\ncount = 60\nduration = 1\n\
                density = 2500\nboundary_x = \"walls\"\nmax_iterations = 200\ngravity_angle = 20\nseed = 3\n";
    let scene = GrainsScene::parse("bed", text, &[]).unwrap();
    let mut run = GrainsSimulation::new(&scene).unwrap();
    while run.time() < 0.15 {
        run.step().unwrap();
    }
    let home = tempfile::tempdir().unwrap();
    let frame = Frame {
        step: 0,
        ..run.frame()
    };
    let film = FrameFolder::begin(&home.path().join("frames"), &run.bodies(9)).unwrap();
    film.finish(&frame).unwrap();
    let [(_, frame)] = &Assembly::read_all(home.path()).unwrap()[..] else {
        panic!("one frame");
    };
    let state = Assembly::parse("state", &run.state()).unwrap();
    assert_eq!(
        (frame.time, frame.forces),
        (Some(run.time()), KnownForces::Rounded)
    );
    assert_eq!(frame.contacts.len(), state.contacts.len());
    let walls = |all: &Assembly| {
        all.contacts
            .iter()
            .filter(|row| row.b.particle().is_none())
            .count()
    };
    assert!(walls(&state) > 10 && walls(frame) == walls(&state));
    let largest = state
        .contacts
        .iter()
        .map(|row| row.force.norm())
        .fold(0.0, f64::max);
    for (coarse, exact) in frame.contacts.iter().zip(&state.contacts) {
        assert_eq!((coarse.a, coarse.b), (exact.a, exact.b));
        // Half of the last place of each component, and places to a 130,000th of the box.
        assert!((coarse.force - exact.force).norm() < 6e-3 * exact.force.norm() + 1e-4 * largest);
        assert!((coarse.normal - exact.normal).norm() < 1e-3);
    }
    let velocities = |all: &Assembly| all.velocities.clone().unwrap();
    for (coarse, exact) in velocities(frame).iter().zip(velocities(&state)) {
        assert!((coarse - exact).norm() <= exact.norm() / 200.0);
    }
}
