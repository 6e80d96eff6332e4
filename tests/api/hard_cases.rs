//! Numerical hard cases of every sampler: the ends of every argument's range, many samples, awkward integrands.
//!
//! Those of single functions stand with their other tests: offsets in `shift.rs`, conversion to floats in `unit.rs`, a
//! mask's far corner in `mask.rs`, floats that are no numbers in `warp.rs`, a billion points of a sequence in
//! `lattice.rs`, and the optimisers' and those of constant integrands in `published_energy.rs`, `anneal.rs` and
//! `void_and_cluster.rs` of `tests/bake`. That no sampler returns 1.0 follows from `unit.rs` and is seen in
//! `call_shape.rs`.

use crate::analysis::error::ErrorImage;
use crate::common::{NO_CORRELATION, SIZE, correlation, for_every_sampler, image};
use bluedither::{White, unit};
use core::f64::consts::{PI, TAU};

#[test]
fn points_differ_at_both_ends_of_any_number_of_samples() {
    // One and two numbers: with N strata every sample has a cell of its own, else the sequence is a bijection.
    for spp in [1, 2, 3, 7, 12, 100, 1000, 1 << 31, u32::MAX] {
        let near = |middle: u32| (0..16).map(move |k| middle.saturating_sub(8).saturating_add(k));
        let mut indices: Vec<u32> = near(0).chain(near(spp / 2)).chain(near(spp)).filter(|&i| i < spp).collect();
        indices.extend((0..1 << 12).map(|k| k << 20).filter(|&i| i < spp));
        indices.sort_unstable();
        indices.dedup();
        for_every_sampler!(9, spp, |name, sampler| {
            let pixel = sampler.pixel(70, 3, 1);
            let mut singles: Vec<[u32; 1]> = indices.iter().map(|&index| pixel.draw_fx(2, index)).collect();
            let mut pairs: Vec<[u32; 2]> = indices.iter().map(|&index| pixel.draw_fx(2, index)).collect();
            singles.sort_unstable();
            singles.dedup();
            pairs.sort_unstable();
            pairs.dedup();
            assert_eq!((singles.len(), pairs.len()), (indices.len(), indices.len()), "{name}: of {spp} samples");
        });
    }
}

/// The filtered error of x + y by one sample over 64² pixels around a corner of four blocks of the plane.
fn filtered_error(corner: [u32; 2], draw: impl Fn(u32, u32, u32) -> [u32; 2]) -> f64 {
    let half = SIZE as u32 / 2;
    let square = |seed: u32| {
        let at = |x: u32, y: u32| {
            draw(seed, corner[0].wrapping_sub(half).wrapping_add(x), corner[1].wrapping_sub(half).wrapping_add(y))
        };
        let image = ErrorImage::new(SIZE, 1.0, |x, y| at(x, y).map(unit::to_f64).iter().sum());
        image.filtered_rms(1.0).powi(2)
    };
    (0..8).map(square).sum::<f64>().sqrt()
}

/// Where coordinates jump: −1 to 0, which is the end of `u32` too; the end of `i32`; the end of 16 bits.
const SEAMS: [[u32; 2]; 7] =
    [[0, 0], [0, 5000], [1 << 31, 5000], [5000, 1 << 31], [1 << 31, 1 << 31], [0, 1 << 31], [1 << 16, 1 << 16]];

#[test]
fn blueness_goes_on_over_the_ends_of_i32_and_u32() {
    for_every_sampler!(0, 1, |name, _first| {
        let error = |corner| {
            filtered_error(corner, |seed, x, y| {
                let mut drawn = [0; 2];
                for_every_sampler!(seed, 1, |other, sampler| {
                    if other == name {
                        drawn = sampler.pixel(x, y, 0).draw_fx(0, 0);
                    }
                });
                drawn
            })
        };
        let inside = error([5000, 5000]);
        for seam in SEAMS {
            let ratio = error(seam) / inside;
            assert!((0.8..1.25).contains(&ratio), "{name} at {seam:?}: {ratio} times the error elsewhere");
        }
    });
    // What a sampler without negative numbers would do.
    let clamped = |corner| {
        filtered_error(corner, |seed, x, y| White::new(seed).pixel(x.min(i32::MAX.cast_unsigned()), y, 0).draw_fx(0, 0))
    };
    assert!(clamped([1 << 31, 5000]) > 1.25 * clamped([5000, 5000]));
}

#[test]
fn seeds_frames_and_domains_of_nothing_and_all_ones_are_even_and_unrelated() {
    const ENDS: [u32; 3] = [0, 1, u32::MAX];
    let arguments = ENDS.into_iter().flat_map(|a| ENDS.into_iter().flat_map(move |b| ENDS.map(|c| [a, b, c])));
    let arguments: Vec<[u32; 3]> = arguments.collect();
    // By name: the images of one number, far apart.
    let mut images: Vec<(&str, Vec<Vec<f64>>)> = Vec::new();
    for &[seed, frame, domain] in &arguments {
        for_every_sampler!(seed, 4, |name, sampler| {
            let at = |x: u32, y: u32| sampler.pixel(33 * x, 33 * y, frame).draw_fx::<2>(domain, 0)[0];
            match images.iter_mut().find(|(known, _)| *known == name) {
                Some((_, all)) => all.push(image(SIZE, at)),
                None => images.push((name, vec![image(SIZE, at)])),
            }
        });
    }
    for (name, images) in images {
        assert_eq!(images.len(), arguments.len(), "{name}");
        for (a, one) in images.iter().enumerate() {
            // 4096 numbers in 64 bins: chi² of 63 degrees of freedom is 63 ± 11; that of a mask is 0.
            let mut count = [0u32; 64];
            one.iter().for_each(|v| count[(v * 64.0) as usize] += 1);
            let chi2: f64 = count.iter().map(|&n| (f64::from(n) - 64.0).powi(2) / 64.0).sum();
            assert!(chi2 < 130.0, "{name}, {:?}: {chi2}", arguments[a]);
            for (b, other) in images[..a].iter().enumerate() {
                let (a, b) = (arguments[a], arguments[b]);
                assert_ne!(one, other, "{name}: {a:?} and {b:?}");
                // Frames of the net complete each other.
                let complete = name.starts_with("net") && (a[0], a[2]) == (b[0], b[2]);
                if !complete {
                    // The baked masks are blue noise, whose neighbours are related a little.
                    let bound = if name.starts_with("baked") { 2.0 * NO_CORRELATION } else { NO_CORRELATION };
                    let r = correlation(one, other);
                    assert!(r.abs() < bound, "{name}: {a:?} and {b:?}: {r}");
                }
            }
        }
    }
}

