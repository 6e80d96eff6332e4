//! Strata against rational arithmetic written out: equal areas, one point a cell, orders that are bijections.

use bluedither::hash::mix;
use bluedither::strata::{jittered_1d, jittered_2d, permute, place_1d, place_2d, regular_1d, regular_2d, turn};
use proptest::prelude::*;

const COUNTS: [u32; 14] = [
    0,
    1,
    2,
    3,
    7,
    1 << 16,
    (1 << 16) + 1,
    99_999_989,
    (1 << 31) - 1,
    1 << 31,
    (1 << 31) + 1,
    u32::MAX / 3,
    u32::MAX - 1,
    u32::MAX,
];
const INSIDES: [u32; 5] = [0, 1, 0x8000_0000, u32::MAX - 1, u32::MAX];

/// The cells of a count: 0 counts as 1.
fn cells(count: u32) -> u128 {
    u128::from(count.max(1))
}

/// ⌊(cell + inside/2³²)/count·2³²⌋.
fn naive_1d(cell: u32, count: u32, inside: u32) -> u32 {
    let numerator = (u128::from(cell) % cells(count)) * (1 << 32) + u128::from(inside);
    u32::try_from(numerator / cells(count)).expect("below 1")
}

/// The integer nearest to √count, no ties: the first r with (r + ½)² > count.
fn naive_rows(count: u32) -> u128 {
    let four = 4 * cells(count);
    let (mut low, mut high) = (0u128, 1 << 17);
    while low < high {
        let r = (low + high) / 2;
        if (2 * r + 1) * (2 * r + 1) > four { high = r } else { low = r + 1 }
    }
    low
}

/// The row, its first cell and its number of cells, by looking at every row.
fn naive_row(cell: u128, count: u32) -> (u128, u128) {
    let rows = naive_rows(count);
    for row in 0..rows {
        let (first, end) = (row * cells(count) / rows, (row + 1) * cells(count) / rows);
        if (first..end).contains(&cell) {
            return (first, end - first);
        }
    }
    panic!("cell {cell} of {count} is in no row")
}

/// x = (cell − first + inside_x)/n and y = (first + n·inside_y)/count in 0.32, for a row of n cells.
fn naive_2d(cell: u32, count: u32, inside: [u32; 2]) -> [u32; 2] {
    let cell = u128::from(cell) % cells(count);
    let (first, n) = naive_row(cell, count);
    let x = ((cell - first) * (1 << 32) + u128::from(inside[0])) / n;
    let y = (first * (1 << 32) + n * u128::from(inside[1])) / cells(count);
    [x, y].map(|v| u32::try_from(v).expect("below 1"))
}

#[test]
fn places_at_extremes_are_exact() {
    for count in COUNTS {
        for cell in [0, 1, 2, count / 2, count.wrapping_sub(1), count, count.wrapping_add(1), u32::MAX] {
            for inside in INSIDES {
                let found = place_1d(cell, count, inside);
                assert_eq!(found, naive_1d(cell, count, inside), "{inside} in {cell} of {count}");
                for other in [0, u32::MAX] {
                    for inside in [[inside, other], [other, inside]] {
                        let found = place_2d(cell, count, inside);
                        assert_eq!(found, naive_2d(cell, count, inside), "{inside:?} in {cell} of {count}");
                    }
                }
            }
        }
    }
}

#[test]
fn every_cell_of_every_small_count() {
    for count in 1..=400 {
        for cell in 0..count {
            for inside in [0, 0x5555_5555, u32::MAX] {
                assert_eq!(place_1d(cell, count, inside), naive_1d(cell, count, inside));
                let inside = [inside, !inside];
                assert_eq!(place_2d(cell, count, inside), naive_2d(cell, count, inside), "{cell} of {count}");
            }
        }
    }
}

#[test]
fn rows_are_as_many_as_the_nearest_root() {
    // y takes one corner value a row.
    for count in (1..=2000).chain([65_535, 65_536, 65_792, 65_793]) {
        let mut corners: Vec<u32> = (0..count).map(|cell| regular_2d(cell, count)[1]).collect();
        corners.dedup();
        let root = f64::from(count).sqrt().round();
        assert_eq!(corners.len() as f64, root, "{count}");
        assert!(corners.windows(2).all(|pair| pair[0] < pair[1]), "{count}: rows from low to high");
    }
}

