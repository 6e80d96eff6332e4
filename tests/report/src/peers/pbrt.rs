//! The ZSobolSampler of pbrt-v4 (Pharr, Jakob and Humphreys 2023; after Ahmed and Wonka 2020), written from its
//! description: Morton order with base-4 digits permuted by a hash of those above, then Owen-scrambled Sobol points.

use super::draws;
use bluedither::zorder::morton_16;
use bluedither::{hash, sobol, unit};

/// The samples are rounded up to a power of two. Images up to 2³² samples.
///
/// Its `seed` does not enter the order of the pixels; so that several seeds are as many instances, each starts here at
/// a dimension of its own.
#[derive(Clone, Copy, Debug)]
pub struct Pbrt {
    seed: u32,
    spp_log2: u32,
}

#[derive(Clone, Copy, Debug)]
pub struct PbrtPixel {
    seed: u32,
    spp_log2: u32,
    morton: u64,
}

/// Resolution in bits: 16384 pixels on a side.
const DIGITS: u32 = 14;

impl Pbrt {
    pub const fn with_spp(seed: u32, spp: u32) -> Self {
        Self { seed, spp_log2: if spp == 0 { 0 } else { spp.next_power_of_two().trailing_zeros() } }
    }

    #[inline]
    pub const fn pixel(&self, x: u32, y: u32, frame: u32) -> PbrtPixel {
        let morton = (morton_16(x, y) as u64) << self.spp_log2;
        PbrtPixel { seed: hash::combine(self.seed, frame), spp_log2: self.spp_log2, morton }
    }
}

impl PbrtPixel {
    #[inline]
    fn pair(self, pair: u32, index: u32) -> [f32; 2] {
        let dimension = (2 * pair).wrapping_add(self.seed << 8);
        let index = self.sample_index(u64::from(index), dimension);
        let scramble = hash::combine(hash::mix(self.seed), dimension);
        // A point takes 32 bits of the index, which the images of this program do not exceed.
        let [x, y] = sobol::point(index as u32);
        [unit::to_f32(hash::owen(x, scramble)), unit::to_f32(hash::owen(y, hash::mix(scramble)))]
    }

    /// Base-4 digits from the top; with an odd power of two, the last digit is binary.
    #[inline]
    fn sample_index(self, index: u64, dimension: u32) -> u64 {
        let morton = self.morton | index;
        let odd = self.spp_log2 & 1;
        let salt = u64::from(0x5555_5555u32.wrapping_mul(dimension));
        let mut permuted = 0;
        let mut digit = DIGITS + self.spp_log2.div_ceil(2);
        while digit > odd {
            digit -= 1;
            let shift = 2 * digit - odd;
            let chosen = (mix_bits(morton >> (shift + 2) ^ salt) >> 24) % 24;
            permuted |= u64::from(PERMUTATIONS[chosen as usize][(morton >> shift & 3) as usize]) << shift;
        }
        if odd == 1 {
            permuted |= (morton & 1) ^ (mix_bits(morton >> 1 ^ salt) & 1);
        }
        permuted
    }
}

draws!(PbrtPixel);

#[inline]
const fn mix_bits(mut v: u64) -> u64 {
    v ^= v >> 31;
    v = v.wrapping_mul(0x7fb5_d329_728e_a185);
    v ^= v >> 27;
    v = v.wrapping_mul(0x81da_def4_bc2d_d44d);
    v ^ v >> 33
}

/// All orders of four digits; which comes first makes no difference.
const PERMUTATIONS: [[u8; 4]; 24] = {
    let (mut all, mut count, mut code) = ([[0; 4]; 24], 0, 0u32);
    while code < 256 {
        let digits = [code as u8 & 3, (code >> 2) as u8 & 3, (code >> 4) as u8 & 3, (code >> 6) as u8];
        if (1 << digits[0] | 1 << digits[1] | 1 << digits[2] | 1 << digits[3]) == 15 {
            all[count] = digits;
            count += 1;
        }
        code += 1;
    }
    all
};
