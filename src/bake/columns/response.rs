//! What a filter leaves of a Walsh function over a block, and its spectrum.

use crate::linear::BLOCK_LOG2;

/// Side of a block, pixels.
pub const BLOCK: usize = 1 << BLOCK_LOG2;
/// Walsh functions of a block; function w is that of x for its lower half of bits, times that of y for the upper.
pub const FUNCTIONS: usize = BLOCK * BLOCK;
/// Frequencies from 0 to half a cycle a pixel at which spectra are looked at.
pub const FREQUENCIES: usize = 33;

/// Responses of all functions; that of white noise is 1.
pub struct Responses {
    /// After a Gaussian of 1 pixel.
    pub sigma_1: Vec<f32>,
    /// What the searches minimise: with a twentieth of that after 2 pixels, lest low frequencies leak.
    pub both: Vec<f32>,
    /// Power of a function of one coordinate at every frequency, 1 in the mean.
    pub spectra: Vec<[f32; FREQUENCIES]>,
}

impl Responses {
    /// Of all functions of a block.
    pub fn new() -> Self {
        let (sigma_1, sigma_2) = (squared(&along(1.0)), squared(&along(2.0)));
        let both = sigma_1.iter().zip(&sigma_2).map(|(a, b)| a + 0.05 * b).collect();
        Self { sigma_1, both, spectra: (0..BLOCK).map(spectrum).collect() }
    }
}

/// The sign of Walsh function `w` at `i`.
fn sign(w: usize, i: usize) -> f64 {
    if (w & i).count_ones().is_multiple_of(2) { 1.0 } else { -1.0 }
}

/// Σ w(i)·w(j)·K(i−j)/side along an axis, K the Gaussian's autocorrelation; beyond the block all else is independent.
fn along(sigma: f64) -> Vec<f64> {
    let weight = |d: usize| libm::exp(-((d * d) as f64) / (4.0 * sigma * sigma));
    let power = |w: usize| -> f64 {
        let pairs = (0..BLOCK * BLOCK).map(|p| (p % BLOCK, p / BLOCK));
        pairs.map(|(i, j)| sign(w, i) * sign(w, j) * weight(i.abs_diff(j))).sum()
    };
    let all: Vec<f64> = (0..BLOCK).map(power).collect();
    let mean = all.iter().sum::<f64>() / BLOCK as f64;
    all.iter().map(|power| power / mean).collect()
}

fn squared(along: &[f64]) -> Vec<f32> {
    (0..FUNCTIONS).map(|w| (along[w % BLOCK] * along[w / BLOCK]) as f32).collect()
}

fn spectrum(w: usize) -> [f32; FREQUENCIES] {
    core::array::from_fn(|k| {
        let step = core::f64::consts::PI * k as f64 / (FREQUENCIES - 1) as f64;
        let (mut re, mut im) = (0.0, 0.0);
        for i in 0..BLOCK {
            re += sign(w, i) * libm::cos(step * i as f64);
            im += sign(w, i) * libm::sin(step * i as f64);
        }
        ((re * re + im * im) / BLOCK as f64) as f32
    })
}