#[test]
fn a_square_count_is_a_regular_grid() {
    for side in [1u32, 2, 3, 8, 10, 255] {
        for cell in 0..side * side {
            let [x, y] = regular_2d(cell, side * side);
            let corner = |k: u32| ((u64::from(k) << 32) / u64::from(side)) as u32;
            assert_eq!([x, y], [corner(cell % side), corner(cell / side)], "{cell} of {side}²");
        }
    }
}

#[test]
fn cells_have_equal_areas_and_fill_the_square() {
    for count in (1..=300).chain([1000, 1999, 2000]) {
        let mut area = 0.0;
        let mut last_row = u32::MAX;
        for cell in 0..count {
            let low = place_2d(cell, count, [0, 0]);
            let high = place_2d(cell, count, [u32::MAX, u32::MAX]);
            let side = |k: usize| f64::from(high[k]) - f64::from(low[k]) + 1.0;
            // Corners are rounded down to 2⁻³², so a side is off by less than that.
            let share = side(0) * side(1) / 2f64.powi(64) * f64::from(count);
            assert!((share - 1.0).abs() < 1e-6, "{cell} of {count}: {share}");
            // The first cell of a row starts at 0, the next ones where the last one ended.
            if low[1] == last_row {
                let before = place_2d(cell - 1, count, [u32::MAX, 0])[0];
                assert!(low[0] - before <= 1, "{cell} of {count}: a gap");
            } else {
                assert_eq!(low[0], 0, "{cell} of {count}");
            }
            last_row = low[1];
            area += side(0) * side(1) / 2f64.powi(64);
        }
        assert!((area - 1.0).abs() < 1e-6, "{count}: {area}");
    }
}

#[test]
fn regular_is_the_corner_and_jitter_stays_inside() {
    for count in [1, 2, 3, 5, 16, 100, 1000] {
        for cell in 0..count {
            assert_eq!(regular_1d(cell, count), place_1d(cell, count, 0));
            assert_eq!(regular_2d(cell, count), place_2d(cell, count, [0; 2]));
            for seed in [0, 1, u32::MAX] {
                let x = jittered_1d(cell, count, seed);
                assert!((place_1d(cell, count, 0)..=place_1d(cell, count, u32::MAX)).contains(&x));
                let point = jittered_2d(cell, count, seed);
                let (low, high) = (place_2d(cell, count, [0; 2]), place_2d(cell, count, [u32::MAX; 2]));
                assert!((0..2).all(|k| (low[k]..=high[k]).contains(&point[k])), "{cell} of {count}");
            }
        }
    }
}

#[test]
fn jitter_is_uniform_and_its_axes_are_unrelated() {
    let centred = |v: u32| f64::from(v) / 4_294_967_296.0 - 0.5;
    let (mut mean, mut square, mut product, mut neighbours) = (0.0, 0.0, 0.0, 0.0);
    let rounds = 4096;
    for seed in 0..rounds {
        let [x, y] = jittered_2d(0, 1, seed).map(centred);
        let next = centred(jittered_1d(1, 1, seed));
        mean += x;
        square += 12.0 * x * x;
        product += 12.0 * x * y;
        neighbours += 12.0 * x * next;
    }
    for (sum, expected) in [(mean, 0.0), (square, 1.0), (product, 0.0), (neighbours, 0.0)] {
        let found = sum / f64::from(rounds);
        assert!((found - expected).abs() < 0.07, "{found} is not {expected}");
    }
}

#[test]
fn permute_is_a_bijection_for_every_count() {
    for count in 0..=2000u32 {
        for seed in [0, 1, 0x8000_0000, u32::MAX, mix(count)] {
            let mut seen = vec![false; count.max(1) as usize];
            for index in 0..count.max(1) {
                let cell = permute(index, count, seed) as usize;
                assert!(!core::mem::replace(&mut seen[cell], true), "seed {seed}: {cell} of {count} twice");
            }
        }
    }
}

#[test]
fn permute_takes_its_index_modulo_the_count() {
    for count in COUNTS {
        let n = count.max(1);
        for index in [n, n.wrapping_add(n / 2), u32::MAX / 2, u32::MAX] {
            assert_eq!(permute(index, count, 7), permute(index % n, count, 7), "{index} of {count}");
        }
    }
}

