//! Files as eight programs of the trade write them, by the forms that their manuals and sources give, and what comes back
//! from each format that is written.

use nalgebra::Vector3;
use std::f64::consts::PI;
use tribos_base::random::Random;
use tribos_base::space::PeriodicBox;
use tribos_grains::measure::{Assembly, PackingColumns, PackingFormat, WrittenPacking};

/// The two spheres of all samples: place, radius, density, velocity, angular velocity; materials 1 and 2.
const PLACES: [[f64; 3]; 2] = [[0.5, 0.5, 0.5], [1.5, 0.5, 0.75]];
const RADII: [f64; 2] = [0.5, 0.25];
const DENSITIES: [f64; 2] = [2000.0, 3000.0];
const VELOCITIES: [[f64; 3]; 2] = [[1.0, 0.0, 0.0], [0.0, -0.5, 0.0]];
const SPINS: [[f64; 3]; 2] = [[0.0, 0.0, 2.0], [0.0, 1.0, 0.0]];

/// A file with what it says: d densities, t types, v velocities, w angular velocities, x y z periods of 4, b a box, s a tilt
/// of 0.5.
type Sample = (&'static str, &'static [u8], &'static str);

const TEXTS: &[Sample] = &[
    // MercuryDPM: states in space and in a plane, restarts of version 1.0 and of before.
    ("mercury, the second of two states", b"1 0 0 0 0 4 4 4 \n9 9 9 0 0 0 1 0 0 0 0 0 0 0\n2 0.1 0 0 0 4 4 4 \n\
      0.5 0.5 0.5 1 0 0 0.5 0 0 0 0 0 2 0\n1.5 0.5 0.75 0 -0.5 0 0.25 0 0 0 0 1 0 1\n", "tvwb"),
    ("mercury restart", b"MercuryDPM 1.0 name two\ndataFile    fileType ONE_FILE saveCount 1 counter 2\nxMin 0 xMax 4 yMin 0 yMax 4 zMin 0 zMax 4\n\
      timeStep 0.1 time 0 ntimeSteps 1\nSpecies 2\nLinearViscoelasticSpecies id 0 density 2000 stiffness 1 dissipation 0 \n\
      LinearViscoelasticSpecies id 1 density 3000 stiffness 1 dissipation 0 \nLinearViscoelasticMixedSpecies idA 1 idB 0 stiffness 1 \n\
      Walls 1\nInfiniteWall id 0 indSpecies 0 position 0 0 0 orientation 1 0 0 0 normal 0 0 -1\nBoundaries 1\n\
      PeriodicBoundary id 0 normal 1 0 0 scaleFactor 1 distanceLeft 0 distanceRight 4 shift 4 0 0\nParticles 2\n\
      SphericalParticle id 0 indSpecies 0 position 0.5 0.5 0.5 orientation 1 0 0 0 velocity 1 0 0 angularVelocity 0 0 2 force 0 0 0 torque 0 0 0 radius 0.5 invMass 1\n\
      SphericalParticle id 1 indSpecies 1 position 1.5 0.5 0.75 orientation 1 0 0 0 velocity 0 -0.5 0 angularVelocity 0 1 0 force 0 0 0 torque 0 0 0 radius 0.25 invMass 1\n\
      Interactions 0\n", "dtvwxb"),
    ("mercury restart 3", b"restart_version 3\nname two\nxmin 0 xmax 4 ymin 0 ymax 4 zmin 0 zmax 4\ndt 1 t 1 tmax 1\nSpecies 2\n\
      k 2 disp 2 rho 2000 dim_particle 3\nk 2 disp 2 rho 3000 dim_particle 3\nWalls 0\nBoundaries 1\n\
      PeriodicBoundary normal 0 1 0 distance_left 0 distance_right 4\nParticles 2\nTSP BP 0.5 0.5 0.5 1 0 0 0.5 0 0 0 0 0 2 1 10 0 0\n\
      TSP BP 1.5 0.5 0.75 0 -0.5 0 0.25 0 0 0 0 1 0 1 10 1 0\n", "dtvwyb"),
    // LIGGGHTS: dump custom with and without its label, data, legacy VTK below.
    ("liggghts dump", b"ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS pp pp ff\n0 4\n0 4\n0 4\n\
      ITEM: ATOMS id type type x y z ix iy iz vx vy vz fx fy fz omegax omegay omegaz radius \n\
      1 1 1 0.5 0.5 0.5 0 0 0 1 0 0 0 0 0 0 0 2 0.5 \n2 2 2 1.5 0.5 0.75 0 0 0 0 -0.5 0 0 0 0 0 1 0 0.25 \n", "tvwxyb"),
    ("liggghts dump with a label", b"ITEM: TIMESTEP\n0\nITEM: LABEL\npour\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS ff ff ff\n0 4\n0 4\n0 4\n\
      ITEM: ATOMS id type radius density x y z vx vy vz\n1 1 0.5 2000 0.5 0.5 0.5 1 0 0\n2 2 0.25 3000 1.5 0.5 0.75 0 -0.5 0\n", "dtvb"),
    ("liggghts data", b"# LIGGGHTS data\n\n2\tatoms\t\t\n2\tatom types\t\n\n0 4 xlo xhi\n0 4 ylo yhi\n0 4 zlo zhi\n\nAtoms\t\t\n\n\
      1\t1 1e0 2000\t0.5 0.5 0.5\n2\t2 0.5 3000\t1.5 0.5 0.75\n", "dtxyzb"),
    // LAMMPS: data with image flags and velocities, a triclinic box; dumps with fractions of the box, without numbers.
    ("lammps data", b"LAMMPS data file via write_data\n\n2 atoms\n2 atom types\n\n0 4 xlo xhi\n0 4 ylo yhi\n0 4 zlo zhi\n\nAtoms # sphere\n\n\
      1 1 1.0 2000 0.5 0.5 0.5 0 0 0\n2 2 0.5 3000 1.5 0.5 0.75 0 0 0\n\nVelocities\n\n1 1 0 0 0 0 2\n2 0 -0.5 0 0 1 0\n", "dtvwxyzb"),
    ("lammps data that leans", b"title\n\n2 atoms\n2 atom types\n0 4 xlo xhi\n0 4 ylo yhi\n0 4 zlo zhi\n0 0.5 0 xy xz yz\n\nAtoms # sphere\n\n\
      1 1 1.0 2000 0.5 0.5 0.5\n2 2 0.5 3000 1.5 0.5 0.75\n", "dtxyzbs"),
    ("lammps dump in fractions", b"ITEM: UNITS\nsi\nITEM: TIMESTEP\n7\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS pp pp pp\n0 4\n0 4\n0 4\n\
      ITEM: ATOMS id type diameter xs ys zs\n9 1 1 0.125 0.125 0.125\n4 2 0.5 0.375 0.125 0.1875\n", "txyzb"),
    ("lammps dump that leans", b"ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS xy xz yz pp pp pp\n0 4.5 0\n0 4 0.5\n0 4 0\n\
      ITEM: ATOMS id type x y z radius\n1 1 0.5 0.5 0.5 0.5\n2 2 1.5 0.5 0.75 0.25\n", "txyzbs"),
    ("lammps dump of a group", b"ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS ff ff ff\n0 4\n0 4\n0 4\n\
      ITEM: ATOMS x y z vx vy vz radius\n0.5 0.5 0.5 1 0 0 0.5\n1.5 0.5 0.75 0 -0.5 0 0.25\n", "vb"),
    // YADE: export.text, export.textExt with materials and clumps, tabs and comments.
    ("yade export.text", b"#format x_y_z_r\n0.5\t0.5\t0.5\t0.5\n1.5\t0.5\t0.75\t0.25\n", ""),
    ("yade export.textExt", b"#format x_y_z_r_matId\n# two\n0.5\t0.5\t0.5\t0.5\t0\n1.5\t0.5\t0.75\t0.25\t1\n", "t"),
    ("yade export.textClumps", b"#format x_y_z_r_clumpId\n0.5 0.5 0.5 0.5 -1\n1.5 0.5 0.75 0.25 -1\n", ""),
    ("yade pack", b"#This is the file with the geometry, which can be imported\n0.5\t0.5\t0.5\t0.5\n\n1.5\t0.5\t0.75\t0.25", ""),
    // Lethe: files of insertion, with a mark at the end of each row.
    ("lethe insertion", b"p_x; p_y; p_z; v_x; v_y; v_z; w_x; w_y; w_z; diameters;\n0.5; 0.5; 0.5; 1.0; 0.0; 0.0; 0.0; 0.0; 2.0; 1;\n\
      1.5; 0.5; 0.75; 0.0; -0.5;  0.0; 0.0; 1.0; 0.0; 0.5;\n", "vw"),
    ("lethe insertion, new names", b"p_x; p_y; p_z; diameters; type;\n0.5; 0.5; 0.5; 1.0; 0;\n1.5; 0.5; 0.75; 0.5; 1;", "t"),
    // MUSEN: an export of objects, of which a wall is none; compounds; a domain that repeats along z.
    ("musen", b"0 0 1 14 5  23 STEEL 24 0 1e+300 2 0 12 1 1 -1 15 0 0 0 16 1 1 -1 18 0 20 0 0 0 31 1 1 1 0\n\
      0 1 1 1 5 0.5 0.5 23 GLASS 24 0 1e+300 2 0 12 9 9 9 15 0 0 0 16 0 0 0 18 0 20 0 0 0 31 1 0 0 0 36 0 0 0 0 0 0 0 0 0 \
      2 0.1 12 0.5 0.5 0.5 15 1 0 0 16 0 0 2 18 0 20 0 0 0 31 1 0 0 0 36 0 0 0 0 0 0 0 0 0\n\
      0 2 1 1 5 0.25 0.25 23 STEEL 24 0 1e+300 2 0 12 1.5 0.5 0.75 15 0 -0.5 0 16 0 1 0 18 0 20 0 0 0 31 1 0 0 0 36 0 0 0 0 0 0 0 0 0\n\
      22 0 0 0 4 4 4\n28 1 0 0 1 0 0 0 4 4 4\n32 STEEL Steel 0 3000 2 1e+40 7 2e+11\n32 GLASS Window glass 0 2000 2 1e+40\n", "dtvwzb"),
    ("musen without walls", b"0 0 1 1 5 0.5 0.5 23 A 24 0 1 2 0 12 0.5 0.5 0.5 15 1 0 0\n0 1 1 1 5 0.25 0.25 23 B 24 0 1 2 0 12 1.5 0.5 0.75 15 0 -0.5 0\n", "tv"),
    // ESyS-Particle: geometries with tags for numbers of materials, and with others.
    ("esys", b"LSMGeometry 1.2\nBoundingBox 0 0 0 4 4 4\nPeriodicBoundaries 1 0 0\nDimension 3D\nBeginParticles\nSimple\n2\n\
      0.5 0.5 0.5 0.5 0 0\n1.5 0.5 0.75 0.25 1 1\nEndParticles\nBeginConnect\n1\n0 1 0\nEndConnect\n", "txb"),
    ("esys with tags", b"LSMGeometry 1.1\nBoundingBox 0 0 0 4 4 4\nPeriodicBoundaries 0 0 0\nDimension 3D\nBeginParticles\nSimple\n2\n\
      0.5 0.5 0.5 0.5 0 -1\n1.5 0.5 0.75 0.25 1 5000\nEndParticles\n", "b"),
    // Kratos: nodes that come twice, a node that is no sphere, initial velocities, two properties.
    ("kratos", b"Begin ModelPartData\n//  VARIABLE_NAME value\nEnd ModelPartData\n\nBegin Properties 1\n    PARTICLE_DENSITY 2000.0\nEnd Properties\n\
      Begin Properties 2 // steel\n PARTICLE_DENSITY 3000\nEnd Properties\nBegin Nodes\n 7  0.5 0.5 0.5\n 3 1.5 0.5 0.75 // here\n 9 8 8 8\nEnd Nodes\n\
      Begin Nodes\n 3 1.5 0.5 0.75\nEnd Nodes\n\nBegin Elements SphericParticle3D// GUI group identifier: DEM\n 1 1 7\n 2 2 3\nEnd Elements\n\n\
      Begin NodalData RADIUS // GUI\n 7 0 0.5\n 3 0 0.25\nEnd NodalData\nBegin NodalData VELOCITY_X\n 7 0 1\nEnd NodalData\n\
      Begin NodalData VELOCITY_Y\n 3 0 -0.5\nEnd NodalData\nBegin SubModelPart Parts\n Begin SubModelPartNodes\n 7\n End SubModelPartNodes\nEnd SubModelPart\n", "dtv"),
    ("kratos without densities", b"Begin Properties 1\nEnd Properties\nBegin Nodes\n 1 0.5 0.5 0.5\n 2 1.5 0.5 0.75\nEnd Nodes\n\
      Begin Elements CylinderParticle\n 1 1 1\n 2 2 2\nEnd Elements\nBegin NodalData RADIUS\n1 0 0.5\n2 0 0.25\nEnd NodalData\n", "t"),
    // Plain and extended XYZ of OVITO and ASE.
    ("plain xyz", b"2\nspheres\nA 0.5 0.5 0.5 0.5\nB 1.5 0.5 0.75 0.25\n", "t"),
    ("plain xyz, two frames, no comment", b"1\n1 9 9 9 1\n2\n1 0.5 0.5 0.5 0.5\n2 1.5 0.5 0.75 0.25\n", "t"),
    ("plain xyz with names", b"2\nelement x y z diameter vx vy vz\nX 0.5 0.5 0.5 1 1 0 0\nX 1.5 0.5 0.75 0.5 0 -0.5 0\n", "v"),
    ("plain xyz with a cell", b"2\nLattice=\"4 0 0 0 4 0 0 0 4\" pbc=\"T T F\"\nA 0.5 0.5 0.5 0.5\nB 1.5 0.5 0.75 0.25\n", "txyb"),
    ("ovito xyz", b"2\nLattice=\"4 0 0 0 4 0 0.5 0 4\" Properties=id:I:1:type:I:1:pos:R:3:Radius:R:1:Velocity:R:3:Angular_Velocity:R:3 Origin=\"0 0 0\" pbc=\"T T T\"\n\
      1 1 0.5 0.5 0.5 0.5 1 0 0 0 0 2\n2 2 1.5 0.5 0.75 0.25 0 -0.5 0 0 1 0\n", "tvwxyzbs"),
    ("xyz with diameters", b"2\nLattice=\"4 0 0 0 4 0 0 0 4\" Properties=species:S:1:pos:R:3:diameter:R:1:density:R:1 pbc=\"F F F\"\n\
      a 0.5 0.5 0.5 1 2000\nb 1.5 0.5 0.75 0.5 3000\n", "dtb"),
    // Tables of laboratories: ParaView's, spreadsheets', by hand.
    ("paraview csv", b"\"Radius\",\"Velocity:0\",\"Velocity:1\",\"Velocity:2\",\"Points:0\",\"Points:1\",\"Points:2\"\n0.5,1,0,0,0.5,0.5,0.5\n\
      0.25,0,-0.5,0,1.5,0.5,0.75\n", "v"),
    ("csv", b"id,x [m],y [m],z [m],r [m],rho,material\n1,0.5,0.5,0.5,0.5,2000,glass\n2,1.5,0.5,0.75,0.25,3000,steel\n", "dt"),
    ("semicolons", b"X;Y;Z;Diameter;Density;Type\n0.5;0.5;0.5;1;2000;1\n1.5;0.5;0.75;0.5;3000;2\n", "dt"),
    ("table", b"0.5 0.5 0.5 0.5\n1.5 0.5 0.75 0.25 # the last\n", ""),
    ("table under a comment", b"% spheres of my packing\n# x y z radius vx vy vz wx wy wz\n0.5 0.5 0.5 0.5 1 0 0 0 0 2\n\
      1.5 0.5 0.75 0.25 0 -0.5 0 0 1 0\n", "vw"),
    ("table under its names", b"x y z rad density\n\n0.5 0.5 0.5 0.5 2e3\n1.5 0.5 0.75 .25 3e3\n", "d"),
];

const BYTES: &[Sample] = &[
    ("mercury.vtu", include_bytes!("vtk/mercury.vtu"), "tvw"),
    (
        "yade-inline-zlib.vtu",
        include_bytes!("vtk/yade-inline-zlib.vtu"),
        "tvw",
    ),
    (
        "yade-appended-raw.vtu",
        include_bytes!("vtk/yade-appended-raw.vtu"),
        "tvw",
    ),
    (
        "lethe-appended-base64-zlib.vtu",
        include_bytes!("vtk/lethe-appended-base64-zlib.vtu"),
        "tvw",
    ),
    (
        "lethe-appended-raw-zlib.vtu",
        include_bytes!("vtk/lethe-appended-raw-zlib.vtu"),
        "tvw",
    ),
    (
        "liggghts-appended-base64.vtp",
        include_bytes!("vtk/liggghts-appended-base64.vtp"),
        "dtvw",
    ),
    (
        "liggghts-big-endian.vtp",
        include_bytes!("vtk/liggghts-big-endian.vtp"),
        "dtvw",
    ),
    (
        "liggghts-ascii.vtk",
        include_bytes!("vtk/liggghts-ascii.vtk"),
        "dtvw",
    ),
    (
        "liggghts-binary.vtk",
        include_bytes!("vtk/liggghts-binary.vtk"),
        "dtvw",
    ),
    (
        "lethe-binary.vtk",
        include_bytes!("vtk/lethe-binary.vtk"),
        "tvw",
    ),
];

fn samples() -> impl Iterator<Item = &'static Sample> {
    TEXTS.iter().chain(BYTES)
}

