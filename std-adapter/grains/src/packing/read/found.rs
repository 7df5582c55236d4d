//! Spheres as columns of numbers, before they are checked.

use super::{Assembly, AssemblyError, PackingColumns, at_zero};
use crate::packing::mixed;
use nalgebra::Vector3;
use std::f64::consts::PI;
use tribos_base::exchange::sphere_columns::SphereColumn;
use tribos_base::exchange::spheres::Cell;
use tribos_base::space::PeriodicBox;

/// How messages name a row.
pub(super) enum RowName {
    /// Lines of the rows, from 1.
    Lines(Vec<usize>),
    /// The word before a number from 0.
    Numbered(&'static str),
}

/// What a file says of its spheres.
pub(super) struct FoundSpheres {
    columns: [Option<Vec<f64>>; SphereColumn::ALL.len()],
    pub cell: Cell,
    pub rows: RowName,
    /// What was left out of the file, or assumed.
    pub notes: Vec<String>,
}

impl FoundSpheres {
    /// Nothing yet, of a file whose rows have these names.
    pub fn new(rows: RowName) -> Self {
        Self {
            columns: Default::default(),
            cell: Cell::default(),
            rows,
            notes: Vec::new(),
        }
    }

    /// As [`FoundSpheres::new`], of a file that has places and radii, though it may be of no sphere.
    pub fn with_places(rows: RowName) -> Self {
        let mut found = Self::new(rows);
        for column in [
            SphereColumn::X,
            SphereColumn::Y,
            SphereColumn::Z,
            SphereColumn::Radius,
        ] {
            found.set(column, Vec::new());
        }
        found
    }

    /// Sets a column.
    pub fn set(&mut self, column: SphereColumn, values: Vec<f64>) {
        self.columns[column as usize] = Some(values);
    }

    /// Whether a column is there.
    pub fn has(&self, column: SphereColumn) -> bool {
        self.columns[column as usize].is_some()
    }

    /// Adds a number to a column.
    pub fn push(&mut self, column: SphereColumn, value: f64) {
        self.columns[column as usize]
            .get_or_insert_default()
            .push(value);
    }

    /// Adds the numbers of a vector that begins at a column.
    pub fn push_vector(&mut self, first: SphereColumn, values: [f64; 3]) {
        for (axis, value) in values.into_iter().enumerate() {
            self.columns[first as usize + axis]
                .get_or_insert_default()
                .push(value);
        }
    }

    /// Sets a vector that begins at a column, from triples of numbers.
    pub fn set_vector(&mut self, first: usize, triples: &[f64]) {
        for axis in 0..3 {
            let numbers = triples
                .as_chunks::<3>()
                .0
                .iter()
                .map(|triple| triple[axis])
                .collect();
            self.columns[first + axis] = Some(numbers);
        }
    }

    /// Adds the spheres of another piece of the file, which has the same columns.
    pub fn append(&mut self, piece: Self) {
        for (mine, theirs) in self.columns.iter_mut().zip(piece.columns) {
            if let Some(theirs) = theirs {
                mine.get_or_insert_default().extend(theirs);
            }
        }
    }

    fn row(&self, at: usize) -> String {
        match &self.rows {
            RowName::Lines(lines) => match lines.get(at) {
                Some(line) => format!("line {line}"),
                None => format!("row {at} (from 0)"),
            },
            RowName::Numbered(word) => format!("{word} {at}"),
        }
    }

    /// A column whose values are within a range, with one for each of `count` spheres.
    fn take(
        &mut self,
        column: SphereColumn,
        count: usize,
        (is_valid, valid): (fn(f64) -> bool, &str),
    ) -> Result<Option<Vec<f64>>, String> {
        let Some(values) = self.columns[column as usize].take() else {
            return Ok(None);
        };
        let name = column.name();
        if values.len() != count {
            let (word, given) = (self.word(), values.len());
            return Err(format!(
                "{count} {word} need as many values of {name}, not {given}"
            ));
        }
        match values.iter().position(|value| !is_valid(*value)) {
            Some(at) => Err(format!(
                "{}: the {name} must be {valid}, not {}",
                self.row(at),
                values[at]
            )),
            None => Ok(Some(values)),
        }
    }

    fn word(&self) -> String {
        match &self.rows {
            RowName::Lines(_) => "rows".into(),
            RowName::Numbered(word) => format!("{word}s"),
        }
    }

    /// Three columns as vectors; none if the file has none of them.
    fn vectors(
        &mut self,
        first: SphereColumn,
        count: usize,
    ) -> Result<Option<Vec<Vector3<f64>>>, String> {
        let mut all: Option<Vec<Vector3<f64>>> = None;
        for axis in 0..3 {
            let column = SphereColumn::ALL[first as usize + axis];
            if let Some(values) = self.take(column, count, (f64::is_finite, "a finite number"))? {
                let all = all.get_or_insert_with(|| vec![Vector3::zeros(); count]);
                all.iter_mut()
                    .zip(values)
                    .for_each(|(vector, value)| vector[axis] = value);
            }
        }
        Ok(all)
    }

