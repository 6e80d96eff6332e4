//! Void-and-cluster (Ulichney 1993): an order of a tile's pixels in which every prefix is evenly spread.
//!
//! ```text
//! scatter a few ones; move the tightest cluster to the largest void until that changes nothing
//! take the ones away, tightest cluster first          → their ranks, downwards
//! put them back, then fill the largest void, repeatedly → the other ranks, upwards
//! ```
//! Ulichney's third phase (clusters of the minority of zeros) picks the same pixels as filling voids, since the two
//! fields add up to a constant.
//!
//! The field is a sum of integer kernel weights, so it never drifts and ties are real; the first pixel wins them.

use rand::Rng;
use rand::rngs::Xoshiro256PlusPlus;

/// Ones stand this far above zeros in the field: its minimum is the largest void, its maximum the tightest cluster.
const ONE: i32 = 1 << 30;

/// Few ones to start with, since taking them away orders them worse than filling voids does: a tenth of the pixels,
/// as usual, costs a tenth more error after a wide filter. Past a few hundred they make no difference.
fn initial_ones(area: usize) -> usize {
    (area / 50).min(512)
}

/// Ranks 0..S²−1 of a tile of 2^`size_log2` squared pixels, row by row.
///
/// `kernel[r²]` is the weight at squared distance r², zero past its end.
pub fn void_and_cluster(size_log2: u32, kernel: &[i32], rng: &mut Xoshiro256PlusPlus) -> Vec<u16> {
    let area = 1usize << (2 * size_log2);
    let window = Window::new(kernel);
    let mut field = vec![0i32; area];

    let mut ones = 0;
    while ones < initial_ones(area) {
        let pixel = (rng.next_u64() >> (64 - 2 * size_log2)) as usize;
        if field[pixel] < ONE {
            window.splat(&mut field, size_log2, pixel, 1);
            ones += 1;
        }
    }
    loop {
        let cluster = argmax(&field);
        window.splat(&mut field, size_log2, cluster, -1);
        let void = argmin(&field);
        window.splat(&mut field, size_log2, void, 1);
        if void == cluster {
            break;
        }
    }

    let mut ranks = vec![0u16; area];
    let prototype = field.clone();
    let mut rank = ones;
    while rank > 0 {
        rank -= 1;
        let cluster = argmax(&field);
        window.splat(&mut field, size_log2, cluster, -1);
        ranks[cluster] = rank as u16;
    }
    field = prototype;
    let mut bounds = Bounds::new(&field);
    rank = ones;
    while rank < area {
        let void = bounds.argmin(&field);
        window.splat(&mut field, size_log2, void, 1);
        ranks[void] = rank as u16;
        rank += 1;
    }
    ranks
}

/// The kernel as a square of weights around a pixel.
struct Window {
    radius: usize,
    weights: Vec<i32>,
}

impl Window {
    fn new(kernel: &[i32]) -> Self {
        let radius = (kernel.len() - 1).isqrt();
        let side = 2 * radius + 1;
        let mut weights = vec![0; side * side];
        for (i, weight) in weights.iter_mut().enumerate() {
            let (dx, dy) = ((i % side).abs_diff(radius), (i / side).abs_diff(radius));
            *weight = kernel.get(dx * dx + dy * dy).copied().unwrap_or(0);
        }
        Self { radius, weights }
    }

    /// Adds (`sign` = 1) or takes away (−1) a one. A tile smaller than the window wraps: the kernel repeats, too.
    fn splat(&self, field: &mut [i32], size_log2: u32, pixel: usize, sign: i32) {
        let mask = (1usize << size_log2) - 1;
        let (x, y) = (pixel & mask, pixel >> size_log2);
        let side = 2 * self.radius + 1;
        let left = x.wrapping_sub(self.radius);
        let mut w = 0;
        let mut j = 0;
        while j < side {
            let row = (y.wrapping_sub(self.radius).wrapping_add(j) & mask) << size_log2;
            let mut i = 0;
            while i < side {
                field[row | (left.wrapping_add(i) & mask)] += sign * self.weights[w];
                w += 1;
                i += 1;
            }
            j += 1;
        }
        field[pixel] += sign * ONE;
    }
}

/// The first minimum of a field that only grows: stored minima of blocks are lower bounds, and only the block that
/// looks best is looked at again.
struct Bounds {
    blocks: Vec<i32>,
    groups: Vec<i32>,
}

const BLOCK: usize = 64;
const GROUP: usize = 32;

impl Bounds {
    fn new(field: &[i32]) -> Self {
        let blocks: Vec<i32> = field.chunks(BLOCK).map(|cells| cells[argmin(cells)]).collect();
        let groups = blocks.chunks(GROUP).map(|minima| minima[argmin(minima)]).collect();
        Self { blocks, groups }
    }

    fn argmin(&mut self, field: &[i32]) -> usize {
        loop {
            let group = argmin(&self.groups);
            let first = group * GROUP;
            let minima = &mut self.blocks[first..(first + GROUP).min(field.len() / BLOCK)];
            let block = argmin(minima);
            let cells = &field[(first + block) * BLOCK..(first + block + 1) * BLOCK];
            let cell = argmin(cells);
            if cells[cell] == self.groups[group] {
                return (first + block) * BLOCK + cell;
            }
            minima[block] = cells[cell];
            self.groups[group] = minima[argmin(minima)];
        }
    }
}

// `while`, not iterators: builds of dependents run this unoptimised, where closures are calls.
fn argmin(values: &[i32]) -> usize {
    let mut best = 0;
    let mut i = 1;
    while i < values.len() {
        if values[i] < values[best] {
            best = i;
        }
        i += 1;
    }
    best
}

fn argmax(values: &[i32]) -> usize {
    let mut best = 0;
    let mut i = 1;
    while i < values.len() {
        if values[i] > values[best] {
            best = i;
        }
        i += 1;
    }
    best
}