fn vectors(all: [[f64; 3]; 2]) -> Vec<Vector3<f64>> {
    all.map(Vector3::from).to_vec()
}

/// What no file may lose; motion that is not known is rest, materials that are all the first are none.
#[derive(Clone, Debug, PartialEq)]
struct Packing {
    positions: Vec<Vector3<f64>>,
    radii: Vec<f64>,
    densities: Option<Vec<f64>>,
    materials: Option<Vec<u8>>,
    velocities: Vec<Vector3<f64>>,
    spins: Vec<Vector3<f64>>,
    periods: [Option<f64>; 3],
    tilt: f64,
    bounds: Option<[[f64; 2]; 3]>,
}

impl Packing {
    fn of(read: &Assembly) -> Self {
        let count = read.radii.len();
        let rest = || vec![Vector3::zeros(); count];
        let periods = read.space.lengths();
        let tilt = read.space.offset();
        let lines = read.about(&|x| x.to_string());
        let has_box = lines
            .iter()
            .any(|(name, what)| *name == "box" && what != "not in the file");
        Self {
            positions: read
                .positions
                .iter()
                .map(|place| read.space.wrap(place))
                .collect(),
            radii: read.radii.clone(),
            densities: read.densities.clone(),
            materials: read.materials.clone(),
            velocities: read.velocities.clone().unwrap_or_else(rest),
            spins: read.spins.clone().unwrap_or_else(rest),
            periods,
            // A tilt is the same after a whole period.
            tilt: periods[0].map_or(tilt, |length| tilt - length * (tilt / length).round()),
            bounds: has_box.then_some(read.bounds),
        }
    }

