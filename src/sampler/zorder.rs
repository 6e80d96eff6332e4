//! Ahmed and Wonka 2020: one sequence for the image, dealt to the pixels along a shuffled Z curve.

use super::{Pair, call_shape, domain_word, halves, row_by_pixels, row_shape};
use crate::{hash, zorder};

/// Z-order sampling: all pixels share one [scrambled (0, 2)-sequence](zorder::point), so that the points of neighbours
/// complete each other, whatever their number.
///
/// Every 2ᵏ×2ᵏ block of pixels that is aligned on the curve holds a net together, for its first 1, 2, 4, 8, … samples, known
/// beforehand or not, in all dimension pairs. On smooth integrands a pixel's own error is below that of
/// [`White`](crate::White) from 2 samples on, on half-planes about the same (`cargo run --release -p report -- error`).
/// Other numbers are a little less blue. No table and no tile: pixels are unrelated only across the borders of 65536²
/// blocks, which are seeded anew. A pixel costs a hash, a Morton code and a scramble in base 4; a domain a scramble, two
/// products (a hash more if it is no constant) and forty operations; a sample the shuffle of its number and thirty
/// operations.
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
        let seed = hash::mix_64((self.seed as u64) << 32 | frame as u64);
        // A product is enough: what is seeded by it is hashed or multiplied by an odd number of the domain's.
        let seed = seed ^ (block as u64).wrapping_mul(0x9e37_79b9_7f4a_7c15);
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
        let shift = domain_word(self.seed, domain, pad);
        // Without an order of its own, a domain would fill its strata over the pixels in step with the others.
        let place_rev = hash::laine_karras(self.place_rev, (shift >> 16) as u32);
        // Neighbours differ in the upper bits alone: the upper half of a product spreads them.
        let order = hash::other(place_rev);
        ZOrderPair { first_rev: zorder::first_index(place_rev).reverse_bits(), order, shift }
    }
}

/// What a pair of dimensions has for all samples of a pixel.
#[derive(Clone, Copy)]
struct ZOrderPair {
    /// Where the pixel begins on the sequence; bit-reversed.
    first_rev: u32,
    /// The order of its samples.
    order: u32,
    /// A digital shift, which all pixels have in common.
    shift: u64,
}

impl Pair for ZOrderPair {
    #[inline]
    fn point(self, index_rev: u32) -> [u32; 2] {
        // The pairs of a pixel see the same first 2ᵏ samples in orders of their own.
        let own = if index_rev == 0 { 0 } else { hash::shuffle_rev(index_rev, self.order) };
        halves(zorder::packed_rev(own ^ self.first_rev) ^ self.shift)
    }
}

call_shape!(impl[] ZOrderPixel, pair);
row_shape!(impl[] ZOrder);
row_by_pixels!(impl[] ZOrder);
