//! Linear pictures: rendered row by row in parallel, developed to sRGB, saved.

use glam::Vec3A;
use image::{Rgb, RgbImage};
use rayon::prelude::*;

/// Linear RGB, row by row.
pub struct Image {
    pub size: [u32; 2],
    pub pixels: Vec<Vec3A>,
}

impl Image {
    /// Every pixel by its own function of (x, y).
    pub fn render(size: [u32; 2], pixel: impl Fn(u32, u32) -> Vec3A + Sync) -> Self {
        let [width, height] = size;
        let pixels = (0..height).into_par_iter().flat_map_iter(|y| (0..width).map(move |x| (x, y)));
        Self { size, pixels: pixels.map(|(x, y)| pixel(x, y)).collect() }
    }

    /// `self` − `other`.
    pub fn minus(&self, other: &Self) -> Self {
        Self { size: self.size, pixels: self.pixels.iter().zip(&other.pixels).map(|(a, b)| *a - *b).collect() }
    }

    /// Tone-mapped for a display.
    pub fn develop(&self) -> RgbImage {
        self.convert(|linear| linear.map(|c| byte(srgb(tone(c)))))
    }

    /// Signed values around mid grey; ±`scale` is black and white.
    pub fn develop_signed(&self, scale: f32) -> RgbImage {
        self.convert(|error| error.map(|c| byte(0.5 + 0.5 * c / scale)))
    }

    fn convert(&self, colour: impl Fn([f32; 3]) -> [u8; 3]) -> RgbImage {
        let [width, height] = self.size;
        RgbImage::from_fn(width, height, |x, y| Rgb(colour(self.pixels[(y * width + x) as usize].to_array())))
    }
}

/// Reinhard's curve with a white point (2002, eq. 4): the darks nearly linear, the highlights rolled off.
fn tone(linear: f32) -> f32 {
    const EXPOSURE: f32 = 1.7;
    const WHITE: f32 = 2.0;
    let c = EXPOSURE * linear;
    c * (1.0 + c / (WHITE * WHITE)) / (1.0 + c)
}

fn srgb(linear: f32) -> f32 {
    if linear <= 0.003_130_8 { 12.92 * linear } else { 1.055 * linear.powf(1.0 / 2.4) - 0.055 }
}
fn byte(value: f32) -> u8 {
    (value * 255.0 + 0.5) as u8
}
