//! Ahmed and Wonka 2020: one sequence for the image, dealt to the pixels along a shuffled Z curve.

use super::{Pair, call_shape, domain_word, halves, row_by_pixels, row_shape};
use crate::{hash, sobol, zorder};

/// Z-order sampling: all pixels share one Owen-scrambled (0, 2)-sequence, so that the points of neighbours complete each
/// other, whatever their number.
///
/// Every 2ᵏ×2ᵏ block of pixels that is aligned on the curve holds a net together, for its first 1, 2, 4, 8, … samples: the
/// blueness is the same for all powers of two, known beforehand or not, and in all dimension pairs, and every pixel has
/// points as good as those of [`White`](crate::White). With other numbers it is a little less. No table and no tile:
/// pixels are unrelated only across the borders of 65536² blocks, which are seeded anew. A pixel costs a Morton code
/// and a scramble, a draw some tenth more than one of `White` (`cargo run --release -p report -- speed`).
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
    #[expect(clippy::cast_possible_truncation, reason = "half of a hash")]
    pub const fn pixel(&self, x: u32, y: u32, frame: u32) -> ZOrderPixel {
        let block = (x >> 16) | (y & 0xffff_0000);
        let seed = hash::mix_64(hash::mix_64((self.seed as u64) << 32 | frame as u64) ^ block as u64);
        ZOrderPixel { seed, place_rev: hash::laine_karras_4(zorder::morton_16(x, y).reverse_bits(), seed as u32) }
    }
}

/// One pixel of [`ZOrder`].
#[derive(Clone, Copy, Debug)]
pub struct ZOrderPixel {
    /// Of a square of 65536².
    seed: u64,
    /// Place on the curve, its squares shuffled; bit-reversed.
    place_rev: u32,
}

impl ZOrderPixel {
    #[inline]
    #[expect(clippy::cast_possible_truncation, reason = "pieces of a hash")]
    const fn pair(self, domain: u32, pad: u32) -> ZOrderPair {
        let seeds = domain_word(self.seed, domain, pad);
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
    /// On the Sobol sequence. The pairs of a pixel see the same first 2ᵏ samples in orders of their own.
    #[inline]
    const fn place(self, index_rev: u32) -> u32 {
        let index = if index_rev == 0 { 0 } else { hash::shuffle_rev(index_rev, self.order).reverse_bits() };
        index ^ self.first
    }
}

impl Pair for ZOrderPair {
    #[inline]
    fn point(self, index_rev: u32) -> [u32; 2] {
        let place = self.place(index_rev);
        let x = hash::laine_karras(place, self.seeds[0]);
        let y = hash::laine_karras(sobol::dimension_1_rev(place), self.seeds[1]);
        // Two reversals for the price of one.
        let [y, x] = halves(((x as u64) << 32 | y as u64).reverse_bits());
        [x, y]
    }
}

call_shape!(impl[] ZOrderPixel, pair);
row_shape!(impl[] ZOrder);
row_by_pixels!(impl[] ZOrder);
