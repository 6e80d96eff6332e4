//! The uncorrelated control: what every renderer has without this crate.

use super::{Pair, call_shape, domain_seed, padded, row_by_pixels, row_shape};
use crate::{hash, sobol};

/// Owen-scrambled Sobol points under a seed of every pixel's own: little error in each pixel, spread as white noise.
#[derive(Clone, Copy, Debug)]
pub struct White {
    seed: u32,
}

impl White {
    /// Progressive: the sequence goes on for as long as it is asked.
    #[inline]
    #[must_use]
    pub const fn new(seed: u32) -> Self {
        Self { seed }
    }

    /// The same as [`new`](Self::new); `spp` makes no difference.
    #[inline]
    #[must_use]
    pub const fn with_spp(seed: u32, spp: u32) -> Self {
        _ = spp;
        Self::new(seed)
    }

    /// The samples of one pixel in one frame.
    #[inline]
    #[must_use]
    pub const fn pixel(&self, x: u32, y: u32, frame: u32) -> WhitePixel {
        // x is hashed first: added as it is, two rows with near seeds would be shifted copies.
        let row = hash::combine(hash::combine(self.seed, frame), y);
        WhitePixel { seed: hash::combine(row, hash::mix(x)) }
    }
}

/// One pixel of [`White`].
#[derive(Clone, Copy, Debug)]
pub struct WhitePixel {
    seed: u32,
}

impl WhitePixel {
    #[inline]
    pub(super) const fn pair(self, domain: u32, pad: u32) -> WhitePair {
        WhitePair { seed: domain_seed(self.seed, domain, pad) }
    }
}

/// The pair of a domain.
#[derive(Clone, Copy)]
pub(super) struct WhitePair {
    seed: u32,
}

impl Pair for WhitePair {
    #[inline]
    fn point(self, index_rev: u32) -> [u32; 2] {
        sobol::owen_point(hash::shuffle_rev(index_rev, self.seed).reverse_bits(), self.seed)
    }
}

padded!(impl[] WhitePixel, pair);
call_shape!(impl[] WhitePixel);
row_shape!(impl[] White);
row_by_pixels!(impl[] White);
