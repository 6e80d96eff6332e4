//! The call shape and what every sampler promises: one definition, prefixes, strata, decorrelation, no bias.
//!
//! The masks are random permutations made here, so that these tests need no table; those of the baked masks follow
//! behind their features.
#![allow(clippy::cast_possible_truncation, reason = "sizes of small loops")]

mod analysis;

use analysis::random::Random;
use bluedither::{Constant, Dithered, ScalarMask, VectorMask, White, sobol, unit};
use proptest::prelude::*;

const SIZE: usize = 64;
const EXTREMES: [u32; 5] = [0, 1, 0x7fff_ffff, 0x8000_0000, u32::MAX];

fn scalar_mask() -> ScalarMask<SIZE> {
    let mut ranks: Vec<u16> = (0..4096).collect();
    Random::new(11).shuffle(&mut ranks);
    ScalarMask::new(core::array::from_fn(|y| core::array::from_fn(|x| ranks[y * SIZE + x])))
}

fn vector_mask() -> VectorMask<2, SIZE> {
    let mut pairs: Vec<[u16; 2]> = (0..4096).map(|i| sobol::point(i).map(|v| (v >> 20) as u16)).collect();
    Random::new(12).shuffle(&mut pairs);
    VectorMask::new(core::array::from_fn(|y| core::array::from_fn(|x| pairs[y * SIZE + x])))
}

/// Calls `$body` with `$sampler` bound to each sampler of this crate, made from `$seed`; `$name` is its name.
macro_rules! for_every_sampler {
    ($seed:expr, |$name:ident, $sampler:ident| $body:block) => {{
        let (scalar, vector) = (scalar_mask(), vector_mask());
        let dithered = Dithered::with_masks(&scalar, &vector, $seed);
        for_every_sampler!(@one "white", White::new($seed), $name, $sampler, $body);
        for_every_sampler!(@one "constant", Constant::new($seed), $name, $sampler, $body);
        for_every_sampler!(@one "global", dithered, $name, $sampler, $body);
        for_every_sampler!(@one "4 strata", dithered.stratified(4), $name, $sampler, $body);
        for_every_sampler!(@one "7 strata", dithered.stratified(7), $name, $sampler, $body);
        for_every_sampler!(@one "2³²-1 strata", dithered.stratified(u32::MAX), $name, $sampler, $body);
        for_every_sampler!(@baked $seed, $name, $sampler, $body);
    }};
    (@baked $seed:expr, $name:ident, $sampler:ident, $body:block) => {
        #[cfg(all(feature = "threshold-64", feature = "offset-2d-64"))]
        {
            for_every_sampler!(@one "baked", Dithered::new($seed), $name, $sampler, $body);
            for_every_sampler!(@one "baked, 5 spp", Dithered::with_spp($seed, 5), $name, $sampler, $body);
        }
    };
    (@one $text:expr, $made:expr, $name:ident, $sampler:ident, $body:block) => {{
        let ($name, $sampler) = ($text, $made);
        $body
    }};
}

/// Pearson's correlation.
fn correlation(a: &[f64], b: &[f64]) -> f64 {
    let mean = |v: &[f64]| v.iter().sum::<f64>() / v.len() as f64;
    let (ma, mb) = (mean(a), mean(b));
    let product: f64 = a.iter().zip(b).map(|(x, y)| (x - ma) * (y - mb)).sum();
    let square = |v: &[f64], m: f64| v.iter().map(|x| (x - m) * (x - m)).sum::<f64>();
    product / (square(a, ma) * square(b, mb)).sqrt()
}

/// One number of every pixel of a tile.
fn image(value: impl Fn(u32, u32) -> u32) -> Vec<f64> {
    let size = SIZE as u32;
    (0..size * size).map(|p| unit::to_f64(value(p % size, p / size))).collect()
}

/// Correlations over 64² pixels of independent numbers scatter by 1/64; five times that never happens.
const NO_CORRELATION: f64 = 0.08;

