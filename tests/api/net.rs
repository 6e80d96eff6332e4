//! The joint net: a naive twin, nets in every pixel for every power of two and over frames, domains apart.

use crate::analysis::net::assert_net;
use crate::common::{EXTREMES, correlation, image};
use bluedither::net::{self, Digits};
use bluedither::sampler::SamplerPixel;
use bluedither::tables::NET;
use bluedither::{Sampler, unit};
use proptest::prelude::*;

/// Numbers of samples that have an order of their own.
const KNOWN: [u32; 8] = [1, 2, 4, 8, 16, 32, 64, 256];

/// The points of an own pair.
fn points(pixel: SamplerPixel, domain: u32, indices: impl Iterator<Item = u32>, pair: usize) -> Vec<[u32; 2]> {
    indices.map(|index| pixel.draw_fx::<8>(domain, index)).map(|all| [all[2 * pair], all[2 * pair + 1]]).collect()
}

#[test]
fn every_aligned_run_of_every_own_pair_is_a_net() {
    let samplers =
        KNOWN.map(|spp| Sampler::with_spp(3, spp)).into_iter().chain([Sampler::new(4), Sampler::with_spp(5, 12)]);
    for (which, sampler) in samplers.enumerate() {
        for (x, y, frame, domain) in [(0, 0, 0, 0), (63, 64, 1, 2), (u32::MAX, 5, u32::MAX, 77)] {
            let pixel = sampler.pixel(x, y, frame);
            for m in 0..=8 {
                for first in [0, 1 << m, 5 << m, 0x0003_0000] {
                    for pair in 0..4 {
                        let run = points(pixel, domain, first..first + (1 << m), pair);
                        assert_net(&run, &format!("sampler {which}, pair {pair}, 2^{m} samples from {first}"));
                    }
                }
            }
        }
    }
}

#[test]
fn frames_go_on_with_the_net() {
    for (m, spp) in [1, 2, 4, 8, 16].into_iter().enumerate() {
        for k in 0..=5 {
            for pair in 0..4 {
                let frames = (7 << k)..(8 << k);
                let all: Vec<_> = frames
                    .flat_map(|frame| points(Sampler::with_spp(9, spp).pixel(10, 20, frame), 1, 0..spp, pair))
                    .collect();
                assert_net(&all, &format!("2^{k} frames of 2^{m} samples, pair {pair}"));
            }
        }
    }
    // Where the number is not known, of 8 and 64 frames; of one sample also of 2 and 4.
    let cases = (0..=6).flat_map(|m| [0, 3, 6].map(|k| (m, k))).chain([(0, 1), (0, 2)]);
    for (m, k) in cases {
        for pair in 0..4 {
            let frames = (3u32 << k)..(4 << k);
            let all: Vec<_> =
                frames.flat_map(|frame| points(Sampler::new(9).pixel(10, 20, frame), 1, 0..1 << m, pair)).collect();
            assert_net(&all, &format!("2^{k} frames of the first 2^{m} samples, pair {pair}"));
        }
    }
}

#[test]
fn frames_of_one_sample_are_later_samples_of_one_frame() {
    for (seed, domain) in [(1, 0), (u32::MAX, 9)] {
        let sampler = Sampler::with_spp(seed, 1);
        let first = sampler.pixel(7, 8, 0);
        for k in 0..4096 {
            assert_eq!(sampler.pixel(7, 8, k).draw_fx::<8>(domain, 0), first.draw_fx::<8>(domain, k));
        }
    }
}

/// Of independent numbers the mean square is 1/4095 and the mean has a scatter of a hundredth of the root of that.
#[test]
fn domains_are_unrelated_over_seeds() {
    const SEEDS: u32 = 100;
    // What two domains have alike over a block is a number of the columns: more in the first of an unknown number.
    let cases = [(1, [0, 1], 3.0), (4, [6, 14], 3.0), (64, [3, 0x5bd1_e996], 3.0), (3, [0, 1], 6.0)];
    for (spp, domains, bound) in cases {
        let rs = (0..SEEDS).map(|seed| {
            let sampler = Sampler::with_spp(seed, spp);
            let [a, b] = domains.map(|domain| image(64, |x, y| sampler.pixel(x, y, 0).draw_fx::<1>(domain, 0)[0]));
            correlation(&a, &b)
        });
        let rs: Vec<f64> = rs.collect();
        let mean = rs.iter().sum::<f64>() / f64::from(SEEDS);
        let square = rs.iter().map(|r| r * r).sum::<f64>() / f64::from(SEEDS);
        assert!(mean.abs() < 4.0 * (square / f64::from(SEEDS)).sqrt(), "{spp} spp, domains {domains:?}: {mean}");
        assert!(square * 4095.0 < bound, "{spp} spp, domains {domains:?}: {}", square * 4095.0);
    }
}

