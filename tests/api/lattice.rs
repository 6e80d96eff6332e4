//! Lattices against exact fractions and their group structure; Fibonacci's against all of their size; the increments of
//! the R-sequences from their polynomials.

use bluedither::lattice::{EXEW, FIBONACCI, R, R_64, extensible, fixed, r, r_64};
use proptest::prelude::*;

#[test]
fn a_fixed_lattice_is_a_group_that_hits_every_fraction_once() {
    for count in [1u32, 2, 3, 12, 55, 64, 1000, 1021] {
        for z in [1, 7, 89, 999, u32::MAX] {
            if gcd(z, count) != 1 {
                continue;
            }
            // Rounded down to 2^-32, a fraction k/count with count < 2^16 can be told from the value.
            let fraction = |index: u32| (u64::from(fixed(index, z, count)) * u64::from(count)).div_ceil(1 << 32) as u32;
            let mut seen = vec![false; count as usize];
            for index in 0..count {
                assert!(!core::mem::replace(&mut seen[fraction(index) as usize], true), "{count} points, z = {z}");
                let sum = (fraction(index) + fraction(count / 3)) % count;
                assert_eq!(sum, fraction((index + count / 3) % count), "{count} points, z = {z}");
                assert_eq!(fraction(index + count), fraction(index));
            }
        }
    }
}

fn gcd(a: u32, b: u32) -> u32 {
    if b == 0 { a } else { gcd(b, a % b) }
}

#[test]
fn every_aligned_block_of_an_extensible_lattice_is_stratified() {
    for z in EXEW {
        assert_eq!(z % 2, 1, "{z}");
        for m in 0..=12u32 {
            for start in [0, 1 << m, 9 << m, u32::MAX - ((1 << m) - 1)] {
                let mut seen = vec![false; 1 << m];
                for index in start..=start + ((1 << m) - 1) {
                    seen[(u64::from(extensible(index, z)) >> (32 - m)) as usize] = true;
                }
                assert!(seen.iter().all(|hit| *hit), "z = {z}, 2^{m} points from {start}");
            }
        }
    }
}

#[test]
fn every_power_of_two_of_an_extensible_lattice_is_a_group() {
    let point = |index: u32| [1, 3, 6].map(|d| extensible(index, EXEW[d]));
    for m in [0, 1, 5, 8u32] {
        let all: std::collections::BTreeSet<_> = (0..1 << m).map(point).collect();
        assert_eq!(all.len(), 1 << m);
        for a in &all {
            for b in &all {
                assert!(all.contains(&[0, 1, 2].map(|d| a[d].wrapping_add(b[d]))), "2^{m} points");
            }
        }
    }
}

/// Squared worst-case error of a lattice in the Korobov space of order 2: the mean of Π(1 + γ·ω(x)) over its points,
/// less one, with ω(x) = 2π²(x² − x + 1/6). `products` are those of the dimensions so far.
fn squared_error(products: &[f64], weight: f64, z: u32) -> f64 {
    let count = products.len();
    (0..count).map(|k| products[k] * factor(k * z as usize % count, count, weight)).sum::<f64>() / count as f64 - 1.0
}

fn factor(k: usize, count: usize, weight: f64) -> f64 {
    let x = k as f64 / count as f64;
    1.0 + weight * 2.0 * core::f64::consts::PI.powi(2) * (x * x - x + 1.0 / 6.0)
}

#[test]
fn fibonacci_lattices_are_the_best_of_their_size() {
    assert_eq!(FIBONACCI[..6], [1, 2, 3, 5, 8, 13]);
    assert_eq!(FIBONACCI[45], 2_971_215_073);
    for k in 4..12 {
        let (count, z) = (FIBONACCI[k], FIBONACCI[k - 1]);
        let first: Vec<f64> = (0..count as usize).map(|i| factor(i, count as usize, 1.0)).collect();
        let ours = squared_error(&first, 1.0, z);
        for other in (1..count).filter(|&other| gcd(other, count) == 1) {
            assert!(ours < squared_error(&first, 1.0, other) * (1.0 + 1e-9), "{count} points: {other} is better");
        }
    }
}

