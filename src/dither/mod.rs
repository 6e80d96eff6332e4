//! Halftoning: pictures on displays with few levels, by comparing every pixel with a threshold.
//!
//! A value between two levels becomes the upper one where it exceeds the threshold of its pixel. With the thresholds
//! of a blue-noise mask the error is high-frequency (R. Ulichney 1987, 1993); a constant gives contours, random numbers
//! give grain, and an ordered (Bayer) matrix gives a regular pattern.
//!
//! ```
//! use bluedither::{Dither, ScalarMask};
//! # fn main() -> Result<(), bluedither::dither::RowError> {
//! # static MASK: ScalarMask<2> = ScalarMask::new([[0, 2], [3, 1]]);
//! let dither = Dither::blue(&MASK); // MASK: tables::THRESHOLD_64, another one, or your own
//! let row: [u8; 8] = [0, 100, 100, 100, 100, 100, 100, 255]; // grey
//! let mut bits = [0; 1]; // eight pixels a byte
//! for y in 0..2 {
//!     dither.gray1_row(y, &row, &mut bits)?; // row by row: no frame buffer
//!     # assert_eq!(bits[0] & 0x81, 0x01);
//! }
//! # Ok(())
//! # }
//! ```
//!
//! - **Exact** with a mask or a matrix, unless `triangular` or `gamma`: on a constant value v of 255, round(v·S²/255)
//!   pixels of every S×S tile are white; black stays black, white stays white, and so does every value that is a level.
//! - **Integers only.** Sources in `f32` (feature `float`) and gamma (feature `gamma`) add one conversion.
//! - **Channels** read the mask at different places, and so do frames, as far as a small one has places.
//! - Every row is a function of its arguments: no state, any order, any thread.
//!
//! Rows work in runs of 64 pixels on the stack. Masks and matrices up to 64² are prepared once a row, larger ones and
//! random numbers in every run.

pub mod alpha;
mod bits;
#[cfg(feature = "gamma")]
pub mod gamma;
mod kernel;
pub mod ordered;
pub mod quantise;
mod rows;
mod samples;
#[cfg(feature = "embedded-graphics")]
pub mod target;

use crate::{ScalarMask, hash, torus};

pub use rows::RowError;
pub use samples::Samples;

/// How many channels have places of their own.
const CHANNELS: usize = 4;

/// A way to choose thresholds: a small value to make once and to copy freely.
#[derive(Clone, Copy, Debug)]
pub struct Dither<'a> {
    thresholds: Thresholds<'a>,
    /// Where each channel looks its thresholds up; seeds of random ones.
    places: [[u32; 2]; CHANNELS],
    origin: [u32; 2],
    rule: Rule,
}

#[derive(Clone, Copy, Debug)]
enum Thresholds<'a> {
    Constant(u32),
    Random(u32),
    Ordered { size_log2: u32 },
    Mask { ranks: &'a [u16], size_log2: u32 },
}

/// What happens between two levels.
#[derive(Clone, Copy, Debug)]
enum Rule {
    Plain,
    Triangular,
    #[cfg(feature = "gamma")]
    Gamma,
}

impl Dither<'static> {
    /// The same threshold everywhere, in 0.32 fixed point: contours. `1 << 31` rounds to the nearest level.
    #[must_use]
    pub const fn constant(threshold_fx: u32) -> Self {
        Self::new(Thresholds::Constant(threshold_fx))
    }

    /// An independent random threshold for every pixel (a hash): grain.
    #[must_use]
    pub const fn random(seed: u32) -> Self {
        Self::new(Thresholds::Random(seed))
    }

    /// A Bayer matrix of 2^`size_log2` squared thresholds, computed, not stored: a regular pattern. Sizes beyond
    /// [`ordered::MAX_LOG2`] count as that.
    #[must_use]
    pub const fn ordered(size_log2: u32) -> Self {
        let size_log2 = if size_log2 < ordered::MAX_LOG2 { size_log2 } else { ordered::MAX_LOG2 };
        Self::new(Thresholds::Ordered { size_log2 })
    }
}

impl<'a> Dither<'a> {
    /// The thresholds of a mask: with one of the crate's `THRESHOLD` tables blue noise, or whatever yours holds.
    #[must_use]
    pub const fn blue<const S: usize>(mask: &'a ScalarMask<S>) -> Self {
        Self::new(Thresholds::Mask { ranks: mask.ranks().as_flattened(), size_log2: ScalarMask::<S>::SIZE_LOG2 })
    }

