//! Keys of a tile: the first points of the sequence, one for every pixel, so that they are a net over the tile.
//!
//! A pixel's samples are points 0, 1, 2, … of the [sequence](crate::sequence) ⊕ its key. If the key is point k, they
//! are points k, k ⊕ 1, k ⊕ 2, …: of the first 2ᵐ samples k >> m tells which block of the sequence they are.
//!
//! ```text
//! number k of every pixel: over a patch of 16×16 a sum modulo 2 of COLUMNS
//! of every four numbers that differ in the last two bits, all change places at random
//! field F = w ∗ f, with w(0) = 0
//! repeat: p = any pixel, q = the one whose number differs from p's in the last two bits, four, six, or any
//!     Δ = (f_q − f_p)·(F_p − F_q)        half the change of the energy if their numbers swap
//!     Δ < threshold: swap, and update F around both
//! the threshold falls to 0
//! ```
//! f are the errors of a basis of cosines, as in [`features`](super::features), 32 of each of the [`PREFIXES`] and only
//! of those that a swap can change. Δ is half the change of the power of the filtered error image, as in
//! [`anneal`](super::anneal).
//!
//! The columns alone would do for the error: that of the first 2ᵐ samples is then a sum of Walsh functions over a
//! patch. But they show, and two places of a tile of few patches would match. Random changes leave nothing of that in
//! the first samples, and touch no set of four; the search makes the samples blue again. Patches are mirrored and
//! turned at random. They share out all numbers, since the columns' sums are a subspace, of which each patch has a
//! coset of its own.

use rand::Rng;
use rand::rngs::Xoshiro256PlusPlus;

use super::anneal::{Window, Words, difference, near, pack, shuffled};
use super::features::Column;
use crate::sequence::Sequence;

/// Numbers of samples whose errors are annealed.
pub const PREFIXES: [u32; 4] = [1, 4, 16, 64];
/// Numbers in a feature vector of one prefix.
pub const LANES: usize = 32;
const ROWS: usize = LANES / 8;
/// A feature vector. Magnitudes up to 63 keep every row of eight products within an `i32`.
pub type Features = [[i16; 8]; ROWS];

/// Where the threshold starts, in thousandths of a pixel's own power.
const FIRST_THRESHOLD: i64 = 50;

/// What bits of the coordinates inside a patch add to a pixel's number: bit 0 of x, bit 0 of y, bit 1 of x, …
///
/// The best of 60 runs of simulated annealing by its error and its pattern: 40,000 tries each, Walsh power of
/// half-planes and of smooth integrands for 1, 2, 4, …, 256 samples, times what Gaussians of 1 and 2.1 pixels leave of
/// the function.
pub const COLUMNS: [u32; 8] = [0x38d, 0x706, 0xd36, 0x184, 0x672, 0x789, 0x01e, 0x03e];

/// log₂ of the side of a patch. With 8×8 pixels 16 samples have more error, and not less of a pattern.
const PATCH_LOG2: u32 = COLUMNS.len() as u32 / 2;

/// The number of every pixel of a tile of 2^`size_log2` squared by its patch, row by row: each of 0..S²−1 once. S is 64
/// or more.
pub fn start(size_log2: u32, rng: &mut Xoshiro256PlusPlus) -> Vec<u32> {
    let side = 1 << PATCH_LOG2;
    let patches_log2 = size_log2 - PATCH_LOG2;
    let cosets = cosets(2 * size_log2);
    let order = shuffled(1 << (2 * patches_log2), rng);
    let mut numbers = vec![0; 1 << (2 * size_log2)];
    for (patch, &coset) in order.iter().enumerate() {
        let (left, top) = (patch % (1 << patches_log2) * side, (patch >> patches_log2) * side);
        let base = sum(&cosets, usize::from(coset));
        let random = (rng.next_u64() >> (63 - 2 * PATCH_LOG2)) as usize;
        for p in 0..side * side {
            // Flips are sums modulo 2 as well.
            let (mut x, mut y) = ((p ^ random) % side, (p / side) ^ (random / side % side));
            if random >> (2 * PATCH_LOG2) == 1 {
                (x, y) = (y, x);
            }
            let number = (0..PATCH_LOG2 as usize).fold(base, |number, bit| {
                number ^ sum(&COLUMNS[2 * bit..2 * bit + 2], x >> bit & 1 | (y >> bit & 1) << 1)
            });
            numbers[(top + p / side) << size_log2 | (left + p % side)] = number;
        }
    }
    numbers
}

/// The upper 16 digits of both numbers of every pixel's key. Beyond those that make the net they are random.
pub fn keys(sequence: &Sequence, numbers: &[u32], rng: &mut Xoshiro256PlusPlus) -> Vec<u16> {
    let random = 0xffff_u16 >> numbers.len().ilog2();
    let digits = |&number: &u32| {
        let (point, bits) = (sequence.packed(number), rng.next_u64());
        let mixed = |point: u64, bits: u64| point as u16 & !random | bits as u16 & random;
        [mixed(point >> 48, bits >> 48), mixed(point >> 16, bits >> 32)]
    };
    numbers.iter().flat_map(digits).collect()
}

