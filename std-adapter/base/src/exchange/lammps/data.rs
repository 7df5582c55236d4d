//! Reading a data file.

use super::header::{Header, section};
use crate::exchange::atoms::Atoms;
use crate::exchange::configuration::Configuration;
use crate::exchange::spheres::{Spheres, Weight};
use crate::exchange::text::{Line, Lines, TextError};
use nalgebra::Vector3;
use std::collections::HashMap;

/// The atoms of a data file (`atom_style atomic`), taken as periodic along all axes, which the file
/// does not specify. Image flags move an atom by whole periods.
///
/// ```
/// use tribos::md::lammps::read_data;
/// let text = "Argon\n\n2 atoms\n1 atom types\n0 4 xlo xhi\n0 4 ylo yhi\n0 4 zlo zhi\n\n\
///             Masses\n\n1 39.948\n\nAtoms # atomic\n\n1 1 0.5 2 2\n2 1 3.5 2 2 -1 0 0\n";
/// let argon = read_data(text)?;
/// assert_eq!(argon.atoms.masses, [39.948]);
/// let places = &argon.atoms.positions;
/// assert_eq!(places[1].x, -0.5); // its image one period back
/// assert_eq!(argon.space()?.displacement(&places[0], &places[1]).norm(), 1.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn read_data(text: &str) -> Result<Configuration, TextError> {
    let reader = read(text, Style::Atomic)?;
    reader.spheres.upright()?;
    Ok(reader.configuration)
}

/// The spheres of a data file (`atom_style sphere`).
pub fn read_spheres(text: &str) -> Result<(Configuration, Spheres), TextError> {
    let reader = read(text, Style::Sphere)?;
    Ok((reader.configuration, reader.spheres))
}

/// Number and velocity of an atom, and the angular velocity of a sphere.
type Motion<'a> = ([&'a str; 4], Option<[&'a str; 3]>);

/// Style of the atoms of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Style {
    Atomic,
    Sphere,
}

impl Style {
    /// Name in the heading of the section Atoms.
    fn name(self) -> &'static str {
        match self {
            Self::Atomic => "atomic",
            Self::Sphere => "sphere",
        }
    }

    fn cure(self) -> &'static str {
        match self {
            Self::Atomic => "write the file with atom_style atomic",
            Self::Sphere => "write the file with atom_style sphere",
        }
    }

    /// Words of a line before the image flags, and which of them is x.
    fn words(self) -> (usize, usize) {
        match self {
            Self::Atomic => (5, 2),
            Self::Sphere => (7, 4),
        }
    }
}

fn read(text: &str, style: Style) -> Result<Reader, TextError> {
    let mut lines = Lines::new(text);
    let header = Header::read(&mut lines)?;
    let mut reader = Reader::new(header, style);
    while let Some(line) = lines.next() {
        match section(line) {
            Some("Masses") => reader.masses(&mut lines)?,
            Some("Atoms") => reader.atoms(line, &mut lines)?,
            Some("Velocities") => reader.velocities(&mut lines)?,
            // Parameters of potentials, which are given elsewhere.
            Some("Pair Coeffs" | "PairIJ Coeffs") => while body(&mut lines).is_some() {},
            Some(other) => {
                return Err(TextError::Unsupported {
                    line: line.number,
                    what: format!("the section `{other}`"),
                    cure: match style {
                        Style::Atomic => {
                            "known are Masses, Atoms and Velocities; write the file with atom_style atomic"
                        }
                        Style::Sphere => {
                            "known are Masses, Atoms and Velocities; write the file with atom_style sphere"
                        }
                    },
                });
            }
            None if line.without_comment().text.is_empty() => {}
            None => {
                let valid = "the name of a section: Masses, Atoms or Velocities";
                return Err(line.invalid("what follows a section", valid, line.text.trim()));
            }
        }
    }
    reader.finish(lines)
}

/// The next line of a section; none at its end.
fn body<'a>(lines: &mut Lines<'a>) -> Option<Line<'a>> {
    lines.skip_blank();
    let line = lines.peek().filter(|&line| section(line).is_none())?;
    lines.next();
    Some(line.without_comment())
}

struct Reader {
    header: Header,
    style: Style,
    spheres: Spheres,
    configuration: Configuration,
    index_of: HashMap<u64, usize>,
}

impl Reader {
    fn new(header: Header, style: Style) -> Self {
        let mut atoms = Atoms::at(Vec::new());
        atoms.masses = vec![1.0; header.species];
        Self {
            header,
            style,
            spheres: Spheres::default(),
            configuration: Configuration {
                atoms,
                ids: Vec::new(),
                names: None,
                bounds: header.bounds,
                has_box: true,
                is_periodic: [true; 3],
                step: 0,
                forces: None,
            },
            index_of: HashMap::new(),
        }
    }

    fn species(&self, line: Line, word: &str) -> Result<usize, TextError> {
        let range = 1..=self.header.species as u64;
        Ok(line.whole("the type", range, word)? as usize - 1)
    }

    fn masses(&mut self, lines: &mut Lines) -> Result<(), TextError> {
        let mut is_given = vec![false; self.header.species];
        for _ in 0..self.header.species {
            let Some(line) = body(lines) else {
                return Err(cut(lines, "a mass", self.header.species, "Masses"));
            };
            let words = line.words();
            let &[species, mass] = words.as_slice() else {
                return Err(line.invalid("a line of Masses", "TYPE MASS", line.text));
            };
            let index = self.species(line, species)?;
            if std::mem::replace(&mut is_given[index], true) {
                return Err(twice(line, "the mass of type", species));
            }
            self.configuration.atoms.masses[index] = line.positive("the mass", mass)?;
        }
        Ok(())
    }