    /// The two spheres, as far as a sample has them.
    fn sample(said: &str) -> Self {
        let has = |letter: char| said.contains(letter);
        let motion = |letter, all| {
            if has(letter) {
                vectors(all)
            } else {
                vec![Vector3::zeros(); 2]
            }
        };
        Self {
            positions: vectors(PLACES),
            radii: RADII.to_vec(),
            densities: has('d').then(|| DENSITIES.to_vec()),
            materials: has('t').then(|| vec![1, 2]),
            velocities: motion('v', VELOCITIES),
            spins: motion('w', SPINS),
            periods: ['x', 'y', 'z'].map(|axis| has(axis).then_some(4.0)),
            tilt: if has('s') { 0.5 } else { 0.0 },
            bounds: has('b').then_some([[0.0, 4.0]; 3]),
        }
    }

    /// Equal to the bit, but the far end of an open box, which XYZ says by its length.
    #[track_caller]
    fn assert_is(&self, other: &Self, what: &str) {
        let (mine, theirs) = (
            self.bounds.unwrap_or_default(),
            other.bounds.unwrap_or_default(),
        );
        for (mine, theirs) in mine.as_flattened().iter().zip(theirs.as_flattened()) {
            assert!(
                (mine - theirs).abs() <= 8.0 * f64::EPSILON * mine.abs(),
                "{what}"
            );
        }
        let bounds = self.bounds.and(other.bounds);
        let [mine, theirs] = [self, other].map(|one| Self {
            bounds,
            ..one.clone()
        });
        assert_eq!(mine, theirs, "{what}");
        assert_eq!(self.bounds.is_some(), other.bounds.is_some(), "{what}");
    }

