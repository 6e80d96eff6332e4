//! Over time: what a renderer that shows frame after frame can do beyond the samplers' `frame` argument.
//!
//! | you have | take | table |
//! |---|---|---|
//! | anything: the default | the samplers' `frame`: those of `Sampler` go on where the last one stopped, others average as independent ones do; each is as blue as the first | |
//! | a threshold or one number a pixel, and frames that are averaged | [`TimeMask`](masks::TimeMask), feature `threshold-over-time-64` | 128 KiB |
//! | the same on a tile of 128² pixels, with 64 frames before they repeat (a second at 60 Hz) | the same, `threshold-over-time-128` | 2 MiB |
//! | pairs of numbers, one sample a frame, averaged over time alone (after a filter over pixels `Sampler` is as good) | [`VectorTimeMask`](masks::VectorTimeMask), `offset-2d-over-time-64` | 128 KiB |
//! | one of the first two, and a filter that you know | [`masks`], `threshold-filtered-64`, `threshold-filtered-over-time-64` | 8, 128 KiB |
//! | paths of many dimensions, a picture that is smooth and moves little | `seeds`, `seed-permutation` | 8 KiB, and 8 KiB of `threshold-64` |
//!
//! A mask over time costs a look-up and one load more than a still one; frames of it shown without any average have up
//! to a third more error than those of a still one.
//!
//! Tables over time sit behind features of their own, off by default. Patents of others are reported on spatiotemporal
//! blue-noise masks, and may touch the rest, filters over time and seed permutation: have that checked before you ship
//! it. The `frame` argument, which moves look-ups and seeds anew, is not concerned.

pub mod masks;
#[cfg(feature = "seed-permutation")]
pub mod seeds;
