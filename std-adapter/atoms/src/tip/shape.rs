//! A tip on a substrate: layers of face-centred cubic crystals.

use super::lattice::CrystalFace;
use nalgebra::Vector3;

/// Least height of a tip over a substrate whose crystal it does not continue, in mean spacings: no
/// site of the one is on top of another so closely that the atoms repel each other much.
const GAP: f64 = 0.9;

/// Frozen and thermostatted layers of the substrate, driven and thermostatted ones of the tip.
pub const LAYERS_OF_A_KIND: usize = 2;

/// Outline of the tip's layers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TipOutline {
    /// A regular hexagon with two corners on the close-packed row through its middle.
    Hexagon,
    /// A disk with the hexagon's corners on its rim.
    Disk,
    /// A hexagon that loses one atom a side from each layer to the one below.
    Cone,
}

/// Shape of a tip on a substrate. Lengths in any unit.
///
/// ```
/// use tribos::tip::{CrystalFace, TipOutline, Shape, Site};
/// let shape = Shape {
///     face: CrystalFace::Fcc111,
///     tip_face: CrystalFace::Fcc111,
///     spacing: 1.0,
///     tip_spacing: 1.0,
///     columns: 8,
///     rows: 8,
///     substrate_layers: 4,
///     tip_layers: 4,
///     side: 2,
///     outline: TipOutline::Hexagon,
///     orientation: 0.0,
///     raise: 0.0,
/// };
/// let sites: Vec<Site> = shape.sites();
/// assert_eq!(sites.len(), 4 * 8 * 8 + 4 * 7); // four hexagons of seven atoms on top
/// // In a face-centred cubic crystal an atom has a volume of d³/√2.
/// let [x, y] = shape.periods();
/// let volume = x * y * shape.layer_distance() / 64.0;
/// assert!((volume - 0.5_f64.sqrt()).abs() < 1e-14);
/// assert_eq!(shape.axis(), [0.5 * x, 0.5 * y]);
/// let top = sites.iter().map(|site| site.place.z).fold(0.0, f64::max);
/// assert_eq!(top, (shape.layers() - 1) as f64 * shape.layer_distance());
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shape {
    /// Face of the substrate's crystal that is parallel to its layers.
    pub face: CrystalFace,
    /// Face of the tip's crystal that is parallel to its layers.
    pub tip_face: CrystalFace,
    /// Distance d of nearest neighbours in the substrate.
    pub spacing: f64,
    /// Distance of nearest neighbours in the tip.
    pub tip_spacing: f64,
    /// Atoms along x in a layer of the substrate, along the close-packed rows.
    pub columns: usize,
    /// Rows of the substrate along y, an even number for (111).
    pub rows: usize,
    /// Layers of the substrate.
    pub substrate_layers: usize,
    /// Layers of the tip.
    pub tip_layers: usize,
    /// Atoms on a side of the tip's top layer.
    pub side: usize,
    /// Outline of the tip's layers.
    pub outline: TipOutline,
    /// Angle by which the tip is turned about the vertical, in radians; at 0 the close-packed rows of
    /// both crystals are along x.
    pub orientation: f64,
    /// Height of the driven layers above their position in the crystal.
    pub raise: f64,
}

/// Parts of the system, from below (thesis, fig. 5.1, with its colours).
///
/// ```
/// # use tribos::tip::{CrystalFace, TipOutline, Shape};
/// use tribos::tip::{LAYERS_OF_A_KIND, AtomRole};
/// # let shape = Shape {
/// #     face: CrystalFace::Fcc111,
/// #     tip_face: CrystalFace::Fcc111,
/// #     spacing: 1.0,
/// #     tip_spacing: 1.0,
/// #     columns: 8,
/// #     rows: 8,
/// #     substrate_layers: 5,
/// #     tip_layers: 4,
/// #     side: 2,
/// #     outline: TipOutline::Hexagon,
/// #     orientation: 0.0,
/// #     raise: 0.0,
/// # };
/// // A substrate of five layers, a tip of four.
/// let parts: Vec<AtomRole> = (0..shape.layers()).map(|layer| shape.part(layer)).collect();
/// let of_kind = AtomRole::ALL.map(|part| parts.iter().filter(|&&other| other == part).count());
/// assert_eq!(of_kind, [2, 2, 1, 0, 2, 2]);
/// assert_eq!(of_kind[0], LAYERS_OF_A_KIND);
/// // One atom to watch in each part that the tip has.
/// let sites = shape.sites();
/// let watched: Vec<_> = shape.marked().iter().map(|&atom| sites[atom].part.name()).collect();
/// assert_eq!(watched, ["tip bath", "driven"]);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AtomRole {
    /// Black: held in place.
    Base,
    /// Green in the substrate: with a thermostat.
    SubstrateBath,
    /// Gray: free.
    Surface,
    /// Blue: free.
    Apex,
    /// Green in the tip: with a thermostat.
    TipBath,
    /// Red: driven.
    Driven,
}

