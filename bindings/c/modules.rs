/// Files of `src/double`, in the order of the header.
const MODULES: [&str; 16] = [
    "vectors",
    "law",
    "patch",
    "patch_batch",
    "nodes",
    "surface",
    "polygon",
    "patch_surface",
    "piece",
    "shape",
    "slider",
    "planar",
    "feet",
    "batch",
    "contact",
    "update",
];
