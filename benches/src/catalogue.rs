//! The methods that are timed and checked: the kernel's tiers, their baselines, tables of other exponents.

use crate::baselines::trapezoid::Trapezoid;
use crate::baselines::{agm, bulirsch, cephes, decoupled, ellipsoid, micromath_agm, pade, series};
use crate::methods::{Kind, Method, as_pair};
use tribos_core::coupling::quadrature::DiskQuadrature;
use tribos_core::coupling::table::{DiskTable32, DiskTable64};
use tribos_core::coupling::unscaled_wrench;
use tribos_core::coupling::{ReducedFriction, compact, coulomb};
use tribos_core::law::{CoulombLaw, LawError};

/// Exponents for which the tables are timed.
pub const EXPONENTS: [f64; 7] = [-0.5, 0.25, 0.5, 1.0, 1.5, 3.0, 10.0];
/// Rings and angles of the trapezoid rule.
pub const TRAPEZOIDS: [usize; 3] = [32, 128, 512];

/// The kernel's tiers for α = 0.
pub fn tiers() -> Result<Vec<Method>, LawError> {
    let quadrature = DiskQuadrature::new(CoulombLaw::new(1.0)?);
    let quadrature_narrow = DiskQuadrature::new(CoulombLaw::new(1.0_f32)?);
    let power = compact::CompactPower::new(0.0)?;
    let power_narrow = compact::CompactPower::new(0.0_f32)?;
    let wrench = |slide, rim| as_pair(coulomb::CoulombDisk.reduced_wrench(slide, rim));
    let narrow = |slide, rim| as_pair(coulomb::CoulombDisk.reduced_wrench(slide, rim));
    let power = move |slide, rim| as_pair(power.reduced_wrench(slide, rim));
    let quadrature = move |slide, rim| as_pair(quadrature.reduced_wrench(slide, rim));
    let power_narrow = move |slide, rim| as_pair(power_narrow.reduced_wrench(slide, rim));
    let quadrature_narrow = move |slide, rim| as_pair(quadrature_narrow.reduced_wrench(slide, rim));
    let tier = Kind::Tier;
    Ok(vec![
        Method::wide("form", tier, 1e-15, wrench),
        Method::narrow("form f32", tier, 5e-7, narrow),
        Method::wide("compact power", tier, 2e-15, power).every(10),
        Method::narrow("compact power f32", tier, 1e-6, power_narrow).every(10),
        Method::wide("quadrature", tier, 1e-8, quadrature).every(10),
        Method::narrow("quadrature f32", tier, 1e-5, quadrature_narrow).every(10),
    ])
}

/// All baselines for the kernel, α = 0.
pub fn baselines() -> Vec<Method> {
    use Kind::{Approximation, Elliptic, Integration};
    let mut methods = vec![
        Method::wide("agm", Elliptic, 1e-14, agm::wrench),
        Method::wide("agm libm", Elliptic, 1e-14, agm::wrench_libm),
        Method::wide("bulirsch", Elliptic, 2e-15, bulirsch::wrench),
        Method::wide("cephes", Elliptic, f64::INFINITY, cephes::wrench),
        Method::narrow("agm micromath f32", Elliptic, 0.3, micromath_agm::wrench),
    ];
    for n in TRAPEZOIDS {
        let rule = Trapezoid::new(n, 0.0);
        // About 3,800 × 32²/n² pairs: equal work for all.
        let stride = (n / 10).pow(2).min(1000);
        let evaluate = move |slide, rim| rule.wrench(slide, rim);
        let method = Method::wide(format!("trapezoid {n}"), Integration, 0.05, evaluate);
        methods.push(method.every(stride));
    }
    methods.extend([
        Method::wide("decoupled", Approximation, 1.0, decoupled::wrench),
        Method::wide("ellipsoid", Approximation, 0.16, ellipsoid::wrench),
        Method::wide("pade 1", Approximation, 0.41, pade::first_order),
        Method::wide("pade 2", Approximation, 0.23, pade::second_order),
        Method::wide("series 3", Approximation, 0.035, series::wrench),
    ]);
    methods
}

/// Tables of several exponents, each with the power of the velocity scale and without.
pub fn exponents() -> Result<Vec<Method>, LawError> {
    let mut methods = Vec::new();
    for alpha in EXPONENTS {
        // Leaked once a program: a table in a closure would be copied with it.
        let table: &'static DiskTable64 = Box::leak(Box::new(DiskTable64::new(alpha)?));
        let full = move |slide, rim| as_pair(table.reduced_wrench(slide, rim));
        let bare = move |slide, rim| as_pair(unscaled_wrench(table, slide, rim));
        let name = format!("table alpha {alpha}");
        let bound = 1e-14;
        methods.push(
            Method::wide(format!("{name} unscaled"), Kind::Tier, bound, bare)
                .with_exponent(alpha, true),
        );
        methods.push(Method::wide(name, Kind::Tier, bound, full).with_exponent(alpha, false));
    }
    let table: &'static DiskTable32 = Box::leak(Box::new(DiskTable32::new(0.5)?));
    let full = move |slide, rim| as_pair(table.reduced_wrench(slide, rim));
    let bare = move |slide, rim| as_pair(unscaled_wrench(table, slide, rim));
    let narrow = "table f32 alpha 0.5";
    methods.push(
        Method::narrow(format!("{narrow} unscaled"), Kind::Tier, 1e-6, bare)
            .with_exponent(0.5, true),
    );
    methods.push(Method::narrow(narrow, Kind::Tier, 1e-6, full).with_exponent(0.5, false));
    Ok(methods)
}