    /// What of it a format holds.
    fn held_by(&self, format: PackingFormat) -> Self {
        let mut held = self.clone();
        if format == PackingFormat::LammpsData {
            // All axes repeat, so that the box begins at 0, and all densities are there.
            for (axis, [low, high]) in held.bounds.iter_mut().flatten().enumerate() {
                held.positions
                    .iter_mut()
                    .for_each(|place| place[axis] -= *low);
                (*low, *high) = (0.0, *high - *low);
            }
            held.densities = held.densities.or(Some(vec![1.0; self.radii.len()]));
            let lengths = self
                .bounds
                .map(|bounds| bounds.map(|[low, high]| Some(high - low)));
            held.periods = lengths.unwrap_or([None; 3]);
        }
        if format == PackingFormat::Csv {
            (held.periods, held.tilt, held.bounds) = ([None; 3], 0.0, None);
        }
        held
    }
}

fn parse(name: &str, bytes: &[u8]) -> Assembly {
    Assembly::parse_as(name, bytes, None).unwrap_or_else(|error| panic!("{name}: {error}"))
}

fn written(read: &Assembly, format: PackingFormat) -> String {
    let WrittenPacking { text, .. } = read.written(format).unwrap().unwrap();
    text
}

const WRITTEN: [PackingFormat; 5] = [
    PackingFormat::ExtendedXyz,
    PackingFormat::VtkXml,
    PackingFormat::LammpsData,
    PackingFormat::Csv,
    PackingFormat::Table,
];

