//! A pixel's whole set: as many samples as were asked for or fit, in order.
#![cfg(feature = "pattern")]

use bluedither::pattern::Pattern;
use bluedither::{Sampler, White};
use proptest::prelude::*;

#[test]
fn as_many_as_asked_for_or_as_fit() {
    for (count, length) in [(0, 0), (1, 1), (15, 15), (16, 16), (17, 16), (1 << 31, 16), (u32::MAX, 16)] {
        let pattern: Pattern<2, 16> = White::new(1).pixel(2, 3, 4).pattern(5, count);
        assert_eq!(pattern.len(), length, "{count}");
    }
}

#[test]
fn no_capacity_is_no_points() {
    assert!(White::new(1).pixel(0, 0, 0).pattern::<2, 0>(0, u32::MAX).is_empty());
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn it_holds_what_draw_gives(seed: u32, x: u32, y: u32, frame: u32, domain: u32, count in 0u32..40) {
        let pixel = White::new(seed).pixel(x, y, frame);
        let pattern: Pattern<3, 32> = pixel.pattern(domain, count);
        prop_assert_eq!(pattern.len() as u32, count.min(32));
        for (index, point) in pattern.iter().enumerate() {
            prop_assert_eq!(*point, pixel.draw::<3>(domain, index as u32));
        }
        let pixel = Sampler::new(seed).pixel(x, y, frame);
        let pattern: Pattern<1, 32> = pixel.pattern(domain, count);
        prop_assert!(pattern.iter().enumerate().all(|(index, point)| *point == pixel.draw::<1>(domain, index as u32)));
    }
}
