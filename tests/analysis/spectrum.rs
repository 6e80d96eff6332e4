//! Spectra: the power of an image at every frequency, what of it is low, and its radial average.

use rustfft::FftPlanner;
use rustfft::num_complex::Complex;

/// |DFT|² of a square image with its mean removed.
#[derive(Clone, Debug)]
pub(crate) struct Spectrum {
    size: usize,
    /// Row by row; frequency (0, 0) first. Divided by the number of pixels, so that the mean is the variance.
    pub(crate) power: Vec<f64>,
}

impl Spectrum {
    /// The spectrum of a square image, row by row.
    pub(crate) fn new(image: &[f64], size: usize) -> Self {
        assert_eq!(image.len(), size * size, "a square image");
        let mean = image.iter().sum::<f64>() / image.len() as f64;
        let mut data: Vec<_> = image.iter().map(|&v| Complex::new(v - mean, 0.0)).collect();
        let fft = FftPlanner::new().plan_fft_forward(size);
        fft.process(&mut data);
        let mut data: Vec<_> = (0..data.len()).map(|p| data[p % size * size + p / size]).collect();
        fft.process(&mut data);
        let n = image.len() as f64;
        // The second pass left the axes swapped.
        let power = (0..data.len()).map(|p| data[p % size * size + p / size].norm_sqr() / n).collect();
        Self::of_power(power, size)
    }

    /// Of powers that are known, row by row.
    pub(crate) fn of_power(power: Vec<f64>, size: usize) -> Self {
        assert_eq!(power.len(), size * size, "a square image");
        Self { size, power }
    }

    /// Mean power over 0 < |f| < `cutoff` cycles a pixel, over its mean for |f| > 0. White 1.
    pub(crate) fn low_frequency(&self, cutoff: f64) -> f64 {
        let (mut low, mut count) = (0.0, 0u32);
        for p in 1..self.power.len() {
            if self.frequency(p) < cutoff {
                low += self.power[p];
                count += 1;
            }
        }
        low / f64::from(count) / self.mean()
    }

    /// Mean power in rings of |f|, relative to the mean for |f| > 0: ring k holds k−½ ≤ |f|·size < k+½, up to the
    /// corner; ring 0 is empty and 0. Ulichney 1987.
    pub(crate) fn radial(&self) -> Vec<f64> {
        let rings = libm::ceil(self.size as f64 * core::f64::consts::FRAC_1_SQRT_2) as usize + 1;
        let (mut sum, mut count, mean) = (vec![0.0; rings], vec![0u32; rings], self.mean());
        for p in 1..self.power.len() {
            let ring = libm::round(self.frequency(p) * self.size as f64) as usize;
            sum[ring] += self.power[p] / mean;
            count[ring] += 1;
        }
        sum.iter().zip(&count).map(|(sum, &count)| sum / f64::from(count.max(1))).collect()
    }

    /// The largest power over the mean for |f| > 0: tells a regular texture. White: about the logarithm of the number
    /// of frequencies.
    pub(crate) fn spike(&self) -> f64 {
        let most = self.power.iter().fold(0.0, |most: f64, &power| most.max(power));
        if most > 0.0 { most / self.mean() } else { 0.0 }
    }

    /// |f| of entry `p` in cycles a pixel.
    fn frequency(&self, p: usize) -> f64 {
        let fold = |k: usize| k.min(self.size - k) as f64 / self.size as f64;
        libm::hypot(fold(p % self.size), fold(p / self.size))
    }

    fn mean(&self) -> f64 {
        self.power[1..].iter().sum::<f64>() / (self.power.len() - 1) as f64
    }
}

/// Low-frequency power of a mask: that of its ranks below .125 cycles a pixel, relative to white.
pub(crate) fn low_frequency_power(values: impl Iterator<Item = f64>, size: usize) -> f64 {
    Spectrum::new(&values.collect::<Vec<_>>(), size).low_frequency(0.125)
}
