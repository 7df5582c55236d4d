//! Patches with straight edges and meshes by name, and their corners from files.

use super::arc_piece::ArcPiece;
use super::coefficients::quarters;
use super::owned_feet::OwnedFeet;
use super::refusal::finite_number;
use super::surface::DryRound;
use super::text::{feet, files};
use super::{FrictionError, OwnedNodes, Precision};
use std::fmt;
use std::path::{Path, PathBuf};
use std::str::FromStr;
use tribos_core::coupling::flat::{Hessian, Motion, PatchShape, PointLoad, Reduced};
use tribos_core::patch::anisotropic::AnisotropicPatch;
use tribos_core::patch::bar::Bar;
use tribos_core::patch::ellipse::{Ellipse, EllipsePressure};
use tribos_core::patch::mesh::{Mesh, Triangle, Vertex};
use tribos_core::patch::nodes::Node;
use tribos_core::patch::outline::{Edge, LinearPressure, OutlineError, Polygon};
use tribos_core::patch::points::PointPatch;
use tribos_core::patch::round::RoundPatch;
use tribos_core::real::Real;

/// A patch with straight edges or a mesh, as it is written. Lengths are in m.
///
/// ```
/// use tribos::friction::FlatPatch;
/// use tribos::kernel::coupling::flat::PatchShape;
/// let crate_: FlatPatch = "box:0.3x0.2".parse()?;
/// assert_eq!(crate_, FlatPatch::Box([0.3, 0.2]));
/// assert!((crate_.loaded::<f64>(None)?.radius() - 0.15_f64.hypot(0.1)).abs() < 1e-16);
/// assert!("box:0.3".parse::<FlatPatch>().is_err());
/// # Ok::<(), tribos::friction::FrictionError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub enum FlatPatch {
    /// A rectangle of these sides along x and y, about the origin.
    Box([f64; 2]),
    /// A polygon with its corners in a file.
    Polygon(PathBuf),
    /// A straight bar of this length along x, about the origin.
    Bar(f64),
    /// Triangles with a pressure at each corner, in a file.
    Mesh(PathBuf),
    /// So many bolts that share the load evenly, on a circle of this radius about the origin, the first one on the x axis.
    Bolts(u32, f64),
    /// Feet of a body, in a file.
    Feet(PathBuf),
    /// An ellipse with these semi-axes along x and y, about the origin, under uniform pressure.
    Ellipse([f64; 2]),
    /// The same under the pressure of curved elastic bodies, sqrt(1 - rho^2).
    HertzEllipse([f64; 2]),
}

/// A patch with straight edges, a mesh or points, ready for the kernel.
#[derive(Clone, Debug)]
pub enum Flat<R: Precision> {
    /// Under uniform pressure.
    Polygon(Polygon<R, Vec<Edge<R>>>),
    /// Under linear pressure.
    Leaning(Polygon<R, Vec<Edge<R>>, LinearPressure<R>>),
    /// Without an area.
    Bar(Bar<R>),
    /// The same under linear pressure.
    LeaningBar(Bar<R, LinearPressure<R>>),
    /// Of triangles, each under linear pressure.
    Mesh(Mesh<R, Vec<Triangle<R>>>),
    /// Points with weights.
    Points(PointPatch<R, OwnedNodes<R>>),
    /// An ellipse.
    Ellipse(Ellipse<R>),
    /// A piece of a disk or an ellipse.
    ArcPiece(Box<ArcPiece<R>>),
    /// Round, in a place of its own.
    Round(Box<RoundPatch<R, DryRound<R>>>),
    /// Any of these under friction that differs along two axes.
    Anisotropic(Box<AnisotropicPatch<R, Self>>),
    /// Several of these under one body.
    Feet(OwnedFeet<R>),
}

/// Most bolts of a ring.
const MOST_BOLTS: u32 = 10_000;
/// Most triangles of a file.
const MOST_TRIANGLES: usize = 1_000_000;
/// Columns of a file of triangles: place and pressure of each corner.
const TRIANGLE: [&str; 9] = ["x1", "y1", "p1", "x2", "y2", "p2", "x3", "y3", "p3"];

impl FlatPatch {
    /// Every patch as it is written, and what it is.
    pub const SYNTAX: &[(&str, &str)] = &[
        (
            "box:AxB",
            "a rectangle of sides A and B, in m, about the origin",
        ),
        ("polygon:FILE", "a CSV file with columns x,y[,loop], in m"),
        (
            "bar:L",
            "a line of length L, in m, along x about the origin",
        ),
        (
            "mesh:FILE",
            "a CSV file of triangles with columns x1,y1,p1,x2,y2,p2,x3,y3,p3: corners in m, and \
             pressures of which only the ratios count",
        ),
        (
            "ellipse:AxB",
            "an ellipse of semi-axes A and B, in m, about the origin, under uniform pressure",
        ),
        (
            "hertz-ellipse:AxB",
            "the same under the pressure of curved elastic bodies, sqrt(1 - rho^2) with rho = 1 at the edge",
        ),
        (
            "bolts:NxR",
            "N bolts on a circle of radius R, in m, that share the load evenly",
        ),
        (
            "feet:FILE",
            "a CSV file of feet with columns patch,x,y[,radius][,angle_deg][,load][,mu][,mu_across]: all carry load times \
             coefficient together, in proportion to the products of theirs",
        ),
    ];

