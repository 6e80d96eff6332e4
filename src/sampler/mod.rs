//! The call shape that all samplers share, and the samplers.
//!
//! ```
//! use bluedither::Sampler; // or any other: changing this one word compares two
//!
//! const LENS: u32 = 0; // a domain names what the numbers are for:
//! const TIME: u32 = 1; // different domains are decorrelated
//!
//! let (seed, spp, frame) = (1, 4, 0);
//! let sampler = Sampler::with_spp(seed, spp);
//! for (x, y) in [(0, 0), (1, 0)] {
//!     let pixel = sampler.pixel(x, y, frame);
//!     for index in 0..spp {
//!         let [u, v] = pixel.draw::<2>(LENS, index); // f32 in [0, 1)
//!         let [t] = pixel.draw::<1>(TIME, index);
//!         assert!(u < 1.0 && v < 1.0 && t < 1.0);
//!     }
//! }
//! ```

mod constant;
mod dithered;
mod keyed;
mod linear;
mod rank1;
mod row;
mod white;
mod zorder;

pub use constant::Constant;
pub use dithered::{Dithered, DitheredPixel};
pub use keyed::{Keyed, KeyedPixel};
pub use linear::{LinearPixel, Sampler};
pub use rank1::{Rank1, Rank1Pixel};
pub use white::{White, WhitePixel};
pub use zorder::{ZOrder, ZOrderPixel};

use row::{row_by_pixels, row_shape};

/// A single dimension of a domain in one pixel: all that does not depend on the index. Every sampler shuffles its
/// indices, which is done bit-reversed, so that is how they come.
trait Single: Copy {
    /// Its value at a bit-reversed index.
    fn value(self, index_rev: u32) -> u32;
}

/// A pair of dimensions of a domain in one pixel: all that does not depend on the index.
trait Pair: Copy {
    /// Its point at a bit-reversed index.
    fn point(self, index_rev: u32) -> [u32; 2];
}

/// The first of a pair, where it costs no more to have both.
impl<P: Pair> Single for P {
    #[inline(always)]
    fn value(self, index_rev: u32) -> u32 {
        self.point(index_rev)[0]
    }
}

/// The public draws of a pixel, made from its private `pair(domain, pad)`, a [`Pair`], where `pad` is 1 for the second pair
/// and else 0, and from what gives a [`Single`] in the same way: `pair` again, or a method of its own.
///
/// A macro and not a trait, so that a user needs no import and the docs of each sampler are whole.
macro_rules! call_shape {
    (impl[$($generics:tt)*] $pixel:ty, $single:ident) => {
        impl<$($generics)*> $pixel {
            /// Sample `index` for purpose `domain`: D = 1..4 numbers in 0.32 fixed point. More is a compile error.
            ///
            /// From D = 2 on, components 0 and 1 are the optimised pair of the domain, 2 and 3 a padded second pair; a
            /// component without a partner is drawn as a single dimension and need not equal the first of a pair. This is
            /// the definition; [`draw`](Self::draw) is derived from it. Number domains 0, 1, 2, …
            #[inline(always)]
            #[must_use]
            pub fn draw_fx<const D: usize>(self, domain: u32, index: u32) -> [u32; D] {
                const { assert!(D >= 1 && D <= 4, "a domain has 1 to 4 dimensions: draw more from further domains") };
                let mut out = [0; D];
                let mut k = 0;
                while k < D {
                    let pad = if k < 2 { 0 } else { 1 };
                    if k + 1 < D {
                        [out[k], out[k + 1]] = $crate::sampler::Pair::point(self.pair(domain, pad), index.reverse_bits());
                    } else {
                        out[k] = $crate::sampler::Single::value(self.$single(domain, pad), index.reverse_bits());
                    }
                    k += 2;
                }
                out
            }

            /// Sample `index` for purpose `domain`: D = 1..4 numbers in [0, 1). More is a compile error.
            #[inline(always)]
            #[must_use]
            pub fn draw<const D: usize>(self, domain: u32, index: u32) -> [f32; D] {
                $crate::unit::to_f32s(self.draw_fx(domain, index))
            }

            /// Samples `first`, `first` + 1, … for purpose `domain`, D = 1..4 numbers each: what
            /// [`draw_fx`](Self::draw_fx) returns, but what does not depend on the index is done once, which pays off from
            /// a few samples on. Indices wrap after 2³²−1.
            #[inline]
            pub fn fill_fx<const D: usize>(self, domain: u32, first: u32, samples: &mut [[u32; D]]) {
                self.fill_by(domain, first, samples, |number| number);
            }

            /// Samples `first`, `first` + 1, … for purpose `domain`, D = 1..4 numbers each: what [`draw`](Self::draw)
            /// returns, but what does not depend on the index is done once, which pays off from a few samples on. Indices
            /// wrap after 2³²−1.
            #[inline]
            pub fn fill<const D: usize>(self, domain: u32, first: u32, samples: &mut [[f32; D]]) {
                self.fill_by(domain, first, samples, $crate::unit::to_f32);
            }

            /// Each number through `convert`. What does not depend on the index stands before the loops.
            #[inline]
            fn fill_by<const D: usize, T>(
                self,
                domain: u32,
                first: u32,
                samples: &mut [[T; D]],
                convert: impl Fn(u32) -> T + Copy,
            ) {
                use $crate::sampler::{Pair, Single, each_rev};
                const { assert!(D >= 1 && D <= 4, "a domain has 1 to 4 dimensions: fill more from further domains") };
                if D == 1 {
                    let single = self.$single(domain, 0);
                    each_rev(first, samples, |index, out| out[0] = convert(single.value(index)));
                    return;
                }
                let pair = self.pair(domain, 0);
                if D == 2 {
                    each_rev(first, samples, |index, out| [out[0], out[1]] = pair.point(index).map(convert));
                } else if D == 3 {
                    let single = self.$single(domain, 1);
                    each_rev(first, samples, |index, out| {
                        [out[0], out[1]] = pair.point(index).map(convert);
                        out[2] = convert(single.value(index));
                    });
                } else {
                    let second = self.pair(domain, 1);
                    each_rev(first, samples, |index, out| {
                        [out[0], out[1]] = pair.point(index).map(convert);
                        [out[2], out[3]] = second.point(index).map(convert);
                    });
                }
            }

            /// The pixel's first `count` samples for purpose `domain` at once; at most `CAPACITY` of them.
            #[cfg(feature = "pattern")]
            #[inline]
            #[must_use]
            pub fn pattern<const D: usize, const CAPACITY: usize>(
                self,
                domain: u32,
                count: u32,
            ) -> $crate::pattern::Pattern<D, CAPACITY> {
                let mut pattern = $crate::pattern::of_length(count);
                self.fill(domain, 0, &mut pattern);
                pattern
            }
        }
    };
}
use call_shape;

