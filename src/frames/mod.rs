//! Over time: what a renderer that shows frame after frame can do beyond the samplers' `frame` argument.
//!
//! Each part sits behind a feature of its own, off by default. Patents of others are reported on spatiotemporal
//! blue-noise masks, and may touch the rest: have that checked before you ship it. The `frame` argument, which moves
//! look-ups and seeds anew, is not concerned.

pub mod masks;
#[cfg(feature = "seed-permutation")]
pub mod seeds;
