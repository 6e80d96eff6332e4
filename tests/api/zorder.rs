//! The Z curve against a naive twin.

use bluedither::zorder;
use proptest::prelude::*;

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, cases: 2000, ..ProptestConfig::default() })]

    #[test]
    fn morton_interleaves(x: u32, y: u32) {
        let bit = |value: u32, k: u32| u64::from(value >> k & 1);
        let naive = (0..32).fold(0, |sum, k| sum | bit(x, k) << (2 * k) | bit(y, k) << (2 * k + 1));
        prop_assert_eq!(zorder::morton(x, y), naive);
        prop_assert_eq!(zorder::morton_16(x, y), naive as u32);
    }
}
