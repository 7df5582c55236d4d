//! Materials of the spheres of a packing, with a law for every two of them and for each at walls.

use super::Material;
use tribos_base::random::Random;
use tribos_contacts::soft::Stiffness;

/// Materials of a packing: the n-th is that of spheres of type n, and the first that of types without one.
#[derive(Clone, Debug, PartialEq)]
pub struct Mixture {
    components: Vec<Component>,
    /// Laws of two spheres by their materials, row by row.
    pairs: Vec<Material>,
}

/// One of them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Component {
    /// Share of the spheres that are drawn to be of it; the first has the rest.
    pub share: f64,
    /// Factor of the radii of spheres that are placed.
    pub radius: f64,
    /// Whether it has a density of its own, which spheres that are drawn to be of it take.
    pub is_dense: bool,
    /// Law of two of its spheres.
    pub alike: Material,
    /// Law of one of them at a wall.
    pub at_wall: Material,
}

/// What is said of a law; what is not is mixed, or that of another material.
#[derive(Clone, Copy, Debug, Default)]
pub struct LawChanges {
    pub sliding: Option<f64>,
    pub rolling: Option<f64>,
    pub torsion: Option<f64>,
    pub restitution: Option<f64>,
    pub cohesion: Option<f64>,
    pub stiffness: Option<Stiffness>,
}

/// What a scene with keys of its own for a second material says of it. What it leaves out is that of the first.
#[derive(Clone, Copy, Debug)]
pub struct SecondMaterialKeys {
    pub share: f64,
    pub radius: f64,
    pub density: Option<f64>,
    pub sliding: Option<f64>,
    pub sliding_mixed: Option<f64>,
}

/// Stream of a seed for the materials of the spheres.
const STREAM: u64 = 2;

impl LawChanges {
    /// A law with these changes.
    pub fn of(&self, law: &Material) -> Material {
        Material {
            sliding: self.sliding.unwrap_or(law.sliding),
            rolling: self.rolling.unwrap_or(law.rolling),
            torsion: self.torsion.unwrap_or(law.torsion),
            restitution: self.restitution.unwrap_or(law.restitution),
            cohesion: self.cohesion.unwrap_or(law.cohesion),
            stiffness: self.stiffness.unwrap_or(law.stiffness),
            ..*law
        }
    }
}

impl Material {
    /// The law of a sphere of one material and one of another, if nothing else is known: geometric means of coefficients,
    /// restitution and cohesion, and springs in series.
    pub(crate) fn between(a: &Self, b: &Self) -> Self {
        // Squares may leave the range of numbers.
        let mean = |of: fn(&Self) -> f64| match [of(a), of(b)] {
            [one, other] if one == other => one,
            [one, other] => (one * other).sqrt(),
        };
        Self {
            sliding: mean(|law| law.sliding),
            rolling: mean(|law| law.rolling),
            torsion: mean(|law| law.torsion),
            restitution: mean(|law| law.restitution),
            cohesion: mean(|law| law.cohesion),
            stiffness: in_series(a.stiffness, b.stiffness),
            ..*a
        }
    }
}

/// The spring of two unlike spheres, each with half of the compliance of two like it: 1/k = 1/(2 k₁) + 1/(2 k₂), and for
/// Hertz's law 1/E* = (1 − ν₁²)/E₁ + (1 − ν₂²)/E₂ (Johnson, Contact Mechanics, 1985, eq. 4.24).
fn in_series(a: Stiffness, b: Stiffness) -> Stiffness {
    let mean = |a: f64, b: f64| if a == b { a } else { 2.0 / (1.0 / a + 1.0 / b) };
    match (a, b) {
        (Stiffness::Linear(a), Stiffness::Linear(b)) => Stiffness::Linear(mean(a, b)),
        (Stiffness::Hertz(a), Stiffness::Hertz(b)) => Stiffness::Hertz(mean(a, b)),
        // One scene has one law.
        _ => a,
    }
}

impl Component {
    /// All spheres, of one material that walls have too.
    pub fn whole(material: Material) -> Self {
        Self {
            share: 0.0,
            radius: 1.0,
            is_dense: false,
            alike: material,
            at_wall: material,
        }
    }
}

impl Mixture {
    /// Materials with what is said of each two of them, the lower number first. *Domain*: one material or more.
    pub fn new(components: Vec<Component>, changes: impl Fn([usize; 2]) -> LawChanges) -> Self {
        let law = |a: usize, b: usize| {
            let [one, other] = [a, b].map(|of| &components[of].alike);
            if a == b {
                return *one;
            }
            changes([a.min(b), a.max(b)]).of(&Material::between(one, other))
        };
        let count = components.len();
        let pairs = (0..count).flat_map(|a| (0..count).map(move |b| (a, b)));
        let pairs = pairs.map(|(a, b)| law(a, b)).collect();
        Self { components, pairs }
    }

