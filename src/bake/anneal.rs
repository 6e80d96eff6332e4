//! The feature-field annealer: swaps the items of a tile until the error of rendered pixels is blue noise.
//!
//! Every item (a mask value) has a vector f of errors that a pixel would make with it, see
//! [`features`](super::features). The energy Σ_{p≠q} w(p−q)⟨f_p, f_q⟩ with w = exp(−r²/2.2²) is, up to a constant, the
//! power of the error image after a Gaussian of standard deviation 2.2/2 pixels. (Georgiev and Fajardo 2016 swap pixels
//! too, but by a kernel of the distance of their values, which is a poor proxy of that power.)
//!
//! ```text
//! field F = w ∗ f, with w(0) = 0
//! repeat: p = any pixel, q = one whose value is within reach of p's, not in its window
//!     Δ = (f_q − f_p)·(F_p − F_q)        half the change of the energy if their items swap
//!     Δ < threshold: swap, and update F around both
//! threshold and reach fall
//! ```
//! A far value is a step too large late in the day: the falling reach saves two thirds of the proposals. Threshold
//! accepting (Dueck and Scheuer 1990) ends where Metropolis does and needs no logarithm. All numbers are integers: the
//! same tile on every machine. For two threads the rows are moved round and cut into two halves, each of which swaps
//! only pixels whose window lies inside.
//!
//! Over time there is a tile for every frame, a row of each by turns, and w has a part between the same pixels of near
//! frames: w_t(s)⟨f_p, f_q⟩ for frames s apart (Wolfe and others 2022). Pixels swap within their frame.

use rand::rngs::Xoshiro256PlusPlus;
use rand::{Rng, SeedableRng};

/// Numbers in a feature vector, in rows that are unrolled by hand: this runs unoptimised in builds of dependents.
pub const LANES: usize = 48;
/// A feature vector. Magnitudes up to 63 and neighbours' weights of up to 2818 in all (they are 1808, over time 2050)
/// keep every sum below within an `i32`.
pub type Features = [[i32; 8]; LANES / 8];
/// A vector of the field: two lanes a word, lane 2i + 2³²·lane 2i+1 modulo 2⁶⁴. Sums of such words are the sums of
/// their lanes, and halve the work of adding.
type Packed = Words<{ LANES / 8 }>;
/// Such a vector of any length.
pub(super) type Words<const ROWS: usize> = [[u64; 4]; ROWS];
/// The window reaches this far: weights beyond are below one part in 128.
pub const RADIUS: usize = 4;

const PHASES: usize = 96;
/// Thousandths of a pixel's own power.
const FIRST_THRESHOLD: u64 = 65;
/// What the lanes after the first eight may take off a Δ, in thresholds: found by trial, 1 loses and 8 wins nothing.
const SCREEN: i32 = 4;

