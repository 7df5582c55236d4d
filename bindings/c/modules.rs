/// Files of `src/double`, in the order of the header.
const MODULES: [&str; 13] = [
    "vectors",
    "law",
    "patch",
    "patch_batch",
    "nodes",
    "surface",
    "polygon",
    "patch_surface",
    "slider",
    "planar",
    "batch",
    "contact",
    "update",
];
