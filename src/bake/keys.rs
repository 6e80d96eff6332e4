//! Keys of a tile: the linear pixel order, in which every pixel has chosen the order of its samples.
//!
//! The linear order gives a pixel digits, and its samples are points 0, 1, 2, … of a linear sequence ⊕ those. To add
//! point r to the digits is to begin with sample r: sample i becomes what sample i ⊕ r was. So for r below n the first n
//! samples stay the same set, which the linear order has made blue, and what is searched for is which of them comes first,
//! which two, which four. (Ranks of Heitz et al. 2019, which a linear sequence turns into keys.)
//!
//! ```text
//! ranks below 4 at random; field F = w ∗ f, with w(0) = 0
//! repeat: p = any pixel, with another rank: of the same two upper thirds of its bits, of the same upper one, or any
//!     Δ = (f' − f)·F + N(f') − N(f),   N = w(0)‖f‖²/2
//!     Δ < threshold: do it, and update F around
//! the threshold falls to 0
//! ```
//! f are a pixel's errors of a basis of cosines, as in [`features`](super::features), 32 of each of the [`PREFIXES`] and
//! only of those that a rank can change. Δ is half the change of the power of the filtered error image, as in
//! [`anneal`](super::anneal).
//!
//! The linear order is regular: its errors are Walsh functions over a block, and two places of a tile of few blocks would
//! match. Random ranks leave nothing of that in the first samples, and no set of four is touched by them; the search
//! makes the samples blue again. What is left of the pattern from four samples on is broken by patches below the size
//! of a block. The threshold is low, or it would trade the order of 4 and 16 samples for that of one.

use rand::Rng;
use rand::rngs::Xoshiro256PlusPlus;

use super::anneal::{Window, Words, difference, pack};
use super::features::Column;
use crate::linear::{self, Order, SETS, Sequence};

/// Numbers of samples whose errors are annealed.
pub const PREFIXES: [u32; 3] = [1, 4, 16];
/// Numbers in a feature vector of one prefix.
pub const LANES: usize = 32;
const ROWS: usize = LANES / 8;
/// A feature vector. Magnitudes up to 63 keep every row of eight products within an `i32`.
pub type Features = [[i16; 8]; ROWS];

/// log₂ of the side of a patch. At 3 the borders leave 64 samples half as much error again, at 5 the pattern shows.
const PATCH_LOG2: u32 = 4;
/// Where the threshold starts, in thousandths of a pixel's own power. Five times that costs the order of 4 samples.
const FIRST_THRESHOLD: i64 = 20;

/// What the linear order gives the pixels of a tile of 2^`size_log2` squared, row by row: the upper 16 digits of the
/// first number in the upper half, of the second in the lower. Patches of 16×16 have sets, transpositions and digits
/// at random.
pub fn linear_digits(order: &Order, size_log2: u32, rng: &mut Xoshiro256PlusPlus) -> Vec<u32> {
    let (size, patches_log2) = (1u32 << size_log2, size_log2 - PATCH_LOG2);
    let patches: Vec<u64> = (0..1 << (2 * patches_log2)).map(|_| rng.next_u64()).collect();
    let pixel = |p: u32| {
        let (x, y) = (p & (size - 1), p >> size_log2);
        let random = patches[((y >> PATCH_LOG2) << patches_log2 | x >> PATCH_LOG2) as usize];
        let set = &order[(random >> 61) as usize % SETS];
        let (x, y) = if random >> 60 & 1 == 1 { (y, x) } else { (x, y) };
        random as u32 ^ linear::digits(set, x, y)
    };
    (0..size * size).map(pixel).collect()
}

/// The first points of the sequence, packed as digits are.
pub fn points(sequence: &Sequence, count: u32) -> Vec<u32> {
    let packed = |i| (sequence.packed(i) >> 32 & 0xffff_0000 | sequence.packed(i) >> 16 & 0xffff) as u32;
    (0..count).map(packed).collect()
}

