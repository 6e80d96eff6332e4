//! The error image and how much of it a viewer sees: F, G and R.

use super::integrands::Integrand;

/// A square image of errors with periodic borders, row by row.
#[derive(Clone, Debug)]
pub(crate) struct ErrorImage {
    /// Pixels on a side.
    pub(crate) size: usize,
    /// Estimate minus exact value; the mean is not removed.
    pub(crate) errors: Vec<f64>,
}

impl ErrorImage {
    /// The error of `estimate(x, y)` in every pixel.
    pub(crate) fn new(size: usize, exact: f64, estimate: impl Fn(u32, u32) -> f64) -> Self {
        let errors = (0..size * size).map(|p| estimate((p % size) as u32, (p / size) as u32) - exact).collect();
        Self { size, errors }
    }

    /// The error of the mean of an integrand over a pixel's samples; `samples(x, y, index)` is the sample.
    pub(crate) fn of_samples<P>(
        size: usize,
        spp: u32,
        integrand: &Integrand<P>,
        samples: impl Fn(u32, u32, u32) -> P,
    ) -> Self {
        Self::new(size, integrand.exact, |x, y| {
            (0..spp).map(|index| integrand.at(samples(x, y, index))).sum::<f64>() / f64::from(spp)
        })
    }

    /// Root mean square of the errors themselves.
    pub(crate) fn rms(&self) -> f64 {
        (self.errors.iter().map(|e| e * e).sum::<f64>() / self.errors.len() as f64).sqrt()
    }

    /// F: root mean square after a Gaussian filter of standard deviation `sigma` pixels.
    pub(crate) fn filtered_rms(&self, sigma: f64) -> f64 {
        self.filter(sigma).rms()
    }

    /// The image after a Gaussian filter of standard deviation `sigma` pixels: separable, direct.
    pub(crate) fn filter(&self, sigma: f64) -> Self {
        let kernel = kernel_1d(self.size, sigma);
        let rows = convolve_rows(&self.errors, self.size, &kernel);
        let both = transpose(&convolve_rows(&transpose(&rows, self.size), self.size, &kernel), self.size);
        Self { size: self.size, errors: both }
    }

    /// G: the filtered error over what white noise of the same root mean square would leave. White 1, blue below.
    pub(crate) fn gain(&self, sigma: f64) -> f64 {
        self.filtered_rms(sigma) / (self.rms() * kernel_norm(self.size, sigma))
    }

    /// F of the same values in random places: root of the mean F² over *all* orders of the pixels, in closed form.
    ///
    /// In a random order two different pixels have covariance −s²/(n−1), so the mean F² is
    /// m² + s²·(‖k‖² − 1/n)·n/(n−1), with mean m and variance s² of the n values.
    pub(crate) fn shuffled_filtered_rms(&self, sigma: f64) -> f64 {
        let n = self.errors.len() as f64;
        let mean = self.errors.iter().sum::<f64>() / n;
        let variance = self.errors.iter().map(|e| (e - mean) * (e - mean)).sum::<f64>() / n;
        let norm = kernel_norm(self.size, sigma);
        (mean * mean + variance * (norm * norm - 1.0 / n) * n / (n - 1.0)).sqrt()
    }
}

/// R of a family: filtered error of a mask over that of the same values in random places, both as the root of the
/// mean of squares over the images. With `normalised`, every image first is divided by its own root mean square, so
/// that integrands of different scale count alike. White 1, blue below.
pub(crate) fn relative_error(images: &[ErrorImage], sigma: f64, normalised: bool) -> f64 {
    let (mut ours, mut white) = (0.0, 0.0);
    for image in images {
        let scale = if normalised { image.rms() } else { 1.0 };
        if scale > 0.0 {
            ours += (image.filtered_rms(sigma) / scale).powi(2);
            white += (image.shuffled_filtered_rms(sigma) / scale).powi(2);
        }
    }
    (ours / white).sqrt()
}

/// ‖k‖₂ of the 2D kernel: what a filter leaves of white noise of variance 1.
pub(crate) fn kernel_norm(size: usize, sigma: f64) -> f64 {
    kernel_1d(size, sigma).iter().map(|weight| weight * weight).sum()
}

/// The 1D Gaussian kernel on a circle of `size` pixels, its weights summing to 1; entry 0 is the centre.
///
/// Wound around the circle as often as it takes: what is cut off beyond 7 sigma is below 10⁻¹⁰ of the centre.
pub(crate) fn kernel_1d(size: usize, sigma: f64) -> Vec<f64> {
    let mut kernel = vec![0.0; size];
    let reach = libm::ceil(7.0 * sigma) as i64;
    for d in -reach..=reach {
        let t = d as f64 / sigma;
        kernel[d.rem_euclid(size as i64) as usize] += libm::exp(-0.5 * t * t);
    }
    let sum: f64 = kernel.iter().sum();
    kernel.iter().map(|weight| weight / sum).collect()
}

fn convolve_rows(image: &[f64], size: usize, kernel: &[f64]) -> Vec<f64> {
    let mut out = vec![0.0; image.len()];
    for (row, out) in image.chunks_exact(size).zip(out.chunks_exact_mut(size)) {
        for (d, &weight) in kernel.iter().enumerate().filter(|(_, weight)| **weight != 0.0) {
            let (tail, head) = row.split_at(size - d);
            for (out, e) in out.iter_mut().zip(head.iter().chain(tail)) {
                *out += weight * e;
            }
        }
    }
    out
}

fn transpose(image: &[f64], size: usize) -> Vec<f64> {
    (0..image.len()).map(|p| image[p % size * size + p / size]).collect()
}
