//! Screen-space best candidate: against a twin, how blue it is, and that it is unbiased where the talk's would not be.

use crate::analysis::SIGMAS;
use crate::analysis::error::ErrorImage;
use bluedither::{candidate, hash, unit};

const SIZE: usize = 128;

/// A picture by three rows.
fn picture<const D: usize>(seed: u32, width: usize, height: usize) -> Vec<[u32; D]> {
    let mut all = Vec::new();
    let mut rows = [const { Vec::new() }; 3].map(|_: Vec<[u32; D]>| vec![[0u32; D]; width]);
    for y in 0..height as u32 {
        let [above_2, above, row] = &mut rows;
        candidate::fill_row(seed, y, [above_2, above], row);
        all.extend_from_slice(row);
        rows.rotate_left(1);
    }
    all
}

/// The same from the whole picture, with lists. `distance` is that of two samples.
fn twin<const D: usize>(
    seed: u32,
    width: usize,
    height: usize,
    distance: fn([u32; D], [u32; D]) -> f64,
) -> Vec<[u32; D]> {
    let mut all: Vec<[u32; D]> = Vec::new();
    for p in 0..width * height {
        let (x, y) = ((p % width) as i64, (p / width) as i64);
        let (mut near, mut far) = (Vec::new(), Vec::new());
        for (q, &sample) in all.iter().enumerate() {
            let (dx, dy) = ((q % width) as i64 - x, (q / width) as i64 - y);
            if dx.abs() <= 2 && dy >= -2 {
                if dx.abs().max(-dy) == 1 { near.push(sample) } else { far.push(sample) }
            }
        }
        all.push(best(seed, [x as u32, y as u32], &near, &far, distance));
    }
    all
}

/// Of 100 candidates the ten farthest from `near`; of these the farthest from `far`.
fn best<const D: usize>(
    seed: u32,
    [x, y]: [u32; 2],
    near: &[[u32; D]],
    far: &[[u32; D]],
    distance: fn([u32; D], [u32; D]) -> f64,
) -> [u32; D] {
    let least = |sample: [u32; D], set: &[[u32; D]]| {
        set.iter().map(|&other| distance(sample, other)).fold(f64::INFINITY, f64::min)
    };
    let pixel = hash::combine(hash::combine(seed, y), x);
    let candidate = |i: u32| {
        let mut state = hash::combine(pixel, i);
        core::array::from_fn(|_| {
            let component = state;
            state = hash::mix(state);
            component
        })
    };
    let mut candidates: Vec<[u32; D]> = (0..100).map(candidate).collect();
    candidates.sort_by(|&a, &b| least(b, near).total_cmp(&least(a, near)));
    candidates.truncate(10);
    candidates.into_iter().max_by(|&a, &b| least(a, far).total_cmp(&least(b, far))).expect("ten")
}

fn toroidal<const D: usize>(a: [u32; D], b: [u32; D]) -> f64 {
    let apart = |k: usize| f64::from(a[k].wrapping_sub(b[k]).min(b[k].wrapping_sub(a[k])) >> 1);
    (0..D).map(|k| apart(k).powi(2)).sum()
}

fn euclidean<const D: usize>(a: [u32; D], b: [u32; D]) -> f64 {
    (0..D).map(|k| f64::from(a[k].abs_diff(b[k])).powi(2)).sum()
}

#[test]
fn three_rows_are_enough() {
    assert_eq!(picture::<1>(1, 23, 11), twin(1, 23, 11, toroidal));
    assert_eq!(picture::<2>(2, 17, 13), twin(2, 17, 13, toroidal));
    assert_eq!(picture::<3>(3, 5, 9), twin(3, 5, 9, toroidal));
    assert_eq!(picture::<4>(4, 9, 5), twin(4, 9, 5, toroidal));
    assert_eq!(picture::<2>(5, 1, 7), twin(5, 1, 7, toroidal));
    assert_eq!(picture::<2>(6, 2, 7), twin(6, 2, 7, toroidal));
}

