//! Digests of the kernel's bits as this target computes them: `index digest instructions`, one
//! subject per line. `TRIBOS_SUBJECTS=2,3,8` at build time selects subjects, so that the image
//! stays small; by default it contains all.
#![cfg_attr(target_os = "none", no_std, no_main)]

tribos_boards::main!(run);

#[cfg(target_os = "none")]
use tribos_subjects::{SUBJECTS, Subject};

/// The subjects in the image; the linker drops the others.
#[cfg(target_os = "none")]
static CHOSEN: [Option<Subject>; SUBJECTS.len()] = {
    let mut chosen = [None; SUBJECTS.len()];
    let mut index = 0;
    while index < SUBJECTS.len() {
        if is_listed(index, env!("TRIBOS_SUBJECTS").as_bytes()) {
            chosen[index] = Some(SUBJECTS[index]);
        }
        index += 1;
    }
    chosen
};

/// Whether a comma-separated list contains the number; the empty list contains all.
#[cfg(target_os = "none")]
const fn is_listed(number: usize, list: &[u8]) -> bool {
    let (mut at, mut read) = (0, 0);
    while at < list.len() {
        if list[at] == b',' {
            if read == number {
                return true;
            }
            read = 0;
        } else {
            read = 10 * read + (list[at] - b'0') as usize;
        }
        at += 1;
    }
    list.is_empty() || read == number
}

#[cfg(target_os = "none")]
fn run() {
    for (index, subject) in CHOSEN.iter().enumerate() {
        let Some(subject) = subject else { continue };
        let mut digest = 0;
        let count = tribos_boards::instructions(&mut || digest = subject.digest());
        let count = count.unwrap_or(0);
        tribos_boards::println!("{index} {digest:016x} {count}");
    }
}
