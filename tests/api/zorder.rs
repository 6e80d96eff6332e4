//! The Z curve and the points of its squares: naive twins, nets for every number of samples.

use crate::analysis::net::assert_net;
use bluedither::{White, ZOrder, sobol, unit, zorder};
use proptest::prelude::*;

/// Σ aⱼ·qʲ over GF(2) with q = t² + t + 1 and the pairs of bits aⱼ of `digits`, term by term.
fn naive_first_index(digits: u32) -> u32 {
    let times_q = |p: u32| p << 2 ^ p << 1 ^ p;
    let term = |j: u32| (0..j).fold(digits >> (2 * j) & 3, |p, _| times_q(p));
    (0..16).fold(0, |sum, j| sum ^ term(j))
}

#[test]
fn first_indices_are_a_bijection() {
    // A linear map with 32 independent images, by elimination.
    let mut rows: Vec<u32> = Vec::new();
    for bit in 0..32 {
        let mut image = zorder::first_index(1 << bit);
        rows.iter().for_each(|row| image = image.min(image ^ row));
        assert_ne!(image, 0, "bit {bit}");
        rows.push(image);
    }
}

/// Every number digit by digit: Sobol's, to which the digits of the scramble's four steps are added one after the other.
fn naive_point(index: u32) -> [u32; 2] {
    let [x, y] = sobol::point(index);
    let mut numbers = [x, y];
    for (lag, mask) in [1, 2, 4, 8].into_iter().zip(SCRAMBLE) {
        for (number, mask) in numbers.iter_mut().zip([mask >> 32, mask & 0xffff_ffff]) {
            let digit = |value: u32, k: u32| value << k >> 31;
            let sum =
                |k| digit(*number, k) ^ if k >= lag { digit(*number, k - lag) & digit(mask as u32, k) } else { 0 };
            *number = (0..32).fold(0, |value, k| value << 1 | sum(k));
        }
    }
    numbers
}

/// As in `zorder::point`.
const SCRAMBLE: [u64; 4] = [0x53be_4322_298a_f328, 0x2ff4_b33a_17ef_c464, 0x03ff_e2f7_099f_e007, 0x00a5_ffec_00ed_ffd3];

#[test]
fn every_aligned_run_of_the_sequence_is_a_net() {
    for m in 0..=12 {
        for run in [0, 1, 2, 0x000f_ffff, 0x0005_a5a5] {
            let first = (run as u32) << m;
            let points: Vec<_> = (first..=first | ((1 << m) - 1)).map(zorder::point).collect();
            assert_net(&points, &format!("2^{m} points from {first}"));
        }
    }
}

#[test]
fn any_number_of_samples_of_any_run_of_places_is_a_net() {
    for k in 0..=4u32 {
        for m in 0..=(12 - 2 * k) {
            for run in [0, 1, 2, 77, 0x00ff_ffff, u32::MAX] {
                let first = run << (2 * k);
                let points: Vec<_> = (first..=first | ((1 << (2 * k)) - 1))
                    .flat_map(|place| {
                        (0..1 << m).map(move |i| zorder::point(zorder::first_index(place.reverse_bits()) ^ i))
                    })
                    .collect();
                assert_net(&points, &format!("2^{m} samples, 4^{k} places from {first}"));
            }
        }
    }
}

#[test]
fn any_number_of_samples_of_any_square_of_pixels_is_a_net() {
    for (seed, frame, domain) in [(0, 0, 0), (1, 2, 3), (u32::MAX, u32::MAX, u32::MAX)] {
        let sampler = ZOrder::new(seed);
        for (x, y) in [(0, 0), (16, 48), (0x1234_5670, 0x8000_0000), (0xffff_fff0, 0xffff_fff0)] {
            for k in 0..=4u32 {
                for m in 0..=(12 - 2 * k) {
                    let (mut first, mut second) = (Vec::new(), Vec::new());
                    for pixel in 0..1u32 << (2 * k) {
                        let pixel = sampler.pixel(x + pixel % (1 << k), y + (pixel >> k), frame);
                        for index in 0..1 << m {
                            let [a, b, c, d] = pixel.draw_fx::<4>(domain, index);
                            first.push([a, b]);
                            second.push([c, d]);
                        }
                    }
                    assert_net(&first, &format!("2^{m} samples of 4^{k} pixels at {x}, {y}"));
                    assert_net(&second, &format!("padded pair: 2^{m} samples of 4^{k} pixels at {x}, {y}"));
                }
            }
        }
    }
}

