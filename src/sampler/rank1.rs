//! Belcour and Heitz 2021: one rank-1 lattice for the image, one shift a pixel from a blue-noise mask.

use super::{Pair, call_shape, domain_seed, row_by_pixels, row_shape};
use crate::{hash, lattice, mask::VectorMask, torus};

/// An extensible rank-1 lattice, shifted in every pixel by a mask that is annealed for it.
///
/// Blue at 1, 4 and 16 samples, and the sequence goes on for as long as it is asked; but on smooth integrands that are not
/// periodic a lattice has larger errors than a net, and from 16 samples on [`White`](crate::White) leaves less of them
/// after a filter. Every domain, pad and frame reads the mask at a place of its own and visits the lattice in an order of
/// its own, the same for all pixels; there are as many places as pixels of the mask, so that of thousands of domains, frames
/// or seeds some two read the same one. A draw is a reversal, five multiplications and a look-up.
///
/// The paper ranks a pixel's samples, too. That is left out: with van der Corput's φ, the first 2ᵏ numbers φ(i ⊕ r) are
/// those of φ(i) + φ(r) modulo 1, so that at every power of two the samples φ(i ⊕ r)·z + s are those of no rank and the
/// shift s + φ(r)·z.
#[derive(Clone, Copy, Debug)]
pub struct Rank1<'a, const S: usize = 64> {
    mask: &'a VectorMask<2, S>,
    seed: u32,
}

#[cfg(feature = "lattice-64")]
impl Rank1<'static, 64> {
    /// Samples per pixel unknown: the sequence goes on for as long as it is asked.
    #[inline]
    #[must_use]
    pub const fn new(seed: u32) -> Self {
        Self::with_mask(&crate::tables::LATTICE_64, seed)
    }

    /// The same as [`new`](Self::new): the lattice is extensible, and `spp` makes no difference.
    #[inline]
    #[must_use]
    pub const fn with_spp(seed: u32, spp: u32) -> Self {
        _ = spp;
        Self::new(seed)
    }
}

impl<'a, const S: usize> Rank1<'a, S> {
    /// With a mask of your own choice.
    #[inline]
    #[must_use]
    pub const fn with_mask(mask: &'a VectorMask<2, S>, seed: u32) -> Self {
        Self { mask, seed }
    }

    /// The samples of one pixel in one frame. Any coordinates and frame; negative ones are passed `as u32`.
    #[inline]
    #[must_use]
    pub const fn pixel(&self, x: u32, y: u32, frame: u32) -> Rank1Pixel<'a, S> {
        Rank1Pixel { sampler: *self, x, y, frame }
    }
}

/// One pixel of [`Rank1`].
#[derive(Clone, Copy, Debug)]
pub struct Rank1Pixel<'a, const S: usize = 64> {
    sampler: Rank1<'a, S>,
    x: u32,
    y: u32,
    frame: u32,
}

impl<const S: usize> Rank1Pixel<'_, S> {
    // Inlined for certain: all but the look-up is the same for all pixels, which a compiler sees only then.
    #[inline(always)]
    fn pair(self, domain: u32, pad: u32) -> Rank1Pair {
        let [dx, dy] = torus::offset(self.sampler.seed, domain, pad, self.frame, VectorMask::<2, S>::SIZE_LOG2);
        let shift = self.sampler.mask.value_fx(self.x.wrapping_add(dx), self.y.wrapping_add(dy));
        Rank1Pair { shift, order: hash::combine(domain_seed(self.sampler.seed, domain, pad), self.frame) }
    }
}

/// The pair of a domain.
#[derive(Clone, Copy)]
struct Rank1Pair {
    shift: [u32; 2],
    order: u32,
}

impl Pair for Rank1Pair {
    #[inline(always)]
    fn point(self, index_rev: u32) -> [u32; 2] {
        // φ of the index, which is what `lattice::extensible` multiplies.
        let phi = hash::shuffle_rev(index_rev, self.order);
        let [x, y] = self.shift;
        [phi.wrapping_mul(lattice::EXEW[0]).wrapping_add(x), phi.wrapping_mul(lattice::EXEW[1]).wrapping_add(y)]
    }
}

call_shape!(impl['a, const S: usize] Rank1Pixel<'a, S>, pair);
row_shape!(impl['a, const S: usize] Rank1<'a, S>);
row_by_pixels!(impl['a, const S: usize] Rank1<'a, S>);