impl AtomRole {
    /// All parts, in the order of their numbers.
    pub const ALL: [Self; 6] = [
        Self::Base,
        Self::SubstrateBath,
        Self::Surface,
        Self::Apex,
        Self::TipBath,
        Self::Driven,
    ];

    /// Name of the part.
    pub fn name(self) -> &'static str {
        match self {
            Self::Base => "base",
            Self::SubstrateBath => "substrate bath",
            Self::Surface => "surface",
            Self::Apex => "apex",
            Self::TipBath => "tip bath",
            Self::Driven => "driven",
        }
    }
}

/// An atom of the crystal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Site {
    /// Position of the atom.
    pub place: Vector3<f64>,
    /// Part that the atom belongs to.
    pub part: AtomRole,
    /// Layer of the atom, from the lowest of the substrate.
    pub layer: usize,
}

impl Shape {
    /// Periods along x and y.
    pub fn periods(&self) -> [f64; 2] {
        [
            self.columns as f64 * self.spacing,
            self.rows as f64 * self.face.row_distance(self.spacing),
        ]
    }

    /// Axis of the tip, through a site of the lowest layer next to the middle.
    pub fn axis(&self) -> [f64; 2] {
        let row = self.rows / 2;
        [
            ((self.columns / 2) as f64 + self.face.row_start(row)) * self.spacing,
            row as f64 * self.face.row_distance(self.spacing),
        ]
    }

    /// Distance of two layers of the substrate.
    pub fn layer_distance(&self) -> f64 {
        self.face.layer_distance(self.spacing)
    }

    /// Whether the tip continues the crystal of the substrate, but for a rotation of (111) layers.
    pub fn is_one_crystal(&self) -> bool {
        let is_alike = self.face == self.tip_face && self.spacing == self.tip_spacing;
        is_alike && (self.face == CrystalFace::Fcc111 || self.orientation == 0.0)
    }

    /// Height of a layer in its crystal.
    fn height(&self, layer: usize) -> f64 {
        if layer < self.substrate_layers || self.is_one_crystal() {
            return layer as f64 * self.layer_distance();
        }
        let above = self.tip_face.layer_distance(self.tip_spacing);
        let usual = 0.5 * (self.layer_distance() + above);
        let gap = usual.max(GAP * 0.5 * (self.spacing + self.tip_spacing));
        let surface = (self.substrate_layers - 1) as f64 * self.layer_distance();
        surface + gap + (layer - self.substrate_layers) as f64 * above
    }

    /// Largest distance of an atom of the tip from its axis.
    pub fn reach(&self) -> f64 {
        let aside = self.tip_face.overhang(self.tip_spacing);
        (self.side as f64 - 1.0) * self.tip_spacing + aside
    }

    /// Number of layers.
    pub fn layers(&self) -> usize {
        self.substrate_layers + self.tip_layers
    }

    /// All atoms: the substrate's layers from below, then the tip's.
    pub fn sites(&self) -> Vec<Site> {
        let mut sites = Vec::new();
        for layer in 0..self.layers() {
            let part = self.part(layer);
            let raise = if part == AtomRole::Driven {
                self.raise
            } else {
                0.0
            };
            let height = self.height(layer) + raise;
            let places = if layer < self.substrate_layers {
                self.substrate_layer(layer)
            } else {
                self.tip_layer(layer)
            };
            sites.extend(places.into_iter().map(|[x, y]| Site {
                place: Vector3::new(x, y, height),
                part,
                layer,
            }));
        }
        sites
    }