/// Digits below those that make a net are not left to themselves: what a pixel's estimate is off by, beside what Owen-scrambled
/// points leave.
#[test]
fn many_samples_leave_no_more_error_than_those_of_white() {
    let square = |estimate: &dyn Fn(u32) -> [f64; 3]| {
        let exact = [1.0, 0.25, 2.0 / 3.0];
        (0..128).map(estimate).fold([0.0; 3], |sum, e| core::array::from_fn(|k| sum[k] + (e[k] - exact[k]).powi(2)))
    };
    for m in 4..=12 {
        let mean = |draw: &dyn Fn(u32) -> [u32; 2]| {
            let values = (0..1 << m).map(|i| draw(i).map(unit::to_f64)).map(|[x, y]| [x + y, x * y, x * x + y * y]);
            let sum = values.fold([0.0; 3], |sum, f| core::array::from_fn(|k| sum[k] + f[k]));
            sum.map(|sum| sum / f64::from(1 << m))
        };
        let ours = square(&|p| mean(&|i| ZOrder::new(5).pixel(37 * p, 11 * p, 0).draw_fx(0, i)));
        let white = square(&|p| mean(&|i| White::new(5).pixel(p, 0, 0).draw_fx(0, i)));
        for (k, name) in ["x + y", "xy", "x² + y²"].into_iter().enumerate() {
            assert!(ours[k] < white[k], "{name}, {} samples: {:.3} times white's", 1 << m, ours[k] / white[k]);
        }
    }
}

#[test]
fn blocks_of_65536_pixels_are_seeded_anew() {
    let sampler = ZOrder::new(1);
    let at = |x, y| sampler.pixel(x, y, 0).draw_fx::<4>(0, 0);
    for (x, y) in [(0, 0), (5, 9)] {
        for far in [1 << 16, 1 << 17, 1 << 31] {
            assert_ne!(at(x, y), at(x + far, y));
            assert_ne!(at(x, y), at(x, y + far));
            assert_ne!(at(x + far, y), at(x, y + far));
        }
    }
}

#[test]
fn squares_are_visited_in_orders_of_their_own() {
    // Where the first quarter of the square goes: over 1024 squares each of the four pixels in a quarter of them (± 14),
    // and its partner in the same half beside, below or across.
    let sampler = ZOrder::new(7);
    let mut lowest = [0u32; 4];
    let mut partner = [0u32; 4];
    for square in 0..1024 {
        let value = |k: u32| sampler.pixel(square % 32 * 2 + k % 2, square / 32 * 2 + k / 2, 0).draw_fx::<2>(0, 0)[0];
        let mut order = [0, 1, 2, 3];
        order.sort_unstable_by_key(|&k| value(k));
        lowest[order[0] as usize] += 1;
        partner[(order[0] ^ order[1]) as usize] += 1;
    }
    assert!(lowest.iter().all(|&count| (200..312).contains(&count)), "{lowest:?}");
    assert!(partner[1..].iter().all(|&count| count > 128), "{partner:?}");
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, cases: 2000, ..ProptestConfig::default() })]

    #[test]
    fn morton_interleaves(x: u32, y: u32) {
        let bit = |value: u32, k: u32| u64::from(value >> k & 1);
        let naive = (0..32).fold(0, |sum, k| sum | bit(x, k) << (2 * k) | bit(y, k) << (2 * k + 1));
        prop_assert_eq!(zorder::morton(x, y), naive);
    }

    #[test]
    fn first_index_is_naive(place_rev: u32) {
        prop_assert_eq!(zorder::first_index(place_rev), naive_first_index(place_rev));
    }

    #[test]
    fn a_point_is_naive_and_linear(a: u32, b: u32) {
        prop_assert_eq!(zorder::point(a), naive_point(a));
        let [sum, [ax, ay], [bx, by]] = [a ^ b, a, b].map(zorder::point);
        prop_assert_eq!(sum, [ax ^ bx, ay ^ by]);
    }
}
