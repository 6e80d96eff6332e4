//! What the mask samplers promise besides the call shape: tiles, nets, strata, passes.
//!
//! The masks are random permutations, so that these tests need no table.

use crate::analysis::random::Random;
use crate::common::{SIZE, scalar_mask, vector_mask};
use bluedither::lattice::{EXEW, extensible};
use bluedither::{Dithered, VectorMask, sobol, unit};
use proptest::prelude::*;

#[test]
fn global_undoes_stratified() {
    let dithered = Dithered::with_masks(scalar_mask(), vector_mask(), 1);
    let back = dithered.stratified(9).global();
    for index in [0, 1, 8, 9, 100] {
        let (a, b) = (dithered.pixel(3, 4, 5), back.pixel(3, 4, 5));
        assert_eq!(a.draw_fx::<3>(0, index), b.draw_fx::<3>(0, index));
        assert_eq!(a.draw_fx::<1>(0, index), b.draw_fx::<1>(0, index));
    }
}

/// Of a lattice pairs alone are others; each power of two of them is the lattice, moved by the mask.
#[test]
fn pairs_on_a_lattice_are_the_lattice_moved_by_the_mask() {
    let sorted = |mut points: Vec<[u32; 2]>| {
        points.sort_unstable();
        points
    };
    for (seed, domain, frame) in [(0, 0, 0), (1, 7, 2), (9, 100, u32::MAX)] {
        let sobol = Dithered::with_masks(scalar_mask(), vector_mask(), seed).pixel(3, 5, frame);
        let pixel = Dithered::with_masks(scalar_mask(), vector_mask(), seed).on_lattice().pixel(3, 5, frame);
        let [x, y] = pixel.draw_fx::<2>(domain, 0);
        assert_eq!(sobol.draw_fx(domain, 0), [x, y], "the first sample is the value of the mask");
        assert_eq!(sobol.draw_fx::<1>(domain, 9), pixel.draw_fx::<1>(domain, 9));
        for m in 0..=10 {
            let drawn = (0..1 << m).map(|i| pixel.draw_fx(domain, i)).collect();
            let moved = |i| [extensible(i, EXEW[0]).wrapping_add(x), extensible(i, EXEW[1]).wrapping_add(y)];
            assert_eq!(sorted(drawn), sorted((0..1 << m).map(moved).collect()), "the first 2^{m}");
        }
    }
}

#[test]
fn a_tile_repeats_and_negative_coordinates_go_on() {
    for sampler in [5, 6].map(|seed| Dithered::with_masks(scalar_mask(), vector_mask(), seed)) {
        for (x, y) in [(0i32, 0i32), (63, 1), (10, 62)] {
            let at = |x: i32, y: i32| sampler.pixel(x.cast_unsigned(), y.cast_unsigned(), 2).draw_fx::<4>(1, 1);
            for (right, down) in [(64, 0), (0, 64), (-64, -128), (64_000, -64), (i32::MIN, i32::MIN)] {
                assert_eq!(at(x, y), at(x.wrapping_add(right), y.wrapping_add(down)), "{x}+{right}, {y}+{down}");
            }
        }
    }
}

#[test]
fn a_global_offset_moves_all_points_alike() {
    // Sample 0 of the pattern is 0, so it shows the offset; taken off, the points are the same in every pixel, and
    // every 2ᵏ of them from the start are a net.
    let sampler = Dithered::with_masks(scalar_mask(), vector_mask(), 21);
    for (domain, frame) in [(0, 0), (1, 0), (0, 1), (77, 99)] {
        let points = |x, y| {
            let pixel = sampler.pixel(x, y, frame);
            let [u0, v0] = pixel.draw_fx::<2>(domain, 0);
            let [t0] = pixel.draw_fx::<1>(domain, 0);
            (0..256u32)
                .map(|i| {
                    let ([u, v], [t]) = (pixel.draw_fx::<2>(domain, i), pixel.draw_fx::<1>(domain, i));
                    [u.wrapping_sub(u0), v.wrapping_sub(v0), t.wrapping_sub(t0)]
                })
                .collect::<Vec<_>>()
        };
        let here = points(3, 4);
        assert_eq!(here, points(40, 7));
        for m in 0..=8u32 {
            for x_digits in 0..=m {
                let mut seen = vec![[false; 2]; 1 << m];
                for [u, v, t] in here.iter().take(1 << m).map(|point| point.map(u64::from)) {
                    let cell = (u >> (32 - x_digits)) << (m - x_digits) | v >> (32 - (m - x_digits));
                    seen[cell as usize][0] = true;
                    seen[(t >> (32 - m)) as usize][1] = true;
                }
                assert!(seen.iter().all(|hit| *hit == [true; 2]), "the first 2^{m}, 2^-{x_digits} wide");
            }
        }
    }
}

