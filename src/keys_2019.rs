//! The tables of 2019 by the formula that came with them, for renders that must match (Heitz, Belcour, Ostromoukhov,
//! Coeurjolly and Iehl 2019, "A low-discrepancy sampler that distributes Monte Carlo errors as a blue noise in screen
//! space").
//!
//! The tables are the caller's: 8-bit values, 256 samples, a tile of 128². With more than one sample many pixels share a
//! value and the finest digits are missing; [`Keyed`](crate::Keyed) has neither limit.

/// Tables of one number of samples per pixel, as published: rows of x, dimensions interleaved.
#[derive(Clone, Copy, Debug)]
pub struct Tables2019<'a> {
    sobol: &'a [u8],
    scrambling: &'a [u8],
    ranking: &'a [u8],
}

impl<'a> Tables2019<'a> {
    /// `sobol[dimension + 256·sample]` and `scrambling`, `ranking[dimension + 8·(x + 128·y)]`: none unless there are
    /// 65,536, 131,072 and 131,072 of them.
    #[must_use]
    pub const fn from_slices(sobol: &'a [u8], scrambling: &'a [u8], ranking: &'a [u8]) -> Option<Self> {
        if sobol.len() != 256 * 256 || scrambling.len() != 128 * 128 * 8 || ranking.len() != 128 * 128 * 8 {
            return None;
        }
        Some(Self { sobol, scrambling, ranking })
    }

    /// The value of a sample, k for (k + ½)/256. Coordinates wrap at 128, `index` and `dimension` at 256.
    ///
    /// The tile has 8 dimensions, and 8 and above read those of `dimension` modulo 8. The published code forgets that
    /// for the ranks: it reads a neighbour's and, at the last pixels, past the end of the table. Here both wrap.
    #[inline]
    #[must_use]
    pub const fn value(&self, x: u32, y: u32, index: u32, dimension: u32) -> u8 {
        let tile = (dimension & 7 | (x & 127) << 3 | (y & 127) << 10) as usize;
        let index = (index & 255) as u8 ^ self.ranking[tile];
        self.sobol[(dimension & 255 | (index as u32) << 8) as usize] ^ self.scrambling[tile]
    }

    /// The value in 0.32 fixed point: (k + ½)/256.
    #[inline]
    #[must_use]
    pub const fn value_fx(&self, x: u32, y: u32, index: u32, dimension: u32) -> u32 {
        (self.value(x, y, index, dimension) as u32) << 24 | 1 << 23
    }

    /// The value in (0, 1).
    #[inline]
    #[must_use]
    pub const fn value_f32(&self, x: u32, y: u32, index: u32, dimension: u32) -> f32 {
        crate::unit::to_f32(self.value_fx(x, y, index, dimension))
    }
}
