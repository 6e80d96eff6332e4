//! The feature vectors of mask values: the errors that a pixel with that value makes on a basis of integrands.
//!
//! The basis is Π cos(π k_j x_j). A feature is the error of one basis function, estimated with the first n points of
//! the pattern that ships moved by the value; n = 1, 4 and 16 at once.
//! Weights fall as |k|^−(d+1)/2, the decay of integrands with edges, and every n has its share of the total. The 48
//! columns of largest variance and their weights are kept in `tables/`; a test derives them again. All coefficients
//! of the kernel that this amounts to are positive, so no frequency is ever rewarded for being loud.

use super::anneal::{Features, LANES};
use crate::{lattice, sobol, strata};

/// What offsets move.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pattern {
    /// i/n, in one dimension.
    Regular,
    /// Points of the (0, 2)-sequence.
    Sobol,
    /// Points of the extensible lattice of two components.
    Lattice,
}

impl Pattern {
    /// Point i of n; in one dimension the second number is 0.
    pub fn point(self, i: u32, samples: u32) -> [u32; 2] {
        match self {
            Self::Regular => [strata::regular_1d(i, samples), 0],
            Self::Sobol => sobol::point(i),
            Self::Lattice => [lattice::extensible(i, lattice::EXEW[0]), lattice::extensible(i, lattice::EXEW[1])],
        }
    }
}

/// One feature: basis function k, number of samples, and 2²⁴·weight/2¹⁴ of a sum of `samples` cosine products.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Column {
    /// Samples a pixel, n.
    pub samples: u32,
    /// Half-periods along x and y.
    pub k: [u32; 2],
    /// Scale of the sum of n products of two cosines of 2.14 fixed point each.
    pub weight: i64,
}

/// The values that a mask of 2^`size_log2` squared pixels holds, as ranks: all of them in one channel, the first S²
/// Sobol points in two, which are a net and in each channel a permutation. (One channel leaves the second at 0.)
pub fn value_set(channels: usize, size_log2: u32) -> Vec<[u16; 2]> {
    let rank = |value_fx: u32| (value_fx >> (32 - 2 * size_log2)) as u16;
    let value = |i: u32| if channels == 1 { [i as u16, 0] } else { sobol::point(i).map(rank) };
    (0..1 << (2 * size_log2)).map(value).collect()
}

/// The place of every value in an order in which near values stand near: a Z curve, which in one channel is the rank.
pub fn value_order(set: &[[u16; 2]]) -> Vec<u16> {
    let morton = |value: [u16; 2]| {
        (0..16).fold(0u32, |z, bit| {
            z | u32::from(value[0] >> bit & 1) << (2 * bit) | u32::from(value[1] >> bit & 1) << (2 * bit + 1)
        })
    };
    let mut sorted: Vec<(u32, u16)> =
        set.iter().enumerate().map(|(item, &value)| (morton(value), item as u16)).collect();
    sorted.sort_unstable();
    let mut order = vec![0; set.len()];
    for (place, &(_, item)) in sorted.iter().enumerate() {
        order[usize::from(item)] = place as u16;
    }
    order
}

/// One feature vector for every value of the set. `cosine` is a quarter of a wave in 256 steps, 2.14 fixed point.
pub fn vectors(
    set: &[[u16; 2]],
    pattern: Pattern,
    size_log2: u32,
    columns: &[Column],
    cosine: &[i32],
) -> Vec<Features> {
    let mut vectors = vec![[[0; 8]; LANES / 8]; set.len()];
    for (lane, column) in columns.iter().enumerate() {
        let pattern: Vec<[u32; 2]> = (0..column.samples).map(|i| pattern.point(i, column.samples)).collect();
        for (value, vector) in set.iter().zip(&mut vectors) {
            let offset = value.map(|rank| (2 * u32::from(rank) + 1) << (31 - 2 * size_log2));
            let mut sum = 0;
            let mut i = 0;
            while i < pattern.len() {
                let x = cos_pi(column.k[0], pattern[i][0].wrapping_add(offset[0]), cosine);
                let y = cos_pi(column.k[1], pattern[i][1].wrapping_add(offset[1]), cosine);
                sum += (x * y) >> 14;
                i += 1;
            }
            vector[lane / 8][lane % 8] = ((i64::from(sum) * column.weight + (1 << 23)) >> 24) as i32;
        }
    }
    vectors
}

/// cos(π k x) for 0.32 fixed-point x.
fn cos_pi(k: u32, x: u32, cosine: &[i32]) -> i32 {
    // The phase in 1024 steps a period; x is half of one for k = 1.
    let phase = ((u64::from(k) * u64::from(x) + (1 << 22)) >> 23 & 1023) as usize;
    match phase >> 8 {
        0 => cosine[phase],
        1 => -cosine[512 - phase],
        2 => -cosine[phase - 512],
        _ => cosine[1024 - phase],
    }
}
