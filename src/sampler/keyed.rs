//! Heitz, Belcour, Ostromoukhov, Coeurjolly and Iehl 2019: one sequence for the image, scrambled by keys of every
//! pixel.

use super::{Pair, call_shape, domain_seed, halves, padded, row_by_pixels, row_shape};
use crate::tables::SEQUENCE;
use crate::{hash, keys::Keys, torus};

/// The points of one [sequence](crate::sequence), XORed in every pixel with the keys of a tile.
///
/// Blue at every number of samples; a net of its own in every pixel at every power of two. The keys are a net, too:
/// of the first samples of a tile, and of the second ones, each of S² equal parts of the interval has exactly one
/// in each channel. Every domain, pad and frame reads the tile at a place of its own, and every pixel visits its
/// points in an order of its own for each of them, so that the joint error of two domains is white noise. (Between
/// powers of two pixels have different points, and the error is less blue.) A domain costs a pixel a look-up, two
/// products and some XORs. A sample is a bit reversal, three products and a look-up in 2 KiB of points; from the
/// 257th on another look-up for each bit set above the eighth.
///
/// The first samples of two domains or frames are as good as uncorrelated over the pixels of a tile. A tile is patches
/// of 16×16 pixels, turned and mirrored at random: their errors show more of a pattern than an annealed mask has, and
/// the tile repeats every 64 pixels. It has 4096 places: of domains, frames or seeds that are thousands apart some two
/// read the same one, and have the same first samples but for the digits below the twelfth.
#[derive(Clone, Copy, Debug)]
pub struct Keyed<'a, const S: usize = 64> {
    keys: &'a Keys<S>,
    seed: u32,
}

#[cfg(feature = "keys-64")]
impl Keyed<'static, 64> {
    /// Samples per pixel unknown: the sequence goes on for as long as it is asked.
    #[inline]
    #[must_use]
    pub const fn new(seed: u32) -> Self {
        Self::with_keys(&crate::tables::KEYS_64, seed)
    }

    /// The same as [`new`](Self::new), whose table is made for every prefix; `spp` makes no difference.
    #[inline]
    #[must_use]
    pub const fn with_spp(seed: u32, spp: u32) -> Self {
        _ = spp;
        Self::new(seed)
    }
}

impl<'a, const S: usize> Keyed<'a, S> {
    /// With a table of your own choice.
    #[inline]
    #[must_use]
    pub const fn with_keys(keys: &'a Keys<S>, seed: u32) -> Self {
        Self { keys, seed }
    }

    /// The samples of one pixel in one frame. Any coordinates and frame; negative ones are passed `as u32`.
    #[inline]
    #[must_use]
    pub const fn pixel(&self, x: u32, y: u32, frame: u32) -> KeyedPixel<'a, S> {
        KeyedPixel { sampler: *self, x, y, frame }
    }
}

/// One pixel of [`Keyed`].
#[derive(Clone, Copy, Debug)]
pub struct KeyedPixel<'a, const S: usize = 64> {
    sampler: Keyed<'a, S>,
    x: u32,
    y: u32,
    frame: u32,
}

impl<const S: usize> KeyedPixel<'_, S> {
    // Inlined for certain: much of it is the same for all pixels, which a compiler sees only then.
    #[inline(always)]
    const fn pair(self, domain: u32, pad: u32) -> KeyedPair {
        let [dx, dy] = torus::offset(self.sampler.seed, domain, pad, self.frame, Keys::<S>::SIZE_LOG2);
        let digits = self.sampler.keys.digits(self.x.wrapping_add(dx), self.y.wrapping_add(dy));
        let seed = hash::combine(domain_seed(self.sampler.seed, domain, pad), self.frame);
        let order = scatter(digits ^ seed);
        // The lower digits are as random.
        KeyedPair { key: [digits & 0xffff_0000 | order >> 16, digits << 16 | order & 0xffff], order }
    }
}

/// A pixel's own order. Its key tells it from the other pixels of the tile, so that nothing else need be hashed; the
/// lower half of the product knows the second key only, and takes in the upper half.
#[inline(always)]
const fn scatter(value: u32) -> u32 {
    let product = value.wrapping_mul(0x9e37_79b1);
    product ^ product >> 15
}

/// The pair of a domain.
#[derive(Clone, Copy)]
struct KeyedPair {
    key: [u32; 2],
    order: u32,
}

impl Pair for KeyedPair {
    #[inline(always)]
    fn point(self, index_rev: u32) -> [u32; 2] {
        // All pixels in one order would have one joint error of two domains.
        let index_rev = hash::shuffle_rev(index_rev, self.order);
        let mut point = POINTS_REV[(index_rev >> 24) as usize];
        if index_rev << 8 != 0 {
            point = xor(point, later(index_rev));
        }
        xor(point, self.key)
    }
}

/// What the bits above the eighth add to a point.
#[cold]
const fn later(index_rev: u32) -> [u32; 2] {
    halves(SEQUENCE.packed_rev(index_rev & 0x00ff_ffff))
}

#[inline(always)]
const fn xor(a: [u32; 2], b: [u32; 2]) -> [u32; 2] {
    [a[0] ^ b[0], a[1] ^ b[1]]
}

/// The first 256 points, at the bit-reversed index.
static POINTS_REV: [[u32; 2]; 256] = {
    let mut points = [[0; 2]; 256];
    let mut index = 0u32;
    while index < 256 {
        points[(index.reverse_bits() >> 24) as usize] = halves(SEQUENCE.packed(index));
        index += 1;
    }
    points
};

padded!(impl['a, const S: usize] KeyedPixel<'a, S>, pair);
call_shape!(impl['a, const S: usize] KeyedPixel<'a, S>);
row_shape!(impl['a, const S: usize] Keyed<'a, S>);
row_by_pixels!(impl['a, const S: usize] Keyed<'a, S>);
