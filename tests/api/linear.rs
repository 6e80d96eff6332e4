//! The linear pixel order: naive twins, nets for every power of two in the sequence.

use crate::analysis::net::assert_net;
use bluedither::linear::{self, BLOCK_LOG2, Columns, Order};
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
