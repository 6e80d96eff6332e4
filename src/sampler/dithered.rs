//! Georgiev and Fajardo 2016: one pattern for the image, one offset a pixel from a blue-noise mask. With a rank-1
//! lattice as the pattern: Belcour and Heitz 2021.

use super::{Pair, Single, call_shape, domain_seed, padded, row_by_pixels, row_shape, spread};
use crate::mask::{ScalarMask, VectorMask};
use crate::{hash, lattice, shift, sobol, strata, torus};

/// Blue-noise dithered sampling: a Sobol pattern, a stratified one or a lattice, moved in every pixel by a mask.
///
/// One dimension is taken from a scalar mask, pairs from a two-channel mask, each read at a place of its own for every
/// domain and frame. Strong at 1 to 9 samples per pixel on what is smooth over the screen; with more the error turns
/// white, and from 16 on [`White`](crate::White), which has better points, leaves less of it. A draw costs a few
/// hashes, a look-up and a Sobol point, and with strata a division or more.
///
/// A mask has as many places as pixels: of thousands of domains or seeds some two read the same one. As many frames
/// read about five sixths of the places; then comes a round from another start and with other values, so that the mean
/// over frames goes on getting better: at one sample its error is that of independent frames, and from a thousand on
/// less.
#[derive(Clone, Copy, Debug)]
pub struct Dithered<'a, const S: usize = 64> {
    scalar: &'a ScalarMask<S>,
    vector: &'a VectorMask<2, S>,
    seed: u32,
    /// Strata of single dimensions and of pairs; 0 moves the pattern as a whole.
    strata_1d: u32,
    strata_2d: u32,
    /// Whether pairs that have no strata are a lattice, and not Sobol's.
    on_lattice: bool,
}

#[cfg(all(feature = "threshold-64", feature = "offset-2d-64"))]
impl Dithered<'static, 64> {
    /// Samples per pixel unknown: the sequence goes on for as long as it is asked, offset globally.
    ///
    /// Pairs are as blue as by [`with_spp`](Self::with_spp); single dimensions fade sooner, since the threshold mask is
    /// made for one number a pixel. For many of those, take `with_masks(&OFFSET_1D_64, &OFFSET_2D_64, seed)`, whose
    /// scalar mask is made for 1, 4 and 16.
    #[inline]
    #[must_use]
    pub const fn new(seed: u32) -> Self {
        Self::with_masks(&crate::tables::THRESHOLD_64, &crate::tables::OFFSET_2D_64, seed)
    }

    /// `spp` samples per pixel: single dimensions stratified, pairs offset globally, which is the better of the two
    /// for each. 0 counts as 1; an `index` ≥ `spp` continues between the first ones.
    #[inline]
    #[must_use]
    pub const fn with_spp(seed: u32, spp: u32) -> Self {
        Self::new(seed).stratified_1d(spp)
    }
}

#[cfg(feature = "lattice-64")]
impl Dithered<'static, 64> {
    /// Pairs of an extensible rank-1 lattice, moved by a mask that is annealed for it; the number of samples makes no
    /// difference. Single dimensions are those of [`new`](Self::new).
    ///
    /// Blue at 1, 4 and 16 samples, and quick: a pair is two products. But on smooth integrands that are not periodic a
    /// lattice has larger errors than a net, and from 16 samples on [`White`](crate::White) leaves less of them after a
    /// filter.
    #[inline]
    #[must_use]
    pub const fn lattice(seed: u32) -> Self {
        Self::with_masks(&crate::tables::THRESHOLD_64, &crate::tables::LATTICE_64, seed).on_lattice()
    }
}

impl<'a, const S: usize> Dithered<'a, S> {
    /// With masks of your own choice, offset globally.
    #[inline]
    #[must_use]
    pub const fn with_masks(scalar: &'a ScalarMask<S>, vector: &'a VectorMask<2, S>, seed: u32) -> Self {
        Self { scalar, vector, seed, strata_1d: 0, strata_2d: 0, on_lattice: false }
    }

