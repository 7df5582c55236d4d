//! Force and torque of the uniform disk, without dimensions.

use super::{BOTH, Code, Item, NARROW, item, round};
use crate::firmware::TIER;

const HALF_TABLE: &str =
    "static TABLE: Table = match Table::new(0.5) { Ok(table) => table, Err(_) => panic!() };";

const fn tier(
    name: &'static str,
    precisions: &'static [&'static str],
    modules: &'static str,
    prepare: &'static str,
) -> Item {
    item(
        [TIER, name],
        precisions,
        modules,
        Code::new(prepare, "couple(object, a, b)"),
    )
}

/// One sliding speed and one rim speed in.
pub const TIERS: [Item; 6] = [
    tier(
        "form: Coulomb",
        BOTH,
        round!(
            "coupling::coulomb coupling::coulomb::form coupling::coulomb::terms special::log_part special::log_quotient coupling::batch::ways"
        ),
        "coulomb::CoulombDisk",
    ),
    item(
        [TIER, "table: alpha 0.5"],
        BOTH,
        round!(
            "coupling::table coupling::disk coupling::equal_speeds special::log_quotient coupling::regime_table coupling::batch::ways power"
        ),
        Code::new("&TABLE", "couple(object, a, b)").with_statics(HALF_TABLE),
    ),
    tier(
        "compact: alpha 0.5",
        BOTH,
        round!(
            "coupling::compact coupling::family_member coupling::half_octave_table special::hypergeometric"
        ),
        "compact::CompactPower::new(0.5 as R).ok()?",
    ),
    tier(
        "compact: power alpha 0",
        BOTH,
        round!(
            "coupling::compact coupling::family_member coupling::half_octave_table special::hypergeometric"
        ),
        "compact::CompactPower::new(0.0 as R).ok()?",
    ),
    tier(
        "quadrature: Coulomb",
        BOTH,
        "coupling::quadrature law law::coulomb",
        "DiskQuadrature::new(CoulombLaw::new(1.0 as R).ok()?)",
    ),
    tier(
        "quadrature: Stribeck",
        NARROW,
        "coupling::quadrature law law::stribeck law::dry",
        "DiskQuadrature::new(Stribeck::new(StribeckParameters { dry: DryFriction::new(0.5 as R, 0.25).ok()?, speed: 0.5, exponent: 2.0, viscous: 0.125 }).ok()?)",
    ),
];