#[test]
fn files_of_eight_programs_are_known_by_their_content() {
    assert!(samples().count() >= 40);
    for (name, bytes, said) in samples() {
        assert_eq!(
            Packing::of(&parse(name, bytes)),
            Packing::sample(said),
            "{name}"
        );
    }
}

#[test]
fn gzip_makes_no_difference() {
    use std::io::Write as _;
    let home = tempfile::tempdir().unwrap();
    for (at, (name, bytes, said)) in samples().enumerate() {
        let mut packer = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::fast());
        packer.write_all(bytes).unwrap();
        // Known by its content, whatever it is called.
        let file = home.path().join(at.to_string());
        std::fs::write(&file, packer.finish().unwrap()).unwrap();
        assert_eq!(
            Packing::of(&Assembly::read(&file).unwrap()),
            Packing::sample(said),
            "{name}"
        );
    }
}

#[test]
fn every_format_read_and_every_format_written_give_back_what_the_second_holds() {
    for (name, bytes, _) in samples() {
        let read = parse(name, bytes);
        let before = Packing::of(&read);
        for format in WRITTEN {
            // LAMMPS data has a box in any case: that of the spheres.
            if format == PackingFormat::LammpsData && before.bounds.is_none() {
                continue;
            }
            let again = parse(format.name(), written(&read, format).as_bytes());
            assert_eq!(again.format, Some(format), "{name}");
            assert_eq!(
                Packing::of(&again),
                before.held_by(format),
                "{name} as {}",
                format.name()
            );
        }
    }
}

