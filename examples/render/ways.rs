//! Ways through time: a gradient in black and white, frame after frame, by white noise and by a mask that is moved in
//! place, moved in value, or made over time. Below each way the moving average that a display's viewer, or a temporal
//! filter, makes of its frames.
//!
//! ```text
//! cargo run --release --features seed-permutation,threshold-over-time-64 --example render -- --frames 16
//! ```

use bluedither::tables::{THRESHOLD_64, THRESHOLD_OVER_TIME_64};
use bluedither::{Dithered, White, unit};
use image::{Rgb, RgbImage};

/// Pixels on a side of a panel.
const SIDE: u32 = 128;
/// What a new frame weighs.
const PART: f32 = 0.1;
/// The names, from left to right.
pub const NAMES: &str = "white noise, place moved, values moved, mask over time";

/// A threshold for pixel (x, y) of a frame.
type Way = fn(u32, u32, u32) -> u32;
const WAYS: [Way; 4] = [
    |x, y, frame| White::new(1).pixel(x, y, frame).draw_fx::<1>(0, 0)[0],
    |x, y, frame| Dithered::new(1).pixel(x, y, frame).draw_fx::<1>(0, 0)[0],
    |x, y, frame| THRESHOLD_64.value_fx(x, y).wrapping_add(frame.wrapping_mul(0x9e37_79b9)),
    |x, y, frame| THRESHOLD_OVER_TIME_64.frame(frame).value_fx(x, y),
];

/// The pictures of an endless loop of `count` frames.
pub fn pictures(count: u32) -> Vec<RgbImage> {
    let width = WAYS.len() as u32 * SIDE;
    let mut average = vec![0.5; (width * SIDE) as usize];
    let mut picture = |frame: u32| {
        let mut picture = RgbImage::new(width, 2 * SIDE);
        for (x, y) in (0..SIDE).flat_map(|y| (0..width).map(move |x| (x, y))) {
            let wanted = (x % SIDE + y) as f32 / (2 * SIDE) as f32;
            let threshold = unit::to_f32(WAYS[(x / SIDE) as usize](x % SIDE, y, frame));
            let lit = f32::from(u8::from(threshold < wanted));
            let average = &mut average[(y * width + x) as usize];
            *average += PART * (lit - *average);
            picture.put_pixel(x, y, grey(lit));
            picture.put_pixel(x, SIDE + y, grey(*average));
        }
        picture
    };
    // The averages settle before the first that is kept.
    for frame in 0..4 * count.max(8) {
        picture(frame);
    }
    (4 * count.max(8)..4 * count.max(8) + count).map(picture).collect()
}

fn grey(value: f32) -> Rgb<u8> {
    Rgb([(value * 255.0 + 0.5) as u8; 3])
}
