//! The joint net's columns: every own pair is a (0, 2)-sequence in all its digits.

use bluedither::net::{Digits, Order};
use bluedither::tables::NET;

/// Row j of a number: bit k is its digit j in column k.
fn row(columns: &[Digits], number: usize, j: usize) -> u32 {
    let digit = |column: &Digits| column[number / 2] >> (31 - j - number % 2 * 16) & 1;
    columns.iter().enumerate().fold(0, |row, (k, column)| row | digit(column) << k)
}

/// Gaussian elimination modulo 2.
fn independent(rows: impl Iterator<Item = u32>) -> bool {
    let mut basis: Vec<u32> = Vec::new();
    for row in rows {
        let left = basis.iter().fold(row, |row, &b| row.min(row ^ b));
        if left == 0 {
            return false;
        }
        basis.push(left);
    }
    true
}

/// Panics unless the sums of these columns, moved by anything, are a net in every own pair: all first digits are
/// independent, as many together as there are columns.
fn assert_nets(columns: &[Digits], what: &str) {
    let m = columns.len();
    for pair in 0..4 {
        for a in 0..=m {
            let rows =
                (0..a).map(|j| row(columns, 2 * pair, j)).chain((0..m - a).map(|j| row(columns, 2 * pair + 1, j)));
            assert!(independent(rows), "{what}, pair {pair}: {a} digits and {}", m - a);
        }
    }
}

fn orders() -> impl Iterator<Item = &'static Order> {
    NET.known.iter().chain([&NET.progressive])
}

#[test]
fn every_own_pair_of_every_order_is_a_sequence_of_nets() {
    for (which, order) in orders().enumerate() {
        for m in 0..=order.samples.len() {
            assert_nets(&order.samples[..m], &format!("order {which}, 2^{m} samples"));
        }
    }
}

/// As the docs of `Sampler` say: 8 frames, or 64, of any power of two of samples are one net.
#[test]
fn frames_of_an_unknown_number_are_nets_by_8_and_64() {
    for k in [3, 6] {
        for m in 0..=16 - k {
            let columns = [&NET.frames[..k], &NET.progressive.samples[..m]].concat();
            assert_nets(&columns, &format!("2^{k} frames of 2^{m} samples"));
        }
    }
}

#[test]
fn dependent_digits_are_found() {
    let mut columns = NET.progressive.samples[..4].to_vec();
    columns[3] = bluedither::net::add(columns[0], columns[1]);
    assert!(!independent((0..4).map(|j| row(&columns, 0, j))));
    assert!(independent([0b01, 0b11].into_iter()) && !independent([0b01, 0b11, 0b10].into_iter()));
}

#[test]
fn no_two_orders_are_alike() {
    let all: Vec<_> = orders().collect();
    for (k, order) in all.iter().enumerate() {
        assert!(!all[..k].contains(order), "order {k}");
    }
}
