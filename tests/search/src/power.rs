//! How much power a family of training integrands has in the Walsh functions of one, two, three and four numbers.
//!
//! Function c of a number is the product of the signs of its digits j+1 for the bits j that are set in c. Of a function
//! of many numbers, the transform of its mean over the others gives the characters of those that are kept.

use rayon::prelude::*;

use crate::random::Random;
use crate::ridge::Ridge;

/// Digits of a number that are looked at where it stands alone, in pairs, in triples and in fours.
pub const DIGITS: [usize; 4] = [12, 10, 6, 4];

/// Mean power by the number of numbers: at index c₁ | c₂ << digits | …, symmetric, 0 where a part of the character is
/// 0.
#[derive(Debug)]
pub struct Family {
    pub dimensions: usize,
    pub power: [Vec<f32>; 4],
    /// The variance that padded, Owen-scrambled points leave in a pixel at 2^m samples.
    pub white: [f64; COUNTS],
}

/// Numbers of samples 2⁰ … 2⁸.
pub const COUNTS: usize = 9;

impl Family {
    pub fn new(seed: u64, dimensions: usize, smooth: bool, count: usize) -> Self {
        let mut random = Random::new(seed);
        let ridges: Vec<Ridge> = (0..count).map(|_| Ridge::random(&mut random, dimensions, smooth)).collect();
        // Large transforms of fewer integrands.
        let power = [1, 2, 3, 4].map(|kept| mean(&ridges, kept, if kept == 3 { count.min(150) } else { count }));
        let white = core::array::from_fn(|m| white(&ridges, m));
        Self { dimensions, power, white }
    }
}

fn mean(ridges: &[Ridge], kept: usize, count: usize) -> Vec<f32> {
    let digits = DIGITS[kept - 1];
    let mut sum = vec![0f32; 1 << (digits * kept)];
    if ridges.is_empty() || kept > ridges[0].normal.len() {
        return sum;
    }
    // In batches, summed in order: the outcome does not depend on the number of threads.
    for batch in ridges[..count.min(ridges.len())].chunks(16) {
        let powers: Vec<Vec<f32>> = batch.par_iter().map(|ridge| squares(ridge, kept, digits)).collect();
        for power in powers {
            sum.iter_mut().zip(power).for_each(|(sum, p)| *sum += p / count as f32);
        }
    }
    symmetric(&sum, kept, digits)
}

/// The squares of the transform.
fn squares(ridge: &Ridge, kept: usize, digits: usize) -> Vec<f32> {
    let side = 1usize << digits;
    let table = ridge.projected(kept);
    let exact = kept == ridge.normal.len();
    let mut values = vec![0f32; 1 << (digits * kept)];
    for i in 0..values.len() {
        let (mut sum, mut place) = (0.0, 0);
        for k in 0..kept {
            let cell = i >> (digits * k) & (side - 1);
            sum += ridge.normal[k] * (cell as f64 + 0.5) / side as f64;
            // Reversed, so that bit j of a character is digit j+1.
            place |= ((cell as u32).reverse_bits() >> (32 - digits)) as usize * (1 << (digits * k));
        }
        values[place] = if exact { ridge.of_sum(sum) } else { table.at(sum) } as f32;
    }
    walsh(&mut values);
    values.iter().map(|v| v * v).collect()
}

/// The fast Walsh–Hadamard transform, means in place of sums.
fn walsh(values: &mut [f32]) {
    let mut half = 1;
    while half < values.len() {
        for block in values.chunks_exact_mut(2 * half) {
            let (a, b) = block.split_at_mut(half);
            for (a, b) in a.iter_mut().zip(b) {
                (*a, *b) = ((*a + *b) / 2.0, (*a - *b) / 2.0);
            }
        }
        half *= 2;
    }
}

/// The mean over the orders of a character's parts; 0 where a part is 0.
fn symmetric(power: &[f32], kept: usize, digits: usize) -> Vec<f32> {
    let parts = |i: usize| {
        let mut parts = [0; 4];
        (0..kept).for_each(|k| parts[k] = i >> (digits * k) & ((1 << digits) - 1));
        parts[..kept].sort_unstable();
        parts
    };
    let place = |parts: [usize; 4]| (0..kept).fold(0, |place, k| place | parts[k] << (digits * k));
    let (mut sums, mut counts) = (vec![0f32; power.len()], vec![0u8; power.len()]);
    for (i, p) in power.iter().enumerate() {
        sums[place(parts(i))] += p;
        counts[place(parts(i))] += 1;
    }
    let mean = |i| {
        let parts = parts(i);
        if parts[0] == 0 { 0.0 } else { sums[place(parts)] / f32::from(counts[place(parts)]) }
    };
    (0..power.len()).map(mean).collect()
}

/// Of some integrands, over some pixels.
fn white(ridges: &[Ridge], m: usize) -> f64 {
    let pixels = if m >= 6 { 400 } else { 1500 };
    let variance = |(k, ridge): (usize, &Ridge)| {
        let (mut sum, mut squares) = (0.0, 0.0);
        for x in 0..pixels {
            let pixel = bluedither::White::new(k as u32).pixel(x, 0, 0);
            let total: f64 = (0..1 << m).map(|index| ridge.of_sum(dot(&ridge.normal, pixel.draw::<8>(0, index)))).sum();
            let mean = total / (1u32 << m) as f64;
            (sum, squares) = (sum + mean, squares + mean * mean);
        }
        squares / f64::from(pixels) - (sum / f64::from(pixels)) * (sum / f64::from(pixels))
    };
    let some = &ridges[..ridges.len().min(60)];
    some.iter().enumerate().map(variance).sum::<f64>() / some.len() as f64
}

fn dot(normal: &[f64], numbers: [f32; 8]) -> f64 {
    normal.iter().zip(numbers).map(|(n, u)| n * f64::from(u)).sum()
}