/// Swaps the items of 2^`frames_log2` tiles of 2^`size_log2` squared pixels, within each, and returns the item of every
/// pixel, row by row, tile after tile.
///
/// Item i has `features[i]` and is number `order[i]` in an order in which near values stand near. `kernel[r²]` are the
/// weights in a tile, `time_kernel[t]` at t frames' distance, of which that at 0 is not read; one tile needs none.
/// `proposals` swaps a pixel are tried.
pub fn anneal(
    [size_log2, frames_log2]: [u32; 2],
    features: &[Features],
    order: &[u16],
    kernel: &[i32],
    time_kernel: &[i32],
    proposals: usize,
    seed: u64,
) -> Vec<u16> {
    let (size, pitch) = (1usize << size_log2, 1usize << (size_log2 + frames_log2));
    let window = Window::over_time(kernel, time_kernel, frames_log2);
    let mut rng = Xoshiro256PlusPlus::seed_from_u64(seed);
    let mut items = vec![0; size * pitch];
    for frame in 0..1 << frames_log2 {
        for (i, item) in shuffled(features.len(), &mut rng).into_iter().enumerate() {
            items[i / size * pitch + frame * size + i % size] = item;
        }
    }
    let mut field: Vec<Packed> = vec![[[0; 4]; LANES / 8]; items.len()];
    for pixel in 0..items.len() {
        window.splat(&mut field, size_log2, size, pixel, &pack(&features[items[pixel] as usize]), 1);
    }

    // Halves of a tile below 64 pixels would hardly have an inside.
    let halves = if size < 64 { 1 } else { 2 };
    let (rows, margin) = if halves == 1 { (size, 0) } else { (size / 2, RADIUS) };
    let tries = proposals * items.len() / halves / PHASES;
    let power = power(features, kernel[0]);
    // 1 in 16.16 fixed point; after all phases a twentieth.
    let mut level = 1u64 << 16;
    for _ in 0..PHASES {
        let turn = (rng.next_u64() >> (64 - size_log2)) as usize * pitch;
        items.rotate_left(turn);
        field.rotate_left(turn);
        let threshold = ((power * FIRST_THRESHOLD / 1000 * level) >> 16) as i32;
        let seeds = [rng.next_u64(), rng.next_u64()];
        let sweep = |items: &mut [u16], field: &mut [Packed], seed| {
            let mut part = Part { features, order, window: &window, items, field, size_log2, rows, margin };
            part.sweep(threshold, level, tries, seed);
        };
        if halves == 1 {
            sweep(&mut items, &mut field, seeds[0]);
        } else {
            let (items_a, items_b) = items.split_at_mut(rows * pitch);
            let (field_a, field_b) = field.split_at_mut(rows * pitch);
            rayon::join(|| sweep(items_a, field_a, seeds[0]), || sweep(items_b, field_b, seeds[1]));
        }
        level = (level * 63_509) >> 16; // .05^(1/95)
    }
    let frame = |t: usize| items.chunks(pitch).flat_map(move |rows| &rows[t * size..(t + 1) * size]);
    (0..1 << frames_log2).flat_map(frame).copied().collect()
}

/// w(0)‖f‖², the mean over items: what a pixel alone would add.
fn power(features: &[Features], weight: i32) -> u64 {
    let squares: u64 = features.iter().flatten().flatten().map(|f| u64::from(f.unsigned_abs()).pow(2)).sum();
    squares * u64::from(weight.unsigned_abs()) / features.len() as u64
}

pub(super) fn shuffled(count: usize, rng: &mut Xoshiro256PlusPlus) -> Vec<u16> {
    let mut items: Vec<u16> = (0..count).map(|i| i as u16).collect();
    for i in (1..count).rev() {
        let j = ((rng.next_u64() >> 32) * (i as u64 + 1)) >> 32;
        items.swap(i, j as usize);
    }
    items
}

/// Some rows of the tile, which wrap; a margin of rows at both ends keeps swaps from noticing that.
struct Part<'a> {
    features: &'a [Features],
    order: &'a [u16],
    window: &'a Window,
    items: &'a mut [u16],
    field: &'a mut [Packed],
    size_log2: u32,
    rows: usize,
    margin: usize,
}

