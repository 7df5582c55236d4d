//! Materials by name, and what holds between two of them: the texts of a scene, their rules, and the laws that follow.

use crate::grains::scene::GrainsScene;
use crate::packing::method::{ContactMethod, FrictionCoupling, NormalForce, WallLaw};
use crate::packing::{Component, LawChanges, Material, Mixture, SecondMaterialKeys, SettingError};
use std::fmt;
use std::str::FromStr;
use tribos_base::scene::finite_number;
use tribos_base::scene::key::Domain::*;
use tribos_base::scene::key::{Domain, Form, reads};
use tribos_base::scene::nearest;
use tribos_base::scene::reader::SceneDiagnostics;
use tribos_base::scene::words::words;
use tribos_contacts::soft::Stiffness;

/// Most materials of a scene: types above are of glued and driven grains.
const MOST: usize = 6;
/// The other side of a contact with a wall, in the name of a pair.
const WALLS: &str = "walls";
/// Rounding of shares that are given for all materials.
const WHOLE: f64 = 1e-9;

/// What an entry says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Property {
    Share,
    Radius,
    Density,
    Mu,
    MuRolling,
    MuTorsion,
    Restitution,
    Cohesion,
    Stiffness,
    YoungModulus,
    PoissonRatio,
}
words!(Property {
    Share = "share",
    Radius = "radius",
    Density = "density",
    Mu = "mu",
    MuRolling = "mu_rolling",
    MuTorsion = "mu_torsion",
    Restitution = "restitution",
    Cohesion = "cohesion",
    Stiffness = "stiffness",
    YoungModulus = "young_modulus",
    PoissonRatio = "poisson_ratio",
});

impl Property {
    fn domain(self) -> Domain {
        match self {
            Self::Share | Self::Restitution => Fraction,
            Self::Radius => Between {
                above: 0.0,
                up_to: 100.0,
            },
            Self::Density | Self::Stiffness | Self::YoungModulus => Positive,
            Self::Mu | Self::MuRolling | Self::MuTorsion | Self::Cohesion => NotNegative,
            Self::PoissonRatio => Between {
                above: -1.0,
                up_to: 0.5,
            },
        }
    }

    /// Whether only springs have it.
    fn is_elastic(self) -> bool {
        matches!(
            self,
            Self::Stiffness | Self::YoungModulus | Self::PoissonRatio
        )
    }

    /// Whether it belongs to a contact of two materials, and not to one of them.
    fn is_of_pairs(self) -> bool {
        !matches!(
            self,
            Self::Share | Self::Radius | Self::Density | Self::YoungModulus | Self::PoissonRatio
        )
    }
}

/// Named entries with their properties, such as `glass: mu=0.5, density=2500; steel: mu=0.2`.
///
/// ```
/// use tribos::grains::PropertyList;
/// let list: PropertyList = "glass; steel: mu=0.2, share=0.3".parse()?;
/// assert_eq!(list.to_string(), "glass; steel: mu=0.2, share=0.3");
/// let refused = "steel: mue=0.2".parse::<PropertyList>().map_err(|error| error.to_string());
/// assert!(refused.is_err_and(|text| text.ends_with("did you mean \"mu\"?")));
/// # Ok::<(), tribos::scene::SettingError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct PropertyList(Vec<Entry>);

/// One of them.
#[derive(Clone, Debug, PartialEq)]
struct Entry {
    name: String,
    properties: Vec<(Property, f64)>,
}

impl Entry {
    fn get(&self, property: Property) -> Option<f64> {
        let found = self.properties.iter().find(|(other, _)| *other == property);
        found.map(|(_, value)| *value)
    }

    /// What it says of a law, where Hertz's modulus does not follow from the materials.
    fn changes(&self, scene: &GrainsScene) -> LawChanges {
        LawChanges {
            sliding: self.get(Property::Mu),
            rolling: self.get(Property::MuRolling),
            torsion: self.get(Property::MuTorsion),
            restitution: self.get(Property::Restitution),
            cohesion: self.get(Property::Cohesion),
            stiffness: self
                .get(Property::Stiffness)
                .map(|k| scene.normal_law.spring(k, scene.radius)),
        }
    }
}