/// The product of two 0.128 numbers.
fn multiply(a: u128, b: u128) -> u128 {
    let ([a1, a0], [b1, b0]) = ([a >> 64, a & u128::from(u64::MAX)], [b >> 64, b & u128::from(u64::MAX)]);
    a1 * b1 + ((a1 * b0) >> 64) + ((a0 * b1) >> 64)
}

fn power(x: u128, n: usize) -> u128 {
    (1..n).fold(x, |product, _| multiply(product, x))
}

/// x = 1/φ solves x^d + x^(d+1) = 1: bit by bit, the largest that stays below.
fn root(d: usize) -> u128 {
    let below = |x: u128| power(x, d).checked_add(power(x, d + 1)).is_some();
    (0..128).rev().fold(0, |x, bit| if below(x | 1 << bit) { x | 1 << bit } else { x })
}

#[test]
fn increments_are_powers_of_the_root() {
    for d in 1..=4 {
        for j in 1..=d {
            let exact = power(root(d), j);
            let (short, long) = (R[d - 1][j - 1], R_64[d - 1][j - 1]);
            assert!(short % 2 == 1 && long % 2 == 1, "an even increment has no full period");
            assert!((u128::from(short) << 96).abs_diff(exact) <= 1 << 96, "32 bits: {d}, {j}");
            assert!((u128::from(long) << 64).abs_diff(exact) <= 1 << 64, "64 bits: {d}, {j}");
        }
    }
}

#[test]
fn a_billion_points_on_the_r_sequences_have_drifted_as_little_as_is_said() {
    for index in [1_000u32, 1_000_000, 1_000_000_000, u32::MAX] {
        let exact = |j: usize| power(root(2), j + 1).wrapping_mul(index.into()).wrapping_add(1 << 127);
        // How far a 0.64 number is from it, around the circle.
        let off = |value: u64, j: usize| {
            let off = value.wrapping_sub((exact(j) >> 64) as u64);
            off.min(off.wrapping_neg()) as f64 / 2f64.powi(64)
        };
        for j in 0..2 {
            let long = off(r_64::<2>(index.into())[j], j);
            assert!(long < f64::from(index) * 1e-19, "64 bits, point {index}: {long}");
            let short = off(u64::from(r::<2>(index)[j]) << 32, j);
            assert!(short < f64::from(index) * 1.9e-10 + 2f64.powi(-32), "32 bits, point {index}: {short}");
        }
    }
}

#[test]
fn r_sequences_fill_the_interval_evenly() {
    // Three lengths of gaps at most between the points on a line (the three-gap theorem), and none twice the mean for
    // the golden ratio.
    for count in [1u32, 2, 10, 144, 1000] {
        let mut values: Vec<u32> = (0..count).map(|i| r::<1>(i)[0]).collect();
        values.sort_unstable();
        let gaps = (0..values.len()).map(|k| values[(k + 1) % values.len()].wrapping_sub(values[k]));
        let lengths: std::collections::BTreeSet<u32> = gaps.collect();
        assert!(lengths.len() <= 3, "{count} points: {lengths:?}");
        let widest = f64::from(*lengths.last().expect("a gap")) * f64::from(count) / 4_294_967_296.0;
        assert!(widest < 2.0, "{count} points: {widest}");
    }
    assert_eq!(r::<3>(0), [1 << 31; 3]);
    assert_eq!(r_64::<2>(0), [1 << 63; 2]);
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, cases: 2000, ..ProptestConfig::default() })]

    #[test]
    fn fixed_is_exact(index: u32, z: u32, count in 1u32..) {
        let exact = ((u128::from(index) * u128::from(z)) << 32) / u128::from(count) % (1 << 32);
        prop_assert_eq!(u128::from(fixed(index, z, count)), exact);
        prop_assert_eq!(fixed(index, z, 0), fixed(index, z, 1));
    }

    #[test]
    fn sequences_are_defined_everywhere(index: u32, far: u64, z: u32) {
        prop_assert_eq!(extensible(index, z), (u64::from(index.reverse_bits()) * u64::from(z)) as u32);
        for k in 0..4 {
            let naive = (u128::from(far) * u128::from(R_64[3][k]) + (1 << 63)) as u64;
            prop_assert_eq!(r_64::<4>(far)[k], naive);
            prop_assert_eq!(r::<4>(index)[k], (u64::from(index) * u64::from(R[3][k]) + (1 << 31)) as u32);
        }
    }
}
