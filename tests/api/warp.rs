//! Warps: finite and inside their domain for every float, and equal areas for equal areas.
#![cfg(feature = "warp")]

use bluedither::warp::{cosine_hemisphere, disk, gaussian, sphere, triangle, uniform_hemisphere};
use proptest::prelude::*;

const EXTREMES: [f32; 22] = [
    0.0,
    -0.0,
    1.0,
    -1.0,
    0.5,
    0.25,
    0.75,
    1.0 / 3.0,
    1.0 - f32::EPSILON / 2.0, // the largest that a sampler returns
    1.0 + f32::EPSILON,
    0.5 - f32::EPSILON / 4.0,
    0.5 + f32::EPSILON / 2.0,
    f32::EPSILON,
    f32::MIN_POSITIVE,
    -f32::MIN_POSITIVE,
    1e-45, // the least subnormal
    f32::MAX,
    f32::MIN,
    f32::INFINITY,
    f32::NEG_INFINITY,
    f32::NAN,
    -f32::NAN,
];

/// Through memory: a compiler for s390x goes astray where it makes doubles of `warp`'s floats, which are right, in
/// place.
fn double(value: f32) -> f64 {
    f64::from(core::hint::black_box(value))
}

fn length<const D: usize>(v: [f32; D]) -> f64 {
    v.iter().map(|c| double(*c).powi(2)).sum::<f64>().sqrt()
}

/// What holds for every argument whatever.
fn check(u: [f32; 2]) {
    let rounding = 3e-7;
    assert!(length(disk(u)) <= 1.0 + rounding, "disk {u:?}: {:?}", disk(u));
    for (name, direction) in [
        ("cosine hemisphere", cosine_hemisphere(u)),
        ("uniform hemisphere", uniform_hemisphere(u)),
        ("sphere", sphere(u)),
    ] {
        assert!((length(direction) - 1.0).abs() <= 2e-6, "{name} {u:?}: {direction:?}");
        assert!(name == "sphere" || direction[2] >= 0.0, "{name} {u:?}: {direction:?}");
    }
    let corners = triangle(u);
    assert!(corners.iter().all(|c| (0.0..=1.0).contains(c)), "triangle {u:?}: {corners:?}");
    assert!((corners.iter().sum::<f32>() - 1.0).abs() <= f32::EPSILON, "triangle {u:?}: {corners:?}");
    assert!(gaussian(u).iter().all(|c| c.abs() <= 6.71), "gaussian {u:?}: {:?}", gaussian(u));
}

#[test]
fn extremes_are_finite_and_inside() {
    for a in EXTREMES {
        for b in EXTREMES {
            check([a, b]);
        }
    }
}

#[test]
fn out_of_range_counts_as_the_border_and_nan_as_zero() {
    for (odd, even) in [(-3.0, 0.0), (f32::NEG_INFINITY, 0.0), (f32::NAN, 0.0), (1.5, 1.0), (f32::INFINITY, 1.0)] {
        for other in [0.0, 0.3, 1.0] {
            assert_eq!(disk([odd, other]), disk([even, other]));
            assert_eq!(disk([other, odd]), disk([other, even]));
            assert_eq!(sphere([odd, other]), sphere([even, other]));
            assert_eq!(triangle([other, odd]), triangle([other, even]));
            assert_eq!(gaussian([odd, other]), gaussian([even, other]));
        }
    }
}

#[test]
fn known_points() {
    let near = |found: &[f32], expected: &[f32]| {
        let off = found.iter().zip(expected).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
        assert!(off < 1e-6, "{found:?} is not {expected:?}");
    };
    let r = core::f32::consts::FRAC_1_SQRT_2;
    near(&disk([0.5, 0.5]), &[0.0, 0.0]);
    near(&disk([1.0, 0.5]), &[1.0, 0.0]);
    near(&disk([0.5, 0.0]), &[0.0, -1.0]);
    near(&disk([1.0, 1.0]), &[r, r]);
    near(&disk([0.0, 1.0]), &[-r, r]);
    near(&cosine_hemisphere([0.5, 0.5]), &[0.0, 0.0, 1.0]);
    near(&uniform_hemisphere([1.0, 0.5]), &[1.0, 0.0, 0.0]);
    near(&sphere([0.0, 0.7]), &[0.0, 0.0, 1.0]);
    near(&sphere([0.5, 0.25]), &[0.0, 1.0, 0.0]);
    near(&triangle([0.0, 0.0]), &[0.0, 0.0, 1.0]);
    near(&triangle([1.0, 1.0]), &[0.5, 0.5, 0.0]);
    near(&triangle([0.0, 1.0]), &[0.0, 1.0, 0.0]);
    near(&gaussian([0.0, 0.3]), &[0.0, 0.0]);
}

