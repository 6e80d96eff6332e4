//! Heitz et al. 2019, "A Low-Discrepancy Sampler that Distributes Monte Carlo Errors as a Blue Noise in Screen Space":
//! the published tables (package `blue-noise-sampler`) and the formula of their release, with the dimension masked,
//! which it leaves out: from dimension 8 on it reads another pixel's entry.
//!
//! The package holds bytes as `i32`; they are packed once.

use super::draws;
use blue_noise_sampler as tables;
use std::sync::LazyLock;

/// One release: optimised for one sample count.
#[derive(Debug)]
struct Release {
    sobol: Vec<u8>,
    scrambling: Vec<u8>,
    ranking: Vec<u8>,
}

impl Release {
    fn new(sobol: &[i32], scrambling: &[i32], ranking: &[i32]) -> Self {
        let bytes = |from: &[i32]| from.iter().map(|&value| value as u8).collect();
        Self { sobol: bytes(sobol), scrambling: bytes(scrambling), ranking: bytes(ranking) }
    }
}

macro_rules! releases {
    ($($module:ident)*) => {
        /// For 1, 2, 4, …, 256 samples.
        static RELEASES: LazyLock<[Release; 9]> = LazyLock::new(|| [
            $(Release::new(tables::$module::SOBOL, tables::$module::SCRAMBLING_TILE, tables::$module::RANKING_TILE)),*
        ]);
    };
}
releases! { spp1 spp2 spp4 spp8 spp16 spp32 spp64 spp128 spp256 }

/// The release of the next power of two; counts above 256 take the last and repeat.
///
/// It has no seed: here the seed picks one of its four optimised pairs of dimensions and moves the tile. A domain has
/// the eight dimensions that it was made for, and the tile at a place of its own.
#[derive(Clone, Copy, Debug)]
pub struct Heitz {
    release: &'static Release,
    seed: u32,
}

#[derive(Clone, Copy, Debug)]
pub struct HeitzPixel {
    release: &'static Release,
    offset: u32,
    x: u32,
    y: u32,
    first: u32,
}

impl Heitz {
    pub fn with_spp(seed: u32, spp: u32) -> Self {
        let log2 = spp.clamp(1, 256).next_power_of_two().trailing_zeros();
        Self { release: &RELEASES[log2 as usize], seed }
    }

    #[inline]
    pub fn pixel(&self, x: u32, y: u32, frame: u32) -> HeitzPixel {
        let offset = bluedither::hash::combine(self.seed, frame);
        HeitzPixel { release: self.release, offset, x, y, first: 2 * (self.seed & 3) }
    }
}

impl HeitzPixel {
    #[inline]
    fn pair(self, pair: u32, index: u32) -> [f32; 2] {
        let Release { sobol, scrambling, ranking } = self.release;
        // A product, which is as good as free: a renderer would have constants here.
        let offset = self.offset.wrapping_add((pair / 4).wrapping_mul(0x9e37_79b1));
        let (x, y) = (self.x.wrapping_add(offset) & 127, self.y.wrapping_add(offset >> 16) & 127);
        let place = 8 * (x + 128 * y) as usize;
        let first = self.first.wrapping_add(2 * pair) & 255;
        core::array::from_fn(|k| {
            let dimension = first as usize + k;
            let at = place + (dimension & 7);
            let ranked = (index & 255) as usize ^ ranking[at] as usize;
            (f32::from(sobol[dimension + 256 * ranked] ^ scrambling[at]) + 0.5) / 256.0
        })
    }
}

draws!(HeitzPixel);
