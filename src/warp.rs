//! From the unit square to what a renderer asks for: disk, sphere, hemisphere, triangle, Gaussian.
//!
//! Every map keeps area (its density is constant, or the one named), so blue noise stays blue where the map is
//! continuous. Arguments are clamped to [0, 1] and NaN counts as 0, so results are always finite. Functions of
//! `libm`: the same bits on every machine, no `std`. Integer paths never come here.

use core::f32::consts::{FRAC_PI_2, FRAC_PI_4, TAU};

/// A point of the unit disk, uniform: |p| ≤ 1 up to rounding.
///
/// Concentric squares to concentric circles (Shirley and Chiu 1997): continuous, little distortion.
#[inline]
#[must_use]
pub fn disk(u: [f32; 2]) -> [f32; 2] {
    let [a, b] = clamp(u).map(|c| 2.0 * c - 1.0);
    let (radius, angle) = if a == 0.0 && b == 0.0 {
        (0.0, 0.0)
    } else if a * a > b * b {
        (a, FRAC_PI_4 * (b / a))
    } else {
        (b, FRAC_PI_2 - FRAC_PI_4 * (a / b))
    };
    [radius * libm::cosf(angle), radius * libm::sinf(angle)]
}

/// A direction of the upper hemisphere (z ≥ 0) with density cos θ/π: a disk point lifted up (Malley).
#[inline]
#[must_use]
pub fn cosine_hemisphere(u: [f32; 2]) -> [f32; 3] {
    let [x, y] = disk(u);
    [x, y, libm::sqrtf((1.0 - x * x - y * y).max(0.0))]
}

/// A direction of the upper hemisphere (z ≥ 0), uniform: density 1/2π.
#[inline]
#[must_use]
pub fn uniform_hemisphere(u: [f32; 2]) -> [f32; 3] {
    let [x, y] = disk(u);
    let r2 = (x * x + y * y).min(1.0);
    let stretch = libm::sqrtf(2.0 - r2);
    [x * stretch, y * stretch, 1.0 - r2]
}

/// A direction of the sphere, uniform: density 1/4π. Archimedes: z is uniform.
#[inline]
#[must_use]
pub fn sphere(u: [f32; 2]) -> [f32; 3] {
    let [u, v] = clamp(u);
    let z = 1.0 - 2.0 * u;
    let r = libm::sqrtf((1.0 - z * z).max(0.0));
    let angle = TAU * v;
    [r * libm::cosf(angle), r * libm::sinf(angle), z]
}

/// Barycentric coordinates of a point of a triangle, uniform: all ≥ 0, their sum is 1 up to rounding.
///
/// Heitz 2019, "A low-distortion map between triangle and square": no root, continuous.
#[inline]
#[must_use]
pub fn triangle(u: [f32; 2]) -> [f32; 3] {
    let [u, v] = clamp(u);
    let (a, b) = if v > u { (u * 0.5, v - u * 0.5) } else { (u - v * 0.5, v * 0.5) };
    [a, b, (1.0 - a - b).max(0.0)]
}

/// Two independent normal numbers, mean 0 and variance 1 (Box and Muller 1958): at most 6.7 in magnitude.
#[inline]
#[must_use]
pub fn gaussian(u: [f32; 2]) -> [f32; 2] {
    let [u, v] = clamp(u);
    // 1 − u is in (0, 1] for every u that a sampler returns; the floor keeps u = 1 finite.
    let radius = libm::sqrtf(-2.0 * libm::logf((1.0 - u).max(1.8e-10)));
    let angle = TAU * v;
    [radius * libm::cosf(angle), radius * libm::sinf(angle)]
}

#[inline]
#[expect(clippy::manual_clamp, reason = "f32::clamp keeps NaN; max and min return the other argument")]
fn clamp(u: [f32; 2]) -> [f32; 2] {
    u.map(|c| c.max(0.0).min(1.0))
}
