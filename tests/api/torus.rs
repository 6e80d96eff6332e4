//! Toroidal addressing: wrapping of every coordinate, and places that stay apart.

use bluedither::torus::{offset, wrap};
use proptest::prelude::*;

/// Distance of two places on a torus of 2^`size_log2` squared pixels, squared.
fn distance_2(a: [u32; 2], b: [u32; 2], size_log2: u32) -> u64 {
    let size = 1u64 << size_log2;
    let axis = |k: usize| {
        let d = u64::from(a[k].abs_diff(b[k])) % size;
        d.min(size - d)
    };
    axis(0).pow(2) + axis(1).pow(2)
}

/// The closest two of some places, in pixels.
fn closest(places: &[[u32; 2]], size_log2: u32) -> f64 {
    let pairs = (1..places.len()).flat_map(|i| (0..i).map(move |j| (i, j)));
    let least = pairs.map(|(i, j)| distance_2(places[i], places[j], size_log2)).min();
    (least.unwrap_or(u64::MAX) as f64).sqrt()
}

#[test]
fn wrap_at_extremes() {
    for size_log2 in 0..=31 {
        let size = 1u32 << size_log2;
        for coordinate in [0, 1, size - 1, size, size.wrapping_add(1), 1 << 31, u32::MAX - 1, u32::MAX] {
            assert_eq!(wrap(coordinate, size), coordinate % size, "{coordinate} in {size}");
        }
        for coordinate in [-1i32, -2, i32::MIN, i32::MIN + 1, i32::MAX] {
            let twin = i64::from(coordinate).rem_euclid(i64::from(size));
            assert_eq!(i64::from(wrap(coordinate as u32, size)), twin, "{coordinate} in {size}");
        }
    }
}

#[test]
fn offsets_are_inside_the_tile() {
    let extremes = [0, 1, 0x8000_0000, u32::MAX];
    for size_log2 in [0, 1, 2, 4, 6, 8, 16, 31, 32, 33, 64, u32::MAX] {
        let size = 1u64 << size_log2.min(32);
        for seed in extremes {
            for domain in extremes {
                for frame in extremes {
                    let place = offset(seed, domain, 0, frame, size_log2);
                    assert!(place.iter().all(|&c| u64::from(c) < size), "{place:?} in {size}");
                }
            }
        }
    }
}

#[test]
fn a_smaller_tile_is_read_at_the_same_place_more_coarsely() {
    for size_log2 in 1..=32 {
        let (fine, coarse) = (offset(7, 8, 1, 9, 32), offset(7, 8, 1, 9, size_log2));
        assert_eq!(coarse, fine.map(|c| (u64::from(c) >> (32 - size_log2)) as u32));
    }
}

#[test]
fn a_hundred_domains_or_frames_stay_apart() {
    for seed in [0, 1, 2, 3, 1000, u32::MAX] {
        for first in [0, 5, 1_000_000, u32::MAX - 40] {
            let domains: Vec<_> = (0..100).map(|k| offset(seed, k + first % 3, 0, 0, 6)).collect();
            let late: Vec<_> = (0..100).map(|k| offset(seed, first.wrapping_add(k), 0, 3, 6)).collect();
            let frames: Vec<_> = (0..100).map(|k| offset(seed, 4, 0, first.wrapping_add(k), 6)).collect();
            for places in [domains, late, frames] {
                let least = closest(&places, 6);
                assert!(least >= 4.0, "seed {seed}, from {first}: two places {least} pixels apart");
            }
        }
    }
}

#[test]
fn domains_in_frames_and_their_pads_stay_apart() {
    for seed in [0, 1, 2, 1000, u32::MAX] {
        for (domains, frames) in [(16, 4), (8, 8), (4, 16)] {
            let places: Vec<_> = (0..domains)
                .flat_map(|domain| (0..frames).map(move |frame| offset(seed, domain, 0, frame, 6)))
                .collect();
            let least = closest(&places, 6);
            assert!(least >= 4.0, "seed {seed}, {domains} domains, {frames} frames: two places {least} pixels apart");
        }
        for (domains, frames) in [(32, 1), (16, 4), (8, 8), (4, 16)] {
            let pads: Vec<_> =
                (0..domains * frames * 4).map(|k| offset(seed, k / 4 % domains, k % 4, k / 4 / domains, 6)).collect();
            let least = closest(&pads, 6);
            assert!(least >= 2.0, "seed {seed}, {domains} domains and pads, {frames} frames: {least} pixels apart");
        }
    }
}

#[test]
fn places_of_many_seeds_fill_the_tile_evenly() {
    // 65536 seeds over 16×16 cells: chi² of 255 degrees of freedom is 255 ± 23.
    let mut count = [0u32; 256];
    for seed in 0..1 << 16 {
        let [x, y] = offset(seed, 3, 0, 5, 4);
        count[(y * 16 + x) as usize] += 1;
    }
    let chi2: f64 = count.iter().map(|&n| (f64::from(n) - 256.0).powi(2) / 256.0).sum();
    assert!((150.0..370.0).contains(&chi2), "{chi2}");
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn wrap_is_the_euclidean_remainder(coordinate: i32, size_log2 in 0u32..31) {
        let size = 1i32 << size_log2;
        prop_assert_eq!(wrap(coordinate as u32, size as u32) as i32, coordinate.rem_euclid(size));
    }

    #[test]
    fn domains_step_alike_from_everywhere(seed: u32, domain: u32, frame: u32, step: u32) {
        // What is between two domains depends on their difference only, in every frame and for every seed.
        let delta = |seed, domain: u32, frame| {
            let (a, b) = (offset(seed, domain, 0, frame, 32), offset(seed, domain.wrapping_add(step), 0, frame, 32));
            [b[0].wrapping_sub(a[0]), b[1].wrapping_sub(a[1])]
        };
        prop_assert_eq!(delta(seed, domain, frame), delta(!seed, 0, 0));
    }
}
