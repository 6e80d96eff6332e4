//! Sobol points against the definitions: a matrix bit by bit, the recurrence of Joe and Kuo, elementary intervals.

use crate::analysis::net::assert_net;
use bluedither::hash::{mix, owen};
use bluedither::sobol::{dimension, dimension_0, dimension_1, owen_point, point};
use proptest::prelude::*;

const EXTREMES: [u32; 9] = [0, 1, 2, 3, 0x7fff_ffff, 0x8000_0000, 0x8000_0001, u32::MAX - 1, u32::MAX];

/// Pascal's triangle modulo 2, row n of binomials C(n, k), by addition.
fn pascal() -> [[u32; 32]; 32] {
    let mut rows = [[0; 32]; 32];
    for n in 0..32 {
        rows[n][0] = 1;
        for k in 1..=n {
            rows[n][k] = (rows[n - 1][k - 1] + rows[n - 1][k]) % 2;
        }
    }
    rows
}

/// Digit r of the point, the one of weight 2^-(r+1), is Σ C(c, r)·(bit c of the index) modulo 2.
fn naive_dimension_1(index: u32, pascal: &[[u32; 32]; 32]) -> u32 {
    let mut value = 0;
    for r in 0..32 {
        let mut digit = 0;
        for (c, row) in pascal.iter().enumerate() {
            digit ^= row[r] & (index >> c & 1);
        }
        value |= digit << (31 - r);
    }
    value
}

/// Joe and Kuo 2008 as published: m_k = 2a₁m_{k−1} ⊕ … ⊕ 2^{s−1}a_{s−1}m_{k−s+1} ⊕ 2^s·m_{k−s} ⊕ m_{k−s}, and the
/// point is the XOR of m_k/2^k over the set bits of the index (k from 1).
fn joe_kuo(index: u32, s: usize, a: u32, first: &[u64]) -> u32 {
    let mut m = first.to_vec();
    for k in s..32 {
        let mut next = m[k - s] << s ^ m[k - s];
        for j in 1..s {
            next ^= (u64::from(a) >> (s - 1 - j) & 1) * (m[k - j] << j);
        }
        m.push(next);
    }
    (0..32).filter(|k| index >> k & 1 == 1).fold(0, |sum, k| sum ^ (m[k] << (31 - k)) as u32)
}

/// Dimensions 0 to 3: lines `d s a m_i` of new-joe-kuo-6.21201. Dimension 0 has all m = 1.
fn naive(index: u32, dimension: u32) -> u32 {
    match dimension {
        0 => (0..32).filter(|k| index >> k & 1 == 1).fold(0, |sum, k| sum ^ 1 << (31 - k)),
        1 => joe_kuo(index, 1, 0, &[1]),
        2 => joe_kuo(index, 2, 1, &[1, 3]),
        _ => joe_kuo(index, 3, 1, &[1, 3, 1]),
    }
}

#[test]
fn known_values() {
    // Published check values of the second dimension (sobol_burley's reference, from index 1000 on).
    for (index, value) in
        [(1000, 692_060_160), (1001, 2_839_543_808), (1002, 3_913_285_632), (1003, 1_765_801_984), (1020, 20_971_520)]
    {
        assert_eq!(dimension_1(index), value, "{index}");
    }
    // The first eight points by hand.
    let eighths = |v: u32| v >> 29;
    let first: Vec<[u32; 2]> = (0..8).map(|i| point(i).map(eighths)).collect();
    assert_eq!(first, [[0, 0], [4, 4], [2, 6], [6, 2], [1, 5], [5, 1], [3, 3], [7, 7]]);
}

#[test]
fn all_dimensions_follow_the_recurrence() {
    let pascal = pascal();
    for index in EXTREMES.into_iter().chain(0..2048).chain((0..32).map(|bit| 1 << bit)) {
        assert_eq!(dimension_1(index), naive_dimension_1(index, &pascal), "{index}");
        for d in 0..4 {
            assert_eq!(dimension(index, d), naive(index, d), "index {index}, dimension {d}");
        }
    }
}