/// One feature vector for every aligned block of `prefix` of every pixel's samples, which are `points` ⊕ its digits.
/// `cosine` is a quarter of a wave in 256 steps, 2.14 fixed point.
pub fn vectors(digits: &[u32], points: &[u32], prefix: usize, columns: &[Column], cosine: &[i32]) -> Vec<Features> {
    let wave = &whole_wave(cosine)[..];
    let count = points.len();
    let mut vectors = vec![[[0; 8]; ROWS]; digits.len() * count / prefix];
    let all = &mut vectors[..];
    let mut places = vec![[0; 2]; count];
    let places = &mut places[..];
    let mut pixel = 0;
    while pixel < digits.len() {
        let mut i = 0;
        while i < count {
            // The centres of cells of 2⁻¹⁰, in steps of 2π/4096.
            let point = digits[pixel] ^ points[i];
            places[i] = [(point >> 21 | 1) as usize, (point >> 5 & 2047 | 1) as usize];
            i += 1;
        }
        let mut lane = 0;
        while lane < LANES {
            let (kx, ky, weight) = (columns[lane].k[0] as usize, columns[lane].k[1] as usize, columns[lane].weight);
            let mut vector = pixel * count / prefix;
            let mut i = 0;
            while i < count {
                let mut sum = 0;
                let end = i + prefix;
                while i < end {
                    let [x, y] = places[i];
                    sum += (wave[(kx * x) & 4095] * wave[(ky * y) & 4095]) >> 14;
                    i += 1;
                }
                all[vector][lane / 8][lane % 8] = ((i64::from(sum) * weight + (1 << 23)) >> 24) as i16;
                vector += 1;
            }
            lane += 1;
        }
        pixel += 1;
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

/// The rank of every pixel of a tile, below 2^`ranks_log2`, after `proposals` a pixel. `features[g]` are the vectors of
/// prefix [`PREFIXES`]`[g]`, `kernel[r²]` the weights.
pub fn choose_ranks(
    size_log2: u32,
    ranks_log2: u32,
    features: &[Vec<Features>],
    kernel: &[i32],
    proposals: usize,
    rng: &mut Xoshiro256PlusPlus,
) -> Vec<u8> {
    let window = Window::new(kernel);
    let mut ranks: Vec<u8> = (0..1 << (2 * size_log2)).map(|_| (rng.next_u64() >> 62) as u8).collect();
    let mut layers = Vec::new();
    for (features, prefix) in features.iter().zip(PREFIXES) {
        layers.push(Layer::new(features, prefix.trailing_zeros(), ranks_log2, &ranks, kernel[0], &window));
    }
    let power: i64 = layers.iter().map(Layer::power).sum();
    let layers = &mut layers[..];
    let mut left = proposals;
    while left > 0 {
        left -= 1;
        let threshold = power * FIRST_THRESHOLD * (left * left) as i64 / (1000 * proposals * proposals) as i64;
        sweep(layers, &mut ranks, threshold as i32, rng);
    }
    ranks
}

/// As many proposals as there are pixels.
fn sweep(layers: &mut [Layer<'_>], ranks: &mut [u8], threshold: i32, rng: &mut Xoshiro256PlusPlus) {
    let all = (1u64 << layers[0].blocks_log2) - 1;
    let size_log2 = layers[0].size_log2;
    let mut tried = 0;
    while tried < ranks.len() {
        tried += 1;
        let bits = rng.next_u64();
        let pixel = (bits >> (64 - 2 * size_log2)) as usize;
        // What changes one sample only costs the least and helps the most.
        let reach = match bits >> 8 & 3 {
            0 | 1 => all & 3,
            2 => all & 15,
            _ => all,
        };
        let (here, there) = (ranks[pixel], ranks[pixel] ^ (bits & reach) as u8);
        let mut delta = 0;
        let mut g = 0;
        while g < layers.len() {
            delta += layers[g].delta(pixel, here, there);
            g += 1;
        }
        if delta < threshold {
            let mut g = 0;
            while g < layers.len() {
                layers[g].put(pixel, here, there);
                g += 1;
            }
            ranks[pixel] = there;
        }
    }
}

/// One prefix.
struct Layer<'a> {
    features: &'a [Features],
    /// w(0)‖f‖²/2.
    norms: Vec<i32>,
    field: Vec<Words<ROWS>>,
    window: &'a Window,
    size_log2: u32,
    prefix_log2: u32,
    blocks_log2: u32,
}

impl<'a> Layer<'a> {
    fn new(
        features: &'a [Features],
        prefix_log2: u32,
        ranks_log2: u32,
        ranks: &[u8],
        weight: i32,
        window: &'a Window,
    ) -> Self {
        let norms = features.iter().map(|vector| square(vector) * weight / 2).collect();
        let (size_log2, blocks_log2) = (ranks.len().ilog2() / 2, ranks_log2 - prefix_log2);
        let field = vec![[[0; 4]; ROWS]; ranks.len()];
        let mut layer = Self { features, norms, field, window, size_log2, prefix_log2, blocks_log2 };
        for (pixel, &rank) in ranks.iter().enumerate() {
            let own = pack(&features[layer.vector(pixel, rank)]);
            window.splat(&mut layer.field, size_log2, 1 << size_log2, pixel, &own, 1);
        }
        layer
    }

    /// What a pixel alone would add, the mean.
    fn power(&self) -> i64 {
        self.norms.iter().map(|&norm| i64::from(norm)).sum::<i64>() / self.norms.len() as i64
    }

    /// The number of a pixel's vector.
    fn vector(&self, pixel: usize, rank: u8) -> usize {
        pixel << self.blocks_log2 | (rank >> self.prefix_log2) as usize
    }

    fn delta(&self, pixel: usize, here: u8, there: u8) -> i32 {
        let (from, to) = (self.vector(pixel, here), self.vector(pixel, there));
        if from == to {
            return 0;
        }
        let (f, g, at) = (&self.features[from], &self.features[to], &self.field[pixel]);
        let mut sum = self.norms[to] - self.norms[from];
        let mut row = 0;
        while row < ROWS {
            sum += part(&f[row], &g[row], &at[row]);
            row += 1;
        }
        sum
    }

    fn put(&mut self, pixel: usize, here: u8, there: u8) {
        let (from, to) = (self.vector(pixel, here), self.vector(pixel, there));
        if from != to {
            let change = difference(&pack(&self.features[from]), &pack(&self.features[to]));
            self.window.splat(&mut self.field, self.size_log2, 1 << self.size_log2, pixel, &change, 1);
        }
    }
}

fn square(features: &Features) -> i32 {
    features.iter().flatten().map(|&f| i32::from(f) * i32::from(f)).sum()
}

/// Eight lanes of (f' − f)·F.
fn part(f: &[i16; 8], g: &[i16; 8], at: &[u64; 4]) -> i32 {
    // A negative low lane has borrowed one from the high lane: its sign bit gives it back.
    (g[0] - f[0]) as i32 * at[0] as i32
        + (g[1] - f[1]) as i32 * (at[0].wrapping_add(1 << 31) >> 32) as i32
        + (g[2] - f[2]) as i32 * at[1] as i32
        + (g[3] - f[3]) as i32 * (at[1].wrapping_add(1 << 31) >> 32) as i32
        + (g[4] - f[4]) as i32 * at[2] as i32
        + (g[5] - f[5]) as i32 * (at[2].wrapping_add(1 << 31) >> 32) as i32
        + (g[6] - f[6]) as i32 * at[3] as i32
        + (g[7] - f[7]) as i32 * (at[3].wrapping_add(1 << 31) >> 32) as i32
}
