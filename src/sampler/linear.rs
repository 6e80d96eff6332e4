//! The recommended sampler: the linear pixel order.

use super::{Pair, call_shape, domain_word, halves, padded, row_shape};
use crate::hash;
use crate::linear::{self, BLOCK_LOG2, Columns, Order, SETS};
use crate::tables::LINEAR_ORDER;

/// Blue-noise error at every number of samples, from points that are better than Owen-scrambled ones: the
/// [linear pixel order](crate::linear).
///
/// All pixels share one digital net; a pixel's place decides which part of it is the pixel's own. No mask and no tile;
/// 3,648 bytes of constants. Best at powers of two. Every pair of every domain is as good as the first; what several of
/// them do together is white, except that the first two samples of different domains are related over blocks of 32×32
/// pixels when the number of samples is 1, not known, or no power of two up to 256: under wide filters that is seen. A
/// pixel costs two hashes; a domain one and two products (two hashes if it is no constant), and some forty operations; a sample the
/// shuffle of its number (a bit reversal, which domains share, and three products), two look-ups, and one for each bit
/// set above the eighth.
#[derive(Clone, Copy, Debug)]
pub struct Sampler {
    order: &'static Order,
    /// Bits of a sample's number that a pixel may flip.
    flips_rev: u32,
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
        Self { order: &LINEAR_ORDER.progressive, flips_rev: 0, seed }
    }

    /// `spp` samples per pixel: bluer than by [`new`](Self::new) once all are drawn, and less so before.
    ///
    /// For powers of two up to 256; 0 counts as 1. Other numbers are drawn as by [`new`](Self::new). An `index` ≥ `spp`
    /// continues the sequence: at every power of two the points are a net again.
    #[inline]
    #[must_use]
    pub const fn with_spp(seed: u32, spp: u32) -> Self {
        match LINEAR_ORDER.known(spp) {
            Some(order) => Self { order, flips_rev: spp.saturating_sub(1).reverse_bits(), seed },
            None => Self::new(seed),
        }
    }

    /// The samples of one pixel in one frame. Any coordinates and frame; negative ones are passed `as u32`.
    #[inline]
    #[must_use]
    pub const fn pixel(&self, x: u32, y: u32, frame: u32) -> LinearPixel {
        let seed = self.seed(frame);
        LinearPixel { order: self.order, flips_rev: self.flips_rev, seed, own: own(seed, x, y), x, y }
    }

    /// The seed of a frame.
    #[inline]
    const fn seed(&self, frame: u32) -> u64 {
        hash::mix_64((self.seed as u64) << 32 | frame as u64)
    }

    /// What a sample of a row of pixels has in a pair, pixel by pixel: inside a block the words are linear in x.
    #[inline]
    fn words_of_row<T>(
        &self,
        pad: u32,
        [mut x, y, frame]: [u32; 3],
        domain: u32,
        index: u32,
        mut targets: impl Iterator<Item = T>,
        put: impl Fn(T, u64),
    ) {
        let index_rev = index.reverse_bits();
        let seed = self.seed(frame);
        let (mut place_x, place_y) = place(seed, domain, pad, x, y);
        let mut next = targets.next();
        while next.is_some() {
            let shared = Shared::new(self.order, seed, place_x, place_y);
            let columns = shared.columns_of_x();
            let mut key = shared.key(place_x, place_y);
            while let Some(target) = next {
                put(target, shared.pair(key, own(seed, x, y), self.flips_rev).word(index_rev));
                x = x.wrapping_add(1);
                place_x = place_x.wrapping_add(1);
                next = targets.next();
                if place_x & INSIDE == 0 {
                    break;
                }
                key ^= columns[(place_x.trailing_zeros() & 7) as usize];
            }
        }
    }

    #[inline]
    fn row<const D: usize, T>(
        &self,
        row: [u32; 3],
        domain: u32,
        index: u32,
        samples: &mut [[T; D]],
        convert: impl Fn(u32) -> T + Copy,
    ) {
        self.pair_of_row::<0, D, T>(row, domain, index, samples, convert);
        if D > 2 {
            self.pair_of_row::<1, D, T>(row, domain, index, samples, convert);
        }
        if D > 4 {
            self.pair_of_row::<2, D, T>(row, domain, index, samples, convert);
        }
        if D > 6 {
            self.pair_of_row::<3, D, T>(row, domain, index, samples, convert);
        }
    }

    #[inline(always)]
    fn pair_of_row<const PAD: u32, const D: usize, T>(
        &self,
        row: [u32; 3],
        domain: u32,
        index: u32,
        samples: &mut [[T; D]],
        convert: impl Fn(u32) -> T + Copy,
    ) {
        self.words_of_row(PAD, row, domain, index, samples.iter_mut(), |sample, word| {
            let [u, v] = halves(word);
            sample[2 * PAD as usize] = convert(u);
            if 2 * (PAD as usize) + 1 < D {
                sample[2 * PAD as usize + 1] = convert(v);
            }
        });
    }
}

