//! Bodies of several materials, with a law for every two of them.

use super::setup::{ContactMaterial, WorldMaterials};

/// Materials of the bodies of a world, and the laws between them.
///
/// ```
/// use tribos::cd::{WorldMaterials, MaterialTable};
/// use tribos::kernel::contact::{Cohesion, NormalLaw, IndependentFriction};
/// // Spheres of material 0 and 1 on a floor of material 1; unlike ones slide most easily.
/// let normal = NormalLaw::new(Cohesion::NONE, 0.0)?;
/// let [like, unlike] = [IndependentFriction::sliding(0.5)?, IndependentFriction::sliding(0.1)?];
/// let mixture = MaterialTable::new(vec![0, 0, 1], vec![1], |[a, b]| {
///     WorldMaterials::uniform(normal, if a == b { like } else { unlike })
/// });
/// assert_eq!(mixture.of_pair([0, 1]).friction.mu(), 0.5);
/// assert_eq!(mixture.of_pair([1, 2]).friction.mu(), 0.1);
/// assert_eq!(mixture.at_wall([2, 0]).friction.mu(), 0.5);
/// # Ok::<(), tribos::kernel::law::LawError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct MaterialTable<F> {
    spheres: Vec<u8>,
    walls: Vec<u8>,
    /// Number of materials.
    count: usize,
    /// Laws of the materials of two bodies, row by row.
    laws: Vec<WorldMaterials<F>>,
}

impl<F> MaterialTable<F> {
    /// Bodies of these materials, numbered from 0. `law` gives the laws of two materials: those of `pairs`,
    /// with the lower number first, between spheres; those of `walls` for a sphere of the first at a wall of
    /// the second.
    pub fn new(
        spheres: Vec<u8>,
        walls: Vec<u8>,
        law: impl Fn([u8; 2]) -> WorldMaterials<F>,
    ) -> Self {
        let most = spheres.iter().chain(&walls).copied().max().unwrap_or(0);
        let of = |a: u8, b: u8| WorldMaterials {
            pairs: law([a.min(b), a.max(b)]).pairs,
            walls: law([a, b]).walls,
        };
        let laws = (0..=most).flat_map(|a| (0..=most).map(move |b| (a, b)));
        Self {
            count: usize::from(most) + 1,
            laws: laws.map(|(a, b)| of(a, b)).collect(),
            spheres,
            walls,
        }
    }

    /// Laws between two spheres. *Domain*: numbers of spheres.
    #[inline(always)]
    pub fn of_pair(&self, [a, b]: [u32; 2]) -> &ContactMaterial<F> {
        let [a, b] = [self.spheres[a as usize], self.spheres[b as usize]];
        &self.laws[usize::from(a) * self.count + usize::from(b)].pairs
    }

    /// Laws of a sphere at a wall; a mesh is of material 0. *Domain*: numbers of a sphere and a wall.
    #[inline(always)]
    pub fn at_wall(&self, [a, wall]: [u32; 2]) -> &ContactMaterial<F> {
        let [a, b] = [
            self.spheres[a as usize],
            self.walls.get(wall as usize).copied().unwrap_or(0),
        ];
        &self.laws[usize::from(a) * self.count + usize::from(b)].walls
    }

    /// The same bodies with what a law gives in place of its friction.
    pub(crate) fn map<G>(&self, of: impl Fn(&ContactMaterial<F>) -> G) -> MaterialTable<G> {
        let of = |law: &ContactMaterial<F>| ContactMaterial {
            normal: law.normal,
            friction: of(law),
        };
        let laws = self.laws.iter().map(|laws| WorldMaterials {
            pairs: of(&laws.pairs),
            walls: of(&laws.walls),
        });
        MaterialTable {
            spheres: self.spheres.clone(),
            walls: self.walls.clone(),
            count: self.count,
            laws: laws.collect(),
        }
    }

    /// The laws of any two materials.
    pub(crate) fn laws(&self) -> &[WorldMaterials<F>] {
        &self.laws
    }

    /// Whether there is a material for each of so many spheres and walls.
    pub(crate) fn fits(&self, spheres: usize, walls: usize) -> bool {
        self.spheres.len() == spheres && self.walls.len() == walls
    }
}

/// The laws of a world: the same for all pairs and for all walls, or by the materials of the bodies.
#[derive(Debug)]
#[doc(hidden)]
pub struct LawBook<'a, F> {
    pub laws: &'a WorldMaterials<F>,
    pub mixture: Option<&'a MaterialTable<F>>,
}

impl<F> Clone for LawBook<'_, F> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<F> Copy for LawBook<'_, F> {}

impl<'a, F> LawBook<'a, F> {
    /// Laws between two spheres.
    #[inline(always)]
    pub fn of_pair(&self, bodies: [u32; 2]) -> &'a ContactMaterial<F> {
        self.mixture
            .map_or(&self.laws.pairs, |mixture| mixture.of_pair(bodies))
    }

    /// Laws of a sphere at a wall.
    #[inline(always)]
    pub fn at_wall(&self, bodies: [u32; 2]) -> &'a ContactMaterial<F> {
        self.mixture
            .map_or(&self.laws.walls, |mixture| mixture.at_wall(bodies))
    }

    /// All laws, those of pairs first.
    pub fn all(&self) -> impl Iterator<Item = &'a ContactMaterial<F>> + use<'a, F> {
        let laws = match self.mixture {
            None => std::slice::from_ref(self.laws),
            Some(mixture) => &mixture.laws,
        };
        let walls = laws.iter().map(|laws| &laws.walls);
        laws.iter().map(|laws| &laws.pairs).chain(walls)
    }
}

/// Friction of the pairs of a problem.
pub(super) trait PairFriction<F>: Sync {
    /// Friction between two spheres.
    fn of(&self, bodies: [u32; 2]) -> &F;
}

/// The same friction for all pairs.
#[derive(Debug)]
pub(super) struct Same<F>(pub F);

impl<F: Sync> PairFriction<F> for Same<F> {
    #[inline(always)]
    fn of(&self, _: [u32; 2]) -> &F {
        &self.0
    }
}

impl<F: Sync> PairFriction<F> for MaterialTable<F> {
    #[inline(always)]
    fn of(&self, bodies: [u32; 2]) -> &F {
        &self.of_pair(bodies).friction
    }
}
