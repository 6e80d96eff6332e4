//! Frame after frame: every one as blue as the first, and their mean no worse than that of independent frames.
#![cfg(all(feature = "threshold-64", feature = "offset-2d-64"))]

use crate::analysis::SIGMAS;
use crate::analysis::error::ErrorImage;
use crate::analysis::half_plane::HalfPlane;
use crate::analysis::random::{Random, seeds};
use bluedither::tables::THRESHOLD_64;
use bluedither::{Dithered, Sampler, White, unit};

const SIZE: usize = 128;

/// One number or a pair, of pixel (x, y) in a frame.
type Draw<'a, const D: usize> = &'a dyn Fn(u32, u32, u32) -> [f64; D];

/// What is integrated, and what comes of it.
struct Integrand<const D: usize> {
    exact: f64,
    at: Box<dyn Fn([f64; D]) -> f64>,
}

fn smooth_1d() -> Vec<Integrand<1>> {
    vec![
        Integrand { exact: 0.5, at: Box::new(|[x]| x) },
        Integrand { exact: 1.0 / 3.0, at: Box::new(|[x]| x * x) },
        Integrand { exact: 0.746_824_132_8, at: Box::new(|[x]| libm::exp(-x * x)) },
    ]
}

fn smooth_2d() -> Vec<Integrand<2>> {
    vec![
        Integrand { exact: 0.25, at: Box::new(|[x, y]| x * y) },
        Integrand { exact: 0.557_746_285_3, at: Box::new(|[x, y]| libm::exp(-x * x - y * y)) },
    ]
}

fn half_planes() -> Vec<Integrand<2>> {
    let mut random = Random::new(seeds::HALF_PLANE_2D);
    let lines = (0..8).map(|_| HalfPlane::random(&mut random));
    lines.map(|line| Integrand { exact: line.area(), at: Box::new(move |p| line.value(p)) }).collect()
}

/// RMS of the error of the mean over frames `first..first + frames`, unfiltered and at both sigmas; integrands count
/// alike by the first frame of white noise.
fn error<const D: usize>(integrands: &[Integrand<D>], frames: core::ops::Range<u32>, draw: Draw<D>) -> [f64; 3] {
    let mut sums = [0.0; 3];
    for Integrand { exact, at } in integrands {
        let image = ErrorImage::new(SIZE, *exact, |x, y| {
            frames.clone().map(|frame| at(draw(x, y, frame))).sum::<f64>() / frames.len() as f64
        });
        let white = ErrorImage::new(SIZE, *exact, |x, y| at(white::<D>(x, y, 0)));
        sums[0] += (image.rms() / white.rms()).powi(2);
        for (i, sigma) in SIGMAS.into_iter().enumerate() {
            sums[i + 1] += (image.filtered_rms(sigma) / white.filtered_rms(sigma)).powi(2);
        }
    }
    sums.map(|sum| (sum / integrands.len() as f64).sqrt())
}

fn white<const D: usize>(x: u32, y: u32, frame: u32) -> [f64; D] {
    White::new(77).pixel(x, y, frame).draw_fx::<D>(0, 0).map(unit::to_f64)
}

/// A mask's frames: their mean loses RMS as that of independent ones, and keeps the blueness of one.
#[test]
fn sixteen_frames_of_masks() {
    fn check<const D: usize>(name: &str, integrands: &[Integrand<D>], limits: [f64; 2]) {
        let (mut one, mut mean) = ([0.0; 3], [0.0; 3]);
        for seed in 1..=4 {
            let sampler = Dithered::new(seed);
            let draw = |x: u32, y: u32, frame: u32| sampler.pixel(x, y, frame).draw_fx::<D>(0, 0).map(unit::to_f64);
            for (sum, frames) in [(&mut one, 0..1), (&mut mean, 0..16)] {
                sum.iter_mut().zip(error(integrands, frames, &draw)).for_each(|(sum, error)| *sum += error / 4.0);
            }
        }
        println!("{name}: one {one:.3?}, mean of 16 {mean:.3?}, of white's one");
        assert!(mean[0] <= limits[0] * one[0], "{name}: {mean:?} of {one:?}");
        assert!(mean[1] <= limits[1], "{name}: {mean:?}");
        assert!(mean[1] / mean[0] <= 1.15 * one[1] / one[0], "{name}: less blue than a frame: {mean:?}, {one:?}");
    }
    // Independent frames: .25.
    check("1D", &smooth_1d(), [0.26, 0.10]);
    check("2D smooth", &smooth_2d(), [0.26, 0.10]);
    check("half-planes", &half_planes(), [0.26, 0.15]);
}

