//! The call shape for a row of pixels at once: one sample of each.

/// The public draws of a sampler for a row of pixels, made from its private `row`, which puts every number through
/// `convert`:
/// ```text
/// row::<D, T>(&self, [x, y, frame], domain, index, samples: &mut [[T; D]], convert)
/// ```
macro_rules! row_shape {
    (impl[$($generics:tt)*] $sampler:ty) => {
        impl<$($generics)*> $sampler {
            /// Sample `index` of the pixels (x, y), (x+1, y), … for purpose `domain`, D = 1..8 numbers each: what their
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
                const { $crate::sampler::assert_dimensions(D) };
                self.row([x, y, frame], domain, index, samples, |number| number);
            }

            /// Sample `index` of the pixels (x, y), (x+1, y), … for purpose `domain`, D = 1..8 numbers each: what their
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
                const { $crate::sampler::assert_dimensions(D) };
                self.row([x, y, frame], domain, index, samples, $crate::unit::to_f32);
            }
        }
    };
}
pub(super) use row_shape;

/// The private draws for a row, pixel by pixel: what is the same in all is inlined, for the compiler to take out.
macro_rules! row_by_pixels {
    (impl[$($generics:tt)*] $sampler:ty) => {
        impl<$($generics)*> $sampler {
            #[inline]
            fn row<const D: usize, T>(
                &self,
                [x, y, frame]: [u32; 3],
                domain: u32,
                index: u32,
                samples: &mut [[T; D]],
                convert: impl Fn(u32) -> T + Copy,
            ) {
                let mut x = x;
                for sample in samples {
                    *sample = self.pixel(x, y, frame).draw_fx(domain, index).map(convert);
                    x = x.wrapping_add(1);
                }
            }
        }
    };
}
pub(super) use row_by_pixels;
