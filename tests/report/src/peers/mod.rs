//! What people use today, in the call shape of the crate, so that one list holds all.
//!
//! Two are packages, the others are written anew from the published descriptions. Each pixel type has
//! `pair(self, pair, index)` for pairs of dimensions 0, 1, 2, …: a domain has two of them.

mod cycles;
mod heitz;
mod pbrt;
mod pcg;
mod random_pattern;
mod sobol_burley;

pub use cycles::Cycles;
pub use heitz::Heitz;
pub use pbrt::Pbrt;
pub use pcg::Pcg;
pub use random_pattern::RandomPattern;
pub use sobol_burley::SobolBurley;

/// `draw` of a pixel from its pairs.
macro_rules! draws {
    ($pixel:ty) => {
        impl $pixel {
            #[inline]
            pub fn draw<const D: usize>(self, domain: u32, index: u32) -> [f32; D] {
                let mut out = [0.0; D];
                for k in 0..D.div_ceil(2) {
                    let pair = self.pair(2 * domain + k as u32, index);
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

/// Interleaves the lower 16 bits of x and y, x lowest.
const fn morton(x: u32, y: u32) -> u32 {
    const fn spread(v: u32) -> u32 {
        let v = v & 0xffff;
        let v = (v | v << 8) & 0x00ff_00ff;
        let v = (v | v << 4) & 0x0f0f_0f0f;
        let v = (v | v << 2) & 0x3333_3333;
        (v | v << 1) & 0x5555_5555
    }
    spread(x) | spread(y) << 1
}