/// The net: frames go on where the last one stopped, and each frame is as blue as the first.
#[test]
fn frames_of_the_net() {
    for (name, integrands) in [("smooth", smooth_2d()), ("half-planes", half_planes())] {
        let samplers =
            [("1 spp", Sampler::with_spp(5, 1)), ("2 spp", Sampler::with_spp(5, 2)), ("any", Sampler::new(5))];
        for (spp, sampler) in samplers {
            let draw = |x: u32, y: u32, frame: u32| sampler.pixel(x, y, frame).draw_fx::<2>(0, 0).map(unit::to_f64);
            let at = |frame: u32| error(&integrands, frame..frame + 1, &draw);
            let white = error(&integrands, 0..1, &white::<2>);
            let mean = |frames: &[u32], i: usize| {
                let sum: f64 = frames.iter().map(|&frame| at(frame)[i].powi(2)).sum();
                (sum / frames.len() as f64).sqrt()
            };
            // Early frames and late ones, odd ones and powers of two; the first two alone hold no order of frames.
            let (first, others) = (mean(&[0, 1], 1), mean(&[2, 3, 7, 64, 100, 1023, 1024, 30_000], 1));
            println!("{name}, {spp}: {first:.3} in the first frames, {others:.3} in others, white {:.3}", white[1]);
            assert!(others < 1.1 * first, "{name}, {spp}: {others} after {first}");
            // One sample of several is no worse than one alone, but not what is optimised.
            if spp != "2 spp" {
                assert!(others < 0.9 * white[1], "{name}, {spp}: {others}, white {}", white[1]);
                // Independent frames: .25.
                let all = error(&integrands, 0..16, &draw)[0];
                assert!(all <= 0.18 * mean(&[0, 1, 2, 3], 0), "{name}, {spp}: {all}");
            }
        }
    }
}

/// Ways to move a threshold mask from frame to frame, side by side; run with `--nocapture`.
///
/// Moving the place keeps each frame as it is, moving the values by the golden ratio takes half of its blueness and
/// averages better without a filter; masks over time average best of all, for a third more error of a single frame.
#[test]
fn ways_through_time() {
    let place = |x: u32, y: u32, frame: u32| Dithered::new(5).pixel(x, y, frame).draw_fx::<1>(0, 0).map(unit::to_f64);
    let golden = |x: u32, y: u32, frame: u32| {
        [unit::to_f64(THRESHOLD_64.value_fx(x, y).wrapping_add(frame.wrapping_mul(0x9e37_79b9)))]
    };
    let still = |x: u32, y: u32, _: u32| [unit::to_f64(THRESHOLD_64.value_fx(x, y))];
    let ways: &[(&str, Draw<1>)] = &[
        ("white", &white::<1>),
        ("still", &still),
        ("place", &place),
        ("golden", &golden),
        #[cfg(feature = "threshold-over-time-64")]
        ("mask over time", &|x, y, frame| {
            [unit::to_f64(bluedither::tables::THRESHOLD_OVER_TIME_64.frame(frame).value_fx(x, y))]
        }),
    ];
    println!("error over white's single frame, unfiltered / sigma 1.0 / sigma 2.1, mean of so many frames");
    let counts = [1, 2, 4, 8, 16, 64];
    let (mut found, mut averages) = (Vec::new(), Vec::new());
    for (name, draw) in ways {
        let errors: Vec<[f64; 3]> = counts.iter().map(|&count| error(&smooth_1d(), 3..3 + count, *draw)).collect();
        let average = exponential(*draw);
        averages.push(average);
        let text: Vec<String> =
            counts.iter().zip(&errors).map(|(n, [a, b, c])| format!("{n}: {a:.3}/{b:.3}/{c:.3}")).collect();
        println!("{name:15} {}  exponential .1: {:.3}/{:.3}", text.join("  "), average[0], average[1]);
        found.push(errors);
    }
    let (single, mean_16) = (|way: usize| found[way][0][1], |way: usize| found[way][4]);
    assert!((single(2) / single(1) - 1.0).abs() < 0.05, "moving the place keeps a frame as it is");
    assert!(single(3) > 1.2 * single(2), "moving values does not");
    assert!(mean_16(3)[0] < 0.6 * mean_16(2)[0], "but averages better");
    // A tenth of each new frame weighs as nineteen.
    let independent = (0.1f64 / 1.9).sqrt();
    assert!((averages[0][0] / independent - 1.0).abs() < 0.1, "white: {:?}", averages[0]);
    assert!(averages[2][0] < 1.15 * independent && averages[2][1] < 0.3 * independent, "place: {:?}", averages[2]);
    assert!(mean_16(2)[1] < 0.10, "place: {:?}", mean_16(2));
    assert!(found[2][5][0] < 0.6 * mean_16(2)[0], "frames do not come again: {:?}", found[2][5]);
    if let Some(over_time) = found.get(4) {
        assert!(over_time[0][1] < 1.6 * single(2), "a frame of a mask over time: {:?}", over_time[0]);
        assert!(over_time[4][0] < 0.5 * mean_16(2)[0] && over_time[4][1] < 0.6 * mean_16(2)[1], "{:?}", over_time[4]);
    }
}

/// The error of an exponential moving average, a tenth of each new frame, after 48 of them: unfiltered and at sigma 1.
fn exponential(draw: Draw<1>) -> [f64; 2] {
    let weight = |age: i32| 0.1 * 0.9f64.powi(age) / (1.0 - 0.9f64.powi(48));
    let average = |x, y| (0..48).map(|age: i32| weight(age) * draw(x, y, 100 - age.cast_unsigned())[0]).sum();
    let image = ErrorImage::new(SIZE, 0.5, average);
    let one = ErrorImage::new(SIZE, 0.5, |x, y| white::<1>(x, y, 0)[0]);
    [image.rms() / one.rms(), image.filtered_rms(SIGMAS[0]) / one.filtered_rms(SIGMAS[0])]
}