/// Spheres with all their bits in use, in a box that leans; without what a file may lack.
fn cloud(has_motion: bool, periods: [Option<f64>; 3]) -> Assembly {
    let mut random = Random::new(11, 0);
    let mut some = |scale: f64, shift: f64| -> Vec<Vector3<f64>> {
        (0..50)
            .map(|_| Vector3::from_fn(|_, _| scale * (random.unit() - shift)))
            .collect()
    };
    let [positions, velocities, spins, others] =
        [(9.0, 0.0), (1e-3, 0.5), (7.0, 0.5), (1.0, -0.1)].map(|(scale, shift)| some(scale, shift));
    let leans = periods[0].is_some() && periods[2].is_some();
    let space = PeriodicBox::new(periods)
        .unwrap()
        .sheared(if leans { 1.0 / 3.0 } else { 0.0 });
    let mut made = Assembly::new(
        space,
        positions,
        others.iter().map(|other| other.x).collect(),
    );
    if has_motion {
        made.densities = Some(others.iter().map(|other| 1e3 * other.y).collect());
        made.materials = Some((0..50).map(|at| 1 + at % 3).collect());
        (made.velocities, made.spins) = (Some(velocities), Some(spins));
    }
    made
}

#[test]
fn pairs_of_written_formats_keep_every_bit() {
    let periodic = [Some(9.25), Some(9.5), Some(9.125)];
    for (has_motion, periods) in [
        (true, periodic),
        (false, periodic),
        (true, [Some(9.25), None, None]),
        (true, [None; 3]),
    ] {
        let made = cloud(has_motion, periods);
        let made_holds = Packing::of(&made);
        for first in WRITTEN {
            if first == PackingFormat::LammpsData && made_holds.bounds.is_none() {
                continue;
            }
            let once = parse("once", written(&made, first).as_bytes());
            let held = Packing::of(&once);
            held.assert_is(&made_holds.held_by(first), first.name());
            for second in WRITTEN {
                if second == PackingFormat::LammpsData && held.bounds.is_none() {
                    continue;
                }
                let twice = parse("twice", written(&once, second).as_bytes());
                let what = format!("{} as {}", first.name(), second.name());
                Packing::of(&twice).assert_is(&held.held_by(second), &what);
            }
        }
    }
}