#[test]
fn strata_are_hit_once_a_pass_and_passes_fill_them() {
    for spp in [1u32, 2, 3, 4, 5, 7, 16, 25, 100] {
        let sampler = Dithered::with_masks(scalar_mask(), vector_mask(), 8).stratified(spp);
        for (x, y) in [(0, 0), (33, 12)] {
            let pixel = sampler.pixel(x, y, 1);
            // In 1D pass by pass; after four passes each quarter of each stratum, seen from the offset, is hit once.
            let mut quarters = vec![0; 4 * spp as usize];
            let offset = (u64::from(pixel.draw_fx::<1>(2, 0)[0]) * u64::from(spp)) as u32;
            for pass in 0..4 {
                let mut seen = vec![false; spp as usize];
                for index in pass * spp..(pass + 1) * spp {
                    let value = u64::from(pixel.draw_fx::<1>(2, index)[0]) * u64::from(spp);
                    // Rounding down may leave a point a hair below its place: move it up by half a unit of the last.
                    let value = value + u64::from(spp / 2);
                    seen[(value >> 32) as usize] = true;
                    let inside = (value as u32).wrapping_sub(offset).wrapping_add(1 << 29) >> 30;
                    quarters[(value >> 32) as usize * 4 + inside as usize] += 1;
                }
                assert!(seen.iter().all(|hit| *hit), "1D, {spp} spp, pass {pass}");
            }
            assert!(quarters.iter().all(|n| *n == 1), "1D, {spp} spp: {quarters:?}");
            // In 2D every pass has one point in each cell of area 1/spp.
            for pass in 0..3 {
                let mut seen = vec![false; spp as usize];
                for index in pass * spp..(pass + 1) * spp {
                    let [u, v] = pixel.draw_fx::<2>(2, index);
                    let cell = (0..spp).find(|&cell| {
                        let low = bluedither::strata::place_2d(cell, spp, [0, 0]);
                        let high = bluedither::strata::place_2d(cell, spp, [u32::MAX, u32::MAX]);
                        (low[0]..=high[0]).contains(&u) && (low[1]..=high[1]).contains(&v)
                    });
                    seen[cell.expect("cells fill the square") as usize] = true;
                }
                assert!(seen.iter().all(|hit| *hit), "2D, {spp} spp, pass {pass}");
            }
        }
    }
}

/// If cell a of one domain met cell b of another in every pixel, all pixels would have the same error.
#[test]
fn strata_of_two_domains_meet_in_every_way_over_the_pixels() {
    for spp in [4, 5] {
        let sampler = Dithered::with_masks(scalar_mask(), vector_mask(), 3).stratified(spp);
        let error = |p: u32| {
            let pixel = sampler.pixel(p % SIZE as u32, p / SIZE as u32, 0);
            let product = |index| {
                let [[a], [b]] = [0, 1].map(|domain| pixel.draw_fx::<1>(domain, index).map(unit::to_f64));
                a * b
            };
            (0..spp).map(product).sum::<f64>() / f64::from(spp) - 0.25
        };
        let errors: Vec<f64> = (0..(SIZE * SIZE) as u32).map(error).collect();
        let n = errors.len() as f64;
        let mean = errors.iter().sum::<f64>() / n;
        let deviation = (errors.iter().map(|e| (e - mean) * (e - mean)).sum::<f64>() / n).sqrt();
        assert!(mean.abs() < 4.0 * deviation / n.sqrt(), "{spp} spp: {mean} ± {}", deviation / n.sqrt());
    }
}

/// Past its `spp` a sampler goes on, and what it has drawn converges: domains, and pads, do not move in step.
#[test]
fn samples_beyond_spp_converge_jointly() {
    let count = 4096;
    for spp in [1, 2, 3, 4, 8] {
        for (name, squares) in [("strata", true), ("single strata", false)] {
            let mut worst: f64 = 0.0;
            for seed in 0..24 {
                let sampler = Dithered::with_masks(scalar_mask(), vector_mask(), seed);
                let sampler = if squares { sampler.stratified(spp) } else { sampler.stratified_1d(spp) };
                let pixel = sampler.pixel(seed * 7, seed * 13, 0);
                let (mut singles, mut pads) = (0.0, 0.0);
                for index in 0..count {
                    let [[a], [b]] = [0, 1].map(|domain| pixel.draw_fx::<1>(domain, index).map(unit::to_f64));
                    let four = pixel.draw_fx::<4>(2, index).map(unit::to_f64);
                    singles += a * b;
                    pads += four[0] * four[2];
                }
                worst = worst.max((singles / f64::from(count) - 0.25).abs());
                worst = worst.max((pads / f64::from(count) - 0.25).abs());
            }
            // 4096 independent samples scatter by .0034.
            assert!(worst < 0.012, "{name}, {spp} spp: {worst} off after {count} samples");
        }
    }
}

