//! What a filter leaves of a character over the picture: its Walsh function over 4×4 pixels, in one of eight variants,
//! times a sign of the block.
//!
//! The sign is that of a place on the shuffled curve: the same up to some level, one of three ways to halve a 2×2
//! square of cells there, unrelated above.

use crate::random::Random;

/// Levels of the curve that have columns (squares of 8, 16 and 32 pixels), and none of them.
pub const LEVELS: usize = 4;
/// Functions of a place: 4 bits inside a block and 6 of the block's place.
pub const FUNCTIONS: usize = 1 << 10;

/// Pixels along a side of a picture.
const SIDE: usize = 128;
const BLOCKS: usize = SIDE / 4;
const PICTURES: u64 = 16;
/// Standard deviations of the filters, and their weights.
const FILTERS: [(f64, f64); 4] = [(1.0, 1.0), (2.1, 0.1), (4.0, 0.05), (8.0, 0.08)];
/// What a sign that is the same over more than a block costs, by level: it makes a texture.
const REGULAR: [f32; LEVELS] = [0.0, 0.2, 0.6, 1.6];

/// For each function of a place what it costs, white noise 1 for every filter.
pub fn costs() -> Vec<f32> {
    let kernels: Vec<Vec<f64>> = FILTERS.iter().map(|&(sigma, _)| kernel(sigma)).collect();
    let table: Vec<[f32; LEVELS]> =
        (0..16).map(|inside| core::array::from_fn(|level| cost(inside, level, &kernels))).collect();
    let of = |function: usize| {
        let (inside, place) = (function & 15, function >> 4);
        let level = if place == 0 { LEVELS - 1 } else { place.trailing_zeros() as usize / 2 };
        table[inside][level] + if inside == 0 { 0.0 } else { REGULAR[level] }
    };
    (0..FUNCTIONS).map(of).collect()
}

/// Weights of a Gaussian along an axis, periodic, sum 1.
fn kernel(sigma: f64) -> Vec<f64> {
    let weight = |k: usize| {
        let distance = k.min(SIDE - k) as f64;
        libm::exp(-distance * distance / (2.0 * sigma * sigma))
    };
    let weights: Vec<f64> = (0..SIDE).map(weight).collect();
    let sum: f64 = weights.iter().sum();
    weights.iter().map(|w| w / sum).collect()
}

fn cost(inside: usize, level: usize, kernels: &[Vec<f64>]) -> f32 {
    let mut total = 0.0;
    for picture in 0..PICTURES {
        let image = image(inside, level, &mut Random::new(picture << 8 | (level as u64) << 4 | inside as u64));
        for (kernel, (_, weight)) in kernels.iter().zip(FILTERS) {
            let white = kernel.iter().map(|k| k * k).sum::<f64>();
            total += weight * mean_square(&filtered(&filtered(&image, kernel), kernel)) / (white * white);
        }
    }
    (total / PICTURES as f64) as f32
}

fn image(inside: usize, level: usize, random: &mut Random) -> Vec<f64> {
    // Cells of the same sign, four of them a square.
    let cell = 1 << level.min(3);
    let mut signs = vec![1.0; BLOCKS * BLOCKS];
    for square_y in 0..BLOCKS / (2 * cell) {
        for square_x in 0..BLOCKS / (2 * cell) {
            let signs_of_cells = if level + 1 < LEVELS {
                let halves = 1 + random.below(3);
                let sign = 1.0 - 2.0 * random.below(2) as f64;
                [0, 1, 2, 3].map(|c: usize| if (c & halves).count_ones() == 1 { -sign } else { sign })
            } else {
                [0; 4].map(|_| 1.0 - 2.0 * random.below(2) as f64)
            };
            for y in 0..2 * cell {
                for x in 0..2 * cell {
                    let at = (square_y * 2 * cell + y) * BLOCKS + square_x * 2 * cell + x;
                    signs[at] = signs_of_cells[x / cell + 2 * (y / cell)];
                }
            }
        }
    }
    let variants: Vec<usize> = (0..BLOCKS * BLOCKS).map(|_| random.below(8)).collect();
    let pixel = |i: usize| {
        let (x, y) = (i % SIDE, i / SIDE);
        let block = y / 4 * BLOCKS + x / 4;
        let odd = (place_inside(x & 3, y & 3, variants[block]) & inside).count_ones() & 1 == 1;
        if odd { -signs[block] } else { signs[block] }
    };
    (0..SIDE * SIDE).map(pixel).collect()
}

/// As `Sampler` has it: transposed or not; the upper bits added to the lower ones of the other axis or not.
fn place_inside(x: usize, y: usize, variant: usize) -> usize {
    let (u, v) = if variant & 4 == 4 { (y, x) } else { (x, y) };
    let u = u ^ (variant >> 1 & v >> 1 & 1);
    u | (v ^ (variant & u >> 1 & 1)) << 2
}

/// Filtered along the rows, and transposed.
fn filtered(image: &[f64], kernel: &[f64]) -> Vec<f64> {
    let reach = kernel.iter().take(SIDE / 2).position(|&k| k < 1e-9).unwrap_or(SIDE / 2);
    let mut out = vec![0.0; SIDE * SIDE];
    for (y, row) in image.chunks_exact(SIDE).enumerate() {
        for x in 0..SIDE {
            let mut sum = kernel[0] * row[x];
            for k in 1..reach {
                sum += kernel[k] * (row[(x + k) % SIDE] + row[(x + SIDE - k) % SIDE]);
            }
            out[x * SIDE + y] = sum;
        }
    }
    out
}

fn mean_square(image: &[f64]) -> f64 {
    image.iter().map(|v| v * v).sum::<f64>() / image.len() as f64
}
