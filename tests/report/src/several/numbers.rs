//! Where the eight numbers of a point come from: one domain, or a domain a pair.

use crate::shape::Pixel;

/// How many samples are drawn at once.
pub const RUN: usize = 16;

/// Which domains the numbers are drawn from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// All from one.
    One,
    /// Each pair from one of its own.
    Several,
}

impl Form {
    pub const BOTH: [Self; 2] = [Self::One, Self::Several];

    pub const fn name(self) -> &'static str {
        match self {
            Self::One => "one domain",
            Self::Several => "several domains",
        }
    }

    /// Samples from `first` on.
    #[inline(always)]
    pub fn fill(self, pixel: impl Pixel, first: u32, points: &mut [[f32; 8]]) {
        match self {
            Self::One => pixel.fill::<8>(0, first, points),
            Self::Several => {
                let mut pairs = [[0.0; 2]; RUN];
                for domain in 0..4 {
                    pixel.fill::<2>(domain, first, &mut pairs[..points.len()]);
                    for (point, pair) in points.iter_mut().zip(&pairs) {
                        point[2 * domain as usize..][..2].copy_from_slice(pair);
                    }
                }
            }
        }
    }
}