    fn atoms(&mut self, heading: Line, lines: &mut Lines) -> Result<(), TextError> {
        if let Some((_, style)) = heading.text.split_once('#')
            && style.trim() != self.style.name()
        {
            return Err(TextError::Unsupported {
                line: heading.number,
                what: format!("the atom style `{}`", style.trim()),
                cure: self.style.cure(),
            });
        }
        let is_sphere = self.style == Style::Sphere;
        self.spheres = Spheres::begin(heading, [is_sphere, false, is_sphere]);
        self.spheres.tilt = self.header.tilt;
        self.spheres.is_silent = true;
        if !self.configuration.ids.is_empty() {
            return Err(twice(heading, "the section", "Atoms"));
        }
        for _ in 0..self.header.atoms {
            let Some(line) = body(lines) else {
                return Err(cut(lines, "an atom", self.header.atoms, "Atoms"));
            };
            self.atom(line)?;
        }
        Ok(())
    }

    fn atom(&mut self, line: Line) -> Result<(), TextError> {
        let words = line.words();
        let (count, at) = self.style.words();
        if words.len() != count && words.len() != count + 3 {
            return Err(wrong_atom(line, self.style));
        }
        let (words, flags) = words.split_at(count);
        let (id, species, [x, y, z]) = (
            words[0],
            words[1],
            [words[at], words[at + 1], words[at + 2]],
        );
        if self.style == Style::Sphere {
            self.spheres.add_radius(line, words[2], 0.5)?;
            self.spheres.add_density(line, words[3], Weight::Density)?;
        }
        let number = line.whole("the number of an atom", 1..=u64::MAX, id)?;
        let index = self.configuration.ids.len();
        if self.index_of.insert(number, index).is_some() {
            return Err(twice(line, "atom", id));
        }
        let mut place = vector(line, "a coordinate", [x, y, z])?;
        let lengths = self.configuration.lengths();
        for (axis, flag) in flags.iter().enumerate() {
            let images: i32 = flag
                .parse()
                .map_err(|_| line.invalid("an image flag", "a whole number", flag))?;
            if images != 0 {
                place[axis] += f64::from(images) * lengths[axis];
                if axis == 2 {
                    place.x += f64::from(images) * self.header.tilt;
                }
            }
        }
        let species = self.species(line, species)? as u8;
        self.configuration.ids.push(number);
        self.configuration.atoms.positions.push(place);
        self.configuration.atoms.velocities.push(Vector3::zeros());
        self.configuration.atoms.species.push(species);
        Ok(())
    }

    fn velocities(&mut self, lines: &mut Lines) -> Result<(), TextError> {
        let mut is_given = vec![false; self.configuration.ids.len()];
        for _ in 0..self.header.atoms {
            let Some(line) = body(lines) else {
                return Err(cut(lines, "a velocity", self.header.atoms, "Velocities"));
            };
            let words = line.words();
            let ([id, x, y, z], spin) = self.velocity_words(line, &words)?;
            let number = line.whole("the number of an atom", 1..=u64::MAX, id)?;
            let Some(&index) = self.index_of.get(&number) else {
                let valid = "that of an atom in the section Atoms, which stands before";
                return Err(line.invalid("the number of an atom", valid, id));
            };
            if std::mem::replace(&mut is_given[index], true) {
                return Err(twice(line, "the velocity of atom", id));
            }
            self.configuration.atoms.velocities[index] = vector(line, "a velocity", [x, y, z])?;
            if let Some(words) = spin {
                let count = self.configuration.ids.len();
                let spins = self
                    .spheres
                    .spins
                    .get_or_insert_with(|| vec![Vector3::zeros(); count]);
                spins[index] = vector(line, "an angular velocity", words)?;
            }
        }
        Ok(())
    }

    /// Number and velocity, and the angular velocity of a sphere.
    fn velocity_words<'a>(&self, line: Line, words: &[&'a str]) -> Result<Motion<'a>, TextError> {
        let wrong = |valid: &str| line.invalid("a line of Velocities", valid, line.text);
        match (words, self.style) {
            (&[id, x, y, z], Style::Atomic) => Ok(([id, x, y, z], None)),
            (&[id, x, y, z, wx, wy, wz], Style::Sphere) => Ok(([id, x, y, z], Some([wx, wy, wz]))),
            (_, Style::Atomic) => Err(wrong("ID VX VY VZ")),
            (_, Style::Sphere) => Err(wrong("ID VX VY VZ WX WY WZ")),
        }
    }

    fn finish(self, mut lines: Lines) -> Result<Self, TextError> {
        if self.configuration.ids.len() != self.header.atoms {
            lines.need("the section Atoms", "is the file cut short?")?;
        }
        self.configuration.atoms.check()?;
        Ok(self)
    }
}

pub(super) fn vector(
    line: Line,
    what: &'static str,
    words: [&str; 3],
) -> Result<Vector3<f64>, TextError> {
    let [x, y, z] = words.map(|word| line.number(what, word));
    Ok(Vector3::new(x?, y?, z?))
}

fn twice(line: Line, what: &'static str, given: &str) -> TextError {
    TextError::Twice {
        line: line.number,
        what,
        given: given.into(),
    }
}

fn cut(lines: &mut Lines, what: &'static str, count: usize, section: &str) -> TextError {
    let cure = format!("{section} needs {count} lines");
    lines.here().missing(what, cure)
}

fn wrong_atom(line: Line, style: Style) -> TextError {
    let valid = match style {
        Style::Atomic => "ID TYPE X Y Z, and three image flags or none (atom_style atomic)",
        Style::Sphere => {
            "ID TYPE DIAMETER DENSITY X Y Z, and three image flags or none (atom_style sphere)"
        }
    };
    line.invalid("a line of Atoms", valid, line.text)
}
