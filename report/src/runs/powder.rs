//! Pictures of a compaction: the packing at both ends, and series over time.

use crate::drawing_grid::DrawingGrid;
use crate::figure::{Axis, Figure, Panels, ReferenceLine, Series};
use crate::packing::{Contact, Packing, PackingError, PackingPicture};
use tribos::powder::{PowderSimulation, PowderSummary};
use tribos::record::{ContactRow, Snapshot};
use tribos::scene::PowderScene;

/// Initial and final spheres in one scale, and the final forces.
pub fn packing(
    scene: &PowderScene,
    [before, after]: &[State; 2],
    outcome: &PowderSummary,
) -> Result<DrawingGrid, PackingError> {
    let top = outcome.heights[0];
    let percent = outcome.porosity.map(|porosity| 100.0 * porosity);
    let title = |name: &str, percent: f64| format!("{name}, {percent:.1} % empty");

    // Both are coloured by height in the deposit, which shows how layers sink and mix.
    let layers: Vec<f64> = before.positions.iter().map(|[_, _, z]| *z).collect();
    let picture = |name: &str, percent: f64, packing: &Packing<'_>| {
        let picture = PackingPicture::spheres(title(name, percent), packing).headroom(top);
        picture.color_by(Axis::linear("initial height"), &layers)
    };
    let initial = before.packing(scene.width, outcome.heights[0])?;
    let blocked = after.packing(scene.width, outcome.heights[1])?;
    let largest = after
        .contacts
        .iter()
        .map(|contact| contact.normal_force.abs());
    let forces = PackingPicture::forces("Final forces", &blocked, &after.contacts)?
        .full_force(largest.fold(0.0, f64::max), "F_coh");
    let (mu, mu_t, mu_n) = (scene.mu, scene.mu_rolling, scene.mu_torsion);
    let name = format!("Compaction, μ = {mu}, μ_t = {mu_t}, μ_n = {mu_n}");
    Ok(DrawingGrid::new(name, 3)
        .drawing(picture("Initial", percent[0], &initial)?)
        .drawing(picture("Final", percent[1], &blocked)?)
        .drawing(forces.headroom(top)))
}

/// Porosity, stress and energies over time.
pub fn series(compaction: &PowderSimulation, outcome: &PowderSummary) -> Panels {
    let rows = compaction.series();
    let curve = |column: usize| rows.iter().map(|row| (row[0], row[column])).collect();
    let time = || Axis::linear("time [√(ρR⁴/F_coh)]");
    let porosity = Figure::new("", time(), Axis::linear("porosity"))
        .series(Series::line("", curve(3)))
        .guide(ReferenceLine::horizontal(outcome.porosity[1], ""));
    let stress = Figure::new("", time(), Axis::linear("σ_zz of the pressure"))
        .series(Series::line("", curve(5)))
        .guide(ReferenceLine::horizontal(1.0, "applied"));
    let contacts =
        Figure::new("", time(), Axis::linear("contacts")).series(Series::line("", curve(4)));
    let mut energies = Figure::new("", time(), Axis::linear("energy [F_coh R]"))
        .series(Series::dashed("work", curve(14)));
    for (name, column) in [
        ("normal", 9),
        ("sliding", 10),
        ("rolling", 11),
        ("torsion", 12),
        ("cohesion", 13),
    ] {
        energies = energies.series(Series::line(name, curve(column)));
    }
    Panels::new("", 2)
        .figure(porosity)
        .figure(stress)
        .figure(contacts)
        .figure(energies)
}

/// A snapshot for pictures.
#[derive(Debug)]
pub struct State {
    /// Centres.
    pub positions: Vec<[f64; 3]>,
    radii: Vec<f64>,
    contacts: Vec<Contact>,
}

impl State {
    /// The initial deposit and the current state.
    pub fn both(compaction: &PowderSimulation) -> [Self; 2] {
        let before = Self::of(&compaction.deposit().snapshot(&[]));
        [before, compaction.with_snapshot(Self::of)]
    }

    /// A snapshot.
    pub(super) fn of(snapshot: &Snapshot<'_>) -> Self {
        let contact = |row: &ContactRow| Contact {
            a: row.a as usize,
            b: row.b.particle().map(|b| b as usize),
            normal_force: row.normal_force(),
        };
        Self {
            positions: snapshot.positions.iter().map(|x| [x.x, x.y, x.z]).collect(),
            radii: snapshot.radii.to_vec(),
            contacts: snapshot.contacts.iter().map(contact).collect(),
        }
    }

    /// The packing without a piston, in a cell of these sides.
    pub(super) fn open(&self, sides: [f64; 2]) -> Result<Packing<'_>, PackingError> {
        Packing::new(&self.positions, &self.radii, sides, None)
    }

    /// Contacts with their forces.
    pub(super) fn contacts(&self) -> &[Contact] {
        &self.contacts
    }

    /// The largest magnitude of a normal force.
    pub(super) fn largest_force(&self) -> f64 {
        let forces = self.contacts.iter().map(|contact| contact.normal_force);
        forces.map(f64::abs).fold(0.0, f64::max)
    }

    fn packing(&self, width: f64, height: f64) -> Result<Packing<'_>, PackingError> {
        Packing::new(&self.positions, &self.radii, [width; 2], Some(height))
    }
}