impl FromStr for Entry {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let (name, rest) = text.split_once(':').unwrap_or((text, ""));
        let name = name.trim();
        let is_name = |c: char| c.is_alphanumeric() || "_.-".contains(c);
        if name.is_empty() || !name.chars().all(is_name) {
            return Err(format!(
                "`{name}` must be a name of letters, digits, _ and ., or of two such names with - between them"
            ));
        }
        let mut properties: Vec<(Property, f64)> = Vec::new();
        for part in rest.split(',').filter(|_| !rest.trim().is_empty()) {
            let Some((word, value)) = part.split_once('=') else {
                let part = part.trim();
                return Err(format!("`{part}` must be PROPERTY=NUMBER such as mu=0.5"));
            };
            let (word, value) = (word.trim(), value.trim());
            let property: Property = word
                .parse()
                .map_err(|unknown| format!("a property {unknown}"))?;
            let number = finite_number(value).map_err(|why| format!("`{word}`: {why}"))?;
            let domain = property.domain();
            if !domain.admits(number) {
                return Err(format!(
                    "`{word}` must be {}, not {value}",
                    domain.describe()
                ));
            }
            if properties.iter().any(|(other, _)| *other == property) {
                return Err(format!("`{word}` is given twice; give it once"));
            }
            properties.push((property, number));
        }
        let name = name.into();
        Ok(Self { name, properties })
    }
}

impl FromStr for PropertyList {
    type Err = SettingError;

    fn from_str(text: &str) -> Result<Self, SettingError> {
        let mut entries: Vec<Entry> = Vec::new();
        for part in text.split(';').filter(|part| !part.trim().is_empty()) {
            let refused = |reason: String| SettingError::Entry {
                entry: part.trim().into(),
                reason,
            };
            let entry: Entry = part.parse().map_err(refused)?;
            if entries.iter().any(|other| other.name == entry.name) {
                return Err(refused(format!(
                    "`{}` is given twice; give each name once",
                    entry.name
                )));
            }
            entries.push(entry);
        }
        if entries.is_empty() {
            return Err(SettingError::Entry {
                entry: text.into(),
                reason: "name something, such as \"glass: mu=0.5; steel: mu=0.2\"".into(),
            });
        }
        Ok(Self(entries))
    }
}

impl fmt::Display for PropertyList {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let property = |(property, value): &(Property, f64)| format!("{property}={value}");
        let entry = |entry: &Entry| {
            let properties: Vec<String> = entry.properties.iter().map(property).collect();
            let colon = if properties.is_empty() { "" } else { ": " };
            format!("{}{colon}{}", entry.name, properties.join(", "))
        };
        let entries: Vec<String> = self.0.iter().map(entry).collect();
        f.write_str(&entries.join("; "))
    }
}

tribos_base::spelled!(PropertyList);

/// Materials by name.
pub(super) const MATERIALS: Domain = Domain::Form(&Form {
    name: "materials",
    valid: "materials such as \"glass: mu=0.5, density=2500; steel: mu=0.2, density=7800, share=0.3\"",
    read: reads::<PropertyList>,
    numbers: None,
    names_absence: true,
});

/// Laws by the names of two materials, or of one and the walls.
pub(super) const PAIRS: Domain = Domain::Form(&Form {
    name: "pairs",
    valid: "pairs such as \"glass-steel: mu=0.3, restitution=0.5; steel-walls: mu=0.1\"",
    read: reads::<PropertyList>,
    numbers: None,
    names_absence: true,
});

impl GrainsScene {
    /// Materials of the grains and their laws.
    pub(crate) fn mixture(&self) -> Mixture {
        let scene = self.scene_material();
        let Some(PropertyList(entries)) = &self.materials else {
            return Mixture::of_two(
                scene,
                &SecondMaterialKeys {
                    share: self.second_fraction,
                    radius: self.second_radius,
                    density: self.second_density,
                    sliding: self.mu_second,
                    sliding_mixed: self.mu_mixed,
                },
            );
        };
        let component = |entry: &Entry| {
            let density = entry.get(Property::Density);
            let alike = Material {
                density: density.unwrap_or(scene.density),
                stiffness: self.spring_of(Some(entry)),
                ..entry.changes(self).of(&scene)
            };
            Component {
                share: entry.get(Property::Share).unwrap_or(0.0),
                radius: entry.get(Property::Radius).unwrap_or(1.0),
                is_dense: density.is_some(),
                at_wall: self.changes([&entry.name, WALLS]).of(&alike),
                alike,
            }
        };
        Mixture::new(entries.iter().map(component).collect(), |pair| {
            self.changes(pair.map(|of| entries[of].name.as_str()))
        })
    }

    /// Normal spring of two grains of an entry, or of the scene.
    fn spring_of(&self, entry: Option<&Entry>) -> Stiffness {
        let of = |property| entry.and_then(|entry| entry.get(property));
        match of(Property::YoungModulus).or(self.young_modulus) {
            Some(young) => {
                let ratio = of(Property::PoissonRatio).unwrap_or(self.poisson_ratio);
                Stiffness::Hertz(0.5 * young / (1.0 - ratio * ratio))
            }
            None => {
                let stiffness = of(Property::Stiffness).unwrap_or(self.stiffness);
                self.normal_law.spring(stiffness, self.radius)
            }
        }
    }