#[test]
fn what_a_format_cannot_hold_is_said() {
    let open = cloud(false, [Some(9.25), None, None]);
    let lost = |format| open.written(format).unwrap().unwrap().lost;
    assert_eq!(lost(PackingFormat::ExtendedXyz), [""; 0]);
    assert_eq!(lost(PackingFormat::Csv), ["the box with its periods"]);
    assert_eq!(
        lost(PackingFormat::LammpsData),
        [
            "that the densities are not known: 1 is written for all",
            "which axes repeat"
        ]
    );
    assert_eq!(open.written(PackingFormat::MercuryData).unwrap(), None);
}

#[test]
fn columns_are_taken_as_the_user_says() {
    let volume = |radius: f64| 4.0 / 3.0 * PI * radius * radius * radius;
    let masses = format!(
        "0.5 0.5 0.5 1 {} 1\n1.5 0.5 0.75 0.5 {} 2\n",
        2000.0 * volume(0.5),
        3000.0 * volume(0.25)
    );
    let file = |columns: &str, bytes: &[u8]| {
        let columns: PackingColumns = columns.parse().unwrap();
        assert_eq!(columns.to_string().parse(), Ok(columns.clone()));
        let read = Assembly::parse_as("f", bytes, Some(&columns));
        read.map(|read| Packing::of(&read))
            .map_err(|error| error.to_string())
    };
    let with_masses = file("x,y,z,diameter,mass,type", masses.as_bytes()).unwrap();
    for (density, expected) in with_masses.densities.iter().flatten().zip(DENSITIES) {
        assert!((density / expected - 1.0).abs() < 4.0 * f64::EPSILON);
    }
    assert_eq!(
        Packing {
            densities: None,
            ..with_masses
        },
        Packing::sample("t")
    );
    let equal = |said: &str| Packing {
        radii: vec![0.5; 2],
        ..Packing::sample(said)
    };
    // Centres alone, with one radius of all.
    let centres = b"2\n\nA 0.5 0.5 0.5\nB 1.5 0.5 0.75\n";
    assert_eq!(file("radius=all:0.5", centres), Ok(equal("t")));
    assert_eq!(file("-,x,y,z,radius=all:0.5", centres), Ok(equal("")));
    assert_eq!(
        file("radius=all:0.5", b"0.5 0.5 0.5\n1.5 0.5 0.75\n"),
        Ok(equal(""))
    );
    let atoms = b"2\nLattice=\"4 0 0 0 4 0 0 0 4\" Properties=species:S:1:pos:R:3\nA 0.5 0.5 0.5\nB 1.5 0.5 0.75\n";
    assert_eq!(file("diameter=all:1", atoms), Ok(equal("txyzb")));
    // By heading, by number; arrays of VTK by name.
    let csv = b"a,x,y,z,R eq\n0.5,0.5,0.5,0.5,7\n0.25,1.5,0.5,0.75,8\n";
    assert_eq!(file("radius=a", csv), Ok(Packing::sample("")));
    assert_eq!(file("radius=1", csv), Ok(Packing::sample("")));
    let (_, vtu, said) = BYTES[0];
    let renamed = String::from_utf8(vtu.to_vec())
        .unwrap()
        .replace("Radius", "size");
    assert_eq!(
        file("radius=size", renamed.as_bytes()),
        Ok(Packing::sample(said))
    );
    for (columns, bytes, reason) in [
        ("x,y,z", &b"0.5 0.5 0.5 0.5\n"[..], "there are no radii"),
        (
            "x,y,z,radius,-",
            b"0 0 0 1\n",
            "there are 4 columns, and 5 are named",
        ),
        (
            "radius=b",
            csv,
            "there is no column `b`; there are a, x, y, z, R eq",
        ),
        (
            "x,y,z,radius",
            renamed.as_bytes(),
            "the arrays have names; give --columns (key `columns`) as NAME=ARRAY",
        ),
        (
            "x,y,z,radius",
            atoms,
            "it is extended XYZ and says itself what its columns are",
        ),
        (
            "radius=all:0",
            atoms,
            "the radius of all must be > 0, not 0",
        ),
    ] {
        let refused = file(columns, bytes).unwrap_err();
        assert!(refused.contains(reason), "{columns}: {refused}");
    }
    for (columns, reason) in [
        (
            "x,y,colour",
            "`colour` is no column; known are x, y, z, radius",
        ),
        ("x,y,x", "`x` is given twice"),
        (
            "radius=all:big",
            "`radius=all:big` is no number for all spheres",
        ),
        ("", "there is no column"),
    ] {
        let refused = columns.parse::<PackingColumns>().unwrap_err().to_string();
        assert!(refused.starts_with(reason), "{refused}");
    }
}

