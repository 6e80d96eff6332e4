//! Masks over time: exact in every frame, blue in space and in time.
#![cfg(any(feature = "threshold-over-time-32", feature = "threshold-over-time-64"))]
#![allow(
    clippy::std_instead_of_core,
    clippy::cast_possible_truncation,
    reason = "a test on the host, on small numbers"
)]

mod analysis;

use analysis::SIGMAS;
use analysis::error::{ErrorImage, kernel_norm};
use analysis::spectrum::low_frequency_power;
use bluedither::frames::masks::TimeMask;

/// A frame's values, ½ less.
fn values<const S: usize, const T: usize>(mask: &TimeMask<S, T>, frame: u32) -> Vec<f64> {
    let mask = mask.frame(frame);
    (0..S * S).map(|p| f64::from(mask.value((p % S) as u32, (p / S) as u32)) - 0.5).collect()
}

fn rms(values: &[f64]) -> f64 {
    (values.iter().map(|v| v * v).sum::<f64>() / values.len() as f64).sqrt()
}

/// RMS of the mean over 16 frames of what `of` makes of the values, over one white frame's: unfiltered, and after a
/// Gaussian of 1 pixel.
fn mean_of_16<const S: usize, const T: usize>(mask: &TimeMask<S, T>, of: impl Fn(f64) -> f64) -> [f64; 2] {
    let frames: Vec<Vec<f64>> = (0..16).map(|frame| values(mask, frame).into_iter().map(&of).collect()).collect();
    let errors = (0..S * S).map(|p| frames.iter().map(|frame| frame[p]).sum::<f64>() / 16.0).collect();
    let mean = ErrorImage { size: S, errors };
    let white = rms(&frames[0]);
    [mean.rms() / white, mean.filtered_rms(SIGMAS[0]) / (white * kernel_norm(S, SIGMAS[0]))]
}

fn check<const S: usize, const T: usize>(mask: &TimeMask<S, T>) {
    for (t, frame) in mask.frames().iter().enumerate() {
        let mut ranks = frame.ranks().as_flattened().to_vec();
        ranks.sort_unstable();
        assert!(ranks.iter().enumerate().all(|(i, &rank)| i == usize::from(rank)), "frame {t}: every rank once");
        assert_eq!(mask.frame(t as u32), frame);
        assert_eq!(mask.frame((t + 3 * T) as u32), frame, "loops");
        assert_eq!(mask.frame((t as u32).wrapping_sub(T as u32)), frame, "loops");
    }
    let low = (0..T as u32).map(|frame| low_frequency_power(values(mask, frame).into_iter(), S)).fold(0.0, f64::max);
    let lag: f64 = (0..T as u32)
        .map(|frame| {
            let (now, next) = (values(mask, frame), values(mask, frame + 1));
            now.iter().zip(&next).map(|(a, b)| a * b).sum::<f64>() / now.iter().map(|v| v * v).sum::<f64>()
        })
        .inspect(|lag| {
            // From the last frame to the first as well.
            assert!(*lag <= -0.4, "autocorrelation of two frames {lag}");
        })
        .sum::<f64>()
        / T as f64;
    let mean = mean_of_16(mask, |v| v);
    // Thresholds keep less than the values themselves: the mean square over seven.
    let thresholds = [0.06, 0.15, 0.3, 0.5, 0.62, 0.8, 0.93];
    let steps = thresholds.map(|level| mean_of_16(mask, |v| f64::from(u8::from(v + 0.5 < level)) - level));
    let step: [f64; 2] = [0, 1].map(|i| rms(&steps.map(|step| step[i])));
    println!("{S}x{S}x{T}: low {low:.5}, lag 1 {lag:.3}, mean of 16 {mean:.3?}, steps {step:.3?}");
    assert!(low <= 0.002, "low-frequency power {low} of white");
    assert!(lag <= -0.45, "autocorrelation from frame to frame {lag}");
    assert!(mean[0] <= 0.14 && mean[1] <= 0.03, "mean of 16 frames {mean:?}");
    assert!(step[0] <= 0.16 && step[1] <= 0.10, "mean of 16 frames of steps {step:?}");
}

#[cfg(feature = "threshold-over-time-32")]
#[test]
fn mask_of_32_frames() {
    check(&bluedither::tables::THRESHOLD_OVER_TIME_32);
}

#[cfg(feature = "threshold-over-time-64")]
#[test]
fn mask_of_16_frames() {
    check(&bluedither::tables::THRESHOLD_OVER_TIME_64);
}
