//! How large an error is, how much of it the eye or a filter leaves, and where its power lies.

use crate::film::Image;
use glam::Vec3A;
use image::{GrayImage, Luma};
use rayon::prelude::*;
use rustfft::{FftPlanner, num_complex::Complex32};

/// Standard deviations of the Gaussian filters in pixels.
pub const SIGMAS: [f32; 2] = [1.0, 2.1];

/// Side of the tiles whose spectra are averaged: the side of the masks, or their period would show as spikes.
const TILE: u32 = 64;

/// Root mean square over pixels and channels; the mean is not removed.
pub fn rms(error: &Image) -> f32 {
    let sum: f64 = error.pixels.iter().map(|p| f64::from(p.length_squared())).sum();
    let mean = (sum / (3 * error.pixels.len()) as f64) as f32;
    mean.sqrt()
}

/// Filtered by a Gaussian of that standard deviation, with periodic borders.
pub fn gaussian(error: &Image, sigma: f32) -> Image {
    let radius = (4.0 * sigma).ceil() as i32;
    let mut kernel: Vec<f32> = (-radius..=radius).map(|d| (-0.5 * (d as f32 / sigma).powi(2)).exp()).collect();
    let sum: f32 = kernel.iter().sum();
    kernel.iter_mut().for_each(|weight| *weight /= sum);

    let [width, height] = error.size.map(u32::cast_signed);
    let pass = |image: &Image, step: [i32; 2]| {
        Image::render(image.size, |x, y| {
            let taps = (-radius..=radius).zip(&kernel).map(|(d, weight)| {
                let [x, y] = [x.cast_signed() + d * step[0], y.cast_signed() + d * step[1]];
                *weight * image.pixels[(y.rem_euclid(height) * width + x.rem_euclid(width)) as usize]
            });
            taps.fold(Vec3A::ZERO, |sum, tap| sum + tap)
        })
    };
    pass(&pass(error, [1, 0]), [0, 1])
}

/// Mean periodogram of the error, DC in the centre, over half-overlapping Hann tiles and the channels.
pub fn spectrum(error: &Image) -> Vec<f32> {
    let [width, height] = error.size;
    let side = TILE as usize;
    let starts = |length: u32| (0..=length - TILE).step_by(side / 2);
    let corners: Vec<[u32; 2]> = starts(height).flat_map(|y| starts(width).map(move |x| [x, y])).collect();
    let fft = FftPlanner::new().plan_fft_forward(side);
    let hann = |i: u32| (core::f32::consts::PI * (i as f32 + 0.5) / TILE as f32).sin().powi(2);

    let periodograms = corners.par_iter().flat_map_iter(|corner| (0..3).map(move |channel| (corner, channel)));
    let power = periodograms.map(|(corner, channel)| {
        let mut tile: Vec<Complex32> = (0..TILE * TILE)
            .map(|i| {
                let [x, y] = [i % TILE, i / TILE];
                let pixel = error.pixels[((corner[1] + y) * width + corner[0] + x) as usize];
                Complex32::from(pixel[channel] * hann(x) * hann(y))
            })
            .collect();
        // Rows, transpose, rows: the result is transposed, and put right while it is centred.
        fft.process(&mut tile);
        let mut turned: Vec<Complex32> = (0..side * side).map(|i| tile[i % side * side + i / side]).collect();
        fft.process(&mut turned);
        let centred = |i: usize| [(i % side + side / 2) % side, (i / side + side / 2) % side];
        (0..side * side).map(centred).map(|[x, y]| turned[x * side + y].norm_sqr()).collect::<Vec<f32>>()
    });
    power.reduce(|| vec![0.0; side * side], |sum, tile| sum.iter().zip(&tile).map(|(a, b)| a + b).collect())
}

/// Log power as a picture: from a hundredth of `white`, black, to ten times that, white.
pub fn develop_spectrum(power: &[f32], white: f32) -> GrayImage {
    GrayImage::from_fn(TILE, TILE, |x, y| {
        let decades = (power[(y * TILE + x) as usize] / white).max(1e-9).log10();
        let level = ((decades + 2.0) / 3.0 * 255.0) as u8;
        Luma([level])
    })
}

/// Mean over all frequencies.
pub fn mean_power(power: &[f32]) -> f32 {
    power.iter().sum::<f32>() / power.len() as f32
}