#[test]
fn files_that_are_not_understood_are_refused_with_what_was_and_a_cure() {
    let refusal = |text: &str| {
        Assembly::parse("f", text).map_or_else(|error| error.to_string(), |_| "read".into())
    };
    for (text, reason) in [
        (
            "0 0 0 1 7\n",
            "f: line 1: 5 columns without names, `0 0 0 1 7`: say what the columns are by --columns",
        ),
        (
            "2\n\nA 0 0 0\nB 1 0 0\n",
            "f: line 3: 4 columns without names, `A 0 0 0`: say what the columns are by --columns",
        ),
        (
            "Dear reader, this is no packing.\n",
            "f: line 1: 2 columns without names, `Dear reader this is no packing.`",
        ),
        (
            "x,y,z\n0,0,0\n",
            "f: there are no radii; say what the columns are",
        ),
        (
            "0 0 0 1\n0 0 1\n",
            "f: line 2: a row must be 4 columns as in line 1, not `0 0 1`",
        ),
        (
            "0 0 0 1\n0 0 b 1\n",
            "f: line 2: z must be a finite number, not `b`",
        ),
        (
            "0 0 0 1\n0 0 3 -1\n",
            "f: line 2: the radius must be a finite number > 0, not -1",
        ),
        (
            "x;y;z;r\n0,5;0;0;1\n",
            "f: line 2: x must be a finite number (write a decimal point: 0.5), not `0,5`",
        ),
        (
            "3\n\nA 0 0 0 1\n",
            "f: line 4: a sphere is missing; is the file cut short?",
        ),
        (
            "1 0 0 0 0 4 4 4\n0 0 0 1 1 1 1 0 0 0 0 0 0 -2\n",
            "f: line 2: the type must be a whole number from 0 to 255, not -1",
        ),
        (
            "2 0 0 0 0 4 4 4\n0 0 0 1 1 1 1 0 0 0 0 0 0 0\n",
            "f: line 3: a particle is missing; is the file cut short?",
        ),
        (
            "MercuryDPM 1.0\nParticles 1\nSuperQuadricParticle id 0\n",
            "f: line 3: the particle `SuperQuadricParticle` cannot be read; only spheres are read",
        ),
        (
            "LSMGeometry 1.2\n",
            "f: line 2: BeginParticles is missing; is the file cut short?",
        ),
        (
            "Begin Nodes\n1 0 0 0\nEnd Nodes\n",
            "f: there are no radii; no node has the data RADIUS",
        ),
        (
            "# vtk DataFile Version 3.0\nt\nASCII\nDATASET STRUCTURED_POINTS\n",
            "f: only POLYDATA and UNSTRUCTURED_GRID are read",
        ),
        ("", "f: the file is empty"),
    ] {
        let said = refusal(text);
        assert!(said.starts_with(reason), "{text}: {said}");
    }
    let (_, bytes, _) = BYTES[1];
    let text = String::from_utf8(bytes.to_vec()).unwrap();
    let other = text.replace("vtkZLibDataCompressor", "vtkLZ4DataCompressor");
    assert_eq!(
        refusal(&other),
        "f: it is compressed by vtkLZ4DataCompressor; in ParaView save it with Compressor Type ZLib or None"
    );
    // A letter of the packed block of radii changed.
    let radii = text.find("AQAAAA").or(text.find("AgAAAA")).unwrap();
    let damaged = format!("{}{}", &text[..radii], &text[radii + 4..]);
    assert!(
        refusal(&damaged).contains("is damaged"),
        "{}",
        refusal(&damaged)
    );
}
