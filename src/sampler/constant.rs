//! The fully correlated control: the same samples in every pixel.

use super::white::{White, WhitePixel};
use super::{row_by_pixels, row_shape};

/// One set of Owen-scrambled Sobol points for the whole image: no noise, all bias, seen as banding and ghosting.
#[derive(Clone, Copy, Debug)]
pub struct Constant {
    points: White,
}

impl Constant {
    /// Progressive: the sequence goes on for as long as it is asked.
    #[inline]
    #[must_use]
    pub const fn new(seed: u32) -> Self {
        Self { points: White::new(seed) }
    }

    /// The same as [`new`](Self::new); `spp` makes no difference.
    #[inline]
    #[must_use]
    pub const fn with_spp(seed: u32, spp: u32) -> Self {
        Self { points: White::with_spp(seed, spp) }
    }

    /// The samples of every pixel in one frame: `x` and `y` make no difference.
    #[inline]
    #[must_use]
    pub const fn pixel(&self, x: u32, y: u32, frame: u32) -> WhitePixel {
        (_, _) = (x, y);
        self.points.pixel(0, 0, frame)
    }
}

row_shape!(impl[] Constant);
row_by_pixels!(impl[] Constant);
