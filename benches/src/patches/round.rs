//! Round patches: tables, closed forms and the compact tier under power laws; the quadrature under
//! all laws.

use super::area::{Moments, Pressure};
use super::laws::{self, ForLaw, Friction};
use super::tables::{self, Source};
use super::{Case, Entry, Label, Refused, SEED, precision};
use crate::methods::as_pair;
use crate::mix;
use crate::reference::Wide;
use tribos_core::coupling::quadrature::DiskQuadrature;
use tribos_core::coupling::round::{PolynomialTable, RoundTable32, RoundTable64};
use tribos_core::coupling::table::{self, CoulombTable, Table32, Table64};
use tribos_core::coupling::{Annulus, Coupling, Lateral, closed, compact};
use tribos_core::law::{LawError, LocalLaw};
use tribos_core::patch::{PolynomialPressure, PowerPressure};
use tribos_core::real::Real;

/// Inner over outer radius of the annulus.
pub const INNER: f64 = 0.9;
/// Table tiers are timed on every `TABLE_STRIDE`-th pair, others on fewer: equal work for all tiers.
pub const TABLE_STRIDE: usize = 4;
const COMPACT_STRIDE: usize = 20;
/// Also for nodes.
pub const SLOW_STRIDE: usize = 80;
/// Pairs judged by integration over the area, and the ratios at which it has its digits.
const AREA_PAIRS: usize = 48;
const AREA_RATIOS: core::ops::Range<f64> = 1e-3..1e3;

/// The tables of one precision.
pub trait Tables: CoulombTable {
    /// Of the uniform disk.
    type Disk: Lateral<Self> + 'static;
    /// Of the other pressures.
    type Round: Coupling<Self> + 'static;
    /// Of the uniform disk.
    fn disk(alpha: f64) -> Result<Self::Disk, LawError>;
    /// Of another pressure.
    fn round(alpha: f64, pressure: PowerPressure) -> Result<Self::Round, LawError>;
}

impl Tables for f64 {
    type Disk = Table64;
    type Round = RoundTable64;
    fn disk(alpha: f64) -> Result<Table64, LawError> {
        Table64::new(alpha)
    }
    fn round(alpha: f64, pressure: PowerPressure) -> Result<RoundTable64, LawError> {
        RoundTable64::new(alpha, pressure)
    }
}

impl Tables for f32 {
    type Disk = Table32;
    type Round = RoundTable32;
    fn disk(alpha: f64) -> Result<Table32, LawError> {
        Table32::new(alpha as f32)
    }
    fn round(alpha: f64, pressure: PowerPressure) -> Result<RoundTable32, LawError> {
        RoundTable32::new(alpha as f32, pressure)
    }
}

/// The pressures (1−r²)^q, where their references are, and what the judge calls them.
const POWERS: [(&str, &str, PowerPressure); 5] = [
    ("disk", "uniform", PowerPressure::UNIFORM),
    ("ring", "ring", PowerPressure::RING),
    ("punch", "punch", PowerPressure::FLAT_PUNCH),
    ("Hertz", "hertz", PowerPressure::HERTZ),
    ("paraboloid", "paraboloid", PowerPressure::PARABOLOID),
];

/// Eight mixes in a row, thinned: what everything is timed on.
pub fn timed(stride: usize) -> Vec<[f64; 2]> {
    let pairs = mix::long_pairs(SEED);
    pairs.into_iter().step_by(stride).collect()
}

/// Speeds as the type `R` has them.
pub fn rounded<R: Real>(pair: [f64; 2]) -> [f64; 2] {
    pair.map(|speed| R::from_f64(speed).to_f64())
}