/// The sum modulo 2 of the columns that `bits` names.
fn sum(columns: &[u32], bits: usize) -> u32 {
    columns.iter().enumerate().filter(|(bit, _)| bits >> bit & 1 == 1).fold(0, |sum, (_, column)| sum ^ column)
}

/// Powers of two below 2^`bits` that make the columns a basis: sums of them tell cosets apart.
fn cosets(bits: u32) -> Vec<u32> {
    // By leading bits, each its own.
    let mut reduced = vec![0; bits as usize];
    let mut is_new = |mut column: u32| {
        while column != 0 {
            let lead = column.ilog2() as usize;
            if reduced[lead] == 0 {
                reduced[lead] = column;
                return true;
            }
            column ^= reduced[lead];
        }
        false
    };
    let independent = COLUMNS.iter().all(|&column| is_new(column));
    assert!(independent, "a patch would have numbers twice");
    (0..bits).map(|bit| 1 << bit).filter(|&column| is_new(column)).collect()
}

/// The first points of the sequence, packed as digits are.
pub fn points(sequence: &Sequence, count: u32) -> Vec<u32> {
    let packed = |i| (sequence.packed(i) >> 32 & 0xffff_0000 | sequence.packed(i) >> 16 & 0xffff) as u32;
    (0..count).map(packed).collect()
}

/// One feature vector for every aligned block of `prefix` points. `cosine` is a quarter of a wave in 256 steps, 2.14
/// fixed point.
pub fn vectors(points: &[u32], prefix: usize, columns: &[Column], cosine: &[i32]) -> Vec<Features> {
    let wave = &whole_wave(cosine)[..];
    let mut vectors = vec![[[0; 8]; ROWS]; points.len() / prefix];
    let all = &mut vectors[..];
    let mut lane = 0;
    while lane < LANES {
        let (kx, ky, weight) = (columns[lane].k[0] as usize, columns[lane].k[1] as usize, columns[lane].weight);
        let (mut i, mut block) = (0, 0);
        while block < all.len() {
            let (mut sum, end) = (0, i + prefix);
            while i < end {
                // The centres of cells of 2⁻¹⁰, in steps of 2π/4096.
                let (x, y) = ((points[i] >> 21 | 1) as usize, (points[i] >> 5 & 2047 | 1) as usize);
                sum += (wave[(kx * x) & 4095] * wave[(ky * y) & 4095]) >> 14;
                i += 1;
            }
            all[block][lane / 8][lane % 8] = ((i64::from(sum) * weight + (1 << 23)) >> 24) as i16;
            block += 1;
        }
        lane += 1;
    }
    vectors
}

/// A period of the cosine in 4096 steps, from a quarter of one in 256: what lies between is interpolated.
fn whole_wave(cosine: &[i32]) -> Vec<i32> {
    let quarter = |i: usize| {
        let (at, part) = (i / 4, (i % 4) as i32);
        if part == 0 { cosine[at] } else { (cosine[at] * (4 - part) + cosine[at + 1] * part + 2) >> 2 }
    };
    let step = |i: usize| match i >> 10 {
        0 => quarter(i),
        1 => -quarter(2048 - i),
        2 => -quarter(i - 2048),
        _ => quarter(4096 - i),
    };
    (0..4096).map(step).collect()
}

/// Swaps numbers, `proposals` a pixel. `features[g]` are the vectors of prefix [`PREFIXES`]`[g]`, `kernel[r²]` the
/// weights.
pub fn anneal(
    numbers: &mut [u32],
    features: &[Vec<Features>],
    kernel: &[i32],
    proposals: usize,
    rng: &mut Xoshiro256PlusPlus,
) {
    let mut at = vec![0; numbers.len()];
    for (pixel, &number) in numbers.iter().enumerate() {
        at[number as usize] = pixel;
    }
    for number in 0..at.len() {
        at.swap(number, number ^ (rng.next_u64() >> 62) as usize);
    }
    for (number, &pixel) in at.iter().enumerate() {
        numbers[pixel] = number as u32;
    }
    let window = Window::new(kernel);
    let mut layers = Vec::new();
    for (features, prefix) in features.iter().zip(PREFIXES) {
        layers.push(Layer::new(features, prefix.trailing_zeros(), numbers, &window));
    }
    let power: i64 = layers.iter().map(|layer| layer.power(kernel[0])).sum();
    let mut left = proposals;
    while left > 0 {
        left -= 1;
        let threshold = power * FIRST_THRESHOLD * (left * left) as i64 / (1000 * proposals * proposals) as i64;
        sweep(&mut layers, numbers, &mut at, threshold, rng);
    }
}

