//! One figure for the build log: how blue a mask is.

/// RMS of the mask's values after a Gaussian of standard deviation 1 pixel, over what white noise would leave: 1 is
/// white, smaller is bluer. The mean over channels for vector masks. Printed, never stored: floats will do.
pub fn gain(ranks: &[u16], channels: usize, size: usize) -> f64 {
    let kernel: [f64; 11] = core::array::from_fn(|i| libm::exp(-0.5 * (i as f64 - 5.0) * (i as f64 - 5.0)));
    let total: f64 = kernel.iter().sum();
    let power: f64 = kernel.iter().map(|w| w * w).sum::<f64>() / (total * total);
    let gains = (0..channels).map(|channel| {
        let ranks = || ranks.iter().skip(channel).step_by(channels).map(|&rank| f64::from(rank));
        let mean = ranks().sum::<f64>() / (size * size) as f64;
        let values: Vec<f64> = ranks().map(|rank| rank - mean).collect();
        let blurred = blur_rows(&blur_rows(&values, size, &kernel), size, &kernel);
        let rms = |image: &[f64]| (image.iter().map(|v| v * v).sum::<f64>() / image.len() as f64).sqrt();
        rms(&blurred) / (total * total * rms(&values) * power)
    });
    gains.sum::<f64>() / channels as f64
}

/// Filters along x on the torus and transposes, so that twice filters along both.
fn blur_rows(image: &[f64], size: usize, kernel: &[f64]) -> Vec<f64> {
    let mut out = vec![0.0; image.len()];
    let mut pixel = 0;
    while pixel < image.len() {
        let (x, y) = (pixel % size, pixel / size);
        let mut sum = 0.0;
        let mut i = 0;
        while i < kernel.len() {
            sum += kernel[i] * image[y * size + (x + i + size - kernel.len() / 2) % size];
            i += 1;
        }
        out[x * size + y] = sum;
        pixel += 1;
    }
    out
}