#[test]
fn powers_of_two_have_an_order_of_their_own_and_other_numbers_the_progressive_one() {
    for (k, spp) in KNOWN.into_iter().enumerate() {
        assert!(NET.known(spp).is_some_and(|order| core::ptr::eq(order, &NET.known[k])), "{spp}");
    }
    assert_eq!(NET.known(0), NET.known(1));
    for spp in [3, 5, 12, 48, 128, 255, 257, 512, 1 << 31, u32::MAX] {
        assert_eq!(NET.known(spp), None, "{spp}");
        let draw = |sampler: Sampler| sampler.pixel(3, 4, 5).draw_fx::<8>(6, spp / 2);
        assert_eq!(draw(Sampler::with_spp(7, spp)), draw(Sampler::new(7)));
    }
}

#[test]
fn no_seed_and_frame_lets_domains_coincide() {
    for seed in EXTREMES.into_iter().chain([0x9e37_79b9]) {
        for frame in EXTREMES.into_iter().chain([0x7f4a_7c15]) {
            let pixel = Sampler::new(seed).pixel(1, 2, frame);
            let mut all: Vec<[u32; 8]> = (0..256).map(|domain| pixel.draw_fx::<8>(domain, 0)).collect();
            all.sort_unstable();
            all.dedup();
            assert_eq!(all.len(), 256, "seed {seed:#x}, frame {frame:#x}");
        }
    }
}

#[test]
fn every_number_is_uniform_over_seeds() {
    // 16,384 seeds: a share scatters by .5/128.
    for (spp, index) in [(1, 0), (2, 0), (2, 1), (16, 3)] {
        let draws: Vec<[f64; 8]> = (0..16_384)
            .map(|seed| Sampler::with_spp(seed, spp).pixel(3, 1, 0).draw_fx::<8>(0, index).map(unit::to_f64))
            .collect();
        for k in 0..8 {
            for below in [0.13, 0.25, 0.5, 0.8] {
                let share = draws.iter().filter(|u| u[k] < below).count() as f64 / 16_384.0;
                assert!((share - below).abs() < 0.02, "{spp} spp, number {k}: {share} below {below}");
            }
            for other in 0..k {
                let [a, b] = [k, other].map(|k| draws.iter().map(|u| u[k]).collect::<Vec<_>>());
                assert!(correlation(&a, &b).abs() < 0.05, "{spp} spp, numbers {other} and {k}");
            }
        }
    }
}

#[test]
fn a_sequence_begins_anew_where_digits_end() {
    let pixel = Sampler::new(1).pixel(5, 6, 7);
    let runs = [0, 0x0001_0000, 0x8000_0000].map(|first: u32| pixel.draw_fx::<8>(0, first));
    assert!(runs[0] != runs[1] && runs[1] != runs[2] && runs[0] != runs[2]);
    // Frames, likewise.
    let first = |frame| Sampler::with_spp(1, 4).pixel(5, 6, frame).draw_fx::<8>(0, 0);
    assert_ne!(first(0), first(1 << 14));
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn digits_are_the_sum_of_columns(sum: Digits, columns: [Digits; 6], bits: u32) {
        let naive = (0..6).filter(|k| bits >> k & 1 == 1).fold(sum, |sum, k| core::array::from_fn(|w| sum[w] ^ columns[k][w]));
        prop_assert_eq!(net::add_columns(sum, &columns, bits), naive);
    }

    #[test]
    fn any_arguments_have_values(seed: u32, spp: u32, x: u32, y: u32, frame: u32, domain: u32, index: u32) {
        let pixel = Sampler::with_spp(seed, spp).pixel(x, y, frame);
        let mut filled = [[0; 8]; 40];
        pixel.fill_fx(domain, index, &mut filled);
        for (k, sample) in (0..).zip(filled) {
            prop_assert_eq!(sample, pixel.draw_fx::<8>(domain, index.wrapping_add(k)));
        }
    }
}
