//! Cycles' blue-noise sampling ("pure" mode, Blender 4.3; after Ahmed and Wonka 2020 and Vegdahl 2022), written from
//! its description: a base-4 Owen-scrambled Morton curve gives every pixel a run of one Owen-scrambled Sobol sequence.

use super::draws;
use bluedither::zorder::morton_16;
use bluedither::{hash, sobol, unit};

/// The samples are rounded up to a power of two. As in the original, pixels times samples wrap at 2³².
///
/// Its sequence is the same for all seeds; so that several seeds are as many instances, the seed enters the hash of the
/// dimension here.
#[derive(Clone, Copy, Debug)]
pub struct Cycles {
    seed: u32,
    spp_log2: u32,
}

#[derive(Clone, Copy, Debug)]
pub struct CyclesPixel {
    seed: u32,
    first: u32,
}

impl Cycles {
    pub const fn with_spp(seed: u32, spp: u32) -> Self {
        Self { seed, spp_log2: if spp == 0 { 0 } else { spp.next_power_of_two().trailing_zeros() } }
    }

    #[inline]
    pub const fn pixel(&self, x: u32, y: u32, frame: u32) -> CyclesPixel {
        let seed = hash::combine(self.seed, frame);
        let place = owen_base_4(morton_16(x, y).reverse_bits(), seed).reverse_bits();
        CyclesPixel { seed, first: place.wrapping_shl(self.spp_log2) }
    }
}

impl CyclesPixel {
    #[inline]
    const fn pair(self, pair: u32, index: u32) -> [f32; 2] {
        let seed = hash::combine(self.seed, pair);
        let shuffled = hash::laine_karras(self.first.wrapping_add(index).reverse_bits(), seed ^ 0xf8ad_e99a);
        let [x, y] = sobol::point(shuffled.reverse_bits());
        [unit::to_f32(hash::owen(x, seed ^ 0xe0aa_af76)), unit::to_f32(hash::owen(y, seed ^ 0x9496_4d4e))]
    }
}

draws!(CyclesPixel);

/// The Laine–Karras hash by digits of two bits: the first step of each half moves a change within a digit both ways.
#[inline]
const fn owen_base_4(value_rev: u32, seed: u32) -> u32 {
    let mut n = value_rev;
    n ^= n.wrapping_mul(0x3d20_adea);
    n ^= (n >> 1) & (n << 1) & 0x5555_5555;
    n = n.wrapping_add(seed);
    n = n.wrapping_mul((seed >> 16) | 1);
    n ^= (n >> 1) & (n << 1) & 0x5555_5555;
    n ^= n.wrapping_mul(0x0552_6c56);
    n ^ n.wrapping_mul(0x53a2_2864)
}
