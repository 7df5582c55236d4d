//! The digest of `examples/digest.c`, computed by the kernel itself without any function of the C
//! interface: the same draws in the same order give the same results.

mod contacts;
mod laws;
mod patch_surfaces;
mod patches;
mod points;
mod polygons;
mod shapes;
mod sliders;
mod stream;
mod surfaces;

use stream::{Precision, Range, Stream};

/// Expected output of the C program.
pub fn digest() -> u64 {
    let mut stream = Stream::new();
    all::<f64>(&mut stream);
    all::<f32>(&mut stream);
    stream.hash()
}

fn all<R: Precision>(s: &mut Stream) {
    let range = |n| if n % 2 == 1 { Range::Wide } else { Range::Mild };
    for n in 0..200 {
        let range = range(n);
        laws::simple::<R>(s);
        laws::with_state::<R>(s);
        patches::round::<R>(s);
        points::at_points::<R>(s);
        surfaces::both::<R>(s, range);
        patch_surfaces::all::<R>(s, range);
        sliders::steps::<R>(s, range);
        contacts::both::<R>(s);
    }
    patches::tables::<R>(s);
    for n in 0..40 {
        patches::powers::<R>(s);
        points::rules::<R>(s);
        polygons::leaning::<R>(s, range(n));
        shapes::all::<R>(s, range(n));
        sliders::ways::<R>(s, n % 8 == 0);
    }
}