    /// Offsets the pattern as a whole, modulo 1, in every dimension.
    #[inline]
    #[must_use]
    pub const fn global(mut self) -> Self {
        (self.strata_1d, self.strata_2d) = (0, 0);
        self
    }

    /// Offsets single dimensions inside the cells of `spp` strata, which keeps the mask's full blueness at every `spp`,
    /// and pairs globally. 0 counts as 1.
    #[inline]
    #[must_use]
    pub const fn stratified_1d(mut self, spp: u32) -> Self {
        (self.strata_1d, self.strata_2d) = (at_least_one(spp), 0);
        self
    }

    /// Offsets single dimensions and pairs inside the cells of `spp` strata. Pairs keep the mask's full blueness, too,
    /// but their error itself falls slower than with a Sobol pattern: for a few samples. 0 counts as 1.
    #[inline]
    #[must_use]
    pub const fn stratified(mut self, spp: u32) -> Self {
        (self.strata_1d, self.strata_2d) = (at_least_one(spp), at_least_one(spp));
        self
    }

    /// Takes pairs that have no strata from a rank-1 lattice, in place of the Sobol sequence: for masks that are made
    /// for it.
    #[inline]
    #[must_use]
    pub const fn on_lattice(mut self) -> Self {
        self.on_lattice = true;
        self
    }

    /// The samples of one pixel in one frame. Any coordinates and frame; negative ones are passed `as u32`.
    #[inline]
    #[must_use]
    pub const fn pixel(&self, x: u32, y: u32, frame: u32) -> DitheredPixel<'a, S> {
        DitheredPixel { sampler: *self, x, y, frame }
    }
}

const fn at_least_one(spp: u32) -> u32 {
    if spp == 0 { 1 } else { spp }
}

/// One pixel of [`Dithered`].
#[derive(Clone, Copy, Debug)]
pub struct DitheredPixel<'a, const S: usize = 64> {
    sampler: Dithered<'a, S>,
    x: u32,
    y: u32,
    frame: u32,
}

impl<const S: usize> DitheredPixel<'_, S> {
    #[inline]
    fn single(self, domain: u32, pad: u32) -> DitheredSingle {
        let (x, y) = self.place(domain, pad);
        let order = self.order(domain, pad, self.sampler.strata_1d);
        DitheredSingle { order, offset: self.sampler.scalar.value_fx(x, y) ^ flips(self.round_seed(domain, pad)) }
    }

    #[inline]
    fn pair(self, domain: u32, pad: u32) -> DitheredPair {
        let (x, y) = self.place(domain, pad);
        let order = self.order(domain, pad, self.sampler.strata_2d);
        let seed = self.round_seed(domain, pad);
        let flips = flips(seed);
        let [u, v] = self.sampler.vector.value_fx(x, y);
        // Upper digits of both or of none: a pattern that is turned by half a turn is much the same, a mirrored one is
        // not.
        let offset = [u ^ flips, v ^ flips ^ seed.rotate_left(16) >> 8];
        DitheredPair { order, offset, on_lattice: self.sampler.on_lattice }
    }

    /// How often there were as many frames as the mask has places.
    #[inline]
    const fn round(self) -> u32 {
        self.frame >> (2 * ScalarMask::<S>::SIZE_LOG2)
    }

    /// Where the mask is read. Every round starts elsewhere, or frames would go on to repeat each other's
    /// values, and their mean would not get better.
    #[inline]
    const fn place(self, domain: u32, pad: u32) -> (u32, u32) {
        let seed = self.sampler.seed ^ self.round().wrapping_mul(ROUND);
        let [dx, dy] = torus::offset(seed, domain, pad, self.frame, ScalarMask::<S>::SIZE_LOG2);
        (self.x.wrapping_add(dx), self.y.wrapping_add(dy))
    }

    /// What tells the flips of a round: none in the first, of which the product is 0. A hash for every round and domain
    /// would be a tenth of a draw's instructions on a GPU; this much of it is the same for all domains.
    #[inline]
    const fn round_seed(self, domain: u32, pad: u32) -> u32 {
        let product = self.round().wrapping_mul(ROUND);
        domain_seed(self.sampler.seed, domain, pad).wrapping_mul(product ^ product >> 15)
    }

    #[inline]
    const fn order(self, domain: u32, pad: u32, strata: u32) -> Order {
        let seed = hash::combine(domain_seed(self.sampler.seed, domain, pad), self.frame);
        Order { seed, strata, turn: hash::combine(seed, spread(self.x, self.y)) }
    }
}

