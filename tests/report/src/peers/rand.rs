//! The `rand` package's Xoshiro256++ (Blackman and Vigna 2018) as its users have it: a generator for every pixel and
//! purpose, asked for one number after the other.

use bluedither::{hash, unit};
use rand::rngs::Xoshiro256PlusPlus;
use rand::{Rng, SeedableRng};

/// White noise without any stratification.
#[derive(Clone, Copy, Debug)]
pub struct Rand {
    seed: u32,
}

#[derive(Clone, Copy, Debug)]
pub struct RandPixel {
    seed: u64,
}

impl Rand {
    pub const fn new(seed: u32) -> Self {
        Self { seed }
    }

    #[inline]
    pub const fn pixel(&self, x: u32, y: u32, frame: u32) -> RandPixel {
        let image = hash::combine(self.seed, frame);
        RandPixel { seed: hash::mix_64((x as u64) << 32 | y as u64) ^ (image as u64) << 16 }
    }
}

impl RandPixel {
    /// A generator has no sample 7 without those before: any sample at once is a generator of its own, as costly as
    /// that is. Other numbers than [`fill`](Self::fill) gives, as random.
    #[inline]
    pub fn draw<const D: usize>(self, domain: u32, index: u32) -> [f32; D] {
        let mut sample = [[0.0; D]];
        self.stream(u64::from(domain) << 32 | u64::from(index), &mut sample);
        sample[0]
    }

    /// One generator for the set.
    #[inline]
    pub fn fill<const D: usize>(self, domain: u32, first: u32, samples: &mut [[f32; D]]) {
        self.stream(u64::from(!domain) << 32 | u64::from(first), samples);
    }

    #[inline]
    fn stream<const D: usize>(self, purpose: u64, samples: &mut [[f32; D]]) {
        let mut generator = Xoshiro256PlusPlus::seed_from_u64(self.seed ^ hash::mix_64(purpose));
        samples.as_flattened_mut().iter_mut().for_each(|value| *value = unit::to_f32(generator.next_u32()));
    }
}
