//! What is called one by one and in batches.

use crate::contact::Contact;
use crate::mix::{self, Lcg};
use core::fmt;
use std::cell::RefCell;
use std::hint::black_box;
use std::rc::Rc;
use tribos_core::Real;
use tribos_core::coupling::coulomb::CoulombDisk;
use tribos_core::coupling::table::{DiskTable32, DiskTable64};
use tribos_core::coupling::{ReducedFriction, ReducedWrench};
use tribos_core::limit_surface::{FrictionSet, RoundLimitSurface};
use tribos_core::twist::Wrench;

/// Seed of all inputs.
const SEED: u64 = 1;
/// An exponent for which no power is a root or a product.
const ALPHA: f64 = 0.37;
/// Force limit and radius of the limit surface.
const LIMIT: f64 = 0.5;
const RADIUS: f64 = 0.08;
/// Why a batch is not timed.
const BROKEN: &str = "the batch differs from single calls";
/// Wrenches of each projection.
const WRENCHES: usize = 3800;

/// One run over all inputs.
pub type Run = Box<dyn FnMut()>;

/// Name, exponent and type of an item.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Label {
    /// What is called.
    pub name: &'static str,
    /// Exponent of the law.
    pub alpha: f64,
    /// f64 or f32.
    pub precision: &'static str,
}

impl fmt::Display for Label {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} α {} {}", self.name, self.alpha, self.precision)
    }
}

/// A call and, where there is one, its batch.
pub struct Item {
    /// What it is.
    pub label: Label,
    /// Calls of a run.
    pub elements: usize,
    /// One call after the other.
    pub one: Run,
    /// All in one call, to the same bits.
    pub batch: Option<Run>,
}

/// How many inputs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Length {
    /// For instruction counts.
    Short,
    /// For times: too many for a branch predictor to learn.
    Long,
}

/// All items, in the order of the table.
pub fn all(length: Length) -> Result<Vec<Item>, String> {
    let refused = |error: tribos_core::Error| error.to_string();
    let double = DiskTable64::new(ALPHA).map_err(|error| error.to_string())?;
    let single = DiskTable32::new(ALPHA as f32).map_err(|error| error.to_string())?;
    let mut items = Vec::new();
    items.extend(calls::<f64, _>(CoulombDisk, (0.0, "f64"), length)?);
    items.extend(calls::<f32, _>(CoulombDisk, (0.0, "f32"), length)?);
    items.extend(calls::<f64, _>(double, (ALPHA, "f64"), length)?);
    items.extend(calls::<f32, _>(single, (ALPHA, "f32"), length)?);
    items.extend(projections::<f64>("f64").map_err(refused)?);
    items.extend(projections::<f32>("f32").map_err(refused)?);
    Ok(items)
}

/// Reduced wrench, wrench and Jacobian of a coupling.
fn calls<R, C>(
    coupling: C,
    (alpha, precision): (f64, &'static str),
    length: Length,
) -> Result<Vec<Item>, String>
where
    R: Real,
    C: ReducedFriction<R> + Clone + 'static,
{
    let pairs = match length {
        Length::Short => mix::pairs(SEED),
        Length::Long => mix::long_pairs(SEED),
    };
    let elements = pairs.len();
    let mut contact =
        Contact::<R, C>::new(coupling.clone(), &pairs, SEED).map_err(|error| error.to_string())?;
    contact.assert_right();
    let contact = Rc::new(RefCell::new(contact));
    let run = |call: fn(&mut Contact<R, C>)| -> Run {
        let contact = Rc::clone(&contact);
        Box::new(move || call(&mut contact.borrow_mut()))
    };
    let item = |name, one, batch| Item {
        label: Label {
            name,
            alpha,
            precision,
        },
        elements,
        one,
        batch,
    };
    let [one, batch] = reduced(coupling, &pairs);
    Ok(vec![
        item("reduced wrench", one, Some(batch)),
        item(
            "wrench",
            run(|contact| {
                black_box(contact.one_by_one());
            }),
            Some(run(|contact| {
                black_box(contact.batch());
            })),
        ),
        item(
            "Jacobian",
            run(|contact| {
                black_box(contact.jacobians());
            }),
            Some(run(|contact| {
                black_box(contact.jacobian_batch());
            })),
        ),
    ])
}

/// Reduced wrenches of speeds, one by one and in a batch.
fn reduced<R: Real, C: ReducedFriction<R> + Clone + 'static>(
    coupling: C,
    pairs: &[[f64; 2]],
) -> [Run; 2] {
    let speeds = [0, 1].map(|of| -> Vec<R> {
        let speeds = pairs.iter().map(|pair| R::from_f64(pair[of]));
        speeds.collect()
    });
    let [mut forces, mut torques] = [(); 2].map(|()| vec![R::ZERO; pairs.len()]);
    coupling.reduced_wrench_batch(&speeds[0], &speeds[1], &mut forces, &mut torques);
    for (at, (&slide, &rim)) in speeds[0].iter().zip(&speeds[1]).enumerate() {
        let ReducedWrench { force, torque } = coupling.reduced_wrench(slide, rim);
        assert!((force, torque) == (forces[at], torques[at]), "{BROKEN}");
    }
    let (single, alone) = (coupling.clone(), speeds.clone());
    let one = move || {
        for (&slide, &rim) in alone[0].iter().zip(&alone[1]) {
            black_box(single.reduced_wrench(black_box(slide), black_box(rim)));
        }
    };
    let batch = move || {
        let [slides, rims] = black_box(&speeds);
        coupling.reduced_wrench_batch(slides, rims, &mut forces, &mut torques);
        black_box((&forces, &torques));
    };
    [Box::new(one), Box::new(batch)]
}

