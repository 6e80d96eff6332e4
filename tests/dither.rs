//! Halftoning: exact counts, order, naive twins, pictures, and the ends of every range.
#![allow(clippy::cast_possible_truncation, clippy::cast_possible_wrap, reason = "small numbers")]
#![allow(clippy::large_stack_arrays, reason = "the tests' own tiles")]

use bluedither::dither::quantise::{self, level, level_triangular, triangular};
use bluedither::dither::{RowError, Samples, alpha, ordered};
use bluedither::{Dither, ScalarMask};
use proptest::prelude::*;

/// Ranks in an order without symmetry, so that no table needs to be baked.
static MASK: ScalarMask<64> = {
    let mut ranks = [[0; 64]; 64];
    let mut p = 0;
    while p < 64 * 64 {
        ranks[p / 64][p % 64] = (p * 2531 % 4096) as u16;
        p += 1;
    }
    ScalarMask::new(ranks)
};

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

/// Every kind of threshold, by name.
fn kinds() -> Vec<(&'static str, Dither<'static>)> {
    vec![
        ("constant", Dither::constant(1 << 31)),
        ("random", Dither::random(7)),
        ("ordered", Dither::ordered(3)),
        ("ordered, large", Dither::ordered(8)),
        ("mask", Dither::blue(&MASK)),
        ("mask, moved", Dither::blue(&MASK).frame(5).origin(17, u32::MAX)),
    ]
}

/// The definition in rational numbers: `value` lies `rest`/`max` above a level, and rises above the threshold.
fn naive_level(value: u16, max: u16, levels: u16, threshold_fx: u32) -> u16 {
    if max == 0 || levels < 2 {
        return 0;
    }
    let scaled = u128::from(value.min(max)) * u128::from(levels - 1);
    let (lower, rest) = (scaled / u128::from(max), scaled % u128::from(max));
    (lower + u128::from(rest << 32 > u128::from(threshold_fx) * u128::from(max))) as u16
}

