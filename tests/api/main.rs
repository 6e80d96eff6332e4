//! What the library promises to those who call it: a module a subject, of one program, which is linked once.
//! `cargo test hash::` runs one module.
#![allow(missing_docs, clippy::cast_possible_truncation, clippy::std_instead_of_core, reason = "tests on the host")]
#![allow(clippy::large_stack_arrays, reason = "the tests' own tiles; a test thread has 2 MiB")]

#[path = "../analysis/mod.rs"]
mod analysis;
mod common;
#[cfg(all(feature = "seed-permutation", feature = "warp"))] // a test's, of the permutation of seeds
#[path = "../../examples/render/paths.rs"]
#[allow(unreachable_pub, reason = "the example's")]
mod paths;

mod analysis_checks;
mod animation;
mod bad_input;
mod bias;
mod call_shape;
mod candidate;
mod casts;
mod controls;
mod decorrelation;
mod directions;
mod dither;
mod dithered;
#[cfg(feature = "embedded-graphics")]
mod draw_target;
mod hard_cases;
mod hash;
mod lattice;
mod mask;
mod net;
mod net_twin;
#[cfg(all(
    feature = "threshold-over-time-32",
    feature = "threshold-over-time-64",
    feature = "threshold-over-time-128",
    feature = "threshold-filtered-over-time-64",
    feature = "offset-2d-over-time-32",
    feature = "offset-2d-over-time-64",
    feature = "offset-2d-32",
))]
mod over_time;
mod pattern;
mod seeds;
mod sequence;
#[cfg(all(feature = "wgsl", feature = "threshold-64", feature = "offset-2d-64"))]
mod shader;
mod shift;
mod sobol;
mod strata;
mod torus;
mod unit;
mod warp;
mod zorder;