/// As many proposals as there are pixels.
fn sweep(
    layers: &mut [Layer<'_>],
    numbers: &mut [u32],
    at: &mut [usize],
    threshold: i64,
    rng: &mut Xoshiro256PlusPlus,
) {
    let all = numbers.len() - 1;
    let size_log2 = layers[0].size_log2;
    let mut tried = 0;
    while tried <= all {
        tried += 1;
        let bits = rng.next_u64();
        let p = (bits >> (64 - 2 * size_log2)) as usize;
        // What changes one sample only costs the least and helps the most.
        let reach = match bits >> 32 & 63 {
            0..=47 => 3,
            48..=59 => 15,
            60 | 61 => 63,
            _ => all,
        };
        let here = numbers[p] as usize;
        let there = here ^ (bits as usize & reach);
        let q = at[there];
        if near(p, q, size_log2, 0, 1 << size_log2) {
            continue;
        }
        let (mut delta, mut g) = (0, 0);
        while g < layers.len() && layers[g].differ(here, there) {
            delta += layers[g].delta(p, q, here, there);
            g += 1;
        }
        if delta < threshold {
            while g > 0 {
                g -= 1;
                layers[g].swap(p, q, here, there);
            }
            (numbers[p], numbers[q]) = (there as u32, here as u32);
            (at[here], at[there]) = (q, p);
        }
    }
}

/// One prefix.
struct Layer<'a> {
    features: &'a [Features],
    field: Vec<Words<ROWS>>,
    window: &'a Window,
    size_log2: u32,
    prefix_log2: u32,
}

impl<'a> Layer<'a> {
    fn new(features: &'a [Features], prefix_log2: u32, numbers: &[u32], window: &'a Window) -> Self {
        let size_log2 = numbers.len().ilog2() / 2;
        let mut field = vec![[[0; 4]; ROWS]; numbers.len()];
        for (pixel, &number) in numbers.iter().enumerate() {
            let own = pack(&features[(number >> prefix_log2) as usize]);
            window.splat(&mut field, size_log2, 1 << size_log2, pixel, &own, 1);
        }
        Self { features, field, window, size_log2, prefix_log2 }
    }

    /// w(0)‖f‖², the mean over blocks: what a pixel alone would add.
    fn power(&self, weight: i32) -> i64 {
        let squares: i64 = self.features.iter().flatten().flatten().map(|&f| i64::from(f).pow(2)).sum();
        squares * i64::from(weight) / self.features.len() as i64
    }

    fn differ(&self, here: usize, there: usize) -> bool {
        (here ^ there) >> self.prefix_log2 != 0
    }

    fn delta(&self, p: usize, q: usize, here: usize, there: usize) -> i64 {
        let (f_p, f_q) = (&self.features[here >> self.prefix_log2], &self.features[there >> self.prefix_log2]);
        let (at_p, at_q) = (&self.field[p], &self.field[q]);
        let (mut sum, mut row) = (0, 0);
        while row < ROWS {
            sum += i64::from(part(&f_p[row], &f_q[row], &at_p[row], &at_q[row]));
            row += 1;
        }
        sum
    }

    fn swap(&mut self, p: usize, q: usize, here: usize, there: usize) {
        let (f_p, f_q) = (&self.features[here >> self.prefix_log2], &self.features[there >> self.prefix_log2]);
        let change = difference(&pack(f_p), &pack(f_q));
        self.window.splat(&mut self.field, self.size_log2, 1 << self.size_log2, p, &change, 1);
        self.window.splat(&mut self.field, self.size_log2, 1 << self.size_log2, q, &change, -1);
    }
}

/// Eight lanes of (f_q − f_p)·(F_p − F_q).
fn part(f_p: &[i16; 8], f_q: &[i16; 8], at_p: &[u64; 4], at_q: &[u64; 4]) -> i32 {
    let word_0 = at_p[0].wrapping_sub(at_q[0]);
    let word_1 = at_p[1].wrapping_sub(at_q[1]);
    let word_2 = at_p[2].wrapping_sub(at_q[2]);
    let word_3 = at_p[3].wrapping_sub(at_q[3]);
    // A negative low lane has borrowed one from the high lane: its sign bit gives it back.
    (f_q[0] - f_p[0]) as i32 * word_0 as i32
        + (f_q[1] - f_p[1]) as i32 * (word_0.wrapping_add(1 << 31) >> 32) as i32
        + (f_q[2] - f_p[2]) as i32 * word_1 as i32
        + (f_q[3] - f_p[3]) as i32 * (word_1.wrapping_add(1 << 31) >> 32) as i32
        + (f_q[4] - f_p[4]) as i32 * word_2 as i32
        + (f_q[5] - f_p[5]) as i32 * (word_2.wrapping_add(1 << 31) >> 32) as i32
        + (f_q[6] - f_p[6]) as i32 * word_3 as i32
        + (f_q[7] - f_p[7]) as i32 * (word_3.wrapping_add(1 << 31) >> 32) as i32
}
