//! `tribos scene list`.

use tribos::scene::LIBRARY;

/// A table.
pub fn text() -> String {
    let mut text = format!("{:<18} {:<9} {:<26} {}\n", "name", "body", "takes", "shows");
    for scene in LIBRARY {
        text += &format!(
            "{:<18} {:<9} {:<26} {}\n",
            scene.name,
            scene.body(),
            scene.takes(),
            scene.summary()
        );
    }
    text + "Run one with `tribos run NAME --out DIR`, start your own with `tribos scene new NAME`.\n"
}
