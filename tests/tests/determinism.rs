//! Regression test of bits across platforms: the constants below were printed once and have to
//! come out everywhere, in every build profile.
//!
//! A change of them is a change of results: say so in the changelog under *Numerical results
//! changed*. New values: `cargo run -p tribos-tests --example bits`.
//!
//! Seen equal: x86-64 with opt-levels 1 and 3, i686 with SSE2, aarch64, wasm32 under Node.

use tribos_tests::bits;

#[test]
fn tables_have_the_same_bits_on_every_platform() {
    assert_eq!(bits::tables_f64(), 0x5b80_4d8b_1e25_0fc3, "f64");
    assert_eq!(bits::tables_f32(), 0xdb92_9c09_2d41_eea4, "f32");
}

#[test]
fn compact_forms_have_the_same_bits_on_every_platform() {
    assert_eq!(bits::compact(), 0x4533_450e_f70b_6a4a);
}

#[test]
fn quadrature_has_the_same_bits_on_every_platform() {
    assert_eq!(bits::quadrature(), 0xe66e_bcfc_f3cd_d9b4);
}

#[test]
fn wrenches_have_the_same_bits_on_every_platform() {
    assert_eq!(bits::wrenches(), 0x884e_69ff_ec82_bbd7);
}

#[test]
fn sliders_have_the_same_bits_on_every_platform() {
    assert_eq!(bits::sliders(), 0x040b_628f_c818_7acd);
}

#[test]
fn pressures_have_the_same_bits_on_every_platform() {
    assert_eq!(bits::pressures_f64(), 0x6eb2_9e99_6901_ae75, "f64");
    assert_eq!(bits::pressures_f32(), 0xc86a_15af_e682_2141, "f32");
}

#[test]
fn closed_forms_have_the_same_bits_on_every_platform() {
    assert_eq!(bits::closed_forms(), 0x65a2_afe1_76cb_8e81);
}

#[test]
fn tall_bodies_have_the_same_bits_on_every_platform() {
    assert_eq!(bits::tall(), 0xdc4c_dbf0_9482_0034);
}

#[test]
fn contacts_at_nodes_have_the_same_bits_on_every_platform() {
    assert_eq!(bits::nodes(), 0xaca1_d7fc_d221_d32b);
}

#[test]
fn limit_surfaces_have_the_same_bits_on_every_platform() {
    assert_eq!(bits::limit_surfaces(), 0x6487_4066_e7ec_b2f1);
}

#[test]
fn laws_have_the_same_bits_on_every_platform() {
    assert_eq!(bits::laws(), 0x91e2_16c3_543e_2622);
}

#[test]
fn impulses_of_contacts_have_the_same_bits_on_every_platform() {
    assert_eq!(bits::contacts(), 0x8d4b_97ef_f3e9_9454);
}

#[test]
fn the_hash_sees_a_single_bit() {
    // All hashes differ and none is the empty one.
    let mut seen: Vec<u64> = bits::bits().iter().map(|(_, hash)| *hash).collect();
    seen.sort_unstable();
    seen.dedup();
    assert_eq!(seen.len(), bits::bits().len());
}
