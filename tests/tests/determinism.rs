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
    assert_eq!(bits::tables_f64(), 0x07b7_9742_e52d_13a8, "f64");
    assert_eq!(bits::tables_f32(), 0xdb92_9c09_2d41_eea4, "f32");
}

#[test]
fn compact_forms_have_the_same_bits_on_every_platform() {
    assert_eq!(bits::compact(), 0xa754_4598_ea20_5966);
}

#[test]
fn quadrature_has_the_same_bits_on_every_platform() {
    assert_eq!(bits::quadrature(), 0xe66e_bcfc_f3cd_d9b4);
}

#[test]
fn wrenches_have_the_same_bits_on_every_platform() {
    assert_eq!(bits::wrenches(), 0x7d42_4370_655f_fc12);
}

#[test]
fn sliders_have_the_same_bits_on_every_platform() {
    assert_eq!(bits::sliders(), 0xb2a0_db1f_591a_43b6);
}

#[test]
fn the_hash_sees_a_single_bit() {
    // All six hashes differ and none is the empty one.
    let mut seen: Vec<u64> = bits::bits().iter().map(|(_, hash)| *hash).collect();
    seen.sort_unstable();
    seen.dedup();
    assert_eq!(seen.len(), bits::bits().len());
}