    /// Law of two grains without what `materials` say.
    fn scene_material(&self) -> Material {
        Material {
            density: self.density,
            cohesion: self.pull_off(),
            cohesion_range: self.cohesion_range,
            attraction: self.attraction,
            restitution: self.restitution,
            sliding: self.mu,
            rolling: self.mu_rolling,
            torsion: self.mu_torsion,
            coupling: self.coupling,
            wall: self.wall_contact,
            stiffness: self.spring_of(None),
        }
    }

    /// What `pairs` says of two names in either order.
    fn changes(&self, [a, b]: [&str; 2]) -> LawChanges {
        let names = [format!("{a}-{b}"), format!("{b}-{a}")];
        let mut pairs = self.pairs.iter().flat_map(|list| &list.0);
        let entry = pairs.find(|entry| names.contains(&entry.name));
        entry.map_or(LawChanges::default(), |entry| entry.changes(self))
    }

    /// Whether Hertz's modulus follows from Young's of the scene or of a material.
    pub(super) fn has_young_modulus(&self) -> bool {
        self.young_modulus.is_some() || self.gives(Property::YoungModulus)
    }

    /// Whether an entry of the materials has a property.
    fn gives(&self, property: Property) -> bool {
        let mut entries = self.materials.iter().flat_map(|list| &list.0);
        entries.any(|entry| entry.get(property).is_some())
    }
}

/// What is wrong with an entry, and the cure.
type Objection = Option<String>;

/// Names, shares, springs and pairs must fit together, and to the other keys.
pub(super) fn rules(scene: &GrainsScene, judge: &mut SceneDiagnostics<'_>) {
    let Some(PropertyList(entries)) = &scene.materials else {
        if scene.pairs.is_some() {
            judge.refuse(
                &["pairs"],
                "`pairs` names `materials`; give them too, such as \"glass: mu=0.5; steel: mu=0.2\"",
            );
        }
        return;
    };
    let second = [
        ("second_fraction", scene.second_fraction > 0.0),
        ("second_radius", scene.second_radius != 1.0),
        ("second_density", scene.second_density.is_some()),
        ("mu_second", scene.mu_second.is_some()),
        ("mu_mixed", scene.mu_mixed.is_some()),
    ];
    if let Some((key, _)) = second.iter().find(|(_, is_given)| *is_given) {
        let message = format!(
            "give `materials` or `{key}`, not both: the second material of `materials` has share, radius, density and mu, and \
             `pairs` the mu of the two"
        );
        judge.refuse(&["materials", key], message);
    }
    for entry in entries {
        if let Some(message) = of_material(scene, entry) {
            judge.refuse(
                &["materials"],
                format!("`materials`: `{}`: {message}", entry.name),
            );
        }
    }
    if let Some(message) = of_all(scene, entries) {
        judge.refuse(&["materials"], format!("`materials`: {message}"));
    }
    let elastic = judge.is_given("stiffness") && scene.has_young_modulus();
    if elastic && scene.young_modulus.is_none() {
        let message = "give `stiffness` or the young_modulus of `materials`, not both";
        judge.refuse(&["stiffness", "materials"], message);
    }
    let is_linear = scene.normal_law == NormalForce::Linear && judge.is_given("normal_law");
    if is_linear && scene.gives(Property::YoungModulus) {
        let message = "young_modulus of `materials` is of Hertz's law: leave out `normal_law` = \"linear\", or give stiffness";
        judge.refuse(&["normal_law", "materials"], message);
    }
    let mut known: Vec<&Entry> = Vec::new();
    for pair in scene.pairs.iter().flat_map(|list| &list.0) {
        if let Some(message) = of_pair(scene, entries, (pair, &known)) {
            judge.refuse(&["pairs"], format!("`pairs`: `{}`: {message}", pair.name));
        }
        known.push(pair);
    }
}

/// Objections to one material.
fn of_material(scene: &GrainsScene, entry: &Entry) -> Objection {
    if entry.name == WALLS || entry.name.contains('-') {
        return Some("a material has another name than walls, without -".into());
    }
    if let Some(message) = of_method(scene, entry) {
        return Some(message);
    }
    if entry.get(Property::Radius).is_some() && scene.initial_state.is_some() {
        return Some("`initial_state` has its own radii; leave radius out".into());
    }
    if !scene.has_young_modulus() {
        let ratio = entry.get(Property::PoissonRatio);
        return ratio.map(|_| "poisson_ratio goes with young_modulus; give it too".into());
    }
    if entry.get(Property::Stiffness).is_some() {
        return Some("springs follow from young_modulus; leave stiffness out".into());
    }
    let own = entry.get(Property::YoungModulus).or(scene.young_modulus);
    own.is_none().then(|| {
        "give its young_modulus, as another material has one, or `young_modulus` of the scene"
            .into()
    })
}

