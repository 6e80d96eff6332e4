//! Padding: the eight numbers of a domain as four pairs of one sampler, each with seeds and places of its own.

/// A single dimension of a domain in one pixel: all that does not depend on the index. Every sampler shuffles its
/// indices, which is done bit-reversed, so that is how they come.
pub(super) trait Single: Copy {
    /// Its value at a bit-reversed index.
    fn value(self, index_rev: u32) -> u32;
}

/// A pair of dimensions of a domain in one pixel: all that does not depend on the index.
pub(super) trait Pair: Copy {
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

/// What [`call_shape!`](super::shape) asks for, made from a pixel's private `pair(domain, pad)`, a [`Pair`], where
/// `pad` = 0..3 is the number of the pair in its domain, and from what gives a [`Single`] in the same way: `pair`
/// again, or a method of its own.
macro_rules! padded {
    (impl[$($generics:tt)*] $pixel:ty, $single:ident) => {
        impl<$($generics)*> $pixel {
            /// The first D numbers of a domain at an index.
            #[inline(always)]
            fn numbers<const D: usize>(self, domain: u32, index: u32) -> [u32; D] {
                use $crate::sampler::padded::{Pair, Single};
                let index_rev = index.reverse_bits();
                let mut out = [0; D];
                let (mut k, mut pad) = (0, 0);
                while k < D {
                    if k + 1 < D {
                        [out[k], out[k + 1]] = self.pair(domain, pad).point(index_rev);
                    } else {
                        out[k] = self.$single(domain, pad).value(index_rev);
                    }
                    (k, pad) = (k + 2, pad + 1);
                }
                out
            }

            /// The same at `first`, `first` + 1, …, each number through `convert`.
            #[inline]
            fn fill_by<const D: usize, T>(
                self,
                domain: u32,
                first: u32,
                samples: &mut [[T; D]],
                convert: impl Fn(u32) -> T + Copy,
            ) {
                self.fill_pair::<0, D, T>(domain, first, samples, convert);
                if D > 2 {
                    self.fill_pair::<1, D, T>(domain, first, samples, convert);
                }
                if D > 4 {
                    self.fill_pair::<2, D, T>(domain, first, samples, convert);
                }
                if D > 6 {
                    self.fill_pair::<3, D, T>(domain, first, samples, convert);
                }
            }

            /// One of the pairs, or what there is of it: what does not depend on the index stands before the loops.
            /// Places are constants, so that no bounds check is left.
            #[inline(always)]
            fn fill_pair<const PAD: u32, const D: usize, T>(
                self,
                domain: u32,
                first: u32,
                samples: &mut [[T; D]],
                convert: impl Fn(u32) -> T + Copy,
            ) {
                use $crate::sampler::padded::{Pair, Single, each_rev};
                if 2 * (PAD as usize) + 1 < D {
                    let pair = self.pair(domain, PAD);
                    each_rev(first, samples, |index_rev, out| {
                        [out[2 * PAD as usize], out[2 * PAD as usize + 1]] = pair.point(index_rev).map(convert);
                    });
                } else {
                    let single = self.$single(domain, PAD);
                    each_rev(first, samples, |index_rev, out| {
                        out[2 * PAD as usize] = convert(single.value(index_rev));
                    });
                }
            }
        }
    };
}
pub(super) use padded;

/// The bit-reversed indices from `first` on, one for each target. A reversal costs as much as a sample: one for
/// sixteen.
#[inline(always)]
pub(super) fn each_rev<T>(first: u32, targets: &mut [T], put: impl Fn(u32, &mut T)) {
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

/// The seed of a domain's numbers, one for each of its pairs.
#[inline(always)]
pub(super) const fn domain_seed(seed: u32, domain: u32, pad: u32) -> u32 {
    crate::hash::combine(seed, own(domain, pad))
}

/// A number for every pair of every domain: by a constant without a pattern, so that domains below 2²⁸ meet no other's
/// second to fourth pair.
#[inline(always)]
const fn own(domain: u32, pad: u32) -> u32 {
    domain ^ pad.wrapping_mul(0x5bd1_e995)
}

/// A number that differs between the pixels of a screen, to be hashed with a seed: two odd constants of no meaning.
#[inline(always)]
pub(super) const fn spread(x: u32, y: u32) -> u32 {
    x.wrapping_mul(0x9e37_79b1) ^ y.wrapping_mul(0x85eb_ca77)
}
