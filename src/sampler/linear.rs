//! The recommended sampler: the linear pixel order.

use super::{call_shape, domain_seed, spread};
use crate::hash;
use crate::linear::{self, BLOCK_LOG2, Order, SETS};
use crate::tables::LINEAR_ORDER;

/// Blue-noise error at every number of samples, from points that are better than Owen-scrambled ones: the
/// [linear pixel order](crate::linear).
///
/// All pixels share one digital net; a pixel's place decides which part of it is the pixel's own. No mask and no tile;
/// 3,648 bytes of constants. Best at powers of two. Every pair of every domain is as good as the first; what several of
/// them do together is white, except that first samples of different domains may be related over a block of 32×32 pixels
/// when the number of samples is 1, not known, or no power of two up to 256. A domain costs five hashes and ten XORs; a sample a
/// shuffle of its number (two bit reversals, three products), two look-ups, and one for each bit set above the eighth.
#[derive(Clone, Copy, Debug)]
pub struct Sampler {
    order: &'static Order,
    /// Bits of a sample's number that a pixel may flip.
    flips: u32,
    seed: u32,
}

impl Sampler {
    /// Progressive: the sequence goes on for as long as it is asked, and every power of two is a good moment to stop.
    ///
    /// Smooth integrands are bluest up to some 32 samples; beyond 256 the points go on as a (0, 2)-sequence, and blueness
    /// fades.
    #[inline]
    #[must_use]
    pub const fn new(seed: u32) -> Self {
        Self { order: &LINEAR_ORDER.progressive, flips: 0, seed }
    }

    /// `spp` samples per pixel: bluer than by [`new`](Self::new) once all are drawn, and less so before.
    ///
    /// For powers of two up to 256; 0 counts as 1. Other numbers are drawn as by [`new`](Self::new). An `index` ≥ `spp`
    /// continues the sequence: at every power of two the points are a net again.
    #[inline]
    #[must_use]
    pub const fn with_spp(seed: u32, spp: u32) -> Self {
        match LINEAR_ORDER.known(spp) {
            Some(order) => Self { order, flips: spp.saturating_sub(1), seed },
            None => Self::new(seed),
        }
    }

    /// The samples of one pixel in one frame. Any coordinates and frame; negative ones are passed `as u32`.
    #[inline]
    #[must_use]
    pub const fn pixel(&self, x: u32, y: u32, frame: u32) -> LinearPixel {
        let seed = hash::combine(self.seed, frame);
        LinearPixel { order: self.order, flips: self.flips, seed, x, y }
    }
}

/// One pixel of [`Sampler`].
#[derive(Clone, Copy, Debug)]
pub struct LinearPixel {
    order: &'static Order,
    flips: u32,
    seed: u32,
    x: u32,
    y: u32,
}

impl LinearPixel {
    #[inline]
    const fn single(self, domain: u32, pad: u32) -> LinearPair {
        self.pair(domain, pad)
    }

    #[inline]
    const fn pair(self, domain: u32, pad: u32) -> LinearPair {
        const INSIDE: u32 = (1 << BLOCK_LOG2) - 1;
        let seed = domain_seed(self.seed, domain, pad);
        // Blocks of every domain begin elsewhere.
        let (x, y) = (self.x.wrapping_add(seed & INSIDE), self.y.wrapping_add(seed >> BLOCK_LOG2 & INSIDE));
        let random = hash::mix(seed ^ spread(x >> BLOCK_LOG2, y >> BLOCK_LOG2));
        // A block has one of the sets, transposed or not, its numbers swapped or not: by upper bits of a product with an
        // odd constant of no meaning.
        let choice = random.wrapping_mul(0xd6e8_feb5);
        let set = ((choice as u64 * SETS as u64) >> 32) as usize;
        let (u, v) = if choice >> 16 & 1 == 1 { (y & INSIDE, x & INSIDE) } else { (x & INSIDE, y & INSIDE) };
        let digits = random ^ linear::digits(&self.order[set], u, v);
        let low = hash::mix(seed);
        let key = ((digits >> 16) as u64) << 48 | ((low >> 16) as u64) << 32 | (digits << 16 | low & 0xffff) as u64;
        // All pixels of a block in one order of samples would keep two domains in step over it.
        let shuffle = hash::mix(seed ^ spread(self.x, self.y));
        LinearPair { key, swap: choice >> 12 & 32, shuffle, flip: hash::other(shuffle) >> 24 & self.flips }
    }
}

/// The pair of a domain.
#[derive(Clone, Copy)]
struct LinearPair {
    key: u64,
    swap: u32,
    shuffle: u32,
    flip: u32,
}

impl LinearPair {
    #[inline]
    #[expect(clippy::cast_possible_truncation, reason = "the lower half of the word")]
    const fn at(self, index: u32) -> [u32; 2] {
        let index = hash::shuffle_rev(index.reverse_bits(), self.shuffle).reverse_bits() ^ self.flip;
        let point = (LINEAR_ORDER.sequence.packed(index) ^ self.key).rotate_left(self.swap);
        [(point >> 32) as u32, point as u32]
    }

    #[inline]
    const fn first(self, index: u32) -> u32 {
        self.at(index)[0]
    }
}

call_shape!(impl[] LinearPixel);
