//! The recommended sampler: the joint net.

use super::{call_shape, row_by_pixels, row_shape};
use crate::net::{self, Digits, Order};
use crate::tables::NET;
use crate::{hash, zorder};

/// Blue-noise error in eight numbers at once, at every number of samples and without a texture that is seen: the
/// [joint net](crate::net).
///
/// All pixels share one digital net; a pixel's place on a shuffled Z curve decides which part of it is the pixel's own. No
/// mask and no tile; 3,984 bytes of constants. The eight numbers of a domain are blue together, own pairs most. Different
/// domains are unrelated: each lies elsewhere on a curve of its own and every pixel visits its samples in an order of its own.
///
/// **Frames** are further digits of the sample's number. 2ᵏ frames of 2ᵐ samples, m known beforehand, are the samples of one
/// net of 2^(m+k) in every pixel, and each frame alone is as blue as the first: frames that are averaged go on where the
/// last one stopped. After 2¹⁶ samples in all (by [`new`](Self::new) after 2¹⁵ frames, or 2¹⁶ samples of one) sequences
/// begin anew. By [`new`](Self::new) eight frames, or 64, go on best.
///
/// A domain costs a pixel three hashes and ten columns; a sample some twelve operations and a column for each bit of its
/// number.
#[derive(Clone, Copy, Debug)]
pub struct Sampler {
    order: &'static Order,
    /// Bits of a sample's number below those of the frame.
    bits: u32,
    /// Whether the number of samples is not known: frames have columns of their own.
    progressive: bool,
    seed: u32,
}

impl Sampler {
    /// Progressive: the sequence goes on for as long as it is asked, and every power of two is a good moment to stop.
    #[inline]
    #[must_use]
    pub const fn new(seed: u32) -> Self {
        Self { order: &NET.progressive, bits: 0, progressive: true, seed }
    }

    /// `spp` samples per pixel: bluer than by [`new`](Self::new) once all are drawn, and less so before.
    ///
    /// For powers of two up to 64, and 256; 0 counts as 1. Other numbers are drawn as by [`new`](Self::new). An `index` ≥
    /// `spp` continues with the samples of the next frames.
    #[inline]
    #[must_use]
    pub const fn with_spp(seed: u32, spp: u32) -> Self {
        match NET.known(spp) {
            Some(order) => {
                Self { order, bits: if spp == 0 { 0 } else { spp.trailing_zeros() }, progressive: false, seed }
            }
            None => Self::new(seed),
        }
    }

    /// The samples of one pixel in one frame. Any coordinates and frame; negative ones are passed `as u32`.
    #[inline]
    #[must_use]
    pub const fn pixel(&self, x: u32, y: u32, frame: u32) -> SamplerPixel {
        SamplerPixel { sampler: *self, x, y, frame }
    }
}

/// One pixel of [`Sampler`].
#[derive(Clone, Copy, Debug)]
pub struct SamplerPixel {
    sampler: Sampler,
    x: u32,
    y: u32,
    frame: u32,
}

/// What a domain has for all samples of a pixel.
#[derive(Clone, Copy)]
struct Domain {
    order: &'static Order,
    /// The digits of the sample whose number is 0.
    digits: Digits,
    /// What stands below the sixteen digits.
    rest: Digits,
    /// Which bits of a number are added to lower ones, which is the pixel's order of samples.
    masks: [u32; 7],
    /// Added to a number before the order: the frame.
    first: u32,
    /// Added after it: the rank.
    rank: u32,
    /// Hashed where numbers have no digits left.
    seed: u64,
}

/// Four odd constants without a pattern: those that sum up to a word each.
const ODD: [u32; 4] = [0x9e37_79b1, 0x85eb_ca77, 0xc2b2_ae3d, 0x27d4_eb2f];

impl SamplerPixel {
    // Inlined for certain: what is the same for all pixels or all domains is taken out of a loop only then.
    #[inline(always)]
    #[expect(clippy::cast_possible_truncation, reason = "halves of hashes")]
    fn domain(self, domain: u32) -> Domain {
        let Sampler { order, bits, progressive, seed } = self.sampler;
        // Digits of the frame, and what is left of it: sequences begin anew.
        let (frame, epoch) = if progressive {
            (self.frame & ((1 << net::FRAMES) - 1), self.frame >> net::FRAMES)
        } else {
            (self.frame << bits & 0xffff, self.frame >> (net::DIGITS - bits))
        };
        // A bijection of the domain, so that no two of them are the same.
        let key = hash::mix_64(hash::mix_64((seed as u64) << 32 | epoch as u64) ^ (domain as u64).wrapping_mul(SPREAD));
        let (low, high) = (key as u32, (key >> 32) as u32);
        // Every domain lies elsewhere on the plane, on a curve of its own.
        let (x, y) = (self.x.wrapping_add(high), self.y.wrapping_add(high.rotate_left(16)));
        let curve = hash::laine_karras_4(zorder::morton_16(x >> 2, y >> 2).reverse_bits(), low);
        let block = curve.wrapping_mul(ODD[0]) >> 31;
        let (u, v) = if block == 1 { (y & 3, x & 3) } else { (x & 3, y & 3) };
        // The digital shift of 32×32 pixels.
        let shift = hash::mix(curve << net::PLACE >> net::PLACE ^ low);
        let own = hash::mix(x ^ y.rotate_left(16) ^ high);
        let rest: Digits = core::array::from_fn(|k| shift.wrapping_mul(ODD[k]) ^ high.wrapping_mul(ODD[3 - k]));
        let mut digits = net::add_columns(rest, &order.inside, u | v << 2);
        digits = net::add_columns(digits, &order.place, curve.reverse_bits());
        if progressive {
            digits = net::add_columns(digits, &NET.frames, frame);
        }
        let other = own.wrapping_mul(ODD[1]);
        Domain {
            order,
            digits,
            rest,
            masks: [own, own >> 16, other >> 8, other >> 16, own >> 24, other, other >> 20],
            first: if progressive { 0 } else { frame },
            rank: if progressive { 0 } else { own >> 8 & ((1 << bits) - 1) },
            seed: key,
        }
    }

