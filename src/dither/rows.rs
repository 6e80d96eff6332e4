//! Rows of pictures, from samples to the bytes of a display.

use super::kernel::{self, Levels, RUN};
use super::{Dither, Samples, bits};
use core::fmt;

/// What keeps a row from being dithered. Nothing has been written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum RowError {
    /// The source does not hold whole pixels of so many channels.
    PartOfAPixel {
        /// Samples in the source.
        samples: usize,
        /// Samples in a pixel.
        channels: usize,
    },
    /// The destination is too short.
    TooShort {
        /// Numbers that the row takes.
        needed: usize,
        /// Numbers there are.
        given: usize,
    },
}

impl fmt::Display for RowError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::PartOfAPixel { samples, channels } => {
                write!(f, "a row of {samples} samples is not made of pixels of {channels}")
            }
            Self::TooShort { needed, given } => {
                write!(f, "the destination holds {given} numbers, and the row takes {needed}")
            }
        }
    }
}

impl core::error::Error for RowError {}

/// Pixels in a row of samples.
pub(super) const fn pixels(samples: usize, channels: usize) -> Result<usize, RowError> {
    match (samples.checked_div(channels), samples.checked_rem(channels)) {
        (Some(pixels), Some(0)) => Ok(pixels),
        (None, _) if samples == 0 => Ok(0),
        _ => Err(RowError::PartOfAPixel { samples, channels }),
    }
}

/// Whether the destination holds what is needed.
pub(super) const fn fits(needed: usize, given: usize) -> Result<(), RowError> {
    if needed <= given { Ok(()) } else { Err(RowError::TooShort { needed, given }) }
}