/// Odd, without a pattern: rounds and the seeds in use do not meet.
const ROUND: u32 = 0xb529_7a4d;

/// Digits that a round flips in all values of a mask: all or none of the upper nine, which leaves their blueness as it
/// is, and any below, which changes little. (Any below the sixth cost a twentieth.) The values stay a net, but of
/// another set: the mean over rounds would else never get better than that over the mask, which a half-plane misses by
/// up to a hundredth.
#[inline(always)]
const fn flips(seed: u32) -> u32 {
    (seed.cast_signed() >> 8).cast_unsigned()
}

/// The order in which a pixel visits the pattern.
#[derive(Clone, Copy)]
struct Order {
    /// The same for all pixels, which would else see different points after fewer samples than 2ᵏ.
    seed: u32,
    /// 0: the pattern as a whole.
    strata: u32,
    /// Every pixel turns the order of the cells by a number of its own. All of them are visited, so this changes
    /// nothing within a domain; but if cell a of one domain met cell b of another in every pixel, all pixels would have
    /// the same error.
    turn: u32,
}

impl Order {
    /// After as many samples as strata these are filled again, between what is there: the pass, and the cell in it.
    #[inline]
    const fn cell(self, index: u32) -> (u32, u32) {
        let Self { seed, strata, turn } = self;
        // Never 0 here; said again for the divisions, which would else keep a check.
        let count = at_least_one(strata);
        if count == 1 {
            return (hash::shuffle(index, seed), 0);
        }
        // In an order of the domain's own: the place in a cell depends on the pass, and two domains that went from
        // place to place together would stay on a diagonal for ever.
        let (pass, index) =
            if index < count { (0, index) } else { (hash::shuffle(index / count, seed), index % count) };
        let cell = strata::permute(index, count, hash::combine(seed, pass));
        (pass, strata::turn(cell, count, turn))
    }
}

/// One dimension of a domain.
#[derive(Clone, Copy)]
struct DitheredSingle {
    order: Order,
    offset: u32,
}

impl Single for DitheredSingle {
    #[inline]
    fn value(self, index_rev: u32) -> u32 {
        if self.order.strata == 0 {
            // Of dimension 0 the reversed number is the value.
            return hash::shuffle_rev(index_rev, self.order.seed).wrapping_add(self.offset);
        }
        let (pass, cell) = self.order.cell(index_rev.reverse_bits());
        shift::stratified_1d(cell, self.order.strata, sobol::dimension_0(pass), self.offset)
    }
}

/// The pair of a domain.
#[derive(Clone, Copy)]
struct DitheredPair {
    order: Order,
    offset: [u32; 2],
    on_lattice: bool,
}

impl Pair for DitheredPair {
    #[inline]
    fn point(self, index_rev: u32) -> [u32; 2] {
        if self.order.strata == 0 {
            let first = hash::shuffle_rev(index_rev, self.order.seed);
            let point = if self.on_lattice { lattice::multiples(first) } else { [first, sobol::second(first)] };
            return shift::global(point, self.offset);
        }
        let (pass, cell) = self.order.cell(index_rev.reverse_bits());
        shift::stratified_2d(cell, self.order.strata, sobol::point(pass), self.offset)
    }
}

padded!(impl['a, const S: usize] DitheredPixel<'a, S>, single);
call_shape!(impl['a, const S: usize] DitheredPixel<'a, S>);
row_shape!(impl['a, const S: usize] Dithered<'a, S>);
row_by_pixels!(impl['a, const S: usize] Dithered<'a, S>);