#[test]
fn draws_of_every_length_agree() {
    for_every_sampler!(3, |name, sampler| {
        for (x, y, frame, domain, index) in [(0, 0, 0, 0, 0), (5, 9, 2, 3, 1), (70, 64, 1, 0, 6), (1, 2, 3, 4, 100)] {
            let pixel = sampler.pixel(x, y, frame);
            let four = pixel.draw_fx::<4>(domain, index);
            assert_eq!(pixel.draw_fx::<2>(domain, index), four[..2], "{name}");
            assert_eq!(pixel.draw_fx::<3>(domain, index)[..2], four[..2], "{name}");
            assert_eq!(pixel.draw::<1>(domain, index), unit::to_f32s(pixel.draw_fx::<1>(domain, index)), "{name}");
            assert_eq!(pixel.draw::<2>(domain, index), unit::to_f32s(pixel.draw_fx::<2>(domain, index)), "{name}");
            assert_eq!(pixel.draw::<3>(domain, index), unit::to_f32s(pixel.draw_fx::<3>(domain, index)), "{name}");
            assert_eq!(pixel.draw::<4>(domain, index), unit::to_f32s(four), "{name}");
        }
    });
}

#[test]
fn every_argument_is_defined() {
    for seed in EXTREMES {
        for_every_sampler!(seed, |name, sampler| {
            for a in EXTREMES {
                for b in EXTREMES {
                    for c in EXTREMES {
                        // Each argument meets each extreme beside each of the others.
                        for [x, frame, domain, index] in [[a, b, c, a], [a, b, a, c], [b, a, c, c], [c, b, b, a]] {
                            let pixel = sampler.pixel(x, frame ^ a, frame);
                            let all = pixel.draw::<4>(domain, index);
                            assert!(all.iter().all(|v| (0.0..1.0).contains(v)), "{name}: {all:?}");
                            assert!((0.0..1.0).contains(&pixel.draw::<1>(domain, index)[0]), "{name}");
                            assert!((0.0..1.0).contains(&pixel.draw::<3>(domain, index)[2]), "{name}");
                        }
                    }
                }
            }
        });
    }
}

#[test]
fn no_samples_per_pixel_count_as_one() {
    let (scalar, vector) = (scalar_mask(), vector_mask());
    let dithered = Dithered::with_masks(&scalar, &vector, 1);
    let (none, one) = (dithered.stratified(0), dithered.stratified(1));
    for index in [0, 1, 2, 100, u32::MAX] {
        let (a, b) = (none.pixel(3, 4, 5), one.pixel(3, 4, 5));
        assert_eq!(a.draw_fx::<4>(6, index), b.draw_fx::<4>(6, index));
        assert_eq!(a.draw_fx::<1>(6, index), b.draw_fx::<1>(6, index));
        let (a, b) = (White::with_spp(1, 0).pixel(3, 4, 5), White::with_spp(1, 1).pixel(3, 4, 5));
        assert_eq!(a.draw_fx::<4>(6, index), b.draw_fx::<4>(6, index));
    }
    #[cfg(all(feature = "threshold-64", feature = "offset-2d-64"))]
    for index in [0, 1, u32::MAX] {
        let (a, b) = (Dithered::with_spp(1, 0).pixel(3, 4, 5), Dithered::with_spp(1, 1).pixel(3, 4, 5));
        assert_eq!(a.draw_fx::<4>(6, index), b.draw_fx::<4>(6, index));
        assert_eq!(a.draw_fx::<1>(6, index), b.draw_fx::<1>(6, index));
    }
}

#[test]
fn global_undoes_stratified() {
    let (scalar, vector) = (scalar_mask(), vector_mask());
    let dithered = Dithered::with_masks(&scalar, &vector, 1);
    let back = dithered.stratified(9).global();
    for index in [0, 1, 8, 9, 100] {
        let (a, b) = (dithered.pixel(3, 4, 5), back.pixel(3, 4, 5));
        assert_eq!(a.draw_fx::<3>(0, index), b.draw_fx::<3>(0, index));
        assert_eq!(a.draw_fx::<1>(0, index), b.draw_fx::<1>(0, index));
    }
}

