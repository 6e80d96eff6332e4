//! Heitz, Belcour, Ostromoukhov, Coeurjolly and Iehl 2019: one sequence for the image, scrambled by keys of every pixel.

use super::{call_shape, domain_seed};
use crate::tables::LINEAR_ORDER;
use crate::{hash, keys::Keys, torus};

/// The points of [`Sampler`](crate::Sampler), XORed in every pixel with the keys of a tile.
///
/// Blue at every number of samples, and at one sample bluer than `Sampler`'s progressive order; a net of its own in every
/// pixel at every power of two. Every domain, pad and frame reads the tile at a place of its own and visits the sequence
/// in an order of its own, the same for all pixels. A domain costs a look-up and what does not depend on the pixel; a
/// sample a shuffle of its number (two bit reversals, three products) and two look-ups, and one more for each bit set
/// above the eighth.
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

    /// The same as [`new`](Self::new), whose table is made for every prefix; `spp` makes no difference. For one made
    /// for 4 or 16 samples, bake it (`keys-64-spp-4`, `keys-64-spp-16`) and take [`with_keys`](Self::with_keys).
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
    #[inline]
    const fn single(self, domain: u32, pad: u32) -> KeyedPair {
        self.pair(domain, pad)
    }

    #[inline]
    const fn pair(self, domain: u32, pad: u32) -> KeyedPair {
        let [dx, dy] = torus::offset(self.sampler.seed, domain, pad, self.frame, Keys::<S>::SIZE_LOG2);
        let digits = self.sampler.keys.digits(self.x.wrapping_add(dx), self.y.wrapping_add(dy));
        let order = hash::combine(domain_seed(self.sampler.seed, domain, pad), self.frame);
        // The lower digits are the domain's.
        let low = hash::mix(order);
        let key = ((digits >> 16) as u64) << 48 | ((low >> 16) as u64) << 32 | (digits << 16 | low & 0xffff) as u64;
        KeyedPair { key, order }
    }
}

/// The pair of a domain.
#[derive(Clone, Copy)]
struct KeyedPair {
    key: u64,
    order: u32,
}

impl KeyedPair {
    #[inline]
    #[expect(clippy::cast_possible_truncation, reason = "the lower half of the word")]
    const fn at(self, index: u32) -> [u32; 2] {
        // All pixels of a domain share one order, or they would see different points between the powers of two.
        let index = hash::shuffle_rev(index.reverse_bits(), self.order).reverse_bits();
        let point = LINEAR_ORDER.sequence.packed(index) ^ self.key;
        [(point >> 32) as u32, point as u32]
    }

    #[inline]
    const fn first(self, index: u32) -> u32 {
        self.at(index)[0]
    }
}

call_shape!(impl['a, const S: usize] KeyedPixel<'a, S>);
