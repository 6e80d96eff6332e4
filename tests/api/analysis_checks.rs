//! The measuring instruments themselves: what they read on inputs whose answer is known.

use crate::analysis::SIGMAS;
use crate::analysis::discrepancy::l2_star;
use crate::analysis::error::{ErrorImage, kernel_1d, kernel_norm, relative_error};
use crate::analysis::half_plane::HalfPlane;
use crate::analysis::integrands::{
    DRAWS, Integrand, evaluation_half_plane_2d, evaluation_smooth_1d, evaluation_smooth_2d, evaluation_step_1d,
    half_plane_2d, smooth_1d, smooth_2d, step_1d,
};
use crate::analysis::random::{Random, seeds};
use crate::analysis::soft_edge::SoftEdge;
use crate::analysis::spectrum::Spectrum;

fn white_image(size: usize, seed: u64) -> ErrorImage {
    let mut random = Random::new(seed);
    ErrorImage { size, errors: (0..size * size).map(|_| random.normal()).collect() }
}

/// Midpoint rule over n cells.
fn midpoint_1d(n: u32, f: impl Fn(f64) -> f64) -> f64 {
    (0..n).map(|k| f((f64::from(k) + 0.5) / f64::from(n))).sum::<f64>() / f64::from(n)
}

/// Composite Gauss–Legendre rule of two points in n×n cells: an error of order n⁻⁴ where f is smooth.
fn gauss_2d(n: u32, f: impl Fn([f64; 2]) -> f64) -> f64 {
    let reach = 0.5 / 3f64.sqrt();
    let nodes: Vec<f64> =
        (0..n).flat_map(|k| [0.5 - reach, 0.5 + reach].map(|t| (f64::from(k) + t) / f64::from(n))).collect();
    nodes.iter().map(|&y| nodes.iter().map(|&x| f([x, y])).sum::<f64>()).sum::<f64>() / (4.0 * f64::from(n * n))
}

#[test]
fn families_have_their_sizes_and_their_own_seeds() {
    assert_eq!((smooth_1d(0).len(), step_1d(0).len(), smooth_2d(0).len(), half_plane_2d(0).len()), (12, 24, 10, 64));
    let draws = DRAWS as usize;
    assert_eq!(evaluation_smooth_1d().len(), 12 * draws);
    assert_eq!(evaluation_step_1d().len(), 24 * draws);
    assert_eq!(evaluation_smooth_2d().len(), 10 * draws);
    assert_eq!(evaluation_half_plane_2d().len(), 64);
    let seeds = [seeds::SMOOTH_1D, seeds::STEP_1D, seeds::SMOOTH_2D, seeds::HALF_PLANE_2D, seeds::WHITE];
    for (k, a) in seeds.iter().enumerate() {
        assert!(seeds[..k].iter().all(|b| a.abs_diff(*b) > 100), "seed {a:x} is used twice");
    }
    // Another seed is another draw, the same seed the same.
    assert_eq!(half_plane_2d(1)[0].exact.to_bits(), half_plane_2d(1)[0].exact.to_bits());
    assert_ne!(half_plane_2d(1)[0].exact.to_bits(), half_plane_2d(2)[0].exact.to_bits());
}

#[test]
fn exact_values_of_1d_families() {
    for f in evaluation_smooth_1d() {
        let brute = midpoint_1d(1 << 17, |x| f.at(x));
        assert!((brute - f.exact).abs() < 1e-9, "{}: {brute} {}", f.name, f.exact);
    }
    for f in evaluation_step_1d() {
        let brute = midpoint_1d(1 << 16, |x| f.at(x));
        assert!((brute - f.exact).abs() < 1.0 / f64::from(1 << 16), "{}: {brute} {}", f.name, f.exact);
    }
}

#[test]
fn exact_values_of_2d_smooth() {
    for f in evaluation_smooth_2d() {
        let brute = gauss_2d(300, |p| f.at(p));
        // Soft edges have a jump in the second derivative: order n⁻³ there.
        assert!((brute - f.exact).abs() < 1e-8, "{}: {brute} {}", f.name, f.exact);
    }
    for seed in 0..20 {
        for f in smooth_2d(seed).into_iter().skip(6) {
            let brute = gauss_2d(100, |p| f.at(p));
            assert!((brute - f.exact).abs() < 1e-6, "seed {seed}, {}: {brute} {}", f.name, f.exact);
        }
    }
}

#[test]
fn soft_edges_along_an_axis_are_exact() {
    for (normal, distance) in [([1.0, 0.0], 0.3), ([0.0, 1.0], 0.3), ([-1.0, 0.0], -0.3), ([0.0, -1.0], -0.3)] {
        let edge = SoftEdge { normal, distance, width: 0.4 };
        // Below .1 and above .5 it is constant; in between its mean is one half.
        let lit_above = if distance > 0.0 { 0.5 * 0.4 + 0.5 } else { 0.1 + 0.5 * 0.4 };
        assert!((edge.integral() - lit_above).abs() < 1e-15, "{normal:?}: {}", edge.integral());
    }
    // A nearly horizontal edge: no cancellation in the density of the trapezoid.
    let tilt: f64 = 1e-9;
    let edge = SoftEdge { normal: [tilt.sin(), tilt.cos()], distance: 0.3, width: 0.4 };
    assert!((edge.integral() - 0.7).abs() < 1e-8);
}

