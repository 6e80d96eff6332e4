//! Masks over time, or spatiotemporal masks: a mask for every frame, blue in each frame and in each pixel's sequence of
//! frames.
//!
//! Thresholds by void-and-cluster in three dimensions (Ulichney 1993; Wolfe and others 2022), with the frames' tiles
//! treated alike at every step, so that each is a permutation of its ranks as a still mask is; pairs by swaps within
//! their frame, so that each holds the net that a still mask holds. After the last frame the first follows.
//!
//! For numbers (a threshold, a ray-march start) whose frames are averaged by the eye, by a filter or over time, and for
//! pairs (of one light) whose frames are averaged over time alone. Error of smooth integrands over that of one frame of
//! white noise, unfiltered and after a Gaussian of 1 pixel:
//!
//! | mean of | 1 frame | 2 | 4 | 16 |
//! |---|---|---|---|---|
//! | a mask over time, 64×64×16 | 1 / .22 | .47 / .12 | .23 / .06 | .04 / .02 |
//! | a still mask, its place moved (the samplers' `frame`) | 1 / .17 | .72 / .12 | .50 / .09 | .24 / .04 |
//! | a still mask, its values moved by the golden ratio | 1 / .41 | .53 / .28 | .32 / .18 | .08 / .06 |
//! | white noise | 1 / 1 | .71 / .71 | .5 / .5 | .25 / .25 |
//! | pairs over time, 64×64×8 | 1 / .43 | .58 / .28 | .31 / .18 | .17 / .12 |
//! | pairs over time, 32×32×16 | 1 / .44 | .57 / .28 | .31 / .18 | .12 / .08 |
//!
//! After a Gaussian of 1 pixel `Sampler` leaves .46 of white noise's error in one frame and .03 in 16, of smooth
//! integrands (`report -- frames`): less than pairs over time. `cargo test --all-features -- over_time:: animation::
//! filtered:: --nocapture` prints these tables.
//!
//! # For a filter that you know
//! `THRESHOLD_FILTERED_64` and `THRESHOLD_FILTERED_OVER_TIME_64` are made for what comes after them, which the
//! environment variable `BLUEDITHER_FILTER` names (Donnelly and others 2024). Error that the filter leaves, over that
//! of the same values in random places, of smooth integrands and of steps:
//!
//! | filter | the default mask | the mask for it |
//! |---|---|---|
//! | `box:3` | .45 / .51 | .25 / .39 |
//! | `box:5` | .34 / .40 | .17 / .28 |
//! | `binomial:3` | .31 / .45 | .25 / .42 |
//! | `gaussian:1` | .18 / .32 | .17 / .32 |
//! | `gaussian:2` | .02 / .17 | .03 / .15 |
//! | `gaussian:3` | .01 / .15 | .01 / .10 |
//! | `box:3+ema:0.1`, over time | .18 / .38 | .13 / .24 |
//! | `gaussian:1+ema:0.1`, over time | .12 / .33 | .10 / .20 |
//!
//! The default masks are made for Gaussians of 1 to 1.5 pixels, where nothing more is won. A mask for a box has a
//! little more error under a Gaussian, and the other way round: take it when the filter is certain. A mask for a filter
//! of your own has no recorded digest: nothing warns if it comes out otherwise on another machine.
//!
//! ```
//! # #[cfg(feature = "threshold-over-time-64")] {
//! use bluedither::tables::THRESHOLD_OVER_TIME_64;
//!
//! let (brightness, frame) = (0.3, 5);
//! let mask = THRESHOLD_OVER_TIME_64.frame(frame);
//! let lit = brightness > mask.value(17, 4);
//! # let _ = lit;
//! # }
//! ```

use crate::mask::{ScalarMask, VectorMask};

/// T masks of S×S pixels; T is a power of two. To dither by one, `Dither::blue(mask.frame(n))`, without
/// `Dither::frame`.
///
/// It holds references: T pointers beside the bytes of the masks, which can be yours and made at run time.
#[doc(alias = "spatiotemporal")]
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TimeMask<'a, const S: usize, const T: usize> {
    frames: [&'a ScalarMask<S>; T],
}

/// The same for pairs of numbers: offsets of two-dimensional samples. To sample by one,
/// `Dithered::with_masks(thresholds, mask.frame(n), seed)`, with frame 0.
#[doc(alias = "spatiotemporal")]
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct VectorTimeMask<'a, const S: usize, const T: usize> {
    frames: [&'a VectorMask<2, S>; T],
}

/// What both have. Frames are apart, so that no table is too large for a compiler.
macro_rules! frames_of {
    ($masks:ident of $mask:ty) => {
        impl<'a, const S: usize, const T: usize> $masks<'a, S, T> {
            /// Masks of your own, one for each frame.
            #[must_use]
            pub const fn new(frames: [&'a $mask; T]) -> Self {
                const { assert!(T.is_power_of_two() && T <= 1 << 16, "the number of frames is a power of two") };
                Self { frames }
            }

            /// The mask of a frame. Any frame: after T of them the first comes again. One load more than a still mask.
            #[inline]
            #[must_use]
            pub const fn frame(&self, frame: u32) -> &'a $mask {
                self.frames[frame as usize & (T - 1)]
            }

            /// All masks.
            #[inline]
            #[must_use]
            pub const fn frames(&self) -> &[&'a $mask; T] {
                &self.frames
            }
        }
    };
}

frames_of!(TimeMask of ScalarMask<S>);
frames_of!(VectorTimeMask of VectorMask<2, S>);