/// Sums 2^`log2` single numbers from `first` on, a multiple of that: each lies in an interval of 2^−log2 of its own, so
/// the mean is one half but for that much, and the interval that an offset cuts in two.
fn assert_no_drift(first: u32, log2: u32) {
    const RUN: usize = 1 << 12;
    for_every_sampler!(3, 4, |name, sampler| {
        let pixel = sampler.pixel(11, 12, 1);
        let (mut sum, mut numbers) = (0u64, [[0; 1]; RUN]);
        for start in (0..1u32 << log2).step_by(RUN) {
            pixel.fill_fx(5, first + start, &mut numbers);
            sum += numbers.iter().map(|[v]| u64::from(*v)).sum::<u64>();
        }
        let off = sum.abs_diff(1 << (31 + log2)) as f64 / 4_294_967_296.0;
        // Numbers of the net have 16 digits, and a random rest for 2¹⁶ of them: five deviations.
        let sequences = f64::from(1u32 << log2.saturating_sub(16));
        let bound = if name.starts_with("net") { 2.0 + 5.0 * (sequences / 12.0).sqrt() } else { 2.0 };
        assert!(off <= bound, "{name}, 2^{log2} numbers from {first} on: the sum is {off} off");
    });
}

#[test]
fn sums_of_late_numbers_do_not_drift() {
    for block in [0, 953, 4095] {
        assert_no_drift(block << 20, 20);
    }
}

/// `cargo test --release --test api hard_cases:: -- --ignored`: a minute.
#[test]
#[ignore = "a billion draws of every sampler"]
fn sums_of_a_billion_numbers_do_not_drift() {
    assert_no_drift(0, 30);
}

/// Name, exact value, function, and the largest error over that of as many independent points.
type Hard = (&'static str, f64, fn(f64, f64) -> f64, f64);
const HARD: [Hard; 5] = [
    ("discontinuous along an axis", 1.0 / PI, |x, _| f64::from(u8::from(x < 1.0 / PI)), 0.5),
    ("discontinuous along a circle", 0.5, |x, y| f64::from(u8::from(x * x + y * y < 2.0 / PI)), 0.8),
    // By 2²⁴ Sobol points.
    ("sin π/r, singular at the corner", -0.220_242, |x, y| (PI / x.hypot(y).max(1e-9)).sin(), 0.8),
    ("x^−¼, a pole", 4.0 / 3.0, |x, _| x.max(1e-12).powf(-0.25), 0.8),
    // Far above what 64 points resolve: as good as any.
    ("oscillating", 0.0, |x, y| (TAU * (311.0 * x + 173.0 * y)).cos(), 1.8),
];

#[test]
fn hard_integrands_are_unbiased_and_no_worse_than_by_independent_points() {
    const SEEDS: u32 = 512;
    const COUNT: u32 = 64;
    let mut errors: Vec<(&str, Vec<[f64; HARD.len()]>)> = Vec::new();
    for seed in 0..SEEDS {
        for_every_sampler!(seed, COUNT, |name, sampler| {
            let pixel = sampler.pixel(17, 40, 3);
            let mut sums = [0.0; HARD.len()];
            for index in 0..COUNT {
                let [x, y] = pixel.draw_fx::<2>(1, index).map(unit::to_f64);
                HARD.iter().zip(&mut sums).for_each(|((_, exact, f, _), sum)| *sum += f(x, y) - exact);
            }
            let found = sums.map(|sum| sum / f64::from(COUNT));
            match errors.iter_mut().find(|(known, _)| *known == name) {
                Some((_, all)) => all.push(found),
                None => errors.push((name, vec![found])),
            }
        });
    }
    for (k, (integrand, exact, f, bound)) in HARD.into_iter().enumerate() {
        // The error of as many independent points, by the variance on a grid of centres.
        let centre = |k: u32| (f64::from(k) + 0.5) / 1024.0;
        let square = |k: u32| (f(centre(k % 1024), centre(k / 1024)) - exact).powi(2);
        let independent = ((0..1 << 20).map(square).sum::<f64>() / f64::from(1 << 20) / f64::from(COUNT)).sqrt();
        for (name, errors) in &errors {
            let n = f64::from(SEEDS);
            let mean = errors.iter().map(|e| e[k]).sum::<f64>() / n;
            let rms = (errors.iter().map(|e| e[k] * e[k]).sum::<f64>() / n).sqrt();
            assert!(mean.abs() < 4.0 * rms / n.sqrt() + 1e-6, "{name}, {integrand}: {mean} ± {}", rms / n.sqrt());
            // 8×8 cells moved alike have their points in 8 columns.
            let bound = if *name == "strata" { 3.0 * bound } else { bound };
            assert!(rms < bound * independent, "{name}, {integrand}: {} of independent points", rms / independent);
        }
    }
}
