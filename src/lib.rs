//! Blue-noise dithered sampling.
#![no_std]

pub mod effort;
pub mod hash;
pub mod mask;
#[cfg(feature = "pattern")]
pub mod pattern;
pub mod sampler;
pub mod shift;
pub mod sobol;
pub mod strata;
pub mod tables;
pub mod torus;
pub mod unit;
#[cfg(feature = "warp")]
pub mod warp;

pub use mask::{ScalarMask, VectorMask};
pub use sampler::{Constant, Dithered, White};
