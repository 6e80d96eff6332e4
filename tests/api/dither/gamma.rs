//! Linear light: the curve, the mean, the ends.

use bluedither::dither::gamma::{from_linear, level, to_linear};
use bluedither::dither::quantise;

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
        assert_eq!((level(9, 0, 4, threshold), level(9, 255, 0, threshold), level(9, 255, 1, threshold)), (0, 0, 0));
        assert!(level(7, 65535, u16::MAX, threshold) <= 8);
    }
}
