//! Local spike: the strongest frequency of a small window of an error image over the mean of its power, the mean of the
//! window left out. Averages over seeds, or over a whole image, hide a texture that every single picture shows.
//!
//! White noise has 7, a void-and-cluster mask 8; lines and tiles have tens.

use crate::field::SIZE;
use rustfft::num_complex::Complex32;
use rustfft::{Fft, FftPlanner};
use std::sync::Arc;

/// Pixels on a side of a window.
pub const WINDOW: usize = 32;
/// Windows of an image, side by side.
pub const WINDOWS: usize = (SIZE / WINDOW).pow(2);

/// The transform, planned once.
pub struct Spikes {
    fft: Arc<dyn Fft<f32>>,
}

impl Spikes {
    pub fn new() -> Self {
        Self { fft: FftPlanner::new().plan_fft_forward(WINDOW) }
    }

    /// The spikes of all windows of two images; a window without any error has none.
    pub fn of(&self, [a, b]: [&[f32]; 2], found: &mut Vec<f32>) {
        let mut data = [Complex32::ZERO; WINDOW * WINDOW];
        let mut turned = data;
        let mut scratch = vec![Complex32::ZERO; self.fft.get_inplace_scratch_len()];
        for window in 0..WINDOWS {
            let corner = window / (SIZE / WINDOW) * WINDOW * SIZE + window % (SIZE / WINDOW) * WINDOW;
            for (y, row) in data.chunks_exact_mut(WINDOW).enumerate() {
                let from = corner + y * SIZE;
                for ((z, &a), &b) in row.iter_mut().zip(&a[from..]).zip(&b[from..]) {
                    *z = Complex32::new(a, b);
                }
            }
            self.fft.process_with_scratch(&mut data, &mut scratch);
            for (k, z) in turned.iter_mut().enumerate() {
                *z = data[k % WINDOW * WINDOW + k / WINDOW];
            }
            self.fft.process_with_scratch(&mut turned, &mut scratch);
            let (mut most, mut sum, mut mean) = ([0.0f32; 2], [0.0f32; 2], [0.0f32; 2]);
            for (k, &z) in turned.iter().enumerate() {
                // The spectrum of a real image is conjugate-symmetric: that tells the two apart.
                let mirror = (WINDOW - k / WINDOW) % WINDOW * WINDOW + (WINDOW - k % WINDOW) % WINDOW;
                let m = turned[mirror].conj();
                for (image, power) in [(z + m).norm_sqr(), (z - m).norm_sqr()].into_iter().enumerate() {
                    if k == 0 {
                        mean[image] = power;
                    } else {
                        most[image] = most[image].max(power);
                        sum[image] += power;
                    }
                }
            }
            let count = (WINDOW * WINDOW - 1) as f32;
            // What rounding leaves of a constant, or of nothing, is no texture.
            let is_flat = |k: usize| sum[k] <= 1e-9 * mean[k] || sum[k] < 1e-12;
            found.extend([0, 1].into_iter().filter(|&k| !is_flat(k)).map(|k| most[k] * count / sum[k]));
        }
    }
}

/// Median and worst; zeros if there are none.
pub fn median_and_worst(spikes: &mut [f32]) -> [f32; 2] {
    spikes.sort_unstable_by(f32::total_cmp);
    [spikes.get(spikes.len() / 2), spikes.last()].map(|spike| spike.copied().unwrap_or(0.0))
}

#[cfg(test)]
mod checks {
    use super::*;
    use crate::analysis::random::Random;
    use crate::field::PIXELS;

    fn image(value: impl FnMut(usize) -> f32) -> Vec<f32> {
        (0..PIXELS).map(value).collect()
    }

    fn spikes(a: &[f32], b: &[f32]) -> Vec<f32> {
        let mut found = Vec::new();
        Spikes::new().of([a, b], &mut found);
        found
    }

    /// A checker has all its power at one frequency of 1023, a row of cells that are two pixels wide at two; a constant
    /// beside it makes no difference, and by itself has none.
    #[test]
    fn checkers_and_stripes_have_theirs() {
        let checker = image(|p| 0.3 + if (p % SIZE + p / SIZE).is_multiple_of(2) { 1.0 } else { -1.0 });
        let stripes = image(|p| if (p % SIZE / 2).is_multiple_of(2) { 1.0 } else { -1.0 });
        let found = spikes(&checker, &stripes);
        assert_eq!(found.len(), 2 * WINDOWS);
        for pair in found.chunks_exact(2) {
            assert!((pair[0] - 1023.0).abs() < 0.1, "{}", pair[0]);
            // A square wave of period four has its first and third harmonic at 8 and 24 of 32, which mirror each other.
            assert!((pair[1] - 511.5).abs() < 0.1, "{}", pair[1]);
        }
        assert!(spikes(&image(|_| 0.25), &image(|_| 0.0)).is_empty());
    }

    /// A checker as strong as the noise below it has half the power: 512, and the noise's own.
    #[test]
    fn a_checker_in_noise_is_found() {
        let mut random = Random::new(7);
        let noise = image(|_| random.normal() as f32);
        let both = image(|p| noise[p] + if (p % SIZE + p / SIZE).is_multiple_of(2) { 1.0 } else { -1.0 });
        let mut found = spikes(&both, &both);
        let [median, _] = median_and_worst(&mut found);
        assert!((460.0..560.0).contains(&median), "{median}");
    }

    /// White noise: the largest of 511 exponential numbers, some 7.
    #[test]
    fn white_noise_has_seven() {
        let mut random = Random::new(8);
        let [a, b] = [0; 2].map(|_| image(|_| random.normal() as f32));
        let [median, worst] = median_and_worst(&mut spikes(&a, &b));
        assert!((6.0..8.0).contains(&median) && worst < 14.0, "{median} {worst}");
    }
}