/// The objection to springs of rigid grains.
fn of_method(scene: &GrainsScene, entry: &Entry) -> Objection {
    let elastic = entry.properties.iter().find(|(of, _)| of.is_elastic())?;
    (scene.method == ContactMethod::ContactDynamics).then(|| {
        format!(
            "{} is for method \"soft\" only; leave it out, or set method = \"soft\"",
            elastic.0
        )
    })
}

/// Objections to all materials together.
fn of_all(scene: &GrainsScene, entries: &[Entry]) -> Objection {
    let given = entries.len();
    if given > MOST {
        return Some(format!(
            "there are {given}, and at most {MOST} have types of their own"
        ));
    }
    let share = |entry: &Entry| entry.get(Property::Share).unwrap_or(0.0);
    let sum: f64 = entries.iter().map(share).sum();
    if sum > 1.0 + WHOLE {
        return Some(format!("the shares add up to {sum}, and to 1 at most"));
    }
    if entries[0].get(Property::Share).is_some() && sum < 1.0 - WHOLE {
        return Some(format!(
            "the first material, `{}`, has the rest of the grains; leave out its share, or let all shares add up to 1, not {sum}",
            entries[0].name
        ));
    }
    let mixture = scene.mixture();
    let is_coupled = mixture.widest().carried().coupling != FrictionCoupling::Independent;
    let is_lone = |law: &Material| law.torsion == 0.0 || law.sliding == 0.0;
    (is_coupled && mixture.all().any(is_lone)).then(|| {
        format!(
            "with coupling = \"{}\" all contacts have mu and mu_torsion above 0, or none has mu_torsion; give the others both, or \
             leave `coupling` out",
            scene.coupling
        )
    })
}

/// Objections to one pair, behind others.
fn of_pair(
    scene: &GrainsScene,
    entries: &[Entry],
    (pair, before): (&Entry, &[&Entry]),
) -> Objection {
    let names = || entries.iter().map(|entry| entry.name.as_str());
    let Some((a, b)) = pair.name.split_once('-') else {
        return Some(format!(
            "give two names such as \"{0}-{1}\", or \"{0}-{WALLS}\"",
            entries[0].name,
            names().nth(1).unwrap_or(WALLS)
        ));
    };
    let is_wall = b == WALLS;
    for name in [a, b] {
        if names().any(|known| known == name) || (name == b && is_wall) {
            continue;
        }
        let near = nearest(name, names().chain([WALLS]));
        let meant = near.map_or(String::new(), |near| format!("; did you mean `{near}`?"));
        let all: Vec<&str> = names().collect();
        return Some(format!(
            "there is no material `{name}`; there are {}, and {WALLS} behind one of them{meant}",
            all.join(", ")
        ));
    }
    if a == b {
        return Some(format!(
            "two grains of `{a}` have what `materials` says; give it there"
        ));
    }
    if before.iter().any(|other| other.name == format!("{b}-{a}")) {
        return Some(format!("it is given as `{b}-{a}` before; give it once"));
    }
    let foreign = pair.properties.iter().find(|(of, _)| !of.is_of_pairs());
    if let Some((property, _)) = foreign {
        return Some(format!(
            "{property} is of a material, not of a pair; give it in `materials`. A pair has mu, mu_rolling, mu_torsion, \
             restitution, cohesion and stiffness"
        ));
    }
    if let Some(message) = of_method(scene, pair) {
        return Some(message);
    }
    if pair.get(Property::Stiffness).is_some() && scene.has_young_modulus() {
        return Some("its modulus follows from young_modulus of both; leave stiffness out".into());
    }
    let is_idle = |property: Property| match (scene.wall_contact, property) {
        (WallLaw::Full, _) | (_, Property::Restitution | Property::Stiffness) => false,
        (WallLaw::Smooth, Property::Cohesion) => false,
        (WallLaw::Smooth | WallLaw::Bare, _) => is_wall,
    };
    let idle = pair.properties.iter().find(|(of, _)| is_idle(*of))?;
    Some(format!(
        "walls have no {} where wall_contact = \"{}\"; leave it out, or leave out `wall_contact`",
        idle.0, scene.wall_contact
    ))
}