/// Each function dithers row `y`, from x = 0 on (see [`origin`](Dither::origin)). The destination may be longer than
/// needed; what is beyond the row stays. An empty row is no error. If the source does not hold whole pixels or the
/// destination is too short, they return that error and write nothing.
impl Dither<'_> {
    /// Grey to 1 bit: eight pixels a byte, the leftmost in the highest bit, 1 is white. Unused bits are 0.
    pub fn gray1_row<'s>(&self, y: u32, src: impl Into<Samples<'s>>, dst: &mut [u8]) -> Result<(), RowError> {
        match src.into() {
            Samples::U8(samples) if matches!(self.rule, super::Rule::Plain) => {
                let (needed, given) = (samples.len().div_ceil(8), dst.len());
                let dst = dst.get_mut(..needed).ok_or(RowError::TooShort { needed, given })?;
                bits::row(self, y, samples, dst);
                Ok(())
            }
            src => self.packed_row::<1, 8>(y, src, dst),
        }
    }

    /// Grey to 2 bits: four pixels a byte, the leftmost in the highest bits. Unused bits are 0.
    pub fn gray2_row<'s>(&self, y: u32, src: impl Into<Samples<'s>>, dst: &mut [u8]) -> Result<(), RowError> {
        self.packed_row::<2, 16>(y, src.into(), dst)
    }

    /// Grey to 4 bits: two pixels a byte, the left one in the higher bits. Unused bits are 0.
    pub fn gray4_row<'s>(&self, y: u32, src: impl Into<Samples<'s>>, dst: &mut [u8]) -> Result<(), RowError> {
        self.packed_row::<4, 32>(y, src.into(), dst)
    }

    /// RGB to a byte a pixel, `rrrgggbb`.
    pub fn rgb332_row<'s>(&self, y: u32, src: impl Into<Samples<'s>>, dst: &mut [u8]) -> Result<(), RowError> {
        let src = src.into();
        self.row(y, src, [8, 8, 4], src.len() / 3, dst, |levels, dst: &mut [u8; RUN]| {
            for (dst, &[r, g, b]) in dst.iter_mut().zip(levels) {
                *dst = r << 5 | g << 2 | b;
            }
        })
    }

    /// RGB to 16 bits a pixel, `rrrrrggggggbbbbb` from the highest bit on; how its bytes are sent is the display's.
    pub fn rgb565_row<'s>(&self, y: u32, src: impl Into<Samples<'s>>, dst: &mut [u16]) -> Result<(), RowError> {
        let src = src.into();
        if let (Samples::U8(samples), super::Rule::Plain) = (src, self.rule) {
            let (needed, given) = (pixels(samples.len(), 3)?, dst.len());
            let dst = dst.get_mut(..needed).ok_or(RowError::TooShort { needed, given })?;
            kernel::row_565(self, y, samples, dst);
            return Ok(());
        }
        self.row(y, src, [32, 64, 32], src.len() / 3, dst, |levels, dst: &mut [u16; RUN]| {
            for (dst, &[r, g, b]) in dst.iter_mut().zip(levels) {
                *dst = u16::from(r) << 11 | u16::from(g) << 5 | u16::from(b);
            }
        })
    }

    /// RGB to three bytes a pixel: for sources of more than 8 bits.
    pub fn rgb888_row<'s>(&self, y: u32, src: impl Into<Samples<'s>>, dst: &mut [u8]) -> Result<(), RowError> {
        let src = src.into();
        self.row(y, src, [256; 3], src.len(), dst, |levels, dst: &mut [u8; 3 * RUN]| {
            dst.copy_from_slice(levels.as_flattened());
        })
    }

    /// Any number of levels for each of C = 1 to 4 channels, a byte a channel that holds the level, 0..`levels`; see
    /// [`quantise::value`](super::quantise::value) for what it stands for. More than 256 levels count as 256.
    pub fn levels_row<'s, const C: usize>(
        &self,
        y: u32,
        src: impl Into<Samples<'s>>,
        levels: [u16; C],
        dst: &mut [[u8; C]],
    ) -> Result<(), RowError> {
        const { assert!(C >= 1 && C <= 4, "one to four channels") }
        let levels = levels.map(|levels| levels.min(256));
        let src = src.into();
        self.row(y, src, levels, src.len() / C, dst, |levels, dst: &mut [[u8; C]; RUN]| *dst = *levels)
    }

    /// The alpha of RGBA to 1 bit, packed as in [`gray1_row`](Self::gray1_row): which pixels to draw on what the screen
    /// shows. Its thresholds are those of the fourth channel, so that it is not tied to the colours.
    pub fn stencil_row(&self, y: u32, rgba: &[u8], dst: &mut [u8]) -> Result<(), RowError> {
        // Alpha is no light, and two levels have no room for more noise.
        Self { rule: super::Rule::Plain, ..*self }.row(
            y,
            Samples::U8(rgba),
            [1, 1, 1, 2],
            (rgba.len() / 4).div_ceil(8),
            dst,
            |levels, dst: &mut [u8; RUN / 8]| {
                for (dst, pixels) in dst.iter_mut().zip(levels.chunks_exact(8)) {
                    *dst = pixels.iter().fold(0, |byte, pixel| byte << 1 | pixel[3]);
                }
            },
        )
    }

    /// Grey in `BITS` bits, `N` bytes a run.
    fn packed_row<const BITS: usize, const N: usize>(
        &self,
        y: u32,
        src: Samples<'_>,
        dst: &mut [u8],
    ) -> Result<(), RowError> {
        self.row(y, src, [1 << BITS], src.len().div_ceil(8 / BITS), dst, |levels, dst: &mut [u8; N]| {
            for (dst, pixels) in dst.iter_mut().zip(levels.chunks_exact(8 / BITS)) {
                *dst = pixels.iter().fold(0, |byte, &[level]| byte << BITS | level);
            }
        })
    }

    /// `needed` numbers a row, N numbers a run: checks the lengths, then works.
    fn row<T: Copy, const C: usize, const N: usize>(
        &self,
        y: u32,
        src: Samples<'_>,
        levels: [u16; C],
        needed: usize,
        dst: &mut [T],
        pack: impl Fn(&Levels<C>, &mut [T; N]),
    ) -> Result<(), RowError> {
        pixels(src.len(), C)?;
        let given = dst.len();
        let dst = dst.get_mut(..needed).ok_or(RowError::TooShort { needed, given })?;
        kernel::row(self, y, src, levels, dst, pack);
        Ok(())
    }
}