#[test]
fn permute_ends_soon_for_awkward_counts() {
    // Just above a power of two half of the numbers fall outside and are mapped again: two rounds in the mean, some
    // tens at worst. This would take minutes if walks were long.
    for count in [3, 1025, 65_537, (1 << 20) + 1, (1 << 31) - 1, (1 << 31) + 1, (1 << 31) + 3, u32::MAX] {
        for seed in (0..50).map(mix).chain([0, 1, u32::MAX]) {
            let mut cells: Vec<u32> = (0..2000u32)
                .map(|k| permute(k.wrapping_mul(0x9e37_79b9) % count, count, seed))
                .inspect(|cell| assert!(*cell < count))
                .collect();
            if count > 1 << 30 {
                cells.sort_unstable();
                assert!(cells.windows(2).all(|pair| pair[0] < pair[1]), "seed {seed}: two alike of {count}");
            }
        }
    }
}

#[test]
fn every_index_meets_every_cell_equally_often() {
    // Over seeds: or a pixel that stops early would be biased.
    let rounds = 20_000u32;
    for count in [2u32, 3, 4, 5, 6, 7, 11, 16, 24] {
        let mut hits = vec![0u32; (count * count) as usize];
        for seed in 0..rounds {
            for index in 0..count {
                hits[(index * count + permute(index, count, seed)) as usize] += 1;
            }
        }
        let expected = f64::from(rounds) / f64::from(count);
        let worst = hits.iter().map(|&n| (f64::from(n) - expected).abs() / expected.sqrt()).fold(0.0, f64::max);
        assert!(worst < 5.0, "{count}: a cell is {worst:.1} standard deviations off");
    }
}

#[test]
fn first_and_last_meet_in_every_way() {
    // Over plain seeds, as users count them.
    for count in [4u32, 8, 16] {
        let mut met = vec![false; (count * count) as usize];
        for seed in 0..20_000 {
            met[(permute(0, count, seed) * count + permute(count - 1, count, seed)) as usize] = true;
        }
        let pairs = met.iter().filter(|&&pair| pair).count() as u32;
        assert_eq!(pairs, count * (count - 1), "{count}: pairs of cells that occur");
    }
}

#[test]
fn runs_of_a_power_of_two_are_spread() {
    // 2ᵏ indices from a multiple of 2ᵏ on: one in each 2ᵏ-th of the cells.
    for m in 0..=10u32 {
        for seed in [0, 1, mix(1), mix(2), u32::MAX] {
            for k in 0..=m {
                for start in (0..1u32 << m).step_by(1 << k) {
                    let mut parts = vec![false; 1 << k];
                    (0..1 << k).for_each(|i| parts[permute(start + i, 1 << m, seed) as usize >> (m - k)] = true);
                    assert!(parts.iter().all(|hit| *hit), "2^{k} of 2^{m} from {start}, seed {seed}");
                }
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, cases: 2000, ..ProptestConfig::default() })]

    #[test]
    fn place_1d_is_the_rational(cell: u32, count: u32, inside: u32) {
        prop_assert_eq!(place_1d(cell, count, inside), naive_1d(cell, count, inside));
    }

    #[test]
    fn place_2d_is_the_rational(cell: u32, count in 0u32..100_000, inside: [u32; 2]) {
        prop_assert_eq!(place_2d(cell, count, inside), naive_2d(cell, count, inside));
    }

    #[test]
    fn permute_is_one_to_one_for_great_counts(a: u32, b: u32, count: u32, seed: u32) {
        let n = count.max(1);
        let (to_a, to_b) = (permute(a, count, seed), permute(b, count, seed));
        prop_assert!(to_a < n && to_b < n);
        prop_assert_eq!(a % n == b % n, to_a == to_b);
    }
}

#[test]
fn a_turn_is_a_shift_of_all_cells() {
    for count in [1, 2, 3, 7, 64, 1000, u32::MAX] {
        for by in [0, 1, 0x7fff_ffff, 0x8000_0000, u32::MAX] {
            let steps = (u128::from(by) * u128::from(count)) >> 32;
            for cell in [0, 1, count / 2, count - 1, u32::MAX] {
                let naive = (u128::from(cell) + steps) % u128::from(count);
                assert_eq!(u128::from(turn(cell, count, by)), naive, "{cell} of {count} by {by}");
            }
        }
    }
}