/// Shares of a regular grid of 512² points in `cells` cells of equal measure; they must be equal.
fn assert_equal_shares(name: &str, cells: usize, cell: impl Fn([f32; 2]) -> usize) {
    const SIDE: u32 = 512;
    let mut count = vec![0u32; cells];
    for k in 0..SIDE * SIDE {
        count[cell([k % SIDE, k / SIDE].map(|c| (c as f32 + 0.5) / SIDE as f32)).min(cells - 1)] += 1;
    }
    let expected = f64::from(SIDE * SIDE) / cells as f64;
    for (k, n) in count.iter().enumerate() {
        // A cell of area A gains or loses points along its border only: of the order of its root.
        assert!((f64::from(*n) - expected).abs() < 3.0 * expected.sqrt(), "{name}, cell {k}: {n} of {expected}");
    }
}

/// One of n equal parts of [0, 1).
fn part(value: f64, n: usize) -> usize {
    ((value * n as f64) as usize).min(n - 1)
}

/// The angle of a direction in turns, [0, 1).
fn turn(x: f32, y: f32) -> f64 {
    (double(y).atan2(double(x)) / core::f64::consts::TAU).rem_euclid(1.0)
}

#[test]
fn equal_areas_of_the_disk_and_the_sphere() {
    assert_equal_shares("disk", 128, |u| {
        let [x, y] = disk(u);
        part(length([x, y]).powi(2), 8) * 16 + part(turn(x, y), 16)
    });
    // With density cos θ/π the disk below it is uniform; with constant density z is.
    assert_equal_shares("cosine hemisphere", 128, |u| {
        let [x, y, z] = cosine_hemisphere(u);
        part(1.0 - double(z).powi(2), 8) * 16 + part(turn(x, y), 16)
    });
    assert_equal_shares("uniform hemisphere", 128, |u| {
        let [x, y, z] = uniform_hemisphere(u);
        part(double(z), 8) * 16 + part(turn(x, y), 16)
    });
    assert_equal_shares("sphere", 128, |u| {
        let [x, y, z] = sphere(u);
        part(0.5 + 0.5 * double(z), 8) * 16 + part(turn(x, y), 16)
    });
}

#[test]
fn equal_areas_of_the_triangle() {
    // Cut in four by the midpoints of its sides, three times.
    assert_equal_shares("triangle", 64, |u| {
        let mut corners = triangle(u).map(f64::from);
        (0..3).fold(0, |cell, _| {
            let near = (0..3).find(|&k| corners[k] > 0.5);
            corners = match near {
                Some(k) => core::array::from_fn(|j| 2.0 * corners[j] - if j == k { 1.0 } else { 0.0 }),
                None => corners.map(|c| 1.0 - 2.0 * c),
            };
            cell * 4 + near.unwrap_or(3)
        })
    });
}

#[test]
fn gaussian_is_normal() {
    // Each coordinate, mapped by the normal distribution function, is uniform, and the two are independent.
    let below = |c: f32| 0.5 + 0.5 * libm::erf(f64::from(c) * core::f64::consts::FRAC_1_SQRT_2);
    assert_equal_shares("gaussian", 64, |u| {
        let [a, b] = gaussian(u);
        part(below(a), 8) * 8 + part(below(b), 8)
    });
}

#[test]
fn disk_and_triangle_are_continuous() {
    // Neighbours stay neighbours, across the diagonals, too: that is what keeps blue noise blue.
    let n = 400u16;
    let step = 1.0 / f32::from(n);
    for i in 0..n {
        for j in 0..n {
            let u = [f32::from(i) * step, f32::from(j) * step];
            for v in [[u[0] + step, u[1]], [u[0], u[1] + step]] {
                let (p, q) = (disk(u), disk(v));
                let moved = f64::from(p[0] - q[0]).hypot(f64::from(p[1] - q[1]));
                assert!(moved < 3.0 * f64::from(step), "disk {u:?}: {moved}");
                let (p, q) = (triangle(u), triangle(v));
                let moved = p.iter().zip(&q).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
                assert!(moved < 1.5 * step, "triangle {u:?}: {moved}");
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, cases: 5000, ..ProptestConfig::default() })]

    #[test]
    fn every_float_is_finite_and_inside(a in any::<u32>(), b in any::<u32>()) {
        check([f32::from_bits(a), f32::from_bits(b)]);
    }

    #[test]
    fn every_sample_is_finite_and_inside(a in 0.0f32..1.0, b in 0.0f32..1.0) {
        check([a, b]);
    }
}
