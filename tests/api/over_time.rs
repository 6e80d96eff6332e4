//! Masks over time: exact in every frame, blue in space and in time.

use crate::analysis::SIGMAS;
use crate::analysis::error::{ErrorImage, kernel_norm};
use crate::analysis::integrands::{Integrand2, evaluation_half_plane_2d, evaluation_smooth_2d};
use crate::analysis::spectrum::low_frequency_power;
use bluedither::frames::masks::VectorTimeMask;
use bluedither::{ScalarMask, VectorMask, tables};

/// The mask of a frame.
type Frame<'a, const S: usize> = &'a dyn Fn(u32) -> &'static ScalarMask<S>;

/// A frame's values, ½ less.
fn values<const S: usize>(mask: Frame<S>, frame: u32) -> Vec<f64> {
    let mask = mask(frame);
    (0..S * S).map(|p| f64::from(mask.value((p % S) as u32, (p / S) as u32)) - 0.5).collect()
}

fn rms(values: &[f64]) -> f64 {
    (values.iter().map(|v| v * v).sum::<f64>() / values.len() as f64).sqrt()
}

/// RMS of the mean over 16 frames of what `of` makes of the values, over one white frame's: unfiltered, and after a
/// Gaussian of 1 pixel.
fn mean_of_16<const S: usize>(mask: Frame<S>, of: impl Fn(f64) -> f64) -> [f64; 2] {
    let frames: Vec<Vec<f64>> = (0..16).map(|frame| values(mask, frame).into_iter().map(&of).collect()).collect();
    let errors = (0..S * S).map(|p| frames.iter().map(|frame| frame[p]).sum::<f64>() / 16.0).collect();
    let mean = ErrorImage { size: S, errors };
    let white = rms(&frames[0]);
    [mean.rms() / white, mean.filtered_rms(SIGMAS[0]) / (white * kernel_norm(S, SIGMAS[0]))]
}

fn check<const S: usize>(count: u32, mask: Frame<S>) {
    let mut all: Vec<_> = (0..count).map(mask).collect();
    for (t, frame) in (0..count).zip(&all) {
        let mut ranks = frame.ranks().as_flattened().to_vec();
        ranks.sort_unstable();
        assert!(ranks.iter().enumerate().all(|(i, &rank)| i == usize::from(rank)), "frame {t}: every rank once");
        assert_eq!(&mask(t + 3 * count), frame, "loops");
        assert_eq!(&mask(t.wrapping_sub(count)), frame, "loops");
    }
    all.sort_unstable_by_key(|frame| frame.ranks());
    all.dedup();
    assert_eq!(all.len() as u32, count, "every frame is another one");
    let low = (0..count).map(|frame| low_frequency_power(values(mask, frame).into_iter(), S)).fold(0.0, f64::max);
    let lag: f64 = (0..count)
        .map(|frame| {
            let (now, next) = (values(mask, frame), values(mask, frame + 1));
            now.iter().zip(&next).map(|(a, b)| a * b).sum::<f64>() / now.iter().map(|v| v * v).sum::<f64>()
        })
        .inspect(|lag| {
            // From the last frame to the first as well.
            assert!(*lag <= -0.4, "autocorrelation of two frames {lag}");
        })
        .sum::<f64>()
        / f64::from(count);
    let mean = mean_of_16(mask, |v| v);
    // Thresholds keep less than the values themselves: the mean square over seven.
    let thresholds = [0.06, 0.15, 0.3, 0.5, 0.62, 0.8, 0.93];
    let steps = thresholds.map(|level| mean_of_16(mask, |v| f64::from(u8::from(v + 0.5 < level)) - level));
    let step: [f64; 2] = [0, 1].map(|i| rms(&steps.map(|step| step[i])));
    println!("{S}x{S}x{count}: low {low:.5}, lag 1 {lag:.3}, mean of 16 {mean:.3?}, steps {step:.3?}");
    assert!(low <= 0.002, "low-frequency power {low} of white");
    assert!(lag <= -0.45, "autocorrelation from frame to frame {lag}");
    assert!(mean[0] <= 0.14 && mean[1] <= 0.03, "mean of 16 frames {mean:?}");
    assert!(step[0] <= 0.16 && step[1] <= 0.10, "mean of 16 frames of steps {step:?}");
}

#[test]
fn mask_of_32_frames() {
    check(32, &|frame| tables::THRESHOLD_OVER_TIME_32.frame(frame));
}

#[test]
fn mask_of_16_frames() {
    check(16, &|frame| tables::THRESHOLD_OVER_TIME_64.frame(frame));
}