fn bit(bits: &[u8], x: usize) -> bool {
    bits[x / 8] >> (7 - x % 8) & 1 == 1
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

#[test]
fn rows_are_their_pixels() {
    for (name, dither) in kinds() {
        for width in [0usize, 1, 7, 8, 9, 63, 64, 65, 130, 200] {
            let eight: Vec<u8> = (0..3 * width).map(|i| (i * 37 + i / 5) as u8).collect();
            let wide: Vec<u16> = (0..3 * width).map(|i| (i * 2753 + i / 3) as u16).collect();
            for y in [0, 1, 77, u32::MAX] {
                check_row(name, dither, y, 255, &eight, Samples::U8(&eight));
                check_row(name, dither, y, 1023, &wide, Samples::U10(&wide));
                check_row(name, dither, y, 4095, &wide, Samples::U12(&wide));
                check_row(name, dither, y, 65535, &wide, Samples::U16(&wide));
                check_row("triangular", dither.triangular(), y, 255, &eight, Samples::U8(&eight));
                #[cfg(feature = "gamma")]
                check_row("gamma", dither.gamma(), y, 65535, &wide, Samples::U16(&wide));
                #[cfg(feature = "gamma")]
                check_row("gamma", dither.gamma(), y, 255, &eight, Samples::U8(&eight));
            }
        }
    }
}

/// All formats of one row against single pixels. The destinations are longer than needed: what is beyond must stay.
fn check_row<T: Copy + Into<u16>>(name: &str, dither: Dither<'_>, y: u32, max: u16, all: &[T], samples: Samples<'_>) {
    let width = all.len() / 3;
    let at = |p: usize, channel: u32, levels| dither.level(p as u32, y, channel, all[p].into(), max, levels);
    let rgb = |x: usize, levels: [u16; 3]| -> [u16; 3] {
        core::array::from_fn(|c| dither.level(x as u32, y, c as u32, all[3 * x + c].into(), max, levels[c]))
    };
    let mut bytes = vec![0xa5u8; 3 * width + 4];
    let gray = all.len();

    type Row<'a> = &'a dyn Fn(&mut [u8]) -> Result<(), RowError>;
    let rows: [(usize, Row<'_>); 3] = [
        (1, &|dst| dither.gray1_row(y, samples, dst)),
        (2, &|dst| dither.gray2_row(y, samples, dst)),
        (4, &|dst| dither.gray4_row(y, samples, dst)),
    ];
    for (bits, row) in rows {
        bytes.fill(0xa5);
        row(&mut bytes).expect("long enough");
        let used = (gray * bits).div_ceil(8);
        let mut naive = vec![0u8; used];
        for x in 0..gray {
            naive[x * bits / 8] |= (at(x, 0, 1 << bits) as u8) << (8 - bits - x * bits % 8);
        }
        assert_eq!(bytes[..used], naive, "{name}, row {y}: {gray} pixels of {bits} bits, source of {max}");
        assert!(bytes[used..].iter().all(|&byte| byte == 0xa5), "written beyond the row");
        if used > 0 {
            assert_eq!(row(&mut bytes[..used - 1]), Err(RowError::TooShort { needed: used, given: used - 1 }));
        }
    }
    bytes.fill(0xa5);
    dither.rgb332_row(y, samples, &mut bytes).expect("long enough");
    let mut words = vec![0xa5a5u16; width + 2];
    dither.rgb565_row(y, samples, &mut words).expect("long enough");
    let mut triples = vec![[9u8; 3]; width + 1];
    dither.levels_row(y, samples, [3, 17, 256], &mut triples).expect("long enough");
    for x in 0..width {
        let [r, g, b] = rgb(x, [8, 8, 4]);
        assert_eq!(u16::from(bytes[x]), r << 5 | g << 2 | b, "{name} 332 at {x}, {y} of {width}");
        let [r, g, b] = rgb(x, [32, 64, 32]);
        assert_eq!(words[x], r << 11 | g << 5 | b, "{name} 565 at {x}, {y} of {width}");
        assert_eq!(triples[x].map(u16::from), rgb(x, [3, 17, 256]), "{name} levels at {x}, {y} of {width}");
    }
    assert!(bytes[width] == 0xa5 && words[width] == 0xa5a5 && triples[width] == [9; 3], "written beyond the row");
    dither.rgb888_row(y, samples, &mut bytes).expect("long enough");
    for x in 0..width {
        assert_eq!([0, 1, 2].map(|c| u16::from(bytes[3 * x + c])), rgb(x, [256; 3]), "{name} 888 at {x}, {y}");
    }
}

#[test]
fn wrong_lengths_are_errors_and_write_nothing() {
    let dither = Dither::ordered(2);
    let mut words = [7; 3];
    assert_eq!(dither.rgb565_row(0, &[1u8; 10], &mut words), Err(RowError::PartOfAPixel { samples: 10, channels: 3 }));
    assert_eq!(dither.rgb565_row(0, &[1u8; 12], &mut words), Err(RowError::TooShort { needed: 4, given: 3 }));
    assert_eq!(dither.rgb565_row(0, &[1u16; 12], &mut words), Err(RowError::TooShort { needed: 4, given: 3 }));
    let rgba = [255; 7];
    assert_eq!(dither.stencil_row(0, &rgba, &mut [0]), Err(RowError::PartOfAPixel { samples: 7, channels: 4 }));
    assert_eq!(alpha::over_row(&rgba, [0; 3], &mut words), Err(RowError::PartOfAPixel { samples: 7, channels: 4 }));
    assert_eq!(alpha::over_row(&[9; 8], [0; 3], &mut words), Err(RowError::TooShort { needed: 6, given: 3 }));
    assert_eq!(words, [7; 3]);
    assert_eq!(dither.gray1_row(0, &[0u8; 0], &mut []), Ok(()), "an empty row");
    let line = RowError::TooShort { needed: 4, given: 3 }.to_string();
    assert_eq!(line, "the destination holds 3 numbers, and the row takes 4");
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

#[test]
fn triangular_is_monotone_and_has_its_distribution() {
    assert_eq!((triangular(0), triangular(u32::MAX)), (i32::MIN, i32::MAX));
    let mut last = i32::MIN;
    for k in 0..=1u64 << 16 {
        let u = (k << 16).min(u64::from(u32::MAX)) as u32;
        let t = triangular(u);
        assert!(t >= last, "at {u}");
        last = t;
        assert_eq!(t, !triangular(!u), "symmetric");
        // The share of a triangle below t is u.
        let t = f64::from(t) / f64::from(1u32 << 31);
        let below = if t < 0.0 { (1.0 + t) * (1.0 + t) / 2.0 } else { 1.0 - (1.0 - t) * (1.0 - t) / 2.0 };
        assert!((below - f64::from(u) / f64::from(u32::MAX)).abs() < 1e-8, "at {u}: {below}");
    }
    for u in [(1u32 << 31) - 2, (1 << 31) - 1, 1 << 31, u32::MAX - 1] {
        assert!(triangular(u) <= triangular(u + 1));
    }
}

/// The mean is the value, and half a level away from the ends the variance of the error is a quarter of a level's square.
#[test]
fn triangular_noise_keeps_mean_and_variance() {
    let n = 4096u32;
    for value in 0..=255 {
        let exact = f64::from(value) * 4.0 / 255.0;
        let (mut sum, mut square) = (0.0, 0.0);
        for k in 0..n {
            let found = f64::from(level_triangular(value, 255, 5, (2 * k + 1) << 19));
            sum += found;
            square += (found - exact) * (found - exact);
        }
        let (mean, variance) = (sum / f64::from(n), square / f64::from(n));
        assert!((mean - exact).abs() < 1e-3, "{value}: {mean} for {exact}");
        if (0.5..=3.5).contains(&exact) {
            assert!((variance - 0.25).abs() < 2e-3, "{value}: {variance}");
        }
    }
    assert!(
        (0..4096).all(|k| level_triangular(0, 255, 5, k << 20) == 0 && level_triangular(255, 255, 5, k << 20) == 4)
    );
}

#[test]
fn alpha_blends_exactly_and_stencils() {
    for alpha in 0..=255u8 {
        for (front, back) in [(0, 255), (255, 0), (17, 200), (255, 255), (1, 0)] {
            let exact = (f64::from(front) * f64::from(alpha) + f64::from(back) * (255.0 - f64::from(alpha))) / 65025.0;
            let found = alpha::over([front, back, front, alpha], [back, back, front])[0];
            assert!((f64::from(found) - exact * 65535.0).abs() <= 0.5, "{front} over {back} by {alpha}");
        }
    }
    assert_eq!(alpha::over([255, 0, 9, 255], [1, 2, 3]), [65535, 0, 9 * 257]);
    assert_eq!(alpha::over([255, 0, 9, 0], [255, 2, 0]), [65535, 2 * 257, 0]);
    let (opaque, clear) = ([1, 2, 3, 255].repeat(20), [200, 200, 200, 0].repeat(20));
    for (_, dither) in kinds() {
        let mut bits = [0; 3];
        dither.stencil_row(5, &opaque, &mut bits).expect("long enough");
        assert_eq!(bits, [0xff, 0xff, 0xf0]);
        dither.stencil_row(5, &clear, &mut bits).expect("long enough");
        assert_eq!(bits, [0; 3]);
        let half = [0, 0, 0, 128].repeat(20);
        dither.stencil_row(5, &half, &mut bits).expect("long enough");
        assert!((0..20).all(|x| u16::from(bit(&bits, x)) == dither.level(x as u32, 5, 3, 128, 255, 2)));
        #[cfg(feature = "gamma")]
        {
            let mut in_light = [0; 3];
            dither.gamma().stencil_row(5, &half, &mut in_light).expect("long enough");
            assert_eq!(in_light, bits, "alpha is no light");
        }
    }
}

#[cfg(feature = "float")]
#[test]
fn floats_are_clamped_and_rounded() {
    let src = [f32::NAN, f32::NEG_INFINITY, -1.0, 0.0, -0.0, 1.0, 2.0, f32::INFINITY];
    for (_, dither) in kinds() {
        let mut bits = [0];
        dither.gray1_row(3, &src, &mut bits).expect("long enough");
        assert_eq!(bits, [0b0000_0111]);
    }
    let floats: Vec<f32> = (0..=65535u16).map(|v| f32::from(v) / 65535.0).collect();
    let ints: Vec<u16> = (0..=65535).collect();
    let (mut a, mut b) = (vec![0; 8192], vec![0; 8192]);
    let dither = Dither::ordered(6);
    dither.gray1_row(1, &floats[..], &mut a).expect("long enough");
    dither.gray1_row(1, &ints[..], &mut b).expect("long enough");
    assert_eq!(a, b);
}

#[cfg(feature = "gamma")]
mod gamma {
    use super::*;
    use bluedither::dither::gamma::{from_linear, level, to_linear};

    #[test]
    fn linear_light_is_srgbs() {
        let naive = |v: f64| if v <= 0.04045 { v / 12.92 } else { ((v + 0.055) / 1.055).powf(2.4) };
        let mut last = 0;
        for v in 0..=65535u16 {
            let (found, exact) = (to_linear(v), naive(f64::from(v) / 65535.0) * 65535.0);
            let allowed = if v % 257 == 0 { 0.6 } else { 1.5 };
            assert!((f64::from(found) - exact).abs() < allowed, "{v}: {found} for {exact}");
            assert!(found >= last);
            last = found;
            let back = from_linear(found);
            assert!(back >= v && to_linear(back) == found);
        }
        assert_eq!((to_linear(0), to_linear(65535), from_linear(0) < 20, from_linear(65535)), (0, 65535, true, 65535));
    }

    #[test]
    fn the_mean_light_is_that_of_the_source() {
        for levels in [2u16, 4, 8, 32] {
            for value in (0..=255u16).step_by(5) {
                let mut sum = 0u64;
                for k in 0..4096u32 {
                    let level = level(value, 255, levels, (2 * k + 1) << 19);
                    sum += u64::from(to_linear(quantise::value(level, 65535, levels)));
                }
                let light = u64::from(to_linear(value * 257));
                assert!((sum / 4096).abs_diff(light) <= 16, "{value}, {levels} levels: {} for {light}", sum / 4096);
            }
        }
    }

    #[test]
    fn ends_and_nonsense_are_defined() {
        for threshold in [0, 1, 0x7fff_ffff, 0x8000_0000, u32::MAX] {
            assert_eq!(level(0, 255, 4, threshold), 0);
            assert_eq!(level(255, 255, 4, threshold), 3);
            assert_eq!(level(300, 255, 4, threshold), 3);
            assert_eq!(
                (level(9, 0, 4, threshold), level(9, 255, 0, threshold), level(9, 255, 1, threshold)),
                (0, 0, 0)
            );
            assert!(level(7, 65535, u16::MAX, threshold) <= 8);
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, cases: 2000, ..ProptestConfig::default() })]

    #[test]
    fn levels_are_as_defined(value: u16, max: u16, levels: u16, threshold: u32) {
        prop_assert_eq!(level(value, max, levels, threshold), naive_level(value, max, levels, threshold));
    }

    #[test]
    fn levels_are_monotone(value in 0u16..u16::MAX, max: u16, levels: u16, threshold in 0..u32::MAX) {
        for rule in [level, level_triangular] {
            let found = rule(value, max, levels, threshold);
            prop_assert!(rule(value + 1, max, levels, threshold) >= found, "in value");
            prop_assert!(rule(value, max, levels, threshold + 1) <= found, "in threshold");
            prop_assert!(found <= levels.saturating_sub(1));
            prop_assert_eq!(rule(value, 0, levels, threshold), 0);
            prop_assert_eq!(rule(0, max, levels, threshold), 0);
            prop_assert_eq!(rule(max, max, levels, threshold), if max == 0 { 0 } else { levels.saturating_sub(1) });
        }
    }

    #[test]
    fn a_level_is_its_own_value(level_in: u16, levels in 2u16..=256, threshold: u32) {
        let level_in = level_in % levels;
        // 255 and 65535 are multiples of these steps: the value is exact, and stays.
        for (max, steps) in [(255u16, [1u16, 3, 5, 15, 17, 51, 85, 255]), (65535, [1, 3, 5, 15, 17, 51, 85, 255])] {
            if steps.contains(&(levels - 1)) {
                prop_assert_eq!(level(quantise::value(level_in, max, levels), max, levels, threshold), level_in);
            }
        }
        prop_assert_eq!(quantise::value(levels - 1, 255, levels), 255);
    }
}
