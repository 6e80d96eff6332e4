//! The `sobol_burley` package: Owen-scrambled Sobol points by hashing (Burley 2020), the common white baseline in Rust.

use bluedither::hash;

/// A seed of every pixel's own; a domain is two of the package's 64 sets of four dimensions.
#[derive(Clone, Copy, Debug)]
pub struct SobolBurley {
    seed: u32,
}

#[derive(Clone, Copy, Debug)]
pub struct SobolBurleyPixel {
    seed: u32,
}

impl SobolBurley {
    pub const fn new(seed: u32) -> Self {
        Self { seed }
    }

    #[inline]
    pub const fn pixel(&self, x: u32, y: u32, frame: u32) -> SobolBurleyPixel {
        let row = hash::combine(hash::combine(self.seed, frame), y);
        SobolBurleyPixel { seed: hash::combine(row, hash::mix(x)) }
    }
}

impl SobolBurleyPixel {
    /// Up to 65536 samples; one number by `sample`, more by `sample_4d`.
    #[inline]
    pub fn draw<const D: usize>(self, domain: u32, index: u32) -> [f32; D] {
        let (set, index) = (2 * domain % sobol_burley::NUM_DIMENSION_SETS_4D, index & 0xffff);
        if D == 1 {
            return [sobol_burley::sample(index, 4 * set, self.seed); D];
        }
        let mut out = [0.0; D];
        for (set, out) in (set..).zip(out.chunks_mut(4)) {
            out.copy_from_slice(&sobol_burley::sample_4d(index, set, self.seed)[..out.len()]);
        }
        out
    }

    super::fill!();
}