    /// The spheres, checked, with what the user says of all of them; `cure` says how a file without radii gets them.
    pub fn checked(
        mut self,
        file: &str,
        columns: Option<&PackingColumns>,
        cure: &str,
    ) -> Result<Assembly, AssemblyError> {
        let refused = |reason: String| AssemblyError::Content {
            file: file.into(),
            reason,
        };
        let lengths = self.columns.iter().flatten().map(Vec::len);
        let count = match &self.columns[0] {
            Some(places) => places.len(),
            None => lengths.max().unwrap_or(0),
        };
        for column in SphereColumn::ALL {
            if let Some(value) = columns.and_then(|columns| columns.of_all(column)) {
                self.set(column, vec![value; count]);
            }
        }
        let positive: (fn(f64) -> bool, &str) = (
            |value| value.is_finite() && value > 0.0,
            "a finite number > 0",
        );
        let diameters = self
            .take(SphereColumn::Diameter, count, positive)
            .map_err(refused)?;
        let halved = diameters.map(|all| all.into_iter().map(|diameter| 0.5 * diameter).collect());
        let radii: Option<Vec<f64>> = self
            .take(SphereColumn::Radius, count, positive)
            .map_err(refused)?
            .or(halved);
        let Some(radii) = radii else {
            return Err(refused(format!("there are no radii; {cure}")));
        };
        for axis in [SphereColumn::X, SphereColumn::Y, SphereColumn::Z] {
            if self.columns[axis as usize].is_none() {
                let name = axis.name();
                return Err(refused(format!(
                    "there is no column {name}; name it, or give `{name}=all:0`, by --columns (key `columns`)"
                )));
            }
        }
        let masses = self
            .take(SphereColumn::Mass, count, positive)
            .map_err(refused)?;
        let of_mass = |all: Vec<f64>| -> Vec<f64> {
            let volumes = radii
                .iter()
                .map(|radius| 4.0 / 3.0 * PI * radius * radius * radius);
            all.into_iter()
                .zip(volumes)
                .map(|(mass, volume)| mass / volume)
                .collect()
        };
        let densities = self
            .take(SphereColumn::Density, count, positive)
            .map_err(refused)?;
        let densities = densities.or(masses.map(of_mass));
        let places = self.vectors(SphereColumn::X, count).map_err(refused)?;
        let velocities = self
            .vectors(SphereColumn::VelocityX, count)
            .map_err(refused)?;
        let spins = self.vectors(SphereColumn::SpinX, count).map_err(refused)?;
        let materials = self.materials(count).map_err(refused)?;
        let lengths = |bounds: [[f64; 2]; 3]| {
            std::array::from_fn(|axis| {
                self.cell.is_periodic[axis].then_some(bounds[axis][1] - bounds[axis][0])
            })
        };
        let space = self.cell.bounds.map_or(Ok(PeriodicBox::OPEN), |bounds| {
            PeriodicBox::new(lengths(bounds))
        });
        let space = space.map_err(|cause| AssemblyError::Space {
            file: file.into(),
            cause,
        })?;
        let mut positions = places.unwrap_or_default();
        let bounds = self
            .cell
            .bounds
            .map(|bounds| at_zero(&mut positions, &space, bounds));
        let mut assembly = Assembly {
            materials,
            densities,
            is_assumed: self.cell.is_silent,
            velocities,
            spins,
            notes: self.notes,
            ..Assembly::new(space.sheared(self.cell.tilt), positions, radii)
        };
        if let Some(bounds) = bounds {
            (assembly.bounds, assembly.has_box) = (bounds, true);
        }
        Ok(assembly)
    }

    /// Numbers of the materials, from 1; those of files that count from 0 are one more.
    fn materials(&mut self, count: usize) -> Result<Option<Vec<u8>>, String> {
        let whole: (fn(f64) -> bool, &str) = (
            |value| value.fract() == 0.0 && (0.0..=f64::from(u8::MAX)).contains(&value),
            "a whole number from 0 to 255",
        );
        let Some(values) = self.take(SphereColumn::Material, count, whole)? else {
            return Ok(None);
        };
        let from_zero = values.contains(&0.0);
        if from_zero && values.contains(&f64::from(u8::MAX)) {
            return Err("its types count from 0 to 255, and at most 255 are kept".into());
        }
        let materials: Vec<u8> = values
            .into_iter()
            .map(|value| value as u8 + u8::from(from_zero))
            .collect();
        Ok(mixed(&materials).then_some(materials))
    }
}