/// Cases judged by integration over the area.
pub fn area_cases<R: Real>(pressure: Pressure, friction: &Friction) -> Vec<Case> {
    let pairs = mix::pairs(SEED).into_iter();
    let pairs = pairs.filter(|[v, w]| AREA_RATIOS.contains(&(v / w)));
    let case = |pair| {
        let speeds = rounded::<R>(pair);
        let moments = Moments::new(pressure, friction, speeds);
        let exact = [moments.force, moments.torque].map(Wide::new);
        Case { speeds, exact }
    };
    pairs.take(AREA_PAIRS).map(case).collect()
}

/// Cases of a power law: from the reference tables in f64, from `wide` at rounded speeds in f32.
fn power_cases<R: Real>(source: Source, alpha: f64, wide: &impl Coupling<f64>) -> Vec<Case> {
    if precision::<R>() == "f64" {
        return tables::cases(source, alpha);
    }
    let case = |pair| {
        let speeds = rounded::<R>(pair);
        let exact = as_pair(wide.reduced_wrench(speeds[0], speeds[1])).map(Wide::new);
        Case { speeds, exact }
    };
    mix::pairs(SEED).into_iter().map(case).collect()
}

/// The judge of power laws.
fn judge<R: Real>() -> &'static str {
    if precision::<R>() == "f64" {
        "tables"
    } else {
        "f64"
    }
}

/// A coupling as a row.
fn coupled<R: Real, C: Coupling<R> + 'static>(
    label: Label,
    bytes: usize,
    (cases, stride): (&[Case], usize),
    coupling: C,
) -> Entry {
    Entry::new(label, bytes, cases, &timed(stride), move |slide, rim| {
        as_pair(coupling.reduced_wrench(slide, rim))
    })
}

/// Power laws on the pressures (1−r²)^q and the annulus, all tiers but the quadrature.
pub fn powers<R: Tables>() -> Result<Vec<Entry>, Refused> {
    let mut rows = Vec::new();
    for (alpha, law) in laws::POWERS {
        for (patch, file, pressure) in POWERS {
            let wide = compact::Power::with_pressure(alpha, pressure)?;
            let cases = power_cases::<R>(Source::File(file), alpha, &wide);
            let label = |tier| Label {
                patch,
                law,
                tier,
                judge: judge::<R>(),
            };
            let quick = (cases.as_slice(), TABLE_STRIDE);
            let row = if pressure != PowerPressure::UNIFORM {
                let table = R::round(alpha, pressure)?;
                coupled::<R, _>(label("table"), size_of::<R::Round>(), quick, table)
            } else if alpha == 0.0 {
                let bytes = size_of::<R::Table>();
                coupled::<R, _>(label("table"), bytes, quick, table::Coulomb)
            } else {
                let bytes = size_of::<R::Disk>();
                coupled::<R, _>(label("table"), bytes, quick, R::disk(alpha)?)
            };
            rows.push(row);
            if alpha == 0.0 {
                rows.extend(in_closed_form::<R>(label("closed"), quick));
            }
            let power = compact::Power::with_pressure(R::from_f64(alpha), pressure)?;
            let slow = (cases.as_slice(), COMPACT_STRIDE);
            let bytes = size_of_val(&power);
            rows.push(coupled::<R, _>(label("compact"), bytes, slow, power));
        }
        rows.extend(annulus::<R>(alpha, law)?);
    }
    Ok(rows)
}

/// Coulomb friction without table or series; not known for the paraboloid.
fn in_closed_form<R: Real>(label: Label, cases: (&[Case], usize)) -> Option<Entry> {
    match label.patch {
        "disk" => Some(coupled::<R, _>(label, 0, cases, compact::Coulomb)),
        "ring" => Some(coupled::<R, _>(label, 0, cases, closed::Ring)),
        "punch" => Some(coupled::<R, _>(label, 0, cases, closed::FlatPunch)),
        "Hertz" => Some(coupled::<R, _>(label, 0, cases, closed::Hertz)),
        _ => None,
    }
}