#[test]
fn short_rows_above_are_edges() {
    let above: [Vec<[u32; 2]>; 2] = [11, 12].map(|seed| picture(seed, 9, 1));
    for [long_2, long_1] in [[9, 9], [0, 3], [4, 9], [9, 0], [0, 0], [6, 2]] {
        let above = [&above[0][..long_2], &above[1][..long_1]];
        let mut row = [[0u32; 2]; 9];
        candidate::fill_row(1, 5, above, &mut row);
        for x in 0..9i64 {
            let (mut near, mut far) = (Vec::new(), Vec::new());
            for (dy, neighbours) in [(0, &row[..x as usize]), (1, above[1]), (2, above[0])] {
                for (q, &sample) in neighbours.iter().enumerate() {
                    match (q as i64 - x).abs().max(dy) {
                        1 => near.push(sample),
                        2 => far.push(sample),
                        _ => {}
                    }
                }
            }
            assert_eq!(row[x as usize], best(1, [x as u32, 5], &near, &far, toroidal), "{long_2}, {long_1}: pixel {x}");
        }
    }
    let mut empty: [[u32; 2]; 0] = [];
    candidate::fill_row(1, u32::MAX, [&above[0], &above[1]], &mut empty);
}

/// The integral and the integrand.
type Integrand<const D: usize> = (f64, fn([f64; D]) -> f64);

/// Root of the mean square gain of the integrands, at both sigmas.
fn gain<const D: usize>(seeds: core::ops::Range<u32>, integrands: &[Integrand<D>]) -> [f64; 2] {
    let mut sums = [0.0; 2];
    let count = seeds.len() * integrands.len();
    for seed in seeds {
        let samples = picture::<D>(seed, SIZE, SIZE);
        for (exact, f) in integrands {
            let errors = samples.iter().map(|sample| f(sample.map(unit::to_f64)) - exact).collect();
            let image = ErrorImage { size: SIZE, errors };
            SIGMAS.into_iter().zip(&mut sums).for_each(|(sigma, sum)| *sum += image.gain(sigma).powi(2));
        }
    }
    sums.map(|sum| (sum / count as f64).sqrt())
}

#[test]
fn errors_are_blue() {
    let one = gain::<1>(0..2, &[(0.5, |[x]| x)]);
    let two = gain::<2>(0..2, &[(0.25, |[x, y]| x * y)]);
    println!("1D {one:.3?}, 2D {two:.3?}");
    assert!(one[0] <= 0.50 && one[1] <= 0.40, "1D: {one:?}");
    assert!(two[0] <= 0.67 && two[1] <= 0.60, "2D: {two:?}");
}

/// The variance of uniform numbers is 1/12 = .0833.
#[test]
fn toroidal_distances_are_unbiased_and_euclidean_ones_are_not() {
    fn variance<const D: usize>(samples: &[[u32; D]]) -> f64 {
        let values = samples.as_flattened().iter().map(|&v| (unit::to_f64(v) - 0.5).powi(2));
        values.sum::<f64>() / (samples.len() * D) as f64
    }
    fn mean<const D: usize>(samples: &[[u32; D]]) -> f64 {
        samples.as_flattened().iter().map(|&v| unit::to_f64(v)).sum::<f64>() / (samples.len() * D) as f64
    }
    for ours in [variance(&picture::<1>(1, 100, 100)), variance(&picture::<2>(1, 100, 100))] {
        assert!((ours - 1.0 / 12.0).abs() < 0.002, "{ours}");
    }
    for ours in [mean(&picture::<1>(1, 100, 100)), mean(&picture::<3>(1, 60, 60)), mean(&picture::<4>(1, 60, 60))] {
        assert!((ours - 0.5).abs() < 0.005, "{ours}");
    }
    let euclidean = variance(&twin::<1>(1, 48, 48, euclidean));
    println!("variance with Euclidean distances {euclidean:.3}");
    assert!(euclidean > 0.095, "{euclidean}");
}