#[test]
fn half_plane_areas() {
    let known = |normal: [f64; 2], distance: f64, area: f64| {
        let found = HalfPlane { normal, distance }.area();
        assert!((found - area).abs() < 1e-15, "{normal:?} {distance}: {found}");
    };
    let r = core::f64::consts::FRAC_1_SQRT_2;
    known([1.0, 0.0], 0.25, 0.25);
    known([-1.0, 0.0], -0.25, 0.75);
    known([0.0, -1.0], -0.25, 0.75);
    known([r, r], r, 0.5);
    known([r, r], 0.5 * r, 0.125);
    known([-r, r], 0.0, 0.5);
    known([r, r], -0.1, 0.0);
    known([r, r], 2.0, 1.0);
    // A line crosses fewer than 2n of n×n cells, each off by less than its area.
    let n = 512u32;
    for f in evaluation_half_plane_2d() {
        let brute = midpoint_1d(n, |y| midpoint_1d(n, |x| f.at([x, y])));
        assert!((brute - f.exact).abs() < 2.0 / f64::from(n), "{}: {brute} {}", f.name, f.exact);
    }
}

#[test]
fn kernel_sums_to_one_and_has_its_sigma() {
    for size in [16, 64, 128] {
        for sigma in SIGMAS {
            let kernel = kernel_1d(size, sigma);
            assert!((kernel.iter().sum::<f64>() - 1.0).abs() < 1e-12);
            for d in 1..size {
                assert_eq!(kernel[d].to_bits(), kernel[size - d].to_bits(), "size {size}, sigma {sigma}, {d}");
            }
        }
    }
    for sigma in SIGMAS {
        let kernel = kernel_1d(128, sigma);
        let signed = |d: usize| if d < 64 { d as f64 } else { d as f64 - 128.0 };
        let variance: f64 = kernel.iter().enumerate().map(|(d, w)| w * signed(d).powi(2)).sum();
        assert!((variance.sqrt() - sigma).abs() < 1e-6, "{sigma}: {}", variance.sqrt());
        // ‖k‖² of a 2D Gaussian is 1/(4πσ²); sampled at sigma 1 it is 2·10⁻⁴ more (Poisson summation).
        let norm = kernel_norm(128, sigma);
        assert!((norm * norm * 4.0 * core::f64::consts::PI * sigma * sigma - 1.0).abs() < 3e-4, "{sigma}: {norm}");
    }
}

#[test]
fn filter_of_a_constant_of_a_point_and_of_a_wave() {
    let size = 32;
    for sigma in SIGMAS {
        let flat = ErrorImage { size, errors: vec![0.7; size * size] }.filter(sigma);
        assert!(flat.errors.iter().all(|e| (e - 0.7).abs() < 1e-12));

        let mut point = ErrorImage { size, errors: vec![0.0; size * size] };
        point.errors[3 * size + 30] = 1.0;
        let spread = point.filter(sigma);
        let kernel = kernel_1d(size, sigma);
        for y in 0..size {
            for x in 0..size {
                let (dx, dy) = ((x + size - 30) % size, (y + size - 3) % size);
                assert!((spread.errors[y * size + x] - kernel[dx] * kernel[dy]).abs() < 1e-15);
            }
        }

        // A wave of frequency f is damped by exp(−2π²f²σ²).
        let (fx, fy) = (2.0 / size as f64, 1.0 / size as f64);
        let turn = core::f64::consts::TAU;
        let wave = ErrorImage::new(size, 0.0, |x, y| libm::cos(turn * (fx * f64::from(x) + fy * f64::from(y))));
        let damped = libm::exp(-0.5 * (turn * sigma).powi(2) * (fx * fx + fy * fy));
        assert!((wave.filtered_rms(sigma) / wave.rms() - damped).abs() < 1e-6);
    }
}

#[test]
fn white_noise_reads_one() {
    let images: Vec<_> = (0..8).map(|k| white_image(128, seeds::WHITE + k)).collect();
    for sigma in SIGMAS {
        let mean_gain = images.iter().map(|image| image.gain(sigma)).sum::<f64>() / 8.0;
        assert!((mean_gain - 1.0).abs() < 0.03, "G at {sigma}: {mean_gain}");
        let r = relative_error(&images, sigma, false);
        assert!((r - 1.0).abs() < 0.03, "R at {sigma}: {r}");
        let r = relative_error(&images, sigma, true);
        assert!((r - 1.0).abs() < 0.03, "normalised R at {sigma}: {r}");
    }
}

