//! Random numbers for renderers, chosen per pixel so that the error left in the picture is *blue noise*:
//! high-frequency, evenly spread, the least visible to the eye and the easiest to denoise.
//!
//! No `std`, no allocation, no `unsafe`, no state: every number is a pure function of (tables, pixel, frame, domain,
//! index), the same on every machine and thread. `build.rs` optimises the masks; the constants of [`Sampler`] come
//! frozen.
//!
//! # Limits
//! - It pays off where the picture is smooth over a few pixels; at edges and in fine texture the error is white.
//! - Draw from one domain what a picture needs together: its eight numbers are blue together, what several domains do
//!   together is white (see [`Sampler`]).
//! - The masks of [`Dithered`] repeat every 64×64 pixels and pay off at 1 to 9 samples per pixel.
//! - Not for cryptography or statistics: neighbouring pixels are correlated on purpose.
//!
//! # The pixel loop
//! ```
//! use bluedither::Sampler;
//!
//! const CAMERA: u32 = 0; // a domain names what its numbers are for, which are blue together:
//! const LIGHT: u32 = 1; // different domains are decorrelated
//!
//! let (seed, spp, frame) = (1, 4, 0);
//! let sampler = Sampler::with_spp(seed, spp); // or Sampler::new(seed), if the number is not known
//! for (x, y) in [(0, 0), (1, 0)] {
//!     let pixel = sampler.pixel(x, y, frame);
//!     for index in 0..spp {
//!         let [u, v, t] = pixel.draw::<3>(CAMERA, index); // f32 in [0, 1); up to eight
//!         let [a, b] = pixel.draw::<2>(LIGHT, index);
//!         assert!(u < 1.0 && v < 1.0 && t < 1.0 && a < 1.0 && b < 1.0);
//!     }
//! }
//! ```
//! All samplers have this shape: change the one word to compare.
//!
//! # What to use when
//! | you have | take |
//! |---|---|
//! | a renderer | [`Sampler`]`::with_spp` |
//! | a renderer that stops when it likes | [`Sampler`]`::new` |
//! | one dimension at a time, few samples, hard steps | [`Dithered`]`::with_spp` |
//! | one number a pixel: a threshold, a ray-march start | [`ScalarMask::value`] of a threshold mask |
//! | a display of few levels, an e-ink panel, banding | [`Dither`] |
//! | the same, and frames that are averaged | a mask over time (feature `threshold-over-time-64`, see [`frames::masks`]) |
//! | the same, and a filter that you know | a mask for it (feature `threshold-filtered-64`, see [`frames::masks`]) |
//! | frames of paths of many dimensions | `White` of a seed a pixel, permuted (feature `seed-permutation`, see `frames::seeds`) |
//! | your own points | [`shift::global`] or [`shift::stratified_2d`] by [`VectorMask::value_fx`] |
//! | a renderer that stops when it likes, often after one sample, and 16 KB | [`Keyed`] (feature `keys-64`) |
//! | a rank-1 lattice, up to 4 samples per pixel | `Dithered::lattice` (feature `lattice-64`) |
//! | a picture without smooth parts | [`White`] |
//! | your own masks | [`ScalarMask::from_slice`], [`VectorMask::from_slice`], [`Dithered::with_masks`] |
//! | a shader | the same functions as WGSL (feature `wgsl`, see `shader`) |
//!
//! # Features
//! A table is baked only if its feature is on, and linked only if it is used. Features add items and change no value.
//!
//! | feature | table | bytes |
//! |---|---|---|
//! | `threshold-16` | void-and-cluster, one channel | 512 |
//! | `threshold-32` | | 2,048 |
//! | `threshold-64` (default) | | 8,192 |
//! | `threshold-128` | | 32,768 |
//! | `threshold-256` | | 131,072 |
//! | `offset-1d-16` | offsets, one channel, good at 1, 4 and 16 samples | 512 |
//! | `offset-1d-32` | | 2,048 |
//! | `offset-1d-64` | | 8,192 |
//! | `offset-1d-128` | | 32,768 |
//! | `offset-2d-16` | offsets, two channels, good at 1, 4 and 16 samples | 1,024 |
//! | `offset-2d-32` | | 4,096 |
//! | `offset-2d-64` (default) | | 16,384 |
//! | `offset-2d-128` | | 65,536 |
//! | `keys-64` | scrambling keys, good at any number of samples | 16,384 |
//! | `keys-128` | | 65,536 |
//! | `lattice-64` | shifts of a rank-1 lattice, good at 1, 4 and 16 samples | 16,384 |
//! | `sobol-16` | direction numbers of the Sobol sequence, in `tables` | 2,048 |
//! | `sobol-64` | | 8,192 |
//! | `sobol-256` | | 32,768 |
//! | `sobol-1024` | | 131,072 |
//! | `threshold-over-time-32` | `frames::masks`: a mask for each of 32 frames; see the caution in `frames` | 65,536 |
//! | `threshold-over-time-64` | the same for each of 16 | 131,072 |
//! | `threshold-over-time-128` | the same for each of 64; some ten seconds to build | 2,097,152 |
//! | `offset-2d-over-time-32` | two channels for each of 16 frames; the same caution | 65,536 |
//! | `offset-2d-over-time-64` | the same for each of 8 | 131,072 |
//! | `threshold-filtered-64` | a threshold mask for the filter that comes after it, see below | 8,192 |
//! | `threshold-filtered-over-time-64` | the same for each of 16 frames and a moving average; the same caution | 131,072 |
//! | `seed-permutation` | `frames::seeds`: swaps of seeds between frames; see the caution there | 8,192 |
//! | `warp` (default) | `warp`: disk, sphere, hemisphere, triangle, Gaussian; needs `libm` | |
//! | `bytemuck` (default) | `bytes()` of every mask; needs `bytemuck` | |
//! | `pattern` (default) | `pattern`: a pixel's whole set at once; needs `heapless` | |
//! | `float` | rows of `f32` in [`dither`] | |
//! | `gamma` | [`dither`] in linear light | 512 |
//! | `wgsl` | `shader`: the same functions as WGSL text, and tables as words | |
//! | `embedded-graphics` | `dither::target`, a draw target of fewer colours; needs `embedded-graphics-core` | |
//!
//! With `default-features = false` the crate has no dependency at run time and keeps all that needs no table:
//! [`Sampler`], [`White`], [`candidate`], [`dither`], [`frames::masks`], [`sobol`], [`sequence`], [`net`],
//! [`zorder`], [`lattice`], [`strata`], [`shift`], [`hash`], [`torus`], [`unit`](mod@unit), and [`Dithered`] and
//! [`Keyed`] by masks and keys of your own.
//!
//! The environment variable `BLUEDITHER_EFFORT` (`quick`, `normal`, `thorough`) sets how long the tables are
//! optimised; [`tables::EFFORT`] tells how long they were. `cargo build -vv` shows what was baked.
//!
//! `BLUEDITHER_FILTER` says what comes after the `threshold-filtered` masks: `gaussian:1.5` (standard deviation in
//! pixels), `box:5`, `binomial:3` (taps along an axis), `ema:0.2` (the part of every new frame that a moving average
//! takes), or one over pixels and `ema` joined by `+`. Without it, and for the half that is not named, it is
//! `box:3+ema:0.1`; `tables::FILTER` tells what it was. Only the masks of that default have a recorded digest.
//!
//! # Vocabulary
//! *rank*: position of a pixel in a mask's order · *shift*: of values, modulo 1 · *offset*: of coordinates, toroidal;
//! also, as in the literature, the shift that a mask holds · *scramble*: bits · *permute*, *shuffle*: order ·
//! *turn*: shift of cells modulo their count ·
//! *domain*: purpose of a draw · *index*: sample number · *frame*: time · *bake*: optimise and write.
//! Postfixes: `_fx` 0.32 fixed point, `_log2`, `_rev` bit-reversed.
#![no_std]

pub mod candidate;
pub mod dither;
pub mod effort;
pub mod frames;
pub mod hash;
pub mod keys;
pub mod lattice;
pub mod mask;
pub mod net;
#[cfg(feature = "pattern")]
pub mod pattern;
pub mod sampler;
pub mod sequence;
#[cfg(feature = "wgsl")]
pub mod shader;
pub mod shift;
pub mod sobol;
pub mod strata;
pub mod tables;
pub mod torus;
pub mod unit;
#[cfg(feature = "warp")]
pub mod warp;
pub mod zorder;

pub use dither::Dither;
pub use keys::Keys;
pub use mask::{ScalarMask, VectorMask};
pub use sampler::{Dithered, Keyed, Sampler, White};

/// The README's examples, compiled.
#[cfg(all(doctest, feature = "threshold-64", feature = "offset-2d-64"))]
#[doc = include_str!("../README.md")]
struct Readme;