#[test]
fn dimensions_are_taken_modulo_four() {
    for index in EXTREMES {
        for d in [4, 5, 6, 7, 0xffff_fffc, u32::MAX] {
            assert_eq!(dimension(index, d), dimension(index, d % 4));
        }
        assert_eq!(point(index), [dimension(index, 0), dimension(index, 1)]);
        assert_eq!(point(index), [dimension_0(index), dimension_1(index)]);
    }
}

#[test]
fn every_aligned_block_is_a_net() {
    for m in 0..=12u32 {
        let blocks = 1u64 << (32 - m);
        for block in [0, 1, 2, 3, 5, 100, blocks / 2, blocks - 1] {
            let start = (block % blocks) << m;
            let points: Vec<_> = (start..start + (1 << m)).map(|i| point(i as u32)).collect();
            assert_net(&points, &format!("2^{m} points from {start}"));
        }
    }
}

#[test]
fn every_dimension_is_stratified_in_every_aligned_block() {
    for d in 0..4 {
        for m in 0..=12u32 {
            for start in [0, 1 << m, 7 << m, u32::MAX - ((1 << m) - 1)] {
                let mut seen = vec![false; 1 << m];
                for i in 0..1u32 << m {
                    let value = u64::from(dimension(start + i, d));
                    seen[(value >> (32 - m)) as usize] = true;
                }
                assert!(seen.iter().all(|hit| *hit), "dimension {d}, 2^{m} points from {start}");
            }
        }
    }
}

#[test]
fn owen_scrambling_keeps_nets() {
    for seed in [0, 1, 2, 12345, u32::MAX] {
        for m in [0, 1, 4, 7, 10, 12u32] {
            for start in [0u32, 3 << m, u32::MAX - ((1 << m) - 1)] {
                let points: Vec<_> = (0..1 << m).map(|i| owen_point(start + i, seed)).collect();
                assert_net(&points, &format!("seed {seed}, 2^{m} points from {start}"));
            }
        }
    }
}

#[test]
fn owen_scrambling_of_two_seeds_or_dimensions_is_unrelated() {
    // Correlation of 4096 first points over seeds; standard error .016.
    let rounds = 4096u32;
    let centred = |v: u32| f64::from(v) / 4_294_967_296.0 - 0.5;
    for index in [0, 1, 77] {
        let (mut between_dimensions, mut between_seeds) = (0.0, 0.0);
        for seed in 0..rounds {
            let [x, y] = owen_point(index, seed).map(centred);
            let [next, _] = owen_point(index, seed + 1).map(centred);
            between_dimensions += 12.0 * x * y;
            between_seeds += 12.0 * x * next;
        }
        for sum in [between_dimensions, between_seeds] {
            assert!((sum / f64::from(rounds)).abs() < 0.07, "index {index}: {sum}");
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, cases: 1000, ..ProptestConfig::default() })]

    #[test]
    fn fast_is_naive(index: u32) {
        for d in 0..4 {
            prop_assert_eq!(dimension(index, d), naive(index, d));
        }
    }

    #[test]
    fn sobol_is_linear(a: u32, b: u32) {
        for d in 0..4 {
            prop_assert_eq!(dimension(a ^ b, d), dimension(a, d) ^ dimension(b, d));
        }
    }

    #[test]
    fn owen_point_is_the_scrambled_point(index: u32, seed: u32) {
        let ([x, y], [u, v]) = (point(index), owen_point(index, seed));
        prop_assert_eq!(u, owen(x, mix(seed)));
        // The seed of the second is a detail, but it is the same for all indices: intervals stay together.
        let (near, moved) = (point(index ^ 1)[1], owen_point(index ^ 1, seed)[1]);
        prop_assert_eq!((y ^ near).leading_zeros(), (v ^ moved).leading_zeros());
    }
}