#[test]
fn closed_form_of_the_shuffled_error_is_the_mean_of_shuffles() {
    // Skewed values with a mean, a small image: every term of the closed form counts.
    let size = 16;
    let mut random = Random::new(seeds::WHITE);
    let mut image = ErrorImage { size, errors: (0..size * size).map(|_| random.uniform().powi(3)).collect() };
    for sigma in SIGMAS {
        let rounds = 1000;
        let mut sum = 0.0;
        for _ in 0..rounds {
            random.shuffle(&mut image.errors);
            sum += image.filtered_rms(sigma).powi(2);
        }
        let (measured, closed) = ((sum / f64::from(rounds)).sqrt(), image.shuffled_filtered_rms(sigma));
        assert!((measured / closed - 1.0).abs() < 2e-3, "{sigma}: {measured} {closed}");
    }
}

#[test]
fn error_image_is_estimate_minus_exact() {
    let half = Integrand::new("x".into(), 0.5, |x: f64| x);
    let image = ErrorImage::of_samples(4, 2, &half, |x, y, index| {
        f64::from(x) / 8.0 + f64::from(y) / 16.0 + f64::from(index) / 4.0
    });
    assert_eq!(image.errors[0], -0.375);
    assert_eq!(image.errors[1], -0.25);
    assert_eq!(image.errors[4], -0.3125);
}

#[test]
fn spectrum_keeps_energy_and_finds_a_wave() {
    let image = white_image(64, seeds::WHITE);
    let spectrum = Spectrum::new(&image.errors, 64);
    let n = image.errors.len() as f64;
    let mean = image.errors.iter().sum::<f64>() / n;
    let variance = image.errors.iter().map(|e| (e - mean).powi(2)).sum::<f64>() / n;
    assert!((spectrum.power.iter().sum::<f64>() / n - variance).abs() < 1e-12, "Parseval");
    assert!(spectrum.power[0] < 1e-12, "the mean is removed");

    // White: flat, within the scatter of the number of frequencies in a ring.
    assert!((spectrum.low_frequency(0.125) - 1.0).abs() < 0.2);
    assert!(spectrum.radial()[8..32].iter().all(|power| (power - 1.0).abs() < 0.6));
    assert!(spectrum.spike() > 5.0 && spectrum.spike() < 16.0, "{}", spectrum.spike());

    // A wave of 5 periods across and 12 down is ring 13, and only that.
    let wave = ErrorImage::new(64, 0.0, |x, y| {
        libm::cos(core::f64::consts::TAU * (5.0 * f64::from(x) + 12.0 * f64::from(y)) / 64.0)
    });
    let spectrum = Spectrum::new(&wave.errors, 64);
    for (p, power) in spectrum.power.iter().enumerate() {
        let expected = if p == 12 * 64 + 5 || p == 52 * 64 + 59 { n / 4.0 } else { 0.0 };
        assert!((power - expected).abs() < 1e-9, "entry {p}: {power}");
    }
    let radial = spectrum.radial();
    assert!(radial.iter().enumerate().all(|(ring, power)| (*power > 1e-9) == (ring == 13)));
    assert!(spectrum.low_frequency(0.125) < 1e-12);
    assert!(spectrum.low_frequency(0.25) > 4.0);
}

#[test]
fn l2_star_of_known_sets() {
    // One point (x, y), n = 1: 1/9 − (1−x²)(1−y²)/2 + (1−x)(1−y).
    let one = |x: f64, y: f64| (1.0 / 9.0 - (1.0 - x * x) * (1.0 - y * y) / 2.0 + (1.0 - x) * (1.0 - y)).sqrt();
    assert!((l2_star(&[[0.0, 0.0]]) - (11.0f64 / 18.0).sqrt()).abs() < 1e-15);
    assert!((l2_star(&[[1.0, 1.0]]) - 1.0 / 3.0).abs() < 1e-15);
    assert!((l2_star(&[[0.25, 0.5]]) - one(0.25, 0.5)).abs() < 1e-15);
    // (¼, ¼) and (¾, ¾): singles (15/16)² + (7/16)² = 274/256; pairs 9/16 + 3·1/16 = 12/16, over 4.
    let by_hand = 1.0f64 / 9.0 - 274.0 / 256.0 / 4.0 + 12.0 / 16.0 / 4.0;
    assert!((l2_star(&[[0.25, 0.25], [0.75, 0.75]]) - by_hand.sqrt()).abs() < 1e-15);
    // Against the definition: the mean over boxes, by brute force.
    let mut random = Random::new(seeds::WHITE);
    let points: Vec<[f64; 2]> = (0..20).map(|_| [random.uniform(), random.uniform()]).collect();
    let inside = |a: f64, b: f64| points.iter().filter(|p| p[0] < a && p[1] < b).count() as f64 / 20.0;
    let n = 400;
    let mean = midpoint_1d(n, |a| midpoint_1d(n, |b| (inside(a, b) - a * b).powi(2)));
    assert!((l2_star(&points) / mean.sqrt() - 1.0).abs() < 0.01);
}
