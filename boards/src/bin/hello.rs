//! Proves the board: numbers of both precisions, counts that repeat, a known stack depth.
#![cfg_attr(target_os = "none", no_std, no_main)]

tribos_boards::main!(run);

#[cfg(target_os = "none")]
fn run() {
    use core::hint::black_box;
    use tribos_boards::{BOARD, free, instructions, println, stack_used};

    println!("board {BOARD}, {} B of stack free", free());
    // Divisions that round, so that the FPU or its emulation takes part.
    let third = black_box(1.0_f64) / black_box(3.0);
    let seventh = black_box(1.0_f32) / black_box(7.0);
    assert_eq!(third.to_bits(), 0x3fd5_5555_5555_5555);
    assert_eq!(seventh.to_bits(), 0x3e12_4925);
    // Twice the work takes twice the instructions, and a second count equals the first.
    let mut divide = |times: u32| {
        instructions(&mut || {
            for _ in 0..black_box(times) {
                black_box(black_box(1.0_f64) / black_box(3.0));
            }
        })
    };
    let [once, again, twice, thrice] = [1000, 1000, 2000, 3000].map(&mut divide);
    println!("1000 divisions of f64: {once:?} instructions");
    let (Some(once), Some(again), Some(twice), Some(thrice)) = (once, again, twice, thrice) else {
        panic!("the clock does not follow the instructions: run QEMU with -icount shift=10");
    };
    assert_eq!(once, again);
    assert_eq!(thrice - twice, twice - once);
    // An array of 512 B needs that much stack and little more.
    let used = stack_used(&mut || {
        black_box([0_u8; 512]);
    });
    println!("an array of 512 B: {used} B of stack");
    assert!((512..768).contains(&used));
}