#[test]
fn padded_pairs_never_meet_the_first_pair() {
    for seed in 0..20_000 {
        let [a, b, c, d] = Dithered::with_masks(scalar_mask(), vector_mask(), seed).pixel(0, 0, 0).draw_fx::<4>(0, 0);
        assert!([a, b] != [c, d], "seed {seed}: components 2 and 3 repeat 0 and 1 in every pixel");
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, cases: 200, ..ProptestConfig::default() })]

    #[test]
    fn the_tile_repeats_everywhere(seed: u32, x: u32, y: u32, frame: u32, domain: u32, index: u32) {
        // But for the order of strata, which is every pixel's own.
        let sampler = Dithered::with_masks(scalar_mask(), vector_mask(), seed);
        let far = |pixel: u32| sampler.pixel(x.wrapping_add(pixel), y.wrapping_sub(pixel), frame);
        prop_assert_eq!(far(0).draw::<4>(domain, index), far(SIZE as u32).draw::<4>(domain, index));
    }
}

/// The mean over frames gets better like that of independent frames, long after every place of the mask was read:
/// smooth integrands and steps, one number and a pair. Before places came in rounds, 65,536 frames left twice as much.
#[test]
fn the_mean_over_frames_goes_on_converging() {
    // Each minus its mean, over its standard deviation.
    let square = |x: f64| (x * x - 1.0 / 3.0) / (4.0f64 / 45.0).sqrt();
    let step = |x: f64| (f64::from(u8::from(x < 0.3)) - 0.3) / 0.21f64.sqrt();
    let product = |x: f64, y: f64| (x * y - 0.25) / (7.0f64 / 144.0).sqrt();
    let half_plane = |x: f64, y: f64| 2.0 * f64::from(u8::from(x + y < 1.0)) - 1.0;
    let pixels: Vec<[u32; 2]> = (0..32).map(|p| [p * 37 % 61, p * 11 % 59]).collect();
    // As baked masks, a net: of one that is not, no mean could be better than its own.
    let mut ranks: Vec<[u16; 2]> = (0..4096).map(|i| sobol::point(i).map(|v| (v >> 20) as u16)).collect();
    Random::new(6).shuffle(&mut ranks);
    let net = VectorMask::from_slice(&ranks).expect("ranks of a mask");
    let mut squares = [[0.0; 4]; 9];
    const SEEDS: u32 = 4;
    for seed in 0..SEEDS {
        let sampler = Dithered::with_masks(scalar_mask(), &net, seed);
        for &[x, y] in &pixels {
            let mut sums = [0.0; 4];
            for frame in 0..1 << 16 {
                let pixel = sampler.pixel(x, y, frame);
                let ([t], [u, v]) =
                    (pixel.draw_fx::<1>(0, 0).map(unit::to_f64), pixel.draw_fx::<2>(1, 0).map(unit::to_f64));
                let values = [square(t), step(t), product(u, v), half_plane(u, v)];
                sums.iter_mut().zip(values).for_each(|(sum, value)| *sum += value);
                let frames = frame + 1;
                if frames.is_power_of_two() && frames.ilog2() % 2 == 0 {
                    let at = &mut squares[frames.ilog2() as usize / 2];
                    at.iter_mut().zip(sums).for_each(|(at, sum)| *at += sum * sum / f64::from(frames));
                }
            }
        }
    }
    for (k, squares) in squares.iter().enumerate() {
        let ratios = squares.map(|square| (square / f64::from(SEEDS) / pixels.len() as f64).sqrt());
        assert!(ratios.iter().all(|&ratio| ratio < 1.3), "{} frames: {ratios:.2?} of independent ones", 1 << (2 * k));
    }
}

/// A round flips digits of all pixels alike, of the upper nine all or none: each rank stands once, near values stay
/// near, and every frame alone is as blue as the mask. The first round flips nothing.
#[test]
fn every_frame_has_the_order_of_the_mask_or_the_other() {
    let mut turned = 0;
    for (seed, frame) in (0..60).map(|k| (k, 4000 + 199 * k)) {
        let sampler = Dithered::with_masks(scalar_mask(), vector_mask(), seed);
        let value = |p: u32| sampler.pixel(p % 64, p / 64, frame).draw_fx::<1>(3, 0)[0];
        let flips = |place: u32, p: u32| value(p) ^ scalar_mask().value_fx(p % 64 + place % 64, p / 64 + place / 64);
        let fits = |place: &u32| (1..4096).all(|p| flips(*place, p) == flips(*place, 0));
        let place = (0..4096).find(fits).expect("one flip for all, somewhere");
        let flips = flips(place, 0);
        assert!([0, 0xff].contains(&(flips >> 24)), "frame {frame}: {flips:x}");
        if frame < 4096 {
            let [dx, dy] = bluedither::torus::offset(seed, 3, 0, frame, 6);
            assert_eq!((flips, place), (0, dy << 6 | dx));
        }
        turned += flips >> 31;
    }
    assert!((15..45).contains(&turned), "{turned} of 60 are turned over");
}