/// Coordinates inside a block.
const INSIDE: u32 = (1 << BLOCK_LOG2) - 1;

/// Where a pixel lies for a pair of dimensions: those of every seed, frame and domain have a place at random on one plane
/// of 2³² pixels a side. So their blocks begin elsewhere, and two that have the same columns are moved against each other.
#[inline]
#[expect(clippy::cast_possible_truncation, reason = "halves of a hash")]
const fn place(seed: u64, domain: u32, pad: u32, x: u32, y: u32) -> (u32, u32) {
    let far = domain_word(seed, domain, pad);
    // The place inside a block is of a product's upper bits: its lowest are the same for too many domains.
    (x.wrapping_add((far >> 32) as u32), y.wrapping_add((far as u32).rotate_left(5)))
}

/// The hash of a pixel.
#[inline]
#[expect(clippy::cast_possible_truncation, reason = "half of a hash")]
const fn own(seed: u64, x: u32, y: u32) -> u32 {
    hash::mix((seed as u32).wrapping_add(x) ^ y.rotate_left(16))
}

/// One pixel of [`Sampler`].
#[derive(Clone, Copy, Debug)]
pub struct LinearPixel {
    order: &'static Order,
    flips_rev: u32,
    /// Of the frame.
    seed: u64,
    /// A hash of the pixel.
    own: u32,
    x: u32,
    y: u32,
}

impl LinearPixel {
    #[inline]
    const fn pair(self, domain: u32, pad: u32) -> LinearPair {
        let (x, y) = place(self.seed, domain, pad, self.x, self.y);
        let shared = Shared::new(self.order, self.seed, x, y);
        shared.pair(shared.key(x, y), self.own, self.flips_rev)
    }
}

/// What all pixels of a block have in common: one of the sets, transposed or not, its numbers swapped or
/// not, and a digital shift.
#[derive(Clone, Copy)]
struct Shared {
    columns: &'static Columns,
    shift: u64,
    /// Bits of no weight choose.
    choice: u32,
}

impl Shared {
    #[inline]
    const fn new(order: &'static Order, seed: u64, x: u32, y: u32) -> Self {
        let shift = hash::mix_64(seed ^ ((y >> BLOCK_LOG2) as u64) << 32 ^ (x >> BLOCK_LOG2) as u64);
        let choice = (shift >> 32) as u32;
        Self { columns: &order[choice as usize % SETS], shift, choice }
    }

    #[inline]
    const fn transposed(self) -> bool {
        self.choice >> 3 & 1 == 1
    }

    /// What a pixel adds to its points. Inside the block it lies by the lower bits.
    #[inline]
    const fn key(self, x: u32, y: u32) -> u64 {
        let (x, y) = if self.transposed() { (y, x) } else { (x, y) };
        self.shift ^ in_place(linear::digits(self.columns, x, y))
    }

    /// What the pixel of a key has.
    #[inline]
    #[expect(clippy::cast_possible_truncation, reason = "pieces of a hash")]
    const fn pair(self, key: u64, own: u32, flips_rev: u32) -> LinearPair {
        // All pixels of a block in one order of samples would keep two domains in step over it.
        let random = ((self.choice ^ own) as u64).wrapping_mul(0x9e37_79b9_7f4a_7c15);
        let (shuffle, flip_rev) = ((random >> 32) as u32, random as u32 & flips_rev);
        LinearPair { key, swap: self.choice << 1 & 32, shuffle, flip_rev }
    }

    /// What the key of a pixel differs by from that of its left neighbour, in a block, by the trailing zeros of x.
    #[inline]
    const fn columns_of_x(self) -> [u64; 8] {
        // Eight and a mask, so that no bounds check is left.
        let mut columns = [0; 8];
        let (mut sum, mut bit) = (0, 0);
        while bit < BLOCK_LOG2 as usize {
            sum ^= in_place(self.columns[2 * bit + self.transposed() as usize]);
            columns[bit] = sum;
            bit += 1;
        }
        columns
    }
}

/// Digits where a key has them.
#[inline]
const fn in_place(digits: u32) -> u64 {
    (digits as u64 >> 16) << 48 | (digits as u64 & 0xffff) << 16
}

/// The pair of a domain.
#[derive(Clone, Copy)]
struct LinearPair {
    key: u64,
    swap: u32,
    shuffle: u32,
    flip_rev: u32,
}

impl LinearPair {
    /// A sample, both numbers in one word, the first in the upper half.
    #[inline]
    const fn word(self, index_rev: u32) -> u64 {
        let index_rev = if index_rev == 0 { 0 } else { hash::shuffle_rev(index_rev, self.shuffle) } ^ self.flip_rev;
        (LINEAR_ORDER.sequence.packed_rev(index_rev) ^ self.key).rotate_left(self.swap)
    }
}

impl Pair for LinearPair {
    #[inline]
    fn point(self, index_rev: u32) -> [u32; 2] {
        halves(self.word(index_rev))
    }
}

padded!(impl[] LinearPixel, pair);
call_shape!(impl[] LinearPixel);
row_shape!(impl[] Sampler);
