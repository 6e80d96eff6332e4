//! The linear pixel order: naive twins, nets for every power of two, in the sequence and in every pixel.

use crate::analysis::net::assert_net;
use bluedither::Sampler;
use bluedither::linear::{self, BLOCK_LOG2, Columns, Order};
use bluedither::sampler::LinearPixel;
use bluedither::tables::LINEAR_ORDER;
use proptest::prelude::*;

fn point(index: u32) -> [u32; 2] {
    let packed = LINEAR_ORDER.sequence.packed(index);
    [(packed >> 32) as u32, packed as u32]
}

#[test]
fn every_aligned_run_of_the_sequence_is_a_net() {
    for m in 0..=12 {
        for run in [0, 1, 2, 0x000f_ffff, 0x0005_a5a5] {
            let first = (run as u32) << m;
            let points: Vec<_> = (first..=first | ((1 << m) - 1)).map(point).collect();
            assert_net(&points, &format!("2^{m} points from {first}"));
        }
        let points: Vec<_> = (0..1u32 << m).map(|i| point(u32::MAX - i)).collect();
        assert_net(&points, &format!("the last 2^{m} points"));
    }
}

#[test]
fn the_sequence_is_the_sum_of_its_columns() {
    let naive = |index: u32| {
        (0..32).filter(|bit| index >> bit & 1 == 1).fold(0, |sum, bit| sum ^ LINEAR_ORDER.sequence.packed(1 << bit))
    };
    for index in (0..4096).chain([0x8000_0000, 0xffff_ffff, 0xdead_beef, 0x0001_0000]) {
        assert_eq!(LINEAR_ORDER.sequence.packed(index), naive(index), "{index}");
        assert_eq!(LINEAR_ORDER.sequence.packed_rev(index.reverse_bits()), naive(index), "{index}");
    }
}

#[test]
fn powers_of_two_have_an_order_of_their_own_and_other_numbers_the_progressive_one() {
    let which = |spp| {
        let found = LINEAR_ORDER.known(spp)?;
        LINEAR_ORDER.known.iter().position(|order| core::ptr::eq(order, found))
    };
    assert_eq!(which(0), Some(0));
    for m in 0..9 {
        assert_eq!(which(1 << m), Some(m));
    }
    for spp in [3, 5, 12, 48, 255, 257, 512, 1 << 31, u32::MAX] {
        assert_eq!(LINEAR_ORDER.known(spp), None, "{spp}");
        let draw = |sampler: Sampler| sampler.pixel(3, 4, 5).draw_fx::<4>(6, spp / 2);
        assert_eq!(draw(Sampler::with_spp(7, spp)), draw(Sampler::new(7)));
    }
}

#[test]
fn no_two_orders_are_alike() {
    let mut all: Vec<&Order> = LINEAR_ORDER.known.iter().collect();
    all.push(&LINEAR_ORDER.progressive);
    for (i, a) in all.iter().enumerate() {
        assert!(all[..i].iter().all(|b| a != b), "order {i}");
        for (k, set) in a.iter().enumerate() {
            assert!(!a[..k].contains(set), "order {i}, set {k}");
        }
    }
}

fn points(pixel: LinearPixel, domain: u32, count: u32) -> Vec<[u32; 2]> {
    (0..count).map(|index| pixel.draw_fx::<2>(domain, index)).collect()
}

#[test]
fn every_pixel_has_a_net_at_every_power_of_two() {
    for (x, y, frame, domain) in [(0, 0, 0, 0), (63, 64, 1, 2), (u32::MAX, 5, u32::MAX, 77)] {
        for m in 0..=12 {
            let count = 1 << m;
            for seed in [0, 1, u32::MAX] {
                let progressive = points(Sampler::new(seed).pixel(x, y, frame), domain, count);
                assert_net(&progressive, &format!("the first {count}, progressive, seed {seed}"));
                let known = points(Sampler::with_spp(seed, count).pixel(x, y, frame), domain, count);
                assert_net(&known, &format!("all {count}, seed {seed}"));
            }
        }
    }
}

#[test]
fn known_numbers_go_on_with_nets() {
    // Twice as many as were announced are one net, and so on.
    for spp in [1, 4, 16, 256] {
        let pixel = Sampler::with_spp(3, spp).pixel(10, 20, 0);
        for more in [2, 4, 8] {
            assert_net(&points(pixel, 1, more * spp), &format!("{more} times {spp}"));
        }
    }
}

/// The samples of a pixel are the first points of the sequence, moved by one digital shift, in some order.
#[test]
fn a_pixels_samples_are_the_first_points_moved() {
    for (m, seed) in [(0, 1), (3, 2), (6, 3), (8, 4)] {
        let mut first: Vec<[u32; 2]> = (0..1 << m).map(point).collect();
        first.sort_unstable();
        for pixel in [Sampler::with_spp(seed, 1 << m), Sampler::new(seed)].map(|sampler| sampler.pixel(40, 7, 1)) {
            let drawn = points(pixel, 2, 1 << m);
            // One of the drawn points is point 0, moved; the block may have swapped its numbers.
            let fits = drawn.iter().flat_map(|&shift| [(shift, false), (shift, true)]).any(|(shift, swap)| {
                let back =
                    |[x, y]: [u32; 2]| if swap { [y ^ shift[1], x ^ shift[0]] } else { [x ^ shift[0], y ^ shift[1]] };
                let mut back: Vec<_> = drawn.iter().map(|&sample| back(sample)).collect();
                back.sort_unstable();
                back == first
            });
            assert!(fits, "2^{m} samples, seed {seed}");
        }
    }
}

#[test]
fn blocks_differ_and_pixels_of_a_block_share_its_shift() {
    // Taken off, the shift of the block is gone: differences within a block are what the columns say, in some set.
    let sampler = Sampler::with_spp(9, 1);
    let upper = |[x, y]: [u32; 2]| (x & 0xffff_0000) | y >> 16;
    let at = |x, y| upper(sampler.pixel(x, y, 0).draw_fx::<2>(0, 0));
    let mut differences = Vec::new();
    for block in 0..64u32 {
        differences.push(at(32 * block, 0) ^ at(32 * block + 1, 0));
    }
    differences.sort_unstable();
    differences.dedup();
    // A set or its transpose, its numbers swapped or not: 32 variants, not 64 random words.
    assert!((2..=32).contains(&differences.len()), "{}", differences.len());
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn digits_are_the_sum_of_columns(words: [u32; 10], x: u32, y: u32) {
        let columns: Columns = words;
        let naive = (0..2 * BLOCK_LOG2)
            .filter(|k| [x, y][*k as usize % 2] >> (k / 2) & 1 == 1)
            .fold(0, |sum, k| sum ^ columns[k as usize]);
        prop_assert_eq!(linear::digits(&columns, x, y), naive);
    }
}