    /// True if `text` begins with the name of such a patch.
    pub fn is_named_by(text: &str) -> bool {
        let name = text.split(':').next().unwrap_or(text).trim();
        let mut all = Self::SYNTAX
            .iter()
            .filter_map(|(syntax, _)| syntax.split(':').next());
        all.any(|known| known == name)
    }

    /// The corners of all loops, the outer one first; of a bar both ends, of a mesh its triangles, of ellipses, bolts and feet none.
    #[doc(hidden)]
    pub fn loops(&self) -> Result<Vec<Vec<[f64; 2]>>, FrictionError> {
        Ok(match self {
            Self::Bar(length) => vec![vec![[-0.5 * length, 0.0], [0.5 * length, 0.0]]],
            Self::Mesh(path) => {
                let triangle =
                    |row: &[f64; 9]| vec![[row[0], row[1]], [row[3], row[4]], [row[6], row[7]]];
                triangles_of(path)?.iter().map(triangle).collect()
            }
            Self::Box([a, b]) => {
                let (x, y) = (0.5 * a, 0.5 * b);
                vec![vec![[-x, -y], [x, -y], [x, y], [-x, y]]]
            }
            Self::Polygon(path) => files::loops(path)?,
            Self::Bolts(..) | Self::Feet(_) | Self::Ellipse(_) | Self::HertzEllipse(_) => {
                Vec::new()
            }
        })
    }

    /// The patch for the kernel, its file read; with a centre of pressure under linear pressure.
    pub fn loaded<R: Precision>(&self, centre: Option<[f64; 2]>) -> Result<Flat<R>, FrictionError> {
        let narrow = |[x, y]: [f64; 2]| [x, y].map(R::from_f64);
        let own = |reason: &str| {
            let refused =
                FrictionError::Syntax(format!("{reason}; leave the centre of pressure out"));
            centre.map_or(Ok(()), |_| Err(refused))
        };
        match self {
            Self::Mesh(path) => {
                own("a mesh has its own pressure")?;
                return Ok(Flat::Mesh(mesh(path)?));
            }
            Self::Bar(length) => {
                let half = 0.5 * length;
                let bar = Bar::new(narrow([-half, 0.0]), narrow([half, 0.0]));
                let bar = bar.map_err(tribos_core::Error::from)?;
                return match centre {
                    None => Ok(Flat::Bar(bar)),
                    Some([x, 0.0]) if x.abs() <= length / 6.0 => {
                        let bar = bar.with_centre_of_pressure(R::from_f64(x));
                        Ok(Flat::LeaningBar(bar.map_err(tribos_core::Error::from)?))
                    }
                    Some(_) => Err(FrictionError::Syntax(format!(
                        "the centre of pressure of a bar lies in its middle third: give X,0 with |X| <= {}",
                        length / 6.0
                    ))),
                };
            }
            Self::Bolts(count, radius) => {
                own("bolts share the load evenly")?;
                let bolts = OwnedNodes::new(bolts(*count, *radius)).and_then(PointPatch::new);
                return Ok(Flat::Points(bolts.map_err(tribos_core::Error::from)?));
            }
            Self::Ellipse(semi_axes) | Self::HertzEllipse(semi_axes) => {
                own("an ellipse has its own pressure")?;
                let pressure = match self {
                    Self::Ellipse(_) => EllipsePressure::Uniform,
                    _ => EllipsePressure::Hertz,
                };
                let ellipse = Ellipse::new(narrow([0.0; 2]), narrow(*semi_axes), pressure);
                return Ok(Flat::Ellipse(ellipse.map_err(tribos_core::Error::from)?));
            }
            Self::Feet(path) => {
                own("feet have loads of their own")?;
                return feet(path);
            }
            Self::Box(_) | Self::Polygon(_) => {}
        }
        let narrowed: Vec<Vec<[R; 2]>> = self
            .loops()?
            .iter()
            .map(|corners| corners.iter().map(|&corner| narrow(corner)).collect())
            .collect();
        let slices: Vec<&[[R; 2]]> = narrowed.iter().map(Vec::as_slice).collect();
        Flat::polygon(&slices, centre.map(narrow)).map_err(|error| match (error, self) {
            (OutlineError::LiftOff { .. }, Self::Box([a, b])) => FrictionError::Syntax(format!(
                "with this centre of pressure the box lifts off: give |X|/{a} + |Y|/{b} <= 1/6"
            )),
            (OutlineError::LiftOff { .. }, _) => FrictionError::Syntax(format!(
                "with this centre of pressure the patch lifts off: {error}; move it nearer to the \
                 centroid"
            )),
            (_, Self::Polygon(path)) => {
                FrictionError::Syntax(format!("{}: {error}", path.display()))
            }
            _ => tribos_core::Error::from(error).into(),
        })
    }
}

