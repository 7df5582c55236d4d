//! Prints `index digest` of every chapter.

use tribos_digest::CHAPTERS;

fn main() {
    for (index, chapter) in CHAPTERS.iter().enumerate() {
        println!("{index} {:016x}", (chapter.run)());
    }
}
