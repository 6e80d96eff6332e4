//! The recommended sampler: the joint net.

use super::{call_shape, row_by_pixels, row_shape};
use crate::net::{self, Digits, Order};
use crate::tables::NET;
use crate::{hash, zorder};

/// Blue-noise error in eight numbers at once, at every number of samples and without a texture that is seen: the
/// [joint net](crate::net).
///
/// All pixels share one digital net; a pixel's place on a shuffled Z curve decides which part of it is the pixel's own.
/// No mask and no tile; 3,984 bytes of constants. The eight numbers of a domain are blue together, own pairs most.
/// Different domains are unrelated: each lies elsewhere on a curve of its own and every pixel visits its samples in an
/// order of its own. Only the first sample of a progressive run and the one of `with_spp(seed, 1)` have no order: after
/// filters of many pixels the joint error of two domains is up to 1.3 times that of independent numbers there.
///
/// **Frames** are further digits of the sample's number. 2ᵏ frames of 2ᵐ samples, m known beforehand, are the samples
/// of one net of 2^(m+k) in every pixel, and each frame alone is as blue as the first: frames that are averaged go on
/// where the last one stopped. By [`new`](Self::new) that holds for 8ᵏ frames. After 2¹⁶ samples in all (by `new` after
/// 2¹⁵ frames, or 2¹⁶ samples of one) sequences begin anew.
///
/// A number has 16 digits of its own; those below are the same for all samples of 32×32 pixels. A domain costs a pixel
/// three hashes and ten columns; a sample some twenty operations and a column for each bit of its number.
#[derive(Clone, Copy, Debug)]
pub struct Sampler {
    order: &'static Order,
    /// Bits of a sample's number below those of the frame; all of them if the number of samples is not known, and
    /// frames have columns of their own.
    bits: u32,
    seed: u32,
}

impl Sampler {
    /// Progressive: the sequence goes on for as long as it is asked, and every power of two is a good moment to stop.
    #[inline]
    #[must_use]
    pub const fn new(seed: u32) -> Self {
        Self { order: &NET.progressive, bits: net::DIGITS, seed }
    }

    /// `spp` samples per pixel: bluer than by [`new`](Self::new) once all are drawn, and less so before.
    ///
    /// For powers of two up to 64, and 256; 0 counts as 1. Other numbers, 128 among them, are drawn as by
    /// [`new`](Self::new). An `index` ≥ `spp` continues the net, with samples of other frames: `index / spp` XORed with
    /// the frame.
    #[inline]
    #[must_use]
    pub const fn with_spp(seed: u32, spp: u32) -> Self {
        match NET.known(spp) {
            Some(order) => Self { order, bits: if spp == 0 { 0 } else { spp.trailing_zeros() }, seed },
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
    columns: &'static [Digits; net::DIGITS as usize],
    /// The digits of the sample whose number is 0.
    digits: Digits,
    /// What stands below the sixteen digits.
    rest: Digits,
    /// The pixel's order of the samples of a frame.
    samples: Masks,
    /// An order of frames, the same for 32×32 pixels, so that each frame is as blue as the first.
    frames: Masks,
    /// Bits of a number below those of the frame.
    bits: u32,
    /// The frame, where its bits stand above those of the samples.
    frame: u32,
    /// Added to a sample's number after the order.
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
        let Sampler { order, bits, seed } = self.sampler;
        let progressive = bits == net::DIGITS;
        // Digits of the frame, and what is left of it: sequences begin anew.
        let frame_bits = if progressive { net::FRAMES as u32 } else { net::DIGITS - bits };
        let (frame, epoch) = (self.frame & ((1 << frame_bits) - 1), self.frame >> frame_bits);
        // A bijection of the domain, so that no two of them are the same.
        let key = hash::mix_64(hash::mix_64((seed as u64) << 32 | epoch as u64) ^ (domain as u64).wrapping_mul(SPREAD));
        let (low, high) = (key as u32, (key >> 32) as u32);
        // Every domain lies elsewhere on the plane, on a curve of its own.
        let (x, y) = (self.x.wrapping_add(high), self.y.wrapping_add(high.rotate_left(16)));
        let curve = hash::laine_karras_4(zorder::morton_16(x >> 2, y >> 2).reverse_bits(), low);
        // Eight variants of a block, by which no Walsh function is seen: transposed or not, upper bits of one axis
        // added to lower ones of the other or not. Every block keeps its points, so that wide filters see no
        // difference.
        let variant = curve.wrapping_mul(ODD[0]) >> 29;
        let (u, v) = if variant & 4 == 4 { (y & 3, x & 3) } else { (x & 3, y & 3) };
        let u = u ^ (variant >> 1 & v >> 1);
        let v = v ^ (variant & u >> 1);
        // The digital shift of 32×32 pixels.
        let shift = hash::mix(curve << net::PLACE >> net::PLACE ^ low);
        let own = hash::mix(x ^ y.rotate_left(16) ^ high);
        let rest: Digits = core::array::from_fn(|k| shift.wrapping_mul(ODD[k]) ^ high.wrapping_mul(ODD[3 - k]));
        let mut digits = net::add_columns(rest, &order.inside, u | v << 2);
        digits = net::add_columns(digits, &order.place, curve.reverse_bits());
        let frames = Masks::new(shift);
        if progressive {
            digits = net::add_columns(digits, &NET.frames, frames.order(frame));
        }
        Domain {
            columns: &order.samples,
            digits,
            rest,
            samples: Masks::new(own),
            frames,
            bits,
            frame: if progressive { 0 } else { frame },
            rank: if progressive { 0 } else { own >> 8 & ((1 << bits) - 1) },
            seed: key,
        }
    }

    #[inline(always)]
    fn numbers<const D: usize>(self, domain: u32, index: u32) -> [u32; D] {
        let (domain, number) = self.domain(domain).sample(index);
        domain.split(domain.at(number))
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
        let lowest = domain.columns.first_chunk::<4>().unwrap_or(&[[0; 4]; 4]);
        let step = |bit: u32| net::add_columns([0; 4], lowest, domain.samples.order(1 << bit));
        let mut sums = [[0; 4]; RUN];
        let steps = [step(0), step(1), step(2), step(3)];
        let mut k = 1;
        while k < RUN {
            sums[k] = net::add(sums[k & (k - 1)], steps[k.trailing_zeros() as usize & 3]);
            k += 1;
        }
        // What follows a frame's samples is no sum.
        let run_log2 = domain.bits.min(RUN_LOG2);
        let mut index = first;
        let mut rest = samples;
        while !rest.is_empty() {
            let upper = index >> run_log2 << run_log2;
            let from = (index ^ upper) as usize;
            let (run, behind) = rest.split_at_mut(rest.len().min((1 << run_log2) - from));
            let (domain, number) = domain.sample(upper);
            let base = domain.at(number);
            for (sample, sum) in run.iter_mut().zip(sums.iter().skip(from)) {
                *sample = domain.split(net::add(base, *sum)).map(convert);
            }
            index = upper.wrapping_add(1 << run_log2);
            rest = behind;
        }
    }
}

/// Samples that a fill makes by one table.
const RUN: usize = 1 << RUN_LOG2;
const RUN_LOG2: u32 = 4;

/// An odd constant without a pattern.
const SPREAD: u64 = 0x9e37_79b9_7f4a_7c15;

/// Which bits of a number are added to lower ones: an order in which every run of 2ᵏ numbers from a multiple of 2ᵏ on
/// stays such a run.
#[derive(Clone, Copy)]
struct Masks([u32; 7]);

impl Masks {
    /// At random: pieces of a hash and of two products of it.
    #[inline(always)]
    const fn new(hash: u32) -> Self {
        let [other, third] = [hash.wrapping_mul(ODD[1]), hash.wrapping_mul(ODD[2])];
        Self([hash, hash >> 16, other >> 16, other >> 8, third >> 16, third >> 12, third >> 8])
    }