/// If cell a of one domain met cell b of another in every pixel, all pixels would have the same error.
#[test]
fn strata_of_two_domains_meet_in_every_way_over_the_pixels() {
    let (scalar, vector) = (scalar_mask(), vector_mask());
    for spp in [4, 5] {
        let sampler = Dithered::with_masks(&scalar, &vector, 3).stratified(spp);
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
    let (scalar, vector) = (scalar_mask(), vector_mask());
    let count = 4096;
    for spp in [1, 2, 3, 4, 8] {
        for (name, squares) in [("strata", true), ("single strata", false)] {
            let mut worst: f64 = 0.0;
            for seed in 0..24 {
                let sampler = Dithered::with_masks(&scalar, &vector, seed);
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
fn a_tile_repeats_and_negative_coordinates_go_on() {
    let (scalar, vector) = (scalar_mask(), vector_mask());
    for sampler in [5, 6].map(|seed| Dithered::with_masks(&scalar, &vector, seed)) {
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
    let (scalar, vector) = (scalar_mask(), vector_mask());
    let sampler = Dithered::with_masks(&scalar, &vector, 21);
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
fn white_points_are_nets_of_their_own() {
    for (x, y) in [(0, 0), (1, 0), (u32::MAX, 5)] {
        let pixel = White::new(4).pixel(x, y, 2);
        for m in 0..=8u32 {
            for x_digits in 0..=m {
                let mut seen = vec![false; 1 << m];
                for index in 0..1 << m {
                    let [u, v] = pixel.draw_fx::<2>(3, index).map(u64::from);
                    seen[((u >> (32 - x_digits)) << (m - x_digits) | v >> (32 - (m - x_digits))) as usize] = true;
                }
                assert!(seen.iter().all(|hit| *hit), "the first 2^{m}, 2^-{x_digits} wide");
            }
        }
    }
}

#[test]
fn strata_are_hit_once_a_pass_and_passes_fill_them() {
    let (scalar, vector) = (scalar_mask(), vector_mask());
    for spp in [1u32, 2, 3, 4, 5, 7, 16, 25, 100] {
        let sampler = Dithered::with_masks(&scalar, &vector, 8).stratified(spp);
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

#[test]
fn domains_frames_and_components_are_decorrelated() {
    for_every_sampler!(2, |name, sampler| {
        if name != "constant" {
            // The baked masks are blue noise, whose neighbours a few pixels apart are related a little.
            let bound = if name.starts_with("baked") { 2.0 * NO_CORRELATION } else { NO_CORRELATION };
            let at = |domain, frame| image(|x, y| sampler.pixel(x, y, frame).draw_fx::<2>(domain, 0)[0]);
            let single = |domain, frame| image(|x, y| sampler.pixel(x, y, frame).draw_fx::<1>(domain, 0)[0]);
            let (pair_here, single_here) = (at(0, 0), single(0, 0));
            for k in 1..=16 {
                for (what, other) in [("domain", (k, 0)), ("frame", (0, k))] {
                    let r = correlation(&pair_here, &at(other.0, other.1));
                    assert!(r.abs() < bound, "{name}, pair, {what} {k}: {r}");
                    let r = correlation(&single_here, &single(other.0, other.1));
                    assert!(r.abs() < bound, "{name}, single, {what} {k}: {r}");
                }
            }
            let component = |k: usize| image(|x, y| sampler.pixel(x, y, 0).draw_fx::<4>(0, 0)[k]);
            for a in 1..4 {
                for b in 0..a {
                    let r = correlation(&component(a), &component(b));
                    assert!(r.abs() < bound, "{name}, components {a} and {b}: {r}");
                }
            }
        }
    });
}

#[test]
fn samples_of_one_pixel_are_decorrelated() {
    // Over the samples of one pixel, two domains, two frames or two components of a draw must fill their joint square:
    // two Owen scrambles of one sequence in one order would fill two quarters of it, in every pixel alike.
    for_every_sampler!(2, |name, sampler| {
        for spp in [64u32, 100, 256] {
            if name.ends_with("spp") || name.ends_with("strata") {
                continue; // of other counts
            }
            assert_no_joint_structure(name, spp, |frame, domain, index| {
                let pixel = sampler.pixel(1, 2, frame);
                (pixel.draw_fx::<1>(domain, index), pixel.draw_fx::<4>(domain, index))
            });
        }
    });
    let (scalar, vector) = (scalar_mask(), vector_mask());
    for spp in [64u32, 100, 256] {
        let sampler = Dithered::with_masks(&scalar, &vector, 2).stratified(spp);
        assert_no_joint_structure("stratified", spp, |frame, domain, index| {
            let pixel = sampler.pixel(1, 2, frame);
            (pixel.draw_fx::<1>(domain, index), pixel.draw_fx::<4>(domain, index))
        });
    }
}

/// The mean square correlation of pairs of series is what random orders have, 1/(n−1), or little more.
fn assert_no_joint_structure(name: &str, spp: u32, draw: impl Fn(u32, u32, u32) -> ([u32; 1], [u32; 4])) {
    let series = |frame, domain| -> [Vec<f64>; 5] {
        let all: Vec<_> = (0..spp).map(|index| draw(frame, domain, index)).collect();
        core::array::from_fn(|k| {
            all.iter().map(|(single, four)| unit::to_f64(if k == 4 { single[0] } else { four[k] })).collect()
        })
    };
    let here = series(0, 0);
    let mut squares = [0.0; 7];
    const OTHERS: u32 = 48;
    for k in 1..=OTHERS {
        let (domain, frame) = (series(0, k), series(k, 0));
        let pairs = [
            (&here[0], &domain[0]),
            (&here[1], &domain[1]),
            (&here[4], &domain[4]),
            (&here[0], &frame[0]),
            (&here[4], &frame[4]),
            (&domain[0], &domain[2]),
            (&domain[1], &domain[3]),
        ];
        pairs.iter().zip(&mut squares).for_each(|((a, b), sum)| *sum += correlation(a, b).powi(2) / f64::from(OTHERS));
    }
    let worst = squares.iter().fold(0.0, |worst: f64, &square| worst.max(square)) * f64::from(spp - 1);
    assert!(worst < 4.0, "{name}, {spp} samples: mean square correlations {squares:.3?}");
}

#[test]
fn padded_pairs_never_meet_the_first_pair() {
    let (scalar, vector) = (scalar_mask(), vector_mask());
    for seed in 0..20_000 {
        let [a, b, c, d] = Dithered::with_masks(&scalar, &vector, seed).pixel(0, 0, 0).draw_fx::<4>(0, 0);
        assert!([a, b] != [c, d], "seed {seed}: components 2 and 3 repeat 0 and 1 in every pixel");
    }
}

#[test]
fn white_is_uncorrelated_between_pixels_and_uniform() {
    let sampler = White::new(5);
    let size = SIZE as u32;
    let here = image(|x, y| sampler.pixel(x, y, 0).draw_fx::<1>(0, 0)[0]);
    for (right, down) in [(1, 0), (0, 1), (1, 1), (2, 0), (64, 0), (0, 64), (5, 7)] {
        let there = image(|x, y| sampler.pixel(x + right, y + down, 0).draw_fx::<1>(0, 0)[0]);
        let r = correlation(&here, &there);
        assert!(r.abs() < NO_CORRELATION, "{right}, {down}: {r}");
    }
    // 4096 pixels in 64 bins: chi² of 63 degrees of freedom is 63 ± 11.
    let mut count = [0u32; 64];
    here.iter().for_each(|v| count[(v * 64.0) as usize] += 1);
    let expected = f64::from(size * size) / 64.0;
    let chi2: f64 = count.iter().map(|&n| (f64::from(n) - expected).powi(2) / expected).sum();
    assert!((30.0..120.0).contains(&chi2), "{chi2}");
}

#[test]
fn constant_is_the_same_everywhere() {
    for (frame, domain, index) in [(0, 0, 0), (1, 2, 3), (u32::MAX, u32::MAX, u32::MAX)] {
        let here = Constant::new(6).pixel(0, 0, frame).draw_fx::<4>(domain, index);
        for (x, y) in [(1, 0), (0, 1), (1000, 77), (u32::MAX, u32::MAX)] {
            assert_eq!(Constant::with_spp(6, 9).pixel(x, y, frame).draw_fx::<4>(domain, index), here);
        }
        assert_ne!(Constant::new(7).pixel(0, 0, frame).draw_fx::<4>(domain, index), here);
        assert_ne!(Constant::new(6).pixel(0, 0, frame ^ 1).draw_fx::<4>(domain, index), here);
    }
}

#[test]
fn the_mean_over_seeds_is_right() {
    // x² in one dimension, xy in two and the product of all four: by all samples of a pass, by the first ones alone,
    // and by those after the pass. Within four standard errors.
    const ROUNDS: u32 = 1024;
    for spp in [1u32, 3, 4] {
        for (from, to) in [(0, spp), (0, 1), (spp, spp + 1)] {
            let mut sums: Vec<(&str, [[f64; 2]; 3])> = Vec::new();
            let (scalar, vector) = (scalar_mask(), vector_mask());
            let mut add = |name: &'static str, estimates: [f64; 3]| {
                let at = sums.iter().position(|(known, _)| *known == name).unwrap_or_else(|| {
                    sums.push((name, [[0.0; 2]; 3]));
                    sums.len() - 1
                });
                for (sum, e) in sums[at].1.iter_mut().zip(estimates) {
                    *sum = [sum[0] + e, sum[1] + e * e];
                }
            };
            macro_rules! estimate {
                ($name:expr, $sampler:expr) => {{
                    let pixel = $sampler.pixel(17, 40, 3);
                    let mut mean = [0.0; 3];
                    for index in from..to {
                        let [x] = pixel.draw_fx::<1>(2, index).map(unit::to_f64);
                        let [a, b, c, d] = pixel.draw_fx::<4>(2, index).map(unit::to_f64);
                        let weight = f64::from(to - from).recip();
                        [x * x, a * b, a * b * c * d].iter().zip(&mut mean).for_each(|(v, m)| *m += v * weight);
                    }
                    add($name, mean);
                }};
            }
            for seed in 0..ROUNDS {
                let dithered = Dithered::with_masks(&scalar, &vector, seed);
                estimate!("white", White::with_spp(seed, spp));
                estimate!("constant", Constant::with_spp(seed, spp));
                estimate!("global", dithered);
                estimate!("stratified", dithered.stratified(spp));
                #[cfg(all(feature = "threshold-64", feature = "offset-2d-64"))]
                estimate!("baked", Dithered::with_spp(seed, spp));
            }
            for (name, families) in sums {
                for ([sum, squares], exact) in families.into_iter().zip([1.0 / 3.0, 0.25, 1.0 / 16.0]) {
                    let n = f64::from(ROUNDS);
                    let mean = sum / n;
                    let error = ((squares / n - mean * mean).max(0.0) / n).sqrt();
                    // A stratified pass may hit the exact value; a mask's centres are 2⁻²⁶ off at most.
                    let off = (mean - exact).abs();
                    assert!(off < 4.0 * error + 1e-7, "{name}, {from}..{to} of {spp}: {mean} ± {error} for {exact}");
                }
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, cases: 200, ..ProptestConfig::default() })]

    #[test]
    fn draws_are_pure_and_below_one(seed: u32, x: u32, y: u32, frame: u32, domain: u32, index: u32, spp: u32) {
        let (scalar, vector) = (scalar_mask(), vector_mask());
        let sampler = Dithered::with_masks(&scalar, &vector, seed).stratified(spp);
        let pixel = sampler.pixel(x, y, frame);
        let all = pixel.draw::<4>(domain, index);
        prop_assert!(all.iter().all(|v| (0.0..1.0).contains(v)));
        // Asked again, of a copy, after another question.
        let copy = pixel;
        _ = pixel.draw::<3>(domain ^ 1, index ^ 1);
        prop_assert_eq!(copy.draw::<4>(domain, index), all);
        // The tile repeats, but for the order of strata, which is every pixel's own.
        let far = |pixel: u32| sampler.global().pixel(x.wrapping_add(pixel), y.wrapping_sub(pixel), frame);
        prop_assert_eq!(far(0).draw::<4>(domain, index), far(SIZE as u32).draw::<4>(domain, index));
    }
}
