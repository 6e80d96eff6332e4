//! Ahmed and Wonka 2020: one sequence for the image, dealt to the pixels along a shuffled Z curve.

use super::{call_shape, padded};
use crate::{hash, sobol, zorder};

/// Z-order sampling: all pixels share one Owen-scrambled (0, 2)-sequence, so that the points of neighbours complete each
/// other, whatever their number.
///
/// Every 2ᵏ×2ᵏ block of pixels that is aligned on the curve holds a net together, for its first 1, 2, 4, 8, … samples: the
/// blueness is the same for all powers of two, known beforehand or not, and in all dimension pairs, and every pixel has
/// points as good as those of [`White`](crate::White). With other numbers it is a little less. No table and no tile:
/// pixels are unrelated only across the borders of 65536² blocks, which are seeded anew. A pixel costs a Morton code
/// and a scramble, a draw more than one of `White` by itself and half as much in a [`fill`](ZOrderPixel::fill).
#[derive(Clone, Copy, Debug)]
pub struct ZOrder {
    seed: u32,
}

impl ZOrder {
    /// Progressive: the sequence goes on for as long as it is asked.
    #[inline]
    #[must_use]
    pub const fn new(seed: u32) -> Self {
        Self { seed }
    }

    /// The same as [`new`](Self::new); `spp` makes no difference. Powers of two, odd ones too, are best.
    #[inline]
    #[must_use]
    pub const fn with_spp(seed: u32, spp: u32) -> Self {
        _ = spp;
        Self::new(seed)
    }

    /// The samples of one pixel in one frame.
    #[inline]
    #[must_use]
    pub const fn pixel(&self, x: u32, y: u32, frame: u32) -> ZOrderPixel {
        let block = (x >> 16) | (y & 0xffff_0000);
        let seed = hash::combine(hash::combine(self.seed, frame), block);
        ZOrderPixel { seed, place_rev: hash::laine_karras_4(zorder::morton_16(x, y).reverse_bits(), seed) }
    }
}

/// One pixel of [`ZOrder`].
#[derive(Clone, Copy, Debug)]
pub struct ZOrderPixel {
    seed: u32,
    /// Place on the curve, its squares shuffled; bit-reversed.
    place_rev: u32,
}

impl ZOrderPixel {
    #[inline]
    const fn single(self, domain: u32, pad: u32) -> ZOrderPair {
        self.pair(domain, pad)
    }

    #[inline]
    #[expect(clippy::cast_possible_truncation, reason = "pieces of a hash")]
    const fn pair(self, domain: u32, pad: u32) -> ZOrderPair {
        let seeds = hash::mix_64((self.seed as u64) << 32 | (padded(domain, pad)) as u64);
        // Without an order of its own, a domain would fill its strata over the pixels in step with the others.
        let place_rev = hash::laine_karras(self.place_rev, (seeds >> 16) as u32);
        // Neighbours differ in the upper bits alone: the upper half of a product spreads them.
        let order = hash::other(place_rev);
        ZOrderPair { first: zorder::first_index(place_rev), order, seeds: [seeds as u32, (seeds >> 32) as u32] }
    }
}

/// What a pair of dimensions has for all samples of a pixel.
#[derive(Clone, Copy)]
struct ZOrderPair {
    /// Where the pixel begins on the Sobol sequence.
    first: u32,
    /// The order of its samples.
    order: u32,
    seeds: [u32; 2],
}

impl ZOrderPair {
    #[inline]
    #[expect(clippy::cast_possible_truncation, reason = "halves of a word")]
    const fn at(self, index: u32) -> [u32; 2] {
        let index = self.index(index);
        let x = hash::laine_karras(index, self.seeds[0]);
        let y = hash::laine_karras(sobol::dimension_1_rev(index), self.seeds[1]);
        // Two reversals for the price of one.
        let both = ((y as u64) << 32 | x as u64).reverse_bits();
        [(both >> 32) as u32, both as u32]
    }

    /// The first number alone.
    #[inline]
    const fn first(self, index: u32) -> u32 {
        hash::laine_karras(self.index(index), self.seeds[0]).reverse_bits()
    }

    /// On the Sobol sequence. The pairs of a pixel see the same first 2ᵏ samples in orders of their own.
    #[inline]
    const fn index(self, index: u32) -> u32 {
        hash::shuffle_rev(index.reverse_bits(), self.order).reverse_bits() ^ self.first
    }
}

call_shape!(impl[] ZOrderPixel);
