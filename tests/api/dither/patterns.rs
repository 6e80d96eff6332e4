//! Thresholds over the picture: exact counts in every tile, Bayer's matrix, places of channels and frames.

use bluedither::dither::ordered;
use bluedither::{Dither, ScalarMask};

use super::{MASK, bit};

/// Bayer's matrix as a mask of one's own.
fn bayer<const S: usize>() -> ScalarMask<S> {
    ScalarMask::new(core::array::from_fn(|y| core::array::from_fn(|x| naive_rank(x, y, S) as u16)))
}

/// Bayer's recursion as it is printed: 4·M + {0, 2; 3, 1}, quadrants by the lower bits.
fn naive_rank(x: usize, y: usize, size: usize) -> usize {
    if size == 1 {
        return 0;
    }
    let half = size / 2;
    4 * naive_rank(x % half, y % half, half) + [[0, 2], [3, 1]][y / half][x / half]
}

#[test]
fn constants_give_exactly_the_nearest_count_in_every_tile() {
    const S: usize = 64;
    let dither = Dither::blue(&MASK);
    for dither in [dither, dither.frame(3), dither.origin(13, 200), Dither::ordered(6)] {
        for v in 0..=255u8 {
            let mut ones = [0; 4];
            for y in 0..2 * S {
                let mut bits = [0; 2 * S / 8];
                dither.gray1_row(y as u32, &[v; 2 * S], &mut bits).expect("long enough");
                for x in 0..2 * S {
                    ones[x / S + 2 * (y / S)] += usize::from(bit(&bits, x));
                }
            }
            let exact = (2 * usize::from(v) * S * S + 255) / 510;
            assert_eq!(ones, [exact; 4], "value {v}");
        }
    }
}

/// The sum of levels over a tile is the nearest whole number, for any count of levels and depth of source.
#[test]
fn sums_of_levels_are_exact() {
    const S: usize = 16;
    let mask = bayer::<S>();
    let dither = Dither::blue(&mask);
    for (max, step) in [(255u16, 1), (1023, 3), (4095, 13), (65535, 211)] {
        for levels in [2u16, 3, 4, 5, 7, 8, 16, 17, 31, 64, 100, 255, 256] {
            for value in (0..=max).step_by(step) {
                let at = |p: usize| u64::from(dither.level((p % S) as u32, (p / S) as u32, 0, value, max, levels));
                let sum: u64 = (0..S * S).map(at).sum();
                let scaled = u64::from(value) * u64::from(levels - 1) * (S * S) as u64;
                assert_eq!(
                    sum,
                    (2 * scaled + u64::from(max)) / (2 * u64::from(max)),
                    "{value} of {max}, {levels} levels"
                );
            }
        }
    }
}

#[test]
fn ordered_is_bayers_matrix() {
    for size_log2 in 0..=6 {
        let size = 1usize << size_log2;
        for y in 0..2 * size {
            for x in 0..2 * size {
                let rank = naive_rank(x % size, y % size, size) as u64;
                let value = (2 * rank + 1) << (31 - 2 * size_log2);
                assert_eq!(u64::from(ordered::value_fx(x as u32, y as u32, size_log2)), value, "{x}, {y} of {size}");
            }
        }
    }
    assert_eq!(ordered::value_fx(3, 9, 99), ordered::value_fx(3, 9, ordered::MAX_LOG2));
    assert_eq!(ordered::value_fx(0, 0, ordered::MAX_LOG2), 2, "the largest has a half to spare");
}

/// Pictures that can be checked by eye.
#[test]
fn pictures() {
    let show = |dither: Dither<'_>, src: &[u8], height: u32| -> Vec<String> {
        let row = |y| {
            let mut bits = vec![0; src.len().div_ceil(8)];
            dither.gray1_row(y, src, &mut bits).expect("long enough");
            (0..src.len()).map(|x| if bit(&bits, x) { '#' } else { '.' }).collect()
        };
        (0..height).map(row).collect()
    };
    let ramp: Vec<u8> = (0..18).map(|x| x * 15).collect();
    assert_eq!(show(Dither::constant(1 << 31), &ramp, 1), [".........#########"]);
    assert_eq!(
        show(Dither::ordered(1), &ramp, 4),
        // Thresholds in 17ths: 2.1 and 10.6, then 14.9 and 6.4.
        ["....#.#.#.########", ".......#.#.#.#.###", "....#.#.#.########", ".......#.#.#.#.###"]
    );
}

/// Thresholds of frames and channels are those of other places, and no two of the first are the same.
#[test]
fn channels_and_frames_move_the_mask() {
    let mask = &MASK;
    let still = Dither::blue(mask);
    let mut first = Vec::new();
    for frame in 0..8 {
        for channel in 0..4 {
            let dither = still.frame(frame);
            let tile: Vec<u32> = (0..4096).map(|p| dither.threshold_fx(p % 64, p / 64, channel)).collect();
            let mut sorted = tile.clone();
            sorted.sort_unstable();
            sorted.dedup();
            assert_eq!(sorted.len(), 4096, "a permutation");
            if frame == 0 && channel == 0 {
                assert!(
                    (0..4096).all(|p| tile[p] == mask.value_fx(p as u32 % 64, p as u32 / 64)),
                    "where the user looks"
                );
            }
            assert!(!first.contains(&tile), "frame {frame}, channel {channel}");
            first.push(tile);
        }
    }
    assert_eq!(still.threshold_fx(3, 4, 6), still.threshold_fx(3, 4, 2), "beyond the fourth they repeat");
    let moved = still.origin(100, 9);
    assert_eq!(moved.threshold_fx(1, 2, 1), still.threshold_fx(101, 11, 1));
    let random = Dither::random(3);
    assert_ne!(random.threshold_fx(0, 0, 0), random.frame(1).threshold_fx(0, 0, 0));
    assert_ne!(random.threshold_fx(0, 0, 0), random.threshold_fx(0, 0, 1));
}
