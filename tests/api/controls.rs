//! The control: White is white.

use crate::common::{NO_CORRELATION, SIZE, correlation, image};
use bluedither::White;

#[test]
fn white_points_are_nets_of_their_own() {
    for (x, y) in [(0, 0), (1, 0), (u32::MAX, 5)] {
        let pixel = White::new(4).pixel(x, y, 2);
        for m in 0..=8u32 {
            for x_digits in 0..=m {
                let mut seen = vec![false; 1 << m];
                for index in 0..1 << m {
                    let [u, v] = pixel.draw_fx::<2>(3, index).map(u64::from);
                    seen[((u >> (32 - x_digits)) << (m - x_digits) | v >> (32 - (m - x_digits))) as usize] = true;
                }
                assert!(seen.iter().all(|hit| *hit), "the first 2^{m}, 2^-{x_digits} wide");
            }
        }
    }
}

#[test]
fn white_is_uncorrelated_between_pixels_and_uniform() {
    let sampler = White::new(5);
    let size = SIZE as u32;
    let here = image(SIZE, |x, y| sampler.pixel(x, y, 0).draw_fx::<1>(0, 0)[0]);
    for (right, down) in [(1, 0), (0, 1), (1, 1), (2, 0), (64, 0), (0, 64), (5, 7)] {
        let there = image(SIZE, |x, y| sampler.pixel(x + right, y + down, 0).draw_fx::<1>(0, 0)[0]);
        let r = correlation(&here, &there);
        assert!(r.abs() < NO_CORRELATION, "{right}, {down}: {r}");
    }
    // 4096 pixels in 64 bins: chi² of 63 degrees of freedom is 63 ± 11.
    let mut count = [0u32; 64];
    here.iter().for_each(|v| count[(v * 64.0) as usize] += 1);
    let expected = f64::from(size * size) / 64.0;
    let chi2: f64 = count.iter().map(|&n| (f64::from(n) - expected).powi(2) / expected).sum();
    assert!((30.0..120.0).contains(&chi2), "{chi2}");
}
