//! Elementary intervals, counted one by one.

/// Panics unless the points have exactly one in each elementary interval of area 1/points, of every shape.
pub(crate) fn assert_net(points: &[[u32; 2]], what: &str) {
    let m = points.len().trailing_zeros();
    assert!(points.len().is_power_of_two(), "{what}");
    for x_digits in 0..=m {
        let mut seen = vec![false; points.len()];
        for [x, y] in points {
            let column = u64::from(*x) >> (32 - x_digits);
            let row = u64::from(*y) >> (32 - (m - x_digits));
            let cell = (column << (m - x_digits) | row) as usize;
            assert!(!core::mem::replace(&mut seen[cell], true), "{what}: two points in one of 2^-{x_digits} wide");
        }
    }
}
