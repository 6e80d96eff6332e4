//! The Sobol table against the recurrence as published, and its points against the structure they must have.

use crate::analysis::net::assert_net;
use bluedither::hash::mix;
use bluedither::sobol::{self, Directions, directions};

/// The table of 1024 dimensions, read from the file line by line.
fn table() -> Directions<1024> {
    let mut all = vec![core::array::from_fn(|bit| 1u32 << (31 - bit))];
    for line in include_str!("../../tables/joe_kuo.txt").lines().filter(|line| !line.starts_with('#')) {
        let row: Vec<u32> = line.split_whitespace().map(|word| word.parse().expect("a number")).collect();
        assert_eq!(row.len() as u32, 3 + row[1]);
        all.push(directions(row[2], &row[3..]));
    }
    Directions::new(all.try_into().expect("1024 dimensions"))
}

/// Joe and Kuo 2008 as published: m_k = 2a₁m_{k−1} ⊕ … ⊕ 2^{s−1}a_{s−1}m_{k−s+1} ⊕ 2^s·m_{k−s} ⊕ m_{k−s}.
#[test]
fn directions_follow_the_recurrence() {
    for line in include_str!("../../tables/joe_kuo.txt").lines().filter(|line| !line.starts_with('#')) {
        let row: Vec<u64> = line.split_whitespace().map(|word| word.parse().expect("a number")).collect();
        let (s, a) = (row[1] as usize, row[2]);
        let mut m = row[3..].to_vec();
        for k in s..32 {
            let inner = (1..s).fold(0, |sum, j| sum ^ ((a >> (s - 1 - j) & 1) * (m[k - j] << j)));
            m.push(m[k - s] << s ^ m[k - s] ^ inner);
        }
        let initial: Vec<u32> = m[..s].iter().map(|&m| m as u32).collect();
        let naive: [u32; 32] = core::array::from_fn(|k| (m[k] << (31 - k)) as u32);
        assert_eq!(directions(a as u32, &initial), naive, "{line}");
    }
}

#[test]
fn published_check_values() {
    let table = table();
    for (index, value) in
        [(1000, 692_060_160), (1001, 2_839_543_808), (1002, 3_913_285_632), (1003, 1_765_801_984), (1020, 20_971_520)]
    {
        assert_eq!(table.dimension(index, 1), value, "{index}");
    }
}

#[test]
fn the_first_four_are_the_computed_ones() {
    let table = table();
    for index in (0..5000).chain([0x7fff_ffff, 0x8000_0000, 0x1234_5678, u32::MAX]) {
        for d in 0..4 {
            assert_eq!(table.dimension(index, d), sobol::dimension(index, d), "index {index}, dimension {d}");
        }
    }
}

#[test]
fn every_dimension_is_stratified_for_every_power_of_two() {
    // A (0, 1)-sequence: number k has its last set bit at 2^-(k+1), and so has whatever the later ones leave of it.
    let table = table();
    for d in 0..1024 {
        for bit in 0..32 {
            assert_eq!(table.dimension(1 << bit, d).trailing_zeros(), 31 - bit, "dimension {d}, bit {bit}");
        }
    }
    // Counted, for some of them and for blocks at both ends.
    for d in [0, 1, 4, 15, 63, 255, 1000, 1023] {
        for m in 0..=12u32 {
            for start in [0, 1 << m, u32::MAX - ((1 << m) - 1)] {
                for scrambled in [false, true] {
                    let mut seen = vec![false; 1 << m];
                    for i in start..=start + ((1 << m) - 1) {
                        let value = if scrambled { table.owen(i, d, 3) } else { table.dimension(i, d) };
                        seen[(u64::from(value) >> (32 - m)) as usize] = true;
                    }
                    assert!(seen.iter().all(|hit| *hit), "dimension {d}, 2^{m} points from {start}");
                }
            }
        }
    }
}

#[test]
fn the_first_two_scrambled_dimensions_are_nets() {
    let table = table();
    for m in 0..=12u32 {
        for start in [0, 5 << m, u32::MAX - ((1 << m) - 1)] {
            let points: Vec<_> =
                (start..=start + ((1 << m) - 1)).map(|i| [table.owen(i, 0, 9), table.owen(i, 1, 9)]).collect();
            assert_net(&points, &format!("2^{m} points from {start}"));
        }
    }
}

#[test]
fn dimensions_beyond_the_table_are_as_independent_ones() {
    let first = core::array::from_fn(|bit| 1 << (31 - bit));
    let small: Directions<2> = Directions::new([first, directions(0, &[1])]);
    assert_eq!(small.dimension(77, 2), small.dimension(77, 0));
    assert_eq!(small.dimension(77, u32::MAX), small.dimension(77, 1));
    // Over 256 samples the joint strata of a dimension and of its repetition: random orders leave a square correlation
    // of 1/255 in the mean over seeds; two scrambles in one order would leave more than a half.
    let centred = |v: u32| f64::from(v) / 4_294_967_296.0 - 0.5;
    for (a, b) in [(0, 2), (1, 3), (0, 4), (2, 4), (3, u32::MAX)] {
        let square = |seed| {
            let sum: f64 = (0..256).map(|i| centred(small.owen(i, a, seed)) * centred(small.owen(i, b, seed))).sum();
            (12.0 * sum / 256.0).powi(2)
        };
        let mean = (0..200).map(|seed| square(mix(seed))).sum::<f64>() / 200.0;
        assert!(mean < 3.0 / 255.0, "dimensions {a} and {b}: {mean}");
    }
}
