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
//! Over time there is a tile for every frame, and a window of weights for every distance in time: of one pixel if a one
//! is felt over its own tile and by its own pixel in the tiles around (Wolfe and others 2022), wider if frames are
//! filtered together. Each step is taken once in every tile, so that all of them hold every rank once; the last frame
//! stands before the first.
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
    over_time([size_log2, 0], &[Window::round(kernel)], rng)
}

/// The same of 2^`frames_log2` tiles, one after the other; `windows[t]` are the weights at t frames' distance, forwards
/// and backwards, of which there is at least the first. All of them together stay below 2²⁹.
pub fn over_time([size_log2, frames_log2]: [u32; 2], windows: &[Window], rng: &mut Xoshiro256PlusPlus) -> Vec<u16> {
    let (area, frames) = (1usize << (2 * size_log2), 1usize << frames_log2);
    let mut space = Space { windows, size_log2, field: vec![0; area * frames] };
    let ones = initial_ones(area);

    for frame in 0..frames {
        let mut scattered = 0;
        while scattered < ones {
            let pixel = (rng.next_u64() >> (64 - 2 * size_log2)) as usize;
            if space.tile(frame)[pixel] < ONE {
                space.splat(frame, pixel, 1);
                scattered += 1;
            }
        }
    }
    let mut moved = true;
    while moved {
        moved = false;
        for frame in 0..frames {
            let cluster = argmax(space.tile(frame));
            space.splat(frame, cluster, -1);
            let void = argmin(space.tile(frame));
            space.splat(frame, void, 1);
            moved |= void != cluster;
        }
    }

    let mut ranks = vec![0u16; area * frames];
    let prototype = space.field.clone();
    let mut rank = ones;
    while rank > 0 {
        rank -= 1;
        for turn in 0..frames {
            let frame = whose_turn(turn, rank, frames_log2);
            let cluster = argmax(space.tile(frame));
            space.splat(frame, cluster, -1);
            ranks[frame * area + cluster] = rank as u16;
        }
    }
    space.field = prototype;
    let mut bounds: Vec<Bounds> = (0..frames).map(|frame| Bounds::new(space.tile(frame))).collect();
    rank = ones;
    while rank < area {
        let mut turn = 0;
        while turn < frames {
            let frame = whose_turn(turn, rank, frames_log2);
            let void = bounds[frame].argmin(space.tile(frame));
            space.splat(frame, void, 1);
            ranks[frame * area + void] = rank as u16;
            turn += 1;
        }
        rank += 1;
    }
    ranks
}

/// Tiles take turns in bit-reversed order, another one first for every rank, so that none always has the choice.
fn whose_turn(turn: usize, rank: usize, frames_log2: u32) -> usize {
    let reversed = ((turn as u64).reverse_bits() >> 1 >> (63 - frames_log2)) as usize;
    (reversed + rank) & ((1 << frames_log2) - 1)
}

/// What every pixel of every tile feels of the ones.
struct Space<'a> {
    windows: &'a [Window],
    size_log2: u32,
    /// Tile by tile.
    field: Vec<i32>,
}

impl Space<'_> {
    fn tile(&self, frame: usize) -> &[i32] {
        &self.field[frame << (2 * self.size_log2)..(frame + 1) << (2 * self.size_log2)]
    }

    /// Adds (`sign` = 1) or takes away (−1) a one. Frames fewer than the windows wrap: these repeat, too.
    fn splat(&mut self, frame: usize, pixel: usize, sign: i32) {
        let area = 1 << (2 * self.size_log2);
        let last = self.field.len() / area - 1;
        let mut distance = 0;
        while distance < self.windows.len() {
            let after = frame.wrapping_add(distance) & last;
            self.windows[distance].splat(
                &mut self.field[after * area..(after + 1) * area],
                self.size_log2,
                pixel,
                sign,
            );
            if distance > 0 {
                let before = frame.wrapping_sub(distance) & last;
                let tile = &mut self.field[before * area..(before + 1) * area];
                self.windows[distance].splat(tile, self.size_log2, pixel, sign);
            }
            distance += 1;
        }
        self.field[frame * area + pixel] += sign * ONE;
    }
}

/// Weights around a pixel, row by row; each row from its first to its last that is not 0.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Window {
    radius: usize,
    /// Of every row the part of `weights`, which begins this far from the left end of the square.
    rows: Vec<[usize; 3]>,
    weights: Vec<i32>,
}

impl Window {
    /// `kernel[r²]` is the weight at squared distance r².
    pub fn round(kernel: &[i32]) -> Self {
        let radius = (kernel.len() - 1).isqrt();
        Self::new(radius, |dx, dy| kernel.get(dx * dx + dy * dy).copied().unwrap_or(0))
    }

    /// The weight of every distance along x and y, 0..=`radius` each.
    pub fn new(radius: usize, weight: impl Fn(usize, usize) -> i32) -> Self {
        let (mut rows, mut weights) = (Vec::new(), Vec::new());
        for y in 0..=2 * radius {
            let row: Vec<i32> = (0..=2 * radius).map(|x| weight(x.abs_diff(radius), y.abs_diff(radius))).collect();
            let first = row.iter().position(|&weight| weight != 0).unwrap_or(radius);
            rows.push([first, weights.len(), weights.len() + row.len() - 2 * first]);
            weights.extend(&row[first..row.len() - first]);
        }
        Self { radius, rows, weights }
    }

    /// Adds or takes away in a tile. One smaller than the window wraps: the kernel repeats, too.
    fn splat(&self, field: &mut [i32], size_log2: u32, pixel: usize, sign: i32) {
        let mask = (1usize << size_log2) - 1;
        let (x, y) = (pixel & mask, pixel >> size_log2);
        // Sums that cannot be negative, and slices: unoptimised, `wrapping_add` and a `Vec`'s index are calls.
        let wraps = (self.radius | mask) + 1 - self.radius;
        let (left, top) = (x + wraps, y + wraps);
        let rows: &[[usize; 3]] = &self.rows;
        let mut j = 0;
        while j < rows.len() {
            let [first, begin, end] = rows[j];
            let (weights, start) = (&self.weights[begin..end], (left + first) & mask);
            let row = ((top + j) & mask) << size_log2;
            j += 1;
            if start + weights.len() <= mask + 1 {
                let cells = &mut field[row | start..(row | start) + weights.len()];
                let mut i = 0;
                while i < weights.len() {
                    cells[i] += sign * weights[i];
                    i += 1;
                }
            } else {
                let mut i = 0;
                while i < weights.len() {
                    field[row | ((start + i) & mask)] += sign * weights[i];
                    i += 1;
                }
            }
        }
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
