//! How much power the training integrands have in each Walsh function of the unit square.

use rayon::prelude::*;

use super::{COUNTS, FAMILIES};

/// Digits of a coordinate that are looked at.
pub const DIGITS: usize = 10;
/// Walsh functions along an axis. Function c is Π over the set bits j of c of the sign of digit j+1.
pub const SIDE: usize = 1 << DIGITS;

const TRAINING: [usize; FAMILIES] = [600, 240];

/// Mean power of a family, its integrands scaled so that Owen-scrambled points leave an error of 1.
pub struct Power {
    /// For each family and each 2^m samples, at index cy·[`SIDE`] + cx. Symmetric.
    pub at: [Vec<Vec<f32>>; FAMILIES],
}

type Integrand = Box<dyn Fn(f64, f64) -> f64 + Send + Sync>;

impl Power {
    /// Of integrands that no evaluation uses: half-planes through random points; random waves and bumps.
    ///
    /// Half-planes are scaled as a family, smooth functions one by one, as in the evaluation.
    pub fn of_training() -> Self {
        let half_planes = mean((0..TRAINING[0]).map(|i| half_plane(i as u64)).collect(), false);
        let smooth = mean((0..TRAINING[1]).map(|i| smooth(i as u64)).collect(), true);
        Self { at: [half_planes, smooth] }
    }
}

fn mean(integrands: Vec<Integrand>, one_by_one: bool) -> Vec<Vec<f32>> {
    let mut sums = vec![vec![0f32; SIDE * SIDE]; COUNTS];
    let mut variances = [0.0; COUNTS];
    let count = integrands.len() as f64;
    // In batches, summed in order: the outcome does not depend on the number of threads.
    for batch in integrands.chunks(8) {
        let transforms: Vec<Vec<f32>> = batch.par_iter().map(|f| squares(&**f)).collect();
        let owen: Vec<[f64; COUNTS]> = transforms.par_iter().map(|squares| owen_variances(squares)).collect();
        for variance in &owen {
            variances.iter_mut().zip(variance).for_each(|(sum, v)| *sum += v / count);
        }
        sums.par_iter_mut().enumerate().for_each(|(m, sum)| {
            for (squares, variance) in transforms.iter().zip(&owen) {
                let scale = if one_by_one { 1.0 / variance[m] } else { 1.0 };
                let scale = (scale / count) as f32;
                sum.iter_mut().zip(squares).for_each(|(sum, square)| *sum += scale * square);
            }
        });
    }
    for (sum, variance) in sums.iter_mut().zip(variances) {
        let scale = if one_by_one { 0.5 } else { 0.5 / variance as f32 };
        let whole: Vec<f32> = (0..SIDE * SIDE).map(|c| scale * (sum[c] + sum[c % SIDE * SIDE + c / SIDE])).collect();
        *sum = whole;
        sum[0] = 0.0;
    }
    sums
}

fn half_plane(seed: u64) -> Integrand {
    let mut random = super::anneal::Random::new(0x1a1f ^ seed << 16);
    let angle = random.uniform() * core::f64::consts::TAU;
    let normal = [libm::cos(angle), libm::sin(angle)];
    let distance = normal[0] * random.uniform() + normal[1] * random.uniform();
    Box::new(move |x, y| if normal[0] * x + normal[1] * y < distance { 1.0 } else { 0.0 })
}

fn smooth(seed: u64) -> Integrand {
    let mut random = super::anneal::Random::new(0x5307 ^ seed << 16);
    let mut uniform = |from: f64, to: f64| from + (to - from) * random.uniform();
    if seed.is_multiple_of(2) {
        // A wave of less than .9 periods, uniform in the disk.
        let (radius, angle) = (0.9 * uniform(0.0, 1.0).sqrt(), uniform(0.0, core::f64::consts::TAU));
        let [fx, fy] = [libm::cos(angle), libm::sin(angle)].map(|f| f * radius * core::f64::consts::TAU);
        let phase = uniform(0.0, core::f64::consts::TAU);
        return Box::new(move |x, y| libm::cos(fx * x + fy * y + phase));
    }
    // A saddle with a bump.
    let [a, b, c, d, height] = core::array::from_fn(|_| uniform(-0.5, 0.5));
    let [px, py] = core::array::from_fn(|_| uniform(-0.2, 1.2));
    let width = uniform(0.4, 1.4);
    Box::new(move |x, y| {
        let r2 = (x - px) * (x - px) + (y - py) * (y - py);
        a * x + b * y + c * x * y + 0.5 * d * (x * x - y * y) + height * libm::exp(-r2 / (width * width))
    })
}

/// Squared Walsh coefficients: a fast transform of the values at the centres of a grid.
pub fn squares(integrand: &dyn Fn(f64, f64) -> f64) -> Vec<f32> {
    let reversed = |i: usize| i.reverse_bits() >> (usize::BITS as usize - DIGITS);
    let centre = |i: usize| (reversed(i) as f64 + 0.5) / SIDE as f64;
    let mut values: Vec<f32> = (0..SIDE * SIDE).map(|i| integrand(centre(i % SIDE), centre(i / SIDE)) as f32).collect();
    let mut half = 1;
    while half < values.len() {
        for block in values.chunks_exact_mut(2 * half) {
            let (low, high) = block.split_at_mut(half);
            low.iter_mut().zip(high).for_each(|(a, b)| (*a, *b) = (*a + *b, *a - *b));
        }
        half *= 2;
    }
    let scale = 1.0 / (SIDE * SIDE) as f32;
    values.iter().map(|v| (v * scale) * (v * scale)).collect()
}

/// The variance of Owen-scrambled points: the power on each level times the share of its functions in a dual net (Owen
/// 1997). Level (a, b) holds the functions whose highest digits are a and b.
pub fn owen_variances(squares: &[f32]) -> [f64; COUNTS] {
    let level = |c: usize| (usize::BITS - c.leading_zeros()) as usize;
    let mut powers = [[0f64; DIGITS + 1]; DIGITS + 1];
    for (c, square) in squares.iter().enumerate() {
        powers[level(c % SIDE)][level(c / SIDE)] += f64::from(*square);
    }
    core::array::from_fn(|m| {
        // Functions of a dual net below level (a, b): an elementary interval of that size holds as many points.
        let below = |a: usize, b: usize| if a == 0 || b == 0 { 0 } else { 1u64 << (a + b - 2).saturating_sub(m) };
        let mut variance = 0.0;
        for (a, row) in powers.iter().enumerate() {
            for (b, power) in row.iter().enumerate().skip(usize::from(a == 0)) {
                let dual = below(a + 1, b + 1) + below(a, b) - below(a, b + 1) - below(a + 1, b);
                let all = 1u64 << (a.saturating_sub(1) + b.saturating_sub(1));
                variance += power * dual as f64 / all as f64;
            }
        }
        variance
    })
}
