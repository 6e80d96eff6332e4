//! From a value and a threshold to a level: the definition, order, ends, and the noise of each rule.

use bluedither::dither::quantise::{self, level, level_triangular, triangular};
use proptest::prelude::*;

/// The definition in rational numbers: `value` lies `rest`/`max` above a level, and rises above the threshold.
fn naive_level(value: u16, max: u16, levels: u16, threshold_fx: u32) -> u16 {
    if max == 0 || levels < 2 {
        return 0;
    }
    let scaled = u128::from(value.min(max)) * u128::from(levels - 1);
    let (lower, rest) = (scaled / u128::from(max), scaled % u128::from(max));
    (lower + u128::from(rest << 32 > u128::from(threshold_fx) * u128::from(max))) as u16
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

/// The mean is the value, and half a level away from the ends the variance of the error is a quarter of a level's
/// square.
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