impl Part<'_> {
    fn sweep(&mut self, threshold: i32, reach: u64, tries: usize, seed: u64) {
        let mut rng = Xoshiro256PlusPlus::seed_from_u64(seed);
        let mut pixels = self.by_value();
        let (all, count) = (pixels.len(), pixels.len() >> self.window.frames_log2);
        let span = (count as u64 * reach) >> 17; // forwards only: half of what is within reach
        let screen = threshold * SCREEN;
        let mut tried = 0;
        while tried < tries {
            tried += 1;
            let bits = rng.next_u64();
            let a = (((bits >> 32) * all as u64) >> 32) as usize;
            let step = (((bits & 0xffff_ffff) * span) >> 32) as usize + 1;
            let b = if a % count + step < count { a + step } else { a + step - count };
            let (p, q) = (pixels[a] as usize, pixels[b] as usize);
            if near(p, q, self.size_log2, self.window.frames_log2, self.rows) {
                continue;
            }
            let (f_p, f_q) = (&self.features[self.items[p] as usize], &self.features[self.items[q] as usize]);
            let (at_p, at_q) = (&self.field[p], &self.field[q]);
            let mut delta = part(&f_p[0], &f_q[0], &at_p[0], &at_q[0]);
            if delta > screen {
                continue;
            }
            let mut k = 1;
            while k < LANES / 8 {
                delta += part(&f_p[k], &f_q[k], &at_p[k], &at_q[k]);
                k += 1;
            }
            if delta < threshold {
                let change = difference(&pack(f_p), &pack(f_q));
                self.window.splat(self.field, self.size_log2, self.rows, p, &change, 1);
                self.window.splat(self.field, self.size_log2, self.rows, q, &change, -1);
                self.items.swap(p, q);
                pixels.swap(a, b);
            }
        }
    }

    /// The pixels between the margins, frame by frame in the order of their values.
    fn by_value(&self) -> Vec<u32> {
        let (row_log2, frames) = (self.size_log2 + self.window.frames_log2, 1 << self.window.frames_log2);
        let mut at = vec![u32::MAX; self.order.len() * frames];
        let mut pixel = self.margin << row_log2;
        while pixel < (self.rows - self.margin) << row_log2 {
            let frame = (pixel >> self.size_log2) & (frames - 1);
            at[frame * self.order.len() + self.order[self.items[pixel] as usize] as usize] = pixel as u32;
            pixel += 1;
        }
        at.retain(|&pixel| pixel != u32::MAX);
        at
    }
}

/// Eight lanes of (f_q − f_p)·(F_p − F_q).
fn part(f_p: &[i32; 8], f_q: &[i32; 8], at_p: &[u64; 4], at_q: &[u64; 4]) -> i32 {
    let word_0 = at_p[0].wrapping_sub(at_q[0]);
    let word_1 = at_p[1].wrapping_sub(at_q[1]);
    let word_2 = at_p[2].wrapping_sub(at_q[2]);
    let word_3 = at_p[3].wrapping_sub(at_q[3]);
    // A negative low lane has borrowed one from the high lane: its sign bit gives it back.
    (f_q[0] - f_p[0]) * word_0 as i32
        + (f_q[1] - f_p[1]) * (word_0.wrapping_add(1 << 31) >> 32) as i32
        + (f_q[2] - f_p[2]) * word_1 as i32
        + (f_q[3] - f_p[3]) * (word_1.wrapping_add(1 << 31) >> 32) as i32
        + (f_q[4] - f_p[4]) * word_2 as i32
        + (f_q[5] - f_p[5]) * (word_2.wrapping_add(1 << 31) >> 32) as i32
        + (f_q[6] - f_p[6]) * word_3 as i32
        + (f_q[7] - f_p[7]) * (word_3.wrapping_add(1 << 31) >> 32) as i32
}

/// Two lanes a word.
pub(super) fn pack<const ROWS: usize, T: Copy + Into<i64>>(features: &[[T; 8]; ROWS]) -> Words<ROWS> {
    let mut packed = [[0; 4]; ROWS];
    let mut lane = 0;
    while lane < 8 * ROWS {
        let [low, high]: [i64; 2] = [features[lane / 8][lane % 8].into(), features[lane / 8][lane % 8 + 1].into()];
        packed[lane / 8][lane % 8 / 2] = (low as u64).wrapping_add((high as u64) << 32);
        lane += 2;
    }
    packed
}

pub(super) fn difference<const ROWS: usize>(p: &Words<ROWS>, q: &Words<ROWS>) -> Words<ROWS> {
    let mut change = *q;
    let mut k = 0;
    while k < ROWS {
        let mut i = 0;
        while i < 4 {
            change[k][i] = q[k][i].wrapping_sub(p[k][i]);
            i += 1;
        }
        k += 1;
    }
    change
}

