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
                let row = [x, y, frame];
                $crate::sampler::fill!(samples, D, |value| value, self.singles_of_row / pairs_of_row(row, domain, index));
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
                let (row, convert) = ([x, y, frame], $crate::unit::to_f32);
                $crate::sampler::fill!(samples, D, convert, self.singles_of_row / pairs_of_row(row, domain, index));
            }
        }
    };
}
pub(super) use row_shape;

/// The private draws for a row, pixel by pixel.
macro_rules! row_by_pixels {
    (impl[$($generics:tt)*] $sampler:ty, $single:ident) => {
        impl<$($generics)*> $sampler {
            #[inline]
            fn singles_of_row<T>(
                &self,
                pad: u32,
                [x, y, frame]: [u32; 3],
                domain: u32,
                index: u32,
                targets: impl Iterator<Item = T>,
                put: impl Fn(T, u32),
            ) {
                let mut x = x;
                for target in targets {
                    let single = self.pixel(x, y, frame).$single(domain, pad);
                    put(target, $crate::sampler::Single::value(single, index.reverse_bits()));
                    x = x.wrapping_add(1);
                }
            }

            #[inline]
            fn pairs_of_row<T>(
                &self,
                pad: u32,
                [x, y, frame]: [u32; 3],
                domain: u32,
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