/// The bit-reversed indices from `first` on, one for each target. A reversal costs as much as a sample: one for sixteen.
#[inline(always)]
fn each_rev<T>(first: u32, targets: &mut [T], put: impl Fn(u32, &mut T)) {
    static LOWER: [u32; 16] = {
        let mut reversed = [0; 16];
        let mut k = 0u32;
        while k < 16 {
            reversed[k as usize] = k.reverse_bits();
            k += 1;
        }
        reversed
    };
    let part = |index: u32, targets: &mut [T]| {
        let upper = (index & !15).reverse_bits();
        targets.iter_mut().zip(&LOWER[(index & 15) as usize..]).for_each(|(target, lower)| put(upper | lower, target));
    };
    let (start, rest) = targets.split_at_mut(targets.len().min((first.wrapping_neg() & 15) as usize));
    part(first, start);
    // Whole runs of sixteen, of which a compiler makes vectors.
    let mut index = first.wrapping_add(15) & !15;
    let mut runs = rest.chunks_exact_mut(16);
    for run in &mut runs {
        let upper = index.reverse_bits();
        run.iter_mut().zip(&LOWER).for_each(|(target, lower)| put(upper | lower, target));
        index = index.wrapping_add(16);
    }
    part(index, runs.into_remainder());
}

/// The upper half of a word and the lower one.
#[inline(always)]
#[expect(clippy::cast_possible_truncation, reason = "halves of a word")]
const fn halves(word: u64) -> [u32; 2] {
    [(word >> 32) as u32, word as u32]
}

/// The seed of a domain's numbers, one for each of its two pairs.
#[inline(always)]
const fn domain_seed(seed: u32, domain: u32, pad: u32) -> u32 {
    crate::hash::combine(seed, padded(domain, pad))
}

/// The 64 bits of a domain's own: times an odd number, which is a constant if the domain is.
#[inline(always)]
const fn domain_word(seed: u64, domain: u32, pad: u32) -> u64 {
    seed.wrapping_mul(crate::hash::mix_64(padded(domain, pad) as u64) | 1)
}

/// A domain of its own for a second pair: by a constant without a pattern, so that it meets no domain in use.
#[inline(always)]
const fn padded(domain: u32, pad: u32) -> u32 {
    domain ^ pad.wrapping_mul(0x5bd1_e995)
}

/// A number that differs between the pixels of a screen, to be hashed with a seed: two odd constants of no meaning.
#[inline(always)]
const fn spread(x: u32, y: u32) -> u32 {
    x.wrapping_mul(0x9e37_79b1) ^ y.wrapping_mul(0x85eb_ca77)
}
