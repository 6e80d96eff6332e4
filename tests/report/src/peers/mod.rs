//! What people use today, in the call shape of the crate, so that one list holds all.
//!
//! Four are packages, the others are written anew from the published descriptions. Each pixel type has
//! `pair(self, pair, index)` for pairs of dimensions 0, 1, 2, …: a domain has four of them.

mod cycles;
mod heitz;
pub mod joint;
mod openqmc;
mod pbrt;
mod pcg;
mod rand;
mod random_pattern;
mod sobol_burley;

pub use cycles::{Cycles, CyclesPixel};
pub use heitz::{Heitz, HeitzPixel};
pub use joint::{JointSobol, JointSobolPixel, SobolZ, SobolZPixel};
pub use openqmc::{OpenQmc, OpenQmcPixel};
pub use pbrt::{Pbrt, PbrtPixel};
pub use pcg::{Pcg, PcgPixel};
pub use rand::{Rand, RandPixel};
pub use random_pattern::{RandomPattern, RandomPatternPixel};
pub use sobol_burley::{SobolBurley, SobolBurleyPixel};

/// `draw` of a pixel from its pairs.
macro_rules! draws {
    ($pixel:ty) => {
        impl $pixel {
            #[inline]
            pub fn draw<const D: usize>(self, domain: u32, index: u32) -> [f32; D] {
                let mut out = [0.0; D];
                for k in 0..D.div_ceil(2) {
                    let pair = self.pair(4 * domain + k as u32, index);
                    out[2 * k..].iter_mut().zip(pair).for_each(|(out, value)| *out = value);
                }
                out
            }

            $crate::peers::fill!();
        }
    };
}
use draws;

/// Many samples: a loop, for the peers have nothing better to offer.
macro_rules! fill {
    () => {
        #[inline]
        pub fn fill<const D: usize>(self, domain: u32, first: u32, samples: &mut [[f32; D]]) {
            for (k, sample) in (0..).zip(samples) {
                *sample = self.draw(domain, first.wrapping_add(k));
            }
        }
    };
}
use fill;
