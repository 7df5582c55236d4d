//! Round patches: tables, closed forms and the compact tier under power laws; the quadrature under
//! all laws.

use super::area::{Moments, Pressure};
use super::laws::{self, ForLaw, Friction};
use super::tables::{self, Source};
use super::{Case, Entry, Label, Refused, SEED, precision};
use crate::methods::as_pair;
use crate::mix;
use crate::reference::Wide;
use std::any::TypeId;
use tribos::friction::{Patch, Precision, RoundPower, Tier, Visitor, visit};
use tribos_core::coupling::coulomb::CoulombDisk;
use tribos_core::coupling::quadrature::DiskQuadrature;
use tribos_core::coupling::round::PolynomialTable;
use tribos_core::coupling::{Annulus, ReducedFriction, compact};
use tribos_core::law::LocalLaw;
use tribos_core::patch::{PolynomialPressure, PowerPressure};
use tribos_core::real::Real;

/// Inner over outer radius of the annulus.
pub const INNER: f64 = 0.9;
/// Stride of the pairs that are timed: slower tiers time fewer of them.
pub const TABLE_STRIDE: usize = 4;
const COMPACT_STRIDE: usize = 20;
/// Also for nodes.
pub const SLOW_STRIDE: usize = 80;
/// Pairs judged by integration over the area, and the ratios at which it has its digits.
const AREA_PAIRS: usize = 48;
const AREA_RATIOS: core::ops::Range<f64> = 1e-3..1e3;

/// The pressures (1−r²)^q, where their references are, and what the judge calls them.
const POWERS: [(&str, &str, Patch); 5] = [
    ("disk", "uniform", Patch::Disk),
    ("ring", "ring", Patch::Ring),
    ("punch", "punch", Patch::Punch),
    ("Hertz", "hertz", Patch::Hertz),
    ("paraboloid", "paraboloid", Patch::Paraboloid),
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
fn power_cases<R: Real>(source: Source, alpha: f64, wide: &impl ReducedFriction<f64>) -> Vec<Case> {
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
fn coupled<R: Real, C: ReducedFriction<R> + 'static>(
    label: Label,
    bytes: usize,
    (cases, stride): (&[Case], usize),
    coupling: C,
) -> Entry {
    Entry::new(label, bytes, cases, &timed(stride), move |slide, rim| {
        as_pair(coupling.reduced_wrench(slide, rim))
    })
}

/// The row of the kernel's own type, chosen at run time.
struct Row<'a> {
    label: Label,
    judged: (&'a [Case], usize),
}

impl<R: Precision> Visitor<R> for Row<'_> {
    type Output = Entry;
    fn visit<P: RoundPower<R> + 'static>(self, friction: P) -> Entry {
        coupled::<R, _>(self.label, table_bytes::<R, P>(), self.judged, friction)
    }
}

/// Size of a coupling with its table or, where it has no data of its own, of the numbers of a form.
pub fn table_bytes<R: Precision, P: 'static>() -> usize {
    match size_of::<P>() {
        own if own > size_of::<R>() => own,
        // A fit for spinning and one for sliding as the faster motion; the disk needs one.
        0 if TypeId::of::<P>() != TypeId::of::<CoulombDisk>() => 2 * form_bytes::<R>(),
        _ => form_bytes::<R>(),
    }
}

/// Size of the numbers of Coulomb friction on a disk in the program: four functions.
pub fn form_bytes<R: Real>() -> usize {
    let terms = if size_of::<R>() == size_of::<f32>() {
        6
    } else {
        12
    };
    4 * terms * size_of::<R>()
}

/// Power laws on the pressures (1−r²)^q and the annulus, all tiers but the quadrature.
pub fn powers<R: Precision>() -> Result<Vec<Entry>, Refused> {
    let mut rows = Vec::new();
    let inner = R::from_f64(INNER);
    for (alpha, law) in laws::POWERS {
        let narrow = R::from_f64(alpha);
        for (name, file, patch) in POWERS {
            let pressure = patch.pressure().unwrap_or(PowerPressure::UNIFORM);
            let wide = compact::CompactPower::with_pressure(alpha, pressure)?;
            let cases = power_cases::<R>(Source::File(file), alpha, &wide);
            exact::<R>(&mut rows, (name, law), (&patch, alpha), &cases)?;
            let series = compact::CompactPower::with_pressure(narrow, pressure)?;
            rows.push(in_series::<R, _>((name, law), &cases, series));
        }
        let name = "annulus 0.9";
        let wide = Annulus::new(compact::CompactPower::new(alpha)?, inner.to_f64())?;
        let cases = power_cases::<R>(Source::Annulus(INNER), alpha, &wide);
        exact::<R>(
            &mut rows,
            (name, law),
            (&Patch::Annulus(INNER), alpha),
            &cases,
        )?;
        let series = Annulus::new(compact::CompactPower::new(narrow)?, inner)?;
        rows.push(in_series::<R, _>((name, law), &cases, series));
    }
    Ok(rows)
}

/// The row of the form, for Coulomb friction, or of the table.
fn exact<R: Precision>(
    rows: &mut Vec<Entry>,
    (name, law): (&'static str, &'static str),
    (patch, alpha): (&Patch, f64),
    cases: &[Case],
) -> Result<(), Refused> {
    let tier = if alpha == 0.0 { "form" } else { "table" };
    let row = Row {
        label: label::<R>(name, law, tier),
        judged: (cases, TABLE_STRIDE),
    };
    rows.push(visit::<R, _>(patch, alpha, Tier::Exact, row)?);
    Ok(())
}

/// The row of the series that serves any exponent.
fn in_series<R: Precision, C: ReducedFriction<R> + 'static>(
    (name, law): (&'static str, &'static str),
    cases: &[Case],
    series: C,
) -> Entry {
    let label = label::<R>(name, law, "compact");
    coupled::<R, _>(label, size_of::<C>(), (cases, COMPACT_STRIDE), series)
}

fn label<R: Real>(patch: &'static str, law: &'static str, tier: &'static str) -> Label {
    Label {
        patch,
        law,
        tier,
        judge: judge::<R>(),
    }
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
