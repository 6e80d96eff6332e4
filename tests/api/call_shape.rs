//! The call shape: one definition for every length, total, pure. Of every sampler.

use crate::common::{EXTREMES, for_every_length, for_every_sampler};
use bluedither::unit;
use proptest::prelude::*;

#[test]
fn draws_of_every_length_agree() {
    for spp in [1, 4, 7] {
        for_every_sampler!(3, spp, |name, sampler| {
            for (x, y, frame, domain, index) in [(0, 0, 0, 0, 0), (5, 9, 2, 3, 1), (70, 64, 1, 0, 6), (1, 2, 3, 4, 100)]
            {
                let pixel = sampler.pixel(x, y, frame);
                let all = pixel.draw_fx::<8>(domain, index);
                for_every_length!(|D| {
                    let drawn = pixel.draw_fx::<D>(domain, index);
                    // The last of an odd number has no partner, and may be a single dimension.
                    assert_eq!(drawn[..D & !1], all[..D & !1], "{name}, {D} numbers");
                    assert_eq!(pixel.draw::<D>(domain, index), unit::to_f32s(drawn), "{name}, {D} numbers");
                });
            }
        });
    }
}

#[test]
fn a_fill_is_the_draws_from_any_index_on() {
    for spp in [1, 4, 7] {
        for_every_sampler!(3, spp, |name, sampler| {
            let pixel = sampler.pixel(5, 9, 2);
            for (first, length) in [(0, 0), (0, 1), (0, 7), (3, 9), (250, 12), (65_530, 12), (u32::MAX - 2, 6)] {
                let indices = || (0..length as u32).map(|k| first.wrapping_add(k));
                for_every_length!(|D| {
                    let (mut numbers, mut floats) = (vec![[0; D]; length], vec![[0.0; D]; length]);
                    pixel.fill_fx(4, first, &mut numbers);
                    pixel.fill(4, first, &mut floats);
                    let what = format!("{name}: {length} samples of {D} numbers from {first} on");
                    assert!(indices().map(|index| pixel.draw_fx(4, index)).eq(numbers), "{what}");
                    assert!(indices().map(|index| pixel.draw(4, index)).eq(floats), "{what}");
                });
            }
        });
    }
}

#[test]
fn a_row_is_the_draws_of_its_pixels() {
    // Inside blocks of any size, across their borders, and across the end of the coordinates.
    let runs = [(0, 0), (7, 1), (0, 70), (29, 5), (u32::MAX - 40, 80)];
    for (spp, index, y, frame) in [(1, 0, 5, 0), (4, 3, 31, 9), (2, 70_000, 6, 40_000), (7, 300, u32::MAX, u32::MAX)] {
        for_every_sampler!(3, spp, |name, sampler| {
            for (first, length) in runs {
                let pixels = || (0..length as u32).map(|k| sampler.pixel(first.wrapping_add(k), y, frame));
                for_every_length!(|D| {
                    let (mut numbers, mut floats) = (vec![[0; D]; length], vec![[0.0; D]; length]);
                    sampler.fill_row_fx(first, y, frame, 4, index, &mut numbers);
                    sampler.fill_row(first, y, frame, 4, index, &mut floats);
                    let what = format!("{name}: {D} numbers of {length} pixels from {first} on");
                    assert!(pixels().map(|pixel| pixel.draw_fx(4, index)).eq(numbers), "{what}");
                    assert!(pixels().map(|pixel| pixel.draw(4, index)).eq(floats), "{what}");
                });
            }
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
                            let all = pixel.draw::<8>(domain, index);
                            assert!(all.iter().all(|v| (0.0..1.0).contains(v)), "{name}: {all:?}");
                            assert!((0.0..1.0).contains(&pixel.draw::<1>(domain, index)[0]), "{name}");
                            assert!((0.0..1.0).contains(&pixel.draw::<7>(domain, index)[6]), "{name}");
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
                draws.push((name, index, pixel.draw_fx::<8>(6, index), pixel.draw_fx::<1>(6, index)));
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
            let all = pixel.draw::<8>(domain, index);
            prop_assert!(all.iter().all(|v| (0.0..1.0).contains(v)), "{}", name);
            // Asked again, of a copy, after another question.
            let copy = pixel;
            _ = pixel.draw::<5>(domain ^ 1, index ^ 1);
            prop_assert_eq!(copy.draw::<8>(domain, index), all, "{}", name);
        });
    }
}