    const fn new(thresholds: Thresholds<'a>) -> Self {
        Self { thresholds, places: [[0; 2]; CHANNELS], origin: [0; 2], rule: Rule::Plain }.frame(0)
    }

    /// For frame `frame` of an animation: the thresholds are looked up elsewhere, so that the error is not stuck to the
    /// screen. Frame 0 is the still picture. Constant thresholds stay.
    #[must_use]
    pub const fn frame(mut self, frame: u32) -> Self {
        let mut channel = 0;
        while channel < CHANNELS {
            #[expect(clippy::cast_possible_truncation, reason = "below 4")]
            let domain = channel as u32;
            self.places[channel] = match self.thresholds {
                Thresholds::Constant(_) => [0; 2],
                Thresholds::Random(seed) => [hash::combine(hash::combine(seed, frame), domain), 0],
                Thresholds::Ordered { size_log2 } | Thresholds::Mask { size_log2, .. } => {
                    // From the first channel of frame 0 on: that one lies where the user's own look-ups do.
                    let first = torus::offset(0, 0, 0, 0, size_log2);
                    let place = torus::offset(0, domain, 0, frame, size_log2);
                    [place[0].wrapping_sub(first[0]), place[1].wrapping_sub(first[1])]
                }
            };
            channel += 1;
        }
        self
    }

    /// Where on the screen the first pixel of row 0 lies: parts that are drawn one by one fit without a seam.
    #[must_use]
    pub const fn origin(mut self, x: u32, y: u32) -> Self {
        self.origin = [x, y];
        self
    }

    /// Triangularly distributed noise of ±1 level (see [`quantise::triangular`]) instead of noise between two levels:
    /// the error's variance no longer depends on the value, except within half a level of black and white. Two levels
    /// stay as they were. Slower: pixel by pixel. Replaces `gamma`.
    #[must_use]
    pub const fn triangular(mut self) -> Self {
        self.rule = Rule::Triangular;
        self
    }

    /// Sources are sRGB, and the *light* of a dithered area is that of the source: without this, dithered mid-tones
    /// come out too bright. All channels of `levels_row` count as light; the alpha of `stencil_row` does not. Slower:
    /// pixel by pixel. Replaces `triangular`.
    #[cfg(feature = "gamma")]
    #[must_use]
    pub const fn gamma(mut self) -> Self {
        self.rule = Rule::Gamma;
        self
    }

    /// The threshold at a pixel in 0.32 fixed point; channels beyond the fourth repeat. Channel 0 of frame 0 of a mask
    /// is [`ScalarMask::value_fx`], at origin 0.
    #[inline]
    #[must_use]
    pub const fn threshold_fx(&self, x: u32, y: u32, channel: u32) -> u32 {
        let place = self.places[channel as usize % CHANNELS];
        let (x, y) = (x.wrapping_add(self.origin[0]), y.wrapping_add(self.origin[1]));
        let (shifted_x, shifted_y) = (x.wrapping_add(place[0]), y.wrapping_add(place[1]));
        match self.thresholds {
            Thresholds::Constant(threshold) => threshold,
            Thresholds::Random(_) => hash::combine(hash::combine(place[0], y), x),
            Thresholds::Ordered { size_log2 } => ordered::value_fx(shifted_x, shifted_y, size_log2),
            Thresholds::Mask { ranks, size_log2 } => {
                let size = 1 << size_log2;
                let row = (torus::wrap(shifted_y, size) as usize) << size_log2;
                let place = row + torus::wrap(shifted_x, size) as usize;
                // Always inside; the compiler cannot know.
                if place < ranks.len() { crate::mask::value_fx(ranks[place], size_log2) } else { 0 }
            }
        }
    }

    /// The level, 0..`levels`, of one value of 0..=`max` at a pixel. What all rows are made of.
    #[inline]
    #[must_use]
    pub const fn level(&self, x: u32, y: u32, channel: u32, value: u16, max: u16, levels: u16) -> u16 {
        self.rule.level(value, max, levels, self.threshold_fx(x, y, channel))
    }
}

impl Rule {
    #[inline]
    const fn level(self, value: u16, max: u16, levels: u16, threshold_fx: u32) -> u16 {
        match self {
            Self::Plain => quantise::level(value, max, levels, threshold_fx),
            Self::Triangular => quantise::level_triangular(value, max, levels, threshold_fx),
            #[cfg(feature = "gamma")]
            Self::Gamma => gamma::level(value, max, levels, threshold_fx),
        }
    }
}