/// A thin annulus from two disks.
fn annulus<R: Tables>(alpha: f64, law: &'static str) -> Result<Vec<Entry>, Refused> {
    let inner = R::from_f64(INNER);
    let wide = Annulus::new(compact::Power::new(alpha)?, inner.to_f64())?;
    let cases = power_cases::<R>(Source::Annulus(INNER), alpha, &wide);
    let label = |tier| Label {
        patch: "annulus 0.9",
        law,
        tier,
        judge: judge::<R>(),
    };
    let quick = (cases.as_slice(), TABLE_STRIDE);
    let slow = (cases.as_slice(), COMPACT_STRIDE);
    let mut rows = Vec::new();
    if alpha == 0.0 {
        let bytes = size_of::<R::Table>();
        let disk = Annulus::new(table::Coulomb, inner)?;
        rows.push(coupled::<R, _>(label("table"), bytes, quick, disk));
        let disk = Annulus::new(compact::Coulomb, inner)?;
        rows.push(coupled::<R, _>(label("closed"), 0, quick, disk));
    } else {
        let disk = Annulus::new(R::disk(alpha)?, inner)?;
        let bytes = size_of_val(&disk);
        rows.push(coupled::<R, _>(label("table"), bytes, quick, disk));
    }
    let disk = Annulus::new(compact::Power::new(R::from_f64(alpha))?, inner)?;
    let bytes = size_of_val(&disk);
    rows.push(coupled::<R, _>(label("compact"), bytes, slow, disk));
    Ok(rows)
}

/// The polynomial pressure, which has a table in f64 and no other tier.
pub fn polynomial() -> Result<Vec<Entry>, Refused> {
    let pressure = PolynomialPressure::new(tables::POLYNOMIAL)?;
    let mut rows = Vec::new();
    for (alpha, law) in laws::POWERS {
        let cases = tables::cases(Source::POLYNOMIAL, alpha);
        let label = Label {
            patch: "polynomial",
            law,
            tier: "table",
            judge: "tables",
        };
        let table = PolynomialTable::new(alpha, &pressure)?;
        let bytes = size_of_val(&table);
        let cases = (cases.as_slice(), TABLE_STRIDE);
        rows.push(coupled::<f64, _>(label, bytes, cases, table));
    }
    Ok(rows)
}

/// The quadrature under every law, on the disk and on the annulus.
struct Quadratures {
    frictions: Vec<(&'static str, Friction)>,
    rows: Vec<Entry>,
}

impl<R: Real> ForLaw<R> for Quadratures {
    fn with<L: LocalLaw<R> + Copy + 'static>(&mut self, name: &'static str, law: L) {
        let Some((_, friction)) = self.frictions.iter().find(|(known, _)| *known == name) else {
            return;
        };
        let label = |patch| Label {
            patch,
            law: name,
            tier: "quadrature",
            judge: "area",
        };
        let disk = DiskQuadrature::new(law);
        let bytes = size_of_val(&disk);
        let cases = area_cases::<R>(Pressure::Power(0.0), friction);
        let judged = (cases.as_slice(), SLOW_STRIDE);
        let row = coupled::<R, _>(label("disk"), bytes, judged, disk);
        self.rows.push(row);
        let inner = R::from_f64(INNER);
        let cases = area_cases::<R>(Pressure::Annulus(inner.to_f64()), friction);
        let judged = (cases.as_slice(), SLOW_STRIDE);
        // The constant is in the domain.
        if let Ok(annulus) = Annulus::new(disk, inner) {
            let bytes = size_of_val(&annulus);
            let row = coupled::<R, _>(label("annulus 0.9"), bytes, judged, annulus);
            self.rows.push(row);
        }
    }
}

/// All laws by quadrature.
pub fn quadratures<R: Real>() -> Result<Vec<Entry>, Refused> {
    let mut all = Quadratures {
        frictions: laws::frictions()?,
        rows: Vec::new(),
    };
    laws::each::<R>(&mut all)?;
    Ok(all.rows)
}