    /// Of 16 bits. Linear: the order of `a ^ b` is that of `a` XOR that of `b`.
    #[inline(always)]
    const fn order(self, number: u32) -> u32 {
        let Self([a, b, c, d, e, f, g]) = self;
        let mut n = number;
        n ^= n >> 1 & a;
        n ^= n >> 2 & b;
        n ^= n >> 4 & c;
        n ^= n >> 8 & d;
        // Once more, or the uppermost bits would reach the lowest too seldom.
        n ^= n >> 1 & e;
        n ^= n >> 2 & f;
        n ^ (n >> 4 & g)
    }
}

impl Domain {
    /// The number of a sample, and the domain at the sequence that it is on: after 2¹⁶ samples another begins.
    #[inline(always)]
    #[expect(clippy::cast_possible_truncation, reason = "pieces of a hash")]
    fn sample(self, index: u32) -> (Self, u32) {
        let mask = (1 << self.bits) - 1;
        let upper = self.frames.order(self.frame ^ index >> self.bits & 0xffff >> self.bits) << self.bits;
        // Bits of the frame are added to those of the sample as well: a pixel's order changes from frame to frame.
        let number = self.samples.order(index & mask | upper) & mask ^ self.rank | upper;
        let later = index >> net::DIGITS;
        if later == 0 {
            return (self, number);
        }
        let key = hash::mix_64(self.seed ^ (later as u64) << 32);
        let anew: Digits = core::array::from_fn(|k| ((key >> 32) as u32).wrapping_mul(ODD[k]) ^ key as u32);
        (Self { digits: net::add(self.digits, anew), rest: net::add(self.rest, anew), ..self }, number)
    }

    /// The digits of a number. Most have eight bits at most, and one branch is less than eight columns.
    #[inline(always)]
    const fn at(self, number: u32) -> Digits {
        let (first, rest) = halves(self.columns);
        let digits = net::add_columns(self.digits, first, number);
        if number >> 8 == 0 { digits } else { net::add_columns(digits, rest, number >> 8) }
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

/// The columns of the lower eight bits, and of the upper ones.
#[inline(always)]
const fn halves(columns: &[Digits; net::DIGITS as usize]) -> (&[Digits; 8], &[Digits; 8]) {
    match (columns.first_chunk(), columns.last_chunk()) {
        (Some(first), Some(last)) => (first, last),
        // Of sixteen there are eight.
        _ => (&[[0; 4]; 8], &[[0; 4]; 8]),
    }
}

call_shape!(impl[] SamplerPixel);
row_shape!(impl[] Sampler);
row_by_pixels!(impl[] Sampler);