/// Bolts of the same load on a circle.
fn bolts<R: Real>(count: u32, radius: f64) -> Vec<Node<R>> {
    let bolt = |index: u32| {
        let [cos, sin] = quarters(360.0 * f64::from(index) / f64::from(count));
        Node {
            x: R::from_f64(radius * cos),
            y: R::from_f64(radius * sin),
            weight: R::ONE,
        }
    };
    (0..count).map(bolt).collect()
}

/// Place and pressure of the three corners of each triangle of a file.
#[doc(hidden)]
pub fn triangles_of(path: &Path) -> Result<Vec<[f64; 9]>, FrictionError> {
    files::numbers(path, &TRIANGLE, MOST_TRIANGLES)
}

/// The mesh of a file of triangles.
fn mesh<R: Real>(path: &Path) -> Result<Mesh<R, Vec<Triangle<R>>>, FrictionError> {
    let rows = triangles_of(path)?;
    let corners = rows.as_flattened().chunks_exact(3);
    let vertices: Vec<Vertex<R>> = corners
        .map(|corner| {
            let [x, y, pressure] = [corner[0], corner[1], corner[2]].map(R::from_f64);
            Vertex { x, y, pressure }
        })
        .collect();
    let count = rows.len();
    let triangles: Vec<[usize; 3]> = (0..count).map(|n| [3 * n, 3 * n + 1, 3 * n + 2]).collect();
    Mesh::with_vertices(&vertices, &triangles, vec![Triangle::default(); count])
        .map_err(|error| FrictionError::Syntax(format!("{}: {error}", path.display())))
}

impl<R: Precision> Flat<R> {
    /// A polygon of these loops, under uniform pressure or with a centre of pressure under linear pressure.
    pub(super) fn polygon(
        loops: &[&[[R; 2]]],
        centre: Option<[R; 2]>,
    ) -> Result<Self, OutlineError> {
        let count = loops.iter().map(|corners| corners.len()).sum();
        let polygon = Polygon::with_holes(loops, vec![Edge::default(); count])?;
        Ok(match centre {
            None => Self::Polygon(polygon),
            Some(at) => Self::Leaning(polygon.with_centre_of_pressure(at)?),
        })
    }

    /// Radius of gyration about the upright axis through the centre, of a plate of uniform thickness on the
    /// patch.
    #[doc(hidden)]
    pub fn radius_of_gyration(&self) -> Result<R, FrictionError> {
        Ok(match self {
            Self::Polygon(patch) => patch.radius_of_gyration(),
            Self::Leaning(patch) => patch.radius_of_gyration(),
            Self::Bar(bar) => bar.radius() / R::from_f64(3.0).sqrt(),
            Self::LeaningBar(bar) => {
                let [[x, y], [to_x, to_y]] = bar.ends();
                (to_x - x).hypot(to_y - y) / R::from_f64(12.0).sqrt()
            }
            Self::Round(patch) => patch.radius() / R::TWO.sqrt(),
            Self::Mesh(_)
            | Self::Points(_)
            | Self::Ellipse(_)
            | Self::ArcPiece(_)
            | Self::Anisotropic(_)
            | Self::Feet(_) => {
                return Err(FrictionError::Syntax(
                    "a plate is a box, a polygon, a bar or a disk".into(),
                ));
            }
        })
    }
}

/// What the kernel's patch of a [`Flat`] answers.
macro_rules! each {
    ($flat:expr, $patch:ident => $answer:expr) => {
        match $flat {
            Flat::Polygon($patch) => $answer,
            Flat::Leaning($patch) => $answer,
            Flat::Bar($patch) => $answer,
            Flat::LeaningBar($patch) => $answer,
            Flat::Mesh($patch) => $answer,
            Flat::Points($patch) => $answer,
            Flat::Ellipse($patch) => $answer,
            Flat::ArcPiece($patch) => $answer,
            Flat::Round($patch) => $answer,
            Flat::Anisotropic($patch) => $answer,
            Flat::Feet($patch) => $answer,
        }
    };
}