/// Regions of the projection: the gauges of its wrenches.
const REGIONS: [(&str, [f64; 2]); 3] = [
    ("projection inside", [0.0, 0.7]),
    ("projection near", [0.97, 1.03]),
    ("projection outside", [1.1, 5.0]),
];

/// Projections onto the limit surface of the uniform disk.
fn projections<R: Real + 'static>(precision: &'static str) -> Result<Vec<Item>, tribos_core::Error>
where
    CoulombDisk: tribos_core::coupling::DryReducedFriction<R>,
{
    let surface = RoundLimitSurface::new(CoulombDisk, R::from_f64(LIMIT), R::from_f64(RADIUS))?;
    let region = |(name, gauges): (&'static str, [f64; 2])| {
        let wrenches = wrenches(&surface, gauges);
        let (pushes, loads) = (wrenches.clone(), vec![R::ONE; wrenches.len()]);
        let mut nearest: Vec<_> = pushes
            .iter()
            .map(|wrench| surface.project(wrench))
            .collect();
        let single = nearest.clone();
        surface.project_batch(surface.radius(), &loads, &pushes, &mut nearest);
        assert!(single == nearest, "{BROKEN}");
        let batch = move || {
            let pushes = black_box(&pushes);
            surface.project_batch(surface.radius(), &loads, pushes, &mut nearest);
            black_box(&nearest);
        };
        Item {
            label: Label {
                name,
                alpha: 0.0,
                precision,
            },
            elements: wrenches.len(),
            one: Box::new(move || {
                for wrench in &wrenches {
                    black_box(surface.project(black_box(wrench)));
                }
            }),
            batch: Some(Box::new(batch)),
        }
    };
    Ok(REGIONS.map(region).into())
}

/// Wrenches in all directions, with gauges evenly spread between two values.
fn wrenches<R: Real, S: FrictionSet<R>>(surface: &S, [low, high]: [f64; 2]) -> Vec<Wrench<R>> {
    let mut random = Lcg::new(SEED);
    let mut wrench = || {
        let [x, y, turn] = [1.0, 1.0, RADIUS].map(|size| size * random.uniform(-1.0, 1.0));
        let gauge = R::from_f64(random.uniform(low, high));
        let [x, y, turn] = [x, y, turn].map(R::from_f64);
        surface.scale_to_surface(&Wrench::new(x, y, turn)) * gauge
    };
    (0..WRENCHES).map(|_| wrench()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn wrenches_have_the_gauges_of_their_region() {
        let surface = RoundLimitSurface::new(CoulombDisk, LIMIT, RADIUS).unwrap();
        for (name, [low, high]) in REGIONS {
            for wrench in wrenches(&surface, [low, high]) {
                let gauge: f64 = surface.gauge(&wrench);
                assert!(gauge > low - 1e-9 && gauge < high + 1e-9, "{name} {gauge}");
            }
        }
    }

    #[test]
    fn every_item_has_its_own_label() {
        let items = all(Length::Short).unwrap();
        let mut labels: Vec<String> = items.iter().map(|item| item.label.to_string()).collect();
        let count = labels.len();
        labels.sort_unstable();
        labels.dedup();
        assert_eq!(labels.len(), count);
        assert!(items.iter().all(|item| item.batch.is_some()));
    }
}
