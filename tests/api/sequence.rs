//! The sequence of keys: naive twins, nets for every power of two.

use crate::analysis::net::assert_net;
use bluedither::tables::SEQUENCE;

fn point(index: u32) -> [u32; 2] {
    let packed = SEQUENCE.packed(index);
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
    let naive =
        |index: u32| (0..32).filter(|bit| index >> bit & 1 == 1).fold(0, |sum, bit| sum ^ SEQUENCE.packed(1 << bit));
    for index in (0..4096).chain([0x8000_0000, 0xffff_ffff, 0xdead_beef, 0x0001_0000]) {
        assert_eq!(SEQUENCE.packed(index), naive(index), "{index}");
        assert_eq!(SEQUENCE.packed_rev(index.reverse_bits()), naive(index), "{index}");
    }
}
