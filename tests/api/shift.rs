//! Cranley–Patterson offsets against rational arithmetic; which of them give every mask value its own pattern.

use bluedither::shift::{global, stratified_1d, stratified_2d};
use bluedither::{sobol, strata};
use proptest::prelude::*;

const EXTREMES: [u32; 6] = [0, 1, 0x7fff_ffff, 0x8000_0000, u32::MAX - 1, u32::MAX];

/// frac(a/2³² + b/2³²)·2³².
fn naive_sum(a: u32, b: u32) -> u32 {
    u32::try_from((i128::from(a) + i128::from(b)).rem_euclid(1 << 32)).expect("a remainder")
}

/// ⌊(cell + frac(local + v))/count·2³²⌋.
fn naive_stratified_1d(cell: u32, count: u32, local: u32, offset: u32) -> u32 {
    let count = u128::from(count.max(1));
    let numerator = (u128::from(cell) % count) * (1 << 32) + u128::from(naive_sum(local, offset));
    u32::try_from(numerator / count).expect("below 1")
}

/// The values of a scalar mask of 64² pixels.
fn mask_values() -> impl Iterator<Item = u32> {
    (0..4096).map(|rank| (2 * rank + 1) << 19)
}

/// How many different sets a pattern becomes over all mask values.
fn patterns<T: Ord>(pattern: impl Fn(u32) -> Vec<T>) -> usize {
    let mut all: Vec<Vec<T>> = mask_values()
        .map(|offset| {
            let mut points = pattern(offset);
            points.sort();
            points
        })
        .collect();
    all.sort();
    all.dedup();
    all.len()
}

#[test]
fn offsets_of_nothing_one_ulp_and_all_ones_are_exact() {
    for a in EXTREMES {
        for b in EXTREMES {
            assert_eq!(global([a], [b]), [naive_sum(a, b)]);
            for count in EXTREMES.into_iter().chain([3, 7, 1 << 20]) {
                for cell in EXTREMES {
                    assert_eq!(stratified_1d(cell, count, a, b), naive_stratified_1d(cell, count, a, b));
                    // In 2D an offset moves the point inside its cell and nothing else.
                    let inside = [naive_sum(a, b), naive_sum(b, a)];
                    assert_eq!(
                        stratified_2d(cell, count, [a, b], [b, a]),
                        strata::place_2d(cell, count, inside),
                        "{cell} of {count}"
                    );
                }
            }
        }
    }
    assert_eq!(global::<0>([], []), []);
}

#[test]
fn a_stratified_offset_gives_every_value_its_own_pattern() {
    for count in [1, 2, 3, 4, 5, 7, 8, 9, 16, 25, 64, 100, 1000] {
        let line = |offset| (0..count).map(|cell| stratified_1d(cell, count, 0, offset)).collect();
        assert_eq!(patterns(line), 4096, "{count} points in 1D");
        if count <= 100 {
            let square =
                |offset| (0..count).map(|cell| stratified_2d(cell, count, [0, 0], [offset, !offset])).collect();
            assert_eq!(patterns(square), 4096, "{count} points in 2D");
        }
    }
}

#[test]
fn a_global_offset_of_a_regular_pattern_is_many_to_one() {
    // v and v + 1/N give the same set: what stratified offsets are for.
    for count in [1u32, 2, 4, 16, 64] {
        let line = |offset| (0..count).map(|i| global([strata::regular_1d(i, count)], [offset])).collect();
        assert_eq!(patterns(line), 4096 / count as usize, "{count} points");
    }
}

#[test]
fn stratified_points_stay_in_their_cells() {
    for count in [1, 2, 3, 10, 64, 1000] {
        for cell in 0..count {
            let low = strata::place_1d(cell, count, 0);
            let high = strata::place_1d(cell, count, u32::MAX);
            for local in EXTREMES {
                for offset in EXTREMES {
                    assert!((low..=high).contains(&stratified_1d(cell, count, local, offset)));
                }
            }
        }
    }
}

#[test]
fn a_global_offset_keeps_the_mean_over_all_offsets() {
    // Every point meets every value of the mask once: uniform over the image, exactly.
    for point in [0u32, 0x1234_5678, u32::MAX] {
        let sum: u64 = mask_values().map(|offset| u64::from(global([point << 20], [offset])[0])).sum();
        assert_eq!(sum, 4096 * (1 << 31));
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, cases: 2000, ..ProptestConfig::default() })]

    #[test]
    fn global_is_the_sum_modulo_one(point: [u32; 4], offset: [u32; 4]) {
        let twin: Vec<u32> = point.iter().zip(&offset).map(|(&a, &b)| naive_sum(a, b)).collect();
        prop_assert_eq!(global(point, offset).to_vec(), twin);
    }

    #[test]
    fn stratified_is_the_rational(cell: u32, count: u32, local: u32, offset: u32) {
        prop_assert_eq!(stratified_1d(cell, count, local, offset), naive_stratified_1d(cell, count, local, offset));
    }

    #[test]
    fn a_common_offset_keeps_differences(index: u32, other: u32, offset: [u32; 2]) {
        let (a, b) = (sobol::point(index), sobol::point(other));
        let (moved_a, moved_b) = (global(a, offset), global(b, offset));
        for k in 0..2 {
            prop_assert_eq!(moved_a[k].wrapping_sub(moved_b[k]), a[k].wrapping_sub(b[k]));
        }
    }
}