fn times<const ROWS: usize>(change: &Words<ROWS>, weight: i32) -> Words<ROWS> {
    let mut product = *change;
    let mut k = 0;
    while k < ROWS {
        let (to, by) = (&mut product[k], weight as u64);
        to[0] = to[0].wrapping_mul(by);
        to[1] = to[1].wrapping_mul(by);
        to[2] = to[2].wrapping_mul(by);
        to[3] = to[3].wrapping_mul(by);
        k += 1;
    }
    product
}

/// Whether each pixel of a frame is in the other's window, on the torus of `rows` rows (or is the other).
pub(super) fn near(p: usize, q: usize, size_log2: u32, frames_log2: u32, rows: usize) -> bool {
    let (size, row_log2) = (1 << size_log2, size_log2 + frames_log2);
    let dx = (p & (size - 1)).wrapping_sub(q & (size - 1)).wrapping_add(RADIUS) & (size - 1);
    let dy = (p >> row_log2).wrapping_sub(q >> row_log2).wrapping_add(RADIUS) & (rows - 1);
    dx <= 2 * RADIUS && dy <= 2 * RADIUS
}

/// The weights around a pixel, without the pixel itself.
pub(super) struct Window {
    /// Every weight that occurs, with the places where it does: right, down, and frames forwards.
    rings: Vec<(i32, Vec<[usize; 3]>)>,
    frames_log2: u32,
}

impl Window {
    pub(super) fn new(kernel: &[i32]) -> Self {
        Self::over_time(kernel, &[], 0)
    }

    fn over_time(kernel: &[i32], time_kernel: &[i32], frames_log2: u32) -> Self {
        let ring = |r2: usize| {
            let side = 2 * RADIUS + 1;
            let places = (0..side * side).map(|i| [i % side, i / side]);
            let here = places.filter(|p| p[0].abs_diff(RADIUS).pow(2) + p[1].abs_diff(RADIUS).pow(2) == r2);
            let steps = here.map(|[x, y]| [x.wrapping_sub(RADIUS), y.wrapping_sub(RADIUS), 0]);
            (kernel[r2], steps.collect::<Vec<_>>())
        };
        let space = (1..kernel.len()).map(ring).filter(|ring| !ring.1.is_empty());
        let in_time = |t: usize| (time_kernel[t], vec![[0, 0, t], [0, 0, t.wrapping_neg()]]);
        Self { rings: space.chain((1..time_kernel.len()).map(in_time)).collect(), frames_log2 }
    }

    /// Adds `sign`·w·`change` to the field around a pixel.
    pub(super) fn splat<const ROWS: usize>(
        &self,
        field: &mut [Words<ROWS>],
        size_log2: u32,
        rows: usize,
        pixel: usize,
        change: &Words<ROWS>,
        sign: i32,
    ) {
        let (mask, frames, row_log2) =
            ((1 << size_log2) - 1, (1 << self.frames_log2) - 1, size_log2 + self.frames_log2);
        let (x, y, t) = (pixel & mask, pixel >> row_log2, pixel >> size_log2 & frames);
        for (weight, places) in &self.rings {
            let by = times(change, sign * weight);
            let mut i = 0;
            while i < places.len() {
                let [dx, dy, dt] = places[i];
                i += 1;
                let row = (y.wrapping_add(dy) & (rows - 1)) << row_log2 | (t.wrapping_add(dt) & frames) << size_log2;
                let cell = &mut field[row | (x.wrapping_add(dx) & mask)];
                let mut k = 0;
                while k < ROWS {
                    let (to, by) = (&mut cell[k], &by[k]);
                    to[0] = to[0].wrapping_add(by[0]);
                    to[1] = to[1].wrapping_add(by[1]);
                    to[2] = to[2].wrapping_add(by[2]);
                    to[3] = to[3].wrapping_add(by[3]);
                    k += 1;
                }
            }
        }
    }
}