    #[inline(always)]
    fn numbers<const D: usize>(self, domain: u32, index: u32) -> [u32; D] {
        let domain = self.domain(domain).begun(index);
        domain.split(net::add_columns(domain.digits, &domain.order.samples, domain.number(index)))
    }

    #[inline]
    fn fill_by<const D: usize, T>(
        self,
        domain: u32,
        first: u32,
        samples: &mut [[T; D]],
        convert: impl Fn(u32) -> T + Copy,
    ) {
        let domain = self.domain(domain);
        // The pixel's order is linear: sums of what single bits add, of four of them by a table.
        let step = |bit: u32| net::add_columns([0; 4], &domain.order.samples, domain.ordered(1 << bit));
        let mut sums = [[0; 4]; RUN];
        let steps = [step(0), step(1), step(2), step(3)];
        let mut k = 1;
        while k < RUN {
            sums[k] = net::add(sums[k & (k - 1)], steps[k.trailing_zeros() as usize & 3]);
            k += 1;
        }
        let mut index = first;
        let mut rest = samples;
        while !rest.is_empty() {
            let from = index as usize % RUN;
            let (run, behind) = rest.split_at_mut(rest.len().min(RUN - from));
            let upper = index >> RUN_LOG2 << RUN_LOG2;
            let domain = domain.begun(upper);
            let base = net::add_columns(domain.digits, &domain.order.samples, domain.number(upper));
            for (sample, sum) in run.iter_mut().zip(&sums[from..]) {
                *sample = domain.split(net::add(base, *sum)).map(convert);
            }
            index = upper.wrapping_add(1 << RUN_LOG2);
            rest = behind;
        }
    }
}

/// Samples that a fill makes by one table.
const RUN: usize = 1 << RUN_LOG2;
const RUN_LOG2: u32 = 4;

/// An odd constant without a pattern.
const SPREAD: u64 = 0x9e37_79b9_7f4a_7c15;

impl Domain {
    /// The number of a sample on the sequence.
    #[inline(always)]
    const fn number(self, index: u32) -> u32 {
        self.ordered(index ^ self.first) ^ self.rank
    }

    /// Every bit may be added to lower ones, by which all runs of 2ᵏ numbers from a multiple of 2ᵏ on stay what they are.
    #[inline(always)]
    const fn ordered(self, number: u32) -> u32 {
        let [a, b, c, d, e, f, g] = self.masks;
        let mut n = number & 0xffff;
        n ^= n >> 1 & a;
        n ^= n >> 2 & b;
        n ^= n >> 4 & c;
        n ^= n >> 8 & d;
        n ^= n >> 1 & e;
        n ^= n >> 2 & f;
        n ^ (n >> 4 & g)
    }

    /// The sequence that `index` is on: after 2¹⁶ samples another begins.
    #[inline(always)]
    #[expect(clippy::cast_possible_truncation, reason = "pieces of a hash")]
    fn begun(self, index: u32) -> Self {
        if index >> net::DIGITS == 0 {
            return self;
        }
        let key = hash::mix_64(self.seed ^ ((index >> net::DIGITS) as u64) << 32);
        let anew: Digits = core::array::from_fn(|k| ((key >> 32) as u32).wrapping_mul(ODD[k]) ^ key as u32);
        Self { digits: net::add(self.digits, anew), rest: net::add(self.rest, anew), ..self }
    }

    /// 32 digits of each number.
    #[inline(always)]
    fn split<const D: usize>(self, digits: Digits) -> [u32; D] {
        let mut numbers = [0; 8];
        let mut k = 0;
        while k < 4 {
            let low = self.rest[k ^ 1];
            numbers[2 * k] = digits[k] & 0xffff_0000 | low & 0xffff;
            numbers[2 * k + 1] = digits[k] << 16 | low >> 16;
            k += 1;
        }
        core::array::from_fn(|k| numbers[k & 7])
    }
}

call_shape!(impl[] SamplerPixel);
row_shape!(impl[] Sampler);
row_by_pixels!(impl[] Sampler);