    /// One atom of each part of the tip that shows its rotation: the one farthest to the right in
    /// the part's top layer.
    pub fn marked(&self) -> Vec<usize> {
        let sites = self.sites();
        let right_of = |&a: &usize, &b: &usize| {
            let (a, b) = (&sites[a], &sites[b]);
            let layers = a.layer.cmp(&b.layer);
            layers.then(a.place.x.total_cmp(&b.place.x))
        };
        let top_right = |part: AtomRole| {
            let atoms = (0..sites.len()).filter(|&atom| sites[atom].part == part);
            atoms.max_by(right_of)
        };
        let parts = [AtomRole::Apex, AtomRole::TipBath, AtomRole::Driven];
        parts.into_iter().filter_map(top_right).collect()
    }

    /// Part that a layer belongs to.
    pub fn part(&self, layer: usize) -> AtomRole {
        let from_top = self.layers() - 1 - layer;
        if layer < LAYERS_OF_A_KIND {
            AtomRole::Base
        } else if layer < 2 * LAYERS_OF_A_KIND {
            AtomRole::SubstrateBath
        } else if layer < self.substrate_layers {
            AtomRole::Surface
        } else if from_top < LAYERS_OF_A_KIND {
            AtomRole::Driven
        } else if from_top < 2 * LAYERS_OF_A_KIND {
            AtomRole::TipBath
        } else {
            AtomRole::Apex
        }
    }

    fn substrate_layer(&self, layer: usize) -> Vec<[f64; 2]> {
        let [_, period] = self.periods();
        let [aside, behind] = self.face.stacking(layer, self.spacing);
        let mut places = Vec::with_capacity(self.rows * self.columns);
        for row in 0..self.rows {
            let y = row as f64 * self.face.row_distance(self.spacing) + behind;
            let y = if y < 0.0 { y + period } else { y };
            let start = self.face.row_start(row);
            for column in 0..self.columns {
                places.push([(column as f64 + start) * self.spacing + aside, y]);
            }
        }
        places
    }

    /// Sites of a layer around the axis, rotated.
    fn tip_layer(&self, layer: usize) -> Vec<[f64; 2]> {
        let below_top = self.layers() - 1 - layer;
        let side = match self.outline {
            TipOutline::Cone => self.side - below_top.min(self.side - 1),
            _ => self.side,
        };
        let (sin, cos) = libm::sincos(self.orientation);
        let [x0, y0] = self.axis();
        let [aside, behind] = self.tip_face.stacking(layer, self.tip_spacing);
        let place = |[x, y]: [f64; 2]| {
            let [x, y] = [x + aside, y + behind];
            [x0 + (cos * x - sin * y), y0 + (sin * x + cos * y)]
        };
        self.outlined(side).into_iter().map(place).collect()
    }

    /// Sites of a layer around the origin within an outline.
    fn outlined(&self, side: usize) -> Vec<[f64; 2]> {
        let reach = side as i64 - 1;
        let row_distance = self.tip_face.row_distance(self.tip_spacing);
        let is_triangular = self.tip_face == CrystalFace::Fcc111;
        let is_inside = |q: i64, r: i64| match (is_triangular, self.outline) {
            (true, TipOutline::Disk) => q * q + q * r + r * r <= reach * reach,
            (true, _) => q.abs().max(r.abs()).max((q + r).abs()) <= reach,
            (false, outline) => {
                let x = (q as f64 * self.tip_spacing).abs();
                let y = (r as f64 * row_distance).abs();
                is_within(outline, reach as f64 * self.tip_spacing, [x, y])
            }
        };
        // Each row of a triangular lattice begins half a spacing on.
        let slant = if is_triangular { 0.5 } else { 0.0 };
        let mut places = Vec::new();
        for r in -2 * reach..=2 * reach {
            for q in -2 * reach..=2 * reach {
                if is_inside(q, r) {
                    let x = (q as f64 + slant * r as f64) * self.tip_spacing;
                    places.push([x, r as f64 * row_distance]);
                }
            }
        }
        places
    }
}

/// Whether a place at these distances from both axes is within an outline, rounded outwards.
fn is_within(outline: TipOutline, reach: f64, [x, y]: [f64; 2]) -> bool {
    const ROUNDING: f64 = 1e-9;
    let reach = reach * (1.0 + ROUNDING);
    match outline {
        TipOutline::Disk => x * x + y * y <= reach * reach,
        TipOutline::Hexagon | TipOutline::Cone => {
            let slope = 3.0_f64.sqrt();
            y <= 0.5 * slope * reach && y <= slope * (reach - x)
        }
    }
}
