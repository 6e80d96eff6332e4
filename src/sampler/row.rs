//! The call shape for a row of pixels at once: one sample of each.

/// The public draws of a sampler for a row of pixels, made from two private ones that give single dimensions and pairs
/// to targets, `singles_of_row` and `pairs_of_row`.
macro_rules! row_shape {
    (impl[$($generics:tt)*] $sampler:ty) => {
        impl<$($generics)*> $sampler {
            /// Sample `index` of the pixels (x, y), (x+1, y), … for purpose `domain`: what their
            /// `pixel(..).draw_fx(domain, index)` return. Coordinates wrap after 2³²−1.
            #[inline]
            #[allow(clippy::too_many_arguments, reason = "a pixel and a draw")]
            pub fn fill_row_fx<const D: usize>(
                &self,
                x: u32,
                y: u32,
                frame: u32,
                domain: u32,
                index: u32,
                samples: &mut [[u32; D]],
            ) {
                $crate::sampler::row::fill_row!(self, [x, y, frame], domain, index, samples, D, |value| value);
            }

            /// Sample `index` of the pixels (x, y), (x+1, y), … for purpose `domain`: what their
            /// `pixel(..).draw(domain, index)` return. Coordinates wrap after 2³²−1.
            #[inline]
            #[allow(clippy::too_many_arguments, reason = "a pixel and a draw")]
            pub fn fill_row<const D: usize>(
                &self,
                x: u32,
                y: u32,
                frame: u32,
                domain: u32,
                index: u32,
                samples: &mut [[f32; D]],
            ) {
                $crate::sampler::row::fill_row!(self, [x, y, frame], domain, index, samples, D, $crate::unit::to_f32);
            }
        }
    };
}
pub(super) use row_shape;

/// Fills `samples` pair by pair, as `fill!` does, from pixel to pixel.
macro_rules! fill_row {
    ($sampler:ident, $pixel:expr, $domain:ident, $index:ident, $samples:ident, $D:ident, $convert:expr) => {{
        const { assert!($D >= 1 && $D <= 4, "a domain has 1 to 4 dimensions: fill more from further domains") };
        if $D == 1 {
            $crate::sampler::row::fill_row!(@single $sampler, $pixel, $domain, $index, $samples, 0, $convert);
        } else {
            $crate::sampler::row::fill_row!(@pair $sampler, $pixel, $domain, $index, $samples, 0, $convert);
        }
        if $D == 3 {
            $crate::sampler::row::fill_row!(@single $sampler, $pixel, $domain, $index, $samples, 2, $convert);
        }
        if $D == 4 {
            $crate::sampler::row::fill_row!(@pair $sampler, $pixel, $domain, $index, $samples, 2, $convert);
        }
    }};
    (@single $sampler:ident, $pixel:expr, $domain:ident, $index:ident, $samples:ident, $k:literal, $convert:expr) => {
        let put = |sample: &mut [_; D], value| [sample[$k]] = [value].map($convert);
        $sampler.singles_of_row($pixel, $domain, $k / 2, $index, $samples.iter_mut(), put);
    };
    (@pair $sampler:ident, $pixel:expr, $domain:ident, $index:ident, $samples:ident, $k:literal, $convert:expr) => {
        let put = |sample: &mut [_; D], point: [u32; 2]| [sample[$k], sample[$k + 1]] = point.map($convert);
        $sampler.pairs_of_row($pixel, $domain, $k / 2, $index, $samples.iter_mut(), put);
    };
}
pub(super) use fill_row;

/// The private draws for a row, pixel by pixel.
macro_rules! row_by_pixels {
    (impl[$($generics:tt)*] $sampler:ty) => {
        impl<$($generics)*> $sampler {
            #[inline]
            fn singles_of_row<T>(
                &self,
                [x, y, frame]: [u32; 3],
                domain: u32,
                pad: u32,
                index: u32,
                targets: impl Iterator<Item = T>,
                put: impl Fn(T, u32),
            ) {
                let mut x = x;
                for target in targets {
                    let single = self.pixel(x, y, frame).single(domain, pad);
                    put(target, $crate::sampler::Single::value(single, index.reverse_bits()));
                    x = x.wrapping_add(1);
                }
            }

            #[inline]
            fn pairs_of_row<T>(
                &self,
                [x, y, frame]: [u32; 3],
                domain: u32,
                pad: u32,
                index: u32,
                targets: impl Iterator<Item = T>,
                put: impl Fn(T, [u32; 2]),
            ) {
                let mut x = x;
                for target in targets {
                    let pair = self.pixel(x, y, frame).pair(domain, pad);
                    put(target, $crate::sampler::Pair::point(pair, index.reverse_bits()));
                    x = x.wrapping_add(1);
                }
            }
        }
    };
}
pub(super) use row_by_pixels;
