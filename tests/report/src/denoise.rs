//! A fixed edge-aware denoiser: the edge-avoiding à-trous wavelet filter of Dammertz et al. 2010, three levels.
//!
//! Its weights come from a guide without noise, as a renderer's surfaces are, and not from the picture itself. So it is
//! linear: what it leaves of the error is the filtered error image.

use crate::film::Image;
use glam::Vec3A;

/// Differences of the guide that count as an edge.
const EDGE: f32 = 0.05;
const LEVELS: u32 = 3;
/// The cubic B-spline.
const SPLINE: [f32; 5] = [1.0 / 16.0, 1.0 / 4.0, 3.0 / 8.0, 1.0 / 4.0, 1.0 / 16.0];

/// What the denoiser makes of an image, or leaves of an error.
pub fn denoise(image: &Image, guide: &Image) -> Image {
    let mut out = Image { size: image.size, pixels: image.pixels.clone() };
    for level in 0..LEVELS {
        out = pass(&out, guide, 1 << level);
    }
    out
}

/// One level: 5×5 taps, `step` pixels apart, clamped at the borders.
fn pass(image: &Image, guide: &Image, step: i32) -> Image {
    let [width, height] = image.size;
    Image::render(image.size, |x, y| {
        let own = guide.pixels[(y * width + x) as usize];
        let (mut sum, mut weights) = (Vec3A::ZERO, 0.0);
        for (dy, wy) in (-2..).zip(SPLINE) {
            for (dx, wx) in (-2..).zip(SPLINE) {
                let tap = |at: u32, by: i32, end: u32| at.saturating_add_signed(by * step).min(end - 1);
                let place = (tap(y, dy, height) * width + tap(x, dx, width)) as usize;
                let distance = (guide.pixels[place] - own).length_squared();
                let weight = wx * wy * (-distance / (EDGE * EDGE)).exp();
                sum += weight * image.pixels[place];
                weights += weight;
            }
        }
        sum / weights
    })
}

#[cfg(test)]
mod checks {
    use super::*;

    /// Constants stay, edges of the guide hold, flat noise is smoothed.
    #[test]
    fn it_smooths_and_keeps_edges() {
        let size = [64, 64];
        let guide = Image::render(size, |x, _| Vec3A::splat(if x < 32 { 0.0 } else { 1.0 }));
        let kept = denoise(&guide, &guide);
        assert!(kept.minus(&guide).pixels.iter().all(|p| p.length() < 1e-5));
        let noise = Image::render(size, |x, y| Vec3A::splat(if (x + y) % 2 == 0 { 1.0 } else { -1.0 }));
        // Out of reach of borders and edge, which are 2 + 4 + 8 pixels away at least.
        let smoothed = denoise(&noise, &guide);
        assert!((20..44).all(|y| (14..18).all(|x| smoothed.pixels[y * 64 + x].length() < 1e-5)));
    }
}
