//! Sobol's sequence in eight dimensions with the direction numbers of Joe and Kuo 2008, plain: what every renderer
//! could have without a table of ours. Two ways to deal it to pixels.

use bluedither::sobol::directions;
use bluedither::zorder::morton_16;
use bluedither::{hash, unit};

/// Number `bit` of each dimension, bit-reversed: where the Owen scramble works.
static DIRECTIONS_REV: [[u32; 8]; 32] = {
    let all = [
        directions(0, &[1]),
        directions(1, &[1, 3]),
        directions(1, &[1, 3, 1]),
        directions(2, &[1, 1, 1]),
        directions(1, &[1, 1, 3, 3]),
        directions(4, &[1, 3, 5, 13]),
        directions(2, &[1, 1, 5, 5, 17]),
    ];
    let mut table = [[0; 8]; 32];
    let mut bit = 0;
    while bit < 32 {
        // The first dimension is the van der Corput sequence.
        table[bit][0] = 1 << bit;
        let mut d = 1;
        while d < 8 {
            table[bit][d] = all[d - 1][bit].reverse_bits();
            d += 1;
        }
        bit += 1;
    }
    table
};

/// Point `index` under an Owen scramble a dimension.
#[inline]
pub fn point<const D: usize>(index: u32, seed: u32) -> [f32; D] {
    const { assert!(D <= 8, "eight dimensions") };
    let mut sums = [0; D];
    let mut rest = index;
    while rest != 0 {
        let directions = &DIRECTIONS_REV[rest.trailing_zeros() as usize];
        sums.iter_mut().zip(directions).for_each(|(sum, direction)| *sum ^= direction);
        rest &= rest - 1;
    }
    core::array::from_fn(|d| {
        let seed = hash::mix(seed.wrapping_add((d as u32).wrapping_mul(0x9e37_79b9)));
        unit::to_f32(hash::laine_karras(sums[d], seed).reverse_bits())
    })
}

/// A seed of every pixel's own: as little error as Sobol's sequence has, spread as white noise.
#[derive(Clone, Copy, Debug)]
pub struct JointSobol {
    seed: u32,
}

#[derive(Clone, Copy, Debug)]
pub struct JointSobolPixel {
    seed: u32,
}

impl JointSobol {
    pub const fn new(seed: u32) -> Self {
        Self { seed }
    }

    #[inline]
    pub const fn pixel(&self, x: u32, y: u32, frame: u32) -> JointSobolPixel {
        let row = hash::combine(hash::combine(self.seed, frame), y);
        JointSobolPixel { seed: hash::combine(row, hash::mix(x)) }
    }
}

impl JointSobolPixel {
    /// A domain's samples come in an order of its own.
    #[inline]
    pub fn draw<const D: usize>(self, domain: u32, index: u32) -> [f32; D] {
        let seed = hash::combine(self.seed, domain);
        point(hash::shuffle(index, seed), hash::mix(seed))
    }

    super::fill!();
}

/// One sequence for the picture, dealt along a Morton curve whose base-4 digits are scrambled (Ahmed and Wonka 2020),
/// in a joint net of eight dimensions: nothing in it is optimised.
#[derive(Clone, Copy, Debug)]
pub struct SobolZ {
    seed: u32,
    spp_log2: u32,
}

#[derive(Clone, Copy, Debug)]
pub struct SobolZPixel {
    seed: u32,
    spp_log2: u32,
    morton_rev: u32,
}

impl SobolZ {
    /// The samples are rounded up to a power of two. Pixels times samples wrap at 2³².
    pub const fn with_spp(seed: u32, spp: u32) -> Self {
        Self { seed, spp_log2: if spp == 0 { 0 } else { spp.next_power_of_two().trailing_zeros() } }
    }

    #[inline]
    pub const fn pixel(&self, x: u32, y: u32, frame: u32) -> SobolZPixel {
        let (seed, morton_rev) = (hash::combine(self.seed, frame), morton_16(x, y).reverse_bits());
        SobolZPixel { seed, spp_log2: self.spp_log2, morton_rev }
    }
}

impl SobolZPixel {
    /// A domain has a curve of its own and an order of its own of the samples in it.
    #[inline]
    pub fn draw<const D: usize>(self, domain: u32, index: u32) -> [f32; D] {
        let seed = hash::combine(self.seed, domain);
        let place = hash::laine_karras_4(self.morton_rev, seed).reverse_bits();
        let first = place.wrapping_shl(self.spp_log2).wrapping_add(index);
        let shuffled = hash::laine_karras(first.reverse_bits(), hash::other(seed)).reverse_bits();
        point(shuffled, hash::mix(seed))
    }

    super::fill!();
}
