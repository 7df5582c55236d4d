//! Programs of the book: what its pages and READMEs say in Rust compiles and runs.

macro_rules! pages {
    ($($page:literal)*) => {
        /// Pages with programs in Rust, from the root of the repository.
        pub const PAGES: &[&str] = &[$($page),*];
        $(
            #[cfg(doctest)]
            const _: () = {
                #[doc = include_str!(concat!("../../", $page))]
                struct Page;
            };
        )*
    };
}

pages! {
    "README.md"
    "core/README.md"
    "std-adapter/README.md"
    "docs/c.md"
    "docs/contact-problems.md"
    "docs/fit.md"
    "docs/granular.md"
    "docs/inside-an-engine.md"
    "docs/limit-surface.md"
    "docs/polygons.md"
    "docs/presliding.md"
    "docs/puck.md"
    "docs/pushing.md"
    "docs/runs.md"
}
