//! The call shape: one definition for every length, total, pure. Of every sampler.

use crate::common::{EXTREMES, for_every_sampler};
use bluedither::unit;
use proptest::prelude::*;

#[test]
fn draws_of_every_length_agree() {
    for spp in [1, 4, 7] {
        for_every_sampler!(3, spp, |name, sampler| {
            for (x, y, frame, domain, index) in [(0, 0, 0, 0, 0), (5, 9, 2, 3, 1), (70, 64, 1, 0, 6), (1, 2, 3, 4, 100)]
            {
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
}

#[test]
fn a_fill_is_the_draws_from_any_index_on() {
    fn check<const D: usize>(name: &str, draw: impl Fn(u32) -> [u32; D], fill: impl Fn(u32, &mut [[u32; D]])) {
        for (first, length) in [(0, 0), (0, 1), (0, 7), (3, 9), (250, 12), (u32::MAX - 2, 6)] {
            let mut samples = vec![[0; D]; length];
            fill(first, &mut samples);
            let drawn = (0..length as u32).map(|i| draw(first.wrapping_add(i)));
            assert!(samples.into_iter().eq(drawn), "{name}: {length} samples of {D} numbers from {first} on");
        }
    }
    for spp in [1, 4, 7] {
        for_every_sampler!(3, spp, |name, sampler| {
            let pixel = sampler.pixel(5, 9, 2);
            check::<1>(name, |i| pixel.draw_fx(4, i), |first, samples| pixel.fill_fx(4, first, samples));
            check::<2>(name, |i| pixel.draw_fx(4, i), |first, samples| pixel.fill_fx(4, first, samples));
            check::<3>(name, |i| pixel.draw_fx(4, i), |first, samples| pixel.fill_fx(4, first, samples));
            check::<4>(name, |i| pixel.draw_fx(4, i), |first, samples| pixel.fill_fx(4, first, samples));
            let mut floats = [[0.0; 3]; 5];
            pixel.fill(4, 2, &mut floats);
            assert!((2..7).map(|i| pixel.draw(4, i)).eq(floats), "{name}");
        });
    }
}

#[test]
fn a_row_is_the_draws_of_its_pixels() {
    fn check<const D: usize>(name: &str, draw: impl Fn(u32) -> [u32; D], fill: impl Fn(u32, &mut [[u32; D]])) {
        // Inside blocks of any size, across their borders, and across the end of the coordinates.
        for (x, length) in [(0, 0), (7, 1), (0, 70), (29, 5), (u32::MAX - 40, 80)] {
            let mut samples = vec![[0; D]; length];
            fill(x, &mut samples);
            let drawn = (0..length as u32).map(|k| draw(x.wrapping_add(k)));
            assert!(samples.into_iter().eq(drawn), "{name}: {length} samples of {D} numbers from {x} on");
        }
    }
    for (spp, index, y, frame) in [(1, 0, 5, 0), (4, 3, 31, 9), (7, 300, u32::MAX, u32::MAX)] {
        for_every_sampler!(3, spp, |name, sampler| {
            let at = |x| sampler.pixel(x, y, frame);
            check::<1>(name, |x| at(x).draw_fx(4, index), |x, out| sampler.fill_row_fx(x, y, frame, 4, index, out));
            check::<2>(name, |x| at(x).draw_fx(4, index), |x, out| sampler.fill_row_fx(x, y, frame, 4, index, out));
            check::<3>(name, |x| at(x).draw_fx(4, index), |x, out| sampler.fill_row_fx(x, y, frame, 4, index, out));
            check::<4>(name, |x| at(x).draw_fx(4, index), |x, out| sampler.fill_row_fx(x, y, frame, 4, index, out));
            let mut floats = [[0.0; 3]; 40];
            sampler.fill_row(2, y, frame, 4, index, &mut floats);
            assert!((2..42).map(|x| at(x).draw(4, index)).eq(floats), "{name}");
        });
    }
}

#[test]
fn every_argument_is_defined() {
    for (seed, spp) in EXTREMES.into_iter().flat_map(|seed| [4, 7, 0x8000_0000, u32::MAX].map(|spp| (seed, spp))) {
        for_every_sampler!(seed, spp, |name, sampler| {
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
    let all = |spp| {
        let mut draws = Vec::new();
        for_every_sampler!(1, spp, |name, sampler| {
            for index in [0, 1, 2, 100, u32::MAX] {
                let pixel = sampler.pixel(3, 4, 5);
                draws.push((name, index, pixel.draw_fx::<4>(6, index), pixel.draw_fx::<1>(6, index)));
            }
        });
        draws
    };
    assert_eq!(all(0), all(1));
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, cases: 200, ..ProptestConfig::default() })]

    #[test]
    fn draws_are_pure_and_below_one(seed: u32, x: u32, y: u32, frame: u32, domain: u32, index: u32, spp: u32) {
        for_every_sampler!(seed, spp, |name, sampler| {
            let pixel = sampler.pixel(x, y, frame);
            let all = pixel.draw::<4>(domain, index);
            prop_assert!(all.iter().all(|v| (0.0..1.0).contains(v)), "{}", name);
            // Asked again, of a copy, after another question.
            let copy = pixel;
            _ = pixel.draw::<3>(domain ^ 1, index ^ 1);
            prop_assert_eq!(copy.draw::<4>(domain, index), all, "{}", name);
        });
    }
}
