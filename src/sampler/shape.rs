//! The call shape for a pixel: one sample, a run of them, or all in a buffer.

/// The public draws of a pixel, made from two private methods that know nothing of floats:
/// ```text
/// numbers::<D>(self, domain, index) -> [u32; D]                          the first D numbers of a domain
/// fill_by::<D, T>(self, domain, first, samples: &mut [[T; D]], convert)  those of a run of indices, each through `convert`
/// ```
/// A macro and not a trait, so that a user needs no import and the docs of each sampler are whole.
macro_rules! call_shape {
    (impl[$($generics:tt)*] $pixel:ty) => {
        impl<$($generics)*> $pixel {
            /// Sample `index` for purpose `domain`: D = 1..8 numbers in 0.32 fixed point. More is a compile error.
            ///
            /// Components 2k and 2k+1 are an own pair, and the same in a longer draw. A last component without a
            /// partner need not be: [`Dithered`](crate::Dithered) has a mask of its own for it. This is the definition;
            /// [`draw`](Self::draw) is derived from it. Number domains 0, 1, 2, …
            #[inline(always)]
            #[must_use]
            pub fn draw_fx<const D: usize>(self, domain: u32, index: u32) -> [u32; D] {
                const { $crate::sampler::assert_dimensions(D) };
                self.numbers(domain, index)
            }

            /// Sample `index` for purpose `domain`: D = 1..8 numbers in [0, 1). More is a compile error.
            #[inline(always)]
            #[must_use]
            pub fn draw<const D: usize>(self, domain: u32, index: u32) -> [f32; D] {
                $crate::unit::to_f32s(self.draw_fx(domain, index))
            }

            /// Samples `first`, `first` + 1, … for purpose `domain`, D = 1..8 numbers each: what
            /// [`draw_fx`](Self::draw_fx) returns, but what does not depend on the index is done once, which pays off
            /// from a few samples on. Indices wrap after 2³²−1.
            #[inline]
            pub fn fill_fx<const D: usize>(self, domain: u32, first: u32, samples: &mut [[u32; D]]) {
                const { $crate::sampler::assert_dimensions(D) };
                self.fill_by(domain, first, samples, |number| number);
            }

            /// Samples `first`, `first` + 1, … for purpose `domain`, D = 1..8 numbers each: what [`draw`](Self::draw)
            /// returns, but what does not depend on the index is done once, which pays off from a few samples on.
            /// Indices wrap after 2³²−1.
            #[inline]
            pub fn fill<const D: usize>(self, domain: u32, first: u32, samples: &mut [[f32; D]]) {
                const { $crate::sampler::assert_dimensions(D) };
                self.fill_by(domain, first, samples, $crate::unit::to_f32);
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
pub(super) use call_shape;
