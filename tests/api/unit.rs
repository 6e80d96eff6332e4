//! Fixed point to float and back: exact, rounded down, never 1.0.

use bluedither::unit::{from_f32, to_f32, to_f32s, to_f64};
use proptest::prelude::*;

const EXTREMES: [u32; 12] = [
    0,
    1,
    0xff,
    0x100,
    0x1ff,
    0x7fff_ffff,
    0x8000_0000,
    0x8000_0001,
    0xffff_feff,
    0xffff_ff00,
    0xffff_ff80, // rounds up to 1.0 where it is converted to the nearest float
    u32::MAX,
];

/// The definition: the largest multiple of 2⁻²⁴ that is not above value·2⁻³². Every step is exact in f64.
fn naive(value_fx: u32) -> f64 {
    (f64::from(value_fx) / 256.0).floor() / 16_777_216.0
}

#[test]
fn to_f32_is_the_floor_at_extremes_and_everywhere() {
    for value in EXTREMES.into_iter().chain((0..=u32::MAX).step_by(65_521)) {
        let float = to_f32(value);
        assert_eq!(f64::from(float).to_bits(), naive(value).to_bits(), "{value:#x}");
        assert!((0.0..1.0).contains(&float), "{value:#x}: {float}");
        assert!(f64::from(float) <= to_f64(value), "{value:#x} is rounded up");
    }
    assert_eq!(to_f32(u32::MAX).to_bits(), (1.0 - f32::EPSILON / 2.0).to_bits());
    assert_eq!(to_f32(0).to_bits(), 0);
    assert_eq!(to_f32(1 << 31).to_bits(), 0.5f32.to_bits());
}

/// Over every `step`-th number: the float never falls, and grows at each multiple of 2⁻²⁴ and nowhere else.
fn assert_monotone(step: u32) {
    let (mut before, mut last) = (0, to_f32(0));
    for value in (0..=u32::MAX).step_by(step as usize) {
        let float = to_f32(value);
        assert_eq!(float > last, value >> 8 > before >> 8, "{before:#x} and {value:#x}: {last} and {float}");
        assert!(float >= last && float < 1.0, "{before:#x} and {value:#x}: {last} and {float}");
        (before, last) = (value, float);
    }
}

#[test]
fn conversion_is_monotone_over_a_sample_of_all_numbers() {
    assert_monotone(251);
}

/// `cargo test --release --test api unit:: -- --ignored`: some seconds.
#[test]
#[ignore = "all 2³² numbers"]
fn conversion_is_monotone_over_all_numbers() {
    assert_monotone(1);
}

#[test]
fn to_f64_is_exact() {
    for value in EXTREMES {
        assert_eq!(to_f64(value) * 4_294_967_296.0, f64::from(value));
        assert!(to_f64(value) < 1.0);
    }
}

#[test]
fn from_f32_clamps() {
    for (float, value) in [
        (0.0, 0),
        (-0.0, 0),
        (-1.0, 0),
        (-f32::MIN_POSITIVE, 0),
        (f32::from_bits(1), 0), // the least subnormal
        (f32::MIN, 0),
        (f32::NEG_INFINITY, 0),
        (f32::NAN, 0),
        (-f32::NAN, 0),
        (0.5, 1 << 31),
        (1.0 / 4_294_967_296.0, 1),
        (0.999_999_9, 0xffff_fe00),
        (1.0 - f32::EPSILON / 2.0, 0xffff_ff00),
        (1.0, u32::MAX),
        (1.000_000_1, u32::MAX),
        (f32::MAX, u32::MAX),
        (f32::INFINITY, u32::MAX),
    ] {
        assert_eq!(from_f32(float), value, "{float}");
    }
}

#[test]
fn the_mean_of_all_floats_is_just_below_one_half() {
    // Multiples of 2⁻²⁴, each equally often: the mean of 2²⁴ of them is ½ − 2⁻²⁵.
    let sum: f64 = (0..1u32 << 24).map(|k| f64::from(to_f32(k << 8))).sum();
    assert_eq!(sum / f64::from(1u32 << 24), 0.5 - 0.5f64.powi(25));
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn there_and_back_clears_the_lower_8_bits(value: u32) {
        prop_assert_eq!(from_f32(to_f32(value)), value & !0xff);
    }

    #[test]
    fn order_is_kept(a: u32, b: u32) {
        prop_assert_eq!(a >> 8 < b >> 8, to_f32(a) < to_f32(b));
        prop_assert_eq!(a < b, to_f64(a) < to_f64(b));
    }

    #[test]
    fn from_f32_is_the_floor(float: f32) {
        let exact = (f64::from(float) * 4_294_967_296.0).floor();
        let expected = if exact >= 0.0 { exact.min(f64::from(u32::MAX)) } else { 0.0 };
        prop_assert_eq!(f64::from(from_f32(float)), expected);
    }

    #[test]
    fn from_f32_is_the_floor_inside(value: u32, below in 0u32..256) {
        // Floats between multiples of 2⁻²⁴ exist only below one half.
        let float = to_f32(value) / 256.0 + to_f32(below << 24) / 65536.0;
        let exact = (f64::from(float) * 4_294_967_296.0).floor();
        prop_assert_eq!(f64::from(from_f32(float)), exact);
    }

    #[test]
    fn components_are_independent(values: [u32; 4]) {
        prop_assert_eq!(to_f32s(values), values.map(to_f32));
        prop_assert_eq!(to_f32s([values[0]]), [to_f32(values[0])]);
    }
}
