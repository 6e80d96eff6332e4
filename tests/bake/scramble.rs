//! The scramble of the sequence that `ZOrder` deals out is what the search finds.

use bluedither::zorder;

use crate::columns::power::Power;
use crate::columns::scramble::{find, point};

#[test]
#[ignore = "searches for half a minute"]
fn frozen_scramble_is_what_the_search_finds() {
    let (_, found) = find(&Power::of_training());
    for bit in 0..32 {
        assert_eq!(zorder::point(1 << bit), point(&found, 1 << bit), "the search finds {found:#018x?}");
    }
}