impl<R: Precision> PatchShape<R> for Flat<R> {
    fn centre(&self) -> nalgebra::Vector2<R> {
        each!(self, patch => patch.centre())
    }
    fn radius(&self) -> R {
        each!(self, patch => patch.radius())
    }
    fn rounding(&self) -> R {
        each!(self, patch => patch.rounding())
    }
    fn reduced(&self, motion: &Motion<R>) -> Reduced<R> {
        each!(self, patch => patch.reduced(motion))
    }
    fn reduced_with_hessian(&self, motion: &Motion<R>) -> (Reduced<R>, Hessian<R>) {
        each!(self, patch => patch.reduced_with_hessian(motion))
    }
    fn nearest_point(&self, place: &nalgebra::Vector2<R>) -> Option<PointLoad<R>> {
        each!(self, patch => patch.nearest_point(place))
    }
}

impl fmt::Display for FlatPatch {
    /// As [`FlatPatch::from_str`] takes it.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Box([a, b]) => write!(f, "box:{a}x{b}"),
            Self::Polygon(path) => write!(f, "polygon:{}", path.display()),
            Self::Bar(length) => write!(f, "bar:{length}"),
            Self::Mesh(path) => write!(f, "mesh:{}", path.display()),
            Self::Ellipse([a, b]) => write!(f, "ellipse:{a}x{b}"),
            Self::HertzEllipse([a, b]) => write!(f, "hertz-ellipse:{a}x{b}"),
            Self::Bolts(count, radius) => write!(f, "bolts:{count}x{radius}"),
            Self::Feet(path) => write!(f, "feet:{}", path.display()),
        }
    }
}

impl FromStr for FlatPatch {
    type Err = FrictionError;

    fn from_str(text: &str) -> Result<Self, FrictionError> {
        let (name, rest) = text.split_once(':').unwrap_or((text, ""));
        let positive = |what: &str, part: &str| {
            let number = finite_number(part).map_err(|error| format!("{what}: {error}"));
            match number {
                Ok(x) if x > 0.0 => Ok(x),
                Ok(x) => Err(FrictionError::Syntax(format!(
                    "{what} must be > 0, not {x}"
                ))),
                Err(error) => Err(FrictionError::Syntax(error)),
            }
        };
        match (name.trim(), rest.trim()) {
            ("box", sides) => {
                let Some((a, b)) = sides.split_once('x') else {
                    return Err(FrictionError::Syntax(
                        "give two sides in m, such as box:0.3x0.2".into(),
                    ));
                };
                Ok(Self::Box([positive("side A", a)?, positive("side B", b)?]))
            }
            ("polygon", "") => Err(FrictionError::Syntax(
                "give a CSV file of corners, such as polygon:sole.csv".into(),
            )),
            ("polygon", file) => Ok(Self::Polygon(file.into())),
            ("bar", "") => Err(FrictionError::Syntax(
                "give a length in m, such as bar:0.2".into(),
            )),
            ("mesh", "") => Err(FrictionError::Syntax(
                "give a CSV file of triangles, such as mesh:pad.csv".into(),
            )),
            ("mesh", file) => Ok(Self::Mesh(file.into())),
            ("ellipse" | "hertz-ellipse", axes) => {
                let Some((a, b)) = axes.split_once('x') else {
                    return Err(FrictionError::Syntax(
                        "give two semi-axes in m, such as ellipse:0.006x0.004".into(),
                    ));
                };
                let axes = [positive("semi-axis A", a)?, positive("semi-axis B", b)?];
                Ok(match name.trim() {
                    "ellipse" => Self::Ellipse(axes),
                    _ => Self::HertzEllipse(axes),
                })
            }
            ("bolts", text) => {
                let parts = text.split_once('x');
                let count = parts.and_then(|(count, _)| count.trim().parse().ok());
                let (Some(count @ 2..=MOST_BOLTS), Some((_, radius))) = (count, parts) else {
                    return Err(FrictionError::Syntax(format!(
                        "give a number of bolts from 2 to {MOST_BOLTS} and the radius of their circle in m, such as bolts:6x0.05"
                    )));
                };
                Ok(Self::Bolts(count, positive("the radius", radius)?))
            }
            ("feet", "") => Err(FrictionError::Syntax(
                "give a CSV file of feet, such as feet:robot.csv".into(),
            )),
            ("feet", file) => Ok(Self::Feet(file.into())),
            ("bar", length) => Ok(Self::Bar(positive("the length", length)?)),
            _ => {
                let all: Vec<&str> = Self::SYNTAX.iter().map(|(syntax, _)| *syntax).collect();
                let names = all.iter().filter_map(|syntax| syntax.split(':').next());
                let list = format!("the patches with straight edges are {}", all.join(", "));
                Err(FrictionError::unknown("patch", text, names, list))
            }
        }
    }
}
