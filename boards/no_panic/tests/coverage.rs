//! The proof covers every public function.

use tribos_no_panic::functions::image;

#[test]
fn every_public_function_has_an_instance_in_both_precisions() {
    let image = image().unwrap_or_else(|error| panic!("{error}"));
    // Far fewer would mean that the compiler's list was misread.
    assert!(image.functions > 400, "{} functions", image.functions);
    assert!(image.names.len() > 2 * image.functions);
}