#[test]
fn mask_of_64_frames() {
    check(64, &|frame| tables::THRESHOLD_OVER_TIME_128.frame(frame));
}

/// The default filter's; what it is for is tested where any filter's is, in `filtered.rs`.
#[test]
fn filtered_mask_of_16_frames() {
    for (t, frame) in (0u32..).zip(tables::THRESHOLD_FILTERED_OVER_TIME_64.frames()) {
        let mut ranks = frame.ranks().as_flattened().to_vec();
        ranks.sort_unstable();
        assert!(ranks.iter().enumerate().all(|(i, &rank)| i == usize::from(rank)), "frame {t}: every rank once");
        assert_eq!(tables::THRESHOLD_FILTERED_OVER_TIME_64.frame(t.wrapping_sub(16)), *frame, "loops");
    }
}

/// Error of the mean of frames from `first` on over that of one white frame: unfiltered and after Gaussians of 1 and
/// 2.1 pixels; root of the mean of squares over integrands.
fn left<const S: usize>(integrands: &[Integrand2], frames: &[&VectorMask<2, S>]) -> [f64; 3] {
    let mut sums = [0.0; 3];
    for integrand in integrands {
        let one = |mask: &VectorMask<2, S>, x, y| integrand.at(mask.value(x, y).map(f64::from));
        let mean = |x, y| frames.iter().map(|mask| one(mask, x, y)).sum::<f64>() / frames.len() as f64;
        let image = ErrorImage::new(S, integrand.exact, mean);
        let white = ErrorImage::new(S, integrand.exact, |x, y| one(frames[0], x, y)).rms();
        sums[0] += (image.rms() / white).powi(2);
        for (sum, sigma) in sums[1..].iter_mut().zip(SIGMAS) {
            *sum += (image.filtered_rms(sigma) / white / kernel_norm(S, sigma)).powi(2);
        }
    }
    sums.map(|sum| (sum / integrands.len() as f64).sqrt())
}

fn check_pairs<const S: usize, const T: usize>(mask: &VectorTimeMask<'_, S, T>, still: &VectorMask<2, S>) {
    let mut set = still.ranks().as_flattened().to_vec();
    set.sort_unstable();
    for (t, frame) in (0u32..).zip(mask.frames()) {
        let mut pairs = frame.ranks().as_flattened().to_vec();
        pairs.sort_unstable();
        assert_eq!(pairs, set, "frame {t}: the values of the still mask, which are a net");
        assert_eq!(mask.frame(t.wrapping_add(5 * T as u32)), *frame, "loops");
        assert_eq!(mask.frame(t.wrapping_sub(T as u32)), *frame, "loops");
    }
    for (name, integrands) in [("smooth", evaluation_smooth_2d()), ("half-planes", evaluation_half_plane_2d())] {
        let of_still = left(&integrands, &[still]);
        let mut one = [0.0; 3];
        for frame in mask.frames() {
            let frame = left(&integrands, &[frame]);
            one.iter_mut().zip(frame).for_each(|(sum, f)| *sum += f / T as f64);
        }
        // Means that begin anywhere: over the end of the loop, too.
        let mean_of = |count: u32, first: u32| {
            let frames: Vec<_> = (first..first + count).map(|frame| mask.frame(frame)).collect();
            left(&integrands, &frames)
        };
        let [two, four, sixteen] = [mean_of(2, T as u32 - 1), mean_of(4, T as u32 - 2), mean_of(16, 3)];
        println!(
            "{S}x{S}x{T} pairs, {name}: still {of_still:.3?}, frames {one:.3?}, mean of 2 {two:.3?}, 4 {four:.3?}, 16 {sixteen:.3?}"
        );
        assert!(one[1] <= 1.3 * of_still[1] && one[2] <= 1.3 * of_still[2], "a frame: {one:?}, still {of_still:?}");
        assert!(two[0] < 0.65 && four[0] < 0.42, "independent frames leave .71 and .50: {two:?}, {four:?}");
        assert!(sixteen[0] <= 0.30 * one[0] && sixteen[1] <= 0.6 * one[1], "the mean of 16: {sixteen:?}, one {one:?}");
    }
}

#[test]
fn pairs_of_16_frames() {
    check_pairs(&tables::OFFSET_2D_OVER_TIME_32, &tables::OFFSET_2D_32);
}

#[test]
fn pairs_of_8_frames() {
    check_pairs(&tables::OFFSET_2D_OVER_TIME_64, &tables::OFFSET_2D_64);
}
