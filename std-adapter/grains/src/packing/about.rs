//! What a packing is, for a person who asks what was understood of a file.

use super::Assembly;
use std::f64::consts::PI;
use tribos_base::space::{AXES, SpaceError};

/// Depth in smaller radii, and the two spheres.
pub(crate) type Overlap = (f64, [u32; 2]);

impl Assembly {
    /// What is known of the spheres, each line with its name: number and radii, densities, types, motion, box with periods and
    /// tilt, solid fraction, contacts and the deepest overlap; `shown` writes a number.
    ///
    /// ```
    /// use tribos::measure::Assembly;
    /// let pair = Assembly::parse("pair.txt", "0 0 0 1\n0 0 1.9 1\n")?;
    /// let lines = pair.about(&|x| format!("{x:.1}"));
    /// assert_eq!(lines[0], ("format", "table between blanks".into()));
    /// assert_eq!(lines[1], ("spheres", "2, all of radius 1.0".into()));
    /// assert!(lines.contains(&("overlap", "10.0 % of the smaller radius at most, spheres 0 and 1 (from 0)".into())));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn about(&self, shown: &dyn Fn(f64) -> String) -> Vec<(&'static str, String)> {
        let mut lines = Vec::new();
        if let Some(format) = self.format {
            lines.push(("format", format.name().into()));
        }
        lines.push((
            "spheres",
            format!(
                "{}, {}",
                self.radii.len(),
                range(shown, &self.radii, "all of radius", "radii from")
            ),
        ));
        let densities = self.densities.as_ref();
        let densities = densities.map_or(NONE.into(), |all| range(shown, all, "", "from"));
        lines.push(("density", densities));
        lines.push(("types", self.types()));
        for (name, vectors) in [("velocities", &self.velocities), ("spins", &self.spins)] {
            let largest = vectors
                .iter()
                .flatten()
                .map(|vector| vector.norm())
                .reduce(f64::max);
            lines.push((
                name,
                match (vectors, largest) {
                    (None, _) => NONE.into(),
                    (_, Some(largest)) if largest > 0.0 => format!("up to {}", shown(largest)),
                    _ => "all 0".into(),
                },
            ));
        }
        lines.push(("box", self.room(shown)));
        if self.has_box || self.space.lengths().iter().all(Option::is_some) {
            let solid: f64 = self
                .radii
                .iter()
                .map(|radius| 4.0 / 3.0 * PI * radius * radius * radius)
                .sum();
            lines.push(("solid fraction", shown(solid / self.volume())));
        }
        match self.overlaps() {
            Ok((contacts, deepest)) => {
                lines.push(("contacts", contacts.to_string()));
                let words = |(depth, [a, b]): (f64, [u32; 2])| {
                    format!(
                        "{} % of the smaller radius at most, spheres {a} and {b} (from 0)",
                        shown(100.0 * depth)
                    )
                };
                lines.push((
                    "overlap",
                    deepest
                        .filter(|(depth, _)| *depth > 0.0)
                        .map_or("none".into(), words),
                ));
            }
            Err(error) => lines.push(("contacts", format!("not counted: {error}"))),
        }
        lines.extend(self.notes.iter().map(|note| ("note", note.clone())));
        lines
    }

    /// Numbers of the spheres of each type.
    fn types(&self) -> String {
        let Some(materials) = &self.materials else {
            return "all of one".into();
        };
        let mut counts = [0_u64; 256];
        materials
            .iter()
            .for_each(|material| counts[usize::from(*material)] += 1);
        let all = counts.iter().enumerate().filter(|(_, count)| **count > 0);
        let words: Vec<String> = all
            .map(|(material, count)| format!("{count} of {material}"))
            .collect();
        words.join(", ")
    }

    /// Ends of the box, which axes repeat, and how far it leans.
    fn room(&self, shown: &dyn Fn(f64) -> String) -> String {
        let lengths = self.space.lengths();
        let periodic: Vec<&str> = AXES
            .iter()
            .zip(lengths)
            .filter(|(_, length)| length.is_some())
            .map(|(name, _)| *name)
            .collect();
        if !self.has_box && periodic.is_empty() {
            return NONE.into();
        }
        let ends = AXES.iter().zip(self.bounds);
        let ends: Vec<String> = ends
            .map(|(name, [low, high])| format!("{name} {} to {}", shown(low), shown(high)))
            .collect();
        let mut text = ends.join(", ");
        text += &match periodic.len() {
            0 => "; open".into(),
            _ => format!("; periodic along {}", periodic.join(", ")),
        };
        if self.is_assumed {
            text += ", which the file does not say (--periods)";
        }
        let tilt = self.space.offset();
        if tilt != 0.0 {
            text += &format!("; leans along x over z by {}", shown(tilt));
        }
        text
    }

    /// Number of pairs that touch, and the deepest overlap over the smaller radius with its spheres.
    pub(crate) fn overlaps(&self) -> Result<(usize, Option<Overlap>), SpaceError> {
        let mut touching = Self::new(self.space, self.positions.clone(), self.radii.clone());
        touching.touch(0.0)?;
        Ok((touching.contacts.len(), self.deepest(|_| true)?))
    }
}

/// What a file does not say.
const NONE: &str = "not in the file";

/// The least and the largest of some numbers.
fn range(shown: &dyn Fn(f64) -> String, all: &[f64], one: &str, several: &str) -> String {
    let [least, most] = all
        .iter()
        .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| {
            [low.min(*x), high.max(*x)]
        });
    let text = if all.is_empty() {
        String::new()
    } else if least == most {
        format!("{one} {}", shown(least))
    } else {
        let mean = all.iter().sum::<f64>() / all.len() as f64;
        format!(
            "{several} {} to {}, mean {}",
            shown(least),
            shown(most),
            shown(mean)
        )
    };
    text.trim().into()
}