    /// A first material, and a second one that differs in some keys.
    pub fn of_two(first: Material, keys: &SecondMaterialKeys) -> Self {
        let own = LawChanges {
            sliding: keys.sliding,
            ..LawChanges::default()
        };
        let material = Material {
            density: keys.density.unwrap_or(first.density),
            ..own.of(&first)
        };
        let second = Component {
            share: keys.share,
            radius: keys.radius,
            is_dense: keys.density.is_some(),
            ..Component::whole(material)
        };
        Self::new(vec![Component::whole(first), second], |_| LawChanges {
            sliding: keys.sliding_mixed,
            ..LawChanges::default()
        })
    }

    /// The first material.
    pub fn first(&self) -> &Material {
        &self.components[0].alike
    }

    /// All materials.
    pub fn components(&self) -> &[Component] {
        &self.components
    }

    /// The material of spheres of a type, as an index.
    pub fn index(&self, kind: u8) -> usize {
        let of_type = usize::from(kind).wrapping_sub(1);
        if of_type < self.components.len() {
            of_type
        } else {
            0
        }
    }

    /// Law of two spheres, and that of the first at a wall, by the indices of their materials.
    pub fn laws(&self, [a, b]: [usize; 2]) -> [&Material; 2] {
        [
            &self.pairs[a * self.components.len() + b],
            &self.components[a].at_wall,
        ]
    }

    /// All laws.
    pub fn all(&self) -> impl Iterator<Item = &Material> {
        let walls = self.components.iter().map(|component| &component.at_wall);
        self.pairs.iter().chain(walls)
    }

    /// Density of the spheres of a type.
    pub fn density(&self, kind: u8) -> f64 {
        self.components[self.index(kind)].alike.density
    }

    /// Whether spheres of these materials obey other laws than those of the first alone.
    pub fn differs(&self, indices: &[u8]) -> bool {
        let mut has = vec![false; self.components.len()];
        for index in indices {
            has[usize::from(*index)] = true;
        }
        let present = || (0..has.len()).filter(|index| has[*index]);
        // Of spheres alike in all but their mass.
        let differ = |a: &Material, b: &Material| {
            let density = b.density;
            Material { density, ..*a } != *b
        };
        let others = |a: usize, b: usize| {
            let mut laws = self.laws([a, b]).into_iter().zip(self.laws([0, 0]));
            laws.any(|(law, first)| differ(law, first))
        };
        present().any(|a| present().any(|b| others(a, b)))
    }

    /// Materials of which spheres are drawn, and the first.
    pub fn drawn(&self) -> impl Iterator<Item = &Component> {
        let others = &self.components[1..];
        let drawn = others.iter().filter(|component| component.share > 0.0);
        self.components[..1].iter().chain(drawn)
    }

    /// Whether any sphere would be drawn to be of another material than the first.
    pub fn is_drawn(&self) -> bool {
        self.drawn().nth(1).is_some()
    }

    /// Types of so many spheres: of each material its share of all, each choice as likely (Knuth's algorithm S).
    pub fn draw(&self, seed: u64, count: usize) -> Vec<u8> {
        let mut random = Random::new(seed, STREAM);
        let mut room = count as f64;
        let others = self.components[1..].iter().map(|component| {
            let needed = (component.share * count as f64).round().min(room);
            room -= needed;
            needed
        });
        let mut needed: Vec<f64> = others.collect();
        let mut choose = |index: usize| {
            if needed.iter().all(|needed| *needed == 0.0) {
                return 1;
            }
            let mut place = random.unit() * (count - index) as f64;
            for (kind, needed) in (2..).zip(&mut needed) {
                if place < *needed {
                    *needed -= 1.0;
                    return kind;
                }
                place -= *needed;
            }
            1
        };
        (0..count).map(&mut choose).collect()
    }

    /// The largest coefficients of any two spheres: which modes the contacts carry.
    pub fn widest(&self) -> Material {
        let most = |of: fn(&Material) -> f64| self.all().map(of).fold(0.0, f64::max);
        Material {
            sliding: most(|law| law.sliding),
            rolling: most(|law| law.rolling),
            torsion: most(|law| law.torsion),
            ..*self.first()
        }
    }
}
